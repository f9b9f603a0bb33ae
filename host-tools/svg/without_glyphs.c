/* host-tools/svg/without_glyphs.c -- replaces svg_glyphs.c if loft is built without cairo
 * SPDX-License-Identifier: MIT
 */
#include "svg/svg.h"

bool svg_glyphs_shape(svg_reader *r, const svg_span spans[], size_t count, const char *text,
                      bool leftwards, svg_shaped *out)
{
    (void)r, (void)spans, (void)count, (void)text, (void)leftwards, (void)out;
    return false;
}

svg_metrics svg_glyphs_metrics(svg_reader *r, const svg_font *font)
{
    (void)r, (void)font;
    return (svg_metrics){ .ascent = 1 };
}

void svg_glyphs_close(svg_fonts *fonts) { (void)fonts; }

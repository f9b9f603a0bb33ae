/* host-tools/svg/without_glyphs.c -- replaces svg_glyphs.c if loft is built without cairo
 * SPDX-License-Identifier: MIT
 */
#include "svg/svg.h"

bool svg_glyphs_shape(svg_reader *r, const svg_font *font, const char *text, size_t length,
                      svg_shaped *out)
{
    (void)r, (void)font, (void)text, (void)length, (void)out;
    return false;
}

void svg_glyphs_close(svg_fonts *fonts) { (void)fonts; }

/* host-tools/svg/svg_glyphs.c -- the outlines of letters in any installed font
 * SPDX-License-Identifier: MIT
 *
 * Pango finds the fonts, orders letters of both directions and shapes them, with kerning and
 * ligatures; cairo gives the outlines. Both work at EM pixels an em, without hints: cairo rounds
 * coordinates to 1/256 px, so an outline is within 4e-6 em.
 */
#include <pango/pangocairo.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"       /* tool_grow */
#include "svg/svg.h"

#define EM 1024

struct svg_fonts {
    PangoFontMap *map;
    PangoContext *context;
    cairo_surface_t *surface;
    cairo_t *cairo;
};

static svg_fonts *open_fonts(void)
{
    svg_fonts *f = tool_grow(NULL, sizeof *f);
    cairo_font_options_t *plain = cairo_font_options_create();

    cairo_font_options_set_hint_style(plain, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(plain, CAIRO_HINT_METRICS_OFF);
    f->map     = pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT);
    f->context = pango_font_map_create_context(f->map);
    pango_cairo_context_set_font_options(f->context, plain);
    pango_context_set_round_glyph_positions(f->context, FALSE);
    f->surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    f->cairo   = cairo_create(f->surface);
    cairo_font_options_destroy(plain);
    return f;
}

void svg_glyphs_close(svg_fonts *f)
{
    if (f == NULL)
        return;
    cairo_destroy(f->cairo);
    cairo_surface_destroy(f->surface);
    g_object_unref(f->context);
    g_object_unref(f->map);
    free(f);
}

static PangoFontDescription *describe(const svg_font *font)
{
    static const PangoStyle slants[] = { PANGO_STYLE_NORMAL, PANGO_STYLE_OBLIQUE,
                                         PANGO_STYLE_ITALIC };
    PangoFontDescription *d = pango_font_description_new();

    pango_font_description_set_family(d, font->family ? font->family : "sans-serif");
    pango_font_description_set_absolute_size(d, EM * PANGO_SCALE);
    pango_font_description_set_weight(d, (PangoWeight)font->weight);
    pango_font_description_set_style(d, slants[font->slant]);
    pango_font_description_set_stretch(d, (PangoStretch)(PANGO_STRETCH_NORMAL + font->stretch));
    if (font->small_caps)
        pango_font_description_set_variant(d, PANGO_VARIANT_SMALL_CAPS);
    return d;
}


// One item: text of one font and one direction
// --------------------------------------------

/* Append what cairo gives for one glyph, `at` em away from the cluster's origin. */
static void add_outline(svg_fonts *f, PangoFont *font, PangoGlyph glyph, const double at[2],
                        svg_shaped *out)
{
    const cairo_glyph_t one = { glyph, 0, 0 };

    cairo_set_scaled_font(f->cairo, pango_cairo_font_get_scaled_font((PangoCairoFont *)font));
    cairo_new_path(f->cairo);
    cairo_glyph_path(f->cairo, &one, 1);
    cairo_path_t *path = cairo_copy_path(f->cairo);
    for (int i = 0; path->status == CAIRO_STATUS_SUCCESS && i < path->num_data;
         i += path->data[i].header.length) {
        const cairo_path_data_t *d = &path->data[i];
        const int points           = d->header.length - 1;
        double p[6];
        for (int k = 0; k < points && k < 3; k++) {
            p[2 * k]     = d[k + 1].point.x / EM + at[0];
            p[2 * k + 1] = d[k + 1].point.y / EM + at[1];
        }
        svg_shaped_part(out,
                        d->header.type == CAIRO_PATH_MOVE_TO    ? 'M'
                        : d->header.type == CAIRO_PATH_LINE_TO  ? 'L'
                        : d->header.type == CAIRO_PATH_CURVE_TO ? 'C'
                                                                : 'Z',
                        p, points < 3 ? points : 3);
    }
    cairo_path_destroy(path);
}

static double em_of(int pango)      { return (double)pango / PANGO_SCALE / EM; }

static void add_item(svg_fonts *f, const char *text, const PangoItem *item, svg_shaped *out)
{
    PangoGlyphString *g = pango_glyph_string_new();
    double x            = 0;

    pango_shape_full(text + item->offset, item->length, NULL, 0, &item->analysis, g);
    for (int i = 0; i < g->num_glyphs; i++) {
        const PangoGlyphInfo *one = &g->glyphs[i];
        if (i == 0 || one->attr.is_cluster_start) {
            svg_shaped_add(out, (size_t)(item->offset + g->log_clusters[i]), 0);
            x = 0;
        }
        const double at[2] = { x + em_of(one->geometry.x_offset), em_of(one->geometry.y_offset) };
        if (one->glyph & PANGO_GLYPH_UNKNOWN_FLAG)
            out->missing = true;
        else if (one->glyph != PANGO_GLYPH_EMPTY && item->analysis.font != NULL)
            add_outline(f, item->analysis.font, one->glyph, at, out);
        x += em_of(one->geometry.width);
        out->cluster[out->clusters - 1].advance = x;
    }
    pango_glyph_string_free(g);
}

static void measure_font(svg_fonts *f, PangoFont *font, svg_shaped *out)
{
    PangoFontMetrics *m = pango_font_get_metrics(font, NULL);

    (void)f;
    out->ascent    = em_of(pango_font_metrics_get_ascent(m));
    out->descent   = em_of(pango_font_metrics_get_descent(m));
    out->thickness = em_of(pango_font_metrics_get_underline_thickness(m));
    out->underline = out->thickness / 2 - em_of(pango_font_metrics_get_underline_position(m));
    pango_font_metrics_unref(m);
}

bool svg_glyphs_shape(svg_reader *r, const svg_font *font, const char *text, size_t length,
                      svg_shaped *out)
{
    if (r->fonts == NULL)
        r->fonts = open_fonts();
    PangoFontDescription *d = describe(font);
    PangoAttrList *none     = pango_attr_list_new();

    pango_context_set_font_description(r->fonts->context, d);
    GList *items = pango_itemize_with_base_dir(
        r->fonts->context, font->leftwards ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR, text, 0,
        (int)length, none, NULL);
    GList *seen  = pango_reorder_items(items);
    if (items != NULL && ((PangoItem *)items->data)->analysis.font != NULL)
        measure_font(r->fonts, ((PangoItem *)items->data)->analysis.font, out);
    for (const GList *at = seen; at != NULL; at = at->next)
        add_item(r->fonts, text, at->data, out);
    g_list_free(seen);
    g_list_free_full(items, (GDestroyNotify)pango_item_free);
    pango_attr_list_unref(none);
    pango_font_description_free(d);
    return true;
}

/* host-tools/svg/svg_glyphs.c -- the outlines of letters in any installed font
 * SPDX-License-Identifier: MIT
 *
 * Pango finds the fonts, orders letters of both directions and shapes them, with kerning and
 * ligatures; cairo gives the outlines. Both work at EM pixels an em, without hints: cairo rounds
 * coordinates to 1/256 px, so an outline is within 4e-6 em.
 */
#include <hb-ot.h>
#include <math.h>
#include <pango/pangocairo.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
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
    svg_fonts *f = memory_grow(NULL, sizeof *f);
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

/* Scripts whose letters join: see CSS Text 3, 7.2. */
static bool is_cursive(const PangoItem *item)
{
    static const GUnicodeScript cursive[] = {
        G_UNICODE_SCRIPT_ARABIC,  G_UNICODE_SCRIPT_SYRIAC,    G_UNICODE_SCRIPT_NKO,
        G_UNICODE_SCRIPT_MANDAIC, G_UNICODE_SCRIPT_MONGOLIAN, G_UNICODE_SCRIPT_PHAGS_PA
    };

    for (size_t i = 0; i < sizeof cursive / sizeof cursive[0]; i++)
        if (item->analysis.script == (guint8)cursive[i])
            return true;
    return false;
}

static void add_item(svg_fonts *f, const char *text, int length, const PangoItem *item,
                     svg_shaped *out)
{
    PangoGlyphString *g = pango_glyph_string_new();
    double x            = 0;

    pango_shape_full(text + item->offset, item->length, text, length, &item->analysis, g);
    for (int i = 0; i < g->num_glyphs; i++) {
        const PangoGlyphInfo *one = &g->glyphs[i];
        const char *letter = text + item->offset + g->log_clusters[i];
        const bool mark = out->clusters > 0 && item->analysis.level % 2 == 0 &&
                          g_unichar_ismark(g_utf8_get_char(letter));
        if (i == 0 && mark) {           /* of another font than its letter */
            x = out->cluster[out->clusters - 1].advance;
        } else if (i == 0 || (one->attr.is_cluster_start && !mark)) {
            svg_shaped_add(out, (size_t)(letter - text), 0);
            out->cluster[out->clusters - 1].cursive = *letter != ' ' && is_cursive(item);
            x = 0;
        }
        const double at[2] = { x + em_of(one->geometry.x_offset), em_of(one->geometry.y_offset) };
        if (one->glyph & PANGO_GLYPH_UNKNOWN_FLAG)
            out->missing = true;
        else if (one->glyph != PANGO_GLYPH_EMPTY && item->analysis.font != NULL) {
            const size_t before = out->parts;
            add_outline(f, item->analysis.font, one->glyph, at, out);
            out->pictured = out->pictured || (out->parts == before && one->geometry.width > 0 &&
                                              g_unichar_isgraph(g_utf8_get_char(letter)));
        }
        x += em_of(one->geometry.width);
        out->cluster[out->clusters - 1].advance = x;
    }
    pango_glyph_string_free(g);
}


// Texts
// -----

static svg_fonts *fonts_of(svg_reader *r)
{
    if (r->fonts == NULL)
        r->fonts = open_fonts();
    return r->fonts;
}

/* What the font says, or the height of its x. */
static int height_of_x(hb_font_t *font)
{
    hb_position_t height;
    hb_codepoint_t glyph;
    hb_glyph_extents_t ink;

    if (hb_ot_metrics_get_position(font, HB_OT_METRICS_TAG_X_HEIGHT, &height) && height > 0)
        return height;
    if (hb_font_get_nominal_glyph(font, 'x', &glyph) &&
        hb_font_get_glyph_extents(font, glyph, &ink) && ink.y_bearing > 0)
        return ink.y_bearing;
    return EM * PANGO_SCALE / 2;
}

svg_metrics svg_glyphs_metrics(svg_reader *r, const svg_font *font)
{
    svg_fonts *f            = fonts_of(r);
    PangoFontDescription *d = describe(font);
    PangoFont *itself       = pango_font_map_load_font(f->map, f->context, d);
    svg_metrics out         = { .ascent = 1 };

    pango_font_description_free(d);
    if (itself == NULL)
        return out;
    PangoFontMetrics *m = pango_font_get_metrics(itself, NULL);
    out.ascent    = em_of(pango_font_metrics_get_ascent(m));
    out.descent   = em_of(pango_font_metrics_get_descent(m));
    out.thickness = em_of(pango_font_metrics_get_underline_thickness(m));
    out.underline = out.thickness / 2 - em_of(pango_font_metrics_get_underline_position(m));
    pango_font_metrics_unref(m);
    out.x_height = em_of(height_of_x(pango_font_get_hb_font(itself)));
    g_object_unref(itself);
    return out;
}

static bool looks_alike(const svg_font *a, const svg_font *b)
{
    return a->family == b->family && a->weight == b->weight && a->slant == b->slant &&
           a->stretch == b->stretch && a->small_caps == b->small_caps && a->plain == b->plain &&
           (fabs(a->letter) > 0) == (fabs(b->letter) > 0);
}

static void add_attribute(PangoAttrList *all, PangoAttribute *one, size_t from, size_t end)
{
    one->start_index = (guint)from;
    one->end_index   = (guint)end;
    pango_attr_list_insert(all, one);
}

/* Are there Arabic letters, or of scripts next to it? */
static bool has_joining(const char *from, const char *end)
{
    for (; from < end; from++)
        if ((unsigned char)*from >= 0xD8 && (unsigned char)*from <= 0xDF)
            return true;
    return false;
}

/* One font for spans that look alike, so that letters join across them. */
static PangoAttrList *attributes_of(const svg_span spans[], size_t count, const char *text)
{
    PangoAttrList *all = pango_attr_list_new();

    for (size_t k = 0, next; k < count; k = next) {
        const svg_font *font = spans[k].font;
        const size_t from    = k > 0 ? spans[k - 1].end : 0;
        for (next = k + 1; next < count && looks_alike(font, spans[next].font);)
            next++;
        const size_t end        = spans[next - 1].end;
        PangoFontDescription *d = describe(font);
        add_attribute(all, pango_attr_font_desc_new(d), from, end);
        pango_font_description_free(d);
        const bool apart = fabs(font->letter) > 0 && !has_joining(text + from, text + end);
        if (font->plain || apart)
            add_attribute(all,
                          pango_attr_font_features_new(!apart        ? "kern=0"
                                                       : font->plain ? "kern=0,liga=0,clig=0"
                                                                     : "liga=0,clig=0"),
                          from, end);
    }
    return all;
}

bool svg_glyphs_shape(svg_reader *r, const svg_span spans[], size_t count, const char *text,
                      bool leftwards, svg_shaped *out)
{
    svg_fonts *f            = fonts_of(r);
    const int length        = count > 0 ? (int)spans[count - 1].end : 0;
    PangoAttrList *attributes = attributes_of(spans, count, text);

    if (length > 0) {
        PangoFontDescription *d = describe(spans[0].font);
        pango_context_set_font_description(f->context, d);
        pango_font_description_free(d);
    }
    GList *items = length == 0
                       ? NULL
                       : pango_itemize_with_base_dir(
                             f->context, leftwards ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR,
                             text, 0, length, attributes, NULL);
    GList *seen  = pango_reorder_items(items);
    for (const GList *at = seen; at != NULL; at = at->next)
        add_item(f, text, length, at->data, out);
    g_list_free(seen);
    g_list_free_full(items, (GDestroyNotify)pango_item_free);
    pango_attr_list_unref(attributes);
    return true;
}

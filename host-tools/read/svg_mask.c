/* host-tools/read/svg_mask.c -- clip-path and mask of an element: their outlines, and what they cut
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "read/svg.h"

/* The element that url(#id) names, or NULL. */
static const xmlNode *target_of(svg_reader *r, const char *value, const char *name)
{
    const char *open = strchr(value, '#');
    char id[200];

    if (strncmp(value, "url(", 4) != 0 || open == NULL) {
        svg_warn(r, SVG_WARN_CLIP_PATH, "%s: %.30s is not applied: cut the paths in the editor",
                 strcmp(name, "mask") == 0 ? "mask" : "clip-path", value);
        return NULL;
    }
    snprintf(id, sizeof id, "%.*s", (int)strcspn(open + 1, ")\"'"), open + 1);
    const xmlNode *node = svg_find(r, id);
    return node != NULL && svg_is(node, name) ? node : NULL;
}

void svg_close_outline(drawing *d)
{
    drawing out = { .count = 0 };

    for (size_t i = 0, begin = 0; i < d->count; i++) {
        drawing_curve c = d->curve[i];
        const bool last = i + 1 == d->count || d->curve[i + 1].path != c.path;
        drawing_add_like(&out, &c, i == begin);
        if (!last)
            continue;
        const double *from = d->curve[i].p[3], *to = d->curve[begin].p[0];
        for (int k = 0; k < 4; k++)
            for (int j = 0; j < 2; j++)
                c.p[k][j] = k == 3 ? to[j] : from[j] + (to[j] - from[j]) * k / 3;
        if (memcmp(from, to, sizeof c.p[0]) != 0)
            drawing_add_like(&out, &c, false);
        begin = i + 1;
    }
    drawing_free(d);
    *d = out;
}

void svg_box(const drawing *d, size_t first, const svg_matrix *m, double all[2][2])
{
    memset(all, 0, 4 * sizeof all[0][0]);
    for (size_t i = first; i < d->count; i++) {
        drawing_curve in  = svg_within(&d->curve[i], m);
        const drawing one = { .curve = &in, .count = 1 };
        double box[2][2];
        (void)drawing_box(&one, box);
        for (int k = 0; k < 2; k++) {
            all[0][k] = i == first || box[0][k] < all[0][k] ? box[0][k] : all[0][k];
            all[1][k] = i == first || box[1][k] > all[1][k] ? box[1][k] : all[1][k];
        }
    }
}

/* With clipPathUnits="objectBoundingBox", 0..1 is the box of what is clipped. */
static void enter_box(const svg_reader *r, svg_space *space, size_t first)
{
    double all[2][2];

    svg_box(r->d, first, &space->to_mm, all);
    space->to_mm = svg_multiply(
        space->to_mm,
        (svg_matrix){ all[1][0] - all[0][0], 0, 0, all[1][1] - all[0][1], all[0][0], all[0][1] });
}

/* What a clip path or a mask lets through, as closed outlines. */
static bool draw_outline(svg_reader *r, const xmlNode *node, svg_space space, const char *units,
                         size_t first, drawing *outline)
{
    const xmlNode *was  = r->node;
    drawing *const d    = r->d;
    const unsigned fill = r->fill;
    svg_scope scope;
    bool shown;

    r->node    = node;
    char *text = svg_attribute(node, units);
    if (text != NULL && strcmp(text, "objectBoundingBox") == 0)
        enter_box(r, &space, first);
    xmlFree(text);
    space.visible = true;
    space.clip_evenodd = false;
    bool good   = svg_enter(r, &space, &scope, &shown);
    r->clipping = true;
    r->d        = outline;
    good = good && (!shown || svg_children(r, node, space));
    r->d        = d;
    r->clipping = false;
    r->fill     = fill;
    r->node     = was;
    svg_scope_close(&scope);
    svg_close_outline(outline);
    return good;
}

bool svg_clip_element(svg_reader *r, const svg_space *of, size_t first)
{
    const xmlNode *node = r->clipping ? NULL : target_of(r, of->clip, "clipPath");
    drawing outline     = { .count = 0 };

    if (node == NULL || r->d->count == first)
        return true;
    const bool good = draw_outline(r, node, *of, "clipPathUnits", first, &outline) &&
                      svg_cut(r, &outline, first);
    drawing_free(&outline);
    return good;
}

bool svg_mask_element(svg_reader *r, const svg_space *of, size_t first)
{
    const xmlNode *node = r->clipping ? NULL : target_of(r, of->mask, "mask");
    drawing outline     = { .count = 0 };
    svg_space space     = *of;

    if (node == NULL || r->d->count == first)
        return true;
    space.fill = space.fill_opaque = true;      /* of the mask, which stands elsewhere */
    space.stroke = space.evenodd = false;
    space.fill_ink = space.stroke_ink = NULL;
    r->masking = r->plain = true;
    bool good  = draw_outline(r, node, space, "maskContentUnits", first, &outline);
    r->masking = false;
    if (good && r->plain)
        good = svg_cut(r, &outline, first);
    else if (good)
        svg_warn(r, SVG_WARN_MASK,
                 "mask is not applied, as it is not of white shapes: the whole outline is drawn: "
                 "cut the paths in the editor");
    drawing_free(&outline);
    return good;
}

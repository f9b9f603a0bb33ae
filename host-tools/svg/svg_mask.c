/* host-tools/svg/svg_mask.c -- clip-path and mask of an element: their outlines, and what they cut
 * SPDX-License-Identifier: MIT
 *
 * A clip path may have a clip path of its own, and so may its children: these are areas of its
 * outline, see svg_cut. What is clipped twice is cut twice.
 */
#include <stdio.h>
#include <string.h>

#include "svg/svg.h"

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
    out.clip  = d->clip;
    out.clips = d->clips;
    d->clip   = NULL;
    d->clips  = 0;
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

static bool says(const xmlNode *node, const char *name, const char *value)
{
    char *text    = svg_attribute(node, name);
    const bool is = text != NULL && strcmp(text, value) == 0;

    xmlFree(text);
    return is;
}

/* The matrix from 0..1 to the box of an element, in its user space: of its geometry, seen or not.
 */
static bool find_box(svg_reader *r, const svg_element *e, svg_matrix *out)
{
    drawing all = { .count = 0 };
    double box[2][2];
    const bool good = svg_geometry(r, e, &all);

    svg_box(&all, 0, &e->space->to_mm, box);
    *out = (svg_matrix){ box[1][0] - box[0][0], 0, 0, box[1][1] - box[0][1], box[0][0], box[0][1] };
    drawing_free(&all);
    return good;
}

/* What is drawn while an outline is found. */
typedef struct {
    drawing *d;
    const xmlNode *node;
    unsigned fill;
    bool clipping, masking;
} state;

static state begin_outline(svg_reader *r, bool masks, drawing *outline)
{
    const state was = { r->d, r->node, r->fill, r->clipping, r->masking };

    r->clipping = true;
    r->masking  = masks;
    r->d        = outline;
    return was;
}

static void end_outline(svg_reader *r, const state *was)
{
    r->d        = was->d;
    r->node     = was->node;
    r->fill     = was->fill;
    r->clipping = was->clipping;
    r->masking  = was->masking;
}

/* What a clip path or a mask lets through, as closed outlines. Its style is that of the place where
 * it stands. *next: the value of its own property `which`, or NULL. */
static bool draw_outline(svg_reader *r, const xmlNode *node, const svg_element *e, bool masks,
                         drawing *outline, const char **next)
{
    svg_scope scope[SVG_DEPTH_MAX + 1];
    svg_space space = svg_space_usual();
    svg_matrix box  = svg_identity;
    size_t scopes   = 0;
    bool shown;

    if (says(node, masks ? "maskContentUnits" : "clipPathUnits", "objectBoundingBox") &&
        !find_box(r, e, &box))
        return false;
    const state was = begin_outline(r, masks, outline);
    space.width     = e->space->width;
    space.height    = e->space->height;
    bool good = svg_enter_from_root(r, node->parent, &space, scope, SVG_DEPTH_MAX, &scopes, &shown);
    space.to_mm  = e->space->to_mm;
    r->node      = node;
    good         = good && svg_enter(r, &space, &scope[scopes++], &shown);
    space.to_mm  = svg_multiply(space.to_mm, box);
    *next        = masks ? space.mask : space.clip;
    good         = good && svg_children(r, node, space);
    end_outline(r, &was);
    while (scopes > 0)
        svg_scope_close(&scope[--scopes]);
    svg_close_outline(outline);
    return good;
}

bool svg_clip_element(svg_reader *r, const svg_element *e, size_t first)
{
    const unsigned markings = r->markings;
    const char *value       = e->space->clip;
    bool good               = true;

    while (good && !r->boxing && value != NULL && r->d->count > first) {
        const xmlNode *node = target_of(r, value, "clipPath");
        drawing outline     = { .count = 0 };
        if (node == NULL || svg_is_marking(r, node))
            break;
        r->marking[r->markings++] = node;
        good = draw_outline(r, node, e, false, &outline, &value) && svg_cut(r, &outline, first);
        drawing_free(&outline);
    }
    r->markings = markings;
    return good;
}

/* The part of the plane in which a mask exists: by default, more than the box. */
static bool cut_region(svg_reader *r, const xmlNode *node, const svg_element *e, size_t first)
{
    static const char *const names[] = { "x", "y", "width", "height" };
    const xmlNode *was               = r->node;
    const bool parts                 = !says(node, "maskUnits", "userSpaceOnUse");
    svg_space space                  = *e->space;
    double v[4]                      = { -10, -10, 120, 120 };
    svg_matrix box                   = svg_identity;

    if (parts && !find_box(r, e, &box))
        return false;
    if (parts && !(box.a > 0 && box.d > 0)) {   /* no region */
        r->d->count = first;
        return true;
    }
    if (parts)
        space.width = space.height = 1;
    r->node = node;
    for (int i = 0; i < 4; i++) {
        const enum svg_side side = i % 2 ? SVG_ALONG_Y : SVG_ACROSS;
        v[i] = svg_length(r, &space, names[i], side,
                          v[i] / 100 * (side == SVG_ACROSS ? space.width : space.height));
    }
    space.to_mm = svg_multiply(svg_multiply(space.to_mm, box),
                               (svg_matrix){ 1, 0, 0, 1, v[0], v[1] });
    const bool good = svg_cut_frame(r, node, &space.to_mm, v[2], v[3], first);
    r->node         = was;
    return good;
}

static bool mask_once(svg_reader *r, const xmlNode *node, const svg_element *e, size_t first,
                      const char **next)
{
    drawing outline = { .count = 0 };
    const bool was  = r->plain;

    r->plain   = true;
    bool good  = cut_region(r, node, e, first) && draw_outline(r, node, e, true, &outline, next);
    if (good && r->plain)
        good = svg_cut(r, &outline, first);
    else if (good)
        svg_warn(r, SVG_WARN_MASK,
                 "mask is not applied, as it is not of white shapes: the whole outline is drawn: "
                 "cut the paths in the editor");
    r->plain = was;
    drawing_free(&outline);
    return good;
}

bool svg_mask_element(svg_reader *r, const svg_element *e, size_t first)
{
    const unsigned markings = r->markings;
    const char *value       = e->space->mask;
    bool good               = true;

    while (good && !r->boxing && value != NULL && r->d->count > first &&
           (!r->clipping || r->masking)) {
        const xmlNode *node = target_of(r, value, "mask");
        if (node == NULL || svg_is_marking(r, node))
            break;
        r->marking[r->markings++] = node;
        good = mask_once(r, node, e, first, &value);
    }
    r->markings = markings;
    return good;
}

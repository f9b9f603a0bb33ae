/* host-tools/draw/scene_label.c -- writes heights on the contours of a scene
 * SPDX-License-Identifier: MIT
 *
 * The pieces of a contour are tried one by one. A label goes to a visible place that has no label
 * of the same height near it, and no label under it. So every curve of some length gets a label,
 * and long curves get several.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "draw/scene.h"
#include "base/memory.h"

#define LETTERS 10.5    /* size of a label, in thousandths of the width */
#define APART   170     /* between two labels of one height */
#define TRIES   240     /* for each height */
#define LIFT    0.01    /* diameters; a cell that hides is nearer by more */

typedef struct {
    double x, y, wide, height;
} label;

typedef struct {
    const scene *s;
    const plot_view *v;
    double (*seen)[3];          /* of each vertex: place on the canvas, and nearness */
    label *done;
    size_t count;
} labelling;

static bool covers(const labelling *l, const mesh_cell *c, const double at[3])
{
    int left = 0, right = 0;

    for (int k = 0; k < 4; k++) {
        const double *a = l->seen[c->corner[k]], *b = l->seen[c->corner[(k + 1) % 4]];
        const double side = (b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0]);
        left  += side > 0;
        right += side < 0;
    }
    return left == 0 || right == 0;
}

static bool is_hidden(const labelling *l, const double at[3])
{
    const double before = at[2] + LIFT * l->s->diameter;

    for (size_t i = 0; i < l->s->m->cells && !l->s->wire; i++) {
        const mesh_cell *c = &l->s->m->cell[i];
        if (l->seen[c->corner[0]][2] > before && l->seen[c->corner[2]][2] > before &&
            covers(l, c, at))
            return true;
    }
    return false;
}

/* Both ends must also lie on a surface: a label over the border would not say which line it
 * means. */
static bool is_inside(const labelling *l, const label *here)
{
    const double reach = here->wide / 2 + 3 * l->v->u,
                 ends[2][3] = { { here->x - reach, here->y, 0 }, { here->x + reach, here->y, 0 } };
    bool found[2] = { false, false };

    for (size_t i = 0; i < l->s->m->cells && !(found[0] && found[1]); i++)
        for (int k = 0; k < 2; k++)
            found[k] = found[k] || covers(l, &l->s->m->cell[i], ends[k]);
    return found[0] && found[1];
}

static bool has_room(const labelling *l, const label *here)
{
    const double u = l->v->u;

    for (size_t i = 0; i < l->count; i++) {
        const label *o = &l->done[i];
        if (o->height == here->height && hypot(o->x - here->x, o->y - here->y) < APART * u)
            return false;
        if (fabs(o->x - here->x) < (o->wide + here->wide) / 2 + 3 * u &&
            fabs(o->y - here->y) < 1.3 * LETTERS * u)
            return false;
    }
    return true;
}

static void put_label(labelling *l, const label *here, const char *words)
{
    const double *rgb = scene_pens[SCENE_CONTOUR], u = l->v->u;
    cairo_t *cairo = l->v->cairo;

    l->done = memory_grow(l->done, (l->count + 1) * sizeof *l->done);
    l->done[l->count++] = *here;
    cairo_move_to(cairo, here->x - here->wide / 2, here->y + 0.36 * LETTERS * u);
    cairo_text_path(cairo, words);
    cairo_set_source_rgba(cairo, 1, 1, 1, 0.85);
    cairo_set_line_width(cairo, 3.2 * u);
    cairo_stroke_preserve(cairo);
    cairo_set_source_rgb(cairo, rgb[0], rgb[1], rgb[2]);
    cairo_fill(cairo);
}

static void try_line(labelling *l, const scene_line *line)
{
    const double middle[3] = { (line->p[0][0] + line->p[1][0]) / 2,
                               (line->p[0][1] + line->p[1][1]) / 2, line->p[0][2] };
    cairo_text_extents_t extents;
    double at[3];
    char words[32];

    snprintf(words, sizeof words, "%.6g", middle[2]);
    cairo_text_extents(l->v->cairo, words, &extents);
    scene_place(l->s, l->v, middle, at);
    const label here = { at[0], at[1], extents.x_advance, middle[2] };
    if (has_room(l, &here) && is_inside(l, &here) && !is_hidden(l, at))
        put_label(l, &here, words);
}

void scene_label(const scene *s, const plot_view *v)
{
    labelling l = { .s = s, .v = v };

    l.seen = memory_grow(NULL, s->m->vertices * sizeof *l.seen);
    for (size_t i = 0; i < s->m->vertices; i++)
        scene_place(s, v, s->m->vertex[i].p, l.seen[i]);
    cairo_select_font_face(v->cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(v->cairo, LETTERS * v->u);
    for (size_t first = 0, last; first < s->lines; first = last) {
        for (last = first + 1; last < s->lines && s->line[last].pen == s->line[first].pen &&
                               s->line[last].p[0][2] == s->line[first].p[0][2];
             last++) {
        }
        const size_t stride = (last - first) / TRIES + 1;
        for (size_t i = first + stride / 2; i < last && s->line[first].pen == SCENE_CONTOUR;
             i += stride)
            try_line(&l, &s->line[i]);
    }
    free(l.done);
    free(l.seen);
}

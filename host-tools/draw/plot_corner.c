/* host-tools/draw/plot_corner.c -- an inset: a corner of the drawing, magnified, with the band of
 * the tolerance and the machine's steps
 * SPDX-License-Identifier: MIT
 *
 * The corner is that next to the place where the machine is farthest from the drawing.
 */
#include <math.h>
#include <string.h>

#include "draw/plot.h"

#define SHARP   0.5     /* turn of a corner: 30 degrees, in radians */
#define ACROSS  16      /* tolerances from side to side */

/* The direction of a curve at one end: from the last control point that differs. */
static bool direction(const drawing_curve *c, bool at_end, double out[2])
{
    const double *from = at_end ? c->p[3] : c->p[0];

    for (int k = 1; k < 4; k++) {
        const double *to = at_end ? c->p[3 - k] : c->p[k];
        for (int i = 0; i < 2; i++)
            out[i] = at_end ? from[i] - to[i] : to[i] - from[i];
        if (hypot(out[0], out[1]) > 1e-6)
            return true;
    }
    return false;
}

static bool turns(const drawing_curve *a, const drawing_curve *b)
{
    double u[2], v[2];

    if (hypot(a->p[3][0] - b->p[0][0], a->p[3][1] - b->p[0][1]) > 1e-6 || !direction(a, true, u) ||
        !direction(b, false, v))
        return false;
    return fabs(atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])) > SHARP;
}

const double *plot_corner_at(const drawing *d, const double near[2])
{
    const double *best = NULL;
    double least = HUGE_VAL;
    size_t first = 0;                   /* curve of this path, which may follow its last one */

    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        const bool last        = i + 1 == d->count || c[1].path != c->path;
        const double *at = c->p[3], far = hypot(at[0] - near[0], at[1] - near[1]);
        if (far < least && turns(c, last ? &d->curve[first] : c + 1)) {
            least = far;
            best  = at;
        }
        first = last ? i + 1 : first;
    }
    return best;
}

static void draw_frame(const plot_view *v, const double at[2])
{
    const double low = v->bottom + 20 * v->u;
    char words[80];

    plot_ink(v, 0.4);
    cairo_set_line_width(v->cairo, 0.8 * v->u);
    cairo_rectangle(v->cairo, v->left, v->top, v->right - v->left, v->bottom - v->top);
    cairo_stroke(v->cairo);
    plot_ink(v, 0.1);
    snprintf(words, sizeof words, "corner at %.2f, %.2f", at[0], at[1]);
    plot_text(v, PLOT_SMALL, v->left, low, 0, words);
    snprintf(words, sizeof words, "%g um wide; the band is the", ACROSS * v->o->tol * 1000);
    plot_text(v, PLOT_SMALL, v->left, low + 18 * v->u, 0, words);
    snprintf(words, sizeof words, "tolerance, %g um to each side", v->o->tol * 1000);
    plot_text(v, PLOT_SMALL, v->left, low + 36 * v->u, 0, words);
}

void plot_corner(plot_view *whole)
{
    const double *at = plot_corner_at(whole->o->d, whole->found.worst_point);
    plot_view v      = *whole;

    if (at == NULL)
        return;
    v.left   = whole->right + 18 * v.u;
    v.right  = v.left + PLOT_INSET * v.u;
    v.bottom = v.top + PLOT_INSET * v.u;
    v.scale  = PLOT_INSET * v.u / (ACROSS * v.o->tol);
    v.x0     = at[0] - ACROSS / 2 * v.o->tol;
    v.y0     = at[1] - ACROSS / 2 * v.o->tol;
    cairo_save(v.cairo);
    cairo_rectangle(v.cairo, v.left, v.top, v.right - v.left, v.bottom - v.top);
    cairo_clip(v.cairo);
    cairo_set_line_cap(v.cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(v.cairo, CAIRO_LINE_JOIN_ROUND);
    plot_curves(&v, 2 * v.o->tol * v.scale / v.u, 0.98, 0.90, 0.72);
    plot_curves(&v, 1.3, 0.13, 0.20, 0.34);
    cairo_set_source_rgb(v.cairo, 0.80, 0.12, 0.16);
    cairo_set_line_width(v.cairo, 1.1 * v.u);
    plot_machine(&v, true);
    cairo_restore(v.cairo);
    draw_frame(&v, at);
    whole->found.inset = true;
    memcpy(whole->found.corner, at, sizeof whole->found.corner);
}

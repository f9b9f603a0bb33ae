/* host-tools/draw/plot_shape.c -- control polygons, knots, and combs that show the curvature
 * SPDX-License-Identifier: MIT
 *
 * Curves of a .loft file are drawn as they are in the file, those of other drawings as cubics. The
 * teeth of a comb are as long as the curvature and point away from its centre. A step in their ends
 * is a joint that is not G2.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/curve.h"
#include "geometry/drawn.h"   /* drawn_pieces, piece_bend */
#include "draw/plot.h"
#include "base/memory.h"

#define TEETH_MIN  8            /* per piece */
#define TEETH_MAX  400
#define TOOTH_TURN 0.04        /* radians */
/* of the picture: curvature has no bound at a cusp; no limit if the scale is given */
#define TOOTH_MAX  0.25


// Pieces
// ------

/* The curves have been drawn: that they have pieces is known. */
static void every_piece(const drawing *d, drawn_sink *take, void *context)
{
    for (size_t i = 0; d->of != NULL && i < d->of->count; i++)
        (void)drawn_pieces(&d->of->curve[i], take, context);
    for (size_t i = 0; d->of == NULL && i < d->count; i++) {
        piece p = { .degree = 3, .w = { 1, 1, 1, 1 } };
        for (int k = 0; k < 4; k++)
            memcpy(p.p[k], d->curve[i].p[k], sizeof d->curve[i].p[k]);
        take(context, &p, i == 0 || d->curve[i].path != d->curve[i - 1].path);
    }
}


// Combs
// -----

/* First store teeth of length |curvature|: their scale is known when all are there. */
typedef struct {
    plot_view *v;
    double spacing;         /* mm between two teeth */
    size_t room;
    double *curvature;          /* curvature of each tooth, > 0: turns left */
} combing;

static void add_tooth(combing *c, const double at[3][CURVE_AXES], double curvature, bool fresh)
{
    plot_view *v = c->v;

    if (v->teeth == c->room) {
        c->room  = c->room ? 2 * c->room : 1024;
        v->tooth = memory_grow(v->tooth, c->room * sizeof *v->tooth);
        c->curvature = memory_grow(c->curvature, c->room * sizeof *c->curvature);
    }
    const double speed = hypot(at[1][0], at[1][1]);
    v->tooth[v->teeth] =
        (plot_tooth){ { at[0][0], at[0][1] }, { at[1][1] / speed, -at[1][0] / speed }, fresh };
    c->curvature[v->teeth++] = curvature;
}

/* The number of teeth that keeps neighbours close, on the curve and, where it bends, at their
 * ends. */
static int teeth_of(const piece *p, double spacing)
{
    double legs = 0, turns = 0, before[2] = { 0, 0 };

    for (unsigned k = 0; k < p->degree; k++) {
        const double leg[2] = { p->p[k + 1][0] - p->p[k][0], p->p[k + 1][1] - p->p[k][1] };
        legs  += hypot(leg[0], leg[1]);
        turns += fabs(atan2(before[0] * leg[1] - before[1] * leg[0],
                            before[0] * leg[0] + before[1] * leg[1]));
        memcpy(before, leg, sizeof before);
    }
    return (int)fmin(fmax(fmax(ceil(legs / spacing), ceil(turns / TOOTH_TURN)), TEETH_MIN),
                     TEETH_MAX);
}

static void comb_piece(void *context, const piece *p, bool fresh)
{
    combing *c = context;
    const int count = teeth_of(p, c->spacing);

    for (int j = 0; j <= count; j++) {
        double at[3][CURVE_AXES], curvature;
        piece_eval(p, (double)j / count, at);
        const bool is_curved = piece_bend(p, (double)j / count, &curvature);
        if (is_curved)
            add_tooth(c, (const double (*)[CURVE_AXES])at, curvature, fresh);
        fresh = !is_curved;
    }
}

static int compare_sizes(const void *a, const void *b)
{
    const double x = fabs(*(const double *)a), y = fabs(*(const double *)b);

    return x < y ? -1 : x > y;
}

/* A round scale that makes nineteen of twenty teeth shorter than an eighth of the picture. */
static double scale_of(const combing *c, double size)
{
    double *sorted = memory_grow(NULL, c->v->teeth * sizeof *sorted);

    memcpy(sorted, c->curvature, c->v->teeth * sizeof *sorted);
    qsort(sorted, c->v->teeth, sizeof *sorted, compare_sizes);
    const double most = c->v->teeth ? fabs(sorted[c->v->teeth * 19 / 20]) : 0;
    free(sorted);
    if (most * size < 1e-9)
        return size;                    /* only straight lines */
    const double wanted = size / 8 / most, power = pow(10, floor(log10(wanted)));
    return wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
}

void plot_make_combs(plot_view *v, const double box[2][2])
{
    const double size = fmax(box[1][0] - box[0][0], box[1][1] - box[0][1]);
    combing c = { .v = v, .spacing = fmax(size / 220, 1e-9) };

    if (v->o->comb < 0)
        return;
    every_piece(v->o->d, comb_piece, &c);
    v->comb = v->o->comb > 0 ? v->o->comb : scale_of(&c, size);
    const double most = v->o->comb > 0 ? size : TOOTH_MAX * size;
    for (size_t i = 0; i < v->teeth; i++) {
        const double length = copysign(fmin(fabs(c.curvature[i]) * v->comb, most), c.curvature[i]);
        for (int k = 0; k < 2; k++)
            v->tooth[i].tip[k] = v->tooth[i].foot[k] + length * v->tooth[i].tip[k];
    }
    free(c.curvature);
}

void plot_combs(const plot_view *v)
{
    cairo_set_source_rgb(v->cairo, 0.62, 0.82, 0.79);
    cairo_set_line_width(v->cairo, 0.45 * v->u);
    for (size_t i = 0; i < v->teeth; i++) {
        cairo_move_to(v->cairo, plot_x(v, v->tooth[i].foot[0]), plot_y(v, v->tooth[i].foot[1]));
        cairo_line_to(v->cairo, plot_x(v, v->tooth[i].tip[0]), plot_y(v, v->tooth[i].tip[1]));
    }
    cairo_stroke(v->cairo);
    cairo_set_source_rgb(v->cairo, 0.10, 0.55, 0.50);
    cairo_set_line_width(v->cairo, 0.8 * v->u);
    for (size_t i = 0; i < v->teeth; i++)
        (v->tooth[i].fresh ? cairo_move_to : cairo_line_to)(v->cairo, plot_x(v, v->tooth[i].tip[0]),
                                                            plot_y(v, v->tooth[i].tip[1]));
    cairo_stroke(v->cairo);
}


// Control
// -------

static void draw_square(const plot_view *v, const double p[2], double half)
{
    cairo_rectangle(v->cairo, plot_x(v, p[0]) - half, plot_y(v, p[1]) - half, 2 * half, 2 * half);
}

static void draw_disc(const plot_view *v, const double p[2], double radius)
{
    cairo_new_sub_path(v->cairo);
    cairo_arc(v->cairo, plot_x(v, p[0]), plot_y(v, p[1]), radius, 0, 7);
}

/* A point on the curve is square, a handle round. */
static void control_cubics(const plot_view *v)
{
    const drawing *d = v->o->d;

    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k < 4; k++)
            (k ? cairo_line_to : cairo_move_to)(v->cairo, plot_x(v, d->curve[i].p[k][0]),
                                                plot_y(v, d->curve[i].p[k][1]));
    cairo_stroke(v->cairo);
    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k < 4; k++)
            (k == 0 || k == 3 ? draw_square : draw_disc)(v, d->curve[i].p[k], 1.1 * v->u);
    cairo_fill(v->cairo);
}

static bool has_control_polygon(const curve *c)
{
    return curve_kinds[c->kind].bezier || curve_has_knots(c);
}

/* The end of the first derivative, drawn as long as the handle of a cubic. */
static void handle_of(const curve_point *p, double out[2])
{
    for (int i = 0; i < 2; i++)
        out[i] = p->p[i] + p->d[0][i] / 3;
}

static void control_lines(const plot_view *v, const curve *c)
{
    for (unsigned k = 0; k < c->count; k++) {
        const double *p = c->point[k].p;
        double handle[2];
        if (has_control_polygon(c)) {
            (k ? cairo_line_to : cairo_move_to)(v->cairo, plot_x(v, p[0]), plot_y(v, p[1]));
        } else if (curve_kinds[c->kind].slopes) {
            handle_of(&c->point[k], handle);
            cairo_move_to(v->cairo, plot_x(v, p[0]), plot_y(v, p[1]));
            cairo_line_to(v->cairo, plot_x(v, handle[0]), plot_y(v, handle[1]));
        }
    }
}

static void control_dots(const plot_view *v, const curve *c)
{
    for (unsigned k = 0; k < c->count; k++) {
        const bool on = !has_control_polygon(c) ||
                        (curve_kinds[c->kind].bezier && (k == 0 || k + 1 == c->count));
        double handle[2];
        (on ? draw_square : draw_disc)(v, c->point[k].p, 1.6 * v->u);
        if (curve_kinds[c->kind].slopes) {
            handle_of(&c->point[k], handle);
            draw_disc(v, handle, 1.3 * v->u);
        }
    }
}

/* Mark where a B-spline goes from one polynomial to the next: circles on the curve. */
static void knot_ring(void *context, const piece *p, bool fresh)
{
    const plot_view *v = *(const plot_view **)context;

    if (!fresh)
        draw_disc(v, p->p[0], 2.6 * v->u);
}

static void control_curves(const plot_view *v)
{
    const curves *all = v->o->d->of;

    for (size_t i = 0; i < all->count; i++)
        control_lines(v, &all->curve[i]);
    cairo_stroke(v->cairo);
    for (size_t i = 0; i < all->count; i++)
        control_dots(v, &all->curve[i]);
    cairo_fill(v->cairo);
    cairo_set_source_rgb(v->cairo, 0.13, 0.20, 0.34);
    for (size_t i = 0; i < all->count; i++)
        if (all->curve[i].knot_count > 0)
            (void)drawn_pieces(&all->curve[i], knot_ring, &v);
    cairo_stroke(v->cairo);
}

void plot_control(const plot_view *v)
{
    cairo_set_source_rgb(v->cairo, 0.90, 0.55, 0.10);
    cairo_set_line_width(v->cairo, 0.5 * v->u);
    (v->o->d->of ? control_curves : control_cubics)(v);
}

void plot_shape_box(const plot_view *v, double box[2][2])
{
    const drawing *d = v->o->d;

    for (size_t i = 0; i < v->teeth; i++)
        plot_join(box, v->tooth[i].tip);
    for (size_t i = 0; v->o->control && d->of != NULL && i < d->of->count; i++)
        for (unsigned k = 0; k < d->of->curve[i].count; k++)
            plot_join(box, d->of->curve[i].point[k].p);
}

/* host-tools/engine/curve.c -- kinds of curves: names, pieces and parameters; lists of curves
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>

#include "engine/curve.h"
#include "base/tool.h"       /* tool_grow */

#define KNOTS "knots that do not descend"
#define STEPS "and at least one step"

const curve_row curve_kinds[CURVE_KINDS] = {
    [CURVE_BEZIER] = { .name = "bezier", .bezier = true, .extends = true },
    [CURVE_LINE] = { .name = "line", .degree = 1, .joins = true },
    [CURVE_RATIONAL] = { .name     = "rational",
                         .rational = true,
                         .bezier   = true,
                         .remedy   = "give degree 1 to 9, weights above 0, " KNOTS ", " STEPS },
    [CURVE_PARABOLA] = { .name = "parabola", .degree = 2, .extends = true },
    [CURVE_HERMITE3] = { .name = "hermite3", .degree = 3, .joins = true, .slopes = true },
    [CURVE_HERMITE5] = { .name = "hermite5", .degree = 5, .joins = true, .slopes = true },
    [CURVE_CARDINAL] = { .name = "cardinal", .degree = 3, .joins = true, .hides_ends = true },
    [CURVE_NATURAL] = { .name = "natural uniform", .degree = 3, .joins = true },
    [CURVE_CHORD] = { .name = "natural chord", .degree = 3, .joins = true },
    [CURVE_BSPLINE] = { .name   = "bspline",
                        .knots  = true,
                        .remedy = "give degree 1 to 9, " KNOTS ", " STEPS },
    [CURVE_NURBS] = { .name     = "nurbs",
                      .rational = true,
                      .knots    = true,
                      .remedy   = "give degree 1 to 9, weights above 0, " KNOTS ", " STEPS },
    [CURVE_ARC] = { .name   = "arc",
                    .degree = 3,
                    .remedy = "its ends differ in their distance from the centre by more than "
                              "1/256: write more digits, or correct the centre" },
    [CURVE_SPLINE] = { .name = "spline", .degree = 3, .joins = true },
    [CURVE_TCB] = { .name = "tcb", .degree = 3, .joins = true, .hides_ends = true },
    [CURVE_CATMULL] = { .name = "catmull", .degree = 3, .joins = true, .hides_ends = true },
};

bool curve_is_high(const curve *c)
{
    return curve_kinds[c->kind].bezier && c->degree > CURVE_DEGREE_MAX;
}

bool curve_hides_ends(const curve *c)
{
    return curve_kinds[c->kind].hides_ends ||
           (c->kind == CURVE_SPLINE && (c->ends == CURVE_THROUGH || c->ends == CURVE_SLOPE));
}

bool curve_is_closed(const curve *c) { return c->kind == CURVE_SPLINE && c->ends == CURVE_CLOSED; }


// Pieces
// ------

/* Knots degree .. count of a B-spline bound its pieces; equal knots bound none. */
static unsigned knot_pieces(const curve *c)
{
    unsigned pieces = 0;

    for (unsigned i = c->degree; i < c->count; i++)
        pieces += c->knot[i + 1] > c->knot[i];
    return pieces;
}

static double knot_break(const curve *c, unsigned i)
{
    for (unsigned k = c->degree; k < c->count; k++)
        if (c->knot[k + 1] > c->knot[k] && i-- == 0)
            return c->knot[k];
    return c->knot[c->count];
}

unsigned curve_pieces(const curve *c)
{
    if (curve_has_knots(c))
        return knot_pieces(c);
    if (!curve_kinds[c->kind].joins)
        return 1;
    return c->count - (curve_hides_ends(c) ? 3 : curve_is_closed(c) ? 0 : 1);
}

double curve_break(const curve *c, unsigned i)
{
    if (curve_has_knots(c))
        return knot_break(c, i);
    if (c->kind == CURVE_PARABOLA)
        return c->point[i == 0 ? 0 : 2].w;
    return i;
}

double curve_from(const curve *c)
{
    return curve_has_knots(c) ? c->knot[c->degree] : curve_break(c, 0);
}

double curve_to(const curve *c)
{
    return curve_has_knots(c) ? c->knot[c->count] : curve_break(c, curve_pieces(c));
}

/* The piece of a B-spline that contains t, and its ends. */
static unsigned knot_locate(const curve *c, long double t, double end[2])
{
    unsigned pieces = 0;

    for (unsigned k = c->degree; k < c->count; k++)
        if (c->knot[k + 1] > c->knot[k]) {
            end[0] = c->knot[k];
            end[1] = c->knot[k + 1];
            pieces++;
            if (t < (long double)end[1])
                break;
        }
    return pieces - 1;
}

unsigned curve_locate(const curve *c, long double t, long double *local)
{
    const unsigned pieces = curve_pieces(c);
    double end[2] = { 0, 1 };
    unsigned i;

    if (curve_has_knots(c)) {
        i = knot_locate(c, t, end);
    } else {
        i = pieces == 1 || !(t >= 1) ? 0 : t >= pieces ? pieces - 1 : (unsigned)t;
        end[0] = curve_break(c, i);
        end[1] = curve_break(c, i + 1);
    }
    *local = (t - (long double)end[0]) / ((long double)end[1] - (long double)end[0]);
    return i;
}


// Lists
// -----

/* Make room for one more item; the room doubles when it is full. */
static void *room_for(void *list, size_t count, size_t each)
{
    return (count & (count - 1)) == 0 ? tool_grow(list, (count ? 2 * count : 1) * each) : list;
}

curve *curves_add(curves *all, enum curve_kind kind, unsigned line)
{
    all->curve = room_for(all->curve, all->count, sizeof *all->curve);
    curve *c = &all->curve[all->count++];
    *c = (curve){ .kind = kind, .line = line };
    return c;
}

void curve_add_point(curve *c, const curve_point *p)
{
    c->point = room_for(c->point, c->count, sizeof *c->point);
    c->point[c->count++] = *p;
}

void curve_add_knot(curve *c, double knot)
{
    c->knot = room_for(c->knot, c->knot_count, sizeof *c->knot);
    c->knot[c->knot_count++] = knot;
}

void curves_free(curves *all)
{
    for (size_t i = 0; i < all->count; i++) {
        free(all->curve[i].point);
        free(all->curve[i].knot);
    }
    free(all->curve);
    *all = (curves){ 0 };
}

/* host-tools/geometry/reference_spline.c -- cubic splines from their formula, in long double
 * SPDX-License-Identifier: MIT
 *
 * With the steps h and the second derivatives M of the cubics between the points (de Boor, A
 * Practical Guide to Splines, ch. IV)
 *
 *     h[i-1] M[i-1] + 2 (h[i-1] + h[i]) M[i] + h[i] M[i+1] = 6 (d[i] - d[i-1])
 *
 * d[i] = (P[i+1] - P[i]) / h[i]. At the ends: natural M = 0; clamped 2 h[0] M[0] + h[0] M[1] = 6
 * (d[0] - slope); not-a-knot (M[1] - M[0]) / h[0] = (M[2] - M[1]) / h[1]; closed: cyclic, by the
 * formula of Sherman and Morrison.
 */
#include <math.h>
#include <stdlib.h>

#include "geometry/reference.h"
#include "base/tool.h"          /* tool_grow */

typedef struct {
    long double below, on, above, right;
} row;

/* The points between which the cubics are, and how many steps there are. */
typedef struct {
    const curve_point *p;
    unsigned count, steps;
    enum curve_ends ends;       /* CURVE_ENDS: natural */
    bool chord;
} knot_row;

static knot_row knots_of(const curve *c)
{
    const bool spline  = c->kind == CURVE_SPLINE, slope = spline && c->ends == CURVE_SLOPE;
    const unsigned all = c->count - (slope ? 2 : 0);

    return (knot_row){ c->point + (slope ? 1 : 0), all, all - (curve_is_closed(c) ? 0 : 1),
                       !spline || c->ends == CURVE_THROUGH ? CURVE_ENDS
                       : slope                             ? CURVE_CLAMPED
                                                           : c->ends,
                       spline ? c->chord : c->kind == CURVE_CHORD };
}

static long double rise(const knot_row *s, unsigned i, int axis)
{
    return (long double)s->p[(i + 1) % s->count].p[axis] - (long double)s->p[i].p[axis];
}

static long double point_distance(const knot_row *s, unsigned i)
{
    long double sum = 0;

    for (int axis = 0; axis < CURVE_AXES; axis++)
        sum += rise(s, i, axis) * rise(s, i, axis);
    return sqrtl(sum);
}

/* The slope at an end: given, or half the way between the neighbours. */
static long double end_slope(const curve *c, const knot_row *s, unsigned i, int axis)
{
    return c->ends == CURVE_CLAMPED
               ? (long double)s->p[i].d[0][axis]
               : ((long double)s->p[i + 1].p[axis] - (long double)(s->p + i)[-1].p[axis]) / 2;
}

/* Elimination forward and back substitution (Thomas); the rows are diagonally dominant. */
static void solve_rows(row a[], unsigned count)
{
    for (unsigned i = 1; i < count; i++) {
        const long double factor = a[i].below / a[i - 1].on;
        a[i].on -= factor * a[i - 1].above;
        a[i].right -= factor * a[i - 1].right;
    }
    a[count - 1].right /= a[count - 1].on;
    for (unsigned i = count - 1; i-- > 0; )
        a[i].right = (a[i].right - a[i].above * a[i + 1].right) / a[i].on;
}

static void solve_cyclic(row a[], row copy[], unsigned count)
{
    const long double corner = a[0].below, other = a[count - 1].above, gamma = -a[0].on;
    long double share;

    a[0].on -= gamma;
    a[count - 1].on -= corner * other / gamma;
    for (unsigned i = 0; i < count; i++) {
        copy[i] = a[i];
        copy[i].right = i == 0 ? gamma : i + 1 == count ? other : 0;
    }
    solve_rows(a, count);
    solve_rows(copy, count);
    share = (a[0].right + corner / gamma * a[count - 1].right) /
            (1 + copy[0].right + corner / gamma * copy[count - 1].right);
    for (unsigned i = 0; i < count; i++)
        a[i].right -= share * copy[i].right;
}

static void set_rows(const reference *r, const knot_row *s, row a[], int axis)
{
    const unsigned last = s->count - 1;

    for (unsigned i = 0; i <= last; i++) {
        const unsigned before = (i + s->count - 1) % s->count;
        const long double h = r->step[before], k = r->step[i];
        if (s->steps < s->count && (i == 0 || i == last))
            a[i] = (row){ 0, 1, 0, 0 };
        else
            a[i] = (row){ h, 2 * (h + k), k,
                          6 * (rise(s, i, axis) / k - rise(s, before, axis) / h) };
    }
    if (s->ends == CURVE_CLAMPED) {
        const long double h = r->step[0], k = r->step[last - 1];
        a[0] = (row){ 0, 2 * h, h, 6 * (rise(s, 0, axis) / h - end_slope(r->c, s, 0, axis)) };
        a[last] = (row){ k, 2 * k, 0,
                         6 * (end_slope(r->c, s, last, axis) - rise(s, last - 1, axis) / k) };
    }
}

/* M[0] = ((h[0] + h[1]) M[1] - h[0] M[2]) / h[1] in the second row, likewise at the far end. */
static void solve_not_a_knot(const reference *r, row a[], unsigned count)
{
    const unsigned last = count - 1;
    const long double *h = r->step;

    if (count == 3)
        a[0].right = a[1].right = a[2].right = a[1].right / (3 * (h[0] + h[1]));
    if (count < 4)
        return;
    a[1].on += h[0] * (h[0] + h[1]) / h[1];
    a[1].above -= h[0] * h[0] / h[1];
    a[last - 1].on += h[last - 1] * (h[last - 1] + h[last - 2]) / h[last - 2];
    a[last - 1].below -= h[last - 1] * h[last - 1] / h[last - 2];
    solve_rows(a + 1, count - 2);
    a[0].right = ((h[0] + h[1]) * a[1].right - h[0] * a[2].right) / h[1];
    a[last].right = ((h[last - 1] + h[last - 2]) * a[last - 1].right -
                     h[last - 1] * a[last - 2].right) /
                    h[last - 2];
}

bool reference_spline_init(reference *r)
{
    const knot_row s = knots_of(r->c);
    row *a = tool_grow(NULL, 2 * s.count * sizeof *a);
    bool apart = true;

    r->step   = tool_grow(NULL, s.count * sizeof *r->step);
    r->second = tool_grow(NULL, s.count * sizeof *r->second);
    for (unsigned i = 0; i < s.count; i++) {
        r->step[i] = s.chord && i < s.steps ? point_distance(&s, i) : 1;
        apart = apart && r->step[i] > 0;
    }
    for (int axis = 0; axis < CURVE_AXES && apart; axis++) {
        set_rows(r, &s, a, axis);
        if (s.ends == CURVE_CLOSED)
            solve_cyclic(a, a + s.count, s.count);
        else if (s.ends == CURVE_NOT_A_KNOT)
            solve_not_a_knot(r, a, s.count);
        else
            solve_rows(a, s.count);
        for (unsigned i = 0; i < s.count; i++)
            r->second[i][axis] = a[i].right;
    }
    free(a);
    return apart;
}

void reference_spline_eval(const reference *r, unsigned k, long double t,
                           long double out[CURVE_AXES])
{
    const knot_row s = knots_of(r->c);
    const unsigned i = k + (r->c->kind == CURVE_SPLINE && r->c->ends == CURVE_THROUGH),
                   j = (i + 1) % s.count;
    const long double h2 = r->step[i] * r->step[i] / 6, u = 1 - t;

    for (int axis = 0; axis < CURVE_AXES; axis++)
        out[axis] = u * (long double)s.p[i].p[axis] + t * (long double)s.p[j].p[axis] +
                    h2 * ((u * u * u - u) * r->second[i][axis] +
                          (t * t * t - t) * r->second[j][axis]);
}

/* lib/curve/overlap.c
 * SPDX-License-Identifier: MIT
 *
 * A shared stretch ends where one of the curves does. Candidates are the pairs (s, t) of an end of
 * one curve and the nearest point of the other, and all pairs of ends. Between two candidates the
 * pieces of both curves are compared: if all control points are within 7/8 tol of each other, so
 * are all points.
 */
#include "curve/overlap.h"
#include "basis/dyadic.h"   /* loft_bernstein_sub */
#include "curve/nearest.h"  /* loft_bezier_nearest */
#include "num/muldiv.h"     /* loft_acc_muldiv */

#define POINTS (LOFT_DEGREE_MAX + 1)
#define PLACES 8
#define SLACK  LOFT_UNIT(1.0 / 1048576)

typedef struct {
    loft_unit s, t;
} place;

static void sub_axis(const loft_bezier *b, loft_unit from, loft_unit to, int axis, loft_acc out[])
{
    loft_acc c[POINTS];

    for (unsigned k = 0; k <= b->degree; k++)
        c[k] = loft_to_acc(b->p[k].axis[axis]);
    loft_bernstein_sub(c, b->degree, from, to, out);
}


/* Finding the stretch */

static void add_ends(const loft_bezier *a, const loft_bezier *b, loft_acc gap, place out[],
                     unsigned *count)
{
    for (unsigned end = 0; end < 4; end++) {
        const loft_vec p = a->p[end & 1 ? a->degree : 0], q = b->p[end & 2 ? b->degree : 0];
        const place here = { end & 1 ? LOFT_UNIT(1) : 0, end & 2 ? LOFT_UNIT(1) : 0 };
        if (loft_vec_distance(p, q) <= gap)
            out[(*count)++] = here;
    }
}

/* An end of `a` and the point of `b` nearest to it; `swap` if `a` is the second curve. */
static void add_nearest(const loft_bezier *a, const loft_bezier *b, loft_real tol, bool swap,
                        place out[], unsigned *count)
{
    const loft_real fine = tol / 8 > 0 ? tol / 8 : LOFT_REAL_LSB;
    loft_nearest n;

    for (unsigned end = 0; end < 2; end++) {
        const loft_unit at = end ? LOFT_UNIT(1) : 0;
        if (loft_bezier_nearest(b, a->p[end ? a->degree : 0], fine, &n) != LOFT_OK ||
            n.distance > loft_acc_ratio(loft_to_acc(tol), 2))
            continue;
        const place here = { swap ? n.t : at, swap ? at : n.t };
        out[(*count)++] = here;
    }
}

/* True if the pieces agree within `limit`, and are longer than 4 tol. */
static bool pieces_agree(const loft_bezier *a, const loft_bezier *b, place from, place to,
                         loft_acc limit, loft_acc *distance)
{
    loft_acc p[LOFT_AXES][POINTS], q[LOFT_AXES][POINTS], off[LOFT_AXES], extent = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        sub_axis(a, from.s, to.s, i, p[i]);
        sub_axis(b, from.t, to.t, i, q[i]);
    }
    for (unsigned k = a->degree + 1u; k-- > 0; ) {
        for (int i = 0; i < LOFT_AXES; i++)
            off[i] = p[i][k] - p[i][0];
        const loft_acc length = loft_acc_hypot(off, LOFT_AXES);
        extent = length > extent ? length : extent;
        for (int i = 0; i < LOFT_AXES; i++)
            off[i] = p[i][k] - q[i][k];
        *distance = loft_acc_hypot(off, LOFT_AXES);
        if (*distance > limit)
            return false;
    }
    return extent > 4 * limit + loft_acc_ratio(4 * limit, 7);
}

bool loft_bezier_overlap(const loft_bezier *a, const loft_bezier *b, loft_real tol,
                         loft_overlap *out)
{
    const loft_acc wide = loft_to_acc(tol), limit = wide - loft_acc_ratio(wide, 8);
    const loft_bezier *lower = a->degree < b->degree ? a : b,
                      *higher = a->degree < b->degree ? b : a;
    loft_vec p[POINTS];
    loft_bezier elevated = { p, higher->degree };
    place at[PLACES];
    loft_acc distance = 0;          /* for compilers that do not see that pieces_agree() sets it */
    unsigned count = 0;

    if (LOFT_AXES < 2 ||
        loft_bezier_elevate(lower, (unsigned)(higher->degree - lower->degree), p) != LOFT_OK)
        return false;
    add_ends(a, b, loft_acc_ratio(wide, 2), at, &count);
    add_nearest(a, b, tol, false, at, &count);
    add_nearest(b, a, tol, true, at, &count);
    for (unsigned j = 0; j < count; j++)
        for (unsigned k = 0; k < count; k++)
            if (at[j].s + SLACK < at[k].s &&
                (at[j].t + SLACK < at[k].t || at[k].t + SLACK < at[j].t) &&
                pieces_agree(lower == a ? &elevated : a, lower == a ? b : &elevated, at[j], at[k],
                             limit, &distance)) {
                const loft_overlap found = { at[j].s, at[k].s, at[j].t, at[k].t, distance };
                *out = found;
                return true;
            }
    return false;
}


/* Using the stretch */

/* The parameter on the first curve at the place with parameter t on the second. */
static loft_unit first_parameter(const loft_overlap *o, loft_unit t)
{
    const loft_acc one = loft_to_acc(LOFT_REAL(1)), way = loft_acc_scale(one, o->t_to - o->t_from);
    const loft_acc gone = loft_acc_scale(one, t - o->t_from),
                   length = loft_acc_scale(one, o->s_to - o->s_from);
    const loft_acc s = loft_acc_muldiv(length, way < 0 ? -gone : gone, way < 0 ? -way : way);

    return loft_unit_clamp(loft_unit_ratio(loft_acc_scale(one, o->s_from) + s, one));
}

static bool range_within(loft_unit from, loft_unit to, loft_unit low, loft_unit high)
{
    return from >= low - SLACK && to <= high + SLACK;
}

/* Edges within 60 degrees of the chord advance along it by at least half their length each. Two
 * points of the piece that are within tol of each other therefore have at most 2 tol of it between
 * them. Lengths and directions are exact to 2^-20. */
static bool turns_little(const loft_bezier *a, loft_unit from, loft_unit to)
{
    loft_acc p[LOFT_AXES][POINTS], chord[LOFT_AXES], edge[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        sub_axis(a, from, to, i, p[i]);
        chord[i] = p[i][a->degree] - p[i][0];
    }
    const loft_acc length = loft_acc_hypot(chord, LOFT_AXES);
    if (!(length > 0))
        return false;
    for (unsigned k = 0; k < a->degree; k++) {
        loft_acc ahead = 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            edge[i] = p[i][k + 1] - p[i][k];
            ahead += loft_acc_scale(edge[i], loft_unit_ratio(chord[i], length));
        }
        if (2 * ahead < loft_acc_hypot(edge, LOFT_AXES))
            return false;
    }
    return true;
}

bool loft_overlap_covers(const loft_overlap *o, const loft_bezier *a, loft_unit s_from,
                         loft_unit s_to, loft_unit t_from, loft_unit t_to)
{
    const bool back = o->t_to < o->t_from;

    if (!range_within(s_from, s_to, o->s_from, o->s_to) ||
        !range_within(t_from, t_to, back ? o->t_to : o->t_from, back ? o->t_from : o->t_to))
        return false;
    const loft_unit one = first_parameter(o, back ? t_to : t_from),
                    two = first_parameter(o, back ? t_from : t_to);
    return turns_little(a, one < s_from ? one : s_from, two > s_to ? two : s_to);
}

/* lib/curve/flatten.c -- chords within a tolerance (curve/measure.h)
 * SPDX-License-Identifier: MIT
 *
 * Consider a piece of the curve with the control points b0..b3 and a chord, the closed segment
 * between the *rounded* ends A and B. The distance to a segment is a convex function, so along the
 * piece
 *
 *     distance(P(t)) <= B0(t) d0 + B1(t) d1 + B2(t) d2 + B3(t) d3         d_i = distance of b_i
 *
 * Let m = max(d0, d3), and a >= b the excesses of d1 and d2 over m, or 0. With B1 + B2 <= 3/4 and
 * max B1 = max B2 = 4/9 this is at most
 *
 *     m + 3/4 b + 4/9 (a - b)                                             (1)
 *
 * with equality for d1 = d2 and for d2 = 0. A piece that fails (1) is halved, and both halves are
 * compared with the same chord, and so on until a piece is too far away. The pieces are the leaves
 * of a binary tree, piece k of 2^level, visited in order. The one after piece k is k + 1, or rather
 * the largest ancestor that starts there.
 *
 * The other direction: the nearest point on the chord moves continuously with t and comes within
 * the rounding of both ends. Every point of the chord is therefore the nearest one of some P(t), or
 * lies within the rounding of an end.
 *
 * The search. Let s be the parameter of the last point. The ends of the dyadic intervals that
 * contain s are tried, from the largest down to the first that succeeds. Bisection between that end
 * and the previous one follows. Halving the curve at the middle until both inner points are within
 * tol of the chord gives dyadic pieces with distances of at most 3/4 tol. The remainder s..r of
 * such a piece a..r is no farther from its own chord: its sideways motion is a part of that of the
 * whole piece. (Hill climbing over all such pieces found 3/4 tol.) So r is reached from every s in
 * a..r, and the chords here are never behind. */
#include "curve/measure.h"
#include "geom/chord.h"    /* loft_chord_foot */

#define STEPS ((uint32_t)1 << 24)   /* of the parameter: all are exact in every number type */
#define FINE  256                   /* ends are found to 1 / FINE of the chord             */
#define DEPTH 14                    /* pieces of a chord: 2^DEPTH where it is closest      */

/* An upper bound of the distance of w from the chord: the distance to a point of the chord that is
 * the nearest one except for rounding. */
static loft_acc chord_distance(const loft_acc w[LOFT_AXES], const loft_chord *c)
{
    loft_acc r[LOFT_AXES];

    loft_chord_foot(c, w, r);
    return loft_acc_hypot(r, LOFT_AXES);
}

/* The bound (1) times 36. */
static bool is_bound_within(loft_acc d0, loft_acc d1, loft_acc d2, loft_acc d3, loft_acc limit)
{
    const loft_acc m = d0 > d3 ? d0 : d3;
    loft_acc a = d1 > d2 ? d1 : d2, b = d1 > d2 ? d2 : d1;

    a = a > m ? a - m : 0;
    b = b > m ? b - m : 0;
    return 36 * m + 16 * a + 11 * b <= 36 * limit;
}

/* The piece from..to of one axis: the blossoms b[from,from,from] b[from,from,to] b[from,to,to]
 * b[to,to,to]. */
static void cut_axis(const loft_cubic *curve, int axis, loft_unit from, loft_unit to,
                     loft_acc out[4])
{
    loft_acc a[4], b[4];

    for (int k = 0; k < 4; k++)
        a[k] = b[k] = loft_to_acc(curve->p[k].axis[axis]);
    for (unsigned degree = 3; degree > 1; degree--) {
        loft_bernstein_step(a, degree, from);
        loft_bernstein_step(b, degree, to);
    }
    out[0] = loft_acc_lerp(a[0], a[1], from);
    out[1] = loft_acc_lerp(a[0], a[1], to);
    out[2] = loft_acc_lerp(b[0], b[1], from);
    out[3] = loft_acc_lerp(b[0], b[1], to);
}

/* The control points of the piece from..to, relative to the last point. */
static void cut_piece(const loft_flatten *f, uint32_t from, uint32_t to, loft_acc p[4][LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc c[4];
        cut_axis(&f->curve, i, loft_unit_of(from, STEPS), loft_unit_of(to, STEPS), c);
        for (int k = 0; k < 4; k++)
            p[k][i] = c[k] - loft_to_acc(f->last.axis[i]);
    }
}

/* The start of piece k of 2^level of the next `steps` steps. */
static uint32_t piece_start(const loft_flatten *f, uint32_t steps, uint32_t k, unsigned level)
{
    return f->at + (uint32_t)((uint64_t)steps * k >> level);
}

/* Is the curve from the last point to the one at `to` within the limit of the chord to *end? p is
 * its first piece. */
static bool is_curve_along(const loft_flatten *f, uint32_t to, const loft_chord *c,
                           loft_acc p[4][LOFT_AXES])
{
    loft_acc d0 = chord_distance(p[0], c);
    unsigned level = 0;
    uint32_t k = 0;

    for (;;) {
        const loft_acc d3 = chord_distance(p[3], c);
        if (d3 > f->limit)
            return false;
        if (is_bound_within(d0, chord_distance(p[1], c), chord_distance(p[2], c), d3, f->limit)) {
            d0 = d3;
            for (k++; level && k % 2 == 0; k /= 2)
                level--;
            if (level == 0)
                return true;
        } else {
            if (level == DEPTH)
                return false;
            k *= 2;
            level++;
        }
        cut_piece(f, piece_start(f, to - f->at, k, level), piece_start(f, to - f->at, k + 1, level),
                  p);
    }
}

/* True if a chord may lead from the last point to the one at `to`. *end is its end. */
static bool is_chord_close(const loft_flatten *f, uint32_t to, loft_vec *end)
{
    loft_acc p[4][LOFT_AXES];
    loft_chord c;

    cut_piece(f, f->at, to, p);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc from = loft_to_acc(f->last.axis[i]);
        end->axis[i] = to == STEPS ? f->curve.p[3].axis[i] : loft_acc_round(p[3][i] + from);
        c.u[i] = loft_to_acc(end->axis[i]) - from;
    }
    loft_chord_aim(&c);
    return is_curve_along(f, to, &c, p);
}

/* One step of the parameter is always flat: its inner points are within 2^-44 of the largest
 * coordinate from the exact chord, below 1/4 of the smallest tolerance. */
enum loft_status loft_flatten_init(loft_flatten *f, const loft_cubic *c, loft_real tol)
{
    const loft_acc wide = loft_to_acc(tol);
    loft_acc size = 0;

    if (!(tol > 0))
        return LOFT_ERR_ARG;
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_acc x = loft_to_acc(c->p[k].axis[i]);
            if (!loft_real_valid(c->p[k].axis[i]))
                return LOFT_ERR_RANGE;
            if (size < (x < 0 ? -x : x))
                size = x < 0 ? -x : x;
        }
    }
    if (!loft_real_valid(tol) || wide < 2 * loft_real_ulp(size) || wide < 512 * loft_acc_ulp(size))
        return LOFT_ERR_RANGE;

    f->curve = *c;
    f->last  = c->p[0];
    f->at    = 0;
    f->limit = wide - loft_acc_scale(wide, LOFT_UNIT(1.0 / 1048576)) - 64 * loft_acc_ulp(size);
    return LOFT_OK;
}

/* The end of the longest chord found, and its parameter. */
static uint32_t longest_chord(const loft_flatten *f, loft_vec *end)
{
    uint32_t low = f->at, high = low;
    loft_vec trial;

    for (uint32_t width = STEPS; width && low == f->at; width /= 2) {
        const uint32_t to = (f->at | (width - 1)) + 1;
        if (to == high)
            continue;
        if (is_chord_close(f, to, end) || width == 1)
            low = to;
        else
            high = to;
    }
    while (high > low + 1 + (low - f->at) / FINE) {
        const uint32_t to = low + (high - low) / 2;
        if (is_chord_close(f, to, &trial)) {
            low  = to;
            *end = trial;
        } else {
            high = to;
        }
    }
    return low;
}

bool loft_flatten_next(loft_flatten *f, loft_vec *out)
{
    loft_vec end;

    if (f->at == STEPS)
        return false;
    f->at   = longest_chord(f, &end);
    f->last = *out = end;
    return true;
}

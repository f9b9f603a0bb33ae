/* lib/curve/bounds.c
 * SPDX-License-Identifier: MIT
 *
 * Each axis is a polynomial, and its values on a piece are at most the largest coefficient of that
 * piece. A piece is dropped if that is below the best value found at the ends of pieces, or so
 * little above it that it can be used as the result. (The pieces become small near the roots of the
 * derivative, which need not be known.)
 *
 * Depth. A coefficient exceeds the larger end value of its piece by at most n^2 / 8 times the
 * largest second difference, which is h^2 times 4 |c| for a piece of width h. For n = 9 and h =
 * 2^-24 that is |c| 2^-42.6, in q16 2^-11 LSB, less than `enough` below. At that depth every piece
 * can therefore be used.
 *
 * Rounding. A coefficient of a piece is off by at most 9 * 2^-33 in q16 (3 * 9 ulp of double in
 * floats). `noise` is at least that, and is added to a coefficient that is used as a bound. The
 * whole curve has no noise. */
#include "curve/bounds.h"
#include "basis/dyadic.h"   /* loft_dyad, loft_bernstein_sub */

static loft_acc top_of(const loft_acc c[], unsigned degree)
{
    loft_acc top = c[0];

    for (unsigned k = 1; k <= degree; k++)
        if (c[k] > top)
            top = c[k];
    return top;
}

/* An upper bound of the polynomial that is not far above one of its values. */
static loft_acc highest(const loft_acc c[], unsigned degree, loft_acc ulp)
{
    const loft_acc noise = 3 * (int32_t)degree * ulp, enough = 256 * ulp;
    loft_acc best = c[0] > c[degree] ? c[0] : c[degree], bound = best, p[LOFT_DEGREE_MAX + 1];
    loft_dyad n = { 0, 0 };

    if (top_of(c, degree) <= best)
        return best;
    do {
        for (;;) {
            loft_bernstein_sub(c, degree, loft_dyad_from(n), loft_dyad_to(n), p);
            if (p[0] > best)
                best = p[0];
            if (p[degree] > best)
                best = p[degree];
            const loft_acc top = top_of(p, degree);
            if (top <= best + enough || n.level == LOFT_DYAD_LEVELS) {
                if (top + noise > bound)
                    bound = top + noise;
                break;
            }
            n = loft_dyad_half(n, 0);
        }
    } while (loft_dyad_next(&n));
    return bound;
}

/* The smallest coordinate >= x, but at most the coordinate `most`. */
static loft_acc ceiling(loft_acc x, loft_acc most)
{
    const loft_acc beyond = x + loft_real_ulp(x < 0 ? -x : x);

    if (!loft_acc_valid(beyond))
        return most;
    const loft_acc near = loft_to_acc(loft_acc_round(x)),
                   next = loft_to_acc(loft_acc_round(beyond));
    const loft_acc up = near < x ? next : near;
    return up < most && up >= x ? up : most;
}

static loft_acc upper(const loft_acc c[], unsigned degree)
{
    loft_acc size = 0;

    for (unsigned k = 0; k <= degree; k++)
        if (size < (c[k] < 0 ? -c[k] : c[k]))
            size = c[k] < 0 ? -c[k] : c[k];
    return ceiling(highest(c, degree, loft_acc_ulp(size)), top_of(c, degree));
}

/* The smallest value comes from the negated polynomial, as an acc: the negative of a coordinate may
 * not be a valid coordinate. */
loft_box loft_bezier_bounds(const loft_bezier *b)
{
    loft_acc c[LOFT_DEGREE_MAX + 1];
    loft_box box;

    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k <= b->degree; k++)
            c[k] = loft_to_acc(b->p[k].axis[i]);
        box.max.axis[i] = loft_acc_round(upper(c, b->degree));
        for (unsigned k = 0; k <= b->degree; k++)
            c[k] = -c[k];
        box.min.axis[i] = loft_acc_round(-upper(c, b->degree));
    }
    return box;
}

/* lib/basis/knots.c
 * SPDX-License-Identifier: MIT
 *
 * All parameters lie within the span, and the span lies within every pair of knots that a row uses:
 *
 *     k[s-rows+1+j] <= k[s] <= u <= k[s+1] <= k[s+1+j]        j = 0 .. rows - 1
 *
 * Each step is therefore an average of two values with weights in 0..1, and no division is by zero,
 * also with repeated knots. Nothing exceeds the largest coefficient, |c| <= 2^47; loft_acc_lerp_in
 * takes 2^62. Each of `degree` rows adds its own rounding: degree * 2^-33.
 */
#include "basis/knots.h"

enum loft_status loft_knots_init(loft_knots *knots, const loft_real k[], unsigned points,
                                 unsigned degree)
{
    if (degree < 1 || degree > LOFT_DEGREE_MAX || points <= degree ||
        points > LOFT_KNOTS_POINTS_MAX)
        return LOFT_ERR_ARG;

    const unsigned last = points + degree;
    for (unsigned i = 0; i <= last; i++)
        if (!loft_real_valid(k[i]))
            return LOFT_ERR_RANGE;
    for (unsigned i = 0; i < last; i++)
        if (k[i + 1] < k[i])
            return LOFT_ERR_ARG;
    for (unsigned i = 0; i + degree < last; i++)
        if (!(k[i] < k[i + degree + 1]))
            return LOFT_ERR_ARG;
    if (!(k[degree] < k[points]))
        return LOFT_ERR_ARG;

    knots->k = k;
    knots->points = (uint16_t)points;
    knots->degree = (uint8_t)degree;
    return LOFT_OK;
}

loft_real loft_knots_clamp(const loft_knots *knots, loft_real u)
{
    const loft_real start = knots->k[knots->degree], end = knots->k[knots->points];
    return u > start ? u < end ? u : end : start;
}

/* k[low] <= u always, and u < k[high] except for high = points. At the end of the domain, low is
 * the last index before it, and its span may be empty. */
unsigned loft_knots_find(const loft_knots *knots, loft_real u)
{
    unsigned low = knots->degree, high = knots->points;

    u = loft_knots_clamp(knots, u);
    while (high - low > 1) {
        const unsigned middle = low + (high - low) / 2;
        if (u < knots->k[middle])
            high = middle;
        else
            low = middle;
    }
    while (!(knots->k[low] < knots->k[low + 1]))
        low--;
    return low;
}

unsigned loft_knots_next(const loft_knots *knots, unsigned span)
{
    for (span = span ? span + 1 : knots->degree; span < knots->points; span++)
        if (knots->k[span] < knots->k[span + 1])
            return span;
    return 0;
}


/* Weights and values */

/* A B-spline of degree r - 1 over lo .. hi passes the fraction (u - lo) / (hi - lo) of itself to
 * its right neighbour of degree r and keeps the rest. As in loft_bernstein_weights, the part passed
 * on is rounded and the part kept is the difference, so the sum stays 1. Each degree adds two
 * roundings to a weight. */
unsigned loft_knots_weights(const loft_knots *knots, loft_real u, loft_acc w[])
{
    const unsigned s = loft_knots_find(knots, u);

    u = loft_knots_clamp(knots, u);
    w[0] = loft_to_acc(LOFT_REAL(1));
    for (unsigned r = 1; r <= knots->degree; r++) {
        w[r] = 0;
        for (unsigned i = r; i > 0; i--) {
            const loft_acc handed = loft_acc_lerp_in(0, w[i - 1], u, knots->k[s + i - r],
                                                     knots->k[s + i]);
            w[i]     += handed;
            w[i - 1] -= handed;
        }
    }
    return s - knots->degree;
}

void loft_knots_step(const loft_knots *knots, unsigned span, unsigned rows, loft_real u,
                     loft_acc c[])
{
    const loft_real *hi = &knots->k[span + 1], *lo = hi - rows;

    for (unsigned j = 0; j < rows; j++)
        c[j] = loft_acc_lerp_in(c[j], c[j + 1], u, lo[j], hi[j]);
}

/* The last `rows` rows, all at u. */
static loft_acc finish(const loft_knots *knots, unsigned span, unsigned rows, loft_real u,
                       loft_acc c[])
{
    for (; rows > 0; rows--)
        loft_knots_step(knots, span, rows, u, c);
    return c[0];
}

loft_acc loft_knots_eval(const loft_knots *knots, unsigned span, loft_real u, loft_acc c[])
{
    return finish(knots, span, knots->degree, u, c);
}

/* out[j] is the blossom with degree - j arguments k[s] and j arguments k[s+1]: degree - j rows at
 * the first, then j rows at the second in a copy. */
void loft_knots_bezier(const loft_knots *knots, unsigned span, loft_acc c[], loft_acc out[])
{
    const loft_real start = knots->k[span], end = knots->k[span + 1];
    loft_acc copy[LOFT_DEGREE_MAX + 1];

    for (unsigned rows = knots->degree + 1u; rows-- > 0; ) {
        for (unsigned j = 0; j <= rows; j++)
            copy[j] = c[j];
        out[rows] = finish(knots, span, rows, end, copy);
        if (rows > 0)
            loft_knots_step(knots, span, rows, start, c);
    }
}


/* Knot insertion */

bool loft_knots_valid(const loft_knots *knots, loft_real u)
{
    const unsigned last = knots->points + knots->degree;
    unsigned times = 0;

    if (!(u >= knots->k[knots->degree] && u <= knots->k[knots->points]) ||
        knots->points >= LOFT_KNOTS_POINTS_MAX)
        return false;
    for (unsigned i = 0; i <= last; i++)
        times += knots->k[i] >= u && knots->k[i] <= u;
    return times <= knots->degree;
}

void loft_knots_insert(const loft_knots *knots, loft_real u, loft_real out[])
{
    const unsigned span = loft_knots_find(knots, u), last = knots->points + knots->degree;

    for (unsigned i = last; i > span; i--)
        out[i + 1] = knots->k[i];
    out[span + 1] = u;
    for (unsigned i = 0; i <= span; i++)
        out[i] = knots->k[i];
}

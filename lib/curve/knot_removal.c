/* lib/curve/knot_removal.c
 * SPDX-License-Identifier: MIT
 *
 * Let r be the last index of the knot u, s its multiplicity, p the degree. Inserting u once more
 * into the curve without it gives, for i = r - p .. r - s,
 *
 *     P_i = a_i Q_i + (1 - a_i) Q_(i-1)        a_i = (u - k_i) / (k_(i+p+1) - k_i)
 *
 * p - s + 1 equations for p - s points Q. They are solved from both ends, with Q_(r-p-1) and the
 * last one known, up to the middle. Where both ends give the same point it is the mean of both.
 *
 * The knot is then inserted again, in the same numbers. The two curves are on the same knots, and
 * their weights sum to 1: they are nowhere further apart than their control points.
 */
#include "curve/knot_removal.h"

#include "num/sci.h"            /* loft_sci */

#define MOST (LOFT_DEGREE_MAX + 1)

/* a[j] of P_(first + j), j = 0..count - 1; count - 1 points are sought. */
typedef struct {
    const loft_bspline *b;
    unsigned first, count;
    loft_sci a[MOST];
} gap;

static loft_sci difference(loft_real x, loft_real y)
{
    return loft_sci_of(loft_to_acc(x) - loft_to_acc(y));
}

static bool find_gap(const loft_bspline *b, unsigned knot, gap *out)
{
    const loft_knots *n = &b->knots;
    unsigned r = knot, times = 1;

    if (knot <= n->degree || knot >= n->points || !(n->k[knot] > n->k[n->degree]) ||
        !(n->k[knot] < n->k[n->points]))
        return false;
    while (!(n->k[r + 1] > n->k[r]))
        r++;
    while (!(n->k[r - times] < n->k[r]))
        times++;
    if (times > n->degree)
        return false;
    out->b = b;
    out->first = r - n->degree;
    out->count = n->degree - times + 1;
    for (unsigned j = 0; j < out->count; j++) {
        const unsigned i = out->first + j;
        out->a[j] = loft_sci_div(difference(n->k[r], n->k[i]),
                                 difference(n->k[i + n->degree + 1], n->k[i]));
    }
    return true;
}

static loft_sci value_of(const gap *g, unsigned j, int axis)
{
    return loft_sci_from_real(g->b->p[g->first + j].axis[axis]);
}

/* q[0] = P_(first - 1), q[1] .. q[count - 1] the new points, q[count] = P_(first + count). */
static void solve(const gap *g, int axis, loft_sci q[MOST + 1])
{
    const loft_sci one = loft_sci_one();
    unsigned i = 0, j = g->count - 1;
    loft_sci low = loft_sci_from_real(g->b->p[g->first - 1].axis[axis]),
             high = loft_sci_from_real(g->b->p[g->first + g->count].axis[axis]);

    q[0] = low;
    q[g->count] = high;
    for (; i < j; i++, j--) {
        const loft_sci left = loft_sci_sub(one, g->a[i]), right = loft_sci_sub(one, g->a[j]);
        low = loft_sci_div(loft_sci_sub_product(value_of(g, i, axis), left, low), g->a[i]);
        high = loft_sci_div(loft_sci_sub_product(value_of(g, j, axis), g->a[j], high), right);
        q[i + 1] = low;
        q[j] = i + 1 == j ? loft_sci_mul(loft_sci_power2(-1), loft_sci_add(low, high)) : high;
    }
}

/* The rounded new points; false if one does not fit. */
static bool round_points(const gap *g, loft_vec out[MOST + 1])
{
    loft_sci q[MOST + 1];

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        solve(g, axis, q);
        for (unsigned j = 0; j <= g->count; j++) {
            loft_acc x;
            if (!loft_sci_to_acc(q[j], &x) || !loft_acc_valid(x))
                return false;
            out[j].axis[axis] = loft_acc_round(x);
        }
    }
    return true;
}

/* The largest distance of P_i from what the new points give. */
static bool distance_of(const gap *g, const loft_vec q[MOST + 1], loft_acc *out)
{
    loft_sci most = loft_sci_zero();

    for (unsigned j = 0; j < g->count; j++) {
        loft_sci sum = loft_sci_zero();
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const loft_sci x = loft_sci_lerp(loft_sci_from_real(q[j].axis[axis]),
                                             loft_sci_from_real(q[j + 1].axis[axis]), g->a[j]);
            const loft_sci off = loft_sci_sub(x, value_of(g, j, axis));
            sum = loft_sci_add(sum, loft_sci_mul(off, off));
        }
        most = loft_sci_larger(most, sum);
    }
    return loft_sci_to_acc(loft_sci_sqrt(most), out);
}

enum loft_status loft_bspline_remove(const loft_bspline *b, unsigned knot, loft_vec p[],
                                     loft_real knots[], loft_acc *far)
{
    const unsigned points = b->knots.points, all = points + b->knots.degree + 1u;
    loft_vec q[MOST + 1];
    loft_acc distance;
    gap g;

    if (!find_gap(b, knot, &g))
        return LOFT_ERR_ARG;
    if (!round_points(&g, q) || !distance_of(&g, q, &distance))
        return LOFT_ERR_RANGE;
    for (unsigned i = 0; i + 1 < points; i++)
        p[i] = i < g.first ? b->p[i] : i + 1 < g.first + g.count ? q[i - g.first + 1] : b->p[i + 1];
    for (unsigned i = 0; i + 1 < all; i++)
        knots[i] = b->knots.k[i < knot ? i : i + 1];
    *far = distance;
    return LOFT_OK;
}

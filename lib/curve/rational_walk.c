/* lib/curve/rational_walk.c
 * SPDX-License-Identifier: MIT
 *
 * Let c_k be the coefficients of numerator or denominator and g_k = C(d, k) D^k c_0. The polynomial
 * at i/n, times n^d, is
 *
 *     n^d F(i/n) = sum_k  g_k n^(d-k) i^k
 *
 * and an integer for integer c_k. Its differences at i = 0 are integers too, and adding them is
 * exact. In q16 the c_k are integers: below 2^31 2^24 = 2^55 for a coordinate times a weight, and
 * for a weight times 2^31. With n^d < 2^63 all values are below 2^118. The differences may wrap at
 * 2^128, where sums are still correct. So the quotient is that of the true values and is rounded
 * once.
 *
 * In floats the n^d F are rounded as in forward.c, relative to the largest coefficient. The
 * quotient has a denominator of at least the smallest weight, so the ratio R of the weights enters
 * twice.
 */
#include "curve/rational_walk.h"
#include "num/walk_exact.h"     /* loft_walk_exact_steps_valid */

#define DEGREE LOFT_RATIONAL_WALK_DEGREE_MAX

/* a_k = g_k n^(d-k), replacing the Bernstein coefficients */
static void powers(loft_acc128 a[], unsigned degree, uint32_t n)
{
    for (unsigned k = 1; k <= degree; k++)
        for (unsigned i = degree; i >= k; i--)
            a[i] = loft_acc128_sub(a[i], a[i - 1]);
    for (unsigned k = 0; k <= degree; k++) {
        a[k] = loft_acc128_times(a[k], (uint32_t)loft_binomial(degree, k));
        for (unsigned i = k; i < degree; i++)
            a[k] = loft_acc128_times(a[k], n);
    }
}

/* Turn sum a_k i^k into its differences at i = 0: dividing by i, i - 1, .. in turn gives the
 * coefficients of i (i-1) .. (i-k+1), whose k-th difference is k!. */
static void differences(loft_acc128 a[], unsigned degree)
{
    uint32_t factorial = 1;

    for (unsigned j = 1; j < degree; j++)
        for (unsigned k = degree - 1; k >= j; k--)
            a[k] = loft_acc128_add(a[k], loft_acc128_times(a[k + 1], j));
    for (unsigned k = 2; k <= degree; k++) {
        factorial *= k;
        a[k] = loft_acc128_times(a[k], factorial);
    }
}

enum loft_status loft_rational_walk_init(loft_rational_walk *walk, const loft_rational *r,
                                         uint32_t n)
{
    const unsigned degree = r->degree;

    if (degree > DEGREE || n == 0)
        return LOFT_ERR_ARG;
    if (!loft_walk_exact_steps_valid(degree, n))
        return LOFT_ERR_RANGE;
    for (unsigned k = 0; k <= degree; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (!loft_acc128_valid(r->p[k].p.axis[i]))
                return LOFT_ERR_RANGE;

    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k <= degree; k++)
            walk->x[i][k] = loft_acc128_of(loft_prod(r->p[k].p.axis[i], r->p[k].w));
        powers(walk->x[i], degree, n);
        differences(walk->x[i], degree);
    }
    for (unsigned k = 0; k <= degree; k++)
        walk->w[k] = loft_acc128_of(loft_to_acc(r->p[k].w) * LOFT_PROJECT);
    powers(walk->w, degree, n);
    differences(walk->w, degree);
    walk->end = r->p[degree].p;
    walk->left = n;
    walk->degree = (uint8_t)degree;
    return LOFT_OK;
}

bool loft_rational_walk_next(loft_rational_walk *walk, loft_vec *out)
{
    if (walk->left == 0)
        return false;
    walk->left--;

    loft_acc128_step(walk->w, walk->degree);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc128_step(walk->x[i], walk->degree);
        out->axis[i] = loft_acc128_project(walk->x[i][0], walk->w[0]);
    }
    if (walk->left == 0)
        *out = walk->end;
    return true;
}

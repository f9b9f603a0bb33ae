/* lib/basis/sign.c
 * SPDX-License-Identifier: MIT
 *
 * Coefficients have R bits (31, in floats 128). Second differences have R + 2, products of two of
 * them 2 R + 4: 66 and 260 bits, well within LOFT_EXACT_BITS.
 */
#include "basis/sign.h"
#include "num/exact.h"  /* loft_exact: exact decisions */

static bool taken(loft_exact out[], const loft_real a[], unsigned count)
{
    for (unsigned k = 0; k < count; k++) {
        if (!loft_exact_valid(a[k]))
            return false;
        out[k] = loft_exact_from_real(a[k]);
    }
    return true;
}

/* a0 a2 - a1^2 */
static loft_exact discriminant(const loft_exact a[3])
{
    return loft_exact_det(a[0], a[1], a[1], a[2]);
}

/* Theorem 2.1: a0 >= 0, a2 >= 0 and a1 >= - sqrt(a0 a2); the same with > for a positive polynomial.
 * The result is the smallest of the three signs: 1 positive, 0 touches zero, -1 has negative
 * values. */
static int quadratic_sign(const loft_exact a[3])
{
    const int s0 = loft_exact_sign(a[0]), s2 = loft_exact_sign(a[2]), least = s0 < s2 ? s0 : s2;
    const int inside = loft_exact_sign(a[1]) >= 0 ? 1 : loft_exact_sign(discriminant(a));

    return least < inside ? least : inside;
}

static loft_exact twice(loft_exact x) { return loft_exact_add(x, x); }

/* Elevated to degree m, the coefficients times m (m - 1) are
 *
 *     f(k) = (m - k) (m - k - 1) a0 + 2 k (m - k) a1 + k (k - 1) a2,      k = 0..m
 *
 * This is quadratic in k: f(0) = m (m - 1) a0, f(1) - f(0) = 2 (m - 1) (a1 - a0), and the second
 * difference is 2 d with d = a0 - 2 a1 + a2. True if all of them are > 0. All values are below
 * 62 * 61 * 2^R. */
static bool elevated_is_positive(const loft_exact a[3], loft_exact d, int32_t m)
{
    loft_exact f    = loft_exact_mul(loft_exact_from_int(m * (m - 1)), a[0]);
    loft_exact step = loft_exact_mul(loft_exact_from_int(2 * (m - 1)), loft_exact_sub(a[1], a[0]));

    for (int32_t k = 0; k <= m; k++) {
        if (loft_exact_sign(f) <= 0)
            return false;
        f = loft_exact_add(f, step);
        step = loft_exact_add(step, twice(d));
    }
    return true;
}

static int8_t elevations_needed(const loft_exact a[3], loft_exact d)
{
    for (int8_t r = 0; r <= LOFT_ELEVATIONS_MAX; r++)
        if (elevated_is_positive(a, d, r + 2))
            return r;
    return -1;
}

/* The vertex lies in 0..1 if both edges point toward it, a0 > a1 < a2. Then the minimum is (a0 a2 -
 * a1^2) / d; otherwise it is at an end. */
static bool has_vertex_inside(const loft_exact a[3])
{
    return loft_exact_compare(a[0], a[1]) > 0 && loft_exact_compare(a[2], a[1]) > 0;
}

enum loft_status loft_quadratic_sign(const loft_real a[3], loft_sign *out)
{
    loft_exact x[3];
    loft_acc vertex;

    if (!taken(x, a, 3))
        return LOFT_ERR_RANGE;
    const loft_exact d = loft_exact_add(loft_exact_sub(x[0], twice(x[1])), x[2]);
    const int sign = quadratic_sign(x);

    out->min = a[0] < a[2] ? a[0] : a[2];
    if (has_vertex_inside(x) && loft_exact_quot(discriminant(x), d, -LOFT_EXACT_REAL, &vertex))
        out->min = loft_acc_round(vertex);
    out->nonnegative = sign >= 0;
    out->positive = sign > 0;
    out->elevations = sign > 0 ? elevations_needed(x, d) : -1;
    return LOFT_OK;
}

/* The second derivative is n (n - 1) times the polynomial of degree n - 2 with the second
 * differences as coefficients. If its degree is at most 1, the coefficients decide; for degree 2
 * theorem 2.1 does. */
enum loft_status loft_bernstein_convex(const loft_real b[], unsigned degree, bool *net,
                                       bool *polynomial)
{
    loft_exact x[5];
    bool all = true;

    if (degree > 4)
        return LOFT_ERR_ARG;
    if (!taken(x, b, degree + 1))
        return LOFT_ERR_RANGE;
    for (unsigned k = 0; k + 2 <= degree; k++) {
        x[k] = loft_exact_add(loft_exact_sub(x[k], twice(x[k + 1])), x[k + 2]);
        all = all && loft_exact_sign(x[k]) >= 0;
    }
    *net = all;
    *polynomial = degree == 4 ? quadratic_sign(x) >= 0 : all;
    return LOFT_OK;
}

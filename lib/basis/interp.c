/* lib/basis/interp.c
 * SPDX-License-Identifier: MIT
 */
#include "basis/interp.h"
#include "basis/bernstein.h"    /* loft_bernstein_eval */
#include "num/exact.h"          /* loft_exact */


/* The parabola. With i, j, k in cyclic order,
 *
 *     p(t) = - sum f_i (t_j - t_k) (t - t_j) (t - t_k) / D
 *     D    = (t_0 - t_1) (t_1 - t_2) (t_2 - t_0)
 *
 * is Newton's form f_0 + (t - t_0) [01] + (t - t_0) (t - t_1) [012] with its divided differences
 * over one common denominator. Each result is the quotient of such a sum and D. The longest sum has
 * four factors (and twice as many terms for the blossom), 4 (R + 1) + 3 bits: 131 in q16, 519 in
 * floats. Numbers carry the factor 2^E, E = LOFT_EXACT_REAL, and D carries 2^(3E); the quotient is
 * shifted by the difference. */

/* a - b of two coordinates */
static loft_exact coordinate_gap(loft_real a, loft_real b)
{
    return loft_exact_sub(loft_exact_from_real(a), loft_exact_from_real(b));
}

/* - f_i (t_j - t_k) */
static loft_exact newton_weight(const loft_parabola *p, int i)
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return loft_exact_mul(loft_exact_from_real(p->f[i]), coordinate_gap(p->t[k], p->t[j]));
}

/* D */
static loft_exact parabola_denominator(const loft_parabola *p)
{
    return loft_exact_mul(
        coordinate_gap(p->t[0], p->t[1]),
        loft_exact_mul(coordinate_gap(p->t[1], p->t[2]), coordinate_gap(p->t[2], p->t[0])));
}

/* x / D * 2^shift, rounded to a coordinate if it fits */
static bool over_denominator(const loft_parabola *p, loft_exact x, int shift, loft_real *out)
{
    loft_acc y;

    if (!loft_exact_quot(x, parabola_denominator(p), shift, &y) || !loft_acc_valid(y))
        return false;
    *out = loft_acc_round(y);
    return true;
}

enum loft_status loft_parabola_init(loft_parabola *p, const loft_real t[3], const loft_real f[3])
{
    for (int i = 0; i < 3; i++)
        if (!loft_exact_valid(t[i]) || !loft_exact_valid(f[i]))
            return LOFT_ERR_RANGE;
    for (int i = 0; i < 3; i++)
        if (loft_exact_sign(coordinate_gap(t[i], t[(i + 1) % 3])) == 0)
            return LOFT_SINGULAR;
    for (int i = 0; i < 3; i++) {
        p->t[i] = t[i];
        p->f[i] = f[i];
    }
    return LOFT_OK;
}

/* The blossom: (t - t_j) (t - t_k) is replaced by half of (u - t_j) (v - t_k) + (u - t_k) (v -
 * t_j). */
static enum loft_status parabola_blossom(const loft_parabola *p, loft_real u, loft_real v,
                                         loft_real *out)
{
    loft_exact sum = loft_exact_from_int(0);

    if (!loft_exact_valid(u) || !loft_exact_valid(v))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < 3; i++) {
        const loft_real tj = p->t[(i + 1) % 3], tk = p->t[(i + 2) % 3];
        const loft_exact one = loft_exact_mul(coordinate_gap(u, tj), coordinate_gap(v, tk)),
                         two = loft_exact_mul(coordinate_gap(u, tk), coordinate_gap(v, tj));
        sum = loft_exact_add(sum, loft_exact_mul(newton_weight(p, i), loft_exact_add(one, two)));
    }
    return over_denominator(p, sum, -LOFT_EXACT_REAL - 1, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_parabola_eval(const loft_parabola *p, loft_real t, loft_real *out)
{
    return parabola_blossom(p, t, t, out);
}

/* (t - t_j) + (t - t_k) replaces the product of both */
enum loft_status loft_parabola_deriv(const loft_parabola *p, loft_real t, loft_real *out)
{
    loft_exact sum = loft_exact_from_int(0);

    if (!loft_exact_valid(t))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < 3; i++) {
        const loft_exact factor = loft_exact_add(coordinate_gap(t, p->t[(i + 1) % 3]),
                                                 coordinate_gap(t, p->t[(i + 2) % 3]));
        sum = loft_exact_add(sum, loft_exact_mul(newton_weight(p, i), factor));
    }
    return over_denominator(p, sum, 0, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

/* (t - t_j) (t - t_k) = t_j t_k - (t_j + t_k) t + t^2 */
enum loft_status loft_parabola_power(const loft_parabola *p, loft_real a[3])
{
    loft_exact sum[3];

    for (int m = 0; m < 3; m++)
        sum[m] = loft_exact_from_int(0);
    for (int i = 0; i < 3; i++) {
        const loft_exact w = newton_weight(p, i);
        const loft_exact tj = loft_exact_from_real(p->t[(i + 1) % 3]),
                         tk = loft_exact_from_real(p->t[(i + 2) % 3]);
        sum[0] = loft_exact_add(sum[0], loft_exact_mul(w, loft_exact_mul(tj, tk)));
        sum[1] = loft_exact_sub(sum[1], loft_exact_mul(w, loft_exact_add(tj, tk)));
        sum[2] = loft_exact_add(sum[2], w);
    }
    for (int m = 0; m < 3; m++)
        if (!over_denominator(p, sum[m], (m - 1) * LOFT_EXACT_REAL, &a[m]))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

enum loft_status loft_parabola_bernstein(const loft_parabola *p, loft_real from, loft_real to,
                                         loft_real c[3])
{
    enum loft_status status = parabola_blossom(p, from, from, &c[0]);

    if (status == LOFT_OK)
        status = parabola_blossom(p, from, to, &c[1]);
    if (status == LOFT_OK)
        status = parabola_blossom(p, to, to, &c[2]);
    return status;
}


/* Values and derivatives at both ends. The coefficients next to an end follow from the slope there:
 *
 *     cubic     p0    p0 + t0 / 3    p1 - t1 / 3    p1
 *     quintic   p0    p0 + t0 / 5    p0 + (8 t0 + a0) / 20
 *               p1 - (8 t1 - a1) / 20    p1 - t1 / 5    p1
 *
 * The coefficients of the derivative need no division except by 4, which a loft_acc represents
 * (q16: coordinates have 16 zeros below them; other sums are rounded by 2^-33):
 *
 *     cubic     t0    3 (p1 - p0) - t0 - t1    t1
 *     quintic   t0    t0 + a0 / 4    5 (p1 - p0) - 2 (t0 + t1) - (a0 - a1) / 4    t1 - a1 / 4    t1
 *
 * Range in q16, where values must stay below 2^30 for loft_acc_lerp. Another k - 1 differences
 * multiply by n!/(n-k)! / n and 2^(k-1), the scheme by L^(n-k) <= 3^(n-k):
 *
 *     quintic, |e| <= 2^16
 *         |c| <= 2^16 (5 * 2 + 4 + 1/2) < 2^19.9, times at most 24 * 8 * 3 (k = 4): 2^29.1
 *     cubic, |e| <= 2^21
 *         |c| <= 2^21 (3 * 2 + 2) = 2^24, times at most 9 (k = 1): 2^27.2
 *     cubic, t in 0..1, |slopes| <= 2^26, |e[1] - e[0]| <= 2^25
 *         |c| <= 2^25 (3 + 4) < 2^27.9, the second derivative 2 (2^27.9 + 2^26) < 2^29.3
 *     quintic, t in 0..1, |e| <= 2^24, |e[4]|, |e[5]| <= 2^27
 *         |8 e[2] + e[4]| <= 2^28, |c| <= 2^24 + 2^28 / 20 < 2^25
 *         first derivative: |c| <= 2^24 (10 + 4) + 2^26 < 2^28.2 */

void loft_ends3_bernstein(const loft_acc e[4], loft_acc c[4])
{
    c[0] = e[0];
    c[1] = e[0] + loft_acc_ratio(e[2], 3);
    c[2] = e[1] - loft_acc_ratio(e[3], 3);
    c[3] = e[1];
}

void loft_ends5_bernstein(const loft_acc e[6], loft_acc c[6])
{
    c[0] = e[0];
    c[1] = e[0] + loft_acc_ratio(e[2], 5);
    c[2] = e[0] + loft_acc_ratio(8 * e[2] + e[4], 20);
    c[3] = e[1] - loft_acc_ratio(8 * e[3] - e[5], 20);
    c[4] = e[1] - loft_acc_ratio(e[3], 5);
    c[5] = e[1];
}

/* The k-th derivative at t of the polynomial with the coefficients c[0..degree], which are
 * overwritten. */
static loft_acc bernstein_derivative(loft_acc c[], unsigned degree, unsigned k, loft_unit t)
{
    if (k > degree)
        return 0;
    for (; k > 0; k--, degree--)
        for (unsigned i = 0; i < degree; i++)
            c[i] = (int32_t)degree * (c[i+1] - c[i]);
    return loft_bernstein_eval(c, degree, t);
}

loft_acc loft_ends3_deriv(const loft_acc e[4], unsigned k, loft_unit t)
{
    loft_acc c[4];

    if (k == 0) {
        loft_ends3_bernstein(e, c);
        return loft_bernstein_eval(c, 3, t);
    }
    c[0] = e[2];
    c[1] = 3 * (e[1] - e[0]) - e[2] - e[3];
    c[2] = e[3];
    return bernstein_derivative(c, 2, k - 1, t);
}

loft_acc loft_ends5_deriv(const loft_acc e[6], unsigned k, loft_unit t)
{
    loft_acc c[6];

    if (k == 0) {
        loft_ends5_bernstein(e, c);
        return loft_bernstein_eval(c, 5, t);
    }
    c[0] = e[2];
    c[1] = e[2] + loft_acc_ratio(e[4], 4);
    c[2] = 5 * (e[1] - e[0]) - 2 * (e[2] + e[3]) - loft_acc_ratio(e[4] - e[5], 4);
    c[3] = e[3] - loft_acc_ratio(e[5], 4);
    c[4] = e[3];
    return bernstein_derivative(c, 4, k - 1, t);
}

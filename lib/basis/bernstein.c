/* lib/basis/bernstein.c
 * SPDX-License-Identifier: MIT
 */
#include "basis/bernstein.h"

/* Range and error of all functions below, in q16 (a loft_acc counts 2^-32).
 *
 * Coefficients are at most 2^15, that is 2^47 as acc. A row of de Casteljau's scheme at t
 * multiplies the largest of them by at most L = |1 - t| + |t|, which is 1 in 0..1 and at most 3 in
 * -1..2. After nine rows: 3^9 * 2^47 < 2^61.3. Within the last row, the two values are below 3^8 *
 * 2^47 < 2^59.7, their difference is below 2^60.7, and times t it is below 2^61.7. loft_acc_lerp
 * requires 2^62.
 *
 * Each lerp rounds once, by at most 2^-33. The next row multiplies that by L and adds its own
 * error:
 *
 *     e_n = 2^-33 (1 + L + .. + L^(n-1))
 *     in 0..1   n 2^-33
 *     L = 3     9841 * 2^-33 < 2^-19.7 for n = 9
 *
 * 2^-19.7 is 0.08 LSB: a value that is then rounded to a coordinate is within 0.58 LSB for any t.
 * This is the law of extrapolation.
 */

/* C(n,k) = C(n,k-1) (n-k+1) / k; each product is divisible. C(28,14) * 28 < 2^31. */
int32_t loft_binomial(unsigned n, unsigned k)
{
    int32_t c = 1;

    if (k > n)
        return 0;
    for (unsigned i = 1; i <= k; i++)
        c = c * (int32_t)(n - i + 1) / (int32_t)i;
    return c;
}

/* B_i^k = (1 - t) B_i^(k-1) + t B_(i-1)^(k-1): each weight of one degree passes the fraction t to
 * its right neighbour of the next degree and keeps the rest. The part passed on is rounded and the
 * part kept is the difference, so the sum stays exactly 1. Each degree adds two roundings of 2^-33
 * to a weight, and the following degrees multiply the largest error by at most L: 2 e_k, with e_k
 * as above. */
void loft_bernstein_weights(unsigned degree, loft_unit t, loft_acc w[])
{
    w[0] = loft_to_acc(LOFT_REAL(1));
    for (unsigned k = 1; k <= degree; k++) {
        w[k] = 0;
        for (unsigned i = k; i > 0; i--) {
            const loft_acc handed = loft_acc_scale(w[i-1], t);
            w[i]   += handed;
            w[i-1] -= handed;
        }
    }
}

void loft_bernstein_step(loft_acc c[], unsigned degree, loft_unit t)
{
    for (unsigned i = 0; i < degree; i++)
        c[i] = loft_acc_lerp(c[i], c[i+1], t);
}

loft_acc loft_bernstein_eval(loft_acc c[], unsigned degree, loft_unit t)
{
    for (unsigned k = degree; k > 0; k--)
        loft_bernstein_step(c, k, t);
    return c[0];
}

loft_acc loft_bernstein_at(loft_acc c[], unsigned degree, uint32_t j, uint32_t n)
{
    for (unsigned k = degree; k > 0; k--)
        for (unsigned i = 0; i < k; i++)
            c[i] = loft_acc_lerp_at(c[i], c[i+1], j, n);
    return c[0];
}

/* |D^k c| <= 2^k 2^47 <= 2^56 */
void loft_bernstein_differences(loft_acc c[], unsigned degree)
{
    for (unsigned k = 1; k <= degree; k++)
        for (unsigned i = degree; i >= k; i--)
            c[i] -= c[i-1];
}

/* C(n,k) 2^k is largest for n = 9, k = 6: 84 * 64 = 5376 < 2^12.4, so results are below 2^59.4. */
void loft_bernstein_to_power(loft_acc c[], unsigned degree)
{
    loft_bernstein_differences(c, degree);
    for (unsigned k = 1; k < degree; k++)
        c[k] *= loft_binomial(degree, k);
}

/* It runs from the last coefficient down, since b_i needs c_0..c_i. Each term is rounded once;
 * C(i,k) <= 126, so a product is below 2^54. The terms k = 0 (c_0 itself) and i = k = n (c_n
 * itself) are exact. */
void loft_bernstein_from_power(loft_acc c[], unsigned degree)
{
    for (unsigned i = degree; i > 0; i--) {
        loft_acc sum = c[0];
        for (unsigned k = 1; k <= i; k++)
            sum += loft_acc_ratio(c[k] * loft_binomial(i, k), loft_binomial(degree, k));
        c[i] = sum;
    }
}

/* v = v x + c_k and d = d x + v: the derivative lags one step behind. With |x| <= 2:
 *
 *     |v| <= 2^47 (1 + 2 + .. + 2^9) < 2^57
 *     |d| <= 2^47 (1 + 2*2 + 3*4 + .. + 9*2^8) = 4097 * 2^47 < 2^59.1
 *
 * Errors after k steps, in units of 2^-33: v: 2^k - 1. The error of d becomes 2 d + v + 1; from 0
 * at k = 1 this gives (k-1) 2^(k-1). For n = 9 these are 511 and 2048, or 2^-8 and 2^-6 LSB. */
enum loft_status loft_power_eval(const loft_real c[], unsigned degree, loft_unit x,
                                 loft_real *value, loft_real *deriv)
{
    if (degree > LOFT_DEGREE_MAX || !(x >= LOFT_UNIT(-2) && x <= LOFT_UNIT(2)))
        return LOFT_ERR_ARG;

    loft_acc v = loft_to_acc(c[degree]), d = 0;
    for (unsigned k = degree; k > 0; k--) {
        d = loft_acc_scale(d, x) + v;
        v = loft_acc_scale(v, x) + loft_to_acc(c[k-1]);
    }
    if (!loft_acc_valid(v) || !loft_acc_valid(d))
        return LOFT_ERR_RANGE;

    *value = loft_acc_round(v);
    *deriv = loft_acc_round(d);
    return LOFT_OK;
}

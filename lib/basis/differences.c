/* lib/basis/differences.c
 * SPDX-License-Identifier: MIT
 *
 * f(t) = sum_k C(d,k) D^k a_0 t^k, and the j-th difference of i^k at i = 0 is T(k,j) = j! S(k,j),
 * with Stirling numbers of the second kind. For steps of 1/n it follows that
 *
 *     e_j = sum_(k >= j) C(d,k) D^k a_0 T(k,j) n^(d-k) / n^d
 *
 * Numerator and denominator are integers. With d <= 9: C <= 126 < 2^7, |D^k a_0| <= 2^9 |a|, T <= 9
 * 8 7! 36 < 2^22, n^d < 2^288, and nine terms: below 2^(R + 330) for coefficients of R bits (31 in
 * q16, 128 in floats). loft_exact holds that.
 */
#include "basis/differences.h"
#include "num/exact.h"          /* loft_exact_mul, loft_exact_quot */

/* T(k,j) for all j <= k of one row k, computed in place from the row before: T(k,j) = j (T(k-1,j) +
 * T(k-1,j-1)). */
static void next_row(int32_t row[], unsigned k)
{
    for (unsigned j = k; j > 0; j--)
        row[j] = (int32_t)j * (row[j] + row[j-1]);
    row[0] = 0;
}

/* The numerator of e_j, by Horner's rule over k; d[k] = D^k a_0. */
static loft_exact numerator(const loft_exact d[], unsigned degree, unsigned j, loft_exact n)
{
    int32_t row[LOFT_DEGREE_MAX + 1] = { 1 };
    loft_exact sum = loft_exact_from_int(0);

    for (unsigned k = 0; k <= degree; k++) {
        if (k > 0)
            next_row(row, k);
        sum = loft_exact_mul(n, sum);
        if (k >= j) {
            const loft_exact weight = loft_exact_mul(loft_exact_from_int(loft_binomial(degree, k)),
                                                     loft_exact_from_int(row[j]));
            sum = loft_exact_add(sum, loft_exact_mul(weight, d[k]));
        }
    }
    return sum;
}

static enum loft_status differences(const loft_real a[], unsigned degree, loft_exact d[])
{
    for (unsigned k = 0; k <= degree; k++) {
        if (!loft_exact_valid(a[k]))
            return LOFT_ERR_RANGE;
        d[k] = loft_exact_from_real(a[k]);
    }
    for (unsigned k = 1; k <= degree; k++)
        for (unsigned i = degree; i >= k; i--)
            d[i] = loft_exact_sub(d[i], d[i-1]);
    return LOFT_OK;
}

enum loft_status loft_bernstein_forward_differences(const loft_real a[], unsigned degree,
                                                    uint32_t n, loft_real e[])
{
    loft_exact d[LOFT_DEGREE_MAX + 1];
    loft_real out[LOFT_DEGREE_MAX + 1];

    if (degree > LOFT_DEGREE_MAX || n < 1)
        return LOFT_ERR_ARG;
    if (differences(a, degree, d) != LOFT_OK)
        return LOFT_ERR_RANGE;

    const loft_exact steps = loft_exact_add(
        loft_exact_shift(loft_exact_from_int((int32_t)(n >> 16)), 16),
        loft_exact_from_int((int32_t)(n & 0xffffu)));
    loft_exact power = loft_exact_from_int(1);
    for (unsigned k = 0; k < degree; k++)
        power = loft_exact_mul(steps, power);

    for (unsigned j = 0; j <= degree; j++) {
        loft_acc wide;
        if (!loft_exact_quot(numerator(d, degree, j, steps), power, -LOFT_EXACT_REAL, &wide) ||
            !loft_acc_valid(wide))
            return LOFT_ERR_RANGE;
        out[j] = loft_acc_round(wide);
    }
    for (unsigned j = 0; j <= degree; j++)
        e[j] = out[j];
    return LOFT_OK;
}

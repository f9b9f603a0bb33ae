/* lib/basis/integral.c
 * SPDX-License-Identifier: MIT
 *
 * The primitive of sum b_k B_k^n that is 0 at 0 has the coefficients c_k = (b_0 + .. + b_(k-1)) /
 * (n + 1), of degree n + 1. The sums are below n + 1 times the largest b.
 *
 * B_i^m B_j^n = C(m, i) C(n, j) / C(m + n, i + j) B_(i+j)^(m+n).
 */
#include "basis/integral.h"

#define COUNT_MAX 220
#define PRODUCT_MAX 37

static bool reals_valid(const loft_real b[], unsigned count)
{
    for (unsigned k = 0; k < count; k++)
        if (!loft_real_valid(b[k]))
            return false;
    return true;
}

enum loft_status loft_bernstein_mean(const loft_real b[], unsigned count, loft_acc *out)
{
    loft_acc sum = 0;

    if (count < 1 || count > COUNT_MAX)
        return LOFT_ERR_ARG;
    if (!reals_valid(b, count))
        return LOFT_ERR_RANGE;
    for (unsigned k = 0; k < count; k++)
        sum += loft_to_acc(b[k]);
    *out = loft_acc_ratio(sum, (int32_t)count);
    return LOFT_OK;
}

static loft_sci value_at(const loft_sci b[], unsigned degree, loft_sci t)
{
    const loft_sci u = loft_sci_sub(loft_sci_one(), t);
    loft_sci c[PRODUCT_MAX + 1];

    for (unsigned k = 0; k <= degree; k++)
        c[k] = b[k];
    for (unsigned n = degree; n > 0; n--)
        for (unsigned k = 0; k < n; k++)
            c[k] = loft_sci_add(loft_sci_mul(u, c[k]), loft_sci_mul(t, c[k + 1]));
    return c[0];
}

loft_sci loft_bernstein_integral_sci(const loft_sci b[], unsigned degree, loft_sci from,
                                     loft_sci to)
{
    const loft_sci part = loft_sci_from_int((int32_t)degree + 1);
    loft_sci c[PRODUCT_MAX + 1], sum = loft_sci_zero();

    c[0] = sum;
    for (unsigned k = 0; k <= degree; k++) {
        sum = loft_sci_add(sum, b[k]);
        c[k + 1] = loft_sci_div(sum, part);
    }
    return loft_sci_sub(value_at(c, degree + 1, to), value_at(c, degree + 1, from));
}

static bool unit_valid(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

enum loft_status loft_bernstein_integral(const loft_real b[], unsigned degree, loft_unit from,
                                         loft_unit to, loft_acc *out)
{
    loft_sci c[LOFT_DEGREE_MAX + 1];

    if (degree > LOFT_DEGREE_MAX || !unit_valid(from) || !unit_valid(to))
        return LOFT_ERR_ARG;
    if (!reals_valid(b, degree + 1))
        return LOFT_ERR_RANGE;
    for (unsigned k = 0; k <= degree; k++)
        c[k] = loft_sci_from_real(b[k]);
    return loft_sci_to_acc(loft_bernstein_integral_sci(c, degree, loft_sci_from_unit(from),
                                                       loft_sci_from_unit(to)),
                           out)
               ? LOFT_OK
               : LOFT_ERR_RANGE;
}

loft_sci loft_binomial_sci(unsigned n, unsigned k)
{
    loft_sci c = loft_sci_one();

    if (k > n)
        return loft_sci_zero();
    for (unsigned i = 1; i <= k; i++)
        c = loft_sci_div(loft_sci_mul(c, loft_sci_from_int((int32_t)(n - i + 1))),
                         loft_sci_from_int((int32_t)i));
    return c;
}

void loft_bernstein_product(const loft_sci a[], unsigned m, const loft_sci b[], unsigned n,
                            loft_sci out[])
{
    for (unsigned k = 0; k <= m + n; k++)
        out[k] = loft_sci_zero();
    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            const loft_sci x = loft_sci_mul(loft_sci_mul(a[i], loft_binomial_sci(m, i)),
                                            loft_sci_mul(b[j], loft_binomial_sci(n, j)));
            out[i + j] = loft_sci_add(out[i + j], x);
        }
    for (unsigned k = 0; k <= m + n; k++)
        out[k] = loft_sci_div(out[k], loft_binomial_sci(m + n, k));
}

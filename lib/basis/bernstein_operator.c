/* lib/basis/bernstein_operator.c -- iterates of Bernstein's operator
 * SPDX-License-Identifier: MIT
 *
 * B preserves x, and maps x (1 - x) to (1 - 1/n) x (1 - x). For a function that vanishes at 0 and
 * 1, |g| <= c x (1 - x) therefore implies |B g| <= (1 - 1/n) c x (1 - x). Two things follow:
 *
 * Sampling errors do not accumulate. They are e = n 2^-33 in each inner node and 0 at the ends
 * (loft_bernstein_at). In the nodes x (1 - x) >= (n - 1) / n^2, so each round adds at most e n^2 /
 * (n - 1) x (1 - x). All rounds together add at most n times that, e n^3 / (4 n - 4). For n = 9
 * this is 205 * 2^-33 for any number of rounds.
 *
 * The limit is reached. f differs from its line by at most 2^17, which is at most 2^17 n^2 / (n -
 * 1) x (1 - x). After 512 rounds (8/9)^512 < 2^-87 of that is left: nothing in any number type.
 */
#include "basis/bernstein_operator.h"

#define TIMES_MAX 512

/* g_i = sum f_j B_j(i / n) at the inner nodes, in place. */
static void sample(loft_acc f[], unsigned n)
{
    loft_acc g[LOFT_DEGREE_MAX + 1], c[LOFT_DEGREE_MAX + 1];

    for (unsigned i = 1; i < n; i++) {
        for (unsigned j = 0; j <= n; j++)
            c[j] = f[j];
        g[i] = loft_bernstein_at(c, n, i, n);
    }
    for (unsigned i = 1; i < n; i++)
        f[i] = g[i];
}

enum loft_status loft_bernstein_iterate(const loft_real f[], unsigned n, uint32_t times,
                                        loft_unit x, loft_real *value)
{
    loft_acc g[LOFT_DEGREE_MAX + 1];

    if (n < 1 || n > LOFT_DEGREE_MAX || times < 1 || !(x >= LOFT_UNIT(-1) && x <= LOFT_UNIT(2)))
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i <= n; i++)
        if (!loft_real_valid(f[i]))
            return LOFT_ERR_RANGE;

    if (times > TIMES_MAX) {                    /* the limit: a polynomial of degree 1 */
        g[0] = loft_to_acc(f[0]);
        g[1] = loft_to_acc(f[n]);
        n = 1;
    } else {
        for (unsigned i = 0; i <= n; i++)
            g[i] = loft_to_acc(f[i]);
        while (--times)
            sample(g, n);
    }
    const loft_acc y = loft_bernstein_eval(g, n, x);
    if (!loft_acc_valid(y))
        return LOFT_ERR_RANGE;
    *value = loft_acc_round(y);
    return LOFT_OK;
}

/* De Casteljau's algorithm on n + 1 numbers, in place: n roundings of 2^-33. The differences of the
 * derivative are below 2^17, and n times their average below 2^23. */
static loft_acc average(loft_acc c[], unsigned n, loft_unit x)
{
    for (; n > 0; n--)
        for (unsigned i = 0; i < n; i++)
            c[i] = loft_acc_lerp(c[i], c[i + 1], x);
    return c[0];
}

enum loft_status loft_bernstein_operator(const loft_real f[], unsigned n, loft_unit x,
                                         loft_real *value, loft_real *deriv)
{
    loft_acc c[LOFT_OPERATOR_MAX + 1];

    if (n < 1 || n > LOFT_OPERATOR_MAX || !(x >= 0 && x <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i <= n; i++) {
        if (!loft_real_valid(f[i]))
            return LOFT_ERR_RANGE;
        c[i] = loft_to_acc(f[i]);
    }
    const loft_acc y = average(c, n, x);
    for (unsigned i = 0; i < n; i++)
        c[i] = loft_to_acc(f[i + 1]) - loft_to_acc(f[i]);
    const loft_acc slope = (loft_acc)n * average(c, n - 1, x);
    if (!loft_acc_valid(y) || !loft_acc_valid(slope))
        return LOFT_ERR_RANGE;
    *value = loft_acc_round(y);
    *deriv = loft_acc_round(slope);
    return LOFT_OK;
}

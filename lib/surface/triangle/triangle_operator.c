/* lib/surface/triangle/triangle_operator.c
 * SPDX-License-Identifier: MIT
 *
 * B keeps u, v and w, and maps the product of two of them to 1 - 1/n of itself. So it does for
 * h = u v + v w + w u. In every node but the corners h >= (n - 1) / n^2. So a function that
 * vanishes in the corners and is at most c in the nodes is there below c n^2 / (n - 1) h, and after
 * k rounds below (1 - 1/n)^k of that.
 *
 * The errors of sampling, e = n 2^-33 per round in the nodes and none in the corners, add up to at
 * most n e n^2 / (n - 1) h <= e n^3 / (3 n - 3), as h <= 1/3. The limit is reached after 512
 * rounds: f differs from the plane by at most 2^17 before, and then by (8/9)^512 2^17 n^2 / (n - 1)
 * < 2^-66.
 */
#include "surface/triangle/triangle_operator.h"

#define TIMES_MAX 512
#define MOST LOFT_TRIANGLE_MAX

/* The value at the node (i, j, k) / n. A sum is below n 2^47, and each row rounds by 2^-33. */
static loft_acc at_node(loft_acc c[], unsigned n, int32_t i, int32_t j, int32_t k)
{
    for (unsigned rows = n; rows > 0; rows--)
        for (unsigned m = 0, p = 0; m < rows; m++)
            for (unsigned l = 0; l <= m; l++, p++)
                c[p] = loft_acc_ratio(c[p] * i + c[p + m + 1] * j + c[p + m + 2] * k, (int32_t)n);
    return c[0];
}

static void copy(const loft_acc from[], unsigned count, loft_acc to[])
{
    for (unsigned k = 0; k < count; k++)
        to[k] = from[k];
}

static void sample(loft_acc f[], unsigned n)
{
    const unsigned count = LOFT_TRIANGLE_POINTS(n);
    loft_acc g[MOST], c[MOST];

    for (unsigned m = 0, p = 0; m <= n; m++)
        for (unsigned k = 0; k <= m; k++, p++) {
            copy(f, count, c);
            g[p] = at_node(c, n, (int32_t)(n - m), (int32_t)(m - k), (int32_t)k);
        }
    copy(g, count, f);
}

/* The net of the polynomial after `times` rounds, and its degree. */
static enum loft_status iterate(const loft_real f[], unsigned *n, uint32_t times, loft_acc g[])
{
    if (*n < 1 || *n > LOFT_DEGREE_MAX || times < 1)
        return LOFT_ERR_ARG;
    for (unsigned p = 0; p < LOFT_TRIANGLE_POINTS(*n); p++) {
        if (!loft_real_valid(f[p]))
            return LOFT_ERR_RANGE;
        g[p] = loft_to_acc(f[p]);
    }
    if (times > TIMES_MAX) {                        /* the limit: a polynomial of degree 1 */
        g[1] = g[loft_triangle_place(*n, 0)];
        g[2] = g[loft_triangle_place(0, *n)];
        *n = 1;
    } else {
        while (--times)
            sample(g, *n);
    }
    return LOFT_OK;
}

enum loft_status loft_triangle_iterate(const loft_real f[], unsigned n, uint32_t times, loft_bary u,
                                       loft_real *value)
{
    loft_acc g[MOST];

    const enum loft_status status = iterate(f, &n, times, g);
    if (status == LOFT_OK)
        *value = loft_acc_round(loft_bary_eval(g, n, loft_bary_clamp(u)));
    return status;
}

/* The samples err by at most s 2^-33, which the n rows multiply by L^n. After 512 rounds the
 * remaining distance of f from the plane is multiplied by at most 2^14.3. */
enum loft_status loft_triangle_iterate_extrapolate(const loft_real f[], unsigned n, uint32_t times,
                                                   loft_bary u, loft_real *value)
{
    loft_acc g[MOST], product = loft_to_acc(LOFT_REAL(1));

    const enum loft_status status = iterate(f, &n, times, g);
    if (status != LOFT_OK)
        return status;
    if (!loft_bary_grows(u, false, n, &product))
        return LOFT_ERR_RANGE;
    const loft_acc x = loft_bary_eval(g, n, u);
    if (!loft_acc_valid(x))
        return LOFT_ERR_RANGE;
    *value = loft_acc_round(x);
    return LOFT_OK;
}

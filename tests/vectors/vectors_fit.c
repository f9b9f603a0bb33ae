/* tests/vectors/vectors_fit.c -- readers of curves near many points
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors_points.h"         /* expect_vecs, as_given; row, answer, law */
#include "curve/fit.h"

#define CONTROLS 64
#define DATA     200

static void bspline_fit(row *r)
{
    static loft_real knot[CONTROLS + 10], u[DATA], weight[DATA];
    static loft_vec p[DATA], out[CONTROLS];
    static loft_sci memory[LOFT_FIT_MEMORY(CONTROLS, LOFT_DEGREE_MAX)];
    const unsigned degree = row_count(r, "p", LOFT_DEGREE_MAX), n = row_count(r, "n", CONTROLS),
                   d = dimension(r), count = row_count(r, "count", DATA);

    row_reals(r, "U_q16", n + degree + 1, knot);
    row_reals(r, "u_q16", count, u);
    row_reals(r, "w_q16", count, weight);
    r->largest = 0;
    row_points(r, "P_q16", count, d, p);
    if (!as_given(r))
        return;
    const loft_fit_points data = { p, u, weight, count };
    const enum loft_status status = loft_bspline_fit(&data, knot, n, degree,
                                                     row_is(r, "ends", "closed"), out, memory);
    /* W times the sums of rows of the inverse matrix are below 1e4 in this file */
    const long double most = powl(degree + 1, 3) * (8 + count) * 1e4L;
    expect_vecs(r, "Q", status, out, n, d,
                (law){ .lsb = 0.5L + 1 / 131072.0L + most * 0x1p-60L * r->largest / LSB,
                       .roundings = most });
}

const vector_system vectors_fit[] = {
    { "bspline_fit", "p,n,d,ends,U_q16,count,u_q16,w_q16,P_q16,Q", bspline_fit,
      "q16: 1/2 LSB + 2^-17 LSB + 1e4 (p + 1)^3 (8 + count) 2^-60 L" },
    { 0 }
};

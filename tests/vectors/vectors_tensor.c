/* tests/vectors/vectors_tensor.c -- readers of the systems of tensor-product patches
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors_points.h"         /* row, law, expect_vec */
#include "surface/tensor/tensor.h"
#include "support/tensor_joins.h"           /* tj_flags: of coordinates that reading rounded */

#define POINTS ((LOFT_DEGREE_MAX + 2) * (LOFT_DEGREE_MAX + 1))

/* 0..1: within a bound of 1/2 LSB and `rows` roundings of 2^-33, times `factor`, of sums of weights
 * `gain`. */
static law inside(unsigned rows, long double factor, long double gain)
{
    return (law) { .lsb = 0.5L + factor * rows / 131072, .gain = gain, .roundings = 3 * rows + 2 };
}

static loft_tensor patch(row *r, unsigned d, loft_vec p[])
{
    const unsigned m = row_count(r, "m", LOFT_DEGREE_MAX), n = row_count(r, "n", LOFT_DEGREE_MAX);
    loft_tensor s = { p, (uint8_t)m, (uint8_t)n };

    row_points(r, "net_q16", (m + 1) * (n + 1), d, p);
    if (loft_tensor_init(&s, p, m, n) != LOFT_OK)
        row_complain(r, "the patch was refused");
    return s;
}

/* Both orders: the transposed net is evaluated along v first. */
static void tensor_eval(row *r)
{
    loft_vec p[POINTS], q[POINTS], v = { { 0 } };
    const unsigned d = row_count(r, "d", LOFT_AXES);
    const loft_tensor s = patch(r, d, p);
    const loft_unit at_u = row_unit(r, "u_q16"), at_v = row_unit(r, "v_q16");
    const unsigned rows = s.m + s.n;
    const loft_tensor other = { q, s.n, s.m };

    loft_tensor_transpose(&s, q);
    expect_vec(r, "P", LOFT_OK, loft_tensor_eval(&s, at_u, at_v), d, inside(rows, 1, 1));
    expect_vec(r, "P", LOFT_OK, loft_tensor_eval(&other, at_v, at_u), d, inside(rows, 1, 1));
    const enum loft_status by_u = loft_tensor_deriv(&s, 1, 0, at_u, at_v, &v);
    expect_vec(r, "Pu", by_u, v, d, inside(rows, s.m, 2 * s.m));
    const enum loft_status by_v = loft_tensor_deriv(&s, 0, 1, at_u, at_v, &v);
    expect_vec(r, "Pv", by_v, v, d, inside(rows, s.n, 2 * s.n));
}

static void tensor_elevate(row *r)
{
    loft_vec p[POINTS], out[POINTS];
    const loft_tensor s = patch(r, 1, p);

    if (row_is(r, "dir", "u"))
        expect_vecs(r, "out", loft_tensor_elevate_u(&s, 1, out), out, (s.m + 2u) * (s.n + 1u), 1,
                    inside(1, 1, 1));
    else if (row_is(r, "dir", "v"))
        expect_vecs(r, "out", loft_tensor_elevate_v(&s, 1, out), out, (s.m + 1u) * (s.n + 2u), 1,
                    inside(1, 1, 1));
    else
        row_complain(r, "column dir is neither u nor v");
}

static void tensor_split(row *r)
{
    loft_vec p[POINTS], left[POINTS], right[POINTS];
    const loft_tensor s = patch(r, 1, p);
    const loft_unit t = row_unit(r, "u0_q16");
    const long double x = exact_unit(t);
    const law l = { .lsb = 0.5L + growth_sum(x, s.m) / 131072,
                    .gain = powl(growth(x), s.m),
                    .roundings = 3 * s.m };

    const enum loft_status status = loft_tensor_split_u(&s, t, left, right);
    expect_vecs(r, "L", status, left, (s.m + 1u) * (s.n + 1u), 1, l);
    expect_vecs(r, "R", status, right, (s.m + 1u) * (s.n + 1u), 1, l);
}

/* Where a float rounded coordinates their own flags count, decided by the tests. */
static void tensor_join(row *r)
{
    loft_vec p[POINTS], q[POINTS];
    const unsigned m = row_count(r, "m", LOFT_DEGREE_MAX), n = row_count(r, "n", LOFT_DEGREE_MAX);
    loft_tensor first, second;
    loft_tensor_join j;
    bool c0, c1;
    int g1;

    row_points(r, "P_q16", (m + 1) * (n + 1), 3, p);
    row_points(r, "Q_q16", (m + 1) * (n + 1), 3, q);
    if (loft_tensor_init(&first, p, m, n) || loft_tensor_init(&second, q, m, n) ||
        loft_tensor_join_init(&j, &first, &second)) {
        row_complain(r, "not patches that can join");
        return;
    }
    if (r->inexact > 0) {
        tj_flags(&first, &second, &c0, &c1, &g1);
        if (j.c0 != c0 || j.c1 != c1 || (g1 >= 0 && j.g1 != g1))
            row_complain(r, "a flag is not that of the rounded coordinates");
        return;
    }
    row_expect_flag(r, "C0", j.c0);
    row_expect_flag(r, "C1", j.c1);
    row_expect_flag(r, "G1", j.g1);
}

const vector_system vectors_tensor[] = {
    { "tensor_eval", "m,n,d,net_q16,u_q16,v_q16,P,Pu,Pv", tensor_eval,
      "q16: 1/2 LSB + f (m + n) 2^-17 LSB, f = 1, for Pu m, for Pv n; floats: 1/2 ulp + 6 f (m + "
      "n) ulp of double" },
    { "tensor_elevate", "m,n,dir,net_q16,out", tensor_elevate,
      "q16: 1/2 LSB + 2^-17 LSB, floats: 1 ulp" },
    { "tensor_split", "m,n,net_q16,u0_q16,L,R", tensor_split,
      "law of extrapolation, as bezier_split" },
    { "tensor_join", "m,n,P_q16,Q_q16,C0,C1,G1", tensor_join, "flags exact" },
    { 0 }
};

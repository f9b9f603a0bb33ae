/* tests/vectors/vectors_tetra.c -- readers of the Bezier tetrahedra
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_whole.h"            /* whole_of, wide */
#include "vectors/vectors.h"                /* row, answer, law */
#include "surface/tetra.h"

static loft_volume row_volume(row *r, const char *column)
{
    const long double largest = r->largest;
    loft_real u[4];

    row_reals(r, column, 4, u);
    if (fabsl(exact_of(u[0]) + exact_of(u[1]) + exact_of(u[2]) + exact_of(u[3]) - 1) > 0)
        row_complain(r, "column %s: not four coordinates of a tetrahedron", column);
    for (int k = 0; k < 4; k++)
        if (!(exact_of(u[k]) >= 0))
            row_complain(r, "column %s: outside the tetrahedron", column);
    r->largest = largest;
    return r->complaint[0]
               ? (loft_volume){ 0, 0, 0 }
               : (loft_volume){ loft_unit_from(u[1]), loft_unit_from(u[2]), loft_unit_from(u[3]) };
}

static void bernstein_tetra(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    answer *a = answer_new();
    loft_acc w[LOFT_TETRA_MAX];

    loft_volume_weights(n, row_volume(r, "u_q16"), w);
    for (unsigned k = 0; k < LOFT_TETRA_POINTS(n); k++)
        answer_wide(a, w[k]);
    r->largest = 1;
    row_expect(r, "basis", a, (law) { .lsb = 3 * n / 65536.0L, .gain = 1, .roundings = 8 * n });
}

/* Six times the volume. */
static wide det_of(loft_vec o, loft_vec a, loft_vec b, loft_vec c)
{
    const loft_vec *corner[3] = { &a, &b, &c };
    wide e[3][3];

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            e[k][i] = whole_of(corner[k]->axis[i]) - whole_of(o.axis[i]);
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
           e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

static void tetra_bary(row *r)
{
    loft_vec t[4], x;
    loft_acc u[4] = { 0 };
    answer *a = answer_new();

    row_points(r, "T_q16", 4, 3, t);
    row_points(r, "X_q16", 1, 3, &x);
    const enum loft_status status = loft_volume_from_point(t, x, u);
    if (r->inexact > 0) {
        const wide whole = det_of(t[0], t[1], t[2], t[3]);
        const wide part[4] = { det_of(x, t[1], t[2], t[3]), det_of(t[0], x, t[2], t[3]),
                               det_of(t[0], t[1], x, t[3]), det_of(t[0], t[1], t[2], x) };
        if ((status == LOFT_SINGULAR) != (whole == 0))
            row_complain(r, "degenerate is not what the rounded coordinates are");
        for (int k = 0; k < 4 && status == LOFT_OK; k++) {
            const long double want = (long double)part[k] / (long double)whole;
            row_within(r, "u", fabsl(exact_acc(u[k]) - want) * 65536, ulp_double(want) * 65536);
        }
        return;
    }
    row_expect_word(r, "status", status == LOFT_SINGULAR ? "degenerate" : "ok");
    if (status == LOFT_SINGULAR)
        return;
    answer_status(r, a, status);
    r->largest = 0;
    for (int k = 0; k < 4 && status == LOFT_OK; k++) {
        answer_acc(a, u[k]);
        r->largest = fmaxl(r->largest, fabsl(exact_acc(u[k])));
    }
    row_expect(r, "u", a, (law) { .lsb = 0.5L + 1 / 65536.0L, .roundings = 0.02L });
}

static unsigned row_tetra(row *r, loft_vec p[], loft_tetra *t)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);

    row_points(r, "net_q16", LOFT_TETRA_POINTS(n), 1, p);
    if (loft_tetra_init(t, p, n) != LOFT_OK)
        row_complain(r, "the net was refused");
    return n;
}

static void tetra_eval(row *r)
{
    loft_vec p[LOFT_TETRA_MAX];
    loft_tetra t;
    const unsigned n = row_tetra(r, p, &t);
    answer *a = answer_new();

    answer_vec(a, loft_tetra_eval(&t, row_volume(r, "u_q16")), 1);
    row_expect(r, "value", a,
               (law){ .lsb = 0.5L + n / 65536.0L, .gain = 1, .roundings = 6 * n + 1 });
}

static void tetra_elevate(row *r)
{
    static loft_vec out[LOFT_TETRA_POINTS(LOFT_DEGREE_MAX + 1)];
    loft_vec p[LOFT_TETRA_MAX];
    loft_tetra t;
    const unsigned n = row_tetra(r, p, &t);
    answer *a = answer_new();

    answer_status(r, a, loft_tetra_elevate(&t, 1, out));
    for (unsigned k = 0; k < LOFT_TETRA_POINTS(n + 1); k++)
        answer_vec(a, out[k], 1);
    row_expect(r, "out", a,
               (law){ .lsb = 0.5L + 1 / 131072.0L, .gain = 1, .roundings = n * n + 3 });
}

const vector_system vectors_tetra[] = {
    { "bernstein_tetra", "n,u_q16,basis", bernstein_tetra,
      "q16 3 n 2^-32; floats 8 n ulp of double" },
    { "tetra_bary", "T_q16,X_q16,status,u", tetra_bary,
      "q16 1/2 LSB + 2^-16 LSB; floats 1/2 ulp + 0.51 ulp of double; status exact" },
    { "tetra_eval", "n,net_q16,u_q16,value", tetra_eval,
      "q16 1/2 LSB + n 2^-16 LSB; floats 1/2 ulp + (6 n + 1) ulp of double" },
    { "tetra_elevate", "n,net_q16,out", tetra_elevate,
      "q16 1/2 LSB + 2^-17 LSB; floats 1/2 ulp + (n^2 + 3) ulp of double" },
    { 0 }
};

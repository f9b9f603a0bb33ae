/* tests/vectors/vectors_join.c -- readers of the systems that join curves
 * SPDX-License-Identifier: MIT
 *
 * Flags are those of the coordinates as the number type holds them: where a float rounded one,
 * those of the CSV do not count, and the flags, alpha and eta are decided again from what was read.
 */
#include "support/joins.h"          /* joins_flags */
#include "vectors/vectors.h"        /* row, row_expect */

#define HALF { .lsb = 0.5L + LSB, .roundings = 2 }

static bool same(const loft_join *a, const loft_join *b)
{
    return a->c0 == b->c0 && a->c1 == b->c1 && a->c2 == b->c2 && a->g0 == b->g0 && a->g1 == b->g1 &&
           a->g2 == b->g2 && a->regular == b->regular;
}

static void expect_rounded(row *r, const loft_join *j, const loft_vec p[], const loft_vec q[],
                           unsigned n)
{
    long double alpha, eta;
    const loft_join want = joins_flags(p, q, n, &alpha, &eta);

    if (!same(j, &want))
        row_complain(r, "a flag is not that of the rounded coordinates");
    row_within(r, "alpha", fabsl(exact_of(j->alpha) - alpha) * 65536, ulp(alpha) * 65536);
    row_within(r, "eta", fabsl(exact_of(j->eta) - eta) * 65536,
               ulp(fmaxl(fabsl(eta), alpha * alpha)) * 65536);
}

static void expect_number(row *r, const char *column, enum loft_status status, bool defined,
                          loft_real x)
{
    answer *a = answer_new();

    if (!defined) {
        if (!row_is(r, column, "-"))
            row_complain(r, "column %s should be undefined", column);
        return;
    }
    answer_status(r, a, status);
    answer_real(a, x);
    r->largest = fmaxl(r->largest, fabsl(exact_of(x)));
    row_expect(r, column, a, (law) HALF);
}

static void join_test(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), d = row_count(r, "d", LOFT_AXES);
    loft_vec p[LOFT_DEGREE_MAX + 1], q[LOFT_DEGREE_MAX + 1];
    loft_bezier b, c;
    loft_join j;

    row_points(r, "P_q16", n + 1, d, p);
    row_points(r, "Q_q16", n + 1, d, q);
    if (loft_bezier_init(&b, p, n) || loft_bezier_init(&c, q, n)) {
        row_complain(r, "not curves");
        return;
    }
    const enum loft_status status = loft_join_init(&j, &b, &c, 0);
    if (r->inexact > 0) {
        expect_rounded(r, &j, p, q, n);
        return;
    }
    row_expect_flag(r, "C0", j.c0);
    row_expect_flag(r, "C1", j.c1);
    row_expect_flag(r, "C2", j.c2);
    row_expect_flag(r, "G1", j.g1);
    row_expect_flag(r, "G2", j.g2);
    row_expect_flag(r, "regular", j.regular);
    expect_number(r, "alpha", status, j.g1, j.alpha);
    expect_number(r, "eta", status, j.g2, j.eta);
}

/* What reading rounded counts: each coordinate is multiplied by at most 1 + alpha + alpha^2 + |eta|
 * and as much. */
static void join_construct(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), d = row_count(r, "d", LOFT_AXES);
    loft_vec p[LOFT_DEGREE_MAX + 1], c[3];
    loft_bezier b;
    answer *a = answer_new();

    row_points(r, "P_q16", n + 1, d, p);
    const long double size = 2 * r->largest;
    const loft_real alpha = row_real(r, "alpha_q16"), eta = row_real(r, "eta_q16");
    const long double x = fabsl(exact_of(alpha)),
                      gain = 2 * (1 + x + x * x + fabsl(exact_of(eta))) + size * (2 + 2 * x);

    if (loft_bezier_init(&b, p, n)) {
        row_complain(r, "not a curve");
        return;
    }
    answer_status(r, a, loft_join_continue(&b, alpha, eta, c));
    for (int k = 0; k < 3 && !a->refused; k++)
        answer_vec(a, c[k], d);
    row_expect(r, "c", a, (law) { .lsb = 0.5L + LSB, .gain = gain, .roundings = 1 });
}

const vector_system vectors_join[] = {
    { "join_test", "n,d,P_q16,Q_q16,C0,C1,C2,G1,G2,regular,alpha,eta", join_test,
      "flags exact; alpha and eta q16: 1/2 LSB + 2^-16 LSB, floats: 1 ulp" },
    { "join_construct", "n,d,P_q16,alpha_q16,eta_q16,c", join_construct,
      "q16: 1/2 LSB + 2^-16 LSB, floats: 1 ulp and what reading rounded" },
    { 0 }
};

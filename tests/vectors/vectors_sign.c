/* tests/vectors/vectors_sign.c -- readers of the systems that decide on quadratic forms and
 * triangular nets
 * SPDX-License-Identifier: MIT
 *
 * Flags are those of the row. Where f32 cannot hold the row's numbers the row speaks of others, and
 * the answers are compared with the tests' own of the rounded ones (exact_form.h), which is done in
 * every row.
 */
#include "vectors/vectors.h"                /* row, answer, law */
#include "support/exact_form.h"             /* exact_copositive, exact_roots, exact_net_shape */
#include "basis/copositive.h"
#include "surface/triangle/triangle_shape.h"

#define NET_MAX 55                  /* degree 9 */

static bool as_given(const row *r)  { return !(r->inexact > 0); }

static void expect_flag(row *r, const char *column, bool got, bool own)
{
    if (as_given(r))
        row_expect_flag(r, column, got);
    if (got != own)
        row_complain(r, "column %s: %d, but the numbers as read make %d", column, got, own);
}

static void tri2_positivity(row *r)
{
    loft_real q[6];
    loft_triangle_sign s = { false, false, false, false };

    row_reals(r, "A_B_C_a_b_c_q16", 6, q);
    const loft_real net[6] = { q[0], q[5], q[4], q[1], q[3], q[2] };
    if (loft_triangle2_sign(net, &s) != LOFT_OK)
        row_complain(r, "refused");

    const wide d[3] = { whole_of(q[0]), whole_of(q[1]), whole_of(q[2]) },
               x[3] = { whole_of(q[3]), whole_of(q[4]), whole_of(q[5]) };
    wide m[4][4] = { { d[0], x[2], x[1] }, { x[2], d[1], x[0] }, { x[1], x[0], d[2] } };
    const int all[3] = { 0, 1, 2 };
    bool edges = true, diagonal = true;
    for (int i = 0; i < 3; i++) {
        wide pair[4][4] = { { d[i], x[(i + 2) % 3] }, { x[(i + 2) % 3], d[(i + 1) % 3] } };
        edges = edges && exact_copositive(pair, 2);
        diagonal = diagonal && d[i] >= 0;
    }
    expect_flag(r, "nonneg", s.nonnegative, exact_copositive(m, 3));
    expect_flag(r, "cond10", s.edges, edges);
    expect_flag(r, "IIa", s.roots, diagonal && exact_roots(d, x));
    expect_flag(r, "IIb", s.determinant, vast_sign(exact_minor(m, all, all, 3)) >= 0);
}

static void copositive(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_COPOSITIVE_MAX);
    loft_real q[10];
    wide m[4][4] = { { 0 } };
    bool flag = false;

    row_reals(r, "M_q16", n * (n + 1) / 2, q);
    for (unsigned i = 0, k = 0; i < n; i++)
        for (unsigned j = i; j < n; j++, k++)
            m[i][j] = m[j][i] = whole_of(q[k]);
    if (loft_matrix_copositive(q, n, &flag) != LOFT_OK)
        row_complain(r, "refused");
    expect_flag(r, "copositive", flag, exact_copositive(m, (int)n));
}

static void read_net(row *r, unsigned n, loft_real net[NET_MAX])
{
    loft_vec p[NET_MAX];

    row_points(r, "net_q16", (n + 1) * (n + 2) / 2, 1, p);
    for (unsigned k = 0; k < (n + 1) * (n + 2) / 2; k++)
        net[k] = p[k].axis[0];
}

static void wang_liu(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    loft_real net[NET_MAX], sums[3] = { 0 };
    bool flag = false, own = true;
    answer *a = answer_new();

    read_net(r, n, net);
    const enum loft_status status = loft_triangle_wang_liu(net, n, &flag, sums);
    answer_status(r, a, status);
    for (int corner = 0; corner < 3; corner++) {
        const unsigned place[3] = { 0, exact_place(n, 0), exact_place(0, n) };
        wide sum = whole_of(net[place[corner]]);
        for (unsigned rest = 0; rest <= n; rest++)
            for (unsigned k = 0; k <= rest; k++) {
                const unsigned at[3] = { n - rest, rest - k, k };
                const wide b = whole_of(net[exact_place(at[1], at[2])]);
                const double factor = at[corner] * tgamma(n) /
                                      (tgamma(at[0] + 1) * tgamma(at[1] + 1) * tgamma(at[2] + 1));
                sum += b < 0 ? (wide)(factor + 0.5) * b : 0;
            }
        own = own && sum >= 0;
        answer_real(a, sums[corner]);
        if (status == LOFT_OK)
            row_within(r, "L, as read", fabsl(exact_of(sums[corner]) * 65536 - (long double)sum),
                       ulp((long double)sum / 65536) * 65536);
    }
    expect_flag(r, "flag", flag, own);
    if (as_given(r)) {
        r->largest *= powl(3, n);
        row_expect(r, "L", a, (law) { .lsb = 0, .roundings = 1 });
    }
}

static void tri_convex(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    loft_real net[NET_MAX];
    loft_net_convexity c = { false, false, { false, false, false }, { 0, 0, 0 } };
    char words[24];

    read_net(r, n, net);
    if (loft_triangle_convex(net, n, &c) != LOFT_OK)
        row_complain(r, "refused");
    const exact_convexity_of_net own = exact_net_shape(net, (int)n);
    expect_flag(r, "netconvex", c.net, own.net);
    expect_flag(r, "weak", c.weak, own.weak);
    for (int x = 0; x < 3; x++)
        if (c.line[x] != own.line[x] || c.trend[x] != own.trend[x])
            row_complain(r, "lines of direction %d: %d %d, but the numbers as read make %d %d", x,
                         c.line[x], c.trend[x], own.line[x], own.trend[x]);
    if (!as_given(r))
        return;
    row_expect_word(r, "exact", n > 3 ? "-" : c.weak ? "1" : "0");
    snprintf(words, sizeof words, "%d %d %d", c.line[0], c.line[1], c.line[2]);
    row_expect_word(r, "lines", words);
    snprintf(words, sizeof words, "%d %d %d", c.trend[0], c.trend[1], c.trend[2]);
    row_expect_word(r, "mono", words);
}

const vector_system vectors_sign[] = {
    { "tri2_positivity", "A_B_C_a_b_c_q16,nonneg,cond10,IIa,IIb", tri2_positivity, "exact" },
    { "wang_liu", "n,net_q16,flag,L", wang_liu, "exact, sums in floats 1 ulp" },
    { "copositive", "n,M_q16,copositive", copositive, "exact" },
    { "tri_convex", "n,net_q16,netconvex,weak,exact,lines,mono", tri_convex, "exact" },
    { NULL, NULL, NULL, NULL }
};

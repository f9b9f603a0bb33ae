/* tests/vectors/vectors_triangle.c -- readers of the Bezier triangles
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"      /* sums, growth3, exact_point */
#include "vectors/vectors_bary.h"   /* row_bary, and row, answer, law */
#include "vectors/vectors_points.h" /* expect_vecs */
#include "curve/bezier.h"           /* LOFT_ELEVATE_MAX */
#include "surface/triangle/triangle.h"
#include "surface/triangle/triangle_join.h"
#include "surface/triangle/triangle_operator.h"
#include "surface/triangle/triangle_pieces.h"

#define MOST LOFT_TRIANGLE_MAX

typedef struct {
    unsigned n, d;
    loft_vec p[MOST];
    loft_triangle t;
} net;

/* Static: a triangle refers to its points. */
static net *row_net(row *r, const char *column, bool scalar)
{
    static net many[2];
    static unsigned turn;
    net *x = &many[turn++ % 2];

    x->n = row_count(r, "n", LOFT_DEGREE_MAX);
    x->d = scalar ? 1 : row_count(r, "d", LOFT_AXES);
    row_points(r, column, LOFT_TRIANGLE_POINTS(x->n), x->d, x->p);
    if (loft_triangle_init(&x->t, x->p, x->n) != LOFT_OK)
        row_complain(r, "the net was refused");
    return x;
}

static law point_law(unsigned rows, long double growth)
{
    return (law){ .lsb = 0.5L + sums(growth, rows) / 131072,
                  .gain = powl(growth, rows),
                  .roundings = 3 * rows + 1 };
}

static void tri_eval(row *r)
{
    const net *x = row_net(r, "net_q16", false);
    const loft_bary u = row_bary(r, "u_q16", false);
    loft_vec p = { { 0 } }, three[3];

    const enum loft_status status = loft_triangle_extrapolate(&x->t, u, &p);
    if (loft_bary_inside(u) &&
        (status != LOFT_OK || !loft_vec_equal(p, loft_triangle_eval(&x->t, u))))
        row_complain(r, "inside the triangle eval and extend differ");
    expect_vecs(r, "point", status, &p, 1, x->d, point_law(x->n, growth3(u)));
    if (x->n > 0)
        expect_vecs(r, "tangent3", loft_triangle_tangent(&x->t, u, three), three, 3, x->d,
                    point_law(x->n - 1, growth3(u)));
}

static void tri_dderiv(row *r)
{
    const net *x = row_net(r, "net_q16", false);
    const loft_bary z = row_bary(r, "z_q16", true), u = row_bary(r, "u_q16", false);
    const unsigned k = row_count(r, "r", 99), m = k < x->n ? x->n - k : 0;
    const long double l = growth3(u), reach = fmaxl(1, reach3(z));
    long double f = 1;
    loft_vec d = { { 0 } };

    for (unsigned j = 0; j < k && j < x->n; j++)
        f *= x->n - j;
    const law own = {
        .lsb = 0.5L + f * (sums(reach, k < x->n ? k : x->n) * powl(l, m) + sums(l, m)) / 131072,
        .gain = f * powl(reach, k < x->n ? k : x->n) * powl(l, m),
        .roundings = 3 * x->n + 3
    };
    const enum loft_status status = loft_triangle_deriv(&x->t, k, z, u, &d);
    expect_vecs(r, "D", status, &d, 1, x->d, own);
}

static void tri_elevate(row *r)
{
    const net *x = row_net(r, "net_q16", false);
    const unsigned times = row_count(r, "m", LOFT_ELEVATE_MAX - x->n);
    static loft_vec out[LOFT_TRIANGLE_POINTS(LOFT_ELEVATE_MAX)];

    expect_vecs(r, "out", loft_triangle_elevate(&x->t, times, out), out,
                LOFT_TRIANGLE_POINTS(x->n + times), x->d,
                (law){ .lsb = 0.5L + 1 / 131072.0L, .gain = 1, .roundings = x->n + 3 });
}

static void tri_split_point(row *r)
{
    const net *x = row_net(r, "net_q16", true);
    const loft_bary u = row_bary(r, "u_q16", false);
    const unsigned count = LOFT_TRIANGLE_POINTS(x->n);
    const law own = point_law(x->n, growth3(u));
    loft_vec part[3][MOST];

    const enum loft_status status = loft_triangle_split(&x->t, u, part[0], part[1], part[2]);
    expect_vecs(r, "A", status, part[0], count, 1, own);
    expect_vecs(r, "B", status, part[1], count, 1, own);
    expect_vecs(r, "C", status, part[2], count, 1, own);
}

static void tri_split4(row *r)
{
    static const char *const column[4] = { "S0", "S1", "S2", "S3" };
    const net *x = row_net(r, "net_q16", true);
    loft_vec out[MOST];

    for (unsigned k = 0; k < 4; k++)
        expect_vecs(r, column[k], loft_triangle_quarter(&x->t, k, out), out,
                    LOFT_TRIANGLE_POINTS(x->n), 1,
                    (law){ .lsb = 0.5L, .gain = 1, .roundings = x->n });
}

static void tri_reparam(row *r)
{
    const net *x = row_net(r, "net_q16", true);
    loft_bary v[3] = { { 0, 0 }, { 0, 0 }, { 0, 0 } };
    loft_vec out[MOST];

    row_barys(r, "V_q16", 3, false, v);
    expect_vecs(r, "out", loft_triangle_sub(&x->t, v, out), out, LOFT_TRIANGLE_POINTS(x->n), 1,
                point_law(x->n, fmaxl(growth3(v[0]), fmaxl(growth3(v[1]), growth3(v[2])))));
}

static void tri_line(row *r)
{
    const net *x = row_net(r, "net_q16", true);
    const loft_bary a = row_bary(r, "A_q16", false), b = row_bary(r, "B_q16", false);
    loft_vec out[LOFT_DEGREE_MAX + 1];

    expect_vecs(r, "curve", loft_triangle_line(&x->t, a, b, out), out, x->n + 1, 1,
                point_law(x->n, fmaxl(growth3(a), growth3(b))));
}

static void tri_polar(row *r)
{
    const net *x = row_net(r, "net_q16", true);
    const loft_bary a = row_bary(r, "R_q16", false), u = row_bary(r, "u_q16", false);
    loft_vec v = { { 0 } };

    const enum loft_status status = loft_triangle_polar(&x->t, row_count(r, "l", x->n), a, u, &v);
    expect_vecs(r, "value", status, &v, 1, 1, point_law(x->n, fmaxl(growth3(a), growth3(u))));
}

/* The file's x and y are its shares of T1 and T2: they are those of T2 and T3 when the corners move
 * on by one. */
static void tri_power(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), count = LOFT_TRIANGLE_POINTS(n);
    loft_real a[MOST];
    loft_vec c[MOST], moved[MOST], out[MOST];

    row_reals(r, "a_q16", count, a);
    for (unsigned k = 0; k < count; k++)
        c[k] = (loft_vec) { { a[k] } };
    const enum loft_status status = loft_triangle_from_power(c, n, moved);
    for (unsigned m = 0; m <= n && status == LOFT_OK; m++)
        for (unsigned k = 0; k <= m; k++)
            out[loft_triangle_place(m - k, k)] = moved[loft_triangle_place(n - m, m - k)];
    expect_vecs(r, "net", status, out, count, 1,
                (law){ .lsb = 0.5L + n * n / 131072.0L,
                       .gain = (n + 2) * (n + 2) / 4,
                       .roundings = 4 * n + 4 });
}

static void tri_continuation(row *r)
{
    const net *x = row_net(r, "net_q16", true);
    const loft_bary star = row_bary(r, "Tstar_q16", false);
    const unsigned order = row_count(r, "r", x->n);
    loft_vec out[MOST];

    expect_vecs(r, "c", loft_triangle_join_continue(&x->t, star, order, out), out,
                LOFT_TRIANGLE_ROWS(x->n, order), 1,
                (law){ .lsb = 0.5L + LSB, .gain = powl(growth3(star), order), .roundings = 1 });
}

/* Where a float rounded a coefficient, the order is that of the rounded ones. */
static void tri_join_test(row *r)
{
    const net *b = row_net(r, "b_q16", true), *c = row_net(r, "c_q16", true);
    const loft_bary star = row_bary(r, "Tstar_q16", false);
    char word[12];
    int order = -2;

    if (loft_triangle_join_order(&b->t, &c->t, star, &order) != LOFT_OK)
        row_complain(r, "the join was refused");
    snprintf(word, sizeof word, "%d", order);
    if (r->inexact > 0) {
        if (order != order_of(b->p, c->p, b->n, star))
            row_complain(r, "the order is not that of the rounded coordinates");
    } else {
        row_expect_word(r, "r", word);
    }
}

static void tri_bernstein_iter(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), times = row_count(r, "k", 1 << 20);
    const loft_bary u = row_bary(r, "u_q16", false);
    const long double s = n > 1 ? n * n * n * n / (3.0L * n - 3) : 0, l = growth3(u),
                      power = powl(l, n);
    answer *value = answer_new(), *limit = answer_new();
    loft_vec p[MOST];
    loft_real f[MOST], x = 0, y = 0, z = 0;

    row_points(r, "f_q16", LOFT_TRIANGLE_POINTS(n), 1, p);
    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(n); k++)
        f[k] = p[k].axis[0];
    answer_status(r, value,
                  times ? loft_triangle_iterate_extrapolate(f, n, times, u, &x) : LOFT_ERR_ARG);
    answer_real(value, x);
    row_expect(r, "value", value,
               (law){ .lsb = 0.5L + (n + s) * power / 131072,
                      .gain = power,
                      .roundings = 4 * (n + s) * power });
    answer_status(r, limit, loft_triangle_iterate_extrapolate(f, n, LOFT_FOREVER, u, &y));
    answer_real(limit, y);
    row_expect(r, "lim", limit,
               (law){ .lsb = 0.5L + l / 131072.0L, .gain = l, .roundings = 4 * l });
    if (loft_bary_inside(u) && times &&
        (loft_triangle_iterate(f, n, times, u, &z) != LOFT_OK || z < x || z > x))
        row_complain(r, "inside the triangle iterate and its extrapolation differ");
}

static void bernstein_tri(row *r)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    answer *a = answer_new();
    loft_acc w[MOST];

    loft_bary_weights(n, row_bary(r, "u_q16", false), w);
    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(n); k++)
        answer_wide(a, w[k]);
    r->largest = 1;
    row_expect(r, "basis", a, (law) { .lsb = n / 32768.0L, .gain = 1, .roundings = 6 * n });
}


/* Coordinates in a triangle */

/* Wide coordinates, each against the exact ones: of the CSV, or where a float rounded the input, of
 * what was read. */
static void expect_ratios(row *r, const char *column, enum loft_status status, const loft_acc x[],
                          unsigned count, const long double exact[])
{
    answer *a = answer_new();

    if (status == LOFT_SINGULAR)
        return;
    if (r->inexact > 0) {
        for (unsigned k = 0; k < count && status == LOFT_OK; k++)
            row_within(r, column, fabsl(exact_acc(x[k]) - exact[k]) * 65536,
                       BY_NUM(0, 1, 1) * ulp_double(exact[k]) * 65536);
        return;
    }
    answer_status(r, a, status);
    r->largest = 0;
    for (unsigned k = 0; k < count && status == LOFT_OK; k++) {
        answer_acc(a, x[k]);
        r->largest = fmaxl(r->largest, fabsl(exact[k]));
    }
    row_expect(r, column, a, (law) { .lsb = 0.5L + 1 / 65536.0L, .roundings = 0.02L });
}

static void expect_status(row *r, enum loft_status status, wide whole)
{
    if (r->inexact > 0) {
        if ((status == LOFT_SINGULAR) != (whole == 0))
            row_complain(r, "degenerate is not what the rounded coordinates are");
    } else {
        row_expect_word(r, "status", status == LOFT_SINGULAR ? "degenerate" : "ok");
    }
}

static void barycentric(row *r)
{
    loft_vec corner[3], x;
    loft_acc u[3] = { 0 };
    loft_real area = 0;
    long double exact[3];
    answer *a = answer_new();

    row_points(r, "T_q16", 3, 2, corner);
    row_points(r, "X_q16", 1, 2, &x);
    const wide whole = exact_point(corner, x, exact);
    const enum loft_status status = loft_bary_from_point(corner, x, u);
    expect_status(r, status, whole);
    const enum loft_status area_status = loft_bary_area(corner, &area);
    if (r->inexact > 0) {
        const long double want = (long double)whole / 8589934592.0L;
        row_within(r, "area", fabsl(exact_of(area) - want) * 65536, ulp(want) * 65536);
    } else {
        answer_status(r, a, area_status);
        answer_real(a, area);
        r->largest = fabsl((long double)whole / 8589934592.0L);
        row_expect(r, "area", a, (law) { .lsb = 0.5L + 1 / 65536.0L, .roundings = 0.02L });
    }
    expect_ratios(r, "u", status, u, 3, exact);
}

static void bary_vector(row *r)
{
    loft_vec corner[3], z;
    loft_acc u[3] = { 0 };
    long double exact[3];

    row_points(r, "T_q16", 3, 2, corner);
    row_points(r, "z_q16", 1, 2, &z);
    const wide whole = exact_vector(corner, z, exact);
    const enum loft_status status = loft_bary_from_vector(corner, z, u);
    expect_status(r, status, whole);
    expect_ratios(r, "zs", status, u, 3, exact);
}

static void bary_change(row *r)
{
    loft_bary q[3] = { { 0, 0 }, { 0, 0 }, { 0, 0 } };
    loft_acc u[3] = { 0 };
    answer *a = answer_new();

    row_barys(r, "Q_q16", 3, false, q);
    const loft_bary v = row_bary(r, "v_q16", false);
    answer_status(r, a, loft_bary_change(q, v, u));
    for (unsigned k = 0; k < 3; k++)
        answer_acc(a, u[k]);
    r->largest = fmaxl(growth3(q[0]), fmaxl(growth3(q[1]), growth3(q[2])));
    row_expect(r, "u", a, (law) { .lsb = 0.5L + 2 / 65536.0L, .gain = growth3(v), .roundings = 8 });
}

const vector_system vectors_triangle[] = {
    { "barycentric", "T_q16,X_q16,area,status,u", barycentric,
      "q16 1/2 LSB + 2^-16 LSB; floats 1/2 ulp + 0.51 ulp of double; status exact" },
    { "bary_vector", "T_q16,z_q16,status,zs", bary_vector,
      "q16 1/2 LSB + 2^-16 LSB; floats 1/2 ulp + 0.51 ulp of double; status exact" },
    { "bary_change", "Q_q16,v_q16,u", bary_change,
      "q16 1/2 LSB + 2^-15 LSB; floats 1/2 ulp + 8 L ulp of double" },
    { "bernstein_tri", "n,u_q16,basis", bernstein_tri, "q16 n 2^-31; floats 6 n ulp of double" },
    { "tri_eval", "n,d,net_q16,u_q16,point,tangent3", tri_eval,
      "q16 1/2 LSB + n 2^-17 LSB; floats 1/2 ulp + (3 n + 1) ulp of double" },
    { "tri_dderiv", "n,d,net_q16,z_q16,r,u_q16,D", tri_dderiv,
      "q16 1/2 LSB + f (1 + Z + .. + n - r) 2^-17 LSB; floats 1/2 ulp + 3 (n + 1) f Z^r ulp of "
      "double" },
    { "tri_elevate", "n,d,m,net_q16,out", tri_elevate,
      "q16 1/2 LSB + 2^-17 LSB; floats 1/2 ulp + (n + 3) ulp of double" },
    { "tri_split_point", "n,net_q16,u_q16,A,B,C", tri_split_point,
      "q16 1/2 LSB + n 2^-17 LSB; floats 1/2 ulp + (3 n + 1) ulp of double" },
    { "tri_split4", "n,net_q16,S0,S1,S2,S3", tri_split4,
      "q16 1/2 LSB; floats 1/2 ulp + n ulp of double" },
    { "tri_reparam", "n,net_q16,V_q16,out", tri_reparam,
      "q16 1/2 LSB + n 2^-17 LSB; floats 1/2 ulp + (3 n + 1) ulp of double" },
    { "tri_line", "n,net_q16,A_q16,B_q16,curve", tri_line,
      "q16 1/2 LSB + n 2^-17 LSB; floats 1/2 ulp + (3 n + 1) ulp of double" },
    { "tri_polar", "n,net_q16,l,R_q16,u_q16,value", tri_polar,
      "q16 1/2 LSB + n 2^-17 LSB; floats 1/2 ulp + (3 n + 1) ulp of double" },
    { "tri_power", "n,a_q16,net", tri_power,
      "q16 1/2 LSB + n^2 2^-17 LSB; floats 1/2 ulp + (n + 1)^2 (n + 2) ulp of double" },
    { "tri_continuation", "n,net_q16,Tstar_q16,r,c", tri_continuation,
      "q16 1/2 LSB + 2^-16 LSB; floats 1 ulp and what reading rounded" },
    { "tri_join_test", "n,b_q16,Tstar_q16,c_q16,r", tri_join_test, "exact" },
    { "tri_bernstein_iter", "n,f_q16,k,u_q16,value,lim", tri_bernstein_iter,
      "q16 1/2 LSB + (n + s) 2^-17 LSB, s = n^4 / (3 n - 3); floats 1/2 ulp + 4 (n + s) ulp of "
      "double" },
    { 0 }
};

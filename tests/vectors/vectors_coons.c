/* tests/vectors/vectors_coons.c -- readers of the systems with patches between curves, planes and
 * spheres
 * SPDX-License-Identifier: MIT
 *
 * Where f32 cannot hold a row's numbers, flags and distances are compared with the tests' own of
 * the rounded ones.
 */
#include "vectors/vectors.h"                /* row, answer, law */
#include "support/exact_whole.h"            /* wide, whole_of */
#include "surface/tensor/bicubic.h"
#include "surface/tensor/coons.h"
#include "surface/plane.h"
#include "surface/sphere.h"

static bool as_given(const row *r)  { return !(r->inexact > 0); }


/* Coons */

static void expect_point(row *r, const char *column, enum loft_status status, loft_vec p,
                         unsigned d, law l)
{
    answer *a = answer_new();

    answer_status(r, a, status);
    if (status == LOFT_OK)
        answer_vec(a, p, d);
    row_expect(r, column, a, l);
}

static loft_bezier curve_of(row *r, const char *column, unsigned d, loft_vec p[LOFT_DEGREE_MAX + 1])
{
    const unsigned count = row_length(r, column, LOFT_DEGREE_MAX + 1);
    loft_real x[LOFT_DEGREE_MAX + 1];
    loft_bezier b = { p, 0 };

    if (d > 1) {
        row_points(r, column, count, d, p);
    } else {
        row_reals(r, column, count, x);
        for (unsigned k = 0; k < count; k++)
            p[k] = (loft_vec) { { x[k] } };
    }
    if (count == 0 || loft_bezier_init(&b, p, count - 1) != LOFT_OK)
        row_complain(r, "column %s: no curve", column);
    return b;
}

static void coons_bilinear(row *r)
{
    static const char *const names[4] = { "u0_q16", "u1_q16", "v0_q16", "v1_q16" };
    loft_vec p[4][LOFT_DEGREE_MAX + 1], of_bezier = { { 0 } }, of_sides = { { 0 } };
    loft_bezier b[4];
    loft_coons c;
    loft_coons_bezier cb;

    for (int k = 0; k < 4; k++)
        b[k] = curve_of(r, names[k], 3, p[k]);
    const loft_side sides[4] = { loft_side_from_bezier(&b[0]), loft_side_from_bezier(&b[1]),
                                 loft_side_from_bezier(&b[2]), loft_side_from_bezier(&b[3]) };
    const loft_bezier u[1][2] = { { b[0], b[1] } }, v[1][2] = { { b[2], b[3] } };
    const loft_unit s = row_unit(r, "u_q16"), t = row_unit(r, "v_q16");
    if (loft_coons_init(&c, sides, sides + 2, 0) || loft_coons_bezier_init(&cb, u, v, 1, 0)) {
        row_complain(r, "no patch");
        return;
    }
    const law l = { .lsb = 0.5L + 10 / 131072.0L, .gain = 3, .roundings = 52 };
    expect_point(r, "S", loft_coons_eval(&c, s, t, &of_sides), of_sides, 3, l);
    expect_point(r, "S", loft_coons_bezier_eval(&cb, s, t, &of_bezier), of_bezier, 3, l);
}

static void coons_of(row *r, const char *const names[], unsigned orders, const char *column)
{
    loft_vec p[2 * 2 * LOFT_COONS_ORDERS][LOFT_DEGREE_MAX + 1], out = { { 0 } };
    loft_bezier u[LOFT_COONS_ORDERS][2], v[LOFT_COONS_ORDERS][2];
    loft_coons_bezier c;
    unsigned n = 0;

    for (unsigned k = 0; k < 2 * orders; k++) {
        u[k / 2][k % 2] = curve_of(r, names[k], 1, p[k]);
        v[k / 2][k % 2] = curve_of(r, names[2 * orders + k], 1, p[2 * orders + k]);
        n = u[k / 2][k % 2].degree > n ? u[k / 2][k % 2].degree : n;
        n = v[k / 2][k % 2].degree > n ? v[k / 2][k % 2].degree : n;
    }
    const loft_unit s = row_unit(r, "u_q16"), t = row_unit(r, "v_q16");
    if (loft_coons_bezier_init(&c, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v, orders,
                               0)) {
        row_complain(r, "no patch");
        return;
    }
    if (as_given(r) && !loft_coons_bezier_meets(&c, BY_NUM(0, 0, LOFT_REAL(1e-8))) &&
        BY_NUM(true, false, true))
        row_complain(r, "the curves do not agree");
    expect_point(r, column, loft_coons_bezier_eval(&c, s, t, &out), out, 1,
                 (law){ .lsb = 0.5L + (3 * n + 20) / 131072.0L,
                        .gain = 4 + n + n * n / 5.0L,
                        .roundings = 64.0L * (n + 1) * (n + 1) / (4 + n + n * n / 5.0L) });
}

static void coons_slope(row *r)
{
    static const char *const names[8] = { "u0_q16", "u1_q16", "su0_q16", "su1_q16",
                                          "v0_q16", "v1_q16", "sv0_q16", "sv1_q16" };
    coons_of(r, names, 2, "T");
}

static void coons_curv(row *r)
{
    static const char *const names[12] = { "u0_q16",  "u1_q16",  "su0_q16", "su1_q16",
                                           "ku0_q16", "ku1_q16", "v0_q16",  "v1_q16",
                                           "sv0_q16", "sv1_q16", "kv0_q16", "kv1_q16" };
    coons_of(r, names, 3, "K");
}

static void read_bicubic(row *r, const char *column, loft_bicubic *b)
{
    loft_vec p[16];

    row_points(r, column, 16, 2, p);
    for (int k = 0; k < 16; k++)
        b->at[k / 4][k % 4] = p[k];
}

static void coons_bicubic(row *r)
{
    static const struct {
        const char *column;
        unsigned j, k;
        double gain, roundings;
    } derivatives[] = { { "C", 0, 0, 1.6, 35 },
                        { "Cu", 1, 0, 6.5, 380 },
                        { "Cv", 0, 1, 6.5, 380 },
                        { "Cuv", 1, 1, 25, 100 } };
    loft_bicubic b;

    read_bicubic(r, "M_q16", &b);
    const loft_unit u = row_unit(r, "u_q16"), v = row_unit(r, "v_q16");
    for (int i = 0; i < 4; i++) {
        loft_vec p = { { 0 } };
        const enum loft_status status = loft_bicubic_deriv(&b, derivatives[i].j, derivatives[i].k,
                                                           u, v, &p);
        expect_point(r, derivatives[i].column, status, p, 2,
                     (law){ .lsb = 0.5L + 160 / 131072.0L,
                            .gain = derivatives[i].gain,
                            .roundings = derivatives[i].roundings });
    }
}

static bool columns_meet(const loft_bicubic *c, int of_c, const loft_bicubic *a, int of_a)
{
    bool same = true;

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            same = same && whole_of(c->at[k][of_c].axis[i]) == whole_of(a->at[k][of_a].axis[i]);
    return same;
}

static void bicubic_join(row *r)
{
    loft_bicubic c, a;
    loft_bicubic_join j;
    answer *lambda = answer_new();
    wide x[8], y[8];
    int m = 0;

    read_bicubic(r, "C_q16", &c);
    read_bicubic(r, "A_q16", &a);
    const enum loft_status status = loft_bicubic_join_init(&j, &c, &a);
    for (int k = 0; k < 8; k++) {
        x[k] = whole_of(c.at[k / 2][3].axis[k % 2]);
        y[k] = whole_of(a.at[k / 2][2].axis[k % 2]);
        m = (x[k] < 0 ? -x[k] : x[k]) > (x[m] < 0 ? -x[m] : x[m]) ? k : m;
    }
    const bool c0 = columns_meet(&c, 1, &a, 0), c1 = c0 && columns_meet(&c, 3, &a, 2);
    bool g1 = c0 && x[m] != 0 && x[m] * y[m] > 0;
    for (int k = 0; k < 8; k++)
        g1 = g1 && x[k] * y[m] == y[k] * x[m];
    if (j.c0 != c0 || j.c1 != c1 || j.g1 != g1)
        row_complain(r, "%d %d %d, but the numbers as read make %d %d %d", j.c0, j.c1, j.g1, c0, c1,
                     g1);
    if (g1 && status == LOFT_OK) {
        const long double want = (long double)y[m] / (long double)x[m];
        row_within(r, "lam, as read", fabsl(exact_of(j.lambda) - want) * 65536, ulp(want) * 65536);
    }
    if (!as_given(r))
        return;
    row_expect_flag(r, "C0", j.c0);
    row_expect_flag(r, "C1", j.c1);
    row_expect_flag(r, "G1", j.g1);
    if (!j.g1) {
        row_expect_word(r, "lam", "-");
        return;
    }
    answer_status(r, lambda, status);
    answer_real(lambda, j.lambda);
    r->largest = fabsl(exact_of(j.lambda));
    row_expect(r, "lam", lambda, (law) { .lsb = 0.5L + LSB, .roundings = 2 });
}


/* Lines, planes, spheres */

/* Numbers of an equation, and the test's own as whole numbers times 2^-16 for each factor. */
static void expect_numbers(row *r, const char *column, enum loft_status status, const loft_real x[],
                           int count, const wide own[], const int factors[])
{
    answer *a = answer_new();

    answer_status(r, a, status);
    for (int k = 0; k < count && status == LOFT_OK; k++) {
        const long double want = ldexpl((long double)own[k], -16 * factors[k]);
        answer_real(a, x[k]);
        row_within(r, column, fabsl(exact_of(x[k]) - want) * 65536, ulp(want) * 65536);
        r->largest = fmaxl(r->largest, fabsl(want));
    }
    if (as_given(r))
        row_expect(r, column, a, (law) { .lsb = 0.5L + LSB, .roundings = 2 });
}

static void expect_distance(row *r, enum loft_status status, loft_real d, wide value,
                            const wide normal[3])
{
    long double square = 0;
    answer *a = answer_new();

    for (int i = 0; i < 3; i++)
        square += (long double)normal[i] * (long double)normal[i];
    if ((square > 0) != (status != LOFT_SINGULAR))
        row_complain(r, "status %d, but not of the numbers as read", status);
    if (as_given(r))
        row_expect_word(r, "status", status == LOFT_SINGULAR ? "degenerate" : "ok");
    if (status == LOFT_SINGULAR && as_given(r))
        row_expect_word(r, "dist", "-");
    if (status == LOFT_SINGULAR)
        return;
    const long double want = (long double)value / sqrtl(square) / 65536;
    answer_status(r, a, status);
    answer_real(a, d);
    if (status == LOFT_OK)
        row_within(r, "dist, as read", fabsl(exact_of(d) - want) * 65536,
                   (ulp(want) + fabsl(want) * 0x1p-60L) * 65536);
    r->largest = fabsl(want);
    if (as_given(r))
        row_expect(r, "dist", a, (law) { .lsb = 0.5L + LSB, .roundings = 2 });
}

static void expect_unit_normal(row *r, enum loft_status status, loft_vec n, const wide normal[3])
{
    const long double x = (long double)normal[0], y = (long double)normal[1],
                      z = (long double)normal[2], length = sqrtl(x * x + y * y + z * z);
    const long double want[3] = { x / length, y / length, z / length };

    for (int i = 0; i < 3 && status == LOFT_OK; i++)
        row_within(r, "normal, as read", fabsl(exact_of(n.axis[i]) - want[i]) * 65536,
                   (ulp(want[i]) + 0x1p-60L) * 65536);
    if (status != LOFT_OK && status != LOFT_SINGULAR)
        row_complain(r, "the normal was refused");
}

static void plane(row *r)
{
    static const int factors[4] = { 2, 2, 2, 3 }, three = 3;
    loft_facet f;
    loft_vec x, normal = { { 0 } };
    loft_real numbers[4] = { 0 }, value = 0, distance = 0;
    wide e[2][3], n[4], of_x = 0;

    row_points(r, "p_q16", 3, 3, f.p);
    row_points(r, "X_q16", 1, 3, &x);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            e[k][i] = whole_of(f.p[k + 1].axis[i]) - whole_of(f.p[0].axis[i]);
    n[3] = 0;
    for (int i = 0; i < 3; i++) {
        n[i] = e[0][(i + 1) % 3] * e[1][(i + 2) % 3] - e[0][(i + 2) % 3] * e[1][(i + 1) % 3];
        n[3] -= n[i] * whole_of(f.p[0].axis[i]);
        of_x += n[i] * (whole_of(x.axis[i]) - whole_of(f.p[0].axis[i]));
    }
    expect_numbers(r, "coef", loft_facet_equation(&f, numbers), numbers, 4, n, factors);
    enum loft_status status = loft_facet_value(&f, x, &value);
    expect_numbers(r, "value", status, &value, 1, &of_x, &three);
    status = loft_facet_distance(&f, x, &distance);
    expect_distance(r, status, distance, of_x, n);
    status = loft_facet_normal(&f, &normal);
    expect_unit_normal(r, status, normal, n);
}

static void line(row *r)
{
    static const int factors[3] = { 1, 1, 2 }, two = 2;
    loft_line l;
    loft_vec x, normal = { { 0 } };
    loft_real numbers[3] = { 0 }, value = 0, distance = 0;

    row_points(r, "p_q16", 2, 2, l.p);
    row_points(r, "X_q16", 1, 2, &x);
    const wide x0 = whole_of(l.p[0].axis[0]), y0 = whole_of(l.p[0].axis[1]);
    const wide n[3] = { y0 - whole_of(l.p[1].axis[1]), whole_of(l.p[1].axis[0]) - x0, 0 };
    const wide of_x = n[0] * (whole_of(x.axis[0]) - x0) + n[1] * (whole_of(x.axis[1]) - y0),
               own[3] = { n[0], n[1], -n[0] * x0 - n[1] * y0 };

    expect_numbers(r, "coef", loft_line_equation(&l, numbers), numbers, 3, own, factors);
    enum loft_status status = loft_line_value(&l, x, &value);
    expect_numbers(r, "value", status, &value, 1, &of_x, &two);
    status = loft_line_distance(&l, x, &distance);
    expect_distance(r, status, distance, of_x, n);
    status = loft_line_normal(&l, &normal);
    expect_unit_normal(r, status, normal, n);
}

static void line_plane(row *r)
{
    if (row_is(r, "kind", "plane"))
        plane(r);
    else
        line(r);
}

static void sphere_param(row *r)
{
    loft_sphere s = { { { 0 } }, 0 };
    loft_vec p = { { 0 } }, n = { { 0 } };
    const long double degree = 0.01745329251994329577L;

    const loft_real theta = row_real(r, "theta_deg_q16"), phi = row_real(r, "phi_deg_q16");
    r->largest = 0;
    s.radius = row_real(r, "r_q16");
    enum loft_status status = loft_sphere_eval(&s, theta, phi, &p);
    expect_point(r, "p", status, p, 3,
                 (law){ .lsb = 0.5L + 0x1p-14L,
                        .gain = 1 + 2 * degree * exact_of(s.radius),
                        .roundings = 16 });
    r->largest = 1;
    status = loft_sphere_normal(&s, theta, phi, &n);
    expect_point(r, "normal", status, n, 3,
                 (law){ .lsb = 0.5L + 0x1p-14L, .gain = 1, .roundings = 16 });
}

const vector_system vectors_coons[] = {
    { "coons_bilinear", "u0_q16,u1_q16,v0_q16,v1_q16,u_q16,v_q16,S", coons_bilinear,
      "1/2 LSB + 10 * 2^-17 LSB" },
    { "coons_slope", "u0_q16,u1_q16,su0_q16,su1_q16,v0_q16,v1_q16,sv0_q16,sv1_q16,u_q16,v_q16,T",
      coons_slope, "1/2 LSB + (3 n + 20) * 2^-17 LSB" },
    { "coons_curv",
      "u0_q16,u1_q16,su0_q16,su1_q16,ku0_q16,ku1_q16,v0_q16,v1_q16,sv0_q16,sv1_q16,kv0_q16,kv1_q16,"
      "u_q16,v_q16,K",
      coons_curv, "1/2 LSB + (3 n + 20) * 2^-17 LSB" },
    { "coons_bicubic", "M_q16,u_q16,v_q16,C,Cu,Cv,Cuv", coons_bicubic,
      "1/2 LSB + 160 * 2^-17 LSB" },
    { "bicubic_join", "C_q16,A_q16,C0,C1,G1,lam", bicubic_join,
      "flags exact; lambda 1/2 LSB + 2^-16 LSB" },
    { "line_plane", "kind,p_q16,X_q16,coef,value,status,dist", line_plane,
      "1/2 LSB + 2^-16 LSB, floats 1 ulp" },
    { "sphere_param", "r_q16,theta_deg_q16,phi_deg_q16,p,normal", sphere_param,
      "1/2 LSB + 2^-14 LSB" },
    { NULL, NULL, NULL, NULL }
};

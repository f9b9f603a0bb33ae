/* tests/vectors/vectors_decide.c -- readers of large degrees, exact decisions, conics, lower
 * degrees, integrals, and derivatives of Zheng-Ball patches
 * SPDX-License-Identifier: MIT
 *
 * Decisions are those of the numbers as read: where f32 cannot hold a row's numbers, nothing is
 * compared.
 */
#include "vectors/vectors_points.h"         /* expect_vec, as_given; row, answer, law */
#include "basis/bernstein_operator.h"
#include "basis/copositive.h"
#include "basis/integral.h"
#include "basis/positivity.h"
#include "curve/conic.h"
#include "curve/enclosed.h"
#include "curve/reduce.h"
#include "polygon/zheng_ball.h"
#include "surface/barycentric.h"
#include "surface/volume.h"
#include "surface/triangle/triangle_integral.h"

#define MOST (LOFT_DEGREE_MAX + 1)

static void expect_acc(row *r, const char *column, enum loft_status status, const loft_acc x[],
                       unsigned count, law l)
{
    answer *a = answer_new();

    answer_status(r, a, status);
    for (unsigned k = 0; k < count && status == LOFT_OK; k++)
        answer_acc(a, x[k]);
    row_expect(r, column, a, l);
}

/* A law whose bound in floats is not a number of ulp of the largest coordinate; call at_one before
 * and after. */
static law law_of(long double lsb, long double error)
{
    return (law) { .lsb = lsb, .roundings = 2 + error / 0x1p-52L };
}

static void expect_acc_within(row *r, const char *column, enum loft_status status,
                              const loft_acc x[], unsigned count, long double lsb,
                              long double error)
{
    const long double largest = r->largest;

    r->largest = 1;
    expect_acc(r, column, status, x, count, law_of(lsb, error));
    r->largest = largest;
}


/* Large degrees */

static void bernstein_op64(row *r)
{
    loft_real f[LOFT_OPERATOR_MAX + 1], y[2] = { 0 };
    const unsigned n = row_count(r, "n", LOFT_OPERATOR_MAX);
    const loft_unit x = row_unit(r, "x_q16");
    static const char *const column[2] = { "value", "deriv" };

    row_reals(r, "f_q16", n + 1, f);
    const enum loft_status status = loft_bernstein_operator(f, n, x, &y[0], &y[1]);
    for (unsigned k = 0; k < 2; k++) {
        answer *a = answer_new();
        answer_status(r, a, status);
        answer_real(a, y[k]);
        row_expect(r, column[k], a,
                   (law){ .lsb = k ? 0.5L + n * n / 131072.0L : 0.5L + n / 131072.0L,
                          .gain = k ? 2 * n : 1,
                          .roundings = 4 * n });
    }
}

static void elevate32(row *r)
{
    loft_vec p[MOST], out[LOFT_BEZIER_ELEVATE_MAX + 1];
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), d = dimension(r);
    loft_bezier b;

    row_points(r, "P_q16", n + 1, d, p);
    if (loft_bezier_init(&b, p, n) != LOFT_OK)
        row_complain(r, "the curve was refused");
    else
        expect_vecs(r, "Q", loft_bezier_elevate(&b, 32 - n, out), out, 33, d,
                    (law){ .lsb = 0.5L + 15 / 131072.0L, .roundings = 64 });
}


/* Decisions */

static void copositive56(row *r)
{
    loft_real m[LOFT_COPOSITIVE_MAX * (LOFT_COPOSITIVE_MAX + 1) / 2];
    const unsigned n = row_count(r, "n", LOFT_COPOSITIVE_MAX);
    bool flag = false;

    row_reals(r, "M_q16", n * (n + 1) / 2, m);
    if (loft_matrix_copositive(m, n, &flag) != LOFT_OK)
        row_complain(r, "the matrix was refused");
    if (as_given(r))
        row_expect_flag(r, "copositive", flag);
}

#define HIGH LOFT_POSITIVITY_DEGREE

static uint32_t work[LOFT_POSITIVITY_WORK(HIGH)];

static void positivity_n(row *r)
{
    loft_real b[HIGH + 1];
    const unsigned n = row_count(r, "n", HIGH) + 1;
    loft_positivity p = { false, false, 0 };
    char roots[12];

    row_reals(r, "b_q16", n, b);
    if (loft_bernstein_positivity_in(b, n - 1, work, &p) != LOFT_OK)
        row_complain(r, "the polynomial was refused");
    if (!as_given(r))
        return;
    snprintf(roots, sizeof roots, "%d", p.roots);
    row_expect_flag(r, "nonneg", p.nonnegative);
    row_expect_flag(r, "positive", p.positive);
    row_expect_word(r, "roots", roots);
}

static void positivity_high(row *r)
{
    loft_real b[HIGH + 1];
    const unsigned n = row_count(r, "n", HIGH) + 1;
    bool net, polynomial = false;

    positivity_n(r);
    row_reals(r, "b_q16", n, b);
    if (loft_bernstein_convex_in(b, n - 1, work, &net, &polynomial) != LOFT_OK)
        row_complain(r, "the polynomial was refused");
    if (as_given(r))
        row_expect_flag(r, "convex", polynomial);
}

static void row_weights(row *r, unsigned count, unsigned d, loft_weighted out[])
{
    loft_vec p[4];
    loft_real w[4];
    const long double before = r->largest;

    row_points(r, "P_q16", count, d, p);
    const long double largest = fmaxl(before, r->largest);
    row_reals(r, "w_q16", count, w);
    r->largest = largest;
    for (unsigned k = 0; k < count; k++)
        out[k] = (loft_weighted) { p[k], w[k] };
}

static const char *kind_word(enum loft_conic_kind k)
{
    static const char *const word[] = {
        "ellipse", "parabola", "hyperbola", "line", "point", "null"
    };
    return word[k];
}

static void conic_kind(row *r)
{
    loft_weighted p[3];
    loft_conic c = { LOFT_CONIC_NULL, false, false };

    row_weights(r, 3, 2, p);
    if (loft_conic_init(&c, p) != LOFT_OK)
        row_complain(r, "the conic was refused");
    if (!as_given(r))
        return;
    row_expect_word(r, "kind", kind_word(c.kind));
    row_expect_flag(r, "finite", c.finite);
    row_expect_flag(r, "circle", c.circle);
}

static void conic_axes(row *r)
{
    loft_weighted p[3];
    loft_conic c = { LOFT_CONIC_NULL, false, false };
    loft_vec centre = { { 0 } };
    loft_real axes[2] = { 0 };
    answer *a = answer_new();

    row_weights(r, 3, 2, p);
    if (loft_conic_init(&c, p) != LOFT_OK)
        row_complain(r, "the conic was refused");
    if (!as_given(r))
        return;
    row_expect_word(r, "kind", kind_word(c.kind));
    const enum loft_status status = loft_conic_axes(p, &centre, axes);
    const long double w = exact_of(p[0].w) * exact_of(p[2].w), w1 = exact_of(p[1].w);
    const long double s = fabsl(w / (w - w1 * w1)), size = r->largest;
    const long double least = fmaxl(fminl(fabsl(exact_of(axes[0])), fabsl(exact_of(axes[1]))),
                                    0x1p-16L);
    const long double far = 4 * (1 + s) * size * 0x1p-44L,
                      bend = 4 * s * (1 + s) * size * size / least * 0x1p-44L;
    answer_status(r, a, status);
    answer_real(a, axes[0]);
    answer_real(a, axes[1]);
    r->largest = 1;
    expect_vec(r, "centre", status, centre, 2,
               law_of(fminl(0.501L + far * 0x1p-8L * 65536, 4), far));
    row_expect(r, "axes", a, law_of(fminl(0.501L + bend * 0x1p-8L * 65536, 4), bend));
    r->largest = size;
}

static void rational_conic(row *r)
{
    loft_weighted p[4], q[3];
    answer *a = answer_new(), *w = answer_new();

    row_weights(r, 4, 2, p);
    const enum loft_status status = loft_conic_from_cubic(p, q);
    if (!as_given(r))
        return;
    row_expect_flag(r, "conic", status != LOFT_SINGULAR);
    if (status == LOFT_SINGULAR)
        return;
    answer_status(r, a, status);
    for (unsigned k = 0; k < 3 && status == LOFT_OK; k++) {
        answer_vec(a, q[k].p, 2);
        answer_real(w, q[k].w);
    }
    const long double w0 = exact_of(p[0].w), w1 = exact_of(p[1].w);
    row_expect(r, "Q", a,
               (law){ .lsb = 0.501L,
                      .gain = (fabsl(w0) + 3 * fabsl(w1)) / fabsl(3 * w1 - w0),
                      .roundings = 8 });
    if (status == LOFT_OK)
        row_expect(r, "wQ", w, (law) { .lsb = 0.501L, .gain = 1, .roundings = 1024 });
}

static void exact_degree(row *r)
{
    loft_vec p[MOST], q[MOST];
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), d = dimension(r);
    unsigned degree = 0;
    char word[12];
    loft_bezier b;

    row_points(r, "P_q16", n + 1, d, p);
    if (loft_bezier_init(&b, p, n) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    const enum loft_status status = loft_bezier_exact_degree(&b, &degree, q);
    if (!as_given(r))
        return;
    snprintf(word, sizeof word, "%u", degree);
    row_expect_word(r, "degree", word);
    expect_vecs(r, "Q", status, q, degree + 1, d,
                (law){ .lsb = 0.501L, .roundings = powl(8, n - degree) });
}

static void bezier_reduce(row *r)
{
    loft_vec p[MOST], q[MOST];
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), d = dimension(r),
                   times = row_count(r, "r", LOFT_DEGREE_MAX);
    loft_acc bound = 0;
    loft_bezier b;
    answer *a = answer_new();

    row_points(r, "P_q16", n + 1, d, p);
    if (loft_bezier_init(&b, p, n) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    const enum loft_status status = loft_bezier_reduce(&b, times, q, &bound);
    if (!as_given(r))
        return;
    expect_vecs(r, "Q", status, q, n - times + 1, d,
                (law){ .lsb = 0.5L + 1 / 1024.0L, .roundings = 0x1p20L });
    answer_status(r, a, status);
    if (status == LOFT_OK)
        answer_wide(a, bound);
    row_expect(r, "bound", a, (law) { .lsb = 2, .roundings = BY_NUM(0, 0x1p31L, 0x1p24L) });
    if (status == LOFT_OK && exact_acc(bound) < strtold(row_text(r, "bound"), NULL))
        row_complain(r, "the bound is below the error");
}


/* Integrals */

static void integral_bern(row *r)
{
    loft_real b[MOST];
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    const loft_unit from = row_unit(r, "a_q16"), to = row_unit(r, "c_q16");
    loft_acc whole = 0, part = 0;

    row_reals(r, "b_q16", n + 1, b);
    const enum loft_status one = loft_bernstein_mean(b, n + 1, &whole),
                           two = loft_bernstein_integral(b, n, from, to, &part);
    expect_acc(r, "whole", one, &whole, 1, (law) { .lsb = 0.501L, .roundings = n + 1 });
    expect_acc(r, "part", two, &part, 1, (law) { .lsb = 0.501L, .roundings = 64 });
}

static void area_under(row *r)
{
    loft_vec p[MOST];
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    const loft_unit from = row_unit(r, "a_q16"), to = row_unit(r, "b_q16");
    loft_acc area = 0;
    loft_bezier b;

    row_points(r, "P_q16", n + 1, 2, p);
    if (loft_bezier_init(&b, p, n) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    const enum loft_status status = loft_bezier_area_under(&b, from, to, &area);
    if (as_given(r))
        expect_acc_within(r, "area", status, &area, 1, 0.501L, r->largest * r->largest * 0x1p-44L);
}

#define CURVES 32

static unsigned row_chain(row *r, loft_vec p[], loft_bezier c[])
{
    const char *text = row_text(r, "degs");
    unsigned count = 0, at = 0;
    int degree[CURVES];

    for (char *end; *text && count < CURVES; text = *end ? end + 1 : end)
        degree[count++] = (int)strtol(text, &end, 10);
    for (unsigned k = 0; k < count; k++)
        at += (unsigned)degree[k];
    row_points(r, "P_q16", at + 1, 2, p);
    at = 0;
    for (unsigned k = 0; k < count; k++, at += (unsigned)degree[k - 1])
        if (loft_bezier_init(&c[k], p + at, (unsigned)degree[k]) != LOFT_OK)
            row_complain(r, "a curve was refused");
    return count;
}

static void area_chain(row *r)
{
    static loft_vec p[CURVES * MOST];
    static loft_bezier c[CURVES];
    const unsigned count = row_chain(r, p, c);
    loft_enclosed e = { 0, { 0, 0 }, 0, 0, 0 };
    long double extent = 0;
    unsigned points = 0;

    if (r->complaint[0])
        return;
    const enum loft_status status = loft_chain_enclosed(c, count, &e);
    for (unsigned k = 0; k < count; k++)
        points += c[k].degree;
    for (unsigned k = 0; k <= points; k++)
        for (int i = 0; i < 2; i++)
            extent = fmaxl(extent, 2 * fabsl(exact_of(p[k].axis[i]) - exact_of(p[0].axis[i])));
    if (!as_given(r))
        return;
    row_expect_word(r, "status", status == LOFT_SINGULAR ? "zero_area" : "ok");
    expect_acc_within(r, "area",
                      status == LOFT_SINGULAR || fabsl(exact_acc(e.area)) > 0 ? LOFT_OK : status,
                      &e.area, 1, 0.501L, extent * extent * 0x1p-52L);
    const long double area = strtold(row_text(r, "area"), NULL), size = fabsl(area),
                      cube = extent * extent * extent;
    const loft_acc moment[3] = { e.xx, e.xy, e.yy };
    if (status == LOFT_SINGULAR || !(size >= 0x1p-6L && size >= 0x1p-8L * extent * extent))
        return;
    expect_acc_within(r, "centroid", status, e.centroid, 2, 0.501L + cube / size * 0x1p-36L,
                      cube / size * 0x1p-44L + r->largest * 0x1p-52L);
    expect_acc_within(r, "moments", status, moment, 3,
                      0.501L + cube * extent * (1 + extent * extent / size) * 0x1p-34L,
                      cube * extent * (1 + extent * extent / size) * 0x1p-42L);
}

static void integral_tri(row *r)
{
    static loft_real b[LOFT_TRIANGLE_MAX];
    loft_vec net[LOFT_TRIANGLE_MAX], t[3];
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), count = LOFT_TRIANGLE_POINTS(n);
    loft_acc mean = 0, area = 0, integral = 0;

    row_points(r, "net_q16", count, 1, net);
    const long double top = r->largest;
    row_points(r, "T_q16", 3, 2, t);
    const long double wide = r->largest;
    for (unsigned k = 0; k < count; k++)
        b[k] = net[k].axis[0];
    const enum loft_status one = loft_bernstein_mean(b, count, &mean),
                           two = loft_triangle_integral(b, n, t, &area, &integral);
    if (!as_given(r))
        return;
    expect_acc_within(r, "mean", one, &mean, 1, 0.501L, count * top * 0x1p-52L);
    expect_acc_within(r, "area", two, &area, 1, 0.501L, wide * wide * 0x1p-50L);
    expect_acc_within(r, "integral", two, &integral, 1, 0.501L,
                      count * top * wide * wide * 0x1p-49L);
}

#define PATCHES 16

static void volume_patches(row *r)
{
    static loft_vec p[PATCHES * MOST * MOST];
    static loft_tensor s[PATCHES];
    const unsigned k = row_count(r, "k", PATCHES);
    loft_net net[PATCHES];
    const char *text = row_text(r, "mn");
    unsigned degree[PATCHES][2] = { { 0 } }, at = 0;
    loft_acc volume = 0;
    long double extent = 0;
    char *end;

    for (unsigned i = 0; i < k; i++)
        for (int j = 0; j < 2; j++, text = *end ? end + 1 : end)
            degree[i][j] = (unsigned)strtoul(text, &end, 10);
    for (unsigned i = 0; i < k; i++)
        at += (degree[i][0] + 1) * (degree[i][1] + 1);
    if (at > PATCHES * MOST * MOST) {
        row_complain(r, "%u points are too many", at);
        return;
    }
    row_points(r, "net_q16", at, 3, p);
    for (unsigned i = 0; i < at; i++)
        for (int j = 0; j < 3; j++)
            extent = fmaxl(extent, 2 * fabsl(exact_of(p[i].axis[j]) - exact_of(p[0].axis[j])));
    at = 0;
    for (unsigned i = 0; i < k; i++, at += (degree[i-1][0] + 1) * (degree[i-1][1] + 1))
        if (loft_tensor_init(&s[i], p + at, degree[i][0], degree[i][1]) != LOFT_OK)
            row_complain(r, "a patch was refused");
        else
            net[i] = loft_net_from_tensor(&s[i]);
    if (r->complaint[0])
        return;
    const enum loft_status status = loft_net_volume(net, k, &volume);
    const long double cube = k * extent * extent * extent;
    if (as_given(r))
        expect_acc_within(r, "volume", status, &volume, 1, fminl(0.501L + cube * 0x1p-36L, 8),
                          cube * 0x1p-44L);
}


/* Zheng-Ball patches */

static unsigned ring_place_of(unsigned n, unsigned d, const uint8_t want[])
{
    uint8_t l[LOFT_ZHENG_BALL_SIDES];
    const unsigned count = loft_zheng_ball_count(n, d);

    for (unsigned k = 0; k < count; k++) {
        bool same = true;
        loft_zheng_ball_index(n, d, k, l);
        for (unsigned i = 0; i < n; i++)
            same = same && l[i] == want[i];
        if (same)
            return k;
    }
    return count;
}

#define RING 400

static void zb_deriv(row *r)
{
    static loft_vec read[RING], p[RING];
    const unsigned n = row_count(r, "n", LOFT_ZHENG_BALL_SIDES),
                   d = row_count(r, "d", LOFT_DEGREE_MAX), count = loft_zheng_ball_count(n, d);
    const char *text = row_text(r, "lambda");
    loft_real u[2];
    loft_jet at[LOFT_ZHENG_BALL_SIDES];
    loft_sci place[LOFT_ZHENG_BALL_SIDES];
    loft_zheng_ball ring;
    loft_differential here;
    loft_vec v = { { 0 } };

    if (count > RING) {
        row_complain(r, "%u points are too many", count);
        return;
    }
    row_points(r, "net_q16", count, 3, read);
    const long double largest = r->largest;
    row_reals(r, "u_q16", 2, u);
    r->largest = largest;
    for (unsigned k = 0; k < count; k++) {
        uint8_t l[LOFT_ZHENG_BALL_SIDES];
        char *end;
        for (unsigned i = 0; i < n; i++, text = *end ? end + 1 : end)
            l[i] = (uint8_t)strtoul(text, &end, 10);
        const unsigned to = ring_place_of(n, d, l);
        if (to == count) {
            row_complain(r, "column lambda: point %u is not one of the patch", k);
            return;
        }
        p[to] = read[k];
    }
    const loft_unit t[2] = { loft_unit_from(u[0]), loft_unit_from(u[1]) };
    const long double far = fmaxl(fmaxl(1 - exact_of(u[0]), 1 - exact_of(u[1])), 0x1p-8L);
    if (loft_zheng_ball_init(&ring, p, n, d) != LOFT_OK ||
        loft_zheng_ball_params(n, t[0], t[1], place) != LOFT_OK ||
        loft_zheng_ball_params_jet(n, t[0], t[1], at) != LOFT_OK) {
        row_complain(r, "the patch or its parameters were refused");
        return;
    }
    if (!as_given(r))
        return;
    expect_vec(r, "P", loft_zheng_ball_eval(&ring, place, &v), v, 3,
               (law){ .lsb = 0.5L + 0x1p-10L, .gain = 64, .roundings = 4096 });
    loft_zheng_ball_differential(&ring, at, &here);
    for (unsigned k = 0; k < 2; k++) {
        loft_acc x[3] = { 0 };
        enum loft_status status = LOFT_OK;
        for (int i = 0; i < 3; i++)
            if (!loft_sci_to_acc(k ? here.v[i] : here.u[i], &x[i]))
                status = LOFT_ERR_RANGE;
        expect_acc(r, k ? "P2" : "P1", status, x, 3,
                   (law){ .lsb = fminl(0.5L + 0x1p-8L + d * largest * 0x1p-36L / (far * far), 8),
                          .gain = 1 << 16,
                          .roundings = 4096 });
    }
}

const vector_system vectors_decide[] = {
    { "bernstein_op64", "n,f_q16,x_q16,value,deriv", bernstein_op64,
      "value 1/2 LSB + n 2^-17 LSB, deriv 1/2 LSB + n^2 2^-17 LSB" },
    { "elevate32", "n,d,P_q16,Q", elevate32, "1/2 LSB + 15 * 2^-17 LSB" },
    { "copositive56", "n,M_q16,copositive", copositive56, "exact" },
    { "positivity_n", "n,b_q16,nonneg,positive,roots", positivity_n, "exact" },
    { "positivity_high", "n,b_q16,nonneg,positive,roots,convex", positivity_high, "exact" },
    { "conic_kind", "P_q16,w_q16,kind,finite,circle", conic_kind, "exact" },
    { "conic_axes", "P_q16,w_q16,kind,centre,axes", conic_axes,
      "kind exact, centre, axes 1/2 LSB + their error, at most 4" },
    { "rational_conic", "P_q16,w_q16,conic,Q,wQ", rational_conic,
      "conic exact, Q, wQ 1/2 LSB + 2^-10 LSB" },
    { "exact_degree", "n,d,P_q16,degree,Q", exact_degree, "degree exact, Q 1/2 LSB + 2^-10 LSB" },
    { "bezier_reduce", "n,d,r,P_q16,Q,bound", bezier_reduce,
      "Q 1/2 LSB + 2^-10 LSB, bound 2 LSB, never below" },
    { "integral_bern", "n,b_q16,a_q16,c_q16,whole,part", integral_bern, "1/2 LSB + 2^-10 LSB" },
    { "area_under", "n,P_q16,a_q16,b_q16,area", area_under, "1/2 LSB + 2^-10 LSB" },
    { "area_chain", "degs,P_q16,status,area,centroid,moments", area_chain,
      "status exact, area 1/2 LSB + 2^-10 LSB, centroid + 2^-52 L^3 / A, moments + 2^-50 L^4 (1 + "
      "L^2 / A)" },
    { "integral_tri", "n,net_q16,T_q16,mean,area,integral", integral_tri, "1/2 LSB + 2^-10 LSB" },
    { "volume_patches", "k,mn,net_q16,volume", volume_patches, "1/2 LSB + k 2^-52 L^3, at most 8" },
    { "zb_deriv", "n,d,lambda,net_q16,u_q16,P,P1,P2", zb_deriv,
      "P 1/2 LSB + 2^-10 LSB, P1, P2 1/2 LSB + 2^-8 LSB + d L 2^-52 / r^2, at most 8" },
    { NULL, NULL, NULL, NULL }
};

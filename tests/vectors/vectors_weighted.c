/* tests/vectors/vectors_weighted.c -- readers of derivatives, normals and pieces of curves and
 * surfaces with weights, of B-spline surfaces, and of surfaces from curves
 * SPDX-License-Identifier: MIT
 *
 * Where f32 cannot hold the row's numbers it reads another curve: nothing is compared there but
 * that the functions accept it.
 */
#include "vectors/vectors_bary.h"           /* row_bary */
#include "vectors/vectors_points.h"         /* expect_vec, as_given; row, answer, law */
#include "curve/tangent.h"
#include "surface/tensor/nurbs_surface.h"
#include "surface/tensor/revolve.h"
#include "surface/tensor/ruled.h"
#include "surface/tensor/skin.h"
#include "surface/triangle/triangle_rational.h"

#define POINTS 400
#define KNOTS 64

typedef struct {
    unsigned count;
    long double ratio;              /* of the largest weight to the smallest */
    loft_weighted p[POINTS];
} weighted;

static void row_weighted(row *r, const char *points, const char *weights, unsigned count,
                         unsigned d, weighted *x)
{
    static loft_vec p[POINTS];
    static loft_real w[POINTS];
    const long double largest = r->largest;
    long double least = 256, most = 1 / 256.0L;

    x->count = count;
    row_points(r, points, count, d, p);
    const long double coordinates = r->largest;
    row_reals(r, weights, count, w);
    r->largest = fmaxl(largest, coordinates);
    for (unsigned k = 0; k < count; k++) {
        x->p[k] = (loft_weighted) { p[k], w[k] };
        least = fminl(least, exact_of(w[k]));
        most = fmaxl(most, exact_of(w[k]));
    }
    x->ratio = most / least;
}

/* A bound in floats that is not a number of ulp of the largest coordinate, and one in q16 of at
 * most `wish`. */
static void expect_vec_within(row *r, const char *column, enum loft_status status, loft_vec v,
                              unsigned d, long double error, long double wish)
{
    const long double largest = r->largest;
    const law l = { .lsb = fminl(0.501L + error * 0x1p-8L * 65536, wish),
                    .roundings = 1 + error / 0x1p-52L };

    r->largest = 1;
    expect_vec(r, column, status, v, d, l);
    r->largest = largest;
}

static void expect_wide_within(row *r, const char *column, enum loft_status status, loft_acc x,
                               long double error)
{
    const long double largest = r->largest;
    answer *a = answer_new();

    answer_status(r, a, status);
    if (status == LOFT_OK)
        answer_acc(a, x);
    r->largest = 1;
    row_expect(r, column, a,
               (law){ .lsb = fminl(0.501L + error * 0x1p-8L * 65536, 4),
                      .roundings = 1 + error / 0x1p-52L });
    r->largest = largest;
}

static long double length_of(const long double x[], unsigned n)
{
    long double sum = 0;
    for (unsigned i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sqrtl(sum);
}

/* The numbers of a column of the row. */
static void row_values(row *r, const char *column, unsigned count, long double out[])
{
    const char *text = row_text(r, column);
    char *end;

    for (unsigned i = 0; i < count; i++, text = *end ? end + 1 : end)
        out[i] = strtold(text, &end);
}


/* Curves */

/* d1 and d2: D1 and D2 of curve/tangent.h, times 2^-46. */
static void expect_tangent(row *r, const loft_tangent *at, unsigned d, long double d1,
                           long double d2)
{
    loft_vec v[2] = { { { 0 } } };
    loft_acc k = 0;
    long double first[LOFT_AXES], second[LOFT_AXES];
    enum loft_status status[2];

    for (unsigned i = 0; i < 2; i++)
        status[i] = loft_tangent_deriv(at, i + 1, &v[i]);
    expect_vec_within(r, "dp", status[0], v[0], d, d1, 4);
    expect_vec_within(r, "ddp", status[1], v[1], d, d2, 16);
    row_expect_word(r, "status", at->stops ? "singular" : "ok");
    row_values(r, "dp", d, first);
    row_values(r, "ddp", d, second);
    const long double speed = length_of(first, d);
    if (at->stops || speed < 0.0625L)
        return;
    const long double error = 4 * d1 * length_of(second, d) / (speed * speed * speed) +
                              d2 / (speed * speed);
    const enum loft_status bends = loft_tangent_curvature(at, d == 2, &k);
    expect_wide_within(r, "kappa", bends, k, error);
}

static void rational_deriv2(row *r)
{
    static weighted x;
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), d = dimension(r);
    const loft_unit t = row_unit(r, "t_q16");
    loft_rational c;
    loft_tangent at;

    row_weighted(r, "P_q16", "w_q16", n + 1, d, &x);
    if (loft_rational_init(&c, x.p, n) != LOFT_OK || loft_rational_tangent(&c, t, &at) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    if (!as_given(r))
        return;
    const long double slope = 2 * n * x.ratio, size = r->largest * 0x1p-46L;
    expect_vec(r, "p", LOFT_OK, loft_rational_eval(&c, t), d,
               (law){ .lsb = 0.501L, .roundings = 6 * n + 4 });
    expect_tangent(r, &at, d, slope * size, slope * slope * size);
}

/* The length of the span of u. */
static long double span_of(const loft_knots *k, loft_real u)
{
    const unsigned s = loft_knots_find(k, loft_knots_clamp(k, u));
    return exact_of(k->k[s + 1]) - exact_of(k->k[s]);
}

static void row_knots(row *r, const char *column, unsigned count, loft_real out[])
{
    const long double largest = r->largest;
    if (count > KNOTS)
        row_complain(r, "column %s: %u knots are more than %d", column, count, KNOTS);
    row_reals(r, column, count < KNOTS ? count : KNOTS, out);
    r->largest = largest;
}

static void nurbs_eval(row *r)
{
    static weighted x;
    static loft_real knot[KNOTS];
    const unsigned p = row_count(r, "p", LOFT_DEGREE_MAX), n = row_count(r, "n", KNOTS - 12),
                   d = dimension(r);
    loft_real u;
    loft_nurbs c;
    loft_tangent at;

    row_weighted(r, "P_q16", "w_q16", n + 1, d, &x);
    row_knots(r, "U_q16", n + p + 2, knot);
    row_knots(r, "t_q16", 1, &u);
    if (!as_given(r))
        return;
    if (loft_nurbs_init(&c, x.p, n + 1, knot, p) != LOFT_OK ||
        loft_nurbs_tangent(&c, u, &at) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    const long double slope = 2 * p * x.ratio / span_of(&c.knots, u), size = r->largest * 0x1p-46L;
    expect_vec(r, "point", LOFT_OK, loft_nurbs_eval(&c, u), d,
               (law){ .lsb = 0.501L, .roundings = 10 * p + 4 });
    expect_tangent(r, &at, d, slope * size, slope * slope * size);
}


/* Triangles with weights */

typedef struct {
    unsigned n;
    weighted x;
    loft_triangle_rational t;
} triangle;

static bool row_triangle(row *r, triangle *x)
{
    x->n = row_count(r, "n", LOFT_DEGREE_MAX);
    row_weighted(r, "net_q16", "w_q16", LOFT_TRIANGLE_POINTS(x->n), 3, &x->x);
    if (loft_triangle_rational_init(&x->t, x->x.p, x->n) != LOFT_OK)
        row_complain(r, "the net was refused");
    return as_given(r) && !r->complaint[0];
}

static void expect_net(row *r, const char *points, const char *weights, const loft_weighted p[],
                       unsigned count)
{
    answer *a = answer_new(), *w = answer_new();

    for (unsigned k = 0; k < count; k++) {
        answer_vec(a, p[k].p, 3);
        answer_real(w, p[k].w);
    }
    row_expect(r, points, a, (law) { .lsb = 0.501L, .roundings = 128 });
    const long double largest = r->largest;
    r->largest = 256;
    row_expect(r, weights, w, (law) { .lsb = 0.501L, .roundings = 128 });
    r->largest = largest;
}

static void tri_rational_split(row *r)
{
    static triangle x;
    static loft_weighted out[3][LOFT_TRIANGLE_MAX];
    const loft_bary u = row_bary(r, "u_q16", false);
    const bool fits = row_triangle(r, &x);

    if (loft_triangle_rational_split(&x.t, u, out[0], out[1], out[2]) != LOFT_OK)
        row_complain(r, "the triangle was not split");
    for (unsigned k = 0; k < 3 && fits; k++) {
        static const char *const net[3] = { "A", "B", "C" }, *const weights[3] = { "wA", "wB",
                                                                                   "wC" };
        expect_net(r, net[k], weights[k], out[k], LOFT_TRIANGLE_POINTS(x.n));
    }
}

static void tri_rational_elevate(row *r)
{
    static triangle x;
    static loft_weighted out[LOFT_TRIANGLE_POINTS(LOFT_ELEVATE_MAX)];
    const unsigned m = row_count(r, "m", LOFT_ELEVATE_MAX);
    const bool fits = row_triangle(r, &x);

    if (loft_triangle_rational_elevate(&x.t, m, out) != LOFT_OK)
        row_complain(r, "the triangle was not raised");
    else if (fits)
        expect_net(r, "out", "wout", out, LOFT_TRIANGLE_POINTS(x.n + m));
}

static long double reach_of(loft_bary z)
{
    const long double v = exact_unit(z.v), w = exact_unit(z.w);
    return fabsl(v + w) + fabsl(v) + fabsl(w);
}

static void tri_rational_deriv2(row *r)
{
    static triangle x;
    const loft_bary u = row_bary(r, "u_q16", false), y = row_bary(r, "y_q16", true),
                    z = row_bary(r, "z_q16", true);
    loft_vec dy = { { 0 } }, dz = { { 0 } }, dyz = { { 0 } };

    if (!row_triangle(r, &x))
        return;
    const long double size = r->largest * 0x1p-46L * x.n * x.x.ratio;
    const long double by_y = size * reach_of(y), by_z = size * reach_of(z);
    expect_vec(r, "p", LOFT_OK, loft_triangle_rational_eval(&x.t, u), 3,
               (law){ .lsb = 0.501L, .roundings = 6 * x.n + 4 });
    const enum loft_status one = loft_triangle_rational_deriv(&x.t, y, u, &dy),
                           two = loft_triangle_rational_deriv(&x.t, z, u, &dz),
                           both = loft_triangle_rational_deriv2(&x.t, y, z, u, &dyz);
    expect_vec_within(r, "Dy", one, dy, 3, by_y, 4);
    expect_vec_within(r, "Dz", two, dz, 3, by_z, 4);
    expect_vec_within(r, "Dyz", both, dyz, 3, 2 * by_y * x.n * x.x.ratio * reach_of(z), 16);
}


/* Normals and curvatures */

static long double sci_value(loft_sci x)
{
    loft_acc wide = 0;
    return loft_sci_to_acc(x, &wide) ? exact_acc(wide) : HUGE_VALL;
}

static void sci_values(const loft_sci x[], long double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = i < LOFT_AXES ? sci_value(x[i]) : 0;
}

static long double cross_length(const long double a[3], const long double b[3])
{
    const long double n[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                               a[0] * b[1] - a[1] * b[0] };
    return length_of(n, 3);
}

/* e1 and e2 are the errors of first and second derivatives in floats. Where the tangents are short
 * or nearly parallel, the normal has length 1 and no more is asked. */
static void expect_normal(row *r, const loft_differential *at, bool regular, long double e1,
                          long double e2, bool mean)
{
    long double u[3], v[3], second[3][3];
    loft_vec n = { { 0 } };
    loft_curvatures k = { 0, 0, 0, 0 };

    row_expect_word(r, "status", regular ? "ok" : "singular");
    if (!regular)
        return;
    sci_values(at->u, u);
    sci_values(at->v, v);
    sci_values(at->uu, second[0]);
    sci_values(at->uv, second[1]);
    sci_values(at->vv, second[2]);
    const long double a = length_of(u, 3), b = length_of(v, 3), w = cross_length(u, v);
    const enum loft_status status = loft_differential_normal(at, &n);
    if (status != LOFT_OK) {
        row_complain(r, "no normal, status %d", status);
        return;
    }
    if (!(w >= 0x1p-6L * a * b && a >= 0.0625L && b >= 0.0625L)) {
        const long double x[3] = { exact_of(n.axis[0]), exact_of(n.axis[1]), exact_of(n.axis[2]) };
        row_within(r, "length of the normal", fabsl(length_of(x, 3) - 1) * 65536, 2);
        return;
    }
    const long double tilt = 2 * e1 * fmaxl(a, b) / w;
    expect_vec_within(r, "normal", LOFT_OK, n, 3, tilt, 4);
    const long double bend = fmaxl(length_of(second[0], 3),
                                   fmaxl(length_of(second[1], 3), length_of(second[2], 3)));
    const long double form = e2 + bend * tilt;
    const long double most = fmaxl(a, b),
                      gauss = 8 * (2 * bend * form + form * form) / (w * w) +
                              8 * bend * bend / (w * w) * most * most * most * 4 * e1 / (w * w);
    const enum loft_status bends = loft_differential_curvatures(at, &k);
    expect_wide_within(r, "K", bends, k.gauss, gauss + 0x1p-46L * bend * bend / (w * w));
    if (mean)
        expect_wide_within(r, "H", bends, k.mean,
                           16 * (form + bend * e1 * most / w) * most * most / (w * w) +
                               0x1p-46L * bend * most * most / (w * w));
}

static void tri_rational_normal(row *r)
{
    static triangle x;
    const loft_bary u = row_bary(r, "u_q16", false);
    loft_differential at;

    if (!row_triangle(r, &x))
        return;
    if (loft_triangle_rational_differential(&x.t, u, &at) != LOFT_OK) {
        row_complain(r, "no derivatives");
        return;
    }
    at.width_u = at.width_v = loft_sci_zero();
    const long double slope = 2 * x.n * x.x.ratio, size = r->largest * 0x1p-46L;
    expect_normal(r, &at, loft_triangle_rational_regular(&x.t, u), slope * size,
                  slope * slope * size, true);
}

static void surface_row(row *r, bool rational)
{
    static weighted x;
    static loft_vec net[POINTS];
    static loft_real knot_u[KNOTS], knot_v[KNOTS];
    const unsigned p = row_count(r, "p", LOFT_DEGREE_MAX), q = row_count(r, "q", LOFT_DEGREE_MAX),
                   m = row_count(r, "m", 18), n = row_count(r, "n", 18);
    const unsigned count = (m + 1) * (n + 1);
    loft_nurbs_surface s;
    loft_differential at;
    loft_vec v[3] = { { { 0 } } };
    loft_real u[2];
    enum loft_status status[3];

    x.ratio = 1;
    if (rational)
        row_weighted(r, "net_q16", "w_q16", count, 3, &x);
    else
        row_points(r, "net_q16", count, 3, net);
    row_knots(r, "U_q16", m + p + 2, knot_u);
    row_knots(r, "V_q16", n + q + 2, knot_v);
    row_knots(r, "u_q16", 1, &u[0]);
    row_knots(r, "v_q16", 1, &u[1]);
    if (!as_given(r))
        return;
    const enum loft_status start =
        rational ? loft_nurbs_surface_init(&s, x.p, m + 1, n + 1, knot_u, p, knot_v, q)
                 : loft_bspline_surface_init(&s, net, m + 1, n + 1, knot_u, p, knot_v, q);
    if (start != LOFT_OK) {
        row_complain(r, "the surface was refused");
        return;
    }
    const long double by_u = 2 * p * x.ratio / span_of(&s.u, u[0]),
                      by_v = 2 * q * x.ratio / span_of(&s.v, u[1]), size = r->largest * 0x1p-46L;
    status[0] = loft_nurbs_surface_eval(&s, u[0], u[1], &v[0]);
    status[1] = loft_nurbs_surface_deriv(&s, 1, 0, u[0], u[1], &v[1]);
    status[2] = loft_nurbs_surface_deriv(&s, 0, 1, u[0], u[1], &v[2]);
    expect_vec(r, "P", status[0], v[0], 3, (law) { .lsb = 0.501L, .roundings = 64 });
    expect_vec_within(r, "Pu", status[1], v[1], 3, by_u * size, 4);
    expect_vec_within(r, "Pv", status[2], v[2], 3, by_v * size, 4);
    const enum loft_status normal = loft_nurbs_surface_differential(&s, u[0], u[1], &at);
    const long double most = fmaxl(by_u, by_v);
    if (normal != LOFT_OK && normal != LOFT_SINGULAR)
        row_complain(r, "no derivatives, status %d", normal);
    else
        expect_normal(r, &at, normal == LOFT_OK, most * size, most * most * size, false);
}

static void bspline_surface(row *r) { surface_row(r, false); }
static void nurbs_surface(row *r)   { surface_row(r, true); }


/* Surfaces from curves */

static void ruled(row *r)
{
    loft_vec p[2][LOFT_DEGREE_MAX + 1], net[2 * (LOFT_DEGREE_MAX + 1)], v[3] = { { { 0 } } };
    const unsigned m = row_count(r, "m", LOFT_DEGREE_MAX), n = row_count(r, "n", LOFT_DEGREE_MAX),
                   d = dimension(r), top = m > n ? m : n;
    const loft_unit at = row_unit(r, "u_q16"), along = row_unit(r, "v_q16");
    loft_bezier a, b;
    enum loft_status status[3];

    row_points(r, "A_q16", m + 1, d, p[0]);
    row_points(r, "B_q16", n + 1, d, p[1]);
    if (loft_bezier_init(&a, p[0], m) != LOFT_OK || loft_bezier_init(&b, p[1], n) != LOFT_OK) {
        row_complain(r, "a curve was refused");
        return;
    }
    expect_vecs(r, "net", loft_tensor_from_ruled(&a, &b, net), net, 2 * (top + 1), d,
                (law){ .lsb = 0.51L, .roundings = 40 });
    status[0] = loft_ruled_deriv(&a, &b, 0, 0, at, along, &v[0]);
    status[1] = loft_ruled_deriv(&a, &b, 1, 0, at, along, &v[1]);
    status[2] = loft_ruled_deriv(&a, &b, 0, 1, at, along, &v[2]);
    const law point = { .lsb = 0.501L, .roundings = 16 * (top + 2) };
    expect_vec(r, "P", status[0], v[0], d, point);
    expect_vec(r, "Pu", status[1], v[1], d,
               (law){ .lsb = 0.501L, .gain = 2 * top, .roundings = 16 * (top + 2) });
    expect_vec(r, "Pv", status[2], v[2], d,
               (law){ .lsb = 0.501L, .gain = 2, .roundings = 16 * (top + 2) });
}

static void revolve(row *r)
{
    static weighted x;
    loft_weighted out[3 * (LOFT_DEGREE_MAX + 1)];
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), k = row_count(r, "k", 3);
    const loft_unit u = row_unit(r, "u_q16"), v = row_unit(r, "v_q16");
    loft_rational profile;
    loft_vec p = { { 0 } };
    answer *net = answer_new(), *weights = answer_new();

    row_weighted(r, "P_q16", "w_q16", n + 1, 3, &x);
    if (loft_rational_init(&profile, x.p, n) != LOFT_OK) {
        row_complain(r, "the profile was refused");
        return;
    }
    const enum loft_status status = loft_tensor_rational_from_revolve(&profile, k, out);
    if (!as_given(r))
        return;
    answer_status(r, net, status);
    for (unsigned i = 0; i < 3 * (n + 1) && status == LOFT_OK; i++) {
        answer_vec(net, out[i].p, 3);
        answer_real(weights, out[i].w);
    }
    row_expect(r, "net", net, (law) { .lsb = 0, .roundings = 1 });
    if (status == LOFT_OK)
        row_expect(r, "wnet", weights, (law) { .lsb = 0.501L, .roundings = 2 });
    expect_vec(r, "S", loft_revolve_eval(&profile, k, u, v, &p), p, 3,
               (law){ .lsb = 0.501L, .roundings = 8 * n + 16 });
}

static void skin(row *r)
{
    static loft_vec p[POINTS];
    static loft_spline_knot memory[POINTS];
    loft_real heights[KNOTS], v;
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), k = row_count(r, "k", KNOTS),
                   d = dimension(r);
    const loft_unit u = row_unit(r, "u_q16");
    const bool natural = row_is(r, "kind", "natural");
    loft_skin s;
    loft_vec out[3] = { { { 0 } } };
    enum loft_status status[3];

    if ((n + 1) * k > POINTS) {
        row_complain(r, "%u points are more than %d", (n + 1) * k, POINTS);
        return;
    }
    row_points(r, "sec_q16", (n + 1) * k, d, p);
    row_knots(r, "vp_q16", k, heights);
    row_knots(r, "v_q16", 1, &v);
    if (!as_given(r))
        return;
    if (loft_skin_init(&s, p, n, k, heights, natural ? LOFT_ENDS_NATURAL : LOFT_ENDS_NOT_A_KNOT,
                       memory) != LOFT_OK) {
        row_complain(r, "the sections were refused");
        return;
    }
    long double least = HUGE_VALL, most = 0;
    for (unsigned i = 0; i + 1 < k; i++) {
        const long double h = exact_of(heights[i + 1]) - exact_of(heights[i]);
        least = fminl(least, h);
        most = fmaxl(most, h);
    }
    /* S is at most 6 of the largest difference over the smallest step, Q the ratio of steps */
    const long double hard = most / least, slope = 12 * r->largest / least * hard * 0x1p-45L;
    status[0] = loft_skin_deriv(&s, 0, 0, u, v, &out[0]);
    status[1] = loft_skin_deriv(&s, 1, 0, u, v, &out[1]);
    status[2] = loft_skin_deriv(&s, 0, 1, u, v, &out[2]);
    expect_vec_within(r, "S", status[0], out[0], d, slope * most, 2);
    expect_vec_within(r, "Su", status[1], out[1], d, n * slope * most, 4);
    expect_vec_within(r, "Sv", status[2], out[2], d, slope, 8);
}

const vector_system vectors_weighted[] = {
    { "rational_deriv2", "n,d,P_q16,w_q16,t_q16,p,dp,ddp,status,kappa", rational_deriv2,
      "status exact, p 1/2 LSB, dp, ddp 1/2 LSB + 2^-54 D, at most 4 and 16" },
    { "nurbs_eval", "p,n,d,P_q16,w_q16,U_q16,t_q16,point,dp,ddp,status,kappa", nurbs_eval,
      "as rational_deriv2" },
    { "tri_rational_split", "n,net_q16,w_q16,u_q16,A,wA,B,wB,C,wC", tri_rational_split,
      "1/2 LSB + 2^-10 LSB" },
    { "tri_rational_elevate", "n,m,net_q16,w_q16,out,wout", tri_rational_elevate,
      "1/2 LSB + 2^-10 LSB" },
    { "tri_rational_deriv2", "n,net_q16,w_q16,u_q16,y_q16,z_q16,p,Dy,Dz,Dyz", tri_rational_deriv2,
      "p 1/2 LSB, Dy, Dz, Dyz 1/2 LSB + 2^-54 E, at most 4 and 16" },
    { "tri_rational_normal", "n,net_q16,w_q16,u_q16,status,normal,K,H", tri_rational_normal,
      "status exact, normal, K, H 1/2 LSB + their error, at most 4" },
    { "bspline_surface", "p,q,m,n,net_q16,U_q16,V_q16,u_q16,v_q16,P,Pu,Pv,status,normal,K",
      bspline_surface, "status exact, P 1/2 LSB, Pu, Pv 1/2 LSB + 2^-54 E, normal, K at most 4" },
    { "nurbs_surface", "p,q,m,n,net_q16,w_q16,U_q16,V_q16,u_q16,v_q16,P,Pu,Pv,status,normal,K",
      nurbs_surface, "as bspline_surface" },
    { "ruled", "m,n,d,A_q16,B_q16,u_q16,v_q16,net,P,Pu,Pv", ruled, "1/2 LSB + 2^-6 LSB" },
    { "revolve", "n,P_q16,w_q16,k,u_q16,v_q16,net,wnet,S", revolve,
      "net exact, wnet, S 1/2 LSB + 2^-10 LSB" },
    { "skin", "n,k,d,sec_q16,vp_q16,kind,u_q16,v_q16,S,Su,Sv", skin,
      "1/2 LSB + 2^-53 S h Q, at most 2, 4, 8" },
    { NULL, NULL, NULL, NULL }
};

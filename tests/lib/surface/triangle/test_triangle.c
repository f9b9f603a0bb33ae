/* tests/lib/surface/triangle/test_triangle.c -- properties of lib/surface/triangle/triangle.h
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"          /* arb_net_of, net_at, rows_bound */
#include "curve/bezier.h"
#include "surface/triangle/triangle.h"

#define MOST LOFT_TRIANGLE_MAX

static loft_triangle triangle_of(const arb_net *x)
{
    loft_triangle t = { 0, 0 };
    CHECK(loft_triangle_init(&t, x->p, x->n) == LOFT_OK);
    return t;
}

static loft_bary arb_point(arb *a)
{
    return arb_below(a, 3) ? arb_bary(a) : arb_far(a, 1 + (int32_t)arb_below(a, 8));
}

/* It is refused only where a value does not fit or the rows could overflow. */
static bool law_kept(long double growth) { return growth <= 19683 * 0.999L; }

static void a_point_is_within_its_bound(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    const loft_triangle t = triangle_of(x);
    const loft_bary u = arb_bary(a);
    const loft_vec v = loft_triangle_eval(&t, u);
    loft_vec w;

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = net_at(x, i, u);
        CHECK_EXACT(exact_of(v.axis[i]), want, rows_bound(x, x->n, 1, want));
    }
    CHECK(loft_triangle_extrapolate(&t, u, &w) == LOFT_OK && loft_vec_equal(v, w));
}

static void corners_are_exact_and_beyond_is_clamped(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    const loft_triangle t = triangle_of(x);
    const loft_bary corner[3] = { { 0, 0 }, { LOFT_UNIT(1), 0 }, { 0, LOFT_UNIT(1) } },
                    far = arb_far(a, 50);

    CHECK(loft_vec_equal(loft_triangle_eval(&t, corner[0]), x->p[0]));
    CHECK(loft_vec_equal(loft_triangle_eval(&t, corner[1]), x->p[loft_triangle_place(x->n, 0)]));
    CHECK(loft_vec_equal(loft_triangle_eval(&t, corner[2]), x->p[loft_triangle_place(0, x->n)]));
    CHECK(
        loft_vec_equal(loft_triangle_eval(&t, far), loft_triangle_eval(&t, loft_bary_clamp(far))));
}

static void a_point_beyond_is_within_its_bound_or_refused(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, arb_below(a, 2) ? 32767 : 100);
    const loft_triangle t = triangle_of(x);
    const loft_bary u = arb_point(a);
    const long double l = fmaxl(1, growth3(u));
    const loft_vec before = { { 7 } };
    bool all = true, none = true;
    loft_vec v = before;

    const enum loft_status status = loft_triangle_extrapolate(&t, u, &v);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = net_at(x, i, u);
        all  = all && exact_fits(want) == 1;
        none = none && exact_fits(want) != 0;
        if (status == LOFT_OK)
            CHECK_EXACT(exact_of(v.axis[i]), want,
                        rows_bound(x, x->n, l, want) + powl(l, x->n) * x->largest * 0x1p-58L);
    }
    CHECK(status == LOFT_OK ? none : status == LOFT_ERR_RANGE && !(all && law_kept(powl(l, x->n))));
    CHECK(status == LOFT_OK || loft_vec_equal(v, before));
}

/* The three points give the point. Degree times their sum with a direction is the derivative. */
static void the_tangent_plane_is_within_its_bound(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, LOFT_DEGREE_MAX, 32767);
    const loft_triangle t = triangle_of(x);
    const loft_bary u = arb_bary(a);
    static const unsigned shift[3][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
    loft_vec v[3];

    CHECK(loft_triangle_tangent(&t, u, v) == LOFT_OK);
    for (int e = 0; e < 3; e++)
        for (int i = 0; i < LOFT_AXES; i++) {
            arb_net sub = *x;
            sub.n = x->n - 1;
            for (unsigned m = 0, p = 0; m < x->n; m++)
                for (unsigned k = 0; k <= m; k++, p++)
                    sub.c[i][p] =
                        x->c[i][loft_triangle_place(m - k + shift[e][0], k + shift[e][1])];
            const long double want = net_at(&sub, i, u);
            CHECK_EXACT(exact_of(v[e].axis[i]), want, rows_bound(x, x->n - 1, 1, want));
        }
}

static void a_derivative_is_within_its_bound_or_refused(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, arb_below(a, 2) ? 32767 : 200);
    const loft_triangle t = triangle_of(x);
    const loft_bary z = arb_far(a, 2), u = arb_point(a);
    const unsigned r = arb_below(a, x->n + 2), m = r < x->n ? x->n - r : 0;
    const long double l = fmaxl(1, growth3(u)), reach = fmaxl(1, reach3(z)),
                      power = powl(reach, r) * powl(l, m);
    long double at[LOFT_DEGREE_MAX + 2][3], f = r <= x->n;
    bool all = true, none = true;
    loft_vec v;

    for (unsigned k = 0; k < x->n; k++) {
        exact_bary(k < r ? z : u, k < r, at[k]);
        f *= k < r ? x->n - k : 1;
    }
    const enum loft_status status = loft_triangle_deriv(&t, r, z, u, &v);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = r <= x->n ? f * exact_polar(x->c[i], x->n, at) : 0;
        const long double q16 = LSB / 2 + f * (sums(reach, r) * powl(l, m) + sums(l, m)) * 0x1p-33L;
        all  = all && exact_fits(want) == 1;
        none = none && exact_fits(want) != 0;
        if (status == LOFT_OK)
            CHECK_EXACT(
                exact_of(v.axis[i]), want,
                by_kind(q16, ulp(want) / 2 + 3 * f * (x->n + 1) * power * ulp_double(x->largest)) +
                    f * power * x->largest * 0x1p-58L);
    }
    CHECK(status == LOFT_OK ? none : status == LOFT_ERR_RANGE && !(all && law_kept(power)));
}

/* The normal of the exact tangent plane. The error of the edges is divided by their lengths and the
 * sine of their angle. */
static void a_normal_is_within_its_bound(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, LOFT_DEGREE_MAX, 1 << arb_below(a, 15));
    const loft_triangle t = triangle_of(x);
    const loft_bary u = arb_bary(a);
    long double e[2][3], n[3], size[3] = { 0 }, at[LOFT_DEGREE_MAX + 1][3];
    loft_vec v;

    for (int i = 0; i < 3; i++) {
        for (unsigned k = 0; k < x->n; k++)
            exact_bary(u, false, at[k]);
        for (int k = 0; k < 2; k++) {
            const loft_bary z = { k ? 0 : LOFT_UNIT(1), k ? LOFT_UNIT(1) : 0 };
            exact_bary(z, true, at[0]);
            e[k][i] = exact_polar(x->c[i], x->n, at);
            size[k] += e[k][i] * e[k][i];
        }
    }
    for (int i = 0; i < 3; i++) {
        n[i] = e[0][(i + 1) % 3] * e[1][(i + 2) % 3] - e[0][(i + 2) % 3] * e[1][(i + 1) % 3];
        size[2] += n[i] * n[i];
    }
    const long double shorter = sqrtl(fminl(size[0], size[1])),
                      s = sqrtl(size[2] / size[0] / size[1]);
    const enum loft_status status = loft_triangle_normal(&t, u, &v);
    /* too narrow to tell it from a line */
    if (!(s * shorter > x->largest * 0x1p-17L + 0x1p-10L))
        return;
    CHECK(status == LOFT_OK);
    const long double q16 = LSB / 2 + (0x1p-32L + x->n * 0x1p-31L / shorter) / s;
    const long double floats = BY_NUM(0, ulp(1) / 2, 0x1p-52L * (8 + 4 / s)) +
                               0x1p-50L * x->n * x->largest / (s * shorter);
    for (int i = 0; i < 3; i++)
        CHECK_EXACT(exact_of(v.axis[i]), n[i] / sqrtl(size[2]), by_kind(q16, floats));
    CHECK(s < 1 / 64.0L || s * shorter < 0x1p-13L || q16 < 0x1p-14L);
}

/* Symmetric: the order of the arguments does not matter. Affine: the midpoint of two arguments
 * gives the midpoint. */
static void the_polar_form_is_symmetric_and_affine(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, LOFT_DEGREE_MAX, 30000);
    const loft_triangle t = triangle_of(x);
    const loft_bary p = arb_bary(a), q = arb_bary(a);
    const unsigned times = arb_below(a, x->n + 1);
    loft_vec v, w;

    CHECK(loft_triangle_polar(&t, times, p, q, &v) == LOFT_OK &&
          loft_triangle_polar(&t, x->n - times, q, p, &w) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(w.axis[i]),
                    BY_NUM(LSB, ulp(x->largest), 6 * x->n * ulp(x->largest)));

    const loft_bary ends[2] = { { 0, 0 }, { LOFT_UNIT(0.5), LOFT_UNIT(0.25) } },
                    middle = { LOFT_UNIT(0.25), LOFT_UNIT(0.125) };
    loft_vec y[2];
    CHECK(loft_triangle_polar(&t, 1, middle, p, &v) == LOFT_OK);
    CHECK(loft_triangle_polar(&t, 1, ends[0], p, &y[0]) == LOFT_OK &&
          loft_triangle_polar(&t, 1, ends[1], p, &y[1]) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), (exact_of(y[0].axis[i]) + exact_of(y[1].axis[i])) / 2,
                    BY_NUM(1.01L * LSB, ulp(x->largest), 6 * x->n * ulp(x->largest)));
    CHECK(loft_triangle_polar(&t, x->n + 1, p, q, &v) == LOFT_ERR_ARG);
}

/* Control points of the line, against polar forms, and the curve against the surface. */
static void a_line_is_within_its_bound_and_on_the_surface(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    const loft_triangle t = triangle_of(x);
    const loft_bary from = arb_bary(a), to = arb_bary(a);
    const loft_unit s = loft_unit_of(1, 4);
    loft_vec out[LOFT_DEGREE_MAX + 1];
    long double at[LOFT_DEGREE_MAX + 1][3], own[LOFT_DEGREE_MAX + 1];

    CHECK(loft_triangle_line(&t, from, to, out) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k <= x->n; k++) {
            for (unsigned r = 0; r < x->n; r++)
                exact_bary(r < k ? to : from, false, at[r]);
            const long double want = exact_polar(x->c[i], x->n, at);
            CHECK_EXACT(exact_of(out[k].axis[i]), want, rows_bound(x, x->n, 1, want));
            own[k] = exact_of(out[k].axis[i]);
        }
        for (unsigned r = 0; r < x->n; r++) {
            long double p[3], q[3];
            exact_bary(from, false, p);
            exact_bary(to, false, q);
            for (int e = 0; e < 3; e++)
                at[r][e] = p[e] + exact_unit(s) * (q[e] - p[e]);
        }
        CHECK_EXACT(exact_eval(own, x->n, exact_unit(s)), exact_polar(x->c[i], x->n, at),
                    rows_bound(x, x->n, 1, x->largest));
    }
}

static void edges_are_curves_of_the_surface(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    const loft_triangle t = triangle_of(x);
    const loft_unit s = arb_unit(a), rest = LOFT_UNIT(1) - s;
    const loft_bary at[3] = { { rest, s }, { 0, rest }, { s, 0 } };
    loft_vec out[LOFT_DEGREE_MAX + 1];
    loft_bezier b;

    for (unsigned side = 0; side < 3; side++) {
        loft_triangle_edge(&t, side, out);
        CHECK(loft_bezier_init(&b, out, x->n) == LOFT_OK);
        const loft_vec v = loft_bezier_eval(&b, s), w = loft_triangle_eval(&t, at[side]);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(exact_of(v.axis[i]), exact_of(w.axis[i]),
                        BY_NUM(LSB, 2 * ulp(x->largest), 6 * x->n * ulp(x->largest)));
    }
}

static void points_lie_in_the_box(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    const loft_triangle t = triangle_of(x);
    const loft_vec v = loft_triangle_eval(&t, arb_bary(a));
    const loft_box box = loft_triangle_box(&t);

    for (int i = 0; i < LOFT_AXES; i++) {
        CHECK(exact_of(v.axis[i]) >=
              exact_of(box.min.axis[i]) - BY_NUM(0, ulp(x->largest), 3 * x->n * ulp(x->largest)));
        CHECK(exact_of(v.axis[i]) <=
              exact_of(box.max.axis[i]) + BY_NUM(0, ulp(x->largest), 3 * x->n * ulp(x->largest)));
    }
}

/* The image of the net under x -> x + y / 2 + d is the image of the point. */
static void affine_maps_move_points_with_the_net(arb *a)
{
    arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 10000);
    const loft_triangle t = triangle_of(x);
    const loft_bary u = arb_bary(a);
    const loft_real shift = LOFT_REAL(1234.5);
    loft_vec moved[MOST];
    loft_triangle other;

    for (unsigned k = 0; k < x->count; k++) {
        moved[k] = x->p[k];
        moved[k].axis[0] = x->p[k].axis[0] + 2 * x->p[k].axis[1] + shift;
    }
    CHECK(loft_triangle_init(&other, moved, x->n) == LOFT_OK);
    const loft_vec v = loft_triangle_eval(&t, u), w = loft_triangle_eval(&other, u);
    const long double size = 3 * x->largest + 1235;
    CHECK_EXACT(exact_of(w.axis[0]),
                exact_of(v.axis[0]) + 2 * exact_of(v.axis[1]) + exact_of(shift),
                by_kind(2.01L * LSB, 8 * (x->n + 1) * ulp(size)));
}

static void nonsense_is_refused(arb *a)
{
    arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    loft_triangle t = { 0, 77 };
    loft_vec v[3];

    CHECK(loft_triangle_init(&t, x->p, LOFT_DEGREE_MAX + 1) == LOFT_ERR_ARG);
    if (BY_NUM(false, true, true)) {
        x->p[arb_below(a, x->count)].axis[1] = (loft_real)BY_NUM(0, NAN, INFINITY);
        CHECK(loft_triangle_init(&t, x->p, x->n) == LOFT_ERR_RANGE);
    }
    CHECK(t.degree == 77);
    const loft_vec p = { { 1 } };
    const loft_bary u = { 0, 0 };
    CHECK(loft_triangle_init(&t, &p, 0) == LOFT_OK &&
          loft_triangle_tangent(&t, u, v) == LOFT_ERR_ARG);
    CHECK(loft_triangle_normal(&t, u, v) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound,                   8000);
    PROPERTY(corners_are_exact_and_beyond_is_clamped,        2000);
    PROPERTY(a_point_beyond_is_within_its_bound_or_refused, 8000);
    PROPERTY(the_tangent_plane_is_within_its_bound,          2000);
    PROPERTY(a_derivative_is_within_its_bound_or_refused,   8000);
    PROPERTY(a_normal_is_within_its_bound,                  4000);
    PROPERTY(the_polar_form_is_symmetric_and_affine,        4000);
    PROPERTY(a_line_is_within_its_bound_and_on_the_surface,  2000);
    PROPERTY(edges_are_curves_of_the_surface,                2000);
    PROPERTY(points_lie_in_the_box,                         4000);
    PROPERTY(affine_maps_move_points_with_the_net,          4000);
    PROPERTY(nonsense_is_refused,                            400);
    return check_failures();
}

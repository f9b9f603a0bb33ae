/* tests/lib/surface/triangle/test_triangle_rational.c -- properties of
 * lib/surface/triangle/triangle_rational.h and lib/surface/octant.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_sci.h"          /* exact_sci */
#include "support/rationals.h"          /* arb_weight */
#include "support/triangles.h"          /* arb_net_of, exact_polar */
#include "surface/differential.h"
#include "surface/octant.h"
#include "surface/triangle/triangle.h"
#include "surface/triangle/triangle_rational.h"

#define MOST LOFT_TRIANGLE_MAX

typedef struct {
    const arb_net *net;
    loft_weighted p[MOST];
    loft_triangle_rational t;
    long double x[LOFT_AXES][MOST], w[MOST], ratio;
} sheet;

static sheet *arb_sheet(arb *a, unsigned least)
{
    static sheet s;
    const arb_net *net = s.net = arb_net_of(a, least, LOFT_DEGREE_MAX, 32767);
    const uint32_t kind = arb_below(a, 6);
    long double light = 256, heavy = 0;

    for (unsigned k = 0; k < net->count; k++) {
        s.p[k].p = net->p[k];
        s.p[k].w = arb_weight(a, kind, k);
        s.w[k] = exact_of(s.p[k].w);
        light = fminl(light, s.w[k]);
        heavy = fmaxl(heavy, s.w[k]);
        for (int i = 0; i < LOFT_AXES; i++)
            s.x[i][k] = net->c[i][k] * s.w[k];
    }
    s.ratio = heavy / light;
    CHECK(loft_triangle_rational_init(&s.t, s.p, net->n) == LOFT_OK);
    return &s;
}

static long double value(const long double c[], unsigned n, loft_bary u, const loft_bary *z)
{
    long double at[LOFT_DEGREE_MAX + 1][3];

    for (unsigned k = 0; k < n; k++)
        exact_bary(u, false, at[k]);
    if (z)
        exact_bary(*z, true, at[0]);
    return exact_polar(c, n, at);
}

static void a_point_is_within_its_bound(arb *a)
{
    const sheet *s = arb_sheet(a, 0);
    const unsigned n = s->net->n;
    const loft_bary u = arb_bary(a);
    const loft_vec v = loft_triangle_rational_eval(&s->t, u);

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = value(s->x[i], n, u, 0) / value(s->w, n, u, 0),
                          size = s->net->largest;
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    by_kind(LSB / 2 + n * s->ratio * LSB / 1073741824 + 0x1p-43L,
                            ulp(want) / 2 + (6 * n + 4) * ulp_double(size)));
    }
    const loft_bary far = arb_far(a, 40);
    CHECK(loft_vec_equal(loft_triangle_rational_eval(&s->t, far),
                         loft_triangle_rational_eval(&s->t, loft_bary_clamp(far))));
}

static void equal_weights_give_the_polynomial(arb *a)
{
    sheet *s = arb_sheet(a, 0);
    const loft_bary u = arb_bary(a), z = arb_far(a, 2);
    const unsigned n = s->net->n;
    loft_triangle t;
    loft_vec d, e;

    for (unsigned k = 0; k < s->net->count; k++)
        s->p[k].w = s->p[0].w;
    CHECK(loft_triangle_init(&t, s->net->p, n) == LOFT_OK &&
          loft_triangle_rational_init(&s->t, s->p, n) == LOFT_OK);
    const loft_vec v = loft_triangle_rational_eval(&s->t, u), w = loft_triangle_eval(&t, u);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(w.axis[i]),
                    BY_NUM(LSB, ulp(s->net->largest), (9 * n + 4) * ulp(s->net->largest)));
    if (loft_triangle_deriv(&t, 1, z, u, &d) == LOFT_OK &&
        loft_triangle_rational_deriv(&s->t, z, u, &e) == LOFT_OK)
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(
                exact_of(d.axis[i]), exact_of(e.axis[i]),
                BY_NUM(1.01L * LSB, ulp(exact_of(d.axis[i])) + ulp(s->net->largest),
                       40 * (n + 1) * (n + 1) * fmaxl(1, reach3(z)) * ulp(s->net->largest)));
}

static void a_derivative_is_within_its_bound_or_refused(arb *a)
{
    const sheet *s = arb_sheet(a, 0);
    const unsigned n = s->net->n;
    const loft_bary u = arb_bary(a), z = arb_far(a, 2);
    const long double steep = n * reach3(z) * s->ratio;
    bool all = true, none = true;
    loft_vec v;

    const enum loft_status status = loft_triangle_rational_deriv(&s->t, z, u, &v);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double w = value(s->w, n, u, 0), x = value(s->x[i], n, u, 0);
        const long double want =
            n ? n * (value(s->x[i], n, u, &z) * w - x * value(s->w, n, u, &z)) / (w * w) : 0;
        /* of the reference: 64 bits, two terms */
        const long double own = steep * s->net->largest * 0x1p-54L;
        all  = all && exact_fits(want) == 1;
        none = none && exact_fits(want) != 0;
        if (status == LOFT_OK)
            CHECK_EXACT(
                exact_of(v.axis[i]), want,
                by_kind(LSB / 2 + (n + 1) * steep * LSB / 67108864,
                        ulp(want) / 2 + 16 * (n + 1) * steep * ulp_double(s->net->largest)) +
                    own);
    }
    CHECK(status == LOFT_OK ? none : status == LOFT_ERR_RANGE && !all);
    CHECK(loft_triangle_rational_deriv(&s->t, z, (loft_bary){ -LOFT_UNIT(0.001), 0 }, &v) ==
          LOFT_ERR_ARG);
}

/* A derivative of the polynomial c, order[0] times toward T2 and order[1] times toward T3, and the
 * largest coefficient of its net. */
static long double slope(const long double c[], unsigned n, loft_bary at, const uint8_t order[2],
                         long double *width)
{
    const unsigned a = order[0], b = order[1];
    static const long double to[2][3] = { { -1, 1, 0 }, { -1, 0, 1 } };
    long double x[LOFT_DEGREE_MAX + 1][3], factor = 1;

    *width = 0;
    if (a + b > n)
        return 0;
    for (unsigned k = 0; k < n; k++) {
        exact_bary(at, false, x[k]);
        for (int i = 0; i < 3 && k < a + b; i++)
            x[k][i] = to[k >= a][i];
        factor *= k < a + b ? n - k : 1;
    }
    const long double value = factor * exact_polar(c, n, x);
    for (unsigned corner = 0; corner < LOFT_TRIANGLE_POINTS(n - a - b); corner++) {
        long double d[MOST];
        for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(n); k++)
            d[k] = c[k];
        for (unsigned m = 0; m < a + b; m++)
            for (unsigned row = 0, k = 0; row < n - m; row++)
                for (unsigned j = 0; j <= row; j++, k++)
                    d[k] = d[k + row + 1 + (m >= a)] - d[k];
        *width = fmaxl(*width, factor * fabsl(d[corner]));
    }
    return value;
}

/* The point is the origin, so the rest of the numerator there is the rounding of the point. */
static void local_derivatives_keep_their_law(arb *a)
{
    static const uint8_t order[5][2] = { { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } };
    const sheet *s = arb_sheet(a, 0);
    const unsigned n = s->net->n;
    const loft_bary u = arb_bary(a);
    const loft_vec o = loft_triangle_rational_eval(&s->t, u);
    const long double law = 2 * s->ratio * (n + 2) * BY_NUM(0x1p-59L, 0x1p-50L, 0x1p-50L);
    const long double tiny = 0x1p-62L * s->net->largest * s->ratio * n;     /* of the reference */
    long double x[MOST], d[5], width[5], widths[2] = { 0, 0 }, none;
    loft_differential here;

    const loft_bary outside = { -LOFT_UNIT(0.001), 0 };
    CHECK(loft_triangle_rational_differential(&s->t, outside, &here) == LOFT_ERR_ARG);
    CHECK(loft_triangle_rational_differential(&s->t, u, &here) == LOFT_OK);
    const long double width_u = exact_sci(here.width_u), width_v = exact_sci(here.width_v);
    const long double steep = 2 * s->ratio * n * fmaxl(width_u, width_v), w = value(s->w, n, u, 0);
    for (int k = 0; k < 5; k++)
        d[k] = slope(s->w, n, u, order[k], &none);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k < s->net->count; k++)
            x[k] = (s->net->c[i][k] - exact_of(o.axis[i])) * s->w[k];
        const long double p = value(x, n, u, 0) / w;
        long double want[5];
        for (int k = 0; k < 5; k++) {
            want[k] = (slope(x, n, u, order[k], &width[k]) - p * d[k]) / w;
            width[k] /= w;
        }
        want[2] -= 2 * want[0] * d[0] / w;
        want[3] -= (want[0] * d[1] + want[1] * d[0]) / w;
        want[4] -= 2 * want[1] * d[1] / w;
        CHECK_EXACT(exact_sci(here.u[i]), want[0], law * width_u + tiny);
        CHECK_EXACT(exact_sci(here.v[i]), want[1], law * width_v + tiny);
        CHECK_EXACT(exact_sci(here.uu[i]), want[2], law * (width[2] + steep) + tiny * n);
        CHECK_EXACT(exact_sci(here.uv[i]), want[3], law * (width[3] + steep) + tiny * n);
        CHECK_EXACT(exact_sci(here.vv[i]), want[4], law * (width[4] + steep) + tiny * n);
        for (int k = 0; k < 2; k++)
            widths[k] = fmaxl(widths[k], width[k]);
    }
    CHECK_EXACT(width_u, widths[0], 1e-9L * widths[0]);
    CHECK_EXACT(width_v, widths[1], 1e-9L * widths[1]);
}

/* The normal points outward, so the sphere curves away from it. */
static void the_octant_bends_as_its_sphere(arb *a)
{
    const loft_real r = loft_real_from_int(1 + (int32_t)arb_below(a, 500));
    const loft_bary u = arb_bary(a);
    const long double size = exact_of(r);
    loft_vec n = { { 0 } };
    loft_weighted p[15];
    loft_triangle_rational t;
    loft_curvatures k;
    loft_differential here;

    CHECK(loft_octant_from_radius(r, p) == LOFT_OK);
    CHECK(loft_triangle_rational_init(&t, p, 4) == LOFT_OK);
    CHECK(loft_triangle_rational_differential(&t, u, &here) == LOFT_OK);
    CHECK(loft_differential_normal(&here, &n) == LOFT_OK &&
          loft_differential_curvatures(&here, &k) == LOFT_OK);
    const loft_vec v = loft_triangle_rational_eval(&t, u);
    /* Points and weights of the net are rounded: slopes are off by 24 times as much. */
    const long double off = BY_NUM(24 * 0x1p-15L / size + 24 * 0x1p-20L, 0x1p-18L, 0x1p-44L);
    for (int i = 0; i < 3; i++)
        CHECK_EXACT(exact_of(n.axis[i]), exact_of(v.axis[i]) / size,
                    off + BY_NUM(LSB, 0x1p-24L, 0));
    CHECK_EXACT(exact_acc(k.min), -1 / size, 20 * off / size);
    CHECK_EXACT(exact_acc(k.max), -1 / size, 20 * off / size);
}

static void nonsense_is_refused(arb *a)
{
    sheet *s = arb_sheet(a, 0);
    loft_triangle_rational t = { 0, 0, 77 };
    loft_weighted octant[15];
    const unsigned k = arb_below(a, s->net->count);
    const loft_real bad[3] = { 0, -1, LOFT_REAL(257) };

    CHECK(loft_triangle_rational_init(&t, s->p, LOFT_DEGREE_MAX + 1) == LOFT_ERR_ARG);
    s->p[k].w = bad[arb_below(a, 3)];
    CHECK(loft_triangle_rational_init(&t, s->p, s->net->n) == LOFT_ERR_RANGE && t.degree == 77);
    CHECK(loft_octant_from_radius(-1, octant) == LOFT_ERR_RANGE);
}

/* x^2 + y^2 + z^2 = 1, and the symmetry of the corners. */
static void the_octant_is_on_the_sphere(arb *a)
{
    const loft_bary u = arb_bary(a);
    const loft_vec v = loft_octant_eval(u),
                   turned = loft_octant_eval((loft_bary){ u.w, LOFT_UNIT(1) - u.v - u.w });
    long double sum = 0;

    for (int i = 0; i < 3; i++) {
        sum += exact_of(v.axis[i]) * exact_of(v.axis[i]);
        CHECK(exact_of(v.axis[i]) >= -BY_NUM(0, 0x1p-24L, 0x1p-47L));
        CHECK_EXACT(exact_of(v.axis[(i + 1) % 3]), exact_of(turned.axis[i]),
                    BY_NUM(0, 4 * ulp(1), 64 * ulp(1)));
    }
    CHECK_EXACT(sqrtl(sum), 1, by_kind((0.87L + LSB) * LSB, BY_NUM(0, ulp(1), 0x1p-46L)));
}

static void its_net_is_a_sphere_of_the_radius(arb *a)
{
    const loft_real r = loft_real_from_int(1 + (int32_t)arb_below(a, 32766));
    const loft_bary u = arb_bary(a);
    const long double size = exact_of(r);
    loft_triangle_rational t;
    loft_weighted p[15];
    long double sum = 0;

    CHECK(loft_octant_from_radius(r, p) == LOFT_OK &&
          loft_triangle_rational_init(&t, p, 4) == LOFT_OK);
    const loft_vec v = loft_triangle_rational_eval(&t, u);
    for (int i = 0; i < 3; i++)
        sum += exact_of(v.axis[i]) * exact_of(v.axis[i]);
    CHECK_EXACT(sqrtl(sum), size,
                by_kind(1.5L * LSB + size * 0x1p-22L, size * BY_NUM(0, 0x1p-22L, 0x1p-46L)));
}

/* Pieces: at the place that a point of the piece has in the whole, both surfaces agree. */
static void pieces_are_the_same_surface(arb *a)
{
    static loft_weighted out[3][MOST];
    const sheet *s = arb_sheet(a, 0);
    const loft_bary u = { loft_unit_of(1 + arb_below(a, 3), 8),
                          loft_unit_of(1 + arb_below(a, 4), 8) };
    const loft_bary in = { loft_unit_of(arb_below(a, 5), 8), loft_unit_of(arb_below(a, 4), 8) };
    const long double iv = exact_unit(in.v), iw = exact_unit(in.w), iu = 1 - iv - iw;
    const long double pv = exact_unit(u.v), pw = exact_unit(u.w);

    CHECK(loft_triangle_rational_split(&s->t, u, out[0], out[1], out[2]) == LOFT_OK);
    for (unsigned k = 0; k < 3; k++) {
        const long double v = k == 0   ? iu * pv + iv
                              : k == 1 ? iv * pv
                                       : iv + iw * pv,
                          w = k == 0   ? iu * pw + iw
                              : k == 1 ? iv * pw + iw
                                       : iw * pw;
        const loft_bary whole = { BY_NUM((loft_unit)(v * 16777216), (loft_unit)v, (loft_unit)v),
                                  BY_NUM((loft_unit)(w * 16777216), (loft_unit)w, (loft_unit)w) };
        loft_triangle_rational part;
        if (loft_triangle_rational_init(&part, out[k], s->net->n) != LOFT_OK || s->ratio > 16)
            continue;
        const loft_vec one = loft_triangle_rational_eval(&part, in),
                       two = loft_triangle_rational_eval(&s->t, whole);
        /* the weights of the piece are rounded by 1/2 LSB, 2^-17 of 1 / 256 * ratio and more */
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(exact_of(one.axis[i]), exact_of(two.axis[i]),
                        BY_NUM(2 * LSB + 0x1p-16L * 65536 / exact_of(out[k][0].w) * s->ratio,
                               64 * 65536 * s->ratio * 0x1p-24L,
                               256 * 65536 * s->ratio * 0x1p-53L));
    }
}

static void raised_nets_are_the_same_surface(arb *a)
{
    static loft_weighted out[MOST];
    const sheet *s = arb_sheet(a, 0);
    const unsigned times = arb_below(a, LOFT_DEGREE_MAX - s->net->n + 1);
    const loft_bary u = arb_bary(a);
    loft_triangle_rational raised;

    CHECK(loft_triangle_rational_elevate(&s->t, times, out) == LOFT_OK);
    if (loft_triangle_rational_init(&raised, out, s->net->n + times) != LOFT_OK)
        return;
    const loft_vec one = loft_triangle_rational_eval(&raised, u),
                   two = loft_triangle_rational_eval(&s->t, u);
    for (int i = 0; i < LOFT_AXES && s->ratio <= 16; i++)
        CHECK_EXACT(exact_of(one.axis[i]), exact_of(two.axis[i]),
                    BY_NUM(2 * LSB + 0x1p-16L * 65536 * 256, 256 * 65536 * s->ratio * 0x1p-24L,
                           256 * 65536 * s->ratio * 0x1p-53L));
    CHECK(loft_triangle_rational_elevate(&s->t, LOFT_ELEVATE_MAX + 1, out) == LOFT_ERR_ARG);
}

/* The mixed derivative is bilinear, so those of surface/differential.h make all others. */
static void second_derivatives_are_those_along_the_sides(arb *a)
{
    const sheet *s = arb_sheet(a, 0);
    const loft_bary u = arb_bary(a), y = { LOFT_UNIT(0.5), LOFT_UNIT(-0.75) },
                    z = { LOFT_UNIT(1), LOFT_UNIT(0.25) };
    loft_differential d;
    loft_vec v = { { 0 } };

    CHECK(loft_triangle_rational_differential(&s->t, u, &d) == LOFT_OK);
    if (loft_triangle_rational_deriv2(&s->t, y, z, u, &v) != LOFT_OK || s->ratio > 1024)
        return;
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = 0.5L * exact_sci(d.uu[i]) - 0.1875L * exact_sci(d.vv[i]) +
                                 (0.125L - 0.75L) * exact_sci(d.uv[i]);
        const long double scale = powl(s->net->n * s->ratio, 2) * 65536 * 16;
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    ulp(want) / 2 + BY_NUM(LSB / 1024, 0, 0) +
                        scale * BY_NUM(0x1p-55L, 0x1p-47L, 0x1p-47L));
    }
}

/* Nets that collapse to a line have no tangent plane; others have one but by chance. */
static void collapsed_nets_are_not_regular(arb *a)
{
    const sheet *s = arb_sheet(a, 1);
    loft_weighted p[MOST];
    loft_triangle_rational t;
    const loft_bary u = arb_bary(a);

    for (unsigned k = 0; k < s->net->count; k++) {
        const int32_t at = (int32_t)arb_below(a, 1000);
        p[k] = s->p[k];
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].p.axis[i] = loft_real_from_raw(at * (3 + 7 * i));
    }
    CHECK(loft_triangle_rational_init(&t, p, s->net->n) == LOFT_OK);
    CHECK(!loft_triangle_rational_regular(&t, u));
    if (LOFT_AXES < 3)
        return;
    for (unsigned k = 0; k < s->net->count; k++)        /* a plane, 1 LSB from a line */
        p[k].p = (loft_vec) { { loft_real_from_raw((int32_t)k * 1000) } };
    p[0].p.axis[1] = loft_real_from_raw(1);
    CHECK(loft_triangle_rational_init(&t, p, s->net->n) == LOFT_OK);
    CHECK(loft_triangle_rational_regular(&t, (loft_bary) { LOFT_UNIT(0.25), LOFT_UNIT(0.25) }));
    CHECK(!loft_triangle_rational_regular(&t, (loft_bary) { LOFT_UNIT(1), LOFT_UNIT(1) }));
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound,                    6000);
    PROPERTY(equal_weights_give_the_polynomial,               1200);
    PROPERTY(a_derivative_is_within_its_bound_or_refused,     1600);
    PROPERTY(local_derivatives_keep_their_law,                2000);
    PROPERTY(the_octant_bends_as_its_sphere,                  400);
    PROPERTY(nonsense_is_refused,                             400);
    PROPERTY(the_octant_is_on_the_sphere,                     400);
    PROPERTY(its_net_is_a_sphere_of_the_radius,              4000);
    PROPERTY(pieces_are_the_same_surface,                    500);
    PROPERTY(raised_nets_are_the_same_surface,               500);
    PROPERTY(second_derivatives_are_those_along_the_sides,   300);
    PROPERTY(collapsed_nets_are_not_regular,                 100);
    return check_failures();
}

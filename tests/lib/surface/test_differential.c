/* tests/lib/surface/test_differential.c -- properties of lib/surface/differential.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"              /* CHECK, PROPERTY, BY_NUM */
#include "surface/differential.h"
#include "support/tensors.h"    /* tensor_fill, tensor_exact */

typedef struct {
    /* share: W */
    long double u[3], v[3], uu[3], uv[3], vv[3], n[3], width_u, width_v, width_2, share;
} reference;

static long double dot(const long double x[3], const long double y[3])
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

static void finish(reference *r)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        r->n[i] = r->u[j] * r->v[k] - r->u[k] * r->v[j];
    }
    r->share = r->width_u * r->width_v > 0 ? sqrtl(dot(r->n, r->n)) / (r->width_u * r->width_v) : 0;
}

/* The largest coefficient of a derivative of the net. */
static long double width_of(const loft_tensor *s, unsigned a, unsigned b)
{
    long double most = 0, factor = 1;

    if (a > s->m || b > s->n)
        return 0;
    for (unsigned k = 0; k < a; k++)
        factor *= s->m - k;
    for (unsigned k = 0; k < b; k++)
        factor *= s->n - k;
    for (unsigned i = 0; i + a <= s->m; i++)
        for (unsigned j = 0; j + b <= s->n; j++)
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                static const int choose[3][3] = { { 1, 0, 0 }, { -1, 1, 0 }, { 1, -2, 1 } };
                long double sum = 0;
                for (unsigned k = 0; k <= a; k++)
                    for (unsigned l = 0; l <= b; l++)
                        sum += choose[a][k] * choose[b][l] *
                               exact_of(s->p[(i + k) * (s->n + 1u) + j + l].axis[axis]);
                most = fmaxl(most, fabsl(sum) * factor);
            }
    return most;
}

static reference tensor_reference(const loft_tensor *s, loft_unit u, loft_unit v)
{
    const long double x = exact_unit(u), y = exact_unit(v);
    reference r;

    for (int i = 0; i < 3; i++) {
        r.u[i]  = tensor_exact(s, i, 1, 0, x, y);
        r.v[i]  = tensor_exact(s, i, 0, 1, x, y);
        r.uu[i] = tensor_exact(s, i, 2, 0, x, y);
        r.uv[i] = tensor_exact(s, i, 1, 1, x, y);
        r.vv[i] = tensor_exact(s, i, 0, 2, x, y);
    }
    r.width_u = width_of(s, 1, 0);
    r.width_v = width_of(s, 0, 1);
    r.width_2 = width_of(s, 2, 0) + 2 * width_of(s, 1, 1) + width_of(s, 0, 2);
    finish(&r);
    return r;
}

/* Patches wide and narrow, down to a few LSB, some of them far from the origin; degrees to 9. */
static tensor *arb_surface(arb *a)
{
    static tensor x;
    const int32_t limit = (int32_t)1 << arb_below(a, 30);
    const unsigned m = 1 + arb_below(a, LOFT_DEGREE_MAX), n = 1 + arb_below(a, LOFT_DEGREE_MAX);
    const int32_t far = arb_below(a, 2) ? arb_raw(a, 1000000000) : 0;

    tensor_fill(&x, a, arb_below(a, 2) ? 2 : m, arb_below(a, 2) ? 2 : n);
    if (arb_below(a, 8))
        for (unsigned k = 0; k < (x.m + 1) * (x.n + 1); k++)
            for (int i = 0; i < LOFT_AXES; i++) {
                const int64_t place = i == 0   ? k / (x.n + 1) * (int64_t)limit
                                      : i == 1 ? k % (x.n + 1) * (int64_t)limit
                                               : 0;
                const int64_t raw = far / 2 + place / 10 +
                                    arb_raw(a, limit) / (arb_below(a, 2) ? 30 : 1);
                x.p[k].axis[i] = (loft_real)BY_NUM(raw, (double)raw / 65536, (double)raw / 65536);
            }
    return &x;
}

#define ROUNDINGS BY_NUM(0x1p-52L, 0x1p-46L, 0x1p-46L)

static void check_normal(const loft_differential *at, const reference *r, unsigned rows)
{
    loft_vec n = { { 0 } };
    const enum loft_status status = loft_differential_normal(at, &n);

    if (r->share > 0x1p-29L)
        CHECK(status == LOFT_OK);
    if (r->share < 0x1p-31L)
        CHECK(status == LOFT_SINGULAR);
    for (int i = 0; i < 3 && status == LOFT_OK; i++)
        CHECK_EXACT(exact_of(n.axis[i]), r->n[i] / sqrtl(dot(r->n, r->n)),
                    BY_NUM(LSB / 2, 0x1p-25L, 0) + ROUNDINGS * rows / r->share);
}

static void a_normal_is_within_its_bound_or_there_is_none(arb *a)
{
    const tensor *x = arb_surface(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const reference r = tensor_reference(&x->s, u, v);
    loft_differential at;

    CHECK(loft_tensor_differential(&x->s, u, v, &at) == LOFT_OK);
    check_normal(&at, &r, x->m + x->n);
}

/* The principal curvatures as roots of the characteristic polynomial, from the fundamental
 * forms. */
static void check_curvatures(const loft_differential *at, const reference *r, unsigned rows)
{
    const long double e = dot(r->u, r->u), f = dot(r->u, r->v), g = dot(r->v, r->v),
                      square = dot(r->n, r->n), d = sqrtl(square);
    const long double l = dot(r->uu, r->n) / d, m = dot(r->uv, r->n) / d, n = dot(r->vv, r->n) / d;
    const long double gauss = (l * n - m * m) / square,
                      mean = (e * n - 2 * f * m + g * l) / (2 * square);
    const long double s = r->width_2 * fmaxl(e, g) / square,
                      err = BY_NUM(0x1p-50L, 0x1p-44L, 0x1p-44L) * rows / r->share;
    const long double apart = sqrtl(fmaxl(mean * mean - gauss, 0));
    loft_curvatures k;

    if (!(r->share > 0x1p-24L))
        return;
    const enum loft_status status = loft_differential_curvatures(at, &k);
    if (status == LOFT_ERR_RANGE) {
        CHECK(BY_NUM(s > 1e4L, 0, 0));
        return;
    }
    CHECK(status == LOFT_OK);
    const long double grain = BY_NUM(0x1p-32L, 0, 0);
    CHECK_EXACT(exact_acc(k.gauss), gauss, grain + err * s * s);
    CHECK_EXACT(exact_acc(k.mean), mean, grain + err * s);
    CHECK_EXACT((exact_acc(k.max) + exact_acc(k.min)) / 2, mean, grain + err * s);
    /* the reference loses the difference of two equal curvatures: compare its square */
    const long double half = (exact_acc(k.max) - exact_acc(k.min)) / 2;
    CHECK(half >= 0);
    CHECK_EXACT(half * half, apart * apart,
                (grain + err * s) * (2 * half + grain + err * s) + 0x1p-58L * s * s / r->share);
}

static void curvatures_are_within_their_bounds(arb *a)
{
    const tensor *x = arb_surface(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const reference r = tensor_reference(&x->s, u, v);
    loft_differential at;

    CHECK(loft_tensor_differential(&x->s, u, v, &at) == LOFT_OK);
    check_curvatures(&at, &r, x->m + x->n);
}

/* The tangents in the orthonormal basis along u, turned by the angle of the matrix a b / b c. */
static void directions_are_those_of_the_form(arb *a)
{
    const tensor *x = arb_surface(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const reference r = tensor_reference(&x->s, u, v);
    const long double e = dot(r.u, r.u), f = dot(r.u, r.v) / e, square = dot(r.n, r.n);
    loft_differential at;
    loft_vec d[2];

    CHECK(loft_tensor_differential(&x->s, u, v, &at) == LOFT_OK);
    if (r.share < 0x1p-6L)
        return;
    const long double uu = dot(r.uu, r.n), uv = dot(r.uv, r.n), vv = dot(r.vv, r.n),
                      lean = uv - f * uu, aa = uu / (e * sqrtl(square)), bb = lean / square,
                      cc = (vv - f * uv - f * lean) * e / (square * sqrtl(square)),
                      spread = hypotl((aa - cc) / 2, bb), turn = atan2l(bb, (aa - cc) / 2) / 2;
    const long double bend = r.width_2 * powl(fmaxl(r.width_u, r.width_v), 2) / square;
    if (!(spread > 0x1p-16L * bend))
        return;
    CHECK(loft_differential_directions(&at, d) == LOFT_OK);
    for (int k = 0; k < 2; k++) {
        const long double angle = turn + (k == 0 ? 1.57079632679489661923L : 0);
        long double want[3], got[3], both = 0;
        for (int i = 0; i < 3; i++) {
            want[i] = cosl(angle) * r.u[i] / sqrtl(e) +
                      sinl(angle) * (r.v[i] - f * r.u[i]) * sqrtl(e / square);
            got[i] = exact_of(d[k].axis[i]);
            both += want[i] * got[i];
        }
        for (int i = 0; i < 3; i++)
            CHECK_NEAR(got[i], both < 0 ? -want[i] : want[i],
                       BY_NUM(LSB / 2 + 0x1p-28L, 0x1p-24L, 0x1p-40L / r.share));
    }
}

/* A sphere has all directions; a cylinder those along and around. */
static void equal_curvatures_have_no_directions(arb *a)
{
    const loft_real one = LOFT_REAL(1), r = loft_real_from_int(1 + (int32_t)arb_below(a, 200));
    const loft_weighted net[6] = { { { { r, 0, 0 } }, one }, { { { r, 0, r } }, one },
                                   { { { r, r, 0 } }, one }, { { { r, r, r } }, one },
                                   { { { 0, r, 0 } }, 2 * one }, { { { 0, r, r } }, 2 * one } };
    loft_tensor_rational s;
    loft_differential at;
    loft_vec d[2];

    CHECK(loft_tensor_rational_init(&s, net, 2, 1) == LOFT_OK);
    CHECK(loft_tensor_rational_differential(&s, arb_unit(a), arb_unit(a), &at) == LOFT_OK);
    CHECK(loft_differential_directions(&at, d) == LOFT_OK);
    CHECK_NEAR(fabsl(exact_of(d[1].axis[2])), 1, BY_NUM(LSB, 0x1p-20L, 0x1p-40L));
    CHECK_NEAR(exact_of(d[0].axis[2]), 0, BY_NUM(LSB, 0x1p-20L, 0x1p-40L));
    for (int i = 0; i < LOFT_AXES; i++)                 /* as over z = (x^2 + y^2) / 2 */
        at.u[i] = at.v[i] = at.uu[i] = at.uv[i] = at.vv[i] = loft_sci_zero();
    at.u[0] = at.v[1] = at.uu[2] = at.vv[2] = at.width_u = at.width_v = loft_sci_one();
    CHECK(loft_differential_directions(&at, d) == LOFT_SINGULAR);
}

/* A triangle of degree n that represents a form of degree 2 or higher: derivatives against
 * differences of its values. */
static void a_triangle_bends_as_the_patch_it_is_cut_from(arb *a)
{
    static tensor x;
    loft_vec b[6];
    loft_triangle t;
    loft_differential one, two;
    const loft_bary at = { loft_unit_of(arb_below(a, 9), 16), loft_unit_of(arb_below(a, 9), 16) };
    loft_curvatures k, l;

    /* b(u, v) = p + q u + r v + s u v, of degree 2 over the triangle and 1 x 1 over the square */
    tensor_fill(&x, a, 1, 1);
    for (int k1 = 0; k1 < 4; k1++)
        for (int i = 0; i < LOFT_AXES; i++)
            x.p[k1].axis[i] = arb_real(a, 1000) * 2 + (loft_real)(i == 0   ? k1 / 2
                                                                  : i == 1 ? k1 % 2
                                                                           : 0) *
                                                          LOFT_REAL(3000);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real p = x.p[0].axis[i], q = x.p[2].axis[i] - p, r = x.p[1].axis[i] - p,
                        s = x.p[3].axis[i] - x.p[2].axis[i] - r;
        b[0].axis[i] = p;
        b[1].axis[i] = p + q / 2;
        b[2].axis[i] = p + r / 2;
        b[3].axis[i] = p + q;
        b[4].axis[i] = p + q / 2 + r / 2 + s / 2;
        b[5].axis[i] = p + r;
    }
    CHECK(loft_triangle_init(&t, b, 2) == LOFT_OK);
    CHECK(loft_tensor_differential(&x.s, at.v, at.w, &one) == LOFT_OK &&
          loft_triangle_differential(&t, at, &two) == LOFT_OK);
    const enum loft_status status = loft_differential_curvatures(&one, &k);
    CHECK(status == loft_differential_curvatures(&two, &l));
    if (status != LOFT_OK || fabsl(exact_acc(k.max)) + fabsl(exact_acc(k.min)) > 1)
        return;
    CHECK_NEAR(exact_acc(k.max), exact_acc(l.max), BY_NUM(1e-9, 1e-6, 1e-12));
    CHECK_NEAR(exact_acc(k.gauss), exact_acc(l.gauss), BY_NUM(1e-9, 1e-6, 1e-12));
}

/* A quarter of a cylinder and of a torus, up to the rounding of sqrt(1/2). */
static void a_rational_cylinder_has_its_radius(arb *a)
{
    const int32_t radius = 1 + (int32_t)arb_below(a, 200);
    const loft_real r = loft_real_from_int(radius), root = LOFT_REAL(181.01933598375618),
                    full = LOFT_REAL(256);
    const loft_real h = loft_real_from_int(1 + (int32_t)arb_below(a, 100));
    const loft_weighted net[6] = { { { { r, 0, 0 } }, full }, { { { r, 0, h } }, full },
                                   { { { r, r, 0 } }, root }, { { { r, r, h } }, root },
                                   { { { 0, r, 0 } }, full }, { { { 0, r, h } }, full } };
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    loft_tensor_rational s;
    loft_curvatures k;
    loft_differential at;
    loft_vec n;

    CHECK(loft_tensor_rational_init(&s, net, 2, 1) == LOFT_OK);
    CHECK(loft_tensor_rational_differential(&s, u, v, &at) == LOFT_OK);
    CHECK(loft_differential_normal(&at, &n) == LOFT_OK &&
          loft_differential_curvatures(&at, &k) == LOFT_OK);
    const loft_vec p = loft_tensor_rational_eval(&s, u, v);
    /* outward: the patch turns left */
    CHECK_EXACT(exact_of(n.axis[0]), exact_of(p.axis[0]) / radius, 0x1p-14L);
    CHECK_EXACT(exact_of(n.axis[1]), exact_of(p.axis[1]) / radius, 0x1p-14L);
    CHECK_EXACT(exact_acc(k.min), -1.0L / radius, BY_NUM(0x1p-22L, 0x1p-22L, 1e-12L));
    CHECK_EXACT(exact_acc(k.max), 0, BY_NUM(0x1p-31L, 1e-9L, 1e-12L));
    CHECK_EXACT(exact_acc(k.gauss), 0, BY_NUM(0x1p-31L, 1e-9L, 1e-12L));
    CHECK(loft_ball_radius(&k) > LOFT_REAL(1000));
}

static long double sum_at(const loft_tensor_rational *s, int axis, unsigned a, unsigned b,
                          long double u, long double v)
{
    long double row[LOFT_DEGREE_MAX + 1], column[LOFT_DEGREE_MAX + 1];

    for (unsigned i = 0; i <= s->m; i++) {
        for (unsigned j = 0; j <= s->n; j++) {
            const loft_weighted *p = &s->p[i * (s->n + 1u) + j];
            row[j] = exact_of(p->w) * (axis < 0 ? 1 : exact_of(p->p.axis[axis]));
        }
        column[i] = exact_deriv(row, s->n, b, v);
    }
    return exact_deriv(column, s->m, a, u);
}

static void check_sci(loft_sci got, long double want, long double size)
{
    loft_acc wide = 0;

    CHECK(loft_sci_to_acc(got, &wide));
    CHECK_EXACT(exact_acc(wide), want, BY_NUM(0x1p-32L, 0, 0) + 0x1p-36L * size);
}

/* All five derivatives, by the quotient rule in long double. */
static void derivatives_of_a_rational_patch_are_those_of_the_quotient(arb *a)
{
    const unsigned m = 1 + arb_below(a, 4), n = 1 + arb_below(a, 4);
    const loft_unit at_u = arb_unit(a), at_v = arb_unit(a);
    const long double u = exact_unit(at_u), v = exact_unit(at_v);
    loft_weighted net[25];
    loft_tensor_rational s;
    loft_differential at;

    for (unsigned k = 0; k < (m + 1) * (n + 1); k++) {
        net[k].p = arb_vec(a, 100);
        net[k].w = LOFT_REAL(2) + arb_real(a, 1);
    }
    CHECK(loft_tensor_rational_init(&s, net, m, n) == LOFT_OK &&
          loft_tensor_rational_differential(&s, at_u, at_v, &at) == LOFT_OK);
    const long double w = sum_at(&s, -1, 0, 0, u, v), wu = sum_at(&s, -1, 1, 0, u, v),
                      wv = sum_at(&s, -1, 0, 1, u, v);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double p = sum_at(&s, i, 0, 0, u, v) / w;
        const long double pu = (sum_at(&s, i, 1, 0, u, v) - p * wu) / w,
                          pv = (sum_at(&s, i, 0, 1, u, v) - p * wv) / w;
        check_sci(at.u[i], pu, 1000);
        check_sci(at.v[i], pv, 1000);
        check_sci(at.uu[i],
                  (sum_at(&s, i, 2, 0, u, v) - 2 * pu * wu - p * sum_at(&s, -1, 2, 0, u, v)) / w,
                  10000);
        check_sci(at.uv[i],
                  (sum_at(&s, i, 1, 1, u, v) - pu * wv - pv * wu - p * sum_at(&s, -1, 1, 1, u, v)) /
                      w,
                  10000);
        check_sci(at.vv[i],
                  (sum_at(&s, i, 0, 2, u, v) - 2 * pv * wv - p * sum_at(&s, -1, 0, 2, u, v)) / w,
                  10000);
    }
}

/* Inside a hollow the ball has the radius of the hollow. */
static void the_ball_fits_and_no_larger_one(arb *a)
{
    loft_curvatures k = { 0, 0, 0, 0 };
    const loft_real most = arb_real(a, 20000);

    k.max = loft_to_acc(most);
    const long double want = most > 0 ? 1 / exact_of(most) : INFINITY;
    const long double got = exact_of(loft_ball_radius(&k));
    CHECK(got <= want * (1 + BY_NUM(0, 0, 0x1p-52L)) + BY_NUM(0x1p-32L, 0, 0));
    CHECK(got >= fminl(want, exact_of(LOFT_REAL_MAX)) * (1 - BY_NUM(0, 0x1p-22L, 0x1p-50L)) -
                     BY_NUM(LSB + 0x1p-32L, 0, 0));
}

/* All points of an edge in one point; all points of the net on a line. */
static void degenerate_patches_have_no_normal(arb *a)
{
    static tensor x;
    loft_differential at;
    loft_vec n;

    tensor_fill(&x, a, 3, 3);
    for (unsigned j = 1; j <= 3; j++)
        x.p[j] = x.p[0];
    CHECK(loft_tensor_differential(&x.s, 0, arb_unit(a), &at) == LOFT_OK &&
          loft_differential_normal(&at, &n) == LOFT_SINGULAR);
    for (unsigned k = 0; k < 16; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            x.p[k].axis[i] = (loft_real)((int)(k * k) - 20 * i) * loft_real_from_int(1);
    for (unsigned k = 0; k < 16; k++)
        for (int i = 1; i < LOFT_AXES; i++)
            x.p[k].axis[i] = 3 * x.p[k].axis[0];
    CHECK(loft_tensor_differential(&x.s, arb_unit(a), arb_unit(a), &at) == LOFT_OK &&
          loft_differential_normal(&at, &n) == LOFT_SINGULAR);
    CHECK(loft_tensor_differential(&x.s, LOFT_UNIT(1.5), 0, &at) == LOFT_ERR_ARG &&
          loft_tensor_differential(&x.s, 0, LOFT_UNIT(-1), &at) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_normal_is_within_its_bound_or_there_is_none, 1000);
    PROPERTY(curvatures_are_within_their_bounds, 1500);
    PROPERTY(directions_are_those_of_the_form, 1500);
    PROPERTY(equal_curvatures_have_no_directions, 100);
    PROPERTY(a_triangle_bends_as_the_patch_it_is_cut_from, 300);
    PROPERTY(a_rational_cylinder_has_its_radius, 300);
    PROPERTY(derivatives_of_a_rational_patch_are_those_of_the_quotient, 300);
    PROPERTY(the_ball_fits_and_no_larger_one, 2000);
    PROPERTY(degenerate_patches_have_no_normal, 100);
    return check_failures();
}

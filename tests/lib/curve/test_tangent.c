/* tests/lib/curve/test_tangent.c -- properties of lib/curve/tangent.h
 * SPDX-License-Identifier: MIT
 *
 * The reference is the quotient rule in 113 bits, over B-splines by their definition.
 */
#include "support/exact_basis.h"        /* quad_basis, arb_knots; CHECK, PROPERTY, BY_NUM */
#include "curve/tangent.h"

#define MOST 24

typedef struct {
    unsigned points, degree, span;
    loft_weighted p[MOST];
    loft_real knot[MOST + 10], u;
    long double ratio, size, step;
} sample;

static sample *arb_sample(arb *a, bool bezier)
{
    static sample s;
    const int32_t limit = (int32_t)1 << arb_below(a, 15);
    long double least = 256, most = 0;

    s.degree = 1 + arb_below(a, 6);
    s.points = s.degree + 1 + (bezier ? 0 : arb_below(a, 8));
    for (unsigned i = 0; i < s.points; i++) {
        const loft_real w = loft_real_from_raw(256 +
                                               (int32_t)arb_below(a, 1u << (1 + arb_below(a, 18))));
        s.p[i] = (loft_weighted) { arb_vec(a, limit), w };
        least = fminl(least, exact_of(w));
        most = fmaxl(most, exact_of(w));
    }
    s.ratio = most / least;
    s.size = limit;
    arb_knots(a, s.points, s.degree, s.knot);
    for (unsigned i = 0; i < 2 * (s.degree + 1) && bezier; i++)
        s.knot[i] = i <= s.degree ? LOFT_REAL(0) : LOFT_REAL(1);
    return &s;
}

static void reference(const sample *s, quad u, quad out[4][LOFT_AXES])
{
    quad w[4] = { 0 }, x[4][LOFT_AXES] = { { 0 } };

    for (unsigned k = 0; k < 4; k++)
        for (unsigned j = 0; j <= s->degree; j++) {
            const loft_weighted *p = &s->p[s->span - s->degree + j];
            const quad n = quad_of(p->w) *
                           quad_basis(s->knot, s->span - s->degree + j, s->degree, u, k, s->span);
            w[k] += n;
            for (int i = 0; i < LOFT_AXES; i++)
                x[k][i] += n * quad_of(p->p.axis[i]);
        }
    for (int i = 0; i < LOFT_AXES; i++) {
        out[0][i] = x[0][i] / w[0];
        out[1][i] = (x[1][i] - w[1] * out[0][i]) / w[0];
        out[2][i] = (x[2][i] - 2 * w[1] * out[1][i] - w[2] * out[0][i]) / w[0];
        out[3][i] = (x[3][i] - 3 * w[1] * out[2][i] - 3 * w[2] * out[1][i] - w[3] * out[0][i]) /
                    w[0];
    }
}

static void check_tangent(const sample *s, const loft_tangent *at, quad u)
{
    quad want[4][LOFT_AXES];
    const long double slope = 2 * s->degree * s->ratio / s->step,
                      rel = bound_by_num(0x1p-54L, 0x1p-46L, 0x1p-46L) * 2 * s->size;

    reference(s, u, want);
    for (unsigned k = 1; k < 4; k++) {
        loft_vec v = { { 0 } };
        const long double room = rel * powl(slope, k) * (k == 3 ? 6 : 1);
        const enum loft_status status = loft_tangent_deriv(at, k, &v);
        if (room < 1)
            check_result(status, &v, want[k], 0.5L + 0x1p-16L + room / LSB, room);
    }
}

static void derivatives_of_nurbs_are_within_their_bound(arb *a)
{
    sample *s = arb_sample(a, false);
    loft_nurbs n;
    loft_tangent at;

    if (loft_nurbs_init(&n, s->p, s->points, s->knot, s->degree) != LOFT_OK)
        return;
    s->u = loft_lerp(s->knot[s->degree], s->knot[s->points], arb_unit(a));
    s->span = loft_knots_find(&n.knots, s->u);
    s->step = exact_of(s->knot[s->span + 1]) - exact_of(s->knot[s->span]);
    CHECK(loft_nurbs_tangent(&n, s->u, &at) == LOFT_OK);
    check_tangent(s, &at, quad_of(s->u));
}

static void derivatives_of_bezier_curves_are_within_their_bound(arb *a)
{
    sample *s = arb_sample(a, true);
    const loft_unit t = arb_unit(a);
    loft_rational r;
    loft_tangent at;

    CHECK(loft_rational_init(&r, s->p, s->degree) == LOFT_OK);
    s->span = s->degree;
    s->step = 1;
    CHECK(loft_rational_tangent(&r, t, &at) == LOFT_OK);
    check_tangent(s, &at, (quad)exact_unit(t));
}

/* A cubic with a cusp in its middle, anywhere, with any one weight; one LSB aside it has none. */
static void cusps_are_told_exactly(arb *a)
{
    const int32_t limit = BY_NUM(4000, 30, 4000);       /* sums are exact */
    const loft_vec at = arb_vec(a, 2 * limit), x = arb_vec(a, limit), y = arb_vec(a, limit);
    const loft_real w = loft_real_from_raw(256 + (int32_t)arb_below(a, 1 << 20));
    loft_weighted p[4] = { { at, w },
                           { loft_vec_add(at, loft_vec_add(x, y)), w },
                           { loft_vec_add(at, y), w },
                           { loft_vec_add(at, x), w } };
    loft_rational r;
    loft_tangent d;
    loft_acc k;
    loft_vec zero = { { 0 } }, v = at;

    if (loft_vec_equal(x, zero) || loft_vec_equal(y, zero))
        return;
    CHECK(loft_rational_init(&r, p, 3) == LOFT_OK);
    CHECK(loft_rational_tangent(&r, LOFT_UNIT(0.5), &d) == LOFT_OK && d.stops);
    CHECK(loft_tangent_deriv(&d, 1, &v) == LOFT_OK && loft_vec_equal(v, zero));
    CHECK(loft_tangent_curvature(&d, true, &k) == LOFT_SINGULAR);
    p[0].p.axis[0] = (p[0].p.axis[0] + loft_real_from_raw(1));
    CHECK(loft_rational_tangent(&r, LOFT_UNIT(0.5), &d) == LOFT_OK && !d.stops);
}

/* A quarter of a circle by weights 1, sqrt(1/2), 1: 1 / radius, to what rounding the weight does.
 */
static void the_curvature_of_an_arc_is_one_over_its_radius(arb *a)
{
    const int32_t whole = 1 + (int32_t)arb_below(a, 2000);
    const loft_real radius = loft_real_from_int(whole);
    loft_weighted p[3] = { { { { 0 } }, LOFT_REAL(128) },
                           { { { 0 } }, LOFT_REAL(90.50966799187808) },
                           { { { 0 } }, LOFT_REAL(128) } };
    loft_rational r;
    loft_tangent d;
    loft_acc left = 0, any = 0;

    p[0].p.axis[0] = p[1].p.axis[0] = radius;
#if LOFT_AXES > 1
    p[1].p.axis[1] = p[2].p.axis[1] = radius;
#endif
    CHECK(loft_rational_init(&r, p, 2) == LOFT_OK);
    CHECK(loft_rational_tangent(&r, arb_unit(a), &d) == LOFT_OK);
    if (LOFT_AXES < 2)
        return;
    CHECK(loft_tangent_curvature(&d, true, &left) == LOFT_OK &&
          loft_tangent_curvature(&d, false, &any) == LOFT_OK);
    CHECK_EXACT(exact_acc(left), 1.0L / whole, 0x1p-20L / whole + 0x1p-32L);
    CHECK_EXACT(exact_acc(any), exact_acc(left), 0x1p-32L);
}

/* (x, y, z) = s (t, t^2, t^3): the torsion is 3 / s over 1 + 9 t^2 + 9 t^4, right-handed; mirrored
 * it is negative. With weights that fall like (1, 1/2, 1/4, 1/8), the same curve at t / (2 - t). */
static void the_torsion_of_a_twisted_cubic_is_known(arb *a)
{
    const int32_t s = 3 * (1 + (int32_t)arb_below(a, 200)), mirror = arb_below(a, 2) ? 1 : -1;
    const bool weights = arb_below(a, 2);
    const loft_unit t = arb_unit(a);
    const long double u = exact_unit(t), x = weights ? u / (2 - u) : u,
                      below = 1 + 9 * x * x + 9 * x * x * x * x;
    loft_weighted p[4];
    loft_rational r;
    loft_tangent d;
    loft_acc torsion = 0;

    for (int k = 0; k < 4; k++) {
        p[k].p = (loft_vec){ { 0 } };
        p[k].w = weights ? loft_real_from_int(8 >> k) : LOFT_REAL(1);
        p[k].p.axis[0] = loft_real_from_int(s * k / 3);
#if LOFT_AXES > 2
        p[k].p.axis[1] = loft_real_from_int(k == 2 ? s / 3 : k == 3 ? s : 0);
        p[k].p.axis[2] = loft_real_from_int(k == 3 ? mirror * s : 0);
#endif
    }
    CHECK(loft_rational_init(&r, p, 3) == LOFT_OK && loft_rational_tangent(&r, t, &d) == LOFT_OK);
    if (LOFT_AXES < 3)
        return;
    CHECK(loft_tangent_torsion(&d, &torsion) == LOFT_OK);
    CHECK_EXACT(exact_acc(torsion), mirror * 3 / (s * below),
                bound_by_num(0x1p-32L, 0x1p-40L, 0x1p-40L));

    const long double h = sqrtl(below),             /* |P' x P''| is 2 h s^2 */
        g = sqrtl(1 + 4 * x * x + 9 * x * x * x * x),
                      want[3][3] = { { 1 / g, 2 * x / g, 3 * x * x * mirror / g },
                                     { (-2 * x - 9 * x * x * x) / (g * h),
                                       (1 - 9 * x * x * x * x) / (g * h),
                                       (3 * x + 6 * x * x * x) * mirror / (g * h) },
                                     { 3 * x * x * mirror / h, -3 * x * mirror / h, 1 / h } };
    loft_vec frame[3];
    CHECK(loft_tangent_frenet(&d, frame) == LOFT_OK);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3 && i < LOFT_AXES; i++)
            CHECK_EXACT(exact_of(frame[k].axis[i]), want[k][i],
                        bound_by_num(0x1p-17L + 0x1p-30L, 0x1p-25L + 0x1p-38L, 0x1p-44L));
}

static void what_does_not_turn_has_no_torsion(arb *a)
{
    loft_weighted p[3] = { { { { 0 } }, LOFT_REAL(1) },
                           { { { 0 } }, LOFT_REAL(1) },
                           { { { 0 } }, LOFT_REAL(1) } };
    loft_vec frame[3];
    loft_rational r;
    loft_tangent d;
    loft_acc torsion = 7;

    if (LOFT_AXES < 3)
        return;
    for (int i = 0; i < LOFT_AXES; i++) {           /* a line, at an uneven pace */
        const int32_t from = (int32_t)arb_below(a, 100), by = (int32_t)arb_below(a, 100);
        p[0].p.axis[i] = loft_real_from_int(from);
        p[1].p.axis[i] = loft_real_from_int(from + by);
        p[2].p.axis[i] = loft_real_from_int(from + 3 * by);
    }
    CHECK(loft_rational_init(&r, p, 1 + arb_below(a, 2)) == LOFT_OK);
    CHECK(loft_rational_tangent(&r, LOFT_UNIT(0.25), &d) == LOFT_OK);
    CHECK(loft_tangent_torsion(&d, &torsion) == LOFT_SINGULAR && torsion == 7);
    CHECK(loft_tangent_frenet(&d, frame) == LOFT_SINGULAR);
}

static void mistakes_are_refused(arb *a)
{
    const sample *s = arb_sample(a, true);
    loft_rational r;
    loft_tangent d;
    loft_vec v;

    CHECK(loft_rational_init(&r, s->p, s->degree) == LOFT_OK);
    CHECK(loft_rational_tangent(&r, LOFT_UNIT(1.5), &d) == LOFT_ERR_ARG);
    CHECK(loft_rational_tangent(&r, 0, &d) == LOFT_OK);
    CHECK(loft_tangent_deriv(&d, 0, &v) == LOFT_ERR_ARG &&
          loft_tangent_deriv(&d, 4, &v) == LOFT_ERR_ARG);
    CHECK(loft_rational_init(&r, s->p, 0) == LOFT_OK);
    CHECK(loft_rational_tangent(&r, 0, &d) == LOFT_OK && d.stops);
}

int main(void)
{
    PROPERTY(derivatives_of_nurbs_are_within_their_bound,         500);
    PROPERTY(derivatives_of_bezier_curves_are_within_their_bound, 500);
    PROPERTY(cusps_are_told_exactly,                              500);
    PROPERTY(the_curvature_of_an_arc_is_one_over_its_radius,      500);
    PROPERTY(the_torsion_of_a_twisted_cubic_is_known,             500);
    PROPERTY(what_does_not_turn_has_no_torsion,                    50);
    PROPERTY(mistakes_are_refused,                                 50);
    return check_failures();
}

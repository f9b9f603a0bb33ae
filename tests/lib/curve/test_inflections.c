/* tests/lib/curve/test_inflections.c -- properties of lib/curve/inflections.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/inflections.h"
#include "curve/shape.h"
#include "support/exact.h"          /* exact_deriv; CHECK, PROPERTY */

#if LOFT_AXES < 2
#  error "curves in the plane"
#endif

#define MOST (LOFT_DEGREE_MAX + 1)

typedef struct {
    loft_vec p[MOST];
    loft_weighted w[MOST];
    loft_bezier b;
} curve;

static void arb_curve(arb *a, curve *c, unsigned n)
{
    for (unsigned k = 0; k <= n; k++) {
        c->p[k] = arb_vec(a, 100);
        c->w[k].p = c->p[k];
        c->w[k].w = loft_real_from_int(3);
    }
    CHECK(loft_bezier_init(&c->b, c->p, n) == LOFT_OK);
}

static long double turn_at(const curve *c, long double t)
{
    long double d[2][3];

    for (int axis = 0; axis < 2; axis++) {
        long double x[MOST];
        for (unsigned k = 0; k <= c->b.degree; k++)
            x[k] = exact_of(c->p[k].axis[axis]);
        for (unsigned k = 1; k < 3; k++)
            d[axis][k] = exact_deriv(x, c->b.degree, k, t);
    }
    return d[0][1] * d[1][2] - d[1][1] * d[0][2];
}

/* The sign of the curvature in each of 512 places follows from the roots before it. */
static void signs_change_at_odd_roots_alone(arb *a)
{
    loft_flat f[LOFT_FLATS_MAX];
    unsigned count, k = 0;
    curve c;

    arb_curve(a, &c, 2 + arb_below(a, LOFT_DEGREE_MAX - 1));
    const enum loft_status status = loft_bezier_inflections(&c.b, f, &count);
    if (status == LOFT_SINGULAR)
        return;
    CHECK(status == LOFT_OK && (c.b.degree == 2 ? count == 0 : count <= 2u * c.b.degree - 4));
    long double size = 0;
    for (int i = 0; i <= 512; i++)
        size = fmaxl(size, fabsl(turn_at(&c, i / 512.0L)));
    bool above = turn_at(&c, 0) > 0;
    if (fabsl(turn_at(&c, 0)) < size * 0x1p-30L)
        return;
    for (int i = 1; i <= 512; i++) {
        const long double t = i / 512.0L, turn = turn_at(&c, t);
        for (; k < count && exact_unit(f[k].t) < t; k++)
            above ^= f[k].multiplicity % 2;
        if (fabsl(turn) > size * 0x1p-16L)
            CHECK((turn > 0) == above);
    }
    for (k = 0; k < count; k++)
        CHECK_NEAR(turn_at(&c, exact_unit(f[k].t)), 0, size * 0x1p-14L);
}

/* What shape.h decides for cubics, and equal weights, is the same. */
static void cubics_and_equal_weights_agree(arb *a)
{
    loft_flat f[LOFT_FLATS_MAX], g[LOFT_FLATS_MAX];
    unsigned count, weighted, inside = 0;
    loft_rational r;
    loft_cubic cubic;
    loft_shape s;
    curve c;

    arb_curve(a, &c, 3);
    for (int k = 0; k < 4; k++)
        cubic.p[k] = c.p[k];
    if (loft_cubic_shape(&cubic, &s) != LOFT_OK)
        return;
    CHECK(loft_rational_init(&r, c.w, 3) == LOFT_OK);
    const enum loft_status status = loft_bezier_inflections(&c.b, f, &count);
    CHECK(loft_rational_inflections(&r, g, &weighted) == status && count == weighted);
    CHECK((status == LOFT_SINGULAR) == (s.kind == LOFT_LINE || s.kind == LOFT_POINT));
    for (unsigned k = 0; k < count; k++) {
        CHECK(f[k].t == g[k].t && f[k].multiplicity == g[k].multiplicity);
        if (f[k].multiplicity == 1 && f[k].t > 0 && f[k].t < LOFT_UNIT(1)) {
            CHECK(inside < s.inflections);
            CHECK_NEAR(exact_unit(f[k].t), exact_unit(s.inflection[inside]), 0x1p-23L);
            inside++;
        }
    }
    CHECK(inside == s.inflections || count == 0 || f[0].t <= 0 || f[count - 1].t >= LOFT_UNIT(1));
}

/* t^4 and (2 t - 1)^5 as graphs over t, without weights and with equal ones. */
static void flat_places_have_their_multiplicity(arb *a)
{
    static const int32_t quartic[5] = { 0, 0, 0, 0, 8192 };     /* t^4: flat at 0, to the order 2 */
    static const int32_t quintic[6] = { -1024, 1024, -1024, 1024, -1024, 1024 };    /* (2t - 1)^5 */
    const bool odd = arb_below(a, 2);
    const unsigned n = odd ? 5 : 4;
    loft_flat f[LOFT_FLATS_MAX];
    unsigned count;
    loft_rational r;
    curve c;

    arb_curve(a, &c, n);
    for (unsigned k = 0; k <= n; k++) {
        c.p[k].axis[0] = loft_real_from_raw((int32_t)(k * 20480));
        c.p[k].axis[1] = loft_real_from_raw(odd ? quintic[k] : quartic[k]);
        c.w[k].p = c.p[k];
    }
    CHECK(loft_bezier_inflections(&c.b, f, &count) == LOFT_OK && count == 1);
    CHECK(f[0].multiplicity == (odd ? 3 : 2) && f[0].t == (odd ? LOFT_UNIT(0.5) : 0));
    CHECK(loft_rational_init(&r, c.w, n) == LOFT_OK);
    CHECK(loft_rational_inflections(&r, f, &count) == LOFT_OK && count == 1 &&
          f[0].multiplicity == (odd ? 3 : 2));
}

static void mistakes_are_refused(arb *a)
{
    loft_flat f[LOFT_FLATS_MAX];
    unsigned count;
    loft_rational r;
    curve c;

    arb_curve(a, &c, 9);
    CHECK(loft_rational_init(&r, c.w, 8) == LOFT_OK);
    CHECK(loft_rational_inflections(&r, f, &count) == LOFT_ERR_ARG && count == 0);
    CHECK(loft_bezier_init(&c.b, c.p, 1) == LOFT_OK);
    CHECK(loft_bezier_inflections(&c.b, f, &count) == LOFT_SINGULAR && count == 0);
    for (int k = 0; k < 5; k++)
        c.p[k] = c.p[0];
    CHECK(loft_bezier_init(&c.b, c.p, 4) == LOFT_OK);
    CHECK(loft_bezier_inflections(&c.b, f, &count) == LOFT_SINGULAR && count == 0);
}

int main(void)
{
    PROPERTY(signs_change_at_odd_roots_alone, 60);
    PROPERTY(cubics_and_equal_weights_agree, 60);
    PROPERTY(flat_places_have_their_multiplicity, 4);
    PROPERTY(mistakes_are_refused, 5);
    return check_failures();
}

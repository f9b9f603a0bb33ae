/* tests/lib/curve/test_knot_removal.c -- properties of lib/curve/knot_removal.h
 * SPDX-License-Identifier: MIT
 */
#include "support/splines.h"            /* arb_grid, exact_weights; CHECK, PROPERTY */
#include "curve/knot_removal.h"

typedef struct {
    grid g;
    loft_vec p[POINTS_MOST + 2];
    loft_bspline b;
} sample;

static sample *arb_bspline(arb *a)
{
    static sample s;
    const int32_t limit = (int32_t)1 << arb_below(a, 12);

    s.g = arb_grid(a);
    for (unsigned k = 0; k < s.g.points; k++)
        s.p[k] = arb_vec(a, limit);
    CHECK(loft_bspline_init(&s.b, s.p, s.g.points, s.g.k, s.g.p) == LOFT_OK);
    return &s;
}

/* With weights, from their definition. */
static void point_of(const grid *g, const loft_weighted p[], loft_real u,
                     long double out[LOFT_AXES])
{
    long double n[KNOTS_MOST], weight = 0;

    exact_weights(g, g->p, exact_span(g, u), exact_of(u), n);
    for (int axis = 0; axis < LOFT_AXES; axis++)
        out[axis] = 0;
    for (unsigned k = 0; k < g->points; k++) {
        weight += n[k] * exact_of(p[k].w);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            out[axis] += n[k] * exact_of(p[k].w) * exact_of(p[k].p.axis[axis]);
    }
    for (int axis = 0; axis < LOFT_AXES; axis++)
        out[axis] /= weight;
}

/* Are two curves within `far` of each other at places between their knots? */
static void check_apart(const grid *g, const loft_weighted w[], const grid *less,
                        const loft_weighted p[], long double far)
{
    for (int i = 0; i <= 40; i++) {
        const loft_real u = loft_lerp(g->k[g->p], g->k[g->points], loft_unit_of((uint32_t)i, 40));
        long double x[LOFT_AXES], y[LOFT_AXES], sum = 0;
        bool at_knot = false;
        for (unsigned k = 0; k <= g->points + g->p; k++)
            at_knot = at_knot || !(u < g->k[k] || u > g->k[k]);
        if (at_knot)
            continue;
        point_of(g, w, u, x);
        point_of(less, p, u, y);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            sum += powl(x[axis] - y[axis], 2);
        CHECK(sqrtl(sum) <= far);
    }
}

static void weigh(loft_weighted out[], const loft_vec p[], unsigned count)
{
    for (unsigned k = 0; k < count; k++)
        out[k] = (loft_weighted){ p[k], LOFT_REAL(1) };
}

/* Any knot of any curve: nowhere further than said. */
static void the_curve_stays_within_the_distance(arb *a)
{
    const sample *s = arb_bspline(a);
    const unsigned knot = arb_below(a, s->g.points + s->g.p + 1);
    const loft_real from = s->g.k[s->g.p], to = s->g.k[s->g.points];
    static loft_vec p[POINTS_MOST + 2];
    static loft_weighted was[POINTS_MOST + 2], is[POINTS_MOST + 2];
    loft_acc far = 0;
    grid less = s->g;

    const enum loft_status status = loft_bspline_remove(&s->b, knot, p, less.k, &far);
    if (status != LOFT_OK) {
        if (status == LOFT_ERR_ARG)
            CHECK(knot <= s->g.p || knot >= s->g.points || !(s->g.k[knot] > from) ||
                  !(s->g.k[knot] < to) || !(s->g.k[knot + 1] > s->g.k[knot]) ||
                  !(s->g.k[knot] > s->g.k[knot - 1]));
        return;
    }
    less.points--;
    weigh(was, s->p, s->g.points);
    weigh(is, p, less.points);
    check_apart(&s->g, was, &less, is, exact_acc(far) * (1 + 0x1p-40L) + 0x1p-28L);
}

/* With weights too. */
static void a_weighted_curve_stays_within_the_distance(arb *a)
{
    const sample *s = arb_bspline(a);
    const unsigned knot = arb_below(a, s->g.points + s->g.p + 1);
    static loft_weighted w[POINTS_MOST + 2], p[POINTS_MOST + 2];
    long double largest = 0;
    loft_acc far = 0;
    grid less = s->g;
    loft_nurbs n;

    for (unsigned k = 0; k < s->g.points; k++) {
        w[k].p = s->p[k];
        w[k].w = LOFT_REAL(0.5) + loft_real_from_raw((int32_t)arb_below(a, 131072));
        for (int axis = 0; axis < LOFT_AXES; axis++)
            largest = fmaxl(largest, fabsl(exact_of(w[k].p.axis[axis])));
    }
    CHECK(loft_nurbs_init(&n, w, s->g.points, s->g.k, s->g.p) == LOFT_OK);
    if (loft_nurbs_remove(&n, knot, p, less.k, &far) != LOFT_OK)
        return;
    less.points--;
    check_apart(&s->g, w, &less, p,
                exact_acc(far) * (1 + 0x1p-40L) + BY_NUM(0x1p-28L, 0, 0) +
                    largest * BY_NUM(0, 0x1p-44L, 0x1p-44L));
}

/* A knot that was inserted goes from a weighted curve, too. */
static void an_inserted_knot_goes_with_weights(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 4), points = degree + 2 + arb_below(a, 6);
    static loft_weighted p[POINTS_MOST + 2], more[POINTS_MOST + 2], back[POINTS_MOST + 2];
    loft_real k[KNOTS_MOST + 2], again[KNOTS_MOST + 2], first[KNOTS_MOST + 2];
    loft_nurbs n;
    loft_acc far = 0;

    for (unsigned i = 0; i < points; i++) {
        p[i].p = arb_vec(a, 100);
        p[i].w = LOFT_REAL(16) + loft_real_from_raw((int32_t)arb_below(a, 1 << 20));
    }
    for (unsigned i = 0; i < points + degree + 1; i++)
        first[i] = loft_real_from_int((int32_t)i);
    CHECK(loft_nurbs_init(&n, p, points, first, degree) == LOFT_OK);
    const loft_real u = loft_real_from_int((int32_t)(degree + arb_below(a, points - degree))) +
                        LOFT_REAL(0.5);
    CHECK(loft_nurbs_insert(&n, u, more, k) == LOFT_OK);
    CHECK(loft_nurbs_init(&n, more, points + 1, k, degree) == LOFT_OK);
    unsigned knot = 0;
    while (k[knot] < u)
        knot++;
    CHECK(loft_nurbs_remove(&n, knot, back, again, &far) == LOFT_OK);
    CHECK(exact_acc(far) <= BY_NUM(256 * LSB, 0x1p-11L, 0x1p-38L));
    for (unsigned i = 0; i < points; i++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            CHECK_NEAR(exact_of(back[i].p.axis[axis]), exact_of(p[i].p.axis[axis]),
                       BY_NUM(512 * LSB, 0x1p-9L, 0x1p-36L));
    CHECK(loft_nurbs_remove(&n, degree, back, again, &far) == LOFT_ERR_ARG);
}

/* A knot that was inserted goes, and little else happens. */
static void an_inserted_knot_goes_again(arb *a)
{
    static sample s;
    static loft_vec more[POINTS_MOST + 2], back[POINTS_MOST + 2];
    const unsigned degree = 1 + arb_below(a, 4), points = degree + 2 + arb_below(a, 6);
    loft_real k[KNOTS_MOST + 2], again[KNOTS_MOST + 2];
    loft_bspline b;
    loft_acc far = 0;

    for (unsigned i = 0; i < points; i++)
        s.p[i] = arb_vec(a, 100);
    for (unsigned i = 0; i < points + degree + 1; i++)
        s.g.k[i] = loft_real_from_int((int32_t)i);
    CHECK(loft_bspline_init(&b, s.p, points, s.g.k, degree) == LOFT_OK);
    const loft_real u = loft_real_from_int((int32_t)(degree + arb_below(a, points - degree))) +
                        LOFT_REAL(0.5);
    CHECK(loft_bspline_insert(&b, u, more, k) == LOFT_OK);
    CHECK(loft_bspline_init(&b, more, points + 1, k, degree) == LOFT_OK);
    unsigned knot = 0;
    while (k[knot] < u)
        knot++;
    CHECK(loft_bspline_remove(&b, knot, back, again, &far) == LOFT_OK);
    CHECK(exact_acc(far) <= BY_NUM(32 * LSB, 0x1p-14L, 0x1p-40L));
    for (unsigned i = 0; i < points + degree + 1; i++)
        CHECK(again[i] == s.g.k[i]);
    for (unsigned i = 0; i < points; i++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            CHECK_NEAR(exact_of(back[i].axis[axis]), exact_of(s.p[i].axis[axis]),
                       BY_NUM(128 * LSB, 0x1p-11L, 0x1p-38L));
    CHECK(loft_bspline_remove(&b, 0, back, again, &far) == LOFT_ERR_ARG &&
          loft_bspline_remove(&b, degree, back, again, &far) == LOFT_ERR_ARG &&
          loft_bspline_remove(&b, points + 1, back, again, &far) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(the_curve_stays_within_the_distance, 1000);
    PROPERTY(a_weighted_curve_stays_within_the_distance, 1000);
    PROPERTY(an_inserted_knot_goes_with_weights, 500);
    PROPERTY(an_inserted_knot_goes_again, 500);
    return check_failures();
}

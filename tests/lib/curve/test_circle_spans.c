/* tests/lib/curve/test_circle_spans.c -- properties of lib/curve/circle.h: the spans of arcs
 * SPDX-License-Identifier: MIT
 */
#include "support/arcs.h"               /* arb_circle, true_point */

static long double distance_at(const truth *t, const long double p[], long double part)
{
    long double q[LOFT_AXES], sum = 0;

    true_point(t, part, q);
    for (int i = 0; i < LOFT_AXES; i++)
        sum += (q[i] - p[i]) * (q[i] - p[i]);
    return sqrtl(sum);
}

/* The distance of p from the arc near `part`, by golden section over `width` of it. */
static long double distance(const truth *t, const long double p[], long double part,
                            long double width)
{
    long double from = part - width, to = part + width;

    for (int k = 0; k < 60; k++) {
        const long double x = from + (to - from) * 0.381966L, y = from + (to - from) * 0.618034L;
        if (distance_at(t, p, x) < distance_at(t, p, y))
            to = y;
        else
            from = x;
    }
    return distance_at(t, p, (from + to) / 2);
}

/* Points of the span with these weighted control points. */
static void check_span(const truth *t, const loft_weighted p[], unsigned degree, uint32_t j,
                       uint32_t n, long double tolerance)
{
    for (int k = 0; k <= 6; k++) {
        long double w[4], x[4], at[LOFT_AXES];
        for (unsigned i = 0; i <= degree; i++)
            w[i] = exact_of(p[i].w);
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            for (unsigned i = 0; i <= degree; i++)
                x[i] = w[i] * exact_of(p[i].p.axis[axis]);
            at[axis] = exact_at(x, degree, k, 6) / exact_at(w, degree, k, 6);
        }
        CHECK(distance(t, at, (j + k / 6.0L) / n, 0.1L / n) <= tolerance);
    }
}

static uint32_t check_spans(const loft_circle *c, const truth *t, const loft_circle_spans *start,
                            enum loft_circle_kind kind, long double tolerance)
{
    const unsigned degree = kind == LOFT_CIRCLE_CONIC ? 2 : 3;
    loft_circle_spans s = *start;
    loft_vec at = c->from;
    uint32_t j = 0;

    for (;; j++) {
        loft_weighted p[4];
        loft_cubic cubic;
        if (kind == LOFT_CIRCLE_CUBIC ? !loft_circle_spans_next(&s, &cubic)
                                      : !loft_circle_spans_rational(&s, p))
            break;
        for (int i = 0; i < 4 && kind == LOFT_CIRCLE_CUBIC; i++) {
            p[i].p = cubic.p[i];
            p[i].w = LOFT_REAL(1);
        }
        CHECK(loft_vec_equal(p[0].p, at));
        at = p[degree].p;
        if (j < 12 || j + 1 == s.n)
            check_span(t, p, degree, j, s.n, tolerance);
    }
    CHECK(j == s.n && loft_vec_equal(at, c->to));
    return j;
}

/* The bound of the header: the error of n spans, for a circle without drift. */
static long double cubic_error(const truth *t, uint32_t n)
{
    const long double h = t->sweep / n;
    return t->radius * 2 / 27 * powl(sinl(h / 4), 6) / powl(cosl(h / 4), 2);
}

static void spans_stay_within_the_tolerance(arb *a)
{
    const enum loft_circle_kind kind = (enum loft_circle_kind)arb_below(a, 3);
    arc s;
    loft_circle_spans spans;

    if (!arb_circle(a, &s))
        return;
    const long double least = 3 * BY_NUM(LSB, 2 * ulp(s.t.largest), 2 * ulp(s.t.largest));
    const long double asked = least * 1.2L * (1 << arb_below(a, 20)) +
                              s.t.radius * (kind == LOFT_CIRCLE_CUBIC ? 0 : 0x1p-24L);
    const loft_real tolerance = coordinate(asked);

    const enum loft_status status = loft_circle_spans_init(&spans, &s.c, kind, tolerance);
    if (status == LOFT_OK)
        check_spans(&s.c, &s.t, &spans, kind, exact_of(tolerance));
    else
        CHECK(status == LOFT_ERR_RANGE);
    /* refused for the range of the number type, or because the helix is too steep for so many
     * spans */
    long double steep = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        steep = fmaxl(steep, fabsl(s.t.drift[i]));
    CHECK(status == LOFT_OK ||
          BY_NUM(s.t.largest + 1.5L * s.t.radius + steep > 32767, false, false) ||
          steep * s.t.sweep * s.t.sweep > 1e-3L * asked);
}

static void as_few_cubics_as_the_bound_needs(arb *a)
{
    const long double radius = 1 + arb_below(a, 10000),
                      tolerance = fmaxl(ldexpl(1, -(int)arb_below(a, 12)), 64 * ulp(radius));
    const loft_plane plane = { 0, 1 };
    loft_vec from = { { 0 } }, centre = { { 0 } };
    loft_circle c;
    loft_circle_spans s;
    truth t = { .sweep = 2 * pi, .radius = radius };

    from.axis[0] = coordinate(radius);
    CHECK(loft_circle_from_centre(&c, from, from, plane, centre, arb_below(a, 2) ? 1 : -1) ==
          LOFT_OK);
    CHECK(loft_circle_spans_init(&s, &c, LOFT_CIRCLE_CUBIC, coordinate(tolerance)) == LOFT_OK);
    CHECK(s.n >= 4 && cubic_error(&t, s.n) <= tolerance);
    if (s.n > 4)
        CHECK(cubic_error(&t, s.n - 1) > 0.97L * (tolerance - 6 * ulp(radius)));
}

/* The quarter points of a full circle in three axes are exact to half an LSB. */
static void conics_of_a_circle_are_exact(arb *a)
{
    const long double radius = 1 + arb_below(a, 2000);
    const loft_plane plane = { 0, 1 };
    loft_vec from = { { 0 } }, centre = { { 0 } };
    const enum loft_circle_kind kind = arb_below(a, 2) ? LOFT_CIRCLE_CONIC
                                                       : LOFT_CIRCLE_RATIONAL_CUBIC;
    loft_circle c;
    loft_circle_spans s;
    loft_weighted p[4];
    loft_rational r;

    from.axis[0] = coordinate(radius);
    CHECK(loft_circle_from_centre(&c, from, from, plane, centre, 1) == LOFT_OK);
    CHECK(loft_circle_spans_init(&s, &c, kind, LOFT_REAL(0.01)) == LOFT_OK && s.n == 4);
    while (loft_circle_spans_rational(&s, p)) {
        CHECK(loft_rational_init(&r, p, kind == LOFT_CIRCLE_CONIC ? 2 : 3) == LOFT_OK);
        const loft_vec v = loft_rational_eval(&r, arb_unit(a));
        CHECK_EXACT(size(in_plane(v, plane)), radius,
                    BY_NUM(1.5L * LSB + radius * 0x1p-26L, 3 * ulp(radius), 16 * ulp(radius)));
    }
}


static void too_small_tolerances_are_reported(arb *a)
{
    const loft_real least = (loft_real)BY_NUM(3, 0, 0);
    arc s;
    loft_circle_spans spans = { .n = 77 };

    if (!arb_circle(a, &s))
        return;
    for (int kind = 0; kind < 3; kind++) {
        CHECK(loft_circle_spans_init(&spans, &s.c, (enum loft_circle_kind)kind, least) ==
              LOFT_ERR_RANGE);
        CHECK(loft_circle_spans_init(&spans, &s.c, (enum loft_circle_kind)kind, LOFT_REAL(-1)) ==
              LOFT_ERR_RANGE);
    }
    CHECK(spans.n == 77);
}

/* A circle at the edge of the range whose control points do not fit, or do. */
static void control_points_out_of_range_are_reported(arb *a)
{
    const loft_plane xy = { 0, 1 };
    loft_vec from = { { 0 } }, centre = { { 0 } }, v;
    loft_circle c;
    loft_circle_spans s;

    (void)a;
    centre.axis[0] = coordinate(20000);
    from.axis[0] = coordinate(20000);
    from.axis[1] = coordinate(-11500);
    CHECK(loft_circle_from_centre(&c, from, from, xy, centre, 1) == LOFT_OK);
    CHECK(loft_circle_spans_init(&s, &c, LOFT_CIRCLE_CUBIC, LOFT_REAL(1)) == LOFT_OK);
    from.axis[1] = coordinate(-13000);
    CHECK(loft_circle_from_centre(&c, from, from, xy, centre, 1) == LOFT_OK);
    CHECK(loft_circle_spans_init(&s, &c, LOFT_CIRCLE_CUBIC, LOFT_REAL(1)) ==
          BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
    CHECK(loft_circle_eval(&c, LOFT_UNIT(0.25), &v) == BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
}

int main(void)
{
    PROPERTY(spans_stay_within_the_tolerance,                 400);
    PROPERTY(as_few_cubics_as_the_bound_needs,                300);
    PROPERTY(conics_of_a_circle_are_exact,                    500);
    PROPERTY(too_small_tolerances_are_reported,               200);
    PROPERTY(control_points_out_of_range_are_reported,          1);
    return check_failures();
}

/* tests/lib/curve/test_cardinal.c -- properties of lib/curve/cardinal.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* check_result, quad_of; CHECK, PROPERTY, BY_NUM */
#include "curve/cardinal.h"

typedef struct {
    loft_vec p[5];              /* two segments */
    loft_unit tension;
    long double largest;
} sample;

/* Points of any size, one in eight the extremes; tension mostly -1..1. */
static sample arb_sample(arb *a)
{
    const loft_real top = BY_NUM(INT32_MAX, 32767, 32767),
                    bottom = BY_NUM(INT32_MIN, -32767, -32767);
    const int32_t limit = (int32_t)1 << arb_below(a, 15);
    sample s = { .largest = 0 };

    for (int k = 0; k < 5; k++) {
        const bool extreme = arb_below(a, 8) == 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            s.p[k].axis[i] = extreme ? (arb_below(a, 2) ? top : bottom) : arb_real(a, limit);
            s.largest = fmaxl(s.largest, fabsl(exact_of(s.p[k].axis[i])));
        }
    }
    s.tension = arb_below(a, 4) ? (loft_unit)(2 * arb_unit(a) - LOFT_UNIT(1))
                                : (loft_unit)(120 * arb_unit(a) - LOFT_UNIT(60));
    return s;
}

/* The functions CAR_0 .. CAR_3 of the literature (corrected) and their derivatives */
static quad exact_cardinal(const loft_vec p[4], loft_unit tension, unsigned k, quad t, int i)
{
    const quad s = (1 - (quad)exact_unit(tension)) / 2;
    const quad p0 = quad_of(p[0].axis[i]), p1 = quad_of(p[1].axis[i]), p2 = quad_of(p[2].axis[i]),
               p3 = quad_of(p[3].axis[i]);
    const quad c3 = -s * p0 + (2 - s) * p1 + (s - 2) * p2 + s * p3,
               c2 = 2 * s * p0 + (s - 3) * p1 + (3 - 2 * s) * p2 - s * p3;
    const quad c1 = s * (p2 - p0);

    return k == 0   ? ((c3 * t + c2) * t + c1) * t + p1
           : k == 1 ? (3 * c3 * t + 2 * c2) * t + c1
           : k == 2 ? 6 * c3 * t + 2 * c2
           : k == 3 ? 6 * c3
                    : 0;
}

static void points_and_derivatives_are_within_their_bound(arb *a)
{
    const sample s = arb_sample(a);
    const loft_unit t = arb_below(a, 2) ? arb_unit(a) : (loft_unit)(3 * arb_unit(a) - LOFT_UNIT(1));
    const long double x = exact_unit(t), l = growth(x), size = 1 + fabsl(1 - exact_unit(s.tension));

    for (unsigned k = 0; k <= 4; k++) {
        const unsigned m = k > 3 ? 0 : 3 - k;
        const long double factor = k == 0 ? 1 : k == 1 ? 3 : 6, power = powl(l, m);
        const long double own = k == 0 ? 2 * power : powl(2, k) * factor * power;
        quad want[LOFT_AXES];
        loft_vec v = { { 0 } };
        for (int i = 0; i < LOFT_AXES; i++)
            want[i] = exact_cardinal(s.p, s.tension, k, (quad)x, i);
        const enum loft_status status = k ? loft_cardinal_deriv(s.p, s.tension, k, t, &v)
                                          : loft_cardinal_eval(s.p, s.tension, t, &v);
        check_result(
            status, &v, want, 0.5L + (own + growth_sum(x, m)) / 131072,
            bound_by_num(0, ulp(s.largest) / 2, 96 * size * power * factor * ulp(s.largest)));
    }
}

static void it_goes_through_the_inner_points(arb *a)
{
    const sample s = arb_sample(a);
    loft_vec v = { { 0 } };

    CHECK(loft_cardinal_eval(s.p, s.tension, 0, &v) == LOFT_OK && loft_vec_equal(v, s.p[1]));
    CHECK(loft_cardinal_eval(s.p, s.tension, LOFT_UNIT(1), &v) == LOFT_OK &&
          loft_vec_equal(v, s.p[2]));
}

/* Equal to the last bit */
static void segments_join_with_equal_derivatives(arb *a)
{
    const sample s = arb_sample(a);
    loft_vec before = { { 0 } }, after = { { 0 } };

    const enum loft_status end = loft_cardinal_deriv(s.p, s.tension, 1, LOFT_UNIT(1), &before);
    const enum loft_status start = loft_cardinal_deriv(s.p + 1, s.tension, 1, 0, &after);
    CHECK(end == start && (end != LOFT_OK || loft_vec_equal(before, after)));
}

/* Evenly spaced points on a line, without tension: the line at constant speed. */
static void evenly_spaced_points_make_a_line(arb *a)
{
    const loft_vec from = arb_vec(a, 8000), step = arb_vec(a, 7000);
    const loft_unit t = arb_unit(a);
    loft_vec p[4] = { from, from, from, from }, v = { { 0 } }, d = { { 0 } };
    quad want[LOFT_AXES], slope[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        for (int k = 1; k < 4; k++)
            p[k].axis[i] = (p[k-1].axis[i] + step.axis[i]);
        want[i] = quad_of(p[1].axis[i]) +
                  (quad)exact_unit(t) * (quad_of(p[2].axis[i]) - quad_of(p[1].axis[i]));
        slope[i] = quad_of(step.axis[i]);
    }
    const enum loft_status point = loft_cardinal_eval(p, 0, t, &v),
                           first = loft_cardinal_deriv(p, 0, 1, t, &d);
    CHECK(point == LOFT_OK && first == LOFT_OK);
    check_result(point, &v, want, 0.5L + 5 / 131072.0L,
                 bound_by_num(0, 2 * ulp(32768), 192 * ulp(32768)));
    check_result(first, &d, slope, 0, bound_by_num(0, 4 * ulp(32768), 576 * ulp(32768)));
}

/* Tension 1: from point to point along the chord. */
static void full_tension_runs_along_the_chord(arb *a)
{
    const sample s = arb_sample(a);
    const loft_unit t = arb_unit(a);
    const quad x = (quad)exact_unit(t), part = x * x * (3 - 2 * x);
    quad want[LOFT_AXES];
    loft_vec v = { { 0 } };

    for (int i = 0; i < LOFT_AXES; i++)
        want[i] = quad_of(s.p[1].axis[i]) +
                  part * (quad_of(s.p[2].axis[i]) - quad_of(s.p[1].axis[i]));
    check_result(loft_cardinal_eval(s.p, LOFT_UNIT(1), t, &v), &v, want, 0.5L + 3 / 131072.0L,
                 bound_by_num(0, ulp(s.largest) / 2, 96 * ulp(s.largest)));
}

static void reversed_points_make_the_same_curve(arb *a)
{
    const sample s = arb_sample(a);
    const loft_vec p[4] = { s.p[3], s.p[2], s.p[1], s.p[0] };
    const loft_unit t = arb_unit(a);
    const long double scale = s.largest * (1 + fabsl(1 - exact_unit(s.tension)));
    loft_vec one = { { 0 } }, two = { { 0 } };

    if (loft_cardinal_eval(s.p, s.tension, t, &one) != LOFT_OK ||
        loft_cardinal_eval(p, s.tension, LOFT_UNIT(1) - t, &two) != LOFT_OK)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(one.axis[i]), exact_of(two.axis[i]),
                    bound_by_num(LSB, 8 * ulp(scale), 96 * ulp(scale)));
}

/* Translation by whole LSB changes nothing else, to the last bit in q16. */
static void moved_points_make_the_curve_moved(arb *a)
{
    const loft_vec by = arb_vec(a, 1000);
    const loft_unit t = arb_unit(a), tension = (loft_unit)(2 * arb_unit(a) - LOFT_UNIT(1));
    loft_vec p[4], q[4], one = { { 0 } }, two = { { 0 } };

    for (int k = 0; k < 4; k++) {
        p[k] = arb_vec(a, 8000);
        q[k] = loft_vec_add(p[k], by);
    }
    CHECK(loft_cardinal_eval(p, tension, t, &one) == LOFT_OK &&
          loft_cardinal_eval(q, tension, t, &two) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(one.axis[i]) + exact_of(by.axis[i]), exact_of(two.axis[i]),
                    bound_by_num(0, 8 * ulp(9000), 400 * ulp(9000)));
}

static void control_points_are_within_their_bound_or_refused(arb *a)
{
    const sample s = arb_sample(a);
    const long double size = 1 + fabsl(1 - exact_unit(s.tension));
    loft_cubic c = { { { { 0 } } } };

    const enum loft_status status = loft_cubic_from_cardinal(s.p, s.tension, &c);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && s.largest * size > 32000));
    for (int k = 0; k < 4; k++) {
        quad want[LOFT_AXES];
        for (int i = 0; i < LOFT_AXES; i++) {
            const quad end = quad_of(s.p[k < 2 ? 1 : 2].axis[i]),
                       slope = exact_cardinal(s.p, s.tension, 1, k < 2 ? 0 : 1, i);
            want[i] = k == 1 ? end + slope / 3 : k == 2 ? end - slope / 3 : end;
        }
        if (status == LOFT_OK)
            check_result(status, &c.p[k], want, 0.5L + 1 / 65536.0L,
                         bound_by_num(0, ulp(s.largest) / 2, 4 * size * ulp(s.largest)));
    }
}

static void mistakes_are_refused(arb *a)
{
    const sample s = arb_sample(a);
    const loft_vec before = arb_vec(a, 100);
    loft_vec v = before;
    loft_cubic c;

    CHECK(loft_cardinal_eval(s.p, LOFT_UNIT(60.1), 0, &v) == LOFT_ERR_ARG &&
          loft_cardinal_eval(s.p, LOFT_UNIT(-60.1), 0, &v) == LOFT_ERR_ARG);
    CHECK(loft_cardinal_eval(s.p, 0, LOFT_UNIT(2.1), &v) == LOFT_ERR_ARG &&
          loft_cardinal_deriv(s.p, 0, 1, LOFT_UNIT(-1.1), &v) == LOFT_ERR_ARG);
    CHECK(loft_cubic_from_cardinal(s.p, BY_NUM(LOFT_UNIT(-100), NAN, NAN), &c) == LOFT_ERR_ARG);
    CHECK(loft_vec_equal(v, before));
}

int main(void)
{
    PROPERTY(points_and_derivatives_are_within_their_bound,     5000);
    PROPERTY(it_goes_through_the_inner_points,                  3000);
    PROPERTY(segments_join_with_equal_derivatives,              3000);
    PROPERTY(evenly_spaced_points_make_a_line,                  3000);
    PROPERTY(full_tension_runs_along_the_chord,                 3000);
    PROPERTY(reversed_points_make_the_same_curve,               3000);
    PROPERTY(moved_points_make_the_curve_moved,                 3000);
    PROPERTY(control_points_are_within_their_bound_or_refused,  3000);
    PROPERTY(mistakes_are_refused,                               100);
    return check_failures();
}

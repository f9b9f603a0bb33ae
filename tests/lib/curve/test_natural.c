/* tests/lib/curve/test_natural.c -- properties of lib/curve/natural.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* exact_natural, check_result; CHECK, PROPERTY, BY_NUM */
#include "curve/natural.h"

typedef struct {
    uint32_t count;
    enum loft_spacing knots;
    loft_vec p[SPLINE_POINTS];
    loft_natural_knot memory[SPLINE_POINTS];
    loft_natural s;
    exact_natural own;
    long double largest, shortest;
} sample;

static const enum loft_spacing both[2] = { LOFT_UNIFORM, LOFT_CHORD };

static bool same(loft_real a, loft_real b) { return !(a < b) && !(b < a); }

static loft_real nudged(arb *a, loft_real x)
{
    const loft_real by = (loft_real)((int32_t)arb_below(a, 3) - 1) * BY_NUM(1, 1, 1 / 65536.0);
    return x > BY_NUM(INT32_MAX - 1, 32766, 32766) || x < BY_NUM(INT32_MIN + 1, -32766, -32766)
               ? x
               : x + by;
}

/* Points of every kind: anywhere, alternating extremes, bunches one LSB apart among long chords,
 * all tiny. */
static void arb_points(arb *a, sample *n, uint32_t count)
{
    const loft_real top = BY_NUM(INT32_MAX, 32767, 32767),
                    bottom = BY_NUM(INT32_MIN, -32767, -32767);
    const uint32_t kind = arb_below(a, 5), period = 1 + arb_below(a, 3);
    const int32_t limit = (int32_t)1 << arb_below(a, 15);

    n->count = count;
    n->largest = 0;
    for (uint32_t k = 0; k < count; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_real any = arb_real(a, limit), before = k ? n->p[k-1].axis[i] : any;
            loft_real x = any;
            if (kind == 0)
                x = k / period % 2 ? top : bottom;
            if (kind == 1 && k % 4 != 0)
                x = nudged(a, before);
            if (kind == 2)
                x = (loft_real)((int32_t)arb_below(a, 5) - 2) *
                    BY_NUM(1, 1 / 65536.0f, 1 / 65536.0);
            n->p[k].axis[i] = x;
            n->largest = fmaxl(n->largest, fabsl(exact_of(x)));
        }
}

static enum loft_status start(sample *n, enum loft_spacing knots)
{
    n->knots = knots;
    exact_natural_init(&n->own, n->p, n->count, knots == LOFT_CHORD);
    n->shortest = knots == LOFT_CHORD ? INFINITY : 1;
    for (uint32_t k = 0; k + 1 < n->count; k++)
        n->shortest = fminl(n->shortest, (long double)n->own.h[k]);
    return loft_natural_init(&n->s, n->p, n->count, knots, n->memory);
}

/* A spline, or false if two points coincide with chord knots: then init must report that. */
static bool arb_spline(arb *a, sample *n, uint32_t count)
{
    arb_points(a, n, count);
    const enum loft_status status = start(n, both[arb_below(a, 2)]);
    CHECK(status == (n->own.coincide ? LOFT_SINGULAR : LOFT_OK));
    return status == LOFT_OK;
}

static sample one, two;

static uint32_t arb_count(arb *a) { return 2 + arb_below(a, arb_below(a, 4) ? 6 : 40); }

static enum loft_status deriv(const sample *n, uint32_t i, unsigned k, loft_unit t, loft_vec *v)
{
    return k ? loft_natural_deriv(&n->s, i, k, t, v) : loft_natural_eval(&n->s, i, t, v);
}

/* The bounds of the header; for floats without the last rounding. */
static long double room(const sample *n, uint32_t i, unsigned k)
{
    const long double u = ulp_double(n->largest);
    if (k == 0)
        return bound_by_num(0, ulp(n->largest) / 2, 64 * u);
    return n->knots == LOFT_UNIFORM ? 256 * u
           : k == 1                 ? 0x1p-43L
                                    : 0x1p-43L / (long double)n->own.h[i];
}

static void check_at(const sample *n, uint32_t i, loft_unit t)
{
    for (unsigned k = 0; k <= 2; k++) {
        quad want[LOFT_AXES];
        loft_vec v = { { 0 } };
        for (int axis = 0; axis < LOFT_AXES; axis++)
            want[axis] = exact_natural_deriv(&n->own, i, k, (quad)exact_unit(t), axis);
        const enum loft_status status = deriv(n, i, k, t, &v);
        check_result(status, &v, want, 0.5L + (k ? 1 / 4096.0L : 1 / 16384.0L), room(n, i, k));
    }
}

static void points_and_derivatives_are_within_their_bound(arb *a)
{
    if (!arb_spline(a, &one, arb_count(a)))
        return;
    for (int k = 0; k < 4; k++)
        check_at(&one, arb_below(a, one.count - 1), arb_unit(a));
}

static void a_thousand_points_are_as_exact_as_few(arb *a)
{
    if (!arb_spline(a, &one, 1000 + arb_below(a, 100)))
        return;
    for (uint32_t i = 0; i + 1 < one.count; i++)
        check_at(&one, i, arb_unit(a));
}

static void slopes_are_within_their_bound(arb *a)
{
    if (!arb_spline(a, &one, arb_count(a)))
        return;
    for (uint32_t k = 0; k < one.count; k++)
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const bool last = k + 1 == one.count;
            const quad want = exact_natural_deriv(&one.own, last ? k - 1 : k, 1, last, axis);
            const long double got = exact_acc(one.memory[k].slope[axis]),
                              u = ulp_double(one.largest);
            if (one.knots == LOFT_UNIFORM)
                CHECK_EXACT(got, (long double)want, bound_by_num(0x1p-30L, 16 * u, 16 * u));
            else
                CHECK_EXACT(got / 16777216, (long double)want,
                            bound_by_num(0x1p-49L, 0x1p-44L, 0x1p-44L));
        }
}

static void it_goes_through_its_points(arb *a)
{
    if (!arb_spline(a, &one, arb_count(a)))
        return;
    for (uint32_t i = 0; i + 1 < one.count; i++) {
        loft_vec v = { { 0 } };
        CHECK(loft_natural_eval(&one.s, i, 0, &v) == LOFT_OK && loft_vec_equal(v, one.p[i]));
        CHECK(loft_natural_eval(&one.s, i, LOFT_UNIT(1), &v) == LOFT_OK &&
              loft_vec_equal(v, one.p[i + 1]));
    }
}

/* First derivatives to the last bit, second ones within both bounds. */
static void segments_join_with_two_derivatives(arb *a)
{
    if (!arb_spline(a, &one, arb_count(a)))
        return;
    for (uint32_t i = 0; i + 2 < one.count; i++)
        for (unsigned k = 1; k <= 2; k++) {
            loft_vec before = { { 0 } }, after = { { 0 } };
            const enum loft_status end = deriv(&one, i, k, LOFT_UNIT(1), &before),
                                   next = deriv(&one, i + 1, k, 0, &after);
            CHECK(k == 2 || (end == next && (end != LOFT_OK || loft_vec_equal(before, after))));
            for (int axis = 0; axis < LOFT_AXES && end == LOFT_OK && next == LOFT_OK; axis++) {
                const long double x = exact_of(before.axis[axis]),
                                  floats = ulp(x) + room(&one, i, k) + room(&one, i + 1, k);
                CHECK_EXACT(x, exact_of(after.axis[axis]), bound_by_num(LSB, floats, floats));
            }
        }
}

static void it_is_straight_at_both_ends(arb *a)
{
    quad zero[LOFT_AXES] = { 0 };
    loft_vec v = { { 0 } };

    if (!arb_spline(a, &one, arb_count(a)))
        return;
    const uint32_t last = one.count - 2;
    check_result(loft_natural_deriv(&one.s, 0, 2, 0, &v), &v, zero, 0.5L + 1 / 4096.0L,
                 room(&one, 0, 2));
    check_result(loft_natural_deriv(&one.s, last, 2, LOFT_UNIT(1), &v), &v, zero,
                 0.5L + 1 / 4096.0L, room(&one, last, 2));
}

/* Points on a line, evenly spaced: the line. */
static void linear_data_make_a_line(arb *a)
{
    const loft_vec from = arb_vec(a, 8000), step = arb_vec(a, 200);
    loft_vec v = { { 0 } };

    one.count = 2 + arb_below(a, 100);
    one.largest = 28000;
    for (uint32_t k = 0; k < one.count; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            one.p[k].axis[i] = from.axis[i] + (loft_real)(int32_t)k * step.axis[i];
    if (start(&one, both[arb_below(a, 2)]) != LOFT_OK)
        return;
    const uint32_t i = arb_below(a, one.count - 1);
    const loft_unit t = arb_unit(a);
    quad want[LOFT_AXES];
    for (int axis = 0; axis < LOFT_AXES; axis++)
        want[axis] = quad_of(from.axis[axis]) +
                     ((quad)i + (quad)exact_unit(t)) * quad_of(step.axis[axis]);
    check_result(loft_natural_eval(&one.s, i, t, &v), &v, want, 0.5L + 1 / 16384.0L,
                 bound_by_num(0, 4 * ulp(one.largest), 64 * ulp(one.largest)));
}

/* Compare the values of `two`, a transform of `one`, with those of `one` at the same or the
 * mirrored place. */
static void compare(arb *a, bool mirrored, long double factor, const loft_vec *by, long double lsb)
{
    const uint32_t i = arb_below(a, one.count - 1), j = mirrored ? one.count - 2 - i : i;
    const loft_unit t = arb_unit(a), u = mirrored ? LOFT_UNIT(1) - t : t;
    const long double size = factor * one.largest + 1000;
    loft_vec v = { { 0 } }, w = { { 0 } };

    if (loft_natural_eval(&one.s, i, t, &v) != LOFT_OK ||
        loft_natural_eval(&two.s, j, u, &w) != LOFT_OK)
        return;
    for (int axis = 0; axis < LOFT_AXES; axis++)
        CHECK_EXACT(factor * exact_of(v.axis[axis]) + exact_of(by->axis[axis]),
                    exact_of(w.axis[axis]),
                    bound_by_num(lsb * LSB, 8 * ulp(size), 128 * ulp(size)));
}

static void reversed_points_make_the_same_curve(arb *a)
{
    const loft_vec zero = { { 0 } };

    if (!arb_spline(a, &one, arb_count(a)))
        return;
    two.count = one.count;
    for (uint32_t k = 0; k < one.count; k++)
        two.p[k] = one.p[one.count - 1 - k];
    CHECK(start(&two, one.knots) == LOFT_OK);
    compare(a, true, 1, &zero, 1);
}

/* Equal to the last bit in q16: lengths and rises are the same. */
static void moved_points_make_the_curve_moved(arb *a)
{
    const loft_vec by = arb_vec(a, 1000);

    one.count = two.count = arb_count(a);
    one.largest = 9000;
    for (uint32_t k = 0; k < one.count; k++) {
        one.p[k] = arb_vec(a, 8000);
        two.p[k] = loft_vec_add(one.p[k], by);
    }
    const enum loft_spacing knots = both[arb_below(a, 2)];
    if (start(&one, knots) == LOFT_OK && start(&two, knots) == LOFT_OK)
        compare(a, false, 1, &by, 0);
}

static void points_of_double_size_make_the_curve_of_double_size(arb *a)
{
    const loft_vec zero = { { 0 } };

    if (!arb_spline(a, &one, arb_count(a)) || one.largest > 16000)
        return;
    two.count = one.count;
    for (uint32_t k = 0; k < one.count; k++)
        two.p[k] = loft_vec_add(one.p[k], one.p[k]);
    CHECK(start(&two, one.knots) == LOFT_OK);
    compare(a, false, 2, &zero, 1.501L);
}

#if LOFT_NUM != LOFT_Q16
/* Powers of two far beyond the coordinates of q16 keep all digits. */
static void size_does_not_matter_to_floats(arb *a)
{
    const long double factor = ldexpl(1, ((int)arb_below(a, 3) - 1) * BY_NUM(0, 80, 900));

    if (!arb_spline(a, &one, arb_count(a)))
        return;
    two.count = one.count;
    for (uint32_t k = 0; k < one.count; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            two.p[k].axis[i] = (loft_real)(factor * exact_of(one.p[k].axis[i]));
    CHECK(start(&two, one.knots) == LOFT_OK);
    const uint32_t i = arb_below(a, one.count - 1);
    const loft_unit t = arb_unit(a);
    loft_vec v = { { 0 } }, w = { { 0 } };
    CHECK(loft_natural_eval(&one.s, i, t, &v) == LOFT_OK &&
          loft_natural_eval(&two.s, i, t, &w) == LOFT_OK);
    for (int axis = 0; axis < LOFT_AXES; axis++)
        CHECK_EXACT(exact_of(w.axis[axis]) / factor, exact_of(v.axis[axis]), 0);
}
#endif

/* Coordinates exchanged: the axes influence each other only through the chord. */
static void exchanged_axes_make_the_curve_exchanged(arb *a)
{
    if (!arb_spline(a, &one, arb_count(a)))
        return;
    two.count = one.count;
    for (uint32_t k = 0; k < one.count; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            two.p[k].axis[i] = one.p[k].axis[LOFT_AXES - 1 - i];
    CHECK(start(&two, one.knots) == LOFT_OK);
    const uint32_t i = arb_below(a, one.count - 1);
    const loft_unit t = arb_unit(a);
    loft_vec v = { { 0 } }, w = { { 0 } };
    CHECK(loft_natural_eval(&one.s, i, t, &v) == loft_natural_eval(&two.s, i, t, &w));
    for (int axis = 0; axis < LOFT_AXES; axis++)
        CHECK_EXACT(exact_of(v.axis[axis]), exact_of(w.axis[LOFT_AXES - 1 - axis]),
                    bound_by_num(0, ulp(3 * one.largest), 128 * ulp(one.largest)));
}

static void control_points_are_within_their_bound_or_refused(arb *a)
{
    if (!arb_spline(a, &one, arb_count(a)))
        return;
    const uint32_t i = arb_below(a, one.count - 1);
    loft_cubic c = { { { { 0 } } } };
    const enum loft_status status = loft_cubic_from_natural(&one.s, i, &c);

    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && one.largest > 10000));
    for (unsigned k = 0; k < 4 && status == LOFT_OK; k++) {
        quad want[LOFT_AXES];
        for (int axis = 0; axis < LOFT_AXES; axis++)
            want[axis] = exact_natural_point(&one.own, i, k, axis);
        check_result(status, &c.p[k], want, 0.5L + 1 / 16384.0L, room(&one, i, 0));
    }
}

static void coinciding_points_have_no_chord(arb *a)
{
    const uint32_t count = 2 + arb_below(a, 20), at = arb_below(a, count - 1);
    loft_vec v = { { 0 } };

    one.count = count;
    for (uint32_t k = 0; k < count; k++)
        one.p[k] = arb_vec(a, 30000);
    one.p[at + 1] = one.p[at];
    CHECK(start(&one, LOFT_CHORD) == LOFT_SINGULAR);
    CHECK(start(&one, LOFT_UNIFORM) == LOFT_OK);
    CHECK(loft_natural_eval(&one.s, at, 0, &v) == LOFT_OK && same(v.axis[0], one.p[at].axis[0]));
}

static void mistakes_are_refused(arb *a)
{
    const loft_vec before = arb_vec(a, 100);
    loft_vec v = before;
    loft_natural s = { 0 };
    loft_cubic c;

    arb_points(a, &one, 5);
    CHECK(loft_natural_init(&s, one.p, 0, LOFT_UNIFORM, one.memory) == LOFT_ERR_ARG && s.p == NULL);
    CHECK(loft_natural_init(&s, one.p, 1, LOFT_CHORD, one.memory) == LOFT_ERR_ARG && s.p == NULL);
    CHECK(loft_natural_init(&s, one.p, 5, LOFT_UNIFORM, one.memory) == LOFT_OK);
    CHECK(loft_natural_eval(&s, 4, 0, &v) == LOFT_ERR_ARG &&
          loft_natural_eval(&s, UINT32_MAX, 0, &v) == LOFT_ERR_ARG);
    CHECK(loft_natural_eval(&s, 0, LOFT_UNIT(1.01), &v) == LOFT_ERR_ARG &&
          loft_natural_eval(&s, 0, LOFT_UNIT(-0.01), &v) == LOFT_ERR_ARG);
    CHECK(loft_natural_deriv(&s, 0, 0, 0, &v) == LOFT_ERR_ARG &&
          loft_natural_deriv(&s, 0, 3, 0, &v) == LOFT_ERR_ARG);
    CHECK(loft_natural_deriv(&s, 4, 1, 0, &v) == LOFT_ERR_ARG &&
          loft_cubic_from_natural(&s, 4, &c) == LOFT_ERR_ARG);
    CHECK(loft_vec_equal(v, before));
#if LOFT_NUM != LOFT_Q16
    one.p[3].axis[0] = (loft_real)NAN;
    CHECK(loft_natural_init(&s, one.p, 5, LOFT_UNIFORM, one.memory) == LOFT_ERR_RANGE);
    one.p[3].axis[0] = (loft_real)INFINITY;
    CHECK(loft_natural_init(&s, one.p, 5, LOFT_CHORD, one.memory) == LOFT_ERR_RANGE);
#endif
}

int main(void)
{
    PROPERTY(points_and_derivatives_are_within_their_bound,         3000);
    PROPERTY(a_thousand_points_are_as_exact_as_few,                   12);
    PROPERTY(slopes_are_within_their_bound,                         2000);
    PROPERTY(it_goes_through_its_points,                            1000);
    PROPERTY(segments_join_with_two_derivatives,                    1000);
    PROPERTY(it_is_straight_at_both_ends,                           1000);
    PROPERTY(linear_data_make_a_line,                               1000);
    PROPERTY(reversed_points_make_the_same_curve,                   1000);
    PROPERTY(moved_points_make_the_curve_moved,                     1000);
    PROPERTY(points_of_double_size_make_the_curve_of_double_size,   1000);
#if LOFT_NUM != LOFT_Q16
    PROPERTY(size_does_not_matter_to_floats,                        1000);
#endif
    PROPERTY(exchanged_axes_make_the_curve_exchanged,               1000);
    PROPERTY(control_points_are_within_their_bound_or_refused,      3000);
    PROPERTY(coinciding_points_have_no_chord,                        500);
    PROPERTY(mistakes_are_refused,                                   100);
    return check_failures();
}

/* tests/lib/geom/test_vec.c -- points and boxes: lib/geom/vec.h against long double
 * SPDX-License-Identifier: MIT
 */
#include <math.h>           /* sqrtl, frexpl, ldexpl: the reference */

#include "check.h"          /* CHECK, CHECK_NEAR, PROPERTY, BY_NUM */

/* The distance between neighbouring coordinates at x, in units. */
static long double lsb(long double x)
{
    int exponent;
    frexpl(x, &exponent);
    return BY_NUM(0x1p-16L, ldexpl(1, exponent - 24), ldexpl(1, exponent - 53));
}

static long double wide(loft_acc x) { return BY_NUM(0x1p-32L, 1, 1) * (long double)x; }

static void sums_and_differences_are_those_of_the_axes(arb *a)
{
    const loft_vec x = arb_vec(a, 16383), y = arb_vec(a, 16383), sum = loft_vec_add(x, y),
                   difference = loft_vec_sub(x, y);

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double u = arb_value(x.axis[i]), v = arb_value(y.axis[i]);
        CHECK_NEAR(arb_value(sum.axis[i]) - (u + v), 0, BY_NUM(0, 0.5, 0.5) * lsb(u + v));
        CHECK_NEAR(arb_value(difference.axis[i]) - (u - v), 0, BY_NUM(0, 0.5, 0.5) * lsb(u - v));
    }
}

static void lerp_is_within_its_bound_and_exact_at_the_ends(arb *a)
{
    const loft_vec x = arb_vec(a, 32767), y = arb_vec(a, 32767);
    const loft_unit t = arb_unit(a);
    const loft_vec z = loft_vec_lerp(x, y, t);
    const long double s = BY_NUM(0x1p-24L, 1, 1) * (long double)t;

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double u = arb_value(x.axis[i]), v = arb_value(y.axis[i]);
        const long double larger = fabsl(u) > fabsl(v) ? u : v;
        CHECK_NEAR(arb_value(z.axis[i]) - (u + s * (v - u)), 0, BY_NUM(0.5, 2, 2) * lsb(larger));
    }
    CHECK(loft_vec_equal(loft_vec_lerp(x, y, LOFT_UNIT(0)), x));
    CHECK(loft_vec_equal(loft_vec_lerp(x, y, LOFT_UNIT(1)), y));
}

static void equal_means_every_axis(arb *a)
{
    const loft_vec x = arb_vec(a, 32766);
    loft_vec y = x;

    CHECK(loft_vec_equal(x, y));
    y.axis[arb_below(a, LOFT_AXES)] += arb_below(a, 2) ? LOFT_REAL(0.25) : -LOFT_REAL(0.25);
    CHECK(!loft_vec_equal(x, y) && !loft_vec_equal(y, x));
}

static void within_means_every_axis(arb *a)
{
    const loft_vec x = arb_vec(a, 1000);
    loft_vec y = x;

    CHECK(loft_vec_within(x, LOFT_REAL(1000)));
    y.axis[arb_below(a, LOFT_AXES)] = arb_below(a, 2) ? LOFT_REAL(1000.25) : LOFT_REAL(-1000.25);
    CHECK(!loft_vec_within(y, LOFT_REAL(1000)));
    CHECK(loft_vec_within(y, LOFT_REAL(1000.25)));
#if LOFT_NUM != LOFT_Q16
    y.axis[0] = (loft_real)NAN;
    CHECK(!loft_vec_within(y, LOFT_REAL_MAX));
#endif
}

static void dot_is_the_sum_of_the_products(arb *a)
{
    const loft_vec x = arb_vec(a, 13000), y = arb_vec(a, 13000);
    long double want = 0, size = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double product = (long double)arb_value(x.axis[i]) * arb_value(y.axis[i]);
        want += product;
        size += fabsl(product);
    }
    CHECK_NEAR(wide(loft_vec_dot(x, y)) - want, 0,
               BY_NUM(0, LOFT_AXES * 0x1p-53L, LOFT_AXES * 0x1p-53L) * size);
}

static void distance_holds_for_any_two_points(arb *a)
{
    const loft_vec x = arb_vec(a, 32767), y = arb_below(a, 4) ? arb_vec(a, 32767) : x;
    long double sum = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double d = (long double)arb_value(y.axis[i]) - arb_value(x.axis[i]);
        sum += d * d;
    }
    const long double want = sqrtl(sum);
    CHECK_NEAR(wide(loft_vec_distance(x, y)) - want, 0,
               BY_NUM(0x1p-28L * want + 0x1p-32L, 0x1p-50L * want, 0x1p-50L * want));
    CHECK(loft_vec_distance(x, y) <= loft_vec_distance(y, x) &&
          loft_vec_distance(y, x) <= loft_vec_distance(x, y));
}

static void box_is_the_smallest_around_its_points(arb *a)
{
    loft_vec p[5];
    loft_box box;

    for (int k = 0; k < 5; k++) {
        p[k] = arb_vec(a, 32767);
        box = k ? loft_box_join(box, p[k]) : (loft_box){ p[0], p[0] };
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        bool low = false, high = false;
        for (int k = 0; k < 5; k++) {
            CHECK(p[k].axis[i] >= box.min.axis[i] && p[k].axis[i] <= box.max.axis[i]);
            low  = low  || p[k].axis[i] <= box.min.axis[i];
            high = high || p[k].axis[i] >= box.max.axis[i];
        }
        CHECK(low && high);
    }
}

int main(void)
{
    PROPERTY(sums_and_differences_are_those_of_the_axes,     20000);
    PROPERTY(lerp_is_within_its_bound_and_exact_at_the_ends, 50000);
    PROPERTY(equal_means_every_axis,                          5000);
    PROPERTY(within_means_every_axis,                         5000);
    PROPERTY(dot_is_the_sum_of_the_products,                 20000);
    PROPERTY(distance_holds_for_any_two_points,              50000);
    PROPERTY(box_is_the_smallest_around_its_points,          10000);
    return check_failures();
}

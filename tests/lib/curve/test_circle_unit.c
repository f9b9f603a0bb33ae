/* tests/lib/curve/test_circle_unit.c -- properties of lib/curve/circle.h: arcs of the unit circle
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"              /* exact_of, exact_eval, ulp */
#include "curve/circle.h"

static void the_arm_touches_the_circle_and_leaves_it_by_no_more_than_stated(arb *a)
{
    const long double arm = exact_acc(loft_circle_arm()), want = 4 * (sqrtl(2) - 1) / 3,
                      t = exact_unit(arb_unit(a));
    const long double cx[4] = { 1, 1, arm, 0 }, cy[4] = { 0, arm, 1, 1 };
    const long double x = exact_eval(cx, 3, t), y = exact_eval(cy, 3, t),
                      off = sqrtl(x * x + y * y) - 1;

    CHECK_EXACT(arm, want, BY_NUM(0x1p-33L, 0x1p-52L, 0x1p-52L));
    CHECK(off <= 2.73e-4L && off >= -BY_NUM(0x1p-33L, 0x1p-52L, 0x1p-52L));
}

static void a_quarter_arc_is_within_its_bound(arb *a)
{
    const loft_acc arm = arb_below(a, 2) ? loft_circle_arm()
                                         : loft_to_acc(arb_real(a, 1 << arb_below(a, 15)));
    const loft_unit t = arb_unit(a);
    const long double l = exact_acc(arm), cx[4] = { 1, 1, l, 0 }, cy[4] = { 0, l, 1, 1 };
    const long double x = exact_eval(cx, 3, exact_unit(t)), y = exact_eval(cy, 3, exact_unit(t)),
                      e = x * x + y * y - 1;
    const long double size = 1 + fabsl(l);
    loft_real p[2], excess;

    const enum loft_status status = loft_circle_quarter(arm, t, p, &excess);
    if (status != LOFT_OK) {
        CHECK(status == LOFT_ERR_RANGE && BY_NUM(fabsl(e) > 32767, false, false));
        return;
    }
    CHECK(BY_NUM(e < 32768, true, true));
    CHECK_EXACT(exact_of(p[0]), x,
                ulp(x) / 2 + BY_NUM(0x1p-31L, 0x1p-49L, 0x1p-49L) * BY_NUM(1, size, size));
    CHECK_EXACT(exact_of(p[1]), y,
                ulp(y) / 2 + BY_NUM(0x1p-31L, 0x1p-49L, 0x1p-49L) * BY_NUM(1, size, size));
    CHECK_EXACT(exact_of(excess), e,
                ulp(e) / 2 +
                    BY_NUM(0x1p-28L * size, 0x1p-48L * size * size, 0x1p-48L * size * size));
}

static loft_real of_raw(int32_t raw)
{
    return (loft_real)BY_NUM(raw, raw / 65536.0, raw / 65536.0);
}

/* Angles down to the last one above -pi/6, where the distance grows without bound. */
static loft_real arb_theta(arb *a)
{
    const int32_t least = -34314, most = 102943;
    const int32_t raw = arb_below(a, 4)
                            ? least + (int32_t)arb_below(a, (uint32_t)(most - least + 1))
                        : arb_below(a, 2) ? least + (int32_t)arb_below(a, 8)
                                          : most - (int32_t)arb_below(a, 8);
    return of_raw(raw);
}

static void an_arc_over_the_top_is_within_its_bound(arb *a)
{
    const loft_real theta = arb_theta(a);
    const long double x = exact_of(theta), base = 1 + 2 * sinl(x), want = 2 * cosl(x) / base,
                      square = 1 + want * want;
    loft_real distance, weight;

    const enum loft_status status = loft_circle_over(theta, &distance, &weight);
    if (status != LOFT_OK) {
        CHECK(status == LOFT_ERR_RANGE && BY_NUM(want > 32767, false, false));
        return;
    }
    CHECK_EXACT(exact_of(distance), want,
                ulp(want) / 2 + BY_NUM(0x1p-56L, 0x1p-50L, 0x1p-50L) * square);
    CHECK_EXACT(exact_of(weight), base / 3,
                ulp(base / 3) / 2 + BY_NUM(0x1p-32L, 0x1p-50L, 0x1p-50L));
}

/* On the circle, and on the rational cubic of that distance and weight. */
static void its_points_are_on_the_circle(arb *a)
{
    const loft_real theta = arb_theta(a);
    const loft_unit t = arb_unit(a);
    const long double c = cosl(exact_of(theta)), s = sinl(exact_of(theta));
    const long double wx[4] = { c, c / 3, -c / 3, -c }, wy[4] = { s, (s + 2) / 3, (s + 2) / 3, s },
                      w[4] = { 1, (1 + 2 * s) / 3, (1 + 2 * s) / 3, 1 };
    const long double base = exact_eval(w, 3, exact_unit(t)),
                      x = exact_eval(wx, 3, exact_unit(t)) / base,
                      y = exact_eval(wy, 3, exact_unit(t)) / base;
    const long double more = BY_NUM(0x1p-32L, 0x1p-50L, 0x1p-50L);
    loft_real p[2];

    CHECK(loft_circle_over_eval(theta, t, p) == LOFT_OK);
    CHECK_EXACT(exact_of(p[0]), x, ulp(x) / 2 + more);
    CHECK_EXACT(exact_of(p[1]), y, ulp(y) / 2 + more);
    CHECK_EXACT(sqrtl(exact_of(p[0]) * exact_of(p[0]) + exact_of(p[1]) * exact_of(p[1])), 1,
                ulp(1) + 2 * more);
}

static void angles_outside_are_refused(arb *a)
{
    const loft_real bad[6] = { of_raw(-34315), of_raw(102944),   LOFT_REAL(3),
                               LOFT_REAL(-2),  LOFT_REAL(32767), LOFT_REAL(-32768) };
    loft_real p[2] = { 7, 7 }, q = 7;

    (void)a;
    for (int i = 0; i < 6; i++) {
        CHECK(loft_circle_over(bad[i], &p[0], &q) == LOFT_ERR_ARG);
        CHECK(loft_circle_over_eval(bad[i], 0, p) == LOFT_ERR_ARG);
    }
    const loft_unit beyond[2] = { LOFT_UNIT(1.001), LOFT_UNIT(-0.001) };
    for (int i = 0; i < 2; i++) {
        CHECK(loft_circle_over_eval(0, beyond[i], p) == LOFT_ERR_ARG);
        CHECK(loft_circle_quarter(loft_circle_arm(), beyond[i], p, &q) == LOFT_ERR_ARG);
    }
    CHECK(!(p[0] > 7) && !(p[0] < 7) && !(q > 7) && !(q < 7));
}

int main(void)
{
    PROPERTY(the_arm_touches_the_circle_and_leaves_it_by_no_more_than_stated, 2000);
    PROPERTY(a_quarter_arc_is_within_its_bound,                               8000);
    PROPERTY(an_arc_over_the_top_is_within_its_bound,                         8000);
    PROPERTY(its_points_are_on_the_circle,                                    8000);
    PROPERTY(angles_outside_are_refused,                                         1);
    return check_failures();
}

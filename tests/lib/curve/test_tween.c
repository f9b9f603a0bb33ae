/* tests/lib/curve/test_tween.c -- properties of lib/curve/tween.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"      /* exact_unit; CHECK, PROPERTY, BY_NUM */
#include "curve/tween.h"

#define NEAR BY_NUM(0x1p-19L, 0x1p-19L, 0x1p-44L)

typedef struct {
    loft_unit x1, y1, x2, y2;
    loft_tween e;
} sample;

static sample arb_sample(arb *a)
{
    sample s = { .x1 = arb_unit(a), .x2 = arb_unit(a) };
    const int32_t size = 1 + (int32_t)arb_below(a, 8);

    s.y1 = (loft_unit)((loft_unit)size * (2 * arb_unit(a) - LOFT_UNIT(1)));
    s.y2 = (loft_unit)((loft_unit)size * (2 * arb_unit(a) - LOFT_UNIT(1)));
    CHECK(loft_tween_init(&s.e, s.x1, s.y1, s.x2, s.y2) == LOFT_OK);
    return s;
}

static long double cubic(long double a, long double b, long double s)
{
    return 3 * a * s * (1 - s) * (1 - s) + 3 * b * s * s * (1 - s) + s * s * s;
}

/* The parameter where x(s) = x. */
static long double solved(const sample *s, long double x)
{
    const long double x1 = exact_unit(s->x1), x2 = exact_unit(s->x2);
    long double low = 0, high = 1;

    for (int i = 0; i < 70; i++) {
        const long double middle = (low + high) / 2;
        if (cubic(x1, x2, middle) < x)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Somewhere on the curve between t - NEAR and t + NEAR is the result. */
static void the_point_is_on_the_curve(arb *a)
{
    const sample s = arb_sample(a);
    const loft_unit t = arb_unit(a);
    const long double x = exact_unit(t), got = exact_unit(loft_tween_eval(&s.e, t));
    const long double from = solved(&s, x - NEAR), to = solved(&s, x + NEAR);
    long double least = HUGE_VALL, most = -HUGE_VALL;

    for (int i = 0; i <= 64; i++) {
        const long double y = cubic(exact_unit(s.y1), exact_unit(s.y2),
                                    from + (to - from) * i / 64);
        least = fminl(least, y);
        most  = fmaxl(most, y);
    }
    CHECK(got >= least - NEAR && got <= most + NEAR);
}

static void it_begins_and_ends_where_it_must(arb *a)
{
    const sample s = arb_sample(a);

    CHECK(loft_tween_eval(&s.e, 0) == 0 && loft_tween_eval(&s.e, LOFT_UNIT(1)) == LOFT_UNIT(1));
    CHECK(loft_tween_eval(&s.e, -LOFT_UNIT(1)) == 0);
    CHECK(loft_tween_eval(&s.e, LOFT_UNIT(2)) == LOFT_UNIT(1));
}

/* y = x by way of points on the diagonal; `ease` by a browser at 0.25, 0.5 and 0.75. */
static void known_curves_are_met(arb *a)
{
    static const struct {
        double t, y;
    } ease[] = { { 0.25, 0.4085 }, { 0.5, 0.8024 }, { 0.75, 0.9605 } };
    const loft_unit t = arb_unit(a), x1 = arb_unit(a), x2 = arb_unit(a);
    loft_tween e;

    CHECK(loft_tween_init(&e, x1, x1, x2, x2) == LOFT_OK);
    CHECK_NEAR(exact_unit(loft_tween_eval(&e, t)), exact_unit(t), NEAR);
    CHECK(loft_tween_init(&e, LOFT_UNIT(0.25), LOFT_UNIT(0.1), LOFT_UNIT(0.25), LOFT_UNIT(1)) ==
          LOFT_OK);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(exact_unit(loft_tween_eval(&e, loft_unit_of((uint32_t)i + 1, 4))), ease[i].y,
                   6e-5);
}

static void what_is_no_function_is_refused(arb *a)
{
    const loft_unit x = arb_unit(a), one = LOFT_UNIT(1), beyond = one + LOFT_UNIT(0x1p-20);
    loft_tween e;

    CHECK(loft_tween_init(&e, beyond, 0, x, one) == LOFT_ERR_ARG);
    CHECK(loft_tween_init(&e, x, 0, -LOFT_UNIT(0x1p-20), one) == LOFT_ERR_ARG);
    CHECK(loft_tween_init(&e, x, 9 * one, x, one) == LOFT_ERR_RANGE);
    CHECK(loft_tween_init(&e, x, 0, x, -9 * one) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(the_point_is_on_the_curve, 5000);
    PROPERTY(it_begins_and_ends_where_it_must, 2000);
    PROPERTY(known_curves_are_met, 2000);
    PROPERTY(what_is_no_function_is_refused, 1000);
    return check_failures();
}

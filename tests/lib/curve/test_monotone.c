/* tests/lib/curve/test_monotone.c -- properties of lib/curve/monotone.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* quad_of; CHECK, PROPERTY, BY_NUM */
#include "curve/monotone.h"

#define MOST 12
#define STEEPEST 0x1p22L

typedef struct {
    loft_real x[MOST], y[MOST];
    loft_acc slope[MOST];
    uint32_t count;
    loft_monotone f;
    long double largest, secant[MOST], steepest;
} sample;

/* Points of any size at even or uneven distances, with level places and steps. */
static sample arb_sample(arb *a)
{
    sample s = { .count = 2 + arb_below(a, MOST - 1) };
    const int32_t limit = (int32_t)1 << arb_below(a, 14),
                  step = (int32_t)1 << (4 + arb_below(a, 17));
    int32_t x = -(int32_t)arb_below(a, 1u << 24);

    for (uint32_t i = 0; i < s.count; i++) {
        s.x[i] = loft_real_from_raw(x);
        x += 1 + (int32_t)arb_below(a, (uint32_t)step << 4);
        s.y[i] = i > 0 && arb_below(a, 4) == 0 ? s.y[i - 1] : arb_real(a, limit);
        s.largest = fmaxl(s.largest, fabsl(exact_of(s.y[i])));
    }
    for (uint32_t i = 0; i + 1 < s.count; i++) {
        s.secant[i] = (exact_of(s.y[i + 1]) - exact_of(s.y[i])) /
                      (exact_of(s.x[i + 1]) - exact_of(s.x[i]));
        s.steepest = fmaxl(s.steepest, fabsl(s.secant[i]));
    }
    return s;
}

static bool made(sample *s)
{
    const enum loft_status status = loft_monotone_init(&s->f, s->x, s->y, s->count, s->slope);

    if (fabsl(s->steepest - STEEPEST) > STEEPEST * 0x1p-14L)
        CHECK((status == LOFT_OK) == (s->steepest < STEEPEST));
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    return status == LOFT_OK;
}

/* The slopes by the text, in long double. */
static void true_slopes(const sample *s, long double m[MOST])
{
    const uint32_t last = s->count - 1;

    m[0] = s->secant[0];
    m[last] = s->secant[last - 1];
    for (uint32_t i = 1; i < last; i++)
        m[i] = s->secant[i - 1] * s->secant[i] <= 0 ? 0 : (s->secant[i - 1] + s->secant[i]) / 2;
    for (uint32_t i = 0; i < last; i++) {
        const long double d = s->secant[i], length = sqrtl(m[i] * m[i] + m[i + 1] * m[i + 1]);
        if (d == 0)
            m[i] = m[i + 1] = 0;
        else if (length > 3 * fabsl(d)) {
            m[i] *= 3 * fabsl(d) / length;
            m[i + 1] *= 3 * fabsl(d) / length;
        }
    }
}

static loft_real arb_between(arb *a, const sample *s, uint32_t *i)
{
    *i = arb_below(a, s->count - 1);
    const loft_real x = loft_lerp(s->x[*i], s->x[*i + 1], arb_unit(a));
    return x < s->x[*i] ? s->x[*i] : x > s->x[*i + 1] ? s->x[*i + 1] : x;
}

static void values_and_slopes_are_within_their_bound(arb *a)
{
    sample s = arb_sample(a);
    long double m[MOST];
    uint32_t i;

    if (!made(&s))
        return;
    true_slopes(&s, m);
    const long double of_slopes = BY_NUM(0x1p-30L, 0x1p-47L * s.steepest, 0x1p-47L * s.steepest);
    for (uint32_t k = 0; k < s.count; k++)
        CHECK_NEAR(exact_acc(s.slope[k]), m[k], of_slopes);
    const loft_real x = arb_between(a, &s, &i);
    const long double x0 = exact_of(s.x[i]), h = exact_of(s.x[i + 1]) - x0;
    const long double t = (exact_of(x) - x0) / h, u = 1 - t, y0 = exact_of(s.y[i]),
                      y1 = exact_of(s.y[i + 1]);
    const long double value = y0 * u * u * (1 + 2 * t) + y1 * t * t * (3 - 2 * t) +
                              h * (m[i] * t * u * u - m[i + 1] * t * t * u);
    const long double deriv = m[i] * u * u + m[i + 1] * t * t +
                              2 * t * u * (3 * s.secant[i] - m[i] - m[i + 1]);
    CHECK_NEAR(exact_of(loft_monotone_eval(&s.f, x)), value,
               BY_NUM(0x1p-17L + h * 0x1p-31L, ulp(value) * 0.5001L + s.largest * 0x1p-45L,
                      64 * ulp(s.largest)));
    if (i + 2 < s.count ? x < s.x[i + 1] : true)
        CHECK_NEAR(exact_acc(loft_monotone_deriv(&s.f, x)), deriv, 4 * of_slopes);
}

/* To the last bit, and it goes on beyond the ends. */
static void it_goes_through_its_points(arb *a)
{
    sample s = arb_sample(a);

    if (!made(&s))
        return;
    for (uint32_t i = 0; i < s.count; i++)
        CHECK(loft_monotone_eval(&s.f, s.x[i]) == s.y[i]);
    CHECK(loft_monotone_eval(&s.f, s.x[0] - LOFT_REAL(1)) == s.y[0]);
    CHECK(loft_monotone_eval(&s.f, s.x[s.count - 1] + LOFT_REAL(1)) == s.y[s.count - 1]);
    CHECK(loft_monotone_deriv(&s.f, s.x[0] - LOFT_REAL(1)) == 0);
}

static void it_stays_between_the_points(arb *a)
{
    sample s = arb_sample(a);
    uint32_t i;

    if (!made(&s))
        return;
    const loft_real x = arb_between(a, &s, &i), y = loft_monotone_eval(&s.f, x);
    const loft_real low = s.y[i] < s.y[i + 1] ? s.y[i] : s.y[i + 1],
                    high = s.y[i] < s.y[i + 1] ? s.y[i + 1] : s.y[i];
    const long double room = BY_NUM(0x1p-17L + (exact_of(s.x[i + 1]) - exact_of(s.x[i])) * 0x1p-31L,
                                    ulp(s.largest), 64 * ulp(s.largest));
    CHECK(exact_of(y) >= exact_of(low) - room && exact_of(y) <= exact_of(high) + room);
}

/* It rises where the points rise: the slope has the sign of the secant. */
static void it_turns_at_points_alone(arb *a)
{
    sample s = arb_sample(a);
    uint32_t i;

    if (!made(&s))
        return;
    const loft_real x = arb_between(a, &s, &i);
    const long double slope = exact_acc(loft_monotone_deriv(&s.f, x)),
                      room = BY_NUM(0x1p-28L, s.steepest * 0x1p-45L, s.steepest * 0x1p-45L);
    if (x < s.x[i + 1])
        CHECK(s.secant[i] > 0   ? slope >= -room
              : s.secant[i] < 0 ? slope <= room
                                : fabsl(slope) <= room);
}

static void a_line_stays_a_line(arb *a)
{
    const int32_t slope = (int32_t)arb_below(a, 2001) - 1000;
    sample s = { .count = MOST };
    uint32_t i;

    for (uint32_t k = 0; k < MOST; k++) {
        s.x[k] = loft_real_from_raw((int32_t)(k * k * 4096));
        s.y[k] = loft_real_from_raw((int32_t)(k * k) * 4 * slope);
    }
    CHECK(loft_monotone_init(&s.f, s.x, s.y, s.count, s.slope) == LOFT_OK);
    const loft_real x = arb_between(a, &s, &i);
    CHECK_NEAR(exact_of(loft_monotone_eval(&s.f, x)), exact_of(x) * slope / 1024,
               BY_NUM(0x1p-16L, 0x1p-20L, 0x1p-44L));
}

static void what_is_no_function_is_refused(arb *a)
{
    sample s = arb_sample(a);
    const uint32_t i = arb_below(a, s.count - 1);

    CHECK(loft_monotone_init(&s.f, s.x, s.y, 1, s.slope) == LOFT_ERR_ARG);
    s.x[i + 1] = s.x[i];
    CHECK(loft_monotone_init(&s.f, s.x, s.y, s.count, s.slope) != LOFT_OK);
    s.x[0] = 0, s.x[1] = 0, s.y[0] = 0, s.y[1] = 0;
    CHECK(loft_monotone_init(&s.f, s.x, s.y, 2, s.slope) == LOFT_ERR_ARG);
    s.x[1] = loft_real_from_raw(1), s.y[1] = LOFT_REAL(20000);
    CHECK(loft_monotone_init(&s.f, s.x, s.y, 2, s.slope) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(values_and_slopes_are_within_their_bound, 20000);
    PROPERTY(it_goes_through_its_points, 5000);
    PROPERTY(it_stays_between_the_points, 20000);
    PROPERTY(it_turns_at_points_alone, 20000);
    PROPERTY(a_line_stays_a_line, 2000);
    PROPERTY(what_is_no_function_is_refused, 1000);
    return check_failures();
}

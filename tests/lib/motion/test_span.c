/* tests/lib/motion/test_span.c -- properties of lib/motion/span.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"          /* CHECK, PROPERTY */
#include "motion/span.h"    /* loft_span_walk */

static loft_span arb_span(arb *a)
{
    loft_span s;
    for (int k = 0; k < 4; k++)
        s.p[k] = arb_vec(a, arb_below(a, 2) ? 8191 : 1);
    s.ticks = (uint16_t)(1 + (arb_below(a, 8) ? arb_below(a, LOFT_SPAN_TICKS_MAX)
                                              : arb_below(a, 2) * (LOFT_SPAN_TICKS_MAX - 1)));
    return s;
}

/* One point per tick, on the cubic at tick / ticks; the last one is the end, exactly. */
static void a_walk_yields_the_position_after_each_tick(arb *a)
{
    const loft_span s = arb_span(a);
    loft_forward w;
    loft_vec p = s.p[0];
    unsigned n = 0;

    CHECK(loft_span_walk(&w, &s) == LOFT_OK);
    while (n <= s.ticks && loft_forward_next(&w, &p)) {
        const long double t = (long double)++n / s.ticks, q = 1 - t;
        for (int i = 0; i < LOFT_AXES; i++) {
            const long double x[4] = { arb_value(s.p[0].axis[i]), arb_value(s.p[1].axis[i]),
                                       arb_value(s.p[2].axis[i]), arb_value(s.p[3].axis[i]) };
            const long double want = q * q * q * x[0] + 3 * q * q * t * x[1] +
                                     3 * q * t * t * x[2] + t * t * t * x[3];
            CHECK_NEAR(arb_value(p.axis[i]) - want, 0,
                       BY_NUM(0.521 / 65536, 8191 * 0x1p-24, 8191 * 0x1p-39));
        }
    }
    CHECK(n == s.ticks && loft_vec_equal(p, s.p[3]));
}

/* Coordinates of all sizes, the largest too: a span of two ticks needs no walk, and steps as if it
 * had one. */
static void the_middle_is_what_a_walk_of_two_ticks_passes(arb *a)
{
    static const int32_t extreme[4] = { INT32_MIN, INT32_MAX, INT32_MIN + 7, -1 };
    const bool walkable = arb_below(a, 4) != 0;     /* a walk takes half the range */
    loft_span s = { .ticks = 2 };
    loft_forward w;
    loft_vec p;
    int64_t sum[LOFT_AXES] = { 0 };

    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 4; k++) {
            const int32_t any = (int32_t)(uint32_t)arb_next(a),
                          raw = walkable          ? any / 4 >> arb_below(a, 28)
                                : arb_below(a, 3) ? any
                                                  : extreme[arb_below(a, 4)];
            s.p[k].axis[i] = loft_real_from_raw(raw);
            sum[i] += (k % 3 ? 3 : 1) *
                      (int64_t)(BY_NUM(raw, (double)loft_real_from_raw(raw) * 65536, raw));
        }
    if (walkable)
        CHECK(loft_span_walk(&w, &s) == LOFT_OK && loft_forward_next(&w, &p));
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real half = loft_walk3_middle(s.p[0].axis[i], s.p[1].axis[i], s.p[2].axis[i],
                                                 s.p[3].axis[i]);
        const int64_t down = sum[i] + 4 >= 0 ? (sum[i] + 4) / 8 : -((3 - sum[i]) / 8);
        (void)down;             /* floats keep what is below 1 LSB */
        CHECK(half == BY_NUM(loft_real_from_raw((int32_t)down),
                             (loft_real)((double)sum[i] / 524288),
                             (loft_real)((double)sum[i] / 524288)));
        if (walkable)
            CHECK(half == p.axis[i]);
    }
}

static void impossible_ticks_are_refused(arb *a)
{
    loft_span s = arb_span(a);
    loft_forward w;

    s.ticks = 0;
    CHECK(loft_span_walk(&w, &s) == LOFT_ERR_RANGE);
    s.ticks = (uint16_t)(LOFT_SPAN_TICKS_MAX + 1 + arb_below(a, 64000));
    CHECK(loft_span_walk(&w, &s) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(a_walk_yields_the_position_after_each_tick, 1000);
    PROPERTY(the_middle_is_what_a_walk_of_two_ticks_passes, 2000);
    PROPERTY(impossible_ticks_are_refused,                100);
    return check_failures();
}

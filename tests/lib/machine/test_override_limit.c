/* tests/lib/machine/test_override_limit.c -- properties of lib/machine/override_limit.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "check.h"
#include "machine/override_limit.h"

typedef struct {
    loft_item before, item;
    int32_t from[LOFT_AXES];
    loft_axis_config axis[LOFT_AXES];
    uint16_t tick_hz;
} span_case;

static int32_t some(arb *a, uint32_t bits) { return arb_raw(a, (int32_t)1 << arb_below(a, bits)); }

/* A span that continues the last one, up to the rounding of its points. */
static void arb_span(arb *a, span_case *c)
{
    static const uint16_t hz[4] = { 50, 1000, 3000, 50000 };

    c->tick_hz = hz[arb_below(a, 4)];
    c->item.ticks = (uint16_t)(1 + arb_below(a, arb_below(a, 2) ? 100 : LOFT_SPAN_TICKS_MAX));
    c->before.ticks = (uint16_t)(1 + arb_below(a, LOFT_SPAN_TICKS_MAX));
    const uint32_t size = 1 + arb_below(a, 22);
    for (int i = 0; i < LOFT_AXES; i++) {
        const int32_t e = some(a, size);
        c->from[i] = some(a, 26);
        c->before.p[2][i] = c->from[i];
        c->before.p[1][i] = c->from[i] - e;
        c->item.p[0][i] = c->from[i] + (int32_t)lround((double)e * c->item.ticks / c->before.ticks);
        c->item.p[1][i] = c->item.p[0][i] + (c->item.p[0][i] - c->from[i]) + some(a, size);
        c->item.p[2][i] = c->item.p[1][i] + (c->item.p[1][i] - c->item.p[0][i]) + some(a, size);
        c->axis[i] = (loft_axis_config){ 65536,
                                         arb_below(a, 8) ? (int32_t)arb_below(a, 16383u << 16) : 0,
                                         arb_below(a, 8) ? (int32_t)arb_below(a, 16383u << 16) : 0,
                                         arb_below(a, 2) ? arb_below(a, 10000000) : 0 };
    }
}

/* The r^2 that the limits of an axis allow in exact numbers. Points may be off by `rounding` times
 * 1/2, in the worst direction. *fine: each intermediate value is at least 2^8 and below 2^32, and
 * the span is not one that is always as planned. */
static double allows(const span_case *c, int i, double rounding, bool *fine)
{
    const double p[4] = { c->from[i], c->item.p[0][i], c->item.p[1][i], c->item.p[2][i] };
    const double s = (double)c->item.ticks / c->tick_hz, speed = c->axis[i].max_speed * s,
                 accel = c->axis[i].max_accel * s * s;
    const double jerk = c->axis[i].max_jerk * 65536. * s * s * s;
    double d1 = 0, d2 = 0;

    for (int k = 0; k < 3; k++)
        d1 = fmax(d1, fabs(p[k + 1] - p[k]) - rounding);
    for (int k = 0; k < 2; k++)
        d2 = fmax(d2, fabs(p[k + 2] - 2 * p[k + 1] + p[k]) - 2 * rounding);
    const double d3 = fabs(p[3] - 3 * p[2] + 3 * p[1] - p[0]) - 4 * rounding;
    double r2 = 4;
    if (speed > 0 && d1 > 0)
        r2 = fmin(r2, pow(speed / (3 * d1), 2));
    if (accel > 0 && d2 > 0)
        r2 = fmin(r2, accel / (6 * d2));
    if (jerk > 0 && d3 > 0)
        r2 = fmin(r2, pow(jerk / (6 * d3), 2 / 3.));
    *fine = *fine && !(speed > 0 && speed < 256) && !(accel > 0 && accel < 256 * fmax(1, s)) &&
            !(jerk > 0 && jerk < 256 * fmax(1, s * s)) &&
            c->item.ticks * 4194304. / c->tick_hz > 1000 && s < 4 &&
            c->axis[i].max_jerk * s < 65000 && d1 < 134217728;
    return r2;
}

static bool stands(const span_case *c)
{
    bool still = true;

    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 3; k++)
            still = still && c->item.p[k][i] == c->from[i];
    return still;
}

static void a_cap_is_what_the_limits_allow_and_never_more(arb *a)
{
    span_case c;
    double most = 4, least = 4;
    bool fine = true;

    arb_span(a, &c);
    if (stands(&c))                 /* then it is not cut short: see below */
        return;
    for (int i = 0; i < LOFT_AXES; i++) {
        most = fmin(most, allows(&c, i, 1, &fine));
        least = fmin(least, allows(&c, i, 0, &fine));
    }
    const double r2 = (loft_override_limit_of(&c.item, c.from, &c.before, c.axis, c.tick_hz) + 1) /
                      64.;
    CHECK(r2 >= 1 && r2 <= 4);
    CHECK(r2 <= fmax(1, most) * (1 + 1e-12));
    if (fine)       /* limits of 2^8 raw and more: rounding them down costs 3 times 2^-8 */
        CHECK(r2 >= fmin(4, least) * (1 - 3 / 256.) - 4 / 64.);
}

/* Something waits there, and no wait becomes shorter. */
static void what_stands_still_passes_as_planned(arb *a)
{
    span_case c;

    arb_span(a, &c);
    for (int i = 0; i < LOFT_AXES; i++)
        c.item.p[0][i] = c.item.p[1][i] = c.item.p[2][i] = c.from[i];
    CHECK(loft_override_limit_of(&c.item, c.from, NULL, c.axis, c.tick_hz) ==
          LOFT_OVERRIDE_LIMIT_ONE);
}

/* A corner at full speed is accepted as planned. It must not become sharper, whatever the
 * limits. */
static void a_jump_of_the_velocity_is_never_passed_faster(arb *a)
{
    span_case c;

    arb_span(a, &c);
    const int i = (int)arb_below(a, LOFT_AXES);
    const double d = c.item.p[0][i] - c.from[i], e = c.from[i] - c.before.p[1][i],
                 m = c.before.ticks, n = c.item.ticks;
    CHECK(fabs(d * m - e * n) <= m + n);        /* none so far */
    c.before.p[1][i] = (int32_t)(c.from[i] - d * m / n +
                                 (arb_below(a, 2) ? 1 : -1) * (5 + m / n * 2 + arb_below(a, 1000)));
    CHECK(loft_override_limit_of(&c.item, c.from, &c.before, c.axis, c.tick_hz) ==
          LOFT_OVERRIDE_LIMIT_ONE);
}

static void coordinates_far_apart_are_as_planned(arb *a)
{
    span_case c;

    arb_span(a, &c);
    c.item.p[arb_below(a, 3)][arb_below(a, LOFT_AXES)] = arb_below(a, 2) ? INT32_MAX : INT32_MIN;
    CHECK(loft_override_limit_of(&c.item, c.from, &c.before, c.axis, c.tick_hz) ==
          LOFT_OVERRIDE_LIMIT_ONE);
}

static void a_level_is_the_square_of_the_pace(arb *a)
{
    const uint16_t full = (uint16_t)(1 + arb_below(a, 16383));
    const uint8_t cap = (uint8_t)(LOFT_OVERRIDE_LIMIT_ONE +
                                  arb_below(a,
                                            LOFT_OVERRIDE_LIMIT_MAX - LOFT_OVERRIDE_LIMIT_ONE + 1));
    const double level = loft_override_limit_level(cap, full), exact = full * (cap + 1) / 64.;

    CHECK(level <= exact && level > exact - 1);
    CHECK(loft_override_limit_level(LOFT_OVERRIDE_LIMIT_ONE, full) == full &&
          loft_override_limit_level(LOFT_OVERRIDE_LIMIT_MAX, full) == 4 * full);
}

int main(void)
{
    PROPERTY(a_cap_is_what_the_limits_allow_and_never_more,     100000);
    PROPERTY(what_stands_still_passes_as_planned,                 1000);
    PROPERTY(a_jump_of_the_velocity_is_never_passed_faster,      10000);
    PROPERTY(coordinates_far_apart_are_as_planned,                1000);
    PROPERTY(a_level_is_the_square_of_the_pace,                  10000);
    return check_failures();
}

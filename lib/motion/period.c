/* lib/motion/period.c
 * SPDX-License-Identifier: MIT
 *
 * The period is chosen so that the largest acceleration a and jerk j make differences that the
 * tolerance can hold: a h^2 <= 6 tol, j h^3 <= 2 tol; but, where the tolerance would allow more, so
 * that j needs several periods to build up a: h = a / (8 j). Where not even a tick is that short,
 * less of them is used. Where jerk is not limited it is 2 tol: a h^2 = 2 tol, and acceleration
 * takes a period to change.
 */
#include "motion/period.h"

#define ROUNDING    2                       /* of third differences */
#define MOST        ((loft_coord)1 << 28)    /* of a difference that is allowed */

static loft_coord least(loft_coord a, loft_coord b) { return a < b ? a : b; }

/* x * ticks / hz, for x below 2^43. */
static int64_t in_period(const loft_period *p, int64_t x) { return x * p->ticks / p->tick_hz; }

static loft_coord cut_off(int64_t x) { return x < MOST ? (loft_coord)x : MOST; }

/* From mm and mm / s^n as raw Q16.16 to fine units. */
static int64_t fine_raw(int32_t raw) { return (int64_t)raw * (1 << (LOFT_COORD_BITS - 16)); }

loft_coord loft_period_speed(const loft_period *period, loft_real speed)
{
    return cut_off(in_period(period, fine_raw(loft_raw_from_real(speed))));
}

/* Sixteenths of a tick that a period may last. */
static uint32_t longest(const loft_limits *limits)
{
    const uint64_t hz = limits->tick_hz;
    uint32_t most = UINT32_MAX, ease = 0;
    bool eased = true;

    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t a = (uint32_t)loft_raw_from_real(limits->max_accel[i]);
        const uint64_t j = limits->max_jerk[i];
        const uint64_t tol = (j > 0 ? 6 : 2) * (uint64_t)loft_raw_from_real(limits->tol);
        const uint32_t h = loft_coord_sqrt(tol * hz * hz * 256 / a);
        most = h < most ? h : most;
        if (j > 0) {
            const uint32_t soft = loft_coord_cbrt(tol / 3 * hz * hz / j * hz / 16);
            most = soft < most ? soft : most;
            const uint64_t rise = (uint64_t)a * hz * 16 / (8 * 65536 * j);
            ease = rise > ease ? (uint32_t)rise : ease;
        } else
            eased = false;
    }
    if (eased && ease < most)
        most = ease > most / 2 ? ease : most / 2;
    return most;
}

void loft_period_init(loft_period *period, const loft_limits *limits)
{
    const uint32_t h = longest(limits);
    const uint32_t slow = limits->tick_hz / 20u + 1;

    period->tol = loft_coord_of(loft_to_acc(limits->tol));
    period->tick_hz = limits->tick_hz;
    period->ticks = (uint16_t)(h < 32 ? 1 : h / 16 < slow ? h / 16 : slow);
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t a = in_period(period, fine_raw(loft_raw_from_real(limits->max_accel[i]))),
                      j = in_period(period, (int64_t)limits->max_jerk[i] << LOFT_COORD_BITS);
        period->speed[i] = loft_period_speed(period, limits->max_speed[i]);
        const loft_coord most = cut_off(in_period(period, a));
        period->accel[i] = least(most, 6 * period->tol);
        const loft_coord jerk = cut_off(in_period(period, in_period(period, j)));
        const loft_coord soft = least(period->accel[i], 2 * period->tol);
        period->jerk[i] = limits->max_jerk[i] == 0 || jerk > soft ? soft
                          : jerk > ROUNDING                       ? jerk - ROUNDING
                                                                  : 1;
    }
    period->tube = period->tol - period->tol / 24 - loft_coord_length(period->jerk) / 18;
}

/* lib/path/period.c
 * SPDX-License-Identifier: MIT
 *
 * Where jerk is limited, the period h is chosen so that the largest jerk makes a third difference
 * of 0.55 tol. Longer ones make motion slower, by 5 % at 1.3 tol, since less of the tolerance is
 * left for corners; shorter ones cost more time of planning. But, where the tolerance would allow
 * more, jerk gets several periods to build up the acceleration: h = a / (8 j), and 3/4 of what it
 * allows at least. With little effort, where places are up to 7/4 apart, more of it is taken.
 *
 * Control values of spans are multiples of a grain, 2^-16 mm. With n0, n1 the second differences at
 * both ends of a span, in grains, acceleration is 6 n / h^2 and jerk 6 (n1 - n0) / h^3. So a
 * machine must be allowed 6 grains: h^3 >= 6 grains / j, and h^2 >= 6 grains / a. Parts of 6 grains
 * may be planned as well: thin.c holds them.
 *
 * Where jerk is not limited, it is 2 tol: a h^2 = 2 tol, and acceleration takes a period to change.
 * Where not even a tick is that short, less of the limits is used.
 */
#include "path/period.h"

#define MOST        ((loft_coord)1 << 28)    /* of a difference that is allowed */
#define TICKS_MAX   1001u                   /* below LOFT_SPAN_TICKS_MAX */

/* x * ticks / hz, for x below 2^43. */
static int64_t in_period(const loft_period *p, int64_t x) { return x * p->ticks / p->tick_hz; }

static loft_coord cut_off(int64_t x) { return x < MOST ? (loft_coord)x : MOST; }

/* From mm and mm / s^n as raw Q16.16 to fine units. */
static int64_t fine_raw(int32_t raw) { return (int64_t)raw * (1 << (LOFT_COORD_BITS - 16)); }

static loft_coord speed_of(const loft_period *period, loft_real speed)
{
    return cut_off(in_period(period, fine_raw(loft_raw_from_real(speed))));
}

/* Rounding to grains adds up to 2 grains to each of the speeds of a span, in thirds of a period. */
loft_coord loft_period_speed(const loft_period *period, loft_real speed)
{
    const loft_coord v = speed_of(period, speed);
    return v - loft_coord_least(6 * LOFT_COORD_GRAIN, v / 1024);
}

/* Sixteenths of a tick that a period may last, and the fewest ticks that it must. */
static uint32_t longest(const loft_limits *limits, uint32_t *fewest)
{
    const uint64_t hz = limits->tick_hz, tol = (uint32_t)loft_raw_from_real(limits->tol);
    uint32_t most = UINT32_MAX, ease = 0;
    bool eased = true;

    *fewest = 1;
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t a = (uint32_t)loft_raw_from_real(limits->max_accel[i]);
        const uint64_t j = limits->max_jerk[i];
        const uint32_t h = j > 0 ? loft_coord_cbrt(tol * 11 / 20 * hz * hz / j * hz / 16)
                                 : loft_coord_sqrt(2 * tol * hz * hz * 256 / a);
        const uint32_t gentle = loft_coord_sqrt(6 * hz * hz / a) + 1;
        most = h < most ? h : most;
        *fewest = gentle > *fewest ? gentle : *fewest;
        if (j > 0) {
            const uint32_t least = loft_coord_cbrt(6 * hz * hz / j * hz / 65536) + 1;
            *fewest = least > *fewest ? least : *fewest;
            const uint64_t rise = (uint64_t)a * hz * 16 / (8 * 65536 * j);
            ease = rise > ease ? (uint32_t)rise : ease;
        } else
            eased = false;
    }
    const uint32_t enough = LOFT_PLAN_EFFORT > 1 ? most / 4 * 3 : most - ease / 8;
    if (eased && ease < most)
        most = ease > enough ? ease : enough;
    return most;
}
/* (16 hz)^3 * tol / 65536 / j = hz^3 tol / (16 j); 6 grains * hz^3 / j */

/* A last period that is shorter than others has grains as well: at least half of one. One that is
 * longer fits a span. */
static uint16_t shortest(const loft_period *p)
{
    const int64_t t = p->ticks, half = (t + 1) / 2;

    for (int i = 0; i < LOFT_AXES; i++)
        if (2 * t > TICKS_MAX ||
            p->jerk[i] * half * half * half < 6 * LOFT_COORD_GRAIN * t * t * t ||
            p->accel[i] * half * half < 6 * LOFT_COORD_GRAIN * t * t)
            return p->ticks;
    return (uint16_t)half;
}

/* Of a speed: whole steps of 3 grains. */
static loft_coord whole(loft_coord x)
{
    const loft_coord step = 3 * LOFT_COORD_GRAIN;
    return x > step ? x - x % step : x;
}

void loft_period_init(loft_period *period, const loft_limits *limits)
{
    uint32_t fewest;
    const uint32_t h = (longest(limits, &fewest) + 4) / 16;
    const uint32_t slow = limits->tick_hz < 20000 ? limits->tick_hz / 20u + 1 : TICKS_MAX,
                   ticks = fewest > h ? fewest
                           : h > 0    ? h
                                      : 1;

    period->tol = loft_coord_of(loft_to_acc(limits->tol));
    const loft_coord corner = loft_coord_of(loft_to_acc(limits->corner));
    period->more = corner > period->tol ? corner - period->tol : 0;
    const int32_t exact = loft_raw_from_real(limits->exact) / 4;
    period->exact = exact * exact;
    period->tick_hz = limits->tick_hz;
    period->one_sided = limits->one_sided;
    period->ticks = (uint16_t)(ticks < slow ? ticks : slow);
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t a = in_period(period, fine_raw(loft_raw_from_real(limits->max_accel[i]))),
                      j = in_period(period, (int64_t)limits->max_jerk[i] << LOFT_COORD_BITS);
        const loft_coord accel = cut_off(in_period(period, a)), soft = 2 * period->tol,
                         jerk = cut_off(in_period(period, in_period(period, j)));
        period->speed[i] = whole(speed_of(period, limits->max_speed[i]));
        period->accel[i] = jerk > 0 ? accel : loft_coord_least(accel, 6 * period->tol);
        period->jerk[i]  = loft_coord_least(jerk > 0 ? jerk : period->accel[i], soft);
    }
    period->last = shortest(period);
    const loft_coord spans = period->tol / 24 + loft_coord_length(period->jerk) / 18;
    period->tube = period->tol - spans;
    period->off = spans / 4 * 3;
    period->joined = (uint16_t)loft_coord_least(LOFT_PERIOD_JOINED,
                                                (loft_coord)TICKS_MAX / period->ticks);
}

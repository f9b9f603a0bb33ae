/* tests/lib/machine/test_pace.c -- properties of lib/machine/pace.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "check.h"
#include "machine/pace.h"

/* A pace with arbitrary slots and ramp that init accepts. */
static loft_pace arb_pace(arb *a, uint16_t *slots, uint16_t *ramp)
{
    loft_pace p;
    do {
        *slots = (uint16_t)(1 + arb_below(a, arb_below(a, 4) ? 100 : LOFT_PACE_SLOTS_MAX));
        *ramp = (uint16_t)(1 + arb_below(a, arb_below(a, 4) ? 400 : LOFT_PACE_RAMP_MAX));
    } while (loft_pace_init(&p, *slots, *ramp) != LOFT_OK);
    return p;
}

static double ticks_of(uint16_t ramp) { return (ramp + 1) / 2; }


static void aim(loft_pace *p, unsigned percent) { loft_pace_aim(p, loft_pace_level(p, percent)); }

/* Slots of the tick between two levels (or at one level) by the law, without rounding. */
static double law(double slots, double full, double from, double to)
{
    return 2 * slots * sqrt(full) / (sqrt(from) + sqrt(to));
}

/* The relative error of three roots in Q8, each rounded by at most 1/2; exact where the level is 0
 * or 1. */
static double root_error(double level) { return level > 1 ? 0.5 / 256 : 0; }
static double roots_error(double full, double from, double to)
{
    const double error = root_error(full) / sqrt(full) +
                         (root_error(from) + root_error(to)) / (sqrt(from) + sqrt(to));
    CHECK(error <= 0.003);
    return error * (1 + error);
}

static void each_tick_lasts_what_the_law_says(arb *a)
{
    uint16_t slots, ramp;
    loft_pace p = arb_pace(a, &slots, &ramp);

    for (int tick = 0; tick < 2000; tick++) {
        if (arb_below(a, 60) == 0)
            aim(&p, arb_below(a, 3) ? arb_below(a, 220) : 100 * arb_below(a, 2));
        const double from = p.level, distance = loft_pace_distance(&p), unit = loft_pace_unit(&p);
        const uint16_t lasts = loft_pace_next(&p);
        const double to = p.level;

        CHECK_NEAR(from, to, unit);
        CHECK(distance == ceil(from / unit) && loft_pace_full(&p) == unit * ticks_of(ramp));
        if (from == 0 && to == 0)
            CHECK(lasts == 0);
        else if (from == loft_pace_full(&p) && to == from)
            CHECK(lasts == slots);
        else
            CHECK_NEAR(lasts, law(slots, loft_pace_full(&p), from, to),
                       1 + law(slots, loft_pace_full(&p), from, to) *
                               roots_error(loft_pace_full(&p), from, to));
        CHECK(lasts <= 32767);
    }
}

/* Mean paces of neighbouring ticks differ by at most 1 / ramp per tick of real time between their
 * middles. */
static void the_pace_never_changes_faster_than_the_ramp(arb *a)
{
    const uint16_t slots = (uint16_t)(400 + arb_below(a, 400)),
                   ramp = (uint16_t)(1 + arb_below(a, 500));
    loft_pace p;
    double pace = 0, lasted = 0;

    CHECK(loft_pace_init(&p, slots, ramp) == LOFT_OK);
    for (int tick = 0; tick < 3000; tick++) {
        if (arb_below(a, 100) == 0)
            aim(&p, arb_below(a, 220));
        const double level = loft_pace_distance(&p), lasts = loft_pace_next(&p);
        if (lasts == 0 && pace == 0)
            continue;
        const double next = lasts > 0 ? slots / lasts : 0, middle = (lasts + lasted) / 2 / slots;
        const double rounding = (pace + next) * (1 / fmax(lasts, lasted) +
                                                 1 / fmin(fmax(lasts, 1), fmax(lasted, 1)) +
                                                 1. / 256 / sqrt(fmax(level, 1)));
        CHECK_NEAR(next, pace, middle / ramp * (1 + 1. / ramp) + rounding);
        pace = next;
        lasted = lasts;
    }
}

static void a_hold_stands_after_the_stated_number_of_ticks(arb *a)
{
    uint16_t slots, ramp;
    loft_pace p = arb_pace(a, &slots, &ramp);

    aim(&p, 1 + arb_below(a, 200));
    for (uint32_t ticks = arb_below(a, 4 * ramp); ticks; ticks--)
        CHECK(loft_pace_next(&p) != 0);
    loft_pace_aim(&p, 0);
    for (unsigned left = loft_pace_distance(&p); left; left--)
        CHECK(loft_pace_next(&p) != 0);
    CHECK(loft_pace_next(&p) == 0);
    CHECK(loft_pace_next(&p) == 0);
    aim(&p, 100);
    CHECK(loft_pace_next(&p) != 0);
}

/* From pace 1 to 0 in `ramp` ticks of real time. */
static void a_hold_from_full_pace_takes_the_ramp(arb *a)
{
    uint16_t slots, ramp;
    loft_pace p = arb_pace(a, &slots, &ramp);
    double sum = 0;

    aim(&p, 100);
    while (p.level < loft_pace_full(&p))
        CHECK(loft_pace_next(&p) >= slots);
    CHECK(loft_pace_next(&p) == slots);
    loft_pace_aim(&p, 0);
    while (loft_pace_distance(&p))
        sum += loft_pace_next(&p);
    CHECK_NEAR(sum, 2 * ticks_of(ramp) * slots,
               1 + ticks_of(ramp) / 256 + 0.003 * 2 * ticks_of(ramp) * slots);
}

static void fractions_are_carried_at_any_steady_pace(arb *a)
{
    uint16_t slots, ramp;
    loft_pace p = arb_pace(a, &slots, &ramp);
    double sum = 0;

    const unsigned percent = 1 + arb_below(a, 200);
    aim(&p, percent);
    uint16_t before;
    do {
        before = p.level;
        CHECK(loft_pace_next(&p) != 0);
    } while (p.level != before);
    /* of that pace */
    CHECK_NEAR(p.level, fmax(1, loft_pace_full(&p) * (percent * percent / 1e4)), 0.5);
    const double ideal = law(slots, loft_pace_full(&p), before, before);
    for (int tick = 0; tick < 1000; tick++)
        sum += loft_pace_next(&p);
    CHECK_NEAR(sum, 1000 * ideal,
               1 + 1000. / 256 + 1000 * ideal * roots_error(loft_pace_full(&p), before, before));
}

/* What was ordered before does not matter. */
static void a_percentage_is_that_percentage(arb *a)
{
    static const uint16_t exact[] = { 1, 2, 4, 7, 10, 20, 50, 100, 200, 400, 1000 };
    const uint16_t slots = (uint16_t)(1 + arb_below(a, 163));
    const bool whole = arb_below(a, 2);
    const uint16_t ramp = whole ? exact[arb_below(a, 11)] : (uint16_t)(1 + arb_below(a, 400));
    loft_pace p;

    CHECK(loft_pace_init(&p, slots, ramp) == LOFT_OK);
    for (int order = 0; order < 5; order++) {
        const unsigned percent = 1 + arb_below(a, arb_below(a, 2) ? 200 : 10);
        const double want = 1000 * fmax(1, slots * 100. / percent);
        double sum = 0;
        aim(&p, percent);
        do
            CHECK(loft_pace_next(&p) != 0);
        while (p.level != p.aim);
        loft_pace_next(&p);
        for (int tick = 0; tick < 1000; tick++)
            sum += loft_pace_next(&p);
        CHECK_NEAR(sum, want, 1 + 1000. / 256 + want * (0.0015 + (whole ? 0 : 0.01)));
    }
}

static void init_refuses_what_does_not_fit(arb *a)
{
    loft_pace p;
    (void)a;
    CHECK(loft_pace_init(&p, 0, 100) == LOFT_ERR_RANGE);
    CHECK(loft_pace_init(&p, LOFT_PACE_SLOTS_MAX + 1, 1) == LOFT_ERR_RANGE);
    CHECK(loft_pace_init(&p, 40, 0) == LOFT_ERR_RANGE);
    CHECK(loft_pace_init(&p, 40, 32767) == LOFT_ERR_RANGE);
    CHECK(loft_pace_init(&p, 4096, 100) == LOFT_ERR_RANGE);
    CHECK(loft_pace_init(&p, 4096, 16) == LOFT_OK);
    CHECK(loft_pace_init(&p, 127, 32766) == LOFT_OK);
    CHECK(loft_pace_init(&p, 1, 1) == LOFT_OK);
}

int main(void)
{
    PROPERTY(each_tick_lasts_what_the_law_says,              300);
    PROPERTY(the_pace_never_changes_faster_than_the_ramp,    300);
    PROPERTY(a_hold_stands_after_the_stated_number_of_ticks, 300);
    PROPERTY(a_hold_from_full_pace_takes_the_ramp,           100);
    PROPERTY(fractions_are_carried_at_any_steady_pace,       300);
    PROPERTY(a_percentage_is_that_percentage,                300);
    PROPERTY(init_refuses_what_does_not_fit,                   1);
    return check_failures();
}

/* tests/lib/machine/test_step.c -- properties of lib/machine/step.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include <string.h>

#include "machine/step.h"

static void arb_target(arb *a, const int32_t from[LOFT_AXES], int32_t most,
                       int32_t target[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t t = from[i] + (int64_t)arb_raw(a, most);
        target[i] = (int32_t)(t > LOFT_STEP_REACH    ? LOFT_STEP_REACH
                              : t < -LOFT_STEP_REACH ? -LOFT_STEP_REACH
                                                     : t);
    }
}

static void add_pulses(int32_t at[LOFT_AXES], loft_pins pins)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (pins.step & (1u << i))
            at[i] += pins.dir & (1u << i) ? -1 : 1;
}

static loft_step arb_step(arb *a, int32_t at[LOFT_AXES])
{
    loft_step s;
    for (int i = 0; i < LOFT_AXES; i++)
        at[i] = arb_raw(a, LOFT_STEP_REACH);
    CHECK(loft_step_init(&s, at) == LOFT_OK);
    return s;
}

/* The sum of the pulses follows the straight line within half a step in every slot, and ends on the
 * target. */
static void pulses_follow_the_straight_line_within_half_a_step(arb *a)
{
    int32_t at[LOFT_AXES], from[LOFT_AXES], target[LOFT_AXES], told[LOFT_AXES];
    loft_step s = arb_step(a, at);

    for (int tick = 0; tick < 40; tick++) {
        const uint16_t asked = (uint16_t)(1 +
                                          arb_below(a, arb_below(a, 8) ? 60 : LOFT_STEP_SLOTS_MAX));
        for (int i = 0; i < LOFT_AXES; i++)
            from[i] = at[i];
        arb_target(a, from, arb_below(a, 8) ? 50 : LOFT_STEP_SLOTS_MAX, target);
        CHECK(loft_step_room(&s));
        const int32_t lasts = loft_step_load(&s, target, asked), line = s.tick[!s.which].slots;
        CHECK(lasts >= asked && (lasts == line || lasts == line + 1));

        for (int32_t slot = 1; slot <= lasts; slot++) {
            CHECK(!loft_step_done(&s));
            add_pulses(at, loft_step_next(&s));
            loft_step_position(&s, told);
            const int32_t j = slot - (lasts - line);
            for (int i = 0; i < LOFT_AXES; i++) {
                const int64_t off = 2 * ((int64_t)(at[i] - from[i]) * line -
                                         (int64_t)j * (target[i] - from[i]));
                CHECK(off <= line && off >= -line);
                CHECK(told[i] == at[i]);
            }
        }
        CHECK(loft_step_done(&s));
        loft_step_position(&s, told);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(at[i] == target[i] && told[i] == target[i]);
        const loft_pins still = loft_step_next(&s);
        CHECK(still.step == 0 && loft_step_done(&s));
    }
}

/* Whatever the targets are: an axis does not pulse in the slot where its direction bit changes. */
static void directions_change_a_slot_before_the_pulse(arb *a)
{
    int32_t at[LOFT_AXES], target[LOFT_AXES], last[LOFT_AXES];
    loft_step s = arb_step(a, at);
    uint8_t dir = 0;

    memcpy(last, at, sizeof last);

    for (int tick = 0; tick < 200; tick++) {
        arb_target(a, last, 45, target);
        memcpy(last, target, sizeof last);
        loft_step_load(&s, target, 40);
        while (!loft_step_room(&s) || (arb_below(a, 2) && !loft_step_done(&s))) {
            const loft_pins pins = loft_step_next(&s);
            CHECK((pins.step & (pins.dir ^ dir)) == 0);
            dir = pins.dir;
            add_pulses(at, pins);
        }
    }
    while (!loft_step_done(&s))
        add_pulses(at, loft_step_next(&s));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(at[i] == target[i]);
}

/* A tick is longer than requested only if an axis has more steps than slots, or reverses and pulses
 * at once. */
static void a_tick_is_not_longer_than_it_must_be(arb *a)
{
    int32_t at[LOFT_AXES], target[LOFT_AXES];
    loft_step s = arb_step(a, at);

    for (int tick = 0; tick < 50; tick++) {
        const uint16_t asked = (uint16_t)(1 + arb_below(a, 60));
        const uint8_t dir = s.tick[s.which].dir;
        int32_t need = asked;
        bool lead = false;
        loft_step_position(&s, at);
        arb_target(a, at, 70, target);
        for (int i = 0; i < LOFT_AXES; i++)
            if (abs(target[i] - at[i]) > need)
                need = abs(target[i] - at[i]);
        for (int i = 0; i < LOFT_AXES; i++) {
            const bool back = target[i] < at[i], was_back = (dir & (1u << i)) != 0;
            if (target[i] != at[i] && back != was_back && 2 * abs(target[i] - at[i]) >= need)
                lead = true;
        }
        const int32_t lasts = loft_step_load(&s, target, asked);
        CHECK(lasts == need + lead);
        while (!loft_step_done(&s))
            loft_step_next(&s);
    }
}

static void an_axis_that_stands_keeps_its_direction(arb *a)
{
    const int32_t zero[LOFT_AXES] = { 0 };
    int32_t target[LOFT_AXES] = { -(int32_t)(1 + arb_below(a, 40)) };
    loft_step s;

    CHECK(loft_step_init(&s, zero) == LOFT_OK);
    loft_step_load(&s, target, 40);
    while (!loft_step_done(&s))
        loft_step_next(&s);
    loft_step_load(&s, target, 40);
    for (int slot = 0; slot < 41; slot++) {
        const loft_pins pins = loft_step_next(&s);
        CHECK(pins.dir == 1 && pins.step == 0);
    }
}

static void the_ends_of_the_reach_can_be_visited(arb *a)
{
    int32_t at[LOFT_AXES], got[LOFT_AXES];
    loft_step s;

    for (int i = 0; i < LOFT_AXES; i++)
        at[i] = arb_below(a, 2) ? LOFT_STEP_REACH - 10 : 10 - LOFT_STEP_REACH;
    CHECK(loft_step_init(&s, at) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        at[i] = at[i] > 0 ? LOFT_STEP_REACH : -LOFT_STEP_REACH;
    loft_step_load(&s, at, 40);
    while (!loft_step_done(&s))
        loft_step_next(&s);
    loft_step_position(&s, got);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(got[i] == at[i]);
    at[0] = LOFT_STEP_REACH + 1;
    CHECK(loft_step_init(&s, at) == LOFT_ERR_RANGE);
    at[0] = INT32_MIN;
    CHECK(loft_step_init(&s, at) == LOFT_ERR_RANGE);
}

/* Against exact integers: the product in units of 2^-32, a number of half steps. */
static void millimetres_become_the_nearest_step(arb *a)
{
    const loft_real mm = arb_real(a, 32767), scale = arb_real(a, 32767);
    const loft_real per_mm = scale < 0 ? -scale : scale;
    const long double exact = (long double)arb_value(mm) * (long double)arb_value(per_mm);
    const int32_t steps = loft_steps_of(mm, per_mm);

    CHECK_NEAR((long double)steps - exact, 0, BY_NUM(0.5, 0.5, 0.5 + 1e-6));
    CHECK(steps >= -LOFT_STEP_REACH && steps <= LOFT_STEP_REACH);
}

static void ties_go_upward(arb *a)
{
    (void)a;
    CHECK(loft_steps_of(LOFT_REAL(0.5), LOFT_REAL(1)) == 1);
    CHECK(loft_steps_of(LOFT_REAL(-0.5), LOFT_REAL(1)) == 0);
    CHECK(loft_steps_of(LOFT_REAL(-1.5), LOFT_REAL(1)) == -1);
    CHECK(loft_steps_of(LOFT_REAL(-1.75), LOFT_REAL(1)) == -2);
    CHECK(loft_steps_of(LOFT_REAL(100), LOFT_REAL(80)) == 8000);
    CHECK(loft_steps_of(LOFT_REAL(32767), LOFT_REAL(32767)) == 32767 * 32767);
    CHECK(loft_steps_of(LOFT_REAL(-32767), LOFT_REAL(32767)) == -32767 * 32767);
}

/* A machine on a step reports its position in mm, rounded to a coordinate. That gives the same step
 * again. */
static void a_position_in_millimetres_is_the_same_step_again(arb *a)
{
    const int32_t per_mm = 1 + (int32_t)arb_below(a, 2000);
    const int32_t limit = BY_NUM(32767, 1000, 32767) * per_mm > 16777216 * BY_NUM(64, 1, 64)
                              ? 16777216
                              : 1000 * per_mm;
    const int32_t steps = arb_raw(a, limit);
    const double mm = (double)steps / per_mm;
    if (mm > 32767 || mm < -32767)
        return;
#if LOFT_NUM == LOFT_Q16
    const loft_real at = (loft_real)(mm * 65536.0 + (mm < 0 ? -0.5 : 0.5));
#else
    const loft_real at = (loft_real)mm;
#endif
    CHECK(loft_steps_of(at, (loft_real)(LOFT_REAL(1) * (loft_real)per_mm)) == steps);
}

/* Slots made many at once equal those made one by one: bits, directions, positions. */
static void slots_made_at_once_are_those_made_one_by_one(arb *a)
{
    int32_t at[LOFT_AXES], target[LOFT_AXES], one[LOFT_AXES], many[LOFT_AXES];
    loft_step s = arb_step(a, at), r = s;
    uint8_t step[255], dir;

    for (int turn = 0; turn < 300; turn++) {
        if (loft_step_room(&s) && arb_below(a, 4)) {
            const uint16_t slots = (uint16_t)(1 + arb_below(a, 100));
            arb_target(a, at, arb_below(a, 8) ? 45 : 300, target);
            memcpy(at, target, sizeof at);
            CHECK(loft_step_load(&s, target, slots) == loft_step_load(&r, target, slots));
        }
        const uint8_t most = (uint8_t)(1 + arb_below(a, 255));
        uint8_t count = most;
        loft_step_tick *taken = loft_step_take(&r, &count, &dir);
        if (taken)
            loft_step_give(taken, step, count);
        else
            memset(step, 0, count);
        CHECK(count >= 1 && count <= most);
        for (int k = 0; k < count; k++) {
            const loft_pins pins = loft_step_next(&s);
            CHECK(pins.step == step[k] && pins.dir == dir);
        }
        loft_step_position(&s, one);
        loft_step_position(&r, many);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(one[i] == many[i]);
        CHECK(loft_step_done(&s) == loft_step_done(&r) && loft_step_room(&s) == loft_step_room(&r));
    }
}

/* All slots of a tick of `slots` slots and `count` steps of the first axis, at once: true if after
 * slot j there were floor((j count + slots / 2) / slots) pulses. */
static bool follows_the_line(uint16_t slots, uint16_t count)
{
    int32_t at[LOFT_AXES] = { 0 };
    uint32_t pulses = 0, j = 0;
    uint8_t step[255], dir;
    loft_step s;

    if (loft_step_init(&s, at) != LOFT_OK)
        return false;
    at[0] = count;
    at[LOFT_AXES - 1] = slots;          /* a pulse in each slot */
    loft_step_load(&s, at, slots);
    while (!loft_step_done(&s)) {
        uint8_t n = 255;
        loft_step_tick *taken = loft_step_take(&s, &n, &dir);
        loft_step_give(taken, step, n);
        for (uint8_t k = 0; k < n; k++) {
            pulses += step[k] & 1u;
            if (pulses != (++j * count + slots / 2u) / slots || !(step[k] >> (LOFT_AXES - 1)))
                return false;
        }
    }
    return j == slots && pulses == count;
}

/* Whether a pulse is the carry of an addition (step.c) or not: each tick of up to 255 slots. */
static void pulses_are_those_of_bresenhams_line(arb *a)
{
    (void)a;
    for (uint16_t slots = 1; slots < 256; slots = (uint16_t)(slots + CHECK_STEP))
        for (uint16_t count = LOFT_AXES > 1 ? 0 : slots; count <= slots; count++)
            CHECK(follows_the_line(slots, count));
}

/* And longer ticks, most of them around the longest that has it. */
static void pulses_of_long_ticks_are_those_of_bresenhams_line(arb *a)
{
    const uint16_t slots = (uint16_t)(arb_below(a, 4) ? 1600 + arb_below(a, 50)
                                                      : 256 + arb_below(a, 6000));

    CHECK(follows_the_line(slots, LOFT_AXES > 1 ? (uint16_t)arb_below(a, slots + 1u) : slots));
}

int main(void)
{
    PROPERTY(pulses_are_those_of_bresenhams_line,                 1);
    PROPERTY(pulses_of_long_ticks_are_those_of_bresenhams_line, 5000);
    PROPERTY(slots_made_at_once_are_those_made_one_by_one, 500);
    PROPERTY(pulses_follow_the_straight_line_within_half_a_step, 60);
    PROPERTY(directions_change_a_slot_before_the_pulse,         100);
    PROPERTY(a_tick_is_not_longer_than_it_must_be,              200);
    PROPERTY(an_axis_that_stands_keeps_its_direction,            40);
    PROPERTY(the_ends_of_the_reach_can_be_visited,              100);
    PROPERTY(millimetres_become_the_nearest_step,             20000);
    PROPERTY(ties_go_upward,                                      1);
    PROPERTY(a_position_in_millimetres_is_the_same_step_again, 20000);
    return check_failures();
}

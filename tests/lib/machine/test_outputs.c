/* tests/lib/machine/test_outputs.c -- properties of lib/machine/outputs.h and of actions in a job
 * SPDX-License-Identifier: MIT
 */
#include "support/rig.h"

static loft_drive drive;

static void start(arb *a, uint16_t slots, uint16_t ramp)
{
    loft_drive_config c = rig_init(a, &drive, slots, ramp, 20);

    while (r.kind != LOFT_SPANS)
        c = rig_init(a, &drive, slots, ramp, 20);
    CHECK(loft_drive_init(&drive, &c) == LOFT_OK);
    CHECK(loft_drive_begin(&drive, LOFT_SPANS, r.start) == LOFT_OK);
}

static void push_all(void)
{
    while (r.pushed < r.items && loft_drive_push(&drive, &r.item[r.pushed]) == LOFT_OK)
        r.pushed++;
    if (r.pushed == r.items)
        loft_drive_end(&drive);
}

/* What the outputs should be in a tick of the plan: the last actions up to it. */
static const loft_action *action_of(uint32_t tick, int output)
{
    for (uint32_t t = tick + 1; t-- > 0;)
        if (r.action[t].output == output)
            return &r.action[t];
    return NULL;
}

static void a_level_begins_with_the_tick_of_its_action_and_lasts(arb *a)
{
    start(a, 40, (uint16_t)(1 + arb_below(a, 100)));
    for (uint32_t slot = 0; loft_state_busy(drive.state) && slot < 20000000; slot++) {
        push_all();
        loft_drive_prepare(&drive);
        rig_operate(a);
        loft_drive_tick(&drive);
        const bool moves = !loft_step_done(&drive.step);
        for (int k = 1; k <= LOFT_MACHINE_OUTPUTS && drive.active && r.passed < r.ticks; k++) {
            /* after the last slot of a tick the next one is about to begin */
            const loft_action *want = action_of(r.passed, k);
            if (moves && r.lasts > 0 && (!want || want->feed == 0))
                CHECK(loft_drive_output(&drive, k) == (want ? want->level : 0));
            if (!moves && r.passed > 0) {
                const loft_action *last = action_of(r.passed - 1, k);
                CHECK(loft_drive_output(&drive, k) ==
                      (last && last->feed == 0 && !last->moving ? last->level : 0));
            }
        }
        rig_slot();
    }
    CHECK(drive.state == LOFT_STATE_DONE && r.passed == r.ticks);
    for (int k = 0; k <= LOFT_MACHINE_OUTPUTS + 1; k++)
        CHECK(loft_drive_output(&drive, k) == 0);
}

/* A job that is aborted, by whom ever, leaves all outputs off. */
static void after_an_abort_all_outputs_are_off(arb *a)
{
    const uint32_t when = arb_below(a, 20000);
    const bool hard     = arb_below(a, 2) == 0;

    start(a, 40, (uint16_t)(1 + arb_below(a, 100)));
    for (uint32_t slot = 0; loft_state_busy(drive.state) && slot < 2000000; slot++) {
        push_all();
        if (slot == when && hard)
            loft_drive_halt(&drive);
        else if (slot == when)
            loft_drive_abort(&drive);
        loft_drive_tick(&drive);
        rig_slot();
    }
    CHECK(!loft_state_busy(drive.state));
    for (int k = 1; k <= LOFT_MACHINE_OUTPUTS; k++)
        CHECK(loft_drive_output(&drive, k) == 0);
}

/* A line of `ticks` ticks that starts and ends at rest. */
static loft_item line(const int32_t from[LOFT_AXES], const int32_t to[LOFT_AXES], uint16_t ticks)
{
    loft_item item = { .ticks = ticks };

    for (int i = 0; i < LOFT_AXES; i++) {
        item.p[0][i] = from[i];
        item.p[1][i] = item.p[2][i] = to[i];
    }
    return item;
}

static loft_item action_at(uint8_t output, uint16_t level, uint16_t feed,
                           const int32_t place[LOFT_AXES])
{
    const loft_action action = { output, false, level, feed };
    loft_item item;

    loft_action_item(&item, &action, place);
    return item;
}

enum { PER_MM = 80, SLOTS = 40 };

static void begin_at_zero(const int32_t zero[LOFT_AXES], uint16_t ramp, uint8_t outputs)
{
    static loft_axis_config axis[LOFT_AXES];
    loft_drive_config c = { axis, { 0 }, 1000, SLOTS, ramp, cells, CELLS, outputs };

    for (int i = 0; i < LOFT_AXES; i++)
        axis[i].steps_per_mm = PER_MM << 16;
    CHECK(loft_drive_init(&drive, &c) == LOFT_OK);
    CHECK(loft_drive_begin(&drive, LOFT_SPANS, zero) == LOFT_OK);
}

/* The place that an item has reached after `tick` of its ticks, raw, exactly. */
static void place_of(const loft_item *item, const int32_t from[LOFT_AXES], double tick,
                     double out[LOFT_AXES])
{
    const double t = tick / item->ticks, s = 1 - t;

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = s * s * s * from[i] + 3 * s * s * t * item->p[0][i] +
                 3 * s * t * t * item->p[1][i] + t * t * t * item->p[2][i];
}

enum { LINES = 30, LONGEST = 600 };

/* A job of lines, and the way of each of its ticks in mm. */
static struct {
    loft_item item[LINES + 1];
    double way[LINES * LONGEST + 1];
    uint32_t ticks;
} job;

static void arb_job(arb *a, const loft_item *first)
{
    int32_t from[LOFT_AXES] = { 0 }, to[LOFT_AXES];
    double at[LOFT_AXES] = { 0 }, next[LOFT_AXES];

    job.item[0] = *first;
    job.way[0]  = 0;
    job.ticks   = 1;
    for (int n = 1; n <= LINES; n++) {
        for (int i = 0; i < LOFT_AXES; i++)
            to[i] = from[i] + arb_raw(a, 4 << 16);
        job.item[n] = line(from, to, (uint16_t)(LONGEST / 3 + arb_below(a, LONGEST * 2 / 3)));
        for (int tick = 1; tick <= job.item[n].ticks; tick++) {
            double square = 0;
            place_of(&job.item[n], from, tick, next);
            for (int i = 0; i < LOFT_AXES; i++)
                square += (next[i] - at[i]) * (next[i] - at[i]);
            job.way[job.ticks++] = sqrt(square) / 65536;
            memcpy(at, next, sizeof at);
        }
        memcpy(from, to, sizeof from);
    }
}

/* Ticks that give at least 0.1 mm are compared with what the feed gives, in levels times slots.
 * Those slower than 1 mm/s do not count, nor those with more than full power. */
typedef struct {
    double energy, way, per_mm;
    unsigned compared;
} window;

static void compare(window *w, uint32_t tick, uint32_t lasted, double energy)
{
    const double speed = job.way[tick] * 1000 * SLOTS / lasted;

    if (speed < 1 || w->per_mm * job.way[tick] / lasted > 65000) {
        w->energy = w->way = 0;
        return;
    }
    w->energy += energy;
    w->way += job.way[tick];
    if (w->way < 0.1)
        return;
    CHECK_NEAR(w->energy, w->per_mm * w->way, 0.02 * w->per_mm * w->way);
    w->energy = w->way = 0;
    w->compared++;
}

/* The energy of each mm is that of the feed, with holds, overrides and a queue that starves, while
 * the machine is faster than 1 mm/s. Where it stands there is none. */
static void every_mm_gets_the_energy_of_its_feed(arb *a)
{
    const uint16_t level = (uint16_t)(10000 + arb_below(a, 20000)),
                   feed  = (uint16_t)(600 + arb_below(a, 3000));
    const int32_t zero[LOFT_AXES] = { 0 };
    const loft_item first = action_at(1, level, feed, zero);
    window w = { .per_mm = level * 60. * 1000 * SLOTS / feed };
    uint32_t pushed = 0, tick = 0, lasts = 0;
    double energy = 0;

    arb_job(a, &first);
    begin_at_zero(zero, (uint16_t)(20 + arb_below(a, 80)), LOFT_MACHINE_OUTPUTS);
    for (uint32_t slot = 0; loft_state_busy(drive.state) && slot < 40000000; slot++) {
        if (slot / 40000 % 3 < 2)                           /* a line that pauses */
            pushed += pushed <= LINES && loft_drive_push(&drive, &job.item[pushed]) == LOFT_OK;
        if (pushed == LINES + 1)
            loft_drive_end(&drive);
        rig_operate(a);
        loft_drive_tick(&drive);
        const bool moves = !loft_step_done(&drive.step);
        (void)loft_drive_slot(&drive);
        if (!moves) {
            CHECK(loft_drive_output(&drive, 1) == 0);
            continue;
        }
        lasts++;
        energy += loft_drive_output(&drive, 1);
        if (!drive.step.busy) {
            CHECK(tick < job.ticks);
            compare(&w, tick++, lasts, energy);
            lasts  = 0;
            energy = 0;
        }
    }
    CHECK(drive.state == LOFT_STATE_DONE && tick == job.ticks && w.compared > 100);
}

/* A pause holds the machine after everything before it and before everything behind it, once. */
static void a_pause_holds_until_it_is_resumed(arb *a)
{
    const int32_t zero[LOFT_AXES] = { 0 };
    int32_t middle[LOFT_AXES], there[LOFT_AXES];
    const uint16_t ticks = (uint16_t)(100 + arb_below(a, 200));
    const bool moving = arb_below(a, 2) == 0;
    uint32_t held = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        middle[i] = arb_raw(a, 1 << 16);
        there[i] = middle[i] + arb_raw(a, 1 << 16);
    }
    const loft_action on = { 1, moving, 40000, 0 };
    loft_item item[4] = { line(zero, middle, ticks),
                          { .ticks = 0 },
                          action_at(0, 0, 0, middle),
                          line(middle, there, ticks) };
    loft_action_item(&item[1], &on, middle);
    begin_at_zero(zero, (uint16_t)(5 + arb_below(a, 100)), LOFT_MACHINE_OUTPUTS);
    loft_drive_override(&drive, 10 + arb_below(a, 190));
    for (int n = 0; n < 4; n++)
        CHECK(loft_drive_push(&drive, &item[n]) == LOFT_OK);
    loft_drive_end(&drive);
    for (uint32_t slot = 0; loft_state_busy(drive.state) && slot < 40000000; slot++) {
        loft_drive_tick(&drive);
        (void)loft_drive_slot(&drive);
        const loft_drive_report now = loft_drive_poll(&drive);
        if (now.state != LOFT_STATE_HELD)
            continue;
        CHECK(now.executed == 3 && now.ticks == ticks + 2u);
        CHECK(loft_drive_output(&drive, 1) == (moving ? 0 : 40000));
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(now.position[i] ==
                  loft_steps_of(loft_real_from_raw(middle[i]), loft_real_from_raw(PER_MM << 16)));
        if (++held == 5000)
            loft_drive_hold(&drive, false);
        CHECK(held <= 5000 + 2 * SLOTS);
    }
    CHECK(drive.state == LOFT_STATE_DONE && held >= 5000);
    CHECK(loft_drive_poll(&drive).executed == 4);
}

/* At 200 percent a wait lasts as long as planned. */
static void no_wait_becomes_shorter(arb *a)
{
    const int32_t zero[LOFT_AXES] = { 0 };
    const uint16_t ticks = (uint16_t)(1 + arb_below(a, 1000));
    const loft_item wait = line(zero, zero, ticks);

    begin_at_zero(zero, 20, 0);
    loft_drive_override(&drive, 200);
    for (int n = 0; n < 5; n++)
        CHECK(loft_drive_push(&drive, &wait) == LOFT_OK);
    loft_drive_end(&drive);
    for (uint32_t slot = 0; loft_state_busy(drive.state) && slot < 40000000; slot++) {
        loft_drive_tick(&drive);
        (void)loft_drive_slot(&drive);
    }
    CHECK(drive.state == LOFT_STATE_DONE && loft_drive_poll(&drive).elapsed >= 5u * ticks);
}

int main(void)
{
    PROPERTY(a_level_begins_with_the_tick_of_its_action_and_lasts,     10);
    PROPERTY(after_an_abort_all_outputs_are_off,                       20);
    PROPERTY(every_mm_gets_the_energy_of_its_feed,                     20);
    PROPERTY(a_pause_holds_until_it_is_resumed,                        50);
    PROPERTY(no_wait_becomes_shorter,                                  20);
    return check_failures();
}

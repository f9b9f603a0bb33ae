/* tests/lib/machine/test_drive.c -- properties of lib/machine/drive.h: whole jobs, slot by slot
 * SPDX-License-Identifier: MIT
 */
#define _DEFAULT_SOURCE     /* setitimer */
#include <signal.h>
#include <sys/time.h>

#include "support/rig.h"

static loft_drive drive;

static void rig_start(arb *a, uint16_t slots, uint16_t ramp, int32_t reach)
{
    const loft_drive_config c = rig_init(a, &drive, slots, ramp, reach);

    CHECK(loft_drive_init(&drive, &c) == LOFT_OK);
    CHECK(loft_drive_poll(&drive).state == LOFT_STATE_IDLE);
    CHECK(loft_drive_begin(&drive, r.kind, r.start) == LOFT_OK);
}

/* The number of items that an empty queue takes. */
static uint16_t room(void)
{
    return r.kind == LOFT_POINTS ? loft_points_capacity(r.cells) : r.cells;
}

static bool rig_push(void)
{
    if (r.pushed == r.items)
        return false;
    const enum loft_status status = loft_drive_push(&drive, &r.item[r.pushed]);
    CHECK(status == LOFT_OK || status == LOFT_ERR_SPACE);
    r.pushed += status == LOFT_OK;
    return status == LOFT_OK;
}

/* An unreliable line and a restless operator; the tick may come late. */
static void rig_life(arb *a, uint32_t slot)
{
    const uint32_t season = slot / 5000 % 3;            /* plenty, little, nothing */

    if (season == 0 || (season == 1 && arb_below(a, 200) == 0))
        rig_push();
    if (r.pushed == r.items)
        loft_drive_end(&drive);
    rig_operate(a);
    if (arb_below(a, 100) == 0)
        loft_drive_prepare(&drive);
    if (arb_below(a, 3000) == 0) {                      /* as if prepared for the item just taken */
        drive.walk[!drive.which] = drive.walk[drive.which];
        drive.ready_item = (uint8_t)(drive.item - 1);
        drive.ready = 1;
    }
    if (r.law || arb_below(a, 3) == 0)
        loft_drive_tick(&drive);
}

static uint32_t items_in(uint32_t ticks) { return ticks == r.ticks ? r.items : r.item_of[ticks]; }

static void whatever_happens_a_job_passes_every_point_and_ends_on_the_last(arb *a)
{
    rig_start(a, (uint16_t)(1 + arb_below(a, 60)), (uint16_t)(1 + arb_below(a, 150)), 20);

    uint32_t slot = 0;
    for (; loft_state_busy(loft_drive_poll(&drive).state) && slot < 20000000; slot++) {
        rig_life(a, slot);
        rig_slot();
        if (arb_below(a, 50) == 0) {
            const loft_drive_report now = loft_drive_poll(&drive);
            CHECK(now.ticks <= r.passed && now.ticks + 2 >= r.passed);
            CHECK(now.executed == items_in(now.ticks));
        }
    }
    const loft_drive_report end = loft_drive_poll(&drive);
    CHECK(end.state == LOFT_STATE_DONE && end.executed == r.items && end.ticks == r.ticks &&
          !end.starved);
    CHECK(r.passed == r.ticks && here(r.path[r.ticks]));
    CHECK(end.elapsed == slot / r.slots || end.elapsed + 1 == slot / r.slots);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(end.position[i] == r.path[r.ticks][i]);
    loft_drive_close(&drive);
    CHECK(loft_drive_poll(&drive).state == LOFT_STATE_IDLE);
}

/* The steps always fit the slots and the tick is always in time. Then the pace changes only by its
 * law, even when the queue runs empty, and the machine stops only at pace 0. */
static void a_queue_that_runs_low_slows_the_machine_down_evenly(arb *a)
{
    rig_start(a, (uint16_t)(100 + arb_below(a, 100)), (uint16_t)(10 + arb_below(a, 100)), 20);
    r.law = true;
    for (uint32_t slot = 0; loft_state_busy(drive.state) && slot < 20000000; slot++) {
        rig_life(a, slot);
        rig_slot();
    }
    CHECK(drive.state == LOFT_STATE_DONE && r.passed == r.ticks);
    CHECK(drive.slowed == 0);
}

static void without_an_end_the_machine_stands_at_pace_0_and_says_that_it_starves(arb *a)
{
    rig_start(a, 40, (uint16_t)(1 + arb_below(a, 100)), 20);
    for (int slot = 0; slot < 2000000 && r.passed < r.ticks; slot++) {
        rig_push();
        loft_drive_tick(&drive);
        rig_slot();
        if (r.pushed == r.items && loft_step_done(&drive.step) && slot % 1000 == 999)
            break;
    }
    loft_drive_tick(&drive);
    CHECK(r.pushed == r.items);
    CHECK(loft_step_done(&drive.step) && loft_pace_distance(&drive.pace) == 0);
    const loft_drive_report now = loft_drive_poll(&drive);
    CHECK(now.state == LOFT_STATE_RUNNING && now.ticks == r.passed && here(r.path[r.passed]));
    CHECK(now.starved || r.passed == 0);
    loft_drive_end(&drive);
    for (int slot = 0; slot < 2000000 && loft_state_busy(drive.state); slot++) {
        loft_drive_tick(&drive);
        rig_slot();
    }
    CHECK(drive.state == LOFT_STATE_DONE && r.passed == r.ticks);
}

/* Must an answer wait, by the list of all items? `next` is the one that begins next. */
static bool answer_waits(uint32_t next)
{
    uint32_t n = next;

    while (n < r.pushed && r.item[n].ticks < 3)
        n++;
    return n + 1 < r.pushed && r.item[n].ticks <= 8 && r.item[n + 1].ticks >= 3;
}

static void a_held_machine_stands_at_the_end_of_a_tick_until_it_is_resumed(arb *a)
{
    const uint32_t when = arb_below(a, 40000);
    bool held = false;
    uint32_t prepared = 0;

    rig_start(a, 40, (uint16_t)(1 + arb_below(a, 100)), 20);
    for (uint32_t slot = 0; slot < 2000000 && loft_state_busy(drive.state); slot++) {
        while (rig_push()) {
        }
        if (r.pushed == r.items)
            loft_drive_end(&drive);
        if (slot == when)
            loft_drive_hold(&drive, true);
        if (drive.state == LOFT_STATE_HELD && !held) {
            held = true;
            const uint32_t passed = r.passed;
            CHECK(slot >= when && here(r.path[passed]) && loft_pace_distance(&drive.pace) == 0);
            CHECK(loft_drive_poll(&drive).ticks == passed);
            for (int still = 0; still < 1000; still++) {
                loft_drive_tick(&drive);
                rig_slot();
            }
            CHECK(r.passed == passed && drive.state == LOFT_STATE_HELD);
            CHECK(!loft_drive_pressed(&drive));
            loft_drive_hold(&drive, false);
        }
        prepared += !drive.ready;
        loft_drive_prepare(&drive);
        prepared -= !drive.ready;
        const bool soon = r.kind != LOFT_POINTS && drive.state == LOFT_STATE_RUNNING &&
                          drive.left <= 1 && drive.ready &&
                          drive.pace.level >= loft_pace_full(&drive.pace) / 4;
        CHECK(loft_drive_pressed(&drive) == (soon && answer_waits(drive.item)));
        loft_drive_tick(&drive);
        rig_slot();
    }
    CHECK(drive.state == LOFT_STATE_DONE && r.passed == r.ticks);
    uint32_t longer = 0;                                /* at most one of two ticks needs no walk */
    for (uint32_t n = 0; n < r.items; n++)
        longer += r.item[n].ticks > 2;
    CHECK(prepared == longer);
}

/* After the abort the machine takes as many ticks as the pace needs, stops on the path, and can
 * begin another job there. */
static void an_abort_stands_on_the_path_and_the_next_job_begins_there(arb *a)
{
    const uint32_t when = arb_below(a, 40000);
    uint32_t left = 0;

    rig_start(a, 40, (uint16_t)(1 + arb_below(a, 100)), 20);
    for (uint32_t slot = 0; slot < 4000000 && loft_state_busy(drive.state); slot++) {
        while (rig_push()) {
        }
        if (slot == when) {
            loft_drive_abort(&drive);
            /* still on the line: ignored, not refused */
            for (int late = 0; late < 2 * CELLS; late++)
                CHECK(loft_drive_push(&drive, &r.item[r.pushed ? r.pushed - 1 : 0]) == LOFT_OK);
            left = r.passed + loft_pace_distance(&drive.pace) + 2;
        }
        if (slot > when && !loft_step_done(&drive.step))
            CHECK(drive.state == LOFT_STATE_STOPPING || drive.prepared == 0 || drive.running);
        loft_drive_tick(&drive);
        rig_slot();
    }
    const loft_drive_report end = loft_drive_poll(&drive);
    CHECK(end.state == LOFT_STATE_ABORTED);
    CHECK(r.passed <= left && end.ticks == r.passed && end.executed == items_in(r.passed));
    CHECK(here(r.path[r.passed]));

    CHECK(loft_drive_push(&drive, &r.item[0]) == LOFT_OK);        /* late on the line: ignored */
    int32_t wrong[LOFT_AXES];
    for (int i = 0; i < LOFT_AXES; i++)
        wrong[i] = r.at[i];
    wrong[LOFT_AXES - 1]++;
    CHECK(loft_drive_begin(&drive, LOFT_POINTS, wrong) == LOFT_ERR_RANGE);
    CHECK(loft_drive_begin(&drive, LOFT_POINTS, r.at) == LOFT_OK);
    CHECK(loft_drive_begin(&drive, LOFT_POINTS, r.at) == LOFT_ERR_ARG);
    CHECK(loft_drive_poll(&drive).room == loft_points_capacity(r.cells));
    loft_drive_end(&drive);
    loft_drive_tick(&drive);
    CHECK(loft_drive_poll(&drive).state == LOFT_STATE_DONE &&
          loft_drive_poll(&drive).executed == 0);
}

static void items_that_are_too_fast_are_refused_and_change_nothing(arb *a)
{
    rig_start(a, 40, 50, 20);
    const int axis = (int)arb_below(a, LOFT_AXES);
    loft_item item = { { { 0 } }, 1 };

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            item.p[k][i] = r.kind == LOFT_SPANS || k == 2 ? r.start[i] : 0;
    if (r.kind == LOFT_POINTS) {
        item.p[2][axis] += arb_below(a, 2) ? LOFT_STEP_SLOTS_MAX + 1 : -LOFT_STEP_SLOTS_MAX - 1;
        CHECK(loft_drive_push(&drive, &item) == LOFT_ERR_RANGE);
        item.p[2][axis] = arb_below(a, 2) ? INT32_MAX : INT32_MIN;
        CHECK(loft_drive_push(&drive, &item) == LOFT_ERR_RANGE);
        item.p[2][axis] = r.start[axis];
        item.ticks = 2;
        CHECK(loft_drive_push(&drive, &item) == LOFT_ERR_RANGE);
    } else {
        item.p[arb_below(a, 3)][axis] = arb_below(a, 2) ? INT32_MAX : INT32_MIN;
        CHECK(loft_drive_push(&drive, &item) == LOFT_ERR_RANGE);
        const loft_action other = { LOFT_MACHINE_OUTPUTS + 1, false, 0, 0 };
        loft_item action;
        loft_action_item(&action, &other, r.start);
        CHECK(loft_drive_push(&drive, &action) == LOFT_ERR_RANGE);
        action.p[1][0] = 0;
        action.p[2][axis] = arb_below(a, 2) ? INT32_MAX : INT32_MIN;
        CHECK(loft_drive_push(&drive, &action) == LOFT_ERR_RANGE);
        item.ticks = LOFT_SPAN_TICKS_MAX + 1;
        CHECK(loft_drive_push(&drive, &item) == LOFT_ERR_RANGE);
    }
    CHECK(loft_drive_poll(&drive).room == room());
    while (rig_push() || r.pushed < r.items) {
        loft_drive_tick(&drive);
        rig_slot();
    }
}

/* The fastest accepted items: thousands of steps per tick. Time is stretched, and no step is
 * lost. */
static void steps_that_do_not_fit_their_tick_are_all_made(arb *a)
{
    rig_start(a, (uint16_t)(1 + arb_below(a, 60)), 10, 2000);
    r.items = r.items < 8 ? r.items : 8;
    for (r.ticks = 0; r.item_of[r.ticks] < r.items && r.ticks < TICKS; r.ticks++) {
    }
    for (uint32_t slot = 0; slot < 40000000 && loft_state_busy(drive.state); slot++) {
        rig_push();
        if (r.pushed == r.items)
            loft_drive_end(&drive);
        loft_drive_tick(&drive);
        rig_slot();
    }
    const loft_drive_report end = loft_drive_poll(&drive);
    CHECK(end.state == LOFT_STATE_DONE && r.passed == r.ticks);
    CHECK(end.slowed > 0);
}

static uint32_t cells_used(void)
{
    uint32_t used = 0;

    for (int k = 0; k < r.cells; k++)
        used += cells[k].tag != 0;
    return used;
}

/* From a stop: a sixteenth of the fill for pace 1 and an eighth more, in ticks of the queue or in
 * cells, which hold several points. The square of that pace is a whole number of levels, so up to
 * one level more is needed. */
static void the_machine_starts_with_enough_in_the_queue(arb *a)
{
    do
        rig_start(a, 40, 50, 20);
    while (r.kind != LOFT_POINTS || r.cells < 8);

    const double horizon = 16 * 25, worth = ceil(32. * (50 + 1) / r.cells),
                 least  = horizon / 16 * 8 / 7 / worth,
                 enough = horizon * sqrt(1 / 256. + 1. / loft_pace_full(&drive.pace)) * 8 / 7 /
                          worth;
    uint32_t items = 0;
    while (items < least - 0.1 && items < LOFT_DRIVE_MARGIN + 2) {
        for (int slot = 0; slot < 100; slot++) {
            loft_drive_tick(&drive);
            CHECK(loft_step_done(&drive.step));
        }
        CHECK(rig_push());
        items++;
    }
    while (items < LOFT_DRIVE_MARGIN + 3 ||
           (items < enough * worth * 1.1 && cells_used() < enough * 1.1)) {
        CHECK(rig_push());
        items++;
    }
    loft_drive_tick(&drive);
    CHECK(!loft_step_done(&drive.step));
}

/* A tick that needs a slot to reverse is longer than planned, and is counted as such. */
static void turning_at_full_speed_is_counted_as_slowed(arb *a)
{
    const uint16_t slots = (uint16_t)(2 * (1 + arb_below(a, 30)));

    do
        rig_start(a, slots, 1, 20);
    while (r.kind != LOFT_POINTS);
    for (uint32_t tick = 0; tick < r.ticks; tick++)
        for (int i = 0; i < LOFT_AXES; i++)
            r.item[tick].p[2][i] = r.path[tick + 1][i] = r.path[tick][i] +
                                                         (tick % 2 ? -slots : slots);
    loft_drive_end(&drive);             /* what follows is in time */
    for (uint32_t slot = 0; slot < 1000000 && loft_state_busy(drive.state); slot++) {
        rig_push();
        loft_drive_tick(&drive);
        rig_slot();
    }
    CHECK(drive.state == LOFT_STATE_DONE && r.passed == r.ticks);
    CHECK(loft_drive_poll(&drive).slowed == r.ticks - 1);
}

/* The timer is set again each time, so the main loop gets its share on any machine. */
static void interrupt_in(int us)
{
    const struct itimerval once = { { 0, 0 }, { 0, us } };
    setitimer(ITIMER_REAL, &once, NULL);
}

static void interrupt(int number)
{
    (void)number;
    for (int slot = 0; slot < 37; slot++) {
        loft_drive_tick(&drive);
        rig_slot();
    }
    interrupt_in(30);
}

/* Ticks and slots in a real interrupt, at any instruction of the main loop. */
static void an_interrupt_at_any_place_of_the_main_loop_does_no_harm(arb *a)
{
    uint32_t prepared = 0;

    rig_start(a, 40, (uint16_t)(1 + arb_below(a, 60)), 20);
    signal(SIGALRM, interrupt);
    interrupt_in(30);
    for (uint32_t turn = 0; loft_state_busy(drive.state) && turn < 100000000; turn++) {
        const uint8_t ready = drive.ready;
        rig_push();
        if (r.pushed == r.items)
            loft_drive_end(&drive);
        loft_drive_prepare(&drive);
        prepared += !ready && drive.ready;
        const loft_drive_report now = loft_drive_poll(&drive);
        CHECK(now.executed <= now.ticks && now.ticks <= r.ticks && now.room <= room());
    }
    signal(SIGALRM, SIG_IGN);
    CHECK(drive.state == LOFT_STATE_DONE && r.passed == r.ticks && drive.executed == r.items);
    CHECK(prepared > 0 || r.kind == LOFT_POINTS);
}

/* A walk is made ready behind up to seven spans that need none: so the main loop may be late. */
static void a_walk_is_ready_behind_short_spans(arb *a)
{
    const unsigned before = arb_below(a, 9);
    loft_item item = { 0 };

    do
        rig_start(a, 20, 50, 20);
    while (r.kind != LOFT_SPANS);
    for (int i = 0; i < LOFT_AXES; i++)
        item.p[0][i] = item.p[1][i] = item.p[2][i] = r.start[i];
    for (unsigned k = 0; k <= before; k++) {
        item.ticks = (uint16_t)(k < before ? 1 + arb_below(a, 2) : 3 + arb_below(a, 100));
        if (loft_drive_push(&drive, &item) != LOFT_OK)
            return;                                     /* there is less room */
    }
    CHECK(!drive.ready);
    loft_drive_prepare(&drive);
    CHECK(drive.ready == (before < 8));
    if (drive.ready)
        CHECK(drive.ready_item == (uint8_t)(drive.item + before));
}

static void init_refuses_what_cannot_work(arb *a)
{
    loft_axis_config axis[LOFT_AXES] = { { 0 } };
    loft_drive_config c = { axis, { 0 }, 1000, 40, 100, cells, CELLS, 0 };
    loft_drive d;
    (void)a;
    CHECK(loft_drive_init(&d, &c) == LOFT_ERR_RANGE);
    for (int i = 0; i < LOFT_AXES; i++)
        axis[i].steps_per_mm = 1;
    CHECK(loft_drive_init(&d, &c) == LOFT_OK);
    c.ramp = 0;
    CHECK(loft_drive_init(&d, &c) == LOFT_ERR_RANGE);
    c.ramp = 10;
    c.cells = 1;
    CHECK(loft_drive_init(&d, &c) == LOFT_ERR_RANGE);
    c.cells = 2;
    c.position[0] = INT32_MAX;
    CHECK(loft_drive_init(&d, &c) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(whatever_happens_a_job_passes_every_point_and_ends_on_the_last,   20);
    PROPERTY(a_queue_that_runs_low_slows_the_machine_down_evenly,              15);
    PROPERTY(without_an_end_the_machine_stands_at_pace_0_and_says_that_it_starves, 15);
    PROPERTY(a_held_machine_stands_at_the_end_of_a_tick_until_it_is_resumed,   20);
    PROPERTY(an_abort_stands_on_the_path_and_the_next_job_begins_there,        30);
    PROPERTY(items_that_are_too_fast_are_refused_and_change_nothing,           20);
    PROPERTY(steps_that_do_not_fit_their_tick_are_all_made,                     5);
    PROPERTY(the_machine_starts_with_enough_in_the_queue,                      30);
    PROPERTY(turning_at_full_speed_is_counted_as_slowed,                       20);
    PROPERTY(an_interrupt_at_any_place_of_the_main_loop_does_no_harm,           8);
    PROPERTY(a_walk_is_ready_behind_short_spans,                              200);
    PROPERTY(init_refuses_what_cannot_work,                                     1);
    return check_failures();
}

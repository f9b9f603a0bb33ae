/* tests/support/rig.h -- a random job, its positions (walked by the test), and its pulses (counted
 * by the test)
 * SPDX-License-Identifier: MIT
 *
 * Every slot goes through rig_slot, which checks the pulses against the plan, and that a hard stop
 * ends them.
 */
#ifndef LOFT_TESTS_RIG_H
#define LOFT_TESTS_RIG_H

#include <math.h>           /* fmax, fmin, fabs */
#include <string.h>         /* memcpy */

#include "check.h"
#include "machine/drive.h"

#define SPANS_MOST 60
#define ITEMS 600
#define TICKS 4000
#define CELLS 64

typedef struct {
    loft_drive *drive;
    uint16_t slots, ramp, cells;
    enum loft_kind kind;
    loft_item item[ITEMS];
    uint32_t items, pushed;
    int32_t start[LOFT_AXES];                   /* as in loft_drive_begin            */
    int32_t path[TICKS + 1][LOFT_AXES];         /* steps after each tick of the plan */
    uint32_t item_of[TICKS];                    /* the item that a tick belongs to   */
    loft_action action[TICKS];                  /* that begins with it; .output 0: none */
    uint32_t ticks;

    int32_t at[LOFT_AXES];                      /* the sum of the pulses */
    uint32_t passed;                            /* ticks whose end was reached */
    uint32_t lasts;                             /* slots since then */
    double pace, lasted;                        /* of the previous tick */
    bool law;                                   /* the tick always comes in time: pace changes only
                                                 * by its law */
    uint8_t dir;
} rig;

static rig r;
static volatile loft_cell cells[CELLS];
static loft_axis_config axes[LOFT_AXES];

static const int32_t per_mm[6] = { 80 * 65536,        80 * 65536, 400 * 65536,
                                   13 * 65536 + 4242, 65536,      1000 * 65536 };

static loft_real scale_of(int i) { return loft_real_from_raw(per_mm[i]); }

static void steps_of(loft_vec mm, int32_t steps[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        steps[i] = loft_steps_of(mm.axis[i], scale_of(i));
}

/* Anywhere within `reach` of a coordinate, but within the range of coordinates. */
static int32_t moved(arb *a, int32_t from, int64_t reach)
{
    const int64_t to = (int64_t)from +
                       arb_raw(a, (int32_t)(reach < 1000000000 ? reach : 1000000000));
    return (int32_t)(to > INT32_MAX ? INT32_MAX : to < INT32_MIN ? INT32_MIN : to);
}

/* An action that moves a little and sets an output, constant or in proportion to the speed. */
static void arb_level(arb *a, loft_item *item, const int32_t from[LOFT_AXES])
{
    const loft_action action = { (uint8_t)(1 + arb_below(a, LOFT_MACHINE_OUTPUTS)),
                                 arb_below(a, 2) != 0, (uint16_t)arb_next(a),
                                 (uint16_t)(arb_below(a, 2) ? 0 : 1 + arb_below(a, 30000)) };
    int32_t place[LOFT_AXES];
    loft_vec mm;

    for (int i = 0; i < LOFT_AXES; i++) {
        place[i]   = moved(a, from[i], 10 * 65536LL * 65536 / per_mm[i]);
        mm.axis[i] = loft_real_from_raw(place[i]);
    }
    loft_action_item(item, &action, place);
    r.action[r.ticks]    = action;
    r.item_of[r.ticks++] = r.items++;
    steps_of(mm, r.path[r.ticks]);
}

/* A job of random items; a tick moves at most `reach` steps (apart from rounding). */
static void arb_spans(arb *a, int32_t reach)
{
    int32_t from[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        from[i] = r.start[i];
    while (r.items < SPANS_MOST && r.ticks < TICKS - 100) {
        loft_item *item = &r.item[r.items];
        loft_forward w;
        loft_span span;
        loft_vec mm;

        if (arb_below(a, 6) == 0) {
            arb_level(a, item, from);
            memcpy(from, item->p[2], sizeof from);
            continue;
        }
        item->ticks = (uint16_t)(1 + arb_below(a, arb_below(a, 5) == 0     ? 4
                                                  : arb_below(a, 20)       ? 80
                                                  : TICKS - r.ticks < 1000 ? 100
                                                                           : 1000));
        for (int i = 0; i < LOFT_AXES; i++)
            for (int k = 0; k < 3; k++)
                item->p[k][i] = moved(a, k ? item->p[k - 1][i] : from[i],
                                      (int64_t)reach * item->ticks * 65536 / 3 * 65536 / per_mm[i]);
        loft_item_span(item, from, &span);
        CHECK(loft_span_walk(&w, &span) == LOFT_OK);
        while (loft_forward_next(&w, &mm)) {
            r.item_of[r.ticks++] = r.items;
            steps_of(mm, r.path[r.ticks]);
        }
        for (int i = 0; i < LOFT_AXES; i++)
            from[i] = item->p[2][i];
        r.items++;
    }
}

static void arb_points(arb *a, int32_t reach)
{
    while (r.items < ITEMS) {
        loft_item *item = &r.item[r.items];
        *item = (loft_item){ { { 0 } }, 1 };
        r.item_of[r.ticks++] = r.items;
        for (int i = 0; i < LOFT_AXES; i++)
            r.path[r.ticks][i] = item->p[2][i] = r.path[r.ticks - 1][i] + arb_raw(a, reach);
        r.items++;
    }
}

/* The operator holds, resumes and overrides. */
static inline void rig_operate(arb *a)
{
    if (arb_below(a, 4000) == 0)
        loft_drive_hold(r.drive, true);
    if (arb_below(a, 1000) == 0)
        loft_drive_hold(r.drive, false);
    if (arb_below(a, 4000) == 0)
        loft_drive_override(r.drive, arb_below(a, 220));
}

/* A job, and a configuration of the machine for it. */
static loft_drive_config rig_init(arb *a, loft_drive *drive, uint16_t slots, uint16_t ramp,
                                  int32_t reach)
{
    loft_drive_config c;
    loft_vec start;

    r = (rig){ .drive = drive,
               .slots = slots,
               .ramp = ramp,
               .cells = (uint16_t)(2 + arb_below(a, CELLS - 1)) };
    r.kind = arb_below(a, 3) ? LOFT_SPANS : LOFT_POINTS;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int32_t raw = arb_raw(a, 100 * 65536);
        axes[i] = (loft_axis_config){ .steps_per_mm = per_mm[i] };
        start.axis[i] = loft_real_from_raw(raw);
        r.start[i] = raw;
    }
    steps_of(start, r.path[0]);
    for (int i = 0; i < LOFT_AXES; i++) {
        c.position[i] = r.at[i] = r.path[0][i];
        if (r.kind == LOFT_POINTS)
            r.start[i] = r.at[i];
    }
    if (r.kind == LOFT_SPANS)
        arb_spans(a, reach);
    else
        arb_points(a, reach);
    c.axis = axes;
    c.tick_hz = 1000;
    c.slots = slots;
    c.ramp = ramp;
    c.cell = cells;
    c.cells = r.cells;
    c.outputs = LOFT_MACHINE_OUTPUTS;
    return c;
}

static bool here(const int32_t want[LOFT_AXES])
{
    int32_t at[LOFT_AXES];

    loft_step_position(&r.drive->step, at);
    for (int i = 0; i < LOFT_AXES; i++)
        if (r.at[i] != want[i] || at[i] != want[i])
            return false;
    return true;
}

/* The speeds of neighbouring ticks differ by at most 1 / ramp per tick between their middles; see
 * test_pace.c. */
static void check_law(double lasts)
{
    const double pace = lasts > 0 ? r.slots / lasts : 0, middle = (lasts + r.lasted) / 2 / r.slots;
    const double rounding = (pace + r.pace) * (1 / fmax(lasts, r.lasted) +
                                               1 / fmin(fmax(lasts, 1), fmax(r.lasted, 1)) + 0.003);

    CHECK_NEAR(pace, r.pace, middle / r.ramp * (1 + 1. / r.ramp) + rounding);
    r.pace = pace;
    r.lasted = lasts;
}

/* Run one slot: count pulses, check that directions are set up in time, and that each tick ends at
 * the planned place, in the planned order. */
static void rig_slot(void)
{
    const bool moving = !loft_step_done(&r.drive->step);
    const loft_pins pins = loft_drive_slot(r.drive);

    CHECK((pins.step & (pins.dir ^ r.dir)) == 0);
    r.dir = pins.dir;
    for (int i = 0; i < LOFT_AXES; i++)
        if (pins.step & (1u << i))
            r.at[i] += pins.dir & (1u << i) ? -1 : 1;
    if (r.drive->active && r.drive->halt) {     /* from now on nothing moves */
        CHECK(pins.step == 0 && loft_step_done(&r.drive->step) && here(r.at));
        return;
    }
    if (!moving) {
        CHECK(pins.step == 0);
        if (r.law && r.pace > 0)
            check_law(0);
        return;
    }
    r.lasts++;
    if (!r.drive->step.busy) {
        CHECK(r.passed < r.ticks);
        CHECK(here(r.path[++r.passed]));
        if (r.law)
            check_law(r.lasts);
        r.lasts = 0;
    }
}

#endif

/* lib/machine/drive_tick.c -- the drive's part in interrupts: the queue becomes ticks, ticks slots
 * SPDX-License-Identifier: MIT
 */
#include "machine/drive.h"

/* The kind of a tick, to count it after its last pulse. */
enum { NO_TICK = 0, TICK = 1, LAST_TICK = 2 };     /* LAST_TICK: of its item */

/* The shortest span, in ticks, that needs a walk. A span of one tick is just its end, a span of two
 * its middle and its end. */
#define WALKED 3

/* A span of so few ticks may be over before a message is answered and the next walk prepared: 5 and
 * 3 ms on an ATmega328P, which interrupts leave a quarter of its time. */
#define SHORT 8

/* The number of items that one call looks at, or looks ahead. The queue empties by at most one item
 * per tick, so any number above 1 catches up. */
#define LOOKS 8


// Tick
// ----

static void run_prepared(loft_drive *d)
{
    loft_outputs_run(&d->outputs);
    d->running = d->prepared;
    d->prepared = NO_TICK;
}

static void count_running(loft_drive *d)
{
    d->ticks += d->running != NO_TICK;
    d->executed += d->running == LAST_TICK;
}

/* The step module holds two ticks: the running one and the prepared one. When there is room again,
 * the prepared tick runs, so the tick before it is over. When all is done, the running tick is over
 * as well: then the next one that is prepared runs with the next slot. */
static void count_ticks(loft_drive *d)
{
    if (d->prepared) {
        count_running(d);
        run_prepared(d);
    }
    if (loft_step_done(&d->step)) {
        count_running(d);
        d->running = NO_TICK;
    }
}

static bool walk_is_ready(const loft_drive *d) { return d->ready && d->ready_item == d->item; }

/* The law of supply. The queue is worth the ticks of its items, or the ticks that an equally full
 * queue of full items has, whichever is more:
 *
 *     fill = max(ahead, items * 4 H / cells)        H = 16 * the ticks from pace 1 to a stop
 *
 * The pace is fill / H. A line that delivers a part q of what the plan needs finds the fill at q H
 * and keeps it there: d fill / dt = q - fill / H approaches q H without oscillation. While the fill
 * is within 1/8 of the value for the pace, the pace does not change, so that items may come in
 * portions. From a stop the fill must reach a sixteenth of that for pace 1, so that the motion can
 * continue. A line that delivers q > 1 fills an empty queue to H in the time H ln(q / (q - 1)),
 * of which H (1 - (q - 1) ln(q / (q - 1))) are lost. What is planned here counts twice: no frame
 * of it is lost, and its portions are the spans of some knots.
 *
 * Independent of that, the level is limited. It changes by one unit per tick, and each tick takes
 * one of `ahead`. In units of the level:
 *
 *     going down    ahead - level is constant
 *     otherwise     ahead - level falls by 2 at most      only if level + 1 <= ahead - 1 - MARGIN
 *
 * With a full queue, when nothing more can come, MARGIN is 0. So ahead >= level always, and the
 * machine stops before the queue is empty or at its last tick. */
static uint16_t level_of_pace(uint16_t full, uint16_t pace)      /* Q8; 2^14 * 2^18 */
{
    return pace >= 512 ? (uint16_t)(4 * full) : (uint16_t)((uint32_t)full * pace * pace >> 16);
}

/* True if a span of several ticks comes next. Its beginning is enough work for one tick. */
static bool long_span_begins(const loft_drive *d)
{
    return d->kind != LOFT_POINTS && d->left == 0 && d->supply && loft_queue_first(&d->queue) &&
           loft_queue_first(&d->queue)->ticks > 1;
}

static uint16_t supplied_level(loft_drive *d)
{
    const uint16_t full = loft_pace_full(&d->pace), unit = loft_pace_unit(&d->pace);
    const uint32_t need = loft_queue_full(&d->queue) ? 1 : 1 + LOFT_DRIVE_MARGIN,
                   items = (uint32_t)d->queue.looked * d->share;
    const uint32_t held = d->ahead > items ? d->ahead : items,
                   fill = LOFT_MACHINE_PLANS && d->kind == LOFT_CURVES ? 2 * held : held;

    if (fill >= (uint32_t)20 * (d->ramp + 1u)) {
        d->supply = (uint16_t)(4 * full);
    } else if (!long_span_begins(d)) {
        /* 16 fill / stop; fill gain < 20 (2 stop + 1) 2^16 / stop */
        const uint16_t pace = (uint16_t)(fill * d->gain >> 12);
        const uint16_t least = level_of_pace(full, (uint16_t)(pace - pace / 8)),
                       most = level_of_pace(full, (uint16_t)(pace + pace / 8));
        if (d->supply < least && (d->supply || least >= full / 256 + 1))
            d->supply = least;
        else if (d->supply > most)
            d->supply = most;
    }
    const uint32_t sure = d->ahead > need ? (d->ahead - need) * unit : 0;
    return d->supply < sure ? d->supply : (uint16_t)sure;
}

/* The level of the override, or the level that the override limits of the items allow if that is
 * lower. The level can fall by one unit per tick. At the end of the next tick it may therefore be
 * so high that it still falls to each limit at the beginning of its item,
 *
 *     level <= limit + unit * (ticks before that item - 1)
 *
 * and, by the limit of the next tick itself, it stays within them from then on. It is never too
 * high when an item arrives: a new item has `ahead` ticks before it, and the law of supply keeps at
 * least as many ticks as the level needs. The search through the queue ends where even the lowest
 * limit is far enough away. Up to pace 1 there is nothing to search for. */
static uint16_t allowed_level(const loft_drive *d)
{
    const uint16_t full = loft_pace_full(&d->pace);
    const uint16_t unit = loft_pace_unit(&d->pace);
    uint16_t level = d->ordered;
    uint32_t before = d->left;
    const volatile loft_cell *cell;

    if (level <= full || d->kind == LOFT_POINTS)
        return level < full ? level : full;
    if (before && level > loft_override_limit_level(d->limit, full))
        level = loft_override_limit_level(d->limit, full);
    for (uint16_t k = 0;
         level > full && before * unit < level && (cell = loft_queue_cell(&d->queue, k)) != NULL;
         k++) {
        const uint32_t most = loft_override_limit_level(cell->tag, full) +
                              (before ? (before - 1) * unit : 0);
        if (level > most)
            level = (uint16_t)most;
        before += loft_item_lasts(&cell->item);
    }
    return level;
}

static void steer_pace(loft_drive *d, bool ended)
{
    const uint8_t percent = d->percent;

    if (percent != d->obeyed) {
        d->obeyed = percent;
        d->ordered = loft_pace_level(&d->pace, percent);
    }
    uint16_t level = d->hold || d->abort ? 0 : allowed_level(d);
    const uint16_t most = ended ? level : supplied_level(d);
    d->starved = !ended && most < d->ordered;
    loft_pace_aim(&d->pace, level < most ? level : most);
}

static void finish_job(loft_drive *d, enum loft_machine_state state)
{
    d->starved = 0;
    d->state = (uint8_t)state;
    loft_outputs_clear(&d->outputs);
    d->active = 0;
}

/* There is no tick to prepare: time stands still, or all items are used. */
static void stand_still(loft_drive *d, bool ended)
{
    if (!loft_step_done(&d->step))
        return;
    loft_outputs_rest(&d->outputs);
    if (d->ahead == 0 && ended)
        finish_job(d, LOFT_STATE_DONE);
    else if (d->abort)
        finish_job(d, LOFT_STATE_ABORTED);
    else
        d->state = d->hold ? LOFT_STATE_HELD : LOFT_STATE_RUNNING;
}

/* Any coordinates and 1..LOFT_SPAN_TICKS_MAX ticks are within the ranges of the walk. */
static void walk_item(loft_drive_walk *walk, const volatile loft_item *item,
                      const volatile int32_t from[LOFT_AXES])
{
    loft_powers3 powers;

    loft_powers3_init(&powers, item->ticks);
    walk->moves = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int32_t start = from[i];
        loft_real p[4];
        p[0] = loft_real_from_raw(start);
        for (int k = 0; k < 3; k++) {
            const int32_t next = item->p[k][i];
            if (next != start)
                walk->moves = (uint8_t)(walk->moves | 1u << i);
            p[k + 1] = loft_real_from_raw(next);
        }
        if (walk->moves & 1u << i)
            loft_walk3_init(&walk->axis[i], p, &powers);
    }
}

/* True if the next span that needs a walk is prepared, even if spans that need none come first. */
static bool walk_is_prepared(const loft_drive *d)
{
    return d->ready && (uint8_t)(d->ready_item - d->item) < LOOKS;
}

/* The tick may take items while this runs; the item number tells when the walk is to be used. The
 * tick does not use walk[!which] before `ready` is set, and increments `item` before it changes
 * `from`. */
void loft_drive_prepare(loft_drive *d)
{
    const volatile int32_t *from = d->from;
    const volatile loft_item *item;
    uint8_t number, behind = 0;

    if (!d->active || walk_is_prepared(d) || d->kind == LOFT_POINTS)
        return;
    d->ready = 0;
    do {
        number = d->item;
        item   = loft_queue_peek(&d->queue, 0);
    } while (number != d->item);
    for (; item && item->ticks < WALKED && behind < LOOKS - 1;
         item = loft_queue_peek(&d->queue, behind)) {
        from = item->p[2];
        behind++;
    }
    /* items were taken meanwhile: try again later */
    if (!item || item->ticks < WALKED || number != d->item)
        return;
    walk_item(&d->walk[!d->which], item, from);
    LOFT_BARRIER();
    d->ready_item = (uint8_t)(number + behind);
    d->ready = 1;
}

/* The walk after the one that is prepared can only be made when the item of that one begins, and
 * must be ready at its end. If an answer begins shortly before a short item, the walk waits for it.
 * That cannot last: each item that begins leaves one less in the queue, and before the last one
 * nothing is waited for. At half the pace there is time for both. */
bool loft_drive_pressed(const loft_drive *d)
{
    if (d->state != LOFT_STATE_RUNNING || d->kind == LOFT_POINTS || !d->ready ||
        d->pace.level < loft_pace_full(&d->pace) / 4 || *(const volatile uint16_t *)&d->left > 1)
        return false;
    const uint8_t at = (uint8_t)(d->ready_item - d->item);
    const volatile loft_item *item = loft_queue_peek(&d->queue, at);
    if (!item || item->ticks > SHORT)
        return false;
    item = loft_queue_peek(&d->queue, at + 1u);
    return item && item->ticks >= WALKED;
}

static bool next_point(loft_drive *d)
{
    if (!loft_points_poll(&d->points, &d->queue))
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        d->from[i] += d->points.step[i];
    d->left = 1;
    return true;
}

/* The tick that is prepared ends there. */
static void aim_axis(loft_drive *d, int axis, loft_real at)
{
    loft_outputs_aim(&d->outputs, axis, loft_raw_from_real(at));
    d->target[axis] = loft_steps_of(at, loft_drive_gear(d, axis));
}

/* In its tick an action does what it says from then on. The plan rests at a pause, so nothing moves
 * that would have to slow down. */
static void obey_action(loft_drive *d, const volatile loft_item *item)
{
    const loft_action action = loft_item_action(item);

    if (action.output > 0) {
        loft_outputs_take(&d->outputs, &action, d->tick_hz);
        return;
    }
    d->hold = 1;
    loft_pace_stop(&d->pace);
}

static void aim_at_middle(loft_drive *d, const volatile loft_item *item)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real half = loft_walk3_middle(
            loft_real_from_raw(d->from[i]), loft_real_from_raw(item->p[0][i]),
            loft_real_from_raw(item->p[1][i]), loft_real_from_raw(item->p[2][i]));
        aim_axis(d, i, half);
    }
}

/* Take the next item. There is one, because it was counted in `ahead`. An item of two ticks aims at
 * its middle at once. */
static bool next_span(loft_drive *d)
{
    const volatile loft_item *item = loft_queue_first(&d->queue);

    if (!item)
        return false;
    const bool ready = walk_is_ready(d);
    d->item++;
    if (LOFT_MACHINE_OUTPUTS > 0 && item->ticks == 0)
        obey_action(d, item);
    if (item->ticks == 2)
        aim_at_middle(d, item);
    if (item->ticks >= WALKED) {
        if (ready)
            d->which ^= 1;
        else if (LOFT_MACHINE_TICK_PREPARES)
            walk_item(&d->walk[d->which], item, d->from);
        d->ready = 0;
    }
    loft_place_copy(d->from, item->p[2]);
    d->left = loft_item_lasts(item);
    d->limit = loft_queue_cell(&d->queue, 0)->tag;
    return loft_queue_poll(&d->queue);
}

/* The last tick of an item ends at the end of the item, so it needs no walk. */
static bool next_target(loft_drive *d)
{
    const bool begun = d->left == 0;

    loft_outputs_begin(&d->outputs);
    if (begun && !(d->kind == LOFT_POINTS ? next_point(d) : next_span(d)))
        return false;
    d->ahead--;
    if (--d->left == 0) {
        for (int i = 0; i < LOFT_AXES; i++)
            if (d->kind == LOFT_POINTS)
                d->target[i] = d->from[i];
            else
                aim_axis(d, i, loft_real_from_raw(d->from[i]));
        return true;
    }
    if (begun && d->left + 1 < WALKED)
        return true;
    loft_drive_walk *walk = &d->walk[d->which];
    for (int i = 0; i < LOFT_AXES; i++)
        if (walk->moves & 1u << i)
            aim_axis(d, i, loft_walk3_step(&walk->axis[i], false));
    return true;
}

/* True if a span comes next that the main loop must still prepare. */
static bool walk_is_missing(const loft_drive *d)
{
    if (LOFT_MACHINE_TICK_PREPARES || d->kind == LOFT_POINTS || d->left || !d->ahead ||
        walk_is_ready(d))
        return false;
    const volatile loft_item *item = loft_queue_first(&d->queue);
    return !item || item->ticks >= WALKED;
}

void loft_drive_next(loft_drive *d)
{
    const bool ended = d->ended;        /* read first, so that no item before the end is missed */

    if (d->halt)
        d->running = d->prepared = NO_TICK;     /* the slot drops them */
    count_ticks(d);
    for (uint8_t looks = 0; looks < LOOKS; looks++) {
        const uint16_t ticks = d->kind == LOFT_POINTS ? loft_points_look(&d->points, &d->queue)
                                                      : loft_queue_look(&d->queue);
        if (ticks == 0)
            break;
        d->ahead += ticks;
    }
    steer_pace(d, ended);
    if (walk_is_missing(d)) {
        if (loft_step_done(&d->step)) {
            d->slowed += loft_pace_distance(&d->pace) > 0;
            loft_outputs_rest(&d->outputs);
        }
        return;
    }

    const uint16_t slots = d->ahead && !d->halt ? loft_pace_next(&d->pace) : 0;
    if (slots == 0) {
        stand_still(d, ended);
        return;
    }
    if (!next_target(d)) {
        finish_job(d, LOFT_STATE_FAULT);    /* never with items that loft_drive_push took */
        return;
    }
    const bool next = loft_step_done(&d->step);
    const uint16_t lasts = loft_step_load(&d->step, d->target, slots);
    if (lasts > slots)
        d->slowed++;
    loft_outputs_prepare(&d->outputs, d->slots, lasts);
    d->prepared = d->left ? TICK : LAST_TICK;
    if (next)
        run_prepared(d);
    d->state = d->abort ? LOFT_STATE_STOPPING : d->hold ? LOFT_STATE_HOLDING : LOFT_STATE_RUNNING;
}


// Slot
// ----

static void count_slots(loft_drive *d, uint8_t count)
{
    if (!d->active)
        return;
    d->slot = (uint16_t)(d->slot + count);
    while (d->slot >= d->slots) {
        d->slot = (uint16_t)(d->slot - d->slots);
        d->elapsed++;
    }
}

/* A tick that is prepared meanwhile is dropped by the next slot. A port that drops slots which it
 * has made ahead drops the ticks as well. */
static void obey_halt(loft_drive *d)
{
    int32_t at[LOFT_AXES];

    if (!LOFT_MACHINE_SLOT_HALTS || !d->halt || loft_step_done(&d->step))
        return;
    loft_step_position(&d->step, at);
    loft_step_halt(&d->step, at);
}

loft_pins loft_drive_slot(loft_drive *d)
{
    obey_halt(d);
    count_slots(d, 1);
    return loft_step_next(&d->step);
}

loft_step_tick *loft_drive_take(loft_drive *d, uint8_t *count, uint8_t *dir)
{
    obey_halt(d);
    loft_step_tick *taken = loft_step_take(&d->step, count, dir);

    count_slots(d, *count);
    return taken;
}

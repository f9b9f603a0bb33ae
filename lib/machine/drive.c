/* lib/machine/drive.c -- the drive's part in the main loop: jobs begin, items go in, reports come
 * out
 * SPDX-License-Identifier: MIT
 *
 * drive_tick.c has the part that interrupts it.
 */
#include "machine/drive.h"

/* A span may move 3 max |p[k+1] - p[k]| / ticks per tick, because its derivative is a mean of those
 * differences, times 3. In steps: each difference is known to one step. Each end of a tick is
 * rounded by 1/2 step and, by the walk, by 0.52 LSB, which is 0.26 step at 32768 steps/mm. So
 * |difference| + 1 <= REACH_PER_TICK ticks leaves 3 * 10921 + 2 < 32767 steps. */
#define REACH_PER_TICK 10921u

static int32_t steps_of(const loft_drive *d, int axis, int32_t raw)
{
    return loft_steps_of(loft_real_from_raw(raw), loft_drive_gear(d, axis));
}

static uint32_t abs_difference(int32_t a, int32_t b)
{
    return a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
}


enum loft_status loft_drive_init(loft_drive *d, const loft_drive_config *config)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (config->axis[i].steps_per_mm <= 0)
            return LOFT_ERR_RANGE;
    if (loft_step_init(&d->step, config->position) != LOFT_OK ||
        loft_pace_init(&d->pace, config->slots, config->ramp) != LOFT_OK ||
        loft_queue_init(&d->queue, config->cell, config->cells) != LOFT_OK)
        return LOFT_ERR_RANGE;

    d->output_count = config->outputs > LOFT_MACHINE_OUTPUTS ? LOFT_MACHINE_OUTPUTS
                                                             : config->outputs;
    loft_outputs_clear(&d->outputs);
    d->axis = config->axis;
    d->kind = LOFT_SPANS;
    d->tick_hz = config->tick_hz;
    d->slots = config->slots;
    d->ramp = config->ramp;
    const uint32_t share = ((uint32_t)32 * (config->ramp + 1u) + config->cells - 1) / config->cells;
    d->share = (uint16_t)(share < UINT16_MAX ? share : UINT16_MAX);
    d->gain = (uint16_t)(UINT16_MAX / (config->ramp / 2u + config->ramp % 2u));
    d->percent = 100;
    d->tabled = 0;
    d->active = d->hold = d->abort = d->halt = d->ended = 0;
    d->state = LOFT_STATE_IDLE;
    d->executed = d->ticks = d->slowed = d->elapsed = 0;
    d->starved = 0;
    return LOFT_OK;
}

/* The tick ignores everything while `active` is 0, so everything may be set here. `active` is set
 * last. */
enum loft_status loft_drive_begin(loft_drive *d, enum loft_kind kind,
                                  const int32_t start[LOFT_AXES])
{
    if (d->active || d->state == LOFT_STATE_FAULT)
        return LOFT_ERR_ARG;
    loft_step_position(&d->step, d->target);
    for (int i = 0; i < LOFT_AXES; i++)
        if ((kind == LOFT_POINTS ? start[i] : steps_of(d, i, start[i])) != d->target[i])
            return LOFT_ERR_RANGE;
    if (loft_pace_init(&d->pace, d->slots, d->ramp) != LOFT_OK ||
        loft_queue_init(&d->queue, d->queue.cell, d->queue.count) != LOFT_OK)
        return LOFT_ERR_RANGE;          /* never after loft_drive_init */

    loft_outputs_init(&d->outputs, start);
    loft_points_init(&d->points);
    d->kind = (uint8_t)kind;
    loft_place_copy(d->from, start);
    loft_place_copy(d->end, start);
    d->ahead = d->left = 0;
    d->which = d->ready = d->item = 0;
    d->running = d->prepared = 0;
    d->limit = LOFT_OVERRIDE_LIMIT_ONE;
    d->percent = d->obeyed = 100;
    d->ordered = loft_pace_full(&d->pace);
    d->supply = 0;
    d->executed = d->ticks = d->slowed = d->elapsed = 0;
    d->slot = 0;
    d->starved = 1;                     /* the queue is empty */
    d->fresh = true;
    d->hold = d->abort = d->halt = d->ended = 0;
    d->state = LOFT_STATE_RUNNING;
    d->active = 1;
    return LOFT_OK;
}

enum loft_status loft_drive_place(loft_drive *d, uint8_t axes, const int32_t position[LOFT_AXES])
{
    int32_t to[LOFT_AXES];

    if (d->active || d->state == LOFT_STATE_FAULT)
        return LOFT_ERR_ARG;
    loft_step_position(&d->step, to);
    for (int i = 0; i < LOFT_AXES; i++)
        if (axes & 1u << i) {
            const uint32_t by = (uint32_t)position[i] - (uint32_t)to[i];
            to[i] = position[i];
            d->table[0][i] = (int32_t)((uint32_t)d->table[0][i] + by);
            d->table[1][i] = (int32_t)((uint32_t)d->table[1][i] + by);
        }
    return loft_step_place(&d->step, to);
}

enum loft_status loft_drive_table(loft_drive *d, int end, uint8_t axes,
                                  const int32_t position[LOFT_AXES])
{
    if (d->active)
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++)
        if (axes & 1u << i)
            d->table[end][i] = position[i];
    d->tabled = (uint8_t)(end ? d->tabled | axes : d->tabled & ~axes);
    return LOFT_OK;
}

bool loft_drive_inside(const loft_drive *d, const loft_item *item)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        int32_t to = item->p[2][i], from = d->end[i];
        if (!(d->tabled & 1u << i))
            continue;
        if (d->kind != LOFT_POINTS) {
            to   = steps_of(d, i, to);
            from = steps_of(d, i, from);
        }
        if ((to < d->table[0][i] && to < from) || (to > d->table[1][i] && to > from))
            return false;
    }
    return true;
}

static bool point_valid(const loft_drive *d, const loft_item *item)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (abs_difference(item->p[2][i], 0) > (uint32_t)LOFT_STEP_REACH ||
            abs_difference(item->p[2][i], d->end[i]) > LOFT_STEP_SLOTS_MAX)
            return false;
    return item->ticks == 1;
}

/* An action has one tick, in which it goes straight. */
static bool action_valid(const loft_drive *d, const loft_item *item)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (abs_difference(steps_of(d, i, d->end[i]), steps_of(d, i, item->p[2][i])) + 1 >
            REACH_PER_TICK)
            return false;
    return loft_item_action(item).output <= d->output_count;
}

static bool span_valid(const loft_drive *d, const loft_item *item)
{
    if (LOFT_MACHINE_OUTPUTS > 0 && item->ticks == 0)
        return action_valid(d, item);
    if (item->ticks < 1 || item->ticks > LOFT_SPAN_TICKS_MAX)
        return false;
    const uint32_t reach = REACH_PER_TICK * (uint32_t)item->ticks;
    for (int i = 0; i < LOFT_AXES; i++) {
        int32_t before = steps_of(d, i, d->end[i]);
        for (int k = 0; k < 3; k++) {
            const int32_t after = steps_of(d, i, item->p[k][i]);
            if (abs_difference(before, after) + 1 > reach)
                return false;
            before = after;
        }
    }
    return true;
}

/* The span that ends where the next one begins. Before a span that follows an action it counts as
 * at rest: so a moving one passes as planned. */
static const volatile loft_item *span_before(const loft_drive *d)
{
    const volatile loft_item *last = d->fresh ? NULL : loft_queue_last(&d->queue);

    return last && last->ticks > 0 ? last : NULL;
}

static enum loft_status queue_span(loft_drive *d, const loft_item *item)
{
    uint8_t limit = LOFT_OVERRIDE_LIMIT_ONE;

    if ((LOFT_MACHINE_OVERRIDE_LIMITS || d->percent > 100) && item->ticks > 0)
        limit = loft_override_limit_of(item, d->end, span_before(d), d->axis, d->tick_hz);
    return loft_queue_push(&d->queue, item, limit);
}

static enum loft_status queue_point(loft_drive *d, const loft_item *item)
{
    int16_t step[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        step[i] = (int16_t)(item->p[2][i] - d->end[i]);     /* it fits */
    return loft_points_push(&d->points, &d->queue, step);
}

enum loft_status loft_drive_push(loft_drive *d, const loft_item *item)
{
    if (!d->active || d->abort)
        return LOFT_OK;
    if (!(d->kind == LOFT_POINTS ? point_valid(d, item) : span_valid(d, item)))
        return LOFT_ERR_RANGE;

    const enum loft_status status = d->kind == LOFT_POINTS ? queue_point(d, item)
                                                           : queue_span(d, item);
    if (status == LOFT_OK) {
        loft_place_copy(d->end, item->p[2]);
        d->fresh = false;
    }
    return status;
}

void loft_drive_end(loft_drive *d)              { d->ended = 1; }
void loft_drive_hold(loft_drive *d, bool hold)  { d->hold = hold; }
void loft_drive_abort(loft_drive *d)            { d->abort = 1; }
void loft_drive_halt(loft_drive *d)             { d->halt = d->abort = 1; }

void loft_drive_override(loft_drive *d, unsigned percent)
{
    d->percent = (uint8_t)(percent < 1 ? 1 : percent > LOFT_PACE_MAX ? LOFT_PACE_MAX : percent);
}

void loft_drive_close(loft_drive *d)
{
    if (!d->active && d->state != LOFT_STATE_FAULT)
        d->state = LOFT_STATE_IDLE;
}

/* A counter of the tick or the slot, read consistently: two equal reads are not torn. */
static uint32_t read_count(const volatile uint32_t *count)
{
    uint32_t once, again = *count;

    do {
        once = again;
        again = *count;
    } while (once != again);
    return again;
}

/* The state is read first. Once it says that the job is over, nothing changes any more. */
loft_drive_report loft_drive_poll(loft_drive *d)
{
    loft_drive_report r;

    r.state = d->state;
    r.executed = read_count(&d->executed);
    r.ticks = read_count(&d->ticks);
    r.elapsed = read_count(&d->elapsed);
    r.slowed = read_count(&d->slowed);
    r.starved = d->starved && r.ticks > 0;      /* not while the first items are awaited */
    r.room = d->kind == LOFT_POINTS ? loft_points_room(&d->points, &d->queue)
                                    : loft_queue_room(&d->queue);
    loft_step_position(&d->step, r.position);
    return r;
}

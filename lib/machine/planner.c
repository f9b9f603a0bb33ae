/* lib/machine/planner.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/planner.h"

// Patches
// -------

static enum loft_patch_state patch_state(const loft_planner *p)
{
    const loft_patch_source *source = p->memory.patches;

    return source ? (enum loft_patch_state)source->state : LOFT_PATCH_NONE;
}

static enum loft_refusal take_part(loft_planner *p, const loft_item *item)
{
    loft_patch_source *source = p->memory.patches;

    if (!source)
        return LOFT_REFUSAL_KIND;
    const enum loft_refusal refusal = source->take(source, item, &p->at);
    if (refusal == LOFT_REFUSAL_NONE) {
        p->parts++;
        p->taken++;
    }
    return refusal;
}


// Curves
// ------

enum loft_status loft_planner_init(loft_planner *p, const loft_planner_memory *memory,
                                   uint16_t cells)
{
    if (memory->move_room < 4 || memory->knot_room < LOFT_PLAN_KNOTS_MIN)
        return LOFT_ERR_SPACE;
    p->memory = *memory;
    p->marks  = (uint16_t)(cells + LOFT_PLANNER_AHEAD);
    p->taken  = p->executed = p->spans = p->parts = 0;
    p->mark   = 0;
    p->closed = p->ended = p->rests = true;
    p->busy   = p->failed = false;
    return LOFT_OK;
}

static int32_t lower_limit(int32_t a, int32_t b)      { return b > 0 && b < a ? b : a; }

/* 0 means no limit. */
static uint32_t lower_jerk(uint32_t a, uint32_t b) { return a == 0 || (b > 0 && b < a) ? b : a; }

enum loft_status loft_planner_begin(loft_planner *p, const loft_machine_info *machine,
                                    const loft_job_limits *asked, const int32_t start[LOFT_AXES])
{
    loft_limits limits;

    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = loft_real_from_raw(
            lower_limit(asked->axis[i].max_speed, machine->axis[i].max_speed));
        limits.max_accel[i] = loft_real_from_raw(
            lower_limit(asked->axis[i].max_accel, machine->axis[i].max_accel));
        limits.max_jerk[i]  = lower_jerk(machine->axis[i].max_jerk, asked->axis[i].max_jerk);
        p->at.axis[i] = loft_real_from_raw(start[i]);
    }
    limits.corner  = loft_real_from_raw(asked->corner);
    limits.tol     = loft_real_from_raw(asked->tol);
    limits.exact   = 0;
    limits.tick_hz = machine->tick_hz;
    limits.one_sided = LOFT_AXES > 2 ? 1 << 2 : 0;      /* the pen goes no deeper than planned */
    p->taken = p->executed = p->spans = p->parts = 0;
    p->mark  = 0;
    p->closed = p->ended = p->rests = p->busy = p->failed = false;
    if (p->memory.patches)
        p->memory.patches->state = LOFT_PATCH_NONE;
    return loft_plan_init(&p->plan, &limits, p->memory.moves, p->memory.move_room, p->memory.knots,
                          p->memory.knot_room);
}

/* mm/min to mm/s. */
static loft_real feed_of(uint16_t per_minute)
{
    return loft_acc_round(loft_acc_ratio(loft_to_acc(LOFT_REAL(1)) * per_minute, 60));
}

static enum loft_status push_move(loft_planner *p, const loft_move *move)
{
    const enum loft_status status = loft_plan_push(&p->plan, move);

    if (status == LOFT_OK) {
        p->at = move->curve.p[3];
        p->rests = false;
    }
    return status;
}

enum loft_refusal loft_planner_push(loft_planner *p, const loft_item *item)
{
    loft_move move;

    if (item->ticks == 0)
        return take_part(p, item);
    if (patch_state(p) != LOFT_PATCH_NONE)
        return LOFT_REFUSAL_ITEM;
    move.feed = feed_of(item->ticks);
    move.curve.p[0] = p->at;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            move.curve.p[k + 1].axis[i] = loft_real_from_raw(item->p[k][i]);
    if (push_move(p, &move) != LOFT_OK)
        return LOFT_REFUSAL_ITEM;
    p->taken++;
    return LOFT_REFUSAL_NONE;
}

static void end_curves(loft_planner *p)
{
    p->ended = true;
    loft_plan_end(&p->plan);
}

enum loft_refusal loft_planner_end(loft_planner *p)
{
    if (patch_state(p) == LOFT_PATCH_GATHERED)
        return LOFT_REFUSAL_ITEM;
    p->closed = true;
    if (patch_state(p) != LOFT_PATCH_CUT)
        end_curves(p);
    return LOFT_REFUSAL_NONE;
}

/* Push the next curve of a patch. Returns true if there was room, so that more may follow. */
static bool cut_patch(loft_planner *p)
{
    loft_patch_source *source = p->memory.patches;
    loft_move move;
    uint16_t feed;

    if (patch_state(p) != LOFT_PATCH_CUT || loft_plan_room(&p->plan) == 0)
        return false;
    if (source->next(source, &move.curve, &feed)) {
        move.feed = feed_of(feed);
        p->failed = p->failed || push_move(p, &move) != LOFT_OK;
        return !p->failed;
    }
    if (p->closed)
        end_curves(p);
    return false;
}

/* Each span is marked with the number of curves that end before its end. They are executed when the
 * span is. */
static bool give_span(loft_planner *p, const loft_span *span, loft_item *out)
{
    p->memory.passed[p->mark] = loft_plan_passed(&p->plan);
    p->mark = (uint16_t)(p->mark + 1 < p->marks ? p->mark + 1 : 0);
    p->spans++;
    return loft_item_from_span(out, span) == LOFT_OK;
}

bool loft_planner_next(loft_planner *p, bool hurry, loft_item *out)
{
    const bool cuts = cut_patch(p);
    loft_span span;
    enum loft_plan_state state = loft_plan_part(&p->plan, &span);

    if (state == LOFT_PLAN_WAIT && hurry && !cuts &&
        loft_plan_room(&p->plan) <= p->memory.move_room / 2) {
        loft_plan_end(&p->plan);
        state = loft_plan_part(&p->plan, &span);
    }
    p->rests = state == LOFT_PLAN_REST;
    p->busy  = state == LOFT_PLAN_BUSY || cuts;
    return state == LOFT_PLAN_SPAN && give_span(p, &span, out);
}

uint16_t loft_planner_room(const loft_planner *p)
{
    return patch_state(p) > LOFT_PATCH_GATHERED ? 0 : loft_plan_room(&p->plan);
}

uint32_t loft_planner_executed(loft_planner *p, uint32_t spans)
{
    const uint32_t since = p->spans - spans;        /* given, but not yet executed */

    if (spans > 0 && since < p->marks) {
        const uint32_t at = (uint32_t)p->mark + p->marks - 1u - since;
        const uint16_t passed = p->memory.passed[at < p->marks ? at : at - p->marks];
        p->executed += (uint16_t)(passed - (uint16_t)(p->executed & 0xFFFFu));
    }
    return p->executed < p->taken - p->parts ? p->executed : p->taken - p->parts;
}

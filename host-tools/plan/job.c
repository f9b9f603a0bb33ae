/* host-tools/plan/job.c -- plans a job while it is drawn
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "motion/span.h"    /* loft_span_walk */
#include "machine/step.h"   /* loft_steps_of */
#include "wire/action_code.h"   /* loft_action_item */
#include "wire/sender.h"    /* loft_job_id */

#include "plan/job.h"
#include "plan/job_curve.h"      /* job_curve */
#include "plan/job_input.h"      /* job_input_crc */
#include "base/spool.h"          /* spool_grow */
#include "base/host.h"
#include "base/memory.h"
#include "base/tool.h"

#define FIRST   64          /* items that identify the plan */
#define AHEAD   65536       /* items planned ahead: more than any queue, so that frames are full */
#define OPENING 0.2         /* s for the first portion */


// Items
// -----

/* Forget items below `kept`, but only if there are many. */
static void make_room(job *j, size_t kept)
{
    const size_t held = j->count - j->low, most = kept < j->count ? kept : j->count;
    const size_t drop = most > j->low ? most - j->low : 0;

    if (held < j->room)
        return;
    if (drop >= j->room / 2 && drop > 0) {
        memmove(j->entry, j->entry + drop, (held - drop) * sizeof *j->entry);
        j->low += drop;
        return;
    }
    j->room  = j->room ? 2 * j->room : 256;
    j->entry = memory_grow(j->entry, j->room * sizeof *j->entry);
}

/* Item n is due after `due` ticks. */
static void time_item(job *j, size_t n, uint64_t due)
{
    if (n >= j->low)
        j->entry[n - j->low].due = due;
    if (n == j->first)
        j->first_due = due;
    j->timed = n + 1;
}

static void add_item(job *j, const loft_item *item, size_t kept)
{
    make_room(j, kept);
    j->entry[j->count - j->low].item = *item;
    j->entry[j->count - j->low].span = j->spans;
    memcpy(j->last, item->p[2], sizeof j->last);
    j->count++;
}

static void add_timed(job *j, const loft_item *item, size_t kept)
{
    add_item(j, item, kept);
    time_item(j, j->count - 1, j->ticks);
    j->ticks += loft_item_lasts(item);
}

void job_source(void *context, uint32_t index, loft_item *out)
{
    const job *j = context;

    *out = j->entry[index - j->low].item;
}

void job_sent_from(job *j, size_t first)
{
    j->first = first;
    if (first < j->timed && first >= j->low)
        j->first_due = j->entry[first - j->low].due;
}


// Points
// ------

static void steps_of(loft_vec at, const int32_t steps_per_mm[ENGINE_AXES], int32_t out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = loft_steps_of(at.axis[i], steps_per_mm[i]);
}

/* Walk a span as a machine does. This file is compiled in q16: a loft_real is a raw coordinate. */
static int add_points(job *j, const loft_item *span, const int32_t from[ENGINE_AXES], size_t kept)
{
    loft_forward w;
    loft_span s;
    loft_vec at;

    loft_item_span(span, from, &s);
    const int status = loft_span_walk(&w, &s);
    while (status == LOFT_OK && loft_forward_next(&w, &at)) {
        loft_item item = { .ticks = 1 };
        steps_of(at, j->steps_per_mm, item.p[2]);
        add_timed(j, &item, kept);
    }
    return status;
}


// Events
// ------

/* The outputs of a machine. */
enum { SPINDLE = 1, COOLANT = 2 };

#define FULL 65535.0

bool job_can(const struct job_does *does, const drawing_event *e)
{
    switch (e->doing) {
    case DRAWING_SPINS: return does->actions && does->outputs >= SPINDLE;
    case DRAWING_COOLS: return does->actions && does->outputs >= COOLANT;
    default:            return does->actions;
    }
}

/* Stand still. */
static void add_wait(job *j, double seconds, size_t kept)
{
    loft_item item;
    double ticks = ceil(seconds * j->tick_hz - 1e-6);

    for (int k = 0; k < 3; k++)
        memcpy(item.p[k], j->end, sizeof item.p[k]);
    for (; ticks >= 1; ticks -= item.ticks) {
        item.ticks = (uint16_t)fmin(ticks, LOFT_SPAN_TICKS_MAX);
        add_timed(j, &item, kept);
    }
}

static void add_action(job *j, const loft_action *action, size_t kept)
{
    loft_item item;

    loft_action_item(&item, action, j->end);
    add_timed(j, &item, kept);
}

/* Output 1 at a level from a tick on, in which the motors go to `to`. */
static void add_level(job *j, double level, const int32_t to[ENGINE_AXES], size_t kept)
{
    loft_action action = { .output = SPINDLE, .level = (uint16_t)lround(level * FULL) };
    loft_item item;

    action.moving = j->of->path->laser;
    action.feed   = (uint16_t)fmin(round(j->feed * 60), FULL);
    loft_action_item(&item, &action, to);
    add_timed(j, &item, kept);
    j->levels.given = level;
}

static void add_spindle(job *j, const toolpath_event *t, size_t kept)
{
    const double level = levels_of(&t->e, j->does.s_max);

    j->feed      = t->feed;
    j->levels.is = level;
    add_level(j, level, j->end, kept);
    if (!j->of->path->laser && level > 0 && !j->spins)
        add_wait(j, j->does.spin_up, kept);
    j->spins = level > 0;
}

static void add_event(job *j, const toolpath_event *t, size_t kept)
{
    const loft_action coolant = { .output = COOLANT, .level = t->e.way ? (uint16_t)FULL : 0 };
    const loft_action pause   = { .output = 0 };

    if (!job_can(&j->does, &t->e))
        return;
    switch (t->e.doing) {
    case DRAWING_WAITS: add_wait(j, t->e.amount, kept); break;
    case DRAWING_SPINS: add_spindle(j, t, kept); break;
    case DRAWING_COOLS: add_action(j, &coolant, kept); break;
    case DRAWING_PAUSES:
        j->pause = memory_grow(j->pause, (j->pauses + 1) * sizeof *j->pause);
        j->pause[j->pauses].item   = j->count;
        j->pause[j->pauses++].text = t->e.text;
        add_action(j, &pause, kept);
    }
}

/* The events before move n; those in it come with its spans. */
static void add_events(job *j, size_t n, size_t kept)
{
    const toolpath *path = j->of->path;

    if (levels_wait(&j->levels))
        add_level(j, j->levels.is, j->end, kept);
    for (; j->head.kind == LOFT_SPANS && j->event < path->events; j->event++) {
        const toolpath_event *t = &path->event[j->event];
        const size_t at         = joints_from(j->of, t->move);
        if (at > n || (at == n && t->e.along > 0))
            break;
        add_event(j, t, kept);
    }
}

/* The move before which the plan stops next, after move n. A line in which something changes is
 * planned by itself. */
static size_t next_stop(const job *j, size_t n)
{
    const toolpath *path = j->of->path;

    for (size_t k = j->event; k < path->events && j->head.kind == LOFT_SPANS; k++) {
        const toolpath_event *t = &path->event[k];
        if (!job_can(&j->does, &t->e))
            continue;
        if (joints_from(j->of, t->move) > n)
            return joints_from(j->of, t->move);
        if (t->e.along > 0 && joints_from(j->of, t->move + 1) > n)
            return joints_from(j->of, t->move + 1);
    }
    return j->of->count;
}

/* The events in the line that is planned from move n on. */
static void find_levels(job *j, size_t n)
{
    const toolpath *path = j->of->path;
    levels *l            = &j->levels;

    l->k     = j->k;
    l->s_max = j->does.s_max;
    l->event = &path->event[j->event];
    l->left  = 0;
    for (size_t k = j->event;
         k < path->events && path->event[k].e.along > 0 &&
         joints_from(j->of, path->event[k].move) == n && job_can(&j->does, &path->event[k].e);
         k++)
        l->left++;
    if (l->left > 0)
        l->line = &path->move[l->event->move];
}

/* A span of that line, cut where its level changes. */
static void add_levels(job *j, const engine_span *span, size_t kept)
{
    const size_t left = j->levels.left;
    levels_piece piece;
    loft_item item;

    levels_begin(&j->levels, span);
    while (levels_next(&j->levels, &piece)) {
        levels_cut(span, &piece, item.p);
        item.ticks = (uint16_t)(piece.to - piece.from);
        if (isnan(piece.level))
            add_timed(j, &item, kept);
        else
            add_level(j, piece.level, item.p[2], kept);
    }
    j->event += left - j->levels.left;
}


// Curves
// ------

static void add_curves(job *j, const joints *of, const job_options *o)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        j->head.start[i] = j->start[i] = j->end[i] = (int32_t)lround(of->move[0].p[0][i] * 65536);
    for (unsigned n = 0; o->patch != NULL && n < o->parts; n++)
        add_item(j, &o->patch[n], 0);
    for (size_t n = 0; o->patch == NULL && n < of->count; spool_passed(n++)) {
        const loft_item item = job_curve(&of->move[n], n > 0 ? j->last : j->head.start);
        add_item(j, &item, 0);
    }
}


// Planning
// --------

/* The duration at the feeds, along the control points: it measures how much of the work is done. */
static double seconds_of(const engine_move *m)
{
    double sum = 0;

    for (int k = 0; k < 3; k++) {
        double square = 0;
        for (int i = 0; i < ENGINE_AXES; i++)
            square += (m->p[k + 1][i] - m->p[k][i]) * (m->p[k + 1][i] - m->p[k][i]);
        sum += sqrt(square);
    }
    return sum / m->feed;
}

/* All passed moves end by the end of the last span. A curve is due when the moves before it are
 * passed. */
static void pass_moves(job *j)
{
    const joints *of = j->plan.j;

    for (const size_t now = joints_passed(&j->plan); j->passed < now; j->passed++) {
        j->done += seconds_of(&of->move[j->passed]);
        j->ends[j->passed] = (uint32_t)(j->patch ? j->ticks : j->count);
        if (j->head.kind == LOFT_CURVES && !j->patch && j->passed + 1 < j->count)
            time_item(j, j->passed + 1, j->ticks);
    }
}

static void begin_job_at(job *j, const int32_t at[ENGINE_AXES])
{
    loft_vec from;

    for (unsigned i = 0; i < ENGINE_AXES; i++)
        from.axis[i] = at[i];
    memcpy(j->start, at, sizeof j->start);
    memcpy(j->end, at, sizeof j->end);
    memcpy(j->head.start, at, sizeof j->head.start);
    if (j->head.kind == LOFT_POINTS)
        steps_of(from, j->steps_per_mm, j->head.start);
}

static int take_span(job *j, const engine_span *span, size_t kept)
{
    loft_item item = { .ticks = span->ticks };
    int32_t from[ENGINE_AXES];
    int status = LOFT_OK;

    if (j->count == 0)
        begin_job_at(j, span->p[0]);
    if (!j->begun) {
        add_events(j, j->plan.first, kept);
        find_levels(j, j->plan.first);
        j->begun = true;
    }
    memcpy(item.p, span->p[1], sizeof item.p);
    memcpy(from, j->end, sizeof from);
    memcpy(j->end, span->p[3], sizeof j->end);
    if (j->levels.left > 0 || levels_wait(&j->levels))
        add_levels(j, span, kept);
    else if (j->head.kind == LOFT_SPANS)
        add_timed(j, &item, kept);
    else if (j->head.kind == LOFT_POINTS)
        status = add_points(j, &item, from, kept);
    else
        j->ticks += span->ticks;
    j->spans++;
    pass_moves(j);
    return j->count >= LOFT_ITEMS_OPEN || j->ticks > UINT32_MAX ? LOFT_ERR_RANGE : status;
}

/* The plan up to an event is over. */
static void end_plan(job *j)
{
    j->judged = job_judged(j);
    certify_along_free(&j->along);
    joints_end(&j->plan);
}

static void complete_job(job *j)
{
    while (j->head.kind == LOFT_CURVES && j->timed < j->count)
        time_item(j, j->timed, j->ticks);
    j->whole = true;
    j->done  = j->all;
    end_plan(j);
}

/* Plan up to the next event. */
static int plan_on(job *j)
{
    const size_t first = j->stop;

    end_plan(j);
    j->begun         = false;
    j->stop          = next_stop(j, first);
    const int status = joints_plan(&j->plan, j->of, first, j->stop, j->e, &j->motors);
    if (status >= 0 && j->head.kind != LOFT_CURVES)
        joints_certify(&j->plan, &j->along, &j->motors);
    return status < 0 ? status : ENGINE_PLAN_BUSY;
}

/* Do one step. Returns enum engine_step or an error. */
static int step_plan(job *j, size_t kept)
{
    engine_span span;
    int state = joints_step(&j->plan, &span), status;

    if (j->plan.along != NULL && !j->plan.holds)
        return JOB_OUTSIDE;
    if (state == ENGINE_PLAN_SPAN && (status = take_span(j, &span, kept)) != LOFT_OK)
        state = status;
    if (state != ENGINE_PLAN_DONE)
        return state;
    if (j->stop == j->of->count) {
        add_events(j, j->stop, kept);
        complete_job(j);
        return state;
    }
    return plan_on(j);
}

bool job_waits(const job *j, size_t kept)
{
    return !j->whole && j->plan.plan != NULL &&
           (j->head.kind == LOFT_CURVES || j->count < kept + AHEAD);
}

int job_plan(job *j, size_t kept, double seconds)
{
    const double until = tool_clock() + seconds;
    int state = ENGINE_PLAN_BUSY;

    while (state >= 0 && job_waits(j, kept) && tool_clock() < until)
        state = step_plan(j, kept);
    return state < 0 ? state : LOFT_OK;
}

int job_finish(host *h, job *j)
{
    int status = LOFT_OK;

    while (status == LOFT_OK && !j->whole) {
        const host_progress p = { "planning", job_part(j), 1, false };
        status = host_goes_on(h, &p) ? job_plan(j, j->count, OPENING) : JOB_STOPPED;
    }
    host_has_done(h);
    return status;
}


// Beginning
// ---------

/* A job of curves has all its items, and nothing else is sent. In other jobs, the first items
 * reveal another planner of the same version. */
static uint32_t id_of(job *j, const joints *of, const job_options *o)
{
    if (o->kind == LOFT_CURVES)
        return loft_job_id(&j->head, (uint32_t)j->count, job_source, j);
    const uint32_t first = (uint32_t)(j->count < FIRST ? j->count : FIRST);
    const uint32_t crc   = job_input_crc(loft_job_id(&j->head, first, job_source, j), of, o);

    return crc ? crc : 1;
}

int job_open(job *j, joints *of, const job_options *o)
{
    *j = (job){ .tick_hz = o->limits.tick_hz,
                .head.kind = (uint8_t)o->kind,
                .k = of->k,
                .of = of,
                .e = o->e,
                .motors = o->limits,
                .patch = o->patch != NULL,
                .judged.connected = true,
                .does = o->does };
    if (of->count == 0)
        return LOFT_ERR_ARG;
    if (of->count >= LOFT_ITEMS_OPEN)
        return LOFT_ERR_RANGE;
    memcpy(j->steps_per_mm, o->steps_per_mm, sizeof j->steps_per_mm);
    j->ends = spool_grow(NULL, of->count * sizeof *j->ends);
    for (size_t n = 0; n < of->count; spool_passed(n++))
        j->all += seconds_of(&of->move[n]);
    if (o->kind == LOFT_CURVES) {
        const engine_limits planned = joints_limits(of, &o->limits);
        j->limits = job_curve_limits(&planned);
        j->head.limits = &j->limits;
        add_curves(j, of, o);
        time_item(j, 0, 0);
    }
    const double until = tool_clock() + OPENING;
    int status         = plan_on(j);
    while (status >= 0 && !j->whole &&
           (j->count < FIRST || (tool_clock() < until && job_waits(j, 0))))
        status = step_plan(j, 0);
    if (status < 0 || j->count == 0)
        return status < 0 ? status : LOFT_ERR_ARG;
    j->head.id = id_of(j, of, o);
    return LOFT_OK;
}

void job_free(job *j)
{
    joints_end(&j->plan);
    certify_along_free(&j->along);
    free(j->entry);
    free(j->pause);
    spool_free(j->ends);
    *j = (job){ 0 };
}

void job_work_free(job_work *w)
{
    job_free(&w->j);
    joints_free(&w->of);
    toolpath_free(&w->path);
}

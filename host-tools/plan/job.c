/* host-tools/plan/job.c -- plans a job while it is drawn
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "motion/span.h"    /* loft_span_walk */
#include "machine/step.h"   /* loft_steps_of */
#include "wire/action_code.h"   /* loft_action_item */
#include "wire/sender.h"    /* loft_job_id */

#include "plan/job.h"
#include "base/progress.h"       /* progress_show */
#include "base/spool.h"          /* spool_grow */
#include "base/tool.h"           /* tool_grow, tool_clock, tool_version */

#define FIRST   64          /* items that identify the plan */
#define AHEAD   65536       /* items planned ahead: more than any queue, so that frames are full */
#define OPENING 0.2         /* s for the first portion */
#define KNOWN   0.02        /* of the path: enough to estimate the duration of all of it */


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
    j->entry = tool_grow(j->entry, j->room * sizeof *j->entry);
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
        j->pause = tool_grow(j->pause, (j->pauses + 1) * sizeof *j->pause);
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

const char *job_pause(const job *j, size_t executed)
{
    for (size_t k = 0; k < j->pauses; k++)
        if (j->pause[k].item + 1 == executed)
            return j->pause[k].text;
    return NULL;
}


// Curves
// ------

/* A line takes fewer bytes if its inner points are exactly its thirds. Rounding has moved them by
 * at most one step from there. */
static void straighten_item(loft_item *item, const int32_t from[ENGINE_AXES])
{
    int32_t inner[2][ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++) {
        const int32_t third = (int32_t)lround(((double)item->p[2][i] - from[i]) / 3);
        inner[0][i] = from[i] + third;
        inner[1][i] = item->p[2][i] - third;
        for (int k = 0; k < 2; k++)
            if (abs(inner[k][i] - item->p[k][i]) > 1)
                return;
    }
    memcpy(item->p, inner, sizeof inner);
}

static loft_item curve_of(const engine_move *m, const int32_t from[ENGINE_AXES])
{
    loft_item item = { .ticks = (uint16_t)fmin(fmax(floor(m->feed * 60 + 1e-6), 1), 65535) };

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            item.p[k][i] = (int32_t)lround(m->p[k + 1][i] * 65536);
    straighten_item(&item, from);
    return item;
}

static loft_job_limits limits_of(const engine_limits *l)
{
    loft_job_limits out = { .corner = (int32_t)floor(l->corner * 65536),
                            .tol    = (int32_t)floor(l->tol * 65536) };

    for (int i = 0; i < ENGINE_AXES; i++) {
        out.axis[i].max_speed = (int32_t)lround(l->max_speed[i] * 65536);
        out.axis[i].max_accel = (int32_t)lround(l->max_accel[i] * 65536);
        out.axis[i].max_jerk  = (uint32_t)lround(l->max_jerk[i]);
    }
    return out;
}

static void add_curves(job *j, const joints *of, const job_options *o)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        j->head.start[i] = j->start[i] = j->end[i] = (int32_t)lround(of->move[0].p[0][i] * 65536);
    for (unsigned n = 0; o->patch != NULL && n < o->parts; n++)
        add_item(j, &o->patch[n], 0);
    for (size_t n = 0; o->patch == NULL && n < of->count; spool_passed(n++)) {
        const loft_item item = curve_of(&of->move[n], n > 0 ? j->last : j->head.start);
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

    memcpy(from.axis, at, sizeof from.axis);
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
    pass_moves(j);
    return j->count >= LOFT_ITEMS_OPEN || j->ticks > UINT32_MAX ? LOFT_ERR_RANGE : status;
}

static void complete_job(job *j)
{
    while (j->head.kind == LOFT_CURVES && j->timed < j->count)
        time_item(j, j->timed, j->ticks);
    j->whole = true;
    j->done  = j->all;
    joints_end(&j->plan);
}

/* Plan up to the next event. */
static int plan_on(job *j)
{
    const size_t first = j->stop;

    joints_end(&j->plan);
    j->begun         = false;
    j->stop          = next_stop(j, first);
    const int status = joints_plan(&j->plan, j->of, first, j->stop, j->e, &j->motors);
    return status < 0 ? status : ENGINE_PLAN_BUSY;
}

/* Do one step. Returns enum engine_step or an error. */
static int step_plan(job *j, size_t kept)
{
    engine_span span;
    int state = joints_step(&j->plan, &span), status;

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

int job_finish(job *j)
{
    int status = LOFT_OK;
    progress bar;

    progress_start(&bar, 1);
    while (status == LOFT_OK && !j->whole) {
        progress_show(&bar, job_part(j), "planning");
        status = job_plan(j, j->count, OPENING);
    }
    progress_clear(&bar);
    return status;
}

uint32_t job_items(const job *j)
{
    return j->whole || j->head.kind == LOFT_CURVES ? (uint32_t)j->count : LOFT_ITEMS_OPEN;
}


// Beginning
// ---------

static uint32_t crc_of(uint32_t crc, double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return loft_crc32(loft_crc32(crc, (uint32_t)bits), (uint32_t)(bits >> 32));
}

static uint32_t limits_crc(uint32_t crc, const engine_limits *l)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        crc = crc_of(crc_of(crc_of(crc, l->max_speed[i]), l->max_accel[i]), l->max_jerk[i]);
    return loft_crc32(crc_of(crc_of(crc_of(crc, l->corner), l->tol), l->exact), l->tick_hz);
}

static uint32_t events_crc(uint32_t crc, const toolpath *path, const struct job_does *does)
{
    for (size_t n = 0; n < path->events; n++) {
        const drawing_event *e = &path->event[n].e;
        crc = loft_crc32(loft_crc32(crc, (uint32_t)path->event[n].move),
                         (uint32_t)e->doing * 256 + (uint32_t)e->way * 2 + job_can(does, e));
        crc = crc_of(crc_of(crc_of(crc, e->amount), path->event[n].feed), e->along);
    }
    return path->events > 0 ? crc_of(crc_of(crc, does->s_max), does->spin_up) : crc;
}

/* All data that a plan depends on. */
static uint32_t input_crc(uint32_t crc, const joints *of, const job_options *o)
{
    const engine_limits limits = joints_limits(of, &o->limits);

    for (const char *at = tool_version; *at != '\0'; at++)
        crc = loft_crc32(crc, (uint32_t)*at);
    for (const char *at = o->e->name; *at != '\0'; at++)
        crc = loft_crc32(crc, (uint32_t)*at);
    crc = limits_crc(crc, &limits);
    for (int i = 0; i < ENGINE_AXES; i++)
        crc = loft_crc32(crc_of(crc, of->scale[i]),
                         o->kind == LOFT_POINTS ? (uint32_t)o->steps_per_mm[i] : 0);
    for (size_t n = 0; n < of->count; spool_passed(n++)) {
        crc = crc_of(crc, of->move[n].feed);
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < ENGINE_AXES; i++)
                crc = crc_of(crc, of->move[n].p[k][i]);
    }
    return events_crc(crc, of->path, &o->does);
}

/* A job of curves has all its items, and nothing else is sent. In other jobs, the first items
 * reveal another planner of the same version. */
static uint32_t id_of(job *j, const joints *of, const job_options *o)
{
    if (o->kind == LOFT_CURVES)
        return loft_job_id(&j->head, (uint32_t)j->count, job_source, j);
    const uint32_t first = (uint32_t)(j->count < FIRST ? j->count : FIRST);
    const uint32_t crc   = input_crc(loft_job_id(&j->head, first, job_source, j), of, o);

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
        j->limits = limits_of(&planned);
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
    free(j->entry);
    free(j->pause);
    spool_free(j->ends);
    *j = (job){ 0 };
}


// How far it is
// -------------

double job_part(const job *j) { return j->whole || !(j->all > 0) ? 1 : fmin(j->done / j->all, 1); }

double job_ticks(const job *j) { return (double)j->ticks / fmax(job_part(j), 1e-6); }

const char *job_of(const job *j, char text[32])
{
    const double part = job_part(j);

    if (j->whole || j->head.kind == LOFT_CURVES)
        snprintf(text, 32, " of %zu", j->count);
    else if (part >= KNOWN)
        snprintf(text, 32, " of about %.0f", ceil((double)j->count / part / 100) * 100);
    else
        text[0] = '\0';
    return text;
}

const char *job_words(const job *j)
{
    return j->head.kind == LOFT_POINTS ? "points"
           : j->patch                    ? "parts of a patch"
           : j->head.kind == LOFT_CURVES ? "curves"
                                         : "spans";
}

/* How many moves end at that item, or tick, or before: see `ends`. */
static size_t moves_to(const job *j, uint64_t at)
{
    size_t low = 0, high = j->passed;

    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (j->ends[middle] <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

size_t job_moves(const job *j, size_t executed)
{
    if (j->patch && executed < j->count)        /* they are executed at its end */
        return 0;
    if (j->whole && executed >= j->count)
        return j->of->path->count;
    const size_t move = j->head.kind == LOFT_CURVES ? executed : moves_to(j, executed);
    return move < j->of->count ? j->of->of[move] : j->of->path->count;
}

double job_seconds(const job *j) { return (double)j->ticks / (double)j->tick_hz; }

static const job_entry *entry_of(const job *j, size_t n) { return &j->entry[n - j->low]; }

size_t job_item_at(const job *j, uint64_t tick)
{
    size_t low = j->low, high = j->timed;       /* due[low] <= tick < due[high] */

    if (j->patch) {
        const size_t move = moves_to(j, tick);
        return move < j->of->count ? move : j->of->count - 1;
    }
    while (high > low + 1) {
        const size_t middle = low + (high - low) / 2;
        if (entry_of(j, middle)->due <= tick)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void tool_at(const job *j, const int32_t motors[ENGINE_AXES], double out[ENGINE_AXES])
{
    double at[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++)
        at[i] = motors[i] / 65536.0;
    if (!kinematics_tool(j->k, at, out))
        memcpy(out, at, sizeof at);
}

double job_feed(const job *j, size_t n)
{
    double from[ENGINE_AXES], to[ENGINE_AXES], sum = 0;

    if (j->patch)
        return j->of->move[n].feed;
    if (n < j->low || n >= j->timed || j->head.kind == LOFT_POINTS || (n > 0 && n == j->low))
        return 0;
    if (j->head.kind == LOFT_CURVES && j->k->kind == ENGINE_CARTESIAN)
        return entry_of(j, n)->item.ticks / 60.0;
    tool_at(j, n > 0 ? entry_of(j, n - 1)->item.p[2] : j->start, from);
    tool_at(j, entry_of(j, n)->item.p[2], to);
    for (int i = 0; i < ENGINE_AXES; i++)
        sum += (to[i] - from[i]) * (to[i] - from[i]);
    const uint64_t due  = entry_of(j, n)->due;
    const uint64_t next = n + 1 < j->timed ? entry_of(j, n + 1)->due : j->ticks;
    return next > due ? sqrt(sum) * (double)j->tick_hz / (double)(next - due) : 0;
}

/* host-tools/job.c -- a planned job
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "motion/span.h"    /* loft_span_walk */
#include "motion/step.h"    /* loft_steps_of */
#include "wire/sender.h"    /* loft_job_id */

#include "job.h"
#include "trace.h"          /* trace_make */
#include "tool.h"           /* tool_grow */

static void add(job *j, const loft_item *item)
{
    if (j->count == j->room) {
        j->room = j->room ? 2 * j->room : 256;
        j->item = tool_grow(j->item, j->room * sizeof *j->item);
        j->tick = tool_grow(j->tick, (j->room + 1) * sizeof *j->tick);
    }
    j->tick[0]            = 0;
    j->tick[j->count + 1] = j->tick[j->count] + item->ticks;
    j->item[j->count++]   = *item;
}

static void add_span(void *context, const engine_span *span)
{
    job *j = context;
    loft_item item = { .ticks = span->ticks };

    if (j->count == 0)
        memcpy(j->start, span->p[0], sizeof j->start);
    memcpy(item.p, span->p[1], sizeof item.p);
    memcpy(j->end, span->p[3], sizeof j->end);
    add(j, &item);
}

static int seal(job *j)
{
    if (j->count == 0)
        return LOFT_ERR_ARG;
    if (j->count > UINT32_MAX)
        return LOFT_ERR_RANGE;
    j->head.id = loft_job_id(&j->head, (uint32_t)j->count, job_source, j);
    return LOFT_OK;
}

int job_plan(job *j, const engine *e, const engine_limits *limits, const toolpath *path, const joints *of)
{
    (void)path;
    *j = (job){ .tick_hz = limits->tick_hz, .head.kind = LOFT_SPANS, .k = of->k };
    const int status = joints_plan(of, e, limits, add_span, j);
    if (status != LOFT_OK)
        return status;
    memcpy(j->head.start, j->start, sizeof j->head.start);
    return seal(j);
}

/* A line is said in fewer bytes if its inner points are the thirds of it exactly: rounding has moved them by no more than
 * one step from there. */
static void straighten(loft_item *item, const int32_t from[ENGINE_AXES])
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
    straighten(&item, from);
    return item;
}

static double length_of(const engine_move *m)
{
    double sum = 0;

    for (int i = 0; i < ENGINE_AXES; i++)
        sum += (m->p[3][i] - m->p[0][i]) * (m->p[3][i] - m->p[0][i]);
    return sqrt(sum);
}

static loft_job_limits limits_of(const engine_limits *l)
{
    loft_job_limits out = { .corner = (int32_t)lround(l->corner * 65536), .tol = (int32_t)floor(l->tol * 65536) };

    for (int i = 0; i < ENGINE_AXES; i++) {
        out.axis[i].max_speed = (int32_t)lround(l->max_speed[i] * 65536);
        out.axis[i].max_accel = (int32_t)lround(l->max_accel[i] * 65536);
        out.axis[i].max_jerk  = (uint32_t)lround(l->max_jerk[i]);
    }
    return out;
}

/* Pieces of one move of the tool are taken to last as long as they are. */
static double seconds_of(const trace *t, const joints *of, size_t n)
{
    double all = 0, own = 0;

    for (size_t k = n; k > 0 && of->of[k - 1] == of->of[n]; k--)
        all += length_of(&of->move[k - 1]);
    for (size_t k = n; k < of->count && of->of[k] == of->of[n]; k++)
        all += length_of(&of->move[k]);
    own = length_of(&of->move[n]);
    return all > 0 ? t->part[of->of[n]].seconds * own / all : 0;
}

int job_curves(job *j, const engine *e, const engine_limits *limits, const toolpath *path, const joints *of)
{
    const engine_limits planned = joints_limits(of, limits);
    double due = 0;
    trace t;

    *j = (job){ .tick_hz = limits->tick_hz, .head.kind = LOFT_CURVES, .limits = limits_of(&planned), .k = of->k };
    j->head.limits = &j->limits;
    if (of->count == 0)
        return LOFT_ERR_ARG;
    const int status = trace_make(&t, e, limits, path, of);
    for (int i = 0; i < ENGINE_AXES; i++)
        j->end[i] = j->start[i] = j->head.start[i] = (int32_t)lround(of->move[0].p[0][i] * 65536);
    for (size_t k = 0; k < of->count && status == LOFT_OK; k++) {
        const loft_item item = curve_of(&of->move[k], j->end);
        add(j, &item);
        due += seconds_of(&t, of, k);
        j->tick[j->count] = (uint64_t)lround(due * j->tick_hz);
        memcpy(j->end, item.p[2], sizeof j->end);
    }
    trace_free(&t);
    return status == LOFT_OK ? seal(j) : status;
}

const char *job_words(const job *j)
{
    return j->head.kind == LOFT_POINTS ? "points" : j->head.kind == LOFT_CURVES ? "curves" : "spans";
}

void job_free(job *j)
{
    free(j->item);
    free(j->tick);
    *j = (job){ 0 };
}

static void steps_of(loft_vec at, const int32_t steps_per_mm[ENGINE_AXES], int32_t out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = loft_steps_of(at.axis[i], steps_per_mm[i]);
}

/* Walk the spans as a machine does; this file is compiled in q16, so a loft_real is a raw coordinate. */
int job_points(job *j, const int32_t steps_per_mm[ENGINE_AXES])
{
    job points = { .tick_hz = j->tick_hz, .head.kind = LOFT_POINTS, .k = j->k };
    const int32_t *from = j->start;
    loft_vec at;

    memcpy(points.start, j->start, sizeof points.start);
    memcpy(points.end, j->end, sizeof points.end);
    memcpy(at.axis, j->start, sizeof at.axis);
    steps_of(at, steps_per_mm, points.head.start);
    for (size_t n = 0; n < j->count; n++) {
        loft_span span;
        loft_forward w;
        loft_item_span(&j->item[n], from, &span);
        const int status = loft_span_walk(&w, &span);
        if (status != LOFT_OK) {
            job_free(&points);
            return status;
        }
        while (loft_forward_next(&w, &at)) {
            loft_item item = { .ticks = 1 };
            steps_of(at, steps_per_mm, item.p[2]);
            add(&points, &item);
        }
        from = j->item[n].p[2];
    }
    job_free(j);
    *j = points;
    return seal(j);
}

void job_source(void *context, uint32_t index, loft_item *out)
{
    const job *j = context;

    *out = j->item[index];
}

size_t job_item_at(const job *j, uint64_t tick)
{
    size_t low = 0, high = j->count;        /* tick[low] <= tick < tick[high] */

    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (j->tick[middle] <= tick)
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

    if (n >= j->count || j->head.kind == LOFT_POINTS)
        return 0;
    if (j->head.kind == LOFT_CURVES && j->k->kind == ENGINE_CARTESIAN)
        return j->item[n].ticks / 60.0;
    tool_at(j, n > 0 ? j->item[n - 1].p[2] : j->start, from);
    tool_at(j, j->item[n].p[2], to);
    for (int i = 0; i < ENGINE_AXES; i++)
        sum += (to[i] - from[i]) * (to[i] - from[i]);
    return j->tick[n + 1] > j->tick[n] ? sqrt(sum) * (double)j->tick_hz / (double)(j->tick[n + 1] - j->tick[n]) : 0;
}

double job_seconds(const job *j)
{
    return j->count ? (double)j->tick[j->count] / (double)j->tick_hz : 0;
}

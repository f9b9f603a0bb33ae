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

int job_plan(job *j, const engine *e, const engine_limits *limits, const engine_move moves[], size_t count)
{
    *j = (job){ .tick_hz = limits->tick_hz, .head.kind = LOFT_SPANS };
    const int status = e->plan(limits, moves, count, add_span, j);
    if (status != LOFT_OK)
        return status;
    memcpy(j->head.start, j->start, sizeof j->head.start);
    return seal(j);
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
    job points = { .tick_hz = j->tick_hz, .head.kind = LOFT_POINTS };
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

double job_feed(const job *j, size_t n)
{
    double sum = 0;

    if (n >= j->count || j->head.kind != LOFT_SPANS)
        return 0;
    const int32_t *from = n > 0 ? j->item[n - 1].p[2] : j->start;
    for (int i = 0; i < ENGINE_AXES; i++) {
        const double by = ((double)j->item[n].p[2][i] - (double)from[i]) / 65536.0;
        sum += by * by;
    }
    return sqrt(sum) * (double)j->tick_hz / (double)j->item[n].ticks;
}

double job_seconds(const job *j)
{
    return j->count ? (double)j->tick[j->count] / (double)j->tick_hz : 0;
}

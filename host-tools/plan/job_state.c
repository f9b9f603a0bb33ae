/* host-tools/plan/job_state.c -- how far a job is: what it has in all, what is due, what is over
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/source.h"         /* source_name */
#include "base/host.h"
#include "plan/job.h"

#define KNOWN   0.02        /* of the path: enough to estimate the duration of all of it */

uint32_t job_items(const job *j)
{
    return j->whole || j->head.kind == LOFT_CURVES ? (uint32_t)j->count : LOFT_ITEMS_OPEN;
}

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

size_t job_ready(job *j)
{
    const size_t sure = j->spans - j->along.spans + j->along.sure;

    if (j->whole || j->plan.along == NULL)
        return j->count;
    if (j->ready < j->low)
        j->ready = j->low;
    while (j->ready < j->count && j->entry[j->ready - j->low].span < sure)
        j->ready++;
    return j->ready;
}

certify job_judged(const job *j)
{
    certify sum = j->judged;

    if (j->along.spans > 0)
        certify_fold(&sum, &j->along.judged);
    return sum;
}

double job_distance(const job *j, double tol, double *of)
{
    const certify c   = job_judged(j);
    const bool missed = c.missed.worst * c.off.tol > c.off.worst * c.missed.tol;
    const certify_worst *w = missed ? &c.missed : &c.off;
    const double used = tol - joints_limits(j->of, &j->motors).tol / j->of->least;

    *of = w->tol / j->of->least + used;
    return w->worst / j->of->least + used;
}

static double worst_of(const certify_worst w[ENGINE_AXES])
{
    return fmax(fmax(w[0].worst, w[1].worst), w[2].worst);
}

const char *job_words_of_plan(const job *j, double tol, char text[160])
{
    const certify c = job_judged(j);
    double of;
    const double is = job_distance(j, tol, &of);

    if (j->head.kind == LOFT_CURVES)
        snprintf(text, 160, "path within %.4f mm", tol);
    else
        snprintf(text, 160,
                 "path within %.4f of %.4f mm, %.0f %% of speed, %.0f %% of acceleration, %.0f %% "
                 "of jerk",
                 is, of, 100 * worst_of(c.speed), 100 * worst_of(c.accel), 100 * worst_of(c.jerk));
    return text;
}

/* Which limit is exceeded, if one is. */
static bool exceeds(const certify_worst w[ENGINE_AXES], double bound, const char *what,
                    const char *axes, char text[200])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        if (!(w[i].worst <= bound)) {
            snprintf(text, 200, "%s of %c is %.4g times its limit: give less --feed or --accel",
                     what, axes[i], w[i].worst);
            return true;
        }
    return false;
}

int job_refuse(host *h, const job *j, const char *file, int status, const char *then)
{
    const certify c  = job_judged(j);
    const char *axes = kinematics_axes(j->k);
    char text[200];

    if (status == JOB_STOPPED)
        return EX_TEMPFAIL;
    if (status != JOB_OUTSIDE)
        return host_error(h, EX_DATAERR, "plan.failed", (host_place){ source_name(file), 0 }, NULL,
                          "cannot be planned: %s%s", engine_status(status, ENGINE_NO_MOTION), then);
    if (!c.connected)
        snprintf(text, sizeof text, "it has a gap: plan with another --num");
    else if (!exceeds(c.speed, CERTIFY_SPEED, "speed", axes, text) &&
             !exceeds(c.accel, CERTIFY_ACCEL, "acceleration", axes, text) &&
             !exceeds(c.jerk, CERTIFY_JERK, "jerk", axes, text)) {
        double of;
        const double is = job_distance(j, j->motors.tol, &of);
        snprintf(text, sizeof text,
                 "it leaves the drawing by %.6f of %.6f mm at most: give less --feed, or --tol "
                 "%.2g",
                 is, of, 1.5 * is);
    }
    return host_error(h, EX_SOFTWARE, "plan.not-within", (host_place){ source_name(file), 0 },
                      HOST_REMEDY("%s; please report this%s", text, then),
                      "the plan is not within its bounds");
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
    if (j->head.kind == LOFT_CURVES && j->k->kind->direct)
        return entry_of(j, n)->item.ticks / 60.0;
    tool_at(j, n > 0 ? entry_of(j, n - 1)->item.p[2] : j->start, from);
    tool_at(j, entry_of(j, n)->item.p[2], to);
    for (int i = 0; i < ENGINE_AXES; i++)
        sum += (to[i] - from[i]) * (to[i] - from[i]);
    const uint64_t due  = entry_of(j, n)->due;
    const uint64_t next = n + 1 < j->timed ? entry_of(j, n + 1)->due : j->ticks;
    return next > due ? sqrt(sum) * (double)j->tick_hz / (double)(next - due) : 0;
}

const char *job_pause(const job *j, size_t executed)
{
    for (size_t k = 0; k < j->pauses; k++)
        if (j->pause[k].item + 1 == executed)
            return j->pause[k].text;
    return NULL;
}

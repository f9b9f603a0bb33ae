/* host-tools/library/plan.c -- plans of a drawing
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "wire/action_code.h"   /* LOFT_OUTPUTS_MOST */

#include "base/memory.h"
#include "library/inside.h"
#include "plan/parts.h"         /* parts_plan */

static double given(double value, double usual) { return value < 0 || value > 0 ? value : usual; }

int host_planning(loft_host *h, planning *p, const loft_host_plan_options *o)
{
    const int code = planning_usual(&h->h, p, o != NULL ? o->machine : NULL);

    if (code != 0 || o == NULL)
        return code;
    p->feed      = given(o->feed, p->feed);
    p->travel    = given(o->travel, p->travel);
    p->accel     = given(o->accel, p->accel);
    p->tol       = given(o->tol, p->tol);
    p->corner    = given(o->corner, p->corner);
    p->lift      = given(o->lift, p->lift);
    p->jerk      = o->jerk < 0 ? 0 : given(o->jerk, p->jerk);
    p->park      = o->park;
    p->order.how = o->order != NULL ? o->order : p->order.how;
    return 0;
}

/* A drawing, prepared for planning with its options, and the job that is planned of it. */
typedef struct {
    planning p;
    drawing smooth;
    plan_parts parts;
    job_work w;
} plan_work;

/* Where the motors are when a planned job is over. */
static void end_of(const job *j, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = j->last[i] / 65536.0;
}

/* Plan the part of a tool, and add it. */
static int plan_part(loft_host *h, plan_work *k, size_t n, double start[ENGINE_AXES],
                     const job_options *as, loft_host_plan_facts *out)
{
    const machine_tool *tool = k->parts.part[n].tool;
    int code = parts_plan(&h->h, &k->p, &k->parts, n, k->p.file, start, false, as, &k->w);

    if (code == 0) {
        const int status = job_finish(&h->h, &k->w.j);
        code = status == LOFT_OK ? 0 : job_refuse(&h->h, &k->w.j, k->parts.file, status, "");
    }
    if (code == 0) {
        end_of(&k->w.j, start);
        out->seconds   += job_seconds(&k->w.j) + (tool != NULL ? tool->delay : 0);
        out->drawn     += k->w.path.drawn;
        out->travelled += k->w.path.travelled;
        out->curves    += k->w.path.curves;
        out->items     += k->w.j.count;
        out->job        = k->w.j.head.id;
    }
    job_work_free(&k->w);
    return code;
}

int loft_host_plan(loft_host *h, loft_host_drawing *d, const loft_host_plan_options *o,
                   loft_host_plan_facts *out)
{
    double start[ENGINE_AXES] = { 0, 0, 0 };
    plan_work *k              = memory_grow(NULL, sizeof *k);
    job_options as = { .does = { .actions = true, .outputs = LOFT_OUTPUTS_MOST } };

    memset(k, 0, sizeof *k);
    *out        = (loft_host_plan_facts){ .seconds = 0 };
    int code    = host_planning(h, &k->p, o);
    k->p.levels = true;
    if (code == 0)
        code = planning_smooth(&h->h, &k->p, &d->d, &k->smooth, d->file);
    if (code == 0)
        code = parts_find(&h->h, &k->p, d->file, &d->d, &k->smooth, &k->parts);
    planning_machine(&k->p, &as.limits);
    planning_limit(&k->p, &as.limits);
    as.e            = k->p.e;
    as.kind         = LOFT_SPANS;
    as.does.s_max   = k->p.machine.s_max;
    as.does.spin_up = k->p.machine.spin_up;
    for (int i = 0; i < ENGINE_AXES; i++)
        as.steps_per_mm[i] = (int32_t)lround(k->p.machine.steps_per_mm[i] * 65536);
    for (size_t n = 0; n < k->parts.count && code == 0; n++)
        code = plan_part(h, k, n, start, &as, out);
    drawing_free(&k->smooth);
    free(k);
    return code;
}

/* host-tools/library/plan.c -- plans of a drawing
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "wire/action_code.h"   /* LOFT_OUTPUTS_MOST */

#include "base/source.h"        /* source_name */
#include "library/inside.h"

static double given(double value, double usual) { return value < 0 || value > 0 ? value : usual; }

int host_plan_start(loft_host *h, host_plan *k, loft_host_drawing *d,
                    const loft_host_plan_options *o)
{
    *k = (host_plan){ .file = d->file };
    int code = planning_usual(&h->h, &k->p, o != NULL ? o->machine : NULL);

    if (o != NULL) {
        k->p.feed   = given(o->feed, k->p.feed);
        k->p.travel = given(o->travel, k->p.travel);
        k->p.accel  = given(o->accel, k->p.accel);
        k->p.tol    = given(o->tol, k->p.tol);
        k->p.corner = given(o->corner, k->p.corner);
        k->p.lift   = given(o->lift, k->p.lift);
        k->p.jerk   = o->jerk < 0 ? 0 : given(o->jerk, k->p.jerk);
        k->p.park   = o->park;
    }
    if (code == 0 && k->p.machine.tools.count > 0)
        code = host_error(&h->h, EX_CONFIG, "host.tools", (host_place){ k->p.file, 0 },
                          "give a machine without tools, and a drawing for each of them",
                          "has tools, which nobody changes here");
    k->p.levels = k->p.machine.laser > 0;
    return code == 0 ? planning_smooth(&h->h, &k->p, &d->d, &k->smooth, d->file) : code;
}

void host_plan_free(host_plan *k)
{
    job_work_free(&k->w);
    drawing_free(&k->smooth);
}

int host_plan_job(loft_host *h, host_plan *k, const double start[ENGINE_AXES], job_options *as)
{
    const host_place at  = { source_name(k->file), 0 };
    toolpath_options how = planning_path(&k->p);

    as->e    = k->p.e;
    as->kind = LOFT_SPANS;
    planning_limit(&k->p, &as->limits);
    if (!planning_start_at(&k->p, start, &how))
        return host_error(&h->h, EX_DATAERR, "host.motors", at, "give the file of the machine",
                          "its motors are at %.6g %.6g %.6g, where those of a %s machine like this "
                          "cannot be",
                          start[0], start[1], start[2], kinematics_name(&k->p.machine.k));
    toolpath_make(&k->w.path, &k->smooth, &how);
    if (k->w.path.count == 0)
        return host_error(&h->h, EX_DATAERR, "host.nothing", at,
                          "give a drawing with visible outlines", "nothing to draw in it");
    const int code = planning_joints(&h->h, &k->p, k->file, &k->smooth, start, false, &as->limits,
                                     &k->w.path, &k->w.of);
    if (code != 0)
        return code;
    const int status = job_open(&k->w.j, &k->w.of, as);
    return status == LOFT_OK ? 0 : job_refuse(&h->h, &k->w.j, k->file, status, "");
}

int loft_host_plan(loft_host *h, loft_host_drawing *d, const loft_host_plan_options *o,
                   loft_host_plan_facts *out)
{
    const double start[ENGINE_AXES] = { 0, 0, 0 };
    job_options as = { .does = { .actions = true, .outputs = LOFT_OUTPUTS_MOST } };
    host_plan k;

    int code = host_plan_start(h, &k, d, o);
    planning_machine(&k.p, &as.limits);
    for (int i = 0; i < ENGINE_AXES; i++)
        as.steps_per_mm[i] = (int32_t)lround(k.p.machine.steps_per_mm[i] * 65536);
    as.does.s_max   = k.p.machine.s_max;
    as.does.spin_up = k.p.machine.spin_up;
    if (code == 0)
        code = host_plan_job(h, &k, start, &as);
    if (code == 0) {
        const int status = job_finish(&h->h, &k.w.j);
        code = status == LOFT_OK ? 0 : job_refuse(&h->h, &k.w.j, k.file, status, "");
    }
    if (code == 0)
        *out = (loft_host_plan_facts){ .seconds   = job_seconds(&k.w.j),
                                       .drawn     = k.w.path.drawn,
                                       .travelled = k.w.path.travelled,
                                       .curves    = k.w.path.curves,
                                       .items     = k.w.j.count,
                                       .job       = k.w.j.head.id };
    host_plan_free(&k);
    return code;
}

/* host-tools/plan/parts.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "base/source.h"        /* source_name */
#include "plan/parts.h"

int parts_find(host *h, const planning *p, const char *file, const drawing *d,
               const drawing *smooth, plan_parts *all)
{
    all->file  = file;
    all->count = tools_split(&p->machine.tools, d, smooth, all->part);
    all->first = 0;
    if (all->count > 0)
        return 0;
    return host_error(h, EX_DATAERR, "plan.tools", (host_place){ source_name(file), 0 },
                      "split the program", "more than %u changes of the tool", TOOLS_PARTS);
}

toolpath_options parts_way(const planning *p, const plan_parts *all, size_t k)
{
    toolpath_options how = planning_path(p);
    const bool last      = k + 1 == all->count;

    how.lift = tools_lift(all->part[k].tool, p->lift);
    if (all->part[k].d.program && k > 0)
        tools_counted(&all->part[k].d, how.counted);
    if (last || all->part[k].d.program)
        return how;
    how.park    = *all->part[k + 1].tool->pause != '\0';
    how.zero[0] = p->machine.park[0];
    how.zero[1] = p->machine.park[1];
    how.zero[2] = NAN;
    return how;
}

int parts_plan(host *h, const planning *p, const plan_parts *all, size_t k, const char *port,
               const double start[ENGINE_AXES], bool chip, const job_options *as, job_work *w)
{
    toolpath_options how = parts_way(p, all, k);
    const drawing *d     = &all->part[k].smooth;

    if (!planning_start_at(p, start, &how))
        return host_error(h, EX_DATAERR, "plan.motors", (host_place){ port, 0 },
                          "give its --machine FILE",
                          "its motors are at %.6g %.6g %.6g, where those of a %s machine like this "
                          "cannot be",
                          start[0], start[1], start[2], kinematics_name(&p->machine.k));
    toolpath_make(&w->path, d, &how);
    if (w->path.count == 0)
        return host_error(h, EX_DATAERR, "plan.nothing", (host_place){ source_name(all->file), 0 },
                          "give a drawing with visible outlines", "nothing to draw in it");
    const int code   = planning_joints(h, p, all->file, d, start, chip, &as->limits, &w->path,
                                     &w->of);
    const int status = code == 0 ? job_open(&w->j, &w->of, as) : LOFT_OK;
    return status == LOFT_OK ? code : job_refuse(h, &w->j, all->file, status, "");
}

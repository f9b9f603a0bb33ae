/* host-tools/plan/job_curve.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plan/job_curve.h"

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

loft_item job_curve(const engine_move *m, const int32_t from[ENGINE_AXES])
{
    loft_item item = { .ticks = (uint16_t)fmin(fmax(floor(m->feed * 60 + 1e-6), 1), 65535) };

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            item.p[k][i] = (int32_t)lround(m->p[k + 1][i] * 65536);
    straighten_item(&item, from);
    return item;
}

loft_job_limits job_curve_limits(const engine_limits *l)
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

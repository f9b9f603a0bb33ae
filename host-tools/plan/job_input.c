/* host-tools/plan/job_input.c
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "wire/frame.h"          /* loft_crc32 */

#include "base/spool.h"          /* spool_passed */
#include "base/tool.h"            /* tool_version */
#include "plan/job_input.h"

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

uint32_t job_input_crc(uint32_t crc, const joints *of, const job_options *o)
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

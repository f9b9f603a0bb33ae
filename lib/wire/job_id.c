/* lib/wire/job_id.c
 * SPDX-License-Identifier: MIT
 */
#include "wire/job_id.h"

static uint32_t limits_crc(uint32_t crc, const loft_job_limits *m)
{
    crc = loft_crc32(loft_crc32(crc, (uint32_t)m->corner), (uint32_t)m->tol);
    for (int i = 0; i < LOFT_AXES; i++) {
        crc = loft_crc32(crc, (uint32_t)m->axis[i].max_speed);
        crc = loft_crc32(crc, (uint32_t)m->axis[i].max_accel);
        crc = loft_crc32(crc, m->axis[i].max_jerk);
    }
    return crc;
}

uint32_t loft_job_id(const loft_job *job, uint32_t count, loft_item_source *source, void *context)
{
    uint32_t crc = loft_crc32(loft_crc32(0xFFFFFFFFu, job->kind), count);
    loft_item item;

    for (int i = 0; i < LOFT_AXES; i++)
        crc = loft_crc32(crc, (uint32_t)job->start[i]);
    if (job->kind == LOFT_CURVES)
        crc = limits_crc(crc, job->limits);
    for (uint32_t n = 0; n < count; n++) {
        source(context, n, &item);
        crc = loft_crc32(crc, item.ticks);
        for (int k = job->kind == LOFT_POINTS ? 2 : 0; k < 3; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                crc = loft_crc32(crc, (uint32_t)item.p[k][i]);
    }
    crc ^= 0xFFFFFFFFu;
    return crc ? crc : 1;
}

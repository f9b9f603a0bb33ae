/* lib/path/limits.c
 * SPDX-License-Identifier: MIT
 */
#include "path/limits.h"

#define TOL_MIN      LOFT_REAL(0.0009765625)
#define TOL_MAX      LOFT_REAL(1)
#define EXACT_MAX    LOFT_REAL(2)

static enum loft_status within(loft_real x, loft_real min, loft_real max)
{
    return !(x > 0) ? LOFT_ERR_ARG : x < min || x > max ? LOFT_ERR_RANGE : LOFT_OK;
}

enum loft_status loft_limits_check(const loft_limits *limits)
{
    enum loft_status status = within(limits->tol, TOL_MIN, TOL_MAX);

    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        status = within(limits->max_speed[i], LOFT_SPEED_MIN, LOFT_SPEED_MAX);
        if (status == LOFT_OK)
            status = within(limits->max_accel[i], LOFT_ACCEL_MIN, LOFT_ACCEL_MAX);
        if (status == LOFT_OK && limits->max_jerk[i] > LOFT_JERK_MAX)
            status = LOFT_ERR_RANGE;
    }
    if (status != LOFT_OK)
        return status;
    if (!(limits->corner >= 0) || !(limits->exact >= 0) || limits->tick_hz == 0)
        return LOFT_ERR_ARG;
    return limits->corner > TOL_MAX || limits->exact > EXACT_MAX || limits->tick_hz < 50 ||
                   limits->tick_hz > 50000u
               ? LOFT_ERR_RANGE
               : LOFT_OK;
}

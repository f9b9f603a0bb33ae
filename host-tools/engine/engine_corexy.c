/* host-tools/engine/engine_corexy.c -- kinematics of CoreXY and H-bot: motors at x + y and x - y
 * SPDX-License-Identifier: MIT
 *
 * Compiled once per number type.
 */
#include "kinematics/kinematics.h"  /* loft_corexy_motors */

#include "engine/engine_num.h"      /* vec_of, point_of */
#include "engine/machine_kinematics.h"

static void corexy_motors(const kinematics *k, const double at[ENGINE_AXES],
                          const double near[ENGINE_AXES], double out[ENGINE_AXES])
{
    loft_vec v;

    (void)k;
    (void)near;
    if (vec_of(at, &v))
        point_of(loft_corexy_motors(NULL, v), out);
}

static bool corexy_tool(const kinematics *k, const double motors[ENGINE_AXES],
                        double at[ENGINE_AXES])
{
    loft_vec v;

    (void)k;
    if (!vec_of(motors, &v) || !loft_corexy_tool(NULL, v, &v))
        return false;
    point_of(v, at);
    return true;
}

static void corexy_slope(const kinematics *k, const double at[ENGINE_AXES],
                         const double v[ENGINE_AXES], double out[ENGINE_AXES])
{
    (void)k;
    (void)at;
    out[0] = v[0] + v[1];
    out[1] = v[0] - v[1];
}

static void corexy_move(const kinematics *k, const double at[ENGINE_AXES],
                        const kinematics_moving *m, kinematics_moving *t)
{
    (void)k;
    (void)at;
    for (int i = 0; i < 2; i++) {
        t->v[i] = (m->v[0] + (i ? -1 : 1) * m->v[1]) / 2;
        t->a[i] = (m->a[0] + (i ? -1 : 1) * m->a[1]) / 2;
    }
}

/* Distances of the motors are sqrt(2) times those of the tool, so z is scaled alike. */
static void corexy_scale(const kinematics *k, double farthest, double scale[ENGINE_AXES])
{
    (void)k;
    (void)farthest;
    scale[2] = sqrt(2);
}

#define COREXY(word)                                                                               \
    { .name = (word), .axes = "abc", .linear = true, .paired = true, .lifts = true,                \
      .motors = corexy_motors, .tool = corexy_tool, .slope = corexy_slope, .move = corexy_move,    \
      .scale = corexy_scale }

const kinematics_kind ENGINE_OF(kinematics_corexy) = COREXY("corexy");
const kinematics_kind ENGINE_OF(kinematics_hbot)   = COREXY("hbot");

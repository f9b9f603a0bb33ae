/* host-tools/engine/engine_kinematics.c -- lib/kinematics/kinematics.h of one number type behind
 * the double interface of engine.h
 * SPDX-License-Identifier: MIT
 *
 * Compiled three times.
 */
#include <string.h>

#include "kinematics/kinematics.h"  /* loft_motors_of, loft_tool_of */

#include "engine/engine_num.h"         /* real_of, vec_of, point_of */

/* The geometry as the library takes it. */
typedef union {
    loft_polar polar;
    loft_delta delta;
} shape;

static bool shape_of(enum engine_kinematics kind, const double geometry[ENGINE_GEOMETRY],
                     shape *out)
{
    bool good = true;

    memset(out, 0, sizeof *out);
    if (kind == ENGINE_POLAR)
        return real_of(geometry[0], &out->polar.turn);
    if (kind == ENGINE_DELTA)
        for (int i = 0; i < 6; i++)
            good = good && real_of(geometry[1 + i], &out->delta.tower[i / 2][i % 2]);
    return good && (kind != ENGINE_DELTA || real_of(geometry[0], &out->delta.arm));
}

static bool to_motors(enum engine_kinematics kind, const double geometry[ENGINE_GEOMETRY],
                      const double tool[ENGINE_AXES], double out[ENGINE_AXES])
{
    static loft_motors_of *const maps[] = { [ENGINE_COREXY] = loft_corexy_motors,
                                            [ENGINE_POLAR] = loft_polar_motors,
                                            [ENGINE_DELTA] = loft_delta_motors };
    loft_vec at;
    shape s;

    if (!vec_of(tool, &at) || !shape_of(kind, geometry, &s))
        return false;
    point_of(maps[kind] ? maps[kind](&s, at) : at, out);
    return true;
}

static bool to_tool(enum engine_kinematics kind, const double geometry[ENGINE_GEOMETRY],
                    const double motors[ENGINE_AXES], double out[ENGINE_AXES])
{
    static loft_tool_of *const maps[] = { [ENGINE_COREXY] = loft_corexy_tool,
                                          [ENGINE_POLAR] = loft_polar_tool,
                                          [ENGINE_DELTA] = loft_delta_tool };
    loft_vec at;
    shape s;

    if (!vec_of(motors, &at) || !shape_of(kind, geometry, &s) ||
        (maps[kind] && !maps[kind](&s, at, &at)))
        return false;
    point_of(at, out);
    return true;
}

const engine_maps ENGINE_OF(engine_maps) = { .motors = to_motors, .tool = to_tool };

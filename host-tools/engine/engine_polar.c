/* host-tools/engine/engine_polar.c -- kinematics of polar machines: a radius and an angle
 * SPDX-License-Identifier: MIT
 *
 * Compiled once per number type.
 */
#include <stdio.h>

#include "kinematics/kinematics.h"  /* loft_polar */

#include "engine/engine_num.h"      /* real_of, vec_of, point_of */
#include "engine/machine_kinematics.h"

#define POLE 1e-6           /* mm: closer than this is the pole */

static void polar_prepare(kinematics *k) { k->geometry[0] = k->turn; }

static bool polar_beyond(const kinematics *k, const double at[ENGINE_AXES], char why[160])
{
    const double out = hypot(at[0], at[1]);

    return out < k->inside &&
           snprintf(why, 160,
                    "%.3g mm from the pole, where the angle would have to turn too fast: keep "
                    "%g mm away, or lower `inside`",
                    out, k->inside) > 0;
}

static void polar_motors(const kinematics *k, const double at[ENGINE_AXES],
                         const double near[ENGINE_AXES], double out[ENGINE_AXES])
{
    loft_polar polar;
    loft_vec v;

    if (vec_of(at, &v) && real_of(k->geometry[0], &polar.turn))
        point_of(loft_polar_motors(&polar, v), out);
    out[1] = hypot(at[0], at[1]) < POLE ? near[1]
                                        : out[1] + k->turn * round((near[1] - out[1]) / k->turn);
}

static bool polar_tool(const kinematics *k, const double motors[ENGINE_AXES],
                       double at[ENGINE_AXES])
{
    loft_polar polar;
    loft_vec v;

    if (!vec_of(motors, &v) || !real_of(k->geometry[0], &polar.turn) ||
        !loft_polar_tool(&polar, v, &v))
        return false;
    point_of(v, at);
    return true;
}

/* v along and across the radius. */
static void polar_slope(const kinematics *k, const double at[ENGINE_AXES],
                        const double v[ENGINE_AXES], double out[ENGINE_AXES])
{
    const double r2 = at[0] * at[0] + at[1] * at[1];

    out[0] = (at[0] * v[0] + at[1] * v[1]) / sqrt(r2);
    out[1] = (at[0] * v[1] - at[1] * v[0]) / r2 * k->turn / (2 * KINEMATICS_PI);
}

static void polar_move(const kinematics *k, const double at[ENGINE_AXES],
                       const kinematics_moving *m, kinematics_moving *t)
{
    const double per = 2 * KINEMATICS_PI / k->turn, r = m->x[0], angle = m->x[1] * per,
                 c = cos(angle), s = sin(angle);
    const double w = m->v[1] * per, dw = m->a[1] * per, along = m->a[0] - r * w * w,
                 across = r * dw + 2 * m->v[0] * w;

    (void)at;
    t->v[0] = c * m->v[0] - s * r * w;
    t->v[1] = s * m->v[0] + c * r * w;
    t->a[0] = c * along - s * across;
    t->a[1] = s * along + c * across;
}

/* An angle counts as its arc where the path is farthest out; if the unit of the angle is longer,
 * the other motors are scaled up to it. */
static void polar_scale(const kinematics *k, double farthest, double scale[ENGINE_AXES])
{
    const double arc = farthest * 2 * KINEMATICS_PI / k->turn,
                 unit = arc < 1 && arc > 0 ? 1 / arc : 1;

    scale[0] = scale[2] = unit;
    scale[1] = unit * arc > 1 ? unit * arc : 1;
}

static size_t polar_text(const kinematics *k, char *out, size_t size)
{
    return (size_t)snprintf(out, size, "# turn = %.17g\n# inside = %.17g\n", k->turn, k->inside);
}

const kinematics_kind ENGINE_OF(kinematics_polar) = { .name    = "polar",
                                                      .axes    = "abc",
                                                      .lifts   = true,
                                                      .pole    = true,
                                                      .prepare = polar_prepare,
                                                      .beyond  = polar_beyond,
                                                      .motors  = polar_motors,
                                                      .tool    = polar_tool,
                                                      .slope   = polar_slope,
                                                      .move    = polar_move,
                                                      .scale   = polar_scale,
                                                      .text    = polar_text };

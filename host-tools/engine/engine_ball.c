/* host-tools/engine/engine_ball.c -- a sphere as the nets of eight octants; compiled once per
 * number type
 * SPDX-License-Identifier: MIT
 *
 * A quarter of a circle has the points (1, 0), (1, 1), (0, 1) with the weights 1, 1, 2: the point
 * at t is (1 - t^2, 2 t) / (1 + t^2), without an error. An octant is the product of two: exact,
 * with a pole.
 */
#include "engine/engine_num.h"      /* real_of, double_of */
#include "engine/engine_sheet.h"

static const int quarter[3][3] = { { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 2 } };   /* x, y, weight */

/* Turn (x, y) by k quarters. */
static void turn(int k, const int at[2], int out[2])
{
    const int c = k == 0 ? 1 : k == 2 ? -1 : 0, s = k == 1 ? 1 : k == 3 ? -1 : 0;

    out[0] = c * at[0] - s * at[1];
    out[1] = s * at[0] + c * at[1];
}

static int visit_octant(const loft_sphere *s, int down, int around, engine_net_visit *visit,
                        void *context)
{
    const engine_net_part part = { .from  = { 0.5 * down, 0.25 * around },
                                   .share = { { 0.5, 0 }, { 0, 0.25 } },
                                   .round = true };
    loft_weighted p[9];
    loft_tensor_rational r;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int z[2], x[2];
            turn(down, quarter[i], z);                      /* z and the distance from the axis */
            turn(around, quarter[j], x);
            const int at[3] = { z[1] * x[0], z[1] * x[1], z[0] };
            p[3 * i + j].w = loft_real_from_int(quarter[i][2] * quarter[j][2]);
            p[3 * i + j].p = s->centre;
            for (int k = 0; k < 3; k++)
                if (!real_of(double_of(s->centre.axis[k]) + at[k] * double_of(s->radius),
                             &p[3 * i + j].p.axis[k]))
                    return LOFT_ERR_RANGE;
        }
    const int status = loft_tensor_rational_init(&r, p, 2, 2);
    return status ? status : visit(context, loft_net_from_tensor_rational(&r), &part);
}

int ENGINE_OF(engine_ball_nets)(const loft_sphere *s, engine_net_visit *visit, void *context)
{
    int status = LOFT_OK;

    for (int k = 0; k < 8 && status == LOFT_OK; k++)
        status = visit_octant(s, k / 4, k % 4, visit, context);
    return status;
}

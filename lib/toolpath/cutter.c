/* lib/toolpath/cutter.c
 * SPDX-License-Identifier: MIT
 */
#include "toolpath/cutter.h"

enum loft_status loft_cutter_init(loft_cutter *c, loft_real radius, loft_real corner)
{
    if (!(radius >= LOFT_REAL(1 / 64.0) && radius <= LOFT_REAL(LOFT_CUTTER_MAX) && corner >= 0 &&
          corner <= radius))
        return LOFT_ERR_ARG;
    c->radius = radius;
    c->corner = corner;
    return LOFT_OK;
}

/* With x the distance from the rounding's centre, corner - sqrt(corner^2 - x^2). */
loft_acc loft_cutter_rise(const loft_cutter *c, loft_real distance)
{
    const loft_real within = distance < c->radius ? distance : c->radius,
                    x = within - (c->radius - c->corner);

    if (!(x > 0))
        return 0;
    return loft_to_acc(c->corner) -
           loft_to_acc(loft_acc_sqrt(loft_prod(c->corner, c->corner) - loft_prod(x, x)));
}

loft_acc loft_cutter_lift(const loft_cutter *c, const loft_real slope[2])
{
    const loft_acc leg[3] = { loft_to_acc(c->corner), loft_prod(c->corner, slope[0]),
                              loft_prod(c->corner, slope[1]) };
    const loft_real disk = c->radius - c->corner;
    loft_acc lift = loft_acc_hypot(leg, 3) - loft_to_acc(c->corner);

    if (disk > 0)
        lift += loft_prod(
            disk, loft_acc_sqrt(loft_prod(slope[0], slope[0]) + loft_prod(slope[1], slope[1])));
    return lift;
}

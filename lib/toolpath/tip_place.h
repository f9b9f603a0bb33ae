/* lib/toolpath/tip_place.h -- places of a tip on lines along an axis; part of raster.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TOOLPATH_TIP_PLACE_H
#define LOFT_TOOLPATH_TIP_PLACE_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

/* Axis 0: along x, across y; 1: exchanged. The height is 0. */
static inline loft_vec loft_place_of(unsigned axis, loft_real along, loft_real across)
{
    loft_vec p = { { 0 } };

    p.axis[0] = axis == 0 ? along : across;
    p.axis[LOFT_AXES > 1 ? 1 : 0] = axis == 0 ? across : along;
    return p;
}

static inline void loft_place_lift(loft_vec *p, loft_real z)
{
    if (LOFT_AXES > 2)
        p->axis[LOFT_AXES > 2 ? 2 : 0] = z;
}

/* x / y as a slope of at most 64, y > 0. */
static inline loft_real loft_place_slope(loft_real x, loft_real y)
{
    const loft_real size = loft_real_abs(x);

    if (!(loft_to_acc(size) < loft_to_acc(y) * 64))
        return x < 0 ? LOFT_REAL(-64) : LOFT_REAL(64);
    return loft_div(x, y);
}

LOFT_END_C

#endif

/* lib/geom/chord.c
 * SPDX-License-Identifier: MIT
 */
#include "geom/chord.h"

void loft_chord_aim(loft_chord *c)
{
    c->length = loft_acc_hypot(c->u, LOFT_AXES);
    for (int i = 0; i < LOFT_AXES; i++)
        c->toward[i] = c->length > 0 ? loft_unit_ratio(c->u[i], c->length) : 0;
}

/* The first nearest point, t u, is off along the chord by up to 2^-23 |u|, which is too much for a
 * small |r|. But r = w - t u shows the error: it is the component of r along the chord. Subtracting
 * that needs only a few digits of the direction. The point must not leave the chord, so the
 * correction stops 2^-20 of the distance short of each end (`most`, `ahead`); the lengths are more
 * exact than that. */
loft_acc loft_chord_foot(const loft_chord *c, const loft_acc w[LOFT_AXES], loft_acc r[LOFT_AXES])
{
    loft_acc along = 0, rest = 0;
    loft_unit t = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        along += loft_acc_scale(w[i], c->toward[i]);
    if (along > 0)
        t = along < c->length ? loft_unit_ratio(along, c->length) : LOFT_UNIT(1);

    for (int i = 0; i < LOFT_AXES; i++) {
        r[i] = w[i] - loft_acc_scale(c->u[i], t);
        rest += loft_acc_scale(r[i], c->toward[i]);
    }
    const loft_acc back = loft_acc_scale(c->length, t),
                   most = loft_acc_scale(back, LOFT_UNIT(1 - 1.0 / 1048576));
    const loft_acc ahead = loft_acc_scale(c->length - back, LOFT_UNIT(1 - 1.0 / 1048576));
    if (rest < -most)
        rest = -most;
    if (rest > ahead)
        rest = ahead;
    for (int i = 0; i < LOFT_AXES; i++)
        r[i] -= loft_acc_scale(rest, c->toward[i]);
    return back + rest;
}

/* lib/curve/tween.c
 * SPDX-License-Identifier: MIT
 *
 * x(s) = 3 x1 s (1 - s)^2 + 3 x2 s^2 (1 - s) + s^3 rises from 0 to 1, since x1 and x2 are in 0..1:
 * halving finds s. q16: s has 24 bits, |x'| <= 3 and |y'| <= 51; three products of 2^-33 each.
 */
#include "curve/tween.h"

#define HALVINGS 60         /* those of a double from 1 to the smallest step that matters */

static void polynomial(loft_acc out[3], loft_unit a, loft_unit b)
{
    const loft_acc p1 = loft_unit_to_acc(a), p2 = loft_unit_to_acc(b);

    out[0] = 3 * p1;
    out[1] = 3 * p2 - 6 * p1;
    out[2] = 3 * p1 - 3 * p2 + loft_unit_to_acc(LOFT_UNIT(1));
}

static loft_acc value(const loft_acc c[3], loft_unit s)
{
    return loft_acc_scale(loft_acc_scale(loft_acc_scale(c[2], s) + c[1], s) + c[0], s);
}

enum loft_status loft_tween_init(loft_tween *e, loft_unit x1, loft_unit y1, loft_unit x2,
                                 loft_unit y2)
{
    const loft_unit one = LOFT_UNIT(1);

    if (!(x1 >= 0 && x1 <= one && x2 >= 0 && x2 <= one))
        return LOFT_ERR_ARG;
    if (!(y1 >= -8 * one && y1 <= 8 * one && y2 >= -8 * one && y2 <= 8 * one))
        return LOFT_ERR_RANGE;
    polynomial(e->x, x1, x2);
    polynomial(e->y, y1, y2);
    return LOFT_OK;
}

loft_unit loft_tween_eval(const loft_tween *e, loft_unit t)
{
    const loft_acc x = loft_unit_to_acc(t);
    loft_unit low = 0, high = LOFT_UNIT(1);

    if (t <= low)
        return low;
    if (t >= high)
        return high;
    for (int i = 0; i < HALVINGS; i++) {
        const loft_unit s = (low + high) / 2;
        if (s == low || s == high)
            break;
        if (value(e->x, s) <= x)
            low = s;
        else
            high = s;
    }
    return loft_unit_round(value(e->y, low));
}

/* lib/curve/cardinal.c
 * SPDX-License-Identifier: MIT
 */
#include "curve/cardinal.h"
#include "basis/interp.h"       /* loft_ends3_deriv */

static bool tension_valid(loft_unit tension)
{
    return tension >= LOFT_UNIT(-60) && tension <= LOFT_UNIT(60);
}

/* A Hermite cubic with the slopes s (p2 - p0), s (p3 - p1). The product of a difference (2^16) and
 * 1 - tension (61) is below 2^22, half of it below 2^21: within the range of loft_ends3. Each is
 * rounded twice, by 2^-33, so a slope is off by 3/4 of 2^-32. A control point has a third of that,
 * and a value at most L^3 times that; with its own rounding this is less than 2 L^3 2^-33. The
 * coefficients of the derivative are off by twice the error of a slope, 3/2 * 2^-32 = 3 * 2^-33,
 * and each difference doubles it: below 2^k (3!/m!) 2^-33 for every k. */
static void ends(const loft_vec p[4], loft_unit tension, int i, loft_acc e[4])
{
    const loft_unit twice = LOFT_UNIT(1) - tension;

    e[0] = loft_to_acc(p[1].axis[i]);
    e[1] = loft_to_acc(p[2].axis[i]);
    e[2] = loft_acc_ratio(loft_acc_scale(e[1] - loft_to_acc(p[0].axis[i]), twice), 2);
    e[3] = loft_acc_ratio(loft_acc_scale(loft_to_acc(p[3].axis[i]) - e[0], twice), 2);
}

enum loft_status loft_cardinal_deriv(const loft_vec p[4], loft_unit tension, unsigned k,
                                     loft_unit t, loft_vec *out)
{
    loft_acc e[4], x[LOFT_AXES];

    if (!tension_valid(tension) || !(t >= LOFT_UNIT(-1) && t <= LOFT_UNIT(2)))
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        ends(p, tension, i, e);
        x[i] = loft_ends3_deriv(e, k, t);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_cardinal_eval(const loft_vec p[4], loft_unit tension, loft_unit t,
                                    loft_vec *out)
{
    return loft_cardinal_deriv(p, tension, 0, t, out);
}

enum loft_status loft_cubic_from_cardinal(const loft_vec p[4], loft_unit tension, loft_cubic *out)
{
    loft_acc e[4], c[4];

    if (!tension_valid(tension))
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        ends(p, tension, i, e);
        loft_ends3_bernstein(e, c);
        if (!loft_vec_round_axis(c, 4, i, out->p))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

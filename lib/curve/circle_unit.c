/* lib/curve/circle_unit.c -- arcs of the unit circle
 * SPDX-License-Identifier: MIT
 */
#include "curve/circle.h"

#define FINE(k) ((k) * LOFT_FINE_1)

static bool inside(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

/* 4/3 tan(pi/8) */
loft_acc loft_circle_arm(void)
{
    const loft_fine root = loft_fine_sin(LOFT_FINE_PI / 4);
    return loft_fine_quot(4 * root, 3 * (LOFT_FINE_1 + root));
}

/* For a number below 2^8: x = r + e with a coordinate r, and e^2 is below 2^-34. */
static loft_acc square(loft_acc x)
{
    const loft_real r = loft_acc_round(x);
    const loft_acc rest = x - loft_to_acc(r);
    return loft_prod(r, r) + 2 * loft_acc_mul(rest, r);
}

/* x = 1 - t^2 (3 - 2t) + 3 l b t,  y = 3 l b (1 - t) + t^2 (3 - 2t),  and the excess is
 *
 *     2 v^2 + 8 w^2 - 16 b^2      v = b (3 l - 2) (t - 1/2)      w = b (1 + 3 l / 4)
 *
 * In q16 it therefore does not fit if |v| or |w| exceeds 256. Both are off by at most 2^-31, |v| <=
 * 0.15 l + 0.1 and |w| <= 0.19 l + 0.25. The excess is off by 4 |v| 2^-31 + 16 |w| 2^-31, and by
 * 2^-30 for the squares: below 2^-28 (1 + l). */
enum loft_status loft_circle_quarter(loft_acc arm, loft_unit t, loft_real point[2],
                                     loft_real *excess)
{
    if (!inside(t))
        return LOFT_ERR_ARG;
    const loft_fine x = loft_fine_unit(t), b = loft_fine_mul(x, LOFT_FINE_1 - x);
    const loft_fine rise = loft_fine_mul(loft_fine_mul(x, x), FINE(3) - 2 * x);
    const loft_acc px = loft_fine_to_acc(LOFT_FINE_1 - rise) +
                        3 * loft_fine_scale(arm, loft_fine_mul(b, x));
    const loft_acc py = loft_fine_to_acc(rise) +
                        3 * loft_fine_scale(arm, loft_fine_mul(b, LOFT_FINE_1 - x));
    const loft_fine lean = loft_fine_mul(b, x - LOFT_FINE_1 / 2);
    const loft_acc v = 3 * loft_fine_scale(arm, lean) - loft_fine_to_acc(2 * lean);
    const loft_acc w = loft_fine_scale(arm, 3 * b / 4) + loft_fine_to_acc(b);
    if (!loft_acc_valid(128 * v) || !loft_acc_valid(128 * w))
        return LOFT_ERR_RANGE;
    const loft_acc e = 2 * square(v) + 8 * square(w) -
                       loft_fine_to_acc(loft_fine_mul(4 * b, 4 * b));
    if (!loft_acc_valid(px) || !loft_acc_valid(py) || !loft_acc_valid(e))
        return LOFT_ERR_RANGE;
    point[0] = loft_acc_round(px);
    point[1] = loft_acc_round(py);
    *excess = loft_acc_round(e);
    return LOFT_OK;
}

/* Sine and cosine of an angle in -pi/6..pi/2, ends excluded, each rounded to a coordinate. */
static bool over(loft_real theta, loft_fine *c, loft_fine *s)
{
    if (!(theta > LOFT_REAL(-1) && theta < LOFT_REAL(2)))
        return false;
    const loft_fine x = loft_fine_of(theta);
    if (!(x > -LOFT_FINE_PI / 6 && x < LOFT_FINE_PI / 2))
        return false;
    *c = loft_fine_cos(x);
    *s = loft_fine_sin(x);
    return true;
}

/* 2 cos / (1 + 2 sin) and (1 + 2 sin) / 3. The denominator is off by 2^-57, the quotient by that
 * times distance^2 / cos. A quotient that would far exceed a coordinate is not computed. */
enum loft_status loft_circle_over(loft_real theta, loft_real *distance, loft_real *weight)
{
    loft_fine c, s;

    if (!over(theta, &c, &s))
        return LOFT_ERR_ARG;
    const loft_fine base = LOFT_FINE_1 + 2 * s;
    if (base < LOFT_FINE_1 / 1000000)
        return LOFT_ERR_RANGE;
    const loft_acc d = loft_fine_quot(2 * c, base);
    if (!loft_acc_valid(d))
        return LOFT_ERR_RANGE;
    *distance = loft_acc_round(d);
    *weight = loft_acc_round(loft_fine_to_acc(base / 3));
    return LOFT_OK;
}

/* The conic with weights 1, s, 1, whose degree elevation is the cubic; with b = t (1 - t):
 *
 *     x = c (1 - 2t) / w      y = (s (1 - 2b) + 2b) / w
 *     w = 1 - 2b (1 - s)  >=  (1 + s) / 2  >  1/4 */
enum loft_status loft_circle_over_eval(loft_real theta, loft_unit t, loft_real point[2])
{
    loft_fine c, s;

    if (!inside(t) || !over(theta, &c, &s))
        return LOFT_ERR_ARG;
    const loft_fine x = loft_fine_unit(t), twice = 2 * loft_fine_mul(x, LOFT_FINE_1 - x);
    const loft_fine w = LOFT_FINE_1 - loft_fine_mul(twice, LOFT_FINE_1 - s);
    point[0] = loft_acc_round(loft_fine_quot(loft_fine_mul(c, LOFT_FINE_1 - 2 * x), w));
    point[1] = loft_acc_round(loft_fine_quot(loft_fine_mul(s, LOFT_FINE_1 - twice) + twice, w));
    return LOFT_OK;
}

/* lib/motion/ease.c
 * SPDX-License-Identifier: MIT
 *
 * Where curvature jumps by d, the path is moved aside by d g(s), within w of the joint, so that it
 * changes steadily: g'' goes down from 0 at an even slope -c / w, then up at c / w to 1/2 at the
 * joint, and behind it the same the other way round. That is the smallest slope for its size. With
 * r = 1 - |s| / w and the turn at r = p, g' = g'' = 0 at r = 0 and g = 0 at r = 1 give
 *
 *     (1 - p)^3 = 1/2                     c = 1 / (2 - 4 p) = 0.8513
 *     g = -+c w^2 r^3 / 6                 up to r = p = 0.2063
 *     g = -+c w^2 (p^3 / 3 - p^2 r + p r^2 - r^3 / 6)
 *
 * |g| <= 0.01452 w^2, which may take 3/8 of the tolerance, and g' = 0.1107 w at the joint: the
 * speed of an axis grows by up to |d| w / 9. |d| w <= 1/6.
 */
#include "motion/ease.h"

#if LOFT_PLAN_FILTER > 1

/* p^2, p^3 */
#define TURN2 LOFT_UNIT(0.0425594729785)
#define TURN3 LOFT_UNIT(0.0087799968901)

loft_unit loft_ease_width(const loft_budget *b, loft_acc jump, loft_acc room)
{
    const loft_real size = loft_acc_round(jump);

    if (!(size > 0) || size > LOFT_REAL(4095))
        return 0;
    const loft_acc most = loft_acc_min(room, loft_acc_div(loft_to_acc(LOFT_REAL(1)) / 6, size));
    return loft_unit_round(loft_acc_min(
        most, loft_to_acc(loft_acc_sqrt(loft_acc_div(loft_to_acc(b->tol) * 103 / 4, size)))));
}

void loft_ease_point(const loft_ease *e, loft_acc off, loft_acc point[LOFT_AXES])
{
    const loft_acc w = loft_unit_to_acc(e->width), s = off < 0 ? -off : off;

    if (s >= w)
        return;
    const loft_unit r = LOFT_UNIT(1) - loft_unit_ratio(s, w);
    const loft_acc r1 = loft_unit_to_acc(r), r2 = loft_acc_scale(r1, r), r3 = loft_acc_scale(r2, r);
    const loft_acc z = r < LOFT_EASE_TURN
                           ? r3
                           : 2 * loft_unit_to_acc(TURN3) - 6 * loft_acc_scale(r1, TURN2) +
                                 6 * loft_acc_scale(r2, LOFT_EASE_TURN) - r3;
    const loft_unit part = loft_unit_round(loft_acc_ratio(loft_acc_scale(z, LOFT_EASE_SLOPE), 6));
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc g = loft_acc_scale(
            loft_acc_scale(loft_acc_scale(loft_to_acc(e->jump[i]), e->width), e->width), part);
        point[i] += off < 0 ? -g : g;
    }
}

loft_easing loft_ease_eval(loft_unit r)
{
    const loft_acc x = loft_unit_to_acc(r), c = loft_unit_to_acc(LOFT_EASE_SLOPE),
                   p = loft_unit_to_acc(LOFT_EASE_TURN);

    if (r < LOFT_EASE_TURN)
        return (loft_easing){ -loft_acc_scale(c, r), -c,
                              -loft_acc_scale(loft_acc_scale(c, r), r) / 2 };
    return (loft_easing){ loft_acc_scale(x - 2 * p, LOFT_EASE_SLOPE), c,
                          loft_acc_scale(loft_acc_scale(x, r) / 2 - 2 * loft_acc_scale(p, r) +
                                             loft_unit_to_acc(TURN2),
                                         LOFT_EASE_SLOPE) };
}

#endif

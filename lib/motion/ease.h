/* lib/motion/ease.h -- ease: the path is moved aside around a jump of its curvature, which then
 * changes steadily
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_EASE_H
#define LOFT_MOTION_EASE_H

#include "motion/limits.h"  /* loft_budget */

LOFT_BEGIN_C

#define LOFT_EASE_MAX   LOFT_REAL(2)                /* mm */
/* where its slope turns: p of the width, from its ends (ease.c); */
#define LOFT_EASE_TURN  LOFT_UNIT(0.2062994740159)
#define LOFT_EASE_SLOPE LOFT_UNIT(0.8512071919597)  /* how steep it is: c */

/* Where curvature jumps by `jump` (1/mm), the path is moved aside up to `width` mm before and
 * behind that place; 0: not. */
typedef struct {
    loft_unit width;
    loft_real jump[LOFT_AXES];
} loft_ease;

/* What it adds, for a jump of 1: to the curvature, its derivative times the width, the direction by
 * the width. */
typedef struct {
    loft_acc bend, turn, along;
} loft_easing;

/* How far before and behind a jump of curvature by `jump` (1/mm) the path is moved aside, where
 * there is `room` mm; 0: not. */
loft_unit loft_ease_width(const loft_budget *b, loft_acc jump, loft_acc room);

/* Move aside the point of the path `off` mm behind (or, negative, before) the place of `e`.
 *
 *   range   e->width > 0; any `off`
 *   error   q16: 2^-30 mm, and 2^-15 of the way it is moved
 */
void loft_ease_point(const loft_ease *e, loft_acc off, loft_acc point[LOFT_AXES]);

/* What it adds before the jump, at the part r of the width from where it begins. */
loft_easing loft_ease_eval(loft_unit r);

LOFT_END_C

#endif

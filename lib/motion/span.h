/* lib/motion/span.h -- a span: a cubic in time, for a whole number of ticks
 * SPDX-License-Identifier: MIT
 *
 * Position at time tau = 0..ticks is the Bezier curve p at tau / ticks, per axis, in mm. A chain of spans
 * is what a machine executes; each starts where the one before ended.
 */
#ifndef LOFT_MOTION_SPAN_H
#define LOFT_MOTION_SPAN_H

#include "curve/forward.h"  /* loft_forward */

#define LOFT_SPAN_TICKS_MAX 1023    /* the most for which a walk errs by at most 0.521 LSB */

typedef struct {
    loft_vec p[4];          /* mm; p[0] is the end of the span before */
    uint16_t ticks;         /* 1..LOFT_SPAN_TICKS_MAX                 */
} loft_span;

/* Prepare to yield the position after each tick of `s` (by exact forward differences).
 *
 *   shape   will yield s->ticks points, the last one is s->p[3]; `s` is not kept
 *   range   ticks 1..LOFT_SPAN_TICKS_MAX, otherwise LOFT_ERR_RANGE; any coordinates that a walk accepts
 *   error   that of loft_forward_next for a cubic: q16: 0.521 LSB
 *   cost    one loft_forward_init of degree 3
 */
enum loft_status loft_span_walk(loft_forward *w, const loft_span *s) LOFT_CHECKED;

#endif

/* lib/motion/span.h -- a span: a cubic in time, for a whole number of ticks
 * SPDX-License-Identifier: MIT
 *
 * Position at time tau = 0..ticks is the Bezier curve p at tau / ticks, per axis, in mm. A chain of spans
 * is what a machine executes; each starts where the one before ended.
 */
#ifndef LOFT_MOTION_SPAN_H
#define LOFT_MOTION_SPAN_H

#include "curve/forward.h"  /* loft_forward */

#define LOFT_SPAN_TICKS_MAX 1023    /* the most for which a walk errs by at most 0.52 LSB */

typedef struct {
    loft_vec p[4];          /* mm; p[0] is the end of the span before */
    uint16_t ticks;         /* 1..LOFT_SPAN_TICKS_MAX                 */
} loft_span;

/* Prepare to yield the position after each tick of `s` (by exact forward differences). */
enum loft_status loft_span_walk(loft_forward *w, const loft_span *s) LOFT_CHECKED;

#endif

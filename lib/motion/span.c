/* lib/motion/span.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/span.h"

enum loft_status loft_span_walk(loft_forward *w, const loft_span *s)
{
    loft_bezier b;
    enum loft_status status = LOFT_ERR_RANGE;

    if (s->ticks >= 1 && s->ticks <= LOFT_SPAN_TICKS_MAX)
        status = loft_bezier_init(&b, s->p, 3);
    return status == LOFT_OK ? loft_forward_init(w, &b, s->ticks) : status;
}

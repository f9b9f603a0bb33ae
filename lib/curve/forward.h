/* lib/curve/forward.h -- walk a Bezier curve at equal parameter steps, by exact forward differences
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CURVE_FORWARD_H
#define LOFT_CURVE_FORWARD_H

#include "curve/bezier.h"   /* loft_bezier */

#define LOFT_FORWARD_DEGREE_MAX 5

/* (draft: the fields are the author's of forward.c; the calls below are fixed) */
typedef struct {
    struct { uint64_t d[LOFT_FORWARD_DEGREE_MAX + 1]; } axis[LOFT_AXES];
    uint32_t left;
    uint8_t degree;
} loft_forward;

/* n equal steps, any n within the law of ranges; yields n points, t = 1/n .. 1. */
enum loft_status loft_forward_init(loft_forward *w, const loft_bezier *b, uint32_t n) LOFT_CHECKED;
bool             loft_forward_next(loft_forward *w, loft_vec *out);
uint32_t         loft_forward_run(loft_forward *w, loft_vec out[], uint32_t count);

#endif

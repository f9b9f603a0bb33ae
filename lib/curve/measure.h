/* lib/curve/measure.h -- flatten within a tolerance, length, parameter at a length
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CURVE_MEASURE_H
#define LOFT_CURVE_MEASURE_H

#include "curve/bezier.h"   /* loft_cubic */

/* Cuts a cubic into chords that stay within `tol` of it. (draft: fields are the author's) */
typedef struct {
    loft_cubic curve;
    loft_real tol;
    loft_unit t;
} loft_flatten;

enum loft_status loft_flatten_init(loft_flatten *f, const loft_cubic *c, loft_real tol) LOFT_CHECKED;
bool             loft_flatten_next(loft_flatten *f, loft_vec *out);     /* the end of the next chord */

loft_acc  loft_cubic_length(const loft_cubic *c, loft_real tol);
loft_unit loft_cubic_at_length(const loft_cubic *c, loft_acc length, loft_real tol);

#endif

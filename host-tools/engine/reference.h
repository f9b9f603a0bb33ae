/* host-tools/engine/reference.h -- what a curve is by its definition, in long double: what others
 * are measured against
 * SPDX-License-Identifier: MIT
 *
 * No code is shared with the library: each kind is computed from its formula. With a mantissa of 64
 * bits the error is below 1e-4 LSB of double for curves of moderate degree and weights.
 */
#ifndef LOFT_REFERENCE_H
#define LOFT_REFERENCE_H

#include "engine/curve.h"

typedef struct {
    const curve *c;                             /* borrowed                                      */
    long double *step;                          /* natural: the length of each piece's parameter */
    long double (*second)[CURVE_AXES];          /* natural: the second derivative at each point  */
} reference;

/* Prepare; false if the curve is none (natural chord: two points in one). Free in either case. */
bool reference_init(reference *r, const curve *c);
void reference_free(reference *r);

/* The point at t, within the curve's parameters (beyond them where curve_extends). */
void reference_eval(const reference *r, long double t, long double out[CURVE_AXES]);

#endif

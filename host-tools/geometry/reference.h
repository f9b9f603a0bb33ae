/* host-tools/geometry/reference.h -- curves by their definitions, in long double: the reference for
 * measurements
 * SPDX-License-Identifier: MIT
 *
 * This shares no code with the library: each kind is computed from its formula. With a mantissa of
 * 64 bits the error is below 1e-4 LSB of double for curves of moderate degree and weights.
 */
#ifndef LOFT_REFERENCE_H
#define LOFT_REFERENCE_H

#include "engine/curve.h"

typedef struct {
    const curve *c;                             /* borrowed */
    long double *step;                          /* splines: the parameter length of each piece */
    long double (*second)[CURVE_AXES];          /* splines: the second derivative at each point  */
} reference;

/* Prepare. Returns false if the curve is invalid (a spline with chords: two points in one place).
 * Free in either case. */
bool reference_init(reference *r, const curve *c);
void reference_free(reference *r);

/* The point at t, within the curve's parameter range (outside it if curve_extends). */
void reference_eval(const reference *r, long double t, long double out[CURVE_AXES]);

/* The same of natural, natural chord and spline; k is the piece, t is in 0..1 of it. */
bool reference_spline_init(reference *r);
void reference_spline_eval(const reference *r, unsigned k, long double t,
                           long double out[CURVE_AXES]);

#endif

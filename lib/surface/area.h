/* lib/surface/area.h -- the area of a patch or a triangle within a proven tolerance
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SURFACE_AREA_H
#define LOFT_SURFACE_AREA_H

#include "surface/net.h"    /* loft_net */

LOFT_BEGIN_C

/* The area, in the first three axes. Folds count more than once.
 *
 *   range   no weights and tol > 0, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the area does not
 *           fit a loft_acc (q16: 2^31), in f32 and f64 when loft_exact_valid refuses a coordinate,
 *           or when 24 halvings of the patch do not prove `tol` (a tolerance finer than about 2^-18
 *           of the area); *out is then untouched
 *   error   tol, in units squared, plus q16: 2^-32 + 2^-48 A   f32, f64: 2^-40 A with A = m n times
 *           the product of the largest steps of the net along u and v (a triangle: of its form,
 *           net.h). A plane patch without folds has only the second part
 *   cost    per piece 16 m^2 n^2 cross products in numbers of num/sci.h (bicubic: 144 with equal
 *           factors joined); the number of pieces is about the squared turning of the patch in
 *           radians times the area over 4 tol, and twice that for a twisted net; 13 kB of stack
 *           in q16, 7 kB in floats; not for an ISR
 *   see     Gravesen: Adaptive subdivision and the length and energy of Bezier curves, 1997, the
 *           same method for curves
 */
enum loft_status loft_net_area(loft_net s, loft_real tol, loft_acc *out) LOFT_CHECKED;

LOFT_END_C

#endif

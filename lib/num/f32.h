/* lib/num/f32.h -- float backend
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NUM_F32_H
#define LOFT_NUM_F32_H

#include <float.h>

#if DBL_MANT_DIG < 53
#  error "f32 needs a 64-bit double for loft_acc (avr-gcc has none): use LOFT_Q16"
#endif

typedef float  loft_real;
typedef float  loft_unit;
typedef double loft_acc;        /* a float sum would drift: 600 ulp after 1024 steps */

#define LOFT_REAL_MAX      FLT_MAX
#define LOFT_REAL_REACH    FLT_MAX         /* sums are double */
#define LOFT_REAL_EPSILON  FLT_EPSILON

#include "num/floats.h" /* the operations */

#endif

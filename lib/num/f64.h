/* lib/num/f64.h -- double backend
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NUM_F64_H
#define LOFT_NUM_F64_H

#include <float.h>

#if DBL_MANT_DIG < 53
#  error "f64 needs a 64-bit double (avr-gcc has none): use LOFT_Q16"
#endif

typedef double loft_real;
typedef double loft_unit;
typedef double loft_acc;

#define LOFT_REAL_MAX      DBL_MAX
#define LOFT_REAL_REACH    1.0715086071862673e301      /* 2^1000, in a form that C++11 accepts */
#define LOFT_REAL_EPSILON  DBL_EPSILON

#include "num/floats.h" /* the operations */

#endif

/* lib/num/explog.h -- logarithms and exponentials
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NUM_EXPLOG_H
#define LOFT_NUM_EXPLOG_H

#include "num/angle.h"  /* loft_fine */
#include "num/sci.h"    /* loft_sci */

LOFT_BEGIN_C

/* Conversion from a loft_fine, and to the nearest one.
 *
 *   range   to_fine: |x| < 8
 *   error   from_fine: none   to_fine: q16: 2^-61   f32, f64: none
 */
loft_sci  loft_sci_from_fine(loft_fine x);
loft_fine loft_sci_to_fine(loft_sci x);

/* The natural logarithm.
 *
 *   range   x > 0
 *   error   q16: 2^-57 and 2^-60 of the result   f32, f64: 2^-51 of the result
 *   cost    15 products and 13 divisions of 64 bits and a quotient in q16; no table
 *   see     the series of artanh, after removing a power of two
 */
loft_sci  loft_sci_log(loft_sci x);

/* e^x; 0 if that is below 2^-1000: from x = -693.147 on.
 *
 *   range   x < 690
 *   error   of the result, q16: 2^-56 + |x| 2^-60   f32, f64: 2^-51
 *   cost    17 products and 16 divisions of 64 bits in q16; no table
 *   see     Taylor series, after removing a power of two
 */
loft_sci  loft_sci_exp(loft_sci x);

LOFT_END_C

#endif

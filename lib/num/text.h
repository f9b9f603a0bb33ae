/* lib/num/text.h -- numbers as decimal text and back, and as whole micrometres, without a C library
 * SPDX-License-Identifier: MIT
 *
 *     char text[LOFT_TEXT_MAX];
 *     loft_real x;
 *     const char *rest = loft_real_from_text("12.7 mm", &x);
 *     if (rest != NULL)                        // " mm"
 *         loft_to_text(x, 2, text);            // "12.70"
 */
#ifndef LOFT_NUM_TEXT_H
#define LOFT_NUM_TEXT_H

#include "num/num.h"    /* loft_real, loft_quotient */

LOFT_BEGIN_C

#define LOFT_TEXT_MAX      40   /* bytes of the longest number, the 0 at its end included */
#define LOFT_TEXT_DECIMALS 16   /* with so many a number of q16 is exact */

/* Read a number: a sign or none, digits, and a point among them or none. There is no exponent.
 *
 *   shape   gives where the text goes on behind the number. NULL where no number begins (blanks are
 *           not skipped), or where it does not fit a coordinate: *out is untouched then
 *   range   any number of digits; f32, f64: up to 41 before the point, others do not fit
 *   error   q16: 1/2 LSB, ties upward   f32: 1/2 ulp + 2^-27 ulp + 10^-22
 *           f64: 1/2 ulp with 15 digits or fewer, up to 22 of them behind the point;
 *           otherwise 2 ulp + 10^-22
 *   cost    q16: a product of 32 or 64 bits for each digit, 17 of 64 bits, a division of 64 bits
 *   stack   Cortex-M4 96   Cortex-M0+ 140   ATmega328P 58
 */
const char *loft_real_from_text(const char *text, loft_real *out);

/* Write a number with that many decimals: the nearest text, of two the one with the even digit.
 * Zero has no sign.
 *
 *   shape   gives the length of the text, which ends with a 0
 *   range   decimals above LOFT_TEXT_DECIMALS count as that; without decimals there is no point.
 *           f32, f64: |a| < 2^63; for others, and what is no number, the text is empty
 *   error   1/2 of the last decimal, and none in q16 with 16; f32, f64: also 2^-60
 *   cost    a product and a shift for each decimal, a division for each digit before the point
 *   stack   Cortex-M4 80   Cortex-M0+ 96   ATmega328P 68
 */
unsigned loft_to_text(loft_real a, unsigned decimals, char text[LOFT_TEXT_MAX]);

/* Thousandths to a coordinate: micrometres to mm.
 *
 *   range   q16: |um| < 32,768,000; f32, f64: any
 *   error   q16: 1/2 LSB   f32: 1/2 ulp + 2^-29 ulp   f64: 1/2 ulp
 *   cost    q16: a division of 64 bits by a small number
 */
static inline loft_real loft_real_from_um(int32_t um)
{
#if LOFT_NUM == LOFT_Q16
    return (loft_real)loft_quotient((int64_t)um * 8192, 125);
#else
    return (loft_real)((loft_acc)um / 1000);
#endif
}

LOFT_END_C

#endif

/* lib/num/avr.h -- wide arithmetic out of line, for avr-gcc
 * SPDX-License-Identifier: MIT
 *
 * avr-gcc expands every operation of 64 bits in place and divides and multiplies by shifts of single bits; these are the same
 * operations once, in registers. No other compiler sees this file.
 */
#ifndef LOFT_NUM_AVR_H
#define LOFT_NUM_AVR_H

#include <stdint.h>

/* x times t / 2^24 and x times a / 2^16, rounded to nearest, ties upward.
 *
 *   range   |t|, |a| < 2^31, the result below 2^63
 *   error   1/2
 *   cost    about 260 cycles */
int64_t loft_avr_scale(int64_t x, int32_t t);
int64_t loft_avr_mul(int64_t x, int32_t a);

/* n / d to nearest, ties upward.
 *
 *   range   d = 1..2^31, |n| + d < 2^63
 *   error   1/2
 *   cost    about 150 cycles for each byte of n, without leading zeros */
int64_t loft_avr_quotient(int64_t n, uint32_t d);

/* 2^24 n / d to nearest, ties upward.
 *
 *   range   d > 0, n < 2 d < 2^39
 *   error   1/2
 *   cost    about 650 cycles */
uint32_t loft_avr_part(uint64_t n, uint64_t d);

/* The whole number nearest to the square root of x.
 *
 *   range   x < 2^63
 *   error   1/2
 *   cost    about 140 cycles for each byte of x, without leading zeros */
uint32_t loft_avr_root(uint64_t x);

#endif

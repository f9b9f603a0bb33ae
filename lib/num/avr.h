/* lib/num/avr.h -- wide arithmetic out of line, for avr-gcc
 * SPDX-License-Identifier: MIT
 *
 * avr-gcc expands every 64-bit operation in place, and divides and multiplies by shifts of single
 * bits. These are the same operations, once, in registers. No other compiler sees this file.
 */
#ifndef LOFT_NUM_AVR_H
#define LOFT_NUM_AVR_H

#include <stdbool.h>
#include <stdint.h>

#include "config.h"     /* names: the symbols carry their number type        */

LOFT_BEGIN_C

/* x times t / 2^24 and x times a / 2^16, rounded to nearest, ties upward.
 *
 *   range   |t|, |a| < 2^31, the result below 2^63
 *   error   1/2
 *   cost    140 cycles where |x| < 2^47 and |t|, |a| < 2^24, elsewhere 210 */
int64_t loft_acc_scale(int64_t x, int32_t t);
int64_t loft_acc_mul(int64_t x, int32_t a);

/* As in num.h.
 *
 *   cost    about 20 cycles, loft_prod 130 */
int64_t loft_acc_abs(int64_t x);
int64_t loft_acc_min(int64_t x, int64_t y);
int64_t loft_acc_max(int64_t x, int64_t y);
int64_t loft_to_acc(int32_t a);
int64_t loft_unit_to_acc(int32_t t);
int32_t loft_acc_round(int64_t x);
int32_t loft_unit_round(int64_t x);
int64_t loft_prod(int32_t a, int32_t b);

/* As in num.h.
 *
 *   range   b >= 0
 *   cost    110 cycles */
int32_t loft_prod_int(int32_t a, int32_t b);

/* The number of bits of x, without leading zeros. */
uint8_t loft_avr_bits(uint64_t x);

/* x / 2^n to nearest, ties upward; a negative n: times 2^-n.
 *
 *   range   the result below 2^64
 *   cost    11 cycles for each of n */
uint64_t loft_avr_shift(uint64_t x, int8_t n);

/* As in num.h.
 *
 *   cost    about 180 cycles */
int32_t loft_lerp(int32_t a, int32_t b, int32_t t);

/* As in num.h.
 *
 *   cost    that of loft_avr_quotient plus 50 cycles */
int64_t loft_acc_div(int64_t x, int32_t a);
int32_t loft_unit_of(uint32_t j, uint32_t n);

/* n / d to nearest, ties upward.
 *
 *   range   d >= 1, |n| + d < 2^63
 *   error   1/2
 *   cost    about 150 cycles for each byte of n, without leading zeros */
int64_t loft_avr_quotient(int64_t n, uint32_t d);

/* The number x / n in place, truncated: bytes, lowest first.
 *
 *   range   n >= 1, bytes 1..120
 *   cost    42 cycles for each byte and 250 */
void loft_avr_divide(uint32_t x[], uint8_t bytes, uint16_t n);

/* a inverse / 2^32, truncated towards 0: a signed number of 5 bytes becomes one of 12, which wraps.
 * The 4 bytes before a are changed.
 *
 *   cost    620 cycles */
void loft_avr_scale_wide(uint8_t a[12], const uint32_t inverse[3]);

/* The differences d[1..3] of a walk along a cubic: walk_start.c. d[0] is changed.
 *
 *   cost    2,400 cycles */
void loft_avr_start3(uint64_t d[4], const int32_t p[4], const uint32_t inverse[3][3],
                     uint8_t room[40]);

/* One step of the cubic walks of a loft_walks: d[0] += d[1], d[1] += d[2], d[2] += d[3], each as
 * they were, and the upper half of d[0] in out[0]; then those of the next axis and out[1], and so
 * on. Returns whether any was left.
 *
 *   cost    150 cycles for each axis, and 20; 192 bytes for each axis */
bool loft_avr_next3(void *walks, int32_t out[]);

/* `count` steps of one cubic walk, with its state in registers: the upper half of d[0] after each
 * in `out`, `bytes` further each time.
 *
 *   range   count >= 1
 *   cost    55 cycles for each step and 190 */
void loft_avr_run3(uint64_t d[4], int32_t *out, uint16_t count, uint8_t bytes);

/* A table that stays in flash (RAM would hold a copy of it), and access to an entry.
 *
 *   cost    4 cycles more than from RAM */
#define LOFT_AVR_FLASH __attribute__((section(".progmem.data")))
static inline uint32_t loft_avr_flash(const uint32_t *entry)
{
    uint32_t x;
    __asm__ ("lpm %A0, Z+\n lpm %B0, Z+\n lpm %C0, Z+\n lpm %D0, Z+" : "=&r" (x), "+z" (entry));
    return x;
}

LOFT_END_C

#endif

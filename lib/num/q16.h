/* lib/num/q16.h -- Q16.16 backend: coordinates in int32_t, wide values in int64_t
 * SPDX-License-Identifier: MIT
 *
 * A loft_acc holds a value times 2^32: a coordinate with 16 guard bits below its LSB and 15 bits of
 * headroom above. The product of two reals is an acc without any shift, and its square root is a
 * real.
 */
#ifndef LOFT_NUM_Q16_H
#define LOFT_NUM_Q16_H

typedef int32_t loft_real;      /* Q16.16: -32768 .. 32767.99998, LSB = 2^-16           */
typedef int32_t loft_unit;      /* Q8.24: -128 .. 127.99999994, resolution of a float in 0..1 */
typedef int64_t loft_acc;       /* Q32.32: value * 2^32                                 */

#define LOFT_REAL(x)   ((loft_real)((x) * 65536.0 + ((x) < 0 ? -0.5 : 0.5)))
#define LOFT_UNIT(x)   ((loft_unit)((x) * 16777216.0 + ((x) < 0 ? -0.5 : 0.5)))
#define LOFT_REAL_MAX  INT32_MAX
/* the distance between neighbouring coordinates; 0 in floats */
#define LOFT_REAL_LSB  ((loft_real)1)

/* All shifts of wide numbers are here. A right shift of a negative number must be arithmetic.
 * avr-gcc shifts 64 bits one bit at a time in a loop; there a shift by whole bytes is a move. */
typedef char loft_assert_arithmetic_shift[((-1 >> 1) == -1) ? 1 : -1];

#if defined(__AVR__)
#include "num/avr.h"
typedef union {
    int64_t all;
    struct {
        uint32_t low;
        int32_t high;
    } half;
    struct {
        uint16_t low;
        int32_t middle;
        uint16_t high;
    } mid;
    uint8_t byte[8];
} loft_bytes;
static inline int32_t loft_acc_high(int64_t x)
{
    loft_bytes b;
    b.all = x;
    return b.half.high;
}
static inline uint32_t loft_acc_low(int64_t x)
{
    loft_bytes b;
    b.all = x;
    return b.half.low;
}
static inline int32_t loft_acc_middle(int64_t x)
{
    loft_bytes b;
    b.all = x;
    return b.mid.middle;
}
static inline int64_t  loft_shift_24(int64_t x)
{
    loft_bytes b, r;
    b.all = x;
    r.half.low = (uint32_t)b.byte[3] | ((uint32_t)b.byte[4] << 8) | ((uint32_t)b.byte[5] << 16) |
                 ((uint32_t)b.byte[6] << 24);
    r.half.high = (int8_t)b.byte[7];
    return r.all;
}
static inline int64_t  loft_shift_16(int64_t x)
{
    loft_bytes b, r;
    b.all = x;
    r.half.low  = (uint32_t)b.mid.middle;
    r.half.high = (int16_t)b.mid.high;
    return r.all;
}

/* n / d, d = 1..2^31, to nearest, ties upward */
static inline int64_t  loft_quotient(int64_t n, uint32_t d) { return loft_avr_quotient(n, d); }
#else
static inline int32_t  loft_acc_high(int64_t x)   { return (int32_t)(x >> 32); }
static inline uint32_t loft_acc_low(int64_t x)    { return (uint32_t)((uint64_t)x & 0xffffffffu); }
static inline int32_t loft_acc_middle(int64_t x)
{
    return (int32_t)(uint32_t)(((uint64_t)x >> 16) & 0xffffffffu);
}
static inline int64_t  loft_shift_24(int64_t x)   { return x >> 24; }
static inline int64_t  loft_shift_16(int64_t x)   { return x >> 16; }

/* error none */
static inline loft_acc loft_to_acc(loft_real a)     { return (loft_acc)a * 65536; }

/* n / d, d = 1..2^31, to nearest, ties upward */
static inline int64_t  loft_quotient(int64_t n, uint32_t d)
{
    const int64_t q = n / d, r = n % d;
    return 2*r >= d ? q + 1 : 2*r < -(int64_t)d ? q - 1 : q;
}
#endif

/* a / 8 rounded down */
static inline int32_t  loft_eighth(loft_real a)   { return a >> 3; }

#if !defined(__AVR__)
/* error none */
static inline loft_acc loft_prod(loft_real a, loft_real b)  { return (loft_acc)a * b; }
#endif

/* Every coordinate is valid. */
static inline bool loft_real_valid(loft_real a)
{
    (void)a;
    return true;
}

/* The distance between neighbouring numbers, of any size: 2^-32 and 2^-16. */
static inline loft_acc loft_acc_ulp(loft_acc size)
{
    (void)size;
    return 1;
}
static inline loft_acc loft_real_ulp(loft_acc size)
{
    (void)size;
    return 65536;
}

/* error none; |x|, of any x */
static inline uint64_t loft_acc_size(int64_t x) { return x < 0 ? 0 - (uint64_t)x : (uint64_t)x; }

/* An upper bound of the error of loft_acc_hypot for that result. */
static inline loft_acc loft_hypot_ulp(loft_acc length)    { return length / 268435456 + 1; }

/* True if x rounds into a real. */
static inline bool loft_acc_valid(loft_acc x)
{
    return x >= (loft_acc)INT32_MIN * 65536 - 32768 && x < (loft_acc)INT32_MAX * 65536 + 32768;
}

#if !defined(__AVR__)
/* error 1/2 LSB; range loft_acc_valid(x) */
static inline loft_real loft_acc_round(loft_acc x)          { return loft_acc_middle(x + 32768); }
#endif

/* error 1/2; -2^31 <= x < 2^31 - 1/2 */
static inline int32_t loft_acc_int(loft_acc x) { return loft_acc_high(x + 2147483648); }

#if !defined(__AVR__)
/* loft_acc_int(loft_prod(a, b)), b >= 0. No sum overflows: (2^15 - 1) (2^16 - 1) + (2^16 - 2) +
 * 2^15 = 2^31 - 1. */
static inline int32_t loft_prod_int(loft_real a, loft_real b)
{
#if defined(__ARM_ARCH_6M__)
    const int32_t a0 = a & 0xffff, a1 = a >> 16, b0 = b & 0xffff, b1 = b >> 16;
    const int32_t left = a1 * b0 + (int32_t)((uint32_t)a0 * (uint32_t)b0 >> 16) + 32768,
                  right = a0 * b1 + (left & 0xffff);

    return a1 * b1 + (left >> 16) + (right >> 16);
#else
    return loft_acc_int(loft_prod(a, b));
#endif
}
#endif

/* error 1/2 LSB; range loft_acc_valid(loft_prod(a, b)), that is -32768 <= a * b < 32768 - 2^-17 */
static inline loft_real loft_mul(loft_real a, loft_real b)
{
    return loft_acc_round(loft_prod(a, b));
}

#if !defined(__AVR__)
/* error 1/2 LSB, none at t = 0 and 1; t in 0..1, any a, b: the difference has 33 bits, t 25, the
 * product 58 */
static inline loft_real loft_lerp(loft_real a, loft_real b, loft_unit t)
{
    return (loft_real)(a + loft_shift_24(((int64_t)b - a) * t + 8388608));
}

#if defined(__ARM_ARCH_6M__)
/* loft_acc_scale of a core that multiplies to 32 bits alone */
loft_acc loft_m0_scale(loft_acc x, loft_unit t);
#endif

/* x * t: the two 32-bit halves of x are multiplied separately, so that no product exceeds 64 bits.
 * error 2^-33 (1/2 of an acc LSB); |x * t| <= 2^30 */
static inline loft_acc loft_acc_scale(loft_acc x, loft_unit t)
{
#if defined(__ARM_ARCH_6M__)
    return loft_m0_scale(x, t);
#else
    return (loft_acc)loft_acc_high(x) * t * 256 +
           loft_shift_24((int64_t)loft_acc_low(x) * t + 8388608);
#endif
}
#endif

/* error 2^-33; |x|, |y| < 2^30, t in 0..1 or |(y - x) t| <= 2^30; none at t = 0 and 1 */
static inline loft_acc loft_acc_lerp(loft_acc x, loft_acc y, loft_unit t)
{
    return x + loft_acc_scale(y - x, t);
}

/* x + v (y - x) + w (z - x), rounded once: the low halves are summed before they are truncated.
 * error 2^-33; |v|, |w| <= 32; |x|, |y|, |z| < 2^30 and v, w, 1 - v - w >= 0, or |y - x| and |z -
 * x| < 2^31 and (|v| |y - x| + |w| |z - x|) < 2^31 - 2^8 and the result below 2^31; none at the
 * corners */
static inline loft_acc loft_acc_lerp3(loft_acc x, loft_acc y, loft_acc z, loft_unit v, loft_unit w)
{
    const loft_acc d = y - x, e = z - x;
    const int64_t high = (int64_t)loft_acc_high(d) * v + (int64_t)loft_acc_high(e) * w;
    const int64_t low = (int64_t)loft_acc_low(d) * v + (int64_t)loft_acc_low(e) * w;
    return x + (high * 256 + loft_shift_24(low + 8388608));
}

/* error 2^-33; |x|, |y| < 2^30, j <= n or |(y - x) j / n| <= 2^30 and j <= 2 n, 1 <= n < 2^30; none
 * at j = 0 and n. The integer quotient of y - x by n, times j, is exact; the remainder is below n,
 * and times j below 2^61. */
static inline loft_acc loft_acc_lerp_at(loft_acc x, loft_acc y, uint32_t j, uint32_t n)
{
    const int64_t d = n, quotient = (y - x) / d, rest = (y - x) % d * j;
    const int64_t q = rest / d, r = rest % d;
    return x + quotient * j + (2*r >= d ? q + 1 : 2*r < -d ? q - 1 : q);
}

/* error none; the largest real, 1 LSB less, of the most negative one */
static inline loft_real loft_real_abs(loft_real a)
{
    return a >= 0 ? a : a < -LOFT_REAL_MAX ? LOFT_REAL_MAX : -a;
}

#if !defined(__AVR__)
/* error none; |x| < 2^31 */
static inline loft_acc loft_acc_abs(loft_acc x)              { return x < 0 ? -x : x; }

/* error none */
static inline loft_acc loft_acc_min(loft_acc x, loft_acc y) { return x < y ? x : y; }
static inline loft_acc loft_acc_max(loft_acc x, loft_acc y)  { return x > y ? x : y; }
#endif

/* error 2^-33, ties upward; |x + y| < 2^31 */
static inline loft_acc loft_acc_mean(loft_acc x, loft_acc y) { return (x + y + 1) >> 1; }

#if !defined(__AVR__)
/* error 2^-33; |x * a| <= 2^30 */
static inline loft_acc loft_acc_mul(loft_acc x, loft_real a)
{
    return (loft_acc)loft_acc_high(x) * a * 65536 +
           loft_shift_16((int64_t)loft_acc_low(x) * a + 32768);
}
#endif

/* error 2^-33; any x, k >= 1 */
static inline loft_acc loft_acc_ratio(loft_acc x, int32_t k)
{
    return loft_quotient(x, (uint32_t)k);
}

#if !defined(__AVR__)
/* error 2^-33; a != 0, |x| < 2^15, |x / a| < 2^30 */
static inline loft_acc loft_acc_div(loft_acc x, loft_real a)
{
    return loft_quotient(x * 65536 * (a < 0 ? -1 : 1), a < 0 ? 0u - (uint32_t)a : (uint32_t)a);
}

/* error 2^-25; j <= n, n >= 1 */
static inline loft_unit loft_unit_of(uint32_t j, uint32_t n)
{
    return (loft_unit)((((uint64_t)j << 24) + n / 2) / n);
}
#endif

/* error 1/2 LSB; b != 0, -32768 <= a / b < 32768: the quotient of the raw numbers. (It cannot round
 * up to 32768: that needs b > 2, and then a does not fit.) */
static inline loft_real loft_div(loft_real a, loft_real b) { return (loft_real)loft_acc_div(a, b); }

/* exact; |a| < 128 */
static inline loft_unit loft_unit_from(loft_real a)         { return a * 256; }

#if !defined(__AVR__)
/* error 2^-25; |x| < 128 */
static inline loft_unit loft_unit_round(loft_acc x) { return loft_acc_middle(x * 256 + 32768); }

/* exact */
static inline loft_acc  loft_unit_to_acc(loft_unit t)         { return (loft_acc)t * 256; }
#endif

/* exact; the wire and files hold coordinates as raw Q16.16 in every number type */
static inline bool loft_raw_valid(loft_real a)
{
    (void)a;
    return true;
}
static inline int32_t   loft_raw_from_real(loft_real a)     { return a; }
static inline loft_real loft_real_from_raw(int32_t raw)     { return raw; }

/* exact; -32768 <= i <= 32767 */
static inline loft_real loft_real_from_int(int32_t i)       { return i * 65536; }
static inline int32_t   loft_real_floor(loft_real a)        { return a >> 16; }

#endif

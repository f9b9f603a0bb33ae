/* lib/num/f32.h -- float backend
 * SPDX-License-Identifier: MIT
 *
 * Every operation is one or two correctly rounded IEEE operations; nothing is contracted or reordered
 * that the compiler was not told to.
 */
#ifndef LOFT_NUM_F32_H
#define LOFT_NUM_F32_H

#include <float.h>

#if DBL_MANT_DIG < 53
#  error "f32 needs a 64-bit double for loft_acc (avr-gcc has none): use LOFT_Q16"
#endif

typedef float loft_real;
typedef float loft_unit;
typedef double loft_acc;        /* a float sum would drift: 600 ulp after 1024 steps */

#define LOFT_REAL(x)   ((loft_real)(x))
#define LOFT_UNIT(x)   ((loft_unit)(x))
#define LOFT_REAL_MAX  FLT_MAX
#define LOFT_REAL_LSB  ((loft_real)0)       /* the distance between neighbouring coordinates; 0 in floats */

static inline loft_acc  loft_wide(loft_real a)                  { return (loft_acc)a; }
static inline loft_acc  loft_prod(loft_real a, loft_real b)     { return (loft_acc)a * (loft_acc)b; }
static inline bool      loft_acc_fits(loft_acc x)               { return x <= FLT_MAX && x >= -FLT_MAX; }
static inline loft_real loft_acc_round(loft_acc x)              { return (loft_real)x; }
static inline loft_real loft_mul(loft_real a, loft_real b)      { return a * b; }
static inline loft_real loft_div(loft_real a, loft_real b)      { return a / b; }
static inline loft_real loft_lerp(loft_real a, loft_real b, loft_unit t) { return (1 - t) * a + t * b; }
static inline loft_acc  loft_acc_scale(loft_acc x, loft_unit t) { return x * (loft_acc)t; }
static inline loft_acc  loft_acc_lerp(loft_acc x, loft_acc y, loft_unit t)
{
    return (1 - (loft_acc)t) * x + (loft_acc)t * y;
}
static inline loft_acc  loft_acc_mul(loft_acc x, loft_real a)   { return x * (loft_acc)a; }
static inline loft_acc  loft_acc_div(loft_acc x, loft_real a)   { return x / (loft_acc)a; }
static inline loft_acc  loft_acc_ratio(loft_acc x, int32_t k)   { return x / (loft_acc)k; }
static inline loft_unit loft_unit_of(uint32_t j, uint32_t n)    { return (loft_unit)((loft_acc)j / (loft_acc)n); }
static inline loft_unit loft_unit_from(loft_real a)             { return a; }
static inline loft_real loft_real_from_int(int32_t i)           { return (loft_real)i; }
static inline int32_t   loft_real_floor(loft_real a)
{
    const int32_t i = (int32_t)a;
    return (loft_real)i > a ? i - 1 : i;
}

#endif

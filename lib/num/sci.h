/* lib/num/sci.h -- numbers with their own exponent, for products of many factors and quotients of
 * small numbers
 * SPDX-License-Identifier: MIT
 *
 * A product of six areas, a weight that vanishes toward an edge, the quotient of two of these: no
 * fixed binary point suits all of them. Every operation has a relative error, whatever the size of
 * its result:
 *
 *   loft_sci   q16: m * 2^e with 62 bits and a sign   f32, f64: double
 *
 *   range   q16: magnitudes 2^-32000 .. 2^32000, not checked   f32, f64: the normal numbers of
 *           double
 *   error   q16: 2^-61 of the result, in a sum of its larger term   f32, f64: 2^-53; none if the
 *           result is exact
 *   cost    q16: mul 4 32-bit products, add and sub two shifts, div and sqrt 63 rounds of shift and
 *           subtract; 16 bytes per number; safe in an ISR, except for cross
 */
#ifndef LOFT_NUM_SCI_H
#define LOFT_NUM_SCI_H

#include "num/acc128.h"     /* loft_acc128 */
#include "num/num.h"        /* loft_real, loft_unit, loft_acc */

LOFT_BEGIN_C

#if LOFT_NUM == LOFT_Q16

/* m = 0, or 2^62 <= m < 2^63. */
typedef struct {
    uint64_t m;
    int16_t  e;
    bool     minus;
} loft_sci;

#define LOFT_SCI_BITS 61        /* a rounding is at most 2^-LOFT_SCI_BITS of the result */

/* 0 and 1, for the start of sums and products. */
static inline loft_sci loft_sci_zero(void)
{
    const loft_sci r = { 0, 0, false };
    return r;
}
static inline loft_sci loft_sci_one(void)
{
    const loft_sci r = { (uint64_t)1 << 62, -62, false };
    return r;
}

/* Conversion from an acc, a coordinate, a parameter, an integer, and a loft_acc128 in units of
 * 2^-32.
 *
 *   error   none; from_acc128: 2^-61 */
loft_sci loft_sci_of(loft_acc x);
loft_sci loft_sci_from_real(loft_real a);
loft_sci loft_sci_from_unit(loft_unit t);
loft_sci loft_sci_from_int(int32_t i);
loft_sci loft_sci_from_acc128(loft_acc128 x);

/* a + b, a - b, a b, a / b for b != 0, the square root of a >= 0. */
loft_sci loft_sci_add(loft_sci a, loft_sci b);
loft_sci loft_sci_sub(loft_sci a, loft_sci b);
loft_sci loft_sci_mul(loft_sci a, loft_sci b);
loft_sci loft_sci_div(loft_sci a, loft_sci b);
loft_sci loft_sci_sqrt(loft_sci a);

static inline loft_sci loft_sci_neg(loft_sci a)
{
    a.minus = !a.minus;
    return a;
}
static inline int loft_sci_sign(loft_sci a)     { return a.m ? a.minus ? -1 : 1 : 0; }

/* x as an acc, rounded to 2^-32. Returns false, and leaves *out untouched, if it does not fit. */
bool loft_sci_to_acc(loft_sci x, loft_acc *out) LOFT_CHECKED;

#else

typedef double loft_sci;

#define LOFT_SCI_BITS 53

static inline loft_sci loft_sci_zero(void)                      { return 0; }
static inline loft_sci loft_sci_one(void)                       { return 1; }
static inline loft_sci loft_sci_of(loft_acc x)                  { return x; }
static inline loft_sci loft_sci_from_real(loft_real a)          { return (loft_sci)a; }
static inline loft_sci loft_sci_from_unit(loft_unit t)          { return (loft_sci)t; }
static inline loft_sci loft_sci_from_int(int32_t i)             { return i; }
static inline loft_sci loft_sci_from_acc128(loft_acc128 x)          { return x; }
static inline loft_sci loft_sci_add(loft_sci a, loft_sci b)     { return a + b; }
static inline loft_sci loft_sci_sub(loft_sci a, loft_sci b)     { return a - b; }
static inline loft_sci loft_sci_mul(loft_sci a, loft_sci b)     { return a * b; }
static inline loft_sci loft_sci_div(loft_sci a, loft_sci b)     { return a / b; }
static inline loft_sci loft_sci_neg(loft_sci a)                 { return -a; }
static inline int loft_sci_sign(loft_sci a)                     { return (a > 0) - (a < 0); }

static inline bool loft_sci_to_acc(loft_sci x, loft_acc *out)
{
    if (!(x >= -DBL_MAX && x <= DBL_MAX))
        return false;
    *out = x;
    return true;
}

/*   error   1/2 ulp; 0 of a negative a */
loft_sci loft_sci_sqrt(loft_sci a);

#endif

static inline loft_sci loft_sci_abs(loft_sci a)
{
    return loft_sci_sign(a) < 0 ? loft_sci_neg(a) : a;
}
static inline bool loft_sci_less(loft_sci a, loft_sci b)
{
    return loft_sci_sign(loft_sci_sub(a, b)) < 0;
}

static inline loft_sci loft_sci_larger(loft_sci a, loft_sci b)
{
    return loft_sci_less(a, b) ? b : a;
}
static inline loft_sci loft_sci_smaller(loft_sci a, loft_sci b)
{
    return loft_sci_less(b, a) ? b : a;
}

/* x - a b.
 *
 *   error   2 roundings */
static inline loft_sci loft_sci_sub_product(loft_sci x, loft_sci a, loft_sci b)
{
    return loft_sci_sub(x, loft_sci_mul(a, b));
}

/* *sum += a b.
 *
 *   error   2 roundings */
static inline void loft_sci_add_product(loft_sci *sum, loft_sci a, loft_sci b)
{
    *sum = loft_sci_add(*sum, loft_sci_mul(a, b));
}

/* The scalar product of vectors in space, and a x b, which is neither of them.
 *
 *   error   5 roundings of the sum of the sizes of the products; 3 for each component */
static inline loft_sci loft_sci_dot3(const loft_sci a[3], const loft_sci b[3])
{
    return loft_sci_add(loft_sci_add(loft_sci_mul(a[0], b[0]), loft_sci_mul(a[1], b[1])),
                        loft_sci_mul(a[2], b[2]));
}
static inline void loft_sci_cross3(const loft_sci a[3], const loft_sci b[3], loft_sci out[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = loft_sci_sub_product(loft_sci_mul(a[i], b[j]), a[j], b[i]);
    }
}

/* x + (y - x) t.
 *
 *   error   3 roundings */
static inline loft_sci loft_sci_lerp(loft_sci x, loft_sci y, loft_sci t)
{
    return loft_sci_add(x, loft_sci_mul(loft_sci_sub(y, x), t));
}

/* The derivative of this order at t of the polynomial with `degree` + 1 Bernstein coefficients,
 * which are overwritten. Order 0 is the value; beyond the degree it is 0.
 *
 *   range   degree 0..9
 *   error   order + 3 (degree - order) + 2 roundings, each of the largest difference of that order
 *   cost    degree (degree + 1) / 2 lerps
 */
loft_sci loft_sci_deriv(loft_sci c[], unsigned degree, unsigned order, loft_sci t);

/* a^k; 1 for k = 0, even if a = 0.
 *
 *   error   2 k roundings
 *   cost    at most 2 log2 k products
 */
loft_sci loft_sci_pow(loft_sci a, unsigned k);

/* True if x is a parameter in 0..1 that a loft_unit represents exactly; it is stored in *t.
 *
 *   error   none */
bool     loft_sci_is_unit(loft_sci x, loft_unit *t) LOFT_CHECKED;

/* The nearest parameter.
 *
 *   range   |x| <= 100
 *   error   q16: 2^-25 + 2^-32   f32: 2^-25 of it   f64: none
 */
loft_unit loft_sci_to_unit(loft_sci x);

/* 2^k.
 *
 *   range   k = -1000..1000
 *   error   none
 */
loft_sci loft_sci_power2(int k);

/* The cross product of b - a and d - c in the plane: twice the area of the triangle a b d if c = a.
 * The sign is exact.
 *
 *   range   f32, f64: coordinates that pass loft_exact_valid
 *   error   q16: 2^-61   f32, f64: 2^-47 of the result, however close to parallel
 *   cost    q16: 2 products of 33 bits   f32, f64: 2 products, 12 more if they cancel to 1/16; four
 *           products and a quotient of num/exact.h if they cancel to 2^-50 or the differences are
 *           not doubles
 *   see     Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
 *           predicates (1997): the floating-point filter
 */
loft_sci loft_sci_cross(const loft_real a[2], const loft_real b[2], const loft_real c[2],
                        const loft_real d[2]);

LOFT_END_C

#endif

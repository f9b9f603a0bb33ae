/* lib/num/floats.h -- the operations that the float and the double backend share
 * SPDX-License-Identifier: MIT
 *
 * Included by f32.h and f64.h after their types. Each operation is one to four correctly rounded
 * IEEE operations, and the compiler must not reorder them. "ulp" is one of loft_real for functions
 * that return a real or a unit, one of double for those that return an acc. It is an ulp of the
 * result unless stated. Results must stay within the normal numbers of their type.
 */
#ifndef LOFT_NUM_FLOATS_H
#define LOFT_NUM_FLOATS_H

/* The bounds count one rounding per operation; an x87 rounds to 64 bits first. */
#if FLT_EVAL_METHOD == 2
#  error "f32 and f64 on a 32-bit x86 need SSE2: compile with -msse2 -mfpmath=sse"
#endif

#define LOFT_REAL(x)   ((loft_real)(x))
#define LOFT_UNIT(x)   ((loft_unit)(x))
/* the distance between neighbouring coordinates; 0 in floats */
#define LOFT_REAL_LSB  ((loft_real)0)

/* error none */
static inline loft_acc  loft_to_acc(loft_real a)                  { return (loft_acc)a; }

/* error f32: none   f64: 1/2 ulp */
static inline loft_acc loft_prod(loft_real a, loft_real b) { return (loft_acc)a * (loft_acc)b; }

/* True if x rounds into a real. (The half ulp of f32 above LOFT_REAL_MAX, and NaN, are not
 * covered.) */
static inline bool      loft_acc_valid(loft_acc x)
{
    return x <= (loft_acc)LOFT_REAL_MAX && x >= -(loft_acc)LOFT_REAL_MAX;
}

/* True if it is finite. f64: below 2^1000, so that no sum or small multiple overflows. */
static inline bool      loft_real_valid(loft_real a)
{
    return a >= -LOFT_REAL_REACH && a <= LOFT_REAL_REACH;
}

/* Between once and twice the distance between neighbouring numbers up to that size; exact at powers
 * of two. */
static inline loft_acc  loft_acc_ulp(loft_acc size)           { return size * DBL_EPSILON; }
static inline loft_acc loft_real_ulp(loft_acc size) { return size * (loft_acc)LOFT_REAL_EPSILON; }

/* An upper bound of the error of loft_acc_hypot for that result. */
static inline loft_acc loft_hypot_ulp(loft_acc length) { return length * (4 * DBL_EPSILON); }

/* error f32: 1/2 ulp   f64: none */
static inline loft_real loft_acc_round(loft_acc x)              { return (loft_real)x; }

/* error 1/2, ties upward; -2^31 <= x < 2^31 - 1/2. Truncation toward zero comes first: the
 * remainder is then exact. */
static inline int32_t   loft_acc_int(loft_acc x)
{
    const int32_t i = (int32_t)x;
    const loft_acc rest = x - (loft_acc)i;
    return rest >= 0.5 ? i + 1 : rest < -0.5 ? i - 1 : i;
}
static inline int32_t loft_prod_int(loft_real a, loft_real b)
{
    return loft_acc_int(loft_prod(a, b));
}

/* error 1/2 ulp */
static inline loft_real loft_mul(loft_real a, loft_real b)      { return a * b; }
static inline loft_real loft_div(loft_real a, loft_real b)      { return a / b; }

/* error 2 ulp of the larger of |a|, |b|: 1/2 in 1 - t, 1/2 and 1/4 in the products, 1/2 in the sum;
 * none at t = 0 and 1. t in 0..1 */
static inline loft_real loft_lerp(loft_real a, loft_real b, loft_unit t)
{
    return (1 - t) * a + t * b;
}

/* error 1/2 ulp */
static inline loft_acc  loft_acc_scale(loft_acc x, loft_unit t) { return x * (loft_acc)t; }

/* error 2 ulp of the larger of |x|, |y|; none at t = 0 and 1. t in 0..1 */
static inline loft_acc  loft_acc_lerp(loft_acc x, loft_acc y, loft_unit t)
{
    return (1 - (loft_acc)t) * x + (loft_acc)t * y;
}

/* error 3 ulp of the largest of |x|, |y|, |z|, times |1 - v - w| + |v| + |w|; none at the corners.
 * The weight of x has one rounding error of 1 and one of 1 - v */
static inline loft_acc  loft_acc_lerp3(loft_acc x, loft_acc y, loft_acc z, loft_unit v, loft_unit w)
{
    return (1 - (loft_acc)v - (loft_acc)w) * x + (loft_acc)v * y + (loft_acc)w * z;
}

/* error none */
static inline loft_real loft_real_abs(loft_real a)            { return a < 0 ? -a : a; }
static inline loft_acc  loft_acc_abs(loft_acc x)              { return x < 0 ? -x : x; }
static inline loft_acc  loft_acc_min(loft_acc x, loft_acc y) { return x < y ? x : y; }
static inline loft_acc  loft_acc_max(loft_acc x, loft_acc y)  { return x > y ? x : y; }

/* error 1/2 ulp */
static inline loft_acc  loft_acc_mean(loft_acc x, loft_acc y)   { return (x + y) * 0.5; }

/* error 3 ulp of the larger of |x|, |y|, for j above n times j / n; none at j = 0 and n. n >= 1 */
static inline loft_acc  loft_acc_lerp_at(loft_acc x, loft_acc y, uint32_t j, uint32_t n)
{
    const loft_acc t = (loft_acc)j / (loft_acc)n;
    return (1 - t) * x + t * y;
}

/* error 1/2 ulp */
static inline loft_acc  loft_acc_mul(loft_acc x, loft_real a)   { return x * (loft_acc)a; }
static inline loft_acc  loft_acc_div(loft_acc x, loft_real a)   { return x / (loft_acc)a; }
static inline loft_acc  loft_acc_ratio(loft_acc x, int32_t k)   { return x / (loft_acc)k; }

/* error f32: 0.5001 ulp (rounded twice)   f64: 1/2 ulp; j <= n, n >= 1 */
static inline loft_unit loft_unit_of(uint32_t j, uint32_t n)
{
    return (loft_unit)((loft_acc)j / (loft_acc)n);
}

/* error f32: 0.5001 ulp (rounded twice)   f64: 1/2 ulp; y > 0 */
static inline loft_unit loft_unit_ratio(loft_acc x, loft_acc y) { return (loft_unit)(x / y); }

/* error none */
static inline loft_unit loft_unit_from(loft_real a)             { return a; }

/* error f32: 1/2 ulp   f64: none */
static inline loft_unit loft_unit_round(loft_acc x)             { return (loft_unit)x; }

/* exact */
static inline loft_acc  loft_unit_to_acc(loft_unit t)             { return (loft_acc)t; }

/* raw Q16.16; error from real: 2^-17, to real: f32 1/2 ulp, f64 none; range: see loft_raw_valid */
static inline bool      loft_raw_valid(loft_real a)
{
    return (double)a * 65536 > -2147483648.5 && (double)a * 65536 < 2147483647.5;
}
static inline int32_t loft_raw_from_real(loft_real a)
{
    return (int32_t)((double)a * 65536 + (a < 0 ? -0.5 : 0.5));
}
static inline loft_real loft_real_from_raw(int32_t raw) 
{
    return (loft_real)raw * (loft_real)(1 / 65536.0);
}

/* error none for |i| <= 2^24, f32: 1/2 ulp above */
static inline loft_real loft_real_from_int(int32_t i)           { return (loft_real)i; }

/* x y - p, where p is the rounded product: the factors are split into 26-bit halves with exact
 * products (Dekker 1971). error none; |x|, |y| < 2^996, |p| > 2^-968 */
static inline double    loft_product_tail(double x, double y, double p)
{
    const double cut = 134217729.0, xc = x * cut, yc = y * cut;
    const double xh = xc - (xc - x), xl = x - xh, yh = yc - (yc - y), yl = y - yh;

    return xl * yl - (((p - xh * yh) - xl * yh) - xh * yl);
}

/* (a - b) - d, where d is the rounded difference (Knuth 1969). error none */
static inline double    loft_difference_tail(double a, double b, double d)
{
    const double t = d - a;
    return (a - (d - t)) + (-b - t);
}

/* Each weight has a relative error of 3 roundings, its product one more, and the sum is the fifth.
 * Neither weight is computed as 1 minus the other: if values of one sign differ greatly, the small
 * one keeps all its digits. */
static inline loft_acc loft_acc_lerp_in(loft_acc x, loft_acc y, loft_real a, loft_real lo,
                                        loft_real hi)
{
    const loft_acc length = loft_to_acc(hi) - loft_to_acc(lo);

    return (loft_to_acc(hi) - loft_to_acc(a)) / length * x +
           (loft_to_acc(a) - loft_to_acc(lo)) / length * y;
}

/* error none; |a| < 2^31 */
static inline int32_t   loft_real_floor(loft_real a)
{
    const int32_t i = (int32_t)a;
    return (loft_real)i > a ? i - 1 : i;
}

#endif

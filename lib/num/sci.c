/* lib/num/sci.c
 * SPDX-License-Identifier: MIT
 */
#include "num/sci.h"
#include "num/exact.h"  /* loft_exact_det, if doubles cancel    */

#if LOFT_NUM == LOFT_Q16

#define TOP 62          /* the highest bit of m */

/* Normalise m with 32 bits below it, times 2^e; lower bits are truncated. */
static loft_sci normal_form(uint64_t m, uint32_t below, int e, bool minus)
{
    loft_sci r;

    if (!(m >> 32)) {
        m = m << 32 | below;
        below = 0;
        e -= 32;
    }
    for (unsigned step = 16; step; step /= 2)
        while (m && !(m >> (TOP + 1 - step))) {
            m = m << step | below >> (32 - step);
            below <<= step;
            e -= (int)step;
        }
    if (m >> (TOP + 1)) {
        m >>= 1;
        e++;
    }
    r.m = m;
    r.e = (int16_t)e;
    r.minus = minus;
    return r;
}

loft_sci loft_sci_of(loft_acc x)            { return normal_form(loft_acc_size(x), 0, -32, x < 0); }
loft_sci loft_sci_from_real(loft_real a)    { return normal_form(loft_acc_size(a), 0, -16, a < 0); }
loft_sci loft_sci_from_unit(loft_unit t)    { return normal_form(loft_acc_size(t), 0, -24, t < 0); }
loft_sci loft_sci_from_int(int32_t i)       { return normal_form(loft_acc_size(i), 0, 0, i < 0); }

/* The highest nonzero limb and the two below it hold at least 65 bits, or all bits of x. */
loft_sci loft_sci_from_acc128(loft_acc128 x)
{
    const loft_acc128 zero = { { 0 } };
    const bool minus = x.limb[3] >> 31 != 0;
    int top = 3;

    if (minus)
        x = loft_acc128_sub(zero, x);
    while (top > 2 && !x.limb[top])
        top--;
    if (!x.limb[top])
        return normal_form((uint64_t)x.limb[1] << 32 | x.limb[0], 0, -32, minus);
    return normal_form((uint64_t)x.limb[top] << 32 | x.limb[top - 1], x.limb[top - 2],
                       32 * (top - 1) - 32, minus);
}

/* The smaller number is truncated to the exponent of the larger one. A difference uses 32 more
 * bits: they are all that remains of it in the case in which they matter, when the first bits
 * cancel. */
loft_sci loft_sci_add(loft_sci a, loft_sci b)
{
    if (!a.m || (b.m && b.e > a.e)) {
        const loft_sci c = a;
        a = b;
        b = c;
    }
    if (!b.m)
        return a;
    const int down = a.e - b.e;
    const uint64_t m = down < 64 ? b.m >> down : 0;
    if (a.minus == b.minus)
        return normal_form(a.m + m, 0, a.e, a.minus);
    if (a.m <= m)               /* then down is 0 */
        return a.m == m ? loft_sci_zero() : normal_form(m - a.m, 0, a.e, b.minus);
    const uint32_t lost = down > 0 && down < 64 ? (uint32_t)(b.m << (64 - down) >> 32) : 0;
    return normal_form(a.m - m - (lost != 0), 0u - lost, a.e, a.minus);
}

loft_sci loft_sci_sub(loft_sci a, loft_sci b) { return loft_sci_add(a, loft_sci_neg(b)); }

/* The upper 64 of 126 bits, at least 2^60, and the 32 bits below them. */
loft_sci loft_sci_mul(loft_sci a, loft_sci b)
{
    const uint64_t a1 = a.m >> 32, a0 = a.m & 0xffffffffu, b1 = b.m >> 32, b0 = b.m & 0xffffffffu;
    const uint64_t low = a1 * b0 + (a0 * b0 >> 32), cross = a0 * b1 + (low & 0xffffffffu);
    const uint64_t m = a1 * b1 + (low >> 32) + (cross >> 32);

    if (!m)
        return loft_sci_zero();
    return normal_form(m, (uint32_t)(cross & 0xffffffffu), a.e + b.e + 64, a.minus != b.minus);
}

/* a.m / b.m > 1/2: the first round gives the integer part, 62 more give the bits below. */
loft_sci loft_sci_div(loft_sci a, loft_sci b)
{
    uint64_t q = 0, rest = a.m;

    if (!a.m)
        return a;
    for (int round = 0; round <= TOP; round++) {
        q += q;
        if (rest >= b.m) {
            rest -= b.m;
            q++;
        }
        rest += rest;
    }
    return normal_form(q, 0, a.e - b.e - TOP, a.minus != b.minus);
}

/* The root of m 2^58 for an even exponent e: 61 bits, two bits of the radicand per round. Before a
 * round the root r is below 2^60 and the remainder is at most 2 r, so neither exceeds 64 bits. */
loft_sci loft_sci_sqrt(loft_sci a)
{
    const bool odd = a.e % 2 != 0;
    uint64_t m = odd ? a.m << 1 : a.m, r = 0, rest = 0;

    if (!m)
        return a;
    for (int round = 0; round < 61; round++) {
        rest = rest << 2 | m >> 62;
        m <<= 2;
        r += r;
        if (rest > 2 * r) {
            rest -= 2 * r + 1;
            r++;
        }
    }
    return normal_form(r, 0, (a.e - odd - 58) / 2, false);
}

bool loft_sci_to_acc(loft_sci x, loft_acc *out)
{
    const int down = -(x.e + 32);

    if (x.m && down < 0)
        return false;
    const uint64_t size = !x.m || down > 63 ? 0 : down ? ((x.m >> (down - 1)) + 1) >> 1 : x.m;
    *out = x.minus ? -(int64_t)size : (int64_t)size;
    return true;
}

/* 24 bits below the binary point: m must be a multiple of 2^(-24 - e). */
bool loft_sci_is_unit(loft_sci x, loft_unit *t)
{
    const int down = -(x.e + 24);

    if (!x.m) {
        *t = 0;
        return true;
    }
    if (x.minus || down < TOP - 24 || down > TOP || (x.m & (((uint64_t)1 << down) - 1)) ||
        x.m >> down > 16777216)
        return false;
    *t = (loft_unit)(x.m >> down);
    return true;
}

/* Each difference has 32 bits and a sign, each product 64, and the difference of products 65. */
static loft_acc128 signed_product(int64_t x, int64_t y)
{
    const loft_acc128 size = loft_acc128_times(loft_acc128_of((int64_t)loft_acc_size(x)),
                                               (uint32_t)loft_acc_size(y)),
                      zero = { { 0 } };
    return (x < 0) != (y < 0) ? loft_acc128_sub(zero, size) : size;
}

loft_sci loft_sci_cross(const loft_real a[2], const loft_real b[2], const loft_real c[2],
                        const loft_real d[2])
{
    const int64_t ux = (int64_t)b[0] - a[0], uy = (int64_t)b[1] - a[1];
    const int64_t vx = (int64_t)d[0] - c[0], vy = (int64_t)d[1] - c[1];

    return loft_sci_from_acc128(loft_acc128_sub(signed_product(ux, vy), signed_product(uy, vx)));
}

#else

#if defined(__SSE2__) && defined(__SSE2_MATH__)

/* It rounds to nearest. Without -fno-math-errno gcc would call libm. */
static double root_of(double x)
{
    double r;
    __asm__("sqrtsd %1, %0" : "=x"(r) : "x"(x));
    return r;
}

#elif defined(__AARCH64EL__)

static double root_of(double x)
{
    double r;
    __asm__("fsqrt %d0, %d1" : "=w"(r) : "w"(x));
    return r;
}

#else

/* Newton's iteration for the reciprocal square root would need a table; halving the exponent by
 * comparisons keeps this freestanding. x is scaled by powers of 4 into [1, 4). There Heron's steps
 * from r = (1 + x) / 2 (relative error at most 1/4, at x = 4) have errors of 1/40, 2^-11, 2^-24,
 * 2^-49, 2^-100.
 *
 * r is then off by less than 1 ulp, u = 2^-52. The rest x - r^2 is exact, a multiple of 2^-104, as
 * r u is. The root lies above the middle of r and its upper neighbour if rest > r u + u^2 / 4, that
 * is if rest > r u; below that of the lower one if rest <= -r u. */
static double root_of(double x)
{
    const double ulp = 1.0 / 4503599627370496.0;
    double scale = 1;

    while (x >= 4) {
        x *= 0.25;
        scale *= 2;
    }
    while (x < 1) {
        x *= 4;
        scale *= 0.5;
    }

    double r = 0.5 * (1 + x);
    for (int i = 0; i < 5; i++)
        r = 0.5 * (r + x / r);
    const double square = r * r, rest = (x - square) - loft_product_tail(r, r, square);
    if (rest > r * ulp)
        r += ulp;
    else if (rest <= -r * ulp)
        r -= ulp;
    return r * scale;
}

#endif

loft_sci loft_sci_sqrt(loft_sci x)
{
    if (!(x > 0))
        return 0;
    return x > DBL_MAX ? x : root_of(x);
}

bool loft_sci_is_unit(loft_sci x, loft_unit *t)
{
    if (!(x >= 0 && x <= 1) || (double)(loft_unit)x < x || (double)(loft_unit)x > x)
        return false;
    *t = (loft_unit)x;
    return true;
}

static loft_exact exact_difference(loft_real a, loft_real b)
{
    return loft_exact_sub(loft_exact_from_real(b), loft_exact_from_real(a));
}

/* Each difference has a relative error of 2^-53, each product three times that. The error of p - q
 * is 3 * 2^-53 of |p| + |q|, which is 48 * 2^-53 of a result that is 1/16 of this sum. Below that,
 * p - q is exact (Sterbenz). What is missing are the tails of the products, and those of the
 * differences times the other factors: each at most 2^-53 of |p| + |q|, and rounded. Two tails
 * times each other are left out. All this errs by less than 2^-100 of |p| + |q|, which is 2^-55 of
 * a result that is 2^-45 of this sum. Below that everything is exact except for one quotient. */
loft_sci loft_sci_cross(const loft_real a[2], const loft_real b[2], const loft_real c[2],
                        const loft_real d[2])
{
    const double ux = (double)b[0] - (double)a[0], uy = (double)b[1] - (double)a[1];
    const double vx = (double)d[0] - (double)c[0], vy = (double)d[1] - (double)c[1];
    const double p = ux * vy, q = uy * vx, size = (p < 0 ? -p : p) + (q < 0 ? -q : q);
    double cross = p - q;
    loft_acc exact = 0;

    if ((cross < 0 ? -cross : cross) >= size * 0.0625)
        return cross;
    const double tails = (loft_product_tail(ux, vy, p) - loft_product_tail(uy, vx, q)) +
                         (ux * loft_difference_tail((double)d[1], (double)c[1], vy) -
                          uy * loft_difference_tail((double)d[0], (double)c[0], vx)) +
                         (vy * loft_difference_tail((double)b[0], (double)a[0], ux) -
                          vx * loft_difference_tail((double)b[1], (double)a[1], uy));
    cross += tails;
    if ((cross < 0 ? -cross : cross) >= size * 0x1p-45)
        return cross;
    const loft_exact det = loft_exact_det(
        exact_difference(a[0], b[0]), exact_difference(a[1], b[1]), exact_difference(c[0], d[0]),
        exact_difference(c[1], d[1]));
    return loft_exact_quot(det, loft_exact_from_int(1), -2 * LOFT_EXACT_REAL, &exact) ? exact
                                                                                      : cross;
}

#endif

loft_sci loft_sci_deriv(loft_sci c[], unsigned degree, unsigned order, loft_sci t)
{
    int32_t factor = 1;

    if (order > degree)
        return loft_sci_zero();
    for (; order > 0; order--, degree--) {
        factor *= (int32_t)degree;
        for (unsigned i = 0; i < degree; i++)
            c[i] = loft_sci_sub(c[i + 1], c[i]);
    }
    for (; degree > 0; degree--)
        for (unsigned i = 0; i < degree; i++)
            c[i] = loft_sci_lerp(c[i], c[i + 1], t);
    return loft_sci_mul(c[0], loft_sci_from_int(factor));
}

loft_sci loft_sci_pow(loft_sci a, unsigned k)
{
    loft_sci r = loft_sci_one();

    for (; k; k >>= 1) {
        if (k & 1)
            r = loft_sci_mul(r, a);
        if (k > 1)
            a = loft_sci_mul(a, a);
    }
    return r;
}

loft_unit loft_sci_to_unit(loft_sci x)
{
    loft_acc t = 0;

    return loft_sci_to_acc(x, &t) ? loft_unit_ratio(t, loft_to_acc(LOFT_REAL(1))) : 0;
}

loft_sci loft_sci_power2(int k)
{
    const loft_sci one = loft_sci_one(), two = loft_sci_from_int(2);
    const loft_sci p = loft_sci_pow(two, (unsigned)(k < 0 ? -k : k));

    return k < 0 ? loft_sci_div(one, p) : p;
}

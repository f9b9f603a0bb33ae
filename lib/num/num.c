/* lib/num/num.c -- the operations that are too long to be inline
 * SPDX-License-Identifier: MIT
 */
#include "num/num.h"
#include "num/sci.h"    /* loft_sci_sqrt, of doubles */


// Roots of whole numbers
// ----------------------

#if !defined(__AVR__)

/* 2^8 / sqrt(h / 2^32) - 2^8 for h = (k + 32.5) 2^25, to nearest: the first 9 bits of the inverse
 * root of every h from 2^30 on, within 2^-6.8 of it. */
static const uint8_t seed[96] = { 252, 244, 237, 230, 223, 217, 211, 205, 199, 194, 188, 183,
                                  178, 173, 169, 164, 160, 156, 152, 148, 144, 140, 136, 133,
                                  129, 126, 123, 119, 116, 113, 110, 107, 105, 102, 99,  97,
                                  94,  91,  89,  87,  84,  82,  80,  77,  75,  73,  71,  69,
                                  67,  65,  63,  61,  59,  57,  55,  54,  52,  50,  48,  47,
                                  45,  44,  42,  40,  39,  37,  36,  34,  33,  31,  30,  29,
                                  27,  26,  25,  23,  22,  21,  20,  18,  17,  16,  15,  13,
                                  12,  11,  10,  9,   8,   7,   6,   5,   4,   3,   2,   1 };

/* a b. A Cortex-M0 multiplies to 32 bits alone; libgcc's product of 64 bits takes twice as long. */
static inline uint64_t product(uint32_t a, uint32_t b)
{
#if defined(__ARM_ARCH_6M__)
    const uint32_t a0 = a & 0xffff, a1 = a >> 16, b0 = b & 0xffff, b1 = b >> 16;
    const uint32_t low = a0 * b0, left = a1 * b0 + (low >> 16), right = a0 * b1 + (left & 0xffff);

    return (uint64_t)(a1 * b1 + (left >> 16) + (right >> 16)) << 32 |
           (right << 16 | (low & 0xffff));
#else
    return (uint64_t)a * b;
#endif
}

/* a b / 2^32, rounded down */
static uint32_t high(uint32_t a, uint32_t b) { return (uint32_t)(product(a, b) >> 32); }

/* 2^30 / sqrt(h / 2^32), for h >= 2^30: too small by 2^-25 of it at most, and never too large.
 *
 * Two steps of Newton, y <- y (3 - h y^2) / 2, for which y (1 - e) becomes at most y (1 - 1.5 e^2 +
 * 0.5 e^3) <= y. The first has numbers of 32 bits alone, and an error below 2^-13; the second
 * takes two units less than 3, as its two products are rounded down by less than one each. */
static uint32_t inverse_root(uint32_t h)
{
    const uint32_t rough = UINT32_C(256) + seed[(h >> 25) - 32];
    const uint32_t first = 3 * ((uint32_t)1 << 30) - rough * rough * (h >> 18);     /* 2^30 */
    const uint32_t y = 2 * rough * (first >> 10);                                   /* 2^30 y */
    const uint32_t second = 3 * ((uint32_t)1 << 28) - 2 - high(high(y, y), h);      /* 2^28 */

    return (uint32_t)(product(y, second) >> 29);
}

/* x is multiplied by a power of 4 until it is 2^62 at least; its root s by one of 2. With the
 * inverse i of the root of its high half, root <= s by at most 2^7. Then root + (x - root^2) i / 2
 * is too small by less than 1 + 2^-16: by rounding down, and by dividing by 2 s instead of s +
 * root. So the last comparison finds what is missing. */
uint32_t loft_root(uint64_t x)
{
    uint8_t down = 0;

    if (x == 0)
        return 0;
    for (uint8_t bits = 32; bits > 1; bits /= 2)
        if (x >> (64 - bits) == 0) {
            x <<= bits;
            down = (uint8_t)(down + bits / 2);
        }
    const uint32_t h = (uint32_t)(x >> 32), inverse = inverse_root(h);
    uint32_t root = (uint32_t)(product(inverse, h) >> 30);
    const uint32_t rest = (uint32_t)((x - product(root, root)) >> 12);      /* below 2^29 */
    root += (uint32_t)(product(rest, inverse) >> 51);
    root += x - product(root, root) > 2 * (uint64_t)root;
    return root >> down;
}

/* x > (r + 1/2)^2 = r^2 + r + 1/4 */
uint32_t loft_root_nearest(uint64_t x)
{
    const uint32_t r = loft_root(x);
    return r + (x - product(r, r) > r);
}

#endif


// Operations of the number type
// -----------------------------

#if LOFT_NUM == LOFT_Q16

#if defined(__ARM_ARCH_6M__)
loft_acc loft_m0_scale(loft_acc x, loft_unit t)
{
    const uint32_t size = t < 0 ? 0u - (uint32_t)t : (uint32_t)t;
    const int32_t top = loft_acc_high(x);
    const int64_t low = (int64_t)product(loft_acc_low(x), size),
                  high = (int64_t)(product((uint32_t)top, size) -
                                   (top < 0 ? (uint64_t)size << 32 : 0));

    return (t < 0 ? -high : high) * 256 + loft_shift_24((t < 0 ? -low : low) + 8388608);
}
#endif

/* sqrt(X / 2^32) = sqrt(X) / 2^16: the raw root is the root of the raw number. */
loft_real loft_acc_sqrt(loft_acc x)
{
    if (x <= 0)
        return 0;
    const uint32_t r = loft_root_nearest((uint64_t)x);
    return r >= INT32_MAX ? INT32_MAX : (loft_real)r;
}

#if !defined(__AVR__)

/* The number of bits to shift x down so that it is below 2^(32 + bits). */
static uint8_t bits_above(uint64_t x, uint8_t bits)
{
    uint8_t down = 0;

    for (uint32_t top = (uint32_t)loft_acc_high((int64_t)x) >> bits; top; top >>= 1)
        down++;
    return down;
}

/* With y below 2^38 the quotient has all 24 bits. A larger y is shifted down together with x, which
 * loses low bits: 2^-37 of y each. */
loft_unit loft_unit_ratio(loft_acc x, loft_acc y)
{
    uint64_t n = loft_acc_size(x), d = (uint64_t)y;
    const uint8_t down = bits_above(d, 6);

    n >>= down;
    d >>= down;
    const int32_t q = (int32_t)(((n << 24) + (d >> 1)) / d);
    return x < 0 ? -q : q;
}

/* Both are halved until x < 2^47. Then y >= 2^31, and the bits lost are less than 2^-30 of it. */
loft_real loft_acc_quot(loft_acc x, loft_acc y)
{
    uint64_t n = loft_acc_size(x), d = (uint64_t)y;
    const uint8_t down = bits_above(n, 15);

    n >>= down;
    d >>= down;
    const uint32_t q = (uint32_t)(((n << 16) + (d >> 1)) / d);
    return (loft_real)(x < 0 ? 0u - q : q);
}

#endif

/* The number of bits of x. */
static uint8_t bits_of(uint64_t x)
{
#if defined(__AVR__)
    return loft_avr_bits(x);
#elif defined(__GNUC__)
    return (uint8_t)(x > 0 ? 64 - __builtin_clzll(x) : 0);
#else
    uint8_t bits = 0;

    for (; x >> 8; x >>= 8)
        bits = (uint8_t)(bits + 8);
    for (; x; x >>= 1)
        bits++;
    return bits;
#endif
}

/* x / 2^down to nearest, or times 2^-down */
static uint64_t shift(uint64_t x, int8_t down)
{
#if defined(__AVR__)
    return loft_avr_shift(x, down);
#else
    return down > 0 ? (x + ((uint64_t)1 << (down - 1))) >> down : x << -down;
#endif
}

/* All components are scaled alike, so that the largest, L, satisfies 2^29 <= L < 2^30 and six
 * squares sum to at most 6 * 2^60 < 2^63. If scaled down, each component is off by at most 1/2, the
 * result therefore by 1/2 sum |x_i| / |x|, and its root by another 1/2: together less than 1.29
 * units of 2^-29 L (the worst case with six: five are 0.29 L). If scaled up, nothing is lost before
 * the root. */
loft_acc loft_acc_hypot(const loft_acc x[], int n)
{
    uint64_t all = 0, sum = 0;

    for (int i = 0; i < n; i++)
        all |= loft_acc_size(x[i]);
    if (all == 0)
        return 0;
    const int8_t down = (int8_t)(bits_of(all) - 30);

    for (int i = 0; i < n; i++) {
        const int32_t size = (int32_t)shift(loft_acc_size(x[i]), down);
        sum += (uint64_t)loft_prod(size, size);
    }
    return (loft_acc)shift(loft_root_nearest(sum), (int8_t)-down);
}

/* There are n < 2^32 steps between lo and hi, and a is step j. |y - x| = q n + r with r < n, so q j
 * <= |y - x| < 2^63 and r j < 2^64. The result q j + r j / n is rounded once, ties away from x. */
loft_acc loft_acc_lerp_in(loft_acc x, loft_acc y, loft_real a, loft_real lo, loft_real hi)
{
    const uint32_t j = (uint32_t)a - (uint32_t)lo, n = (uint32_t)hi - (uint32_t)lo;
    const uint64_t size = y < x ? (uint64_t)x - (uint64_t)y : (uint64_t)y - (uint64_t)x;
    const uint64_t product = size % n * j;
    const uint32_t rest = (uint32_t)(product % n);
    const int64_t part = (int64_t)(size / n * j + product / n + (rest >= n - rest));

    return y < x ? x - part : x + part;
}

#else

loft_real loft_acc_sqrt(loft_acc x) { return (loft_real)loft_sci_sqrt(x); }

loft_real loft_acc_quot(loft_acc x, loft_acc y) { return (loft_real)(x / y); }

/* Where a square might overflow or underflow, the vector is scaled, by a power of two: so its size
 * does not matter to what is rounded. */
loft_acc loft_acc_hypot(const loft_acc x[], int n)
{
    loft_acc largest = 0, sum = 0;

    for (int i = 0; i < n; i++) {
        const loft_acc size = x[i] < 0 ? -x[i] : x[i];
        if (size > largest)
            largest = size;
        sum += x[i] * x[i];
    }
    if (largest < 1e150 && largest > 1e-140)
        return loft_sci_sqrt(sum);
    if (!(largest > 0))
        return 0;
    const loft_acc up = largest < 1 ? 0x1p600 : 0x1p-600;
    sum = 0;
    for (int i = 0; i < n; i++)
        sum += x[i] * up * (x[i] * up);
    return loft_sci_sqrt(sum) / up;
}

#endif

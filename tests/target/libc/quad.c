/* tests/target/libc/quad.c -- long double of 128 bits, if the compiler's library has none: for the
 * references of tests on a Cortex-M
 * SPDX-License-Identifier: MIT
 *
 * clang -Xclang -mlong-double-128 calls these functions, by these names. IEEE 754 binary128: sign,
 * 15 bits of exponent, 112 of mantissa; everything is rounded to nearest, ties to even.
 * quad_check.c compares it with gcc's __float128 on the host, bit for bit; there all names are
 * different.
 *
 * A finite number is m * 2^(e - BIAS - 112 - 3) with m of 116 bits: 113 bits of mantissa and three
 * more. The last one is sticky: it is set if any bit was cut off. An addition or a product cuts off
 * once and rounds once, in pack().
 */
#include <stdbool.h>
#include <stdint.h>

#ifndef QUAD
#  define QUAD(name) __##name
typedef long double quad;
#endif

__extension__ typedef unsigned __int128 uwide;
__extension__ typedef __int128 wide;

#define BIAS    16383
/* the first bit of a mantissa with three bits beyond it */
#define TOP     ((uwide)1 << 115)
/* the exponent of infinities and NaNs */
#define E_LAST  ((int)INT16_MAX)

struct parts {
    bool negative;
    int e;
    uwide m;
};

static int leading_zeros(uwide m)           /* m > 0 */
{
    const uint64_t high = (uint64_t)(m >> 64);
    return high ? __builtin_clzll(high) : 64 + __builtin_clzll((uint64_t)m);
}

static uwide shifted_right(uwide m, int n)  /* bits that are cut off stay as the sticky last bit */
{
    if (n <= 0)
        return m;
    if (n > 127)
        return m != 0;
    return m >> n | ((m & (((uwide)1 << n) - 1)) != 0);
}

static uwide bits_of(quad a)
{
    union {
        quad q;
        uwide bits;
    } u;
    u.q = a;
    return u.bits;
}

static quad quad_of(uwide bits)
{
    union {
        quad q;
        uwide bits;
    } u;
    u.bits = bits;
    return u.q;
}

static quad special(bool negative, bool number)
{
    return quad_of((uwide)negative << 127 | (uwide)E_LAST << 112 | (uwide)!number << 111);
}

static bool finite_(uwide bits) { return (int)(bits >> 112 & INT16_MAX) != E_LAST; }
static bool nan_(uwide bits)    { return bits << 1 > (uwide)E_LAST << 113; }

static struct parts unpack(uwide bits)
{
    struct parts p = { (bool)(bits >> 127), (int)(bits >> 112 & INT16_MAX), bits << 16 >> 13 };

    if (p.e) {
        p.m |= TOP;
    } else if (p.m) {
        const int n = leading_zeros(p.m) - 12;
        p.m <<= n;
        p.e = 1 - n;
    } else {
        p.e = -BIAS;                            /* zero is below all other numbers */
    }
    return p;
}

/* The number nearest to m * 2^(e - BIAS - 115), for any m below 2^127. */
static quad pack(bool negative, int e, uwide m)
{
    if (m == 0)
        return quad_of((uwide)negative << 127);
    const int n = leading_zeros(m) - 12;
    m = n < 0 ? shifted_right(m, -n) : m << n;
    e -= n;
    if (e <= 0) {
        m = shifted_right(m, 1 - e);
        e = m >> 115 != 0;
    }
    const unsigned beyond = (unsigned)(m & 7);
    m >>= 3;
    m += beyond > 4 || (beyond == 4 && (m & 1));
    if (m >> 113) {
        m >>= 1;
        e++;
    }
    if (e == 0 && m >> 112)                     /* the largest subnormal number has become a normal
                                                 * one */
        e = 1;
    if (e >= E_LAST)
        return special(negative, true);
    return quad_of((uwide)negative << 127 | (uwide)e << 112 | (m & (((uwide)1 << 112) - 1)));
}


// Sums, products, quotients
// -------------------------

quad QUAD(addtf3)(quad x, quad y);
quad QUAD(subtf3)(quad x, quad y);
quad QUAD(multf3)(quad x, quad y);
quad QUAD(divtf3)(quad x, quad y);

quad QUAD(addtf3)(quad x, quad y)
{
    const uwide a = bits_of(x), b = bits_of(y);

    if (!finite_(a) || !finite_(b)) {
        if (nan_(a) || nan_(b) || (!finite_(a) && !finite_(b) && a != b))
            return special(false, false);
        return finite_(a) ? y : x;
    }
    struct parts p = unpack(a), q = unpack(b);
    if (p.e < q.e || (p.e == q.e && p.m < q.m)) {
        const struct parts other = p;
        p = q;
        q = other;
    }
    const uwide small = shifted_right(q.m, p.e - q.e);
    if (p.negative == q.negative)
        return pack(p.negative, p.e, p.m + small);
    return pack(p.m != small && p.negative, p.e, p.m - small);
}

quad QUAD(subtf3)(quad x, quad y) { return QUAD(addtf3)(x, quad_of(bits_of(y) ^ (uwide)1 << 127)); }

/* The upper 128 bits of a product of 256 bits; the last one is set if any lower bit is. */
static uwide upper_product(uwide a, uwide b)
{
    const uint64_t a1 = (uint64_t)(a >> 64), a0 = (uint64_t)a, b1 = (uint64_t)(b >> 64),
                   b0 = (uint64_t)b;
    const uwide low = (uwide)a0 * b0, mid = (uwide)a1 * b0 + (low >> 64),
                other = (uwide)a0 * b1 + (uint64_t)mid;

    return ((uwide)a1 * b1 + (mid >> 64) + (other >> 64)) | ((uint64_t)other || (uint64_t)low);
}

quad QUAD(multf3)(quad x, quad y)
{
    const uwide a = bits_of(x), b = bits_of(y);
    const bool negative = (a ^ b) >> 127;

    if (!finite_(a) || !finite_(b)) {
        if (nan_(a) || nan_(b) || a << 1 == 0 || b << 1 == 0)
            return special(false, false);
        return special(negative, true);
    }
    const struct parts p = unpack(a), q = unpack(b);
    /* the upper part of 2^243 is 2^115 */
    return pack(negative, p.e + q.e - BIAS, upper_product(p.m << 3, q.m << 10));
}

quad QUAD(divtf3)(quad x, quad y)
{
    const uwide a = bits_of(x), b = bits_of(y);
    const bool negative = (a ^ b) >> 127;
    uwide quotient = 0;

    if (nan_(a) || nan_(b) || (!finite_(a) && !finite_(b)) || (a << 1 == 0 && b << 1 == 0))
        return special(false, false);
    if (!finite_(a) || b << 1 == 0)
        return special(negative, true);
    if (!finite_(b) || a << 1 == 0)
        return quad_of((uwide)negative << 127);
    const struct parts p = unpack(a), q = unpack(b);
    uwide rest = p.m;
    for (int n = 0; n < 4; n++) {               /* 29 bits each, too small by at most a few: rest <
                                                 * 4 q.m again */
        const uint64_t digit = (uint64_t)(rest >> 55) / ((uint64_t)(q.m >> 84) + 1);
        quotient = (quotient << 29) + digit;
        rest = (rest << 29) - digit * q.m;      /* the part that wraps is above the difference */
    }
    for (; rest >= q.m; quotient++)
        rest -= q.m;
    return pack(negative, p.e - q.e + BIAS - 1, quotient | (rest != 0));
}


// Which is greater
// ----------------

int QUAD(eqtf2)(quad x, quad y);
int QUAD(netf2)(quad x, quad y);
int QUAD(lttf2)(quad x, quad y);
int QUAD(letf2)(quad x, quad y);
int QUAD(gttf2)(quad x, quad y);
int QUAD(getf2)(quad x, quad y);
int QUAD(unordtf2)(quad x, quad y);

/* -1, 0, 1, or `unordered` if one is a NaN */
static int compare_quads(quad x, quad y, int unordered)
{
    const uwide a = bits_of(x), b = bits_of(y);

    if (nan_(a) || nan_(b))
        return unordered;
    if (a == b || (a | b) << 1 == 0)
        return 0;
    if ((a ^ b) >> 127)
        return a >> 127 ? -1 : 1;
    return (a < b) == (a >> 127 == 0) ? -1 : 1;
}

int QUAD(eqtf2)(quad x, quad y)     { return compare_quads(x, y, 1); }
int QUAD(netf2)(quad x, quad y)     { return compare_quads(x, y, 1); }
int QUAD(lttf2)(quad x, quad y)     { return compare_quads(x, y, 1); }
int QUAD(letf2)(quad x, quad y)     { return compare_quads(x, y, 1); }
int QUAD(gttf2)(quad x, quad y)     { return compare_quads(x, y, -1); }
int QUAD(getf2)(quad x, quad y)     { return compare_quads(x, y, -1); }
int QUAD(unordtf2)(quad x, quad y)  { return nan_(bits_of(x)) || nan_(bits_of(y)); }


// From and to other types
// -----------------------

quad   QUAD(extenddftf2)(double x);
quad   QUAD(extendsftf2)(float x);
double QUAD(trunctfdf2)(quad x);
float  QUAD(trunctfsf2)(quad x);

quad QUAD(extenddftf2)(double x)
{
    union {
        double d;
        uint64_t bits;
    } u = { x };
    const bool negative = u.bits >> 63;
    const int e = (int)(u.bits >> 52 & 2047);
    const uwide m = (uwide)(u.bits & ((UINT64_C(1) << 52) - 1)) << 63;

    if (e == 2047)
        return special(negative, m == 0);
    return pack(negative, (e ? e : 1) - 1023 + BIAS, e ? m | TOP : m);
}

quad QUAD(extendsftf2)(float x)     { return QUAD(extenddftf2)(x); }

/* A smaller format: `mantissa` bits of mantissa, exponents up to 2^`most` - 1. */
static uint64_t narrow_bits(uwide bits, int mantissa, int most)
{
    const uint64_t negative = (uint64_t)(bits >> 127);

    if (!finite_(bits))
        return negative << (mantissa + most) | ((UINT64_C(1) << most) - 1) << mantissa |
               (uint64_t)nan_(bits) << (mantissa - 1);
    const struct parts p = unpack(bits);
    const int e = p.e - BIAS + (1 << (most - 1)) - 1, below = e <= 0 ? 1 - e : 0;
    const uwide m = shifted_right(p.m, 112 - mantissa + below);
    const unsigned beyond = (unsigned)(m & 7);
    uint64_t result = (uint64_t)(m >> 3);
    result += beyond > 4 || (beyond == 4 && (result & 1));
    if (p.m)
        /* the first bit of the mantissa adds one */
        result += (uint64_t)(below ? 0 : e - 1) << mantissa;
    if (result >> mantissa >= (UINT64_C(1) << most) - 1 || e >= 1 << most)
        result = ((UINT64_C(1) << most) - 1) << mantissa;
    return result | negative << (mantissa + most);
}

double QUAD(trunctfdf2)(quad x)
{
    union {
        uint64_t bits;
        double d;
    } u = { narrow_bits(bits_of(x), 52, 11) };
    return u.d;
}

float QUAD(trunctfsf2)(quad x)
{
    union {
        uint32_t bits;
        float f;
    } u = { (uint32_t)narrow_bits(bits_of(x), 23, 8) };
    return u.f;
}

quad     QUAD(floatsitf)(int32_t x);
quad     QUAD(floatditf)(int64_t x);
quad     QUAD(floattitf)(wide x);
quad     QUAD(floatunsitf)(uint32_t x);
quad     QUAD(floatunditf)(uint64_t x);
quad     QUAD(floatuntitf)(uwide x);
int32_t  QUAD(fixtfsi)(quad x);
int64_t  QUAD(fixtfdi)(quad x);
wide     QUAD(fixtfti)(quad x);
uint32_t QUAD(fixunstfsi)(quad x);
uint64_t QUAD(fixunstfdi)(quad x);
uwide    QUAD(fixunstfti)(quad x);

static quad quad_of_whole(bool negative, uwide size)
{
    return size >> 127 ? pack(negative, BIAS + 116, shifted_right(size, 1))
                       : pack(negative, BIAS + 115, size);
}

quad QUAD(floattitf)(wide x)          { return quad_of_whole(x < 0, x < 0 ? -(uwide)x : (uwide)x); }
quad QUAD(floatditf)(int64_t x)         { return QUAD(floattitf)(x); }
quad QUAD(floatsitf)(int32_t x)         { return QUAD(floattitf)(x); }
quad QUAD(floatuntitf)(uwide x)         { return quad_of_whole(false, x); }
quad QUAD(floatunditf)(uint64_t x)      { return quad_of_whole(false, x); }
quad QUAD(floatunsitf)(uint32_t x)      { return quad_of_whole(false, x); }

/* Toward zero; |x| < 2^128. */
static uwide whole_part(quad x)
{
    const struct parts p = unpack(bits_of(x));
    const int n = p.e - BIAS - 115;

    if (p.e < BIAS)
        return 0;
    return n > 0 ? p.m << n : p.m >> -n;
}

wide QUAD(fixtfti)(quad x)
{
    return bits_of(x) >> 127 ? (wide)-whole_part(x) : (wide)whole_part(x);
}
int64_t  QUAD(fixtfdi)(quad x)          { return (int64_t)QUAD(fixtfti)(x); }
int32_t  QUAD(fixtfsi)(quad x)          { return (int32_t)QUAD(fixtfti)(x); }
uwide    QUAD(fixunstfti)(quad x)       { return whole_part(x); }
uint64_t QUAD(fixunstfdi)(quad x)       { return (uint64_t)whole_part(x); }
uint32_t QUAD(fixunstfsi)(quad x)       { return (uint32_t)whole_part(x); }

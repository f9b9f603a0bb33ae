/* tests/target/libc/math.c
 * SPDX-License-Identifier: MIT
 *
 * A long double has 113 bits here; tests are written for 64. Nothing is fast: series end when the
 * next term is below 2^-113.
 */
#include "math.h"

#include <stdint.h>

#define PI      3.14159265358979323846264338327950288419716939937510L
#define LN2     0.69314718055994530941723212145817656807550013436026L


// Powers of two, whole numbers
// ----------------------------

typedef union {
    long double value;
    struct {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
        uint64_t high, low;
#else
        uint64_t low, high;
#endif
    } bits;                                     /* the exponent: 15 bits below the sign */
} parts;

static int exponent_of(const parts *p) { return (int)(p->bits.high >> 48 & 0x7fff); }

static long double power_of_two(int n)          /* -16382 <= n <= 16383 */
{
    const parts p = { .bits = { .high = (uint64_t)(n + 16383) << 48 } };
    return p.value;
}

/* In three steps, since a factor has 15 bits of exponent; the last one rounds. */
long double ldexpl(long double x, int n)
{
    for (; n > 16000; n -= 16000)
        x *= power_of_two(16000);
    for (; n < -16000; n += 16000)
        x *= power_of_two(-16000);
    return x * power_of_two(n);
}

long double frexpl(long double x, int *n)
{
    parts p = { x };

    *n = 0;
    if (x == 0 || exponent_of(&p) == 0x7fff)
        return x;
    if (exponent_of(&p) == 0) {
        p.value *= power_of_two(200);
        *n = -200;
    }
    *n += exponent_of(&p) - 16382;
    p.bits.high = (p.bits.high & ~(UINT64_C(0x7fff) << 48)) | UINT64_C(16382) << 48;
    return p.value;
}

/* A number of 2^112 or more has no fraction. */
long double truncl(long double x)
{
    const long double size = fabsl(x), half = 0x1p62L;
    long double rest = size, sum = 0;

    if (!(size < 0x1p112L))
        return x;
    if (rest >= half) {
        const long double upper = (long double)(uint64_t)(rest / half) * half;
        sum = upper;
        rest -= upper;
    }
    sum += (long double)(uint64_t)rest;
    return x < 0 ? -sum : sum;
}

long double floorl(long double x)
{
    const long double t = truncl(x);
    return t > x ? t - 1 : t;
}
long double ceill(long double x)    { return -floorl(-x); }
long double roundl(long double x)
{
    const long double t = truncl(x);
    return fabsl(x - t) >= 0.5L ? t + (x < 0 ? -1 : 1) : t;
}

/* Subtract multiples by powers of two, from the largest down: each difference is exact. */
long double fmodl(long double x, long double y)
{
    long double rest = fabsl(x);
    const long double by = fabsl(y);

    if (!isfinite(x) || isnan(y) || y == 0)
        return NAN;
    while (rest >= by) {
        long double multiple = by;
        while (multiple <= rest / 2)
            multiple *= 2;
        rest -= multiple;
    }
    return x < 0 ? -rest : rest;
}

/* At a tie between two multiples, take the even one. */
long double remainderl(long double x, long double y)
{
    const long double by = fabsl(y), rest = fmodl(fabsl(x), 2 * by);
    const long double off = rest * 2 < by ? rest : rest * 2 <= 3 * by ? rest - by : rest - 2 * by;

    if (rest * 2 == by)
        return x < 0 ? -rest : rest;
    if (rest * 2 == 3 * by)
        return x < 0 ? by / 2 : -by / 2;
    return x < 0 ? -off : off;
}

double nextafter(double x, double toward)
{
    union {
        double d;
        uint64_t bits;
    } u = { x };

    if (x == toward || isnan(x) || isnan(toward))
        return isnan(x) ? x : toward;
    if (x == 0)
        u.bits = (uint64_t)(toward < 0) << 63 | 1;
    else
        u.bits += (toward > x) == (x > 0) ? 1 : UINT64_MAX;
    return u.d;
}

float nextafterf(float x, float toward)
{
    union {
        float f;
        uint32_t bits;
    } u = { x };

    if (x == toward || isnan(x) || isnan(toward))
        return isnan(x) ? x : toward;
    if (x == 0)
        u.bits = (uint32_t)(toward < 0) << 31 | 1;
    else
        u.bits += (toward > x) == (x > 0) ? 1 : UINT32_MAX;
    return u.f;
}


// Roots
// -----

/* The square root of m < 2^32, rounded down, bit by bit. */
static uint32_t whole_root(uint32_t m)
{
    uint32_t root = 0;

    for (uint32_t bit = UINT32_C(1) << 30; bit; bit >>= 2) {
        const uint32_t sum = root + bit;
        root >>= 1;
        if (m >= sum) {
            m -= sum;
            root += bit;
        }
    }
    return root;
}

/* Newton's method, from 15 bits: 30, 60, 120. */
long double sqrtl(long double x)
{
    int n;
    long double m = frexpl(x, &n);

    if (x == 0 || isnan(x) || x == INFINITY)
        return x;
    if (x < 0)
        return NAN;
    if (n & 1) {
        m /= 2;
        n++;
    }
    long double y = whole_root((uint32_t)(m * 0x1p32L)) / 65536.0L;
    for (int k = 0; k < 3; k++)
        y = (y + m / y) / 2;
    return ldexpl(y, n / 2);
}

/* Rounding 113 bits to 53 gives the nearest double: a root is never that close to the middle of two
 * doubles. */
double sqrt(double x) { return (double)sqrtl(x); }

long double hypotl(long double x, long double y)
{
    const long double most = fmaxl(fabsl(x), fabsl(y)), least = fminl(fabsl(x), fabsl(y));

    return most == 0 || !isfinite(most) ? most : most * sqrtl(1 + (least / most) * (least / most));
}


// Powers, exponentials, logarithms
// --------------------------------

long double expl(long double x)
{
    const long double n = floorl(x / LN2 + 0.5L), r = x - n * LN2;
    long double sum = 1;

    if (n > 16500 || n < -16500)
        return n > 0 ? INFINITY : 0;
    for (int k = 30; k; k--)
        sum = 1 + sum * r / k;
    return ldexpl(sum, (int)n);
}

long double exp2l(long double x)
{
    const long double n = truncl(x);

    return fabsl(n) > 16500 ? expl(x) : ldexpl(expl((x - n) * LN2), (int)n);
}

/* 2 artanh((m - 1) / (m + 1)), m in 0.7..1.42 */
long double logl(long double x)
{
    int n;
    long double m = frexpl(x, &n), sum = 0;

    if (x <= 0 || !isfinite(x))
        return x == 0 ? -INFINITY : x > 0 ? x : NAN;
    if (m < 0.7071L) {
        m *= 2;
        n--;
    }
    const long double s = (m - 1) / (m + 1), q = s * s;
    for (int k = 45; k > 0; k -= 2)
        sum = sum * q + 2.0L / k;
    return sum * s + n * LN2;
}

long double log2l(long double x) { return logl(x) / LN2; }

long double powl(long double x, long double y)
{
    long double result = 1, square = x;

    if (y != truncl(y) || fabsl(y) > 100000)
        return expl(y * logl(x));
    for (unsigned k = (unsigned)fabsl(y); k; k >>= 1, square *= square)
        if (k & 1)
            result *= square;
    return y < 0 ? 1 / result : result;
}


// Angles
// ------

/* sin for which = 0, cos for 1, by the nearest multiple of pi / 2 */
static long double sine_of(long double x, unsigned which)
{
    const long double n = floorl(x / (PI / 2) + 0.5L), r = x - n * (PI / 2), q = r * r;
    const unsigned quarter = which + (unsigned)(int64_t)n;
    long double sum = 1;

    for (int k = quarter & 1 ? 30 : 31; k > 1; k -= 2)
        sum = 1 - sum * q / (k * (k - 1));
    if (!(quarter & 1))
        sum *= r;
    return quarter & 2 ? -sum : sum;
}

long double sinl(long double x) { return sine_of(x, 0); }
long double cosl(long double x) { return sine_of(x, 1); }
long double tanl(long double x) { return sinl(x) / cosl(x); }

/* In 0..1, by an eighth of the angle */
static long double arctan_of(long double t)
{
    long double sum = 0;

    for (int k = 0; k < 3; k++)
        t /= 1 + sqrtl(1 + t * t);
    for (int k = 39; k > 0; k -= 2)
        sum = 1.0L / k - sum * t * t;
    return 8 * sum * t;
}

long double atan2l(long double y, long double x)
{
    const long double a = fabsl(x), b = fabsl(y);
    long double angle = a == 0 && b == 0 ? 0
                        : b <= a         ? arctan_of(b / a)
                                         : PI / 2 - arctan_of(a / b);

    if (x < 0)
        angle = PI - angle;
    return y < 0 ? -angle : angle;
}

long double asinl(long double x) { return atan2l(x, sqrtl((1 - x) * (1 + x))); }
long double acosl(long double x) { return 2 * atan2l(sqrtl(1 - x), sqrtl(1 + x)); }

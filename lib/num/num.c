/* lib/num/num.c -- the operations that are too long to be inline
 * SPDX-License-Identifier: MIT
 */
#include "num/num.h"

#if LOFT_NUM == LOFT_Q16

/* The largest r with r^2 <= x, and the rest x - r^2, digit by digit (two bits of x a round).
 * r < 2^32, so (2r+1) << 2k below stays within 64 bits. */
static uint32_t square_root(uint64_t x, uint64_t *rest)
{
    uint64_t r = 0, bit = (uint64_t)1 << 62;

    while (bit > x)
        bit >>= 2;
    for (; bit; bit >>= 2) {
        const uint64_t trial = r + bit;
        r >>= 1;
        if (x >= trial) {
            x -= trial;
            r += bit;
        }
    }
    *rest = x;
    return (uint32_t)r;
}

/* sqrt(X / 2^32) = sqrt(X) / 2^16: the root of the raw number is the raw root. It is r + 1 when
 * X > (r + 1/2)^2 = r^2 + r + 1/4, that is when the rest exceeds r. X < 2^63, so r + 1 fits. */
loft_real loft_acc_sqrt(loft_acc x)
{
    uint64_t rest;

    if (x <= 0)
        return 0;
    const uint32_t r = square_root((uint64_t)x, &rest);
    return (loft_real)(rest > r && r < INT32_MAX ? r + 1 : r);
}

/* All components are brought to the same scale, the largest to 30 bits, so that six squares sum to less
 * than 6 * 2^60 < 2^63; the root then has about 30 significant bits and is scaled back. */
loft_acc loft_acc_hypot(const loft_acc x[], int n)
{
    uint64_t largest = 0, sum = 0, rest;
    int down = 0, up = 0;

    for (int i = 0; i < n; i++) {
        const uint64_t size = (uint64_t)(x[i] < 0 ? -x[i] : x[i]);
        if (size > largest)
            largest = size;
    }
    if (largest == 0)
        return 0;
    while ((largest >> down) >= ((uint64_t)1 << 30))
        down++;
    while ((largest << up) < ((uint64_t)1 << 29))
        up++;

    for (int i = 0; i < n; i++) {
        const uint64_t size = (uint64_t)(x[i] < 0 ? -x[i] : x[i]);
        const uint64_t even = down ? (size + ((uint64_t)1 << down >> 1)) >> down : size << up;
        sum += even * even;
    }
    uint64_t root = square_root(sum, &rest);
    if (rest > root)
        root++;
    return (loft_acc)(down ? root << down : (root + ((uint64_t)1 << up >> 1)) >> up);
}

#else

/* Newton's iteration for the reciprocal square root would need a table; halving the exponent by
 * comparison keeps it freestanding: x is scaled by powers of 4 into [1, 4), where six Heron steps
 * from (1 + x) / 2 converge to the last bit. */
static double square_root(double x)
{
    double scale = 1;

    if (!(x > 0))
        return 0;
    if (x > DBL_MAX)
        return x;
    while (x >= 4) { x *= 0.25; scale *= 2; }
    while (x < 1)  { x *= 4;    scale *= 0.5; }

    double r = 0.5 * (1 + x);
    for (int i = 0; i < 6; i++)
        r = 0.5 * (r + x / r);
    return r * scale;
}

loft_real loft_acc_sqrt(loft_acc x) { return (loft_real)square_root(x); }

/* Scaled by the largest component, so that no square overflows or vanishes. */
loft_acc loft_acc_hypot(const loft_acc x[], int n)
{
    loft_acc largest = 0, sum = 0;

    for (int i = 0; i < n; i++) {
        const loft_acc size = x[i] < 0 ? -x[i] : x[i];
        if (size > largest)
            largest = size;
    }
    if (!(largest > 0))
        return 0;
    for (int i = 0; i < n; i++) {
        const loft_acc part = x[i] / largest;
        sum += part * part;
    }
    return largest * square_root(sum);
}

#endif

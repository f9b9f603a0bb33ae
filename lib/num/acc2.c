/* lib/num/acc2.c
 * SPDX-License-Identifier: MIT
 */
#include "num/acc2.h"

#if LOFT_NUM == LOFT_Q16

/* The unit is 2^-88 LSB. A difference is below 2^32 LSB, hence below 2^120; twice that is still
 * within the range of loft_acc128_lerp. */
loft_acc2 loft_acc2_sub(loft_real a, loft_real b)
{
    const loft_acc x = ((loft_acc)a - b) * 16777216;
    const loft_acc2 r = { { 0, 0, loft_acc_low(x), (uint32_t)loft_acc_high(x) } };
    return r;
}

loft_acc2 loft_acc2_twice(loft_acc2 x) { return loft_acc128_add(x, x); }
loft_acc2 loft_acc2_lerp(loft_acc2 x, loft_acc2 y, loft_unit t)
{
    return loft_acc128_lerp(x, y, t);
}

static bool is_negative(loft_acc2 x) { return x.limb[3] >> 31 != 0; }

static loft_acc2 magnitude(loft_acc2 x)
{
    const loft_acc2 zero = { { 0 } };
    return is_negative(x) ? loft_acc128_sub(zero, x) : x;
}

/* The number of bits of a number that is not negative. */
static int bits_of(loft_acc2 size)
{
    int limb = 3, bits = 0;

    while (limb > 0 && !size.limb[limb])
        limb--;
    for (uint32_t rest = size.limb[limb]; rest; rest >>= 1)
        bits++;
    return 32 * limb + bits;
}

/* 60 bits of the number, starting at bit `low`; bits below bit 0 are 0. */
static loft_acc bits_from(loft_acc2 size, int low)
{
    uint64_t out = 0;

    for (int k = 0; k < 4; k++) {
        const int at = 32 * k - low;
        if (at >= 0 && at < 60)
            out |= (uint64_t)size.limb[k] << at;
        else if (at < 0 && at > -32)
            out |= (uint64_t)(size.limb[k] >> -at);
    }
    return (loft_acc)out;
}

bool loft_acc2_scaled(const loft_acc2 x[], int n, loft_acc out[])
{
    int most = 0;

    for (int i = 0; i < n; i++) {
        const int bits = bits_of(magnitude(x[i]));
        most = bits > most ? bits : most;
    }
    for (int i = 0; most && i < n; i++) {
        const loft_acc size = bits_from(magnitude(x[i]), most - 60);
        out[i] = is_negative(x[i]) ? -size : size;
    }
    return most > 0;
}

#else

/* The unit is 2^64, so that the halves of a product do not overflow. */
loft_acc2 loft_acc2_sub(loft_real a, loft_real b)
{
    const double x = (double)a * 0x1p-64, y = (double)b * 0x1p-64;
    const loft_acc2 r = { x - y, loft_difference_tail(x, y, x - y) };
    return r;
}

loft_acc2 loft_acc2_twice(loft_acc2 x)
{
    const loft_acc2 r = { 2 * x.high, 2 * x.low };
    return r;
}

/* The low part of a sum of two doubles is the rounding error of that sum plus the tails. */
static loft_acc2 sum_of(double x, double y, double tails)
{
    const double sum = x + y, tail = loft_difference_tail(x, -y, sum) + tails, high = sum + tail;
    const loft_acc2 r = { high, tail - (high - sum) };
    return r;
}

/* 1 - t is exact. The tails are below 2^-52 of the larger number, and their errors below 2^-103 of
 * it. */
loft_acc2 loft_acc2_lerp(loft_acc2 x, loft_acc2 y, loft_unit t)
{
    const double v = (double)t, u = 1 - v, p = x.high * u, q = y.high * v;

    return sum_of(p, q,
                  loft_product_tail(x.high, u, p) + loft_product_tail(y.high, v, q) +
                      (x.low * u + y.low * v));
}

bool loft_acc2_scaled(const loft_acc2 x[], int n, loft_acc out[])
{
    static const double power[10] = { 0x1p512, 0x1p256, 0x1p128, 0x1p64, 0x1p32,
                                      0x1p16,  0x1p8,   0x1p4,   0x1p2,  0x1p1 };
    double most = 0;

    for (int i = 0; i < n; i++)
        most = loft_acc_max(most, loft_acc_abs(x[i].high));
    if (!(most > 0))
        return false;
    for (int i = 0; i < n; i++)
        out[i] = x[i].high;
    for (int k = 0; k < 10; k++) {
        const double by = most * power[k] < 0x1p28    ? power[k]
                          : most / power[k] >= 0x1p27 ? 1 / power[k]
                                                      : 1;
        for (int i = 0; i < n; i++)
            out[i] *= by;
        most *= by;
    }
    return true;
}

#endif

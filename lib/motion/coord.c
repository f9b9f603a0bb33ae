/* lib/motion/coord.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/coord.h"

loft_coord loft_coord_of(loft_acc x)
{
    const int32_t whole = loft_acc_int(x);
    const loft_acc rest = x - loft_to_acc(loft_real_from_int(whole));
    return loft_coord_add((loft_coord)((uint32_t)whole << LOFT_COORD_BITS),
                          loft_acc_int(rest * LOFT_COORD_MM));
}

loft_acc loft_coord_to_acc(int64_t x)
{
    const int32_t whole = (int32_t)(x >> LOFT_COORD_BITS);
    const int32_t rest = (int32_t)(x - (int64_t)whole * LOFT_COORD_MM);
    return loft_to_acc(loft_real_from_int(whole)) +
           loft_acc_ratio(loft_to_acc(loft_real_from_int(rest >> 11)), LOFT_COORD_MM >> 11) +
           loft_acc_ratio(loft_to_acc(loft_real_from_int(rest & 2047)), LOFT_COORD_MM);
}

/* a b / 2^32. */
static uint32_t high(uint32_t a, uint32_t b) { return (uint32_t)((uint64_t)a * b >> 32); }

/* 1 / sqrt(h / 2^32), 2^-30, for h of 2^30 at least: Newton, from a straight line that is within a
 * seventh. */
static uint32_t inverse_root(uint32_t h)
{
    uint32_t y = UINT32_C(2376204288) - high(h, UINT32_C(1332000000));

    for (int n = 0; n < 4; n++) {
        const uint32_t square = high(high(y, y), h);        /* 2^28 y^2 h */
        y = (uint32_t)((uint64_t)y * (UINT32_C(3) * ((uint32_t)1 << 28) - square) >> 29);
    }
    return y;
}

uint32_t loft_coord_sqrt(uint64_t x)
{
    int down = 0;

    if (x == 0)
        return 0;
    for (int bits = 32; bits > 1; bits /= 2)
        if (x >> (64 - bits) == 0) {
            x <<= bits;
            down += bits / 2;
        }
    const uint32_t h = (uint32_t)(x >> 32);
    const uint32_t inverse = inverse_root(h);
    uint64_t root = (uint64_t)inverse * h >> 30;
    root = root > UINT32_MAX ? UINT32_MAX : root;
    const int64_t rest = (int64_t)(x - root * root);
    root += (uint64_t)(rest / 4096 * (int64_t)inverse / ((int64_t)1 << 51));
    root = root > UINT32_MAX ? UINT32_MAX : root;
    while (root * root > x)
        root--;
    while (root < UINT32_MAX && (root + 1) * (root + 1) <= x)
        root++;
    return (uint32_t)(root >> down);
}

/* Bit by bit: (y + 1)^3 - y^3 = 3 y (y + 1) + 1. */
uint32_t loft_coord_cbrt(uint64_t x)
{
    uint64_t root = 0;

    for (int shift = 63; shift >= 0; shift -= 3) {
        root *= 2;
        const uint64_t step = 3 * root * (root + 1) + 1;
        if (x >> shift >= step) {
            x -= step << shift;
            root++;
        }
    }
    return (uint32_t)root;
}

loft_coord loft_coord_length(const loft_coord x[LOFT_AXES])
{
    uint64_t sum = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        sum += (uint64_t)((int64_t)x[i] * x[i]);
    return (loft_coord)loft_coord_sqrt(sum);
}

/* lib/num/part.c
 * SPDX-License-Identifier: MIT
 */
#include "num/part.h"

/* 1 / sqrt m for m = 16/64, 17/64, .. 1, 2^-14, less 2^-11 of it, so that lines between are below
 * it. */
static const uint16_t inverse_roots[49] = {
    32752, 31774, 30878, 30055, 29294, 28588, 27930, 27317, 26741, 26201, 25692, 25212, 24758,
    24327, 23918, 23529, 23159, 22805, 22467, 22144, 21834, 21537, 21252, 20978, 20714, 20460,
    20214, 19978, 19750, 19529, 19316, 19109, 18909, 18715, 18527, 18344, 18167, 17995, 17827,
    17665, 17506, 17352, 17202, 17055, 16913, 16773, 16638, 16505, 16376
};

int32_t loft_part_root(uint32_t m)
{
    const uint32_t i = (m >> 24) - 16, part = m >> 14 & 1023, y = inverse_roots[i];
    return (int32_t)(y - ((y - inverse_roots[i + 1]) * part >> 10));
}

/* With y (1 - e)^(-1/2) right, the first terms of its series: e is below 2^-9, so that 5/16 e^3 is
 * left out. */
int32_t loft_part_root_fine(uint32_t m)
{
    const int32_t y = loft_part_root(m),
                  e = ((int32_t)1 << 30) - (int32_t)((uint64_t)m * (uint32_t)(y * y) >> 28),
                  square = (e >> 6) * (e >> 6) >> 18;
    return y * LOFT_PART_ONE + 2 * loft_part(e / 2 + square * 3 / 8, y);
}

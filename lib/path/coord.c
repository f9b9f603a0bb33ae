/* lib/path/coord.c
 * SPDX-License-Identifier: MIT
 */
#include "path/coord.h"

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

loft_coord loft_position_distance(const loft_position *a, const loft_position *b)
{
    loft_coord off[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        off[i] = loft_coord_sub(b->axis[i], a->axis[i]);
    return loft_coord_length(off);
}

/* lib/path/coord.h -- whole numbers in which motion is planned, the same in every number type
 * SPDX-License-Identifier: MIT
 *
 * A place is kept in units of 2^-24 mm, modulo 2^8 mm: only differences of neighbours are ever
 * taken. A factor (of the squared pace, see timing.h) is a multiple of 2^-24.
 */
#ifndef LOFT_PATH_COORD_H
#define LOFT_PATH_COORD_H

#include "geom/vec.h"   /* loft_vec, loft_root */

LOFT_BEGIN_C

typedef int32_t loft_coord;      /* 2^-24 mm */

#define LOFT_COORD_BITS 24
#define LOFT_COORD_MM   ((loft_coord)1 << LOFT_COORD_BITS)

/* A grain is 2^-16 mm: the last bit of a span in q16. */
#define LOFT_COORD_GRAIN ((loft_coord)1 << (LOFT_COORD_BITS - 16))

typedef struct {
    loft_coord axis[LOFT_AXES];
} loft_position;

/* Where effort is spent, long slow lines are folded: most of such a line is left out of the path,
 * and comes back in the motion as a cruise (chain.c, thin.c). What is left out so far: grains, and
 * the ticks that it takes, modulo 2^32. */
#define LOFT_FOLDS (LOFT_PLAN_EFFORT > 1)

typedef struct {
    int32_t  axis[LOFT_AXES];
    uint32_t ticks;
} loft_fold;

/* a - b of two coordinates that are less than 2^7 mm apart. */
static inline loft_coord loft_coord_sub(loft_coord a, loft_coord b)
{
    return (loft_coord)((uint32_t)a - (uint32_t)b);
}

static inline loft_coord loft_coord_add(loft_coord a, loft_coord b)
{
    return (loft_coord)((uint32_t)a + (uint32_t)b);
}

/* A coordinate of the path without what is left out of it, grains. */
static inline loft_coord loft_coord_folded(loft_coord x, int32_t left_out)
{
    return (loft_coord)((uint32_t)x - (uint32_t)left_out * (uint32_t)LOFT_COORD_GRAIN);
}

static inline int32_t loft_coord_least(int32_t a, int32_t b) { return a < b ? a : b; }
static inline int32_t loft_coord_most(int32_t a, int32_t b) { return a > b ? a : b; }
static inline int32_t loft_coord_abs(int32_t a) { return a < 0 ? -a : a; }
static inline int64_t loft_long_abs(int64_t a) { return a < 0 ? -a : a; }

/* A coordinate or a length, mm.
 *
 *   range   |x| < 2^15; modulo 2^8 mm
 *   error   2^-25 mm
 */
loft_coord loft_coord_of(loft_acc x);

/* And back, of as many units as 64 bits hold.
 *
 *   range   |x| < 2^38
 *   error   none in q16 and f64
 */
loft_acc loft_coord_to_acc(int64_t x);

/* The square root, rounded down.
 *
 *   cost    loft_root
 */
static inline uint32_t loft_coord_sqrt(uint64_t x) { return loft_root(x); }

/* The cube root, rounded down.
 *
 *   cost    22 rounds
 */
uint32_t loft_coord_cbrt(uint64_t x);

/* A length in grains, rounded down, at most 65535: 1 mm.
 *
 *   range   x >= 0
 */
static inline uint16_t loft_coord_grains(loft_coord x)
{
    return (uint16_t)(x < 65536 * LOFT_COORD_GRAIN ? x / LOFT_COORD_GRAIN : 65535);
}

/* The length of a vector of differences.
 *
 *   range   each below 2^30
 *   error   1
 */
loft_coord loft_coord_length(const loft_coord x[LOFT_AXES]);

/* How far two places are apart. */
loft_coord loft_position_distance(const loft_position *a, const loft_position *b);

LOFT_END_C

#endif

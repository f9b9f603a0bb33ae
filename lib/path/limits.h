/* lib/path/limits.h -- what a machine can do
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PATH_LIMITS_H
#define LOFT_PATH_LIMITS_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

#define LOFT_SPEED_MIN LOFT_REAL(0.015625)  /* 1/64 mm/s: just below 1 mm/min */
#define LOFT_SPEED_MAX LOFT_REAL(16383)     /* mm/s                          */
#define LOFT_ACCEL_MIN LOFT_REAL(1)         /* mm/s^2                         */
#define LOFT_ACCEL_MAX LOFT_REAL(16383)     /* mm/s^2                         */
#define LOFT_JERK_MAX  10000000             /* mm/s^3                         */

/* What the machine can do. */
typedef struct {
    loft_real max_speed[LOFT_AXES];     /* mm/s, 1/64..16383 */
    loft_real max_accel[LOFT_AXES];     /* mm/s^2, 1..16383 */
    uint32_t  max_jerk[LOFT_AXES];      /* mm/s^3, to 10,000,000; 0: not limited */
    loft_real tol;                      /* how far spans may leave the path, rounding included, mm,
                                         * 1/1024..1 */
    loft_real corner;                   /* 0..1: the same, up to 32 times this along the path from
                                         * where it turns by more than 5 degrees; at least tol */
    loft_real exact;                    /* 0..2: it stops where a curve's direction, of length 1,
                                         * differs by more from that of the last one: 2 sin(turn
                                         * / 2); 0: nowhere */
    uint16_t  tick_hz;                  /* ticks per second, 50..50000 */
    uint8_t   one_sided;                /* bit i: axis i does not swing beyond where it stops, as a
                                         * pen or a mill may not, nor do others beyond an end at
                                         * which such axes move alone: but for tol / 8, with little
                                         * effort tol / 4. Such corners take up to a tenth longer */
} loft_limits;

/* Are these limits possible?
 *
 *   range   LOFT_ERR_ARG for a limit that is zero (except corner and exact), negative or not a
 *           number: the machine could not move; LOFT_ERR_RANGE for one beyond the ranges beside
 *           the fields
 */
enum loft_status loft_limits_check(const loft_limits *limits) LOFT_CHECKED;

LOFT_END_C

#endif

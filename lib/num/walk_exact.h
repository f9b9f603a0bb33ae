/* lib/num/walk_exact.h -- forward differencing without any rounding, in one coordinate
 * SPDX-License-Identifier: MIT
 *
 * As num/walk.h, but each difference is an integer and a remainder over n^degree. It is exact also
 * if the number of steps is not a power of two, at a few times the cost. In f32 and f64 it is the
 * walk of num/walk.h.
 */
#ifndef LOFT_NUM_WALK_EXACT_H
#define LOFT_NUM_WALK_EXACT_H

#include "num/walk.h"   /* LOFT_WALK_DEGREE_MAX, loft_walk */

LOFT_BEGIN_C

#if LOFT_NUM == LOFT_Q16

typedef struct {
    uint64_t rest[LOFT_WALK_DEGREE_MAX + 1];    /* below n^degree; rest[0] includes half of it  */
    uint32_t whole[LOFT_WALK_DEGREE_MAX + 1];   /* wraps                                        */
} loft_walk_exact;

static inline loft_real loft_walk_exact_step(loft_walk_exact *s, unsigned degree, uint64_t power,
                                             bool last)
{
    (void)last;
    for (unsigned k = 0; k < degree; k++) {
        const uint64_t rest = s->rest[k] + s->rest[k + 1];      /* below 2 power < 2^64 */
        const bool carry = rest >= power;

        s->rest[k] = carry ? rest - power : rest;
        s->whole[k] += s->whole[k + 1] + carry;
    }
    return (loft_real)s->whole[0];
}

#else

typedef loft_walk loft_walk_exact;

static inline loft_real loft_walk_exact_step(loft_walk_exact *s, unsigned degree, uint64_t power,
                                             bool last)
{
    const loft_real arrived = loft_walk_step(s, degree);

    (void)power;
    return last ? loft_walk_end(s, arrived) : arrived;
}

#endif

/* True if n^degree is below 2^63; n >= 1 */
bool     loft_walk_exact_steps_valid(unsigned degree, uint32_t n);
uint64_t loft_walk_exact_power(unsigned degree, uint32_t n);       /* n^degree */

/* Start at p[0] of the Bezier polynomial p[0..degree], with a valid n steps to go.
 *
 *   range   f32, f64: |p| <= LOFT_REAL_MAX / 65536
 *   error   q16: none   f32, f64: as loft_walk_init
 *   cost    q16: degree^2 divisions of 64 bits
 */
void loft_walk_exact_init(loft_walk_exact *s, const loft_real p[], unsigned degree, uint32_t n);

LOFT_END_C

#endif

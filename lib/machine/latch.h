/* lib/machine/latch.h -- the latch: where the input of a guard has changed, and when it is certain
 * SPDX-License-Identifier: MIT
 *
 * Contacts bounce. The latch keeps the position of the first change. The guard has come true when
 * the input has then stayed so for `filter` samples more. A change that does not last is forgotten,
 * with its place, once the input has been back for as many samples.
 *
 *     main loop   loft_latch_arm when the job begins; loft_latch_sample each ms, here or with ticks
 *     slot        loft_latch_keep, while loft_latch_waits, where inputs are loft_latch_wanted
 *
 * A guard of LOFT_GUARD_EDGE first waits until the input has been otherwise for as many samples.
 */
#ifndef LOFT_MACHINE_LATCH_H
#define LOFT_MACHINE_LATCH_H

#include "wire/message.h"   /* loft_guard */

LOFT_BEGIN_C

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_guard guard;
    volatile uint8_t waits;             /* main loop sets it: a change is awaited; slot clears it */
    volatile uint8_t seen;              /* slot sets it: `place` holds; main loop clears it */
    uint8_t armed;                      /* the guard has not come true yet */
    uint8_t like, unlike;               /* samples in succession, as the guard wants and not */
    int32_t place[LOFT_AXES];           /* steps */
} loft_latch;

/* No guard. */
void loft_latch_init(loft_latch *l);

/* A job begins, with this guard or, without inputs, with none. */
void loft_latch_arm(loft_latch *l, const loft_guard *guard);

/* The job is over: wait for nothing more. The place stays. */
void loft_latch_rest(loft_latch *l);

/* Take a sample of the closed inputs. Returns those that make the guard true, once; else 0. */
uint16_t loft_latch_sample(loft_latch *l, uint16_t inputs);

/* Where the input of a guard that came true has changed: LOFT_AXES steps. NULL: the job has no
 * guard. */
static inline const int32_t *loft_latch_place(const loft_latch *l)
{
    return l->guard.inputs ? l->place : NULL;
}

/* True if a change is awaited. Otherwise loft_latch_keep has no effect. */
static inline bool loft_latch_waits(const loft_latch *l)        { return l->waits; }

/* Of these closed inputs, those of the guard that are as it wants. */
static inline uint16_t loft_latch_wanted(const loft_latch *l, uint16_t closed)
{
    return (uint16_t)((l->guard.how & LOFT_GUARD_OPENS ? ~closed : closed) & l->guard.inputs);
}

/* An input of the guard is as it wants: keep the position, LOFT_AXES steps. */
void loft_latch_keep(loft_latch *l, const int32_t position[LOFT_AXES]);

LOFT_END_C

#endif

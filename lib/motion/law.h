/* lib/motion/law.h -- law: which place of the path is reached at which beat
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_LAW_H
#define LOFT_MOTION_LAW_H

#include "motion/flow.h"    /* loft_flow, loft_course */

LOFT_BEGIN_C

/* Part of a piece that is passed with even acceleration: where it ends, from the start of the
 * piece, and the speed there. */
typedef struct {
    loft_acc  end;
    loft_real speed;
} loft_law_part;

/* Complete so that it can be static; do not rely on the fields. */
typedef struct {
    loft_course course;
    loft_course_place  at;                     /* of the law, before it is averaged */
    loft_real   speed;                  /* there, mm/s */
    unsigned    from;                   /* the piece that the place is counted from */
    bool        rests;
    loft_law_part part[3];              /* jerk not limited: of the piece; how many, and the next
                                         * one */
    uint8_t     parts, next;
    loft_real   aim;                    /* the speed at the end of the piece that they lead to */
    loft_unit   left;                   /* of the beat */
#if LOFT_PLAN_FILTER > 1
    loft_acc    sum, mean;              /* of the ways; the mean place of the window times beats  */
    loft_unit   way[LOFT_PLAN_FILTER];  /* a ring: mm in each of the last beats                   */
    uint8_t     beats, slot;            /* of the window; the oldest of them                      */
    uint8_t     calm;                   /* beats since it last braked, or since it rests          */
    uint8_t     steady;                 /* beats since it last sped up                            */
#endif
#if LOFT_PLAN_FLOW
    loft_flow   flow;
    bool        flows;                  /* where jerk is limited and there is room for it: this is
                                         * what moves */
#endif
} loft_law;

enum loft_law_state {
    LOFT_LAW_RUNS,      /* a beat was added                                            */
    LOFT_LAW_WAITS,     /* the next beat depends on curves that have not come yet      */
    LOFT_LAW_RESTS      /* at the end of what there is                                 */
};

/* Rest at the start of an empty course. */
void loft_law_init(loft_law *law);

#if LOFT_PLAN_FILTER > 1

/* The mean over the window of what is summed over it. */
static inline loft_acc loft_law_mean(const loft_law *law, loft_acc sum)
{
    return law->beats > 1 ? loft_acc_ratio(sum, law->beats) : sum;
}

#endif

/* How far from the start of piece law->from the place is. */
static inline loft_acc loft_law_off(const loft_law *law)
{
#if LOFT_PLAN_FILTER > 1
    if (LOFT_BUDGET_JERK(&law->course.budget))
        return loft_law_mean(law, law->mean);
#endif
    return law->at.off;
}

/* Go on for one beat.
 *
 *   shape   no beat is given that curves yet to come may make wrong, unless the course has ended or
 *           is full
 */
enum loft_law_state loft_law_next(loft_law *law);

LOFT_END_C

#endif

/* host-tools/send/hand.h -- what is done by hand: the tool goes to a place, or along an axis, the
 * pen up and down, the tool to its parking place; and the machine is told where it stands
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HAND_H
#define LOFT_HAND_H

#include "send/sequence.h"

/* It must not move until it is over. */
typedef struct {
    mover *v;
    sequence q;
    double feed;                /* mm/s */
    double to[ENGINE_AXES];     /* mm; NAN: this axis stays */
    bool by;                    /* by that much, from where the tool is */
    bool up;                    /* the pen */
    int axis;                   /* of a jog, by this way */
    double way;
    bool (*ends)(void *context);
    void *context;
    unsigned axes;              /* that are placed: bit i for axis i */
    double was[ENGINE_AXES];    /* mm: where the tool was before */
} hand;

/* A machine that is not greeted is greeted first; mover_ready before has it greeted in any case.
 * Straight to a place, if table and closed switches allow it. */
void hand_go(hand *m, mover *v, const double to[ENGINE_AXES], bool by, double feed);

/* z to pen_up or pen_down; first z to pen_up, if it is below, then to x.park and y.park. */
void hand_pen(hand *m, mover *v, bool up, double feed);
void hand_park(hand *m, mover *v, double feed);

/* Along an axis by `way` mm, or to the end of the table before; infinite: as far as that. `ends` is
 * asked in each step, and may be NULL. */
void hand_jog(hand *m, mover *v, int axis, double way, double feed, bool (*ends)(void *context),
              void *context);

/* These axes are at `at` now: bit i for axis i. `keep`: a homed machine has it in its settings. */
void hand_zero(hand *m, mover *v, unsigned axes, const double at[ENGINE_AXES], bool keep);

/* Stepped, it ends with 0, or with an exit code after one message. */
task hand_task(hand *m);

#endif

/* host-tools/send/home.h -- finds the switches of the axes, and leaves them
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOME_H
#define LOFT_HOME_H

#include "send/facts.h"         /* send_teller */
#include "send/sequence.h"

/* It must not move until it is over. */
typedef struct {
    mover *v;
    sequence q;
    send_teller to;
    bool wanted[ENGINE_AXES];   /* axes that are still to be homed, */
    bool all;                   /* all that have a switch */
    unsigned touches;
    bool over;                  /* no axis is left */
    /* ---- of one axis and its switch */
    int axis;
    double sign;                /* towards the switch */
    uint16_t own, other;        /* the inputs at this end and at the other; with two motors `own`
                                 * are both, one of each */
    double from, way;           /* mm: the place before it was sought, and how far it was */
    mover_outcome found;        /* where it closed */
    int32_t first;              /* steps: where the first of two switches closed */
    long before, after;         /* steps between them, before and after squaring */
    int32_t least[LOFT_AXES], most[LOFT_AXES];  /* steps of all touches */
    unsigned touched;
    /* ---- of motors that are moved as if they were axes */
    bool motors;
    machine_file kept;
    /* ---- of the way out */
    int out;                    /* the axis that is named; below 0: none */
    double out_sign;
} home;

/* Find the switches of these axes, in their order; NULL: of those that have a place in the order.
 * `touches` times each slowly, 1..20. Then it is told where they are. */
void home_begin(home *h, mover *v, const bool axis[ENGINE_AXES], unsigned touches,
                const send_teller *to);

/* Lead the tool away from the closed switches. Where it is not known at which end one is: axis
 * `out` by way of `sign`; out below 0: none is named. */
void home_unlock(home *h, mover *v, int out, double sign, const send_teller *to);

/* Stepped, it ends with 0, or with an exit code after one message. */
int  home_step(home *h, double now, task_wants *w);
task home_task(home *h);

#endif

/* host-tools/send/probe.h -- moves until the probe touches something
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PROBE_H
#define LOFT_PROBE_H

#include "send/facts.h"         /* send_teller */
#include "send/sequence.h"

typedef struct {
    int axis;
    double sign;                /* 1 or -1: the way */
    double within;              /* mm: how far to look */
    double feed;                /* mm/s */
    double back;                /* mm: to leave the surface again */
    double at;                  /* mm: the axis is there where it touches; NAN: it is not told so */
} probe_way;

/* It must not move until it is over. */
typedef struct {
    mover *v;
    sequence q;
    probe_way way;
    send_teller to;
    double touched[ENGINE_AXES];    /* mm */
} probe;

/* At the end it is told where. Stepped, it ends with 0, or with an exit code after one message. */
void probe_begin(probe *p, mover *v, const probe_way *way, const send_teller *to);
task probe_task(probe *p);

#endif

/* host-tools/send/sequence.h -- several things that a mover does, one after the other, each judged
 * SPDX-License-Identifier: MIT
 *
 *     sequence_begin(&q, &v, context);
 *     sequence_add(&q, seek, found);      seek: mover_go(..) or another call of send/mover.h
 *     sequence_add(&q, greet, NULL);
 *     ..                                  then step it: send/task.h
 */
#ifndef LOFT_SEQUENCE_H
#define LOFT_SEQUENCE_H

#include "send/mover.h"

#define SEQUENCE_PARTS 160

/* 0, or an exit code after one message: it ends there. */
typedef int sequence_call(void *context);

typedef struct {
    mover *v;
    void *context;
    struct {
        sequence_call *begin, *end;
    } part[SEQUENCE_PARTS];
    unsigned at, count;
    bool begun;                 /* part `at` has */
} sequence;

/* Nothing is to be done yet; `context` is for the calls. */
void sequence_begin(sequence *q, mover *v, void *context);

/* Add a part: `begin` gives the mover something to do, or nothing; `end` judges what came of it.
 * NULL: none. A part may add others, behind those that wait; SEQUENCE_PARTS in all. */
void sequence_add(sequence *q, sequence_call *begin, sequence_call *end);

/* TASK_GOES, 0 after the last part, or an exit code after one message. */
int  sequence_step(sequence *q, double now, task_wants *w);
task sequence_task(sequence *q);

#endif

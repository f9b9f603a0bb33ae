/* host-tools/send/sequence.c
 * SPDX-License-Identifier: MIT
 */
#include "send/sequence.h"

void sequence_begin(sequence *q, mover *v, void *context)
{
    q->v       = v;
    q->context = context;
    q->at = q->count = 0;
    q->begun         = false;
}

void sequence_add(sequence *q, sequence_call *begin, sequence_call *end)
{
    q->part[q->count].begin = begin;
    q->part[q->count].end   = end;
    q->count++;
}

int sequence_step(sequence *q, double now, task_wants *w)
{
    int code = 0;

    for (; code == 0 && q->at < q->count; q->at += code == 0) {
        sequence_call *begin = q->part[q->at].begin, *end = q->part[q->at].end;
        if (!q->begun && begin != NULL)
            code = begin(q->context);
        q->begun = true;
        if (code == 0)
            code = mover_step(q->v, now, w);
        if (code == 0 && end != NULL)
            code = end(q->context);
        q->begun = code != 0;
    }
    return code;
}

static int step_sequence(void *context, double now, task_wants *w)
{
    return sequence_step(context, now, w);
}

task sequence_task(sequence *q) { return (task){ step_sequence, q, &q->v->t.stop }; }

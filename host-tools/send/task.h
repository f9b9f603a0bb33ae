/* host-tools/send/task.h -- what takes time: a conversation with a machine, which is stepped
 * SPDX-License-Identifier: MIT
 *
 *     task_wants w;
 *     while ((code = task_step(&t, seconds(), &w)) == TASK_GOES)
 *         poll w.in and w.out, until w.until at most;
 *
 * A step takes some milliseconds: it moves the bytes that are there, or plans a portion. It waits
 * for nothing and reads no clock: who steps it owns the loop, the time, the keys and the signals.
 * So a command, a server and a test with a simulated clock step the same task.
 */
#ifndef LOFT_TASK_H
#define LOFT_TASK_H

#include <math.h>       /* HUGE_VAL */
#include <stdbool.h>
#include <sysexits.h>

enum { TASK_GOES = -1 };        /* otherwise a code of <sysexits.h>: it is over */

/* What a task waits for. It may be stepped earlier as well. */
typedef struct {
    int in, out;                /* descriptors, to read from and to write to; -1: none */
    double until;               /* step it then, in any case */
    char awaits[200];           /* what does not come, in words; "": nothing */
} task_wants;

typedef struct {
    int (*step)(void *context, double now, task_wants *w);
    void *context;              /* it stays until the task is over */
    bool *stop;                 /* set it to ask for the end: the machine stops on the path */
} task;

/* `now` is the time of any clock in seconds that is never set, the same in all steps. After the end
 * the task may not be stepped again. */
static inline int task_step(const task *t, double now, task_wants *w)
{
    *w = (task_wants){ .in = -1, .out = -1, .until = HUGE_VAL };
    return t->step(t->context, now, w);
}

/* Step again at this time, or before. */
static inline void task_wake(task_wants *w, double at)
{
    if (at < w->until)
        w->until = at;
}

#endif

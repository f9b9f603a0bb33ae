/* host-tools/send/stream.h -- sends a job to the machine: what is asked of it, how it goes, the end
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STREAM_H
#define LOFT_STREAM_H

#include <stddef.h>

#include "read/drawing.h"        /* drawing */
#include "plan/job.h"            /* job, kinematics */
#include "send/facts.h"          /* send_facts */
#include "send/greeted.h"        /* stream_machine */
#include "send/talk.h"           /* talk */

/* What the closing line says about the drawing. */
typedef struct {
    const char *file;
    size_t curves;
    double drawn;           /* mm                                                       */
    double tol;             /* mm, planned                                              */
    const drawing *d;
    const char *record;     /* the pulses that a simulated machine recorded, or NULL    */
    const kinematics *k;
    const char *port, *tool;        /* tool NULL: the drawing has none */
    const toolpath *path;
} stream_subject;

/* A job that runs. */
typedef struct stream {
    talk *t;
    job *j;
    const stream_subject *about;
    send_teller to;
    const char *pause;      /* what the program says of the pause; NULL: there is none */
    bool over;              /* the motion is: the next step tells the end */
    /* ---- */
    int (*stage)(struct stream *r, double now, task_wants *w);
    int lost;               /* errno of a port that has vanished */
    int planned;            /* enum loft_status                         */
    size_t kept;            /* items before it will not be asked for again */
    double stop_at;         /* the time when the end was asked for; 0: not yet */
    double held_at;         /* the time when the machine stopped; 0: not yet */
    bool woken;             /* a job that was already running continues */
    bool resting;           /* it was held then: it goes on, if that is no pause */
    uint32_t ticks, elapsed;/* of the previous status */
    double pace;            /* between the last two */
    double moved;           /* the time when the ticks last advanced */
    int percent;            /* that a key last asked for; 0: none */
    double began;
    double until;           /* a record is complete, or never */
} stream;

/* Begin `j` on the greeted machine, plan on while it draws, and wait for the end. At the end the
 * closing line is told, or one error. `j` and `about` stay until then. */
void stream_begin(stream *r, talk *t, job *j, const stream_subject *about, const send_teller *to);
int  stream_step(stream *r, double now, task_wants *w);
task stream_task(stream *r);

/* Obey a key: h holds, r resumes, a aborts, + - 0 change the override, s tells the state, Enter
 * goes on after a pause. */
void stream_key(stream *r, int key);

/* How it goes, and the same in words. Returns false if the machine has not taken the job yet. */
bool stream_facts(stream *r, send_facts *f, char words[160]);

/* Hold, resume or abort whatever the machine does, and tell where it stands. */
typedef struct {
    talk *t;
    enum loft_verb verb;
    const kinematics *k;
    send_teller to;
    double began, done;     /* 0: not yet */
} stream_control;

int  stream_control_step(stream_control *c, double now, task_wants *w);
void stream_control_begin(stream_control *c, talk *t, enum loft_verb verb, const kinematics *k,
                          const send_teller *to);
task stream_control_task(stream_control *c);

/* Let the limit switches and the emergency stop that are open now stop a job at once, if `hard`: a
 * machine that cannot do so is refused. Returns 0, or an exit code after one message. */
int stream_limits(const talk *t, bool hard, loft_job *head);

#endif

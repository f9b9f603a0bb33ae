/* host-tools/send/stream.h -- sends a job to the machine: keys, progress, the end
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STREAM_H
#define LOFT_STREAM_H

#include <stddef.h>

#include "read/drawing.h"        /* drawing */
#include "plan/job.h"            /* job, kinematics */
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

/* The limits of a greeted machine. */
void stream_machine(const loft_sender *s, engine_limits *l);

/* Where a new job begins: the place of the motors, in whole multiples of 2^-16 mm, which become the
 * same steps again. Where the machine's current job began. */
void stream_new_start(const loft_sender *s, double out[ENGINE_AXES]);
void stream_old_start(const loft_sender *s, bool points, double out[ENGINE_AXES]);

/* Begin `j` on the greeted machine, plan on while it draws, and wait for the end. Returns an exit
 * code, after printing the closing line or one error. */
int stream_run(talk *t, job *j, const stream_subject *about);

/* Hold, resume or abort whatever the machine does, and print where it stands. Returns an exit
 * code. */
int stream_control(talk *t, enum loft_verb verb, const kinematics *k);

/* Let the limit switches and the emergency stop that are open now stop a job at once, if `hard`: a
 * machine that cannot do so is refused. Returns 0, or an exit code after printing one line. */
int stream_limits(const talk *t, bool hard, loft_job *head);

#endif

/* host-tools/send/stream_end.h -- how a job ended, in one line
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STREAM_END_H
#define LOFT_STREAM_END_H

#include "send/stream.h"

/* The sender is at its end: drawn, aborted, or why not. Each prints one line and gives the exit
 * code. */
int stream_ended(talk *t, job *j, const stream_subject *about);

/* ^C: the machine stands on the path, and where. */
int stream_interrupted(const talk *t, const job *j);

/* A hold, resume or abort from the command line was done. */
int stream_obeyed(const talk *t, enum loft_verb verb, const kinematics *k);

/* Where the tool is for steps of the motors, in mm. */
void stream_place(const loft_sender *s, const kinematics *k, const int32_t steps[LOFT_AXES],
                  double out[LOFT_AXES]);

#endif

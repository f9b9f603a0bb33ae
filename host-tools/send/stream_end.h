/* host-tools/send/stream_end.h -- reports in one line how a job ended
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STREAM_END_H
#define LOFT_STREAM_END_H

#include "send/stream.h"

/* The sender has ended: the job was drawn or aborted, or failed. Prints one line and returns the
 * exit code. */
int stream_ended(talk *t, job *j, const stream_subject *about);

/* ^C: the machine has stopped on the path; print where. */
int stream_interrupted(const talk *t, const job *j);

/* A hold, resume or abort from the command line was done. */
int stream_obeyed(const talk *t, enum loft_verb verb, const kinematics *k);

/* The position of the tool in mm for steps of the motors. */
void stream_place(const loft_sender *s, const kinematics *k, const int32_t steps[LOFT_AXES],
                  double out[LOFT_AXES]);

#endif

/* host-tools/send/stream_end.h -- reports in one line how a job ended
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STREAM_END_H
#define LOFT_STREAM_END_H

#include "send/stream.h"

/* The sender has ended, and the job was not drawn. Gives one message and returns the exit code. */
int stream_ended(talk *t, const job *j);

/* The job was drawn, and all of it is planned: is it as commanded? Returns 0, or an exit code after
 * one message. */
int stream_checked(talk *t, const job *j, const send_teller *to);

/* ", worst path error 0.0031 mm": as the machine recorded it, if it did. Returns 0, TASK_GOES while
 * the record is not complete and not `late`, or an exit code after one message. */
int stream_error(const talk *t, const stream_subject *about, bool late, char text[64]);

/* Tell the closing lines; `error` is that text. */
void stream_drawn(const talk *t, const job *j, const stream_subject *about, const send_teller *to,
                  const char *error);

/* The user asked for the end: the machine has stopped on the path; say where. */
int stream_interrupted(const talk *t, const job *j);

/* A hold, resume or abort from the command line was done. */
void stream_obeyed(const talk *t, enum loft_verb verb, const kinematics *k, const send_teller *to);

#endif

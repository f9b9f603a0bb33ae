/* host-tools/cmd/run_drawing.h -- a job is run: keys, progress, pauses between tools
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_RUN_DRAWING_H
#define LOFT_RUN_DRAWING_H

#include "read/machine_tools.h" /* machine_tool */
#include "send/stream.h"        /* stream_subject */

/* Send a job to the greeted machine and wait for its end. Returns an exit code, after printing the
 * closing line or one error. */
int run_drawing(talk *t, job *j, const stream_subject *about);

/* The lines of a job: events to the report, the end to standard output. */
send_teller run_teller(void);

/* Hold, resume or abort what the machine does. Results as above. */
int run_control(talk *t, enum loft_verb verb, const kinematics *k);

/* Print the pause of a tool, and wait for Enter or for an empty line on standard input, then for
 * its delay. `asks`: standard input is free for that. Returns 0, or EX_TEMPFAIL after one line: q,
 * ^C, the end of standard input. */
int run_change(const machine_tool *tool, bool asks);

#endif

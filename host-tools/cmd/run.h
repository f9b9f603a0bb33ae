/* host-tools/cmd/run.h -- the loop of a command: steps a task, and waits between the steps
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_RUN_H
#define LOFT_RUN_H

#include "send/grbl.h"      /* grbl */
#include "send/talk.h"      /* talk, task */

/* Step it until it is over. ^C asks it to stop. What does not come in time is told in one line. */
int run_until(task t);

/* Open a port, and wait until it is. Returns 0, or an exit code after one message. */
int run_line(transport *t, const char *name, unsigned baud);

/* Open a port and greet the machine; the port is closed after an error. Returns 0, or an exit code
 * after printing one line. */
int run_open(talk *t, const talk_options *o);

/* Greet it again: a session has one job. Results as above, but the line stays open. */
int run_again(talk *t, double seconds);

/* The same for a controller of grbl's kind. */
int run_controller(grbl **g, const talk_options *o);

#endif

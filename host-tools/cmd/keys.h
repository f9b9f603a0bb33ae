/* host-tools/cmd/keys.h -- single keys and ^C while a job runs; the terminal is restored on every
 * exit
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_KEYS_H
#define LOFT_KEYS_H

#include <stdbool.h>

/* Catch ^C, TERM and HUP. If `single`, also read keys one by one without echo; standard input must
 * then be a terminal. */
void keys_start(bool single);
void keys_stop(void);

/* Whatever ends the program, write this to the terminal before, on standard error; NULL: nothing.
 * The text must stay where it is. */
void keys_leave_by(const char *text);

/* The next key, or 0. */
int keys_next(void);

/* The answer to a question: the next key of a terminal, or the next byte of what standard input is
 * else. 0: none came within so many ms; KEYS_END: none will come. */
#define KEYS_END (-1)
int keys_answer(int wait);

/* While this is true, the first ^C ends the program at once, with EX_TEMPFAIL: nothing has been
 * sent yet, and a long computation does not check keys_interrupted. */
void keys_hasty(bool hasty);

/* True if the user has asked to stop. The second ^C ends the program at once, with EX_TEMPFAIL. */
bool keys_interrupted(void);

#endif

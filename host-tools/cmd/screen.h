/* host-tools/cmd/screen.h -- the whole terminal as a grid of characters, restored on every exit
 * SPDX-License-Identifier: MIT
 *
 * The terminal is that of standard error. Keys are those of cmd/keys.h, which must have started.
 */
#ifndef LOFT_SCREEN_H
#define LOFT_SCREEN_H

#include <stdbool.h>

/* Refuse the option `name` without a terminal. Returns 0, or an exit code after one line. */
int screen_check(const char *name);

/* Take the terminal. Returns false if it cannot do this. A second call does nothing. */
bool screen_open(void);

/* Give it back, with what it showed before. Does nothing if no screen is open. */
void screen_close(void);

/* The size now: the window of a terminal may change. */
void screen_size(int *rows, int *columns);

/* Put a text at row 0.. and column 0..: what lies beyond the edge is cut. */
void screen_put(int row, int column, const char *text);

/* The next screen_show writes every character anew. Does nothing if no screen is open. */
void screen_paint(void);

/* Show all that was put since the last call, and nothing else. */
void screen_show(void);

#endif

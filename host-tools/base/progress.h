/* host-tools/base/progress.h -- a progress bar with the remaining time, on a terminal; nothing in a
 * pipe
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PROGRESS_H
#define LOFT_PROGRESS_H

#include <stdbool.h>

typedef struct {
    bool shown;                 /* standard error is a terminal      */
    double total;               /* the amount that is 100 % */
    double last, first;         /* clock of the last call; amount at the first call */
    double worked, left;        /* seconds of work without rests; remaining seconds */
    bool resting;
    double drawn;               /* clock of the last redraw */
} progress;

void progress_start(progress *p, double total);

/* The same, for what mostly takes less than a second: nothing is shown before that. */
void progress_start_late(progress *p, double total);

/* Show `done` of the total and a short text, at most ten times a second. */
void progress_show(progress *p, double done, const char *text);

/* Nothing can go on until the next call of progress_show: this time does not count, and the
 * remaining time stays. */
void progress_rest(progress *p);

/* Remove the bar, so that a line can be printed. The second function removes any that is drawn. */
void progress_clear(progress *p);
void progress_clear_any(void);

/* From now on the program computes: on a terminal, a line says so after 1 s, 10 s and so on, if no
 * bar is drawn. `what` must stay; NULL: it does not compute any more. */
void progress_watch(const char *what);

#endif

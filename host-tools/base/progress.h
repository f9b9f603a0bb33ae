/* host-tools/base/progress.h -- a bar with the time that is left, on a terminal; nothing in a pipe
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PROGRESS_H
#define LOFT_PROGRESS_H

#include <stdbool.h>

typedef struct {
    bool shown;                 /* standard error is a terminal      */
    double total;               /* what 100 % is                     */
    double last, first;         /* clock of the last call, amount at the first */
    double worked, left;        /* seconds without rests; that are left        */
    bool resting;
    double drawn;               /* clock of the last picture         */
} progress;

void progress_start(progress *p, double total);

/* Show `done` of the total and a short text; at most ten times a second. */
void progress_show(progress *p, double done, const char *text);

/* Until the next call of progress_show nothing could go on: this time does not count, and what is
 * left stays. */
void progress_rest(progress *p);

/* Remove the bar, so that a line can be printed. */
void progress_clear(progress *p);

#endif

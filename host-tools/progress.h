/* host-tools/progress.h -- a bar with the time that is left, on a terminal; nothing in a pipe
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PROGRESS_H
#define LOFT_PROGRESS_H

#include <stdbool.h>

typedef struct {
    bool shown;                 /* standard error is a terminal      */
    double total;               /* what 100 % is                     */
    double began, first;        /* clock and amount at the first call */
    double drawn;               /* clock of the last picture         */
} progress;

void progress_start(progress *p, double total);

/* Show `done` of the total and a short text; at most ten times a second. */
void progress_show(progress *p, double done, const char *text);

/* Remove the bar, so that a line can be printed. */
void progress_clear(progress *p);

#endif

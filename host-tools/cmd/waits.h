/* host-tools/cmd/waits.h -- says what a command waits for, also without a terminal
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WAITS_H
#define LOFT_WAITS_H

#include <stdbool.h>

#define WAITS_AFTER 1.5     /* s of waiting before the message */

/* Initialize with { 0 }. */
typedef struct {
    char what[200];         /* the awaited event, "": none */
    double since;           /* the clock at its start */
    bool told;
} waits;

/* Call this in each iteration of a loop that waits. Returns true once, when `what` has been awaited
 * for WAITS_AFTER. "": nothing is awaited. */
bool waits_due(waits *w, const char *what, double now);

/* The same, and then print it in one line on standard error. */
void waits_for(waits *w, const char *what, double now);

#endif

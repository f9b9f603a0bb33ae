/* host-tools/base/waits.h -- a command that waits says for what, also without a terminal
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WAITS_H
#define LOFT_WAITS_H

#include <stdbool.h>

#define WAITS_AFTER 1.5     /* s of waiting until it is said */

/* Begins as { 0 }. */
typedef struct {
    char what[200];         /* is awaited, "": nothing */
    double since;           /* the clock               */
    bool told;
} waits;

/* Call it in each turn of a loop that waits. `what` has been awaited for WAITS_AFTER: one line on
 * standard error, once. NULL: nothing is awaited. */
void waits_for(waits *w, const char *what);

#endif

/* ports/linux-gpio/inputs.h -- switches by their edges: what counts is one that closes and stays
 * closed
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_INPUTS_H
#define LOFT_INPUTS_H

#include <poll.h>

#include "linux-gpio/lines.h"

/* A switch. Where the kernel debounces, an edge is a change that has lasted; else it counts when no
 * edge has come for that long. */
struct input {
    int64_t edge;               /* when one came last, in ns; 0: what it has become is known */
    bool closed;
};

struct inputs {
    struct lines *lines;
    unsigned quiet_us;          /* after which an edge was the last             */
    bool lost;                  /* a chip no longer tells of edges              */
    struct input input[LINE_INPUTS];
};

void     inputs_init(struct inputs *in, struct lines *lines, unsigned debounce_us);

/* Those that are closed for good: a sum of LOFT_INPUT_; a limit serves both ends of its axis. */
uint16_t inputs_closed(struct inputs *in);

/* What to poll for; *ms becomes less if inputs_closed is to be called sooner. Gives the count. */
unsigned inputs_watch(struct inputs *in, struct pollfd fd[LINE_INPUTS], int *ms);

#endif

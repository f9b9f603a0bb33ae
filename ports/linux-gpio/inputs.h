/* ports/linux-gpio/inputs.h -- switches by their edges, debounced
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_INPUTS_H
#define LOFT_INPUTS_H

#include <poll.h>

#include "linux-gpio/machine_lines.h"

/* A switch. If the kernel debounces, an edge is a steady change. Otherwise it counts when no edge
 * has come for the debounce time. */
struct input {
    int64_t edge;               /* time of the last edge in ns; 0: the state is known */
    bool closed;
};

struct inputs {
    struct lines *lines;
    unsigned quiet_us;          /* the debounce time                            */
    bool lost;                  /* a chip no longer reports edges               */
    struct input input[LINE_INPUTS];
};

void     inputs_init(struct inputs *in, struct lines *lines, unsigned debounce_us);

/* The closed inputs, debounced: a sum of LOFT_INPUT_. A limit serves both ends of its axis,
 * or the first motor of two. */
uint16_t inputs_closed(struct inputs *in);

/* Those that are closed in this moment, as they bounce. */
uint16_t inputs_raw(struct inputs *in);

/* The files to poll; *ms is lowered if inputs_closed must be called sooner. Returns their
 * number. */
unsigned inputs_watch(struct inputs *in, struct pollfd fd[LINE_INPUTS], int *ms);

#endif

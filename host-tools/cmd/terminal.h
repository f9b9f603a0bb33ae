/* host-tools/cmd/terminal.h -- the host of the command: lines on standard error, a bar
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CMD_TERMINAL_H
#define LOFT_CMD_TERMINAL_H

#include <limits.h>

#include "base/host.h"
#include "base/progress.h"

/* Initialize with { 0 }. */
typedef struct {
    progress bar;
    const char *doing;          /* what it shows; NULL: no bar */
    char state[PATH_MAX];       /* the folder for notes of jobs; "": there is none */
} terminal;

/* A host that prints, and draws. `t` outlives it. Without memory the program ends, in one line. */
host terminal_host(terminal *t);

#endif

/* host-tools/cmd/dispatch.h -- a command line: options, struct, one call
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_DISPATCH_H
#define LOFT_DISPATCH_H

#include "cmd/command.h"

/* Read the options of a command from argv[1..] and run it; --help is described. Returns the exit
 * code. */
int dispatch(const command *c, int argc, char **argv);

#endif

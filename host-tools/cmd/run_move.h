/* host-tools/cmd/run_move.h -- a command that moves: its machine, and where the tool is at the end
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_RUN_MOVE_H
#define LOFT_RUN_MOVE_H

#include "send/mover.h"

/* Open the port and greet the machine. `keys`: also read single keys (cmd/keys.h). Returns 0, or an
 * exit code after one message. Call mover_close in any case. */
int run_mover(mover *v, const mover_options *o, bool keys);

/* Unless `code` tells of a failure, print where the tool is; returns `code`. */
int run_told(const mover *v, int code);

#endif

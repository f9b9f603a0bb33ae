/* host-tools/cmd/run_move.h -- the calls of send/mover.h, each run until it is over
 * SPDX-License-Identifier: MIT
 *
 * Each returns 0, or an exit code after printing one line.
 */
#ifndef LOFT_RUN_MOVE_H
#define LOFT_RUN_MOVE_H

#include "send/mover.h"

/* `keys`: also read single keys (cmd/keys.h). Call mover_close in any case. */
int run_mover(mover *v, const mover_options *o, bool keys);

int run_ready(mover *v);
int run_go(mover *v, const mover_move *m, mover_outcome *out);
int run_place(mover *v, unsigned axes, const double at[ENGINE_AXES]);
int run_to(mover *v, const double to[ENGINE_AXES], double feed);

/* Unless `code` tells of a failure, print where the tool is; returns `code`. */
int run_told(const mover *v, int code);

#endif

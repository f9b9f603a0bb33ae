/* host-tools/cmd/stream_grbl.h -- loft stream --grbl: a controller of grbl's kind, which plans
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STREAM_GRBL_H
#define LOFT_STREAM_GRBL_H

#include "cmd/stream_parts.h"   /* stream_options, plan_parts */

/* Send the parts as G-code, one after the other; in a dry run print them. Returns an exit code. */
int stream_grbl(stream_options *o, const plan_parts *all);

#endif

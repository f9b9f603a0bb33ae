/* host-tools/mill/mill_trim.h -- closed loops of a drawing, to which surfaces are trimmed
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_MILL_TRIM_H
#define LOFT_HOST_MILL_TRIM_H

#include "engine/mill.h"        /* mill_trim */

struct host;                /* base/host.h */

/* Read the loops of a drawing into *t, of which tol and plane are set. Returns 0, or an exit code
 * after one message. */
int  mill_trim_read(struct host *h, mill_trim *t, const char *file);
void mill_trim_free(mill_trim *t);

#endif

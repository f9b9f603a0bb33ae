/* host-tools/library/inside.h -- what stands behind the types of library/host.h
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_INSIDE_H
#define LOFT_HOST_INSIDE_H

#include "base/host.h"
#include "library/host.h"
#include "plan/planning.h"      /* planning */
#include "read/drawing.h"       /* drawing */

struct loft_host {
    host h;
    loft_host_calls calls;
};

struct loft_host_drawing {
    drawing d;
    char *file;
};

/* The options of planning. Returns 0, or an exit code after one message. */
int host_planning(loft_host *h, planning *p, const loft_host_plan_options *o);

#endif

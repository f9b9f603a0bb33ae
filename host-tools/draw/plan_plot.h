/* host-tools/draw/plan_plot.h -- a picture of a plan: the path coloured by speed, and speed,
 * acceleration and jerk over time
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PLAN_PLOT_H
#define LOFT_PLAN_PLOT_H

#include "read/drawing.h"        /* drawing */
#include "draw/plot.h"           /* plot_known */
#include "plan/toolpath.h"       /* toolpath */
#include "plan/trace.h"          /* trace */

struct host;                /* base/host.h */

typedef struct {
    const drawing *d;
    const toolpath *path;
    const trace *t;
    const char *name, *output;      /* of the drawing; the extension decides: .png .svg .pdf */
    double size;                    /* width: px, or points                               */
} plan_picture;

/* Draw. Returns 0, or a code of <sysexits.h> after printing one line. */
int plan_plot(struct host *h, const plan_picture *p);

#endif

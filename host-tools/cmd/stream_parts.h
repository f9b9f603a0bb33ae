/* host-tools/cmd/stream_parts.h -- loft stream: its options; the parts of a drawing, by their tools
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STREAM_PARTS_H
#define LOFT_STREAM_PARTS_H

#include "plan/parts.h"         /* plan_parts, planning */
#include "send/talk.h"          /* talk_options */

typedef struct {
    talk_options line;
    planning p;
    const char *file, *record, *from_tool;
    int where;                  /* 1: the machine plans */
    bool points, grbl, g5, dry, check, hold, resume, abort, away, view, json;
    bool chip, asks;            /* the machine plans; standard input can answer */
} stream_options;

/* The parts of a drawing, from the tool that was asked on. Returns 0, or an exit code after
 * printing one line. */
int stream_parts_find(const stream_options *o, const char *file, const drawing *d,
                      const drawing *smooth, plan_parts *all);

#endif

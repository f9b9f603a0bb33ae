/* host-tools/read/machine_tools.h -- the tools of a machine: pens, colours, feeds, heights, pauses
 * SPDX-License-Identifier: MIT
 *
 * Lines `tool.NAME.key = value` of a machine file. The tools draw in the order of the file.
 */
#ifndef LOFT_MACHINE_TOOLS_H
#define LOFT_MACHINE_TOOLS_H

#include <stdbool.h>
#include <stddef.h>

struct host;                /* base/host.h */

#define MACHINE_TOOLS 32

typedef struct {
    char name[24];
    char colours[120], layers[120]; /* what it draws: "red,#00f", "Ink,2"; "": none of them */
    char pause[120];                /* what to do before it draws: stop and say so; "": go on */
    double feed;                    /* mm/s; 0: that of the options */
    double pen_up, pen_down;        /* mm; NAN: as without tools */
    double delay;                   /* s before it draws */
    double diameter;                /* mm, of a cutter; 0: not given */
    double length;                  /* mm, for G43; NAN: not given */
} machine_tool;

typedef struct machine_tools {
    machine_tool tool[MACHINE_TOOLS];
    unsigned count;
} machine_tools;

/* Read one line, which begins with `tool.`. Returns 0, or an exit code after printing one line. */
int machine_tools_line(struct host *h, machine_tools *t, const char *file, unsigned line,
                       const char *text);

/* The tool of a name; NULL: there is none. */
const machine_tool *machine_tools_find(const machine_tools *t, const char *name);

/* True if it draws what no other tool names. */
bool machine_tool_draws_rest(const machine_tool *t);

#endif

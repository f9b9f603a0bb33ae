/* host-tools/cmd/mill_chip.h -- loft mill --plan chip: patches that the machine cuts by itself
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MILL_CHIP_H
#define LOFT_MILL_CHIP_H

#include "mill/patch.h"         /* patch_order */
#include "plan/planning.h"      /* planning */
#include "send/talk.h"          /* TALK_OPTIONS */

typedef struct {
    planning p;
    patch_order o;
    const char *port, *log;
    unsigned baud;
    double wait;
    bool dry;
} mill_chip;

/* Rows of a table of options. */
#define MILL_CHIP_OPTIONS(c)                                                                       \
    TALK_OPTIONS(c),                                                                               \
        TOOL_TEXT("machine", "FILE", &(c).p.file,                                                  \
                  "of --plan chip: a machine as text, see host-tools/MACHINE.md"),                 \
        TOOL_SPEED("feed", &(c).p.feed, 0.016, 1000,                                               \
                   "of --plan chip: on the surface, mm/s, or as 1200mm/min (30)"),                 \
        TOOL_SPEED("travel", &(c).p.travel, 0.016, 1000, "of --plan chip: above it (100)"),        \
        TOOL_TEXT("log", "FILE", &(c).log,                                                         \
                  "of --plan chip: write what passes on the line, in words"),                      \
        TOOL_SWITCH("dry-run", &(c).dry,                                                           \
                    "of --plan chip: plan for a usual machine, print a summary, move nothing")

/* Set the defaults; reads the machine's file if the options name one. Returns 0, or an exit code
 * after printing one line. */
int mill_chip_start(mill_chip *c, int argc, char **argv);

/* Send the surfaces of a file as patches, each as a job. Returns an exit code. */
int mill_chip_run(mill_chip *c, const char *file);

#endif

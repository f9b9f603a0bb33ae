/* host-tools/cmd/mill_chip.h -- loft mill --plan chip: patches that the machine cuts by itself
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MILL_CHIP_H
#define LOFT_MILL_CHIP_H

#include "mill/patch.h"         /* patch_order */
#include "plan/planning.h"      /* planning */
#include "send/talk.h"          /* talk_options */

typedef struct {
    talk_options line;
    const char *machine;        /* a machine file, or NULL */
    double feed, travel;        /* mm/s */
    bool dry;
} mill_chip_options;
extern const option mill_chip_rows[];

typedef struct {
    mill_chip_options a;
    planning p;
    patch_order o;
} mill_chip;

/* Send the surfaces of a file as patches, each as a job. Returns an exit code. */
int mill_chip_run(mill_chip *c, const char *file);

#endif

/* lib/toolpath/patches.h -- a patch of a job becomes the curves of a ball over it, on the machine
 * SPDX-License-Identifier: MIT
 *
 * The last items of a job of curves may be a patch (wire/patch_code.h). Its parts are gathered;
 * when all have come the patch is checked, as the host has checked it, and cut line by line: the
 * planner (planner.h) takes its curves as it has room for them.
 *
 *     parts -> net -> loft_lines -> curves
 *
 * A machine takes patches if it is given them before it starts. Cost: 5.4 kB of RAM with 64
 * columns, 24 bytes of them for each, and 15 to 19 kB of flash on a Cortex-M.
 *
 *     static loft_patches patches;
 *     static loft_tip     row[COLUMNS + 1];
 *     config.plan.patches = loft_patches_init(&patches, row, COLUMNS);
 */
#ifndef LOFT_TOOLPATH_PATCHES_H
#define LOFT_TOOLPATH_PATCHES_H

#include "machine/planner.h"    /* loft_patch_source */
#include "toolpath/lines.h"     /* loft_lines, loft_tip */
#include "wire/patch_code.h"    /* loft_patch_head */

LOFT_BEGIN_C

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_patch_source source;   /* what the planner knows of it; first */
    loft_lines lines;
    loft_vec   net[(LOFT_PATCH_DEGREE + 1) * (LOFT_PATCH_DEGREE + 1)];
    loft_patch_head head;
    loft_tip  *row;
    uint8_t    parts;           /* that have come */
} loft_patches;

/* How a head says that its patch is cut. */
static inline loft_lines_way loft_patches_way(const loft_patch_head *h)
{
    const loft_lines_way way = { loft_real_from_raw(h->radius),
                                 loft_real_from_raw(h->tol),
                                 loft_real_from_raw(h->safe),
                                 h->rows,
                                 h->columns,
                                 h->one_way };
    return way;
}

/* Prepare; row[columns + 1] are the places of a line. Gives what loft_planner_memory takes. */
loft_patch_source *loft_patches_init(loft_patches *p, loft_tip row[], uint16_t columns);

LOFT_END_C

#endif

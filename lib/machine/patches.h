/* lib/machine/patches.h -- a patch of a job becomes the curves of a ball over it, on the machine
 * SPDX-License-Identifier: MIT
 *
 * The last items of a job of curves may be a patch (wire/patch_code.h). Its parts are gathered;
 * when all have come the patch is checked, as the host has checked it, and cut line by line: the
 * planner (planner.h) takes its curves as it has room for them.
 *
 *     parts -> net -> loft_lines -> curves
 */
#ifndef LOFT_MACHINE_PATCHES_H
#define LOFT_MACHINE_PATCHES_H

#include "toolpath/lines.h"     /* loft_lines, loft_tip */
#include "wire/message.h"       /* enum loft_refusal */
#include "wire/patch_code.h"    /* loft_patch_head */

LOFT_BEGIN_C

enum loft_patch_state {
    LOFT_PATCH_NONE,            /* the job has none so far */
    LOFT_PATCH_GATHERED,        /* parts are missing */
    LOFT_PATCH_CUT,             /* it has curves to give */
    LOFT_PATCH_OVER             /* all are given, or it was refused */
};

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_lines lines;
    loft_vec   net[(LOFT_PATCH_DEGREE + 1) * (LOFT_PATCH_DEGREE + 1)];
    loft_patch_head head;
    loft_tip  *row;
    uint16_t   columns;         /* of a line, at most */
    uint8_t    parts;           /* that have come */
    uint8_t    state;           /* enum loft_patch_state */
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

/* Prepare; row[columns + 1] are the places of a line. */
void loft_patches_init(loft_patches *p, loft_tip row[], uint16_t columns);

/* A job begins. */
static inline void loft_patches_begin(loft_patches *p)      { p->state = LOFT_PATCH_NONE; }

/* Take the next part of a patch that begins and ends at `at`.
 *
 *   shape   LOFT_REFUSAL_NONE: taken, and cut from now on if it was the last one
 *   range   LOFT_REFUSAL_ITEM: it is no part that may come now; LOFT_REFUSAL_PATCH: it cannot be
 *           cut so, or has more columns than there is memory for
 *   cost    of the last part that of loft_lines_init */
enum loft_refusal loft_patches_take(loft_patches *p, const loft_item *part, const loft_vec *at);

/* Give the next curve and its feed, mm/min. Returns false when there is none.
 *
 *   cost    that of loft_lines_next */
bool loft_patches_next(loft_patches *p, loft_cubic *out, uint16_t *feed);

LOFT_END_C

#endif

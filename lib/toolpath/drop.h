/* lib/toolpath/drop.h -- how low a cutter may go over sheets without cutting them, for certain
 * SPDX-License-Identifier: MIT
 *
 *     loft_drop d;
 *     if (loft_drop_init(&d, sheets, count, &ball, tol, floor) == LOFT_OK)
 *         z = loft_drop_height(&d, x, y, NULL);
 *
 * No mesh stands between: the search divides the sheets themselves. A piece is left out when a
 * plane separates the cutter from it, which is proved by its corners and the bend of the sheet.
 * Sheets are seen from above: an overhang hides what is below.
 */
#ifndef LOFT_TOOLPATH_DROP_H
#define LOFT_TOOLPATH_DROP_H

#include "toolpath/cutter.h"    /* loft_cutter */
#include "toolpath/sheet.h"     /* loft_sheet */

LOFT_BEGIN_C

#define LOFT_DROP_LEVELS LOFT_SHEET_FINEST

/* What is cut, and with what. Do not fill it yourself: call init. */
typedef struct {
    const loft_sheet *sheet;
    uint32_t count;
    loft_cutter cutter;
    loft_real tol, floor;
    loft_acc slack;             /* of the cutter's own numbers */
} loft_drop;

/* A place of a sheet, found by one search: the next one nearby begins with it. Zero it first. */
typedef struct {
    uint32_t sheet;
    loft_unit u, v;
} loft_drop_spot;

/* The smallest tolerance: 16 LSB in q16, 2^-20 in floats. */
static inline loft_real loft_drop_tol(void)
{
    return LOFT_REAL_LSB > 0 ? 16 * LOFT_REAL_LSB : LOFT_REAL(0.00000095367431640625);
}

/* True if the area (of x and y) is within LOFT_SHEET_REACH and not empty. */
static inline bool loft_drop_takes(const loft_box *area)
{
    const loft_real reach = LOFT_REAL(LOFT_SHEET_REACH);

    for (int k = 0; k < 2; k++)
        if (!(loft_vec_axis(&area->min, k) >= -reach && loft_vec_axis(&area->max, k) <= reach &&
              loft_vec_axis(&area->min, k) < loft_vec_axis(&area->max, k)))
            return false;
    return true;
}

/* Prepare to search.
 *
 *   shape   the sheets must outlive *d
 *   units   tol: how much too high a tip may be; floor: the lowest one, where nothing is below
 *   range   count >= 1, tol >= loft_drop_tol(), floor within LOFT_SHEET_REACH, otherwise
 *           LOFT_ERR_ARG; *d is then untouched
 *   error   none
 *   cost    some comparisons
 */
enum loft_status loft_drop_init(loft_drop *d, const loft_sheet sheet[], uint32_t count,
                                const loft_cutter *cutter, loft_real tol,
                                loft_real floor) LOFT_CHECKED;

/* The lowest height of the tip at (x, y), at least the floor.
 *
 *   range   |x|, |y| up to LOFT_SHEET_REACH, larger ones count as that. `spot`: where the search
 *           begins, and where it ended, or NULL
 *   error   never too low: the cutter cuts nothing there. At most tol too high, where a slope of
 *           LOFT_CUTTER_SLOPE is not exceeded; beside steeper walls and their tops at most as high
 *           as the wall within 2^-6 of its height
 *   cost    a bicubic patch, tol 0.001: 100 to 300 points of the surface; a box test per sheet that
 *           is out of reach
 *   stack   Cortex-M4 4,140   Cortex-M0+ 4,260   ATmega328P 4,110   + callback
 */
loft_real loft_drop_height(const loft_drop *d, loft_real x, loft_real y, loft_drop_spot *spot);

/* True if the cutter, moved straight from one tip to another, cuts nothing.
 *
 *   range   coordinates within LOFT_SHEET_REACH
 *   error   true: proved, for every place of the way. false: it cuts, or passes too near to tell
 *   cost    as loft_drop_height
 */
bool loft_drop_clear(const loft_drop *d, const loft_vec *from, const loft_vec *to);

/* The height at which the cutter may go straight from above one tip to above another.
 *
 *   range   coordinates within LOFT_SHEET_REACH
 *   error   never too low, at least that of both; at most twice as far above these as it must be
 *           and tol
 *   cost    a loft_drop_clear for each power of 2 of the rise in tol
 */
loft_real loft_drop_over(const loft_drop *d, const loft_vec *from, const loft_vec *to);

LOFT_END_C

#endif

/* lib/toolpath/waterline.h -- the path of a cutter around sheets at one height of its tip, as
 * chords that cut nothing
 * SPDX-License-Identifier: MIT
 *
 *     loft_waterline w;
 *     if (loft_waterline_init(&w, &drop, &area, z) == LOFT_OK &&
 *         loft_waterline_begin(&w, &beside, &inside) == LOFT_OK)
 *         while (loft_waterline_next(&w, &tip))
 *             ..                      // once around, the sheets to the right
 *
 * Every chord between two points is proved clear (toolpath/drop.h). The cutter is within tol of a
 * sheet, as seen at the ends and quarters of a chord; where the area ends, the line follows its
 * border.
 */
#ifndef LOFT_TOOLPATH_WATERLINE_H
#define LOFT_TOOLPATH_WATERLINE_H

#include "toolpath/drop.h"      /* loft_drop */

LOFT_BEGIN_C

#define LOFT_WATERLINE_MOST 0x100000u   /* points of a line, at most */

/* A line in progress. Read only `from`, the last point, and `closed`. */
typedef struct {
    loft_drop d, grown[2];      /* the cutter; with tol / 2 and with tol on all of it */
    loft_box area;
    loft_real z, step, least, most;
    loft_vec from;
    loft_real heading[2];
    loft_vec gate[2][2];        /* chords of this line: whoever passes one has gone around */
    uint32_t points;
    bool closed, over;
} loft_waterline;

/* Prepare to walk around what stands above a height of the tip.
 *
 *   range   an area (of x and y) within LOFT_SHEET_REACH and not empty, z within it, the tol of the
 *           drop at least 4 loft_drop_tol(), the radius and tol at most LOFT_CUTTER_MAX, otherwise
 *           LOFT_ERR_ARG; *w is then undefined
 *   error   none
 *   cost    some comparisons
 */
enum loft_status loft_waterline_init(loft_waterline *w, const loft_drop *d, const loft_box *area,
                                     loft_real z) LOFT_CHECKED;

/* True if a line may run here: the cutter is in the area and at least tol / 2 from every sheet.
 *
 *   range   |x|, |y| up to LOFT_SHEET_REACH
 *   error   false also where it passes too near to tell (loft_drop_clear)
 *   cost    loft_drop_clear of a single point
 */
bool loft_waterline_clear(const loft_waterline *w, loft_real x, loft_real y);

/* Begin a line at the border between two places; w->from is its first point.
 *
 *   shape   clear, blocked: x, y; loft_waterline_clear holds at the first, but not at the second
 *   range   otherwise LOFT_ERR_ARG; *w can begin again
 *   error   the point is at most tol / 8 beside the border
 *   cost    one loft_waterline_clear for each halving of their distance
 */
enum loft_status loft_waterline_begin(loft_waterline *w, const loft_vec *clear,
                                      const loft_vec *blocked) LOFT_CHECKED;

/* Give the next point. Returns false, and leaves *out alone, when the line is back at the end of
 * one of its chords, most often the first: w->closed. Where no way on is found it ends without.
 *
 *   error   see above; chords are as long as the cutter's radius, or shorter where the line bends
 *   cost    about 20 loft_waterline_clear and one loft_drop_clear per try, about two tries
 */
bool loft_waterline_next(loft_waterline *w, loft_vec *out);

LOFT_END_C

#endif

/* lib/toolpath/raster.h -- the path of a cutter over sheets, line by line, as chords that cut
 * nothing
 * SPDX-License-Identifier: MIT
 *
 *     loft_raster r;
 *     if (loft_raster_init(&r, &drop, &area, 0, LOFT_REAL(0.01), 0) == LOFT_OK)
 *         while (loft_raster_next(&r, &tip))
 *             ..                      // there along x and back, the steps across by the cusp
 *
 * Every chord between two points is proved clear (toolpath/drop.h). None is higher than tol over
 * the lowest way, as seen at its ends and quarters; beside a wall the path goes up or down on the
 * spot.
 */
#ifndef LOFT_TOOLPATH_RASTER_H
#define LOFT_TOOLPATH_RASTER_H

#include "toolpath/drop.h"      /* loft_drop */

LOFT_BEGIN_C

#define LOFT_RASTER_LOOKS   64  /* places along a line where a cusp is measured, at most */

/* A straight line seen from above, walked in chords. Read only `from`: the last point. */
typedef struct {
    const loft_drop *d;
    loft_vec from, start, end;
    loft_vec next[2];           /* points that are given before the next chord */
    uint32_t at, n;
    uint8_t level, most, queued;
    loft_drop_spot spot;
} loft_pass;

/* Prepare to walk from above (start x, y) to above (end x, y); the first point is p->from.
 *
 *   range   coordinates within LOFT_SHEET_REACH, otherwise LOFT_ERR_ARG; *p is then untouched
 *   error   none
 *   cost    one loft_drop_height
 */
enum loft_status loft_pass_init(loft_pass *p, const loft_drop *d, const loft_vec *start,
                                const loft_vec *end) LOFT_CHECKED;

/* Give the next point. Returns false, and leaves *out alone, at the end.
 *
 *   error   see above, with 4 times the tol of the loft_drop; a chord is at least 2^-16 of the
 *           line, or tol, long, but beside a wall
 *   cost    four loft_drop_height and a loft_drop_clear per try, about two tries
 */
bool loft_pass_next(loft_pass *p, loft_vec *out);

/* The height of the largest cusp that a ball leaves between two parallel lines, `step` apart. It
 * is what both leave of points that the ball touches between them, at a border too.
 *
 *   shape   axis 0: lines along x, at y = `at` and at + step, looked at from x = from to `to`;
 *           axis 1: exchanged
 *   units   measured at a right angle to the surface, from the lowest way between the lines
 *   range   step > 0; 0 where no line meets a sheet
 *   error   2^-4 of it by the sections that are looked at, on surfaces that bend less than the
 *           ball; the height of what the ball cannot reach is not counted
 *   cost    three loft_drop_height for each of LOFT_RASTER_LOOKS places, or fewer; up to six more
 *           where the cusp may be the highest, and up to six places more where it changes much
 *   see     raster_cusp.c
 */
loft_real loft_raster_cusp(const loft_drop *d, unsigned axis, loft_real at, loft_real step,
                           loft_real from, loft_real to);

/* A raster in progress. Read only `place`, `lines`, `cusp`. */
typedef struct {
    loft_drop d, fine;          /* fine: to measure cusps */
    loft_pass pass;
    loft_box area;
    loft_real wish, step;       /* the cusp that is wanted between lines, or 0 */
    loft_real asked, corner;    /* of a spiral: the cusp that is wanted; by how much it is higher
                                 * at the corners of this side than between lines */
    loft_real place, cusp;      /* of this line; the largest cusp until now, as measured */
    uint32_t lines;             /* begun */
    uint8_t axis, side;         /* side: of a spiral, from 0 to 3 around */
    bool spiral, back, linking, begun, over;
} loft_raster;

/* Prepare lines along an axis: 0, x; 1, y; there and back again.
 *
 *   units   cusp: the height that may be left between two lines, or 0; step: the distance of
 *           lines, or 0: one of the two, `cusp` for balls only
 *   range   an area (of x and y) within LOFT_SHEET_REACH and not empty, axis 0 or 1; 0 < cusp <
 *           radius / 2 of a ball, or step > 0, otherwise LOFT_ERR_ARG; *r is then undefined
 *   error   none
 *   cost    one loft_drop_height
 */
enum loft_status loft_raster_init(loft_raster *r, const loft_drop *d, const loft_box *area,
                                  unsigned axis, loft_real cusp, loft_real step) LOFT_CHECKED;

/* Prepare a spiral of straight lines: around the area, to the left, and inward to its middle,
 * without a link. Each side has a step of its own.
 *
 *   range   as above
 *   error   `cusp` of the raster is what is measured between lines times 4 / (1 + sin(a / 2))^2 of
 *           a corner with the angle a on the surface, for there the lines are so much farther: it
 *           is never too small where all bends alike
 *   cost    one loft_drop_height
 */
enum loft_status loft_raster_init_spiral(loft_raster *r, const loft_drop *d, const loft_box *area,
                                         loft_real cusp, loft_real step) LOFT_CHECKED;

/* Give the next point of the path, from the first to the last. Returns false, and leaves *out
 * alone, when it is over.
 *
 *   error   cusps are 92 to 100 % of what is asked where one step decides them; steps are never
 *           smaller than 1/64 of those over a level plane, so walls along a line have larger ones
 *   cost    loft_pass_next; at the end of a line 2 to 6 loft_raster_cusp, and of a spiral 12
 *           loft_drop_height
 */
bool loft_raster_next(loft_raster *r, loft_vec *out);

LOFT_END_C

#endif

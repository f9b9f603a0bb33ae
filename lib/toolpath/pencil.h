/* lib/toolpath/pencil.h -- the path of a ball along a valley of sheets, where it touches in two
 * places
 * SPDX-License-Identifier: MIT
 *
 *     loft_pencil p;
 *     if (loft_pencil_init(&p, &drop, &area) == LOFT_OK &&
 *         loft_pencil_begin(&p, &left, &right, false) == LOFT_OK)
 *         while (loft_pencil_next(&p, &tip))
 *             ..                      // one way along the valley; `true`: the other way
 *
 * Between two points go with loft_pass (toolpath/raster.h): its chords are proved to cut nothing.
 */
#ifndef LOFT_TOOLPATH_PENCIL_H
#define LOFT_TOOLPATH_PENCIL_H

#include "toolpath/drop.h"      /* loft_drop */

LOFT_BEGIN_C

#define LOFT_PENCIL_MOST 0x10000u   /* points of a valley, at most */

/* A place of the ball, and the point of a sheet that it touches there. */
typedef struct {
    loft_vec tip, contact;
} loft_touch;

/* A valley in progress. Read only `from`: the last point. */
typedef struct {
    loft_drop d;                /* finer than that of the caller */
    loft_box area;
    loft_real step, least, most, apart;
    loft_vec from, start;
    loft_vec contact[2];        /* to the left and to the right */
    loft_real heading[2];
    uint32_t points;
    bool over;
} loft_pencil;

/* Prepare to follow valleys.
 *
 *   range   a ball, an area (of x and y) within LOFT_SHEET_REACH and not empty, otherwise
 *           LOFT_ERR_ARG; *p is then undefined
 *   error   none
 *   cost    some comparisons
 */
enum loft_status loft_pencil_init(loft_pencil *p, const loft_drop *d,
                                  const loft_box *area) LOFT_CHECKED;

/* What the ball touches over a place. Returns false where it touches nothing above the floor.
 *
 *   range   |x|, |y| up to LOFT_SHEET_REACH
 *   error   tip: that of loft_drop_height with tol / 16. contact: sqrt(tol / 4 radius) of the
 *           radius beside it, where the ball fits closely more
 *   cost    one loft_drop_height
 */
bool loft_pencil_touch(const loft_pencil *p, loft_real x, loft_real y, loft_touch *out);

/* True if what it touches at two places is so far apart that a valley may lie between: half a
 * radius.
 *
 *   error   none
 *   cost    a length
 */
bool loft_pencil_apart(const loft_pencil *p, const loft_touch *a, const loft_touch *b);

/* Begin in the valley between two places; `back`: the other way. p->from is the first point.
 *
 *   range   LOFT_SINGULAR when the touched point moves from the one to the other without a jump of
 *           half a radius
 *   error   the point is within tol of a place where the ball touches twice
 *   cost    a loft_drop_height for each halving of their distance
 */
enum loft_status loft_pencil_begin(loft_pencil *p, const loft_touch *a, const loft_touch *b,
                                   bool back) LOFT_CHECKED;

/* Give the next point. Returns false, and leaves *out alone, at the end of the valley, of the area,
 * or where it began.
 *
 *   error   as begin; steps are up to half a radius, shorter where the valley bends
 *   cost    about 12 loft_drop_height per try, about two tries
 */
bool loft_pencil_next(loft_pencil *p, loft_vec *out);

LOFT_END_C

#endif

/* lib/toolpath/sector.h -- patches with n sides as sheets for a mill
 * SPDX-License-Identifier: MIT
 *
 * A patch is divided into sectors, and each of them into squares or triangles of parameters. The
 * second derivatives over such a part are bounded by computing with ranges (polygon/jet_ball.h).
 * Where a part has no bound, its quarters are tried:
 *
 *     loft_sector c = { &disk, 0 };            // 0 .. loft_sector_count(&disk) - 1
 *     if (loft_sheet_from_sector(&s, &c, part) == LOFT_SINGULAR)
 *         ..                                   // its quarters: loft_sheet_piece_quarter
 *
 *     patch                       sectors      parts
 *     spatch, gb, toric           sides        triangles: middle, vertex k, vertex k + 1
 *     basepoint                   3            squares: a corner of the triangle, share 1/3 to 1
 *     zheng_ball of 5, 6 sides    sides        squares: a corner, to the parameters of the middle
 *     zheng_ball of 3 sides       1            triangles of u_1 and u_2
 *
 * Those of basepoint and zheng_ball overlap, which does no harm to a search.
 */
#ifndef LOFT_TOOLPATH_SECTOR_H
#define LOFT_TOOLPATH_SECTOR_H

#include "polygon/disk.h"       /* loft_disk */
#include "toolpath/drop.h"      /* LOFT_DROP_LEVELS; loft_sheet */

LOFT_BEGIN_C

/* Part of a patch; the disk is borrowed. Fill it yourself. */
typedef struct {
    const loft_disk *disk;
    uint8_t number;
} loft_sector;

/* The number of sectors of a patch; 0: it has no bounds.
 *
 *   range   no bounds: coordinates other than Wachspress ones, since second derivatives of those
 *           grow without bound at vertices
 *   error   none
 *   cost    some comparisons
 */
unsigned loft_sector_count(const loft_disk *d);

/* Make a loft_surface of a sector, which must outlive it.
 *
 *   range   number < loft_sector_count
 *   error   a point: that of loft_disk, or of loft_basepoint_corner or loft_zheng_ball_eval at
 *           parameters rounded once
 *   cost    two pointers copied; a point: that of the patch's eval
 */
loft_surface loft_surface_from_sector(const loft_sector *c);

/* Make a sheet of a part: a square or a triangle.
 *
 *   range   part.level up to LOFT_DROP_LEVELS, part.i, part.j in it, three axes, a number below
 *           loft_sector_count, otherwise LOFT_ERR_ARG; LOFT_SINGULAR when no bound is found at this
 *           level; LOFT_ERR_RANGE as for loft_sheet_from_tensor; *s is then untouched
 *   error   bend: never too small; nearer to that of the part the smaller it is. At vertices of a
 *           gb patch there is none: at the last level the range of the points themselves is taken
 *   cost    per control point 3 to 6 products of polygon/jet_ball.h
 *   stack   Cortex-M4 24,692   Cortex-M0+ 24,760   ATmega328P 17,111   + callback
 *   see     Moore, Interval Analysis (1966)
 */
enum loft_status loft_sheet_from_sector(loft_sheet *s, const loft_sector *c,
                                        loft_sheet_piece part) LOFT_CHECKED;

LOFT_END_C

#endif

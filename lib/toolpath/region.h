/* lib/toolpath/region.h -- the inside of closed loops in the plane, to which a sheet is trimmed
 * SPDX-License-Identifier: MIT
 *
 *     const loft_region r = { edge, count };
 *     if (loft_region_valid(&r) && loft_sheet_trim(&sheet, &r, true)) ..
 *
 * A point is inside if a ray from it crosses the edges an odd number of times: loops in loops are
 * holes. All decisions are exact.
 */
#ifndef LOFT_TOOLPATH_REGION_H
#define LOFT_TOOLPATH_REGION_H

#include "polygon/domain.h"     /* loft_spot */

LOFT_BEGIN_C

typedef struct {
    loft_spot from, to;
} loft_region_edge;

/* Edges are borrowed; together they form closed loops, in any order. Fill it yourself. */
typedef struct {
    const loft_region_edge *edge;
    uint32_t count;
} loft_region;

/* A spot that decisions accept: coordinates below 2^-50 count as 0. */
static inline loft_spot loft_region_spot(loft_real x, loft_real y)
{
    const loft_real least = LOFT_REAL(1.0 / 1125899906842624.0);
    const loft_spot s = { { loft_real_abs(x) < least ? 0 : x, loft_real_abs(y) < least ? 0 : y } };

    return s;
}

/* True if every edge has coordinates that loft_spot_valid accepts, and as many edges begin as end
 * at each place.
 *
 *   error   none
 *   cost    `count` comparisons per edge
 */
bool loft_region_valid(const loft_region *r);

/* True if the point is inside. On an edge: either.
 *
 *   error   none: exact
 *   cost    two comparisons per edge, and a loft_spot_turn where it passes beside the point
 */
bool loft_region_has(const loft_region *r, loft_spot p);

/* Where a box lies. */
enum loft_region_part {
    LOFT_REGION_OUT,
    LOFT_REGION_BORDER,         /* some edge meets it */
    LOFT_REGION_IN
};

/* Tell where the box between two corners lies, its sides included.
 *
 *   range   low <= high along both axes
 *   error   none: exact
 *   cost    four comparisons per edge, and up to four loft_spot_turn where they do not decide
 */
enum loft_region_part loft_region_part_of(const loft_region *r, loft_spot low, loft_spot high);

LOFT_END_C

#endif

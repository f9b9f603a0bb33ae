/* lib/polygon/disk_part.h -- what the sources of disk.h have in common
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_POLYGON_DISK_PART_H
#define LOFT_POLYGON_DISK_PART_H

#include "polygon/disk.h"       /* loft_disk */

LOFT_BEGIN_C

static inline unsigned loft_disk_next(unsigned i, unsigned n) { return i + 1 < n ? i + 1 : 0; }

static inline loft_unit loft_disk_rest(loft_unit t) { return LOFT_UNIT(1) - t; }

/* A disk without a polygon. */
static inline void loft_disk_begin(loft_disk *r, unsigned sides, loft_disk_at *at,
                                   enum loft_disk_of of, const void *patch)
{
    r->domain = NULL;
    r->coordinates = NULL;
    r->harmonic = NULL;
    r->cut.count = 0;
    r->sides = (uint8_t)sides;
    r->at = at;
    r->of = (uint8_t)of;
    r->patch = patch;
}

LOFT_END_C

#endif

/* lib/wire/patch_code.h -- a patch as items: how it is cut, then its net, two points at a time
 * SPDX-License-Identifier: MIT
 *
 * A job of curves may end with a patch, which the machine cuts by lines of a ball by itself
 * (toolpath/lines.h). Its items have a feed of 0: the first one is its head, the others are points
 * of the net, row by row. Each ends where it begins, as the whole patch does.
 */
#ifndef LOFT_WIRE_PATCH_CODE_H
#define LOFT_WIRE_PATCH_CODE_H

#include "wire/codec.h"     /* loft_item */

LOFT_BEGIN_C

#define LOFT_PATCH_DEGREE   3           /* the highest along u and along v */
#define LOFT_PATCH_PARTS    9           /* the most items of a patch */

/* The head. */
typedef struct {
    int32_t  radius, tol, safe;         /* as in loft_lines_way, mm, raw Q16.16 */
    uint16_t rows, columns;
    uint16_t feed, rapid;               /* on the patch, and above it, mm/min */
    uint8_t  m, n;                      /* degrees along u and v */
    bool     one_way;
} loft_patch_head;

/* Items of a patch, with the head: (m + 1) (n + 1) points, two in each. */
static inline uint8_t loft_patch_parts(const loft_patch_head *head)
{
    return (uint8_t)(1 + ((head->m + 1) * (head->n + 1) + 1) / 2);
}

/* The head as an item; the patch begins and ends at `place`, raw Q16.16 mm.
 *
 *   range   three axes or more; degrees 1..LOFT_PATCH_DEGREE, feeds at least 1 */
void loft_patch_item(loft_item *item, const loft_patch_head *head, const int32_t place[LOFT_AXES]);

/* Two points of the net as an item, raw Q16.16 mm. The last one of an odd number is given twice. */
void loft_patch_points(loft_item *item, const int32_t first[LOFT_AXES],
                       const int32_t second[LOFT_AXES], const int32_t place[LOFT_AXES]);

/* The head that an item is. LOFT_ERR_DATA: it is none, or not within its range. */
enum loft_status loft_item_patch(const loft_item *item, loft_patch_head *out) LOFT_CHECKED;

LOFT_END_C

#endif

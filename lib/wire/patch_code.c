/* lib/wire/patch_code.c
 * SPDX-License-Identifier: MIT
 *
 * In the item of a head, p[0] has three words and p[1] three lengths; further axes have 0:
 *
 *     p[0]    rows + 65536 columns    feed + 65536 rapid    m + 16 n + 256 one_way
 *     p[1]    radius                  tol                   safe
 *
 * The lengths are last, since the points that follow are expected near them.
 */
#include "wire/patch_code.h"

#include "wire/varint.h"    /* loft_word_signed */

#define ONE_WAY 0x100u

static uint32_t pair(uint16_t low, uint16_t high) { return (uint32_t)high << 16 | low; }

void loft_patch_item(loft_item *item, const loft_patch_head *head, const int32_t place[LOFT_AXES])
{
    const uint32_t word[3] = { pair(head->rows, head->columns), pair(head->feed, head->rapid),
                               head->m | (uint32_t)head->n << 4 | (head->one_way ? ONE_WAY : 0) };
    const int32_t size[3]  = { head->radius, head->tol, head->safe };

    for (int i = 0; i < LOFT_AXES; i++) {
        item->p[0][i] = i < 3 ? loft_word_signed(word[i < 3 ? i : 0]) : 0;
        item->p[1][i] = i < 3 ? size[i < 3 ? i : 0] : 0;
        item->p[2][i] = place[i];
    }
    item->ticks = 0;
}

void loft_patch_points(loft_item *item, const int32_t first[LOFT_AXES],
                       const int32_t second[LOFT_AXES], const int32_t place[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        item->p[0][i] = first[i];
        item->p[1][i] = second[i];
        item->p[2][i] = place[i];
    }
    item->ticks = 0;
}

enum loft_status loft_item_patch(const loft_item *item, loft_patch_head *out)
{
    uint32_t word[3] = { 0, 0, 0 };
    int32_t size[3]  = { 0, 0, 0 };

    for (int i = 0; i < LOFT_AXES; i++) {
        if (i >= 3 && (item->p[0][i] != 0 || item->p[1][i] != 0))
            return LOFT_ERR_DATA;
        word[i < 3 ? i : 0] = (uint32_t)item->p[0][i];
        size[i < 3 ? i : 0] = item->p[1][i];
    }
    out->rows    = (uint16_t)(word[0] & 0xFFFFu);
    out->columns = (uint16_t)(word[0] >> 16);
    out->feed    = (uint16_t)(word[1] & 0xFFFFu);
    out->rapid   = (uint16_t)(word[1] >> 16);
    out->m       = (uint8_t)(word[2] & 15u);
    out->n       = (uint8_t)(word[2] >> 4 & 15u);
    out->one_way = (word[2] & ONE_WAY) != 0;
    out->radius  = size[0];
    out->tol     = size[1];
    out->safe    = size[2];
    return item->ticks == 0 && word[2] < 2 * ONE_WAY && out->feed >= 1 && out->rapid >= 1 &&
                   out->m >= 1 && out->m <= LOFT_PATCH_DEGREE && out->n >= 1 &&
                   out->n <= LOFT_PATCH_DEGREE
               ? LOFT_OK
               : LOFT_ERR_DATA;
}

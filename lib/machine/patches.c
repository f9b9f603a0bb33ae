/* lib/machine/patches.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/patches.h"

#if LOFT_MACHINE_PATCHES            /* a chip that does not cut is built without toolpath/lines.c */

void loft_patches_init(loft_patches *p, loft_tip row[], uint16_t columns)
{
    p->row = row;
    p->columns = columns;
    p->state = LOFT_PATCH_NONE;
}

static loft_vec point_of(const int32_t raw[LOFT_AXES])
{
    loft_vec v;

    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_real_from_raw(raw[i]);
    return v;
}

static bool ends_there(const loft_item *part, const loft_vec *at)
{
    const loft_vec end = point_of(part->p[2]);

    return part->ticks == 0 && loft_vec_equal(end, *at);
}

static enum loft_refusal take_head(loft_patches *p, const loft_item *part)
{
    if (loft_item_patch(part, &p->head) != LOFT_OK)
        return LOFT_REFUSAL_ITEM;
    if (p->head.columns > p->columns)
        return LOFT_REFUSAL_PATCH;
    p->parts = 1;
    p->state = LOFT_PATCH_GATHERED;
    return LOFT_REFUSAL_NONE;
}

/* The net is complete. */
static enum loft_refusal begin_lines(loft_patches *p, const loft_vec *at)
{
    const loft_patch_head *h = &p->head;
    const loft_lines_way way = loft_patches_way(h);
    loft_tensor patch;

    p->state = LOFT_PATCH_OVER;
    if (loft_tensor_init(&patch, p->net, h->m, h->n) != LOFT_OK ||
        loft_lines_init(&p->lines, &patch, &way, at, p->row, p->columns + (size_t)1) != LOFT_OK)
        return LOFT_REFUSAL_PATCH;
    p->state = LOFT_PATCH_CUT;
    return LOFT_REFUSAL_NONE;
}

enum loft_refusal loft_patches_take(loft_patches *p, const loft_item *part, const loft_vec *at)
{
    if (p->state > LOFT_PATCH_GATHERED || !ends_there(part, at))
        return LOFT_REFUSAL_ITEM;
    if (p->state == LOFT_PATCH_NONE)
        return take_head(p, part);
    const unsigned count = (p->head.m + 1u) * (p->head.n + 1u);
    for (unsigned k = 0; k < 2 && 2 * (p->parts - 1u) + k < count; k++)
        p->net[2 * (p->parts - 1u) + k] = point_of(part->p[k]);
    p->parts++;
    return p->parts == loft_patch_parts(&p->head) ? begin_lines(p, at) : LOFT_REFUSAL_NONE;
}

bool loft_patches_next(loft_patches *p, loft_cubic *out, uint16_t *feed)
{
    bool cuts;

    if (p->state != LOFT_PATCH_CUT)
        return false;
    if (!loft_lines_next(&p->lines, out, &cuts)) {
        p->state = LOFT_PATCH_OVER;
        return false;
    }
    *feed = cuts ? p->head.feed : p->head.rapid;
    return true;
}

#endif

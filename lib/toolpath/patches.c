/* lib/toolpath/patches.c
 * SPDX-License-Identifier: MIT
 */
#include "toolpath/patches.h"

/* The source is the first member. */
static loft_patches *patches_of(loft_patch_source *source)
{
    return (loft_patches *)(void *)source;
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
    if (p->head.columns > p->source.columns)
        return LOFT_REFUSAL_PATCH;
    p->parts = 1;
    p->source.state = LOFT_PATCH_GATHERED;
    return LOFT_REFUSAL_NONE;
}

/* The net is complete. */
static enum loft_refusal begin_lines(loft_patches *p, const loft_vec *at)
{
    const loft_patch_head *h = &p->head;
    const loft_lines_way way = loft_patches_way(h);
    loft_tensor patch;

    p->source.state = LOFT_PATCH_OVER;
    if (loft_tensor_init(&patch, p->net, h->m, h->n) != LOFT_OK ||
        loft_lines_init(&p->lines, &patch, &way, at, p->row, p->source.columns + (size_t)1) !=
            LOFT_OK)
        return LOFT_REFUSAL_PATCH;
    p->source.state = LOFT_PATCH_CUT;
    return LOFT_REFUSAL_NONE;
}

static enum loft_refusal take_part(loft_patch_source *source, const loft_item *part,
                                   const loft_vec *at)
{
    loft_patches *p = patches_of(source);

    if (p->source.state > LOFT_PATCH_GATHERED || !ends_there(part, at))
        return LOFT_REFUSAL_ITEM;
    if (p->source.state == LOFT_PATCH_NONE)
        return take_head(p, part);
    const unsigned count = (p->head.m + 1u) * (p->head.n + 1u);
    for (unsigned k = 0; k < 2 && 2 * (p->parts - 1u) + k < count; k++)
        p->net[2 * (p->parts - 1u) + k] = point_of(part->p[k]);
    p->parts++;
    return p->parts == loft_patch_parts(&p->head) ? begin_lines(p, at) : LOFT_REFUSAL_NONE;
}

static bool next_curve(loft_patch_source *source, loft_cubic *out, uint16_t *feed)
{
    loft_patches *p = patches_of(source);
    bool cuts;

    if (p->source.state != LOFT_PATCH_CUT)
        return false;
    if (!loft_lines_next(&p->lines, out, &cuts)) {
        p->source.state = LOFT_PATCH_OVER;
        return false;
    }
    *feed = cuts ? p->head.feed : p->head.rapid;
    return true;
}

loft_patch_source *loft_patches_init(loft_patches *p, loft_tip row[], uint16_t columns)
{
    p->source = (loft_patch_source){ take_part, next_curve, columns, LOFT_PATCH_NONE };
    p->row = row;
    return &p->source;
}

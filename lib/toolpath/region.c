/* lib/toolpath/region.c
 * SPDX-License-Identifier: MIT
 */
#include "toolpath/region.h"

static bool is_same(loft_spot a, loft_spot b)
{
    return a.at[0] <= b.at[0] && a.at[0] >= b.at[0] && a.at[1] <= b.at[1] && a.at[1] >= b.at[1];
}

bool loft_region_valid(const loft_region *r)
{
    for (uint32_t k = 0; k < r->count; k++) {
        uint32_t ends = 0, begins = 0;
        if (!loft_spot_valid(r->edge[k].from) || !loft_spot_valid(r->edge[k].to))
            return false;
        for (uint32_t j = 0; j < r->count; j++) {
            begins += is_same(r->edge[j].from, r->edge[k].to);
            ends += is_same(r->edge[j].to, r->edge[k].to);
        }
        if (begins != ends)
            return false;
    }
    return r->count > 2;
}

bool loft_region_has(const loft_region *r, loft_spot p)
{
    bool in = false;

    for (uint32_t k = 0; k < r->count; k++) {
        const loft_region_edge *e = &r->edge[k];
        const bool from = e->from.at[1] > p.at[1], to = e->to.at[1] > p.at[1];
        if (from == to || (e->from.at[0] < p.at[0] && e->to.at[0] < p.at[0]))
            continue;
        /* to the left of the edge that rises */
        if ((to ? loft_spot_turn(&e->from, &e->to, &p) : loft_spot_turn(&e->to, &e->from, &p)) > 0)
            in = !in;
    }
    return in;
}

/* True if the edge may meet the box: no line parts them. */
static bool meets(const loft_region_edge *e, loft_spot low, loft_spot high)
{
    int left = 0, right = 0;

    for (int k = 0; k < 2; k++)
        if ((e->from.at[k] < low.at[k] && e->to.at[k] < low.at[k]) ||
            (e->from.at[k] > high.at[k] && e->to.at[k] > high.at[k]))
            return false;
    for (int k = 0; k < 4; k++) {
        const loft_spot corner = { { k & 1 ? high.at[0] : low.at[0],
                                     k & 2 ? high.at[1] : low.at[1] } };
        const int turn = loft_spot_turn(&e->from, &e->to, &corner);
        left += turn > 0;
        right += turn < 0;
    }
    return left < 4 && right < 4;
}

enum loft_region_part loft_region_part_of(const loft_region *r, loft_spot low, loft_spot high)
{
    for (uint32_t k = 0; k < r->count; k++)
        if (meets(&r->edge[k], low, high))
            return LOFT_REGION_BORDER;
    return loft_region_has(r, low) ? LOFT_REGION_IN : LOFT_REGION_OUT;
}

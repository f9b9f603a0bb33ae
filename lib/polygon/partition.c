/* lib/polygon/partition.c
 * SPDX-License-Identifier: MIT
 *
 * A run of successive vertices may be cut off if it is a convex polygon and no other vertex lies in
 * it or on its border. Then no edge passes through it: an edge could enter and leave only over the
 * diagonal, and it meets that line once. A polygon with more than three sides has an ear, a run of
 * three. So something can always be cut off, with or without straight angles.
 */
#include "polygon/partition.h"

/* The remaining polygon, and a run in it. */
typedef struct {
    const loft_spot *v;
    uint8_t vertex[LOFT_SIDES_MAX];
    unsigned count;
    unsigned start, length;
} remainder_run;

static unsigned vertex_at(const remainder_run *r, unsigned k)
{
    return r->vertex[(r->start + k) % r->count];
}

/* The side of edge k of the run on which the vertex is: 1 inside, 0 on its line. The last edge
 * closes the run. */
static int turn_at(const remainder_run *r, unsigned k, unsigned vertex)
{
    const unsigned after = vertex_at(r, k + 1 < r->length ? k + 1 : 0);

    return loft_spot_turn(&r->v[vertex_at(r, k)], &r->v[after], &r->v[vertex]);
}

static bool is_convex(const remainder_run *r)
{
    for (unsigned k = 0; k < r->length; k++)
        for (unsigned i = 2; i < r->length; i++)
            if (turn_at(r, k, vertex_at(r, (k + i) % r->length)) <= 0)
                return false;
    return true;
}

static bool has_within(const remainder_run *r, unsigned vertex)
{
    for (unsigned k = 0; k < r->length; k++)
        if (turn_at(r, k, vertex) < 0)
            return false;
    return true;
}

static bool is_part(const remainder_run *r)
{
    if (!is_convex(r))
        return false;
    for (unsigned k = r->length; k < r->count; k++)
        if (has_within(r, vertex_at(r, k)))
            return false;
    return true;
}

/* The longest run that is a convex piece; of those the first. */
static void find_run(remainder_run *r)
{
    for (r->length = r->count; r->length > 2; r->length--)
        for (r->start = 0; r->start < (r->length < r->count ? r->count : 1); r->start++)
            if (is_part(r))
                return;
}

/* Cut off the run; its ends stay. */
static void cut_off(remainder_run *r)
{
    uint8_t left[LOFT_SIDES_MAX];
    unsigned count = 0;

    for (unsigned k = r->length - 1; k <= r->count; k++)
        left[count++] = (uint8_t)vertex_at(r, k);
    for (unsigned k = 0; k < count; k++)
        r->vertex[k] = left[k];
    r->count = count;
}

void loft_partition_init(loft_partition *p, const loft_domain *d)
{
    remainder_run r = { d->v, { 0 }, d->sides, 0, 0 };

    for (unsigned k = 0; k < d->sides; k++)
        r.vertex[k] = (uint8_t)k;
    for (p->count = 0; r.count > 2 && p->count < LOFT_PARTS_MAX; p->count++) {
        find_run(&r);
        p->sides[p->count] = (uint8_t)r.length;
        for (unsigned k = 0; k < r.length; k++)
            p->vertex[p->count][k] = (uint8_t)vertex_at(&r, k);
        cut_off(&r);
    }
}

/* tests/lib/polygon/test_partition.c -- properties of lib/polygon/partition.h
 * SPDX-License-Identifier: MIT
 */
#include "support/arb_polygon.h"            /* arb_convex, arb_simple, arb_winding */
#include "polygon/partition.h"

static arb_domain arb_any(arb *a)
{
    switch (arb_below(a, 4)) {
    case 0:  return arb_convex(a);
    case 1:  return arb_simple(a);
    default: return arb_winding(a);
    }
}

/* Twice the area of a polygon of some of the vertices, times 2^32. */
static exact_wide area_of(const arb_domain *p, const uint8_t vertex[], unsigned count)
{
    exact_wide sum = 0;

    for (unsigned k = 1; k + 1 < count; k++)
        sum += exact_cross(&p->v[vertex[0]], &p->v[vertex[k]], &p->v[vertex[k + 1]]);
    return sum;
}

static void parts_are_strictly_convex(arb *a)
{
    arb_domain p = arb_any(a);
    loft_partition cut;

    settle(&p);
    loft_partition_init(&cut, &p.d);
    CHECK(cut.count >= 1 && (cut.count == 1) == p.d.convex);
    for (unsigned part = 0; part < cut.count; part++) {
        arb_domain own = { .n = cut.sides[part] };
        CHECK(own.n >= 3 && own.n <= p.n);
        for (unsigned k = 0; k < own.n; k++)
            own.v[k] = p.v[cut.vertex[part][k]];
        CHECK(is_convex(&own));
    }
}

/* The areas sum to that of the polygon. Every side belongs to one piece, every diagonal to one
 * piece on each of its sides. All pieces run counter-clockwise, so they cover the polygon once. */
static void parts_cover_the_polygon_once(arb *a)
{
    static const uint8_t every[LOFT_SIDES_MAX] = { 0, 1, 2, 3, 4, 5, 6, 7 };
    arb_domain p = arb_any(a);
    unsigned used[LOFT_SIDES_MAX][LOFT_SIDES_MAX] = { { 0 } }, turns = 0;
    exact_wide area = 0;
    loft_partition cut;

    settle(&p);
    loft_partition_init(&cut, &p.d);
    for (unsigned part = 0; part < cut.count; part++) {
        area += area_of(&p, cut.vertex[part], cut.sides[part]);
        turns += cut.sides[part] - 2u;
        for (unsigned k = 0; k < cut.sides[part]; k++)
            used[cut.vertex[part][k]][cut.vertex[part][(k + 1) % cut.sides[part]]]++;
    }
    CHECK(area == area_of(&p, every, p.n) && turns == p.n - 2);
    for (unsigned i = 0; i < p.n; i++)
        for (unsigned k = 0; k < p.n; k++)
            if (k == (i + 1) % p.n)
                CHECK(used[i][k] == 1 && used[k][i] == 0);
            else if (i != (k + 1) % p.n)
                CHECK(used[i][k] <= 1 && used[i][k] == used[k][i]);
}

int main(void)
{
    PROPERTY(parts_are_strictly_convex,    1000);
    PROPERTY(parts_cover_the_polygon_once, 1000);
    return check_failures();
}

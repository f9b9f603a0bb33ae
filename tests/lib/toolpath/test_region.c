/* tests/lib/toolpath/test_region.c -- properties of lib/toolpath/region.h, and of trimmed sheets
 * SPDX-License-Identifier: MIT
 */
#include "support/sheets.h"

#define EDGES 24

/* A star around a place: 3 to EDGES / 2 corners, at random distances. */
static uint32_t add_star(arb *a, const long double at[2], long double size, loft_region_edge edge[])
{
    const uint32_t n = 3 + arb_below(a, EDGES / 2 - 2);
    loft_spot p[EDGES];

    for (uint32_t k = 0; k < n; k++) {
        const long double turn = 2 * acosl(-1) * k / n,
                          r = size * (1000 + arb_below(a, 1000)) / 2000;
        p[k] = loft_region_spot(LOFT_REAL((double)(at[0] + r * cosl(turn))),
                                LOFT_REAL((double)(at[1] + r * sinl(turn))));
    }
    for (uint32_t k = 0; k < n; k++)
        edge[k] = (loft_region_edge){ p[k], p[(k + 1) % n] };
    return n;
}

/* A ring: a star with a hole. */
static loft_region arb_region(arb *a, const long double at[2], long double size,
                              loft_region_edge edge[2 * EDGES])
{
    const uint32_t n = add_star(a, at, size, edge), hole = add_star(a, at, size / 4, edge + n);
    const loft_region r = { edge, n + hole };

    CHECK(loft_region_valid(&r));
    return r;
}

/* By the angles at which edges are seen. */
static bool has_by_angles(const loft_region *r, loft_spot p)
{
    long double sum = 0;

    for (uint32_t k = 0; k < r->count; k++) {
        const loft_region_edge *e = &r->edge[k];
        const long double x = exact_of(e->from.at[0]) - exact_of(p.at[0]),
                          y = exact_of(e->from.at[1]) - exact_of(p.at[1]),
                          u = exact_of(e->to.at[0]) - exact_of(p.at[0]),
                          v = exact_of(e->to.at[1]) - exact_of(p.at[1]);
        sum += atan2l(x * v - y * u, x * u + y * v);
    }
    return (int)fabsl(roundl(sum / (2 * acosl(-1)))) % 2 == 1;
}

static void a_point_is_where_angles_say(arb *a)
{
    const long double at[2] = { 0, 0 };
    loft_region_edge edge[2 * EDGES];
    const loft_region r = arb_region(a, at, 20, edge);

    for (int k = 0; k < 50; k++) {
        const loft_spot p = { { arb_real(a, 22), arb_real(a, 22) } };
        CHECK(loft_region_has(&r, p) == has_by_angles(&r, p));
    }
    CHECK(!loft_region_valid(&(loft_region){ edge, r.count - 1 }));
    CHECK(!loft_region_valid(&(loft_region){ edge, 2 }));
}

static void a_box_is_where_its_points_are(arb *a)
{
    const long double at[2] = { 0, 0 };
    loft_region_edge edge[2 * EDGES];
    const loft_region r = arb_region(a, at, 20, edge);
    unsigned decided = 0;

    for (int k = 0; k < 40; k++) {
        const loft_spot low = { { arb_real(a, 22), arb_real(a, 22) } };
        loft_spot high = low;
        for (int i = 0; i < 2; i++)
            high.at[i] += loft_real_abs(arb_real(a, 2));
        const enum loft_region_part part = loft_region_part_of(&r, low, high);
        decided += part != LOFT_REGION_BORDER;
        for (int j = 0; j < 30 && part != LOFT_REGION_BORDER; j++) {
            loft_spot p;
            for (int i = 0; i < 2; i++)
                p.at[i] = loft_lerp(low.at[i], high.at[i], loft_unit_of(arb_below(a, 65), 64));
            CHECK(loft_region_has(&r, p) == (part == LOFT_REGION_IN));
        }
    }
    CHECK(decided > 10);
}

/* A cutter over a trimmed sheet: its tip clears what is inside, and is no higher than that asks. */
static void what_is_outside_is_not_there(arb *a)
{
    static hills h;
    const bool plane = arb_below(a, 2);
    const long double at[2] = { plane ? 12 : 0.5, plane ? 12 : 0.5 };
    const loft_cutter c = arb_cutter(a, LOFT_REAL(2));
    loft_region_edge edge[2 * EDGES];
    const loft_region r = arb_region(a, at, plane ? 12 : 0.5L, edge);
    long double least = -60;
    loft_drop d;

    arb_hills(a, arb_below(a, HILLS_KINDS), 5, &h);
    if (!loft_sheet_trim(&h.sheet, &r, plane))
        return;
    const loft_real x = LOFT_REAL(2) + loft_real_abs(arb_real(a, 20)),
                    y = LOFT_REAL(2) + loft_real_abs(arb_real(a, 20));
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(0.002), -LOFT_REAL(60)) == LOFT_OK);
    const long double z = exact_of(loft_drop_height(&d, x, y, NULL));
    for (uint32_t i = 0; i <= 128; i++)
        for (uint32_t j = 0; j <= 128; j++) {
            const bool beyond = h.sheet.surface.over == LOFT_SURFACE_TRIANGLE && i + j > 128;
            const uint32_t u = beyond ? 128 - i : i, v = beyond ? 128 - j : j;
            const loft_vec p = hills_of(&h, u, v, 128);
            const loft_spot on = plane
                                     ? loft_region_spot(p.axis[0], p.axis[1])
                                     : loft_region_spot(LOFT_REAL(u / 128.0), LOFT_REAL(v / 128.0));
            if (loft_region_has(&r, on))
                least = fmaxl(least, tip_over(&c, &p, exact_of(x), exact_of(y)));
        }
    CHECK(z >= least);
    if (c.corner > 0 && least > -50)
        CHECK(z < least + 0.6L);        /* points are 0.25 mm apart */
}

int main(void)
{
    PROPERTY(a_point_is_where_angles_say, 50);
    PROPERTY(a_box_is_where_its_points_are, 50);
    PROPERTY(what_is_outside_is_not_there, 25);
    return check_failures();
}

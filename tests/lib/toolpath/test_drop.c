/* tests/lib/toolpath/test_drop.c -- properties of lib/toolpath/drop.h
 * SPDX-License-Identifier: MIT
 *
 * The reference is brute force: the tip over many points of the surface, and over finer and finer
 * grids around the best of them.
 */
#include "support/sheets.h"

#define GRID 32
#define FLOOR 60

static loft_real arb_radius(arb *a)
{
    return LOFT_REAL(1) + loft_real_from_raw((int32_t)arb_below(a, 262144));
}

/* The highest tip so far, and the point of the grid that gives it. */
typedef struct {
    long double tip;
    uint32_t at[2];
} highest;

/* Try the points from..to of a grid of n steps, ends included. */
static void search_grid(const hills *h, const loft_cutter *c, long double x, long double y,
                        const uint32_t from[2], const uint32_t to[2], uint32_t n, highest *best)
{
    for (uint32_t i = from[0]; i <= to[0] && i <= n; i++)
        for (uint32_t j = from[1]; j <= to[1] && j <= n; j++) {
            const loft_vec p = hills_of(h, i, j, n);
            const long double z = tip_over(c, &p, x, y);
            if (z > best->tip)
                *best = (highest){ z, { i, j } };
        }
}

/* The largest tip over the points of a grid, and then of ever smaller ones around the best. */
static long double tip_by_search(const hills *h, const loft_cutter *c, long double x, long double y)
{
    highest best = { -1e6L, { 0, 0 } };
    uint32_t from[2] = { 0, 0 }, to[2] = { GRID, GRID }, n = GRID;

    search_grid(h, c, x, y, from, to, n, &best);
    for (int level = 0; level < 7; level++) {
        n *= 4;
        for (int k = 0; k < 2; k++) {
            best.at[k] *= 4;
            from[k] = best.at[k] < 8 ? 0 : best.at[k] - 8;
            to[k] = best.at[k] + 8;
        }
        search_grid(h, c, x, y, from, to, n, &best);
    }
    return best.tip;
}

static void a_tip_cuts_nothing_and_is_low(arb *a)
{
    static hills h;
    const loft_cutter c = arb_cutter(a, arb_radius(a));
    const loft_real tol = LOFT_REAL(0.002), x = LOFT_REAL(2) + loft_real_abs(arb_real(a, 20)),
                    y = LOFT_REAL(2) + loft_real_abs(arb_real(a, 20));
    loft_drop d;

    arb_hills(a, arb_below(a, HILLS_KINDS), 5, &h);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, tol, -LOFT_REAL(FLOOR)) == LOFT_OK);
    const long double z = exact_of(loft_drop_height(&d, x, y, NULL)),
                      least = tip_by_search(&h, &c, exact_of(x), exact_of(y));
    CHECK(z >= least);
    CHECK(z >= -FLOOR);
    if (least > -1e5L && c.corner > 0)
        CHECK(z <= least + 0.01L);
    if (least < -1e5L)
        CHECK(z <= -FLOOR + 1e-3L || z <= 6);       /* beside it, or barely so */
}

/* In the middle of level hills the tolerance is kept. */
static void the_tolerance_is_kept(arb *a)
{
    static hills h;
    const loft_cutter c = arb_cutter(a, arb_radius(a));
    const loft_real x = LOFT_REAL(8), y = LOFT_REAL(8);
    loft_drop_spot spot = { 0, 0, 0 };
    loft_drop d;

    do
        arb_hills(a, HILLS_TENSOR, 3, &h);
    while (h.as.tensor.m < 2 || h.as.tensor.n < 2);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(0.001), -LOFT_REAL(FLOOR)) == LOFT_OK);
    const long double z = exact_of(loft_drop_height(&d, x, y, &spot)),
                      least = tip_by_search(&h, &c, 8, 8);
    CHECK(z >= least && z <= least + 0.0015L);
    const long double again = exact_of(loft_drop_height(&d, x, y, &spot));
    CHECK(again >= least && again <= least + 0.0015L);
}

/* A way that is said to be clear is clear at each of its places; one above all others is said to
 * be, and one below the tip at its middle is not. */
static void a_clear_way_cuts_nothing(arb *a)
{
    static hills h;
    const loft_cutter c = arb_cutter(a, arb_radius(a));
    loft_vec from = { { 0 } }, to = { { 0 } };
    loft_drop d;

    arb_hills(a, arb_below(a, HILLS_KINDS), 5, &h);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(0.002), -LOFT_REAL(FLOOR)) == LOFT_OK);
    for (int k = 0; k < 2; k++) {
        from.axis[k] = LOFT_REAL(2) + loft_real_abs(arb_real(a, 20));
        to.axis[k] = from.axis[k] + arb_real(a, 2);
    }
    from.axis[2] = loft_drop_height(&d, from.axis[0], from.axis[1], NULL) + LOFT_REAL(0.002);
    to.axis[2] = loft_drop_height(&d, to.axis[0], to.axis[1], NULL) + LOFT_REAL(0.002);
    if (loft_drop_clear(&d, &from, &to))
        for (uint32_t i = 0; i <= GRID; i++)
            for (uint32_t j = 0; j <= GRID; j++) {
                const loft_vec p = hills_of(&h, i, j, GRID);
                for (int k = 0; k <= 8; k++) {
                    long double at[3];
                    for (int axis = 0; axis < 3; axis++)
                        at[axis] = exact_of(from.axis[axis]) +
                                   (exact_of(to.axis[axis]) - exact_of(from.axis[axis])) * k / 8;
                    CHECK(tip_over(&c, &p, at[0], at[1]) <= at[2] + 1e-12L);
                }
            }
    const long double least = tip_by_search(&h, &c, exact_of(from.axis[0]), exact_of(from.axis[1]));
    if (least > -20) {
        from.axis[2] = LOFT_REAL((double)least - 0.001);
        CHECK(!loft_drop_clear(&d, &from, &to));
    }
    from.axis[2] = to.axis[2] = h.sheet.box.max.axis[2] + LOFT_REAL(0.01);
    CHECK(loft_drop_clear(&d, &from, &to));
}

/* Many sheets are as one. */
static void parts_give_what_the_patch_gives(arb *a)
{
    static hills h;
    static loft_sheet part[64];
    const loft_cutter c = arb_cutter(a, arb_radius(a));
    const loft_real x = arb_real(a, 16), y = arb_real(a, 16);
    loft_drop whole, parts;

    arb_hills(a, HILLS_TENSOR, 5, &h);
    for (unsigned k = 0; k < 64; k++)
        CHECK(loft_sheet_from_tensor_part(&part[k], &h.as.tensor, 3, k / 8, k % 8) == LOFT_OK);
    CHECK(loft_drop_init(&whole, &h.sheet, 1, &c, LOFT_REAL(0.002), -LOFT_REAL(9)) == LOFT_OK);
    CHECK(loft_drop_init(&parts, part, 64, &c, LOFT_REAL(0.002), -LOFT_REAL(9)) == LOFT_OK);
    const long double one = exact_of(loft_drop_height(&whole, x, y, NULL)),
                      many = exact_of(loft_drop_height(&parts, x, y, NULL)),
                      least = tip_by_search(&h, &c, exact_of(x), exact_of(y));
    CHECK(one >= least && many >= least);
    if (least > -9 && c.corner > 0)
        CHECK_NEAR(one, many, 0.01);
}

static void wrong_orders_are_refused(arb *a)
{
    static hills h;
    const loft_cutter c = arb_cutter(a, arb_radius(a));
    loft_drop d;

    arb_hills(a, HILLS_TENSOR, 5, &h);
    CHECK(loft_drop_init(&d, &h.sheet, 0, &c, LOFT_REAL(0.1), 0) == LOFT_ERR_ARG);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, 0, 0) == LOFT_ERR_ARG);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, loft_drop_tol(), LOFT_REAL(5000)) == LOFT_ERR_ARG);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, loft_drop_tol(),
                         BY_NUM(INT32_MIN, -FLT_MAX, (loft_real)-DBL_MAX)) == LOFT_ERR_ARG);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, loft_drop_tol(), 0) == LOFT_OK);
}

int main(void)
{
    PROPERTY(a_tip_cuts_nothing_and_is_low, 30);
    PROPERTY(the_tolerance_is_kept, 15);
    PROPERTY(a_clear_way_cuts_nothing, 20);
    PROPERTY(parts_give_what_the_patch_gives, 12);
    PROPERTY(wrong_orders_are_refused, 1);
    return check_failures();
}

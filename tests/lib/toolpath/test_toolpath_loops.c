/* tests/lib/toolpath/test_toolpath_loops.c -- the loops that headers of lib/toolpath print, word
 * for word, over arbitrary hills
 * SPDX-License-Identifier: MIT
 *
 * tests/house/loops.py compares them with the headers.
 */
#include "support/sheets.h"             /* arb_hills, arb_cutter; CHECK */
#include "toolpath/lines.h"
#include "toolpath/pencil.h"
#include "toolpath/raster.h"
#include "toolpath/waterline.h"

enum { COLUMNS = 32, ROOM = 20000 };

static loft_box square_of(int32_t from, int32_t to)
{
    loft_box area = { { { 0 } }, { { 0 } } };

    for (int k = 0; k < 2; k++) {
        area.min.axis[k] = loft_real_from_int(from);
        area.max.axis[k] = loft_real_from_int(to);
    }
    return area;
}

/* From `here` and back to `here`, without a gap. */
static void lines_over_a_patch_come_back(arb *a)
{
    const loft_vec here = { { LOFT_REAL(-5), LOFT_REAL(3), LOFT_REAL(20) } };
    const unsigned m = 1 + arb_below(a, 3), n = 1 + arb_below(a, 3);
    unsigned curves = 0, cut = 0;
    loft_vec net[16], at = here;
    loft_lines_way way = {
        .radius = LOFT_REAL(1), .tol = LOFT_REAL(0.02), .safe = LOFT_REAL(12), .columns = COLUMNS
    };
    loft_tensor patch;
    loft_cubic curve;
    bool cuts, near;

    for (unsigned k = 0; k < (m + 1) * (n + 1); k++) {
        net[k] = (loft_vec){ { 0 } };
        net[k].axis[0] = loft_real_from_int(30 * (int32_t)(k / (n + 1))) / (loft_real)m;
        net[k].axis[1] = loft_real_from_int(30 * (int32_t)(k % (n + 1))) / (loft_real)n;
        net[k].axis[2] = arb_real(a, 2);
    }
    way.rows = (uint16_t)(1 + arb_below(a, 40));
    way.one_way = arb_below(a, 2) > 0;
    CHECK(loft_tensor_init(&patch, net, m, n) == LOFT_OK);
    const bool fine = loft_lines_check(&patch, &way, &near) == LOFT_LINES_FINE;
    static loft_lines l;
    static loft_tip   row[COLUMNS + 1];
    if (loft_lines_init(&l, &patch, &way, &here, row, COLUMNS + 1) == LOFT_OK)
        while (loft_lines_next(&l, &curve, &cuts)) {
            CHECK(loft_vec_equal(curve.p[0], at));
            at = curve.p[3];
            cut += cuts;
            curves++;
        }
    CHECK(loft_vec_equal(at, here) && (curves > 0) == fine);
    CHECK(cut >= (fine ? COLUMNS * (way.rows + 1u) : 0) && curves < ROOM + cut);
}

/* Between two planes. */
static void a_valley_is_followed_to_the_border(arb *a)
{
    const loft_box area = square_of(-10, 10);
    loft_vec p_[2][4], tip, last = { { 0 } };
    loft_tensor plane[2];
    loft_sheet sheet[2];
    loft_touch left, right;
    loft_cutter c;
    loft_drop drop;
    unsigned count = 0;

    for (int side = 0; side < 2; side++) {
        const loft_real steep = LOFT_REAL(0.7) + loft_real_abs(arb_real(a, 1)),
                        slope_x = side ? steep : -steep, slope_y = arb_real(a, 1) / 4;
        for (int k = 0; k < 4; k++) {
            p_[side][k] = (loft_vec){ { 0 } };
            p_[side][k].axis[0] = loft_real_from_int(k / 2 ? 16 : -16);
            p_[side][k].axis[1] = loft_real_from_int(k % 2 ? 16 : -16);
            p_[side][k].axis[2] = 16 *
                                  ((k / 2 ? slope_x : -slope_x) + (k % 2 ? slope_y : -slope_y));
        }
        CHECK(loft_tensor_init(&plane[side], p_[side], 1, 1) == LOFT_OK);
        CHECK(loft_sheet_from_tensor(&sheet[side], &plane[side]) == LOFT_OK);
    }
    CHECK(loft_cutter_init(&c, LOFT_REAL(2), LOFT_REAL(2)) == LOFT_OK);
    CHECK(loft_drop_init(&drop, sheet, 2, &c, LOFT_REAL(0.01), -LOFT_REAL(60)) == LOFT_OK);
    loft_pencil look;
    CHECK(loft_pencil_init(&look, &drop, &area) == LOFT_OK);
    CHECK(loft_pencil_touch(&look, LOFT_REAL(-2), 0, &left));
    CHECK(loft_pencil_touch(&look, LOFT_REAL(2), 0, &right));
    loft_pencil p;
    if (loft_pencil_init(&p, &drop, &area) == LOFT_OK &&
        loft_pencil_begin(&p, &left, &right, false) == LOFT_OK)
        while (loft_pencil_next(&p, &tip)) {
            CHECK(++count < 100);
            last = tip;
        }
    CHECK(count > 4);
    CHECK(fabsl(exact_of(last.axis[0])) > 8 || fabsl(exact_of(last.axis[1])) > 8);
}

static void a_raster_ends(arb *a)
{
    static hills h;
    const loft_box area = square_of(0, 8);
    loft_cutter c;
    loft_drop drop;
    loft_vec tip;
    unsigned count = 0;

    arb_hills(a, arb_below(a, HILLS_KINDS), 4, &h);
    CHECK(loft_cutter_init(&c, LOFT_REAL(2), LOFT_REAL(2)) == LOFT_OK);
    CHECK(loft_drop_init(&drop, &h.sheet, 1, &c, LOFT_REAL(0.05), -LOFT_REAL(20)) == LOFT_OK);
    loft_raster r;
    if (loft_raster_init(&r, &drop, &area, 0, LOFT_REAL(0.2), 0) == LOFT_OK)
        while (loft_raster_next(&r, &tip)) {
            CHECK(++count < ROOM);
            for (int k = 0; k < 2; k++)
                CHECK(tip.axis[k] >= area.min.axis[k] && tip.axis[k] <= area.max.axis[k]);
        }
    CHECK(count > 8);
}

static void a_waterline_comes_back(arb *a)
{
    static hills h;
    const loft_box area = square_of(-12, 48);
    const loft_real z = arb_real(a, 5), y = loft_real_from_int((int32_t)arb_below(a, 8));
    loft_vec beside = { { 0 } }, inside = { { 0 } }, tip;
    loft_waterline look;
    loft_drop drop;
    unsigned count = 0;
    bool begun = false;

    arb_hills(a, arb_below(a, HILLS_KINDS), 8, &h);
    const loft_cutter c = arb_cutter(a, LOFT_REAL(2));
    CHECK(loft_drop_init(&drop, &h.sheet, 1, &c, LOFT_REAL(0.05), -LOFT_REAL(20)) == LOFT_OK);
    CHECK(loft_waterline_init(&look, &drop, &area, z) == LOFT_OK);
    beside.axis[1] = inside.axis[1] = y;
    for (int32_t k = -24; k < 94 && !begun; k++) {
        beside.axis[0] = loft_real_from_int(k) / 2;
        inside.axis[0] = loft_real_from_int(k + 1) / 2;
        begun = loft_waterline_clear(&look, beside.axis[0], y) &&
                !loft_waterline_clear(&look, inside.axis[0], y);
    }
    if (!begun)
        return;
    loft_waterline w;
    if (loft_waterline_init(&w, &drop, &area, z) == LOFT_OK &&
        loft_waterline_begin(&w, &beside, &inside) == LOFT_OK)
        while (loft_waterline_next(&w, &tip))
            CHECK(++count < ROOM);
    CHECK(count > 2 && w.closed);
}

int main(void)
{
    PROPERTY_LONG(lines_over_a_patch_come_back, 12);
    PROPERTY(a_valley_is_followed_to_the_border, 4);
    PROPERTY_LONG(a_raster_ends,                 2);
    PROPERTY_LONG(a_waterline_comes_back,        4);
    return check_failures();
}

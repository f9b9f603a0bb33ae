/* tests/lib/toolpath/test_sheet.c -- properties of lib/toolpath/sheet.h
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "support/sheets.h"

static hills land;              /* 3 kB: a small chip has no room for more of them */

/* The distance of a point of a piece from the blend of its corners. */
static long double off_of(const hills *h, const loft_sheet *s, uint32_t i, uint32_t j, uint32_t n,
                          uint32_t k, uint32_t l)
{
    const bool triangle = s->surface.over == LOFT_SURFACE_TRIANGLE;
    const loft_vec c[4] = { hills_at(h, loft_unit_of(i, n), loft_unit_of(j, n)),
                            hills_at(h, loft_unit_of(i + 1, n), loft_unit_of(j, n)),
                            hills_at(h, loft_unit_of(i, n), loft_unit_of(j + 1, n)),
                            hills_at(h, loft_unit_of(i + 1, n), loft_unit_of(j + !triangle, n)) };
    const loft_vec p = hills_at(h, loft_unit_of(i * 16 + k, n * 16),
                                loft_unit_of(j * 16 + l, n * 16));
    const long double u = k / 16.0L, v = l / 16.0L;
    long double sum = 0;

    for (int axis = 0; axis < 3; axis++) {
        const long double a = exact_of(c[0].axis[axis]), b = exact_of(c[1].axis[axis]),
                          d = exact_of(c[2].axis[axis]), e = exact_of(c[3].axis[axis]);
        const long double flat = triangle
                                     ? a + u * (b - a) + v * (d - a)
                                     : (1 - u) * ((1 - v) * a + v * d) + u * ((1 - v) * b + v * e);
        sum += (exact_of(p.axis[axis]) - flat) * (exact_of(p.axis[axis]) - flat);
    }
    return sqrtl(sum);
}

static void pieces_are_as_flat_as_the_bend_says(arb *a)
{
    const unsigned kind = arb_below(a, HILLS_KINDS);
    long double most = 0;

    arb_hills(a, kind, 40, &land);
    for (unsigned level = 0; level < 4; level++) {
        const uint32_t n = 1u << level, i = arb_below(a, n),
                       j = arb_below(a, kind >= HILLS_TRIANGLE ? n - i : n);
        for (int k = 0; k < 20; k++) {
            const uint32_t u = arb_below(a, 17),
                           v = arb_below(a, kind >= HILLS_TRIANGLE ? 17 - u : 17);
            const long double off = off_of(&land, &land.sheet, i, j, n, u, v);
            CHECK(off <=
                  exact_acc(land.sheet.bend) / (long double)(n * n) + exact_acc(land.sheet.fuzz));
            most = fmaxl(most, off * (long double)(n * n));
        }
    }
    if (kind == HILLS_TENSOR && land.as.tensor.m + land.as.tensor.n < 3)
        CHECK(exact_acc(land.sheet.bend) < 0x1p-12L);
    for (unsigned k = 0; k < 20; k++) {
        const loft_vec p = hills_of(&land, arb_below(a, 17), arb_below(a, 17), 16);
        for (int axis = 0; axis < 3; axis++)
            CHECK(p.axis[axis] >= land.sheet.box.min.axis[axis] - LOFT_REAL(0x1p-14) &&
                  p.axis[axis] <= land.sheet.box.max.axis[axis] + LOFT_REAL(0x1p-14));
    }
}

static void parts_of_a_patch_are_as_flat(arb *a)
{
    loft_sheet s;

    arb_hills(a, HILLS_TENSOR, 40, &land);
    const unsigned level = 1 + arb_below(a, LOFT_SHEET_LEVELS), n = 1u << level,
                   i = arb_below(a, n), j = arb_below(a, n);
    CHECK(loft_sheet_from_tensor_part(&s, &land.as.tensor, level, i, j) == LOFT_OK);
    CHECK(exact_acc(s.bend) <= exact_acc(land.sheet.bend) / (n * n) + 0x1p-8L);
    for (int k = 0; k < 20; k++) {
        const uint32_t u = arb_below(a, 17), v = arb_below(a, 17);
        CHECK(off_of(&land, &s, i, j, n, u, v) <= exact_acc(s.bend) + exact_acc(s.fuzz));
    }
    CHECK(loft_sheet_from_tensor_part(&s, &land.as.tensor, level, n, 0) == LOFT_ERR_ARG);
    CHECK(loft_sheet_from_tensor_part(&s, &land.as.tensor, LOFT_SHEET_LEVELS + 1, 0, 0) ==
          LOFT_ERR_ARG);
}

/* Of all pieces, down to the finest that are measured and below. */
static void pieces_are_as_flat_as_measured(arb *a)
{
    const unsigned kind = arb_below(a, HILLS_KINDS);
    const bool triangle = kind >= HILLS_TRIANGLE;
    long double most = 0;

    arb_hills(a, kind, 40, &land);
    loft_sheet s = land.sheet;
    const loft_acc near = loft_acc_ratio(s.bend, 1 << arb_below(a, 12)) + loft_acc_ulp(s.bend);
    loft_sheet_measure(&s, near);
    CHECK(s.measured <= LOFT_SHEET_MEASURED);
    for (unsigned level = 0; level <= LOFT_SHEET_MEASURED + 1; level++) {
        const uint32_t n = 1u << level, i = arb_below(a, n), j = arb_below(a, triangle ? n - i : n);
        CHECK(loft_sheet_gap(&s, level) <= loft_sheet_gap(&land.sheet, level));
        for (int k = 0; k < 20; k++) {
            const uint32_t u = arb_below(a, 17), v = arb_below(a, triangle ? 17 - u : 17);
            CHECK(off_of(&land, &s, i, j, n, u, v) <= exact_acc(loft_sheet_gap(&s, level)));
        }
    }
    for (uint32_t u = 0; u <= 16; u++)
        for (uint32_t v = 0; v <= (triangle ? 16 - u : 16); v++) {
            const loft_vec p = hills_of(&land, u, v, 16);
            most = fmaxl(most, off_of(&land, &s, 0, 0, 1, u, v));
            for (int axis = 0; axis < 3; axis++) {
                const long double x = exact_of(p.axis[axis]), fuzz = exact_acc(s.fuzz);
                CHECK(x >= exact_of(s.box.min.axis[axis]) - fuzz);
                CHECK(x <= exact_of(s.box.max.axis[axis]) + fuzz);
            }
        }
    if (s.measured == LOFT_SHEET_MEASURED)
        CHECK(exact_acc(loft_sheet_gap(&s, 0)) <=
              2 * most + exact_acc(s.bend) / 4096 + 2 * exact_acc(s.fuzz));
}

/* A sheet that is flat enough stays as it is, and one without a point. */
static enum loft_status no_point(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    (void)surface;
    (void)v;
    *out = (loft_vec){ { 0 } };
    return u > LOFT_UNIT(0.5) ? LOFT_ERR_RANGE : LOFT_OK;
}

static void what_is_flat_or_has_no_points_is_not_measured(arb *a)
{

    arb_hills(a, HILLS_TENSOR, 40, &land);
    loft_sheet s = land.sheet;
    loft_sheet_measure(&s, s.bend + loft_acc_ulp(s.bend));
    CHECK(s.measured == 0 && memcmp(&s.box, &land.sheet.box, sizeof s.box) == 0);
    s.surface.eval = no_point;
    s.bend = loft_to_acc(LOFT_REAL(1));
    loft_sheet_measure(&s, loft_to_acc(LOFT_REAL(0.125)));
    CHECK(s.measured == 0 && memcmp(&s.box, &land.sheet.box, sizeof s.box) == 0);
}

static void a_bend_of_one_direction_is_sharp(arb *a)
{
    loft_vec p[3];
    loft_tensor t;
    loft_sheet s;

    (void)a;
    for (int k = 0; k < 3; k++) {
        p[k].axis[0] = loft_real_from_int(4 * k);
        p[k].axis[1] = 0;
        p[k].axis[2] = LOFT_REAL(k == 1 ? 10 : 0);
    }
    CHECK(loft_tensor_init(&t, p, 2, 0) == LOFT_OK && loft_sheet_from_tensor(&s, &t) == LOFT_OK);
    CHECK_NEAR(exact_acc(s.bend), 5, 1e-4);     /* half of 10: the height of the arch */
    p[1].axis[2] = LOFT_REAL(5000);
    CHECK(loft_sheet_from_tensor(&s, &t) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(pieces_are_as_flat_as_the_bend_says, 400);
    PROPERTY(parts_of_a_patch_are_as_flat, 100);
    PROPERTY(pieces_are_as_flat_as_measured, 100);
    PROPERTY(what_is_flat_or_has_no_points_is_not_measured, 5);
    PROPERTY(a_bend_of_one_direction_is_sharp, 1);
    return check_failures();
}

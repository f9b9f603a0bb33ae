/* tests/lib/toolpath/test_sector.c -- properties of lib/toolpath/sector.h
 * SPDX-License-Identifier: MIT
 */
#include "support/sheets.h"
#include "support/sided.h"
#include "toolpath/sector.h"

#define PARTS 1024

/* The kinds of support/sided.h that have bounds. */
static const unsigned bounded[5] = { 0, 2, 4, 5, 6 };

/* A part of a surface by its corners, and a place in it: k, l of 16 steps. */
typedef struct {
    uint32_t i, j, n;
    bool triangle, upper;
} piece;

static loft_vec place_in(const loft_surface *s, const piece *p, uint32_t k, uint32_t l)
{
    const uint32_t n = 16 * p->n;
    loft_vec out;

    if (p->upper) {
        k = 16 - k;
        l = 16 - l;
    }
    CHECK(s->eval(s->surface, loft_unit_of(16 * p->i + k, n), loft_unit_of(16 * p->j + l, n),
                  &out) == LOFT_OK);
    return out;
}

/* The distance of a place of a piece from the blend of its corners. */
static long double off_of(const loft_surface *s, const piece *p, uint32_t k, uint32_t l)
{
    const loft_vec c[4] = { place_in(s, p, 0, 0), place_in(s, p, 16, 0), place_in(s, p, 0, 16),
                            p->triangle ? place_in(s, p, 0, 0) : place_in(s, p, 16, 16) },
                   at = place_in(s, p, k, l);
    const long double u = k / 16.0L, v = l / 16.0L;
    long double sum = 0;

    for (int axis = 0; axis < 3; axis++) {
        const long double a = exact_of(c[0].axis[axis]), b = exact_of(c[1].axis[axis]),
                          d = exact_of(c[2].axis[axis]), e = exact_of(c[3].axis[axis]),
                          flat = p->triangle
                                     ? a + u * (b - a) + v * (d - a)
                                     : (1 - u) * ((1 - v) * a + v * d) + u * ((1 - v) * b + v * e),
                          off = exact_of(at.axis[axis]) - flat;
        sum += off * off;
    }
    return sqrtl(sum);
}

static loft_sheet_piece part_of(unsigned level, uint32_t i, uint32_t j, bool upper)
{
    return (loft_sheet_piece){ (uint16_t)i, (uint16_t)j, (uint8_t)level, upper };
}

/* A part of a sector of any kind, of any level. */
static bool arb_part(arb *a, unsigned *level, loft_sheet *s, piece *p)
{
    const scene *x = arb_kind(a, bounded[arb_below(a, 5)], arb_below(a, 2) ? 4 : 0);
    static loft_sector c;

    c = (loft_sector){ &x->round, (uint8_t)arb_below(a, loft_sector_count(&x->round)) };
    *level = arb_below(a, 7);
    p->n = 1u << *level;
    p->triangle = loft_surface_from_sector(&c).over == LOFT_SURFACE_TRIANGLE;
    p->i = arb_below(a, p->n);
    p->j = arb_below(a, p->triangle ? p->n - p->i : p->n);
    p->upper = p->triangle && p->i + p->j + 1 < p->n && arb_below(a, 2);
    return loft_sheet_from_sector(s, &c, part_of(*level, p->i, p->j, p->upper)) == LOFT_OK;
}

/* Any point of a piece is no farther from the blend of its corners than this, and in the box. */
static void check_point(arb *a, const loft_sheet *s, const piece *p, long double most)
{
    const uint32_t u = arb_below(a, 17), v = arb_below(a, p->triangle ? 17 - u : 17);
    const loft_vec at = place_in(&s->surface, p, u, v);

    CHECK(off_of(&s->surface, p, u, v) <= most);
    for (int axis = 0; axis < 3; axis++) {
        const long double x = exact_of(at.axis[axis]), fuzz = exact_acc(s->fuzz);
        CHECK(x >= exact_of(s->box.min.axis[axis]) - fuzz);
        CHECK(x <= exact_of(s->box.max.axis[axis]) + fuzz);
    }
}

static void parts_are_as_flat_as_the_bend_says(arb *a)
{
    unsigned level;
    loft_sheet s;
    piece p;

    if (!arb_part(a, &level, &s, &p))
        return;
    for (int k = 0; k < 30; k++)
        check_point(a, &s, &p, exact_acc(s.bend) + exact_acc(s.fuzz));
}

/* Quarter k of a piece; of a triangle the last one is turned round. */
static piece quarter_of(const piece *p, unsigned k)
{
    const uint32_t far = p->upper;

    if (!p->triangle)
        return (piece){ 2 * p->i + (k & 1), 2 * p->j + (k >> 1), 2 * p->n, false, false };
    return (piece){ 2 * p->i + (k == 1 ? 1 - far : far), 2 * p->j + (k == 2 ? 1 - far : far),
                    2 * p->n, true, (k == 3) != p->upper };
}

static void pieces_of_parts_are_as_flat_as_measured(arb *a)
{
    unsigned level;
    loft_sheet s;
    piece p;

    if (!arb_part(a, &level, &s, &p))
        return;
    const loft_acc bend = s.bend;
    loft_sheet_measure(&s, loft_acc_ratio(bend, 1 << arb_below(a, 12)) + loft_acc_ulp(bend));
    for (unsigned k = 0; k <= LOFT_SHEET_MEASURED + 1; k++) {
        for (int n = 0; n < 10; n++)
            check_point(a, &s, &p, exact_acc(loft_sheet_gap(&s, level + k)));
        p = quarter_of(&p, arb_below(a, 4));
    }
}

/* At a vertex of a gb patch the range of the finest part is about as large as it is. */
static void ranges_at_vertices_are_near(arb *a)
{
    const scene *x = arb_kind(a, 2, 0);
    const loft_sector c = { &x->round, (uint8_t)arb_below(a, x->round.sides) };
    const uint32_t n = 1u << LOFT_DROP_LEVELS;
    const piece p = { n - 1, 0, n, true, false };
    loft_sheet s;

    CHECK(loft_sheet_from_sector(&s, &c, part_of(LOFT_DROP_LEVELS, p.i, p.j, false)) == LOFT_OK);
    long double size = 0;
    for (uint32_t k = 0; k <= 16; k++)
        for (uint32_t l = 0; l <= 16 - k; l++) {
            long double d = 0;
            const loft_vec q = place_in(&s.surface, &p, k, l), o = place_in(&s.surface, &p, 16, 0);
            CHECK(off_of(&s.surface, &p, k, l) <= exact_acc(s.bend) + exact_acc(s.fuzz));
            for (int axis = 0; axis < 3; axis++)
                d += powl(exact_of(q.axis[axis]) - exact_of(o.axis[axis]), 2);
            size = fmaxl(size, sqrtl(d));
        }
    CHECK(exact_acc(s.bend) < 4 * size);
}

/* Third derivatives are all that is added to the second ones: fine parts have bends of the size
 * that they need. */
static void bends_of_fine_parts_are_near(arb *a)
{
    const scene *x = arb_kind(a, bounded[arb_below(a, 5)], 0);
    const loft_sector c = { &x->round, 0 };
    const piece p = { 10, 9, 32, loft_surface_from_sector(&c).over == LOFT_SURFACE_TRIANGLE,
                      false };
    long double most = 0;
    loft_sheet s;

    CHECK(loft_sheet_from_sector(&s, &c, part_of(5, p.i, p.j, false)) == LOFT_OK);
    for (uint32_t k = 0; k <= 16; k++)
        for (uint32_t l = 0; l <= (p.triangle ? 16 - k : 16); l++)
            most = fmaxl(most, off_of(&s.surface, &p, k, l));
    if (most > 0.004L)
        CHECK(exact_acc(s.bend) < 20 * most);       /* 15 with 8 sides and degree 5 */
}

/* All sheets of a patch: what has no bound is divided. */
static uint32_t add_parts(const loft_sector *c, loft_sheet_piece p, loft_sheet out[],
                          uint32_t count)
{
    const bool triangle = loft_surface_from_sector(c).over == LOFT_SURFACE_TRIANGLE;

    CHECK(count < PARTS);
    const enum loft_status status = p.level < 2 ? LOFT_SINGULAR
                                                : loft_sheet_from_sector(&out[count], c, p);
    if (status == LOFT_OK)
        return count + 1;
    CHECK(status == LOFT_SINGULAR && p.level < LOFT_DROP_LEVELS);
    for (unsigned k = 0; k < 4; k++)
        count = add_parts(c, loft_sheet_piece_quarter(&p, triangle, k), out, count);
    return count;
}

static void a_tip_cuts_no_point_of_a_patch(arb *a)
{
    static loft_sheet sheet[PARTS];
    const scene *x = arb_kind(a, bounded[arb_below(a, 5)], 3);
    const loft_cutter c = arb_cutter(a, LOFT_REAL(4));
    loft_sector sector[LOFT_SIDES_MAX];
    uint32_t count = 0;
    loft_drop d;

    for (unsigned k = 0; k < loft_sector_count(&x->round); k++) {
        sector[k] = (loft_sector){ &x->round, (uint8_t)k };
        count = add_parts(&sector[k], part_of(0, 0, 0, false), sheet, count);
    }
    CHECK(loft_drop_init(&d, sheet, count, &c, LOFT_REAL(0.02), -LOFT_REAL(60)) == LOFT_OK);
    for (int place = 0; place < 3; place++) {
        const loft_real at[2] = { arb_real(a, 50), arb_real(a, 50) };
        const long double z = exact_of(loft_drop_height(&d, at[0], at[1], NULL));
        long double most = -1e6L;
        for (int k = 0; k < 1000; k++) {
            const loft_vec p = point_at(x, loft_unit_of(arb_below(a, 4097), 4096),
                                        loft_unit_of(arb_below(a, 4097), 4096));
            const long double tip = tip_over(&c, &p, exact_of(at[0]), exact_of(at[1]));
            most = fmaxl(most, tip);
            CHECK(tip <= z + 1e-9L);
        }
        if (most > 0)
            CHECK(z < most + 5);        /* few points are near */
    }
}

static void what_has_no_bounds_is_refused(arb *a)
{
    loft_sheet s;

    for (unsigned kind = 0; kind < KINDS; kind++) {
        const scene *x = arb_kind(a, kind, 0);
        const loft_sector c = { &x->round, 0 };
        const bool any = kind == 0 || kind == 2 || kind >= 4;
        CHECK((loft_sector_count(&x->round) > 0) == any);
        if (!any)
            CHECK(loft_sheet_from_sector(&s, &c, part_of(3, 0, 0, false)) == LOFT_ERR_ARG);
        CHECK(loft_sheet_from_sector(&s, &c, part_of(LOFT_DROP_LEVELS + 1, 0, 0, false)) ==
              LOFT_ERR_ARG);
        CHECK(loft_sheet_from_sector(&s, &c, part_of(3, 8, 0, false)) == LOFT_ERR_ARG);
    }
}

int main(void)
{
    PROPERTY(parts_are_as_flat_as_the_bend_says, 150);
    PROPERTY(pieces_of_parts_are_as_flat_as_measured, 50);
    PROPERTY(ranges_at_vertices_are_near, 20);
    PROPERTY(bends_of_fine_parts_are_near, 20);
    PROPERTY_LONG(a_tip_cuts_no_point_of_a_patch, 5);
    PROPERTY(what_has_no_bounds_is_refused, 1);
    return check_failures();
}

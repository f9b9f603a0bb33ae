/* tests/lib/curve/test_flatten.c -- chords (lib/curve/measure.h, flatten.c): within the tolerance,
 * and few
 * SPDX-License-Identifier: MIT
 */
#include "curve/forward.h"
#include "curve/measure.h"
#include "support/cubics.h"          /* the reference, CHECK, PROPERTY, arb_shape */

/* All promises for one chord from..to of the parameter. */
static void check_chord(const exact *e, point from, point to, real s, real t, real tol)
{
    real worst = 0, back = 0;

    for (int j = 0; j <= 24; j++)
        worst = fmaxl(worst, distance_from_segment(at(e, s + (t - s) * j / 24), from, to));
    for (int j = 1; j < 4; j++) {               /* points of the chord against a polyline in the
                                                 * curve */
        const point x = between(from, to, j / 4.0L);
        real nearest = INFINITY;
        point p = at(e, s);
        for (int k = 1; k <= 32; k++) {
            const point q = at(e, s + (t - s) * k / 32);
            nearest = fminl(nearest, distance_from_segment(x, p, q));
            p = q;
        }
        back = fmaxl(back, nearest);
    }
    CHECK_NEAR(worst / tol, 0, 1);
    CHECK_NEAR(back / tol, 0, 1 + 0x1p-8L);
}

static void chords_and_curve_are_within_the_tolerance_of_each_other(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 2);
    loft_flatten f;
    loft_vec p, q = c.p[0];
    uint32_t from = 0, chords = 0;

    const bool accepted = loft_flatten_init(&f, &c, tol_of(raw)) == LOFT_OK;
    CHECK(accepted);
    while (p = q, accepted && loft_flatten_next(&f, &q)) {
        if (chords++ % 8 == 0 || chords < 20)
            check_chord(&e, point_of(p), point_of(q), ldexpl(from, -24), ldexpl(f.at, -24),
                        raw / 65536.0L);
        from = f.at;
    }
    CHECK(chords > 0 && loft_vec_equal(q, c.p[3]) && f.at == (uint32_t)1 << 24);
    CHECK(!accepted || !loft_flatten_next(&f, &p));
}

static void equal_steps_are_within_the_tolerance(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 8);
    loft_bezier b;
    loft_forward w;
    loft_vec p = c.p[0], q;

    if (loft_bezier_init(&b, c.p, 3) != LOFT_OK || loft_forward_flatten(&w, &b, tol_of(raw)))
        return;                         /* more steps than the law of ranges allows */
    const uint32_t n = w.left;
    for (uint32_t j = 1; loft_forward_next(&w, &q); j++, p = q)
        if (j % 8 == 1 || j < 20)
            check_chord(&e, point_of(p), point_of(q), (j - 1.0L) / n, (real)j / n, raw / 65536.0L);
    CHECK(loft_vec_equal(p, c.p[3]));
}

/* The bound of a parabola is its distance from the chords. */
static void equal_steps_along_a_parabola_are_few(arb *a)
{
    const int32_t h = 65536 << arb_below(a, 6);
    loft_vec p[3] = { { { 0 } }, { { 0 } }, { { 0 } } };
    loft_bezier b;
    loft_forward w;

    p[1].axis[0] = tol_of(h);
    CHECK(loft_bezier_init(&b, p, 2) == LOFT_OK &&
          loft_forward_flatten(&w, &b, tol_of(655)) == LOFT_OK);
    const double n = sqrt(2.0 / 8 * 2 * h / 655);
    CHECK(w.left >= n && w.left <= n * 1.006 + 2);
}

static uint32_t chords_of(const loft_cubic *c, int32_t raw)
{
    loft_flatten f;
    loft_vec p = c->p[0];
    uint32_t n = 0;
    const bool accepted = loft_flatten_init(&f, c, tol_of(raw)) == LOFT_OK;

    CHECK(accepted);
    while (accepted && loft_flatten_next(&f, &p))
        n++;
    CHECK(loft_vec_equal(p, c->p[3]));
    return n;
}

static void never_more_chords_than_halving_gives(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 8);
    CHECK(chords_of(&c, raw) <= halvings(&e, raw / 65536.0L));
}

/* A piece that is just flat and long, often almost stopping in the middle, and as much of the cubic
 * before it. This is the hard case: a chord may end anywhere in the piece, and the rest must still
 * be one chord. */
static void never_more_chords_than_halving_gives_where_a_piece_halts(arb *a)
{
    const double reach = 4 << arb_below(a, 9);
    const int32_t least = BY_NUM(8, (int32_t)reach * 8, 8),
                  raw = least + (int32_t)arb_below(a, 2u << arb_below(a, 15));
    const double foot = arb_below(a, 2) ? 1 : arb_below(a, 1024) / 1024.0,
                 side = 0.98 * raw / 65536 / sqrt(LOFT_AXES);
    loft_cubic c;

    for (int i = 0; i < LOFT_AXES; i++) {
        const double way = side * (arb_below(a, 2001) / 1000.0 - 1);
        const double b1 = (i ? 0 : foot * reach) + way,
                     b2 = (i ? 0 : (1 - foot) * reach) + (arb_below(a, 2) ? way : -way);
        const double b3 = i ? 0 : reach;
        const double whole[4] = { 6 * b2 - 12 * b1 - b3, 4 * b1 - 4 * b2 + b3, 2 * b2 - b3, b3 };
        for (int k = 0; k < 4; k++)
            c.p[k].axis[i] = BY_NUM((loft_real)(whole[k] * 65536), (loft_real)whole[k],
                                    (loft_real)whole[k]);
    }
    const exact e = exact_of(&c);
    CHECK(chords_of(&c, raw) <= halvings(&e, raw / 65536.0L));
}

static void never_more_chords_than_halving_gives_for_drawings(arb *a)
{
    const loft_cubic c = arb_cubic(a, (int32_t)(1 + arb_below(a, 60)));
    const exact e = exact_of(&c);
    const int32_t raw = 10000 + (int32_t)arb_below(a, 250000);
    CHECK(chords_of(&c, raw) <= halvings(&e, raw / 65536.0L));
}

/* y = 4 d t (1 - t) over a long x: n chords of equal dt leave d / n^2 each, so the fewest are
 * sqrt(d / tol). */
static void a_flat_parabola_takes_the_fewest_chords(arb *a)
{
    const int32_t d = 1 + (int32_t)arb_below(a, 30), raw = 200 + (int32_t)arb_below(a, 60000);
    loft_cubic c = {{{{0}}}};

    for (int k = 0; k < 4; k++)
        c.p[k].axis[0] = LOFT_REAL(9000 * k - 13500);
#if LOFT_AXES > 1
    c.p[1].axis[1] = c.p[2].axis[1] = loft_real_from_int(4 * d) / 3;
    const double fewest = ceil(sqrt(d * 65536.0 / (raw - 1)) * (1 + 1.0 / 256));
    CHECK(chords_of(&c, raw) <= (uint32_t)fewest);
    CHECK(chords_of(&c, raw) >= (uint32_t)floor(sqrt(d * 65536.0 / (raw + 1))));
#endif
}

static void a_straight_even_line_is_one_chord(arb *a)
{
    loft_cubic c;
    c.p[0] = arb_vec(a, 10000);
    const loft_vec step = arb_vec(a, 6000);
    for (int k = 1; k < 4; k++)
        c.p[k] = loft_vec_add(c.p[k - 1], step);
    CHECK(chords_of(&c, 1000) == 1);
}

/* y = 3 d t (1 - t)(1 - 2 t) is at most d / sqrt(12) on either side, with control points at d. */
static void an_inflection_between_sides_within_the_tolerance_is_one_chord(arb *a)
{
    const int32_t d = 1 + (int32_t)arb_below(a, 300);
    loft_cubic c = {{{{0}}}};

    for (int k = 0; k < 4; k++)
        c.p[k].axis[0] = LOFT_REAL(9000 * k - 13500);
    c.p[1].axis[LOFT_AXES - 1] += loft_real_from_int(d);
    c.p[2].axis[LOFT_AXES - 1] -= loft_real_from_int(d);
    if (LOFT_AXES > 1)
        CHECK(chords_of(&c, d * 19200) == 1);           /* d / 3.413 > d / sqrt(12) */
}

/* Along 0, L, 0, L the curve stops in the middle but never turns back. Its second half has control
 * points far behind its start and is still one chord. */
static void a_line_that_halts_is_one_chord(arb *a)
{
    const loft_vec end = arb_vec(a, 1000);
    loft_cubic c = {{{{0}}}};

    c.p[1] = c.p[3] = end;
    const exact e = exact_of(&c);
    exact before, after;
    split(&e, (300 + (int)arb_below(a, 210)) / 1024.0L, &before, &after);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            c.p[k].axis[i] = BY_NUM((loft_real)floorl(after.p[k].x[i] * 65536 + 0.5L),
                                    (loft_real)after.p[k].x[i], (loft_real)after.p[k].x[i]);
    CHECK(chords_of(&c, BY_NUM(8, 64, 8)) == 1);
}

static void tolerances_that_cannot_be_kept_are_refused(arb *a)
{
    loft_cubic c = arb_cubic(a, 32767);
    loft_flatten f;

    c.p[0].axis[0] = LOFT_REAL(32767);
    CHECK(loft_flatten_init(&f, &c, 0) == LOFT_ERR_ARG);
    CHECK(loft_flatten_init(&f, &c, -LOFT_REAL(1)) == LOFT_ERR_ARG);
    const loft_real least = BY_NUM(2, LOFT_REAL(32767) / 4194304, (loft_real)(32767 * 0x1p-43));
    CHECK(loft_flatten_init(&f, &c, least) == LOFT_OK);
    CHECK(loft_flatten_init(&f, &c, least / 2) == LOFT_ERR_RANGE);
    CHECK(loft_flatten_init(&f, &c, BY_NUM(INT32_MAX, LOFT_REAL(1e30), LOFT_REAL(1e30))) ==
          LOFT_OK);
#if LOFT_NUM != LOFT_Q16
    CHECK(loft_flatten_init(&f, &c, (loft_real)NAN) == LOFT_ERR_ARG);
    CHECK(loft_flatten_init(&f, &c, (loft_real)INFINITY) == LOFT_ERR_RANGE);
    c.p[arb_below(a, 4)].axis[0] = arb_below(a, 2) ? (loft_real)NAN : -(loft_real)INFINITY;
    CHECK(loft_flatten_init(&f, &c, LOFT_REAL(1)) == LOFT_ERR_RANGE);
#endif
}

/* The finest tolerance at every size: it terminates, and every piece keeps it. */
static void the_finest_tolerance_is_kept(arb *a)
{
    const int32_t limit = (int32_t)(1 + arb_below(a, 16)) << (arb_below(a, 2) ? 0 : 11);
    loft_cubic c = arb_cubic(a, limit < 32768 ? limit : 32767);
    const exact e = exact_of(&c);
    const real tol = BY_NUM(2 / 65536.0L, size_of(&e) / 4194304, size_of(&e) * 0x1p-40L);
    loft_flatten f;
    loft_vec p, q = c.p[0];
    uint32_t from = 0;

    if (loft_flatten_init(&f, &c, BY_NUM(2, (loft_real)(tol * 1.0001L), (loft_real)tol)) !=
        LOFT_OK) {
        CHECK(size_of(&e) <= 0);
        return;
    }
    for (int n = 0; n < 200 && (p = q, loft_flatten_next(&f, &q)); n++) {
        check_chord(&e, point_of(p), point_of(q), ldexpl(from, -24), ldexpl(f.at, -24),
                    tol * 1.0001L);
        from = f.at;
    }
}

static void a_point_is_one_chord(arb *a)
{
    const loft_vec p = arb_vec(a, 32767);
    const loft_cubic c = {{ p, p, p, p }};
    CHECK(chords_of(&c, 8192) == 1);
}

int main(void)
{
    PROPERTY(chords_and_curve_are_within_the_tolerance_of_each_other,        150);
    PROPERTY(equal_steps_are_within_the_tolerance,                           300);
    PROPERTY(equal_steps_along_a_parabola_are_few,                            50);
    PROPERTY(never_more_chords_than_halving_gives,                           150);
    PROPERTY(never_more_chords_than_halving_gives_for_drawings,             2000);
    PROPERTY(never_more_chords_than_halving_gives_where_a_piece_halts,       600);
    PROPERTY(a_flat_parabola_takes_the_fewest_chords,                        100);
    PROPERTY(a_straight_even_line_is_one_chord,                              200);
    PROPERTY(an_inflection_between_sides_within_the_tolerance_is_one_chord,  100);
    PROPERTY(a_line_that_halts_is_one_chord,                                 300);
    PROPERTY(tolerances_that_cannot_be_kept_are_refused,                      50);
    PROPERTY(the_finest_tolerance_is_kept,                                    20);
    PROPERTY(a_point_is_one_chord,                                            50);
    return check_failures();
}

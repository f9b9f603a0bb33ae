/* tests/lib/curve/test_clip.c -- properties of lib/curve/clip.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/clip.h"
#include "support/exact.h"          /* exact_eval, CHECK_EXACT */

#define LAST (LOFT_AXES - 1)

typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_bezier b;
    loft_piece x;
} curve;

static void start(curve *c, unsigned degree)
{
    CHECK(loft_bezier_init(&c->b, c->p, degree) == LOFT_OK);
    loft_piece_start(&c->x, &c->b);
}

/* In a plane, or in all axes. */
static void arb_curve(arb *a, curve *c, unsigned degree, int32_t limit, bool flat)
{
    for (unsigned k = 0; k <= degree; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            c->p[k].axis[i] = flat && i > 0 && i < LAST ? 0 : arb_real(a, limit);
    start(c, degree);
}

static long double at(const curve *c, int i, long double t)
{
    long double w[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= c->b.degree; k++)
        w[k] = exact_of(c->p[k].axis[i]);
    return exact_eval(w, c->b.degree, t);
}

static bool has(const loft_piece *x, loft_unit t)
{
    return loft_piece_from(x) <= t && t <= loft_piece_to(x);
}

/* A place where the curves are within the gap stays, whatever is cut off. */
static void nothing_near_is_cut_off(arb *a)
{
    const int32_t limits[3] = { 3, 200, 8000 }, limit = limits[arb_below(a, 3)];
    const int32_t raws[3] = { 16, 655, 65536 };
    const loft_unit s = loft_unit_of(arb_below(a, 1025), 1024),
                    t = loft_unit_of(arb_below(a, 1025), 1024);
    const bool flat = arb_below(a, 2);
    const loft_real wide = loft_real_from_raw(raws[arb_below(a, 3)]);
    const loft_acc gap = BY_NUM(1, 4096, 1) * loft_to_acc(wide);
    curve p, q;
    bool less = true;

    arb_curve(a, &p, 1 + arb_below(a, LOFT_DEGREE_MAX), limit, flat);
    arb_curve(a, &q, 1 + arb_below(a, LOFT_DEGREE_MAX), limit, flat);
    const loft_vec from = loft_bezier_eval(&p.b, s), to = loft_bezier_eval(&q.b, t);
    const int axis = arb_below(a, 2) ? 0 : LAST;
    for (unsigned k = 0; k <= q.b.degree; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            q.p[k].axis[i] += from.axis[i] - to.axis[i] + (i == axis ? wide - wide / 8 : 0);
    start(&q, q.b.degree);
    for (int round = 0; round < 40 && less; round++) {
        CHECK(loft_piece_clip(&p.x, &q.x, gap, &less));
        CHECK(has(&p.x, s) && has(&q.x, t));
    }
    CHECK(!less);
}

/* Straight curves that cross are cut to a few gaps at once; curves do not take much longer. */
static void crossing_pieces_shrink(arb *a)
{
    const loft_acc gap = loft_to_acc(LOFT_REAL(1.0 / 256));
    const uint32_t bend = arb_below(a, 2) ? 40 : 0;
    curve p, q;
    bool less = true;
    int rounds = 0;

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const int32_t way = 200 * k - 300, off = (int32_t)arb_below(a, 2 * bend + 1);
            p.p[k].axis[i] = loft_real_from_int(i == 0 ? way : i == LAST ? off : 0);
            q.p[k].axis[i] = loft_real_from_int(i == LAST ? way : i == 0 ? off : 0);
        }
    start(&p, 3);
    start(&q, 3);
    while (loft_piece_clip(&p.x, &q.x, gap, &less) && less)
        rounds++;
    CHECK(rounds >= 1 && rounds <= (bend ? 4 : 2));
    CHECK(exact_acc(p.x.reach) <= 0.1L && exact_acc(q.x.reach) <= 0.1L);
}

/* Curves on either side of a strip that is wider than the gap. */
static void curves_apart_are_told_apart(arb *a)
{
    const loft_acc gap = loft_to_acc(LOFT_REAL(0.5));
    curve p, q;
    bool less;

    arb_curve(a, &p, 1 + arb_below(a, 5), 100, true);
    arb_curve(a, &q, 1 + arb_below(a, 5), 100, true);
    for (unsigned k = 0; k <= p.b.degree; k++)
        p.p[k].axis[0] = loft_real_abs(p.p[k].axis[0]) + loft_real_from_int(1);
    for (unsigned k = 0; k <= q.b.degree; k++)
        q.p[k].axis[0] = -loft_real_abs(q.p[k].axis[0]);
    start(&p, p.b.degree);
    start(&q, q.b.degree);
    CHECK(loft_piece_boxes_apart(&p.x, &q.x, gap) && loft_piece_hulls_apart(&p.x, &q.x, gap));
    for (less = true; less && loft_piece_clip(&p.x, &q.x, gap, &less);)
        CHECK(!less || loft_piece_hulls_apart(&p.x, &q.x, gap));
}

/* The control points of a piece are those of its polynomial. */
static void a_piece_is_a_part_of_the_curve(arb *a)
{
    const uint32_t from = arb_below(a, LOFT_PIECE_WHOLE),
                   to = from + 1 + arb_below(a, LOFT_PIECE_WHOLE - from);
    curve c;

    arb_curve(a, &c, 1 + arb_below(a, LOFT_DEGREE_MAX), 1000, false);
    loft_piece_cut(&c.x, from, to);
    loft_piece_aim(&c.x);
    const unsigned n = c.b.degree;
    const long double slack = BY_NUM(0x1p-28L, 0x1p-38L, 0x1p-38L);
    long double length = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc low, high;
        CHECK_EXACT(exact_acc(c.x.p[i][0]), at(&c, i, exact_unit(loft_piece_from(&c.x))), slack);
        CHECK_EXACT(exact_acc(c.x.p[i][n]), at(&c, i, exact_unit(loft_piece_to(&c.x))), slack);
        loft_piece_range(&c.x, i, &low, &high);
        CHECK(low <= c.x.p[i][0] && high >= c.x.p[i][n] && exact_acc(high - low) >= 0);
        length += powl(exact_acc(c.x.p[i][n] - c.x.p[i][0]), 2);
    }
    CHECK_EXACT(exact_acc(c.x.chord.length), sqrtl(length), sqrtl(length) * 0x1p-27L + slack);
    CHECK_EXACT(exact_unit(loft_piece_at(&c.x, LOFT_UNIT(0.25))),
                (from + (to - from) * 0.25L) / LOFT_PIECE_WHOLE, 0x1.1p-25L);
}

int main(void)
{
    if (LOFT_AXES < 2)
        return check_failures();
    PROPERTY(nothing_near_is_cut_off,       20000);
    PROPERTY(crossing_pieces_shrink,         2000);
    PROPERTY(curves_apart_are_told_apart,    5000);
    PROPERTY(a_piece_is_a_part_of_the_curve, 5000);
    return check_failures();
}

/* tests/lib/curve/test_crossings.c -- properties of lib/curve/crossings.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/crossings.h"
#include "curve/intersect.h"
#include "support/exact.h"          /* exact_eval; CHECK, PROPERTY */

#define MOST (LOFT_DEGREE_MAX + 1)

#if LOFT_AXES > 1

typedef struct {
    loft_vec p[MOST];
    loft_bezier b;
} curve;

static void set(curve *c, unsigned n, const int32_t xy[][2])
{
    for (unsigned k = 0; k <= n; k++) {
        c->p[k] = (loft_vec) { { 0 } };
        c->p[k].axis[0] = loft_real_from_raw(xy[k][0]);
        c->p[k].axis[1] = loft_real_from_raw(xy[k][1]);
    }
    CHECK(loft_bezier_init(&c->b, c->p, n) == LOFT_OK);
}

static void arb_curve(arb *a, curve *c, unsigned n, unsigned bits)
{
    int32_t xy[MOST][2];

    for (unsigned k = 0; k <= n; k++)
        for (int axis = 0; axis < 2; axis++)
            xy[k][axis] = (int32_t)arb_below(a, (uint32_t)1 << bits) - ((int32_t)1 << (bits - 1));
    set(c, n, (const int32_t (*)[2])xy);
}

static long double at(const curve *c, int axis, loft_unit t)
{
    long double x[MOST];

    for (unsigned k = 0; k <= c->b.degree; k++)
        x[k] = exact_of(c->p[k].axis[axis]);
    return exact_eval(x, c->b.degree, exact_unit(t));
}

static long double gap_of(const curve *a, const curve *b, const loft_meeting *m)
{
    return hypotl(at(a, 0, m->s) - at(b, 0, m->t), at(a, 1, m->s) - at(b, 1, m->t));
}

static unsigned meet(const curve *a, const curve *b, loft_meeting m[])
{
    unsigned count;
    CHECK(loft_bezier_crossings(&a->b, &b->b, m, &count) == LOFT_OK);
    return count;
}

/* Points are equal up to the rounding of parameters, the other order gives the same, and each lies
 * in a stretch of the search within a tolerance. */
static void meetings_are_places_of_both_curves(arb *a)
{
    curve p, q;
    loft_meeting m[LOFT_MEETINGS_MAX], back[LOFT_MEETINGS_MAX];
    loft_crossing c[32];
    size_t stretches = 0;

    arb_curve(a, &p, 1 + arb_below(a, 4), 21);
    arb_curve(a, &q, 1 + arb_below(a, 4), 21);
    const unsigned count = meet(&p, &q, m), again = meet(&q, &p, back);
    CHECK(count == again);
    const enum loft_status status = loft_bezier_intersect(&p.b, &q.b, LOFT_REAL(0.001), c, 32,
                                                          &stretches);
    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    for (unsigned k = 0; k < count; k++) {
        CHECK(gap_of(&p, &q, &m[k]) < 32 * 8 * 0x1p-24L + 32 * 0x1p-40L);
        CHECK(m[k].multiplicity == 1);
        bool same = false, near = false;
        for (unsigned j = 0; j < again; j++)
            same = same || (!(m[k].s < back[j].t) && !(m[k].s > back[j].t) &&
                            !(m[k].t < back[j].s) && !(m[k].t > back[j].s));
        for (size_t j = 0; j < stretches; j++)
            near = near || (c[j].s_from <= m[k].s + LOFT_UNIT(0x1p-20) &&
                            m[k].s <= c[j].s_to + LOFT_UNIT(0x1p-20));
        CHECK(same && near);
    }
}

/* A parabola that a line touches at 1/2; one LSB beside it there are two meetings or none. */
static void the_last_bit_decides_whether_they_touch(arb *a)
{
    loft_meeting m[LOFT_MEETINGS_MAX];
    curve p, q;
    const int32_t x = (int32_t)arb_below(a, 200000), y = (int32_t)arb_below(a, 200000) * 2;
    const int32_t parabola[3][2] = { { x, y }, { x + 65536, y + 131072 }, { x + 131072, y } };

    set(&p, 2, parabola);
    for (int32_t off = -1; off <= 1; off++) {
        const int32_t line[2][2] = { { x - 65536, y + 65536 + off },
                                     { x + 196608, y + 65536 + off } };
        set(&q, 1, line);
        const unsigned count = meet(&p, &q, m);
        CHECK(count == (off < 0 ? 2u : off == 0 ? 1u : 0u));
        for (unsigned k = 0; k < count; k++)
            CHECK(m[k].multiplicity == (off == 0 ? 2 : 1));
    }
}

static void ends_in_common_are_exact(arb *a)
{
    loft_meeting m[LOFT_MEETINGS_MAX];
    curve p, q;
    bool found = false;

    arb_curve(a, &p, 1 + arb_below(a, 4), 24);
    arb_curve(a, &q, 1 + arb_below(a, 4), 24);
    const bool last_p = arb_below(a, 2), last_q = arb_below(a, 2);
    const loft_unit s = last_p ? LOFT_UNIT(1) : 0, t = last_q ? LOFT_UNIT(1) : 0;
    q.p[last_q ? q.b.degree : 0] = p.p[last_p ? p.b.degree : 0];
    const unsigned count = meet(&p, &q, m);
    for (unsigned k = 0; k < count; k++)
        found = found || (!(m[k].s < s) && !(m[k].s > s) && !(m[k].t < t) && !(m[k].t > t));
    CHECK(found);
}

/* y = x^3 and y = 0; the cusp of (t^2, t^3) and lines through it; a loop and a line through its
 * node. */
static void multiplicities_are_those_of_the_place(arb *a)
{
    static const int32_t cubic[4][2] = { { -3, -27 }, { -1, 27 }, { 1, -27 }, { 3, 27 } };
    static const int32_t cusp[4][2] = { { 9, -27 }, { -3, 27 }, { -3, -27 }, { 9, 27 } };
    static const int32_t loop[4][2] = { { -2, 0 }, { 4, 6 }, { -4, 6 }, { 2, 0 } };
    static const int32_t flat[2][2] = { { -5, 0 }, { 3, 0 } },
                         tilted[2][2] = { { -1, -8 }, { 1, 8 } };
    loft_meeting m[LOFT_MEETINGS_MAX];
    curve p, q;

    (void)a;
    set(&p, 3, cubic);
    set(&q, 1, flat);
    CHECK(meet(&p, &q, m) == 1 && m[0].multiplicity == 3);
    set(&p, 3, cusp);
    CHECK(meet(&p, &q, m) == 1 && m[0].multiplicity == 3);      /* the tangent of the cusp */
    set(&q, 1, tilted);
    CHECK(meet(&p, &q, m) == 1 && m[0].multiplicity == 2);
    set(&p, 3, loop);
    const int32_t upright[2][2] = { { 0, -40 }, { 0, 50 } };
    set(&q, 1, upright);
    const unsigned count = meet(&p, &q, m);
    CHECK(count == 3);                          /* twice the node, once the top of the loop */
    for (unsigned k = 0; k < count; k++)
        CHECK(m[k].multiplicity == 1);
}

static void pieces_of_one_curve_are_told(arb *a)
{
    loft_meeting m[LOFT_MEETINGS_MAX];
    unsigned count;
    curve p, q;
    const int32_t x = (int32_t)arb_below(a, 100000) * 4, y = (int32_t)arb_below(a, 100000) * 4;
    const int32_t whole[3][2] = { { x, y }, { x + 80000, y + 160000 }, { x + 240000, y } };
    const int32_t left[3][2] = { { x, y }, { x + 40000, y + 80000 }, { x + 100000, y + 80000 } };
    const int32_t right[3][2] = { { x + 100000, y + 80000 },
                                  { x + 160000, y + 80000 },
                                  { x + 240000, y } };

    set(&p, 2, whole);
    set(&q, 2, left);
    CHECK(loft_bezier_crossings(&p.b, &q.b, m, &count) == LOFT_SINGULAR && count == 0);
    set(&p, 2, right);
    CHECK(loft_bezier_crossings(&p.b, &q.b, m, &count) == LOFT_OK && count == 1);
    CHECK(!(m[0].s > 0) && !(m[0].t < LOFT_UNIT(1)) && m[0].multiplicity == 0);
}

static void a_point_lies_on_a_curve_or_not(arb *a)
{
    loft_meeting m[LOFT_MEETINGS_MAX];
    unsigned count;
    curve p, q;

    arb_curve(a, &p, 2, 20);
    p.p[0] = p.p[1] = p.p[2];
    arb_curve(a, &q, 3, 20);
    CHECK(loft_bezier_crossings(&p.b, &q.b, m, &count) == LOFT_OK && count == 0);
    q.p[arb_below(a, 2) ? 0 : 3] = p.p[0];
    CHECK(loft_bezier_crossings(&p.b, &q.b, m, &count) == LOFT_SINGULAR && count == 0);
    CHECK(loft_bezier_crossings(&q.b, &p.b, m, &count) == LOFT_SINGULAR && count == 0);
    CHECK(loft_bezier_crossings(&p.b, &p.b, m, &count) == LOFT_SINGULAR);
}

/* A raised curve has the same meetings. */
static void the_degree_is_the_exact_one(arb *a)
{
    loft_meeting m[LOFT_MEETINGS_MAX], n[LOFT_MEETINGS_MAX];
    curve p, q, high;

    arb_curve(a, &p, 2, 16);
    arb_curve(a, &q, 1 + arb_below(a, 3), 20);
    for (unsigned k = 0; k < 3; k++)
        for (int axis = 0; axis < 2; axis++)
            p.p[k].axis[axis] *= 3;
    const loft_vec raised[4] = { p.p[0], p.p[0], p.p[2], p.p[2] };
    for (unsigned k = 0; k < 4; k++)
        high.p[k] = raised[k];
    for (int axis = 0; axis < 2; axis++) {
        high.p[1].axis[axis] += (p.p[1].axis[axis] - p.p[0].axis[axis]) / 3 * 2;
        high.p[2].axis[axis] += (p.p[1].axis[axis] - p.p[2].axis[axis]) / 3 * 2;
    }
    CHECK(loft_bezier_init(&high.b, high.p, 3) == LOFT_OK);
    const unsigned one = meet(&p, &q, m), two = meet(&high, &q, n);
    CHECK(one == two);
    for (unsigned k = 0; k < one; k++)
        CHECK(fabsl(exact_unit(m[k].s) - exact_unit(n[k].s)) < 0x1p-23L &&
              m[k].multiplicity == n[k].multiplicity);
}

#endif

static void what_is_not_taken_is_refused(arb *a)
{
    const loft_vec p[7] = { { { 0 } } };
    loft_meeting m[LOFT_MEETINGS_MAX];
    loft_bezier b, c;
    unsigned count = 5;

    (void)a;
    CHECK(loft_bezier_init(&b, p, 5) == LOFT_OK && loft_bezier_init(&c, p, 0) == LOFT_OK);
    CHECK(loft_bezier_crossings(&b, &b, m, &count) == LOFT_ERR_ARG && count == 0);
    CHECK(loft_bezier_crossings(&c, &c, m, &count) == LOFT_ERR_ARG);
}

int main(void)
{
#if LOFT_AXES > 1
    PROPERTY(meetings_are_places_of_both_curves, 200);
    PROPERTY(the_last_bit_decides_whether_they_touch, 20);
    PROPERTY(ends_in_common_are_exact, 50);
    PROPERTY(multiplicities_are_those_of_the_place, 1);
    PROPERTY(pieces_of_one_curve_are_told, 20);
    PROPERTY(a_point_lies_on_a_curve_or_not, 20);
    PROPERTY(the_degree_is_the_exact_one, 50);
#endif
    PROPERTY(what_is_not_taken_is_refused, 1);
    return check_failures();
}

/* tests/lib/path/test_arc.c -- properties of lib/path/arc.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>           /* sqrt, fmax: the reference */

#include "path/arc.h"             /* loft_arc_next, loft_arc_eval */
#include "support/motion_oracle.h"  /* cubic_at, distance; CHECK, PROPERTY, arb */

static double wide_value(loft_acc x)
{
    return BY_NUM((double)x / 4294967296.0, (double)x, (double)x);
}

static void point_at(const loft_arc *arc, loft_acc s, double out[LOFT_AXES])
{
    loft_acc x[LOFT_AXES];
    loft_arc_eval(arc, s, x);
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = wide_value(x[i]);
}

/* Sizes from 2^-10 mm to the reach of a plan, with coinciding points. */
static loft_cubic arb_curve(arb *a)
{
    const int down = (int)arb_below(a, 24);
    loft_cubic c = arb_cubic(a, 8190);

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            c.p[k].axis[i] = BY_NUM(c.p[k].axis[i] / (1 << down),
                                    c.p[k].axis[i] / (loft_real)(1 << down),
                                    c.p[k].axis[i] / (loft_real)(1 << down));
    if (arb_below(a, 4) == 0)
        c.p[1 + arb_below(a, 3)] = c.p[arb_below(a, 4)];
    return c;
}

/* The length of the curve between two parameters, as 1024 chords. */
static double length_of(const loft_cubic *c, double from, double to)
{
    double sum = 0, p[LOFT_AXES], q[LOFT_AXES];

    cubic_at(c->p, from, p);
    for (int n = 1; n <= 1024; n++) {
        cubic_at(c->p, from + (to - from) * n / 1024, q);
        sum += distance(p, q);
        for (int i = 0; i < LOFT_AXES; i++)
            p[i] = q[i];
    }
    return sum;
}

/* They follow each other without a gap from the first control point to the last, and each begins
 * and ends on the curve at its parameters (a straight curve is walked evenly, so there only the
 * ends are compared). */
static void arcs_make_up_the_curve(arb *a)
{
    const loft_cubic c = arb_curve(a);
    double at[LOFT_AXES], p[LOFT_AXES];
    loft_arc arc;
    unsigned n = 0;

    cubic_at(c.p, 0, at);
    for (uint32_t from = 0, to; from < LOFT_ARC_WHOLE; from = to, n++) {
        to = loft_arc_next(&arc, &c, from);
        CHECK(to > from && to <= LOFT_ARC_WHOLE);
        if (!(arc.length > 0))
            continue;
        point_at(&arc, 0, p);
        CHECK_NEAR(distance(p, at), 0, BY_NUM(0x1p-29, 1e-9, 1e-9));
        point_at(&arc, arc.length, p);
        for (int i = 0; i < LOFT_AXES; i++)
            at[i] = p[i];
    }
    cubic_at(c.p, 1, p);
    CHECK_NEAR(distance(p, at), 0, BY_NUM(0x1p-29, 1e-9, 1e-9));
    CHECK(n <= 8 * 32 + polygon_length(&c) / 32);     /* an arc has at most 64 mm */
}

/* Lengths add up, and equal lengths are equal distances: the speed along the path is what the plan
 * says. */
static void arcs_are_walked_by_their_length(arb *a)
{
    const loft_cubic c = arb_curve(a);
    loft_arc arc;
    double p[LOFT_AXES], q[LOFT_AXES];

    for (uint32_t from = 0, to; from < LOFT_ARC_WHOLE; from = to) {
        to = loft_arc_next(&arc, &c, from);
        if (wide_value(arc.length) < 0.001)
            continue;
        const double length = wide_value(arc.length),
                     want = length_of(&c, (double)from / LOFT_ARC_WHOLE,
                                      (double)to / LOFT_ARC_WHOLE);
        if (from > 0 || to < LOFT_ARC_WHOLE)
            CHECK_NEAR(length / want, 1, 0x1p-16 + 1e-9 / length);
        for (int n = 0; n < 8; n++) {
            loft_acc s0 = arc.length / 8 * n, s1 = arc.length / 8 * (n + 1);
            point_at(&arc, s0, p);
            point_at(&arc, s1, q);
            CHECK_NEAR(distance(p, q) / wide_value(s1 - s0), 1,
                       0.0004 + 8 * BY_NUM(0x1p-24, 0x1p-23, 0));
        }
    }
}

/* The heading anywhere is the direction in which the next place lies. */
static void headings_lead_along_the_arc(arb *a)
{
    const loft_cubic c = arb_curve(a);
    loft_arc arc;
    double p[LOFT_AXES], q[LOFT_AXES];

    for (uint32_t from = 0, to; from < LOFT_ARC_WHOLE; from = to) {
        to = loft_arc_next(&arc, &c, from);
        if (wide_value(arc.length) < 0.5)
            continue;
        for (int n = 1; n < 8; n++) {
            loft_vec u;
            point_at(&arc, arc.length / 8 * n - arc.length / 64, p);
            point_at(&arc, arc.length / 8 * n + arc.length / 64, q);
            loft_arc_heading(&arc, arc.length / 8 * n, &u);
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_NEAR(arb_value(u.axis[i]), (q[i] - p[i]) / distance(p, q), 0.001);
        }
    }
}

/* Straight says what the arc leaves its chord by, walked evenly; folded it is its chord, less what
 * is left out, and begins where it did. */
static void a_folded_arc_is_a_part_of_its_chord(arb *a)
{
    const loft_cubic c = arb_curve(a);
    const double part = 0.1 + 0.8 * arb_below(a, 1000) / 1000.0;
    double from[LOFT_AXES], to[LOFT_AXES], p[LOFT_AXES], most = 0;
    loft_acc by[LOFT_AXES];
    loft_arc arc;
    uint32_t at = arb_below(a, 2) ? arb_below(a, LOFT_ARC_WHOLE) : 0;

    at &= ~(uint32_t)0 << arb_below(a, 20);
    (void)loft_arc_next(&arc, &c, at);
    if (wide_value(arc.length) < 0.01)
        return;
    point_at(&arc, 0, from);
    point_at(&arc, arc.length, to);
    for (int n = 1; n < 16; n++) {
        point_at(&arc, arc.length / 16 * n, p);
        for (int i = 0; i < LOFT_AXES; i++)
            most = fmax(most, fabs(p[i] - from[i] - (to[i] - from[i]) * n / 16));
    }
    CHECK(!loft_arc_is_straight(&arc, loft_to_acc(LOFT_REAL(0.03125))) || most < 0.02);
    CHECK(loft_arc_is_straight(&arc, loft_to_acc(LOFT_REAL(32))));
    for (int i = 0; i < LOFT_AXES; i++)
        by[i] = BY_NUM((loft_acc)floor((to[i] - from[i]) * part * 0x1p32),
                       (loft_acc)((to[i] - from[i]) * part), (loft_acc)((to[i] - from[i]) * part));
    loft_arc_fold(&arc, by);
    CHECK_NEAR(wide_value(arc.length), distance(from, to) * (1 - part), 1e-6);
    for (int n = 0; n <= 16; n++) {
        point_at(&arc, arc.length / 16 * n, p);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_NEAR(p[i], from[i] + (to[i] - from[i]) * (1 - part) * n / 16, 1e-5);
    }
}

/* Along an arc the direction changes by little, and so does the length of a parameter. */
static void an_arc_is_nearly_straight(arb *a)
{
    const loft_cubic c = arb_curve(a);
    loft_arc arc;

    for (uint32_t from = 0, to; from < LOFT_ARC_WHOLE; from = to) {
        loft_vec u[3];
        double turn = 0;
        to = loft_arc_next(&arc, &c, from);
        if (wide_value(arc.length) < 0.01)
            continue;
        for (unsigned n = 0; n < 3; n++)
            loft_arc_direction(&arc, n, &u[n]);
        for (int i = 0; i < LOFT_AXES; i++)
            turn = fmax(turn, fmax(fabs(arb_value(u[2].axis[i]) - arb_value(u[0].axis[i])),
                                   2 * fabs(arb_value(u[1].axis[i]) - arb_value(u[0].axis[i]))));
        CHECK(turn <= 0.36);
    }
}

int main(void)
{
    PROPERTY(arcs_make_up_the_curve,          2000);
    PROPERTY(arcs_are_walked_by_their_length,  100);
    PROPERTY(headings_lead_along_the_arc,      100);
    PROPERTY(a_folded_arc_is_a_part_of_its_chord, 1000);
    PROPERTY(an_arc_is_nearly_straight, 400);
    return check_failures();
}

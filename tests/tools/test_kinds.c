/* tests/tools/test_kinds.c -- every kind of curve: the library against its definition, pieces,
 * cubics, curvature
 * SPDX-License-Identifier: MIT
 */
#include "tools/drawn.h"
#include "engine/curve.h"
#include "engine/engine.h"
#include "engine/piece.h"
#include "geometry/reference.h"

static double random_to(arb *a, double most)
{
    return most * ((double)arb_below(a, 2000001) / 1000000 - 1);
}

static double random_weight(arb *a) { return exp2((double)arb_below(a, 8001) / 1000 - 4); }

/* Points at least 1 apart from the one before. */
static curve_point random_point(arb *a, const curve *c, double ascending)
{
    curve_point p = { .w = c->kind == CURVE_PARABOLA ? ascending
                           : curve_is_rational(c)    ? random_weight(a)
                                                     : 1 };

    for (int i = 0; i < CURVE_AXES; i++) {
        p.p[i] = random_to(a, 100) + (c->count % 2 ? 202 : 0);
        p.d[0][i] = random_to(a, c->kind == CURVE_TCB ? 2 : 100);
        p.d[1][i] = random_to(a, 100);
    }
    return p;
}

/* No knot more than `degree` times: the curve does not jump. */
static void random_knots(arb *a, curve *c)
{
    double knot = random_to(a, 3);

    for (unsigned i = 0; i < c->count + c->degree + 1; i++) {
        curve_add_knot(c, knot);
        const bool full = i + 1 >= c->degree && c->knot[i] <= c->knot[i + 1 - c->degree];
        knot += full || i == c->degree || arb_below(a, 3) > 0
                    ? 0.25 + (double)arb_below(a, 1000) / 500
                    : 0;
    }
}

/* An arc in space, of up to three turns. */
static void random_arc(arb *a, curve *c)
{
    const double r = 1 + (double)arb_below(a, 100), from = random_to(a, 3), to = random_to(a, 3);
    curve_point p[3] = { { .w = 1 }, { .w = 1 }, { .w = 1 } };

    c->turns = (arb_below(a, 2) ? 1 : -1) * (1 + (int)arb_below(a, 3));
    p[1].p[0] = random_to(a, 100);
    p[1].p[1] = random_to(a, 100);
    for (int k = 0; k < 3; k += 2) {
        p[k].p[0] = p[1].p[0] + r * cos(k ? to : from);
        p[k].p[1] = p[1].p[1] + r * sin(k ? to : from);
        p[k].p[2] = random_to(a, 1);
    }
    for (int k = 0; k < 3; k++)
        curve_add_point(c, &p[k]);
}

static curve *random_curve(arb *a, curves *all)
{
    curve *c = curves_add(all, (enum curve_kind)arb_below(a, CURVE_KINDS), 1);
    const bool knots = curve_has_knots(c);
    unsigned count   = 4 + arb_below(a, 8);

    c->degree  = curve_kinds[c->kind].degree;
    c->tension = c->kind == CURVE_CATMULL ? (double)arb_below(a, 5) / 4 : random_to(a, 2);
    c->ends    = (enum curve_ends)arb_below(a, CURVE_ENDS);
    c->chord   = !curve_hides_ends(c) && arb_below(a, 2);
    if (c->kind == CURVE_ARC) {
        random_arc(a, c);
        return c;
    }
    if (knots)
        c->degree = 1 + arb_below(a, 9), count += c->degree - 3 < 9 ? c->degree - 3 : 0;
    if (curve_kinds[c->kind].bezier)
        c->degree = 1 + arb_below(a, 9), count = c->degree + 1;
    if (c->kind == CURVE_PARABOLA)
        count = 3;
    double ascending = random_to(a, 5);
    for (unsigned k = 0; k < count; k++) {
        const curve_point p = random_point(a, c, ascending);
        curve_add_point(c, &p);
        ascending += 0.5 + (double)arb_below(a, 100) / 50;
    }
    if (knots)
        random_knots(a, c);
    return c;
}

static double distance(const double a[CURVE_AXES], const double b[CURVE_AXES])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static void reference_at(const reference *r, double t, double out[CURVE_AXES])
{
    long double p[CURVE_AXES];

    reference_eval(r, (long double)t, p);
    for (int i = 0; i < CURVE_AXES; i++)
        out[i] = (double)p[i];
}

/* In double: points equal the definition, and the Bezier pieces pass the same points at the same
 * parameters. */
static void every_kind_is_what_its_definition_says(arb *a)
{
    const engine_curves *make = engine_f64.curve;
    curves all = { 0 };
    const curve *c = random_curve(a, &all);
    engine_curve *held = NULL;
    reference exact;

    CHECK(reference_init(&exact, c));
    const int status = make->open(c, &held);
    CHECK(status == 0);
    for (unsigned i = 0; status == 0 && c->kind != CURVE_ARC && i < curve_pieces(c); i++) {
        const double from = curve_break(c, i), to = curve_break(c, i + 1);
        piece p;
        CHECK(make->piece(held, i, &p) == 0);
        for (int j = 0; j <= 8; j++) {
            double want[CURVE_AXES], got[CURVE_AXES], at[3][CURVE_AXES];
            const double t = from + (to - from) * j / 8;
            reference_at(&exact, t, want);
            CHECK(make->eval(held, t, got) == 0);
            CHECK_NEAR(distance(got, want), 0, 1e-10);
            piece_eval(&p, j / 8.0, at);
            CHECK_NEAR(distance(at[0], want), 0, 1e-9);
        }
    }
    if (held != NULL)
        make->close(held);
    reference_free(&exact);
    curves_free(&all);
}

/* The smallest distance of p from the curve within `around` of t, where it has one minimum. */
static double nearest_distance(const reference *r, const double p[CURVE_AXES], double t,
                               double around)
{
    double low = t - around, high = t + around, at[CURVE_AXES];

    for (int k = 0; k < 100; k++) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        reference_at(r, a, at);
        const double far = distance(p, at);
        reference_at(r, b, at);
        if (far < distance(p, at))
            high = b;
        else
            low = a;
    }
    reference_at(r, low, at);
    return distance(p, at);
}

/* An arc's own points are exact; its cubics are within 0.0001 mm of some of them. */
static void arcs_are_within_their_tolerance(arb *a)
{
    const engine_curves *make = engine_f64.curve;
    curves all = { 0 };
    curve *c = curves_add(&all, CURVE_ARC, 1);
    engine_curve *held;
    reference exact;

    c->degree = 3;
    random_arc(a, c);
    CHECK(reference_init(&exact, c));
    CHECK(make->open(c, &held) == 0);
    for (unsigned i = 0; i < make->pieces(held); i++) {
        piece p;
        CHECK(make->piece(held, i, &p) == 0);
        for (int j = 0; j <= 16; j++) {
            const double t = ((double)i + j / 16.0) / make->pieces(held);
            double want[CURVE_AXES], got[CURVE_AXES], at[3][CURVE_AXES];
            reference_at(&exact, t, want);
            CHECK(make->eval(held, t, got) == 0);
            CHECK_NEAR(distance(got, want), 0, 1e-11);
            piece_eval(&p, j / 16.0, at);
            CHECK(nearest_distance(&exact, at[0], t, 0.1 / make->pieces(held)) <= 1e-4);
        }
    }
    make->close(held);
    reference_free(&exact);
    curves_free(&all);
}

static piece random_piece(arb *a)
{
    piece p = { .degree = 1 + arb_below(a, 9) };
    const bool rational = arb_below(a, 2);

    for (unsigned k = 0; k <= p.degree; k++) {
        for (int i = 0; i < CURVE_AXES; i++)
            p.p[k][i] = random_to(a, 10);
        p.w[k] = rational ? random_weight(a) : 1;
    }
    return p;
}

static void derivatives_are_those_of_the_points(arb *a)
{
    const piece p  = random_piece(a);
    const double h = 1e-4, t = 0.01 + 0.98 * (double)arb_below(a, 1001) / 1000;
    double before[3][CURVE_AXES], at[3][CURVE_AXES], after[3][CURVE_AXES];

    piece_eval(&p, t - h, before);
    piece_eval(&p, t, at);
    piece_eval(&p, t + h, after);
    for (int i = 0; i < CURVE_AXES; i++)
        for (int k = 0; k < 2; k++) {
            const double slope = (after[k][i] - before[k][i]) / (2 * h);
            const double size  = fabs(at[k + 1][i]) + distance(before[k + 1], after[k + 1]) + 1e3;
            CHECK_NEAR(at[k + 1][i], slope, 1e-2 * size);
        }
}

/* 1 / radius, for left and right turns. */
static void the_curvature_of_a_circle_is_constant(arb *a)
{
    const double r = exp2(random_to(a, 8)), t = (double)arb_below(a, 1001) / 1000;
    piece left  = { { { r, 0 }, { r, r }, { 0, r } }, { 1, sqrt(0.5), 1 }, 2 };
    piece right = { { { 0, r }, { r, r }, { r, 0 } }, { 1, sqrt(0.5), 1 }, 2 };
    piece halt  = { { { r, 0 }, { r, 0 }, { r, 0 } }, { 1, 1, 1 }, 2 };
    double bend;

    CHECK(piece_bend(&left, t, &bend));
    CHECK_NEAR(bend * r, 1, 1e-12);
    CHECK(piece_bend(&right, t, &bend));
    CHECK_NEAR(bend * r, -1, 1e-12);
    CHECK(!piece_bend(&halt, t, &bend));
}

typedef struct {
    const piece *p;
    double tol, end[CURVE_AXES], far;
    unsigned count;
} covering;

/* Each point of the cubic has a point of the curve within tol. The curve is sampled densely, and
 * its length between two samples is added. */
static void check_cover(void *context, double p[4][CURVE_AXES])
{
    covering *c = context;

    if (c->count++ > 0)
        c->far = fmax(c->far, distance(c->end, p[0]));
    memcpy(c->end, p[3], sizeof c->end);
    for (int j = 0; j <= 4 && c->count <= 40; j++) {
        const double t = j / 4.0, s = 1 - t;
        double at[CURVE_AXES], best = HUGE_VAL;
        for (int i = 0; i < CURVE_AXES; i++)
            at[i] = s * s * s * p[0][i] + 3 * s * s * t * p[1][i] + 3 * s * t * t * p[2][i] +
                    t * t * t * p[3][i];
        for (int k = 0; k <= 1000; k++) {
            double d[3][CURVE_AXES];
            piece_eval(c->p, k / 1000.0, d);
            best = fmin(best, fmax(0, distance(at, d[0]) -
                                          distance(d[1], (double[CURVE_AXES]){ 0 }) / 1000));
        }
        CHECK(best <= c->tol);
    }
}

static void cubics_stay_within_their_tolerance(arb *a)
{
    const piece p = random_piece(a);
    covering c = { .p = &p, .tol = 0.5 * exp2(-(double)arb_below(a, 10)) };
    double from[3][CURVE_AXES];

    piece_eval(&p, 0, from);
    CHECK(engine_f64.piece->cubics(&p, c.tol, check_cover, &c) == 0 && c.count > 0 &&
          (piece_is_rational(&p) || p.degree > 3 || c.count == 1));
    CHECK_NEAR(c.far, 0, 1e-9);
    CHECK_NEAR(distance(c.end, p.p[p.degree]), 0, 1e-9);
}

int main(void)
{
    PROPERTY(every_kind_is_what_its_definition_says, 600);
    PROPERTY(arcs_are_within_their_tolerance, 20);
    PROPERTY(derivatives_are_those_of_the_points, 500);
    PROPERTY(the_curvature_of_a_circle_is_constant, 200);
    PROPERTY(cubics_stay_within_their_tolerance, 20);
    return check_failures();
}

/* tests/lib/polygon/test_harmonic.c -- properties of lib/polygon/harmonic.h and of the host's
 * solver
 * SPDX-License-Identifier: MIT
 */
#include "support/arb_polygon.h"            /* exact_sci, spot_raw */
#include "support/solved.h"

#define SHAPES        25
#define NARROW_TARGET ((harmonic_target){ 5e-7L, 4e-7L, 0, 3e-13L })

/* Polygons that ask for everything: corners of all kinds, straight and nearly so, a vertex that is
 * not seen from most of the inside. */
static const struct {
    const char *name;
    unsigned n;
    double v[LOFT_SIDES_MAX][2];
} shapes[SHAPES] = {
    { "triangle",   3, { { 0, 0 }, { 3, 1 }, { 1, 2 } } },
    { "square",     4, { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } },
    { "kite",       4, { { -1, -1 }, { 1.5, -0.5 }, { 1, 1.25 }, { -0.5, 0.75 } } },
    { "pentagon",
      5,
      { { 0, 1 },
        { -0.951171875, 0.30908203125 },
        { -0.587890625, -0.80908203125 },
        { 0.587890625, -0.80908203125 },
        { 0.951171875, 0.30908203125 } } },
    { "long",
      5,
      { { -1.25, -0.25 }, { 0.25, -0.75 }, { 1.5, -0.125 }, { 0.5, 0.625 }, { -0.75, 0.75 } } },
    { "hexagon",
      6,
      { { 0, 1 },
        { -0.865966796875, 0.5 },
        { -0.865966796875, -0.5 },
        { 0, -1 },
        { 0.865966796875, -0.5 },
        { 0.865966796875, 0.5 } } },
    { "straight",   5, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1.5 } } },
    { "almost",     5, { { 0, 0 }, { 1, 0 }, { 2, 0.0009765625 }, { 2, 1 }, { 0, 1.5 } } },
    { "notch",      5, { { 0, 0 }, { 4, 0 }, { 4, 3 }, { 2, 1 }, { 0, 3 } } },
    { "angle",      6, { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } } },
    { "star",
      8,
      { { 2, 0 },
        { 0.5, 0.5 },
        { 0, 2 },
        { -0.5, 0.5 },
        { -2, 0 },
        { -0.5, -0.5 },
        { 0, -2 },
        { 0.5, -0.5 } } },
    { "spiral",
      8,
      { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 1, 4 }, { 1, 2 }, { 3, 3 }, { 3, 1 }, { 0, 1 } } },
    { "strip", 4, { { 0, 0 }, { 100, 0.2 }, { 98, 1 }, { 1, 2 } } },
    { "spike", 5, { { 0, 0 }, { 4, 0 }, { 4, 3 }, { 2.02, 3 }, { 2, 0.5 } } },
    { "dart", 4, { { 0, 0 }, { 10, -0.3 }, { 2, 0 }, { 10, 1 } } },
    { "sliver", 3, { { 0, 0 }, { 57.25, 0 }, { 57.25, 1 } } },
    { "blade", 4, { { 0, 0 }, { 57.25, -0.5 }, { 60, 0 }, { 57.25, 0.5 } } },
    { "pocket",
      5,
      { { -10.654, -0.045 },
        { 0.103, -0.185 },
        { 0.047, -1.648 },
        { 848.02, 5.904 },
        { -0.371, 125.38 } } },
    { "zigzag",
      8,
      { { 0, -0.5 },
        { 100.5, -0.5 },
        { 100.5, 99.5 },
        { 200, 99.5 },
        { 200, 100.5 },
        { 99.5, 100.5 },
        { 99.5, 0.5 },
        { 0, 0.5 } } },
    { "kinks",
      8,
      { { 0, -0.5 },
        { 103.73, -0.5 },
        { 17.13, 49.5 },
        { 113.4, 49.5 },
        { 113.4, 50.5 },
        { 13.4, 50.5 },
        { 100, 0.5 },
        { 0, 0.5 } } },
    { "slit",
      8,
      { { 0, 0 },
        { 100, 0 },
        { 100, 50 },
        { 50.01, 50 },
        { 50.01, 25 },
        { 50, 25 },
        { 50, 50 },
        { 0, 50 } } },
    { "fork",
      6,
      { { 26.1, -0.468 },
        { 27.149, 0.755 },
        { 2.026, -0.682 },
        { 23.439, -0.811 },
        { 29.516, -0.844 },
        { 15.011, -0.323 } } },
    { "wedge",
      6,
      { { -34.0293, -19.4824 },
        { -12.1838, -27.7873 },
        { -17.1365, -25.601 },
        { 23.071, -43.3373 },
        { 5.2621, 22.431 },
        { -15.5829, -21.6387 } } },
    { "bent slit",
      8,
      { { 0, 0 },
        { -183.671875, 24.5 },
        { -208.15625, -159.1875 },
        { -117.265625, -171.296875 },
        { -102.96875, -69.890625 },
        { -92.9375, -0.28125 },
        { -115.390625, -171.546875 },
        { -24.5, -183.671875 } } },
    { "octagon",
      8,
      { { 2, 0 },
        { 1.5, 1.3 },
        { 0.2, 2.1 },
        { -1.4, 1.2 },
        { -1.9, 0.3 },
        { -1.2, -1.5 },
        { 0.1, -1.8 },
        { 1.3, -1.4 } } }
};

/* They have a target of their own, which takes about a second each in f64 too. */
static bool is_narrow(unsigned k) { return k >= 12 && k < SHAPES - 1; }

/* To solve a narrow one takes seconds, and the solver is the same for each number type: each of
 * them is solved once, for one type. The zigzag in q16 and the spiral in f64 take 16 s each, and
 * are left out. With LOFT_ALL each is solved for each type. */
#define SPIRAL 11
#define ZIGZAG 18
static unsigned arb_shape(arb *a)
{
    const unsigned k = arb_below(a, SHAPES);

    if (getenv("LOFT_ALL"))
        return k;
    const unsigned once = is_narrow(k) ? k - k % 3 + BY_NUM(0, 1, 2) : k;
    return once == BY_NUM(ZIGZAG, SHAPES, SPIRAL) ? once - 3 : once;
}

static struct {
    arb_domain p;
    solved s;
    bool begun;
} known[SHAPES];

static solved *shape_of(unsigned k)
{
    arb_domain *p = &known[k].p;

    if (known[k].begun)
        return &known[k].s;
    p->n = shapes[k].n;
    for (unsigned i = 0; i < p->n; i++)
        p->v[i] = spot_raw((int64_t)(shapes[k].v[i][0] * 65536),
                           (int64_t)(shapes[k].v[i][1] * 65536));
    CHECK(loft_domain_init(&p->d, p->v, p->n) == LOFT_OK);
    if (is_narrow(k))
        solve_to(&known[k].s, &p->d, BY_NUM(HARMONIC_TARGET_Q16, NARROW_TARGET, NARROW_TARGET));
    else
        solve(&known[k].s, &p->d);
    CHECK(known[k].s.ready);
    known[k].begun = true;
    return &known[k].s;
}

/* A point inside, half of them within some LSB of an edge; false when it fell elsewhere. */
static bool inside(arb *a, const arb_domain *p, loft_spot *out)
{
    loft_sci area[LOFT_SIDES_MAX];
    unsigned index = 0;

    *out = arb_near(a, p);
    return loft_domain_place(&p->d, *out, area, &index) == LOFT_INSIDE;
}

static void point_of(loft_spot p, double out[2])
{
    for (int k = 0; k < 2; k++)
        out[k] = (double)exact_of(p.at[k]);
}

static void the_bound_is_reached(arb *a)
{
    const unsigned k = arb_shape(a);
    const solved *s = shape_of(k);

    CHECK(s->series.bound + solved_rounding(s) <
          (is_narrow(k) ? 1e-6L : BY_NUM(1e-6L, 1e-6L, 1e-12L)));
    CHECK(s->series.largest < 0x1p31L && s->series.points > 200);
}

/* No point of the boundary, however close to a vertex, has an error above the bound. */
static void the_bound_holds_between_the_samples(arb *a)
{
    const unsigned k = arb_shape(a), n = shapes[k].n, edge = arb_below(a, n),
                   after = (edge + 1) % n;
    const solved *s = shape_of(k);
    const double(*v)[2] = (const double(*)[2])s->series.v;
    const double share = ldexp(1 + arb_below(a, 65536) / 65536.0, -1 - (int)arb_below(a, 24));
    long double phi[LOFT_SIDES_MAX], t[2];
    double at[2];

    for (int i = 0; i < 2; i++)
        at[i] = v[edge][i] + (v[after][i] - v[edge][i]) * share;
    harmonic_at(&s->series, at, phi);
    t[0] = hypotl(at[0] - v[edge][0], at[1] - v[edge][1]);
    t[1] = hypotl(at[0] - v[after][0], at[1] - v[after][1]);
    /* The point is rounded, and next to a vertex the slope is infinite. */
    for (unsigned i = 0; i < n; i++)
        CHECK_NEAR(phi[i] - (i == edge    ? t[1] / (t[0] + t[1])
                             : i == after ? t[0] / (t[0] + t[1])
                                          : 0),
                   0, s->series.bound + 6e-10L);
}

/* 1e-12 in f64, rounding included. */
static void an_irregular_octagon_has_twelve_digits(arb *a)
{
    const solved *s = shape_of(SHAPES - 1);

    (void)a;
    CHECK(s->series.bound + solved_rounding(s) < BY_NUM(0x1p-21L, 1e-8L, 1e-12L));
}

static void the_library_evaluates_the_series(arb *a)
{
    const unsigned shape = arb_shape(a);
    const solved *s = shape_of(shape);
    const arb_domain *p = &known[shape].p;
    long double want[LOFT_SIDES_MAX];
    loft_sci phi[LOFT_SIDES_MAX];
    double at[2];
    loft_spot q;

    if (!inside(a, p, &q))
        return;
    point_of(q, at);
    harmonic_at(&s->series, at, want);
    CHECK(loft_harmonic_eval(&s->h, q, phi) == LOFT_OK);
    for (unsigned i = 0; i < p->n; i++) {
        CHECK_NEAR(exact_sci(phi[i]) - fminl(fmaxl(want[i], 0), 1), 0, solved_rounding(s));
        CHECK(exact_sci(phi[i]) > 0 && exact_sci(phi[i]) <= 1);
    }
}

/* sum phi_i = 1 and sum phi_i v_i = p hold of the solution, so of the series within its bound for
 * each. */
static void constants_and_the_point_are_reproduced(arb *a)
{
    const unsigned shape = arb_shape(a);
    const solved *s = shape_of(shape);
    const arb_domain *p = &known[shape].p;
    const long double off = (long double)p->n * (s->series.bound + solved_rounding(s));
    long double sum = 0, x[2] = { 0, 0 }, size = 4;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_spot q;

    if (!inside(a, p, &q))
        return;
    CHECK(loft_harmonic_eval(&s->h, q, phi) == LOFT_OK);
    for (unsigned i = 0; i < p->n; i++) {
        sum += exact_sci(phi[i]);
        for (int k = 0; k < 2; k++) {
            x[k] += exact_sci(phi[i]) * exact_of(p->v[i].at[k]);
            size = fmaxl(size, fabsl(exact_of(p->v[i].at[k])));
        }
    }
    CHECK_NEAR(sum - 1, 0, off);
    for (int k = 0; k < 2; k++)
        CHECK_NEAR(x[k] - exact_of(q.at[k]), 0, size * off);
}

/* Known without a solver: barycentric in a triangle, bilinear in a square. */
static void triangle_and_square_are_what_formulas_say(arb *a)
{
    const unsigned shape = arb_below(a, 2);
    const solved *s = shape_of(shape);
    const arb_domain *p = &known[shape].p;
    const long double off = s->series.bound + solved_rounding(s);
    loft_sci phi[LOFT_SIDES_MAX];
    loft_spot q;

    if (!inside(a, p, &q))
        return;
    CHECK(loft_harmonic_eval(&s->h, q, phi) == LOFT_OK);
    const long double x = exact_of(q.at[0]), y = exact_of(q.at[1]);
    const long double square[4] = { (1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y };
    for (unsigned i = 0; i < p->n; i++) {
        const loft_spot *b = &p->v[(i + 1) % p->n], *c = &p->v[(i + 2) % p->n];
        const long double triangle = (long double)exact_cross(&q, b, c) /
                                     (long double)exact_cross(&p->v[i], b, c);
        CHECK_NEAR(exact_sci(phi[i]) - (shape ? square[i] : triangle), 0, off);
    }
}

/* One LSB inside, a coordinate is what it is on the edge but for some multiple of its slope there;
 * at a corner of the angle
 * A that is infinite, like r^(pi/A - 1), at most r^(-1/2). A branch that is missed anywhere shows
 * as an error of its own size. */
static void next_to_an_edge_it_is_nearly_linear(arb *a)
{
    const unsigned shape = arb_shape(a);
    const solved *s = shape_of(shape);
    const arb_domain *p = &known[shape].p;
    const unsigned edge = arb_below(a, p->n), after = (edge + 1) % p->n;
    const long double off = is_narrow(shape) ? 0.05L : 0.02L;
    const loft_spot on = arb_on_edge(a, p, edge);
    const loft_spot q = spot_raw(exact_raw(on.at[0]) + (int)arb_below(a, 5) - 2,
                                 exact_raw(on.at[1]) + (int)arb_below(a, 5) - 2);
    loft_sci phi[LOFT_SIDES_MAX], area[LOFT_SIDES_MAX];
    unsigned index = 0;

    if (loft_domain_place(&p->d, q, area, &index) != LOFT_INSIDE)
        return;
    CHECK(loft_harmonic_eval(&s->h, q, phi) == LOFT_OK);
    const long double x = exact_of(p->v[after].at[0]) - exact_of(p->v[edge].at[0]),
                      y = exact_of(p->v[after].at[1]) - exact_of(p->v[edge].at[1]);
    const long double t = ((exact_of(q.at[0]) - exact_of(p->v[edge].at[0])) * x +
                           (exact_of(q.at[1]) - exact_of(p->v[edge].at[1])) * y) /
                          (x * x + y * y);
    for (unsigned i = 0; i < p->n; i++)
        CHECK_NEAR(exact_sci(phi[i]) - (i == edge    ? 1 - t
                                        : i == after ? t
                                                     : 0),
                   0, off + s->series.bound);
}

static void edges_and_vertices_are_exact_and_outside_is_refused(arb *a)
{
    const unsigned shape = arb_shape(a);
    const solved *s = shape_of(shape);
    const arb_domain *p = &known[shape].p;
    const unsigned edge = arb_below(a, p->n);
    const loft_spot q = arb_on_edge(a, p, edge),
                    far = spot_raw(30000 * 65536, (int32_t)arb_below(a, 65536));
    loft_sci phi[LOFT_SIDES_MAX], want[LOFT_SIDES_MAX], area[LOFT_SIDES_MAX];
    loft_jet jet[LOFT_SIDES_MAX];
    unsigned index = 0;

    const enum loft_place place = loft_domain_place(&p->d, q, area, &index);
    if (place == LOFT_AT_VERTEX)
        loft_domain_vertex(&p->d, index, want);
    else
        loft_domain_edge(&p->d, q, index, want);
    CHECK(loft_harmonic_eval(&s->h, q, phi) == LOFT_OK);
    for (unsigned i = 0; i < p->n; i++)
        CHECK(exact_sci(phi[i]) - exact_sci(want[i]) == 0);
    CHECK(loft_harmonic_jet(&s->h, q, jet) == (place == LOFT_AT_VERTEX ? LOFT_SINGULAR : LOFT_OK));
    CHECK(loft_harmonic_eval(&s->h, far, phi) == LOFT_ERR_RANGE &&
          loft_harmonic_jet(&s->h, far, jet) == LOFT_ERR_RANGE);
}

/* How far from the boundary. */
static long double room_of(const arb_domain *p, const double at[2])
{
    long double least = 1e9L;

    for (unsigned i = 0; i < p->n; i++) {
        const loft_spot *b = &p->v[i], *c = &p->v[(i + 1) % p->n];
        const long double x = exact_of(c->at[0]) - exact_of(b->at[0]),
                          y = exact_of(c->at[1]) - exact_of(b->at[1]);
        const long double u = at[0] - exact_of(b->at[0]), v = at[1] - exact_of(b->at[1]);
        const long double t = fminl(fmaxl((u * x + v * y) / (x * x + y * y), 0), 1);
        least = fminl(least, hypotl(u - t * x, v - t * y));
    }
    return least;
}

/* Against central differences of the series, whose own error is a fourth derivative: at most 4! /
 * r^4 times the step squared. */
static void derivatives_are_those_of_the_series(arb *a)
{
    const unsigned shape = arb_shape(a);
    const solved *s = shape_of(shape);
    const arb_domain *p = &known[shape].p;
    long double by[3][3][LOFT_SIDES_MAX];
    loft_jet jet[LOFT_SIDES_MAX];
    double at[2];
    loft_spot q;

    if (!inside(a, p, &q))
        return;
    point_of(q, at);
    const long double room = room_of(p, at), step = ldexpl(1, ilogbl(room) - 9),
                      rest = solved_rounding(s) + 0x1p-60L * s->series.largest;
    if (room < 0.01L)
        return;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            const double beside[2] = { at[0] + (i - 1) * (double)step,
                                       at[1] + (k - 1) * (double)step };
            harmonic_at(&s->series, beside, by[i][k]);
        }
    CHECK(loft_harmonic_jet(&s->h, q, jet) == LOFT_OK);
    for (unsigned i = 0; i < p->n; i++) {
        const long double first = 8 * step * step / powl(room, 3) + 16 * rest / room,
                          second = 64 * step * step / powl(room, 4) + 256 * rest / (room * room) +
                                   0x1p-60L * s->series.largest / (step * step);
        CHECK_NEAR(exact_sci(jet[i].x) - (by[2][1][i] - by[0][1][i]) / (2 * step), 0,
                   first + rest / step * 0x1p-8L);
        CHECK_NEAR(exact_sci(jet[i].y) - (by[1][2][i] - by[1][0][i]) / (2 * step), 0,
                   first + rest / step * 0x1p-8L);
        CHECK_NEAR(exact_sci(jet[i].xx) -
                       (by[2][1][i] - 2 * by[1][1][i] + by[0][1][i]) / (step * step),
                   0, second);
        CHECK_NEAR(exact_sci(jet[i].xy) -
                       (by[2][2][i] - by[2][0][i] - by[0][2][i] + by[0][0][i]) / (4 * step * step),
                   0, second);
        CHECK_NEAR(exact_sci(jet[i].xx) + exact_sci(jet[i].yy), 0, 0);
    }
}

static void a_table_for_another_polygon_is_refused(arb *a)
{
    const unsigned shape = arb_shape(a);
    const solved *s = shape_of(shape);
    loft_harmonic h;
    loft_harmonic_table other = s->table;

    other.sides = (uint8_t)(other.sides == 3 ? 4 : 3);
    CHECK(loft_harmonic_init(&h, &known[shape].p.d, &other) == LOFT_ERR_ARG);
    other = s->table;
    other.powers[arb_below(a, s->table.sides)]++;
    CHECK(loft_harmonic_init(&h, &known[shape].p.d, &other) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(the_bound_is_reached, 100);
    PROPERTY(the_bound_holds_between_the_samples, 1500);
    PROPERTY(an_irregular_octagon_has_twelve_digits, 1);
    PROPERTY(the_library_evaluates_the_series, 1500);
    PROPERTY(constants_and_the_point_are_reproduced, 1500);
    PROPERTY(triangle_and_square_are_what_formulas_say, 1000);
    PROPERTY(next_to_an_edge_it_is_nearly_linear, 1500);
    PROPERTY(edges_and_vertices_are_exact_and_outside_is_refused, 500);
    PROPERTY(derivatives_are_those_of_the_series, 500);
    PROPERTY(a_table_for_another_polygon_is_refused, 100);
    for (unsigned k = 0; k < SHAPES; k++)
        solved_free(&known[k].s);
    return check_failures();
}

/* tests/test_measure.c -- chords, lengths and parameters at a length (lib/curve/measure.h) against long double
 * SPDX-License-Identifier: MIT
 */
#include <math.h>           /* sqrtl, ldexpl: the reference */

#include "curve/measure.h"
#include "check.h"          /* CHECK, CHECK_NEAR, PROPERTY, BY_NUM */

typedef long double real;
typedef struct { real x[LOFT_AXES]; } point;
typedef struct { point p[4]; } exact;

static point point_of(loft_vec v)
{
    point p;
    for (int i = 0; i < LOFT_AXES; i++)
        p.x[i] = arb_value(v.axis[i]);
    return p;
}

static exact exact_of(const loft_cubic *c)
{
    exact e;
    for (int k = 0; k < 4; k++)
        e.p[k] = point_of(c->p[k]);
    return e;
}

static real  wide(loft_acc x)       { return BY_NUM(0x1p-32L, 1, 1) * (real)x; }
static real  parameter(loft_unit t) { return BY_NUM(0x1p-24L, 1, 1) * (real)t; }
static loft_real tol_of(int32_t raw) { return BY_NUM(raw, (loft_real)(raw / 65536.0), (loft_real)(raw / 65536.0)); }

/* A length as acc, cut to its grain. */
static loft_acc acc_of(real x)      { return (loft_acc)(BY_NUM(0x1p32L, 1, 1) * x); }

static point between(point a, point b, real t)
{
    for (int i = 0; i < LOFT_AXES; i++)
        a.x[i] += (b.x[i] - a.x[i]) * t;
    return a;
}

static real distance(point a, point b)
{
    real sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += (a.x[i] - b.x[i]) * (a.x[i] - b.x[i]);
    return sqrtl(sum);
}

static real distance_from_segment(point w, point a, point b)
{
    real dot = 0, square = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        dot    += (w.x[i] - a.x[i]) * (b.x[i] - a.x[i]);
        square += (b.x[i] - a.x[i]) * (b.x[i] - a.x[i]);
    }
    const real t = square > 0 ? dot / square : 0;
    return distance(w, between(a, b, t < 0 ? 0 : t > 1 ? 1 : t));
}

static void split(const exact *c, real t, exact *left, exact *right)
{
    const point q0 = between(c->p[0], c->p[1], t), q1 = between(c->p[1], c->p[2], t), q2 = between(c->p[2], c->p[3], t);
    const point r0 = between(q0, q1, t), r1 = between(q1, q2, t), s = between(r0, r1, t);
    const exact l = {{ c->p[0], q0, r0, s }}, r = {{ s, r1, q2, c->p[3] }};
    *left  = l;
    *right = r;
}

static point at(const exact *c, real t)
{
    exact left, right;
    split(c, t, &left, &right);
    return left.p[3];
}

static real polygon(const exact *c)
{
    return distance(c->p[0], c->p[1]) + distance(c->p[1], c->p[2]) + distance(c->p[2], c->p[3]);
}

/* Length within +-tol, by halving until chord and polygon agree. */
static real length(const exact *c, real tol, int depth)
{
    const real p = polygon(c), chord = distance(c->p[0], c->p[3]);
    exact left, right;

    if (p - chord <= 2 * tol || depth == 40)
        return (p + chord) / 2;
    split(c, 0.5L, &left, &right);
    return length(&left, tol / 2, depth + 1) + length(&right, tol / 2, depth + 1);
}

static real length_to(const exact *c, real t, real tol)
{
    exact left, right;
    split(c, t, &left, &right);
    return length(&left, tol, 0);
}

static uint32_t halvings(const exact *c, real tol)
{
    exact left, right;

    if (distance_from_segment(c->p[1], c->p[0], c->p[3]) <= tol && distance_from_segment(c->p[2], c->p[0], c->p[3]) <= tol)
        return 1;
    split(c, 0.5L, &left, &right);
    return halvings(&left, tol) + halvings(&right, tol);
}

static loft_real part_of(loft_real a, loft_real b, double t)    /* on the way from a to b, beyond it too */
{
    const double x = arb_value(a) + t * (arb_value(b) - arb_value(a));
    return BY_NUM((loft_real)(x * 65536), (loft_real)x, (loft_real)x);
}

/* Cubics of every kind: any, closed, with double ends, straight and overshooting, cusped, of corners, plane, and
 * almost straight with an inflection; from a few LSB to the whole range. */
static loft_cubic arb_shape(arb *a)
{
    loft_cubic c = arb_cubic(a, (1 << arb_below(a, 15)));
    const double u = arb_below(a, 4096) / 1024.0 - 1.5, v = arb_below(a, 4096) / 1024.0 - 1.5;

    switch (arb_below(a, 10)) {
    case 0: c.p[3] = c.p[0]; break;
    case 1: c.p[1] = c.p[0]; break;
    case 2: c.p[1] = c.p[0]; c.p[2] = c.p[3]; break;
    case 3: case 4:
        for (int i = 0; i < LOFT_AXES; i++) {
            c.p[0].axis[i] /= 4;
            c.p[3].axis[i] /= 4;
            c.p[1].axis[i] = part_of(c.p[0].axis[i], c.p[3].axis[i], u);
            c.p[2].axis[i] = part_of(c.p[0].axis[i], c.p[3].axis[i], v);
        }
        if (arb_below(a, 2))
            c.p[2].axis[0] += LOFT_REAL(0.01);
        break;
    case 5:                                         /* legs w, w', -w have a cusp when w' is none */
        for (int i = 0; i < LOFT_AXES; i++) {
            for (int k = 0; k < 3; k++)
                c.p[k].axis[i] /= 4;
            c.p[2].axis[i] = c.p[1].axis[i] + (arb_below(a, 2) ? c.p[2].axis[i] / 64 : 0);
            c.p[3].axis[i] = c.p[0].axis[i] + (arb_below(a, 2) ? c.p[2].axis[i] / 16 : 0);
        }
        break;
    case 6:                                         /* p0 + p3 - p1 - p2 = -2 (p1 - p2): cusp at 1/2 */
        for (int i = 0; i < LOFT_AXES; i++) {
            for (int k = 0; k < 3; k++)
                c.p[k].axis[i] /= 8;
            c.p[3].axis[i] = c.p[0].axis[i] + c.p[2].axis[i] - c.p[1].axis[i];
            c.p[2].axis[i] = c.p[0].axis[i] + c.p[3].axis[i] - c.p[1].axis[i];
        }
        break;
    case 7:
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                c.p[k].axis[i] = BY_NUM(arb_below(a, 2) ? INT32_MAX : INT32_MIN, LOFT_REAL(32767) * (arb_below(a, 2) ? 1 : -1),
                                        LOFT_REAL(32767) * (arb_below(a, 2) ? 1 : -1));
        break;
    case 8:
        for (int k = 0; k < 4; k++)
            c.p[k].axis[LOFT_AXES - 1] = 0;
        break;
    }
    return c;
}

static real size_of(const exact *c)
{
    real size = 0;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            size = fmaxl(size, fabsl(c->p[k].x[i]));
    return size;
}

/* A tolerance from `least` LSB up that leaves at most some thousand chords. */
static int32_t arb_tol(arb *a, const exact *c, int32_t least)
{
    int64_t raw = least - 1 + ((int32_t)1 << arb_below(a, 20));
    while ((real)raw / 65536 < size_of(c) / (1 << 17))
        raw *= 2;
    return (int32_t)raw;
}


// Chords
// ------

/* All that is promised of one chord from..to of the parameter. */
static void check_chord(const exact *e, point from, point to, real s, real t, real tol)
{
    real worst = 0, back = 0;

    for (int j = 0; j <= 24; j++)
        worst = fmaxl(worst, distance_from_segment(at(e, s + (t - s) * j / 24), from, to));
    for (int j = 1; j < 4; j++) {               /* points of the chord against a polyline in the curve */
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
            check_chord(&e, point_of(p), point_of(q), ldexpl(from, -24), ldexpl(f.at, -24), raw / 65536.0L);
        from = f.at;
    }
    CHECK(chords > 0 && loft_vec_equal(q, c.p[3]) && f.at == (uint32_t)1 << 24);
    CHECK(!accepted || !loft_flatten_next(&f, &p));
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

/* A piece that is just flat and long, often almost halting in the middle, and as much of the cubic before it: the
 * hard case, since a chord may end anywhere in the piece and the rest is still to be one chord. */
static void never_more_chords_than_halving_gives_where_a_piece_halts(arb *a)
{
    const double reach = 4 << arb_below(a, 9);
    const int32_t least = BY_NUM(8, (int32_t)reach * 8, 8), raw = least + (int32_t)arb_below(a, 2u << arb_below(a, 15));
    const double foot = arb_below(a, 2) ? 1 : arb_below(a, 1024) / 1024.0, side = 0.98 * raw / 65536 / sqrt(LOFT_AXES);
    loft_cubic c;

    for (int i = 0; i < LOFT_AXES; i++) {
        const double way = side * (arb_below(a, 2001) / 1000.0 - 1);
        const double b1 = (i ? 0 : foot * reach) + way, b2 = (i ? 0 : (1 - foot) * reach) + (arb_below(a, 2) ? way : -way);
        const double b3 = i ? 0 : reach;
        const double whole[4] = { 6 * b2 - 12 * b1 - b3, 4 * b1 - 4 * b2 + b3, 2 * b2 - b3, b3 };
        for (int k = 0; k < 4; k++)
            c.p[k].axis[i] = BY_NUM((loft_real)(whole[k] * 65536), (loft_real)whole[k], (loft_real)whole[k]);
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

/* y = 4 d t (1 - t) over a long x: n chords of equal dt leave d / n^2 each, so the fewest are sqrt(d / tol). */
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

/* y = 3 d t (1 - t)(1 - 2 t) is at most d / sqrt(12) to either side, with control points at d. */
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

/* Along 0, L, 0, L the curve halts in the middle but never turns back. Its second part has control points far
 * behind its start and is one chord all the same. */
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
            c.p[k].axis[i] = BY_NUM((loft_real)floorl(after.p[k].x[i] * 65536 + 0.5L), (loft_real)after.p[k].x[i], (loft_real)after.p[k].x[i]);
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
    CHECK(loft_flatten_init(&f, &c, BY_NUM(INT32_MAX, LOFT_REAL(1e30), LOFT_REAL(1e30))) == LOFT_OK);
#if LOFT_NUM != LOFT_Q16
    CHECK(loft_flatten_init(&f, &c, (loft_real)NAN) == LOFT_ERR_ARG);
    CHECK(loft_flatten_init(&f, &c, (loft_real)INFINITY) == LOFT_ERR_RANGE);
    c.p[arb_below(a, 4)].axis[0] = arb_below(a, 2) ? (loft_real)NAN : -(loft_real)INFINITY;
    CHECK(loft_flatten_init(&f, &c, LOFT_REAL(1)) == LOFT_ERR_RANGE);
#endif
}

/* The finest tolerance at every size: it still ends, and every piece keeps it. */
static void the_finest_tolerance_is_kept(arb *a)
{
    const int32_t limit = (int32_t)(1 + arb_below(a, 16)) << (arb_below(a, 2) ? 0 : 11);
    loft_cubic c = arb_cubic(a, limit < 32768 ? limit : 32767);
    const exact e = exact_of(&c);
    const real tol = BY_NUM(2 / 65536.0L, size_of(&e) / 4194304, size_of(&e) * 0x1p-40L);
    loft_flatten f;
    loft_vec p, q = c.p[0];
    uint32_t from = 0;

    if (loft_flatten_init(&f, &c, BY_NUM(2, (loft_real)(tol * 1.0001L), (loft_real)tol)) != LOFT_OK) {
        CHECK(size_of(&e) <= 0);
        return;
    }
    for (int n = 0; n < 200 && (p = q, loft_flatten_next(&f, &q)); n++) {
        check_chord(&e, point_of(p), point_of(q), ldexpl(from, -24), ldexpl(f.at, -24), tol * 1.0001L);
        from = f.at;
    }
}


// Length
// ------

/* What the header promises for a tolerance. */
static real promised(const exact *e, real tol, real share)
{
    const real p = polygon(e);
    return fmaxl(tol, p * share) + BY_NUM(p * 0x1p-27L + 0x1p-16L, p * 0x1p-40L, p * 0x1p-40L);
}

static void length_is_within_the_tolerance(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 1);
    const real bound = promised(&e, raw / 65536.0L, 0x1p-22L);

    CHECK_NEAR(wide(loft_cubic_length(&c, tol_of(raw))) - length(&e, bound / 64, 0), 0, bound);
}

/* y = x^2: length sqrt(5) / 2 + ln(2 + sqrt(5)) / 4 per unit. */
static void the_length_of_a_parabola_is_its_closed_form(arb *a)
{
    const int32_t scale = 3 << arb_below(a, 12);
    loft_cubic c = {{{{0}}}};

#if LOFT_AXES > 1
    c.p[1].axis[0] = loft_real_from_int(scale / 3);
    c.p[2].axis[0] = loft_real_from_int(2 * scale / 3);
    c.p[2].axis[1] = loft_real_from_int(scale / 3);
    c.p[3].axis[0] = c.p[3].axis[1] = loft_real_from_int(scale);
    const real want = scale * (sqrtl(5) / 2 + logl(2 + sqrtl(5)) / 4);
    const exact e = exact_of(&c);
    for (int32_t raw = 1; raw < 1 << 20; raw *= 4)
        CHECK_NEAR(wide(loft_cubic_length(&c, tol_of(raw))) - want, 0, promised(&e, raw / 65536.0L, 0x1p-22L));
#else
    (void)c; (void)scale;
#endif
}

static void the_parameter_at_a_length_has_that_length(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 2);
    const real bound = promised(&e, raw / 65536.0L, 0x1p-21L), whole = length(&e, bound / 64, 0);
    loft_ruler r;

    CHECK(loft_ruler_init(&r, &c, tol_of(raw)) == LOFT_OK);
    CHECK_NEAR(wide(loft_ruler_length(&r)) - whole, 0, bound);
    for (int k = 0; k < 8; k++) {
        const real want = whole * arb_below(a, 1025) / 1024;
        const loft_unit t = k % 2 ? loft_ruler_at_length(&r, acc_of(want)) : loft_cubic_at_length(&c, acc_of(want), tol_of(raw));
        const real got = length_to(&e, parameter(t), bound / 64), before = parameter(t) - 0x1p-24L, after = parameter(t) + 0x1p-24L;
        CHECK(t >= 0 && t <= LOFT_UNIT(1));
        if (fabsl(got - want) > bound) {        /* a step of t too far at most */
            const real low  = length_to(&e, before > 0 ? before : 0, bound / 64);
            const real high = length_to(&e, after < 1 ? after : 1, bound / 64);
            CHECK(want >= low - bound && want <= high + bound);
        }
    }
}

static void a_ruler_measures_from_the_start_to_anywhere(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 2);
    const real bound = promised(&e, raw / 65536.0L, 0x1p-21L);
    const loft_unit t = arb_unit(a);
    loft_ruler r;

    CHECK(loft_ruler_init(&r, &c, tol_of(raw)) == LOFT_OK);
    CHECK_NEAR(wide(loft_ruler_eval(&r, t)) - length_to(&e, parameter(t), bound / 64), 0, bound);
    CHECK(!(loft_ruler_eval(&r, 0) > 0) && !(loft_ruler_eval(&r, -LOFT_UNIT(1)) > 0));
    CHECK_NEAR(loft_ruler_eval(&r, LOFT_UNIT(1)), loft_ruler_length(&r), 0);
    CHECK_NEAR(loft_ruler_eval(&r, LOFT_UNIT(2)), loft_ruler_length(&r), 0);
}

static void the_parameter_never_decreases_with_the_length(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const loft_real tol = tol_of(arb_tol(a, &e, 2));
    loft_ruler r;
    loft_unit last = 0, low = 0;

    CHECK(loft_ruler_init(&r, &c, tol) == LOFT_OK);
    const real whole = wide(loft_ruler_length(&r)), fine = whole / (1 << (8 + arb_below(a, 16)));
    const real start = whole * arb_below(a, 1024) / 1024;
    for (int k = -2; k < 60; k++) {
        const loft_unit t = loft_ruler_at_length(&r, acc_of(start + k * fine));
        const loft_unit u = k % 8 ? low : loft_cubic_at_length(&c, acc_of(start + k * fine), tol);
        CHECK(t >= last && u >= low);
        last = t;
        low  = u;
    }
    CHECK(!(loft_ruler_at_length(&r, -loft_wide(tol)) > 0) && !(loft_cubic_at_length(&c, -loft_wide(tol), tol) > 0));
    CHECK(loft_ruler_at_length(&r, acc_of(whole * 1.01L + 1)) >= LOFT_UNIT(1));
    CHECK(loft_cubic_at_length(&c, acc_of(whole * 1.01L + 1), tol) >= LOFT_UNIT(1));
}

static void a_point_has_no_length_and_ends_where_it_starts(arb *a)
{
    const loft_vec p = arb_vec(a, 32767);
    const loft_cubic c = {{ p, p, p, p }};
    const loft_real tol = LOFT_REAL(0.125);
    loft_ruler r;

    CHECK(loft_ruler_init(&r, &c, tol) == LOFT_OK && chords_of(&c, 8192) == 1);
    CHECK(!(loft_cubic_length(&c, tol) > 0) && !(loft_ruler_length(&r) > 0));
    CHECK(!(loft_cubic_at_length(&c, 0, tol) > 0) && !(loft_ruler_at_length(&r, 0) > 0));
    CHECK(loft_cubic_at_length(&c, loft_wide(tol), tol) >= LOFT_UNIT(1) && loft_ruler_at_length(&r, loft_wide(tol)) >= LOFT_UNIT(1));
}

static void a_ruler_refuses_what_is_no_number(arb *a)
{
    loft_cubic c = arb_cubic(a, 32767);
    loft_ruler r;

    CHECK(loft_ruler_init(&r, &c, 0) == LOFT_ERR_ARG && loft_ruler_init(&r, &c, -LOFT_REAL(1)) == LOFT_ERR_ARG);
#if LOFT_NUM != LOFT_Q16
    CHECK(loft_ruler_init(&r, &c, (loft_real)NAN) == LOFT_ERR_ARG);
    c.p[arb_below(a, 4)].axis[0] = arb_below(a, 2) ? (loft_real)NAN : (loft_real)INFINITY;
    CHECK(loft_ruler_init(&r, &c, LOFT_REAL(1)) == LOFT_ERR_RANGE);
#endif
}

int main(void)
{
    PROPERTY(chords_and_curve_are_within_the_tolerance_of_each_other, 150);
    PROPERTY(never_more_chords_than_halving_gives,                    150);
    PROPERTY(never_more_chords_than_halving_gives_for_drawings,      2000);
    PROPERTY(never_more_chords_than_halving_gives_where_a_piece_halts, 600);
    PROPERTY(a_flat_parabola_takes_the_fewest_chords,                 100);
    PROPERTY(a_straight_even_line_is_one_chord,                       200);
    PROPERTY(an_inflection_between_sides_within_the_tolerance_is_one_chord, 100);
    PROPERTY(a_line_that_halts_is_one_chord,                          300);
    PROPERTY(tolerances_that_cannot_be_kept_are_refused,               50);
    PROPERTY(the_finest_tolerance_is_kept,                             20);
    PROPERTY(length_is_within_the_tolerance,                          400);
    PROPERTY(the_length_of_a_parabola_is_its_closed_form,              12);
    PROPERTY(the_parameter_at_a_length_has_that_length,               100);
    PROPERTY(a_ruler_measures_from_the_start_to_anywhere,             200);
    PROPERTY(the_parameter_never_decreases_with_the_length,           100);
    PROPERTY(a_point_has_no_length_and_ends_where_it_starts,           50);
    PROPERTY(a_ruler_refuses_what_is_no_number,                        50);
    return check_failures();
}

/* tests/vectors/vectors_spline.c -- readers of the interpolating curves
 * SPDX-License-Identifier: MIT
 *
 * Where f32 cannot hold the row's coordinates the parabolas and the splines by chord length are
 * other curves than the row's: there answers and statuses are those of the coordinates as read, by
 * the tests' own reference.
 */
#include "vectors/vectors_points.h"         /* expect_vec, as_given; row, answer, law */
#include "support/exact_spline.h"           /* exact_parabola, exact_natural */
#include "basis/interp.h"
#include "curve/cardinal.h"
#include "curve/hermite.h"
#include "curve/monotone.h"
#include "curve/natural.h"

#define POINTS SPLINE_POINTS

/* The point once more, by the control points, which may lie further out than the point. They are
 * rounded: by 1/2 LSB, in doubles this is in the roundings; f32 rounds them to other numbers than
 * the law speaks of. */
static void expect_span(row *r, enum loft_status status, const loft_cubic *c, loft_unit t,
                        unsigned d, law l)
{
    if (status != LOFT_OK || !BY_NUM(true, false, true))
        return;
    l.lsb += 0.5L + 1 / 16384.0L;
    l.roundings += 16;
    expect_vec(r, "p", LOFT_OK, loft_cubic_eval(c, t), d, l);
}


/* Parabolas */

/* The bounds of floats are those of each result. */
static void expect_reals(row *r, const char *column, enum loft_status status, const loft_real x[],
                         unsigned count)
{
    answer *a = answer_new();

    answer_status(r, a, status);
    for (unsigned k = 0; k < count; k++)
        answer_real(a, x[k]);
    r->largest = 0;
    for (unsigned k = 0; k < count && status == LOFT_OK; k++)
        r->largest = fmaxl(r->largest, fabsl(exact_of(x[k])));
    row_expect(r, column, a, (law) { .lsb = 0.5L + 1 / 65536.0L, .roundings = 1 });
}

/* 2^-60: where results fit, the reference's terms are below 2^45, and its own error is below
 * that. */
static void expect_own(row *r, const char *what, loft_real got, quad own)
{
    const long double want = (long double)own,
                      room = ulp(want) / 2 * BY_NUM(1 + 0x1p-15L, 1.04L, 2) + 0x1p-60L;
    row_within(r, what, fabsl((long double)(quad_of(got) - own)) * 65536, room * 65536);
}

static void interp_parabola(row *r)
{
    loft_real t[3], f[3], a[3] = { 0 }, y = 0;
    loft_parabola p;

    row_reals(r, "ti_q16", 3, t);
    row_reals(r, "fi_q16", 3, f);
    const loft_real at = row_real(r, "t_q16");
    const enum loft_status start = loft_parabola_init(&p, t, f);
    const bool same = !(t[0] < t[1] || t[1] < t[0]) || !(t[1] < t[2] || t[2] < t[1]) ||
                      !(t[2] < t[0] || t[0] < t[2]);
    if (start != (same ? LOFT_SINGULAR : LOFT_OK))
        row_complain(r, "status %d of the places", start);
    if (start != LOFT_OK)
        return;

    const enum loft_status power = loft_parabola_power(&p, a),
                           value = loft_parabola_eval(&p, at, &y);
    const exact_parabola own = exact_parabola_of(t, f);
    for (int k = 0; k < 3 && power == LOFT_OK; k++)
        expect_own(r, "A, as read", a[k], exact_parabola_power(&own, k));
    if (value == LOFT_OK)
        expect_own(r, "value, as read", y, exact_parabola_blossom(&own, quad_of(at), quad_of(at)));
    if (as_given(r)) {
        expect_reals(r, "A", power, a, 3);
        expect_reals(r, "value", value, &y, 1);
    }
}


/* Hermite and cardinal segments: linear in the coordinates, so what reading rounds grows by the sum
 * of the weights */

static void hermite3(row *r)
{
    const char *const columns[3] = { "p", "dp", "ddp" };
    const unsigned d = dimension(r);
    const loft_unit t = row_unit(r, "t_q16");
    const long double l = growth(exact_unit(t));
    loft_hermite h;
    loft_cubic c;

    row_points(r, "P0_q16", 1, d, &h.p0);
    row_points(r, "P1_q16", 1, d, &h.p1);
    row_points(r, "T0_q16", 1, d, &h.t0);
    row_points(r, "T1_q16", 1, d, &h.t1);
    const law point = { .lsb = 0.5L + (l * l * l + growth_sum(exact_unit(t), 3)) / 131072,
                        .gain = 2 * l * l * l,
                        .roundings = 11 };
    for (unsigned k = 0; k < 3; k++) {
        loft_vec v = { { 0 } };
        const enum loft_status status = k ? loft_hermite_deriv(&h, k, t, &v)
                                          : loft_hermite_eval(&h, t, &v);
        const law slope = { .lsb = 0.5L + growth_sum(exact_unit(t), 3 - k) / 131072,
                            .gain = (k == 1 ? 8 : 24) * powl(l, 3 - k),
                            .roundings = 18 };
        expect_vec(r, columns[k], status, v, d, k ? slope : point);
    }
    if (t >= 0 && t <= LOFT_UNIT(1))
        expect_span(r, loft_cubic_from_hermite(&h, &c), &c, t, d, point);
}

static void hermite5(row *r)
{
    const unsigned d = dimension(r);
    const loft_unit t = row_unit(r, "t_q16");
    const long double l5 = powl(growth(exact_unit(t)), 5);
    loft_vec v = { { 0 } }, c[6];
    loft_hermite5 h;
    loft_bezier b;

    row_points(r, "P0_q16", 1, d, &h.p0);
    row_points(r, "P1_q16", 1, d, &h.p1);
    row_points(r, "T0_q16", 1, d, &h.t0);
    row_points(r, "T1_q16", 1, d, &h.t1);
    row_points(r, "A0_q16", 1, d, &h.a0);
    row_points(r, "A1_q16", 1, d, &h.a1);
    law point = { .lsb = 0.5L + (l5 + growth_sum(exact_unit(t), 5)) / 131072,
                  .gain = 2 * l5,
                  .roundings = 17 };
    const enum loft_status status = loft_hermite5_eval(&h, t, &v);
    expect_vec(r, "p", status, v, d, point);

    if (!BY_NUM(true, false, true) || loft_bezier_from_hermite5(&h, c) != LOFT_OK ||
        loft_bezier_init(&b, c, 5) != LOFT_OK)
        return;
    const enum loft_status again = loft_bezier_extrapolate(&b, t, &v);
    point.lsb += 0.5L * l5 + growth_sum(exact_unit(t), 5) / 131072;
    point.roundings += 17;
    expect_vec(r, "p", again, v, d, point);
}

static void cardinal(row *r)
{
    const unsigned d = dimension(r);
    const loft_unit t = row_unit(r, "t_q16"), tension = row_unit(r, "tau_q16");
    const long double l = growth(exact_unit(t)), s = 1 + fabsl(1 - exact_unit(tension));
    loft_vec p[4], v = { { 0 } };
    loft_cubic c;

    row_points(r, "P_q16", 4, d, p);
    const law point = { .lsb = 0.5L + (2 * l * l * l + growth_sum(exact_unit(t), 3)) / 131072,
                        .gain = s * l * l * l,
                        .roundings = 96 };
    enum loft_status status = loft_cardinal_eval(p, tension, t, &v);
    expect_vec(r, "p", status, v, d, point);
    status = loft_cardinal_deriv(p, tension, 1, t, &v);
    expect_vec(r, "dp", status, v, d,
               (law){ .lsb = 0.5L + (6 * l * l + growth_sum(exact_unit(t), 2)) / 131072,
                      .gain = 6 * s * l * l,
                      .roundings = 48 });
    if (t >= 0 && t <= LOFT_UNIT(1))
        expect_span(r, loft_cubic_from_cardinal(p, tension, &c), &c, t, d, point);
}


/* Natural splines */

typedef struct {
    unsigned d, count, i;
    loft_unit t;
    loft_vec p[POINTS];
    loft_natural_knot memory[POINTS];
    loft_natural s;
} natural;

static enum loft_status natural_of(row *r, natural *n, enum loft_spacing knots)
{
    n->d = dimension(r);
    n->count = row_count(r, "N", POINTS - 1) + 1;
    n->i = row_count(r, "i", n->count);
    n->t = row_unit(r, "t_q16");
    row_points(r, "P_q16", n->count, n->d, n->p);
    return loft_natural_init(&n->s, n->p, n->count, knots, n->memory);
}

/* A point is at most 1 + 6 / 4 of the largest coordinate: slopes are at most 6, a derivative 18, a
 * second one 48. */
static void natural_uniform(row *r)
{
    static natural n;
    loft_vec v[3] = { { { 0 } } };
    loft_cubic c;
    const law point = { .lsb = 0.5L + 1 / 16384.0L, .gain = 2.5L, .roundings = 25 };

    if (natural_of(r, &n, LOFT_UNIFORM) != LOFT_OK) {
        row_complain(r, "the spline was refused");
        return;
    }
    enum loft_status status = loft_natural_eval(&n.s, n.i, n.t, &v[0]);
    expect_vec(r, "p", status, v[0], n.d, point);
    status = loft_natural_deriv(&n.s, n.i, 1, n.t, &v[1]);
    expect_vec(r, "dp", status, v[1], n.d,
               (law){ .lsb = 0.5L + 1 / 4096.0L, .gain = 18, .roundings = 14 });
    status = loft_natural_deriv(&n.s, n.i, 2, n.t, &v[2]);
    expect_vec(r, "ddp", status, v[2], n.d,
               (law){ .lsb = 0.5L + 1 / 4096.0L, .gain = 48, .roundings = 5 });
    expect_span(r, loft_cubic_from_natural(&n.s, n.i, &c), &c, n.t, n.d, point);
}

static void expect_as_read(row *r, const natural *n, loft_vec p, loft_vec dp,
                           enum loft_status second)
{
    static exact_natural own;

    exact_natural_init(&own, n->p, n->count, true);
    if (own.coincide != (second == LOFT_SINGULAR))
        row_complain(r, "zero chord: %d, but not of the coordinates as read",
                     second == LOFT_SINGULAR);
    for (unsigned i = 0; i < n->d && !own.coincide; i++) {
        const quad t = (quad)exact_unit(n->t);
        const long double want = (long double)exact_natural_deriv(&own, n->i, 0, t, (int)i);
        const long double slope = (long double)exact_natural_deriv(&own, n->i, 1, t, (int)i);
        const long double room = BY_NUM(LSB / 16384, 64 * ulp_double(r->largest),
                                        64 * ulp_double(r->largest));
        row_within(r, "p, as read", fabsl(exact_of(p.axis[i]) - want) * 65536,
                   (ulp(want) / 2 + room) * 65536);
        row_within(r, "dp, as read", fabsl(exact_of(dp.axis[i]) - slope) * 65536,
                   (ulp(slope) / 2 + BY_NUM(LSB / 4096, 0x1p-43L, 0x1p-43L)) * 65536);
    }
}

static void natural_chord(row *r)
{
    static natural n;
    loft_vec p = { { 0 } }, dp = { { 0 } };
    loft_cubic c;
    const law point = { .lsb = 0.5L + 1 / 16384.0L, .roundings = 64 };

    const enum loft_status start = natural_of(r, &n, LOFT_CHORD);
    if (as_given(r))
        row_expect_word(r, "status", start == LOFT_SINGULAR ? "zero_chord" : "ok");
    if (start != LOFT_OK) {
        expect_as_read(r, &n, p, dp, start);
        return;
    }
    const enum loft_status first = loft_natural_eval(&n.s, n.i, n.t, &p);
    const enum loft_status second = loft_natural_deriv(&n.s, n.i, 1, n.t, &dp);
    if (first == LOFT_OK && second == LOFT_OK)
        expect_as_read(r, &n, p, dp, start);
    if (!as_given(r))
        return;
    expect_vec(r, "p", first, p, n.d, point);
    expect_span(r, loft_cubic_from_natural(&n.s, n.i, &c), &c, n.t, n.d, point);
    r->largest = 1;                 /* slopes are those of unit chords: 512 ulp at 1 are 2^-43 */
    expect_vec(r, "dp", second, dp, n.d, (law) { .lsb = 0.5L + 1 / 4096.0L, .roundings = 512 });
}

static long double steepest_secant(const loft_real x[], const loft_real y[], unsigned count)
{
    long double most = 0;

    for (unsigned i = 0; i + 1 < count; i++)
        most = fmaxl(most, fabsl(exact_of(y[i + 1]) - exact_of(y[i])) /
                               (exact_of(x[i + 1]) - exact_of(x[i])));
    return most;
}

/* Slopes are known to parts of secants. */
static void expect_slopes(row *r, const char *column, const answer *a, long double secant,
                          long double roundings)
{
    const long double largest = r->largest;

    r->largest = secant;
    row_expect(r, column, a, (law) { .lsb = 1 / 1024.0L, .roundings = roundings });
    r->largest = largest;
}

/* f32 reads other points than the row's where it cannot hold them, and secants magnify that. */
static void monotone_fc(row *r)
{
    static loft_real x[POINTS], y[POINTS];
    static loft_acc slope[POINTS];
    const unsigned count = row_count(r, "n", POINTS);
    loft_monotone f;
    loft_real z;
    answer *a = answer_new();

    row_reals(r, "x_q16", count, x);
    row_reals(r, "y_q16", count, y);
    row_reals(r, "z_q16", 1, &z);
    const enum loft_status status = loft_monotone_init(&f, x, y, count, slope);
    const long double secant = steepest_secant(x, y, count);
    /* so steep that a slope within an interval, 3/2 of the secant, does not fit a coordinate */
    if (!as_given(r) || (status == LOFT_ERR_RANGE && secant > 0x1p22L))
        return;
    if (status != LOFT_OK) {
        row_complain(r, "the function was refused");
        return;
    }
    for (unsigned i = 0; i < count; i++)
        answer_wide(a, slope[i]);
    expect_slopes(r, "slopes", a, secant, 32);
    a = answer_new();
    answer_real(a, loft_monotone_eval(&f, z));
    row_expect(r, "value", a, (law) { .lsb = 0.5L + 1 / 16.0L, .roundings = 64 });
    a = answer_new();
    answer_wide(a, loft_monotone_deriv(&f, z));
    expect_slopes(r, "deriv", a, secant, 128);
}

const vector_system vectors_spline[] = {
    { "interp_parabola", "ti_q16,fi_q16,t_q16,A,value", interp_parabola,
      "1/2 LSB + 2^-16 LSB; f32, f64: 0.52 and 1 ulp of the result" },
    { "hermite3", "d,P0_q16,P1_q16,T0_q16,T1_q16,t_q16,p,dp,ddp", hermite3,
      "1/2 LSB + (L^3 + 1 + L + L^2) / 2^17 LSB; k-th derivative 1/2 LSB + (1 + .. + L^(2-k)) / "
      "2^17 LSB" },
    { "hermite5", "d,P0_q16,P1_q16,T0_q16,T1_q16,A0_q16,A1_q16,t_q16,p", hermite5,
      "1/2 LSB + (L^5 + 1 + L + .. + L^4) / 2^17 LSB" },
    { "cardinal", "d,P_q16,tau_q16,t_q16,p,dp", cardinal,
      "p 1/2 LSB + (2 L^3 + 1 + L + L^2) / 2^17 LSB, dp 1/2 LSB + (6 L^2 + 1 + L) / 2^17 LSB" },
    { "natural_uniform", "N,d,P_q16,i,t_q16,p,dp,ddp", natural_uniform,
      "p 1/2 LSB + 2^-14 LSB, dp, ddp 1/2 LSB + 2^-12 LSB" },
    { "monotone_fc", "n,x_q16,y_q16,z_q16,slopes,value,deriv", monotone_fc,
      "slopes and derivative 1/1024, value 1/2 + 1/16" },
    { "natural_chord", "N,d,P_q16,i,t_q16,status,p,dp", natural_chord,
      "status exact, p 1/2 LSB + 2^-14 LSB, dp 1/2 LSB + 2^-12 LSB" },
    { NULL, NULL, NULL, NULL }
};

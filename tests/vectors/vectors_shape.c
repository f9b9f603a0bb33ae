/* tests/vectors/vectors_shape.c -- readers of the systems that say what a curve looks like, and of
 * Bernstein's operator
 * SPDX-License-Identifier: MIT
 *
 * Flags and numbers are those of the row. Where f32 cannot hold the row's coordinates the row
 * speaks of another curve, and the answers are compared with the tests' own of the rounded
 * coordinates (exact_shape.h).
 */
#include "vectors/vectors.h"                /* row, answer, law */
#include "support/exact_shape.h"            /* exact_shape_of, exact_bend_at */
#include "support/exact_sign.h"             /* exact_sign_of */
#include "basis/bernstein_operator.h"
#include "basis/sign.h"
#include "curve/shape.h"

static bool as_given(const row *r)  { return !(r->inexact > 0); }

/* The bound of a parameter, in LSB: 2^-25 in q16, one ulp of the type at 1 else. */
#define UNIT_LAW ((law) { .lsb = 1 / 512.0L + 0x1p-16L, .roundings = 1 })

static const char *const kinds[] = { "point", "line", "parabola",        "serpentine",
                                     "cusp",  "loop", "cusp_at_infinity" };

/* Parameters in a column, or `-` for none; the row's own, or the test's. */
static void expect_units(row *r, const char *column, unsigned count, const loft_unit got[],
                         const long double want[])
{
    answer *a = answer_new();

    for (unsigned k = 0; k < count; k++)
        if (as_given(r))
            answer_unit(a, got[k]);
        else
            row_within(r, column, fabsl(exact_unit(got[k]) - want[k]) * 65536,
                       ulp(want[k]) * 65536);
    if (as_given(r) && count)
        row_expect(r, column, a, UNIT_LAW);
    else if (as_given(r))
        row_expect_word(r, column, "-");
}

static void expect_kind(row *r, const loft_shape *s, const exact_shape *own)
{
    char count[2] = { (char)('0' + s->inflections), '\0' };

    if (as_given(r)) {
        row_expect_word(r, "type", kinds[s->kind]);
        row_expect_word(r, "ninfl", count);
    }
    if (s->kind != own->kind || s->inflections != own->inflections || s->cusps != own->cusps ||
        s->loops != own->loops)
        row_complain(r, "%s %u %u %u, but the coordinates as read make %s %u %u %u", kinds[s->kind],
                     s->inflections, s->cusps, s->loops, kinds[own->kind], own->inflections,
                     own->cusps, own->loops);
}

static void cubic_shape(row *r)
{
    loft_cubic c;
    loft_shape s = { LOFT_POINT, 0, 0, 0, { 0 }, 0, { 0 } };

    row_points(r, "P_q16", 4, 2, c.p);
    if (loft_cubic_shape(&c, &s) != LOFT_OK)
        row_complain(r, "refused");
    const exact_shape own = exact_shape_of(&c);
    expect_kind(r, &s, &own);
    expect_units(r, "infl", s.inflections, s.inflection, own.inflection);
    expect_units(r, "cusp", s.cusps, &s.cusp, &own.cusp);
    expect_units(r, "loop", 2u * s.loops, s.loop, own.loop);
}

/* Compare with the test's own: 1 LSB, 1 ulp, and what 113 bits leave open. */
static void expect_bend(row *r, const exact_bend *own, loft_real k, loft_vec tangent, unsigned d)
{
    row_within(r, "kappa, as read", fabsl(exact_of(k) - own->curvature) * 65536,
               (ulp(own->curvature) + own->unsure) * 65536);
    for (unsigned i = 0; i < d; i++)
        row_within(r, "T, as read", fabsl(exact_of(tangent.axis[i]) - own->tangent[i]) * 65536,
                   ulp(own->tangent[i]) * 65536);
}

static void expect_curvature(row *r, enum loft_status status, loft_real k, loft_vec tangent,
                             unsigned d)
{
    const law l = { .lsb = 0.5L + 1 / 65536.0L, .roundings = 1 };
    answer *kappa = answer_new(), *direction = answer_new();

    row_expect_word(r, "status", status == LOFT_SINGULAR ? "singular" : "ok");
    if (status == LOFT_SINGULAR) {
        row_expect_word(r, "kappa", "-");
        row_expect_word(r, "T", "-");
        return;
    }
    answer_status(r, kappa, status);
    answer_status(r, direction, status);
    answer_real(kappa, k);
    answer_vec(direction, tangent, d);
    /* in floats the bound is that of the result */
    r->largest = fmaxl(r->largest, fabsl(exact_of(k)));
    row_expect(r, "kappa", kappa, l);
    row_expect(r, "T", direction, l);
}

static void curvature(row *r)
{
    loft_vec p[LOFT_DEGREE_MAX + 1], tangent = { { 0 } };
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), d = row_count(r, "d", LOFT_AXES);
    const loft_unit t = row_unit(r, "t_q16");
    loft_bezier b = { p, (uint8_t)n };
    loft_real k = 0;

    row_points(r, "P_q16", n + 1, d, p);
    if (loft_bezier_init(&b, p, n) != LOFT_OK)
        row_complain(r, "the curve was refused");
    const enum loft_status status = d == 2 ? loft_bezier_curvature_vec(&b, t, &k, &tangent)
                                           : loft_bezier_curvature(&b, t, &k, &tangent);
    const exact_bend own = exact_bend_at(&b, (int64_t)(exact_unit(t) * 65536),
                                         d == 2 ? 2 : LOFT_AXES);

    if (as_given(r))
        expect_curvature(r, status, k, tangent, d);
    if (own.singular != (status == LOFT_SINGULAR))
        row_complain(r, "singular: %d, but not of the coordinates as read",
                     status == LOFT_SINGULAR);
    if (status == LOFT_OK && !own.singular)
        expect_bend(r, &own, k, tangent, d);
}

static void polygon_convex(row *r)
{
    loft_vec p[64];
    const unsigned n = row_count(r, "n", 63);
    enum loft_convexity c = LOFT_COLLINEAR;

    row_points(r, "P_q16", n + 1, 2, p);
    if (loft_polygon_convex(p, n + 1, &c) != LOFT_OK)
        row_complain(r, "refused");
    if (as_given(r))
        row_expect_word(r, "convex", c == LOFT_CONVEX ? "1" : c == LOFT_NOT_CONVEX ? "0" : "-1");
    if (c != exact_convexity(p, n + 1))
        row_complain(r, "%d, but the coordinates as read make %d", c, exact_convexity(p, n + 1));
}

static void positivity1d(row *r)
{
    loft_real a[3];
    loft_sign s = { false, false, 0, 0 };
    answer *least = answer_new();
    char raises[8];

    row_reals(r, "a_q16", 3, a);
    if (loft_quadratic_sign(a, &s) != LOFT_OK)
        row_complain(r, "refused");
    const exact_sign own = exact_sign_of(a);
    if (s.nonnegative != own.nonnegative || s.positive != own.positive ||
        s.elevations != own.elevations)
        row_complain(r, "%d %d %d, but the coordinates as read make %d %d %d", s.nonnegative,
                     s.positive, s.elevations, own.nonnegative, own.positive, own.elevations);
    row_within(r, "min, as read", fabsl(exact_of(s.min) - own.min) * 65536, ulp(own.min) * 65536);
    if (!as_given(r))
        return;
    row_expect_flag(r, "nonneg", s.nonnegative);
    row_expect_flag(r, "positive", s.positive);
    snprintf(raises, sizeof raises, "%d", s.elevations);
    row_expect_word(r, "rpos", raises);
    answer_real(least, s.min);
    row_expect(r, "min", least, (law) { .lsb = 0.5L + 1 / 65536.0L, .roundings = 1 });
}

static void convex1d(row *r)
{
    loft_real b[5];
    const unsigned n = row_count(r, "n", 4);
    bool net = false, polynomial = false;

    row_reals(r, "b_q16", n + 1, b);
    if (loft_bernstein_convex(b, n, &net, &polynomial) != LOFT_OK)
        row_complain(r, "refused");
    if (as_given(r)) {
        row_expect_flag(r, "net", net);
        row_expect_flag(r, "poly", polynomial);
    }
    if (net != exact_net_convex(b, n) || polynomial != exact_convex(b, n))
        row_complain(r, "%d %d, but the coordinates as read make %d %d", net, polynomial,
                     exact_net_convex(b, n), exact_convex(b, n));
}

static void expect_value(row *r, const char *column, enum loft_status status, loft_real y, law l)
{
    answer *a = answer_new();

    answer_status(r, a, status);
    answer_real(a, y);
    row_expect(r, column, a, l);
}

static void bernstein_op(row *r)
{
    loft_real f[LOFT_DEGREE_MAX + 1], y = 0;
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX),
                   times = row_count(r, "k", UINT32_MAX - 1);
    const loft_unit x = row_unit(r, "x_q16");
    const long double sampling = n < 2 ? 0 : powl(n, 4) / (4 * n - 4),
                      gain = powl(growth(exact_unit(x)), n);

    row_reals(r, "f_q16", n + 1, f);
    enum loft_status status = loft_bernstein_iterate(f, n, times, x, &y);
    expect_value(r, "value", status, y,
                 (law){ .lsb = 0.5L + (growth_sum(exact_unit(x), n) + gain * sampling) / 131072,
                        .gain = gain,
                        .roundings = 4 * (n + sampling) });
    status = loft_bernstein_iterate(f, n, LOFT_FOREVER, x, &y);
    expect_value(
        r, "lim", status, y,
        (law){ .lsb = 0.5L + 1 / 131072.0L, .gain = growth(exact_unit(x)), .roundings = 3 });
}

const vector_system vectors_shape[] = { { "cubic_shape", "P_q16,type,ninfl,infl,cusp,loop",
                                          cubic_shape, "kinds and counts exact, parameters 2^-25" },
                                        { "curvature", "n,d,P_q16,t_q16,status,kappa,T", curvature,
                                          "status exact, 1/2 LSB + 2^-16 LSB, floats 1 ulp" },
                                        { "polygon_convex", "n,P_q16,convex", polygon_convex,
                                          "exact" },
                                        { "positivity1d", "a_q16,nonneg,positive,min,rpos",
                                          positivity1d, "flags exact, minimum 1/2 LSB" },
                                        { "convex1d", "n,b_q16,net,poly", convex1d, "exact" },
                                        { "bernstein_op", "n,f_q16,k,x_q16,value,lim", bernstein_op,
                                          "1/2 LSB + (n + n^4 / (4 n - 4)) * 2^-17 LSB, any k" },
                                        { NULL, NULL, NULL, NULL } };

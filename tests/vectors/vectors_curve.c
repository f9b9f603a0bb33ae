/* tests/vectors/vectors_curve.c -- readers of the curve systems
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors_points.h"         /* row, law, expect_vec */
#include "basis/bernstein.h"
#include "basis/differences.h"
#include "curve/bezier.h"
#include "curve/forward.h"

#define POINTS (LOFT_DEGREE_MAX + 1)

/* The law of extrapolation for degree n at t, in each number type; `gain` is what else multiplies
 * an error. */
static law extrapolation(unsigned n, loft_unit t, long double gain)
{
    const long double x = exact_unit(t);
    return (law){ .lsb = 0.5L + gain * growth_sum(x, n) / 131072,
                  .gain      = gain * powl(growth(x), n),
                  .roundings = 3 * n };
}

static bool inside(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

static unsigned degree(row *r)      { return row_count(r, "n", LOFT_DEGREE_MAX); }

static loft_bezier curve(row *r, unsigned n, unsigned d, loft_vec p[])
{
    loft_bezier b = { p, (uint8_t)n };

    row_points(r, "P_q16", n + 1, d, p);
    if (loft_bezier_init(&b, p, n) != LOFT_OK)
        row_complain(r, "the curve was refused");
    return b;
}

static loft_cubic cubic_of(const loft_vec p[])
{
    const loft_cubic c = { { p[0], p[1], p[2], p[3] } };
    return c;
}

/* All roads that lead to the point: extend, and between 0 and 1 eval, for a cubic its own. */
static void expect_point(row *r, const loft_bezier *b, unsigned d, loft_unit t, law l)
{
    loft_vec v = { { 0 } };

    const enum loft_status status = loft_bezier_extrapolate(b, t, &v);
    expect_vec(r, "point", status, v, d, l);
    if (!inside(t))
        return;
    expect_vec(r, "point", LOFT_OK, loft_bezier_eval(b, t), d, l);
    if (b->degree == 3) {
        const loft_cubic c = cubic_of(b->p);
        law own = l;
        own.lsb += 1 / 32768.0L;
        own.roundings = 16;
        expect_vec(r, "point", LOFT_OK, loft_cubic_eval(&c, t), d, own);
    }
}

static void bezier_eval(row *r)
{
    loft_vec p[POINTS];
    const unsigned n = degree(r), d = dimension(r);
    const loft_bezier b = curve(r, n, d, p);
    const loft_unit t = row_unit(r, "t_q16");

    expect_point(r, &b, d, t, extrapolation(n, t, 1));
}

/* The parameter is finer than loft_unit (f64: not) and is rounded once, by at most 2^-25: the point
 * moves by that times the largest derivative, n times the longest edge. */
static void bezier_eval_q30(row *r)
{
    loft_vec p[POINTS];
    const unsigned n = degree(r), d = dimension(r);
    const loft_bezier b = curve(r, n, d, p);
    const loft_unit t = row_unit_q30(r, "t_q30");
    law l = extrapolation(n, t, 1);
    long double edge = 0;

    for (unsigned k = 0; k < n; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            edge = fmaxl(edge, fabsl(exact_of(p[k+1].axis[i]) - exact_of(p[k].axis[i])));
    const long double moved = BY_NUM(n, n, 0) * edge / 33554432;
    l.lsb += moved * 65536;
    r->inexact += moved;
    expect_point(r, &b, d, t, l);
}

static void bezier_original(row *r)
{
    loft_vec a[POINTS], v = { { 0 } };
    const unsigned n = degree(r), d = dimension(r);
    const loft_unit t = row_unit(r, "t_q16");
    law l = extrapolation(n, t, 1);

    row_points(r, "a_q16", n + 1, d, a);
    const enum loft_status status = loft_bezier_from_edges(a, n, t, &v);
    l.gain *= n + 1;
    l.roundings += n;
    expect_vec(r, "point", status, v, d, l);
}

static void bezier_split(row *r)
{
    loft_vec p[POINTS], left[POINTS], right[POINTS];
    const unsigned n = degree(r), d = dimension(r);
    const loft_bezier b = curve(r, n, d, p);
    const loft_unit t = row_unit(r, "t_q16");
    const law l = extrapolation(n, t, 1);

    const enum loft_status status = loft_bezier_split(&b, t, left, right);
    expect_vecs(r, "L", status, left, n + 1, d, l);
    expect_vecs(r, "R", status, right, n + 1, d, l);
    if (n == 3 && inside(t)) {
        const loft_cubic c = cubic_of(p);
        loft_cubic one, two;
        loft_cubic_split(&c, t, &one, &two);
        expect_vecs(r, "L", LOFT_OK, one.p, 4, d, l);
        expect_vecs(r, "R", LOFT_OK, two.p, 4, d, l);
    }
}

static void bezier_segment(row *r)
{
    loft_vec p[POINTS], out[POINTS];
    const unsigned n = degree(r), d = dimension(r);
    const loft_bezier b = curve(r, n, d, p);
    const loft_unit from = row_unit(r, "a_q16"), to = row_unit(r, "b_q16");
    const law l = extrapolation(n, growth(exact_unit(from)) > growth(exact_unit(to)) ? from : to,
                                1);

    const enum loft_status status = loft_bezier_sub(&b, from, to, out);
    expect_vecs(r, "Q", status, out, n + 1, d, l);
    if (n == 3 && inside(from) && inside(to)) {
        const loft_cubic c = cubic_of(p), piece = loft_cubic_sub(&c, from, to);
        expect_vecs(r, "Q", LOFT_OK, piece.p, 4, d, l);
    }
}

static void bezier_elevate(row *r)
{
    loft_vec p[POINTS], out[LOFT_BEZIER_ELEVATE_MAX + 1];
    const unsigned n = degree(r), d = dimension(r),
                   times = row_count(r, "r", LOFT_BEZIER_ELEVATE_MAX - n);
    const loft_bezier b = curve(r, n, d, p);

    const enum loft_status status = loft_bezier_elevate(&b, times, out);
    expect_vecs(r, "Q", status, out, n + times + 1, d,
                (law){ .lsb = 0.5L + 1 / 131072.0L, .roundings = n + 3 });
}

static void bezier_deriv(row *r)
{
    loft_vec p[POINTS], v = { { 0 } };
    const unsigned n = degree(r), d = dimension(r), k = row_count(r, "k", UINT16_MAX),
                   m = k > n ? 0 : n - k;
    const loft_bezier b = curve(r, n, d, p);
    const loft_unit t = row_unit(r, "t_q16");
    long double factor = 1;

    for (unsigned j = m + 1; j <= n; j++)
        factor *= j;
    law l = extrapolation(m, t, factor);
    l.gain *= powl(2, n - m);
    l.roundings = 3 * m + (n - m) + 1;
    const enum loft_status status = loft_bezier_deriv(&b, k, t, &v);
    expect_vec(r, "D", status, v, d, l);
}

static void bernstein1d(row *r)
{
    const unsigned n = degree(r);
    const loft_unit t = row_unit(r, "t_q16");
    loft_acc w[POINTS];
    answer *a = answer_new();

    loft_bernstein_weights(n, t, w);
    for (unsigned k = 0; k <= n; k++)
        answer_wide(a, w[k]);
    r->largest = 1;
    const law l = extrapolation(n, t, 1);
    row_expect(r, "basis", a,
               (law){ .lsb = 2 * (l.lsb - 0.5L), .gain = l.gain, .roundings = 3 * n });
}

static void power_bernstein(row *r)
{
    const unsigned n = degree(r);
    const bool back = row_is(r, "dir", "b2p");
    loft_real in[POINTS];
    loft_acc c[POINTS];
    answer *a = answer_new();

    if (!back && !row_is(r, "dir", "p2b"))
        row_complain(r, "column dir: neither p2b nor b2p");
    row_reals(r, "in_q16", n + 1, in);
    for (unsigned k = 0; k <= n; k++)
        c[k] = loft_to_acc(in[k]);
    if (back)
        loft_bernstein_to_power(c, n);
    else
        loft_bernstein_from_power(c, n);
    for (unsigned k = 0; k <= n; k++)
        answer_acc(a, c[k]);
    const long double gain = back ? powl(2, n) * loft_binomial(n, n / 2) : n + 1;
    row_expect(r, "out", a,
               (law){ .lsb = back ? 0 : 0.5L + n / 131072.0L, .gain = gain, .roundings = n + 2 });
}

static void horner(row *r)
{
    const unsigned n = degree(r);
    loft_real c[POINTS], value = 0, deriv = 0;
    answer *v = answer_new(), *d = answer_new();

    row_reals(r, "c_q16", n + 1, c);
    const enum loft_status status = loft_power_eval(c, n, row_unit(r, "x_q16"), &value, &deriv);
    answer_status(r, v, status);
    answer_status(r, d, status);
    answer_real(v, value);
    answer_real(d, deriv);
    const long double two = powl(2, n);
    row_expect(r, "value", v,
               (law){ .lsb = 0.5L + (two - 1) / 131072, .gain = 2 * two, .roundings = n });
    row_expect(r, "deriv", d,
               (law){ .lsb = 0.5L + n * two / 262144, .gain = n * two + 1, .roundings = n + 1 });
}


/* fwd_diff: coefficients, their differences, and the values at j / N from every walk that takes the
 * row */

typedef struct {
    unsigned n, steps;
    loft_real a[POINTS];
} walked;

static void copy_wide(const walked *w, loft_acc c[])
{
    for (unsigned k = 0; k <= w->n; k++)
        c[k] = loft_to_acc(w->a[k]);
}

static void expect_differences(row *r, const walked *w)
{
    answer *a = answer_new();
    loft_acc c[POINTS];

    copy_wide(w, c);
    loft_bernstein_differences(c, w->n);
    for (unsigned k = 0; k <= w->n; k++)
        answer_acc(a, c[k]);
    row_expect(r, "diffs", a, (law) { .lsb = 0, .gain = powl(2, w->n), .roundings = w->n });
}

static void expect_step_differences(row *r, const walked *w)
{
    answer *a = answer_new();
    loft_real e[POINTS];
    const long double t = fmaxl((long double)w->n / w->steps, 1), power = powl(2, w->n);

    a->refused = loft_bernstein_forward_differences(w->a, w->n, w->steps, e) != LOFT_OK;
    for (unsigned k = 0; k <= w->n && !a->refused; k++)
        answer_real(a, e[k]);
    row_expect(
        r, "e", a,
        (law){ .lsb = 0.5L + 1 / 65536.0L, .gain = power * powl(growth(t), w->n), .roundings = 2 });
}

/* Walk in axis 0; in strict steps or plain ones. False when the walk does not take the row. */
static bool expect_walk(row *r, const walked *w, bool strict, law l)
{
    loft_vec p[POINTS] = { { { 0 } } }, v;
    loft_bezier b;
    loft_forward plain;
    loft_forward_exact exact;
    answer *a = answer_new();

    for (unsigned k = 0; k <= w->n; k++)
        p[k].axis[0] = w->a[k];
    if (w->n > LOFT_FORWARD_DEGREE_MAX || loft_bezier_init(&b, p, w->n) != LOFT_OK ||
        (strict ? loft_forward_exact_init(&exact, &b, w->steps)
                : loft_forward_init(&plain, &b, w->steps)) != LOFT_OK)
        return false;
    answer_real(a, w->a[0]);
    while (strict ? loft_forward_exact_next(&exact, &v) : loft_forward_next(&plain, &v))
        answer_real(a, v.axis[0]);
    row_expect(r, "values", a, l);
    return true;
}

static void expect_samples(row *r, const walked *w)
{
    answer *a = answer_new();

    for (unsigned j = 0; j <= w->steps; j++) {
        loft_acc c[POINTS];
        copy_wide(w, c);
        answer_acc(a, loft_bernstein_at(c, w->n, j, w->steps));
    }
    row_expect(r, "values", a, (law) { .lsb = 0.5L + w->n / 131072.0L, .roundings = 4 * w->n });
}

static void fwd_diff(row *r)
{
    const long double per_step[] = { 0, 1, 3, 8, 21, 55 };
    walked w = { degree(r), row_count(r, "N", LIST_MAX - 1), { 0 } };

    row_reals(r, "a_q16", w.n + 1, w.a);
    if (w.steps == 0) {
        row_complain(r, "column N: no steps");
        return;
    }
    expect_differences(r, &w);
    expect_step_differences(r, &w);

    long double binomials = 0, c = 1;
    for (unsigned i = 1; i <= w.n && i <= w.steps; i++)
        binomials += c *= (long double)(w.steps - i + 1) / i;
    const bool dyadic = (w.steps & (w.steps - 1)) == 0 && powl(w.steps, w.n) <= 4294967296.0L;
    law l = { .lsb = 0.5L, .roundings = w.n > 5 ? 0 : per_step[w.n] * w.steps + 8 * powl(3, w.n) };
    const bool strict = expect_walk(r, &w, true, l);
    if (!dyadic)
        l.lsb += binomials / 8589934592.0L;
    const bool plain = expect_walk(r, &w, false, l);
    if (!strict && !plain)
        expect_samples(r, &w);
}

const vector_system vectors_curve[] = {
    { "bezier_eval", "n,d,P_q16,t_q16,point", bezier_eval,
      "1/2 LSB + (1 + L + .. + L^(n-1)) / 2^17 LSB, L = |1-t| + |t|; f32, f64: 3 n L^n roundings "
      "of double + 1/2 ulp" },
    { "bezier_eval_q30", "n,d,P_q16,t_q30,point", bezier_eval_q30,
      "as bezier_eval, and max|P'| / 2^25 for the parameter, rounded once to 2^-24 (f64: holds "
      "it)" },
    { "bezier_original", "n,d,a_q16,t_q16,point", bezier_original,
      "as bezier_eval; f32, f64: of the largest sum" },
    { "bezier_split", "n,d,P_q16,t_q16,L,R", bezier_split, "as bezier_eval, per control point" },
    { "bezier_segment", "n,d,P_q16,a_q16,b_q16,Q", bezier_segment,
      "as bezier_eval, per control point" },
    { "bezier_elevate", "n,d,r,P_q16,Q", bezier_elevate,
      "1/2 LSB + 1 / 2^17 LSB; f32, f64: n + 3 roundings of double + 1/2 ulp" },
    { "bezier_deriv", "n,d,k,P_q16,t_q16,D", bezier_deriv,
      "1/2 LSB + n!/(n-k)! (1 + L + .. + L^(n-k-1)) / 2^17 LSB; f32, f64: n!/(n-k)! 2^k L^(n-k) "
      "(3n-2k+1) roundings" },
    { "bernstein1d", "n,t_q16,basis", bernstein1d,
      "n / 2^16 LSB; f32, f64: 3 n roundings of double" },
    { "power_bernstein", "n,dir,in_q16,out", power_bernstein,
      "p2b 1/2 LSB + n / 2^17 LSB, b2p none; f32, f64: n + 2 roundings of double of the terms + "
      "1/2 ulp" },
    { "horner", "n,c_q16,x_q16,value,deriv", horner,
      "value 1/2 LSB + (2^n - 1) / 2^17 LSB, deriv 1/2 LSB + n 2^(n-1) / 2^17 LSB" },
    { "fwd_diff", "n,a_q16,N,diffs,e,values", fwd_diff,
      "diffs none; values 1/2 LSB, in guarded steps (any N) + (C(N,1) + .. + C(N,n)) / 2^33 LSB; "
      "degree 6..9 + n / 2^17 LSB" },
    { 0 }
};

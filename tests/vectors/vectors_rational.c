/* tests/vectors/vectors_rational.c -- readers of the rational curves and of the arcs of the unit
 * circle
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors.h"                /* row, answer, law */
#include "curve/circle.h"
#include "curve/rational.h"

#define POINTS (LOFT_DEGREE_MAX + 1)

typedef struct {
    unsigned n, d;
    loft_weighted p[POINTS];
    loft_rational curve;
    long double w[POINTS], ratio, heaviest, size;
} rational;

/* Weights are exact in every number type, so of `inexact` and `largest` only the coordinates
 * count. */
static rational rational_of(row *r)
{
    rational c = { .n = row_count(r, "n", LOFT_DEGREE_MAX), .d = row_count(r, "d", LOFT_AXES) };
    loft_vec p[POINTS];
    loft_real w[POINTS];
    long double lightest = 256;

    row_points(r, "P_q16", c.n + 1, c.d, p);
    c.size = r->largest;
    row_reals(r, "w_q16", c.n + 1, w);
    r->largest = c.size;
    for (unsigned k = 0; k <= c.n; k++) {
        c.p[k].p = p[k];
        c.p[k].w = w[k];
        c.w[k] = exact_of(w[k]);
        lightest = fminl(lightest, c.w[k]);
        c.heaviest = fmaxl(c.heaviest, c.w[k]);
    }
    c.ratio = c.heaviest / lightest;
    return c;
}

/* The curve refers to points in the same object, which must therefore stay where it is. */
static void init(row *r, rational *c)
{
    if (loft_rational_init(&c->curve, c->p, c->n) != LOFT_OK)
        row_complain(r, "the curve was refused");
}

static law point_law(const rational *c, unsigned rows)
{
    return (
        law){ .lsb = 0.5L + rows * c->ratio / 1073741824, .gain = 1, .roundings = 6 * rows + 4 };
}

/* K of rational.h */
static law extrapolated_law(const rational *c, loft_unit t)
{
    const long double x = exact_unit(t), l = fabsl(1 - x) + fabsl(x),
                      k = powl(l, c->n) * c->heaviest / exact_eval(c->w, c->n, x);

    return (law) { .lsb = 0.501L, .gain = k, .roundings = 4 * (c->n + 2) * k };
}

/* n w0 w1 / w^2 before the last step */
static long double slope(const rational *c, loft_unit t)
{
    const long double x = exact_unit(t), a = exact_eval(c->w, c->n - 1, x),
                      b = exact_eval(c->w + 1, c->n - 1, x);
    const long double w = (1 - x) * a + x * b;
    return c->n * a * b / (w * w);
}

static void expect_points(row *r, const char *column, const loft_weighted p[], unsigned count,
                          const rational *c, law l)
{
    answer *a = answer_new();

    for (unsigned k = 0; k < count; k++)
        answer_vec(a, p[k].p, c->d);
    row_expect(r, column, a, l);
}

static void expect_weights(row *r, const char *column, const loft_weighted p[], unsigned count,
                           const rational *c, unsigned rows)
{
    const long double inexact = r->inexact;
    answer *a = answer_new();

    for (unsigned k = 0; k < count; k++)
        answer_real(a, p[k].w);
    r->inexact = 0;
    r->largest = c->heaviest;
    row_expect(r, column, a, (law) { .lsb = 0.5L + rows / 131072.0L, .roundings = 4 * rows });
    r->inexact = inexact;
    r->largest = c->size;
}

static void rational_eval(row *r)
{
    rational c = rational_of(r);
    const loft_unit t = row_unit(r, "t_q16");
    loft_vec v = { { 0 } };
    answer *p = answer_new(), *dp = answer_new();

    init(r, &c);
    if (t >= 0 && t <= LOFT_UNIT(1)) {
        answer_vec(p, loft_rational_eval(&c.curve, t), c.d);
        row_expect(r, "p", p, point_law(&c, c.n));
    } else {
        answer_status(r, p, loft_rational_extrapolate(&c.curve, t, &v));
        answer_vec(p, v, c.d);
        row_expect(r, "p", p, extrapolated_law(&c, t));
    }
    answer_status(r, dp, loft_rational_deriv(&c.curve, t, &v));
    answer_vec(dp, v, c.d);
    row_expect(r, "dp", dp,
               (law){ .lsb = 0.501L, .gain = c.n ? 2 * slope(&c, t) : 1, .roundings = 12 * c.n });
}

static void rational_split(row *r)
{
    rational c = rational_of(r);
    loft_weighted left[POINTS], right[POINTS];

    init(r, &c);
    if (loft_rational_split(&c.curve, row_unit(r, "t_q16"), left, right) != LOFT_OK) {
        row_complain(r, "the split was refused");
        return;
    }
    expect_points(r, "L", left, c.n + 1, &c, point_law(&c, c.n));
    expect_points(r, "R", right, c.n + 1, &c, point_law(&c, c.n));
    expect_weights(r, "wL", left, c.n + 1, &c, c.n);
    expect_weights(r, "wR", right, c.n + 1, &c, c.n);
}

static void rational_elevate(row *r)
{
    rational c = rational_of(r);
    loft_weighted out[LOFT_ELEVATE_MAX + 1];

    init(r, &c);
    if (loft_rational_elevate(&c.curve, 1, out) != LOFT_OK) {
        row_complain(r, "raising was refused");
        return;
    }
    expect_points(r, "Q", out, c.n + 2, &c, point_law(&c, 1));
    expect_weights(r, "wQ", out, c.n + 2, &c, 1);
}

/* The arm is one of the types' numbers, or the one that touches the circle. */
static void arc_quarter(row *r)
{
    const bool touching = row_is(r, "lam_q16", "lambda0");
    const loft_acc arm = touching ? loft_circle_arm() : loft_to_acc(row_real(r, "lam_q16"));
    const long double l = fabsl(exact_acc(arm));
    loft_real p[2] = { 0, 0 }, excess = 0;
    answer *x = answer_new(), *y = answer_new(), *e = answer_new();

    const enum loft_status status = loft_circle_quarter(arm, row_unit(r, "t_q16"), p, &excess);
    answer_status(r, x, status);
    answer_status(r, y, status);
    answer_status(r, e, status);
    answer_real(x, p[0]);
    answer_real(y, p[1]);
    answer_real(e, excess);
    r->largest = 1 + l;
    const law point = { .lsb = 0.5L + 1 / 32768.0L, .gain = 1, .roundings = 8 };
    row_expect(r, "x", x, point);
    row_expect(r, "y", y, point);
    r->largest = 1 + l * l;
    row_expect(r, "eps", e,
               (law){ .lsb = 0.5L + (1 + l) / 4096, .gain = 2 * (1 + l), .roundings = 16 });
}

static void arc_rational(row *r)
{
    const loft_real theta = row_real(r, "theta_q16");
    const loft_unit t = row_unit(r, "t_q16");
    loft_real distance = 0, weight = 0, p[2] = { 0, 0 };
    answer *lambda = answer_new(), *omega = answer_new(), *x = answer_new(), *y = answer_new();

    const enum loft_status status = loft_circle_over(theta, &distance, &weight);
    answer_status(r, lambda, status);
    answer_status(r, omega, status);
    answer_status(r, x, loft_circle_over_eval(theta, t, p));
    answer_real(lambda, distance);
    answer_real(omega, weight);
    answer_real(x, p[0]);
    answer_real(y, p[1]);
    const long double square = exact_of(distance) * exact_of(distance);
    r->largest = 1;
    row_expect(r, "lambda", lambda,
               (law){ .lsb = 0.5L + square * 0x1p-40L, .gain = 1, .roundings = 4 * (1 + square) });
    row_expect(r, "omega", omega, (law) { .lsb = 0.5L + 1 / 65536.0L, .gain = 1, .roundings = 4 });
    row_expect(r, "x", x, (law) { .lsb = 0.5L + 1 / 65536.0L, .gain = 1, .roundings = 4 });
    row_expect(r, "y", y, (law) { .lsb = 0.5L + 1 / 65536.0L, .gain = 1, .roundings = 4 });
}

const vector_system vectors_rational[] = {
    { "rational_eval", "n,d,P_q16,w_q16,t_q16,p,dp", rational_eval,
      "q16 1/2 + n R 2^-30 LSB, p' 0.501 LSB; floats 1/2 ulp + (6 n + 4) ulp of double" },
    { "rational_split", "n,d,P_q16,w_q16,t_q16,L,wL,R,wR", rational_split,
      "q16 1/2 + n R 2^-30 LSB; floats 1/2 ulp + (6 n + 4) ulp of double" },
    { "rational_elevate", "n,d,P_q16,w_q16,Q,wQ", rational_elevate,
      "q16 1/2 + R 2^-30 LSB; floats 1/2 ulp + 10 ulp of double" },
    { "arc_quarter", "lam_q16,t_q16,x,y,eps", arc_quarter,
      "q16 1/2 LSB + 2^-15 LSB, eps 1/2 + (1 + lam) 2^-12 LSB; floats 1/2 ulp + 16 (1 + lam^2) ulp "
      "of double" },
    { "arc_rational", "theta_q16,t_q16,lambda,omega,x,y", arc_rational,
      "q16 1/2 LSB + 2^-16 LSB, lambda 1/2 + lambda^2 2^-40 LSB; floats 1/2 ulp + 4 (1 + lambda^2) "
      "ulp of double" },
    { 0 }
};

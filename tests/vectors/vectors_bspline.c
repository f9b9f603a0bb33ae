/* tests/vectors/vectors_bspline.c -- readers of B-spline and NURBS curves
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors.h"                /* row, answer, law */
#include "curve/bspline.h"
#include "curve/nurbs.h"

#define COUNT_MAX 100
#define POINTS    (LOFT_DEGREE_MAX + 1)

typedef struct {
    unsigned n, c, d;
    loft_real k[COUNT_MAX + POINTS];
    loft_vec p[COUNT_MAX];
} spline;

/* Numbers that are exact in every number type, and not coordinates. */
static void exact_reals(row *r, const char *column, unsigned count, loft_real out[])
{
    const long double largest = r->largest, inexact = r->inexact;

    r->inexact = 0;
    row_reals(r, column, count, out);
    if (r->inexact > 0)
        row_complain(r, "column %s: more than 24 bits", column);
    r->largest = largest;
    r->inexact = inexact;
}

static spline *spline_of(row *r)
{
    static spline s;

    s.n = row_count(r, "n", LOFT_DEGREE_MAX);
    s.c = row_count(r, "c", COUNT_MAX);
    s.d = row_count(r, "d", LOFT_AXES);
    exact_reals(r, "K_q16", s.c + s.n + 1, s.k);
    row_points(r, "P_q16", s.c, s.d, s.p);
    return &s;
}

static law point_law(unsigned n)
{
    return (law){ .lsb = 0.5L + n / 131072.0L, .gain = 1, .roundings = 5 * n };
}

static law slope_law(const loft_bspline *b, loft_real u)
{
    const unsigned n = b->knots.degree, span = loft_knots_find(&b->knots, u);
    const long double h = exact_of(b->knots.k[span + 1]) - exact_of(b->knots.k[span]);

    return (law){ .lsb = 0.5L + (1 + (2 * n + 1) * n / h) / 131072,
                  .gain = fmaxl(2 * n / h, 1),
                  .roundings = 6 * n };
}

static void bspline_eval(row *r)
{
    const spline *s = spline_of(r);
    loft_bspline b;
    loft_real u;
    loft_vec v = { { 0 } };
    answer *p = answer_new(), *dp = answer_new();

    exact_reals(r, "u_q16", 1, &u);
    if (loft_bspline_init(&b, s->p, s->c, s->k, s->n) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    answer_vec(p, loft_bspline_eval(&b, u), s->d);
    row_expect(r, "p", p, point_law(s->n));
    answer_status(r, dp, loft_bspline_deriv(&b, 1, u, &v));
    answer_vec(dp, v, s->d);
    row_expect(r, "dp", dp, slope_law(&b, u));
}

static void bspline_bezier(row *r)
{
    const spline *s = spline_of(r);
    const unsigned m = row_count(r, "m", COUNT_MAX);
    loft_bspline b;
    loft_vec out[POINTS];
    unsigned count = 0;
    answer *a = answer_new();

    if (loft_bspline_init(&b, s->p, s->c, s->k, s->n) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    for (unsigned span = 0; loft_bspline_next(&b, &span, out); count++)
        for (unsigned k = 0; k <= s->n; k++)
            answer_vec(a, out[k], s->d);
    if (count != m)
        row_complain(r, "%u spans, %u were expected", count, m);
    row_expect(r, "B", a, point_law(s->n));
}

static void nurbs_point(row *r)
{
    const spline *s = spline_of(r);
    loft_real w[COUNT_MAX], u;
    loft_weighted p[COUNT_MAX];
    long double least = 256, most = 0;
    loft_nurbs n;
    answer *a = answer_new();

    exact_reals(r, "w_q16", s->c, w);
    exact_reals(r, "u_q16", 1, &u);
    for (unsigned k = 0; k < s->c; k++) {
        p[k] = (loft_weighted) { s->p[k], w[k] };
        least = fminl(least, exact_of(w[k]));
        most = fmaxl(most, exact_of(w[k]));
    }
    if (loft_nurbs_init(&n, p, s->c, s->k, s->n) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    answer_vec(a, loft_nurbs_eval(&n, u), s->d);
    row_expect(r, "p", a,
               (law){ .lsb = 0.5L + s->n * most / least / 1073741824,
                      .gain = 1,
                      .roundings = 10 * s->n + 4 });
}

const vector_system vectors_bspline[] = {
    { "bspline_eval", "n,c,d,K_q16,P_q16,u_q16,p,dp", bspline_eval,
      "q16 1/2 + n 2^-17 LSB, p' 1/2 + n (n-1) / h 2^-16 LSB; floats 1/2 ulp + 5 n ulp of double, "
      "p' 12 n^2 / h" },
    { "bspline_bezier", "n,c,d,K_q16,P_q16,m,B", bspline_bezier,
      "q16 1/2 + n 2^-17 LSB; floats 1/2 ulp + 5 n ulp of double" },
    { "nurbs_point", "n,c,d,K_q16,P_q16,w_q16,u_q16,p", nurbs_point,
      "q16 1/2 + n R 2^-30 LSB; floats 1/2 ulp + (10 n + 4) ulp of double" },
    { 0 }
};

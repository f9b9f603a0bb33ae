/* host-tools/piece.c -- a Bezier piece: derivatives, curvature, cubics within a tolerance
 * SPDX-License-Identifier: MIT
 *
 * Cubics: C has the ends of the piece P and its derivatives there. With numerator N = sum B_i w_i p_i and denominator
 * W = sum B_i w_i of degree n
 *
 *     P - C = (N - W C) / W,     N - W C = sum_k B_k^{n+3} e_k,     e_k = sum_i C(n,i) C(3,k-i) / C(n+3,k) w_i (p_i - c_{k-i})
 *
 * so |P - C| <= max |e_k| / min w everywhere, by the hull property. Halving divides that by 16: a piece that is not
 * near enough is halved. A bound, not an estimate; for polynomials to degree 3 it is 0.
 */
#include <math.h>
#include <string.h>

#include "piece.h"

#define WIDE       (CURVE_AXES + 1)
#define LEVELS_MAX 20

typedef struct {
    double b[CURVE_DEGREE_MAX + 1][WIDE];       /* homogeneous, the weight last */
    unsigned degree;
} lifted;

static lifted lift(const piece *c)
{
    lifted l = { .degree = c->degree };

    for (unsigned k = 0; k <= c->degree; k++) {
        for (int i = 0; i < CURVE_AXES; i++)
            l.b[k][i] = c->w[k] * c->p[k][i];
        l.b[k][CURVE_AXES] = c->w[k];
    }
    return l;
}

/* de Casteljau; `left` and `right` may be NULL. */
static void split(const lifted *l, double t, lifted *left, lifted *right)
{
    lifted work = *l;

    if (left != NULL)
        *left = *l;
    for (unsigned row = l->degree; row > 0; row--) {
        for (unsigned k = 0; k < row; k++)
            for (int i = 0; i < WIDE; i++)
                work.b[k][i] += t * (work.b[k + 1][i] - work.b[k][i]);
        if (left != NULL)
            memcpy(left->b[l->degree - row + 1], work.b[0], sizeof work.b[0]);
    }
    if (right != NULL)
        *right = work;
}

/* Point and derivatives at the start: P = N / W, P' = (N' - W' P) / W, P'' = (N'' - 2 W' P' - W'' P) / W. */
static void at_start(const lifted *l, double out[3][CURVE_AXES])
{
    const double n = l->degree, m = n * (n - 1);
    const double *b0 = l->b[0], *b1 = l->b[n > 0 ? 1 : 0], *b2 = l->b[n > 1 ? 2 : 0];
    const double w = b0[CURVE_AXES], dw = n * (b1[CURVE_AXES] - w), ddw = m * (b2[CURVE_AXES] - 2 * b1[CURVE_AXES] + w);

    for (int i = 0; i < CURVE_AXES; i++) {
        out[0][i] = b0[i] / w;
        out[1][i] = (n * (b1[i] - b0[i]) - dw * out[0][i]) / w;
        out[2][i] = (m * (b2[i] - 2 * b1[i] + b0[i]) - 2 * dw * out[1][i] - ddw * out[0][i]) / w;
    }
}

static void at_end(const lifted *l, double out[3][CURVE_AXES])
{
    lifted back = { .degree = l->degree };

    for (unsigned k = 0; k <= l->degree; k++)
        memcpy(back.b[k], l->b[l->degree - k], sizeof back.b[k]);
    at_start(&back, out);
    for (int i = 0; i < CURVE_AXES; i++)
        out[1][i] = -out[1][i];
}

bool piece_is_rational(const piece *c)
{
    for (unsigned k = 1; k <= c->degree; k++)
        if (c->w[k] < c->w[0] || c->w[k] > c->w[0])
            return true;
    return false;
}

void piece_eval(const piece *c, double t, double out[3][CURVE_AXES])
{
    const lifted l = lift(c);
    lifted part;

    if (t <= 0.5) {
        split(&l, t, NULL, &part);      /* its derivatives are those by t, times 1 - t */
        at_start(&part, out);
    } else {
        split(&l, t, &part, NULL);
        at_end(&part, out);
    }
    const double share = t <= 0.5 ? 1 - t : t;
    for (int i = 0; i < CURVE_AXES; i++) {
        out[1][i] /= share;
        out[2][i] /= share * share;
    }
}

bool piece_bend(const piece *c, double t, double *out)
{
    double d[3][CURVE_AXES];

    piece_eval(c, t, d);
    const double speed = hypot(d[1][0], d[1][1]);
    *out = (d[1][0] * d[2][1] - d[1][1] * d[2][0]) / (speed * speed * speed);
    return speed > 0 && isfinite(*out);
}


// Cubics
// ------

static double binomial(unsigned n, unsigned k)
{
    double c = 1;

    for (unsigned i = 1; i <= k; i++)
        c = c * (n - k + i) / i;
    return c;
}

static double deviation(const lifted *l, double c[4][CURVE_AXES])
{
    const unsigned n = l->degree;
    double worst = 0, least = l->b[0][CURVE_AXES];

    for (unsigned k = 0; k <= n + 3; k++) {
        double e[CURVE_AXES] = { 0 };
        for (unsigned i = k > 3 ? k - 3 : 0; i <= n && i <= k; i++)
            for (int a = 0; a < CURVE_AXES; a++)
                e[a] += binomial(n, i) * binomial(3, k - i) * (l->b[i][a] - l->b[i][CURVE_AXES] * c[k - i][a]);
        worst = fmax(worst, hypot(hypot(e[0], e[1]), e[2]) / binomial(n + 3, k));
    }
    for (unsigned k = 1; k <= n; k++)
        least = fmin(least, l->b[k][CURVE_AXES]);
    return worst / least;
}

static void cubic_of(const lifted *l, double c[4][CURVE_AXES])
{
    double a[3][CURVE_AXES], z[3][CURVE_AXES];

    at_start(l, a);
    at_end(l, z);
    for (int i = 0; i < CURVE_AXES; i++) {
        c[0][i] = a[0][i];
        c[1][i] = a[0][i] + a[1][i] / 3;
        c[2][i] = z[0][i] - z[1][i] / 3;
        c[3][i] = z[0][i];
    }
}

static bool cut(const lifted *l, double tol, int levels, piece_cubic_sink *sink, void *context)
{
    double c[4][CURVE_AXES];
    lifted left, right;

    cubic_of(l, c);
    if (deviation(l, c) <= tol) {
        sink(context, c);
        return true;
    }
    if (levels == 0)
        return false;
    split(l, 0.5, &left, &right);
    return cut(&left, tol, levels - 1, sink, context) && cut(&right, tol, levels - 1, sink, context);
}

bool piece_cubics(const piece *c, double tol, piece_cubic_sink *sink, void *context)
{
    const lifted l = lift(c);
    double p[4][CURVE_AXES];

    if (piece_is_rational(c) || c->degree < 1 || c->degree > 3)
        return cut(&l, tol, LEVELS_MAX, sink, context);
    for (int i = 0; i < CURVE_AXES; i++) {
        const double a = c->p[0][i], b = c->p[1][i], z = c->p[c->degree][i];
        p[0][i] = a;
        p[1][i] = c->degree == 3 ? b : c->degree == 2 ? (a + 2 * b) / 3 : (2 * a + z) / 3;
        p[2][i] = c->degree == 3 ? c->p[2][i] : c->degree == 2 ? (2 * b + z) / 3 : (a + 2 * z) / 3;
        p[3][i] = z;
    }
    sink(context, p);
    return true;
}

/* host-tools/geometry/drawn.c
 * SPDX-License-Identifier: MIT
 *
 * Above degree 9, with P = N / W of degree n (W = 1 without weights), the cubic q has the ends of P
 * and its derivatives there. W (P - q) = N - W q is a polynomial of degree n + 3 with the Bernstein
 * coefficients
 *
 *     e_j = sum over i + k = j of C(n, i) C(3, k) / C(n + 3, j) (N_i - W_i q_k)
 *
 * so |P - q| <= max |e_j| / min W_i at equal parameters. A piece that exceeds the tolerance is
 * halved; the bound falls with the fourth power of the width.
 */
#include <math.h>

#include "num/status.h"         /* LOFT_OK */

#include "geometry/drawn.h"

#define HALVINGS 30

int drawn_pieces(const curve *c, drawn_sink *take, void *context)
{
    const engine_curves *make = engine_f64.curve;
    engine_curve *held;
    piece p = { .degree = c->degree };
    int status;

    if (curve_is_high(c)) {
        for (unsigned k = 0; k <= c->degree; k++) {
            for (int i = 0; i < CURVE_AXES; i++)
                p.p[k][i] = c->point[k].p[i];
            p.w[k] = c->point[k].w;
        }
        take(context, &p, true);
        return LOFT_OK;
    }
    status = make->open(c, &held);
    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i < make->pieces(held) && status == LOFT_OK; i++) {
        status = make->piece(held, i, &p);
        if (status == LOFT_OK)
            take(context, &p, i == 0);
    }
    make->close(held);
    return status;
}


// Cubics
// ------

static void cubic_of(const piece *p, double q[4][CURVE_AXES])
{
    double end[2][3][CURVE_AXES];

    piece_eval(p, 0, end[0]);
    piece_eval(p, 1, end[1]);
    for (int i = 0; i < CURVE_AXES; i++) {
        q[0][i] = end[0][0][i];
        q[1][i] = end[0][0][i] + end[0][1][i] / 3;
        q[2][i] = end[1][0][i] - end[1][1][i] / 3;
        q[3][i] = end[1][0][i];
    }
}

static double choose(unsigned n, unsigned k)
{
    double c = 1;

    for (unsigned i = 1; i <= k; i++)
        c = c * (n - k + i) / i;
    return c;
}

/* The distance of the cubic from the piece is at most this. */
static double bound_of(const piece *p, double q[4][CURVE_AXES])
{
    const unsigned n = p->degree;
    double most = 0, least = p->w[0];

    for (unsigned j = 0; j <= n + 3; j++) {
        double e[CURVE_AXES] = { 0 }, sum = 0;
        for (unsigned k = j > n ? j - n : 0; k <= 3 && k <= j; k++) {
            const double part = choose(n, j - k) * choose(3, k) / choose(n + 3, j) * p->w[j - k];
            for (int i = 0; i < CURVE_AXES; i++)
                e[i] += part * (p->p[j - k][i] - q[k][i]);
        }
        for (int i = 0; i < CURVE_AXES; i++)
            sum += e[i] * e[i];
        most = fmax(most, sqrt(sum));
    }
    for (unsigned i = 1; i <= n; i++)
        least = fmin(least, p->w[i]);
    return most / least;
}

/* Halves of halves, in order: `left` counts halvings that are not used up. */
static int give_cubics(const piece *p, double tol, int left, engine_cubic_sink *sink, void *context)
{
    double q[4][CURVE_AXES];
    piece half[2];
    int status = LOFT_OK;

    cubic_of(p, q);
    if (bound_of(p, q) <= tol) {
        sink(context, q);
        return LOFT_OK;
    }
    if (left == 0)
        return LOFT_ERR_RANGE;
    piece_split(p, 0.5, &half[0], &half[1]);
    for (int k = 0; k < 2 && status == LOFT_OK; k++)
        status = give_cubics(&half[k], tol, left - 1, sink, context);
    return status;
}

int drawn_cubics(const piece *p, double tol, engine_cubic_sink *sink, void *context)
{
    return p->degree <= CURVE_DEGREE_MAX ? engine_f64.piece->cubics(p, tol, sink, context)
                                         : give_cubics(p, tol, HALVINGS, sink, context);
}

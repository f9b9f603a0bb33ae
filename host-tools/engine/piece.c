/* host-tools/engine/piece.c -- a Bezier piece: derivatives, curvature
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "engine/piece.h"

#define WIDE (CURVE_AXES + 1)

typedef struct {
    double b[CURVE_DRAWN_MAX + 1][WIDE];        /* homogeneous, the weight last */
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

/* Point and derivatives at the start: P = N / W, P' = (N' - W' P) / W, P'' = (N'' - 2 W' P' - W''
 * P) / W. */
static void at_start(const lifted *l, double out[3][CURVE_AXES])
{
    const double n = l->degree, m = n * (n - 1);
    const double *b0 = l->b[0], *b1 = l->b[n > 0 ? 1 : 0], *b2 = l->b[n > 1 ? 2 : 0];
    const double w = b0[CURVE_AXES], dw = n * (b1[CURVE_AXES] - w),
                 ddw = m * (b2[CURVE_AXES] - 2 * b1[CURVE_AXES] + w);

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

static void project(const lifted *l, piece *out)
{
    out->degree = l->degree;
    for (unsigned k = 0; k <= l->degree; k++) {
        out->w[k] = l->b[k][CURVE_AXES];
        for (int i = 0; i < CURVE_AXES; i++)
            out->p[k][i] = l->b[k][i] / out->w[k];
    }
}

void piece_split(const piece *c, double t, piece *left, piece *right)
{
    const lifted l = lift(c);
    lifted part[2];

    split(&l, t, &part[0], &part[1]);
    project(&part[0], left);
    project(&part[1], right);
}

bool piece_bend(const piece *c, double t, double *out)
{
    double d[3][CURVE_AXES];

    piece_eval(c, t, d);
    const double speed = hypot(d[1][0], d[1][1]);
    *out = (d[1][0] * d[2][1] - d[1][1] * d[2][0]) / (speed * speed * speed);
    return speed > 0 && isfinite(*out);
}

/* host-tools/engine_curve.c -- curves of every kind through the library; compiled once per number type
 * SPDX-License-Identifier: MIT
 *
 * A curve is opened: its points are rounded to the number type, what it needs is prepared. Each piece is then a Bezier
 * curve of the library, by the library's own conversion; points come from the function that evaluates that kind.
 */
#include <stdlib.h>

#include "curve/bezier.h"           /* loft_bezier */
#include "curve/forward.h"          /* loft_forward */
#include "curve/rational.h"         /* loft_rational */

#include "curve.h"
#include "engine_num.h"     /* real_of, vec_of, point_of */
#include "piece.h"
#include "tool.h"           /* tool_grow */

struct engine_curve {
    const curve *c;
    loft_vec *p;
    loft_real *w;
};

/* A piece in the number type. */
typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_weighted weighted[LOFT_DEGREE_MAX + 1];
    unsigned degree;
    bool rational;
} part;


// Open and close
// --------------

static void curve_close(engine_curve *e)
{
    free(e->p);
    free(e->w);
    free(e);
}

/* Points and weights in the number type. */
static int hold(engine_curve *e)
{
    const curve *c = e->c;

    e->p = tool_grow(NULL, c->count * sizeof *e->p);
    e->w = tool_grow(NULL, c->count * sizeof *e->w);
    for (unsigned i = 0; i < c->count; i++)
        if (!vec_of(c->point[i].p, &e->p[i]) || !real_of(c->point[i].w, &e->w[i]))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

static int prepare(engine_curve *e)
{
    const int status = hold(e);

    if (status != LOFT_OK)
        return status;
    switch (e->c->kind) {
    case CURVE_BEZIER: case CURVE_LINE: case CURVE_RATIONAL: return LOFT_OK;
    default:                                                 return LOFT_ERR_ARG;
    }
}

static int curve_open(const curve *c, engine_curve **out)
{
    engine_curve *e = tool_grow(NULL, sizeof *e);

    *e = (engine_curve){ .c = c };
    const int status = prepare(e);
    if (status != LOFT_OK)
        curve_close(e);
    else
        *out = e;
    return status;
}


// Pieces
// ------

static void take(const engine_curve *e, unsigned first, part *out)
{
    for (unsigned k = 0; k <= out->degree; k++) {
        out->p[k] = e->p[first + k];
        out->weighted[k] = (loft_weighted){ e->p[first + k], e->w[first + k] };
    }
}

static int part_of(const engine_curve *e, unsigned i, part *out)
{
    out->degree   = e->c->degree;
    out->rational = curve_is_rational(e->c);
    switch (e->c->kind) {
    case CURVE_BEZIER: case CURVE_RATIONAL: take(e, 0, out); return LOFT_OK;
    case CURVE_LINE:                        take(e, i, out); return LOFT_OK;
    default:                                return LOFT_ERR_ARG;
    }
}

static int curve_piece(engine_curve *e, unsigned i, piece *out)
{
    part s;
    const int status = part_of(e, i, &s);

    out->degree = e->c->degree;
    for (unsigned k = 0; status == LOFT_OK && k <= s.degree; k++) {
        point_of(s.rational ? s.weighted[k].p : s.p[k], out->p[k]);
        out->w[k] = s.rational ? double_of(s.weighted[k].w) : 1;
    }
    return status;
}


// Points
// ------

static int eval_bezier(const loft_vec p[], unsigned degree, double t, loft_vec *out)
{
    loft_bezier b;
    const int status = loft_bezier_init(&b, p, degree);

    if (status != LOFT_OK)
        return status;
    if (!(t >= 0 && t <= 1))
        return fabs(t) < 127 ? loft_bezier_extend(&b, LOFT_UNIT(t), out) : LOFT_ERR_RANGE;
    *out = loft_bezier_eval(&b, LOFT_UNIT(t));
    return LOFT_OK;
}

static int eval_rational(const loft_weighted p[], unsigned degree, double t, loft_vec *out)
{
    loft_rational r;
    const int status = loft_rational_init(&r, p, degree);

    if (status == LOFT_OK)
        *out = loft_rational_eval(&r, LOFT_UNIT(t));
    return status;
}

static int eval_part(const engine_curve *e, unsigned i, double t, loft_vec *out)
{
    part s;
    const int status = part_of(e, i, &s);

    if (status != LOFT_OK)
        return status;
    return s.rational ? eval_rational(s.weighted, s.degree, t, out) : eval_bezier(s.p, s.degree, t, out);
}

static int curve_eval(engine_curve *e, double t, double out[ENGINE_AXES])
{
    const bool inside = t >= curve_from(e->c) && t <= curve_to(e->c);
    long double local;
    loft_vec at;

    if (!inside && !curve_extends(e->c))
        return LOFT_ERR_ARG;
    const unsigned i = curve_locate(e->c, (long double)t, &local);
    const int status = eval_part(e, i, (double)local, &at);
    if (status == LOFT_OK)
        point_of(at, out);
    return status;
}


// Walks
// -----

static void give(engine_point_sink *sink, void *context, loft_vec at)
{
    double point[ENGINE_AXES];

    point_of(at, point);
    sink(context, point);
}

static int walk_bezier(const part *s, uint32_t n, engine_point_sink *sink, void *context)
{
    loft_bezier b;
    loft_forward w;
    loft_vec at;
    int status = loft_bezier_init(&b, s->p, s->degree);

    if (status == LOFT_OK)
        status = loft_forward_init(&w, &b, n);
    while (status == LOFT_OK && loft_forward_next(&w, &at))
        give(sink, context, at);
    return status;
}

/* Point by point, for what the library does not walk. */
static int step_through(const part *s, uint32_t n, engine_point_sink *sink, void *context)
{
    loft_rational r;
    loft_bezier b;
    int status = s->rational ? loft_rational_init(&r, s->weighted, s->degree) : loft_bezier_init(&b, s->p, s->degree);

    if (n == 0)
        status = LOFT_ERR_ARG;
    for (uint32_t j = 1; status == LOFT_OK && j != 0 && j <= n; j++)
        give(sink, context, s->rational ? loft_rational_eval(&r, loft_unit_of(j, n)) : loft_bezier_eval(&b, loft_unit_of(j, n)));
    return status;
}

static int curve_walk(engine_curve *e, unsigned i, uint32_t n, engine_point_sink *sink, void *context)
{
    part s;
    const int status = part_of(e, i, &s);

    if (status != LOFT_OK)
        return status;
    if (!s.rational && s.degree <= LOFT_FORWARD_DEGREE_MAX)
        return walk_bezier(&s, n, sink, context);
    return step_through(&s, n, sink, context);
}

const engine_curves ENGINE_OF(engine_curves) = {
    .open  = curve_open,
    .close = curve_close,
    .eval  = curve_eval,
    .piece = curve_piece,
    .walk  = curve_walk
};

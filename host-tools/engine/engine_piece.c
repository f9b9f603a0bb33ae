/* host-tools/engine/engine_piece.c -- Bezier pieces through the library: walks, cubics and shapes;
 * compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "curve/bezier.h"           /* loft_bezier */
#include "curve/bounds.h"           /* loft_bezier_bounds */
#include "curve/to_cubics.h"        /* loft_to_cubics */
#include "curve/forward.h"          /* loft_forward */
#include "curve/rational.h"         /* loft_rational */
#include "curve/rational_walk.h"    /* loft_rational_walk */
#include "curve/shape.h"            /* loft_cubic_shape */
#include "curve/tangent.h"          /* loft_rational_tangent */

#include "engine/engine_num.h"     /* real_of, vec_of, point_of */
#include "engine/piece.h"

/* A piece in the number type. */
typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_weighted weighted[LOFT_DEGREE_MAX + 1];
    unsigned degree;
    bool rational;
} part;

static bool piece_in_type(const piece *p, part *out)
{
    out->degree   = p->degree;
    out->rational = piece_is_rational(p);
    for (unsigned k = 0; k <= p->degree; k++) {
        if (!vec_of(p->p[k], &out->p[k]) || !real_of(p->w[k], &out->weighted[k].w))
            return false;
        out->weighted[k].p = out->p[k];
    }
    return true;
}


// Walks
// -----

static void give_point(engine_point_sink *sink, void *context, loft_vec at)
{
    double point[ENGINE_AXES];

    point_of(at, point);
    sink(context, point);
}

/* LOFT_ERR_RANGE: too many steps for this walk; then no point was given. */
static int walk_bezier(const part *s, uint32_t n, engine_point_sink *sink, void *context)
{
    loft_bezier b;
    loft_forward w;
    loft_vec at;
    int status = loft_bezier_init(&b, s->p, s->degree);

    if (status == LOFT_OK)
        status = loft_forward_init(&w, &b, n);
    while (status == LOFT_OK && loft_forward_next(&w, &at))
        give_point(sink, context, at);
    return status;
}

static int walk_exact(const part *s, uint32_t n, engine_point_sink *sink, void *context)
{
    loft_bezier b;
    loft_forward_exact w;
    loft_vec at;
    int status = loft_bezier_init(&b, s->p, s->degree);

    if (status == LOFT_OK)
        status = loft_forward_exact_init(&w, &b, n);
    while (status == LOFT_OK && loft_forward_exact_next(&w, &at))
        give_point(sink, context, at);
    return status;
}

static int walk_rational(const part *s, uint32_t n, engine_point_sink *sink, void *context)
{
    loft_rational_walk w;
    loft_rational r;
    loft_vec at;
    int status = loft_rational_init(&r, s->weighted, s->degree);

    if (status == LOFT_OK)
        status = loft_rational_walk_init(&w, &r, n);
    while (status == LOFT_OK && loft_rational_walk_next(&w, &at))
        give_point(sink, context, at);
    return status;
}

/* Evaluate point by point: for degrees and counts of steps that the library does not walk. */
static int step_by_eval(const part *s, uint32_t n, engine_point_sink *sink, void *context)
{
    loft_rational r;
    loft_bezier b;
    int status = s->rational ? loft_rational_init(&r, s->weighted, s->degree)
                             : loft_bezier_init(&b, s->p, s->degree);

    for (uint32_t j = 0; status == LOFT_OK && j < n; j++)
        give_point(sink, context,
                   s->rational ? loft_rational_eval(&r, loft_unit_of(j + 1, n))
                               : loft_bezier_eval(&b, loft_unit_of(j + 1, n)));
    return status;
}

static int piece_walk(const piece *p, uint32_t n, engine_point_sink *sink, void *context)
{
    int status;
    part s;

    if (!piece_in_type(p, &s))
        return LOFT_ERR_RANGE;
    if (s.degree > LOFT_FORWARD_DEGREE_MAX)
        return step_by_eval(&s, n, sink, context);
    status = s.rational ? walk_rational(&s, n, sink, context) : walk_bezier(&s, n, sink, context);
    if (status == LOFT_ERR_RANGE && !s.rational)
        status = walk_exact(&s, n, sink, context);
    return status == LOFT_ERR_RANGE ? step_by_eval(&s, n, sink, context) : status;
}


// Cubics
// ------

static int piece_cubics(const piece *p, double tol, engine_cubic_sink *sink, void *context)
{
    loft_rational r;
    loft_bezier b;
    loft_to_cubics chain;
    loft_cubic c;
    loft_real within;
    part s;
    int status;

    if (!piece_in_type(p, &s) || !tol_of(tol, &within))
        return LOFT_ERR_RANGE;
    status = s.rational ? loft_rational_init(&r, s.weighted, s.degree)
                        : loft_bezier_init(&b, s.p, s.degree);
    if (status == LOFT_OK)
        status = s.rational ? loft_rational_to_cubics_init(&chain, &r, within)
                            : loft_to_cubics_init(&chain, &b, within);
    while (status == LOFT_OK && loft_to_cubics_next(&chain, &c)) {
        double out[4][ENGINE_AXES];
        for (int k = 0; k < 4; k++)
            point_of(c.p[k], out[k]);
        sink(context, out);
    }
    return status;
}


// Shape
// -----

static double double_of_unit(loft_unit t) { return (double)t / (double)LOFT_UNIT(1.0); }

static void take_box(loft_box box, bool tight, engine_shape *out)
{
    point_of(box.min, out->box[0]);
    point_of(box.max, out->box[1]);
    out->tight = tight;
}

/* The kind of a piece. A plane cubic that has no inflection, cusp or crossing in 0..1 is an arch
 * there, whatever the whole curve is. */
static const char *name_of_shape(const loft_shape *s)
{
    static const char *const names[] = { "point", "line", "parabola",        "serpentine",
                                         "cusp",  "loop", "cusp at infinity" };
    switch (s->kind) {
    case LOFT_SERPENTINE:
        return s->inflections == 2   ? names[s->kind]
               : s->inflections == 1 ? "serpentine (an inflection outside 0..1)"
                                     : "arch (serpentine, inflections outside 0..1)";
    case LOFT_CUSP: return s->cusps > 0 ? names[s->kind] : "arch (cusp outside 0..1)";
    case LOFT_LOOP: return s->loops > 0 ? names[s->kind] : "arch (loop outside 0..1)";
    case LOFT_CUSP_AT_INFINITY:
        return s->inflections > 0 ? names[s->kind]
                                  : "arch (cusp at infinity, inflection outside 0..1)";
    default: return names[s->kind];
    }
}

static int shape_of_cubic(const part *s, engine_shape *out)
{
    const loft_cubic c = { { s->p[0], s->p[1], s->p[2], s->p[3] } };
    loft_shape shape;
    const int status = loft_cubic_shape(&c, &shape);

    if (status != LOFT_OK)
        return status;
    out->type        = name_of_shape(&shape);
    out->inflections = shape.inflections;
    out->cusp        = shape.cusps > 0;
    out->loop        = shape.loops > 0;
    out->cusp_at     = double_of_unit(shape.cusp);
    for (int i = 0; i < 2; i++) {
        out->inflection[i] = double_of_unit(shape.inflection[i]);
        out->loop_at[i]    = double_of_unit(shape.loop[i]);
    }
    return LOFT_OK;
}

/* Lower degrees are not elevated: rounding would bend lines. */
static int shape_of_lower(const part *s, engine_shape *out)
{
    enum loft_convexity convexity;
    const int status = loft_polygon_convex(s->p, s->degree + 1, &convexity);
    bool same = true;

    for (unsigned k = 1; k <= s->degree; k++)
        same = same && loft_vec_equal(s->p[k], s->p[0]);
    if (status == LOFT_OK)
        out->type = same ? "point" : convexity == LOFT_COLLINEAR ? "line" : "parabola";
    return status;
}

static int piece_shape(const piece *p, engine_shape *out)
{
    loft_rational r;
    loft_bezier b;
    int status;
    part s;

    *out = (engine_shape){ .type = NULL };
    if (!piece_in_type(p, &s))
        return LOFT_ERR_RANGE;
    status = s.rational ? loft_rational_init(&r, s.weighted, s.degree)
                        : loft_bezier_init(&b, s.p, s.degree);
    if (status != LOFT_OK)
        return status;
    take_box(s.rational ? loft_rational_box(&r) : loft_bezier_bounds(&b), !s.rational, out);
    if (s.rational || s.degree > 3)
        return LOFT_OK;
    return s.degree == 3 ? shape_of_cubic(&s, out) : shape_of_lower(&s, out);
}

/* The tangent is that of 0..1: derivatives are divided by powers of the span. */
static int piece_bend_at(const piece *p, double t, double span, bool plane, engine_bend *out)
{
    loft_vec d, frame[3];
    loft_tangent here;
    loft_rational r;
    loft_acc x = 0;
    part s;

    if (!piece_in_type(p, &s))
        return LOFT_ERR_RANGE;
    int status = loft_rational_init(&r, s.weighted, s.degree);
    if (status == LOFT_OK)
        status = loft_rational_tangent(&r, LOFT_UNIT(t), &here);
    if (status != LOFT_OK)
        return status;
    out->derived = true;
    for (unsigned k = 0; k < 3 && out->derived; k++) {
        out->derived = loft_tangent_deriv(&here, k + 1, &d) == LOFT_OK;
        if (out->derived)
            point_of(d, out->d[k]);
        for (int axis = 0; axis < ENGINE_AXES; axis++)
            out->d[k][axis] /= pow(span, k + 1);
    }
    out->stops = loft_tangent_curvature(&here, plane, &x) != LOFT_OK;
    out->curvature = double_of_acc(x);
    out->straight = loft_tangent_frenet(&here, frame) != LOFT_OK ||
                    loft_tangent_torsion(&here, &x) != LOFT_OK;
    out->torsion = double_of_acc(x);
    for (int k = 0; k < 3 && !out->straight; k++)
        point_of(frame[k], out->frame[k]);
    return LOFT_OK;
}

const engine_pieces ENGINE_OF(engine_pieces) = {
    .walk = piece_walk, .bend = piece_bend_at, .shape = piece_shape, .cubics = piece_cubics
};

/* host-tools/engine/engine_curve.c -- curves of every kind through the library; compiled once per
 * number type
 * SPDX-License-Identifier: MIT
 *
 * Opening a curve rounds its points to the number type and prepares its data. Each piece is then a
 * Bezier curve of the library, by the library's own conversion. Points come from the function that
 * evaluates that kind of curve.
 */
#include <float.h>
#include <stdlib.h>

#include "basis/interp.h"           /* loft_parabola */
#include "curve/bezier.h"           /* loft_bezier */
#include "curve/bspline.h"          /* loft_bspline */
#include "curve/cardinal.h"         /* loft_cardinal_eval */
#include "curve/catmull.h"          /* loft_catmull_eval */
#include "curve/circle.h"           /* loft_circle */
#include "curve/hermite.h"          /* loft_hermite */
#include "curve/natural.h"          /* loft_natural */
#include "curve/nurbs.h"            /* loft_nurbs */
#include "curve/parabola.h"         /* loft_bezier_from_parabola */
#include "curve/rational.h"         /* loft_rational */
#include "curve/spline.h"           /* loft_spline */
#include "curve/tcb.h"              /* loft_tcb */

#include "engine/curve.h"
#include "engine/engine_num.h"  /* real_of, vec_of, point_of */
#include "engine/piece.h"
#include "base/tool.h"          /* tool_grow */

#define ARC_TOL 1e-4    /* mm; the largest distance of the cubics of an arc from it */

struct engine_curve {
    const curve *c;
    loft_vec *p;
    loft_real *w;                   /* weights; of a parabola: its parameters */
    loft_weighted *weighted;        /* both                                   */
    loft_vec (*d)[2];
    loft_unit tension;
    loft_natural natural;
    loft_natural_knot *memory;      /* of `natural` */
    loft_spline spline;
    loft_spline_knot *nodes;        /* of `spline` */
    loft_tcb *way;
    loft_real *knot;
    loft_bspline bspline;
    loft_nurbs nurbs;
    unsigned *before;               /* B-splines: for each span, the index of the one before it as
                                     * the library counts; 0 for the first */
    loft_circle circle;
    loft_cubic *cubic;              /* of an arc: its spans */
    unsigned spans;                 /* of B-splines and arcs */
};

/* A piece in the number type. */
typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_weighted weighted[LOFT_DEGREE_MAX + 1];
    unsigned degree;
    bool rational;
} part;


/* A kind of curve in the library. NULL: the points suffice; take `cubic`; the Bezier piece has the
 * points. */
typedef struct {
    int (*prepare)(engine_curve *e);
    int (*piece)(const engine_curve *e, unsigned i, part *out);
    int (*cubic)(const engine_curve *e, unsigned i, loft_cubic *out);
    int (*eval)(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out);
    int (*eval_at)(const engine_curve *e, double t, loft_vec *out);     /* of its own parameter */
} library_row;

static const library_row library_rows[CURVE_KINDS];


// Open and close
// --------------

static void curve_close(engine_curve *e)
{
    free(e->p);
    free(e->w);
    free(e->weighted);
    free(e->d);
    free(e->memory);
    free(e->nodes);
    free(e->way);
    free(e->knot);
    free(e->before);
    free(e->cubic);
    free(e);
}

/* Round the data of the file to the number type. */
static int hold_points(engine_curve *e)
{
    const curve *c = e->c;

    e->p = tool_grow(NULL, c->count * sizeof *e->p);
    e->w = tool_grow(NULL, c->count * sizeof *e->w);
    e->weighted = tool_grow(NULL, c->count * sizeof *e->weighted);
    e->d = tool_grow(NULL, c->count * sizeof *e->d);
    for (unsigned i = 0; i < c->count; i++) {
        if (!vec_of(c->point[i].p, &e->p[i]) || !vec_of(c->point[i].d[0], &e->d[i][0]) ||
            !vec_of(c->point[i].d[1], &e->d[i][1]) || !real_of(c->point[i].w, &e->w[i]))
            return LOFT_ERR_RANGE;
        e->weighted[i] = (loft_weighted){ e->p[i], e->w[i] };
    }
    e->knot = tool_grow(NULL, c->knot_count * sizeof *e->knot);
    for (unsigned i = 0; i < c->knot_count; i++)
        if (!real_of(c->knot[i], &e->knot[i]))
            return LOFT_ERR_RANGE;
    e->tension = LOFT_UNIT(c->tension);
    return LOFT_OK;
}

static void list_spans(engine_curve *e, const loft_knots *knots)
{
    e->before = tool_grow(NULL, e->c->count * sizeof *e->before);
    for (unsigned span = 0; ; ) {
        const unsigned before = span;
        span = loft_knots_next(knots, span);
        if (span == 0)
            break;
        e->before[e->spans++] = before;
    }
}

/* In floats the tolerance is at least the resolution there. */
static double arc_tolerance(const engine_curve *e)
{
    const double step = LOFT_REAL_LSB > 0                     ? 0
                        : sizeof(loft_real) == sizeof(double) ? DBL_EPSILON
                                                              : (double)FLT_EPSILON;
    double largest = 0;

    for (unsigned k = 0; k < 3; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            largest = fmax(largest, fabs(e->c->point[k].p[i]));
    return fmax(ARC_TOL, 16 * step * largest);
}

static int prepare_arc(engine_curve *e)
{
    loft_circle_spans s;
    int status = loft_circle_from_centre(&e->circle, e->p[0], e->p[2], LOFT_PLANE_XY, e->p[1],
                                         e->c->turns);

    if (status == LOFT_OK)
        status = loft_circle_spans_init(&s, &e->circle, LOFT_CIRCLE_CUBIC,
                                        LOFT_REAL(arc_tolerance(e)));
    if (status != LOFT_OK)
        return status;
    e->cubic = tool_grow(NULL, s.n * sizeof *e->cubic);
    while (loft_circle_spans_next(&s, &e->cubic[e->spans]))
        e->spans++;
    return LOFT_OK;
}

static int prepare_spline(engine_curve *e)
{
    const curve *c = e->c;
    const enum loft_spacing spacing = c->chord ? LOFT_CHORD : LOFT_UNIFORM;
    const loft_vec slope[2] = { e->d[0][0], e->d[c->count - 1][0] };

    e->nodes = tool_grow(NULL, c->count * sizeof *e->nodes);
    switch (c->ends) {
    case CURVE_CLAMPED:
        return loft_spline_clamped_init(&e->spline, e->p, c->count, slope, spacing, e->nodes);
    case CURVE_THROUGH:
    case CURVE_SLOPE:
        return loft_spline_hidden_init(
            &e->spline, e->p, c->count,
            c->ends == CURVE_SLOPE ? LOFT_HIDDEN_SLOPE : LOFT_HIDDEN_THROUGH, e->nodes);
    default:
        return loft_spline_init(&e->spline, e->p, c->count,
                                c->ends == CURVE_CLOSED ? LOFT_ENDS_CLOSED : LOFT_ENDS_NOT_A_KNOT,
                                spacing, e->nodes);
    }
}

/* Tension, continuity and bias are parameters, not lengths. */
static int prepare_tcb(engine_curve *e)
{
    e->way = tool_grow(NULL, e->c->count * sizeof *e->way);
    for (unsigned i = 0; i < e->c->count; i++) {
        const double *d = e->c->point[i].d[0];
        e->way[i] = (loft_tcb){ LOFT_UNIT(d[0]), LOFT_UNIT(d[1]), LOFT_UNIT(d[2]) };
    }
    return LOFT_OK;
}

static int prepare_natural(engine_curve *e)
{
    const curve *c = e->c;

    e->memory = tool_grow(NULL, c->count * sizeof *e->memory);
    return loft_natural_init(&e->natural, e->p, c->count,
                             c->kind == CURVE_CHORD ? LOFT_CHORD : LOFT_UNIFORM, e->memory);
}

static int prepare_bspline(engine_curve *e)
{
    const int status = loft_bspline_init(&e->bspline, e->p, e->c->count, e->knot, e->c->degree);

    if (status == LOFT_OK)
        list_spans(e, &e->bspline.knots);
    return status;
}

static int prepare_nurbs(engine_curve *e)
{
    const int status = loft_nurbs_init(&e->nurbs, e->weighted, e->c->count, e->knot, e->c->degree);

    if (status == LOFT_OK)
        list_spans(e, &e->nurbs.knots);
    return status;
}

static int prepare_curve(engine_curve *e)
{
    const library_row *row = &library_rows[e->c->kind];
    const int status       = hold_points(e);

    return status == LOFT_OK && row->prepare != NULL ? row->prepare(e) : status;
}

static int curve_open(const curve *c, engine_curve **out)
{
    engine_curve *e = tool_grow(NULL, sizeof *e);

    *e = (engine_curve){ .c = c };
    const int status = prepare_curve(e);
    if (status != LOFT_OK)
        curve_close(e);
    else
        *out = e;
    return status;
}


// Pieces
// ------

static void take_points(const engine_curve *e, unsigned first, part *out)
{
    for (unsigned k = 0; k <= out->degree; k++) {
        out->p[k] = e->p[first + k];
        out->weighted[k] = e->weighted[first + k];
    }
}

static int piece_bezier(const engine_curve *e, unsigned i, part *out)
{
    take_points(e, i, out);
    return LOFT_OK;
}

static int piece_parabola(const engine_curve *e, unsigned i, part *out)
{
    (void)i;
    return loft_bezier_from_parabola(e->w, e->p, e->w[0], e->w[2], out->p);
}

static loft_hermite hermite_of(const engine_curve *e, unsigned i)
{
    return (loft_hermite){ e->p[i], e->p[i + 1], e->d[i][0], e->d[i + 1][0] };
}

static loft_hermite5 hermite5_of(const engine_curve *e, unsigned i)
{
    return (loft_hermite5){ e->p[i],        e->p[i + 1], e->d[i][0],
                            e->d[i + 1][0], e->d[i][1],  e->d[i + 1][1] };
}

static int piece_hermite5(const engine_curve *e, unsigned i, part *out)
{
    const loft_hermite5 h = hermite5_of(e, i);

    return loft_bezier_from_hermite5(&h, out->p);
}

static int piece_bspline(const engine_curve *e, unsigned i, part *out)
{
    unsigned span = e->before[i];

    return loft_bspline_next(&e->bspline, &span, out->p) ? LOFT_OK : LOFT_ERR_ARG;
}

static int piece_nurbs(const engine_curve *e, unsigned i, part *out)
{
    unsigned span = e->before[i];

    return loft_nurbs_next(&e->nurbs, &span, out->weighted) ? LOFT_OK : LOFT_ERR_ARG;
}

static int cubic_hermite(const engine_curve *e, unsigned i, loft_cubic *out)
{
    const loft_hermite h = hermite_of(e, i);

    return loft_cubic_from_hermite(&h, out);
}

static int cubic_cardinal(const engine_curve *e, unsigned i, loft_cubic *out)
{
    return loft_cubic_from_cardinal(&e->p[i], e->tension, out);
}

static int cubic_arc(const engine_curve *e, unsigned i, loft_cubic *out)
{
    *out = e->cubic[i];
    return LOFT_OK;
}

static int cubic_spline(const engine_curve *e, unsigned i, loft_cubic *out)
{
    return loft_cubic_from_spline(&e->spline, i, out);
}

static int cubic_tcb(const engine_curve *e, unsigned i, loft_cubic *out)
{
    return loft_cubic_from_tcb(&e->p[i], &e->way[i + 1], &e->way[i + 2], out);
}

static int cubic_catmull(const engine_curve *e, unsigned i, loft_cubic *out)
{
    return loft_cubic_from_catmull(&e->p[i], e->tension, out);
}

static int cubic_natural(const engine_curve *e, unsigned i, loft_cubic *out)
{
    return loft_cubic_from_natural(&e->natural, i, out);
}

static int piece_in_type(const engine_curve *e, unsigned i, part *out)
{
    const library_row *row = &library_rows[e->c->kind];
    loft_cubic cubic;

    out->degree   = e->c->degree;
    out->rational = curve_is_rational(e->c);
    if (row->piece != NULL)
        return row->piece(e, i, out);
    const int status = row->cubic(e, i, &cubic);
    for (int k = 0; k < 4; k++)
        out->p[k] = cubic.p[k];
    return status;
}

static unsigned curve_count(const engine_curve *e)
{
    return e->spans ? e->spans : curve_pieces(e->c);
}

static int curve_piece(engine_curve *e, unsigned i, piece *out)
{
    part s;
    const int status = piece_in_type(e, i, &s);

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
        return fabs(t) < 127 ? loft_bezier_extrapolate(&b, LOFT_UNIT(t), out) : LOFT_ERR_RANGE;
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

static int eval_piece(const engine_curve *e, unsigned i, double t, loft_vec *out)
{
    part s;
    const int status = piece_in_type(e, i, &s);

    if (status != LOFT_OK)
        return status;
    return s.rational ? eval_rational(s.weighted, s.degree, t, out)
                      : eval_bezier(s.p, s.degree, t, out);
}

static int eval_parabola(const engine_curve *e, double t, loft_vec *out)
{
    int status = LOFT_OK;
    loft_real at;

    if (!real_of(t, &at))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        const loft_real f[3] = { e->p[0].axis[i], e->p[1].axis[i], e->p[2].axis[i] };
        loft_parabola p;
        status = loft_parabola_init(&p, e->w, f);
        if (status == LOFT_OK)
            status = loft_parabola_eval(&p, at, &out->axis[i]);
    }
    return status;
}

static int eval_hermite(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out)
{
    const loft_hermite h = hermite_of(e, i);

    return loft_hermite_eval(&h, local, out);
}

static int eval_hermite5(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out)
{
    const loft_hermite5 h = hermite5_of(e, i);

    return loft_hermite5_eval(&h, local, out);
}

static int eval_cardinal(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out)
{
    return loft_cardinal_eval(&e->p[i], e->tension, local, out);
}

static int eval_natural(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out)
{
    return loft_natural_eval(&e->natural, i, local, out);
}

static int eval_arc(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out)
{
    (void)i;
    return loft_circle_eval(&e->circle, local, out);
}

static int eval_spline(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out)
{
    return loft_spline_eval(&e->spline, i, local, out);
}

static int eval_tcb(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out)
{
    return loft_tcb_eval(&e->p[i], &e->way[i + 1], &e->way[i + 2], local, out);
}

static int eval_catmull(const engine_curve *e, unsigned i, loft_unit local, loft_vec *out)
{
    return loft_catmull_eval(&e->p[i], e->tension, local, out);
}

static int eval_bspline(const engine_curve *e, double t, loft_vec *out)
{
    loft_real u;

    if (!real_of(t, &u))
        return LOFT_ERR_RANGE;
    *out = e->c->kind == CURVE_NURBS ? loft_nurbs_eval(&e->nurbs, u)
                                     : loft_bspline_eval(&e->bspline, u);
    return LOFT_OK;
}

static const library_row library_rows[CURVE_KINDS] = {
    [CURVE_BEZIER]   = { .piece = piece_bezier },
    [CURVE_LINE]     = { .piece = piece_bezier },
    [CURVE_RATIONAL] = { .piece = piece_bezier },
    [CURVE_PARABOLA] = { .piece = piece_parabola, .eval_at = eval_parabola },
    [CURVE_HERMITE3] = { .cubic = cubic_hermite, .eval = eval_hermite },
    [CURVE_HERMITE5] = { .piece = piece_hermite5, .eval = eval_hermite5 },
    [CURVE_CARDINAL] = { .cubic = cubic_cardinal, .eval = eval_cardinal },
    [CURVE_NATURAL]  = { prepare_natural, .cubic = cubic_natural, .eval = eval_natural },
    [CURVE_CHORD]    = { prepare_natural, .cubic = cubic_natural, .eval = eval_natural },
    [CURVE_BSPLINE]  = { prepare_bspline, .piece = piece_bspline, .eval_at = eval_bspline },
    [CURVE_NURBS]    = { prepare_nurbs, .piece = piece_nurbs, .eval_at = eval_bspline },
    [CURVE_ARC]      = { prepare_arc, .cubic = cubic_arc, .eval = eval_arc },
    [CURVE_SPLINE]   = { prepare_spline, .cubic = cubic_spline, .eval = eval_spline },
    [CURVE_TCB]      = { prepare_tcb, .cubic = cubic_tcb, .eval = eval_tcb },
    [CURVE_CATMULL]  = { .cubic = cubic_catmull, .eval = eval_catmull },
};

static int curve_eval(engine_curve *e, double t, double out[ENGINE_AXES])
{
    const library_row *row = &library_rows[e->c->kind];
    const bool inside      = t >= curve_from(e->c) && t <= curve_to(e->c);
    long double local;
    loft_vec at;
    int status;

    if (!inside && !curve_extends(e->c))
        return LOFT_ERR_ARG;
    if (row->eval_at != NULL) {
        status = row->eval_at(e, t, &at);
    } else {
        const unsigned i = curve_locate(e->c, (long double)t, &local);
        status = row->eval != NULL ? row->eval(e, i, LOFT_UNIT((double)local), &at)
                                   : eval_piece(e, i, (double)local, &at);
    }
    if (status == LOFT_OK)
        point_of(at, out);
    return status;
}

const engine_curves ENGINE_OF(engine_curves) = { .open = curve_open,
    .close  = curve_close,
    .eval   = curve_eval,
    .pieces = curve_count,
                                                 .piece = curve_piece };

/* host-tools/cmd/cmd_eval.c -- loft eval: points of a curve or a surface, or the shape of a curve
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "cmd/commands.h"
#include "geometry/surface_text.h"
#include "num/status.h"     /* LOFT_SINGULAR */

#include "engine/piece.h"
#include "geometry/print.h"
#include "engine/sided.h"   /* sided_has */
#include "base/source.h"    /* source_name */
#include "engine/surface.h"
#include "readers.h"

typedef struct {
    print_options p;
    const option_list *t;
    const char *file;
    size_t number;          /* the number of the curve */
    bool deriv, normal, curvature, frame;   /* what stands behind each point */
} evaluation;


// Points
// ------

static const char *text_of(const evaluation *v, double x) { return number_text(v->p.e, x); }

static const char *place_of(const evaluation *v, double t) { return parameter_text(v->p.e, t); }

static int refuse_parameter(const evaluation *v, const curve *c, double t, int status)
{
    if (!curve_extends(c) && (t < curve_from(c) || t > curve_to(c)))
        return tool_error(EX_DATAERR, "%s:%u: t = %s: give %s to %s for this %s", v->file, c->line,
                          place_of(v, t), place_of(v, curve_from(c)), place_of(v, curve_to(c)),
                          curve_name(c->kind));
    return tool_error(EX_DATAERR, "%s:%u: t = %s: %s", v->file, c->line, place_of(v, t),
                      curve_status(c, status));
}

static bool wants_more(const evaluation *v)
{
    return v->deriv || v->normal || v->curvature || v->frame;
}

static void print_more(const evaluation *v, const double p[ENGINE_AXES])
{
    putchar(' ');
    print_words(&v->p, p);
}

static void print_bend(const evaluation *v, const engine_bend *b)
{
    for (int k = 0; k < 3 && v->deriv && b->derived; k++)
        print_more(v, b->d[k]);
    if (v->deriv && !b->derived)
        printf(" none");
    if (v->normal && !b->straight)
        print_more(v, b->frame[1]);
    else if (v->normal)
        printf(" none");
    if (v->curvature && !b->stops)
        printf(" %s", text_of(v, b->curvature));
    else if (v->curvature)
        printf(" none");
    if (v->curvature && v->p.solid && !b->straight)
        printf(" %s", text_of(v, b->torsion));
    else if (v->curvature && v->p.solid)
        printf(" none");
    for (int k = 0; k < 3 && v->frame && !b->straight; k++)
        print_more(v, b->frame[k]);
    if (v->frame && b->straight)
        printf(" none");
    putchar('\n');
}

/* What stands behind the point at t. */
static int print_local(const evaluation *v, const curve *c, engine_curve *held, double t)
{
    long double local;
    const unsigned i = curve_locate(c, t, &local);
    engine_bend b;
    piece p;
    int status = v->p.e->curve->piece(held, i, &p);

    if (status == 0)
        status = v->p.e->piece->bend(&p, (double)local, curve_break(c, i + 1) - curve_break(c, i),
                                     !v->p.solid, &b);
    if (status == 0)
        print_bend(v, &b);
    return status;
}

static int print_points(evaluation *v, const curve *c, engine_curve *held)
{
    if (v->number > 0)
        putchar('\n');
    for (size_t j = 0; j < v->t->count || j == 0; j++) {
        const double t = v->t->count ? v->t->value[j] : (curve_from(c) + curve_to(c)) / 2;
        double point[ENGINE_AXES];
        int status = v->p.e->curve->eval(held, t, point);
        if (status == 0 && !wants_more(v))
            print_point(&v->p, point);
        else if (status == 0) {
            print_words(&v->p, point);
            status = print_local(v, c, held, t);
        }
        if (status != 0)
            return refuse_parameter(v, c, t, status);
    }
    return EX_OK;
}


// Shape
// -----

/* Parameters are those of the whole curve. */
static void print_places(const evaluation *v, const engine_shape *s, const curve *c, unsigned i)
{
    const double a = curve_break(c, i), b = curve_break(c, i + 1) - a;

    for (unsigned k = 0; k < s->inflections; k++)
        printf("inflection at %s, ", place_of(v, a + b * s->inflection[k]));
    if (s->cusp)
        printf("cusp at %s, ", place_of(v, a + b * s->cusp_at));
    if (s->loop)
        printf("loop from %s to %s, ", place_of(v, a + b * s->loop_at[0]),
               place_of(v, a + b * s->loop_at[1]));
}

static int print_shapes(evaluation *v, const curve *c, engine_curve *held)
{
    const engine *e = v->p.e;
    int status = 0;

    for (unsigned i = 0; i < e->curve->pieces(held) && status == 0; i++) {
        engine_shape s;
        piece p;
        status = e->curve->piece(held, i, &p);
        if (status == 0)
            status = e->piece->shape(&p, &s);
        if (status != 0)
            break;
        printf("%zu.%u %s: ", v->number, i, curve_name(c->kind));
        if (s.type != NULL)
            printf("%s, ", s.type);
        print_places(v, &s, c, i);
        printf("%s ", s.tight ? "box" : "hull");
        for (int k = 0; k < 2; k++) {
            print_words(&v->p, s.box[k]);
            fputs(k == 0 ? " to " : "\n", stdout);
        }
    }
    return status == 0 ? EX_OK
                       : tool_error(EX_DATAERR, "%s:%u: %s: %s", v->file, c->line,
                                    curve_name(c->kind), curve_status(c, status));
}

static int every_curve(evaluation *v, const curves *all, bool shape)
{
    const engine_curves *make = v->p.e->curve;
    int code = EX_OK;

    for (v->number = 0; v->number < all->count && code == EX_OK; v->number++) {
        const curve *c = &all->curve[v->number];
        engine_curve *held;
        const int status = make->open(c, &held);
        if (status != 0)
            return tool_error(EX_DATAERR, "%s:%u: %s: %s", v->file, c->line, curve_name(c->kind),
                              curve_status(c, status));
        code = shape ? print_shapes(v, c, held) : print_points(v, c, held);
        make->close(held);
    }
    return code;
}


// Surfaces
// --------

/* Derivatives, the unit normal, curvatures and their directions, behind a point. */
static int print_look(const evaluation *v, const engine_surface *held, double a, double b)
{
    engine_look look;
    const int status = v->p.e->surface->local(held, a, b, &look);

    if (status == LOFT_SINGULAR)
        puts(" none");
    if (status != LOFT_OK)
        return status == LOFT_SINGULAR ? LOFT_OK : status;
    for (int k = 0; k < 5 && v->deriv && look.derived; k++)
        print_more(v, look.d[k]);
    if (v->deriv && !look.derived)
        printf(" none");
    if (v->normal)
        printf(" %s %s %s %s %s", text_of(v, look.normal[0]), text_of(v, look.normal[1]),
               text_of(v, look.normal[2]), text_of(v, look.gauss), text_of(v, look.mean));
    if (v->curvature)
        printf(" %s %s", text_of(v, look.least), text_of(v, look.most));
    for (int k = 0; k < 2 && v->frame && look.directed; k++)
        print_more(v, look.direction[k]);
    if (v->frame && !look.directed)
        printf(" none");
    putchar('\n');
    return status == LOFT_SINGULAR ? LOFT_OK : status;
}

static int surface_points_of(const evaluation *v, const surface *s)
{
    const engine_surfaces *make = v->p.e->surface;
    engine_surface *held;
    double middle[2];
    int status = make->open(s, &held), code = EX_OK;

    if (status != 0)
        return tool_error(EX_DATAERR, "%s:%u: %s: %s", v->file, s->line, surface_name(s->kind),
                          surface_status(s, status));
    surface_middle(s, middle);
    for (size_t j = 0; (j < v->t->count || j == 0) && code == EX_OK; j += 2) {
        const double a = v->t->count ? v->t->value[j] : middle[0],
                     b = v->t->count ? v->t->value[j + 1] : middle[1];
        double point[ENGINE_AXES];
        status = make->eval(held, a, b, point);
        if (status == 0) {
            print_words(&v->p, point);
            if (!wants_more(v))
                putchar('\n');
            else
                status = print_look(v, held, a, b);
        }
        if (status == 0)
            continue;
        if (!surface_is_sided(s) &&
            !(a >= 0 && a <= 1 && b >= 0 && b <= (surface_is_triangle(s) ? 1 - a : 1)))
            code = tool_error(EX_DATAERR, "%s:%u: u, v = %s, %s: give 0 to 1 for this %s%s",
                              v->file, s->line, place_of(v, a), place_of(v, b),
                              surface_name(s->kind),
                              surface_is_triangle(s) ? ", u + v at most 1" : "");
        else if (!sided_has(s, a, b))
            code = tool_error(
                EX_DATAERR,
                "%s:%u: u, v = %s, %s: outside the domain: give a point x, y of the polygon",
                v->file, s->line, place_of(v, a), place_of(v, b));
        else
            code = tool_error(EX_DATAERR, "%s:%u: u, v = %s, %s: %s", v->file, s->line,
                              place_of(v, a), place_of(v, b), surface_status(s, status));
    }
    make->close(held);
    return code;
}

static int every_surface(const evaluation *v, const surfaces *all)
{
    int code = EX_OK;

    for (size_t i = 0; i < all->count && code == EX_OK; i++) {
        if (i > 0)
            putchar('\n');
        code = surface_points_of(v, &all->surface[i]);
    }
    return code;
}

static int eval_surfaces(const surfaces *all, const evaluation *asked, const option_list *uv,
                         bool of_curves)
{
    evaluation v = *asked;

    if (of_curves)
        return tool_error(EX_USAGE,
                          "%s: holds surfaces: --t and --shape are for curves, give --uv U,V,..",
                          v.file);
    v.t = uv;
    v.p.solid = true;
    return every_surface(&v, all);
}

/* Points of tetrahedra. */
static int eval_solids(const char *file, const engine *e, const option_list *uvw)
{
    const print_options p = { e, true };
    surfaces all = { .solids = true };
    int code = surfaces_read_only(tool_host(), &all, file);

    for (size_t i = 0; i < all.count && code == 0; i++) {
        const surface *s = &all.surface[i];
        if (s->kind != SURFACE_TETRA)
            code = tool_error(EX_DATAERR, "%s:%u: --uvw: is for tetra: give this %s --uv U,V",
                              source_name(file), s->line, surface_name(s->kind));
        for (size_t k = 0; k < uvw->count && code == 0; k += 3) {
            const double *at = &uvw->value[k];
            double point[ENGINE_AXES];
            if (!(at[0] >= 0 && at[1] >= 0 && at[2] >= 0 && at[0] + at[1] + at[2] <= 1))
                code = tool_error(EX_USAGE,
                                  "--uvw: %s, %s, %s: give shares of T2, T3, T4 from 0 "
                                  "on, together at most 1",
                                  parameter_text(e, at[0]), parameter_text(e, at[1]),
                                  parameter_text(e, at[2]));
            else if (e->solid(s, at, point) != 0)
                code = tool_error(EX_DATAERR, "%s:%u: tetra: %s", source_name(file), s->line,
                                  engine_status(LOFT_ERR_RANGE, NULL));
            else
                print_point((void *)&p, point);
        }
    }
    surfaces_free(&all);
    return code;
}

typedef struct {
    source_given from;
    option_list t, uv, uvw;
    bool deriv, normal, curvature, frame, shape;
    const engine *e;
} eval_options;

static const option eval_rows[] = {
    { "t", OPTION_LIST(eval_options, t), .least = -1e6, .most = 1e6, .value = "T,..",
      .help = "parameters, 0..1 on a Bezier curve (the middle)" },
    { "uv", OPTION_LIST(eval_options, uv), .least = -32768, .most = 32767, .value = "U,V,..",
      .counts = "2n", .remedy = "give pairs, U,V,U,V,..",
      .help = "pairs of parameters on a surface (the middle)" },
    { "uvw", OPTION_LIST(eval_options, uvw), .least = 0, .most = 1, .value = "V,W,X,..",
      .counts = "3n", .remedy = "give triples, V,W,X,..",
      .help = "shares of T2, T3, T4 in a tetrahedron" },
    { "deriv", OPTION_FLAG(eval_options, deriv),
      .help = "behind each point its derivatives: first to third, of an arc those of cubics; of a "
              "surface by u, v, uu, uv, vv" },
    { "normal", OPTION_FLAG(eval_options, normal),
      .help = "the principal normal; of a surface its normal, Gaussian and mean curvature" },
    { "curvature", OPTION_FLAG(eval_options, curvature),
      .help = "curvature and, in space, torsion; of a surface the principal curvatures" },
    { "frame", OPTION_FLAG(eval_options, frame),
      .help = "Frenet's frame: tangent, normal, binormal; of a surface the directions of its "
              "principal curvatures" },
    { "shape", OPTION_FLAG(eval_options, shape),
      .help = "not points, but the shape of each piece: its type, inflections, box" },
    OPTION_GROUP(eval_options, from, source_rows),
    ENGINE_ROW(eval_options, e, "q16", "number type"),
    OPTION_EXCLUDES("shape", "t", "a shape is that of the whole curve"),
    { 0 }
};

static int eval_curves(const eval_options *o, evaluation *v)
{
    curves all = { 0 };

    if (o->uv.count > 0)
        return tool_error(EX_USAGE, "--uv: is for surfaces: curves have one parameter, --t");
    const int code = curves_read(tool_host(), &all, o->from.file, o->from.points);
    v->p.solid     = all.solid;
    const int done = code == 0 ? every_curve(v, &all, o->shape) : code;
    curves_free(&all);
    return done;
}

static int run_eval(void *options)
{
    const eval_options *o = options;
    surfaces patches      = { 0 };
    evaluation v          = { .p = { .e = o->e },
                              .t = &o->t,
                              .file = source_given_name(&o->from),
                              .deriv = o->deriv,
                              .normal = o->normal,
                              .curvature = o->curvature,
                              .frame = o->frame };

    if (o->uvw.count > 0)
        return eval_solids(o->from.file, o->e, &o->uvw);
    int code = o->from.points ? 0 : surfaces_read(tool_host(), &patches, o->from.file);
    if (code == 0)
        code = patches.count > 0 ? eval_surfaces(&patches, &v, &o->uv, o->shape || o->t.count > 0)
                                 : eval_curves(o, &v);
    surfaces_free(&patches);
    return code;
}

const command command_eval = {
    .name = "eval",
    .arguments = "[--t T,..|--uv U,V,..] [FILE|-]",
    .summary = "points of a curve or a surface, or what a curve looks like",
    .detail = "FILE has one control point per line, `x y` or `x y z` (an "
        "empty line ends a curve), or curves of any kind in the\n"
        "format of host-tools/LOFT.md. Prints one point per parameter. "
        "A parameter is the curve's own: 0..1 for Bezier\n"
        "curves, 0..n over the n pieces of a spline, the knots of a "
        "B-spline. With --shape prints one line per piece: its\n"
        "number and kind, what it is as a cubic in the plane of x and "
        "y (decided exactly) and where, the smallest box around\n"
        "it, or, if it has weights, around its control points. Of "
        "surfaces (the same format) prints one point per pair --uv, of "
        "tetra per triple --uvw.\n",
    .options = eval_rows,
    .size = sizeof(eval_options),
    .run = run_eval,
};

/* host-tools/engine/engine_surface.c -- surfaces of every kind through the library; compiled once
 * per number type
 * SPDX-License-Identifier: MIT
 *
 * Opening a surface rounds its points to the number type and prepares its data. Points come from
 * the function of the library that evaluates that kind of surface.
 */
#include <stdlib.h>

#include "polygon/disk.h"                           /* loft_disk */
#include "surface/tensor/bicubic.h"                 /* loft_bicubic */
#include "surface/contour.h"                        /* loft_contour */
#include "surface/tensor/coons.h"                   /* loft_coons_bezier */
#include "surface/differential.h"                   /* loft_differential */
#include "surface/tensor/gregory.h"                 /* loft_gregory */
#include "surface/tensor/nurbs_surface.h"           /* loft_nurbs_surface */
#include "surface/octant.h"                         /* loft_octant_from_radius */
#include "surface/pn.h"                             /* loft_pn */
#include "surface/sphere.h"                         /* loft_sphere */
#include "surface/tensor/tensor.h"                  /* loft_tensor */
#include "surface/tensor/tensor_rational.h"         /* loft_tensor_rational */
#include "surface/triangle/triangle.h"              /* loft_triangle */
#include "surface/triangle/triangle_rational.h"     /* loft_triangle_rational */

#include "engine/engine_cells.h"
#include "engine/engine_num.h"  /* real_of, vec_of, point_of */
#include "engine/engine_sheet.h"
#include "engine/engine_sided.h"
#include "engine/surface.h"
#include "base/tool.h"          /* tool_grow */

#define OCTANT_POINTS 15

/* One of the library's surfaces; which says the kind. */
struct engine_surface {
    const surface *s;
    engine_sided *sided;        /* for patches with n sides; then nothing else is used */
    loft_vec *p;
    loft_weighted *weighted;
    loft_vec *net;              /* of a patch that was converted for its sheets, or NULL */
    loft_real *knot[2];         /* of a NURBS surface */
    union {
        loft_tensor tensor;
        loft_tensor_rational tensor_rational;
        loft_triangle triangle;
        loft_triangle_rational triangle_rational;
        loft_coons_bezier coons;
        loft_bicubic bicubic;
        loft_gregory gregory;
        loft_nurbs_surface nurbs;
        loft_pn pn;
        loft_sphere sphere;
    } as;
};


// Open and close
// --------------

static void surface_close(engine_surface *e)
{
    if (e->sided)
        ENGINE_OF(engine_sides).close(e->sided);
    free(e->p);
    free(e->weighted);
    free(e->net);
    free(e->knot[0]);
    free(e->knot[1]);
    free(e);
}

static int hold_points(engine_surface *e)
{
    const surface *s = e->s;
    const unsigned room = s->count > OCTANT_POINTS ? s->count : OCTANT_POINTS;

    e->p = tool_grow(NULL, room * sizeof *e->p);
    e->weighted = tool_grow(NULL, room * sizeof *e->weighted);
    for (unsigned i = 0; i < s->count; i++) {
        if (!vec_of(s->point[i].p, &e->p[i]) || !real_of(s->point[i].w, &e->weighted[i].w))
            return LOFT_ERR_RANGE;
        e->weighted[i].p = e->p[i];
    }
    return LOFT_OK;
}

/* The first 2 `orders` curves run along u, the others along v. */
static int prepare_coons(engine_surface *e)
{
    const surface *s = e->s;
    loft_bezier u[LOFT_COONS_ORDERS][2], v[LOFT_COONS_ORDERS][2];
    int status = LOFT_OK;

    for (unsigned k = 0; k < 2 * s->orders && status == LOFT_OK; k++) {
        status = loft_bezier_init(&u[k / 2][k % 2], e->p + k * (s->m + 1), s->m);
        if (status == LOFT_OK)
            status = loft_bezier_init(&v[k / 2][k % 2],
                                      e->p + 2 * s->orders * (s->m + 1) + k * (s->n + 1), s->n);
    }
    return status ? status
                  : (int)loft_coons_bezier_init(&e->as.coons, (const loft_bezier(*)[2])u,
                                                (const loft_bezier(*)[2])v, s->orders, 0);
}

static int prepare_pn(engine_surface *e)
{
    loft_vec normal[3];

    for (int k = 0; k < 3; k++)
        if (!vec_of(e->s->point[k].d, &normal[k]))
            return LOFT_ERR_RANGE;
    return loft_pn_init(&e->as.pn, e->p, normal);
}

/* The centre of the library's octant is 0. */
static int prepare_octant(engine_surface *e)
{
    loft_real radius;
    double point[ENGINE_AXES];

    if (!real_of(e->s->radius, &radius))
        return LOFT_ERR_RANGE;
    const int status = loft_octant_from_radius(radius, e->weighted);
    for (int k = 0; k < OCTANT_POINTS && status == LOFT_OK; k++) {
        point_of(e->weighted[k].p, point);
        for (int i = 0; i < ENGINE_AXES; i++)
            point[i] += double_of(e->p[0].axis[i]);
        if (!vec_of(point, &e->weighted[k].p))
            return LOFT_ERR_RANGE;
    }
    return status ? status
                  : (int)loft_triangle_rational_init(&e->as.triangle_rational, e->weighted, 4);
}

static int prepare_sphere(engine_surface *e)
{
    e->as.sphere.centre = e->p[0];
    return real_of(e->s->radius, &e->as.sphere.radius) ? LOFT_OK : LOFT_ERR_RANGE;
}

static int prepare_nurbs(engine_surface *e)
{
    const surface *s = e->s;

    for (unsigned along = 0; along < 2; along++) {
        e->knot[along] = tool_grow(NULL, s->knots[along] * sizeof *e->knot[along]);
        for (unsigned k = 0; k < s->knots[along]; k++)
            if (!real_of(s->knot[along][k], &e->knot[along][k]))
                return LOFT_ERR_RANGE;
    }
    return s->rational ? loft_nurbs_surface_init(&e->as.nurbs, e->weighted, s->rows, s->columns,
                                                 e->knot[0], s->m, e->knot[1], s->n)
                       : loft_bspline_surface_init(&e->as.nurbs, e->p, s->rows, s->columns,
                                                   e->knot[0], s->m, e->knot[1], s->n);
}

static int prepare_surface(engine_surface *e)
{
    const surface *s = e->s;
    const int status = hold_points(e);

    if (status != LOFT_OK)
        return status;
    switch (s->kind) {
    case SURFACE_TENSOR:
        return s->rational
                   ? (int)loft_tensor_rational_init(&e->as.tensor_rational, e->weighted, s->m, s->n)
                   : (int)loft_tensor_init(&e->as.tensor, e->p, s->m, s->n);
    case SURFACE_TRIANGLE:
        return s->rational
                   ? (int)loft_triangle_rational_init(&e->as.triangle_rational, e->weighted, s->m)
                   : (int)loft_triangle_init(&e->as.triangle, e->p, s->m);
    case SURFACE_COONS:  return prepare_coons(e);
    case SURFACE_GREGORY: return loft_gregory_init(&e->as.gregory, e->p);
    case SURFACE_NURBS:  return prepare_nurbs(e);
    case SURFACE_PN:     return prepare_pn(e);
    case SURFACE_OCTANT: return prepare_octant(e);
    case SURFACE_SPHERE: return prepare_sphere(e);
    default:
        for (int k = 0; k < 16; k++)
            e->as.bicubic.at[k / 4][k % 4] = e->p[k];
        return LOFT_OK;
    }
}

static int surface_open(const surface *s, engine_surface **out)
{
    engine_surface *e = tool_grow(NULL, sizeof *e);

    *e = (engine_surface){ .s = s };
    const int status = surface_is_sided(s) ? ENGINE_OF(engine_sides).open(s, &e->sided)
                                           : prepare_surface(e);
    if (status != LOFT_OK)
        surface_close(e);
    else
        *out = e;
    return status;
}


// Points
// ------

/* The parameters of a sphere are angles in degrees. */
static int eval_sphere(const engine_surface *e, double u, double v, loft_vec *out)
{
    return loft_sphere_eval(&e->as.sphere, LOFT_REAL(360 * v), LOFT_REAL(180 * u), out);
}

static int eval_triangle(const engine_surface *e, double u, double v, loft_vec *out)
{
    const loft_bary at = { LOFT_UNIT(u), LOFT_UNIT(v) };

    if (e->s->kind == SURFACE_PN)
        *out = loft_pn_eval(&e->as.pn, at);
    else if (e->s->rational || e->s->kind == SURFACE_OCTANT)
        *out = loft_triangle_rational_eval(&e->as.triangle_rational, at);
    else
        *out = loft_triangle_eval(&e->as.triangle, at);
    return LOFT_OK;
}

static int surface_eval(const engine_surface *e, double u, double v, double out[ENGINE_AXES])
{
    int status = LOFT_OK;
    loft_surface any;
    loft_vec at;

    if (e->sided)
        return ENGINE_OF(engine_sides).eval(e->sided, (sided_place){ SIDED_OWN, 0, u, v }, out);
    if (!(u >= 0 && v >= 0 && u <= 1 && v <= 1 &&
          (u + v <= 1 + 1e-9 || !surface_is_triangle(e->s))))
        return LOFT_ERR_ARG;
    switch (e->s->kind) {
    case SURFACE_TENSOR:
        at = e->s->rational
                 ? loft_tensor_rational_eval(&e->as.tensor_rational, LOFT_UNIT(u), LOFT_UNIT(v))
                 : loft_tensor_eval(&e->as.tensor, LOFT_UNIT(u), LOFT_UNIT(v));
        break;
    case SURFACE_COONS:
        status = loft_coons_bezier_eval(&e->as.coons, LOFT_UNIT(u), LOFT_UNIT(v), &at);
        break;
    case SURFACE_BICUBIC:
        status = loft_bicubic_eval(&e->as.bicubic, LOFT_UNIT(u), LOFT_UNIT(v), &at);
        break;
    case SURFACE_GREGORY:
        status = loft_gregory_eval(&e->as.gregory, LOFT_UNIT(u), LOFT_UNIT(v), &at);
        break;
    case SURFACE_NURBS:
        any = loft_surface_from_nurbs(&e->as.nurbs);
        status = any.eval(any.surface, LOFT_UNIT(u), LOFT_UNIT(v), &at);
        break;
    case SURFACE_SPHERE: status = eval_sphere(e, u, v, &at); break;
    default: status = eval_triangle(e, u, v, &at); break;
    }
    if (status == LOFT_OK)
        point_of(at, out);
    return status;
}

static int surface_kite(const engine_surface *e, unsigned kite, double u, double v,
                        double out[ENGINE_AXES])
{
    if (e->sided)
        return ENGINE_OF(engine_sides).eval(e->sided, sided_kite(e->s, kite, u, v), out);
    return surface_eval(e, u, v, out);
}


// Normals and curvatures
// ----------------------

/* On a sphere the normal points outward and the surface bends away from it. */
static int look_sphere(const engine_surface *e, double u, double v, engine_look *out)
{
    double at[ENGINE_AXES], length = 0;
    const int status = surface_eval(e, u, v, at);

    for (int i = 0; i < ENGINE_AXES; i++)
        at[i] -= e->s->point[0].p[i];
    for (int i = 0; i < ENGINE_AXES; i++)
        length += at[i] * at[i];
    for (int i = 0; i < ENGINE_AXES && status == LOFT_OK; i++)
        out->normal[i] = at[i] / sqrt(length);
    out->gauss = 1 / (e->s->radius * e->s->radius);
    out->mean  = out->least = out->most = -1 / e->s->radius;
    out->directed = out->derived = false;
    return status;
}

/* The derivatives at (u, v). `net` is the patch for a kind that is converted to a tensor product or
 * a triangle. */
static int surface_differential(const engine_surface *e, double u, double v, loft_differential *out)
{
    const loft_bary point = { LOFT_UNIT(u), LOFT_UNIT(v) };
    const loft_bary at = surface_is_triangle(e->s) ? loft_bary_clamp(point) : point;
    loft_vec net[16];
    const loft_tensor tensor = { net, 3, 3 };
    const loft_triangle cubic = { net, 3 };
    loft_real place[2];
    int status;

    switch (e->s->kind) {
    case SURFACE_TENSOR:
        if (e->s->rational)
            return loft_tensor_rational_differential(&e->as.tensor_rational, at.v, at.w, out);
        return loft_tensor_differential(&e->as.tensor, at.v, at.w, out);
    case SURFACE_COONS: return loft_coons_bezier_differential(&e->as.coons, at.v, at.w, out);
    case SURFACE_GREGORY: return loft_gregory_differential(&e->as.gregory, at.v, at.w, out);
    case SURFACE_NURBS:
        loft_nurbs_surface_at(&e->as.nurbs, at.v, at.w, place);
        return loft_nurbs_surface_differential(&e->as.nurbs, place[0], place[1], out);
    case SURFACE_BICUBIC:
        status = loft_tensor_from_bicubic(&e->as.bicubic, net);
        return status ? status : (int)loft_tensor_differential(&tensor, at.v, at.w, out);
    case SURFACE_PN:
        loft_pn_net(&e->as.pn, net);
        return loft_triangle_differential(&cubic, at, out);
    default:
        if (e->s->rational || e->s->kind == SURFACE_OCTANT)
            return loft_triangle_rational_differential(&e->as.triangle_rational, at, out);
        return loft_triangle_differential(&e->as.triangle, at, out);
    }
}

static int surface_local(const engine_surface *e, double u, double v, engine_look *out)
{
    const sided_place own = { SIDED_OWN, 0, u, v };
    loft_differential here;

    if (e->sided)
        return ENGINE_OF(engine_sides).look(e->sided, own, out);
    if (e->s->kind == SURFACE_SPHERE)
        return look_sphere(e, u, v, out);
    const int status = surface_differential(e, u, v, &here);

    return status ? status : look_of(&here, out);
}

static int look_at(const engine_surface *e, unsigned kite, double u, double v, engine_look *out)
{
    return e->sided ? ENGINE_OF(engine_sides).look(e->sided, sided_kite(e->s, kite, u, v), out)
                    : surface_local(e, u, v, out);
}

/* If rounding leads outside the polygon, move a little inside. If there is no normal (an edge that
 * is one point), move 2^-21 of the way to the middle, or more. There the normal errs by about 2^-43
 * / share, and by its turn over the share. */
static int surface_look(const engine_surface *e, unsigned kite, double u, double v,
                        engine_look *out)
{
    const double middle = surface_is_triangle(e->s) ? 1 / 3.0 : 0.5;
    int status = look_at(e, kite, u, v, out);

    for (double share = 0x1p-33; status != LOFT_OK && share < 0x1p-8; share *= 4) {
        if (status == LOFT_SINGULAR)
            share = fmax(share, 0x1p-21);
        status = look_at(e, kite, u + share * (middle - u), v + share * (middle - v), out);
    }
    return status;
}


// Contours
// --------

/* The data that a contour surface borrows, in addition to the surface. */
typedef struct {
    loft_vec net[10];
    loft_triangle cubic;
    loft_disk disk;
} sheet_room;

static int contour_surface(const engine_surface *e, sheet_room *room, loft_surface *out)
{
    int status = LOFT_OK;

    if (e->sided) {
        status = ENGINE_OF(engine_sides).disk(e->sided, &room->disk);
        *out = loft_surface_from_disk(&room->disk);
        return status;
    }
    switch (e->s->kind) {
    case SURFACE_TENSOR:
        *out = e->s->rational ? loft_surface_from_tensor_rational(&e->as.tensor_rational)
                              : loft_surface_from_tensor(&e->as.tensor);
        break;
    case SURFACE_PN:
        loft_pn_net(&e->as.pn, room->net);
        status = loft_triangle_init(&room->cubic, room->net, 3);
        *out = loft_surface_from_triangle(&room->cubic);
        break;
    case SURFACE_COONS:   *out = loft_surface_from_coons(&e->as.coons);     break;
    case SURFACE_BICUBIC: *out = loft_surface_from_bicubic(&e->as.bicubic); break;
    case SURFACE_GREGORY: *out = loft_surface_from_gregory(&e->as.gregory); break;
    case SURFACE_NURBS:   *out = loft_surface_from_nurbs(&e->as.nurbs);     break;
    case SURFACE_SPHERE:  *out = loft_surface_from_sphere(&e->as.sphere);   break;
    default:
        *out = e->s->rational || e->s->kind == SURFACE_OCTANT
                   ? loft_surface_from_triangle_rational(&e->as.triangle_rational)
                   : loft_surface_from_triangle(&e->as.triangle);
        break;
    }
    return status;
}

static int level_of(const engine_level *of, loft_level *out)
{
    const double degree = 3.14159265358979323846 / 180;
    const double wanted = of->of == ENGINE_LEVEL_ANGLE ? cos(of->value * degree) : of->value;
    loft_vec direction;
    loft_real value;

    if (!real_of(wanted, &value) || !vec_of(of->direction, &direction))
        return LOFT_ERR_RANGE;
    switch (of->of) {
    case ENGINE_LEVEL_PLANE: return loft_level_plane(out, direction, value);
    case ENGINE_LEVEL_ANGLE: return loft_level_light(out, direction, value);
    default:                 return loft_level_axis(out, 2, value);
    }
}

static int surface_contour(engine_surface *e, const engine_level *of, double tol, unsigned n,
                           engine_doubt *doubt, engine_contour_sink *sink, void *context)
{
    const unsigned sides = surface_is_sided(e->s) ? sided_count(e->s) : 1;
    int status = ENGINE_OF(engine_cells)(e, of, LOFT_CONTOUR_MAX / sides * sides, &n, doubt);
    const unsigned around = (n + sides - 1) / sides * sides;
    const size_t bytes = LOFT_CONTOUR_BYTES((size_t)n, (size_t)around);
    enum loft_contour_step step;
    double point[ENGINE_AXES];
    sheet_room room;
    loft_surface target;
    loft_contour c;
    loft_level level;
    loft_real within;
    loft_vec at;

    if (!tol_of(tol, &within))
        return LOFT_ERR_RANGE;
    uint8_t *memory = tool_grow(NULL, bytes);
    if (status == LOFT_OK)
        status = level_of(of, &level);
    if (status == LOFT_OK)
        status = contour_surface(e, &room, &target);
    if (status == LOFT_OK)
        status = loft_contour_init_level(&c, target, &level, within, n, around, memory, bytes);
    while (status == LOFT_OK && (step = loft_contour_next(&c, &at)) != LOFT_CONTOUR_OVER) {
        point_of(at, point);
        sink(context, step == LOFT_CONTOUR_START, point);
    }
    free(memory);
    return status;
}


// Sheets
// ------

static int tensor_sheets(const loft_tensor *t, unsigned level, engine_sheet_list *out)
{
    const unsigned n = 1u << level;

    if (level == 0)
        return loft_sheet_from_tensor(ENGINE_OF(engine_sheet_add)(out), t);
    for (unsigned k = 0; k < n * n; k++) {
        loft_sheet *const s = ENGINE_OF(engine_sheet_add)(out);
        const int status = loft_sheet_from_tensor_part(s, t, level, k / n, k % n);
        if (status != LOFT_OK)
            return status;
    }
    return LOFT_OK;
}

/* Write a surface as a tensor product or a triangle of the library, which then replaces it. */
static int convert_surface(engine_surface *e)
{
    int status = LOFT_ERR_ARG;

    e->net = tool_grow(e->net,
                       (SURFACE_DEGREE_MAX + 1) * (SURFACE_DEGREE_MAX + 1) * sizeof *e->net);
    if (e->s->kind == SURFACE_BICUBIC) {
        status = loft_tensor_from_bicubic(&e->as.bicubic, e->net);
        return status ? status : (int)loft_tensor_init(&e->as.tensor, e->net, 3, 3);
    }
    if (e->s->kind == SURFACE_COONS) {
        unsigned m, n;
        status = loft_tensor_from_coons_blended(&e->as.coons, &m, &n, e->net);
        return status ? status : (int)loft_tensor_init(&e->as.tensor, e->net, m, n);
    }
    if (e->s->kind == SURFACE_PN) {
        loft_pn_net(&e->as.pn, e->net);
        return loft_triangle_init(&e->as.triangle, e->net, 3);
    }
    return status;
}

int ENGINE_OF(engine_sheets)(engine_surface *e, unsigned level, engine_sheet_list *out)
{
    const enum surface_kind kind = e->s->kind;

    if (e->sided)
        return ENGINE_OF(engine_sides).sheets(e->sided, level, out);
    if (kind == SURFACE_TENSOR && !e->s->rational)
        return tensor_sheets(&e->as.tensor, level, out);
    if (kind == SURFACE_TENSOR)
        return loft_sheet_from_tensor_rational(ENGINE_OF(engine_sheet_add)(out),
                                               &e->as.tensor_rational);
    if (kind == SURFACE_OCTANT || (kind == SURFACE_TRIANGLE && e->s->rational))
        return loft_sheet_from_triangle_rational(ENGINE_OF(engine_sheet_add)(out),
                                                 &e->as.triangle_rational);
    const int status = kind == SURFACE_TRIANGLE ? LOFT_OK : convert_surface(e);
    if (status != LOFT_OK)
        return status;
    return kind == SURFACE_TRIANGLE || kind == SURFACE_PN
               ? (int)loft_sheet_from_triangle(ENGINE_OF(engine_sheet_add)(out), &e->as.triangle)
               : tensor_sheets(&e->as.tensor, level, out);
}

static int visit_spans(const engine_surface *e, engine_net_visit *visit, void *context)
{
    const loft_nurbs_surface *s = &e->as.nurbs;
    const loft_knots *knots[2] = { &s->u, &s->v };
    loft_weighted weighted[(SURFACE_DEGREE_MAX + 1) * (SURFACE_DEGREE_MAX + 1)];
    unsigned span[2] = { 0, 0 };
    int status = LOFT_OK;

    while (status == LOFT_OK && loft_nurbs_surface_next(s, span, weighted)) {
        const unsigned m = s->u.degree, n = s->v.degree;
        engine_net_part part = { .round = false };
        loft_tensor_rational r;
        loft_tensor t;
        for (int k = 0; k < 2; k++) {
            const loft_real *at = knots[k]->k, low = at[knots[k]->degree];
            const double all = (double)at[knots[k]->points] - (double)low;
            part.from[k]  = ((double)at[span[k]] - (double)low) / all;
            part.share[k][k] = ((double)at[span[k] + 1] - (double)at[span[k]]) / all;
        }
        if (s->weighted) {
            status = loft_tensor_rational_init(&r, weighted, m, n);
            if (status == LOFT_OK)
                status = visit(context, loft_net_from_tensor_rational(&r), &part);
            continue;
        }
        for (unsigned k = 0; k < (m + 1) * (n + 1); k++)
            e->net[k] = weighted[k].p;
        status = loft_tensor_init(&t, e->net, m, n);
        if (status == LOFT_OK)
            status = visit(context, loft_net_from_tensor(&t), &part);
    }
    return status;
}

int ENGINE_OF(engine_nets)(engine_surface *e, engine_net_visit *visit, void *context)
{
    static const engine_net_part all = { .share = { { 1, 0 }, { 0, 1 } } };
    const enum surface_kind kind = e->s->kind;
    const bool weighted = e->s->rational || kind == SURFACE_OCTANT;

    if (kind == SURFACE_NURBS) {
        e->net = tool_grow(e->net,
                           (SURFACE_DEGREE_MAX + 1) * (SURFACE_DEGREE_MAX + 1) * sizeof *e->net);
        return visit_spans(e, visit, context);
    }
    if (kind == SURFACE_SPHERE)
        return ENGINE_OF(engine_ball_nets)(&e->as.sphere, visit, context);
    if (e->sided)
        return ENGINE_OF(engine_sided_nets)(e->sided, visit, context);
    if (kind == SURFACE_BICUBIC || kind == SURFACE_COONS || kind == SURFACE_PN) {
        const int status = convert_surface(e);
        if (status != LOFT_OK)
            return status;
    } else if (kind != SURFACE_TENSOR && kind != SURFACE_TRIANGLE && kind != SURFACE_OCTANT)
        return LOFT_ERR_ARG;
    if (surface_is_triangle(e->s))
        return visit(context,
                     weighted ? loft_net_from_triangle_rational(&e->as.triangle_rational)
                              : loft_net_from_triangle(&e->as.triangle),
                     &all);
    return visit(context,
                 weighted ? loft_net_from_tensor_rational(&e->as.tensor_rational)
                          : loft_net_from_tensor(&e->as.tensor),
                 &all);
}

const engine_surfaces ENGINE_OF(engine_surfaces) = { .open = surface_open,
    .close = surface_close,
    .eval  = surface_eval,
    .kite  = surface_kite,
    .look  = surface_look,
    .local = surface_local,
                                                     .contour = surface_contour };

/* host-tools/engine/engine_fit.c -- B-splines near points through the library; compiled once per
 * number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>

#include "basis/knots_basis.h"      /* loft_knots_basis */
#include "curve/fit.h"              /* loft_bspline_fit */
#include "surface/tensor/nurbs_surface.h"   /* loft_nurbs_surface_eval */
#include "surface/tensor/surface_fit.h"     /* loft_surface_fit */

#include "base/space.h"             /* space_distance */
#include "base/tool.h"              /* tool_grow */
#include "engine/engine_fit.h"

typedef struct {
    loft_vec *p, *out;
    loft_real *u, *weight, *knot;
    loft_sci *memory;
} held_fit;

static void take_room(const engine_fit *f, held_fit *h)
{
    h->p      = tool_grow(NULL, f->count * sizeof *h->p);
    h->u      = tool_grow(NULL, f->count * sizeof *h->u);
    h->weight = tool_grow(NULL, f->count * sizeof *h->weight);
    h->knot   = tool_grow(NULL, (f->points + f->degree + 1) * sizeof *h->knot);
    h->out    = tool_grow(NULL, f->points * sizeof *h->out);
    h->memory = tool_grow(NULL, LOFT_FIT_MEMORY(f->points, f->degree) * sizeof *h->memory);
}

static void give_back(held_fit *h)
{
    free(h->p);
    free(h->u);
    free(h->weight);
    free(h->knot);
    free(h->out);
    free(h->memory);
}

static bool hold_fit(const engine_fit *f, held_fit *h)
{
    for (size_t k = 0; k < f->count; k++)
        if (!vec_of(f->p[k], &h->p[k]) || !real_of(f->u[k], &h->u[k]) ||
            (f->weight && !real_of(f->weight[k], &h->weight[k])))
            return false;
    for (unsigned k = 0; k <= f->points + f->degree; k++)
        if (!real_of(f->knot[k], &h->knot[k]))
            return false;
    return true;
}

int ENGINE_OF(engine_fit_spline)(const engine_fit *f, double out[][ENGINE_AXES])
{
    held_fit h;
    int status = LOFT_ERR_RANGE;

    take_room(f, &h);
    if (hold_fit(f, &h)) {
        const loft_fit_points data = { h.p, h.u, f->weight ? h.weight : NULL, (uint32_t)f->count };
        status = loft_bspline_fit(&data, h.knot, f->points, f->degree, f->closed, h.out, h.memory);
    }
    for (unsigned k = 0; k < f->points && status == LOFT_OK; k++)
        point_of(h.out[k], out[k]);
    give_back(&h);
    return status;
}


// Surfaces
// --------

typedef struct {
    loft_vec *p, *out, *middle;
    loft_real *at[2], *knot[2];
    loft_sci *memory;
} held_grid;

static bool hold_reals(const double *from, size_t count, loft_real **out)
{
    *out = tool_grow(NULL, count * sizeof **out);
    for (size_t k = 0; k < count; k++)
        if (!real_of(from[k], &(*out)[k]))
            return false;
    return true;
}

static bool hold_grid(const engine_grid_fit *f, held_grid *h)
{
    const unsigned rows = f->count[0], m = f->points[0], n = f->points[1];
    bool fits = true;

    h->p      = tool_grow(NULL, (size_t)rows * f->count[1] * sizeof *h->p);
    h->out    = tool_grow(NULL, (size_t)m * n * sizeof *h->out);
    h->middle = tool_grow(NULL, LOFT_SURFACE_FIT_POINTS((size_t)rows, m, n) * sizeof *h->middle);
    h->memory = tool_grow(NULL,
                          (size_t)LOFT_FIT_MEMORY(m + n, LOFT_DEGREE_MAX) * sizeof *h->memory);
    for (size_t k = 0; k < (size_t)rows * f->count[1]; k++)
        fits = vec_of(f->p[k], &h->p[k]) && fits;
    for (int k = 0; k < 2; k++) {
        fits = hold_reals(f->at[k], f->count[k], &h->at[k]) && fits;
        fits = hold_reals(f->knot[k], f->points[k] + f->degree[k] + 1, &h->knot[k]) && fits;
    }
    return fits;
}

/* Raise *off to the distance of a point from its place. */
static int take_distance(const loft_nurbs_surface *s, loft_real u, loft_real v,
                         const double want[ENGINE_AXES], double *off)
{
    double got[ENGINE_AXES];
    loft_vec p;
    const int status = loft_nurbs_surface_eval(s, u, v, &p);

    if (status == LOFT_OK) {
        point_of(p, got);
        *off = fmax(*off, space_distance(got, want));
    }
    return status;
}

static int measure_grid(const engine_grid_fit *f, const held_grid *h, double *off)
{
    loft_nurbs_surface s;
    int status = loft_bspline_surface_init(&s, h->out, f->points[0], f->points[1], h->knot[0],
                                           f->degree[0], h->knot[1], f->degree[1]);

    *off = 0;
    for (unsigned i = 0; i < f->count[0]; i++)
        for (unsigned j = 0; j < f->count[1] && status == LOFT_OK; j++)
            status = take_distance(&s, h->at[0][i], h->at[1][j], f->p[(size_t)i * f->count[1] + j],
                                   off);
    return status;
}

int ENGINE_OF(engine_fit_surface)(const engine_grid_fit *f, double out[][ENGINE_AXES], double *off)
{
    held_grid h = { .p = NULL };
    int status = LOFT_ERR_RANGE;

    if (hold_grid(f, &h)) {
        const loft_fit_grid data = { h.p, h.at[0], h.at[1], (uint16_t)f->count[0],
                                     (uint16_t)f->count[1] };
        const loft_fit_net net = { h.knot[0],
                                   h.knot[1],
                                   (uint16_t)f->points[0],
                                   (uint16_t)f->points[1],
                                   (uint8_t)f->degree[0],
                                   (uint8_t)f->degree[1] };
        status = loft_surface_fit(&data, &net, h.out, h.middle, h.memory);
    }
    if (status == LOFT_OK)
        status = measure_grid(f, &h, off);
    for (size_t k = 0; k < (size_t)f->points[0] * f->points[1] && status == LOFT_OK; k++)
        point_of(h.out[k], out[k]);
    for (int k = 0; k < 2; k++) {
        free(h.at[k]);
        free(h.knot[k]);
    }
    free(h.p);
    free(h.out);
    free(h.middle);
    free(h.memory);
    return status;
}


// Points anywhere
// ---------------

int ENGINE_OF(engine_fit_basis)(const engine_net_fit *f, int axis, engine_basis out[])
{
    const unsigned degree = f->degree[axis];
    loft_real *knot, u = 0;
    loft_sci value[2][LOFT_DEGREE_MAX + 1];
    loft_knots k;
    int status = LOFT_ERR_RANGE;

    if (hold_reals(f->knot[axis], f->points[axis] + degree + 1, &knot))
        status = loft_knots_init(&k, knot, f->points[axis], degree);
    for (size_t n = 0; n < f->count && status == LOFT_OK; n++) {
        if (!real_of(f->at[n][axis], &u))
            status = LOFT_ERR_RANGE;
        u = loft_knots_clamp(&k, u);
        const unsigned span = loft_knots_find(&k, u);
        out[n].first = span - degree;
        for (unsigned order = 0; order < 2; order++)
            loft_knots_basis(&k, span, u, order, value[order]);
        for (unsigned i = 0; i <= degree; i++) {
            loft_acc wide[2] = { 0, 0 };
            if (!loft_sci_to_acc(value[0][i], &wide[0]) || !loft_sci_to_acc(value[1][i], &wide[1]))
                status = LOFT_ERR_RANGE;
            out[n].value[i] = double_of_acc(wide[0]);
            out[n].slope[i] = double_of_acc(wide[1]);
        }
    }
    free(knot);
    return status;
}

int ENGINE_OF(engine_fit_places)(const engine_net_fit *f, const double net[][ENGINE_AXES],
                                 double out[][ENGINE_AXES])
{
    const size_t points = (size_t)f->points[0] * f->points[1];
    loft_vec *const held = tool_grow(NULL, points * sizeof *held);
    loft_real *knot[2], at[2];
    loft_nurbs_surface s;
    bool fits = true;

    for (int k = 0; k < 2; k++)
        fits = hold_reals(f->knot[k], f->points[k] + f->degree[k] + 1, &knot[k]) && fits;
    for (size_t k = 0; k < points; k++)
        fits = vec_of(net[k], &held[k]) && fits;
    int status = fits ? loft_bspline_surface_init(&s, held, f->points[0], f->points[1], knot[0],
                                                  f->degree[0], knot[1], f->degree[1])
                      : LOFT_ERR_RANGE;
    for (size_t k = 0; k < f->count && status == LOFT_OK; k++) {
        loft_vec p;
        status = real_of(f->at[k][0], &at[0]) && real_of(f->at[k][1], &at[1])
                     ? loft_nurbs_surface_eval(&s, at[0], at[1], &p)
                     : LOFT_ERR_RANGE;
        if (status == LOFT_OK)
            point_of(p, out[k]);
    }
    free(held);
    free(knot[0]);
    free(knot[1]);
    return status;
}

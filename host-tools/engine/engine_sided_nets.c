/* host-tools/engine/engine_sided_nets.c -- surfaces with n sides as nets; compiled once per number
 * type
 * SPDX-License-Identifier: MIT
 */
#include "polygon/spatch_triangle.h"    /* loft_spatch_triangle */
#include "polygon/toric_tensor.h"       /* loft_toric_tensor */

#include "engine/engine_num.h"          /* double_of */
#include "engine/engine_sided_patch.h"  /* struct engine_sided */

static double balance_of(const loft_toric *t, unsigned edge)
{
    loft_acc balance = 0;

    return loft_sci_to_acc(loft_toric_balance(t, edge), &balance) ? double_of_acc(balance) : 1;
}

static int visit_quarters(const surface *s, const loft_toric *t, engine_net_visit *visit,
                          void *context)
{
    const unsigned sides = t->lattice->sides;
    loft_weighted p[LOFT_TORIC_TENSOR_MAX];
    loft_tensor_rational r;
    int status = LOFT_OK;

    for (unsigned vertex = 0; vertex < sides && status == LOFT_OK; vertex++) {
        if (loft_toric_tensor(t, vertex, p, &r) != LOFT_OK)
            return LOFT_ERR_ARG;
        const engine_net_part part = { .toric   = s,
                                       .lattice = t->lattice,
                                       .balance = { balance_of(t, (vertex + sides - 1) % sides),
                                                    balance_of(t, vertex) },
                                       .vertex = vertex };
        status = visit(context, loft_net_from_tensor_rational(&r), &part);
    }
    return status;
}

#define POINTS LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)

static int visit_basepoint(const engine_sided *e, engine_net_visit *visit, void *context)
{
    loft_vec p[POINTS];
    loft_real c[POINTS], w[POINTS];
    loft_lattice_polygon lattice;
    loft_toric t;
    const int status = loft_toric_from_basepoint(&e->as.basepoint, &lattice, p, c, w, &t);

    return status ? status : visit_quarters(e->s, &t, visit, context);
}

/* The triangles around the middle of an S-patch, where it is a quotient of polynomials of the
 * library's degrees. */
static int visit_triangles(const engine_sided *e, engine_net_visit *visit, void *context)
{
    const unsigned n = e->s->n;
    engine_net_part part = { .round = false };
    loft_weighted p[LOFT_SPATCH_TRIANGLE_MAX];
    loft_triangle_rational t;
    int status = e->s->coordinates == COORDINATES_WACHSPRESS ? LOFT_OK : LOFT_ERR_ARG;

    for (unsigned i = 0; i < n; i++)
        for (int k = 0; k < 2; k++)
            part.from[k] += double_of(e->v[i].at[k]) / n;
    for (unsigned edge = 0; edge < n && status == LOFT_OK; edge++) {
        for (unsigned corner = 0; corner < 2; corner++)
            for (int k = 0; k < 2; k++)
                part.share[k][corner] = double_of(e->v[(edge + corner) % n].at[k]) - part.from[k];
        status = loft_spatch_triangle(&e->as.spatch, &e->domain, edge, p);
        if (status == LOFT_OK)
            status = loft_triangle_rational_init(&t, p, e->s->m * (n - 2));
        if (status == LOFT_OK)
            status = visit(context, loft_net_from_triangle_rational(&t), &part);
    }
    return status;
}

int ENGINE_OF(engine_sided_nets)(const engine_sided *e, engine_net_visit *visit, void *context)
{
    switch (e->s->kind) {
    case SURFACE_TORIC:     return visit_quarters(e->s, &e->as.toric, visit, context);
    case SURFACE_BASEPOINT: return visit_basepoint(e, visit, context);
    case SURFACE_SPATCH:    return visit_triangles(e, visit, context);
    default:                return LOFT_ERR_ARG;
    }
}

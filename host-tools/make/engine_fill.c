/* host-tools/make/engine_fill.c -- patches from other surfaces: Gregory patches, fills of holes;
 * compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>

#include "polygon/hole.h"                       /* loft_gb_from_hole */
#include "surface/tensor/bicubic.h"             /* loft_tensor_from_bicubic */
#include "surface/tensor/gregory.h"             /* loft_gregory_from_coons */
#include "surface/tensor/tensor.h"              /* loft_tensor */

#include "engine/surface.h"
#include "make/engine_pieces.h"                /* write_solid */
#include "make/engine_weave.h"


// Gregory patches
// ---------------

static int gregory_of(const decide_input *in, const surface *s)
{
    loft_vec p[8][4], out[LOFT_GREGORY_POINTS];
    loft_bezier u[2][2], v[2][2];
    loft_coons_bezier c;
    int status = LOFT_OK;

    if (s->kind != SURFACE_COONS || s->orders != 2 || s->m > 3 || s->n > 3) {
        snprintf(
            in->why, DECIDE_WHY,
            "a surface that is not `coons slopes`, or above degree 3: give `coons slopes 3 3`");
        return LOFT_ERR_ARG;
    }
    for (unsigned k = 0, at = 0; k < 8 && status == LOFT_OK; k++) {
        const unsigned degree = k < 4 ? s->m : s->n, l = k % 4;
        for (unsigned i = 0; i <= degree; i++, at++)
            if (!vec_of(s->point[at].p, &p[k][i]))
                return LOFT_ERR_RANGE;
        status = loft_bezier_init(k < 4 ? &u[l / 2][l % 2] : &v[l / 2][l % 2], p[k], degree);
    }
    if (status == LOFT_OK)
        status = loft_coons_bezier_init(&c, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v,
                                        2, 0);
    if (status == LOFT_OK)
        status = loft_gregory_from_coons(&c, out);
    if (status == LOFT_OK) {
        printf("gregory\n");
        write_solid(in, out, LOFT_GREGORY_POINTS);
    }
    return status;
}

int ENGINE_OF(make_gregory)(const decide_input *in)
{
    int status = LOFT_OK;

    for (size_t i = 0; i < in->surfaces->count && status == LOFT_OK; i++)
        status = gregory_of(in, &in->surfaces->surface[i]);
    return status;
}


// Edges of neighbours
// -------------------

#define EDGES_MAX 4096

/* An edge: its curve, and the derivative across it that leaves the patch. */
typedef struct {
    loft_vec p[MOST], across[MOST];
    unsigned degree;
    bool shared;
} patch_edge;

typedef struct {
    patch_edge *edge;
    size_t count;
} edge_list;

static int tensor_net_of(const decide_input *in, const surface *s, loft_vec net[], unsigned *m,
                         unsigned *n)
{
    loft_bicubic b;

    *m = *n = 3;
    if (s->kind == SURFACE_BICUBIC) {
        for (int k = 0; k < 16; k++)
            if (!vec_of(s->point[k].p, &b.at[k / 4][k % 4]))
                return LOFT_ERR_RANGE;
        return loft_tensor_from_bicubic(&b, net);
    }
    if (s->kind != SURFACE_TENSOR || s->rational || s->m < 1 || s->n < 1) {
        snprintf(in->why, DECIDE_WHY,
                 "a neighbour that is not a tensor patch without weights: give `tensor` or "
                 "`bicubic`");
        return LOFT_ERR_ARG;
    }
    *m = s->m;
    *n = s->n;
    for (unsigned k = 0; k < s->count; k++)
        if (!vec_of(s->point[k].p, &net[k]))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

/* Side 0: v = 0, 1: u = 1, 2: v = 1, 3: u = 0; around the patch. */
static const loft_vec *net_at(const loft_vec net[], unsigned m, unsigned n, unsigned side,
                              unsigned along, unsigned across)
{
    const unsigned i = side == 0   ? along
                       : side == 1 ? m - across
                       : side == 2 ? m - along
                                   : across,
                   j = side == 0   ? across
                       : side == 1 ? along
                       : side == 2 ? n - across
                                   : n - along;

    return &net[i * (n + 1) + j];
}

static int add_edges(edge_list *all, const loft_vec net[], unsigned m, unsigned n)
{
    for (unsigned side = 0; side < 4; side++) {
        const unsigned degree = side % 2 ? n : m, depth = side % 2 ? m : n;
        patch_edge *e = &all->edge[all->count];
        if (all->count++ == EDGES_MAX)
            return LOFT_ERR_SPACE;
        e->degree = degree;
        e->shared = false;
        for (unsigned k = 0; k <= degree; k++) {
            e->p[k] = *net_at(net, m, n, side, k, 0);
            for (int i = 0; i < LOFT_AXES; i++)
                if (!real_of((double_of(e->p[k].axis[i]) -
                              double_of(net_at(net, m, n, side, k, 1)->axis[i])) *
                                 depth,
                             &e->across[k].axis[i]))
                    return LOFT_ERR_RANGE;
        }
    }
    return LOFT_OK;
}

/* Edges around patches of one sense run against each other; others run alike. */
static bool edges_equal(const patch_edge *a, const patch_edge *b)
{
    bool same = a->degree == b->degree, turned = same;

    for (unsigned k = 0; k <= a->degree && (same || turned); k++) {
        same = same && loft_vec_equal(a->p[k], b->p[k]);
        turned = turned && loft_vec_equal(a->p[k], b->p[a->degree - k]);
    }
    return same || turned;
}

static int read_edges(const decide_input *in, edge_list *all)
{
    loft_vec net[MOST * MOST];
    unsigned m, n;
    int status = LOFT_OK;

    for (size_t i = 0; i < in->surfaces->count && status == LOFT_OK; i++) {
        status = tensor_net_of(in, &in->surfaces->surface[i], net, &m, &n);
        if (status == LOFT_OK)
            status = add_edges(all, net, m, n);
    }
    for (size_t i = 0; i < all->count; i++)
        for (size_t k = i + 1; k < all->count; k++)
            if (edges_equal(&all->edge[i], &all->edge[k]))
                all->edge[i].shared = all->edge[k].shared = true;
    return status;
}

static void turn_edge(patch_edge *e)
{
    for (unsigned k = 0; 2 * k < e->degree; k++) {
        const loft_vec p = e->p[k], d = e->across[k];
        e->p[k] = e->p[e->degree - k];
        e->p[e->degree - k] = p;
        e->across[k] = e->across[e->degree - k];
        e->across[e->degree - k] = d;
    }
}

/* The only free edge that goes on from the end of `last`, turned so that it starts there. */
static patch_edge *edge_after(edge_list *all, const patch_edge *last)
{
    patch_edge *found = NULL;

    for (size_t i = 0; i < all->count; i++) {
        patch_edge *e = &all->edge[i];
        const bool starts = loft_vec_equal(e->p[0], last->p[last->degree]),
                   ends = loft_vec_equal(e->p[e->degree], last->p[last->degree]);
        if (e == last || e->shared || (!starts && !ends))
            continue;
        if (found)
            return NULL;
        if (!starts)
            turn_edge(e);
        found = e;
    }
    return found;
}

/* The loops of free edges: the one of fewest, 3 to 8. Edges that were looked at become shared. A
 * loop runs against the sense of its first neighbour, so that the fill has the same side up. */
static unsigned find_hole(edge_list *all, patch_edge best[LOFT_SIDES_MAX])
{
    unsigned least = 0;

    for (size_t i = 0; i < all->count; i++) {
        patch_edge *first = &all->edge[i], *e = first, loop[LOFT_SIDES_MAX];
        unsigned count = 0;
        if (!first->shared)
            turn_edge(first);
        while (e && !e->shared) {
            if (count < LOFT_SIDES_MAX)
                loop[count] = *e;
            count++;
            e->shared = true;
            if (loft_vec_equal(e->p[e->degree], first->p[0]))
                break;
            e = edge_after(all, e);
        }
        const bool closed = e && count > 0 && loft_vec_equal(e->p[e->degree], first->p[0]);
        if (!closed || count < 3 || count > LOFT_SIDES_MAX || (least && count >= least))
            continue;
        least = count;
        for (unsigned k = 0; k < count; k++)
            best[k] = loop[k];
    }
    return least;
}


// Filling
// -------

static void curve_value(const loft_vec p[], unsigned degree, unsigned order, double t,
                        double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        double c[MOST];
        unsigned n = degree;
        for (unsigned k = 0; k <= n; k++)
            c[k] = double_of(p[k].axis[i]);
        for (unsigned o = 0; o < order; o++, n--)
            for (unsigned k = 0; k < n; k++)
                c[k] = n * (c[k + 1] - c[k]);
        for (; n > 0; n--)
            for (unsigned k = 0; k < n; k++)
                c[k] += (c[k + 1] - c[k]) * t;
        out[i] = c[0];
    }
}

static void cross(const double a[ENGINE_AXES], const double b[ENGINE_AXES], double out[ENGINE_AXES])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double angle_between(const double a[ENGINE_AXES], const double b[ENGINE_AXES])
{
    double c[ENGINE_AXES], dot = 0, sine = 0;

    cross(a, b, c);
    for (int i = 0; i < ENGINE_AXES; i++) {
        dot += a[i] * b[i];
        sine += c[i] * c[i];
    }
    return atan2(sqrt(sine), fabs(dot)) * 180 / acos(-1);
}

/* The largest angle between the tangent planes of the patch and of its neighbour along side i: that
 * of the patch holds the edge and the second row. */
static double side_angle(const patch_edge *e, const loft_vec net[], const loft_vec split[],
                         unsigned sides, unsigned degree, unsigned i)
{
    loft_vec row[2][MOST], leg[MOST];
    double most = 0;

    for (unsigned j = 0; j <= degree; j++) {
        row[0][j] = net[loft_gb_place(sides, degree, i, j, 0)];
        row[1][j] = j + 1 == degree ? split[(i + 1) % sides]
                                    : net[loft_gb_place(sides, degree, i, j, 1)];
        leg[j] = loft_vec_sub(row[1][j], row[0][j]);
    }
    for (int k = 0; k <= 64; k++) {
        double along[ENGINE_AXES], across[ENGINE_AXES], mine[ENGINE_AXES], theirs[ENGINE_AXES];
        curve_value(row[0], degree, 1, k / 64.0, along);
        curve_value(leg, degree, 0, k / 64.0, across);
        cross(along, across, mine);
        curve_value(e->p, e->degree, 1, k / 64.0, along);
        curve_value(e->across, e->degree, 0, k / 64.0, across);
        cross(along, across, theirs);
        most = fmax(most, angle_between(mine, theirs));
    }
    return most;
}

static int fill_hole(const decide_input *in, const patch_edge edge[], unsigned sides,
                     unsigned degree)
{
    loft_vec net[SURFACE_SIDES_MAX * 25 + 1], split[SURFACE_SIDES_MAX];
    loft_hole_side side[SURFACE_SIDES_MAX];
    double most = 0;
    loft_acc gap;
    int status = LOFT_OK;

    for (unsigned i = 0; i < sides && status == LOFT_OK; i++) {
        status = loft_bezier_init(&side[i].edge, edge[i].p, edge[i].degree);
        if (status == LOFT_OK)
            status = loft_bezier_init(&side[i].across, edge[i].across, edge[i].degree);
    }
    if (status == LOFT_OK)
        status = loft_gb_from_hole(side, sides, degree, net, split, &gap);
    if (status == LOFT_SINGULAR)
        snprintf(in->why, DECIDE_WHY,
                 "no tangent plane at a corner of the hole, or an edge there leads away from it");
    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i < sides; i++)
        most = fmax(most, side_angle(&edge[i], net, split, sides, degree, i));
    printf("gb %u %u split\n# tangent planes within %s degrees\n", sides, degree, bound_text(most));
    write_solid(in, net, loft_gb_count(sides, degree));
    write_solid(in, split, sides);
    return status;
}

int ENGINE_OF(make_fill)(const decide_input *in)
{
    edge_list all = { tool_grow(NULL, (EDGES_MAX + 1) * sizeof *all.edge), 0 };
    patch_edge hole[SURFACE_SIDES_MAX];
    unsigned sides = 0, degree = 5;
    int status = read_edges(in, &all);

    if (status == LOFT_OK && (sides = find_hole(&all, hole)) == 0) {
        snprintf(in->why, DECIDE_WHY,
                 "no hole with 3 to 8 sides: at each corner two free edges must meet, and no more");
        status = LOFT_ERR_ARG;
    }
    for (unsigned i = 0; i < sides; i++)
        degree = hole[i].degree + 1 > degree ? hole[i].degree + 1 : degree;
    if (in->of->count == 1)
        degree = (unsigned)in->of->value[0];
    if (status == LOFT_OK && degree > SURFACE_DEGREE_MAX) {
        snprintf(in->why, DECIDE_WHY, "an edge of degree 9: lower it to 8");
        status = LOFT_ERR_ARG;
    }
    if (status == LOFT_OK)
        status = fill_hole(in, hole, sides, degree);
    free(all.edge);
    return status;
}

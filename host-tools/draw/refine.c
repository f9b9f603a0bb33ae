/* host-tools/draw/refine.c -- halves triangles where the surface leaves them
 * SPDX-License-Identifier: MIT
 *
 * All surfaces begin with grids of one number of cells, so that neighbours have the same corners.
 * Whether an edge is halved depends on the line on the surface over it alone. So both neighbours
 * agree, and no corner lies within an edge. A triangle whose edges are near enough, but not its
 * middle, halves its longest edge. Nodes and middles of edges of different surfaces that are within
 * a quarter of the tolerance are one; edges are halved at three quarters of it.
 *
 * Only sides of surfaces are shared with others: two lines inside may have the same ends.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/space.h"     /* space_distance */
#include "base/host.h"
#include "base/memory.h"
#include "draw/refine.h"
#include "num/status.h"     /* LOFT_OK */

#define NONE        SIZE_MAX
#define TRIANGLES   4000000

typedef struct {
    size_t node, next;
} listed_node;

/* The work on one surface. */
typedef struct {
    refined *r;
    const surfaces *all;
    const engine *e;
    const engine_surface *held;
    size_t surface;             /* its number */
    double near, far;           /* points that are one; a line that leaves its edge */
    listed_node *listed;        /* nodes by place, until all surfaces have begun */
    size_t *cube, cubes, lists, list_room;
} work;

static void *room_for(void *old, size_t used, size_t *room, size_t bytes)
{
    if (used < *room)
        return old;
    *room = *room ? 2 * *room : 1024;
    return memory_grow(old, *room * bytes);
}

static size_t add_node(refined *r, const double p[ENGINE_AXES])
{
    r->node = room_for(r->node, r->nodes, &r->room[0], sizeof *r->node);
    memcpy(r->node[r->nodes], p, sizeof *r->node);
    return r->nodes++;
}

static void add_triangle(work *w, unsigned kite, refined_place a, refined_place b, refined_place c)
{
    refined *r = w->r;

    if (a.node == b.node || b.node == c.node || c.node == a.node)
        return;
    r->triangle = room_for(r->triangle, r->triangles, &r->room[1], sizeof *r->triangle);
    r->triangle[r->triangles++] = (refined_triangle){
        .surface = w->surface, .kite = kite, .edge = { NONE, NONE, NONE }, .at = { a, b, c }
    };
}


// Edges
// -----

/* The sides of its kite on which a place is. Bits: u = 0, u = 1, v = 0, v = 1, u + v = 1. */
static unsigned sides_of(const surface *s, const refined_place *x)
{
    const bool triangle = surface_is_triangle(s);

    return (x->u <= 0 ? 1u : 0) | (!triangle && x->u >= 1 ? 2u : 0) | (x->v <= 0 ? 4u : 0) |
           (!triangle && x->v >= 1 ? 8u : 0) | (triangle && x->u + x->v >= 1 ? 16u : 0) |
           (x->open & 1 ? 3u : 0) | (x->open & 2 ? 12u : 0);
}

/* A place between two others. */
static refined_place place_between(const refined_place *a, const refined_place *b, double share)
{
    const double u0 = a->open & 1 ? b->u : a->u, u1 = b->open & 1 ? a->u : b->u;
    const double v0 = a->open & 2 ? b->v : a->v, v1 = b->open & 2 ? a->v : b->v;

    return (refined_place){ u0 + share * (u1 - u0), v0 + share * (v1 - v0), NONE, 0 };
}

/* Edges that may be shared have a hash of their nodes alone. */
static size_t hash_of(size_t a, size_t b, size_t owner)
{
    const size_t low = a < b ? a : b, high = a < b ? b : a;
    const uint64_t mixed = low * UINT64_C(0x9e3779b97f4a7c15) ^
                           high * UINT64_C(0xc2b2ae3d27d4eb4f) ^
                           owner * UINT64_C(0x165667b19e3779f9);
    return (size_t)(mixed >> 16);
}

/* As many slots as edges keep chains short. */
static void spread_edges(refined *r)
{
    if (r->edges < r->slots)
        return;
    r->slots = r->slots ? 2 * r->slots : 1024;
    r->first = memory_grow(r->first, r->slots * sizeof *r->first);
    for (size_t k = 0; k < r->slots; k++)
        r->first[k] = NONE;
    for (size_t k = 0; k < r->edges; k++) {
        size_t *first = &r->first[r->edge[k].hash % r->slots];
        r->edge[k].next = *first;
        *first = k;
    }
}

static int point_at(const work *w, unsigned kite, const refined_place *x, double out[ENGINE_AXES])
{
    return w->e->surface->kite(w->held, kite, x->u, x->v, out);
}

static int new_edge(work *w, unsigned kite, const refined_place *a, const refined_place *b,
                    const double middle[ENGINE_AXES], size_t hash)
{
    refined *r = w->r;
    refined_edge made = { { a->node, b->node }, NONE, NONE, hash, { 0 }, false };

    memcpy(made.middle, middle, sizeof made.middle);
    for (int k = 1; k <= 3 && !made.split; k++) {
        const refined_place at = place_between(a, b, k / 4.0);
        double p[ENGINE_AXES];
        const int status = point_at(w, kite, &at, p);
        if (status != LOFT_OK)
            return status;
        made.split = space_segment_distance(p, r->node[a->node], r->node[b->node]) > w->far;
    }
    r->edge = room_for(r->edge, r->edges, &r->room[2], sizeof *r->edge);
    spread_edges(r);
    made.next = r->first[hash % r->slots];
    r->edge[r->edges] = made;
    r->first[hash % r->slots] = r->edges++;
    return LOFT_OK;
}

static bool is_edge(const work *w, const refined_edge *e, size_t a, size_t b,
                    const double middle[ENGINE_AXES])
{
    return ((e->node[0] == a && e->node[1] == b) || (e->node[0] == b && e->node[1] == a)) &&
           space_distance(e->middle, middle) <= w->near;
}

static int find_edge(work *w, unsigned kite, const refined_place *a, const refined_place *b,
                     size_t *out)
{
    refined *r = w->r;
    const surface *s = &w->all->surface[w->surface];
    const bool side = (sides_of(s, a) & sides_of(s, b)) != 0;
    const size_t owner = side ? 0 : (w->surface + 1) * 64 + kite;
    const size_t hash = hash_of(a->node, b->node, owner);
    const refined_place half = place_between(a, b, 0.5);
    double middle[ENGINE_AXES];
    int status = point_at(w, kite, &half, middle);

    spread_edges(r);
    for (*out = r->first[hash % r->slots]; *out != NONE && status == LOFT_OK;
         *out = r->edge[*out].next)
        if (r->edge[*out].hash == hash && is_edge(w, &r->edge[*out], a->node, b->node, middle))
            return LOFT_OK;
    if (status == LOFT_OK)
        status = new_edge(w, kite, a, b, middle, hash);
    *out = r->edges - 1;
    return status;
}


// Triangles
// ---------

static refined_place middle_of(const refined_triangle *t)
{
    refined_place out = { 0, 0, NONE, 0 };
    int u = 0, v = 0;

    for (int k = 0; k < 3; k++) {
        if (!(t->at[k].open & 1)) {
            out.u += t->at[k].u;
            u++;
        }
        if (!(t->at[k].open & 2)) {
            out.v += t->at[k].v;
            v++;
        }
    }
    out.u /= u ? u : 1;
    out.v /= v ? v : 1;
    return out;
}

static double distance_to_plane(const double p[3], const double a[3], const double b[3],
                                const double c[3])
{
    double across = 0, length = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double n = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
        across += n * (p[i] - a[i]);
        length += n * n;
    }
    return length > 0 ? fabs(across) / sqrt(length) : 0;
}

/* Find its edges; where they are near enough and its middle is not, the longest is halved. */
static int look_at_triangle(work *w, refined_triangle *t)
{
    const refined *r = w->r;
    const refined_place middle = middle_of(t);
    double p[ENGINE_AXES], longest = -1;
    size_t most = NONE;
    bool split = false;
    int status = LOFT_OK;

    t->looked = true;
    for (int k = 0; k < 3 && status == LOFT_OK; k++) {
        const refined_place *a = &t->at[k], *b = &t->at[(k + 1) % 3];
        status = find_edge(w, t->kite, a, b, &t->edge[k]);
        const double length = space_distance(r->node[a->node], r->node[b->node]);
        split = split || (status == LOFT_OK && r->edge[t->edge[k]].split);
        if (length > longest) {
            longest = length;
            most = t->edge[k];
        }
    }
    if (status == LOFT_OK && !split)
        status = point_at(w, t->kite, &middle, p);
    if (status == LOFT_OK && !split &&
        distance_to_plane(p, r->node[t->at[0].node], r->node[t->at[1].node],
                          r->node[t->at[2].node]) > w->far)
        r->edge[most].split = true;
    return status;
}

/* The middle of an edge as a corner of this triangle. */
static refined_place split_place(work *w, const refined_triangle *t, int k)
{
    refined *r = w->r;
    refined_edge *e = &r->edge[t->edge[k]];
    refined_place out = place_between(&t->at[k], &t->at[(k + 1) % 3], 0.5);

    if (e->middle_node == NONE)
        e->middle_node = add_node(r, e->middle);
    out.node = e->middle_node;
    return out;
}

/* Into two, three or four. */
static void split_triangle(work *w, size_t number)
{
    const refined_triangle t = w->r->triangle[number];
    refined_place half[3];
    unsigned splits = 0;
    int one = 0, rest = 0;

    for (int k = 0; k < 3; k++) {
        const bool split = w->r->edge[t.edge[k]].split;
        if (split)
            half[k] = split_place(w, &t, k);
        splits += split;
        *(split ? &one : &rest) = k;
    }
    if (splits == 1) {
        const int b = (one + 1) % 3, c = (one + 2) % 3;
        add_triangle(w, t.kite, t.at[one], half[one], t.at[c]);
        add_triangle(w, t.kite, half[one], t.at[b], t.at[c]);
    } else if (splits == 2) {           /* corner z has both; a b is whole */
        const int a = rest, b = (rest + 1) % 3, z = (rest + 2) % 3;
        add_triangle(w, t.kite, half[b], t.at[z], half[z]);
        add_triangle(w, t.kite, t.at[a], t.at[b], half[b]);
        add_triangle(w, t.kite, t.at[a], half[b], half[z]);
    } else {
        for (int k = 0; k < 3; k++)
            add_triangle(w, t.kite, t.at[k], half[k], half[(k + 2) % 3]);
        add_triangle(w, t.kite, half[0], half[1], half[2]);
    }
    w->r->triangles--;          /* the last of them takes its place */
    w->r->triangle[number] = w->r->triangle[w->r->triangles];
}

static bool is_split(const refined *r, const refined_triangle *t)
{
    return r->edge[t->edge[0]].split || r->edge[t->edge[1]].split || r->edge[t->edge[2]].split;
}


// Surfaces
// --------

/* Space is divided into cubes; nodes of cubes with one hash are a list. */
static size_t *cube_of(const work *w, const double p[ENGINE_AXES], unsigned corner, double by)
{
    uint64_t hash = 0;

    for (int i = 0; i < ENGINE_AXES; i++) {
        const double x = floor((p[i] + (corner >> i & 1 ? by : -by)) / (8 * w->near));
        hash = (hash ^ (uint64_t)(int64_t)x) * UINT64_C(0x9e3779b97f4a7c15);
    }
    return &w->cube[(hash >> 20) % w->cubes];
}

/* A node that is near, or a new one. It is listed in all cubes that are near it, at most eight. */
static size_t share_node(work *w, const double p[ENGINE_AXES])
{
    refined *r = w->r;
    size_t *list[8];

    for (size_t k = *cube_of(w, p, 0, 0); k != NONE; k = w->listed[k].next)
        if (space_distance(r->node[w->listed[k].node], p) <= w->near)
            return w->listed[k].node;
    const size_t made = add_node(r, p);
    for (unsigned corner = 0; corner < 8; corner++) {
        bool known = false;
        list[corner] = cube_of(w, p, corner, w->near);
        for (unsigned k = 0; k < corner; k++)
            known = known || list[k] == list[corner];
        if (known)
            continue;
        w->listed = room_for(w->listed, w->lists, &w->list_room, sizeof *w->listed);
        w->listed[w->lists] = (listed_node){ made, *list[corner] };
        *list[corner] = w->lists++;
    }
    return made;
}

/* True if the side that begins at cell corner k of a grid, toward the next, is one point. */
static void open_ends(refined_place at[4], bool along_u[4])
{
    for (int k = 0; k < 4; k++) {
        refined_place *a = &at[k], *b = &at[(k + 1) % 4];
        if (a->node == b->node) {
            a->open |= along_u[k] ? 1 : 2;
            b->open |= along_u[k] ? 1 : 2;
        }
    }
}

static void add_cell(work *w, unsigned kite, refined_place at[4])
{
    bool along_u[4] = { true, false, true, false };

    open_ends(at, along_u);
    add_triangle(w, kite, at[0], at[1], at[2]);
    add_triangle(w, kite, at[0], at[2], at[3]);
}

static int begin_kite(work *w, unsigned kite, unsigned n)
{
    const surface *s = &w->all->surface[w->surface];
    const bool triangle = surface_is_triangle(s);
    refined_place *at = memory_grow(NULL, (size_t)(n + 1) * (n + 1) * sizeof *at);
    int status = LOFT_OK;

    for (unsigned i = 0; i <= n; i++)
        for (unsigned j = 0; j <= (triangle ? n - i : n) && status == LOFT_OK; j++) {
            refined_place *x = &at[i * (n + 1) + j];
            double p[ENGINE_AXES];
            *x = (refined_place){ i / (double)n, j / (double)n, NONE, 0 };
            status = point_at(w, kite, x, p);
            if (status == LOFT_OK)
                x->node = share_node(w, p);
        }
    for (unsigned i = 0; i < n && status == LOFT_OK; i++)
        for (unsigned j = 0; j < (triangle ? n - i : n); j++) {
            const refined_place *low = &at[i * (n + 1) + j], *high = low + n + 1;
            refined_place cell[4] = { low[0], high[0], low[1], low[1] };
            if (triangle)
                add_triangle(w, kite, cell[0], cell[1], cell[2]);
            if (triangle && i + j + 1 < n)
                add_triangle(w, kite, high[0], high[1], low[1]);
            cell[2] = high[1];
            if (!triangle)
                add_cell(w, kite, cell);
        }
    free(at);
    return status;
}

/* The cells along a side that its degree or its kind asks for. */
static unsigned cells_of(const surface *s)
{
    switch (s->kind) {
    case SURFACE_TENSOR:
    case SURFACE_TRIANGLE: return s->m > s->n ? s->m : s->n;
    case SURFACE_COONS:    return (s->m > s->n ? s->m : s->n) + 2 * (s->orders - 1);
    case SURFACE_NURBS:    return 2 * (s->rows > s->columns ? s->rows : s->columns);
    case SURFACE_SPHERE:   return 8;
    default:               return 4;
    }
}

static unsigned cells_of_all(const surfaces *all)
{
    unsigned n = 1;

    for (size_t k = 0; k < all->count; k++)
        while (n < cells_of(&all->surface[k]) + surface_is_sided(&all->surface[k]) && n < 64)
            n *= 2;
    return n;
}

/* Look at the triangles that are new; *more: some edge is halved. */
static int look_at_all(work *w, engine_surface *const held[], bool *more)
{
    int status = LOFT_OK;

    for (size_t k = 0; k < w->r->triangles && status == LOFT_OK; k++)
        if (!w->r->triangle[k].looked) {
            w->surface = w->r->triangle[k].surface;
            w->held = held[w->surface];
            status = look_at_triangle(w, &w->r->triangle[k]);
        }
    *more = false;
    for (size_t k = 0; k < w->r->triangles && status == LOFT_OK; k++)
        *more = *more || is_split(w->r, &w->r->triangle[k]);
    return status;
}

static void split_all(work *w)
{
    for (size_t k = w->r->triangles; k-- > 0; )
        if (is_split(w->r, &w->r->triangle[k])) {
            w->surface = w->r->triangle[k].surface;
            split_triangle(w, k);
        }
}

static int refine_all(work *w, engine_surface *const held[])
{
    bool more = true;
    int status = LOFT_OK;

    while (more && status == LOFT_OK && w->r->triangles < TRIANGLES) {
        status = look_at_all(w, held, &more);
        if (more && status == LOFT_OK)
            split_all(w);
    }
    return status == LOFT_OK && more ? LOFT_ERR_SPACE : status;
}

static void close_all(const work *w, engine_surface *held[], size_t count)
{
    while (count-- > 0)
        w->e->surface->close(held[count]);
    free(held);
    free(w->listed);
    free(w->cube);
}

static int begin_all(work *w, engine_surface *held[], size_t *count)
{
    const unsigned n = cells_of_all(w->all);
    int status = LOFT_OK;

    for (*count = 0; *count < w->all->count && status == LOFT_OK; ) {
        const surface *s = &w->all->surface[*count];
        const unsigned cells = surface_is_sided(s) && n > 1 ? n / 2 : n;
        w->surface = *count;
        status = w->e->surface->open(s, &held[*count]);
        if (status != LOFT_OK)
            return status;
        w->held = held[(*count)++];
        for (unsigned kite = 0; kite < surface_kites(s) && status == LOFT_OK; kite++)
            status = begin_kite(w, kite, cells);
    }
    return status;
}

int refine_surfaces(host *h, refined *r, const surfaces *all, const char *file, const engine *e,
                    double tol)
{
    work w = { .r = r, .all = all, .e = e, .near = tol / 4, .far = 0.75 * tol, .cubes = 65536 };
    engine_surface **held = memory_grow(NULL, all->count * sizeof *held);
    size_t opened;

    w.cube = memory_grow(NULL, w.cubes * sizeof *w.cube);
    for (size_t k = 0; k < w.cubes; k++)
        w.cube[k] = NONE;
    int status = begin_all(&w, held, &opened);
    if (status == LOFT_OK)
        status = refine_all(&w, held);
    close_all(&w, held, opened);
    if (status == LOFT_OK)
        return 0;
    const surface *s = &all->surface[w.surface];
    return status == LOFT_ERR_SPACE
               ? host_error(h, EX_DATAERR, "mesh.too-many", (host_place){ file, 0 },
                            "give a larger one", "--tol %g: more than %d triangles", tol, TRIANGLES)
               : host_error(h, EX_DATAERR, "surface.not-computed", (host_place){ file, s->line },
                            NULL, "%s: %s", surface_name(s->kind), surface_status(s, status));
}

void refined_free(refined *r)
{
    free(r->node);
    free(r->triangle);
    free(r->edge);
    free(r->first);
    *r = (refined){ 0 };
}

/* host-tools/engine/sided.c -- surfaces with n sides: polygons, kites and nets
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "polygon/basepoint.h"      /* loft_basepoint_side_of */
#include "polygon/gb.h"             /* loft_gb_count */
#include "polygon/zheng_ball.h"     /* loft_zheng_ball_count */
#include "polygon/spatch.h"         /* loft_links */

#include "engine/sided.h"

#define NOTHING 1e-9            /* of a kite: closer to a side than this is on the side */

unsigned sided_count(const surface *s) { return s->n; }


// Polygons
// --------

/* Numbers next to 0 that are left by cancellation are finer than the numbers that the library
 * decides on exactly. */
static double rounded(double x) { return nearbyint(x * 0x1p52) / 0x1p52; }

void sided_regular(surface *s)
{
    for (unsigned i = 0; i < s->n; i++) {
        s->domain[i][0] = rounded(-sin(2 * M_PI * i / s->n));
        s->domain[i][1] = rounded(cos(2 * M_PI * i / s->n));
    }
    s->corners = s->n;
}

static bool lattice_of(const surface *s, loft_lattice_polygon *out)
{
    loft_whole v[SURFACE_SIDES_MAX];

    for (unsigned i = 0; i < s->corners; i++)
        for (int k = 0; k < 2; k++) {
            if (!(fabs(s->domain[i][k]) <= LOFT_LATTICE_MAX) ||
                s->domain[i][k] != floor(s->domain[i][k]))
                return false;
            v[i].at[k] = (int8_t)s->domain[i][k];
        }
    return loft_lattice_polygon_init(out, v, s->corners) == LOFT_OK;
}

bool sided_is_lattice(const surface *s)
{
    loft_lattice_polygon lattice;
    return lattice_of(s, &lattice);
}

/* The corners of the triangle that base points cut off. */
static unsigned cut_corners(const surface *s)
{
    unsigned count = 0;

    for (int i = 0; i < 3; i++)
        count += s->cut[i] * (s->cut[i] + 1) / 2;
    return count;
}

unsigned sided_points(const surface *s)
{
    loft_lattice_polygon lattice;

    switch (s->kind) {
    case SURFACE_SPATCH:    return loft_multiindex_count(s->n, s->m);
    case SURFACE_TORIC: return lattice_of(s, &lattice) ? loft_lattice_polygon_count(&lattice) : 0;
    case SURFACE_BASEPOINT: return loft_multiindex_count(3, s->m) - cut_corners(s);
    case SURFACE_GB:        return loft_gb_count(s->n, s->m) + (s->split ? s->n : 0);
    default:                return loft_zheng_ball_count(s->n, s->m);
    }
}


// Kites
// -----

/* The u_(i-1) that equals u_(i+1) when u_i = b: the middle line of side i. polygon/disk.c has the
 * equations. */
static double balanced_parameter(unsigned sides, double b)
{
    double low = 0, high = 1;

    for (int i = 0; i < 60; i++) {
        const double a = (low + high) / 2;
        const double over = sides == 5 ? 2 * a - 1 - b * a * a
                                       : 4 * a * a - 1 - a * b - 2 * a * a * a * b;
        *(over > 0 ? &high : &low) = a;
    }
    return (low + high) / 2;
}

/* The value of all parameters in the middle. */
static double middle_parameter(unsigned sides)
{
    double low = 0, high = 1;

    for (int i = 0; i < 60; i++) {
        const double b = (low + high) / 2;
        *(balanced_parameter(sides, b) < b ? &high : &low) = b;
    }
    return (low + high) / 2;
}

/* The shares of the three corners of a triangle: this, next and last. On the lines s = 1 and t = 1
 * two shares are equal. */
static sided_place triangle_kite(unsigned k, double s, double t)
{
    const double whole = 1 - s * t / 4;

    return (sided_place){ SIDED_CORNER, k, s / 2 * (1 - t / 2) / whole,
                          t / 2 * (1 - s / 2) / whole };
}

/* Straight lines between the sides and the curves in which the kites meet. */
static sided_place zheng_ball_kite(unsigned sides, unsigned k, double s, double t)
{
    if (sides == 3)
        return triangle_kite(k, s, t);
    const double middle = middle_parameter(sides);
    return (sided_place){ SIDED_CORNER, k, s * balanced_parameter(sides, middle * t),
                          t * balanced_parameter(sides, middle * s) };
}

/* A corner of the patch: the begin or end of a side at a cut corner of the triangle, or an uncut
 * corner. Corner c lacks v to 1; w and 1 - w are the fractions of v that the next and the last
 * corner have. */
static sided_place basepoint_kite(const surface *patch, unsigned k, double s, double t)
{
    const loft_basepoint b = { .degree = (uint8_t)patch->m,
                               .cut = { (uint8_t)patch->cut[0], (uint8_t)patch->cut[1],
                                        (uint8_t)patch->cut[2] } };
    const loft_basepoint_side side = loft_basepoint_side_of(&b, k);
    double w, v;

    if (side.cut) {
        w = s / 2;
        v = t / (2 - w);
    } else if (patch->cut[side.corner] > 0) {
        w = 1 - t / 2;
        v = s / (1 + w);
    } else {
        const sided_place at = triangle_kite(side.corner, s, t);
        v = at.u + at.v;
        w = v > 0 ? at.u / v : 0;
    }
    return (sided_place){ SIDED_CORNER, side.corner, 1 - w, v };
}

/* A kite: its part, its corner of the part, and the vertices there, before it and after it. */
typedef struct {
    unsigned part, corner, first;       /* first: the kite at corner 0 of the part */
    unsigned vertex, before, after;
} kite_corner;

static kite_corner corner_of(const surface *s, unsigned kite)
{
    kite_corner k = { 0, 0, 0, 0, 0, 0 };

    while (kite - k.first >= s->part[k.part].sides)
        k.first += s->part[k.part++].sides;
    const surface_part *p = &s->part[k.part];
    k.corner = kite - k.first;
    k.vertex = p->vertex[k.corner];
    k.before = p->vertex[(k.corner + p->sides - 1) % p->sides];
    k.after  = p->vertex[(k.corner + 1) % p->sides];
    return k;
}

static bool is_side(const surface *s, unsigned from, unsigned to)
{
    return to == (from + 1) % s->n;
}

/* Between two sides of a convex polygon and its middle: no cell of this grid is inverted. */
static sided_place polygon_kite(const surface *patch, unsigned kite, double s, double t)
{
    const kite_corner k = corner_of(patch, kite);
    const surface_part *part = &patch->part[k.part];
    const double *v = patch->domain[k.vertex], *before = patch->domain[k.before],
                 *after = patch->domain[k.after];
    double x[2];

    if (s < NOTHING && t < NOTHING)
        return (sided_place){ SIDED_SIDE, k.vertex, 0, 0 };
    if (t < NOTHING && is_side(patch, k.vertex, k.after))
        return (sided_place){ SIDED_SIDE, k.vertex, s / 2, 0 };
    if (s < NOTHING && is_side(patch, k.before, k.vertex))
        return (sided_place){ SIDED_SIDE, k.before, 1 - t / 2, 0 };
    for (int j = 0; j < 2; j++) {
        double middle = 0;
        for (unsigned i = 0; i < part->sides; i++)
            middle += patch->domain[part->vertex[i]][j] / part->sides;
        x[j] = rounded((1 - s) * (1 - t) * v[j] + s * (1 - t) * (v[j] + after[j]) / 2 +
                       (1 - s) * t * (v[j] + before[j]) / 2 + s * t * middle);
    }
    return (sided_place){ SIDED_WITHIN, 0, x[0], x[1] };
}

sided_place sided_kite(const surface *patch, unsigned k, double s, double t)
{
    switch (patch->kind) {
    case SURFACE_RING:      return zheng_ball_kite(patch->n, k, s, t);
    case SURFACE_BASEPOINT: return basepoint_kite(patch, k, s, t);
    default:                return polygon_kite(patch, k, s, t);
    }
}

bool sided_is_border(const surface *patch, unsigned kite, bool before)
{
    const kite_corner k = corner_of(patch, kite);
    return before ? is_side(patch, k.before, k.vertex) : is_side(patch, k.vertex, k.after);
}

/* The first kite at `vertex` in the parts before `part` that have the side from `vertex` to
 * `beside`, or, with `back`, from `beside` to `vertex`. Returns false if there is none. */
static bool earlier_kite(const surface *s, unsigned part, unsigned vertex, unsigned beside,
                         bool back, unsigned *out)
{
    for (unsigned kite = 0; kite < surface_kites(s); kite++) {
        const kite_corner k = corner_of(s, kite);
        if (k.part >= part)
            return false;
        if (k.vertex == vertex && (beside == vertex || (back ? k.before : k.after) == beside)) {
            *out = kite;
            return true;
        }
    }
    return false;
}

/* Go one step from a name of a grid node towards the name that is used; the name itself if it is
 * that one. */
static sided_node next_node_name(const surface *s, sided_node at, unsigned half)
{
    const kite_corner k = corner_of(s, at.kite);
    const unsigned sides = s->part[k.part].sides;
    unsigned kite;

    if (at.i == half && at.j == half)
        return (sided_node){ k.first, half, half };
    if (at.j == half)
        return (sided_node){ k.first + (k.corner + sides - 1) % sides, half, at.i };
    if (at.i == 0 && at.j == 0 && earlier_kite(s, k.part, k.vertex, k.vertex, false, &kite))
        return (sided_node){ kite, 0, 0 };
    if (at.j == 0 && at.i > 0 && earlier_kite(s, k.part, k.vertex, k.after, true, &kite))
        return (sided_node){ kite, 0, at.i };
    if (at.i == 0 && at.j > 0 && earlier_kite(s, k.part, k.vertex, k.before, false, &kite))
        return (sided_node){ kite, at.j, 0 };
    return at;
}

sided_node sided_owner(const surface *patch, sided_node at, unsigned half)
{
    sided_node next = next_node_name(patch, at, half);

    while (next.kite != at.kite || next.i != at.i || next.j != at.j) {
        at   = next;
        next = next_node_name(patch, at, half);
    }
    return at;
}

static bool is_over_polygon(const surface *s)
{
    return s->kind == SURFACE_SPATCH || s->kind == SURFACE_TORIC || s->kind == SURFACE_GB;
}

bool sided_has(const surface *patch, double x, double y)
{
    if (!is_over_polygon(patch))
        return true;
    for (unsigned k = 0; k < patch->parts; k++) {
        const surface_part *p = &patch->part[k];
        unsigned inside = 0;
        for (unsigned i = 0; i < p->sides; i++) {
            const double *a = patch->domain[p->vertex[i]],
                         *b = patch->domain[p->vertex[(i + 1) % p->sides]];
            inside += (b[0] - a[0]) * (y - a[1]) >= (b[1] - a[1]) * (x - a[0]);
        }
        if (inside == p->sides)
            return true;
    }
    return false;
}

void sided_spot(const surface *patch, sided_place at, double out[2])
{
    const double *from = patch->domain[at.k],
                 *to = patch->domain[(at.k + 1) % SURFACE_SIDES_MAX % sided_count(patch)];

    for (int j = 0; j < 2; j++)
        out[j] = !is_over_polygon(patch) ? 0
                 : at.how == SIDED_SIDE  ? from[j] + at.u * (to[j] - from[j])
                 : j == 0                ? at.u
                                         : at.v;
}

sided_place sided_middle(const surface *patch)
{
    if (patch->kind == SURFACE_RING) {
        const double u = patch->n == 3 ? (sqrt(3) - 1) / 2 : middle_parameter(patch->n);
        return (sided_place){ SIDED_OWN, 0, u, u };
    }
    if (patch->kind == SURFACE_BASEPOINT)
        return (sided_place){ SIDED_OWN, 0, 1 / 3.0, 1 / 3.0 };
    return sided_kite(patch, 0, 1, 1);
}


// Nets
// ----

static void spatch_net(const surface *s, sided_edge *each, void *context)
{
    loft_links w;
    unsigned l, m;

    loft_links_start(&w, s->n, s->m);
    while (loft_links_next(&w, &l, &m))
        each(context, &s->point[l], &s->point[m]);
}

/* The index of a lattice point among those of the polygon; their count if it is not one of them. */
static unsigned lattice_index(const loft_lattice_polygon *lattice, int x, int y)
{
    loft_whole l;
    unsigned k = 0;

    loft_lattice_polygon_first(lattice, &l);
    do {
        if (l.at[0] == x && l.at[1] == y)
            return k;
        k++;
    } while (loft_lattice_polygon_next(lattice, &l));
    return k;
}

/* Steps along x and y, and along the edges. */
static void toric_net(const surface *s, sided_edge *each, void *context)
{
    loft_lattice_polygon lattice;
    loft_whole l;
    unsigned k = 0;

    if (!lattice_of(s, &lattice))
        return;
    loft_lattice_polygon_first(&lattice, &l);
    do {
        const unsigned right = lattice_index(&lattice, l.at[0] + 1, l.at[1]),
                       up = lattice_index(&lattice, l.at[0], l.at[1] + 1);
        if (right < s->count)
            each(context, &s->point[k], &s->point[right]);
        if (up < s->count)
            each(context, &s->point[k], &s->point[up]);
        k++;
    } while (loft_lattice_polygon_next(&lattice, &l));
    for (unsigned i = 0; i < lattice.sides; i++) {
        const loft_lattice_edge *e = &lattice.edge[i];
        const int x = e->normal.at[1], y = -e->normal.at[0];
        for (int step = 0; step < e->length && x != 0 && y != 0; step++)
            each(context,
                 &s->point[lattice_index(&lattice, e->from.at[0] + step * x,
                                         e->from.at[1] + step * y)],
                 &s->point[lattice_index(&lattice, e->from.at[0] + (step + 1) * x,
                                         e->from.at[1] + (step + 1) * y)]);
    }
}

static bool is_cut(const surface *s, const uint8_t l[3])
{
    return l[0] + s->cut[0] > s->m || l[1] + s->cut[1] > s->m || l[2] + s->cut[2] > s->m;
}

/* The mesh of the triangle without the parts that are cut off. */
static void basepoint_net(const surface *s, sided_edge *each, void *context)
{
    const surface_point *at[(SURFACE_DEGREE_MAX + 1) * (SURFACE_DEGREE_MAX + 2) / 2] = { NULL };
    unsigned rank = 0, kept = 0;
    uint8_t l[3];

    loft_multiindex_first(l, 3, s->m);
    do
        at[rank++] = is_cut(s, l) ? NULL : &s->point[kept++];
    while (loft_multiindex_next(l, 3));
    rank = 0;
    loft_multiindex_first(l, 3, s->m);
    do {
        for (unsigned i = 0; i < 3; i++) {
            uint8_t beside[3] = { l[0], l[1], l[2] };
            if (l[i] == 0)
                continue;
            beside[i]--;
            beside[(i + 1) % 3]++;
            const surface_point *other = at[loft_multiindex_rank(beside, 3)];
            if (at[rank] != NULL && other != NULL)
                each(context, at[rank], other);
        }
        rank++;
    } while (loft_multiindex_next(l, 3));
}

/* Blocks of a = 0 .. wide - 1, b = 0 .. high - 1 at each corner. The row at distance b from side i
 * runs over the a of corner i, then backwards over the b of corner i + 1. For an even degree the
 * last a of each block connect to a point in the middle. For an odd degree a GB patch has such a
 * point, and the innermost points connect to it. */
static void zheng_ball_net(const surface *s, sided_edge *each, void *context)
{
    const unsigned wide = s->m / 2 + 1, high = (s->m + 1) / 2, block = wide * high;
    const surface_point *middle = s->point + s->count - 1 - (s->split ? s->n : 0);

    for (unsigned i = 0; i < s->n; i++) {
        const surface_point *here = s->point + i * block, *next = s->point + (i + 1) % s->n * block;
        for (unsigned b = 0; b < high; b++) {
            for (unsigned a = 0; a + 1 < wide; a++)
                each(context, here + a * high + b, here + (a + 1) * high + b);
            each(context, here + (wide - 1) * high + b, next + b * high + high - 1);
            for (unsigned a = high - 1; a > 0; a--)
                each(context, next + b * high + a, next + b * high + a - 1);
        }
        for (unsigned b = 0; b < high && s->m % 2 == 0; b++) {
            const surface_point *last = here + (wide - 1) * high + b;
            each(context, last, b + 1 < high ? last + 1 : middle);
        }
        if (s->m % 2 != 0 && s->kind == SURFACE_GB)
            each(context, here + block - 1, middle);
    }
}

void sided_net(const surface *patch, sided_edge *each, void *context)
{
    switch (patch->kind) {
    case SURFACE_SPATCH:    spatch_net(patch, each, context);    break;
    case SURFACE_TORIC:     toric_net(patch, each, context);     break;
    case SURFACE_BASEPOINT: basepoint_net(patch, each, context); break;
    default:                zheng_ball_net(patch, each, context);      break;
    }
}

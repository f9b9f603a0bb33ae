/* host-tools/engine/harmonic_poles.c -- where the poles of a harmonic series lie
 * SPDX-License-Identifier: MIT
 *
 * A pole lies in the plane of z, or in that of a corner's root of z - v, where the corner is half
 * as wide: there a slit that ends at it is open. What the solution, continued over an edge, is
 * singular at needs a chain of poles that leads away from it: a corner, the mirror image of a
 * vertex in an edge that it is before, and the image of such an image in another edge. Each chain
 * takes the plane in which the polygon leaves it the most room, so that its poles are few, and are
 * not near a part of the polygon that has nothing to do with them.
 *
 * A slit too narrow for poles keeps nothing out: a corner's terms are as large on its other side,
 * where other terms have to cancel them. So no chain lies around a slit, but in the plane in which
 * that is open; and what a corner's powers need on the other side is a chain behind the edge there,
 * from the corner on, in a plane in which the way to it is outside.
 *
 * A corner's chain begins near the corner: a solution like r^a, a = pi over the angle, needs poles
 * from r = e^(-DIGITS / a) on, in distances that grow where fewer digits are left to find. Each
 * circle around the corner has a place in each of its arcs outside, where that has the most room:
 * this makes chains between the parts of the polygon that the circle crosses, as two channels that
 * meet at the corner: the solution is another polynomial in each.
 */
#include <math.h>
#include <stdlib.h>

#include "engine/harmonic_poles.h"
#include "base/memory.h"   /* memory_grow */

#define DIRECTIONS 96
#define CIRCLES    1.1L  /* from one to the next, in distances from the corner           */
#define CLEAR      0.05L /* of a pole from the polygon, in its distance from the corner  */
#define CLEAR_FOOT 0.1L  /* the same, in its distance from the edge                      */
#define DENSITY    0.3L  /* of poles behind an edge                                      */
#define BEHIND     0.02L /* how far behind the mirror image they begin                   */
#define STEEP      6     /* their distances are at most that many times how far behind   */
#define DIGITS     18    /* of a corner's chain, as a natural logarithm                  */
#define THIN       3     /* by how much its distances grow at most                       */
#define OWN        1.5L  /* what a place in the corner's own plane counts                */
#define FLAT       0.8L  /* what a place in the plane of z counts                        */
#define BLOCKED    100   /* what the end of a chain counts, and each e-fold that it lacks */
#define LACKING    30

/* How far a point is from the boundary, in a plane; 0 when it is within. */
static long double clearance(const harmonic_planes *p, unsigned plane, harmonic_point at)
{
    const harmonic_root *root = p->root[plane];
    const double x = (double)creall(at), y = (double)cimagl(at);
    double least = INFINITY;
    bool within = false;

    for (size_t k = 0; k < p->count; k++) {
        const harmonic_root *a = &root[k];
        const double dx = x - a->x, dy = y - a->y, along = (dx * a->dx + dy * a->dy) * a->inverse,
                     share = along < 0   ? 0
                             : along > 1 ? 1
                                         : along,
                     apart = dx - share * a->dx, aside = dy - share * a->dy,
                     square = apart * apart + aside * aside;
        const bool above = dy < 0;
        least = square < least ? square : least;
        if (above != (dy < a->dy) && (a->dx * dy - a->dy * dx < 0) == above)
            within = !within;
    }
    return within ? 0 : sqrtl(least);
}

static void add(harmonic_planes *p, harmonic_cut cut)
{
    if (p->cuts < HARMONIC_CUTS)
        p->cut[p->cuts++] = cut;
}


// Around corners
// --------------

/* The arcs of a circle that are outside: the place of each with the most room. Gives how many. No
 * direction is that of a corner's own edge in its plane, where within and outside are rounding.
 *
 *   shape   out[directions] */
static unsigned arcs(const harmonic_planes *p, unsigned plane, harmonic_point centre,
                     long double radius, unsigned directions, harmonic_cut out[])
{
    long double room[DIRECTIONS];
    harmonic_point at[DIRECTIONS];
    unsigned start = 0, count = 0;
    bool open = false;

    for (unsigned k = 0; k < directions; k++) {
        at[k] = centre + radius * cexpl(I * (2 * HARMONIC_PI * (k + 0.5L) / directions));
        room[k] = clearance(p, plane, at[k]);
        if (!(room[k] > 0))
            start = k;
    }
    for (unsigned m = 1; m <= directions; m++) {
        const unsigned k = (start + m) % directions;
        const harmonic_cut here = { plane, at[k], room[k], 1, false };
        if (room[k] > 0 && !open)
            out[count++] = here;
        else if (room[k] > 0 && room[k] > out[count - 1].room * 1.001L)
            out[count - 1] = here;
        open = room[k] > 0;
    }
    return count;
}

/* How many arcs of a circle are outside, however narrow. */
static unsigned arc_count(const harmonic_planes *p, unsigned plane, harmonic_point centre,
                          long double radius)
{
    const harmonic_root *root = p->root[plane];
    const double x = (double)creall(centre), y = (double)cimagl(centre),
                 square = (double)(radius * radius);
    unsigned crossings = 0;

    for (size_t k = 0; k < p->count; k++) {
        const double dx = root[k].x - x, dy = root[k].y - y, ex = dx + root[k].dx,
                     ey = dy + root[k].dy;
        crossings += (dx * dx + dy * dy < square) != (ex * ex + ey * ey < square);
    }
    return crossings / 2;
}

/* A chain around a corner in a plane: its centre, the radii of its circles, and the distance there
 * that is one of z beside the corner; 0 in the corner's own plane. */
typedef struct {
    unsigned corner, plane;
    harmonic_point centre;
    long double least, most, slope;
} chain;

static long double power_of(const harmonic_shape *h, unsigned i)
{
    return fmaxl(HARMONIC_PI / h->angle[i], 1);
}

static chain chain_of(const harmonic_shape *h, unsigned i, unsigned plane)
{
    const long double depth = fmaxl(fminl(expl(DIGITS / power_of(h, i)), 1e6L), 10),
                      nearest = h->room[i] / depth;
    chain c = { i, plane, 0, sqrtl(nearest / h->far[i]), 2, 0 };

    if (plane != i) {
        c.centre = cexpl(harmonic_log(h, plane, h->v[i], (int)i) / 2);
        c.slope = cabsl(c.centre) / (2 * cabsl(h->v[i] - h->v[plane]));
        c.least = nearest * c.slope;
    }
    return c;
}

/* About how many poles it needs, by the narrowest arc of each circle. One that was not found is too
 * narrow for a pole. */
static long double chain_cost(const harmonic_planes *p, const chain *c)
{
    const long double step = 1.25L;
    harmonic_cut arc[DIRECTIONS];
    long double cost = 0;

    for (long double r = c->least; r < c->most; r *= step) {
        const unsigned count = arcs(p, c->plane, c->centre, r, DIRECTIONS / 2, arc);
        long double narrow = INFINITY;
        for (unsigned k = 0; k < count; k++)
            narrow = fminl(narrow, arc[k].room);
        if (arc_count(p, c->plane, c->centre, r) > count)
            narrow = CLEAR * r;
        cost += fminl(r / narrow, 1 / CLEAR) * (step - 1);
    }
    return cost * (c->plane == c->corner ? OWN : 1);
}

/* In the root's plane of a corner of more than half a turn there is more room. */
static bool is_opening(const harmonic_shape *h, unsigned corner)
{
    return h->angle[corner] > 1.02L * HARMONIC_PI;
}

static void circle_cuts(harmonic_planes *p, const chain *c, long double r)
{
    const harmonic_shape *h = p->h;
    const unsigned i = c->corner;
    const long double apart = c->plane == i ? r * r * h->far[i] : r / c->slope,
                      found = fmaxl(power_of(h, i) * logl(h->room[i] / apart), 0);
    harmonic_cut arc[DIRECTIONS];
    const unsigned count = arcs(p, c->plane, c->centre, r, DIRECTIONS, arc);

    for (unsigned k = 0; k < count; k++) {
        arc[k].room = fminl(arc[k].room, r);
        arc[k].thin = fminl(DIGITS / fmaxl(DIGITS - found, 1), THIN);
        if (arc[k].room > CLEAR * r)
            add(p, arc[k]);
    }
}

static void corner_cuts(harmonic_planes *p, unsigned i)
{
    const harmonic_shape *h = p->h;
    chain best = chain_of(h, i, i);
    long double cost = chain_cost(p, &best);

    for (unsigned j = 0; j < h->sides; j++) {
        const chain other = chain_of(h, i, j);
        const long double others = j != i && is_opening(h, j) ? chain_cost(p, &other) : INFINITY;
        if (others < cost) {
            cost = others;
            best = other;
        }
    }
    const long double step = best.plane == i ? sqrtl(CIRCLES) : CIRCLES;
    for (long double r = best.most; r > best.least; r /= step)
        circle_cuts(p, &best, r);
}


// Behind edges
// ------------

/* A place behind an edge, on the perpendicular through a foot, in a plane. */
static harmonic_point behind(const harmonic_shape *h, unsigned plane, const harmonic_foot *foot,
                             harmonic_point z)
{
    if (plane == h->sides)
        return z;
    const harmonic_point v = h->v[plane], l = harmonic_log(h, plane, foot->at, (int)foot->edge) +
                                              clogl((z - v) / (foot->at - v));
    return cexpl(l / 2);
}

/* Whether the way from an edge to what is behind it is outside, in a plane. */
static bool is_open(const harmonic_planes *p, const harmonic_foot *foot, unsigned plane)
{
    const harmonic_point way = foot->image - foot->at;

    for (long double share = 1; share > 0.01L; share /= 1.1L)
        if (!(clearance(p, plane, behind(p->h, plane, foot, foot->at + share * way)) > 0))
            return false;
    return true;
}

/* Where it gets narrow, the chain ends. Gives about how many poles it needs. */
static long double foot_cuts(harmonic_planes *p, const harmonic_foot *foot, unsigned plane,
                             bool put)
{
    const harmonic_shape *h = p->h;
    const harmonic_point way = (foot->image - foot->at) / foot->room;
    long double cost = 0, last = 0;

    for (long double more = foot->room * BEHIND, off = foot->room + more; off < 4 * h->reach;
         last = off, more *= 1.2L, off = foot->room + more) {
        const harmonic_point z = foot->at + way * off, at = behind(h, plane, foot, z);
        const long double slope = plane == h->sides ? 1 : cabsl(at) / (2 * cabsl(z - h->v[plane])),
                          room = clearance(p, plane, at);
        if (room < CLEAR_FOOT * off * slope)
            return cost + BLOCKED + LACKING * logl(4 * h->reach / off);
        if (put)
            add(p, (harmonic_cut){ plane, at, room, fminl(STEEP * more / foot->room, 1), true });
        cost += slope * (off - last) / room;
    }
    return cost;
}

static long double foot_cost(harmonic_planes *p, const harmonic_foot *foot, unsigned plane)
{
    return foot->hidden && !is_open(p, foot, plane) ? INFINITY : foot_cuts(p, foot, plane, false);
}

/* In the plane of z, or that of a corner that is not the foot itself. A hidden corner has no chain
 * where no plane is open. */
static void put_foot(harmonic_planes *p, const harmonic_foot *foot)
{
    const harmonic_shape *h = p->h;
    unsigned best = h->sides;
    long double least = FLAT * foot_cost(p, foot, best);

    for (unsigned j = 0; j < h->sides; j++) {
        if (!is_opening(h, j) || cabsl(foot->at - h->v[j]) < 1e-6L * foot->room)
            continue;
        const long double cost = foot_cost(p, foot, j);
        if (cost < least) {
            least = cost;
            best = j;
        }
    }
    if (least < INFINITY)
        foot_cuts(p, foot, best, true);
}


// Public
// ------

static void find_steps(harmonic_root root[], size_t count)
{
    for (size_t k = 0; k < count; k++) {
        harmonic_root *a = &root[k];
        const harmonic_root *b = &root[k + 1 < count ? k + 1 : 0];
        a->dx = b->x - a->x;
        a->dy = b->y - a->y;
        const double square = a->dx * a->dx + a->dy * a->dy;
        a->inverse = square > 0 ? 1 / square : 0;
    }
}

void harmonic_planes_of(const harmonic_shape *h, const harmonic_place place[], size_t count,
                        harmonic_planes *p)
{
    p->h = h;
    p->count = count;
    p->cuts = 0;
    p->cut = memory_grow(NULL, HARMONIC_CUTS * sizeof *p->cut);
    for (unsigned j = 0; j <= h->sides; j++) {
        p->root[j] = memory_grow(NULL, count * sizeof *p->root[j]);
        for (size_t k = 0; k < count; k++) {
            const int edge = (int)place[k].edge;
            const harmonic_point at = j < h->sides
                                          ? cexpl(harmonic_log(h, j, place[k].at, edge) / 2)
                                          : place[k].at;
            p->root[j][k] = (harmonic_root){ (double)creall(at), (double)cimagl(at), 0, 0, 0 };
        }
        find_steps(p->root[j], count);
    }
    for (unsigned i = 0; i < h->sides; i++)
        corner_cuts(p, i);
    for (unsigned i = 0; i < h->feet; i++)
        put_foot(p, &h->foot[i]);
}

void harmonic_planes_free(harmonic_planes *p)
{
    for (unsigned j = 0; p->cut != NULL && j <= p->h->sides; j++)
        free(p->root[j]);
    free(p->cut);
    p->cut = NULL;
}

/* How far a place is from the nearest pole that was put since the first one. */
static long double pole_distance(const harmonic_series *s, unsigned first, harmonic_point at)
{
    long double least = INFINITY;

    for (unsigned k = first; k < s->pole_count; k++)
        least = fminl(least, cabsl(at - (s->pole[k][0] + I * s->pole[k][1])));
    return least;
}

/* Put the poles of a plane where there is none nearer. Their sizes are their rooms. */
static unsigned put_poles(const harmonic_planes *p, unsigned plane, long double ratio,
                          harmonic_series *s)
{
    const unsigned first = s->pole_count;

    for (unsigned k = 0; k < p->cuts && s->pole_count < HARMONIC_POLES; k++) {
        const harmonic_cut *c = &p->cut[k];
        const long double density = c->behind ? DENSITY * (ratio - 1) : sqrtl(ratio) - 1;
        if (c->plane != plane || pole_distance(s, first, c->at) < density * c->thin * c->room)
            continue;
        long double *pole = s->pole[s->pole_count++];
        pole[0] = (double)creall(c->at);
        pole[1] = (double)cimagl(c->at);
        pole[2] = (double)c->room;
    }
    return s->pole_count - first;
}

void harmonic_put_poles(const harmonic_planes *p, long double ratio, harmonic_series *s)
{
    for (unsigned j = 0; j < s->sides; j++)
        s->corner_poles[j] = put_poles(p, j, ratio, s);
    s->poles = put_poles(p, s->sides, ratio, s);
}

/* lib/polygon/domain.c
 * SPDX-License-Identifier: MIT
 *
 * Every decision is the sign of a cross product, which num/sci.h guarantees to be exact, or a
 * comparison of two coordinates.
 */
#include "polygon/domain.h"
#include "num/exact.h"  /* loft_exact_valid */

static unsigned next_vertex(unsigned i, unsigned sides) { return i + 1 < sides ? i + 1 : 0; }

static loft_sci turn_area(const loft_spot *a, const loft_spot *b, const loft_spot *c)
{
    return loft_sci_cross(a->at, b->at, a->at, c->at);
}

int loft_spot_turn(const loft_spot *a, const loft_spot *b, const loft_spot *c)
{
    return loft_sci_sign(turn_area(a, b, c));
}

static bool real_between(loft_real x, loft_real a, loft_real b)
{
    return a < b ? x >= a && x <= b : x >= b && x <= a;
}

/* True if p, which is on the line through a and b, lies between them. */
static bool on_segment(const loft_spot *p, const loft_spot *a, const loft_spot *b)
{
    return real_between(p->at[0], a->at[0], b->at[0]) && real_between(p->at[1], a->at[1], b->at[1]);
}

static bool spots_equal(const loft_spot *a, const loft_spot *b) { return on_segment(a, b, b); }

/* True if two edges a b and c d that are not neighbours cross, or one begins on the other. Testing
 * the begins is enough. Where an edge ends another begins, and if that one is a neighbour of the
 * touched edge, it folds back onto it. */
static bool edges_touch(const loft_spot *a, const loft_spot *b, const loft_spot *c,
                        const loft_spot *d)
{
    const int abc = loft_spot_turn(a, b, c), cda = loft_spot_turn(c, d, a);

    if ((!abc && on_segment(c, a, b)) || (!cda && on_segment(a, c, d)))
        return true;
    return abc * loft_spot_turn(a, b, d) < 0 && cda * loft_spot_turn(c, d, b) < 0;
}

/* True if the edge from `at` folds back over the whole edge before it, which may have no length. If
 * it covers only a part, the vertex after it touches that edge. Of three points on a line one edge
 * covers another. */
static bool edge_folds(const loft_spot *before, const loft_spot *at, const loft_spot *after)
{
    return !loft_spot_turn(before, at, after) && on_segment(before, at, after);
}

bool loft_outline_fault(const loft_spot v[], unsigned sides, unsigned edge[2])
{
    for (edge[0] = 0; edge[0] < sides; edge[0]++) {
        const unsigned i = edge[0], j = next_vertex(i, sides);
        edge[1] = j;
        if (edge_folds(&v[i], &v[j], &v[next_vertex(j, sides)]))
            return true;
        for (edge[1] = i + 2; edge[1] < sides; edge[1]++) {
            const unsigned k = edge[1], l = next_vertex(k, sides);
            if (l != i && edges_touch(&v[i], &v[j], &v[k], &v[l]))
                return true;
        }
    }
    return false;
}

/* A simple polygon turns at its lowest vertex (of those the leftmost) as it does as a whole, since
 * no edge is below. The vertices beside it cannot be on one line with it: one of them would be
 * lower or further left. */
static int outline_turn(const loft_spot v[], unsigned sides)
{
    unsigned least = 0;

    for (unsigned i = 1; i < sides; i++)
        if (v[i].at[1] < v[least].at[1] ||
            (!(v[i].at[1] > v[least].at[1]) && v[i].at[0] < v[least].at[0]))
            least = i;
    return loft_spot_turn(&v[least ? least - 1 : sides - 1], &v[least],
                          &v[next_vertex(least, sides)]);
}

enum loft_outline loft_outline_of(const loft_spot v[], unsigned sides)
{
    unsigned edge[2];

    if (loft_outline_fault(v, sides, edge))
        return LOFT_OUTLINE_BROKEN;
    if (outline_turn(v, sides) < 0)
        return LOFT_OUTLINE_CLOCKWISE;
    for (unsigned i = 0; i < sides; i++)
        if (loft_spot_turn(&v[i], &v[next_vertex(i, sides)],
                           &v[next_vertex(next_vertex(i, sides), sides)]) <= 0)
            return LOFT_OUTLINE_SIMPLE;
    return LOFT_OUTLINE_CONVEX;
}

bool loft_spot_valid(loft_spot p) { return loft_exact_valid(p.at[0]) && loft_exact_valid(p.at[1]); }

enum loft_status loft_domain_init(loft_domain *d, const loft_spot v[], unsigned sides)
{
    if (sides < 3 || sides > LOFT_SIDES_MAX)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i < sides; i++)
        if (!loft_spot_valid(v[i]))
            return LOFT_ERR_RANGE;
    const enum loft_outline outline = loft_outline_of(v, sides);
    if (outline == LOFT_OUTLINE_BROKEN)
        return LOFT_SINGULAR;
    if (outline == LOFT_OUTLINE_CLOCKWISE)
        return LOFT_ERR_ARG;

    d->v = v;
    d->sides = (uint8_t)sides;
    d->convex = outline == LOFT_OUTLINE_CONVEX;
    for (unsigned i = 0; i < sides; i++)
        d->corner[i] = turn_area(&v[i ? i - 1 : sides - 1], &v[i], &v[next_vertex(i, sides)]);
    return LOFT_OK;
}

/* A ray from p to the right crosses an edge that has one end above p and one not above it, if p
 * lies left of a rising edge or right of a falling one. Inside, the number of crossings is odd. */
enum loft_place loft_domain_place(const loft_domain *d, loft_spot p, loft_sci area[],
                                  unsigned *index)
{
    bool inside = false, on_edge = false;

    for (unsigned i = 0; i < d->sides; i++) {
        const loft_spot *a = &d->v[i], *b = &d->v[next_vertex(i, d->sides)];
        area[i] = turn_area(&p, a, b);
        const int sign = loft_sci_sign(area[i]);
        const bool rises = b->at[1] > p.at[1], above = a->at[1] > p.at[1];

        if (!sign && on_segment(&p, a, b) && !on_edge) {
            on_edge = true;
            *index = spots_equal(&p, b) ? next_vertex(i, d->sides) : i;
        }
        if (rises != above && sign == (rises ? 1 : -1))
            inside = !inside;
    }
    if (on_edge)
        return spots_equal(&p, &d->v[*index]) ? LOFT_AT_VERTEX : LOFT_ON_EDGE;
    return inside ? LOFT_INSIDE : LOFT_OUTSIDE;
}

void loft_domain_vertex(const loft_domain *d, unsigned vertex, loft_sci phi[])
{
    for (unsigned i = 0; i < d->sides; i++)
        phi[i] = i == vertex ? loft_sci_one() : loft_sci_zero();
}

static loft_sci sci_difference(loft_real from, loft_real to)
{
    return loft_sci_sub(loft_sci_from_real(to), loft_sci_from_real(from));
}

/* The shares are taken along the axis in which the edge is longer. Both are quotients, so neither
 * is the rounded difference of 1 and the other. */
void loft_domain_edge(const loft_domain *d, loft_spot p, unsigned edge, loft_sci phi[])
{
    const unsigned after = next_vertex(edge, d->sides);
    const loft_spot *a = &d->v[edge], *b = &d->v[after];
    const loft_sci x = sci_difference(a->at[0], b->at[0]), y = sci_difference(a->at[1], b->at[1]);
    const bool tall = loft_sci_less(loft_sci_mul(x, x), loft_sci_mul(y, y));
    const loft_sci whole = tall ? y : x;

    loft_domain_vertex(d, edge, phi);
    phi[edge]  = loft_sci_div(sci_difference(p.at[tall], b->at[tall]), whole);
    phi[after] = loft_sci_div(sci_difference(a->at[tall], p.at[tall]), whole);
}

/* The point of edge i nearest to p: its share, and its squared distance. */
static loft_sci nearest_of_edge(const loft_domain *d, loft_spot p, unsigned i, loft_sci *share)
{
    const loft_spot *a = &d->v[i], *b = &d->v[next_vertex(i, d->sides)];
    loft_sci along = loft_sci_zero(), whole = loft_sci_zero(), apart = loft_sci_zero();

    for (int k = 0; k < 2; k++) {
        const loft_sci edge = sci_difference(a->at[k], b->at[k]);
        along = loft_sci_add(along, loft_sci_mul(sci_difference(a->at[k], p.at[k]), edge));
        whole = loft_sci_add(whole, loft_sci_mul(edge, edge));
    }
    *share = loft_sci_sign(along) <= 0     ? loft_sci_zero()
             : loft_sci_less(along, whole) ? loft_sci_div(along, whole)
                                           : loft_sci_one();
    for (int k = 0; k < 2; k++) {
        const loft_sci off = loft_sci_sub(sci_difference(a->at[k], p.at[k]),
                                          loft_sci_mul(*share, sci_difference(a->at[k], b->at[k])));
        apart = loft_sci_add(apart, loft_sci_mul(off, off));
    }
    return apart;
}

void loft_domain_nearest(const loft_domain *d, loft_spot p, loft_sci phi[])
{
    loft_sci share, best, least = nearest_of_edge(d, p, 0, &best);
    unsigned edge = 0;

    for (unsigned i = 1; i < d->sides; i++) {
        const loft_sci apart = nearest_of_edge(d, p, i, &share);
        if (loft_sci_less(apart, least)) {
            least = apart;
            best = share;
            edge = i;
        }
    }
    loft_domain_vertex(d, edge, phi);
    phi[next_vertex(edge, d->sides)] = best;
    phi[edge] = loft_sci_sub(loft_sci_one(), best);
}

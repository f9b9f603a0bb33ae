/* lib/polygon/lattice.c
 * SPDX-License-Identifier: MIT
 *
 * Vectors between vertices are within 64, products within 4096, their sums within 2^13. An int
 * holds all of them.
 */
#include "polygon/lattice.h"

static int dot(loft_whole a, loft_whole b) { return a.at[0] * b.at[0] + a.at[1] * b.at[1]; }

static int cross(loft_whole o, loft_whole a, loft_whole b)
{
    return (a.at[0] - o.at[0]) * (b.at[1] - o.at[1]) - (a.at[1] - o.at[1]) * (b.at[0] - o.at[0]);
}

/* The greatest common divisor, by Euclid's algorithm. */
static int common_divisor(int a, int b)
{
    a = a < 0 ? -a : a;
    b = b < 0 ? -b : b;
    while (b) {
        const int rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static bool vertex_valid(loft_whole p)
{
    for (int i = 0; i < 2; i++)
        if (p.at[i] < -LOFT_LATTICE_MAX || p.at[i] > LOFT_LATTICE_MAX)
            return false;
    return true;
}

/* True if all other vertices are strictly left of every edge. */
static bool convex(const loft_whole v[], unsigned sides)
{
    for (unsigned i = 0; i < sides; i++) {
        const unsigned j = i + 1 < sides ? i + 1 : 0;
        for (unsigned k = 0; k < sides; k++)
            if (k != i && k != j && cross(v[i], v[j], v[k]) <= 0)
                return false;
    }
    return true;
}

static loft_lattice_edge edge_of(loft_whole from, loft_whole to)
{
    const int x = to.at[0] - from.at[0], y = to.at[1] - from.at[1], length = common_divisor(x, y);
    loft_lattice_edge e;

    e.from = from;
    e.normal.at[0] = (int8_t)(-y / length);
    e.normal.at[1] = (int8_t)(x / length);
    e.offset = (int16_t)-dot(e.normal, from);
    e.length = (uint8_t)length;
    return e;
}

enum loft_status loft_lattice_polygon_init(loft_lattice_polygon *l, const loft_whole v[],
                                           unsigned sides)
{
    if (sides < 3 || sides > LOFT_SIDES_MAX)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i < sides; i++)
        if (!vertex_valid(v[i]))
            return LOFT_ERR_ARG;
    if (!convex(v, sides))
        return LOFT_SINGULAR;

    l->sides = (uint8_t)sides;
    l->low = l->high = v[0];
    for (unsigned i = 0; i < sides; i++) {
        l->edge[i] = edge_of(v[i], v[i + 1 < sides ? i + 1 : 0]);
        for (int k = 0; k < 2; k++) {
            if (v[i].at[k] < l->low.at[k])
                l->low.at[k] = v[i].at[k];
            if (v[i].at[k] > l->high.at[k])
                l->high.at[k] = v[i].at[k];
        }
    }
    return LOFT_OK;
}

int loft_lattice_polygon_height(const loft_lattice_polygon *l, unsigned edge, loft_whole p)
{
    return dot(l->edge[edge].normal, p) + l->edge[edge].offset;
}

static bool polygon_holds(const loft_lattice_polygon *l, loft_whole p)
{
    for (unsigned i = 0; i < l->sides; i++)
        if (loft_lattice_polygon_height(l, i, p) < 0)
            return false;
    return true;
}

/* Move p to the next point of the box that lies in the polygon; p itself counts. */
static bool find_inside(const loft_lattice_polygon *l, loft_whole *p)
{
    for (; p->at[1] <= l->high.at[1]; p->at[1]++, p->at[0] = l->low.at[0])
        for (; p->at[0] <= l->high.at[0]; p->at[0]++)
            if (polygon_holds(l, *p))
                return true;
    return false;
}

void loft_lattice_polygon_first(const loft_lattice_polygon *l, loft_whole *p)
{
    *p = l->low;
    find_inside(l, p);
}

bool loft_lattice_polygon_next(const loft_lattice_polygon *l, loft_whole *p)
{
    loft_whole after = *p;

    after.at[0]++;
    if (!find_inside(l, &after))
        return false;
    *p = after;
    return true;
}

unsigned loft_lattice_polygon_count(const loft_lattice_polygon *l)
{
    loft_whole p;
    unsigned count = 0;

    loft_lattice_polygon_first(l, &p);
    do
        count++;
    while (loft_lattice_polygon_next(l, &p));
    return count;
}

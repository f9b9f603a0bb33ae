/* lib/curve/convex.c -- whether a polygon is the boundary of a convex region
 * SPDX-License-Identifier: MIT
 *
 * Null edges are skipped. The others must turn one way: all products of neighbours >= 0, or all <=
 * 0. If all are 0, all edges are parallel. The number of revolutions follows from two half planes
 * of directions: y > 0 or y = 0 < x, and the opposite. An edge that turns by half a revolution or
 * less changes between them at most once, and a full revolution changes twice.
 *
 * An edge that goes straight back is half a revolution. It needs no test: in a polygon that makes
 * one revolution, all directions would then lie in the other half plane, and such edges do not sum
 * to 0.
 *
 * Edges have R + 1 bits, products 2 R + 3 (R = 31, in floats 128).
 */
#include "curve/shape.h"
#include "geom/vec_exact.h" /* loft_exact: exact decisions */

typedef struct {
    loft_exact x, y;
} edge;

/* Edge k of the closed polygon: the last one leads back to the first point. */
static edge edge_at(const loft_vec p[], unsigned count, unsigned k)
{
    const loft_vec *from = &p[k], *to = &p[k + 1 < count ? k + 1 : 0];
    const edge e = { loft_vec_exact_sub_axis(to, from, 0), loft_vec_exact_sub_axis(to, from, 1) };
    return e;
}

static bool is_null(const edge *e)
{
    return loft_exact_sign(e->x) == 0 && loft_exact_sign(e->y) == 0;
}

static bool is_upper(const edge *e)
{
    const int y = loft_exact_sign(e->y);
    return y > 0 || (y == 0 && loft_exact_sign(e->x) > 0);
}

static int turn(const edge *a, const edge *b)
{
    return loft_exact_sign(loft_exact_det(a->x, a->y, b->x, b->y));
}

typedef struct {
    bool left, right;       /* a left, a right turn has occurred */
    unsigned changes;       /* of the half plane          */
} tally;

static void count_turn(tally *t, const edge *a, const edge *b)
{
    const int way = turn(a, b);

    t->left  = t->left || way > 0;
    t->right = t->right || way < 0;
    t->changes += is_upper(a) != is_upper(b);
}

enum loft_status loft_polygon_convex(const loft_vec p[], unsigned count, enum loft_convexity *out)
{
    tally t = { false, false, 0 };
    edge before;
    unsigned last = count;

    if (!loft_vec_exact_valid(p, count, 2))
        return LOFT_ERR_RANGE;
    while (last > 0) {                          /* the last nonnull edge precedes the first */
        before = edge_at(p, count, --last);
        if (!is_null(&before))
            break;
    }
    for (unsigned k = 0; k < count; k++) {
        const edge e = edge_at(p, count, k);
        if (is_null(&e))
            continue;
        count_turn(&t, &before, &e);
        before = e;
    }
    *out = !t.left && !t.right ? LOFT_COLLINEAR
           : (t.left && t.right) || t.changes != 2 ? LOFT_NOT_CONVEX
                                                   : LOFT_CONVEX;
    return LOFT_OK;
}

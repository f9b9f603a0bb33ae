/* lib/surface/contour.c
 * SPDX-License-Identifier: MIT
 *
 * A corner of the grid is (i, j): row i, column j. The lower triangle of cell (i, j) has the
 * corners (i, j), (i + 1, j), (i, j + 1). The upper one has (i + 1, j + 1), (i, j + 1), (i + 1, j).
 * Both run counter-clockwise with u to the right. Edge k of a triangle runs from corner k to the
 * next one. A contour has the higher side to its left. It enters a triangle over the edge from a
 * higher corner to a lower one, and leaves it over the edge from a lower corner to a higher one.
 * There is exactly one of each when the corners differ.
 *
 * An edge has the same low end and the same high end in both of its triangles. So the search finds
 * the same point from both sides.
 */
#include "surface/contour.h"

#define GUESSES 54      /* bisection steps: more than a parameter has binary digits */

typedef struct {
    unsigned i, j;
} corner;

static bool get_bit(const loft_contour *c, uint32_t k) { return c->memory[k / 8] >> k % 8 & 1; }
static void set_bit(loft_contour *c, uint32_t k)
{
    c->memory[k / 8] = (uint8_t)(c->memory[k / 8] | 1u << k % 8);
}

static uint32_t corner_bit(const loft_contour *c, corner k)
{
    const unsigned j = c->surface.over == LOFT_SURFACE_DISK && k.j == c->columns ? 0 : k.j;
    return k.i * (c->columns + (uint32_t)1) + j;
}

static uint32_t cell_bit(const loft_contour *c, const loft_contour_cell *t)
{
    return (c->rows + (uint32_t)1) * (c->columns + (uint32_t)1) +
           ((uint32_t)t->i * c->columns + t->j) * 2 + t->upper;
}

static bool is_high(const loft_contour *c, corner k) { return get_bit(c, corner_bit(c, k)); }

static bool cell_exists(const loft_contour *c, unsigned i, unsigned j, bool upper)
{
    if (c->surface.over == LOFT_SURFACE_TRIANGLE)
        return i + j + upper < c->rows;
    return i < c->rows && j < c->columns;
}

/* Corner k of a triangle, k = 0..3. Corner 3 is corner 0. */
static corner corner_of(const loft_contour_cell *t, unsigned k)
{
    const unsigned one = t->upper ? 0 : 1, i = t->i + (k % 3 == 1 ? one : 1 - one),
                   j = t->j + (k % 3 == 2 ? one : 1 - one);
    const corner at = { i, j };
    return at;
}

/* The edge over which a contour enters (`high` true) or leaves the triangle. 3 when the contour
 * does not cross the triangle. */
static unsigned crossed_edge(const loft_contour *c, const loft_contour_cell *t, bool high)
{
    unsigned k = 0;

    while (k < 3 &&
           !(is_high(c, corner_of(t, k)) == high && is_high(c, corner_of(t, k + 1)) == !high))
        k++;
    return k;
}

/* Go to the triangle beyond edge k, in place. False when the edge is on the border. Edge 0 is the
 * line between columns, edge 1 the diagonal, edge 2 the line between rows. */
static bool go_to_neighbour(const loft_contour *c, loft_contour_cell *t, unsigned k)
{
    unsigned i = t->i, j = t->j;

    if (k == 0 && !t->upper && j == 0) {
        if (c->surface.over != LOFT_SURFACE_DISK)
            return false;
        j = c->columns;
    }
    if (k == 2 && !t->upper && i == 0)
        return false;
    if (k == 0)
        j = t->upper ? j + 1 : j - 1;
    if (k == 2)
        i = t->upper ? i + 1 : i - 1;
    if (c->surface.over == LOFT_SURFACE_DISK && j == c->columns)
        j = 0;
    if (!cell_exists(c, i, j, !t->upper))
        return false;
    t->i = (uint16_t)i;
    t->j = (uint16_t)j;
    t->upper = !t->upper;
    return true;
}


/* Points */

/* A point between two corners of the grid. */
typedef struct {
    loft_unit u, v;
    loft_vec p;
    loft_acc off;               /* its height minus the wanted height */
} spot;

static loft_unit unit_lerp(loft_unit a, loft_unit b, loft_unit s)
{
    return loft_unit_round(loft_acc_lerp(loft_unit_to_acc(a), loft_unit_to_acc(b), s));
}

static enum loft_status look_at(const loft_contour *c, spot *s)
{
    return loft_level_at(&c->level, &c->surface, s->u, s->v, &s->p, &s->off);
}

/* False when the surface has no point there. */
static bool eval_spot(const loft_contour *c, spot *s) { return look_at(c, s) == LOFT_OK; }

static bool eval_corner(const loft_contour *c, corner k, spot *s)
{
    s->u = loft_unit_of(k.i, c->rows);
    s->v = loft_unit_of(k.j, c->columns);
    return eval_spot(c, s);
}

static bool spot_within_tol(const loft_contour *c, const spot *s)
{
    return s->off <= loft_to_acc(c->tol) && s->off >= -loft_to_acc(c->tol);
}

/* Find the crossing between a low and a high corner, low.off < 0 <= high.off. Secant and bisection
 * steps alternate. The secant converges fast where the surface is smooth; bisection limits the
 * steps on any surface to twice those of bisection alone. */
static spot find_crossing(const loft_contour *c, corner from, corner to)
{
    loft_unit least = 0, most = LOFT_UNIT(1);
    spot a, b, low, high;

    if (!eval_corner(c, from, &a) || !eval_corner(c, to, &b))   /* never: init has evaluated both */
        return a;
    low = a;
    high = b;
    for (unsigned guess = 0; guess < 2 * GUESSES && high.off != 0; guess++) {
        const loft_unit share = guess % 2 ? LOFT_UNIT(0.5)
                                          : loft_unit_ratio(-low.off, high.off - low.off);
        const loft_unit s = unit_lerp(least, most, share);
        spot x;
        if (!(s > least && s < most)) {
            if (guess % 2)
                break;
            continue;
        }
        x.u = unit_lerp(a.u, b.u, s);
        x.v = unit_lerp(a.v, b.v, s);
        if (!eval_spot(c, &x))
            break;
        if (spot_within_tol(c, &x))
            return x;
        if (x.off < 0) {
            least = s;
            low = x;
        } else {
            most = s;
            high = x;
        }
    }
    return high.off < -low.off ? high : low;
}

static void give_point(loft_contour *c, unsigned k, bool entry, loft_vec *out)
{
    const corner from = corner_of(&c->at, k), to = corner_of(&c->at, k + 1);
    const spot s = entry ? find_crossing(c, to, from) : find_crossing(c, from, to);

    c->u = s.u;
    c->v = s.v;
    *out = s.p;
}


/* Curves */

enum loft_status loft_contour_init(loft_contour *c, loft_surface surface, unsigned axis,
                                   loft_real height, loft_real tol, unsigned rows, unsigned columns,
                                   uint8_t memory[], size_t count)
{
    loft_level level;

    if (loft_level_axis(&level, axis, height) != LOFT_OK)
        return LOFT_ERR_ARG;
    return loft_contour_init_level(c, surface, &level, tol, rows, columns, memory, count);
}

enum loft_status loft_contour_init_level(loft_contour *c, loft_surface surface,
                                         const loft_level *level, loft_real tol, unsigned rows,
                                         unsigned columns, uint8_t memory[], size_t count)
{
    const bool round = surface.over == LOFT_SURFACE_DISK,
               triangle = surface.over == LOFT_SURFACE_TRIANGLE;
    corner k;

    if (rows < 1 || rows > LOFT_CONTOUR_MAX || columns < (round ? 3u : 1u) ||
        columns > LOFT_CONTOUR_MAX || (triangle && rows != columns) || !(tol >= 0))
        return LOFT_ERR_ARG;
    if (count < LOFT_CONTOUR_BYTES(rows, columns))
        return LOFT_ERR_SPACE;
    for (uint32_t i = 0; i < LOFT_CONTOUR_BYTES(rows, columns); i++)
        memory[i] = 0;
    c->surface = surface;
    c->level = *level;
    c->tol = tol;
    c->rows = (uint16_t)rows;
    c->columns = (uint16_t)columns;
    c->memory = memory;
    c->walking = c->closed = false;
    c->next = 0;
    for (k.i = 0; k.i <= rows; k.i++)
        for (k.j = 0; k.j <= (triangle ? rows - k.i : columns); k.j++) {
            spot s;
            s.u = loft_unit_of(k.i, rows);
            s.v = loft_unit_of(k.j, columns);
            const enum loft_status status = look_at(c, &s);
            if (status != LOFT_OK)
                return status;
            if (s.off >= 0)
                set_bit(c, corner_bit(c, k));
        }
    return LOFT_OK;
}

/* True if a curve that is not yet walked begins in this triangle. The first pass looks at the
 * border only, the second pass everywhere. */
static bool curve_begins(const loft_contour *c, const loft_contour_cell *t, unsigned *entry)
{
    loft_contour_cell beyond = *t;

    if (!cell_exists(c, t->i, t->j, t->upper) || get_bit(c, cell_bit(c, t)))
        return false;
    *entry = crossed_edge(c, t, true);
    return *entry < 3 && (c->closed || !go_to_neighbour(c, &beyond, *entry));
}

static bool find_start(loft_contour *c, unsigned *entry)
{
    const uint32_t all = (uint32_t)2 * c->rows * c->columns;

    for (;;) {
        for (; c->next < all; c->next++) {
            c->at.i = (uint16_t)(c->next / 2 / c->columns);
            c->at.j = (uint16_t)(c->next / 2 % c->columns);
            c->at.upper = c->next % 2 != 0;
            if (curve_begins(c, &c->at, entry))
                return true;
        }
        if (c->closed)
            return false;
        c->closed = true;
        c->next = 0;
    }
}

enum loft_contour_step loft_contour_next(loft_contour *c, loft_vec *out)
{
    unsigned k = 0;

    if (!c->walking) {
        if (!find_start(c, &k))
            return LOFT_CONTOUR_OVER;
        c->walking = true;
        give_point(c, k, true, out);
        return LOFT_CONTOUR_START;
    }
    k = crossed_edge(c, &c->at, false);
    give_point(c, k, false, out);
    set_bit(c, cell_bit(c, &c->at));
    c->walking = go_to_neighbour(c, &c->at, k) && !get_bit(c, cell_bit(c, &c->at));
    return LOFT_CONTOUR_ON;
}

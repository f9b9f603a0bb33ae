/* host-tools/geometry/nearest_piece.c -- a tree of boxes over pieces in their given order
 * SPDX-License-Identifier: MIT
 *
 * Pieces of a path follow each other, so a range of the list is a compact part of the plane, and
 * the tree needs no sorting. Node k covers a range, its children 2k+1 and 2k+2 the two halves.
 * Ranges of LEAF pieces are not split.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geometry/nearest_piece.h"
#include "base/tool.h"       /* tool_grow */

#define LEAF 4

void nearest_add(nearest *n, const double a[2], const double b[2])
{
    if (n->count == n->room) {
        n->room  = n->room ? 2 * n->room : 1024;
        n->piece = tool_grow(n->piece, n->room * sizeof *n->piece);
    }
    n->piece[n->count++] = (nearest_piece){ { a[0], a[1] }, { b[0], b[1] } };
}

static void build(nearest *n, size_t node, size_t from, size_t to)
{
    double box[4] = { HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL };

    for (size_t i = from; i < to; i++)
        for (int k = 0; k < 2; k++) {
            box[k]     = fmin(box[k],     fmin(n->piece[i].a[k], n->piece[i].b[k]));
            box[k + 2] = fmax(box[k + 2], fmax(n->piece[i].a[k], n->piece[i].b[k]));
        }
    memcpy(n->box[node], box, sizeof box);
    if (to - from > LEAF) {
        build(n, 2 * node + 1, from, (from + to) / 2);
        build(n, 2 * node + 2, (from + to) / 2, to);
    }
}

void nearest_build(nearest *n)
{
    size_t nodes = 1;

    for (size_t range = n->count; range > LEAF; range = (range + 1) / 2)
        nodes = 2 * nodes + 1;
    n->box = tool_grow(n->box, nodes * sizeof *n->box);
    build(n, 0, 0, n->count);
}

void nearest_free(nearest *n)
{
    free(n->piece);
    free(n->box);
    *n = (nearest){ 0 };
}

/* The state of a search; distances are squared. */
typedef struct {
    const nearest *n;
    const double *p;
    size_t best;
    double u, square;
} search;

static void try_piece(search *s, size_t i)
{
    const nearest_piece *q = &s->n->piece[i];
    const double dx = q->b[0] - q->a[0], dy = q->b[1] - q->a[1], px = s->p[0] - q->a[0],
                 py = s->p[1] - q->a[1];
    const double length = dx * dx + dy * dy;
    const double along = px * dx + py * dy,
                 u = along > 0 ? (along < length ? along / length : 1) : 0;
    const double ex = px - u * dx, ey = py - u * dy, square = ex * ex + ey * ey;

    if (square < s->square) {
        s->square = square;
        s->best   = i;
        s->u      = u;
    }
}

/* How far x is outside of least..most. No call of fmax: this takes most of a search. */
static double outside(double x, double least, double most)
{
    return x < least ? least - x : x > most ? x - most : 0;
}

static double box_distance(const double box[4], const double p[2])
{
    const double dx = outside(p[0], box[0], box[2]), dy = outside(p[1], box[1], box[3]);

    return dx * dx + dy * dy;
}

static void visit(search *s, size_t node, size_t from, size_t to)
{
    if (to - from <= LEAF) {
        for (size_t i = from; i < to; i++)
            try_piece(s, i);
        return;
    }
    const size_t middle = (from + to) / 2;
    const double left = box_distance(s->n->box[2 * node + 1], s->p),
                 right = box_distance(s->n->box[2 * node + 2], s->p);

    if (left <= right && left < s->square)
        visit(s, 2 * node + 1, from, middle);
    if (right < s->square)
        visit(s, 2 * node + 2, middle, to);
    if (right < left && left < s->square)
        visit(s, 2 * node + 1, from, middle);
}

size_t nearest_find(const nearest *n, const double p[2], size_t hint, double *u, double *distance)
{
    search s = { .n = n, .p = p, .square = HUGE_VAL };

    for (size_t i = hint > 0 ? hint - 1 : 0; i < n->count && i <= hint + 2; i++)
        try_piece(&s, i);
    visit(&s, 0, 0, n->count);
    *u = s.u;
    *distance = sqrt(s.square);
    return s.best;
}

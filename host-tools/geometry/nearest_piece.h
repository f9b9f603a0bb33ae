/* host-tools/geometry/nearest_piece.h -- finds the nearest of many line pieces to a point
 * SPDX-License-Identifier: MIT
 *
 *     nearest n = { 0 };
 *     nearest_add(&n, a, b); ...
 *     nearest_build(&n);
 *     i = nearest_find(&n, p, i, &u, &distance);      // the last answer is the best hint
 */
#ifndef LOFT_NEAREST_PIECE_H
#define LOFT_NEAREST_PIECE_H

#include <stddef.h>

typedef struct {
    double a[2], b[2];
} nearest_piece;

typedef struct {
    nearest_piece *piece;       /* in the order in which they were added                        */
    size_t count, room;
    double (*box)[4];           /* smallest x, y, largest x, y of each node of a tree over ranges */
} nearest;

void nearest_add(nearest *n, const double a[2], const double b[2]);
void nearest_build(nearest *n);
void nearest_free(nearest *n);

/* The index of the piece nearest to p; `u` 0..1 is the place on it. Pieces near `hint` are tried
 * first.
 *
 *   range   at least one piece
 *   cost    about log2(count) boxes if neighbours in the list are neighbours in the plane */
size_t nearest_find(const nearest *n, const double p[2], size_t hint, double *u, double *distance);

#endif

/* tests/support/lattices.h -- arbitrary lattice polygons
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_LATTICES_H
#define LOFT_TESTS_LATTICES_H

#include "check.h"                  /* CHECK */
#include "polygon/lattice.h"

/* Polygons with edges of any direction and length, corners with determinants 1 to 8. */
static const struct {
    loft_whole v[LOFT_SIDES_MAX];
    unsigned n;
} lattice_shape[] = {
    { { { { 0, 0 } }, { { 4, 0 } }, { { 0, 4 } } }, 3 },
    { { { { 0, 0 } }, { { 9, 0 } }, { { 0, 9 } } }, 3 },        /* LATTICE_WHOLE */
    { { { { 0, 0 } }, { { 1, 0 } }, { { 7, 1 } } }, 3 },
    { { { { 0, 0 } }, { { 3, 1 } }, { { 1, 3 } } }, 3 },
    { { { { -3, -2 } }, { { 5, -2 } }, { { 5, 1 } }, { { -3, 1 } } }, 4 },
    { { { { 0, -1 } }, { { 2, 0 } }, { { 0, 1 } }, { { -2, 0 } } }, 4 },
    { { { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 1, 2 } }, { { 0, 2 } } }, 5 },
    { { { { 0, 0 } }, { { 1, 0 } }, { { 2, 1 } }, { { 2, 2 } }, { { 1, 2 } }, { { 0, 1 } } }, 6 },
    { { { { 0, 0 } }, { { 2, 0 } }, { { 3, 1 } }, { { 3, 2 } }, { { 2, 3 } }, { { 0, 3 } } }, 6 },
    { { { { -3, -2 } }, { { 1, -3 } }, { { 4, 0 } }, { { 3, 3 } }, { { -1, 4 } }, { { -4, 1 } } },
      6 },                                                      /* LATTICE_WIDE */
    { { { { 0, 0 } },
        { { 4, 0 } },
        { { 6, 1 } },
        { { 6, 3 } },
        { { 4, 5 } },
        { { 1, 5 } },
        { { 0, 3 } } },
      7 },
    { { { { 1, 0 } },
        { { 2, 0 } },
        { { 3, 1 } },
        { { 3, 2 } },
        { { 2, 3 } },
        { { 1, 3 } },
        { { 0, 2 } },
        { { 0, 1 } } },
      8 },
};

enum {
    LATTICE_WHOLE = 1,
    LATTICE_WIDE = 9,
    LATTICES = sizeof lattice_shape / sizeof lattice_shape[0]
};

/* One of them, that begins at any of its vertices. */
static inline loft_lattice_polygon lattice_turned(arb *a, unsigned k)
{
    const unsigned n = lattice_shape[k].n, turn = arb_below(a, n);
    loft_whole v[LOFT_SIDES_MAX];
    loft_lattice_polygon l = { .sides = 0 };

    for (unsigned i = 0; i < n; i++)
        v[i] = lattice_shape[k].v[(i + turn) % n];
    CHECK(loft_lattice_polygon_init(&l, v, n) == LOFT_OK);
    return l;
}

static inline loft_lattice_polygon arb_lattice(arb *a)
{
    return lattice_turned(a, arb_below(a, LATTICES));
}

/* The largest height of a vertex over an edge. */
static inline unsigned lattice_height(const loft_lattice_polygon *l)
{
    unsigned most = 0;

    for (unsigned edge = 0; edge < l->sides; edge++)
        for (unsigned k = 0; k < l->sides; k++) {
            const unsigned h = (unsigned)loft_lattice_polygon_height(l, edge, l->edge[k].from);
            most = h > most ? h : most;
        }
    return most;
}

#endif

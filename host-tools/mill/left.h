/* host-tools/mill/left.h -- what a mill left on surfaces, by the places where its tool was
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_LEFT_H
#define LOFT_HOST_LEFT_H

#include "draw/mesh.h"
#include "mill/stock.h"
#include "read/record.h"

typedef struct {
    double radius, corner;      /* of the tool */
    double (*tip)[3];           /* where it was, bin by bin */
    size_t *start;              /* of each bin, and of the end */
    size_t count, bins[2];
    double low[2], size;        /* of the bins, mm */
    double most[2];             /* cut below the surface, and left on it, until now */
    const stock *block;         /* what there was before, or NULL: it had no top and no sides */
} left_over;

/* Sort the places of a record by bins. Those before the tool first goes down are its way to the
 * work, and do not count. Free with left_free. */
void left_make(left_over *l, const record *r, double radius, double corner);
void left_free(left_over *l);

/* The height of the material at a corner of a mesh, along its normal as if the surface were flat.
 * Below 0 it is cut: how deep it was in the tool at most. Where the tool never was it is 0, or the
 * height of the block. `context` is a left_over.
 *
 *   error   the surface's bend over the size of a cusp: below 1 % of what is left
 *   cost    one root for each place of the tool within its radius */
double left_at(void *context, const mesh_vertex *v);

/* Add what is left of the block beside the surfaces: a grid of about 200 cells along its longer
 * side without what is over the surfaces, and the sides. */
void left_around(void *context, mesh *m);

#endif

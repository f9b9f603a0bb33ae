/* host-tools/draw/mesh.h -- surfaces as triangles with normals and curvatures at their corners; STL
 * and PLY
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_MESH_H
#define LOFT_HOST_MESH_H

#include <stddef.h>

#include "engine/engine.h"
#include "engine/surface.h"

struct host;                /* base/host.h */

/* A corner of the mesh. Normal and curvatures come from the library in double. Where the surface
 * has none (at a pole that is an edge) they are those of a nearby point. */
typedef struct {
    double p[ENGINE_AXES], normal[ENGINE_AXES];
    double gauss, mean;         /* 1/mm^2, 1/mm: mean is positive where it bends towards the
                                 * normal */
    double u, v;                /* of a patch over a polygon: the point of the polygon */
} mesh_vertex;

/* A cell of the grid: 4 corners, or 3 with the last one twice; counterclockwise when the normal
 * points at the viewer. */
typedef struct {
    size_t corner[4];
    unsigned char line;         /* bit k: a line of the surface runs from corner k to k + 1: an edge
                                 * (then bit k + 4 is set too) or an inner line */
} mesh_cell;

typedef struct {
    mesh_vertex *vertex;
    mesh_cell *cell;
    size_t vertices, cells;
    size_t mapped;              /* vertices of the surfaces; those after them are around */
} mesh;

/* Add a grid of n x n cells for each surface (a triangle: n rows; n sides: kites of n/2 x n/2, see
 * sided.h). Points are in the number type of `e`. Every `lines`-th parameter line is marked. The
 * cells of a patch over a polygon cover the polygon once, whatever its shape. Returns 0, or an exit
 * code after printing one line. `*m` must be zeroed. */
int mesh_make(struct host *h, mesh *m, const surfaces *all, const char *file, const engine *e,
              unsigned n, unsigned lines);
void mesh_free(mesh *m);

/* The principal curvature of larger absolute value, without its sign. */
double mesh_bend(const mesh_vertex *v);

/* Write the mesh. The extension of `output` decides: .stl (binary) or .ply (binary, with normals).
 * *triangles: how many were written; those without area are left out. */
int mesh_write(struct host *h, const mesh *m, const char *output, size_t *triangles);

#endif

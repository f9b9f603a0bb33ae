/* host-tools/draw/mesh.h -- triangles of surfaces, normals and curvatures at their corners; STL and
 * PLY
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_MESH_H
#define LOFT_HOST_MESH_H

#include <stddef.h>

#include "engine/engine.h"
#include "engine/surface.h"

/* A corner of the mesh. Normal and curvatures are those of the library in double; where the surface
 * has none, as at a pole that is an edge, those next to it. */
typedef struct {
    double p[ENGINE_AXES], normal[ENGINE_AXES];
    double gauss, mean;         /* 1/mm^2, 1/mm: positive mean where it bends towards the normal */
    double u, v;                /* of a patch over a polygon: the point of the polygon */
} mesh_vertex;

/* A cell of the grid: 4 corners, or 3 and the last one twice; counterclockwise seen from where the
 * normal points. */
typedef struct {
    size_t corner[4];
    unsigned char line;         /* bit k: from corner k to k + 1 runs a line of the surface: an edge
                                 * (bit k + 4 as well) or inside */
} mesh_cell;

typedef struct {
    mesh_vertex *vertex;
    mesh_cell *cell;
    size_t vertices, cells;
} mesh;

/* Add a grid of n x n cells (a triangle: n rows; n sides: kites of n/2 x n/2, sided.h) of each
 * surface, points in the number type of `e`; every `lines`-th parameter line is marked. The cells
 * of a patch over a polygon cover the polygon once, whatever its shape. Gives 0 or an exit code
 * after printing one line. `*m` must be zeroed. */
int mesh_make(mesh *m, const surfaces *all, const char *file, const engine *e, unsigned n,
              unsigned lines);
void mesh_free(mesh *m);

/* The curvature with the larger size of the two principal ones, without its sign. */
double mesh_bend(const mesh_vertex *v);

/* Write it: the ending of `output` decides, .stl (binary) or .ply (binary, with normals).
 * *triangles: how many, those without area left away. */
int mesh_write(const mesh *m, const char *output, size_t *triangles);

#endif

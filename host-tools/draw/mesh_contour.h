/* host-tools/draw/mesh_contour.h -- lines of equal height on a mesh
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MESH_CONTOUR_H
#define LOFT_MESH_CONTOUR_H

#include "draw/mesh.h"

/* Give the pieces of the line z = height: one for each triangle of a cell that it crosses, straight
 * between linear interpolations. The pieces of neighbouring triangles meet; none is given twice. */
typedef void contour_sink(void *context, size_t cell, const double from[ENGINE_AXES],
                          const double to[ENGINE_AXES]);
void contour_lines(const mesh *m, double height, contour_sink *sink, void *context);

/* Choose about `count` round heights between the lowest and the highest vertex. Returns how many,
 * at most `most`. */
size_t contour_heights(const mesh *m, unsigned count, double out[], size_t most);

#endif

/* host-tools/geometry/solid.h -- tetrahedra as their faces
 * SPDX-License-Identifier: MIT
 *
 * What has two parameters takes a tetrahedron as its four faces, triangles with the normal outward
 * if T1 T2 T3 T4 is right-handed: T1 T3 T2, T1 T2 T4, T1 T4 T3, T2 T3 T4.
 */
#ifndef LOFT_HOST_SOLID_H
#define LOFT_HOST_SOLID_H

#include "engine/surface.h"     /* surfaces */

/* Replace each tetrahedron of the list by its faces, in its place. */
void solid_faces(surfaces *all);

#endif

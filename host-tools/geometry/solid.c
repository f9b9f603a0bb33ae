/* host-tools/geometry/solid.c
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "geometry/solid.h"

/* The index of b_ijkl, as in surface/tetra.h. */
static unsigned place_of(const unsigned times[4])
{
    const unsigned n = times[2] + times[3], m = times[1] + n;

    return m * (m + 1) * (m + 2) / 6 + n * (n + 1) / 2 + times[3];
}

static void add_face(surfaces *all, const surface *solid, const unsigned char corner[3])
{
    surface *face = surfaces_add(all, SURFACE_TRIANGLE, solid->line);

    face->m = solid->m;
    for (unsigned row = 0; row <= solid->m; row++)
        for (unsigned k = 0; k <= row; k++) {
            unsigned times[4] = { 0 };
            times[corner[0]] = solid->m - row;
            times[corner[1]] = row - k;
            times[corner[2]] = k;
            surface_add_point(face, &solid->point[place_of(times)]);
        }
}

void solid_faces(surfaces *all)
{
    static const unsigned char corner[4][3] = {
        { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 }
    };
    surfaces given = *all;

    *all = (surfaces){ .solids = given.solids };
    for (size_t i = 0; i < given.count; i++) {
        surface *s = &given.surface[i];
        if (s->kind != SURFACE_TETRA) {
            *surfaces_add(all, s->kind, s->line) = *s;
            *s = (surface){ .kind = s->kind };      /* its points have moved */
        }
        for (int k = 0; k < 4 && s->kind == SURFACE_TETRA; k++)
            add_face(all, s, corner[k]);
    }
    surfaces_free(&given);
}

/* host-tools/draw/gallery.h -- several pictures of surfaces in one, with one colour bar
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_GALLERY_H
#define LOFT_HOST_GALLERY_H

#include "draw/mesh.h"
#include "engine/surface.h"

typedef struct {
    const mesh *m;
    const double *value;        /* of each vertex: a map of it; NULL: shaded */
    const double *level;        /* contours at these heights                 */
    size_t levels;
    const surfaces *net;        /* whose control nets are drawn; NULL: none  */
    const char *title;          /* above it                                  */
} gallery_panel;

typedef struct {
    const char *title, *output; /* the ending of `output` decides: .png .svg .pdf */
    const char *values;         /* what the maps show, with its unit */
    const char *note;           /* below everything: what the lines are; NULL: none */
    bool signs;                 /* the values have both signs */
    double limit;               /* what the ends of the maps stand for; 0: as the values of all
                                 * panels say */
    unsigned columns;
    double azimuth, elevation, distance;        /* as those of a scene; elevation 90: from above, y
                                                 * upward for azimuth -90 */
    double size;                /* width: px of a PNG, mm of the others; 0: 1600 px, 160 mm */
} gallery;

/* Draw, panel by panel, row by row. Gives 0, or an exit code after printing one line. */
int gallery_draw(const gallery *g, const gallery_panel panel[], size_t count);

#endif

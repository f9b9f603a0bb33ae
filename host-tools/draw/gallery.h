/* host-tools/draw/gallery.h -- several pictures of surfaces in one, with one colour bar
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_GALLERY_H
#define LOFT_HOST_GALLERY_H

#include "draw/mesh.h"
#include "engine/surface.h"

struct host;                /* base/host.h */

typedef struct {
    const mesh *m;
    const double *value;        /* of each vertex: draw a map of it; NULL: shade */
    const double *level;        /* contours at these heights                 */
    size_t levels;
    const surfaces *net;        /* draw the control nets of these; NULL: none */
    const char *title;          /* above it                                  */
} gallery_panel;

typedef struct {
    const char *title, *output; /* the file name extension of `output` decides: .png .svg .pdf */
    const char *values;         /* what the maps show, and its unit */
    const char *note;           /* text below everything: what the lines mean; NULL: none */
    bool signs;                 /* the values have both signs */
    double limit;               /* the value at the ends of the colour scale; 0: from the values of
                                 * all panels */
    unsigned columns;
    double azimuth, elevation, distance;        /* as in a scene; elevation 90: from above; y points
                                                 * up if azimuth is -90 */
    double size;                /* width: px of a PNG, mm of the others; 0: 1600 px, 160 mm */
} gallery;

/* Draw the panels row by row. Returns 0, or an exit code after printing one line. */
int gallery_draw(struct host *told, const gallery *g, const gallery_panel panel[], size_t count);

#endif

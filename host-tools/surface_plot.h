/* host-tools/surface_plot.h -- pictures of surfaces: shaded, with parameter lines, control nets, maps of curvature
 * SPDX-License-Identifier: MIT
 *
 *     surface_plot.c   the view, what hides what, shades and colours
 *     surface_frame.c  what stands around it: title, axes, legend, scale and colour bar
 */
#ifndef LOFT_HOST_SURFACE_PLOT_H
#define LOFT_HOST_SURFACE_PLOT_H

#include "mesh.h"
#include "plot.h"           /* plot_view: canvas and unit */
#include "surface.h"

enum surface_map { MAP_NONE, MAP_GAUSS, MAP_MEAN, MAP_LARGEST };

typedef struct {
    const surfaces *all;
    const char *name;           /* of the file, for the title */
    const char *output;
    const engine *e;
    enum surface_map map;
    bool control, wire;         /* control nets; parameter lines only, nothing hidden           */
    double azimuth, elevation;  /* degrees: from where it is seen, from +x towards +y, and up   */
    double distance;            /* of the eye, in diameters of the surface; 0: endless          */
    double size;                /* width: px of a PNG, mm of the others; 0: 1600 px, 160 mm     */
} surface_options;

/* Draw. Gives 0, or an exit code after printing one line. */
int surface_plot(const surface_options *o);


// Between the files
// -----------------

typedef struct {
    plot_view v;                /* canvas, frame, unit; scale: canvas units per mm in the middle */
    const surface_options *o;
    double axis[3][3];          /* right, up, towards the eye                                    */
    double centre[3], diameter;
    double limit;               /* of the map: what its ends stand for; 0: nothing to show       */
    bool clipped;               /* there is more than that                                       */
} surface_view;

/* The colour of a value of the map. */
void surface_colour(const surface_view *s, double value, double rgb[3]);

/* The colours of the two sides without a map. */
extern const double surface_sides[2][3];

void surface_frame(surface_view *s);

#endif

/* host-tools/draw/surface_plot.h -- a picture of surfaces: shaded, with parameter lines, control
 * nets, contours, maps of curvature
 * SPDX-License-Identifier: MIT
 *
 *     scene.c          the view, hidden parts, shades and colours
 *     scene_label.c    heights written on contours
 *     surface_plot.c   one picture of all surfaces of a file
 *     surface_frame.c  the frame: title, axes, legend, scale
 */
#ifndef LOFT_HOST_SURFACE_PLOT_H
#define LOFT_HOST_SURFACE_PLOT_H

#include "draw/scene.h"

struct host;                /* base/host.h */

enum surface_map { MAP_NONE, MAP_GAUSS, MAP_MEAN, MAP_LARGEST, MAP_GIVEN };

typedef struct {
    const surfaces *all;
    const char *name;           /* of the file, for the title */
    const char *output;
    const engine *e;
    enum surface_map map;
    double (*value)(void *context, const mesh_vertex *v);       /* MAP_GIVEN: the map's values */
    void *context;
    const char *words;          /* MAP_GIVEN: what they are */
    void (*around)(void *context, mesh *m);     /* MAP_GIVEN: adds what is around, or NULL */
    const char *around_words;
    bool control, wire;         /* control nets; parameter lines only, nothing hidden           */
    unsigned contours;          /* about this many contours, at round heights */
    const double *height;       /* or contours at these heights */
    size_t heights;
    double azimuth, elevation;  /* degrees: the view direction, from +x towards +y, and up */
    double distance;            /* of the eye, in diameters of the surface; 0: infinite */
    double size;                /* width: px of a PNG, mm of the others; 0: 1600 px, 160 mm     */
} surface_options;

/* Draw. Returns 0, or an exit code after printing one line. */
int surface_plot(struct host *h, const surface_options *o);


// Between the files
// -----------------

#define SURFACE_HEIGHTS 200

typedef struct {
    plot_view v;                /* canvas, frame, unit; scale: canvas units per mm in the middle */
    const surface_options *o;
    scene scene;
    double height[SURFACE_HEIGHTS];     /* of the contours */
    size_t heights;
} surface_view;

void surface_frame(const surface_view *s);

/* Draw the three directions as they appear in the view, around (x, y). */
void surface_axes(const plot_view *v, const scene *s, double x, double y);

/* Describe the heights of the contours in words. */
void surface_heights(char *out, size_t size, const double height[], size_t count);

#endif

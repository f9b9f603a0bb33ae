/* host-tools/draw/scene.h -- a view of a mesh: shaded, or coloured by values, with nets and
 * contours
 * SPDX-License-Identifier: MIT
 *
 *     scene s = { .m = &m, .azimuth = -55, .elevation = 28 };
 *     scene_net(&s, &all);
 *     scene_contour(&s, 2.5);
 *     scene_look(&s);             // its extent is in s.seen
 *     scene_paint(&s, &view);     // view: the mapping from mm to the canvas
 *     scene_free(&s);
 */
#ifndef LOFT_HOST_SCENE_H
#define LOFT_HOST_SCENE_H

#include "draw/mesh.h"
#include "draw/plot.h"           /* plot_view */
#include "engine/surface.h"

/* The colours of a map: from dark to bright; or, with `signs`, blue below 0, white, red above. */
typedef struct {
    double limit;               /* the value at its ends; 0: none */
    bool signs;
    bool clipped;               /* some values are larger */
} scene_scale;

/* What is drawn over a mesh: a line of a net, a point of it (both ends in one place), a piece of a
 * contour, or of the border. */
enum scene_pen { SCENE_NET, SCENE_CONTOUR, SCENE_EDGE };

typedef struct {
    double p[2][3];
    enum scene_pen pen;
    size_t cell;                /* of a contour: its cell */
} scene_line;

typedef struct {
    const mesh *m;
    const double *value;        /* of each vertex: draw a map; NULL: the colours of the two sides */
    scene_scale scale;
    bool wire;                  /* lines of the mesh only, nothing hidden */
    bool plain;                 /* of the lines of the mesh, only the edges of the surfaces */
    double azimuth, elevation;  /* degrees: the view direction, from +x towards +y, and up */
    double distance;            /* of the eye, in diameters; 0: infinite */
    scene_line *line;
    size_t lines;
    double axis[3][3];          /* set by scene_look from here on: right, up, towards the eye */
    double centre[3], diameter;
    double seen[2][2];          /* the smallest and largest x and y in the picture, mm */
} scene;

/* Add a line, the control nets of surfaces, or a contour. */
void scene_add(scene *s, enum scene_pen pen, const double from[3], const double to[3]);
void scene_net(scene *s, const surfaces *all);
void scene_contour(scene *s, double height);

void scene_look(scene *s);

/* Choose the scale on the canvas (units per mm) that centres everything in the frame of `v`:
 * v->scale, x0, y0. */
void scene_fit(const scene *s, plot_view *v);
void scene_paint(const scene *s, const plot_view *v);

/* Write the heights on the visible contours. */
void scene_label(const scene *s, const plot_view *v);

/* The place of a point on the canvas, and its nearness. */
void scene_place(const scene *s, const plot_view *v, const double p[3], double out[3]);
void scene_free(scene *s);


// Colours
// -------

/* The ends of a map of these values: a range that holds 98 of 100 of them, if some are far outside.
 * Sizes up to `flat` count as 0. */
void scene_scale_of(scene_scale *s, const double value[], size_t count, double flat);

void scene_colour(const scene_scale *s, double value, double rgb[3]);

/* The colours of the two sides without a map, of what is around the surfaces, and of lines, nets
 * and contours. */
extern const double scene_sides[2][3], scene_around[3], scene_pens[3][3];

/* Draw a colour bar with numbers, below the words that say what it shows. */
void scene_bar(const plot_view *v, const scene_scale *s, const char *words, double x, double top,
               double high);

#endif

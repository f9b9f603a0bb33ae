/* host-tools/draw/scene.h -- a mesh as it is seen: shaded, or coloured by values, with nets and
 * contours on it
 * SPDX-License-Identifier: MIT
 *
 *     scene s = { .m = &m, .azimuth = -55, .elevation = 28 };
 *     scene_net(&s, &all);
 *     scene_contour(&s, 2.5);
 *     scene_look(&s);             // what it measures is in s.seen
 *     scene_paint(&s, &view);     // view: where mm are on the canvas
 *     scene_free(&s);
 */
#ifndef LOFT_HOST_SCENE_H
#define LOFT_HOST_SCENE_H

#include "draw/mesh.h"
#include "draw/plot.h"           /* plot_view */
#include "engine/surface.h"

/* The colours of a map: from dark to bright, or with `signs` blue below 0, white, red above. */
typedef struct {
    double limit;               /* what its ends stand for; 0: there is nothing to show */
    bool signs;
    bool clipped;               /* there is more than that                              */
} scene_scale;

/* What is drawn over a mesh: a line of a net, a point of it (both ends in one place), a piece of a
 * contour, of the border. */
enum scene_pen { SCENE_NET, SCENE_CONTOUR, SCENE_EDGE };

typedef struct {
    double p[2][3];
    enum scene_pen pen;
    size_t cell;                /* of a contour: where it lies */
} scene_line;

typedef struct {
    const mesh *m;
    const double *value;        /* of each vertex: a map of them; NULL: the colours of the two
                                 * sides */
    scene_scale scale;
    bool wire;                  /* lines of the mesh only, nothing hidden */
    bool plain;                 /* of the lines of the mesh only the edges of the surfaces */
    double azimuth, elevation;  /* degrees: from where it is seen, from +x towards +y, and up */
    double distance;            /* of the eye, in diameters; 0: endless */
    scene_line *line;
    size_t lines;
    double axis[3][3];          /* from here on by scene_look: right, up, towards the eye */
    double centre[3], diameter;
    double seen[2][2];          /* the least and the most x and y in the picture, mm */
} scene;

/* Put a line, the control nets of surfaces, a contour over it. */
void scene_add(scene *s, enum scene_pen pen, const double from[3], const double to[3]);
void scene_net(scene *s, const surfaces *all);
void scene_contour(scene *s, double height);

void scene_look(scene *s);

/* The scale on the canvas, units per mm, so that all of it is in the middle of the frame of `v`:
 * v->scale, x0, y0. */
void scene_fit(const scene *s, plot_view *v);
void scene_paint(const scene *s, const plot_view *v);

/* Write their heights on the contours that are seen. */
void scene_label(const scene *s, const plot_view *v);

/* Where a point is on the canvas, and how near. */
void scene_place(const scene *s, const plot_view *v, const double p[3], double out[3]);
void scene_free(scene *s);


// Colours
// -------

/* The ends of a map of these values: what 98 of 100 of them keep within, when some are far beyond;
 * sizes to `flat` are 0. */
void scene_scale_of(scene_scale *s, const double value[], size_t count, double flat);

void scene_colour(const scene_scale *s, double value, double rgb[3]);

/* The colours of the two sides without a map, of lines, nets and contours. */
extern const double scene_sides[2][3], scene_pens[3][3];

/* A bar of the colours of a map with numbers, below the words that say what it shows. */
void scene_bar(const plot_view *v, const scene_scale *s, const char *words, double x, double top,
               double high);

#endif

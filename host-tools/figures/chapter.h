/* host-tools/figures/chapter.h -- the pentagonal patch of `loft study gb`, over any pentagon and
 * with any coordinates
 * SPDX-License-Identifier: MIT
 *
 * A generalized Bezier patch with 5 sides of degree 5. Side i of its net lies over side i of the
 * pentagon; with c the mean of the vertices, row 0 divides the side into fifths, rows 1 and 2 have
 * the corners 2/3 v + 1/3 c and 1/3 v + 2/3 c and divide evenly between them; heights are 0.4
 * (min(j, 5 - j) + k), that of V0, over c, is 1.6.
 *
 *     engine_chapter.c    the patch through the library; compiled once per number type
 *     chapter.c           the pentagons, the net, curvatures at a point
 *     chapter_study.c     the quantities: fractions of the area, ridges and valleys,
 *                         curvatures
 *     cmd_study.c         the command: numbers next to the expected ones, pictures
 */
#ifndef LOFT_HOST_CHAPTER_H
#define LOFT_HOST_CHAPTER_H

#include <stdbool.h>
#include <stddef.h>

#define CHAPTER_SIDES 5
#define CHAPTER_V0    1.6
#define CHAPTER_KINDS 3     /* Wachspress, mean values, harmonic */

/* A function of the point of the pentagon, with its derivatives by x, y, xx, xy and yy. */
typedef struct {
    double f, x, y, xx, xy, yy;
} chapter_jet;

/* The weight of V0, and the point. If V0 is higher by dz, the height is p[2] + dz b0. */
typedef struct {
    chapter_jet b0, p[3];
    bool bent;                  /* there are derivatives: not at vertices */
} chapter_point;

typedef struct engine_chapter engine_chapter;

#define CHAPTER_FAN 4

typedef struct {
    bool rough;                 /* coordinates have 32 bits: numbers err by the rounding of the
                                 * pentagon and the net */
    /* kind: 0, 1, 2. Returns enum loft_status; after an error there is nothing to close. */
    int (*open)(const double v[CHAPTER_SIDES][2], unsigned kind, engine_chapter **out);
    void (*close)(engine_chapter *e);
    int (*at)(const engine_chapter *e, double x, double y, bool bent, chapter_point *out);
    /* The Gaussian curvature of a fan of triangles, from its angle deficit. */
    int (*fan)(const double vertex[3], double ring[][3], unsigned count, double *gauss);
} engine_chapters;

extern const engine_chapters engine_chapters_q16, engine_chapters_f32, engine_chapters_f64;
extern const char *const chapter_kinds[CHAPTER_KINDS];      /* W MV H */

typedef struct {
    const char *name;
    double v[CHAPTER_SIDES][2];
} chapter_pentagon;

extern const chapter_pentagon chapter_pentagons[3];

/* The mean of the vertices, and point (j, k) of the net of side i. */
void chapter_middle(const double v[CHAPTER_SIDES][2], double c[2]);
void chapter_net(const double v[CHAPTER_SIDES][2], unsigned side, unsigned j, unsigned k,
                 double out[3]);

// What is asked of it
// -------------------

/* A quantity: its name, `figure;pentagon;quantity;coordinates`, and its numbers. `off` is the
 * allowed difference from another computation of the same quantity. */
typedef struct {
    char key[260];
    double value[5], off;
    unsigned count;
    bool sampled;               /* computed from many points: rough if there are few */
} chapter_row;

typedef void chapter_sink(void *context, const chapter_row *r);

/* All quantities of a pentagon, from a grid of `fine`^2 triangles in each of its five triangles: 60
 * gives 18000 points. Returns enum loft_status.
 *
 *   cost    f64: 5 s for 60 */
int chapter_study(const engine_chapters *e, const chapter_pentagon *p, unsigned fine,
                  chapter_sink *sink, void *context);

/* The height with V0 higher by dz, times `scale`. The Gaussian curvature with all heights divided
 * by 8 and V0 at `height`. The second derivative of the height along its contour, over the plane,
 * with V0 higher by dz: above 0 in a valley that runs downhill, below 0 on a ridge. */
chapter_jet chapter_height(const chapter_point *p, double scale, double dz);
double chapter_gauss(const chapter_point *p, double height);
double chapter_across(const chapter_point *p, double dz);

#endif

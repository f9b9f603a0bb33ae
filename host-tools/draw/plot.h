/* host-tools/draw/plot.h -- pictures: the drawing, its control polygons, curvature, the machine's
 * path, the magnified error
 * SPDX-License-Identifier: MIT
 *
 *     plot.c        the picture: layers in mm
 *     plot_shape.c  control polygons, knots and curvature combs
 *     plot_corner.c an inset: a corner, magnified
 *     plot_frame.c  the frame: axes, title, legend, scale and colour bar
 */
#ifndef LOFT_PLOT_H
#define LOFT_PLOT_H

#ifdef LOFT_WITHOUT_CAIRO
typedef struct cairo_t cairo_t;             /* there is none */
typedef struct cairo_surface_t cairo_surface_t;
#else
#include <cairo.h>
#endif
#include <stdbool.h>
#include <stdio.h>

#include "read/drawing.h"
#include "read/record.h"

struct host;                /* base/host.h */

#define PLOT_NO_ERROR   (-1.0)
#define PLOT_AUTO_ERROR 0.0
#define PLOT_NO_COMB    (-1.0)
#define PLOT_AUTO_COMB  0.0

typedef struct {
    const drawing *d;
    const record *r;            /* NULL: none */
    bool control;               /* draw the control polygons, and knots where curves are splines */
    double comb;                /* mm of a comb's tooth for a curvature of 1/mm; PLOT_AUTO_COMB,
                                 * PLOT_NO_COMB */
    double error;               /* magnification of errors; PLOT_AUTO_ERROR, PLOT_NO_ERROR */
    double tol;                 /* mm: an inset shows a corner of the record and this band around
                                 * the drawing; 0: none */
    double part[4];             /* visible part: x, y, width, height in mm; width 0: everything */
    double size;                /* width: px of a PNG, mm of the others; 0: 1600 px, or true to
                                 * scale */
    const char *name;           /* of the drawing, for the title */
    const char *output;         /* its extension decides: .png .svg .pdf */
} plot_options;

/* What a plot measures. */
typedef struct {
    double worst, worst_point[2];       /* mm; the worst path error and its place; 0 without a
                                         * record */
    double mean;                        /* mm                                                     */
    size_t drawing_pulses;              /* with the pen down                                      */
    bool inset;                         /* it shows the corner at                                 */
    double corner[2];
} plot_result;

/* Draw. Returns 0, or a code of <sysexits.h> after printing one line. */
int plot_draw(struct host *h, const plot_options *o, plot_result *result);


// Between the files
// -----------------

/* A tooth of a comb: it points from the curve away from the centre of curvature. */
typedef struct {
    double foot[2], tip[2];
    bool fresh;                 /* does not follow the tooth before it */
} plot_tooth;

/* The mapping from mm to the canvas, and the data to show. */
typedef struct {
    const plot_options *o;
    cairo_t *cairo;
    FILE *file;                 /* the picture; failed: its error, of errno */
    int failed;
    double u;                   /* a thousandth of the canvas width: the unit of line widths and
                                 * letters */
    double width, height;       /* canvas */
    double left, top, right, bottom;    /* the frame on the canvas */
    double x0, y0, scale;       /* mm at its lower left corner; canvas units per mm */
    double magnified;           /* magnification of errors; 0: not shown */
    bool inset;                 /* a corner is shown at the right, plot_corner.c */
    plot_tooth *tooth;
    size_t teeth;
    double comb;                /* mm per 1/mm; 0: no combs */
    plot_result found;
} plot_view;

/* The colour for a share 0..1 of the worst error. */
void plot_colour(double share, double rgb[3]);

void plot_frame(plot_view *v);

/* The curves, as wide as `line` thousandths of the width. */
void plot_curves(const plot_view *v, double line, double r, double g, double b);

/* Runs of pulses as lines: the drawing ones, or the travels. */
void plot_machine(const plot_view *v, bool drawing_runs);

/* The inset at the upper right, beside the frame, and what is below it: thousandths of the width.
 * Frames with it are at least so tall. */
#define PLOT_INSET 226
#define PLOT_BELOW 74
#define PLOT_TALL  (PLOT_INSET + PLOT_BELOW + 130)
void plot_corner(plot_view *whole);

/* The corner of the drawing next to a place; NULL: it has none. */
const double *plot_corner_at(const drawing *d, const double near[2]);

/* A stroke that grows point by point and may change its colour: level 0..PLOT_LEVELS - 1.
 * plot_brush_up ends it. */
#define PLOT_LEVELS 24
typedef struct {
    const plot_view *v;
    double at[2];               /* mm */
    int level;
    bool open;
} plot_brush;
void plot_brush_to(plot_brush *b, const double to[2], int level);
void plot_brush_up(plot_brush *b);

/* Parts of frames: axes in mm; a legend entry at *x, y, which advances *x; a colour bar beside the
 * frame, from 0 to `most`, with the words below it. */
void plot_axes(const plot_view *v);
void plot_entry(const plot_view *v, double *x, double y, const double rgb[3], double wide,
                bool dashed, const char *words);
void plot_bar(const plot_view *v, double most, const char *words);

/* Elements of frames: a grey; text at (x, y), where align 0 means start, 1/2 centre, 1 end (returns
 * its width); a line; a step of 1, 2 or 5 times a power of ten, so that `range` has about `count`
 * steps; a number with the digits that a step needs; a file name without its folders. */
#define PLOT_SMALL 12.5         /* letters, in thousandths of the width */
#define PLOT_LARGE 17.0
void   plot_ink(const plot_view *v, double grey);
double plot_text(const plot_view *v, double size, double x, double y, double align,
                 const char *words);
void   plot_line(const plot_view *v, double x0, double y0, double x1, double y1);
double plot_step(double range, double count);

/* Draw a round length at the lower right, about 1/`parts` of the picture's width, at the height
 * y. */
void   plot_scale_bar(const plot_view *v, double y, double parts);
void   plot_number(char *out, size_t size, double value, double step);
const char *plot_base_name(const char *path);

/* Tell whether the extension of `output` is known, and whether it is a PNG. Begin a picture of that
 * format: v->cairo on a canvas of v->width x v->height. End it: returns an exit code after printing
 * one line. `v` must not move in between. */
bool plot_known(const char *output, bool *png);
cairo_surface_t *plot_begin(plot_view *v, const char *output);
int  plot_end(struct host *h, plot_view *v, cairo_surface_t *canvas, const char *output);

/* The position of a point in mm on the canvas. */
double plot_x(const plot_view *v, double x);
double plot_y(const plot_view *v, double y);

/* The smallest box around box and p. */
void plot_join(double box[2][2], const double p[2]);

/* The teeth of all combs, for curves within `box`; v->tooth is to be freed. */
void plot_make_combs(plot_view *v, const double box[2][2]);

/* Widen the box by the extent of the layers below. */
void plot_shape_box(const plot_view *v, double box[2][2]);

void plot_combs(const plot_view *v);
void plot_control(const plot_view *v);

#endif

/* host-tools/plot.h -- pictures: the drawing, its control polygons, what the machine drew, the error magnified
 * SPDX-License-Identifier: MIT
 *
 *     plot.c        the picture: layers over each other, in mm
 *     plot_frame.c  what stands around it: axes, title, legend, scale and colour bar
 */
#ifndef LOFT_PLOT_H
#define LOFT_PLOT_H

#include <cairo.h>
#include <stdbool.h>

#include "drawing.h"
#include "record.h"

#define PLOT_NO_ERROR   (-1.0)
#define PLOT_AUTO_ERROR 0.0

typedef struct {
    const drawing *d;
    const record *r;            /* NULL: none                                                               */
    bool control;               /* draw the control polygons                                                */
    double error;               /* how many times errors are magnified; PLOT_AUTO_ERROR, PLOT_NO_ERROR      */
    double part[4];             /* x, y, width, height in mm of what is shown; width 0: everything          */
    double size;                /* width: px of a PNG, mm of the others; 0: 1600 px, or true to scale       */
    const char *name;           /* of the drawing, for the title                                            */
    const char *output;         /* its ending decides: .png .svg .pdf                                       */
} plot_options;

/* What a plot found out on its way. */
typedef struct {
    double worst, worst_point[2];       /* mm; the worst path error and where; without a record 0 */
    double mean;                        /* mm                                                     */
    size_t drawing_pulses;              /* with the pen down                                      */
} plot_result;

/* Draw. Gives 0, or a code of <sysexits.h> after printing one line. */
int plot_draw(const plot_options *o, plot_result *result);


// Between the two files
// ---------------------

/* Where mm are on the canvas, and what is shown. */
typedef struct {
    const plot_options *o;
    cairo_t *cairo;
    double u;                   /* a thousandth of the canvas' width: unit of line widths and letters   */
    double width, height;       /* canvas                                                               */
    double left, top, right, bottom;    /* the frame on the canvas                                      */
    double x0, y0, scale;       /* mm at its lower left corner; canvas units per mm                     */
    double magnified;           /* by how much errors are; 0: they are not shown                        */
    plot_result found;
} plot_view;

/* The colour of a share 0..1 of the worst error. */
void plot_colour(double share, double rgb[3]);

void plot_frame(plot_view *v);

#endif

/* host-tools/draw/export.h -- writes a drawing to a file of another kind
 * SPDX-License-Identifier: MIT
 *
 * In the order of the drawing, y up except in SVG. Travels of a program are left out, since these
 * files have none.
 */
#ifndef LOFT_EXPORT_H
#define LOFT_EXPORT_H

#include <stdio.h>

#include "read/drawing.h"

typedef struct {
    struct host *host;      /* base/host.h */
    const drawing *d;
    const char *name;       /* for messages */
    double tol;             /* mm, of chords */
    const drawing_names *layers;    /* their names; NULL: none is known */
} export_options;

/* Returns 0, or an exit code after printing one line; the caller looks at errors of `out`. */
typedef int export_form(const export_options *o, FILE *out);

/* Curves as they are, seen from above, one <path> for each path, in mm on the page of the drawing
 * or, without one, of its box. Paths that follow each other in a layer are in a layer of its name.
 *
 *   error   5e-7 mm, for the decimals */
export_form export_svg;

/* x0,y0,..,x3,y3 in mm, one cubic a line. A drawing in space is refused. Error: 5e-7 mm. */
export_form export_csv;

/* As `bezier 3` (host-tools/LOFT.md), with z in space. Error: 5e-7 mm. */
export_form export_loft;

/* HP-GL: chords, pen 1, 40 units a mm, y up.
 *
 *   error   tol, and 0.018 mm for rounding both coordinates */
export_form export_hpgl;

#endif

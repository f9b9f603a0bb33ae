/* host-tools/drawing.h -- a drawing: cubic curves in mm, y up, in drawing order
 * SPDX-License-Identifier: MIT
 *
 * Readers (svg.c, csv.c) fill it; lines and arcs are cubics too. A path is a connected run of curves that is
 * drawn with the pen down; between paths the pen travels.
 */
#ifndef LOFT_DRAWING_H
#define LOFT_DRAWING_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    double p[4][2];         /* control points, mm, y up, origin at the lower left corner of the page */
    unsigned path;          /* 0, 1, 2 ..: curves of one path follow each other and are connected    */
    unsigned line;          /* line of the file that it came from                                    */
} drawing_curve;

typedef struct {
    drawing_curve *curve;
    size_t count, room;
    double width, height;   /* page in mm; 0 when the file names none */
} drawing;

/* Read `file` ("-" is standard input), by its content: SVG or CSV (x0,y0,..,x3,y3 in mm per line).
 * Returns 0, or a code of <sysexits.h> after printing one line. `*d` must be zeroed; free with drawing_free. */
int  drawing_read(drawing *d, const char *file);
void drawing_free(drawing *d);

/* Append one curve; `fresh` begins a new path. For readers. */
void drawing_add(drawing *d, const double p[4][2], bool fresh, unsigned line);

/* The true length in mm, to 1e-6 relative. */
double drawing_length(const drawing *d);

#endif

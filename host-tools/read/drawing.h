/* host-tools/read/drawing.h -- a drawing: cubic curves in mm, y up, in drawing order
 * SPDX-License-Identifier: MIT
 *
 * Readers (svg.c, csv.c, drawing_curves.c) fill it; lines and arcs are cubics too. A path is a
 * connected run of curves that is drawn with the pen down; between paths the pen travels. Nothing
 * is clipped, and paint does not matter: a plotter draws outlines.
 */
#ifndef LOFT_DRAWING_H
#define LOFT_DRAWING_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    double p[4][2];         /* control points, mm, y up, origin at the lower left corner of the
                             * page */
    unsigned path;          /* 0, 1, 2 ..: curves of one path follow each other and are connected */
    unsigned line;          /* line of the file that it came from */
} drawing_curve;

typedef struct {
    drawing_curve *curve;
    size_t count, room;
    double width, height;   /* page in mm; 0 when the file names none          */
    struct curves *of;      /* the curves that became cubics; NULL: they were  */
} drawing;

/* mm; coordinates beyond +- this are refused: they must fit Q16.16 sums */
#define DRAWING_LIMIT 16000.0
#define DRAWING_CURVES_MAX 4000000u /* more are refused: a file of some kB can ask for billions */

/* Read `file` ("-" is standard input), by its content: SVG, curves (LOFT.md) or CSV (x0,y0,..,x3,y3
 * in mm per line). Returns 0, or a code of <sysexits.h> after printing one line. `*d` must be
 * zeroed; free with drawing_free. */
int  drawing_read(drawing *d, const char *file);
void drawing_free(drawing *d);

/* Append one curve; `fresh` begins a new path (the first curve always does). For readers, which
 * keep the limits. */
void drawing_add(drawing *d, double p[4][2], bool fresh, unsigned line);

/* The same for what may go on where the curve before it ends: then it does, exactly. A curve
 * without length is left out, one beyond the limits refused with one line. */
int drawing_join(drawing *d, const char *file, unsigned line, double p[4][2]);

/* The point of a curve at t in 0..1, and its derivative by t. */
void drawing_eval(const drawing_curve *c, double t, double out[2]);
void drawing_deriv(const drawing_curve *c, double t, double out[2]);

/* The true length in mm, to 1e-6 relative. */
double drawing_length(const drawing *d);

/* The smallest box around the curves themselves (not their control points): box[0] least, box[1]
 * greatest. False if there are none. */
bool drawing_box(const drawing *d, double box[2][2]);

/* Readers, chosen by drawing_read. `text` holds `size` bytes and a 0 behind them; `file` is for
 * messages. */
int drawing_read_svg(drawing *d, const char *file, const char *text, size_t size);
int drawing_read_csv(drawing *d, const char *file, const char *text, size_t size);
int drawing_read_curves(drawing *d, const char *file, const char *text);

#endif

/* host-tools/svg.h -- what the parts of the SVG reader share
 * SPDX-License-Identifier: MIT
 *
 *     svg_file.c   the XML: read safely, ids, lines for messages
 *     svg.c        the document: elements, viewports, use, what is hidden
 *     svg_shape.c  path data and basic shapes          -> pen
 *     svg_pen.c    lines, cubics, arcs in user units   -> curves in mm
 *     svg_space.c  transforms, lengths with units, viewBox
 *     svg_style.c  properties from attributes, style="" and style sheets
 *
 * Functions that give bool print one line with file and line and give false when the file is at fault; the reading
 * ends there: a machine shall not draw half of a broken drawing.
 */
#ifndef LOFT_SVG_H
#define LOFT_SVG_H

#include <libxml/tree.h>
#include <stdbool.h>

#include "drawing.h"

/* x' = a x + c y + e,  y' = b x + d y + f */
typedef struct {
    double a, b, c, d, e, f;
} svg_matrix;

typedef struct svg_sheet svg_sheet;     /* the rules of <style>, see svg_style.c */

/* An element with an id. */
typedef struct {
    char *id;
    const xmlNode *node;
} svg_named;

/* One reading of one file. */
typedef struct {
    drawing *d;
    const char *file;
    const xmlNode *node;        /* the element being read: its attributes, and for messages */
    const char **line;          /* where the lines of the file start, to the end of the last */
    size_t line_count;
    svg_sheet *sheet;
    svg_named *named;           /* sorted; of equal ids the first in the file is first    */
    size_t named_count;
    size_t visited;             /* elements, to stop a flood of <use>                     */
    unsigned warned;            /* bits, see svg_warn                                     */
} svg_reader;

/* The space that an element is drawn in. */
typedef struct {
    svg_matrix to_mm;
    double width, height;       /* of the viewport in user units, for %; below 0: unknown */
    bool visible;
    bool filled, stroked;       /* what has neither is not seen, and not drawn            */
} svg_space;

enum svg_side { SVG_ACROSS, SVG_ALONG_Y, SVG_DIAGONAL };       /* what a % is taken of */


// Document
// --------

/* Is it an element of SVG, of this name (NULL: of any)? */
bool svg_is(const xmlNode *node, const char *name);

/* Draw everything in the outermost <svg>. */
bool svg_draw(svg_reader *r, const xmlNode *root);


// Messages
// --------

/* The line on which the tag of the current element starts. */
unsigned svg_at_line(const svg_reader *r);

/* Print `loft: file:line: <message>`, give false. */
bool svg_fail(const svg_reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same, but the reading goes on; only the first of each `kind`, 0..31, is printed. */
void svg_warn(svg_reader *r, unsigned kind, const char *format, ...) __attribute__((format(printf, 3, 4)));


// Attributes and style
// --------------------

/* The attribute without a namespace, or NULL; free with xmlFree. */
char *svg_attribute(const xmlNode *node, const char *name);

/* The value of a property (style sheet < style="" ; an attribute is the weakest), or NULL; free with xmlFree. */
char *svg_property(const svg_reader *r, const char *name);

void svg_sheet_read(svg_reader *r, const xmlNode *style);
void svg_sheet_free(svg_sheet *sheet);


// Space
// -----

extern const svg_matrix svg_identity;

/* First `inner`, then `outer`. */
svg_matrix svg_multiply(svg_matrix outer, svg_matrix inner);

/* The greatest factor by which it stretches any length. */
double svg_stretch(svg_matrix m);

/* Append the list of transforms in `text` to *m. `css`: numbers may carry px and deg. */
bool svg_transform(const svg_reader *r, const char *text, bool css, svg_matrix *m);

/* A length attribute of the current element in user units; `absent` if it is missing or `auto`. */
bool svg_length(const svg_reader *r, const svg_space *space, const char *name, enum svg_side side, double absent, double *out);

/* Numbers of the attribute `viewBox`; *given tells whether there are any. */
bool svg_view_box(const svg_reader *r, double box[4], bool *given);

/* The matrix that fits `box` into width x height as preserveAspectRatio of the current element says. */
bool svg_fit(const svg_reader *r, const double box[4], double width, double height, svg_matrix *out);


// Pen
// ---

typedef struct {
    const svg_reader *r;
    svg_matrix to_mm;
    double start[2], at[2];     /* user units                                    */
    double end[2];              /* mm; where the drawn path ends                 */
    bool fresh;                 /* nothing is drawn since the last move          */
    unsigned line;              /* of the file                                   */
} svg_pen;

svg_pen svg_pen_at(const svg_reader *r, svg_matrix to_mm);
void svg_move(svg_pen *pen, double x, double y);
bool svg_line(svg_pen *pen, double x, double y);
bool svg_quad(svg_pen *pen, double x1, double y1, double x, double y);
bool svg_cubic(svg_pen *pen, double x1, double y1, double x2, double y2, double x, double y);
bool svg_arc(svg_pen *pen, double rx, double ry, double degrees, bool large, bool sweep, double x, double y);
bool svg_close(svg_pen *pen);


// Shapes
// ------

/* Draw the current element if it is a shape; *known tells whether it is. */
bool svg_shape(const svg_reader *r, const svg_space *space, bool *known);

/* Draw path data. */
bool svg_path(const svg_reader *r, const char *data, svg_pen *pen);

#endif

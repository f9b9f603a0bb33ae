/* host-tools/read/drawing.h -- a drawing: cubic curves in mm, y up, in drawing order, flat or in
 * space
 * SPDX-License-Identifier: MIT
 *
 * Readers (reader.h) fill it; lines and arcs are cubics too. A path is a connected run of curves
 * that is drawn with the pen down. Between paths the pen travels. Nothing is clipped, and colours
 * do not matter: a plotter draws outlines.
 *
 * A curve in space has heights beside its points in the plane. A program (G-code) is a drawing that
 * says every motion: its curves have feeds, travels are curves too, and nothing is added between.
 */
#ifndef LOFT_DRAWING_H
#define LOFT_DRAWING_H

#include <stdbool.h>
#include <stddef.h>

#include "base/host.h"

typedef struct {
    double p[4][2];         /* control points, mm, y up, origin at the lower left corner of the
                             * page */
    double z[4];            /* their heights, mm */
    double feed;            /* mm/s; 0: that of the options, DRAWING_RAPID: as fast as can be */
    unsigned char loose[2]; /* of its start and end: bit i, axis i counts from where the machine
                             * stands, for the program has not said where that is */
    unsigned path;          /* 0, 1, 2 ..: curves of one path follow each other and are connected */
    unsigned line;          /* its line in the file */
    unsigned tool;          /* of the machine: its number in the table of tools, from 1; 0: none */
    unsigned layer;         /* of SVG: which layer of Inkscape it is in, from 1 in the order of the
                             * file; 0: in none */
    float width, mitre;     /* of SVG: of its stroke, mm, 0: none is known; length over width */
    float pen[3];           /* of SVG: its stroke is as wide as an ellipse: xx, xy, yy of the matrix
                             * of determinant 1 that makes it of a circle; all 0: a circle */
    unsigned char cap, join;/* of it: butt, round, square; mitre, round, bevel */
    unsigned clip;          /* of SVG: which area it is cut at, from 1; 0: at none */
    unsigned fill;          /* of SVG: which shape it outlines times DRAWING_SHAPE, and how that is
                             * painted */
} drawing_curve;

/* What a program does between two motions. */
enum drawing_doing {
    DRAWING_WAITS,              /* `amount` seconds */
    DRAWING_PAUSES,             /* until somebody resumes it */
    DRAWING_SPINS,              /* spindle or laser: `way` 3, 4 (M3, M4) or 0, at S `amount`; NAN:
                                 * not given */
    DRAWING_COOLS               /* `way` 1 or 0 */
};

typedef struct {
    enum drawing_doing doing;
    size_t before;              /* the curve that follows, counted from the first one of the file;
                                 * it begins a path */
    unsigned line;
    int way;
    double amount;
    double along;               /* not 0: SPINS, in that curve, a line, so many mm from its start */
    char text[80];              /* PAUSES: what to tell */
} drawing_event;

/* The names of layers: number 1 is name[0]. Free with drawing_names_free. */
typedef struct {
    char **name;
    size_t count;
} drawing_names;

struct drawing_clip;
struct drawing;

/* Take curves out of a drawing that is being read, with drawing_forget: then a long one needs no
 * more memory than a short one. Returns 0, or an exit code after one message. */
typedef int drawing_taker(void *context, struct drawing *d);

typedef struct drawing {
    drawing_curve *curve;
    size_t count, room;
    double width, height;   /* page in mm; 0 if the file gives none */
    bool program;           /* it says every motion */
    int dialect;            /* of G-code: enum gcode_dialect (gcode.h); set before reading */
    unsigned most_lines;    /* of G-code with O-words, that are run; 0: the usual; as that */
    unsigned from_line;     /* of G-code: no motions before it; 0: all; set before reading */
    bool exact;             /* of G-code: G61 or G61.1 is in force somewhere: it stops at corners */
    double within;          /* of G-code: the smallest P of G64, mm; 0: none */
    double clear;           /* then the height of the way to the first one: that of the whole
                             * program */
    const char *layers;     /* of SVG: draw only these, as "Ink,2"; NULL: all; set before reading */
    const char *only;       /* of SVG: draw only these colours, as "red,#00f"; NULL: all; set
                             * before reading */
    bool white;             /* of SVG: a white page is drawn too; set before reading */
    const char *text;       /* of SVG: "outline", "line", "line:rowmans", "none"; NULL: outline; set
                             * before reading */
    const struct machine_tools *tools;      /* of SVG: which draws what; NULL: none; set before
                             * reading */
    drawing_names *named;   /* of SVG: takes the names of its layers; NULL: not wanted; set before
                             * reading */
    bool areas;             /* of SVG: keep outlines of what is filled also where they are not
                             * drawn; set before reading */
    drawing_event *event;   /* of a program, in its order */
    size_t events, event_room;
    struct drawing_clip *clip;      /* areas at which painted shapes are cut */
    size_t clips;
    struct curves *of;      /* the curves that were converted; NULL: they were cubics */
    drawing_taker *taker;   /* takes curves out while they are read; NULL: all stay; set before
                             * reading */
    void *context;
    size_t taken;           /* curves of the file before the first one, which are not here */
} drawing;

/* What is left of a shape is inside of the outline, and of the area number `up`, 0: none. */
typedef struct drawing_clip {
    drawing outline;        /* its shapes together, each by its own rule, and in its own area */
    unsigned up;
} drawing_clip;

/* mm; coordinates beyond +- this are refused: they must fit Q16.16 sums */
#define DRAWING_LIMIT 16000.0
#define DRAWING_RAPID (-1.0)
#define DRAWING_TOL   1e-4          /* mm between a curve and its cubics, a fiftieth of a plan's */
#define DRAWING_EVENODD 1u
#define DRAWING_STROKED 2u
#define DRAWING_FILLED  4u
#define DRAWING_HIDDEN  8u      /* only filled, not drawn */
#define DRAWING_SHAPE   16u
#ifndef DRAWING_CURVES_MAX      /* more are refused: a few kB can expand to billions */
#define DRAWING_CURVES_MAX 4000000u
#endif

void drawing_free(drawing *d);
void drawing_names_free(drawing_names *n);

/* Append one curve, flat or in space, or a copy of all but the path; `fresh` begins a new path (the
 * first curve always does). For readers, which check the limits. */
void drawing_add(drawing *d, double p[4][2], bool fresh, unsigned line);
void drawing_add_space(drawing *d, double p[4][3], double feed, bool fresh, unsigned line);
void drawing_add_like(drawing *d, const drawing_curve *c, bool fresh);

/* Append an event behind all curves. */
void drawing_add_event(drawing *d, const drawing_event *e);

/* The number of the area that is inside of an outline, which is copied, and of another one. */
unsigned drawing_add_clip(drawing *d, const drawing *outline, unsigned up);

/* For readers, after a curve: let it be taken out, if so many wait that it is worth while. Only
 * G-code and CSV are read so; the others keep all. Returns 0, or an exit code. */
int drawing_offer(drawing *d);

/* Take the first `count` curves out; all events stay. */
void drawing_forget(drawing *d, size_t count);

/* Give *to the page and the kind of a drawing. */
void drawing_like(drawing *to, const drawing *from);

/* The same for a curve that may continue the one before: if it starts at that end, it is joined
 * exactly. A curve without length is left out; one beyond the limits is refused. The
 * second function takes a curve in space, and its feed. */
int drawing_join(host *h, drawing *d, const char *file, unsigned line, double p[4][2]);
int drawing_join_space(host *h, drawing *d, const char *file, unsigned line, double p[4][3],
                       double feed);

/* The point of a curve at t in 0..1, and its derivative by t, seen from above. */
void drawing_eval(const drawing_curve *c, double t, double out[2]);
void drawing_deriv(const drawing_curve *c, double t, double out[2]);

/* Cut out the part from a to b, 0..1; parts that meet have one end. */
void drawing_cut(drawing_curve *c, double a, double b);

/* Where a cubic of one coordinate, y, crosses a height: its parameters, and 1 where it rises, -1
 * where it falls. A piece counts from its lower end to below its upper one, so chains of curves
 * are crossed consistently. Returns how many there are. */
int drawing_crossings(const double y[4], double height, double t[3], int turn[3]);

/* What a curve adds to the winding number of the outline around a point. */
int drawing_winding(const drawing_curve *c, const double at[2]);

/* The true length in mm, to 1e-6 relative. */
double drawing_length(const drawing *d);

/* The smallest box around the curves themselves (not their control points), seen from above: box[0]
 * smallest, box[1] largest. Returns false if there are no curves. */
bool drawing_box(const drawing *d, double box[2][2]);

/* The height of the highest control point; 0 in a flat drawing. */
double drawing_top(const drawing *d);

#endif

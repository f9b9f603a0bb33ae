/* host-tools/gcode/gcode.h -- reads G-code: line by line, its motions as events
 * SPDX-License-Identifier: MIT
 *
 *     gcode_block.h     a line as words with numbers
 *     gcode_number.h    its numbers: expressions, parameters
 *     gcode_state.h     what the words mean: modes, coordinates, units
 *     gcode_run.c       one line: its words in their order of execution
 *     gcode_flow.c      subroutines, branches, loops
 *     gcode_named.c     parameters that tell how the program stands
 *     gcode_left.c      words that are left out
 *     gcode_event.c     events: motions with their feed, waits
 *     gcode_motion.c    straight motions, arcs, cubics, NURBS
 *     gcode_arc.c       an arc as cubics
 *     gcode_cycle.c     drilling
 *     gcode_offset.c    coordinate systems, home, lengths of tools
 *     gcode_tool.c      tools
 *     gcode_modes.c     modes that are saved and brought back
 *     gcode_radius.c    tool radius compensation
 *     gcode_draw.c      the motions as a drawing
 *
 * Coordinates of an event are those of the program, in its units: so its numbers stay as written.
 * gcode_place converts them to mm of the machine.
 */
#ifndef LOFT_READ_GCODE_H
#define LOFT_READ_GCODE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/option.h"    /* option */
#include "read/drawing.h"

enum gcode_kind {
    GCODE_RAPID,            /* straight to `to`, as fast as can be */
    GCODE_LINE,             /* straight to `to` */
    GCODE_ARC,
    GCODE_CUBIC,
    GCODE_QUADRATIC,
    GCODE_NURBS,
    GCODE_WAIT,             /* `seconds` */
    GCODE_STOP,             /* M0 M1 M60, a tool change: until somebody resumes */
    GCODE_SPINDLE,          /* M3 M4 M5, or another S: `way` and `speed` */
    GCODE_COOLANT,          /* M7 M8 M9: `way` 1 or 0 */
    GCODE_SAY,              /* (MSG,text) */
    GCODE_TOOL              /* M6: `tool` is to be in the spindle */
};

/* From the coordinates of the program to those of the machine: add `shift`, turn by `degrees`
 * around z, add `origin`; all in units of `unit` mm. */
typedef struct {
    double unit, shift[3], degrees, origin[3];
} gcode_frame;

typedef struct {
    enum gcode_kind kind;
    unsigned line;
    double from[3], to[3];
    int plane;              /* ARC: the axis across it: 2 is G17, 1 is G18, 0 is G19 */
    int turns;              /* ARC: 1 counterclockwise, -1 clockwise, 2, -2 .. a turn more */
    unsigned char loose[2]; /* of `from` and `to`: axes not yet placed, as in drawing.h */
    double centre[3];       /* ARC: in its plane */
    double inner[2][3];     /* CUBIC: control points between; QUADRATIC: the one */
    const double (*points)[3];      /* NURBS: x, y, weight */
    unsigned count, degree; /* NURBS */
    double feed;            /* mm/s; 0: none is set */
    bool exact;             /* G61, G61.1: it stops at corners */
    double within;          /* G64 P: how far the path may be left, mm; 0: not said */
    double seconds;         /* WAIT */
    long tool;              /* TOOL: its number */
    int way;                /* SPINDLE: 3, 4 or 0: off */
    double speed;           /* S; NAN: it was never given */
    const char *text;       /* SAY */
    size_t length;
    const gcode_frame *frame;
} gcode_event;

/* Returns 0, or an exit code that ends the reading. */
typedef int gcode_sink(void *context, const gcode_event *e);

/* The cubics of an arc within tol of it, in coordinates of the program, up to the first one for
 * which the sink does not return 0; and its length. */
typedef int gcode_cubic_sink(void *context, double p[4][3]);
int    gcode_arc_cubics(const gcode_event *e, double tol, gcode_cubic_sink *sink, void *context);
double gcode_arc_length(const gcode_event *e);

/* The program as a machine of this kind reads it. */
enum gcode_dialect { GCODE_ANY, GCODE_LINUXCNC, GCODE_GRBL, GCODE_FLUIDNC, GCODE_MARLIN };

/* Of a table of options. */
typedef struct {
    int dialect;                /* enum gcode_dialect */
    unsigned from_line;         /* the first line that is run; 0: all */
} gcode_choice;
extern const option gcode_rows[];

typedef struct gcode_program gcode_program;

/* Begin a program at machine coordinates 0, 0, 0; GCODE_ANY is LINUXCNC or, for a 3-D printer's
 * file, MARLIN. Free with gcode_close. */
gcode_program *gcode_open(struct host *h, const char *file, enum gcode_dialect d, gcode_sink *sink,
                          void *context);

/* The tools of the machine, for G41, G43 and M6; NULL: none. They outlive the program. */
void gcode_set_tools(gcode_program *g, const struct machine_tools *tools);

/* True if the program has said its end (M2, M30 or the second %). */
bool gcode_ended(const gcode_program *g);

/* Run at most so many lines behind the first O-word; 0: the usual bound. */
void gcode_bound(gcode_program *g, unsigned lines);

/* Run what was kept for O-words, and check the end of the program. */
int  gcode_finish(gcode_program *g);
void gcode_close(gcode_program *g);

/* All lines of a part of a text, which ends with a whole line; all of a text and its end. Returns
 * 0, or an exit code after one message. */
int  gcode_lines(gcode_program *g, const char *text, size_t size);
int  gcode_read(gcode_program *g, const char *text, size_t size);

/* A point of the program in mm of the machine. */
void gcode_place(const gcode_frame *f, const double at[3], double out[3]);

#endif

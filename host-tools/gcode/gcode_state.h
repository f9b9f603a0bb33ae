/* host-tools/gcode/gcode_state.h -- the modes of a G-code program
 * SPDX-License-Identifier: MIT
 *
 * Shared by the files gcode_*.c. Positions are in the coordinates of the program, in its units.
 * Offsets are kept in mm, as parameters of the program: 5161.. home, 5181.. second home, 5211..
 * G92, 5221.. coordinate systems (20 numbers each).
 */
#ifndef LOFT_READ_GCODE_STATE_H
#define LOFT_READ_GCODE_STATE_H

#include "gcode/gcode.h"
#include "gcode/gcode_block.h"

#define GCODE_SYSTEMS 9
#define GCODE_POLES   1024      /* control points of a NURBS */
#define GCODE_HELD    64        /* events that wait in G41 and G42 */

/* Codes in tenths: G5.1 is 51. */
#define GCODE_CALLS   1
#define GCODE_RETURNS 2

#define GCODE_NONE    (-1)
#define GCODE_CANCEL  800       /* G80 */

/* What M70 saves and M72 brings back: modes, no places. */
typedef struct {
    bool valid;
    double unit, feed, speed, within, tool[3];
    bool timed, incremental, centre_absolute, exact, retract_to_r, shifted;
    int feed_mode, plane, system, spindle, coolant;
} gcode_modes;

struct gcode_program {
    const char *file;
    gcode_sink *sink;
    void *context;
    enum gcode_dialect dialect;
    bool printer, ended, begun;
    unsigned percents;
    gcode_parameters all;
    gcode_block b;              /* the line under way, */
    uint32_t used;              /* and its letters that something used */
    unsigned main_line;         /* of the program itself, which called for it */
    struct gcode_flow *flow;    /* NULL: no O-word so far */
    int wants;                  /* of M98 and M99: 0, GCODE_CALLS or GCODE_RETURNS */
    double wants_p, wants_times;
    unsigned quiet;             /* lines since the last event */
    unsigned most_lines;        /* that are run behind the first O-word; 0: the usual */

    double at[3];
    unsigned char loose;        /* bit i: axis i counts from where the machine stands; */
    bool homing;                /* the motion ends at a place of the machine, */
    unsigned char homed;        /* where these axes are loose */
    unsigned char tied;         /* and the program's numbers too, by G92 or G10 L20 */
    gcode_frame frame;
    int motion;                 /* 0 10 20 30 50 51 52, 810 .. or GCODE_CANCEL */
    int plane;                  /* the axis across it */
    bool incremental, centre_absolute;
    int feed_mode;              /* 930 940 950 */
    double feed;                /* units per minute, per turn; 1/minutes */
    bool fed;                   /* it was given */
    double speed;               /* S; 0, if it is not `timed` */
    bool timed;
    int spindle, coolant;       /* 3, 4 or 0; 1 or 0 */
    bool exact;                 /* G61, G61.1 */
    double within;              /* P of G64, mm; 0: none */
    bool retract_to_r;          /* G99 */
    int system;                 /* 1 .. 9: G54 .. G59.3 */
    bool shifted;               /* G92 is in force */
    double tool[3];             /* length offset, mm */
    double last_pq[2];          /* G5: of the cubic before */
    const struct machine_tools *tools;          /* NULL: none */
    long selected, loaded;      /* T; the tool in the spindle, below 0: none */
    bool apart;                 /* the tool is not at `at`, but at */
    double place[3];
    struct {                    /* G41 and G42; in the plane, units of the program */
        int side;               /* 1: the tool is left of the path, -1: right, 0: on it */
        double r;
        bool entered;           /* there was a motion in the plane; the last one waits: */
        double way[2], end[2];  /* its direction at its end, as programmed; that end, shifted */
        double sweep;           /* of an arc, as programmed */
        bool cut;               /* it begins in an inner corner */
        gcode_event held[GCODE_HELD];
        unsigned count;
    } radius;
    bool after_cubic;
    gcode_modes saved; /* by M70 */

    struct {                    /* sticky words of drilling */
        double r, z, p, q;
        double aside[3];        /* I J K of G87 */
        double initial;         /* the height before the first one */
        bool leveled;           /* `initial` is known */
        int code;               /* 0: none before */
    } cycle;

    double pole[GCODE_POLES][3];
    unsigned poles, degree;     /* poles > 0: between G5.2 and G5.3 */
    double pole_weight;
    unsigned pole_line;

    struct {                    /* words that this machine has no use for, said at the end */
        char letter, name[24];
        int code;
        unsigned line, count;
    } left[64];
    unsigned lefts;
};

/* The axes of the plane, and the one across it: X Y Z, Z X Y or Y Z X. */
static inline int gcode_first(const gcode_program *g)   { return (g->plane + 1) % 3; }
static inline int gcode_second(const gcode_program *g)  { return (g->plane + 2) % 3; }

static inline int gcode_fails(const gcode_program *g, const char *name, const char *what,
                              const char *remedy)
{
    return gcode_wrong(&g->b, name, what, remedy);
}

/* Give an event, completed with line, start, frame and feed. `length`: of the motion in units of
 * the program, for inverse time. Moves the position to e->to if it is a motion. */
int gcode_give(gcode_program *g, gcode_event *e, double length);
int gcode_go(gcode_program *g, enum gcode_kind kind, const double to[3]);
int gcode_wait(gcode_program *g, double seconds);
int gcode_simple(gcode_program *g, enum gcode_kind kind);

/* Give an event from where the tool is. */
int gcode_send(gcode_program *g, gcode_event *e);

/* Where the axis words of the line lead; and the loose axes there. */
void gcode_target(const gcode_program *g, double out[3]);
void gcode_polar_target(const gcode_program *g, const double from[3], double out[3]);
unsigned char gcode_loose_there(const gcode_program *g);

/* gcode_left.c: a word that this machine has no use for; and one line for each of them. */
void gcode_leave_out(gcode_program *g, char letter, int code);
void gcode_leave_name(gcode_program *g, const char *name);
void gcode_tell_left(gcode_program *g);

/* gcode_run.c: a line of `length` characters, without its newline. Where a line ends, and where the
 * next one begins. */
int gcode_line(gcode_program *g, const char *text, size_t length);
const char *gcode_line_end(const char *text, const char *end);
const char *gcode_next_line(const char *stop, const char *end);

/* gcode_flow.c: true if a line has an O-word that is not just the program's name. From line number
 * `line` on the text is kept, and run when it is complete. M98 of the line. */
bool gcode_flow_steers(gcode_program *g, const char *text, size_t length);
void gcode_flow_open(gcode_program *g, unsigned line);
int  gcode_flow_keep(gcode_program *g, const char *text, size_t size);
int  gcode_flow_run(gcode_program *g);
void gcode_flow_free(gcode_program *g);
int  gcode_flow_m98(gcode_program *g);

/* gcode_motion.c: the motion of the line. */
int gcode_move(gcode_program *g);
int gcode_nurbs_end(gcode_program *g);

/* gcode_cycle.c */
int gcode_drill(gcode_program *g);

/* gcode_radius.c: a motion beside the programmed path; off: give what waits. */
int gcode_radius_on(gcode_program *g, int side, double diameter);
int gcode_radius_off(gcode_program *g);
int gcode_radius_take(gcode_program *g, gcode_event *e);

/* gcode_tool.c: T; M6 and M61; the length that H names, mm; G41, G42 and their .1. */
int gcode_tool_select(gcode_program *g);
int gcode_tool_change(gcode_program *g, int m);
int gcode_tool_length(const gcode_program *g, double *out);
int gcode_tool_side(gcode_program *g, int code);

/* gcode_offset.c */
void gcode_use_offsets(gcode_program *g);
void gcode_machine_place(const gcode_program *g, const double at[3], double out[3]);
void gcode_program_place(const gcode_program *g, const double machine[3], double out[3]);
int  gcode_use_units(gcode_program *g, double unit);
int  gcode_nonmodal(gcode_program *g, int code);
int  gcode_use_system(gcode_program *g, int system);
int  gcode_use_shift(gcode_program *g, bool shifted);
int  gcode_use_tool(gcode_program *g, int code);

/* gcode_modes.c: M70 saves the modes, M71 forgets them, M72 brings them back. */
int gcode_modes_word(gcode_program *g, int m);

#endif

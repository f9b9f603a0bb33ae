/* host-tools/library/host.h -- libloft-host, installed as loft/host.h: read, order, plan, stream
 * SPDX-License-Identifier: MIT
 *
 *     loft_host *h = loft_host_open(&(loft_host_calls){ .message = print });
 *     code = loft_host_read(h, "part.svg", &d);
 *     code = loft_host_order(h, d, NULL);
 *     code = loft_host_connect(h, &(loft_host_line){ .port = "/dev/ttyUSB0" }, &m);
 *     code = loft_host_stream(m, d, NULL);
 *     while ((code = loft_host_step(m, seconds(), &wants)) == LOFT_HOST_GOES)
 *         poll wants.in and wants.out, for wants.ms at most
 *
 * A call returns 0 or a code of <sysexits.h>. What is wrong is told once, to `message`, with a name
 * that stays. Nothing here prints, waits, ends the program, or takes its signals and its terminal.
 * What belongs to one loft_host may be used by one thread at a time; two of them share nothing.
 * Lengths are in mm, times in s, speeds in mm/s. host-tools/USE.md has a whole program.
 */
#ifndef LOFT_HOST_PUBLIC_H
#define LOFT_HOST_PUBLIC_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// The host
// --------

typedef struct {
    int code;               /* of <sysexits.h>; 0: a warning, and the call goes on */
    const char *name;       /* "svg.no-font": host-tools/MESSAGES.md has all */
    const char *file;       /* NULL: nowhere */
    unsigned line;          /* 0: in all of the file */
    const char *what, *remedy;      /* for people; remedy NULL: none. They are valid until the call
                                     * returns, and may hold any byte that is not 0 */
} loft_host_message;

typedef struct {
    const char *doing;      /* "planning"; NULL: that work has ended */
    double done, total;     /* total 0: unknown */
} loft_host_progress;

/* What a program does for the library. NULL: nothing. They may not call the library. */
typedef struct {
    void (*message)(void *context, const loft_host_message *m);
    bool (*progress)(void *context, const loft_host_progress *p);   /* false: stop, with
                                                                     * EX_TEMPFAIL */
    double (*now)(void *context);       /* of a clock that is never set: then `progress` comes at
                                         * most ten times a second */
    void *context;
    bool strict;            /* a call that warned ends with EX_DATAERR */
    const char *state;      /* a folder for notes of jobs, so that one that was cut off is noticed
                             * if the machine restarts; NULL: none are kept */
} loft_host_calls;

typedef struct loft_host loft_host;

/* Begin; end, when all that was made with it is freed. */
loft_host *loft_host_open(const loft_host_calls *calls);
void       loft_host_close(loft_host *h);

/* Sizes that a file asks for are refused with a message before they are taken. If the system has
 * not even these bytes, `handler` is called, which may not return; without it the program traps.
 * It is one for all of the program: set it first. */
void loft_host_no_memory(void (*handler)(size_t bytes));

// Drawings
// --------

typedef struct loft_host_drawing loft_host_drawing;

/* A cubic curve of three axes, y up. Curves of one path follow each other and are connected. */
typedef struct {
    double p[4][3];
    unsigned path, line;    /* line: in the file */
} loft_host_curve;

/* Read a file of any kind that the command reads: SVG, G-code, CSV, .loft; "-": standard input. */
int  loft_host_read(loft_host *h, const char *file, loft_host_drawing **out);
void loft_host_drawing_free(loft_host_drawing *d);

size_t loft_host_curves(const loft_host_drawing *d);
void   loft_host_curve_at(const loft_host_drawing *d, size_t i, loft_host_curve *out);

/* 0: as the command */
typedef struct {
    double effort;          /* s of work, counted: the same on every computer (2) */
    double join;            /* ends this close are joined by a line (0.005) */
    const char *seam;       /* where closed paths begin: "any", "corner", "X,Y" (any) */
    bool doubles;           /* draw twice what the drawing has twice */
} loft_host_order_options;

/* Put the paths in an order with short travels. `o` NULL: as by default. */
int loft_host_order(loft_host *h, loft_host_drawing *d, const loft_host_order_options *o);

// Plans
// -----

/* 0: what the machine, or else the command, has */
typedef struct {
    const char *machine;    /* a file as host-tools/MACHINE.md says; NULL: a cartesian one, or that
                             * which is connected */
    double feed, travel;    /* pen down (30), pen up (100) */
    double accel;           /* mm/s^2, at most, on any axis */
    double jerk;            /* mm/s^3; below 0: acceleration changes at once */
    double tol, corner;     /* how far from the drawing; at corners */
    double lift;            /* of the pen (1) */
    bool park;              /* at the end go to the machine's zero */
    const char *order;      /* of a file that is streamed: "file", "layer", "best" (file) */
} loft_host_plan_options;

typedef struct {
    double seconds, drawn, travelled;
    size_t curves, items;
    uint32_t job;           /* the same drawing, options and machine give the same; of the last
                             * tool */
} loft_host_plan_facts;

/* Plan for the machine of the options, or for a usual one, and judge the plan: it is within the
 * limits, and within `tol` of the drawing. */
int loft_host_plan(loft_host *h, loft_host_drawing *d, const loft_host_plan_options *o,
                   loft_host_plan_facts *out);

// Machines
// --------

typedef struct loft_host_machine loft_host_machine;

/* A line of the program's own. Neither call waits: 0: nothing can be moved now; below 0: the line
 * is gone, and errno says why. */
typedef struct {
    long (*get)(void *context, void *bytes, size_t most);
    long (*put)(void *context, const void *bytes, size_t count);
    void *context;
} loft_host_port;

typedef struct {
    const char *port;       /* "/dev/ttyUSB0", a pseudo terminal, "unix:PATH", "tcp:HOST:PORT"; of a
                             * line of one's own, its name in messages */
    unsigned baud;          /* of a serial port; 0: 115200 */
    double wait;            /* s, for its first answer; 0: 5 */
    const loft_host_port *own;      /* it stays; NULL: `port` is opened */
    const char *machine;    /* a file as host-tools/MACHINE.md says; NULL: the machine's settings,
                             * or a usual one */
    const char *log;        /* a file for what passes, in words; NULL: none */
    void (*changed)(void *context, loft_host_machine *m);   /* loft_host_state tells other facts
                                                             * than before. It may only ask that */
    void (*told)(void *context, const char *line);  /* "homed: the tool is at ..", "drawn: .." */
    void *context;          /* of both */
} loft_host_line;

/* Open the line; next, in steps, the machine is greeted. *out is NULL after an error. Freed in the
 * middle of a job, the machine draws what it has and stops on its path. */
int  loft_host_connect(loft_host *h, const loft_host_line *line, loft_host_machine **out);
void loft_host_machine_free(loft_host_machine *m);

#define LOFT_HOST_GOES (-1)

/* What a step waits for. It may be stepped earlier as well. */
typedef struct {
    int in, out;            /* descriptors to read from, and to write to; -1: none */
    bool get, put;          /* of a line of one's own: until it has bytes; until it takes some */
    int ms;                 /* step it then, in any case */
} loft_host_wants;

/* Move the bytes that are there, or plan for some ms. `now` is the time in s of any clock that is
 * never set, the same in all steps. Returns LOFT_HOST_GOES while something goes on that was asked
 * for; then how that ended: 0 if it is done. Stepped at rest, it looks at the machine once a
 * second, so that its state is of now. */
int loft_host_step(loft_host_machine *m, double now, loft_host_wants *wants);

// What it does, one thing at a time: each call returns 0, or a code after one message; how it ends
// is told by loft_host_step. While the machine is greeted it waits for that.

/* Draw, from where the machine stands and within its limits. A job that was cut off goes on where
 * the machine stopped, if the same is drawn again. A file is read and laid out for the tools of the
 * machine: at each change its state is "tool", until loft_host_resume. The drawing stays. */
int loft_host_stream(loft_host_machine *m, loft_host_drawing *d, const loft_host_plan_options *o);
int loft_host_stream_file(loft_host_machine *m, const char *file, const loft_host_plan_options *o);

/* Move straight to a place in mm; NAN: this axis stays. `by`: from where the tool is. What table
 * and closed switches do not allow is refused. */
int loft_host_go(loft_host_machine *m, const double to[3], bool by, double feed);

/* Move along axis 0 to 2 by `way` mm, not beyond the table. Infinite: until loft_host_jog_on has
 * not been called for 0.6 s. */
int  loft_host_jog(loft_host_machine *m, int axis, double way, double feed);
void loft_host_jog_on(loft_host_machine *m);

/* The pen up or down; up, and then to the parking place. */
int loft_host_pen(loft_host_machine *m, bool up, double feed);
int loft_host_park(loft_host_machine *m, double feed);

/* Find the switches of these axes, as "xy", and know where the tool is; NULL: of all that have one.
 * Lead the tool away from closed switches; where it is not known at which end one is, this way, as
 * "x+", or NULL. */
int loft_host_home(loft_host_machine *m, const char *axes, unsigned touches);
int loft_host_unlock(loft_host_machine *m, const char *way);

/* Say that these axes are at `at` mm now. `keep`: in the settings of a homed machine, too. */
int loft_host_zero(loft_host_machine *m, const char *axes, double at, bool keep);

/* Move, as "z-", until the probe touches: at most `within` mm, and back by `back`. The axis is at
 * `at` there; NAN: it is only told where that is. */
int loft_host_probe(loft_host_machine *m, const char *way, double within, double feed, double back,
                    double at);

/* Read what the machine keeps; change it, by lines `key = value` as of a machine file. Then
 * loft_host_settings gives the lines, until the next call; "": none have been read. */
int         loft_host_settings_read(loft_host_machine *m);
int         loft_host_settings_set(loft_host_machine *m, const char *lines);
const char *loft_host_settings(loft_host_machine *m);

// Meanwhile, at any time, also twice

/* Slow down on the path and stop; go on, also after a pause and a change of tools; slow down and
 * end it. What is no job ends at a hold. Also a job of somebody else. */
void loft_host_hold(loft_host_machine *m);
void loft_host_resume(loft_host_machine *m);
void loft_host_abort(loft_host_machine *m);

/* Run time at `percent` of the plan, 10 to 200. */
void loft_host_override(loft_host_machine *m, unsigned percent);

/* Ask for the end: a job is held, and goes on when it is streamed again. Returns whether there is
 * nothing to wait for; otherwise step on. */
bool loft_host_stop(loft_host_machine *m);

typedef struct {
    const char *state;      /* "closed", "connects", "rests", "other-job", "moves", "prepares",
                             * "plans", "draws", "waits", "holds", "held", "pause", "aborts",
                             * "tool" */
    double done, total;     /* s of the plan; the total is an estimate until all is planned */
    uint32_t item, items;   /* executed; 0: not known yet */
    uint32_t queued;        /* items that the machine has ahead */
    double feed;            /* mm/s */
    unsigned override;      /* % */
    double at[3];           /* the tool, mm */
    int32_t steps[3];       /* the motors */
    uint32_t job;           /* of the machine; 0: none */
    uint16_t closed;        /* limit switches: bits 2 axis (low end), 2 axis + 1 (high end) */
    bool stop, doubt;       /* the emergency stop is closed; it does not know where it stands */
    const char *tool, *pause;       /* that draws or is asked for; what the program says; or NULL */
} loft_host_facts;

void loft_host_state(loft_host_machine *m, loft_host_facts *out);

#ifdef __cplusplus
}
#endif

#endif

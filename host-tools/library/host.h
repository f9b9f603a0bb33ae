/* host-tools/library/host.h -- libloft-host, installed as loft/host.h: read, order, plan, stream
 * SPDX-License-Identifier: MIT
 *
 *     loft_host *h = loft_host_open(&(loft_host_calls){ .message = print });
 *     code = loft_host_read(h, "part.svg", &d);
 *     code = loft_host_order(h, d, NULL);
 *     code = loft_host_stream(h, d, NULL, &port, &j);
 *     while ((code = loft_host_step(j, seconds(), &wants)) == LOFT_HOST_GOES)
 *         wait for a byte of the port, or for wants.ms
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
    const char *machine;    /* a file as host-tools/MACHINE.md says; NULL: a cartesian one */
    double feed, travel;    /* pen down (30), pen up (100) */
    double accel;           /* mm/s^2, at most, on any axis */
    double jerk;            /* mm/s^3; below 0: acceleration changes at once */
    double tol, corner;     /* how far from the drawing; at corners */
    double lift;            /* of the pen (1) */
    bool park;              /* at the end go to the machine's zero */
} loft_host_plan_options;

typedef struct {
    double seconds, drawn, travelled;
    size_t curves, items;
    uint32_t job;           /* the same drawing, options and machine give the same */
} loft_host_plan_facts;

/* Plan for the machine of the options, or for a usual one, and judge the plan: it is within the
 * limits, and within `tol` of the drawing. */
int loft_host_plan(loft_host *h, loft_host_drawing *d, const loft_host_plan_options *o,
                   loft_host_plan_facts *out);

// Jobs
// ----

/* A line to a machine. Neither call waits: 0: nothing can be moved now; below 0: the line is gone.
 */
typedef struct {
    const char *name;       /* in messages */
    long (*get)(void *context, void *bytes, size_t most);
    long (*put)(void *context, const void *bytes, size_t count);
    void *context;
} loft_host_port;

typedef struct loft_host_job loft_host_job;

#define LOFT_HOST_GOES (-1)

/* What a job waits for. It may be stepped earlier as well. */
typedef struct {
    bool put;               /* until the port takes bytes again, too */
    int ms;                 /* step it then, in any case */
} loft_host_wants;

/* A job of a drawing, which must outlive it. It greets the machine, plans from where that stands
 * and within its limits, and goes on planning while it draws. Free it also after an error. */
int  loft_host_stream(loft_host *h, loft_host_drawing *d, const loft_host_plan_options *o,
                     const loft_host_port *port, loft_host_job **out);
void loft_host_job_free(loft_host_job *j);

/* Move the bytes that are there, or plan for some ms. `now` is the time in s of any clock that is
 * never set, the same in all steps. Returns LOFT_HOST_GOES, or how the job ended: 0 if it is drawn,
 * and the machine stands where it was sent. */
int loft_host_step(loft_host_job *j, double now, loft_host_wants *wants);

/* Slow down on the path and stop; go on; slow down and end the job. At any time, also twice. */
void loft_host_hold(loft_host_job *j);
void loft_host_resume(loft_host_job *j);
void loft_host_abort(loft_host_job *j);

/* Run time at `percent` of the plan, 10 to 200. */
void loft_host_override(loft_host_job *j, unsigned percent);

typedef struct {
    const char *state;      /* "greets", "draws", "holds", "held", "aborts", "over" */
    double done, total;     /* s of the plan; the total is an estimate until all is planned */
    uint32_t item, items;   /* executed; 0: not known yet */
    double at[3];           /* the tool, mm */
    int32_t steps[3];       /* the motors */
} loft_host_job_facts;

void loft_host_job_state(const loft_host_job *j, loft_host_job_facts *out);

#ifdef __cplusplus
}
#endif

#endif

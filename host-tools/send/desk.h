/* host-tools/send/desk.h -- one machine, and what it is asked to do: greeted, moved, homed, drawn
 * on
 * SPDX-License-Identifier: MIT
 *
 * It does one thing at a time, in steps (send/task.h): nothing here waits. Between two things the
 * machine is greeted once in a while, so that its place and its switches are those of now.
 */
#ifndef LOFT_DESK_H
#define LOFT_DESK_H

#include "plan/parts.h"         /* plan_parts */
#include "send/change.h"        /* change */
#include "send/hand.h"          /* hand, mover */
#include "send/home.h"          /* home */
#include "send/probe.h"         /* probe */
#include "send/stream.h"        /* stream */

enum desk_state {
    DESK_ALONE,                 /* no port is open */
    DESK_CONNECTS,
    DESK_RESTS,
    DESK_MOVES,
    DESK_DRAWS,
    DESK_CHANGES                /* a tool is asked for */
};

enum desk_verb {
    DESK_GO,
    DESK_PEN,
    DESK_PARK,
    DESK_JOG,
    DESK_ZERO,
    DESK_HOME,
    DESK_UNLOCK,
    DESK_DRAW,
    DESK_PROBE,
    DESK_SETTINGS
};

/* What it is asked to do. */
typedef struct {
    enum desk_verb verb;
    bool axis[ENGINE_AXES];     /* ZERO, HOME; none: all that have a switch */
    double to[ENGINE_AXES];     /* GO: mm; NAN: this axis stays. ZERO: the places */
    bool by;                    /* GO: from where the tool is */
    bool up;                    /* PEN */
    int way;                    /* JOG, UNLOCK: +-(axis + 1); UNLOCK 0: none is named */
    double size;                /* JOG: mm; 0: until it is let go */
    double feed;                /* mm/s */
    const planning *how;        /* DRAW: its options, and */
    const char *file;           /* the drawing: both stay until it is over, and so does */
    drawing *given;             /* one that was read already, in order; NULL: it is read */
    probe_way probe;            /* PROBE */
    bool keep;                  /* ZERO: in the settings of a homed machine */
    unsigned touches;           /* HOME: of each switch; 0: twice */
    const char *lines;          /* SETTINGS: what is changed, until it is over; NULL: they are read
                                 */
} desk_wish;

typedef struct desk {
    host *host;
    mover v;                    /* its talk is that of all */
    enum desk_state state;
    bool looking;               /* it rests, and is greeted */
    bool others;                /* the machine has a job that this program does not draw */
    unsigned greeted;           /* how often what a plan depends on was learnt */
    int code;                   /* how the last thing ended */
    /* ---- of a job */
    stream r;
    change c;
    job_work w;
    plan_parts parts;
    size_t part, old;           /* that is drawn; that the machine had already, or parts.count */
    stream_subject about;
    planning p;
    drawing d, smooth;
    /* ---- */
    talk_options line;
    const char *machine;
    send_teller to;
    home h;
    hand m;
    probe touch;
    settings_work settings;
    settings kept;              /* by the machine, as they were read last */
    const transport *given;     /* the bytes of the program; NULL: the port is opened */
    desk_wish wish;
    bool wished, ends;
    bool held;                  /* JOG: the key is, */
    double until, now;          /* until then, if nobody says so again */
    double look_at;
    enum loft_verb verb;        /* for a job of others; 0: none */
    stream_control control;
    task doing;
    bool busy;
    int (*then)(struct desk *d, int code);
} desk;

/* The machine of a port, NULL: none, and its file, NULL: it is asked. `to` hears the lines of jobs,
 * the host what is wrong. */
void desk_begin(desk *d, host *h, const talk_options *line, const char *machine,
                const send_teller *to);
void desk_end(desk *d);

/* Open the port and greet the machine. Returns 0, or an exit code after one message. */
int desk_connect(desk *d, double now);
void desk_disconnect(desk *d);

/* Before that: a line that is open already. */
void desk_line(desk *d, const transport *line);

/* Some milliseconds of work. */
void desk_step(desk *d, double now, task_wants *w);

/* Ask for something while it rests, or is being connected. Returns 0, or an exit code after one
 * message. */
int desk_ask(desk *d, const desk_wish *wish, double now);

/* At any time: slow down on the path and stop; go on, after a pause and a change too; end it. What
 * is no job ends at a hold. */
void desk_hold(desk *d);
void desk_resume(desk *d);
void desk_abort(desk *d);
void desk_override(desk *d, unsigned percent);

/* The key of a jog is still held; it is let go. */
void desk_jog_on(desk *d, double now);
void desk_jog_off(desk *d);

/* Is a job drawn, with the numbers of stream_facts? */
bool desk_draws(const desk *d);

/* Ask for the end: a job is held, and goes on when it is asked for again. Returns true when there
 * is nothing to wait for. */
bool desk_stop(desk *d);

/* What the motion of a job begins with: the place and the limits of the machine, or of that of the
 * file or a usual one while there is none. */
void desk_given(const desk *d, planning *p, double start[ENGINE_AXES], job_options *as);

#endif

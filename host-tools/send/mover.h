/* host-tools/send/mover.h -- single straight moves of the tool, each a job of its own, with or
 * without a guard
 * SPDX-License-Identifier: MIT
 *
 * Homing, probing and jogging are such moves. They are planned like a drawing, and the machine
 * needs nothing for them but guards and place (lib/machine/latch.h).
 */
#ifndef LOFT_MOVER_H
#define LOFT_MOVER_H

#include "plan/job.h"           /* job_work */
#include "plan/planning.h"      /* planning */
#include "send/settings.h"      /* settings_work */
#include "send/talk.h"          /* talk */

/* The options of a command that moves. */
typedef struct {
    talk_options line;
    const char *machine;        /* a machine file, or NULL */
} mover_options;
extern const option mover_rows[];

typedef struct {
    double to[ENGINE_AXES];     /* mm */
    double feed;                /* mm/s */
    loft_guard guard;           /* without inputs: none */
    uint16_t away;              /* closed inputs that it leads away from */
    bool (*ends)(void *context);    /* asked in each step: end it now? NULL: never */
    void *context;
} mover_move;

enum mover_end { MOVER_ARRIVED, MOVER_GUARDED, MOVER_ENDED };

typedef struct {
    enum mover_end how;         /* at `to`; the guard came true; `ends` asked for it */
    double latched[ENGINE_AXES];    /* mm, of a guard that came true: where the input changed */
    int32_t steps[LOFT_AXES];       /* the same */
    uint16_t by;                    /* the inputs that did */
} mover_outcome;

/* It does one thing at a time. It must not move while it does. */
typedef struct mover {
    host *host;                 /* hears of what is wrong */
    mover_options o;
    planning p;
    talk t;
    double at[ENGINE_AXES];     /* mm: where the tool is */
    mover_outcome out;          /* of the last move */
    /* ---- */
    int (*stage)(struct mover *v, double now, task_wants *w);   /* NULL: it does nothing */
    int (*then)(struct mover *v, double now, task_wants *w);    /* when the machine is greeted */
    int code;                   /* of something that was refused before it began */
    settings_work settings;
    settings kept;              /* by the machine, and how much farther its zero is to lie, mm */
    double farther[ENGINE_AXES];
    mover_move m;
    job_work w;
    int planned;                /* enum loft_status */
    bool ended;                 /* we asked for its end */
    unsigned axes;              /* that are placed, */
    double place[ENGINE_AXES];  /* there; */
    int32_t steps[LOFT_AXES];
    int axis;                   /* whose table is told */
    bool high, counts;
    double until;               /* the machine obeys, or never */
    double began;               /* the move */
} mover;

/* Read the machine's file, if there is one, and open the port; next the machine is greeted, which
 * must be at rest. Returns 0, or an exit code after one message; call mover_close in any
 * case. */
int  mover_open(mover *v, host *h, const mover_options *o, double now);
void mover_close(mover *v);

/* Go on with what was begun by one of the calls below, or by mover_open: TASK_GOES, 0, or an exit
 * code after one message. */
int  mover_step(mover *v, double now, task_wants *w);
task mover_task(mover *v);

/* Greet it again: its position and its closed inputs are those of now. */
void mover_ready(mover *v);

/* Move the tool straight from where it is. At the end v->at is the new place, and v->out tells how
 * it ended. It is an error if a limit switch or the user did. */
void mover_go(mover *v, const mover_move *m);

/* Tell the machine where the tool is, on the axes of `axes` (bit i: axis i; all of them, if motors
 * are not axes). */
void mover_place(mover *v, unsigned axes, const double at[ENGINE_AXES]);

/* Tell a machine whose motors are axes where its table begins and ends on this one: it then refuses
 * what leaves it. Without `counts` it has no table any more. One that cannot is not told. */
void mover_table(mover *v, int axis, bool counts);

/* Let the machine keep, in its settings, that its zero lies farther on its table: by this on each
 * axis. A machine of a file, and one that keeps no settings, are refused. */
void mover_keep_zero(mover *v, const double farther[ENGINE_AXES]);

/* Move straight to a place that table and closed switches allow. */
void mover_to(mover *v, const double to[ENGINE_AXES], double feed);

/* The closed limit switches and, of them, those that a move from `from` to `to` leads away from. A
 * switch for both ends of its axis leads nowhere. */
uint16_t mover_away(const mover *v, const double from[ENGINE_AXES], const double to[ENGINE_AXES]);

/* Refuse a move while a limit switch is closed that it does not lead away from. Returns 0, or an
 * exit code after one message. */
int mover_free(const mover *v, const double to[ENGINE_AXES]);

/* "3.000 0.000 -2.500" */
const char *mover_text(const double at[ENGINE_AXES], char text[96]);

/* Read `xy`: letters of axes, each once, into axis[]. Returns 0, or an exit code after one
 * message. */
int mover_axes(host *h, const char *text, bool axis[ENGINE_AXES]);

#endif

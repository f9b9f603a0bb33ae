/* host-tools/send/mover.h -- single straight moves of the tool, each a job that is waited for, with
 * or without a guard
 * SPDX-License-Identifier: MIT
 *
 * Homing, probing and jogging are such moves. They are planned like a drawing, and the machine
 * needs nothing for them but guards and place (lib/machine/latch.h).
 */
#ifndef LOFT_MOVER_H
#define LOFT_MOVER_H

#include "plan/planning.h"      /* planning */
#include "send/talk.h"          /* talk */

/* The options of a command that moves. */
typedef struct {
    talk_options line;
    const char *machine;        /* a machine file, or NULL */
} mover_options;
extern const option mover_rows[];

typedef struct {
    mover_options o;
    planning p;
    talk t;
    double at[ENGINE_AXES];     /* mm: where the tool is */
} mover;

/* Read the machine's file, if there is one, and greet the machine, which must be at rest. `keys`:
 * also read single keys (base/keys.h). Returns 0, or an exit code after printing one line; call
 * mover_close in any case. */
int  mover_open(mover *v, const mover_options *o, bool keys);
void mover_close(mover *v);

/* Greet it again: its position and its closed inputs are those of now. Results as above. */
int mover_ready(mover *v);

typedef struct {
    double to[ENGINE_AXES];     /* mm */
    double feed;                /* mm/s */
    loft_guard guard;           /* without inputs: none */
    uint16_t away;              /* closed inputs that it leads away from */
    bool (*ends)(void *context);    /* asked again and again: end it now? NULL: never */
    void *context;
} mover_move;

enum mover_end { MOVER_ARRIVED, MOVER_GUARDED, MOVER_ENDED };

typedef struct {
    enum mover_end how;         /* at `to`; the guard came true; `ends` asked for it */
    double latched[ENGINE_AXES];    /* mm, of a guard that came true: where the input changed */
    int32_t steps[LOFT_AXES];       /* the same */
    uint16_t by;                    /* the inputs that did */
} mover_outcome;

/* Move the tool straight from where it is, and wait for the end. Then v->at is the new place.
 * Returns 0, or an exit code after printing one line: also if a limit switch or ^C ended it. */
int mover_go(mover *v, const mover_move *m, mover_outcome *out);

/* Tell the machine where the tool is, on the axes of `axes` (bit i: axis i; all of them, if motors
 * are not axes). Results as above. */
int mover_place(mover *v, unsigned axes, const double at[ENGINE_AXES]);

/* Tell a machine whose motors are axes where its table begins and ends on this one: it then refuses
 * what leaves it. Without `counts` it has no table any more. Results as above; one that cannot is
 * not told. */
int mover_table(mover *v, int axis, bool counts);

/* The closed limit switches and, of them, those that a move from `from` to `to` leads away from. A
 * switch for both ends of its axis leads nowhere. */
uint16_t mover_away(const mover *v, const double from[ENGINE_AXES], const double to[ENGINE_AXES]);

/* Refuse a move while a limit switch is closed that it does not lead away from. Returns 0, or an
 * exit code after printing one line. */
int mover_free(const mover *v, const double to[ENGINE_AXES]);

/* Move straight to a place that table and closed switches allow. Results as of mover_go. */
int mover_to(mover *v, const double to[ENGINE_AXES], double feed);

/* Unless `code` tells of a failure, print where the tool is; returns `code`. */
int mover_told(const mover *v, int code);

/* "3.000 0.000 -2.500" */
const char *mover_text(const double at[ENGINE_AXES], char text[96]);

/* Read `xy`: letters of axes, each once, into axis[]. Results as above. */
int mover_axes(const char *text, bool axis[ENGINE_AXES]);

#endif

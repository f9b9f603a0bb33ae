/* host-tools/send/settings.h -- the settings that a machine keeps: read, adopted and written
 * SPDX-License-Identifier: MIT
 *
 * What the machine obeys is numbers in it (lib/machine/settings.h). The rest is lines of a machine
 * file, which it only keeps.
 */
#ifndef LOFT_SETTINGS_H
#define LOFT_SETTINGS_H

#include "read/machine_file.h"  /* machine_file */
#include "send/talk.h"          /* talk */

typedef struct {
    machine_file m;
    uint8_t origin;             /* enum loft_settings_origin */
    uint8_t number;             /* of the write */
    uint8_t obeyed;             /* bit k: the board obeys byte k of the wiring */
    unsigned size, room;        /* bytes */
} settings;

/* Does the machine keep settings? */
static inline bool settings_kept(const talk *t)
{
    return t->sender.machine.kinds & LOFT_TAKES_SETTINGS;
}

/* Reading or writing them, stepped. */
typedef struct settings_work {
    settings *s;                /* that are read; NULL: own */
    settings own;
    talk *t;
    machine_file *adopts;
    uint8_t *block;             /* that is read or written, */
    unsigned size, at;          /* up to here by now */
    double until;               /* the answer comes, or never */
    double wait;                /* s, for the greeting behind a write */
    bool resets;
    int (*stage)(struct settings_work *k, double now, task_wants *w);
} settings_work;

/* Read them; the machine was greeted. */
void settings_read(settings_work *k, settings *s, talk *t);

/* Write s->m, which follows those that were read, and greet the machine again. It is refused if the
 * board does not obey one of them. */
void settings_write(settings_work *k, settings *s, talk *t, double wait);

/* Put the settings of the firmware in force again, and read them. */
void settings_reset(settings_work *k, settings *s, talk *t, double wait);

/* For a command without --machine: read a machine from its settings, if it keeps any. Warns if they
 * are damaged. */
void settings_adopt(settings_work *k, machine_file *m, talk *t);

/* Go on with what was begun: TASK_GOES, 0, or an exit code after one message. */
int  settings_step(settings_work *k, double now, task_wants *w);
task settings_task(settings_work *k);

/* Leave it in the middle. */
void settings_leave(settings_work *k);

#endif

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

/* Read them; the machine was greeted. Returns 0, or an exit code after printing one line. */
int settings_read(settings *s, talk *t);

/* Write s->m, which follows those that were read, and greet the machine again. Results as above:
 * also if the board does not obey one of them. */
int settings_write(const settings *s, talk *t, double wait);

/* Put the settings of the firmware in force again, and read them. Results as settings_write. */
int settings_reset(settings *s, talk *t, double wait);

/* For a command without --machine: read a machine from its settings, if it keeps any. Says so on
 * standard error if they are damaged. Results as above. */
int settings_adopt(machine_file *m, talk *t);

#endif

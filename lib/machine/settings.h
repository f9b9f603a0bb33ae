/* lib/machine/settings.h -- settings: what a machine is like, kept without power in two copies
 * SPDX-License-Identifier: MIT
 *
 * A copy is a block of bytes: a check, a head of numbers that the machine obeys, and a text that
 * only the host reads. WIRE.md has the table. One copy is in force. Writing goes to the other one,
 * and its check comes last. So when the power fails at any byte, the old settings or the new ones
 * are in force, never a mixture.
 *
 * Without a sound copy the values of the configuration are in force, and loft_settings_origin_of
 * says why. A sound copy of a head alone, LOFT_SETTINGS_AXES bytes, puts them in force again.
 */
#ifndef LOFT_MACHINE_SETTINGS_H
#define LOFT_MACHINE_SETTINGS_H

#include "wire/receiver.h"  /* loft_axis_config */

LOFT_BEGIN_C

/* Bytes of `wiring`: how pins and contacts are wired. */
enum loft_wiring {
    LOFT_WIRING_REVERSED,       /* bit i: the motor of axis i turns the other way               */
    LOFT_WIRING_SERVO,          /* 10 us: the third axis is a servo, with this pulse at 0 and 1 us
                                 * more for each step; 0: it is a motor                         */
    LOFT_WIRING_PULSE,          /* us: the length of a step pulse                               */
    LOFT_WIRING_IDLE,           /* s: motors at rest are switched off after it; 0: never        */
    LOFT_WIRING_OPENS,          /* and the next byte: LOFT_INPUT_ of contacts that open         */
    LOFT_WIRING_OBEYED = 6,     /* bit k: the board obeys byte k; never loaded                  */
    LOFT_WIRING_BYTES  = 7
};

#define LOFT_SETTINGS_LAYOUT 1u
#define LOFT_SETTINGS_AXES   8u         /* where the axes begin in a copy */
#define LOFT_SETTINGS_WIRING (LOFT_SETTINGS_AXES + 16u * LOFT_AXES)
#define LOFT_SETTINGS_TEXT   (LOFT_SETTINGS_WIRING + LOFT_WIRING_BYTES)

/* The first five fields are the caller's; the rest may change without notice. */
typedef struct loft_settings loft_settings;
struct loft_settings {
    uint8_t (*get)(uint16_t at);        /* a byte of the memory, 0 .. 2 room - 1; NULL: no memory */
    void    (*put)(uint16_t at, uint8_t byte);  /* it lasts when this returns */
    void    (*usual)(loft_settings *s); /* set s->axis and s->wiring to those of the firmware; NULL:
                                         * there is no way back to them */
    uint16_t room;                      /* bytes of each copy */
    uint8_t  wiring[LOFT_WIRING_BYTES]; /* without a sound copy; then what is in force */

    loft_axis_config *axis;
    uint8_t  which;                     /* the copy in force; 2: none is */
};

/* Put the newest sound copy in force: into `axis` and s->wiring. Without one both stay.
 *
 *   shape   axis stays borrowed
 *   range   get and put; `usual` leaves wiring[LOFT_WIRING_OBEYED]; any bytes in the memory */
void loft_settings_init(loft_settings *s, loft_axis_config axis[LOFT_AXES]);

/* Where the settings in force come from. */
enum loft_settings_origin loft_settings_origin_of(const loft_settings *s);

/* A byte of the settings in force. Those of a machine without a sound copy can be read as well. */
uint8_t loft_settings_get(const loft_settings *s, uint16_t at);

/* A byte of the copy that is not in force. */
uint8_t loft_settings_spare(const loft_settings *s, uint16_t at);

/* Write to the copy that is not in force; bytes beyond it are dropped. A write at 0, the check,
 * puts it in force if it is sound. Returns true if so. */
bool loft_settings_put(loft_settings *s, uint16_t at, const uint8_t byte[], uint8_t count);

LOFT_END_C

#endif

/* host-tools/send/facts.h -- how a job goes: as numbers, and in lines
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_FACTS_H
#define LOFT_FACTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "engine/engine.h"      /* ENGINE_AXES */

typedef struct {
    const char *state;              /* "draws", "holds", "held", "pause", "aborts", "waits",
                                     * "plans" */
    double done, total;             /* ticks, or items while it plans */
    uint32_t item, items;           /* items 0: not known yet */
    uint32_t queued;
    double feed;                    /* mm/s */
    unsigned override;              /* % */
    double at[ENGINE_AXES];         /* of the tool, mm */
    size_t moves;                   /* of the path, which are behind it */
    bool rests;                     /* nothing can go on: this time does not count */
} send_facts;

/* A line, without its end: an event of a job that runs; something about its end; the end. */
enum send_line { SEND_EVENT, SEND_NOTE, SEND_RESULT };

/* Who hears them. */
typedef struct {
    void (*tell)(void *context, enum send_line what, const char *line);     /* NULL: nobody */
    void *context;
    bool shown;                     /* the state is shown: what is awaited does not repeat it */
} send_teller;

void send_tell(const send_teller *to, enum send_line what, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif

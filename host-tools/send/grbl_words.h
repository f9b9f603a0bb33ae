/* host-tools/send/grbl_words.h -- explains grbl's errors, alarms and states, with remedies
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GRBL_WORDS_H
#define LOFT_GRBL_WORDS_H

#include <stddef.h>

enum grbl_doing {
    GRBL_IDLE,
    GRBL_RUNS,
    GRBL_SLOWS,         /* it will stand still */
    GRBL_STANDS,
    GRBL_AWAITS,        /* somebody */
    GRBL_ENDS           /* no job can go on from there */
};

/* A state of its reports. */
typedef struct {
    const char *word;           /* "Hold:0" */
    enum grbl_doing doing;
    const char *text;           /* what it is, and how it ends; "": that is normal */
} grbl_state;

/* The state that a report begins with, for example "Hold:0" or "Door:1|WPos:..". One that is not
 * known awaits somebody. */
const grbl_state *grbl_state_of(const char *report);

/* Explain what follows `error:` and `ALARM:`, a number or words; "": there is nothing to add. */
const char *grbl_error_text(const char *said);
const char *grbl_alarm_text(const char *said);

#endif

/* host-tools/send/wire_text.h -- the traffic in words: each frame becomes one line of text
 * SPDX-License-Identifier: MIT
 *
 *     12.345 > JOB     session 12 job 1a2b3c4d spans start 0 0 0
 *     12.347 < ACK     session 12 next 0 limit 64 executed 0 running
 *
 * The columns are seconds, direction (> to the machine), kind, fields. A damaged frame is shown as
 * such, with its length.
 */
#ifndef LOFT_WIRE_TEXT_H
#define LOFT_WIRE_TEXT_H

#include <stdio.h>

#include "wire/message.h"   /* loft_frame */

/* One direction of a line. */
typedef struct {
    loft_frame frame;
    unsigned long long bytes, frames, damaged;
    char arrow;                 /* '>' or '<' */
} wire_text;

void wire_text_init(wire_text *w, char arrow);

/* Take bytes that passed at `seconds`, and print the frames that they complete to `out`. */
void wire_text_push(wire_text *w, FILE *out, double seconds, const uint8_t byte[], size_t count);

#endif

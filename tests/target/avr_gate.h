/* tests/target/avr_gate.h -- decides whose turn it is: may the emulated machine's time advance, or
 * must the host send first?
 * SPDX-License-Identifier: MIT
 *
 * It listens to both directions of the line. Time stops while no job is running and the machine has
 * nothing more to send, and while the host may send items but has not. It may while fewer than
 * LOFT_WINDOW_FRAMES frames lack an answer: see wire/window.h. So no result depends on how fast the
 * host is.
 */
#ifndef TARGET_GATE_H
#define TARGET_GATE_H

#include "wire/message.h"
#include "wire/window.h"        /* LOFT_WINDOW_FRAMES */

struct gate {
    loft_frame from_host, from_machine;
    loft_ack ack;               /* the latest                                         */
    uint32_t sent;              /* items that the host has sent, including repeats */
    uint32_t flight[LOFT_WINDOW_FRAMES];    /* where the latest frames end, in items */
    uint32_t flights;
    uint16_t queue, points;     /* items of both kinds that the machine's queue takes */
    uint32_t step;              /* items sent at once: see can_send of the sender */
    bool ended;                 /* END or an abort was sent, or nothing but a greeting */
    uint32_t jobs;              /* closed                                             */
    uint32_t frames, naks;      /* of the machine                                     */
};

void gate_init(struct gate *g);
void gate_host(struct gate *g, uint8_t byte);
void gate_machine(struct gate *g, uint8_t byte);

/* Are all frames in flight that may be? The host waits for an answer. */
static inline bool gate_full(const struct gate *g)
{
    return g->flights == LOFT_WINDOW_FRAMES && (int32_t)(g->flight[0] - g->ack.next) > 0;
}

/* Is a job running, and is it the host's turn in it? */
static inline bool gate_busy(const struct gate *g)      { return loft_state_busy(g->ack.state); }
static inline bool gate_owed(const struct gate *g)
{
    return !g->ended && !gate_full(g) && (int32_t)(g->ack.limit - g->sent) >= (int32_t)g->step;
}

#endif

/* tests/target/avr_gate.h -- whose turn it is: may an emulated machine's time go on, or has the
 * host still to speak?
 * SPDX-License-Identifier: MIT
 *
 * It listens to both directions of the line. Time stands while no job is under way and the machine
 * has nothing more to say, and while the host may send items and has not: so no result depends on
 * how fast the host is.
 */
#ifndef TARGET_GATE_H
#define TARGET_GATE_H

#include "wire/message.h"

struct gate {
    loft_frame from_host, from_machine;
    loft_ack ack;               /* the latest                                         */
    uint32_t sent;              /* items that the host has sent, repeated ones too    */
    uint16_t queue, points;     /* items of both kinds that the machine's queue takes */
    uint32_t step;              /* so many items at once: see can_send of the sender  */
    bool ended;                 /* END was sent                                       */
    uint32_t jobs;              /* closed                                             */
    uint32_t frames, naks;      /* of the machine                                     */
};

void gate_init(struct gate *g);
void gate_host(struct gate *g, uint8_t byte);
void gate_machine(struct gate *g, uint8_t byte);

/* Is a job under way, and is it the host's turn in it? */
static inline bool gate_busy(const struct gate *g)      { return loft_state_busy(g->ack.state); }
static inline bool gate_owed(const struct gate *g)
{
    return !g->ended && (int32_t)(g->ack.limit - g->sent) >= (int32_t)g->step;
}

/* Has the machine told of all items that were sent? If not the host may wait for that, and send no
 * more. */
static inline bool gate_answered(const struct gate *g)  { return g->ack.next == g->sent; }

#endif

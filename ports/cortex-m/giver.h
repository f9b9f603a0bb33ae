/* ports/cortex-m/giver.h -- the slots of a stream given by an interrupt, where DMA does not reach
 * the pins
 * SPDX-License-Identifier: MIT
 *
 * A port includes it after these: GIVER_SET(word) and GIVER_END(word) begin and end the pulses,
 * GIVER_EVENT() takes back the request of the timer, GIVER_TIME() is the cycles of the core since
 * the slot began, and GIVER_HZ their number in a second. A pulse has 2 us, or 1 us with more than
 * 250 slots in a millisecond: the interrupt waits for its end, and does the rest meanwhile.
 */
#ifndef LOFT_CORTEX_GIVER_H
#define LOFT_CORTEX_GIVER_H

#include "cortex-m/cortex.h"
#include "cortex-m/stream.h"

/* Reading the time after the begin and before the end adds this, at least. */
#define GIVER_READS 10u
#define GIVER_PULSE (GIVER_HZ / (LOFT_SLOTS > 250 ? 1000000u : 500000u) - GIVER_READS)

static const uint32_t *volatile giver_next;     /* word, and the end of its half */
static const uint32_t *giver_end;

static void end_half(void)
{
    const uint32_t *const ring = cortex_ring();

    if (giver_next == ring + STREAM_WORDS)
        giver_next = ring;
    giver_end = giver_next + STREAM_HALF;
    cortex_block();
}

void cortex_slot(void)
{
    const uint32_t *const at = giver_next, word = *at;

    GIVER_SET(word);
    if (word & STREAM_STEPS) {
        const uint32_t begun = GIVER_TIME();
        GIVER_EVENT();
        giver_next = at + 1;
        while (GIVER_TIME() - begun < GIVER_PULSE) {
        }
        GIVER_END(word);
    } else {
        GIVER_EVENT();
        giver_next = at + 1;
    }
    if (at + 1 == giver_end)
        end_half();
}

static inline void giver_begin(void)
{
    giver_next = cortex_ring();
    giver_end  = giver_next + STREAM_HALF;
}

uint32_t cortex_given(void)     { return (uint32_t)(giver_next - cortex_ring()); }
void     cortex_acknowledge(void) {}

#endif

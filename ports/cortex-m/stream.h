/* ports/cortex-m/stream.h -- slots made ahead: a ring of words that a timer gives to the pins,
 * without the core
 * SPDX-License-Identifier: MIT
 *
 * A timer requests a transfer by DMA in each slot, from the ring to the register that sets and
 * clears pins. A second request, later in the slot, ends the pulses: its word clears all step pins.
 * The core makes a half of the ring when that half is given. So a pulse is counted half a
 * millisecond before it is given, at most, and so much later a stop begins at the pins.
 *
 *     cortex_block    a half of the ring is given: in the interrupt of highest priority
 *     cortex_fill     in that of lowest priority: makes that half, and latches
 *     cortex_sample   while a guard waits, 100,000 times a second: looks at its input
 *
 * An output changes where the half begins in which its tick does: 0.25 ms before it, at most. While
 * the timer stands all are off.
 *
 * On an RP2040 and an RP2350 DMA feeds a state machine instead of the pins: rp2040/port.c. Where
 * DMA does not reach the pins a short interrupt gives the words, with STREAM_BY_CORE: giver.h.
 *
 * If a half is not made in time the timer stops until it is: no word is given twice.
 */
#ifndef LOFT_CORTEX_STREAM_H
#define LOFT_CORTEX_STREAM_H

#include <stdbool.h>
#include <stdint.h>

#define STREAM_HALF  (LOFT_SLOTS / 4u)      /* slots of half a ring: a quarter of a tick */
#define STREAM_WORDS (2 * STREAM_HALF)

/* Words that the transfer has fetched ahead of those that it has given: 0 or 1. The first word of a
 * half is made with the half before, so that it is there. */
#ifndef STREAM_AHEAD
#  define STREAM_AHEAD 0
#endif

/* Words that the transfer has taken, at most, and that wait for their slots behind it. */
#ifndef STREAM_LAG
#  define STREAM_LAG 0
#endif

/* The outputs that the port has. */
#ifndef STREAM_OUTPUTS
#  define STREAM_OUTPUTS 0
#endif

/* A word sets pins by its low half and clears pins by its high one: bits 0..2 step x, y, z, bits
 * 3..5 their directions. Every word has all directions. A port may have a layout of its own, with
 * steps in bits 0..2: the number of the step's bit and of the direction's, of axis i. */
#define STREAM_STEPS 0x07u
#ifdef STREAM_LAYOUT
#  include STREAM_LAYOUT
#else
#  define STREAM_STEP(i) (i)
#  define STREAM_DIR(i)  (3 + (i))
static inline uint32_t stream_dir(uint8_t dir)
{
    return (uint32_t)(dir & STREAM_STEPS) << 3 | (uint32_t)(~dir & STREAM_STEPS) << (3 + 16);
}
#endif

/* The ring, for the transfer. */
uint32_t *cortex_ring(void);

/* OF THE PORT: set up timer and transfer, and return the clock of the core in Hz; let the timer
 * run, also at the begin of each half, or stand; the number of words of this turn of the ring that
 * the transfer has taken, and, with a STREAM_LAG, of those that wait; the transfer's interrupt is
 * acknowledged; set an output, from 1, if it has any. */
uint32_t cortex_stream(uint32_t slot_hz);
void     cortex_run(bool run);
uint32_t cortex_given(void);
uint32_t cortex_waiting(void);
void     cortex_acknowledge(void);
void     cortex_output(int output, uint16_t level);

/* OF A PORT without SysTick, with CORTEX_SAMPLE_IRQ: let that interrupt come so often a second; it
 * is cortex_sampler, which calls cortex_sample. */
void     cortex_samples(uint32_t hz);

#endif

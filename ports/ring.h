/* ports/ring.h -- ring: bytes that have come in an interrupt, waiting for the main loop; no lock,
 * they meet in single bytes
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_RING_H
#define LOFT_RING_H

#include <stddef.h>
#include <stdint.h>

#include "machine/machine.h"    /* LOFT_BARRIER */

/* A power of two, at most 32768 and on an 8-bit part 256: what the line brings while the main loop
 * is busy, 1 ms at 1 Mbit/s being 100 bytes; an emulated line has no speed, and may bring all that
 * a sender has under way. */
#ifndef LOFT_RING_BYTES
#  define LOFT_RING_BYTES 1024u
#endif

#if LOFT_RING_BYTES <= 256
typedef uint8_t  loft_ring_index;
#else
typedef uint16_t loft_ring_index;
#endif

typedef struct {
    volatile uint8_t byte[LOFT_RING_BYTES];
    volatile loft_ring_index head;                  /* the interrupt */
    loft_ring_index tail;                           /* the main loop */
} loft_ring;

/* In the interrupt. A byte that finds no room is lost: its frame is then damaged, and sent
 * again. */
static inline void loft_ring_put(loft_ring *r, uint8_t byte)
{
    const loft_ring_index head = r->head, after = (loft_ring_index)((head + 1u) % LOFT_RING_BYTES);

    if (after != r->tail) {
        r->byte[head] = byte;
        LOFT_BARRIER();
        r->head = after;
    }
}

/* In the main loop: as many bytes as there are, at most `max`. */
static inline size_t loft_ring_take(loft_ring *r, uint8_t *bytes, size_t max)
{
    const loft_ring_index head = r->head;
    loft_ring_index tail = r->tail;
    size_t count = 0;

    for (; tail != head && count < max; tail = (loft_ring_index)((tail + 1u) % LOFT_RING_BYTES))
        bytes[count++] = r->byte[tail];
    LOFT_BARRIER();
    r->tail = tail;
    return count;
}

#endif

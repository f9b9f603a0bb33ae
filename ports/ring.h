/* ports/ring.h -- ring buffer: bytes from an interrupt wait for the main loop, without a lock
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_RING_H
#define LOFT_RING_H

#include <stddef.h>
#include <stdint.h>

#include "machine/machine.h"    /* LOFT_BARRIER */

/* A power of two, at most 32768, and 256 on an 8-bit part. It must hold what the line brings while
 * the main loop is busy: 1 ms at 1 Mbit/s is 100 bytes. An emulated line has no speed, and may
 * bring everything that a sender has in flight. */
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

/* For the interrupt. A byte that finds no room is lost. Its frame is then damaged, and is sent
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

/* For the main loop: take the waiting bytes, at most `max`. */
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

/* lib/machine/queue.h -- the queue between the main loop, which receives items, and the tick, which
 * executes them
 * SPDX-License-Identifier: MIT
 *
 * One producer and one consumer, which may interrupt each other at any place. What they share is
 * one byte per cell, written last by whoever hands the cell over; every index belongs to one side
 * alone. So nothing can be read half written, also on parts with 8-bit memory accesses, and no
 * interrupt is ever locked out.
 */
#ifndef LOFT_MACHINE_QUEUE_H
#define LOFT_MACHINE_QUEUE_H

#include "wire/codec.h"     /* loft_item */

LOFT_BEGIN_C

#define LOFT_QUEUE_MAX 32768u

/* The compiler moves no access to memory across this. (The processor does not either: there is one
 * core.) */
#if defined(__GNUC__)
#  define LOFT_BARRIER() __asm__ volatile ("" ::: "memory")
#else
#  define LOFT_BARRIER() ((void)0)      /* have the compiler not optimise across files */
#endif

typedef struct {
    loft_item item;
    uint8_t cap;                        /* 0: the cell is empty; any other number goes with the
                                         * item */
} loft_cell;

/* Complete so that it can be static; the fields may change without notice. */
typedef struct {
    volatile loft_cell *cell;
    uint16_t count;
    uint16_t head, freed, room;         /* producer: fill next; give back next; empty cells known */
    volatile uint16_t tail;             /* consumer: take next; look at next; cells between them */
    uint16_t seen, looked;
} loft_queue;

/* Copy a place, LOFT_AXES numbers, that one of the two sides shares with the other: number by
 * number. */
void loft_place_copy(volatile int32_t *to, const volatile int32_t *from);

/* Empty the queue. Neither side may be at work.
 *
 *   shape   cell[0..count-1] is the caller's memory and stays borrowed
 *   range   count 2..LOFT_QUEUE_MAX, otherwise LOFT_ERR_RANGE */
enum loft_status loft_queue_init(loft_queue *q, volatile loft_cell *cell,
                                 uint16_t count) LOFT_CHECKED;

// Producer
// --------

/* Append a copy of `item` with its cap, 1..255; LOFT_ERR_SPACE if the queue is full. */
enum loft_status loft_queue_push(loft_queue *q, const loft_item *item, uint8_t cap) LOFT_CHECKED;

/* The item that was appended last; of an empty queue: whatever was there before. */
const volatile loft_item *loft_queue_last(const loft_queue *q);

/* Items that can be appended now. */
uint16_t loft_queue_room(loft_queue *q);

/* Of the items in it, number `index` from the oldest; NULL if there are not so many. It stays as it
 * is until the producer appends the next one, but the consumer may take items meanwhile: ask the
 * consumer's count before and after. */
const volatile loft_item *loft_queue_peek(const loft_queue *q, uint16_t index);


// Consumer
// --------

/* Look at the oldest item that was not looked at: gives its ticks, or 0 if there is none. */
uint16_t loft_queue_look(loft_queue *q);

/* The oldest item that was looked at, or NULL; it stays as it is until loft_queue_poll. */
static inline const volatile loft_item *loft_queue_first(const loft_queue *q)
{
    return q->looked ? &q->cell[q->tail].item : NULL;
}

/* Of the items that were looked at, number `index` from the oldest; NULL if there are not so
 * many. */
const volatile loft_cell *loft_queue_cell(const loft_queue *q, uint16_t index);

/* Take the oldest item out. Returns false if there is none that was looked at. */
bool loft_queue_poll(loft_queue *q);

/* Does every cell hold an item that was looked at? */
static inline bool loft_queue_full(const loft_queue *q)     { return q->looked == q->count; }

LOFT_END_C

#endif

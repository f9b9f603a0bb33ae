/* lib/machine/queue.h -- the queue from the main loop, which receives items, to the tick, which
 * executes them
 * SPDX-License-Identifier: MIT
 *
 * One producer and one consumer may interrupt each other at any place. They share one byte per
 * cell, which the side that hands the cell over writes last. Every index belongs to one side. So
 * nothing is read half written, even on parts with 8-bit memory accesses, and no interrupt is ever
 * disabled.
 */
#ifndef LOFT_MACHINE_QUEUE_H
#define LOFT_MACHINE_QUEUE_H

#include "wire/codec.h"     /* loft_item */

LOFT_BEGIN_C

#define LOFT_QUEUE_MAX 32768u

/* The compiler moves no memory access across this. Nor does the processor, because there is one
 * core. */
#if defined(__GNUC__)
#  define LOFT_BARRIER() __asm__ volatile ("" ::: "memory")
#else
#  define LOFT_BARRIER() ((void)0)      /* the compiler must not optimize across files */
#endif

typedef struct {
    loft_item item;
    uint8_t tag;                        /* 0: the cell is empty; else a number for the item */
} loft_cell;

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    volatile loft_cell *cell;
    uint16_t count;
    uint16_t head, freed, room;         /* producer: fill here, reclaim here; empty cells */
    volatile uint16_t tail;             /* consumer: next to take */
    uint16_t seen, looked;              /* consumer: next to look at; cells from tail to seen */
} loft_queue;

/* Copy a position, LOFT_AXES numbers that the two sides share, number by number. */
void loft_place_copy(volatile int32_t *to, const volatile int32_t *from);

/* Empty the queue. Neither side may be active.
 *
 *   shape   cell[0..count-1] is the caller's memory and stays borrowed
 *   range   count 2..LOFT_QUEUE_MAX, otherwise LOFT_ERR_RANGE */
enum loft_status loft_queue_init(loft_queue *q, volatile loft_cell *cell,
                                 uint16_t count) LOFT_CHECKED;

// Producer
// --------

/* Append a copy of `item` with its tag, 1..255; LOFT_ERR_SPACE if the queue is full. */
enum loft_status loft_queue_push(loft_queue *q, const loft_item *item, uint8_t tag) LOFT_CHECKED;

/* The item that was appended last. For an empty queue: whatever is in that cell. */
const volatile loft_item *loft_queue_last(const loft_queue *q);

/* The number of items that can be appended now. */
uint16_t loft_queue_room(loft_queue *q);

/* Item number `index` from the oldest; NULL if there are fewer. The cell does not change until the
 * producer appends an item. But the consumer may take items meanwhile: compare the consumer's count
 * before and after. */
const volatile loft_item *loft_queue_peek(const loft_queue *q, uint16_t index);


// Consumer
// --------

/* Look at the oldest item not yet looked at: gives its ticks, or 0 if there is none. */
uint16_t loft_queue_look(loft_queue *q);

/* The oldest item that was looked at, or NULL. It does not change until loft_queue_poll. */
static inline const volatile loft_item *loft_queue_first(const loft_queue *q)
{
    return q->looked ? &q->cell[q->tail].item : NULL;
}

/* Cell number `index` from the oldest, among those that were looked at; NULL if there are fewer. */
const volatile loft_cell *loft_queue_cell(const loft_queue *q, uint16_t index);

/* Remove the oldest item. Returns false if no item that was looked at is left. */
bool loft_queue_poll(loft_queue *q);

/* True if every cell holds an item that was looked at. */
static inline bool loft_queue_full(const loft_queue *q)     { return q->looked == q->count; }

LOFT_END_C

#endif

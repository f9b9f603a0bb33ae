/* lib/machine/points.h -- sampled points in the cells of a queue: as bytes, many to a cell
 * SPDX-License-Identifier: MIT
 *
 * A point is its step from the one before, and of that, which changes little, the change: one byte
 * for three axes as a rule, where an item takes 38. So the queue of a small part holds a third of a
 * second of motion instead of 12 ms.
 *
 * Producer and consumer may interrupt each other at any place, as with a queue of items. They share
 * the `cap` of a cell: how many points are in it, which the producer counts up behind the bytes of
 * each, and whether more will follow; the consumer sets it to 0 to give the cell back.
 */
#ifndef LOFT_MACHINE_POINTS_H
#define LOFT_MACHINE_POINTS_H

#include "machine/queue.h"      /* loft_queue                          */
#include "wire/point_code.h"    /* loft_point_encode, LOFT_POINT_BYTES2 */

LOFT_BEGIN_C

#define LOFT_POINTS_MOST 32768u     /* that room is told for: what a frame's number can say */

/* Points that a cell holds at the least. */
#define LOFT_POINTS_PER_CELL (sizeof(loft_item) / LOFT_POINT_BYTES2)

/* Complete so that it can be static; the fields may change without notice. */
typedef struct {
    int16_t last[LOFT_AXES];            /* producer: the step of the point that was appended last */
    uint8_t used, count;                /* bytes and points in the cell that is being filled */
    int16_t step[LOFT_AXES];            /* consumer: the step of the point that was taken last */
    uint8_t at, taken;                  /* bytes and points taken from the oldest cell */
    uint8_t told;                       /* points that were looked at in the one that is looked
                                         * at */
} loft_points;

/* Begin with an empty queue, at rest. Neither side may be at work. */
void loft_points_init(loft_points *p);

/* Points that a queue of so many cells holds at the least. */
uint16_t loft_points_capacity(uint16_t cells);


// Producer
// --------

/* Append the point that is `step` steps from the one before; LOFT_ERR_SPACE if there is no room.
 *
 *   range   any steps
 *   cost    that of loft_point_encode */
enum loft_status loft_points_push(loft_points *p, loft_queue *q,
                                  const int16_t step[LOFT_AXES]) LOFT_CHECKED;

/* Points that can be appended now, whatever they are. It falls by at most one with each of them. */
uint16_t loft_points_room(const loft_points *p, loft_queue *q);


// Consumer
// --------

/* Look at what has come: gives the number of points that were not looked at before, or 0; ask again
 * until it is 0. */
uint8_t loft_points_look(loft_points *p, loft_queue *q);

/* Take the oldest point out: p->step is its step. Returns false if there is none that was looked
 * at.
 *
 *   cost    that of loft_point_decode */
bool loft_points_poll(loft_points *p, loft_queue *q);

LOFT_END_C

#endif

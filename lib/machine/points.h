/* lib/machine/points.h -- sampled points in the cells of a queue: as bytes, many per cell
 * SPDX-License-Identifier: MIT
 *
 * A point is stored as the change of its step, which is small: typically one byte for three axes,
 * where an item takes 38. So the queue of a small part holds a third of a second of motion instead
 * of 12 ms.
 *
 * Producer and consumer may interrupt each other at any place, as with a queue of items. They share
 * the `tag` of a cell: the number of points in it, and whether more will follow. The producer
 * increments it after the bytes of each point. The consumer sets it to 0 to give the cell back.
 */
#ifndef LOFT_MACHINE_POINTS_H
#define LOFT_MACHINE_POINTS_H

#include "machine/queue.h"      /* loft_queue                          */
#include "wire/point_code.h"    /* loft_point_encode, LOFT_POINT_BYTES2 */

LOFT_BEGIN_C

#define LOFT_POINTS_MAX 32768u     /* the largest room reported: the limit of a frame's number */

/* The number of points that a cell holds at least. */
#define LOFT_POINTS_PER_CELL (sizeof(loft_item) / LOFT_POINT_BYTES2)

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    int16_t last[LOFT_AXES];            /* producer: the step of the last appended point */
    uint8_t used, count;                /* producer: bytes and points in the cell being filled */
    int16_t step[LOFT_AXES];            /* consumer: the step of the last taken point */
    uint8_t at, taken;                  /* consumer: bytes and points taken from the oldest cell */
    uint8_t looked;                     /* consumer: points looked at in the cell `seen` */
} loft_points;

/* Begin with an empty queue, at rest. Neither side may be active. */
void loft_points_init(loft_points *p);

/* The number of points that a queue of so many cells holds at least. */
uint16_t loft_points_capacity(uint16_t cells);


// Producer
// --------

/* Append the point `step` steps after the one before; LOFT_ERR_SPACE if there is no room.
 *
 *   range   any steps
 *   cost    that of loft_point_encode */
enum loft_status loft_points_push(loft_points *p, loft_queue *q,
                                  const int16_t step[LOFT_AXES]) LOFT_CHECKED;

/* The number of points that can be appended now, whatever they are. Each point lowers it by at most
 * one. */
uint16_t loft_points_room(const loft_points *p, loft_queue *q);


// Consumer
// --------

/* Look at new points: gives the number of points that were not looked at before, or 0. Call it
 * until it gives 0. */
uint8_t loft_points_look(loft_points *p, loft_queue *q);

/* Take the oldest point: p->step is its step. Returns false if no point that was looked at is left.
 *
 *   cost    that of loft_point_decode */
bool loft_points_poll(loft_points *p, loft_queue *q);

LOFT_END_C

#endif

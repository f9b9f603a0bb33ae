/* lib/machine/points.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/points.h"

/* A cell's `tag` is the number of points in it, plus this flag once no more will follow: */
#define CLOSED 0x80u

/* The next point takes 1..LOFT_POINT_BYTES2 bytes, because steps and their changes are known modulo
 * 2^16. A cell is closed when a point does not fit. It then has less than that left, so its room
 * was already 0. So the room falls by at most one per point, and what the host was told stays
 * true. */
#define SIZE sizeof(loft_item)

static volatile uint8_t *bytes_of(const loft_queue *q, uint16_t cell)
{
    return (volatile uint8_t *)&q->cell[cell].item;
}

static uint16_t next_cell(const loft_queue *q, uint16_t index)
{
    return (uint16_t)(index + 1 == q->count ? 0 : index + 1);
}

static int16_t signed_step(uint16_t x) { return (int16_t)(x < 0x8000u ? x : (int32_t)x - 0x10000); }

static int16_t step_difference(int16_t a, int16_t b)
{
    return signed_step((uint16_t)((uint16_t)a - (uint16_t)b));
}

void loft_points_init(loft_points *p) { *p = (loft_points){ .used = 0 }; }

uint16_t loft_points_capacity(uint16_t cells)
{
    const uint32_t points = cells * (uint32_t)LOFT_POINTS_PER_CELL;
    return (uint16_t)(points < LOFT_POINTS_MAX ? points : LOFT_POINTS_MAX);
}


// Producer
// --------

static void close_cell(loft_points *p, loft_queue *q)
{
    q->cell[q->head].tag = (uint8_t)(p->count | CLOSED);
    q->head = next_cell(q, q->head);
    q->room--;
    p->used = p->count = 0;
}

enum loft_status loft_points_push(loft_points *p, loft_queue *q, const int16_t step[LOFT_AXES])
{
    uint8_t byte[LOFT_POINT_BYTES];
    uint32_t change[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        change[i] = (uint32_t)step_difference(step[i], p->last[i]);
    const uint8_t size = loft_point_encode(byte, change);

    if (p->count > 0 && p->used + (unsigned)size > SIZE)
        close_cell(p, q);
    if (p->count == 0 && loft_queue_room(q) == 0)
        return LOFT_ERR_SPACE;
    for (uint8_t k = 0; k < size; k++)
        bytes_of(q, q->head)[p->used + k] = byte[k];
    for (int i = 0; i < LOFT_AXES; i++)
        p->last[i] = step[i];
    p->used  = (uint8_t)(p->used + size);
    p->count = (uint8_t)(p->count + 1);
    q->cell[q->head].tag = p->count;
    return LOFT_OK;
}

uint16_t loft_points_room(const loft_points *p, loft_queue *q)
{
    const uint16_t cells = loft_queue_room(q);

    return p->count == 0 ? loft_points_capacity(cells)
                         : (uint16_t)(loft_points_capacity((uint16_t)(cells - 1)) +
                                      (SIZE - p->used) / LOFT_POINT_BYTES2);
}


// Consumer
// --------

/* `seen` is `tail`, with `looked` 0, if no cell has been looked at or all have. */

/* Give back the oldest cell if all its points are taken. */
static void give_back_cell(loft_points *p, loft_queue *q)
{
    if (p->taken == 0 || q->cell[q->tail].tag != (CLOSED | p->taken))
        return;
    q->cell[q->tail].tag = 0;
    if (q->seen == q->tail && p->looked > 0) {
        q->seen = next_cell(q, q->seen);
        p->looked = 0;
    }
    q->tail = next_cell(q, q->tail);
    q->looked--;
    p->at = p->taken = 0;
}

uint8_t loft_points_look(loft_points *p, loft_queue *q)
{
    give_back_cell(p, q);
    if (p->looked > 0 && q->cell[q->seen].tag == (CLOSED | p->looked)) {
        q->seen = next_cell(q, q->seen);
        p->looked = 0;
    }
    if (p->looked == 0 && loft_queue_full(q))
        return 0;
    const uint8_t count = q->cell[q->seen].tag & (uint8_t)~CLOSED,
                  more = (uint8_t)(count - p->looked);
    if (p->looked == 0 && count > 0)
        q->looked++;
    p->looked = count;
    return more;
}

bool loft_points_poll(loft_points *p, loft_queue *q)
{
    const uint8_t count = q->tail == q->seen && p->looked > 0
                              ? p->looked
                              : q->cell[q->tail].tag & (uint8_t)~CLOSED;
    const volatile uint8_t *from = bytes_of(q, q->tail) + p->at;
    uint8_t byte[LOFT_POINT_BYTES2];
    uint32_t change[LOFT_AXES];

    if (q->looked == 0 || p->taken == count)
        return false;
    for (uint8_t k = 0; k < LOFT_POINT_BYTES2 && p->at + k < SIZE; k++)
        byte[k] = from[k];
    const uint8_t size = (uint8_t)(loft_point_decode(byte, change) - byte);
    for (int i = 0; i < LOFT_AXES; i++)
        p->step[i] = signed_step((uint16_t)((uint16_t)p->step[i] + (change[i] & 0xFFFFu)));
    p->at    = (uint8_t)(p->at + size);
    p->taken = (uint8_t)(p->taken + 1);
    give_back_cell(p, q);
    return true;
}

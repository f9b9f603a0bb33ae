/* lib/machine/queue.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/queue.h"

void loft_place_copy(volatile int32_t *to, const volatile int32_t *from)
{
    for (int i = 0; i < LOFT_AXES; i++)
        to[i] = from[i];
}

/* The cells are volatile, so the compiler keeps their accesses in order. The item is written before
 * the byte that hands the cell over, and read before the byte that gives the cell back. A part with
 * one core keeps the order too. */
enum loft_status loft_queue_init(loft_queue *q, volatile loft_cell *cell, uint16_t count)
{
    if (count < 2 || count > LOFT_QUEUE_MAX)
        return LOFT_ERR_RANGE;

    q->cell = cell;
    q->count = q->room = count;
    q->head = q->freed = 0;
    q->tail = q->seen = q->looked = 0;
    for (uint16_t i = 0; i < count; i++)
        cell[i].tag = 0;
    return LOFT_OK;
}

static uint16_t next_cell(const loft_queue *q, uint16_t index)
{
    return (uint16_t)(index + 1 == q->count ? 0 : index + 1);
}

uint16_t loft_queue_room(loft_queue *q)
{
    while (q->room < q->count && !q->cell[q->freed].tag) {
        q->freed = next_cell(q, q->freed);
        q->room++;
    }
    return q->room;
}

/* C++ does not assign volatile structures: bytes, which are volatile too. */
static void put_item(volatile loft_item *to, const loft_item *item)
{
#ifdef __cplusplus
    for (size_t i = 0; i < sizeof *item; i++)
        ((volatile uint8_t *)to)[i] = ((const uint8_t *)item)[i];
#else
    *to = *item;
#endif
}

enum loft_status loft_queue_push(loft_queue *q, const loft_item *item, uint8_t tag)
{
    if (loft_queue_room(q) == 0)
        return LOFT_ERR_SPACE;
    put_item(&q->cell[q->head].item, item);
    q->cell[q->head].tag = tag;
    q->head = next_cell(q, q->head);
    q->room--;
    return LOFT_OK;
}

const volatile loft_item *loft_queue_last(const loft_queue *q)
{
    return &q->cell[q->head ? q->head - 1 : q->count - 1].item;
}

const volatile loft_item *loft_queue_peek(const loft_queue *q, uint16_t index)
{
    uint16_t once, tail = q->tail;

    do {                                /* two equal reads are not torn */
        once = tail;
        tail = q->tail;
    } while (once != tail);
    if (index >= q->count)
        return NULL;
    const uint32_t at = (uint32_t)tail + index;
    const volatile loft_cell *cell = &q->cell[at < q->count ? at : at - q->count];
    return cell->tag ? &cell->item : NULL;
}

uint16_t loft_queue_look(loft_queue *q)
{
    if (loft_queue_full(q) || !q->cell[q->seen].tag)
        return 0;
    const uint16_t ticks = loft_item_lasts(&q->cell[q->seen].item);
    q->seen = next_cell(q, q->seen);
    q->looked++;
    return ticks;
}

const volatile loft_cell *loft_queue_cell(const loft_queue *q, uint16_t index)
{
    if (index >= q->looked)
        return NULL;
    const uint32_t at = (uint32_t)q->tail + index;
    return &q->cell[at < q->count ? at : at - q->count];
}

bool loft_queue_poll(loft_queue *q)
{
    if (q->looked == 0)
        return false;
    q->cell[q->tail].tag = 0;
    q->tail = next_cell(q, q->tail);
    q->looked--;
    return true;
}

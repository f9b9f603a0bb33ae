/* tests/lib/machine/test_queue.c -- properties of lib/machine/queue.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include "machine/queue.h"

#define CELLS 40

static volatile loft_cell cells[CELLS + 1];

static loft_item numbered(uint32_t number)
{
    loft_item item = { { { 0 } }, (uint16_t)(1 + number % LOFT_SPAN_TICKS_MAX) };
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            item.p[k][i] = (int32_t)(number * 2654435761u + (uint32_t)(k * LOFT_AXES + i));
    return item;
}

static uint8_t cap_of(uint32_t number)      { return (uint8_t)(1 + number % 255); }

static bool same(const loft_item *a, const loft_item *b)
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (a->p[k][i] != b->p[k][i])
                return false;
    return a->ticks == b->ticks;
}

/* Any order of pushes, looks and polls: items come out as they went in, none is lost, and the room
 * is exact. */
static void items_come_out_in_order_and_unchanged(arb *a)
{
    const uint16_t count = (uint16_t)(2 + arb_below(a, CELLS - 1));
    const uint32_t eager = arb_below(a, 10);            /* from a starved to a full queue */
    uint32_t pushed = 0, looked = 0, polled = 0;
    loft_queue q;
    loft_item item;

    cells[count].tag = 77;
    CHECK(loft_queue_init(&q, cells, count) == LOFT_OK);
    for (int turn = 0; turn < 1000; turn++) {
        if (arb_below(a, 10) < eager) {
            item = numbered(pushed);
            CHECK(loft_queue_push(&q, &item, cap_of(pushed)) ==
                  (pushed - polled < count ? LOFT_OK : LOFT_ERR_SPACE));
            pushed += pushed - polled < count;
        }
        if (arb_below(a, 2)) {
            item = numbered(looked);
            CHECK(loft_queue_look(&q) == (looked < pushed ? item.ticks : 0));
            looked += looked < pushed;
        }
        if (arb_below(a, 2)) {
            const loft_item want = numbered(polled);
            const volatile loft_item *first = loft_queue_first(&q);
            CHECK((first != NULL) == (polled < looked));
            if (polled < looked) {
                item = *first;
                CHECK(same(&item, &want));
                CHECK(loft_queue_cell(&q, 0)->tag == cap_of(polled) &&
                      loft_queue_cell(&q, (uint16_t)(looked - polled - 1))->tag ==
                          cap_of(looked - 1));
            }
            CHECK(loft_queue_cell(&q, (uint16_t)(looked - polled)) == NULL);
            CHECK(loft_queue_poll(&q) == (polled < looked));
            polled += polled < looked;
        }
        if (arb_below(a, 3) == 0) {
            const loft_item want = numbered(polled);
            const volatile loft_item *oldest = loft_queue_peek(&q, 0);
            CHECK((oldest != NULL) == (polled < pushed));
            if (oldest != NULL)
                item = *oldest;
            CHECK(polled == pushed || same(&item, &want));
            const uint16_t k = (uint16_t)arb_below(a, CELLS + 2u);
            const loft_item later = numbered(polled + k);
            oldest = loft_queue_peek(&q, k);
            CHECK((oldest != NULL) == (k < pushed - polled));
            if (oldest != NULL)
                item = *oldest;
            CHECK(oldest == NULL || same(&item, &later));
        }
        if (arb_below(a, 3) == 0)
            CHECK(loft_queue_room(&q) == count - (pushed - polled));
        CHECK(loft_queue_full(&q) == (looked - polled == count));
    }
    CHECK(cells[count].tag == 77);
}

static void init_refuses_a_queue_that_cannot_work(arb *a)
{
    loft_queue q;
    (void)a;
    CHECK(loft_queue_init(&q, cells, 0) == LOFT_ERR_RANGE);
    CHECK(loft_queue_init(&q, cells, 1) == LOFT_ERR_RANGE);
    CHECK(loft_queue_init(&q, cells, 2) == LOFT_OK);
    CHECK(loft_queue_room(&q) == 2 && loft_queue_look(&q) == 0 && !loft_queue_full(&q));
}

int main(void)
{
    PROPERTY(items_come_out_in_order_and_unchanged, 300);
    PROPERTY(init_refuses_a_queue_that_cannot_work,   1);
    return check_failures();
}

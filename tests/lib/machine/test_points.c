/* tests/lib/machine/test_points.c -- properties of lib/machine/points.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include "machine/points.h"

#define CELLS 40
#define MOST  20000

static volatile loft_cell cells[CELLS + 1];
static loft_queue  queue;
static loft_points points;
static int16_t     steps[MOST][LOFT_AXES];

/* A walk that is even for a while and then wild: the changes of its steps take one byte, or all. */
static void arb_step(arb *a, uint32_t n, uint32_t wild)
{
    for (int i = 0; i < LOFT_AXES; i++)
        steps[n][i] = arb_below(a, 100) < wild
                          ? arb_below(a, 9) ? (int16_t)arb_raw(a, arb_below(a, 2) ? 200 : 32767)
                                            : INT16_MIN
                          : (int16_t)((n ? steps[n - 1][i] / 2 : 0) + (int)arb_below(a, 3) - 1);
}

static void start(uint16_t count)
{
    cells[count].tag = 77;
    CHECK(loft_queue_init(&queue, cells, count) == LOFT_OK);
    loft_points_init(&points);
}

typedef struct {
    uint32_t pushed, looked, polled, limit;
} counts;

/* Room is a promise: what it allowed stays allowed, and as many points are taken. */
static void push_point(counts *n)
{
    const uint16_t room = loft_points_room(&points, &queue);
    const enum loft_status status = loft_points_push(&points, &queue, steps[n->pushed]);

    CHECK(status == LOFT_OK || (status == LOFT_ERR_SPACE && room == 0));
    n->pushed += status == LOFT_OK;
}

static void poll_point(counts *n)
{
    const bool there = n->polled < n->looked;

    CHECK(loft_points_poll(&points, &queue) == there);
    for (int i = 0; i < LOFT_AXES && there; i++)
        CHECK(points.step[i] == steps[n->polled][i]);
    n->polled += there;
}

/* Any order of pushes, looks and polls, from a starved to a full queue. */
static void points_come_out_in_order_and_unchanged(arb *a)
{
    const uint16_t count = (uint16_t)(2 + arb_below(a, CELLS - 1));
    const uint32_t eager = 1 + arb_below(a, 30), wild = arb_below(a, 3) ? arb_below(a, 20) : 100;
    counts n = { 0 };

    start(count);
    for (uint32_t k = 0; k < MOST; k++)
        arb_step(a, k, wild);
    CHECK(loft_points_room(&points, &queue) == loft_points_capacity(count));
    for (int turn = 0; turn < 10000 && n.pushed < MOST - 40; turn++) {
        for (uint32_t k = arb_below(a, 40); k > 0 && arb_below(a, 30) < eager; k--)
            push_point(&n);
        if (arb_below(a, 2))
            for (uint8_t more; (more = loft_points_look(&points, &queue)) > 0; n.looked += more) {
            }
        CHECK(n.looked <= n.pushed);
        for (uint32_t k = arb_below(a, 20); k > 0; k--)
            poll_point(&n);
        const uint32_t limit = n.pushed + loft_points_room(&points, &queue);
        CHECK(limit >= n.limit && loft_points_room(&points, &queue) <= loft_points_capacity(count));
        n.limit = limit;
    }
    for (uint32_t k = 0; k < 2 * MOST && n.polled < n.pushed; k++) {
        n.looked += loft_points_look(&points, &queue);
        poll_point(&n);
    }
    CHECK(n.polled == n.pushed && cells[count].tag == 77);
}

/* Motion at even speeds: three axes in a byte, until the last cell is full. */
static void an_even_motion_takes_a_byte_a_point(arb *a)
{
    const uint16_t count = (uint16_t)(2 + arb_below(a, CELLS - 1));
    uint32_t n = 0;
    int16_t step[LOFT_AXES] = { 0 };

    start(count);
    while (loft_points_push(&points, &queue, step) == LOFT_OK) {
        for (int i = 0; i < LOFT_AXES; i++)
            step[i] = (int16_t)(step[i] + (int)arb_below(a, 5) - 2);
        n++;
    }
    CHECK(n == count * (uint32_t)(sizeof(loft_item) / LOFT_POINT_GROUPS));
    CHECK(loft_points_room(&points, &queue) == 0);
}

int main(void)
{
    EXTREMES(loft_points_push, points_come_out_in_order_and_unchanged, 100);
    PROPERTY(an_even_motion_takes_a_byte_a_point,     20);
    return check_failures();
}

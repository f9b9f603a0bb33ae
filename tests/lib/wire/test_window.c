/* tests/lib/wire/test_window.c -- properties of lib/wire/window.h: what is on its way, and again
 * SPDX-License-Identifier: MIT
 */
#include "support/line.h"           /* job_item */

#include "wire/window.h"

enum { COUNT = 400 };

static void source(void *context, uint32_t index, loft_item *out)
{
    const loft_window *w = context;
    CHECK(index < w->known);
    job_item(7, (enum loft_kind)w->kind, index, out);
}

static void begin(loft_window *w, arb *a)
{
    static const enum loft_kind kind[3] = { LOFT_SPANS, LOFT_POINTS, LOFT_CURVES };
    const loft_job job = { .kind = kind[arb_below(a, 3)] };

    loft_window_init(w, &job, arb_below(a, 2) ? COUNT : LOFT_ITEMS_OPEN, source, w);
    loft_window_open(w, 0, LOFT_FRAME_MAX);
}

/* More items of a job in the making are known, or all. */
static void extend(loft_window *w, uint32_t by)
{
    const uint32_t known = w->known + by < COUNT ? w->known + by : COUNT;

    if (w->count == LOFT_ITEMS_OPEN)
        loft_window_extend(w, known, known == COUNT ? COUNT : LOFT_ITEMS_OPEN);
}

/* Does the frame begin with item `first`, sealed by all items before it? */
static bool begins_at(const loft_window *w, uint32_t first, const uint8_t wire[], size_t n)
{
    loft_predictor p;
    loft_item item;
    loft_frame f;
    enum loft_status ended = LOFT_MORE;
    uint16_t number = 0;

    loft_predictor_init(&p, w->start);
    for (uint32_t i = 0; i < first; i++) {
        source(w->context, i, &item);
        loft_predictor_next(&p, (enum loft_kind)w->kind, &item);
    }
    loft_frame_init(&f);
    for (size_t i = 0; i < n; i++)
        ended = loft_frame_push(&f, wire[i]);
    return ended != LOFT_MORE && f.count > 0 && loft_frame_sealed(&f, loft_predictor_seal(&p)) &&
           loft_data_carried(&f) && loft_data_first(&f, &number) == LOFT_OK && number == first;
}

/* Frames arrive, are lost or are requested again. Each frame begins where the last one ended or,
 * after going back, at base. None exceeds the limit or the window, and acknowledged items are not
 * sent again. */
static void frames_follow_each_other(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    uint32_t now = 0, trip = 0, next = 0;
    loft_window w;

    begin(&w, a);
    while (w.base < COUNT && now < 100000 && !check_bad) {
        const uint32_t limit = w.base + 40;
        now += 1 + arb_below(a, 9);
        if (arb_below(a, 2))
            extend(&w, arb_below(a, 30));
        CHECK(w.count == COUNT || (w.count == LOFT_ITEMS_OPEN && w.known < COUNT));
        while (loft_window_ready(&w, limit, 1)) {
            const size_t n = loft_window_give(&w, limit, 3, now, wire);
            CHECK(n > 0 && n <= w.frame_size && begins_at(&w, next, wire, n));
            next = w.send;
            CHECK(w.flights <= LOFT_WINDOW_FRAMES && next <= limit && next <= w.high &&
                  w.high <= COUNT);
        }
        switch (arb_below(a, 4)) {
        case 0:
            loft_window_shrink(&w);
            loft_window_back(&w);
            next = w.base;
            CHECK(w.flights == 0);
            break;
        case 1: break;
        default:
            if (w.high > w.base) {
                const uint32_t reached = w.base + 1 + arb_below(a, w.high - w.base);
                if (loft_window_take(&w, reached, now, &trip))
                    CHECK(trip <= now);
                CHECK(w.base == reached);
                next = w.send;
            }
        }
        CHECK(w.base <= w.send && w.send <= w.high);
    }
    CHECK(w.base == COUNT && !loft_window_ready(&w, UINT32_MAX, 1));
}

/* A frame made again from the same item is the same, byte for byte, even from a sender that has not
 * made it before. */
static void frames_are_made_again_byte_for_byte(arb *a)
{
    uint8_t wire[2][LOFT_FRAME_MAX];
    uint32_t trip;
    loft_window w, other;

    begin(&w, a);
    extend(&w, COUNT);
    for (uint32_t n = arb_below(a, 6); n > 0; n--)
        loft_window_give(&w, COUNT, 3, 0, wire[0]);
    loft_window_take(&w, w.send, 0, &trip);
    const uint32_t at = w.base;
    w.frame_size = w.frame_most;
    const size_t n = loft_window_give(&w, COUNT, 3, 0, wire[0]);

    loft_window_back(&w);
    CHECK(loft_window_give(&w, COUNT, 3, 9, wire[1]) == n && memcmp(wire[0], wire[1], n) == 0);
    other = w;
    loft_window_open(&other, at, LOFT_FRAME_MAX);
    CHECK(loft_window_give(&other, COUNT, 3, 5, wire[1]) == n && memcmp(wire[0], wire[1], n) == 0);
}

/* The answer to a frame that was sent twice may belong to either: it measures nothing. */
static void what_was_sent_twice_measures_nothing(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const uint32_t before = arb_below(a, 1000), time = 1 + arb_below(a, 1000);
    uint32_t trip = 0;
    loft_window w;

    begin(&w, a);
    extend(&w, COUNT);
    loft_window_give(&w, COUNT, 3, before, wire);
    const uint32_t end = w.send;
    if (arb_below(a, 2)) {
        CHECK(loft_window_take(&w, end, before + time, &trip) && trip == time);
        return;
    }
    loft_window_back(&w);
    loft_window_give(&w, end, 3, before + 1, wire);
    CHECK(!loft_window_take(&w, end, before + time, &trip) && w.flights == 0);
}

/* New items wait for `step` of room, unless they are the last. Repeated items do not wait. */
static void little_room_is_waited_for(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const uint32_t step = 2 + arb_below(a, 10);
    loft_window w;

    begin(&w, a);
    extend(&w, COUNT);
    CHECK(!loft_window_ready(&w, 0, step) && !loft_window_ready(&w, step - 1, step) &&
          loft_window_ready(&w, step, step));
    loft_window_give(&w, 1, 3, 0, wire);
    CHECK(w.send == 1 && !loft_window_ready(&w, 1, step) && !loft_window_ready(&w, step, step));
    loft_window_back(&w);
    CHECK(loft_window_ready(&w, 1, step));
    loft_window_open(&w, COUNT - 1, LOFT_FRAME_MAX);
    CHECK(loft_window_ready(&w, COUNT, step));
}

int main(void)
{
    PROPERTY(frames_follow_each_other, BY_NUM(100, 10, 10));
    PROPERTY(frames_are_made_again_byte_for_byte, 50);
    PROPERTY(what_was_sent_twice_measures_nothing, 50);
    PROPERTY(little_room_is_waited_for, 50);
    return check_failures();
}

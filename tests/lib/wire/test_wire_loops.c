/* tests/lib/wire/test_wire_loops.c -- the loop that receiver.h prints, word for word, beside a
 * sender on a line that gives any number of bytes at a time
 * SPDX-License-Identifier: MIT
 *
 * tests/house/loops.py compares it with the header.
 */
#include "support/line.h"               /* world, mill: the smallest machine; CHECK */

enum { ROOM = 4096 };

typedef struct {
    uint8_t byte[ROOM];
    size_t in, out;
} pipe;

static world w;
static pipe down, up;
static arb *draws;

static void put(pipe *p, const uint8_t wire[], size_t size)
{
    for (size_t i = 0; i < size; i++)
        p->byte[p->in++ % ROOM] = wire[i];
    CHECK(p->in - p->out <= ROOM);
}

static bool port_read(uint8_t *byte)
{
    const bool any = down.out < down.in && arb_below(draws, 50) > 0;

    if (any)
        *byte = down.byte[down.out++ % ROOM];
    return any;
}

static bool port_takes_a_frame(void) { return arb_below(draws, 3) > 0; }

static void port_write(const uint8_t wire[], size_t size) { put(&up, wire, size); }

static loft_snapshot where_i_stand(void)
{
    w.m.now.room = (uint16_t)(w.m.info.queue - w.m.queued);
    return w.m.now;
}

static void act(enum loft_event e, const loft_event_data *what) { mill_act(&w.m, e, what, w.now); }

static void serve(void)
{
    uint8_t byte, wire[LOFT_FRAME_MAX];
    loft_event_data what;

#define r w.m.r
    while (port_read(&byte))
        if (loft_receiver_push(&r, byte)) {
            loft_snapshot now = where_i_stand();
            enum loft_event e;
            while ((e = loft_receiver_next(&r, &now, &what)) != LOFT_EVENT_NONE)
                act(e, &what);
        }
    if (port_takes_a_frame()) {
        loft_snapshot now = where_i_stand();
        port_write(wire, loft_receiver_poll(&r, &now, wire));
    }
#undef r
}

static void each_item_arrives_once(arb *a)
{
    uint8_t frame[LOFT_FRAME_MAX];
    bool begun = false;

    draws = a;
    world_init(&w, a, (uint16_t)(16 + arb_below(a, 64)), 1, 1 + arb_below(a, 300));
    down = up = (pipe) { .in = 0 };
    for (uint32_t ms = 0; ms < 200000 && w.s.phase != LOFT_PHASE_DONE; ms++, w.now++) {
        if (down.in == down.out)
            put(&down, frame, loft_sender_poll(&w.s, w.now, frame));
        serve();
        while (up.out < up.in)
            loft_sender_push(&w.s, up.byte[up.out++ % ROOM], w.now);
        if (w.s.phase == LOFT_PHASE_READY && !begun) {
            CHECK(loft_sender_begin(&w.s, &w.job, w.count, world_source, &w) == LOFT_OK);
            begun = true;
        }
        mill_run(&w.m, w.now);
    }
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count && w.m.ends == 1);
}

int main(void)
{
    PROPERTY(each_item_arrives_once, 30);
    return check_failures();
}

/* tests/lib/wire/test_sender.c -- properties of lib/wire/sender.h: when it sends what
 * SPDX-License-Identifier: MIT
 */
#include "support/line.h"           /* world: a sender, a line, a receiver */

static enum loft_message type_of(const uint8_t wire[], size_t n)
{
    loft_frame f;
    loft_frame_init(&f);
    for (size_t i = 0; i < n; i++)
        if (loft_frame_push(&f, wire[i]) == LOFT_OK)
            return loft_message_type(&f);
    CHECK(false);
    return LOFT_POLL;
}

static size_t poll(loft_sender *s, uint32_t now, uint8_t wire[])
{
    const size_t n = loft_sender_poll(s, now, wire);
    CHECK(n <= LOFT_FRAME_MAX);
    return n;
}

/* The next frame of this type, and its time in ms, counted from *now. Other frames are dropped. */
static uint32_t next_of(loft_sender *s, uint32_t *now, enum loft_message type)
{
    uint8_t wire[LOFT_FRAME_MAX];
    for (uint32_t ms = 0; ms < 5000; ms++, (*now)++)
        for (size_t n; (n = poll(s, *now, wire)) > 0; )
            if (type_of(wire, n) == type)
                return ms;
    CHECK(false);
    return 0;
}

static void tell(loft_sender *s, const uint8_t wire[], size_t n, uint32_t now)
{
    for (size_t i = 0; i < n; i++)
        loft_sender_push(s, wire[i], now);
}


// Greeting
// --------

/* At once, then after 200, 400, 800, 1000, 1000 .. ms, always with the same nonce. */
static void hello_is_repeated_ever_less_often(arb *a)
{
    static const uint32_t wait[7] = { 0, 200, 400, 800, 1000, 1000, 1000 };
    uint32_t now = (uint32_t)arb_next(a);
    loft_sender s;

    loft_sender_init(&s, 1, now);
    const uint32_t nonce = s.nonce;
    for (int i = 0; i < 7; i++) {
        CHECK(loft_sender_wait(&s, now) == wait[i]);
        CHECK(next_of(&s, &now, LOFT_HELLO) == wait[i]);
    }
    CHECK(s.hellos == 7 && s.nonce == nonce &&
          loft_sender_silence(&s, now) == 200 + 400 + 800 + 3000);
}

/* Only one AXIS arrives for each HELLO. What has arrived is kept, unless the machine restarts in
 * between. */
static void a_greeting_is_put_together(arb *a)
{
    static world w;
    uint8_t wire[LOFT_FRAME_MAX];
    loft_welcome m = { 0 };
    loft_axis axis = { 0 };
    const bool restart = arb_below(a, 2);

    world_init(&w, a, 64, 0, 10);
    m.version = LOFT_WIRE_VERSION, m.nonce = w.s.nonce, m.boot = 5, m.axes = LOFT_AXES;
    m.frame_max = LOFT_FRAME_MAX, m.queue = 10, m.tick_hz = 10, m.slots = 10;

    tell(&w.s, wire, loft_axis_encode(&axis, 9, wire), w.now);
    CHECK(w.s.unknown == 1);                                        /* nobody's session yet */
    for (int round = 0; round < LOFT_AXES + (restart ? LOFT_AXES - 1 : 0); round++) {
        CHECK(w.s.phase == LOFT_PHASE_HELLO);
        if (restart && round == LOFT_AXES - 1)
            m.boot++;
        axis.number = (uint8_t)((round + 1) % LOFT_AXES);
        axis.steps_per_mm = 1000 + round;
        tell(&w.s, wire, loft_welcome_encode(&m, 9, wire), w.now);
        tell(&w.s, wire, loft_axis_encode(&axis, 9, wire), w.now);
    }
    CHECK(w.s.phase == LOFT_PHASE_READY && w.s.axis[axis.number].steps_per_mm == axis.steps_per_mm);

    m.nonce++;                                                      /* somebody else's */
    m.boot = 77;
    tell(&w.s, wire, loft_welcome_encode(&m, 10, wire), w.now);
    CHECK(w.s.machine.boot != 77 && w.s.session == 9);
}

static void frames_of_another_session_are_counted_and_forgotten(arb *a)
{
    static world w;
    uint8_t wire[LOFT_FRAME_MAX];
    loft_ack ack = { 0 };

    world_init(&w, a, 16, 2, 200);
    while (w.m.delivered < 20 && !check_bad)
        world_step(&w);
    loft_sender_push(&w.s, 0, w.now);
    const uint32_t unknown = w.s.unknown, next = w.s.ack.next;
    ack.next = ack.limit = ack.executed = w.s.window.high;
    tell(&w.s, wire, loft_ack_encode(&ack, (uint8_t)(w.s.session + 1), wire), w.now + 50);
    CHECK(w.s.unknown == unknown + 1 && w.s.ack.next == next &&
          loft_sender_silence(&w.s, w.now + 50) >= 50);

    const size_t n = loft_ack_encode(&ack, w.s.session, wire);      /* of another version */
    loft_frame f;
    loft_frame_init(&f);
    for (size_t i = 0; i < n; i++)
        if (loft_frame_push(&f, wire[i]) == LOFT_OK)
            memcpy(wire + 1, f.byte, f.count);
    wire[1] ^= 2;
    tell(&w.s, wire, loft_frame_encode(wire, f.count), w.now);
    CHECK(w.s.unknown == unknown + 2 && w.s.ack.next == next);
}

/* An outdated answer, or one about items that do not exist, changes nothing. */
static void stale_answers_are_forgotten(arb *a)
{
    static world w;
    uint8_t wire[LOFT_FRAME_MAX];
    world_init(&w, a, 64, 2, 200);
    while (w.s.window.base < 50 && !check_bad)
        world_step(&w);
    loft_sender_push(&w.s, 0, w.now);

    const loft_ack before = w.s.ack;
    loft_ack m = before;
    m.limit = 199, m.state = LOFT_STATE_HELD;
    m.next = m.executed = arb_below(a, 2) ? w.s.window.base - 1 : 201;
    m.limit = m.next + 60;
    tell(&w.s, wire, loft_ack_encode(&m, w.s.session, wire), w.now);
    CHECK(memcmp(&w.s.ack, &before, sizeof before) == 0);

    m = before;                                         /* a limit of before: what was promised
                                                         * stays promised */
    m.limit = m.next;
    const size_t n = loft_ack_encode(&m, w.s.session, wire);
    for (size_t i = 0; i < n; i++)
        CHECK(loft_sender_push(&w.s, wire[i], w.now) == (i + 1 == n));
    CHECK(w.s.ack.limit == before.limit && w.s.ack.next == before.next);
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count);
}

/* With enough room eight frames are in flight, not nine. */
static void the_window_is_used_and_kept(arb *a)
{
    static world w;
    uint8_t most = 0;
    world_init(&w, a, 4096, 0, 3000);
    w.job.kind = LOFT_SPANS;
    w.delay = 150;
    while (w.s.phase < LOFT_PHASE_DONE && !check_bad) {
        world_step(&w);
        most = w.s.window.flights > most ? w.s.window.flights : most;
    }
    CHECK(most == LOFT_WINDOW_FRAMES && w.s.timeouts == 0);
}


// Time
// ----

/* After poll has given nothing, it gives nothing for loft_sender_wait ms, and then something. */
static void wait_tells_the_truth(arb *a)
{
    static world w;
    world_init(&w, a, (uint16_t)(1 + arb_below(a, 100)), arb_below(a, 20), arb_below(a, 300));
    w.rate  = 20;
    w.delay = arb_below(a, 30);
    w.faults.drop = arb_below(a, 2) ? 0 : arb_below(a, 20000);
    for (int k = 0; k < 300 && w.s.phase < LOFT_PHASE_DONE && !check_bad; k++) {
        uint8_t wire[LOFT_FRAME_MAX];
        for (uint32_t ms = 1 + arb_below(a, 30); ms > 0; ms--)
            world_step(&w);
        if (k == 20)
            loft_sender_control(&w.s, LOFT_HOLD);
        if (k == 40)
            loft_sender_control(&w.s, LOFT_RESUME);

        loft_sender s = w.s;                            /* a copy, which hears nothing from now
                                                         * on */
        uint32_t now = w.now;
        for (int frames = 0; frames < 20 && poll(&s, now, wire) > 0; frames++) {
        }
        for (int round = 0; round < 4 && s.phase < LOFT_PHASE_DONE; round++) {
            const uint32_t wait = loft_sender_wait(&s, now);
            CHECK(wait > 0 && wait <= 1000);
            for (uint32_t ms = 1; ms < wait; ms++)
                CHECK(poll(&s, now + ms, wire) == 0);
            now += wait;
            if (s.phase == LOFT_PHASE_CLOSING && s.attempts >= 4)
                break;                                  /* gives up instead */
            CHECK(loft_sender_wait(&s, now) == 0);
            int frames = 0;
            while (frames < 20 && poll(&s, now, wire) > 0)
                frames++;
            CHECK(frames > 0 && frames < 20);
        }
    }
}

/* The round trip is that of the line: delays, the bytes of one frame and of its answer, and the
 * steps of the simulated world. */
static void the_round_trip_is_measured(arb *a)
{
    static world w;
    world_init(&w, a, 64, 0, 600);
    w.job.kind = LOFT_SPANS;
    w.rate  = 11;
    w.delay = 1 + arb_below(a, 60);
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_DONE);
    CHECK(w.s.rtt_ms >= 2 * w.delay + 5 &&
          w.s.rtt_ms <= 2 * w.delay + (LOFT_FRAME_MAX + 24 + 56) / 11 + 6);
    CHECK(w.s.timeouts == 0 && w.s.naks == 0);
    CHECK(w.s.rto.ms >= 2 * w.s.rtt_ms && w.s.rto.ms <= 4 * w.s.rtt_ms + 25);
}

/* The line dies in mid-job: the sender asks after rto, twice, four times that .., and sends nothing
 * else. It sends HELLO after 1.5 s without an answer. */
static void a_dead_line_is_tried_ever_less_often(arb *a)
{
    static world w;
    world_init(&w, a, 256, 0, 4000);
    w.job.kind = LOFT_SPANS;
    while (w.m.delivered < 500 && !check_bad)
        world_step(&w);
    uint32_t now = w.now, rto = w.s.rto.ms, timeouts = 0;
    uint8_t wire[LOFT_FRAME_MAX];

    while (poll(&w.s, now, wire) > 0) {
    }
    CHECK(w.s.window.base < w.s.window.send);
    const uint32_t sent = w.s.sent, resent = w.s.resent, tried = w.s.tried;
    uint32_t last = tried, nonce = w.s.nonce;
    for (; w.s.phase == LOFT_PHASE_STREAMING && !check_bad; now++) {
        while (poll(&w.s, now, wire) > 0) {
        }
        if (w.s.timeouts > timeouts && w.s.phase == LOFT_PHASE_STREAMING) {
            CHECK(w.s.timeouts == timeouts + 1 && now - last == rto);
            rto = 2 * rto < 1000 ? 2 * rto : 1000;
            last = now;
            timeouts++;
        }
    }
    CHECK(timeouts >= 3 && w.s.resent == resent && w.s.sent == sent);
    CHECK(w.s.phase == LOFT_PHASE_HELLO && w.s.nonce != nonce && w.s.hellos == 2);
    CHECK(loft_sender_silence(&w.s, now) == 1);         /* counted anew */

    w.now = now;                                        /* the line is back: the same sender goes
                                                         * on */
    w.down.out = w.down.in;
    w.up.out = w.up.in;
    w.down.out_at = w.down.out_size = 0;
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.jobs == 1 && w.m.delivered == w.count);
    CHECK(!w.s.resumed && !w.s.collected);
}

/* With a buffer that accepts everything, answers are late for a while, because a program did not
 * run. That is not a loss, and nothing is sent twice: repetitions would delay the next answers
 * further, without end. */
static void what_is_answered_late_is_not_sent_again(arb *a)
{
    static world w;
    uint32_t naps = 0;
    world_init(&w, a, 64, 2, 3000);
    w.job.kind = LOFT_SPANS;
    w.buffered = true;
    w.rate = 11;
    while (w.s.phase < LOFT_PHASE_DONE && !check_bad) {
        if (arb_below(a, 150) == 0 && w.asleep + w.frozen == 0) {
            *(arb_below(a, 2) ? &w.asleep : &w.frozen) = 10 + arb_below(a, 250);
            naps++;
        }
        world_step(&w);
    }
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count);
    CHECK(naps > 0 && w.s.resent == 0 && w.s.naks == 0);
    if (check_bad)
        printf("%u naps, %u of %u frames resent, %u naks, %u timeouts, %u ms\n", naps, w.s.resent,
               w.s.sent, w.s.naks, w.s.timeouts, w.steps);
}

/* One frame is lost: one NAK, no timeout, nothing sent more than twice. */
static void one_lost_frame_costs_one_round_trip(arb *a)
{
    static world w;
    const uint32_t at = 100 + arb_below(a, 1300);
    uint32_t clean, lost;

    arb again = *a;
    world_init(&w, a, 1024, 0, 1500);
    w.job.kind = LOFT_SPANS;
    world_run(&w, 60000);
    clean = w.steps;

    world_init(&w, &again, 1024, 0, 1500);
    w.job.kind = LOFT_SPANS;
    while (w.m.delivered < at && !check_bad)
        world_step(&w);
    w.faults.drop = 1000000;
    world_step(&w);
    w.faults.drop = 0;
    world_run(&w, 60000);
    lost = w.steps;
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count);
    CHECK(at >= 1300 || (w.s.naks == 1 && w.s.timeouts == 0));
    CHECK(w.s.naks + w.s.timeouts <= 2 && w.s.resent <= LOFT_WINDOW_FRAMES);
    CHECK(lost <= clean + 150);
}

/* All answers are lost for a while. The next answer covers them, and nothing is sent again. */
static void answers_that_are_lost_cost_nothing(arb *a)
{
    static world w;
    world_init(&w, a, 64, 2, 1500);
    w.job.kind = LOFT_SPANS;
    while (w.s.phase < LOFT_PHASE_DONE && !check_bad) {
        if (w.s.phase == LOFT_PHASE_STREAMING && arb_below(a, 100) == 0)
            w.up.out = w.up.in;
        world_step(&w);
    }
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count && w.s.resent == 0);
}

/* The last frames are lost, and no later frame shows it. A question does, after a silence. */
static void what_is_lost_at_the_end_is_asked_for(arb *a)
{
    static world w;
    world_init(&w, a, 1024, 0, 200 + arb_below(a, 100));
    while (w.s.window.send < w.count && !check_bad)
        world_step(&w);
    while (w.down.out_at < w.down.out_size && !check_bad)
        world_step(&w);
    CHECK(w.s.window.base < w.count);
    const uint32_t begun = w.now, sent = w.s.sent;
    w.down.out = w.down.in;
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count && w.now - begun < 400);
    CHECK(w.s.resent > 0 && w.s.sent - sent == w.s.resent && w.s.resent <= LOFT_WINDOW_FRAMES);
}

/* Only END is lost. */
static void a_lost_end_is_said_again(arb *a)
{
    static world w;
    world_init(&w, a, 1024, 0, 100 + arb_below(a, 100));
    while (w.m.delivered < w.count && !check_bad)
        world_step(&w);
    const uint32_t begun = w.now;
    w.down.out = w.down.in;                             /* END was on its way */
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.ends == 1 && w.now - begun < 300);
}

/* Only JOB is lost, repeatedly. */
static void a_lost_job_is_said_again(arb *a)
{
    static world w;
    uint32_t wait[3];
    world_init(&w, a, 64, 0, 10);
    while (w.s.phase != LOFT_PHASE_OPENING && !check_bad)
        world_step(&w);
    uint32_t now = w.now;
    const uint32_t timeouts = w.s.timeouts;
    CHECK(w.s.job_sent);
    for (int i = 0; i < 3; i++, now++)
        wait[i] = next_of(&w.s, &now, LOFT_JOB);
    CHECK(wait[1] == 399 && wait[2] == 799 && w.s.timeouts == timeouts + 3);
}


// The end
// -------

/* The machine never confirms the close: the sender gives up after four attempts. */
static void closing_is_not_waited_for(arb *a)
{
    static world w;
    uint8_t wire[LOFT_FRAME_MAX];
    unsigned closes = 0;
    world_init(&w, a, 64, 0, 50);
    CHECK(world_until(&w, LOFT_PHASE_CLOSING, 60000));
    for (uint32_t now = w.now; w.s.phase == LOFT_PHASE_CLOSING && now - w.now < 10000; now++)
        for (size_t n; (n = poll(&w.s, now, wire)) > 0; )
            closes += type_of(wire, n) == LOFT_CONTROL;
    CHECK(closes + (w.s.attempts - closes) == 4 && closes >= 3 && w.s.phase == LOFT_PHASE_DONE);
}

static void broken_source(void *context, uint32_t index, loft_item *out)
{
    world_source(context, index, out);
    if (index == 60)
        out->ticks = ((world *)context)->job.kind == LOFT_CURVES ? 0 : LOFT_SPAN_TICKS_MAX + 1;
}

/* An item that no frame can hold ends the job, and the reason is reported. */
static void an_item_that_cannot_be_said_ends_the_job(arb *a)
{
    static world w;
    world_init(&w, a, 16, 1, 100);
    while (w.s.phase != LOFT_PHASE_STREAMING && !check_bad)
        world_step(&w);
    w.s.window.source = broken_source;
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_ABORTED && w.s.refusal == LOFT_REFUSAL_ITEM);
    CHECK(w.m.delivered == 60 && w.m.aborts == 1 && w.s.report.state == LOFT_STATE_ABORTED);
}

/* On a line where no long frame survives, short ones do. */
static void frames_shrink_on_a_bad_line_and_grow_again(arb *a)
{
    static world w;
    uint8_t least = 255;
    world_init(&w, a, 1024, 0, 3000);
    CHECK(world_until(&w, LOFT_PHASE_STREAMING, 60000));
    w.faults.flip = 25000;
    for (int ms = 0; ms < 20000 && w.m.delivered < 600 && !check_bad; ms++) {
        world_step(&w);
        if (w.s.window.frame_size < least)
            least = w.s.window.frame_size;
    }
    CHECK(least < 80);
    w.faults.flip = 0;
    CHECK(world_until(&w, LOFT_PHASE_CLOSING, 60000));
    CHECK(w.s.window.frame_size == LOFT_FRAME_MAX);
}

int main(void)
{
    PROPERTY(hello_is_repeated_ever_less_often, 5);
    PROPERTY(a_greeting_is_put_together, 10);
    PROPERTY(frames_of_another_session_are_counted_and_forgotten, 5);
    PROPERTY(stale_answers_are_forgotten, 20);
    PROPERTY(the_window_is_used_and_kept, 3);
    PROPERTY(wait_tells_the_truth, BY_NUM(100, 10, 10));
    PROPERTY(the_round_trip_is_measured, 20);
    PROPERTY(a_dead_line_is_tried_ever_less_often, 5);
    PROPERTY(what_is_answered_late_is_not_sent_again, BY_NUM(50, 5, 5));
    PROPERTY(answers_that_are_lost_cost_nothing, 20);
    PROPERTY(what_is_lost_at_the_end_is_asked_for, 20);
    PROPERTY(one_lost_frame_costs_one_round_trip, BY_NUM(50, 5, 5));
    PROPERTY(a_lost_end_is_said_again, 20);
    PROPERTY(a_lost_job_is_said_again, 5);
    PROPERTY(closing_is_not_waited_for, 5);
    PROPERTY(an_item_that_cannot_be_said_ends_the_job, 10);
    PROPERTY(frames_shrink_on_a_bad_line_and_grow_again, 5);
    return check_failures();
}

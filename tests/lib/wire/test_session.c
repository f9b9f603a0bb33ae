/* tests/lib/wire/test_session.c -- properties of lib/wire/receiver.h and sender.h: a job arrives
 * exactly once
 * SPDX-License-Identifier: MIT
 */
#include "support/line.h"           /* world: a sender, a bad line, a receiver */

static const uint16_t queue_sizes[6] = { 2, 5, 16, 64, 256, 4096 };

static void arb_world(arb *a, world *w)
{
    world_init(w, a, queue_sizes[arb_below(a, 6)], arb_below(a, 4),
               arb_below(a, 4) ? arb_below(a, 400) : arb_below(a, 4));
    w->delay = arb_below(a, 20);
    w->rate  = 2 + arb_below(a, 40);
}

static void arb_faults(arb *a, line_faults *f)
{
    const uint32_t worst = arb_below(a, 3) ? 2000 : 12000;
    f->flip   = arb_below(a, worst);
    f->drop   = arb_below(a, worst);
    f->twice  = arb_below(a, worst / 4);
    f->insert = arb_below(a, worst / 4);
    f->burst  = arb_below(a, worst / 10);
    f->outage_ms = arb_below(a, 4) ? 60 : 3000;
    f->outage    = arb_below(a, 3) ? 0 : 200000 / f->outage_ms;     /* a tenth of the time */
}

/* The job is drawn: every item once, in order (the machine compares each), and both sides report
 * it. */
static void check_drawn(const world *w)
{
    CHECK(w->s.phase == LOFT_PHASE_DONE);
    CHECK(w->m.delivered == w->count && w->m.jobs == 1 && w->m.ends == 1);
    CHECK(w->s.report.job == w->job.id && w->s.report.items == w->count &&
          w->s.report.state == LOFT_STATE_DONE);
}


// A good line
// -----------

static void a_good_line_needs_no_repairs(arb *a)
{
    static world w;
    arb_world(a, &w);
    world_run(&w, 600000);
    check_drawn(&w);
    CHECK(w.m.now.state == LOFT_STATE_IDLE && w.m.closes == 1);
    CHECK(w.s.resent == 0 && w.s.naks == 0 && w.s.timeouts == 0 && w.s.hellos == 1);
    CHECK(w.m.r.dropped == 0 && w.m.r.damaged == 0 && w.s.damaged == 0 && w.s.unknown == 0);
    CHECK(!w.s.resumed && !w.s.collected);
}

/* 115200 baud, and a machine that is never full: more than nine tenths of the line's bytes are
 * items. */
static void a_good_line_is_used_well(arb *a)
{
    static world w;
    uint32_t payload = 0;
    loft_predictor p;
    loft_packer k;
    uint8_t byte[255];

    world_init(&w, a, 4096, 0, 4000);
    world_run(&w, 600000);
    check_drawn(&w);

    const uint32_t took = w.bytes;
    loft_predictor_init(&p, w.job.start);
    for (uint32_t n = 0; n < w.count; n += k.count) {
        loft_item item;
        loft_packer_init(&k, (enum loft_kind)w.job.kind, &p, byte, LOFT_FRAME_MAX - 11);
        do
            job_item(w.job.id, (enum loft_kind)w.job.kind, n + k.count, &item);
        while (n + k.count < w.count && loft_packer_push(&k, &item) == LOFT_OK);
        p = k.predictor;
        payload += k.size;
    }
    CHECK(took * 8 < payload * 10);
}

/* A machine much slower than the line: its queue stays full without frames of one item. */
static void a_full_machine_is_fed_in_portions(arb *a)
{
    static world w;
    uint32_t least = 0xFFFFFFFFu;
    world_init(&w, a, 64, 5, 600);
    w.rate = 40;
    while (w.s.phase < LOFT_PHASE_DONE && !check_bad) {
        world_step(&w);
        if (w.m.delivered >= 64 && !w.m.ended && w.m.queued < least)
            least = w.m.queued;
    }
    check_drawn(&w);
    CHECK(least > 30);
    CHECK(w.s.sent < 600 / 8);
    /* answers, too, in portions */
    CHECK(w.up.frames < 600 / 8 + 3 * 600 * 5 / LOFT_SENDER_POLL);
    CHECK(w.m.r.dropped == 0);
}

/* A queue of 1 to 4 items still works. */
static void the_smallest_queues_work(arb *a)
{
    static world w;
    world_init(&w, a, (uint16_t)(1 + arb_below(a, 4)), arb_below(a, 3), 30);
    world_run(&w, 60000);
    check_drawn(&w);
}


// A bad line
// ----------

static void every_item_arrives_once_over_a_bad_line(arb *a)
{
    static world w;
    arb_world(a, &w);
    arb_faults(a, &w.faults);
    world_run(&w, 3000000);
    check_drawn(&w);
}

/* The sender is killed at any moment, even in the middle of a frame, and the same command is given
 * again. */
static void senders_may_die(arb *a)
{
    static world w;
    arb_world(a, &w);
    if (arb_below(a, 2))
        arb_faults(a, &w.faults);
    for (uint32_t lives = arb_below(a, 8); lives > 0; lives--) {
        for (uint32_t ms = arb_below(a, 2000); ms > 0 && w.s.phase < LOFT_PHASE_CLOSING; ms--)
            world_step(&w);
        if (w.s.phase >= LOFT_PHASE_CLOSING)        /* drawn and reported: the same command would
                                                     * draw it again */
            break;
        if (arb_below(a, 2))
            w.up.out = w.up.in;                     /* the port was flushed */
        world_dial(&w);
        if (arb_below(a, 3) == 0)
            for (uint32_t ms = arb_below(a, 3000); ms > 0; ms--) {
                /* nobody there for a while */
                w.s.hello_sent = true, w.s.tried = w.s.heard = w.now;
                world_step(&w);
            }
    }
    world_run(&w, 3000000);
    check_drawn(&w);
}

/* Old frames, of this session and of earlier ones, come again in both directions. */
static void stale_frames_change_nothing(arb *a)
{
    static world w;
    arb_world(a, &w);
    w.faults.replay = 100000;
    w.faults.drop   = arb_below(a, 1000);
    for (uint32_t lives = arb_below(a, 3); lives > 0; lives--) {
        for (uint32_t ms = arb_below(a, 1000); ms > 0 && w.s.phase < LOFT_PHASE_CLOSING; ms--)
            world_step(&w);
        if (w.s.phase >= LOFT_PHASE_CLOSING)
            break;
        world_dial(&w);
    }
    if (!world_run(&w, 20000))
        w.faults.replay = 0;            /* an old HELLO every 10 ms would keep even the best from
                                         * working */
    world_run(&w, 3000000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count && w.m.jobs == 1);
}

/* A machine that does not take all items of a frame gets the rest again. */
static void a_careless_machine_loses_nothing(arb *a)
{
    static world w;
    arb_world(a, &w);
    w.m.sloppy = 20000;
    world_run(&w, 3000000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count);
}

static void cut(arb *a, uint32_t at, bool up, bool kill)
{
    static world w;

    world_init(&w, a, 16, 1, 40);
    w.job.kind = LOFT_SPANS;
    for (int ms = 0; w.s.phase < LOFT_PHASE_DONE && ms < 20000 && !check_bad; ms++) {
        const uint32_t before = up ? w.up.in : w.bytes;
        world_step(&w);
        if (before <= at && (up ? w.up.in : w.bytes) > at) {
            if (kill && w.s.phase < LOFT_PHASE_CLOSING) {
                world_dial(&w);
            } else {
                w.down.dead = w.up.dead = true;
                w.down.dead_until = w.up.dead_until = w.now + 20;
            }
        }
    }
    check_drawn(&w);
}

/* The cable is out for 20 ms, or the sender dies, after any byte that either side sends. */
static void a_cut_after_any_byte_is_repaired(arb *a)
{
    const uint32_t step = BY_NUM(1, 97, 97) * CHECK_STEP;
    for (uint32_t at = arb_below(a, step); at < 2600 && !check_bad; at += step) {
        cut(a, at, at & 1, false);
        cut(a, at, at & 1, true);
        if (check_bad)
            printf("cut after byte %u\n", (unsigned)at);
    }
}


// The machine goes, or has other plans
// ------------------------------------

static void a_restarted_machine_is_lost(arb *a)
{
    static world w;
    arb_world(a, &w);
    w.count = 400;
    w.m.period = 3;
    if (arb_below(a, 2))
        arb_faults(a, &w.faults);
    while (!(w.s.opened && w.m.delivered > 0) && !check_bad)
        world_step(&w);
    for (uint32_t ms = arb_below(a, 500); ms > 0 && w.m.queued > 0; ms--)
        world_step(&w);

    mill_init(&w.m, w.m.info.boot + 1 + arb_below(a, 1000), w.m.info.queue, 3);
    w.m.told = 0xFFFFFFFFu;                             /* what the one before said still counts */
    w.up.out_at = w.up.out_size = 0;
    world_run(&w, 3000000);
    CHECK(w.s.phase == LOFT_PHASE_LOST);
    CHECK(w.m.delivered == 0 && w.m.jobs == 0);
}

static void another_job_is_left_alone(arb *a)
{
    static world w;
    arb_world(a, &w);
    w.count = 300;
    w.m.period = 2;
    while (w.m.delivered < 3 && !check_bad)
        world_step(&w);
    const uint32_t first = w.job.id;
    const loft_job job = w.job;

    w.job.id ^= 0x55555555u;
    w.job.id |= 1;
    world_dial(&w);
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_BUSY && w.s.machine.job == first && w.m.jobs == 1);

    if (arb_below(a, 2)) {                              /* stop it from there */
        loft_sender_control(&w.s, LOFT_ABORT);
        for (int ms = 0; ms < 3000 && w.m.now.state != LOFT_STATE_ABORTED; ms++)
            world_step(&w);
        CHECK(w.m.now.state == LOFT_STATE_ABORTED && w.s.verb == 0);
        world_dial(&w);                                 /* and now there is room for ours */
        world_run(&w, 600000);
        CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.jobs == 2 && w.m.delivered == w.count);
    } else {                                            /* or let it go on */
        w.job = job;
        world_dial(&w);
        world_run(&w, 600000);
        check_drawn(&w);
        CHECK(w.s.resumed);
        for (int i = 0; i < LOFT_AXES; i++)             /* it was told where the job began */
            CHECK(w.s.axis[i].start == job.start[i] &&
                  w.s.axis[i].steps_per_mm == (80 + i) * 65536);
    }
}

/* The sender died when everything was sent. The report waits for the next sender, which does not
 * draw the job again. */
/* A lost line ends a job whose report has come, and no other. */
static void a_hangup_ends_what_is_reported(arb *a)
{
    static world w;

    arb_world(a, &w);
    for (uint32_t ms = arb_below(a, 2000); ms > 0 && w.s.phase < LOFT_PHASE_CLOSING; ms--)
        world_step(&w);
    const enum loft_phase before = w.s.phase;
    loft_sender_hangup(&w.s);
    CHECK(w.s.phase == (before == LOFT_PHASE_CLOSING ? LOFT_PHASE_DONE : before));

    world_init(&w, a, 16, 0, 5);
    for (int ms = 0; ms < 60000 && w.s.phase < LOFT_PHASE_CLOSING; ms++)
        world_step(&w);
    CHECK(w.s.phase == LOFT_PHASE_CLOSING);
    loft_sender_hangup(&w.s);
    check_drawn(&w);
}

static void a_report_is_collected_once(arb *a)
{
    static world w;
    arb_world(a, &w);
    while (w.m.ends == 0 && !check_bad)
        world_step(&w);
    world_dial(&w);
    w.s.hello_sent = true;
    while (w.m.now.state != LOFT_STATE_DONE && !check_bad) {
        w.s.tried = w.s.heard = w.now;
        world_step(&w);
    }
    world_run(&w, 60000);
    check_drawn(&w);
    CHECK(w.s.collected && w.m.closes == 1 && w.m.now.state == LOFT_STATE_IDLE);

    world_dial(&w);                                     /* once more is once more */
    world_run(&w, 600000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.jobs == 2 && !w.s.collected && !w.s.resumed);
}

static void a_refusal_is_told(arb *a)
{
    static world w;
    arb_world(a, &w);
    if (arb_below(a, 2))
        arb_faults(a, &w.faults);
    w.m.refuses = arb_below(a, 2) ? LOFT_REFUSAL_START : LOFT_REFUSAL_ITEM;
    if (arb_below(a, 3) == 0) {
        w.m.refuses = LOFT_REFUSAL_NONE;                /* the receiver itself does */
        w.m.info.kinds = (uint8_t)(w.m.info.kinds & ~(1u << w.job.kind));
    }
    world_run(&w, 600000);
    CHECK(w.s.phase == LOFT_PHASE_REFUSED);
    CHECK(w.s.refusal == (w.m.refuses ? w.m.refuses : LOFT_REFUSAL_KIND));
    CHECK(w.m.jobs == 0 && w.m.delivered == 0);
}

/* A refused JOB stays refused in its session: a late one must not begin after its host has gone. */
static void a_refused_job_comes_late_and_begins_nothing(arb *a)
{
    static world w;
    uint8_t wire[LOFT_FRAME_MAX];
    arb_world(a, &w);
    w.m.refuses = LOFT_REFUSAL_INPUT;
    w.m.now.closed = LOFT_INPUT_HIGH(0);
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_REFUSED && w.s.refusal == LOFT_REFUSAL_INPUT &&
          w.s.closed == LOFT_INPUT_HIGH(0));
    w.m.refuses = LOFT_REFUSAL_NONE;
    const size_t n = loft_job_encode(&w.s.job, w.s.session, wire);
    for (size_t i = 0; i < n; i++)
        mill_byte(&w.m, a, wire[i], w.now);
    CHECK(w.m.jobs == 0 && w.m.r.job == 0);
    world_dial(&w);                                     /* another session, another answer */
    world_run(&w, 600000);
    check_drawn(&w);
}

/* The machine finds in mid-job that it cannot continue: the job ends and the reason is reported. */
static void a_late_refusal_ends_the_job(arb *a)
{
    static world w;
    arb_world(a, &w);
    w.count = 300;
    w.m.period = 2;
    while (w.m.delivered < 5 && !check_bad)
        world_step(&w);
    loft_receiver_answer(&w.m.r, NULL, LOFT_REFUSAL_ITEM);
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_ABORTED && w.s.report.job == w.job.id &&
          w.s.report.state == LOFT_STATE_ABORTED);
    CHECK(w.s.report.items == w.m.now.executed && w.m.aborts == 1);
}

static void a_fault_is_a_loss(arb *a)
{
    static world w;
    arb_world(a, &w);
    w.count = 300;
    w.m.period = 2;
    while (w.m.delivered < 5 && !check_bad)
        world_step(&w);
    w.m.now.state = LOFT_STATE_FAULT;
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_LOST);
    world_dial(&w);
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_LOST && w.m.jobs == 1);
}

static void an_unfit_machine_is_not_used(arb *a)
{
    static world w;
    loft_welcome m = { 0 };
    uint8_t wire[LOFT_FRAME_MAX];
    const uint32_t what = arb_below(a, 7);

    world_init(&w, a, 16, 0, 10);
    m.version = LOFT_WIRE_VERSION;
    m.axes = LOFT_AXES;
    m.queue = m.tick_hz = m.slots = 10;
    m.frame_max = 13 + 15 * LOFT_AXES;
    if (what == 0)
        m.version = 0;
    if (what == 1)
        m.axes++;
    if (what == 2)
        m.frame_max--;
    if (what == 3)
        m.queue = 0;
    if (what == 4)
        m.tick_hz = 0;
    if (what == 5)
        m.slots = 0;
    CHECK(loft_sender_poll(&w.s, w.now, wire) > 0);
    m.nonce = w.s.nonce;
    const size_t n = loft_welcome_encode(&m, 7, wire);
    for (size_t i = 0; i < n; i++)
        loft_sender_push(&w.s, wire[i], w.now);
    CHECK((w.s.phase == LOFT_PHASE_UNFIT) == (what < 6));
}

/* A host of another version is refused, and the job continues. */
static void no_common_version_is_told(arb *a)
{
    static world w;
    loft_hello hello = { 0 };
    uint8_t wire[LOFT_FRAME_MAX];
    loft_welcome m;
    loft_frame f;

    world_init(&w, a, 16, 3, 100);
    while (w.m.delivered < 5 && !check_bad)
        world_step(&w);
    hello.nonce = 77;
    hello.min_version = LOFT_WIRE_VERSION + 1;
    hello.max_version = 9;
    size_t n = loft_hello_encode(&hello, wire);
    for (size_t i = 0; i < n; i++)
        mill_byte(&w.m, a, wire[i], w.now);
    n = loft_receiver_poll(&w.m.r, &w.m.now, wire);
    loft_frame_init(&f);
    for (size_t i = 0; i + 1 < n; i++)
        CHECK(loft_frame_push(&f, wire[i]) == LOFT_MORE);
    CHECK(loft_frame_push(&f, 0) == LOFT_OK);
    CHECK(loft_message_type(&f) == LOFT_WELCOME && loft_welcome_decode(&f, &m) == LOFT_OK);
    CHECK(m.version == 0 && m.nonce == 77 && m.job == w.job.id);
    CHECK(loft_receiver_poll(&w.m.r, &w.m.now, wire) == 0);
    world_run(&w, 60000);
    check_drawn(&w);
}


// Hold, resume, abort
// -------------------

/* The queue and the window are full; a control is still executed within a round trip. */
static void controls_pass_a_full_window(arb *a)
{
    static world w;
    world_init(&w, a, 16, 50, 300);
    while (w.m.queued < 16 && !check_bad)
        world_step(&w);
    loft_sender_control(&w.s, LOFT_HOLD);
    for (int ms = 0; ms < 40; ms++)
        world_step(&w);
    CHECK(w.m.now.state == LOFT_STATE_HELD && w.m.holds == 1);

    const uint32_t executed = w.m.now.executed;
    for (int ms = 0; ms < 3000; ms++)
        world_step(&w);
    CHECK(w.m.now.executed == executed && w.s.phase == LOFT_PHASE_STREAMING && w.s.hellos == 1);
    CHECK(w.s.status.ack.state == LOFT_STATE_HELD && w.s.ack.state == LOFT_STATE_HELD);

    loft_sender_control(&w.s, LOFT_RESUME);
    for (int ms = 0; ms < 40; ms++)
        world_step(&w);
    CHECK(w.m.now.state == LOFT_STATE_RUNNING && w.m.resumes == 1);
    w.m.period = 0;
    world_run(&w, 60000);
    check_drawn(&w);
    CHECK(w.m.holds == 1 && w.m.resumes == 1 && w.m.aborts == 0);
}

/* An override during a hold in flight: both are executed, and the last override counts. */
static void overrides_pass_a_full_window_and_replace_no_hold(arb *a)
{
    static world w;
    world_init(&w, a, 16, 50, 300);
    arb_faults(a, &w.faults);
    for (int ms = 0; ms < 20000 && w.m.queued < 16 && !check_bad; ms++)
        world_step(&w);
    const uint8_t percent = (uint8_t)(1 + arb_below(a, 200));
    for (uint32_t k = arb_below(a, 4); k > 0; k--) {
        loft_sender_override(&w.s, 1 + arb_below(a, 200));
        for (uint32_t ms = arb_below(a, 60); ms > 0; ms--)
            world_step(&w);
    }
    const bool before = arb_below(a, 2);
    if (before)
        loft_sender_override(&w.s, percent);
    loft_sender_control(&w.s, LOFT_HOLD);
    if (!before)
        loft_sender_override(&w.s, percent);
    for (int ms = 0; ms < 60000 && (w.s.verb || w.s.percent || w.m.now.state != LOFT_STATE_HELD) &&
                     w.s.phase < LOFT_PHASE_CLOSING;
         ms++)
        world_step(&w);
    CHECK(w.m.now.state == LOFT_STATE_HELD && w.m.now.override == percent && w.m.overrides >= 1);
    for (int ms = 0; ms < 60000 && w.s.status.override != percent; ms++)
        world_step(&w);
    CHECK(w.s.status.override == percent);
}

/* Any controls at any time over a bad line: the machine follows the last one, and executes none
 * twice in a session. */
static void the_last_control_counts(arb *a)
{
    static world w;
    uint32_t asked = 0;
    arb_world(a, &w);
    w.count = 200;
    w.m.period = 10;
    arb_faults(a, &w.faults);
    w.faults.replay = arb_below(a, 2) ? 50000 : 0;
    for (int k = 0; k < 6; k++) {
        for (uint32_t ms = arb_below(a, 200); ms > 0; ms--)
            world_step(&w);
        if (w.s.phase == LOFT_PHASE_STREAMING) {
            loft_sender_control(&w.s, k == 5            ? LOFT_RESUME
                                      : arb_below(a, 2) ? LOFT_HOLD
                                                        : LOFT_RESUME);
            asked++;
        }
    }
    w.m.period = 0;
    if (w.m.now.state == LOFT_STATE_HELD && w.s.verb == 0)
        loft_sender_control(&w.s, LOFT_RESUME), asked++;
    for (int ms = 0; ms < 20000 && (w.s.verb || w.m.now.state == LOFT_STATE_HELD) &&
                     w.s.phase < LOFT_PHASE_CLOSING;
         ms++) {
        world_step(&w);
        if (w.m.now.state == LOFT_STATE_HELD && w.s.verb == 0 && w.s.phase == LOFT_PHASE_STREAMING)
            loft_sender_control(&w.s, LOFT_RESUME), asked++;
    }
    world_run(&w, 3000000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count);
    CHECK(w.m.holds + w.m.resumes <= asked + w.s.hellos);
}

/* A control before the machine has the JOB is sent after it, even over a bad line, because the job
 * would begin without it. */
static void a_hold_asked_for_early_holds_the_job(arb *a)
{
    static world w;
    arb_world(a, &w);
    w.count = 300;
    w.m.period = 3;
    arb_faults(a, &w.faults);
    for (int ms = 0; ms < 20000 && !(w.s.phase == LOFT_PHASE_OPENING && w.s.job_sent); ms++)
        world_step(&w);
    loft_sender_control(&w.s, LOFT_HOLD);
    for (int ms = 0; ms < 60000 && (w.s.phase < LOFT_PHASE_STREAMING || w.s.verb); ms++)
        world_step(&w);
    CHECK(w.m.jobs == 1 && w.m.now.state == LOFT_STATE_HELD);
}

static void an_aborted_job_ends_with_a_report(arb *a)
{
    static world w;
    arb_world(a, &w);
    w.count = 300;
    w.m.period = 3;
    if (arb_below(a, 2))
        arb_faults(a, &w.faults);
    for (uint32_t ms = arb_below(a, 1000); ms > 0 && w.s.phase < LOFT_PHASE_CLOSING; ms--)
        world_step(&w);
    const uint32_t sent = w.s.sent;
    loft_sender_control(&w.s, LOFT_ABORT);
    world_run(&w, 3000000);
    CHECK(w.s.sent == sent);
    CHECK(w.s.phase == LOFT_PHASE_ABORTED ||
          (w.s.phase == LOFT_PHASE_DONE && w.m.delivered == w.count));
    CHECK(w.m.jobs == 0 || w.s.report.job == w.job.id);
    CHECK(w.m.jobs == 0 || w.s.report.items == w.m.now.executed);

    world_dial(&w);                                     /* the machine is ready for the next one */
    w.m.period = 0;
    memset(&w.faults, 0, sizeof w.faults);
    const uint32_t jobs = w.m.jobs;
    world_run(&w, 60000);
    CHECK(w.s.phase == LOFT_PHASE_DONE && w.m.jobs <= jobs + 1 && w.m.delivered == w.count);
}


// Odds and ends
// -------------

/* Unknown types, and the machine's own frames coming back, are skipped and counted. */
static void unknown_messages_are_skipped_and_counted(arb *a)
{
    static world w;
    uint8_t wire[LOFT_FRAME_MAX];
    world_init(&w, a, 64, 2, 200);
    while (w.m.delivered < 20 && !check_bad)
        world_step(&w);

    mill_byte(&w.m, a, 0, w.now);                       /* the end of whatever was on its way */
    loft_sender_push(&w.s, 0, w.now);
    const uint32_t dropped = w.m.r.dropped, unknown = w.s.unknown;
    for (unsigned type = 0; type < 16; type++) {
        const bool from_host = (type >= LOFT_HELLO && type <= LOFT_POLL) ||
                               type == LOFT_DATA_FINE || type == LOFT_DATA_CURVES;
        wire[1] = (uint8_t)(type << 4 | LOFT_WIRE_VERSION);
        wire[2] = w.s.session;
        wire[3] = (uint8_t)arb_next(a);
        const size_t n = loft_frame_encode(wire, 3);
        for (size_t i = 0; i < n && !from_host; i++)
            mill_byte(&w.m, a, wire[i], w.now);
        for (size_t i = 0; i < n && (type < LOFT_WELCOME || type > LOFT_REPORT); i++)
            loft_sender_push(&w.s, wire[i], w.now);
    }
    CHECK(w.m.r.dropped == dropped + 7 && w.s.unknown == unknown + 10);
    world_run(&w, 60000);
    check_drawn(&w);
}

static void bad_arguments_are_refused(arb *a)
{
    static world w;
    loft_machine_info t = { 0 };
    loft_receiver r;
    world_init(&w, a, 16, 0, 5);
    /* not welcomed */
    CHECK(loft_sender_begin(&w.s, &w.job, 5, world_source, &w) == LOFT_ERR_ARG);
    CHECK(loft_receiver_init(&r, &t) == LOFT_ERR_ARG);
    t.queue = t.slots = 1;
    CHECK(loft_receiver_init(&r, &t) == LOFT_ERR_ARG);
    t.tick_hz = 1;
    CHECK(loft_receiver_init(&r, &t) == LOFT_OK);
}

static uint32_t touched, touched_k, touched_bit, touched_axis;
static void touched_source(void *context, uint32_t index, loft_item *out)
{
    world_source(context, index, out);
    if (index == touched)
        out->p[touched_k][touched_axis] ^= (int32_t)((uint32_t)1 << touched_bit);
}

static void the_id_depends_on_every_item(arb *a)
{
    static world w;
    world_init(&w, a, 16, 0, 20);
    const uint32_t id = loft_job_id(&w.job, 20, world_source, &w);
    touched     = arb_below(a, 20);
    touched_k   = w.job.kind == LOFT_SPANS ? arb_below(a, 3) : 2;
    touched_bit = arb_below(a, 32);
    touched_axis = arb_below(a, LOFT_AXES);
    CHECK(id != 0 && id == loft_job_id(&w.job, 20, world_source, &w));
    CHECK(id != loft_job_id(&w.job, 20, touched_source, &w));
    CHECK(id != loft_job_id(&w.job, 19, world_source, &w));
    const loft_job job = w.job;
    w.job.start[touched_axis]++;
    CHECK(id != loft_job_id(&w.job, 20, world_source, &w));
    w.job = job;
    w.job.kind = (uint8_t)(job.kind == LOFT_SPANS ? LOFT_POINTS : LOFT_SPANS);
    CHECK(id != loft_job_id(&w.job, 20, world_source, &w));
}

/* Curves are planned with limits: with others it is another job. */
static void the_id_depends_on_every_limit(arb *a)
{
    static world w;
    loft_job_limits limits;
    uint8_t *byte = (uint8_t *)&limits;

    world_init(&w, a, 16, 0, 20);
    for (unsigned n = 0; n < sizeof limits; n++)
        byte[n] = (uint8_t)arb_next(a);
    w.job.kind = LOFT_CURVES;
    w.job.limits = &limits;
    const uint32_t id = loft_job_id(&w.job, 20, world_source, &w);
    const loft_job_limits before = limits;
    const unsigned i = arb_below(a, LOFT_AXES);
    switch (arb_below(a, 5)) {
    case 0:  limits.corner++; break;
    case 1:  limits.tol++; break;
    case 2:  limits.axis[i].max_speed++; break;
    case 3:  limits.axis[i].max_accel++; break;
    default: limits.axis[i].max_jerk++; break;
    }
    CHECK(id != loft_job_id(&w.job, 20, world_source, &w));
    limits = before;
    CHECK(id == loft_job_id(&w.job, 20, world_source, &w));
}

int main(void)
{
    PROPERTY(a_good_line_needs_no_repairs, BY_NUM(300, 30, 30));
    PROPERTY(a_good_line_is_used_well, 2);
    PROPERTY(a_full_machine_is_fed_in_portions, 3);
    PROPERTY(the_smallest_queues_work, 20);
    PROPERTY(every_item_arrives_once_over_a_bad_line, BY_NUM(1000, 50, 50));
    PROPERTY(senders_may_die, BY_NUM(1000, 50, 50));
    PROPERTY(stale_frames_change_nothing, BY_NUM(500, 30, 30));
    PROPERTY(a_careless_machine_loses_nothing, 20);
    PROPERTY(a_cut_after_any_byte_is_repaired, 1);
    PROPERTY(a_restarted_machine_is_lost, BY_NUM(300, 20, 20));
    PROPERTY(another_job_is_left_alone, 20);
    PROPERTY(a_report_is_collected_once, 20);
    PROPERTY(a_hangup_ends_what_is_reported, 50);
    PROPERTY(a_refusal_is_told, 20);
    PROPERTY(a_refused_job_comes_late_and_begins_nothing, 20);
    PROPERTY(a_late_refusal_ends_the_job, 20);
    PROPERTY(a_fault_is_a_loss, 10);
    PROPERTY(an_unfit_machine_is_not_used, 30);
    PROPERTY(no_common_version_is_told, 5);
    PROPERTY(controls_pass_a_full_window, 10);
    PROPERTY(a_hold_asked_for_early_holds_the_job, BY_NUM(300, 30, 30));
    PROPERTY(overrides_pass_a_full_window_and_replace_no_hold, BY_NUM(100, 10, 10));
    PROPERTY(the_last_control_counts, BY_NUM(300, 20, 20));
    PROPERTY(an_aborted_job_ends_with_a_report, BY_NUM(500, 30, 30));
    PROPERTY(unknown_messages_are_skipped_and_counted, 10);
    PROPERTY(bad_arguments_are_refused, 1);
    PROPERTY(the_id_depends_on_every_item, 200);
    PROPERTY(the_id_depends_on_every_limit, 200);
    return check_failures();
}

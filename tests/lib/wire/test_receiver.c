/* tests/lib/wire/test_receiver.c -- properties of lib/wire/receiver.h, frame by frame
 * SPDX-License-Identifier: MIT
 */
#include "support/line.h"           /* mill: the smallest machine behind a receiver */

/* Give one frame to the receiver; count the events. */
static unsigned give(mill *m, arb *a, const uint8_t wire[], size_t size)
{
    const uint32_t before = m->jobs + m->delivered + m->ends + m->holds + m->resumes + m->aborts +
                            m->closes + m->places;
    for (size_t i = 0; i < size; i++)
        mill_byte(m, a, wire[i], 0);
    return m->jobs + m->delivered + m->ends + m->holds + m->resumes + m->aborts + m->closes +
           m->places - before;
}

static loft_ack answer(mill *m)
{
    uint8_t wire[LOFT_FRAME_MAX];
    loft_ack ack = { 0 };
    loft_frame f;
    size_t n;

    m->now.room = (uint16_t)(m->info.queue - m->queued);
    loft_frame_init(&f);
    while ((n = loft_receiver_poll(&m->r, &m->now, wire)) > 0)
        for (size_t i = 0; i < n; i++)
            if (loft_frame_push(&f, wire[i]) == LOFT_OK && loft_message_type(&f) == LOFT_ACK)
                CHECK(loft_ack_decode(&f, &ack) == LOFT_OK);
    return ack;
}

/* A repeated message, a misplaced one, and one of a wrong session have no effect. */
static void a_message_works_once_and_in_its_place(arb *a)
{
    static mill m;
    uint8_t wire[LOFT_FRAME_MAX], data[LOFT_FRAME_MAX];
    loft_hello hello = { LOFT_WIRE_VERSION, LOFT_WIRE_VERSION, 1 };
    loft_control control = { .number = 1, .verb = LOFT_HOLD };
    loft_job job = { 0 };
    loft_predictor p;
    loft_packer k;
    loft_item item;
    uint8_t s;

    mill_init(&m, 99, 16, 0);
    job.nonce = 1, job.id = 5, job.kind = LOFT_SPANS;

    CHECK(give(&m, a, wire, loft_job_encode(&job, 1, wire)) == 0);          /* no session */
    CHECK(give(&m, a, wire, loft_hello_encode(&hello, wire)) == 0);
    s = m.r.session;
    CHECK(s != 0 && answer(&m).state == LOFT_STATE_IDLE);
    CHECK(give(&m, a, wire, loft_hello_encode(&hello, wire)) == 0 && m.r.session == s);
    answer(&m);

    loft_predictor_init(&p, job.start);
    loft_data_init(&k, LOFT_SPANS, &p, LOFT_FRAME_MAX, data);
    job_item(5, LOFT_SPANS, 0, &item);
    CHECK(loft_packer_push(&k, &item) == LOFT_OK);
    const size_t size = loft_data_encode(&k, 0, loft_predictor_seal(&p), s, data);

    CHECK(give(&m, a, data, size) == 0);                                    /* no job */
    job.nonce = 2;
    /* of another connection */
    CHECK(give(&m, a, wire, loft_job_encode(&job, s, wire)) == 0);
    job.nonce = 1;
    CHECK(give(&m, a, wire, loft_job_encode(&job, (uint8_t)(s + 1), wire)) == 0);
    CHECK(give(&m, a, wire, loft_job_encode(&job, s, wire)) == 1);
    CHECK(give(&m, a, wire, loft_job_encode(&job, s, wire)) == 0);
    CHECK(answer(&m).flags == (LOFT_FLAG_OPENED));
    job.id = 6;
    CHECK(give(&m, a, wire, loft_job_encode(&job, s, wire)) == 0 &&
          answer(&m).refusal == LOFT_REFUSAL_BUSY);
    CHECK(m.r.job == 5);

    CHECK(give(&m, a, wire, loft_end_encode(1, s, wire)) == 0);             /* an item is missing */
    CHECK(answer(&m).flags & LOFT_FLAG_NAK);
    /* early */
    CHECK(give(&m, a, wire,
               loft_data_encode(&k, 1, loft_predictor_seal(&p), s, memcpy(wire, data, size))) == 0);
    CHECK(answer(&m).flags & LOFT_FLAG_NAK);
    CHECK(give(&m, a, data, size) == 1);
    loft_ack ack = answer(&m);
    CHECK(ack.next == 1 && ack.limit == 16 && !(ack.flags & LOFT_FLAG_NAK));
    CHECK(give(&m, a, data, size) == 0);                                    /* again */
    ack = answer(&m);
    CHECK(ack.next == 1 && !(ack.flags & LOFT_FLAG_NAK));

    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 1);
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 0);
    control.number = 200;                               /* older than 1, modulo 256 */
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 0);
    control.number = 2, control.verb = LOFT_CLOSE;                          /* nothing to close */
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 0 && m.r.job == 5);
    control.number = 3, control.verb = LOFT_RESUME;
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 1);
    control.number = 4, control.verb = LOFT_PLACE, control.value = 1;       /* not in a job */
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 0 && m.places == 0);
    CHECK(answer(&m).refusal == LOFT_REFUSAL_BUSY);
    control.value = 0;

    CHECK(give(&m, a, wire, loft_end_encode(1, s, wire)) == 1);
    CHECK(give(&m, a, wire, loft_end_encode(1, s, wire)) == 0);
    CHECK(give(&m, a, data, size) == 0);
    mill_run(&m, 0);
    mill_run(&m, 0);
    CHECK(m.now.state == LOFT_STATE_DONE);
    hello.nonce = 3;
    CHECK(give(&m, a, wire, loft_hello_encode(&hello, wire)) == 0 && m.r.session != s);
    s = m.r.session;
    answer(&m);
    job.nonce = 3, job.id = 5;                          /* drawn, but nobody has the report */
    CHECK(give(&m, a, wire, loft_job_encode(&job, s, wire)) == 0 && m.r.job == 5 &&
          answer(&m).refusal == 0);
    control.number = 1, control.verb = LOFT_CLOSE;
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 1 && m.r.job == 0);

    control.number = 2, control.verb = LOFT_PLACE, control.value = 1;       /* idle: obeyed, once */
    CHECK(m.places == 0);
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 1 && m.places == 1);
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 0 && m.places == 1);
    ack = answer(&m);
    CHECK(ack.control == 2 && ack.refusal == LOFT_REFUSAL_NONE);
    /* one job per session */
    CHECK(give(&m, a, wire, loft_job_encode(&job, s, wire)) == 0);
}

/* All frames that the receiver would send now, type by type; the last of each is kept. */
typedef struct {
    uint16_t types;             /* bit t: type t was among them */
    unsigned frames;
    loft_welcome welcome;
    loft_axis axis[LOFT_AXES];
    loft_ack ack;
    loft_machine_status status;
    loft_report report;
} answers;

static void take_answer(answers *all, const loft_frame *f)
{
    loft_axis axis;
    all->frames++;
    all->types = (uint16_t)(all->types | 1u << loft_message_type(f));
    switch (loft_message_type(f)) {
    case LOFT_WELCOME: CHECK(loft_welcome_decode(f, &all->welcome) == LOFT_OK);       break;
    case LOFT_ACK:     CHECK(loft_ack_decode(f, &all->ack) == LOFT_OK);               break;
    case LOFT_STATUS:  CHECK(loft_machine_status_decode(f, &all->status) == LOFT_OK); break;
    case LOFT_REPORT:  CHECK(loft_report_decode(f, &all->report) == LOFT_OK);         break;
    case LOFT_AXIS:
        CHECK(loft_axis_decode(f, &axis) == LOFT_OK);
        CHECK(axis.number == all->frames - 2);                  /* in order, behind WELCOME */
        all->axis[axis.number] = axis;
        break;
    default: CHECK(false);
    }
}

static answers all_answers(mill *m)
{
    uint8_t wire[LOFT_FRAME_MAX];
    answers all;
    loft_frame f;
    size_t n;

    memset(&all, 0, sizeof all);
    loft_frame_init(&f);
    while ((n = loft_receiver_poll(&m->r, &m->now, wire)) > 0)
        for (size_t i = 0; i < n; i++)
            if (loft_frame_push(&f, wire[i]) == LOFT_OK)
                take_answer(&all, &f);
    return all;
}

#define TYPE(t) (1u << (t))

/* A machine in the middle of a job, with a different number in each field. */
static void arb_mill(arb *a, mill *m, loft_job *job)
{
    /* 0 is a nonce like any other */
    const loft_hello hello = { LOFT_WIRE_VERSION, LOFT_WIRE_VERSION, 0 };
    uint8_t wire[LOFT_FRAME_MAX];

    mill_init(m, 1 + (uint32_t)arb_below(a, 1000000), (uint16_t)(300 + arb_below(a, 300)), 0);
    m->info.tick_hz = (uint16_t)(1 + arb_below(a, 5000));
    m->info.slots   = (uint16_t)(1 + arb_below(a, 60));
    for (int i = 0; i < LOFT_AXES; i++) {
        m->info.axis[i].steps_per_mm = arb_raw(a, 1 << 30);
        m->info.axis[i].max_speed    = arb_raw(a, 1 << 30);
        m->info.axis[i].max_accel    = arb_raw(a, 1 << 30);
        m->now.position[i]             = arb_raw(a, 1 << 30);
        job->start[i]                  = arb_raw(a, 1 << 30);
    }
    CHECK(give(m, a, wire, loft_hello_encode(&hello, wire)) == 0 && m->r.session != 0);
    answers all = all_answers(m);
    CHECK(all.types == (TYPE(LOFT_WELCOME) | TYPE(LOFT_AXIS)) && all.frames == 1 + LOFT_AXES);
    CHECK(all.welcome.job == 0 && all.axis[LOFT_AXES - 1].start == 0);

    job->nonce = 0, job->id = 1 + arb_below(a, 1000), job->kind = LOFT_SPANS;
    job->guard = (loft_guard){ .inputs = 0 };
    CHECK(give(m, a, wire, loft_job_encode(job, m->r.session, wire)) == 1);
}

static void same_ack(const loft_ack *ack, const mill *m, uint32_t next)
{
    CHECK(ack->next == next && ack->limit == next + m->now.room &&
          ack->executed == m->now.executed);
    CHECK(ack->state == m->now.state && ack->refusal == 0 && ack->control == 0);
    CHECK(ack->flags == (LOFT_FLAG_OPENED | (m->now.starved ? LOFT_FLAG_STARVED : 0)));
}

/* The number and the CRC are right, but the sender assumes another state of the decoder. */
static void items_for_another_place_are_not_taken(arb *a)
{
    static mill m;
    uint8_t wire[LOFT_FRAME_MAX];
    loft_predictor elsewhere;
    loft_item item;
    loft_packer k;
    loft_job job;

    arb_mill(a, &m, &job);
    loft_predictor_init(&elsewhere, job.start);
    uint32_t *const state[] = { elsewhere.position, elsewhere.change, elsewhere.bend };
    state[arb_below(a, 3)][arb_below(a, LOFT_AXES)] ^= 1u << arb_below(a, 32);
    job_item(job.id, LOFT_SPANS, 0, &item);
    loft_data_init(&k, LOFT_SPANS, &elsewhere, LOFT_FRAME_MAX, wire);
    CHECK(loft_packer_push(&k, &item) == LOFT_OK);
    CHECK(give(&m, a, wire,
               loft_data_encode(&k, 0, loft_predictor_seal(&elsewhere), m.r.session, wire)) == 0);
    CHECK(m.r.damaged == 1 && m.r.next == 0 && answer(&m).flags & LOFT_FLAG_NAK);

    loft_predictor_init(&elsewhere, job.start);
    loft_data_init(&k, LOFT_SPANS, &elsewhere, LOFT_FRAME_MAX, wire);
    CHECK(loft_packer_push(&k, &item) == LOFT_OK);
    CHECK(give(&m, a, wire,
               loft_data_encode(&k, 0, loft_predictor_seal(&elsewhere), m.r.session, wire)) == 1);
}

/* Every number of the machine arrives in its field. */
static void answers_say_what_is(arb *a)
{
    const loft_hello hello = { 0, 15, 8 };
    static mill m;
    uint8_t wire[LOFT_FRAME_MAX], s;
    loft_job job;
    answers all;

    arb_mill(a, &m, &job);
    s = m.r.session;
    all = all_answers(&m);
    CHECK(all.types == TYPE(LOFT_ACK) && all.frames == 1);
    same_ack(&all.ack, &m, 0);

    m.r.next = m.r.offered = 5000 + arb_below(a, 1000);            /* as if so many had come */
    m.now.executed = 4000 + arb_below(a, 1000);
    m.now.ticks    = arb_below(a, 1 << 30);
    m.now.elapsed  = arb_below(a, 1 << 30);
    m.now.slowed   = arb_below(a, 1 << 30);
    m.now.room     = (uint16_t)arb_below(a, 70);
    m.now.starved  = arb_below(a, 2) != 0;
    m.now.override = (uint8_t)arb_below(a, 256);
    /* noise, to be counted once it ends */
    CHECK(give(&m, a, (const uint8_t *)"\x05\x05", 2) == 0);
    mill_byte(&m, a, 0, 0);
    m.r.due = 0;
    CHECK(give(&m, a, wire, loft_poll_encode(s, wire)) == 0);
    m.now.room = 60;
    all = all_answers(&m);
    CHECK(all.types == TYPE(LOFT_STATUS));
    same_ack(&all.status.ack, &m, m.r.next);
    CHECK(all.status.ticks == m.now.ticks && all.status.elapsed == m.now.elapsed &&
          all.status.slowed == m.now.slowed);
    CHECK(all.status.damaged == 1 && all.status.dropped == 0 &&
          all.status.override == m.now.override);
    CHECK(memcmp(all.status.position, m.now.position, sizeof m.now.position) == 0);

    CHECK(give(&m, a, wire, loft_hello_encode(&hello, wire)) == 0);
    all = all_answers(&m);
    CHECK(all.types == (TYPE(LOFT_WELCOME) | TYPE(LOFT_AXIS)) && all.frames == 1 + LOFT_AXES);
    same_ack(&all.welcome.ack, &m, m.r.next);
    CHECK(all.welcome.version == LOFT_WIRE_VERSION && all.welcome.nonce == 8 &&
          all.welcome.boot == m.info.boot);
    CHECK(all.welcome.job == job.id && all.welcome.axes == LOFT_AXES &&
          all.welcome.num == LOFT_NUM);
    CHECK(all.welcome.frame_max == LOFT_FRAME_MAX && all.welcome.queue == m.info.queue);
    CHECK(all.welcome.tick_hz == m.info.tick_hz && all.welcome.slots == m.info.slots);
    for (int i = 0; i < LOFT_AXES; i++) {
        CHECK(all.axis[i].steps_per_mm == m.info.axis[i].steps_per_mm &&
              all.axis[i].max_speed == m.info.axis[i].max_speed);
        CHECK(all.axis[i].max_accel == m.info.axis[i].max_accel &&
              all.axis[i].position == m.now.position[i]);
        CHECK(all.axis[i].start == job.start[i]);
    }

    m.now.state = arb_below(a, 2) ? LOFT_STATE_DONE : LOFT_STATE_ABORTED;
    all = all_answers(&m);                                      /* unasked, once */
    CHECK(all.types == TYPE(LOFT_REPORT) && all.frames == 1);
    CHECK(all.report.job == job.id && all.report.items == m.now.executed &&
          all.report.state == m.now.state);
    CHECK(all.report.ticks == m.now.ticks && all.report.elapsed == m.now.elapsed &&
          all.report.slowed == m.now.slowed);
    CHECK(memcmp(all.report.position, m.now.position, sizeof m.now.position) == 0);
    CHECK(all_answers(&m).frames == 0);
}

/* There is no unrequested answer: noise without a session or after the end, frames of unknown
 * senders. */
static void silence_where_nothing_is_asked(arb *a)
{
    static const uint8_t noise[4] = { 5, 5, 5, 0 };
    static mill m;
    uint8_t wire[LOFT_FRAME_MAX], s;
    loft_control control = { .number = 128, .verb = LOFT_HOLD };
    loft_job job;
    answers all;

    mill_init(&m, 5, 64, 0);
    CHECK(give(&m, a, noise, 4) == 0 && m.r.damaged == 1 && all_answers(&m).frames == 0);
    arb_mill(a, &m, &job);
    s = m.r.session;
    CHECK(all_answers(&m).types == TYPE(LOFT_ACK) && all_answers(&m).frames == 0);

    CHECK(give(&m, a, wire, loft_poll_encode((uint8_t)(s + 1), wire)) == 0 &&
          all_answers(&m).frames == 0);
    job.nonce = 9;
    CHECK(give(&m, a, wire, loft_job_encode(&job, s, wire)) == 0 && all_answers(&m).frames == 0);
    CHECK(give(&m, a, noise, 4) == 0);
    all = all_answers(&m);
    CHECK(all.types == TYPE(LOFT_ACK) && all.ack.flags & LOFT_FLAG_NAK);
    /* 128 ahead is as far as 128 behind */
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 0);
    CHECK(all_answers(&m).ack.control == 0);

    CHECK(give(&m, a, wire, loft_end_encode(0, s, wire)) == 1);
    all = all_answers(&m);
    /* room for nothing more */
    CHECK(all.ack.flags & LOFT_FLAG_ENDED && all.ack.limit == 0 && all.ack.next == 0);
    CHECK(give(&m, a, noise, 4) == 0 && all_answers(&m).frames == 0);

    mill_run(&m, 0);
    /* asks for the report */
    CHECK(give(&m, a, wire, loft_poll_encode(s, wire)) == 0);
    control.number = 1, control.verb = LOFT_CLOSE;
    /* and has it already */
    CHECK(give(&m, a, wire, loft_control_encode(&control, s, wire)) == 1);
    CHECK(all_answers(&m).types == TYPE(LOFT_STATUS));
}

/* An answer comes unasked when a quarter of the queue more has become free, in each state that
 * takes items and in no other state. */
static void room_is_told_in_quarters(arb *a)
{
    /* by enum loft_machine_state */
    static const uint8_t takes[8] = { 0, 1, 1, 1, 0, 0, 0, 0 };
    static mill m;
    loft_job job;

    for (uint8_t state = LOFT_STATE_RUNNING; state <= LOFT_STATE_STOPPING; state++) {
        arb_mill(a, &m, &job);
        m.now.room  = (uint16_t)arb_below(a, 20);
        m.now.state = state;
        answers all = all_answers(&m);
        const uint16_t told = m.now.room;
        CHECK(all.types == TYPE(LOFT_ACK) && all.ack.limit == (takes[state] ? told : 0u));
        m.now.room = (uint16_t)(told + m.info.queue / 4 - 1);
        CHECK(all_answers(&m).frames == 0);
        m.now.room++;
        all = all_answers(&m);
        CHECK(all.types == (takes[state] ? TYPE(LOFT_ACK) : 0u) &&
              (!takes[state] || all.ack.limit == m.now.room));
        CHECK(all_answers(&m).frames == 0);
    }
}

/* A frame waits exactly when push says so. One that is not looked at is requested again. */
static void push_tells_when_a_frame_waits(arb *a)
{
    static mill m;
    uint8_t wire[LOFT_FRAME_MAX];
    loft_job job;

    arb_mill(a, &m, &job);
    CHECK(all_answers(&m).frames == 1);
    const size_t n = loft_poll_encode(m.r.session, wire);
    for (size_t i = 0; i < n; i++)
        CHECK(loft_receiver_push(&m.r, wire[i]) == (i + 1 == n));
    CHECK(!loft_receiver_push(&m.r, 0) && m.r.dropped == 1);
    const answers all = all_answers(&m);
    CHECK(all.types == TYPE(LOFT_ACK) && all.ack.flags & LOFT_FLAG_NAK);
    CHECK(!loft_receiver_push(&m.r, 7) && !loft_receiver_push(&m.r, 0) && m.r.damaged == 1);
}

int main(void)
{
    PROPERTY(a_message_works_once_and_in_its_place, 1);
    PROPERTY(items_for_another_place_are_not_taken, 200);
    PROPERTY(answers_say_what_is, 50);
    PROPERTY(silence_where_nothing_is_asked, 5);
    PROPERTY(room_is_told_in_quarters, 20);
    PROPERTY(push_tells_when_a_frame_waits, 5);
    return check_failures();
}

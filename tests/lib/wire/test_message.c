/* tests/lib/wire/test_message.c -- properties of lib/wire/message.h
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "check.h"          /* CHECK, PROPERTY */
#include "wire/message.h"

static uint32_t arb_u32(arb *a)
{
    static const uint32_t edge[6] = { 0, 1, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu, 0x01020304u };
    return arb_below(a, 3) ? (uint32_t)arb_next(a) : edge[arb_below(a, 6)];
}

static uint16_t arb_u16(arb *a)     { return (uint16_t)arb_u32(a); }
static uint8_t  arb_u8(arb *a)      { return (uint8_t)arb_u32(a); }
static int32_t  arb_i32(arb *a)     { return (int32_t)arb_u32(a); }

static void arb_axes(arb *a, int32_t x[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = arb_i32(a);
}

static loft_ack arb_ack(arb *a)
{
    loft_ack m;
    m.next     = arb_u32(a);
    m.limit    = m.next + arb_below(a, 0xFFFFFFFFu - m.next);
    m.executed = m.next - arb_below(a, m.next < 0xFFFFFFFFu ? m.next + 1 : m.next);
    m.state    = (uint8_t)arb_below(a, LOFT_STATE_FAULT + 1);
    m.flags    = arb_u8(a);
    m.refusal  = arb_u8(a);
    m.control  = arb_u8(a);
    return m;
}

static bool same_ack(const loft_ack *a, const loft_ack *b)
{
    return a->next == b->next && a->limit == b->limit && a->executed == b->executed &&
           a->state == b->state && a->flags == b->flags && a->refusal == b->refusal &&
           a->control == b->control;
}

/* The content of the one frame in wire[0..size-1], which only a receiver that knows its seal can
 * take. */
static loft_frame sealed_content(const uint8_t wire[], size_t size, uint32_t seal)
{
    loft_frame f;
    loft_frame_init(&f);
    CHECK(size > 0 && size <= LOFT_FRAME_MAX);
    for (size_t i = 0; i + 1 < size; i++)
        CHECK(loft_frame_push(&f, wire[i]) == LOFT_MORE);
    CHECK(loft_frame_push(&f, wire[size - 1]) == (seal ? LOFT_ERR_DATA : LOFT_OK));
    CHECK(f.count > 0 && loft_frame_sealed(&f, seal) && !loft_frame_sealed(&f, seal ^ 1u) &&
          !loft_frame_sealed(&f, ~seal));
    return f;
}

static loft_frame content(const uint8_t wire[], size_t size)
{
    return sealed_content(wire, size, 0);
}

/* Run `decode` (a call with &f and m) on the content one byte shorter and one longer. */
#define REFUSES_OTHER_LENGTHS(f, call, may_grow)                                                   \
    do {                                                                                           \
        (f).count--;                                                                        \
        CHECK((call) == LOFT_ERR_DATA);                                                     \
        (f).count = (uint8_t)((f).count + 2);                                               \
        CHECK((call) == ((may_grow) ? LOFT_OK : LOFT_ERR_DATA));                            \
        (f).count--;                                                                        \
    } while (0)

#define IS(f, what, v, s)                                                                          \
    CHECK(loft_message_type(&(f)) == (what) && loft_message_version(&(f)) == (v) &&                \
          loft_message_session(&(f)) == (s))

static void greetings_come_back(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    loft_hello h, g;
    h.min_version = (uint8_t)arb_below(a, 8);
    h.max_version = (uint8_t)(h.min_version + arb_below(a, 8));
    h.nonce = arb_u32(a);
    const size_t n = loft_hello_encode(&h, wire);
    CHECK(n == 15 && wire[0] == 0);
    loft_frame f = content(wire, n);
    IS(f, LOFT_HELLO, 0, 0);
    CHECK(loft_hello_decode(&f, &g) == LOFT_OK);
    CHECK(g.min_version == h.min_version && g.max_version == h.max_version && g.nonce == h.nonce);
    REFUSES_OTHER_LENGTHS(f, loft_hello_decode(&f, &g), true);
    f.byte[2] = 2, f.byte[3] = 1;
    CHECK(loft_hello_decode(&f, &g) == LOFT_ERR_DATA);
}

static void welcomes_come_back(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const uint8_t session = arb_u8(a);
    loft_welcome m, g;
    m.version = arb_u8(a), m.nonce = arb_u32(a), m.boot = arb_u32(a), m.job = arb_u32(a),
    m.ack = arb_ack(a);
    m.axes = arb_u8(a), m.num = arb_u8(a), m.frame_max = arb_u8(a);
    m.queue = arb_u16(a), m.tick_hz = arb_u16(a), m.slots = arb_u16(a), m.kinds = arb_u8(a),
    m.curves = arb_u16(a), m.points = arb_u16(a), m.closed = arb_u16(a), m.outputs = arb_u8(a),
    m.columns = arb_u16(a);
    const size_t n = loft_welcome_encode(&m, session, wire);
    CHECK(n == 56);
    loft_frame f = content(wire, n);
    IS(f, LOFT_WELCOME, 0, session);
    CHECK(loft_welcome_decode(&f, &g) == LOFT_OK);
    CHECK(g.version == m.version && g.nonce == m.nonce && g.boot == m.boot && g.job == m.job &&
          same_ack(&g.ack, &m.ack));
    CHECK(g.axes == m.axes && g.num == m.num && g.frame_max == m.frame_max);
    CHECK(g.queue == m.queue && g.tick_hz == m.tick_hz && g.slots == m.slots &&
          g.kinds == m.kinds && g.curves == m.curves && g.points == m.points &&
          g.closed == m.closed && g.outputs == m.outputs && g.columns == m.columns);
    f.count = (uint8_t)(f.count - 2);                           /* of machines that do not say */
    CHECK(loft_welcome_decode(&f, &g) == LOFT_OK && g.outputs == m.outputs && g.columns == 0);
    f.count--;
    CHECK(loft_welcome_decode(&f, &g) == LOFT_OK && g.closed == m.closed && g.outputs == 0);
    f.count--;
    CHECK(loft_welcome_decode(&f, &g) == LOFT_ERR_DATA);
    f.count++;
    f.count = (uint8_t)(f.count - 2);
    CHECK(loft_welcome_decode(&f, &g) == LOFT_OK && g.points == m.points && g.closed == 0);
    f.count = (uint8_t)(f.count - 2);
    CHECK(loft_welcome_decode(&f, &g) == LOFT_OK && g.kinds == m.kinds && g.curves == m.curves &&
          g.points == m.queue);
    f.count = (uint8_t)(f.count - 3);
    CHECK(loft_welcome_decode(&f, &g) == LOFT_OK && g.slots == m.slots && g.kinds == 6 &&
          g.curves == 0 && g.points == m.queue);
    REFUSES_OTHER_LENGTHS(f, loft_welcome_decode(&f, &g), false);
}

static void axes_come_back(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const uint8_t session = arb_u8(a);
    loft_axis m, g;
    m.number = (uint8_t)arb_below(a, LOFT_AXES);
    m.steps_per_mm = arb_i32(a), m.max_speed = arb_i32(a), m.max_accel = arb_i32(a),
    m.position = arb_i32(a);
    m.start = arb_i32(a);
    const size_t n = loft_axis_encode(&m, session, wire);
    CHECK(n == 29);
    loft_frame f = content(wire, n);
    IS(f, LOFT_AXIS, LOFT_WIRE_VERSION, session);
    CHECK(loft_axis_decode(&f, &g) == LOFT_OK && g.number == m.number);
    CHECK(g.steps_per_mm == m.steps_per_mm && g.max_speed == m.max_speed);
    CHECK(g.max_accel == m.max_accel && g.position == m.position && g.start == m.start);
    REFUSES_OTHER_LENGTHS(f, loft_axis_decode(&f, &g), false);
    f.byte[2] = LOFT_AXES;
    CHECK(loft_axis_decode(&f, &g) == LOFT_ERR_DATA);
}

/* Any guard, or none. */
static loft_guard arb_guard(arb *a)
{
    loft_guard g = { 0, 0, 0 };

    if (arb_below(a, 2))
        return g;
    g.inputs = (uint16_t)(1 + arb_below(a, 65535));
    g.how = (uint8_t)arb_below(a, 16);
    g.filter = arb_u8(a);
    return g;
}

static void jobs_come_back(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const uint8_t session = arb_u8(a);
    loft_job m, g;
    m.nonce = arb_u32(a), m.id = arb_u32(a) | 1, m.kind = (uint8_t)(1 + arb_below(a, 2)),
    m.away = arb_u16(a);
    m.guard = arb_guard(a);
    arb_axes(a, m.start);
    const size_t n = loft_job_encode(&m, session, wire);
    CHECK(n == 19 + 4 * LOFT_AXES + (m.guard.inputs ? 4 : 0));
    loft_frame f = content(wire, n);
    IS(f, LOFT_JOB, LOFT_WIRE_VERSION, session);
    CHECK(loft_job_decode(&f, &g) == LOFT_OK && g.nonce == m.nonce && g.id == m.id &&
          g.kind == m.kind && g.away == m.away);
    CHECK(memcmp(g.start, m.start, sizeof g.start) == 0);
    CHECK(g.guard.inputs == m.guard.inputs && g.guard.how == m.guard.how &&
          g.guard.filter == m.guard.filter);
    if (m.guard.inputs) {
        f.byte[15] = (uint8_t)(16 + arb_below(a, 240));                         /* how */
        CHECK(loft_job_decode(&f, &g) == LOFT_ERR_DATA);
        f.byte[15] = m.guard.how;
        f.byte[13] = f.byte[14] = 0;                                            /* no inputs */
        CHECK(loft_job_decode(&f, &g) == LOFT_ERR_DATA);
        f = content(wire, loft_job_encode(&m, session, wire));
    }
    REFUSES_OTHER_LENGTHS(f, loft_job_decode(&f, &g), false);
    f.byte[10] = (uint8_t)((f.byte[10] & 128) | (arb_below(a, 2) ? 0 : 5 + arb_below(a, 123)));
    CHECK(loft_job_decode(&f, &g) == LOFT_ERR_DATA);
    m.id = 0;
    f = content(wire, loft_job_encode(&m, session, wire));
    CHECK(loft_job_decode(&f, &g) == LOFT_ERR_DATA);
}

static void jobs_of_curves_bring_their_limits(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    loft_job_limits l, k;
    loft_job m, g;

    m.nonce = arb_u32(a), m.id = arb_u32(a) | 1, m.kind = LOFT_CURVES,
    m.away = (uint16_t)arb_u32(a), m.limits = &l;
    m.guard = arb_guard(a);
    arb_axes(a, m.start);
    memset(&l, 0, sizeof l);
    memset(&k, 0, sizeof k);
    l.corner = arb_i32(a), l.tol = arb_i32(a);
    for (int i = 0; i < LOFT_AXES; i++)
        l.axis[i].max_speed = arb_i32(a), l.axis[i].max_accel = arb_i32(a),
        l.axis[i].max_jerk = arb_u32(a);
    const size_t n = loft_job_encode(&m, 9, wire);
    CHECK(n == 27 + 16 * LOFT_AXES + (m.guard.inputs ? 4 : 0));
    loft_frame f = content(wire, n);
    CHECK(loft_job_decode(&f, &g) == LOFT_OK && g.id == m.id && g.kind == LOFT_CURVES &&
          g.away == m.away && memcmp(g.start, m.start, sizeof g.start) == 0 &&
          g.guard.inputs == m.guard.inputs);
    CHECK(loft_job_limits_decode(&f, &k) == LOFT_OK && memcmp(&l, &k, sizeof l) == 0);
    REFUSES_OTHER_LENGTHS(f, loft_job_decode(&f, &g), false);
    REFUSES_OTHER_LENGTHS(f, loft_job_limits_decode(&f, &k), false);
    for (f.count = 2; f.count < n - LOFT_FRAME_EXTRA; f.count++)
        CHECK(loft_job_decode(&f, &g) == LOFT_ERR_DATA &&
              loft_job_limits_decode(&f, &k) == LOFT_ERR_DATA);
    m.kind = LOFT_SPANS;
    f = content(wire, loft_job_encode(&m, 9, wire));
    CHECK(loft_job_limits_decode(&f, &k) == LOFT_ERR_DATA);
}

static void short_ones_come_back(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const uint8_t session = arb_u8(a);
    const uint32_t total = arb_u32(a);
    loft_control m = { .number = arb_u8(a), .verb = (uint8_t)(1 + arb_below(a, 5)) }, g;
    uint32_t got;

    if (m.verb == LOFT_OVERRIDE)
        m.value = (uint8_t)(1 + arb_below(a, 200));
    size_t n = loft_end_encode(total, session, wire);
    CHECK(n == 12);
    loft_frame f = content(wire, n);
    IS(f, LOFT_END, LOFT_WIRE_VERSION, session);
    CHECK(loft_end_decode(&f, &got) == LOFT_OK && got == total);
    REFUSES_OTHER_LENGTHS(f, loft_end_decode(&f, &got), false);

    n = loft_control_encode(&m, session, wire);
    CHECK(n == 11);
    f = content(wire, n);
    IS(f, LOFT_CONTROL, LOFT_WIRE_VERSION, session);
    CHECK(loft_control_decode(&f, &g) == LOFT_OK && g.number == m.number && g.verb == m.verb &&
          g.value == m.value);
    REFUSES_OTHER_LENGTHS(f, loft_control_decode(&f, &g), false);
    f.byte[4] = (uint8_t)(m.verb == LOFT_OVERRIDE ? arb_below(a, 2) ? 0 : 201 + arb_below(a, 55)
                                                  : 1 + arb_below(a, 255));
    CHECK(loft_control_decode(&f, &g) == LOFT_ERR_DATA);
    f.byte[4] = m.value;
    f.byte[3] = (uint8_t)(arb_below(a, 2) ? 0 : 6 + arb_below(a, 250));
    CHECK(loft_control_decode(&f, &g) == LOFT_ERR_DATA);

    m.verb = (uint8_t)(LOFT_PLACE + arb_below(a, 3));
    m.value = (uint8_t)(1 + arb_below(a, (1u << LOFT_AXES) - 1));
    arb_axes(a, m.position);
    n = loft_control_encode(&m, session, wire);
    CHECK(n == 11 + 4 * LOFT_AXES);
    f = content(wire, n);
    CHECK(loft_control_decode(&f, &g) == LOFT_OK && g.verb == m.verb && g.value == m.value &&
          memcmp(g.position, m.position, sizeof g.position) == 0);
    REFUSES_OTHER_LENGTHS(f, loft_control_decode(&f, &g), false);
    f.byte[4] = (uint8_t)(arb_below(a, 2) ? 0 : (1u << LOFT_AXES) + arb_below(a, 100));
    CHECK(loft_control_decode(&f, &g) == LOFT_ERR_DATA);

    n = loft_poll_encode(session, wire);
    CHECK(n == 8);
    f = content(wire, n);
    IS(f, LOFT_POLL, LOFT_WIRE_VERSION, session);
}

static void answers_come_back(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const uint8_t session = arb_u8(a);
    const loft_ack m = arb_ack(a);
    loft_machine_status s, t;
    loft_ack g;

    size_t n = loft_ack_encode(&m, session, wire);
    CHECK(n == 24);
    loft_frame f = content(wire, n);
    IS(f, LOFT_ACK, LOFT_WIRE_VERSION, session);
    CHECK(loft_ack_decode(&f, &g) == LOFT_OK && same_ack(&g, &m));
    REFUSES_OTHER_LENGTHS(f, loft_ack_decode(&f, &g), false);

    s.ack = m;
    s.ticks = arb_u32(a), s.elapsed = arb_u32(a), s.slowed = arb_u32(a), s.damaged = arb_u32(a),
    s.dropped = arb_u32(a);
    s.override = arb_u8(a), s.closed = (uint16_t)arb_u32(a);
    arb_axes(a, s.position);
    n = loft_machine_status_encode(&s, session, wire);
    CHECK(n == 47 + 4 * LOFT_AXES);
    f = content(wire, n);
    IS(f, LOFT_STATUS, LOFT_WIRE_VERSION, session);
    CHECK(loft_machine_status_decode(&f, &t) == LOFT_OK && same_ack(&t.ack, &s.ack));
    CHECK(t.ticks == s.ticks && t.elapsed == s.elapsed && t.slowed == s.slowed);
    CHECK(t.damaged == s.damaged && t.dropped == s.dropped && t.override == s.override &&
          t.closed == s.closed && memcmp(t.position, s.position, sizeof t.position) == 0);
    REFUSES_OTHER_LENGTHS(f, loft_machine_status_decode(&f, &t), false);
}

/* A contradictory answer is not used. */
static void impossible_answers_are_refused(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const loft_ack good = { 1000, 1016, 990, LOFT_STATE_RUNNING, 0, 0, 0 };
    loft_ack m = good, g;
    switch (arb_below(a, 3)) {
    case 0: m.limit    = arb_below(a, 1000);                                       break;
    case 1: m.executed = 1001 + arb_below(a, 100000);                              break;
    case 2: m.state    = (uint8_t)(LOFT_STATE_FAULT + 1 + arb_below(a, 200));      break;
    }
    loft_frame f = content(wire, loft_ack_encode(&m, 1, wire));
    CHECK(loft_ack_decode(&f, &g) == LOFT_ERR_DATA);
    f = content(wire, loft_ack_encode(&good, 1, wire));
    CHECK(loft_ack_decode(&f, &g) == LOFT_OK);
}

static void reports_come_back(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const uint8_t session = arb_u8(a);
    loft_report m, g;
    m.job = arb_u32(a) | 1, m.items = arb_u32(a), m.ticks = arb_u32(a), m.elapsed = arb_u32(a),
    m.slowed = arb_u32(a);
    m.state = arb_below(a, 2) ? LOFT_STATE_DONE : LOFT_STATE_ABORTED;
    m.ended_by = (uint16_t)arb_u32(a);
    arb_axes(a, m.position);
    arb_axes(a, m.latched);
    m.guarded = arb_below(a, 2);
    const size_t n = loft_report_encode(&m, session, wire);
    CHECK(n == 31 + 4 * LOFT_AXES + (m.guarded ? 4 * LOFT_AXES : 0));
    loft_frame f = content(wire, n);
    IS(f, LOFT_REPORT, LOFT_WIRE_VERSION, session);
    CHECK(loft_report_decode(&f, &g) == LOFT_OK && g.job == m.job && g.items == m.items &&
          g.ticks == m.ticks);
    CHECK(g.elapsed == m.elapsed && g.slowed == m.slowed && g.state == m.state &&
          g.ended_by == m.ended_by);
    CHECK(memcmp(g.position, m.position, sizeof g.position) == 0 && g.guarded == m.guarded);
    if (m.guarded)
        CHECK(memcmp(g.latched, m.latched, sizeof g.latched) == 0);
    REFUSES_OTHER_LENGTHS(f, loft_report_decode(&f, &g), false);
    m.state = LOFT_STATE_RUNNING;
    f = content(wire, loft_report_encode(&m, session, wire));
    CHECK(loft_report_decode(&f, &g) == LOFT_ERR_DATA);
}

/* Items fill a frame up to the machine's size. The number of the first item is sent modulo
 * 65536. */
static void items_come_back(arb *a)
{
    const uint8_t frame_max = (uint8_t)(15 + 15 * LOFT_AXES +
                                        arb_below(a, 256 - 15 - 15 * LOFT_AXES));
    static const enum loft_message type[] = { [LOFT_SPANS] = LOFT_DATA_SPANS,
                                              [LOFT_POINTS] = LOFT_DATA_POINTS,
                                              [LOFT_POINTS_FINE] = LOFT_DATA_FINE,
                                              [LOFT_CURVES] = LOFT_DATA_CURVES };
    /* curves are data only of a machine that plans */
    const enum loft_kind kind = (enum loft_kind)(LOFT_SPANS +
                                                 arb_below(a, LOFT_MACHINE_PLANS ? 4 : 3));
    const uint32_t first = arb_u32(a);
    const int32_t start[LOFT_AXES] = { 0 };
    uint8_t wire[LOFT_FRAME_MAX];
    loft_predictor p;
    loft_unpacker u;
    loft_packer k;
    loft_item item = { 0 }, got;
    uint16_t number;

    loft_predictor_init(&p, start);
    loft_data_init(&k, kind, &p, frame_max, wire);
    item.ticks = 1;
    do
        for (int i = 0; i < LOFT_AXES; i++)
            item.p[2][i] = arb_i32(a);
    while (loft_packer_push(&k, &item) == LOFT_OK);
    CHECK(k.count >= 1);

    const uint32_t seal = loft_predictor_seal(&p);
    const size_t n = loft_data_encode(&k, first, seal, 9, wire);
    CHECK(n == 11u + k.size && n <= frame_max);
    loft_frame f = sealed_content(wire, n, seal);
    IS(f, type[kind], LOFT_WIRE_VERSION, 9);
    CHECK(loft_data_carried(&f));
    CHECK(loft_data_first(&f, &number) == LOFT_OK && loft_data_decode(&f, &u) == LOFT_OK &&
          number == (first & 0xFFFFu) && u.count == k.count);
    while (loft_unpacker_next(&u, &p, &got)) {
    }
    CHECK(memcmp(p.position, k.predictor.position, sizeof p.position) == 0);
    REFUSES_OTHER_LENGTHS(f, loft_data_decode(&f, &u), false);
    f.byte[4]++;                                                /* count */
    CHECK(loft_data_decode(&f, &u) == LOFT_ERR_DATA);
    for (f.count = 2; f.count <= 5; f.count++)
        CHECK(loft_data_decode(&f, &u) == LOFT_ERR_DATA);
}

int main(void)
{
    PROPERTY(greetings_come_back, 500);
    PROPERTY(welcomes_come_back, 500);
    PROPERTY(axes_come_back, 500);
    PROPERTY(jobs_come_back, 500);
    PROPERTY(jobs_of_curves_bring_their_limits, 500);
    PROPERTY(short_ones_come_back, 500);
    PROPERTY(answers_come_back, 500);
    PROPERTY(impossible_answers_are_refused, 300);
    PROPERTY(reports_come_back, 500);
    PROPERTY(items_come_back, 1000);
    return check_failures();
}

/* lib/wire/message.c -- every field of every message, in the order on the wire
 * SPDX-License-Identifier: MIT
 */
#include "wire/message.h"

/* The size of the limits in a JOB of curves, after `start_frame`. */
#define LIMITS_BYTES (8 + 12 * LOFT_AXES)

/* HELLO and WELCOME never change their layout, so they carry version 0. */
#define FOREVER 0


// Writing
// -------

/* A cursor in the frame being made. Content starts at wire[1]. */
typedef struct {
    uint8_t *wire;
    size_t size;
} writer;

static void put8(writer *w, uint8_t x)      { w->wire[++w->size] = x; }
static void put16(writer *w, uint16_t x)
{
    put8(w, (uint8_t)(x & 0xFFu));
    put8(w, (uint8_t)(x >> 8));
}
static void put32(writer *w, uint32_t x)
{
    put16(w, (uint16_t)(x & 0xFFFFu));
    put16(w, (uint16_t)(x >> 16));
}
static void put_axes(writer *w, const int32_t x[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        put32(w, (uint32_t)x[i]);
}

static writer start_frame(uint8_t wire[], enum loft_message type, uint8_t version, uint8_t session)
{
    writer w;
    w.wire = wire;
    w.size = 0;
    put8(&w, (uint8_t)((unsigned)type << 4 | version));
    put8(&w, session);
    return w;
}

static size_t finish_frame(const writer *w)       { return loft_frame_encode(w->wire, w->size); }


// Reading
// -------

/* A cursor in the content of a frame. A read beyond the end gives 0 and sets `bad`. */
typedef struct {
    const loft_frame *frame;
    uint8_t at;
    bool bad;
} reader;

static reader read_from(const loft_frame *f)
{
    reader r;
    r.frame = f;
    r.at    = 2;
    r.bad   = false;
    return r;
}

static uint8_t get8(reader *r)
{
    if (r->at >= r->frame->count) {
        r->bad = true;
        return 0;
    }
    return r->frame->byte[r->at++];
}

static uint16_t get16(reader *r)
{
    const uint16_t low = get8(r);
    return (uint16_t)(low | (unsigned)get8(r) << 8);
}
static uint32_t get32(reader *r)
{
    const uint32_t low = get16(r);
    return low | (uint32_t)get16(r) << 16;
}
static int32_t  get_i32(reader *r)
{
    const uint32_t x = get32(r);
    return x & 0x80000000u ? -(int32_t)~x - 1 : (int32_t)x;
}

static void get_axes(reader *r, int32_t x[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = get_i32(r);
}

static enum loft_status end_read(const reader *r, bool sound)
{
    return !r->bad && sound ? LOFT_OK : LOFT_ERR_DATA;
}

static enum loft_status end_read_all(const reader *r, bool sound)
{
    return end_read(r, sound && r->at == r->frame->count);
}


// Host to machine
// ---------------

size_t loft_hello_encode(const loft_hello *m, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire + 1, LOFT_HELLO, FOREVER, 0);
    put8(&w, m->min_version);
    put8(&w, m->max_version);
    put32(&w, m->nonce);
    wire[0] = 0;
    return 1 + finish_frame(&w);
}

/* It may grow in later versions, as WELCOME. */
enum loft_status loft_hello_decode(const loft_frame *f, loft_hello *m)
{
    reader r = read_from(f);
    m->min_version = get8(&r);
    m->max_version = get8(&r);
    m->nonce       = get32(&r);
    return end_read(&r, m->min_version <= m->max_version);
}

static void put_limits(writer *w, const loft_job_limits *m)
{
    put32(w, (uint32_t)m->corner);
    put32(w, (uint32_t)m->tol);
    for (int i = 0; i < LOFT_AXES; i++) {
        put32(w, (uint32_t)m->axis[i].max_speed);
        put32(w, (uint32_t)m->axis[i].max_accel);
        put32(w, m->axis[i].max_jerk);
    }
}

/* A bit of `kind`: a guard follows. */
#define GUARDED 0x80u

size_t loft_job_encode(const loft_job *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    const bool guarded = m->guard.inputs != 0;
    writer w = start_frame(wire, LOFT_JOB, LOFT_WIRE_VERSION, session);
    put32(&w, m->nonce);
    put32(&w, m->id);
    put8(&w, (uint8_t)(m->kind | (guarded ? GUARDED : 0)));
    put16(&w, m->away);
    if (guarded) {
        put16(&w, m->guard.inputs);
        put8(&w, m->guard.how);
        put8(&w, m->guard.filter);
    }
    put_axes(&w, m->start);
    if (m->kind == LOFT_CURVES)
        put_limits(&w, m->limits);
    return finish_frame(&w);
}

static reader read_job(const loft_frame *f, loft_job *m)
{
    reader r = read_from(f);
    m->nonce = get32(&r);
    m->id    = get32(&r);
    m->kind  = get8(&r);
    m->away  = get16(&r);
    m->guard.inputs = 0;
    m->guard.how = m->guard.filter = 0;
    if (m->kind & GUARDED) {
        m->kind = (uint8_t)(m->kind & ~GUARDED);
        m->guard.inputs = get16(&r);
        m->guard.how = get8(&r);
        m->guard.filter = get8(&r);
        if (m->guard.inputs == 0 || m->guard.how > (LOFT_GUARD_OPENS | LOFT_GUARD_EDGE |
                                                    LOFT_GUARD_HARD | LOFT_GUARD_SQUARE))
            r.bad = true;
    }
    get_axes(&r, m->start);
    m->limits = NULL;
    return r;
}

enum loft_status loft_job_decode(const loft_frame *f, loft_job *m)
{
    reader r = read_job(f, m);
    if (m->kind == LOFT_CURVES)
        r.at = (uint8_t)(r.at + LIMITS_BYTES);
    return end_read_all(&r, m->id != 0 && (m->kind == LOFT_SPANS || m->kind == LOFT_POINTS ||
                                           m->kind == LOFT_CURVES));
}

enum loft_status loft_job_limits_decode(const loft_frame *f, loft_job_limits *m)
{
    loft_job job;
    reader r = read_job(f, &job);
    m->corner = get_i32(&r);
    m->tol    = get_i32(&r);
    for (int i = 0; i < LOFT_AXES; i++) {
        m->axis[i].max_speed = get_i32(&r);
        m->axis[i].max_accel = get_i32(&r);
        m->axis[i].max_jerk  = get32(&r);
    }
    return end_read_all(&r, job.kind == LOFT_CURVES);
}

size_t loft_end_encode(uint32_t total, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_END, LOFT_WIRE_VERSION, session);
    put32(&w, total);
    return finish_frame(&w);
}

enum loft_status loft_end_decode(const loft_frame *f, uint32_t *total)
{
    reader r = read_from(f);
    *total = get32(&r);
    return end_read_all(&r, true);
}

size_t loft_control_encode(const loft_control *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_CONTROL, LOFT_WIRE_VERSION, session);
    put8(&w, m->number);
    put8(&w, m->verb);
    put8(&w, m->value);
    if (m->verb >= LOFT_PLACE)
        put_axes(&w, m->position);
    return finish_frame(&w);
}

enum loft_status loft_control_decode(const loft_frame *f, loft_control *m)
{
    reader r = read_from(f);
    m->number = get8(&r);
    m->verb   = get8(&r);
    m->value  = get8(&r);
    if (m->verb >= LOFT_PLACE) {
        get_axes(&r, m->position);
        return end_read_all(&r, m->verb <= LOFT_TABLE_HIGH && m->value >= 1 &&
                                    m->value < 1u << LOFT_AXES);
    }
    return end_read_all(&r, m->verb == LOFT_OVERRIDE
                                ? m->value >= 1 && m->value <= 200
                                : m->verb >= LOFT_HOLD && m->verb <= LOFT_CLOSE && m->value == 0);
}

size_t loft_poll_encode(uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_POLL, LOFT_WIRE_VERSION, session);
    return finish_frame(&w);
}

size_t loft_set_encode(const loft_set *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_SET, LOFT_WIRE_VERSION, session);
    put16(&w, m->at);
    for (uint8_t i = 0; i < m->count; i++)
        put8(&w, m->byte[i]);
    return finish_frame(&w);
}

enum loft_status loft_set_decode(const loft_frame *f, loft_set *m)
{
    reader r = read_from(f);
    m->at    = get16(&r);
    m->byte  = f->byte + r.at;
    m->count = (uint8_t)(f->count - r.at);
    return end_read(&r, m->count <= LOFT_KEPT_MOST);
}

/* The bytes before the items: type, session, first 2, count. */
#define ITEMS_AT 5

void loft_data_init(loft_packer *p, enum loft_kind kind, const loft_predictor *predictor,
                    uint8_t frame_max, uint8_t wire[LOFT_FRAME_MAX])
{
    const uint8_t most = frame_max < LOFT_FRAME_MAX ? frame_max : LOFT_FRAME_MAX;
    const uint8_t room = most > ITEMS_AT + LOFT_FRAME_EXTRA
                             ? (uint8_t)(most - ITEMS_AT - LOFT_FRAME_EXTRA)
                             : 0;
    loft_packer_init(p, kind, predictor, wire + 1 + ITEMS_AT, room);
}

/* Of each loft_kind, from 1 on; without designators, which g++ does not know. */
static const uint8_t message_of[LOFT_CURVES + 1] = { 0, LOFT_DATA_SPANS, LOFT_DATA_POINTS,
                                                     LOFT_DATA_FINE, LOFT_DATA_CURVES };

static enum loft_kind kind_of(enum loft_message type)
{
    return type == LOFT_DATA_SPANS    ? LOFT_SPANS
           : type == LOFT_DATA_POINTS ? LOFT_POINTS
           : type == LOFT_DATA_CURVES ? LOFT_CURVES
                                      : LOFT_POINTS_FINE;
}

bool loft_data_carried(const loft_frame *f)
{
    return loft_message_type(f) == message_of[kind_of(loft_message_type(f))];
}

size_t loft_data_encode(const loft_packer *p, uint32_t first, uint32_t seal, uint8_t session,
                        uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, (enum loft_message)message_of[p->kind], LOFT_WIRE_VERSION,
                           session);
    put16(&w, (uint16_t)(first & 0xFFFFu));
    put8(&w, p->count);
    return loft_frame_seal(w.wire, (size_t)(w.size + p->size), seal);
}

enum loft_status loft_data_first(const loft_frame *f, uint16_t *first)
{
    reader r = read_from(f);
    *first = get16(&r);
    return r.bad ? LOFT_ERR_DATA : LOFT_OK;
}

enum loft_status loft_data_decode(const loft_frame *f, loft_unpacker *u)
{
    reader r = read_from(f);
    (void)get16(&r);
    const uint8_t count = get8(&r);
    return r.bad ? LOFT_ERR_DATA
                 : loft_unpacker_init(u, kind_of(loft_message_type(f)), f->byte + ITEMS_AT,
                                      (uint8_t)(f->count - ITEMS_AT), count);
}


// Machine to host
// ---------------

static void put_ack(writer *w, const loft_ack *m)
{
    put32(w, m->next);
    put32(w, m->limit);
    put32(w, m->executed);
    put8(w, m->state);
    put8(w, m->flags);
    put8(w, m->refusal);
    put8(w, m->control);
}

static bool get_ack(reader *r, loft_ack *m)
{
    m->next     = get32(r);
    m->limit    = get32(r);
    m->executed = get32(r);
    m->state    = get8(r);
    m->flags    = get8(r);
    m->refusal  = get8(r);
    m->control  = get8(r);
    return m->limit >= m->next && m->executed <= m->next && m->state <= LOFT_STATE_FAULT;
}

size_t loft_ack_encode(const loft_ack *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_ACK, LOFT_WIRE_VERSION, session);
    put_ack(&w, m);
    return finish_frame(&w);
}

enum loft_status loft_ack_decode(const loft_frame *f, loft_ack *m)
{
    reader r = read_from(f);
    const bool sound = get_ack(&r, m);
    return end_read_all(&r, sound);
}

size_t loft_welcome_encode(const loft_welcome *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_WELCOME, FOREVER, session);
    put8(&w, m->version);
    put32(&w, m->nonce);
    put32(&w, m->boot);
    put32(&w, m->job);
    put_ack(&w, &m->ack);
    put8(&w, m->axes);
    put8(&w, m->num);
    put8(&w, m->frame_max);
    put16(&w, m->queue);
    put16(&w, m->tick_hz);
    put16(&w, m->slots);
    put8(&w, m->kinds);
    put16(&w, m->curves);
    put16(&w, m->points);
    put16(&w, m->closed);
    put8(&w, m->outputs);
    put16(&w, m->columns);
    return finish_frame(&w);
}

enum loft_status loft_welcome_decode(const loft_frame *f, loft_welcome *m)
{
    reader r = read_from(f);
    m->version = get8(&r);
    m->nonce   = get32(&r);
    m->boot    = get32(&r);
    m->job     = get32(&r);
    const bool sound = get_ack(&r, &m->ack);
    m->axes      = get8(&r);
    m->num       = get8(&r);
    m->frame_max = get8(&r);
    m->queue     = get16(&r);
    m->tick_hz   = get16(&r);
    m->slots     = get16(&r);
    m->kinds     = 1u << LOFT_SPANS | 1u << LOFT_POINTS;    /* if the machine does not say */
    m->curves    = 0;
    m->points    = m->queue;
    if (f->count > r.at) {
        m->kinds  = get8(&r);
        m->curves = get16(&r);
    }
    if (f->count > r.at)
        m->points = get16(&r);
    m->closed  = f->count > r.at ? get16(&r) : 0;
    m->outputs = f->count > r.at ? get8(&r) : 0;
    m->columns = f->count > r.at ? get16(&r) : 0;
    return end_read(&r, sound);
}

size_t loft_axis_encode(const loft_axis *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_AXIS, LOFT_WIRE_VERSION, session);
    put8(&w, m->number);
    put32(&w, (uint32_t)m->steps_per_mm);
    put32(&w, (uint32_t)m->max_speed);
    put32(&w, (uint32_t)m->max_accel);
    put32(&w, (uint32_t)m->position);
    put32(&w, (uint32_t)m->start);
    return finish_frame(&w);
}

enum loft_status loft_axis_decode(const loft_frame *f, loft_axis *m)
{
    reader r = read_from(f);
    m->number       = get8(&r);
    m->steps_per_mm = get_i32(&r);
    m->max_speed    = get_i32(&r);
    m->max_accel    = get_i32(&r);
    m->position     = get_i32(&r);
    m->start        = get_i32(&r);
    return end_read_all(&r, m->number < LOFT_AXES);
}

size_t loft_machine_status_encode(const loft_machine_status *m, uint8_t session,
                                  uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_STATUS, LOFT_WIRE_VERSION, session);
    put_ack(&w, &m->ack);
    put32(&w, m->ticks);
    put32(&w, m->elapsed);
    put32(&w, m->slowed);
    put32(&w, m->damaged);
    put32(&w, m->dropped);
    put8(&w, m->override);
    put16(&w, m->closed);
    put_axes(&w, m->position);
    return finish_frame(&w);
}

enum loft_status loft_machine_status_decode(const loft_frame *f, loft_machine_status *m)
{
    reader r = read_from(f);
    const bool sound = get_ack(&r, &m->ack);
    m->ticks   = get32(&r);
    m->elapsed = get32(&r);
    m->slowed  = get32(&r);
    m->damaged = get32(&r);
    m->dropped = get32(&r);
    m->override = get8(&r);
    m->closed  = get16(&r);
    get_axes(&r, m->position);
    return end_read_all(&r, sound);
}

size_t loft_report_encode(const loft_report *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_REPORT, LOFT_WIRE_VERSION, session);
    put32(&w, m->job);
    put32(&w, m->items);
    put32(&w, m->ticks);
    put32(&w, m->elapsed);
    put32(&w, m->slowed);
    put8(&w, m->state);
    put16(&w, m->ended_by);
    put_axes(&w, m->position);
    if (m->guarded)
        put_axes(&w, m->latched);
    return finish_frame(&w);
}

enum loft_status loft_report_decode(const loft_frame *f, loft_report *m)
{
    reader r = read_from(f);
    m->job     = get32(&r);
    m->items   = get32(&r);
    m->ticks   = get32(&r);
    m->elapsed = get32(&r);
    m->slowed  = get32(&r);
    m->state   = get8(&r);
    m->ended_by = get16(&r);
    get_axes(&r, m->position);
    m->guarded = f->count > r.at;
    if (m->guarded)
        get_axes(&r, m->latched);
    return end_read_all(&r, m->job != 0 &&
                                (m->state == LOFT_STATE_DONE || m->state == LOFT_STATE_ABORTED));
}

/* A bit of `origin` on the wire. */
#define BUSY 0x80u

size_t loft_kept_encode(const loft_kept *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX])
{
    writer w = start_frame(wire, LOFT_KEPT, LOFT_WIRE_VERSION, session);
    put16(&w, m->at);
    put16(&w, m->room);
    put8(&w, (uint8_t)(m->origin | (m->busy ? BUSY : 0)));
    for (uint8_t i = 0; i < m->count; i++)
        put8(&w, m->byte[i]);
    return finish_frame(&w);
}

enum loft_status loft_kept_decode(const loft_frame *f, loft_kept *m)
{
    reader r = read_from(f);
    m->at     = get16(&r);
    m->room   = get16(&r);
    m->origin = get8(&r);
    m->busy   = m->origin & BUSY;
    m->origin = (uint8_t)(m->origin & ~BUSY);
    m->count  = (uint8_t)(f->count - r.at);
    for (uint8_t i = 0; i < m->count && i < LOFT_KEPT_MOST; i++)
        m->byte[i] = get8(&r);
    return end_read_all(&r, m->count <= LOFT_KEPT_MOST && m->origin <= LOFT_SETTINGS_DAMAGED);
}

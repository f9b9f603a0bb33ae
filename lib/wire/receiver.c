/* lib/wire/receiver.c -- the machine's half of a session
 * SPDX-License-Identifier: MIT
 *
 * Exactly once: `next` is the number of the only item that is accepted, and it grows in the same
 * call that gives the item away. A frame that starts elsewhere is answered with `next` and dropped.
 * So a repeated frame has no effect, and a missing one is requested. Answers carry no changes, only
 * states (next, limit, number of the last control). So a lost or doubled answer does no harm.
 */
#include "wire/receiver.h"

/* due: */
#define DUE_ACK     1u
#define DUE_NAK     2u      /* with DUE_ACK: sets its flag */
#define DUE_STATUS  4u
#define DUE_REPORT  8u

enum loft_status loft_receiver_init(loft_receiver *r, const loft_machine_info *info)
{
    if (info->queue < 1 || info->tick_hz < 1 || info->slots < 1)
        return LOFT_ERR_ARG;

    loft_frame_init(&r->frame);
    r->info   = info;
    r->sessions = (uint8_t)(info->boot & 0xFFu);      /* differs from the numbers of the last run */
    r->session  = 0;
    r->nonce    = r->job = r->next = r->offered = r->damaged = r->dropped = 0;
    r->kind     = r->control = r->refusal = r->welcome = r->due = 0;
    r->fresh    = r->opened = r->ended = r->reported = false;
    r->unpacker.count = 0;
    return LOFT_OK;
}

static bool state_takes_items(uint8_t state)
{
    return state == LOFT_STATE_RUNNING || state == LOFT_STATE_HOLDING || state == LOFT_STATE_HELD;
}

static bool job_is_over(uint8_t state)
{
    return state == LOFT_STATE_DONE || state == LOFT_STATE_ABORTED;
}


// Bytes
// -----

static bool frame_is_ours(const loft_receiver *r)
{
    return loft_message_version(&r->frame) == LOFT_WIRE_VERSION && r->session != 0 &&
           loft_message_session(&r->frame) == r->session;
}

/* Count a damaged frame. */
static void count_damaged(loft_receiver *r)
{
    r->damaged++;
    if (r->session && r->job && !r->ended)
        r->due |= DUE_ACK | DUE_NAK;
}

bool loft_receiver_push(loft_receiver *r, uint8_t byte)
{
    if (r->fresh || r->unpacker.count > 0) {    /* the caller did not look: drop the rest */
        r->fresh = false;
        r->unpacker.count = 0;
        r->dropped++;
        r->due |= DUE_ACK | DUE_NAK;
    }
    switch (loft_frame_push(&r->frame, byte)) {
    case LOFT_OK: r->fresh = true; return true;
    case LOFT_ERR_DATA:
        if (r->frame.count > 0 && frame_is_ours(r) && loft_data_carried(&r->frame)) {
            /* it may be sealed: take_data decides */
            r->fresh = true;
            return true;
        }
        count_damaged(r);
        return false;
    default: return false;
    }
}


// Frames
// ------

static enum loft_event drop_frame(loft_receiver *r, unsigned due)
{
    r->dropped++;
    r->due = (uint8_t)(r->due | due);
    return LOFT_EVENT_NONE;
}

static enum loft_event refuse_frame(loft_receiver *r, enum loft_refusal refusal)
{
    r->refusal = (uint8_t)refusal;
    return drop_frame(r, DUE_ACK);
}

/* The same nonce again means the same connection: its WELCOME was lost. */
static enum loft_event take_hello(loft_receiver *r, const loft_snapshot *now)
{
    loft_hello m;
    if (loft_hello_decode(&r->frame, &m) != LOFT_OK)
        return drop_frame(r, 0);

    const bool common = m.min_version <= LOFT_WIRE_VERSION && m.max_version >= LOFT_WIRE_VERSION;
    if (!common) {
        r->session = 0;
    } else if (r->session == 0 || m.nonce != r->nonce) {
        if (++r->sessions == 0)
            r->sessions = 1;
        r->session = r->sessions;
        r->control = 0;
        r->refusal = LOFT_REFUSAL_NONE;
        r->opened  = loft_state_busy(now->state);
    }
    r->nonce   = m.nonce;
    r->welcome = common ? 1 + LOFT_AXES : 1;
    r->due     = 0;
    return LOFT_EVENT_NONE;
}

static enum loft_event take_job(loft_receiver *r, const loft_snapshot *now, loft_job *m)
{
    if (loft_job_decode(&r->frame, m) != LOFT_OK || m->nonce != r->nonce)
        return drop_frame(r, 0);
    if (m->id == r->job && (r->opened || now->state == LOFT_STATE_DONE))
        return drop_frame(r, DUE_ACK);                        /* the same JOB again, or job done */
    if (r->opened || loft_state_busy(now->state))
        return refuse_frame(r, LOFT_REFUSAL_BUSY);
    if (r->refusal != LOFT_REFUSAL_NONE)
        return drop_frame(r, DUE_STATUS);                /* refused stays refused in this session */
    if (now->state == LOFT_STATE_FAULT)
        return refuse_frame(r, LOFT_REFUSAL_FAULT);
    if (!(r->info->kinds & 1u << m->kind) ||
        (m->guard.inputs && !(r->info->kinds & LOFT_TAKES_GUARDS)))
        return refuse_frame(r, LOFT_REFUSAL_KIND);
    return LOFT_EVENT_JOB;
}

void loft_receiver_answer(loft_receiver *r, const loft_job *job, enum loft_refusal refusal)
{
    r->refusal = (uint8_t)refusal;
    r->due     = (uint8_t)(r->due | (refusal ? DUE_STATUS : DUE_ACK));
    if (refusal != LOFT_REFUSAL_NONE)
        return;
    r->job      = job->id;
    r->kind     = job->kind;
    r->next     = 0;
    r->offered     = 0;
    r->opened   = true;
    r->ended    = false;
    r->reported = false;
    for (int i = 0; i < LOFT_AXES; i++)
        r->start[i] = job->start[i];
    loft_predictor_init(&r->predictor, job->start);
}

/* The distance from `next` to the number whose low 16 bits are `first`. Windows are shorter than
 * 2^15 items. */
static int32_t items_ahead(const loft_receiver *r, uint16_t first)
{
    const uint16_t d = (uint16_t)(first - (uint16_t)(r->next & 0xFFFFu));
    return d < 0x8000u ? (int32_t)d : (int32_t)d - 0x10000;
}

static enum loft_event take_data(loft_receiver *r, const loft_snapshot *now)
{
    const enum loft_message type = loft_message_type(&r->frame);
    loft_unpacker u;
    uint16_t first;

    if (r->job == 0 || r->ended || !state_takes_items(now->state))
        return drop_frame(r, DUE_ACK);
    if (loft_data_first(&r->frame, &first) == LOFT_OK && items_ahead(r, first) != 0)
        return drop_frame(r, items_ahead(r, first) > 0 ? DUE_ACK | DUE_NAK : DUE_ACK);
    if (!loft_frame_sealed(&r->frame, loft_predictor_seal(&r->predictor))) {
        count_damaged(r);
        return LOFT_EVENT_NONE;
    }
    if (loft_data_decode(&r->frame, &u) != LOFT_OK)
        return refuse_frame(r, LOFT_REFUSAL_ITEM);
    if ((type == LOFT_DATA_SPANS) != (r->kind == LOFT_SPANS) ||
        (type == LOFT_DATA_CURVES) != (r->kind == LOFT_CURVES))
        return refuse_frame(r, LOFT_REFUSAL_KIND);
    if (u.count > now->room || u.count > 0xFFFFFFFFu - r->next)
        return drop_frame(r, DUE_ACK | DUE_NAK);

    r->unpacker = u;
    r->due |= DUE_ACK;
    return LOFT_EVENT_ITEMS;
}

static enum loft_event take_end(loft_receiver *r)
{
    uint32_t total;
    if (loft_end_decode(&r->frame, &total) != LOFT_OK || r->job == 0)
        return drop_frame(r, 0);
    if (total > r->next)
        return drop_frame(r, DUE_ACK | DUE_NAK);
    if (total < r->next)
        return refuse_frame(r, LOFT_REFUSAL_ITEM);

    r->due |= DUE_ACK;
    if (r->ended)
        return LOFT_EVENT_NONE;
    r->ended = true;
    return LOFT_EVENT_END;
}

/* Numbers count up, so that neither a repeated nor an overtaken control is executed. */
static enum loft_event take_control(loft_receiver *r, const loft_snapshot *now,
                                    loft_event_data *out)
{
    loft_control *m = &out->place;
    if (loft_control_decode(&r->frame, m) != LOFT_OK)
        return drop_frame(r, 0);
    const uint8_t newer = (uint8_t)(m->number - r->control);
    if (newer == 0 || newer >= 128)
        return drop_frame(r, DUE_ACK);

    r->control = m->number;
    r->due |= DUE_ACK;
    switch (m->verb) {
    case LOFT_HOLD:   return LOFT_EVENT_HOLD;
    case LOFT_RESUME: return LOFT_EVENT_RESUME;
    case LOFT_ABORT:  return LOFT_EVENT_ABORT;
    case LOFT_OVERRIDE: out->percent = m->value; return LOFT_EVENT_OVERRIDE;
    case LOFT_PLACE:
    case LOFT_TABLE_LOW:
    case LOFT_TABLE_HIGH:
        if (loft_state_busy(now->state) || now->state == LOFT_STATE_FAULT)
            return refuse_frame(r, LOFT_REFUSAL_BUSY);
        r->job = 0;
        return LOFT_EVENT_PLACE;
    default:
        if (!job_is_over(now->state))
            return LOFT_EVENT_NONE;
        r->job = 0;
        return LOFT_EVENT_CLOSE;
    }
}

static enum loft_event take_frame(loft_receiver *r, const loft_snapshot *now, loft_event_data *out)
{
    if (loft_message_type(&r->frame) == LOFT_HELLO)
        return take_hello(r, now);
    if (!frame_is_ours(r))
        return drop_frame(r, 0);

    switch (loft_message_type(&r->frame)) {
    case LOFT_JOB:          return take_job(r, now, &out->job);
    case LOFT_DATA_SPANS:
    case LOFT_DATA_POINTS:
    case LOFT_DATA_FINE:
    case LOFT_DATA_CURVES:  return take_data(r, now);
    case LOFT_END:          return take_end(r);
    case LOFT_CONTROL:      return take_control(r, now, out);
    case LOFT_POLL:
        r->due |= DUE_STATUS;
        if (job_is_over(now->state) && r->job)
            r->due |= DUE_REPORT;
        return LOFT_EVENT_NONE;
    case LOFT_SET:
        if (r->info->kinds & LOFT_TAKES_SETTINGS &&
            loft_set_decode(&r->frame, &out->set) == LOFT_OK)
            return LOFT_EVENT_SET;
        return drop_frame(r, 0);
    default: return drop_frame(r, 0);
    }
}

enum loft_event loft_receiver_next(loft_receiver *r, const loft_snapshot *now, loft_event_data *out)
{
    if (r->fresh) {
        r->fresh = false;
        const enum loft_event e = take_frame(r, now, out);
        if (e != LOFT_EVENT_NONE)
            return e;
    }
    if (!loft_unpacker_next(&r->unpacker, &r->predictor, &out->item))
        return LOFT_EVENT_NONE;
    r->next++;
    return LOFT_EVENT_ITEM;
}


// Answers
// -------

static uint32_t limit_of(const loft_receiver *r, const loft_snapshot *now)
{
    if (r->job == 0 || r->ended || !state_takes_items(now->state))
        return r->next;
    return now->room < 0xFFFFFFFFu - r->next ? r->next + now->room : 0xFFFFFFFFu;
}

static loft_ack ack_of(loft_receiver *r, const loft_snapshot *now)
{
    loft_ack a;
    a.next     = r->next;
    a.limit    = r->offered = limit_of(r, now);
    a.executed = now->executed;
    a.state    = now->state;
    a.flags = (uint8_t)((r->due & DUE_NAK ? LOFT_FLAG_NAK : 0) | (r->ended ? LOFT_FLAG_ENDED : 0) |
                        (now->starved ? LOFT_FLAG_STARVED : 0) |
                        (r->opened ? LOFT_FLAG_OPENED : 0) | (now->lost ? LOFT_FLAG_LOST : 0));
    a.refusal  = r->refusal;
    a.control  = r->control;
    r->due &= (uint8_t)~(DUE_ACK | DUE_NAK);
    return a;
}

static size_t give_welcome(loft_receiver *r, const loft_snapshot *now, uint8_t wire[])
{
    loft_welcome m;
    m.version   = r->session ? LOFT_WIRE_VERSION : 0;
    m.nonce     = r->nonce;
    m.boot      = r->info->boot;
    m.job       = r->job;
    m.ack       = ack_of(r, now);
    m.axes      = LOFT_AXES;
    m.num       = LOFT_NUM;
    m.frame_max = LOFT_FRAME_MAX;
    m.queue     = r->info->queue;
    m.tick_hz   = r->info->tick_hz;
    m.slots     = r->info->slots;
    m.kinds     = r->info->kinds;
    m.curves    = r->info->curves;
    m.points    = r->info->points;
    m.closed    = now->closed;
    m.outputs   = r->info->outputs;
    m.columns   = r->info->columns;
    return loft_welcome_encode(&m, r->session, wire);
}

static size_t give_axis(const loft_receiver *r, const loft_snapshot *now, uint8_t number,
                        uint8_t wire[])
{
    loft_axis m;
    m.number       = number;
    m.steps_per_mm = r->info->axis[number].steps_per_mm;
    m.max_speed    = r->info->axis[number].max_speed;
    m.max_accel    = r->info->axis[number].max_accel;
    m.position     = now->position[number];
    m.start        = r->job ? r->start[number] : 0;
    return loft_axis_encode(&m, r->session, wire);
}

static size_t give_status(loft_receiver *r, const loft_snapshot *now, uint8_t wire[])
{
    loft_machine_status m;
    m.ack     = ack_of(r, now);
    m.ticks   = now->ticks;
    m.elapsed = now->elapsed;
    m.slowed  = now->slowed;
    m.damaged = r->damaged;
    m.dropped = r->dropped;
    m.override = now->override;
    m.closed  = now->closed;
    for (int i = 0; i < LOFT_AXES; i++)
        m.position[i] = now->position[i];
    r->due &= (uint8_t)~DUE_STATUS;
    return loft_machine_status_encode(&m, r->session, wire);
}

static size_t give_report(loft_receiver *r, const loft_snapshot *now, uint8_t wire[])
{
    loft_report m;
    m.job     = r->job;
    m.items   = now->executed;
    m.ticks   = now->ticks;
    m.elapsed = now->elapsed;
    m.slowed  = now->slowed;
    m.state   = now->state;
    m.ended_by = now->ended_by;
    m.guarded = now->latched != NULL;
    for (int i = 0; i < LOFT_AXES; i++) {
        m.position[i] = now->position[i];
        m.latched[i] = m.guarded ? now->latched[i] : 0;
    }
    r->due &= (uint8_t)~DUE_REPORT;
    return loft_report_encode(&m, r->session, wire);
}

/* Room is reported a quarter of the queue at a time. So the host never waits for a report while the
 * queue is less than three quarters full, and it does not send frames of one item. */
static void note_changes(loft_receiver *r, const loft_snapshot *now)
{
    const loft_machine_info *t = r->info;
    const uint16_t most = r->kind == LOFT_CURVES   ? t->curves
                          : r->kind == LOFT_POINTS ? t->points
                                                   : t->queue;
    const uint32_t step = most < 4 ? 1 : most / 4u;

    if (limit_of(r, now) > r->offered && limit_of(r, now) - r->offered >= step)
        r->due |= DUE_ACK;
    if (job_is_over(now->state) && r->job && !r->reported) {
        r->due |= DUE_REPORT;
        r->reported = true;
    }
    if (!job_is_over(now->state))
        r->due &= (uint8_t)~DUE_REPORT;
}

size_t loft_receiver_poll(loft_receiver *r, const loft_snapshot *now, uint8_t wire[LOFT_FRAME_MAX])
{
    if (r->welcome > LOFT_AXES || (r->welcome && r->session == 0)) {
        r->welcome = r->session ? LOFT_AXES : 0;
        return give_welcome(r, now, wire);
    }
    if (r->welcome)
        return give_axis(r, now, (uint8_t)(LOFT_AXES - r->welcome--), wire);
    if (r->session == 0)
        return 0;

    note_changes(r, now);
    if (r->due & DUE_REPORT)
        return give_report(r, now, wire);
    if (r->due & DUE_STATUS)
        return give_status(r, now, wire);
    if (r->due & DUE_ACK) {
        const loft_ack m = ack_of(r, now);
        return loft_ack_encode(&m, r->session, wire);
    }
    return 0;
}

/* lib/wire/sender.c -- the host's half of a session: go back n; only the machine's count is valid
 * SPDX-License-Identifier: MIT
 *
 * After a NAK the host sends everything unacknowledged again. It does the same after a STATUS that
 * still lacks what was sent before the question. Silence alone causes no repetition: a busy machine
 * or computer answers late, and everything sent twice makes it later.
 */
#include "wire/sender.h"

#define CLOSE_TRIES   4

#define ALL_AXES    ((1u << LOFT_AXES) - 1u)

/* How much is left of `span` ms that began at `since`. */
static uint32_t time_left(uint32_t since, uint32_t span, uint32_t now)
{
    const uint32_t gone = now - since;
    return gone >= span ? 0 : span - gone;
}

static bool job_finished(const loft_sender *s)  { return s->phase >= LOFT_PHASE_DONE; }

/* The report has arrived and says how the job ended. */
static void conclude_job(loft_sender *s)
{
    s->phase = s->report.state == LOFT_STATE_DONE ? LOFT_PHASE_DONE : LOFT_PHASE_ABORTED;
}


// Beginning, and beginning again
// ------------------------------

static void greet_machine(loft_sender *s, uint32_t now)
{
    s->phase      = LOFT_PHASE_HELLO;
    s->nonce      = s->nonce * 1664525u + 1013904223u;
    s->session    = 0;
    s->hello_sent = s->greeted = false;
    s->heard      = now;
    loft_rto_reset(&s->rto);
}

void loft_sender_init(loft_sender *s, uint32_t nonce, uint32_t now_ms)
{
    *s = (loft_sender){ .phase = LOFT_PHASE_HELLO };
    s->nonce = nonce;
    loft_rto_init(&s->rto);
    loft_frame_init(&s->frame);
    greet_machine(s, now_ms);
}

static void start_stream(loft_sender *s)
{
    s->opened   = true;
    s->phase    = s->ack.next <= s->window.count ? LOFT_PHASE_STREAMING : LOFT_PHASE_LOST;
    s->polling  = false;
    s->doubt    = 0;
    loft_window_open(&s->window, s->ack.next, s->machine.frame_max);
    loft_rto_reset(&s->rto);
}

/* The machine and the job are known: choose the phase. */
static void join_job(loft_sender *s)
{
    const loft_welcome *w = &s->machine;
    const bool same = w->job == s->job.id && (!s->opened || w->boot == s->boot);

    s->job_sent = false;
    if (s->opened && !same)
        s->phase = LOFT_PHASE_LOST;
    else if (same &&
             (s->asked || loft_state_busy(w->ack.state) || w->ack.state == LOFT_STATE_DONE)) {
        s->resumed   = s->resumed   || (!s->asked && loft_state_busy(w->ack.state));
        s->collected = s->collected || (!s->asked && w->ack.state == LOFT_STATE_DONE);
        start_stream(s);
    } else if (loft_state_busy(w->ack.state))
        s->phase = LOFT_PHASE_BUSY;
    else if (w->ack.state == LOFT_STATE_FAULT)
        s->phase = LOFT_PHASE_LOST;
    else
        s->phase = s->aborting ? LOFT_PHASE_ABORTED : LOFT_PHASE_OPENING;
    s->boot = w->boot;
    s->job.nonce = s->nonce;
}

enum loft_status loft_sender_begin(loft_sender *s, const loft_job *job, uint32_t count,
                                   loft_item_source *source, void *context)
{
    if (s->phase != LOFT_PHASE_READY || job->id == 0 ||
        (job->kind != LOFT_SPANS && job->kind != LOFT_POINTS && job->kind != LOFT_CURVES) ||
        (job->kind == LOFT_CURVES && (!job->limits || s->machine.curves == 0)) ||
        (job->guard.inputs && !(s->machine.kinds & LOFT_TAKES_GUARDS)))
        return LOFT_ERR_ARG;
    s->job     = *job;
    loft_window_init(&s->window, job, count, source, context);
    s->began   = true;
    s->machine.ack = s->ack;        /* newer than that of the welcome */
    join_job(s);
    return LOFT_OK;
}

/* A machine that is beyond all items has another job with the same id. */
void loft_sender_extend(loft_sender *s, uint32_t known, uint32_t count)
{
    loft_window_extend(&s->window, known, count);
    if (s->phase == LOFT_PHASE_STREAMING && s->window.base > count)
        s->phase = LOFT_PHASE_LOST;
}

static void set_control(loft_sender *s, enum loft_verb verb)
{
    s->verb      = (uint8_t)verb;
    s->value     = verb == LOFT_OVERRIDE ? s->percent : verb >= LOFT_PLACE ? s->axes : 0;
    s->verb_sent = false;
    s->attempts  = 0;
    s->number++;
}

void loft_sender_override(loft_sender *s, unsigned percent)
{
    if (s->phase == LOFT_PHASE_CLOSING || job_finished(s))
        return;
    s->percent = (uint8_t)(percent < 1 ? 1 : percent > 200 ? 200 : percent);
    if (s->verb == 0 || s->verb == LOFT_OVERRIDE)
        set_control(s, LOFT_OVERRIDE);
}

static enum loft_status send_position(loft_sender *s, enum loft_verb verb, unsigned kind,
                                      uint8_t axes, const int32_t position[LOFT_AXES])
{
    if (s->phase != LOFT_PHASE_READY || !(s->machine.kinds & kind) || axes == 0 || axes > ALL_AXES)
        return LOFT_ERR_ARG;
    s->axes = axes;
    for (int i = 0; i < LOFT_AXES; i++)
        s->place[i] = position[i];
    set_control(s, verb);
    return LOFT_OK;
}

enum loft_status loft_sender_place(loft_sender *s, uint8_t axes, const int32_t position[LOFT_AXES])
{
    return send_position(s, LOFT_PLACE, LOFT_TAKES_PLACES, axes, position);
}

enum loft_status loft_sender_table(loft_sender *s, bool high, uint8_t axes,
                                   const int32_t position[LOFT_AXES])
{
    return send_position(s, high ? LOFT_TABLE_HIGH : LOFT_TABLE_LOW, LOFT_TAKES_TABLE, axes,
                         position);
}

enum loft_status loft_sender_set(loft_sender *s, uint16_t at, const uint8_t byte[], uint8_t count)
{
    if (s->phase != LOFT_PHASE_READY || !(s->machine.kinds & LOFT_TAKES_SETTINGS) || s->asking ||
        count > LOFT_KEPT_MOST)
        return LOFT_ERR_ARG;
    s->set.at    = at;
    s->set.count = count;
    for (uint8_t i = 0; i < count; i++)
        s->set_byte[i] = byte[i];
    s->asking   = true;
    s->set_sent = false;
    return LOFT_OK;
}

void loft_sender_control(loft_sender *s, enum loft_verb verb)
{
    if (s->phase == LOFT_PHASE_CLOSING || (job_finished(s) && s->phase != LOFT_PHASE_BUSY))
        return;
    if (verb == LOFT_ABORT && s->phase != LOFT_PHASE_BUSY) {
        s->aborting = true;
        if (s->began && !s->asked && s->phase == LOFT_PHASE_OPENING)
            s->phase = LOFT_PHASE_ABORTED;
    }
    set_control(s, verb);
}


// Frames from the machine
// -----------------------

static bool welcome_fits(const loft_welcome *w)
{
    return w->version == LOFT_WIRE_VERSION && w->axes == LOFT_AXES &&
           w->frame_max >= LOFT_WINDOW_MIN && w->queue > 0 && w->tick_hz > 0 && w->slots > 0;
}

static void take_welcome(loft_sender *s, uint32_t now)
{
    loft_welcome w;
    if (s->phase != LOFT_PHASE_HELLO || loft_welcome_decode(&s->frame, &w) != LOFT_OK ||
        w.nonce != s->nonce)
        return;
    if (!s->greeted || w.boot != s->machine.boot || loft_message_session(&s->frame) != s->session)
        s->seen = 0;                            /* otherwise a repeated WELCOME: an AXIS was lost */
    s->machine = w;
    s->closed  = w.closed;
    s->ack     = w.ack;
    s->session = loft_message_session(&s->frame);
    s->greeted = true;
    s->tried   = now;
    if (!welcome_fits(&w))
        s->phase = LOFT_PHASE_UNFIT;
}

/* The last AXIS completes the greeting. A control that was not acknowledged is sent again, because
 * it is a wish, not a step. */
static void take_axis(loft_sender *s, uint32_t now)
{
    loft_axis m;
    if (s->phase != LOFT_PHASE_HELLO || !s->greeted || loft_axis_decode(&s->frame, &m) != LOFT_OK)
        return;
    s->axis[m.number] = m;
    s->seen = (uint8_t)(s->seen | 1u << m.number);
    if (s->seen != ALL_AXES)
        return;

    s->number    = s->verb ? 1 : 0;
    s->verb_sent = s->set_sent = false;
    s->back      = s->polled = now - LOFT_RTO_MAX;
    s->phase     = LOFT_PHASE_READY;
    loft_rto_reset(&s->rto);
    if (s->began)
        join_job(s);
}

static void go_back(loft_sender *s, uint32_t now)
{
    loft_window_back(&s->window);
    s->doubt = 0;
    s->back  = s->tried = now;
}

static void advance_window(loft_sender *s, uint32_t now)
{
    uint32_t trip;

    s->doubt = 0;
    if (loft_window_take(&s->window, s->ack.next, now, &trip)) {
        loft_rto_take(&s->rto, trip);
        loft_rto_reset(&s->rto);
        s->rtt_ms = loft_rto_trip(&s->rto);
    }
    s->tried = now;
}

/* Handle an answer while items are sent. All frames in flight after a gap cause a NAK; one NAK per
 * round trip counts. */
static void take_progress(loft_sender *s, uint32_t now)
{
    if (s->ack.state == LOFT_STATE_FAULT) {
        s->phase = LOFT_PHASE_LOST;
        return;
    }
    if (s->ack.refusal && !s->aborting) {
        s->aborting = true;
        set_control(s, LOFT_ABORT);
    }
    if (s->ack.next > s->window.base)
        advance_window(s, now);
    const uint32_t once = s->rtt_ms ? s->rtt_ms : LOFT_RTO_FIRST / 4;
    if (s->ack.flags & LOFT_FLAG_NAK && (s->window.base < s->window.high || s->window.ended) &&
        now - s->back >= once) {
        s->naks++;
        loft_window_shrink(&s->window);
        go_back(s, now);
    }
}

static void take_place(loft_sender *s, const loft_ack *m)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (m->refusal == LOFT_REFUSAL_NONE && s->axes & 1u << i)
            s->axis[i].position = s->place[i];
}

static void take_ack(loft_sender *s, const loft_ack *m, uint32_t now)
{
    const bool streaming = s->phase == LOFT_PHASE_STREAMING;
    const uint32_t limit = s->ack.limit;

    if (streaming && (m->next < s->window.base || m->next > s->window.count))
        return;
    s->ack = *m;
    if (m->refusal)
        s->refusal = m->refusal;
    if (streaming && s->ack.limit < limit)      /* limits only grow; a lower one is old */
        s->ack.limit = limit;

    if (s->verb_sent && m->control == s->number) {
        if (s->verb == LOFT_OVERRIDE && s->value == s->percent)
            s->percent = 0;
        if (s->verb == LOFT_PLACE)
            take_place(s, m);
        s->verb = 0;
        s->verb_sent = false;
        if (s->percent && s->phase != LOFT_PHASE_CLOSING)
            set_control(s, LOFT_OVERRIDE);
    }
    if (streaming) {
        take_progress(s, now);
    } else if (s->phase == LOFT_PHASE_OPENING && s->job_sent) {
        if (m->flags & LOFT_FLAG_OPENED)
            start_stream(s);
        else if (m->refusal)
            s->phase = LOFT_PHASE_REFUSED;
        else if (s->aborting && s->verb == 0)
            s->phase = LOFT_PHASE_ABORTED;
    } else if (s->phase == LOFT_PHASE_CLOSING && (s->verb == 0 || m->state == LOFT_STATE_IDLE)) {
        conclude_job(s);
    }
}

/* True if an answer is due to something that could be sent again. */
static bool answer_is_due(const loft_sender *s)
{
    return s->phase == LOFT_PHASE_STREAMING && !s->aborting &&
           (s->window.base < s->window.send ||
            (s->window.ended && !(s->ack.flags & LOFT_FLAG_ENDED)));
}

/* The line keeps the order, so what was sent before the question and is still missing is lost. If
 * an earlier question was open, the first answer may belong to that one. */
static void take_status(loft_sender *s, const loft_machine_status *m, uint32_t now)
{
    s->status  = *m;
    s->closed  = m->closed;
    s->polling = false;
    take_ack(s, &m->ack, now);
    if (s->doubt > 0 && --s->doubt == 0 && answer_is_due(s))
        go_back(s, now);
}

static void take_report(loft_sender *s)
{
    loft_report m;
    if (s->phase != LOFT_PHASE_STREAMING || loft_report_decode(&s->frame, &m) != LOFT_OK ||
        m.job != s->job.id)
        return;
    s->report = m;
    s->phase  = LOFT_PHASE_CLOSING;
    set_control(s, LOFT_CLOSE);
}

/* The line keeps the order, so an answer to an earlier question is for another place. */
static void take_kept(loft_sender *s)
{
    loft_kept m;
    if (!s->asking || !s->set_sent || loft_kept_decode(&s->frame, &m) != LOFT_OK ||
        m.at != s->set.at)
        return;
    s->kept   = m;
    s->asking = false;
    loft_rto_reset(&s->rto);
}

static void take_frame(loft_sender *s, uint32_t now)
{
    loft_machine_status status;
    loft_ack ack;

    switch (loft_message_type(&s->frame)) {
    case LOFT_WELCOME: take_welcome(s, now); break;
    case LOFT_AXIS:    take_axis(s, now);    break;
    case LOFT_REPORT:  take_report(s);       break;
    case LOFT_KEPT:    take_kept(s);         break;
    case LOFT_ACK:
        if (s->phase != LOFT_PHASE_HELLO && loft_ack_decode(&s->frame, &ack) == LOFT_OK)
            take_ack(s, &ack, now);
        break;
    case LOFT_STATUS:
        if (s->phase != LOFT_PHASE_HELLO &&
            loft_machine_status_decode(&s->frame, &status) == LOFT_OK)
            take_status(s, &status, now);
        break;
    default: s->unknown++;
    }
}

bool loft_sender_push(loft_sender *s, uint8_t byte, uint32_t now_ms)
{
    const enum loft_status status = loft_frame_push(&s->frame, byte);
    if (status == LOFT_ERR_DATA)
        s->damaged++;
    if (status != LOFT_OK)
        return false;

    const bool welcome = loft_message_type(&s->frame) == LOFT_WELCOME;
    if (!welcome && (loft_message_version(&s->frame) != LOFT_WIRE_VERSION || s->session == 0 ||
                     loft_message_session(&s->frame) != s->session)) {
        s->unknown++;
        return false;
    }
    s->heard = now_ms;
    take_frame(s, now_ms);
    return true;
}


// Frames to the machine
// ---------------------

/* New items are sent a quarter of the machine's queue at a time. */
static bool can_send(const loft_sender *s)
{
    const loft_welcome *w = &s->machine;
    const uint16_t most = s->job.kind == LOFT_CURVES   ? w->curves
                          : s->job.kind == LOFT_POINTS ? w->points
                                                       : w->queue;

    return s->phase == LOFT_PHASE_STREAMING && !s->aborting &&
           loft_window_ready(&s->window, s->ack.limit, most < 4 ? 1 : most / 4u);
}

static bool can_end(const loft_sender *s)
{
    return s->phase == LOFT_PHASE_STREAMING && !s->aborting && s->window.send == s->window.count &&
           !s->window.ended && !(s->ack.flags & LOFT_FLAG_ENDED);
}

static size_t give_data(loft_sender *s, uint32_t now, uint8_t wire[])
{
    const bool   waited = answer_is_due(s), again = s->window.send < s->window.high;
    const size_t n      = loft_window_give(&s->window, s->ack.limit, s->session, now, wire);

    if (n == 0) {                       /* an item cannot be encoded: the job ends */
        s->refusal = LOFT_REFUSAL_ITEM;
        s->aborting = true;
        set_control(s, LOFT_ABORT);
        return 0;
    }
    s->tried   = waited ? s->tried : now;
    s->sent   += 1;
    s->resent += again;
    return n;
}

static size_t give_hello(loft_sender *s, uint32_t now, uint8_t wire[])
{
    loft_hello m;
    m.min_version = m.max_version = LOFT_WIRE_VERSION;
    m.nonce = s->nonce;
    if (s->hello_sent)
        loft_rto_back_off(&s->rto);
    s->hello_sent = true;
    s->tried = now;
    s->hellos++;
    return loft_hello_encode(&m, wire);
}

static size_t give_job(loft_sender *s, uint32_t now, uint8_t wire[])
{
    if (s->job_sent) {
        loft_rto_back_off(&s->rto);
        s->timeouts++;
    }
    s->job_sent = s->asked = true;
    s->tried = now;
    return loft_job_encode(&s->job, s->session, wire);
}

static size_t give_control(loft_sender *s, uint32_t now, uint8_t wire[])
{
    loft_control m;
    m.number = s->number;
    m.verb   = s->verb;
    m.value  = s->value;
    for (int i = 0; i < LOFT_AXES; i++)
        m.position[i] = s->place[i];
    s->verb_sent = true;
    s->verb_time = now;
    s->attempts++;
    return loft_control_encode(&m, s->session, wire);
}

static size_t give_set(loft_sender *s, uint32_t now, uint8_t wire[])
{
    if (s->set_sent)
        loft_rto_back_off(&s->rto);
    s->set_sent = true;
    s->tried    = now;
    s->set.byte = s->set_byte;
    return loft_set_encode(&s->set, s->session, wire);
}

/* After a silence start again. If the report is here, only the closing was not heard. */
static void check_silence(loft_sender *s, uint32_t now)
{
    if (s->phase == LOFT_PHASE_CLOSING && s->attempts >= CLOSE_TRIES &&
        time_left(s->verb_time, s->rto.ms, now) == 0)
        conclude_job(s);
    if (s->phase > LOFT_PHASE_HELLO && s->phase < LOFT_PHASE_CLOSING &&
        time_left(s->heard, LOFT_SENDER_SILENCE, now) == 0)
        greet_machine(s, now);
}

/* A job begins without earlier orders, so a hold or an override waits until the machine has the
 * JOB. */
static bool control_due(const loft_sender *s, uint32_t now)
{
    return s->verb && s->phase != LOFT_PHASE_HELLO &&
           !(s->phase == LOFT_PHASE_OPENING && (!s->job_sent || s->verb != LOFT_ABORT)) &&
           (!job_finished(s) || s->phase == LOFT_PHASE_BUSY) &&
           (!s->verb_sent || time_left(s->verb_time, s->rto.ms, now) == 0);
}

static bool set_due(const loft_sender *s, uint32_t now)
{
    return s->asking && s->phase == LOFT_PHASE_READY &&
           (!s->set_sent || time_left(s->tried, s->rto.ms, now) == 0);
}

/* An answer is overdue: ask what has arrived. */
static bool poll_due(loft_sender *s, uint32_t now)
{
    if (answer_is_due(s) && time_left(s->tried, s->rto.ms, now) == 0) {
        s->timeouts++;
        s->tried = now;
        loft_rto_back_off(&s->rto);
        if (s->doubt == 0)
            s->doubt = s->polling ? 2 : 1;
        return true;
    }
    return time_left(s->polled, LOFT_SENDER_POLL, now) == 0;
}

static size_t give_poll(loft_sender *s, uint32_t now, uint8_t wire[])
{
    s->polled  = now;
    s->polling = true;
    return loft_poll_encode(s->session, wire);
}

static size_t give_stream(loft_sender *s, uint32_t now, uint8_t wire[])
{
    if (can_send(s))
        return give_data(s, now, wire);
    if (can_end(s)) {
        if (!answer_is_due(s))
            s->tried = now;
        s->window.ended = true;
        return loft_end_encode(s->window.count, s->session, wire);
    }
    return 0;
}

size_t loft_sender_poll(loft_sender *s, uint32_t now_ms, uint8_t wire[LOFT_FRAME_MAX])
{
    check_silence(s, now_ms);
    if (s->phase == LOFT_PHASE_HELLO)
        return !s->hello_sent || time_left(s->tried, s->rto.ms, now_ms) == 0
                   ? give_hello(s, now_ms, wire)
                   : 0;
    if (control_due(s, now_ms))
        return give_control(s, now_ms, wire);
    if (job_finished(s))
        return 0;
    if (set_due(s, now_ms))
        return give_set(s, now_ms, wire);
    if (poll_due(s, now_ms))
        return give_poll(s, now_ms, wire);
    if (s->phase == LOFT_PHASE_OPENING && !s->aborting &&
        (!s->job_sent || time_left(s->tried, s->rto.ms, now_ms) == 0))
        return give_job(s, now_ms, wire);
    return s->phase == LOFT_PHASE_STREAMING ? give_stream(s, now_ms, wire) : 0;
}

uint32_t loft_sender_wait(const loft_sender *s, uint32_t now_ms)
{
    const uint32_t retry = time_left(s->tried, s->rto.ms, now_ms);
    uint32_t wait = time_left(s->polled, LOFT_SENDER_POLL, now_ms);

    if (s->phase == LOFT_PHASE_HELLO)
        return s->hello_sent ? retry : 0;
    if (control_due(s, now_ms) || set_due(s, now_ms) || can_send(s) || can_end(s) ||
        (s->phase == LOFT_PHASE_OPENING && !s->job_sent))
        return 0;
    if (job_finished(s))
        return LOFT_SENDER_POLL;
    if (s->verb_sent && time_left(s->verb_time, s->rto.ms, now_ms) < wait)
        wait = time_left(s->verb_time, s->rto.ms, now_ms);
    if ((answer_is_due(s) || (s->asking && s->phase == LOFT_PHASE_READY) ||
         (s->phase == LOFT_PHASE_OPENING && !s->aborting)) &&
        retry < wait)
        wait = retry;
    return time_left(s->heard, LOFT_SENDER_SILENCE, now_ms) < wait
               ? time_left(s->heard, LOFT_SENDER_SILENCE, now_ms)
               : wait;
}

uint32_t loft_sender_silence(const loft_sender *s, uint32_t now_ms) { return now_ms - s->heard; }

void loft_sender_hangup(loft_sender *s)
{
    if (s->phase == LOFT_PHASE_CLOSING)
        conclude_job(s);
}

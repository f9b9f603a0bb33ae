/* tests/support/line.h -- a serial line between a loft_sender and a loft_receiver, in virtual time,
 * with any faults
 * SPDX-License-Identifier: MIT
 *
 * Bytes come out in order, `delay` ms after they went in, unless a fault hits them. The machine
 * behind the receiver is the smallest one that obeys the contract. It checks each item that it gets
 * against the job.
 */
#ifndef LOFT_TESTS_LINE_H
#define LOFT_TESTS_LINE_H

#include <string.h>

#include "check.h"
#include "wire/session.h"

/* Per million bytes. */
typedef struct {
    uint32_t flip, drop, twice, insert, burst;
    uint32_t outage, outage_ms;     /* per million ms; the longest duration */
    uint32_t replay;                /* per million ms: an earlier frame is repeated */
} line_faults;

enum { LINE_ROOM = 1 << 14, LINE_FRAMES = 64 };

typedef struct {
    uint8_t  byte[LINE_ROOM];
    uint32_t due[LINE_ROOM];
    uint32_t in, out;
    uint8_t  out_frame[LOFT_FRAME_MAX];     /* what is being sent */
    size_t   out_size, out_at;
    uint8_t  past[LINE_FRAMES][LOFT_FRAME_MAX];
    uint8_t  past_size[LINE_FRAMES];
    uint32_t frames;
    uint32_t dead_until, burst_left;
    uint64_t clock;             /* when the last byte leaves the buffer, in bytes since the start */
    bool     dead;
} line;

static inline void line_carry(line *l, uint8_t byte, uint32_t due)
{
    if (l->in - l->out == LINE_ROOM)
        return;
    l->byte[l->in % LINE_ROOM] = byte;
    l->due[l->in++ % LINE_ROOM] = due;
}

static inline bool line_hit(arb *a, uint32_t per_million)
{
    return per_million && arb_below(a, 1000000) < per_million;
}

static inline void line_send(line *l, arb *a, const line_faults *f, uint8_t byte, uint32_t due)
{
    if (l->dead || line_hit(a, f->drop))
        return;
    if (line_hit(a, f->burst))
        l->burst_left = 2 + arb_below(a, 30);
    if (l->burst_left > 0) {
        l->burst_left--;
        byte = (uint8_t)(byte ^ arb_next(a));
    }
    if (line_hit(a, f->flip))
        byte = (uint8_t)(byte ^ 1u << arb_below(a, 8));
    if (line_hit(a, f->insert))
        line_carry(l, (uint8_t)arb_next(a), due);
    line_carry(l, byte, due);
    if (line_hit(a, f->twice))
        line_carry(l, byte, due);
}

static inline void line_remember(line *l)
{
    const uint32_t slot = l->frames++ % LINE_FRAMES;
    l->past_size[slot] = (uint8_t)l->out_size;
    memcpy(l->past[slot], l->out_frame, l->out_size);
}

static inline void line_trouble(line *l, arb *a, const line_faults *f, uint32_t now)
{
    if (l->dead && (int32_t)(now - l->dead_until) >= 0)
        l->dead = false;
    if (line_hit(a, f->outage)) {
        l->dead = true;
        l->dead_until = now + 1 + arb_below(a, f->outage_ms);
    }
    if (l->frames && line_hit(a, f->replay)) {
        const uint32_t slot = arb_below(a, l->frames < LINE_FRAMES ? l->frames : LINE_FRAMES);
        for (uint32_t i = 0; i < l->past_size[slot]; i++)
            line_carry(l, l->past[slot][i], now);
        line_carry(l, 0, now);
    }
}


// The machine
// -----------

typedef struct {
    loft_machine_info   info;
    loft_receiver r;
    loft_snapshot now;
    uint32_t queued, ended, stop_at, wake;
    uint32_t period;                /* ms per item; 0: immediate */
    enum loft_refusal refuses;
    uint32_t jobs, ends, holds, resumes, aborts, closes, overrides, places;        /* events */
    int32_t place[LOFT_AXES];
    uint32_t told;                  /* highest limit that was sent */
    uint32_t delivered;             /* items, counted here and not by the receiver */
    uint32_t sloppy;                /* per million: fails to drain a frame */
} mill;

static inline void mill_init(mill *m, uint32_t boot, uint16_t queue, uint32_t period)
{
    memset(m, 0, sizeof *m);
    m->info.boot    = boot;
    m->info.queue   = queue;
    m->info.tick_hz = 1000;
    m->info.slots   = 40;
    m->info.curves  = m->info.points = queue;
    m->info.kinds   = 1u << LOFT_SPANS | 1u << LOFT_POINTS | 1u << LOFT_CURVES;
    for (int i = 0; i < LOFT_AXES; i++) {
        m->info.axis[i].steps_per_mm = (80 + i) * 65536;
        m->info.axis[i].max_speed    = 200 * 65536;
        m->info.axis[i].max_accel    = 2000 * 65536;
    }
    m->period   = period;
    m->now.room = queue;
    memset(&m->r, 0xA5, sizeof m->r);
    CHECK(loft_receiver_init(&m->r, &m->info) == LOFT_OK);
}

/* Item n of the job with this id: different for every n and id. */
static inline void job_item(uint32_t id, enum loft_kind kind, uint32_t n, loft_item *out)
{
    arb a = arb_start(((uint64_t)id << 32) + n);
    memset(out, 0, sizeof *out);
    out->ticks = kind == LOFT_POINTS ? 1 : (uint16_t)(1 + arb_below(&a, 50));
    for (int k = kind == LOFT_POINTS ? 2 : 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            out->p[k][i] = (int32_t)(3 * n + (uint32_t)k) * (kind == LOFT_POINTS ? 1 : 900) *
                               (i + 1) +
                           (int32_t)arb_below(&a, n % 40 == 0           ? 100000
                                                  : kind == LOFT_POINTS ? 3
                                                                        : 60);
}

static inline void mill_item(mill *m, const loft_item *got)
{
    loft_item want;
    job_item(m->r.job, (enum loft_kind)m->r.kind, m->delivered, &want);
    CHECK(want.ticks == got->ticks && memcmp(want.p, got->p, sizeof want.p) == 0);
    CHECK(m->queued < m->info.queue);
    CHECK(m->now.state == LOFT_STATE_RUNNING || m->now.state == LOFT_STATE_HELD);
    m->delivered++;
    m->queued++;
}

static inline void mill_job(mill *m, const loft_job *job, uint32_t now)
{
    loft_receiver_answer(&m->r, job, m->refuses);
    if (m->refuses)
        return;
    m->jobs++;
    m->delivered = m->queued = m->ended = m->told = 0;
    m->now.executed = m->now.ticks = 0;
    m->now.state = LOFT_STATE_RUNNING;
    m->wake = now;
}

static inline void mill_act(mill *m, enum loft_event e, const loft_event_data *data, uint32_t now)
{
    switch (e) {
    case LOFT_EVENT_JOB:  mill_job(m, &data->job, now); break;
    case LOFT_EVENT_ITEM: mill_item(m, &data->item);     break;
    case LOFT_EVENT_END:
        m->ended = 1;
        m->ends++;
        break;
    case LOFT_EVENT_HOLD:
        m->holds++;
        if (m->now.state == LOFT_STATE_RUNNING)
            m->now.state = LOFT_STATE_HELD;
        break;
    case LOFT_EVENT_RESUME:
        m->resumes++;
        if (m->now.state == LOFT_STATE_HELD)
            m->now.state = LOFT_STATE_RUNNING;
        break;
    case LOFT_EVENT_ABORT:
        m->aborts++;
        if (loft_state_busy(m->now.state)) {
            m->now.state = LOFT_STATE_STOPPING;
            m->stop_at = now + 30;
        }
        break;
    case LOFT_EVENT_OVERRIDE:
        m->overrides++;
        m->now.override = data->percent;
        break;
    case LOFT_EVENT_PLACE:
        m->places++;
        memcpy(m->place, data->place.position, sizeof m->place);
        break;
    case LOFT_EVENT_CLOSE:
        m->closes++;
        m->now.state = LOFT_STATE_IDLE;
        break;
    default: break;
    }
}

static inline void mill_byte(mill *m, arb *a, uint8_t byte, uint32_t now)
{
    loft_event_data data;
    enum loft_event e;
    if (!loft_receiver_push(&m->r, byte))
        return;
    m->now.room = (uint16_t)(m->info.queue - m->queued);
    const loft_snapshot before = m->now;
    while ((e = loft_receiver_next(&m->r, &before, &data)) != LOFT_EVENT_NONE) {
        mill_act(m, e, &data, now);
        if (line_hit(a, m->sloppy))
            return;
    }
}

/* One ms of work. */
static inline void mill_run(mill *m, uint32_t now)
{
    if (m->now.state == LOFT_STATE_RUNNING && m->queued > 0 &&
        (m->period == 0 || (int32_t)(now - m->wake) >= 0)) {
        const uint32_t n = m->period == 0 ? m->queued : 1;
        m->queued -= n;
        m->now.executed += n;
        m->now.ticks += n;
        m->wake = now + m->period;
    }
    if (m->now.state == LOFT_STATE_RUNNING && m->ended && m->queued == 0)
        m->now.state = LOFT_STATE_DONE;
    if (m->now.state == LOFT_STATE_STOPPING && (int32_t)(now - m->stop_at) >= 0) {
        m->queued = 0;
        m->now.state = LOFT_STATE_ABORTED;
    }
    m->now.room = (uint16_t)(m->info.queue - m->queued);
    m->now.starved = m->now.state == LOFT_STATE_RUNNING && m->queued == 0;
    m->now.elapsed++;
}


// Both, and the line between
// --------------------------

typedef struct {
    arb        *a;
    uint32_t    now, delay, rate;           /* ms, ms, bytes per ms */
    line_faults faults;
    line        down, up;
    loft_sender s;
    mill        m;
    loft_job    job;
    uint32_t    count, bytes, steps;        /* bytes: sent by the host */
    bool        begun;
    bool        buffered;                   /* something accepts all bytes at once and passes them
                                             * on as fast as the line can */
    uint32_t    asleep, frozen;             /* ms in which the host does not run; in which the line
                                             * passes nothing */
} world;

static const loft_job_limits world_limits;

static inline void world_source(void *context, uint32_t index, loft_item *out)
{
    const world *w = context;
    CHECK(index < w->count);
    job_item(w->job.id, (enum loft_kind)w->job.kind, index, out);
}

static inline void world_dial(world *w)
{
    w->down.out_size = w->down.out_at = 0;          /* a half-sent frame stays half sent */
    w->begun = false;
    loft_sender_init(&w->s, (uint32_t)arb_next(w->a), w->now);
}

static inline void world_init(world *w, arb *a, uint16_t queue, uint32_t period, uint32_t count)
{
    memset(w, 0, sizeof *w);
    w->a     = a;
    w->now   = arb_below(a, 4) ? (uint32_t)arb_next(a) : 0xFFFFFFFFu - arb_below(a, 2000);
    w->delay = 2;
    w->rate  = 11;
    w->count = count;
    w->job.id   = 1 + arb_below(a, 0xFFFFFFFEu);
    w->job.kind = (uint8_t)(arb_below(a, 2)   ? LOFT_SPANS
                            : arb_below(a, 3) ? LOFT_POINTS
                                              : LOFT_CURVES);
    w->job.limits = &world_limits;
    for (int i = 0; i < LOFT_AXES; i++)
        w->job.start[i] = arb_raw(a, 5000);
    mill_init(&w->m, (uint32_t)arb_next(a), queue, period);
    world_dial(w);
}

static inline void world_down(world *w)
{
    line *l = &w->down;
    for (uint32_t i = 0; i < (w->buffered ? 100000 : w->rate); i++) {
        if (l->out_at == l->out_size) {
            l->out_at = 0;
            l->out_size = loft_sender_poll(&w->s, w->now, l->out_frame);
            CHECK(l->out_size <= LOFT_FRAME_MAX);
            CHECK(l->out_size == 0 || l->out_frame[l->out_size - 1] == 0);
            CHECK(w->s.phase != LOFT_PHASE_STREAMING || w->s.window.send <= w->m.told ||
                  w->s.window.high == w->s.window.base);
            if (l->out_size == 0)
                return;
            line_remember(l);
        }
        if (l->clock < (uint64_t)w->steps * w->rate)
            l->clock = (uint64_t)w->steps * w->rate;
        l->clock++;
        line_send(l, w->a, &w->faults, l->out_frame[l->out_at++],
                  w->now + w->delay +
                      (w->buffered ? (uint32_t)(l->clock / w->rate) - w->steps : 0));
        w->bytes++;
    }
}

static inline void world_up(world *w)
{
    line *l = &w->up;
    for (uint32_t i = 0; i < w->rate; i++) {
        if (l->out_at == l->out_size) {
            l->out_at = 0;
            l->out_size = loft_receiver_poll(&w->m.r, &w->m.now, l->out_frame);
            if (w->m.told < w->m.r.offered)
                w->m.told = w->m.r.offered;
            if (l->out_size == 0)
                return;
            line_remember(l);
        }
        line_send(l, w->a, &w->faults, l->out_frame[l->out_at++], w->now + w->delay);
    }
}

static inline bool line_ready(const line *l, uint32_t now)
{
    return l->out != l->in && (int32_t)(now - l->due[l->out % LINE_ROOM]) >= 0;
}

/* One ms. */
static inline void world_step(world *w)
{
    line_trouble(&w->down, w->a, &w->faults, w->now);
    line_trouble(&w->up, w->a, &w->faults, w->now);
    if (w->frozen > 0)
        w->frozen--;
    while (w->frozen == 0 && line_ready(&w->down, w->now))
        mill_byte(&w->m, w->a, w->down.byte[w->down.out++ % LINE_ROOM], w->now);
    mill_run(&w->m, w->now);
    if (w->asleep > 0)
        w->asleep--;
    while (w->asleep == 0 && w->frozen == 0 && line_ready(&w->up, w->now))
        loft_sender_push(&w->s, w->up.byte[w->up.out++ % LINE_ROOM], w->now);
    if (w->s.phase == LOFT_PHASE_READY) {
        CHECK(!w->begun);                   /* only once, even if the line was silent for long */
        CHECK(loft_sender_begin(&w->s, &w->job, w->count, world_source, w) == LOFT_OK);
        w->begun = true;
    }
    CHECK(w->s.window.flights <= LOFT_WINDOW_FRAMES);
    CHECK(w->s.window.base <= w->s.window.send && w->s.window.send <= w->s.window.high &&
          w->s.window.high <= w->count);
    if (w->asleep == 0)
        world_down(w);
    world_up(w);
    w->now++;
    CHECK(++w->steps < 2000000);            /* half an hour is never needed */
}

/* Run until the sender has finished, or until `ms` have passed. */
static inline bool world_run(world *w, uint32_t ms)
{
    while (ms-- > 0 && w->s.phase < LOFT_PHASE_DONE && !check_bad)
        world_step(w);
    return w->s.phase >= LOFT_PHASE_DONE;
}

/* Run until `phase`, or until `ms` have passed. */
static inline bool world_until(world *w, enum loft_phase phase, uint32_t ms)
{
    while (ms-- > 0 && w->s.phase != phase && w->s.phase < LOFT_PHASE_DONE && !check_bad)
        world_step(w);
    return w->s.phase == phase;
}

#endif

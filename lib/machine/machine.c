/* lib/machine/machine.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/machine.h"

/* Keep the variables of such a function off the stack of its caller, which calls deep functions. */
#if defined(__GNUC__)
#  define APART __attribute__((noinline))
#else
#  define APART
#endif

/* The machine cannot execute the item, or the receiver saw room where there is none. The item is
 * already counted as taken, so the job ends here, on the path. */
static void give_up_job(loft_machine *m, enum loft_refusal refusal)
{
    loft_drive_abort(&m->drive);
    loft_receiver_answer(&m->receiver, NULL, refusal);
}

/* A job that is over or being aborted ignores its items. */
static void queue_item(loft_machine *m, const loft_item *item)
{
    if (m->drive.active && !m->drive.abort && !loft_drive_inside(&m->drive, item))
        give_up_job(m, LOFT_REFUSAL_TABLE);
    else if (loft_drive_push(&m->drive, item) != LOFT_OK)
        give_up_job(m, LOFT_REFUSAL_ITEM);
}


// Planning
// --------

#if LOFT_MACHINE_PLANS

static enum loft_status init_planner(loft_machine *m, loft_machine_config *config)
{
    m->planner = config->planner;
    if (!m->planner)
        return LOFT_OK;
    config->info.kinds = (uint8_t)(config->info.kinds | 1u << LOFT_CURVES);
    config->info.curves = config->plan.move_room;
    config->info.columns = config->plan.patches ? config->plan.patches->columns : 0;
    return loft_planner_init(m->planner, &config->plan, config->cells);
}

/* True if the job, under way or over, is one of curves. */
static bool job_has_curves(const loft_machine *m)        { return m->job.kind == LOFT_CURVES; }

static enum loft_status begin_planner(loft_machine *m, const loft_job *job)
{
    loft_job_limits asked;
    const enum loft_status status = loft_job_limits_decode(&m->receiver.frame, &asked);
    return status == LOFT_OK ? loft_planner_begin(m->planner, &m->config->info, &asked, job->start)
                             : status;
}

/* Queue items are spans, job items are curves. */
static void count_curves(loft_machine *m, loft_snapshot *now)
{
    now->room     = loft_planner_room(m->planner);
    now->executed = now->state == LOFT_STATE_DONE
                        ? m->planner->taken
                        : loft_planner_executed(m->planner, now->executed);
}

static enum loft_refusal take_curve(loft_machine *m, const loft_item *item)
{
    return m->drive.active && !m->drive.abort ? loft_planner_push(m->planner, item)
                                              : LOFT_REFUSAL_NONE;
}

static enum loft_refusal end_planner(loft_machine *m) { return loft_planner_end(m->planner); }

bool loft_machine_plan(loft_machine *m)
{
    loft_drive *d = &m->drive;
    loft_item span;

    if (!job_has_curves(m) || !d->active || d->abort || d->ended || loft_queue_room(&d->queue) == 0)
        return false;
    if (loft_planner_next(m->planner, loft_queue_room(&d->queue) > d->queue.count / 2, &span)) {
        queue_item(m, &span);
        return true;
    }
    if (loft_planner_failed(m->planner))
        give_up_job(m, LOFT_REFUSAL_PATCH);
    else if (loft_planner_done(m->planner))
        loft_drive_end(d);
    return loft_planner_busy(m->planner);
}

#else

static enum loft_status init_planner(loft_machine *m, loft_machine_config *config)
{
    (void)m;
    (void)config;
    return LOFT_OK;
}

static bool job_has_curves(const loft_machine *m)
{
    (void)m;
    return false;
}
static enum loft_status begin_planner(loft_machine *m, const loft_job *job)
{
    (void)m;
    (void)job;
    return LOFT_ERR_ARG;
}
static void count_curves(loft_machine *m, loft_snapshot *now)
{
    (void)m;
    (void)now;
}
static enum loft_refusal take_curve(loft_machine *m, const loft_item *item)
{
    (void)m;
    (void)item;
    return LOFT_REFUSAL_KIND;
}
static enum loft_refusal end_planner(loft_machine *m)
{
    (void)m;
    return LOFT_REFUSAL_NONE;
}
bool loft_machine_plan(loft_machine *m)
{
    (void)m;
    return false;
}

#endif


// Main loop
// ---------

enum loft_status loft_machine_init(loft_machine *m, loft_machine_config *config)
{
    loft_drive_config drive;

    m->config = config;
    m->set.session = 0;
    if (config->settings.get)
        loft_settings_init(&config->settings, config->info.axis);
    for (int i = 0; i < LOFT_AXES; i++)
        drive.position[i] = config->position[i];
    drive.axis = m->config->info.axis;
    drive.tick_hz = config->info.tick_hz;
    drive.slots = config->info.slots;
    drive.ramp = config->ramp;
    drive.cell = config->cell;
    drive.cells = config->cells;
    drive.outputs = config->info.outputs;

    config->info.queue  = config->cells;
    config->info.points = loft_points_capacity(config->cells);
    config->info.kinds  = (uint8_t)(1u << LOFT_SPANS | 1u << LOFT_POINTS | LOFT_TAKES_PLACES |
                                   LOFT_TAKES_TABLE |
                                   (config->settings.get ? LOFT_TAKES_SETTINGS : 0) |
                                   (LOFT_MACHINE_OUTPUTS ? LOFT_TAKES_ACTIONS : 0) |
                                   (config->senses ? LOFT_TAKES_GUARDS : 0));
    config->info.curves = config->info.columns = 0;
    m->job.kind = LOFT_SPANS;
    m->job.id = m->job.away = 0;
    m->closed = m->ended_by = 0;
    m->guard_ended = m->lost = 0;
    loft_latch_init(&m->latch);
    enum loft_status status = init_planner(m, config);
    if (status == LOFT_OK)
        status = loft_receiver_init(&m->receiver, &m->config->info);
    return status == LOFT_OK ? loft_drive_init(&m->drive, &drive) : status;
}

/* An input ends the job. */
static void note_end(loft_machine *m, uint16_t why)
{
    m->ended_by = why;
    loft_receiver_answer(&m->receiver, NULL, LOFT_REFUSAL_INPUT);
}

/* A guard that came true was noted before the drive could stop. */
static void take_snapshot(loft_machine *m, loft_snapshot *now)
{
    const loft_drive_report r = loft_drive_poll(&m->drive);

    if (m->guard_ended) {
        m->guard_ended = 0;
        note_end(m, m->guarded);
    }
    now->executed = r.executed;
    now->ticks = r.ticks;
    now->elapsed = r.elapsed;
    now->slowed = r.slowed;
    for (int i = 0; i < LOFT_AXES; i++)
        now->position[i] = r.position[i];
    now->room = r.room;
    now->state = r.state;
    now->override = m->drive.percent;
    now->starved = r.starved;
    now->lost = m->lost != 0;
    now->closed = m->closed;
    now->ended_by = m->ended_by;
    now->latched = loft_latch_place(&m->latch);
    if (job_has_curves(m))
        count_curves(m, now);
}

/* The closed inputs that end a job which moves away from the inputs `away`, with this guard. */
static uint16_t ending_inputs(const loft_machine *m, uint16_t away, const loft_guard *guard)
{
    return (uint16_t)(m->closed & LOFT_INPUT_ENDING & ~away & ~guard->inputs);
}

#if LOFT_MACHINE_SQUARES

static bool may_square(const loft_machine *m, const loft_guard *guard)
{
    return !(guard->how & LOFT_GUARD_SQUARE) ||
           (guard->inputs & m->config->squares) == guard->inputs;
}

/* When its motors are squared, an axis is no longer where its steps led. */
static void mark_square(loft_machine *m, const loft_guard *guard)
{
    m->gated = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        if (guard->how & LOFT_GUARD_SQUARE && guard->inputs & LOFT_INPUT_ENDS(i))
            m->lost = (uint8_t)(m->lost | 1u << i);
}

#else

static bool may_square(const loft_machine *m, const loft_guard *guard)
{
    (void)m;
    return !(guard->how & LOFT_GUARD_SQUARE);
}
static void mark_square(loft_machine *m, const loft_guard *guard)
{
    (void)m;
    (void)guard;
}

#endif

/* No job is under way. The plan of the last job is discarded, even if this job is refused. */
static void begin_job(loft_machine *m, const loft_job *job)
{
    const bool curves = job->kind == LOFT_CURVES;

    if (ending_inputs(m, job->away, &job->guard)) {
        loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_INPUT);
        return;
    }
    if (!may_square(m, &job->guard)) {
        loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_KIND);
        return;
    }
    if (curves && begin_planner(m, job) != LOFT_OK) {
        loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_LIMITS);
        return;
    }
    loft_latch_rest(&m->latch);             /* that of the last job ends nothing any more */
    switch (loft_drive_begin(&m->drive, (enum loft_kind)job->kind, job->start)) {
    case LOFT_OK:
        m->job.id   = job->id;
        m->job.kind = job->kind;
        m->job.away = job->away;
        m->ended_by = 0;
        mark_square(m, &job->guard);
        loft_latch_arm(&m->latch, &job->guard);
        loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_NONE);
        break;
    case LOFT_ERR_RANGE: loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_START); break;
    default: loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_BUSY);
    }
}

static void refuse_job(loft_machine *m, enum loft_refusal refusal)
{
    if (refusal != LOFT_REFUSAL_NONE)
        give_up_job(m, refusal);
}

static void take_item(loft_machine *m, const loft_item *item)
{
    if (job_has_curves(m))
        refuse_job(m, take_curve(m, item));
    else
        queue_item(m, item);
}

static void end_job(loft_machine *m)
{
    if (job_has_curves(m))
        refuse_job(m, end_planner(m));
    else
        loft_drive_end(&m->drive);
}

void loft_machine_control(loft_machine *m, enum loft_verb verb)
{
    switch (verb) {
    case LOFT_HOLD:     loft_drive_hold(&m->drive, true);   break;
    case LOFT_RESUME:   loft_drive_hold(&m->drive, false);  break;
    case LOFT_ABORT:    loft_drive_abort(&m->drive);        break;
    case LOFT_CLOSE:    loft_drive_close(&m->drive);        break;
    case LOFT_OVERRIDE:                     /* these have values: loft_machine_override, */
    case LOFT_PLACE:                        /* loft_drive_place, loft_drive_table */
    case LOFT_TABLE_LOW:
    case LOFT_TABLE_HIGH: break;
    }
}

void loft_machine_sample(loft_machine *m, uint16_t inputs)
{
    if (!m->drive.active) {
        loft_latch_rest(&m->latch);
        return;
    }
    const uint16_t why = loft_latch_sample(&m->latch, loft_machine_squared(m, inputs));
    if (!why || m->ended_by)
        return;
    m->guarded = why;
    LOFT_BARRIER();
    m->guard_ended = 1;
    LOFT_BARRIER();
    if (m->latch.guard.how & LOFT_GUARD_HARD)
        loft_drive_halt(&m->drive);
    else
        loft_drive_abort(&m->drive);
}

void loft_machine_inputs(loft_machine *m, uint16_t closed)
{
    const uint16_t fresh = (uint16_t)(closed & ~m->closed);

    m->closed   = closed;
    m->job.away = (uint16_t)(m->job.away & closed);
    const uint16_t why = ending_inputs(m, m->job.away, &m->latch.guard);
    if (why && m->drive.active && !m->ended_by) {
        note_end(m, why);
        if (why & LOFT_INPUT_STOP) {
            m->lost = (1u << LOFT_AXES) - 1;
            loft_drive_halt(&m->drive);
        } else {
            loft_drive_abort(&m->drive);
        }
    } else if (fresh & LOFT_INPUT_HOLD) {
        loft_machine_control(m, LOFT_HOLD);
    } else if (fresh & LOFT_INPUT_RESUME) {
        loft_machine_control(m, LOFT_RESUME);
    }
}

static void place_machine(loft_machine *m, const loft_control *place)
{
    enum loft_status status;

    loft_drive_close(&m->drive);
    if (place->verb == LOFT_PLACE) {
        status  = loft_drive_place(&m->drive, place->value, place->position);
        m->lost = (uint8_t)(m->lost & ~place->value);
    } else {
        status = loft_drive_table(&m->drive, place->verb == LOFT_TABLE_HIGH, place->value,
                                  place->position);
    }
    if (status != LOFT_OK)
        loft_receiver_answer(&m->receiver, NULL, LOFT_REFUSAL_START);
}

#define BUSY (LOFT_KEPT_MOST + 1)

/* What was planned with other gearing must not begin: the host greets again. */
static APART void take_set(loft_machine *m, const loft_set *set)
{
    m->set.at      = set->at;
    m->set.wrote   = set->count && m->drive.active ? BUSY : set->count;
    m->set.session = m->receiver.session;
    if (m->set.wrote != BUSY &&
        loft_settings_put(&m->config->settings, set->at, set->byte, set->count))
        loft_receiver_answer(&m->receiver, NULL, LOFT_REFUSAL_LIMITS);
}

static APART size_t answer_set(loft_machine *m, uint8_t wire[LOFT_FRAME_MAX])
{
    const bool busy = m->set.wrote == BUSY, spare = m->set.at && m->set.wrote && !busy;
    loft_kept kept;

    kept.at     = m->set.at;
    kept.room   = m->config->settings.room;
    kept.origin = (uint8_t)loft_settings_origin_of(&m->config->settings);
    kept.busy   = busy;
    kept.count  = m->set.wrote && !busy ? m->set.wrote : LOFT_KEPT_MOST;
    for (uint8_t i = 0; i < kept.count; i++) {
        const uint16_t at = (uint16_t)(kept.at + i);
        kept.byte[i] = spare ? loft_settings_spare(&m->config->settings, at)
                             : loft_settings_get(&m->config->settings, at);
    }
    const uint8_t session = m->set.session;
    m->set.session = 0;
    return loft_kept_encode(&kept, session, wire);
}

static void act_on_event(loft_machine *m, enum loft_event event, const loft_event_data *what)
{
    switch (event) {
    case LOFT_EVENT_NONE:
    case LOFT_EVENT_ITEMS:                                              break;
    case LOFT_EVENT_JOB:        begin_job(m, &what->job);                   break;
    case LOFT_EVENT_ITEM:       take_item(m, &what->item);                   break;
    case LOFT_EVENT_END:        end_job(m);                                 break;
    case LOFT_EVENT_HOLD:       loft_machine_control(m, LOFT_HOLD);     break;
    case LOFT_EVENT_RESUME:     loft_machine_control(m, LOFT_RESUME);   break;
    case LOFT_EVENT_ABORT:      loft_machine_control(m, LOFT_ABORT);    break;
    case LOFT_EVENT_OVERRIDE:   loft_machine_override(m, what->percent); break;
    case LOFT_EVENT_CLOSE:      loft_machine_control(m, LOFT_CLOSE);    break;
    case LOFT_EVENT_PLACE:      place_machine(m, &what->place);             break;
    case LOFT_EVENT_SET:        take_set(m, &what->set);                    break;
    }
}

/* Act on the events of the frame. To check one, to unpack an item and to take it may each outlast a
 * short span on 8 bits. */
static APART void act_on_frame(loft_machine *m)
{
    loft_snapshot now;
    loft_event_data what;
    enum loft_event event;

    take_snapshot(m, &now);
    do {
        loft_drive_prepare(&m->drive);
        event = loft_receiver_next(&m->receiver, &now, &what);
        act_on_event(m, event, &what);
        (void)loft_machine_plan(m);
    } while (event != LOFT_EVENT_NONE);
}

void loft_machine_push(loft_machine *m, const uint8_t byte[], size_t count)
{
    loft_drive_prepare(&m->drive);              /* here and in poll: each takes 1 ms on 8 bits */
    for (size_t i = 0; i < count; i++)
        if (loft_receiver_push(&m->receiver, byte[i]))
            act_on_frame(m);
}

size_t loft_machine_poll(loft_machine *m, uint8_t wire[LOFT_FRAME_MAX])
{
    (void)loft_machine_plan(m);
    loft_drive_prepare(&m->drive);
    if (!LOFT_MACHINE_TICK_PREPARES && loft_drive_pressed(&m->drive))
        return 0;
    if (m->set.session)
        return answer_set(m, wire);

    loft_snapshot now;
    take_snapshot(m, &now);
    return loft_receiver_poll(&m->receiver, &now, wire);
}

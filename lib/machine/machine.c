/* lib/machine/machine.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/machine.h"

enum loft_status loft_machine_init(loft_machine *m, loft_machine_config *config)
{
    loft_drive_config drive;

    m->traits = &config->traits;
    for (int i = 0; i < LOFT_AXES; i++)
        drive.position[i] = config->position[i];
    drive.axis = m->traits->axis;
    drive.tick_hz = config->traits.tick_hz;
    drive.slots = config->traits.slots;
    drive.ramp = config->ramp;
    drive.cell = config->cell;
    drive.cells = config->cells;

    config->traits.queue = config->cells;
    config->traits.kinds = 1u << LOFT_SPANS | 1u << LOFT_POINTS;
    const enum loft_status status = loft_receiver_init(&m->receiver, m->traits);
    return status == LOFT_OK ? loft_drive_init(&m->drive, &drive) : status;
}

static loft_standing standing(loft_machine *m)
{
    const loft_drive_report r = loft_drive_poll(&m->drive);
    loft_standing now;

    now.executed = r.executed;
    now.ticks = r.ticks;
    now.elapsed = r.elapsed;
    now.slowed = r.slowed;
    for (int i = 0; i < LOFT_AXES; i++)
        now.position[i] = r.position[i];
    now.room = r.room;
    now.state = r.state;
    now.starved = r.starved;
    return now;
}

static void begin(loft_machine *m, const loft_job *job)
{
    switch (loft_drive_begin(&m->drive, (enum loft_kind)job->kind, job->start)) {
    case LOFT_OK:
        m->job = *job;
        loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_NONE);
        break;
    case LOFT_ERR_RANGE:
        loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_START);
        break;
    default:
        loft_receiver_answer(&m->receiver, job, LOFT_REFUSAL_BUSY);
    }
}

/* An item that the machine cannot do, or for which the receiver saw room where there is none, is already counted as
 * taken: the job ends here, on the path. */
static void queue(loft_machine *m, const loft_item *item)
{
    if (loft_drive_push(&m->drive, item) == LOFT_OK)
        return;
    loft_drive_abort(&m->drive);
    loft_receiver_answer(&m->receiver, &m->job, LOFT_REFUSAL_ITEM);
}

void loft_machine_control(loft_machine *m, enum loft_verb verb)
{
    switch (verb) {
    case LOFT_HOLD:     loft_drive_hold(&m->drive, true);   break;
    case LOFT_RESUME:   loft_drive_hold(&m->drive, false);  break;
    case LOFT_ABORT:    loft_drive_abort(&m->drive);        break;
    case LOFT_CLOSE:    loft_drive_close(&m->drive);        break;
    }
}

static void act(loft_machine *m, enum loft_event event, const loft_event_data *what)
{
    switch (event) {
    case LOFT_EVENT_NONE:                                               break;
    case LOFT_EVENT_JOB:        begin(m, &what->job);                   break;
    case LOFT_EVENT_ITEM:       queue(m, &what->item);                  break;
    case LOFT_EVENT_END:        loft_drive_end(&m->drive);              break;
    case LOFT_EVENT_HOLD:       loft_machine_control(m, LOFT_HOLD);     break;
    case LOFT_EVENT_RESUME:     loft_machine_control(m, LOFT_RESUME);   break;
    case LOFT_EVENT_ABORT:      loft_machine_control(m, LOFT_ABORT);    break;
    case LOFT_EVENT_CLOSE:      loft_machine_control(m, LOFT_CLOSE);    break;
    }
}

void loft_machine_push(loft_machine *m, const uint8_t byte[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!loft_receiver_push(&m->receiver, byte[i]))
            continue;
        const loft_standing now = standing(m);
        loft_event_data what;
        enum loft_event event;
        while ((event = loft_receiver_next(&m->receiver, &now, &what)) != LOFT_EVENT_NONE) {
            act(m, event, &what);
            loft_drive_prepare(&m->drive);      /* unpacking a frame takes longer than a short span lasts */
        }
    }
}

size_t loft_machine_poll(loft_machine *m, uint8_t wire[LOFT_FRAME_MAX])
{
    loft_drive_prepare(&m->drive);
    const loft_standing now = standing(m);
    return loft_receiver_poll(&m->receiver, &now, wire);
}

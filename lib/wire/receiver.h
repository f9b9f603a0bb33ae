/* lib/wire/receiver.h -- the machine's half of a session: bytes in, items in order and exactly
 * once, answers out
 * SPDX-License-Identifier: MIT
 *
 * It has no memory but the struct, no clock and no transport. The machine's main loop:
 *
 *     while (port_read(&byte))
 *         if (loft_receiver_push(&r, byte)) {                              // a frame is complete
 *             loft_snapshot now = where_i_stand();
 *             enum loft_event e;
 *             while ((e = loft_receiver_next(&r, &now, &what)) != LOFT_EVENT_NONE)
 *                 act(e, &what);                                           // queue what.item, ...
 *         }
 *     if (port_takes_a_frame()) {
 *         loft_snapshot now = where_i_stand();
 *         port_write(wire, loft_receiver_poll(&r, &now, wire));
 *     }
 *
 * An item counts as taken at the moment loft_receiver_next gives it. Put it in the queue before
 * anything else.
 */
#ifndef LOFT_WIRE_RECEIVER_H
#define LOFT_WIRE_RECEIVER_H

#include "wire/message.h"   /* the messages, loft_frame, loft_unpacker */

LOFT_BEGIN_C

/* An axis of the machine. */
typedef struct {
    int32_t  steps_per_mm, max_speed, max_accel;    /* raw Q16.16: of mm, mm/s, mm/s^2 */
    uint32_t max_jerk;                              /* mm/s^3; 0: no limit; not sent to the host */
} loft_axis_config;

/* The constant data of a machine, set once. */
typedef struct {
    uint32_t boot;                      /* different at each start: a counter in flash, a clock */
    uint16_t tick_hz, slots;
    uint16_t queue;                     /* spans that fit the queue */
    uint16_t points;                    /* points that fit it at least */
    uint16_t curves;                    /* curves that fit the plan */
    uint16_t columns;                   /* curves of a line of a patch; 0: it takes none */
    uint8_t  kinds;                     /* 1 << enum loft_kind: items of this kind are accepted;
                                         * LOFT_TAKES_ */
    uint8_t  outputs;                   /* 0..LOFT_MACHINE_OUTPUTS that the board has */
    loft_axis_config axis[LOFT_AXES];
} loft_machine_info;

/* The current state of the machine, made anew for each call. */
typedef struct {
    uint32_t executed;                  /* items of the job executed entirely */
    uint32_t ticks, elapsed, slowed;    /* as in loft_machine_status; only poll uses it */
    int32_t  position[LOFT_AXES];       /* steps; only poll uses it */
    uint16_t room;                      /* items of the job's kind that fit now */
    uint8_t  state;                     /* enum loft_machine_state */
    uint8_t  override;                  /* percent; only poll uses it */
    uint16_t closed, ended_by;          /* inputs, as in the messages; only poll uses it */
    const int32_t *latched;             /* LOFT_AXES steps; NULL: no guard; only poll uses it */
    bool     starved, lost;             /* as in the flags of ACK */
} loft_snapshot;

enum loft_event {
    LOFT_EVENT_NONE,
    LOFT_EVENT_JOB,         /* `job` wants to begin: answer with loft_receiver_answer. For curves,
                             * loft_job_limits_decode(&r->frame, ..) has the limits until the next
                             * byte */
    LOFT_EVENT_ITEMS,       /* a frame of them is sound: they follow, one each */
    LOFT_EVENT_ITEM,        /* `item`, the next one: queue it */
    LOFT_EVENT_END,         /* no more items follow: DONE once all are executed */
    LOFT_EVENT_HOLD,
    LOFT_EVENT_RESUME,
    LOFT_EVENT_ABORT,
    LOFT_EVENT_OVERRIDE,    /* `percent` */
    LOFT_EVENT_CLOSE,       /* the host has the report: IDLE */
    LOFT_EVENT_SET,         /* `set`: settings are asked for or written. The machine answers KEPT */
    LOFT_EVENT_PLACE        /* `place`: no job is under way, and one that is over is closed; the
                             * machine stands there, or its table ends there, by `place.verb`. If it
                             * cannot, answer LOFT_REFUSAL_START without a job */
};

typedef union {
    loft_job  job;
    loft_item item;
    loft_control place;
    loft_set  set;
    uint8_t   percent;
} loft_event_data;

/* The struct is complete so that it can be static. The counters are yours to read; the other fields
 * may change without notice. */
typedef struct {
    uint32_t damaged, dropped;          /* frames, as in loft_machine_status */

    const loft_machine_info *info;
    loft_frame     frame;
    loft_unpacker  unpacker;
    loft_predictor predictor;
    uint32_t nonce, job, next, offered;     /* offered: the last limit sent */
    int32_t  start[LOFT_AXES];          /* of the job */
    uint8_t  session, sessions;         /* the current one (0: none); the last number used */
    uint8_t  kind, control, refusal;
    uint8_t  welcome;                   /* WELCOME and AXIS frames still to send */
    uint8_t  due;                       /* other answers still to send */
    bool     fresh;                     /* a frame waits for loft_receiver_next */
    bool     opened;                    /* this session has had its JOB */
    bool     ended, reported;
} loft_receiver;

/* Prepare to listen. `info` is borrowed.
 *
 *   range   queue, tick_hz and slots >= 1; otherwise LOFT_ERR_ARG
 */
enum loft_status loft_receiver_init(loft_receiver *r, const loft_machine_info *info) LOFT_CHECKED;

/* Take one byte from the line. Returns true when a frame waits: call loft_receiver_next until it
 * gives LOFT_EVENT_NONE.
 *
 *   error   a byte pushed earlier discards the waiting frame, which the host sends again
 *   cost    that of loft_frame_push
 */
bool loft_receiver_push(loft_receiver *r, uint8_t byte);

/* Give the next event of the waiting frame.
 *
 *   shape   the `now` of the first event of a frame may serve for all its events
 *   cost    one item unpacked, or the seal of a frame checked
 */
enum loft_event loft_receiver_next(loft_receiver *r, const loft_snapshot *now,
                                   loft_event_data *out);

/* Answer LOFT_EVENT_JOB. LOFT_REFUSAL_NONE begins `job`, and item 0 is next. Any other refusal is
 * sent to the host in a STATUS, and that JOB stays refused in this session. It may also be called
 * later with a refusal and no job, to say why the machine ends the job by itself. */
void loft_receiver_answer(loft_receiver *r, const loft_job *job, enum loft_refusal refusal);

/* Give the next frame to send; 0 when there is none. Call it whenever the line is free: it also
 * reports room that the queue has gained. */
size_t loft_receiver_poll(loft_receiver *r, const loft_snapshot *now, uint8_t wire[LOFT_FRAME_MAX]);

LOFT_END_C

#endif

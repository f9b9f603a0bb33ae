/* lib/wire/receiver.h -- the machine's half of a session: bytes in, items in order and exactly
 * once, answers out
 * SPDX-License-Identifier: MIT
 *
 * No memory but the struct, no clock, no transport. The machine's main loop:
 *
 *     while (port has a byte)
 *         if (loft_receiver_push(&r, byte)) {                              // a frame is complete
 *             loft_snapshot now = where_i_stand();
 *             enum loft_event e;
 *             while ((e = loft_receiver_next(&r, &now, &what)) != LOFT_EVENT_NONE)
 *                 act(e, &what);                                           // queue what.item, ...
 *         }
 *     if (the port can take a frame) {
 *         loft_snapshot now = where_i_stand();
 *         write(wire, loft_receiver_poll(&r, &now, wire));
 *     }
 *
 * An item is counted as taken at the moment loft_receiver_next gives it: put it in the queue before
 * anything else.
 */
#ifndef LOFT_WIRE_RECEIVER_H
#define LOFT_WIRE_RECEIVER_H

#include "wire/message.h"   /* the messages, loft_frame, loft_unpacker */

LOFT_BEGIN_C

/* An axis of the machine. */
typedef struct {
    int32_t  steps_per_mm, max_speed, max_accel;    /* raw Q16.16: of mm, mm/s, mm/s^2 */
    uint32_t max_jerk;                              /* mm/s^3; 0: not limited. The host is not
                                                     * told */
} loft_axis_config;

/* What the machine is; set once. */
typedef struct {
    uint32_t boot;                      /* another one at each start: a counter in flash, a random
                                         * number, a clock */
    uint16_t tick_hz, slots;
    uint16_t queue;                     /* spans that fit the queue */
    uint16_t points;                    /* points that fit it, at the least */
    uint16_t curves;                    /* curves that fit the plan */
    uint8_t  kinds;                     /* bit 1: spans, bit 2: points, bit 4: curves: 1 << enum
                                         * loft_kind */
    loft_axis_config axis[LOFT_AXES];
} loft_machine_info;

/* How the machine stands; made afresh for each call. */
typedef struct {
    uint32_t executed;                  /* items of the job executed entirely */
    uint32_t ticks, elapsed, slowed;    /* as in loft_machine_status; only looked at by poll */
    int32_t  position[LOFT_AXES];       /* steps; only looked at by poll */
    uint16_t room;                      /* items of the job's kind that can be taken now */
    uint8_t  state;                     /* enum loft_machine_state */
    uint8_t  override;                  /* percent; only looked at by poll */
    uint16_t closed, ended_by;          /* inputs, as in loft_machine_status and loft_report; only
                                         * looked at by poll */
    bool     starved;
} loft_snapshot;

enum loft_event {
    LOFT_EVENT_NONE,
    LOFT_EVENT_JOB,         /* a job wants to begin, `job`: answer with loft_receiver_answer. What a
                             * job of curves asks for: loft_job_limits_decode(&r->frame, ..), until
                             * the next byte */
    LOFT_EVENT_ITEM,        /* `item`, the next one: queue it */
    LOFT_EVENT_END,         /* no more items follow: DONE once all are executed */
    LOFT_EVENT_HOLD,
    LOFT_EVENT_RESUME,
    LOFT_EVENT_ABORT,
    LOFT_EVENT_OVERRIDE,    /* `percent` */
    LOFT_EVENT_CLOSE        /* the host has the report: IDLE */
};

typedef union {
    loft_job  job;
    loft_item item;
    uint8_t   percent;
} loft_event_data;

/* Complete so that it can be static; the counters are yours to read, the other fields may change
 * without notice. */
typedef struct {
    uint32_t damaged, dropped;          /* frames, as in loft_machine_status */

    const loft_machine_info *info;
    loft_frame     frame;
    loft_unpacker  unpacker;
    loft_predictor predictor;
    uint32_t nonce, job, next, told;    /* told: the limit last sent */
    int32_t  start[LOFT_AXES];          /* of the job */
    uint8_t  session, sessions;         /* the one under way (0: none), and the last number used */
    uint8_t  kind, control, refusal;
    uint8_t  welcome;                   /* WELCOME and AXIS frames still to be sent */
    uint8_t  due;                       /* other answers still to be sent */
    bool     fresh;                     /* a frame waits for loft_receiver_next */
    bool     opened;                    /* this session has had its JOB */
    bool     ended, reported;
} loft_receiver;

/* Prepare to listen. `info` is borrowed.
 *
 *   range   queue, tick_hz and slots >= 1; otherwise LOFT_ERR_ARG
 */
enum loft_status loft_receiver_init(loft_receiver *r, const loft_machine_info *info) LOFT_CHECKED;

/* Take one byte from the line. Gives true when a frame waits: call loft_receiver_next until it
 * gives LOFT_EVENT_NONE.
 *
 *   error   bytes pushed before that are lost (and sent again by the host); nothing else is
 *   cost    that of loft_frame_push
 */
bool loft_receiver_push(loft_receiver *r, uint8_t byte);

/* Give the next event of the waiting frame.
 *
 *   shape   `now` as it was before the first event of this frame is good enough for all of them
 *   cost    one item unpacked
 */
enum loft_event loft_receiver_next(loft_receiver *r, const loft_snapshot *now,
                                   loft_event_data *out);

/* Answer LOFT_EVENT_JOB: LOFT_REFUSAL_NONE begins `job`, item 0 is next; any other is told to the
 * host with a STATUS, and that JOB stays refused in this session. May also be called later with a
 * refusal and no job, to tell why the machine ends it by itself. */
void loft_receiver_answer(loft_receiver *r, const loft_job *job, enum loft_refusal refusal);

/* Give the next frame to send; 0 when there is none. Call it whenever the line can take one: it
 * also tells the host of room that the queue gained. */
size_t loft_receiver_poll(loft_receiver *r, const loft_snapshot *now, uint8_t wire[LOFT_FRAME_MAX]);

LOFT_END_C

#endif

/* lib/wire/sender.h -- the host's half of a session: a job is sent, repaired, resumed and reported
 * SPDX-License-Identifier: MIT
 *
 * It has no transport and no clock: the caller moves the bytes and passes the time in ms (any
 * origin, may wrap). Items are requested by number, again when frames were lost; sent items are not
 * stored. Later items may still be in the making while the first ones are executed.
 *
 *     loft_sender_init(&s, nonce, now);
 *     loop:
 *         for each byte read        loft_sender_push(&s, byte, now);
 *         if the line is free       write(wire, loft_sender_poll(&s, now, wire));
 *         if s.phase is LOFT_PHASE_READY          plan for s.machine and s.axis;
 *                                                 loft_sender_begin(&s, &job, ..);
 *         if s.phase >= LOFT_PHASE_DONE           print what happened; stop
 *         sleep until a byte comes or loft_sender_wait(&s, now) ms have passed
 */
#ifndef LOFT_WIRE_SENDER_H
#define LOFT_WIRE_SENDER_H

#include "wire/message.h"   /* the messages, loft_frame */
#include "wire/rto.h"       /* loft_rto */
#include "wire/window.h"    /* loft_window, loft_item_source */

LOFT_BEGIN_C

#define LOFT_SENDER_SILENCE 1500        /* ms without an answer before HELLO is sent again */
#define LOFT_SENDER_POLL    100         /* ms between two requests for the status         */

enum loft_phase {
    LOFT_PHASE_HELLO,       /* no answer yet; also in mid-job, which continues after it */
    LOFT_PHASE_READY,       /* welcomed: `machine`, `axis` are known; waits for loft_sender_begin */
    LOFT_PHASE_OPENING,     /* JOB is sent */
    LOFT_PHASE_STREAMING,   /* items are sent; also after the last one, until the report */
    LOFT_PHASE_CLOSING,     /* the report is here, and the machine gets CLOSE */
                          /* ... the phases below are final */
    LOFT_PHASE_DONE,        /* done: `report` */
    LOFT_PHASE_ABORTED,     /* ended early: `report` if report.job is not 0 */
    LOFT_PHASE_BUSY,        /* another job is under way: `machine.job` */
    LOFT_PHASE_LOST,        /* the machine restarted or has another job: position unreliable */
    LOFT_PHASE_REFUSED,     /* by the machine: `refusal` */
    LOFT_PHASE_UNFIT        /* no common version, other axes, or too short a frame: `machine` */
};

/* The struct is complete so that it can be static. Read the fields above the line; the rest may
 * change without notice. */
typedef struct {
    enum loft_phase     phase;
    loft_welcome        machine;
    loft_axis           axis[LOFT_AXES];
    loft_ack            ack;                /* the latest */
    loft_machine_status status;             /* the latest, about LOFT_SENDER_POLL ms old, no ack */
    loft_report         report;
    uint16_t closed;                        /* closed inputs of the machine, the latest */
    uint8_t  refusal;                       /* enum loft_refusal: why REFUSED or ABORTED */
    bool     resumed;                       /* the job was already under way when it was begun */
    bool     collected;                     /* the job was already over: only its report is read */
    uint8_t  verb;                          /* the unacknowledged CONTROL; 0: none */
    bool     asking;                        /* SET is not answered; when it is: `kept` */
    loft_kept kept;
    /* frames; the first two count data frames */
    uint32_t sent, resent, naks, timeouts, hellos, damaged, unknown;
    uint32_t rtt_ms;                        /* smoothed; 0 until measured */
    /* ---- */
    loft_frame  frame;
    loft_job    job;
    loft_window window;                     /* the items in flight */
    uint8_t     doubt;                      /* STATUS to wait for until losses are known; 0: none */
    uint8_t     session, seen;              /* seen: bit i: AXIS i of this session has come */
    uint8_t     value, number;              /* of the unacknowledged CONTROL */
    uint8_t     percent;                    /* the unacknowledged override; 0: none */
    uint8_t     axes;                       /* of the unacknowledged place */
    int32_t     place[LOFT_AXES];
    uint8_t     attempts;                   /* to send CONTROL */
    loft_set    set;                        /* what is asked, and its bytes */
    uint8_t     set_byte[LOFT_KEPT_MOST];
    bool        set_sent;                   /* in this session */
    bool        greeted;                    /* WELCOME has come, AXIS may be missing */
    bool        began, asked, opened;       /* loft_sender_begin; JOB was sent; JOB was taken */
    bool        hello_sent, job_sent, verb_sent;    /* in this session */
    bool        aborting, polling;          /* polling: no STATUS since the last POLL */
    uint32_t    nonce, boot;
    loft_rto    rto;                        /* the time to wait for an answer */
    uint32_t    heard, tried, polled, back, verb_time;          /* times */
} loft_sender;

/* Prepare to greet a machine. `nonce` is any number that the last connection did not use (a clock,
 * a random number). */
void loft_sender_init(loft_sender *s, uint32_t nonce, uint32_t now_ms);

/* Begin `job` of `count` items, or of LOFT_ITEMS_OPEN: see loft_sender_extend. job->nonce is filled
 * in. What follows depends on the machine. If it is idle, the job starts. If it is in the middle of
 * this job (same id), the job continues at the machine's position. If it has finished this job and
 * nobody has read the report, the report is read. If it is in another job, the phase is BUSY.
 *
 *   range   phase is LOFT_PHASE_READY, job->id not 0, job->kind known, curves only for a machine
 *           that plans (machine.curves > 0), with job->limits (borrowed), a guard only for one that
 *           takes it (LOFT_TAKES_GUARDS); otherwise LOFT_ERR_ARG
 */
enum loft_status loft_sender_begin(loft_sender *s, const loft_job *job, uint32_t count,
                                   loft_item_source *source, void *context) LOFT_CHECKED;

/* More is known of a job that began with LOFT_ITEMS_OPEN: items 0 .. known - 1 can be requested
 * now. `count` is LOFT_ITEMS_OPEN, or `known` when there are no more. A job that continues at an
 * item beyond `known` waits for it.
 *
 *   range   known not below its last value; only after loft_sender_begin */
void loft_sender_extend(loft_sender *s, uint32_t known, uint32_t count);

/* Hold, resume or abort (not LOFT_CLOSE), at any time after the welcome, also with a full window
 * and when BUSY. The latest control counts. After an abort no more items are sent, and the phase
 * becomes ABORTED. */
void loft_sender_control(loft_sender *s, enum loft_verb verb);

/* Say where the machine stands: axis i, of bit i of `axes`, is at position[i] steps. When `verb` is
 * 0 again, the machine has obeyed, and axis[].position is corrected; or `ack.refusal` says why it
 * has not, and it refuses the job of this session as well.
 *
 *   range   phase is LOFT_PHASE_READY; machine.kinds has LOFT_TAKES_PLACES; 0 < axes < 2^LOFT_AXES;
 *           otherwise LOFT_ERR_ARG */
enum loft_status loft_sender_place(loft_sender *s, uint8_t axes,
                                   const int32_t position[LOFT_AXES]) LOFT_CHECKED;

/* Say where the table of the axes begins, then, with `high`, where it ends. It counts after the
 * second. When `verb` is 0 again, the machine has obeyed.
 *
 *   range   as of loft_sender_place; machine.kinds has LOFT_TAKES_TABLE; otherwise LOFT_ERR_ARG */
enum loft_status loft_sender_table(loft_sender *s, bool high, uint8_t axes,
                                   const int32_t position[LOFT_AXES]) LOFT_CHECKED;

/* Ask for the settings from `at` on, or write `count` bytes there (machine/settings.h). When
 * `asking` is false again, `kept` is the answer. After a write at 0 greet the machine again.
 *
 *   range   phase is LOFT_PHASE_READY; machine.kinds has LOFT_TAKES_SETTINGS; not asking; count
 *           0..LOFT_KEPT_MOST; otherwise LOFT_ERR_ARG */
enum loft_status loft_sender_set(loft_sender *s, uint16_t at, const uint8_t byte[],
                                 uint8_t count) LOFT_CHECKED;

/* Run time at `percent` of the plan, 1..200, from now on until the job ends. It is sent after a
 * control in flight. */
void loft_sender_override(loft_sender *s, unsigned percent);

/* Take one byte from the line. Returns true when `phase`, `ack`, `status` or `report` may have
 * changed. */
bool loft_sender_push(loft_sender *s, uint8_t byte, uint32_t now_ms);

/* Give the next frame to send; 0 when there is none now. */
size_t loft_sender_poll(loft_sender *s, uint32_t now_ms, uint8_t wire[LOFT_FRAME_MAX]);

/* The number of ms in which loft_sender_poll has nothing to send if no byte arrives; 0: it has
 * something now. */
uint32_t loft_sender_wait(const loft_sender *s, uint32_t now_ms);

/* The line is gone for good. A job whose report has arrived has still ended. */
void loft_sender_hangup(loft_sender *s);

/* The number of ms without a good frame. */
uint32_t loft_sender_silence(const loft_sender *s, uint32_t now_ms);

LOFT_END_C

#endif

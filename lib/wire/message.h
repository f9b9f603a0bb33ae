/* lib/wire/message.h -- messages: the content of frames
 * SPDX-License-Identifier: MIT
 *
 * Every message is a struct and two functions. encode makes a complete frame of it, ready to send.
 * decode reads the content of a received frame. All numbers are little endian. WIRE.md has the
 * tables.
 *
 *     host to machine   HELLO  JOB  SPANS  POINTS  FINE  CURVES  END  CONTROL  POLL  SET
 *     machine to host   WELCOME  AXIS  ACK  STATUS  REPORT  KEPT
 */
#ifndef LOFT_WIRE_MESSAGE_H
#define LOFT_WIRE_MESSAGE_H

#include "wire/codec.h"     /* loft_packer, enum loft_kind */
#include "wire/frame.h"     /* LOFT_FRAME_MAX, loft_frame  */

LOFT_BEGIN_C

#define LOFT_WIRE_VERSION 3

enum loft_message {
    LOFT_HELLO = 0x1,
    LOFT_WELCOME = 0x8, /* HELLO and WELCOME never change their layout */
    LOFT_JOB = 0x2,
    LOFT_AXIS = 0x9,
    LOFT_DATA_SPANS = 0x3,
    LOFT_ACK = 0xA,
    LOFT_DATA_POINTS = 0x4,
    LOFT_STATUS = 0xB,
    LOFT_END = 0x5,
    LOFT_REPORT = 0xC,
    LOFT_CONTROL = 0x6,
    LOFT_POLL    = 0x7,
    LOFT_DATA_FINE   = 0xD,                         /* host: POINTS, packed by third differences */
    LOFT_DATA_CURVES = 0xE,                         /* host */
    LOFT_SET  = 0xF,                                /* host */
    LOFT_KEPT = 0x0                                 /* machine */
};

/* The state of the machine. */
enum loft_machine_state {
    LOFT_STATE_IDLE,        /* no job                                                           */
    LOFT_STATE_RUNNING,     /* in a job: moving, or waiting for items                           */
    LOFT_STATE_HOLDING,     /* slowing down on the path for a hold                              */
    LOFT_STATE_HELD,        /* stopped on the path                                              */
    LOFT_STATE_STOPPING,    /* slowing down on the path, then the job is over                   */
    LOFT_STATE_DONE,        /* the job is done; the report has not been closed                  */
    LOFT_STATE_ABORTED,     /* the job ended early; the report has not been closed              */
    LOFT_STATE_FAULT        /* the position is unreliable: no job until the machine restarts    */
};

/* True if a job is under way, so that no other job can begin. */
static inline bool loft_state_busy(uint8_t state)
{
    return state >= LOFT_STATE_RUNNING && state <= LOFT_STATE_STOPPING;
}

enum loft_flag {
    LOFT_FLAG_NAK     = 1,  /* a frame was damaged or missing: send again from `next`           */
    LOFT_FLAG_ENDED   = 2,  /* END was taken: all items are here                                */
    LOFT_FLAG_STARVED = 4,  /* the queue ran low and the job slowed down or stopped             */
    LOFT_FLAG_OPENED  = 8,  /* this session has had its JOB, or found a job under way           */
    LOFT_FLAG_LOST    = 16  /* since an emergency stop, or while motors are squared: where the
                             * machine stands is in doubt                                       */
};

/* Why the machine refused a JOB or an item. */
enum loft_refusal {
    LOFT_REFUSAL_NONE,
    LOFT_REFUSAL_BUSY,      /* a job is under way                                               */
    LOFT_REFUSAL_START,     /* the job does not start at the machine's position                 */
    LOFT_REFUSAL_KIND,      /* the machine does not accept items of this kind                   */
    LOFT_REFUSAL_ITEM,      /* an item is invalid, or exceeds what the machine can do           */
    LOFT_REFUSAL_FAULT,     /* the machine's position is unreliable                             */
    LOFT_REFUSAL_LIMITS,    /* the limits of the job are impossible                             */
    LOFT_REFUSAL_INPUT,     /* a limit switch or the emergency stop is closed                   */
    LOFT_REFUSAL_TABLE,     /* an item leaves the table of the machine                          */
    LOFT_REFUSAL_PATCH      /* a patch cannot be cut so: toolpath/lines.h                       */
};

/* Inputs of a machine, one bit each, 1: closed. A limit switch for both ends of its axis is both
 * bits. */
#define LOFT_INPUT_LOW(axis)    ((uint16_t)(1u << 2 * (axis)))
#define LOFT_INPUT_HIGH(axis)   ((uint16_t)(2u << 2 * (axis)))
#define LOFT_INPUT_ENDS(axis)   ((uint16_t)(3u << 2 * (axis)))
#define LOFT_INPUT_STOP         0x1000u     /* the emergency stop                               */
#define LOFT_INPUT_HOLD         0x2000u     /* the buttons                                      */
#define LOFT_INPUT_RESUME       0x4000u
#define LOFT_INPUT_PROBE        0x8000u     /* it only ends jobs whose guard names it           */
#define LOFT_INPUT_ENDING       0x1FFFu     /* inputs that end a job and let no job begin       */

enum loft_verb {
    LOFT_HOLD   = 1,        /* slow down on the path and stop                                   */
    LOFT_RESUME = 2,
    LOFT_ABORT  = 3,        /* slow down on the path, end the job                               */
    LOFT_CLOSE  = 4,        /* the report was read: forget the job                              */
    LOFT_OVERRIDE = 5,      /* run time at `value` percent of the plan                          */
    LOFT_PLACE  = 6,        /* the machine stands at `position`: bit i of `value`: axis i       */
    LOFT_TABLE_LOW  = 7,    /* the table begins there: axes as above; there is none till it ends */
    LOFT_TABLE_HIGH = 8     /* it ends there, and counts from now on                            */
};

/* What a machine can do besides its kinds of items: bits of `kinds`. */
#define LOFT_TAKES_GUARDS 0x01u         /* a JOB with a guard   */
#define LOFT_TAKES_PLACES 0x80u         /* LOFT_PLACE           */
#define LOFT_TAKES_TABLE  0x08u         /* LOFT_TABLE_LOW, LOFT_TABLE_HIGH */
#define LOFT_TAKES_ACTIONS 0x20u        /* actions among spans  */
#define LOFT_TAKES_SETTINGS 0x40u       /* LOFT_SET             */

/* A guard ends a job when an input changes: see machine/latch.h. */
#define LOFT_GUARD_OPENS 1u             /* an input that opens, in place of one that closes */
#define LOFT_GUARD_EDGE  2u             /* not one that is like that already: it changes first */
#define LOFT_GUARD_HARD  4u             /* stop at once, not slowing down: see loft_drive_halt */
#define LOFT_GUARD_SQUARE 8u            /* both ends of an axis with two motors: each stops at its
                                         * own switch; true when both are closed */

typedef struct {
    uint16_t inputs;                    /* any of these; 0: no guard */
    uint8_t  how;                       /* a sum of LOFT_GUARD_ */
    uint8_t  filter;                    /* ms that the input must stay so */
} loft_guard;

typedef struct {
    uint8_t  min_version, max_version;
    uint32_t nonce;                     /* any number, different for each connection    */
} loft_hello;

/* Limits of a job for a machine that plans, in addition to its own limits. */
typedef struct {
    int32_t corner, tol;                /* as in lib/path/limits.h, mm, raw Q16.16 */
    struct {
        int32_t  max_speed, max_accel;  /* raw Q16.16; the machine's own limits prevail */
        uint32_t max_jerk;              /* mm/s^3; 0: not limited */
    } axis[LOFT_AXES];
} loft_job_limits;

typedef struct {
    uint32_t nonce;                     /* of the session's HELLO: the job is for this connection */
    uint32_t id;                        /* not 0; the same for the same job, see loft_job_id */
    uint8_t  kind;                      /* enum loft_kind */
    uint16_t away;                      /* inputs it moves away from: ignored until they open */
    loft_guard guard;
    int32_t  start[LOFT_AXES];          /* spans, curves: raw Q16.16 mm; points: steps */
    const loft_job_limits *limits;      /* encode: for curves; decode sets it to NULL */
} loft_job;

typedef struct {
    uint8_t number;                     /* counts up; each number is executed once */
    uint8_t verb;                       /* enum loft_verb */
    uint8_t value;                      /* LOFT_OVERRIDE: 1..200; with a position: axes; else 0 */
    int32_t position[LOFT_AXES];        /* of LOFT_PLACE and the table: steps */
} loft_control;

#define LOFT_KEPT_MOST 32               /* bytes of settings in a frame */

/* Ask for settings, or write some: see machine/settings.h. */
typedef struct {
    uint16_t at;                        /* where, in a copy of the settings */
    uint8_t  count;                     /* 0: a question */
    const uint8_t *byte;                /* into the frame */
} loft_set;

/* Where the settings in force come from. */
enum loft_settings_origin {
    LOFT_SETTINGS_KEPT,                 /* from the machine's memory */
    LOFT_SETTINGS_USUAL,                /* from its firmware: nothing was written yet */
    LOFT_SETTINGS_DAMAGED               /* from its firmware: what was written is damaged */
};

/* The answer to SET. */
typedef struct {
    uint16_t at;                        /* as in SET */
    uint16_t room;                      /* bytes that settings may have */
    uint8_t  origin;                    /* enum loft_settings_origin */
    bool     busy;                      /* a job is under way: nothing was written */
    uint8_t  count;
    uint8_t  byte[LOFT_KEPT_MOST];      /* of the settings in force; after a write beyond the check,
                                         * what was written, read back */
} loft_kept;

/* The progress of a job: part of every answer. */
typedef struct {
    uint32_t next;                      /* items taken = number of the next expected item */
    uint32_t limit;                     /* items below this number may be sent */
    uint32_t executed;                  /* items executed entirely */
    uint8_t  state;                     /* enum loft_machine_state */
    uint8_t  flags;                     /* of enum loft_flag */
    uint8_t  refusal;                   /* enum loft_refusal: the last one in this session */
    uint8_t  control;                   /* number of the last CONTROL executed in this session */
} loft_ack;

typedef struct {
    uint8_t  version;                   /* 0: no common version */
    uint32_t nonce;                     /* that of the HELLO */
    uint32_t boot;                      /* different for each start of the machine */
    uint32_t job;                       /* 0: none */
    loft_ack ack;
    uint8_t  axes;
    uint8_t  num;                       /* LOFT_Q16, LOFT_F32, LOFT_F64 */
    uint8_t  frame_max;                 /* the longest frame that the machine accepts */
    uint16_t queue;                     /* the number of spans that fit the queue */
    uint16_t tick_hz;                   /* ticks per second */
    uint16_t slots;                     /* chances to step per tick */
    uint8_t  kinds;                     /* bit k: items of kind k are accepted; LOFT_TAKES_ */
    uint16_t curves;                    /* curves that fit its plan; 0: it does not plan */
    uint16_t points;                    /* points that fit its queue at least */
    uint16_t closed;                    /* closed inputs */
    uint8_t  outputs;                   /* that actions may set: 1 .. outputs */
    uint16_t columns;                   /* curves of a line of a patch; 0: it takes none */
} loft_welcome;

/* One per axis after each WELCOME. */
typedef struct {
    uint8_t number;                     /* 0 .. axes - 1 */
    int32_t steps_per_mm;               /* raw Q16.16 */
    int32_t max_speed;                  /* mm/s, raw Q16.16 */
    int32_t max_accel;                  /* mm/s^2, raw Q16.16 */
    int32_t position;                   /* steps */
    int32_t start;                      /* of the job, as in loft_job; 0 if there is no job */
} loft_axis;

typedef struct {
    loft_ack ack;
    uint32_t ticks;                     /* ticks of the job's plan executed */
    uint32_t elapsed;                   /* ticks of time since the job began */
    uint32_t slowed;                    /* ticks that lasted longer: their steps did not fit */
    uint32_t damaged;                   /* frames that arrived damaged */
    uint32_t dropped;                   /* good frames not taken: repeated, early, unknown, stale */
    uint8_t  override;                  /* percent, as ordered */
    uint16_t closed;                    /* closed inputs */
    int32_t  position[LOFT_AXES];       /* steps */
} loft_machine_status;

typedef struct {
    uint32_t job;
    uint32_t items;                     /* items executed */
    uint32_t ticks, elapsed, slowed;    /* as in loft_machine_status */
    uint8_t  state;                     /* LOFT_STATE_DONE or LOFT_STATE_ABORTED */
    uint16_t ended_by;                  /* the inputs that ended the job; 0: none */
    bool     guarded;                   /* the job had a guard */
    int32_t  position[LOFT_AXES];       /* steps: the sum of all pulses */
    int32_t  latched[LOFT_AXES];        /* of a guard that has ended the job: steps, where its input
                                         * changed */
} loft_report;


// Any frame
// ---------

/* The type of a frame's content, and its session. */
static inline enum loft_message loft_message_type(const loft_frame *f)
{
    return (enum loft_message)(f->byte[0] >> 4);
}
static inline uint8_t loft_message_version(const loft_frame *f) { return f->byte[0] & 15; }
static inline uint8_t           loft_message_session(const loft_frame *f) { return f->byte[1]; }


// Host to machine: each encode returns the length of the frame
// ------------------------------------------------------------

/* HELLO begins with an additional 0x00, which ends whatever was on the line. */
size_t loft_hello_encode(const loft_hello *m, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_job_encode(const loft_job *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_end_encode(uint32_t total, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_control_encode(const loft_control *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_poll_encode(uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_set_encode(const loft_set *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);

/* SPANS, POINTS, FINE and CURVES: init prepares `p` to pack items into the frame, encode finishes
 * it with the packed items. `frame_max` is the longest frame that the machine accepts;
 * LOFT_FRAME_MAX applies as well. `seal` is loft_predictor_seal of `predictor`, before the
 * items. */
void loft_data_init(loft_packer *p, enum loft_kind kind, const loft_predictor *predictor,
                    uint8_t frame_max, uint8_t wire[LOFT_FRAME_MAX]);
bool   loft_data_carried(const loft_frame *f);     /* true: it is one of the four */
size_t loft_data_encode(const loft_packer *p, uint32_t first, uint32_t seal, uint8_t session,
                        uint8_t wire[LOFT_FRAME_MAX]);

/* SPANS, POINTS, FINE or CURVES: the number of the first item modulo 65536. Check it before the
 * seal, because only the expected item has a predictor for the seal. LOFT_ERR_DATA: too short. */
enum loft_status loft_data_first(const loft_frame *f, uint16_t *first) LOFT_CHECKED;

/* Each decode gives LOFT_ERR_DATA if the content has another length, or a value that its table does
 * not list. */
enum loft_status loft_hello_decode(const loft_frame *f, loft_hello *m) LOFT_CHECKED;
enum loft_status loft_job_decode(const loft_frame *f, loft_job *m) LOFT_CHECKED;
/* For a JOB of curves. */
enum loft_status loft_job_limits_decode(const loft_frame *f, loft_job_limits *m) LOFT_CHECKED;
enum loft_status loft_end_decode(const loft_frame *f, uint32_t *total) LOFT_CHECKED;
enum loft_status loft_control_decode(const loft_frame *f, loft_control *m) LOFT_CHECKED;
enum loft_status loft_data_decode(const loft_frame *f, loft_unpacker *u) LOFT_CHECKED;
enum loft_status loft_set_decode(const loft_frame *f, loft_set *m) LOFT_CHECKED;


// Machine to host
// ---------------

/* Each encode returns the length of the frame. WELCOME may grow at its end in later versions:
 * additional bytes are not an error. */
size_t loft_welcome_encode(const loft_welcome *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_axis_encode(const loft_axis *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_ack_encode(const loft_ack *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_machine_status_encode(const loft_machine_status *m, uint8_t session,
                                  uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_report_encode(const loft_report *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);
size_t loft_kept_encode(const loft_kept *m, uint8_t session, uint8_t wire[LOFT_FRAME_MAX]);

/* Each decode gives LOFT_ERR_DATA as those of the other direction. */
enum loft_status loft_welcome_decode(const loft_frame *f, loft_welcome *m) LOFT_CHECKED;
enum loft_status loft_axis_decode(const loft_frame *f, loft_axis *m) LOFT_CHECKED;
enum loft_status loft_ack_decode(const loft_frame *f, loft_ack *m) LOFT_CHECKED;
enum loft_status loft_machine_status_decode(const loft_frame *f,
                                            loft_machine_status *m) LOFT_CHECKED;
enum loft_status loft_report_decode(const loft_frame *f, loft_report *m) LOFT_CHECKED;
enum loft_status loft_kept_decode(const loft_frame *f, loft_kept *m) LOFT_CHECKED;

LOFT_END_C

#endif

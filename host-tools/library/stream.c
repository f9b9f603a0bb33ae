/* host-tools/library/stream.c -- a job, stepped
 * SPDX-License-Identifier: MIT
 */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "arrange/tools.h"      /* tools_part */
#include "base/memory.h"
#include "library/inside.h"
#include "plan/missing.h"       /* missing_tell */
#include "send/greeted.h"       /* stream_machine */

#define ANSWER  5.0             /* s for the first one */
#define SILENCE 10.0            /* s until we give up */
#define PORTION 0.005           /* s of planning in a step */
#define FULL    20              /* ms until the line is looked at again, if it is full */
#define KEPT    4               /* items before those that the machine has */

struct loft_host_job {
    loft_host *h;
    loft_host_port port;
    host_plan k;
    loft_sender s;
    bool began, opened;         /* a step was; the job is planned, from the machine's place */
    double since;               /* the time of the first step */
    uint64_t got;               /* bytes */
    uint8_t out[LOFT_FRAME_MAX + 1];
    size_t out_size, out_at;
    size_t kept;                /* items before it will not be asked for again */
    int planned;                /* enum loft_status */
    int code;                   /* of the end; LOFT_HOST_GOES before */
};

static uint32_t ms_of(double now) { return (uint32_t)(uint64_t)(1000 * now); }

static int refuse(loft_host_job *j, int code, const char *name, const char *remedy,
                  const char *what)
{
    return host_error(&j->h->h, code, name, (host_place){ j->port.name, 0 }, remedy, "%s", what);
}

int loft_host_stream(loft_host *h, loft_host_drawing *d, const loft_host_plan_options *o,
                     const loft_host_port *port, loft_host_job **out)
{
    loft_host_job *j = memory_grow(NULL, sizeof *j);

    *j       = (loft_host_job){ .h = h, .port = *port, .planned = LOFT_OK };
    *out     = j;
    const int code = host_plan_start(h, &j->k, d, o);
    j->code        = code == 0 ? LOFT_HOST_GOES : code;
    return code;
}

void loft_host_job_free(loft_host_job *j)
{
    if (j != NULL)
        host_plan_free(&j->k);
    free(j);
}


// Bytes
// -----

/* What has arrived comes before what is sent: after a rest, answers that wait are not late. */
static bool take_bytes(loft_host_job *j, double now)
{
    uint8_t bytes[512];
    long got;

    while ((got = j->port.get(j->port.context, bytes, sizeof bytes)) > 0) {
        j->got += (uint64_t)got;
        for (long i = 0; i < got; i++)
            (void)loft_sender_push(&j->s, bytes[i], ms_of(now));
        if ((size_t)got < sizeof bytes)
            break;
    }
    return got >= 0;
}

/* Send frames until there are none, or until the line is full. */
static bool put_frames(loft_host_job *j, double now)
{
    for (;;) {
        if (j->out_at == j->out_size) {
            j->out_at   = 0;
            j->out_size = loft_sender_poll(&j->s, ms_of(now), j->out);
            if (j->out_size == 0)
                return true;
        }
        const long put = j->port.put(j->port.context, j->out + j->out_at, j->out_size - j->out_at);
        if (put < 0)
            return false;
        j->out_at += (size_t)put;
        if (put == 0)
            return true;
    }
}


// The job
// -------

/* Plan from where the greeted machine stands, and begin. */
static int open_job(loft_host_job *j)
{
    double start[ENGINE_AXES];
    job_options as         = { .patch = NULL };
    const tools_part all   = { .d = j->k.smooth, .smooth = j->k.smooth };
    const missing_job asks = { .file = j->k.file, .part = &all, .count = 1 };

    j->opened = true;
    if (j->s.ack.flags & LOFT_FLAG_LOST)
        return refuse(j, EX_UNAVAILABLE, "host.place-in-doubt", "home it",
                      "the position of the machine is in doubt, as after an emergency stop");
    as.does = (struct job_does){ .actions = j->s.machine.kinds & LOFT_TAKES_ACTIONS,
                                 .outputs = j->s.machine.outputs,
                                 .s_max   = j->k.p.machine.s_max,
                                 .spin_up = j->k.p.machine.spin_up };
    int code = j->k.p.machine.laser > 0 ? missing_laser(&j->h->h, &asks, &as.does) : 0;
    if (code == 0)
        code = missing_tell(&j->h->h, &asks, &as.does);
    stream_machine(&j->s, &as.limits);
    for (int i = 0; i < ENGINE_AXES; i++)
        as.steps_per_mm[i] = j->s.axis[i].steps_per_mm;
    stream_new_start(&j->s, start);
    if (code == 0)
        code = host_plan_job(j->h, &j->k, start, &as);
    if (code != 0)
        return code;
    if (j->k.p.machine.hard_stop > 0 && !stream_guard(&j->s, &j->k.w.j.head))
        return refuse(j, EX_CONFIG, "host.limit-stop",
                      "give limit_stop = ramp, or a newer firmware",
                      "limit_stop = hard: this machine slows down on the path");
    if (loft_sender_begin(&j->s, &j->k.w.j.head, job_items(&j->k.w.j), job_source, &j->k.w.j) !=
        LOFT_OK)
        return refuse(j, EX_SOFTWARE, "host.not-begun", "please report this",
                      "the job could not begin");
    loft_sender_extend(&j->s, (uint32_t)job_ready(&j->k.w.j), job_items(&j->k.w.j));
    return 0;
}

/* Plan on, if that is wanted. Returns true if more is. */
static bool plan_portion(loft_host_job *j)
{
    job *of = &j->k.w.j;

    if (j->s.phase != LOFT_PHASE_STREAMING || j->planned != LOFT_OK)
        return false;
    if (j->s.ack.executed > j->kept + KEPT)
        j->kept = j->s.ack.executed - KEPT;
    if (!job_waits(of, j->kept))
        return false;
    j->planned = job_plan(of, j->kept, PORTION);
    loft_sender_extend(&j->s, (uint32_t)job_ready(of), job_items(of));
    if (j->planned != LOFT_OK)
        loft_sender_control(&j->s, LOFT_ABORT);
    return j->planned == LOFT_OK && job_waits(of, j->kept);
}

static int end_drawn(loft_host_job *j)
{
    int32_t want[LOFT_AXES];

    stream_commanded(&j->s, &j->k.w.j, want);
    if (memcmp(want, j->s.report.position, sizeof want) == 0)
        return 0;
    return refuse(j, EX_PROTOCOL, "host.elsewhere", "home it, and please report this",
                  "the machine does not stand where the job ends");
}

static int end_refused(loft_host_job *j)
{
    static const struct {
        int code;
        const char *name, *what, *remedy;
    } row[] = {
        [LOFT_REFUSAL_NONE] = { EX_TEMPFAIL, "host.aborted", "the job was ended on the path",
                                NULL },
        [LOFT_REFUSAL_BUSY]  = { EX_TEMPFAIL, "host.busy", "the machine is busy", "wait" },
        [LOFT_REFUSAL_START] = { EX_TEMPFAIL, "host.moved",
                                 "the machine has moved since it was asked for its position",
                                 "begin again" },
        [LOFT_REFUSAL_KIND]  = { EX_CONFIG, "host.kind",
                                 "the machine does not accept items of this kind",
                                 "give it a newer firmware" },
        [LOFT_REFUSAL_ITEM]  = { EX_DATAERR, "host.item", "the machine cannot do an item",
                                 "give less feed or acceleration" },
        [LOFT_REFUSAL_FAULT] = { EX_UNAVAILABLE, "host.fault",
                                 "the machine does not know its position", "restart and home it" },
        [LOFT_REFUSAL_LIMITS] = { EX_DATAERR, "host.limits",
                                  "the machine cannot plan within these limits",
                                  "give other limits" },
        [LOFT_REFUSAL_INPUT] = { EX_UNAVAILABLE, "host.input",
                                 "a limit switch or the emergency stop is closed",
                                 "move away from it" },
        [LOFT_REFUSAL_TABLE] = { EX_DATAERR, "host.table", "an item leaves the table",
                                 "move the drawing, or home the machine again" },
        [LOFT_REFUSAL_PATCH] = { EX_DATAERR, "host.patch", "the machine cannot cut this patch",
                                 NULL },
    };
    const unsigned why = j->s.refusal < sizeof row / sizeof row[0] ? j->s.refusal : 0;

    return refuse(j, row[why].code, row[why].name, row[why].remedy, row[why].what);
}

/* How a job ended whose sender has ended. */
static int end_job(loft_host_job *j)
{
    if (j->planned != LOFT_OK)
        return job_refuse(&j->h->h, &j->k.w.j, j->k.file, j->planned,
                          "; the job was ended on the path");
    switch (j->s.phase) {
    case LOFT_PHASE_DONE: return end_drawn(j);
    case LOFT_PHASE_BUSY:
        return refuse(j, EX_TEMPFAIL, "host.other-job", "wait, or abort it",
                      "another job is running");
    case LOFT_PHASE_LOST:
        return refuse(j, EX_PROTOCOL, "host.restarted", "home it, then begin again",
                      "the machine was restarted in the job: its position may be lost");
    case LOFT_PHASE_UNFIT:
        return refuse(j, EX_CONFIG, "host.unfit", "give both the same release",
                      "the machine has other axes, or speaks another version");
    default: return end_refused(j);
    }
}

/* Has the machine been silent for too long? */
static int judge_silence(loft_host_job *j, double now)
{
    const double silent = loft_sender_silence(&j->s, ms_of(now)) / 1000.0;

    if (j->s.phase == LOFT_PHASE_HELLO && !j->opened && now - j->since > ANSWER)
        return j->got > 0 ? refuse(j, EX_PROTOCOL, "host.no-frame",
                                   "is it a loft machine, and is its speed right?",
                                   "bytes came, but no good frame")
                          : refuse(j, EX_UNAVAILABLE, "host.no-answer",
                                   "look at its power and its cable", "no machine has answered");
    if (j->opened && silent > SILENCE)
        return refuse(j, EX_IOERR, "host.silent", "look at the cable, then begin again",
                      "the machine has been silent: it stops on the path");
    return 0;
}

static int gone(loft_host_job *j)
{
    loft_sender_hangup(&j->s);
    if (j->s.phase == LOFT_PHASE_DONE)
        return end_job(j);
    return refuse(j, EX_IOERR, "host.port-gone", "plug it in, and begin again",
                  "the port has vanished");
}

/* Returns LOFT_HOST_GOES, or how it ended. */
static int step(loft_host_job *j, double now)
{
    if (!take_bytes(j, now))
        return gone(j);
    if (j->s.phase >= LOFT_PHASE_DONE)
        return end_job(j);
    int code = judge_silence(j, now);
    if (code == 0 && j->s.phase == LOFT_PHASE_READY && !j->opened)
        code = open_job(j);
    if (code != 0)
        return code;
    return put_frames(j, now) ? LOFT_HOST_GOES : gone(j);
}

int loft_host_step(loft_host_job *j, double now, loft_host_wants *wants)
{
    *wants = (loft_host_wants){ .ms = 0 };
    if (j->code != LOFT_HOST_GOES)
        return j->code;
    if (!j->began) {
        j->began = true;
        j->since = now;
        loft_sender_init(&j->s, (uint32_t)(uint64_t)(1e6 * now) ^ (uint32_t)(uintptr_t)j,
                         ms_of(now));
    }
    const bool more = plan_portion(j);
    j->code         = step(j, now);
    if (j->code == LOFT_HOST_GOES && !more)
        wants->ms = (int)loft_sender_wait(&j->s, ms_of(now));
    wants->put = j->out_at < j->out_size;
    if (wants->put && wants->ms < FULL)
        wants->ms = FULL;
    return j->code;
}


// Meanwhile
// ---------

static void ask(loft_host_job *j, enum loft_verb verb)
{
    if (j->opened)
        loft_sender_control(&j->s, verb);
}

void loft_host_hold(loft_host_job *j)   { ask(j, LOFT_HOLD); }
void loft_host_resume(loft_host_job *j) { ask(j, LOFT_RESUME); }
void loft_host_abort(loft_host_job *j)  { ask(j, LOFT_ABORT); }

void loft_host_override(loft_host_job *j, unsigned percent)
{
    if (j->opened)
        loft_sender_override(&j->s, percent < 10 ? 10 : percent > 200 ? 200 : percent);
}

static const char *state_of(const loft_host_job *j)
{
    if (j->code != LOFT_HOST_GOES)
        return "over";
    if (j->s.phase < LOFT_PHASE_STREAMING)
        return "greets";
    switch (j->s.ack.state) {
    case LOFT_STATE_HOLDING:  return "holds";
    case LOFT_STATE_HELD:     return "held";
    case LOFT_STATE_STOPPING: return "aborts";
    default:                  return j->s.phase < LOFT_PHASE_DONE ? "draws" : "over";
    }
}

void loft_host_job_state(const loft_host_job *j, loft_host_job_facts *out)
{
    const loft_sender *s = &j->s;
    const bool over      = s->phase == LOFT_PHASE_DONE ||
                      (s->phase == LOFT_PHASE_ABORTED && s->report.job != 0);
    const int32_t *at = over ? s->report.position : s->status.position;
    const double hz   = s->machine.tick_hz > 0 ? s->machine.tick_hz : 1;

    *out = (loft_host_job_facts){ .state = state_of(j) };
    if (!j->opened || s->phase < LOFT_PHASE_STREAMING)
        return;
    out->done  = s->status.ticks / hz;
    out->total = job_ticks(&j->k.w.j) / hz;
    out->item  = over ? s->report.items : s->ack.executed;
    out->items = job_items(&j->k.w.j) == LOFT_ITEMS_OPEN ? 0 : job_items(&j->k.w.j);
    memcpy(out->steps, at, sizeof out->steps);
    stream_place(s, &j->k.p.machine.k, at, out->at);
}

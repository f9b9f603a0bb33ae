/* host-tools/send/stream.c -- sends a job to the machine
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "send/stream.h"
#include "send/stream_end.h"     /* stream_drawn, stream_place */
#include "base/tool.h"

#define SILENCE 10.0        /* s of silence until we give up */
#define STOP    10.0        /* s for the machine to stop */
#define PORTION 0.005       /* s of planning in a step */
#define LOOK    0.02        /* s between two looks at the machine */
#define RECORD  2.0         /* s until the record of a simulated machine is complete, */
#define RECORD_LOOK 0.05    /* and between two looks at it */
/* items before those that the machine has: the sender needs 3, a feed needs 1 */
#define KEPT    4

static bool machine_is_stopped(const loft_sender *s)
{
    return s->ack.state == LOFT_STATE_HELD || !loft_state_busy(s->ack.state);
}

/* The state of the machine, padded to a fixed width so that the numbers after it do not move. */
static void state_text(const stream *r, char text[32])
{
    const loft_sender *s = &r->t->sender;

    switch (s->ack.state) {
    case LOFT_STATE_HOLDING:  snprintf(text, 32, "%-16s", "slowing down");    return;
    case LOFT_STATE_HELD:
        snprintf(text, 32, "%-16s", r->pause ? "pause, r resumes" : "held, r resumes");
        return;
    case LOFT_STATE_STOPPING: snprintf(text, 32, "%-16s", "aborting");        return;
    default: break;
    }
    if ((s->ack.flags & LOFT_FLAG_STARVED) && r->pace < 0.02)
        snprintf(text, 32, "%-16s", "waits for data");
    else
        snprintf(text, 32, "feed %5.1f mm/s ",
                 r->pace * job_feed(r->j, job_item_at(r->j, s->status.ticks)));
}

/* Ticks of the plan per tick of time, between two answers. */
static void measure_pace(stream *r)
{
    const loft_machine_status *now = &r->t->sender.status;

    if (now->ticks != r->ticks)
        r->moved = r->t->now;
    if (now->elapsed == r->elapsed)
        return;
    r->pace    = (double)(now->ticks - r->ticks) / (double)(now->elapsed - r->elapsed);
    r->ticks   = now->ticks;
    r->elapsed = now->elapsed;
}

/* Does the job rest until somebody or something lets it continue? */
static bool time_rests(const stream *r)
{
    const loft_sender *s = &r->t->sender;

    return s->ack.state == LOFT_STATE_HELD ||
           ((s->ack.flags & LOFT_FLAG_STARVED) && r->pace < 0.02);
}

/* What keeps the job from continuing, or NULL. */
static const char *awaited_event(const stream *r, char text[200])
{
    const loft_sender *s = &r->t->sender;

    if (s->phase == LOFT_PHASE_HELLO)
        return "the machine does not answer: look at cable and power";
    if (s->phase == LOFT_PHASE_OPENING)
        return "the machine has not taken the job";
    if (s->phase != LOFT_PHASE_STREAMING || r->to.shown)
        return NULL;
    switch (s->ack.state) {
    case LOFT_STATE_HOLDING:    return "the machine slows down to a hold";
    case LOFT_STATE_STOPPING:   return "the machine slows down, then the job is over";
    case LOFT_STATE_HELD:
        snprintf(
            text, 200,
            r->pause
                ? "the program pauses: end this command, then `loft stream --resume "
                  "--port %s` goes on, and --abort gives up"
                : "the machine is held: end this command, then `loft stream --resume --port %s` "
                  "goes on, and --abort gives up",
            r->t->port);
        return text;
    default: break;
    }
    if (r->t->now - r->moved < 3 * LOFT_SENDER_POLL / 1000.0)
        return NULL;
    if (job_items(r->j) == LOFT_ITEMS_OPEN && job_ready(r->j) < s->ack.next)
        return "planning up to where the machine stands";
    if (job_items(r->j) == LOFT_ITEMS_OPEN && job_ready(r->j) == s->ack.next)
        return "the machine has all that is planned by now: it waits for more";
    if (s->ack.flags & LOFT_FLAG_STARVED)
        return "the machine waits for data: this computer or the line is slow";
    if (r->j->head.kind == LOFT_CURVES && s->status.ticks == 0)
        return "the machine plans";
    return s->ack.next < s->window.count ? "the machine's queue is full, and it does not move"
                                         : "the machine has all items, and does not move";
}

/* The state in one word, for a program. */
static const char *state_word(const stream *r)
{
    switch (r->t->sender.ack.state) {
    case LOFT_STATE_HOLDING:  return "holds";
    case LOFT_STATE_HELD:     return r->pause ? "pause" : "held";
    case LOFT_STATE_STOPPING: return "aborts";
    default:                  return time_rests(r) ? "waits" : "draws";
    }
}

static send_facts facts_of(const stream *r)
{
    const loft_sender *s = &r->t->sender;
    const uint32_t items = job_items(r->j);
    const bool stale     = s->status.ack.executed > s->ack.executed;     /* of the job before */
    const uint32_t ticks = stale ? 0 : s->status.ticks;
    const bool rests     = stale || time_rests(r);
    const size_t item    = job_item_at(r->j, ticks);

    return (send_facts){ .state = state_word(r),
                         .done = (double)ticks,
                         .total = job_ticks(r->j),
                         .item = s->ack.executed,
                         .items = items == LOFT_ITEMS_OPEN ? 0 : items,
                         .queued = s->ack.next - s->ack.executed,
                         .feed = rests ? 0 : r->pace * job_feed(r->j, item),
                         .override = s->status.override,
                         .moves = job_moves(r->j, s->ack.executed),
                         .rests = rests };
}

bool stream_facts(stream *r, send_facts *f, char words[160])
{
    const loft_sender *s = &r->t->sender;
    char state[32];

    if (s->phase != LOFT_PHASE_STREAMING)
        return false;
    measure_pace(r);
    state_text(r, state);
    *f = facts_of(r);
    stream_place(s, r->about->k, s->status.position, f->at);
    if (job_items(r->j) == LOFT_ITEMS_OPEN && job_ready(r->j) < s->ack.next) {
        f->state = "plans";
        f->done  = (double)job_ready(r->j);
        f->total = (double)s->ack.next;
        f->rests = false;
        snprintf(words, 160, "planning up to where the machine stopped");
        return true;
    }
    size_t used = (size_t)snprintf(words, 160, "%s %3u %%  queue %3u ", state, s->status.override,
                                   (unsigned)(s->ack.next - s->ack.executed));
    for (int i = 0; i < LOFT_AXES; i++)
        used += (size_t)snprintf(words + used, 160 - used, " %c %.2f", "XYZABC"[i], f->at[i]);
    return true;
}

/* Tell the current state in one line; it stays on the screen. */
static void tell_state(stream *r)
{
    const loft_sender *s = &r->t->sender;
    char state[32], of[32], place[96];
    double at[LOFT_AXES];
    size_t used = 0;

    state_text(r, state);
    stream_place(s, r->about->k, s->status.position, at);
    for (int i = 0; i < LOFT_AXES; i++)
        used += (size_t)snprintf(place + used, sizeof place - used, " %c %.2f", "XYZABC"[i], at[i]);
    send_tell(&r->to, SEND_EVENT, "item %u%s, %u queued, override %u %%, %s%s",
              (unsigned)s->ack.executed, job_of(r->j, of),
              (unsigned)(s->ack.next - s->ack.executed), s->status.override, state, place);
}

/* A key counts from the override that was last asked for, which the machine may not have confirmed
 * yet. */
static void change_override(stream *r, int by)
{
    loft_sender *s = &r->t->sender;
    const int now  = r->percent ? r->percent : s->status.override, next = by == 0 ? 100 : now + by;

    if (now == 0)
        return;
    r->percent = next < 10 ? 10 : next > 200 ? 200 : next;
    loft_sender_override(s, (unsigned)r->percent);
}

void stream_key(stream *r, int key)
{
    loft_sender *s = &r->t->sender;

    switch (key) {
    case '+':
    case '=': change_override(r, 10); break;
    case '-':
    case '_': change_override(r, -10); break;
    case '0': change_override(r, 0); break;
    case 's': tell_state(r); break;
    case 'h': loft_sender_control(s, LOFT_HOLD);   break;
    case 'r': loft_sender_control(s, LOFT_RESUME); break;
    case '\r':
    case '\n':
        if (r->pause != NULL)
            loft_sender_control(s, LOFT_RESUME);
        break;
    case 'a': loft_sender_control(s, LOFT_ABORT);  break;
    default:  break;
    }
}

/* Report and prepare, once, when a running job is found. */
static void wake_job(stream *r)
{
    const loft_sender *s = &r->t->sender;
    char of[32];

    if (s->phase < LOFT_PHASE_STREAMING || !s->resumed || r->woken)
        return;
    r->woken    = true;
    job_sent_from(r->j, s->ack.next);
    send_tell(&r->to, SEND_EVENT, "resuming at item %u%s", (unsigned)s->ack.next, job_of(r->j, of));
    r->resting = s->ack.state == LOFT_STATE_HELD || s->ack.state == LOFT_STATE_HOLDING;
}

/* A job that stands still may be in a pause of the program: the plan knows, when it has come so
 * far. Then the user decides. A hold of an earlier program ends. */
static void watch_pauses(stream *r)
{
    const loft_sender *s = &r->t->sender;
    const char *before   = r->pause;

    if (s->phase != LOFT_PHASE_STREAMING || (!r->j->whole && r->j->count < s->ack.executed))
        return;
    r->pause = s->ack.state == LOFT_STATE_HELD ? job_pause(r->j, s->ack.executed) : NULL;
    if (r->pause != NULL && r->pause != before)
        send_tell(&r->to, SEND_EVENT, "pause%s%s: Enter goes on, a gives up", *r->pause ? ": " : "",
                  r->pause);
    if (r->resting && r->pause == NULL && r->stop_at <= 0)
        loft_sender_control(&r->t->sender, LOFT_RESUME);
    r->resting = false;
}

/* Asked for the end: hold, and wait until the machine has stopped and reported its position.
 * Returns true when that is done or takes too long. */
static bool has_stopped(stream *r)
{
    const double now = r->t->now;

    if (!r->t->stop)
        return false;
    if (r->stop_at <= 0) {
        r->stop_at = now;
        loft_sender_control(&r->t->sender, LOFT_HOLD);
    }
    if (!machine_is_stopped(&r->t->sender) || r->t->sender.phase < LOFT_PHASE_STREAMING)
        r->held_at = 0;
    else if (r->held_at <= 0)
        r->held_at = now;
    return (r->held_at > 0 && now - r->held_at > 3 * LOFT_SENDER_POLL / 1000.0) ||
           now - r->stop_at > STOP;
}

/* The items that the machine has executed, as far as it has told. */
static const char *where_text(const stream *r, char text[64])
{
    char of[32];

    snprintf(text, 64, "at item %u%s ", (unsigned)r->t->sender.ack.executed, job_of(r->j, of));
    return text;
}

/* Plan a portion, if one is wanted. Returns true if another one is. Greetings and the end after ^C
 * come first: on a busy computer a portion may take long. */
static bool plan_portion(stream *r)
{
    loft_sender *s = &r->t->sender;

    if (s->phase != LOFT_PHASE_STREAMING || r->stop_at > 0 || r->planned != LOFT_OK)
        return false;
    if (s->ack.executed > r->kept + KEPT)
        r->kept = s->ack.executed - KEPT;
    if (!job_waits(r->j, r->kept))
        return false;
    r->planned = job_plan(r->j, r->kept, PORTION);
    loft_sender_extend(s, (uint32_t)job_ready(r->j), job_items(r->j));
    if (r->planned != LOFT_OK)
        loft_sender_control(s, LOFT_ABORT);
    return r->planned == LOFT_OK && job_waits(r->j, r->kept);
}

/* What comes next prints: whoever shows the job clears its line before. */
static int end_by(stream *r, double now, task_wants *w,
                  int (*stage)(stream *r, double now, task_wants *w))
{
    r->over  = true;
    r->stage = stage;
    task_wake(w, now);
    return TASK_GOES;
}

static int report_vanished(stream *r, double now, task_wants *w)
{
    char place[64];

    (void)now;
    (void)w;
    errno          = r->lost;
    const int code = talk_vanished(r->t, where_text(r, place));
    talk_over(r->t);
    return code;
}

static int report_silent(stream *r, double now, task_wants *w)
{
    char place[64];

    (void)now;
    (void)w;
    talk_over(r->t);
    return host_error(r->t->host, EX_IOERR, "job.silent", (host_place){ .file = r->t->port },
                      "it stops on the path; look at the cable, then run the same command again; "
                      "if it lost its power, the position may be lost: home it, or `loft zero`",
                      "the machine has been silent for %g s %s", SILENCE, where_text(r, place));
}

/* The job was drawn, and is as commanded. The record of the machine may not be complete yet. */
static int report_drawn(stream *r, double now, task_wants *w)
{
    char error[64];
    const int code = stream_error(r->t, r->about, now >= r->until, error);

    task_wake(w, now + RECORD_LOOK);
    if (code == 0)
        stream_drawn(r->t, r->j, r->about, &r->to, error);
    return code;
}

/* A job that was drawn before need not be planned completely yet: the rest, in portions, tells
 * where it ends. */
static int plan_rest(stream *r, double now, task_wants *w)
{
    job *j                = r->j;
    host *h               = r->t->host;
    const host_progress p = { "planning", job_part(j), 1, false };
    const bool more       = !j->whole && (j->head.kind != LOFT_CURVES || j->first > 0);

    if (more)
        r->planned = host_goes_on(h, &p) ? job_plan(j, j->count, PORTION) : JOB_STOPPED;
    if (more && r->planned == LOFT_OK) {
        task_wake(w, now);
        return TASK_GOES;
    }
    host_has_done(h);
    if (r->planned != LOFT_OK)
        return job_refuse(h, j, r->about->file, r->planned, "");
    const int code = stream_checked(r->t, j, &r->to);
    if (code != 0)
        return code;
    r->until = now + RECORD;
    r->stage = report_drawn;
    return report_drawn(r, now, w);
}

/* The sender has ended, or the machine has stopped. */
static int report_end(stream *r, double now, task_wants *w)
{
    talk *t = r->t;
    char then[96];

    talk_over(t);
    if (r->planned != LOFT_OK) {
        snprintf(then, sizeof then, "; the job was ended on the path before item %zu",
                 job_ready(r->j));
        return job_refuse(r->t->host, r->j, r->about->file, r->planned, then);
    }
    if (t->sender.phase < LOFT_PHASE_DONE)
        return stream_interrupted(t, r->j);
    if (t->sender.phase != LOFT_PHASE_DONE)
        return stream_ended(t, r->j);
    r->stage = plan_rest;
    return plan_rest(r, now, w);
}

static int draw(stream *r, double now, task_wants *w)
{
    loft_sender *s = &r->t->sender;

    if (!talk_step(r->t, now, w)) {
        r->lost = errno;
        loft_sender_hangup(s);
        return end_by(r, now, w, s->phase >= LOFT_PHASE_DONE ? report_end : report_vanished);
    }
    if (talk_silence(r->t, r->began) > SILENCE)
        return end_by(r, now, w, report_silent);
    task_wake(w, plan_portion(r) ? now : now + LOOK);
    wake_job(r);
    watch_pauses(r);
    if (has_stopped(r) || s->phase >= LOFT_PHASE_DONE)
        return end_by(r, now, w, report_end);
    talk_wants(r->t, w);
    const char *what = awaited_event(r, w->awaits);
    if (what != w->awaits)
        snprintf(w->awaits, sizeof w->awaits, "%s", what ? what : "");
    return TASK_GOES;
}

static int begin_job(stream *r, double now, task_wants *w)
{
    talk *t = r->t;
    job *j  = r->j;

    talk_begins(t, j->head.id, r->about->file);
    if (loft_sender_begin(&t->sender, &j->head, job_items(j), job_source, j) != LOFT_OK)
        return host_error(t->host, EX_SOFTWARE, "job.not-begun", (host_place){ .file = NULL },
                          "please report this", "the job could not begin");
    loft_sender_extend(&t->sender, (uint32_t)job_ready(j), job_items(j));
    r->began = now;
    r->stage = draw;
    return t->sender.phase < LOFT_PHASE_DONE ? draw(r, now, w) : end_by(r, now, w, report_end);
}

void stream_begin(stream *r, talk *t, job *j, const stream_subject *about, const send_teller *to)
{
    *r = (stream){ .t = t, .j = j, .about = about, .to = *to, .stage = begin_job };
}

int stream_step(stream *r, double now, task_wants *w) { return r->stage(r, now, w); }

static int step_stream(void *context, double now, task_wants *w)
{
    return stream_step(context, now, w);
}

task stream_task(stream *r) { return (task){ step_stream, r, &r->t->stop }; }

/* Has the machine done what `verb` asks? */
static bool verb_obeyed(const loft_sender *s, enum loft_verb verb)
{
    if (s->verb != 0)
        return false;
    return verb == LOFT_RESUME
               ? s->ack.state != LOFT_STATE_HELD && s->ack.state != LOFT_STATE_HOLDING
               : machine_is_stopped(s);
}

int stream_limits(const talk *t, bool hard, loft_job *head)
{
    if (!hard || stream_guard(&t->sender, head))
        return 0;
    return host_error(t->host, EX_CONFIG, "job.limit-stop", (host_place){ .file = t->port },
                      "give limit_stop = ramp, or a newer firmware",
                      "limit_stop = hard: this machine slows down on the path");
}

/* For some time after that, so that the machine tells where it stands. */
static bool has_obeyed(stream_control *c, double now)
{
    const loft_sender *s = &c->t->sender;

    if (c->done <= 0 && verb_obeyed(s, c->verb))
        c->done = now;
    return s->phase >= LOFT_PHASE_DONE ||
           (c->done > 0 && now - c->done >= 3 * LOFT_SENDER_POLL / 1000.0);
}

static int begin_control(stream_control *c, double now)
{
    loft_sender *s = &c->t->sender;

    if (!loft_state_busy(s->ack.state))
        return host_error(c->t->host, EX_UNAVAILABLE, "job.none-runs",
                          (host_place){ .file = c->t->port }, NULL,
                          "no job is running: nothing to %s",
                          c->verb == LOFT_HOLD     ? "hold"
                          : c->verb == LOFT_RESUME ? "resume"
                                                   : "abort");
    loft_sender_control(s, c->verb);
    c->began = now;
    return 0;
}

int stream_control_step(stream_control *c, double now, task_wants *w)
{
    int code = c->began > 0 ? 0 : begin_control(c, now);

    if (code != 0)
        return code;
    if (!talk_step(c->t, now, w))
        return talk_vanished(c->t, "");
    if (now - c->began > STOP)
        return host_error(c->t->host, EX_IOERR, "job.not-obeyed",
                          (host_place){ .file = c->t->port }, "look at the cable, or cut its power",
                          "the machine did not obey in %g s", STOP);
    task_wake(w, now + LOOK);
    if (c->done <= 0)
        snprintf(w->awaits, sizeof w->awaits, "%s",
                 c->verb == LOFT_RESUME ? "the machine does not go on yet"
                                        : "the machine is not stopped yet");
    if (!has_obeyed(c, now))
        return TASK_GOES;
    talk_over(c->t);
    stream_obeyed(c->t, c->verb, c->k, &c->to);
    return 0;
}

static int step_control(void *context, double now, task_wants *w)
{
    return stream_control_step(context, now, w);
}

void stream_control_begin(stream_control *c, talk *t, enum loft_verb verb, const kinematics *k,
                          const send_teller *to)
{
    *c = (stream_control){ .t = t, .verb = verb, .k = k, .to = *to };
}

task stream_control_task(stream_control *c) { return (task){ step_control, c, &c->t->stop }; }

/* host-tools/send/stream.c -- sends a job to the machine
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>              /* isatty */

#include "cmd/keys.h"           /* keys_next, keys_answer */
#include "cmd/report.h"         /* report_show */
#include "send/stream.h"
#include "send/stream_end.h"     /* stream_drawn, stream_place */
#include "base/tool.h"
#include "base/waits.h"          /* waits_due */

#define SILENCE 10.0        /* s of silence until we give up */
#define LIMIT_FILTER 1      /* ms that a limit switch must stay closed: sparks are shorter */
#define STOP    10.0        /* s for the machine to stop */
#define PORTION 0.005       /* s of planning between two looks at the line */
/* items before those that the machine has: the sender needs 3, a feed needs 1 */
#define KEPT    4

typedef struct {
    talk *t;
    job *j;
    const stream_subject *about;
    waits waiting;
    int planned;            /* enum loft_status                         */
    size_t kept;            /* items before it will not be asked for again */
    double stop_at;         /* the clock when ^C was seen; 0: not yet */
    double held_at;         /* the clock when the machine stopped; 0: not yet */
    bool woken;             /* a job that was already running continues */
    bool resting;           /* it was held then: it goes on, if that is no pause */
    const char *pause;      /* what the program says of the pause; NULL: there is none */
    bool answered;          /* by a pipe, and the machine has not told so yet */
    bool deaf;              /* standard input, which is no terminal, has ended */
    uint32_t ticks, elapsed;/* of the previous status */
    double pace;            /* between the last two */
    double moved;           /* the clock when the ticks last advanced */
    int percent;            /* that a key last asked for; 0: none */
} run_state;

static bool machine_is_stopped(const loft_sender *s)
{
    return s->ack.state == LOFT_STATE_HELD || !loft_state_busy(s->ack.state);
}

/* The state of the machine, padded to a fixed width so that the numbers after it do not move. */
static void state_text(const run_state *r, char text[32])
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
static void measure_pace(run_state *r)
{
    const loft_machine_status *now = &r->t->sender.status;

    if (now->ticks != r->ticks)
        r->moved = tool_clock();
    if (now->elapsed == r->elapsed)
        return;
    r->pace    = (double)(now->ticks - r->ticks) / (double)(now->elapsed - r->elapsed);
    r->ticks   = now->ticks;
    r->elapsed = now->elapsed;
}

/* Does the job rest until somebody or something lets it continue? */
static bool time_rests(const run_state *r)
{
    const loft_sender *s = &r->t->sender;

    return s->ack.state == LOFT_STATE_HELD ||
           ((s->ack.flags & LOFT_FLAG_STARVED) && r->pace < 0.02);
}

/* What keeps the job from continuing, or NULL. */
static const char *awaited_event(const run_state *r, char text[200])
{
    const loft_sender *s = &r->t->sender;

    if (s->phase == LOFT_PHASE_HELLO)
        return "the machine does not answer: look at cable and power";
    if (s->phase == LOFT_PHASE_OPENING)
        return "the machine has not taken the job";
    if (s->phase != LOFT_PHASE_STREAMING || report_shown())
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
    if (tool_clock() - r->moved < 3 * LOFT_SENDER_POLL / 1000.0)
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
static const char *state_word(const run_state *r)
{
    switch (r->t->sender.ack.state) {
    case LOFT_STATE_HOLDING:  return "holds";
    case LOFT_STATE_HELD:     return r->pause ? "pause" : "held";
    case LOFT_STATE_STOPPING: return "aborts";
    default:                  return time_rests(r) ? "waits" : "draws";
    }
}

static report_facts facts_of(const run_state *r)
{
    const loft_sender *s = &r->t->sender;
    const uint32_t items = job_items(r->j);
    const bool stale     = s->status.ack.executed > s->ack.executed;     /* of the job before */
    const uint32_t ticks = stale ? 0 : s->status.ticks;
    const bool rests     = stale || time_rests(r);
    const size_t item    = job_item_at(r->j, ticks);

    return (report_facts){ .state = state_word(r),
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

static void show_progress(run_state *r)
{
    const loft_sender *s = &r->t->sender;
    char state[32], text[160];

    measure_pace(r);
    state_text(r, state);
    report_facts f = facts_of(r);
    stream_place(s, r->about->k, s->status.position, f.at);
    if (job_items(r->j) == LOFT_ITEMS_OPEN && job_ready(r->j) < s->ack.next) {
        f.state = "plans";
        f.done  = (double)job_ready(r->j);
        f.total = (double)s->ack.next;
        f.rests = false;
        report_show(&f, "planning up to where the machine stopped");
        return;
    }
    size_t used = (size_t)snprintf(text, sizeof text, "%s %3u %%  queue %3u ", state,
                                   s->status.override, (unsigned)(s->ack.next - s->ack.executed));
    for (int i = 0; i < LOFT_AXES; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, " %c %.2f", "XYZABC"[i], f.at[i]);
    report_show(&f, text);
}

/* Tell the current state in one line; it stays on the screen. */
static void tell_state(run_state *r)
{
    const loft_sender *s = &r->t->sender;
    char state[32], of[32], place[96];
    double at[LOFT_AXES];
    size_t used = 0;

    state_text(r, state);
    stream_place(s, r->about->k, s->status.position, at);
    for (int i = 0; i < LOFT_AXES; i++)
        used += (size_t)snprintf(place + used, sizeof place - used, " %c %.2f", "XYZABC"[i], at[i]);
    report_line("item %u%s, %u queued, override %u %%, %s%s", (unsigned)s->ack.executed,
                job_of(r->j, of), (unsigned)(s->ack.next - s->ack.executed), s->status.override,
                state, place);
}

/* A key counts from the override that was last asked for, which the machine may not have confirmed
 * yet. */
static void change_override(run_state *r, int by)
{
    loft_sender *s = &r->t->sender;
    const int now  = r->percent ? r->percent : s->status.override, next = by == 0 ? 100 : now + by;

    if (now == 0)
        return;
    r->percent = next < 10 ? 10 : next > 200 ? 200 : next;
    loft_sender_override(s, (unsigned)r->percent);
}

/* A key of the terminal; in a pause of the program also what a pipe says, until it ends. */
static int next_key(run_state *r)
{
    if (isatty(STDIN_FILENO) || r->pause == NULL || r->answered || r->deaf)
        return keys_next();
    const int key = keys_answer(0);
    r->deaf       = key == KEYS_END;
    r->answered   = key == '\n' || key == '\r' || key == 'a';
    return r->answered ? key : 0;
}

static void obey_keys(run_state *r)
{
    switch (next_key(r)) {
    case '+':
    case '=': change_override(r, 10); break;
    case '-':
    case '_': change_override(r, -10); break;
    case '0': change_override(r, 0); break;
    case 's': tell_state(r); break;
    case 'h': loft_sender_control(&r->t->sender, LOFT_HOLD);   break;
    case 'r': loft_sender_control(&r->t->sender, LOFT_RESUME); break;
    case '\r':
    case '\n':
        if (r->pause != NULL)
            loft_sender_control(&r->t->sender, LOFT_RESUME);
        break;
    case 'a': loft_sender_control(&r->t->sender, LOFT_ABORT);  break;
    default:  break;
    }
}

/* Report and prepare, once, when a running job is found. */
static void wake_job(run_state *r)
{
    const loft_sender *s = &r->t->sender;
    char of[32];

    if (s->phase < LOFT_PHASE_STREAMING || !s->resumed || r->woken)
        return;
    r->woken    = true;
    job_sent_from(r->j, s->ack.next);
    report_line("resuming at item %u%s", (unsigned)s->ack.next, job_of(r->j, of));
    r->resting = s->ack.state == LOFT_STATE_HELD || s->ack.state == LOFT_STATE_HOLDING;
}

/* A job that stands still may be in a pause of the program: the plan knows, when it has come so
 * far. Then the user decides. A hold of an earlier program ends. */
static void watch_pauses(run_state *r)
{
    const loft_sender *s = &r->t->sender;
    const char *before   = r->pause;

    if (s->phase != LOFT_PHASE_STREAMING || (!r->j->whole && r->j->count < s->ack.executed))
        return;
    r->pause = s->ack.state == LOFT_STATE_HELD ? job_pause(r->j, s->ack.executed) : NULL;
    r->answered = r->answered && r->pause == before;
    if (r->pause != NULL && r->pause != before)
        report_line("pause%s%s: Enter goes on, a gives up", *r->pause ? ": " : "", r->pause);
    if (r->resting && r->pause == NULL && r->stop_at <= 0)
        loft_sender_control(&r->t->sender, LOFT_RESUME);
    r->resting = false;
}

/* After ^C: hold, and wait until the machine has stopped and reported its position. Returns true
 * when that is done or takes too long. */
static bool has_stopped(run_state *r)
{
    const double now = tool_clock();

    if (!keys_interrupted())
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
static const char *where_text(const run_state *r, char text[64])
{
    char of[32];

    snprintf(text, 64, "at item %u%s ", (unsigned)r->t->sender.ack.executed, job_of(r->j, of));
    return text;
}

/* Plan a portion, if one is wanted. Returns true if another one is. Greetings and the end after ^C
 * come first: on a busy computer a portion may take long. */
static bool plan_portion(run_state *r)
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

/* Loop until the sender has ended, or until there is an exit code. */
static int stream_loop(run_state *r)
{
    loft_sender *s = &r->t->sender;
    char place[64], text[200];

    while (s->phase < LOFT_PHASE_DONE) {
        if (!talk_pump(r->t, plan_portion(r) ? 0 : 20)) {
            loft_sender_hangup(s);
            if (s->phase >= LOFT_PHASE_DONE)
                break;
            report_end();
            return talk_vanished(r->t, where_text(r, place));
        }
        if (talk_silence(r->t) > SILENCE) {
            report_end();
            return tool_error(EX_IOERR,
                              "%s: the machine has been silent for %g s %s: it stops on the path; "
                              "look at the cable, then run the same command again; if it lost its "
                              "power, the position may be lost: home it, or `loft zero`",
                              r->t->port, SILENCE, where_text(r, place));
        }
        wake_job(r);
        watch_pauses(r);
        obey_keys(r);
        if (has_stopped(r))
            break;
        if (s->phase == LOFT_PHASE_STREAMING)
            show_progress(r);
        if (waits_due(&r->waiting, awaited_event(r, text)))
            report_line("waiting: %s", r->waiting.what);
    }
    report_end();
    return 0;
}

int stream_run(talk *t, job *j, const stream_subject *about)
{
    run_state r          = { .t = t, .j = j, .about = about };
    const report_job told = { about->file, about->port, about->tool,
                              about->path, about->tol,  j->head.id };

    talk_begins(t, j->head.id, about->file);
    if (loft_sender_begin(&t->sender, &j->head, job_items(j), job_source, j) != LOFT_OK)
        return tool_error(EX_SOFTWARE, "the job could not begin: please report this");
    loft_sender_extend(&t->sender, (uint32_t)job_ready(j), job_items(j));
    report_begin(&told);
    const int code = stream_loop(&r);
    talk_over(t);
    if (code != 0)
        return code;
    if (r.planned != LOFT_OK) {
        char then[96];
        snprintf(then, sizeof then, "; the job was ended on the path before item %zu",
                 job_ready(j));
        return job_refuse(j, about->file, r.planned, then);
    }
    if (t->sender.phase < LOFT_PHASE_DONE)
        return stream_interrupted(t, j);
    return stream_ended(t, j, about);
}

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
    const loft_sender *s = &t->sender;

    if (!hard)
        return 0;
    if (!(s->machine.kinds & LOFT_TAKES_GUARDS))
        return tool_error(EX_CONFIG,
                          "%s: limit_stop = hard: this machine slows down on the path: give "
                          "limit_stop = ramp, or a newer firmware",
                          t->port);
    head->guard = (loft_guard){ LOFT_INPUT_ENDING & ~s->closed & ~head->away, LOFT_GUARD_HARD,
                                LIMIT_FILTER };
    return 0;
}

int stream_control(talk *t, enum loft_verb verb, const kinematics *k)
{
    loft_sender *s     = &t->sender;
    const double began = tool_clock();
    double done        = 0;
    waits waiting      = { .told = false };

    if (!loft_state_busy(s->ack.state))
        return tool_error(EX_UNAVAILABLE, "%s: no job is running: nothing to %s", t->port,
                          verb == LOFT_HOLD     ? "hold"
                          : verb == LOFT_RESUME ? "resume"
                                                : "abort");
    loft_sender_control(s, verb);
    while (s->phase < LOFT_PHASE_DONE &&
           (done <= 0 || tool_clock() - done < 3 * LOFT_SENDER_POLL / 1000.0)) {
        if (!talk_pump(t, 20))
            return talk_vanished(t, "");
        if (tool_clock() - began > STOP)
            return tool_error(
                EX_IOERR,
                "%s: the machine did not obey in %g s: look at the cable, or cut its power",
                t->port, STOP);
        waits_for(&waiting, done > 0              ? NULL
                            : verb == LOFT_RESUME ? "the machine does not go on yet"
                                                  : "the machine is not stopped yet");
        if (done <= 0 && verb_obeyed(s, verb))
            done = tool_clock();
    }
    talk_over(t);
    return stream_obeyed(t, verb, k);
}

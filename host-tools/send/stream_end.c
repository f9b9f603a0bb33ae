/* host-tools/send/stream_end.c -- reports in one line how a job ended
 * SPDX-License-Identifier: MIT
 */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "read/record.h"         /* record_worst_error */
#include "send/stream_end.h"
#include "base/tool.h"
#include "host/duration.h"      /* host_duration */

/* Positions for steps: "12.345 8.000 1.000". */
static const char *place_text(const loft_sender *s, const kinematics *k,
                              const int32_t steps[LOFT_AXES], char text[96])
{
    double at[LOFT_AXES];
    size_t used = 0;

    stream_place(s, k, steps, at);
    for (int i = 0; i < LOFT_AXES; i++)
        used += (size_t)snprintf(text + used, 96 - used, "%s%.3f", i ? " " : "", at[i]);
    return text;
}

static const char *steps_text(const int32_t steps[LOFT_AXES], char text[96])
{
    size_t used = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        used += (size_t)snprintf(text + used, 96 - used, "%s%" PRId32, i ? " " : "", steps[i]);
    return text;
}

static double machine_seconds(const loft_sender *s)
{
    return (double)s->report.elapsed / (double)s->machine.tick_hz;
}

/* Bytes, their share of the line's capacity, and repairs. */
static void tell_line(const talk *t, const job *j, const send_teller *to)
{
    const loft_sender *s  = &t->sender;
    const unsigned baud   = t->line.baud ? t->line.baud : 115200;
    const double part     = 1 - (double)j->first_due / (double)j->ticks;
    const double seconds  = machine_seconds(s) * part;
    const double rested   = (double)(s->report.elapsed - s->report.ticks) / s->machine.tick_hz;
    char share[64] = "", slowed[80] = "", held[HOST_DURATION + 32] = "", time[HOST_DURATION];

    if (seconds > 0 && !s->collected)
        snprintf(share, sizeof share, "%.1f %% of %u baud, ",
                 1000 * (double)t->written / (seconds * baud), baud);
    if (s->report.slowed > 0)
        snprintf(slowed, sizeof slowed, "%u ticks slowed because their steps did not fit, ",
                 (unsigned)s->report.slowed);
    if (s->report.elapsed > s->report.ticks + s->machine.tick_hz / 10)
        snprintf(held, sizeof held, "%s held or waiting, ", host_duration(time, rested, 1));
    send_tell(to, SEND_RESULT,
              "line: %" PRIu64 " bytes out for %zu %s, %" PRIu64 " in, %s%s%s%u of %u frames "
              "resent",
              t->written, j->count - j->first, job_words(j), t->received, share, slowed, held,
              (unsigned)s->resent, (unsigned)(s->sent + s->resent));
}

/* The record of a machine in another process. It is complete when it ends at the position of the
 * report. */
static bool is_complete(const loft_sender *s, const record *r)
{
    bool complete = r->count > 0;

    for (int i = 0; i < LOFT_AXES && complete; i++)
        complete = lround(r->motors[i] * r->steps_per_mm[i]) == s->report.position[i];
    return complete;
}

int stream_error(const talk *t, const stream_subject *about, bool late, char text[64])
{
    const loft_sender *s = &t->sender;
    record r = { 0 };
    int code = 0;

    text[0] = '\0';
    if (about->record == NULL)
        return 0;
    code = record_read(t->host, &r, about->record, s->report.job);
    if (code == 0 && is_complete(s, &r))
        snprintf(text, 64, ", worst path error %.4f mm",
                 record_worst_error(about->d, &r, NULL, NULL));
    else if (code == 0 && !late)
        code = TASK_GOES;
    else if (code == 0)
        code = host_error(t->host, EX_DATAERR, "record.other-machine",
                          (host_place){ .file = about->record }, "name the record of this machine",
                          "does not end where the machine says it is");
    record_free(&r);
    return code;
}

int stream_checked(talk *t, const job *j, const send_teller *to)
{
    const loft_sender *s = &t->sender;
    int32_t want[LOFT_AXES];
    char text[96], other[96];

    stream_commanded(s, j, want);
    if (memcmp(want, s->report.position, sizeof want) != 0)
        return host_error(t->host, EX_SOFTWARE, "job.elsewhere", (host_place){ .file = NULL },
                          "home it, and please report this",
                          "the machine is at steps %s, commanded were %s",
                          steps_text(s->report.position, text), steps_text(want, other));
    if (s->collected)
        send_tell(to, SEND_NOTE, "this job was drawn already: its report is");
    return 0;
}

void stream_drawn(const talk *t, const job *j, const stream_subject *about, const send_teller *to,
                  const char *error)
{
    const loft_sender *s = &t->sender;
    char text[96], plan[160], time[HOST_DURATION];

    send_tell(to, SEND_RESULT,
              "drawn: %zu curve%s, %.3f m, %s machine time, %s%s, steps %s as commanded",
              about->curves, tool_s(about->curves), about->drawn / 1000,
              host_duration(time, machine_seconds(s), 1), job_words_of_plan(j, about->tol, plan),
              error, steps_text(s->report.position, text));
    tell_line(t, j, to);
}

/* An input ended the job, or prevented its begin. */
static int report_hindered(const talk *t, const job *j)
{
    const loft_sender *s = &t->sender;
    const bool began     = s->report.job != 0;
    const uint16_t by    = (began ? s->report.ended_by : s->closed) & LOFT_INPUT_ENDING;
    const bool stop      = by & LOFT_INPUT_STOP;
    const bool hard      = stop || (s->report.guarded && j->head.guard.how & LOFT_GUARD_HARD);
    char text[256], at[96], steps[96], of[32];

    if (!began)
        return host_error(
            t->host, EX_UNAVAILABLE, "job.input-closed", (host_place){ .file = t->port },
            "move away by hand, with `loft unlock`, or with a drawing that leads away and --away",
            "%s is closed", by ? talk_inputs(by, text) : "an input");
    return host_error(
        t->host, EX_TEMPFAIL, "job.ended-by-input", (host_place){ .file = t->port }, NULL,
        "%s closed and ended the job after %u%s items: the machine is stopped %s at %s mm, steps "
        "%s; move away by hand, with `loft unlock`, or with a drawing that leads away and --away%s",
        talk_inputs(by, text), (unsigned)s->report.items, job_of(j, of),
        hard ? "at once" : "on the path", place_text(s, j->k, s->report.position, at),
        steps_text(s->report.position, steps),
        stop   ? "; its position is in doubt: then `loft home`, or `loft zero`"
        : hard ? "; its motors may have lost steps: then home it"
               : "");
}

static int report_refused(const talk *t, const job *j)
{
    switch (t->sender.refusal) {
    case LOFT_REFUSAL_START:
        return host_error(t->host, EX_TEMPFAIL, "job.moved-since", (host_place){ .file = t->port },
                          "run the same command again",
                          "the machine has moved since it was asked for its position");
    case LOFT_REFUSAL_KIND:
        if (j->head.guard.how & LOFT_GUARD_SQUARE)
            return host_error(
                t->host, EX_CONFIG, "job.no-squaring", (host_place){ .file = t->port },
                "square it by hand, and give square = no",
                "this board has one motor or one switch pin for an axis with square = yes");
        return host_error(t->host, EX_CONFIG, "job.kind", (host_place){ .file = t->port },
                          "try with or without --points",
                          "the machine does not accept items of this kind");
    case LOFT_REFUSAL_LIMITS:
        return host_error(t->host, EX_DATAERR, "job.limits", (host_place){ .file = t->port },
                          "see --tol, --corner, --accel and --jerk, or plan here, with --plan host",
                          "the machine cannot plan within these limits");
    case LOFT_REFUSAL_ITEM:
        return host_error(t->host, EX_DATAERR, "job.item", (host_place){ .file = t->port },
                          "give less --feed or --accel", "the machine cannot do item %u",
                          (unsigned)t->sender.ack.next);
    case LOFT_REFUSAL_INPUT: return report_hindered(t, j);
    case LOFT_REFUSAL_TABLE:
        return host_error(
            t->host, EX_DATAERR, "job.table", (host_place){ .file = t->port },
            "it is stopped on the path before; move the drawing, or `loft home` again",
            "item %u leaves the table, where the machine was homed", (unsigned)t->sender.ack.next);
    case LOFT_REFUSAL_PATCH:
        return host_error(t->host, EX_DATAERR, "job.patch", (host_place){ .file = t->port },
                          "give a smaller ball, more columns, or --plan host",
                          "the machine cannot cut this patch so");
    case LOFT_REFUSAL_FAULT:
        return host_error(t->host, EX_UNAVAILABLE, "job.place-unknown",
                          (host_place){ .file = t->port }, "restart and home it",
                          "the machine does not know its position");
    default:
        return host_error(
            t->host, EX_TEMPFAIL, "job.busy", (host_place){ .file = t->port },
            HOST_REMEDY("wait, or end its job with `loft stream --abort --port %s`", t->port),
            "the machine is busy");
    }
}

int stream_ended(talk *t, const job *j)
{
    const loft_sender *s = &t->sender;
    char text[96], other[96], of[32];

    switch (s->phase) {
    case LOFT_PHASE_ABORTED:
        if (s->refusal != LOFT_REFUSAL_NONE)
            return report_refused(t, j);
        return host_error(t->host, EX_TEMPFAIL, "job.aborted", (host_place){ .file = NULL }, NULL,
                          "aborted after %u%s items: the machine is stopped on the path at %s mm, "
                          "steps %s; the next job starts there",
                          (unsigned)s->report.items, job_of(j, of),
                          place_text(s, j->k, s->report.position, text),
                          steps_text(s->report.position, other));
    case LOFT_PHASE_BUSY:
        return host_error(
            t->host, EX_TEMPFAIL, "job.other", (host_place){ .file = t->port },
            HOST_REMEDY("wait, or end it with `loft stream --abort --port %s`", t->port),
            "another job (%08x) is running", (unsigned)s->machine.job);
    case LOFT_PHASE_LOST:
        return host_error(t->host, EX_PROTOCOL, "job.restarted", (host_place){ .file = t->port },
                          HOST_REMEDY("home it, or `loft zero --port %s` at 0,0,0, then start "
                                      "again: its position may be lost",
                                      t->port),
                          "the machine was restarted in the middle of the job");
    case LOFT_PHASE_UNFIT:
        return host_error(t->host, EX_CONFIG, "job.unfit", (host_place){ .file = t->port },
                          "start again",
                          "the machine came back with another version or other axes");
    default: return report_refused(t, j);
    }
}

int stream_interrupted(const talk *t, const job *j)
{
    const loft_sender *s = &t->sender;
    char text[96], other[96], of[32];

    if (s->phase < LOFT_PHASE_STREAMING && s->sent == 0 && !s->resumed)
        return host_error(t->host, EX_TEMPFAIL, "job.stopped-before", (host_place){ .file = NULL },
                          NULL, "stopped before the job began: the machine has not moved");
    if (s->ack.state != LOFT_STATE_HELD)
        return host_error(t->host, EX_IOERR, "job.not-stopped", (host_place){ .file = NULL }, NULL,
                          "stopped, but the machine did not say that it is stopped: it runs out of "
                          "items and then stops on the path");
    return host_error(t->host, EX_TEMPFAIL, "job.held", (host_place){ .file = NULL }, NULL,
                      "held at item %u%s: the machine is stopped on the path at %s mm, steps %s; "
                      "the same command continues, `loft stream --abort --port %s` gives up",
                      (unsigned)s->ack.executed, job_of(j, of),
                      place_text(s, j->k, s->status.position, text),
                      steps_text(s->status.position, other), t->port);
}

void stream_obeyed(const talk *t, enum loft_verb verb, const kinematics *k, const send_teller *to)
{
    const loft_sender *s   = &t->sender;
    const bool told        = s->phase == LOFT_PHASE_ABORTED && s->report.job != 0;
    const int32_t *at      = told ? s->report.position : s->status.position;
    char text[96], other[96];

    send_tell(to, SEND_RESULT, "%s: %u items executed, at %s mm, steps %s",
              verb == LOFT_HOLD     ? "held"
              : verb == LOFT_RESUME ? "resumed"
                                    : "aborted",
              (unsigned)(told ? s->report.items : s->ack.executed), place_text(s, k, at, text),
              steps_text(at, other));
}

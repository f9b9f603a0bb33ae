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

int stream_error(const loft_sender *s, const stream_subject *about, bool late, char text[64])
{
    record r = { 0 };
    int code = 0;

    text[0] = '\0';
    if (about->record == NULL)
        return 0;
    code = record_read(tool_host(), &r, about->record, s->report.job);
    if (code == 0 && is_complete(s, &r))
        snprintf(text, 64, ", worst path error %.4f mm",
                 record_worst_error(about->d, &r, NULL, NULL));
    else if (code == 0 && !late)
        code = TASK_GOES;
    else if (code == 0)
        code = tool_error(
            EX_DATAERR,
            "%s: does not end where the machine says it is: name the record of this machine",
            about->record);
    record_free(&r);
    return code;
}

int stream_checked(talk *t, job *j, const stream_subject *about, const send_teller *to)
{
    const loft_sender *s = &t->sender;
    int32_t want[LOFT_AXES];
    char text[96], other[96];
    int status = LOFT_OK;

    if (j->head.kind != LOFT_CURVES || j->first > 0)    /* a job that was drawn before need not be
                                                         * planned completely */
        status = job_finish(tool_host(), j);
    if (status != LOFT_OK)
        return job_refuse(tool_host(), j, about->file, status, "");
    stream_commanded(s, j, want);
    if (memcmp(want, s->report.position, sizeof want) != 0)
        return tool_error(
            EX_SOFTWARE,
            "the machine is at steps %s, commanded were %s: home it, and please report this",
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
        return tool_error(
            EX_UNAVAILABLE,
            "%s: %s is closed: move away by hand, with `loft unlock`, or with a drawing that leads "
            "away and --away",
            t->port, by ? talk_inputs(by, text) : "an input");
    return tool_error(
        EX_TEMPFAIL,
        "%s: %s closed and ended the job after %u%s items: the machine is stopped %s at %s mm, "
        "steps %s; move away by hand, with `loft unlock`, or with a drawing that leads away and "
        "--away%s",
        t->port, talk_inputs(by, text), (unsigned)s->report.items, job_of(j, of),
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
        return tool_error(EX_TEMPFAIL,
                          "%s: the machine has moved since it was asked for its position: run the "
                          "same command again",
                          t->port);
    case LOFT_REFUSAL_KIND:
        if (j->head.guard.how & LOFT_GUARD_SQUARE)
            return tool_error(EX_CONFIG,
                              "%s: this board has one motor or one switch pin for an axis with "
                              "square = yes: square it by hand, and give square = no",
                              t->port);
        return tool_error(
            EX_CONFIG,
            "%s: the machine does not accept items of this kind: try with or without --points",
            t->port);
    case LOFT_REFUSAL_LIMITS:
        return tool_error(EX_DATAERR,
                          "%s: the machine cannot plan within these limits: see --tol, --corner, "
                          "--accel and --jerk, or plan here, "
                          "with --plan host",
                          t->port);
    case LOFT_REFUSAL_ITEM:
        return tool_error(EX_DATAERR,
                          "%s: the machine cannot do item %u: give less --feed or --accel", t->port,
                          (unsigned)t->sender.ack.next);
    case LOFT_REFUSAL_INPUT: return report_hindered(t, j);
    case LOFT_REFUSAL_TABLE:
        return tool_error(
            EX_DATAERR,
            "%s: item %u leaves the table, where the machine was homed: it is stopped "
            "on the path before; move the drawing, or `loft home` again",
            t->port, (unsigned)t->sender.ack.next);
    case LOFT_REFUSAL_PATCH:
        return tool_error(EX_DATAERR,
                          "%s: the machine cannot cut this patch so: give a smaller ball, more "
                          "columns, or --plan host",
                          t->port);
    case LOFT_REFUSAL_FAULT:
        return tool_error(EX_UNAVAILABLE,
                          "%s: the machine does not know its position: restart and home it",
                          t->port);
    default:
        return tool_error(
            EX_TEMPFAIL,
            "%s: the machine is busy: wait, or end its job with `loft stream --abort --port %s`",
            t->port, t->port);
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
        return tool_error(EX_TEMPFAIL,
                          "aborted after %u%s items: the machine is stopped on the path at %s mm, "
                          "steps %s; the next job starts there",
                          (unsigned)s->report.items, job_of(j, of),
                          place_text(s, j->k, s->report.position, text),
                          steps_text(s->report.position, other));
    case LOFT_PHASE_BUSY:
        return tool_error(EX_TEMPFAIL,
                          "%s: another job (%08x) is running: wait, or end it with `loft stream "
                          "--abort --port %s`",
                          t->port, (unsigned)s->machine.job, t->port);
    case LOFT_PHASE_LOST:
        return tool_error(
            EX_PROTOCOL,
            "%s: the machine was restarted in the middle of the job: home it, or `loft zero --port "
            "%s` at 0,0,0, then start again: its position may be lost",
            t->port, t->port);
    case LOFT_PHASE_UNFIT:
        return tool_error(
            EX_CONFIG, "%s: the machine came back with another version or other axes: start again",
            t->port);
    default: return report_refused(t, j);
    }
}

int stream_interrupted(const talk *t, const job *j)
{
    const loft_sender *s = &t->sender;
    char text[96], other[96], of[32];

    if (s->phase < LOFT_PHASE_STREAMING && s->sent == 0 && !s->resumed)
        return tool_error(EX_TEMPFAIL, "stopped before the job began: the machine has not moved");
    if (s->ack.state != LOFT_STATE_HELD)
        return tool_error(EX_IOERR, "stopped, but the machine did not say that it is stopped: it "
                                    "runs out of items and then stops on the path");
    return tool_error(EX_TEMPFAIL,
                      "held at item %u%s: the machine is stopped on the path at %s mm, steps %s; "
                      "the same command continues, "
                      "`loft stream --abort --port %s` gives up",
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

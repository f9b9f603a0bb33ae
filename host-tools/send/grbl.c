/* host-tools/send/grbl.c -- the conversation with a controller of grbl's kind
 * SPDX-License-Identifier: MIT
 *
 * Lines are sent ahead while their bytes fit the controller's buffer (grbl's wiki, "Streaming a
 * G-code program", character counting). Each `ok` or `error:` frees the bytes of the oldest line.
 */
#include <math.h>
#include <stdio.h>

#include "base/say.h"
#include "send/grbl_talk.h"
#include "send/near_move.h"      /* near_move */
#include "send/grbl_words.h"     /* grbl_error_text, grbl_alarm_text */
#include "cmd/keys.h"           /* keys_next, keys_interrupted */
#include "cmd/report.h"         /* report_show */
#include "base/tool.h"           /* tool_error, tool_clock */
#include "base/waits.h"          /* waits_due */
#include "host/duration.h"      /* host_duration */

#define STUCK       5.0     /* s at rest with unanswered lines */
#define UNREAD      5.0     /* s without a status that has a meaning */
#define STOPS       5.0     /* s to slow down to a stop, at most, */
#define STOPS_STILL 1.0     /* and without another place */
#define STILL       3.0     /* s that it says it runs, without another place or an answer */
#define IDLES       2       /* "Idle" so often after the last answer: it draws nothing any more */
#define ABREAST     0.05    /* mm: moves that are so much farther may be the ones that it draws */

/* Send as many lines as fit. */
static bool send_lines(grbl *g)
{
    char text[160];

    while (g->sent < g->code->count && g->sent - g->done < GRBL_WAITING) {
        const unsigned size = (unsigned)snprintf(text, sizeof text, "%s\n",
                                                 gcode_text(g->code, g->sent));
        if (g->under_way > 0 && g->under_way + size > g->buffer - 1)
            break;
        if (!grbl_put(g, text, size))
            return false;
        g->size_of[g->sent++ % GRBL_WAITING] = size;
        g->under_way += size;
    }
    return true;
}

static enum grbl_doing doing_of(const grbl *g)
{
    return g->state != NULL ? g->state->doing : GRBL_RUNS;
}

/* Slow down, stop, and discard the lines that were sent. The position is kept, since a reset at
 * rest loses no step; *rests: it said that it rests. */
static bool stop_controller(grbl *g, bool *rests)
{
    const double began = tool_clock();

    *rests = false;
    if (!grbl_put_byte(g, '!'))
        return false;
    g->state = NULL;
    g->moved = began;
    while (!*rests && tool_clock() - began < STOPS && tool_clock() - g->moved < STOPS_STILL) {
        if (!grbl_pump(g, 20))
            return false;
        *rests = g->state != NULL && g->state->doing != GRBL_RUNS && g->state->doing != GRBL_SLOWS;
    }
    g->code = NULL;                     /* the greeting that follows is expected */
    return grbl_put_byte(g, 0x18);
}

static bool is_held(const grbl *g)
{
    return doing_of(g) == GRBL_SLOWS || doing_of(g) == GRBL_STANDS;
}

/* The state in one word, for a program. */
static const char *state_word(const grbl *g)
{
    switch (doing_of(g)) {
    case GRBL_RUNS:   return g->state != NULL ? "draws" : "waits";
    case GRBL_SLOWS:  return "holds";
    case GRBL_STANDS: return "held";
    default:          return "waits";
    }
}

/* What keeps the job from going on, or NULL. */
static const char *awaited_event(const grbl *g, char text[200])
{
    if (tool_clock() - g->heard > STILL)
        return "the controller does not answer: look at cable and power";
    if (g->state == NULL)
        return NULL;
    if (*g->state->text != '\0')
        snprintf(text, 200, "the controller says %s: %s", g->word, g->state->text);
    else if (is_held(g) && !report_shown())
        snprintf(text, 200, "the controller is held: its button goes on");
    else if (doing_of(g) == GRBL_RUNS && tool_clock() - g->moved > STILL)
        snprintf(text, 200,
                 "the controller says %s, and does not move: a pause of the program, or "
                 "it waits for something",
                 g->word);
    else
        return NULL;
    return text;
}

/* Tell the current state in one line; it stays on the screen. */
static void tell_state(const grbl *g)
{
    report_line("line %zu of %zu, %zu sent ahead, override %u %%, %s  X %.2f Y %.2f Z %.2f",
                g->done, g->code->count, g->sent - g->done, g->rate, state_word(g), g->place[0],
                g->place[1], g->place[2]);
}

static bool obey_keys(grbl *g, bool *abort)
{
    switch (keys_next()) {
    case 'h': return grbl_put_byte(g, '!');
    case 'r': return grbl_put_byte(g, '~');
    case '+':
    case '=': return grbl_put_byte(g, 0x91);
    case '-':
    case '_': return grbl_put_byte(g, 0x92);
    case '0': return grbl_put_byte(g, 0x90);
    case 's': tell_state(g); return true;
    case 'a': *abort = true; return true;
    default:  return true;
    }
}

/* Stop: the count of answers, or what they say, cannot be right. Returns the exit code. */
static int stop_after(grbl *g, const char *what)
{
    const size_t done = g->done, count = g->code->count;
    bool rests;

    (void)stop_controller(g, &rests);
    return tool_error(EX_PROTOCOL,
                      "%s: %s, at line %zu of %zu: what was drawn cannot be trusted; look at cable "
                      "and --baud, home it and begin again",
                      g->port, what, done, count);
}

/* An answer says that a line of ours is wrong. */
static int report_failed(grbl *g)
{
    const gcode *code = g->code;
    const bool ours   = g->wrong < g->sent;
    bool rests;

    (void)stop_controller(g, &rests);
    return tool_error(EX_PROTOCOL, "%s: error %s at line %zu of %zu%s%s%s%s; the machine %s",
                      g->port, g->error, g->wrong + ours, code->count, ours ? ", `" : "",
                      ours ? gcode_text(code, g->wrong) : "", ours ? "`" : "",
                      grbl_error_text(g->error),
                      rests ? "is stopped" : "did not say that it stopped");
}

/* Report what is wrong. Returns an exit code after printing one line; 0: nothing is wrong. */
static int report_trouble(grbl *g)
{
    const gcode *code = g->code;
    const double now = tool_clock();

    if (g->restarted && g->done == 0)
        return tool_error(EX_TEMPFAIL,
                          "%s: the controller was reset before the first line: nothing was drawn; "
                          "run the same command again",
                          g->port);
    if (g->restarted)
        return tool_error(EX_PROTOCOL,
                          "%s: the controller restarted at line %zu of %zu: its position is lost; "
                          "home it and begin again",
                          g->port, g->done, code->count);
    if (g->alarmed)
        return tool_error(EX_PROTOCOL, "%s: alarm %s at line %zu of %zu%s", g->port, g->alarm,
                          g->done, code->count, grbl_alarm_text(g->alarm));
    if (g->failed)
        return report_failed(g);
    if (doing_of(g) == GRBL_ENDS)
        return tool_error(EX_PROTOCOL,
                          "%s: the controller says %s at line %zu of %zu: %s; then "
                          "begin again",
                          g->port, g->word, g->done, code->count, g->state->text);
    if (g->surplus)
        return stop_after(g, "one answer more than lines were sent: bytes were bent on the line");
    if (g->unread[0] != '\0' && now - g->read > UNREAD) {
        char text[GRBL_SAID + 64];
        snprintf(text, sizeof text, "its report `%s` has no meaning", g->unread);
        return stop_after(g, text);
    }
    if (now - g->heard > GRBL_DEAF)
        return tool_error(EX_IOERR,
                          "%s: silent for %g s at line %zu of %zu: look at cable and power; it "
                          "draws what it has and stops",
                          g->port, GRBL_DEAF, g->done, code->count);
    if (now - g->read > GRBL_DEAF)
        return stop_after(g, "it answers lines, but does not tell its state");
    if (g->idles > 0 && g->done < g->sent && now - g->moved > STUCK) {
        char text[96];
        snprintf(text, sizeof text, "%zu lines were not answered: bytes were lost on the line",
                 g->sent - g->done);
        return stop_after(g, text);
    }
    return 0;
}

/* Find the move that it draws. Lines are answered before they are drawn, so it is one of those up
 * to the last that was answered: the first that is as near to the tool as any. */
static void follow_path(grbl *g, const toolpath *path)
{
    const size_t last = g->done > 0 ? g->code->line[g->done - 1].move : 0;
    double best       = HUGE_VAL, t;

    for (size_t n = g->behind; n <= last && n < path->count; n++)
        best = fmin(best, near_move(&path->move[n], g->place, &t));
    while (g->behind < last && near_move(&path->move[g->behind], g->place, &t) > best + ABREAST)
        g->behind++;
}

static void show_progress(grbl *g, const report_job *job)
{
    char text[128];
    report_facts f = { .state    = state_word(g),
                       .done     = (double)g->done,
                       .total    = (double)g->code->count,
                       .item     = (uint32_t)g->done,
                       .items    = (uint32_t)g->code->count,
                       .queued   = (uint32_t)(g->sent - g->done),
                       .feed     = g->feed / 60,
                       .override = g->rate,
                       .at       = { g->place[0], g->place[1], g->place[2] },
                       .rests    = is_held(g) };

    follow_path(g, job->path);
    f.moves = g->behind;
    if (is_held(g))
        snprintf(text, sizeof text, "held, r resumes  X %.2f Y %.2f Z %.2f", g->place[0],
                 g->place[1], g->place[2]);
    else
        snprintf(text, sizeof text, "feed %5.1f mm/s %3u %% X %.2f Y %.2f Z %.2f", f.feed, g->rate,
                 g->place[0], g->place[1], g->place[2]);
    report_show(&f, text);
}

static int report_aborted(grbl *g)
{
    const size_t done = g->done, count = g->code->count;
    bool rests;

    if (!stop_controller(g, &rests))
        return grbl_report_vanished(g);
    if (!rests)
        return tool_error(EX_TEMPFAIL,
                          "aborted at line %zu of %zu: the controller did not say that it stopped, "
                          "and was reset: home it",
                          done, count);
    return tool_error(EX_TEMPFAIL,
                      "aborted at line %zu of %zu: the machine is stopped at %.3f %.3f %.3f", done,
                      count, g->place[0], g->place[1], g->place[2]);
}

static int drive_job(grbl *g, const report_job *job)
{
    bool abort = false;
    waits waiting = { .told = false };
    char text[200];

    while (g->done < g->code->count || g->idles < IDLES) {
        if (!send_lines(g) || !grbl_pump(g, 20) || !obey_keys(g, &abort))
            return grbl_report_vanished(g);
        const int code = report_trouble(g);
        if (code != 0)
            return code;
        if (abort || keys_interrupted())
            return report_aborted(g);
        if (g->done == g->code->count && doing_of(g) == GRBL_IDLE)
            g->asked = 0;               /* the last line was answered before it was drawn: ask
                                         * again */
        show_progress(g, job);
        if (waits_due(&waiting, awaited_event(g, text)))
            report_line("waiting: %s", waiting.what);
    }
    return 0;
}

int grbl_run(grbl *g, const gcode *code, const report_job *job)
{
    const double began = tool_clock();
    char time[HOST_DURATION];

    g->code   = code;
    g->state  = NULL;
    g->idles  = 0;
    g->behind = 0;
    g->sent = g->done = 0;
    g->heard = g->moved = g->read = began;
    report_begin(job);
    const int result = drive_job(g, job);
    report_end();
    g->code = NULL;
    if (result == 0)
        (void)say(stdout,
                  "drawn: %zu curve%s, %.3f m, %zu lines of G-code in %s, %s at %.3f %.3f %.3f\n",
                  job->path->curves, tool_s(job->path->curves), job->path->drawn / 1000,
                  code->count, host_duration(time, tool_clock() - began, 1),
                  g->name[0] != '\0' ? g->name : "the controller is stopped", g->place[0],
                  g->place[1], g->place[2]);
    return result;
}

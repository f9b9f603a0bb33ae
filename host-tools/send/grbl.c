/* host-tools/send/grbl.c -- the conversation with a controller of grbl's kind
 * SPDX-License-Identifier: MIT
 *
 * Lines are sent ahead while their bytes fit the controller's buffer (grbl's wiki, "Streaming a
 * G-code program", character counting). Each `ok` or `error:` frees the bytes of the oldest line.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "send/grbl_talk.h"
#include "send/near_move.h"      /* near_move */
#include "send/grbl_words.h"     /* grbl_error_text, grbl_alarm_text */
#include "base/tool.h"           /* tool_s */
#include "host/duration.h"      /* host_duration */

#define QUESTIONS   256     /* bytes that are left for questions and keys */
#define STUCK       5.0     /* s at rest with unanswered lines */
#define UNREAD      5.0     /* s without a status that has a meaning */
#define STOPS       5.0     /* s to slow down to a stop, at most, */
#define STOPS_STILL 1.0     /* and without another place */
#define STILL       3.0     /* s that it says it runs, without another place or an answer */
#define IDLES       2       /* "Idle" so often after the last answer: it draws nothing any more */
#define AGAIN       0.02    /* s between two questions after the last answer, */
#define LOOK        0.02    /* and between two looks at the controller */
#define ABREAST     0.05    /* mm: moves that are so much farther may be the ones that it draws */

/* Send as many lines as fit. Returns whether there is no room for the next one here. */
static bool send_lines(grbl *g)
{
    char text[160];

    while (g->sent < g->code->count && g->sent - g->done < GRBL_WAITING) {
        const unsigned size = (unsigned)snprintf(text, sizeof text, "%s\n",
                                                 gcode_text(g->code, g->sent));
        if (g->under_way > 0 && g->under_way + size > g->buffer - 1)
            break;
        if (size + QUESTIONS > grbl_room(g))
            return true;
        grbl_put(g, text, size);
        g->size_of[g->sent++ % GRBL_WAITING] = size;
        g->under_way += size;
    }
    return false;
}

static enum grbl_doing doing_of(const grbl *g)
{
    return g->state != NULL ? g->state->doing : GRBL_RUNS;
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
    if (g->now - g->heard > STILL)
        return "the controller does not answer: look at cable and power";
    if (g->state == NULL)
        return NULL;
    if (*g->state->text != '\0')
        snprintf(text, 200, "the controller says %s: %s", g->word, g->state->text);
    else if (is_held(g) && !g->to.shown)
        snprintf(text, 200, "the controller is held: its button goes on");
    else if (doing_of(g) == GRBL_RUNS && g->now - g->moved > STILL)
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
    send_tell(&g->to, SEND_EVENT,
              "line %zu of %zu, %zu sent ahead, override %u %%, %s  X %.2f Y %.2f Z %.2f", g->done,
              g->lines->count, g->sent - g->done, g->rate, state_word(g), g->place[0], g->place[1],
              g->place[2]);
}

void grbl_key(grbl *g, int key)
{
    switch (key) {
    case 'h': grbl_put_byte(g, '!'); break;
    case 'r': grbl_put_byte(g, '~'); break;
    case '+':
    case '=': grbl_put_byte(g, 0x91); break;
    case '-':
    case '_': grbl_put_byte(g, 0x92); break;
    case '0': grbl_put_byte(g, 0x90); break;
    case 's': tell_state(g); break;
    case 'a': g->abort = true; break;
    default:  break;
    }
}


// Stopping
// --------

/* An answer says that a line of ours is wrong. */
static int report_wrong(const grbl *g)
{
    const bool ours = g->wrong < g->sent;

    return host_error(g->host, EX_PROTOCOL, "grbl.error", (host_place){ .file = g->port }, NULL,
                      "error %s at line %zu of %zu%s%s%s%s; the machine %s", g->error,
                      g->wrong + ours, g->lines->count, ours ? ", `" : "",
                      ours ? gcode_text(g->lines, g->wrong) : "", ours ? "`" : "",
                      grbl_error_text(g->error),
                      g->rests ? "is stopped" : "did not say that it stopped");
}

static int report_aborted(const grbl *g)
{
    if (!g->rests)
        return host_error(
            g->host, EX_TEMPFAIL, "grbl.aborted", (host_place){ .file = NULL }, "home it",
            "aborted at line %zu of %zu: the controller did not say that it stopped, and was reset",
            g->done, g->lines->count);
    return host_error(g->host, EX_TEMPFAIL, "grbl.aborted", (host_place){ .file = NULL }, NULL,
                      "aborted at line %zu of %zu: the machine is stopped at %.3f %.3f %.3f",
                      g->done, g->lines->count, g->place[0], g->place[1], g->place[2]);
}

static int report_stopped(const grbl *g, bool gone)
{
    if (g->why == GRBL_STOPS_ABORTED)
        return gone ? grbl_report_vanished(g) : report_aborted(g);
    if (g->why == GRBL_STOPS_WRONG)
        return report_wrong(g);
    return host_error(
        g->host, EX_PROTOCOL, "grbl.untrusted", (host_place){ .file = g->port },
        "what was drawn cannot be trusted; look at cable and --baud, home it and begin again",
        "%s, at line %zu of %zu", g->what, g->done, g->lines->count);
}

/* The lines that were sent are discarded. The greeting that follows is expected. */
static int reset(grbl *g, double now, task_wants *w)
{
    g->now          = now;
    const bool gone = !grbl_flush(g);

    w->out = g->line.out;
    task_wake(w, g->put + GRBL_DEAF);
    return g->out_size > 0 && !gone ? TASK_GOES : report_stopped(g, gone);
}

/* The position is kept, since a reset at rest loses no step. */
static int await_rest(grbl *g, double now, task_wants *w)
{
    if (!grbl_step(g, now, w))
        return report_stopped(g, true);
    g->rests = g->state != NULL && g->state->doing != GRBL_RUNS && g->state->doing != GRBL_SLOWS;
    task_wake(w, now + LOOK);
    if (!g->rests && now - g->began < STOPS && now - g->moved < STOPS_STILL)
        return TASK_GOES;
    g->code = NULL;
    grbl_put_byte(g, 0x18);
    g->stage = reset;
    return reset(g, now, w);
}

/* Slow down, stop, then tell why. */
static int stop_controller(grbl *g, enum grbl_stop why)
{
    grbl_put_byte(g, '!');
    g->why   = why;
    g->over  = true;
    g->state = NULL;
    g->rests = false;
    g->began = g->moved = g->now;
    g->stage            = await_rest;
    return TASK_GOES;
}

/* The count of answers, or what they say, cannot be right. */
static int stop_after(grbl *g, const char *what)
{
    snprintf(g->what, sizeof g->what, "%s", what);
    return stop_controller(g, GRBL_STOPS_AFTER);
}


// Drawing
// -------

/* Report what is wrong. Returns an exit code after printing one line; TASK_GOES: it is to stop
 * first; 0: nothing is wrong. */
static int report_trouble(grbl *g)
{
    const gcode *code = g->code;
    const double now  = g->now;

    if (g->restarted && g->done == 0)
        return host_error(g->host, EX_TEMPFAIL, "grbl.reset-before",
                          (host_place){ .file = g->port },
                          "nothing was drawn; run the same command again",
                          "the controller was reset before the first line");
    if (g->restarted)
        return host_error(g->host, EX_PROTOCOL, "grbl.restarted", (host_place){ .file = g->port },
                          "its position is lost; home it and begin again",
                          "the controller restarted at line %zu of %zu", g->done, code->count);
    if (g->alarmed)
        return host_error(g->host, EX_PROTOCOL, "grbl.alarm", (host_place){ .file = g->port }, NULL,
                          "alarm %s at line %zu of %zu%s", g->alarm, g->done, code->count,
                          grbl_alarm_text(g->alarm));
    if (g->failed)
        return stop_controller(g, GRBL_STOPS_WRONG);
    if (doing_of(g) == GRBL_ENDS)
        return host_error(g->host, EX_PROTOCOL, "grbl.ended", (host_place){ .file = g->port },
                          HOST_REMEDY("%s; then begin again", g->state->text),
                          "the controller says %s at line %zu of %zu", g->word, g->done,
                          code->count);
    if (g->surplus)
        return stop_after(g, "one answer more than lines were sent: bytes were bent on the line");
    if (g->unread[0] != '\0' && now - g->read > UNREAD) {
        char text[sizeof g->what];
        snprintf(text, sizeof text, "its report `%s` has no meaning", g->unread);
        return stop_after(g, text);
    }
    if (now - g->heard > GRBL_DEAF)
        return host_error(g->host, EX_IOERR, "grbl.silent", (host_place){ .file = g->port },
                          "look at cable and power; it draws what it has and stops",
                          "silent for %g s at line %zu of %zu", GRBL_DEAF, g->done, code->count);
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

void grbl_facts(grbl *g, send_facts *f, char words[160])
{
    *f = (send_facts){ .state    = state_word(g),
                       .done     = (double)g->done,
                       .total    = (double)g->lines->count,
                       .item     = (uint32_t)g->done,
                       .items    = (uint32_t)g->lines->count,
                       .queued   = (uint32_t)(g->sent - g->done),
                       .feed     = g->feed / 60,
                       .override = g->rate,
                       .at       = { g->place[0], g->place[1], g->place[2] },
                       .rests    = is_held(g) };

    follow_path(g, g->path);
    f->moves = g->behind;
    if (is_held(g))
        snprintf(words, 160, "held, r resumes  X %.2f Y %.2f Z %.2f", g->place[0], g->place[1],
                 g->place[2]);
    else
        snprintf(words, 160, "feed %5.1f mm/s %3u %% X %.2f Y %.2f Z %.2f", f->feed, g->rate,
                 g->place[0], g->place[1], g->place[2]);
}

bool grbl_over(const grbl *g) { return g->over; }

static int tell_end(grbl *g, double now, task_wants *w)
{
    char time[HOST_DURATION];

    (void)w;
    g->code = NULL;
    send_tell(&g->to, SEND_RESULT,
              "drawn: %zu curve%s, %.3f m, %zu lines of G-code in %s, %s at %.3f %.3f %.3f",
              g->path->curves, tool_s(g->path->curves), g->path->drawn / 1000, g->lines->count,
              host_duration(time, now - g->began, 1),
              g->name[0] != '\0' ? g->name : "the controller is stopped", g->place[0], g->place[1],
              g->place[2]);
    return 0;
}

static int draw(grbl *g, double now, task_wants *w)
{
    g->now            = now;
    const bool behind = send_lines(g);
    if (!grbl_step(g, now, w))
        return grbl_report_vanished(g);
    const int code = report_trouble(g);
    if (code != 0)
        return code;
    if (g->abort || g->stop)
        return stop_controller(g, GRBL_STOPS_ABORTED);
    task_wake(w, behind && g->out_size == 0 ? now : now + LOOK);
    if (g->done < g->code->count || g->idles < IDLES) {
        if (g->done == g->code->count && doing_of(g) == GRBL_IDLE)
            g->asked = fmin(g->asked, now - GRBL_ASK + AGAIN);  /* the last line was answered
                                                                 * before it was drawn */
        const char *what = awaited_event(g, w->awaits);
        if (what != w->awaits)
            snprintf(w->awaits, sizeof w->awaits, "%s", what ? what : "");
        return TASK_GOES;
    }
    g->over  = true;
    g->stage = tell_end;
    task_wake(w, now);
    return TASK_GOES;
}

static int begin_job(grbl *g, double now, task_wants *w)
{
    g->heard = g->moved = g->read = g->began = now;
    g->stage                                 = draw;
    return draw(g, now, w);
}

void grbl_begin(grbl *g, const gcode *code, const toolpath *path, const send_teller *to)
{
    g->code = g->lines = code;
    g->path            = path;
    g->to              = *to;
    g->state           = NULL;
    g->idles           = 0;
    g->behind          = 0;
    g->sent = g->done = 0;
    g->abort = g->over = false;
    g->stage           = begin_job;
}

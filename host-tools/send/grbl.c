/* host-tools/send/grbl.c -- the conversation with a controller of grbl's kind
 * SPDX-License-Identifier: MIT
 *
 * Lines are sent ahead while their bytes fit the controller's buffer (grbl's wiki, "Streaming a
 * G-code program", character counting). Each `ok` or `error:` frees the bytes of the oldest line.
 * The controller takes ? ! ~ and bytes from 0x80 on out of the stream at once; they do not count.
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "send/grbl.h"
#include "send/grbl_words.h"     /* grbl_error_text, grbl_alarm_text */
#include "base/keys.h"           /* keys_next, keys_interrupted */
#include "base/progress.h"       /* progress_show */
#include "base/tool.h"           /* tool_error, tool_clock */
#include "base/waits.h"          /* waits_for */
#include "send/transport.h"      /* transport */

#define BUFFER      128     /* bytes that every such controller accepts */
#define ASK         0.2     /* s between two status queries */
#define DEAF        10.0    /* s of silence until we give up */
#define STUCK       5.0     /* s at rest with unanswered lines */
#define WAITING     512     /* lines in flight at most */

enum grbl_state { UNKNOWN, IDLE, RUN, HOLD, HELD, ALARM, OTHER };

struct grbl {
    const char *port;
    transport line;
    char text[256];                     /* a line that is being received */
    size_t size;
    char name[64];                      /* its greeting                          */
    unsigned buffer;
    unsigned long received;             /* bytes                                 */
    bool answered;                      /* a word of grbl's arrived */
    bool inquired, asking;              /* $I was sent; its answer is awaited */
    enum grbl_state state;
    double machine[ENGINE_AXES], offset[ENGINE_AXES], place[ENGINE_AXES];
    bool placed, machined, offsetted;   /* known: WPos, or MPos and WCO; MPos; WCO */
    double feed;                        /* mm/min                                */
    unsigned rate;                      /* override in percent                   */
    double heard, asked, moved;         /* clocks                                */
    const gcode *code;
    size_t sent, done, wrong;           /* lines; wrong: the line that the error is about */
    unsigned size_of[WAITING], under_way;   /* bytes                             */
    int error, alarm;
    bool restarted;
};

// Bytes
// -----

static bool put_bytes(grbl *g, const char *bytes, size_t count)
{
    const double until = tool_clock() + DEAF;

    while (count > 0) {
        const long n = g->line.kind->write(&g->line, bytes, count, 100);
        if (n < 0 || tool_clock() > until)
            return false;
        bytes += n;
        count -= (size_t)n;
    }
    return true;
}

static bool put_byte(grbl *g, int byte)
{
    const char c = (char)byte;

    return put_bytes(g, &c, 1);
}

static void read_vector(const char *text, double out[ENGINE_AXES])
{
    (void)sscanf(text, "%lf,%lf,%lf", &out[0], &out[1], &out[2]);
}

static enum grbl_state state_of(const char *word)
{
    static const struct {
        const char *word;
        enum grbl_state state;
    } states[] = { { "Idle", IDLE },   { "Run", RUN },   { "Jog", RUN },
                   { "Hold:0", HELD }, { "Hold", HOLD }, { "Alarm", ALARM } };

    for (size_t i = 0; i < sizeof states / sizeof *states; i++)
        if (strncmp(word, states[i].word, strlen(states[i].word)) == 0)
            return states[i].state;
    return OTHER;
}

/* <Idle|WPos:1.000,2.000,0.000|FS:500,0|Ov:100,100,100|WCO:0.000,0.000,0.000> */
static void take_status(grbl *g, char *text)
{
    g->state = state_of(text);
    for (char *part = strchr(text, '|'); part != NULL; part = strchr(part, '|')) {
        part++;
        if (strncmp(part, "MPos:", 5) == 0) {
            read_vector(part + 5, g->machine);
            g->machined = true;
            g->placed = g->offsetted;
        } else if (strncmp(part, "WPos:", 5) == 0) {
            read_vector(part + 5, g->place);
            g->placed = true;
        } else if (strncmp(part, "WCO:", 4) == 0) {
            read_vector(part + 4, g->offset);
            g->offsetted = true;
        } else if (strncmp(part, "F:", 2) == 0 || strncmp(part, "FS:", 3) == 0) {
            g->feed = atof(strchr(part, ':') + 1);
        } else if (strncmp(part, "Ov:", 3) == 0) {
            g->rate = (unsigned)atoi(part + 3);
        }
    }
    if (strstr(text, "MPos:") != NULL && g->offsetted) {
        g->placed = true;
        for (int i = 0; i < ENGINE_AXES; i++)
            g->place[i] = g->machine[i] - g->offset[i];
    }
}

/* A line was answered: $I, one of our lines, or an earlier line of somebody else. */
static void take_answer(grbl *g)
{
    g->asking = false;
    if (g->done == g->sent)
        return;
    g->under_way -= g->size_of[g->done++ % WAITING];
    g->moved = tool_clock();
}

static bool is_word(const char *text)
{
    static const char *const words[] = { "<", "[", "ok", "error:", "ALARM:", "Grbl" };

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strncmp(text, words[i], strlen(words[i])) == 0)
            return true;
    return false;
}

static void take_line(grbl *g, char *text)
{
    unsigned first, second, bytes;

    g->heard    = tool_clock();
    g->answered = g->answered || is_word(text);
    if (text[0] == '<') {
        take_status(g, text + 1);
    } else if (strcmp(text, "ok") == 0) {
        take_answer(g);
    } else if (strncmp(text, "error:", 6) == 0) {
        if (g->error == 0 && g->done < g->sent) {   /* our first error: lines after it may be
                                                     * answered before anybody looks */
            g->error = atoi(text + 6);
            g->wrong = g->done;
        }
        take_answer(g);
    } else if (strncmp(text, "ALARM:", 6) == 0) {
        g->alarm = atoi(text + 6);
    } else if (strncmp(text, "Grbl", 4) == 0) {
        g->restarted = g->code != NULL;
        if (g->code == NULL)            /* what it said before is obsolete, and so is the
                                         * question */
            g->placed = g->offsetted = g->machined = g->inquired = g->asking = false;
        snprintf(g->name, sizeof g->name, "%.*s", (int)strcspn(text, "["), text);
    } else if (sscanf(text, "[OPT:%*[^,],%u,%u,%u", &first, &second, &bytes) >= 2) {
        g->buffer = second >= BUFFER ? second : BUFFER;
    }
}

static bool pump_bytes(grbl *g, int most_ms)
{
    char bytes[256];
    const double now = tool_clock();

    if (now - g->asked >= ASK) {
        g->asked = now;
        if (!put_byte(g, '?'))
            return false;
    }
    const long got = g->line.kind->read(&g->line, bytes, sizeof bytes, most_ms);
    g->received += got > 0 ? (unsigned long)got : 0;
    for (long i = 0; i < got; i++) {
        if (bytes[i] == '\n' || bytes[i] == '\r') {
            g->text[g->size] = '\0';
            if (g->size > 0)
                take_line(g, g->text);
            g->size = 0;
        } else if (g->size + 1 < sizeof g->text) {
            g->text[g->size++] = bytes[i];
        }
    }
    return got >= 0;
}

static int report_vanished(const grbl *g)
{
    return tool_error(EX_IOERR,
                      "%s: the port has vanished (%s) at line %zu: this protocol cannot resume; "
                      "home the machine and begin again",
                      g->port, strerror(errno), g->done);
}

// The beginning
// -------------

/* Explain, from the received bytes, why the controller is not ready. */
static int report_unready(const grbl *g, double seconds)
{
    const char *name = g->name[0] != '\0' ? g->name : "the controller";

    if (g->received == 0)
        return tool_error(EX_UNAVAILABLE,
                          "%s: no answer in %g s: look at its power, cable and --baud; one that "
                          "takes longer to start needs --wait; "
                          "or is it a loft machine? Then without --grbl",
                          g->line.text, seconds);
    if (!g->answered)
        return tool_error(EX_PROTOCOL,
                          "%s: %lu bytes came, but no word of grbl's: is --baud right, and is it a "
                          "controller of that kind?",
                          g->line.text, g->received);
    if (g->machined)
        return tool_error(EX_CONFIG,
                          "%s: %s answers, but reports its position as MPos without WCO: set $10=0 "
                          "with a terminal, so that it reports WPos",
                          g->line.text, name);
    return tool_error(EX_PROTOCOL,
                      "%s: %s answers, but does not report its position when asked by `?`: "
                      "reset it, or give it firmware that speaks grbl 1.1",
                      g->line.text, name);
}

/* A board that is reset when its port is opened, or whose boot loader listens first, answers late:
 * from its first word on it has the same time again. */
static int greet_controller(grbl *g, double seconds)
{
    double until  = tool_clock() + seconds;
    bool answered = false;
    waits waiting = { .told = false };
    char text[200];

    snprintf(text, sizeof text, "no controller has answered at %s yet: it is asked for %g s",
             g->line.text, seconds);
    while (!g->placed || !g->inquired || g->asking) {
        if (keys_interrupted())
            return tool_error(EX_TEMPFAIL,
                              "stopped before the controller answered: nothing was sent");
        if (!pump_bytes(g, 50))
            return report_vanished(g);
        if (g->answered && !answered)
            until = tool_clock() + seconds;
        answered = g->answered;
        if (!answered)
            waits_for(&waiting, text);
        if (answered && !g->inquired) {
            g->inquired = g->asking = true;
            if (!put_bytes(g, "$I\n", 3))
                return report_vanished(g);
        }
        if (tool_clock() < until)
            continue;
        if (g->placed)
            break;                      /* $I is unknown: use the buffer that all have */
        return report_unready(g, seconds);
    }
    if (g->state == ALARM)
        return tool_error(EX_CONFIG,
                          "%s: the controller is locked after an alarm: home it ($H) or unlock it "
                          "($X) with a terminal, then run this again",
                          g->port);
    if (g->state != IDLE)
        return tool_error(EX_UNAVAILABLE,
                          "%s: the controller is not idle: let it finish, or reset it", g->port);
    return 0;
}

int grbl_open(grbl **out, const char *port, unsigned baud, double seconds)
{
    grbl *g = tool_grow(NULL, sizeof *g);

    *g = (grbl){ .port = port, .buffer = BUFFER, .rate = 100 };
    int code = transport_open(&g->line, port, baud);
    if (code == 0 && (code = greet_controller(g, seconds)) != 0)
        g->line.kind->close(&g->line);
    if (code != 0) {
        free(g);
        g = NULL;
    }
    *out = g;
    return code;
}

void grbl_close(grbl *g)
{
    if (g == NULL)
        return;
    g->line.kind->close(&g->line);
    free(g);
}

const double *grbl_place(const grbl *g) { return g->place; }

// The job
// -------

/* Send as many lines as fit. */
static bool send_lines(grbl *g)
{
    char text[160];

    while (g->sent < g->code->count && g->sent - g->done < WAITING) {
        const unsigned size = (unsigned)snprintf(text, sizeof text, "%s\n", g->code->line[g->sent]);
        if (g->under_way + size > g->buffer - 1)
            break;
        if (!put_bytes(g, text, size))
            return false;
        g->size_of[g->sent++ % WAITING] = size;
        g->under_way += size;
    }
    return true;
}

/* Slow down, stop, and discard the lines that were sent. The position is kept, since a reset at
 * rest loses no step. */
static bool stop_controller(grbl *g)
{
    const double until = tool_clock() + DEAF;

    if (!put_byte(g, '!'))
        return false;
    g->state = UNKNOWN;
    while (g->state != HELD && g->state != IDLE && g->state != ALARM && tool_clock() < until)
        if (!pump_bytes(g, 20))
            return false;
    g->code = NULL;                     /* the greeting that follows is expected */
    return put_byte(g, 0x18);
}

static bool obey_keys(grbl *g, bool *abort)
{
    switch (keys_next()) {
    case 'h': return put_byte(g, '!');
    case 'r': return put_byte(g, '~');
    case '+': return put_byte(g, 0x91);
    case '-': return put_byte(g, 0x92);
    case '0': return put_byte(g, 0x90);
    case 'a': *abort = true; return true;
    default:  return true;
    }
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
    if (g->alarm != 0)
        return tool_error(EX_PROTOCOL, "%s: alarm %d at line %zu of %zu: %s", g->port, g->alarm,
                          g->done, code->count, grbl_alarm_text(g->alarm));
    if (g->error != 0) {
        (void)stop_controller(g);
        return tool_error(EX_PROTOCOL,
                          "%s: error %d at line %zu of %zu, `%s`: %s; the machine is stopped",
                          g->port, g->error, g->wrong + 1, code->count, code->line[g->wrong],
                          grbl_error_text(g->error));
    }
    if (now - g->heard > DEAF)
        return tool_error(EX_IOERR,
                          "%s: silent for %g s at line %zu of %zu: look at cable and power; it "
                          "draws what it has and stops",
                          g->port, DEAF, g->done, code->count);
    if (g->state == IDLE && g->done < g->sent && now - g->moved > STUCK) {
        (void)stop_controller(g);
        return tool_error(EX_PROTOCOL,
                          "%s: %zu lines were not answered: bytes were lost on the line, and what "
                          "was drawn cannot be trusted",
                          g->port, g->sent - g->done);
    }
    return 0;
}

static void show_progress(const grbl *g, progress *bar)
{
    char text[128];

    const bool held = g->state == HOLD || g->state == HELD;

    if (held)
        progress_rest(bar);
    if (held)
        snprintf(text, sizeof text, "held, r resumes  X %.2f Y %.2f Z %.2f", g->place[0],
                 g->place[1], g->place[2]);
    else
        snprintf(text, sizeof text, "feed %5.1f mm/s %3u %% X %.2f Y %.2f Z %.2f", g->feed / 60,
                 g->rate, g->place[0], g->place[1], g->place[2]);
    progress_show(bar, (double)g->done, text);
}

static int drive_job(grbl *g, progress *bar)
{
    bool abort = false;
    waits waiting = { .told = false };

    while (g->done < g->code->count || g->state != IDLE) {
        if (!send_lines(g) || !pump_bytes(g, 20) || !obey_keys(g, &abort))
            return report_vanished(g);
        const int code = report_trouble(g);
        if (code != 0)
            return code;
        if (abort || keys_interrupted()) {
            const size_t count = g->code->count;
            if (!stop_controller(g))
                return report_vanished(g);
            return tool_error(
                EX_TEMPFAIL, "aborted at line %zu of %zu: the machine is stopped at %.3f %.3f %.3f",
                g->done, count, g->place[0], g->place[1], g->place[2]);
        }
        if (g->done == g->code->count && g->state != RUN && g->state != HOLD && g->state != HELD)
            g->asked = 0;               /* the last line was answered before it was drawn: ask
                                         * again */
        show_progress(g, bar);
        waits_for(&waiting, !bar->shown && (g->state == HOLD || g->state == HELD)
                                ? "the controller is held: its button goes on"
                                : NULL);
    }
    return 0;
}

int grbl_run(grbl *g, const gcode *code, const char *what)
{
    progress bar;
    const double began = tool_clock();

    g->code  = code;
    g->state = UNKNOWN;
    g->heard = g->moved = began;
    progress_start(&bar, (double)code->count);
    const int result = drive_job(g, &bar);
    progress_clear(&bar);
    if (result == 0)
        printf("drawn: %s, %zu lines of G-code in %.1f s, %s at %.3f %.3f %.3f\n", what,
               code->count, tool_clock() - began,
               g->name[0] != '\0' ? g->name : "the controller is stopped", g->place[0], g->place[1],
               g->place[2]);
    return result;
}

/* host-tools/send/grbl_talk.c
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "send/grbl_talk.h"
#include "base/tool.h"           /* tool_error, tool_clock */

#define ASK         0.2     /* s between two status queries */
#define OFFSET_ASK  0.02    /* s, until it has told its offset: with every 10th or 30th answer */


// Bytes
// -----

bool grbl_put(grbl *g, const char *bytes, size_t count)
{
    const double until = tool_clock() + GRBL_DEAF;

    while (count > 0) {
        const long n = g->line.kind->write(&g->line, bytes, count, 100);
        if (n < 0 || tool_clock() > until)
            return false;
        bytes += n;
        count -= (size_t)n;
    }
    return true;
}

bool grbl_put_byte(grbl *g, int byte)
{
    const char c = (char)byte;

    return grbl_put(g, &c, 1);
}


// Lines
// -----

static void read_vector(const grbl *g, const char *text, double out[ENGINE_AXES])
{
    if (sscanf(text, "%lf,%lf,%lf", &out[0], &out[1], &out[2]) == ENGINE_AXES)
        for (int i = 0; i < ENGINE_AXES; i++)
            out[i] *= g->unit;
}

static enum grbl_state state_of(const char *word)
{
    static const struct {
        const char *word;
        enum grbl_state state;
    } states[] = { { "Idle", GRBL_IDLE },   { "Run", GRBL_RUN },   { "Jog", GRBL_RUN },
                   { "Hold:0", GRBL_HELD }, { "Hold", GRBL_HOLD }, { "Alarm", GRBL_ALARM } };

    for (size_t i = 0; i < sizeof states / sizeof *states; i++)
        if (strncmp(word, states[i].word, strlen(states[i].word)) == 0)
            return states[i].state;
    return GRBL_OTHER;
}

/* <Idle|WPos:1.000,2.000,0.000|FS:500,0|Ov:100,100,100|WCO:0.000,0.000,0.000> */
static void take_status(grbl *g, char *text)
{
    g->state = state_of(text);
    for (char *part = strchr(text, '|'); part != NULL; part = strchr(part, '|')) {
        part++;
        if (strncmp(part, "MPos:", 5) == 0) {
            read_vector(g, part + 5, g->machine);
            g->machined = true;
            g->placed = g->offsetted;
        } else if (strncmp(part, "WPos:", 5) == 0) {
            read_vector(g, part + 5, g->place);
            g->placed = true;
        } else if (strncmp(part, "WCO:", 4) == 0) {
            read_vector(g, part + 4, g->offset);
            g->offsetted = true;
        } else if (strncmp(part, "F:", 2) == 0 || strncmp(part, "FS:", 3) == 0) {
            g->feed = g->unit * atof(strchr(part, ':') + 1);
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

/* What it said of its place, and of itself, does not hold any more. */
static void forget(grbl *g)
{
    g->placed = g->offsetted = g->machined = g->asking = false;
    g->inquired              = 0;
    g->unit                  = 1;
    g->settings              = (grbl_settings){ .used = 0 };
}

/* All of `$$` is known: from now on it is understood in its unit. */
static void use_settings(grbl *g)
{
    if (!(grbl_settings_number(&g->settings, 13, 0) > 0))
        return;
    g->unit   = 25.4;
    g->placed = g->offsetted = g->machined = false;
}

/* A line was answered: a question, one of our lines, or an earlier line of somebody else. */
static void take_answer(grbl *g)
{
    if (g->asking && g->inquired == GRBL_QUESTIONS)
        use_settings(g);
    g->asking = false;
    if (g->done == g->sent)
        return;
    g->under_way -= g->size_of[g->done++ % GRBL_WAITING];
    g->moved = tool_clock();
}

static bool is_word(const char *text)
{
    static const char *const words[] = { "<", "[", "$", "ok", "error:", "ALARM:", "Grbl" };

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strncmp(text, words[i], strlen(words[i])) == 0)
            return true;
    return false;
}

static void take_line(grbl *g, char *text)
{
    unsigned first, second, bytes;
    char built[64];

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
            forget(g);
        snprintf(g->name, sizeof g->name, "%.*s", (int)strcspn(text, "["), text);
    } else if (text[0] == '$') {
        grbl_settings_take(&g->settings, text);
    } else if (sscanf(text, "[OPT:%63[^,],%u,%u,%u", built, &first, &second, &bytes) >= 3) {
        g->buffer               = second >= GRBL_BUFFER ? second : GRBL_BUFFER;
        g->settings.corner_zero = strchr(built, 'Z') != NULL;
    }
}

bool grbl_pump(grbl *g, int most_ms)
{
    char bytes[256];
    const double now = tool_clock();

    if (now - g->asked >= (g->code == NULL && g->answered && !g->offsetted ? OFFSET_ASK : ASK)) {
        g->asked = now;
        if (!grbl_put_byte(g, '?'))
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

int grbl_report_vanished(const grbl *g)
{
    return tool_error(EX_IOERR,
                      "%s: the port has vanished (%s) at line %zu: this protocol cannot resume; "
                      "home the machine and begin again",
                      g->port, strerror(errno), g->done);
}

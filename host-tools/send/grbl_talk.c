/* host-tools/send/grbl_talk.c
 * SPDX-License-Identifier: MIT
 */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "base/scan.h"           /* scan_number */
#include "send/grbl_talk.h"

#define OFFSET_ASK  0.02    /* s, until it has told its offset: with every 10th or 30th answer */


// Bytes
// -----

size_t grbl_room(const grbl *g) { return sizeof g->out - g->out_size; }

void grbl_put(grbl *g, const char *bytes, size_t count)
{
    if (g->out_size == 0)
        g->put = g->now;
    if (count > grbl_room(g))
        return;                     /* only questions, while the line is full for long */
    memcpy(g->out + g->out_size, bytes, count);
    g->out_size += count;
}

void grbl_put_byte(grbl *g, int byte)
{
    const char c = (char)byte;

    grbl_put(g, &c, 1);
}

bool grbl_flush(grbl *g)
{
    if (g->out_size == 0)
        return true;
    const long n = g->line.kind->write(&g->line, g->out, g->out_size);
    if (n < 0)
        return false;
    if (n > 0)
        g->put = g->now;
    g->out_size -= (size_t)n;
    memmove(g->out, g->out + n, g->out_size);
    if (g->out_size == 0 || g->now - g->put <= GRBL_DEAF)
        return true;
    errno = ETIMEDOUT;
    return false;
}


// Lines
// -----

/* A number of it, which ends at one of these. Numbers that are none, such as nan, are not read. */
static bool number_at(const char **at, const char *ends, double least, double most, double *out)
{
    double value;

    if (!scan_number(at, &value) || !(value >= least && value <= most) ||
        strchr(ends, **at) == NULL)
        return false;
    *out = value;
    return true;
}

/* Places of its axes: the first three count. */
static bool vector_at(const char *text, double unit, double out[ENGINE_AXES])
{
    double value = 0;
    int count    = 0;

    do {
        if (!number_at(&text, ",|>", -GRBL_FAR, GRBL_FAR, &value))
            return false;
        if (count < ENGINE_AXES)
            out[count] = value * unit;
        count++;
    } while (*text++ == ',');
    return count >= ENGINE_AXES;
}

/* What a status tells; what it does not tell is as before. */
typedef struct {
    double place[ENGINE_AXES], machine[ENGINE_AXES], offset[ENGINE_AXES], feed, rate;
    bool placed, machined, offsetted;
} status;

/* A part of a status, "WPos:1.000,2.000,0.000". Returns false if it has no meaning. */
static bool part_read(const char *part, double unit, status *s)
{
    const char *value = part + strcspn(part, ":|>");

    value += *value == ':';
    if (strncmp(part, "MPos:", 5) == 0)
        return s->machined = vector_at(value, unit, s->machine);
    if (strncmp(part, "WPos:", 5) == 0)
        return s->placed = vector_at(value, unit, s->place);
    if (strncmp(part, "WCO:", 4) == 0)
        return s->offsetted = vector_at(value, unit, s->offset);
    if (strncmp(part, "F:", 2) == 0 || strncmp(part, "FS:", 3) == 0)
        return number_at(&value, ",|>", 0, GRBL_FAR, &s->feed);
    if (strncmp(part, "Ov:", 3) == 0)
        return number_at(&value, ",|>", 1, 1000, &s->rate);
    return true;
}

/* <Idle|WPos:1.000,2.000,0.000|FS:500,0|Ov:100,100,100|WCO:0.000,0.000,0.000> */
static bool status_read(const grbl *g, const char *text, status *s)
{
    const size_t size = strlen(text);

    *s = (status){ .rate = g->rate, .feed = NAN };
    if (size == 0 || text[size - 1] != '>')
        return false;                   /* bytes of it were lost on the line */
    for (const char *part = strchr(text, '|'); part != NULL; part = strchr(part, '|'))
        if (!part_read(++part, g->unit, s))
            return false;
    return true;
}

static void set_place(grbl *g, const double to[ENGINE_AXES])
{
    if (g->placed && memcmp(g->place, to, sizeof g->place) != 0)
        g->moved = g->now;
    memcpy(g->place, to, sizeof g->place);
    g->placed = true;
}

static void take_status(grbl *g, const char *text)
{
    double place[ENGINE_AXES];
    status s;

    if (!status_read(g, text, &s)) {
        if (g->unread[0] == '\0')
            snprintf(g->unread, sizeof g->unread, "<%s", text);
        return;
    }
    g->unread[0] = '\0';
    g->read      = g->now;
    g->state     = grbl_state_of(text);
    g->idles     = g->state->doing == GRBL_IDLE ? g->idles + 1 : 0;
    snprintf(g->word, sizeof g->word, "%.*s", (int)strcspn(text, "|>"), text);
    g->rate = (unsigned)s.rate;
    if (!isnan(s.feed))
        g->feed = g->unit * s.feed;
    if (s.offsetted) {
        memcpy(g->offset, s.offset, sizeof g->offset);
        g->offsetted = true;
    }
    g->machined = g->machined || s.machined;
    for (int i = 0; i < ENGINE_AXES; i++)
        place[i] = s.machine[i] - g->offset[i];
    if (s.placed)
        set_place(g, s.place);
    else if (s.machined && g->offsetted)
        set_place(g, place);
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

/* A line was answered: a question, one of our lines, or an earlier line of somebody else. In a job
 * there is nobody else. */
static void take_answer(grbl *g)
{
    const bool asked = g->asking;

    if (g->asking && g->inquired == GRBL_QUESTIONS)
        use_settings(g);
    g->asking = false;
    g->idles  = 0;
    if (g->done == g->sent) {
        g->surplus = g->surplus || (g->code != NULL && !asked);
        return;
    }
    g->under_way -= g->size_of[g->done++ % GRBL_WAITING];
    g->moved = g->now;
}

/* What follows `word`, written in any case, and a colon; NULL: the line does not begin with it. */
static const char *said_behind(const char *word, const char *line)
{
    const size_t size = strlen(word);

    if (strncasecmp(line, word, size) != 0 || isalnum((unsigned char)line[size]))
        return NULL;
    return line + size + strspn(line + size, ": \t");
}

static bool is_word(const char *text)
{
    static const char *const words[] = { "<", "[", "$", "Grbl" };

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strncmp(text, words[i], strlen(words[i])) == 0)
            return true;
    return strcmp(text, "ok") == 0 || said_behind("error", text) || said_behind("alarm", text);
}

/* Our first error: lines after it may be answered before anybody looks. */
static void take_error(grbl *g, const char *said)
{
    if (!g->failed && g->code != NULL) {
        snprintf(g->error, sizeof g->error, "%s", said);
        g->failed = true;
        g->wrong  = g->done;
    }
    take_answer(g);
}

static void take_greeting(grbl *g, const char *text)
{
    g->restarted = g->code != NULL;
    if (g->code == NULL)                /* what it said before is obsolete */
        forget(g);
    snprintf(g->name, sizeof g->name, "%.*s", (int)strcspn(text, "["), text);
}

/* [OPT:VZ,15,128]: what it was built with, blocks, bytes of its buffer; some tell less. */
static void take_build(grbl *g, const char *text)
{
    const char *built = text + strlen("[OPT:"), *at = built + strcspn(built, ",]");
    double blocks, bytes;

    g->settings.corner_zero = memchr(built, 'Z', (size_t)(at - built)) != NULL;
    if (*at != ',')
        return;
    at++;
    if (number_at(&at, ",", 0, GRBL_FAR, &blocks) && *at++ == ',' &&
        number_at(&at, ",]", GRBL_BUFFER_LEAST, GRBL_BUFFER_MOST, &bytes))
        g->buffer = (unsigned)bytes;
    else
        host_warn(g->host, "grbl.buffer", (host_place){ .file = g->port },
                  "look at the line and at its firmware",
                  "the controller says `%s`, which is no size of a buffer: %u bytes are sent ahead",
                  text, g->buffer - 1);
}

static void take_line(grbl *g, char *text)
{
    const char *said;

    g->heard    = g->now;
    g->answered = g->answered || is_word(text);
    if (text[0] == '<') {
        take_status(g, text + 1);
    } else if (strcmp(text, "ok") == 0) {
        take_answer(g);
    } else if ((said = said_behind("error", text)) != NULL) {
        take_error(g, said);
    } else if ((said = said_behind("alarm", text)) != NULL) {
        if (!g->alarmed)
            snprintf(g->alarm, sizeof g->alarm, "%s", said);
        g->alarmed = true;
    } else if (strncmp(text, "Grbl", 4) == 0) {
        take_greeting(g, text);
    } else if (text[0] == '$') {
        grbl_settings_take(&g->settings, g->host, g->port, text);
    } else if (strncmp(text, "[OPT:", 5) == 0) {
        take_build(g, text);
    }
}

static double asks_after(const grbl *g)
{
    return g->code == NULL && g->answered && !g->offsetted ? OFFSET_ASK : GRBL_ASK;
}

static void take_byte(grbl *g, char byte)
{
    if (byte == '\n' || byte == '\r') {
        g->text[g->size] = '\0';
        if (g->size > 0)
            take_line(g, g->text);
        g->size = 0;
    } else if (g->size + 1 < sizeof g->text) {
        g->text[g->size++] = byte;
    }
}

bool grbl_step(grbl *g, double now, task_wants *w)
{
    char bytes[256];

    g->now = now;
    if (now - g->asked >= asks_after(g)) {
        g->asked = now;
        grbl_put_byte(g, '?');
    }
    if (!grbl_flush(g))
        return false;
    const long got = g->line.kind->read(&g->line, bytes, sizeof bytes);
    g->received += got > 0 ? (unsigned long)got : 0;
    for (long i = 0; i < got; i++)
        take_byte(g, bytes[i]);
    w->in  = g->line.in;
    w->out = g->out_size > 0 ? g->line.out : -1;
    task_wake(w, g->asked + asks_after(g));
    return got >= 0;
}

int grbl_report_vanished(const grbl *g)
{
    return host_error(g->host, EX_IOERR, "grbl.port-gone", (host_place){ .file = g->port },
                      "this protocol cannot resume; home the machine and begin again",
                      "the port has vanished (%s) at line %zu", strerror(errno), g->done);
}

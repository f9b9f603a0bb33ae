/* tests/tools/test_grbl.c -- jobs for a controller of grbl's kind, in simulated time: whatever it
 * answers, the job is drawn as a whole, or the user is told
 * SPDX-License-Identifier: MIT
 *
 * The controller is a model of what grbl's wiki says: bytes wait in a buffer, a line takes 1 ms, 15
 * moves are planned ahead. The line is replaced here, and the clock is that of the model.
 */
#include <ctype.h>
#include <math.h>
#include <string.h>
#include <sysexits.h>

#include "check.h"
#include "cmd/waits.h"
#include "send/grbl.h"
#include "send/transport.h"

#define NEVER   100000
#define BLOCKS  15
#define PATIENCE 5.0            /* s until something is told */

/* What is wrong with it, from or at a line. */
typedef struct {
    unsigned at;                /* its number, from 1 */
    const char *answer;         /* instead of `ok` */
    const char *state;          /* it stays in it, and reads no more lines */
    const char *place;          /* what it reports */
    unsigned answers;           /* `ok` so often */
    const char *build;          /* it answers to $I */
    unsigned room;              /* bytes of its buffer */
} faults;

static struct {
    faults f;
    double clock, free_at;
    char in[4096], out[65536];
    size_t in_used, out_used, out_at;
    unsigned lines, drawn, blocks, overflows, oks;
    bool held, deaf;
} c;

static char caught[4096], told[4096];
static unsigned caught_lines;
static double told_at, stop_at;
static bool finite_only;


// What the sender uses
// --------------------

static void hear_message(void *context, const host_message *m)
{
    (void)context;
    snprintf(caught + strlen(caught), sizeof caught - strlen(caught), "%s", m->what);
    caught_lines++;
    told_at = fmin(told_at, c.clock);
}

static host hears = { .message = hear_message };

static void hear_line(const char *line)
{
    const size_t used = strlen(told);

    snprintf(told + used, sizeof told - used, "%s", line);
    told_at = fmin(told_at, c.clock);
}

static void look_at(grbl *g)
{
    send_facts f;
    char words[160];

    grbl_facts(g, &f, words);
    for (int i = 0; i < ENGINE_AXES; i++)
        finite_only = finite_only && isfinite(f.at[i]);
    finite_only = finite_only && isfinite(f.feed);
}


// The controller
// --------------

static void say(const char *text)
{
    c.out_used += (size_t)snprintf(c.out + c.out_used, sizeof c.out - c.out_used, "%s\r\n", text);
}

static void say_ok(void)
{
    say("ok");
    c.oks++;
}

static bool is_wrong(void) { return c.lines >= c.f.at; }

static void say_state(void)
{
    char text[200];

    snprintf(text, sizeof text, "<%s|WPos:%s|FS:600,0|WCO:0.000,0.000,0.000|Ov:100,100,100>",
             is_wrong() && c.f.state ? c.f.state
             : c.held                ? "Hold:0"
             : c.blocks > 0          ? "Run"
                                     : "Idle",
             is_wrong() && c.f.place ? c.f.place : "1.000,2.000,0.000");
    say(text);
}

static void take_byte(unsigned char byte)
{
    if (byte == '?') {
        say_state();
    } else if (byte == '!') {
        c.held = true;
    } else if (byte == 0x18) {
        c.in_used = c.blocks = 0;
        c.held = false;
        say("Grbl 1.1h ['$' for help]");
    } else if (byte < 0x80 && byte != '~') {
        c.overflows += c.in_used >= c.f.room;
        if (c.in_used < sizeof c.in)
            c.in[c.in_used++] = (char)byte;
    }
}

static void obey_line(const char *line)
{
    if (strcmp(line, "$I") == 0) {
        say(c.f.build);
        say_ok();
    } else if (strcmp(line, "$$") == 0) {
        say("$20=0");
        say_ok();
    } else {
        c.lines++;
        if (c.lines == c.f.at && c.f.answer) {
            say(c.f.answer);
        } else {
            for (unsigned k = c.lines == c.f.at ? c.f.answers : 1; k > 0; k--)
                say_ok();
            c.drawn++;
            c.blocks++;
        }
    }
}

/* A millisecond. */
static void work(void)
{
    char line[128];
    const char *end = memchr(c.in, '\n', c.in_used);

    c.clock += 0.001;
    if (c.held || (is_wrong() && c.f.state))
        return;
    if (c.blocks > 0 && c.clock >= c.free_at) {
        c.blocks--;
        c.free_at = c.clock + 0.004;
    }
    if (end == NULL || c.blocks >= BLOCKS)
        return;
    const size_t size = (size_t)(end - c.in);
    snprintf(line, sizeof line, "%.*s", (int)size, c.in);
    c.in_used -= size + 1;
    memmove(c.in, end + 1, c.in_used);
    obey_line(line);
}

static long read_bytes(transport *t, void *bytes, size_t most)
{
    (void)t;
    const size_t left = c.out_used - c.out_at, count = left < most ? left : most;
    memcpy(bytes, c.out + c.out_at, count);
    c.out_at += count;
    if (c.out_at == c.out_used)
        c.out_at = c.out_used = 0;
    return (long)count;
}

static long write_bytes(transport *t, const void *bytes, size_t count)
{
    (void)t;
    for (size_t k = 0; k < count; k++)
        take_byte(((const unsigned char *)bytes)[k]);
    return (long)count;
}

static void close_line(transport *t) { (void)t; }

int transport_open(transport *t, host *h, const char *name, unsigned baud)
{
    static const transport_kind kind = { read_bytes, write_bytes, close_line };

    (void)h;
    (void)baud;
    *t = (transport){ .kind = &kind };
    snprintf(t->text, sizeof t->text, "%s", name);
    return 0;
}

int transport_step(transport *t, double now, task_wants *w)
{
    (void)t;
    (void)now;
    (void)w;
    return 0;
}


// Jobs
// ----

static void begin(const faults *f)
{
    memset(&c, 0, sizeof c);
    c.f = *f;
    c.f.room     = f->room ? f->room : 128;
    c.f.build    = f->build ? f->build : "[OPT:V,15,128]";
    caught[0] = told[0] = '\0';
    caught_lines = 0;
    told_at = stop_at = HUGE_VAL;
    finite_only = true;
}

/* Step what was begun until it is over; the model works on until it has something to say, or until
 * the time that the task wants. */
static int run(grbl *g, bool draws)
{
    const task t  = grbl_task(g);
    waits waiting = { .told = false };
    task_wants w;
    int code;

    while ((code = task_step(&t, c.clock, &w)) == TASK_GOES) {
        if (draws && !grbl_over(g))
            look_at(g);
        if (waits_due(&waiting, w.awaits, c.clock))
            hear_line(w.awaits);
        CHECK(w.until < HUGE_VAL);
        do
            work();
        while (c.out_at == c.out_used && c.clock < w.until);
        *t.stop = c.clock >= stop_at;
    }
    return code;
}

static int open_controller(grbl **g)
{
    const int code = grbl_open(g, &hears, "p", 115200, 5);

    return code ? code : run(*g, false);
}

/* Send `count` lines to a controller that is open. */
static int send(grbl *g, unsigned count)
{
    static char text[NEVER];
    static struct gcode_line line[2000];
    gcode lines   = { .text = text, .line = line, .count = count };
    toolpath path = { 0 };

    for (unsigned n = 0; n < count; n++) {
        line[n] = (struct gcode_line){ lines.used, 0 };
        lines.used += (size_t)snprintf(text + lines.used, 64, "G1X%u.125Y%uF600", n, n * n) + 1;
    }
    grbl_begin(g, &lines, &path, &(send_teller){ .shown = true });
    return run(g, true);
}

/* A whole job; the exit code. */
static int draw(const faults *f, unsigned count)
{
    grbl *g;

    begin(f);
    int code = open_controller(&g);
    if (code == 0)
        code = send(g, count);
    grbl_close(g);
    return code;
}

static const char *one_of(arb *a, const char *const words[], size_t count)
{
    return words[arb_below(a, (uint32_t)count)];
}
#define ONE_OF(a, words) one_of(a, words, sizeof words / sizeof *words)

static unsigned some_lines(arb *a) { return 40 + arb_below(a, 200); }

static void a_job_is_drawn_as_a_whole(arb *a)
{
    const unsigned count = some_lines(a);

    CHECK(draw(&(faults){ .at = NEVER }, count) == 0);
    CHECK(c.drawn == count && c.overflows == 0 && caught_lines == 0 && c.blocks == 0);
}

static void any_error_or_alarm_ends_it(arb *a)
{
    static const char *const heads[] = { "error:", "error: ", "Error:", "ERROR:", "ALARM:",
                                         "ALARM: ", "alarm:", "error", "ALARM" };
    const unsigned count = some_lines(a), n = 1 + arb_below(a, 39);
    const char *head = ONE_OF(a, heads);
    char words[40] = "", text[64];
    const uint32_t kind = arb_below(a, 3);

    if (isalpha((unsigned char)head[strlen(head) - 1]))
        ;
    else if (kind == 0)
        snprintf(words, sizeof words, "%d", (int)arb_below(a, 300));
    else if (kind == 1)
        snprintf(words, sizeof words, "%s", arb_below(a, 2) ? "Unsupported command" : "-1 nan");
    else
        for (size_t k = 0; k < 1 + arb_below(a, 30); k++)
            words[k] = (char)('A' + arb_below(a, 26));
    snprintf(text, sizeof text, "%s%s", head, words);
    CHECK(draw(&(faults){ .at = n, .answer = text }, count) == EX_PROTOCOL);
    CHECK(caught_lines == 1 && strstr(caught, words) != NULL &&
          strstr(caught, " at line ") != NULL);
    CHECK(c.clock < 10);
}

static void every_state_is_known_or_told(arb *a)
{
    static const char *const states[] = { "Door",   "Door:0", "Door:1",  "Door:2", "Door:3",
                                          "Sleep",  "Check",  "Home",    "Tool",   "Run",
                                          "Jog",    "Alarm",  "Alarm:3", "Queue",  "Feed:1",
                                          "Hold:1", "Run:2",  "" };
    const char *state = ONE_OF(a, states);
    const unsigned n  = 1 + arb_below(a, 39);
    double since;
    grbl *g;

    begin(&(faults){ .at = n, .state = state });
    CHECK(open_controller(&g) == 0);
    stop_at        = c.clock + 1 + PATIENCE + 1;     /* 40 lines take less than a second */
    const int code = send(g, 100);
    since          = c.clock - stop_at;
    grbl_close(g);
    CHECK(code == EX_PROTOCOL || code == EX_TEMPFAIL);
    CHECK(strncmp(state, "Hold", 4) == 0 || told_at < stop_at - 1);
    CHECK(since < 6);
    CHECK(caught_lines == 1);
}

static void a_state_that_draws_nothing_begins_no_job(arb *a)
{
    static const char *const states[] = { "Door:1", "Sleep", "Check", "Home",  "Tool",
                                          "Run",    "Alarm", "Queue", "Hold:0" };

    const int code = draw(&(faults){ .at = 0, .state = ONE_OF(a, states) }, 50);
    CHECK(code == EX_UNAVAILABLE || code == EX_CONFIG);
    CHECK(caught_lines == 1 && c.lines == 0);
}

static void numbers_without_a_meaning_are_told(arb *a)
{
    static const char *const places[] = {
        "nan,inf,inf",  "1.0,-nan,2.0", "0.0,0.0,1e999", "0x10,1,2", "1e30,0,0", "1.0,2.0", "",
        "1.0,2.0,3.0x", "-inf,0,0",     "1,2,3,"
    };
    const unsigned n  = arb_below(a, 40);
    const int code    = draw(&(faults){ .at = n, .place = ONE_OF(a, places) }, 100);

    CHECK(code == EX_PROTOCOL);
    CHECK(finite_only && caught_lines == 1);
    CHECK(n == 0 || told_at < 1 + PATIENCE + 1);
}

static void answers_are_counted_both_ways(arb *a)
{
    const unsigned n = 1 + arb_below(a, 100);

    CHECK(draw(&(faults){ .at = n, .answers = 2 + arb_below(a, 2) }, 100) == EX_PROTOCOL);
    CHECK(caught_lines == 1 && strstr(caught, "one answer more") != NULL);
    CHECK(draw(&(faults){ .at = n, .answers = 0 }, 100) == EX_PROTOCOL);
    CHECK(caught_lines == 1 && strstr(caught, "not answered") != NULL);
}

static void its_buffer_is_as_it_says(arb *a)
{
    static const char *const strange[] = { "[OPT:V,-1,-1]",         "[OPT:V,15,0]",
                                           "[OPT:V,15,nan]",        "[OPT:V,15,1e9]",
                                           "[OPT:V,15,4294967296]", "[OPT:V,15]",
                                           "[OPT:V,15,64x]", "[OPT:V,,]" };
    static const char *const silent[]  = { "[OPT:V]", "[VER:1.1:]", "[OPT:]" };
    const unsigned room = 16 + arb_below(a, 400), count = some_lines(a);
    char build[40];

    snprintf(build, sizeof build, "[OPT:V,15,%u%s]", room, arb_below(a, 2) ? ",3,0" : "");
    CHECK(draw(&(faults){ .at = NEVER, .build = build, .room = room < 40 ? 40 : room }, count) ==
          0);
    CHECK(c.drawn == count && c.overflows == 0 && caught_lines == 0);
    CHECK(draw(&(faults){ .at = NEVER, .build = ONE_OF(a, strange) }, count) == 0);
    CHECK(c.drawn == count && c.overflows == 0 && caught_lines == 1);
    CHECK(draw(&(faults){ .at = NEVER, .build = ONE_OF(a, silent) }, count) == 0);
    CHECK(c.drawn == count && c.overflows == 0 && caught_lines == 0);
}

static void each_part_is_sent_from_its_first_line(arb *a)
{
    const unsigned first = some_lines(a), second = some_lines(a);
    grbl *g;

    begin(&(faults){ .at = NEVER });
    CHECK(open_controller(&g) == 0);
    CHECK(send(g, first) == 0 && send(g, second) == 0);
    CHECK(c.drawn == first + second);
    grbl_close(g);
}

int main(void)
{
    PROPERTY(a_job_is_drawn_as_a_whole, 20);
    PROPERTY(any_error_or_alarm_ends_it, 100);
    PROPERTY(every_state_is_known_or_told, 100);
    PROPERTY(a_state_that_draws_nothing_begins_no_job, 20);
    PROPERTY(numbers_without_a_meaning_are_told, 50);
    PROPERTY(answers_are_counted_both_ways, 20);
    PROPERTY(its_buffer_is_as_it_says, 20);
    PROPERTY(each_part_is_sent_from_its_first_line, 10);
    return check_failures();
}

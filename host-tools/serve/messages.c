/* host-tools/serve/messages.c
 * SPDX-License-Identifier: MIT
 */
#include <json-c/json.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/say.h"
#include "base/tool.h"          /* tool_version */
#include "plan/table.h"          /* table_ends */
#include "serve/client.h"
#include "serve/messages.h"
#include "serve/store.h"

#define OFTEN  0.1              /* s between two reports to a page */
#define DEPTH  8                /* of arrays and objects in a text that is heard */
#define LINES  40               /* that are kept for a page that comes */
#define NOBODY (-1)

/* What has a text of its own in the state. */
enum part { PART_CONTROL, PART_MACHINE, PART_DRAWING, PART_PLAN, PART_JOB, PART_LINES, PARTS };
static const char *const part_names[PARTS] = { "control", "machine", "drawing",
                                               "plan",    "job",     "lines" };

struct serve {
    host *host;
    serve_options o;
    desk d;
    store kept;
    preview v;
    client client[SERVE_CLIENTS];
    int holder;                 /* who controls, or NOBODY */
    struct {
        char *text;
        uint64_t seq;           /* when it changed last */
    } part[PARTS];
    uint64_t seq;
    double now, looked;
    unsigned greeted;           /* what the plan is made for: as d.greeted */
    char *plan, *moves;         /* what the other process said */
    char *warnings;             /* of the plan, with commas between */
    unsigned plans;             /* how many there were */
    bool failed;
    double planned;             /* 0..1 */
    char *line[LINES];          /* objects; line[k % LINES] is number k */
    unsigned lines;
    bool drawing;               /* a job was begun, and its end is not told yet */
    bool job;                   /* there was one */
    int code;                   /* how it ended */
    char result[300];           /* what was said then */
    bool blocked, stops;        /* work takes long; it is to stop */
    bool hears;                 /* what is told now is the answer: */
    char name[48], failure[600], remedy[300];
};


// Texts
// -----

typedef struct {
    FILE *out;
    char *text;
    size_t size;
} writing;

static void begin_text(writing *w)
{
    *w     = (writing){ .out = NULL };
    w->out = open_memstream(&w->text, &w->size);
}

static char *end_text(writing *w)
{
    fclose(w->out);
    return w->text;
}

static char *text_of(const char *format, ...) __attribute__((format(printf, 1, 2)));
static char *text_of(const char *format, ...)
{
    writing w;
    va_list values;

    begin_text(&w);
    va_start(values, format);
    vfprintf(w.out, format, values);
    va_end(values);
    return end_text(&w);
}

static void put_pair(FILE *out, const char *before, const char *key, const char *text)
{
    fprintf(out, "%s\"%s\":", before, key);
    if (text != NULL)
        say_quoted(out, text);
    else
        fputs("null", out);
}

/* A part of the state; `text` becomes its own. */
static void set(serve *s, enum part k, char *text)
{
    if (s->part[k].text != NULL && strcmp(s->part[k].text, text) == 0) {
        free(text);
        return;
    }
    free(s->part[k].text);
    s->part[k].text = text;
    s->part[k].seq  = ++s->seq;
}


// The state
// ---------

static void set_lines(serve *s)
{
    writing w;
    const unsigned first = s->lines > LINES ? s->lines - LINES : 0;

    begin_text(&w);
    putc('[', w.out);
    for (unsigned k = first; k < s->lines; k++)
        fprintf(w.out, "%s%s", k > first ? "," : "", s->line[k % LINES]);
    putc(']', w.out);
    set(s, PART_LINES, end_text(&w));
}

static void add_line(serve *s, char *object)
{
    free(s->line[s->lines % LINES]);
    s->line[s->lines++ % LINES] = object;
    set_lines(s);
}

static void set_control(serve *s)
{
    unsigned count = 0;

    for (int i = 0; i < SERVE_CLIENTS; i++)
        count += s->client[i].greeted;
    if (s->holder == NOBODY)
        set(s, PART_CONTROL, text_of("{\"holder\":null,\"pages\":%u}", count));
    else
        set(s, PART_CONTROL, text_of("{\"holder\":%d,\"pages\":%u}", s->holder, count));
}

static const char *machine_word(const serve *s)
{
    const desk *d = &s->d;

    if (s->o.line.port == NULL)
        return "none";
    switch (d->state) {
    case DESK_ALONE:    return "away";
    case DESK_CONNECTS: return "connects";
    case DESK_MOVES:    return "moves";
    case DESK_DRAWS:
    case DESK_CHANGES:  return "job";
    case DESK_RESTS:    break;
    }
    if (d->v.t.sender.ack.state == LOFT_STATE_FAULT)
        return "fault";
    return !d->others ? "idle" : d->v.t.sender.ack.state == LOFT_STATE_HELD ? "held" : "busy";
}

static void put_place(FILE *out, const double at[ENGINE_AXES])
{
    fprintf(out, ",\"at\":[%.4f,%.4f,%.4f]", at[0], at[1], at[2]);
}

static void set_machine(serve *s)
{
    const desk *d        = &s->d;
    const machine_file *m = &d->v.p.machine;
    const bool known     = d->state >= DESK_RESTS;
    const uint16_t closed = known ? d->v.t.sender.closed & LOFT_INPUT_ENDING : 0;
    double least, most;
    char text[256];
    writing w;

    begin_text(&w);
    put_pair(w.out, "{", "state", machine_word(s));
    put_pair(w.out, ",", "port", s->o.line.port);
    if (known && d->state != DESK_DRAWS)
        put_place(w.out, d->v.at);
    put_pair(w.out, ",", "closed", closed ? talk_inputs(closed, text) : NULL);
    fprintf(w.out, ",\"doubt\":%s,\"pen\":[%.4f,%.4f],\"table\":[",
            known && d->v.t.sender.ack.flags & LOFT_FLAG_LOST ? "true" : "false", m->pen_up,
            m->pen_down);
    for (int i = 0; i < ENGINE_AXES; i++) {
        table_ends(m, i, &least, &most);
        fprintf(w.out, most < HUGE_VAL ? "%s[%.3f,%.3f]" : "%snull", i ? "," : "", least, most);
    }
    fputs("]}", w.out);
    set(s, PART_MACHINE, end_text(&w));
}

static void set_drawing(serve *s)
{
    writing w;

    begin_text(&w);
    put_pair(w.out, "{", "name", s->kept.file[0] ? s->kept.name : NULL);
    fprintf(w.out, ",\"options\":%s}", s->kept.given);
    set(s, PART_DRAWING, end_text(&w));
}

static void set_plan(serve *s)
{
    const char *word = s->kept.file[0] == '\0' ? "none"
                       : s->v.child > 0        ? "plans"
                       : s->failed             ? "failed"
                                               : "ready";

    set(s, PART_PLAN,
        text_of("{\"state\":\"%s\",\"number\":%u,\"part\":%.2f,\"facts\":%s,\"messages\":[%s]}",
                word, s->plans, s->planned, s->plan ? s->plan : "null",
                s->warnings ? s->warnings : ""));
}

/* The state of a job that runs, with the names of `loft stream --json`. */
static void put_job(serve *s, FILE *out)
{
    desk *d                  = &s->d;
    const machine_tool *tool = d->parts.count > 0 ? d->parts.part[d->part].tool : NULL;
    char words[160];
    send_facts f;

    put_pair(out, ",", "tool", tool ? tool->name : NULL);
    if (d->state == DESK_CHANGES)
        put_pair(out, ",", "pause", tool ? tool->pause : "");
    if (d->state != DESK_DRAWS || !d->busy || d->r.j == NULL || !stream_facts(&d->r, &f, words)) {
        put_pair(out, ",", "state", d->state == DESK_CHANGES ? "pause" : "begins");
        return;
    }
    const double hz   = d->w.j.tick_hz;
    const bool draws  = f.moves < d->w.path.count && d->w.path.curve[f.moves] != TOOLPATH_TRAVEL;
    const double left = (f.total - f.done) / hz * 100 / fmax(f.override, 1);
    put_pair(out, ",", "state", f.state);
    if (d->r.pause != NULL)
        put_pair(out, ",", "pause", d->r.pause);
    fprintf(out,
            ",\"id\":\"%08x\",\"pen\":\"%s\",\"item\":%u,\"items\":%u,\"part\":%.4f,\"left\":%.1f,"
            "\"queued\":%u,\"feed\":%.2f,\"override\":%u,\"parts\":[%zu,%zu],\"moves\":%zu",
            (unsigned)d->w.j.head.id, draws ? "down" : "up", f.item, f.items,
            f.total > 0 ? fmin(f.done / f.total, 1) : 1, left, f.queued, f.feed, f.override,
            d->part, d->parts.count, f.moves);
    put_place(out, f.at);
}

static void set_job(serve *s)
{
    writing w;

    begin_text(&w);
    put_pair(w.out, "{", "file", s->job ? s->kept.name : NULL);
    if (s->drawing) {
        put_job(s, w.out);
    } else {
        put_pair(w.out, ",", "state", s->job ? "over" : "none");
        fprintf(w.out, ",\"code\":%d", s->code);
        put_pair(w.out, ",", "result", s->result);
    }
    putc('}', w.out);
    set(s, PART_JOB, end_text(&w));
}


// What is told by what is below
// -----------------------------

static void take_message(void *context, const host_message *m)
{
    serve *s = context;
    char what[600], remedy[300];
    host_message plain = *m;
    writing w;

    store_plain(&s->kept, m->what, what, sizeof what);
    store_plain(&s->kept, m->remedy ? m->remedy : "", remedy, sizeof remedy);
    if (s->hears && m->code != EX_OK) {
        snprintf(s->name, sizeof s->name, "%s", m->name);
        snprintf(s->failure, sizeof s->failure, "%s", what);
        snprintf(s->remedy, sizeof s->remedy, "%s", remedy);
        return;
    }
    plain.what   = what;
    plain.remedy = m->remedy ? remedy : NULL;
    begin_text(&w);
    fprintf(w.out, "{\"n\":%u,\"message\":", s->lines);
    host_put_json(w.out, &plain);
    putc('}', w.out);
    if (m->code != EX_OK)
        snprintf(s->result, sizeof s->result, "%.290s", what);
    add_line(s, end_text(&w));
}

static void take_teller(void *context, enum send_line what, const char *line)
{
    serve *s = context;
    char plain[600];
    writing w;

    store_plain(&s->kept, line, plain, sizeof plain);
    if (what == SEND_RESULT && s->result[0] == '\0')
        snprintf(s->result, sizeof s->result, "%.290s", plain);
    begin_text(&w);
    fprintf(w.out, "{\"n\":%u", s->lines);
    put_pair(w.out, ",", "text", plain);
    putc('}', w.out);
    add_line(s, end_text(&w));
}

static bool take_progress(void *context, const host_progress *p)
{
    serve *s = context;

    if (p->doing == NULL || s->o.meanwhile == NULL)
        return !s->stops;
    s->blocked = true;
    s->o.meanwhile(s->o.context);
    s->blocked = false;
    return !s->stops;
}

static double clock_of(void *context)
{
    (void)context;
    return tool_clock();
}


// The plan
// --------

static void forget_plan(serve *s)
{
    free(s->plan);
    free(s->moves);
    free(s->warnings);
    s->plan = s->moves = s->warnings = NULL;
    s->failed                        = false;
    s->planned                       = 0;
}

static void plan_again(serve *s)
{
    preview_end(&s->v);
    forget_plan(s);
    s->plans++;
    s->greeted = s->d.greeted;
    if (s->kept.file[0] != '\0' &&
        !preview_begin(&s->v, s->o.beside, &s->d, &s->kept.how, s->kept.file))
        s->failed = true;
    set_plan(s);
}

static char *copy(const char *text) { return strcpy(memory_grow(NULL, strlen(text) + 1), text); }

static void add_warning(serve *s, struct json_object *line)
{
    struct json_object *m;
    char *before = s->warnings;

    if (!json_object_object_get_ex(line, "message", &m))
        return;
    const char *text = json_object_to_json_string_ext(m, JSON_C_TO_STRING_PLAIN);
    const size_t size = strlen(text) + (before ? strlen(before) : 0);
    if (size > 65536)
        return;
    char *plain = memory_grow(NULL, strlen(text) + 1);
    store_plain(&s->kept, text, plain, strlen(text) + 1);
    s->warnings = text_of("%s%s%s", before ? before : "", before ? "," : "", plain);
    free(plain);
    free(before);
}

static void take_plan_line(serve *s, const char *text)
{
    static const char moves[] = "{\"kind\":\"moves\",";
    struct json_object *line, *value;

    if (strncmp(text, moves, sizeof moves - 1) == 0) {
        free(s->moves);
        s->moves = text_of("{%s", text + sizeof moves - 1);
        return;
    }
    line = json_tokener_parse(text);
    if (line == NULL || !json_object_object_get_ex(line, "kind", &value)) {
        json_object_put(line);
        return;
    }
    const char *kind = json_object_get_string(value);
    if (strcmp(kind, "message") == 0)
        add_warning(s, line);
    else if (strcmp(kind, "plan") == 0) {
        free(s->plan);
        s->plan = copy(text);
    } else if (strcmp(kind, "progress") == 0 && json_object_object_get_ex(line, "part", &value))
        s->planned = json_object_get_double(value);
    else if (strcmp(kind, "failed") == 0)
        s->failed = true;
    json_object_put(line);
}

static void watch_plan(serve *s, task_wants *w)
{
    const char *text;

    if (s->v.child == 0)
        return;
    while ((text = preview_line(&s->v)) != NULL)
        take_plan_line(s, text);
    if (s->v.child == 0 && s->moves == NULL)
        s->failed = true;
    if (s->v.child > 0)
        task_wake(w, s->now + OFTEN / 2);
    set_plan(s);
}


// Answers
// -------

typedef struct {
    serve *s;
    int from;                   /* the page */
    char *id;                   /* as it was written; NULL: no answer is wanted */
} asking;

static void answer(const asking *a, char *result)
{
    if (a->id != NULL)
        client_put(&a->s->client[a->from],
                   text_of("{\"jsonrpc\":\"2.0\",\"id\":%s,\"result\":%s}", a->id, result));
    free(result);
}

static void refuse(const asking *a, int code, const char *name, const char *what,
                   const char *remedy)
{
    writing w;

    begin_text(&w);
    fprintf(w.out, "{\"jsonrpc\":\"2.0\",\"id\":%s,\"error\":{\"code\":%d", a->id ? a->id : "null",
            code);
    put_pair(w.out, ",", "message", what);
    put_pair(w.out, ",\"data\":{", "name", name);
    put_pair(w.out, ",", "remedy", remedy);
    fputs("}}}", w.out);
    client_put(&a->s->client[a->from], end_text(&w));
}

/* The codes of JSON-RPC, and ours. */
enum {
    NOT_JSON = -32700,
    NOT_A_REQUEST = -32600,
    NO_METHOD = -32601,
    BAD_PARAMS = -32602,
    NOT_YOURS = 1,
    NOT_NOW = 2,
    FAILED = 3
};

/* What a call below has told becomes the answer. */
static void answer_code(const asking *a, int code)
{
    if (code == 0)
        answer(a, copy("{}"));
    else
        refuse(a, FAILED, a->s->name, a->s->failure, a->s->remedy);
}


// What can be asked
// -----------------

/* The parameters of all methods. */
typedef struct {
    unsigned protocol, upload, percent;
    const char *token, *axes, *given;
    double x, y, z, at, feed, size;
    int way, pen;
    bool by;
} params;

#define FEED { "feed", OPTION_NUMBER(params, feed), .least = 0.016, .most = 1000, .unit = "mm/s", \
               .standard = "50" }
#define PLACE(k) { #k, OPTION_NUMBER(params, k), .least = -16383, .most = 16383, .unit = "mm", \
                   .unset = (double)NAN }
#define WAY(none) { "way", OPTION_CHOICE(params, way), .choices = "x+|x-|y+|y-|z+|z-", \
                    .unset = none }

static const option none_rows[] = { { 0 } };
static const option hello_rows[] = { { "protocol", OPTION_INTEGER(params, protocol), .least = 0,
                                       .most = 65535, .standard = "0" },
    { "token", OPTION_TEXT(params, token), .value = "TOKEN" },
                                     { 0 } };
static const option upload_rows[] = {
    { "upload", OPTION_INTEGER(params, upload), .least = 0, .most = STORE_UPLOADS - 1 }, { 0 }
};
static const option percent_rows[] = { { "percent", OPTION_INTEGER(params, percent), .least = 10,
                                         .most = 200, .standard = "100" },
                                       { 0 } };
static const option axes_rows[] = { { "axes", OPTION_TEXT(params, axes),
                                      .choices = "x|y|z|xy|xz|yz|xyz" },
                                    { "at", OPTION_NUMBER(params, at), .least = -16383,
                                      .most = 16383, .unit = "mm", .standard = "0" },
                                    { 0 } };
static const option unlock_rows[] = { WAY(-1), { 0 } };
static const option jog_rows[] = { WAY(0),
                                   FEED,
                                   { "size", OPTION_NUMBER(params, size), .least = 0, .most = 1000,
                                     .unit = "mm", .standard = "0" },
                                   { 0 } };
static const option go_rows[] = { PLACE(x), PLACE(y),
                                  PLACE(z), { "by", OPTION_FLAG(params, by), .help = "" },
                                  FEED,     { 0 } };
static const option pen_rows[] = { { "pen", OPTION_CHOICE(params, pen), .choices = "up|down" },
                                   FEED,
                                   { 0 } };
static const option feed_rows[] = { FEED, { 0 } };

static void put_state(const serve *s, FILE *out, uint64_t since)
{
    const char *between = "";

    putc('{', out);
    for (int k = 0; k < PARTS; k++)
        if (s->part[k].seq > since) {
            fprintf(out, "%s\"%s\":%s", between, part_names[k], s->part[k].text);
            between = ",";
        }
    putc('}', out);
}

static void do_hello(const asking *a, const params *p)
{
    serve *s  = a->s;
    client *c = &s->client[a->from];
    writing w;

    if (p->protocol != SERVE_PROTOCOL) {
        refuse(a, BAD_PARAMS, "serve.protocol", "this page is of another release", "reload it");
        return;
    }
    if (!serve_knows(s, p->token)) {
        refuse(a, NOT_YOURS, "serve.token", "open the address that `loft serve` printed",
               "it has a token behind #");
        c->late = true;
        return;
    }
    c->greeted = true;
    if (s->holder == NOBODY)
        s->holder = a->from;
    set_control(s);
    begin_text(&w);
    fprintf(w.out, "{\"protocol\":%d,\"version\":\"%s\",\"you\":%d,\"seq\":%llu,\"state\":",
            SERVE_PROTOCOL, tool_version, a->from, (unsigned long long)s->seq);
    put_state(s, w.out, 0);
    fputs(",\"options\":[", w.out);
    option_put_json(w.out, planning_rows, false);
    fputs("]}", w.out);
    c->seq = s->seq;
    answer(a, end_text(&w));
}

static void do_ping(const asking *a, const params *p)
{
    (void)p;
    answer(a, copy("{}"));
}

static void do_take(const asking *a, const params *p)
{
    (void)p;
    desk_jog_off(&a->s->d);
    a->s->holder = a->from;
    set_control(a->s);
    answer(a, copy("{}"));
}

/* A drawing that is drawn stays. */
static bool is_drawn(const asking *a)
{
    if (a->s->drawing)
        refuse(a, NOT_NOW, "serve.busy", "the job of this drawing is not over",
               "wait, or abort it");
    return a->s->drawing;
}

/* The drawing is another one: the number of its plan is the answer. */
static void answer_plan(const asking *a)
{
    set_drawing(a->s);
    plan_again(a->s);
    answer(a, text_of("{\"plan\":%u}", a->s->plans));
}

static void do_open(const asking *a, const params *p)
{
    serve *s = a->s;

    if (is_drawn(a))
        return;
    const int code = store_take(&s->kept, (int)p->upload);
    if (code == 0)
        answer_plan(a);
    else
        answer_code(a, code);
}

static void do_close(const asking *a, const params *p)
{
    (void)p;
    if (is_drawn(a))
        return;
    store_drop(&a->s->kept);
    answer_plan(a);
}

static void do_options(const asking *a, const params *p)
{
    option_fault fault;

    if (is_drawn(a))
        return;
    if (store_options(&a->s->kept, p->given, &fault) != 0) {
        refuse(a, BAD_PARAMS, fault.name, fault.text, NULL);
        return;
    }
    store_keep(&a->s->kept);
    answer_plan(a);
}

static void do_moves(const asking *a, const params *p)
{
    serve *s = a->s;

    (void)p;
    if (s->moves == NULL)
        refuse(a, NOT_NOW, "serve.no-plan", "there is no plan yet", "wait for it");
    else
        answer(a, text_of("{\"number\":%u,\"plan\":%s}", s->plans, s->moves));
}

static void ask_desk(const asking *a, const desk_wish *wish)
{
    serve *s = a->s;

    answer_code(a, desk_ask(&s->d, wish, s->now));
    s->looked = 0;
}

static void do_start(const asking *a, const params *p)
{
    serve *s = a->s;

    (void)p;
    if (s->kept.file[0] == '\0') {
        refuse(a, NOT_NOW, "serve.no-drawing", "there is no drawing", "choose one");
        return;
    }
    const desk_wish wish = { .verb = DESK_DRAW, .how = &s->kept.how, .file = s->kept.file };
    const int code       = desk_ask(&s->d, &wish, s->now);
    if (code == 0) {
        s->job = s->drawing = true;
        s->result[0]        = '\0';
        s->stops            = false;
        set_job(s);
    }
    answer_code(a, code);
}

static void do_hold(const asking *a, const params *p)
{
    (void)p;
    desk_hold(&a->s->d);
    answer(a, copy("{}"));
}

static void do_resume(const asking *a, const params *p)
{
    (void)p;
    desk_resume(&a->s->d);
    answer(a, copy("{}"));
}

static void do_abort(const asking *a, const params *p)
{
    (void)p;
    a->s->stops = a->s->blocked;
    desk_abort(&a->s->d);
    answer(a, copy("{}"));
}

static void do_override(const asking *a, const params *p)
{
    desk_override(&a->s->d, p->percent);
    answer(a, copy("{}"));
}

static void do_connect(const asking *a, const params *p)
{
    (void)p;
    answer_code(a, desk_connect(&a->s->d, a->s->now));
}

static void do_disconnect(const asking *a, const params *p)
{
    (void)p;
    if (is_drawn(a))
        return;
    desk_disconnect(&a->s->d);
    answer(a, copy("{}"));
}

static void take_axes(const params *p, desk_wish *wish)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        wish->axis[i] = p->axes != NULL && strchr(p->axes, "xyz"[i]) != NULL;
}

static void do_home(const asking *a, const params *p)
{
    desk_wish wish = { .verb = DESK_HOME };

    take_axes(p, &wish);
    ask_desk(a, &wish);
}

static void do_zero(const asking *a, const params *p)
{
    desk_wish wish = { .verb = DESK_ZERO, .to = { p->at, p->at, p->at } };

    take_axes(p, &wish);
    ask_desk(a, &wish);
}

static int way_of(int word) { return word < 0 ? 0 : (word % 2 ? -1 : 1) * (word / 2 + 1); }

static void do_unlock(const asking *a, const params *p)
{
    ask_desk(a, &(desk_wish){ .verb = DESK_UNLOCK, .way = way_of(p->way) });
}

static void do_jog(const asking *a, const params *p)
{
    ask_desk(a, &(desk_wish){
                    .verb = DESK_JOG, .way = way_of(p->way), .size = p->size, .feed = p->feed });
}

static void do_jog_on(const asking *a, const params *p)
{
    (void)p;
    desk_jog_on(&a->s->d, a->s->now);
    answer(a, copy("{}"));
}

static void do_jog_off(const asking *a, const params *p)
{
    (void)p;
    desk_jog_off(&a->s->d);
    answer(a, copy("{}"));
}

static void do_go(const asking *a, const params *p)
{
    ask_desk(a, &(desk_wish){
                    .verb = DESK_GO, .to = { p->x, p->y, p->z }, .by = p->by, .feed = p->feed });
}

static void do_pen(const asking *a, const params *p)
{
    ask_desk(a, &(desk_wish){ .verb = DESK_PEN, .up = p->pen == 0, .feed = p->feed });
}

static void do_park(const asking *a, const params *p)
{
    ask_desk(a, &(desk_wish){ .verb = DESK_PARK, .feed = p->feed });
}

/* Who may ask it. */
enum {
    VERB_FIRST = 1,
    VERB_ANYONE = 2,
    VERB_ALWAYS = 4
}; /* before hello; without control;
                                                                 * in work that takes long, too */
typedef struct {
    const char *name;
    void (*call)(const asking *a, const params *p);
    const option *rows;         /* NULL: `given` is the text of the parameters */
    unsigned flags;
} verb;

#define VERB(on, what, call, rows, flags) { #on "." what, call, rows, flags }
static const verb verbs[] = {
    { "hello", do_hello, hello_rows, VERB_FIRST | VERB_ANYONE | VERB_ALWAYS },
    { "ping", do_ping, none_rows, VERB_ANYONE | VERB_ALWAYS },
    VERB(control, "take", do_take, none_rows, VERB_ANYONE),
    VERB(drawing, "open", do_open, upload_rows, 0),
    VERB(drawing, "close", do_close, none_rows, 0),
    VERB(drawing, "options", do_options, NULL, 0),
    VERB(plan, "moves", do_moves, none_rows, VERB_ANYONE),
    VERB(job, "start", do_start, none_rows, 0),
    VERB(job, "hold", do_hold, none_rows, VERB_ANYONE | VERB_ALWAYS),
    VERB(job, "resume", do_resume, none_rows, 0),
    VERB(job, "abort", do_abort, none_rows, VERB_ALWAYS),
    VERB(job, "override", do_override, percent_rows, 0),
    VERB(machine, "connect", do_connect, none_rows, 0),
    VERB(machine, "disconnect", do_disconnect, none_rows, 0),
    VERB(machine, "home", do_home, axes_rows, 0),
    VERB(machine, "unlock", do_unlock, unlock_rows, 0),
    VERB(machine, "zero", do_zero, axes_rows, 0),
    VERB(machine, "go", do_go, go_rows, 0),
    VERB(machine, "pen", do_pen, pen_rows, 0),
    VERB(machine, "park", do_park, feed_rows, 0),
    VERB(machine, "jog", do_jog, jog_rows, 0),
    VERB(machine, "jog-on", do_jog_on, none_rows, VERB_ALWAYS),
    VERB(machine, "jog-off", do_jog_off, none_rows, VERB_ANYONE | VERB_ALWAYS),
};

static const verb *verb_of(const char *name)
{
    for (size_t i = 0; i < sizeof verbs / sizeof verbs[0]; i++)
        if (strcmp(verbs[i].name, name) == 0)
            return &verbs[i];
    return NULL;
}

/* Read the parameters by the table of the method, and call it. */
static void call(const asking *a, const verb *v, struct json_object *given)
{
    const char *text = given ? json_object_to_json_string_ext(given, JSON_C_TO_STRING_PLAIN) : "{}";
    const char *word[OPTION_JSON_WORDS];
    params p = { .given = text };
    option_fault fault;
    char *own = copy(text);

    if (v->rows != NULL && options_read_json(v->rows, own, word, &p, &fault) != 0)
        refuse(a, BAD_PARAMS, fault.name, fault.text, NULL);
    else
        v->call(a, &p);
    free(own);
}

static bool may(const asking *a, const verb *v)
{
    serve *s = a->s;

    if (s->blocked && !(v->flags & VERB_ALWAYS)) {
        refuse(a, NOT_NOW, "serve.busy", "the drawing is read", "wait, or abort it");
        return false;
    }
    if (v->flags & VERB_ANYONE || s->holder == a->from)
        return true;
    if (s->holder == NOBODY) {
        s->holder = a->from;
        set_control(s);
        return true;
    }
    refuse(a, NOT_YOURS, "serve.not-yours", "another page controls the machine", "take it over");
    return false;
}

static bool obey(asking *a, struct json_object *request)
{
    struct json_object *version, *method, *given = NULL, *id = NULL;
    const client *c = &a->s->client[a->from];

    if (json_object_object_get_ex(request, "id", &id))
        a->id = copy(json_object_to_json_string_ext(id, JSON_C_TO_STRING_PLAIN));
    if (!json_object_object_get_ex(request, "jsonrpc", &version) ||
        !json_object_is_type(version, json_type_string) ||
        strcmp(json_object_get_string(version), "2.0") != 0 ||
        !json_object_object_get_ex(request, "method", &method) ||
        !json_object_is_type(method, json_type_string)) {
        refuse(a, NOT_A_REQUEST, "serve.request", "this is no request",
               "give jsonrpc 2.0 and a method");
        return c->greeted;
    }
    const verb *v = verb_of(json_object_get_string(method));
    if (!c->greeted && (v == NULL || !(v->flags & VERB_FIRST))) {
        refuse(a, NOT_A_REQUEST, "serve.hello", "nobody has come in", "say hello first");
        return false;
    }
    if (json_object_object_get_ex(request, "params", &given) &&
        !json_object_is_type(given, json_type_object))
        refuse(a, BAD_PARAMS, "serve.params", "the parameters are no object", "give them by name");
    else if (v == NULL)
        refuse(a, NO_METHOD, "serve.method", "there is no such method", "reload the page");
    else if (may(a, v))
        call(a, v, given);
    return true;
}

bool serve_hear(serve *s, int client_number, const char *text, size_t size, double now)
{
    asking a                    = { .s = s, .from = client_number };
    struct json_tokener *reader = json_tokener_new_ex(DEPTH);
    const bool fits             = size <= SERVE_TEXT && memchr(text, '\0', size) == NULL;
    bool stays                  = s->client[client_number].greeted;

    s->now = now;
    json_tokener_set_flags(reader, JSON_TOKENER_STRICT | JSON_TOKENER_VALIDATE_UTF8);
    struct json_object *request = fits ? json_tokener_parse_ex(reader, text, (int)size) : NULL;
    if (request == NULL || json_tokener_get_error(reader) != json_tokener_success) {
        refuse(&a, NOT_JSON, "serve.json", "this is no JSON", "give one object");
    } else if (!json_object_is_type(request, json_type_object)) {
        refuse(&a, NOT_A_REQUEST, "serve.request", "this is no request", "give one object");
    } else {
        s->hears = true;
        stays    = obey(&a, request);
        s->hears = false;
    }
    json_object_put(request);
    json_tokener_free(reader);
    free(a.id);
    return stays && !s->client[client_number].late;
}

bool serve_speaks(const serve *s, int client_number, double now)
{
    const client *c = &s->client[client_number];

    return c->count > 0 || (c->greeted && c->seq < s->seq && now - c->told >= OFTEN);
}

const char *serve_says(serve *s, int client_number, double now, size_t *size)
{
    client *c        = &s->client[client_number];
    const char *text = client_take(c);

    if (text == NULL && serve_speaks(s, client_number, now)) {
        writing w;
        begin_text(&w);
        fprintf(w.out,
                "{\"jsonrpc\":\"2.0\",\"method\":\"state\",\"params\":{\"seq\":%llu,"
                "\"changed\":",
                (unsigned long long)s->seq);
        put_state(s, w.out, c->seq);
        fputs("}}", w.out);
        c->seq  = s->seq;
        c->told = now;
        client_say(c, end_text(&w));
        text = c->said;
    }
    *size = text ? strlen(text) : 0;
    return text;
}

bool serve_is_late(const serve *s, int client_number) { return s->client[client_number].late; }


// Pages
// -----

int serve_join(serve *s)
{
    for (int i = 0; i < SERVE_CLIENTS; i++)
        if (!s->client[i].here) {
            s->client[i] = (client){ .here = true, .told = -1 };
            return i;
        }
    return -1;
}

void serve_leave(serve *s, int client_number)
{
    client_free(&s->client[client_number]);
    if (s->holder == client_number) {
        s->holder = NOBODY;
        desk_jog_off(&s->d);
    }
    set_control(s);
}

bool serve_knows(const serve *s, const char *token)
{
    const char *known = s->o.token;
    unsigned char differs = 0;

    if (known == NULL)
        return true;
    if (token == NULL || strlen(token) != strlen(known))
        return false;
    for (size_t i = 0; known[i] != '\0'; i++)       /* as long for each wrong one */
        differs |= (unsigned char)(known[i] ^ token[i]);
    return differs == 0;
}

int serve_upload_begin(serve *s, const char *name) { return store_upload(&s->kept, name); }

bool serve_upload_more(serve *s, int upload, const void *bytes, size_t count)
{
    return store_more(&s->kept, upload, bytes, count);
}

bool serve_upload_end(serve *s, int upload, bool whole)
{
    return store_whole(&s->kept, upload, whole);
}


// All of it
// ---------

serve *serve_open(host *h, const serve_options *o, double now)
{
    serve *s = memory_grow(NULL, sizeof *s);

    memset(s, 0, sizeof *s);
    s->host   = h;
    s->o      = *o;
    s->now    = now;
    s->holder = NOBODY;
    s->v      = (preview){ .fd = -1 };
    const send_teller to = { .tell = take_teller, .context = s, .shown = true };
    desk_begin(&s->d, h, &o->line, o->machine, &to);
    store_begin(&s->kept, h, o->folder, o->machine, SERVE_UPLOAD);
    h->message  = take_message;
    h->progress = take_progress;
    h->now      = clock_of;
    h->context  = s;
    set_lines(s);
    set_control(s);
    set_drawing(s);
    set_job(s);
    if (o->line.port != NULL)
        (void)desk_connect(&s->d, now);
    set_machine(s);
    plan_again(s);
    return s;
}

void serve_close(serve *s)
{
    preview_end(&s->v);
    desk_end(&s->d);
    store_end(&s->kept);
    forget_plan(s);
    for (int i = 0; i < SERVE_CLIENTS; i++)
        client_free(&s->client[i]);
    for (int k = 0; k < PARTS; k++)
        free(s->part[k].text);
    for (int k = 0; k < LINES; k++)
        free(s->line[k]);
    s->host->message  = NULL;
    s->host->progress = NULL;
    free(s);
}

bool serve_stop(serve *s) { return desk_stop(&s->d); }

void serve_step(serve *s, double now, task_wants *w)
{
    s->now = now;
    *w     = (task_wants){ .in = -1, .out = -1, .until = HUGE_VAL };
    desk_step(&s->d, now, w);
    if (s->drawing && s->d.code != TASK_GOES && !s->d.wished &&
        (s->d.state == DESK_RESTS || s->d.state == DESK_ALONE)) {
        s->drawing = false;
        s->code    = s->d.code;
        s->looked  = 0;
    }
    if (s->greeted != s->d.greeted && !s->drawing)
        plan_again(s);
    watch_plan(s, w);
    for (int i = 0; i < SERVE_CLIENTS; i++)     /* who is told later; the others can be now */
        if (s->client[i].greeted && s->client[i].seq < s->seq && s->client[i].told + OFTEN > now)
            task_wake(w, s->client[i].told + OFTEN);
    if (now - s->looked < OFTEN) {
        task_wake(w, s->looked + OFTEN);
        return;
    }
    s->looked = now;
    set_machine(s);
    set_job(s);
    task_wake(w, s->drawing || s->d.state == DESK_MOVES ? now + OFTEN : HUGE_VAL);
}

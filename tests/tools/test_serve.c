/* tests/tools/test_serve.c -- the messages of `loft serve`, without a browser and without a socket,
 * beside a machine in simulated time
 * SPDX-License-Identifier: MIT
 */
#include <fcntl.h>
#include <json-c/json.h>
#include <poll.h>
#include <unistd.h>

#include "serve/messages.h"
#include "support/heard.h"
#include "tools/simulated.h"

#define LONG 100.0              /* s: longer than each job */

static serve *s;
static host own;
static char folder[64];
static int planned = -1;        /* what the other process writes */
static int page;                /* that asks */
static struct json_object *state[SERVE_CLIENTS];    /* as each page knows it */
static struct json_object *answer;                  /* the last one */
static int last_code;           /* of its error; 0: none */


// The server
// ----------

static pid_t beside(void (*work)(void *given, FILE *out), void *given, int *fd)
{
    int ends[2];

    CHECK(pipe(ends) == 0);
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        FILE *out = fdopen(ends[1], "w");
        work(given, out);
        fclose(out);
        _exit(0);
    }
    close(ends[1]);
    (void)fcntl(ends[0], F_SETFL, O_NONBLOCK);
    *fd = planned = ends[0];
    return child;
}

static void open_server(const char *token)
{
    const serve_options o = { .line   = { .port = "sim", .baud = 115200, .wait = 5 },
                              .folder = folder,
                              .token  = token,
                              .beside = beside };

    s = serve_open(&own, &o, sim.clock);
}

static void begin_with(const char *token)
{
    struct loft_host_options o = loft_host_defaults();

    o.slots = 4;
    for (int i = 0; i < LOFT_AXES; i++)
        o.steps_per_mm[i] = 7;
    simulated_begin(&o);
    strcpy(folder, "/tmp/loft-serve-XXXXXX");
    CHECK(mkdtemp(folder) != NULL);
    tool_use(&own);             /* of rooms that take none */
    open_server(token);
}

static void close_server(void)
{
    serve_close(s);
    for (int i = 0; i < SERVE_CLIENTS; i++) {
        json_object_put(state[i]);
        state[i] = NULL;
    }
    json_object_put(answer);
    answer = NULL;
}

static void end(void)
{
    char command[100];

    close_server();
    snprintf(command, sizeof command, "rm -r %s", folder);
    CHECK(system(command) == 0);
}


// Pages
// -----

static struct json_object *at(struct json_object *o, const char *key)
{
    struct json_object *value = NULL;

    return o != NULL && json_object_object_get_ex(o, key, &value) ? value : NULL;
}

static void merge(int client, struct json_object *changed)
{
    if (state[client] == NULL)
        state[client] = json_object_new_object();
    json_object_object_foreach(changed, key, value)
        json_object_object_add(state[client], key, json_object_get(value));
}

/* All texts for a page. */
static void take_texts(int client)
{
    const char *text;
    size_t size;

    while ((text = serve_says(s, client, sim.clock, &size)) != NULL) {
        struct json_object *said = json_tokener_parse(text);
        CHECK(said != NULL && strlen(text) == size);
        struct json_object *params = at(said, "params");
        if (params != NULL) {
            merge(client, at(params, "changed"));
            json_object_put(said);
            continue;
        }
        json_object_put(answer);
        answer    = said;
        last_code = at(said, "error") ? json_object_get_int(at(at(said, "error"), "code")) : 0;
        if (at(at(said, "result"), "state") != NULL)
            merge(client, at(at(said, "result"), "state"));
    }
}

/* Ask, and take the answer. Returns the code of its error. */
static int ask(const char *method, const char *params)
{
    char text[1000];

    snprintf(text, sizeof text, "{\"jsonrpc\":\"2.0\",\"id\":7,\"method\":\"%s\",\"params\":%s}",
             method, params);
    (void)serve_hear(s, page, text, strlen(text), sim.clock);
    last_code = -1;
    take_texts(page);
    return last_code;
}

static int join(void)
{
    page = serve_join(s);
    CHECK(page >= 0 && ask("hello", "{\"protocol\":1}") == 0);
    return page;
}

static const char *word(const char *part, const char *key)
{
    const char *text = json_object_get_string(at(at(state[page], part), key));

    return text ? text : "";
}

static bool says(const char *part, const char *key, const char *text)
{
    return strcmp(word(part, key), text) == 0;
}

static int step_server(void *context, double now, task_wants *w)
{
    (void)context;
    serve_step(s, now, w);
    return TASK_GOES;
}

static void step(void)
{
    static bool stop;
    const task t = { step_server, NULL, &stop };
    task_wants w;

    (void)simulated_step(&t, &w);
    if (w.until > sim.clock + 0.02)
        w.until = sim.clock + 0.02;
    simulated_wait(&w);
    take_texts(page);
}

/* Step until a part of the state says this. */
static bool until(const char *part, const char *key, const char *text)
{
    const double most = sim.clock + LONG;

    while (!says(part, key, text) && sim.clock < most) {
        struct pollfd p = { .fd = planned, .events = POLLIN };
        if (strcmp(part, "plan") == 0)
            (void)poll(&p, 1, 20);
        step();
    }
    if (!says(part, key, text))
        fprintf(stderr, "%s.%s is no %s: %s\n", part, key, text,
                json_object_to_json_string(at(state[page], part)));
    return says(part, key, text);
}

static void pass(double seconds)
{
    for (const double most = sim.clock + seconds; sim.clock < most;)
        step();
}

static double end_x, end_y;     /* of the drawing */

/* Lines there and back, planned. */
static void give_drawing(arb *a, int count)
{
    char line[200], text[40];

    const int upload = serve_upload_begin(s, "../a <b>.csv");
    for (int n = 0; n < count; n++) {
        const double x = end_x, y = end_y;
        end_x = 5 + arb_below(a, 40);
        end_y = 5 + arb_below(a, 40);
        const int size = snprintf(line, sizeof line, "%g,%g,%g,%g,%g,%g,%g,%g\n", x, y,
                                  x + (end_x - x) / 3, y + (end_y - y) / 3, x + 2 * (end_x - x) / 3,
                                  y + 2 * (end_y - y) / 3, end_x, end_y);
        CHECK(serve_upload_more(s, upload, line, (size_t)size));
    }
    CHECK(serve_upload_end(s, upload, true));
    snprintf(text, sizeof text, "{\"upload\":%d}", upload);
    CHECK(ask("drawing.open", text) == 0);
    CHECK(until("plan", "state", "ready") && until("machine", "state", "idle"));
    CHECK(until("plan", "state", "ready"));
}

static bool is_drawn(void)
{
    const double step_x = 0.5 / sim.options.steps_per_mm[0] + 1e-9;

    return fabs(sim.world.at[0] - end_x) <= step_x && fabs(sim.world.at[1] - end_y) <= step_x;
}

static void begin(void)
{
    end_x = end_y = 10;
    begin_with(NULL);
    (void)join();
}


// Properties
// ----------

static void a_drawing_is_planned_and_drawn(arb *a)
{
    begin();
    give_drawing(a, 2 + (int)arb_below(a, 8));
    CHECK(says("drawing", "name", "_a _b_.csv") || strstr(word("drawing", "name"), "b_.csv"));
    CHECK(ask("plan.moves", "{}") == 0);
    struct json_object *moves = at(at(at(answer, "result"), "plan"), "moves");
    CHECK(json_object_array_length(moves) >= 2);
    CHECK(ask("job.start", "{}") == 0 && until("job", "state", "draws"));
    CHECK(ask("job.start", "{}") != 0);
    CHECK(until("job", "state", "over") && says("job", "code", "0") && is_drawn());
    CHECK(strstr(word("job", "result"), "as commanded") != NULL);
    end();
}

static void a_hold_stops_it_and_it_goes_on(arb *a)
{
    begin();
    give_drawing(a, 12);
    CHECK(ask("job.start", "{}") == 0 && until("job", "state", "draws"));
    pass(0.2 + 0.001 * arb_below(a, 500));
    CHECK(ask("job.hold", "{}") == 0);
    const double asked = sim.clock;
    while (!sim.machine.drive.hold && sim.clock < asked + 0.05)
        step();
    CHECK(sim.machine.drive.hold && until("job", "state", "held"));
    pass(1);
    const double at_x = sim.world.at[0];
    pass(1);
    CHECK(fabs(sim.world.at[0] - at_x) < 1e-9);
    CHECK(ask("job.override", "{\"percent\":150}") == 0);
    CHECK(ask("job.resume", "{}") == 0 && until("job", "state", "draws"));
    CHECK(until("job", "override", "150"));
    CHECK(until("job", "state", "over") && says("job", "code", "0") && is_drawn());
    end();
}

static void an_abort_ends_it(arb *a)
{
    begin();
    give_drawing(a, 12);
    CHECK(ask("job.start", "{}") == 0 && until("job", "state", "draws"));
    pass(0.001 * arb_below(a, 1000));
    CHECK(ask("job.abort", "{}") == 0 && until("job", "state", "over"));
    CHECK(says("job", "code", "75") && strstr(word("job", "result"), "aborted") != NULL);
    CHECK(until("machine", "state", "idle") && !simulated_moves());
    end();
}

static void one_page_controls_and_each_may_hold(arb *a)
{
    begin();
    const int first = page;
    give_drawing(a, 8);
    const int second = join();
    CHECK(ask("job.start", "{}") == 1 && ask("machine.home", "{}") == 1);
    page = first;
    CHECK(ask("job.start", "{}") == 0 && until("job", "state", "draws"));
    page = second;
    CHECK(ask("job.hold", "{}") == 0 && until("job", "state", "held"));
    CHECK(ask("job.resume", "{}") == 1 && ask("control.take", "{}") == 0);
    page = first;
    CHECK(ask("job.resume", "{}") == 1);
    serve_leave(s, second);
    CHECK(ask("job.resume", "{}") == 0 && until("job", "state", "over") && is_drawn());
    end();
}

/* Who has heard all changes knows what a new page is told. */
static void a_page_that_comes_again_knows_the_same(arb *a)
{
    begin();
    const int first = page;
    give_drawing(a, 6);
    CHECK(ask("job.start", "{}") == 0 && until("job", "state", "draws"));
    pass(0.001 * arb_below(a, 1500));
    (void)join();
    pass(0.11);
    const int second = page;
    page = first;
    take_texts(first);
    take_texts(second);
    CHECK(json_object_equal(state[first], state[second]));
    CHECK(until("job", "state", "over"));
    end();
}

/* The program is gone in the middle; the machine draws what it has. */
static void a_killed_server_goes_on_with_the_job(arb *a)
{
    begin();
    give_drawing(a, 14);
    CHECK(ask("drawing.options", "{\"feed\":40}") == 0 && until("plan", "state", "ready"));
    CHECK(ask("job.start", "{}") == 0 && until("job", "state", "draws"));
    pass(0.001 * arb_below(a, 4000));
    close_server();
    for (uint32_t ms = arb_below(a, 3000); ms > 0; ms--)
        simulated_ms();
    open_server(NULL);
    (void)join();
    CHECK(strstr(word("drawing", "options"), "40") != NULL && until("plan", "state", "ready"));
    while (says("machine", "state", "connects"))
        step();
    CHECK(ask("job.start", "{}") == 0 && until("job", "state", "over"));
    CHECK(says("job", "code", "0") && is_drawn());
    end();
}

static void moves_end_where_they_should(arb *a)
{
    char text[100];
    const double x = arb_below(a, 50), y = arb_below(a, 50);

    begin();
    CHECK(until("machine", "state", "idle"));
    snprintf(text, sizeof text, "{\"x\":%g,\"y\":%g,\"feed\":60}", x, y);
    CHECK(ask("machine.go", text) == 0 && until("machine", "state", "moves"));
    CHECK(until("machine", "state", "idle") && fabs(sim.world.at[0] - x) < 0.1);
    CHECK(ask("machine.zero", "{\"axes\":\"xy\"}") == 0);
    pass(0.5);
    CHECK(fabs(json_object_get_double(
              json_object_array_get_idx(at(at(state[page], "machine"), "at"), 0))) < 1e-9);
    CHECK(ask("machine.jog", "{\"way\":\"y+\",\"size\":1}") == 0);
    CHECK(until("machine", "state", "moves") && until("machine", "state", "idle"));
    CHECK(fabs(sim.world.at[1] - y - 1) < 0.1);
    end();
}

/* A held jog ends when it is let go, when nobody says that it is held, and with its page. */
static void a_jog_ends_with_its_page(arb *a)
{
    begin();
    CHECK(until("machine", "state", "idle"));
    const uint32_t way = arb_below(a, 3);
    CHECK(ask("machine.jog", "{\"way\":\"x+\",\"feed\":20}") == 0);
    CHECK(until("machine", "state", "moves"));
    for (int k = 0; k < 3; k++) {
        CHECK(ask("machine.jog-on", "{}") == 0);
        pass(0.4);
        CHECK(simulated_moves());
    }
    const int watcher = serve_join(s), holder = page;
    page = watcher;
    CHECK(ask("hello", "{\"protocol\":1}") == 0);
    page = holder;
    if (way == 0)
        CHECK(ask("machine.jog-off", "{}") == 0);
    else if (way == 1)
        serve_leave(s, holder);
    page = watcher;
    pass(2.5);
    CHECK(!simulated_moves() && says("machine", "state", "idle"));
    CHECK(sim.world.at[0] > 10 && sim.world.at[0] < 80);
    end();
}

static void nobody_is_heard_before_hello_and_its_token(arb *a)
{
    begin_with("0123456789abcdef");
    page = serve_join(s);
    CHECK(ask("job.hold", "{}") == -32600);
    CHECK(ask("hello", "{\"protocol\":2}") == -32602);
    CHECK(ask("hello", "{\"protocol\":1}") == 1);
    serve_leave(s, page);
    page = serve_join(s);
    CHECK(ask("hello", "{\"protocol\":1,\"token\":\"0123456789abcdee\"}") == 1);
    serve_leave(s, page);
    page = serve_join(s);
    CHECK(ask("hello", "{\"protocol\":1,\"token\":\"0123456789abcdef\"}") == 0);
    (void)a;
    end();
}

/* Texts that are cut, doubled, changed: each is answered, and the next good one, too. */
static void what_is_no_message_is_refused(arb *a)
{
    static const char *const good[] = {
        "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\",\"params\":{}}",
        "{\"jsonrpc\":\"2.0\",\"id\":[[[[[[[[[[1]]]]]]]]]],\"method\":\"job.override\","
        "\"params\":{\"percent\":1e400}}",
        "{\"jsonrpc\":\"2.0\",\"method\":\"drawing.options\",\"params\":{\"\\u006dachine\":"
        "\"/etc/passwd\"}}",
        "[1,2,3]",
        "{\"jsonrpc\":\"2.0\",\"id\":null,\"method\":\"machine.jog\",\"params\":[1]}",
    };
    char text[400];

    begin();
    for (int n = 0; n < 60; n++) {
        const char *from = good[arb_below(a, 5)];
        size_t size      = strlen(from);
        memcpy(text, from, size);
        for (uint32_t k = arb_below(a, 4); k > 0; k--)
            text[arb_below(a, (uint32_t)size)] = (char)arb_below(a, 256);
        if (arb_below(a, 2) == 0)
            size = arb_below(a, (uint32_t)size + 1);
        CHECK(serve_hear(s, page, text, size, sim.clock));
        take_texts(page);
    }
    CHECK(ask("drawing.options", "{\"\\u006dachine\":\"/etc/passwd\"}") == -32602);
    CHECK(ask("drawing.options", "{\"feed\":-3}") == -32602);
    CHECK(ask("machine.jog", "{\"way\":\"q+\"}") == -32602);
    CHECK(ask("nothing", "{}") == -32601);
    CHECK(ask("ping", "{}") == 0);
    end();
}

int main(void)
{
    PROPERTY(a_drawing_is_planned_and_drawn, 2);
    PROPERTY(a_hold_stops_it_and_it_goes_on, 2);
    PROPERTY(an_abort_ends_it, 1);
    PROPERTY(one_page_controls_and_each_may_hold, 1);
    PROPERTY(a_page_that_comes_again_knows_the_same, 2);
    PROPERTY(a_killed_server_goes_on_with_the_job, 2);
    PROPERTY(moves_end_where_they_should, 2);
    PROPERTY(a_jog_ends_with_its_page, 3);
    PROPERTY(nobody_is_heard_before_hello_and_its_token, 1);
    PROPERTY(what_is_no_message_is_refused, 4);
    return check_failures();
}

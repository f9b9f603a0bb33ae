/* tests/tools/test_library.c -- libloft-host: a program asks a machine for all that a page needs,
 * in simulated time
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <unistd.h>

#include "library/host.h"
#include "support/heard.h"
#include "tools/simulated.h"

#define LATE  0.05              /* s until a hold is obeyed */
#define HOURS 7200.0

static struct {
    loft_host *h;
    loft_host_machine *m;
    char names[512], told[4096], states[4096];
    unsigned changes;
} p;

static void keep_name(void *context, const loft_host_message *m)
{
    (void)context;
    snprintf(p.names + strlen(p.names), sizeof p.names - strlen(p.names), "%s ", m->name);
}

static void keep_line(void *context, const char *line)
{
    (void)context;
    snprintf(p.told + strlen(p.told), sizeof p.told - strlen(p.told), "%s\n", line);
}

/* Each state once, as they come. */
static void keep_state(void *context, loft_host_machine *m)
{
    loft_host_facts f;
    char word[32];

    (void)context;
    loft_host_state(m, &f);
    p.changes++;
    snprintf(word, sizeof word, " %s", f.state);
    const size_t used = strlen(p.states), size = strlen(word);
    if (used < size || strcmp(p.states + used - size, word) != 0)
        snprintf(p.states + used, sizeof p.states - used, "%s", word);
}

/* The bytes of the simulated line, by two functions. */
static transport line;

static long get(void *context, void *bytes, size_t most)
{
    return line.kind->read(context, bytes, most);
}

static long put(void *context, const void *bytes, size_t count)
{
    return line.kind->write(context, bytes, count);
}

static void connect_by(const char *machine, bool own)
{
    static const loft_host_port port = { get, put, &line };
    const loft_host_line at = { .port    = "-",
                                .own     = own ? &port : NULL,
                                .machine = machine,
                                .told    = keep_line,
                                .changed = keep_state };

    if (own)
        (void)transport_open(&line, &heard, "-", 0);
    CHECK(loft_host_connect(p.h, &at, &p.m) == 0);
}

static void begin(arb *a, const char *machine)
{
    struct loft_host_options o = loft_host_defaults();

    o.slots = 4;
    for (int i = 0; i < LOFT_AXES; i++)
        o.steps_per_mm[i] = 7;
    simulated_begin(&o);
    memset(&p, 0, sizeof p);
    p.h = loft_host_open(&(loft_host_calls){ .message = keep_name });
    connect_by(machine, arb_below(a, 2) != 0);
}

static void end(void)
{
    loft_host_machine_free(p.m);
    loft_host_close(p.h);
}

/* The same as a task; a line of the program is looked at as one of a descriptor. */
static int step_machine(void *context, double now, task_wants *w)
{
    loft_host_wants wants;
    const int code = loft_host_step(context, now, &wants);

    *w = (task_wants){ .in  = wants.get || wants.in >= 0 ? 5 : -1,
                       .out = wants.put || wants.out >= 0 ? 6 : -1 };
    w->until = now + 0.001 * wants.ms;
    return code;
}

/* One step, and a wait as long as it wants. */
static int step(void)
{
    static bool stop;
    const task t = { step_machine, p.m, &stop };
    task_wants w;
    const int code = simulated_step(&t, &w);

    simulated_wait(&w);
    return code;
}

static int run(double until)
{
    int code;

    while ((code = step()) == LOFT_HOST_GOES && sim.clock < until)
        if (sim.clock > HOURS) {
            CHECK(sim.clock < HOURS);
            return EX_SOFTWARE;
        }
    return code;
}

static int done(int code) { return code == 0 ? run(HUGE_VAL) : code; }

static loft_host_facts facts(void)
{
    loft_host_facts f;

    loft_host_state(p.m, &f);
    return f;
}

static bool is_there(double x, double y, double z)
{
    const double to[] = { x, y, z };

    for (int i = 0; i < 3; i++)
        if (fabs(sim.world.at[i] - to[i]) > 0.5 / sim.options.steps_per_mm[i] + 1e-9)
            return false;
    return true;
}

/* A file with lines there and back; *x, *y is its end. */
static void draw_lines(arb *a, unsigned count, char name[40], double *x, double *y)
{
    strcpy(name, "/tmp/loft-library-XXXXXX");
    FILE *out = fdopen(mkstemp(name), "w");

    fputs("line\n0 0\n", out);
    for (unsigned n = 0; n < count; n++) {
        *x = 5 + arb_below(a, 40);
        *y = 5 + arb_below(a, 40);
        fprintf(out, "%g %g\n", *x, *y);
    }
    fclose(out);
}


// Drawings
// --------

/* Whoever is killed, and streams the same again, draws it once. */
static void a_drawing_that_was_cut_off_goes_on(arb *a)
{
    char name[40];
    double x, y;
    loft_host_drawing *d;

    begin(a, NULL);
    draw_lines(a, 3 + arb_below(a, 10), name, &x, &y);
    CHECK(loft_host_read(p.h, name, &d) == 0 && loft_host_stream(p.m, d, NULL) == 0);
    int code = run(sim.clock + 0.01 * arb_below(a, 400));
    for (int k = 0; k < 2 && code == LOFT_HOST_GOES; k++) {
        loft_host_machine_free(p.m);
        connect_by(NULL, k != 0);
        CHECK(loft_host_stream(p.m, d, NULL) == 0);
        code = run(sim.clock + (k > 0 ? HUGE_VAL : 0.01 * arb_below(a, 400)));
    }
    CHECK(code == 0 && is_there(x, y, facts().at[2]) && strstr(p.told, "drawn: ") != NULL);
    CHECK(strcmp(p.names, "") == 0 && strstr(p.states, " draws") != NULL && p.changes > 5);
    loft_host_drawing_free(d);
    (void)unlink(name);
    end();
}

static void a_hold_is_obeyed_at_once_and_a_stop_holds(arb *a)
{
    char name[40];
    double x, y;

    begin(a, NULL);
    draw_lines(a, 30, name, &x, &y);
    CHECK(loft_host_stream_file(p.m, name, NULL) == 0);
    CHECK(run(sim.clock + 2 + 0.01 * arb_below(a, 200)) == LOFT_HOST_GOES);
    loft_host_hold(p.m);
    const double asked = sim.clock;
    while (sim.machine.drive.state != LOFT_STATE_HOLDING &&
           sim.machine.drive.state != LOFT_STATE_HELD)
        CHECK(step() == LOFT_HOST_GOES && sim.clock < asked + 1);
    CHECK(sim.clock < asked + LATE);
    while (strcmp(facts().state, "held") != 0)
        CHECK(step() == LOFT_HOST_GOES && sim.clock < asked + 5);
    loft_host_override(p.m, 150);
    loft_host_resume(p.m);
    CHECK(run(sim.clock + 1) == LOFT_HOST_GOES && facts().override == 150);
    CHECK(strcmp(facts().state, "draws") == 0 && facts().feed > 0 && facts().job != 0);
    while (!loft_host_stop(p.m))
        (void)step();
    CHECK(run(sim.clock) == EX_TEMPFAIL && strstr(p.names, "job.held") != NULL);
    CHECK(sim.machine.drive.state == LOFT_STATE_HELD && simulated_moves());
    end();
    (void)unlink(name);
}

/* One tool after the other; the state says which one is asked for. */
static void tools_are_asked_for(arb *a)
{
    char name[] = "/tmp/loft-library-XXXXXX", tools[] = "/tmp/loft-library-XXXXXX";
    FILE *out = fdopen(mkstemp(name), "w"), *file = fdopen(mkstemp(tools), "w");
    const bool leaves = arb_below(a, 3) == 0;

    fputs("<svg xmlns='http://www.w3.org/2000/svg' width='40mm' height='40mm' viewBox='0 0 40 40'>"
          "<path stroke='red' d='M1 1L9 9'/><path stroke='blue' d='M5 5L20 9'/></svg>",
          out);
    fputs("tool.one.colours = red\ntool.two.colours = blue\ntool.two.pause = put in two\n", file);
    fclose(out);
    fclose(file);
    begin(a, tools);
    CHECK(loft_host_stream_file(p.m, name, NULL) == 0);
    while (strcmp(facts().state, "tool") != 0)
        if (step() != LOFT_HOST_GOES || sim.clock > 100)
            break;
    CHECK(facts().tool != NULL && strcmp(facts().tool, "two") == 0);
    (leaves ? loft_host_abort : loft_host_resume)(p.m);
    CHECK(run(HUGE_VAL) == (leaves ? EX_TEMPFAIL : 0));
    CHECK(leaves || is_there(20, 31, facts().at[2]));
    end();
    (void)unlink(name);
    (void)unlink(tools);
}


// By hand
// -------

static void a_tool_is_led_by_hand(arb *a)
{
    const double x = arb_below(a, 30), to[] = { x, NAN, 3 }, back[] = { NAN, 2, -1 };

    begin(a, NULL);
    CHECK(done(loft_host_go(p.m, to, false, 50)) == 0 && is_there(x, 0, 3));
    CHECK(done(loft_host_go(p.m, back, true, 50)) == 0 && is_there(x, 2, 2));
    CHECK(done(loft_host_pen(p.m, true, 50)) == 0 && is_there(x, 2, 1));
    CHECK(done(loft_host_jog(p.m, 1, -1, 50)) == 0 && is_there(x, 1, 1));
    CHECK(done(loft_host_park(p.m, 50)) == 0 && is_there(0, 0, 1));
    CHECK(loft_host_jog(p.m, 0, HUGE_VAL, 20) == 0);
    for (const double since = sim.clock; sim.clock < since + 1;) {
        loft_host_jog_on(p.m);
        CHECK(step() == LOFT_HOST_GOES);
    }
    CHECK(run(sim.clock + 3) == 0 && sim.world.at[0] > 5 && sim.world.at[0] < 40);
    CHECK(loft_host_go(p.m, to, false, 5) == 0);
    CHECK(loft_host_go(p.m, to, false, 5) == EX_TEMPFAIL);
    CHECK(strcmp(p.names, "desk.busy ") == 0);
    loft_host_hold(p.m);
    (void)run(HUGE_VAL);
    p.names[0] = '\0';
    CHECK(done(loft_host_zero(p.m, "xy", 4, false)) == 0);
    CHECK(facts().at[0] == 4 && facts().at[1] == 4);
    CHECK(loft_host_zero(p.m, "xx", 0, false) == EX_USAGE && strcmp(p.names, "job.axes ") == 0);
    end();
}

static void a_machine_keeps_what_it_is_told(arb *a)
{
    char row[64];

    begin(a, NULL);
    snprintf(row, sizeof row, "y.steps_per_mm = %u\n", 10 + (unsigned)arb_below(a, 200));
    CHECK(done(loft_host_settings_read(p.m)) == 0 && strstr(loft_host_settings(p.m), row) == NULL);
    CHECK(done(loft_host_settings_set(p.m, row)) == 0);
    CHECK(strstr(loft_host_settings(p.m), row) != NULL);
    CHECK(done(loft_host_settings_set(p.m, "no.such = 1\n")) == EX_DATAERR);
    CHECK(strcmp(p.names, "machine.key-unknown ") == 0);
    CHECK(done(loft_host_settings_read(p.m)) == 0 && strstr(loft_host_settings(p.m), row) != NULL);
    end();
}

/* A machine that does not answer is told of once; then nothing is asked of it. */
static void a_machine_that_is_mute_is_closed(arb *a)
{
    begin(a, NULL);
    sim.mute = true;
    CHECK(run(HUGE_VAL) == EX_UNAVAILABLE && strcmp(p.names, "port.no-answer ") == 0);
    CHECK(strcmp(facts().state, "closed") == 0);
    CHECK(loft_host_park(p.m, 50) == EX_UNAVAILABLE && step() == EX_UNAVAILABLE);
    end();
}

int main(void)
{
    PROPERTY(a_drawing_that_was_cut_off_goes_on, 6);
    PROPERTY(a_hold_is_obeyed_at_once_and_a_stop_holds, 3);
    PROPERTY(tools_are_asked_for, 3);
    PROPERTY(a_tool_is_led_by_hand, 3);
    PROPERTY(a_machine_keeps_what_it_is_told, 3);
    PROPERTY(a_machine_that_is_mute_is_closed, 2);
    return check_failures();
}

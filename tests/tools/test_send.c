/* tests/tools/test_send.c -- conversations with a machine, stepped in simulated time
 * SPDX-License-Identifier: MIT
 */
#include "base/spool.h"
#include "plan/job.h"
#include "send/hand.h"
#include "send/home.h"
#include "send/mover.h"
#include "send/probe.h"
#include "send/settings.h"
#include "send/stream.h"
#include "support/heard.h"
#include "tools/simulated.h"

#define LATE   0.05             /* s until a hold is obeyed */
#define HOURS  7200.0

static const talk_options at_once = { .port = "-", .baud = 115200, .wait = 5 };

static struct {
    talk t;
    planning p;
    job_work w;
    stream r;
    char told[4096];
} s;


// Running
// -------

/* Step until it is over, or until `until`. */
static int run(task t, double until)
{
    task_wants w;
    int code;

    while ((code = simulated_step(&t, &w)) == TASK_GOES && sim.clock < until)
        simulated_wait(&w);
    return code;
}

static void tell_line(void *context, enum send_line what, const char *line)
{
    (void)context;
    (void)what;
    snprintf(s.told + strlen(s.told), sizeof s.told - strlen(s.told), "%s\n", line);
}

/* With few slots, since each of them takes the time of this computer. */
static struct loft_host_options usual(void)
{
    struct loft_host_options o = loft_host_defaults();

    o.slots = 4;
    for (int i = 0; i < LOFT_AXES; i++)
        o.steps_per_mm[i] = 7;
    return o;
}

static void begin(void)
{
    const struct loft_host_options o = usual();

    hear();
    s.told[0] = '\0';
    simulated_begin(&o);
    CHECK(talk_open(&s.t, &heard, &at_once, sim.clock) == 0);
    CHECK(run(talk_greets(&s.t), HOURS) == 0);
}

static void end(void)
{
    job_work_free(&s.w);
    talk_close(&s.t);
}

/* `count` lines there and back, from where the machine is or from where its job began. */
static void plan_lines_from(arb *a, size_t count, bool old)
{
    const drawing nothing = { 0 };
    job_options as        = { .kind = LOFT_SPANS };
    double start[ENGINE_AXES], at[ENGINE_AXES];

    CHECK(planning_usual(&heard, &s.p, NULL) == 0);
    s.w    = (job_work){ .path = { 0 } };
    as.e   = s.p.e;
    if (old)
        stream_old_start(&s.t.sender, false, start);
    else
        stream_new_start(&s.t.sender, start);
    memcpy(at, start, sizeof at);
    s.w.path = (toolpath){ .move  = spool_grow(NULL, count * sizeof *s.w.path.move),
                           .curve = spool_grow(NULL, count * sizeof *s.w.path.curve),
                           .count = count };
    for (size_t n = 0; n < count; n++) {
        double to[ENGINE_AXES] = { 5 + arb_below(a, 40), 5 + arb_below(a, 40), 0 };
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < ENGINE_AXES; i++)
                s.w.path.move[n].p[k][i] = at[i] + (to[i] - at[i]) * k / 3;
        s.w.path.move[n].feed = 60;
        s.w.path.curve[n]     = n;
        memcpy(at, to, sizeof at);
    }
    stream_machine(&s.t.sender, &as.limits);
    for (int i = 0; i < ENGINE_AXES; i++)
        as.steps_per_mm[i] = s.t.sender.axis[i].steps_per_mm;
    planning_limit(&s.p, &as.limits);
    CHECK(planning_joints(&heard, &s.p, "-", &nothing, start, false, &as.limits, &s.w.path,
                          &s.w.of) == 0);
    CHECK(job_open(&s.w.j, &s.w.of, &as) == LOFT_OK);
}

static void plan_lines(arb *a, size_t count) { plan_lines_from(a, count, false); }

static task stream_of(void)
{
    static stream_subject about;

    about = (stream_subject){
        .file = "-", .k = &s.p.machine.k, .port = "-", .tol = s.p.tol, .path = &s.w.path
    };
    stream_begin(&s.r, &s.t, &s.w.j, &about, &(send_teller){ .tell = tell_line });
    return stream_task(&s.r);
}

/* The pulses that came are those of the job. */
static bool is_at(const double at[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        if (fabs(sim.world.at[i] - at[i]) > 0.5 / sim.options.steps_per_mm[i] + 1e-9)
            return false;
    return true;
}

static bool is_drawn(void) { return is_at(s.w.path.move[s.w.path.count - 1].p[3]); }


// Jobs
// ----

static void a_job_is_drawn_as_commanded(arb *a)
{
    begin();
    plan_lines(a, 1 + arb_below(a, 20));
    CHECK(run(stream_of(), HOURS) == 0);
    CHECK(strstr(s.told, " as commanded") != NULL);
    CHECK(is_drawn() && caught_lines == 0);
    end();
}

/* A hold is obeyed while the plan goes on, and then nothing moves. */
static void a_hold_is_answered_while_planning_goes_on(arb *a)
{
    begin();
    plan_lines(a, 60);
    const task t = stream_of();
    CHECK(run(t, sim.clock + 0.2 + 0.001 * arb_below(a, 500)) == TASK_GOES);
    CHECK(!s.w.j.whole && simulated_moves());
    const size_t planned = s.w.j.count;
    stream_key(&s.r, 'h');
    const double asked = sim.clock;
    while (!sim.machine.drive.hold && sim.clock < asked + LATE) {
        CHECK(run(t, sim.clock) == TASK_GOES);
        simulated_ms();
    }
    CHECK(sim.machine.drive.hold);
    CHECK(run(t, sim.clock + 1) == TASK_GOES);
    const double at[] = { sim.world.at[0], sim.world.at[1], sim.world.at[2] };
    CHECK(sim.machine.drive.state == LOFT_STATE_HELD && s.w.j.count >= planned);
    CHECK(run(t, sim.clock + 1) == TASK_GOES && is_at(at));
    stream_key(&s.r, 'r');
    CHECK(run(t, HOURS) == 0);
    CHECK(is_drawn() && caught_lines == 0);
    end();
}

static void who_asks_for_the_end_gets_a_hold_and_may_go_on(arb *a)
{
    begin();
    plan_lines(a, 12);
    CHECK(run(stream_of(), sim.clock + 0.2 + 0.001 * arb_below(a, 2000)) == TASK_GOES);
    s.t.stop = true;
    CHECK(run(stream_task(&s.r), sim.clock + 5) == EX_TEMPFAIL);
    CHECK(caught_lines == 1 && strstr(caught, "held at item") != NULL);
    CHECK(sim.machine.drive.state == LOFT_STATE_HELD);
    /* the same command */
    hear();
    s.t.stop = false;
    talk_again(&s.t, 5);
    CHECK(run(talk_greets(&s.t), HOURS) == 0);
    CHECK(run(stream_of(), HOURS) == 0);
    CHECK(is_drawn() && strstr(s.told, "resuming at item") != NULL && caught_lines == 0);
    end();
}

static void an_abort_ends_it_on_the_path(arb *a)
{
    begin();
    plan_lines(a, 12);
    CHECK(run(stream_of(), sim.clock + 0.2 + 0.001 * arb_below(a, 2000)) == TASK_GOES);
    stream_key(&s.r, 'a');
    CHECK(run(stream_task(&s.r), sim.clock + 5) == EX_TEMPFAIL);
    CHECK(caught_lines == 1 && strstr(caught, "aborted after") != NULL && !simulated_moves());
    end();
}

static void a_line_that_is_lost_is_told_once(arb *a)
{
    begin();
    plan_lines(a, 12);
    const task t = stream_of();
    CHECK(run(t, sim.clock + 0.2 + 0.001 * arb_below(a, 2000)) == TASK_GOES);
    const double since = sim.clock;
    sim.gone           = arb_below(a, 2) == 0;
    sim.mute           = !sim.gone;
    CHECK(run(t, HOURS) == EX_IOERR && caught_lines == 1);
    CHECK(sim.clock - since < (sim.gone ? 0.5 : 12));
    CHECK(strstr(caught, sim.gone ? "vanished" : "silent for 10 s") != NULL);
    end();
}

static void pass(double seconds)
{
    for (const double until = sim.clock + seconds; sim.clock < until;)
        simulated_ms();
}

/* Nothing was asked of the machine while this computer planned. */
static void a_long_plan_is_no_silence(arb *a)
{
    begin();
    plan_lines(a, 3);
    pass(5 + arb_below(a, 20));
    CHECK(run(stream_of(), HOURS) == 0 && is_drawn() && caught_lines == 0);
    end();
}

/* A job whose report comes later is planned up to its end, and no step computes for long. */
static void what_was_drawn_is_judged_in_slices(arb *a)
{
    const arb again = *a;

    begin();
    plan_lines(a, 150);
    const task t = stream_of();
    do
        CHECK(run(t, sim.clock + 0.01) == TASK_GOES);
    while (!s.w.j.whole || s.t.sender.ack.next < s.w.j.count);
    end();
    while (simulated_moves())
        simulated_ms();
    CHECK(talk_open(&s.t, &heard, &at_once, sim.clock) == 0);
    CHECK(run(talk_greets(&s.t), HOURS) == 0);
    *a = again;
    plan_lines_from(a, 150, true);
    sim.most = 0;
    CHECK(!s.w.j.whole);
    CHECK(run(stream_of(), HOURS) == 0 && is_drawn() && caught_lines == 0);
    CHECK(sim.most < 1000 * LATE && strstr(s.told, "this job was drawn already") != NULL);
    end();
}

static void another_job_is_told_of(arb *a)
{
    begin();
    plan_lines(a, 30);
    CHECK(run(stream_of(), sim.clock + 2) == TASK_GOES);
    end();
    CHECK(talk_open(&s.t, &heard, &at_once, sim.clock) == 0);
    CHECK(run(talk_greets(&s.t), HOURS) == 0);
    plan_lines(a, 3);
    pass(arb_below(a, 20));
    CHECK(run(stream_of(), sim.clock + 1) == EX_TEMPFAIL);
    CHECK(caught_lines == 1 && strstr(caught, "another job") != NULL);
    end();
}

static void a_mute_machine_is_asked_for_as_long_as_said(arb *a)
{
    const struct loft_host_options o = usual();
    const talk_options to = { .port = "-", .baud = 115200, .wait = 0.1 + 0.1 * arb_below(a, 50) };

    hear();
    simulated_begin(&o);
    sim.mute = true;
    CHECK(talk_open(&s.t, &heard, &to, sim.clock) == 0);
    CHECK(run(talk_greets(&s.t), HOURS) == EX_UNAVAILABLE);
    CHECK(fabs(sim.clock - to.wait) < 0.01 && caught_lines == 1);
    talk_close(&s.t);
}

static void every_number_of_steps_gives_the_same_pulses(arb *a)
{
    task_wants w;

    begin();
    plan_lines(a, 10);
    const task t = stream_of();
    int code;
    while ((code = simulated_step(&t, &w)) == TASK_GOES)    /* too early, as a busy loop does */
        for (uint32_t ms = arb_below(a, 30); ms > 0 && sim.clock < w.until; ms--)
            simulated_ms();
    CHECK(code == 0 && is_drawn());
    end();
}


// Moves and settings
// ------------------

static mover v;

static void open_mover(const struct loft_host_options *o)
{
    const mover_options options = { .line = at_once };

    hear();
    simulated_begin(o);
    CHECK(mover_open(&v, &heard, &options, sim.clock) == 0);
    CHECK(run(mover_task(&v), HOURS) == 0);
}

static void moves_arrive(arb *a)
{
    const struct loft_host_options o = usual();

    open_mover(&o);
    for (int k = 0; k < 3; k++) {
        const double to[] = { arb_below(a, 30), arb_below(a, 30), arb_below(a, 3) };
        mover_to(&v, to, 30);
        CHECK(run(mover_task(&v), HOURS) == 0);
        CHECK(v.out.how == MOVER_ARRIVED && is_at(to));
    }
    const double said[] = { 1, 2, 3 };
    mover_place(&v, 7, said);
    CHECK(run(mover_task(&v), HOURS) == 0 && memcmp(v.at, said, sizeof said) == 0);
    CHECK(caught_lines == 0);
    mover_close(&v);
}

static bool asks_for_end(void *context) { return sim.clock > *(const double *)context; }

static void a_move_that_is_ended_stops_on_its_path(arb *a)
{
    const struct loft_host_options o = usual();
    double when = 0.3 + 0.001 * arb_below(a, 2000);
    mover_move m = { .to = { 200, 0, 0 }, .feed = 30, .ends = asks_for_end, .context = &when };

    open_mover(&o);
    when += sim.clock;
    mover_go(&v, &m);
    CHECK(run(mover_task(&v), HOURS) == 0 && v.out.how == MOVER_ENDED);
    CHECK(sim.clock < when + 1.5 && v.at[0] < 100 && is_at(v.at));
    mover_close(&v);
}

static void a_move_in_the_middle_can_be_left(arb *a)
{
    const struct loft_host_options o = usual();
    const mover_move m = { .to = { 200, 0, 0 }, .feed = 30 };

    open_mover(&o);
    mover_go(&v, &m);
    CHECK(run(mover_task(&v), sim.clock + 0.001 * arb_below(a, 2000)) == TASK_GOES);
    mover_close(&v);
    CHECK(!sim.open);
}

/* Parking never goes along the table with the pen down; what is placed is there. */
static void a_hand_parks_lifted_and_keeps_the_zero(arb *a)
{
    const struct loft_host_options o = usual();
    const double low = arb_below(a, 3), to[] = { 3.0 + arb_below(a, 9), NAN, low };
    const double zero[] = { 0, 0, 0 };
    hand m;

    open_mover(&o);
    CHECK(machine_text(&heard, &v.p.machine, "test", "pen_up = 2\nx.park = 1\ny.park = 2\n") == 0);
    hand_go(&m, &v, to, false, 30);
    CHECK(run(hand_task(&m), HOURS) == 0 && v.at[0] == to[0] && v.at[1] == 0 && v.at[2] == low);
    hand_park(&m, &v, 30);
    while (run(hand_task(&m), sim.clock) == TASK_GOES && fabs(v.at[2] - 2) > 0.1)
        CHECK(fabs(sim.world.at[0] - to[0]) < 0.2);
    CHECK(run(hand_task(&m), HOURS) == 0);
    CHECK(v.at[2] == fmax(low, 2) && v.at[0] == 1 && v.at[1] == 2);
    hand_jog(&m, &v, 0, arb_below(a, 2) ? 4 : -4, 30, NULL, NULL);
    CHECK(run(hand_task(&m), HOURS) == 0 && fabs(v.at[0] - 1) == 4);
    hand_pen(&m, &v, false, 30);
    CHECK(run(hand_task(&m), HOURS) == 0 && v.at[2] == 0);
    const double before = v.at[0];
    hand_zero(&m, &v, 1, zero, true);
    CHECK(run(hand_task(&m), HOURS) == 0 && v.at[0] == 0 && v.at[1] == 2 && m.was[0] == before);
    CHECK(fabs(v.kept.m.zero[0] - before) < 1e-9 && v.kept.m.zero[1] == 0 && caught_lines == 0);
    mover_close(&v);
}

/* x has a switch at its low end, y one at its high end, somewhere. */
static void homing_tells_where_the_tool_is(arb *a)
{
    struct loft_host_options o = usual();
    const send_teller to       = { .tell = tell_line };
    static home h;

    o.limit[0][0].at = -1.0 - arb_below(a, 30);
    o.limit[1][1].at = 1.0 + arb_below(a, 30);
    o.bounce_ms      = arb_below(a, 5);
    s.told[0]        = '\0';
    open_mover(&o);
    CHECK(machine_text(&heard, &v.p.machine, "test",
                       "x.travel = 60\nx.home_order = 1\ny.travel = 60\ny.home_order = 2\n"
                       "y.home_end = high\n") == 0);
    home_begin(&h, &v, NULL, 2, &to);
    CHECK(run(home_task(&h), HOURS) == 0 && caught_lines == 0);
    CHECK(strstr(s.told, "y: its switch at the high end") != NULL);
    CHECK(strstr(s.told, "homed: the tool is at") != NULL);
    /* the switches are where the machine says */
    const double step = 1 / o.steps_per_mm[0];
    CHECK(fabs(sim.world.at[0] - o.limit[0][0].at - (v.at[0] - machine_home_at(&v.p.machine, 0))) <=
          2 * step);
    CHECK(fabs(sim.world.at[1] - o.limit[1][1].at - (v.at[1] - machine_home_at(&v.p.machine, 1))) <=
          2 * step);
    mover_close(&v);
}

static void homing_ends_where_it_is_asked_to(arb *a)
{
    struct loft_host_options o = usual();
    const send_teller to       = { .tell = tell_line };
    static home h;

    o.limit[0][0].at = -20;
    open_mover(&o);
    CHECK(machine_text(&heard, &v.p.machine, "test", "x.travel = 60\nx.home_order = 1\n") == 0);
    home_begin(&h, &v, NULL, 2, &to);
    CHECK(run(home_task(&h), sim.clock + 0.001 * arb_below(a, 800)) == TASK_GOES);
    v.t.stop           = true;
    const double since = sim.clock;
    CHECK(run(home_task(&h), HOURS) == EX_TEMPFAIL && caught_lines == 1);
    CHECK(sim.clock < since + 2 && !simulated_moves());
    mover_close(&v);
}

static void a_probe_says_where_it_touches(arb *a)
{
    struct loft_host_options o = usual();
    const send_teller to       = { .tell = tell_line };
    const bool kept            = arb_below(a, 2) != 0;
    static probe p;
    probe_way way = {
        .axis = 2, .sign = -1, .within = 10, .feed = 2, .back = 1, .at = kept ? 15 : (double)NAN
    };

    o.probe[2][0].at = -1.0 - arb_below(a, 8);
    open_mover(&o);
    probe_begin(&p, &v, &way, &to);
    CHECK(run(probe_task(&p), HOURS) == 0 && caught_lines == 0);
    CHECK(fabs(p.touched[2] - (kept ? 15 : o.probe[2][0].at)) < 2 / o.steps_per_mm[2]);
    CHECK(fabs(sim.world.at[2] - o.probe[2][0].at - 1) < 3 / o.steps_per_mm[2]);
    way.within = 0.5;                   /* it was left by 1 */
    hear();
    probe_begin(&p, &v, &way, &to);
    CHECK(run(probe_task(&p), HOURS) == EX_UNAVAILABLE && caught_lines == 1);
    mover_close(&v);
}

/* A setting is written and read back after another greeting; who asks for the end is heard. */
static void settings_come_back(arb *a)
{
    const double steps = 10 + arb_below(a, 200);
    static settings_work k;
    static settings before, after;

    begin();
    settings_read(&k, &before, &s.t);
    CHECK(run(settings_task(&k), HOURS) == 0 && before.origin != LOFT_SETTINGS_KEPT);
    before.m.steps_per_mm[1] = steps;
    settings_write(&k, &before, &s.t, 5);
    CHECK(run(settings_task(&k), HOURS) == 0);
    settings_read(&k, &after, &s.t);
    CHECK(run(settings_task(&k), HOURS) == 0 && after.origin == LOFT_SETTINGS_KEPT);
    CHECK(after.m.steps_per_mm[1] == steps && caught_lines == 0);
    settings_read(&k, &after, &s.t);
    CHECK(run(settings_task(&k), sim.clock) == TASK_GOES);
    s.t.stop = true;
    CHECK(run(settings_task(&k), HOURS) == EX_TEMPFAIL);
    talk_close(&s.t);
}

int main(void)
{
    PROPERTY(a_job_is_drawn_as_commanded, 6);
    PROPERTY(a_hold_is_answered_while_planning_goes_on, 3);
    PROPERTY(who_asks_for_the_end_gets_a_hold_and_may_go_on, 5);
    PROPERTY(an_abort_ends_it_on_the_path, 5);
    PROPERTY(a_line_that_is_lost_is_told_once, 5);
    PROPERTY(a_mute_machine_is_asked_for_as_long_as_said, 10);
    PROPERTY(a_long_plan_is_no_silence, 5);
    PROPERTY(what_was_drawn_is_judged_in_slices, 1);
    PROPERTY(another_job_is_told_of, 5);
    PROPERTY(every_number_of_steps_gives_the_same_pulses, 4);
    PROPERTY(moves_arrive, 10);
    PROPERTY(a_move_that_is_ended_stops_on_its_path, 5);
    PROPERTY(a_move_in_the_middle_can_be_left, 10);
    PROPERTY(a_hand_parks_lifted_and_keeps_the_zero, 5);
    PROPERTY(homing_tells_where_the_tool_is, 4);
    PROPERTY(homing_ends_where_it_is_asked_to, 5);
    PROPERTY(a_probe_says_where_it_touches, 5);
    PROPERTY(settings_come_back, 5);
    return check_failures();
}

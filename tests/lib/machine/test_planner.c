/* tests/lib/machine/test_planner.c -- properties of lib/machine/planner.h, and of machines that
 * plan: from curves on the line to pulses
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#define LONG  400000    /* ms until a test gives up */
#include "support/motion_chains.h"  /* chain, limits, arb_chain, arb_limits */
#include "support/motion_oracle.h"  /* path, path_distance */
#include "support/planned.h"        /* w, turn_on, go_on, finish */

#define SPANS 1500
#define KNOTS 176       /* as a chip has */

static loft_move       moves[CURVES];
static loft_knot       knots[KNOTS];
static uint16_t        passed[CELLS + LOFT_PLANNER_AHEAD];
static loft_planner    planner;
static loft_item       items[CURVES], spans[SPANS];
static path            track;

/* As the main loop of a machine: again, while there is work. */
static bool next_of(bool hurry, loft_item *span)
{
    do
        if (loft_planner_next(&planner, hurry, span))
            return true;
    while (loft_planner_busy(&planner));
    return false;
}

static loft_planner_memory memory_of(uint16_t move_room)
{
    return (loft_planner_memory){
        .moves = moves, .knots = knots, .passed = passed, .move_room = move_room, .knot_room = KNOTS
    };
}

/* The chain as a job; its feeds become whole mm/min. */
static void make_job(int32_t start[LOFT_AXES])
{
    for (unsigned n = 0; n < curves; n++) {
        const uint16_t feed = (uint16_t)fmin(fmax(floor(arb_value(chain[n].feed) * 60), 1), 65535);
        chain[n].feed  = loft_acc_round(loft_acc_ratio(loft_to_acc(LOFT_REAL(1)) * feed, 60));
        items[n].ticks = feed;
        for (int i = 0; i < LOFT_AXES; i++)
            for (int k = 0; k < 3; k++)
                items[n].p[k][i] = loft_raw_from_real(chain[n].curve.p[k + 1].axis[i]);
    }
    for (int i = 0; i < LOFT_AXES; i++)
        start[i] = loft_raw_from_real(chain[0].curve.p[0].axis[i]);
}

static int32_t raw(loft_real x)     { return loft_raw_from_real(x); }

static loft_job_limits asked(void)
{
    loft_job_limits l = { .corner = raw(limits.corner), .tol = raw(limits.tol) };
    for (int i = 0; i < LOFT_AXES; i++) {
        l.axis[i].max_speed = raw(limits.max_speed[i]);
        l.axis[i].max_accel = raw(limits.max_accel[i]);
        l.axis[i].max_jerk  = limits.max_jerk[i];
    }
    return l;
}

/* A machine without limits. */
static loft_machine_info info(void)
{
    loft_machine_info t = { .tick_hz = limits.tick_hz, .slots = 40 };
    for (int i = 0; i < LOFT_AXES; i++)
        t.axis[i] = (loft_axis_config){ .steps_per_mm = 80 * 65536,
                                        .max_speed = INT32_MAX,
                                        .max_accel = INT32_MAX };
    return t;
}

static void arb_job(arb *a, int32_t start[LOFT_AXES])
{
    arb_limits(a);
    arb_chain(a);
    for (int i = 0; i < LOFT_AXES && arb_below(a, 2); i++)
        limits.max_jerk[i] = (uint32_t)(20 * arb_value(limits.max_accel[i]));
    make_job(start);
}


// The planner
// -----------

/* The place on the path where a curve begins. */
static double begin_of(unsigned curve)
{
    for (unsigned k = 1; k < track.count; k++)
        if (track.end[k].curve >= curve)
            return track.end[k - 1].s;
    return track.length;
}

/* A span's end lies behind the curves that are told, and hardly more than a period into what
 * is not. */
static void check_told(const loft_item *span, unsigned told, unsigned *at)
{
    const double late = 3.0 * planner.plan.period.ticks / planner.plan.period.tick_hz * 500;
    double end[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        end[i] = span->p[2][i] / 65536.0;
    CHECK(told <= curves);
    const double off = path_distance(&track, at, end, begin_of(told),
                                     fmin(begin_of(told + 1) + late, track.length));
    CHECK_NEAR(off, 0, 3 * arb_value(limits.tol) + 1e-4);
}

static void curves_are_told_when_they_are_behind(arb *a)
{
    const uint16_t room = (uint16_t)(8 + arb_below(a, CURVES - 8));
    const loft_planner_memory memory = memory_of(room);
    int32_t start[LOFT_AXES];
    unsigned next = 0, given = 0, at = 0;
    uint32_t told = 0;

    arb_job(a, start);
    const loft_machine_info machine = info();
    const loft_job_limits l   = asked();
    path_trace(&track, chain, curves, fmax(0.01, arb_value(limits.tol)) * 20);
    CHECK(loft_planner_init(&planner, &memory, CELLS) == LOFT_OK);
    CHECK(loft_planner_begin(&planner, &machine, &l, start) == LOFT_OK);
    for (unsigned idle = 0; !loft_planner_done(&planner) && idle < 100 && !check_bad; idle++) {
        for (unsigned n = arb_below(a, 5);
             n > 0 && next < curves && loft_planner_room(&planner) > 0; n--)
            CHECK(loft_planner_push(&planner, &items[next++]) == LOFT_REFUSAL_NONE);
        if (next == curves)
            CHECK(loft_planner_end(&planner) == LOFT_REFUSAL_NONE);
        for (unsigned n = arb_below(a, 30);
             n > 0 && given < SPANS && next_of(arb_below(a, 2), &spans[given]); n--, idle = 0) {
            const uint32_t now = loft_planner_executed(&planner, ++given);
            CHECK(now >= told && now <= next);
            told = now;
            if (given % 8 == 0)
                check_told(&spans[given - 1], told, &at);
        }
    }
    CHECK(loft_planner_done(&planner) || given == SPANS);
    CHECK(planner.taken == curves || given == SPANS);
    for (int i = 0; i < LOFT_AXES && given > 0 && given < SPANS; i++)
        CHECK(spans[given - 1].p[2][i] == items[curves - 1].p[2][i]);
}

/* The planner adds only the encoding to lib/motion/plan.h: the same curves give the same spans. */
static void the_spans_are_those_of_the_plan(arb *a)
{
    static loft_plan plan;
    static loft_move ring[CURVES];
    static loft_knot ahead[KNOTS];
    const loft_planner_memory memory = memory_of(CURVES);
    enum loft_plan_state state = LOFT_PLAN_SPAN;
    int32_t start[LOFT_AXES];
    unsigned given = 0;
    loft_item want, got;
    loft_span span;

    arb_job(a, start);
    limits.tol = loft_real_from_raw(raw(limits.tol));
    const loft_machine_info machine = info();
    const loft_job_limits l   = asked();
    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = loft_real_from_raw(l.axis[i].max_speed);
        limits.max_accel[i] = loft_real_from_raw(l.axis[i].max_accel);
    }
    limits.corner = loft_real_from_raw(l.corner);
    limits.one_sided = LOFT_AXES > 2 ? 1 << 2 : 0;      /* as a machine plans */
    CHECK(loft_plan_init(&plan, &limits, ring, CURVES, ahead, KNOTS) == LOFT_OK);
    CHECK(loft_planner_init(&planner, &memory, CELLS) == LOFT_OK &&
          loft_planner_begin(&planner, &machine, &l, start) == LOFT_OK);
    for (unsigned n = 0; n < curves; n++)
        CHECK(loft_plan_push(&plan, &chain[n]) == LOFT_OK &&
              loft_planner_push(&planner, &items[n]) == LOFT_REFUSAL_NONE);
    loft_plan_end(&plan);
    CHECK(loft_planner_end(&planner) == LOFT_REFUSAL_NONE);
    while (given < SPANS && next_of(arb_below(a, 2), &got) && !check_bad) {
        state = loft_plan_next(&plan, &span);
        CHECK(state == LOFT_PLAN_SPAN && loft_item_from_span(&want, &span) == LOFT_OK);
        CHECK(want.ticks == got.ticks && memcmp(want.p, got.p, sizeof want.p) == 0);
        given++;
    }
    CHECK(given == SPANS ||
          (loft_planner_done(&planner) && loft_plan_next(&plan, &span) == LOFT_PLAN_REST));
}

/* The planner's limits are the lower of those of the machine and of the job. */
static void the_lower_limit_holds(arb *a)
{
    const loft_planner_memory memory = memory_of(8);
    const double line[2][4] = { { 0, 200, 400, 600 }, { 0, 0, 0, 0 } };
    double along[LOFT_AXES] = { 1 }, across[LOFT_AXES] = { 0 }, ticks = 0;
    const int which = (int)arb_below(a, 4);         /* who sets the speed, and the acceleration */
    int32_t start[LOFT_AXES];
    loft_item span;

    usual_limits();
    begin_chain();
    add_curve(along, across, line[0], line[1], 1000);
    make_job(start);
    loft_machine_info machine = info();
    loft_job_limits l   = asked();
    (which & 1 ? &machine.axis[0].max_speed : &l.axis[0].max_speed)[0] = 100 * 65536;
    (which & 2 ? &machine.axis[0].max_accel : &l.axis[0].max_accel)[0] = 200 * 65536;
    CHECK(loft_planner_init(&planner, &memory, CELLS) == LOFT_OK &&
          loft_planner_begin(&planner, &machine, &l, start) == LOFT_OK);
    CHECK(loft_planner_push(&planner, &items[0]) == LOFT_REFUSAL_NONE);
    CHECK(loft_planner_end(&planner) == LOFT_REFUSAL_NONE);
    while (next_of(false, &span))
        ticks += span.ticks;
    CHECK_NEAR(ticks, 6500, 65);                    /* 600 mm / 100 mm/s and 100 mm/s / 200 mm/s2,
                                                     * in ms */
}

/* A patch that is cut into lines along x, there and back. */
typedef struct {
    loft_patch_source source;
    unsigned left;
    loft_real from;
} lined;

static bool next_line(loft_patch_source *source, loft_cubic *out, uint16_t *feed)
{
    lined *const l = (lined *)source;
    const loft_real to = l->from > 0 ? 0 : LOFT_REAL(20), third = (to - l->from) / 3;

    if (l->left == 0) {
        source->state = LOFT_PATCH_OVER;
        return false;
    }
    *out = (loft_cubic){ { { { 0 } } } };
    out->p[0].axis[0] = l->from;
    out->p[1].axis[0] = l->from + third;
    out->p[2].axis[0] = to - third;
    out->p[3].axis[0] = l->from = to;
    *feed = 6000;
    l->left--;
    return true;
}

/* Asked while it is busy alone, it gives all that is left, with any room for curves. */
static void a_planner_is_busy_while_it_cuts(arb *a)
{
    lined patch = { { NULL, next_line, 32, LOFT_PATCH_NONE }, 1 + arb_below(a, 20), 0 };
    loft_planner_memory memory = memory_of((uint16_t)(4 + arb_below(a, 20)));
    int32_t start[LOFT_AXES] = { 0 };
    loft_item span = { .ticks = 0 };

    usual_limits();
    const loft_machine_info machine = info();
    const loft_job_limits l = asked();
    memory.patches = &patch.source;
    CHECK(loft_planner_init(&planner, &memory, CELLS) == LOFT_OK &&
          loft_planner_begin(&planner, &machine, &l, start) == LOFT_OK);
    patch.source.state = LOFT_PATCH_CUT;
    CHECK(loft_planner_end(&planner) == LOFT_REFUSAL_NONE);
    while (next_of(true, &span))
        CHECK(span.ticks > 0);
    CHECK(patch.left == 0 && loft_planner_done(&planner));
    CHECK(span.p[2][0] == loft_raw_from_real(patch.from));
}

static void impossible_jobs_are_refused(arb *a)
{
    loft_planner_memory memory = memory_of(8);
    int32_t start[LOFT_AXES] = { 0 };
    loft_item item = { .ticks = 0 };
    (void)a;

    usual_limits();
    const loft_machine_info machine = info();
    loft_job_limits l = asked();
    CHECK(loft_planner_init(&planner, &memory, CELLS) == LOFT_OK &&
          loft_planner_begin(&planner, &machine, &l, start) == LOFT_OK);
    CHECK(loft_planner_push(&planner, &item) == LOFT_REFUSAL_KIND);     /* a part of a patch */
    item.ticks = 600;
    item.p[2][0] = INT32_MAX;
    CHECK(loft_planner_push(&planner, &item) == LOFT_REFUSAL_ITEM && planner.taken == 0);
    l.axis[0].max_accel = 0;
    CHECK(loft_planner_begin(&planner, &machine, &l, start) == LOFT_ERR_ARG);
    l = asked();
    l.tol = 1;
    CHECK(loft_planner_begin(&planner, &machine, &l, start) == LOFT_ERR_RANGE);
    memory.move_room = 3;
    CHECK(loft_planner_init(&planner, &memory, CELLS) == LOFT_ERR_SPACE);
    memory.move_room = 8;
    memory.knot_room = LOFT_PLAN_KNOTS_MIN - 1;
    CHECK(loft_planner_init(&planner, &memory, CELLS) == LOFT_ERR_SPACE);
}


// A machine that plans
// --------------------

/* A machine for the chain. */
static void switch_on(const arb *a, uint16_t move_room)
{
    const loft_planner_memory plan = memory_of(move_room);

    limits.tick_hz = 1000;
    w.limits = asked();
    turn_on(a, &planner, &plan, items, curves);
}

/* Some curves of 1/2 to 6 mm from the origin. */
static void arb_drawing(arb *a)
{
    int32_t start[LOFT_AXES];

    usual_limits();
    limits.max_jerk[0] = 10000 * arb_below(a, 2);
    begin_chain();
    for (unsigned n = 3 + arb_below(a, 12); n > 0; n--)
        arb_curve(a, (enum kind)arb_below(a, POINT + 1), arb_between(a, 0.5, 6),
                  arb_between(a, 20, 150), arb_below(a, 2));
    make_job(start);
}

static void check_drawn(void)
{
    CHECK(w.sender.phase == LOFT_PHASE_DONE && w.sender.report.state == LOFT_STATE_DONE);
    CHECK(w.sender.report.items == curves && w.sender.report.job == w.job.id);
    for (int i = 0; i < LOFT_AXES; i++) {
        const int32_t end = loft_steps_of(loft_real_from_raw(items[curves - 1].p[2][i]),
                                          LOFT_REAL(80));
        CHECK(w.at[i] == end && w.sender.report.position[i] == end);
    }
}

/* The machine is no farther from the path than tolerance and steps allow. */
static void check_place(double from)
{
    double at[LOFT_AXES];
    unsigned chord = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        at[i] = w.at[i] / 80.0;
    CHECK_NEAR(path_distance(&track, &chord, at, from, track.length), 0,
               arb_value(limits.tol) + sqrt(LOFT_AXES) / 80);
}

/* Damage, holds and dead senders change the time of the pulses, but the path is not left, and all
 * of it is drawn. */
static void a_drawing_is_planned_and_drawn_whatever_happens(arb *a)
{
    uint32_t executed = 0;

    arb_drawing(a);
    path_trace(&track, chain, curves, 0.2);
    switch_on(a, CURVES);
    w.bend = arb_below(a, 2) ? arb_below(a, 200) : 0;
    while (w.sender.phase < LOFT_PHASE_DONE && w.ms < LONG && !check_bad) {
        const bool streams = w.sender.phase == LOFT_PHASE_STREAMING;
        go_on();
        CHECK(!streams || w.sender.phase != LOFT_PHASE_STREAMING ||
              w.sender.ack.executed >= executed);
        executed = w.sender.phase == LOFT_PHASE_STREAMING ? w.sender.ack.executed : 0;
        if (arb_below(a, 50) == 0)
            check_place(0);
        if (streams && arb_below(a, 400) == 0)
            loft_sender_control(&w.sender, arb_below(a, 2) ? LOFT_HOLD : LOFT_RESUME);
        if (w.machine.drive.state == LOFT_STATE_HELD && streams && arb_below(a, 100) == 0)
            loft_sender_control(&w.sender, LOFT_RESUME);
        if (streams && arb_below(a, 3000) == 0)
            dial();
    }
    check_drawn();
}

/* Small rings: the machine stops at the end of the known path, and still reaches the end. */
static void a_small_ring_draws_it_too(arb *a)
{
    arb_drawing(a);
    switch_on(a, (uint16_t)(4 + arb_below(a, 8)));
    finish();
    check_drawn();
}

/* An abort ends on the path, and no more items are reported than drawn. */
static void an_aborted_drawing_stands_on_the_path(arb *a)
{
    arb_drawing(a);
    path_trace(&track, chain, curves, 0.2);
    switch_on(a, CURVES);
    for (uint32_t ms = 50 + arb_below(a, 1500); ms > 0 && w.sender.phase <= LOFT_PHASE_STREAMING;
         ms--)
        go_on();
    if (w.sender.phase > LOFT_PHASE_STREAMING)
        return;
    loft_sender_control(&w.sender, LOFT_ABORT);
    finish();
    if (w.sender.phase == LOFT_PHASE_DONE)          /* it came too late */
        return;
    CHECK(w.sender.phase == LOFT_PHASE_ABORTED && w.sender.report.items <= curves);
    check_place(begin_of(w.sender.report.items));
}

/* The next job is independent of it. */
static void limits_that_are_impossible_refuse_the_job(arb *a)
{
    arb_drawing(a);
    switch_on(a, CURVES);
    w.limits.tol = 0;
    finish();
    CHECK(w.sender.phase == LOFT_PHASE_REFUSED && w.sender.refusal == LOFT_REFUSAL_LIMITS &&
          w.machine.drive.state == LOFT_STATE_IDLE);
    w.limits = asked();
    w.job.id++;
    dial();
    finish();
    check_drawn();
}

static void a_machine_without_a_planner_is_sent_no_curves(arb *a)
{
    arb_drawing(a);
    switch_on(a, CURVES);
    w.config = plain_machine();
    CHECK(loft_machine_init(&w.machine, &w.config) == LOFT_OK);
    while (w.sender.phase < LOFT_PHASE_READY && w.ms < LONG)
        go_on();
    CHECK(w.sender.machine.curves == 0 &&
          w.sender.machine.kinds == (1u << LOFT_SPANS | 1u << LOFT_POINTS | LOFT_TAKES_PLACES |
                                     LOFT_TAKES_TABLE | LOFT_TAKES_ACTIONS));
    CHECK(loft_sender_begin(&w.sender, &w.job, curves, source, NULL) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(curves_are_told_when_they_are_behind,           8);
    PROPERTY(the_spans_are_those_of_the_plan,                6);
    PROPERTY(the_lower_limit_holds,                          4);
    PROPERTY(a_planner_is_busy_while_it_cuts,                5);
    PROPERTY(impossible_jobs_are_refused,                    1);
    PROPERTY_LONG(a_drawing_is_planned_and_drawn_whatever_happens, 2);
    PROPERTY_LONG(a_small_ring_draws_it_too,                      2);
    PROPERTY(an_aborted_drawing_stands_on_the_path,          3);
    PROPERTY(limits_that_are_impossible_refuse_the_job,      1);
    PROPERTY(a_machine_without_a_planner_is_sent_no_curves,  1);
    return check_failures();
}

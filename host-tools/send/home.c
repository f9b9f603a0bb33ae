/* host-tools/send/home.c -- finds the switches of the axes, and leaves them
 * SPDX-License-Identifier: MIT
 *
 * Each axis is a sequence: it leaves its closed switch, seeks it, backs off, is squared if it has
 * two motors, touches the switch slowly some times, and is told where it is.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"           /* tool_s */
#include "send/home.h"

#define FILTER 10               /* ms: longer than contacts bounce */
#define AGAIN  2                /* how far to touch again, in home_back */
#define FREE   4                /* how far to back off from a closed switch, in home_back */

static host_place nowhere(void) { return (host_place){ .file = NULL }; }

static host_place port_of(const mover *v) { return (host_place){ .file = v->o.line.port }; }

static char name_of(const home *h) { return "xyz"[h->axis]; }

static const char *end_name(const home *h) { return h->sign < 0 ? "low" : "high"; }

static double back_of(const home *h) { return h->v->p.machine.home_back[h->axis]; }

static double touch_feed(const home *h) { return h->v->p.machine.home_touch[h->axis]; }

static double sign_of(const mover *v, int axis) { return v->p.machine.home_end[axis] > 0 ? 1 : -1; }

/* Of an axis with two motors both ends: one of each motor. */
static uint16_t own_of(const mover *v, int axis)
{
    const uint16_t ends = LOFT_INPUT_ENDS(axis), high = LOFT_INPUT_HIGH(axis);

    return v->p.machine.square[axis] > 0 ? ends
           : sign_of(v, axis) > 0        ? high
                                         : (uint16_t)(ends & ~high);
}

static void choose_axis(home *h, int axis)
{
    h->axis    = axis;
    h->sign    = sign_of(h->v, axis);
    h->own     = own_of(h->v, axis);
    h->other   = (uint16_t)(LOFT_INPUT_ENDS(axis) & ~h->own);
    h->from    = h->v->at[axis];
    h->touched = 0;
}

/* Move the axis by `by` mm, positive: towards the switch. */
static int move_axis(home *h, double by, double feed, const loft_guard *guard)
{
    mover *v     = h->v;
    mover_move m = { .feed = feed };

    memcpy(m.to, v->at, sizeof m.to);
    m.to[h->axis] += h->sign * by;
    m.away = v->t.sender.closed & LOFT_INPUT_ENDING;
    if (guard)
        m.guard = *guard;
    mover_go(v, &m);
    return 0;
}

/* The place and the closed inputs after a move. */
static int greet(void *context)
{
    home *h = context;

    if (h->v->t.sender.phase != LOFT_PHASE_READY)
        mover_ready(h->v);
    return 0;
}

static int check_machine(const mover *v)
{
    if (!(v->t.sender.machine.kinds & LOFT_TAKES_GUARDS))
        return host_error(v->host, EX_CONFIG, "home.no-guards", port_of(v),
                          "give it a newer firmware", "this machine cannot look for a switch");
    return 0;
}


// Parts of a sequence
// -------------------

/* Leave the closed switch, or one of those that are. A machine that does not report which end is
 * closed has one pin for both; the way is then away from the homing switch. */
static int leave(void *context)
{
    home *h                = context;
    const loft_guard opens = { h->own & h->v->t.sender.closed, LOFT_GUARD_OPENS, FILTER };

    h->v->out.how = MOVER_GUARDED;
    return opens.inputs ? move_axis(h, -FREE * back_of(h), touch_feed(h), &opens) : 0;
}

static int has_left(void *context)
{
    const home *h = context;

    return h->v->out.how != MOVER_ARRIVED
               ? 0
               : host_error(h->v->host, EX_UNAVAILABLE, "home.stays-closed", nowhere(),
                            "is it stuck, wired the other way, or does the motor turn the wrong "
                            "way?",
                            "%c: its switch at the %s end stays closed over %g mm", name_of(h),
                            end_name(h), FREE * back_of(h));
}

static int look_for(home *h, double distance, double feed)
{
    const uint16_t ends = h->own | (h->v->t.sender.closed & h->other ? 0 : h->other);
    const uint8_t how       = h->v->p.machine.hard_stop > 0 ? LOFT_GUARD_HARD : 0;
    const loft_guard closes = { ends, how, FILTER };

    return move_axis(h, distance, feed, &closes);
}

static int report_nothing(const home *h, double distance)
{
    char remedy[96];

    snprintf(remedy, sizeof remedy,
             "look at switch, wire and motor, or give a larger %c.home_search", name_of(h));
    return host_error(h->v->host, EX_UNAVAILABLE, "home.no-switch", nowhere(), remedy,
                      "%c: no switch at the %s end within %.6g mm", name_of(h), end_name(h),
                      distance);
}

static int report_other(const home *h)
{
    char remedy[96];

    snprintf(remedy, sizeof remedy, "the motor turns the wrong way, or give the other %c.home_end",
             name_of(h));
    return host_error(h->v->host, EX_UNAVAILABLE, "home.other-switch", nowhere(), remedy,
                      "%c: looking for the switch at the %s end, the other one closed", name_of(h),
                      end_name(h));
}

static int has_found(home *h, double distance)
{
    if (h->v->out.how == MOVER_ARRIVED)
        return report_nothing(h, distance);
    if (!(h->v->out.by & h->own))
        return report_other(h);
    h->found = h->v->out;
    return 0;
}

static double search_of(const home *h) { return machine_home_search(&h->v->p.machine, h->axis); }

static int seek(void *context)
{
    home *h = context;

    return look_for(h, search_of(h), h->v->p.machine.home_seek[h->axis]);
}

static int has_sought(void *context)
{
    home *h        = context;
    const int code = has_found(h, search_of(h));

    if (code == 0)
        h->way = fabs(h->found.latched[h->axis] - h->from);
    return code;
}

static int touch(void *context)
{
    home *h = context;

    return look_for(h, AGAIN * back_of(h), touch_feed(h));
}

static int has_touched(void *context)
{
    home *h        = context;
    const int code = has_found(h, AGAIN * back_of(h));

    for (int k = 0; k < LOFT_AXES && code == 0; k++) {
        const int32_t at = h->found.steps[k];
        h->least[k]      = h->touched == 0 || at < h->least[k] ? at : h->least[k];
        h->most[k]       = h->touched == 0 || at > h->most[k] ? at : h->most[k];
    }
    h->touched++;
    return code;
}

/* Back off from the switch that was found, to home_back before it. */
static int back_off(void *context)
{
    home *h             = context;
    const double beyond = h->sign * (h->v->at[h->axis] - h->found.latched[h->axis]);

    return move_axis(h, -(beyond + back_of(h)), h->v->p.machine.home_seek[h->axis], NULL);
}

static int is_off(void *context)
{
    const home *h = context;
    char remedy[96];

    if (!(h->v->t.sender.closed & h->own))
        return 0;
    snprintf(remedy, sizeof remedy, "is it stuck? or give a larger %c.home_back", name_of(h));
    return host_error(h->v->host, EX_UNAVAILABLE, "home.closed-before", nowhere(), remedy,
                      "%c: its switch at the %s end stays closed %g mm before it", name_of(h),
                      end_name(h), back_of(h));
}

/* Say where the tool is: the switch, where it was latched, is at its place. */
static int place(void *context)
{
    home *h = context;
    double at[ENGINE_AXES];

    memcpy(at, h->v->at, sizeof at);
    const double moved = machine_home_at(&h->v->p.machine, h->axis) - h->found.latched[h->axis];
    at[h->axis] += moved;
    h->found.latched[h->axis] += at[h->axis] - h->v->at[h->axis];
    mover_place(h->v, 1u << h->axis, at);
    return 0;
}

static int forget_table(void *context)
{
    home *h = context;

    mover_table(h->v, h->axis, false);
    return 0;
}

static int tell_table(void *context)
{
    home *h = context;

    mover_table(h->v, h->axis, true);
    return 0;
}

static int tell_axis(void *context)
{
    const home *h = context;
    int spread    = 0;

    for (int k = 0; k < LOFT_AXES; k++)
        spread = h->most[k] - h->least[k] > spread ? h->most[k] - h->least[k] : spread;
    send_tell(&h->to, SEND_RESULT,
              "%c: its switch at the %s end, after %.3f mm, is at %.3f: %u touch%s within %d "
              "step%s",
              name_of(h), end_name(h), h->way, machine_home_at(&h->v->p.machine, h->axis),
              h->touches, h->touches == 1 ? "" : "es", spread, tool_s((size_t)spread));
    return 0;
}


// Two motors on an axis
// ---------------------

/* Touch the switches with both motors: each stops at its own, at most home_back after the other. */
static int stop_motors(void *context)
{
    home *h                 = context;
    const loft_guard square = { h->own, LOFT_GUARD_SQUARE | LOFT_GUARD_HARD, FILTER };

    if (!(h->v->t.sender.machine.kinds & LOFT_TAKES_TABLE))
        return host_error(h->v->host, EX_CONFIG, "home.no-squares", port_of(h->v),
                          "give it a newer firmware", "this machine cannot square an axis");
    h->first = h->found.steps[h->axis];
    return move_axis(h, AGAIN * back_of(h), touch_feed(h), &square);
}

static int have_stopped(void *context)
{
    home *h = context;
    char remedy[96];

    if (h->v->out.how == MOVER_ARRIVED) {
        snprintf(remedy, sizeof remedy,
                 "turn one by hand with the power off, or give a larger %c.home_back", name_of(h));
        return host_error(h->v->host, EX_UNAVAILABLE, "home.not-square", nowhere(), remedy,
                          "%c: its two motors differ by more than %g mm, or a switch is stuck",
                          name_of(h), back_of(h));
    }
    h->found  = h->v->out;
    h->before = h->after;
    h->after  = labs((long)h->found.steps[h->axis] - h->first);
    return 0;
}

static int tell_square(void *context)
{
    const home *h = context;

    send_tell(&h->to, SEND_RESULT,
              "%c: squared: its switches close within %ld step%s of each other, before %ld",
              name_of(h), h->after, tool_s((size_t)h->after), h->before);
    return 0;
}


// Motors that are not axes
// ------------------------

/* The switches of a delta and of a polar machine are those of its motors. */
static bool by_motors(const mover *v) { return !v->p.machine.k.kind->linear; }

static int report_motor(const home *h, int axis)
{
    char remedy[128];

    snprintf(remedy, sizeof remedy,
             "give %c.home_at, where it is, and %c.home_search, how far it is at most, in its mm",
             "abc"[axis], "abc"[axis]);
    return host_error(h->v->host, EX_CONFIG, "home.of-a-motor", nowhere(), remedy,
                      "kinematics = %s: the switch is one of motor %c",
                      kinematics_name(&h->v->p.machine.k), "abc"[axis]);
}

static int check_motors(const home *h)
{
    const machine_file *m = &h->v->p.machine;

    if (!m->k.kind->lifts && !(h->wanted[0] && h->wanted[1] && h->wanted[2]))
        return host_error(h->v->host, EX_CONFIG, "home.together", nowhere(),
                          "name no axis, and give home_order = 1",
                          "kinematics = %s: its three carriages are homed together",
                          kinematics_name(&m->k));
    for (int i = 0; i < ENGINE_AXES; i++)
        if (h->wanted[i] && (isnan(m->home_at[i]) || !(m->home_search[i] > 0)))
            return report_motor(h, i);
    return 0;
}

/* The machine of which each motor is an axis. */
static int as_axes(void *context)
{
    home *h  = context;
    mover *v = h->v;

    h->kept             = v->p.machine;
    h->motors           = true;
    v->p.machine.k.kind = &kinematics_cartesian;
    memset(v->p.machine.travel, 0, sizeof v->p.machine.travel);
    memset(v->p.machine.zero, 0, sizeof v->p.machine.zero);
    mover_ready(v);
    return 0;
}

static void restore(home *h)
{
    if (h->motors)
        h->v->p.machine = h->kept;
    h->motors = false;
}

static int as_motors(void *context)
{
    home *h = context;

    restore(h);
    mover_ready(h->v);
    return 0;
}

/* The least of all axes; of carriages that move together. */
static double least_of(const double of[ENGINE_AXES]) { return fmin(of[0], fmin(of[1], of[2])); }

/* Move the carriages of a delta to the first switch, all by the same way. */
static int raise_carriages(void *context)
{
    home *h               = context;
    mover *v              = h->v;
    const machine_file *m = &v->p.machine;
    mover_move move       = { .feed  = least_of(m->home_seek) * sqrt(ENGINE_AXES),
                              .guard = { 0, 0, FILTER } };

    v->out.how = MOVER_GUARDED;
    for (int i = 0; i < ENGINE_AXES; i++) {
        move.guard.inputs |= own_of(v, i);
        move.to[i] = v->at[i] + sign_of(v, i) * least_of(m->home_search);
    }
    if (!(v->t.sender.closed & move.guard.inputs))
        mover_go(v, &move);
    return 0;
}

static int have_risen(void *context)
{
    const home *h = context;

    return h->v->out.how != MOVER_ARRIVED
               ? 0
               : host_error(h->v->host, EX_UNAVAILABLE, "home.no-carriage", nowhere(),
                            "look at switches, wires and motors, or give a larger home_search",
                            "no carriage found its switch within %.6g mm",
                            least_of(h->v->p.machine.home_search));
}


// Homing
// ------

static void add_back(sequence *q)
{
    sequence_add(q, back_off, NULL);
    sequence_add(q, greet, is_off);
}

static void add_found(sequence *q, sequence_call *begin, sequence_call *end)
{
    sequence_add(q, begin, end);
    sequence_add(q, greet, NULL);
}

/* With one more look for the first switch between the two. */
static void add_square(sequence *q)
{
    add_found(q, stop_motors, have_stopped);
    add_back(q);
    add_found(q, touch, has_touched);
    add_back(q);
    add_found(q, stop_motors, have_stopped);
    add_back(q);
    sequence_add(q, NULL, tell_square);
}

static int check_search(void *context)
{
    const home *h = context;

    return search_of(h) > 0 ? 0
                            : host_error(h->v->host, EX_CONFIG, "home.no-search", nowhere(), NULL,
                                         "%c: how far is its switch at most? give %c.travel, or "
                                         "%c.home_search, in the machine file",
                                         name_of(h), name_of(h), name_of(h));
}

static int begin_touches(void *context)
{
    home *h = context;

    h->touched = 0;
    return 0;
}

static void add_axis(home *h)
{
    sequence *q = &h->q;

    sequence_begin(q, h->v, h);
    sequence_add(q, check_search, NULL);
    sequence_add(q, forget_table, NULL);
    for (int motor = 0; motor < 2; motor++)
        add_found(q, leave, has_left);
    add_found(q, seek, has_sought);
    add_back(q);
    if (h->v->p.machine.square[h->axis] > 0)
        add_square(q);
    sequence_add(q, begin_touches, NULL);
    for (unsigned i = 0; i < h->touches; i++) {
        if (i > 0)
            add_back(q);
        add_found(q, touch, has_touched);
    }
    sequence_add(q, place, NULL);
    sequence_add(q, tell_table, NULL);
    add_back(q);
    sequence_add(q, NULL, tell_axis);
}

static int tell_homed(void *context)
{
    const home *h = context;
    char text[96];

    if (h->all)
        talk_placed(&h->v->t, ~0u);     /* also those that find no switch, as a servo */
    send_tell(&h->to, SEND_RESULT, "homed: the tool is at %s", mover_text(h->v->at, text));
    return 0;
}

/* The axes in their order; without an order, those that are asked for come last. Returns whether
 * there is anything else to do. */
static bool go_on(home *h)
{
    if (h->over)
        return false;
    for (int order = 1; order <= 4; order++)
        for (int i = 0; i < ENGINE_AXES; i++) {
            const double own = h->v->p.machine.home_order[i];
            if (!h->wanted[i] || (own > 0 ? own : 4) != order)
                continue;
            h->wanted[i] = false;
            choose_axis(h, i);
            add_axis(h);
            return true;
        }
    h->over = true;
    sequence_begin(&h->q, h->v, h);
    if (h->motors)
        sequence_add(&h->q, as_motors, NULL);
    sequence_add(&h->q, NULL, tell_homed);
    return true;
}

static int check_axes(void *context)
{
    home *h  = context;
    bool any = !h->all;

    for (int i = 0; i < ENGINE_AXES && h->all; i++)
        any = (h->wanted[i] = h->v->p.machine.home_order[i] > 0) || any;
    if (!any)
        return host_error(h->v->host, EX_CONFIG, "home.no-axis", nowhere(),
                          "give z.home_order = 1, x.home_order = 2 .. in the machine file",
                          "no axis has a switch for homing");
    const int code = by_motors(h->v) ? check_motors(h) : 0;
    if (code != 0)
        return code;
    if (by_motors(h->v)) {
        sequence_add(&h->q, as_axes, NULL);
        if (!h->v->p.machine.k.kind->lifts)
            add_found(&h->q, raise_carriages, have_risen);
    }
    return 0;
}

static int check_guards(void *context) { return check_machine(((const home *)context)->v); }

static void begin(home *h, mover *v, const send_teller *to)
{
    *h = (home){ .v = v, .to = *to };
    sequence_begin(&h->q, v, h);
}

void home_begin(home *h, mover *v, const bool axis[ENGINE_AXES], unsigned touches,
                const send_teller *to)
{
    begin(h, v, to);
    h->touches = touches;
    h->all     = axis == NULL;
    if (axis != NULL)
        memcpy(h->wanted, axis, sizeof h->wanted);
    sequence_add(&h->q, check_axes, NULL);
    sequence_add(&h->q, check_guards, NULL);
}

int home_step(home *h, double now, task_wants *w)
{
    int code;

    do
        code = sequence_step(&h->q, now, w);
    while (code == 0 && go_on(h));
    if (code != TASK_GOES)
        restore(h);
    return code;
}

static int step_home(void *context, double now, task_wants *w)
{
    return home_step(context, now, w);
}

task home_task(home *h) { return (task){ step_home, h, &h->v->t.stop }; }


// Unlocking
// ---------

static int check_closed(void *context)
{
    home *h  = context;
    mover *v = h->v;
    int code = check_machine(v);

    if (code == 0 && by_motors(v))
        code = host_error(v->host, EX_CONFIG, "unlock.of-motors", nowhere(),
                          "`loft home` leads them away",
                          "kinematics = %s: its switches are those of the motors",
                          kinematics_name(&v->p.machine.k));
    if (code == 0 && (v->t.sender.closed & LOFT_INPUT_ENDING) == 0) {
        send_tell(&h->to, SEND_RESULT, "no switch is closed: the machine is free");
        h->q.count = 1;
    }
    if (code == 0 && v->t.sender.closed & LOFT_INPUT_STOP)
        code = host_error(v->host, EX_UNAVAILABLE, "unlock.emergency-stop", port_of(v), "open it",
                          "the emergency stop is closed");
    return code;
}

static int report_which(const home *h, uint16_t ends)
{
    char text[256], remedy[64];

    snprintf(remedy, sizeof remedy, "name the way out, as `loft unlock %c+`", name_of(h));
    return host_error(h->v->host, EX_UNAVAILABLE, "unlock.which-end", port_of(h->v), remedy,
                      "%s is closed, at which end is not known", talk_inputs(ends, text));
}

/* The next axis. */
static int lead_out(void *context)
{
    home *h             = context;
    const int i         = (h->axis = (int)h->touched++);
    const uint16_t ends = h->v->t.sender.closed & LOFT_INPUT_ENDS(i);

    h->v->out.how = MOVER_GUARDED;
    if (ends == 0)
        return 0;
    if (ends == LOFT_INPUT_ENDS(i) && h->out != i)
        return report_which(h, ends);
    h->sign = h->out == i ? -h->out_sign : ends == LOFT_INPUT_LOW(i) ? -1 : 1;
    h->own  = ends;
    return leave(h);
}

static int tell_free(void *context)
{
    const home *h = context;
    const mover *v = h->v;
    char text[256], at[96];

    if (v->t.sender.closed & LOFT_INPUT_ENDING)
        return host_error(v->host, EX_UNAVAILABLE, "unlock.still-closed", port_of(v), NULL,
                          "%s is still closed", talk_inputs(v->t.sender.closed, text));
    send_tell(&h->to, SEND_RESULT, "free: the tool is at %s", mover_text(v->at, at));
    return 0;
}

void home_unlock(home *h, mover *v, int out, double sign, const send_teller *to)
{
    begin(h, v, to);
    h->over     = true;
    h->out      = out;
    h->out_sign = sign;
    sequence_add(&h->q, check_closed, NULL);
    for (int i = 0; i < ENGINE_AXES; i++)
        add_found(&h->q, lead_out, has_left);
    sequence_add(&h->q, NULL, tell_free);
}

/* host-tools/cmd/cmd_home.c -- loft home, loft unlock: finds the switches of the axes, and leaves
 * them
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "cmd/run_move.h"       /* run_mover, run_go */

#define WAYS "x-|x+|y-|y+|z-|z+"
#define FILTER 10               /* ms: longer than contacts bounce */
#define AGAIN  2                /* how far to touch again, in home_back */
#define FREE   4                /* how far to back off from a closed switch, in home_back */

/* One axis and its switch. */
typedef struct {
    mover *v;
    int axis;
    double sign;                /* towards the switch */
    uint16_t own, other;        /* the inputs at this end and at the other; with two motors `own`
                                 * are both, one of each */
} homing;

static const char *end_name(const homing *h) { return h->sign < 0 ? "low" : "high"; }

static double back_of(const homing *h) { return h->v->p.machine.home_back[h->axis]; }

static homing homing_of(mover *v, int axis)
{
    const bool high = v->p.machine.home_end[axis] > 0;
    const uint16_t low_end = LOFT_INPUT_LOW(axis), high_end = LOFT_INPUT_HIGH(axis);

    if (v->p.machine.square[axis] > 0)
        return (homing){ v, axis, high ? 1 : -1, LOFT_INPUT_ENDS(axis), 0 };
    return (homing){ v, axis, high ? 1 : -1, high ? high_end : low_end, high ? low_end : high_end };
}

/* Move the axis by `by` mm, positive: towards the switch. */
static int move_axis(const homing *h, double by, double feed, const loft_guard *guard,
                     mover_outcome *out)
{
    mover *v     = h->v;
    mover_move m = { .feed = feed };

    memcpy(m.to, v->at, sizeof m.to);
    m.to[h->axis] += h->sign * by;
    m.away = v->t.sender.closed & LOFT_INPUT_ENDING;
    if (guard)
        m.guard = *guard;
    return run_go(v, &m, out);
}

/* Leave the closed switch, or one of those that are. A machine that does not report which end is
 * closed has one pin for both; the way is then away from the homing switch. */
static int leave_switch(const homing *h)
{
    const loft_guard opens = { h->own & h->v->t.sender.closed, LOFT_GUARD_OPENS, FILTER };
    const double most      = FREE * back_of(h);
    mover_outcome out;
    int code = move_axis(h, -most, h->v->p.machine.home_touch[h->axis], &opens, &out);

    if (code == 0 && out.how == MOVER_ARRIVED)
        code = tool_error(
            EX_UNAVAILABLE,
            "%c: its switch at the %s end stays closed over %g mm: is it stuck, wired "
            "the other way, or does the motor turn the wrong way?",
            "xyz"[h->axis], end_name(h), most);
    return code ? code : run_ready(h->v);
}

static int look_for(const homing *h, double distance, double feed, mover_outcome *out)
{
    const uint16_t ends = h->own | (h->v->t.sender.closed & h->other ? 0 : h->other);
    const uint8_t how       = h->v->p.machine.hard_stop > 0 ? LOFT_GUARD_HARD : 0;
    const loft_guard closes = { ends, how, FILTER };
    int code = move_axis(h, distance, feed, &closes, out);

    if (code == 0 && out->how == MOVER_ARRIVED)
        code = tool_error(EX_UNAVAILABLE,
                          "%c: no switch at the %s end within %.6g mm: look at switch, wire and "
                          "motor, or give a larger %c.home_search",
                          "xyz"[h->axis], end_name(h), distance, "xyz"[h->axis]);
    else if (code == 0 && !(out->by & h->own))
        code = tool_error(
            EX_UNAVAILABLE,
            "%c: looking for the switch at the %s end, the other one closed: the motor "
            "turns the wrong way, or give the other %c.home_end",
            "xyz"[h->axis], end_name(h), "xyz"[h->axis]);
    return code ? code : run_ready(h->v);
}

/* Back off from the switch that was found at `out`, to `back` mm before it. */
static int back_off(const homing *h, const mover_outcome *out)
{
    const double beyond = h->sign * (h->v->at[h->axis] - out->latched[h->axis]);
    mover_outcome moved;
    int code = move_axis(h, -(beyond + back_of(h)), h->v->p.machine.home_seek[h->axis], NULL,
                         &moved);

    if (code == 0)
        code = run_ready(h->v);
    if (code == 0 && h->v->t.sender.closed & h->own)
        code = tool_error(EX_UNAVAILABLE,
                          "%c: its switch at the %s end stays closed %g mm before it: is it stuck? "
                          "or give a larger %c.home_back",
                          "xyz"[h->axis], end_name(h), back_of(h), "xyz"[h->axis]);
    return code;
}

/* Touch the switch `times` times. *spread: the steps between the first and the last place. */
static int touch_switch(const homing *h, unsigned times, mover_outcome *out, int *spread)
{
    const double feed = h->v->p.machine.home_touch[h->axis];
    int32_t least[LOFT_AXES], most[LOFT_AXES];
    int code = 0;

    for (unsigned i = 0; i < times && code == 0; i++) {
        if (i > 0)
            code = back_off(h, out);
        if (code == 0)
            code = look_for(h, AGAIN * back_of(h), feed, out);
        for (int k = 0; k < LOFT_AXES && code == 0; k++) {
            least[k] = i == 0 || out->steps[k] < least[k] ? out->steps[k] : least[k];
            most[k]  = i == 0 || out->steps[k] > most[k] ? out->steps[k] : most[k];
            *spread  = most[k] - least[k] > *spread ? most[k] - least[k] : *spread;
        }
    }
    return code;
}

// Two motors on an axis
// ---------------------

/* Touch the switches with both motors: each stops at its own, at most home_back after the other. */
static int stop_motors(const homing *h, mover_outcome *out)
{
    const loft_guard square = { h->own, LOFT_GUARD_SQUARE | LOFT_GUARD_HARD, FILTER };
    const machine_file *m   = &h->v->p.machine;
    const char name         = "xyz"[h->axis];

    if (!(h->v->t.sender.machine.kinds & LOFT_TAKES_TABLE))
        return tool_error(EX_CONFIG,
                          "%s: this machine cannot square an axis: give it a newer firmware",
                          h->v->o.line.port);
    int code = move_axis(h, AGAIN * back_of(h), m->home_touch[h->axis], &square, out);
    if (code == 0 && out->how == MOVER_ARRIVED)
        code = tool_error(
            EX_UNAVAILABLE,
            "%c: its two motors differ by more than %g mm, or a switch is stuck: turn "
            "one by hand with the power off, or give a larger %c.home_back",
            name, back_of(h), name);
    return code ? code : run_ready(h->v);
}

/* Both motors touch their switches, once more. *apart: the steps between the first and the last of
 * them; the first one closed at `first`. */
static int close_both(const homing *h, int32_t first, mover_outcome *out, long *apart)
{
    int code = stop_motors(h, out);

    *apart = code == 0 ? labs((long)out->steps[h->axis] - first) : 0;
    return code ? code : back_off(h, out);
}

/* `found`: where the first of two switches closed. */
static int square_axis(const homing *h, const mover_outcome *found)
{
    const double feed = h->v->p.machine.home_touch[h->axis];
    long before, after;
    mover_outcome out;
    int code = close_both(h, found->steps[h->axis], &out, &before);

    if (code == 0)
        code = look_for(h, AGAIN * back_of(h), feed, &out);
    const int32_t first = out.steps[h->axis];
    if (code == 0)
        code = back_off(h, &out);
    if (code == 0)
        code = close_both(h, first, &out, &after);
    if (code == 0)
        printf("%c: squared: its switches close within %ld step%s of each other, before %ld\n",
               "xyz"[h->axis], after, tool_s((size_t)after), before);
    return code;
}

/* Say where the tool is: the switch, where it was latched, is at its place. */
static int set_axis(const homing *h, const mover_outcome *out)
{
    double at[ENGINE_AXES];

    memcpy(at, h->v->at, sizeof at);
    at[h->axis] += machine_home_at(&h->v->p.machine, h->axis) - out->latched[h->axis];
    const double moved = at[h->axis] - h->v->at[h->axis];
    int code           = run_place(h->v, 1u << h->axis, at);
    mover_outcome now  = *out;
    now.latched[h->axis] += moved;
    if (code == 0)
        code = run_table(h->v, h->axis, true);
    return code ? code : back_off(h, &now);
}

static int home_axis(mover *v, int axis, unsigned touches)
{
    const homing h        = homing_of(v, axis);
    const machine_file *m = &v->p.machine;
    const double search   = machine_home_search(m, axis), from = v->at[axis];
    mover_outcome out;
    int spread = 0, code = 0;

    if (!(search > 0))
        return tool_error(
            EX_CONFIG,
            "%c: how far is its switch at most? give %c.travel, or %c.home_search, in "
            "the machine file",
            "xyz"[axis], "xyz"[axis], "xyz"[axis]);
    code = run_table(v, axis, false);
    for (int motor = 0; motor < 2 && code == 0 && v->t.sender.closed & h.own; motor++)
        code = leave_switch(&h);
    if (code == 0)
        code = look_for(&h, search, m->home_seek[axis], &out);
    const double way = code == 0 ? fabs(out.latched[axis] - from) : 0;
    if (code == 0)
        code = back_off(&h, &out);
    if (code == 0 && m->square[axis] > 0)
        code = square_axis(&h, &out);
    if (code == 0)
        code = touch_switch(&h, touches, &out, &spread);
    if (code == 0)
        code = set_axis(&h, &out);
    if (code == 0)
        printf("%c: its switch at the %s end, after %.3f mm, is at %.3f: %u touch%s within %d "
               "step%s\n",
               "xyz"[axis], end_name(&h), way, machine_home_at(m, axis), touches,
               touches == 1 ? "" : "es", spread, tool_s((size_t)spread));
    fflush(stdout);
    return code;
}

// Motors that are not axes
// ------------------------

/* The switches of a delta and of a polar machine are those of its motors. */
static bool by_motors(const mover *v) { return !v->p.machine.k.kind->linear; }

static int check_motors(const mover *v, const bool axis[ENGINE_AXES])
{
    const machine_file *m = &v->p.machine;

    if (!m->k.kind->lifts && !(axis[0] && axis[1] && axis[2]))
        return tool_error(
            EX_CONFIG,
            "kinematics = %s: its three carriages are homed together: name no axis, and give "
            "home_order = 1",
            kinematics_name(&m->k));
    for (int i = 0; i < ENGINE_AXES; i++)
        if (axis[i] && (isnan(m->home_at[i]) || !(m->home_search[i] > 0)))
            return tool_error(
                EX_CONFIG,
                "kinematics = %s: the switch is one of motor %c: give %c.home_at, where "
                "it is, and %c.home_search, how far it is at most, in its mm",
                kinematics_name(&m->k), "abc"[i], "abc"[i], "abc"[i]);
    return 0;
}

/* Move the carriages of a delta to the first switch, all by the same way. */
static int raise_carriages(mover *v)
{
    const machine_file *m = &v->p.machine;
    loft_guard closes     = { 0, 0, FILTER };
    double way = m->home_search[0], feed = m->home_seek[0];
    mover_move move;
    mover_outcome out;

    for (int i = 0; i < ENGINE_AXES; i++) {
        closes.inputs |= homing_of(v, i).own;
        way  = fmin(way, m->home_search[i]);
        feed = fmin(feed, m->home_seek[i]);
    }
    if (v->t.sender.closed & closes.inputs)
        return 0;
    move = (mover_move){ .feed = feed * sqrt(ENGINE_AXES), .guard = closes };
    for (int i = 0; i < ENGINE_AXES; i++)
        move.to[i] = v->at[i] + homing_of(v, i).sign * way;
    const int code = run_go(v, &move, &out);
    if (code == 0 && out.how == MOVER_ARRIVED)
        return tool_error(
            EX_UNAVAILABLE,
            "no carriage found its switch within %.6g mm: look at switches, wires and "
            "motors, or give a larger home_search",
            way);
    return code ? code : run_ready(v);
}

static int home_axes(mover *v, const bool axis[ENGINE_AXES], unsigned touches);

/* Motors are moved as if they were axes; then the tool is where they have it. */
static int home_motors(mover *v, const bool axis[ENGINE_AXES], unsigned touches)
{
    const machine_file kept = v->p.machine;
    int code = check_motors(v, axis);

    if (code != 0)
        return code;
    v->p.machine.k.kind = &kinematics_cartesian;
    memset(v->p.machine.travel, 0, sizeof v->p.machine.travel);
    memset(v->p.machine.zero, 0, sizeof v->p.machine.zero);
    code = run_ready(v);
    if (code == 0 && !kept.k.kind->lifts)
        code = raise_carriages(v);
    if (code == 0)
        code = home_axes(v, axis, touches);
    v->p.machine = kept;
    return code ? code : run_ready(v);
}

static int check_machine(const mover *v)
{
    if (!(v->t.sender.machine.kinds & LOFT_TAKES_GUARDS))
        return tool_error(EX_CONFIG,
                          "%s: this machine cannot look for a switch: give it a newer firmware",
                          v->o.line.port);
    return 0;
}

/* The axes in their order; without an order, those that are asked for come last. */
static int home_axes(mover *v, const bool axis[ENGINE_AXES], unsigned touches)
{
    int code = check_machine(v);

    for (int order = 1; order <= 4 && code == 0; order++)
        for (int i = 0; i < ENGINE_AXES && code == 0; i++) {
            const double own = v->p.machine.home_order[i];
            if (axis[i] && (own > 0 ? own : 4) == order)
                code = home_axis(v, i, touches);
        }
    return code;
}

/* The axes of the machine file or of the machine's settings. */
static int choose_axes(const mover *v, bool axis[ENGINE_AXES])
{
    bool any = false;

    for (int i = 0; i < ENGINE_AXES; i++)
        any = (axis[i] = v->p.machine.home_order[i] > 0) || any;
    return any ? 0
               : tool_error(EX_CONFIG, "no axis has a switch for homing: give z.home_order = 1, "
                                       "x.home_order = 2 .. in the machine file");
}

typedef struct {
    mover_options move;
    const char *axes;           /* NULL: those with a place in the order */
    unsigned touches;
} home_options;

static const option home_rows[] = { { "axes", OPTION_WORD(home_options, axes), .value = "AXES",
      .remedy = "name the axes in one word, as xy" },
    OPTION_GROUP(home_options, move, mover_rows),
                                    { "touches", OPTION_INTEGER(home_options, touches), .least = 1,
                                      .most = 20, .value = "N", .standard = "2",
                                      .help = "how often each switch is touched slowly" },
                                    { 0 } };

static int run_home(void *options)
{
    const home_options *o  = options;
    bool axis[ENGINE_AXES] = { false };
    char text[96];
    mover v  = { .at = { 0 } };
    int code = o->axes ? mover_axes(o->axes, axis) : 0;

    if (code == 0)
        code = run_mover(&v, &o->move, false);
    if (code == 0 && o->axes == NULL)
        code = choose_axes(&v, axis);
    if (code == 0)
        code = by_motors(&v) ? home_motors(&v, axis, o->touches) : home_axes(&v, axis, o->touches);
    if (code == 0 && o->axes == NULL)
        talk_placed(&v.t, ~0u);         /* also those that find no switch, as a servo */
    if (code == 0)
        printf("homed: the tool is at %s\n", mover_text(v.at, text));
    mover_close(&v);
    return code;
}

const command command_home = {
    .name = "home",
    .arguments = "[AXES] --port PORT",
    .summary = "find the switches of the axes, and know where the tool is",
    .detail = "AXES are letters, as xy or z; without them those with a home_order in the machine "
              "file, in\n"
              "this order. Each axis seeks its switch, backs off, touches it slowly, and is then "
              "home_back\n"
        "before it. Guard the first run with a hand at the power switch.\n",
    .options = home_rows,
    .size = sizeof(home_options),
    .run = run_home,
    .talks = true,
};


// Unlock
// ------

/* `x+`: away from the switch is plus. */
static int unlock_axis(mover *v, int axis, double sign)
{
    const uint16_t ends = v->t.sender.closed & LOFT_INPUT_ENDS(axis);
    const homing h = { v, axis, -sign, ends, 0 };

    return leave_switch(&h);
}

static int unlock_axes(mover *v, int axis, double sign)
{
    char text[256], at[96];
    int code = check_machine(v);

    if (code == 0 && by_motors(v))
        return tool_error(
            EX_CONFIG,
            "kinematics = %s: its switches are those of the motors: `loft home` leads "
            "them away",
            kinematics_name(&v->p.machine.k));

    if (code == 0 && (v->t.sender.closed & LOFT_INPUT_ENDING) == 0) {
        printf("no switch is closed: the machine is free\n");
        return 0;
    }
    if (code == 0 && v->t.sender.closed & LOFT_INPUT_STOP)
        return tool_error(EX_UNAVAILABLE, "%s: the emergency stop is closed: open it",
                          v->o.line.port);
    for (int i = 0; i < ENGINE_AXES && code == 0; i++) {
        const uint16_t ends = v->t.sender.closed & LOFT_INPUT_ENDS(i);
        if (ends == 0)
            continue;
        if (ends == LOFT_INPUT_ENDS(i) && axis != i)
            return tool_error(EX_UNAVAILABLE,
                              "%s: %s is closed, at which end is not known: name the way out, as "
                              "`loft unlock %c+`",
                              v->o.line.port, talk_inputs(ends, text), "xyz"[i]);
        code = unlock_axis(v, i, axis == i ? sign : ends == LOFT_INPUT_LOW(i) ? 1 : -1);
    }
    if (code == 0 && v->t.sender.closed & LOFT_INPUT_ENDING)
        return tool_error(EX_UNAVAILABLE, "%s: %s is still closed", v->o.line.port,
                          talk_inputs(v->t.sender.closed, text));
    if (code == 0)
        printf("free: the tool is at %s\n", mover_text(v->at, at));
    return code;
}

typedef struct {
    mover_options move;
    const char *way;            /* "x+", or NULL */
} unlock_options;

static const option unlock_rows[] = { { "way", OPTION_WORD(unlock_options, way), .value = "AXIS+",
                                        .choices = WAYS,
      .remedy = "name one way out, as x+ or y-" },
    OPTION_GROUP(unlock_options, move, mover_rows),
                                      { 0 } };

static int run_unlock(void *options)
{
    const unlock_options *o = options;
    mover v                 = { .at = { 0 } };
    int code                = run_mover(&v, &o->move, false);

    if (code == 0)
        code = unlock_axes(&v, o->way ? o->way[0] - 'x' : -1, o->way && o->way[1] == '-' ? -1 : 1);
    mover_close(&v);
    return code;
}

const command command_unlock = {
    .name = "unlock",
    .arguments = "[AXIS+|AXIS-] --port PORT",
    .summary = "lead the tool away from a closed limit switch",
    .detail = "Where one switch serves both ends of its axis, name the way out, as x+. It moves "
              "slowly, at\n"
        "most four times home_back, and ends where the switch has opened.\n",
    .options = unlock_rows,
    .size = sizeof(unlock_options),
    .run = run_unlock,
    .talks = true,
};

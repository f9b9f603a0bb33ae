/* host-tools/cmd/cmd_probe.c -- loft probe: moves until the probe touches something
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmd/commands.h"
#include "cmd/run_move.h"       /* run_mover, run_go */

#define FILTER 10               /* ms: longer than contacts bounce */

typedef struct {
    mover v;
    int axis;
    double sign, within, feed, back, at;
} probing;

/* Leave the surface by `back` mm. */
static int back_off(probing *p, const double touched[ENGINE_AXES])
{
    mover_move m = { .feed = p->feed };
    mover_outcome out;

    memcpy(m.to, p->v.at, sizeof m.to);
    m.to[p->axis] = touched[p->axis] - p->sign * p->back;
    return run_go(&p->v, &m, &out);
}

static int probe_it(probing *p)
{
    mover *v               = &p->v;
    mover_move m           = { .feed = p->feed };
    const loft_guard touch = { LOFT_INPUT_PROBE, 0, FILTER };
    mover_outcome out;
    char text[96];

    if (!(v->t.sender.machine.kinds & LOFT_TAKES_GUARDS))
        return tool_error(EX_CONFIG, "%s: this machine cannot probe: give it a newer firmware",
                          v->o.line.port);
    if (v->t.sender.closed & LOFT_INPUT_PROBE)
        return tool_error(EX_UNAVAILABLE,
                          "%s: the probe touches already: move it away, or look at its wire",
                          v->o.line.port);
    memcpy(m.to, v->at, sizeof m.to);
    m.to[p->axis] += p->sign * p->within;
    m.guard = touch;
    int code = mover_free(v, m.to);
    if (code == 0)
        code = run_go(v, &m, &out);
    if (code == 0 && out.how != MOVER_GUARDED)
        code = tool_error(EX_UNAVAILABLE,
                          "%s: the probe has touched nothing within %g mm; the tool is at %s: give "
                          "more --within, or look at its wire",
                          v->o.line.port, p->within, mover_text(v->at, text));
    if (code == 0 && !isnan(p->at)) {
        double now[ENGINE_AXES];
        const double by = p->at - out.latched[p->axis];
        memcpy(now, v->at, sizeof now);
        now[p->axis] += by;
        out.latched[p->axis] = p->at;
        code = run_place(v, 1u << p->axis, now);
    }
    if (code == 0)
        code = back_off(p, out.latched);
    if (code == 0)
        printf("touched at %s\n", mover_text(out.latched, text));
    return run_told(v, code);
}

typedef struct {
    mover_options move;
    const char *way;
    double within, feed, back, at;      /* at NAN: it only says where */
} probe_options;

static const option probe_rows[] = {
    { "way", OPTION_WORD(probe_options, way), .value = "AXIS+", .choices = "x-|x+|y-|y+|z-|z+",
      .standard = "z-", .remedy = "name one direction, as z- or x+" },
    OPTION_GROUP(probe_options, move, mover_rows),
    { "within", OPTION_NUMBER(probe_options, within), .least = 0.01, .most = 16383, .unit = "mm",
      .standard = "10", .help = "how far to look" },
    { "feed", OPTION_NUMBER(probe_options, feed), .least = 0.016, .most = 1000, .unit = "mm/s",
      .standard = "2", .help = "mm/s, or as 60mm/min" },
    { "back", OPTION_NUMBER(probe_options, back), .least = 0, .most = 1000, .unit = "mm",
      .standard = "2", .help = "to leave the surface again" },
    { "at", OPTION_NUMBER(probe_options, at), .least = -16383, .most = 16383, .unit = "mm",
      .unset = NAN,
      .help = "the axis is there where it touches: tell the machine (it only says where)" },
    { 0 }
};

static int run_probe(void *options)
{
    const probe_options *o = options;
    probing p = { .axis = o->way[0] - 'x',
                  .sign = o->way[1] == '+' ? 1 : -1,
                  .within = o->within,
                  .feed = o->feed,
                  .back = o->back,
                  .at = o->at };
    int code = run_mover(&p.v, &o->move, false);

    if (code == 0)
        code = probe_it(&p);
    mover_close(&p.v);
    return code;
}

const command command_probe = {
    .name = "probe",
    .arguments = "[AXIS+|AXIS-] --port PORT",
    .summary = "move until the probe touches something, and say where",
    .detail =
        "Without a direction it is z-. The place is that of the slot in which the contact first\n"
        "closed, whatever the speed; then the tool backs off. With --at, the place becomes that "
        "number:\n"
        "loft probe --at 0 makes the surface z = 0, and --at 15 takes a plate of 15 mm off.\n",
    .options = probe_rows,
    .size = sizeof(probe_options),
    .run = run_probe,
    .talks = true,
};

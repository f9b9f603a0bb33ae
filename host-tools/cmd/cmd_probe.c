/* host-tools/cmd/cmd_probe.c -- loft probe: moves until the probe touches something
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/tool.h"
#include "send/mover.h"

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
    return mover_go(&p->v, &m, &out);
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
                          v->port);
    if (v->t.sender.closed & LOFT_INPUT_PROBE)
        return tool_error(EX_UNAVAILABLE,
                          "%s: the probe touches already: move it away, or look at its wire",
                          v->port);
    memcpy(m.to, v->at, sizeof m.to);
    m.to[p->axis] += p->sign * p->within;
    m.guard = touch;
    int code = mover_free(v, m.to);
    if (code == 0)
        code = mover_go(v, &m, &out);
    if (code == 0 && out.how != MOVER_GUARDED)
        code = tool_error(EX_UNAVAILABLE,
                          "%s: the probe has touched nothing within %g mm; the tool is at %s: give "
                          "more --within, or look at its wire",
                          v->port, p->within, mover_text(v->at, text));
    if (code == 0 && !isnan(p->at)) {
        double now[ENGINE_AXES];
        const double by = p->at - out.latched[p->axis];
        memcpy(now, v->at, sizeof now);
        now[p->axis] += by;
        out.latched[p->axis] = p->at;
        code = mover_place(v, 1u << p->axis, now);
    }
    if (code == 0)
        code = back_off(p, out.latched);
    if (code == 0)
        printf("touched at %s\n", mover_text(out.latched, text));
    return mover_told(v, code);
}

static int run_probe(const tool_command *self, int argc, char **argv)
{
    probing p = { .axis = 2, .sign = -1, .within = 10, .feed = 2, .back = 2, .at = NAN };
    int first, code = mover_start(&p.v, argc, argv);

    if (code != 0)
        return code;
    const tool_option options[] = {
        MOVER_OPTIONS(p.v),
        TOOL_NUMBER("within", "MM", &p.within, 0.01, 16383, "how far to look (10)"),
        TOOL_SPEED("feed", &p.feed, 0.016, 1000, "mm/s, or as 60mm/min (2)"),
        TOOL_NUMBER("back", "MM", &p.back, 0, 1000, "to leave the surface again (2)"),
        TOOL_NUMBER("at", "MM", &p.at, -16383, 16383,
                    "the axis is there where it touches: tell the machine (it only says where)"),
        TOOL_OPTIONS_END
    };
    code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first < argc) {
        const char *known = argv[first][0] ? strchr("xyz", argv[first][0]) : NULL;
        if (first + 1 < argc || !known || strlen(argv[first]) != 2 ||
            (argv[first][1] != '+' && argv[first][1] != '-'))
            return tool_error(EX_USAGE, "%s: name one direction, as z- or x+", argv[first]);
        p.axis = (int)(known - "xyz");
        p.sign = argv[first][1] == '+' ? 1 : -1;
    }
    code = mover_open(&p.v);
    if (code == 0)
        code = probe_it(&p);
    mover_close(&p.v);
    return code;
}

const tool_command command_probe = {
    "probe", "[AXIS+|AXIS-] --port PORT", "move until the probe touches something, and say where",
    "Without a direction it is z-. The place is that of the slot in which the contact first\n"
    "closed, whatever the speed; then the tool backs off. With --at, the place becomes that "
    "number:\n"
    "loft probe --at 0 makes the surface z = 0, and --at 15 takes a plate of 15 mm off.\n",
    run_probe
};

/* host-tools/send/probe.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "send/probe.h"

#define FILTER 10               /* ms: longer than contacts bounce */

static host_place port_of(const mover *v) { return (host_place){ .file = v->o.line.port }; }

static int look(void *context)
{
    probe *p     = context;
    mover *v     = p->v;
    mover_move m = { .feed = p->way.feed, .guard = { LOFT_INPUT_PROBE, 0, FILTER } };

    if (!(v->t.sender.machine.kinds & LOFT_TAKES_GUARDS))
        return host_error(v->host, EX_CONFIG, "probe.no-guards", port_of(v),
                          "give it a newer firmware", "this machine cannot probe");
    if (v->t.sender.closed & LOFT_INPUT_PROBE)
        return host_error(v->host, EX_UNAVAILABLE, "probe.touches", port_of(v),
                          "move it away, or look at its wire", "the probe touches already");
    memcpy(m.to, v->at, sizeof m.to);
    m.to[p->way.axis] += p->way.sign * p->way.within;
    const int code = mover_free(v, m.to);
    if (code == 0)
        mover_go(v, &m);
    return code;
}

static int has_touched(void *context)
{
    probe *p       = context;
    const mover *v = p->v;
    char text[96];

    memcpy(p->touched, v->out.latched, sizeof p->touched);
    return v->out.how == MOVER_GUARDED
               ? 0
               : host_error(v->host, EX_UNAVAILABLE, "probe.nothing", port_of(v),
                            "give more --within, or look at its wire",
                            "the probe has touched nothing within %g mm; the tool is at %s",
                            p->way.within, mover_text(v->at, text));
}

static int place(void *context)
{
    probe *p = context;
    double now[ENGINE_AXES];

    if (isnan(p->way.at))
        return 0;
    memcpy(now, p->v->at, sizeof now);
    now[p->way.axis] += p->way.at - p->touched[p->way.axis];
    p->touched[p->way.axis] = p->way.at;
    mover_place(p->v, 1u << p->way.axis, now);
    return 0;
}

/* Leave the surface. */
static int back_off(void *context)
{
    probe *p     = context;
    mover_move m = { .feed = p->way.feed };

    memcpy(m.to, p->v->at, sizeof m.to);
    m.to[p->way.axis] = p->touched[p->way.axis] - p->way.sign * p->way.back;
    mover_go(p->v, &m);
    return 0;
}

static int tell(void *context)
{
    const probe *p = context;
    char text[96];

    send_tell(&p->to, SEND_RESULT, "touched at %s", mover_text(p->touched, text));
    return 0;
}

void probe_begin(probe *p, mover *v, const probe_way *way, const send_teller *to)
{
    *p = (probe){ .v = v, .way = *way, .to = *to };
    sequence_begin(&p->q, v, p);
    sequence_add(&p->q, look, has_touched);
    sequence_add(&p->q, place, NULL);
    sequence_add(&p->q, back_off, tell);
}

task probe_task(probe *p) { return sequence_task(&p->q); }

/* host-tools/gcode/gcode_event.c -- the events of a G-code program: motions with their feed, waits
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "gcode/gcode_state.h"

void gcode_place(const gcode_frame *f, const double at[3], double out[3])
{
    const double x = at[0] + f->shift[0], y = at[1] + f->shift[1];
    const double c = cos(f->degrees * 3.14159265358979323846 / 180),
                 s = sin(f->degrees * 3.14159265358979323846 / 180);

    out[0] = (fabs(f->degrees) > 0 ? c * x - s * y : x) + f->origin[0];
    out[1] = (fabs(f->degrees) > 0 ? s * x + c * y : y) + f->origin[1];
    out[2] = at[2] + f->shift[2] + f->origin[2];
    for (int i = 0; i < 3; i++)
        out[i] *= f->unit;
}

/* The feed of a motion in mm/s; 0 if none is set. */
static double feed_of(const gcode_program *g, double length)
{
    switch (g->feed_mode) {
    case 930: return length * g->frame.unit * g->feed / 60;
    case 950: return g->feed * g->frame.unit * g->speed / 60;
    default:  return g->feed * g->frame.unit / 60;
    }
}

int gcode_send(gcode_program *g, gcode_event *e)
{
    memcpy(e->from, g->apart ? g->place : g->at, sizeof e->from);
    if (e->kind <= GCODE_NURBS)
        memcpy(g->place, e->to, sizeof g->place);
    g->quiet = 0;
    return g->sink(g->context, e);
}

int gcode_give(gcode_program *g, gcode_event *e, double length)
{
    const bool moves = e->kind <= GCODE_NURBS;
    double to[3];

    memcpy(e->from, g->at, sizeof e->from);
    e->line  = g->main_line;
    e->loose[0] = e->loose[1] = g->loose;
    if (moves)
        e->loose[1] = g->loose = g->homing ? g->homed : gcode_loose_there(g);
    e->frame = &g->frame;
    e->plane = g->plane;
    e->exact  = g->exact;
    e->within = g->within;
    e->feed  = e->kind != GCODE_RAPID || g->printer ? feed_of(g, length) : 0;
    if (moves && e->kind != GCODE_RAPID && g->feed_mode == 930 && !gcode_has(&g->b, 'F'))
        return gcode_fails(g, "gcode.inverse-time-no-feed", "no F: in G93 each line has its time",
                           "give F with each motion, or G94");
    if (moves && e->kind != GCODE_RAPID && g->feed_mode == 950 && !(g->speed > 0))
        return gcode_fails(g, "gcode.feed-no-speed", "G95: the feed of a turn, and no turns",
                           "give S with the speed of the spindle, or G94");
    if (moves && e->kind != GCODE_RAPID && g->fed && !(g->feed > 0))
        return gcode_fails(g, "gcode.feed-zero", "F0: this motion would never end",
                           "give a feed above 0");
    memcpy(to, e->to, sizeof to);
    const int code = g->radius.side != 0 ? gcode_radius_take(g, e) : gcode_send(g, e);
    if (moves) {
        memcpy(g->at, to, sizeof g->at);
        g->apart = g->radius.side != 0;
    }
    return code;
}

int gcode_go(gcode_program *g, enum gcode_kind kind, const double to[3])
{
    gcode_event e = { .kind = kind };

    memcpy(e.to, to, sizeof e.to);
    return gcode_give(g, &e, hypot(hypot(to[0] - g->at[0], to[1] - g->at[1]), to[2] - g->at[2]));
}

int gcode_wait(gcode_program *g, double seconds)
{
    gcode_event e = { .kind = GCODE_WAIT, .seconds = seconds };

    return gcode_give(g, &e, 0);
}

int gcode_simple(gcode_program *g, enum gcode_kind kind)
{
    gcode_event e = { .kind = kind, .text = g->b.say, .length = g->b.say_length };

    return gcode_give(g, &e, 0);
}

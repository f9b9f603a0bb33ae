/* host-tools/plan/toolpath.c -- converts a drawing to one connected chain of moves
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/spool.h"          /* spool_grow */
#include "plan/toolpath.h"

/* Points closer than half a step of Q16.16 are one point. */
#define SAME 7.6e-6

typedef struct {
    toolpath *t;
    const toolpath_options *o;
    double at[ENGINE_AXES];
    double up;                      /* mm: height of a travel */
    size_t room;
    size_t events;                  /* of the drawing, so far */
    drawing_event beam;             /* as the program has it, */
    bool lit;                       /* and as it is */
    double lit_at;
} making;

static double is_apart(const double a[ENGINE_AXES], const double b[ENGINE_AXES])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static void add_move(making *m, const engine_move *move, size_t curve)
{
    if (m->t->count == m->room) {
        m->room     = m->room ? 2 * m->room : 64;
        m->t->move  = spool_grow(m->t->move, m->room * sizeof *m->t->move);
        m->t->curve = spool_grow(m->t->curve, m->room * sizeof *m->t->curve);
    }
    spool_passed(m->t->count);
    m->t->curve[m->t->count]  = curve;
    m->t->move[m->t->count++] = *move;
    memcpy(m->at, move->p[3], sizeof m->at);
}

static void go_to(making *m, double x, double y, double z, double feed)
{
    const double to[ENGINE_AXES] = { x, y, z };
    engine_move line             = { .feed = feed };

    const double way = is_apart(m->at, to);
    if (way < SAME)
        return;
    for (int i = 0; i < ENGINE_AXES; i++) {
        const double from = m->at[i], by = to[i] - from;
        line.p[0][i] = from;
        line.p[1][i] = from + by / 3;
        line.p[2][i] = to[i] - by / 3;
        line.p[3][i] = to[i];
    }
    m->t->travelled += way;
    add_move(m, &line, TOOLPATH_TRAVEL);
}

/* Travel with the pen up to (x, y), then go down to z at `feed`. */
static void travel_to(making *m, double x, double y, double z, double feed)
{
    if (hypot(m->at[0] - x, m->at[1] - y) >= SAME) {
        if (m->at[2] < m->up)
            go_to(m, m->at[0], m->at[1], m->up, m->o->travel);
        go_to(m, x, y, m->at[2], m->o->travel);
    }
    go_to(m, x, y, z, feed);
}

/* Control point k. An axis that is loose at one end of a line is so in part between. */
static void place_of(const making *m, const drawing_curve *c, int k, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        const int from = c->loose[0] >> i & 1, to = c->loose[1] >> i & 1;
        out[i] = (i < 2 ? c->p[k][i] : c->z[k]) +
                 (from + to > 0
                      ? (m->o->start[i] - m->o->counted[i]) * ((3 - k) * from + k * to) / 3
                      : 0);
    }
}

static void draw_path(making *m, const drawing *d, size_t i)
{
    const drawing_curve *c = &d->curve[i];
    const bool rapid = c->feed < 0;
    engine_move move = { .feed = rapid ? m->o->rapid : c->feed > 0 ? c->feed : m->o->feed };
    double widest    = 0;

    memcpy(move.p[0], m->at, sizeof move.p[0]);
    for (int k = 1; k < 4; k++) {
        place_of(m, c, k, move.p[k]);
        widest       = fmax(widest, is_apart(move.p[0], move.p[k]));
    }
    if (widest < SAME)
        return;
    add_move(m, &move, rapid ? TOOLPATH_TRAVEL : i);
    m->t->curves += !rapid;
}

/* How much of the drawing is travelled. */
static double length_of_rapids(const drawing *d)
{
    double sum = 0;

    for (size_t i = 0; i < d->count; spool_passed(i++))
        if (d->curve[i].feed < 0)
            sum += hypot(hypot(d->curve[i].p[3][0] - d->curve[i].p[0][0],
                               d->curve[i].p[3][1] - d->curve[i].p[0][1]),
                         d->curve[i].z[3] - d->curve[i].z[0]);
    return sum;
}

static void go_to_curve(making *m, const drawing *d, size_t i)
{
    const drawing_curve *c = &d->curve[i];
    double to[ENGINE_AXES];

    place_of(m, c, 0, to);

    if (d->program && d->from_line > 0 && i == 0)
        travel_to(m, to[0], to[1], to[2], c->feed > 0 ? c->feed : m->o->feed);
    else if (d->program)
        go_to(m, to[0], to[1], to[2], m->o->rapid);
    else if (i == 0 || c->path != c[-1].path || is_apart(m->at, to) >= SAME)
        travel_to(m, to[0], to[1], to[2], m->o->travel);
}

static void add_event(making *m, const drawing_event *e, double feed, size_t move)
{
    toolpath *t = m->t;

    if (t->events == t->event_room) {
        t->event_room = t->event_room ? 2 * t->event_room : 16;
        t->event      = spool_grow(t->event, t->event_room * sizeof *t->event);
    }
    spool_passed(t->events);
    t->event[t->events++] = (toolpath_event){ move, *e, feed };
}

/* A laser is off in travels, and with M4 its power is that of each feed. */
static void light(making *m, const drawing_curve *c)
{
    const bool on     = m->beam.way != 0 && c->feed >= 0;
    const double feed = !on || m->beam.way == 3 ? 0 : c->feed > 0 ? c->feed : m->o->feed;
    drawing_event e   = m->beam;

    if (on == m->lit && !(feed < m->lit_at) && !(feed > m->lit_at))
        return;
    e.line    = c->line;
    e.way     = on ? e.way : 0;
    m->lit    = on;
    m->lit_at = feed;
    add_event(m, &e, feed, m->t->count);
}

/* The events of the drawing before curve i. */
static void add_events(making *m, const drawing *d, size_t i)
{
    for (; m->events < d->events && d->event[m->events].before <= d->taken + i; m->events++) {
        const drawing_event *e = &d->event[m->events];
        if (e->along > 0 && e->before == d->taken + i)
            break;
        if (!m->o->laser || e->doing != DRAWING_SPINS) {
            add_event(m, e, 0, m->t->count);
            continue;
        }
        m->beam = *e;               /* the next curve says how */
        if (m->lit)
            m->lit_at = -1;
        if (e->way == 0)
            light(m, &(drawing_curve){ .feed = DRAWING_RAPID, .line = e->line });
    }
    if (m->o->laser && i < d->count)
        light(m, &d->curve[i]);
}

/* The levels of a laser in the move of curve i; without one all are done before the next move. */
static void add_levels(making *m, const drawing *d, size_t i, size_t move)
{
    for (; move < m->t->count && m->events < d->events && d->event[m->events].along > 0 &&
           d->event[m->events].before == d->taken + i;
         m->events++) {
        m->beam = d->event[m->events];
        add_event(m, &m->beam, m->lit_at, move);
        m->beam.along = 0;
    }
}

void toolpath_make(toolpath *t, const drawing *d, const toolpath_options *o)
{
    making m = { .t = t, .o = o, .up = drawing_top(d) + (d->program ? 0 : o->lift) };
    const double rapids = length_of_rapids(d);

    *t = (toolpath){ .drawn = drawing_length(d) - rapids, .travelled = rapids, .laser = o->laser };
    if (d->from_line > 0)
        m.up = fmax(m.up, d->clear);
    memcpy(m.at, o->start, sizeof m.at);
    for (size_t i = 0; i < d->count; spool_passed(i++)) {
        add_events(&m, d, i);
        go_to_curve(&m, d, i);
        const size_t move = t->count;
        draw_path(&m, d, i);
        add_levels(&m, d, i, move);
    }
    add_events(&m, d, d->count);
    if (t->count > 0 && o->park)
        travel_to(&m, o->zero[0], o->zero[1], isnan(o->zero[2]) ? m.up : o->zero[2], o->travel);
    else if (t->count > 0 && !d->program)
        go_to(&m, m.at[0], m.at[1], m.up, o->travel);
}

void toolpath_free(toolpath *t)
{
    spool_free(t->move);
    spool_free(t->curve);
    spool_free(t->event);
    *t = (toolpath){ 0 };
}

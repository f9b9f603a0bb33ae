/* host-tools/plan/toolpath.c -- converts a drawing to one connected chain of moves
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"           /* tool_grow */
#include "plan/toolpath.h"

/* Points closer than half a step of Q16.16 are one point. */
#define SAME 7.6e-6

typedef struct {
    toolpath *t;
    const toolpath_options *o;
    double at[ENGINE_AXES];
    size_t room;
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
        m->t->move  = tool_grow(m->t->move, m->room * sizeof *m->t->move);
        m->t->curve = tool_grow(m->t->curve, m->room * sizeof *m->t->curve);
    }
    m->t->curve[m->t->count]  = curve;
    m->t->move[m->t->count++] = *move;
    memcpy(m->at, move->p[3], sizeof m->at);
}

static void go_to(making *m, double x, double y, double z)
{
    const double to[ENGINE_AXES] = { x, y, z };
    engine_move line             = { .feed = m->o->travel };

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

/* Travel with the pen up to (x, y), then go down to z. */
static void travel_to(making *m, double x, double y, double z)
{
    if (hypot(m->at[0] - x, m->at[1] - y) >= SAME) {
        if (m->at[2] < m->o->lift)
            go_to(m, m->at[0], m->at[1], m->o->lift);
        go_to(m, x, y, m->at[2]);
    }
    go_to(m, x, y, z);
}

static void draw_path(making *m, const drawing *d, size_t i)
{
    const drawing_curve *c = &d->curve[i];
    engine_move move = { .feed = m->o->feed };
    double widest    = 0;

    memcpy(move.p[0], m->at, sizeof move.p[0]);
    for (int k = 1; k < 4; k++) {
        move.p[k][0] = c->p[k][0];
        move.p[k][1] = c->p[k][1];
        widest       = fmax(widest, is_apart(move.p[0], move.p[k]));
    }
    if (widest < SAME)
        return;
    add_move(m, &move, i);
    m->t->curves++;
}

void toolpath_make(toolpath *t, const drawing *d, const toolpath_options *o)
{
    making m = { .t = t, .o = o };

    *t = (toolpath){ .drawn = drawing_length(d) };
    memcpy(m.at, o->start, sizeof m.at);
    for (size_t i = 0; i < d->count; i++) {
        const drawing_curve *c = &d->curve[i];
        if (i == 0 || c->path != c[-1].path ||
            hypot(m.at[0] - c->p[0][0], m.at[1] - c->p[0][1]) >= SAME)
            travel_to(&m, c->p[0][0], c->p[0][1], 0);
        draw_path(&m, d, i);
    }
    if (t->count > 0 && o->park)
        travel_to(&m, o->zero[0], o->zero[1], o->zero[2]);
    else if (t->count > 0)
        go_to(&m, m.at[0], m.at[1], o->lift);
}

void toolpath_free(toolpath *t)
{
    free(t->move);
    free(t->curve);
    *t = (toolpath){ 0 };
}

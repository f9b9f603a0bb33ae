/* host-tools/plan/way.c -- finds how far along a chain of moves a motion is
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/space.h"          /* space_distance */
#include "base/memory.h"
#include "plan/way.h"

#define SAGITTA   0.0005    /* mm; distance of chords from their curve */
#define CHORDS    4000      /* of a curve at most                            */
#define DRIFT     0.05      /* mm of distance that cost as much as 1 mm of detour */
#define WIDENINGS 8
#define MANY      4096      /* passed chords that are kept */

static void add_chord(way *w, const double at[ENGINE_AXES], size_t move)
{
    if (w->count == w->room) {
        w->room = w->room ? 2 * w->room : 256;
        w->end  = memory_grow(w->end, w->room * sizeof *w->end);
    }
    way_end *e = &w->end[w->count];

    memcpy(e->at, at, sizeof e->at);
    e->move = move;
    e->s    = w->count > 0 ? e[-1].s + space_distance(e[-1].at, at) : 0;
    w->count++;
}

/* The second derivative of a cubic is at most 6 d, where d is the largest second difference of its
 * points. n chords deviate by at most 6 d / (8 n^2). */
static void add_move(way *w, const engine_move *m, size_t number)
{
    double d = 0, at[ENGINE_AXES];

    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < ENGINE_AXES; i++)
            at[i] = m->p[k][i] - 2 * m->p[k + 1][i] + m->p[k + 2][i];
        d = fmax(d, sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]));
    }
    const int n = (int)fmin(fmax(ceil(sqrt(0.75 * d / SAGITTA)), 1), CHORDS);
    for (int k = 1; k <= n; k++) {
        const double z = (double)k / n, y = 1 - z;
        for (int i = 0; i < ENGINE_AXES; i++)
            at[i] = y * y * y * m->p[0][i] + 3 * y * y * z * m->p[1][i] +
                    3 * y * z * z * m->p[2][i] + z * z * z * m->p[3][i];
        add_chord(w, at, number);
    }
}

/* Forget chords that the motion has passed, but only if there are many. */
static void forget_chords(way *w)
{
    if (w->near <= MANY)
        return;
    const size_t drop = w->near - 1;    /* the chord there begins at the end of the one before */
    memmove(w->end, w->end + drop, (w->count - drop) * sizeof *w->end);
    w->count -= drop;
    w->near   = 1;
}

static bool load_move(way *w)
{
    if (w->loaded == w->moves)
        return false;
    const engine_move *m = &w->move[w->loaded];
    if (w->loaded == 0)
        add_chord(w, m->p[0], 0);
    const double before = w->end[w->count - 1].s;
    add_move(w, m, w->loaded);
    w->load(w->context, w->loaded++, m, w->end[w->count - 1].s - before);
    return true;
}

void way_make(way *w, const engine_move move[], size_t moves, double tol, way_load *load,
              void *context)
{
    *w = (way){ .move = move, .moves = moves, .tol = tol, .load = load, .context = context };
    if (load_move(w))
        memcpy(w->x, move[0].p[0], sizeof w->x);
}

void way_finish(way *w)
{
    while (load_move(w)) {
        w->near = w->count - 1;
        forget_chords(w);
    }
}

void way_free(way *w)
{
    free(w->end);
    *w = (way){ .count = 0 };
}

/* The nearest place on chord k, not before w->s. Returns the distance. */
static double nearest_on_chord(const way *w, size_t k, const double x[ENGINE_AXES], double *s)
{
    const way_end *b = &w->end[k], *a = k > 0 ? b - 1 : b;
    const double length = b->s - a->s;
    double dot = 0, at[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++)
        dot += (x[i] - a->at[i]) * (b->at[i] - a->at[i]);
    const double least = length > 0 ? fmax(0, (w->s - a->s) / length) : 0,
                 z = length > 0 ? fmin(fmax(dot / (length * length), least), 1) : 1;
    for (int i = 0; i < ENGINE_AXES; i++)
        at[i] = a->at[i] + z * (b->at[i] - a->at[i]);
    *s = a->s + z * length;
    return space_distance(x, at);
}

/* The best place within `reach` of the place `goal`. Returns the distance. */
static double search_chords(way *w, const double x[ENGINE_AXES], double goal, double reach,
                            size_t *near, double *s)
{
    double least = HUGE_VAL, off = HUGE_VAL;

    for (size_t k = w->near; k == w->near || w->end[k - 1].s <= goal + reach; k++) {
        if (k == w->count && !load_move(w))
            break;
        double at;
        const double d = nearest_on_chord(w, k, x, &at), cost = d + DRIFT * fabs(at - goal);
        if (cost < least) {
            least = cost;
            off   = d;
            *near = k;
            *s    = at;
        }
    }
    return off;
}

size_t way_follow(way *w, const double x[ENGINE_AXES])
{
    const double step = space_distance(x, w->x), goal = w->s + step;
    double reach = 2 * w->tol + step / 4, s = w->s;
    size_t near  = w->near;

    for (int n = 0; n < WIDENINGS && search_chords(w, x, goal, reach, &near, &s) > 2 * w->tol; n++)
        reach *= 4;
    memcpy(w->x, x, sizeof w->x);
    w->near = near;
    w->s    = s;
    forget_chords(w);
    return w->end[w->near].move;
}

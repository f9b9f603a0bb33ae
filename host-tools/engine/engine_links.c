/* host-tools/engine/engine_links.c -- the ways of a mill between lines, and into the material;
 * compiled once per number type
 * SPDX-License-Identifier: MIT
 *
 * A ramp lies over the line that follows, whose chords are proved clear, so it is clear too: a
 * closed line is followed around, of an open one the beginning there and back. A helix may meet a
 * surface; then its centre is looked for in other directions, and at last the ramp is taken. All
 * chords are proved as given, after rounding.
 */
#include <math.h>
#include <string.h>

#include "base/tool.h"              /* tool_grow */
#include "engine/engine_links.h"

#define SIDES  24           /* of a turn of a helix */
#define SEARCH 8            /* directions of its centre */
#define LEG    8            /* radii: a leg of a ramp, at most */
#define MOST   65536        /* points of an entry */

typedef struct {
    const loft_drop *d;
    const mill_order *o;
    mill_cuts *path;
    mill_report *out;
} links;

/* Add a point; `way`: it ends a way between lines. */
static void give(links *l, const double p[ENGINE_AXES], bool way)
{
    const mill_cut *const c = &l->path->cut[0];
    const double *const last = c->count > 0 ? c->point[c->count - 1] : p;
    double length2 = 0;

    for (int k = 0; k < ENGINE_AXES; k++)
        length2 += (p[k] - last[k]) * (p[k] - last[k]);
    if (way)
        l->out->ways += sqrt(length2);
    if (length2 > 0 || c->count == 0)
        mill_cuts_add(l->path, p);
}

/* Add a point of an entry as the number type has it. */
static void plan(mill_cuts *entry, double x, double y, double z)
{
    const double wish[ENGINE_AXES] = { x, y, z };
    double p[ENGINE_AXES];
    loft_vec v;

    if (!vec_of(wish, &v))
        return;
    point_of(v, p);
    mill_cuts_add(entry, p);
}

static bool is_clear(const links *l, const mill_cuts *entry)
{
    const mill_cut *const c = &entry->cut[0];
    loft_vec from, to;

    for (size_t k = 0; k + 1 < c->count; k++)
        if (!vec_of(c->point[k], &from) || !vec_of(c->point[k + 1], &to) ||
            !loft_drop_clear(l->d, &from, &to))
            return false;
    return c->count > 1;
}


/* Ramps */

static double chord(const mill_cut *c, size_t k)
{
    double sum = 0;

    for (int i = 0; i < ENGINE_AXES; i++)
        sum += (c->point[k + 1][i] - c->point[k][i]) * (c->point[k + 1][i] - c->point[k][i]);
    return sqrt(sum);
}

/* Point k of the way of a ramp: around a closed line, or there and back over `leg` chords. */
static size_t place_of(const mill_cut *c, size_t leg, size_t k)
{
    if (c->closed)
        return k % (c->count - 1);
    return k % (2 * leg) <= leg ? k % (2 * leg) : 2 * leg - k % (2 * leg);
}

/* The chords of a ramp that is at least as long as the slope asks; 0: it would be too long. */
static size_t count_chords(const links *l, const mill_cut *c, double high, size_t *leg, double *way)
{
    const double wish = high / l->o->slope;
    double length = 0;

    for (*leg = 0; *leg + 1 < c->count; length += chord(c, (*leg)++))
        if (!c->closed && length >= fmin(wish / 2, LEG * l->o->radius))
            break;
    *way = length;
    if (length < l->o->radius / 4 || wish / length * (double)c->count > MOST)
        return 0;
    if (!c->closed) {           /* whole ways there and back */
        const double times = ceil(wish / (2 * length));
        *way = 2 * length * times;
        return 2 * *leg * (size_t)times;
    }
    size_t n = 0;
    for (*way = 0; *way < wish; n++)
        *way += chord(c, n % (c->count - 1));
    return n;
}

/* Over the line, from `high` down to it. Returns the place of the line where it ends, or -1. */
static long plan_ramp(const links *l, const mill_cut *c, double high, mill_cuts *entry)
{
    double way, gone = 0;
    size_t leg;
    const size_t n = count_chords(l, c, high, &leg, &way);

    for (size_t k = 0; k <= n && n > 0; k++) {
        const size_t at = place_of(c, leg, k), next = place_of(c, leg, k + 1);
        const bool back = !c->closed && next < at;
        const double *const p = c->point[at];
        plan(entry, p[0], p[1], p[2] + (k < n ? high * (1 - gone / way) : 0));
        gone += chord(c, back ? next : at);
    }
    return n > 0 ? (long)place_of(c, leg, n) : -1;
}


/* Helices */

/* Around the place that lies in direction `angle` from the start; `turn` 1 to the left, -1. */
static void plan_helix(const links *l, const mill_cut *c, double high, double angle, int turn,
                       mill_cuts *entry)
{
    const double r = l->o->around, step = 2 * acos(-1) / SIDES, x = c->point[0][0] + r * cos(angle),
                 y = c->point[0][1] + r * sin(angle), fall = 2 * r * sin(step / 2) * l->o->slope;

    for (double k = fmin(ceil(high / fall), MOST); k > 0; k--) {
        const double at = angle + acos(-1) - turn * k * step;
        plan(entry, x + r * cos(at), y + r * sin(at), c->point[0][2] + fmin(high, k * fall));
    }
    plan(entry, c->point[0][0], c->point[0][1], c->point[0][2]);
}

static void clear_entry(mill_cuts *entry)
{
    mill_cuts_free(entry);
    (void)mill_cuts_begin(entry, 0);
}

static bool find_helix(const links *l, const mill_cut *c, double high, mill_cuts *entry)
{
    const double ahead = atan2(c->point[1][1] - c->point[0][1], c->point[1][0] - c->point[0][0]);

    for (int k = 0; k < SEARCH; k++) {          /* the first two arrive along the line */
        const int turn = k % 2 == 0 ? 1 : -1;
        clear_entry(entry);
        plan_helix(l, c, high, ahead + turn * acos(-1) * (0.5 + (k / 2) * 0.5), turn, entry);
        if (is_clear(l, entry))
            return true;
    }
    return false;
}


/* From over the start of a line down to it */
static void enter(links *l, mill_cut *c, double from)
{
    const double above = l->o->stocked ? l->out->clear : from,
                 high = fmin(above - c->point[0][2], l->out->depth);
    enum mill_entry kind = l->o->entry;
    mill_cuts entry = { 0 };

    if (!(high > l->o->tol) || c->count < 2)
        return;
    clear_entry(&entry);
    if (kind == MILL_HELIX && !find_helix(l, c, high, &entry)) {
        kind = MILL_RAMP;
        clear_entry(&entry);
    }
    if (kind == MILL_RAMP) {
        const long end = plan_ramp(l, c, high, &entry);
        if (end >= 0 && is_clear(l, &entry))
            mill_cut_turn(c, (size_t)end);
        else
            kind = MILL_STRAIGHT;
    }
    l->out->entries[kind]++;
    if (kind != MILL_STRAIGHT) {
        const double *const start = entry.cut[0].point[0];
        const double over[ENGINE_AXES] = { start[0], start[1], fmax(from, start[2]) };
        give(l, over, true);
        for (size_t k = 0; k < entry.cut[0].count; k++)
            give(l, entry.cut[0].point[k], true);
    }
    mill_cuts_free(&entry);
}

static void lift(double p[ENGINE_AXES], const mill_cut *c, size_t k, double z)
{
    memcpy(p, c->point[k], sizeof *c->point);
    p[2] = fmax(p[2], z);
}

/* From the end of the path to the start of a cut, over all that is between. Returns the height. */
static double cross(links *l, const mill_cut *c)
{
    const mill_cut *const p = &l->path->cut[0];
    double over[ENGINE_AXES];
    loft_vec from, to;

    lift(over, c, 0, l->out->clear + l->o->safe);
    if (p->count > 0 && vec_of(p->point[p->count - 1], &from) && vec_of(c->point[0], &to)) {
        const double over_all = double_of(loft_drop_over(l->d, &from, &to)),
                     z = l->o->stocked ? fmax(over_all, l->out->clear + l->o->safe) : over_all;
        lift(over, p, p->count - 1, z);
        give(l, over, true);
        lift(over, c, 0, z);
    }
    give(l, over, true);
    return over[2];
}

void ENGINE_OF(engine_links)(const loft_drop *d, const mill_order *o, mill_cuts *cuts,
                             mill_cuts *path, mill_report *out)
{
    links l = { d, o, path, out };
    double end[ENGINE_AXES];

    (void)mill_cuts_begin(path, 0);
    for (size_t i = 0; i < cuts->count; i++) {
        mill_cut *const c = &cuts->cut[i];
        enter(&l, c, cross(&l, c));
        for (size_t k = 0; k < c->count; k++)
            give(&l, c->point[k], k == 0);
    }
    const mill_cut *const all = &path->cut[0];
    if (all->count > 0) {
        lift(end, all, all->count - 1, out->clear + o->safe);
        give(&l, end, true);
    }
}

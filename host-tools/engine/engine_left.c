/* host-tools/engine/engine_left.c -- what a path of a mill leaves on surfaces, at most; compiled
 * once per number type
 * SPDX-License-Identifier: MIT
 *
 * A tool with all that is above it is convex, so the distance from it is a convex function of a
 * point: over the hull of a piece's corners it is the largest at a corner. The surface is within
 * its bend of that hull (toolpath/sheet.h). So of one place of the tool
 *
 *     max over the corners of the distance from the tool + sqrt(3) gap
 *
 * is never less than what it leaves anywhere on the piece, and any place may be taken. Pieces are
 * divided until the bound is near to what is known to be left: by the tolerance, and for the path
 * by a SHARE of it.
 *
 * For the path the places are the nearest ones of its chords. For the hollows they are anywhere:
 * beside the piece along its normal, and from there downhill. How low the tool may be there the
 * search of toolpath/drop.h proves.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"              /* tool_grow */
#include "engine/engine_left.h"

#define SHARE   4               /* of the tolerance: how near bounds of the path come */
#define DEEP    32              /* of what is left in hollows: bounds of these come so near */
#define FINE    256             /* of a radius: steps of a search downhill end there */
#define NEAR    32              /* and begin there, of a point */
#define COARSE  4               /* or there, of a piece of that size */
#define SMALL   8               /* of a radius: larger pieces are divided without a search */
#define ROUNDS  24              /* of a search along a chord, where the tool is no ball */
#define NARROW  0.7             /* of what is left, by a round */

typedef struct {
    double corner[4][3], middle[3];
    unsigned corners, level, i, j;
    bool upper;
    double size;                /* from the middle to the farthest corner */
    double gap;                 /* from the hull of the corners to the surface */
} piece;

/* A place of the tool, and its distance from what is looked at. */
typedef struct {
    double tip[3], left;
} stand;

typedef struct {
    const loft_drop *d;
    const mill_order *o;
    const mill_cut *path;
    const loft_sheet *sheet;
    double reached;             /* no more counts as reached */
    double near[2];             /* bounds come so near: of the path, of any tool */
    double known[2];            /* what is left somewhere: by the path, by any tool */
    double most[2];             /* the bounds, as they are until now */
} left;

/* The distance of a point from the tool with a cylinder above it. */
static double beside(const left *l, const double tip[3], const double p[3])
{
    const double corner = l->o->corner,
                 across = hypot(p[0] - tip[0], p[1] - tip[1]) - (l->o->radius - corner),
                 below = tip[2] + corner - p[2];

    return fmax(0, hypot(fmax(0, across), fmax(0, below)) - corner);
}

static void go_along(const double *a, const double *b, double t, double tip[3])
{
    for (int k = 0; k < 3; k++)
        tip[k] = a[k] + t * (b[k] - a[k]);
}

/* The place of a chord that is nearest to a point: of a ball the foot on the way of its centre. */
static stand nearest_of(const left *l, const double *a, const double *b, const double p[3])
{
    double low = 0, high = 1, to = 0, length2 = 0;
    stand s;

    for (int k = 0; k < 3; k++) {
        to += (b[k] - a[k]) * (p[k] - a[k] - (k == 2 ? l->o->corner : 0));
        length2 += (b[k] - a[k]) * (b[k] - a[k]);
    }
    if (l->o->corner == l->o->radius || !(length2 > 0))
        low = high = length2 > 0 ? fmax(0, fmin(1, to / length2)) : 0;
    for (int k = 0; k < ROUNDS && low < high; k++) {
        const double cut = (high - low) * (1 - NARROW), t = low + cut, u = high - cut;
        double tips[2][3];
        go_along(a, b, t, tips[0]);
        go_along(a, b, u, tips[1]);
        if (beside(l, tips[0], p) < beside(l, tips[1], p))
            high = u;
        else
            low = t;
    }
    go_along(a, b, (low + high) / 2, s.tip);
    s.left = beside(l, s.tip, p);
    return s;
}

/* What a place of the tool leaves on a piece, at most. */
static double bound_of(const left *l, const piece *p, const double tip[3])
{
    double most = 0;

    for (unsigned k = 0; k < p->corners; k++)
        most = fmax(most, beside(l, tip, p->corner[k]));
    return most + p->gap;
}


/* The path */

/* Of these chords keep those that may be the nearest to some point of the piece. Returns the bound
 * of what they leave; *least: what they leave at its first corner. */
static double bound_by_path(const left *l, const piece *p, const size_t *chord, size_t count,
                            size_t *kept, size_t *keep, double *least)
{
    double *const at = tool_grow(NULL, (count + 1) * sizeof *at), nearest = INFINITY,
                  bound = INFINITY;

    for (size_t i = 0; i < count; i++) {
        const double *const a = l->path->point[chord[i]];
        const stand s = nearest_of(l, a, a + ENGINE_AXES, p->middle);
        at[i]   = s.left;
        nearest = fmin(nearest, s.left);
        if (s.left < bound)
            bound = fmin(bound, bound_of(l, p, s.tip));
    }
    *keep = 0;
    *least = INFINITY;
    for (size_t i = 0; i < count; i++)
        if (at[i] <= nearest + 2 * (p->size + p->gap)) {
            const double *const a = l->path->point[chord[i]];
            kept[(*keep)++] = chord[i];
            *least = fmin(*least, nearest_of(l, a, a + ENGINE_AXES, p->corner[0]).left);
        }
    free(at);
    return bound;
}


/* The tool anywhere */

static stand stand_at(const left *l, const piece *p, double x, double y)
{
    stand s = { { x, y, 0 }, INFINITY };
    loft_real at[2];

    if (!real_of(x, &at[0]) || !real_of(y, &at[1]))
        return s;
    s.tip[0] = double_of(at[0]);
    s.tip[1] = double_of(at[1]);
    s.tip[2] = double_of(loft_drop_height(l->d, at[0], at[1], NULL));
    s.left = bound_of(l, p, s.tip);
    return s;
}

/* Where it would touch the middle of the piece if nothing else were in its way. */
static stand stand_beside(const left *l, const piece *p)
{
    const unsigned last = p->corners - 1;
    double n[3], d[2][3], length = 0;

    for (int k = 0; k < 3; k++) {
        d[0][k] = last == 3 ? p->corner[3][k] - p->corner[0][k] : p->corner[1][k] - p->corner[0][k];
        d[1][k] = p->corner[2][k] - p->corner[last == 3 ? 1 : 0][k];
    }
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = d[0][i] * d[1][j] - d[0][j] * d[1][i];
        length += n[k] * n[k];
    }
    length = copysign(sqrt(length), n[2]);
    for (int k = 0; k < 3; k++)
        n[k] = length != 0 ? n[k] / length : 0;
    const double s = hypot(n[0], n[1]), flat = l->o->radius - l->o->corner,
                 on = l->o->corner + (s > 1e-3 ? flat / s : 0);
    return stand_at(l, p, p->middle[0] + on * n[0], p->middle[1] + on * n[1]);
}

/* From a place on downhill, until little enough is left. */
static void go_downhill(const left *l, const piece *p, double enough, stand *best)
{
    static const int way[8][2] = { { 1, 0 },  { 0, 1 },  { -1, 0 }, { 0, -1 },
                                   { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } };

    for (double step = l->o->radius / COARSE; step > l->o->radius / FINE && best->left > enough;) {
        const stand from = *best;
        for (int k = 0; k < 8 && best->left > enough; k++) {
            const stand s = stand_at(l, p, from.tip[0] + step * way[k][0],
                                     from.tip[1] + step * way[k][1]);
            *best = s.left < best->left ? s : *best;
        }
        step = best->left < from.left ? step : step / 2;
    }
}

/* The better one of two places, or from there on. */
static stand bound_by_any(const left *l, const piece *p, const stand *before, double enough)
{
    stand best = stand_beside(l, p);

    if (best.left > enough && before->left < INFINITY) {
        const stand s = stand_at(l, p, before->tip[0], before->tip[1]);
        best = s.left < best.left ? s : best;
    }
    if (p->size < l->o->radius / SMALL && beside(l, best.tip, p->middle) > enough)
        go_downhill(l, p, enough, &best);
    return best;
}

/* What any tool leaves at the first corner, as far as it is more than is known. */
static void learn_corner(left *l, const piece *p, const stand *from, double by_path)
{
    piece corner = { .corners = 1 };

    if (!(fmin(by_path, beside(l, from->tip, p->corner[0])) > l->known[1] + l->near[1]))
        return;
    memcpy(corner.corner[0], p->corner[0], sizeof corner.corner[0]);
    stand best = stand_at(l, &corner, from->tip[0], from->tip[1]);
    go_downhill(l, &corner, l->known[1], &best);
    l->known[1] = fmax(l->known[1], fmin(best.left, by_path));
}


/* Pieces */

/* The corners of a piece at i, j; false if the surface has no point there. */
static bool fill_piece(const left *l, piece *p)
{
    const loft_sheet *const s = l->sheet;
    const uint32_t far = p->upper ? 1 : 0, n = (uint32_t)1 << p->level;

    p->corners = s->surface.over == LOFT_SURFACE_TRIANGLE ? 3 : 4;
    memset(p->middle, 0, sizeof p->middle);
    for (unsigned k = 0; k < p->corners; k++) {
        const uint32_t i = p->i + ((k & 1) ^ far), j = p->j + ((k >> 1) ^ far);
        loft_vec v;
        if (s->surface.eval(s->surface.surface, loft_unit_of(i, n), loft_unit_of(j, n), &v) !=
            LOFT_OK)
            return false;
        point_of(v, p->corner[k]);
        for (int axis = 0; axis < 3; axis++)
            p->middle[axis] += p->corner[k][axis] / p->corners;
    }
    p->size = 0;
    for (unsigned k = 0; k < p->corners; k++) {
        double d2 = 0;
        for (int axis = 0; axis < 3; axis++)
            d2 += pow(p->corner[k][axis] - p->middle[axis], 2);
        p->size = fmax(p->size, sqrt(d2));
    }
    p->gap = sqrt(3) * (double_of_acc(s->fuzz) +
                        ldexp(double_of_acc(s->bend), -2 * (int)(p->level - s->level)));
    return true;
}

/* Is its first corner one of the sheet, which may be trimmed? */
static bool has_corner(const left *l, const piece *p)
{
    const loft_sheet *const s = l->sheet;
    const uint32_t far = p->upper ? 1 : 0, n = (uint32_t)1 << p->level;
    loft_vec v;

    if (s->trim == NULL)
        return true;
    if (!s->plane)
        return loft_region_has(s->trim, loft_region_spot(LOFT_REAL((double)(p->i + far) / n),
                                                         LOFT_REAL((double)(p->j + far) / n)));
    return vec_of(p->corner[0], &v) &&
           loft_region_has(s->trim, loft_region_spot(v.axis[0], v.axis[1]));
}

/* Is nothing of it left by the loops to which the sheet is trimmed? */
static bool is_outside(const left *l, const piece *p)
{
    loft_box box = l->sheet->box;

    for (int axis = 0; axis < ENGINE_AXES; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (unsigned k = 0; k < p->corners; k++) {
            low  = fmin(low, p->corner[k][axis]);
            high = fmax(high, p->corner[k][axis]);
        }
        (void)real_of(low - p->gap, &box.min.axis[axis]);
        (void)real_of(high + p->gap, &box.max.axis[axis]);
    }
    return l->sheet->trim != NULL &&
           loft_sheet_part_of(l->sheet, &box, p->level, p->i, p->j) == LOFT_REGION_OUT;
}

/* Quarter k of 4. Of a triangle the last one is turned round. */
static piece quarter_of(const left *l, const piece *p, unsigned k)
{
    piece q = { .level = p->level + 1, .i = 2 * p->i, .j = 2 * p->j };

    if (l->sheet->surface.over != LOFT_SURFACE_TRIANGLE) {
        q.i += k % 2;
        q.j += k / 2;
        return q;
    }
    q.upper = (k == 3) != p->upper;
    q.i += p->upper ? k != 1 : k == 1;
    q.j += p->upper ? k != 2 : k == 2;
    return q;
}

/* A bound that need not be nearer. */
static double enough_of(const left *l, int by)
{
    if (by == 0)
        return l->known[0] + l->near[0];
    return fmax(l->known[1], l->reached) + fmax(l->near[1], l->known[1] / DEEP);
}

static void close_piece(left *l, double by_path, double by_any)
{
    l->most[0] = fmax(l->most[0], by_path);
    l->most[1] = fmax(l->most[1], by_any);
}

/* `before`: where a tool leaves the least on the piece that this one is a part of, and how much. */
static void look_at(left *l, piece *p, const size_t *chord, size_t count, const stand *before)
{
    size_t keep;
    double least;

    if (!fill_piece(l, p)) {
        close_piece(l, INFINITY, INFINITY);
        return;
    }
    if (is_outside(l, p))
        return;
    size_t *const kept = tool_grow(NULL, (count + 1) * sizeof *kept);
    const bool is_there = has_corner(l, p);
    const double by_path = bound_by_path(l, p, chord, count, kept, &keep, &least);
    stand best = *before;
    if (is_there)
        l->known[0] = fmax(l->known[0], least);
    if (best.left > enough_of(l, 1) && by_path > enough_of(l, 1)) {
        best = bound_by_any(l, p, before, enough_of(l, 1));
        if (is_there)
            learn_corner(l, p, &best, least);
    }
    const double by_any = fmin(best.left, by_path);
    if (p->level >= LOFT_DROP_LEVELS || (by_path <= enough_of(l, 0) && by_any <= enough_of(l, 1)))
        close_piece(l, by_path, by_any);
    else
        for (unsigned k = 0; k < 4; k++) {
            piece q = quarter_of(l, p, k);
            look_at(l, &q, kept, keep, &best);
        }
    free(kept);
}

void ENGINE_OF(engine_left)(const loft_drop *d, const mill_order *o, const mill_cut *path,
                            mill_report *out)
{
    const stand nowhere = { { 0 }, INFINITY };
    loft_drop deep = *d;
    left l = { .d = &deep, .o = o, .path = path, .near = { o->tol / SHARE, o->tol } };
    size_t *const every = tool_grow(NULL, (path->count + 1) * sizeof *every);

    deep.floor -= 2 * d->cutter.radius;
    l.reached = o->cusp + o->tol;
    for (size_t k = 0; k + 1 < path->count; k++)
        every[k] = k;
    for (uint32_t k = 0; k < d->count; k++) {
        l.sheet = &d->sheet[k];
        piece p = {
            .level = l.sheet->level, .i = l.sheet->i, .j = l.sheet->j, .upper = l.sheet->upper
        };
        look_at(&l, &p, every, path->count > 0 ? path->count - 1 : 0, &nowhere);
    }
    free(every);
    out->left = l.most[0];
    out->hollow = l.most[1];
    out->reached = l.reached + l.near[1];
}

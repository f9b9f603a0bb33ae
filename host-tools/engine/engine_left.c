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
 * is never less than what it leaves anywhere on the piece, and any place may be taken. The piece
 * with the largest bound is divided until that is near to what is known to be left. How near it
 * comes decides the cost: a flat tool touches in a point, and its bounds shrink no faster than the
 * pieces. Where a step was asked and no cusp, it comes as near as is worth while beside what is
 * left.
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
#define PLAIN   64              /* of what the path leaves, where a step was asked */
#define DEEP    128             /* of what is left in hollows: bounds of these come so near */
#define FINE    256             /* of a radius: steps of a search downhill end there */
#define COARSE  4               /* and begin there */
#define SMALL   8               /* of a radius: larger pieces are divided without a search */
#define ROUNDS  24              /* of a search along a chord, where the tool is no ball */
#define NARROW  0.7             /* of what is left, by a round */

typedef struct {
    const loft_sheet *sheet;
    double corner[4][3], middle[3];
    loft_sheet_piece at;
    unsigned corners;
    double size;                /* from the middle to the farthest corner */
    double gap;                 /* from the hull of the corners to the surface */
} piece;

/* A place of the tool, and its distance from what is looked at. */
typedef struct {
    double tip[3], left;
} stand;

/* Of the chords of the path those that may be the nearest to some point of a piece. */
typedef struct {
    size_t count, chord[];
} shortlist;

/* A piece that may be divided, and what is known of it. */
typedef struct {
    piece p;
    shortlist *near;
    bool is_there;              /* its first corner */
    bool asked;                 /* for `best`, which is of the whole before */
    double by_path;             /* the bound of what the path leaves */
    stand best;                 /* where a tool leaves little, and the bound of it */
} part;

typedef struct {
    loft_drop d;
    const mill_order *o;
    const mill_cut *path;
    double *half;               /* of the length of each chord */
    loft_drop_spot spot;
    double reached;             /* no more counts as reached */
    double near[2];             /* bounds come so near: of the path, of any tool */
    double share[2];            /* or so near, of what is left */
    double known[2];            /* what is left somewhere: by the path, by any tool */
    double most[2];             /* the bounds of what is no longer looked at */
    int by;                     /* what is looked for: 0, what the path leaves; 1, any tool */
    part *heap;                 /* the largest bound is the first */
    size_t count, room;
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

/* What the path leaves at a point; stops early below `enough`. */
static double left_at(const left *l, const shortlist *s, const double p[3], double enough)
{
    double least = INFINITY;

    for (size_t i = 0; i < s->count && least > enough; i++) {
        const double *const a = l->path->point[s->chord[i]];
        least = fmin(least, nearest_of(l, a, a + ENGINE_AXES, p).left);
    }
    return least;
}

/* The distance of a point from the tool in the middle of a chord: half of its length nearer it may
 * be elsewhere. */
static double beside_middle(const left *l, size_t chord, const double p[3])
{
    double tip[3];

    go_along(l->path->point[chord], l->path->point[chord + 1], 0.5, tip);
    return beside(l, tip, p);
}

/* Of these chords keep those that may be the nearest to some point of the piece, and bound what
 * they leave. */
static void bound_by_path(const left *l, part *q, const shortlist *from)
{
    double *const at = tool_grow(NULL, (from->count + 1) * sizeof *at), nearest = INFINITY;
    const double apart = 2 * (q->p.size + q->p.gap);

    q->near = tool_grow(NULL, sizeof *q->near + from->count * sizeof *q->near->chord);
    q->near->count = 0;
    q->by_path = INFINITY;
    for (size_t i = 0; i < from->count; i++) {
        at[i] = beside_middle(l, from->chord[i], q->p.middle);
        nearest = fmin(nearest, at[i]);
        at[i] -= l->half[from->chord[i]];
    }
    for (size_t i = 0; i < from->count; i++) {
        const bool is_long = l->half[from->chord[i]] > q->p.size;
        if (at[i] <= nearest + (is_long ? apart : 0)) {
            const double *const a = l->path->point[from->chord[i]];
            const stand s = nearest_of(l, a, a + ENGINE_AXES, q->p.middle);
            at[i]   = s.left;
            nearest = fmin(nearest, s.left);
            if (s.left < q->by_path)
                q->by_path = fmin(q->by_path, bound_of(l, &q->p, s.tip));
        }
    }
    for (size_t i = 0; i < from->count; i++)
        if (at[i] <= nearest + apart)
            q->near->chord[q->near->count++] = from->chord[i];
    q->near = tool_grow(q->near, sizeof *q->near + q->near->count * sizeof *q->near->chord);
    free(at);
}


/* The tool anywhere */

static stand stand_at(left *l, const piece *p, double x, double y)
{
    stand s = { { x, y, 0 }, INFINITY };
    loft_real at[2];

    if (!real_of(x, &at[0]) || !real_of(y, &at[1]))
        return s;
    s.tip[0] = double_of(at[0]);
    s.tip[1] = double_of(at[1]);
    s.tip[2] = double_of(loft_drop_height(&l->d, at[0], at[1], &l->spot));
    s.left = bound_of(l, p, s.tip);
    return s;
}

/* Where it would touch a point of the piece if nothing else were in its way, and what it leaves
 * of another one. */
static stand stand_beside(left *l, const piece *p, const double at[3], const piece *of)
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
    return stand_at(l, of, at[0] + on * n[0], at[1] + on * n[1]);
}

/* From a place on downhill, until little enough is left. */
static void go_downhill(left *l, const piece *p, double enough, stand *best)
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

/* A bound that need not be nearer. */
static double enough_of(const left *l, int by)
{
    return (by == 0 ? l->known[0] : fmax(l->known[1], l->reached)) +
           fmax(l->near[by], l->known[by] * l->share[by]);
}

/* Try for a better place than the one of the whole. */
static void bound_by_any(left *l, part *q)
{
    const double enough = enough_of(l, 1);
    stand best = stand_beside(l, &q->p, q->p.middle, &q->p);

    if (best.left > enough && q->best.left < INFINITY) {
        const stand s = stand_at(l, &q->p, q->best.tip[0], q->best.tip[1]);
        best = s.left < best.left ? s : best;
    }
    if (q->p.size < l->o->radius / SMALL && beside(l, best.tip, q->p.middle) > enough)
        go_downhill(l, &q->p, enough, &best);
    q->best = best.left < q->best.left ? best : q->best;
}

/* What any tool leaves at the first corner, as far as it is more than is known. */
static void learn_corner(left *l, const part *q)
{
    piece corner = { .corners = 1 };
    const double enough = fmax(l->known[1], l->reached);

    if (!(fmin(q->by_path, beside(l, q->best.tip, q->p.corner[0])) > enough + l->near[1]))
        return;
    const double by_path = left_at(l, q->near, q->p.corner[0], enough);
    if (!(by_path > enough))
        return;
    memcpy(corner.corner[0], q->p.corner[0], sizeof corner.corner[0]);
    stand best = stand_beside(l, &q->p, corner.corner[0], &corner);
    if (best.left > enough) {
        const stand s = stand_at(l, &corner, q->best.tip[0], q->best.tip[1]);
        best = s.left < best.left ? s : best;
    }
    go_downhill(l, &corner, enough, &best);
    l->known[1] = fmax(l->known[1], fmin(best.left, by_path));
}


/* Pieces */

/* The corners of a piece at i, j; false if the surface has no point there. */
static bool fill_piece(piece *p)
{
    const loft_sheet *const s = p->sheet;
    const uint32_t n = (uint32_t)1 << p->at.level;

    p->corners = s->surface.over == LOFT_SURFACE_TRIANGLE ? 3 : 4;
    memset(p->middle, 0, sizeof p->middle);
    for (unsigned k = 0; k < p->corners; k++) {
        uint32_t at[2];
        loft_vec v;
        loft_sheet_piece_corner(&p->at, k, at);
        if (s->surface.eval(s->surface.surface, loft_unit_of(at[0], n), loft_unit_of(at[1], n),
                            &v) != LOFT_OK)
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
    p->gap = sqrt(3) * double_of_acc(loft_sheet_gap(s, p->at.level));
    return true;
}

/* True if its first corner is one of the sheet, which may be trimmed. */
static bool has_corner(const piece *p)
{
    const loft_sheet *const s = p->sheet;
    const double n = ldexp(1, p->at.level);
    uint32_t at[2];
    loft_vec v;

    if (s->trim == NULL)
        return true;
    loft_sheet_piece_corner(&p->at, 0, at);
    if (!s->plane)
        return loft_region_has(s->trim,
                               loft_region_spot(LOFT_REAL(at[0] / n), LOFT_REAL(at[1] / n)));
    return vec_of(p->corner[0], &v) &&
           loft_region_has(s->trim, loft_region_spot(v.axis[0], v.axis[1]));
}

/* True if the loops to which the sheet is trimmed leave nothing of it. */
static bool is_outside(const piece *p)
{
    loft_box box = p->sheet->box;

    for (int axis = 0; axis < ENGINE_AXES; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (unsigned k = 0; k < p->corners; k++) {
            low  = fmin(low, p->corner[k][axis]);
            high = fmax(high, p->corner[k][axis]);
        }
        (void)real_of(low - p->gap, &box.min.axis[axis]);
        (void)real_of(high + p->gap, &box.max.axis[axis]);
    }
    return p->sheet->trim != NULL && loft_sheet_part_of(p->sheet, &box, &p->at) == LOFT_REGION_OUT;
}

static piece quarter_of(const piece *p, unsigned k)
{
    const bool triangle = p->sheet->surface.over == LOFT_SURFACE_TRIANGLE;
    return (piece){ .sheet = p->sheet, .at = loft_sheet_piece_quarter(&p->at, triangle, k) };
}

/* Parts, the largest bound first */

static double bound_by(const part *q, int by)
{
    return by == 0 ? q->by_path : fmin(q->by_path, q->best.left);
}

static bool is_before(const left *l, const part *a, const part *b)
{
    return bound_by(a, l->by) > bound_by(b, l->by);
}

/* Put a part into the heap at k, or below it. */
static void sink(left *l, size_t k, part q)
{
    for (size_t next = 2 * k + 1; next < l->count; next = 2 * k + 1) {
        next += next + 1 < l->count && is_before(l, &l->heap[next + 1], &l->heap[next]);
        if (!is_before(l, &l->heap[next], &q))
            break;
        l->heap[k] = l->heap[next];
        k = next;
    }
    l->heap[k] = q;
}

static void add(left *l, const part *q)
{
    size_t k = l->count++;

    if (l->count > l->room) {
        l->room = 2 * l->count;
        l->heap = tool_grow(l->heap, l->room * sizeof *l->heap);
    }
    for (; k > 0 && is_before(l, q, &l->heap[(k - 1) / 2]); k = (k - 1) / 2)
        l->heap[k] = l->heap[(k - 1) / 2];
    l->heap[k] = *q;
}

/* Add a piece, if it need be looked at: against these chords. */
static void add_piece(left *l, const piece *p, const stand *best, const shortlist *from)
{
    part q = { .p = *p, .best = *best, .by_path = INFINITY };

    if (!fill_piece(&q.p)) {            /* nothing is known of it */
        q.p.at.level = LOFT_DROP_LEVELS;
        q.best.left = INFINITY;
        add(l, &q);
        return;
    }
    if (is_outside(&q.p))
        return;
    q.is_there = has_corner(&q.p);
    bound_by_path(l, &q, from);
    if (q.is_there && q.by_path > l->known[0])
        l->known[0] = fmax(l->known[0], left_at(l, q.near, q.p.corner[0], l->known[0]));
    if (bound_by(&q, 0) > enough_of(l, 0) || bound_by(&q, 1) > enough_of(l, 1)) {
        add(l, &q);
        return;
    }
    for (int by = 0; by < 2; by++)
        l->most[by] = fmax(l->most[by], bound_by(&q, by));
    free(q.near);
}

/* Divide what has the largest bound, until that is near enough. Returns the bound of all. */
static double search(left *l)
{
    while (l->count > 0) {
        part q = l->heap[0];
        const double bound = bound_by(&q, l->by);
        if (q.p.at.level >= LOFT_DROP_LEVELS || bound <= enough_of(l, l->by))
            return fmax(l->most[l->by], bound);
        if (l->by == 1 && !q.asked) {
            bound_by_any(l, &q);
            q.asked = true;
            if (q.is_there)
                learn_corner(l, &q);
            sink(l, 0, q);
            continue;
        }
        const part last = l->heap[--l->count];
        if (l->count > 0)
            sink(l, 0, last);
        for (unsigned k = 0; k < 4; k++) {
            const piece quarter = quarter_of(&q.p, k);
            add_piece(l, &quarter, &q.best, q.near);
        }
        free(q.near);
    }
    return l->most[l->by];
}

static void begin_search(left *l)
{
    const stand nowhere = { { 0 }, INFINITY };
    const mill_cut *const path = l->path;
    shortlist *const every = tool_grow(NULL, sizeof *every + path->count * sizeof *every->chord);

    l->half = tool_grow(NULL, path->count * sizeof *l->half);
    every->count = path->count - 1;
    for (size_t k = 0; k < every->count; k++) {
        const double *const a = path->point[k], *const b = path->point[k + 1];
        every->chord[k] = k;
        l->half[k] = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]) / 2;
    }
    for (uint32_t k = 0; k < l->d.count; k++) {
        const loft_sheet *const s = &l->d.sheet[k];
        const piece p = { .sheet = s, .at = s->part };
        add_piece(l, &p, &nowhere, every);
    }
    free(every);
}

/* Where much may be left, small remainders need no report, nor a tool that low. */
static void look_coarsely(left *l)
{
    const double little = l->known[0] * l->share[0];
    loft_real tol;

    l->near[1] = fmax(l->near[1], little);
    l->reached = fmax(l->reached, 4 * little);
    if (real_of(little / 4, &tol) && tol > l->d.tol)
        l->d.tol = tol;
}

void ENGINE_OF(engine_left)(const loft_drop *d, const mill_order *o, const mill_cut *path,
                            mill_report *out)
{
    const bool plain = !(o->cusp > 0);
    left l = { .d       = *d,
               .o       = o,
               .path    = path,
               .near    = { o->tol / SHARE, o->tol },
               .share   = { plain ? 1.0 / PLAIN : 0, 1.0 / DEEP },
               .reached = o->cusp + o->tol };

    l.d.floor -= 2 * d->cutter.radius;
    begin_search(&l);
    out->left = search(&l);
    if (plain)
        look_coarsely(&l);
    l.by = 1;
    for (size_t k = l.count / 2; k-- > 0;)
        sink(&l, k, l.heap[k]);
    out->hollow = search(&l);
    out->reached = l.reached + l.near[1];
    while (l.count > 0)
        free(l.heap[--l.count].near);
    free(l.heap);
    free(l.half);
}

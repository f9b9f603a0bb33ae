/* host-tools/arrange/tour.c
 * SPDX-License-Identifier: MIT
 *
 * The way is a closed tour: stroke number `count` stands for the place where it begins, and where
 * it ends. A tour is a list of ends: stroke s has the ends 2s and 2s + 1, and is entered at the one
 * that is listed, and left at the other, e ^ 1. Every change is a reversal of a part of the list,
 * or another point of a closed stroke; so changes that did not help are taken back.
 *
 * 1. Nearest end first.
 * 2. For the ends in a queue: 2-opt, Or-opt and other points of closed strokes, with the nearest
 *    ends as candidates, until nothing helps.
 * 3. Exchange two neighbouring short parts at a random place, and improve again there; keep the
 *    better tour.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/host.h"
#include "arrange/tour.h"

#define NEAR     10         /* candidates of an end */
#define SEGMENT  3          /* strokes that Or-opt moves */
#define PART     30         /* strokes of the parts that are exchanged */
#define UNITS    8e7       /* of work in a second */
#define ROUNDS   2000       /* exchanges for each stroke */
#define LEAST    1e-9       /* mm; a smaller gain is none */
#define REVERSAL 50000u     /* strokes; longer reversals are too slow for what they give */
#define NONE     UINT32_MAX

typedef struct {
    uint32_t from, to;          /* places of a reversal; from == NONE: `to` is a stroke that had */
    uint32_t point;             /* this point */
} change;

typedef struct {
    const tour_problem *t;
    uint32_t strokes;           /* and the beginning */
    double (*at)[2];            /* of each end */
    uint32_t *point;            /* of a stroke: the point that is entered, if it is closed */
    uint32_t *list, *place;     /* ends in order; of a stroke: its place */
    uint32_t (*near)[NEAR];     /* of an end */
    uint32_t *queue, queued, head;
    bool *waits;                /* the stroke is in the queue */
    change *done;
    size_t changes, room;
    bool logged;
    double gain;                /* mm, since it was set to 0 */
    double work, most;          /* units */
    uint64_t seed;
} tour;

static double apart(const double a[2], const double b[2])
{
    const double x = a[0] - b[0], y = a[1] - b[1];
    return sqrt(x * x + y * y);
}

/* The distance of two ends. The way ends anywhere, unless it returns. */
static double gap(const tour *r, uint32_t a, uint32_t b)
{
    const uint32_t open = r->t->returns ? NONE : 2 * (r->strokes - 1) + 1;

    return a == open || b == open ? 0 : apart(r->at[a], r->at[b]);
}

static uint32_t after(const tour *r, uint32_t p)     { return p + 1 < r->strokes ? p + 1 : 0; }
static uint32_t before(const tour *r, uint32_t p)    { return p > 0 ? p - 1 : r->strokes - 1; }
static uint32_t random_below(tour *r, uint32_t n)
{
    r->seed ^= r->seed << 13;
    r->seed ^= r->seed >> 7;
    r->seed ^= r->seed << 17;
    return (uint32_t)(((r->seed >> 32) * n) >> 32);
}

static bool is_closed(const tour *r, uint32_t s)
{
    return s + 1 < r->strokes && r->t->stroke[s].closed;
}


// Changes
// -------

static void log_change(tour *r, change c)
{
    if (!r->logged)
        return;
    if (r->changes == r->room) {
        r->room = r->room ? 2 * r->room : 1024;
        r->done = memory_grow(r->done, r->room * sizeof *r->done);
    }
    r->done[r->changes++] = c;
}

/* Reverse the places from..to, which may pass the end of the list; or all others, which makes the
 * same tour, run backwards. */
static void reverse(tour *r, uint32_t from, uint32_t to)
{
    const uint32_t n = r->strokes;
    uint32_t inside  = (to + n - from) % n + 1;

    log_change(r, (change){ from, to, 0 });
    if (2 * inside > n) {
        const uint32_t low = after(r, to);
        to     = before(r, from);
        from   = low;
        inside = n - inside;
    }
    r->work += 8 + inside / 4;
    for (uint32_t k = 0; k < inside / 2; k++) {
        const uint32_t a = r->list[from] ^ 1, b = r->list[to] ^ 1;
        r->list[from]    = b;
        r->list[to]      = a;
        r->place[b >> 1] = from;
        r->place[a >> 1] = to;
        from = after(r, from);
        to   = before(r, to);
    }
    if (inside % 2 == 1)
        r->list[from] ^= 1;
}

static void set_point(tour *r, uint32_t s, uint32_t point)
{
    const double *at = r->t->point[r->t->stroke[s].first + point];

    log_change(r, (change){ NONE, s, r->point[s] });
    r->point[s] = point;
    for (uint32_t e = 2 * s; e < 2 * s + 2; e++)
        memcpy(r->at[e], at, sizeof r->at[e]);
}

static void take_back(tour *r)
{
    r->logged = false;
    while (r->changes > 0) {
        const change c = r->done[--r->changes];
        if (c.from == NONE)
            set_point(r, c.to, c.point);
        else
            reverse(r, c.from, c.to);
    }
}

static void enqueue(tour *r, uint32_t s)
{
    if (r->waits[s])
        return;
    r->waits[s] = true;
    r->queue[(r->head + r->queued++) % r->strokes] = s;
}

/* Reverse what lies between the outer ends x and y of neighbouring strokes. Whichever way the list
 * runs: earlier reversals may have turned it round. */
static void flip(tour *r, uint32_t x, uint32_t y)
{
    const uint32_t p = r->place[x >> 1], q = r->place[y >> 1];

    if (r->list[p] == x)
        reverse(r, p, q);
    else
        reverse(r, q, p);
}


// Neighbours
// ----------

/* Points in squares of a grid, about two in each. */
typedef struct {
    const double (*at)[2];
    const uint32_t *stroke;     /* of a point */
    double low[2], size;
    uint32_t cells[2], count;
    uint32_t *first, *point;    /* of a square: where its points are in point[] */
    uint32_t *left;             /* of a square: how many of its points are not removed */
} grid;

static uint32_t cell_along(const grid *g, const double p[2], int axis)
{
    const double k = floor((p[axis] - g->low[axis]) / g->size);
    return k < 0 ? 0 : k >= g->cells[axis] ? g->cells[axis] - 1 : (uint32_t)k;
}

static uint32_t cell_of(const grid *g, const double p[2])
{
    return cell_along(g, p, 1) * g->cells[0] + cell_along(g, p, 0);
}

static void grid_free(grid *g)
{
    free(g->first);
    free(g->left);
    free(g->point);
}

/* A line of points has squares along it only; at most 4096 squares in a row. */
static void grid_shape(grid *g, const uint32_t ids[])
{
    double high[2] = { -HUGE_VAL, -HUGE_VAL };

    g->low[0] = g->low[1] = HUGE_VAL;
    for (uint32_t k = 0; k < g->count; k++)
        for (int i = 0; i < 2; i++) {
            g->low[i] = fmin(g->low[i], g->at[ids[k]][i]);
            high[i]   = fmax(high[i], g->at[ids[k]][i]);
        }
    const double wide = high[0] - g->low[0], tall = high[1] - g->low[1], n = g->count / 2.0 + 1,
                 most = fmax(fmax(wide, tall), 1e-6);
    g->size = fmax(sqrt(fmax(wide, most / n) * fmax(tall, most / n) / n), most / 4096);
    g->cells[0] = (uint32_t)(wide / g->size) + 1;
    g->cells[1] = (uint32_t)(tall / g->size) + 1;
}

static void grid_make(grid *g, const uint32_t ids[], uint32_t count)
{
    g->count = count;
    grid_shape(g, ids);
    const size_t cells = (size_t)g->cells[0] * g->cells[1];
    g->first = memory_grow(NULL, (cells + 1) * sizeof *g->first);
    g->left  = memory_grow(NULL, cells * sizeof *g->left);
    g->point = memory_grow(NULL, count * sizeof *g->point);
    memset(g->first, 0, (cells + 1) * sizeof *g->first);
    memset(g->left, 0, cells * sizeof *g->left);
    for (uint32_t k = 0; k < count; k++)
        g->first[cell_of(g, g->at[ids[k]]) + 1]++;
    for (size_t c = 0; c < cells; c++)
        g->first[c + 1] += g->first[c];
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t c = cell_of(g, g->at[ids[k]]);
        g->point[g->first[c] + g->left[c]++] = ids[k];
    }
}

static void grid_remove(grid *g, uint32_t id)
{
    const uint32_t c = cell_of(g, g->at[id]);
    uint32_t *points = &g->point[g->first[c]], k = 0;

    while (points[k] != id)
        k++;
    points[k] = points[--g->left[c]];
    points[g->left[c]] = id;
    g->count--;
}

/* The nearest points, sorted; of each stroke only the nearest one. */
typedef struct {
    struct {
        uint32_t point, stroke;
        double distance;
    } row[NEAR];
    unsigned count, most;
} nearest;

static bool is_full(const nearest *n, double distance)
{
    return n->count == n->most && n->row[n->count - 1].distance <= distance;
}

static void add_near(nearest *n, uint32_t point, uint32_t stroke, double distance)
{
    unsigned same = 0, k;

    if (is_full(n, distance))
        return;
    while (same < n->count && n->row[same].stroke != stroke)
        same++;
    if (same < n->count && n->row[same].distance <= distance)
        return;
    if (same == n->count && n->count < n->most)
        n->count++;
    for (k = same < n->count ? same : n->count - 1; k > 0 && n->row[k - 1].distance > distance; k--)
        n->row[k] = n->row[k - 1];
    n->row[k].point    = point;
    n->row[k].stroke   = stroke;
    n->row[k].distance = distance;
}

static void search_cell(const grid *g, int64_t x, int64_t y, const double p[2], uint32_t but,
                        nearest *out)
{
    if (x < 0 || y < 0 || x >= g->cells[0] || y >= g->cells[1])
        return;
    const size_t c        = (size_t)y * g->cells[0] + (size_t)x;
    const uint32_t *point = &g->point[g->first[c]];
    for (uint32_t k = 0; k < g->left[c] && !is_full(out, 0); k++)
        if (g->stroke[point[k]] != but)
            add_near(out, point[k], g->stroke[point[k]], apart(p, g->at[point[k]]));
}

/* Search in square rings around p; what is beyond a ring is farther away than it is wide. */
static void grid_search(const grid *g, const double p[2], uint32_t but, nearest *out)
{
    const int64_t cx = cell_along(g, p, 0), cy = cell_along(g, p, 1),
                  rings = g->cells[0] > g->cells[1] ? g->cells[0] : g->cells[1];

    for (int64_t ring = 0; ring <= rings && !is_full(out, ((double)ring - 1) * g->size); ring++)
        for (int64_t y = cy - ring; y <= cy + ring; y++) {
            const int64_t step = y == cy - ring || y == cy + ring ? 1 : 2 * ring;
            for (int64_t x = cx - ring; x <= cx + ring; x += step)
                search_cell(g, x, y, p, but, out);
        }
}

/* The points of all strokes, one after the other. */
typedef struct {
    double (*at)[2];
    uint32_t *stroke, *id, *first, count;
} points;

static void points_make(points *p, const tour_problem *t)
{
    size_t count = 0;

    for (size_t s = 0; s < t->count; s++)
        count += t->stroke[s].count;
    *p = (points){ .count = (uint32_t)count };
    p->at     = memory_grow(NULL, count * sizeof *p->at);
    p->stroke = memory_grow(NULL, count * sizeof *p->stroke);
    p->id     = memory_grow(NULL, count * sizeof *p->id);
    p->first  = memory_grow(NULL, t->count * sizeof *p->first);
    for (uint32_t s = 0, k = 0; s < t->count; s++) {
        p->first[s] = k;
        for (size_t j = 0; j < t->stroke[s].count; j++, k++) {
            memcpy(p->at[k], t->point[t->stroke[s].first + j], sizeof p->at[k]);
            p->stroke[k] = s;
            p->id[k]     = k;
        }
    }
}

static void points_free(points *p)
{
    free(p->at);
    free(p->stroke);
    free(p->id);
    free(p->first);
}

/* The end of a stroke that has this point. */
static uint32_t end_at(const tour *r, const points *p, uint32_t point)
{
    const uint32_t s = p->stroke[point];
    return is_closed(r, s) ? 2 * s : 2 * s + point - p->first[s];
}

/* A closed stroke has the neighbours of all its points. */
static void find_neighbours(tour *r, const points *p, const grid *g)
{
    for (uint32_t e = 0; e < 2 * r->strokes; e++) {
        const uint32_t s = e >> 1;
        nearest n = { .most = NEAR };
        if (!is_closed(r, s))
            grid_search(g, r->at[e], s, &n);
        else
            for (uint32_t k = 0; k < r->t->stroke[s].count; k++)
                grid_search(g, p->at[p->first[s] + k], s, &n);
        for (unsigned k = 0; k < NEAR; k++)
            r->near[e][k] = k < n.count ? end_at(r, p, n.row[k].point) : NONE;
    }
}

/* From the beginning, always the nearest point of a stroke that is left. A grid with few points
 * left is made again, so that the search does not walk over empty squares. */
static void nearest_first(tour *r, points *p, grid *g)
{
    const uint32_t last = r->strokes - 1;
    const double *here  = r->t->from;
    uint32_t whole      = g->count;

    r->list[0]     = 2 * last + 1;      /* entered where the way ends */
    r->place[last] = 0;
    for (uint32_t k = 1; k <= last; k++) {
        nearest next = { .most = 1 };
        grid_search(g, here, NONE, &next);
        const uint32_t point = next.row[0].point, s = next.row[0].stroke;
        if (is_closed(r, s))
            set_point(r, s, point - p->first[s]);
        r->list[k]  = end_at(r, p, point);
        r->place[s] = k;
        here        = r->at[r->list[k] ^ 1];
        for (uint32_t j = 0; j < r->t->stroke[s].count; j++)
            grid_remove(g, p->first[s] + j);
        if (g->count > 0 && g->count < whole / 4) {
            uint32_t count = 0;
            for (uint32_t i = 0; i < p->count; i++)
                if (r->place[p->stroke[i]] == NONE)
                    p->id[count++] = i;
            grid_free(g);
            grid_make(g, p->id, count);
            whole = count;
        }
    }
}


// Improving
// ---------

/* 2-opt: connect the ends of the strokes at p and q (`ahead`), or their beginnings. What lies
 * between is reversed. */
static bool try_reversal(tour *r, uint32_t p, uint32_t q, bool ahead)
{
    const uint32_t p1 = ahead ? after(r, p) : before(r, p), q1 = ahead ? after(r, q) : before(r, q);
    const uint32_t a = r->list[p] ^ (uint32_t)ahead, c = r->list[q] ^ (uint32_t)ahead,
                   b = r->list[p1] ^ (uint32_t)!ahead, d = r->list[q1] ^ (uint32_t)!ahead;
    const double gain = gap(r, a, b) + gap(r, c, d) - gap(r, a, c) - gap(r, b, d);

    if (p == q || gain <= LEAST)
        return false;
    const uint32_t from = ahead ? p1 : p, to = ahead ? q : q1,
                   inside = (to + r->strokes - from) % r->strokes + 1;
    if (inside > REVERSAL && r->strokes - inside > REVERSAL)
        return false;
    reverse(r, from, to);
    r->gain += gain;
    enqueue(r, a >> 1);
    enqueue(r, b >> 1);
    enqueue(r, c >> 1);
    enqueue(r, d >> 1);
    return true;
}

/* The point of a closed stroke that is best between two ends. */
static uint32_t best_point(tour *r, uint32_t s, uint32_t a, uint32_t b, double *length)
{
    const tour_stroke *of = &r->t->stroke[s];
    const uint32_t own    = r->point[s];
    uint32_t best         = own;

    *length = gap(r, a, 2 * s) + gap(r, 2 * s, b);
    for (uint32_t k = 0; k < of->count; k++) {
        memcpy(r->at[2 * s], r->t->point[of->first + k], sizeof r->at[2 * s]);
        const double sum = gap(r, a, 2 * s) + gap(r, 2 * s, b);
        if (sum < *length - LEAST) {
            *length = sum;
            best    = k;
        }
    }
    r->work += (double)of->count;
    memcpy(r->at[2 * s], r->t->point[of->first + own], sizeof r->at[2 * s]);
    return best;
}

static bool move_point(tour *r, uint32_t s)
{
    const uint32_t p = r->place[s], a = r->list[before(r, p)] ^ 1, b = r->list[after(r, p)];
    const double was = gap(r, a, 2 * s) + gap(r, 2 * s, b);
    double length;
    const uint32_t to = best_point(r, s, a, b, &length);

    if (to == r->point[s])
        return false;
    set_point(r, s, to);
    r->gain += was - length;
    enqueue(r, a >> 1);
    enqueue(r, s);
    enqueue(r, b >> 1);
    return true;
}

/* Or-opt: move the strokes b..c at `length` places from `from` on to between place p and the next;
 * `turned`: the other way round; one closed stroke: from its best point. */
static bool try_move(tour *r, uint32_t from, uint32_t length, uint32_t p, bool turned)
{
    const uint32_t n = r->strokes, to = (from + length - 1) % n, p1 = after(r, p);

    if (length + 2 > n || (p + n - from) % n < length || (p1 + n - from) % n < length)
        return false;
    const uint32_t a = r->list[before(r, from)] ^ 1, b = r->list[from], c = r->list[to] ^ 1,
                   d = r->list[after(r, to)], e = r->list[p] ^ 1, f = r->list[p1];
    const bool round = length == 1 && is_closed(r, b >> 1);
    uint32_t point   = 0;
    double with      = turned ? gap(r, e, c) + gap(r, b, f) : gap(r, e, b) + gap(r, c, f);
    if (round)
        point = best_point(r, b >> 1, e, f, &with);
    const double gain = gap(r, a, b) + gap(r, c, d) + gap(r, e, f) - gap(r, a, d) - with;
    const uint32_t ahead = (p + n - to) % n, back = (from + n - p1) % n,
                   between = ahead < back ? ahead : back;
    if (gain <= LEAST || between > REVERSAL)
        return false;
    if (round && point != r->point[b >> 1])
        set_point(r, b >> 1, point);
    if (ahead < back) {         /* a b..c d..e f */
        flip(r, b, e);
        flip(r, d, e);
    } else {                    /* e f..a b..c d */
        flip(r, f, c);
        flip(r, f, a);
    }
    if (!turned)
        flip(r, b, c);
    r->gain += gain;
    enqueue(r, a >> 1);
    enqueue(r, b >> 1);
    enqueue(r, c >> 1);
    enqueue(r, d >> 1);
    enqueue(r, e >> 1);
    enqueue(r, f >> 1);
    return true;
}

/* Move strokes so that the end of the stroke at p (`ahead`), or its beginning, is connected to the
 * one at q: to its end, if they have one role, or to its beginning. */
static bool try_moves(tour *r, uint32_t p, uint32_t q, bool ahead, bool same)
{
    const uint32_t n = r->strokes;
    const bool right = ahead != same;       /* the strokes that go with q are those after it */

    for (uint32_t length = 1; length <= SEGMENT && length + 2 <= n; length++) {
        const uint32_t low_q = right ? q : (q + n - length + 1) % n,
                       low_p = ahead ? (p + n - length + 1) % n : p;
        if (try_move(r, low_q, length, ahead ? p : before(r, p), same) ||
            try_move(r, low_p, length, right ? before(r, q) : q, same))
            return true;
    }
    return false;
}

static bool improve_end(tour *r, uint32_t s, bool ahead)
{
    const uint32_t p = r->place[s], a = r->list[p] ^ (uint32_t)ahead,
                   b = r->list[ahead ? after(r, p) : before(r, p)] ^ (uint32_t)!ahead;
    const double length = gap(r, a, b);

    for (unsigned k = 0; k < NEAR && r->near[a][k] != NONE; k++) {
        const uint32_t c = r->near[a][k], q = r->place[c >> 1];
        const bool round = is_closed(r, c >> 1);
        r->work += 1;
        if (gap(r, a, c) >= length - LEAST) {
            if (!round && !is_closed(r, s))
                break;              /* they are sorted */
            continue;
        }
        r->work += 2 + 2 * SEGMENT;
        const bool same = c == (r->list[q] ^ (uint32_t)ahead);
        if ((same || round) && (try_reversal(r, p, q, ahead) || try_moves(r, p, q, ahead, true)))
            return true;
        if ((!same || round) && try_moves(r, p, q, ahead, false))
            return true;
    }
    return false;
}

static void improve(tour *r)
{
    while (r->queued > 0 && r->work < r->most) {
        const uint32_t s = r->queue[r->head];
        r->head = (r->head + 1) % r->strokes;
        r->queued--;
        r->waits[s] = false;
        if ((is_closed(r, s) && move_point(r, s)) || improve_end(r, s, true) ||
            improve_end(r, s, false))
            enqueue(r, s);
    }
}

/* Exchange two neighbouring parts, and improve there. */
static void exchange(tour *r)
{
    const uint32_t n = r->strokes, most = n / 3 < PART ? n / 3 : PART, p = random_below(r, n),
                   one = 1 + random_below(r, most), two = 1 + random_below(r, most),
                   q = (p + one) % n, end = (q + two) % n;
    const uint32_t a = r->list[p] ^ 1, b = r->list[after(r, p)], c = r->list[q] ^ 1,
                   d = r->list[after(r, q)], e = r->list[end] ^ 1, f = r->list[after(r, end)];

    r->changes = 0;
    r->logged  = true;
    r->gain    = gap(r, a, b) + gap(r, c, d) + gap(r, e, f) - gap(r, a, d) - gap(r, e, b) -
              gap(r, c, f);
    flip(r, b, e);
    flip(r, d, e);
    flip(r, b, c);
    r->work += 50;
    for (int k = 0; k < 6; k++)
        enqueue(r, (const uint32_t[6]){ a, b, c, d, e, f }[k] >> 1);
    improve(r);
    r->logged = false;
    if (r->gain < 0 || r->queued > 0)
        take_back(r);
}

/* Returns false if the host has stopped it. */
static bool improve_all(tour *r)
{
    host *h   = r->t->host;
    bool goes = true;

    for (uint32_t k = 0; k < r->strokes; k++)
        enqueue(r, r->list[k] >> 1);
    improve(r);
    for (uint64_t k = 0; r->strokes >= 4 && r->work < r->most && r->queued == 0 && goes &&
                         k < (uint64_t)ROUNDS * r->strokes;
         k++) {
        if (k % 1024 == 0) {
            const host_progress p = { "ordering", r->work, r->most, false };
            goes = host_goes_on(h, &p);
        }
        exchange(r);
    }
    host_has_done(h);
    return goes;
}


// All of it
// ---------

static double visit_gap(const tour_problem *t, const double **here, const tour_visit *v)
{
    const tour_stroke *s = &t->stroke[v->stroke];
    const double length  = apart(*here, t->point[s->first + v->point]);

    *here = t->point[s->first + (s->closed ? v->point : 1 - v->point)];
    return length;
}

double tour_length(const tour_problem *t, const tour_visit way[])
{
    const double *here = t->from;
    double sum         = 0;

    for (size_t k = 0; k < t->count; k++)
        sum += visit_gap(t, &here, &way[k]);
    return sum + (t->returns ? apart(here, t->from) : 0);
}

static void tour_open(tour *r, const tour_problem *t)
{
    const uint32_t n = (uint32_t)t->count + 1;

    *r = (tour){ .t = t, .strokes = n, .most = t->effort * UNITS, .seed = 88172645463325252u };
    r->at    = memory_grow(NULL, 2 * n * sizeof *r->at);
    r->point = memory_grow(NULL, n * sizeof *r->point);
    r->list  = memory_grow(NULL, n * sizeof *r->list);
    r->place = memory_grow(NULL, n * sizeof *r->place);
    r->near  = memory_grow(NULL, 2 * n * sizeof *r->near);
    r->queue = memory_grow(NULL, n * sizeof *r->queue);
    r->waits = memory_grow(NULL, n * sizeof *r->waits);
    for (uint32_t s = 0; s < n; s++) {
        r->waits[s] = false;
        r->place[s] = NONE;
        r->point[s] = 0;
        for (uint32_t k = 0; k < 2; k++)
            memcpy(r->at[2 * s + k],
                   s + 1 == n ? t->from : t->point[t->stroke[s].first + (is_closed(r, s) ? 0 : k)],
                   sizeof r->at[2 * s + k]);
    }
}

static void tour_close(tour *r)
{
    free(r->at);
    free(r->point);
    free(r->list);
    free(r->place);
    free(r->near);
    free(r->queue);
    free(r->waits);
    free(r->done);
}

/* From the place where the way begins: in the direction in which it leaves that. */
static void give_visits(const tour *r, tour_visit out[])
{
    const uint32_t last = r->strokes - 1;
    uint32_t p          = r->place[last];
    const bool ahead    = r->list[p] == 2 * last + 1;

    for (size_t k = 0; k < r->t->count; k++) {
        p = ahead ? after(r, p) : before(r, p);
        const uint32_t e = r->list[p] ^ (uint32_t)!ahead, s = e >> 1;
        out[k] = (tour_visit){ s, is_closed(r, s) ? r->point[s] : (e & 1) };
    }
}

double tour_find(const tour_problem *t, tour_visit out[])
{
    points p;
    tour r;

    for (size_t k = 0; k < t->count; k++)
        out[k] = (tour_visit){ k, 0 };
    const double given = tour_length(t, out);
    if (t->count == 0)
        return given;
    points_make(&p, t);
    grid g = { .at = (const double (*)[2])p.at, .stroke = p.stroke };
    grid_make(&g, p.id, p.count);
    tour_open(&r, t);
    find_neighbours(&r, &p, &g);
    nearest_first(&r, &p, &g);
    const bool whole = improve_all(&r);
    give_visits(&r, out);
    grid_free(&g);
    points_free(&p);
    tour_close(&r);
    const double found = tour_length(t, out);
    if (found <= given || !whole)
        return whole ? found : -1;
    for (size_t k = 0; k < t->count; k++)
        out[k] = (tour_visit){ k, 0 };
    return given;
}

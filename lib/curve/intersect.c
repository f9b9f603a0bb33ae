/* lib/curve/intersect.c
 * SPDX-License-Identifier: MIT
 *
 * The search examines pairs of pieces, one of each curve, starting with both whole curves. What is
 * not within 7/8 tol of the other piece is cut off (curve/clip.h). If neither piece loses a
 * quarter, the pair is dropped if its hulls are more than tol / 2 apart; otherwise one piece is
 * halved. Both go on until they are straight: all control points are within tol / 8 of the even
 * steps along the chord; then the curve is within tol / 8 of the chord at the same parameter. The
 * chords decide: they meet if their distance is at most tol / 2. So
 *
 *     curves that meet    have chords within  tol / 4 < tol / 2       none is missed
 *     chords that meet    have curves within  tol / 2 + tol / 4       none is invented
 *
 * and a quarter of tol is left on both sides for rounding. No part whose chords meet is cut off,
 * because 7/8 tol is more than 3/4 tol.
 *
 * Chords. The smallest distance (geom/chord_pair.h) may be wrong by sqrt(d L), with d = 4 ulp
 * (2^-30 in q16; 2^-43 L in f32) and L the length. That is below tol / 8 for L <= tol^2 / (256 ulp)
 * and L <= 2^14 tol. A longer chord is halved first, unless the whole of it or of the other is
 * within tol / 2: then they meet all along, and no search is needed. L is always kept below 2^18
 * tol, because a parameter on the chord is a loft_unit: 2^-24 L.
 *
 * The traversal. A piece of 2^-24 is straight: second differences are 2^-48 of 4 times the largest
 * coordinate, 2^-31 in q16. So each curve is halved at most 24 times, and at most 48 pairs wait.
 *
 * Stretches. The (sigma, tau) where two chords are within tol / 2 of each other form a convex set.
 * Two such sets of neighbouring pairs meet on the common edge. Joining those whose ranges touch
 * gives the whole stretch. It ends where the chords are 1/2 to 5/8 tol apart.
 *
 * A stretch that both curves share from end to end is sought once the search has halved often
 * (curve/overlap.h). Pairs of pieces that meet only there are skipped from then on, so the rest is
 * found as quickly as without the stretch. */
#include "curve/intersect.h"
#include "curve/clip.h"         /* loft_piece_clip */
#include "curve/overlap.h"      /* loft_bezier_overlap */
#include "geom/chord_pair.h"    /* loft_chord_closest */

#define HALVINGS 24
#define CHEAP    3      /* halvings that cost less than a look whether hulls are apart  */
#define PATIENT  16     /* halvings before a shared stretch is sought: it costs as much */

/* The current piece of a curve, and whether it is straight without and with the limit of L: of
 * from..to. */
typedef struct {
    loft_piece x;
    uint32_t   from, to;
    bool       flat, straight;
} side;

typedef struct {
    uint32_t a_from, a_to, b_from, b_to;
} waiting;

typedef struct {
    side a, b;
    waiting waits[2 * HALVINGS];
    unsigned depth, halvings;
    loft_acc eighth, half;                  /* of tol                      */
    loft_acc short_enough, long_enough;     /* the limits of L, as above   */
    loft_overlap shared;
    bool shares;
} search;


/* One piece */

/* True if the control points are within `limit` of the even steps along the chord. */
static bool is_piece_flat(const loft_piece *x, loft_acc limit)
{
    const unsigned n = x->b->degree;
    loft_acc off[LOFT_AXES];

    for (unsigned k = 1; k < n; k++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            off[i] = x->p[i][k] - loft_acc_lerp_at(x->p[i][0], x->p[i][n], k, n);
            if (loft_acc_abs(off[i]) > limit)
                return false;
        }
        if (loft_acc_hypot(off, LOFT_AXES) > limit)
            return false;
    }
    return true;
}

/* Decide whether the piece is straight, if it is another one than before. */
static void judge_side(const search *z, side *s)
{
    const bool last = s->x.to - s->x.from == 1;

    if (s->from == s->x.from && s->to == s->x.to)
        return;
    s->from = s->x.from;
    s->to = s->x.to;
    s->flat = last || (s->x.reach <= z->long_enough && is_piece_flat(&s->x, z->eighth));
    if (s->flat) {
        loft_piece_aim(&s->x);
        s->flat = last || s->x.chord.length <= z->long_enough;
    }
    s->straight = last || (s->flat && s->x.chord.length <= z->short_enough);
}

/* The largest extent along an axis. */
static loft_acc piece_size(const loft_piece *x)
{
    loft_acc size = 0, low, high;

    for (int i = 0; i < LOFT_AXES; i++) {
        loft_piece_range(x, i, &low, &high);
        size = loft_acc_max(size, high - low);
    }
    return size;
}


/* Crossings */

static bool ranges_touch(loft_unit from, loft_unit to, loft_unit other_from, loft_unit other_to)
{
    const loft_unit slack = LOFT_UNIT(1.0 / 1048576);
    return from <= other_to + slack && other_from <= to + slack;
}

static void widen_range(loft_unit *from, loft_unit *to, loft_unit other_from, loft_unit other_to)
{
    if (other_from < *from)
        *from = other_from;
    if (other_to > *to)
        *to = other_to;
}

/* Merge `other` into c. */
static void unite_crossings(loft_crossing *c, const loft_crossing *other)
{
    loft_crossing both = other->distance < c->distance ? *other : *c;

    widen_range(&both.s_from, &both.s_to, c->s_from, c->s_to);
    widen_range(&both.s_from, &both.s_to, other->s_from, other->s_to);
    widen_range(&both.t_from, &both.t_to, c->t_from, c->t_to);
    widen_range(&both.t_from, &both.t_to, other->t_from, other->t_to);
    *c = both;
}

/* Merge all crossings that c touches into it, then insert c, sorted by s. False if `out` is
 * full. */
static bool add_crossing(loft_crossing c, loft_crossing out[], size_t room, size_t *count)
{
    size_t k = 0;

    while (k < *count) {
        if (ranges_touch(c.s_from, c.s_to, out[k].s_from, out[k].s_to) &&
            ranges_touch(c.t_from, c.t_to, out[k].t_from, out[k].t_to)) {
            unite_crossings(&c, &out[k]);
            for (--*count; k < *count; k++)
                out[k] = out[k + 1];
            k = 0;
        } else {
            k++;
        }
    }
    if (*count == room)
        return false;
    for (k = (*count)++; k > 0 && out[k - 1].s > c.s; k--)
        out[k] = out[k - 1];
    out[k] = c;
    return true;
}

static loft_chord_pair pair_of(const loft_piece *a, const loft_piece *b)
{
    loft_chord_pair c = { &a->chord, &b->chord, { 0 } };

    for (int i = 0; i < LOFT_AXES; i++)
        c.apart[i] = a->p[i][0] - b->p[i][0];
    return c;
}

/* The stretch from..to of the piece x, around its point at `at`, which is near. */
static void near_range(const search *z, const loft_piece *x, const loft_chord_pair *c,
                       const loft_foot end[2], loft_unit at, loft_acc gap, loft_unit *from,
                       loft_unit *to)
{
    const loft_acc most = z->half + z->eighth;
    const loft_foot in = { at, 0, gap, 0 };

    *from = loft_piece_at(x, loft_chord_near_end(c, in, end[0], z->half, most));
    *to = loft_piece_at(x, loft_chord_near_end(c, in, end[1], z->half, most));
}

/* Where the chords of the current pair meet; false if they do not. */
static bool chords_meet(const search *z, loft_crossing *c)
{
    const loft_piece *a = &z->a.x, *b = &z->b.x;
    const bool by_a = a->chord.length <= b->chord.length;
    const loft_chord_pair on_a = pair_of(a, b), on_b = pair_of(b, a);
    loft_foot end_a[2], end_b[2];

    loft_chord_ends(by_a ? &on_a : &on_b, by_a ? end_a : end_b);
    const loft_foot f = loft_chord_closest(by_a ? &on_a : &on_b, by_a ? end_a : end_b,
                                           loft_acc_ratio(z->eighth, 256));
    if (f.gap > z->half)
        return false;
    loft_chord_ends(by_a ? &on_b : &on_a, by_a ? end_b : end_a);
    c->distance = f.gap;
    c->s = by_a ? f.at : f.other;
    c->t = by_a ? f.other : f.at;
    near_range(z, a, &on_a, end_a, c->s, f.gap, &c->s_from, &c->s_to);
    near_range(z, b, &on_b, end_b, c->t, f.gap, &c->t_from, &c->t_to);
    return true;
}

/* Add the crossing of the chords of the current pair if they meet. False if `out` is full. */
static bool add_chord_crossing(const search *z, loft_crossing out[], size_t room, size_t *count)
{
    const loft_piece *a = &z->a.x, *b = &z->b.x;
    loft_crossing c;
    loft_acc dot = 0;

    if (!chords_meet(z, &c))
        return true;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc x = a->p[i][0] + loft_acc_scale(a->chord.u[i], c.s),
                       y = b->p[i][0] + loft_acc_scale(b->chord.u[i], c.t);
        c.point.axis[i] = loft_acc_round(loft_acc_ratio(x + y, 2));
        dot += loft_acc_scale(loft_acc_scale(loft_to_acc(LOFT_REAL(1)), a->chord.toward[i]),
                              b->chord.toward[i]);
    }
    c.s       = loft_piece_at(a, c.s);
    c.t       = loft_piece_at(b, c.t);
    c.along   = dot >= 0;
    c.overlap = false;
    return add_crossing(c, out, room, count);
}

/* Curves that agree on a stretch do so until one of them ends. The direction of the second curve
 * follows from the ends of a long stretch: if the first curve turns back within tol, its direction
 * at one place means little. */
static void judge_crossing(const search *z, loft_crossing *c, loft_acc least)
{
    const bool s_ends[2] = { !(c->s_from > 0), !(c->s_to < LOFT_UNIT(1)) },
               t_ends[2] = { !(c->t_from > 0), !(c->t_to < LOFT_UNIT(1)) };

    if (!((s_ends[0] || t_ends[0] || t_ends[1]) && (s_ends[1] || t_ends[0] || t_ends[1])))
        return;
    const loft_vec from = loft_bezier_eval(z->a.x.b, c->s_from),
                   to = loft_bezier_eval(z->a.x.b, c->s_to);
    const loft_vec middle = loft_bezier_eval(z->a.x.b, c->s_from + (c->s_to - c->s_from) / 2);
    const loft_vec t_from = loft_bezier_eval(z->b.x.b, c->t_from),
                   t_to = loft_bezier_eval(z->b.x.b, c->t_to);
    const loft_acc straight = loft_vec_distance(from, t_from) + loft_vec_distance(to, t_to);
    const loft_acc crossed = loft_vec_distance(from, t_to) + loft_vec_distance(to, t_from);
    const bool along = straight < crossed || (straight <= crossed && c->along);

    const bool starts = s_ends[0] || t_ends[along ? 0 : 1],
               ends = s_ends[1] || t_ends[along ? 1 : 0];

    c->overlap = starts && ends &&
                 (loft_vec_distance(from, to) > least || loft_vec_distance(from, middle) > least);
    if (c->overlap)
        c->along = along;
}


/* The traversal */

/* True if all of a's chord is near b's: both its ends are. */
static bool is_chord_along(const loft_piece *a, const loft_piece *b, loft_acc gap)
{
    const loft_chord_pair c = pair_of(a, b);
    return loft_chord_foot_at(&c, 0).gap <= gap && loft_chord_foot_at(&c, LOFT_UNIT(1)).gap <= gap;
}

static bool is_pair_straight(search *z)
{
    side *a = &z->a, *b = &z->b;

    judge_side(z, a);
    judge_side(z, b);
    return (a->straight && b->straight) ||
           (a->flat && b->flat &&
            (is_chord_along(&a->x, &b->x, z->half) || is_chord_along(&b->x, &a->x, z->half)));
}

/* Halve the piece that needs it, or the larger one if both do; the second half waits. */
static void halve_pair(search *z)
{
    side *a = &z->a, *b = &z->b;
    const bool halve_a = !a->straight && (b->straight || piece_size(&a->x) >= piece_size(&b->x));
    loft_piece *x = halve_a ? &a->x : &b->x;
    const uint32_t from = x->from, middle = from + (x->to - from) / 2;
    waiting second = { a->x.from, a->x.to, b->x.from, b->x.to };

    *(halve_a ? &second.a_from : &second.b_from) = middle;
    z->waits[z->depth++] = second;
    loft_piece_cut(x, from, middle);
    z->halvings++;
}

/* The shared stretch is a crossing. False if `out` is full. */
static bool add_shared(const search *z, loft_crossing out[], size_t room, size_t *count)
{
    const loft_overlap *o = &z->shared;
    const bool along = o->t_from < o->t_to;
    loft_crossing c;

    c.s = c.s_from = o->s_from;
    c.s_to     = o->s_to;
    c.t        = o->t_from;
    c.t_from   = along ? o->t_from : o->t_to;
    c.t_to     = along ? o->t_to : o->t_from;
    c.point = loft_vec_lerp(loft_bezier_eval(z->a.x.b, c.s), loft_bezier_eval(z->b.x.b, c.t),
                            LOFT_UNIT(0.5));
    c.distance = o->distance;
    c.along    = along;
    c.overlap  = true;
    return add_crossing(c, out, room, count);
}

/* True if nothing is left to find in this pair but the shared stretch. */
static bool is_pair_covered(const search *z)
{
    const loft_piece *a = &z->a.x, *b = &z->b.x;
    return z->shares && loft_overlap_covers(&z->shared, a->b, loft_piece_from(a), loft_piece_to(a),
                                            loft_piece_from(b), loft_piece_to(b));
}

/* Search the current pair, until it is done or halved parts of it wait. False if `out` is full. */
static bool search_pair(search *z, loft_real tol, loft_crossing out[], size_t room, size_t *count)
{
    loft_piece *a = &z->a.x, *b = &z->b.x;

    while (!is_pair_covered(z)) {
        bool less;

        if (is_pair_straight(z))
            return add_chord_crossing(z, out, room, count);
        if (!loft_piece_clip(a, b, 7 * z->eighth, &less))
            return true;
        if (less)
            continue;
        if (z->halvings > CHEAP && loft_piece_hulls_apart(a, b, z->half))
            return true;
        halve_pair(z);
        if (z->halvings == PATIENT) {
            z->shares = loft_bezier_overlap(a->b, b->b, tol, &z->shared);
            if (z->shares && !add_shared(z, out, room, count))
                return false;
        }
    }
    return true;
}

static bool search_pairs(search *z, loft_real tol, loft_crossing out[], size_t room, size_t *count)
{
    if (loft_piece_boxes_apart(&z->a.x, &z->b.x, z->half))
        return true;
    while (search_pair(z, tol, out, room, count)) {
        if (z->depth == 0)
            return true;
        const waiting *w = &z->waits[--z->depth];
        loft_piece_cut(&z->a.x, w->a_from, w->a_to);
        loft_piece_cut(&z->b.x, w->b_from, w->b_to);
    }
    return false;
}

static loft_acc largest_coordinate(const loft_bezier *b, loft_acc most)
{
    for (unsigned k = 0; k <= b->degree; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (loft_acc_abs(loft_to_acc(b->p[k].axis[i])) > most)
                most = loft_acc_abs(loft_to_acc(b->p[k].axis[i]));
    return most;
}

enum loft_status loft_bezier_intersect(const loft_bezier *a, const loft_bezier *b, loft_real tol,
                                       loft_crossing out[], size_t room, size_t *count)
{
    const loft_acc wide = loft_to_acc(tol), size = largest_coordinate(b, largest_coordinate(a, 0)),
                   ulp = loft_acc_ulp(size);
    search z;

    *count = 0;
    if (!(tol > 0) || LOFT_AXES < 2)
        return LOFT_ERR_ARG;
    if (!loft_real_valid(tol) || wide < 2 * loft_real_ulp(size) || wide < 16384 * ulp)
        return LOFT_ERR_RANGE;

    z.depth = z.halvings = 0;
    z.shares = false;
    z.eighth = loft_acc_ratio(wide, 8);
    z.half   = loft_acc_ratio(wide, 2);
    z.long_enough = tol < LOFT_REAL(2048) ? 262144 * wide : loft_to_acc(LOFT_REAL_MAX);
    z.short_enough = loft_acc_mul(wide, wide > 4194304 * ulp ? LOFT_REAL(16384)
                                                             : loft_acc_quot(wide, 256 * ulp));

    loft_piece_start(&z.a.x, a);
    loft_piece_start(&z.b.x, b);
    z.a.from = z.a.to = z.b.from = z.b.to = 0;
    const bool complete = search_pairs(&z, tol, out, room, count);
    bool overlaps = false;
    for (size_t k = 0; k < *count; k++) {
        judge_crossing(&z, &out[k], 4 * wide);
        overlaps = overlaps || out[k].overlap;
    }
    return !complete ? LOFT_MORE : overlaps ? LOFT_SINGULAR : LOFT_OK;
}

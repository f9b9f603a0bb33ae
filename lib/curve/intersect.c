/* lib/curve/intersect.c
 * SPDX-License-Identifier: MIT
 *
 * The search examines pairs of pieces, one of each curve, starting with both whole curves. A pair
 * is dropped if its hulls are more than tol / 2 apart: along an axis, or along the direction
 * between the nearest points of the two chords (for any direction u, min <b_i, u> - max <a_i, u> is
 * a lower bound). Otherwise one piece is halved, until both are straight. A piece is straight if
 * all control points are within tol / 8 of the even steps along the chord; then the curve is within
 * tol / 8 of the chord at the same parameter. The chords decide: they meet if their distance is at
 * most tol / 2. So
 *
 *     curves that meet    have chords within  tol / 4 < tol / 2       none is missed
 *     chords that meet    have curves within  tol / 2 + tol / 4       none is invented
 *
 * and a quarter of tol is left on both sides for rounding.
 *
 * Chords. The distance of the point at sigma of one segment from the other segment is convex in
 * sigma, so bisection by the sign of its slope finds the minimum. The sign may be wrong if the
 * slope is within d of 0, where d is the error of a nearest point. At an angle theta the distance
 * is then off by less than d / sin theta. On a chord of length L it is also off by less than L sin
 * theta, so by less than sqrt(d L). With d = 4 ulp (2^-30 in q16; 2^-43 L in f32) that is below tol
 * / 8 for L <= tol^2 / (256 ulp) and L <= 2^14 tol. A longer chord is halved first, unless the
 * whole of it or of the other is within tol / 2: then they meet all along, and no search is needed.
 * L is always kept below 2^18 tol, because a parameter on the chord is a loft_unit: 2^-24 L.
 *
 * The traversal. One flag per level stores which of the two was halved on the way down: a piece has
 * at most LOFT_DYAD_LEVELS = 24 levels, hence there are at most 48 flags. At level 24 a piece
 * counts as straight. (It is: second differences are 2^-48 of 4 times the largest coordinate, 2^-31
 * in q16.)
 *
 * Stretches. The (sigma, tau) where two chords are within tol / 2 of each other form a convex set.
 * Two such sets of neighbouring pairs meet on the common edge. Joining those whose ranges touch
 * gives the whole stretch.
 *
 * A stretch that both curves share from end to end is known beforehand (curve/overlap.h). Pairs of
 * pieces that meet only there are skipped, so the rest is found as quickly as without the
 * stretch. */
#include "curve/intersect.h"
#include "basis/dyadic.h"   /* loft_dyad, loft_bernstein_sub */
#include "curve/overlap.h"  /* loft_bezier_overlap */
#include "geom/chord.h"     /* loft_chord_foot */

#define STEPS ((uint32_t)1 << LOFT_DYAD_LEVELS)

/* A curve and its current piece. */
typedef struct {
    const loft_bezier *b;
    loft_dyad n;
    loft_acc   p[LOFT_AXES][LOFT_DEGREE_MAX + 1];
    loft_acc   size;                /* its largest extent along an axis */
    loft_chord chord;
    bool       flat, straight;      /* as above: without, and with the limit of L */
} side;

typedef struct {
    side a, b;
    bool halved_a[2 * LOFT_DYAD_LEVELS];
    unsigned depth;
    loft_acc eighth, half;                  /* of tol                      */
    loft_acc short_enough, long_enough;     /* the limits of L, as above   */
    loft_overlap shared;
    bool shares;
} search;



/* One piece */

/* Are the control points within `limit` of the even steps along the chord? */
static bool is_side_flat(const side *s, loft_acc limit)
{
    const unsigned n = s->b->degree;
    loft_acc off[LOFT_AXES];

    for (unsigned k = 1; k < n; k++) {
        for (int i = 0; i < LOFT_AXES; i++)
            off[i] = s->p[i][k] - loft_acc_lerp_at(s->p[i][0], s->p[i][n], k, n);
        if (loft_acc_hypot(off, LOFT_AXES) > limit)
            return false;
    }
    return true;
}

static void axis_range(const side *s, int axis, loft_acc *low, loft_acc *high)
{
    *low = *high = s->p[axis][0];
    for (unsigned k = 1; k <= s->b->degree; k++) {
        if (s->p[axis][k] < *low)
            *low = s->p[axis][k];
        if (s->p[axis][k] > *high)
            *high = s->p[axis][k];
    }
}

static void cut_side(search *z, side *s)
{
    loft_acc c[LOFT_DEGREE_MAX + 1], low, high;

    s->size = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k <= s->b->degree; k++)
            c[k] = loft_to_acc(s->b->p[k].axis[i]);
        loft_bernstein_sub(c, s->b->degree, loft_dyad_from(s->n), loft_dyad_to(s->n), s->p[i]);
        s->chord.u[i] = s->p[i][s->b->degree] - s->p[i][0];
        axis_range(s, i, &low, &high);
        if (high - low > s->size)
            s->size = high - low;
    }
    loft_chord_aim(&s->chord);
    const bool last = s->n.level == LOFT_DYAD_LEVELS;
    s->flat     = last || (s->chord.length <= z->long_enough && is_side_flat(s, z->eighth));
    s->straight = last || (s->chord.length <= z->short_enough && s->flat);
}

/* Move x to the nearest point of the chord; r is the old x minus the new one. */
static void move_to_chord(const side *s, loft_acc x[], loft_acc r[])
{
    loft_acc w[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        w[i] = x[i] - s->p[i][0];
    loft_chord_foot(&s->chord, w, r);
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] -= r[i];
}

/* The maximum of <p_k - x, u> (sign 1) or of its negative (sign -1), but at least 0. */
static loft_acc hull_extreme(const side *s, const loft_acc x[], const loft_unit u[], int32_t sign)
{
    loft_acc most = 0;

    for (unsigned k = 0; k <= s->b->degree; k++) {
        loft_acc along = 0;
        for (int i = 0; i < LOFT_AXES; i++)
            along += loft_acc_scale(s->p[i][k] - x[i], u[i]);
        if (sign * along > most)
            most = sign * along;
    }
    return most + loft_acc_scale(most, LOFT_UNIT(1.0 / 4194304));       /* |u| may be 1 +- 2^-23 */
}


/* A pair of pieces */

static bool are_sides_apart(const side *a, const side *b, loft_acc gap)
{
    loft_acc x[LOFT_AXES], y[LOFT_AXES], r[LOFT_AXES], low_a, high_a, low_b, high_b;
    loft_unit u[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        axis_range(a, i, &low_a, &high_a);
        axis_range(b, i, &low_b, &high_b);
        if (low_b - high_a > gap || low_a - high_b > gap)
            return true;
        x[i] = b->p[i][0] + loft_acc_ratio(b->chord.u[i], 2);
    }
    move_to_chord(a, x, r);
    move_to_chord(b, x, r);
    for (int i = 0; i < LOFT_AXES; i++)
        y[i] = x[i];
    move_to_chord(a, x, r);                     /* r = y - x, from a to b */

    const loft_acc m = loft_acc_hypot(r, LOFT_AXES);
    if (m <= gap)
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        u[i] = loft_unit_ratio(r[i], m);
    return m - hull_extreme(a, x, u, 1) - hull_extreme(b, y, u, -1) - 4 * loft_hypot_ulp(m) > gap;
}

/* The distance of the point at sigma of a's chord from b's chord, the parameter tau there, and the
 * slope along a. */
static loft_acc chord_gap_at(const side *a, const side *b, loft_unit sigma, loft_unit *tau,
                             loft_acc *slope)
{
    loft_acc w[LOFT_AXES], r[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        w[i] = a->p[i][0] + loft_acc_scale(a->chord.u[i], sigma) - b->p[i][0];
    const loft_acc at = loft_chord_foot(&b->chord, w, r);
    *tau = at <= 0 ? 0 : at < b->chord.length ? loft_unit_ratio(at, b->chord.length) : LOFT_UNIT(1);
    *slope = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        *slope += loft_acc_scale(r[i], a->chord.toward[i]);
    return loft_acc_hypot(r, LOFT_AXES);
}

static bool is_chord_near(const side *a, const side *b, loft_unit sigma, loft_acc gap)
{
    loft_unit tau;
    loft_acc slope;
    return chord_gap_at(a, b, sigma, &tau, &slope) <= gap;
}

/* Is all of a's chord near b's? It is if both its ends are. */
static bool is_chord_along(const side *a, const side *b, loft_acc gap)
{
    return is_chord_near(a, b, 0, gap) && is_chord_near(a, b, LOFT_UNIT(1), gap);
}

/* The smallest distance of the two chords, and its parameters. */
static loft_acc closest_points(const side *a, const side *b, loft_unit *sigma, loft_unit *tau)
{
    uint32_t low = 0, high = STEPS;
    loft_acc slope;

    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        chord_gap_at(a, b, loft_unit_of(middle, STEPS), tau, &slope);
        if (slope > 0)
            high = middle;
        else
            low = middle;
    }
    *sigma = loft_unit_of(low, STEPS);
    const loft_acc left = chord_gap_at(a, b, *sigma, tau, &slope),
                   right = chord_gap_at(a, b, loft_unit_of(high, STEPS), tau, &slope);
    if (right < left) {
        *sigma = loft_unit_of(high, STEPS);
        return right;
    }
    return chord_gap_at(a, b, *sigma, tau, &slope);
}

/* The last parameter from sigma, which is near, toward `end` that is near, plus 2^-10 of the
 * distance. */
static loft_unit near_range_end(const side *a, const side *b, loft_unit sigma, loft_unit end,
                                loft_acc gap)
{
    if (is_chord_near(a, b, end, gap))
        return end;
    for (int round = 0; round < 10; round++) {
        const loft_unit middle = sigma + (end - sigma) / 2;
        if (is_chord_near(a, b, middle, gap))
            sigma = middle;
        else
            end = middle;
    }
    return end;
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

/* Add the crossing of the chords of the current pair if they meet. False if `out` is full. */
static bool add_chord_crossing(const search *z, loft_crossing out[], size_t room, size_t *count)
{
    const side *a = &z->a, *b = &z->b;
    const loft_acc gap = z->half;
    loft_crossing c;
    loft_unit sigma, tau;
    loft_acc dot = 0;

    c.distance = a->chord.length <= b->chord.length ? closest_points(a, b, &sigma, &tau)
                                                    : closest_points(b, a, &tau, &sigma);
    if (c.distance > gap)
        return true;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc x = a->p[i][0] + loft_acc_scale(a->chord.u[i], sigma),
                       y = b->p[i][0] + loft_acc_scale(b->chord.u[i], tau);
        c.point.axis[i] = loft_acc_round(loft_acc_ratio(x + y, 2));
        dot += loft_acc_scale(loft_acc_scale(loft_to_acc(LOFT_REAL(1)), a->chord.toward[i]),
                              b->chord.toward[i]);
    }
    c.s       = loft_dyad_at(a->n, sigma);
    c.t       = loft_dyad_at(b->n, tau);
    c.s_from  = loft_dyad_at(a->n, near_range_end(a, b, sigma, 0, gap));
    c.s_to    = loft_dyad_at(a->n, near_range_end(a, b, sigma, LOFT_UNIT(1), gap));
    c.t_from  = loft_dyad_at(b->n, near_range_end(b, a, tau, 0, gap));
    c.t_to    = loft_dyad_at(b->n, near_range_end(b, a, tau, LOFT_UNIT(1), gap));
    c.along   = dot >= 0;
    c.overlap = false;
    return add_crossing(c, out, room, count);
}

/* Curves that agree on a stretch do so until one of them ends. The direction of the second curve
 * follows from the ends of a long stretch: if the first curve turns back within tol, its direction
 * at one place means little. */
static void judge_crossing(const search *z, loft_crossing *c, loft_acc least)
{
    const loft_vec from = loft_bezier_eval(z->a.b, c->s_from),
                   to = loft_bezier_eval(z->a.b, c->s_to);
    const loft_vec middle = loft_bezier_eval(z->a.b, c->s_from + (c->s_to - c->s_from) / 2);
    const loft_vec t_from = loft_bezier_eval(z->b.b, c->t_from),
                   t_to = loft_bezier_eval(z->b.b, c->t_to);
    const loft_acc straight = loft_vec_distance(from, t_from) + loft_vec_distance(to, t_to);
    const loft_acc crossed = loft_vec_distance(from, t_to) + loft_vec_distance(to, t_from);
    const bool along = straight < crossed || (straight <= crossed && c->along);

    const bool starts = !(c->s_from > 0) || (along ? !(c->t_from > 0) : !(c->t_to < LOFT_UNIT(1)));
    const bool ends = !(c->s_to < LOFT_UNIT(1)) ||
                      (along ? !(c->t_to < LOFT_UNIT(1)) : !(c->t_from > 0));

    c->overlap = starts && ends &&
                 (loft_vec_distance(from, to) > least || loft_vec_distance(from, middle) > least);
    if (c->overlap)
        c->along = along;
}


/* The traversal */

/* Halve the piece that needs it, or the larger one if both do. False if neither does. */
static bool halve_pair(search *z)
{
    side *a = &z->a, *b = &z->b;

    if ((a->straight && b->straight) ||
        (a->flat && b->flat && (is_chord_along(a, b, z->half) || is_chord_along(b, a, z->half))))
        return false;
    const bool halve_a = !a->straight && (b->straight || a->size >= b->size);
    side *s = halve_a ? a : b;

    z->halved_a[z->depth++] = halve_a;
    s->n = loft_dyad_half(s->n, 0);
    cut_side(z, s);
    return true;
}

/* Go to the pair after the current one and its descendants; false if there is none. */
static bool next_pair(search *z)
{
    for (; z->depth; z->depth--) {
        side *s = z->halved_a[z->depth - 1] ? &z->a : &z->b;
        if (s->n.k % 2 == 0) {
            s->n.k++;
            cut_side(z, &z->a);
            cut_side(z, &z->b);
            return true;
        }
        s->n.k /= 2;
        s->n.level--;
    }
    return false;
}

/* The shared stretch is the first crossing. False if `out` is full. */
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
    c.point = loft_vec_lerp(loft_bezier_eval(z->a.b, c.s), loft_bezier_eval(z->b.b, c.t),
                            LOFT_UNIT(0.5));
    c.distance = o->distance;
    c.along    = along;
    c.overlap  = true;
    return add_crossing(c, out, room, count);
}

/* Is nothing left to find in this pair? */
static bool is_pair_done(const search *z)
{
    const loft_dyad a = z->a.n, b = z->b.n;

    return are_sides_apart(&z->a, &z->b, z->half) ||
           (z->shares && loft_overlap_covers(&z->shared, z->a.b, loft_dyad_from(a), loft_dyad_to(a),
                                             loft_dyad_from(b), loft_dyad_to(b)));
}

static bool walk_pairs(search *z, loft_crossing out[], size_t room, size_t *count)
{
    if (z->shares && !add_shared(z, out, room, count))
        return false;
    cut_side(z, &z->a);
    cut_side(z, &z->b);
    do {
        while (!is_pair_done(z))
            if (!halve_pair(z)) {
                if (!add_chord_crossing(z, out, room, count))
                    return false;
                break;
            }
    } while (next_pair(z));
    return true;
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

    z.a.b = a;
    z.b.b = b;
    z.a.n.k = z.b.n.k = 0;
    z.a.n.level = z.b.n.level = 0;
    z.depth = 0;
    z.eighth = loft_acc_ratio(wide, 8);
    z.half   = loft_acc_ratio(wide, 2);
    z.long_enough = tol < LOFT_REAL(2048) ? 262144 * wide : loft_to_acc(LOFT_REAL_MAX);
    z.short_enough = loft_acc_mul(wide, wide > 4194304 * ulp ? LOFT_REAL(16384)
                                                             : loft_acc_quot(wide, 256 * ulp));

    z.shares = loft_bezier_overlap(a, b, tol, &z.shared);
    const bool complete = walk_pairs(&z, out, room, count);
    bool overlaps = false;
    for (size_t k = 0; k < *count; k++) {
        judge_crossing(&z, &out[k], 4 * wide);
        overlaps = overlaps || out[k].overlap;
    }
    return !complete ? LOFT_MORE : overlaps ? LOFT_SINGULAR : LOFT_OK;
}

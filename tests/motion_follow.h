/* tests/motion_follow.h -- spans followed along their path: how far from it they are, and how fast where which feed is asked for
 * SPDX-License-Identifier: MIT
 *
 * Each span is looked at in parts. A part's place on the path is looked for near that of the part before. The distance is
 * refined around the farthest end of a part; the speed is that of the whole part, exactly.
 */
#ifndef LOFT_TESTS_MOTION_FOLLOW_H
#define LOFT_TESTS_MOTION_FOLLOW_H

#include "motion_uses.h"    /* spans, limits, span_squares, quartic_peak */

#define FOLLOW_PARTS 8

typedef struct {
    double off;         /* the largest distance of the spans from the path, mm                          */
    double missed;      /* the largest distance of the path from the spans: of a tip that was cut, mm   */
    double along;       /* speed along the path, part of the feed there                                 */
    double length;      /* mm                                                                           */
} motion_follow;

typedef struct {
    path         *track;
    unsigned      at;                       /* the chord near the end of the last part   */
    double        s;                        /* where on the path that is, mm             */
    double        extent;                   /* of the largest curve                      */
    motion_follow out;
} follower;

/* A place of the path near a point. `shared`: the path passes there more than once. */
typedef struct {
    double   off, s;
    unsigned chord;
    bool     shared;
} foothold;

/* The nearest place of the curve under chord j: thirds of the parameter, again and again. */
static inline foothold nearest_under(const path *p, unsigned j, const double q[])
{
    const loft_vec *c = p->chain[p->end[j + 1].curve].curve.p;
    const double t1 = p->end[j + 1].t, t0 = p->end[j].curve == p->end[j + 1].curve ? p->end[j].t : 0;
    double low = t0, high = t1, a[LOFT_AXES], b[LOFT_AXES];

    for (int n = 0; n < 30; n++) {
        const double third = (high - low) / 3;
        cubic_at(c, low + third, a);
        cubic_at(c, high - third, b);
        if (distance(q, a) < distance(q, b)) high -= third; else low += third;
    }
    const double part = (low - t0) / (t1 - t0);
    return (foothold){ fmin(distance(q, a), distance(q, b)), p->end[j].s + part * (p->end[j + 1].s - p->end[j].s), j, false };
}

/* The place of the path near q: the nearest one; of those as near as that, to 1/100 of the tolerance, the one that comes
 * nearest to `s`. Looked at are chords s - near..s + near; chord `at` is not far. */
static inline foothold follow_locate(const path *p, unsigned at, const double q[], double s, double near)
{
    static double off[PATH_MAX];
    const double same = arb_value(limits.tol) / 100;
    foothold best = { 1e300, 0, at, false };
    double nearest = 1e300;
    unsigned first = at, last;

    while (first > 0 && p->end[first].s > s - near)
        first--;
    while (first + 2 < p->count && p->end[first + 1].s < s - near)
        first++;
    for (last = first; last + 1 < p->count && (p->end[last].s <= s + near || last == first); last++) {
        off[last] = chord_distance(q, p->end[last].at, p->end[last + 1].at);
        nearest   = off[last] < nearest ? off[last] : nearest;
    }
    for (unsigned j = first; j < last; j++) {
        if (off[j] > nearest + (p->end[j + 1].s - p->end[j].s) / 8 + same)
            continue;
        const foothold h = nearest_under(p, j, q), other = best;
        const bool as_near = fabs(h.off - best.off) <= same;
        if (h.off < best.off - same || (as_near && fabs(h.s - s) < fabs(best.s - s)))
            best = h;
        best.shared = as_near && (other.shared || fabs(h.s - other.s) > 10 * same);
    }
    return best;
}

/* Where q is, about `step` mm on; where a feature smaller than the tolerance is left out, it may be farther. */
static inline foothold follow_step(const follower *f, const double q[], double step)
{
    const double tol = arb_value(limits.tol);
    double near = step + 10 * tol;
    const foothold h = follow_locate(f->track, f->at, q, f->s + step, near);

    if (h.off <= tol)
        return h;
    near += 20 * tol * fmin(curves, 20) + f->extent / 50;
    const foothold far = follow_locate(f->track, f->at, q, f->s + step, near);
    return far.off < h.off ? far : h;
}

/* The largest feed of the curves near the chords first..last. */
static inline double feed_near(const path *p, unsigned first, unsigned last)
{
    const double more = 4 * arb_value(limits.tol), from = p->end[first].s - more, to = p->end[last + 1].s + more;
    double feed = 0;

    while (first > 0 && p->end[first].s > from)
        first--;
    while (last + 2 < p->count && p->end[last + 1].s < to)
        last++;
    for (unsigned c = p->end[first].curve; c <= p->end[last + 1].curve; c++)
        feed = fmax(feed, arb_value(p->chain[c].feed));
    return feed;
}

/* The distance of a point from the part low..high of a span: thirds of its time, again and again. */
static inline double span_distance(const loft_span *s, double low, double high, const double q[])
{
    double a[LOFT_AXES], b[LOFT_AXES];

    for (int n = 0; n < 36; n++) {
        const double third = (high - low) / 3;
        cubic_at(s->p, low + third, a);
        cubic_at(s->p, high - third, b);
        if (distance(q, a) < distance(q, b)) high -= third; else low += third;
    }
    return fmin(distance(q, a), distance(q, b));
}

/* While a part j of `parts` of span k passed, the path went from one chord to another: did the part come by all of them? */
static inline void follow_missed(follower *f, unsigned k, int j, int parts, unsigned from)
{
    for (unsigned n = from + 2; n < f->at; n++) {
        const double *node = f->track->end[n].at;
        f->out.missed = fmax(f->out.missed, span_distance(&spans[k], fmax(0, j - 2.0) / parts, fmin(parts, j + 1.0) / parts, node));
    }
}

/* Inside a part that begins at `s` of the path and is `step` long, is it farther off than at its ends? Thirds again. */
static inline void follow_refine(follower *f, unsigned k, double low, double high, double s, double step)
{
    const double near = step + 10 * arb_value(limits.tol);

    for (int n = 0; n < 6; n++) {
        const double third = (high - low) / 3;
        const motion a = span_at(&spans[k], low + third, limits.tick_hz), b = span_at(&spans[k], high - third, limits.tick_hz);
        const double off_a = follow_locate(f->track, f->at, a.x, s + step / 2, near).off;
        const double off_b = follow_locate(f->track, f->at, b.x, s + step / 2, near).off;
        f->out.off = fmax(f->out.off, fmax(off_a, off_b));
        if (off_a > off_b) high -= third; else low += third;
    }
}

/* Its length, by 8 midpoints. */
static inline double part_length(const loft_span *s, double from, double to)
{
    double sum = 0;
    for (int n = 0; n < 8; n++)
        sum += span_at(s, from + (to - from) * (n + 0.5) / 8, limits.tick_hz).speed;
    return sum / 8 * (to - from) * duration(s);
}

/* Part j of `parts` of span k. */
static inline void follow_part(follower *f, unsigned k, int j, int parts, double noise)
{
    const motion m = span_at(&spans[k], (double)j / parts, limits.tick_hz);
    const double step = part_length(&spans[k], (j - 1.0) / parts, (double)j / parts), s = f->s;
    const unsigned before = f->at;
    double q[5];

    const foothold h = follow_step(f, m.x, step);
    f->at = h.chord;
    f->s  = h.shared ? fmin(s + step, f->track->length) : h.s;
    f->out.length += step;
    f->out.off = fmax(f->out.off, h.off);
    if (h.off > 0.5 * arb_value(limits.tol))
        follow_refine(f, k, (j - 1.0) / parts, (double)j / parts, s, step);
    follow_missed(f, k, j, parts, before);
    const double feed = feed_near(f->track, before < f->at ? before : f->at, before < f->at ? f->at : before);
    span_squares(&spans[k], (j - 1.0) / parts, (double)j / parts, q);
    f->out.along = fmax(f->out.along, use_of(sqrt(quartic_peak(q)), noise, feed));
}

/* Follow the spans along `moved` moves. */
static inline motion_follow follow_path(path *track, const loft_move moves[], unsigned moved)
{
    follower f = { .track = track };
    const double g = grain();

    for (unsigned c = 0; c < moved; c++)
        f.extent = fmax(f.extent, polygon_length(&moves[c].curve));
    path_trace(track, moves, moved, fmax(f.extent / 100, arb_value(limits.tol) / 2));
    for (unsigned k = 0; k < count; k++) {
        const int parts = spans[k].ticks < FOLLOW_PARTS ? spans[k].ticks : FOLLOW_PARTS;
        for (int j = 1; j <= parts; j++)
            follow_part(&f, k, j, parts, sqrt(LOFT_AXES) * 3 * g / duration(&spans[k]));
    }
    return f.out;
}

#endif

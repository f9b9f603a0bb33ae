/* tests/support/motion_follow.h -- follows spans along their path: measures their distance, and
 * their speed relative to the feed there
 * SPDX-License-Identifier: MIT
 *
 * The distance is the Frechet distance: the length of the leash with which a walker goes along the
 * path and a dog along the spans, neither ever going back. So no part of the path is left out, and
 * none is passed twice. Path and spans are replaced by chords within a part of the tolerance. For
 * these the decision whether a leash is long enough is exact. Each pair of chords is a cell, in
 * which the places (s, t) within the leash form a convex set. So the reachable parts of its right
 * and upper side follow from those of the other two sides [Alt and Godau 1995]. Cells are visited
 * in the order of time; only the reachable chords of the path are kept.
 */
#ifndef LOFT_TESTS_MOTION_FOLLOW_H
#define LOFT_TESTS_MOTION_FOLLOW_H

#include <string.h>         /* memcpy */

#ifndef PATH_MAX
#  define PATH_MAX 200000
#endif
#include "support/motion_corners.h" /* corner_share */
#include "support/motion_uses.h"    /* spans, limits, span_squares, quartic_peak */

typedef struct {
    double off;         /* the distance of spans and path, mm; too large by at most twice
                         * `follow_chords` of the tolerance plus `fine`; near corners times tol
                         * / corner */
    double along;       /* speed along the path, as a fraction of the feed there */
} motion_follow;

typedef struct {
    double low, high;   /* parts of a chord; empty if high < low */
} stretch;

typedef struct {
    const path   *track;
    double        leash, error;     /* of the path, and so much less of its chords */
    unsigned      first, last;      /* chords of the path that are reachable now */
    motion_follow out;
} follower;

static const stretch nowhere = { 1, 0 };
static stretch reached[PATH_MAX];   /* on each of them */
static double  share[PATH_MAX];     /* of the leash */

/* Of the tolerance; a test sets it for one that is nearly used up. */
static double follow_chords = 1 / 64.0;

static inline double follow_chord_error(void) { return arb_value(limits.tol) * follow_chords; }

/* The part of the chord a..b within `leash` of q. */
static inline stretch stretch_near(const double a[], const double b[], const double q[],
                                   double leash)
{
    double aa = 0, ab = 0, bb = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        aa += (a[i] - q[i]) * (a[i] - q[i]);
        ab += (a[i] - q[i]) * (b[i] - a[i]);
        bb += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double square = ab * ab - bb * (aa - leash * leash);
    if (!(bb > 0))
        return aa <= leash * leash ? (stretch){ 0, 1 } : nowhere;
    if (square < 0)
        return nowhere;
    const stretch s = { fmax(0, (-ab - sqrt(square)) / bb), fmin(1, (-ab + sqrt(square)) / bb) };
    return s;
}

static inline bool is_stretch(stretch s) { return s.low <= s.high; }

/* The reachable part of `side` in a cell: all of it from below, or the part that is not before the
 * place of entry. */
static inline stretch reachable_side(stretch side, stretch across, stretch opposite)
{
    return is_stretch(across)     ? side
           : is_stretch(opposite) ? (stretch){ fmax(side.low, opposite.low), side.high }
                                  : nowhere;
}

/* How long the leash is on chord j; at its end it is the longer one of two. */
static inline double leash_on(const follower *f, unsigned j)
{
    return f->leash * share[j] - f->error;
}

static inline double leash_after(const follower *f, unsigned j)
{
    return j + 2 < f->track->count ? fmax(leash_on(f, j), leash_on(f, j + 1)) : leash_on(f, j);
}

/* The dog is at `from`, the start: how far can the walker be? */
static inline void follow_begin(follower *f, const double from[])
{
    const path *p = f->track;

    f->first = 0;
    reached[0] = stretch_near(p->end[0].at, p->end[1].at, from, leash_on(f, 0));
    if (reached[0].low > 0)
        reached[0] = nowhere;
    for (f->last = 0;
         is_stretch(reached[f->last]) && reached[f->last].high >= 1 && f->last + 2 < p->count;) {
        const stretch next = stretch_near(p->end[f->last + 1].at, p->end[f->last + 2].at, from,
                                          leash_on(f, f->last + 1));
        f->last++;
        reached[f->last] = next.low > 0 ? nowhere : next;
    }
}

/* The dog runs from one place to another. Returns false if the leash is too short. */
static inline bool follow_run(follower *f, const double from[], const double to[])
{
    const path *p = f->track;
    stretch below = nowhere;
    unsigned first = p->count, last = 0;

    for (unsigned j = f->first; j + 1 < p->count && (j <= f->last || is_stretch(below)); j++) {
        const stretch left = j <= f->last ? reached[j] : nowhere;
        reached[j] = nowhere;
        if (is_stretch(left) || is_stretch(below)) {
            reached[j] = reachable_side(
                stretch_near(p->end[j].at, p->end[j + 1].at, to, leash_on(f, j)), below, left);
            below = reachable_side(stretch_near(from, to, p->end[j + 1].at, leash_after(f, j)),
                                   left, below);
        }
        if (is_stretch(reached[j])) {
            first = j < first ? j : first;
            last  = j;
        }
    }
    f->first = first;
    f->last  = last;
    return first < p->count;
}

/* A place on the path, mm. */
static inline double place_on(const path *p, unsigned chord, double part)
{
    return p->end[chord].s + part * (p->end[chord + 1].s - p->end[chord].s);
}

/* The reachable places, mm along the path. */
static inline stretch reachable_places(const follower *f)
{
    return (stretch){ place_on(f->track, f->first, reached[f->first].low),
                      place_on(f->track, f->last, reached[f->last].high) };
}

/* The largest feed of the curves near these places; f->first and f->last are close. */
static inline double feed_near(const follower *f, stretch s)
{
    const path *p = f->track;
    const double more = 4 * fmax(arb_value(limits.tol), arb_value(limits.corner));
    unsigned first = f->first, last = f->last;
    double feed = 0;

    while (first > 0 && p->end[first].s > s.low - more)
        first--;
    while (first + 2 < p->count && p->end[first + 1].s < s.low - more)
        first++;
    while (last > first && p->end[last].s > s.high + more)
        last--;
    while (last + 2 < p->count && p->end[last + 1].s < s.high + more)
        last++;
    for (unsigned c = p->end[first + 1].curve; c <= p->end[last + 1].curve; c++)
        feed = fmax(feed, arb_value(p->chain[c].feed));
    return feed;
}

/* The number of parts of a span that keeps its chords within their bound. */
static inline int count_parts(const loft_span *s)
{
    const double h = duration(s);
    double most = 0;

    for (int end = 0; end < 2; end++) {
        const motion m = span_at(s, end, limits.tick_hz);
        double sum = 0;
        for (int i = 0; i < LOFT_AXES; i++)
            sum += m.a[i] * m.a[i];
        most = fmax(most, sqrt(sum));
    }
    return 1 + (int)(h * sqrt(most / (8 * follow_chord_error())));
}

/* Its length, by 8 midpoints. */
static inline double part_length(const loft_span *s, double from, double to)
{
    double sum = 0;
    for (int n = 0; n < 8; n++)
        sum += span_at(s, from + (to - from) * (n + 0.5) / 8, limits.tick_hz).speed;
    return sum / 8 * (to - from) * duration(s);
}

/* What rounding to 2^-16 mm adds to a feed in span k, where the plan cannot leave room for it. */
static inline double feed_grains(unsigned k, double feed)
{
    return fmax(0, 6 * 0x1p-16 / duration(&spans[k]) - feed / 1024);
}

/* Compare the speed in a part of span k with the feed there, piece by piece, since the speed is
 * nearly constant in each. The part leads from `before` to the current places. */
static inline void follow_feed(follower *f, unsigned k, double from, double to, stretch before)
{
    const double noise = sqrt(LOFT_AXES) * 3 * grain() / duration(&spans[k]);
    const stretch now = reachable_places(f);
    const int bits = feed_near(f, (stretch){ before.low, before.high }) == feed_near(f, now) ? 1
                                                                                             : 16;

    for (int n = 0; n < bits; n++) {
        const double z0 = (double)n / bits, z1 = (n + 1.0) / bits;
        const stretch s = { before.low + z0 * (now.low - before.low),
                            before.high + z1 * (now.high - before.high) };
        double q[5];
        const double feed = feed_near(f, s);
        span_squares(&spans[k], from + z0 * (to - from), from + z1 * (to - from), q);
        f->out.along = fmax(f->out.along,
                            use_of(sqrt(quartic_peak(q)), noise + feed_grains(k, feed), feed));
    }
}

/* Can the walker go along the path while the dog runs along the spans? `feed`: also compare the
 * speed with the feed there. */
static inline bool follow_all(follower *f, double leash, bool feed)
{
    double at[LOFT_AXES], to[LOFT_AXES];

    f->leash = leash;
    cubic_at(spans[0].p, 0, at);
    follow_begin(f, at);
    for (unsigned k = 0; k < count; k++) {
        const int parts = count_parts(&spans[k]);
        for (int j = 1; j <= parts; j++) {
            const stretch before = reachable_places(f);
            cubic_at(spans[k].p, (double)j / parts, to);
            if (!follow_run(f, at, to))
                return false;
            memcpy(at, to, sizeof at);
            if (feed)
                follow_feed(f, k, (j - 1.0) / parts, (double)j / parts, before);
        }
    }
    return f->last + 2 == f->track->count && reached[f->last].high >= 1;
}

/* Follow the spans along `moved` moves, and bisect for their distance: to `fine` mm, or to 1.5
 * times the error of the chords. */
static inline motion_follow follow_path(path *track, const loft_move moves[], unsigned moved,
                                        double fine)
{
    const double error = 2 * follow_chord_error();
    follower f = { .track = track, .error = error };
    double low = 0, high = arb_value(limits.tol);

    corners_find(moves, corners_matter() ? moved : 0);
    path_trace_by(track, moves, moved, follow_chord_error(),
                  corners_matter() ? chord_is_near_by_corners : chord_is_near);
    corners_measure(track);
    for (unsigned k = 0; k + 1 < track->count; k++)
        share[k] = corner_share(track, k);
    for (bool first = true; !follow_all(&f, high, first) && high < 1e3; first = false) {
        low = high;
        high *= 2;
    }
    while (high - low > fine && high > 1.5 * error) {
        const double middle = fmax((low + high) / 2, 1.25 * error);
        if (follow_all(&f, middle, false))
            high = middle;
        else
            low = middle;
    }
    f.out.off = high;
    return f.out;
}

#endif

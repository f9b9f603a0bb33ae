/* host-tools/plan/certify_compare.c -- how far a curve is from a path
 * SPDX-License-Identifier: MIT
 *
 * A part of a curve between two points a and b is within `bulge` of its chord, at equal parameters:
 * 3/4 of the largest second difference of its control points. Chords of the other path are within
 * `fine` of it. The distance from a segment is convex, so no point of the chord ab is farther from
 * a segment than the farther one of a and b. A part for which this bound is too much is halved,
 * down to parts that are shorter than `fine`.
 *
 * Distances from a chord, and of it, count by its `share`: the tolerance over that of the chord.
 */
#include <math.h>

#include "plan/certify_compare.h"

#define DEPTH 60            /* halvings of a curve */

/* How far the segment from a to b is from chord k at most, as it counts there. */
static double chord_distance(const certify_search *s, size_t k, const double a[ENGINE_AXES],
                             const double b[ENGINE_AXES])
{
    const certify_chords *c = s->to;
    return s->share * c->share[k] *
           fmax(space_segment_distance(a, c->end[k], c->end[k + 1]),
                space_segment_distance(b, c->end[k], c->end[k + 1]));
}

/* The least of these for chords near the last one, or the first that is at most `enough`. The
 * search spreads both ways from the nearest chord so far. What is longer than the tolerance is
 * halved anyway where no chord is beside all of it, so the search ends soon. Otherwise it goes on
 * until something is within the tolerance, or to both ends of the path. */
static double least_distance(certify_search *s, const double a[ENGINE_AXES],
                             const double b[ENGINE_AXES], double enough)
{
    const certify_chords *c = s->to;
    const double size = space_distance(a, b), reach = size > s->tol ? size : s->reach;
    size_t low = s->near, high = low + 1;
    double least = chord_distance(s, s->near, a, b);

    while (least > enough && (low > 0 || high < c->chords)) {
        const double below = low > 0 ? c->s[s->near] - c->s[low] : HUGE_VAL,
                     above = high < c->chords ? c->s[high] - c->s[s->near + 1] : HUGE_VAL;
        if (fmin(below, above) > reach && (least <= s->tol || size > s->tol))
            break;
        const size_t k = above <= below ? high++ : --low;
        const double d = chord_distance(s, k, a, b);
        if (d < least) {
            least   = d;
            s->near = k;
        }
    }
    return least;
}

bool certify_compare(certify_search *s, const certify_cubic *c, double *t)
{
    struct {
        double from, to;
    } part[DEPTH + 2] = { { 0, 1 } };
    const double bulge = certify_bulge(c);
    bool worse = false;

    for (int parts = 1; parts > 0; parts--) {
        const double from = part[parts - 1].from, to = part[parts - 1].to, middle = (from + to) / 2;
        double a[ENGINE_AXES], b[ENGINE_AXES];
        certify_eval(c, from, a);
        certify_eval(c, to, b);
        const double fine = s->share * s->fine,
                     more = s->share * bulge * (to - from) * (to - from) + fine,
                     most = s->worst + s->step, off = least_distance(s, a, b, most - more) + more;
        if (off <= most)
            continue;
        if ((space_distance(a, b) <= s->fine && more <= 2 * fine) || parts > DEPTH) {
            s->worst = off;
            s->worst_share = s->share * s->to->share[s->near];
            *t = middle;
            worse = true;
            continue;
        }
        part[parts - 1].from = middle;      /* the later half waits */
        part[parts].from = from;
        part[parts].to   = middle;
        parts += 2;
    }
    return worse;
}

void certify_points(certify_search *s, const certify_cubic *c)
{
    for (double t = 0.25; t < 1; t += 0.5) {
        double at[ENGINE_AXES];
        certify_eval(c, t, at);
        s->worst = fmax(s->worst, least_distance(s, at, at, s->worst));
    }
}

void certify_again(certify_search *s)
{
    s->worst = fmax(s->worst - 2 * s->step, 0);
    s->near  = 0;
}

void certify_cubic_of_chord(certify_search *s, const certify_chords *c, size_t k,
                            certify_cubic *out)
{
    for (int n = 0; n < 4; n++)
        for (int i = 0; i < ENGINE_AXES; i++)
            out->p[n][i] = n < 3 ? c->end[k][i] + n / 3.0 * (c->end[k + 1][i] - c->end[k][i])
                                 : c->end[k + 1][i];
    s->share = c->share[k];
}

void certify_take(certify_worst *w, const certify_search *s)
{
    w->tol   = s->tol / s->worst_share;
    w->worst = (s->worst + s->step) / s->worst_share;
}

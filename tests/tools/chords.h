/* tests/tools/chords.h -- the chords of a mill's path over and beside a point, by brute force
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_CHORDS_H
#define LOFT_TESTS_CHORDS_H

#include <math.h>
#include <stdlib.h>

#include "engine/mill.h"            /* mill_cut */
#include "tools/drawn.h"            /* CHECK */

#define FREE 1e9

/* Squares of x and y, each with the chords of a path that may be the lowest over some point of it.
 * A square with many is divided when a point comes to lie in it. */
typedef struct squares {
    struct squares *quarter[4];
    double middle[2], half;
    size_t *chord, count;
} squares;

typedef struct {
    const mill_cut *path;
    const mill_order *o;
    squares all;
} chords;

/* How high the underside of a cutter, grown sideways, is over a point at `t` of a chord. */
static double over_point(const mill_order *o, double grown, const double *a, const double *b,
                         double t, const double p[3])
{
    const double x = a[0] + t * (b[0] - a[0]) - p[0], y = a[1] + t * (b[1] - a[1]) - p[1],
                 corner = o->corner, beyond = sqrt(x * x + y * y) - (o->radius + grown - corner);

    return a[2] + t * (b[2] - a[2]) - p[2] +
           (beyond <= 0 ? 0 : corner - sqrt(fmax(0, corner * corner - beyond * beyond)));
}

/* Where a ball is the lowest over a point beside a chord, the slope of its underside is that of the
 * chord. */
static double lowest_of_ball(double length2, double rise, double to, double off2, double r2)
{
    const double across2 = fmax(0, off2 - to * to / length2);

    return to / length2 - rise * sqrt(fmax(0, r2 - across2) / (length2 + rise * rise) / length2);
}

/* The least of it where the cutter is over the point; it is convex there. */
static double over_chord(const mill_order *o, double grown, const double *a, const double *b,
                         const double p[3])
{
    const double x = b[0] - a[0], y = b[1] - a[1], length2 = x * x + y * y,
                 to = (p[0] - a[0]) * x + (p[1] - a[1]) * y,
                 off2 = (p[0] - a[0]) * (p[0] - a[0]) + (p[1] - a[1]) * (p[1] - a[1]),
                 r = o->radius + grown, r2 = r * r;
    double low = 0, high = 1;

    if (length2 > 0) {
        const double half2 = to * to - length2 * (off2 - r2);
        if (half2 < 0)
            return FREE;
        low  = fmax(0, (to - sqrt(half2)) / length2);
        high = fmin(1, (to + sqrt(half2)) / length2);
    }
    if (r <= 0 || low > high || (length2 <= 0 && off2 > r2))
        return FREE;
    if (length2 <= 0)
        low = b[2] < a[2] ? 1 : 0;
    else if (o->corner == r)
        low = fmax(low, fmin(high, lowest_of_ball(length2, b[2] - a[2], to, off2, r2)));
    for (int k = 0; k < 40 && length2 > 0 && o->corner != r; k++) {
        const double t = low + (high - low) * 0.4, u = low + (high - low) * 0.6;
        if (over_point(o, grown, a, b, t, p) < over_point(o, grown, a, b, u, p))
            high = u;
        else
            low = t;
    }
    return over_point(o, grown, a, b, low, p);
}

/* Where a chord is nearest to a point, seen from above. */
static double nearest_place(const double *a, const double *b, const double p[3])
{
    const double x = b[0] - a[0], y = b[1] - a[1], length2 = x * x + y * y,
                 to = (p[0] - a[0]) * x + (p[1] - a[1]) * y;

    return length2 > 0 ? fmax(0, fmin(1, to / length2)) : 0;
}

/* No place of the chord is lower over the point. */
static double least_over(const mill_order *o, double grown, const double *a, const double *b,
                         const double p[3])
{
    const double t = nearest_place(a, b, p), dx = a[0] + t * (b[0] - a[0]) - p[0],
                 dy = a[1] + t * (b[1] - a[1]) - p[1], d = sqrt(dx * dx + dy * dy),
                 corner = o->corner, beyond = d - (o->radius + grown - corner);

    if (d > o->radius + grown)
        return FREE;
    return fmin(a[2], b[2]) - p[2] +
           (beyond <= 0 ? 0 : corner - sqrt(fmax(0, corner * corner - beyond * beyond)));
}

/* One place of the chord is as low as this. */
static double most_over(const mill_order *o, double grown, const double *a, const double *b,
                        const double p[3])
{
    const double t = nearest_place(a, b, p), x = a[0] + t * (b[0] - a[0]) - p[0],
                 y = a[1] + t * (b[1] - a[1]) - p[1], r = o->radius + grown;

    return r > 0 && x * x + y * y <= r * r ? over_point(o, grown, a, b, t, p) : FREE;
}

/* Take from a list the chords that may be the lowest somewhere in the square. With its half
 * diagonal e, over every point the cutter is at least as low as one narrower by e is over the
 * middle, and no lower than one wider by e. */
static void sift_chords(const chords *c, squares *s, const size_t *chord, size_t count)
{
    const double e = s->half * sqrt(2), middle[3] = { s->middle[0], s->middle[1], 0 };
    double rough = FREE, most = FREE, *const least = malloc((count + 1) * sizeof *least);

    s->chord = malloc((count + 1) * sizeof *s->chord);
    CHECK(least != NULL && s->chord != NULL);
    for (size_t i = 0; i < count; i++) {
        const double *const a = c->path->point[chord[i]];
        rough = fmin(rough, most_over(c->o, -e, a, a + ENGINE_AXES, middle));
    }
    for (size_t i = 0; i < count; i++) {        /* what is searched for takes long */
        const double *const a = c->path->point[chord[i]], *const b = a + ENGINE_AXES;
        least[i] = FREE;
        if (least_over(c->o, e, a, b, middle) > rough + 1e-6)
            continue;
        least[i] = over_chord(c->o, e, a, b, middle);
        most     = fmin(most, over_chord(c->o, -e, a, b, middle));
    }
    for (size_t i = 0; i < count; i++)
        if (least[i] < FREE && least[i] <= most + 1e-6)
            s->chord[s->count++] = chord[i];
    free(least);
}

static void index_chords(chords *c, const mill_cut *path, const mill_order *o)
{
    size_t *const every = malloc(path->count * sizeof *every);

    CHECK(every != NULL);
    *c = (chords){ .path = path, .o = o };
    for (int k = 0; k < 2; k++) {
        c->all.middle[k] = (o->area[0][k] + o->area[1][k]) / 2;
        c->all.half      = fmax(c->all.half, (o->area[1][k] - o->area[0][k]) / 2 + o->radius);
    }
    for (size_t k = 0; k + 1 < path->count; k++)
        every[k] = k;
    sift_chords(c, &c->all, every, path->count - 1);
    free(every);
}

static void free_squares(squares *s)
{
    for (int k = 0; k < 4; k++)
        if (s->quarter[k]) {
            free_squares(s->quarter[k]);
            free(s->quarter[k]);
        }
    free(s->chord);
}

static squares *quarter_at(const chords *c, squares *s, const double p[3])
{
    const int right = p[0] > s->middle[0], up = p[1] > s->middle[1];
    squares **const q = &s->quarter[2 * up + right];

    if (*q == NULL) {
        *q = calloc(1, sizeof **q);
        CHECK(*q != NULL);
        (*q)->half = s->half / 2;
        (*q)->middle[0] = s->middle[0] + (right ? s->half : -s->half) / 2;
        (*q)->middle[1] = s->middle[1] + (up ? s->half : -s->half) / 2;
        sift_chords(c, *q, s->chord, s->count);
    }
    return *q;
}

/* How far a point is beside a cutter with a cylinder above it, at `t` of its way. */
static double beside_at(const mill_order *o, const double *a, const double *b, double t,
                        const double p[3])
{
    const double x = a[0] + t * (b[0] - a[0]) - p[0], y = a[1] + t * (b[1] - a[1]) - p[1],
                 above = a[2] + t * (b[2] - a[2]) + o->corner - p[2],
                 beyond = hypot(x, y) - (o->radius - o->corner);

    return hypot(fmax(0, above), fmax(0, beyond)) - o->corner;
}

/* The place of a ball that is nearest to a point: the foot of the point on the way of the centre
 * where that is above the point; the nearest place seen from above where it is below; otherwise
 * between both, where the centre is as high as the point. */
static double nearest_of_ball(const mill_order *o, const double *a, const double *b,
                              const double p[3])
{
    double way[3], off[3], length2 = 0, to = 0;

    for (int k = 0; k < 3; k++) {
        way[k] = b[k] - a[k];
        off[k] = p[k] - a[k] - (k == 2 ? o->radius : 0);
        length2 += way[k] * way[k];
        to += way[k] * off[k];
    }
    const double foot = length2 > 0 ? fmax(0, fmin(1, to / length2)) : 0,
                 seen = nearest_place(a, b, p);
    return off[2] <= foot * way[2] ? foot : off[2] >= seen * way[2] ? seen : off[2] / way[2];
}

/* The least of it: it is convex along the way. */
static double beside_chord(const mill_order *o, const double *a, const double *b, const double p[3])
{
    double low = 0, high = 1;

    if (!(o->corner < o->radius))
        return beside_at(o, a, b, nearest_of_ball(o, a, b, p), p);
    for (int n = 0; n < 40; n++) {
        const double third = (high - low) / 3;
        if (beside_at(o, a, b, low + third, p) < beside_at(o, a, b, high - third, p))
            high -= third;
        else
            low += third;
    }
    return beside_at(o, a, b, (low + high) / 2, p);
}

/* The height of the underside over a point; what is left there, at most, over its surface. */
static double over_path(chords *c, const double p[3], double *left)
{
    squares *s = &c->all;
    double least = FREE;

    if (fmax(fabs(p[0] - s->middle[0]), fabs(p[1] - s->middle[1])) > s->half)
        return FREE;
    while (s->count > 3 && s->half > c->o->radius / 64)
        s = quarter_at(c, s, p);
    for (size_t i = 0; i < s->count; i++) {
        const double *const a = c->path->point[s->chord[i]], *const b = a + ENGINE_AXES;
        if (least_over(c->o, 0, a, b, p) < least)
            least = fmin(least, over_chord(c->o, 0, a, b, p));
        *left = fmin(*left, beside_chord(c->o, a, b, p));
    }
    return least;
}

/* What is left at a point by all of the path: on a wall the nearest chord is not the lowest one. */
static double left_by_all(const chords *c, const double p[3])
{
    double left = FREE;

    for (size_t i = 0; i + 1 < c->path->count; i++) {
        const double *const a = c->path->point[i], *const b = a + ENGINE_AXES;
        const double half = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]) / 2;
        if (beside_at(c->o, a, b, 0.5, p) - half < left)
            left = fmin(left, beside_chord(c->o, a, b, p));
    }
    return left;
}

#endif

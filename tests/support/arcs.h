/* tests/support/arcs.h -- arbitrary arcs, and their reference in long double
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_ARCS_H
#define LOFT_TESTS_ARCS_H

#include "support/rationals.h"          /* exact_of, ulp, exact_at */
#include "curve/circle.h"

static const long double pi = 3.14159265358979323846264338327950288L;

typedef struct {
    long double x, y;
} pair;

/* An arc as long double: centre + u cos a + v sin a + drift a / sweep */
typedef struct {
    pair centre, u, v;
    long double drift[LOFT_AXES], from[LOFT_AXES], sweep, radius, largest;
    loft_plane plane;
} truth;

static inline long double of_raw(int32_t raw) { return raw / 65536.0L; }
static inline loft_real coordinate(long double x) { return (loft_real)(x * BY_NUM(65536, 1, 1)); }

static inline loft_plane arb_plane(arb *a)
{
    const uint8_t first = (uint8_t)arb_below(a, LOFT_AXES),
                  second = (uint8_t)((first + 1 + arb_below(a, LOFT_AXES - 1)) % LOFT_AXES);
    const loft_plane plane = { first, second };
    return plane;
}

static inline pair in_plane(loft_vec v, loft_plane plane)
{
    const pair p = { exact_of(v.axis[plane.first]), exact_of(v.axis[plane.second]) };
    return p;
}

static inline pair minus(pair a, pair b)
{
    const pair c = { a.x - b.x, a.y - b.y };
    return c;
}
static inline long double size(pair a) { return sqrtl(a.x * a.x + a.y * a.y); }

/* The remainder when the ends are given: the drift. */
static inline void complete(truth *t, loft_vec from, loft_vec to, loft_plane plane)
{
    const long double c = cosl(t->sweep), s = sinl(t->sweep);

    t->plane = plane;
    t->largest = t->radius;
    for (int i = 0; i < LOFT_AXES; i++) {
        t->from[i] = exact_of(from.axis[i]);
        t->drift[i] = exact_of(to.axis[i]) - t->from[i];
        t->largest = fmaxl(t->largest, fmaxl(fabsl(t->from[i]), fabsl(exact_of(to.axis[i]))));
    }
    t->largest = fmaxl(t->largest, fmaxl(fabsl(t->centre.x), fabsl(t->centre.y)));
    t->drift[plane.first] = exact_of(to.axis[plane.first]) -
                            (t->centre.x + t->u.x * c + t->v.x * s);
    t->drift[plane.second] = exact_of(to.axis[plane.second]) -
                             (t->centre.y + t->u.y * c + t->v.y * s);
}

static inline void true_point(const truth *t, long double part, long double out[])
{
    const long double a = t->sweep * part;

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = t->from[i] + t->drift[i] * part;
    out[t->plane.first] = t->centre.x + t->u.x * cosl(a) + t->v.x * sinl(a) +
                          t->drift[t->plane.first] * part;
    out[t->plane.second] = t->centre.y + t->u.y * cosl(a) + t->v.y * sinl(a) +
                           t->drift[t->plane.second] * part;
}

typedef struct {
    loft_vec from, to, centre;
    loft_plane plane;
    int32_t turns;
    truth t;
    loft_circle c;
} arc;

/* Ends at the same distance from a centre, or off by a small part of it; radii from a few LSB to
 * the whole range. */
static inline bool arb_centred(arb *a, arc *s)
{
    const long double radius = ldexpl(1 + arb_below(a, 1000) / 1000.0L, (int)arb_below(a, 26) - 11);
    const long double start = arb_below(a, 3) ? arb_below(a, 6284) / 1000.0L
                                              : arb_below(a, 8) * pi / 4;
    const long double end = arb_below(a, 4) ? start + arb_below(a, 6284) / 1000.0L : start;
    const long double off = arb_below(a, 2) ? 1 : 1 + (arb_below(a, 100) - 50.0L) / 20000;
    const bool same = arb_below(a, 8) == 0;

    s->plane = arb_plane(a);
    s->turns = (arb_below(a, 4) ? 1 : 1 + (int32_t)arb_below(a, 20)) * (arb_below(a, 2) ? 1 : -1);
    s->from = arb_vec(a, 1 << arb_below(a, 14));
    s->to = arb_vec(a, 1 << arb_below(a, 14));
    s->centre = arb_vec(a, 1 << arb_below(a, 14));
    const pair m = in_plane(s->centre, s->plane);
    const long double corner[4] = { m.x + radius * cosl(start), m.y + radius * sinl(start),
                                    m.x + off * radius * cosl(end),
                                    m.y + off * radius * sinl(end) };
    for (int i = 0; i < 4; i++)
        if (fabsl(corner[i]) > 32767)
            return false;
    s->from.axis[s->plane.first]  = coordinate(corner[0]);
    s->from.axis[s->plane.second] = coordinate(corner[1]);
    s->to.axis[s->plane.first]    = same ? s->from.axis[s->plane.first] : coordinate(corner[2]);
    s->to.axis[s->plane.second]   = same ? s->from.axis[s->plane.second] : coordinate(corner[3]);
    return true;
}

/* The same by definition, in long double. */
static inline void centred_truth(arc *s)
{
    truth *t = &s->t;
    const pair e = minus(in_plane(s->to, s->plane), in_plane(s->centre, s->plane));
    const int side = s->turns > 0 ? 1 : -1;

    t->centre = in_plane(s->centre, s->plane);
    t->u = minus(in_plane(s->from, s->plane), t->centre);
    t->v.x = -side * t->u.y;
    t->v.y = side * t->u.x;
    t->radius = size(t->u);
    t->sweep = side * (atan2l(e.y, e.x) - atan2l(t->u.y, t->u.x));
    while (t->sweep < 0x1p-48L)
        t->sweep += 2 * pi;
    t->sweep += 2 * pi * (labs(s->turns) - 1);
    complete(t, s->from, s->to, s->plane);
}

static inline bool arb_circle(arb *a, arc *s)
{
    if (!arb_centred(a, s) ||
        loft_circle_from_centre(&s->c, s->from, s->to, s->plane, s->centre, s->turns) != LOFT_OK)
        return false;
    centred_truth(s);
    return true;
}

#endif

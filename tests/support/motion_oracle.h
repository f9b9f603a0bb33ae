/* tests/support/motion_oracle.h -- the reference for spans, in double: their polynomials and the
 * exact path
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_MOTION_ORACLE_H
#define LOFT_TESTS_MOTION_ORACLE_H

#include <math.h>           /* sqrt, fmin, fmax: the reference */

#include "check.h"
#include "motion/plan.h"    /* loft_move, loft_span */

#ifndef PATH_MAX
#  define PATH_MAX 60000
#endif

/* The path as a chain of short chords; each knows its curve. */
typedef struct {
    const loft_move *chain;
    unsigned count;
    double length;
    struct {
        double at[LOFT_AXES], s, t;
        unsigned curve;
    } end[PATH_MAX];
} path;

static inline void cubic_at(const loft_vec p[4], double t, double out[LOFT_AXES])
{
    const double w[4] = { (1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t),
                          3 * t * t * (1 - t), t * t * t };
    for (int i = 0; i < LOFT_AXES; i++) {
        out[i] = 0;
        for (int k = 0; k < 4; k++)
            out[i] += w[k] * arb_value(p[k].axis[i]);
    }
}

static inline double distance(const double a[], const double b[])
{
    double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum);
}

static inline double polygon_length(const loft_cubic *c)
{
    double sum = 0, a[LOFT_AXES], b[LOFT_AXES];
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            a[i] = arb_value(c->p[k].axis[i]);
            b[i] = arb_value(c->p[k + 1].axis[i]);
        }
        sum += distance(a, b);
    }
    return sum;
}

static inline void path_add(path *p, unsigned curve, double t)
{
    const unsigned k = p->count < PATH_MAX ? p->count++ : PATH_MAX - 1;

    p->end[k].t = t;
    p->end[k].curve = curve;
    cubic_at(p->chain[curve].curve.p, t, p->end[k].at);
    p->length += k > 0 ? distance(p->end[k].at, p->end[k - 1].at) : 0;
    p->end[k].s = p->length;
}

/* Is the chord t..t + dt at most `step` long, and its curve close to it? At least 8 per curve. */
static inline bool chord_is_short(const loft_vec c[4], double t, double dt, double step)
{
    double a[LOFT_AXES], b[LOFT_AXES], m[LOFT_AXES], middle[LOFT_AXES];

    cubic_at(c, t, a);
    cubic_at(c, t + dt, b);
    cubic_at(c, t + dt / 2, m);
    for (int i = 0; i < LOFT_AXES; i++)
        middle[i] = (a[i] + b[i]) / 2;
    return dt <= 0.125 && (dt <= 0x1p-14 ||
                           (distance(a, b) <= step && distance(m, middle) <= distance(a, b) / 16));
}

/* Is the curve within `error` of the chord? The bound is an eighth of the second derivative, which
 * is largest at an end, times dt^2. */
static inline bool chord_is_near(const loft_vec c[4], double t, double dt, double error)
{
    double most = 0;

    for (int end = 0; end < 2; end++) {
        double sum = 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            const double x0 = arb_value(c[0].axis[i]), x1 = arb_value(c[1].axis[i]),
                         x2 = arb_value(c[2].axis[i]), x3 = arb_value(c[3].axis[i]);
            const double bend = 6 * ((1 - t - end * dt) * (x0 - 2 * x1 + x2) +
                                     (t + end * dt) * (x1 - 2 * x2 + x3));
            sum += bend * bend;
        }
        most = fmax(most, sqrt(sum));
    }
    return most * dt * dt / 8 <= error;
}

/* Chords that satisfy the condition, each 2^-n of a curve. */
static inline void path_trace_by(path *p, const loft_move moves[], unsigned count, double most,
                                 bool (*fine)(const loft_vec c[4], double t, double dt,
                                              double most))
{
    p->chain  = moves;
    p->count  = 0;
    p->length = 0;
    path_add(p, 0, 0);
    for (unsigned c = 0; c < count; c++) {
        double dt = 1;
        for (double t = 0; t < 1; t += dt, path_add(p, c, t)) {
            dt = fmin(1, 2 * dt);
            while (fmod(t, dt) > 0 || !fine(moves[c].curve.p, t, dt, most))
                dt /= 2;
        }
    }
    CHECK(p->count < PATH_MAX);
}

/* Chords of at most `step` mm, shorter where the curve turns. */
static inline void path_trace(path *p, const loft_move moves[], unsigned count, double step)
{
    path_trace_by(p, moves, count, step, chord_is_short);
}

/* Chords within `error` of their curves. */
static inline void path_trace_near(path *p, const loft_move moves[], unsigned count, double error)
{
    path_trace_by(p, moves, count, error, chord_is_near);
}

static inline double chord_distance(const double q[], const double a[], const double b[])
{
    double dot = 0, len = 0, at[LOFT_AXES];
    for (int i = 0; i < LOFT_AXES; i++) {
        dot += (q[i] - a[i]) * (b[i] - a[i]);
        len += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double t = len > 0 ? fmin(1, fmax(0, dot / len)) : 0;
    for (int i = 0; i < LOFT_AXES; i++)
        at[i] = a[i] + t * (b[i] - a[i]);
    return distance(q, at);
}

/* The distance of q from the curve near chord j: ternary search over the parameter. */
static inline double curve_distance(const path *p, unsigned j, const double q[])
{
    const loft_vec *c = p->chain[p->end[j + 1].curve].curve.p;
    const double t1 = p->end[j + 1].t,
                 t0 = p->end[j].curve == p->end[j + 1].curve ? p->end[j].t : 0,
                 more = (t1 - t0) / 4;
    double low = fmax(0, t0 - more), high = fmin(1, t1 + more), a[LOFT_AXES], b[LOFT_AXES];

    for (int n = 0; n < 30; n++) {
        cubic_at(c, low + (high - low) / 3, a);
        cubic_at(c, high - (high - low) / 3, b);
        if (distance(q, a) < distance(q, b))
            high -= (high - low) / 3;
        else
            low += (high - low) / 3;
    }
    return fmin(distance(q, a), distance(q, b));
}

/* The distance of q from the part of the path at lengths from..to from the start. *at is a chord
 * nearby, for speed, and moves to the nearest one. A curve is searched if its chord is nearest, or
 * almost: its own arch, less than an eighth of its length, may decide. */
static inline double path_distance(const path *p, unsigned *at, const double q[], double from,
                                   double to)
{
    double best = 1e300, nearest = 1e300;
    unsigned first = *at, last;

    while (first > 0 && p->end[first].s > from)
        first--;
    while (first + 2 < p->count && p->end[first + 1].s < from)
        first++;
    for (last = first; last + 1 < p->count && (p->end[last].s <= to || last == first); last++)
        nearest = fmin(nearest, chord_distance(q, p->end[last].at, p->end[last + 1].at));
    for (unsigned j = first; j < last; j++) {
        const double d = chord_distance(q, p->end[j].at, p->end[j + 1].at);
        if (d <= nearest + distance(p->end[j].at, p->end[j + 1].at) / 8) {
            best = fmin(best, curve_distance(p, j, q));
            *at = d <= nearest ? j : *at;
        }
    }
    return best;
}

/* Position, velocity (mm/s) and acceleration (mm/s^2) of a span at the fraction z of its time. */
typedef struct {
    double x[LOFT_AXES], v[LOFT_AXES], a[LOFT_AXES], speed;
} motion;

static inline motion span_at(const loft_span *s, double z, double tick_hz)
{
    const double h = s->ticks / tick_hz;
    double sum = 0;
    motion m;

    cubic_at(s->p, z, m.x);
    for (int i = 0; i < LOFT_AXES; i++) {
        const double p0 = arb_value(s->p[0].axis[i]), p1 = arb_value(s->p[1].axis[i]);
        const double p2 = arb_value(s->p[2].axis[i]), p3 = arb_value(s->p[3].axis[i]);
        m.v[i] = 3 *
                 ((1 - z) * (1 - z) * (p1 - p0) + 2 * z * (1 - z) * (p2 - p1) + z * z * (p3 - p2)) /
                 h;
        m.a[i] = 6 * ((1 - z) * (p0 - 2 * p1 + p2) + z * (p1 - 2 * p2 + p3)) / (h * h);
        sum += m.v[i] * m.v[i];
    }
    m.speed = sqrt(sum);
    return m;
}

#endif

/* tests/support/motion_uses.h -- how much of each limit the spans use, from their control values:
 * exact, also between samples
 * SPDX-License-Identifier: MIT
 *
 * Per axis, over the time of a span, velocity is a parabola, acceleration is linear, jerk is
 * constant. The square of the speed along the path is a polynomial of degree 4. Its control values
 * bound it, and halving makes the bound as tight as needed.
 */
#ifndef LOFT_TESTS_MOTION_USES_H
#define LOFT_TESTS_MOTION_USES_H

#include "support/motion_spans.h"   /* spans, count, limits */

/* Fractions of the limits; 1 is the whole limit. */
typedef struct {
    double   speed, accel, jerk, along;
    double   jump;                      /* of the acceleration from span to span */
} motion_uses;

/* Spans are exact, but in f32: no part of a limit is left to rounding. */
#define GRAIN_OF(size) BY_NUM(0, ((size) + 1) * 0x1p-23, 0)
/* Their control points are multiples of 2^-16 mm: acceleration jumps by that. */
#define JUMP_GRAINS(g) (12 * 0x1p-16 + 12 * (g))

static inline double grain(void)
{
    double size = 0;
    for (unsigned c = 0; c < curves; c++)
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                size = fmax(size, fabs(arb_value(chain[c].curve.p[k].axis[i])));
    return GRAIN_OF(size);
}

/* The control values of the velocity of axis i, mm/s. */
static inline void span_speeds(const loft_span *s, int i, double v[3])
{
    for (int k = 0; k < 3; k++)
        v[k] = 3 * (arb_value(s->p[k + 1].axis[i]) - arb_value(s->p[k].axis[i])) / duration(s);
}

/* The largest absolute value of a parabola on 0..1. */
static inline double parabola_peak(const double v[3])
{
    const double bend = v[0] - 2 * v[1] + v[2], at = bend != 0 ? (v[0] - v[1]) / bend : -1;
    const double ends = fmax(fabs(v[0]), fabs(v[2]));
    return at > 0 && at < 1 ? fmax(ends, fabs(v[0] + at * (v[1] - v[0]))) : ends;
}

/* The control values of the square of the speed in the part from..to of a span. */
static inline void span_squares(const loft_span *s, double from, double to, double q[5])
{
    for (int k = 0; k < 5; k++)
        q[k] = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        double v[3];
        span_speeds(s, i, v);
        const double a = v[0] + from * (v[1] - v[0]), b = v[1] + from * (v[2] - v[1]);
        const double c = v[0] + to * (v[1] - v[0]), d = v[1] + to * (v[2] - v[1]);
        v[0] = a + from * (b - a);
        v[1] = a + to * (b - a);
        v[2] = c + to * (d - c);
        q[0] += v[0] * v[0];
        q[1] += v[0] * v[1];
        q[2] += (v[0] * v[2] + 2 * v[1] * v[1]) / 3;
        q[3] += v[1] * v[2];
        q[4] += v[2] * v[2];
    }
}

/* de Casteljau at 1/2: both halves of a polynomial of degree 4. */
static inline void halve(const double q[5], double left[5], double right[5])
{
    double row[5];

    for (int k = 0; k < 5; k++)
        row[k] = q[k];
    for (int n = 4; n >= 0; n--) {
        left[4 - n] = row[0];
        right[n]    = row[n];
        for (int k = 0; k < n; k++)
            row[k] = (row[k] + row[k + 1]) / 2;
    }
}

static inline double hull_top(const double q[5])
{
    return fmax(fmax(fmax(q[0], q[1]), fmax(q[2], q[3])), q[4]);
}

/* The largest value of such a polynomial on 0..1, at most a millionth too large: keeps a stack of
 * halves that may contain it. */
static inline double quartic_peak(const double q[5])
{
    double todo[24][5], best = fmax(q[0], q[4]);
    int n = 1;

    for (int k = 0; k < 5; k++)
        todo[0][k] = q[k];
    while (n > 0) {
        double left[5], *right = todo[--n];
        if (hull_top(right) <= best * (1 + 1e-6))
            continue;
        if (n > 21)
            return hull_top(q);
        halve(right, left, right);
        best = fmax(best, left[4]);
        n++;
        for (int k = 0; k < 5; k++)
            todo[n][k] = left[k];
        n++;
    }
    return best * (1 + 1e-6);
}

static inline double use_of(double value, double noise, double limit)
{
    return (fabs(value) - noise) / limit;
}

/* Axis i in span k. */
static inline void axis_uses(unsigned k, int i, double g, motion_uses *u)
{
    const loft_span *s = &spans[k];
    const double h = duration(s);
    double v[3];

    span_speeds(s, i, v);
    const double jerk = 2 * (v[0] - 2 * v[1] + v[2]) / (h * h), first = 2 * (v[1] - v[0]) / h,
                 last = 2 * (v[2] - v[1]) / h;
    u->speed = fmax(u->speed, use_of(parabola_peak(v), 3 * g / h, arb_value(limits.max_speed[i])));
    u->accel = fmax(u->accel, use_of(fmax(fabs(first), fabs(last)), 12 * g / (h * h),
                                     arb_value(limits.max_accel[i])));
    if (limits.max_jerk[i] == 0)
        return;
    u->jerk = fmax(u->jerk, use_of(jerk, 24 * g / (h * h * h), limits.max_jerk[i]));
    if (k + 1 < count) {
        const double next = duration(&spans[k + 1]);
        span_speeds(&spans[k + 1], i, v);
        const double jump = 2 * (v[1] - v[0]) / next - last,
                     noise = JUMP_GRAINS(g) / (h * h) + JUMP_GRAINS(g) / (next * next);
        u->jump = fmax(u->jump, use_of(jump, noise, arb_value(limits.max_accel[i])));
    }
}

/* Fractions of the limits per axis, and of `feed` along the path. */
static inline motion_uses uses_of_spans(double feed)
{
    const double g = grain();
    motion_uses u = { 0, 0, 0, 0, 0 };

    for (unsigned k = 0; k < count; k++) {
        double q[5];
        for (int i = 0; i < LOFT_AXES; i++)
            axis_uses(k, i, g, &u);
        span_squares(&spans[k], 0, 1, q);
        u.along = fmax(u.along, use_of(sqrt(quartic_peak(q)),
                                       sqrt(LOFT_AXES) * 3 * g / duration(&spans[k]), feed));
    }
    return u;
}

#endif

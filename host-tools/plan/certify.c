/* host-tools/plan/certify.c -- judges a plan
 * SPDX-License-Identifier: MIT
 *
 * Limits. With d[k] = p[k + 1] - p[k], integers below 2^31, a span of n ticks has the velocity
 * 3 hz / n times the Bezier polynomial of d[0..2]. It is largest at an end, or where its derivative
 * vanishes, and there it is (d0 d2 - d1^2) / (d0 - 2 d1 + d2), in 64-bit integers. Acceleration is
 * linear: largest at an end. Jerk is constant. What is left of rounding is that of eight operations
 * of double, which the last factor makes good.
 *
 * Distances. A part of a curve between two points a and b is within `bulge` of its chord, at equal
 * parameters: 3/4 of the largest second difference of its control points. Chords of the other path
 * are within `fine` of it. The distance from a segment is convex, so no point of the chord ab is
 * farther from a segment than the farther one of a and b. A part for which this bound is too much
 * is halved, down to parts that are shorter than `fine`.
 *
 * Distances from a chord, and of it, count by its `share`: the tolerance over that of the chord.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plan/certify_chords.h" /* certify_chords */
#include "base/space.h"          /* space_distance, space_eval */
#include "base/tool.h"           /* tool_grow */

#define UP       (1 + 1 / 562949953421312.0)    /* 1 + 2^-49: above eight roundings of 2^-53 */
#define FINE     400        /* parts of the tolerance, and where these do not decide */
#define FINEST   400000     /* ten times as many, up to these */
#define DOUBT    20         /* of these parts: what is beyond the bound by more is so in any case */
#define NEAR     0.25       /* mm along the other path, in which the first search looks */
#define DEPTH    60         /* halvings of a curve */

typedef struct {
    const certify_chords *to;
    double tol, fine;
    double step;                /* by which the worst rises: `fine`, as it counts at corners */
    double share;               /* of what is compared */
    size_t near;                /* the chord that was the nearest */
    double worst, worst_share;
} search;


// Limits
// ------

static void take_worst(certify_worst *w, double value, double seconds)
{
    if (value > w->worst || isnan(value)) {
        w->worst   = value;
        w->seconds = seconds;
    }
}

/* The speed at ends and where it is largest between them; `unit` is its value for 1. */
static void judge_speed(certify_worst *w, const int64_t d[3], double unit, double begin, double h)
{
    const int64_t curl = d[0] - 2 * d[1] + d[2], over = d[0] - d[1];

    take_worst(w, fabs((double)d[0]) * unit * UP, begin);
    take_worst(w, fabs((double)d[2]) * unit * UP, begin + h);
    if ((curl > 0 && over > 0 && over < curl) || (curl < 0 && over < 0 && over > curl))
        take_worst(w, fabs((double)(d[0] * d[2] - d[1] * d[1]) / (double)curl) * unit * UP,
                   begin + h * ((double)over / (double)curl));
}

static void judge_span(certify *c, const certify_plan *plan, const engine_span *s, double begin)
{
    const engine_limits *l = plan->limits;
    const double h = (double)s->ticks / l->tick_hz;

    for (int i = 0; i < ENGINE_AXES; i++) {
        int64_t d[3];
        for (int k = 0; k < 3; k++)
            d[k] = (int64_t)s->p[k + 1][i] - s->p[k][i];
        judge_speed(&c->speed[i], d, 3 * ENGINE_LSB / h / l->max_speed[i], begin, h);
        const double accel = 6 * ENGINE_LSB / (h * h) / l->max_accel[i] * UP;
        take_worst(&c->accel[i], fabs((double)(d[1] - d[0])) * accel, begin);
        take_worst(&c->accel[i], fabs((double)(d[2] - d[1])) * accel, begin + h);
        if (l->max_jerk[i] > 0)
            take_worst(&c->jerk[i],
                       fabs((double)(d[2] - 2 * d[1] + d[0])) * 6 * ENGINE_LSB / (h * h * h) /
                           l->max_jerk[i] * UP,
                       begin);
    }
}

static bool is_connected(const certify_plan *plan, size_t n)
{
    return n == 0 ||
           memcmp(plan->span[n].p[0], plan->span[n - 1].p[3], sizeof plan->span[n].p[0]) == 0;
}


// Distances
// ---------

/* How far the segment from a to b is from chord k at most, as it counts there. */
static double chord_distance(const search *s, size_t k, const double a[ENGINE_AXES],
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
static double least_distance(search *s, const double a[ENGINE_AXES], const double b[ENGINE_AXES],
                             double enough)
{
    const certify_chords *c = s->to;
    const double size = space_distance(a, b), reach = size > s->tol ? size : NEAR;
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

/* Compare a curve. Returns whether some of it is farther by `step` than the worst so far; *t is its
 * parameter. */
static bool compare_curve(search *s, const certify_cubic *c, double *t)
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

/* Compare two points of a curve: if they are far, few parts set a new worst distance afterwards. */
static void compare_points(search *s, const certify_cubic *c)
{
    for (double t = 0.25; t < 1; t += 0.5) {
        double at[ENGINE_AXES];
        certify_eval(c, t, at);
        s->worst = fmax(s->worst, least_distance(s, at, at, s->worst));
    }
}

/* Now all of it is compared. */
static void begin_curves(search *s)
{
    s->worst = fmax(s->worst - 2 * s->step, 0);
    s->near  = 0;
}

/* Chord k of the drawing, which counts as what is left of its curve. */
static void cubic_of_chord(search *s, const certify_chords *c, size_t k, certify_cubic *out)
{
    for (int n = 0; n < 4; n++)
        for (int i = 0; i < ENGINE_AXES; i++)
            out->p[n][i] = n < 3 ? c->end[k][i] + n / 3.0 * (c->end[k + 1][i] - c->end[k][i])
                                 : c->end[k + 1][i];
    s->share = c->share[k];
}

static void take_distance(certify_worst *w, const search *s)
{
    w->tol   = s->tol / s->worst_share;
    w->worst = (s->worst + s->step) / s->worst_share;
}

static void compare_motion(certify *c, const certify_plan *plan, search *off)
{
    certify_cubic curve;
    double t = 0, begin = 0;

    for (size_t n = 0; n < plan->spans; n++) {
        certify_cubic_of_span(plan, n, &curve);
        compare_points(off, &curve);
    }
    begin_curves(off);
    for (size_t n = 0; n < plan->spans; n++) {
        const double h = (double)plan->span[n].ticks / plan->limits->tick_hz;
        certify_cubic_of_span(plan, n, &curve);
        if (compare_curve(off, &curve, &t)) {
            c->off.seconds = begin + t * h;
            certify_eval(&curve, t, c->off.at);
        }
        begin += h;
    }
    take_distance(&c->off, off);
}

static void compare_drawing(certify *c, const certify_chords *drawn, search *missed)
{
    certify_cubic curve;
    double t = 0;

    for (size_t k = 0; k < drawn->chords; k++) {
        cubic_of_chord(missed, drawn, k, &curve);
        compare_points(missed, &curve);
    }
    begin_curves(missed);
    for (size_t k = 0; k < drawn->chords; k++) {
        cubic_of_chord(missed, drawn, k, &curve);
        if (compare_curve(missed, &curve, &t)) {
            c->missed.move = drawn->of[k];
            certify_eval(&curve, t, c->missed.at);
        }
    }
    take_distance(&c->missed, missed);
}

static void compare_paths(certify *c, const certify_plan *plan, double fine)
{
    certify_chords drawn, moved;

    certify_chords_make(&drawn, plan, certify_cubic_of_move, plan->moves, fine / 4);
    certify_chords_make(&moved, plan, certify_cubic_of_span, plan->spans, fine / 2);
    search off = { .to = &drawn, .tol = plan->tol, .fine = fine, .share = 1, .worst_share = 1 };

    off.step = fine;
    if (plan->corner > plan->tol) {
        certify_mark_corners(&drawn, plan);
        off.step *= plan->tol / plan->corner;
    }
    search missed = off;
    missed.to = &moved;
    compare_motion(c, plan, &off);
    compare_drawing(c, &drawn, &missed);
    certify_chords_free(&drawn);
    certify_chords_free(&moved);
}


// All of it
// ---------

/* May it be beyond its bound by the error of these parts alone? */
static bool is_doubtful(const certify_worst *w, double parts)
{
    return w->worst > w->tol && w->worst <= w->tol * (1 + DOUBT / parts);
}

void certify_make(certify *c, const certify_plan *plan)
{
    uint64_t ticks = 0;

    *c = (certify){ .connected = plan->spans > 0 && plan->moves > 0 };
    for (size_t n = 0; n < plan->spans; n++) {
        judge_span(c, plan, &plan->span[n], (double)ticks / plan->limits->tick_hz);
        c->connected = c->connected && is_connected(plan, n);
        ticks += plan->span[n].ticks;
    }
    for (double parts = FINE; c->connected && parts <= FINEST; parts *= 10) {
        compare_paths(c, plan, plan->tol / parts);
        if (!is_doubtful(&c->off, parts) && !is_doubtful(&c->missed, parts))
            break;
    }
}

bool certify_holds(const certify *c)
{
    bool good = c->connected && c->off.worst <= c->off.tol && c->missed.worst <= c->missed.tol;

    for (int i = 0; i < ENGINE_AXES; i++)
        good = good && c->speed[i].worst <= CERTIFY_SPEED && c->accel[i].worst <= CERTIFY_ACCEL &&
               c->jerk[i].worst <= CERTIFY_JERK;
    return good;
}

static void print_limit(char axis, const char *what, const char *unit, const certify_worst *w,
                        double limit, double bound)
{
    if (limit > 0)
        printf("%c %-20s %10.6f of %-9.9g %-8s %10.3f s  %8.6g  %s\n", axis, what, w->worst, limit,
               unit, w->seconds, bound, w->worst <= bound ? "ok" : "MISSED");
}

static void print_distance(const char *what, const certify_worst *w, const char *where)
{
    printf("%-22s %10.6f mm %22s at %.3f,%.3f,%.3f  %g  %s\n", what, w->worst, where, w->at[0],
           w->at[1], w->at[2], w->tol, w->worst <= w->tol ? "ok" : "MISSED");
}

bool certify_print(const certify *c, const certify_plan *plan, const char *axes)
{
    const engine_limits *l = plan->limits;
    char when[32];

    printf("%-22s %10s %-21s %12s  %8s\n", "limit", "worst", "", "at", "at most");
    for (int i = 0; i < ENGINE_AXES; i++) {
        print_limit(axes[i], "speed", "mm/s", &c->speed[i], l->max_speed[i], CERTIFY_SPEED);
        print_limit(axes[i], "acceleration", "mm/s^2", &c->accel[i], l->max_accel[i],
                    CERTIFY_ACCEL);
        print_limit(axes[i], "jerk", "mm/s^3", &c->jerk[i], l->max_jerk[i], CERTIFY_JERK);
    }
    if (!c->connected)
        printf("%-22s MISSED\n", "spans without a gap");
    else {
        snprintf(when, sizeof when, "%.3f s", c->off.seconds);
        print_distance("motion from drawing", &c->off, when);
        snprintf(when, sizeof when, "move %zu", c->missed.move + 1);
        print_distance("drawing from motion", &c->missed, when);
    }
    return certify_holds(c);
}

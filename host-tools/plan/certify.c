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
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plan/certify.h"
#include "base/space.h"          /* space_distance, space_eval */
#include "base/tool.h"           /* tool_grow */

#define LSB      (1 / 65536.0)
#define UP       (1 + 1 / 562949953421312.0)    /* 1 + 2^-49: above eight roundings of 2^-53 */
#define FINE     400        /* parts of the tolerance */
#define NEAR     0.25       /* mm along the other path, in which the first search looks */
#define DEPTH    60         /* halvings of a curve */

typedef struct {
    double p[4][ENGINE_AXES];
} cubic;

/* A path as short chords; chord k leads from end[k] to end[k + 1]. */
typedef struct {
    double (*end)[ENGINE_AXES];
    double *s;                  /* length up to each end */
    size_t chords, room;
} chords;

typedef struct {
    const chords *to;
    double tol, fine;
    size_t near;                /* the chord that was the nearest */
    double worst;
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
    const int64_t bend = d[0] - 2 * d[1] + d[2], over = d[0] - d[1];

    take_worst(w, fabs((double)d[0]) * unit * UP, begin);
    take_worst(w, fabs((double)d[2]) * unit * UP, begin + h);
    if ((bend > 0 && over > 0 && over < bend) || (bend < 0 && over < 0 && over > bend))
        take_worst(w, fabs((double)(d[0] * d[2] - d[1] * d[1]) / (double)bend) * unit * UP,
                   begin + h * ((double)over / (double)bend));
}

static void judge_span(certify *c, const certify_plan *plan, const engine_span *s, double begin)
{
    const engine_limits *l = plan->limits;
    const double h = (double)s->ticks / l->tick_hz;

    for (int i = 0; i < ENGINE_AXES; i++) {
        int64_t d[3];
        for (int k = 0; k < 3; k++)
            d[k] = (int64_t)s->p[k + 1][i] - s->p[k][i];
        judge_speed(&c->speed[i], d, 3 * LSB / h / l->max_speed[i], begin, h);
        const double accel = 6 * LSB / (h * h) / l->max_accel[i] * UP;
        take_worst(&c->accel[i], fabs((double)(d[1] - d[0])) * accel, begin);
        take_worst(&c->accel[i], fabs((double)(d[2] - d[1])) * accel, begin + h);
        if (l->max_jerk[i] > 0)
            take_worst(&c->jerk[i],
                       fabs((double)(d[2] - 2 * d[1] + d[0])) * 6 * LSB / (h * h * h) /
                           l->max_jerk[i] * UP,
                       begin);
    }
}

static bool is_connected(const certify_plan *plan, size_t n)
{
    return n == 0 ||
           memcmp(plan->span[n].p[0], plan->span[n - 1].p[3], sizeof plan->span[n].p[0]) == 0;
}


// Paths
// -----

static void cubic_of_span(const certify_plan *plan, size_t n, cubic *out)
{
    for (int k = 0; k < 4; k++) {
        double motors[ENGINE_AXES];
        for (int i = 0; i < ENGINE_AXES; i++)
            motors[i] = plan->span[n].p[k][i] * LSB;
        if (!kinematics_tool(plan->k, motors, out->p[k]))
            memcpy(out->p[k], motors, sizeof motors);
    }
}

static void cubic_of_move(const certify_plan *plan, size_t n, cubic *out)
{
    memcpy(out->p, plan->move[n].p, sizeof out->p);
}

typedef void cubic_source(const certify_plan *plan, size_t n, cubic *out);

static void eval(const cubic *c, double t, double out[ENGINE_AXES]) { space_eval(c->p, t, out); }

/* How far the curve may be from its chord; of a part of it: times the square of its length. */
static double bulge_of(const cubic *c)
{
    double most = 0;

    for (int k = 0; k < 2; k++) {
        double sum = 0;
        for (int i = 0; i < ENGINE_AXES; i++) {
            const double d = c->p[k][i] - 2 * c->p[k + 1][i] + c->p[k + 2][i];
            sum += d * d;
        }
        most = fmax(most, sum);
    }
    return 0.75 * sqrt(most);
}

static void add_end(chords *c, const double at[ENGINE_AXES])
{
    const size_t n = c->s == NULL ? 0 : c->chords + 1;

    if (n >= c->room) {
        c->room = c->room ? 2 * c->room : 1024;
        c->end  = tool_grow(c->end, c->room * sizeof *c->end);
        c->s    = tool_grow(c->s, c->room * sizeof *c->s);
    }
    memcpy(c->end[n], at, sizeof c->end[n]);
    c->s[n]   = n > 0 ? c->s[n - 1] + space_distance(at, c->end[n - 1]) : 0;
    c->chords = n;
}

static void make_chords(chords *out, const certify_plan *plan, cubic_source *source, size_t count,
                        double fine)
{
    *out = (chords){ .chords = 0 };
    for (size_t n = 0; n < count; n++) {
        cubic c;
        source(plan, n, &c);
        const double parts = fmax(ceil(sqrt(bulge_of(&c) / fine)), 1);
        if (n == 0)
            add_end(out, c.p[0]);
        for (double k = 1; k <= parts; k++) {
            double at[ENGINE_AXES];
            eval(&c, k / parts, at);
            add_end(out, k < parts ? at : c.p[3]);
        }
    }
}

static void free_chords(chords *c)
{
    free(c->end);
    free(c->s);
}


// Distances
// ---------

static double segment_distance(const double p[ENGINE_AXES], const double a[ENGINE_AXES],
                               const double b[ENGINE_AXES])
{
    double along = 0, square = 0, at[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++) {
        along  += (p[i] - a[i]) * (b[i] - a[i]);
        square += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double z = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    for (int i = 0; i < ENGINE_AXES; i++)
        at[i] = a[i] + z * (b[i] - a[i]);
    return space_distance(p, at);
}

/* How far the segment from a to b is from chord k at most. */
static double chord_distance(const chords *c, size_t k, const double a[ENGINE_AXES],
                             const double b[ENGINE_AXES])
{
    return fmax(segment_distance(a, c->end[k], c->end[k + 1]),
                segment_distance(b, c->end[k], c->end[k + 1]));
}

/* The least of these for chords near the last one, or the first that is at most `enough`. The
 * search spreads both ways from the nearest chord so far. What is longer than the tolerance is
 * halved anyway where no chord is beside all of it, so the search ends soon. Otherwise it goes on
 * until something is within the tolerance, or to both ends of the path. */
static double least_distance(search *s, const double a[ENGINE_AXES], const double b[ENGINE_AXES],
                             double enough)
{
    const chords *c = s->to;
    const double size = space_distance(a, b), reach = size > s->tol ? size : NEAR;
    size_t low = s->near, high = low + 1;
    double least = chord_distance(c, s->near, a, b);

    while (least > enough && (low > 0 || high < c->chords)) {
        const double below = low > 0 ? c->s[s->near] - c->s[low] : HUGE_VAL,
                     above = high < c->chords ? c->s[high] - c->s[s->near + 1] : HUGE_VAL;
        if (fmin(below, above) > reach && (least <= s->tol || size > s->tol))
            break;
        const size_t k = above <= below ? high++ : --low;
        const double d = chord_distance(c, k, a, b);
        if (d < least) {
            least   = d;
            s->near = k;
        }
    }
    return least;
}

/* Compare a curve. Returns whether some of it is farther by `fine` than the worst so far; *t is its
 * parameter. */
static bool compare_curve(search *s, const cubic *c, double *t)
{
    struct {
        double from, to;
    } part[DEPTH + 2] = { { 0, 1 } };
    const double bulge = bulge_of(c);
    bool worse = false;

    for (int parts = 1; parts > 0; parts--) {
        const double from = part[parts - 1].from, to = part[parts - 1].to, middle = (from + to) / 2;
        double a[ENGINE_AXES], b[ENGINE_AXES];
        eval(c, from, a);
        eval(c, to, b);
        const double more = bulge * (to - from) * (to - from) + s->fine, most = s->worst + s->fine,
                     off  = least_distance(s, a, b, most - more) + more;
        if (off <= most)
            continue;
        if ((space_distance(a, b) <= s->fine && more <= 2 * s->fine) || parts > DEPTH) {
            s->worst = off;
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

/* Compare two points of each curve, so that few parts set a new worst distance afterwards. */
static void compare_points(search *s, const certify_plan *plan, cubic_source *source, size_t count)
{
    for (size_t n = 0; n < count; n++)
        for (double t = 0.25; t < 1; t += 0.5) {
            cubic c;
            double at[ENGINE_AXES];
            source(plan, n, &c);
            eval(&c, t, at);
            s->worst = fmax(s->worst, least_distance(s, at, at, s->worst));
        }
    s->worst = fmax(s->worst - 2 * s->fine, 0);
    s->near  = 0;
}

static void compare_paths(certify *c, const certify_plan *plan)
{
    const double fine = plan->tol / FINE;
    chords drawn, moved;
    cubic curve;
    double t = 0, begin = 0;

    make_chords(&drawn, plan, cubic_of_move, plan->moves, fine);
    make_chords(&moved, plan, cubic_of_span, plan->spans, fine);
    search off = { .to = &drawn, .tol = plan->tol, .fine = fine },
           missed = { .to = &moved, .tol = plan->tol, .fine = fine };
    compare_points(&off, plan, cubic_of_span, plan->spans);
    compare_points(&missed, plan, cubic_of_move, plan->moves);
    for (size_t n = 0; n < plan->spans; n++) {
        const double h = (double)plan->span[n].ticks / plan->limits->tick_hz;
        cubic_of_span(plan, n, &curve);
        if (compare_curve(&off, &curve, &t)) {
            c->off.seconds = begin + t * h;
            eval(&curve, t, c->off.at);
        }
        begin += h;
    }
    for (size_t n = 0; n < plan->moves; n++) {
        cubic_of_move(plan, n, &curve);
        if (compare_curve(&missed, &curve, &t)) {
            c->missed.move = n;
            eval(&curve, t, c->missed.at);
        }
    }
    c->off.worst    = off.worst + fine;
    c->missed.worst = missed.worst + fine;
    free_chords(&drawn);
    free_chords(&moved);
}


// All of it
// ---------

void certify_make(certify *c, const certify_plan *plan)
{
    uint64_t ticks = 0;

    *c = (certify){ .connected = plan->spans > 0 && plan->moves > 0 };
    for (size_t n = 0; n < plan->spans; n++) {
        judge_span(c, plan, &plan->span[n], (double)ticks / plan->limits->tick_hz);
        c->connected = c->connected && is_connected(plan, n);
        ticks += plan->span[n].ticks;
    }
    if (c->connected)
        compare_paths(c, plan);
}

bool certify_holds(const certify *c, double tol)
{
    bool good = c->connected && c->off.worst <= tol && c->missed.worst <= tol;

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

static void print_distance(const char *what, const certify_worst *w, const char *where, double tol)
{
    printf("%-22s %10.6f mm %22s at %.3f,%.3f,%.3f  %g  %s\n", what, w->worst, where, w->at[0],
           w->at[1], w->at[2], tol, w->worst <= tol ? "ok" : "MISSED");
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
        print_distance("motion from drawing", &c->off, when, plan->tol);
        snprintf(when, sizeof when, "move %zu", c->missed.move + 1);
        print_distance("drawing from motion", &c->missed, when, plan->tol);
    }
    return certify_holds(c, plan->tol);
}

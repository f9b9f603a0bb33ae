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
 * Where corners have a larger tolerance, chords of the drawing end where that begins and ends.
 * Distances from each chord, and of it, count by its `share`: the tolerance over that of the chord.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plan/certify.h"
#include "plan/bends.h"          /* bends_find */
#include "base/space.h"          /* space_distance, space_eval */
#include "base/tool.h"           /* tool_grow */

#define LSB      (1 / 65536.0)
#define UP       (1 + 1 / 562949953421312.0)    /* 1 + 2^-49: above eight roundings of 2^-53 */
#define FINE     400        /* parts of the tolerance, and where these do not decide */
#define FINEST   400000     /* ten times as many, up to these */
#define DOUBT    20         /* of these parts: what is beyond the bound by more is so in any case */
#define NEAR     0.25       /* mm along the other path, in which the first search looks */
#define DEPTH    60         /* halvings of a curve */

typedef struct {
    double p[4][ENGINE_AXES];
} cubic;

/* A path as short chords; chord k leads from end[k] to end[k + 1]. */
typedef struct {
    double (*end)[ENGINE_AXES];
    double *s;                  /* length up to each end */
    double *share;              /* of the tolerance, of each chord */
    size_t *of;                 /* the curve that each chord belongs to */
    size_t chords, room;
} chords;

typedef struct {
    const chords *to;
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

static void add_end(chords *c, size_t of, const double at[ENGINE_AXES])
{
    const size_t n = c->s == NULL ? 0 : c->chords + 1;

    if (n >= c->room) {
        c->room = c->room ? 2 * c->room : 1024;
        c->end  = tool_grow(c->end, c->room * sizeof *c->end);
        c->s    = tool_grow(c->s, c->room * sizeof *c->s);
        c->share = tool_grow(c->share, c->room * sizeof *c->share);
        c->of   = tool_grow(c->of, c->room * sizeof *c->of);
    }
    c->share[n] = 1;
    c->of[n > 0 ? n - 1 : 0] = of;
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
            add_end(out, 0, c.p[0]);
        for (double k = 1; k <= parts; k++) {
            double at[ENGINE_AXES];
            eval(&c, k / parts, at);
            add_end(out, n, k < parts ? at : c.p[3]);
        }
    }
}

static void free_chords(chords *c)
{
    free(c->end);
    free(c->s);
    free(c->share);
    free(c->of);
}


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


// Corners
// -------

/* Where along the drawing the corner at `at` is: it is about `expected`. */
static double corner_at(const chords *c, const double at[ENGINE_AXES], double expected,
                        double within)
{
    double least = HUGE_VAL, s = expected;

    for (size_t k = 0; k < c->chords; k++) {
        if (c->s[k + 1] < expected - within || c->s[k] > expected + within)
            continue;
        const double d = segment_distance(at, c->end[k], c->end[k + 1]);
        if (d < least) {
            least = d;
            s = c->s[k] + fmin(space_distance(at, c->end[k]), c->s[k + 1] - c->s[k]);
        }
    }
    return s;
}

/* The length of the path that is planned up to a bend; chord *k is not behind it. */
static double way_to(const chords *c, const bend *b, size_t *k)
{
    while (*k < c->chords && c->of[*k] < b->move)
        ++*k;
    size_t end = *k;
    while (end < c->chords && c->of[end] == b->move)
        end++;
    return b->t > 0 ? corner_at(c, b->at, (c->s[*k] + c->s[end]) / 2, (c->s[end] - c->s[*k]) / 2)
                    : c->s[*k];
}

/* Chords again, with ends at s. */
static void cut_at(chords *c, const double s[], size_t count)
{
    chords out = { .chords = 0 };
    size_t n = 0;

    add_end(&out, 0, c->end[0]);
    for (size_t k = 0; k < c->chords; k++) {
        for (; n < count && s[n] < c->s[k + 1]; n++)
            if (s[n] > c->s[k]) {
                const double z = (s[n] - c->s[k]) / (c->s[k + 1] - c->s[k]);
                double at[ENGINE_AXES];
                for (int i = 0; i < ENGINE_AXES; i++)
                    at[i] = c->end[k][i] + z * (c->end[k + 1][i] - c->end[k][i]);
                add_end(&out, c->of[k], at);
            }
        add_end(&out, c->of[k], c->end[k + 1]);
    }
    free_chords(c);
    *c = out;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where the corners of the path that is planned are along the drawing; tool_grow has made it. */
static double *corners_of(const chords *drawn, const certify_plan *plan, size_t *count)
{
    const certify_plan planned = { .move = plan->planned ? plan->planned : plan->move,
                                   .moves = plan->planned ? plan->planned_moves : plan->moves };
    bends b;
    chords path;
    size_t k = 0;
    double at = 0, before = 0;

    bends_find(&b, planned.move, planned.moves);
    make_chords(&path, &planned, cubic_of_move, planned.moves, plan->tol);
    double *s = tool_grow(NULL, (b.count + 1) * sizeof *s);
    for (size_t n = 0; n < b.count; n++) {
        const double now = way_to(&path, &b.bend[n], &k), way = now - before;
        at = corner_at(drawn, b.bend[n].at, at + way, plan->tol + 0.02 * way);
        before = now;
        s[n] = at;
    }
    *count = b.count;
    free_chords(&path);
    bends_free(&b);
    return s;
}

/* Give each chord of the drawing its share. */
static void mark_corners(chords *drawn, const certify_plan *plan)
{
    const double reach = CERTIFY_NEAR * plan->corner;
    size_t count, n = 0;
    double *corner = corners_of(drawn, plan, &count),
           *cut = tool_grow(NULL, (2 * count + 1) * sizeof *cut);

    for (size_t i = 0; i < count; i++) {
        cut[2 * i]     = corner[i] - reach;
        cut[2 * i + 1] = corner[i] + reach;
    }
    qsort(cut, 2 * count, sizeof *cut, by_size);
    cut_at(drawn, cut, 2 * count);
    for (size_t k = 0; k < drawn->chords; k++) {
        const double middle = (drawn->s[k] + drawn->s[k + 1]) / 2;
        while (n < count && corner[n] + reach < middle)
            n++;
        drawn->share[k] = n < count && corner[n] - reach <= middle ? plan->tol / plan->corner : 1;
    }
    free(cut);
    free(corner);
}


// Distances
// ---------

/* How far the segment from a to b is from chord k at most, as it counts there. */
static double chord_distance(const search *s, size_t k, const double a[ENGINE_AXES],
                             const double b[ENGINE_AXES])
{
    const chords *c = s->to;
    return s->share * c->share[k] *
           fmax(segment_distance(a, c->end[k], c->end[k + 1]),
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
static void compare_points(search *s, const cubic *c)
{
    for (double t = 0.25; t < 1; t += 0.5) {
        double at[ENGINE_AXES];
        eval(c, t, at);
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
static void cubic_of_chord(search *s, const chords *c, size_t k, cubic *out)
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
    cubic curve;
    double t = 0, begin = 0;

    for (size_t n = 0; n < plan->spans; n++) {
        cubic_of_span(plan, n, &curve);
        compare_points(off, &curve);
    }
    begin_curves(off);
    for (size_t n = 0; n < plan->spans; n++) {
        const double h = (double)plan->span[n].ticks / plan->limits->tick_hz;
        cubic_of_span(plan, n, &curve);
        if (compare_curve(off, &curve, &t)) {
            c->off.seconds = begin + t * h;
            eval(&curve, t, c->off.at);
        }
        begin += h;
    }
    take_distance(&c->off, off);
}

static void compare_drawing(certify *c, const chords *drawn, search *missed)
{
    cubic curve;
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
            eval(&curve, t, c->missed.at);
        }
    }
    take_distance(&c->missed, missed);
}

static void compare_paths(certify *c, const certify_plan *plan, double fine)
{
    chords drawn, moved;

    make_chords(&drawn, plan, cubic_of_move, plan->moves, fine / 4);
    make_chords(&moved, plan, cubic_of_span, plan->spans, fine / 2);
    search off = { .to = &drawn, .tol = plan->tol, .fine = fine, .share = 1, .worst_share = 1 };

    off.step = fine;
    if (plan->corner > plan->tol) {
        mark_corners(&drawn, plan);
        off.step *= plan->tol / plan->corner;
    }
    search missed = off;
    missed.to = &moved;
    compare_motion(c, plan, &off);
    compare_drawing(c, &drawn, &missed);
    free_chords(&drawn);
    free_chords(&moved);
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

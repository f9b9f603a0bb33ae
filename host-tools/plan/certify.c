/* host-tools/plan/certify.c -- judges a plan
 * SPDX-License-Identifier: MIT
 *
 * Limits. With d[k] = p[k + 1] - p[k], integers below 2^31, a span of n ticks has the velocity
 * 3 hz / n times the Bezier polynomial of d[0..2]. It is largest at an end, or where its derivative
 * vanishes, and there it is (d0 d2 - d1^2) / (d0 - 2 d1 + d2), in 64-bit integers. Acceleration is
 * linear: largest at an end. Jerk is constant. What is left of rounding is that of eight operations
 * of double, which the last factor makes good.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan/certify.h"
#include "plan/certify_compare.h" /* certify_search */

#define UP       (1 + 1 / 562949953421312.0)    /* 1 + 2^-49: above eight roundings of 2^-53 */
#define FINE     400        /* parts of the tolerance, and where these do not decide */
#define FINEST   400000     /* ten times as many, up to these */
#define NEAR     0.25       /* mm along the other path, in which the first search looks */
#define DOUBT    20         /* of these parts: what is beyond the bound by more is so in any case */


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

void certify_span(certify *c, const engine_limits *l, const engine_span *s, double begin)
{
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

static void compare_motion(certify *c, const certify_plan *plan, certify_search *off)
{
    certify_cubic curve;
    double t = 0, begin = 0;

    for (size_t n = 0; n < plan->spans; n++) {
        certify_cubic_of_span(plan, n, &curve);
        certify_points(off, &curve);
    }
    certify_again(off);
    for (size_t n = 0; n < plan->spans; n++) {
        const double h = (double)plan->span[n].ticks / plan->limits->tick_hz;
        certify_cubic_of_span(plan, n, &curve);
        if (certify_compare(off, &curve, &t)) {
            c->off.seconds = begin + t * h;
            certify_eval(&curve, t, c->off.at);
        }
        begin += h;
    }
    certify_take(&c->off, off);
}

static void compare_drawing(certify *c, const certify_chords *drawn, certify_search *missed)
{
    certify_cubic curve;
    double t = 0;

    for (size_t k = 0; k < drawn->chords; k++) {
        certify_cubic_of_chord(missed, drawn, k, &curve);
        certify_points(missed, &curve);
    }
    certify_again(missed);
    for (size_t k = 0; k < drawn->chords; k++) {
        certify_cubic_of_chord(missed, drawn, k, &curve);
        if (certify_compare(missed, &curve, &t)) {
            c->missed.move = drawn->of[k];
            certify_eval(&curve, t, c->missed.at);
        }
    }
    certify_take(&c->missed, missed);
}

static void compare_paths(certify *c, const certify_plan *plan, double fine)
{
    certify_chords drawn, moved;

    certify_chords_make(&drawn, plan, certify_cubic_of_move, plan->moves, fine / 4);
    certify_chords_make(&moved, plan, certify_cubic_of_span, plan->spans, fine / 2);
    certify_search off = {
        .to = &drawn, .tol = plan->tol, .fine = fine, .reach = NEAR, .share = 1, .worst_share = 1
    };

    off.step = fine;
    if (plan->corner > plan->tol) {
        certify_mark_corners(&drawn, plan);
        off.step *= plan->tol / plan->corner;
    }
    certify_search missed = off;
    missed.to = &moved;
    compare_motion(c, plan, &off);
    compare_drawing(c, &drawn, &missed);
    certify_chords_free(&drawn);
    certify_chords_free(&moved);
}


// All of it
// ---------

/* True if the error of these parts alone may take it beyond its bound. */
static bool is_doubtful(const certify_worst *w, double parts)
{
    return w->worst > w->tol && w->worst <= w->tol * (1 + DOUBT / parts);
}

void certify_make(certify *c, const certify_plan *plan)
{
    uint64_t ticks = 0;

    *c = (certify){ .connected = plan->spans > 0 && plan->moves > 0 };
    for (size_t n = 0; n < plan->spans; n++) {
        certify_span(c, plan->limits, &plan->span[n], (double)ticks / plan->limits->tick_hz);
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

static void fold_worst(certify_worst *sum, const certify_worst *part)
{
    const double is = part->worst * (sum->tol > 0 ? sum->tol : 1),
                 was = sum->worst * (part->tol > 0 ? part->tol : 1);

    if (is > was || isnan(is))
        *sum = *part;
}

void certify_fold(certify *sum, const certify *part)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        fold_worst(&sum->speed[i], &part->speed[i]);
        fold_worst(&sum->accel[i], &part->accel[i]);
        fold_worst(&sum->jerk[i], &part->jerk[i]);
    }
    fold_worst(&sum->off, &part->off);
    fold_worst(&sum->missed, &part->missed);
    sum->connected = sum->connected && part->connected;
}

static void print_limit(FILE *out, char axis, const char *what, const char *unit,
                        const certify_worst *w, double limit, double bound)
{
    if (limit > 0)
        fprintf(out, "%c %-20s %10.6f of %-9.9g %-8s %10.3f s  %8.6g  %s\n", axis, what, w->worst,
                limit, unit, w->seconds, bound, w->worst <= bound ? "ok" : "MISSED");
}

static void print_distance(FILE *out, const char *what, const certify_worst *w, const char *where)
{
    fprintf(out, "%-22s %10.6f mm %22s at %.3f,%.3f,%.3f  %g  %s\n", what, w->worst, where,
            w->at[0], w->at[1], w->at[2], w->tol, w->worst <= w->tol ? "ok" : "MISSED");
}

bool certify_print(FILE *out, const certify *c, const certify_plan *plan, const char *axes)
{
    const engine_limits *l = plan->limits;
    char when[32];

    fprintf(out, "%-22s %10s %-21s %12s  %8s\n", "limit", "worst", "", "at", "at most");
    for (int i = 0; i < ENGINE_AXES; i++) {
        print_limit(out, axes[i], "speed", "mm/s", &c->speed[i], l->max_speed[i], CERTIFY_SPEED);
        print_limit(out, axes[i], "acceleration", "mm/s^2", &c->accel[i], l->max_accel[i],
                    CERTIFY_ACCEL);
        print_limit(out, axes[i], "jerk", "mm/s^3", &c->jerk[i], l->max_jerk[i], CERTIFY_JERK);
    }
    if (!c->connected)
        fprintf(out, "%-22s MISSED\n", "spans without a gap");
    else {
        snprintf(when, sizeof when, "%.3f s", c->off.seconds);
        print_distance(out, "motion from drawing", &c->off, when);
        snprintf(when, sizeof when, "move %zu", c->missed.move + 1);
        print_distance(out, "drawing from motion", &c->missed, when);
    }
    return certify_holds(c);
}

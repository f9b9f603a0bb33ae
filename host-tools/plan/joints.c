/* host-tools/plan/joints.c -- a toolpath as a path of the motors
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plan/joints.h"
#include "base/source.h"         /* source_name */
#include "base/space.h"          /* space_distance, space_eval */
#include "base/spool.h"          /* spool_grow */
#include "base/host.h"

#define LOOKS     8         /* places in a piece where it is compared with the path */
#define EVEN      1.02      /* largest change of the motors' feed within a piece */
#define SHORT     0.02      /* mm: shorter pieces may change it more */
#define CUTS      20        /* halvings of a move, then following it fails */
#define POLE      1e-6      /* mm: closer than this is the pole */
#define SPEED_MAX 16383.0   /* of a plan, lib/path/limits.h                       */
#define ACCEL_MAX 16383.0
#define JERK_MAX  1e7
#define TOL_MIN   (1 / 1024.0)
#define TOL_MAX   1.0
#define UPRIGHT   (1u << 2) /* the motor that lifts the pen */

typedef struct {
    host *host;
    joints *j;
    const toolpath *path;
    const joints_options *o;
    double at[ENGINE_AXES];         /* the motors */
    size_t number;                  /* of the tool's move */
} mapping;

/* A piece under examination. */
typedef struct {
    engine_move move;
    double least, most;             /* planned length of the motors over the length of the tool */
    double off, length;             /* of the tool, mm                                    */
} piece;


// Cubics
// ------

static double size_of(const double v[ENGINE_AXES])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void eval_move(const engine_move *m, double t, double out[ENGINE_AXES])
{
    space_eval(m->p, t, out);
}

static void deriv_move(const engine_move *m, double t, double out[ENGINE_AXES])
{
    const double s = 1 - t;

    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = 3 * (s * s * (m->p[1][i] - m->p[0][i]) + 2 * s * t * (m->p[2][i] - m->p[1][i]) +
                      t * t * (m->p[3][i] - m->p[2][i]));
}

static double pole_distance(const kinematics *k, const double tool[ENGINE_AXES])
{
    return hypot(tool[0] - k->center[0], tool[1] - k->center[1]);
}


// Past a pole
// -----------

/* The smallest distance of the line from a to b from the pole. */
static double line_pole_distance(const kinematics *k, const double a[ENGINE_AXES],
                                 const double b[ENGINE_AXES])
{
    const double bx = b[0] - a[0], by = b[1] - a[1], cx = k->center[0] - a[0],
                 cy = k->center[1] - a[1], square = bx * bx + by * by;
    const double z = square > 0 ? fmin(fmax((bx * cx + by * cy) / square, 0), 1) : 0;

    return hypot(cx - z * bx, cy - z * by);
}

static void make_line(engine_move *m, const double from[ENGINE_AXES], const double to[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        m->p[0][i] = from[i];
        m->p[1][i] = from[i] + (to[i] - from[i]) / 3;
        m->p[2][i] = to[i] - (to[i] - from[i]) / 3;
        m->p[3][i] = to[i];
    }
}

static bool is_upright(const engine_move *m)
{
    return hypot(m->p[0][0] - m->p[3][0], m->p[0][1] - m->p[3][1]) < POLE;
}

/* A travel that comes too close to the pole goes to it and continues from there: at the pole the
 * angle may turn without the tool. */
static void lead_travels_through_pole(toolpath *t, const kinematics *k)
{
    for (size_t n = 0; n < t->count; spool_passed(n++)) {
        engine_move *m = &t->move[n];
        if (t->curve[n] != TOOLPATH_TRAVEL || is_upright(m) || pole_distance(k, m->p[0]) < POLE ||
            pole_distance(k, m->p[3]) < POLE ||
            line_pole_distance(k, m->p[0], m->p[3]) >= k->inside)
            continue;
        t->move  = spool_grow(t->move, (t->count + 1) * sizeof *t->move);
        t->curve = spool_grow(t->curve, (t->count + 1) * sizeof *t->curve);
        m        = &t->move[n];
        memmove(m + 1, m, (t->count - n) * sizeof *m);
        memmove(&t->curve[n + 1], &t->curve[n], (t->count - n) * sizeof *t->curve);
        const double pole[ENGINE_AXES] = { k->center[0], k->center[1], m->p[0][2] };
        make_line(&m[1], pole, m[1].p[3]);
        make_line(&m[0], m[0].p[0], pole);
        for (size_t i = 0; i < t->events; i++)
            t->event[i].move += t->event[i].move > n;
        t->count++;
        n++;
    }
}


// Pieces
// ------

static void add_move(mapping *m, const engine_move *move)
{
    joints *j = m->j;

    if (j->count == j->room) {
        j->room = j->room ? 2 * j->room : 64;
        j->move = spool_grow(j->move, j->room * sizeof *j->move);
        j->of   = spool_grow(j->of, j->room * sizeof *j->of);
    }
    spool_passed(j->count);
    j->of[j->count]     = m->number;
    j->move[j->count++] = *move;
    memcpy(m->at, move->p[3], sizeof m->at);
}

/* Planned length of a velocity of the motors. */
static double planned_length(const joints *j, const double v[ENGINE_AXES])
{
    const double scaled[ENGINE_AXES] = { v[0] * j->scale[0], v[1] * j->scale[1],
                                         v[2] * j->scale[2] };

    return size_of(scaled);
}

/* Compare the lengths of motors and tool at t. */
static void compare_lengths(const joints *j, engine_move *m, double t, piece *p)
{
    double at[ENGINE_AXES], v[ENGINE_AXES], slope[ENGINE_AXES];

    eval_move(m, t, at);
    deriv_move(m, t, v);
    const double size = size_of(v);
    if (!(size > 1e-9))
        return;
    kinematics_slope(j->k, at, v, slope);
    p->least = fmin(p->least, planned_length(j, slope) / size);
    p->most  = fmax(p->most, planned_length(j, slope) / size);
}

/* The cubic of the motors that has the positions and the directions of the path at t0 and t1. The
 * derivative by t is that of the path, mapped to the motors. */
static void map_piece(const mapping *m, engine_move *move, double t0, double t1, piece *p)
{
    double tool[2][ENGINE_AXES], v[ENGINE_AXES], slope[2][ENGINE_AXES];

    memcpy(p->move.p[0], m->at, sizeof p->move.p[0]);
    for (int k = 0; k < 2; k++) {
        eval_move(move, k ? t1 : t0, tool[k]);
        deriv_move(move, k ? t1 : t0, v);
        kinematics_slope(m->j->k, tool[k], v, slope[k]);
    }
    kinematics_motors(m->j->k, tool[1], m->at, p->move.p[3]);
    for (int i = 0; i < ENGINE_AXES; i++) {
        p->move.p[1][i] = p->move.p[0][i] + slope[0][i] * (t1 - t0) / 3;
        p->move.p[2][i] = p->move.p[3][i] - slope[1][i] * (t1 - t0) / 3;
    }
}

/* Examine the piece along its way: how far the tool is off the path, how lengths compare. */
static void examine_piece(const mapping *m, engine_move *move, double t0, double t1, piece *p)
{
    double before[ENGINE_AXES];

    map_piece(m, move, t0, t1, p);
    p->least = HUGE_VAL;
    p->most = p->off = p->length = 0;
    eval_move(move, t0, before);
    for (int n = 0; n <= LOOKS; n++) {
        const double u = (double)n / LOOKS, t = t0 + u * (t1 - t0);
        double want[ENGINE_AXES], motors[ENGINE_AXES], is[ENGINE_AXES];
        eval_move(move, t, want);
        eval_move(&p->move, u, motors);
        compare_lengths(m->j, move, t, p);
        p->off = kinematics_tool(m->j->k, motors, is) ? fmax(p->off, space_distance(is, want))
                                                      : HUGE_VAL;
        p->length += space_distance(want, before);
        memcpy(before, want, sizeof before);
    }
}

static int refuse_place(const mapping *m, const double at[ENGINE_AXES], const char *why)
{
    const size_t curve     = m->path->curve[m->number];
    const bool travel      = curve == TOOLPATH_TRAVEL;
    const host_place place = { source_name(m->o->file), travel ? 0 : m->o->d->curve[curve].line };

    return host_error(m->host, EX_DATAERR, "plan.place-unreachable", place, NULL,
                      "%s %.6g,%.6g,%.6g mm is beyond a %s machine like this, %s",
                      travel ? "the travel over" : "the place", at[0], at[1], at[2],
                      kinematics_name(m->j->k), why);
}

/* Refuse places out of reach. The sampling is as fine as the cuts of curves, so nothing can be far
 * out of reach unnoticed. */
static int check_reach(const mapping *m, engine_move *move)
{
    const double length = space_distance(move->p[0], move->p[1]) +
                          space_distance(move->p[1], move->p[2]) +
                          space_distance(move->p[2], move->p[3]);
    const int n = (int)fmin(fmax(m->j->k->kind->pole ? 2 * length / m->j->k->inside : length, 8),
                            10000);
    char why[160];

    for (int i = 0; i <= n; i++) {
        double at[ENGINE_AXES];
        eval_move(move, (double)i / n, at);
        if (kinematics_beyond(m->j->k, at, why))
            return refuse_place(m, at, why);
    }
    return 0;
}

static int check_piece_reach(const mapping *m, const engine_move *move,
                             const double at[ENGINE_AXES])
{
    for (int n = 1; n < 4; n++)
        for (int i = 0; i < ENGINE_AXES; i++)
            if (!(fabs(move->p[n][i]) * m->j->scale[i] <= m->o->reach)) {
                char why[160];
                snprintf(why, sizeof why, "motor %c would be at %.6g, of %.6g that can be planned",
                         kinematics_axes(m->j->k)[i], move->p[n][i], m->o->reach / m->j->scale[i]);
                return refuse_place(m, at, why);
            }
    return 0;
}

static int add_piece(mapping *m, piece *p, double feed, const double tool[ENGINE_AXES])
{
    engine_move move = { .feed = fmin(feed * (p->least < HUGE_VAL ? p->least : 1), SPEED_MAX) };
    char why[160];

    memcpy(move.p, p->move.p, sizeof move.p);
    if (kinematics_beyond(m->j->k, tool, why))
        return refuse_place(m, tool, why);
    const int code = check_piece_reach(m, &move, tool);
    if (code == 0) {
        add_move(m, &move);
        m->j->least = fmin(m->j->least, kinematics_least(m->j->k, tool, m->j->scale));
    }
    return code;
}

/* Greedy: take the longest valid piece, at most twice as long as the last one. */
static int map_curved(mapping *m, engine_move *move)
{
    double t = 0, step = 1;
    int code = check_reach(m, move);

    m->j->least = fmin(m->j->least, kinematics_least(m->j->k, move->p[0], m->j->scale));
    while (code == 0 && t < 1) {
        double tool[ENGINE_AXES];
        piece p;
        step = fmin(2 * step, 1 - t);
        for (int cuts = 0;; cuts++, step /= 2) {
            examine_piece(m, move, t, t + step, &p);
            if (p.off <= m->j->within && (p.most <= EVEN * p.least || p.length <= SHORT))
                break;
            if (cuts == CUTS) {
                eval_move(move, t, tool);
                return refuse_place(m, tool, "and cannot be followed: move the drawing");
            }
        }
        t = t + step > 1 - 1e-9 ? 1 : t + step;
        eval_move(move, t, tool);
        code = add_piece(m, &p, move->feed, tool);
    }
    return code;
}

/* A matrix maps the control points. The feed is scaled by the direction with the smallest
 * length. */
static int map_linear(mapping *m, engine_move *move)
{
    piece p = { .least = HUGE_VAL };

    memcpy(p.move.p[0], m->at, sizeof p.move.p[0]);
    for (int n = 1; n < 4; n++)
        kinematics_motors(m->j->k, move->p[n], m->at, p.move.p[n]);
    for (int n = 0; n <= LOOKS && !m->j->k->kind->direct; n++)
        compare_lengths(m->j, move, (double)n / LOOKS, &p);
    return add_piece(m, &p, move->feed, move->p[3]);
}

/* From or to the pole, or vertical: the angle is that of the other end, and the motor turns to it
 * first. */
static int map_radial(mapping *m, engine_move *move)
{
    const bool out = pole_distance(m->j->k, move->p[0]) < POLE;
    double from[ENGINE_AXES], to[ENGINE_AXES];
    engine_move turn = { .feed = SPEED_MAX },
                go = { .feed = fmin(move->feed * m->j->scale[0], SPEED_MAX) };

    memcpy(from, m->at, sizeof from);
    kinematics_motors(m->j->k, move->p[3], m->at, to);
    if (out)
        from[1] = to[1];
    else
        to[1] = from[1];
    make_line(&turn, m->at, from);
    make_line(&go, from, to);
    int code = check_piece_reach(m, &go, move->p[3]);
    if (code == 0 && fabs(from[1] - m->at[1]) > 0)
        add_move(m, &turn);
    if (code == 0 && space_distance(from, to) > 0)
        add_move(m, &go);
    return code;
}

static int map_move(mapping *m, engine_move *move)
{
    const kinematics *k = m->j->k;
    const bool travels  = m->path->curve[m->number] == TOOLPATH_TRAVEL;

    if (k->kind->linear)
        return map_linear(m, move);
    if (k->kind->pole && travels &&
        (pole_distance(k, move->p[0]) < POLE || pole_distance(k, move->p[3]) < POLE ||
         is_upright(move)))
        return map_radial(m, move);
    return map_curved(m, move);
}


// All of it
// ---------

static double farthest_radius(const toolpath *path, const kinematics *k)
{
    double most = 0;

    for (size_t n = 0; n < path->count; spool_passed(n++))
        for (int i = 0; i < 4; i++)
            most = fmax(most, pole_distance(k, path->move[n].p[i]));
    return most;
}

int joints_make(host *h, joints *out, toolpath *path, const kinematics *k, const joints_options *o)
{
    mapping m = { .host = h, .j = out, .path = path, .o = o };
    int code  = 0;

    *out = (joints){ .k = k, .path = path, .scale = { 1, 1, 1 }, .least = 1 };
    memcpy(m.at, o->start, sizeof m.at);
    if (k->kind->pole)
        lead_travels_through_pole(path, k);
    if (!k->kind->direct) {
        out->within = k->kind->linear ? 0 : o->within;
        if (!o->chip)
            kinematics_scale(k, farthest_radius(path, k), out->scale);
        out->least  = k->kind->pole ? out->scale[0] : HUGE_VAL;
    }
    for (int i = 0; i < ENGINE_AXES; i++)
        out->scaled = out->scaled || out->scale[i] > 1;
    for (m.number = 0; m.number < path->count && code == 0; spool_passed(m.number++))
        code = map_move(&m, &path->move[m.number]);
    return code;
}

void joints_free(joints *j)
{
    spool_free(j->move);
    spool_free(j->of);
    *j = (joints){ .k = NULL };
}

/* The error of converting planned units to those of the wire: half an LSB for each scaled motor,
 * and half an LSB of the plan. */
static double rounding_error(const joints *j)
{
    double sum = 0;

    for (int i = 0; i < ENGINE_AXES; i++)
        sum += j->scale[i] > 1 ? (j->scale[i] + 1) * (j->scale[i] + 1) : 0;
    return sqrt(sum) * ENGINE_LSB / 2;
}

/* The share of the tool's tolerance that is left for the plan. */
static double planned_tol(const joints *j, double tol)
{
    return fmin((tol - j->within) * j->least - rounding_error(j), TOL_MAX);
}

/* Where one motor lifts the pen, the pen goes no deeper than planned. */
engine_limits joints_limits(const joints *j, const engine_limits *motors)
{
    engine_limits l = *motors;

    l.one_sided = j->k->kind->lifts ? UPRIGHT : 0;
    if (j->k->kind->direct)
        return l;
    for (int i = 0; i < ENGINE_AXES; i++) {
        l.max_speed[i] = fmin(l.max_speed[i] * j->scale[i], SPEED_MAX);
        l.max_accel[i] = fmin(l.max_accel[i] * j->scale[i], ACCEL_MAX);
        l.max_jerk[i]  = fmin(l.max_jerk[i] * j->scale[i], JERK_MAX);
    }
    l.corner = fmax(planned_tol(j, l.corner), 0);
    l.tol    = planned_tol(j, l.tol);
    return l;
}

/* A move in planned units. */
static void scaled_move(void *context, size_t n, engine_move *out)
{
    const joints_planning *p = context;
    const joints *j          = p->j;

    spool_passed(n);
    *out = j->move[p->first + n];
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            out->p[k][i] *= j->scale[i];
}

size_t joints_from(const joints *j, size_t move)
{
    size_t low = 0, high = j->count;        /* of[low - 1] < move <= of[high] */

    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (j->of[middle] < move)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

int joints_plan(joints_planning *p, joints *j, size_t first, size_t end, const engine *e,
                const engine_limits *motors)
{
    const engine_limits limits = joints_limits(j, motors);

    *p = (joints_planning){ .j = j, .e = e, .first = first, .count = end - first };
    return e->plan->open(&limits, scaled_move, p, end - first, &p->plan);
}

void joints_certify(joints_planning *p, certify_along *along, const engine_limits *motors)
{
    const engine_limits limits = joints_limits(p->j, motors);

    p->along = along;
    p->holds = true;
    certify_along_begin(along, &limits, scaled_move, p, p->count);
}

int joints_step(joints_planning *p, engine_span *out)
{
    const int step = p->e->plan->step(p->plan, out);

    if (p->along != NULL && step == ENGINE_PLAN_SPAN)
        p->holds = certify_along_span(p->along, out, p->e->plan->passed(p->plan));
    if (p->along != NULL && step == ENGINE_PLAN_DONE)
        p->holds = certify_along_end(p->along);
    for (int n = 0; n < 4 && step == ENGINE_PLAN_SPAN; n++)
        for (int i = 0; i < ENGINE_AXES; i++)
            if (p->j->scale[i] > 1)
                out->p[n][i] = (int32_t)lround(out->p[n][i] / p->j->scale[i]);
    return step;
}

size_t joints_passed(const joints_planning *p) { return p->first + p->e->plan->passed(p->plan); }

void joints_end(joints_planning *p)
{
    if (p->plan != NULL)
        p->e->plan->close(p->plan);
    *p = (joints_planning){ .plan = NULL };
}

/* tests/tools/test_joints.c -- the path of the tool as cubics of the motors: within tolerance,
 * continuous in direction, at the given feed
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>
#include <sysexits.h>

#include "check.h"
#include "base/spool.h"      /* spool_grow */
#include "tools/drawn.h"
#include "engine/engine.h"
#include "plan/joints.h"

#define MOVES  4
#define WITHIN 0.001
#define LOOKS  16
/* how much the feed of the motors may be off in a piece that is not short: */
#define EVEN   1.02
#define SHORT  0.02         /* mm */

static double random_unit(arb *a)      { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }
static double random_signed(arb *a, double size)     { return (2 * random_unit(a) - 1) * size; }

static kinematics kind_of(const kinematics_kind *kind)
{
    kinematics k = kinematics_usual();

    k.kind = kind;
    k.arm_length = 200;
    k.delta_radius = 95;
    if (kind->pole)
        k.center[0] = k.center[1] = -80;
    kinematics_ready(&k);
    return k;
}

static double size_of(const double v[ENGINE_AXES])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void eval_move(double p[4][ENGINE_AXES], double t, double at[ENGINE_AXES],
                      double v[ENGINE_AXES])
{
    const double s = 1 - t;

    for (int i = 0; i < ENGINE_AXES; i++) {
        at[i] = s * s * s * p[0][i] + 3 * s * s * t * p[1][i] + 3 * s * t * t * p[2][i] +
                t * t * t * p[3][i];
        v[i] = 3 * (s * s * (p[1][i] - p[0][i]) + 2 * s * t * (p[2][i] - p[1][i]) +
                    t * t * (p[3][i] - p[2][i]));
    }
}

/* A smooth chain without cusps, within 80 mm of 0,0, drawn at 30 mm/s. */
static void arb_path(arb *a, toolpath *path)
{
    double at[ENGINE_AXES] = { random_signed(a, 20), random_signed(a, 20), 0 },
           way = 7 * random_unit(a);

    *path = (toolpath){ .move = spool_grow(NULL, MOVES * sizeof *path->move),
                        .curve = spool_grow(NULL, MOVES * sizeof *path->curve),
                        .count = MOVES };
    for (int n = 0; n < MOVES; n++) {
        engine_move *m = &path->move[n];
        const double first = 2 + 5 * random_unit(a), last = 2 + 5 * random_unit(a);
        path->curve[n] = 0;
        *m = (engine_move){ .feed = 30 };
        for (int k = 0; k < 4; k++)
            memcpy(m->p[k], at, sizeof at);
        m->p[1][0] += first * cos(way);
        m->p[1][1] += first * sin(way);
        m->p[3][0] += 12 * cos(way) + random_signed(a, 4);
        m->p[3][1] += 12 * sin(way) + random_signed(a, 4);
        way += random_signed(a, 1);
        m->p[2][0] = m->p[3][0] - last * cos(way);
        m->p[2][1] = m->p[3][1] - last * sin(way);
        memcpy(at, m->p[3], sizeof at);
    }
}

static int make_joints(joints *j, toolpath *path, const kinematics *k)
{
    const double none[ENGINE_AXES] = { 0, 0, 0 };
    static drawing_curve twelfth = { .line = 12 };
    static drawing d = { .curve = &twelfth, .count = 1 };
    joints_options o = { .file = "file.csv", .d = &d, .within = WITHIN, .reach = 8191 };

    hear();
    kinematics_motors(k, path->move[0].p[0], none, o.start);
    return joints_make(&heard, j, path, k, &o);
}

/* The distance of a place from a move of the tool: the nearest of many places, then ternary
 * search. */
static double distance_to_move(engine_move *m, const double at[ENGINE_AXES])
{
    double best = 0, least = HUGE_VAL, p[ENGINE_AXES], v[ENGINE_AXES];

    for (int pass = 0; pass < 80; pass++) {
        const int n = pass == 0 ? 100 : 2;
        const double step = pass == 0 ? 0.01 : 0.01 * pow(0.8, pass),
                     from = pass == 0 ? 0 : best - step;
        for (int k = 0; k <= n; k++) {
            const double t = fmin(fmax(from + k * step, 0), 1);
            eval_move(m->p, t, p, v);
            const double by[ENGINE_AXES] = { p[0] - at[0], p[1] - at[1], p[2] - at[2] };
            if (size_of(by) < least) {
                least = size_of(by);
                best  = t;
            }
        }
    }
    return least;
}

static void the_tool_stays_within(arb *a)
{
    const kinematics k = kind_of(arb_below(a, 2) ? &kinematics_delta_f64 : &kinematics_polar_f64);
    double at[ENGINE_AXES], v[ENGINE_AXES], tool[ENGINE_AXES];
    toolpath path;
    joints j;

    arb_path(a, &path);
    CHECK(make_joints(&j, &path, &k) == 0 && j.count > MOVES && j.count < MOVES * 200);
    for (size_t n = 0; n < j.count; n++)
        for (int i = 0; i <= 21; i++) {
            eval_move(j.move[n].p, i / 21.0, at, v);
            CHECK(kinematics_tool(&k, at, tool));
            CHECK_NEAR(distance_to_move(&path.move[j.of[n]], tool), 0, WITHIN * 1.01);
        }
    joints_free(&j);
    toolpath_free(&path);
}

/* Each piece ends where the next begins, in the same direction; the last one ends where the tool's
 * path ends. */
static void pieces_meet(arb *a)
{
    const kinematics k = kind_of(arb_below(a, 2) ? &kinematics_delta_f64 : &kinematics_polar_f64);
    double at[ENGINE_AXES], before[ENGINE_AXES], after[ENGINE_AXES];
    toolpath path;
    joints j;

    arb_path(a, &path);
    CHECK(make_joints(&j, &path, &k) == 0);
    for (size_t n = 1; n < j.count; n++) {
        eval_move(j.move[n - 1].p, 1, at, before);
        eval_move(j.move[n].p, 0, at, after);
        for (int i = 0; i < ENGINE_AXES; i++) {
            CHECK(j.move[n - 1].p[3][i] == j.move[n].p[0][i]);
            CHECK_NEAR(before[i] / size_of(before), after[i] / size_of(after), 1e-9);
        }
        CHECK(j.of[n] == j.of[n - 1] || j.of[n] == j.of[n - 1] + 1);
    }
    kinematics_motors(&k, path.move[MOVES - 1].p[3], j.move[j.count - 1].p[3], at);
    for (int i = 0; i < ENGINE_AXES; i++)
        CHECK_NEAR(j.move[j.count - 1].p[3][i], at[i], 1e-9);
    joints_free(&j);
    toolpath_free(&path);
}

/* The length that a move of the motors moves the tool. */
static double tool_length(const kinematics *k, const engine_move *m)
{
    double from[ENGINE_AXES], to[ENGINE_AXES];

    CHECK(kinematics_tool(k, m->p[0], from) && kinematics_tool(k, m->p[3], to));
    for (int i = 0; i < ENGINE_AXES; i++)
        to[i] -= from[i];
    return size_of(to);
}

/* The tool is not faster than the feed, except for turning within the tolerance, and hardly slower,
 * except in short pieces. */
static void the_tool_has_its_feed(arb *a)
{
    const kinematics k = kind_of((const kinematics_kind *const[]){
        &kinematics_delta_f64, &kinematics_polar_f64, &kinematics_corexy_f64 }[arb_below(a, 3)]);
    double v[ENGINE_AXES], scaled[ENGINE_AXES];
    kinematics_moving motors = { .a = { 0 } }, tool;
    toolpath path;
    joints j;

    arb_path(a, &path);
    CHECK(make_joints(&j, &path, &k) == 0);
    for (size_t n = 0; n < j.count; n++)
        for (int i = 0; i <= 10; i++) {
            eval_move(j.move[n].p, i / 10.0, motors.x, v);
            for (int axis = 0; axis < ENGINE_AXES; axis++)
                scaled[axis] = v[axis] * j.scale[axis];
            for (int axis = 0; axis < ENGINE_AXES; axis++)
                motors.v[axis] = size_of(scaled) > 0 ? v[axis] * j.move[n].feed / size_of(scaled)
                                                     : 0;
            CHECK(kinematics_move(&k, &motors, &tool));
            CHECK(size_of(tool.v) <= 30 * 1.005);
            CHECK(size_of(tool.v) >= 30 / (EVEN * 1.01) || tool_length(&k, &j.move[n]) <= SHORT);
        }
    joints_free(&j);
    toolpath_free(&path);
}

static void a_matrix_keeps_every_curve(arb *a)
{
    const kinematics k = kind_of(&kinematics_corexy_f64);
    toolpath path;
    joints j;

    arb_path(a, &path);
    CHECK(make_joints(&j, &path, &k) == 0 && j.count == MOVES);
    for (size_t n = 0; n < j.count; n++)
        for (int i = 0; i < 4; i++) {
            const double *p = path.move[n].p[i], *m = j.move[n].p[i];
            CHECK_NEAR(m[0], p[0] + p[1], 1e-12);
            CHECK_NEAR(m[1], p[0] - p[1], 1e-12);
            CHECK(m[2] == p[2] && j.of[n] == n);
        }
    joints_free(&j);
    toolpath_free(&path);
}

/* A quarter of a circle around the pole in each move; turns add up. */
static void turns_around_the_pole_are_counted(arb *a)
{
    const kinematics k = kind_of(&kinematics_polar_f64);
    const double r = 5 + 40 * random_unit(a), handle = 0.5522847498 * r,
                 way = arb_below(a, 2) ? 1 : -1, begin = random_signed(a, 3);
    toolpath path;
    joints j;

    arb_path(a, &path);
    for (int n = 0; n < MOVES; n++)
        for (int i = 0; i < 4; i++) {
            const double turn = begin + way * (n + (i >= 2)) * 1.57079632679,
                         along = i == 1   ? handle
                                 : i == 2 ? -handle
                                          : 0;
            path.move[n].p[i][0] = k.center[0] + r * cos(turn) - way * along * sin(turn);
            path.move[n].p[i][1] = k.center[1] + r * sin(turn) + way * along * cos(turn);
        }
    CHECK(make_joints(&j, &path, &k) == 0);
    CHECK_NEAR(j.move[j.count - 1].p[3][1] - j.move[0].p[0][1], way * 360, 1e-6);
    for (size_t n = 0; n < j.count; n++)
        CHECK(way * j.move[n].p[3][1] > way * j.move[n].p[0][1]);
    joints_free(&j);
    toolpath_free(&path);
}

/* A travel leads over the pole, and stops there while the table turns. */
static void a_travel_goes_through_the_pole(arb *a)
{
    const kinematics k = kind_of(&kinematics_polar_f64);
    const double way = 7 * random_unit(a);
    size_t turned = 0;
    toolpath path;
    joints j;

    arb_path(a, &path);
    path.count = 1;
    path.curve[0] = TOOLPATH_TRAVEL;
    for (int i = 0; i < 4; i++) {
        path.move[0].p[i][0] = k.center[0] + 20 * (i / 1.5 - 1) * cos(way) + 0.3 * sin(way);
        path.move[0].p[i][1] = k.center[1] + 20 * (i / 1.5 - 1) * sin(way) - 0.3 * cos(way);
    }
    CHECK(make_joints(&j, &path, &k) == 0 && path.count == 2 && j.count == 3);
    for (size_t n = 0; n < j.count; n++) {
        const bool turns = fabs(j.move[n].p[3][1] - j.move[n].p[0][1]) > 1;
        CHECK(!turns || fabs(j.move[n].p[0][0]) + fabs(j.move[n].p[3][0]) < 1e-9);
        turned += turns;
    }
    CHECK(turned == 1);
    CHECK_NEAR(j.move[0].p[0][0], hypot(20, 0.3), 1e-9);
    CHECK_NEAR(j.move[2].p[3][0], hypot(20, 0.3), 1e-9);
    joints_free(&j);
    toolpath_free(&path);
}

static void out_of_reach_is_refused(arb *a)
{
    const kinematics delta = kind_of(&kinematics_delta_f64), polar = kind_of(&kinematics_polar_f64);
    toolpath path;
    joints j;

    arb_path(a, &path);
    path.move[2].p[1][0] += 800;
    CHECK(make_joints(&j, &path, &delta) == EX_DATAERR && caught_lines == 1);
    CHECK(strstr(caught, "file.csv:12: ") && strstr(caught, "from the tower of motor"));
    joints_free(&j);
    toolpath_free(&path);

    arb_path(a, &path);
    path.count = 1;
    for (int i = 0; i < 4; i++) {
        path.move[0].p[i][0] = polar.center[0] + 10 * (i / 1.5 - 1);
        path.move[0].p[i][1] = polar.center[1] + 0.5;
    }
    CHECK(make_joints(&j, &path, &polar) == EX_DATAERR && caught_lines == 1 &&
          strstr(caught, "from the pole"));
    joints_free(&j);
    toolpath_free(&path);
}

/* The limits of a machine of some size. */
static engine_limits arb_limits(arb *a)
{
    engine_limits l = { .tol = 0.002 + 0.02 * random_unit(a), .tick_hz = 1000 };

    for (int i = 0; i < ENGINE_AXES; i++) {
        l.max_speed[i] = 20 + 200 * random_unit(a);
        l.max_accel[i] = 100 + 2000 * random_unit(a);
        l.max_jerk[i]  = 20 * l.max_accel[i];
    }
    return l;
}

static void line_of(engine_move *m, const double from[ENGINE_AXES], const double to[ENGINE_AXES],
                    double feed)
{
    m->feed = feed;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            m->p[k][i] = k == 0 ? from[i] : k == 3 ? to[i] : from[i] + k / 3.0 * (to[i] - from[i]);
}

static void take_place(const engine_span *s, double t, double low[], double high[])
{
    double p[4][ENGINE_AXES], at[ENGINE_AXES], v[ENGINE_AXES];

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            p[k][i] = s->p[k][i] * ENGINE_LSB;
    eval_move(p, t, at, v);
    for (int i = 0; i < ENGINE_AXES; i++) {
        low[i]  = fmin(low[i], at[i]);
        high[i] = fmax(high[i], at[i]);
    }
}

/* Plan it, and give the lowest and highest place of each motor. */
static void plan_lines(engine_move *move, size_t count, const engine_limits *l, double low[],
                       double high[])
{
    const kinematics k = kind_of(&kinematics_cartesian);
    joints j = { .k = &k, .move = move, .count = count, .scale = { 1, 1, 1 }, .least = 1 };
    joints_planning p;
    engine_span s;
    int step = joints_plan(&p, &j, 0, count, &engine_f64, l);

    CHECK(step == 0);
    for (int i = 0; i < ENGINE_AXES; i++)
        low[i] = high[i] = move[0].p[0][i];
    for (step = ENGINE_PLAN_BUSY; step >= 0 && step != ENGINE_PLAN_DONE;) {
        step = joints_step(&p, &s);
        for (int n = 1; step == ENGINE_PLAN_SPAN && n <= LOOKS; n++)
            take_place(&s, (double)n / LOOKS, low, high);
    }
    CHECK(step == ENGINE_PLAN_DONE);
    joints_end(&p);
}

static void a_line_alone_goes_no_farther_than_its_ends(arb *a)
{
    const engine_limits l = arb_limits(a);
    engine_move move[MOVES];
    double end[2][ENGINE_AXES];
    double low[ENGINE_AXES], high[ENGINE_AXES];
    const size_t parts = 1 + arb_below(a, MOVES);

    for (int i = 0; i < ENGINE_AXES; i++) {
        end[0][i] = random_signed(a, 50);
        end[1][i] = end[0][i] + (arb_below(a, 3) > 0 ? random_signed(a, 20) : 0);
    }
    for (size_t n = 0; n < parts; n++) {
        double cut[2][ENGINE_AXES];
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < ENGINE_AXES; i++)
                cut[k][i] = end[0][i] +
                            (double)(n + (size_t)k) / (double)parts * (end[1][i] - end[0][i]);
        line_of(&move[n], cut[0], cut[1], 30);
    }
    plan_lines(move, parts, &l, low, high);
    for (int i = 0; i < ENGINE_AXES; i++) {
        CHECK(low[i] >= fmin(end[0][i], end[1][i]) - ENGINE_LSB);
        CHECK(high[i] <= fmax(end[0][i], end[1][i]) + ENGINE_LSB);
    }
}

static void a_pen_goes_no_deeper_than_its_line(arb *a)
{
    const engine_limits l = arb_limits(a);
    const double lift = 1 + 3 * random_unit(a), x = random_signed(a, 30), y = random_signed(a, 30),
                 corner[4][ENGINE_AXES] = { { 0, 0, lift }, { 0 }, { x, y, 0 }, { x, y, lift } };
    engine_move move[3];
    double low[ENGINE_AXES], high[ENGINE_AXES];

    for (int n = 0; n < 3; n++)
        line_of(&move[n], corner[n], corner[n + 1], 30);
    plan_lines(move, 3, &l, low, high);
    CHECK(low[2] >= -l.tol / 8 - ENGINE_LSB);
    CHECK(high[2] <= lift + ENGINE_LSB);
}

int main(void)
{
    PROPERTY(the_tool_stays_within, 12);
    PROPERTY(pieces_meet, 200);
    PROPERTY(the_tool_has_its_feed, 100);
    PROPERTY(a_matrix_keeps_every_curve, 50);
    PROPERTY(turns_around_the_pole_are_counted, 50);
    PROPERTY(a_travel_goes_through_the_pole, 50);
    PROPERTY(out_of_reach_is_refused, 5);
    PROPERTY(a_line_alone_goes_no_farther_than_its_ends, 60);
    PROPERTY(a_pen_goes_no_deeper_than_its_line, 60);
    return check_failures();
}

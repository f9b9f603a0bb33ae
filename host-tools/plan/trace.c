/* host-tools/plan/trace.c -- analyses a finished plan: its motion, and what limits it
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"       /* progress_show */
#include "plan/trace.h"
#include "base/tool.h"           /* tool_grow */
#include "plan/way.h"            /* way_follow */

#define MOMENT   0.001      /* s; spans are examined in parts of at most this */
#define USED_UP  0.97       /* of a speed                                          */
#define USED_UP_ACCEL 0.94  /* what a span may use is a multiple of 6 grains in its time */
#define USED_UP_JERK  0.85
#define ROUNDED       0.7
#define AT_REST  1e-3       /* mm/s                                                */
#define SLOWLY   0.02       /* of the feed: as good as the speed at a corner */
#define TURN     0.03       /* radians; a smaller turn is not a corner */
#define NEAR     40         /* moments between passing a corner and the slowest one */
#define LSB      (1 / 65536.0)

/* A short time within a span. */
typedef struct {
    float    seconds, speed;        /* the smallest speed in it */
    uint32_t move;
    uint8_t  cause;                 /* TRACE_CAUSES: none    */
} moment;

typedef struct {
    trace *t;
    moment *moment;
    size_t count, room;
    way path;
    double x[ENGINE_AXES];          /* planned so far        */
    double length;
    progress bar;
} making;


// Motion
// ------

static double size_of(const double v[ENGINE_AXES])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static double along_of(const double v[ENGINE_AXES], const double a[ENGINE_AXES])
{
    const double speed = size_of(v);

    return speed > AT_REST ? (v[0] * a[0] + v[1] * a[1] + v[2] * a[2]) / speed : size_of(a);
}

/* The motion at fraction z of a span that lasts h seconds. */
static void motion_of(const trace *t, const engine_span *s, double h, double z, trace_motion *out)
{
    const double y = 1 - z;
    kinematics_moving motors;

    for (int i = 0; i < ENGINE_AXES; i++) {
        const double p0 = s->p[0][i] * LSB, p1 = s->p[1][i] * LSB, p2 = s->p[2][i] * LSB,
                     p3 = s->p[3][i] * LSB;
        out->x[i] = y * y * y * p0 + 3 * y * y * z * p1 + 3 * y * z * z * p2 + z * z * z * p3;
        out->v[i] = 3 * (y * y * (p1 - p0) + 2 * y * z * (p2 - p1) + z * z * (p3 - p2)) / h;
        out->a[i] = 6 * (y * (p0 - 2 * p1 + p2) + z * (p1 - 2 * p2 + p3)) / (h * h);
        out->j[i] = 6 * (p3 - 3 * p2 + 3 * p1 - p0) / (h * h * h);
        motors.x[i] = out->x[i];
        motors.v[i] = out->v[i];
        motors.a[i] = out->a[i];
    }
    if (!kinematics_move(t->joints->k, &motors, &out->tool))
        out->tool = motors;             /* no plan leads there */
    out->speed = size_of(out->tool.v);
    out->along = along_of(out->tool.v, out->tool.a);
}

void trace_at(const trace *t, double seconds, size_t *near, trace_motion *out)
{
    if (*near >= t->count || t->begin[*near] > seconds)
        *near = 0;
    while (*near + 1 < t->count && t->begin[*near + 1] <= seconds)
        ++*near;
    const double h = t->begin[*near + 1] - t->begin[*near];
    motion_of(t, &t->span[*near], h, fmin(fmax((seconds - t->begin[*near]) / h, 0), 1), out);
}


// What is used up
// ---------------

typedef struct {
    double most;            /* the largest used share so far */
    uint8_t cause;
} use;

static void use_limit(use *u, double part, double used_up, unsigned cause)
{
    if (part / used_up > u->most) {
        u->most  = part / used_up;
        u->cause = (uint8_t)cause;
    }
}

/* Acceleration counts as curvature if more of it is across the path than along it. */
static void use_accels(use *u, const trace *t, const trace_motion *m, double share)
{
    const double speed = size_of(m->v), all = along_of(m->v, m->a);

    for (unsigned i = 0; i < ENGINE_AXES; i++) {
        const double along = speed > AT_REST ? all * m->v[i] / speed : m->a[i],
                     across = m->a[i] - along;
        use_limit(u, fabs(m->a[i]) / t->limits.max_accel[i], share * USED_UP_ACCEL,
                  fabs(across) > fabs(along) ? TRACE_CURVATURE : TRACE_ACCEL + i);
        if (t->limits.max_jerk[i] > 0)
            use_limit(u, fabs(m->j[i]) / t->limits.max_jerk[i], share * USED_UP_JERK,
                      TRACE_JERK + i);
    }
}

/* Motion is smoother than its limits: acceleration changes over some periods. A limit that is used
 * up except for that comes second. */
static uint8_t cause_of(const trace *t, const trace_motion *m, double feed)
{
    use u = { .cause = TRACE_CAUSES };

    use_limit(&u, m->speed / feed, USED_UP, TRACE_FEED);
    for (unsigned i = 0; i < ENGINE_AXES; i++)
        use_limit(&u, fabs(m->v[i]) / t->limits.max_speed[i], USED_UP, TRACE_SPEED + i);
    use_accels(&u, t, m, 1);
    if (u.most < 1)
        use_accels(&u, t, m, ROUNDED);
    return u.most >= 1 ? u.cause : TRACE_CAUSES;
}


// Moments
// -------

static void add_moment(making *m, const engine_span *s, double begin, double h, double from,
                       double to)
{
    trace_motion first, middle, last;
    moment now = { .seconds = (float)(h * (to - from)) };

    motion_of(m->t, s, h, from, &first);
    motion_of(m->t, s, h, (from + to) / 2, &middle);
    motion_of(m->t, s, h, to, &last);
    now.move  = way_follow(&m->path, middle.tool.x);
    now.speed = (float)fmin(fmin(first.speed, middle.speed), last.speed);
    now.cause = cause_of(m->t, &middle, m->t->move[now.move].feed);

    trace_part *p = &m->t->part[now.move];
    if (!(p->seconds > 0))
        p->from = begin + h * from;
    p->seconds += h * (to - from);
    p->top = fmax(p->top, fmax(fmax(first.speed, middle.speed), last.speed));
    if (m->count == m->room) {
        m->room   = m->room ? 2 * m->room : 4096;
        m->moment = tool_grow(m->moment, m->room * sizeof *m->moment);
    }
    m->moment[m->count++] = now;
}

static void add_moments(making *m)
{
    const trace *t = m->t;

    for (size_t i = 0; i < t->count; i++) {
        const double h = t->begin[i + 1] - t->begin[i];
        const int n    = (int)ceil(h / MOMENT - 1e-9);
        for (int k = 0; k < n; k++)
            add_moment(m, &t->span[i], t->begin[i], h, (double)k / n, (k + 1.0) / n);
        progress_show(&m->bar, m->length + m->path.s, "looking at the plan");
    }
}


// Corners and stops
// -----------------

/* The direction at the end of a move, or at its begin. */
static bool move_direction(const engine_move *m, bool end, double out[ENGINE_AXES])
{
    for (int k = 1; k < 4; k++) {
        const double *from = m->p[end ? 3 - k : 0], *to = m->p[end ? 3 : k];
        for (int i = 0; i < ENGINE_AXES; i++)
            out[i] = to[i] - from[i];
        const double size = size_of(out);
        for (int i = 0; i < ENGINE_AXES; i++)
            out[i] /= size;
        if (size > LSB)
            return true;
    }
    return false;
}

static bool is_corner(const engine_move *before, const engine_move *after)
{
    double a[ENGINE_AXES], b[ENGINE_AXES];

    if (!move_direction(before, true, a) || !move_direction(after, false, b))
        return false;
    for (int i = 0; i < ENGINE_AXES; i++)
        a[i] -= b[i];
    return size_of(a) > TURN;
}

/* The slowest moment near i. */
static size_t slowest_moment(const making *m, size_t i)
{
    for (int n = 0; n < NEAR; n++) {
        if (i > 0 && m->moment[i - 1].speed < m->moment[i].speed)
            i--;
        else if (i + 1 < m->count && m->moment[i + 1].speed < m->moment[i].speed)
            i++;
    }
    return i;
}

/* Mark all moments around i that are hardly faster. */
static bool is_held_back(const making *m, size_t k, float speed)
{
    return m->moment[k].speed <= 1.03 * speed + SLOWLY * m->t->move[m->moment[k].move].feed;
}

static void hold_back_moments(making *m, size_t i)
{
    const float speed   = m->moment[i].speed;
    const uint8_t cause = speed < AT_REST ? TRACE_STOP : TRACE_CORNER;

    for (size_t k = i; k < m->count && is_held_back(m, k, speed); k++)
        m->moment[k].cause = cause;
    for (size_t k = i; k > 0 && is_held_back(m, k - 1, speed); k--)
        m->moment[k - 1].cause = cause;
}

static void find_corners(making *m)
{
    const engine_move *move = m->t->move;

    for (size_t i = 0; i < m->count; i++) {
        const uint32_t now = m->moment[i].move, before = i > 0 ? m->moment[i - 1].move : now;
        bool corner = false;
        for (uint32_t k = before; k < now; k++)
            corner = corner || is_corner(&move[k], &move[k + 1]);
        const double feed = fmin(move[before].feed, move[now].feed);
        const size_t k    = corner ? slowest_moment(m, i) : i;
        if (corner && m->moment[k].speed < USED_UP * feed)
            hold_back_moments(m, k);
        else if (m->moment[i].speed < AT_REST && m->moment[i].cause != TRACE_STOP)
            hold_back_moments(m, i);
    }
}

static bool is_limit(const moment *m)   { return m->cause < TRACE_CORNER; }

/* Where no limit is used up, take the limit that is closer in time. A forward pass marks the last
 * one before, a backward pass compares. */
static void fill_gaps(making *m)
{
    size_t *before = tool_grow(NULL, m->count * sizeof *before), after = SIZE_MAX;

    for (size_t i = 0; i < m->count; i++)
        before[i] = is_limit(&m->moment[i]) ? i : i > 0 ? before[i - 1] : SIZE_MAX;
    for (size_t i = m->count; i-- > 0; ) {
        const size_t last = before[i];
        if (last == i)
            after = i;
        else if (m->moment[i].cause == TRACE_CAUSES && (last != SIZE_MAX || after != SIZE_MAX))
            m->moment[i].cause =
                m->moment[after == SIZE_MAX || (last != SIZE_MAX && i - last < after - i) ? last
                                                                                          : after]
                    .cause;
        else if (m->moment[i].cause == TRACE_CAUSES)
            m->moment[i].cause = TRACE_STOP;
    }
    free(before);
}


// All of it
// ---------

static void add_span(making *m, const engine_span *span)
{
    trace *t = m->t;
    double by[ENGINE_AXES];

    if (t->count == t->room) {
        t->room  = t->room ? 2 * t->room : 256;
        t->span  = tool_grow(t->span, t->room * sizeof *t->span);
        t->begin = tool_grow(t->begin, (t->room + 1) * sizeof *t->begin);
    }
    t->begin[0] = 0;
    t->begin[t->count + 1] = t->begin[t->count] + (double)span->ticks / t->limits.tick_hz;
    t->span[t->count++] = *span;

    for (int i = 0; i < ENGINE_AXES; i++)
        by[i] = (span->p[3][i] - (double)span->p[0][i]) * LSB;
    m->length += size_of(by);
    progress_show(&m->bar, m->length, "planning");
}

static void look_at_plan(making *m)
{
    trace *t = m->t;

    t->seconds = t->begin[t->count];
    for (size_t k = 0; k < t->moves; k++)
        t->part[k].length = m->path.length[k];
    add_moments(m);
    find_corners(m);
    fill_gaps(m);
    for (size_t i = 0; i < m->count; i++)
        t->part[m->moment[i].move].share[m->moment[i].cause] += (double)m->moment[i].seconds;
}

static int plan_spans(making *m, joints *of, const engine *e, const engine_limits *limits)
{
    joints_planning p;
    engine_span span;
    int step = joints_plan(&p, of, e, limits);

    while (step >= 0 && step != ENGINE_PLAN_DONE)
        if ((step = joints_step(&p, &span)) == ENGINE_PLAN_SPAN)
            add_span(m, &span);
    joints_end(&p);
    return step < 0 ? step : 0;
}

int trace_make(trace *t, const engine *e, const engine_limits *limits, const toolpath *path,
               joints *of)
{
    const size_t moves = path->count;
    making m = { .t = t };

    *t = (trace){ .limits = *limits, .joints = of, .move = path->move, .moves = moves };
    t->part = tool_grow(NULL, moves * sizeof *t->part);
    for (size_t k = 0; k < moves; k++)
        t->part[k] = (trace_part){ .length = 0 };
    way_make(&m.path, path->move, moves, limits->tol);
    progress_start(&m.bar, 2 * way_length(&m.path));
    const int status = plan_spans(&m, of, e, limits);
    if (status == 0 && t->count > 0)
        look_at_plan(&m);
    progress_clear(&m.bar);
    way_free(&m.path);
    free(m.moment);
    return status;
}

void trace_free(trace *t)
{
    free(t->span);
    free(t->begin);
    free(t->part);
    *t = (trace){ .count = 0 };
}

void trace_add(trace_part *sum, const trace_part *p)
{
    sum->length  += p->length;
    sum->seconds += p->seconds;
    sum->top      = fmax(sum->top, p->top);
    for (int k = 0; k < TRACE_CAUSES; k++)
        sum->share[k] += p->share[k];
}

static void cause_words(const char *axes, unsigned cause, char out[24])
{
    static const char *const kinds[] = { "speed", "acceleration", "jerk" };
    static const char *const others[] = { "curvature", "corner", "stop" };

    if (cause == TRACE_FEED)
        snprintf(out, 24, "feed");
    else if (cause < TRACE_CURVATURE)
        snprintf(out, 24, "%c %s", axes[(cause - TRACE_SPEED) % 3],
                 kinds[(cause - TRACE_SPEED) / 3]);
    else
        snprintf(out, 24, "%s", others[cause - TRACE_CURVATURE]);
}

/* Name as many causes as nine tenths of the time need. */
void trace_words(const trace *t, const trace_part *p, char *out, size_t size)
{
    double left[TRACE_CAUSES], told = 0;
    size_t used = 0;

    memcpy(left, p->share, sizeof left);
    out[0] = '\0';
    for (int n = 0; n < 4 && told < 0.9 * p->seconds && used < size; n++) {
        unsigned most = 0;
        char words[24];
        for (unsigned k = 1; k < TRACE_CAUSES; k++)
            most = left[k] > left[most] ? k : most;
        cause_words(kinematics_axes(t->joints->k), most, words);
        used += (size_t)snprintf(out + used, size - used, "%s%s %.0f %%", n ? ", " : "", words,
                                 100 * left[most] / p->seconds);
        told += left[most];
        left[most] = 0;
    }
}

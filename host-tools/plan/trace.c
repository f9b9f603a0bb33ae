/* host-tools/plan/trace.c -- analyses a plan while it is made: its motion, and what limits it
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plan/trace.h"
#include "base/host.h"
#include "base/memory.h"
#include "plan/way.h"            /* way_follow */

#define MOMENT   0.001      /* s; spans are examined in parts of at most this */
#define EVEN     16         /* parts of a span that cruises */
#define USED_UP  0.97       /* of a speed                                          */
#define USED_UP_ACCEL 0.94  /* what a span may use is a multiple of 6 grains in its time */
#define USED_UP_JERK  0.85
#define ROUNDED       0.7
#define AT_REST  1e-3       /* mm/s                                                */

typedef struct {
    trace *t;
    const trace_sink *sink;
    bool keep;
    way path;
    causes causes;
    double length;
    host *host;
    double all;                     /* its largest value */
    bool stopped;
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
        const double p0 = s->p[0][i] * ENGINE_LSB, p1 = s->p[1][i] * ENGINE_LSB,
                     p2 = s->p[2][i] * ENGINE_LSB, p3 = s->p[3][i] * ENGINE_LSB;
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

void trace_in(const trace *t, const engine_span *s, double begin, double end, double seconds,
              trace_motion *out)
{
    const double h = end - begin;

    motion_of(t, s, h, fmin(fmax((seconds - begin) / h, 0), 1), out);
}

void trace_at(const trace *t, double seconds, size_t *near, trace_motion *out)
{
    if (*near >= t->count || t->begin[*near] > seconds)
        *near = 0;
    while (*near + 1 < t->count && t->begin[*near + 1] <= seconds)
        ++*near;
    trace_in(t, &t->span[*near], t->begin[*near], t->begin[*near + 1], seconds, out);
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
    causes_moment now = { .seconds = (float)(h * (to - from)) };

    motion_of(m->t, s, h, from, &first);
    motion_of(m->t, s, h, (from + to) / 2, &middle);
    motion_of(m->t, s, h, to, &last);
    const size_t move = way_follow(&m->path, middle.tool.x);
    now.move  = (uint32_t)move;
    now.speed = (float)fmin(fmin(first.speed, middle.speed), last.speed);
    now.cause = cause_of(m->t, &middle, m->t->move[move].feed);

    trace_part *p = causes_part(&m->causes, move);
    if (!(p->seconds > 0))
        p->from = begin + h * from;
    p->seconds += h * (to - from);
    p->top = fmax(p->top, fmax(fmax(first.speed, middle.speed), last.speed));
    causes_add(&m->causes, &now);
}

/* True if it cruises: its speed is the same but for rounding. */
static bool is_even(const engine_span *s)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        for (int k = 1; k < 3; k++)
            if (llabs(3 * ((int64_t)s->p[k][i] - s->p[0][i]) -
                      k * ((int64_t)s->p[3][i] - s->p[0][i])) > 6)
                return false;
    return true;
}

static void add_moments(making *m, const engine_span *s, double begin, double end)
{
    const double h = end - begin;
    const int all = (int)ceil(h / MOMENT - 1e-9), n = all > EVEN && is_even(s) ? EVEN : all;

    for (int k = 0; k < n; k++)
        add_moment(m, s, begin, h, (double)k / n, (k + 1.0) / n);
}

static void load_move(void *context, size_t n, const engine_move *move, double length)
{
    making *m = context;

    (void)n;
    causes_add_move(&m->causes, move, length);
}

static void take_part(void *context, size_t n, const trace_part *p)
{
    making *m = context;

    if (m->keep)
        m->t->part[n] = *p;
    if (m->sink != NULL && m->sink->part != NULL)
        m->sink->part(m->sink->context, n, p);
}


// All of it
// ---------

static void keep_span(trace *t, const engine_span *span, double end)
{
    if (t->count == t->room) {
        t->room  = t->room ? 2 * t->room : 256;
        t->span  = memory_grow(t->span, t->room * sizeof *t->span);
        t->begin = memory_grow(t->begin, (t->room + 1) * sizeof *t->begin);
    }
    t->begin[0]            = 0;
    t->begin[t->count + 1] = end;
    t->span[t->count]      = *span;
}

static void add_span(making *m, const engine_span *span)
{
    trace *t           = m->t;
    const double begin = t->seconds, end = begin + (double)span->ticks / t->limits.tick_hz;
    double by[ENGINE_AXES];

    if (m->keep)
        keep_span(t, span, end);
    if (m->sink != NULL && m->sink->span != NULL)
        m->sink->span(m->sink->context, span, begin, end);
    add_moments(m, span, begin, end);
    t->seconds = end;
    t->count++;

    for (int i = 0; i < ENGINE_AXES; i++)
        by[i] = (span->p[3][i] - (double)span->p[0][i]) * ENGINE_LSB;
    m->length += size_of(by);
    const host_progress p = { "planning", m->length, m->all, false };
    m->stopped            = !host_goes_on(m->host, &p);
}

static int plan_spans(making *m, joints *of, const engine *e, const engine_limits *limits)
{
    joints_planning p;
    engine_span span;
    int step = joints_plan(&p, of, 0, of->count, e, limits);

    while (step >= 0 && step != ENGINE_PLAN_DONE && !m->stopped)
        if ((step = joints_step(&p, &span)) == ENGINE_PLAN_SPAN)
            add_span(m, &span);
    joints_end(&p);
    return step < 0 ? step : m->stopped ? TRACE_STOPPED : 0;
}

int trace_make(host *h, trace *t, const engine *e, const engine_limits *limits,
               const toolpath *path, joints *of, const trace_sink *sink, bool keep)
{
    making m = {
        .t = t, .sink = sink, .keep = keep, .host = h, .all = path->drawn + path->travelled
    };

    *t = (trace){ .limits = *limits, .joints = of, .move = path->move, .moves = path->count };
    if (keep)
        t->part = memory_grow(NULL, t->moves * sizeof *t->part);
    causes_start(&m.causes, take_part, &m);
    way_make(&m.path, path->move, t->moves, limits->tol, load_move, &m);
    const int status = plan_spans(&m, of, e, limits);
    if (status == 0) {
        way_finish(&m.path);
        causes_finish(&m.causes);
    }
    host_has_done(h);
    way_free(&m.path);
    causes_free(&m.causes);
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

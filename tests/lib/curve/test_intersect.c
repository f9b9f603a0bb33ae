/* tests/lib/curve/test_intersect.c -- properties of lib/curve/intersect.h
 * SPDX-License-Identifier: MIT
 *
 * Random curves are planar, in the first and the last axis: others do not meet. The reference cuts
 * both into chords, intersects all pairs and refines by Newton's method, in long double.
 */
#include "curve/intersect.h"
#include "support/exact.h"          /* exact_eval, exact_deriv, CHECK_EXACT */

#define LAST  (LOFT_AXES - 1)
#define ROOM  64
#define PARTS 128

typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_bezier b;
    unsigned n;
    long double c[LOFT_AXES][LOFT_DEGREE_MAX + 1], speed;
} curve;

typedef struct {
    long double s, t, sine;
} meeting;

static void prepare(curve *c)
{
    long double edge = 0;

    CHECK(loft_bezier_init(&c->b, c->p, c->n) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k <= c->n; k++) {
            c->c[i][k] = exact_of(c->p[k].axis[i]);
            if (k)
                edge = fmaxl(edge, fabsl(c->c[i][k] - c->c[i][k-1]));
        }
    c->speed = c->n * edge * sqrtl(LOFT_AXES);
}

static void arb_curve(arb *a, curve *c, unsigned degree, int32_t limit)
{
    c->n = degree;
    for (unsigned k = 0; k <= degree; k++) {
        c->p[k] = (loft_vec) { { 0 } };
        c->p[k].axis[0] = arb_real(a, limit);
        c->p[k].axis[LAST] = arb_real(a, limit);
    }
    prepare(c);
}

static long double at(const curve *c, int i, long double t) { return exact_eval(c->c[i], c->n, t); }

static long double apart(const curve *a, long double s, const curve *b, long double t)
{
    long double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += powl(at(a, i, s) - at(b, i, t), 2);
    return sqrtl(sum);
}

/* Newton's method; false if it leaves 0..1 or does not converge. */
static bool refine(const curve *a, const curve *b, meeting *m)
{
    for (int round = 0; round < 30; round++) {
        const long double x = at(b, 0, m->t) - at(a, 0, m->s),
                          y = at(b, LAST, m->t) - at(a, LAST, m->s);
        const long double ax = exact_deriv(a->c[0], a->n, 1, m->s),
                          ay = exact_deriv(a->c[LAST], a->n, 1, m->s);
        const long double bx = exact_deriv(b->c[0], b->n, 1, m->t),
                          by = exact_deriv(b->c[LAST], b->n, 1, m->t);
        const long double cross = ax * by - ay * bx;
        if (!(fabsl(cross) > 0))
            return false;
        m->s += (x * by - y * bx) / cross;
        m->t += (x * ay - y * ax) / cross;
        if (!(m->s > -0.1L && m->s < 1.1L && m->t > -0.1L && m->t < 1.1L))
            return false;
        m->sine = fabsl(cross) / (hypotl(ax, ay) * hypotl(bx, by));
    }
    return m->s >= 0 && m->s <= 1 && m->t >= 0 && m->t <= 1 && apart(a, m->s, b, m->t) < 1e-12L;
}

static bool chords_meet(long double a[2][PARTS + 1], unsigned j, long double b[2][PARTS + 1],
                        unsigned k, meeting *m)
{
    const long double ux = a[0][j + 1] - a[0][j], uy = a[1][j + 1] - a[1][j],
                      vx = b[0][k + 1] - b[0][k], vy = b[1][k + 1] - b[1][k];
    const long double x = b[0][k] - a[0][j], y = b[1][k] - a[1][j], cross = ux * vy - uy * vx;
    const long double s = (x * vy - y * vx) / cross, t = (x * uy - y * ux) / cross;

    m->s = (j + s) / PARTS;
    m->t = (k + t) / PARTS;
    return fabsl(cross) > 0 && s >= -0.5L && s <= 1.5L && t >= -0.5L && t <= 1.5L;
}

static void sample(const curve *c, long double out[2][PARTS + 1])
{
    for (unsigned k = 0; k <= PARTS; k++) {
        out[0][k] = at(c, 0, (long double)k / PARTS);
        out[1][k] = at(c, LAST, (long double)k / PARTS);
    }
}

static unsigned reference(const curve *a, const curve *b, meeting found[ROOM])
{
    static long double x[2][PARTS + 1], y[2][PARTS + 1];
    unsigned count = 0;

    sample(a, x);
    sample(b, y);
    for (unsigned j = 0; j < PARTS; j++)
        for (unsigned k = 0; k < PARTS; k++) {
            meeting m;
            bool fresh = chords_meet(x, j, y, k, &m) && refine(a, b, &m);
            for (unsigned i = 0; i < count && fresh; i++)
                fresh = fabsl(m.s - found[i].s) > 1e-9L || fabsl(m.t - found[i].t) > 1e-9L;
            if (fresh && count < ROOM)
                found[count++] = m;
        }
    return count;
}

static long double in_time(const curve *a, const curve *b)
{
    return (a->speed + b->speed) * BY_NUM(0x1.1p-25L, 0x1.1p-25L, 0x1p-50L);
}

/* The distance of a point from a curve: the least near each sample. */
static long double from_curve(const curve *a, long double s, const curve *b)
{
    long double least = INFINITY;

    for (unsigned k = 0; k <= PARTS; k++) {
        long double best = (long double)k / PARTS, here = apart(a, s, b, best);
        if (here > least + b->speed / PARTS)
            continue;
        for (long double step = 1.0L / PARTS; step > 0x1p-45L; step /= 2)
            for (int way = -1; way <= 1; way += 2) {
                const long double next = fminl(fmaxl(best + (long double)way * step, 0), 1);
                const long double there = apart(a, s, b, next);
                if (there < here) {
                    here = there;
                    best = next;
                }
            }
        least = fminl(least, here);
    }
    return least;
}

/* All points of a stretch are within tol of the other curve. */
static void check_stretch(const curve *a, loft_unit from, loft_unit to, const curve *b,
                          long double tol)
{
    for (int k = 0; k <= 2; k++) {
        const long double s = exact_unit(from) + k * (exact_unit(to) - exact_unit(from)) / 2;
        CHECK(from_curve(a, s, b) <= tol + in_time(a, b));
    }
}

/* The properties of every crossing. */
static void check_crossings(const curve *a, const curve *b, const loft_crossing c[], size_t count,
                            long double tol)
{
    const long double slack = in_time(a, b);

    for (size_t k = 0; k < count; k++) {
        const long double s = exact_unit(c[k].s), t = exact_unit(c[k].t);
        long double off = 0;

        CHECK(apart(a, s, b, t) <= tol + slack);
        CHECK_EXACT(exact_acc(c[k].distance), apart(a, s, b, t), tol / 4 + slack);
        CHECK(c[k].s_from <= c[k].s && c[k].s <= c[k].s_to && c[k].t_from <= c[k].t &&
              c[k].t <= c[k].t_to);
        CHECK(c[k].s_from >= 0 && exact_unit(c[k].s_to) <= 1 && c[k].t_from >= 0 &&
              exact_unit(c[k].t_to) <= 1);
        CHECK(k == 0 || c[k-1].s <= c[k].s);
        check_stretch(a, c[k].s_from, c[k].s_to, b, tol);
        check_stretch(b, c[k].t_from, c[k].t_to, a, tol);
        for (int i = 0; i < LOFT_AXES; i++)
            off += powl(exact_of(c[k].point.axis[i]) - (at(a, i, s) + at(b, i, t)) / 2, 2);
        CHECK(sqrtl(off) <= tol / 4 + slack + ulp(32768));
    }
}

static bool is_inside(long double x, loft_unit from, loft_unit to)
{
    const long double slack = BY_NUM(0x1p-24L, 0x1p-24L, 0x1p-50L);
    return x >= exact_unit(from) - slack && x <= exact_unit(to) + slack;
}

static int counted, crossings;

/* Every meeting is in a stretch; if meetings are clear, the number of crossings is the same. */
static void no_meeting_is_missed_and_none_invented(arb *a)
{
    const int32_t limits[3] = { 5, 300, 30000 }, limit = limits[arb_below(a, 3)];
    const int32_t raws[3] = { 2, 65, 6554 };
    const unsigned degrees[6] = { 1, 2, 3, 3, 5, LOFT_DEGREE_MAX };
    loft_real tol = loft_real_from_raw(raws[arb_below(a, 3)]);
    loft_crossing c[ROOM];
    meeting m[ROOM];
    curve p, q;
    size_t count;

    arb_curve(a, &p, degrees[arb_below(a, 6)], limit);
    arb_curve(a, &q, degrees[arb_below(a, 6)], limit);
    if (arb_below(a, 4) == 0) {             /* a common end */
        q.p[0] = p.p[p.n];
        prepare(&q);
    }
    enum loft_status status = loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count);
    if (status == LOFT_ERR_RANGE) {         /* f32 */
        tol *= 1024;
        status = loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count);
    }
    const long double t = exact_of(tol);
    const unsigned meetings = reference(&p, &q, m);

    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    check_crossings(&p, &q, c, count, t);
    bool clear = true;
    for (unsigned k = 0; k < meetings; k++) {
        size_t i = 0;
        while (i < count && !(is_inside(m[k].s, c[i].s_from, c[i].s_to) &&
                              is_inside(m[k].t, c[i].t_from, c[i].t_to)))
            i++;
        CHECK(i < count);
        const long double least = 400 * t / m[k].sine;
        clear = clear && m[k].sine > 0.01L && p.speed > least && q.speed > least;
        for (unsigned j = 0; j < k; j++)
            clear = clear && (fabsl(at(&p, 0, m[j].s) - at(&p, 0, m[k].s)) > least ||
                              fabsl(at(&p, LAST, m[j].s) - at(&p, LAST, m[k].s)) > least);
    }
    CHECK(!clear || count >= meetings);
    counted += clear && count == meetings && count > 0;
    crossings += clear && count > 0;
}

/* Curves in space pass each other. */
static void curves_that_pass_do_not_meet(arb *a)
{
#if LOFT_AXES > 2
    loft_crossing c[ROOM];
    curve p, q;
    size_t count;
    const loft_real tol = loft_real_from_raw(655);

    arb_curve(a, &p, 3, 100);
    arb_curve(a, &q, 3, 100);
    for (int k = 0; k < 4; k++)
        q.p[k].axis[1] = 2 * tol;
    prepare(&q);
    CHECK(loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count) == LOFT_OK && count == 0);
    for (int k = 0; k < 4; k++)
        q.p[k].axis[1] = tol;
    prepare(&q);
    CHECK(loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count) == LOFT_OK && count == 0);
#else
    (void)a;
#endif
}

/* A piece of a curve lies on it, forwards and backwards, from end to end. */
static void a_piece_overlaps(arb *a)
{
    const uint32_t first = arb_below(a, 700), last = first + 100 + arb_below(a, 900 - first);
    const loft_unit from = loft_unit_of(first, 1000), to = loft_unit_of(last, 1000);
    const bool along = arb_below(a, 2);
    const loft_real tol = loft_real_from_raw(655);
    loft_crossing c[ROOM];
    curve p, q;
    size_t count, k = 0;

    arb_curve(a, &p, 1 + arb_below(a, 4), 200);
    q = p;
    CHECK(loft_bezier_sub(&p.b, along ? from : to, along ? to : from, q.p) == LOFT_OK);
    prepare(&q);
    CHECK(loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count) == LOFT_SINGULAR);
    check_crossings(&p, &q, c, count, exact_of(tol));
    while (k < count && !c[k].overlap)
        k++;
    CHECK(k < count && c[k].along == along && c[k].t_from <= 0 && exact_unit(c[k].t_to) >= 1);
    CHECK(k < count && is_inside(exact_unit(from), c[k].s_from, c[k].s_to) &&
          is_inside(exact_unit(to), c[k].s_from, c[k].s_to));
}

/* The largest curves with the finest tolerance: hours, if the whole stretch were searched. */
static void a_long_overlap_takes_no_longer(arb *a)
{
    const loft_real tol = BY_NUM(8, 0.03f, 1e-6);
    const uint32_t first = arb_below(a, 500);
    loft_crossing c[ROOM];
    curve p, q;
    size_t count;

    arb_curve(a, &p, 2 + arb_below(a, 4), 30000);
    q = p;
    CHECK(loft_bezier_sub(&p.b, loft_unit_of(first, 1024), loft_unit_of(first + 512, 1024), q.p) ==
          LOFT_OK);
    prepare(&q);
    CHECK(loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count) == LOFT_SINGULAR);
    check_crossings(&p, &q, c, count, exact_of(tol));
    bool found = false;
    for (size_t k = 0; k < count; k++)
        found = found ||
                (c[k].overlap && c[k].along && c[k].t_from <= 0 && exact_unit(c[k].t_to) >= 1);
    CHECK(found && count < 10);
}

/* A straight curve of another degree and speed is the same line. */
static void lines_overlap_whatever_their_speed(arb *a)
{
    const loft_real tol = loft_real_from_raw(65);
    loft_crossing c[ROOM];
    curve p, q;
    size_t count;

    arb_curve(a, &p, 1, 1000);
    q.n = 2 + arb_below(a, 4);
    for (unsigned k = 0; k <= q.n; k++)
        q.p[k] = loft_bezier_eval(&p.b, loft_unit_of(k * k, q.n * q.n));
    prepare(&q);
    if (p.speed < 10)
        return;
    CHECK(loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count) == LOFT_SINGULAR && count == 1 &&
          c[0].overlap && c[0].along);
    check_crossings(&p, &q, c, count, exact_of(tol));
    CHECK(c[0].s_from <= 0 && exact_unit(c[0].s_to) >= 1 && c[0].t_from <= 0 &&
          exact_unit(c[0].t_to) >= 1);
}

/* A parabola touches its tangent once, and that is not an overlap. */
static void touching_is_one_crossing(arb *a)
{
    const int32_t w = 1 + (int32_t)arb_below(a, 500), h = 1 + (int32_t)arb_below(a, 500);
    const loft_real tol = loft_real_from_raw(65), x = loft_real_from_int(w),
                    y = loft_real_from_int(h);
    loft_crossing c[ROOM];
    curve p, q;
    size_t count;

    arb_curve(a, &p, 2, 1);
    arb_curve(a, &q, 1, 1);
    for (int k = 0; k < 3; k++) {
        p.p[k].axis[0] = k == 0 ? -x : k == 1 ? 0 : x;
        p.p[k].axis[LAST] = k == 1 ? -y : y;
    }
    for (int k = 0; k < 2; k++) {
        q.p[k].axis[0] = k ? x : -x;
        q.p[k].axis[LAST] = 0;
    }
    prepare(&p);
    prepare(&q);
    CHECK(loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count) == LOFT_OK);
    check_crossings(&p, &q, c, count, exact_of(tol));
    CHECK(count == 1 && !c[0].overlap && c[0].along);
    CHECK_EXACT(exact_unit(c[0].s), 0.5L, 1.01L * sqrtl(exact_of(tol) / h));
}

/* Curves that continue each other meet once, at their common end. */
static void a_joint_is_one_crossing(arb *a)
{
    const loft_real tol = loft_real_from_raw(65);
    loft_crossing c[ROOM];
    curve p, q;
    size_t count, joints = 0;

    arb_curve(a, &p, 3, 200);
    arb_curve(a, &q, 3, 200);
    q.p[0] = p.p[3];
    q.p[1] = loft_vec_sub(loft_vec_add(p.p[3], p.p[3]), p.p[2]);
    prepare(&q);
    CHECK(loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count) == LOFT_OK);
    check_crossings(&p, &q, c, count, exact_of(tol));
    for (size_t k = 0; k < count; k++)
        joints += exact_unit(c[k].s_to) >= 1 && c[k].t_from <= 0;
    CHECK(joints == 1);
}

/* A curve of degree 0 is a point. */
static void a_point_on_a_curve_is_met(arb *a)
{
    const loft_real tol = loft_real_from_raw(655);
    const loft_unit at = loft_unit_of(arb_below(a, 1001), 1000);
    loft_crossing c[ROOM];
    curve p, q;
    size_t count;

    arb_curve(a, &p, 1 + arb_below(a, 4), 200);
    arb_curve(a, &q, 0, 200);
    q.p[0] = loft_bezier_eval(&p.b, at);
    prepare(&q);
    enum loft_status status = loft_bezier_intersect(&p.b, &q.b, tol, c, ROOM, &count);
    CHECK((status == LOFT_OK || status == LOFT_SINGULAR) && count > 0);
    check_crossings(&p, &q, c, count, exact_of(tol));
    q.p[0].axis[0] = loft_real_from_int(300);
    prepare(&q);
    CHECK(loft_bezier_intersect(&q.b, &p.b, tol, c, ROOM, &count) == LOFT_OK && count == 0);
}

static void room_and_arguments_are_checked(arb *a)
{
    loft_crossing c[ROOM];
    curve p, q;
    size_t count;

    arb_curve(a, &p, 2, 100);
    arb_curve(a, &q, 1, 100);
    for (int k = 0; k < 3; k++) {
        p.p[k].axis[0] = loft_real_from_int(k - 1);
        p.p[k].axis[LAST] = loft_real_from_int(k == 1 ? -1 : 1);
    }
    for (int k = 0; k < 2; k++) {
        q.p[k].axis[0] = loft_real_from_int(2 * k - 1);
        q.p[k].axis[LAST] = (loft_real)(loft_real_from_int(1) / 2);
    }
    prepare(&p);
    prepare(&q);
    CHECK(loft_bezier_intersect(&p.b, &q.b, loft_real_from_raw(65), c, ROOM, &count) == LOFT_OK &&
          count == 2);
    CHECK(loft_bezier_intersect(&p.b, &q.b, loft_real_from_raw(65), c, 1, &count) == LOFT_MORE &&
          count == 1);
    CHECK(loft_bezier_intersect(&p.b, &q.b, loft_real_from_raw(65), c, 0, &count) == LOFT_MORE &&
          count == 0);
    CHECK(loft_bezier_intersect(&p.b, &q.b, 0, c, ROOM, &count) == LOFT_ERR_ARG && count == 0);
    CHECK(loft_bezier_intersect(&p.b, &q.b, BY_NUM(1, 0x1p-24f, 0x1p-44), c, ROOM, &count) ==
          LOFT_ERR_RANGE);
}

/* Most of the clear scenes above had the exact number of crossings. */
static void met_enough_crossings(arb *a)
{
    (void)a;
    CHECK(check_sampled() || (crossings > 50 && counted > crossings * 9 / 10));
}

/* In one axis nothing crosses. */
static void one_axis_is_refused(arb *a)
{
    const loft_vec p[2] = { arb_vec(a, 100), arb_vec(a, 100) };
    loft_bezier b;
    loft_crossing c[1];
    size_t count = 7;

    CHECK(loft_bezier_init(&b, p, 1) == LOFT_OK);
    const enum loft_status status = loft_bezier_intersect(&b, &b, LOFT_REAL(0.5), c, 1, &count);
    CHECK(LOFT_AXES > 1 ? status != LOFT_ERR_ARG : status == LOFT_ERR_ARG && count == 0);
}

int main(void)
{
    PROPERTY(one_axis_is_refused,                     10);
    if (LOFT_AXES < 2)
        return check_failures();
    PROPERTY(no_meeting_is_missed_and_none_invented, 400);
    PROPERTY(curves_that_pass_do_not_meet,           200);
    PROPERTY(a_piece_overlaps,                       200);
    PROPERTY(a_long_overlap_takes_no_longer,          50);
    PROPERTY(lines_overlap_whatever_their_speed,      50);
    PROPERTY(touching_is_one_crossing,               100);
    PROPERTY(a_joint_is_one_crossing,                100);
    PROPERTY(a_point_on_a_curve_is_met,              100);
    PROPERTY(room_and_arguments_are_checked,           1);
    PROPERTY(met_enough_crossings,                     1);
    return check_failures();
}

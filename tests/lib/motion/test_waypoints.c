/* tests/lib/motion/test_waypoints.c -- properties of lib/motion/waypoints.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"      /* exact_of; CHECK, PROPERTY */
#include "motion/waypoints.h"

#define COUNT 6
#define MOVES 4
#define LOOK_MOST (LOFT_PLAN_EFFORT > 1 || LOFT_AXES > 3 ? 400 : 220)   /* a chip has 16 kB */
#define PASSED    (LOFT_PLAN_EFFORT > 1 ? 8 : 4)
#define LOOPS     (LOFT_PLAN_EFFORT > 1 ? 9 : 30)
#define LOOK      112       /* knots of a chip */

static loft_plan plan;
static loft_move moves[MOVES];
static loft_knot ahead[LOOK_MOST];
static loft_natural_knot slopes[COUNT];

static loft_limits limits_of(int32_t speed, int32_t accel, uint32_t jerk)
{
    loft_limits l = { .corner = LOFT_REAL(0.01), .tol = LOFT_REAL(0.01), .tick_hz = 1000 };

    for (int i = 0; i < LOFT_AXES; i++) {
        l.max_speed[i] = loft_real_from_int(speed);
        l.max_accel[i] = loft_real_from_int(accel);
        l.max_jerk[i] = jerk;
    }
    return l;
}

static loft_limits usual(void) { return limits_of(100, 1000, 0); }

static uint32_t arb_points(arb *a, loft_vec p[COUNT])
{
    const uint32_t count = 2 + arb_below(a, COUNT - 1);

    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < LOFT_AXES; k++)
            p[i].axis[k] = loft_real_from_int((int32_t)arb_below(a, 60)) +
                           (k == 0 ? loft_real_from_int(100 * (int32_t)i) : 0);
    return count;
}

static long double distance(const loft_vec *p, const loft_vec *q)
{
    long double sum = 0;
    for (int k = 0; k < LOFT_AXES; k++)
        sum += powl(exact_of(p->axis[k]) - exact_of(q->axis[k]), 2);
    return sqrtl(sum);
}

/* Along each span, how near does it come to p? */
static long double nearest(const loft_span *s, const loft_vec *p)
{
    const loft_cubic c = { { s->p[0], s->p[1], s->p[2], s->p[3] } };
    long double best = HUGE_VALL;

    for (uint32_t i = 0; i <= 64; i++) {
        const loft_vec at = loft_cubic_eval(&c, loft_unit_of(i, 64));
        best = fminl(best, distance(&at, p));
    }
    return best;
}

/* It comes near each point in turn: within the tolerance, and half a step of the samples. */
static void each_point_is_passed_in_turn(arb *a)
{
    loft_vec p[COUNT];
    const uint32_t count = arb_points(a, p);
    const loft_limits limits = usual();
    loft_waypoints w;
    loft_span s;
    uint32_t next = 0;
    enum loft_plan_state state;

    CHECK(loft_plan_init(&plan, &limits, moves, MOVES, ahead, 160) == LOFT_OK);
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(50), slopes) == LOFT_OK);
    while ((state = loft_waypoints_next(&w, &s)) == LOFT_PLAN_SPAN)
        while (next < count) {
            const long double step = s.ticks * 0.05L / 64;     /* at most, at 50 mm/s */
            if (nearest(&s, &p[next]) > 0.01L + step / 2 + 0.001L)
                break;
            next++;
        }
    CHECK(state == LOFT_PLAN_REST && next == count);
    for (int k = 0; k < LOFT_AXES; k++)
        CHECK(s.p[3].axis[k] == p[count - 1].axis[k]);
    CHECK(loft_waypoints_next(&w, &s) == LOFT_PLAN_REST);
}

static void what_cannot_be_moved_is_refused(arb *a)
{
    loft_vec p[COUNT];
    const uint32_t count = arb_points(a, p);
    const loft_limits limits = usual();
    loft_waypoints w;

    CHECK(loft_plan_init(&plan, &limits, moves, MOVES, ahead, 160) == LOFT_OK);
    CHECK(loft_waypoints_init(&w, &plan, p, 1, LOFT_REAL(50), slopes) == LOFT_ERR_ARG);
    CHECK(loft_waypoints_init(&w, &plan, p, count, 0, slopes) == LOFT_ERR_ARG);
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(20000), slopes) == LOFT_ERR_RANGE);
    p[0].axis[0] = LOFT_REAL(-9000);
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(50), slopes) == LOFT_ERR_RANGE);
    p[0] = p[1];
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(50), slopes) == LOFT_SINGULAR);
}

/* Points near each other: less than a launch. */
static uint32_t arb_near_points(arb *a, loft_vec p[COUNT])
{
    const uint32_t count = arb_points(a, p);

    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < LOFT_AXES; k++)
            p[i].axis[k] = loft_real_from_int((int32_t)arb_below(a, 9)) +
                           (k == 0 ? loft_real_from_int(10 * (int32_t)i) : 0);
    return count;
}

/* Any memory, and a plan that may stop at joints. */
static uint16_t arb_move_room(arb *a) { return (uint16_t)(1 + arb_below(a, MOVES)); }

static uint16_t arb_knot_room(arb *a)
{
    const uint32_t most = arb_below(a, 2) ? 8 : 160 - LOFT_PLAN_KNOTS_MIN;
    return (uint16_t)(LOFT_PLAN_KNOTS_MIN + arb_below(a, most + 1));
}

static loft_limits arb_limits(arb *a)
{
    loft_limits l = limits_of(200, 2000, 50000);

    if (arb_below(a, 2))
        l.exact = arb_below(a, 2) ? LOFT_REAL(0.02) : LOFT_REAL(0.5);
    return l;
}

/* The loop of waypoints.h, with any memory. */
static void the_loop_of_its_header_comes_to_the_end(arb *a)
{
    const uint16_t move_room = arb_move_room(a), knot_room = arb_knot_room(a);
    const loft_limits limits = arb_limits(a);
    loft_vec points[COUNT], at = { { 0 } };
    const uint32_t count = arb_near_points(a, points);
    uint32_t ticks = 0;

    static loft_natural_knot knots[COUNT];
    loft_waypoints way;
    loft_span span;
    if (loft_plan_init(&plan, &limits, moves, move_room, ahead, knot_room) == LOFT_OK &&
        loft_waypoints_init(&way, &plan, points, count, LOFT_REAL(200), knots) == LOFT_OK)
        while (loft_waypoints_next(&way, &span) == LOFT_PLAN_SPAN) {
            ticks += span.ticks;
            at = span.p[3];
        }
    CHECK(ticks > 0 && loft_vec_equal(at, points[count - 1]));
}

static loft_vec sent_to;

static void send(const loft_span *span) { sent_to = span->p[3]; }

/* The loop of plan.h. Each turn of it pushes a curve or gives a span, but for one at most. */
static void so_does_that_of_a_plan(arb *a)
{
    const uint16_t move_room = arb_move_room(a), knot_room = arb_knot_room(a);
    const loft_limits limits = arb_limits(a);
    loft_knot *const knots = ahead;
    loft_vec p[COUNT];
    loft_move curve[COUNT];
    const uint32_t count = arb_near_points(a, p) - 1;
    uint32_t next = 0;
    enum loft_plan_state state;
    loft_span span;

    for (uint32_t k = 0; k < count; k++) {
        const loft_vec *q = &p[k];
        curve[k] = (loft_move){ .feed = LOFT_REAL(200) };
        curve[k].curve = (loft_cubic){ { q[0], loft_vec_lerp(q[0], q[1], loft_unit_of(1, 3)),
                                         loft_vec_lerp(q[0], q[1], loft_unit_of(2, 3)), q[1] } };
    }
    if (loft_plan_init(&plan, &limits, moves, move_room, knots, knot_room) == LOFT_OK)
        do {
            while (next < count && loft_plan_push(&plan, &curve[next]) == LOFT_OK)
                next++;
            if (next == count)
                loft_plan_end(&plan);
            while ((state = loft_plan_next(&plan, &span)) == LOFT_PLAN_SPAN)
                send(&span);
        } while (next < count || state != LOFT_PLAN_REST);
    CHECK(next == count && loft_vec_equal(sent_to, p[count]));
}

/* Ticks through the points with so many knots. */
static uint32_t ticks_with(uint16_t room, const loft_vec p[COUNT], uint32_t count)
{
    const loft_limits fast = limits_of(200, 2000, 50000);
    loft_waypoints w;
    loft_span s;
    uint32_t ticks = 0;

    CHECK(loft_plan_init(&plan, &fast, moves, MOVES, ahead, room) == LOFT_OK);
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(200), slopes) == LOFT_OK);
    while (loft_waypoints_next(&w, &s) == LOFT_PLAN_SPAN)
        ticks += s.ticks;
    return ticks;
}

/* However many axes move. Where a place and its pace share memory, none spoils the other. */
static void the_memory_of_a_chip_is_enough(arb *a)
{
    loft_vec p[COUNT];
    const uint32_t count = arb_points(a, p), few = ticks_with(LOOK, p, count),
                   many = ticks_with(LOOK_MOST, p, count);

    CHECK(few <= many + many / 20);
}

/* How far a span is beyond from..to on an axis. */
static long double beyond(const loft_span *s, int i, const loft_vec *from, const loft_vec *to)
{
    const loft_cubic c = { { s->p[0], s->p[1], s->p[2], s->p[3] } };
    long double most = 0;

    for (uint32_t n = 1; n <= 16; n++) {
        const loft_vec at = loft_cubic_eval(&c, loft_unit_of(n, 16));
        const long double x = exact_of(at.axis[i]), a = exact_of(from->axis[i]),
                          b = exact_of(to->axis[i]);
        most = fmaxl(most, fmaxl(fminl(a, b) - x, x - fmaxl(a, b)));
    }
    return most;
}

/* Pen down, a line, pen up: neither the pen nor the line passes its end by an eighth of the
 * tolerance, with little effort by a quarter. */
static void a_pen_stops_where_its_line_does(arb *a)
{
    loft_limits l = limits_of(20 + (int32_t)arb_below(a, 200), 200 + (int32_t)arb_below(a, 3000),
                              8000 + arb_below(a, 100000));
    loft_vec p[4] = { { { 0 } } };
    loft_span s;
    uint32_t next = 0;

    l.corner = 0;
    l.tol = loft_real_from_raw(200 + (int32_t)arb_below(a, 1000));
    l.one_sided = 4;
    p[0].axis[2] = p[3].axis[2] = loft_real_from_int(1 + (int32_t)arb_below(a, 5));
    p[2].axis[0] = p[3].axis[0] = loft_real_from_int(1 + (int32_t)arb_below(a, 20));
    p[2].axis[1] = p[3].axis[1] = loft_real_from_int((int32_t)arb_below(a, 20));
    CHECK(loft_plan_init(&plan, &l, moves, MOVES, ahead, LOOK) == LOFT_OK);
    for (; next < 3; next++) {
        const loft_vec *q = &p[next];
        const loft_move line = { { { q[0], loft_vec_lerp(q[0], q[1], loft_unit_of(1, 3)),
                                     loft_vec_lerp(q[0], q[1], loft_unit_of(2, 3)), q[1] } },
                                 LOFT_REAL(50) };
        CHECK(loft_plan_push(&plan, &line) == LOFT_OK);
    }
    loft_plan_end(&plan);
    while (loft_plan_next(&plan, &s) == LOFT_PLAN_SPAN)
        for (int i = 0; i < 3; i++)
            CHECK(beyond(&s, i, &p[i == 2 ? 3 : 0], &p[2]) <= exact_of(l.tol) / PASSED);
}

int main(void)
{
    PROPERTY(each_point_is_passed_in_turn, 25);
    PROPERTY(the_loop_of_its_header_comes_to_the_end, LOOPS);
    PROPERTY(so_does_that_of_a_plan, LOOPS);
    PROPERTY(the_memory_of_a_chip_is_enough, LOOPS / 3);
    PROPERTY(a_pen_stops_where_its_line_does, 2 * LOOPS);
    PROPERTY(what_cannot_be_moved_is_refused, 200);
    return check_failures();
}

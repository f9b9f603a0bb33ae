/* tests/lib/motion/test_waypoints.c -- properties of lib/motion/waypoints.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"      /* exact_of; CHECK, PROPERTY */
#include "motion/waypoints.h"

#define COUNT 6
#define MOVES 4

static loft_plan plan;
static loft_move moves[MOVES];
static loft_knot ahead[160];
static loft_natural_knot knots[COUNT];

static const loft_limits limits = {
    .max_speed = { LOFT_REAL(100), LOFT_REAL(100), LOFT_REAL(100) },
    .max_accel = { LOFT_REAL(1000), LOFT_REAL(1000), LOFT_REAL(1000) },
    .corner = LOFT_REAL(0.01),
    .tol = LOFT_REAL(0.01),
    .tick_hz = 1000,
};

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
    loft_waypoints w;
    loft_span s;
    uint32_t next = 0;
    enum loft_plan_state state;

    CHECK(loft_plan_init(&plan, &limits, moves, MOVES, ahead, 160) == LOFT_OK);
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(50), knots) == LOFT_OK);
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
    loft_waypoints w;

    CHECK(loft_plan_init(&plan, &limits, moves, MOVES, ahead, 160) == LOFT_OK);
    CHECK(loft_waypoints_init(&w, &plan, p, 1, LOFT_REAL(50), knots) == LOFT_ERR_ARG);
    CHECK(loft_waypoints_init(&w, &plan, p, count, 0, knots) == LOFT_ERR_ARG);
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(20000), knots) == LOFT_ERR_RANGE);
    p[0].axis[0] = LOFT_REAL(-9000);
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(50), knots) == LOFT_ERR_RANGE);
    p[0] = p[1];
    CHECK(loft_waypoints_init(&w, &plan, p, count, LOFT_REAL(50), knots) == LOFT_SINGULAR);
}

int main(void)
{
    PROPERTY(each_point_is_passed_in_turn, 25);
    PROPERTY(what_cannot_be_moved_is_refused, 200);
    return check_failures();
}

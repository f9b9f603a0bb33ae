/* lib/examples/arm.c -- move the joints of an arm through way-points, each within its limits
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

static const loft_limits limits = {
    /* degrees, s */
    .max_speed = { LOFT_REAL(90), LOFT_REAL(60), LOFT_REAL(120) },
    .max_accel = { LOFT_REAL(300), LOFT_REAL(200), LOFT_REAL(400) },
    .tol = LOFT_REAL(0.05),
    .tick_hz = 100,
};
#define JOINTS(a, b, c) { { LOFT_REAL(a), LOFT_REAL(b), LOFT_REAL(c) } }
static const loft_vec points[] = { JOINTS(0, 0, 0), JOINTS(45, 30, -20), JOINTS(90, 10, 60),
                                   JOINTS(60, -20, 90) };
static loft_natural_knot knots[4];
static loft_move moves[4];
static loft_knot ahead[160];
static loft_plan plan;

int main(void)
{
    loft_waypoints way;
    loft_span span;
    unsigned ticks = 0;

    if (loft_plan_init(&plan, &limits, moves, 4, ahead, 160) != LOFT_OK ||
        loft_waypoints_init(&way, &plan, points, 4, LOFT_SPEED_MAX, knots) != LOFT_OK)
        return 1;
    while (loft_waypoints_next(&way, &span) == LOFT_PLAN_SPAN)
        ticks += span.ticks;            /* here: walk it, a point in each tick */
    printf("%u ms, at rest at %ld %ld %ld degrees\n", 10 * ticks,
           (long)loft_acc_int(loft_to_acc(span.p[3].axis[0])),
           (long)loft_acc_int(loft_to_acc(span.p[3].axis[1])),
           (long)loft_acc_int(loft_to_acc(span.p[3].axis[2])));
    return 0;
}

/* prints
 *
 *     2170 ms, at rest at 60 -20 90 degrees
 */

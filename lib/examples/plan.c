/* lib/examples/plan.c -- plan a path within the machine's limits, curve by curve, while it moves
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"
static const loft_limits limits = {
    .max_speed = { LOFT_REAL(200), LOFT_REAL(200), LOFT_REAL(20) }, /* mm, s */
    .max_accel = { LOFT_REAL(1000), LOFT_REAL(1000), LOFT_REAL(200) },
    .tol = LOFT_REAL(0.01),
    .tick_hz = 1000,
};
#define XY(x, y) { { LOFT_REAL(x), LOFT_REAL(y), 0 } }
static const loft_vec corner[4] = { XY(0, 0), XY(30, 0), XY(30, 20), XY(0, 20) };
static const loft_cubic bow = { { XY(30, 0), XY(45, 0), XY(45, 20), XY(30, 20) } };
static loft_move moves[2];                      /* as many as the planner looks ahead */
static loft_knot knots[160];
static loft_plan plan;

int main(void)
{
    const loft_move path[] = { { loft_cubic_line(corner[0], corner[1]), LOFT_REAL(100) },
                               { bow, LOFT_REAL(50) },
                               { loft_cubic_line(corner[2], corner[3]), LOFT_REAL(100) },
                               { loft_cubic_line(corner[3], corner[0]), LOFT_REAL(100) } };
    unsigned pushed = 0, ticks = 0, count = sizeof path / sizeof *path;
    enum loft_plan_state state;
    loft_span span;

    if (loft_plan_init(&plan, &limits, moves, 2, knots, 160) != LOFT_OK)
        return 1;
    do {
        while (pushed < count && loft_plan_push(&plan, &path[pushed]) == LOFT_OK)
            if (++pushed == count)
                loft_plan_end(&plan);
        if ((state = loft_plan_next(&plan, &span)) == LOFT_PLAN_SPAN)
            ticks += span.ticks;                /* here: put it into the queue of the interrupt */
    } while (state != LOFT_PLAN_REST);
    return printf("%u curves in %u.%02u s, at rest again\n", pushed, ticks / 1000,
                  ticks % 1000 / 10) < 0;
}

/* prints
 *
 *     4 curves in 1.72 s, at rest again
 */

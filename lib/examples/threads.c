/* lib/examples/threads.c -- plan in one thread, step in another, as two tasks of an RTOS do
 * SPDX-License-Identifier: MIT
 */
#include <pthread.h>
#include <semaphore.h>
#include <stdio.h>
#include "loft.h"
static loft_limits limits = { .tol = LOFT_REAL(0.01), .tick_hz = 1000 };
static loft_plan plan;
static loft_move moves[4];
static loft_knot knots[160];
static loft_span queue[4];              /* the planner writes, the ticks read; 0 ticks: the end */
static sem_t room, filled;              /* as those of an RTOS: they wait, and order the memory */
static void *planner(void *unused)      /* low priority; its stack: loft_plan_next of STACK.md */
{
    loft_plan_end(&plan);
    for (unsigned n = 0, last = 0; !last && sem_wait(&room) == 0; n++, sem_post(&filled))
        if ((last = loft_plan_next(&plan, &queue[n % 4]) != LOFT_PLAN_SPAN) != 0)
            queue[n % 4].ticks = 0;
    return unused;
}
int main(void)                          /* high priority, or a timer's interrupt */
{
    const loft_vec ends[2] = { { { 0 } }, { { LOFT_REAL(50) } } };
    const loft_move move = { loft_cubic_line(ends[0], ends[1]), LOFT_REAL(60) };
    loft_forward walk;
    loft_vec at;
    pthread_t thread;
    for (int i = 0; i < LOFT_AXES; i++)
        limits.max_speed[i] = LOFT_REAL(60), limits.max_accel[i] = LOFT_REAL(800);
    if (loft_plan_init(&plan, &limits, moves, 4, knots, 160) || loft_plan_push(&plan, &move) ||
        sem_init(&room, 0, 4) || sem_init(&filled, 0, 0) ||
        pthread_create(&thread, NULL, planner, NULL))
        return 1;                       /* from here on the plan is the planner's alone */
    for (unsigned n = 0; sem_wait(&filled) == 0 && queue[n % 4].ticks > 0; n++, sem_post(&room))
        for (bool on = !loft_span_walk(&walk, &queue[n % 4]); on;)
            on = loft_forward_next(&walk, &at);         /* here: steps, as walk.c makes them */
    return pthread_join(thread, NULL) ||
           printf("at %d mm\n", (int)loft_prod_int(at.axis[0], LOFT_REAL(1))) < 0;
}

/* prints
 *
 *     at 50 mm
 */

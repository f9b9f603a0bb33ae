/* lib/examples/walk.c -- walk a curve in an interrupt, by additions only
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

#define XY(x, y) { { LOFT_REAL(x), LOFT_REAL(y), 0 } }
static const loft_vec points[4] = { XY(0, 0), XY(30, 0), XY(0, 40), XY(30, 40) };     /* in flash */

static loft_forward  walk;
static volatile bool walking;
static int32_t       motor[2];                  /* the steps that the motors were sent to */

static void timer_interrupt(void)               /* a thousand times a second */
{
    loft_vec at;

    walking = loft_forward_next(&walk, &at);
    for (int i = 0; walking && i < 2; i++)
        motor[i] = loft_steps_of(at.axis[i], LOFT_REAL(80));       /* 80 steps a millimetre */
}

int main(void)
{
    loft_bezier curve;
    unsigned ticks = 0;

    if (loft_bezier_init(&curve, points, 4 - 1) != LOFT_OK ||
        loft_forward_init(&walk, &curve, 512) != LOFT_OK)          /* 512 points, each exact */
        return 1;
    for (timer_interrupt(); walking; timer_interrupt())
        if (++ticks % 128 == 0)
            printf("tick %u: %ld %ld\n", ticks, (long)motor[0], (long)motor[1]);
    return 0;
}

/* prints
 *
 *     tick 128: 1050 500
 *     tick 256: 1200 1600
 *     tick 384: 1350 2700
 *     tick 512: 2400 3200
 */

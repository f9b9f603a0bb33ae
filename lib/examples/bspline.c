/* lib/examples/bspline.c -- follow a B-spline at 1 kHz
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

#define XY(x, y) { { LOFT_REAL(x), LOFT_REAL(y), 0 } }
static const loft_vec points[] = { XY(0, 0), XY(10, 20), XY(30, 20), XY(40, 0), XY(60, 10) };
/* seconds: it begins and ends on its end points, and takes 1.5 s */
static const loft_real knots[] = { LOFT_REAL(0),   LOFT_REAL(0),   LOFT_REAL(0),
                                   LOFT_REAL(0),   LOFT_REAL(0.5), LOFT_REAL(1.5),
                                   LOFT_REAL(1.5), LOFT_REAL(1.5), LOFT_REAL(1.5) };

int main(void)
{
    loft_bspline curve;

    if (loft_bspline_init(&curve, points, 5, knots, 3) != LOFT_OK)
        return 1;
    for (int32_t tick = 0; tick <= 1500; tick++) {              /* once a millisecond */
        const loft_real seconds = loft_acc_round(
            loft_acc_ratio(loft_to_acc(loft_real_from_int(tick)), 1000));
        const loft_vec at = loft_bspline_eval(&curve, seconds);
        if (tick % 250 == 0)                                    /* here: move the motors to `at` */
            printf("%4ld ms: %ld %ld steps\n", (long)tick,
                   (long)loft_steps_of(at.axis[0], LOFT_REAL(80)),
                   (long)loft_steps_of(at.axis[1], LOFT_REAL(80)));
    }
    return 0;
}

/* prints
 *
 *        0 ms: 0 0 steps
 *      250 ms: 1022 1378 steps
 *      500 ms: 1778 1422 steps
 *      750 ms: 2400 1063 steps
 *     1000 ms: 3022 678 steps
 *     1250 ms: 3778 510 steps
 *     1500 ms: 4800 800 steps
 */

/* lib/examples/servo.c -- ease a servo between poses, starting and stopping without a jolt
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

#define DEGREES(pan, tilt) { { LOFT_REAL(pan), LOFT_REAL(tilt), 0 } }
static const loft_vec pose[] = { DEGREES(0, 90), DEGREES(60, 30), DEGREES(-45, 75) };

/* Speed and acceleration are 0 at both ends: of all such moves this has the least jerk. */
static enum loft_status ease(loft_forward *walk, loft_vec from, loft_vec to, uint32_t frames)
{
    const loft_hermite5 move = { .p0 = from, .p1 = to };
    loft_vec points[6];
    loft_bezier curve;
    enum loft_status status = loft_bezier_from_hermite5(&move, points);

    if (status == LOFT_OK)
        status = loft_bezier_init(&curve, points, 5);
    return status == LOFT_OK ? loft_forward_init(walk, &curve, frames) : status;
}

int main(void)
{
    loft_forward walk;
    loft_vec at;

    for (int i = 0; i + 1 < (int)(sizeof pose / sizeof *pose); i++) {
        if (ease(&walk, pose[i], pose[i + 1], 64) != LOFT_OK)      /* 64 frames of 20 ms: 1.3 s */
            return 1;
        for (int frame = 1; loft_forward_next(&walk, &at); frame++)
            if (frame % 16 == 0)                /* pulses: 1500 us in the middle, 10 us a degree */
                printf("%ld %ld us\n", 1500 + (long)loft_steps_of(at.axis[0], LOFT_REAL(10)),
                       1500 + (long)loft_steps_of(at.axis[1], LOFT_REAL(10)));
    }
    return 0;
}

/* prints
 *
 *     1562 2338 us
 *     1800 2100 us
 *     2038 1862 us
 *     2100 1800 us
 *     1991 1847 us
 *     1575 2025 us
 *     1159 2203 us
 *     1050 2250 us
 */

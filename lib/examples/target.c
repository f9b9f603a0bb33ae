/* lib/examples/target.c -- move one axis to a target, and change the target on the way
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

static const loft_scurve_limits limits = {
    /* degrees, s */
    .max_speed = LOFT_REAL(180),
    .max_accel = LOFT_REAL(720),
    .max_jerk = 7200,
    .tick_hz = 50,
};

int main(void)
{
    loft_scurve servo;

    if (loft_scurve_init(&servo, LOFT_REAL(0), LOFT_REAL(90), &limits) != LOFT_OK)
        return 1;
    for (uint32_t tick = 1; tick <= servo.ticks; tick++) {      /* in a timer of 50 Hz */
        if (tick == 25 && loft_scurve_retarget(&servo, tick, LOFT_REAL(30)) != LOFT_OK)
            return 1;
        if (tick % 8 == 0 || tick == servo.ticks)
            printf("%2lu: %ld us\n", (unsigned long)tick,   /* pulses: 10 us a degree */
                   1500 + (long)loft_steps_of(loft_scurve_eval(&servo, tick), LOFT_REAL(10)));
    }
    return 0;
}

/* prints
 *
 *      8: 1545 us
 *     16: 1753 us
 *     24: 2040 us
 *     32: 2297 us
 *     40: 2398 us
 *     48: 2389 us
 *     56: 2256 us
 *     64: 2002 us
 *     72: 1829 us
 *     79: 1800 us
 */

/* lib/motion/kinematics.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/kinematics.h"

#if LOFT_AXES >= 2

/* a = x + y, b = x - y; x = (a + b) / 2, y = (a - b) / 2. The way back
 * is in acc, for a + b may be beyond a coordinate. */
loft_vec loft_corexy_motors(const void *geometry, loft_vec tool)
{
    const loft_real x = tool.axis[0], y = tool.axis[1];

    (void)geometry;
    tool.axis[0] = x + y;
    tool.axis[1] = x - y;
    return tool;
}

loft_vec loft_corexy_tool(loft_vec motors)
{
    const loft_acc a = loft_wide(motors.axis[0]), b = loft_wide(motors.axis[1]);

    motors.axis[0] = loft_acc_round((a + b) / 2);
    motors.axis[1] = loft_acc_round((a - b) / 2);
    return motors;
}

#if LOFT_AXES >= 3

/* Pythagoras: the carriage is above the joint by h, h^2 = arm^2 - dx^2 - dy^2. Products are exact in acc, below 2^28 + 2 * 2^30. */
loft_vec loft_delta_motors(const void *geometry, loft_vec tool)
{
    const loft_delta *delta = geometry;
    const loft_real x = tool.axis[0], y = tool.axis[1], z = tool.axis[2];

    for (int i = 0; i < 3; i++) {
        const loft_real dx = x - delta->tower[i][0], dy = y - delta->tower[i][1];
        const loft_acc left = loft_prod(delta->arm, delta->arm) - loft_prod(dx, dx) - loft_prod(dy, dy);
        tool.axis[i] = z + (left > 0 ? loft_acc_sqrt(left) : 0);
    }
    return tool;
}

#endif
#endif

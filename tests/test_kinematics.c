/* tests/test_kinematics.c -- properties of lib/motion/kinematics.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "check.h"
#include "motion/kinematics.h"

static void corexy_there_and_back_is_where_it_was(arb *a)
{
    const loft_vec tool = arb_vec(a, 16000), motors = loft_corexy_motors(NULL, tool), back = loft_corexy_tool(motors);
    const double x = arb_value(tool.axis[0]), y = arb_value(tool.axis[1]), ulp = BY_NUM(0, 0x1p-9, 0x1p-37);

    CHECK_NEAR(arb_value(motors.axis[0]), x + y, ulp);
    CHECK_NEAR(arb_value(motors.axis[1]), x - y, ulp);
    CHECK_NEAR(arb_value(back.axis[0]), x, ulp);
    CHECK_NEAR(arb_value(back.axis[1]), y, ulp);
    CHECK(motors.axis[2] == tool.axis[2] && back.axis[2] == tool.axis[2]);
}

/* The arms have their length: the carriage is where a sphere around the joint meets the tower. */
static void the_arms_of_a_delta_keep_their_length(arb *a)
{
    loft_delta d;
    loft_vec tool = arb_vec(a, 100);

    d.arm = loft_real_from_raw((int32_t)(400 * 65536 + arb_below(a, 200 * 65536)));
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            d.tower[i][k] = arb_real(a, 150);
    const loft_vec motors = loft_delta_motors(&d, tool);
    for (int i = 0; i < 3; i++) {
        const double dx = arb_value(tool.axis[0]) - arb_value(d.tower[i][0]), dy = arb_value(tool.axis[1]) - arb_value(d.tower[i][1]);
        const double h = sqrt(arb_value(d.arm) * arb_value(d.arm) - dx * dx - dy * dy);
        CHECK_NEAR(arb_value(motors.axis[i]) - arb_value(tool.axis[2]), h, BY_NUM(0.5001 / 65536, 2e-4, 1e-9));
    }
}

static void an_arm_that_does_not_reach_lies_flat(arb *a)
{
    const loft_delta d = { { { 0, 0 }, { 0, 0 }, { 0, 0 } }, LOFT_REAL(10) };
    loft_vec tool = arb_vec(a, 1);

    tool.axis[0] = LOFT_REAL(11);
    CHECK(loft_delta_motors(&d, tool).axis[0] == tool.axis[2]);
}

int main(void)
{
    PROPERTY(corexy_there_and_back_is_where_it_was,  20000);
    PROPERTY(the_arms_of_a_delta_keep_their_length,  20000);
    PROPERTY(an_arm_that_does_not_reach_lies_flat,     100);
    return check_failures();
}

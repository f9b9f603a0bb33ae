/* tests/lib/kinematics/test_kinematics.c -- properties of lib/kinematics/kinematics.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include "support/exact.h"          /* exact_of, ulp */
#include "kinematics/kinematics.h"

#define PI 3.14159265358979323846264338327950288L

static void corexy_there_and_back_is_where_it_was(arb *a)
{
    const loft_vec tool = arb_vec(a, 16000), motors = loft_corexy_motors(NULL, tool);
    const double x = arb_value(tool.axis[0]), y = arb_value(tool.axis[1]),
                 off = BY_NUM(0, 0x1p-9, 0x1p-37);
    loft_vec back;

    CHECK(loft_corexy_tool(NULL, motors, &back));
    CHECK_NEAR(arb_value(motors.axis[0]), x + y, off);
    CHECK_NEAR(arb_value(motors.axis[1]), x - y, off);
    CHECK_NEAR(arb_value(back.axis[0]), x, off);
    CHECK_NEAR(arb_value(back.axis[1]), y, off);
    CHECK(motors.axis[2] == tool.axis[2] && back.axis[2] == tool.axis[2]);
}

/* Limits that hold for both motors hold for the tool along x and along y. Lengths in the plane are
 * sqrt(2) times as long for the motors. */
static void corexy_motors_that_keep_a_limit_keep_it_for_the_tool(arb *a)
{
    const int32_t limit = 1 + (int32_t)arb_below(a, 16000);
    const loft_vec motors = arb_vec(a, limit);
    loft_vec tool;

    CHECK(loft_corexy_tool(NULL, motors, &tool));
    for (int i = 0; i < 2; i++)
        CHECK(fabs(arb_value(tool.axis[i])) <= limit);
    const double m = hypot(arb_value(motors.axis[0]), arb_value(motors.axis[1])),
                 t = hypot(arb_value(tool.axis[0]), arb_value(tool.axis[1]));
    CHECK_NEAR(m, sqrt(2) * t, BY_NUM(1.01 / 65536, 4e-3, 1e-10));
}


// Polar
// -----

static loft_polar arb_polar(arb *a)
{
    static const double usual[] = { 360, 6.283185307179586, 1, 400, 16383 };
    loft_polar p;

    p.turn = arb_below(a, 2) ? LOFT_REAL(usual[arb_below(a, 5)])
                             : loft_real_from_raw((int32_t)(65536 + arb_below(a, 16382u * 65536)));
    return p;
}

static loft_vec arb_place(arb *a) { return arb_vec(a, arb_below(a, 2) ? 16383 : 200); }

static void radius_and_angle_are_those_of_the_tool(arb *a)
{
    const loft_polar p = arb_polar(a);
    const loft_vec tool = arb_place(a), motors = loft_polar_motors(&p, tool);
    const long double x = exact_of(tool.axis[0]), y = exact_of(tool.axis[1]),
                      turn = exact_of(p.turn);
    const long double r = hypotl(x, y),
                      angle = (x == 0 && y == 0) ? 0 : atan2l(y, x) / (2 * PI) * turn;

    CHECK_EXACT(exact_of(motors.axis[0]), r, BY_NUM(LSB / 2, 0.51L, 2) * BY_NUM(1, ulp(r), ulp(r)));
    CHECK_EXACT(exact_of(motors.axis[1]), angle,
                BY_NUM(LSB / 2 + turn * 0x1p-33L, 0.51L * ulp(turn / 2), turn * 0x1p-49L));
    CHECK(motors.axis[2] == tool.axis[2]);
}

/* The angle may be any number of turns, and the radius below 0. */
static void a_radius_and_an_angle_are_one_place(arb *a)
{
    const loft_polar p = arb_polar(a);
    loft_vec motors = arb_place(a), tool;
    const long double r = exact_of(motors.axis[0]), turn = exact_of(p.turn),
                      angle = exact_of(motors.axis[1]) / turn * 2 * PI;
    const long double bound = BY_NUM(LSB / 2 + 0x1p-33L + fabsl(r) * 0x1p-56L,
                                     0.51L * ulp(fabsl(r)),
                                     fabsl(r) * 0x1p-48L * (fabsl(angle / PI) / 2 + 1));

    CHECK(loft_polar_tool(&p, motors, &tool));
    CHECK_EXACT(exact_of(tool.axis[0]), r * cosl(angle), bound);
    CHECK_EXACT(exact_of(tool.axis[1]), r * sinl(angle), bound);
    CHECK(tool.axis[2] == motors.axis[2]);
}

/* Half a unit of the angle moves the tool by radius pi / turn units. */
static void polar_there_and_back_is_where_it_was(arb *a)
{
    const loft_polar p = arb_polar(a);
    const loft_vec tool = arb_place(a), motors = loft_polar_motors(&p, tool);
    const long double r = exact_of(motors.axis[0]), turn = exact_of(p.turn),
                      arc = 2 * PI * r / turn;
    const long double grain = BY_NUM(LSB + 0x1p-30L + turn * 0x1p-31L, 0.51L * ulp(turn / 2),
                                     turn * 0x1p-49L);
    loft_vec back;

    CHECK(loft_polar_tool(&p, motors, &back));
    for (int i = 0; i < 2; i++)
        CHECK_EXACT(exact_of(back.axis[i]), exact_of(tool.axis[i]),
                    arc * grain + BY_NUM(1.2L * LSB, 1.1L * ulp(r), r * 0x1p-47L));
}

static void the_angle_follows_the_one_before(arb *a)
{
    const loft_polar p = arb_polar(a);
    const loft_vec tool = arb_place(a), motors = loft_polar_motors(&p, tool);
    loft_vec before = arb_vec(a, 16383), back;
    const long double turn = exact_of(p.turn), most = 16383 - turn / 2;

    if (fabsl(exact_of(before.axis[1])) > most)
        before.axis[1] = 0;
    const loft_vec near = loft_polar_near(&p, motors, before);
    const long double by = exact_of(near.axis[1]) - exact_of(motors.axis[1]), k = roundl(by / turn);
    const long double grain = BY_NUM(0, ulp(16383), 2 * ulp(16383));
    CHECK_EXACT(by, k * turn, grain);
    CHECK(fabsl(exact_of(near.axis[1]) - exact_of(before.axis[1])) <=
          turn / 2 + grain + BY_NUM(turn * LSB, 0, 0));
    CHECK(near.axis[0] == motors.axis[0] && near.axis[2] == motors.axis[2]);
    CHECK(loft_polar_tool(&p, near, &back));
}


// Delta
// -----

/* Any towers, with arms that reach. */
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
        const double dx = arb_value(tool.axis[0]) - arb_value(d.tower[i][0]),
                     dy = arb_value(tool.axis[1]) - arb_value(d.tower[i][1]);
        const double h = sqrt(arb_value(d.arm) * arb_value(d.arm) - dx * dx - dy * dy);
        CHECK_NEAR(arb_value(motors.axis[i]) - arb_value(tool.axis[2]), h,
                   BY_NUM(0.5001 / 65536, 2e-4, 1e-9));
    }
}

static void an_arm_that_does_not_reach_lies_flat(arb *a)
{
    const loft_delta d = { { { 0, 0 }, { 0, 0 }, { 0, 0 } }, LOFT_REAL(10) };
    loft_vec tool = arb_vec(a, 1);

    tool.axis[0] = LOFT_REAL(11);
    CHECK(loft_delta_motors(&d, tool).axis[0] == tool.axis[2]);
}

/* A typical machine: towers around the middle, a third of a turn apart (within 10 degrees), at 0.3
 * to 0.6 of the arm. */
static loft_delta arb_delta(arb *a, double *radius)
{
    const double arm = 100 + arb_below(a, 900), r = arm * (0.3 + arb_below(a, 300) / 1000.0),
                 turn = arb_below(a, 6283) / 1000.0;
    loft_delta d = { .arm = LOFT_REAL(arm) };

    for (int i = 0; i < 3; i++) {
        const double angle = turn + (i + arb_below(a, 100) / 1800.0) * 2.0943951;
        d.tower[i][0] = loft_real_from_raw((int32_t)(r * cos(angle) * 65536));
        d.tower[i][1] = loft_real_from_raw((int32_t)(r * sin(angle) * 65536));
    }
    *radius = r;
    return d;
}

static loft_vec arb_on_table(arb *a, double radius)
{
    const double r = radius * arb_below(a, 500) / 1000, angle = arb_below(a, 6283) / 1000.0;
    loft_vec tool = arb_vec(a, 500);

    tool.axis[0] = loft_real_from_raw((int32_t)(r * cos(angle) * 65536));
    tool.axis[1] = loft_real_from_raw((int32_t)(r * sin(angle) * 65536));
    return tool;
}

/* The point where the arms meet for carriages at m, by Newton's method from `at`, in long
 * double. */
static void meet(const loft_delta *d, const long double m[3], long double at[3])
{
    for (int round = 0; round < 12; round++) {
        long double row[3][4], by[3];
        for (int i = 0; i < 3; i++) {
            const long double p[3] = { at[0] - exact_of(d->tower[i][0]),
                                       at[1] - exact_of(d->tower[i][1]), at[2] - m[i] };
            row[i][3] = exact_of(d->arm) * exact_of(d->arm);
            for (int k = 0; k < 3; k++) {
                row[i][k] = 2 * p[k];
                row[i][3] -= p[k] * p[k];
            }
        }
        const long double det = row[0][0] * (row[1][1] * row[2][2] - row[1][2] * row[2][1]) -
                                row[0][1] * (row[1][0] * row[2][2] - row[1][2] * row[2][0]) +
                                row[0][2] * (row[1][0] * row[2][1] - row[1][1] * row[2][0]);
        for (int k = 0; k < 3; k++) {       /* Cramer */
            long double c[3][3];
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    c[i][j] = row[i][j == k ? 3 : j];
            by[k] = (c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) -
                     c[0][1] * (c[1][0] * c[2][2] - c[1][2] * c[2][0]) +
                     c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0])) /
                    det;
        }
        for (int k = 0; k < 3; k++)
            at[k] += by[k];
    }
}

static void the_tool_of_a_delta_is_where_its_arms_meet(arb *a)
{
    double radius;
    const loft_delta d = arb_delta(a, &radius);
    const loft_vec tool = arb_on_table(a, radius), motors = loft_delta_motors(&d, tool);
    const long double m[3] = { exact_of(motors.axis[0]), exact_of(motors.axis[1]),
                               exact_of(motors.axis[2]) };
    long double at[3] = { exact_of(tool.axis[0]), exact_of(tool.axis[1]), exact_of(tool.axis[2]) };
    loft_vec back;

    meet(&d, m, at);
    CHECK(loft_delta_tool(&d, motors, &back));
    for (int i = 0; i < 3; i++)
        CHECK_EXACT(
            exact_of(back.axis[i]), at[i],
            BY_NUM(LSB / 2 + LSB * 0x1p-14L, 0.51L * ulp(fabsl(at[i])) + 0x1p-38L, 0x1p-38L));
}

static void delta_there_and_back_is_where_it_was(arb *a)
{
    double radius;
    const loft_delta d = arb_delta(a, &radius);
    const loft_vec tool = arb_on_table(a, radius);
    loft_vec back;

    CHECK(loft_delta_tool(&d, loft_delta_motors(&d, tool), &back));
    for (int i = 0; i < 3; i++)
        CHECK_EXACT(exact_of(back.axis[i]), exact_of(tool.axis[i]),
                    2.5L * BY_NUM(LSB, ulp(2000), 0x1p-40L));
}

static void carriages_that_cannot_be_so_are_refused(arb *a)
{
    double radius;
    const loft_delta d = arb_delta(a, &radius);
    loft_vec motors = loft_delta_motors(&d, arb_on_table(a, radius)),
             back = { { LOFT_REAL(1), LOFT_REAL(2), LOFT_REAL(3) } };

    motors.axis[arb_below(a, 3)] += 3 * d.arm;
    CHECK(!loft_delta_tool(&d, motors, &back));
    CHECK(back.axis[0] == LOFT_REAL(1) && back.axis[1] == LOFT_REAL(2) &&
          back.axis[2] == LOFT_REAL(3));
    const loft_delta line = {
        { { 0, 0 }, { LOFT_REAL(10), LOFT_REAL(5) }, { LOFT_REAL(20), LOFT_REAL(10) } }, d.arm
    };
    CHECK(!loft_delta_tool(&line, (loft_vec){ { 0 } }, &back));
}

int main(void)
{
    PROPERTY(corexy_there_and_back_is_where_it_was,                20000);
    PROPERTY(corexy_motors_that_keep_a_limit_keep_it_for_the_tool, 20000);
    PROPERTY(radius_and_angle_are_those_of_the_tool,               20000);
    PROPERTY(a_radius_and_an_angle_are_one_place,                  20000);
    PROPERTY(polar_there_and_back_is_where_it_was,                 20000);
    PROPERTY(the_angle_follows_the_one_before,                     20000);
    PROPERTY(the_arms_of_a_delta_keep_their_length,                20000);
    PROPERTY(an_arm_that_does_not_reach_lies_flat,                   100);
    PROPERTY(the_tool_of_a_delta_is_where_its_arms_meet,           10000);
    PROPERTY(delta_there_and_back_is_where_it_was,                 10000);
    PROPERTY(carriages_that_cannot_be_so_are_refused,               1000);
    return check_failures();
}

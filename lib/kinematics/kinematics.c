/* lib/kinematics/kinematics.c
 * SPDX-License-Identifier: MIT
 */
#include "kinematics/kinematics.h"

#include "num/angle.h"  /* loft_fine_atan2, loft_fine_sin */
#include "num/sci.h"    /* loft_sci */

#if LOFT_AXES >= 2

/* a = x + y, b = x - y; x = (a + b) / 2, y = (a - b) / 2. The inverse is in acc, because a + b may
 * exceed a coordinate. */
loft_vec loft_corexy_motors(const void *geometry, loft_vec tool)
{
    const loft_real x = tool.axis[0], y = tool.axis[1];

    (void)geometry;
    tool.axis[0] = x + y;
    tool.axis[1] = x - y;
    return tool;
}

bool loft_corexy_tool(const void *geometry, loft_vec motors, loft_vec *tool)
{
    const loft_acc a = loft_to_acc(motors.axis[0]), b = loft_to_acc(motors.axis[1]);

    (void)geometry;
    *tool = motors;
    tool->axis[0] = loft_acc_round((a + b) / 2);
    tool->axis[1] = loft_acc_round((a - b) / 2);
    return true;
}

/* x^2 + y^2 <= 2^29 is exact in acc. The angle over a whole turn is at most 1/2 and errs by 2^-33.
 * That is multiplied by `turn`: turn 2^-33 mm, turn 2^-17 LSB. */
loft_vec loft_polar_motors(const void *geometry, loft_vec tool)
{
    const loft_polar *polar = (const loft_polar *)geometry;
    const loft_real x = tool.axis[0], y = tool.axis[1];
    const loft_fine angle = loft_fine_atan2(loft_to_acc(y), loft_to_acc(x));

    tool.axis[0] = loft_acc_sqrt(loft_prod(x, x) + loft_prod(y, y));
    tool.axis[1] = loft_acc_round(
        loft_acc_mul(loft_fine_quot(angle, 2 * LOFT_FINE_PI), polar->turn));
    return tool;
}

/* The number of whole turns between two angles, to nearest. */
static int32_t turns_of(loft_real by, loft_real turn)
{
    return loft_acc_int(loft_to_acc(loft_div(by, turn)));
}

loft_vec loft_polar_near(const void *geometry, loft_vec motors, loft_vec before)
{
    const loft_polar *polar = (const loft_polar *)geometry;
    const int32_t k = turns_of(before.axis[1] - motors.axis[1], polar->turn);

    motors.axis[1] = loft_acc_round(loft_to_acc(motors.axis[1]) + k * loft_to_acc(polar->turn));
    return motors;
}

/* Whole turns are removed first, exactly in q16 and f32. The rest is at most half a turn, plus the
 * rounding of the quotient. So the product with 2 pi is below 4. */
bool loft_polar_tool(const void *geometry, loft_vec motors, loft_vec *tool)
{
    const loft_polar *polar = (const loft_polar *)geometry;
    const loft_acc radius = loft_to_acc(motors.axis[0]), turn = loft_to_acc(polar->turn);
    const loft_acc rest = loft_to_acc(motors.axis[1]) -
                          turns_of(motors.axis[1], polar->turn) * turn;
    const loft_fine angle = loft_fine_mul(loft_fine_ratio(rest, turn), 2 * LOFT_FINE_PI);

    *tool = motors;
    tool->axis[0] = loft_acc_round(loft_fine_scale(radius, loft_fine_cos(angle)));
    tool->axis[1] = loft_acc_round(loft_fine_scale(radius, loft_fine_sin(angle)));
    return true;
}

#if LOFT_AXES >= 3

/* The carriage is above the joint by h, h^2 = arm^2 - dx^2 - dy^2. Products are exact in acc, below
 * 2^28 + 2 * 2^30. */
loft_vec loft_delta_motors(const void *geometry, loft_vec tool)
{
    const loft_delta *delta = (const loft_delta *)geometry;
    const loft_real x = tool.axis[0], y = tool.axis[1], z = tool.axis[2];

    for (int i = 0; i < 3; i++) {
        const loft_real dx = x - delta->tower[i][0], dy = y - delta->tower[i][1];
        const loft_acc left = loft_prod(delta->arm, delta->arm) - loft_prod(dx, dx) -
                              loft_prod(dy, dy);
        tool.axis[i] = z + (left > 0 ? loft_acc_sqrt(left) : 0);
    }
    return tool;
}

typedef struct {
    loft_sci c[3];
} arrow;

static arrow arrow_cross(arrow a, arrow b)
{
    arrow out;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out.c[i] = loft_sci_sub(loft_sci_mul(a.c[j], b.c[k]), loft_sci_mul(a.c[k], b.c[j]));
    }
    return out;
}

static loft_sci arrow_square(arrow a)
{
    return loft_sci_add(loft_sci_add(loft_sci_mul(a.c[0], a.c[0]), loft_sci_mul(a.c[1], a.c[1])),
                        loft_sci_mul(a.c[2], a.c[2]));
}

/* The vector from carriage 0 to carriage i. Differences of coordinates are exact in acc. */
static arrow carriage_side(const loft_delta *d, loft_vec motors, int i)
{
    arrow out;

    for (int k = 0; k < 2; k++)
        out.c[k] = loft_sci_of(loft_to_acc(d->tower[i][k]) - loft_to_acc(d->tower[0][k]));
    out.c[2] = loft_sci_of(loft_to_acc(motors.axis[i]) - loft_to_acc(motors.axis[0]));
    return out;
}

/* Seen from carriage 0, with b and c the vectors to the others and n = b x c, the centre and the
 * radius of the circle through the carriages are
 *
 *     m = (b^2 c x n + c^2 n x b) / (2 n^2)        r^2 = m^2
 *
 * The tool is at m -+ n sqrt((arm^2 - r^2) / n^2), with the sign of -n_z, because it is below. q16:
 * the vectors are exact. n is a difference of products and errs by 2^-60 of them. For triangles not
 * flatter than 1:8 that is 2^-57 of n. Each of the other 40 roundings is 2^-61 of a length below
 * 2^15 mm. The cancellation in arm^2 - r^2 loses no more than the steepness of the arm: in all
 * below 2^-30 mm. */
bool loft_delta_tool(const void *geometry, loft_vec motors, loft_vec *tool)
{
    const loft_delta *d = (const loft_delta *)geometry;
    const arrow b = carriage_side(d, motors, 1), c = carriage_side(d, motors, 2),
                n = arrow_cross(b, c), cn = arrow_cross(c, n), nb = arrow_cross(n, b);
    const loft_sci b2 = arrow_square(b), c2 = arrow_square(c), n2 = arrow_square(n),
                   arm = loft_sci_from_real(d->arm);
    const loft_real from[3] = { d->tower[0][0], d->tower[0][1], motors.axis[0] };
    loft_acc at[3];
    arrow m;

    if (loft_sci_sign(n.c[2]) == 0)
        return false;
    for (int i = 0; i < 3; i++)
        m.c[i] = loft_sci_div(loft_sci_add(loft_sci_mul(b2, cn.c[i]), loft_sci_mul(c2, nb.c[i])),
                              loft_sci_add(n2, n2));
    const loft_sci left = loft_sci_sub(loft_sci_mul(arm, arm), arrow_square(m));
    if (loft_sci_sign(left) < 0)
        return false;
    const loft_sci part = loft_sci_sqrt(loft_sci_div(left, n2)),
                   down = loft_sci_sign(n.c[2]) > 0 ? loft_sci_neg(part) : part;
    for (int i = 0; i < 3; i++) {
        if (!loft_sci_to_acc(loft_sci_add(m.c[i], loft_sci_mul(n.c[i], down)), &at[i]))
            return false;
        at[i] += loft_to_acc(from[i]);
        if (!loft_acc_valid(at[i]))
            return false;
    }
    for (int i = 0; i < 3; i++)
        tool->axis[i] = loft_acc_round(at[i]);
    return true;
}

#endif
#endif

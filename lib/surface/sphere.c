/* lib/surface/sphere.c
 * SPDX-License-Identifier: MIT
 */
#include "surface/sphere.h"
#include "num/angle.h"          /* loft_fine: sines */
#include "num/explog.h"         /* loft_sci_from_fine */
#include "geom/vec_exact.h"     /* loft_exact: distances */

#define ANGLE_MAX LOFT_REAL(32767)


/* By angles. An angle is k quarters and a remainder of at most 45 degrees, up to the rounding of a
 * quotient. They are separated without rounding. The remainder in radians is off by 2^-59. So its
 * sine and cosine are off by 2^-57 in q16, and a product of two of them by 2^-56. Times a radius
 * below 2^15 this is 2^-41, plus 2^-33 from rounding to a wide value: 2^-17 LSB, a third of the
 * stated error. Floats have 2^-52 in place of 2^-57. */
typedef struct {
    loft_fine sin, cos;
} turn;

static turn turn_of(loft_real degrees)
{
    const int32_t k = loft_real_floor(loft_div(degrees, LOFT_REAL(90)) + LOFT_REAL(0.5));
    const loft_acc rest = loft_to_acc(degrees) - k * loft_to_acc(LOFT_REAL(90));
    const loft_fine angle = loft_fine_mul(loft_fine_ratio(rest, loft_to_acc(LOFT_REAL(180))),
                                          LOFT_FINE_PI);
    const loft_fine s = loft_fine_sin(angle), c = loft_fine_cos(angle);
    turn t = { s, c };

    switch (k & 3) {
    case 1:
        t.sin = c;
        t.cos = -s;
        break;
    case 2:
        t.sin = -s;
        t.cos = -c;
        break;
    case 3:
        t.sin = -c;
        t.cos = s;
        break;
    default: break;
    }
    return t;
}

static bool angles_valid(const loft_sphere *s, loft_real theta, loft_real phi)
{
    return s->radius >= 0 && theta >= -ANGLE_MAX && theta <= ANGLE_MAX && phi >= -ANGLE_MAX &&
           phi <= ANGLE_MAX;
}

static void direction_of(loft_real theta, loft_real phi, loft_fine n[3])
{
    const turn longitude = turn_of(theta), colatitude = turn_of(phi);

    n[0] = loft_fine_mul(longitude.cos, colatitude.sin);
    n[1] = loft_fine_mul(longitude.sin, colatitude.sin);
    n[2] = colatitude.cos;
}

enum loft_status loft_sphere_eval(const loft_sphere *s, loft_real theta, loft_real phi,
                                  loft_vec *out)
{
    loft_acc x[LOFT_AXES];
    loft_fine n[3];

    if (!angles_valid(s, theta, phi))
        return LOFT_ERR_ARG;
    direction_of(theta, phi, n);
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = loft_to_acc(s->centre.axis[i]) +
               (i < 3 ? loft_fine_scale(loft_to_acc(s->radius), n[i < 3 ? i : 0]) : 0);
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_sphere_normal(const loft_sphere *s, loft_real theta, loft_real phi,
                                    loft_vec *out)
{
    loft_fine n[3];

    if (!angles_valid(s, theta, phi))
        return LOFT_ERR_ARG;
    direction_of(theta, phi, n);
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = i < 3 ? loft_acc_round(loft_fine_to_acc(n[i < 3 ? i : 0])) : 0;
    return LOFT_OK;
}

/* With t theta, f phi: P = r (cos t sin f, sin t sin f, cos f). */
enum loft_status loft_sphere_differential(const loft_sphere *s, loft_real theta, loft_real phi,
                                          loft_differential *out)
{
    if (!angles_valid(s, theta, phi))
        return LOFT_ERR_ARG;
    const turn t = turn_of(theta), f = turn_of(phi);
    const loft_sci r = loft_sci_from_real(s->radius), ct = loft_sci_from_fine(t.cos),
                   st = loft_sci_from_fine(t.sin), rc = loft_sci_mul(r, loft_sci_from_fine(f.cos)),
                   rs = loft_sci_mul(r, loft_sci_from_fine(f.sin));
    loft_differential made = { .width_u = r, .width_v = r };
    const loft_sci by[5][3] = {
        { loft_sci_mul(rc, ct), loft_sci_mul(rc, st), loft_sci_neg(rs) },
        { loft_sci_neg(loft_sci_mul(rs, st)), loft_sci_mul(rs, ct), loft_sci_zero() },
        { loft_sci_neg(loft_sci_mul(rs, ct)), loft_sci_neg(loft_sci_mul(rs, st)),
          loft_sci_neg(rc) },
        { loft_sci_neg(loft_sci_mul(rc, st)), loft_sci_mul(rc, ct), loft_sci_zero() },
        { loft_sci_neg(loft_sci_mul(rs, ct)), loft_sci_neg(loft_sci_mul(rs, st)), loft_sci_zero() },
    };
    loft_sci *const to[5] = { made.u, made.v, made.uu, made.uv, made.vv };

    for (int k = 0; k < 5; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            to[k][i] = i < 3 ? by[k][i < 3 ? i : 0] : loft_sci_zero();
    *out = made;
    return LOFT_OK;
}


/* By whole numbers, which carry 2^E, E = LOFT_EXACT_REAL. The distance from the centre carries
 * 2^(E + LOFT_EXACT_HYPOT). Differences have R + 1 bits, three squares 2 R + 4, the root 130 more:
 * 196 and 390 bits. */

static bool arm_of(const loft_sphere *s, const loft_vec *x, loft_exact arm[3])
{
    if (!loft_vec_exact_valid(&s->centre, 1, 3) || !loft_vec_exact_valid(x, 1, 3))
        return false;
    loft_vec_exact_sub(x, &s->centre, 3, arm);
    return loft_exact_valid(s->radius);
}

enum loft_status loft_sphere_distance(const loft_sphere *s, loft_vec x, loft_real *out)
{
    loft_exact arm[3];

    if (!(s->radius >= 0))
        return LOFT_ERR_ARG;
    if (!arm_of(s, &x, arm))
        return LOFT_ERR_RANGE;
    const loft_exact radius = loft_exact_shift(loft_exact_from_real(s->radius), LOFT_EXACT_HYPOT);
    const loft_exact gap = loft_exact_sub(loft_exact_hypot(arm, 3), radius);
    const int shift = -LOFT_EXACT_REAL - LOFT_EXACT_HYPOT;
    return loft_exact_quot_real(gap, loft_exact_from_int(1), shift, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_sphere_value(const loft_sphere *s, loft_vec x, loft_real *out)
{
    loft_exact arm[3];

    if (!(s->radius >= 0))
        return LOFT_ERR_ARG;
    if (!arm_of(s, &x, arm))
        return LOFT_ERR_RANGE;
    const loft_exact radius = loft_exact_from_real(s->radius);
    const loft_exact square = loft_vec_exact_dot(arm, arm, 3);
    const loft_exact sum = loft_exact_sub(square, loft_exact_mul(radius, radius));
    return loft_exact_quot_real(sum, loft_exact_from_int(1), -2 * LOFT_EXACT_REAL, out)
               ? LOFT_OK
               : LOFT_ERR_RANGE;
}

enum loft_status loft_sphere_direction(const loft_sphere *s, loft_vec x, loft_vec *out)
{
    const loft_vec nothing = { { 0 } };
    loft_exact arm[3];

    if (!(s->radius >= 0))
        return LOFT_ERR_ARG;
    if (!arm_of(s, &x, arm))
        return LOFT_ERR_RANGE;
    if (loft_exact_sign(arm[0]) == 0 && loft_exact_sign(arm[1]) == 0 &&
        loft_exact_sign(arm[2]) == 0)
        return LOFT_SINGULAR;
    const loft_exact length = loft_exact_hypot(arm, 3);
    *out = nothing;
    for (int i = 0; i < 3 && i < LOFT_AXES; i++)
        if (!loft_exact_quot_real(arm[i], length, LOFT_EXACT_HYPOT, &out->axis[i]))
            return LOFT_ERR_RANGE;      /* never: it is at most 1 */
    return LOFT_OK;
}

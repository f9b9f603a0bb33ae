/* lib/motion/limits.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/limits.h"

#define BEATS_HZ     500    /* a beat lasts at most 2 ms, or one tick                          */
#define SPARE        32     /* 1/32 of the acceleration is kept for smooth joints              */
#define TOL_MIN      LOFT_REAL(0.0009765625)
#define TOL_MAX      LOFT_REAL(1)
#define CORNER_MAX   LOFT_REAL(1)
#define SPACING_MAX  LOFT_REAL(1)

static enum loft_status within(loft_real x, loft_real min, loft_real max)
{
    return !(x > 0) ? LOFT_ERR_ARG : x < min || x > max ? LOFT_ERR_RANGE : LOFT_OK;
}

enum loft_status loft_limits_check(const loft_limits *limits)
{
    enum loft_status status = within(limits->tol, TOL_MIN, TOL_MAX);

    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        status = within(limits->max_speed[i], LOFT_SPEED_MIN, LOFT_SPEED_MAX);
        if (status == LOFT_OK)
            status = within(limits->max_accel[i], LOFT_ACCEL_MIN, LOFT_ACCEL_MAX);
    }
    if (status != LOFT_OK)
        return status;
    if (!(limits->corner >= 0) || limits->tick_hz == 0)
        return LOFT_ERR_ARG;
    return limits->corner > CORNER_MAX || limits->tick_hz < 50 || limits->tick_hz > 50000u ? LOFT_ERR_RANGE : LOFT_OK;
}

/* The plan samples the path at beats of T seconds and draws a uniform quadratic B-spline with those samples as
 * control points. Its acceleration is their second difference over T^2, which is the true acceleration
 * averaged over two beats with triangular weights: limits per axis, being convex, are held by an average
 * when they are held by what is averaged. The price is a distance from the path of |acceleration| T^2 / 8 along
 * bends and of |jump of velocity| T / 4 at corners (worst when the corner falls between two samples). Each may
 * use half the tolerance:
 *
 *     A T^2 <= 4 tol      with A the length of the vector of the limits of all axes
 *     J T   <= 2 tol
 *
 * The first gives the longest beat. If not even one tick is short enough, A is reduced.
 *
 * In q16, T = n / hz: A n^2 / hz <= 4 tol hz has no term above 40000 * 100 * 2 or 4 * 50000. */
static loft_unit set_beat(loft_budget *b, const loft_limits *limits)
{
    loft_acc size[LOFT_AXES];
    for (int i = 0; i < LOFT_AXES; i++)
        size[i] = loft_wide(limits->max_accel[i]);

    const loft_acc a = loft_acc_ratio(loft_acc_hypot(size, LOFT_AXES), limits->tick_hz);
    const loft_acc most = loft_wide(limits->tol) * 4 * limits->tick_hz;

    uint16_t n = (uint16_t)(limits->tick_hz / BEATS_HZ);
    while (n > 1 && a * n * n > most)
        n--;
    b->beat = n > 1 ? n : 1;
    return a > most ? loft_unit_ratio(most, a) : LOFT_UNIT(1);
}

void loft_budget_init(loft_budget *b, const loft_limits *limits)
{
    b->tick_hz = limits->tick_hz;
    const loft_unit usable = set_beat(b, limits);

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc accel = loft_acc_scale(loft_wide(limits->max_accel[i]), usable);
        b->max_speed[i] = limits->max_speed[i];
        b->accel[i] = loft_acc_round(accel - loft_acc_ratio(accel, SPARE));
        b->spare[i] = loft_acc_round(loft_acc_ratio(accel * b->beat, (int32_t)b->tick_hz * SPARE));
    }
    const loft_acc swing = loft_acc_ratio(loft_wide(limits->tol) * 2 * b->tick_hz, b->beat);
    b->swing  = swing < loft_wide(LOFT_SPEED_MAX) ? loft_acc_round(swing) : LOFT_SPEED_MAX;
    b->corner = limits->corner;
    b->tol    = limits->tol;
}

loft_acc loft_budget_beat(const loft_budget *b, loft_real v)
{
    return loft_acc_ratio(loft_wide(v) * b->beat, b->tick_hz);
}

/* Where the direction jumps by d = after - before, the velocity v jumps by v d. Averaged over a beat T that is
 * an acceleration of v d / T, and where jumps follow each other at a distance s, of v^2 d / s. What is kept in
 * reserve (accel / 32, spare = accel T / 32) pays for it while, per axis,
 *
 *     v <= spare / d          v^2 <= (accel / 32) s / d
 *
 * A machine that allows a junction deviation c (as grbl does) may pass faster: as on the arc that touches both
 * directions and passes c from the corner. With q = |d| / 2 = sin(turn / 2), s = cos(turn / 2),
 *
 *     v^2 = accel c s / (1 - s) = accel c s (1 + s) / q^2
 *
 * but not so fast that the rounding of the corner exceeds its half of the tolerance, v |d| <= swing, nor so
 * that dense corners bend the path more than `accel` allows, v^2 <= accel s / d. accel is that of the direction d.
 *
 * q16: |d_i| <= 2, squares below 2^28, accel * spacing <= 2^14 as the spacing counts up to 1 mm. */
static loft_real junction_speed(const loft_budget *b, const loft_real jump[], loft_acc turn)
{
    const loft_real whole = loft_acc_round(turn);
    loft_real accel = LOFT_ACCEL_MAX;

    for (int i = 0; i < LOFT_AXES; i++)
        accel = loft_real_cap(accel, loft_acc_round(loft_acc_mul(turn, b->accel[i])), jump[i]);

    const loft_real s    = loft_acc_sqrt(loft_wide(LOFT_REAL(1)) - loft_prod(whole, whole) / 4);
    const loft_acc  top  = loft_acc_mul(loft_prod(accel, b->corner), s);
    const loft_real root = loft_acc_sqrt(top + loft_acc_mul(top, s));

    return loft_real_cap(loft_real_cap(LOFT_SPEED_MAX, 2 * root, whole), b->swing, whole);
}

/* v^2 or accel * spacing / jump, whichever is less; q16: the product is below 2^29, the dividend 2^14 */
static loft_acc dense_cap(loft_acc speed2, loft_acc accel, loft_real spacing, loft_real jump)
{
    const loft_acc most = loft_acc_mul(accel, spacing);
    return loft_acc_mul(speed2, jump) > most ? loft_acc_div(most, jump) : speed2;
}

loft_acc loft_budget_joint(const loft_budget *b, loft_vec before, loft_vec after, loft_acc spacing)
{
    const loft_real apart = spacing < loft_wide(SPACING_MAX) ? loft_acc_round(spacing) : SPACING_MAX;
    loft_real jump[LOFT_AXES], v = LOFT_SPEED_MAX;

    for (int i = 0; i < LOFT_AXES; i++) {
        jump[i] = after.axis[i] - before.axis[i];
        jump[i] = jump[i] < 0 ? -jump[i] : jump[i];
        v = loft_real_cap(v, b->spare[i], jump[i]);
    }
    const loft_real w = junction_speed(b, jump, loft_vec_distance(before, after));
    loft_acc smooth = loft_prod(v, v), corner = loft_prod(w, w);

    for (int i = 0; i < LOFT_AXES; i++) {
        smooth = dense_cap(smooth, loft_acc_ratio(loft_wide(b->accel[i]), SPARE), apart, jump[i]);
        corner = dense_cap(corner, loft_wide(b->accel[i]), apart, jump[i]);
    }
    return smooth > corner ? smooth : corner;
}

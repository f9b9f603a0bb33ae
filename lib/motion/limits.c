/* lib/motion/limits.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/limits.h"

#define SLOW_HZ      125    /* 8 ms where jerk is limited */
/* 1/64 of the acceleration may be used by smooth joints, half of it is kept for them */
#define SPARE        64
#define TOL_MIN      LOFT_REAL(0.0009765625)
#define TOL_MAX      LOFT_REAL(1)
#define CORNER_MAX   LOFT_REAL(1)
#define SPACING_MAX  LOFT_REAL(1)

/* What bends and corners may use of the tolerance (set_beat), in 18ths of it */
#define BEND         (LOFT_PLAN_WINDOW > 4 ? 45 : 78)
#define SWING        (LOFT_PLAN_WINDOW > 4 ? 27 : 15)

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
        if (status == LOFT_OK && limits->max_jerk[i] > (LOFT_PLAN_FILTER > 1 ? LOFT_JERK_MAX : 0))
            status = LOFT_ERR_RANGE;
    }
    if (status != LOFT_OK)
        return status;
    if (!(limits->corner >= 0) || !(limits->max_across >= 0) || limits->tick_hz == 0)
        return LOFT_ERR_ARG;
    if (limits->max_across > LOFT_ACCEL_MAX ||
        (limits->max_across > 0 && limits->max_across < LOFT_ACCEL_MIN))
        return LOFT_ERR_RANGE;
    return limits->corner > CORNER_MAX || limits->tick_hz < 50 || limits->tick_hz > 50000u
               ? LOFT_ERR_RANGE
               : LOFT_OK;
}

/* The plan samples the path at beats of h seconds and draws a uniform cubic B-spline with those
 * samples as control points. Its velocity, acceleration and jerk are differences of the samples,
 * averages of the path's with positive weights: limits per axis, being convex, are held by an
 * average when they are held by what is averaged. The price is a distance from the path of
 * |acceleration| h^2 / 6 along bends and of |jump of velocity| h 13 / 48 at corners (worst when the
 * corner falls between two samples):
 *
 *     A h^2 <= 5/2 tol, jump h <= 3/2 tol     5/12 and 13/32 of the tolerance; 1/8 is for longer
 *                                             spans
 *     A h^2 <= 13/3 tol, jump h <= 5/6 tol    where every beat is a span: 13/18 and 65/288
 *     A h^2 <= 3 tol                          where jerk is limited: corners are all but stops;
 *                                             half of it, 3/8 for easing joints
 *
 * with A the length of the vector of the limits of all axes, and what is allowed across the path
 * besides. That gives the longest beat. If not even one tick is short enough, A is reduced
 * (most_of_axis). In q16, h = n / hz: A n^2 / hz <= 3 tol hz has no term above 60000 * 400 * 2. */
static loft_unit set_beat(loft_budget *b, const loft_limits *limits)
{
    loft_acc size[LOFT_AXES];
    for (int i = 0; i < LOFT_AXES; i++)
        size[i] = loft_to_acc(limits->max_accel[i]);

    const loft_acc a = loft_acc_ratio(
        loft_acc_hypot(size, LOFT_AXES) + loft_to_acc(limits->max_across), limits->tick_hz);
    const loft_acc most = loft_acc_ratio(
        loft_to_acc(limits->tol) * (int32_t)(LOFT_BUDGET_JERK(b) ? 54 : BEND) * limits->tick_hz,
        18);

    uint16_t n = (uint16_t)(limits->tick_hz / (LOFT_BUDGET_JERK(b) ? SLOW_HZ : LOFT_PLAN_BEATS));
    while (n > 1 && a * n * n > most)
        n--;
    b->beat  = n > 1 ? n : 1;
    b->pulse = loft_unit_of(b->beat, b->tick_hz);
    return a > most ? loft_unit_ratio(most, a) : LOFT_UNIT(1);
}

/* The change of acceleration in a beat, J h, at most `accel`; the beats that `accel` takes at that
 * pace. */
static void set_gain(loft_budget *b, int i, uint32_t jerk)
{
    const loft_acc accel = loft_to_acc(b->accel[i]);
    const loft_acc gain = loft_acc_ratio(loft_to_acc(LOFT_REAL(1)) * b->beat, b->tick_hz) *
                          (int32_t)jerk;
    unsigned n = 1;

    b->gain[i] = jerk == 0 || gain > accel ? b->accel[i] : loft_acc_round(gain);
    while (n < LOFT_PLAN_FILTER && (int32_t)n * loft_to_acc(b->gain[i]) < accel)
        n++;
    b->filter = (uint8_t)(n > b->filter ? n : b->filter);
}

/* Joints of a smooth path: their jumps of direction are of the size of rounding, or of the chords
 * of a polyline. One may use half of what is kept for them, those that follow each other the other
 * half. Kept are 1/64 of the acceleration or 4/5 of the jerk. */
static void set_shares(loft_budget *b, int i)
{
    const loft_acc part = LOFT_BUDGET_JERK(b) ? loft_acc_ratio(loft_to_acc(b->gain[i]), 5)
                                              : loft_acc_ratio(loft_to_acc(b->accel[i]), SPARE);

    b->share[i] = loft_acc_round(part);
    b->spare[i] = loft_acc_round(loft_acc_scale(LOFT_BUDGET_JERK(b) ? 2 * part : part, b->pulse));
}

/* Where A is reduced: the acceleration that no axis may exceed, so that the length of the vector of
 * all is the part `usable` of what it was: slower axes lose nothing. Where every beat is a span (a
 * small chip) all are reduced alike. */
static loft_real most_of_axis(const loft_limits *limits, loft_unit usable)
{
    loft_acc size[LOFT_AXES];
    loft_real most = LOFT_ACCEL_MAX;

    if (LOFT_PLAN_WINDOW == 4 || !(usable < LOFT_UNIT(1)))
        return most;
    for (int i = 0; i < LOFT_AXES; i++)
        size[i] = loft_to_acc(limits->max_accel[i]);
    const loft_acc whole = loft_acc_scale(loft_acc_hypot(size, LOFT_AXES), usable);
    most = 0;
    for (loft_real step = LOFT_ACCEL_MAX / 2; step > LOFT_REAL(0.01); step /= 2) {
        for (int i = 0; i < LOFT_AXES; i++)
            size[i] = loft_to_acc(limits->max_accel[i] < most + step ? limits->max_accel[i]
                                                                     : most + step);
        most += loft_acc_hypot(size, LOFT_AXES) > whole ? 0 : step;
    }
    return most;
}

void loft_budget_init(loft_budget *b, const loft_limits *limits)
{
    b->tick_hz = limits->tick_hz;
    b->filter  = 1;
    b->jerk    = false;
    for (int i = 0; i < LOFT_AXES; i++)
        b->jerk = b->jerk || limits->max_jerk[i] > 0;
    const loft_unit usable = set_beat(b, limits);
    const loft_real most = most_of_axis(limits, usable);

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real held = limits->max_accel[i] < most ? limits->max_accel[i] : most;
        const loft_acc accel = LOFT_PLAN_WINDOW == 4
                                   ? loft_acc_scale(loft_to_acc(limits->max_accel[i]), usable)
                                   : loft_to_acc(held);
        b->max_speed[i] = limits->max_speed[i];
        b->accel[i] = loft_acc_round(
            LOFT_BUDGET_JERK(b) ? accel : accel - loft_acc_ratio(accel, 2 * SPARE));
        if (LOFT_PLAN_FILTER > 1)
            set_gain(b, i, limits->max_jerk[i]);
        set_shares(b, i);
    }
    const loft_acc swing = loft_acc_ratio(loft_to_acc(limits->tol) * SWING * b->tick_hz,
                                          18 * (int32_t)b->beat);
    b->swing  = swing < loft_to_acc(LOFT_SPEED_MAX) ? loft_acc_round(swing) : LOFT_SPEED_MAX;
    b->corner = limits->corner;
    b->tol    = limits->tol;
    b->across = loft_acc_round(loft_acc_scale(loft_to_acc(limits->max_across), usable));
}

loft_acc loft_budget_beat(const loft_budget *b, loft_real v)
{
    return loft_acc_scale(loft_to_acc(v), b->pulse);
}

/* Where the direction jumps by d = after - before, the velocity v jumps by v d. Averaged over a
 * beat h that is an acceleration of v d / h, and where jumps follow each other at a distance s, of
 * v^2 d / s. What is kept for joints pays for it while, per axis,
 *
 *     v <= spare / d          v^2 <= share s / d
 *
 * A machine whose jerk is not limited and that allows a junction deviation c (as grbl does) may
 * pass faster: as on the arc that touches both directions and passes c from the corner. With q =
 * |d| / 2 = sin(turn / 2), s = cos(turn / 2),
 *
 *     v^2 = accel c s / (1 - s) = accel c s (1 + s) / q^2
 *
 * but not so fast that the rounding of the corner exceeds its part of the tolerance, v |d| <=
 * swing, nor so that dense corners bend the path more than `accel` allows, v^2 <= accel s / d.
 * accel is that of the direction d; where acceleration across the path has a limit of its own,
 * dense corners are a bend, v^2 <= across s / |d|.
 *
 * q16: |d_i| <= 2, squares below 2^28, accel * spacing <= 2^14 as the spacing counts up to 1 mm. */
static loft_real junction_speed(const loft_budget *b, const loft_real jump[], loft_acc turn)
{
    const loft_real whole = loft_acc_round(turn);
    loft_real accel = LOFT_ACCEL_MAX;

    for (int i = 0; i < LOFT_AXES; i++)
        accel = loft_real_cap(accel, loft_acc_round(loft_acc_mul(turn, b->accel[i])), jump[i]);

    const loft_real s    = loft_acc_sqrt(loft_to_acc(LOFT_REAL(1)) - loft_prod(whole, whole) / 4);
    const loft_acc  top  = loft_acc_mul(loft_prod(accel, b->corner), s);
    const loft_real root = loft_acc_sqrt(top + loft_acc_mul(top, s));

    return loft_real_cap(loft_real_cap(LOFT_SPEED_MAX, 2 * root, whole), b->swing, whole);
}

/* v^2 becomes accel * spacing / jump if that is less; q16: the product is below 2^29, the dividend
 * 2^14 */
static void set_dense(loft_acc *speed2, loft_real accel, loft_real spacing, loft_real jump)
{
    const loft_acc most = loft_acc_mul(loft_to_acc(accel), spacing);

    if (loft_acc_mul(*speed2, jump) > most)
        *speed2 = loft_acc_div(most, jump);
}

loft_acc loft_budget_joint(const loft_budget *b, const loft_vec *before, const loft_vec *after,
                           loft_acc spacing, bool corner)
{
    const loft_real apart = spacing < loft_to_acc(SPACING_MAX) ? loft_acc_round(spacing)
                                                               : SPACING_MAX;
    loft_real jump[LOFT_AXES], v = LOFT_SPEED_MAX;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real turn = after->axis[i] - before->axis[i];
        jump[i] = loft_real_abs(turn);
        v = loft_real_cap(v, b->spare[i], jump[i]);
    }
    const loft_acc  turn = loft_vec_distance(*before, *after);
    const loft_real w = corner ? junction_speed(b, jump, turn) : 0;
    loft_acc smooth = loft_prod(v, v), sharp = loft_prod(w, w);

    for (int i = 0; i < LOFT_AXES; i++) {
        set_dense(&smooth, b->share[i], apart, jump[i]);
        if (b->across > 0)
            set_dense(&sharp, b->across, apart, loft_acc_round(turn));
        else
            set_dense(&sharp, b->accel[i], apart, jump[i]);
    }
    return LOFT_BUDGET_JERK(b) ? smooth : loft_acc_max(smooth, sharp);
}

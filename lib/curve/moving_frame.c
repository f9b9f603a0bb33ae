/* lib/curve/moving_frame.c
 * SPDX-License-Identifier: MIT
 *
 * A reflection in the plane with the normal n takes x to x - 2 (n x) / (n n) n. The first one, with
 * n the chord, takes the frame r, t at the last place to r', t' at the next one. The second one,
 * with n = t1 - t', takes t' to the tangent t1 there, and r' to the new r. Two reflections are a
 * rotation.
 *
 * The normal of the second one is at least 1 long if both tangents are within 60 degrees of the
 * chord: t' then points back. In general it errs by 2^-57 over its length, at least 2^-16; then the
 * part of r along t1 is taken out, so the frame stays at right angles.
 */
#include "curve/moving_frame.h"

#define LEAST_TURN (-16)        /* log2 of the shortest normal of a reflection of directions */
#define LEAST_SINE (-20)

static loft_sci frame_dot(const loft_sci a[3], const loft_sci b[3])
{
    return loft_sci_add(loft_sci_add(loft_sci_mul(a[0], b[0]), loft_sci_mul(a[1], b[1])),
                        loft_sci_mul(a[2], b[2]));
}

static void frame_cross(const loft_sci a[3], const loft_sci b[3], loft_sci out[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = loft_sci_sub(loft_sci_mul(a[j], b[k]), loft_sci_mul(a[k], b[j]));
    }
}

/* x / |x|, if x is longer than `least`. */
static bool frame_unit(loft_sci x[3], loft_sci least)
{
    const loft_sci length = loft_sci_sqrt(frame_dot(x, x));

    if (!loft_sci_less(least, length))
        return false;
    for (int i = 0; i < 3; i++)
        x[i] = loft_sci_div(x[i], length);
    return true;
}

static bool frame_direction(loft_vec v, loft_sci out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = loft_sci_from_real(loft_vec_axis(&v, i));
    return frame_unit(out, loft_sci_zero());
}

/* x - scale (n x) n */
static void take_part(loft_sci x[3], const loft_sci n[3], loft_sci scale)
{
    const loft_sci part = loft_sci_mul(scale, frame_dot(n, x));

    for (int i = 0; i < 3; i++)
        x[i] = loft_sci_sub(x[i], loft_sci_mul(part, n[i]));
}

enum loft_status loft_moving_frame_start(loft_moving_frame *f, loft_vec at, loft_vec tangent,
                                         loft_vec up)
{
    loft_moving_frame made = { .at = at };

    if (LOFT_AXES < 3)
        return LOFT_ERR_ARG;
    if (!frame_direction(tangent, made.along) || !frame_direction(up, made.across))
        return LOFT_SINGULAR;
    take_part(made.across, made.along, loft_sci_one());
    if (!frame_unit(made.across, loft_sci_power2(LEAST_SINE)))
        return LOFT_SINGULAR;
    *f = made;
    return LOFT_OK;
}

/* The chord as a unit vector; false if the places are one. */
static bool chord_between(loft_vec from, loft_vec to, loft_sci out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = loft_sci_sub(loft_sci_from_real(loft_vec_axis(&to, i)),
                              loft_sci_from_real(loft_vec_axis(&from, i)));
    return frame_unit(out, loft_sci_zero());
}

/* With the places in one, the normal of the first reflection is the old tangent: t' = -t. */
enum loft_status loft_moving_frame_move(loft_moving_frame *f, loft_vec at, loft_vec tangent)
{
    const loft_sci two = loft_sci_from_int(2);
    loft_moving_frame to = *f;
    loft_sci chord[3], turn[3];

    to.at = at;
    if (!frame_direction(tangent, to.along))
        return LOFT_SINGULAR;
    if (!chord_between(f->at, at, chord))
        for (int i = 0; i < 3; i++)
            chord[i] = f->along[i];
    loft_sci mirrored[3] = { f->along[0], f->along[1], f->along[2] };
    take_part(mirrored, chord, two);
    take_part(to.across, chord, two);
    for (int i = 0; i < 3; i++)
        turn[i] = loft_sci_sub(to.along[i], mirrored[i]);
    if (!frame_unit(turn, loft_sci_power2(LEAST_TURN)))
        return LOFT_SINGULAR;
    take_part(to.across, turn, two);
    take_part(to.across, to.along, loft_sci_one());
    if (!frame_unit(to.across, loft_sci_power2(-1)))
        return LOFT_SINGULAR;
    *f = to;
    return LOFT_OK;
}

enum loft_status loft_moving_frame_point(const loft_moving_frame *f, loft_vec p, loft_vec *out)
{
    loft_sci beside[3], x[3];
    loft_acc sum[LOFT_AXES];

    for (int i = 0; i < 3; i++)
        x[i] = loft_sci_from_real(loft_vec_axis(&p, i));
    frame_cross(f->along, f->across, beside);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_sci s = loft_sci_from_real(f->at.axis[i]);
        if (i < 3) {
            s = loft_sci_add(s, loft_sci_mul(x[0], f->across[i]));
            s = loft_sci_add(s, loft_sci_mul(x[1], beside[i]));
            s = loft_sci_add(s, loft_sci_mul(x[2], f->along[i]));
        }
        if (!loft_sci_to_acc(s, &sum[i]))
            return LOFT_ERR_RANGE;
    }
    return loft_vec_round(sum, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

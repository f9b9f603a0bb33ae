/* lib/curve/tcb.c
 * SPDX-License-Identifier: MIT
 *
 * Parameters have 26 bits in q16, so a factor of three of them has 2^-59 of error in num/sci.h. A
 * factor is at most 27 / 2, a chord below 2^16, so a tangent is below 2^20.8: within the range of
 * loft_ends3_deriv (2^21). It is rounded to 2^-33, and the curve takes at most t (1 - t)^2 and
 * t^2 (1 - t) of the two.
 */
#include "curve/tcb.h"
#include "basis/interp.h"       /* loft_ends3_deriv */
#include "num/sci.h"            /* loft_sci: the factors */

static bool knob_valid(loft_unit x) { return x >= LOFT_UNIT(-2) && x <= LOFT_UNIT(2); }

static bool tcb_valid(const loft_tcb *k)
{
    return knob_valid(k->tension) && knob_valid(k->continuity) && knob_valid(k->bias);
}

static enum loft_status check_segment(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2)
{
    if (!tcb_valid(k1) || !tcb_valid(k2))
        return LOFT_ERR_ARG;
    for (int i = 0; i < 4; i++)
        if (!loft_vec_valid(p[i]))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

/* (1 - t) (1 + sign_c c) (1 + sign_b b) / 2 */
static loft_sci chord_factor(const loft_tcb *k, int sign_c, int sign_b)
{
    const loft_sci one = loft_sci_one(), t = loft_sci_from_unit(k->tension);
    const loft_sci c = loft_sci_from_unit(k->continuity), b = loft_sci_from_unit(k->bias);
    const loft_sci by_c = sign_c > 0 ? loft_sci_add(one, c) : loft_sci_sub(one, c),
                   by_b = sign_b > 0 ? loft_sci_add(one, b) : loft_sci_sub(one, b);

    return loft_sci_div(loft_sci_mul(loft_sci_sub(one, t), loft_sci_mul(by_c, by_b)),
                        loft_sci_from_int(2));
}

static loft_sci chord_of(const loft_vec *p, int axis)
{
    return loft_sci_sub(loft_sci_from_real(p[1].axis[axis]), loft_sci_from_real(p[0].axis[axis]));
}

/* The ends of the Hermite cubic of one axis; false if a tangent does not fit. */
static bool segment_ends(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2, int axis,
                         loft_acc e[4])
{
    const loft_sci middle = chord_of(p + 1, axis);
    const loft_sci t1 = loft_sci_add(loft_sci_mul(chord_factor(k1, 1, 1), chord_of(p, axis)),
                                     loft_sci_mul(chord_factor(k1, -1, -1), middle));
    const loft_sci t2 = loft_sci_add(loft_sci_mul(chord_factor(k2, -1, 1), middle),
                                     loft_sci_mul(chord_factor(k2, 1, -1), chord_of(p + 2, axis)));

    e[0] = loft_to_acc(p[1].axis[axis]);
    e[1] = loft_to_acc(p[2].axis[axis]);
    return loft_sci_to_acc(t1, &e[2]) && loft_sci_to_acc(t2, &e[3]);
}

enum loft_status loft_tcb_tangents(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2,
                                   loft_vec out[2])
{
    const enum loft_status status = check_segment(p, k1, k2);
    loft_acc e[4];

    if (status != LOFT_OK)
        return status;
    for (int i = 0; i < LOFT_AXES; i++)
        if (!segment_ends(p, k1, k2, i, e) || !loft_vec_round_axis(e + 2, 2, i, out))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

enum loft_status loft_tcb_deriv(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2,
                                unsigned k, loft_unit t, loft_vec *out)
{
    const enum loft_status status = check_segment(p, k1, k2);
    loft_acc e[4], x[LOFT_AXES];

    if (status != LOFT_OK)
        return status;
    if (!(t >= 0 && t <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        if (!segment_ends(p, k1, k2, i, e))
            return LOFT_ERR_RANGE;
        x[i] = loft_ends3_deriv(e, k, t);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_tcb_eval(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2,
                               loft_unit t, loft_vec *out)
{
    return loft_tcb_deriv(p, k1, k2, 0, t, out);
}

enum loft_status loft_cubic_from_tcb(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2,
                                     loft_cubic *out)
{
    const enum loft_status status = check_segment(p, k1, k2);
    loft_acc e[4], c[4];

    if (status != LOFT_OK)
        return status;
    for (int i = 0; i < LOFT_AXES; i++) {
        if (!segment_ends(p, k1, k2, i, e))
            return LOFT_ERR_RANGE;
        loft_ends3_bernstein(e, c);
        if (!loft_vec_round_axis(c, 4, i, out->p))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

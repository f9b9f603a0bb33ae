/* lib/curve/catmull.c
 * SPDX-License-Identifier: MIT
 *
 * The pyramid of Barry and Goldman is the Hermite cubic whose tangents are those of the parabolas
 * through three points each. For the steps h0, h1, h2 and the chords d0, d1, d2 they are, per h1,
 *
 *     T1 = (d0 h1^2/h0 + d1 h0) / (h0 + h1)      T2 = (d1 h2 + d2 h1^2/h2) / (h1 + h2)
 *
 * Nothing cancels here. For alpha in 0..1, d0/h0 <= |d0|^(1 - alpha), and both tangents are at most
 * the sum of the two chords: below 2^18.4 in three axes, within the range of loft_ends3_deriv. A
 * step by the logarithm errs by 2^-55 + 21 * 2^-57 of itself, so a tangent by 2^-52, below 2^-33.
 */
#include "curve/catmull.h"
#include "basis/interp.h"       /* loft_ends3_deriv */
#include "num/explog.h"         /* loft_sci_log, loft_sci_exp */

static loft_sci chord_of(const loft_vec *p, int axis)
{
    return loft_sci_sub(loft_sci_from_real(p[1].axis[axis]), loft_sci_from_real(p[0].axis[axis]));
}

/* The length of a chord to the power alpha; 0 for equal points. */
static loft_sci step_of(const loft_vec *p, loft_unit alpha)
{
    loft_sci sum = loft_sci_zero();

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci d = chord_of(p, i);
        sum = loft_sci_add(sum, loft_sci_mul(d, d));
    }
    if (loft_sci_sign(sum) == 0)
        return sum;
    if (alpha <= 0)
        return loft_sci_one();
    const loft_sci length = loft_sci_sqrt(sum);
    if (alpha >= LOFT_UNIT(1))
        return length;
    if (alpha <= LOFT_UNIT(0.5) && alpha >= LOFT_UNIT(0.5))
        return loft_sci_sqrt(length);
    return loft_sci_exp(loft_sci_mul(loft_sci_from_unit(alpha), loft_sci_log(length)));
}

static enum loft_status set_steps(const loft_vec p[4], loft_unit alpha, loft_sci h[3])
{
    const loft_sci limit = loft_sci_pow(loft_sci_from_int(2), 500);

    if (!(alpha >= 0 && alpha <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (!loft_sci_less(loft_sci_abs(loft_sci_from_real(p[k].axis[i])), limit))
                return LOFT_ERR_RANGE;
    for (int k = 0; k < 3; k++) {
        h[k] = step_of(p + k, alpha);
        if (loft_sci_sign(h[k]) == 0)
            return LOFT_SINGULAR;
    }
    return LOFT_OK;
}

/* (outer chord * h1^2 / h + middle chord * h) / (h + h1) */
static loft_sci tangent_of(loft_sci outer, loft_sci middle, loft_sci h, loft_sci h1)
{
    const loft_sci far = loft_sci_div(loft_sci_mul(outer, loft_sci_mul(h1, h1)), h);

    return loft_sci_div(loft_sci_add(far, loft_sci_mul(middle, h)), loft_sci_add(h, h1));
}

static bool segment_ends(const loft_vec p[4], const loft_sci h[3], int axis, loft_acc e[4])
{
    const loft_sci middle = chord_of(p + 1, axis);
    const loft_sci t1 = tangent_of(chord_of(p, axis), middle, h[0], h[1]),
                   t2 = tangent_of(chord_of(p + 2, axis), middle, h[2], h[1]);

    e[0] = loft_to_acc(p[1].axis[axis]);
    e[1] = loft_to_acc(p[2].axis[axis]);
    return loft_sci_to_acc(t1, &e[2]) && loft_sci_to_acc(t2, &e[3]);
}

enum loft_status loft_catmull_deriv(const loft_vec p[4], loft_unit alpha, unsigned k, loft_unit t,
                                    loft_vec *out)
{
    loft_sci h[3];
    loft_acc e[4], x[LOFT_AXES];

    if (!(t >= 0 && t <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    const enum loft_status status = set_steps(p, alpha, h);
    if (status != LOFT_OK)
        return status;
    for (int i = 0; i < LOFT_AXES; i++) {
        if (!segment_ends(p, h, i, e))
            return LOFT_ERR_RANGE;
        x[i] = loft_ends3_deriv(e, k, t);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_catmull_eval(const loft_vec p[4], loft_unit alpha, loft_unit t, loft_vec *out)
{
    return loft_catmull_deriv(p, alpha, 0, t, out);
}

enum loft_status loft_cubic_from_catmull(const loft_vec p[4], loft_unit alpha, loft_cubic *out)
{
    loft_sci h[3];
    loft_acc e[4], c[4];
    const enum loft_status status = set_steps(p, alpha, h);

    if (status != LOFT_OK)
        return status;
    for (int i = 0; i < LOFT_AXES; i++) {
        if (!segment_ends(p, h, i, e))
            return LOFT_ERR_RANGE;
        loft_ends3_bernstein(e, c);
        if (!loft_vec_round_axis(c, 4, i, out->p))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

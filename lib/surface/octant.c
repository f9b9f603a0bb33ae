/* lib/surface/octant.c
 * SPDX-License-Identifier: MIT
 *
 * The net has the symmetry of its corners. There are four kinds of control points, and a coordinate
 * depends only on the kind and the index of its axis.
 *
 *     b400 = (1, 0, 0)            w400 = 4 sqrt3 (sqrt3 - 1)
 *     b310 = (1, alpha, 0)        w310 = 3 sqrt2
 *     b220 = (beta, beta, 0)      w220 = 4
 *     b211 = (1, gamma, gamma)    w211 = sqrt2 / sqrt3 (3 + 2 sqrt2 - sqrt3)
 *
 *     alpha = (sqrt3 - 1) / sqrt3
 *     beta  = (sqrt3 + 1) / (2 sqrt3)
 *     gamma = 1 - (5 - sqrt2) (7 - sqrt3) / 46
 *
 * The constants err by 2^-58 (floats 2^-50), and the rows together by 2^-58. Weights are positive.
 */
#include "surface/octant.h"
#include "num/sci.h"                /* loft_sci: irrational weights */

#define DEGREE 4
#define POINTS 15
#define SPACE 3

typedef struct {
    loft_sci w400, w310, w220, w211, alpha, beta, gamma;
} shape;

static loft_sci whole(int32_t i) { return loft_sci_from_int(i); }

static shape shape_of(void)
{
    const loft_sci one = loft_sci_one(), root2 = loft_sci_sqrt(whole(2)),
                   root3 = loft_sci_sqrt(whole(3));
    const loft_sci less = loft_sci_sub(root3, one), more = loft_sci_add(root3, one);
    const loft_sci near = loft_sci_mul(loft_sci_sub(whole(5), root2),
                                       loft_sci_sub(whole(7), root3));
    const loft_sci far = loft_sci_sub(loft_sci_add(whole(3), loft_sci_mul(whole(2), root2)), root3);
    shape s;

    s.w400 = loft_sci_mul(loft_sci_mul(whole(4), root3), less);
    s.w310 = loft_sci_mul(whole(3), root2);
    s.w220 = whole(4);
    s.w211 = loft_sci_mul(loft_sci_div(root2, root3), far);
    s.alpha = loft_sci_div(less, root3);
    s.beta = loft_sci_div(more, loft_sci_mul(whole(2), root3));
    s.gamma = loft_sci_sub(one, loft_sci_div(near, whole(46)));
    return s;
}

/* The weight of the control point with these indices. */
static loft_sci weight(const shape *s, const unsigned index[SPACE])
{
    unsigned most = 0, nonzero = 0;

    for (int i = 0; i < SPACE; i++) {
        most = index[i] > most ? index[i] : most;
        nonzero += index[i] > 0;
    }
    return most == 4 ? s->w400 : most == 3 ? s->w310 : nonzero == 2 ? s->w220 : s->w211;
}

static loft_sci coordinate(const shape *s, const unsigned index[SPACE], int axis)
{
    const bool inner = index[0] && index[1] && index[2];
    const unsigned own = index[axis];

    return own == 0             ? loft_sci_zero()
           : own == 1           ? (inner ? s->gamma : s->alpha)
           : own == 2 && !inner ? s->beta
                                : loft_sci_one();
}

/* The weights (axis < 0), or the weighted coordinates of an axis, evaluated at u. */
static loft_sci value(const shape *s, int axis, loft_sci u, loft_sci v, loft_sci w)
{
    loft_sci c[POINTS];

    for (unsigned m = 0, p = 0; m <= DEGREE; m++)
        for (unsigned k = 0; k <= m; k++, p++) {
            const unsigned index[SPACE] = { DEGREE - m, m - k, k };
            c[p] = weight(s, index);
            if (axis >= 0)
                c[p] = loft_sci_mul(c[p], coordinate(s, index, axis));
        }
    for (unsigned n = DEGREE; n > 0; n--)
        for (unsigned m = 0, p = 0; m < n; m++)
            for (unsigned k = 0; k <= m; k++, p++)
                c[p] = loft_sci_add(
                    loft_sci_add(loft_sci_mul(u, c[p]), loft_sci_mul(v, c[p + m + 1])),
                    loft_sci_mul(w, c[p + m + 2]));
    return c[0];
}

static loft_real rounded(loft_sci x)
{
    loft_acc y;

    return loft_sci_to_acc(x, &y) && loft_acc_valid(y) ? loft_acc_round(y) : 0;
}

loft_vec loft_octant_eval(loft_bary at)
{
    const shape s = shape_of();
    loft_vec out = { { 0 } };

    at = loft_bary_clamp(at);
    const loft_sci v = loft_sci_from_unit(at.v), w = loft_sci_from_unit(at.w);
    const loft_sci u = loft_sci_sub(loft_sci_sub(loft_sci_one(), v), w),
                   sum = value(&s, -1, u, v, w);
    for (int i = 0; i < SPACE && i < LOFT_AXES; i++)
        out.axis[i] = rounded(loft_sci_div(value(&s, i, u, v, w), sum));
    return out;
}

enum loft_status loft_octant_from_radius(loft_real r, loft_weighted out[15])
{
    const shape s = shape_of();

    if (!(r >= 0) || !loft_real_valid(r))
        return LOFT_ERR_RANGE;
    for (unsigned m = 0, p = 0; m <= DEGREE; m++)
        for (unsigned k = 0; k <= m; k++, p++) {
            const unsigned index[SPACE] = { DEGREE - m, m - k, k };
            const loft_vec origin = { { 0 } };
            out[p].p = origin;
            out[p].w = rounded(loft_sci_mul(whole(32), weight(&s, index)));
            for (int i = 0; i < SPACE && i < LOFT_AXES; i++)
                out[p].p.axis[i] = rounded(
                    loft_sci_mul(loft_sci_from_real(r), coordinate(&s, index, i)));
        }
    return LOFT_OK;
}

/* lib/surface/deficit.c
 * SPDX-License-Identifier: MIT
 *
 * A triangle has the edges a and b at the vertex, and c = b - a. D = |a x b| is twice its area.
 *
 *     angle = atan2(D, a b)
 *     area  = D / 4                                  where a b < 0
 *           = D / 8                                  where a c > 0 or b c < 0
 *           = (a^2 (b c) - b^2 (a c)) / (8 D)        otherwise
 *
 * The last line is (a^2 cot at b's end + b^2 cot at a's end) / 8. At a right angle the formulas on
 * both sides agree. So a sign that rounding decides costs no more than rounding itself. The terms
 * of the last formula are not negative. Where D is small against a^2, both angles away from the
 * vertex are nearly right and (b c) is off by 2^-60 of |b c|. The sum is then off by that part of
 * a^2. The bound allows for this.
 */
#include "surface/deficit.h"
#include "geom/vec_exact.h"     /* loft_vec_exact_valid */
#include "num/explog.h"         /* loft_sci_from_fine */

static void offset(const loft_vec *from, const loft_vec *to, loft_sci out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = loft_sci_sub(loft_sci_from_real(loft_vec_axis(to, k)),
                              loft_sci_from_real(loft_vec_axis(from, k)));
}

/* |a x b|. The relative error of each component does not grow when it is small. */
static loft_sci cross_size(const loft_vec *vertex, const loft_vec *p, const loft_vec *q)
{
    loft_sci c[3];

    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const loft_real o[2] = { loft_vec_axis(vertex, i), loft_vec_axis(vertex, j) };
        const loft_real a[2] = { loft_vec_axis(p, i), loft_vec_axis(p, j) },
                        b[2] = { loft_vec_axis(q, i), loft_vec_axis(q, j) };
        c[k] = loft_sci_cross(o, a, o, b);
    }
    return loft_sci_sqrt(loft_sci_dot3(c, c));
}

/* The angle of (x, y), y >= 0. Both are scaled so that the larger is 2^29. */
static loft_fine angle_of(loft_sci y, loft_sci x)
{
    const loft_sci size = loft_sci_sign(x) < 0 ? loft_sci_neg(x) : x,
                   most = loft_sci_less(size, y) ? y : size;
    const loft_sci scale = loft_sci_div(loft_sci_from_int(536870912), most);
    loft_acc wide[2] = { 0, 0 };

    if (!loft_sci_to_acc(loft_sci_mul(y, scale), &wide[0]) ||
        !loft_sci_to_acc(loft_sci_mul(x, scale), &wide[1]))
        return 0;
    return loft_fine_atan2(wide[0], wide[1]);
}

static loft_sci area_of(const loft_sci a[3], const loft_sci b[3], const loft_sci c[3], loft_sci d)
{
    const loft_sci ac = loft_sci_dot3(a, c), bc = loft_sci_dot3(b, c);

    if (!loft_sci_sign(d))
        return d;
    if (loft_sci_sign(loft_sci_dot3(a, b)) < 0)
        return loft_sci_mul(d, loft_sci_from_unit(LOFT_UNIT(0.25)));
    if (loft_sci_sign(ac) > 0 || loft_sci_sign(bc) < 0)
        return loft_sci_mul(d, loft_sci_from_unit(LOFT_UNIT(0.125)));
    const loft_sci sum = loft_sci_sub(loft_sci_mul(loft_sci_dot3(a, a), bc),
                                      loft_sci_mul(loft_sci_dot3(b, b), ac));
    return loft_sci_div(loft_sci_mul(sum, loft_sci_from_unit(LOFT_UNIT(0.125))), d);
}

enum loft_status loft_deficit_eval(const loft_vec *vertex, const loft_vec ring[], unsigned count,
                                   loft_deficit *out)
{
    loft_sci angles = loft_sci_zero(), area = loft_sci_zero(), a[3], b[3], c[3];

    if (count < 3 || count > 255)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i < count; i++)
        if (!loft_vec_exact_valid(vertex, 1, 3) || !loft_vec_exact_valid(&ring[i], 1, 3))
            return LOFT_ERR_RANGE;
    for (unsigned i = 0; i < count; i++) {
        const loft_vec *next = &ring[i + 1 < count ? i + 1 : 0];
        offset(vertex, &ring[i], a);
        offset(vertex, next, b);
        offset(&ring[i], next, c);
        if (!loft_sci_sign(loft_sci_dot3(a, a)) || !loft_sci_sign(loft_sci_dot3(b, b)))
            return LOFT_SINGULAR;
        const loft_sci d = cross_size(vertex, &ring[i], next);
        angles = loft_sci_add(angles, loft_sci_from_fine(angle_of(d, loft_sci_dot3(a, b))));
        area = loft_sci_add(area, area_of(a, b, c, d));
    }
    if (!loft_sci_sign(area))
        return LOFT_SINGULAR;
    const loft_sci turn = loft_sci_mul(loft_sci_from_fine(LOFT_FINE_PI), loft_sci_from_int(2));
    out->angles = angles;
    out->area = area;
    out->gauss = loft_sci_div(loft_sci_sub(turn, angles), area);
    return LOFT_OK;
}

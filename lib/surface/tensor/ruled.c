/* lib/surface/tensor/ruled.c
 * SPDX-License-Identifier: MIT
 *
 * S(u, v) = (1 - v) A(u) + v B(u), S_v = B - A, S_vv = 0. A row of de Casteljau's algorithm errs by
 * 3 roundings of num/sci.h, 2^-59 of the largest value in q16.
 */
#include "surface/tensor/ruled.h"
#include "num/sci.h"            /* loft_sci */

enum loft_status loft_tensor_from_ruled(const loft_bezier *a, const loft_bezier *b, loft_vec out[])
{
    const unsigned m = a->degree > b->degree ? a->degree : b->degree;
    const loft_bezier *const side[2] = { a, b };
    loft_vec raised[LOFT_DEGREE_MAX + 1];

    for (unsigned j = 0; j < 2; j++) {
        const enum loft_status status = loft_bezier_elevate(side[j], m - side[j]->degree, raised);
        if (status != LOFT_OK)
            return status;
        for (unsigned i = 0; i <= m; i++)
            out[2 * i + j] = raised[i];
    }
    return LOFT_OK;
}

static loft_sci curve_slope(const loft_bezier *b, unsigned order, loft_sci t, int axis)
{
    loft_sci c[LOFT_DEGREE_MAX + 1];

    for (unsigned i = 0; i <= b->degree; i++)
        c[i] = loft_sci_from_real(b->p[i].axis[axis]);
    return loft_sci_deriv(c, b->degree, order, t);
}

static bool unit_valid(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

enum loft_status loft_ruled_deriv(const loft_bezier *a, const loft_bezier *b, unsigned j,
                                  unsigned k, loft_unit u, loft_unit v, loft_vec *out)
{
    const loft_sci at = loft_sci_from_unit(u), along = loft_sci_from_unit(v);
    loft_acc x[LOFT_AXES];

    if (!unit_valid(u) || !unit_valid(v) || j > 2)
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const loft_sci from = curve_slope(a, j, at, axis), to = curve_slope(b, j, at, axis);
        const loft_sci s = k == 0   ? loft_sci_lerp(from, to, along)
                           : k == 1 ? loft_sci_sub(to, from)
                                    : loft_sci_zero();
        if (!loft_sci_to_acc(s, &x[axis]))
            return LOFT_ERR_RANGE;
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

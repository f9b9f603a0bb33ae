/* lib/surface/tensor/skin.c
 * SPDX-License-Identifier: MIT
 *
 * S(u, v) = sum B_i(u) s_i(v), where s_i is the spline of control point i. The place of v in its
 * piece is a quotient, which errs by 2^-61 of itself. De Casteljau's algorithm takes averages of
 * the s_i, and errs by 3 roundings a row.
 */
#include "surface/tensor/skin.h"

enum loft_status loft_skin_init(loft_skin *s, const loft_vec p[], unsigned degree,
                                uint32_t sections, const loft_real v[], enum loft_spline_ends ends,
                                loft_spline_knot memory[])
{
    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i <= degree; i++) {
        const enum loft_status status = loft_spline_knots_init(
            &s->line[i], p + i, sections, degree + 1, v, ends, memory + (size_t)i * sections);
        if (status != LOFT_OK)
            return status;
    }
    s->v = v;
    s->sections = sections;
    s->degree = (uint8_t)degree;
    return LOFT_OK;
}

/* The piece of v, which is clamped; its place in it. */
static uint32_t piece_of(const loft_skin *s, loft_real v, loft_sci *x)
{
    uint32_t low = 0, high = s->sections - 1;

    v = v > s->v[0] ? v < s->v[high] ? v : s->v[high] : s->v[0];
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        if (s->v[middle] <= v)
            low = middle;
        else
            high = middle;
    }
    const loft_sci from = loft_sci_from_real(s->v[low]);
    *x = loft_sci_div(loft_sci_sub(loft_sci_from_real(v), from),
                      loft_sci_sub(loft_sci_from_real(s->v[low + 1]), from));
    return low;
}

enum loft_status loft_skin_deriv(const loft_skin *s, unsigned j, unsigned k, loft_unit u,
                                 loft_real v, loft_vec *out)
{
    loft_sci x, c[LOFT_DEGREE_MAX + 1];
    loft_acc sum[LOFT_AXES];

    if (!(u >= 0 && u <= LOFT_UNIT(1)) || j > 2 || k > 2)
        return LOFT_ERR_ARG;
    const uint32_t piece = piece_of(s, v, &x);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        for (unsigned i = 0; i <= s->degree; i++)
            c[i] = loft_spline_slope(&s->line[i], piece, k, x, axis);
        if (!loft_sci_to_acc(loft_sci_deriv(c, s->degree, j, loft_sci_from_unit(u)), &sum[axis]))
            return LOFT_ERR_RANGE;
    }
    return loft_vec_round(sum, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_tensor_from_skin(const loft_skin *s, uint32_t j, loft_vec out[])
{
    for (unsigned i = 0; i <= s->degree; i++) {
        loft_cubic c;
        const enum loft_status status = loft_cubic_from_spline(&s->line[i], j, &c);
        if (status != LOFT_OK)
            return status;
        for (unsigned l = 0; l < 4; l++)
            out[4 * i + l] = c.p[l];
    }
    return LOFT_OK;
}

/* lib/surface/tensor/tensor_rational.c
 * SPDX-License-Identifier: MIT
 *
 * Numerator and denominator are two tensor-product polynomials at the scale of curve/rational.c. In
 * q16 |x| < 2^30 and w' < 2^30, w' >= 2^29 / R. m + n rows of lerps err by (m + n) 2^-33, so the
 * quotient errs by (m + n) R 2^-30 LSB.
 */
#include "surface/tensor/tensor_rational.h"
#include "num/acc128.h"             /* loft_acc_project */
#include "surface/differential.h"   /* the derivatives */

#define POINTS (LOFT_DEGREE_MAX + 1)
#define WEIGHTS (-1)            /* given in place of an axis */

static loft_rational row_of(const loft_tensor_rational *s, unsigned i)
{
    const loft_rational r = { s->p + (size_t)i * (s->n + 1u), s->scale, s->n };
    return r;
}

/* The points of a column are n + 1 apart, so they are copied. The scale of the patch is valid for
 * each of its curves. */
static loft_rational column_of(const loft_tensor_rational *s, unsigned j, loft_weighted copy[])
{
    const loft_rational r = { copy, s->scale, s->m };

    for (unsigned i = 0; i <= s->m; i++)
        copy[i] = s->p[i * (s->n + 1u) + j];
    return r;
}

static void set_column(const loft_weighted line[], unsigned count, unsigned j, unsigned width,
                       loft_weighted out[])
{
    for (unsigned i = 0; i < count; i++)
        out[i * width + j] = line[i];
}


/* Points */

enum loft_status loft_tensor_rational_init(loft_tensor_rational *s, const loft_weighted p[],
                                           unsigned m, unsigned n)
{
    int32_t scale;

    if (m > LOFT_DEGREE_MAX || n > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    if (loft_weighted_scale(p, (m + 1) * (n + 1), &scale) != LOFT_OK)
        return LOFT_ERR_RANGE;
    s->p = p;
    s->scale = scale;
    s->m = (uint8_t)m;
    s->n = (uint8_t)n;
    return LOFT_OK;
}

static loft_acc net_coefficient(const loft_tensor_rational *s, const loft_weighted *p, int axis)
{
    const loft_real w = p->w * (loft_real)s->scale;
    return axis == WEIGHTS ? loft_to_acc(w) * LOFT_PROJECT : loft_prod(p->p.axis[axis], w);
}

static loft_acc eval_polynomial(const loft_tensor_rational *s, int axis, loft_unit u, loft_unit v)
{
    loft_acc c[POINTS], row[POINTS];

    for (unsigned j = 0; j <= s->n; j++) {
        for (unsigned i = 0; i <= s->m; i++)
            c[i] = net_coefficient(s, &s->p[i * (s->n + 1u) + j], axis);
        row[j] = loft_bernstein_eval(c, s->m, u);
    }
    return loft_bernstein_eval(row, s->n, v);
}

loft_vec loft_tensor_rational_eval(const loft_tensor_rational *s, loft_unit u, loft_unit v)
{
    loft_vec p;

    u = loft_unit_clamp(u);
    v = loft_unit_clamp(v);
    const loft_acc w = eval_polynomial(s, WEIGHTS, u, v);
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = loft_acc_project(eval_polynomial(s, i, u, v), w);
    return p;
}

static bool round_derivative(const loft_sci x[LOFT_AXES], loft_vec *out)
{
    loft_acc wide[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_sci_to_acc(x[i], &wide[i]))
            return false;
    return loft_vec_round(wide, out);
}

enum loft_status loft_tensor_rational_deriv(const loft_tensor_rational *s, loft_unit u, loft_unit v,
                                            loft_vec *by_u, loft_vec *by_v)
{
    loft_differential at;
    loft_vec one, two;

    const enum loft_status status = loft_tensor_rational_differential(s, u, v, &at);
    if (status != LOFT_OK)
        return status;
    if (!round_derivative(at.u, &one) || !round_derivative(at.v, &two))
        return LOFT_ERR_RANGE;
    *by_u = one;
    *by_v = two;
    return LOFT_OK;
}


/* Pieces and other forms */

enum loft_status loft_tensor_rational_split_u(const loft_tensor_rational *s, loft_unit t,
                                              loft_weighted left[], loft_weighted right[])
{
    loft_weighted copy[POINTS], one[POINTS];
    const unsigned width = s->n + 1u;

    for (unsigned j = 0; j < width; j++) {
        const loft_rational column = column_of(s, j, copy);
        const enum loft_status status = loft_rational_split(&column, t, one, copy);
        if (status != LOFT_OK)
            return status;
        set_column(one, s->m + 1u, j, width, left);
        set_column(copy, s->m + 1u, j, width, right);
    }
    return LOFT_OK;
}

enum loft_status loft_tensor_rational_split_v(const loft_tensor_rational *s, loft_unit t,
                                              loft_weighted left[], loft_weighted right[])
{
    for (unsigned i = 0; i <= s->m; i++) {
        const loft_rational row = row_of(s, i);
        const size_t at = (size_t)i * (s->n + 1u);
        const enum loft_status status = loft_rational_split(&row, t, left + at, right + at);
        if (status != LOFT_OK)
            return status;
    }
    return LOFT_OK;
}

enum loft_status loft_tensor_rational_elevate_u(const loft_tensor_rational *s, unsigned times,
                                                loft_weighted out[])
{
    loft_weighted copy[POINTS], line[LOFT_ELEVATE_MAX + 1];

    for (unsigned j = 0; j <= s->n; j++) {
        const loft_rational column = column_of(s, j, copy);
        const enum loft_status status = loft_rational_elevate(&column, times, line);
        if (status != LOFT_OK)
            return status;
        set_column(line, s->m + times + 1, j, s->n + 1u, out);
    }
    return LOFT_OK;
}

enum loft_status loft_tensor_rational_elevate_v(const loft_tensor_rational *s, unsigned times,
                                                loft_weighted out[])
{
    for (unsigned i = 0; i <= s->m; i++) {
        const loft_rational row = row_of(s, i);
        const enum loft_status status = loft_rational_elevate(&row, times,
                                                              out + (size_t)i * (s->n + times + 1));
        if (status != LOFT_OK)
            return status;
    }
    return LOFT_OK;
}

loft_box loft_tensor_rational_box(const loft_tensor_rational *s)
{
    loft_box box = { s->p[0].p, s->p[0].p };

    for (unsigned k = 1; k < (s->m + 1u) * (s->n + 1u); k++)
        box = loft_box_join(box, s->p[k].p);
    return box;
}

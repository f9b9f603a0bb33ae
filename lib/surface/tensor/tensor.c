/* lib/surface/tensor/tensor.c
 * SPDX-License-Identifier: MIT
 *
 * Range and error. Within 0..1 a row of de Casteljau's algorithm makes no value larger and rounds
 * by 2^-33 (basis/bernstein.c). After m rows along u each of the n + 1 values errs by at most m
 * 2^-33. Along v these errors are averaged while n more roundings come: (m + n) 2^-33, in LSB (m +
 * n) 2^-17.
 */
#include "surface/tensor/tensor.h"

static bool unit_valid(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

static loft_bezier row_of(const loft_tensor *s, unsigned i)
{
    const loft_bezier b = { s->p + (size_t)i * (s->n + 1u), s->n };
    return b;
}

/* The points of a column are n + 1 apart, so they are copied. */
static loft_bezier column_of(const loft_tensor *s, unsigned j, loft_vec copy[])
{
    const loft_bezier b = { copy, s->m };

    for (unsigned i = 0; i <= s->m; i++)
        copy[i] = s->p[i * (s->n + 1u) + j];
    return b;
}

static void set_column(const loft_vec line[], unsigned count, unsigned j, unsigned width,
                       loft_vec out[])
{
    for (unsigned i = 0; i < count; i++)
        out[i * width + j] = line[i];
}


/* Points */

enum loft_status loft_tensor_init(loft_tensor *s, const loft_vec p[], unsigned m, unsigned n)
{
    loft_bezier row;

    if (m > LOFT_DEGREE_MAX || n > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i <= m; i++) {
        const enum loft_status status = loft_bezier_init(&row, p + (size_t)i * (n + 1), n);
        if (status != LOFT_OK)
            return status;
    }
    s->p = p;
    s->m = (uint8_t)m;
    s->n = (uint8_t)n;
    return LOFT_OK;
}

/* Replace c[0..degree] by its differences of order k, c[0..degree-k]. */
static void difference_net(loft_acc c[], unsigned degree, unsigned k)
{
    for (; k > 0; k--, degree--)
        for (unsigned i = 0; i < degree; i++)
            c[i] = c[i+1] - c[i];
}

/* The value at (u, v) of the patch of degrees (m - a) x (n - b) made of the differences of one
 * axis. With a + b <= 9 differences are below 2^9 2^47. */
static loft_acc differences_at(const loft_tensor *s, int axis, unsigned a, unsigned b, loft_unit u,
                               loft_unit v)
{
    loft_acc c[LOFT_DEGREE_MAX + 1], row[LOFT_DEGREE_MAX + 1];

    for (unsigned j = 0; j <= s->n; j++) {
        for (unsigned i = 0; i <= s->m; i++)
            c[i] = loft_to_acc(s->p[i * (s->n + 1u) + j].axis[axis]);
        difference_net(c, s->m, a);
        row[j] = loft_bernstein_eval(c, s->m - a, u);
    }
    difference_net(row, s->n, b);
    return loft_bernstein_eval(row, s->n - b, v);
}

loft_vec loft_tensor_eval(const loft_tensor *s, loft_unit u, loft_unit v)
{
    loft_vec p;

    u = loft_unit_clamp(u);
    v = loft_unit_clamp(v);
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = loft_acc_round(differences_at(s, i, 0, 0, u, v));
    return p;
}

/* n! / (n - k)!, 0 for k > n */
static int32_t falling_factorial(unsigned n, unsigned k)
{
    int32_t f = 1;

    for (unsigned j = 0; j < k; j++)
        f = j < n ? f * (int32_t)(n - j) : 0;
    return f;
}

/* The factor is at most 9! / 5! * 9! / 4! < 2^26. It is applied only when the value is within twice
 * the range of a coordinate divided by the factor. */
enum loft_status loft_tensor_deriv(const loft_tensor *s, unsigned a, unsigned b, loft_unit u,
                                   loft_unit v, loft_vec *out)
{
    loft_vec r = { { 0 } };

    if (!unit_valid(u) || !unit_valid(v) || a > LOFT_DEGREE_MAX || b > LOFT_DEGREE_MAX - a)
        return LOFT_ERR_ARG;
    const int32_t factor = falling_factorial(s->m, a) * falling_factorial(s->n, b);
    const loft_acc limit = factor ? 2 * loft_acc_ratio(loft_to_acc(LOFT_REAL_MAX), factor) : 0;

    for (int i = 0; i < LOFT_AXES && factor; i++) {
        const loft_acc d = differences_at(s, i, a, b, u, v);
        if (!(d >= -limit && d <= limit) || !loft_acc_valid(d * factor))
            return LOFT_ERR_RANGE;
        r.axis[i] = loft_acc_round(d * factor);
    }
    *out = r;
    return LOFT_OK;
}

void loft_tensor_at_u(const loft_tensor *s, loft_unit u, loft_vec out[])
{
    loft_vec copy[LOFT_DEGREE_MAX + 1];

    for (unsigned j = 0; j <= s->n; j++) {
        const loft_bezier column = column_of(s, j, copy);
        out[j] = loft_bezier_eval(&column, u);
    }
}

void loft_tensor_at_v(const loft_tensor *s, loft_unit v, loft_vec out[])
{
    for (unsigned i = 0; i <= s->m; i++) {
        const loft_bezier row = row_of(s, i);
        out[i] = loft_bezier_eval(&row, v);
    }
}


/* Pieces and other forms */

enum loft_status loft_tensor_split_u(const loft_tensor *s, loft_unit t, loft_vec left[],
                                     loft_vec right[])
{
    loft_vec copy[LOFT_DEGREE_MAX + 1], one[LOFT_DEGREE_MAX + 1];
    const unsigned width = s->n + 1u;

    for (unsigned j = 0; j < width; j++) {
        const loft_bezier column = column_of(s, j, copy);
        const enum loft_status status = loft_bezier_split(&column, t, one, copy);
        if (status != LOFT_OK)
            return status;
        set_column(one, s->m + 1u, j, width, left);
        set_column(copy, s->m + 1u, j, width, right);
    }
    return LOFT_OK;
}

enum loft_status loft_tensor_split_v(const loft_tensor *s, loft_unit t, loft_vec left[],
                                     loft_vec right[])
{
    for (unsigned i = 0; i <= s->m; i++) {
        const loft_bezier row = row_of(s, i);
        const size_t at = (size_t)i * (s->n + 1u);
        const enum loft_status status = loft_bezier_split(&row, t, left + at, right + at);
        if (status != LOFT_OK)
            return status;
    }
    return LOFT_OK;
}

enum loft_status loft_tensor_sub_u(const loft_tensor *s, loft_unit from, loft_unit to,
                                   loft_vec out[])
{
    loft_vec copy[LOFT_DEGREE_MAX + 1];

    for (unsigned j = 0; j <= s->n; j++) {
        const loft_bezier column = column_of(s, j, copy);
        const enum loft_status status = loft_bezier_sub(&column, from, to, copy);
        if (status != LOFT_OK)
            return status;
        set_column(copy, s->m + 1u, j, s->n + 1u, out);
    }
    return LOFT_OK;
}

enum loft_status loft_tensor_sub_v(const loft_tensor *s, loft_unit from, loft_unit to,
                                   loft_vec out[])
{
    for (unsigned i = 0; i <= s->m; i++) {
        const loft_bezier row = row_of(s, i);
        const enum loft_status status = loft_bezier_sub(&row, from, to,
                                                        out + (size_t)i * (s->n + 1u));
        if (status != LOFT_OK)
            return status;
    }
    return LOFT_OK;
}

enum loft_status loft_tensor_elevate_u(const loft_tensor *s, unsigned times, loft_vec out[])
{
    loft_vec copy[LOFT_DEGREE_MAX + 1], line[LOFT_BEZIER_ELEVATE_MAX + 1];

    if (times > LOFT_BEZIER_ELEVATE_MAX - (unsigned)s->m)
        return LOFT_ERR_ARG;
    for (unsigned j = 0; j <= s->n; j++) {
        const loft_bezier column = column_of(s, j, copy);
        const enum loft_status status = loft_bezier_elevate(&column, times, line);
        if (status != LOFT_OK)
            return status;
        set_column(line, s->m + times + 1, j, s->n + 1u, out);
    }
    return LOFT_OK;
}

enum loft_status loft_tensor_elevate_v(const loft_tensor *s, unsigned times, loft_vec out[])
{
    if (times > LOFT_BEZIER_ELEVATE_MAX - (unsigned)s->n)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i <= s->m; i++) {
        const loft_bezier row = row_of(s, i);
        const enum loft_status status = loft_bezier_elevate(&row, times,
                                                            out + (size_t)i * (s->n + times + 1));
        if (status != LOFT_OK)
            return status;
    }
    return LOFT_OK;
}

void loft_tensor_transpose(const loft_tensor *s, loft_vec out[])
{
    for (unsigned i = 0; i <= s->m; i++)
        for (unsigned j = 0; j <= s->n; j++)
            out[j * (s->m + 1u) + i] = s->p[i * (s->n + 1u) + j];
}

loft_box loft_tensor_box(const loft_tensor *s)
{
    loft_box box = { s->p[0], s->p[0] };

    for (unsigned k = 1; k < (s->m + 1u) * (s->n + 1u); k++)
        box = loft_box_join(box, s->p[k]);
    return box;
}

/* lib/surface/triangle/triangle.c
 * SPDX-License-Identifier: MIT
 *
 * Every function takes one axis at a time: coefficients as loft_acc, rows of de Casteljau's
 * algorithm, one rounding at the end. barycentric.c proves range and error of the rows. In real
 * units e_n = 2^-33 (1 + L + ..), in LSB (2^-16) 2^-17 (1 + L + ..), at most 0.08. The final
 * rounding adds 1/2.
 */
#include "surface/triangle/triangle.h"
#include "geom/normal.h"            /* loft_vec_normal */

#define MOST LOFT_TRIANGLE_MAX

static void axis_to_acc(const loft_triangle *t, int axis, loft_acc c[])
{
    const unsigned count = LOFT_TRIANGLE_POINTS(t->degree);

    for (unsigned k = 0; k < count; k++)
        c[k] = loft_to_acc(t->p[k].axis[axis]);
}

/* `times` rows of a net of that degree. */
static void casteljau_rows(loft_acc c[], unsigned degree, unsigned times, loft_bary u)
{
    for (unsigned n = degree; n > degree - times; n--)
        loft_bary_step(c, n, u);
}

static bool growth_valid(const loft_triangle *t, loft_bary a, loft_bary b)
{
    loft_acc product = loft_to_acc(LOFT_REAL(1)), other = product;

    return loft_bary_grows(a, false, t->degree, &product) &&
           loft_bary_grows(b, false, t->degree, &other);
}

enum loft_status loft_triangle_init(loft_triangle *t, const loft_vec p[], unsigned degree)
{
    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    const unsigned count = LOFT_TRIANGLE_POINTS(degree);
    for (unsigned k = 0; k < count; k++)
        if (!loft_vec_valid(p[k]))
            return LOFT_ERR_RANGE;
    t->p = p;
    t->degree = (uint8_t)degree;
    return LOFT_OK;
}


/* Points */

loft_vec loft_triangle_eval(const loft_triangle *t, loft_bary u)
{
    loft_acc c[MOST];
    loft_vec v;

    u = loft_bary_clamp(u);
    for (int i = 0; i < LOFT_AXES; i++) {
        axis_to_acc(t, i, c);
        v.axis[i] = loft_acc_round(loft_bary_eval(c, t->degree, u));
    }
    return v;
}

enum loft_status loft_triangle_extrapolate(const loft_triangle *t, loft_bary u, loft_vec *out)
{
    return loft_triangle_polar(t, 0, u, u, out);
}

enum loft_status loft_triangle_polar(const loft_triangle *t, unsigned times, loft_bary a,
                                     loft_bary u, loft_vec *out)
{
    loft_acc c[MOST], product = loft_to_acc(LOFT_REAL(1)), x[LOFT_AXES];

    if (times > t->degree)
        return LOFT_ERR_ARG;
    if (!loft_bary_grows(a, false, times, &product) ||
        !loft_bary_grows(u, false, t->degree - times, &product))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++) {
        axis_to_acc(t, i, c);
        casteljau_rows(c, t->degree, times, a);
        x[i] = loft_bary_eval(c, t->degree - times, u);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

/* All rows but the last: three coefficients remain. */
static void last_three(const loft_triangle *t, loft_bary u, int axis, loft_acc x[3])
{
    loft_acc c[MOST];

    axis_to_acc(t, axis, c);
    casteljau_rows(c, t->degree, t->degree - 1u, u);
    for (int k = 0; k < 3; k++)
        x[k] = c[k];
}

enum loft_status loft_triangle_tangent(const loft_triangle *t, loft_bary u, loft_vec out[3])
{
    loft_acc product = loft_to_acc(LOFT_REAL(1)), x[3];
    loft_vec v[3];

    if (t->degree == 0)
        return LOFT_ERR_ARG;
    if (!loft_bary_grows(u, false, t->degree - 1u, &product))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++) {
        last_three(t, u, i, x);
        if (!loft_vec_round_axis(x, 3, i, v))
            return LOFT_ERR_RANGE;
    }
    for (int k = 0; k < 3; k++)
        out[k] = v[k];
    return LOFT_OK;
}

enum loft_status loft_triangle_normal(const loft_triangle *t, loft_bary u, loft_vec *out)
{
    loft_acc a[LOFT_AXES], b[LOFT_AXES], x[3];

    if (t->degree == 0)
        return LOFT_ERR_ARG;
    u = loft_bary_clamp(u);
    for (int i = 0; i < LOFT_AXES; i++) {
        last_three(t, u, i, x);
        a[i] = x[1] - x[0];
        b[i] = x[2] - x[0];
    }
    return loft_vec_normal(a, b, out);
}

/* The differences come first, so that their roundings stay small: each of the r rows multiplies
 * earlier errors by Z, the other rows by L. The factor is at most 9! < 2^18.5, and the product
 * could overflow. So it is applied only when the value is within twice the range of a coordinate
 * divided by the factor. */
enum loft_status loft_triangle_deriv(const loft_triangle *t, unsigned r, loft_bary z, loft_bary u,
                                     loft_vec *out)
{
    loft_acc c[MOST], product = loft_to_acc(LOFT_REAL(1)), x[LOFT_AXES];
    const unsigned n = t->degree;
    int32_t factor = 1;

    if (r > n) {
        *out = (loft_vec) { { 0 } };
        return LOFT_OK;
    }
    if (!loft_bary_grows(z, true, r, &product) || !loft_bary_grows(u, false, n - r, &product))
        return LOFT_ERR_RANGE;
    for (unsigned j = 0; j < r; j++)
        factor *= (int32_t)(n - j);
    const loft_acc limit = 2 * loft_acc_ratio(loft_to_acc(LOFT_REAL_MAX), factor);
    for (int i = 0; i < LOFT_AXES; i++) {
        axis_to_acc(t, i, c);
        for (unsigned m = n; m > n - r; m--)
            loft_bary_slope(c, m, z);
        x[i] = loft_bary_eval(c, n - r, u);
        if (!(x[i] >= -limit && x[i] <= limit))
            return LOFT_ERR_RANGE;
        x[i] *= factor;
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}


/* Curves */

/* out[k] = b[from^(degree-k), to^k]: after degree - k rows at `from`, k rows at `to` in a copy. */
enum loft_status loft_triangle_line(const loft_triangle *t, loft_bary from, loft_bary to,
                                    loft_vec out[])
{
    loft_acc c[MOST], copy[MOST], x[LOFT_DEGREE_MAX + 1];

    if (!growth_valid(t, from, to))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++) {
        axis_to_acc(t, i, c);
        for (unsigned k = t->degree + 1u; k-- > 0; ) {
            for (unsigned j = 0; j < LOFT_TRIANGLE_POINTS(k); j++)
                copy[j] = c[j];
            x[k] = loft_bary_eval(copy, k, to);
            loft_bary_step(c, k, from);
        }
        if (!loft_vec_round_axis(x, t->degree + 1u, i, out))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

void loft_triangle_edge(const loft_triangle *t, unsigned side, loft_vec out[])
{
    const unsigned n = t->degree;

    for (unsigned k = 0; k <= n; k++)
        out[k] = t->p[side == 0   ? loft_triangle_place(n - k, k)
                      : side == 1 ? loft_triangle_place(0, n - k)
                                  : loft_triangle_place(k, 0)];
}

loft_box loft_triangle_box(const loft_triangle *t)
{
    const unsigned count = LOFT_TRIANGLE_POINTS(t->degree);
    loft_box box = { t->p[0], t->p[0] };

    for (unsigned k = 1; k < count; k++)
        box = loft_box_join(box, t->p[k]);
    return box;
}

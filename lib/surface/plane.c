/* lib/surface/plane.c
 * SPDX-License-Identifier: MIT
 *
 * A line is the two-axis case of the same formulas. With E = LOFT_EXACT_REAL, coordinates carry the
 * factor 2^E. The normal carries 2^E for a line and 2^(2 E) for a plane. The value at a point
 * carries one factor 2^E more than the normal.
 *
 * Range: differences have R + 1 bits (32, in floats 129), the normal of a plane 2 R + 3, the value
 * 3 R + 6: 99 and 390 bits. The result of loft_exact_hypot has twice the bits of the normal and 130
 * more.
 */
#include "surface/plane.h"
#include "geom/vec_exact.h" /* loft_exact */

/* The equation n (x - p0) = 0 in `axes` axes; n carries 2^scale. */
typedef struct {
    loft_exact normal[3];
    loft_vec   p0;
    int        axes, scale;
} equation;

static bool line_equation(const loft_line *l, equation *e)
{
    e->p0    = l->p[0];
    e->axes  = 2;
    e->scale = LOFT_EXACT_REAL;
    if (!loft_vec_exact_valid(l->p, 2, 2))
        return false;
    e->normal[0] = loft_vec_exact_sub_axis(&l->p[0], &l->p[1], 1);
    e->normal[1] = loft_vec_exact_sub_axis(&l->p[1], &l->p[0], 0);
    return true;
}

static bool facet_equation(const loft_facet *f, equation *e)
{
    loft_exact a[3], b[3];

    e->p0    = f->p[0];
    e->axes  = 3;
    e->scale = 2 * LOFT_EXACT_REAL;
    if (!loft_vec_exact_valid(f->p, 3, 3))
        return false;
    loft_vec_exact_sub(&f->p[1], &f->p[0], 3, a);
    loft_vec_exact_sub(&f->p[2], &f->p[0], 3, b);
    loft_vec_exact_cross(a, b, e->normal);
    return true;
}

static bool normal_is_zero(const equation *e)
{
    for (int i = 0; i < e->axes; i++)
        if (loft_exact_sign(e->normal[i]) != 0)
            return false;
    return true;
}

static loft_exact value(const equation *e, const loft_vec *x)
{
    loft_exact d[3];

    loft_vec_exact_sub(x, &e->p0, e->axes, d);
    return loft_vec_exact_dot(e->normal, d, e->axes);
}

static enum loft_status value_at(const equation *e, loft_vec x, loft_real *out)
{
    if (!loft_vec_exact_valid(&x, 1, e->axes) ||
        !loft_exact_quot_real(value(e, &x), loft_exact_from_int(1), -e->scale - LOFT_EXACT_REAL,
                              out))
        return LOFT_ERR_RANGE;
    return LOFT_OK;
}

/* The length carries 2^(scale + LOFT_EXACT_HYPOT). */
static enum loft_status distance_at(const equation *e, loft_vec x, loft_real *out)
{
    if (normal_is_zero(e))
        return LOFT_SINGULAR;
    if (!loft_vec_exact_valid(&x, 1, e->axes) ||
        !loft_exact_quot_real(value(e, &x), loft_exact_hypot(e->normal, e->axes),
                              LOFT_EXACT_HYPOT - LOFT_EXACT_REAL, out))
        return LOFT_ERR_RANGE;
    return LOFT_OK;
}

static enum loft_status normal_of(const equation *e, loft_vec *out)
{
    const loft_vec nothing = { { 0 } };

    if (normal_is_zero(e))
        return LOFT_SINGULAR;
    const loft_exact length = loft_exact_hypot(e->normal, e->axes);
    *out = nothing;
    for (int i = 0; i < e->axes && i < LOFT_AXES; i++)
        if (!loft_exact_quot_real(e->normal[i], length, LOFT_EXACT_HYPOT, &out->axis[i]))
            return LOFT_ERR_RANGE;      /* never: it is at most 1 */
    return LOFT_OK;
}

static enum loft_status numbers_of(const equation *e, loft_real out[])
{
    const loft_exact one = loft_exact_from_int(1);
    const loft_vec origin = { { 0 } };
    loft_real number[4];

    for (int i = 0; i < e->axes; i++)
        if (!loft_exact_quot_real(e->normal[i], one, -e->scale, &number[i]))
            return LOFT_ERR_RANGE;
    if (!loft_exact_quot_real(value(e, &origin), one, -e->scale - LOFT_EXACT_REAL,
                              &number[e->axes]))
        return LOFT_ERR_RANGE;
    for (int i = 0; i <= e->axes; i++)
        out[i] = number[i];
    return LOFT_OK;
}

static bool unit_valid(loft_unit t) { return t >= LOFT_UNIT(-1) && t <= LOFT_UNIT(2); }

/* Differences are below 2^16, and twice as large when multiplied by `at`. */
static enum loft_status point_at(const loft_vec p[], int count, const loft_unit at[], loft_vec *out)
{
    loft_acc x[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc p0 = loft_to_acc(p[0].axis[i]);
        x[i] = p0;
        for (int k = 1; k < count; k++)
            x[i] += loft_acc_scale(loft_to_acc(p[k].axis[i]) - p0, at[k - 1]);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_line_eval(const loft_line *l, loft_unit s, loft_vec *out)
{
    return unit_valid(s) ? point_at(l->p, 2, &s, out) : LOFT_ERR_ARG;
}

enum loft_status loft_facet_eval(const loft_facet *f, loft_unit s, loft_unit t, loft_vec *out)
{
    const loft_unit at[2] = { s, t };
    return unit_valid(s) && unit_valid(t) ? point_at(f->p, 3, at, out) : LOFT_ERR_ARG;
}

enum loft_status loft_line_equation(const loft_line *l, loft_real abc[3])
{
    equation e;
    return line_equation(l, &e) ? numbers_of(&e, abc) : LOFT_ERR_RANGE;
}

enum loft_status loft_facet_equation(const loft_facet *f, loft_real abcd[4])
{
    equation e;
    return facet_equation(f, &e) ? numbers_of(&e, abcd) : LOFT_ERR_RANGE;
}

enum loft_status loft_line_value(const loft_line *l, loft_vec x, loft_real *out)
{
    equation e;
    return line_equation(l, &e) ? value_at(&e, x, out) : LOFT_ERR_RANGE;
}

enum loft_status loft_facet_value(const loft_facet *f, loft_vec x, loft_real *out)
{
    equation e;
    return facet_equation(f, &e) ? value_at(&e, x, out) : LOFT_ERR_RANGE;
}

enum loft_status loft_line_distance(const loft_line *l, loft_vec x, loft_real *out)
{
    equation e;
    return line_equation(l, &e) ? distance_at(&e, x, out) : LOFT_ERR_RANGE;
}

enum loft_status loft_facet_distance(const loft_facet *f, loft_vec x, loft_real *out)
{
    equation e;
    return facet_equation(f, &e) ? distance_at(&e, x, out) : LOFT_ERR_RANGE;
}

enum loft_status loft_line_normal(const loft_line *l, loft_vec *out)
{
    equation e;
    return line_equation(l, &e) ? normal_of(&e, out) : LOFT_ERR_RANGE;
}

enum loft_status loft_facet_normal(const loft_facet *f, loft_vec *out)
{
    equation e;
    return facet_equation(f, &e) ? normal_of(&e, out) : LOFT_ERR_RANGE;
}

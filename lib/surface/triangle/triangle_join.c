/* lib/surface/triangle/triangle_join.c
 * SPDX-License-Identifier: MIT
 *
 * With u + v + w = 1 for T*, c_ijk is the value at T* of the small net of degree i at (0, j, k):
 *
 *     c_ijk = sum over a + b + c = i of i! / (a! b! c!) u^a v^b w^c b_(a, j+b, k+c)
 *
 * It is a whole number over 2^(R + i T), R = LOFT_EXACT_REAL, T = LOFT_EXACT_UNIT. Since |u| + |v|
 * + |w| < 509 < 2^9, it has at most 9 (T + 9) bits more than a coordinate: 329 in q16, 687 in
 * floats. loft_exact has 447 and 1087.
 */
#include "surface/triangle/triangle_join.h"
#include "geom/vec_exact.h"         /* loft_exact: no decision depends on rounding */

#define FARTHEST LOFT_UNIT(127)

typedef struct {
    loft_exact u, v, w;
} weights;

static bool weights_of(loft_bary star, weights *x)
{
    if (!(star.v > -FARTHEST && star.v < FARTHEST && star.w > -FARTHEST && star.w < FARTHEST))
        return false;
    x->v = loft_exact_from_unit(star.v);
    x->w = loft_exact_from_unit(star.w);
    x->u = loft_exact_sub(loft_exact_sub(loft_exact_from_unit(LOFT_UNIT(1)), x->v), x->w);
    return true;
}

static bool points_valid(const loft_triangle *t)
{
    return loft_vec_exact_valid(t->p, LOFT_TRIANGLE_POINTS(t->degree), LOFT_AXES);
}

/* sum over b + c = m of C(m,c) v^b w^c b_(.., j+b, k+c): Horner's scheme in v, with the powers of
 * w. */
static loft_exact line(const loft_triangle *t, int axis, unsigned m, unsigned j, unsigned k,
                       const weights *x)
{
    loft_exact sum = loft_exact_from_int(0), power = loft_exact_from_int(1);

    for (unsigned c = 0; c <= m; c++) {
        const loft_exact p = loft_exact_from_real(
            t->p[loft_triangle_place(j + m - c, k + c)].axis[axis]);
        const loft_exact term = loft_exact_mul(
            loft_exact_mul(loft_exact_from_int(loft_binomial(m, c)), power), p);
        sum = loft_exact_add(loft_exact_mul(sum, x->v), term);
        power = loft_exact_mul(power, x->w);
    }
    return sum;
}

/* c_ijk 2^(R + i T): Horner's scheme in u over the lines. */
static loft_exact beyond(const loft_triangle *t, int axis, unsigned i, unsigned k, const weights *x)
{
    const unsigned j = t->degree - i - k;
    loft_exact sum = loft_exact_from_int(0);

    for (unsigned m = 0; m <= i; m++) {
        const loft_exact part = line(t, axis, m, j, k, x);
        sum = loft_exact_add(loft_exact_mul(sum, x->u),
                             loft_exact_mul(loft_exact_from_int(loft_binomial(i, m)), part));
    }
    return sum;
}

static bool extend_axis(const loft_triangle *t, int axis, unsigned order, const weights *x,
                        loft_vec out[])
{
    for (unsigned i = 0; i <= order; i++)
        for (unsigned k = 0; k <= t->degree - i; k++, out++) {
            const int shift = -LOFT_EXACT_REAL - (int)i * LOFT_EXACT_UNIT;
            loft_acc y;
            if (!loft_exact_quot(beyond(t, axis, i, k, x), loft_exact_from_int(1), shift, &y) ||
                !loft_acc_valid(y))
                return false;
            out->axis[axis] = loft_acc_round(y);
        }
    return true;
}

enum loft_status loft_triangle_join_continue(const loft_triangle *t, loft_bary star, unsigned order,
                                             loft_vec out[])
{
    weights x;

    if (order > t->degree)
        return LOFT_ERR_ARG;
    if (!weights_of(star, &x) || !points_valid(t))
        return LOFT_ERR_RANGE;
    for (int axis = 0; axis < LOFT_AXES; axis++)
        if (!extend_axis(t, axis, order, &x, out))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

/* True if row i agrees. */
static bool agrees(const loft_triangle *b, const loft_triangle *c, unsigned i, const weights *x)
{
    const unsigned m = b->degree - i;

    for (unsigned k = 0; k <= m; k++)
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const loft_exact p = loft_exact_from_real(
                c->p[loft_triangle_place(m - k, k)].axis[axis]);
            if (loft_exact_compare(beyond(b, axis, i, k, x),
                                   loft_exact_shift(p, (int)i * LOFT_EXACT_UNIT)))
                return false;
        }
    return true;
}

enum loft_status loft_triangle_join_order(const loft_triangle *b, const loft_triangle *c,
                                          loft_bary star, int *order)
{
    weights x;
    unsigned rows = 0;

    if (b->degree != c->degree)
        return LOFT_ERR_ARG;
    if (!weights_of(star, &x) || !points_valid(b) || !points_valid(c))
        return LOFT_ERR_RANGE;
    while (rows <= b->degree && agrees(b, c, rows, &x))
        rows++;
    *order = (int)rows - 1;
    return LOFT_OK;
}

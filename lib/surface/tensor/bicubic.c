/* lib/surface/tensor/bicubic.c
 * SPDX-License-Identifier: MIT
 *
 * One axis at a time: along v in each of the four rows, then along u with the results
 * (basis/interp.h).
 *
 * Error in units of 2^-33: the k-th derivative of a cubic by loft_ends3_deriv errs by e = 4, 2, 1,
 * 0 for k = 0..3. It weighs errors of its data by a sum of at most g = 1.25, 5, 20, 36. Together:
 * g(j) e(k) + e(j), at most 9 for a point and 144 for j = 3, k = 0. In LSB that is times 2^-17.
 *
 * Range in q16: the rows give at most 36 * 2^15 < 2^21, which loft_ends3_deriv accepts.
 */
#include "surface/tensor/bicubic.h"
#include "basis/interp.h"       /* loft_ends3_deriv */
#include "geom/vec_exact.h"     /* loft_exact: the join */

static bool unit_valid(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

static void axis_to_acc(const loft_vec p[4], int axis, loft_acc e[4])
{
    for (int b = 0; b < 4; b++)
        e[b] = loft_to_acc(p[b].axis[axis]);
}

enum loft_status loft_bicubic_deriv(const loft_bicubic *b, unsigned j, unsigned k, loft_unit u,
                                    loft_unit v, loft_vec *out)
{
    loft_acc row[4], e[4], x[LOFT_AXES];

    if (!unit_valid(u) || !unit_valid(v))
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        for (int a = 0; a < 4; a++) {
            axis_to_acc(b->at[a], i, row);
            e[a] = loft_ends3_deriv(row, k, v);
        }
        x[i] = loft_ends3_deriv(e, j, u);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_bicubic_eval(const loft_bicubic *b, loft_unit u, loft_unit v, loft_vec *out)
{
    return loft_bicubic_deriv(b, 0, 0, u, v, out);
}

enum loft_status loft_tensor_from_bicubic(const loft_bicubic *b, loft_vec net[16])
{
    loft_acc row[4], along_v[4][4], e[4], c[4];

    for (int i = 0; i < LOFT_AXES; i++) {
        for (int a = 0; a < 4; a++) {
            axis_to_acc(b->at[a], i, row);
            loft_ends3_bernstein(row, along_v[a]);
        }
        for (int column = 0; column < 4; column++) {
            for (int a = 0; a < 4; a++)
                e[a] = along_v[a][column];
            loft_ends3_bernstein(e, c);
            for (int r = 0; r < 4; r++) {
                if (!loft_acc_valid(c[r]))
                    return LOFT_ERR_RANGE;
                net[4 * r + column].axis[i] = loft_acc_round(c[r]);
            }
        }
    }
    return LOFT_OK;
}


/* Joins. Let x be the coordinates in C's last column (derivatives by v at v = 1), y those in A's
 * third. The condition is y = lambda x with x not 0. It holds if y_i x_m = y_m x_i for all i, where
 * x_m is the first x that is not 0: products of two. */

static bool points_valid(const loft_bicubic *b)
{
    for (int a = 0; a < 4; a++)
        if (!loft_vec_exact_valid(b->at[a], 4, LOFT_AXES))
            return false;
    return true;
}

static bool columns_equal(const loft_bicubic *c, int of_c, const loft_bicubic *a, int of_a)
{
    for (int r = 0; r < 4; r++)
        if (!loft_vec_equal(c->at[r][of_c], a->at[r][of_a]))
            return false;
    return true;
}

/* A coordinate of the column, by its place 0 .. 4 LOFT_AXES - 1. */
static loft_exact column_coordinate(const loft_bicubic *b, int column, int place)
{
    return loft_exact_from_real(b->at[place / LOFT_AXES][column].axis[place % LOFT_AXES]);
}

/* The place of the first coordinate that is not 0; 4 LOFT_AXES if all are 0. */
static int first_nonzero(const loft_bicubic *b, int column)
{
    int place = 0;

    while (place < 4 * LOFT_AXES && loft_exact_sign(column_coordinate(b, column, place)) == 0)
        place++;
    return place;
}

static bool columns_proportional(const loft_bicubic *c, const loft_bicubic *a, loft_exact x,
                                 loft_exact y)
{
    for (int i = 0; i < 4 * LOFT_AXES; i++)
        if (loft_exact_sign(
                loft_exact_det(x, y, column_coordinate(c, 3, i), column_coordinate(a, 2, i))) != 0)
            return false;
    return loft_exact_sign(x) * loft_exact_sign(y) > 0;
}

enum loft_status loft_bicubic_join_init(loft_bicubic_join *j, const loft_bicubic *c,
                                        const loft_bicubic *a)
{
    const loft_bicubic_join nothing = { false, false, false, 0 };
    loft_acc lambda;

    *j = nothing;
    if (!points_valid(c) || !points_valid(a))
        return LOFT_ERR_RANGE;
    j->c0 = columns_equal(c, 1, a, 0);
    j->c1 = j->c0 && columns_equal(c, 3, a, 2);
    const int m = first_nonzero(c, 3);
    if (!j->c0 || m == 4 * LOFT_AXES)
        return LOFT_OK;
    const loft_exact x = column_coordinate(c, 3, m), y = column_coordinate(a, 2, m);
    j->g1 = columns_proportional(c, a, x, y);
    if (!j->g1)
        return LOFT_OK;
    if (!loft_exact_quot(y, x, 0, &lambda) || !loft_acc_valid(lambda))
        return LOFT_ERR_RANGE;
    j->lambda = loft_acc_round(lambda);
    return LOFT_OK;
}

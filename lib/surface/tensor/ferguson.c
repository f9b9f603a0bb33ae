/* lib/surface/tensor/ferguson.c
 * SPDX-License-Identifier: MIT
 *
 * A derivative by Bessel is a sum over three neighbours with the weights -1/2, 0, 1/2, or at an end
 * -3/2, 2, -1/2; with two points -1, 1. Twice that is a sum with whole weights. A twist by Bessel
 * is such a sum of such sums. The Coons patch over the cells around a point, from row a to row b
 * and column c to column d, has there the twist
 *
 *     (S_v(b, j) - S_v(a, j)) / (b - a) + (S_u(i, d) - S_u(i, c)) / (d - c)
 *         - (p_bd - p_ad - p_bc + p_ac) / ((b - a) (d - c))
 *
 * where b - a and d - c are 1 or 2. So 4 times a twist is a whole sum, of weights at most 64 in
 * all: below 2^53 in q16, and exact.
 */
#include "surface/tensor/ferguson.h"

/* Three places from `first` on, in one direction, and twice the weights of the derivative. */
typedef struct {
    uint32_t first, count;
    int32_t weight[3];
} stencil;

static stencil stencil_of(uint32_t at, uint32_t count)
{
    const stencil two = { 0, 2, { -2, 2, 0 } }, start = { 0, 3, { -3, 4, -1 } },
                  end = { count - 3, 3, { 1, -4, 3 } }, middle = { at - 1, 3, { -1, 0, 1 } };

    return count == 2 ? two : at == 0 ? start : at == count - 1 ? end : middle;
}

typedef struct {
    const loft_vec *p;
    uint32_t rows, columns;
    int axis;
} point_grid;

static loft_acc grid_at(const point_grid *g, uint32_t i, uint32_t j)
{
    return loft_to_acc(g->p[(size_t)i * g->columns + j].axis[g->axis]);
}

/* Twice the derivative at (i, j), by u or by v. */
static loft_acc twice_by(const point_grid *g, uint32_t i, uint32_t j, bool v)
{
    const stencil s = v ? stencil_of(j, g->columns) : stencil_of(i, g->rows);
    loft_acc sum = 0;

    for (uint32_t k = 0; k < s.count; k++)
        sum += s.weight[k] * (v ? grid_at(g, i, s.first + k) : grid_at(g, s.first + k, j));
    return sum;
}

static loft_acc bessel_twist(const point_grid *g, uint32_t i, uint32_t j)
{
    const stencil s = stencil_of(i, g->rows);
    loft_acc sum = 0;

    for (uint32_t k = 0; k < s.count; k++)
        sum += s.weight[k] * twice_by(g, s.first + k, j, true);
    return sum;
}

static loft_acc adini_twist(const point_grid *g, uint32_t i, uint32_t j)
{
    const uint32_t a = i > 0 ? i - 1 : 0, b = i + 1 < g->rows ? i + 1 : i, c = j > 0 ? j - 1 : 0,
                   d = j + 1 < g->columns ? j + 1 : j;
    const int32_t wide = 2 / (int32_t)(b - a), high = 2 / (int32_t)(d - c);     /* 1 or 2 */
    const loft_acc by_v = twice_by(g, b, j, true) - twice_by(g, a, j, true),
                   by_u = twice_by(g, i, d, false) - twice_by(g, i, c, false),
                   turn = grid_at(g, b, d) - grid_at(g, a, d) - grid_at(g, b, c) + grid_at(g, a, c);

    return wide * by_v + high * by_u - wide * high * turn;
}

/* Value, derivative by u, by v, and twist of one axis. */
static void data_at(const point_grid *g, uint32_t i, uint32_t j, enum loft_twist twist,
                    loft_acc out[4])
{
    const loft_acc four = twist == LOFT_TWIST_ZERO    ? 0
                          : twist == LOFT_TWIST_ADINI ? adini_twist(g, i, j)
                                                      : bessel_twist(g, i, j);
    out[0] = grid_at(g, i, j);
    out[1] = loft_acc_ratio(twice_by(g, i, j, false), 2);
    out[2] = loft_acc_ratio(twice_by(g, i, j, true), 2);
    out[3] = loft_acc_ratio(four, 4);
}

enum loft_status loft_bicubic_from_grid(const loft_vec p[], uint32_t rows, uint32_t columns,
                                        uint32_t i, uint32_t j, enum loft_twist twist,
                                        loft_bicubic *out)
{
    loft_bicubic made;
    loft_acc x[4];

    if (rows < 2 || columns < 2 || i >= rows - 1 || j >= columns - 1 ||
        (unsigned)twist > LOFT_TWIST_BESSEL)
        return LOFT_ERR_ARG;
    for (uint32_t corner = 0; corner < 4; corner++)
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const uint32_t a = corner / 2, b = corner % 2;
            const point_grid g = { p, rows, columns, axis };
            data_at(&g, i + a, j + b, twist, x);
            for (uint32_t k = 0; k < 4; k++) {
                if (!loft_acc_valid(x[k]))
                    return LOFT_ERR_RANGE;
                made.at[a + 2 * (k % 2)][b + 2 * (k / 2)].axis[axis] = loft_acc_round(x[k]);
            }
        }
    *out = made;
    return LOFT_OK;
}

/* lib/surface/tensor/gordon.c
 * SPDX-License-Identifier: MIT
 *
 * The natural spline through values y has second derivatives M with T M = R y: T has the diagonal
 * 2 (h_(i-1) + h_i) and h_i beside it, R the rows 6 / h_(i-1), -6 / h_(i-1) - 6 / h_i, 6 / h_i. In
 * piece k, with b = (x - x_k) / h_k and a = 1 - b,
 *
 *     s(x) = a y_k + b y_(k+1) + h^2 / 6 ((a^3 - a) M_k + (b^3 - b) M_(k+1)) = e y + d M
 *
 * So s(x) = (e + R' T^-1 d) y: the weights of all y come from one tridiagonal system, since T is
 * symmetric. T is diagonally dominant, so a solution errs by a few roundings of its largest term.
 */
#include "surface/tensor/gordon.h"
#include "num/sci.h"            /* loft_sci */

#define MOST (LOFT_DEGREE_MAX + 1)

static bool unit_within(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

static loft_sci step_of(const loft_unit at[], unsigned k)
{
    return loft_sci_sub(loft_sci_from_unit(at[k + 1]), loft_sci_from_unit(at[k]));
}

/* The piece of x: at a knot that behind it, at the end the last one. */
static unsigned piece_at(const loft_unit at[], unsigned count, loft_unit x)
{
    unsigned k = 0;

    while (k + 2 < count && at[k + 1] <= x)
        k++;
    return k;
}

/* e and d of the value (order 0) or the derivative (order 1) at x, of piece k. */
static void spline_rows(loft_sci h, loft_sci b, unsigned order, loft_sci e[2], loft_sci d[2])
{
    const loft_sci one = loft_sci_one(), a = loft_sci_sub(one, b), three = loft_sci_from_int(3),
                   sixth = loft_sci_div(h, loft_sci_from_int(6)), at[2] = { a, b };

    for (unsigned i = 0; i < 2; i++) {
        const loft_sci square = loft_sci_mul(at[i], at[i]);
        e[i] = order == 0 ? at[i] : loft_sci_div(i ? one : loft_sci_neg(one), h);
        if (order == 0)
            d[i] = loft_sci_mul(loft_sci_mul(h, sixth),
                                loft_sci_mul(at[i], loft_sci_sub(square, one)));
        else
            d[i] = loft_sci_mul(i ? sixth : loft_sci_neg(sixth),
                                loft_sci_sub(loft_sci_mul(three, square), one));
    }
}

/* Solve T z = d for the inner knots 1 .. count - 2; d becomes z. */
static void solve_inner(const loft_unit at[], unsigned count, loft_sci d[])
{
    const loft_sci two = loft_sci_from_int(2);
    loft_sci c[LOFT_GORDON_MAX], last = loft_sci_zero();

    for (unsigned i = 1; i + 1 < count; i++) {
        const loft_sci before = step_of(at, i - 1), behind = step_of(at, i);
        loft_sci den = loft_sci_mul(two, loft_sci_add(before, behind)), x = d[i];
        if (i > 1) {
            den = loft_sci_sub(den, loft_sci_mul(before, last));
            x = loft_sci_sub(x, loft_sci_mul(before, d[i - 1]));
        }
        c[i] = last = loft_sci_div(behind, den);
        d[i] = loft_sci_div(x, den);
    }
    for (unsigned i = count - 2; i > 1; i--)
        d[i - 1] = loft_sci_sub(d[i - 1], loft_sci_mul(c[i - 1], d[i]));
}

/* The weights at x, from piece k. */
static void blend_weights(const loft_unit at[], unsigned count, unsigned k, loft_unit x,
                          unsigned order, loft_sci out[])
{
    const loft_sci h = step_of(at, k), six = loft_sci_from_int(6),
                   b = loft_sci_div(loft_sci_sub(loft_sci_from_unit(x), loft_sci_from_unit(at[k])),
                                    h);
    loft_sci e[2], d[2], z[LOFT_GORDON_MAX];

    spline_rows(h, b, order, e, d);
    for (unsigned i = 0; i < count; i++) {
        z[i] = i == k ? d[0] : i == k + 1 ? d[1] : loft_sci_zero();
        out[i] = i == k ? e[0] : i == k + 1 ? e[1] : loft_sci_zero();
    }
    solve_inner(at, count, z);
    for (unsigned i = 1; i + 1 < count; i++) {
        const loft_sci before = loft_sci_mul(loft_sci_div(six, step_of(at, i - 1)), z[i]),
                       behind = loft_sci_mul(loft_sci_div(six, step_of(at, i)), z[i]);
        out[i - 1] = loft_sci_add(out[i - 1], before);
        out[i] = loft_sci_sub(out[i], loft_sci_add(before, behind));
        out[i + 1] = loft_sci_add(out[i + 1], behind);
    }
}


// The network
// -----------

static bool parameters_ascend(const loft_unit at[], unsigned count)
{
    if (count < 2 || count > LOFT_GORDON_MAX || at[0] < 0 || at[0] > 0 ||
        at[count - 1] < LOFT_UNIT(1) || at[count - 1] > LOFT_UNIT(1))
        return false;
    for (unsigned k = 0; k + 1 < count; k++)
        if (!(at[k] < at[k + 1]))
            return false;
    return true;
}

enum loft_status loft_gordon_init(loft_gordon *g, const loft_side along_u[], const loft_unit v[],
                                  unsigned columns, const loft_side along_v[], const loft_unit u[],
                                  unsigned rows, loft_real tol, loft_gordon_point memory[])
{
    const loft_gordon made = { along_u, along_v, u, v, memory, (uint8_t)rows, (uint8_t)columns };
    loft_acc other[LOFT_AXES];

    if (!parameters_ascend(u, rows) || !parameters_ascend(v, columns) || !(tol >= 0))
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i < rows; i++)
        for (unsigned j = 0; j < columns; j++) {
            loft_acc *here = memory[columns * i + j].axis;
            along_u[j].eval(along_u[j].curve, u[i], here);
            along_v[i].eval(along_v[i].curve, v[j], other);
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                const loft_acc off = here[axis] - other[axis];
                if (!((off < 0 ? -off : off) <= loft_to_acc(tol)))
                    return LOFT_ERR_ARG;
            }
        }
    *g = made;
    return LOFT_OK;
}

/* One axis of the Boolean sum: weights f and g, points of the curves. */
static loft_sci boolean_sum(const loft_gordon *g, const loft_sci f[], const loft_sci by_u[],
                            const loft_sci g_i[], const loft_sci by_v[], int axis)
{
    loft_sci sum = loft_sci_zero();

    for (unsigned j = 0; j < g->columns; j++)
        sum = loft_sci_add(sum, loft_sci_mul(f[j], by_u[j]));
    for (unsigned i = 0; i < g->rows; i++) {
        loft_sci rest = by_v[i];
        for (unsigned j = 0; j < g->columns; j++)
            rest = loft_sci_sub(
                rest, loft_sci_mul(f[j], loft_sci_of(g->crossing[g->columns * i + j].axis[axis])));
        sum = loft_sci_add(sum, loft_sci_mul(g_i[i], rest));
    }
    return sum;
}

enum loft_status loft_gordon_eval(const loft_gordon *g, loft_unit s, loft_unit t, loft_vec *out)
{
    loft_sci f[LOFT_GORDON_MAX], g_i[LOFT_GORDON_MAX], by_u[LOFT_AXES][LOFT_GORDON_MAX],
        by_v[LOFT_AXES][LOFT_GORDON_MAX];
    loft_acc x[LOFT_AXES];

    if (!unit_within(s) || !unit_within(t))
        return LOFT_ERR_ARG;
    blend_weights(g->v, g->columns, piece_at(g->v, g->columns, t), t, 0, f);
    blend_weights(g->u, g->rows, piece_at(g->u, g->rows, s), s, 0, g_i);
    for (unsigned j = 0; j < g->columns; j++) {
        g->along_u[j].eval(g->along_u[j].curve, s, x);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            by_u[axis][j] = loft_sci_of(x[axis]);
    }
    for (unsigned i = 0; i < g->rows; i++) {
        g->along_v[i].eval(g->along_v[i].curve, t, x);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            by_v[axis][i] = loft_sci_of(x[axis]);
    }
    for (int axis = 0; axis < LOFT_AXES; axis++)
        if (!loft_sci_to_acc(boolean_sum(g, f, by_u[axis], g_i, by_v[axis], axis), &x[axis]))
            return LOFT_ERR_RANGE;
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}


// Tensor patches
// --------------

/* Raise Bernstein coefficients from degree n to m, in place. */
static void raise_to(loft_sci c[], unsigned n, unsigned m)
{
    for (; n < m; n++) {
        const loft_sci whole = loft_sci_from_int((int32_t)n + 1);
        c[n + 1] = c[n];
        for (unsigned k = n; k > 0; k--)
            c[k] = loft_sci_lerp(c[k], c[k - 1],
                                 loft_sci_div(loft_sci_from_int((int32_t)k), whole));
    }
}

/* The Bernstein coefficients of all weights over from..to, which is within piece k: c[knot][..]. */
static void blend_nets(const loft_unit at[], unsigned count, unsigned k, loft_unit from,
                       loft_unit to, unsigned degree, loft_sci c[][MOST])
{
    const loft_sci third = loft_sci_div(
        loft_sci_sub(loft_sci_from_unit(to), loft_sci_from_unit(from)), loft_sci_from_int(3));
    const loft_unit end[2] = { from, to };
    loft_sci value[LOFT_GORDON_MAX], slope[LOFT_GORDON_MAX];

    for (unsigned side = 0; side < 2; side++) {
        blend_weights(at, count, k, end[side], 0, value);
        blend_weights(at, count, k, end[side], 1, slope);
        for (unsigned i = 0; i < count; i++) {
            const loft_sci leg = loft_sci_mul(third, slope[i]);
            c[i][3 * side] = value[i];
            c[i][1 + side] = side ? loft_sci_sub(value[i], leg) : loft_sci_add(value[i], leg);
        }
    }
    for (unsigned i = 0; i < count; i++)
        raise_to(c[i], 3, degree);
}

static void piece_net(const loft_bezier *b, int axis, unsigned degree, loft_sci c[])
{
    for (unsigned k = 0; k <= b->degree; k++)
        c[k] = loft_sci_from_real(b->p[k].axis[axis]);
    raise_to(c, b->degree, degree);
}

static bool part_valid(const loft_unit at[], unsigned count, loft_unit from, loft_unit to)
{
    return from >= 0 && from < to && to <= LOFT_UNIT(1) && to <= at[piece_at(at, count, from) + 1];
}

static bool pieces_valid(const loft_bezier b[], unsigned count, unsigned degree)
{
    for (unsigned k = 0; k < count; k++)
        if (b[k].degree > degree)
            return false;
    return degree >= 3 && degree <= LOFT_DEGREE_MAX;
}

enum loft_status loft_tensor_from_gordon(const loft_gordon *g, const loft_bezier along_u[],
                                         const loft_bezier along_v[], const loft_unit from[2],
                                         const loft_unit to[2], unsigned m, unsigned n,
                                         loft_vec out[])
{
    loft_sci f[LOFT_GORDON_MAX][MOST], g_i[LOFT_GORDON_MAX][MOST], row[LOFT_GORDON_MAX],
        column[LOFT_GORDON_MAX], by_u[LOFT_GORDON_MAX][MOST], by_v[LOFT_GORDON_MAX][MOST];
    loft_sci weight[2][LOFT_GORDON_MAX];
    loft_acc x;

    if (!part_valid(g->u, g->rows, from[0], to[0]) ||
        !part_valid(g->v, g->columns, from[1], to[1]) || !pieces_valid(along_u, g->columns, m) ||
        !pieces_valid(along_v, g->rows, n))
        return LOFT_ERR_ARG;
    blend_nets(g->u, g->rows, piece_at(g->u, g->rows, from[0]), from[0], to[0], m, g_i);
    blend_nets(g->v, g->columns, piece_at(g->v, g->columns, from[1]), from[1], to[1], n, f);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        for (unsigned j = 0; j < g->columns; j++)
            piece_net(&along_u[j], axis, m, by_u[j]);
        for (unsigned i = 0; i < g->rows; i++)
            piece_net(&along_v[i], axis, n, by_v[i]);
        for (unsigned k = 0; k < (m + 1) * (n + 1); k++) {
            const unsigned a = k / (n + 1), b = k % (n + 1);
            for (unsigned j = 0; j < g->columns; j++) {
                weight[0][j] = f[j][b];
                row[j] = by_u[j][a];
            }
            for (unsigned i = 0; i < g->rows; i++) {
                weight[1][i] = g_i[i][a];
                column[i] = by_v[i][b];
            }
            if (!loft_sci_to_acc(boolean_sum(g, weight[0], row, weight[1], column, axis), &x) ||
                !loft_acc_valid(x))
                return LOFT_ERR_RANGE;
            out[k].axis[axis] = loft_acc_round(x);
        }
    }
    return LOFT_OK;
}

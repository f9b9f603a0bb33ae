/* lib/polygon/toric_tensor.c
 * SPDX-License-Identifier: MIT
 *
 * h_i(l) = n_i . l + o_i. So the basis function of a whole point is a common factor times a
 * monomial, with X = prod h_i^n_i(1), Y = prod h_i^n_i(2):
 *
 *     B_l = c_l prod h_i^(n_i . l + o_i) = c_l (prod h_i^o_i) X^l_1 Y^l_2
 *
 * p -> (log X, log Y) is the gradient of the convex function sum h_i log h_i - h_i, and maps the
 * inside of the polygon one to one to the plane. The normals of the edges cut the plane into one
 * cone for each vertex, the normal fan. In that of vertex k, turned round,
 *
 *     (log X, log Y) = log s n_(k-1) + log t n_k,   0 < s, t <= 1
 *     X^l_1 Y^l_2    = s^(n_(k-1) . l) t^(n_k . l) = const s^h_(k-1)(l) t^h_k(l)
 *
 * which are whole powers from 0 (on the edges) to the largest heights m, n: the patch is a tensor
 * product of these degrees, whatever the angle at the vertex.
 *
 * Bernstein coefficients. s^a = sum over i of C(i,a) / C(m,a) B_i^m(s). C(i,a) are binomial
 * transforms: m passes of sums of neighbours. All weights are positive, and a point is an average
 * of those of the toric patch, so nothing cancels.
 *
 * Weights. At s = t = 1 the sum of weights is C, on edge k, at s = 1, C_k. s = u / (u + a (1 - u))
 * keeps 0 and 1 and multiplies weight (i, j) by a^(m - i). a^m = C / C_(k-1) makes those at the
 * ends of the line t = 1 equal; since it depends on the edge alone, neighbours agree. Of the whole
 * triangle with multinomials the weights are then within (4/3)^degree instead of 3^degree.
 *
 * An error e of all weights moves the surface by at most e E / v: the numerator, seen from the
 * point, changes by e sum B_ij |P_ij - P| <= e E.
 */
#include "polygon/toric_tensor.h"

typedef struct {
    unsigned m, n, edge[2];                     /* edge[0] is k - 1, of height i; edge[1] is k */
    loft_sci w[LOFT_TORIC_TENSOR_MAX], x[LOFT_TORIC_TENSOR_MAX];
} work;

static unsigned height_of(const loft_lattice_polygon *p, unsigned edge, loft_whole l)
{
    return (unsigned)loft_lattice_polygon_height(p, edge, l);
}

static unsigned degree_of(const loft_lattice_polygon *p, unsigned edge)
{
    unsigned most = 0;

    for (unsigned k = 0; k < p->sides; k++) {
        const unsigned h = height_of(p, edge, p->edge[k].from);
        most = h > most ? h : most;
    }
    return most;
}

/* c[0], c[stride] ..: sums of C(i, a) c_a. */
static void transform_line(loft_sci c[], unsigned degree, unsigned stride)
{
    for (unsigned pass = 1; pass <= degree; pass++)
        for (unsigned i = degree; i >= pass; i--)
            c[i * stride] = loft_sci_add(c[i * stride], c[(i - 1) * stride]);
}

/* The coefficients of one axis, or of the weights (axis LOFT_AXES). */
static void load_axis(const loft_toric *t, int axis, const work *x, loft_sci out[])
{
    const unsigned row = x->n + 1;
    loft_whole l;
    unsigned k = 0;

    for (unsigned i = 0; i < (x->m + 1) * row; i++)
        out[i] = loft_sci_zero();
    loft_lattice_polygon_first(t->lattice, &l);
    do {
        const unsigned a = height_of(t->lattice, x->edge[0], l),
                       b = height_of(t->lattice, x->edge[1], l);
        const int32_t ways = loft_binomial(x->m, a) * loft_binomial(x->n, b);
        loft_sci term = loft_sci_div(loft_toric_factor(t, k), loft_sci_from_int(ways));
        if (axis < LOFT_AXES)
            term = loft_sci_mul(term, loft_sci_from_real(t->p[k].axis[axis]));
        out[a * row + b] = term;
        k++;
    } while (loft_lattice_polygon_next(t->lattice, &l));
    for (unsigned j = 0; j <= x->n; j++)
        transform_line(out + j, x->m, row);
    for (unsigned i = 0; i <= x->m; i++)
        transform_line(out + i * row, x->n, 1);
}

/* r^(1/degree) of r >= 1, by Newton's method from a power of 2 that is at most twice as large. */
static loft_sci root_of(loft_sci r, unsigned degree)
{
    const loft_sci all = loft_sci_from_int((int32_t)degree);
    loft_sci x         = loft_sci_one();

    while (loft_sci_less(loft_sci_pow(x, degree), r))
        x = loft_sci_add(x, x);
    for (int step = 0; step < 16; step++) {
        const loft_sci over = loft_sci_sub(x, loft_sci_div(r, loft_sci_pow(x, degree - 1)));
        x = loft_sci_sub(x, loft_sci_div(over, all));
    }
    return x;
}

loft_sci loft_toric_balance(const loft_toric *t, unsigned edge)
{
    loft_sci all = loft_sci_zero(), on = all;
    loft_whole l;
    unsigned k = 0;

    loft_lattice_polygon_first(t->lattice, &l);
    do {
        const loft_sci factor = loft_toric_factor(t, k++);
        all = loft_sci_add(all, factor);
        if (height_of(t->lattice, edge, l) == 0)
            on = loft_sci_add(on, factor);
    } while (loft_lattice_polygon_next(t->lattice, &l));
    return root_of(loft_sci_div(all, on), degree_of(t->lattice, edge));
}

/* Multiply weight (i, j) by a^(m - i) b^(n - j). */
static void balance_weights(const loft_toric *t, work *x)
{
    const loft_sci a = loft_toric_balance(t, x->edge[0]), b = loft_toric_balance(t, x->edge[1]);
    loft_sci power = loft_sci_one();

    for (unsigned i = x->m + 1; i-- > 0; power = loft_sci_mul(power, a)) {
        loft_sci both = power;
        for (unsigned j = x->n + 1; j-- > 0; both = loft_sci_mul(both, b)) {
            loft_sci *at = &x->w[i * (x->n + 1) + j];
            *at = loft_sci_mul(*at, both);
        }
    }
}

/* By a power of 2, the largest to 128..256. */
static bool set_weights(const loft_sci w[], unsigned count, loft_weighted out[])
{
    const loft_sci two = loft_sci_from_int(2), top = loft_sci_from_int(256);
    loft_sci most = w[0], scale = loft_sci_one();

    for (unsigned k = 1; k < count; k++)
        most = loft_sci_larger(most, w[k]);
    for (; !loft_sci_less(most, top); most = loft_sci_div(most, two))
        scale = loft_sci_div(scale, two);
    for (; loft_sci_less(loft_sci_mul(most, two), top); most = loft_sci_mul(most, two))
        scale = loft_sci_mul(scale, two);
    for (unsigned k = 0; k < count; k++) {
        loft_acc weight;
        if (!loft_sci_to_acc(loft_sci_mul(w[k], scale), &weight))
            return false;
        out[k].w = loft_acc_round(weight);
        if (!(out[k].w >= LOFT_WEIGHT_MIN))
            return false;
    }
    return true;
}

enum loft_status loft_toric_tensor(const loft_toric *t, unsigned vertex, loft_weighted out[],
                                   loft_tensor_rational *s)
{
    const unsigned sides = t->lattice->sides;
    work x;

    if (vertex >= sides)
        return LOFT_ERR_ARG;
    x.edge[0] = vertex ? vertex - 1 : sides - 1;
    x.edge[1] = vertex;
    x.m = degree_of(t->lattice, x.edge[0]);
    x.n = degree_of(t->lattice, x.edge[1]);
    if (x.m > LOFT_DEGREE_MAX || x.n > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    const unsigned count = (x.m + 1) * (x.n + 1);
    load_axis(t, LOFT_AXES, &x, x.w);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        load_axis(t, axis, &x, x.x);
        for (unsigned k = 0; k < count; k++) {
            loft_acc at;
            if (!loft_sci_to_acc(loft_sci_div(x.x[k], x.w[k]), &at) || !loft_acc_valid(at))
                return LOFT_ERR_RANGE;
            out[k].p.axis[axis] = loft_acc_round(at);
        }
    }
    balance_weights(t, &x);
    if (!set_weights(x.w, count, out))
        return LOFT_ERR_RANGE;
    return loft_tensor_rational_init(s, out, x.m, x.n);
}

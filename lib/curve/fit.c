/* lib/curve/fit.c
 * SPDX-License-Identifier: MIT
 *
 * The control points c solve the normal equations A c = b with
 *
 *     A_ij = sum w N_i(u) N_j(u)        b_i = sum w N_i(u) p
 *
 * of which only j = i - degree .. i + degree are not 0. A is symmetric, and positive definite if
 * the points tell all control points (Schoenberg and Whitney). Cholesky A = L L^T keeps the band
 * and needs no pivots; what it solves is A + E with |E| at most (degree + 2) roundings of |L|
 * |L|^T, whose entries are at most the largest A_ii <= W: (degree + 2) (2 degree + 1) roundings of
 * L W in each row. Sums of positive terms over all points err by one rounding for each point.
 *
 * Of a closed curve the last `degree` control points are the first ones again, so the unknowns are
 * m = points - degree and indices count modulo m. The last `degree` rows then meet the first
 * columns: they are kept whole, from the first column on, and fill with what elimination adds.
 *
 * An end that is kept is a known number: its row says so, and its terms go to the right side.
 */
#include "curve/fit.h"
#include "basis/knots_basis.h"  /* loft_knots_basis */
#include "num/exact.h"          /* loft_exact_valid */

typedef struct {
    loft_knots knots;
    unsigned unknowns;
    bool closed;
    loft_sci *band;             /* row i: A_ij for j = i - degree .. i               */
    loft_sci *whole;            /* closed, the last `degree` rows: j = 0 .. i        */
    loft_sci *right;            /* LOFT_AXES in a row                                */
} system_of;

static bool row_is_whole(const system_of *s, unsigned i)
{
    return s->closed && i + s->knots.degree >= s->unknowns;
}

static unsigned first_column(const system_of *s, unsigned i)
{
    return row_is_whole(s, i) || i < s->knots.degree ? 0 : i - s->knots.degree;
}

/* A_ij for j <= i and j >= first_column. */
static loft_sci *entry(const system_of *s, unsigned i, unsigned j)
{
    const unsigned degree = s->knots.degree;

    return row_is_whole(s, i) ? &s->whole[(i + degree - s->unknowns) * s->unknowns + j]
                              : &s->band[i * (degree + 1) + (j + degree - i)];
}

static loft_sci *right_of(const system_of *s, unsigned i) { return &s->right[i * LOFT_AXES]; }

static void clear_system(const system_of *s)
{
    for (unsigned i = 0; i < s->unknowns; i++) {
        for (unsigned j = first_column(s, i); j <= i; j++)
            *entry(s, i, j) = loft_sci_zero();
        for (int axis = 0; axis < LOFT_AXES; axis++)
            right_of(s, i)[axis] = loft_sci_zero();
    }
}


// The equations
// -------------

/* Add w N_i N_j and w N_i p of one point. */
static void add_point(const system_of *s, unsigned span, const loft_sci n[], loft_sci weight,
                      const loft_vec *p)
{
    const unsigned degree = s->knots.degree;

    for (unsigned r = 0; r <= degree; r++) {
        const unsigned i = (span - degree + r) % s->unknowns;
        const loft_sci scaled = loft_sci_mul(weight, n[r]);
        loft_sci *right = right_of(s, i);
        for (unsigned q = 0; q <= degree; q++) {
            const unsigned j = (span - degree + q) % s->unknowns;
            if (j <= i)
                *entry(s, i, j) = loft_sci_add(*entry(s, i, j), loft_sci_mul(scaled, n[q]));
        }
        for (int axis = 0; axis < LOFT_AXES; axis++)
            right[axis] = loft_sci_add(right[axis],
                                       loft_sci_mul(scaled, loft_sci_from_real(p->axis[axis])));
    }
}

static void set_equations(const system_of *s, const loft_fit_points *data)
{
    loft_sci n[LOFT_DEGREE_MAX + 1];

    clear_system(s);
    for (uint32_t k = 0; k < data->count; k++) {
        const unsigned span = loft_knots_find(&s->knots, data->u[k]);
        loft_knots_basis(&s->knots, span, data->u[k], 0, n);
        add_point(s, span, n, data->weight ? loft_sci_from_real(data->weight[k]) : loft_sci_one(),
                  &data->p[k]);
    }
}

/* The first and the last control point are known. */
static void keep_end(const system_of *s, unsigned end, const loft_vec *p)
{
    const unsigned degree = s->knots.degree, from = end > degree ? end - degree : 0;

    for (unsigned i = from; i < s->unknowns && i <= end + degree; i++) {
        loft_sci *a = i < end ? entry(s, end, i) : entry(s, i, end);
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const loft_sci at = loft_sci_from_real(p->axis[axis]);
            loft_sci *right = &right_of(s, i)[axis];
            *right = i == end ? at : loft_sci_sub_product(*right, *a, at);
        }
        *a = i == end ? loft_sci_one() : loft_sci_zero();
    }
}


// The solution
// ------------

/* True if the pivot is so small that rounding may have made it. */
static bool pivot_is_lost(loft_sci pivot, loft_sci before)
{
    const loft_sci part = loft_sci_div(before, loft_sci_pow(loft_sci_from_int(2), 44));

    return loft_sci_sign(before) <= 0 || !loft_sci_less(part, pivot);
}

/* L in place of A. False: not positive definite. */
static bool factor_system(const system_of *s)
{
    for (unsigned i = 0; i < s->unknowns; i++) {
        const unsigned from = first_column(s, i);
        const loft_sci before = *entry(s, i, i);
        for (unsigned j = from; j <= i; j++) {
            const unsigned low = first_column(s, j) > from ? first_column(s, j) : from;
            loft_sci sum = *entry(s, i, j);
            for (unsigned k = low; k < j; k++)
                sum = loft_sci_sub_product(sum, *entry(s, i, k), *entry(s, j, k));
            if (j < i)
                *entry(s, i, j) = loft_sci_div(sum, *entry(s, j, j));
            else if (pivot_is_lost(sum, before))
                return false;
            else
                *entry(s, i, i) = loft_sci_sqrt(sum);
        }
    }
    return true;
}

static void solve_axis(const system_of *s, int axis)
{
    for (unsigned i = 0; i < s->unknowns; i++) {
        loft_sci *x = &right_of(s, i)[axis];
        for (unsigned j = first_column(s, i); j < i; j++)
            *x = loft_sci_sub_product(*x, *entry(s, i, j), right_of(s, j)[axis]);
        *x = loft_sci_div(*x, *entry(s, i, i));
    }
    for (unsigned i = s->unknowns; i-- > 0; ) {
        loft_sci *x = &right_of(s, i)[axis];
        *x = loft_sci_div(*x, *entry(s, i, i));
        for (unsigned j = first_column(s, i); j < i; j++)
            right_of(s, j)[axis] = loft_sci_sub_product(right_of(s, j)[axis], *entry(s, i, j), *x);
    }
}

static bool round_point(const loft_sci x[LOFT_AXES], loft_vec *out)
{
    loft_acc wide[LOFT_AXES];

    for (int axis = 0; axis < LOFT_AXES; axis++)
        if (!loft_sci_to_acc(x[axis], &wide[axis]))
            return false;
    return loft_vec_round(wide, out);
}


// What is given
// -------------

static bool data_valid(const loft_fit_points *data)
{
    for (uint32_t k = 0; k < data->count; k++) {
        for (int axis = 0; axis < LOFT_AXES; axis++)
            if (!loft_real_valid(data->p[k].axis[axis]))
                return false;
        if (data->weight && !loft_real_valid(data->weight[k]))
            return false;
    }
    return true;
}

static bool data_in_order(const loft_fit_points *data, loft_real from, loft_real to, bool closed)
{
    if (data->count < 2 || !(data->u[0] >= from && data->u[data->count - 1] <= to))
        return false;
    if (!closed && (data->u[0] > from || data->u[data->count - 1] < to))
        return false;
    for (uint32_t k = 0; k < data->count; k++) {
        if (k > 0 && !(data->u[k] >= data->u[k - 1]))
            return false;
        if (data->weight && !(data->weight[k] > 0))
            return false;
    }
    return true;
}

/* Ends that the curve reaches: all their knots are one. */
static bool knots_clamped(const loft_knots *k)
{
    return !(k->k[0] < k->k[k->degree]) && !(k->k[k->points] < k->k[k->points + k->degree]);
}

enum loft_status loft_bspline_fit(const loft_fit_points *data, const loft_real knots[],
                                  unsigned points, unsigned degree, bool closed, loft_vec out[],
                                  loft_sci memory[])
{
    system_of s = { .closed = closed };
    enum loft_status status = loft_knots_init(&s.knots, knots, points, degree);

    if (status != LOFT_OK)
        return status;
    if (closed ? points <= 2 * degree : !knots_clamped(&s.knots))
        return LOFT_ERR_ARG;
    if (!data_in_order(data, knots[degree], knots[points], closed))
        return LOFT_ERR_ARG;
    if (!data_valid(data))
        return LOFT_ERR_RANGE;
    s.unknowns = closed ? points - degree : points;
    s.band     = memory;
    s.right    = memory + s.unknowns * (degree + 1);
    s.whole    = s.right + s.unknowns * LOFT_AXES;
    set_equations(&s, data);
    if (!closed) {
        keep_end(&s, 0, &data->p[0]);
        keep_end(&s, points - 1, &data->p[data->count - 1]);
    }
    if (!factor_system(&s))
        return LOFT_SINGULAR;
    for (int axis = 0; axis < LOFT_AXES; axis++)
        solve_axis(&s, axis);
    for (unsigned i = 0; i < points; i++)
        if (!round_point(right_of(&s, i % s.unknowns), &out[i]))
            return LOFT_ERR_RANGE;
    if (!closed) {
        out[0] = data->p[0];
        out[points - 1] = data->p[data->count - 1];
    }
    return LOFT_OK;
}

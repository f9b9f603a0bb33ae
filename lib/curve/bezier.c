/* lib/curve/bezier.c
 * SPDX-License-Identifier: MIT
 *
 * Every function processes one axis at a time: it converts the coefficients to loft_acc, applies de
 * Casteljau's scheme, and rounds once at the end. Range and error of the scheme are proved in
 * basis/bernstein.c:
 *
 *     |value| < 2^61.3 of 2^63
 *     error e_n = 2^-33 (1 + L + .. + L^(n-1)),   L = |1 - t| + |t| <= 3
 *
 * in real units. In LSB (2^-16) that is 2^-17 (1 + L + ..), at most 0.08, and the rounding adds
 * 1/2.
 */
#include "curve/bezier.h"

static bool parameter_valid(loft_unit t) { return t >= LOFT_UNIT(-1) && t <= LOFT_UNIT(2); }

/* Round to a coordinate, if it fits. */
static bool round_coordinate(loft_acc x, loft_real *out)
{
    if (!loft_acc_valid(x))
        return false;
    *out = loft_acc_round(x);
    return true;
}

static void widen_axis(const loft_vec p[], unsigned degree, int axis, loft_acc c[])
{
    for (unsigned k = 0; k <= degree; k++)
        c[k] = loft_to_acc(p[k].axis[axis]);
}

static bool round_axis(const loft_acc c[], unsigned degree, int axis, loft_vec out[])
{
    for (unsigned k = 0; k <= degree; k++)
        if (!round_coordinate(c[k], &out[k].axis[axis]))
            return false;
    return true;
}


/* Points */

enum loft_status loft_bezier_init(loft_bezier *b, const loft_vec p[], unsigned degree)
{
    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k <= degree; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            /* infinities and nans; in q16 everything fits */
            if (!loft_acc_valid(loft_to_acc(p[k].axis[i])))
                return LOFT_ERR_RANGE;
    b->p = p;
    b->degree = (uint8_t)degree;
    return LOFT_OK;
}

loft_vec loft_bezier_eval(const loft_bezier *b, loft_unit t)
{
    loft_acc c[LOFT_DEGREE_MAX + 1];
    loft_vec v;

    t = loft_unit_clamp(t);
    for (int i = 0; i < LOFT_AXES; i++) {
        widen_axis(b->p, b->degree, i, c);
        v.axis[i] = loft_acc_round(loft_bernstein_eval(c, b->degree, t));
    }
    return v;
}

enum loft_status loft_bezier_extrapolate(const loft_bezier *b, loft_unit t, loft_vec *out)
{
    return loft_bezier_deriv(b, 0, t, out);
}

/* c[0..degree] to its differences c[0..degree-1] */
static void difference_row(loft_acc c[], unsigned degree)
{
    for (unsigned i = 0; i < degree; i++)
        c[i] = c[i+1] - c[i];
}

/* degree! / (degree - k)! times the curve of degree - k through the k-th differences of the points.
 *
 * Differences are below 2^k 2^47 and the scheme multiplies by at most 3^(degree-k): again at most
 * 3^9 2^47. The factor is at most 9! < 2^18.5, so the product could overflow. It is therefore
 * computed only if the value is within twice the range of a coordinate divided by the factor. */
enum loft_status loft_bezier_deriv(const loft_bezier *b, unsigned k, loft_unit t, loft_vec *out)
{
    loft_acc c[LOFT_DEGREE_MAX + 1];
    loft_vec v = { { 0 } };
    int32_t factor = 1;

    if (!parameter_valid(t))
        return LOFT_ERR_ARG;
    for (unsigned j = 0; j < k; j++)
        factor = j < b->degree ? factor * (int32_t)(b->degree - j) : 0;

    const loft_acc limit = factor ? 2 * loft_acc_ratio(loft_to_acc(LOFT_REAL_MAX), factor) : 0;
    for (int i = 0; i < LOFT_AXES && factor; i++) {
        widen_axis(b->p, b->degree, i, c);
        for (unsigned m = b->degree; m > b->degree - k; m--)
            difference_row(c, m);
        const loft_acc d = loft_bernstein_eval(c, b->degree - k, t);
        if (!(d >= -limit && d <= limit) || !round_coordinate(d * factor, &v.axis[i]))
            return LOFT_ERR_RANGE;
    }
    *out = v;
    return LOFT_OK;
}

/* Edges and points: |a[0] + .. + a[k]| <= (degree + 1) 2^47. In 0..1 the scheme adds nothing to
 * that. Outside, 8 * 2^47 * 3^7 < 2^61.1 holds for degree 7; for higher degrees the sums themselves
 * must be coordinates. */
enum loft_status loft_bezier_from_edges(const loft_vec a[], unsigned degree, loft_unit t,
                                        loft_vec *out)
{
    loft_acc c[LOFT_DEGREE_MAX + 1];
    loft_vec v;

    if (degree > LOFT_DEGREE_MAX || !parameter_valid(t))
        return LOFT_ERR_ARG;
    const bool narrow = degree > 7 && (t < 0 || t > LOFT_UNIT(1));

    for (int i = 0; i < LOFT_AXES; i++) {
        widen_axis(a, degree, i, c);
        for (unsigned k = 1; k <= degree; k++) {
            c[k] += c[k-1];
            if (narrow && !loft_acc_valid(c[k]))
                return LOFT_ERR_RANGE;
        }
        if (!round_coordinate(loft_bernstein_eval(c, degree, t), &v.axis[i]))
            return LOFT_ERR_RANGE;
    }
    *out = v;
    return LOFT_OK;
}


/* Pieces and other forms */

/* The first value of each row belongs to the left piece, the last one to the right piece. The rows
 * are computed in place, so c finally holds the last values. */
enum loft_status loft_bezier_split(const loft_bezier *b, loft_unit t, loft_vec left[],
                                   loft_vec right[])
{
    const unsigned degree = b->degree;
    loft_acc c[LOFT_DEGREE_MAX + 1];

    if (!parameter_valid(t))
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        widen_axis(b->p, degree, i, c);
        for (unsigned k = 0; k <= degree; k++) {
            if (!round_coordinate(c[0], &left[k].axis[i]))
                return LOFT_ERR_RANGE;
            loft_bernstein_step(c, degree - k, t);
        }
        if (!round_axis(c, degree, i, right))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

/* out[k] = b[from^(degree-k), to^k]: degree - k rows at `from`, then k rows at `to` in a copy. */
enum loft_status loft_bezier_sub(const loft_bezier *b, loft_unit from, loft_unit to, loft_vec out[])
{
    loft_acc c[LOFT_DEGREE_MAX + 1], copy[LOFT_DEGREE_MAX + 1];

    if (!parameter_valid(from) || !parameter_valid(to))
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        widen_axis(b->p, b->degree, i, c);
        for (unsigned k = b->degree + 1u; k-- > 0; ) {
            for (unsigned j = 0; j <= k; j++)
                copy[j] = c[j];
            if (!round_coordinate(loft_bernstein_eval(copy, k, to), &out[k].axis[i]))
                return LOFT_ERR_RANGE;
            loft_bernstein_step(c, k, from);
        }
    }
    return LOFT_OK;
}

/* q_k = sum C(n,i) C(r,k-i) b_i / C(n+r,k), i = max(0,k-r) .. min(n,k). The products of binomials
 * sum to C(n+r,k) <= C(18,9) = 48620, so the sum is below 48620 * 2^47 < 2^62.6. There is one
 * division, rounded to 2^-33. Beyond degree 18 the degree is raised by one at a time, q_k = (k
 * q_(k-1) + (d + 1 - k) q_k) / (d + 1), which rounds once more. */
#define AT_ONCE LOFT_ELEVATE_MAX

static void elevate_axis(const loft_acc c[], unsigned n, unsigned times, loft_acc q[])
{
    const unsigned first = n + times > AT_ONCE ? AT_ONCE - n : times;

    for (unsigned k = 0; k <= n + first; k++) {
        loft_acc sum = 0;
        for (unsigned i = k > first ? k - first : 0; i <= n && i <= k; i++)
            sum += c[i] * (loft_binomial(n, i) * loft_binomial(first, k - i));
        q[k] = loft_acc_ratio(sum, loft_binomial(n + first, k));
    }
    for (unsigned d = n + first; d < n + times; d++) {
        q[d + 1] = q[d];
        for (unsigned k = d; k > 0; k--)
            q[k] = loft_acc_lerp_at(q[k], q[k - 1], k, d + 1);
    }
}

enum loft_status loft_bezier_elevate(const loft_bezier *b, unsigned times, loft_vec out[])
{
    const unsigned n = b->degree;
    loft_acc c[LOFT_DEGREE_MAX + 1], q[LOFT_BEZIER_ELEVATE_MAX + 1];

    if (times > LOFT_BEZIER_ELEVATE_MAX - n)
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        widen_axis(b->p, n, axis, c);
        elevate_axis(c, n, times, q);
        for (unsigned k = 0; k <= n + times; k++)
            out[k].axis[axis] = loft_acc_round(q[k]);
    }
    return LOFT_OK;
}

enum loft_status loft_bezier_power(const loft_bezier *b, loft_vec out[])
{
    loft_acc c[LOFT_DEGREE_MAX + 1];

    for (int i = 0; i < LOFT_AXES; i++) {
        widen_axis(b->p, b->degree, i, c);
        loft_bernstein_to_power(c, b->degree);
        if (!round_axis(c, b->degree, i, out))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

enum loft_status loft_bezier_from_power(const loft_vec c[], unsigned degree, loft_vec out[])
{
    loft_acc p[LOFT_DEGREE_MAX + 1];

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        widen_axis(c, degree, i, p);
        loft_bernstein_from_power(p, degree);
        if (!round_axis(p, degree, i, out))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

loft_box loft_bezier_box(const loft_bezier *b)
{
    loft_box box = { b->p[0], b->p[0] };

    for (unsigned k = 1; k <= b->degree; k++)
        box = loft_box_join(box, b->p[k]);
    return box;
}

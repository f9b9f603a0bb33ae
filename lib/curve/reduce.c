/* lib/curve/reduce.c
 * SPDX-License-Identifier: MIT
 *
 * The degree is the highest k for which a k-th difference is not 0; that one is a multiple of the
 * leading coefficient once all higher ones vanish. A curve of degree n - 1 raised once has b_i = (i
 * q_(i-1) + (n - i) q_i) / n. From the left this gives q_i = (n b_i - i q_(i-1)) / (n - i), from
 * the right likewise; each is used for its half, where the factor i / (n - i) is at most 1. So a
 * step adds errors of at most n / (n - i) <= 2 of b, n of them.
 *
 * Nearest: the inner points q_1 .. q_(m-1) solve the normal equations with the entries
 *
 *     int B_i^m B_j^m = C(m, i) C(m, j) / (C(2m, i + j) (2m + 1))
 *
 * and the right side int B_i^m (P - q_0 B_0^m - q_m B_m^m). P of degree n has int B_i^m B_j^n =
 * C(m, i) C(n, j) / (C(m + n, i + j) (m + n + 1)). The matrix is symmetric and positive definite:
 * Gauss's elimination needs no pivots. Its condition is below C(2m, m), 12870 for m = 8. Points are
 * taken relative to p_0, and in the system relative to the line from p_0 to p_n, whose ends are
 * then 0. So what rounding takes is a part of E, the largest |p_j - p_0| and |q_i - p_0| of an
 * axis, wherever the curve lies: with 2^6 roundings of the system at most C(2m, m) 2^6 of them. The
 * bound is larger by twice that, also for the lengths themselves.
 */
#include "curve/reduce.h"
#include "basis/integral.h"     /* loft_binomial_sci */
#include "num/exact.h"          /* loft_exact */

#define MOST (LOFT_DEGREE_MAX + 1)

static bool coordinates_exact(const loft_bezier *b)
{
    for (unsigned i = 0; i <= b->degree; i++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            if (!loft_exact_valid(b->p[i].axis[axis]))
                return false;
    return true;
}

unsigned loft_bezier_axis_degree(const loft_bezier *b, int axis)
{
    loft_exact c[MOST];
    unsigned degree = 0;

    for (unsigned i = 0; i <= b->degree; i++)
        c[i] = loft_exact_from_real(loft_vec_axis(&b->p[i], axis));
    for (unsigned k = 1; k <= b->degree; k++)
        for (unsigned i = 0; i + k <= b->degree; i++) {
            c[i] = loft_exact_sub(c[i + 1], c[i]);
            if (loft_exact_sign(c[i]) != 0)
                degree = k;
        }
    return degree;
}

/* One degree less, in place: c[0..n] to c[0..n-1]. */
static void lower_once(loft_sci c[], unsigned n)
{
    const loft_sci all = loft_sci_from_int((int32_t)n);
    const unsigned half = (n + 1) / 2;
    loft_sci q[MOST];

    for (unsigned i = 0; i < half; i++) {
        loft_sci x = loft_sci_mul(all, c[i]);
        if (i > 0)
            x = loft_sci_sub(x, loft_sci_mul(loft_sci_from_int((int32_t)i), q[i - 1]));
        q[i] = loft_sci_div(x, loft_sci_from_int((int32_t)(n - i)));
    }
    for (unsigned i = n; i > half; i--) {
        loft_sci x = loft_sci_mul(all, c[i]);
        if (i < n)
            x = loft_sci_sub(x, loft_sci_mul(loft_sci_from_int((int32_t)(n - i)), q[i]));
        q[i - 1] = loft_sci_div(x, loft_sci_from_int((int32_t)i));
    }
    for (unsigned i = 0; i < n; i++)
        c[i] = q[i];
}

static bool round_coordinate(loft_sci x, loft_real *out)
{
    loft_acc wide;

    if (!loft_sci_to_acc(x, &wide) || !loft_acc_valid(wide))
        return false;
    *out = loft_acc_round(wide);
    return true;
}

enum loft_status loft_bezier_exact_degree(const loft_bezier *b, unsigned *degree, loft_vec out[])
{
    unsigned most = 0;
    loft_sci c[MOST];

    if (!coordinates_exact(b))
        return LOFT_ERR_RANGE;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const unsigned k = loft_bezier_axis_degree(b, axis);
        most = k > most ? k : most;
    }
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        for (unsigned i = 0; i <= b->degree; i++)
            c[i] = loft_sci_from_real(b->p[i].axis[axis]);
        for (unsigned n = b->degree; n > most; n--)
            lower_once(c, n);
        for (unsigned i = 0; i <= most; i++)
            if (!round_coordinate(c[i], &out[i].axis[axis]))
                return LOFT_ERR_RANGE;
    }
    *degree = most;
    return LOFT_OK;
}

/* int B_i^m B_j^n */
static loft_sci pair_integral(unsigned m, unsigned i, unsigned n, unsigned j)
{
    const loft_sci top = loft_sci_mul(loft_binomial_sci(m, i), loft_binomial_sci(n, j));
    const loft_sci all = loft_sci_mul(loft_binomial_sci(m + n, i + j),
                                      loft_sci_from_int((int32_t)(m + n + 1)));
    return loft_sci_div(top, all);
}

/* Solve for x[1 .. m - 1], which holds the right sides. */
static void solve_normal(unsigned m, loft_sci x[])
{
    loft_sci a[MOST][MOST];

    for (unsigned i = 1; i < m; i++)
        for (unsigned j = 1; j < m; j++)
            a[i][j] = pair_integral(m, i, m, j);
    for (unsigned k = 1; k < m; k++)
        for (unsigned i = k + 1; i < m; i++) {
            const loft_sci f = loft_sci_div(a[i][k], a[k][k]);
            for (unsigned j = k; j < m; j++)
                a[i][j] = loft_sci_sub_product(a[i][j], f, a[k][j]);
            x[i] = loft_sci_sub_product(x[i], f, x[k]);
        }
    for (unsigned i = m; i-- > 1; ) {
        for (unsigned j = i + 1; j < m; j++)
            x[i] = loft_sci_sub_product(x[i], a[i][j], x[j]);
        x[i] = loft_sci_div(x[i], a[i][i]);
    }
}

/* A coordinate relative to the first point. */
static loft_sci from_start(const loft_bezier *b, int axis, loft_real x)
{
    return loft_sci_sub(loft_sci_from_real(x), loft_sci_from_real(b->p[0].axis[axis]));
}

/* i / n of the way from the first to the last point */
static loft_sci line_at(const loft_bezier *b, int axis, unsigned i, unsigned n)
{
    const loft_sci part = loft_sci_div(loft_sci_from_int((int32_t)i),
                                       loft_sci_from_int((int32_t)n));
    return loft_sci_mul(part, from_start(b, axis, b->p[b->degree].axis[axis]));
}

/* The points q[0..m] of one axis, relative to the first one. */
static void reduce_axis(const loft_bezier *b, unsigned m, int axis, loft_sci q[])
{
    const unsigned n = b->degree;

    q[0] = q[m] = loft_sci_zero();
    for (unsigned i = 1; i < m; i++) {
        q[i] = loft_sci_zero();
        for (unsigned j = 1; j < n; j++) {
            const loft_sci rise = loft_sci_sub(from_start(b, axis, b->p[j].axis[axis]),
                                               line_at(b, axis, j, n));
            loft_sci_add_product(&q[i], pair_integral(m, i, n, j), rise);
        }
    }
    solve_normal(m, q);
    for (unsigned i = 1; i <= m; i++)
        q[i] = loft_sci_add(q[i], line_at(b, axis, i, m));
}

/* Add the squares of the coefficients of P - Q to sum[0..n]. */
static void add_squares(const loft_bezier *b, unsigned m, int axis, const loft_sci q[],
                        loft_sci sum[])
{
    const unsigned n = b->degree;

    for (unsigned k = 0; k <= n; k++) {
        loft_sci raised = loft_sci_zero();
        for (unsigned i = k > n - m ? k - (n - m) : 0; i <= m && i <= k; i++)
            loft_sci_add_product(
                &raised, loft_sci_mul(loft_binomial_sci(m, i), loft_binomial_sci(n - m, k - i)),
                q[i]);
        const loft_sci d = loft_sci_sub(from_start(b, axis, b->p[k].axis[axis]),
                                        loft_sci_div(raised, loft_binomial_sci(n, k)));
        loft_sci_add_product(&sum[k], d, d);
    }
}

/* The larger of `most` and E of one axis. */
static loft_sci larger_extent(const loft_bezier *b, unsigned m, int axis, const loft_sci q[],
                              loft_sci most)
{
    for (unsigned k = 0; k <= b->degree; k++)
        most = loft_sci_larger(most, loft_sci_abs(from_start(b, axis, b->p[k].axis[axis])));
    for (unsigned i = 0; i <= m; i++)
        most = loft_sci_larger(most, loft_sci_abs(q[i]));
    return most;
}

/* Round q[0..m] of one axis to out, but for the ends, which are the curve's. */
static bool round_axis(const loft_bezier *b, unsigned m, int axis, loft_sci q[], loft_vec out[])
{
    const loft_sci start = loft_sci_from_real(b->p[0].axis[axis]);

    out[0].axis[axis] = b->p[0].axis[axis];
    out[m].axis[axis] = b->p[b->degree].axis[axis];
    for (unsigned i = 1; i < m; i++) {
        if (!round_coordinate(loft_sci_add(start, q[i]), &out[i].axis[axis]))
            return false;
        q[i] = from_start(b, axis, out[i].axis[axis]);
    }
    return true;
}

#define MARGIN (7 - LOFT_SCI_BITS)      /* 2^7 roundings of num/sci.h */

enum loft_status loft_bezier_reduce(const loft_bezier *b, unsigned times, loft_vec out[],
                                    loft_acc *bound)
{
    const unsigned n = b->degree, m = n - times;
    loft_sci sum[2][MOST], q[MOST], most = loft_sci_zero(), extent = loft_sci_zero();
    loft_acc wide;

    if (times < 1 || times >= n)
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k <= n; k++)
        sum[0][k] = sum[1][k] = loft_sci_zero();
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        reduce_axis(b, m, axis, q);
        add_squares(b, m, axis, q, sum[0]);
        extent = larger_extent(b, m, axis, q, extent);
        if (!round_axis(b, m, axis, q, out))
            return LOFT_ERR_RANGE;
        add_squares(b, m, axis, q, sum[1]);
    }
    for (unsigned k = 0; k <= n; k++)
        most = loft_sci_larger(most, loft_sci_larger(sum[0][k], sum[1][k]));
    extent = loft_sci_mul(extent, loft_binomial_sci(2 * m, m));
    most = loft_sci_add(loft_sci_sqrt(most), loft_sci_mul(extent, loft_sci_power2(MARGIN)));
    if (!loft_sci_to_acc(most, &wide) || !loft_acc_valid(wide + loft_real_ulp(wide)))
        return LOFT_ERR_RANGE;
    *bound = wide + loft_acc_ulp(wide);
    return LOFT_OK;
}

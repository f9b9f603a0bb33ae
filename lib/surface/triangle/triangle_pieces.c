/* lib/surface/triangle/triangle_pieces.c
 * SPDX-License-Identifier: MIT
 *
 * One axis at a time. An axis is read completely before it is written, so the result may replace
 * its input. barycentric.c proves range and error of the rows.
 */
#include "surface/triangle/triangle_pieces.h"

#define MOST LOFT_TRIANGLE_MAX

static void axis_to_acc(const loft_vec p[], unsigned count, int axis, loft_acc c[])
{
    for (unsigned k = 0; k < count; k++)
        c[k] = loft_to_acc(p[k].axis[axis]);
}

static bool round_axis(loft_acc x, loft_real *out)
{
    if (!loft_acc_valid(x))
        return false;
    *out = loft_acc_round(x);
    return true;
}

static void copy_net(const loft_acc from[], unsigned count, loft_acc to[])
{
    for (unsigned k = 0; k < count; k++)
        to[k] = from[k];
}


/* Around a point */

/* After r rows the three edges of the remaining net belong to the three pieces, with the power r of
 * the new corner: b_0jk, b_i0k and b_ij0. */
static bool deal_row(const loft_acc x[], unsigned degree, unsigned r, int axis, loft_vec a[],
                     loft_vec b[], loft_vec c[])
{
    const unsigned n = degree - r;

    for (unsigned k = 0; k <= n; k++)
        if (!round_axis(x[loft_triangle_place(n - k, k)],
                        &a[loft_triangle_place(n - k, k)].axis[axis]) ||
            !round_axis(x[loft_triangle_place(0, k)], &b[loft_triangle_place(r, k)].axis[axis]) ||
            !round_axis(x[loft_triangle_place(k, 0)], &c[loft_triangle_place(k, r)].axis[axis]))
            return false;
    return true;
}

enum loft_status loft_triangle_split(const loft_triangle *t, loft_bary u, loft_vec a[],
                                     loft_vec b[], loft_vec c[])
{
    const unsigned n = t->degree;
    loft_acc x[MOST], product = loft_to_acc(LOFT_REAL(1));

    if (!loft_bary_grows(u, false, n, &product))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++) {
        axis_to_acc(t->p, LOFT_TRIANGLE_POINTS(n), i, x);
        for (unsigned r = 0; r <= n; r++) {
            if (!deal_row(x, n, r, i, a, b, c))
                return LOFT_ERR_RANGE;
            loft_bary_step(x, n - r, u);
        }
    }
    return LOFT_OK;
}


/* Over another triangle */

/* One corner of a sub-triangle, and the row of the algorithm that belongs to it. */
typedef struct {
    loft_bary u;
    uint8_t ends[2];                /* for halves: take the mean of these two corners */
} corner;

typedef void row(loft_acc c[], unsigned degree, const corner *at);

static void blend_row(loft_acc c[], unsigned degree, const corner *at)
{
    loft_bary_step(c, degree, at->u);
}

/* Corner e = 0, 1, 2 of the small triangle at place p in row m is at p, p + m + 1, p + m + 2. In
 * q16 an acc has 16 bits below the LSB of a coordinate. Nine rows use nine of them, so nothing is
 * rounded. */
static void halve_row(loft_acc c[], unsigned degree, const corner *at)
{
    for (unsigned m = 0, p = 0; m < degree; m++)
        for (unsigned k = 0; k <= m; k++, p++) {
            const unsigned place[3] = { p, p + m + 1, p + m + 2 };
            c[p] = (c[place[at->ends[0]]] + c[place[at->ends[1]]]) / 2;
        }
}

/* b[corner0^i, corner1^j, corner2^k]: i rows at the first corner, then j rows at the second in a
 * copy, then k rows at the third in a copy of that. */
static bool reshape_axis(loft_acc c[], unsigned degree, const corner at[3], row *step, int axis,
                         loft_vec out[])
{
    loft_acc second[MOST], third[MOST];

    for (unsigned m = degree + 1; m-- > 0; ) {
        copy_net(c, LOFT_TRIANGLE_POINTS(m), second);
        for (unsigned k = m + 1; k-- > 0; ) {
            copy_net(second, LOFT_TRIANGLE_POINTS(k), third);
            for (unsigned n = k; n > 0; n--)
                step(third, n, &at[2]);
            if (!round_axis(third[0], &out[loft_triangle_place(m - k, k)].axis[axis]))
                return false;
            step(second, k, &at[1]);
        }
        step(c, m, &at[0]);
    }
    return true;
}

static enum loft_status reshape_all(const loft_triangle *t, const corner at[3], row *step,
                                    loft_vec out[])
{
    const unsigned count = LOFT_TRIANGLE_POINTS(t->degree);
    loft_acc c[MOST];

    for (int i = 0; i < LOFT_AXES; i++) {
        axis_to_acc(t->p, count, i, c);
        if (!reshape_axis(c, t->degree, at, step, i, out))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

enum loft_status loft_triangle_quarter(const loft_triangle *t, unsigned part, loft_vec out[])
{
    static const uint8_t ends[4][3][2] = { { { 0, 0 }, { 0, 1 }, { 0, 2 } },
                                           { { 0, 1 }, { 1, 1 }, { 1, 2 } },
                                           { { 0, 2 }, { 1, 2 }, { 2, 2 } },
                                           { { 1, 2 }, { 0, 2 }, { 0, 1 } } };
    corner at[3] = { { { 0, 0 }, { 0, 0 } }, { { 0, 0 }, { 0, 0 } }, { { 0, 0 }, { 0, 0 } } };

    if (part > 3)
        return LOFT_ERR_ARG;
    for (int k = 0; k < 3; k++)
        for (int e = 0; e < 2; e++)
            at[k].ends[e] = ends[part][k][e];
    return reshape_all(t, at, halve_row, out);
}

enum loft_status loft_triangle_sub(const loft_triangle *t, const loft_bary at[3], loft_vec out[])
{
    corner corners[3];

    for (int k = 0; k < 3; k++) {
        loft_acc product = loft_to_acc(LOFT_REAL(1));
        if (!loft_bary_grows(at[k], false, t->degree, &product))
            return LOFT_ERR_RANGE;
        corners[k].u = at[k];
    }
    return reshape_all(t, corners, blend_row, out);
}


/* Other forms */

/* sum C(i,r) C(j,s) C(k,t) b_rst / C(n+m,n) over r + s + t = n, with (i, j, k) of degree n + m. To
 * degree 18 the products of binomials sum to C(n+m,n) <= C(18,9) = 48620, so the sum is below 48620
 * * 2^47 < 2^62.6. One division rounds to 2^-33. */
static loft_acc elevated_coefficient(const loft_acc c[], unsigned n, unsigned i, unsigned j,
                                     unsigned k)
{
    loft_acc sum = 0;

    for (unsigned s = 0; s <= n && s <= j; s++)
        for (unsigned t = 0; s + t <= n && t <= k; t++)
            sum += c[loft_triangle_place(s, t)] *
                   (loft_binomial(i, n - s - t) * loft_binomial(j, s) * loft_binomial(k, t));
    return loft_acc_ratio(sum, loft_binomial(i + j + k, n));
}

/* The sum is the mean of b_rst when n balls are drawn out of i of the first kind, j of the second
 * and k of the third. Beyond degree 18 it is taken ball by ball, the last one first. After a draw
 * of (r, s, t), together d - 1, the next ball is of the first kind with the share
 *
 *     (i - r) / (i + j + k - d + 1)
 *
 * Shares are positive and sum to 1: no mean exceeds its three numbers, and a sum is below
 * 32 * 2^47. Each of the n steps rounds to 2^-33. What no draw can reach has the share 0. */
static loft_acc elevated_by_steps(const loft_acc c[], unsigned n, unsigned i, unsigned j,
                                  unsigned k)
{
    loft_acc x[MOST];

    copy_net(c, LOFT_TRIANGLE_POINTS(n), x);
    for (unsigned d = n; d > 0; d--)
        for (unsigned m = 0, p = 0; m < d; m++)
            for (unsigned t = 0; t <= m; t++, p++) {
                const unsigned r = d - 1 - m, s = m - t;
                if (r > i || s > j || t > k)
                    continue;
                const loft_acc sum = x[p] * (int32_t)(i - r) + x[p + m + 1] * (int32_t)(j - s) +
                                     x[p + m + 2] * (int32_t)(k - t);
                x[p] = loft_acc_ratio(sum, (int32_t)(i + j + k - d + 1));
            }
    return x[0];
}

enum loft_status loft_triangle_elevate(const loft_triangle *t, unsigned times, loft_vec out[])
{
    const unsigned n = t->degree, most = n + times;
    loft_acc c[MOST];

    if (times > LOFT_BEZIER_ELEVATE_MAX - n)
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        axis_to_acc(t->p, LOFT_TRIANGLE_POINTS(n), axis, c);
        for (unsigned m = 0; m <= most; m++)
            for (unsigned k = 0; k <= m; k++)
                out[loft_triangle_place(m - k, k)].axis[axis] = loft_acc_round(
                    most > LOFT_ELEVATE_MAX ? elevated_by_steps(c, n, most - m, m - k, k)
                                            : elevated_coefficient(c, n, most - m, m - k, k));
    }
    return LOFT_OK;
}

/* b_ijk = sum over p <= j, r <= k of C(j,p) C(k,r) a_pr over n! / (p! r! (n-p-r)!) = C(n,p)
 * C(n-p,r). A product is below 126 * 2^47, no quotient exceeds its coefficient, and there are at
 * most 30 of them: below 2^52. */
static loft_acc power_coefficient(const loft_acc a[], unsigned n, unsigned j, unsigned k)
{
    loft_acc sum = 0;

    for (unsigned p = 0; p <= j; p++)
        for (unsigned r = 0; r <= k; r++)
            sum += loft_acc_ratio(a[loft_triangle_place(p, r)] *
                                      (loft_binomial(j, p) * loft_binomial(k, r)),
                                  loft_binomial(n, p) * loft_binomial(n - p, r));
    return sum;
}

enum loft_status loft_triangle_from_power(const loft_vec a[], unsigned degree, loft_vec out[])
{
    loft_acc c[MOST];

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        axis_to_acc(a, LOFT_TRIANGLE_POINTS(degree), axis, c);
        for (unsigned m = 0; m <= degree; m++)
            for (unsigned k = 0; k <= m; k++)
                if (!round_axis(power_coefficient(c, degree, m - k, k),
                                &out[loft_triangle_place(m - k, k)].axis[axis]))
                    return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

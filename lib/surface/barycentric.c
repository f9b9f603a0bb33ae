/* lib/surface/barycentric.c
 * SPDX-License-Identifier: MIT
 *
 * Range of a row in q16. Coefficients are at most 2^15 G, where G is the product of the growths L
 * of the earlier rows. loft_bary_grows guarantees G L <= 19683 for the current row.
 * loft_acc_lerp3 forms
 *
 *     |v| |y - x| + |w| |z - x|  <=  2 (|v| + |w|) 2^15 G  <=  2 L G 2^15  <  2^30.3
 *
 * and the result is below 2^29.3. Both are below the limit 2^31. The rounding of 2^-33 is
 * multiplied by the growths of the later rows. For rows of one L <= 19683^(1/n) the error is
 *
 *     e_n = 2^-33 (1 + L + .. + L^(n-1)) <= 9841 * 2^-33 < 2^-19.7
 *
 * as for curves (basis/bernstein.c). The worst case is n = 9, L = 3.
 */
#include "surface/barycentric.h"
#include "geom/vec_exact.h"          /* loft_exact: areas and decisions */

#define GROWTH_MAX 19683
#define FARTHEST   LOFT_UNIT(32)


/* Coordinates in a plane triangle */

/* The first two axes of a difference. */
typedef struct {
    loft_exact x, y;
} side;

static side exact_side(loft_vec a, loft_vec b)
{
    return (side) { loft_vec_exact_sub_axis(&b, &a, 0), loft_vec_exact_sub_axis(&b, &a, 1) };
}

static loft_exact det(side a, side b) { return loft_exact_det(a.x, a.y, b.x, b.y); }

/* part / whole. The parts are two determinants, and their difference from the whole or from 0. */
static enum loft_status divide_parts(const loft_exact part[3], loft_exact whole, loft_acc out[3])
{
    loft_acc x[3];

    if (loft_exact_sign(whole) == 0)
        return LOFT_SINGULAR;
    for (int k = 0; k < 3; k++)
        if (!loft_exact_quot(part[k], whole, 0, &x[k]))
            return LOFT_ERR_RANGE;
    for (int k = 0; k < 3; k++)
        out[k] = x[k];
    return LOFT_OK;
}

/* [x - T1, T3 - T1] and [T2 - T1, x - T1] over [T2 - T1, T3 - T1] */
enum loft_status loft_bary_from_point(const loft_vec corner[3], loft_vec x, loft_acc out[3])
{
    if (!loft_vec_exact_valid(corner, 3, 2) || !loft_vec_exact_valid(&x, 1, 2))
        return LOFT_ERR_RANGE;
    const side a = exact_side(corner[0], corner[1]), b = exact_side(corner[0], corner[2]),
               p = exact_side(corner[0], x);
    const loft_exact whole = det(a, b);
    loft_exact part[3] = { whole, det(p, b), det(a, p) };

    part[0] = loft_exact_sub(loft_exact_sub(whole, part[1]), part[2]);
    return divide_parts(part, whole, out);
}

enum loft_status loft_bary_from_vector(const loft_vec corner[3], loft_vec x, loft_acc out[3])
{
    const loft_vec origin = { { 0 } };

    if (!loft_vec_exact_valid(corner, 3, 2) || !loft_vec_exact_valid(&x, 1, 2))
        return LOFT_ERR_RANGE;
    const side a = exact_side(corner[0], corner[1]), b = exact_side(corner[0], corner[2]),
               p = exact_side(origin, x);
    const loft_exact v = det(p, b), w = det(a, p),
                     part[3] = { loft_exact_neg(loft_exact_add(v, w)), v, w };

    return divide_parts(part, det(a, b), out);
}

enum loft_status loft_bary_area(const loft_vec corner[3], loft_real *area)
{
    loft_acc x;

    if (!loft_vec_exact_valid(corner, 3, 2))
        return LOFT_ERR_RANGE;
    const loft_exact twice = det(exact_side(corner[0], corner[1]),
                                 exact_side(corner[0], corner[2]));
    if (!loft_exact_quot(twice, loft_exact_from_int(2), -2 * LOFT_EXACT_REAL, &x) ||
        !loft_acc_valid(x))
        return LOFT_ERR_RANGE;
    *area = loft_acc_round(x);
    return LOFT_OK;
}

static bool bary_near(loft_bary u)
{
    return u.v >= -FARTHEST && u.v <= FARTHEST && u.w >= -FARTHEST && u.w <= FARTHEST;
}

enum loft_status loft_bary_round(const loft_acc wide[3], loft_bary *out)
{
    const loft_acc most = loft_to_acc(LOFT_REAL(32));

    for (int k = 1; k < 3; k++)
        if (!(wide[k] >= -most && wide[k] <= most))
            return LOFT_ERR_RANGE;
    out->v = loft_unit_round(wide[1]);
    out->w = loft_unit_round(wide[2]);
    return LOFT_OK;
}

static loft_acc unit_to_acc(loft_unit t) { return loft_acc_scale(loft_to_acc(LOFT_REAL(1)), t); }

enum loft_status loft_bary_change(const loft_bary corner[3], loft_bary x, loft_acc out[3])
{
    if (!bary_near(corner[0]) || !bary_near(corner[1]) || !bary_near(corner[2]) || !bary_near(x))
        return LOFT_ERR_ARG;
    out[1] = loft_acc_lerp3(unit_to_acc(corner[0].v), unit_to_acc(corner[1].v),
                            unit_to_acc(corner[2].v), x.v, x.w);
    out[2] = loft_acc_lerp3(unit_to_acc(corner[0].w), unit_to_acc(corner[1].w),
                            unit_to_acc(corner[2].w), x.v, x.w);
    out[0] = loft_to_acc(LOFT_REAL(1)) - out[1] - out[2];
    return LOFT_OK;
}


/* Polynomials over a triangle */


bool loft_bary_grows(loft_bary u, bool direction, unsigned times, loft_acc *product)
{
    const loft_acc one = loft_to_acc(LOFT_REAL(1)), most = one * GROWTH_MAX;

    if (!direction && loft_bary_inside(u))
        return true;
    if (!bary_near(u))
        return false;
    const loft_acc v = unit_to_acc(u.v), w = unit_to_acc(u.w);
    /* at most 129 */
    const loft_acc growth = loft_acc_abs((direction ? 0 : one) - v - w) + loft_acc_abs(v) +
                            loft_acc_abs(w);
    for (unsigned k = 0; k < times && growth > one; k++) {
        *product = loft_acc_mul(*product, loft_acc_round(growth)) + loft_acc_ulp(*product);
        if (*product > most)
            return false;
    }
    return true;
}

/* Each weight passes v and w of itself to its two neighbours of the next degree and keeps the rest.
 * So the sum stays 1 without error. Two roundings come from what it passes on, and two from what it
 * receives. Its earlier error is passed on with weights of sum 1. The error is therefore 4 * 2^-33
 * per degree. Rows run from the last one up, and within a row from the end, so row m is read before
 * row m + 1 is complete. */
void loft_bary_weights(unsigned degree, loft_bary u, loft_acc c[])
{
    c[0] = loft_to_acc(LOFT_REAL(1));
    for (unsigned n = 1; n <= degree; n++) {
        for (unsigned k = 0; k <= n; k++)
            c[loft_triangle_place(n - k, k)] = 0;
        for (unsigned p = loft_triangle_place(n, 0), m = n; m-- > 0; ) {
            for (unsigned k = m + 1; k-- > 0; ) {
                p--;
                const loft_acc v = loft_acc_scale(c[p], u.v), w = loft_acc_scale(c[p], u.w);
                c[p] -= v + w;
                c[p + m + 1] += v;
                c[p + m + 2] += w;
            }
        }
    }
}

/* From place p in row m, b_i(j+1)k is at p + m + 1 and b_ij(k+1) at p + m + 2. Both are still
 * unchanged. */
void loft_bary_step(loft_acc c[], unsigned degree, loft_bary u)
{
    for (unsigned m = 0, p = 0; m < degree; m++)
        for (unsigned k = 0; k <= m; k++, p++)
            c[p] = loft_acc_lerp3(c[p], c[p + m + 1], c[p + m + 2], u.v, u.w);
}

void loft_bary_slope(loft_acc c[], unsigned degree, loft_bary z)
{
    for (unsigned m = 0, p = 0; m < degree; m++)
        for (unsigned k = 0; k <= m; k++, p++)
            c[p] = loft_acc_lerp3(0, c[p + m + 1] - c[p], c[p + m + 2] - c[p], z.v, z.w);
}

loft_acc loft_bary_eval(loft_acc c[], unsigned degree, loft_bary u)
{
    for (unsigned n = degree; n > 0; n--)
        loft_bary_step(c, n, u);
    return c[0];
}

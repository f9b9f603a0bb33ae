/* lib/curve/enclosed.c
 * SPDX-License-Identifier: MIT
 *
 * With x and y relative to the first point of the chain,
 *
 *     A = int x dy       A c_x = int x^2 / 2 dy       A c_y = int x y dy
 *     I_xx = int x^3 / 3 dy     I_xy = int x^2 y / 2 dy     I_yy = int x y^2 dy
 *
 * less A c_x^2, A c_x c_y, A c_y^2. Products of polynomials in Bernstein form stay positive
 * averages of products of coefficients: nothing grows, and a product of four errs by 60 roundings
 * of num/sci.h of L^4.
 *
 * Whether A is 0 is decided exactly. 2 A = int x dy - y dx is a sum of (x_i y_j - x_j y_i) W_ij, i
 * < j, with W_ij = int B_i B_j' - B_j B_i'. Since int B_i^n B_k^(n-1) = C(n, i) C(n-1, k) / (2 n
 * C(2n-1, i+k)), and 2 n C(2n-1, k) divides lcm(1..2n), the W are integers over LCM = lcm(1..18).
 * W LCM is below 2 n LCM < 2^28, a cross product below 2^(2 R + 3), and any number of curves below
 * 2^32 of them makes less than 2^(2 R + 70): 134 bits, in floats 328.
 */
#include "curve/enclosed.h"
#include "basis/integral.h"     /* loft_bernstein_product */
#include "geom/vec_exact.h"     /* loft_vec_exact_sub */

#define LCM 12252240            /* of 1..18 */
#define MOST (4 * LOFT_DEGREE_MAX + 1)

/* LCM int B_i^n B_k^(n-1), 0 for k outside 0..n-1 */
static int32_t pair_integral(unsigned n, unsigned i, int k)
{
    if (k < 0 || k >= (int)n)
        return 0;
    const int32_t whole = 2 * (int32_t)n * loft_binomial(2 * n - 1, i + (unsigned)k);
    return loft_binomial(n, i) * loft_binomial(n - 1, (unsigned)k) * (LCM / whole);
}

/* LCM int B_i B_j' */
static int32_t slope_integral(unsigned n, unsigned i, unsigned j)
{
    return (int32_t)n * (pair_integral(n, i, (int)j - 1) - pair_integral(n, i, (int)j));
}

/* 2 LCM times the area of one curve, relative to the origin. */
static loft_exact exact_area(const loft_bezier *b, const loft_vec *origin)
{
    const unsigned n = b->degree;
    loft_exact sum = loft_exact_from_int(0), p[2], q[2];

    for (unsigned i = 0; i <= n; i++)
        for (unsigned j = i + 1; j <= n; j++) {
            loft_vec_exact_sub(&b->p[i], origin, 2, p);
            loft_vec_exact_sub(&b->p[j], origin, 2, q);
            const int32_t w = slope_integral(n, i, j) - slope_integral(n, j, i);
            sum = loft_exact_add(sum, loft_exact_mul(loft_exact_from_int(w),
                                                     loft_exact_det(p[0], p[1], q[0], q[1])));
        }
    return sum;
}

/* Coefficients relative to the origin. */
static void load_axis(const loft_bezier *b, int axis, const loft_vec *origin, loft_sci c[])
{
    const loft_sci from = loft_sci_from_real(loft_vec_axis(origin, axis));

    for (unsigned i = 0; i <= b->degree; i++)
        c[i] = loft_sci_sub(loft_sci_from_real(loft_vec_axis(&b->p[i], axis)), from);
}

/* int f dg, f of degree m */
static loft_sci integral_along(const loft_sci f[], unsigned m, const loft_sci g[], unsigned n)
{
    loft_sci slope[LOFT_DEGREE_MAX + 1], product[MOST];

    if (n == 0)
        return loft_sci_zero();
    for (unsigned i = 0; i < n; i++)
        slope[i] = loft_sci_mul(loft_sci_from_int((int32_t)n), loft_sci_sub(g[i + 1], g[i]));
    loft_bernstein_product(f, m, slope, n - 1, product);
    return loft_bernstein_integral_sci(product, m + n - 1, loft_sci_zero(), loft_sci_one());
}

enum { MX, MY, MXX, MXY, MYY, SUMS };

static void add_curve(const loft_bezier *b, const loft_vec *origin, loft_sci sum[SUMS])
{
    const unsigned n = b->degree;
    loft_sci x[LOFT_DEGREE_MAX + 1], y[LOFT_DEGREE_MAX + 1], two[MOST], three[MOST];

    load_axis(b, 0, origin, x);
    load_axis(b, 1, origin, y);
    loft_bernstein_product(x, n, x, n, two);
    sum[MX] = loft_sci_add(sum[MX], integral_along(two, 2 * n, y, n));
    loft_bernstein_product(two, 2 * n, x, n, three);
    sum[MXX] = loft_sci_add(sum[MXX], integral_along(three, 3 * n, y, n));
    loft_bernstein_product(two, 2 * n, y, n, three);
    sum[MXY] = loft_sci_add(sum[MXY], integral_along(three, 3 * n, y, n));
    loft_bernstein_product(x, n, y, n, two);
    sum[MY] = loft_sci_add(sum[MY], integral_along(two, 2 * n, y, n));
    loft_bernstein_product(two, 2 * n, y, n, three);
    sum[MYY] = loft_sci_add(sum[MYY], integral_along(three, 3 * n, y, n));
}

static bool chain_closed(const loft_bezier c[], unsigned count)
{
    for (unsigned k = 0; k < count; k++) {
        const loft_vec *end = &c[k].p[c[k].degree], *start = &c[k + 1 < count ? k + 1 : 0].p[0];
        for (int axis = 0; axis < 2; axis++)
            if (loft_vec_axis(end, axis) < loft_vec_axis(start, axis) ||
                loft_vec_axis(start, axis) < loft_vec_axis(end, axis))
                return false;
    }
    return true;
}

static loft_sci over_int(loft_sci x, int32_t k) { return loft_sci_div(x, loft_sci_from_int(k)); }

/* The area as a number with an exponent: the quotient at a scale where it has 21 bits before the
 * binary point, so it errs by 2^-53 of itself. */
static bool sci_area(loft_exact twice, loft_sci *out)
{
    const int shift = 45 - loft_exact_bits(twice), down = shift + 2 * LOFT_EXACT_REAL;
    const loft_sci two = loft_sci_from_int(2);
    loft_acc x;

    if (!loft_exact_quot(twice, loft_exact_from_int(2 * LCM), shift, &x))
        return false;
    *out = down > 0 ? loft_sci_div(loft_sci_of(x), loft_sci_pow(two, (unsigned)down))
                    : loft_sci_mul(loft_sci_of(x), loft_sci_pow(two, (unsigned)-down));
    return true;
}

/* The moments about the centroid, from the sums. */
static bool set_moments(const loft_sci sum[SUMS], loft_sci a, const loft_vec *origin,
                        loft_enclosed *out)
{
    const loft_sci cx = loft_sci_div(over_int(sum[MX], 2), a), cy = loft_sci_div(sum[MY], a);
    const loft_sci xx = loft_sci_sub(over_int(sum[MXX], 3), loft_sci_mul(a, loft_sci_mul(cx, cx)));
    const loft_sci xy = loft_sci_sub(over_int(sum[MXY], 2), loft_sci_mul(a, loft_sci_mul(cx, cy)));
    const loft_sci yy = loft_sci_sub(sum[MYY], loft_sci_mul(a, loft_sci_mul(cy, cy)));
    const loft_sci x = loft_sci_add(cx, loft_sci_from_real(loft_vec_axis(origin, 0))),
                   y = loft_sci_add(cy, loft_sci_from_real(loft_vec_axis(origin, 1)));

    return loft_sci_to_acc(x, &out->centroid[0]) && loft_sci_to_acc(y, &out->centroid[1]) &&
           loft_sci_to_acc(xx, &out->xx) && loft_sci_to_acc(xy, &out->xy) &&
           loft_sci_to_acc(yy, &out->yy);
}

enum loft_status loft_chain_enclosed(const loft_bezier c[], unsigned count, loft_enclosed *out)
{
    loft_exact area = loft_exact_from_int(0);
    loft_sci sum[SUMS], size;
    loft_enclosed own;

    if (count < 1 || !chain_closed(c, count))
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k < count; k++)
        if (!loft_vec_exact_valid(c[k].p, c[k].degree + 1u, LOFT_AXES < 2 ? LOFT_AXES : 2))
            return LOFT_ERR_RANGE;
    for (int i = 0; i < SUMS; i++)
        sum[i] = loft_sci_zero();
    for (unsigned k = 0; k < count; k++)
        area = loft_exact_add(area, exact_area(&c[k], &c[0].p[0]));
    if (loft_exact_sign(area) == 0) {
        out->area = 0;
        return LOFT_SINGULAR;
    }
    if (!loft_exact_quot(area, loft_exact_from_int(2 * LCM), -2 * LOFT_EXACT_REAL, &own.area) ||
        !sci_area(area, &size))
        return LOFT_ERR_RANGE;
    for (unsigned k = 0; k < count; k++)
        add_curve(&c[k], &c[0].p[0], sum);
    out->area = own.area;
    if (!set_moments(sum, size, &c[0].p[0], &own))
        return LOFT_ERR_RANGE;
    *out = own;
    return LOFT_OK;
}

enum loft_status loft_bezier_area_under(const loft_bezier *b, loft_unit from, loft_unit to,
                                        loft_acc *out)
{
    const loft_vec zero = { { 0 } };
    const unsigned n = b->degree;
    loft_sci x[LOFT_DEGREE_MAX + 1], y[LOFT_DEGREE_MAX + 1], product[MOST], area = loft_sci_zero();

    if (!(from >= 0 && from <= LOFT_UNIT(1)) || !(to >= 0 && to <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    load_axis(b, 0, &zero, x);
    load_axis(b, 1, &zero, y);
    if (n > 0) {
        for (unsigned i = 0; i < n; i++)
            x[i] = loft_sci_mul(loft_sci_from_int((int32_t)n), loft_sci_sub(x[i + 1], x[i]));
        loft_bernstein_product(y, n, x, n - 1, product);
        area = loft_bernstein_integral_sci(product, 2 * n - 1, loft_sci_from_unit(from),
                                           loft_sci_from_unit(to));
    }
    return loft_sci_to_acc(area, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

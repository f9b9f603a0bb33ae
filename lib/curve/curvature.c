/* lib/curve/curvature.c -- curvature without cancellation
 * SPDX-License-Identifier: MIT
 *
 * Let e0, e1 be the two edges in the last row but one of de Casteljau's scheme. Then
 *
 *     P' = n q,  q = (1 - t) e0 + t e1        P' x P'' = n^2 (n - 1) e0 x e1
 *     curvature = (n - 1) / n * |e0 x e1| / |q|^3
 *
 * Edges and products are integers, so q = 0 and e0 x e1 = 0 are exact decisions and no digit
 * cancels. With t = j / T, T = 2^LOFT_EXACT_UNIT, and d_i = b_(i+1) - b_i,
 *
 *     T^(n-2) e_k = sum over i = 0..n-2 of C(n-2, i) (T - j)^(n-2-i) j^i d_(i+k)
 *
 * Bits for n = 9, t in -1..2: |T - j| + |j| <= 3 T, so e has R + 1 + 7 (25.6 or 54.6), q 1 (25.6 or
 * 54.6) more, and e0 x e1 twice those of e plus 1: q16 212, 237, 425; floats 512, 566, 1025.
 *
 * Lengths: the components are reduced to at most 100 bits before they are squared. The bits dropped
 * are 2^-100 of the largest, and the integer root of 200 bits is exact to 2^-99. The cube has fewer
 * than 307 bits, and the result has a relative error of 2^-95 before it is rounded.
 */
#include "curve/shape.h"
#include "num/exact.h"  /* loft_exact: exact decisions */

#define LENGTH_BITS 100

/* A sum of squares, and the power of two by which the squared numbers were multiplied. */
typedef struct {
    loft_exact sum;
    int shift;
} squares;

static void add_square(squares *s, loft_exact x)
{
    const int bits = loft_exact_bits(x), shift = LENGTH_BITS - bits;

    if (bits == 0)
        return;
    if (loft_exact_sign(s->sum) == 0)
        s->shift = shift;
    else if (shift < s->shift) {
        s->sum = loft_exact_shift(s->sum, 2 * (shift - s->shift));
        s->shift = shift;
    }
    x = loft_exact_shift(x, s->shift);
    s->sum = loft_exact_add(s->sum, loft_exact_mul(x, x));
}

/* One coordinate of e_k, times T^(n-2): Horner's scheme in T - j, with the powers of j. */
static loft_exact edge(const loft_bezier *b, int axis, unsigned k, loft_exact j, loft_exact rest)
{
    const unsigned m = b->degree - 2u;
    loft_exact sum = loft_exact_from_int(0), power = loft_exact_from_int(1);

    for (unsigned i = 0; i <= m; i++) {
        const loft_exact d = loft_exact_sub(loft_exact_from_real(b->p[i + k + 1].axis[axis]),
                                            loft_exact_from_real(b->p[i + k].axis[axis]));
        sum = loft_exact_mul(rest, sum);
        sum = loft_exact_add(
            sum,
            loft_exact_mul(loft_exact_mul(loft_exact_from_int(loft_binomial(m, i)), power), d));
        power = loft_exact_mul(j, power);
    }
    return sum;
}

/* The first derivative and the last edges, without the factors above, in the first `axes` axes. */
typedef struct {
    loft_exact e[2][LOFT_AXES], q[LOFT_AXES];
} ends;

static void find_ends(const loft_bezier *b, loft_unit t, int axes, ends *x)
{
    const loft_exact j = loft_exact_from_unit(t), one = loft_exact_from_unit(LOFT_UNIT(1)),
                     rest = loft_exact_sub(one, j);

    for (int a = 0; a < axes; a++) {
        if (b->degree == 1) {
            x->e[0][a] = x->e[1][a] = loft_exact_from_int(0);
            x->q[a] = loft_exact_sub(loft_exact_from_real(b->p[1].axis[a]),
                                     loft_exact_from_real(b->p[0].axis[a]));
            continue;
        }
        x->e[0][a] = edge(b, a, 0, j, rest);
        x->e[1][a] = edge(b, a, 1, j, rest);
        x->q[a] = loft_exact_add(loft_exact_mul(rest, x->e[0][a]), loft_exact_mul(j, x->e[1][a]));
    }
}

static loft_exact cross(const ends *x, int a, int b)
{
    return loft_exact_det(x->e[0][a], x->e[0][b], x->e[1][a], x->e[1][b]);
}

/* |e0 x e1|: the root of the sum over all pairs of axes. */
static loft_exact area(const ends *x, int axes, int *shift)
{
    squares s = { loft_exact_from_int(0), 0 };

    for (int a = 0; a < axes; a++)
        for (int b = a + 1; b < axes; b++)
            add_square(&s, cross(x, a, b));
    *shift = s.shift;
    return loft_exact_root(s.sum);
}

/* (n - 1) / n * top / length^3 in units of coordinates: e0 x e1 has the factor T^(2n-4) G^2,
 * length^3 has T^(3n-3) G^3. */
static bool quotient(const loft_bezier *b, loft_exact top, int top_shift, loft_exact length,
                     int length_shift, loft_real *out)
{
    const int n = b->degree;
    const loft_exact cube = loft_exact_mul(length, loft_exact_mul(length, length));
    loft_acc k;

    if (!loft_exact_quot(loft_exact_mul(loft_exact_from_int(n - 1), top),
                         loft_exact_mul(loft_exact_from_int(n), cube),
                         (n + 1) * LOFT_EXACT_UNIT + LOFT_EXACT_REAL + 3 * length_shift - top_shift,
                         &k) ||
        !loft_acc_valid(k))
        return false;
    *out = loft_acc_round(k);
    return true;
}

static void set_tangent(const ends *x, int axes, loft_exact length, int shift, loft_vec *tangent)
{
    for (int a = 0; a < LOFT_AXES; a++) {
        loft_acc y = 0;
        if (a < axes && !loft_exact_quot(x->q[a], length, shift, &y))
            y = 0;                              /* never: |y| <= 1 */
        tangent->axis[a] = loft_acc_round(y);
    }
}

static enum loft_status check(const loft_bezier *b, loft_unit t, int axes)
{
    if (!(t >= LOFT_UNIT(-1) && t <= LOFT_UNIT(2)))
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k <= b->degree; k++)
        for (int a = 0; a < axes; a++)
            if (!loft_exact_valid(b->p[k].axis[a]))
                return LOFT_ERR_RANGE;
    return b->degree == 0 ? LOFT_SINGULAR : LOFT_OK;
}

/* Both functions: with a sign in the plane, or over all pairs of axes. */
static enum loft_status curvature_and_tangent(const loft_bezier *b, loft_unit t, int axes,
                                              bool with_sign, loft_real *curvature,
                                              loft_vec *tangent)
{
    const enum loft_status status = check(b, t, axes);
    squares s = { loft_exact_from_int(0), 0 };
    ends x;
    int shift = 0;

    if (status != LOFT_OK)
        return status;
    find_ends(b, t, axes, &x);
    for (int a = 0; a < axes; a++)
        add_square(&s, x.q[a]);
    const loft_exact length = loft_exact_root(s.sum);
    if (loft_exact_sign(length) == 0)
        return LOFT_SINGULAR;
    const loft_exact top = !with_sign ? area(&x, axes, &shift)
                           : axes > 1 ? cross(&x, 0, axes > 1)
                                      : loft_exact_from_int(0);
    if (!quotient(b, top, shift, length, s.shift, curvature))
        return LOFT_ERR_RANGE;
    set_tangent(&x, axes, length, s.shift, tangent);
    return LOFT_OK;
}

enum loft_status loft_bezier_curvature(const loft_bezier *b, loft_unit t, loft_real *curvature,
                                       loft_vec *tangent)
{
    return curvature_and_tangent(b, t, LOFT_AXES, false, curvature, tangent);
}

enum loft_status loft_bezier_curvature_vec(const loft_bezier *b, loft_unit t, loft_real *curvature,
                                           loft_vec *tangent)
{
    return curvature_and_tangent(b, t, LOFT_AXES < 2 ? LOFT_AXES : 2, true, curvature, tangent);
}

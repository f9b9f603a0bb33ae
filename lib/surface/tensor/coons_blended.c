/* lib/surface/tensor/coons_blended.c -- Coons patches with slopes and curvatures as tensor products
 * SPDX-License-Identifier: MIT
 *
 * Value a = 2 k + end of the ends of a curve is its k-th derivative at t = end. The polynomial H_a
 * of degree d = 2 orders - 1 has this value 1 and all others 0. Its Bernstein coefficients at the
 * start are C(j, k) (d - k)! / d!, j < orders, and 0 after; at the end they are mirrored, with the
 * sign (-1)^k. With curves and blending raised to the degrees M, N, and E_ab value a of curve b
 * along u,
 *
 *     net_ij = sum_b u_b,i H_b,j + sum_a H_a,i v_a,j - sum_ab H_a,i H_b,j E_ab
 */
#include "surface/tensor/coons.h"
#include "basis/bernstein.h"    /* loft_binomial */
#include "num/sci.h"            /* loft_sci */

#define SIDE (LOFT_DEGREE_MAX + 1)
#define ENDS (2 * LOFT_COONS_ORDERS)

/* One coordinate: curves along u and v, raised; the blending polynomials along both. */
typedef struct {
    loft_sci u[ENDS][SIDE], v[ENDS][SIDE], by_u[ENDS][SIDE], by_v[ENDS][SIDE], end[ENDS][ENDS];
} blended;

static void raise_to(loft_sci c[], unsigned degree, unsigned to)
{
    for (unsigned d = degree; d < to; d++) {
        c[d + 1] = c[d];
        for (unsigned k = d; k > 0; k--)
            c[k] = loft_sci_lerp(
                c[k], c[k - 1],
                loft_sci_div(loft_sci_from_int((int32_t)k), loft_sci_from_int((int32_t)d + 1)));
    }
}

static void load_blending(unsigned orders, unsigned a, unsigned to, loft_sci c[])
{
    const unsigned k = a / 2, d = 2 * orders - 1;
    int32_t below = 1;

    for (unsigned i = 0; i < k; i++)
        below *= (int32_t)(d - i);
    for (unsigned j = 0; j <= d; j++) {
        const int32_t above = j < orders && j >= k ? loft_binomial(j, k) : 0;
        const int32_t sign = a % 2 && k % 2 ? -1 : 1;
        c[a % 2 ? d - j : j] = loft_sci_div(loft_sci_from_int(sign * above),
                                            loft_sci_from_int(below));
    }
    raise_to(c, d, to);
}

static void load_curve(const loft_bezier *b, int axis, unsigned to, loft_sci c[])
{
    for (unsigned k = 0; k <= b->degree; k++)
        c[k] = loft_sci_from_real(b->p[k].axis[axis]);
    raise_to(c, b->degree, to);
}

/* The k-th derivative at an end, of the raised curve. */
static loft_sci end_of(const loft_sci c[], unsigned degree, unsigned a)
{
    loft_sci copy[SIDE];

    for (unsigned k = 0; k <= degree; k++)
        copy[k] = c[k];
    return loft_sci_deriv(copy, degree, a / 2, a % 2 ? loft_sci_one() : loft_sci_zero());
}

static void load_blended(const loft_coons_bezier *c, int axis, unsigned m, unsigned n, blended *out)
{
    const unsigned ends = 2u * c->orders;

    for (unsigned a = 0; a < ends; a++) {
        load_curve(&c->u[a / 2][a % 2], axis, m, out->u[a]);
        load_curve(&c->v[a / 2][a % 2], axis, n, out->v[a]);
        load_blending(c->orders, a, m, out->by_u[a]);
        load_blending(c->orders, a, n, out->by_v[a]);
    }
    for (unsigned a = 0; a < ends; a++)
        for (unsigned b = 0; b < ends; b++)
            out->end[a][b] = end_of(out->u[b], m, a);
}

static loft_sci coefficient_of(const blended *x, unsigned ends, unsigned i, unsigned j)
{
    loft_sci sum = loft_sci_zero();

    for (unsigned a = 0; a < ends; a++) {
        loft_sci across = x->v[a][j];
        sum = loft_sci_add(sum, loft_sci_mul(x->u[a][i], x->by_v[a][j]));
        for (unsigned b = 0; b < ends; b++)
            across = loft_sci_sub(across, loft_sci_mul(x->by_v[b][j], x->end[a][b]));
        sum = loft_sci_add(sum, loft_sci_mul(x->by_u[a][i], across));
    }
    return sum;
}

static unsigned degree_of(const loft_bezier curve[][2], unsigned orders)
{
    unsigned degree = 2 * orders - 1;

    for (unsigned a = 0; a < 2 * orders; a++)
        if (curve[a / 2][a % 2].degree > degree)
            degree = curve[a / 2][a % 2].degree;
    return degree;
}

enum loft_status loft_tensor_from_coons_blended(const loft_coons_bezier *c, unsigned *m,
                                                unsigned *n, loft_vec net[])
{
    blended x;

    *m = degree_of(c->u, c->orders);
    *n = degree_of(c->v, c->orders);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        load_blended(c, axis, *m, *n, &x);
        for (unsigned i = 0; i <= *m; i++)
            for (unsigned j = 0; j <= *n; j++) {
                loft_acc at;
                if (!loft_sci_to_acc(coefficient_of(&x, 2u * c->orders, i, j), &at) ||
                    !loft_acc_valid(at))
                    return LOFT_ERR_RANGE;
                net[i * (*n + 1) + j].axis[axis] = loft_acc_round(at);
            }
    }
    return LOFT_OK;
}

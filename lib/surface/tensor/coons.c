/* lib/surface/tensor/coons.c
 * SPDX-License-Identifier: MIT
 *
 * Let H_t(x_0 .. x_k) blend values (and derivatives) at both ends of 0..1: linear, cubic or
 * quintic. With the curves U_b along u and V_a along v, the Boolean sum is
 *
 *     S(s, t) = H_t(U_b(s)) + H_s(V_a(t) - H_t(C_ab))
 *
 * C_ab is the a-th value or derivative of U_b at its ends. Since C is taken from U, the patch is
 * V_a at the ends of s, whatever the curves are. At the ends of t the second term is the difference
 * of V and U at the corners: 0 where they agree. */
#include "surface/tensor/coons.h"
#include "basis/bernstein.h"    /* loft_bernstein_eval */
#include "basis/interp.h"       /* loft_ends3_deriv, loft_ends5_deriv */

static bool unit_valid(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

static loft_acc acc_distance(loft_acc x, loft_acc y) { return x < y ? y - x : x - y; }


/* Curves of any kind */

static void bezier_side(const void *curve, loft_unit t, loft_acc out[LOFT_AXES])
{
    const loft_bezier *b = (const loft_bezier *)curve;
    loft_acc c[LOFT_DEGREE_MAX + 1];

    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k <= b->degree; k++)
            c[k] = loft_to_acc(b->p[k].axis[i]);
        out[i] = loft_bernstein_eval(c, b->degree, t);
    }
}

static void vec_to_acc(loft_vec p, loft_acc out[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = loft_to_acc(p.axis[i]);
}

static void rational_side(const void *curve, loft_unit t, loft_acc out[LOFT_AXES])
{
    vec_to_acc(loft_rational_eval((const loft_rational *)curve, t), out);
}

/* The parameter of t in a knot domain. The knots are arbitrary; their distance need not fit. */
static loft_real domain_param(const loft_knots *knots, loft_unit t)
{
    return loft_acc_round(loft_acc_lerp(loft_to_acc(knots->k[knots->degree]),
                                        loft_to_acc(knots->k[knots->points]), t));
}

static void bspline_side(const void *curve, loft_unit t, loft_acc out[LOFT_AXES])
{
    const loft_bspline *b = (const loft_bspline *)curve;
    vec_to_acc(loft_bspline_eval(b, domain_param(&b->knots, t)), out);
}

static void nurbs_side(const void *curve, loft_unit t, loft_acc out[LOFT_AXES])
{
    const loft_nurbs *n = (const loft_nurbs *)curve;
    vec_to_acc(loft_nurbs_eval(n, domain_param(&n->knots, t)), out);
}

loft_side loft_side_from_bezier(const loft_bezier *b)
{
    const loft_side s = { bezier_side, b };
    return s;
}
loft_side loft_side_from_rational(const loft_rational *r)
{
    const loft_side s = { rational_side, r };
    return s;
}
loft_side loft_side_from_bspline(const loft_bspline *b)
{
    const loft_side s = { bspline_side, b };
    return s;
}
loft_side loft_side_from_nurbs(const loft_nurbs *n)
{
    const loft_side s = { nurbs_side, n };
    return s;
}

enum loft_status loft_coons_init(loft_coons *c, const loft_side u[2], const loft_side v[2],
                                 loft_real tol)
{
    loft_coons made = { { u[0], u[1] }, { v[0], v[1] }, { { { 0 } } } };
    loft_acc other[LOFT_AXES];

    if (!(tol >= 0))
        return LOFT_ERR_ARG;
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++) {
            loft_acc *corner = made.corner[a][b];
            u[b].eval(u[b].curve, a ? LOFT_UNIT(1) : 0, corner);
            v[a].eval(v[a].curve, b ? LOFT_UNIT(1) : 0, other);
            for (int i = 0; i < LOFT_AXES; i++)
                if (!(acc_distance(corner[i], other[i]) <= loft_to_acc(tol)))
                    return LOFT_ERR_ARG;
        }
    *c = made;
    return LOFT_OK;
}

/* Each term is within three coordinates. Rounding of the lerps, in 2^-33: 1 along t, 1 along s, 2
 * at the corners. */
enum loft_status loft_coons_eval(const loft_coons *c, loft_unit s, loft_unit t, loft_vec *out)
{
    loft_acc u[2][LOFT_AXES], v[2][LOFT_AXES], x[LOFT_AXES];

    if (!unit_valid(s) || !unit_valid(t))
        return LOFT_ERR_ARG;
    for (int k = 0; k < 2; k++) {
        c->u[k].eval(c->u[k].curve, s, u[k]);
        c->v[k].eval(c->v[k].curve, t, v[k]);
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc left  = v[0][i] - loft_acc_lerp(c->corner[0][0][i], c->corner[0][1][i], t);
        const loft_acc right = v[1][i] - loft_acc_lerp(c->corner[1][0][i], c->corner[1][1][i], t);
        x[i] = loft_acc_lerp(u[0][i], u[1][i], t) + loft_acc_lerp(left, right, s);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}


/* Bezier curves, slopes, curvatures. Range in q16, n = 9: a second derivative at an end is below
 * 72 * 4 * 2^15 < 2^23.2, a first one below 2^19.2. A derivative of a blend weighs its data by at
 * most 6. So blended second derivatives are below 2^26, first ones below 2^22, values below 2^20.
 * basis/interp.h accepts these for t in 0..1. */

/* The k-th derivative of one coordinate at t. */
static loft_acc bezier_at(const loft_bezier *b, int axis, unsigned k, loft_unit t)
{
    loft_acc c[LOFT_DEGREE_MAX + 1];
    int32_t factor = 1;

    if (k > b->degree)
        return 0;
    for (unsigned i = 0; i <= b->degree; i++)
        c[i] = loft_to_acc(b->p[i].axis[axis]);
    for (unsigned d = b->degree; d > b->degree - k; d--) {
        for (unsigned i = 0; i < d; i++)
            c[i] = c[i + 1] - c[i];
        factor *= (int32_t)d;
    }
    return factor * loft_bernstein_eval(c, b->degree - k, t);
}

/* Value 2 k + end is the k-th derivative at t = end, the order of loft_ends3_deriv and
 * loft_ends5_deriv. */
static loft_acc bezier_end(const loft_bezier *b, int axis, unsigned which)
{
    return bezier_at(b, axis, which / 2, which % 2 ? LOFT_UNIT(1) : 0);
}

static loft_acc blend_ends(const loft_acc e[], unsigned orders, unsigned k, loft_unit t)
{
    switch (orders) {
    case 1:  return k ? e[1] - e[0] : loft_acc_lerp(e[0], e[1], t);
    case 2:  return loft_ends3_deriv(e, k, t);
    default: return loft_ends5_deriv(e, k, t);
    }
}

enum loft_status loft_coons_bezier_init(loft_coons_bezier *c, const loft_bezier u[][2],
                                        const loft_bezier v[][2], unsigned orders, loft_real tol)
{
    if (orders < 1 || orders > LOFT_COONS_ORDERS || !(tol >= 0))
        return LOFT_ERR_ARG;
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++)
            for (int i = 0; i < LOFT_AXES; i++) {
                const loft_acc of_u = loft_to_acc(u[0][b].p[a ? u[0][b].degree : 0].axis[i]);
                const loft_acc of_v = loft_to_acc(v[0][a].p[b ? v[0][a].degree : 0].axis[i]);
                if (!(acc_distance(of_u, of_v) <= loft_to_acc(tol)))
                    return LOFT_ERR_ARG;
            }
    for (unsigned k = 0; k < LOFT_COONS_ORDERS; k++)
        for (int end = 0; end < 2; end++) {
            c->u[k][end] = u[k < orders ? k : 0][end];
            c->v[k][end] = v[k < orders ? k : 0][end];
        }
    c->orders = (uint8_t)orders;
    return LOFT_OK;
}

bool loft_coons_bezier_meets(const loft_coons_bezier *c, loft_real tol)
{
    for (unsigned a = 0; a < 2u * c->orders; a++)
        for (unsigned b = 0; b < 2u * c->orders; b++)
            for (int i = 0; i < LOFT_AXES; i++) {
                const loft_acc x = bezier_end(&c->u[b / 2][b % 2], i, a),
                               y = bezier_end(&c->v[a / 2][a % 2], i, b);
                if (!(acc_distance(x, y) <= loft_to_acc(tol)))
                    return false;
            }
    return true;
}

static loft_acc eval_axis(const loft_coons_bezier *c, int axis, unsigned j, unsigned k, loft_unit s,
                          loft_unit t)
{
    loft_acc e[2 * LOFT_COONS_ORDERS], along_t[2 * LOFT_COONS_ORDERS];
    const unsigned n = 2u * c->orders;

    for (unsigned a = 0; a < n; a++) {
        for (unsigned b = 0; b < n; b++)
            e[b] = bezier_end(&c->u[b / 2][b % 2], axis, a);
        along_t[a] = bezier_at(&c->v[a / 2][a % 2], axis, k, t) - blend_ends(e, c->orders, k, t);
    }
    for (unsigned b = 0; b < n; b++)
        e[b] = bezier_at(&c->u[b / 2][b % 2], axis, j, s);
    return blend_ends(e, c->orders, k, t) + blend_ends(along_t, c->orders, j, s);
}

enum loft_status loft_coons_bezier_deriv(const loft_coons_bezier *c, unsigned j, unsigned k,
                                         loft_unit s, loft_unit t, loft_vec *out)
{
    loft_acc x[LOFT_AXES];

    if (!unit_valid(s) || !unit_valid(t) || j > 1 || k > 1)
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = eval_axis(c, i, j, k, s, t);
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_coons_bezier_eval(const loft_coons_bezier *c, loft_unit s, loft_unit t,
                                        loft_vec *out)
{
    return loft_coons_bezier_deriv(c, 0, 0, s, t, out);
}

/* b_ij = (1 - j/n) u0_i + j/n u1_i + (1 - i/m) v0_j + i/m v1_j - (corners at i/m, j/n). All terms
 * are multiplied by m n <= 81, so the sum is below 3 * 81 * 2^47 < 2^55. */
enum loft_status loft_tensor_from_coons(const loft_coons_bezier *c, loft_vec net[])
{
    const loft_bezier *u = c->u[0], *v = c->v[0];
    const int32_t m = u[0].degree, n = v[0].degree;

    if (u[1].degree != m || v[1].degree != n || m < 1 || n < 1)
        return LOFT_ERR_ARG;
    for (int32_t i = 0; i <= m; i++)
        for (int32_t j = 0; j <= n; j++)
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                const loft_acc left = n * loft_to_acc(v[0].p[j].axis[axis]) -
                                      (n - j) * loft_to_acc(u[0].p[0].axis[axis]) -
                                      j * loft_to_acc(u[1].p[0].axis[axis]);
                const loft_acc right = n * loft_to_acc(v[1].p[j].axis[axis]) -
                                       (n - j) * loft_to_acc(u[0].p[m].axis[axis]) -
                                       j * loft_to_acc(u[1].p[m].axis[axis]);
                const loft_acc ruled = (n - j) * loft_to_acc(u[0].p[i].axis[axis]) +
                                       j * loft_to_acc(u[1].p[i].axis[axis]);
                const loft_acc x = loft_acc_ratio(m * ruled + (m - i) * left + i * right, m * n);
                if (!loft_acc_valid(x))
                    return LOFT_ERR_RANGE;
                net[i * (n + 1) + j].axis[axis] = loft_acc_round(x);
            }
    return LOFT_OK;
}

/* lib/surface/differential.c -- derivatives and curvatures, in numbers with an exponent of their
 * own
 * SPDX-License-Identifier: MIT
 *
 * Derivatives are de Casteljau's algorithm on the differences of the net. The differences are exact
 * in q16. A lerp x + (y - x) t errs by 3 roundings. Let a be the unit vector along the longer
 * tangent, P_u = p a. Let b be the unit vector in the tangent plane at a right angle to a,
 * P_v = q a + r b. In this frame the second fundamental form N . d^2P has the matrix
 *
 *     A = N_uu / p^2
 *     B = (N_uv - q/p N_uu) / (p r)
 *     C = (N_vv - 2 q/p N_uv + (q/p)^2 N_uu) / r^2            N_uu = P_uu . N ..
 *
 * with |q / p| <= 1. The principal curvatures are (A + C) / 2 +- sqrt(((A - C) / 2)^2 + B^2). So
 * only the curvatures themselves can cancel. With E = P_u^2, F = P_u P_v and D = |P_u x P_v|:
 * p^2 = E, q / p = F / E, p r = D, r^2 = D^2 / E.
 *
 * A rational patch is P = o + X / w with any o. If o is the rounded point itself, X is small, and
 *
 *     P_u  = (X_u - (P - o) w_u) / w
 *     P_uv = (X_uv - P_u w_v - P_v w_u - (P - o) w_uv) / w           P_uu, P_vv likewise
 *
 * Let e be the error of one operation (q16: 2^-61, floats: 2^-53), and x and y the largest
 * coefficients of X_u and X_uu over w. A row errs by 3 e of them. w is at least 1 / R of the
 * largest weight, so it errs by 3 rows R e of itself. w_u / w is at most n R. So P_u errs by (3
 * rows + 4) e x and by (3 rows R + 2) e |P_u|, where |P_u| <= x: at most 6 R (rows + 1) e x. P_uu
 * errs by the same multiple of y, and of 2 n R x because w_u and P_u err: at most 8 R (rows + 2) e
 * (y + 2 n R x).
 *
 * A Coons patch is the Boolean sum of coons.c. Each H depends on one parameter, so the derivative
 * is
 *
 *     S_jk = sum H_b^(k)(t) U_b^(j)(s) + sum H_a^(j)(s) (V_a^(k)(t) - sum H_b^(k)(t) C_ab)
 *
 * Its width is the same sum with the largest coefficient in place of each value and all signs
 * positive. A curve of degree 9 errs by 28 e of its largest coefficient, H by 17 e, a product and
 * at most 13 sums by 14 e. Together this is below 64 e of the width: 2^-55 in q16, 2^-47 in floats.
 */
#include "surface/differential.h"
#define MOST ((LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1))
#define WEIGHTS (-1)        /* given in place of an axis */

/* A control net: a patch with or without weights, or a triangle (m = n, its degree). */
typedef struct {
    const loft_vec *p;
    const loft_weighted *weighted;
    loft_vec origin;
    unsigned m, n;
    bool triangle;
} net;


static unsigned points_of(const net *s)
{
    return s->triangle ? LOFT_TRIANGLE_POINTS(s->m) : (s->m + 1) * (s->n + 1);
}

static const loft_vec *point_of(const net *s, unsigned k)
{
    return s->weighted ? &s->weighted[k].p : &s->p[k];
}

/* Coordinates are relative to the origin. */
static void load_net(const net *s, int axis, loft_sci c[])
{
    for (unsigned k = 0; k < points_of(s); k++) {
        const loft_sci w = s->weighted ? loft_sci_from_real(s->weighted[k].w) : loft_sci_one();
        c[k] = axis == WEIGHTS ? w
                               : loft_sci_of(loft_to_acc(point_of(s, k)->axis[axis]) -
                                             loft_to_acc(s->origin.axis[axis]));
        if (axis != WEIGHTS && s->weighted)
            c[k] = loft_sci_mul(c[k], w);
    }
}

/* In floats, products of up to six coordinates and small numbers stay below 2^1023. */
static bool net_valid(const net *s)
{
    const loft_sci limit = loft_sci_pow(loft_sci_from_int(2), 100);

    for (unsigned k = 0; k < points_of(s); k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (!loft_sci_less(loft_sci_abs(loft_sci_from_real(point_of(s, k)->axis[i])), limit))
                return false;
    return true;
}

static loft_sci largest_abs(const loft_sci c[], unsigned count)
{
    loft_sci most = loft_sci_zero();

    for (unsigned k = 0; k < count; k++)
        if (loft_sci_less(most, loft_sci_abs(c[k])))
            most = loft_sci_abs(c[k]);
    return most;
}

/* The derivative of order a by u and order b by v, in one axis, and the largest coefficient of its
 * net. */
typedef struct {
    loft_sci value, width;
} slope;

/* Rows keep their stride n + 1. */
static slope tensor_slope(const net *s, int axis, unsigned a, unsigned b, loft_sci u, loft_sci v)
{
    const unsigned stride = s->n + 1;
    unsigned m = s->m, n = s->n;
    slope r = { loft_sci_zero(), loft_sci_zero() };
    int32_t factor = 1;
    loft_sci c[MOST];

    if (a > m || b > n)
        return r;
    load_net(s, axis, c);
    for (; a > 0; a--, m--) {
        factor *= (int32_t)m;
        for (unsigned k = 0; k < m * stride; k++)
            c[k] = loft_sci_sub(c[k + stride], c[k]);
    }
    for (; b > 0; b--, n--) {
        factor *= (int32_t)n;
        for (unsigned k = 0; k + 1 < (m + 1) * stride; k++)
            c[k] = loft_sci_sub(c[k + 1], c[k]);    /* values beyond the n-th of a row are unused */
    }
    for (unsigned i = 0; i <= m; i++) {
        const loft_sci most = largest_abs(c + i * stride, n + 1);
        if (loft_sci_less(r.width, most))
            r.width = most;
    }
    for (; m > 0; m--)
        for (unsigned i = 0; i < m; i++)
            for (unsigned j = 0; j <= n; j++)
                c[i * stride + j] = loft_sci_lerp(c[i * stride + j], c[(i + 1) * stride + j], u);
    for (; n > 0; n--)
        for (unsigned j = 0; j < n; j++)
            c[j] = loft_sci_lerp(c[j], c[j + 1], v);
    r.value = loft_sci_mul(c[0], loft_sci_from_int(factor));
    r.width = loft_sci_mul(r.width, loft_sci_from_int(factor));
    return r;
}

/* u and v are the second and third coordinate. A row of the algorithm replaces b_ijk by the three
 * coefficients below it. */
static slope triangle_slope(const net *s, int axis, unsigned a, unsigned b, loft_sci u, loft_sci v)
{
    unsigned degree = s->m;
    slope r = { loft_sci_zero(), loft_sci_zero() };
    int32_t factor = 1;
    loft_sci c[LOFT_TRIANGLE_MAX];

    if (a + b > degree)
        return r;
    load_net(s, axis, c);
    for (; a + b > 0; degree--) {
        const unsigned along = a > 0 ? 0 : 1;       /* to T2, or to T3 */
        factor *= (int32_t)degree;
        for (unsigned row = 0, k = 0; row < degree; row++)
            for (unsigned j = 0; j <= row; j++, k++)
                c[k] = loft_sci_sub(c[k + row + 1 + along], c[k]);
        if (a > 0)
            a--;
        else
            b--;
    }
    r.width = largest_abs(c, LOFT_TRIANGLE_POINTS(degree));
    for (; degree > 0; degree--)
        for (unsigned row = 0, k = 0; row < degree; row++)
            for (unsigned j = 0; j <= row; j++, k++) {
                const loft_sci by_u = loft_sci_mul(loft_sci_sub(c[k + row + 1], c[k]), u);
                const loft_sci by_v = loft_sci_mul(loft_sci_sub(c[k + row + 2], c[k]), v);
                c[k] = loft_sci_add(c[k], loft_sci_add(by_u, by_v));
            }
    r.value = loft_sci_mul(c[0], loft_sci_from_int(factor));
    r.width = loft_sci_mul(r.width, loft_sci_from_int(factor));
    return r;
}

static slope net_slope(const net *s, int axis, unsigned a, unsigned b, loft_sci u, loft_sci v)
{
    return s->triangle ? triangle_slope(s, axis, a, b, u, v) : tensor_slope(s, axis, a, b, u, v);
}

static void max_width(loft_sci *width, loft_sci other)
{
    if (loft_sci_less(*width, other))
        *width = other;
}

static void eval_net(const net *s, loft_unit u, loft_unit v, loft_differential *out)
{
    const loft_sci at_u = loft_sci_from_unit(u), at_v = loft_sci_from_unit(v);

    out->width_u = out->width_v = loft_sci_zero();
    for (int i = 0; i < LOFT_AXES; i++) {
        const slope by_u = net_slope(s, i, 1, 0, at_u, at_v),
                    by_v = net_slope(s, i, 0, 1, at_u, at_v);
        out->u[i] = by_u.value;
        out->v[i] = by_v.value;
        max_width(&out->width_u, by_u.width);
        max_width(&out->width_v, by_v.width);
        out->uu[i] = net_slope(s, i, 2, 0, at_u, at_v).value;
        out->uv[i] = net_slope(s, i, 1, 1, at_u, at_v).value;
        out->vv[i] = net_slope(s, i, 0, 2, at_u, at_v).value;
    }
}

static bool unit_valid(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

enum loft_status loft_tensor_differential(const loft_tensor *s, loft_unit u, loft_unit v,
                                          loft_differential *out)
{
    const net n = { s->p, NULL, s->p[0], s->m, s->n, false };

    if (!unit_valid(u) || !unit_valid(v))
        return LOFT_ERR_ARG;
    if (!net_valid(&n))
        return LOFT_ERR_RANGE;
    eval_net(&n, u, v, out);
    return LOFT_OK;
}

enum loft_status loft_triangle_differential(const loft_triangle *t, loft_bary at,
                                            loft_differential *out)
{
    const net n = { t->p, NULL, t->p[0], t->degree, t->degree, true };

    if (!loft_bary_inside(at))
        return LOFT_ERR_ARG;
    if (!net_valid(&n))
        return LOFT_ERR_RANGE;
    eval_net(&n, at.v, at.w, out);
    return LOFT_OK;
}


/* Rational patches */

/* Turn the derivatives of X, in place, into those of X / w. d holds the derivatives of w. */
static void divide_by_weight(loft_differential *x, int i, loft_sci offset, loft_sci w,
                             const loft_sci d[5])
{
    const loft_sci two = loft_sci_from_int(2);

    x->u[i] = loft_sci_div(loft_sci_sub_product(x->u[i], offset, d[0]), w);
    x->v[i] = loft_sci_div(loft_sci_sub_product(x->v[i], offset, d[1]), w);
    x->uu[i] = loft_sci_sub_product(
        loft_sci_sub_product(x->uu[i], loft_sci_mul(two, x->u[i]), d[0]), offset, d[2]);
    x->uv[i] = loft_sci_sub_product(
        loft_sci_sub_product(loft_sci_sub_product(x->uv[i], x->u[i], d[1]), x->v[i], d[0]), offset,
        d[3]);
    x->vv[i] = loft_sci_sub_product(
        loft_sci_sub_product(x->vv[i], loft_sci_mul(two, x->v[i]), d[1]), offset, d[4]);
    x->uu[i] = loft_sci_div(x->uu[i], w);
    x->uv[i] = loft_sci_div(x->uv[i], w);
    x->vv[i] = loft_sci_div(x->vv[i], w);
}

/* The origin of the net is the point itself. */
static void eval_rational(const net *s, loft_unit u, loft_unit v, loft_differential *out)
{
    static const uint8_t order[5][2] = { { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } };
    const loft_sci at_u = loft_sci_from_unit(u), at_v = loft_sci_from_unit(v);
    const loft_sci w = net_slope(s, WEIGHTS, 0, 0, at_u, at_v).value;
    loft_sci d[5];

    eval_net(s, u, v, out);
    for (int k = 0; k < 5; k++)
        d[k] = net_slope(s, WEIGHTS, order[k][0], order[k][1], at_u, at_v).value;
    for (int i = 0; i < LOFT_AXES; i++)
        divide_by_weight(out, i, loft_sci_div(net_slope(s, i, 0, 0, at_u, at_v).value, w), w, d);
    out->width_u = loft_sci_div(out->width_u, w);
    out->width_v = loft_sci_div(out->width_v, w);
}

enum loft_status loft_tensor_rational_differential(const loft_tensor_rational *s, loft_unit u,
                                                   loft_unit v, loft_differential *out)
{
    net n = { NULL, s->p, s->p[0].p, s->m, s->n, false };

    if (!unit_valid(u) || !unit_valid(v))
        return LOFT_ERR_ARG;
    if (!net_valid(&n))
        return LOFT_ERR_RANGE;
    n.origin = loft_tensor_rational_eval(s, u, v);
    eval_rational(&n, u, v, out);
    return LOFT_OK;
}

enum loft_status loft_triangle_rational_differential(const loft_triangle_rational *t, loft_bary at,
                                                     loft_differential *out)
{
    net n = { NULL, t->p, t->p[0].p, t->degree, t->degree, true };

    if (!loft_bary_inside(at))
        return LOFT_ERR_ARG;
    if (!net_valid(&n))
        return LOFT_ERR_RANGE;
    n.origin = loft_triangle_rational_eval(t, at);
    eval_rational(&n, at.v, at.w, out);
    return LOFT_OK;
}


/* Coons patches */

#define ENDS (2 * LOFT_COONS_ORDERS)    /* 2 k + end is the k-th derivative at that end */

/* The coefficients of the k-th derivative, k <= degree, without the returned factor. */
static loft_sci difference_net(loft_sci c[], unsigned degree, unsigned k)
{
    int32_t factor = 1;

    for (; k > 0; k--, degree--) {
        factor *= (int32_t)degree;
        for (unsigned i = 0; i < degree; i++)
            c[i] = loft_sci_sub(c[i + 1], c[i]);
    }
    return loft_sci_from_int(factor);
}

/* The k-th derivative at t of a polynomial with `degree` + 1 coefficients, which are
 * overwritten. */
static slope line_slope(loft_sci c[], unsigned degree, unsigned k, loft_sci t)
{
    slope r = { loft_sci_zero(), loft_sci_zero() };

    if (k > degree)
        return r;
    const loft_sci factor = difference_net(c, degree, k);
    degree -= k;
    r.width = loft_sci_mul(largest_abs(c, degree + 1), factor);
    r.value = loft_sci_mul(loft_sci_deriv(c, degree, 0, t), factor);
    return r;
}

static void load_curve(const loft_bezier *b, int axis, loft_acc origin, loft_sci c[])
{
    for (unsigned i = 0; i <= b->degree; i++)
        c[i] = loft_sci_of(loft_to_acc(b->p[i].axis[axis]) - origin);
}

static slope curve_slope(const loft_bezier *b, int axis, loft_acc origin, unsigned k, loft_sci t)
{
    loft_sci c[LOFT_DEGREE_MAX + 1];

    load_curve(b, axis, origin, c);
    return line_slope(c, b->degree, k, t);
}

/* The derivative of a curve at its end, from its coefficients. `which` is 2 k + end. */
static slope end_slope(const loft_bezier *b, int axis, loft_acc origin, unsigned which)
{
    const unsigned k = which / 2;
    loft_sci c[LOFT_DEGREE_MAX + 1];
    slope r = { loft_sci_zero(), loft_sci_zero() };

    if (k > b->degree)
        return r;
    load_curve(b, axis, origin, c);
    const loft_sci factor = difference_net(c, b->degree, k);
    r.value = loft_sci_mul(factor, c[which % 2 ? b->degree - k : 0]);
    r.width = loft_sci_abs(r.value);
    return r;
}

/* H_b has Bernstein coefficients of degree 2 orders - 1: integers over 1, 3, 5 or 20. */
static slope blend_slope(unsigned orders, unsigned b, unsigned k, loft_sci t)
{
    static const int8_t whole[LOFT_COONS_ORDERS][ENDS][ENDS] = {
        { { 1, 0 }, { 0, 1 } },
        { { 1, 1, 0, 0 }, { 0, 0, 1, 1 }, { 0, 1, 0, 0 }, { 0, 0, -1, 0 } },
        { { 1, 1, 1, 0, 0, 0 },
          { 0, 0, 0, 1, 1, 1 },
          { 0, 1, 2, 0, 0, 0 },
          { 0, 0, 0, -2, -1, 0 },
          { 0, 0, 1, 0, 0, 0 },
          { 0, 0, 0, 1, 0, 0 } }
    };
    static const int8_t over[][LOFT_COONS_ORDERS] = { { 1 }, { 1, 3 }, { 1, 5, 20 } };
    const loft_sci part = loft_sci_from_int(over[orders - 1][b / 2]);
    loft_sci c[ENDS];

    for (unsigned i = 0; i < 2 * orders; i++)
        c[i] = loft_sci_from_int(whole[orders - 1][b][i]);
    slope r = line_slope(c, 2 * orders - 1, k, t);
    r.value = loft_sci_div(r.value, part);
    r.width = loft_sci_div(r.width, part);
    return r;
}

/* In one axis: the curves at s and t with their derivatives, the end derivatives of U_b, and
 * H_b. */
typedef struct {
    slope u[ENDS][3], v[ENDS][3], corner[ENDS][ENDS];
    slope by_s[ENDS][3], by_t[ENDS][3];
} blended;

static void set_blends(blended *x, unsigned orders, loft_sci s, loft_sci t)
{
    for (unsigned b = 0; b < 2 * orders; b++)
        for (unsigned k = 0; k < 3; k++) {
            x->by_s[b][k] = blend_slope(orders, b, k, s);
            x->by_t[b][k] = blend_slope(orders, b, k, t);
        }
}

/* Points are relative to a corner, derivatives to 0. */
static void set_curves(blended *x, const loft_coons_bezier *c, int axis, loft_sci s, loft_sci t)
{
    const loft_acc first = loft_to_acc(c->u[0][0].p[0].axis[axis]);

    for (unsigned b = 0; b < 2u * c->orders; b++) {
        const loft_bezier *u = &c->u[b / 2][b % 2], *v = &c->v[b / 2][b % 2];
        const loft_acc origin = b < 2 ? first : 0;
        for (unsigned k = 0; k < 3; k++) {
            x->u[b][k] = curve_slope(u, axis, origin, k, s);
            x->v[b][k] = curve_slope(v, axis, origin, k, t);
        }
        for (unsigned a = 0; a < 2u * c->orders; a++)
            x->corner[a][b] = end_slope(u, axis, origin, a);
    }
}

static void add_product(slope *sum, slope h, slope x)
{
    sum->value = loft_sci_add(sum->value, loft_sci_mul(h.value, x.value));
    sum->width = loft_sci_add(sum->width, loft_sci_mul(h.width, x.width));
}

/* The Boolean sum of coons.c, differentiated j times by s and k times by t. */
static slope coons_slope(const blended *x, unsigned ends, unsigned j, unsigned k)
{
    slope sum = { loft_sci_zero(), loft_sci_zero() };

    for (unsigned b = 0; b < ends; b++)
        add_product(&sum, x->by_t[b][k], x->u[b][j]);
    for (unsigned a = 0; a < ends; a++) {
        slope rest = x->v[a][k];
        rest.value = loft_sci_neg(rest.value);
        for (unsigned b = 0; b < ends; b++)
            add_product(&rest, x->by_t[b][k], x->corner[a][b]);
        rest.value = loft_sci_neg(rest.value);
        add_product(&sum, x->by_s[a][j], rest);
    }
    return sum;
}

static bool curves_valid(const loft_coons_bezier *c)
{
    for (unsigned k = 0; k < 2u * c->orders; k++) {
        const loft_bezier *u = &c->u[k / 2][k % 2], *v = &c->v[k / 2][k % 2];
        const net along_u = { u->p, NULL, u->p[0], u->degree, 0, false };
        const net along_v = { v->p, NULL, v->p[0], v->degree, 0, false };
        if (!net_valid(&along_u) || !net_valid(&along_v))
            return false;
    }
    return true;
}

enum loft_status loft_coons_bezier_differential(const loft_coons_bezier *c, loft_unit s,
                                                loft_unit t, loft_differential *out)
{
    const loft_sci at_s = loft_sci_from_unit(s), at_t = loft_sci_from_unit(t);
    const unsigned ends = 2u * c->orders;
    blended x;

    if (!unit_valid(s) || !unit_valid(t))
        return LOFT_ERR_ARG;
    if (!curves_valid(c))
        return LOFT_ERR_RANGE;
    set_blends(&x, c->orders, at_s, at_t);
    out->width_u = out->width_v = loft_sci_zero();
    for (int i = 0; i < LOFT_AXES; i++) {
        set_curves(&x, c, i, at_s, at_t);
        const slope by_u = coons_slope(&x, ends, 1, 0), by_v = coons_slope(&x, ends, 0, 1);
        out->u[i] = by_u.value;
        out->v[i] = by_v.value;
        max_width(&out->width_u, by_u.width);
        max_width(&out->width_v, by_v.width);
        out->uu[i] = coons_slope(&x, ends, 2, 0).value;
        out->uv[i] = coons_slope(&x, ends, 1, 1).value;
        out->vv[i] = coons_slope(&x, ends, 0, 2).value;
    }
    return LOFT_OK;
}

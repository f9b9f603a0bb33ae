/* lib/surface/local.c -- derivatives and what follows from them, in numbers with an exponent of their own
 * SPDX-License-Identifier: MIT
 *
 * Derivatives are schemes of de Casteljau on the differences of the net, which are exact in q16; a lerp x + (y - x) t errs by
 * 3 roundings. In the frame of the unit vectors a along the longer tangent, say P_u = p a, and b at a right angle to it in
 * the tangent plane, P_v = q a + r b, the second fundamental form N . d^2P has the matrix
 *
 *     A = N_uu / p^2     B = (N_uv - q/p N_uu) / (p r)     C = (N_vv - 2 q/p N_uv + (q/p)^2 N_uu) / r^2      N_uu = P_uu . N ..
 *
 * with |q / p| <= 1, and the principal curvatures (A + C) / 2 +- sqrt(((A - C) / 2)^2 + B^2): nothing cancels but the
 * curvatures themselves. With E = P_u^2, F = P_u P_v and D = |P_u x P_v|: p^2 = E, q / p = F / E, p r = D, r^2 = D^2 / E.
 *
 * A rational patch is P = o + X / w with any o. With o the point itself, but for its rounding, X is small, and
 *
 *     P_u = (X_u - (P - o) w_u) / w     P_uv = (X_uv - P_u w_v - P_v w_u - (P - o) w_uv) / w     P_uu, P_vv likewise
 */
#include "surface/local.h"
#include "num/exact.h"      /* loft_exact_admits */

#define MOST ((LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1))
#define WEIGHTS (-1)        /* in place of an axis */

/* What has coefficients: a patch with or without weights, or a triangle (m = n, its degree). */
typedef struct {
    const loft_vec *p;
    const loft_weighted *weighted;
    loft_vec origin;
    unsigned m, n;
    bool triangle;
} net;

static loft_sci sci_lerp(loft_sci x, loft_sci y, loft_sci t)
{
    return loft_sci_add(x, loft_sci_mul(loft_sci_sub(y, x), t));
}


static unsigned points_of(const net *s)
{
    return s->triangle ? LOFT_TRIANGLE_POINTS(s->m) : (s->m + 1) * (s->n + 1);
}

static const loft_vec *point_of(const net *s, unsigned k)
{
    return s->weighted ? &s->weighted[k].p : &s->p[k];
}

/* Coordinates count from the origin. */
static void load(const net *s, int axis, loft_sci c[])
{
    for (unsigned k = 0; k < points_of(s); k++) {
        const loft_sci w = s->weighted ? loft_sci_from_real(s->weighted[k].w) : loft_sci_one();
        c[k] = axis == WEIGHTS ? w
             : loft_sci_of(loft_wide(point_of(s, k)->axis[axis]) - loft_wide(s->origin.axis[axis]));
        if (axis != WEIGHTS && s->weighted)
            c[k] = loft_sci_mul(c[k], w);
    }
}

static bool admitted(const net *s)
{
    for (unsigned k = 0; k < points_of(s); k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (!loft_exact_admits(point_of(s, k)->axis[i]))
                return false;
    return true;
}

static loft_sci largest_of(const loft_sci c[], unsigned count)
{
    loft_sci most = loft_sci_zero();

    for (unsigned k = 0; k < count; k++)
        if (loft_sci_less(most, loft_sci_size(c[k])))
            most = loft_sci_size(c[k]);
    return most;
}

/* The derivative of order a by u and b by v at a place, of one axis, and its largest coefficient. */
typedef struct {
    loft_sci value, width;
} slope;

/* Rows stay n + 1 apart. */
static slope tensor_slope(const net *s, int axis, unsigned a, unsigned b, loft_sci u, loft_sci v)
{
    const unsigned stride = s->n + 1;
    unsigned m = s->m, n = s->n;
    slope r = { loft_sci_zero(), loft_sci_zero() };
    int32_t factor = 1;
    loft_sci c[MOST];

    if (a > m || b > n)
        return r;
    load(s, axis, c);
    for (; a > 0; a--, m--) {
        factor *= (int32_t)m;
        for (unsigned k = 0; k < m * stride; k++)
            c[k] = loft_sci_sub(c[k + stride], c[k]);
    }
    for (; b > 0; b--, n--) {
        factor *= (int32_t)n;
        for (unsigned k = 0; k + 1 < (m + 1) * stride; k++)
            c[k] = loft_sci_sub(c[k + 1], c[k]);    /* what is beyond the n-th of a row is of no use, and not used */
    }
    for (unsigned i = 0; i <= m; i++) {
        const loft_sci most = largest_of(c + i * stride, n + 1);
        if (loft_sci_less(r.width, most))
            r.width = most;
    }
    for (; m > 0; m--)
        for (unsigned i = 0; i < m; i++)
            for (unsigned j = 0; j <= n; j++)
                c[i * stride + j] = sci_lerp(c[i * stride + j], c[(i + 1) * stride + j], u);
    for (; n > 0; n--)
        for (unsigned j = 0; j < n; j++)
            c[j] = sci_lerp(c[j], c[j + 1], v);
    r.value = loft_sci_mul(c[0], loft_sci_from_int(factor));
    r.width = loft_sci_mul(r.width, loft_sci_from_int(factor));
    return r;
}

/* u and v are the second and third coordinate; a row of the scheme replaces b_ijk by the three below it. */
static slope triangle_slope(const net *s, int axis, unsigned a, unsigned b, loft_sci u, loft_sci v)
{
    unsigned degree = s->m;
    slope r = { loft_sci_zero(), loft_sci_zero() };
    int32_t factor = 1;
    loft_sci c[LOFT_TRIANGLE_MOST];

    if (a + b > degree)
        return r;
    load(s, axis, c);
    for (; a + b > 0; degree--) {
        const unsigned along = a > 0 ? 0 : 1;       /* to T2, or to T3 */
        factor *= (int32_t)degree;
        for (unsigned row = 0, k = 0; row < degree; row++)
            for (unsigned j = 0; j <= row; j++, k++)
                c[k] = loft_sci_sub(c[k + row + 1 + along], c[k]);
        if (a > 0) a--; else b--;
    }
    r.width = largest_of(c, LOFT_TRIANGLE_POINTS(degree));
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

static slope slope_of(const net *s, int axis, unsigned a, unsigned b, loft_sci u, loft_sci v)
{
    return s->triangle ? triangle_slope(s, axis, a, b, u, v) : tensor_slope(s, axis, a, b, u, v);
}

static void widen(loft_sci *width, loft_sci other)
{
    if (loft_sci_less(*width, other))
        *width = other;
}

static void find(const net *s, loft_unit u, loft_unit v, loft_local *out)
{
    const loft_sci at_u = loft_sci_from_unit(u), at_v = loft_sci_from_unit(v);

    out->width_u = out->width_v = loft_sci_zero();
    for (int i = 0; i < LOFT_AXES; i++) {
        const slope by_u = slope_of(s, i, 1, 0, at_u, at_v), by_v = slope_of(s, i, 0, 1, at_u, at_v);
        out->u[i] = by_u.value;
        out->v[i] = by_v.value;
        widen(&out->width_u, by_u.width);
        widen(&out->width_v, by_v.width);
        out->uu[i] = slope_of(s, i, 2, 0, at_u, at_v).value;
        out->uv[i] = slope_of(s, i, 1, 1, at_u, at_v).value;
        out->vv[i] = slope_of(s, i, 0, 2, at_u, at_v).value;
    }
}

static bool within(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

enum loft_status loft_tensor_local(const loft_tensor *s, loft_unit u, loft_unit v, loft_local *out)
{
    const net n = { s->p, NULL, s->p[0], s->m, s->n, false };

    if (!within(u) || !within(v))
        return LOFT_ERR_ARG;
    if (!admitted(&n))
        return LOFT_ERR_RANGE;
    find(&n, u, v, out);
    return LOFT_OK;
}

enum loft_status loft_triangle_local(const loft_triangle *t, loft_bary at, loft_local *out)
{
    const net n = { t->p, NULL, t->p[0], t->degree, t->degree, true };

    if (!loft_bary_inside(at))
        return LOFT_ERR_ARG;
    if (!admitted(&n))
        return LOFT_ERR_RANGE;
    find(&n, at.v, at.w, out);
    return LOFT_OK;
}


/* Rational patches */

static loft_sci less_product(loft_sci x, loft_sci a, loft_sci b) { return loft_sci_sub(x, loft_sci_mul(a, b)); }

/* From the derivatives of X, in place, and those of w to those of X / w. */
static void divide(loft_local *x, int i, loft_sci offset, loft_sci w, const loft_sci d[5])
{
    const loft_sci two = loft_sci_from_int(2);

    x->u[i] = loft_sci_div(less_product(x->u[i], offset, d[0]), w);
    x->v[i] = loft_sci_div(less_product(x->v[i], offset, d[1]), w);
    x->uu[i] = less_product(less_product(x->uu[i], loft_sci_mul(two, x->u[i]), d[0]), offset, d[2]);
    x->uv[i] = less_product(less_product(less_product(x->uv[i], x->u[i], d[1]), x->v[i], d[0]), offset, d[3]);
    x->vv[i] = less_product(less_product(x->vv[i], loft_sci_mul(two, x->v[i]), d[1]), offset, d[4]);
    x->uu[i] = loft_sci_div(x->uu[i], w);
    x->uv[i] = loft_sci_div(x->uv[i], w);
    x->vv[i] = loft_sci_div(x->vv[i], w);
}

enum loft_status loft_tensor_rational_local(const loft_tensor_rational *s, loft_unit u, loft_unit v, loft_local *out)
{
    const loft_sci at_u = loft_sci_from_unit(u), at_v = loft_sci_from_unit(v);
    net n = { NULL, s->p, s->p[0].p, s->m, s->n, false };

    if (!within(u) || !within(v))
        return LOFT_ERR_ARG;
    if (!admitted(&n))
        return LOFT_ERR_RANGE;
    n.origin = loft_tensor_rational_eval(s, u, v);
    find(&n, u, v, out);

    const loft_sci w = tensor_slope(&n, WEIGHTS, 0, 0, at_u, at_v).value;
    const loft_sci d[5] = { tensor_slope(&n, WEIGHTS, 1, 0, at_u, at_v).value, tensor_slope(&n, WEIGHTS, 0, 1, at_u, at_v).value,
                            tensor_slope(&n, WEIGHTS, 2, 0, at_u, at_v).value, tensor_slope(&n, WEIGHTS, 1, 1, at_u, at_v).value,
                            tensor_slope(&n, WEIGHTS, 0, 2, at_u, at_v).value };
    for (int i = 0; i < LOFT_AXES; i++)
        divide(out, i, loft_sci_div(tensor_slope(&n, i, 0, 0, at_u, at_v).value, w), w, d);
    out->width_u = loft_sci_div(out->width_u, w);
    out->width_v = loft_sci_div(out->width_v, w);
    return LOFT_OK;
}


/* Normal and curvatures */

#if LOFT_AXES >= 3

static loft_sci dot(const loft_sci x[], const loft_sci y[])
{
    return loft_sci_add(loft_sci_add(loft_sci_mul(x[0], y[0]), loft_sci_mul(x[1], y[1])), loft_sci_mul(x[2], y[2]));
}

/* P_u x P_v and the square of its length; false where it is no more than 2^-30 of the widths. */
static bool cross(const loft_local *at, loft_sci n[3], loft_sci *square)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = less_product(loft_sci_mul(at->u[j], at->v[k]), at->u[k], at->v[j]);
    }
    *square = dot(n, n);
    const loft_sci least = loft_sci_div(loft_sci_mul(at->width_u, at->width_v), loft_sci_from_int((int32_t)1 << 30));
    return loft_sci_less(loft_sci_mul(least, least), *square);
}

enum loft_status loft_local_normal(const loft_local *at, loft_vec *out)
{
    loft_sci n[3], square;
    loft_acc x = 0;

    if (!cross(at, n, &square))
        return LOFT_SINGULAR;
    const loft_sci length = loft_sci_sqrt(square);
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = i < 3 && loft_sci_wide(loft_sci_div(n[i], length), &x) ? loft_acc_round(x) : 0;
    return LOFT_OK;
}

static bool take(loft_sci gauss, loft_sci mean, loft_sci least, loft_sci most, loft_curvatures *out)
{
    loft_curvatures k;

    if (!loft_sci_wide(gauss, &k.gauss) || !loft_sci_wide(mean, &k.mean) || !loft_sci_wide(least, &k.least) ||
        !loft_sci_wide(most, &k.most))
        return false;
    *out = k;
    return true;
}

enum loft_status loft_local_curvatures(const loft_local *at, loft_curvatures *out)
{
    loft_sci n[3], square;

    if (!cross(at, n, &square))
        return LOFT_SINGULAR;
    const bool swap = loft_sci_less(dot(at->u, at->u), dot(at->v, at->v));
    const loft_sci *u = swap ? at->v : at->u, *uu = swap ? at->vv : at->uu, *vv = swap ? at->uu : at->vv;
    const loft_sci length = loft_sci_sqrt(square), e = dot(u, u), f = loft_sci_div(dot(at->u, at->v), e);
    const loft_sci n_uu = dot(uu, n), n_uv = dot(at->uv, n), n_vv = dot(vv, n);       /* times the length */

    const loft_sci lean = less_product(n_uv, f, n_uu);
    const loft_sci a = loft_sci_div(n_uu, loft_sci_mul(e, length)), b = loft_sci_div(lean, square);
    const loft_sci c = loft_sci_div(loft_sci_mul(less_product(less_product(n_vv, f, n_uv), f, lean), e), loft_sci_mul(square, length));
    const loft_sci half = loft_sci_div(loft_sci_one(), loft_sci_from_int(2));
    const loft_sci mean = loft_sci_mul(half, loft_sci_add(a, c)), apart = loft_sci_mul(half, loft_sci_sub(a, c));
    const loft_sci spread = loft_sci_sqrt(loft_sci_add(loft_sci_mul(apart, apart), loft_sci_mul(b, b)));

    return take(less_product(loft_sci_mul(a, c), b, b), mean, loft_sci_sub(mean, spread), loft_sci_add(mean, spread), out)
         ? LOFT_OK : LOFT_ERR_RANGE;
}

#else

enum loft_status loft_local_normal(const loft_local *at, loft_vec *out)                     { (void)at; (void)out; return LOFT_SINGULAR; }
enum loft_status loft_local_curvatures(const loft_local *at, loft_curvatures *out)          { (void)at; (void)out; return LOFT_SINGULAR; }

#endif

/* A coordinate that is not above 1 / most: rounded to nearest and then one step back where it is. */
loft_real loft_ball_radius(const loft_curvatures *k)
{
    loft_acc radius;

    if (!(k->most > 0) || !loft_sci_wide(loft_sci_div(loft_sci_one(), loft_sci_of(k->most)), &radius))
        return LOFT_REAL_MAX;
    const loft_acc below = radius - loft_real_grain(radius);
    if (!loft_acc_fits(radius))
        return LOFT_REAL_MAX;
    return loft_wide(loft_acc_round(radius)) <= radius ? loft_acc_round(radius) : loft_acc_round(below);
}

/* lib/surface/curvatures.c -- normal and curvatures from the derivatives of differential.h
 * SPDX-License-Identifier: MIT
 *
 * The longer tangent is u, and w = v - f u is at a right angle to it, f = u v / u u. In the unit
 * vectors along u and w the second fundamental form is the matrix a b / b c. Its eigenvalues are
 * the principal curvatures m -+ s with m = (a + c) / 2, d = (a - c) / 2, s = |(d, b)|. The
 * direction of the larger one is (d + s, b), or (b, s - d), which is longer for d < 0.
 */
#include "surface/differential.h"

#if LOFT_AXES >= 3

/* P_u x P_v and its squared length. False when the length is at most 2^-30 of the widths. */
static bool cross_tangents(const loft_differential *at, loft_sci n[3], loft_sci *square)
{
    loft_sci_cross3(at->u, at->v, n);
    *square = loft_sci_dot3(n, n);
    const loft_sci least = loft_sci_div(loft_sci_mul(at->width_u, at->width_v),
                                        loft_sci_from_int((int32_t)1 << 30));
    return loft_sci_less(loft_sci_mul(least, least), *square);
}

enum loft_status loft_differential_normal(const loft_differential *at, loft_vec *out)
{
    loft_sci n[3], square;
    loft_acc x = 0;

    if (!cross_tangents(at, n, &square))
        return LOFT_SINGULAR;
    const loft_sci length = loft_sci_sqrt(square);
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = i < 3 && loft_sci_to_acc(loft_sci_div(n[i], length), &x) ? loft_acc_round(x)
                                                                                : 0;
    return LOFT_OK;
}

static bool set_curvatures(loft_sci gauss, loft_sci mean, loft_sci least, loft_sci most,
                           loft_curvatures *out)
{
    loft_curvatures k;

    if (!loft_sci_to_acc(gauss, &k.gauss) || !loft_sci_to_acc(mean, &k.mean) ||
        !loft_sci_to_acc(least, &k.min) || !loft_sci_to_acc(most, &k.max))
        return false;
    *out = k;
    return true;
}

/* The second fundamental form in unit vectors; those. */
typedef struct {
    loft_sci a, b, c, along[3], across[3];
} form;

static bool find_form(const loft_differential *at, form *out)
{
    loft_sci n[3], square;

    if (!cross_tangents(at, n, &square))
        return false;
    const bool swap = loft_sci_less(loft_sci_dot3(at->u, at->u), loft_sci_dot3(at->v, at->v));
    const loft_sci *u = swap ? at->v : at->u, *v = swap ? at->u : at->v,
                   *uu = swap ? at->vv : at->uu, *vv = swap ? at->uu : at->vv;
    const loft_sci length = loft_sci_sqrt(square), e = loft_sci_dot3(u, u),
                   f = loft_sci_div(loft_sci_dot3(at->u, at->v), e);
    /* times the length */
    const loft_sci n_uu = loft_sci_dot3(uu, n), n_uv = loft_sci_dot3(at->uv, n),
                   n_vv = loft_sci_dot3(vv, n);
    const loft_sci lean = loft_sci_sub_product(n_uv, f, n_uu);

    out->a = loft_sci_div(n_uu, loft_sci_mul(e, length));
    out->b = loft_sci_div(lean, square);
    out->c = loft_sci_div(
        loft_sci_mul(loft_sci_sub_product(loft_sci_sub_product(n_vv, f, n_uv), f, lean), e),
        loft_sci_mul(square, length));
    const loft_sci root = loft_sci_sqrt(e);
    for (int i = 0; i < 3; i++) {
        out->along[i] = loft_sci_div(u[i], root);
        out->across[i] = loft_sci_div(loft_sci_mul(loft_sci_sub_product(v[i], f, u[i]), root),
                                      length);
    }
    return true;
}

/* Half the difference of a and c, and of the curvatures. */
static loft_sci spread_of(const form *x, loft_sci *apart)
{
    *apart = loft_sci_mul(loft_sci_power2(-1), loft_sci_sub(x->a, x->c));
    return loft_sci_sqrt(loft_sci_add(loft_sci_mul(*apart, *apart), loft_sci_mul(x->b, x->b)));
}

enum loft_status loft_differential_curvatures(const loft_differential *at, loft_curvatures *out)
{
    loft_sci apart;
    form x;

    if (!find_form(at, &x))
        return LOFT_SINGULAR;
    const loft_sci spread = spread_of(&x, &apart),
                   mean = loft_sci_mul(loft_sci_power2(-1), loft_sci_add(x.a, x.c));
    return set_curvatures(loft_sci_sub_product(loft_sci_mul(x.a, x.c), x.b, x.b), mean,
                          loft_sci_sub(mean, spread), loft_sci_add(mean, spread), out)
               ? LOFT_OK
               : LOFT_ERR_RANGE;
}

enum loft_status loft_differential_directions(const loft_differential *at, loft_vec out[2])
{
    loft_sci apart, x, y;
    form m;

    if (!find_form(at, &m))
        return LOFT_SINGULAR;
    const loft_sci spread = spread_of(&m, &apart),
                   size = loft_sci_add(loft_sci_abs(m.a), loft_sci_abs(m.c));
    if (!loft_sci_less(loft_sci_mul(size, loft_sci_power2(-20)), spread))
        return LOFT_SINGULAR;
    x = loft_sci_sign(apart) < 0 ? m.b : loft_sci_add(apart, spread);
    y = loft_sci_sign(apart) < 0 ? loft_sci_sub(spread, apart) : m.b;
    const loft_sci length = loft_sci_sqrt(loft_sci_add(loft_sci_mul(x, x), loft_sci_mul(y, y)));
    x = loft_sci_div(x, length);
    y = loft_sci_div(y, length);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc most = 0, least = 0;
        out[0].axis[i] = out[1].axis[i] = 0;
        if (i < 3 &&
            loft_sci_to_acc(loft_sci_sub_product(loft_sci_mul(x, m.across[i]), y, m.along[i]),
                            &least) &&
            loft_sci_to_acc(loft_sci_add(loft_sci_mul(x, m.along[i]), loft_sci_mul(y, m.across[i])),
                            &most)) {
            out[0].axis[i] = loft_acc_round(least);
            out[1].axis[i] = loft_acc_round(most);
        }
    }
    return LOFT_OK;
}

#else

enum loft_status loft_differential_normal(const loft_differential *at, loft_vec *out)
{
    (void)at;
    (void)out;
    return LOFT_SINGULAR;
}
enum loft_status loft_differential_curvatures(const loft_differential *at, loft_curvatures *out)
{
    (void)at;
    (void)out;
    return LOFT_SINGULAR;
}
enum loft_status loft_differential_directions(const loft_differential *at, loft_vec out[2])
{
    (void)at;
    (void)out;
    return LOFT_SINGULAR;
}

#endif

/* Round 1 / most to a coordinate that is not above it: to nearest, and one step back where that is
 * above. */
loft_real loft_ball_radius(const loft_curvatures *k)
{
    loft_acc radius;

    if (!(k->max > 0) ||
        !loft_sci_to_acc(loft_sci_div(loft_sci_one(), loft_sci_of(k->max)), &radius))
        return LOFT_REAL_MAX;
    const loft_acc below = radius - loft_real_ulp(radius);
    if (!loft_acc_valid(radius))
        return LOFT_REAL_MAX;
    return loft_to_acc(loft_acc_round(radius)) <= radius ? loft_acc_round(radius)
                                                         : loft_acc_round(below);
}

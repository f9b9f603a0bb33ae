/* lib/surface/tensor/revolve.c
 * SPDX-License-Identifier: MIT
 *
 * Let R turn by 90 degrees: R (x, y, z) = (-y, x, z). The quarter of the point P has the control
 * points P, P + R P without the double z, and R P, all turned by R^k, and the weights 1, c, 1 with
 * c = sqrt(1/2). With f = (1 - v)^2, g = 2 v (1 - v) c, h = v^2 and D = f + g + h,
 *
 *     cosine = (f + g) / D       sine = (g + h) / D       S = (x cosine - y sine, x sine + y
 *     cosine)
 *
 * for the point (x, y, z) of the profile at u. Its rows are sums (1 - u) a + u b of weighted
 * coordinates, which weights of different size do not spoil as a + (b - a) u would. All of f, g, h
 * are positive: nothing cancels but the two terms of a coordinate, which are at most |x| and |y|.
 */
#include "surface/tensor/revolve.h"
#include "num/sci.h"            /* loft_sci */

#if LOFT_AXES >= 2

/* (x, y) turned by k quarters, wide. */
static void turn_quarters(unsigned k, loft_acc *x, loft_acc *y)
{
    for (; k > 0; k--) {
        const loft_acc old = *x;
        *x = -*y;
        *y = old;
    }
}

static bool turned(const loft_vec *p, loft_acc x, loft_acc y, unsigned k, loft_vec *out)
{
    turn_quarters(k, &x, &y);
    *out = *p;
    if (!loft_acc_valid(x) || !loft_acc_valid(y))
        return false;
    out->axis[0] = loft_acc_round(x);
    out->axis[1] = loft_acc_round(y);
    return true;
}

static loft_real middle_weight(loft_real w)
{
    const loft_sci half = loft_sci_div(loft_sci_one(), loft_sci_from_int(2));
    loft_acc x = 0;

    if (!loft_sci_to_acc(loft_sci_mul(loft_sci_from_real(w), loft_sci_sqrt(half)), &x))
        return w;                               /* never: it is smaller than w */
    return loft_acc_round(x);
}

enum loft_status loft_tensor_rational_from_revolve(const loft_rational *profile, unsigned k,
                                                   loft_weighted out[])
{
    if (k > 3)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i <= profile->degree; i++) {
        const loft_weighted *p = &profile->p[i];
        const loft_acc x = loft_to_acc(p->p.axis[0]), y = loft_to_acc(p->p.axis[1]);
        loft_weighted *row = &out[3 * i];

        if (!turned(&p->p, x, y, k, &row[0].p) || !turned(&p->p, x - y, x + y, k, &row[1].p) ||
            !turned(&p->p, -y, x, k, &row[2].p))
            return LOFT_ERR_RANGE;
        row[0].w = row[2].w = p->w;
        row[1].w = middle_weight(p->w);
    }
    return LOFT_OK;
}

/* The weighted coordinate of the profile at t, or its weight for axis -1. */
static loft_sci profile_sum(const loft_rational *r, int axis, loft_sci t)
{
    const loft_sci u = loft_sci_sub(loft_sci_one(), t);
    loft_sci c[LOFT_DEGREE_MAX + 1];

    for (unsigned i = 0; i <= r->degree; i++) {
        c[i] = loft_sci_from_real(r->p[i].w);
        if (axis >= 0)
            c[i] = loft_sci_mul(c[i], loft_sci_from_real(r->p[i].p.axis[axis]));
    }
    for (unsigned n = r->degree; n > 0; n--)
        for (unsigned i = 0; i < n; i++)
            c[i] = loft_sci_add(loft_sci_mul(u, c[i]), loft_sci_mul(t, c[i + 1]));
    return c[0];
}

/* Cosine and sine of the angle that v stands for, of the whole turn with quarter k. */
static void angle_of(loft_sci v, unsigned k, loft_sci *cosine, loft_sci *sine)
{
    const loft_sci one = loft_sci_one(), two = loft_sci_from_int(2), u = loft_sci_sub(one, v);
    const loft_sci f = loft_sci_mul(u, u), h = loft_sci_mul(v, v);
    const loft_sci g = loft_sci_mul(loft_sci_mul(u, v), loft_sci_sqrt(two));
    const loft_sci all = loft_sci_add(loft_sci_add(f, g), h);
    loft_sci c = loft_sci_div(loft_sci_add(f, g), all), s = loft_sci_div(loft_sci_add(g, h), all);

    for (; k > 0; k--) {
        const loft_sci old = c;
        c = loft_sci_neg(s);
        s = old;
    }
    *cosine = c;
    *sine = s;
}

static bool unit_valid(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

enum loft_status loft_revolve_eval(const loft_rational *profile, unsigned k, loft_unit u,
                                   loft_unit v, loft_vec *out)
{
    const loft_sci at = loft_sci_from_unit(u);
    loft_sci p[LOFT_AXES], cosine, sine;
    loft_acc x[LOFT_AXES];

    if (!unit_valid(u) || !unit_valid(v) || k > 3)
        return LOFT_ERR_ARG;
    const loft_sci w = profile_sum(profile, -1, at);
    for (int i = 0; i < LOFT_AXES; i++)
        p[i] = loft_sci_div(profile_sum(profile, i, at), w);
    angle_of(loft_sci_from_unit(v), k, &cosine, &sine);
    const loft_sci from = loft_sci_sub(loft_sci_mul(p[0], cosine), loft_sci_mul(p[1], sine));
    p[1] = loft_sci_add(loft_sci_mul(p[0], sine), loft_sci_mul(p[1], cosine));
    p[0] = from;
    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_sci_to_acc(p[i], &x[i]))
            return LOFT_ERR_RANGE;
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

#else

enum loft_status loft_tensor_rational_from_revolve(const loft_rational *profile, unsigned k,
                                                   loft_weighted out[])
{
    (void)profile;
    (void)k;
    (void)out;
    return LOFT_ERR_ARG;
}

enum loft_status loft_revolve_eval(const loft_rational *profile, unsigned k, loft_unit u,
                                   loft_unit v, loft_vec *out)
{
    (void)profile;
    (void)k;
    (void)u;
    (void)v;
    (void)out;
    return LOFT_ERR_ARG;
}

#endif

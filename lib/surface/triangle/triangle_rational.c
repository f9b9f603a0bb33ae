/* lib/surface/triangle/triangle_rational.c
 * SPDX-License-Identifier: MIT
 *
 * Points: as for curves (curve/rational.c), with rows over three corners in place of two. Weights
 * are scaled to 2^14 .. 2^15. So numerators and denominators stay below 2^30 inside the triangle,
 * each row rounds them by 2^-33, and the quotient errs by n R 2^-30 LSB.
 */
#include "surface/triangle/triangle_rational.h"
#include "basis/bernstein.h"    /* loft_binomial */
#include "num/acc128.h"     /* loft_acc_project */
#include "num/residue.h"    /* loft_residue */
#include "num/sci.h"        /* loft_sci: derivatives */

#define MOST LOFT_TRIANGLE_MAX

enum loft_status loft_triangle_rational_init(loft_triangle_rational *t, const loft_weighted p[],
                                             unsigned degree)
{
    int32_t scale;

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    if (loft_weighted_scale(p, LOFT_TRIANGLE_POINTS(degree), &scale) != LOFT_OK)
        return LOFT_ERR_RANGE;
    t->p = p;
    t->degree = (uint8_t)degree;
    t->scale = scale;
    return LOFT_OK;
}

static loft_acc denominator(const loft_triangle_rational *t, loft_bary u)
{
    const unsigned degree = t->degree;
    loft_acc c[MOST];

    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(degree); k++)
        c[k] = loft_to_acc(t->p[k].w * (loft_real)t->scale) * LOFT_PROJECT;
    return loft_bary_eval(c, degree, u);
}

static loft_acc numerator(const loft_triangle_rational *t, int axis, loft_bary u)
{
    const unsigned degree = t->degree;
    loft_acc c[MOST];

    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(degree); k++)
        c[k] = loft_prod(t->p[k].p.axis[axis], t->p[k].w * (loft_real)t->scale);
    return loft_bary_eval(c, degree, u);
}

loft_vec loft_triangle_rational_eval(const loft_triangle_rational *t, loft_bary u)
{
    loft_vec v;

    u = loft_bary_clamp(u);
    const loft_acc w = denominator(t, u);
    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_acc_project(numerator(t, i, u), w);
    return v;
}


/* Derivatives
 *
 * Let x and w be the last three numerators and weights, X / W their point at u, and N, V their sums
 * with the coordinates of z. Then
 *
 *     D = n (N W - X V) / W^2
 *
 * Each row errs by at most 5 * 2^-61 of the largest value, and W by that part of itself, because it
 * is a sum of positive numbers. N / W is at most Z R P with the largest coordinate P. So in q16 D
 * errs by n Z R P (10 n + 6) 2^-61, P = 2^31 LSB. */

typedef struct {
    loft_sci u, v, w;
} weights;

static weights weights_of(loft_bary u, loft_sci sum)
{
    weights x;

    x.v = loft_sci_from_unit(u.v);
    x.w = loft_sci_from_unit(u.w);
    x.u = loft_sci_sub(loft_sci_sub(sum, x.v), x.w);
    return x;
}

static loft_sci weighted_sum(loft_sci a, loft_sci b, loft_sci c, const weights *x)
{
    return loft_sci_add(loft_sci_add(loft_sci_mul(x->u, a), loft_sci_mul(x->v, b)),
                        loft_sci_mul(x->w, c));
}

/* The three values of the last row but one: the numerators of an axis, or the weights for axis
 * -1. */
static void last_three(const loft_triangle_rational *t, int axis, const weights *u, loft_sci out[3])
{
    loft_sci c[MOST];
    const unsigned degree = t->degree;

    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(degree); k++) {
        c[k] = loft_sci_from_real(t->p[k].w);
        if (axis >= 0)
            c[k] = loft_sci_mul(c[k], loft_sci_from_real(t->p[k].p.axis[axis]));
    }
    for (unsigned n = degree; n > 1; n--)
        for (unsigned m = 0, p = 0; m < n; m++)
            for (unsigned k = 0; k <= m; k++, p++)
                c[p] = weighted_sum(c[p], c[p + m + 1], c[p + m + 2], u);
    for (unsigned k = 0; k < 3; k++)
        out[k] = c[k];
}

enum loft_status loft_triangle_rational_deriv(const loft_triangle_rational *t, loft_bary z,
                                              loft_bary u, loft_vec *out)
{
    const weights at = weights_of(u, loft_sci_one()), toward = weights_of(z, loft_sci_zero());
    loft_acc d[LOFT_AXES] = { 0 };
    loft_sci w[3], x[3];

    if (!loft_bary_inside(u))
        return LOFT_ERR_ARG;
    if (t->degree > 0) {
        last_three(t, -1, &at, w);
        const loft_sci sum = weighted_sum(w[0], w[1], w[2], &at),
                       slope = weighted_sum(w[0], w[1], w[2], &toward);
        const loft_sci factor = loft_sci_div(loft_sci_from_int(t->degree), loft_sci_mul(sum, sum));
        for (int i = 0; i < LOFT_AXES; i++) {
            last_three(t, i, &at, x);
            const loft_sci rise = loft_sci_mul(weighted_sum(x[0], x[1], x[2], &toward), sum);
            const loft_sci fall = loft_sci_mul(weighted_sum(x[0], x[1], x[2], &at), slope);
            if (!loft_sci_to_acc(loft_sci_mul(factor, loft_sci_sub(rise, fall)), &d[i]))
                return LOFT_ERR_RANGE;
        }
    }
    return loft_vec_round(d, out) ? LOFT_OK : LOFT_ERR_RANGE;
}


/* Second derivatives
 *
 * Of numerators X relative to the rounded point, and of weights w, the values h[u..u], n h[y, u..],
 * n h[z, u..] and n (n - 1) h[y, z, u..] of the blossom are the value and the derivatives. Then
 *
 *     D_y = (X_y - w_y P) / w     D_yz = (X_yz - w_y D_z - w_z D_y - w_yz P) / w
 *
 * where P is below one LSB, because the point is the origin. */

static void load_net(const loft_triangle_rational *t, int axis, loft_real origin, loft_sci c[])
{
    const loft_sci from = loft_sci_from_real(origin);

    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(t->degree); k++) {
        c[k] = loft_sci_from_real(t->p[k].w);
        if (axis >= 0)
            c[k] = loft_sci_mul(c[k], loft_sci_sub(loft_sci_from_real(t->p[k].p.axis[axis]), from));
    }
}

/* One row of the scheme: degree n to n - 1. */
static void bary_step(loft_sci c[], unsigned n, const weights *x)
{
    for (unsigned m = 0, p = 0; m < n; m++)
        for (unsigned k = 0; k <= m; k++, p++)
            c[p] = weighted_sum(c[p], c[p + m + 1], c[p + m + 2], x);
}

/* The derivative in the directions that are not NULL, of one axis or of the weights. */
static loft_sci blossom_slope(const loft_triangle_rational *t, int axis, loft_real origin,
                              const weights *y, const weights *z, const weights *u)
{
    unsigned n = t->degree;
    loft_sci c[MOST], factor = loft_sci_one();
    const weights *const along[2] = { y, z };

    if ((unsigned)(y != NULL) + (unsigned)(z != NULL) > n)
        return loft_sci_zero();
    load_net(t, axis, origin, c);
    for (int i = 0; i < 2; i++)
        if (along[i]) {
            factor = loft_sci_mul(factor, loft_sci_from_int((int32_t)n));
            bary_step(c, n--, along[i]);
        }
    for (; n > 0; n--)
        bary_step(c, n, u);
    return loft_sci_mul(factor, c[0]);
}

enum loft_status loft_triangle_rational_deriv2(const loft_triangle_rational *t, loft_bary y,
                                               loft_bary z, loft_bary u, loft_vec *out)
{
    const weights by = weights_of(y, loft_sci_zero()), bz = weights_of(z, loft_sci_zero()),
                  at = weights_of(u, loft_sci_one());
    loft_acc d[LOFT_AXES];

    if (!loft_bary_inside(u))
        return LOFT_ERR_ARG;
    const loft_vec o = loft_triangle_rational_eval(t, u);
    const loft_sci w = blossom_slope(t, -1, 0, NULL, NULL, &at),
                   wy = blossom_slope(t, -1, 0, &by, NULL, &at),
                   wz = blossom_slope(t, -1, 0, NULL, &bz, &at),
                   wyz = blossom_slope(t, -1, 0, &by, &bz, &at);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci p = loft_sci_div(blossom_slope(t, i, o.axis[i], NULL, NULL, &at), w);
        const loft_sci dy = loft_sci_div(
            loft_sci_sub_product(blossom_slope(t, i, o.axis[i], &by, NULL, &at), wy, p), w);
        const loft_sci dz = loft_sci_div(
            loft_sci_sub_product(blossom_slope(t, i, o.axis[i], NULL, &bz, &at), wz, p), w);
        loft_sci x = loft_sci_sub_product(blossom_slope(t, i, o.axis[i], &by, &bz, &at), wyz, p);
        x = loft_sci_sub_product(loft_sci_sub_product(x, wy, dz), wz, dy);
        if (!loft_sci_to_acc(loft_sci_div(x, w), &d[i]))
            return LOFT_ERR_RANGE;
    }
    return loft_vec_round(d, out) ? LOFT_OK : LOFT_ERR_RANGE;
}


/* Pieces
 *
 * Row m of a net holds the points (n - m, m - k, k), k = 0..m. After L rows of the scheme at u the
 * net of degree n - L holds b[u^L, ..]: its last row is row n - L of P T2 T3, the ends of its rows
 * m are in row L + m of T1 P T3 at place m, the starts in row L + m of T1 T2 P at place L. */

static unsigned place(unsigned row, unsigned k) { return row * (row + 1) / 2 + k; }

/* Store one coordinate, or the weight for axis -1. */
static bool store_number(loft_weighted *out, int axis, loft_sci x, loft_sci w)
{
    loft_acc wide;

    if (!loft_sci_to_acc(axis < 0 ? w : loft_sci_div(x, w), &wide) || !loft_acc_valid(wide))
        return false;
    if (axis < 0)
        out->w = loft_weight_clamp(loft_acc_round(wide));
    else
        out->p.axis[axis] = loft_acc_round(wide);
    return true;
}

static bool split_axis(const loft_triangle_rational *t, int axis, const weights *u,
                       loft_weighted a[], loft_weighted b[], loft_weighted c[])
{
    loft_sci x[MOST], w[MOST];
    bool fits = true;

    load_net(t, axis, 0, x);
    load_net(t, -1, 0, w);
    for (unsigned done = 0, n = t->degree; fits; done++, n--) {
        for (unsigned m = 0; m <= n; m++) {
            const unsigned side = place(n, m), end = place(m, m), start = place(m, 0);
            fits = fits && store_number(&a[side], axis, x[side], w[side]) &&
                   store_number(&b[place(done + m, m)], axis, x[end], w[end]) &&
                   store_number(&c[place(done + m, done)], axis, x[start], w[start]);
        }
        if (n == 0)
            break;
        bary_step(x, n, u);
        bary_step(w, n, u);
    }
    return fits;
}

enum loft_status loft_triangle_rational_split(const loft_triangle_rational *t, loft_bary u,
                                              loft_weighted a[], loft_weighted b[],
                                              loft_weighted c[])
{
    const weights at = weights_of(u, loft_sci_one());

    if (!loft_bary_inside(u))
        return LOFT_ERR_ARG;
    for (int axis = -1; axis < LOFT_AXES; axis++)
        if (!split_axis(t, axis, &at, a, b, c))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

/* The sum over the net for the point (i, j, k) of degree n + times, of one axis or the weights,
 * without the common divisor C(n + times, n). Nothing cancels in the weights. */
static loft_sci elevated_sum(const loft_triangle_rational *t, int axis, unsigned i, unsigned j,
                             unsigned k)
{
    const unsigned n = t->degree;
    loft_sci sum = loft_sci_zero();

    for (unsigned m = 0, p = 0; m <= n; m++)
        for (unsigned c = 0; c <= m; c++, p++) {
            if (n - m > i || m - c > j || c > k)
                continue;
            loft_sci term = loft_sci_mul(loft_sci_from_int(loft_binomial(i, n - m)),
                                         loft_sci_from_int(loft_binomial(j, m - c)));
            term = loft_sci_mul(term, loft_sci_from_int(loft_binomial(k, c)));
            term = loft_sci_mul(term, loft_sci_from_real(t->p[p].w));
            if (axis >= 0)
                term = loft_sci_mul(term, loft_sci_from_real(t->p[p].p.axis[axis]));
            sum = loft_sci_add(sum, term);
        }
    return sum;
}

enum loft_status loft_triangle_rational_elevate(const loft_triangle_rational *t, unsigned times,
                                                loft_weighted out[])
{
    const unsigned degree = t->degree + times;

    if (times > LOFT_ELEVATE_MAX || degree > LOFT_ELEVATE_MAX)
        return LOFT_ERR_ARG;
    const loft_sci all = loft_sci_from_int(loft_binomial(degree, t->degree));
    for (unsigned m = 0, p = 0; m <= degree; m++)
        for (unsigned k = 0; k <= m; k++, p++) {
            const loft_sci w = elevated_sum(t, -1, degree - m, m - k, k);
            bool fits = store_number(&out[p], -1, w, loft_sci_div(w, all));
            for (int axis = 0; axis < LOFT_AXES; axis++)
                fits = fits &&
                       store_number(&out[p], axis, elevated_sum(t, axis, degree - m, m - k, k), w);
            if (!fits)
                return LOFT_ERR_RANGE;
        }
    return LOFT_OK;
}


/* Tangent planes
 *
 * The last three points of the scheme, in homogeneous coordinates, span point and derivatives. They
 * are dependent if and only if the derivatives of the projected surface are. A coordinate is a sum
 * of products of two numbers and degree - 1 parameters. */

static void residue_step(const loft_residue *r, uint32_t c[], unsigned n, const uint32_t u[3])
{
    for (unsigned m = 0, p = 0; m < n; m++)
        for (unsigned k = 0; k <= m; k++, p++) {
            const uint32_t first = loft_residue_mul(r, u[0], c[p]),
                           second = loft_residue_mul(r, u[1], c[p + m + 1]),
                           third = loft_residue_mul(r, u[2], c[p + m + 2]);
            c[p] = loft_residue_add(r, loft_residue_add(r, first, second), third);
        }
}

static bool plane_modulo(const loft_triangle_rational *t, const loft_residue *r, loft_bary at)
{
    const uint32_t v = loft_residue_unit(r, at.v), w = loft_residue_unit(r, at.w);
    const uint32_t u[3] = { loft_residue_sub(r, loft_residue_sub(r, loft_residue_one(r), v), w), v,
                            w };
    uint32_t rows[1 + LOFT_AXES][3];

    for (int axis = -1; axis < LOFT_AXES; axis++) {
        uint32_t c[MOST];
        for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(t->degree); k++) {
            c[k] = loft_residue_real(r, t->p[k].w);
            if (axis >= 0)
                c[k] = loft_residue_mul(r, c[k], loft_residue_real(r, t->p[k].p.axis[axis]));
        }
        for (unsigned n = t->degree; n > 1; n--)
            residue_step(r, c, n, u);
        for (unsigned k = 0; k < 3; k++)
            rows[axis + 1][k] = c[k];
    }
    return !loft_residue_dependent(r, rows, 1 + LOFT_AXES);
}

static bool net_exact(const loft_triangle_rational *t)
{
    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(t->degree); k++) {
        if (!loft_exact_valid(t->p[k].w))
            return false;
        for (int axis = 0; axis < LOFT_AXES; axis++)
            if (!loft_exact_valid(t->p[k].p.axis[axis]))
                return false;
    }
    return true;
}

bool loft_triangle_rational_regular(const loft_triangle_rational *t, loft_bary u)
{
    loft_residue r;

    if (t->degree == 0 || !loft_bary_inside(u) || !net_exact(t))
        return false;
    loft_residue_start(&r, 3 * (2 * LOFT_RESIDUE_REAL + t->degree * (LOFT_RESIDUE_UNIT + 2u)) + 3);
    while (loft_residue_next(&r))
        if (plane_modulo(t, &r, u))
            return true;
    return false;
}

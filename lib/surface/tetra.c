/* lib/surface/tetra.c
 * SPDX-License-Identifier: MIT
 *
 * Let p be the place of b_ijkl in layer m = j + k + l, row n = k + l. The places of the next degree
 * are
 *
 *     b_(i+1)jkl: p                                   b_ij(k+1)l: q + n + 1
 *     b_i(j+1)kl: q = p + (m + 1) (m + 2) / 2         b_ijk(l+1): q + n + 2
 *
 * All are p itself or after p. So a row of the algorithm runs in place from the front, and a row of
 * weights from the back.
 */
#include "surface/tetra.h"
#include "geom/vec_exact.h"     /* loft_exact: volumes and decisions */

#define MOST LOFT_TETRA_MAX
#define SPACE 3

loft_volume loft_volume_clamp(loft_volume u)
{
    u.v = loft_unit_clamp(u.v);
    u.w = loft_unit_clamp(u.w);
    u.x = loft_unit_clamp(u.x);
    if (u.w > LOFT_UNIT(1) - u.v)
        u.w = LOFT_UNIT(1) - u.v;
    if (u.x > LOFT_UNIT(1) - u.v - u.w)
        u.x = LOFT_UNIT(1) - u.v - u.w;
    return u;
}


/* Coordinates. A difference has 32 bits (floats 129), a determinant 3 times as many and 3 more. */

static loft_exact det(const loft_exact a[SPACE], const loft_exact b[SPACE],
                      const loft_exact c[SPACE])
{
    loft_exact product[SPACE];

    loft_vec_exact_cross(b, c, product);
    return loft_vec_exact_dot(a, product, SPACE);
}

enum loft_status loft_volume_from_point(const loft_vec corner[4], loft_vec p, loft_acc out[4])
{
    loft_exact a[SPACE], b[SPACE], c[SPACE], e[SPACE];
    loft_acc x[4];

    if (!loft_vec_exact_valid(corner, 4, SPACE) || !loft_vec_exact_valid(&p, 1, SPACE))
        return LOFT_ERR_RANGE;
    loft_vec_exact_sub(&corner[1], &corner[0], SPACE, a);
    loft_vec_exact_sub(&corner[2], &corner[0], SPACE, b);
    loft_vec_exact_sub(&corner[3], &corner[0], SPACE, c);
    loft_vec_exact_sub(&p, &corner[0], SPACE, e);
    const loft_exact whole = det(a, b, c);
    loft_exact part[4] = { whole, det(e, b, c), det(a, e, c), det(a, b, e) };

    if (loft_exact_sign(whole) == 0)
        return LOFT_SINGULAR;
    for (int k = 1; k < 4; k++)
        part[0] = loft_exact_sub(part[0], part[k]);
    for (int k = 0; k < 4; k++)
        if (!loft_exact_quot(part[k], whole, 0, &x[k]))
            return LOFT_ERR_RANGE;
    for (int k = 0; k < 4; k++)
        out[k] = x[k];
    return LOFT_OK;
}


/* Points */

/* Each weight passes on three parts, rounded, and keeps the rest, so the sum stays 1. The error is
 * 6 * 2^-33 per degree. */
void loft_volume_weights(unsigned degree, loft_volume u, loft_acc c[])
{
    c[0] = loft_to_acc(LOFT_REAL(1));
    for (unsigned d = 1; d <= degree; d++) {
        for (unsigned k = LOFT_TETRA_POINTS(d - 1); k < LOFT_TETRA_POINTS(d); k++)
            c[k] = 0;
        for (unsigned p = LOFT_TETRA_POINTS(d - 1), m = d; m-- > 0; )
            for (unsigned n = m + 1; n-- > 0; )
                for (unsigned l = n + 1; l-- > 0; ) {
                    const unsigned q = --p + (m + 1) * (m + 2) / 2;
                    const loft_acc v = loft_acc_scale(c[p], u.v), w = loft_acc_scale(c[p], u.w),
                                   x = loft_acc_scale(c[p], u.x);
                    c[p] -= v + w + x;
                    c[q] += v;
                    c[q + n + 1] += w;
                    c[q + n + 2] += x;
                }
    }
}

/* In q16 two roundings of 2^-33. Inside, no value leaves the range of the coefficients. */
static void casteljau_row(loft_acc c[], unsigned degree, loft_volume u)
{
    for (unsigned m = 0, p = 0; m < degree; m++)
        for (unsigned n = 0; n <= m; n++)
            for (unsigned l = 0; l <= n; l++, p++) {
                const unsigned q = p + (m + 1) * (m + 2) / 2;
                const loft_acc rest = loft_acc_scale(c[q + n + 2] - c[p], u.x);
                c[p] = loft_acc_lerp3(c[p], c[q], c[q + n + 1], u.v, u.w) + rest;
            }
}

static void axis_to_acc(const loft_tetra *t, int axis, loft_acc c[])
{
    const unsigned degree = t->degree;

    for (unsigned k = 0; k < LOFT_TETRA_POINTS(degree); k++)
        c[k] = loft_to_acc(t->p[k].axis[axis]);
}

enum loft_status loft_tetra_init(loft_tetra *t, const loft_vec p[], unsigned degree)
{
    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k < LOFT_TETRA_POINTS(degree); k++)
        if (!loft_vec_valid(p[k]))
            return LOFT_ERR_RANGE;
    t->p = p;
    t->degree = (uint8_t)degree;
    return LOFT_OK;
}

loft_vec loft_tetra_eval(const loft_tetra *t, loft_volume u)
{
    loft_acc c[MOST];
    loft_vec out;

    u = loft_volume_clamp(u);
    for (int i = 0; i < LOFT_AXES; i++) {
        axis_to_acc(t, i, c);
        for (unsigned n = t->degree; n > 0; n--)
            casteljau_row(c, n, u);
        out.axis[i] = loft_acc_round(c[0]);
    }
    return out;
}


/* Degree elevation */

/* sum C(i,q) C(j,r) C(k,s) C(l,t) b_qrst / C(n+m,n) over q + r + s + t = n, with (i, j, k, l) of
 * degree n + m. The products of binomials sum to C(n+m,n) <= C(18,9) = 48620, so the sum is below
 * 48620 * 2^47 < 2^62.6. */
static loft_acc elevated_coefficient(const loft_acc c[], unsigned n, unsigned i, unsigned j,
                                     unsigned k, unsigned l)
{
    loft_acc sum = 0;

    for (unsigned r = 0; r <= n && r <= j; r++)
        for (unsigned s = 0; r + s <= n && s <= k; s++)
            for (unsigned t = 0; r + s + t <= n && t <= l; t++)
                sum += c[loft_tetra_place(r, s, t)] *
                       (loft_binomial(i, n - r - s - t) * loft_binomial(j, r) *
                        (loft_binomial(k, s) * loft_binomial(l, t)));
    return loft_acc_ratio(sum, loft_binomial(i + j + k + l, n));
}

enum loft_status loft_tetra_elevate(const loft_tetra *t, unsigned times, loft_vec out[])
{
    const unsigned n = t->degree, most = n + times;
    loft_acc c[MOST];

    if (times > LOFT_ELEVATE_MAX - n)
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        axis_to_acc(t, axis, c);
        for (unsigned m = 0, p = 0; m <= most; m++)
            for (unsigned r = 0; r <= m; r++)
                for (unsigned l = 0; l <= r; l++, p++)
                    out[p].axis[axis] = loft_acc_round(
                        elevated_coefficient(c, n, most - m, m - r, r - l, l));
    }
    return LOFT_OK;
}

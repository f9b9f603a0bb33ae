/* lib/surface/triangle/triangle_curvature.c
 * SPDX-License-Identifier: MIT
 *
 * With e, f the edges from the corner b_n00 to its neighbours, and g, h, l the second differences
 * there,
 *
 *     S' = n p,             p = v e + w f
 *     S'' = n (n - 1) q,    q = v^2 g + 2 v w h + w^2 l
 *     curvature = (n - 1) / n * <q, m> / (|m| |p|^2),    m = e x f
 *
 * p is a whole number over 2^(R + T), q over 2^(R + 2T), m over 2^(2R), R = LOFT_EXACT_REAL, T =
 * LOFT_EXACT_UNIT. Bits, with coordinates of R' (31, floats 128): p R' + T + 10, q R' + 2T + 19, m
 * 2R' + 4; <q, m> has 3R' + 2T + 25: 166 in q16 and 515 in floats. |p|^2 has 2R' + 2T + 22: 132 and
 * 384. |m|, of which 100 bits are kept, has 100 more.
 */
#include "surface/triangle/triangle_curvature.h"
#include "geom/vec_exact.h"         /* loft_exact: no cancellation */

#define SPACE 3
#define ROOT_BITS 100
#define FARTHEST LOFT_UNIT(127)

/* b_n00 and the five points nearest to it, in one axis. The last three are absent for degree 1. */
static void load_points(const loft_triangle *t, int axis, loft_exact b[6])
{
    for (unsigned k = 0; k < 6; k++)
        b[k] = loft_exact_from_real(k < 3 || t->degree > 1 ? loft_vec_axis(&t->p[k], axis) : 0);
}

static loft_exact twice(loft_exact a)               { return loft_exact_shift(a, 1); }
static loft_exact scaled(loft_exact a, loft_exact x) { return loft_exact_mul(x, a); }

/* One axis of p, of q, and of the edges. */
static void differ(const loft_exact b[6], loft_exact v, loft_exact w, loft_exact *p, loft_exact *q,
                   loft_exact *e, loft_exact *f)
{
    *e = loft_exact_sub(b[1], b[0]);
    *f = loft_exact_sub(b[2], b[0]);
    *p = loft_exact_add(scaled(*e, v), scaled(*f, w));
    const loft_exact g = loft_exact_sub(loft_exact_sub(b[3], b[1]), *e);
    const loft_exact h = loft_exact_sub(loft_exact_sub(b[4], b[1]), *f);
    const loft_exact l = loft_exact_sub(loft_exact_sub(b[5], b[2]), *f);
    const loft_exact first = loft_exact_add(scaled(g, v), twice(scaled(h, w)));
    *q = loft_exact_add(scaled(first, v), scaled(scaled(l, w), w));
}

/* |m| 2^shift, to 2^-97 of itself: the components are scaled to 100 bits. */
static loft_exact length(const loft_exact m[SPACE], int *shift)
{
    loft_exact scaled_down[SPACE];
    int bits = 0;

    for (int i = 0; i < SPACE; i++)
        if (loft_exact_bits(m[i]) > bits)
            bits = loft_exact_bits(m[i]);
    *shift = ROOT_BITS - bits;
    for (int i = 0; i < SPACE; i++)
        scaled_down[i] = loft_exact_shift(m[i], *shift);
    return loft_exact_root(loft_vec_exact_dot(scaled_down, scaled_down, SPACE));
}

static enum loft_status check(const loft_triangle *t, loft_bary z)
{
    if (t->degree == 0)
        return LOFT_ERR_ARG;
    if (!(z.v > -FARTHEST && z.v < FARTHEST && z.w > -FARTHEST && z.w < FARTHEST))
        return LOFT_ERR_RANGE;
    return loft_vec_exact_valid(t->p, t->degree > 1 ? 6 : 3, SPACE) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_triangle_corner_curvature_vec(const loft_triangle *t, loft_bary z,
                                                    loft_real *out)
{
    const enum loft_status status = check(t, z);
    loft_exact p[SPACE], q[SPACE], e[SPACE], f[SPACE], m[SPACE], b[6];
    int shift;

    if (status != LOFT_OK)
        return status;
    const loft_exact v = loft_exact_from_unit(z.v), w = loft_exact_from_unit(z.w);
    for (int i = 0; i < SPACE; i++) {
        load_points(t, i, b);
        differ(b, v, w, &p[i], &q[i], &e[i], &f[i]);
    }
    loft_vec_exact_cross(e, f, m);
    const loft_exact speed = loft_vec_exact_dot(p, p, SPACE), size = length(m, &shift);
    if (loft_exact_sign(speed) == 0 || loft_exact_sign(size) == 0)
        return LOFT_SINGULAR;
    const int32_t n = t->degree;
    const loft_exact above = loft_exact_mul(loft_exact_from_int(n - 1),
                                            loft_vec_exact_dot(q, m, SPACE));
    const loft_exact below = loft_exact_mul(loft_exact_from_int(n), loft_exact_mul(size, speed));
    return loft_exact_quot_real(above, below, LOFT_EXACT_REAL + shift, out) ? LOFT_OK
                                                                            : LOFT_ERR_RANGE;
}

/* lib/surface/area.c
 * SPDX-License-Identifier: MIT
 *
 * net_field.c has the normal M / w^3, the polynomial h for w^-3, and its error R = 6 d^2 / min w^5.
 *
 * Directions. S = int M h, n = S / |S|, a = M . n, b the part of M across n. Where all coefficients
 * of a are above 0,
 *
 *     a + b^2 / 2a - b^4 / 8a^3  <=  |M| = sqrt(a^2 + b^2)  <=  a + b^2 / 2a
 *
 * so with Q = int b^2, the extremes of the coefficients of a and w, and B the largest |b|,
 *
 *     area <= |S| + R + Q / (2 min a min w^3),   R = 6 d^2 / min w^5 int a
 *     area >= |S| - R + Q / (2 max a max w^3) (1 - B^2 / (4 min a^2))
 *
 * The two differ by the third power of the width. Elsewhere, at poles and folds, |S| - R <= area <=
 * mean |M_kl| / min w^3, with R from |M|. The mean of the two bounds is taken where they differ by
 * at most 2 tol times the piece's share of the parameter domain. So all pieces together err by at
 * most tol. Elsewhere the piece is halved, along the parameter by which M and w change more. The
 * pieces are the leaves of a binary tree (basis/dyadic.h).
 */
#include "surface/area.h"
#include "geom/vec_exact.h"     /* loft_vec_exact_valid */
#include "surface/net_field.h"

#define WIDE (3 * LOFT_DEGREE_MAX - 1)

/* Of an integral over a part: its components, and how much each may err. */
typedef struct {
    loft_sci middle[3], rest;
} measure;

typedef struct {
    loft_sci lower, upper;
} bounds;

static loft_sci sci_of(unsigned k) { return loft_sci_from_int((int32_t)k); }

/* The mean of |M_kl|. */
static loft_sci mean_size(const loft_net_field *x)
{
    const unsigned count = (x->p + 1) * (x->q + 1);
    loft_sci sum = loft_sci_zero();

    for (unsigned k = 0; k < count; k++)
        sum = loft_sci_add(sum, x->each == 1
                                    ? loft_sci_abs(x->c[k])
                                    : loft_sci_sqrt(loft_sci_dot3(&x->c[3 * k], &x->c[3 * k])));
    return loft_sci_div(sum, sci_of(count));
}

/* The integral of the square of the vectors. */
static loft_sci square_integral(const loft_net_field *x)
{
    loft_sci row[WIDE][3], sum = loft_sci_zero();

    for (unsigned k = 0; k <= x->p; k++) {
        for (unsigned l = 0; l <= x->q; l++)
            for (unsigned i = 0; i < 3; i++) {
                row[l][i] = loft_sci_zero();
                for (unsigned g = 0; g <= x->p; g++)
                    loft_sci_add_product(&row[l][i], x->same[0][k * (x->p + 1) + g],
                                         x->c[(g * (x->q + 1) + l) * 3 + i]);
            }
        for (unsigned l = 0; l <= x->q; l++)
            for (unsigned h = 0; h <= x->q; h++)
                loft_sci_add_product(&sum, x->same[1][l * (x->q + 1) + h],
                                     loft_sci_dot3(row[l], &x->c[(k * (x->q + 1) + h) * 3]));
    }
    return loft_sci_abs(sum);
}


// Bounds
// ------

/* Each coefficient of M as its part along n, in sum and extremes, and the part across n, in place.
 * The largest square of the latter is `across`. */
typedef struct {
    loft_sci mean, least, most, across;
} parted;

static parted part_along(loft_net_field *x, const loft_sci n[3])
{
    const unsigned count = (x->p + 1) * (x->q + 1);
    parted r = { loft_sci_zero(), loft_sci_zero(), loft_sci_zero(), loft_sci_zero() };

    for (unsigned k = 0; k < count; k++) {
        loft_sci *at = &x->c[3 * k];
        const loft_sci a = loft_sci_dot3(at, n);
        r.mean  = loft_sci_add(r.mean, a);
        r.least = k ? loft_sci_smaller(r.least, a) : a;
        r.most  = k ? loft_sci_larger(r.most, a) : a;
        for (unsigned i = 0; i < 3; i++)
            at[i] = loft_sci_sub_product(at[i], a, n[i]);
        r.across = loft_sci_larger(r.across, loft_sci_dot3(at, at));
    }
    r.mean = loft_sci_div(r.mean, sci_of(count));
    return r;
}

static bounds bounds_around(loft_sci middle, loft_sci rest)
{
    const bounds r = { loft_sci_sub(middle, rest), loft_sci_add(middle, rest) };
    return r;
}

static bounds area_bounds(loft_net_field *x)
{
    const loft_net_weighing by = loft_net_field_weighing(x);
    const loft_sci size = mean_size(x);
    loft_sci sum[3], n[3];

    loft_net_field_integral(x, &by, sum);
    const loft_sci middle = loft_sci_sqrt(loft_sci_dot3(sum, sum));
    bounds r = bounds_around(middle, loft_sci_mul(by.rest, size));
    r.lower = loft_sci_larger(r.lower, loft_sci_zero());
    r.upper = loft_sci_mul(size, by.most);
    if (loft_sci_sign(middle) == 0)
        return r;
    for (unsigned i = 0; i < 3; i++)
        n[i] = loft_sci_div(sum[i], middle);
    const parted a = part_along(x, n);
    if (loft_sci_sign(a.least) <= 0)
        return r;
    const loft_sci q = loft_sci_mul(square_integral(x), loft_sci_power2(-1)),
                   slack = loft_sci_sub(
                       loft_sci_one(),
                       loft_sci_div(a.across,
                                    loft_sci_mul(sci_of(4), loft_sci_mul(a.least, a.least))));
    r = bounds_around(middle, loft_sci_mul(by.rest, a.mean));
    r.upper = loft_sci_add(r.upper, loft_sci_div(loft_sci_mul(q, by.most), a.least));
    if (loft_sci_sign(slack) > 0)
        r.lower = loft_sci_add(
            r.lower, loft_sci_mul(loft_sci_div(loft_sci_mul(q, by.least), a.most), slack));
    return r;
}

static measure measure_of(loft_net_field *x)
{
    const loft_sci half = loft_sci_power2(-1);
    measure r;

    if (x->each == 3 && x->power == 3) {
        const bounds b = area_bounds(x);
        r.middle[0]    = loft_sci_mul(half, loft_sci_add(b.lower, b.upper));
        r.middle[1] = r.middle[2] = loft_sci_zero();
        r.rest = loft_sci_mul(half, loft_sci_sub(b.upper, b.lower));
        return r;
    }
    const loft_net_weighing by = loft_net_field_weighing(x);
    loft_net_field_integral(x, &by, r.middle);
    r.rest = loft_sci_mul(by.rest, mean_size(x));
    return r;
}

/* The integrals over the net, each within tol. */
static enum loft_status integrate_parts(loft_net_field *x, loft_sci tol, loft_sci out[3])
{
    loft_sci sum[3] = { loft_sci_zero(), loft_sci_zero(), loft_sci_zero() };
    loft_dyad_box part;

    loft_dyad_box_start(&part);
    do {
        for (;;) {
            loft_net_field_cut(x, &part);
            const unsigned along = loft_net_field_longer(x);
            const measure got    = measure_of(x);
            if (!loft_sci_less(tol, got.rest)) {
                for (int i = 0; i < 3; i++)
                    loft_sci_add_product(&sum[i], loft_sci_power2(-(int)part.depth), got.middle[i]);
                break;
            }
            if (part.depth == LOFT_DYAD_LEVELS)
                return LOFT_ERR_RANGE;
            loft_dyad_box_halve(&part, along);
        }
    } while (loft_dyad_box_next(&part));
    for (int i = 0; i < 3; i++)
        out[i] = sum[i];
    return LOFT_OK;
}

static bool points_valid(const loft_net *s)
{
    const unsigned count = s->triangle ? LOFT_TRIANGLE_POINTS(s->m) : (s->m + 1u) * (s->n + 1u);
    bool valid = s->weighted || loft_vec_exact_valid(s->p, count, LOFT_AXES);

    for (unsigned k = 0; k < count && s->weighted; k++)
        valid = valid && loft_vec_exact_valid(&s->weighted[k].p, 1, LOFT_AXES);
    return valid;
}

/* The integral of |M| / w^3, of det / w^3, or of X det / w^4. */
static enum loft_status integral_of(loft_net s, loft_vec origin, enum loft_net_field_of of,
                                    loft_sci tol, loft_sci memory[], loft_sci out[3])
{
    loft_net_field x;

    if (!points_valid(&s))
        return LOFT_ERR_RANGE;
    if (s.m == 0 || s.n == 0) {
        out[0] = out[1] = out[2] = loft_sci_zero();
        return LOFT_OK;
    }
    loft_net_field_load(s, origin, of, memory, &x);
    return integrate_parts(&x, tol, out);
}

enum loft_status loft_net_area(loft_net s, loft_real tol, loft_sci memory[], loft_acc *out)
{
    loft_sci area[3];

    if (!(tol > 0))
        return LOFT_ERR_ARG;
    const enum loft_status status = integral_of(s, s.weighted ? s.weighted[0].p : s.p[0],
                                                LOFT_NET_NORMAL, loft_sci_from_real(tol), memory,
                                                area);
    if (status != LOFT_OK)
        return status;
    return loft_sci_to_acc(area[0], out) ? LOFT_OK : LOFT_ERR_RANGE;
}

/* An integral over a cone, which is a part `share` of that over the net. */
static enum loft_status cone_integral(loft_net s, loft_vec apex, enum loft_net_field_of of,
                                      int32_t share, loft_real tol, loft_sci memory[],
                                      loft_sci out[3])
{
    const loft_sci parts = loft_sci_from_int(share);
    loft_sci all[3];

    if (!(tol > 0) || LOFT_AXES < 3)
        return LOFT_ERR_ARG;
    const enum loft_status status = integral_of(
        s, apex, of, loft_sci_mul(parts, loft_sci_from_real(tol)), memory, all);
    for (int i = 0; i < 3 && status == LOFT_OK; i++)
        out[i] = loft_sci_div(all[i], parts);
    return status;
}

enum loft_status loft_net_cone_volume(loft_net s, loft_vec apex, loft_real tol, loft_sci memory[],
                                      loft_acc *out)
{
    loft_sci volume[3];
    const enum loft_status status = cone_integral(s, apex, LOFT_NET_CONE, 3, tol, memory, volume);

    if (status != LOFT_OK)
        return status;
    return loft_sci_to_acc(volume[0], out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_net_cone_moment(loft_net s, loft_vec apex, loft_real tol, loft_sci memory[],
                                      loft_sci out[3])
{
    return cone_integral(s, apex, LOFT_NET_MOMENT, 4, tol, memory, out);
}

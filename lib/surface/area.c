/* lib/surface/area.c
 * SPDX-License-Identifier: MIT
 *
 * net_field.c has the normal M / w^3, the polynomial h for w^-3, and its error R = 6 d^2 / min w^5.
 *
 * Gauss's formula with 4 x 4 nodes errs by at most T_8 / 44100 along u, and along v, where T_8
 * bounds the 8th Taylor coefficient of the integrand at every place. Series with coefficients that
 * are not smaller bound it: with a_k for M or D and b_k for w, k > 0, |M| >= A > 0 and w >= W,
 *
 *     s = sum a_k / A t^k,   z = sum b_k / W t^k,   |M(x + t)| = |M(x)| |e + ..| << |M| sqrt(..)
 *     |M| w^-3 << max |M| W^-3 (2 - sqrt(1 - 2 s - s^2)) (1 - z)^-3
 *     D w^-k   << W^-k (max |D| + sum d_k t^k) (1 - z)^-k
 *
 * because the coefficients of sqrt(1 + y) and (1 + z)^-k are up to signs those of 2 - sqrt(1 - y)
 * and (1 - z)^-k. A is the least part of the coefficients of M along S = int M h. At poles and
 * folds there is none, and where it is finer, also for plane patches, |S| - R <= area <=
 * mean |M_kl| / min w^3, with R from |M|. The mean of the two bounds is taken where they differ by
 * at most 2 tol times the piece's share of the parameter domain. So all pieces together err by at
 * most tol. Elsewhere the piece is halved, along the parameter by which M and w change more. The
 * pieces are the leaves of a binary tree (basis/dyadic.h), as many as tol^(-1/4).
 */
#include "surface/area.h"
#include "geom/vec_exact.h"     /* loft_vec_exact_valid */
#include "surface/net_field.h"

#define ORDER LOFT_NET_ORDER

/* Of an integral over a part: its components, and how much each may err. */
typedef struct {
    loft_sci middle[3], rest;
    bool turns;                 /* its normals are on no one side */
} measure;

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

// Series
// ------

/* Bounds of Taylor coefficients, none below 0. */
typedef struct {
    loft_sci c[ORDER + 1];
} series;

static series series_product(const series *a, const series *b)
{
    series r;

    for (unsigned k = 0; k <= ORDER; k++) {
        r.c[k] = loft_sci_zero();
        for (unsigned j = 0; j <= k; j++)
            loft_sci_add_product(&r.c[k], a->c[j], b->c[k - j]);
    }
    return r;
}

/* 1 / (1 - x), where x begins with 0. */
static series series_inverse(const series *x)
{
    series r;

    r.c[0] = loft_sci_one();
    for (unsigned k = 1; k <= ORDER; k++) {
        r.c[k] = loft_sci_zero();
        for (unsigned j = 1; j <= k; j++)
            loft_sci_add_product(&r.c[k], x->c[j], r.c[k - j]);
    }
    return r;
}

/* 2 - sqrt(1 - x), where x begins with 0. */
static series series_root(const series *x)
{
    const loft_sci half = loft_sci_power2(-1);
    series r;

    r.c[0] = loft_sci_one();
    for (unsigned k = 1; k <= ORDER; k++) {
        r.c[k] = x->c[k];
        for (unsigned j = 1; j < k; j++)
            loft_sci_add_product(&r.c[k], r.c[j], r.c[k - j]);
        r.c[k] = loft_sci_mul(r.c[k], half);
    }
    return r;
}

/* All but the first over `least`; the first is 0. */
static series series_over(const loft_sci c[ORDER + 1], loft_sci least)
{
    series r;

    r.c[0] = loft_sci_zero();
    for (unsigned k = 1; k <= ORDER; k++)
        r.c[k] = loft_sci_div(c[k], least);
    return r;
}


// Nodes
// -----

/* What an integrand is made of: lengths of normals are from least to most. */
typedef struct {
    bool length;
    loft_sci least, most;
} integrand;

/* The length: its series over |M| at a place, times the most that this is. */
static series length_series(const loft_sci a[ORDER + 1], const integrand *of)
{
    const series s = series_over(a, of->least);
    series y = series_product(&s, &s);

    for (unsigned k = 0; k <= ORDER; k++)
        y.c[k] = loft_sci_add(y.c[k], loft_sci_add(s.c[k], s.c[k]));
    series r = series_root(&y);
    for (unsigned k = 0; k <= ORDER; k++)
        r.c[k] = loft_sci_mul(r.c[k], of->most);
    return r;
}

/* The least weight, of the coefficients. */
static loft_sci least_weight(const loft_net_field *x)
{
    loft_sci least = x->w[0];

    for (unsigned k = 1; k < (x->m + 1) * (x->n + 1); k++)
        least = loft_sci_smaller(least, x->w[k]);
    return least;
}

/* By how much the formula may err along u or v. */
static loft_sci error_along(const loft_net_field *x, const integrand *of, unsigned along)
{
    loft_sci c[ORDER + 1], last;
    series top;

    loft_net_field_taylor(x, false, along, c);
    if (of->length)
        top = length_series(c, of);
    for (unsigned k = 0; k <= ORDER && !of->length; k++)
        top.c[k] = c[k];
    last = top.c[ORDER];
    if (x->weighted) {
        const loft_sci least = least_weight(x);
        loft_net_field_taylor(x, true, along, c);
        const series z = series_over(c, least), one = series_inverse(&z);
        for (unsigned k = 0; k < x->power; k++)
            top = series_product(&top, &one);
        last = loft_sci_div(top.c[ORDER], loft_sci_pow(least, x->power));
    }
    return loft_sci_div(last, sci_of(44100));
}

/* The integral by the formula. */
static void sum_of_nodes(const loft_net_field *x, bool length, loft_sci out[3])
{
    loft_net_row row;
    loft_sci value[3], weight;

    for (unsigned i = 0; i < 3; i++)
        out[i] = loft_sci_zero();
    for (unsigned g = 0; g < LOFT_NET_NODES; g++) {
        loft_net_field_row(x, g, &row);
        for (unsigned h = 0; h < LOFT_NET_NODES; h++) {
            loft_net_field_value(x, &row, h, value, &weight);
            if (length) {
                value[0] = loft_sci_sqrt(loft_sci_dot3(value, value));
                value[1] = value[2] = loft_sci_zero();
            }
            const loft_sci share = loft_sci_div(
                loft_sci_mul(x->share[g % 3 > 0], x->share[h % 3 > 0]),
                loft_sci_pow(weight, x->power));
            for (unsigned i = 0; i < 3; i++)
                loft_sci_add_product(&out[i], share, value[i]);
        }
    }
}

/* Take the formula where it errs by less. */
static void take_nodes(const loft_net_field *x, const integrand *of, measure *r)
{
    const loft_sci rest = loft_sci_add(error_along(x, of, 0), error_along(x, of, 1));

    if (!loft_sci_less(rest, r->rest))
        return;
    sum_of_nodes(x, of->length, r->middle);
    r->rest = rest;
}


// Bounds
// ------

/* The least part of the coefficients along n, and the largest length. */
static integrand length_of(const loft_net_field *x, const loft_sci n[3])
{
    integrand r = { true, loft_sci_zero(), loft_sci_zero() };

    for (unsigned k = 0; k < (x->p + 1) * (x->q + 1); k++) {
        const loft_sci *at = &x->c[3 * k], a = loft_sci_dot3(at, n);
        r.least = k ? loft_sci_smaller(r.least, a) : a;
        r.most  = loft_sci_larger(r.most, loft_sci_dot3(at, at));
    }
    r.most = loft_sci_sqrt(r.most);
    return r;
}

static measure area_of(const loft_net_field *x, loft_sci tol)
{
    const loft_net_weighing by = loft_net_field_weighing(x);
    const loft_sci size = mean_size(x), half = loft_sci_power2(-1);
    loft_sci sum[3];

    loft_net_field_integral(x, &by, sum);
    const loft_sci middle = loft_sci_sqrt(loft_sci_dot3(sum, sum)),
                   lower  = loft_sci_larger(loft_sci_sub(middle, loft_sci_mul(by.rest, size)),
                                           loft_sci_zero()),
                   upper  = loft_sci_mul(size, by.most);
    measure r = { { loft_sci_mul(half, loft_sci_add(lower, upper)), loft_sci_zero(),
                    loft_sci_zero() },
                  loft_sci_mul(half, loft_sci_sub(upper, lower)),
                  true };
    if (!loft_sci_less(tol, r.rest) || loft_sci_sign(middle) == 0)
        return r;
    for (unsigned i = 0; i < 3; i++)
        sum[i] = loft_sci_div(sum[i], middle);
    const integrand of = length_of(x, sum);
    r.turns = loft_sci_sign(of.least) <= 0;
    if (!r.turns)
        take_nodes(x, &of, &r);
    return r;
}

static measure measure_of(const loft_net_field *x, loft_sci tol)
{
    const integrand parts = { false, loft_sci_zero(), loft_sci_zero() };
    measure r = { .turns = false };

    if (x->each == 3 && x->power == 3)
        return area_of(x, tol);
    const loft_net_weighing by = loft_net_field_weighing(x);
    loft_net_field_integral(x, &by, r.middle);
    r.rest = loft_sci_mul(by.rest, mean_size(x));
    if (loft_sci_less(tol, r.rest))
        take_nodes(x, &parts, &r);
    return r;
}

/* What the parts may err by: all of them evenly, and a stock of what they left, for those where
 * normals turn around, of which each takes at most an eighth. */
typedef struct {
    loft_sci even, stock;
} allowance;

static bool may_take(allowance *by, const measure *got, unsigned depth)
{
    const loft_sci left = loft_sci_mul(loft_sci_sub(by->even, got->rest),
                                       loft_sci_power2(-(int)depth)),
                   most = loft_sci_mul(by->stock, loft_sci_power2(-3));

    if (loft_sci_sign(left) < 0 && !(got->turns && !loft_sci_less(most, loft_sci_neg(left))))
        return false;
    by->stock = loft_sci_add(by->stock, left);
    return true;
}

/* The integrals over the net, each within tol. */
static enum loft_status integrate_parts(loft_net_field *x, loft_sci tol, loft_sci out[3])
{
    const loft_sci half = loft_sci_mul(tol, loft_sci_power2(-1));
    loft_sci sum[3] = { loft_sci_zero(), loft_sci_zero(), loft_sci_zero() };
    allowance by = { half, half };
    uint32_t left = 2 * LOFT_NET_AREA_HALVINGS / (x->m * x->n * (x->m + x->n));
    loft_dyad_box part;

    loft_dyad_box_start(&part);
    do {
        for (;;) {
            loft_net_field_cut(x, &part);
            const unsigned along = loft_net_field_longer(x);
            const measure got    = measure_of(x, by.even);
            if (may_take(&by, &got, part.depth)) {
                for (int i = 0; i < 3; i++)
                    loft_sci_add_product(&sum[i], loft_sci_power2(-(int)part.depth), got.middle[i]);
                break;
            }
            if (part.n[along].level == LOFT_DYAD_LEVELS || --left == 0)
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

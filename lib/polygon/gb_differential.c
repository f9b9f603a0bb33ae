/* lib/polygon/gb_differential.c -- derivatives of generalized Bezier patches
 * SPDX-License-Identifier: MIT
 *
 * The formulas of gb.c, as functions of the point. All weights, including B0, sum to 1, so their
 * derivatives sum to 0:
 *
 *     S - V0 = sum mu^i_jk B_j(s_i) B_k(h_i) (V^i_jk - V0)
 *
 * Near vertex i the derivatives of mu are unbounded, and cancel where ribbons i and i - 1 share a
 * point, because their mu sum to 1 there. Let a = phi_i, b and c the phi after and before it, R the
 * sum of the others, alpha = h_(i-1) / (h_(i-1) + h_i), beta = 1 - alpha, and
 *
 *     e = a R - b c
 *     e / (a + c) = s_(i-1) R - (1 - s_(i-1)) b
 *     e / (a + b) = (1 - s_i) R - s_i c
 *
 * which are of second order there. The four points of a corner have the weights
 *
 *     V^i_00  a^d
 *     V^i_10  d a^(d-1) (b + beta e / (a + c))
 *     V^i_01  d a^(d-1) (c + alpha e / (a + b))
 *     V^i_11  d^2 a^(d-1) s_i h_i + d^2 a^(d-2) beta (1 - s_i) (c - b) e / (a + c)
 *
 * Of a split corner ribbon i - 1 has the share d^2 a^(d-1) beta (1 - s_(i-1)) h_(i-1), which is of
 * second order at the vertex. It is added for the second point, and taken from the first.
 *
 * On a far side s_i is 0/0. All weights have squares of factors that are 0 there. So second
 * derivatives need only the limit of s_i: the quotient of derivatives in any direction that leaves
 * the side.
 */
#include "polygon/gb.h"
#include "polygon/jet_weighted_sum.h"  /* loft_jet_weighted_sum */

#define LAYERS ((LOFT_DEGREE_MAX + 1) / 2)

static unsigned side_before(unsigned i, unsigned sides) { return i ? i - 1 : sides - 1; }
static unsigned side_after(unsigned i, unsigned sides)  { return i + 1 < sides ? i + 1 : 0; }

static bool is_zero(loft_sci x)            { return loft_sci_sign(x) == 0; }
static loft_sci one_half(void)           { return loft_sci_from_real(LOFT_REAL(0.5)); }

/* The parameters of one side, and 1 minus each of them. */
typedef struct {
    loft_jet s, before_s, h, below_h;
} params;

static loft_jet mul3(const loft_jet *a, const loft_jet *b, const loft_jet *c)
{
    const loft_jet ab = loft_jet_mul(a, b);
    return loft_jet_mul(&ab, c);
}

/* C(degree, k) x^k y^(degree - k) for k = 0 .. count - 1. */
static void bernstein_jets(loft_jet out[], unsigned degree, unsigned count, const loft_jet *x,
                           const loft_jet *y)
{
    loft_jet power = loft_jet_of(loft_sci_one());

    for (unsigned k = 0; k < count; k++) {
        out[k] = loft_jet_scale(&power, loft_sci_from_int(loft_binomial(degree, k)));
        power = loft_jet_mul(&power, x);
    }
    power = loft_jet_pow(y, degree + 1 - count);
    for (unsigned k = count; k-- > 0; ) {
        out[k] = loft_jet_mul(&out[k], &power);
        power = loft_jet_mul(&power, y);
    }
}

/* The sum of all but `count` coordinates from `first` on. */
static loft_jet sum_of_rest(const loft_jet phi[], unsigned sides, unsigned first, unsigned count)
{
    loft_jet sum = loft_jet_of(loft_sci_zero());

    for (unsigned k = count; k < sides; k++)
        sum = loft_jet_add(&sum, &phi[(first + k) % sides]);
    return sum;
}

/* f / whole; its limit where both are 0. */
static loft_jet quotient_or_limit(const loft_jet *f, const loft_jet *whole)
{
    const bool tall = loft_sci_less(loft_sci_abs(whole->x), loft_sci_abs(whole->y));

    if (!is_zero(whole->f))
        return loft_jet_div(f, whole);
    if (is_zero(whole->x) && is_zero(whole->y))
        return loft_jet_of(one_half());
    return loft_jet_of(tall ? loft_sci_div(f->y, whole->y) : loft_sci_div(f->x, whole->x));
}

static bool params_at(params *p, const loft_jet phi[], unsigned sides, unsigned i)
{
    const loft_jet *a = &phi[i], *b = &phi[side_after(i, sides)];

    p->below_h = loft_jet_add(a, b);
    p->h = sum_of_rest(phi, sides, i, 2);
    p->s = quotient_or_limit(b, &p->below_h);
    p->before_s = quotient_or_limit(a, &p->below_h);
    return !is_zero(p->below_h.f) || is_zero(a->f);
}

static void add_point(loft_jet_weighted_sum *s, const loft_gb *g, unsigned side, unsigned j,
                      unsigned k, const loft_jet *weight)
{
    loft_jet_weighted_sum_add(s, &g->p[loft_gb_place(g->sides, g->degree, side, j, k)], weight);
}

/* b + share e. */
static loft_jet moved_jet(const loft_jet *b, const loft_jet *share, const loft_jet *e)
{
    const loft_jet by = loft_jet_mul(share, e);
    return loft_jet_add(b, &by);
}

/* Move the share of ribbon i - 1 from V^i_11 to the other point there; `power` is a^(d-1). */
static void move_share(loft_jet_weighted_sum *s, const loft_gb *g, unsigned i,
                       const loft_jet *power, const loft_jet *beta, const params *last)
{
    const loft_sci m = loft_sci_from_int((int32_t)g->degree);
    const loft_jet part = mul3(power, beta, &last->before_s), whole = loft_jet_mul(&part, &last->h);
    loft_jet share = loft_jet_scale(&whole, loft_sci_mul(m, m));

    loft_jet_weighted_sum_add(s, &g->split[i], &share);
    share = loft_jet_scale(&share, loft_sci_from_int(-1));
    add_point(s, g, i, 1, 1, &share);
}

/* The four points of corner i, from the parameters of its two sides. */
static bool add_corner(loft_jet_weighted_sum *s, const loft_gb *g, const loft_jet phi[], unsigned i,
                       const params *last, const params *here)
{
    const unsigned n = g->sides, d = g->degree;
    const loft_sci m = loft_sci_from_int((int32_t)d);
    const loft_jet *a = &phi[i], *b = &phi[side_after(i, n)], *c = &phi[side_before(i, n)];
    const loft_jet rest = sum_of_rest(phi, n, side_before(i, n), 3),
                   both = loft_jet_add(&last->h, &here->h);

    if (is_zero(both.f))
        return false;
    const loft_jet alpha = loft_jet_div(&last->h, &both), beta = loft_jet_div(&here->h, &both);
    loft_jet x = loft_jet_mul(&last->s, &rest), y = loft_jet_mul(&last->before_s, b);
    const loft_jet e_c = loft_jet_sub(&x, &y);
    x = loft_jet_mul(&here->before_s, &rest);
    y = loft_jet_mul(&here->s, c);
    const loft_jet e_b = loft_jet_sub(&x, &y);

    loft_jet power = loft_jet_pow(a, d - 2);
    x = loft_jet_sub(c, b);
    y = mul3(&here->before_s, &x, &e_c);
    x = mul3(&power, &beta, &y);
    power = loft_jet_mul(&power, a);
    y = mul3(&power, &here->s, &here->h);
    x = loft_jet_add(&x, &y);
    x = loft_jet_scale(&x, loft_sci_mul(m, m));
    add_point(s, g, i, 1, 1, &x);
    y = loft_jet_mul(&power, a);
    add_point(s, g, i, 0, 0, &y);
    if (g->split)
        move_share(s, g, i, &power, &beta, last);

    power = loft_jet_scale(&power, m);
    x = moved_jet(b, &beta, &e_c);
    x = loft_jet_mul(&power, &x);
    add_point(s, g, i, 1, 0, &x);
    x = moved_jet(c, &alpha, &e_b);
    x = loft_jet_mul(&power, &x);
    add_point(s, g, i, 0, 1, &x);
    return true;
}

/* Add all other points of ribbon i. */
static void add_ribbon(loft_jet_weighted_sum *s, const loft_gb *g, unsigned i, const params *here)
{
    const unsigned d = g->degree, layers = (d + 1) / 2;
    loft_jet along[LOFT_DEGREE_MAX + 1], across[LAYERS];

    bernstein_jets(along, d, d + 1, &here->s, &here->before_s);
    bernstein_jets(across, d, layers, &here->h, &here->below_h);
    for (unsigned k = 0; k < layers; k++)
        for (unsigned j = k < 2 ? 2 : k; j <= d - (k < 2 ? 2 : k); j++) {
            loft_jet weight = loft_jet_mul(&along[j], &across[k]);
            if (loft_gb_mu_of(d, j, k) == LOFT_GB_HALF)
                weight = loft_jet_scale(&weight, one_half());
            add_point(s, g, i, j, k, &weight);
        }
}

enum loft_status loft_gb_differential(const loft_gb *g, const loft_jet phi[],
                                      loft_differential *out)
{
    params side[2];
    loft_jet_weighted_sum sum;

    if (!params_at(&side[0], phi, g->sides, g->sides - 1u))
        return LOFT_SINGULAR;
    loft_jet_weighted_sum_start(&sum, g->p[loft_gb_count(g->sides, g->degree) - 1]);
    for (unsigned i = 0; i < g->sides; i++) {
        if (!params_at(&side[1], phi, g->sides, i) ||
            !add_corner(&sum, g, phi, i, &side[0], &side[1]))
            return LOFT_SINGULAR;
        add_ribbon(&sum, g, i, &side[1]);
        side[0] = side[1];
    }
    loft_jet_weighted_sum_end(&sum, out);
    return LOFT_OK;
}

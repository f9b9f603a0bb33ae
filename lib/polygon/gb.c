/* lib/polygon/gb.c
 * SPDX-License-Identifier: MIT
 *
 * 1 - s_i = phi_i / (phi_i + phi_(i+1)), 1 - h_i = phi_i + phi_(i+1), and h_i is the sum of the
 * other phi. If no phi is negative, all factors are sums of positive numbers, their products and
 * quotients. A weight has at most 2 degree + 8 factors, each off by some roundings: q16 2^-54 of
 * it, floats 2^-46. The weights of one ribbon sum to at most 1, those of all ribbons to at most 1.5
 * (the centre of a triangle). V0 has the rest of the weight. So a point errs by 2^-52 (2^-44) of
 * the largest coordinate.
 */
#include "polygon/gb.h"
#include "polygon/weighted_sum.h"      /* loft_weighted_sum, loft_weighted_sum_curve */

#define LAYERS ((LOFT_DEGREE_MAX + 1) / 2)

/* A corner has `wide` points along the side after it and `high` along the one before. */
static unsigned block_width(unsigned degree) { return degree / 2 + 1; }
static unsigned block_height(unsigned degree) { return (degree + 1) / 2; }

static unsigned side_before(unsigned i, unsigned sides) { return i ? i - 1 : sides - 1; }
static unsigned side_after(unsigned i, unsigned sides)  { return i + 1 < sides ? i + 1 : 0; }

static bool sides_valid(unsigned sides, unsigned degree)
{
    return sides >= 3 && sides <= LOFT_SIDES_MAX && degree >= 3 && degree <= LOFT_DEGREE_MAX;
}

unsigned loft_gb_count(unsigned sides, unsigned degree)
{
    return sides * block_width(degree) * block_height(degree) + 1;
}

/* The points beyond those of the first corner belong to the second, where j and k change places. */
unsigned loft_gb_place(unsigned sides, unsigned degree, unsigned side, unsigned j, unsigned k)
{
    const unsigned wide = block_width(degree), high = block_height(degree);

    if (j < wide)
        return (side * wide + j) * high + k;
    return (side_after(side, sides) * wide + k) * high + degree - j;
}

enum loft_status loft_gb_init(loft_gb *g, const loft_vec p[], unsigned sides, unsigned degree)
{
    if (!sides_valid(sides, degree))
        return LOFT_ERR_ARG;
    const unsigned count = loft_gb_count(sides, degree);
    for (unsigned k = 0; k < count; k++)
        if (!loft_vec_valid(p[k]))
            return LOFT_ERR_RANGE;
    g->p = p;
    g->split = NULL;
    g->sides = (uint8_t)sides;
    g->degree = (uint8_t)degree;
    return LOFT_OK;
}

enum loft_status loft_gb_init_split(loft_gb *g, const loft_vec p[], const loft_vec split[],
                                    unsigned sides, unsigned degree)
{
    loft_gb made;
    const enum loft_status status = loft_gb_init(&made, p, sides, degree);

    if (status != LOFT_OK)
        return status;
    for (unsigned k = 0; k < sides; k++)
        if (!loft_vec_valid(split[k]))
            return LOFT_ERR_RANGE;
    made.split = split;
    *g = made;
    return LOFT_OK;
}


/* Parameters */

static bool is_zero(loft_sci x) { return loft_sci_sign(x) == 0; }

enum loft_status loft_gb_params(unsigned sides, const loft_sci phi[], loft_gb_side out[])
{
    for (unsigned i = 0; i < sides; i++) {
        const unsigned j = side_after(i, sides);
        loft_gb_side *o = &out[i];

        o->any = is_zero(phi[i]) && is_zero(phi[j]);
        o->below_h = loft_sci_add(phi[i], phi[j]);
        o->h = loft_sci_zero();
        for (unsigned k = side_after(j, sides); k != i; k = side_after(k, sides))
            o->h = loft_sci_add(o->h, phi[k]);
        if (o->any) {
            o->s = o->before_s = loft_sci_from_real(LOFT_REAL(0.5));
            continue;
        }
        if (is_zero(o->below_h))
            return LOFT_SINGULAR;
        o->s = loft_sci_div(phi[j], o->below_h);
        o->before_s = loft_sci_div(phi[i], o->below_h);
    }
    return LOFT_OK;
}

enum loft_gb_mu loft_gb_mu_of(unsigned degree, unsigned j, unsigned k)
{
    if (k < 2)
        return j < 2 ? LOFT_GB_BEFORE : j + 2 > degree ? LOFT_GB_AFTER : LOFT_GB_WHOLE;
    if (j < k || j > degree - k)
        return LOFT_GB_NONE;
    return j == k || j == degree - k ? LOFT_GB_HALF : LOFT_GB_WHOLE;
}


/* Weights */

/* The factors of the weights of one ribbon: B_j(s_i), the same times mu, B_k(h_i). */
typedef struct {
    loft_sci along[LOFT_DEGREE_MAX + 1], turned[4], across[LAYERS];
} ribbon;

/* C(degree, k) x^k y^(degree - k) for k = 0 .. count - 1. */
static void bernstein_values(loft_sci out[], unsigned degree, unsigned count, loft_sci x,
                             loft_sci y)
{
    loft_sci power = loft_sci_one();
    int32_t ways = 1;

    for (unsigned k = 0; k < count; k++) {
        out[k] = loft_sci_mul(power, loft_sci_from_int(ways));
        power = loft_sci_mul(power, x);
        ways = ways * (int32_t)(degree - k) / (int32_t)(k + 1);
    }
    power = loft_sci_pow(y, degree + 1 - count);
    for (unsigned k = count; k-- > 0; ) {
        out[k] = loft_sci_mul(out[k], power);
        power = loft_sci_mul(power, y);
    }
}

/* a / (a + b); 1/2 where both are 0; false where only their sum is 0. */
static bool quotient_of_sum(loft_sci a, loft_sci b, loft_sci *out)
{
    const loft_sci sum = loft_sci_add(a, b);

    if (is_zero(sum) && !is_zero(a))
        return false;
    *out = is_zero(sum) ? loft_sci_from_real(LOFT_REAL(0.5)) : loft_sci_div(a, sum);
    return true;
}

static bool ribbon_start(ribbon *r, const loft_gb_side side[], unsigned sides, unsigned degree,
                         unsigned i)
{
    loft_sci alpha, beta;

    if (!quotient_of_sum(side[side_before(i, sides)].h, side[i].h, &alpha) ||
        !quotient_of_sum(side[side_after(i, sides)].h, side[i].h, &beta))
        return false;
    bernstein_values(r->along, degree, degree + 1, side[i].s, side[i].before_s);
    bernstein_values(r->across, degree, block_height(degree), side[i].h, side[i].below_h);
    for (unsigned j = 0; j < 2; j++) {
        r->turned[j] = loft_sci_mul(alpha, r->along[j]);
        r->turned[3 - j] = loft_sci_mul(beta, r->along[degree - j]);
    }
    return true;
}

/* mu B_j(s_i), where mu is not 0. */
static loft_sci point_share(const ribbon *r, unsigned degree, unsigned j, unsigned k)
{
    switch (loft_gb_mu_of(degree, j, k)) {
    case LOFT_GB_BEFORE:    return r->turned[j];
    case LOFT_GB_AFTER:     return r->turned[j + 3 - degree];
    case LOFT_GB_HALF:      return loft_sci_mul(r->along[j], loft_sci_from_real(LOFT_REAL(0.5)));
    case LOFT_GB_WHOLE:     return r->along[j];
    case LOFT_GB_NONE:      break;
    }
    return loft_sci_zero();
}

/* The first j of row k whose mu is not 0. The last j is as far from the other end. */
static unsigned first_of_row(unsigned k) { return k < 2 ? 0 : k; }

enum loft_status loft_gb_weights(unsigned sides, unsigned degree, const loft_sci phi[],
                                 loft_sci out[])
{
    const unsigned last = loft_gb_count(sides, degree) - 1;
    loft_gb_side side[LOFT_SIDES_MAX];
    loft_sci sum = loft_sci_zero();
    ribbon r;

    if (loft_gb_params(sides, phi, side) != LOFT_OK)
        return LOFT_SINGULAR;
    for (unsigned p = 0; p < last; p++)
        out[p] = loft_sci_zero();
    for (unsigned i = 0; i < sides; i++) {
        if (side[i].any)
            continue;
        if (!ribbon_start(&r, side, sides, degree, i))
            return LOFT_SINGULAR;
        for (unsigned k = 0; k < block_height(degree); k++)
            for (unsigned j = first_of_row(k); j <= degree - first_of_row(k); j++) {
                loft_sci *o = &out[loft_gb_place(sides, degree, i, j, k)];
                const loft_sci weight = loft_sci_mul(point_share(&r, degree, j, k), r.across[k]);
                *o = loft_sci_add(*o, weight);
                sum = loft_sci_add(sum, weight);
            }
    }
    out[last] = loft_sci_sub(loft_sci_one(), sum);
    return LOFT_OK;
}


/* Points */

/* The side on which all other coordinates are 0; `sides` if there is none. */
static unsigned border_of(unsigned sides, const loft_sci phi[])
{
    unsigned i = 0;

    for (; i < sides; i++) {
        unsigned k = side_after(side_after(i, sides), sides);
        while (k != i && is_zero(phi[k]))
            k = side_after(k, sides);
        if (k == i)
            break;
    }
    return i;
}

static enum loft_status border_point(const loft_gb *g, const loft_sci phi[], unsigned side,
                                     loft_vec *out)
{
    const loft_sci share[2] = { phi[side], phi[side_after(side, g->sides)] };
    loft_vec p[LOFT_DEGREE_MAX + 1];

    for (unsigned j = 0; j <= g->degree; j++)
        p[j] = g->p[loft_gb_place(g->sides, g->degree, side, j, 0)];
    return loft_weighted_sum_curve(p, NULL, g->degree, share, out);
}

/* The point of the ribbon of this side: at its end that of a split corner. */
static const loft_vec *ribbon_point(const loft_gb *g, unsigned side, unsigned j, unsigned k)
{
    return g->split && j + 1 == g->degree && k == 1
               ? &g->split[side_after(side, g->sides)]
               : &g->p[loft_gb_place(g->sides, g->degree, side, j, k)];
}

static void add_row(loft_weighted_sum *sum, const loft_gb *g, const ribbon *r, unsigned side,
                    unsigned k)
{
    loft_weighted_sum row;

    loft_weighted_sum_start(&row);
    for (unsigned j = first_of_row(k); j <= g->degree - first_of_row(k); j++)
        loft_weighted_sum_add(&row, ribbon_point(g, side, j, k), point_share(r, g->degree, j, k));
    loft_weighted_sum_join(sum, &row, r->across[k]);
}

enum loft_status loft_gb_eval(const loft_gb *g, const loft_sci phi[], loft_vec *out)
{
    const unsigned border = border_of(g->sides, phi);
    loft_gb_side side[LOFT_SIDES_MAX];
    loft_weighted_sum sum;
    ribbon r;

    if (border < g->sides)
        return border_point(g, phi, border, out);
    if (loft_gb_params(g->sides, phi, side) != LOFT_OK)
        return LOFT_SINGULAR;
    loft_weighted_sum_start(&sum);
    for (unsigned i = 0; i < g->sides; i++) {
        if (side[i].any)
            continue;
        if (!ribbon_start(&r, side, g->sides, g->degree, i))
            return LOFT_SINGULAR;
        for (unsigned k = 0; k < block_height(g->degree); k++)
            add_row(&sum, g, &r, i, k);
    }
    loft_weighted_sum_add(&sum, &g->p[loft_gb_count(g->sides, g->degree) - 1],
                          loft_sci_sub(loft_sci_one(), sum.w));
    return loft_weighted_sum_point(&sum, out);
}

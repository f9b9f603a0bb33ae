/* lib/polygon/zheng_ball.c
 * SPDX-License-Identifier: MIT
 *
 * Weights before the correction, with P = prod u_i^l_i, and k = l_(i-1) for a point on side i:
 *
 *     inside      C(d,a) C(d,b) P
 *     on side i   C(d,k) P f      f = 1 - d U (5 sides), 1 - 2 d U (6 sides), U = prod u_i
 *                                 3 sides: 1 - u_i ((d - k) + (2 k - d) u_(i+1)) if d - k <= k,
 *                                 else 1 - u_i (k + (d - 2 k) u_(i-1))
 *
 * They sum to 1 + e with a small e. The correction distributes -e evenly over the T points inside.
 * All weights are below 126^2 / 2^4 in absolute value and have at most 9 sides + 3 factors, so they
 * err by at most 2^-53 (floats 2^-46). Most of the up to 151 terms are far below 1, so their sum
 * errs by no more.
 */
#include "polygon/zheng_ball.h"
#include "polygon/weighted_sum.h"      /* loft_weighted_sum */
#include "polygon/jet_weighted_sum.h"  /* loft_jet_weighted_sum */

/* The points of a block: a = 0 .. wide - 1, b = 0 .. high - 1. */
static unsigned block_width(unsigned degree) { return degree / 2 + 1; }
static unsigned block_height(unsigned degree) { return (degree + 1) / 2; }

static unsigned side_before(unsigned i, unsigned sides) { return i ? i - 1 : sides - 1; }
static unsigned side_after(unsigned i, unsigned sides)  { return i + 1 < sides ? i + 1 : 0; }

unsigned loft_zheng_ball_count(unsigned sides, unsigned degree)
{
    return sides * block_width(degree) * block_height(degree) + (degree % 2 == 0);
}

/* The corner and the indices a, b of point k. The centre is a = b = degree / 2 of any corner. */
static void block_of(unsigned sides, unsigned degree, unsigned k, unsigned *corner, unsigned *a,
                     unsigned *b)
{
    const unsigned high = block_height(degree), block = block_width(degree) * high;

    *corner = k / block;
    *a = k % block / high;
    *b = k % high;
    if (*corner == sides) {
        *corner = 0;
        *a = *b = degree / 2;
    }
}

void loft_zheng_ball_index(unsigned sides, unsigned degree, unsigned k, uint8_t l[])
{
    unsigned corner, a, b;

    block_of(sides, degree, k, &corner, &a, &b);
    const unsigned less = a < b ? a : b, more = a < b ? b : a;
    for (unsigned i = 0; i < sides; i++)
        l[i] = (uint8_t)(degree - less);
    if (sides == 3) {
        l[side_after(corner, sides)] = (uint8_t)(degree - more);
    } else {
        l[side_after(corner, sides)] = (uint8_t)(degree - a);
        l[side_before(side_before(corner, sides), sides)] = (uint8_t)(degree - b);
    }
    l[side_before(corner, sides)] = (uint8_t)a;
    l[corner] = (uint8_t)b;
}

enum loft_status loft_zheng_ball_init(loft_zheng_ball *r, const loft_vec p[], unsigned sides,
                                      unsigned degree)
{
    if ((sides != 3 && sides != 5 && sides != 6) || degree < 2 || degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    const unsigned count = loft_zheng_ball_count(sides, degree);
    for (unsigned k = 0; k < count; k++)
        if (!loft_vec_valid(p[k]))
            return LOFT_ERR_RANGE;
    r->p = p;
    r->sides = (uint8_t)sides;
    r->degree = (uint8_t)degree;
    return LOFT_OK;
}


/* Weights */

typedef struct {
    loft_sci power[LOFT_ZHENG_BALL_SIDES]
                  [LOFT_DEGREE_MAX + 1]; /* u_i^k                           */
    loft_sci factor;                                        /* f of 5 and 6 sides              */
    const loft_sci *u;
    uint8_t sides, degree;
} basis;

static void basis_start(basis *b, unsigned sides, unsigned degree, const loft_sci u[])
{
    loft_sci all = loft_sci_one();

    for (unsigned i = 0; i < sides; i++) {
        b->power[i][0] = loft_sci_one();
        for (unsigned k = 1; k <= degree; k++)
            b->power[i][k] = loft_sci_mul(b->power[i][k - 1], u[i]);
        all = loft_sci_mul(all, u[i]);
    }
    all = loft_sci_mul(all, loft_sci_from_int((int32_t)(sides == 6 ? 2 * degree : degree)));
    b->factor = loft_sci_sub(loft_sci_one(), all);
    b->u = u;
    b->sides = (uint8_t)sides;
    b->degree = (uint8_t)degree;
}

static loft_sci border_factor(const basis *b, unsigned side, unsigned k)
{
    const unsigned d = b->degree;
    const bool far = d - k <= k;
    const int32_t one = (int32_t)(far ? d - k : k), rest = (int32_t)d - 2 * one;

    if (b->sides != 3)
        return b->factor;
    const loft_sci *beside = &b->u[far ? side_after(side, 3) : side_before(side, 3)];
    const loft_sci sum = loft_sci_add(loft_sci_from_int(one),
                                      loft_sci_mul(loft_sci_from_int(rest), *beside));
    return loft_sci_sub(loft_sci_one(), loft_sci_mul(b->u[side], sum));
}

/* The weight of point k before the correction. *inside is true if the point takes part in the
 * correction. */
static loft_sci point_weight(const basis *b, unsigned k, bool *inside)
{
    uint8_t l[LOFT_ZHENG_BALL_SIDES];
    unsigned corner, a, c;
    loft_sci weight = loft_sci_one();

    block_of(b->sides, b->degree, k, &corner, &a, &c);
    loft_zheng_ball_index(b->sides, b->degree, k, l);
    for (unsigned i = 0; i < b->sides; i++)
        if (l[i])
            weight = loft_sci_mul(weight, b->power[i][l[i]]);
    weight = loft_sci_mul(
        weight, loft_sci_from_int(loft_binomial(b->degree, a) * loft_binomial(b->degree, c)));
    *inside = a && c;
    if (!*inside)
        weight = loft_sci_mul(weight,
                              c ? border_factor(b, side_before(corner, b->sides), b->degree - c)
                                : border_factor(b, corner, a));
    return weight;
}

/* The number of points inside. */
static int32_t inner_count(unsigned sides, unsigned degree)
{
    return (int32_t)(loft_zheng_ball_count(sides, degree) - sides * degree);
}

/* The correction of each point inside: (1 - sum) / T. */
static loft_sci correction_of(unsigned sides, unsigned degree, loft_sci sum)
{
    return loft_sci_div(loft_sci_sub(loft_sci_one(), sum),
                        loft_sci_from_int(inner_count(sides, degree)));
}

void loft_zheng_ball_weights(unsigned sides, unsigned degree, const loft_sci u[], loft_sci out[])
{
    const unsigned count = loft_zheng_ball_count(sides, degree);
    loft_sci sum = loft_sci_zero();
    bool inside = false;
    basis b;

    basis_start(&b, sides, degree, u);
    for (unsigned k = 0; k < count; k++) {
        out[k] = point_weight(&b, k, &inside);
        sum = loft_sci_add(sum, out[k]);
    }
    const loft_sci part = correction_of(sides, degree, sum);
    for (unsigned k = 0; k < count; k++) {
        unsigned corner, a, c;
        block_of(sides, degree, k, &corner, &a, &c);
        if (a && c)
            out[k] = loft_sci_add(out[k], part);
    }
}


/* Points */

/* The index of point k of side i, in the block of its first or its second corner. */
static unsigned border_place(const loft_zheng_ball *r, unsigned side, unsigned k)
{
    const unsigned d = r->degree, high = block_height(d), block = block_width(d) * high;

    return k < block_width(d) ? side * block + k * high
                              : side_after(side, r->sides) * block + d - k;
}

static enum loft_status border_point(const loft_zheng_ball *r, const loft_sci u[], unsigned side,
                                     loft_vec *out)
{
    const loft_sci share[2] = { u[side_after(side, r->sides)], u[side_before(side, r->sides)] };
    loft_vec p[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= r->degree; k++)
        p[k] = r->p[border_place(r, side, k)];
    return loft_weighted_sum_curve(p, NULL, r->degree, share, out);
}

/* The correction is the same for all points inside, so it multiplies their plain sum. */
enum loft_status loft_zheng_ball_eval(const loft_zheng_ball *r, const loft_sci u[], loft_vec *out)
{
    const unsigned count = loft_zheng_ball_count(r->sides, r->degree);
    loft_weighted_sum sum, inner;
    bool inside = false;
    basis b;

    for (unsigned i = 0; i < r->sides; i++)
        if (!loft_sci_sign(u[i]))
            return border_point(r, u, i, out);
    basis_start(&b, r->sides, r->degree, u);
    loft_weighted_sum_start(&sum);
    loft_weighted_sum_start(&inner);
    for (unsigned k = 0; k < count; k++) {
        loft_weighted_sum_add(&sum, &r->p[k], point_weight(&b, k, &inside));
        if (inside)
            loft_weighted_sum_add(&inner, &r->p[k], loft_sci_one());
    }
    loft_weighted_sum_join(&sum, &inner, correction_of(r->sides, r->degree, sum.w));
    return loft_weighted_sum_point(&sum, out);
}


/* Derivatives
 *
 * The same weights as jets. Since the weights sum to 1, points are relative to the last one. With P
 * and Q of zheng_ball.h, the terms of a first derivative of a product of powers are at most n P,
 * those of a second one (n P)^2 + n Q, times weights whose absolute values sum to less than 3. They
 * err by 9 sides + 3 < 2^6 roundings of 2^-61 (floats 2^-53), their sum and the correction by as
 * much: below 2^-52. */

typedef struct {
    loft_jet factor;            /* f of 5 and 6 sides */
    const loft_jet *u;
    unsigned sides, degree;
} jet_basis;

/* 1 - a. */
static loft_jet one_minus(const loft_jet *a)
{
    const loft_jet one = loft_jet_of(loft_sci_one());
    return loft_jet_sub(&one, a);
}

static void jet_basis_start(jet_basis *b, const loft_zheng_ball *r, const loft_jet u[])
{
    const int32_t times = r->sides == 6 ? 2 * r->degree : r->degree;
    loft_jet all = loft_jet_of(loft_sci_from_int(times));

    for (unsigned i = 0; i < r->sides; i++)
        all = loft_jet_mul(&all, &u[i]);
    b->factor = one_minus(&all);
    b->u = u;
    b->sides = r->sides;
    b->degree = r->degree;
}

static loft_jet border_jet(const jet_basis *b, unsigned side, unsigned k)
{
    const unsigned d = b->degree;
    const bool far = d - k <= k;
    const int32_t one = (int32_t)(far ? d - k : k), rest = (int32_t)d - 2 * one;

    if (b->sides != 3)
        return b->factor;
    const loft_jet *beside = &b->u[far ? side_after(side, 3) : side_before(side, 3)];
    loft_jet sum = loft_jet_scale(beside, loft_sci_from_int(rest));
    sum.f = loft_sci_add(sum.f, loft_sci_from_int(one));
    const loft_jet product = loft_jet_mul(&b->u[side], &sum);
    return one_minus(&product);
}

/* As point_weight. */
static loft_jet point_weight_jet(const jet_basis *b, unsigned k, bool *inside)
{
    uint8_t l[LOFT_ZHENG_BALL_SIDES];
    unsigned corner, a, c;

    block_of(b->sides, b->degree, k, &corner, &a, &c);
    loft_zheng_ball_index(b->sides, b->degree, k, l);
    const int32_t ways = loft_binomial(b->degree, a) * loft_binomial(b->degree, c);
    loft_jet weight = loft_jet_of(loft_sci_from_int(ways));
    for (unsigned i = 0; i < b->sides; i++)
        if (l[i]) {
            const loft_jet power = loft_jet_pow(&b->u[i], l[i]);
            weight = loft_jet_mul(&weight, &power);
        }
    *inside = a && c;
    if (*inside)
        return weight;
    const loft_jet factor = c ? border_jet(b, side_before(corner, b->sides), b->degree - c)
                              : border_jet(b, corner, a);
    return loft_jet_mul(&weight, &factor);
}

/* The correction of each point inside: (1 - sum) / T. */
static loft_jet correction_jet(const loft_zheng_ball *r, const loft_jet *sum)
{
    const loft_jet rest = one_minus(sum);
    const loft_sci count = loft_sci_from_int(inner_count(r->sides, r->degree));

    return loft_jet_scale(&rest, loft_sci_div(loft_sci_one(), count));
}

void loft_zheng_ball_differential(const loft_zheng_ball *r, const loft_jet u[],
                                  loft_differential *out)
{
    const unsigned count = loft_zheng_ball_count(r->sides, r->degree);
    loft_jet_weighted_sum sum;
    jet_basis b;
    bool inside;

    jet_basis_start(&b, r, u);
    loft_jet_weighted_sum_start(&sum, r->p[count - 1]);
    for (unsigned k = 0; k < count; k++) {
        const loft_jet weight = point_weight_jet(&b, k, &inside);
        loft_jet_weighted_sum_add(&sum, &r->p[k], &weight);
    }
    const loft_jet part = correction_jet(r, &sum.w);
    for (unsigned k = 0; k < count; k++) {
        unsigned corner, a, c;
        block_of(r->sides, r->degree, k, &corner, &a, &c);
        if (a && c)
            loft_jet_weighted_sum_add(&sum, &r->p[k], &part);
    }
    loft_jet_weighted_sum_end(&sum, out);
}

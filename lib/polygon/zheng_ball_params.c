/* lib/polygon/zheng_ball_params.c -- consistent parameters of Zheng-Ball patches
 * SPDX-License-Identifier: MIT
 *
 * A parameter near 1 keeps all digits of 1 - u. Everything is computed for u and for 1 - u, and the
 * sums below are formed from both without cancellation.
 */
#include "polygon/zheng_ball.h"
#include "polygon/jet.h"        /* loft_jet: derivatives */

typedef struct {
    loft_sci u, rest;       /* rest = 1 - u */
} share;

static share share_of(loft_unit u)
{
    const share s = { loft_sci_from_unit(u), loft_sci_sub(loft_sci_one(), loft_sci_from_unit(u)) };
    return s;
}

/* 1 - a b */
static loft_sci one_minus_product(share a, share b)
{
    return loft_sci_add(a.rest, loft_sci_mul(a.u, b.rest));
}

/* u_1 + u_2 + u_3 = 2 u_1 u_2 u_3 + 1 */
static enum loft_status three_params(share a, share b, loft_sci u[])
{
    const loft_sci left = loft_sci_sub(a.rest, b.u), two = loft_sci_from_int(2);

    if (loft_sci_sign(left) < 0)
        return LOFT_ERR_ARG;
    u[2] = loft_sci_div(left,
                        loft_sci_sub(loft_sci_one(), loft_sci_mul(two, loft_sci_mul(a.u, b.u))));
    return LOFT_OK;
}

/* u_i = 1 - u_(i+2) u_(i+3) */
static void five_params(share a, share b, loft_sci u[])
{
    u[3] = one_minus_product(a, b);
    u[2] = loft_sci_div(a.rest, u[3]);
    u[4] = loft_sci_div(b.rest, u[3]);
}

/* Six sides: three neighbours a, b, x satisfy
 *
 *     A x^2 + B x + C = 0        A = (1 - ab)(1 - 2ab),  B = 2a - 3a^2 b + a b^2,  C = a^2 - 1
 *
 * with one root in 0..1. With alpha = 1 - a, beta = 1 - b, sigma = alpha + beta, pi = alpha beta,
 * s = 1 - ab = sigma - pi:
 *
 *     A = s (2s - 1)        B = a (3 alpha b + beta + beta^2)        -C = alpha (1 + a)
 *     F = A + B + C = a beta (alpha b + beta (2 + a))
 *     M = 2A + B    = (alpha - beta) + sigma (sigma + 4 beta) - pi (5 alpha + 9 beta - 4 pi)
 *     D = B^2 - 4AC = M^2 - 4AF
 *       = (alpha - beta)^2 + s (sigma^2 (s + 2) + 4 pi (2 - 3 sigma + 2 pi))
 *
 *     x     = -2C / (B + sqrt D)
 *     1 - x = 2F / (M + sqrt D),  for M < 0, where A < 0, (M - sqrt D) / (2A)
 *
 * B, -C, F are sums of positive numbers. So is D where alpha and beta are small. M cancels only
 * near a = b = 1, where it is small against sqrt D. */
typedef struct {
    loft_sci a, b, c, f, m, d;      /* A, B, -C, F, M, sqrt D */
} quadratic;

static loft_sci times_int(int32_t k, loft_sci x) { return loft_sci_mul(loft_sci_from_int(k), x); }

static quadratic quadratic_of(share a, share b)
{
    const loft_sci one = loft_sci_one(), alpha = a.rest, beta = b.rest;
    const loft_sci s = one_minus_product(a, b), sigma = loft_sci_add(alpha, beta),
                   pi = loft_sci_mul(alpha, beta);
    const loft_sci apart = loft_sci_sub(alpha, beta), mixed = loft_sci_mul(alpha, b.u);
    quadratic q;

    q.a = loft_sci_mul(s, loft_sci_sub(times_int(2, s), one));
    q.b = loft_sci_mul(
        a.u, loft_sci_add(times_int(3, mixed), loft_sci_add(beta, loft_sci_mul(beta, beta))));
    q.c = loft_sci_mul(alpha, loft_sci_add(one, a.u));
    q.f = loft_sci_mul(
        loft_sci_mul(a.u, beta),
        loft_sci_add(mixed, loft_sci_mul(beta, loft_sci_add(loft_sci_from_int(2), a.u))));

    const loft_sci second = loft_sci_mul(sigma, loft_sci_add(sigma, times_int(4, beta)));
    const loft_sci third = loft_sci_mul(
        pi, loft_sci_add(times_int(5, alpha), loft_sci_sub(times_int(9, beta), times_int(4, pi))));
    q.m = loft_sci_add(apart, loft_sci_sub(second, third));

    const loft_sci squares = loft_sci_mul(loft_sci_mul(sigma, sigma),
                                          loft_sci_add(s, loft_sci_from_int(2)));
    const loft_sci rest = loft_sci_add(loft_sci_sub(loft_sci_from_int(2), times_int(3, sigma)),
                                       times_int(2, pi));
    const loft_sci sum = loft_sci_add(squares, times_int(4, loft_sci_mul(pi, rest)));
    q.d = loft_sci_sqrt(loft_sci_add(loft_sci_mul(apart, apart), loft_sci_mul(s, sum)));
    return q;
}

/* The neighbour of b that is not a. */
static share neighbour_share(share a, share b)
{
    const share corner = { loft_sci_one(), loft_sci_zero() };
    const loft_sci two = loft_sci_from_int(2);
    share x;

    if (!loft_sci_sign(a.rest) && !loft_sci_sign(b.rest))
        return corner;
    const quadratic q = quadratic_of(a, b);
    x.u = loft_sci_div(loft_sci_mul(two, q.c), loft_sci_add(q.b, q.d));
    x.rest = loft_sci_sign(q.m) < 0 ? loft_sci_div(loft_sci_sub(q.m, q.d), loft_sci_mul(two, q.a))
                                    : loft_sci_div(loft_sci_mul(two, q.f), loft_sci_add(q.m, q.d));
    return x;
}

static void six_params(share a, share b, loft_sci u[])
{
    const share c = neighbour_share(a, b), f = neighbour_share(b, a);

    u[2] = c.u;
    u[3] = neighbour_share(b, c).u;
    u[4] = neighbour_share(a, f).u;
    u[5] = f.u;
}

static bool unit_valid(loft_unit u) { return u >= 0 && u <= LOFT_UNIT(1); }

enum loft_status loft_zheng_ball_params(unsigned sides, loft_unit u1, loft_unit u2, loft_sci u[])
{
    const share a = share_of(u1), b = share_of(u2);

    if (!unit_valid(u1) || !unit_valid(u2) || (sides != 3 && sides != 5 && sides != 6))
        return LOFT_ERR_ARG;
    if (sides > 3 && u1 >= LOFT_UNIT(1) && u2 >= LOFT_UNIT(1))
        return LOFT_SINGULAR;
    u[0] = a.u;
    u[1] = b.u;
    if (sides == 3)
        return three_params(a, b, u);
    if (sides == 5)
        five_params(a, b, u);
    else
        six_params(a, b, u);
    return LOFT_OK;
}

/* Newton's method for 2 p t^3 - t + 1 = 0, p = b_1 b_2 b_3 <= 1/27, from t = 1:
 *
 *     t = (1 - 4 p t^3) / (1 - 6 p t^2)
 *
 * The errors are at most 0.099, 4e-3, 6e-6, 2e-11, 2e-22, because the second derivative over twice
 * the first is below 0.4. */
enum loft_status loft_zheng_ball_lift(loft_unit b1, loft_unit b2, loft_sci u[])
{
    const loft_sci one = loft_sci_one(), four = loft_sci_from_int(4), six_of = loft_sci_from_int(6);
    loft_sci t = one;

    if (!unit_valid(b1) || !unit_valid(b2))
        return LOFT_ERR_ARG;
    u[0] = loft_sci_from_unit(b1);
    u[1] = loft_sci_from_unit(b2);
    u[2] = loft_sci_sub(loft_sci_sub(one, u[0]), u[1]);
    if (loft_sci_sign(u[2]) < 0)
        return LOFT_ERR_ARG;
    const loft_sci p = loft_sci_mul(loft_sci_mul(u[0], u[1]), u[2]);
    for (int step = 0; step < 4; step++) {
        const loft_sci pt2 = loft_sci_mul(p, loft_sci_mul(t, t));
        t = loft_sci_div(loft_sci_sub(one, loft_sci_mul(four, loft_sci_mul(pt2, t))),
                         loft_sci_sub(one, loft_sci_mul(six_of, pt2)));
    }
    for (int i = 0; i < 3; i++)
        u[i] = loft_sci_mul(u[i], t);
    return LOFT_OK;
}


/* Derivatives
 *
 * The first two parameters, or b_1 and b_2 of a lift, are the variables. The value of each other
 * parameter is known. Its derivatives follow from the equation G = 0 that it solves. Let G be
 * computed in jets from a jet u whose value and derivatives of orders 1 .. k - 1 are right. The
 * derivatives of order k of G contain those of u once, times the number G_u. So
 *
 *     u - G / G_u
 *
 * has the right derivatives of order k as well: two rounds from a constant give both orders. For
 * six sides G_x is sqrt D above, which is small where a and b are both near 1. u_4 follows from u_2
 * and u_3 or from u_6 and u_5, and u_5 likewise: the pair farther from 1 is taken. For a lift G_t
 * is between -1 and -0.73.
 *
 * Errors: e = 2^-61 (floats 2^-53), r the larger of 1 - u_1 and 1 - u_2. Terms of G are at most 6.
 * It errs by 30 e where its jets are of size 1: 2^-56 in all. Derivatives grow as 1 / r and 1 / r^2
 * toward u_1 = u_2 = 1. Each round divides by sqrt D, which is about r^(3/2) there for u_1 = u_2.
 * The measured growth of the errors is 1 / r^2 and 1 / r^4 in all. */

/* c - a. */
static loft_jet jet_from(int32_t c, const loft_jet *a)
{
    const loft_jet number = loft_jet_of(loft_sci_from_int(c));
    return loft_jet_sub(&number, a);
}

static loft_jet times_int_jet(int32_t c, const loft_jet *a)
{
    return loft_jet_scale(a, loft_sci_from_int(c));
}

static loft_jet mul3(const loft_jet *a, const loft_jet *b, const loft_jet *c)
{
    const loft_jet ab = loft_jet_mul(a, b);
    return loft_jet_mul(&ab, c);
}

/* u - g / slope; the value stays. */
static loft_jet corrected_jet(const loft_jet *u, const loft_jet *g, loft_sci slope)
{
    const loft_jet step = loft_jet_scale(g, loft_sci_div(loft_sci_one(), slope));
    loft_jet r = loft_jet_sub(u, &step);

    r.f = u->f;
    return r;
}

/* A, B and C. */
static void neighbour_terms(const loft_jet *a, const loft_jet *b, loft_jet term[3])
{
    const loft_jet ab = loft_jet_mul(a, b), left = jet_from(1, &ab);
    const loft_jet twice = times_int_jet(2, &ab), right = jet_from(1, &twice);
    const loft_jet aab = loft_jet_mul(a, &ab), abb = loft_jet_mul(&ab, b),
                   two = times_int_jet(2, a);
    const loft_jet three = times_int_jet(3, &aab), rise = loft_jet_add(&two, &abb);
    const loft_jet one = loft_jet_of(loft_sci_one()), square = loft_jet_mul(a, a);

    term[0] = loft_jet_mul(&left, &right);
    term[1] = loft_jet_sub(&rise, &three);
    term[2] = loft_jet_sub(&square, &one);
}

/* The neighbour of b that is not a. Its value x is known. */
static loft_jet neighbour_jet(const loft_jet *a, const loft_jet *b, loft_sci x)
{
    loft_jet u = loft_jet_of(x), term[3];

    neighbour_terms(a, b, term);
    const loft_sci slope = loft_sci_add(times_int(2, loft_sci_mul(term[0].f, x)), term[1].f);
    for (int round = 0; round < 2; round++) {
        const loft_jet linear = loft_jet_mul(&term[0], &u), sum = loft_jet_add(&linear, &term[1]);
        const loft_jet product = loft_jet_mul(&sum, &u), g = loft_jet_add(&product, &term[2]);
        u = corrected_jet(&u, &g, slope);
    }
    return u;
}

static void three_jets(loft_jet u[])
{
    const loft_jet ab = loft_jet_mul(&u[0], &u[1]), twice = times_int_jet(2, &ab);
    const loft_jet sum = loft_jet_add(&u[0], &u[1]);
    const loft_jet above = jet_from(1, &sum), below = jet_from(1, &twice);

    u[2] = loft_jet_div(&above, &below);
}

static void five_jets(loft_jet u[])
{
    const loft_jet ab = loft_jet_mul(&u[0], &u[1]), a = jet_from(1, &u[0]), b = jet_from(1, &u[1]);

    u[3] = jet_from(1, &ab);
    u[2] = loft_jet_div(&a, &u[3]);
    u[4] = loft_jet_div(&b, &u[3]);
}

static loft_sci sci_min(loft_sci a, loft_sci b) { return loft_sci_less(a, b) ? a : b; }

/* From the pair of neighbours that is farther from 1. */
static loft_jet best_neighbour(const loft_jet u[], const loft_sci at[], const uint8_t pair[4],
                               unsigned i)
{
    const loft_sci one = sci_min(at[pair[0]], at[pair[1]]), two = sci_min(at[pair[2]], at[pair[3]]);
    const uint8_t *p = loft_sci_less(two, one) ? pair + 2 : pair;

    return neighbour_jet(&u[p[0]], &u[p[1]], at[i]);
}

static void six_jets(const loft_sci at[], loft_jet u[])
{
    u[2] = neighbour_jet(&u[0], &u[1], at[2]);
    u[5] = neighbour_jet(&u[1], &u[0], at[5]);
    if (loft_sci_less(sci_min(at[0], at[5]), sci_min(at[1], at[2]))) {
        u[4] = neighbour_jet(&u[0], &u[5], at[4]);
        u[3] = best_neighbour(u, at, (const uint8_t[]) { 1, 2, 5, 4 }, 3);
    } else {
        u[3] = neighbour_jet(&u[1], &u[2], at[3]);
        u[4] = best_neighbour(u, at, (const uint8_t[]) { 0, 5, 2, 3 }, 4);
    }
}

enum loft_status loft_zheng_ball_params_jet(unsigned sides, loft_unit u1, loft_unit u2,
                                            loft_jet u[])
{
    loft_sci at[LOFT_ZHENG_BALL_SIDES];
    const enum loft_status status = loft_zheng_ball_params(sides, u1, u2, at);

    if (status != LOFT_OK)
        return status;
    u[0] = loft_jet_of(at[0]);
    u[1] = loft_jet_of(at[1]);
    u[0].x = u[1].y = loft_sci_one();
    if (sides == 3)
        three_jets(u);
    else if (sides == 5)
        five_jets(u);
    else
        six_jets(at, u);
    for (unsigned i = 2; i < sides; i++)
        u[i].f = at[i];
    return LOFT_OK;
}

/* The t of a lift. Its value is known. */
static loft_jet lift_jet(const loft_jet b[3], loft_sci t)
{
    const loft_jet p = mul3(&b[0], &b[1], &b[2]), one = loft_jet_of(loft_sci_one());
    const loft_sci square = times_int(6, loft_sci_mul(p.f, loft_sci_mul(t, t)));
    const loft_sci slope = loft_sci_sub(square, loft_sci_one());
    loft_jet r = loft_jet_of(t);

    for (int round = 0; round < 2; round++) {
        const loft_jet cube = mul3(&r, &r, &r), product = loft_jet_mul(&p, &cube);
        const loft_jet twice = times_int_jet(2, &product);
        const loft_jet rest = loft_jet_sub(&one, &r), g = loft_jet_add(&twice, &rest);
        r = corrected_jet(&r, &g, slope);
    }
    return r;
}

enum loft_status loft_zheng_ball_lift_jet(loft_unit b1, loft_unit b2, loft_jet u[])
{
    unsigned largest = 0;
    loft_sci at[3];
    loft_jet b[3];

    const enum loft_status status = loft_zheng_ball_lift(b1, b2, at);
    if (status != LOFT_OK)
        return status;
    b[0] = loft_jet_of(loft_sci_from_unit(b1));
    b[1] = loft_jet_of(loft_sci_from_unit(b2));
    b[0].x = b[1].y = loft_sci_one();
    const loft_jet sum = loft_jet_add(&b[0], &b[1]);
    b[2] = jet_from(1, &sum);
    for (unsigned i = 1; i < 3; i++)
        if (loft_sci_less(at[largest], at[i]))
            largest = i;
    const loft_jet t = lift_jet(b, loft_sci_div(at[largest], b[largest].f));
    for (unsigned i = 0; i < 3; i++) {
        u[i] = loft_jet_mul(&t, &b[i]);
        u[i].f = at[i];
    }
    return LOFT_OK;
}

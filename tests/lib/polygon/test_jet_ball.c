/* tests/lib/polygon/test_jet_ball.c -- properties of lib/polygon/jet_ball.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include "polygon/jet_ball.h"
#include "polygon/jet_ball_sum.h"
#include "support/arb.h"
#include "support/exact_sci.h"      /* exact_sci */

static loft_sci arb_sci(arb *a, long double most)
{
    return loft_sci_from_real(LOFT_REAL((double)most * ((int)arb_below(a, 2001) - 1000) / 1000));
}

static loft_jet arb_jet(arb *a, long double most)
{
    const loft_jet r = { arb_sci(a, most), arb_sci(a, most), arb_sci(a, most),
                         arb_sci(a, most), arb_sci(a, most), arb_sci(a, most) };
    return r;
}

static loft_jet size_of(loft_jet j)
{
    const loft_jet r = { loft_sci_abs(j.f),  loft_sci_abs(j.x),  loft_sci_abs(j.y),
                         loft_sci_abs(j.xx), loft_sci_abs(j.xy), loft_sci_abs(j.yy) };
    return r;
}

static loft_jet_ball arb_ball(arb *a)
{
    const loft_jet_ball r = { arb_jet(a, 4), size_of(arb_jet(a, 0.5L)) };
    return r;
}

static loft_sci member(arb *a, loft_sci mid, loft_sci off)
{
    return loft_sci_add(mid, loft_sci_mul(off, arb_sci(a, 1)));
}

static loft_jet arb_in(arb *a, const loft_jet_ball *b)
{
    const loft_jet *m = &b->mid, *o = &b->off;
    const loft_jet r = {
        member(a, m->f, o->f),   member(a, m->x, o->x),   member(a, m->y, o->y),
        member(a, m->xx, o->xx), member(a, m->xy, o->xy), member(a, m->yy, o->yy)
    };
    return r;
}

static void check_in(const loft_jet_ball *b, const loft_jet *j)
{
    const loft_sci mid[6] = { b->mid.f, b->mid.x, b->mid.y, b->mid.xx, b->mid.xy, b->mid.yy },
                   off[6] = { b->off.f, b->off.x, b->off.y, b->off.xx, b->off.xy, b->off.yy },
                   at[6] = { j->f, j->x, j->y, j->xx, j->xy, j->yy };
    const loft_jet most = loft_jet_ball_most(b);

    for (int k = 0; k < 6; k++) {
        const long double slack = 1e-10L * (1 + fabsl(exact_sci(mid[k])) + exact_sci(off[k]));
        CHECK(fabsl(exact_sci(at[k]) - exact_sci(mid[k])) <= exact_sci(off[k]) + slack);
    }
    CHECK_NEAR(exact_sci(most.xy), fabsl(exact_sci(mid[4])) + exact_sci(off[4]), 1e-6);
}

static void sums_products_and_powers_contain_theirs(arb *a)
{
    const loft_jet_ball p = arb_ball(a), q = arb_ball(a);
    const unsigned k = arb_below(a, 5);
    const loft_sci c = arb_sci(a, 3);
    const loft_jet_ball sum = loft_jet_ball_add(&p, &q), left = loft_jet_ball_sub(&p, &q),
                        product = loft_jet_ball_mul(&p, &q), power = loft_jet_ball_pow(&p, k),
                        scaled = loft_jet_ball_scale(&p, c), constant = loft_jet_ball_of(c);

    for (int n = 0; n < 20; n++) {
        const loft_jet x = arb_in(a, &p), y = arb_in(a, &q);
        loft_jet r = loft_jet_add(&x, &y);
        check_in(&sum, &r);
        r = loft_jet_sub(&x, &y);
        check_in(&left, &r);
        r = loft_jet_mul(&x, &y);
        check_in(&product, &r);
        r = loft_jet_pow(&x, k);
        check_in(&power, &r);
        r = loft_jet_scale(&x, c);
        check_in(&scaled, &r);
        r = loft_jet_of(c);
        check_in(&constant, &r);
    }
}

static void quotients_contain_theirs(arb *a)
{
    const loft_jet_ball p = arb_ball(a);
    loft_jet_ball q = arb_ball(a), quotient;

    q.mid.f = loft_sci_add(loft_sci_abs(q.mid.f), loft_sci_one());      /* at least 1/2 */
    CHECK(loft_jet_ball_div(&p, &q, &quotient));
    for (int n = 0; n < 20; n++) {
        const loft_jet x = arb_in(a, &p), y = arb_in(a, &q), r = loft_jet_div(&x, &y);
        check_in(&quotient, &r);
    }
    q.mid.f = q.off.f;
    CHECK(!loft_jet_ball_div(&p, &q, &quotient));
}

static void roots_contain_theirs(arb *a)
{
    loft_jet_ball p = arb_ball(a), root;

    p.mid.f = loft_sci_add(loft_sci_abs(p.mid.f), loft_sci_one());      /* at least 1/2 */
    CHECK(loft_jet_ball_sqrt(&p, &root));
    for (int n = 0; n < 20; n++) {
        const loft_jet x = arb_in(a, &p), r = loft_jet_sqrt(&x);
        check_in(&root, &r);
    }
    p.mid.f = p.off.f;
    CHECK(!loft_jet_ball_sqrt(&p, &root));
}

/* As small as it can be for a product of constants. */
static void ranges_of_values_are_near(arb *a)
{
    loft_jet_ball p = loft_jet_ball_of(loft_sci_from_int(2)),
                  q = loft_jet_ball_of(loft_sci_from_int(3));

    (void)a;
    p.off.f = loft_sci_from_real(LOFT_REAL(0.25));
    q.off.f = loft_sci_from_real(LOFT_REAL(0.5));
    const loft_jet_ball product = loft_jet_ball_mul(&p, &q);
    CHECK_NEAR(exact_sci(product.off.f), 2.25 * 3.5 - 6, 1e-9);
}

/* Points of integers times weights, relative to the first one, and over the sum of the weights. */
static void sums_of_points_contain_theirs(arb *a)
{
    loft_jet_ball weight[3];
    loft_jet_ball_sum sum;
    loft_vec p[3];

    for (int k = 0; k < 3; k++) {
        p[k] = (loft_vec){ { 0 } };
        p[k].axis[0] = loft_real_from_int((int32_t)arb_below(a, 40) - 20);
        weight[k] = arb_ball(a);
        weight[k].mid.f = loft_sci_add(loft_sci_abs(weight[k].mid.f), loft_sci_one());
    }
    loft_jet_ball_sum_start(&sum, p[0]);
    for (int k = 0; k < 3; k++)
        loft_jet_ball_sum_add(&sum, &p[k], &weight[k]);
    loft_jet_ball_sum over = sum;
    CHECK(loft_jet_ball_sum_project(&over));
    for (int n = 0; n < 20; n++) {
        loft_jet x = loft_jet_of(loft_sci_zero()), w = x;
        for (int k = 0; k < 3; k++) {
            const loft_jet j = arb_in(a, &weight[k]);
            const loft_jet term = loft_jet_scale(&j,
                                                 loft_sci_from_real(p[k].axis[0] - p[0].axis[0]));
            x = loft_jet_add(&x, &term);
            w = loft_jet_add(&w, &j);
        }
        check_in(&sum.x[0], &x);
        check_in(&sum.w, &w);
        const loft_jet quotient = loft_jet_div(&x, &w);
        check_in(&over.x[0], &quotient);
    }
}

int main(void)
{
    PROPERTY(sums_products_and_powers_contain_theirs, 100);
    PROPERTY(quotients_contain_theirs, 100);
    PROPERTY(roots_contain_theirs, 100);
    PROPERTY(sums_of_points_contain_theirs, 50);
    PROPERTY(ranges_of_values_are_near, 1);
    return check_failures();
}

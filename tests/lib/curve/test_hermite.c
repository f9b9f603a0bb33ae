/* tests/lib/curve/test_hermite.c -- properties of lib/curve/hermite.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* check_result, quad_of; CHECK, PROPERTY, BY_NUM */
#include "curve/hermite.h"

/* Data of any size, one in eight the extremes; the cubic is the quintic without the last two. */
typedef struct {
    loft_hermite three;
    loft_hermite5 five;
    long double largest;
} sample;

static loft_vec arb_datum(arb *a, int32_t limit, sample *s)
{
    const loft_real top = BY_NUM(INT32_MAX, 32767, 32767),
                    bottom = BY_NUM(INT32_MIN, -32767, -32767);
    const bool extreme = arb_below(a, 8) == 0;
    loft_vec v;

    for (int i = 0; i < LOFT_AXES; i++) {
        v.axis[i] = extreme ? (arb_below(a, 2) ? top : bottom) : arb_real(a, limit);
        s->largest = fmaxl(s->largest, fabsl(exact_of(v.axis[i])));
    }
    return v;
}

static sample arb_sample(arb *a)
{
    const int32_t limit = (int32_t)1 << arb_below(a, 15);
    sample s = { .largest = 0 };

    s.five.p0 = arb_datum(a, limit, &s);
    s.five.p1 = arb_datum(a, limit, &s);
    s.five.t0 = arb_datum(a, limit, &s);
    s.five.t1 = arb_datum(a, limit, &s);
    s.five.a0 = arb_datum(a, limit, &s);
    s.five.a1 = arb_datum(a, limit, &s);
    s.three = (loft_hermite) { s.five.p0, s.five.p1, s.five.t0, s.five.t1 };
    return s;
}

static loft_unit arb_extended(arb *a)
{
    return arb_below(a, 2) ? arb_unit(a) : (loft_unit)(3 * arb_unit(a) - LOFT_UNIT(1));
}

/* The k-th derivative of sum w[j] t^j at t */
static quad power_deriv(const quad w[], int n, unsigned k, quad t)
{
    quad sum = 0;
    for (int j = n; j >= (int)k; j--) {
        quad factor = 1;
        for (int f = j; f > j - (int)k; f--)
            factor *= f;
        sum = sum * t + factor * w[j];
    }
    return sum;
}

/* In powers of t, the usual solution of the boundary conditions. */
static quad exact3(const loft_hermite *h, unsigned k, quad t, int i)
{
    const quad p0 = quad_of(h->p0.axis[i]), p1 = quad_of(h->p1.axis[i]),
               t0 = quad_of(h->t0.axis[i]), t1 = quad_of(h->t1.axis[i]);
    const quad w[4] = { p0, t0, 3 * (p1 - p0) - 2 * t0 - t1, 2 * (p0 - p1) + t0 + t1 };
    return power_deriv(w, 3, k, t);
}

static quad exact5(const loft_hermite5 *h, unsigned k, quad t, int i)
{
    const quad p0 = quad_of(h->p0.axis[i]), d = quad_of(h->p1.axis[i]) - p0,
               t0 = quad_of(h->t0.axis[i]), t1 = quad_of(h->t1.axis[i]);
    const quad a0 = quad_of(h->a0.axis[i]), a1 = quad_of(h->a1.axis[i]);
    const quad w[6] = { p0,
                        t0,
                        a0 / 2,
                        10 * d - 6 * t0 - 4 * t1 - (3 * a0 - a1) / 2,
                        -15 * d + 8 * t0 + 7 * t1 + (3 * a0 - 2 * a1) / 2,
                        6 * d - 3 * (t0 + t1) - (a0 - a1) / 2 };
    return power_deriv(w, 5, k, t);
}

static void check_deriv(const sample *s, unsigned n, unsigned k, loft_unit t)
{
    const long double x = exact_unit(t), l = growth(x);
    const unsigned m = k > n ? 0 : n - k;
    long double factor = 1;
    quad want[LOFT_AXES];
    loft_vec v = { { 0 } };

    for (unsigned j = m + 1; j <= n; j++)
        factor *= j;
    for (int i = 0; i < LOFT_AXES; i++)
        want[i] = n == 3 ? exact3(&s->three, k, (quad)x, i) : exact5(&s->five, k, (quad)x, i);
    const enum loft_status status = n == 3 ? loft_hermite_deriv(&s->three, k, t, &v)
                                           : loft_hermite5_deriv(&s->five, k, t, &v);
    const long double steps = k == 0 ? powl(l, n) + growth_sum(x, n) : growth_sum(x, m);
    const long double ulps = k == 0 ? (6 * n + 4) * powl(l, n)
                                    : 3 * n * powl(2, n) * powl(l, m) * factor;
    check_result(status, &v, want, 0.5L + steps / 131072,
                 bound_by_num(0, ulp(s->largest) / 2, ulps * ulp(s->largest)));
}

static void points_and_derivatives_are_within_their_bound(arb *a)
{
    const sample s = arb_sample(a);
    const loft_unit t = arb_extended(a);

    for (unsigned k = 0; k <= 4; k++)
        check_deriv(&s, 3, k, t);
    for (unsigned k = 0; k <= 6; k++)
        check_deriv(&s, 5, k, t);
}

/* Exactly, except for the second derivatives of the cubic, which are not given. */
static void the_ends_have_what_was_given(arb *a)
{
    const sample s = arb_sample(a);
    const loft_hermite5 *h = &s.five;
    const loft_vec want[2][3] = { { h->p0, h->t0, h->a0 }, { h->p1, h->t1, h->a1 } };
    const long double error[3] = { 0, 0, BY_NUM(0, 1, 96 * ulp(s.largest)) };

    for (unsigned end = 0; end < 2; end++)
        for (unsigned k = 0; k < 3; k++) {
            const loft_unit t = end ? LOFT_UNIT(1) : 0;
            loft_vec three = { { 0 } }, five = { { 0 } };
            CHECK(loft_hermite5_deriv(h, k, t, &five) == LOFT_OK);
            if (k < 2)
                CHECK(loft_hermite_deriv(&s.three, k, t, &three) == LOFT_OK &&
                      loft_vec_equal(three, want[end][k]));
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_EXACT(exact_of(five.axis[i]), exact_of(want[end][k].axis[i]), error[k]);
        }
}

static loft_vec opposite(loft_vec v)
{
    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = v.axis[i] > -LOFT_REAL_MAX ? -v.axis[i] : LOFT_REAL_MAX;
    return v;
}

/* Reversed, first derivatives change their sign. */
static void a_reversed_curve_is_the_same_curve(arb *a)
{
    const sample s = arb_sample(a);
    const loft_hermite three = { s.three.p1, s.three.p0, opposite(s.three.t1),
                                 opposite(s.three.t0) };
    const loft_unit t = arb_unit(a);
    loft_vec one = { { 0 } }, two = { { 0 } };

    const enum loft_status there = loft_hermite_eval(&s.three, t, &one),
                           back = loft_hermite_eval(&three, LOFT_UNIT(1) - t, &two);
    if (there != LOFT_OK || back != LOFT_OK)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(one.axis[i]), exact_of(two.axis[i]),
                    bound_by_num(LSB, 2 * ulp(2 * s.largest), 50 * ulp(s.largest)));
}

/* Translated by whole LSB, in q16 it is the same curve bit for bit. */
static void a_moved_curve_is_the_curve_moved(arb *a)
{
    loft_hermite5 h = arb_sample(a).five;
    const loft_unit t = arb_unit(a);
    const loft_vec by = arb_vec(a, 100);
    loft_vec one = { { 0 } }, two = { { 0 } };

    h.p0 = arb_vec(a, 8000);
    h.p1 = arb_vec(a, 8000);
    if (loft_hermite5_eval(&h, t, &one) != LOFT_OK)
        return;
    h.p0 = loft_vec_add(h.p0, by);
    h.p1 = loft_vec_add(h.p1, by);
    if (loft_hermite5_eval(&h, t, &two) != LOFT_OK)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(one.axis[i]) + exact_of(by.axis[i]), exact_of(two.axis[i]),
                    bound_by_num(0, 4, 100) * ulp(65536));
}

static void check_points(enum loft_status status, const loft_vec p[], const quad want[],
                         unsigned count, int axis, long double largest)
{
    for (unsigned k = 0; k < count && status == LOFT_OK; k++) {
        const long double half = ulp((long double)want[k]) / 2;
        CHECK_EXACT((long double)(quad_of(p[k].axis[axis]) - want[k]), 0,
                    bound_by_num((0.5L + 1 / 131072.0L) * LSB, half + ulp(largest) / 2,
                                 half + 3 * ulp(largest)));
    }
}

static void control_points_are_within_their_bound_or_refused(arb *a)
{
    const sample s = arb_sample(a);
    loft_cubic c = { { { { 0 } } } };
    loft_vec q[6] = { { { 0 } } };

    const enum loft_status three = loft_cubic_from_hermite(&s.three, &c),
                           five = loft_bezier_from_hermite5(&s.five, q);
    for (int i = 0; i < LOFT_AXES; i++) {
        const quad p0 = quad_of(s.five.p0.axis[i]), p1 = quad_of(s.five.p1.axis[i]),
                   t0 = quad_of(s.five.t0.axis[i]), t1 = quad_of(s.five.t1.axis[i]);
        const quad a0 = quad_of(s.five.a0.axis[i]), a1 = quad_of(s.five.a1.axis[i]);
        const quad want3[4] = { p0, p0 + t0 / 3, p1 - t1 / 3, p1 };
        const quad want5[6] = {
            p0, p0 + t0 / 5, p0 + (8 * t0 + a0) / 20, p1 - (8 * t1 - a1) / 20, p1 - t1 / 5, p1
        };
        check_points(three, c.p, want3, 4, i, s.largest);
        check_points(five, q, want5, 6, i, s.largest);
    }
    CHECK(s.largest > 16000 || (three == LOFT_OK && five == LOFT_OK));
    CHECK(three == LOFT_OK || three == LOFT_ERR_RANGE);
    CHECK(five == LOFT_OK || five == LOFT_ERR_RANGE);
}

static void what_does_not_fit_is_refused(arb *a)
{
    const loft_vec far = opposite(opposite((loft_vec){ { LOFT_REAL_MAX } })), zero = { { 0 } },
                   back = opposite(far);
    const loft_hermite h = { far, far, far, back };
    const loft_hermite5 h5 = { far, far, far, back, zero, zero };
    const loft_vec before = arb_vec(a, 100);
    loft_vec v = before, q[6];
    loft_cubic c;

    CHECK(loft_hermite_eval(&h, LOFT_UNIT(0.5), &v) == LOFT_ERR_RANGE &&
          loft_hermite_deriv(&h, 2, LOFT_UNIT(2), &v) == LOFT_ERR_RANGE);
    CHECK(loft_hermite5_eval(&h5, LOFT_UNIT(0.5), &v) == LOFT_ERR_RANGE);
    CHECK(loft_cubic_from_hermite(&h, &c) == LOFT_ERR_RANGE &&
          loft_bezier_from_hermite5(&h5, q) == LOFT_ERR_RANGE);
    CHECK(loft_hermite_eval(&h, LOFT_UNIT(2.01), &v) == LOFT_ERR_ARG &&
          loft_hermite_eval(&h, LOFT_UNIT(-1.01), &v) == LOFT_ERR_ARG);
    CHECK(loft_hermite5_deriv(&h5, 1, LOFT_UNIT(3), &v) == LOFT_ERR_ARG &&
          loft_hermite_eval(&h, BY_NUM(LOFT_UNIT(99), NAN, NAN), &v) == LOFT_ERR_ARG);
    CHECK(loft_vec_equal(v, before));
}

int main(void)
{
    PROPERTY(points_and_derivatives_are_within_their_bound, 4000);
    PROPERTY(the_ends_have_what_was_given,                  3000);
    PROPERTY(a_reversed_curve_is_the_same_curve,            3000);
    PROPERTY(a_moved_curve_is_the_curve_moved,              3000);
    PROPERTY(control_points_are_within_their_bound_or_refused, 3000);
    PROPERTY(what_does_not_fit_is_refused,                    10);
    return check_failures();
}

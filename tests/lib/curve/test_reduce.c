/* tests/lib/curve/test_reduce.c -- properties of lib/curve/reduce.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* quad_of, bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "curve/reduce.h"

#define MOST (LOFT_DEGREE_MAX + 1)

static void raise_once(quad c[], unsigned n)
{
    c[n + 1] = c[n];
    for (unsigned i = n; i > 0; i--)
        c[i] = (i * c[i - 1] + (n + 1 - i) * c[i]) / (n + 1);
}

/* A curve of a low degree, raised where that is exact: it has that degree, and its points. */
static void raised_curves_come_back(arb *a)
{
    const unsigned low = arb_below(a, 5), n = low + arb_below(a, 5);
    loft_vec p[MOST], q[MOST];
    quad c[LOFT_AXES][MOST];
    unsigned degree = 99, want = 0;
    loft_bezier b;

    for (int i = 0; i < LOFT_AXES; i++)     /* powers of x with whole coefficients, over 5040 / 2 */
        for (unsigned k = 0; k <= n; k++) {
            int64_t sum = 0;
            for (unsigned j = 0; j <= low && j <= k; j++) {
                const int64_t power = ((int64_t)((i + 2) * (int)j * 37 + 11) % 17 - 8) * 2520;
                sum += power * loft_binomial(k, j) / loft_binomial(n, j);
            }
            p[k].axis[i] = loft_real_from_raw((int32_t)sum);
        }
    for (unsigned j = 0; j <= low; j++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (((i + 2) * (int)j * 37 + 11) % 17 != 8)
                want = j;
    for (unsigned j = 1; j <= low; j++)     /* was every quotient whole? */
        if (2520 % loft_binomial(n, j))
            return;
    CHECK(loft_bezier_init(&b, p, n) == LOFT_OK);
    CHECK(loft_bezier_exact_degree(&b, &degree, q) == LOFT_OK);
    CHECK(degree == want);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k <= degree; k++)
            c[i][k] = quad_of(q[k].axis[i]);
        for (unsigned m = degree; m < n; m++)
            raise_once(c[i], m);
        for (unsigned k = 0; k <= n; k++)
            CHECK_EXACT((long double)(c[i][k] - quad_of(p[k].axis[i])), 0,
                        bound_by_num(0.51L * LSB, 1e-6L, 1e-11L));
    }
    if (n > 0) {
        p[n].axis[0] = loft_real_from_raw(loft_raw_from_real(p[n].axis[0]) + 1);
        CHECK(loft_bezier_exact_degree(&b, &degree, q) == LOFT_OK && degree == n);
    }
}

static long double distance_sum(const loft_bezier *b, const loft_vec q[], unsigned m)
{
    long double sum = 0;

    for (int j = 0; j <= 200; j++)
        for (int i = 0; i < LOFT_AXES; i++) {
            long double c[2][MOST];
            for (unsigned k = 0; k <= b->degree; k++)
                c[0][k] = exact_of(b->p[k].axis[i]);
            for (unsigned k = 0; k <= m; k++)
                c[1][k] = exact_of(q[k].axis[i]);
            const long double d = exact_eval(c[0], b->degree, j / 200.0L) -
                                  exact_eval(c[1], m, j / 200.0L);
            sum += d * d * (j % 200 ? 1 : 0.5L);
        }
    return sum;
}

/* No other control points do better, and the curve stays within the bound. */
static void reduced_curves_are_nearest_and_within_their_bound(arb *a)
{
    const unsigned n = 2 + arb_below(a, LOFT_DEGREE_MAX - 1), times = 1 + arb_below(a, n - 1),
                   m = n - times;
    loft_vec p[MOST], q[MOST], other[MOST];
    loft_acc bound = 0;
    loft_bezier b, low;

    for (unsigned k = 0; k <= n; k++)
        p[k] = arb_vec(a, 100);
    CHECK(loft_bezier_init(&b, p, n) == LOFT_OK);
    CHECK(loft_bezier_reduce(&b, times, q, &bound) == LOFT_OK);
    CHECK(loft_vec_equal(q[0], p[0]) && loft_vec_equal(q[m], p[n]));
    CHECK(loft_bezier_init(&low, q, m) == LOFT_OK);
    for (int j = 0; j <= 20; j++) {
        long double square = 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            long double c[2][MOST];
            for (unsigned k = 0; k <= n; k++)
                c[0][k] = exact_of(p[k].axis[i]);
            for (unsigned k = 0; k <= m; k++)
                c[1][k] = exact_of(q[k].axis[i]);
            square += powl(exact_eval(c[0], n, j / 20.0L) - exact_eval(c[1], m, j / 20.0L), 2);
        }
        CHECK(sqrtl(square) <= exact_acc(bound));
    }
    if (m < 2)
        return;
    for (unsigned k = 0; k <= m; k++)
        other[k] = q[k];
    other[1 + arb_below(a, m - 1)].axis[arb_below(a, LOFT_AXES)] += LOFT_REAL(2);
    CHECK(distance_sum(&b, q, m) <= distance_sum(&b, other, m));
}

/* Curves of a few LSB anywhere: every coefficient of the difference is within the bound. */
static void bounds_hold_far_from_the_origin(arb *a)
{
    const unsigned n = 2 + arb_below(a, LOFT_DEGREE_MAX - 1), times = 1 + arb_below(a, n - 1),
                   m = n - times;
    loft_vec p[MOST], q[MOST];
    int32_t start[LOFT_AXES];
    quad square[MOST] = { 0 }, largest = 0;
    loft_acc bound = 0;
    loft_bezier b;

    for (int i = 0; i < LOFT_AXES; i++)
        start[i] = arb_raw(a, 30000 * 65536) / 2;
    for (unsigned k = 0; k <= n; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = loft_real_from_raw(start[i] + (int32_t)arb_below(a, 9));
    CHECK(loft_bezier_init(&b, p, n) == LOFT_OK);
    CHECK(loft_bezier_reduce(&b, times, q, &bound) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        quad c[MOST];
        for (unsigned k = 0; k <= m; k++)
            c[k] = quad_of(q[k].axis[i]);
        for (unsigned k = m; k < n; k++)
            raise_once(c, k);
        for (unsigned k = 0; k <= n; k++) {
            const quad d = c[k] - quad_of(p[k].axis[i]);
            square[k] += d * d;
        }
    }
    for (unsigned k = 0; k <= n; k++)
        largest = square[k] > largest ? square[k] : largest;
    const long double length = (long double)quad_sqrt(largest);
    CHECK(length <= exact_acc(bound));
    CHECK(exact_acc(bound) <= length + bound_by_num(4 * LSB, 16 * ulp(16000), 1e-9L));
}

/* Nothing is lost where nothing need be. */
static void reducing_a_raised_curve_gives_it_back(arb *a)
{
    const unsigned n = 1 + arb_below(a, 5), times = 1 + arb_below(a, LOFT_DEGREE_MAX - n);
    loft_vec p[MOST], raised[MOST], q[MOST];
    loft_acc bound = 0;
    loft_bezier b, high;

    for (unsigned k = 0; k <= n; k++)
        p[k] = arb_vec(a, 10000);
    CHECK(loft_bezier_init(&b, p, n) == LOFT_OK &&
          loft_bezier_elevate(&b, times, raised) == LOFT_OK &&
          loft_bezier_init(&high, raised, n + times) == LOFT_OK &&
          loft_bezier_reduce(&high, times, q, &bound) == LOFT_OK);
    /* raising rounds by 1/2 LSB, which lowering multiplies */
    for (unsigned k = 0; k <= n; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(exact_of(q[k].axis[i]), exact_of(p[k].axis[i]),
                        bound_by_num(64 * LSB, 64 * ulp(10000), 1e-7L));
    CHECK_EXACT(exact_acc(bound), 0, bound_by_num(64 * LSB, 64 * ulp(10000), 1e-7L));
}

static void mistakes_are_refused(arb *a)
{
    loft_vec p[3] = { arb_vec(a, 10), arb_vec(a, 10), arb_vec(a, 10) }, q[3];
    loft_acc bound;
    loft_bezier b;

    CHECK(loft_bezier_init(&b, p, 2) == LOFT_OK);
    CHECK(loft_bezier_reduce(&b, 0, q, &bound) == LOFT_ERR_ARG &&
          loft_bezier_reduce(&b, 2, q, &bound) == LOFT_ERR_ARG);
}

/* A parabola whose middle point is beyond all coordinates, though the cubic's points are not. */
static void points_that_do_not_fit_are_refused(arb *a)
{
    const int32_t middle = 30000 + (int32_t)arb_below(a, 15000), third = 2 * middle / 3;
    const int axis = (int)arb_below(a, LOFT_AXES);
    loft_vec p[4] = { { { 0 } }, { { 0 } }, { { 0 } }, { { 0 } } }, q[4];
    unsigned degree = 7;
    loft_bezier b;

    p[1].axis[axis] = p[2].axis[axis] = arb_below(a, 2) ? loft_real_from_int(third)
                                                        : loft_real_from_int(-third);
    CHECK(loft_bezier_init(&b, p, 3) == LOFT_OK);
    const bool fits = BY_NUM(3 * third < 2 * 32768, true, true);
    CHECK(loft_bezier_exact_degree(&b, &degree, q) == (fits ? LOFT_OK : LOFT_ERR_RANGE));
    CHECK(degree == (fits ? 2 : 7));
}

int main(void)
{
    PROPERTY(raised_curves_come_back,                           2000);
    PROPERTY(reduced_curves_are_nearest_and_within_their_bound,  300);
    PROPERTY(bounds_hold_far_from_the_origin,                    500);
    PROPERTY(reducing_a_raised_curve_gives_it_back,              300);
    PROPERTY(mistakes_are_refused,                                20);
    PROPERTY(points_that_do_not_fit_are_refused,                 200);
    return check_failures();
}

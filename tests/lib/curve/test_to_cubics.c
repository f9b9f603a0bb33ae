/* tests/lib/curve/test_to_cubics.c -- properties of lib/curve/to_cubics.h
 * SPDX-License-Identifier: MIT
 */
#include "support/rationals.h"          /* arb_rational, exact_eval, ulp */
#include "curve/to_cubics.h"

#define COUNT_MAX 200000
#define SAMPLES   24

typedef struct {
    sample *of;
    loft_vec p[POINTS];
    loft_to_cubics s;
    bool rational;
    long double tol, least;
} chain;

static loft_real real_near(long double x)
{
    return (loft_real)BY_NUM((int32_t)ceill(x * 65536), (float)x, (double)x);
}

/* The smallest tolerance of the header, or slightly more. */
static long double least_of(const chain *c)
{
    const long double by_num[3] = { c->rational ? 4 * LSB : 2 * LSB,
                                    c->of->largest * (c->rational ? 0x1p-21L : 0x1p-22L),
                                    c->of->largest * 0x1p-39L };
    const long double least = by_num[BY_NUM(0, 1, 2)];
    return least > 0 ? least : LSB;
}

/* A curve with or without weights, and a tolerance of `times` the smallest. */
static chain *start(sample *of, bool rational, long double times)
{
    static chain c;
    loft_bezier b;

    c.of = of;
    c.rational = rational;
    for (unsigned k = 0; k <= of->n; k++) {
        c.p[k] = of->p[k].p;
        if (!rational) {
            of->p[k].w = LOFT_REAL(1);
            for (int i = 0; i < LOFT_AXES; i++)
                of->x[i][k] = exact_of(c.p[k].axis[i]);
            of->w[k] = of->ratio = 1;
        }
    }
    c.least = least_of(&c);
    const loft_real tol = real_near(c.least * times);
    c.tol = exact_of(tol);
    if (rational) {
        CHECK(loft_rational_to_cubics_init(&c.s, &of->r, tol) == LOFT_OK);
    } else {
        CHECK(loft_bezier_init(&b, c.p, of->n) == LOFT_OK);
        CHECK(loft_to_cubics_init(&c.s, &b, tol) == LOFT_OK);
    }
    return &c;
}

static long double start_of(const loft_to_cubics *s)
{
    return s->more ? ldexpl((long double)s->piece.k, -s->piece.level) : 1;
}

/* The distance of the cubic at u from the curve at t. */
static long double apart(const chain *c, const loft_cubic *q, long double u, long double t)
{
    long double sum = 0, x[4];

    for (int i = 0; i < LOFT_AXES; i++) {
        for (int k = 0; k < 4; k++)
            x[k] = exact_of(q->p[k].axis[i]);
        const long double d = exact_eval(x, 3, u) - rational_at(c->of, i, t, 1);
        sum += d * d;
    }
    return sqrtl(sum);
}

static unsigned all_within(chain *c)
{
    unsigned count = 0;
    loft_cubic q;

    for (long double from = 0, to; loft_to_cubics_next(&c->s, &q); from = to, count++) {
        to = start_of(&c->s);
        for (int j = 0; j <= SAMPLES && !check_bad; j++)
            CHECK_EXACT(apart(c, &q, j / (long double)SAMPLES, from + (to - from) * j / SAMPLES), 0,
                        c->tol);
        if (count > COUNT_MAX || check_bad)
            break;
    }
    CHECK(count >= 1 && count <= COUNT_MAX);
    return count;
}

static void every_point_is_within_the_tolerance(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const bool rational = arb_below(a, 3) > 0;

    all_within(start(s, rational, ldexpl(1, (int)arb_below(a, 16) + 2)));
}

static void even_with_the_least_tolerance(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);

    all_within(start(s, arb_below(a, 3) > 0, 1));
}

/* The sharpest turn possible: all of the curve except its start is in the first 2^-16 of the
 * parameter. */
static void weights_of_1_to_65536_are_resolved(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const bool from_the_end = arb_below(a, 2), light = arb_below(a, 4) > 0;

    while (s->n < 2)
        s = arb_rational(a, LOFT_DEGREE_MAX);
    for (unsigned k = 0; k <= s->n; k++)
        s->p[k].w = (k == (from_the_end ? s->n : 0)) == light ? LOFT_WEIGHT_MIN : LOFT_WEIGHT_MAX;
    CHECK(loft_rational_init(&s->r, s->p, s->n) == LOFT_OK);
    measure(s);
    all_within(start(s, true, 1 + arb_below(a, 64)));
}

static void ends_are_the_curve_s_and_joints_are_the_same_point(arb *a)
{
    chain *c = start(arb_rational(a, LOFT_DEGREE_MAX), arb_below(a, 2),
                     ldexpl(1, (int)arb_below(a, 20)));
    const loft_vec last = c->of->p[c->of->n].p;
    loft_vec at = c->of->p[0].p;
    loft_cubic q;

    while (loft_to_cubics_next(&c->s, &q)) {
        CHECK(loft_vec_equal(q.p[0], at));
        at = q.p[3];
    }
    CHECK(loft_vec_equal(at, last));
    CHECK(!loft_to_cubics_next(&c->s, &q) && loft_vec_equal(q.p[3], last));
}

/* A third of the derivative at t, with respect to a parameter that runs h times as fast. */
static long double third_at(const sample *s, int axis, long double t, long double h)
{
    const long double w = exact_eval(s->w, s->n, t), p = exact_eval(s->x[axis], s->n, t) / w;
    return h * (exact_deriv(s->x[axis], s->n, 1, t) - p * exact_deriv(s->w, s->n, 1, t)) / w / 3;
}

static void arms_are_the_curve_s_derivatives(arb *a)
{
    chain *c = start(arb_rational(a, LOFT_DEGREE_MAX), arb_below(a, 2),
                     ldexpl(1, (int)arb_below(a, 20)));
    const long double largest = c->of->largest,
                      by_num[3] = { LSB / 2 + c->of->ratio * LSB * 0x1p-18L, 2 * ulp(2 * largest),
                                    2000 * ulp(largest) };
    loft_cubic q;

    for (long double from = 0, to; loft_to_cubics_next(&c->s, &q) && !check_bad; from = to) {
        to = start_of(&c->s);
        for (int i = 0; i < LOFT_AXES; i++) {
            const long double first = rational_at(c->of, i, from, 1) +
                                      third_at(c->of, i, from, to - from);
            const long double second = rational_at(c->of, i, to, 1) -
                                       third_at(c->of, i, to, to - from);
            const long double edge = BY_NUM(
                fabsl(first) > 32767.9L || fabsl(second) > 32767.9L ? 2 * LSB : 0, 0, 0);
            const long double bound = by_num[BY_NUM(0, 1, 2)] + edge + largest * 0x1p-58L;
            CHECK_EXACT(exact_of(q.p[1].axis[i]), first, bound);
            CHECK_EXACT(exact_of(q.p[2].axis[i]), second, bound);
        }
    }
}

static void a_polynomial_to_degree_3_is_one_cubic(arb *a)
{
    chain *c = start(arb_rational(a, 3), false, 1);
    loft_cubic q;

    CHECK(loft_to_cubics_next(&c->s, &q));
    for (unsigned k = 0; k < 4 && c->of->n == 3; k++)
        CHECK(loft_vec_equal(q.p[k], c->p[k]));
    CHECK(!loft_to_cubics_next(&c->s, &q));
}

/* Errors fall with the fourth power. */
static void sixteen_times_the_accuracy_doubles_the_number(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    unsigned count[2];

    for (unsigned k = 0; k <= s->n; k++) {
        s->p[k].w = arb_below(a, 2) ? LOFT_REAL(1) : LOFT_REAL(2);
        for (int i = 0; i < LOFT_AXES; i++)
            s->p[k].p.axis[i] = arb_real(a, 1000);
    }
    CHECK(loft_rational_init(&s->r, s->p, s->n) == LOFT_OK);
    measure(s);
    for (int j = 0; j < 2; j++) {
        chain *c = start(s, true, 100 * BY_NUM(1, 1, 4096) * (j ? 1 : 16));
        loft_cubic q;
        for (count[j] = 0; loft_to_cubics_next(&c->s, &q); count[j]++)
            continue;
    }
    CHECK(count[0] <= count[1] && count[1] <= 3 * count[0]);
}

static void bad_tolerances_and_coordinates_are_refused(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const double least = (double)start(s, true, 1)->least;
    loft_vec p[2] = { s->p[0].p, s->p[s->n].p };
    loft_bezier b;
    loft_to_cubics q;

    CHECK(loft_rational_to_cubics_init(&q, &s->r, 0) == LOFT_ERR_ARG);
    CHECK(loft_rational_to_cubics_init(&q, &s->r, -LOFT_REAL(1)) == LOFT_ERR_ARG);
    CHECK(!(s->largest > 0) ||
          loft_rational_to_cubics_init(&q, &s->r,
                                       (loft_real)(least * BY_NUM(65536 * 3 / 4.0, 0.5, 0.99))) ==
              LOFT_ERR_RANGE);
    CHECK(loft_bezier_init(&b, p, 1) == LOFT_OK);
    CHECK(loft_to_cubics_init(&q, &b, 0) == LOFT_ERR_ARG);
    CHECK(loft_to_cubics_init(&q, &b, BY_NUM(1, LOFT_REAL(1e-30), LOFT_REAL(1e-30))) ==
          (BY_NUM(true, s->largest > 1e-20L, s->largest > 1e-20L) ? LOFT_ERR_RANGE : LOFT_OK));
    p[1].axis[0] = BY_NUM(0, (loft_real)INFINITY, (loft_real)INFINITY);
    CHECK(BY_NUM(true, loft_to_cubics_init(&q, &b, 1) == LOFT_ERR_RANGE,
                 loft_to_cubics_init(&q, &b, 1) == LOFT_ERR_RANGE));
}

int main(void)
{
    PROPERTY(every_point_is_within_the_tolerance, BY_NUM(400, 400, 100));
    PROPERTY(even_with_the_least_tolerance, BY_NUM(40, 40, 8));
    PROPERTY(weights_of_1_to_65536_are_resolved, BY_NUM(40, 40, 4));
    PROPERTY(ends_are_the_curve_s_and_joints_are_the_same_point, BY_NUM(300, 300, 60));
    PROPERTY(arms_are_the_curve_s_derivatives, BY_NUM(200, 200, 30));
    PROPERTY(a_polynomial_to_degree_3_is_one_cubic, 300);
    PROPERTY(sixteen_times_the_accuracy_doubles_the_number, 100);
    PROPERTY(bad_tolerances_and_coordinates_are_refused, 200);
    return check_failures();
}

/* tests/lib/curve/test_rational.c -- properties of lib/curve/rational.h
 * SPDX-License-Identifier: MIT
 */
#include "support/rationals.h"          /* arb_rational, exact_eval, ulp */

/* Errors of the reference itself: 2^-60 of a coordinate. */
#define REFERENCE (32768 * 0x1p-58L)

static long double point_bound(const sample *s, unsigned rows, long double want)
{
    const long double by_num[3] = { LSB / 2 + rows * s->ratio * LSB / 1073741824 + REFERENCE,
                                    ulp(want) / 2 + ulp(s->largest) / 2,
                                    (6 * rows + 4) * ulp(s->largest) };
    return by_num[BY_NUM(0, 1, 2)];
}

static void check_point(const sample *s, loft_vec v, unsigned rows, const long double want[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), want[i], point_bound(s, rows, want[i]));
}

static void a_point_is_within_its_bound(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit t = arb_unit(a);
    long double want[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        want[i] = rational_at(s, i, exact_unit(t), 1);
    check_point(s, loft_rational_eval(&s->r, t), s->n, want);
}

/* In f64 the product with the weight is rounded, and so is the quotient by it. */
static void the_ends_are_exact_and_beyond_is_clamped(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_vec first = loft_rational_eval(&s->r, 0),
                   last = loft_rational_eval(&s->r, LOFT_UNIT(1));

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double start = exact_of(s->p[0].p.axis[i]), end = exact_of(s->p[s->n].p.axis[i]);
        CHECK_EXACT(exact_of(first.axis[i]), start, BY_NUM(0, 0, ulp(start)));
        CHECK_EXACT(exact_of(last.axis[i]), end, BY_NUM(0, 0, ulp(end)));
    }
    CHECK(loft_vec_equal(loft_rational_eval(&s->r, LOFT_UNIT(-3)), loft_rational_eval(&s->r, 0)));
    CHECK(loft_vec_equal(loft_rational_eval(&s->r, LOFT_UNIT(100)),
                         loft_rational_eval(&s->r, LOFT_UNIT(1))));
}

static void equal_weights_give_the_polynomial(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit t = arb_unit(a);
    loft_vec p[POINTS];
    loft_bezier b;

    for (unsigned k = 0; k <= s->n; k++) {
        p[k] = s->p[k].p;
        s->p[k].w = s->p[0].w;
    }
    CHECK(loft_bezier_init(&b, p, s->n) == LOFT_OK &&
          loft_rational_init(&s->r, s->p, s->n) == LOFT_OK);
    const loft_vec v = loft_rational_eval(&s->r, t), want = loft_bezier_eval(&b, t);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(want.axis[i]),
                    BY_NUM(1, 1, 9 * s->n + 4) * ulp(s->largest));
}

static void a_common_factor_of_the_weights_changes_nothing(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit t = arb_unit(a);
    const loft_vec v = loft_rational_eval(&s->r, t);

    for (unsigned k = 0; k <= s->n; k++)
        if (s->p[k].w > LOFT_WEIGHT_MAX / 2)
            return;
    for (unsigned k = 0; k <= s->n; k++)
        s->p[k].w *= 2;
    CHECK(loft_rational_init(&s->r, s->p, s->n) == LOFT_OK);
    CHECK(loft_vec_equal(loft_rational_eval(&s->r, t), v));
}

static void the_reversed_curve_is_the_same(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit t = arb_unit(a);
    long double want[LOFT_AXES];
    loft_weighted back[POINTS];
    loft_rational r;

    for (unsigned k = 0; k <= s->n; k++)
        back[k] = s->p[s->n - k];
    CHECK(loft_rational_init(&r, back, s->n) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        want[i] = rational_at(s, i, exact_unit(t), 1);
    check_point(s, loft_rational_eval(&r, LOFT_UNIT(1) - t), s->n, want);
}

/* 1: fits, 0: does not, -1: too close to decide */
static int fits(long double want)
{
    const long double over = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX),
                      under = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
    return want < over - LSB && want > under + LSB   ? 1
           : want > over + LSB || want < under - LSB ? 0
                                                     : -1;
}

static void a_derivative_is_within_its_bound_or_refused(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const unsigned n = s->n;
    const loft_unit t = arb_unit(a);
    const long double x = exact_unit(t);
    long double want[LOFT_AXES] = { 0 }, factor = 0;
    bool all = true, none = true;
    loft_vec v;

    for (int i = 0; i < LOFT_AXES && n; i++) {
        const long double w0 = exact_eval(s->w, n - 1, x), w1 = exact_eval(s->w + 1, n - 1, x),
                          w = (1 - x) * w0 + x * w1;
        factor = n * w0 * w1 / (w * w);
        want[i] = factor *
                  (exact_eval(s->x[i] + 1, n - 1, x) / w1 - exact_eval(s->x[i], n - 1, x) / w0);
        all  = all && fits(want[i]) == 1;
        none = none && fits(want[i]) != 0;
    }
    const enum loft_status status = loft_rational_deriv(&s->r, t, &v);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !all));
    CHECK(status != LOFT_OK || none);
    CHECK(factor <= n * s->ratio * 1.000001L);
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        const long double floats = ulp(want[i]) / 2 + 24 * n * factor * ulp_double(s->largest);
        const long double bound[2] = { 0.501L * LSB + factor * REFERENCE, floats };
        CHECK_EXACT(exact_of(v.axis[i]), want[i], bound[BY_NUM(0, 1, 1)]);
    }
}

/* The blossom at `from` (n - k times) and `to` (k times) of the curve as a point and a weight. */
static long double blossom_of(const sample *s, unsigned k, long double from, long double to,
                              long double want[])
{
    long double at[POINTS];

    for (unsigned j = 0; j < s->n; j++)
        at[j] = j < s->n - k ? from : to;
    const long double w = exact_blossom(s->w, s->n, at);
    for (int i = 0; i < LOFT_AXES; i++)
        want[i] = exact_blossom(s->x[i], s->n, at) / w;
    return w;
}

static long double weight_bound(const sample *s, unsigned roundings, long double want)
{
    const long double by_num[3] = { LSB / 2 + roundings * LSB / 131072,
                                    ulp(want) / 2 + ulp_double(256) * 40,
                                    4 * roundings * ulp(256) };
    (void)s;
    return by_num[BY_NUM(0, 1, 2)] + 1e-15L;
}

static void check_piece(const sample *s, const loft_weighted out[], long double from,
                        long double to, long double factor)
{
    for (unsigned k = 0; k <= s->n; k++) {
        long double want[LOFT_AXES];
        const long double w = factor * blossom_of(s, k, from, to, want);
        check_point(s, out[k].p, s->n, want);
        CHECK_EXACT(exact_of(out[k].w), w, weight_bound(s, s->n, w));
        CHECK(out[k].w >= LOFT_WEIGHT_MIN && out[k].w <= LOFT_WEIGHT_MAX);
    }
}

static void both_pieces_of_a_split_are_within_their_bound(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit t = arb_unit(a);
    loft_weighted left[POINTS], right[POINTS];

    CHECK(loft_rational_split(&s->r, t, left, right) == LOFT_OK);
    check_piece(s, left, 0, exact_unit(t), 1);
    check_piece(s, right, exact_unit(t), 1, 1);
    CHECK(loft_vec_equal(left[s->n].p, right[0].p));
}

static void a_part_is_within_its_bound_in_both_directions(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit from = arb_unit(a), to = arb_unit(a);
    loft_weighted out[POINTS];
    long double most = 0, largest = 0, point[LOFT_AXES];

    CHECK(loft_rational_sub(&s->r, from, to, out) == LOFT_OK);
    for (unsigned k = 0; k <= s->n; k++) {
        most = fmaxl(most, exact_of(out[k].w));
        largest = fmaxl(largest, blossom_of(s, k, exact_unit(from), exact_unit(to), point));
    }
    CHECK(most > 127.9L);
    check_piece(s, out, exact_unit(from), exact_unit(to), exp2l(roundl(log2l(most / largest))));
}

/* The promise of loft_rational_sub: how its rounded weights change the curve. */
static void a_piece_is_the_same_curve(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX), piece = *s;
    const loft_unit t = arb_unit(a);
    loft_weighted out[POINTS];
    long double want[LOFT_AXES];

    CHECK(loft_rational_sub(&s->r, 0, LOFT_UNIT(1), out) == LOFT_OK);
    CHECK(loft_rational_init(&piece.r, out, s->n) == LOFT_OK);
    const loft_vec v = loft_rational_eval(&piece.r, t);
    for (int i = 0; i < LOFT_AXES; i++) {
        want[i] = rational_at(s, i, exact_unit(t), 1);
        CHECK_EXACT(exact_of(v.axis[i]), want[i],
                    2 * point_bound(s, s->n, want[i]) +
                        BY_NUM(s->ratio * 2 * s->largest * 0x1p-25L, 0, 0));
    }
}

static void an_elevated_curve_is_within_its_bound(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const unsigned times = arb_below(a, LOFT_ELEVATE_MAX - s->n + 1), top = s->n + times;
    loft_weighted out[LOFT_ELEVATE_MAX + 1];

    CHECK(loft_rational_elevate(&s->r, times, out) == LOFT_OK);
    for (unsigned k = 0; k <= top; k++) {
        long double w = 0, want[LOFT_AXES] = { 0 };
        for (unsigned j = 0; j <= s->n && j <= k; j++) {
            const long double part = k - j <= times
                                         ? (long double)loft_binomial(s->n, j) *
                                               loft_binomial(times, k - j) / loft_binomial(top, k)
                                         : 0;
            w += part * s->w[j];
            for (int i = 0; i < LOFT_AXES; i++)
                want[i] += part * s->x[i][j];
        }
        for (int i = 0; i < LOFT_AXES; i++)
            want[i] /= w;
        check_point(s, out[k].p, times, want);
        CHECK_EXACT(exact_of(out[k].w), w, weight_bound(s, times, w));
    }
}

static void the_box_holds_the_curve(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_box box = loft_rational_box(&s->r);
    const loft_vec v = loft_rational_eval(&s->r, arb_unit(a));

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double slack = BY_NUM(0, 1, 6 * s->n + 4) * ulp(s->largest);
        bool touches_min = false, touches_max = false;
        for (unsigned k = 0; k <= s->n; k++) {
            touches_min = touches_min || !(s->p[k].p.axis[i] > box.min.axis[i]);
            touches_max = touches_max || !(s->p[k].p.axis[i] < box.max.axis[i]);
        }
        CHECK(touches_min && touches_max);
        CHECK(exact_of(v.axis[i]) >= exact_of(box.min.axis[i]) - slack &&
              exact_of(v.axis[i]) <= exact_of(box.max.axis[i]) + slack);
    }
}

static bool same(const loft_weighted p[], const loft_weighted q[], unsigned count)
{
    bool all = true;

    for (unsigned k = 0; k < count; k++)
        all = all && loft_vec_equal(p[k].p, q[k].p) && !(p[k].w < q[k].w) && !(p[k].w > q[k].w);
    return all;
}

static void results_may_replace_the_control_points(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit t = arb_unit(a);
    loft_weighted left[POINTS], right[POINTS], part[POINTS], elevated[LOFT_ELEVATE_MAX + 1],
        p[LOFT_ELEVATE_MAX + 1], other[POINTS];
    loft_rational r = s->r;

    r.p = p;
    CHECK(loft_rational_split(&s->r, t, left, right) == LOFT_OK &&
          loft_rational_sub(&s->r, t, 0, part) == LOFT_OK);
    CHECK(loft_rational_elevate(&s->r, 2, elevated) == LOFT_OK);
    for (int way = 0; way < 4; way++) {
        for (unsigned k = 0; k <= s->n; k++)
            p[k] = s->p[k];
        CHECK((way == 0   ? loft_rational_split(&r, t, p, other)
               : way == 1 ? loft_rational_split(&r, t, other, p)
               : way == 2 ? loft_rational_sub(&r, t, 0, p)
                          : loft_rational_elevate(&r, 2, p)) == LOFT_OK);
        CHECK(same(p,
                   way == 0   ? left
                   : way == 1 ? right
                   : way == 2 ? part
                              : elevated,
                   s->n + 1 + (way == 3 ? 2 : 0)));
    }
}

static void nonsense_is_refused(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    loft_weighted out[2 * POINTS], other[POINTS];
    loft_rational r = { .degree = 77 };
    loft_vec v = { { 0 } };
    const unsigned k = arb_below(a, s->n + 1);
    const loft_weighted good = s->p[k];
    const loft_real step = BY_NUM(1, (loft_real)0x1p-16, (loft_real)0x1p-44);

    CHECK(loft_rational_init(&r, s->p, LOFT_DEGREE_MAX + 1) == LOFT_ERR_ARG);
    const loft_real bad[4] = { 0, -LOFT_WEIGHT_MIN, LOFT_WEIGHT_MIN - step,
                               LOFT_WEIGHT_MAX + 16 * step * BY_NUM(1, 16, 16) };
    for (int i = 0; i < 4; i++) {
        s->p[k].w = bad[i];
        CHECK(loft_rational_init(&r, s->p, s->n) == LOFT_ERR_RANGE);
    }
    s->p[k] = good;
    for (int i = 0; i < 2 && BY_NUM(false, true, true); i++) {
        s->p[k].w = (loft_real)BY_NUM(0, i ? NAN : 1, i ? NAN : 1);
        s->p[k].p.axis[0] = (loft_real)BY_NUM(0, i ? 0 : INFINITY, i ? 0 : INFINITY);
        CHECK(loft_rational_init(&r, s->p, s->n) == LOFT_ERR_RANGE);
        s->p[k] = good;
    }
    CHECK(r.degree == 77);
    for (int i = 0; i < 2; i++) {
        const loft_unit t = i ? LOFT_UNIT(2) + LOFT_UNIT(0.0000002)
                              : LOFT_UNIT(-1) - LOFT_UNIT(0.0000002);
        CHECK(loft_rational_split(&s->r, t, out, other) == LOFT_ERR_ARG);
        CHECK(loft_rational_sub(&s->r, t, 0, out) == LOFT_ERR_ARG &&
              loft_rational_sub(&s->r, 0, t, out) == LOFT_ERR_ARG);
        CHECK(loft_rational_deriv(&s->r, t, &v) == LOFT_ERR_ARG &&
              loft_rational_extrapolate(&s->r, t, &v) == LOFT_ERR_ARG);
    }
    CHECK(loft_rational_elevate(&s->r, LOFT_ELEVATE_MAX - s->n + 1, out) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound,                       4000);
    PROPERTY(the_ends_are_exact_and_beyond_is_clamped,          1000);
    PROPERTY(equal_weights_give_the_polynomial,                 1000);
    PROPERTY(a_common_factor_of_the_weights_changes_nothing,    1000);
    PROPERTY(the_reversed_curve_is_the_same,                    1000);
    PROPERTY(a_derivative_is_within_its_bound_or_refused,       2000);
    PROPERTY(both_pieces_of_a_split_are_within_their_bound,     1000);
    PROPERTY(a_part_is_within_its_bound_in_both_directions,     1000);
    PROPERTY(a_piece_is_the_same_curve,                         1000);
    PROPERTY(an_elevated_curve_is_within_its_bound,             1000);
    PROPERTY(the_box_holds_the_curve,                           1000);
    PROPERTY(results_may_replace_the_control_points,             500);
    PROPERTY(nonsense_is_refused,                                300);
    return check_failures();
}

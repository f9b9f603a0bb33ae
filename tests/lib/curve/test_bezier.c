/* tests/lib/curve/test_bezier.c -- properties of lib/curve/bezier.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"          /* CHECK, PROPERTY, BY_NUM */
#include "support/exact.h"  /* exact_eval, growth, ulp */
#include "curve/bezier.h"

#define POINTS (LOFT_DEGREE_MAX + 1)

typedef struct {
    loft_vec p[POINTS];
    unsigned n;
    loft_bezier b;
    long double c[LOFT_AXES][POINTS], largest;
} sample;

/* A curve of any degree. One in four consists of the extremes of the number type, one in eight in
 * the worst order. */
static sample *arb_curve(arb *a)
{
    static sample s;
    const loft_real top = BY_NUM(INT32_MAX, 32767, 32767),
                    bottom = BY_NUM(INT32_MIN, -32767, -32767);
    const uint32_t kind = arb_below(a, 8), limit = (uint32_t)1 << arb_below(a, 15);

    s.n = arb_below(a, POINTS);
    for (unsigned k = 0; k <= s.n; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            s.p[k].axis[i] = kind == 0   ? (k & 1 ? top : bottom)
                             : kind == 1 ? (arb_below(a, 2) ? top : bottom)
                                         : arb_real(a, (int32_t)limit);
    CHECK(loft_bezier_init(&s.b, s.p, s.n) == LOFT_OK);
    s.largest = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k <= s.n; k++) {
            s.c[i][k] = exact_of(s.p[k].axis[i]);
            s.largest = fmaxl(s.largest, fabsl(s.c[i][k]));
        }
    return &s;
}

static loft_unit arb_extended(arb *a)
{
    static const double edge[4] = { -1, 0, 1, 2 };
    if (arb_below(a, 4) == 0)
        return (loft_unit)LOFT_UNIT(edge[arb_below(a, 4)]);
    return (loft_unit)(3 * arb_unit(a) - LOFT_UNIT(1));
}

static long double factorial(unsigned n)
{
    long double f = 1;
    for (unsigned k = 2; k <= n; k++)
        f *= k;
    return f;
}

/* The error bound of a value whose guard error is `steps` (q16: in 2^-33, floats: in f64
 * roundings). */
static long double bound_of(const sample *s, long double want, long double q16_steps,
                            long double f64_ulps)
{
    const long double by_num[3] = { LSB / 2 + q16_steps * LSB / 131072 + 1e-12L,
        ulp(want) / 2 + ulp(s->largest) / 2,
                                    ulp(want) / 2 + ulp(s->largest) * f64_ulps };
    return by_num[BY_NUM(0, 1, 2)];
}

/* Does it fit the type? 1 or 0 by more than an LSB, -1 if it is too close to decide. */
static int fits(long double want)
{
    const long double over = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX),
                      under = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
    return want < over - LSB && want > under + LSB   ? 1
           : want > over + LSB || want < under - LSB ? 0
                                                     : -1;
}

static void a_point_is_within_its_bound(arb *a)
{
    const sample *s = arb_curve(a);
    const loft_unit t = arb_unit(a);
    const loft_vec v = loft_bezier_eval(&s->b, t);

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_eval(s->c[i], s->n, exact_unit(t));
        CHECK_EXACT(
            exact_of(v.axis[i]), want,
            BY_NUM(LSB / 2 + s->n * LSB / 131072, ulp(s->largest), 3 * s->n * ulp(s->largest)));
    }
}

static void the_ends_are_exact_and_beyond_is_clamped(arb *a)
{
    const sample *s = arb_curve(a);

    CHECK(loft_vec_equal(loft_bezier_eval(&s->b, 0), s->p[0]));
    CHECK(loft_vec_equal(loft_bezier_eval(&s->b, LOFT_UNIT(1)), s->p[s->n]));
    CHECK(loft_vec_equal(loft_bezier_eval(&s->b, LOFT_UNIT(-3)), s->p[0]));
    CHECK(loft_vec_equal(loft_bezier_eval(&s->b, LOFT_UNIT(100)), s->p[s->n]));
}

static void beyond_the_ends_the_law_of_extrapolation_holds(arb *a)
{
    const sample *s = arb_curve(a);
    const loft_unit t = arb_extended(a);
    const long double x = exact_unit(t);
    bool all = true, none = true;
    loft_vec v;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int f = fits(exact_eval(s->c[i], s->n, x));
        all  = all && f == 1;
        none = none && f != 0;
    }
    const enum loft_status status = loft_bezier_extrapolate(&s->b, t, &v);
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    CHECK(status == LOFT_OK || !all);
    CHECK(status != LOFT_OK || none);
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        const long double want = exact_eval(s->c[i], s->n, x);
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    bound_of(s, want, growth_sum(x, s->n), 3 * s->n * powl(growth(x), s->n)));
    }
}

static void a_derivative_is_within_its_bound_or_refused(arb *a)
{
    const sample *s = arb_curve(a);
    const unsigned k = arb_below(a, s->n + 2), m = k > s->n ? 0 : s->n - k;
    const loft_unit t = arb_below(a, 2) ? arb_unit(a) : arb_extended(a);
    const long double x = exact_unit(t), factor = k > s->n ? 0 : factorial(s->n) / factorial(m);
    bool all = true, none = true;
    loft_vec v;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int f = fits(exact_deriv(s->c[i], s->n, k, x));
        all  = all && (f == 1);
        none = none && f != 0;
    }
    const enum loft_status status = loft_bezier_deriv(&s->b, k, t, &v);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !(all && factor < 1000)));
    CHECK(status != LOFT_OK || none || factor > 1000);
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        const long double want = exact_deriv(s->c[i], s->n, k, x);
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    bound_of(s, want, factor * growth_sum(x, m),
                             factor * powl(2, k) * powl(growth(x), m) * (3 * m + k + 1)));
    }
}

static void check_points(const sample *s, const loft_vec out[], unsigned count,
                         const long double from, const long double to)
{
    for (unsigned k = 0; k < count; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            long double at[POINTS];
            for (unsigned j = 0; j < s->n; j++)
                at[j] = j < s->n - k ? from : to;
            const long double want = exact_blossom(s->c[i], s->n, at);
            const long double l = fmaxl(growth(from), growth(to)),
                              x = growth(from) > growth(to) ? from : to;
            CHECK_EXACT(exact_of(out[k].axis[i]), want,
                        bound_of(s, want, growth_sum(x, s->n), 3 * s->n * powl(l, s->n)));
        }
}

/* 1: every blossom value of the piece fits, 0: one does not, -1: too close to decide */
static int piece_fits(const sample *s, long double from, long double to)
{
    int worst = 1;
    for (unsigned k = 0; k <= s->n; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            long double at[POINTS];
            for (unsigned j = 0; j < s->n; j++)
                at[j] = j < s->n - k ? from : to;
            const int f = fits(exact_blossom(s->c[i], s->n, at));
            if (f == 0)
                return 0;
            if (f < worst)
                worst = f;
        }
    return worst;
}

static void both_pieces_of_a_split_are_within_their_bound(arb *a)
{
    const sample *s = arb_curve(a);
    const loft_unit t = arb_below(a, 2) ? arb_unit(a) : arb_extended(a);
    const long double x = exact_unit(t);
    const int left_fits = piece_fits(s, 0, x), right_fits = piece_fits(s, x, 1);
    loft_vec left[POINTS], right[POINTS];

    const enum loft_status status = loft_bezier_split(&s->b, t, left, right);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !(left_fits == 1 && right_fits == 1)));
    CHECK(status != LOFT_OK || (left_fits && right_fits));
    if (status != LOFT_OK)
        return;
    check_points(s, left, s->n + 1, 0, x);
    check_points(s, right, s->n + 1, x, 1);
    CHECK(loft_vec_equal(left[s->n], right[0]));
}

static void a_part_is_within_its_bound_in_both_directions(arb *a)
{
    const sample *s = arb_curve(a);
    const bool inside = arb_below(a, 2);
    const loft_unit from = inside ? arb_unit(a) : arb_extended(a),
                    to = inside ? arb_unit(a) : arb_extended(a);
    const int fit = piece_fits(s, exact_unit(from), exact_unit(to));
    loft_vec there[POINTS], back[POINTS];

    const enum loft_status status = loft_bezier_sub(&s->b, from, to, there);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && fit != 1));
    CHECK(status != LOFT_OK || fit);
    if (status != LOFT_OK)
        return;
    check_points(s, there, s->n + 1, exact_unit(from), exact_unit(to));
    if (loft_bezier_sub(&s->b, to, from, back) == LOFT_OK)
        check_points(s, back, s->n + 1, exact_unit(to), exact_unit(from));
    CHECK(loft_bezier_sub(&s->b, 0, LOFT_UNIT(1), there) == LOFT_OK);
    for (unsigned k = 0; k <= s->n; k++)
        CHECK(loft_vec_equal(there[k], s->p[k]));
}

/* The bound of this number type; all three are evaluated, so none is left unused. */
static long double bound_by(long double q16, long double f32, long double f64)
{
    const long double bound[3] = { q16, f32, f64 };
    return bound[BY_NUM(0, 1, 2)];
}

static void an_elevated_curve_is_within_its_bound(arb *a)
{
    const sample *s = arb_curve(a);
    const unsigned r = arb_below(a, LOFT_BEZIER_ELEVATE_MAX - s->n + 1);
    loft_vec out[LOFT_BEZIER_ELEVATE_MAX + 1];

    CHECK(loft_bezier_elevate(&s->b, r, out) == LOFT_OK);
    const long double beyond = s->n + r > LOFT_ELEVATE_MAX ? s->n + r - LOFT_ELEVATE_MAX : 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        long double c[LOFT_BEZIER_ELEVATE_MAX + 1];
        for (unsigned k = 0; k <= s->n; k++)
            c[k] = s->c[i][k];
        for (unsigned m = s->n; m < s->n + r; m++) {        /* one degree at a time */
            c[m+1] = c[m];
            for (unsigned k = m; k > 0; k--)
                c[k] = ((long double)k * c[k-1] + (long double)(m + 1 - k) * c[k]) / (m + 1);
        }
        for (unsigned k = 0; k <= s->n + r; k++)
            CHECK_EXACT(exact_of(out[k].axis[i]), c[k],
                        bound_by(LSB / 2 + (1 + beyond) * LSB / 131072 + 1e-12L, ulp(s->largest),
                                 (s->n + 3 + 4 * beyond) * ulp(s->largest)));
    }
    CHECK(loft_vec_equal(out[0], s->p[0]));
    CHECK(loft_vec_equal(out[s->n + r], s->p[s->n]));
}

/* Small enough for every coefficient: both conversions, and back to the original. */
static void power_form_is_exact_and_returns(arb *a)
{
    const sample *s = arb_curve(a);
    loft_vec c[POINTS], p[POINTS];
    bool all = true, none = true;

    long double want[LOFT_AXES][POINTS];
    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k <= s->n; k++) {
            want[i][k] = exact_deriv(s->c[i], s->n, k, 0) / factorial(k);
            all  = all && fits(want[i][k]) == 1;
            none = none && fits(want[i][k]) != 0;
        }
    const enum loft_status status = loft_bezier_power(&s->b, c);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !all));
    CHECK(status != LOFT_OK || none);
    if (status != LOFT_OK)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k <= s->n; k++)
            CHECK_EXACT(exact_of(c[k].axis[i]), want[i][k],
                        BY_NUM(0, ulp(want[i][k]) / 2 + ulp(s->largest) / 2,
                               (k + 1) * powl(2, k) * loft_binomial(s->n, k) * ulp(s->largest)));

    const enum loft_status returned = loft_bezier_from_power(c, s->n, p);
    CHECK(returned == LOFT_OK);
    for (unsigned k = 0; k <= s->n && returned == LOFT_OK && BY_NUM(true, false, false); k++)
        CHECK(loft_vec_equal(p[k], s->p[k]));
}

static void points_from_power_coefficients_are_within_their_bound(arb *a)
{
    const sample *s = arb_curve(a);                         /* its points serve as coefficients */
    loft_vec p[POINTS];
    bool all = true, none = true;
    long double want[LOFT_AXES][POINTS];

    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned j = 0; j <= s->n; j++) {
            want[i][j] = 0;
            for (unsigned k = 0; k <= j; k++)
                want[i][j] += s->c[i][k] * (long double)loft_binomial(j, k) /
                              (long double)loft_binomial(s->n, k);
            all  = all && fits(want[i][j]) == 1;
            none = none && fits(want[i][j]) != 0;
        }
    const enum loft_status status = loft_bezier_from_power(s->p, s->n, p);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !all));
    CHECK(status != LOFT_OK || none);
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++)
        for (unsigned j = 0; j <= s->n; j++)
            CHECK_EXACT(exact_of(p[j].axis[i]), want[i][j],
                        bound_of(s, want[i][j], j, (j + 1) * (j + 2)));
}

/* The sums of the edges may leave the range by a factor of ten. */
static void edges_hold_the_bound_though_their_sums_overflow(arb *a)
{
    sample *s = arb_curve(a);
    const loft_unit t = arb_below(a, 2) ? arb_unit(a) : arb_extended(a);
    const bool outside = t < 0 || t > LOFT_UNIT(1);
    const long double x = exact_unit(t);
    bool all = true, none = true;
    loft_vec v;

    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 1; k <= s->n; k++) {
            s->c[i][k] += s->c[i][k-1];
            s->largest = fmaxl(s->largest, fabsl(s->c[i][k]));
            if (outside && s->n > 7 && fits(s->c[i][k]) != 1)
                all = false;
        }
        const int f = fits(exact_eval(s->c[i], s->n, x));
        all  = all && f == 1;
        none = none && f != 0;
    }
    const enum loft_status status = loft_bezier_from_edges(s->p, s->n, t, &v);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !all));
    CHECK(status != LOFT_OK || none);
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        const long double want = exact_eval(s->c[i], s->n, x);
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    bound_of(s, want, growth_sum(x, s->n), 4 * s->n * powl(growth(x), s->n)));
    }
}

static void the_box_holds_the_curve(arb *a)
{
    const sample *s = arb_curve(a);
    const loft_box box = loft_bezier_box(&s->b);
    const loft_vec v = loft_bezier_eval(&s->b, arb_unit(a));

    for (int i = 0; i < LOFT_AXES; i++) {
        bool touches_min = false, touches_max = false;
        for (unsigned k = 0; k <= s->n; k++) {
            CHECK(s->p[k].axis[i] >= box.min.axis[i] && s->p[k].axis[i] <= box.max.axis[i]);
            touches_min = touches_min || !(s->p[k].axis[i] > box.min.axis[i]);
            touches_max = touches_max || !(s->p[k].axis[i] < box.max.axis[i]);
        }
        CHECK(touches_min && touches_max);
        const long double slack = BY_NUM(0, 1, 3 * s->n) * ulp(s->largest);
        CHECK(exact_of(v.axis[i]) >= exact_of(box.min.axis[i]) - slack);
        CHECK(exact_of(v.axis[i]) <= exact_of(box.max.axis[i]) + slack);
    }
}

static void results_may_replace_the_control_points(arb *a)
{
    const sample *s = arb_curve(a);
    loft_vec p[LOFT_BEZIER_ELEVATE_MAX + 1], left[POINTS], right[POINTS],
        elevated[LOFT_BEZIER_ELEVATE_MAX + 1], other[POINTS];
    const loft_unit t = arb_unit(a);
    const loft_bezier b = { p, (uint8_t)s->n };

    for (int way = 0; way < 4; way++) {
        for (unsigned k = 0; k <= s->n; k++)
            p[k] = s->p[k];
        CHECK(loft_bezier_split(&s->b, t, left, right) == LOFT_OK);
        CHECK(loft_bezier_elevate(&s->b, 2, elevated) == LOFT_OK);
        CHECK((way == 0   ? loft_bezier_split(&b, t, p, other)
               : way == 1 ? loft_bezier_split(&b, t, other, p)
               : way == 2 ? loft_bezier_sub(&b, t, LOFT_UNIT(1), p)
                          : loft_bezier_elevate(&b, 2, p)) == LOFT_OK);
        const loft_vec *want = way == 0 ? left : way == 3 ? elevated : right;
        for (unsigned k = 0;
             k <= s->n + (way == 3 ? 2u : 0u) && (way != 2 || BY_NUM(true, true, false)); k++)
            CHECK(loft_vec_equal(p[k], want[k]));
    }
}


/* Cubics */

static sample *arb_cubic_curve(arb *a, loft_cubic *c)
{
    sample *s;
    do
        s = arb_curve(a);
    while (s->n != 3);
    for (int k = 0; k < 4; k++)
        c->p[k] = s->p[k];
    return s;
}

static void a_cubic_point_is_within_its_bound(arb *a)
{
    loft_cubic c;
    const sample *s = arb_cubic_curve(a, &c);
    const loft_unit t = arb_unit(a);
    const loft_vec v = loft_cubic_eval(&c, t);

    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_eval(s->c[i], 3, exact_unit(t)),
                    BY_NUM(LSB / 2 + LSB / 32768, ulp(s->largest), 16 * ulp(s->largest)));
    CHECK(loft_vec_equal(loft_cubic_eval(&c, LOFT_UNIT(-1)), c.p[0]));
    CHECK(loft_vec_equal(loft_cubic_eval(&c, 0), c.p[0]));
    CHECK(loft_vec_equal(loft_cubic_eval(&c, LOFT_UNIT(1)), c.p[3]));
    CHECK(loft_vec_equal(loft_cubic_eval(&c, LOFT_UNIT(2)), c.p[3]));
}

/* Inner points are the thirds, rounded once, so each point of it is on the line within as much. */
static void a_line_is_run_through_evenly(arb *a)
{
    const loft_vec from = arb_vec(a, 32000), to = arb_vec(a, 32000);
    const loft_cubic line = loft_cubic_line(from, to);

    CHECK(loft_vec_equal(line.p[0], from) && loft_vec_equal(line.p[3], to));
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 1; k < 3; k++) {
            const long double p = exact_of(from.axis[i]), d = exact_of(to.axis[i]) - p;
            CHECK_NEAR(exact_of(line.p[k].axis[i]), p + d * k / 3,
                       BY_NUM(0x1.0001p-17L, ulp(32000) / 2, 4 * ulp(32000)));
        }
}

static void a_cubic_derivative_is_within_its_bound(arb *a)
{
    loft_cubic c;
    const sample *s = arb_cubic_curve(a, &c);
    const loft_unit t = arb_unit(a);
    const unsigned k = arb_below(a, 6);
    const long double q16_steps = k == 0 ? 4 : k < 3 ? 3 - k : 0;
    const long double double_ulps = k > 3 ? 0 : powl(2, k + 6) * ulp_double(s->largest);
    loft_acc d[LOFT_AXES];

    loft_cubic_deriv(&c, k, t, d);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_acc(d[i]), exact_deriv(s->c[i], 3, k, exact_unit(t)),
                    BY_NUM(true, false, false) ? q16_steps / 8589934592.0L + 1e-14L : double_ulps);
}

static void a_cubic_piece_is_within_its_bound(arb *a)
{
    loft_cubic c, left, right;
    const sample *s = arb_cubic_curve(a, &c);
    const loft_unit from = arb_unit(a), to = arb_unit(a);
    const loft_cubic piece = loft_cubic_sub(&c, from, to),
                     whole = loft_cubic_sub(&c, LOFT_UNIT(-1), LOFT_UNIT(2));

    check_points(s, piece.p, 4, exact_unit(from), exact_unit(to));
    loft_cubic_split(&c, to, &left, &right);
    check_points(s, left.p, 4, 0, exact_unit(to));
    check_points(s, right.p, 4, exact_unit(to), 1);
    CHECK(loft_vec_equal(left.p[3], right.p[0]));
    for (int k = 0; k < 4; k++)
        CHECK(loft_vec_equal(whole.p[k], c.p[k]));
}

static void mistakes_are_refused_by_name(arb *a)
{
    loft_vec p[POINTS + 1], out[LOFT_BEZIER_ELEVATE_MAX + 2], other[POINTS];
    loft_bezier b = { NULL, 77 };

    for (int k = 0; k <= POINTS; k++)
        p[k] = arb_vec(a, 100);
    CHECK(loft_bezier_init(&b, p, POINTS) == LOFT_ERR_ARG);
    CHECK(b.p == NULL && b.degree == 77);
    const unsigned n = arb_below(a, POINTS);
    CHECK(loft_bezier_init(&b, p, n) == LOFT_OK);
    CHECK(loft_bezier_elevate(&b, LOFT_BEZIER_ELEVATE_MAX - n, out) == LOFT_OK);
    CHECK(loft_bezier_elevate(&b, LOFT_BEZIER_ELEVATE_MAX - n + 1, out) == LOFT_ERR_ARG);
    CHECK(loft_bezier_from_power(p, POINTS, out) == LOFT_ERR_ARG);
    CHECK(loft_bezier_from_edges(p, POINTS, 0, out) == LOFT_ERR_ARG);
    const loft_unit beyond[2] = { LOFT_UNIT(-1.0001), LOFT_UNIT(2.0001) };
    for (int k = 0; k < 2; k++) {
        CHECK(loft_bezier_extrapolate(&b, beyond[k], out) == LOFT_ERR_ARG);
        CHECK(loft_bezier_deriv(&b, 1, beyond[k], out) == LOFT_ERR_ARG);
        CHECK(loft_bezier_split(&b, beyond[k], out, other) == LOFT_ERR_ARG);
        CHECK(loft_bezier_sub(&b, beyond[k], 0, out) == LOFT_ERR_ARG);
        CHECK(loft_bezier_sub(&b, 0, beyond[k], out) == LOFT_ERR_ARG);
        CHECK(loft_bezier_from_edges(p, n, beyond[k], out) == LOFT_ERR_ARG);
    }
    const loft_real bad[3] = { BY_NUM(0, NAN, NAN), BY_NUM(0, INFINITY, INFINITY),
                               BY_NUM(0, -INFINITY, -INFINITY) };
    const unsigned where = arb_below(a, n + 1);
    for (int k = 0; k < BY_NUM(0, 3, 3); k++) {
        loft_bezier c = b;
        p[where].axis[arb_below(a, LOFT_AXES)] = bad[k];
        CHECK(loft_bezier_init(&c, p, n) == LOFT_ERR_RANGE);
        CHECK(loft_bezier_extrapolate(&b, bad[k], out) == LOFT_ERR_ARG);
    }
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound,                           3000);
    PROPERTY(the_ends_are_exact_and_beyond_is_clamped,               500);
    PROPERTY(beyond_the_ends_the_law_of_extrapolation_holds,        3000);
    PROPERTY(a_derivative_is_within_its_bound_or_refused,           3000);
    PROPERTY(both_pieces_of_a_split_are_within_their_bound,         2000);
    PROPERTY(a_part_is_within_its_bound_in_both_directions,         2000);
    PROPERTY(an_elevated_curve_is_within_its_bound,                 2000);
    PROPERTY(power_form_is_exact_and_returns,                       2000);
    PROPERTY(points_from_power_coefficients_are_within_their_bound, 2000);
    PROPERTY(edges_hold_the_bound_though_their_sums_overflow,       3000);
    PROPERTY(the_box_holds_the_curve,                               1000);
    PROPERTY(results_may_replace_the_control_points,                 500);
    PROPERTY(a_cubic_point_is_within_its_bound,                     3000);
    PROPERTY(a_line_is_run_through_evenly,                          2000);
    PROPERTY(a_cubic_derivative_is_within_its_bound,                2000);
    PROPERTY(a_cubic_piece_is_within_its_bound,                     2000);
    PROPERTY(mistakes_are_refused_by_name,                           100);
    return check_failures();
}

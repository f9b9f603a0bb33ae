/* tests/lib/curve/test_nurbs.c -- properties of lib/curve/nurbs.h
 * SPDX-License-Identifier: MIT
 */
#include "support/splines.h"            /* arb_grid, exact_weights */
#include "support/exact_spline.h"       /* quad, quad_of */
#include "curve/bspline.h"
#include "curve/nurbs.h"

#define REFERENCE (32768 * 0x1p-56L)    /* the error of the reference itself */

typedef struct {
    grid g;
    loft_weighted p[POINTS_MOST + 1];
    loft_nurbs n;
    long double largest, width, ratio;
} sample;

static void init(sample *s)
{
    long double least = 256, most = 0, low = 32768, high = -32768;

    CHECK(loft_nurbs_init(&s->n, s->p, s->g.points, s->g.k, s->g.p) == LOFT_OK);
    for (unsigned k = 0; k < s->g.points; k++) {
        least = fminl(least, exact_of(s->p[k].w));
        most = fmaxl(most, exact_of(s->p[k].w));
        for (int i = 0; i < LOFT_AXES; i++) {
            low = fminl(low, exact_of(s->p[k].p.axis[i]));
            high = fmaxl(high, exact_of(s->p[k].p.axis[i]));
        }
    }
    s->largest = fmaxl(fabsl(low), fabsl(high));
    s->width = high - low;
    s->ratio = most / least;
}

/* 1/256..256: equal, alternating extremes, or of any size */
static loft_real arb_weight(arb *a, uint32_t kind, unsigned k)
{
    const double any = (65536 + arb_below(a, 65536)) / 65536.0 * (1 << arb_below(a, 15)) / 128 / 2;

    return kind == 0   ? LOFT_REAL(1)
           : kind == 1 ? (k & 1 ? LOFT_WEIGHT_MAX : LOFT_WEIGHT_MIN)
           : kind == 2 ? (arb_below(a, 2) ? LOFT_WEIGHT_MAX : LOFT_WEIGHT_MIN)
                       : LOFT_REAL(any);
}

static sample *arb_nurbs(arb *a)
{
    static sample s;
    const loft_real high = BY_NUM(INT32_MAX, 32767, 32767), low = BY_NUM(INT32_MIN, -32767, -32767);
    const uint32_t kind = arb_below(a, 8), weights = arb_below(a, 5);
    const int32_t limit = (int32_t)1 << arb_below(a, 15);

    s.g = arb_grid(a);
    for (unsigned k = 0; k < s.g.points; k++) {
        s.p[k].w = arb_weight(a, weights, k);
        for (int i = 0; i < LOFT_AXES; i++)
            s.p[k].p.axis[i] = kind == 0 ? (k & 1 ? high : low) : arb_real(a, limit);
    }
    init(&s);
    return &s;
}

/* The numerator of an axis, or with axis -1 the denominator, of the piece on `span`. */
static long double exact_sum(const sample *s, int axis, unsigned span, long double u)
{
    long double n[KNOTS_MOST], sum = 0;

    exact_weights(&s->g, s->g.p, span, u, n);
    for (unsigned k = 0; k < s->g.points; k++)
        sum += n[k] * exact_of(s->p[k].w) * (axis < 0 ? 1 : exact_of(s->p[k].p.axis[axis]));
    return sum;
}

static long double exact_point(const sample *s, int axis, loft_real u)
{
    const unsigned span = exact_span(&s->g, u);
    return exact_sum(s, axis, span, exact_of(u)) / exact_sum(s, -1, span, exact_of(u));
}

static long double point_bound(const sample *s, unsigned rows, long double want)
{
    const long double by_num[3] = { LSB / 2 + rows * s->ratio * LSB / 1073741824 + REFERENCE,
                                    ulp(want) / 2 + (10 * rows + 4) * ulp_double(s->largest) +
                                        REFERENCE,
                                    (10 * rows + 4) * ulp(s->largest) };
    return by_num[BY_NUM(0, 1, 2)];
}

static void a_point_is_within_its_bound(arb *a)
{
    const sample *s = arb_nurbs(a);
    const loft_real u = arb_u(a, &s->g);
    const loft_vec v = loft_nurbs_eval(&s->n, u);

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_point(s, i, u);
        CHECK_EXACT(exact_of(v.axis[i]), want, point_bound(s, s->g.p, want));
    }
}

static void equal_weights_give_the_polynomial(arb *a)
{
    sample *s = arb_nurbs(a);
    const loft_real u = arb_u(a, &s->g);
    loft_vec p[POINTS_MOST];
    loft_bspline b;

    for (unsigned k = 0; k < s->g.points; k++) {
        p[k] = s->p[k].p;
        s->p[k].w = s->p[0].w;
    }
    init(s);
    CHECK(loft_bspline_init(&b, p, s->g.points, s->g.k, s->g.p) == LOFT_OK);
    const loft_vec v = loft_nurbs_eval(&s->n, u), want = loft_bspline_eval(&b, u);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(want.axis[i]),
                    BY_NUM(1, 1, 15 * s->g.p + 5) * ulp(s->largest));
}

static void a_common_factor_of_the_weights_changes_nothing(arb *a)
{
    sample *s = arb_nurbs(a);
    const loft_real u = arb_u(a, &s->g);
    const loft_vec v = loft_nurbs_eval(&s->n, u);

    for (unsigned k = 0; k < s->g.points; k++)
        if (s->p[k].w > LOFT_WEIGHT_MAX / 2)
            return;
    for (unsigned k = 0; k < s->g.points; k++)
        s->p[k].w *= 2;
    init(s);
    CHECK(loft_vec_equal(loft_nurbs_eval(&s->n, u), v));
}

static void u_is_clamped_and_a_clamped_end_is_its_point(arb *a)
{
    sample *s = arb_nurbs(a);
    const unsigned last = s->g.points + s->g.p;

    CHECK(loft_vec_equal(loft_nurbs_eval(&s->n, BY_NUM(INT32_MIN, -FLT_MAX, -DBL_MAX)),
                         loft_nurbs_eval(&s->n, s->g.k[s->g.p])));
    CHECK(loft_vec_equal(loft_nurbs_eval(&s->n, LOFT_REAL_MAX),
                         loft_nurbs_eval(&s->n, s->g.k[s->g.points])));
    if (s->g.k[0] < s->g.k[s->g.p] || s->g.k[s->g.points] < s->g.k[last])
        return;
    const loft_vec end = loft_nurbs_eval(&s->n, LOFT_REAL_MAX);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_of(s->p[s->g.points - 1].p.axis[i]);
        CHECK_EXACT(exact_of(end.axis[i]), want, BY_NUM(0, 0, ulp(want)));
    }
}

/* 1: fits, 0: does not, -1: too close to decide */
static int fits(long double want, long double slack)
{
    const long double over = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX),
                      under = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
    return want < over - slack && want > under + slack   ? 1
           : want > over + slack || want < under - slack ? 0
                                                         : -1;
}

/* The coefficients of the derivative of a spline on its knots, all of them: p (c_i - c_(i-1)) /
 * (k_(i+p) - k_i). */
static quad slope_sum(const sample *s, int axis, unsigned span, quad u)
{
    const unsigned p = s->g.p;
    quad n[POINTS], sum = 0;

    n[0] = 1;                           /* the B-splines of degree p - 1 of span - p + 1 .. span */
    for (unsigned r = 1; r < p; r++) {
        n[r] = 0;
        for (unsigned i = r; i > 0; i--) {
            const quad lo = quad_of(s->g.k[span + i - r]), hi = quad_of(s->g.k[span + i]),
                       part = (u - lo) / (hi - lo) * n[i - 1];
            n[i] += part;
            n[i - 1] -= part;
        }
    }
    for (unsigned j = 0; j < p; j++) {
        const unsigned i = span - p + 1 + j;
        const quad w1 = quad_of(s->p[i].w), w0 = quad_of(s->p[i - 1].w);
        const quad c1 = axis < 0 ? w1 : w1 * quad_of(s->p[i].p.axis[axis]),
                   c0 = axis < 0 ? w0 : w0 * quad_of(s->p[i - 1].p.axis[axis]);
        sum += n[j] * p * (c1 - c0) / (quad_of(s->g.k[i + p]) - quad_of(s->g.k[i]));
    }
    return sum;
}

/* x and w' as sums over all B-splines, by de Boor's rows. */
static quad value_sum(const sample *s, int axis, unsigned span, quad u)
{
    const unsigned p = s->g.p;
    quad c[POINTS];

    for (unsigned j = 0; j <= p; j++) {
        const loft_weighted *q = &s->p[span - p + j];
        c[j] = quad_of(q->w) * (axis < 0 ? 1 : quad_of(q->p.axis[axis < 0 ? 0 : axis]));
    }
    for (unsigned rows = p; rows > 0; rows--)
        for (unsigned j = 0; j < rows; j++) {
            const quad lo = quad_of(s->g.k[span + 1 + j - rows]),
                       hi = quad_of(s->g.k[span + 1 + j]);
            c[j] += (u - lo) / (hi - lo) * (c[j + 1] - c[j]);
        }
    return c[0];
}

/* (x' w - x w') / w^2, by the derivatives of numerator and denominator: a different method than in
 * lib/. */
static void a_derivative_is_within_its_bound_or_refused(arb *a)
{
    sample *s = arb_nurbs(a);
    const unsigned p = s->g.p;

    if (arb_below(a, 2)) {                          /* small ones, so that more of them fit */
        for (unsigned k = 0; k < s->g.points; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                s->p[k].p.axis[i] = real_of_raw((int64_t)arb_below(a, 2000) - 1000);
        init(s);
    }
    const loft_real u = arb_u(a, &s->g), sign = LOFT_REAL(-3);
    const unsigned span = exact_span(&s->g, u);
    const long double h = exact_of(s->g.k[span + 1]) - exact_of(s->g.k[span]);
    const quad at = quad_of(u), w = value_sum(s, -1, span, at), dw = slope_sum(s, -1, span, at);
    bool all = true, none = true;
    loft_vec v;

    v.axis[0] = sign;
    const enum loft_status status = loft_nurbs_deriv(&s->n, u, &v);
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want =
            (long double)((slope_sum(s, i, span, at) * w - value_sum(s, i, span, at) * dw) /
                          (w * w));
        const long double floats = ulp(want) / 2 +
                                   40 * p * p * s->ratio / h * ulp_double(s->largest);
        const long double bound = bound_by_num((0.51L + 0x1p-17L / h) * LSB, floats, floats);
        all = all && fits(want, bound) == 1;
        none = none && fits(want, bound) != 0;
        if (status == LOFT_OK)
            CHECK_EXACT(exact_of(v.axis[i]), want, bound);
    }
    CHECK(status == LOFT_OK || (!all && v.axis[0] <= sign && v.axis[0] >= sign));
    CHECK(status != LOFT_OK || none);
}

/* Equal weights: the derivative of the B-spline. */
static void equal_weights_give_the_polynomial_derivative(arb *a)
{
    sample *s = arb_nurbs(a);
    const loft_real u = arb_u(a, &s->g);
    const unsigned p = s->g.p, span = exact_span(&s->g, u);
    const long double h = exact_of(s->g.k[span + 1]) - exact_of(s->g.k[span]);
    loft_vec points[POINTS_MOST], v, want;
    loft_bspline b;

    for (unsigned k = 0; k < s->g.points; k++) {
        points[k] = s->p[k].p;
        s->p[k].w = s->p[0].w;
    }
    init(s);
    CHECK(loft_bspline_init(&b, points, s->g.points, s->g.k, p) == LOFT_OK);
    if (loft_nurbs_deriv(&s->n, u, &v) != LOFT_OK || loft_bspline_deriv(&b, 1, u, &want) != LOFT_OK)
        return;
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double x = exact_of(want.axis[i]),
                          floats = ulp(x) + 64 * p * p / h * ulp_double(s->largest);
        CHECK_EXACT(exact_of(v.axis[i]), x,
                    bound_by_num((1.02L + (4 * p * p + 3) * 0x1p-17L / h) * LSB, floats, floats));
    }
}

/* Points and weights of the spans: w p and w, as Bernstein coefficients, are numerator and
 * denominator except for the rounding of points and weights. If points P with weights W are off by
 * dp and dw each, a point of the span is off by dp, and by dw / w of the width twice. */
static void spans_are_the_curve(arb *a)
{
    const sample *s = arb_nurbs(a);
    const unsigned p = s->g.p;
    loft_weighted out[POINTS];
    unsigned count = 0, want = 0;

    for (unsigned i = p; i < s->g.points; i++)
        want += s->g.k[i] < s->g.k[i + 1];
    for (unsigned span = 0; loft_nurbs_next(&s->n, &span, out); count++) {
        const long double lo = exact_of(s->g.k[span]), hi = exact_of(s->g.k[span + 1]);
        long double heaviest = 0, w[POINTS], x[POINTS];
        loft_rational r;
        CHECK(loft_rational_init(&r, out, p) == LOFT_OK);
        for (unsigned k = 0; k <= p; k++)
            heaviest = fmaxl(heaviest, w[k] = exact_of(out[k].w));
        CHECK(heaviest > 127.9L && heaviest <= 256);
        for (unsigned j = 0; j <= 4; j++) {
            const long double t = j / 4.0L, u = lo + (hi - lo) * t;
            for (int i = 0; i < LOFT_AXES; i++) {
                for (unsigned k = 0; k <= p; k++)
                    x[k] = w[k] * exact_of(out[k].p.axis[i]);
                const long double point = exact_sum(s, i, span, u) / exact_sum(s, -1, span, u);
                const long double weights[3] = { s->ratio * 0x1p-25L * s->width,
                                                 2 * ulp(s->largest), 20 * p * ulp(s->largest) };
                CHECK_EXACT(exact_eval(x, p, t) / exact_eval(w, p, t), point,
                            point_bound(s, p, BY_NUM(point, s->largest, point)) +
                                weights[BY_NUM(0, 1, 2)]);
            }
        }
    }
    CHECK(count == want);
}

/* A circle of nine points with a radius of at least 1000: at every u the distance from the centre
 * is the radius. */
static void nine_points_make_a_circle(arb *a)
{
#if LOFT_AXES > 1
    static const int8_t at[9][2] = { { 1, 0 },   { 1, 1 },  { 0, 1 },  { -1, 1 }, { -1, 0 },
                                     { -1, -1 }, { 0, -1 }, { 1, -1 }, { 1, 0 } };
    static const int8_t knot[12] = { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 };
    const int32_t radius = 1 + (int32_t)arb_below(a, 16000);
    const loft_real u = LOFT_REAL(arb_below(a, 4 * 65536 + 1) / 65536.0);
    loft_weighted p[9];
    loft_real k[12];
    loft_nurbs n;

    for (int i = 0; i < 12; i++)
        k[i] = loft_real_from_int(knot[i]);
    for (int i = 0; i < 9; i++) {
        p[i] = (loft_weighted){ { { 0 } },
                                i & 1 ? LOFT_REAL(181.01933598375616625) : LOFT_REAL(256) };
        for (int j = 0; j < 2 && j < LOFT_AXES; j++)
            p[i].p.axis[j] = loft_real_from_int(radius * at[i][j]);
    }
    CHECK(loft_nurbs_init(&n, p, 9, k, 2) == LOFT_OK);
    const loft_vec v = loft_nurbs_eval(&n, u);
    const long double length = hypotl(exact_of(v.axis[0]), exact_of(v.axis[1]));
    const long double weight = 0x1p-17L / 181 / 4, bound[3] = {
        /* 1/4 of the error of the weight, times the distance */
        0.75L * LSB + radius * weight, ulp(radius) * 1.5L, ulp(radius) * 40
    };
    CHECK_EXACT(length, radius, bound[BY_NUM(0, 1, 2)]);
#else
    (void)a;
#endif
}

static void a_rational_bezier_curve_is_a_special_case(arb *a)
{
    sample *s = arb_nurbs(a);
    const unsigned p = s->g.p;
    loft_real k[2 * POINTS];
    loft_weighted out[POINTS];
    loft_nurbs n;
    unsigned span = 0;

    for (unsigned i = 0; i < 2 * p + 2; i++)
        k[i] = i <= p ? LOFT_REAL(-1) : LOFT_REAL(3);
    CHECK(loft_nurbs_init(&n, s->p, p + 1, k, p) == LOFT_OK);
    CHECK(loft_nurbs_next(&n, &span, out) && span == p);
    const long double factor = exact_of(out[0].w) / exact_of(s->p[0].w);
    for (unsigned i = 0; i <= p; i++) {
        CHECK_EXACT(exact_of(out[i].w), factor * exact_of(s->p[i].w), 0);
        for (int j = 0; j < LOFT_AXES; j++)
            CHECK_EXACT(exact_of(out[i].p.axis[j]), exact_of(s->p[i].p.axis[j]),
                        BY_NUM(0, 0, ulp(exact_of(s->p[i].p.axis[j]))));
    }
    CHECK(!loft_nurbs_next(&n, &span, out) && span == 0);
}

/* In q16 the inserted weights of at least 1/256 are rounded by 2^-17. */
static void an_inserted_knot_changes_nothing(arb *a)
{
    sample *s = arb_nurbs(a);
    const sample old = *s;
    const loft_real at = arb_u(a, &s->g), u = arb_u(a, &old.g);
    long double least = 256;

    if (!loft_knots_valid(&s->n.knots, at) || s->g.points == POINTS_MOST) {
        CHECK(s->g.points == POINTS_MOST ||
              loft_nurbs_insert(&s->n, at, s->p, s->g.k) == LOFT_ERR_ARG);
        return;
    }
    CHECK(loft_nurbs_insert(&s->n, at, s->p, s->g.k) == LOFT_OK);
    s->g.points++;
    init(s);
    for (unsigned k = 0; k < s->g.points; k++)
        least = fminl(least, exact_of(s->p[k].w));
    const loft_vec v = loft_nurbs_eval(&s->n, u);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_point(&old, i, u),
                          weights = BY_NUM(0x1p-17L / least, 0x1p-23L, 12 * 0x1p-52L);
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    point_bound(&old, s->g.p, want) +
                        point_bound(&old, 1, BY_NUM(want, old.largest, want)) +
                        weights * old.width);
    }
}

static void bad_input_is_refused_and_nothing_touched(arb *a)
{
    sample *s = arb_nurbs(a);
    const unsigned k = arb_below(a, s->g.points);
    const loft_real bad[4] = { 0, LOFT_REAL(-1), LOFT_REAL(256.001), LOFT_REAL(0.0038) },
                    first = s->g.k[0];
    loft_nurbs n = { NULL, { NULL, 0, 0 }, 5 };

    s->p[k].w = bad[arb_below(a, 4)];
    CHECK(loft_nurbs_init(&n, s->p, s->g.points, s->g.k, s->g.p) == LOFT_ERR_RANGE && n.p == NULL &&
          n.scale == 5);
    s->p[k].w = LOFT_REAL(1);
    s->g.k[0] = s->g.k[s->g.points];
    CHECK(loft_nurbs_init(&n, s->p, s->g.points, s->g.k, s->g.p) == LOFT_ERR_ARG && n.p == NULL &&
          n.scale == 5);
    s->g.k[0] = first;
    CHECK(loft_nurbs_init(&n, s->p, s->g.points, s->g.k, s->g.p) == LOFT_OK);
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound, 5000);
    PROPERTY(equal_weights_give_the_polynomial, 1000);
    PROPERTY(a_common_factor_of_the_weights_changes_nothing, 1000);
    PROPERTY(u_is_clamped_and_a_clamped_end_is_its_point, 1000);
    PROPERTY(a_derivative_is_within_its_bound_or_refused, 4000);
    PROPERTY(equal_weights_give_the_polynomial_derivative, 1000);
    PROPERTY(spans_are_the_curve, 1000);
    PROPERTY(nine_points_make_a_circle, 5000);
    PROPERTY(a_rational_bezier_curve_is_a_special_case, 1000);
    PROPERTY(an_inserted_knot_changes_nothing, 3000);
    PROPERTY(bad_input_is_refused_and_nothing_touched, 300);
    return check_failures();
}

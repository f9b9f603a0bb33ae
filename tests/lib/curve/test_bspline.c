/* tests/lib/curve/test_bspline.c -- properties of lib/curve/bspline.h
 * SPDX-License-Identifier: MIT
 */
#include "support/splines.h"            /* arb_grid, exact_weights */
#include "support/exact_spline.h"       /* quad, quad_of */
#include "curve/bspline.h"

#define REFERENCE (32768 * 0x1p-58L)    /* the error of the reference itself */

typedef struct {
    grid g;
    loft_vec p[POINTS_MOST + 1];
    loft_bspline b;
    long double largest;
} sample;

static void init(sample *s)
{
    CHECK(loft_bspline_init(&s->b, s->p, s->g.points, s->g.k, s->g.p) == LOFT_OK);
    s->largest = 0;
    for (unsigned k = 0; k < s->g.points; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            s->largest = fmaxl(s->largest, fabsl(exact_of(s->p[k].axis[i])));
}

/* Points of any size, or alternating extremes. */
static sample *arb_bspline(arb *a)
{
    static sample s;
    const loft_real high = BY_NUM(INT32_MAX, 32767, 32767), low = BY_NUM(INT32_MIN, -32767, -32767);
    const uint32_t kind = arb_below(a, 8);
    const int32_t limit = (int32_t)1 << arb_below(a, 15);

    s.g = arb_grid(a);
    for (unsigned k = 0; k < s.g.points; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            s.p[k].axis[i] = kind == 0 ? (k & 1 ? high : low) : arb_real(a, limit);
    init(&s);
    return &s;
}

static long double exact_point(const sample *s, int axis, loft_real u)
{
    long double n[KNOTS_MOST], sum = 0;

    exact_weights(&s->g, s->g.p, exact_span(&s->g, u), exact_of(u), n);
    for (unsigned k = 0; k < s->g.points; k++)
        sum += n[k] * exact_of(s->p[k].axis[axis]);
    return sum;
}

static long double point_bound(const sample *s, unsigned rows, long double want)
{
    const long double by_num[3] = { LSB / 2 + rows * LSB / 131072 + REFERENCE,
                                    ulp(want) / 2 + 5 * rows * ulp_double(s->largest) + REFERENCE,
                                    (5 * rows + 1) * ulp(s->largest) };
    return by_num[BY_NUM(0, 1, 2)];
}

static void a_point_is_within_its_bound(arb *a)
{
    const sample *s = arb_bspline(a);
    const loft_real u = arb_u(a, &s->g);
    const loft_vec v = loft_bspline_eval(&s->b, u);

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_point(s, i, u);
        CHECK_EXACT(exact_of(v.axis[i]), want, point_bound(s, s->g.p, want));
    }
}

static void beyond_the_domain_u_is_clamped(arb *a)
{
    const sample *s = arb_bspline(a);
    const loft_real start = s->g.k[s->g.p], end = s->g.k[s->g.points];

    CHECK(loft_vec_equal(loft_bspline_eval(&s->b, BY_NUM(INT32_MIN, -FLT_MAX, -DBL_MAX)),
                         loft_bspline_eval(&s->b, start)));
    CHECK(loft_vec_equal(loft_bspline_eval(&s->b, LOFT_REAL_MAX), loft_bspline_eval(&s->b, end)));
#if LOFT_NUM != LOFT_Q16
    CHECK(
        loft_vec_equal(loft_bspline_eval(&s->b, (loft_real)NAN), loft_bspline_eval(&s->b, start)));
#endif
    bool clamped = true;
    for (unsigned i = 0; i <= s->g.p; i++)
        clamped = clamped && !(s->g.k[i] < start) && !(end < s->g.k[s->g.points + i]);
    if (clamped) {
        CHECK(loft_vec_equal(loft_bspline_eval(&s->b, start), s->p[0]));
        CHECK(loft_vec_equal(loft_bspline_eval(&s->b, end), s->p[s->g.points - 1]));
    }
}

/* The k-th derivative by the control points of the derivative, each on its own knots: a different
 * method than in lib/. It needs 113 bits, since close knots make large differences. */
static quad exact_slope(const sample *s, unsigned k, int axis, unsigned span, quad u)
{
    const unsigned p = s->g.p;
    const loft_real *knots = s->g.k;
    quad c[POINTS];

    for (unsigned j = 0; j <= p; j++)
        c[j] = quad_of(s->p[span - p + j].axis[axis]);
    for (unsigned d = 1; d <= k; d++)
        for (unsigned j = p; j >= d; j--)
            c[j] = (p + 1 - d) * (c[j] - c[j - 1]) /
                   (quad_of(knots[span + j + 1 - d]) - quad_of(knots[span + j - p]));
    for (unsigned rows = p - k; rows > 0; rows--)
        for (unsigned j = p; j > p - rows; j--) {
            const quad lo = quad_of(knots[span + j - p]), hi = quad_of(knots[span + j - p + rows]);
            c[j] = c[j - 1] + (u - lo) / (hi - lo) * (c[j] - c[j - 1]);
        }
    return c[p];
}

static void a_derivative_is_within_its_bound_or_refused(arb *a)
{
    sample *s = arb_bspline(a);
    const unsigned p = s->g.p, k = arb_below(a, 3) ? arb_below(a, p + 1) : 1;

    if (arb_below(a, 2))                            /* small ones, so that more of them fit */
        for (unsigned j = 0; j < s->g.points; j++)
            for (int i = 0; i < LOFT_AXES; i++)
                s->p[j].axis[i] = real_of_raw((int64_t)arb_below(a, 20000) - 10000);
    init(s);
    const loft_real u = arb_u(a, &s->g), sign = LOFT_REAL(-3);
    const unsigned span = exact_span(&s->g, u);
    long double f = 1;
    bool all = true, none = true;
    loft_vec v;

    for (unsigned j = 0; j < k; j++)
        f *= (p - j) / (exact_of(s->g.k[span + 1]) - exact_of(s->g.k[span]));
    v.axis[0] = sign;
    const enum loft_status status = loft_bspline_deriv(&s->b, k, u, &v);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = (long double)exact_slope(s, k, i, span, quad_of(u)),
                          twice = 1u << k;
        const long double floats = ulp(want) / 2 + 5 * (p + k) * twice * f * ulp_double(s->largest);
        const long double bound = bound_by_num(LSB / 2 + (k + (twice * p + k) * f) * LSB / 131072,
                                               floats, floats);
        const long double over = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX),
                          under = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
        all  = all && want < over - bound && want > under + bound;
        none = none && want < over + bound && want > under - bound;
        if (status == LOFT_OK)
            CHECK_EXACT(exact_of(v.axis[i]), want, bound);
    }
    CHECK(status == LOFT_OK
              ? none
              : status == LOFT_ERR_RANGE && !all && v.axis[0] <= sign && v.axis[0] >= sign);
}

static void a_derivative_above_the_degree_is_0(arb *a)
{
    const sample *s = arb_bspline(a);
    const loft_real u = arb_u(a, &s->g);
    loft_vec v, zero = { { 0 } };

    CHECK(loft_bspline_deriv(&s->b, s->g.p + 1 + arb_below(a, 300), u, &v) == LOFT_OK &&
          loft_vec_equal(v, zero));
    CHECK(loft_bspline_deriv(&s->b, 0, u, &v) == LOFT_OK &&
          loft_vec_equal(v, loft_bspline_eval(&s->b, u)));
}

/* A slope of -32768 on a knot span of 1, and a slope one LSB below, which does not fit a
 * coordinate. */
static void a_derivative_reaches_the_end_of_the_range(arb *a)
{
    const loft_real k[4] = { 0, 0, LOFT_REAL(1), LOFT_REAL(1) };
    loft_vec p[2] = { { { LOFT_REAL(16384) } }, { { LOFT_REAL(-16384) } } }, v;
    loft_bspline b;

    (void)a;
    CHECK(loft_bspline_init(&b, p, 2, k, 1) == LOFT_OK);
    CHECK(loft_bspline_deriv(&b, 1, LOFT_REAL(0.5), &v) == LOFT_OK);
    CHECK_EXACT(exact_of(v.axis[0]), -32768, 0);
    p[1].axis[0] -= BY_NUM(1, 0, 0);
    CHECK(loft_bspline_deriv(&b, 1, LOFT_REAL(0.5), &v) ==
          BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
}

/* Moving a point moves the curve within k[i] .. k[i+p+1] only. */
static void a_point_has_local_support(arb *a)
{
    sample *s = arb_bspline(a);
    const loft_real u = arb_u(a, &s->g);
    const unsigned i = arb_below(a, s->g.points), span = exact_span(&s->g, u);
    const loft_vec before = loft_bspline_eval(&s->b, u);

    s->p[i] = arb_vec(a, 32767);
    if (i + s->g.p < span || i > span)
        CHECK(loft_vec_equal(loft_bspline_eval(&s->b, u), before));
}

/* x -> o - x / 2: exact for points that are even and small enough. */
static void an_affine_image_has_the_image_of_the_point(arb *a)
{
    sample *s = arb_bspline(a);
    const loft_real u = arb_u(a, &s->g), o = arb_real(a, 100);
    const loft_vec v = loft_bspline_eval(&s->b, u);

    for (unsigned k = 0; k < s->g.points; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            s->p[k].axis[i] = o - s->p[k].axis[i] / 2;
    const loft_vec image = loft_bspline_eval(&s->b, u);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(image.axis[i]), exact_of(o) - exact_of(v.axis[i]) / 2,
                    BY_NUM(2, 3, 10 * s->g.p + 4) * ulp(s->largest + 100));
}

/* Knots and parameter times 2 and, if that is exact, translated: the place of u is the same. */
static void an_affine_image_of_the_knots_changes_nothing(arb *a)
{
    sample *s = arb_bspline(a);
    const loft_real u = arb_u(a, &s->g), by = BY_NUM(LOFT_REAL(-4), 0, 0);
    grid twice = s->g;
    loft_bspline b;

    if (s->g.kind == 2 || s->g.kind == 3)               /* as large as possible    */
        return;
    for (unsigned i = 0; i <= s->g.points + s->g.p; i++)
        twice.k[i] = 2 * s->g.k[i] + by;
    CHECK(loft_bspline_init(&b, s->p, s->g.points, twice.k, s->g.p) == LOFT_OK);
    CHECK(loft_vec_equal(loft_bspline_eval(&b, 2 * u + by), loft_bspline_eval(&s->b, u)));
}

static void spans_are_the_curve(arb *a)
{
    const sample *s = arb_bspline(a);
    const unsigned p = s->g.p;
    loft_vec out[POINTS];
    unsigned count = 0, want = 0;

    for (unsigned i = p; i < s->g.points; i++)
        want += s->g.k[i] < s->g.k[i + 1];
    for (unsigned span = 0; loft_bspline_next(&s->b, &span, out); count++) {
        const long double lo = exact_of(s->g.k[span]), hi = exact_of(s->g.k[span + 1]);
        for (unsigned j = 0; j <= 4; j++) {
            const long double t = j / 4.0L, u = lo + (hi - lo) * t;
            long double n[KNOTS_MOST];
            exact_weights(&s->g, p, span, u, n);
            for (int i = 0; i < LOFT_AXES; i++) {
                long double c[POINTS], sum = 0;
                for (unsigned k = 0; k <= p; k++)
                    c[k] = exact_of(out[k].axis[i]);
                for (unsigned k = 0; k < s->g.points; k++)
                    sum += n[k] * exact_of(s->p[k].axis[i]);
                CHECK_EXACT(exact_eval(c, p, t), sum,
                            point_bound(s, p, BY_NUM(sum, s->largest, sum)));
            }
        }
    }
    CHECK(count == want);
}

static void a_bezier_curve_is_a_special_case(arb *a)
{
    sample *s = arb_bspline(a);
    const unsigned p = s->g.p;
    loft_real k[2 * POINTS];
    loft_vec out[POINTS];
    loft_bspline b;
    loft_bezier bezier;
    unsigned span = 0;
    const loft_unit t = arb_unit(a);

    for (unsigned i = 0; i <= p; i++) {
        k[i] = LOFT_REAL(-1);
        k[p + 1 + i] = LOFT_REAL(3);
    }
    CHECK(loft_bspline_init(&b, s->p, p + 1, k, p) == LOFT_OK);
    CHECK(loft_bezier_init(&bezier, s->p, p) == LOFT_OK);
    CHECK(loft_bspline_next(&b, &span, out) && span == p);
    for (unsigned i = 0; i <= p; i++)
        CHECK(loft_vec_equal(out[i], s->p[i]));
    CHECK(!loft_bspline_next(&b, &span, out) && span == 0);
    const loft_unit coarse = BY_NUM(t / 1024 * 1024, t, t);     /* so that u is a coordinate */
    const loft_vec want = loft_bezier_eval(&bezier, coarse),
                   got = loft_bspline_eval(
                       &b, BY_NUM(coarse / 64 - 65536, 4 * coarse - 1, 4 * coarse - 1));
    for (int i = 0; i < LOFT_AXES; i++)         /* f32 and f64 round u */
        CHECK_EXACT(exact_of(got.axis[i]), exact_of(want.axis[i]),
                    BY_NUM(1, 4 * p + 2, 14 * p + 4) * ulp(s->largest));
}

/* Pieces that meet at a knot of multiplicity p share its control point; the others belong to one
 * piece. */
static void bezier_pieces_come_back_as_they_were(arb *a)
{
    sample *s = arb_bspline(a);
    const unsigned p = s->g.p;
    loft_real k[3 * POINTS];
    loft_vec p2[2 * POINTS], out[POINTS];
    loft_bspline b;
    unsigned span = 0;

    for (unsigned i = 0; i <= 2 * p; i++)
        p2[i] = arb_vec(a, 32767);
    for (unsigned i = 0; i < 3 * p + 2; i++)
        k[i] = i <= p ? LOFT_REAL(0.25) : i <= 2 * p ? LOFT_REAL(0.5) : LOFT_REAL(7);
    CHECK(loft_bspline_init(&b, p2, 2 * p + 1, k, p) == LOFT_OK);
    for (unsigned piece = 0; piece < 2; piece++) {
        CHECK(loft_bspline_next(&b, &span, out));
        for (unsigned i = 0; i <= p; i++)
            CHECK(loft_vec_equal(out[i], p2[piece * p + i]));
    }
    CHECK(!loft_bspline_next(&b, &span, out));
}

static void an_inserted_knot_changes_nothing(arb *a)
{
    sample *s = arb_bspline(a);
    const sample old = *s;
    const loft_real at = arb_u(a, &s->g), u = arb_u(a, &old.g);

    if (!loft_knots_valid(&s->b.knots, at) || s->g.points == POINTS_MOST) {
        CHECK(s->g.points == POINTS_MOST ||
              loft_bspline_insert(&s->b, at, s->p, s->g.k) == LOFT_ERR_ARG);
        return;
    }
    CHECK(loft_bspline_insert(&s->b, at, s->p, s->g.k) == LOFT_OK);
    s->g.points++;
    init(s);
    CHECK(s->largest <= old.largest + BY_NUM(0, 1, 6) * ulp(old.largest));
    if (exact_span(&s->g, u) == 0)
        return;
    const loft_vec v = loft_bspline_eval(&s->b, u);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_point(&old, i, u);
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    point_bound(&old, s->g.p, want) +
                        point_bound(&old, 1, BY_NUM(want, old.largest, want)));
    }
}

/* The two pieces of the points 0 0 6 0 0 are 0 0 3 3 and 3 3 0 0: 1 inserted twice by hand. */
static void a_clamped_cubic_has_its_known_spans(arb *a)
{
    const loft_real k[9] = {
        0, 0, 0, 0, LOFT_REAL(1), LOFT_REAL(2), LOFT_REAL(2), LOFT_REAL(2), LOFT_REAL(2)
    };
    const double want[2][4] = { { 0, 0, 3, 3 }, { 3, 3, 0, 0 } };
    loft_vec p[5] = { { { 0 } } }, out[4];
    loft_bspline b;
    unsigned span = 0, piece = 0;

    (void)a;
    p[2].axis[0] = LOFT_REAL(6);
    CHECK(loft_bspline_init(&b, p, 5, k, 3) == LOFT_OK);
    for (; loft_bspline_next(&b, &span, out); piece++)
        for (unsigned j = 0; j < 4; j++)
            CHECK_EXACT(exact_of(out[j].axis[0]), want[piece][j], 0);
    CHECK(piece == 2);
}

/* Cardinal splines: 1/6, 4/6, 1/6 at the knots; 1/48, 23/48, 23/48, 1/48 between them. */
static void a_uniform_cubic_has_its_known_weights(arb *a)
{
    loft_real k[12];
    loft_vec p[8] = { { { 0 } } };
    loft_bspline b;

    (void)a;
    for (int32_t i = 0; i < 12; i++)
        k[i] = loft_real_from_int(i);
    p[4].axis[0] = LOFT_REAL(48);
    CHECK(loft_bspline_init(&b, p, 8, k, 3) == LOFT_OK);
    const double u[5] = { 5, 5.5, 6, 6.5, 7 }, want[5] = { 8, 23, 32, 23, 8 };
    for (int j = 0; j < 5; j++)
        CHECK_EXACT(exact_of(loft_bspline_eval(&b, LOFT_REAL(u[j])).axis[0]), want[j],
                    BY_NUM(LSB / 2, ulp(want[j]), 16 * ulp(48)));
}

static void bad_input_is_refused_and_nothing_touched(arb *a)
{
    sample *s = arb_bspline(a);
    loft_bspline b = { NULL, { NULL, 0, 0 } };
    const loft_real first = s->g.k[0];

    s->g.k[0] = s->g.k[s->g.points];
    CHECK(loft_bspline_init(&b, s->p, s->g.points, s->g.k, s->g.p) == LOFT_ERR_ARG && b.p == NULL);
    s->g.k[0] = first;
    CHECK(loft_bspline_init(&b, s->p, s->g.p, s->g.k, s->g.p) == LOFT_ERR_ARG && b.p == NULL);
#if LOFT_NUM != LOFT_Q16
    s->p[arb_below(a, s->g.points)].axis[0] = (loft_real)INFINITY;
    CHECK(loft_bspline_init(&b, s->p, s->g.points, s->g.k, s->g.p) == LOFT_ERR_RANGE &&
          b.p == NULL);
#endif
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound, 5000);
    PROPERTY(beyond_the_domain_u_is_clamped, 1000);
    PROPERTY(a_derivative_is_within_its_bound_or_refused, 5000);
    PROPERTY(a_derivative_above_the_degree_is_0, 1000);
    PROPERTY(a_derivative_reaches_the_end_of_the_range, 1);
    PROPERTY(a_point_has_local_support, 1000);
    PROPERTY(an_affine_image_has_the_image_of_the_point, 1000);
    PROPERTY(an_affine_image_of_the_knots_changes_nothing, 1000);
    PROPERTY(spans_are_the_curve, 1000);
    PROPERTY(a_bezier_curve_is_a_special_case, 1000);
    PROPERTY(bezier_pieces_come_back_as_they_were, 1000);
    PROPERTY(an_inserted_knot_changes_nothing, 3000);
    PROPERTY(a_clamped_cubic_has_its_known_spans, 1);
    PROPERTY(a_uniform_cubic_has_its_known_weights, 1);
    PROPERTY(bad_input_is_refused_and_nothing_touched, 300);
    return check_failures();
}

/* tests/lib/curve/test_rational_extend.c -- properties of lib/curve/rational.h beyond the ends of
 * 0..1
 * SPDX-License-Identifier: MIT
 *
 * The denominator is small there, which costs the reference accuracy: it uses 113 bits.
 */
#include "support/rationals.h"          /* arb_rational */
#include "support/exact_spline.h"       /* quad, quad_of */

#define SLACK 1e-9L             /* relative, where a decision depends on rounding        */

typedef struct {
    quad x[LOFT_AXES][POINTS], w[POINTS];
    long double most;           /* the largest weight */
} exact_rational;

static quad quad_unit(loft_unit t) { return BY_NUM((quad)t / 16777216, (quad)t, (quad)t); }

static exact_rational exact_curve(const sample *s)
{
    exact_rational e = { .most = 0 };

    for (unsigned k = 0; k <= s->n; k++) {
        e.w[k] = quad_of(s->p[k].w);
        e.most = fmaxl(e.most, (long double)e.w[k]);
        for (int i = 0; i < LOFT_AXES; i++)
            e.x[i][k] = e.w[k] * quad_of(s->p[k].p.axis[i]);
    }
    return e;
}

/* The blossom at `from` n - k times and at `to` k times. */
static quad blossom_at(const quad c[], unsigned n, unsigned k, quad from, quad to)
{
    quad v[POINTS];

    for (unsigned j = 0; j <= n; j++)
        v[j] = c[j];
    for (unsigned rows = n; rows > 0; rows--) {
        const quad t = rows > k ? from : to;
        for (unsigned j = 0; j < rows; j++)
            v[j] = (1 - t) * v[j] + t * v[j + 1];
    }
    return v[0];
}

static quad value_at(const quad c[], unsigned n, quad t) { return blossom_at(c, n, 0, t, t); }

/* In -1..2, more often next to the ends, so that more curves have a point there. */
static loft_unit arb_beyond(arb *a)
{
    const double by = arb_below(a, 16777217) / 16777216.0 / (1 << arb_below(a, 8));
    return arb_below(a, 2) ? LOFT_UNIT(-by) : LOFT_UNIT(1 + by);
}

static long double loss(const exact_rational *e, unsigned n, long double t, quad w)
{
    return powl(growth(t), n) * e->most / (long double)w;
}

static long double within(long double want[LOFT_AXES], long double largest)
{
    for (int i = 0; i < LOFT_AXES; i++)
        largest = fmaxl(largest, fabsl(want[i]));
    return largest;
}

/* 1: all fit, 0: one does not, -1: too close to decide */
static int all_fit(const long double want[LOFT_AXES], long double slack)
{
    const long double over = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX),
                      under = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
    int all = 1;

    for (int i = 0; i < LOFT_AXES; i++) {
        if (want[i] > over + slack || want[i] < under - slack)
            return 0;
        if (want[i] > over - slack || want[i] < under + slack)
            all = -1;
    }
    return all;
}

static void check_point(const sample *s, loft_vec v, const long double want[], long double k)
{
    const long double size = within((long double *)want, s->largest), lost = 4 * (s->n + 2) * k;

    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), want[i],
                    bound_by_num(LSB / 2 + LSB * 0x1p-40L,
                                 ulp(want[i]) / 2 + lost * ulp_double(size), lost * ulp(size)));
}

/* 1: the weight is large enough for a division, 0: it is not, -1: too close to decide */
static int divisible(const exact_rational *e, unsigned n, long double t, quad w)
{
    const long double least = e->most / 1048576,
                      slack = least * 1e-9L +
                              powl(growth(t), n) * e->most * BY_NUM(0, 1e-14L, 1e-14L);
    return w > least + slack ? 1 : w < least - slack ? 0 : -1;
}

static void a_point_beyond_the_ends_is_within_its_bound_or_refused(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const exact_rational e = exact_curve(s);
    const loft_unit t = arb_beyond(a);
    const quad w = value_at(e.w, s->n, quad_unit(t));
    long double want[LOFT_AXES] = { 0 };
    loft_vec v;

    v.axis[0] = LOFT_REAL(7);
    const enum loft_status status = loft_rational_extrapolate(&s->r, t, &v);
    const int good = divisible(&e, s->n, exact_unit(t), w);
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    CHECK(good != 0 || status == LOFT_ERR_RANGE);
    CHECK(status == LOFT_OK || !(v.axis[0] < LOFT_REAL(7) || v.axis[0] > LOFT_REAL(7)));
    if (good != 1)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        want[i] = (long double)(value_at(e.x[i], s->n, quad_unit(t)) / w);
    const int fit = all_fit(want, SLACK);
    CHECK(fit == -1 || (status == LOFT_OK) == (fit == 1));
    if (status == LOFT_OK)
        check_point(s, v, want, loss(&e, s->n, exact_unit(t), w));
}

static void a_derivative_beyond_the_ends_is_within_its_bound_or_refused(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const exact_rational e = exact_curve(s);
    const loft_unit t = arb_beyond(a);
    const quad u = quad_unit(t), w = value_at(e.w, s->n, u);
    const unsigned n = s->n;
    long double want[LOFT_AXES] = { 0 }, point[LOFT_AXES];
    loft_vec v;

    const enum loft_status status = loft_rational_deriv(&s->r, t, &v);
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    if (divisible(&e, n, exact_unit(t), w) != 1)
        return;
    for (int i = 0; i < LOFT_AXES; i++) {
        point[i] = (long double)(value_at(e.x[i], n, u) / w);
        if (n > 0)
            want[i] = (long double)(n *
                                    (value_at(e.x[i] + 1, n - 1, u) * value_at(e.w, n - 1, u) -
                                     value_at(e.x[i], n - 1, u) * value_at(e.w + 1, n - 1, u)) /
                                    (w * w));
    }
    const long double k = loss(&e, n, exact_unit(t), w), size = within(point, s->largest);
    const int fit = all_fit(point, SLACK),
              slope = all_fit(want, SLACK + BY_NUM(LSB * k * 0x1p-24L, 0, 0));
    CHECK((fit != 0 && slope != 0) || status == LOFT_ERR_RANGE);
    CHECK(fit != 1 || slope != 1 || status == LOFT_OK);
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        const long double floats = ulp(want[i]) / 2 + 24 * n * n * k * k * ulp_double(size);
        CHECK_EXACT(exact_of(v.axis[i]), want[i],
                    bound_by_num((0.51L + k * 0x1p-24L) * LSB, floats, floats));
    }
}

typedef struct {
    bool good, bad;                 /* all fit, one does not: both for sure   */
    long double want[POINTS][LOFT_AXES], w[POINTS], k[POINTS], least, most;
} exact_piece;

static exact_piece piece_of(const sample *s, const exact_rational *e, loft_unit from, loft_unit to)
{
    exact_piece p = { .good = true, .least = 1e30L };
    const long double t = growth(exact_unit(from)) > growth(exact_unit(to)) ? exact_unit(from)
                                                                            : exact_unit(to);

    for (unsigned k = 0; k <= s->n; k++) {
        const quad w = blossom_at(e->w, s->n, k, quad_unit(from), quad_unit(to));
        const int divides = divisible(e, s->n, t, w);
        int fit = -1;
        p.w[k] = (long double)w;
        p.least = fminl(p.least, p.w[k]);
        p.most = fmaxl(p.most, p.w[k]);
        p.k[k] = loss(e, s->n, t, w);
        if (divides == 1) {
            for (int i = 0; i < LOFT_AXES; i++)
                p.want[k][i] =
                    (long double)(blossom_at(e->x[i], s->n, k, quad_unit(from), quad_unit(to)) / w);
            fit = all_fit(p.want[k], SLACK);
        }
        p.good = p.good && divides == 1 && fit == 1;
        p.bad = p.bad || divides == 0 || fit == 0;
    }
    return p;
}

static void check_piece(const sample *s, const loft_weighted out[], const exact_piece *p,
                        long double factor)
{
    for (unsigned k = 0; k <= s->n; k++) {
        const long double w = p->w[k] * factor, top = p->k[0] * p->w[0] * factor;    /* L^n W */
        check_point(s, out[k].p, p->want[k], p->k[k]);
        CHECK_EXACT(exact_of(out[k].w), w,
                    bound_by_num(LSB / 2 + LSB / 32768,
                                 ulp(w) / 2 + 4 * (s->n + 2) * ulp_double(top),
                                 3 * (s->n + 1) * ulp(top)));
        CHECK(out[k].w >= LOFT_WEIGHT_MIN && out[k].w <= LOFT_WEIGHT_MAX);
    }
}

static void a_split_beyond_the_ends_is_within_its_bound_or_refused(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const exact_rational e = exact_curve(s);
    const loft_unit t = arb_beyond(a);
    loft_weighted left[POINTS], right[POINTS];
    exact_piece p[2] = { piece_of(s, &e, 0, t), piece_of(s, &e, t, LOFT_UNIT(1)) };
    const enum loft_status status = loft_rational_split(&s->r, t, left, right);

    for (int i = 0; i < 2; i++) {
        const bool outer = p[i].least < LSB * 255.4L || p[i].most > 256.0001L;
        const bool inner = p[i].least > LSB * 256.6L && p[i].most < 255.9999L;
        CHECK((!outer && !p[i].bad) || status == LOFT_ERR_RANGE || (t >= 0 && t <= LOFT_UNIT(1)));
        p[i].good = p[i].good && inner;
    }
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    CHECK(!p[0].good || !p[1].good || status == LOFT_OK);
    if (status == LOFT_OK) {
        check_piece(s, left, &p[0], 1);
        check_piece(s, right, &p[1], 1);
    }
}

static void a_part_beyond_the_ends_is_within_its_bound_or_refused(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const exact_rational e = exact_curve(s);
    const loft_unit one = arb_beyond(a), two = arb_below(a, 2) ? arb_unit(a) : arb_beyond(a);
    const bool back = arb_below(a, 2);
    const loft_unit from = back ? two : one, to = back ? one : two;
    loft_weighted out[POINTS];
    const exact_piece p = piece_of(s, &e, from, to);
    const enum loft_status status = loft_rational_sub(&s->r, from, to, out);
    const bool inside = from >= 0 && from <= LOFT_UNIT(1) && to >= 0 && to <= LOFT_UNIT(1);
    /* into 128..256 */
    const long double factor = exp2l(floorl(8 - log2l(p.most))), lowest = p.least * factor * 256;
    long double most = 0;

    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    CHECK((!p.bad && (lowest > 0.997L || p.most * factor < 128.1L)) || status == LOFT_ERR_RANGE ||
          inside);
    CHECK(!p.good || lowest < 1.003L || p.most * factor > 255.9L || status == LOFT_OK);
    if (status != LOFT_OK)
        return;
    for (unsigned k = 0; k <= s->n; k++)
        most = fmaxl(most, exact_of(out[k].w));
    CHECK(most > 127.9L);
    check_piece(s, out, &p, exp2l(roundl(log2l(most / p.most))));
}

/* With equal weights the rational curve is the polynomial one, everywhere. */
static void equal_weights_extrapolate_as_the_polynomial(arb *a)
{
    sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit t = arb_beyond(a);
    loft_vec p[POINTS], v, want;
    loft_bezier b;

    for (unsigned k = 0; k <= s->n; k++) {
        p[k] = s->p[k].p;
        s->p[k].w = s->p[0].w;
    }
    CHECK(loft_bezier_init(&b, p, s->n) == LOFT_OK &&
          loft_rational_init(&s->r, s->p, s->n) == LOFT_OK);
    const enum loft_status status = loft_rational_extrapolate(&s->r, t, &v);
    CHECK(status == loft_bezier_extrapolate(&b, t, &want));
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        const long double size = fmaxl(s->largest, fabsl(exact_of(want.axis[i]))) *
                                 powl(growth(exact_unit(t)), s->n);
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(want.axis[i]),
                    bound_by_num(LSB, ulp(size), (10 * s->n + 10) * ulp(size)));
    }
}

/* The denominator 4 (1 - t) + t is 0 at t = 4/3. */
static void where_the_denominator_vanishes_there_is_no_point(arb *a)
{
    loft_weighted p[2] = { { { { 0 } }, LOFT_REAL(4) }, { { { LOFT_REAL(1) } }, LOFT_REAL(1) } },
                  left[2], right[2];
    const loft_unit pole = LOFT_UNIT(1.3333333333333333), before = LOFT_UNIT(1.25),
                    behind = LOFT_UNIT(1.5);
    loft_rational r;
    loft_vec v;

    (void)a;
    CHECK(loft_rational_init(&r, p, 1) == LOFT_OK);
    CHECK(loft_rational_extrapolate(&r, before, &v) == LOFT_OK);
    CHECK_EXACT(exact_of(v.axis[0]), 5, 0);                     /* 1.25 / (4 (1 - 1.25) + 1.25) */
    CHECK(loft_rational_deriv(&r, before, &v) == LOFT_OK);
    CHECK_EXACT(exact_of(v.axis[0]), 64, BY_NUM(0, 0, 16 * ulp(64)));    /* 4 / 0.25^2 */
    CHECK(loft_rational_extrapolate(&r, pole, &v) == LOFT_ERR_RANGE &&
          loft_rational_extrapolate(&r, behind, &v) == LOFT_ERR_RANGE);
    CHECK(loft_rational_deriv(&r, pole, &v) == LOFT_ERR_RANGE &&
          loft_rational_deriv(&r, behind, &v) == LOFT_ERR_RANGE);
    CHECK(loft_rational_split(&r, behind, left, right) == LOFT_ERR_RANGE);
    CHECK(loft_rational_sub(&r, 0, behind, left) == LOFT_ERR_RANGE &&
          loft_rational_sub(&r, behind, 0, left) == LOFT_ERR_RANGE);
    CHECK(loft_rational_sub(&r, 0, before, left) == LOFT_OK &&
          loft_rational_split(&r, before, left, right) == LOFT_OK);
}

int main(void)
{
    PROPERTY(a_point_beyond_the_ends_is_within_its_bound_or_refused,        4000);
    PROPERTY(a_derivative_beyond_the_ends_is_within_its_bound_or_refused,   4000);
    PROPERTY(a_split_beyond_the_ends_is_within_its_bound_or_refused,        2000);
    PROPERTY(a_part_beyond_the_ends_is_within_its_bound_or_refused,         2000);
    PROPERTY(equal_weights_extrapolate_as_the_polynomial,                   1000);
    PROPERTY(where_the_denominator_vanishes_there_is_no_point,                 1);
    return check_failures();
}

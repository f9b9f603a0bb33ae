/* tests/lib/basis/test_interp.c -- properties of lib/basis/interp.h and lib/curve/parabola.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* exact_parabola, quad_of; CHECK, PROPERTY, BY_NUM */
#include "support/extremes.h"           /* extreme_int */
#include "basis/bernstein.h"
#include "basis/interp.h"
#include "curve/bezier.h"
#include "curve/parabola.h"

typedef struct {
    loft_real t[3], f[3], at;
    exact_parabola own;
} sample;

static bool same(loft_real a, loft_real b) { return !(a < b) && !(b < a); }

/* Places of any size and distance, down to neighbours; in one case of four, two may coincide. */
static bool arb_sample(arb *a, sample *s)
{
    const int32_t far = (int32_t)1 << arb_below(a, 15), high = (int32_t)1 << arb_below(a, 15);
    const loft_real base = arb_below(a, 2) ? arb_real(a, far) : 0;

    for (int i = 0; i < 3; i++) {
        s->t[i] = arb_below(a, 2) ? arb_real(a, far)
                                  : base + (loft_real)((int32_t)arb_below(a, 7) - 3) *
                                               BY_NUM(1, 1, 1 / 65536.0);
        s->f[i] = arb_real(a, high);
    }
    s->at = arb_below(a, 4) ? arb_real(a, far) : s->t[arb_below(a, 3)];
    if (same(s->t[0], s->t[1]) || same(s->t[1], s->t[2]) || same(s->t[2], s->t[0]))
        return false;
    s->own = exact_parabola_of(s->t, s->f);
    return true;
}

/* 1/2 LSB + 2^-16 LSB; 0.52 ulp in f32, 1 ulp in f64. The reference itself: 2^-60. */
static void check_value(enum loft_status status, loft_real got, quad want)
{
    const long double w = (long double)want;
    const bool fits = fabsl(w)<BY_NUM(32768 - LSB, FLT_MAX, DBL_MAX), beyond = fabsl(w)> BY_NUM(
        32768 + LSB, FLT_MAX, DBL_MAX);
    const long double by_num[3] = { (0.5L + 0x1p-16L) * LSB, 0.52L * ulp(w), ulp(w) };

    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !fits));
    CHECK(status != LOFT_OK || !beyond);
    if (status == LOFT_OK)
        CHECK_EXACT((long double)(quad_of(got) - want), 0, by_num[BY_NUM(0, 1, 2)] + 0x1p-60L);
}

static void a_parabola_is_rounded_once(arb *a)
{
    sample s;
    loft_parabola p;
    loft_real y = 0, slope = 0;

    if (!arb_sample(a, &s))
        return;
    CHECK(loft_parabola_init(&p, s.t, s.f) == LOFT_OK);
    const enum loft_status value = loft_parabola_eval(&p, s.at, &y);
    check_value(value, y, exact_parabola_blossom(&s.own, quad_of(s.at), quad_of(s.at)));
    const enum loft_status first = loft_parabola_deriv(&p, s.at, &slope);
    check_value(first, slope, exact_parabola_deriv(&s.own, quad_of(s.at)));
}

/* The ends of the type; in floats what loft_exact_valid takes, apart by 2^-16 or more. */
static loft_real extreme_place(arb *a)
{
    const int32_t ends[] = { 1048575, -1048575, 1048574, 0, 1, -1 }, i = ends[arb_below(a, 6)];
    (void)i;
    return BY_NUM((loft_real)extreme_int(a), arb_below(a, 2) ? (loft_real)i : arb_real(a, 1),
                  arb_below(a, 2) ? (loft_real)i : arb_real(a, 1));
}

static void places_and_values_may_be_any(arb *a)
{
    sample s;
    loft_parabola p;
    loft_real y = 0, slope = 0;

    for (int i = 0; i < 3; i++) {
        s.t[i] = extreme_place(a);
        s.f[i] = extreme_place(a);
    }
    s.at = extreme_place(a);
    const bool two = same(s.t[0], s.t[1]) || same(s.t[1], s.t[2]) || same(s.t[2], s.t[0]);
    CHECK(loft_parabola_init(&p, s.t, s.f) == (two ? LOFT_SINGULAR : LOFT_OK));
    if (two)
        return;
    s.own = exact_parabola_of(s.t, s.f);
    const enum loft_status value = loft_parabola_eval(&p, s.at, &y),
                           first = loft_parabola_deriv(&p, s.at, &slope);
    check_value(value, y, exact_parabola_blossom(&s.own, quad_of(s.at), quad_of(s.at)));
    check_value(first, slope, exact_parabola_deriv(&s.own, quad_of(s.at)));
}

static void its_coefficients_are_rounded_once(arb *a)
{
    sample s;
    loft_parabola p;
    loft_real c[3] = { 0 };
    bool fit = true;

    if (!arb_sample(a, &s))
        return;
    CHECK(loft_parabola_init(&p, s.t, s.f) == LOFT_OK);
    const enum loft_status status = loft_parabola_power(&p, c);
    for (int k = 0; k < 3; k++) {
        const quad want = exact_parabola_power(&s.own, k);
        fit = fit && fabsl((long double)want) < BY_NUM(32768 - LSB, FLT_MAX, DBL_MAX);
        if (status == LOFT_OK)
            check_value(status, c[k], want);
    }
    CHECK(status == (fit ? LOFT_OK : status) && (status == LOFT_OK || status == LOFT_ERR_RANGE));
}

static void it_goes_through_its_values(arb *a)
{
    sample s;
    loft_parabola p;

    if (!arb_sample(a, &s))
        return;
    CHECK(loft_parabola_init(&p, s.t, s.f) == LOFT_OK);
    for (int i = 0; i < 3; i++) {
        loft_real y = 0;
        CHECK(loft_parabola_eval(&p, s.t[i], &y) == LOFT_OK);
        CHECK(same(y, s.f[i]));
    }
}

static void the_order_of_its_places_does_not_matter(arb *a)
{
    sample s;
    loft_parabola p, q;
    loft_real x = 0, y = 0;

    if (!arb_sample(a, &s))
        return;
    const loft_real t[3] = { s.t[2], s.t[0], s.t[1] }, f[3] = { s.f[2], s.f[0], s.f[1] };
    CHECK(loft_parabola_init(&p, s.t, s.f) == LOFT_OK && loft_parabola_init(&q, t, f) == LOFT_OK);
    const enum loft_status one = loft_parabola_eval(&p, s.at, &x),
                           two = loft_parabola_eval(&q, s.at, &y);
    CHECK(one == two && (one != LOFT_OK || same(x, y)));
}

/* Per coefficient, also as a piece of a curve. */
static void its_pieces_are_bezier_curves(arb *a)
{
    sample s;
    loft_parabola p;
    loft_real c[3] = { 0 };
    loft_vec points[3], out[3] = { { { 0 } } };
    bool fit = true;

    if (!arb_sample(a, &s))
        return;
    const loft_real from = s.at, to = s.t[arb_below(a, 3)], u[3] = { from, from, to },
                    v[3] = { from, to, to };
    CHECK(loft_parabola_init(&p, s.t, s.f) == LOFT_OK);
    const enum loft_status status = loft_parabola_bernstein(&p, from, to, c);
    for (int k = 0; k < 3; k++) {
        const quad want = exact_parabola_blossom(&s.own, quad_of(u[k]), quad_of(v[k]));
        fit = fit && fabsl((long double)want) < BY_NUM(32768 - LSB, FLT_MAX, DBL_MAX);
        if (status == LOFT_OK)
            check_value(status, c[k], want);
        for (int i = 0; i < LOFT_AXES; i++)
            points[k].axis[i] = s.f[k];
    }
    CHECK(status == LOFT_OK || !fit);
    CHECK(loft_bezier_from_parabola(s.t, points, from, to, out) == status);
    for (int k = 0; k < 3 && status == LOFT_OK; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(same(out[k].axis[i], c[k]));
}

static void coinciding_places_have_no_parabola(arb *a)
{
    const loft_real t = arb_real(a, 32767), other = arb_real(a, 32767), f[3] = { t, other, t };
    const loft_real places[3][3] = { { t, t, other }, { other, t, t }, { t, other, t } };
    loft_parabola p;

    for (int k = 0; k < 3; k++)
        CHECK(loft_parabola_init(&p, places[k], f) == LOFT_SINGULAR);
#if LOFT_NUM != LOFT_Q16
    const loft_real good[3] = { 0, 1, 2 };
    loft_real odd[3] = { 0, 1, 2 }, wide[3] = { 0, 1, 2 }, y = 7;
    odd[arb_below(a, 3)] = (loft_real)NAN;
    wide[arb_below(a, 3)] = (loft_real)(arb_below(a, 2) ? 0x1p20 : -0x1p20);
    CHECK(loft_parabola_init(&p, odd, good) == LOFT_ERR_RANGE &&
          loft_parabola_init(&p, good, wide) == LOFT_ERR_RANGE);
    CHECK(loft_parabola_init(&p, good, good) == LOFT_OK);
    CHECK(loft_parabola_eval(&p, (loft_real)NAN, &y) == LOFT_ERR_RANGE &&
          loft_parabola_deriv(&p, (loft_real)0x1p20, &y) == LOFT_ERR_RANGE);
    CHECK(same(y, 7));
#endif
}


/* Both ends: `n` = 3 or 5, data of any size in the range */

typedef struct {
    unsigned n;
    loft_acc e[6];
    long double c[6], largest;
} ends;

static loft_unit arb_extended(arb *a)
{
    return arb_below(a, 2) ? arb_unit(a) : (loft_unit)(3 * arb_unit(a) - LOFT_UNIT(1));
}

static ends arb_ends(arb *a)
{
    ends s = { .n = arb_below(a, 2) ? 3 : 5 };
    long double x[6] = { 0 };
    const int32_t limit = (int32_t)1 << arb_below(a, 15);

    for (unsigned k = 0; k < s.n + 1; k++) {
        s.e[k] = loft_to_acc(arb_real(a, limit)) * (s.n == 3 ? 64 : 2);
        x[k] = exact_acc(s.e[k]);
        s.largest = fmaxl(s.largest, fabsl(x[k]));
    }
    const long double n = s.n, second = s.n == 5 ? 1 / 20.0L : 0;
    s.c[0] = x[0];
    s.c[1] = x[0] + x[2] / n;
    s.c[s.n - 1] = x[1] - x[3] / n;
    s.c[s.n] = x[1];
    if (s.n == 5) {
        s.c[2] = x[0] + x[2] * 2 / 5 + x[4] * second;
        s.c[3] = x[1] - x[3] * 2 / 5 + x[5] * second;
    }
    return s;
}

static void coefficients_are_what_the_ends_ask_for(arb *a)
{
    const ends s = arb_ends(a);
    loft_acc c[6];

    if (s.n == 3)
        loft_ends3_bernstein(s.e, c);
    else
        loft_ends5_bernstein(s.e, c);
    for (unsigned k = 0; k <= s.n; k++)
        CHECK_EXACT(exact_acc(c[k]), s.c[k],
                    BY_NUM(k == 0 || k == s.n ? 0 : 0x1p-33L + s.largest * 0x1p-62L,
                           3 * ulp_double(s.largest), 3 * ulp_double(s.largest)));
}

static void derivatives_are_within_their_bound(arb *a)
{
    const ends s = arb_ends(a);
    const unsigned k = arb_below(a, s.n + 2), m = k > s.n ? 0 : s.n - k;
    const loft_unit t = arb_extended(a);
    const long double x = exact_unit(t), l = growth(x), n = s.n;
    long double factor = 1;

    for (unsigned j = m + 1; j <= s.n; j++)
        factor *= j;
    const loft_acc got = s.n == 3 ? loft_ends3_deriv(s.e, k, t) : loft_ends5_deriv(s.e, k, t);
    const long double steps = k == 0 ? powl(l, n) + growth_sum(x, s.n) : growth_sum(x, m);
    const long double ulps = k == 0 ? (6 * n + 4) * powl(l, n)
                                    : 3 * n * powl(2, n) * powl(l, m) * factor;
    const long double floats = ulps * ulp_double(s.largest);
    CHECK_EXACT(exact_acc(got), exact_deriv(s.c, s.n, k, x),
                bound_by_num(steps * 0x1p-33L + factor * s.largest * 0x1p-58L, floats, floats));
}

int main(void)
{
    PROPERTY(a_parabola_is_rounded_once,               1500);
    EXTREMES(loft_parabola_init, places_and_values_may_be_any, 1500);
    EXTREMES(loft_parabola_eval, places_and_values_may_be_any,    1);
    PROPERTY(its_coefficients_are_rounded_once,        1500);
    PROPERTY(it_goes_through_its_values,                500);
    PROPERTY(the_order_of_its_places_does_not_matter,   500);
    PROPERTY(its_pieces_are_bezier_curves,              500);
    PROPERTY(coinciding_places_have_no_parabola,        100);
    PROPERTY(coefficients_are_what_the_ends_ask_for,   5000);
    PROPERTY(derivatives_are_within_their_bound,      10000);
    return check_failures();
}

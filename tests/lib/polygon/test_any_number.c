/* tests/lib/polygon/test_any_number.c -- functions whose range says "any", with the ends of types
 * SPDX-License-Identifier: MIT
 *
 * Of all rooms, those whose own tests draw no extremes. What no reference of 113 bits can tell is
 * at least defined, in its bounds and without overflow: the sanitizers see that.
 */
#include "support/exact_sci.h"
#include "support/exact_whole.h"        /* quad */
#include "support/extremes.h"

#include "curve/forward.h"
#include "curve/join.h"
#include "curve/measure.h"
#include "curve/shape.h"
#include "curve/spline.h"
#include "geom/vec_exact.h"
#include "machine/override_limit.h"
#include "motion/span.h"
#include "polygon/gb.h"
#include "polygon/meanvalue.h"
#include "surface/tensor/grid.h"
#include "wire/codec.h"

static long double larger(long double x, long double y) { return fmaxl(fabsl(x), fabsl(y)); }


// Numbers and points
// ------------------

static void a_parameter_becomes_a_whole_number(arb *a)
{
    const int32_t i = BY_NUM(extreme_int(a), (int32_t)arb_below(a, 2049) - 1024,
                             (int32_t)arb_below(a, 2049) - 1024);
    const loft_exact got = loft_exact_from_unit((loft_unit)i),
                     want = loft_exact_shift(loft_exact_from_int(i), BY_NUM(0, 53, 53));

    CHECK(loft_exact_compare(got, want) == 0);
}

static void a_place_between_any_two_gives_a_value_between(arb *a)
{
    const loft_real p = extreme_real(a), q = extreme_real(a), at = extreme_real(a);
    const loft_real lo = p < q ? p : q, hi = p < q ? q : p;
    const loft_real between = at < lo ? lo : at > hi ? hi : at;
    const loft_acc most = BY_NUM(((loft_acc)1 << 62) - 1, 0, 0);
    loft_acc x = extreme_acc(a), y = extreme_acc(a);

    if (BY_NUM(true, false, false)) {
        x = x > most ? most : x < -most ? -most : x;
        y = y > most ? most : y < -most ? -most : y;
    }
    if (!(lo < hi) || larger(exact_of(lo), exact_of(hi)) >= BY_NUM(1e9L, 1e300L, 1e300L))
        return;
    const long double part = (exact_of(between) - exact_of(lo)) / (exact_of(hi) - exact_of(lo)),
                      u = exact_acc(x), v = exact_acc(y), want = u + part * (v - u),
                      off = larger(u, v);
    const loft_acc got = loft_acc_lerp_in(x, y, between, lo, hi);
    CHECK_EXACT(exact_acc(got), want,
                BY_NUM(0x1p-33L + off * 0x1p-61L, 5 * ulp_double(off), 5 * ulp_double(off)));
    CHECK_EXACT(exact_acc(loft_acc_lerp_in(x, y, lo, lo, hi)), u, 0);
    CHECK_EXACT(exact_acc(loft_acc_lerp_in(x, y, hi, lo, hi)), v, 0);
}

static void a_vector_of_any_axes_has_a_length(arb *a)
{
    loft_acc x[9];
    const int n = (int)arb_below(a, BY_NUM(7, 10, 10));
    long double want = 0;

    for (int i = 0; i < n; i++) {
        const loft_acc most = BY_NUM(((loft_acc)1 << 61) - 1, 0, 0), any = extreme_acc(a);
        (void)most;
        x[i] = BY_NUM(any > most ? most : any < -most ? -most : any, any, any);
        want = hypotl(want, exact_acc(x[i]));
    }
    CHECK_EXACT(exact_acc(loft_acc_hypot(x, n)), want,
                BY_NUM(0x1p-28L * want + 0x1p-32L, 0x1p-50L * want, 0x1p-50L * want));
}

static void any_points_have_a_point_between(arb *a)
{
    const loft_vec x = extreme_vec(a), y = extreme_vec(a);
    const loft_unit t = arb_unit(a);
    const loft_vec got = loft_vec_lerp(x, y, t);

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double u = exact_of(x.axis[i]), v = exact_of(y.axis[i]);
        CHECK_EXACT(exact_of(got.axis[i]), u + exact_unit(t) * (v - u),
                    BY_NUM(LSB / 2, 4 * ulp(larger(u, v) / 2) + 0x1p-120L,
                           4 * ulp(larger(u, v) / 2) + 0x1p-120L));
    }
    CHECK(loft_vec_equal(loft_vec_lerp(x, y, LOFT_UNIT(0)), x) &&
          loft_vec_equal(loft_vec_lerp(x, y, LOFT_UNIT(1)), y));
}

static void any_axis_of_a_difference_is_exact(arb *a)
{
    loft_vec x = { { 0 } }, y = { { 0 } };

    for (int i = 0; i < LOFT_AXES; i++) {
        x.axis[i] = extreme_exact(a);
        y.axis[i] = extreme_exact(a);
    }
    const int axis = (int)arb_below(a, LOFT_AXES + 2);
    const loft_exact got = loft_vec_exact_sub_axis(&x, &y, axis);
    if (axis >= LOFT_AXES) {
        CHECK(loft_exact_sign(got) == 0);
        return;
    }
    CHECK(loft_exact_compare(got, loft_exact_sub(loft_exact_from_real(x.axis[axis]),
                                                 loft_exact_from_real(y.axis[axis]))) == 0);
    CHECK(loft_exact_sign(got) == (x.axis[axis] > y.axis[axis]) - (x.axis[axis] < y.axis[axis]));
}


// Curves
// ------

static loft_bezier extreme_curve(arb *a, loft_vec p[], unsigned degree, bool exact)
{
    const loft_bezier b = { p, (uint8_t)degree };

    for (unsigned k = 0; k <= degree; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = exact ? extreme_exact(a) : extreme_real(a);
    return b;
}

static void a_walk_of_any_points_ends_on_the_last_or_is_refused(arb *a)
{
    loft_vec p[6], at = { { 0 } };
    const loft_bezier b = extreme_curve(a, p, arb_below(a, 6), false);
    const uint32_t n = 1 + arb_below(a, 9);
    loft_forward w;

    if (loft_forward_init(&w, &b, n) != LOFT_OK)
        return;
    for (uint32_t k = 0; k < n; k++)
        CHECK(loft_forward_next(&w, &at));
    CHECK(!loft_forward_next(&w, &at) && loft_vec_equal(at, p[b.degree]));
}

static void a_span_of_any_points_ends_on_the_last_or_is_refused(arb *a)
{
    loft_span s = { .ticks = (uint16_t)(1 + arb_below(a, 50)) };
    loft_forward w;
    loft_vec at = { { 0 } };

    (void)extreme_curve(a, s.p, 3, false);
    if (loft_span_walk(&w, &s) != LOFT_OK)
        return;
    for (unsigned k = 0; k < s.ticks; k++)
        CHECK(loft_forward_next(&w, &at));
    CHECK(!loft_forward_next(&w, &at) && loft_vec_equal(at, s.p[3]));
}

static quad quad_real(loft_real x) { return BY_NUM((quad)x / 65536, (quad)x, (quad)x); }

/* c[1] = c[0] + alpha a[n], c[2] = c[1] - alpha^2 a[n-1] + eta a[n] */
static void any_alpha_continues_by_the_formula_or_is_refused(arb *a)
{
    loft_vec p[4], c[3];
    const loft_bezier b = extreme_curve(a, p, 2 + arb_below(a, 2), true);
    const loft_real alpha = extreme_exact(a), eta = extreme_exact(a);
    const unsigned n = b.degree;

    if (loft_join_continue(&b, alpha, eta, c) != LOFT_OK)
        return;
    CHECK(loft_vec_equal(c[0], p[n]));
    for (int i = 0; i < LOFT_AXES; i++) {
        const quad last = quad_real(p[n].axis[i]) - quad_real(p[n - 1].axis[i]),
                   before = quad_real(p[n - 1].axis[i]) - quad_real(p[n - 2].axis[i]),
                   one = quad_real(p[n].axis[i]) + quad_real(alpha) * last,
                   two = one - quad_real(alpha) * quad_real(alpha) * before + quad_real(eta) * last;
        const quad want[2] = { one, two };
        for (int k = 0; k < 2; k++) {
            const long double size = fabsl((long double)want[k]);
            CHECK_EXACT((long double)(quad_real(c[k + 1].axis[i]) - want[k]), 0,
                        BY_NUM((0.5L + 0x1p-16L) * LSB + 0 * size, 0.51L * ulp(size) + 0x1p-60L,
                               ulp(size) + 0x1p-60L));
        }
    }
}

static void any_curve_is_cut_into_chords(arb *a)
{
    loft_cubic c;
    loft_flatten f;
    loft_vec at;
    const loft_real tol[] = { BY_NUM(2, LOFT_REAL(1e30), LOFT_REAL(1e30)), LOFT_REAL_MAX,
                              LOFT_REAL(1), 0, -LOFT_REAL_MAX };

    (void)extreme_curve(a, c.p, 3, false);
    if (loft_flatten_init(&f, &c, tol[arb_below(a, 5)]) != LOFT_OK)
        return;
    for (int n = 0; n < 30; n++)
        if (!loft_flatten_next(&f, &at)) {
            CHECK(loft_vec_equal(f.last, c.p[3]));
            return;
        }
}

static long double apart(const loft_vec *p, const loft_vec *q)
{
    long double sum = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        sum = hypotl(sum, exact_of(p->axis[i]) - exact_of(q->axis[i]));
    return sum;
}

/* Never shorter than the chord, nor longer than the control polygon. */
static void the_length_of_any_curve_is_between_its_bounds(arb *a)
{
    loft_cubic c;
    const loft_real tol[] = { LOFT_REAL(1), LOFT_REAL_MAX, 0, -LOFT_REAL_MAX };

    (void)extreme_curve(a, c.p, 3, false);
    const long double least = apart(&c.p[0], &c.p[3]), most = apart(&c.p[0], &c.p[1]) +
                                                              apart(&c.p[1], &c.p[2]) +
                                                              apart(&c.p[2], &c.p[3]);
    const loft_real chosen = tol[arb_below(a, 4)];
    const long double own = fmaxl(exact_of(chosen), most * 0x1p-22L),
                      off = own + BY_NUM(most * 0x1p-27L + LSB, most * 0x1p-40L, most * 0x1p-40L);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (!loft_real_valid(c.p[k].axis[i]) || most > BY_NUM(1e9L, 1e300L, 1e300L))
                return;
    const long double got = exact_acc(loft_cubic_arclen(&c, chosen));
    CHECK(got >= least - off && got <= most + off);
}

static void any_number_of_points_is_convex_or_not_backwards_too(arb *a)
{
    const unsigned count = arb_below(a, 7);
    loft_vec p[7], back[7];
    enum loft_convexity one = 0, two = 0;

    for (unsigned k = 0; k < count; k++) {
        p[k] = extreme_vec(a);
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = arb_below(a, 9) ? extreme_exact(a) : p[k].axis[i];
    }
    for (unsigned k = 0; k < count; k++)
        back[k] = p[count - 1 - k];
    const enum loft_status status = loft_polygon_convex(p, count, &one);
    CHECK(status == loft_polygon_convex(back, count, &two) && one == two);
}

/* The second derivative of a cubic is linear, at any place. */
static void any_place_of_a_spline_has_a_slope(arb *a)
{
    loft_vec p[5];
    loft_spline_knot memory[5];
    loft_spline s;
    const loft_sci x = loft_sci_from_real(extreme_exact(a));

    for (int k = 0; k < 5; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = extreme_exact(a) / 4;
    if (loft_spline_hidden_init(&s, p, 5, LOFT_HIDDEN_SLOPE, memory) != LOFT_OK)
        return;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const long double from = exact_sci(loft_spline_slope(&s, 1, 2, loft_sci_zero(), axis)),
                          to = exact_sci(loft_spline_slope(&s, 1, 2, loft_sci_one(), axis)),
                          at = exact_sci(x), size = (fabsl(at) + 1) * (larger(from, to) + 1e6L);
        CHECK_EXACT(exact_sci(loft_spline_slope(&s, 1, 2, x, axis)), from + at * (to - from),
                    size * BY_NUM(0x1p-50L, 0x1p-44L, 0x1p-44L));
        CHECK(isfinite((double)exact_sci(loft_spline_slope(&s, 0, 0, x, axis))) &&
              isfinite((double)exact_sci(loft_spline_slope(&s, 1, 1, x, axis))));
    }
}


// Motion, wire and machine
// ------------------------

static void any_curve_comes_out_as_it_went_in(arb *a)
{
    int32_t start[LOFT_AXES];
    loft_predictor from;
    uint8_t byte[2 * 255];
    loft_item item = { .ticks = (uint16_t)(arb_below(a, 2) ? 65535 : 1 + arb_below(a, 9)) }, out;
    loft_packer p;
    loft_unpacker u;

    for (int i = 0; i < LOFT_AXES; i++) {
        start[i] = extreme_int(a);
        for (int k = 0; k < 3; k++)
            item.p[k][i] = extreme_int(a);
    }
    loft_predictor_init(&from, start);
    loft_packer_init(&p, LOFT_CURVES, &from, byte, 255);
    CHECK(loft_packer_push(&p, &item) == LOFT_OK);
    CHECK(loft_unpacker_init(&u, LOFT_CURVES, byte, p.size, p.count) == LOFT_OK);
    CHECK(loft_unpacker_next(&u, &from, &out) && out.ticks == item.ticks);
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 3; k++)
            CHECK(out.p[k][i] == item.p[k][i]);
}

static void any_span_has_an_override_limit(arb *a)
{
    int32_t from[LOFT_AXES];
    loft_item item = { .ticks = (uint16_t)(1 + arb_below(a, LOFT_SPAN_TICKS_MAX)) }, before = item;
    loft_axis_config axis[LOFT_AXES] = { 0 };

    for (int i = 0; i < LOFT_AXES; i++) {
        from[i] = extreme_int(a);
        for (int k = 0; k < 3; k++) {
            item.p[k][i] = extreme_int(a);
            before.p[k][i] = extreme_int(a);
        }
        axis[i].max_speed = extreme_int(a) & INT32_MAX;
        axis[i].max_accel = extreme_int(a) & INT32_MAX;
        axis[i].max_jerk = (uint32_t)extreme_int(a);
    }
    const uint16_t hz = (uint16_t)(1 + arb_below(a, UINT16_MAX));
    const uint8_t got = loft_override_limit_of(&item, from, arb_below(a, 2) ? &before : NULL, axis,
                                               hz);
    CHECK(got >= LOFT_OVERRIDE_LIMIT_ONE);
}


// Surfaces
// --------

static void a_grid_of_any_points_ends_on_the_last_or_is_refused(arb *a)
{
    loft_vec p[16], at = { { 0 } };
    const loft_tensor s = { p, (uint8_t)arb_below(a, 4), (uint8_t)arb_below(a, 4) };
    const unsigned count = (s.m + 1u) * (s.n + 1u);
    const uint32_t rows = 1 + arb_below(a, 3), columns = 1 + arb_below(a, 3);
    loft_state memory[LOFT_GRID_STATES(3, 3)];
    loft_grid g;

    (void)extreme_curve(a, p, count - 1, false);
    if (loft_grid_init(&g, &s, rows, columns, memory, LOFT_GRID_STATES(3, 3)) != LOFT_OK)
        return;
    for (uint32_t k = 0; k < (rows + 1) * (columns + 1); k++)
        CHECK(loft_grid_next(&g, &at));
    CHECK(!loft_grid_next(&g, &at) && loft_vec_equal(at, p[count - 1]));
}

static void any_shares_have_parameters_or_none(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6);
    loft_gb_side side[LOFT_SIDES_MAX];
    loft_sci phi[LOFT_SIDES_MAX];
    bool positive = true;

    for (unsigned i = 0; i < n; i++) {
        phi[i] = loft_sci_from_real(extreme_exact(a));
        positive = positive && loft_sci_sign(phi[i]) >= 0;
    }
    const enum loft_status status = loft_gb_params(n, phi, side);
    CHECK(status == LOFT_OK || (status == LOFT_SINGULAR && !positive));
    for (unsigned i = 0; i < n && positive; i++) {
        const long double p = exact_sci(phi[i]), q = exact_sci(phi[(i + 1) % n]);
        if (!side[i].any)
            CHECK_EXACT(exact_sci(side[i].s), q / (p + q),
                        BY_NUM(0x1p-58L, 0x1p-50L, 0x1p-50L) * q / (p + q));
    }
}

static void mean_values_of_any_point_sum_to_one(arb *a)
{
    const loft_real far = BY_NUM(INT32_MAX, (loft_real)0xFFFFF, (loft_real)0xFFFFF),
                    reach = arb_below(a, 2) ? far : LOFT_REAL(1);
    const loft_real low = reach < far ? -reach : BY_NUM(INT32_MIN, -far, -far);
    const loft_spot v[4] = {
        { { low, low } }, { { reach, low } }, { { reach, reach } }, { { low, reach } }
    };
    const loft_spot at = { { extreme_exact(a), extreme_exact(a) } };
    loft_domain d;
    loft_sci phi[4];
    long double sum = 0, most = 0;

    CHECK(loft_domain_init(&d, v, 4) == LOFT_OK);
    CHECK(loft_meanvalue_eval(&d, at, phi) == LOFT_OK);
    for (int i = 0; i < 4; i++) {
        sum += exact_sci(phi[i]);
        most = fmaxl(most, fabsl(exact_sci(phi[i])));
    }
    const long double away = larger(exact_of(at.at[0]), exact_of(at.at[1])) / exact_of(reach) + 1;
    CHECK_EXACT(sum, 1, (1 + most) * away * away * BY_NUM(0x1p-54L, 0x1p-45L, 0x1p-45L));
}

int main(void)
{
    EXTREMES(loft_exact_from_unit, a_parameter_becomes_a_whole_number, 500);
    EXTREMES(loft_acc_lerp_in, a_place_between_any_two_gives_a_value_between, 3000);
    EXTREMES(loft_acc_hypot, a_vector_of_any_axes_has_a_length, 2000);
    EXTREMES(loft_vec_lerp, any_points_have_a_point_between, 2000);
    EXTREMES(loft_vec_exact_sub_axis, any_axis_of_a_difference_is_exact, 1000);
    EXTREMES(loft_forward_init, a_walk_of_any_points_ends_on_the_last_or_is_refused, 2000);
    EXTREMES(loft_span_walk, a_span_of_any_points_ends_on_the_last_or_is_refused, 1000);
    EXTREMES(loft_join_continue, any_alpha_continues_by_the_formula_or_is_refused, 2000);
    EXTREMES(loft_flatten_init, any_curve_is_cut_into_chords, 500);
    EXTREMES(loft_cubic_arclen, the_length_of_any_curve_is_between_its_bounds, 100);
    EXTREMES(loft_polygon_convex, any_number_of_points_is_convex_or_not_backwards_too, 1000);
    EXTREMES(loft_spline_slope, any_place_of_a_spline_has_a_slope, 500);
    EXTREMES(loft_curve_encode, any_curve_comes_out_as_it_went_in, 1000);
    EXTREMES(loft_override_limit_of, any_span_has_an_override_limit, 5000);
    EXTREMES(loft_grid_init, a_grid_of_any_points_ends_on_the_last_or_is_refused, 1000);
    EXTREMES(loft_gb_params, any_shares_have_parameters_or_none, 1000);
    EXTREMES(loft_meanvalue_eval, mean_values_of_any_point_sum_to_one, 1000);
    return check_failures();
}

/* tests/lib/surface/test_barycentric.c -- properties of lib/surface/barycentric.h
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"          /* arb_bary, exact_weight, exact_point */

#define MOST LOFT_TRIANGLE_MAX

static void places_follow_each_other(arb *a)
{
    const unsigned n = arb_below(a, LOFT_DEGREE_MAX + 1);
    unsigned p = 0;

    for (unsigned m = 0; m <= n; m++)
        for (unsigned k = 0; k <= m; k++)
            CHECK(loft_triangle_place(m - k, k) == p++);
    CHECK(p == LOFT_TRIANGLE_POINTS(n));
}

static void a_clamped_point_is_inside(arb *a)
{
    const loft_bary u = arb_bary(a), far = arb_far(a, 100), v = loft_bary_clamp(u),
                    w = loft_bary_clamp(far);
    long double x[3];

    CHECK(loft_bary_inside(v) && loft_bary_inside(w));
    CHECK(!loft_bary_inside(u) ||
          (exact_unit(u.v) - exact_unit(v.v) <= 0 && exact_unit(u.w) - exact_unit(v.w) <= 0));
    exact_bary(w, false, x);
    CHECK(x[0] >= -BY_NUM(0, 0x1p-25L, 0x1p-54L) && x[1] >= 0 && x[2] >= 0);
}

static void weights_are_within_their_bound_and_sum_to_one(arb *a)
{
    const unsigned n = arb_below(a, LOFT_DEGREE_MAX + 1);
    const loft_bary u = arb_bary(a);
    long double x[3], sum = 0;
    loft_acc w[MOST];

    exact_bary(u, false, x);
    loft_bary_weights(n, u, w);
    for (unsigned m = 0, p = 0; m <= n; m++)
        for (unsigned k = 0; k <= m; k++, p++) {
            CHECK_EXACT(exact_acc(w[p]), exact_weight(n - m, m - k, k, x),
                        by_kind(n * 0x1p-31L, 6 * n * 0x1p-52L) + 0x1p-60L);
            sum += exact_acc(w[p]);
        }
    CHECK_EXACT(sum, 1, BY_NUM(0, n * 0x1p-50L, n * 0x1p-50L));
}

/* The weights of a basis, times a net, are the net's value. */
static void rows_are_within_their_bound_anywhere(arb *a)
{
    arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    const loft_bary u = arb_below(a, 3) ? arb_bary(a) : arb_far(a, 1 + (int32_t)arb_below(a, 31));
    loft_acc c[MOST], product = loft_to_acc(LOFT_REAL(1));
    const long double l = fmaxl(1, growth3(u));

    for (unsigned k = 0; k < x->count; k++)
        c[k] = loft_to_acc(x->p[k].axis[0]);
    const bool grows = loft_bary_grows(u, false, x->n, &product);
    CHECK(grows == (powl(l, x->n) <= 19683) || fabsl(powl(l, x->n) / 19683 - 1) < 0x1p-10L);
    if (!grows)
        return;
    const long double want = net_at(x, 0, u), got = exact_acc(loft_bary_eval(c, x->n, u));
    const long double floats = 3 * x->n * powl(l, x->n) * ulp_double(x->largest);
    CHECK_EXACT(got, want,
                by_kind(sums(l, x->n) * 0x1p-33L, floats) + powl(l, x->n) * x->largest * 0x1p-59L);
}

/* Coordinates of a point, and the area, against whole numbers; a float is a multiple of 2^-16
 * here. */
static void coordinates_are_within_their_bound(arb *a)
{
    const int32_t limit = 1 << arb_below(a, 15);
    loft_vec t[3] = { arb_vec(a, limit), arb_vec(a, limit), arb_vec(a, limit) },
             x = arb_vec(a, limit);
    long double want[3], vector[3];
    loft_acc u[3], z[3];
    loft_real area;

    if (arb_below(a, 8) == 0)
        t[2] = t[arb_below(a, 2)];
    const wide whole = exact_point(t, x, want);
    exact_vector(t, x, vector);
    const enum loft_status status = loft_bary_from_point(t, x, u);
    const long double most = fmaxl(fabsl(want[0]), fmaxl(fabsl(want[1]), fabsl(want[2])));
    CHECK(whole == 0 ? status == LOFT_SINGULAR
                     : status == LOFT_OK || (status == LOFT_ERR_RANGE && most > 0x1p29L &&
                                             BY_NUM(true, false, false)));
    for (int k = 0; k < 3 && status == LOFT_OK; k++)
        CHECK_EXACT(exact_acc(u[k]), want[k],
                    by_kind(0x1.01p-33L, 0.51L * ulp_double(want[k])) + fabsl(want[k]) * 0x1p-61L);
    if (loft_bary_from_vector(t, x, z) == LOFT_OK)
        for (int k = 0; k < 3; k++)
            CHECK_EXACT(exact_acc(z[k]), vector[k],
                        by_kind(0x1.01p-33L, 0.51L * ulp_double(vector[k])) +
                            fabsl(vector[k]) * 0x1p-61L);
    const long double size = (long double)whole / 8589934592.0L;
    const enum loft_status measured = loft_bary_area(t, &area);
    CHECK(measured == LOFT_OK ? exact_fits(size) != 0 : exact_fits(size) != 1);
    if (measured == LOFT_OK)
        CHECK_EXACT(exact_of(area), size, 0.51L * ulp(size));
}

static void corners_have_the_coordinates_one_and_zero(arb *a)
{
    const loft_vec t[3] = { arb_vec(a, 30000), arb_vec(a, 30000), arb_vec(a, 30000) };
    loft_acc u[3];
    loft_bary b;

    for (int k = 0; k < 3; k++) {
        if (loft_bary_from_point(t, t[k], u) != LOFT_OK)
            return;
        for (int i = 0; i < 3; i++)
            CHECK_EXACT(exact_acc(u[i]), i == k, 0);
        CHECK(loft_bary_round(u, &b) == LOFT_OK && loft_bary_inside(b));
        CHECK_EXACT(exact_unit(b.v), k == 1, 0);
        CHECK_EXACT(exact_unit(b.w), k == 2, 0);
    }
}

static void a_change_of_triangle_is_within_its_bound(arb *a)
{
    const int32_t far = 1 + (int32_t)arb_below(a, 31);
    const loft_bary q[3] = { arb_far(a, far), arb_far(a, far), arb_far(a, far) },
                    v = arb_below(a, 2) ? arb_bary(a) : arb_far(a, far);
    const loft_bary beyond = { LOFT_UNIT(33), 0 };
    long double x[3][3], y[3], largest = 1;
    loft_acc u[3];

    exact_bary(v, false, y);
    for (int k = 0; k < 3; k++)
        exact_bary(q[k], false, x[k]);
    for (int k = 0; k < 3; k++)
        largest = fmaxl(largest, fmaxl(fabsl(x[k][1]), fabsl(x[k][2])));
    CHECK(loft_bary_change(q, v, u) == LOFT_OK);
    for (int i = 0; i < 3; i++) {
        const long double want = y[0] * x[0][i] + y[1] * x[1][i] + y[2] * x[2][i],
                          floats = 8 * growth3(v) * ulp_double(largest);
        CHECK_EXACT(exact_acc(u[i]), want, by_kind((i ? 1 : 2) * 0x1p-33L, floats) + 0x1p-50L);
    }
    CHECK(loft_bary_change(q, beyond, u) == LOFT_ERR_ARG);
}

static void what_is_too_far_is_refused(arb *a)
{
    const loft_acc far[3] = { 0, loft_to_acc(LOFT_REAL(arb_below(a, 2) ? 33 : -33)), 0 };
    const loft_bary u = { LOFT_UNIT(32.1), 0 };
    loft_acc product = loft_to_acc(LOFT_REAL(1));
    loft_bary b;

    CHECK(loft_bary_round(far, &b) == LOFT_ERR_RANGE);
    CHECK(!loft_bary_grows(u, false, 1, &product) && !loft_bary_grows(u, true, 1, &product));
}

int main(void)
{
    PROPERTY(places_follow_each_other,                        10);
    PROPERTY(a_clamped_point_is_inside,                     2000);
    PROPERTY(weights_are_within_their_bound_and_sum_to_one, 1500);
    PROPERTY(rows_are_within_their_bound_anywhere,          3000);
    PROPERTY(coordinates_are_within_their_bound,            2000);
    PROPERTY(corners_have_the_coordinates_one_and_zero,      500);
    PROPERTY(a_change_of_triangle_is_within_its_bound,      2000);
    PROPERTY(what_is_too_far_is_refused,                      20);
    return check_failures();
}

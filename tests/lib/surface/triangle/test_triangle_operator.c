/* tests/lib/surface/triangle/test_triangle_operator.c -- properties of
 * lib/surface/triangle/triangle_operator.h
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"          /* arb_net_of, exact_polar */
#include "surface/triangle/triangle_operator.h"

static void samples_of(const arb_net *x, loft_real f[])
{
    for (unsigned k = 0; k < x->count; k++)
        f[k] = x->p[k].axis[0];
}

static long double bound_of(const arb_net *x, long double want)
{
    const unsigned n = x->n;
    const long double s = n > 1 ? n * n * n * n / (3.0L * n - 3) : 0;
    return by_kind(LSB / 2 + (n + s) * LSB / 131072 + 0x1p-40L,
                   ulp(want) / 2 + 4 * (n + s) * ulp_double(x->largest));
}

/* Sampled again and again, in long double. */
static long double iterated(const arb_net *x, uint32_t times, loft_bary u)
{
    long double f[LOFT_TRIANGLE_MAX], g[LOFT_TRIANGLE_MAX], at[LOFT_DEGREE_MAX + 1][3];
    const unsigned n = x->n;

    for (unsigned k = 0; k < x->count; k++)
        f[k] = x->c[0][k];
    while (--times) {
        for (unsigned m = 0, p = 0; m <= n; m++)
            for (unsigned k = 0; k <= m; k++, p++) {
                for (unsigned r = 0; r < n; r++) {
                    at[r][0] = (long double)(n - m) / n;
                    at[r][1] = (long double)(m - k) / n;
                    at[r][2] = (long double)k / n;
                }
                g[p] = exact_polar(f, n, at);
            }
        for (unsigned k = 0; k < x->count; k++)
            f[k] = g[k];
    }
    for (unsigned r = 0; r < n; r++)
        exact_bary(u, false, at[r]);
    return exact_polar(f, n, at);
}

static void a_value_is_within_its_bound(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, LOFT_DEGREE_MAX, 32767);
    const uint32_t times = 1 + arb_below(a, arb_below(a, 4) ? 4 : 30);
    const loft_bary u = arb_bary(a);
    loft_real f[LOFT_TRIANGLE_MAX], y;

    samples_of(x, f);
    CHECK(loft_triangle_iterate(f, x->n, times, u, &y) == LOFT_OK);
    const long double want = iterated(x, times, u);
    CHECK_EXACT(exact_of(y), want, bound_of(x, want));
}

/* Anywhere within three times the triangle's size, or farther for low degrees. */
static void a_value_outside_is_within_its_bound(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, LOFT_DEGREE_MAX, 32767);
    const unsigned n = x->n;
    const uint32_t times = 1 + arb_below(a, 4);
    const loft_bary u = arb_far(a, n < 4 ? 12 : 2);
    const long double s = n > 1 ? n * n * n * n / (3.0L * n - 3) : 0, l = growth3(u);
    const long double grown = powl(l, n), want = iterated(x, times, u);
    loft_real f[LOFT_TRIANGLE_MAX], y = LOFT_REAL(77);

    samples_of(x, f);
    const enum loft_status status = loft_triangle_iterate_extrapolate(f, n, times, u, &y);
    if (status == LOFT_OK)
        CHECK_EXACT(exact_of(y), want,
                    by_kind(LSB / 2 + (s * grown + sums(l, n)) * LSB / 131072 + 0x1p-36L,
                            ulp(want) / 2 + 4 * (n + s) * grown * ulp_double(x->largest)));
    else
        CHECK(status == LOFT_ERR_RANGE && y == LOFT_REAL(77) &&
              (grown > 19682 || exact_fits(want) != 1));
    CHECK(status == LOFT_ERR_RANGE || (grown < 19684 && exact_fits(want) != 0));
    CHECK(loft_triangle_iterate_extrapolate(f, n, 0, u, &y) == LOFT_ERR_ARG);
}

/* Inside it is the same; the limit is the plane through the corners, everywhere. */
static void beyond_the_triangle_the_polynomial_goes_on(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, LOFT_DEGREE_MAX, 1000);
    const loft_bary u = arb_bary(a), far = arb_far(a, 10);
    const unsigned at[3] = { 0, loft_triangle_place(x->n, 0), loft_triangle_place(0, x->n) };
    loft_real f[LOFT_TRIANGLE_MAX], y, z;
    long double share[3], want = 0;

    samples_of(x, f);
    CHECK(loft_triangle_iterate(f, x->n, 2, u, &y) == LOFT_OK);
    CHECK(loft_triangle_iterate_extrapolate(f, x->n, 2, u, &z) == LOFT_OK && y == z);
    exact_bary(far, false, share);
    for (int k = 0; k < 3; k++)
        want += share[k] * x->c[0][at[k]];
    CHECK(loft_triangle_iterate_extrapolate(f, x->n, LOFT_FOREVER, far, &y) == LOFT_OK);
    CHECK_EXACT(exact_of(y), want, by_kind(LSB, ulp(want) + 200 * ulp_double(x->largest)));
}

static void planes_stay_and_corners_too(arb *a)
{
    arb_net *x = arb_net_of(a, 1, LOFT_DEGREE_MAX, 32767);
    const loft_bary u = arb_bary(a),
                    corner[3] = { { 0, 0 }, { LOFT_UNIT(1), 0 }, { 0, LOFT_UNIT(1) } };
    const unsigned n = x->n, at[3] = { 0, loft_triangle_place(n, 0), loft_triangle_place(0, n) };
    loft_real f[LOFT_TRIANGLE_MAX], y;
    long double z[3];

    samples_of(x, f);
    for (int k = 0; k < 3; k++) {
        CHECK(loft_triangle_iterate(f, n, 3, corner[k], &y) == LOFT_OK);
        CHECK_EXACT(exact_of(y), x->c[0][at[k]], BY_NUM(0, 0, 0x1p-50L * x->largest));
    }
    for (unsigned m = 0, p = 0; m <= n; m++)            /* whole numbers: the samples of 3 v - 2 w +
                                                         * 7, times n */
        for (unsigned k = 0; k <= m; k++, p++)
            f[p] = loft_real_from_int(3 * (int32_t)(m - k) - 2 * (int32_t)k + 7 * (int32_t)n);
    CHECK(loft_triangle_iterate(f, n, 1 + arb_below(a, 20), u, &y) == LOFT_OK);
    exact_bary(u, false, z);
    x->largest = 100;
    CHECK_EXACT(exact_of(y), n * (3 * z[1] - 2 * z[2] + 7), bound_of(x, 100));
}

static void the_limit_is_reached(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, arb_below(a, 8) ? 3 : LOFT_DEGREE_MAX, 32767);
    const loft_bary u = arb_bary(a);
    loft_real f[LOFT_TRIANGLE_MAX], y, z;

    samples_of(x, f);
    CHECK(loft_triangle_iterate(f, x->n, 512, u, &y) == LOFT_OK &&
          loft_triangle_iterate(f, x->n, LOFT_FOREVER, u, &z) == LOFT_OK);
    CHECK_EXACT(exact_of(y), exact_of(z), 2 * bound_of(x, x->largest));
    CHECK(loft_triangle_iterate(f, 0, 1, u, &y) == LOFT_ERR_ARG &&
          loft_triangle_iterate(f, 10, 1, u, &y) == LOFT_ERR_ARG);
    CHECK(loft_triangle_iterate(f, x->n, 0, u, &y) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_value_is_within_its_bound,  150);
    PROPERTY(a_value_outside_is_within_its_bound, 400);
    PROPERTY(beyond_the_triangle_the_polynomial_goes_on, 200);
    PROPERTY(planes_stay_and_corners_too,  150);
    PROPERTY(the_limit_is_reached,           8);
    return check_failures();
}

/* tests/lib/surface/triangle/test_triangle_pieces.c -- properties of
 * lib/surface/triangle/triangle_pieces.h
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"          /* arb_net_of, exact_polar, rows_bound */
#include "surface/triangle/triangle_pieces.h"

#define MOST LOFT_TRIANGLE_MAX

static loft_triangle triangle_of(const arb_net *x)
{
    loft_triangle t = { 0, 0 };
    CHECK(loft_triangle_init(&t, x->p, x->n) == LOFT_OK);
    return t;
}

/* b[at0^i, at1^j, at2^k] for one control point of the piece with these corners. */
static long double piece(const arb_net *x, int axis, long double at[3][3], unsigned j, unsigned k)
{
    long double all[LOFT_DEGREE_MAX + 1][3];

    for (unsigned r = 0; r < x->n; r++)
        for (int e = 0; e < 3; e++)
            all[r][e] = at[r < j ? 1 : r < j + k ? 2 : 0][e];
    return exact_polar(x->c[axis], x->n, all);
}

static void check_piece(const arb_net *x, long double at[3][3], const loft_vec p[],
                        long double growth, bool halves)
{
    for (unsigned m = 0, q = 0; m <= x->n; m++)
        for (unsigned k = 0; k <= m; k++, q++)
            for (int i = 0; i < LOFT_AXES; i++) {
                const long double want = piece(x, i, at, m - k, k);
                const long double bound =
                    halves ? by_kind(LSB / 2, ulp(want) / 2 + x->n * ulp_double(x->largest) / 2)
                           : rows_bound(x, x->n, growth, want);
                CHECK_EXACT(exact_of(p[q].axis[i]), want,
                            bound + powl(growth, x->n) * x->largest * 0x1p-58L);
            }
}

static void exact_corners(long double at[3][3])
{
    for (int k = 0; k < 3; k++)
        for (int e = 0; e < 3; e++)
            at[k][e] = k == e;
}

static void a_split_is_within_its_bound(arb *a)
{
    const bool beyond = arb_below(a, 3) == 0;
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, beyond ? 20 : 32767);
    const loft_triangle t = triangle_of(x);
    const loft_bary u = beyond ? arb_far(a, 1) : arb_bary(a);
    loft_vec part[3][MOST];
    long double at[3][3];

    const enum loft_status status = loft_triangle_split(&t, u, part[0], part[1], part[2]);
    CHECK(status == LOFT_OK ||
          (status == LOFT_ERR_RANGE && powl(growth3(u), x->n) * x->largest > 16383));
    for (int k = 0; k < 3 && status == LOFT_OK; k++) {
        exact_corners(at);
        exact_bary(u, false, at[k]);
        check_piece(x, at, part[k], fmaxl(1, growth3(u)), false);
    }
}

/* The midpoints of the edges are exact. Pieces that meet have the same control points. */
static void quarters_are_within_their_bound_and_join(arb *a)
{
    static const unsigned corner[4][3] = { { 0, 3, 4 }, { 3, 1, 5 }, { 4, 5, 2 }, { 5, 4, 3 } };
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    const loft_triangle t = triangle_of(x);
    loft_vec part[4][MOST];
    long double at[6][3], own[3][3];

    exact_corners(at);
    for (int e = 0; e < 3; e++) {
        at[3][e] = e == 2 ? 0 : 0.5L;
        at[4][e] = e == 1 ? 0 : 0.5L;
        at[5][e] = e == 0 ? 0 : 0.5L;
    }
    for (unsigned k = 0; k < 4; k++) {
        CHECK(loft_triangle_quarter(&t, k, part[k]) == LOFT_OK);
        for (int c = 0; c < 3; c++)
            for (int e = 0; e < 3; e++)
                own[c][e] = at[corner[k][c]][e];
        check_piece(x, own, part[k], 1, true);
    }
    for (unsigned k = 0; k <= x->n; k++) {      /* M12 M13, M12 M23, M13 M23 */
        const unsigned edge[3] = { loft_triangle_place(x->n - k, k), loft_triangle_place(0, k),
                                   loft_triangle_place(k, 0) };
        const unsigned inner[3] = { loft_triangle_place(k, x->n - k),
                                    loft_triangle_place(0, x->n - k),
                                    loft_triangle_place(x->n - k, 0) };
        for (int i = 0; i < LOFT_AXES; i++) {
            const long double same = BY_NUM(0, ulp(x->largest), x->n * ulp(x->largest));
            CHECK_EXACT(exact_of(part[0][edge[0]].axis[i]), exact_of(part[3][inner[0]].axis[i]),
                        same);
            CHECK_EXACT(exact_of(part[1][edge[1]].axis[i]), exact_of(part[3][inner[1]].axis[i]),
                        same);
            CHECK_EXACT(exact_of(part[2][edge[2]].axis[i]), exact_of(part[3][inner[2]].axis[i]),
                        same);
        }
    }
    CHECK(loft_triangle_quarter(&t, 4, part[0]) == LOFT_ERR_ARG);
}

static void a_part_is_within_its_bound_and_the_same_surface(arb *a)
{
    const bool beyond = arb_below(a, 3) == 0;
    const arb_net *x = arb_net_of(a, 0, beyond ? 4 : LOFT_DEGREE_MAX, beyond ? 20 : 32767);
    const loft_triangle t = triangle_of(x);
    loft_bary corner[3];
    loft_vec out[MOST];
    long double at[3][3], growth = 1;

    for (int k = 0; k < 3; k++) {
        corner[k] = beyond ? arb_far(a, 1) : arb_bary(a);
        exact_bary(corner[k], false, at[k]);
        growth = fmaxl(growth, growth3(corner[k]));
    }
    const enum loft_status status = loft_triangle_sub(&t, corner, out);
    CHECK(status == LOFT_OK ||
          (status == LOFT_ERR_RANGE && powl(growth, x->n) * x->largest > 16383));
    if (status == LOFT_OK)
        check_piece(x, at, out, growth, false);
}

/* The elevated surface has the same value. Repeated elevation by one gives the same control
 * points. */
static void a_raised_triangle_is_within_its_bound(arb *a)
{
    static long double c[LOFT_TRIANGLE_POINTS(LOFT_BEZIER_ELEVATE_MAX)],
        next[LOFT_TRIANGLE_POINTS(LOFT_BEZIER_ELEVATE_MAX)];
    static loft_vec out[LOFT_TRIANGLE_POINTS(LOFT_BEZIER_ELEVATE_MAX)];
    const arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, 32767);
    const loft_triangle t = triangle_of(x);
    const unsigned times = arb_below(a, LOFT_BEZIER_ELEVATE_MAX - x->n + 1);
    const bool steps = x->n + times > LOFT_ELEVATE_MAX;

    CHECK(loft_triangle_elevate(&t, times, out) == LOFT_OK);
    CHECK(loft_triangle_elevate(&t, LOFT_BEZIER_ELEVATE_MAX - x->n + 1, out) == LOFT_ERR_ARG);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k < x->count; k++)
            c[k] = x->c[i][k];
        for (unsigned n = x->n + 1; n <= x->n + times; n++) {
            for (unsigned m = 0, p = 0; m <= n; m++)
                for (unsigned k = 0; k <= m; k++, p++) {
                    const unsigned j = m - k;
                    next[p] = ((m < n ? (n - m) * c[p] : 0) +
                               (j ? j * c[loft_triangle_place(j - 1, k)] : 0) +
                               (k ? k * c[loft_triangle_place(j, k - 1)] : 0)) /
                              n;
                }
            for (unsigned p = 0; p < LOFT_TRIANGLE_POINTS(n); p++)
                c[p] = next[p];
        }
        for (unsigned p = 0; p < LOFT_TRIANGLE_POINTS(x->n + times); p++)
            CHECK_EXACT(
                exact_of(out[p].axis[i]), c[p],
                by_kind(LSB / 2 + (steps ? x->n : 1) * LSB / 131072 + 0x1p-40L,
                        ulp(c[p]) / 2 + ((steps ? 2 : 1) * x->n + 3) * ulp_double(x->largest)));
    }
}

/* Against the value of the power form at any point. */
static void power_coefficients_make_the_same_surface(arb *a)
{
    arb_net *x = arb_net_of(a, 0, LOFT_DEGREE_MAX, arb_below(a, 2) ? 32767 : 500);
    const loft_bary u = arb_bary(a);
    long double at[3], largest = 0;
    loft_vec out[MOST];
    arb_net y;

    const enum loft_status status = loft_triangle_from_power(x->p, x->n, out);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double sum = 0;
        for (unsigned k = 0; k < x->count; k++)
            sum += fabsl(x->c[i][k]);
        largest = fmaxl(largest, sum);
    }
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && largest > 32767));
    if (status != LOFT_OK)
        return;
    y.n = x->n;
    y.count = x->count;
    exact_bary(u, false, at);
    for (unsigned k = 0; k < x->count; k++)
        y.p[k] = out[k];
    measure_net(&y);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double want = 0;
        for (unsigned m = 0, p = 0; m <= x->n; m++)
            for (unsigned r = 0; r <= m; r++, p++)
                want += x->c[i][p] * powl(at[1], m - r) * powl(at[2], r);
        CHECK_EXACT(net_at(&y, i, u), want,
                    by_kind(LSB / 2 + x->n * x->n * LSB / 131072 + 0x1p-40L,
                            ulp(y.largest) / 2 +
                                (x->n + 1) * (x->n + 1) * (x->n + 2) * ulp_double(x->largest) +
                                largest * 0x1p-58L));
    }
    CHECK(loft_triangle_from_power(x->p, LOFT_DEGREE_MAX + 1, out) == LOFT_ERR_ARG);
}

static bool same(const loft_vec p[], const loft_vec q[], unsigned count)
{
    for (unsigned k = 0; k < count; k++)
        if (!loft_vec_equal(p[k], q[k]))
            return false;
    return true;
}

static void results_may_replace_the_control_points(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, 5, 300);
    static loft_vec p[LOFT_TRIANGLE_POINTS(LOFT_ELEVATE_MAX)],
        out[LOFT_TRIANGLE_POINTS(LOFT_ELEVATE_MAX)];
    const loft_triangle t = triangle_of(x);
    const loft_bary corner[3] = { arb_bary(a), arb_bary(a), arb_bary(a) };
    loft_vec part[3][MOST];
    loft_triangle own;

    CHECK(loft_triangle_split(&t, corner[0], part[0], part[1], part[2]) == LOFT_OK);
    for (int way = 0; way < 7; way++) {
        unsigned count = x->count;
        for (unsigned k = 0; k < x->count; k++)
            p[k] = x->p[k];
        CHECK(loft_triangle_init(&own, p, x->n) == LOFT_OK);
        if (way < 3) {
            loft_vec other[2][MOST];
            CHECK(loft_triangle_split(&own, corner[0], way == 0 ? p : other[0],
                                      way == 1 ? p : other[way == 0 ? 0 : 1],
                                      way == 2 ? p : other[1]) == LOFT_OK);
            CHECK(same(p, part[way], count));
            continue;
        }
        if (way == 3)
            CHECK(loft_triangle_quarter(&t, 3, out) == LOFT_OK &&
                  loft_triangle_quarter(&own, 3, p) == LOFT_OK);
        if (way == 4)
            CHECK(loft_triangle_sub(&t, corner, out) == LOFT_OK &&
                  loft_triangle_sub(&own, corner, p) == LOFT_OK);
        if (way == 5)
            CHECK(loft_triangle_elevate(&t, 3, out) == LOFT_OK &&
                  loft_triangle_elevate(&own, 3, p) == LOFT_OK);
        if (way == 6)
            CHECK(loft_triangle_from_power(x->p, x->n, out) == LOFT_OK &&
                  loft_triangle_from_power(p, x->n, p) == LOFT_OK);
        count = way == 5 ? LOFT_TRIANGLE_POINTS(x->n + 3) : count;
        CHECK(same(p, out, count));
    }
}

int main(void)
{
    PROPERTY(a_split_is_within_its_bound,                       1000);
    PROPERTY(quarters_are_within_their_bound_and_join,          400);
    PROPERTY(a_part_is_within_its_bound_and_the_same_surface,   600);
    PROPERTY(a_raised_triangle_is_within_its_bound,             400);
    PROPERTY(power_coefficients_make_the_same_surface,         2000);
    PROPERTY(results_may_replace_the_control_points,            400);
    return check_failures();
}

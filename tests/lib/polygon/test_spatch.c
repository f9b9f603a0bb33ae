/* tests/lib/polygon/test_spatch.c -- properties of lib/polygon/spatch.h, multiindex.h and
 * weighted_sum.h
 * SPDX-License-Identifier: MIT
 */
#include "support/arb_patch.h"              /* arb_net, arb_domain */
#include "curve/rational.h"
#include "polygon/meanvalue.h"
#include "polygon/spatch.h"
#include "polygon/wachspress.h"
#include "surface/tensor/tensor.h"
#include "surface/triangle/triangle.h"

static net points, other;

/* Any size that fits the arrays. */
static loft_spatch arb_spatch(arb *a, unsigned sides, bool rational)
{
    unsigned depth = 1 + arb_below(a, LOFT_DEGREE_MAX);
    loft_spatch s = { 0, 0, 0, 0 };

    while (loft_multiindex_count(sides, depth) > PATCH_POINTS)
        depth--;
    arb_net(a, &points, loft_multiindex_count(sides, depth));
    CHECK(loft_spatch_init(&s, points.p, rational ? points.w : NULL, sides, depth) == LOFT_OK);
    return s;
}

/* Coordinates >= 0 that sum to 1, not of a particular polygon. */
static void arb_phi(arb *a, unsigned n, loft_sci phi[])
{
    int32_t left = 1 << 20;

    for (unsigned i = 0; i < n; i++) {
        const int32_t part = i + 1 < n
                                 ? (int32_t)arb_below(a, (uint32_t)left + 1) >> arb_below(a, 4)
                                 : left;
        left -= part;
        phi[i] = loft_sci_div(loft_sci_from_int(part), loft_sci_from_int(1 << 20));
    }
}

/* The definition, with factorials. */
static void exact_spatch(const loft_spatch *s, const loft_sci phi[], long double out[LOFT_AXES])
{
    static const long double factorial[10] = { 1, 1, 2, 6, 24, 120, 720, 5040, 40320, 362880 };
    uint8_t l[LOFT_SIDES_MAX];
    long double w = 0;
    unsigned k = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = 0;
    loft_multiindex_first(l, s->sides, s->depth);
    do {
        long double b = factorial[s->depth];
        for (unsigned i = 0; i < s->sides; i++)
            b *= power(exact_sci(phi[i]), l[i]) / factorial[l[i]];
        b *= s->w ? exact_of(s->w[k]) : 1;
        w += b;
        for (int i = 0; i < LOFT_AXES; i++)
            out[i] += b * exact_of(s->p[k].axis[i]);
        k++;
    } while (loft_multiindex_next(l, s->sides));
    for (int i = 0; i < LOFT_AXES && s->w; i++)
        out[i] /= w;
}

static void ranks_count_all_indices_in_order(arb *a)
{
    const unsigned n = 3 + arb_below(a, 6), d = arb_below(a, n > 6 ? 6 : LOFT_DEGREE_MAX + 2);
    uint8_t l[LOFT_SIDES_MAX];
    unsigned rank = 0;

    loft_multiindex_first(l, n, d);
    do {
        unsigned sum = 0;
        for (unsigned i = 0; i < n; i++)
            sum += l[i];
        CHECK(sum == d && loft_multiindex_rank(l, n) == rank);
        rank++;
    } while (loft_multiindex_next(l, n));
    CHECK(rank == loft_multiindex_count(n, d) && l[n - 1] == d);
}

static void both_roads_are_within_the_bound(arb *a)
{
    static loft_sci work[PATCH_POINTS];
    const loft_spatch s = arb_spatch(a, 3 + arb_below(a, 6), arb_below(a, 2));
    loft_sci phi[LOFT_SIDES_MAX];
    long double want[LOFT_AXES];
    loft_vec u = { { 0 } }, v = { { 0 } };

    arb_phi(a, s.sides, phi);
    exact_spatch(&s, phi, want);
    CHECK(loft_spatch_eval(&s, phi, &u) == LOFT_OK &&
          loft_spatch_casteljau(&s, phi, work, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        check_axis(u.axis[i], want[i], points.largest, s.w ? 0x1p-9L : 0x1p-14L, 128);
        check_axis(v.axis[i], want[i], points.largest, 0x1p-14L, 128);
    }
}

/* Beside a polygon coordinates are negative: the patch continues, or reports that it does not
 * fit. */
static void outside_of_a_polygon_the_bound_grows(arb *a)
{
    arb_domain p = arb_simple(a);
    loft_sci phi[LOFT_SIDES_MAX];
    long double want[LOFT_AXES], sum = 0;
    loft_vec v = { { 0 } };
    bool fits = true, near = false;

    settle(&p);
    const loft_spatch s = arb_spatch(a, p.n, false);
    CHECK(loft_meanvalue_eval(&p.d, arb_near(a, &p), phi) == LOFT_OK);
    for (unsigned i = 0; i < p.n; i++)
        sum += fabsl(exact_sci(phi[i]));
    const long double gain = 1 + power(sum, s.depth);
    exact_spatch(&s, phi, want);
    for (int i = 0; i < LOFT_AXES; i++) {
        fits = fits && BY_NUM(fabsl(want[i]) < 32767, true, true);
        near = near || fabsl(fabsl(want[i]) - 32768) < 2 + gain * 1e-9L;
    }
    const enum loft_status status = loft_spatch_eval(&s, phi, &v);
    CHECK(near || status == (fits ? LOFT_OK : LOFT_ERR_RANGE));
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++)
        check_axis(v.axis[i], want[i], points.largest, gain * 0x1p-15L, 64 * gain);
}

/* Bit for bit, at parameters that a loft_unit holds; with another digit, within the bound of the
 * curve. */
static void edges_are_the_curves_of_their_points(arb *a)
{
    const bool rational = arb_below(a, 2);
    const loft_spatch s = arb_spatch(a, 3 + arb_below(a, 6), rational);
    const unsigned e = arb_below(a, s.sides), f = (e + 1) % s.sides, d = s.depth;
    const loft_unit t = arb_unit(a);
    loft_sci phi[LOFT_SIDES_MAX];
    loft_weighted w[LOFT_DEGREE_MAX + 1];
    loft_vec p[LOFT_DEGREE_MAX + 1], v = { { 0 } };
    loft_rational r;
    loft_bezier b;

    for (unsigned k = 0; k <= d; k++) {
        uint8_t l[LOFT_SIDES_MAX] = { 0 };
        l[e] = (uint8_t)(d - k);
        l[f] = (uint8_t)k;
        w[k].p = p[k] = s.p[loft_multiindex_rank(l, s.sides)];
        w[k].w = points.w[loft_multiindex_rank(l, s.sides)];
    }
    for (unsigned i = 0; i < s.sides; i++)
        phi[i] = loft_sci_zero();
    phi[f] = loft_sci_from_unit(t);
    phi[e] = loft_sci_sub(loft_sci_one(), phi[f]);
    CHECK(loft_spatch_eval(&s, phi, &v) == LOFT_OK);
    CHECK(loft_rational_init(&r, w, d) == LOFT_OK && loft_bezier_init(&b, p, d) == LOFT_OK);
    check_same(v, rational ? loft_rational_eval(&r, t) : loft_bezier_eval(&b, t));

    const loft_sci third = loft_sci_div(loft_sci_from_int(1 + (int32_t)arb_below(a, 2)),
                                        loft_sci_from_int(3));
    long double want[LOFT_AXES];
    phi[f] = third;
    phi[e] = loft_sci_sub(loft_sci_one(), third);
    exact_spatch(&s, phi, want);
    CHECK(loft_spatch_eval(&s, phi, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        check_axis(v.axis[i], want[i], points.largest, 0x1p-16L, 8 * d + 30);
}

static void corners_are_control_points(arb *a)
{
    const loft_spatch s = arb_spatch(a, 3 + arb_below(a, 6), arb_below(a, 2));
    const unsigned corner = arb_below(a, s.sides);
    loft_sci phi[LOFT_SIDES_MAX];
    uint8_t l[LOFT_SIDES_MAX] = { 0 };
    loft_vec v = { { 0 } };

    l[corner] = s.depth;
    for (unsigned i = 0; i < s.sides; i++)
        phi[i] = i == corner ? loft_sci_one() : loft_sci_zero();
    CHECK(loft_spatch_eval(&s, phi, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(s.p[loft_multiindex_rank(l, s.sides)].axis[i]),
                    s.w ? BY_NUM(0, ulp(points.largest), ulp(points.largest)) : 0);
}

static void raising_changes_nothing(arb *a)
{
    const unsigned sides = 3 + arb_below(a, 3);
    loft_spatch s = arb_spatch(a, sides, arb_below(a, 2)), raised = s;
    loft_sci phi[LOFT_SIDES_MAX];
    long double want[LOFT_AXES], got[LOFT_AXES];

    if (s.depth == LOFT_DEGREE_MAX || loft_multiindex_count(sides, s.depth + 1u) > PATCH_POINTS) {
        CHECK(s.depth < LOFT_DEGREE_MAX ||
              loft_spatch_elevate(&s, other.p, other.w) == LOFT_ERR_ARG);
        return;
    }
    CHECK(loft_spatch_elevate(&s, other.p, other.w) == LOFT_OK);
    CHECK(loft_spatch_init(&raised, other.p, s.w ? other.w : NULL, sides, s.depth + 1u) == LOFT_OK);
    arb_phi(a, sides, phi);
    exact_spatch(&s, phi, want);
    exact_spatch(&raised, phi, got);
    for (int i = 0; i < LOFT_AXES; i++) {
        /* weights are rounded too: 2^-17 of 1/256 at the least, 2^-24, 2^-51, of the distance of
         * two points */
        const long double moved = s.w ? 2 * points.largest * BY_NUM(0x1p-8L, 0x1p-23L, 0x1p-50L)
                                      : 0;
        CHECK_EXACT(got[i], want[i],
                    BY_NUM(0.51L * LSB, ulp(points.largest), 32 * ulp(points.largest)) + moved);
    }
}

static void three_sides_make_a_triangle(arb *a)
{
    const loft_spatch s = arb_spatch(a, 3, false);
    const loft_unit j = arb_unit(a), k = loft_unit_of(arb_below(a, 1025), 1024);
    loft_triangle t;
    loft_vec v = { { 0 } };

    if (j + k > LOFT_UNIT(1))
        return;
    const loft_bary u = { j, k };
    const loft_sci phi[3] = { loft_sci_sub(loft_sci_sub(loft_sci_one(), loft_sci_from_unit(j)),
                                           loft_sci_from_unit(k)),
                              loft_sci_from_unit(j), loft_sci_from_unit(k) };
    CHECK(loft_triangle_init(&t, s.p, s.depth) == LOFT_OK &&
          loft_spatch_eval(&s, phi, &v) == LOFT_OK);
    const loft_vec w = loft_triangle_eval(&t, u);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(w.axis[i]),
                    BY_NUM(1, 2, 64) * ulp(points.largest));
}

/* A square, and a parallelogram that is not a square, with sides 2^-k. */
static void four_sides_over_a_parallelogram_make_a_tensor_product(arb *a)
{
    const loft_spatch s = arb_spatch(a, 4, false);
    const unsigned n = s.depth + 1u;
    const int32_t skew = (int32_t)arb_below(a, 3) * 1000, size = 65536,
                  x = (int32_t)arb_below(a, 65537), y = (int32_t)arb_below(a, 65537);
    const loft_spot v[4] = { spot_raw(0, 0), spot_raw(size, 0), spot_raw(size + skew, size),
                             spot_raw(skew, size) };
    const int64_t across = (int64_t)skew * y / 65536;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_domain d;
    loft_tensor t;
    loft_vec got = { { 0 } };

    if (across * 65536 != (int64_t)skew * y)
        return;
    CHECK(loft_spatch_tensor(&s, other.p, NULL) == LOFT_OK &&
          loft_tensor_init(&t, other.p, n - 1, n - 1) == LOFT_OK);
    CHECK(loft_domain_init(&d, v, 4) == LOFT_OK &&
          loft_wachspress_eval(&d, spot_raw(x + across, y), phi) == LOFT_OK);
    CHECK(loft_spatch_eval(&s, phi, &got) == LOFT_OK);
    const loft_vec want = loft_tensor_eval(&t, loft_unit_from(loft_real_from_raw(x)),
                                           loft_unit_from(loft_real_from_raw(y)));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(got.axis[i]), exact_of(want.axis[i]),
                    BY_NUM(1.51L * LSB, 2 * ulp(points.largest), 128 * ulp(points.largest)));
}

static void a_rational_tensor_form_is_the_same_surface(arb *a)
{
    loft_spatch s = arb_spatch(a, 4, true);
    const unsigned n = s.depth + 1u;
    const long double u = arb_below(a, 1001) / 1000.0L, v = arb_below(a, 1001) / 1000.0L;
    const int32_t x = (int32_t)lroundl(u * 1048576), y = (int32_t)lroundl(v * 1048576);
    const loft_sci m = loft_sci_from_int(1 << 20), fx = loft_sci_div(loft_sci_from_int(x), m),
                   fy = loft_sci_div(loft_sci_from_int(y), m);
    const loft_sci gx = loft_sci_sub(loft_sci_one(), fx), gy = loft_sci_sub(loft_sci_one(), fy);
    const loft_sci phi[4] = { loft_sci_mul(gx, gy), loft_sci_mul(fx, gy), loft_sci_mul(fx, fy),
                              loft_sci_mul(gx, fy) };
    long double want[LOFT_AXES], got[LOFT_AXES] = { 0 }, w = 0;

    CHECK(loft_spatch_tensor(&s, other.p, other.w) == LOFT_OK);
    exact_spatch(&s, phi, want);
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < n; j++) {
            const long double b = loft_binomial(n - 1, i) * power(x / 1048576.0L, i) *
                                  power(1 - x / 1048576.0L, n - 1 - i) * loft_binomial(n - 1, j) *
                                  power(y / 1048576.0L, j) * power(1 - y / 1048576.0L, n - 1 - j) *
                                  exact_of(other.w[i * n + j]);
            w += b;
            for (int k = 0; k < LOFT_AXES; k++)
                got[k] += b * exact_of(other.p[i * n + j].axis[k]);
        }
    for (int k = 0; k < LOFT_AXES; k++)
        CHECK_EXACT(got[k] / w, want[k],
                    BY_NUM(0.51L * LSB, ulp(points.largest), 32 * ulp(points.largest)) +
                        2 * points.largest * BY_NUM(0x1p-8L, 0x1p-23L, 0x1p-50L));
}

/* Adding a whole number of LSB to every point adds it to the surface; in q16 bit for bit. */
static void a_moved_net_moves_the_surface(arb *a)
{
    const loft_spatch s = arb_spatch(a, 3 + arb_below(a, 6), false);
    loft_spatch m = s;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_vec u = { { 0 } }, v = { { 0 } };
    const loft_real by = loft_real_from_raw((int32_t)arb_below(a, 1 << 20));

    if (points.largest > 16000)
        return;
    for (unsigned k = 0; k < loft_multiindex_count(s.sides, s.depth); k++)
        for (int i = 0; i < LOFT_AXES; i++)
            other.p[k].axis[i] = s.p[k].axis[i] + by;
    m.p = other.p;
    arb_phi(a, s.sides, phi);
    CHECK(loft_spatch_eval(&s, phi, &u) == LOFT_OK && loft_spatch_eval(&m, phi, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(u.axis[i]) + exact_of(by),
                    BY_NUM(LSB, 4 * ulp(points.largest + 16), 256 * ulp(points.largest + 16)));
}

static void the_surface_stays_within_its_points(arb *a)
{
    const loft_spatch s = arb_spatch(a, 3 + arb_below(a, 6), arb_below(a, 2));
    const unsigned count = loft_multiindex_count(s.sides, s.depth);
    loft_sci phi[LOFT_SIDES_MAX];
    loft_vec v = { { 0 } };

    arb_phi(a, s.sides, phi);
    CHECK(loft_spatch_eval(&s, phi, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double low = INFINITY, high = -INFINITY;
        for (unsigned k = 0; k < count; k++) {
            low = fminl(low, exact_of(s.p[k].axis[i]));
            high = fmaxl(high, exact_of(s.p[k].axis[i]));
        }
        const long double slack = BY_NUM(0, 1, 64) * ulp(points.largest);
        CHECK(exact_of(v.axis[i]) >= low - slack && exact_of(v.axis[i]) <= high + slack);
    }
}

/* l - e_r = m - e_(r+1), each pair once, and all of them. */
static void links_are_the_edges_of_the_net(arb *a)
{
    static uint8_t l[PATCH_POINTS][LOFT_SIDES_MAX];
    static bool seen[PATCH_POINTS][LOFT_SIDES_MAX];
    const loft_spatch s = arb_spatch(a, 3 + arb_below(a, 6), false);
    const unsigned n = s.sides, count = loft_multiindex_count(n, s.depth);
    unsigned from, to, edges = 0;
    loft_links w;

    loft_multiindex_first(l[0], n, s.depth);
    for (unsigned k = 1; k < count; k++) {
        for (unsigned i = 0; i < n; i++)
            l[k][i] = l[k - 1][i];
        loft_multiindex_next(l[k], n);
    }
    for (unsigned k = 0; k < count; k++)
        for (unsigned i = 0; i < n; i++)
            seen[k][i] = false;
    for (loft_links_start(&w, n, s.depth); loft_links_next(&w, &from, &to); edges++) {
        unsigned differ = 0, r = n;
        for (unsigned i = 0; i < n; i++) {
            differ += l[from][i] != l[to][i];
            if (l[from][i] == l[to][i] + 1)
                r = i;
        }
        CHECK(differ == 2 && r < n && l[to][(r + 1) % n] == l[from][(r + 1) % n] + 1 &&
              !seen[from][r]);
        seen[from][r < n ? r : 0] = true;
    }
    CHECK(edges == n * loft_multiindex_count(n, s.depth - 1u));
}

static void nonsense_is_refused(arb *a)
{
    loft_spatch s = arb_spatch(a, 4, true), t = { .sides = 77 };
    const unsigned k = arb_below(a, loft_multiindex_count(4, s.depth));

    CHECK(loft_spatch_init(&t, points.p, NULL, 2, 3) == LOFT_ERR_ARG &&
          loft_spatch_init(&t, points.p, NULL, 9, 3) == LOFT_ERR_ARG);
    CHECK(loft_spatch_init(&t, points.p, NULL, 3, 0) == LOFT_ERR_ARG &&
          loft_spatch_init(&t, points.p, NULL, 3, 10) == LOFT_ERR_ARG);
    points.w[k] = arb_below(a, 2) ? 0 : loft_real_from_raw(256 * 65536 + 64);
    CHECK(loft_spatch_init(&t, points.p, points.w, 4, s.depth) == LOFT_ERR_RANGE);
    points.w[k] = LOFT_REAL(1);
    points.p[k].axis[0] = (loft_real)BY_NUM(0, NAN, NAN);
    CHECK(loft_spatch_init(&t, points.p, points.w, 4, s.depth) ==
          BY_NUM(LOFT_OK, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
    CHECK(BY_NUM(true, t.sides == 77, t.sides == 77));
    s.sides = 5;
    CHECK(loft_spatch_tensor(&s, other.p, other.w) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(ranks_count_all_indices_in_order,                       60);
    PROPERTY(both_roads_are_within_the_bound,                       250);
    PROPERTY(outside_of_a_polygon_the_bound_grows,                  400);
    PROPERTY(edges_are_the_curves_of_their_points,                 1000);
    PROPERTY(corners_are_control_points,                            300);
    PROPERTY(raising_changes_nothing,                               150);
    PROPERTY(three_sides_make_a_triangle,                           400);
    PROPERTY(four_sides_over_a_parallelogram_make_a_tensor_product, 300);
    PROPERTY(a_rational_tensor_form_is_the_same_surface,            200);
    PROPERTY(a_moved_net_moves_the_surface,                         200);
    PROPERTY(the_surface_stays_within_its_points,                   200);
    PROPERTY(links_are_the_edges_of_the_net,                         60);
    PROPERTY(nonsense_is_refused,                                   100);
    return check_failures();
}

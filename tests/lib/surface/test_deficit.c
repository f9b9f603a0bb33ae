/* tests/lib/surface/test_deficit.c -- properties of lib/surface/deficit.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_sci.h"                  /* exact_of */
#include "surface/deficit.h"

#define RING 8

static loft_vec at_raw(const int64_t raw[3])
{
    loft_vec p;

    for (int k = 0; k < 3; k++)
        p.axis[k] = loft_real_from_raw((int32_t)raw[k]);
    return p;
}

static void offset(const loft_vec *from, const loft_vec *to, long double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = exact_of(to->axis[k]) - exact_of(from->axis[k]);
}

static long double dot(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static long double length(const long double a[3]) { return sqrtl(dot(a, a)); }

/* By the law of sines and Kahan's formula for the angle between two vectors, without products. */
static long double angle_between(const long double a[3], const long double b[3])
{
    long double sum[3], difference[3];

    for (int k = 0; k < 3; k++) {
        sum[k] = a[k] / length(a) + b[k] / length(b);
        difference[k] = a[k] / length(a) - b[k] / length(b);
    }
    return 2 * atan2l(length(difference), length(sum));
}

static void exact_deficit(const loft_vec *vertex, const loft_vec ring[], unsigned n,
                          long double *angles, long double *area, long double *squares)
{
    *angles = *area = *squares = 0;
    for (unsigned i = 0; i < n; i++) {
        long double a[3], b[3], c[3], back[3];
        offset(vertex, &ring[i], a);
        offset(vertex, &ring[(i + 1) % n], b);
        offset(&ring[i], &ring[(i + 1) % n], c);
        for (int k = 0; k < 3; k++)
            back[k] = -a[k];
        const long double here = angle_between(a, b), there = angle_between(back, c),
                          right = acosl(-1) / 2;
        const long double half = length(a) * length(b) * sinl(here) / 2,
                          last = 2 * right - here - there;
        *angles += here;
        *squares += dot(a, a);
        if (here > right)
            *area += half / 2;
        else if (there > right || last > right)
            *area += half / 4;
        else
            *area += (dot(a, a) / tanl(last) + dot(b, b) / tanl(there)) / 8;
    }
}

/* Around the vertex, at any distances, up and down. */
static unsigned arb_ring(arb *a, loft_vec *vertex, loft_vec ring[])
{
    const unsigned n = 3 + arb_below(a, RING - 2);
    const int32_t sizes[4] = { 30, 4000, 65536, 20 * 65536 }, size = sizes[arb_below(a, 4)];
    int64_t raw[3], centre[3];

    for (int k = 0; k < 3; k++)
        centre[k] = (int64_t)arb_below(a, 2 * 65536) - 65536;
    *vertex = at_raw(centre);
    for (unsigned i = 0; i < n; i++) {
        const double t = 6.283185307179586 * (i + 0.9 * arb_below(a, 1000) / 1000) / n,
                     r = size * (0.1 + 0.9 * arb_below(a, 1000) / 1000);
        raw[0] = centre[0] + lround(r * cos(t));
        raw[1] = centre[1] + lround(r * sin(t));
        raw[2] = centre[2] + (int64_t)arb_below(a, (uint32_t)size) - size / 2;
        ring[i] = at_raw(raw);
    }
    return n;
}

static void angles_area_and_curvature_hold_their_bounds(arb *a)
{
    loft_vec vertex, ring[RING];
    const unsigned n = arb_ring(a, &vertex, ring);
    long double angles, area, squares;
    loft_deficit d;

    CHECK(loft_deficit_eval(&vertex, ring, n, &d) == LOFT_OK);
    exact_deficit(&vertex, ring, n, &angles, &area, &squares);
    const long double angle_off = n * BY_NUM(0x1p-54L, 0x1p-48L, 0x1p-48L),
                      area_off = squares * BY_NUM(0x1p-55L, 0x1p-46L, 0x1p-46L);
    const long double gauss = (2 * acosl(-1) - angles) / area;
    CHECK_NEAR(exact_sci(d.angles) - angles, 0, angle_off);
    CHECK_NEAR(exact_sci(d.area) - area, 0, area_off);
    CHECK_NEAR(exact_sci(d.gauss) - gauss, 0, (angle_off + area_off * fabsl(gauss)) / area);
}

/* An octahedron with corners anywhere nearby: every vertex has the four that are not opposite. */
static void deficits_of_a_closed_mesh_sum_to_two_turns(arb *a)
{
    loft_vec corner[6];
    long double sum = 0;

    for (int i = 0; i < 6; i++) {
        int64_t raw[3];
        for (int k = 0; k < 3; k++)
            raw[k] = (k == i % 3 ? (i < 3 ? 131072 : -131072) : 0) + (int64_t)arb_below(a, 65536) -
                     32768;
        corner[i] = at_raw(raw);
    }
    for (int i = 0; i < 6; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const loft_vec ring[4] = { corner[j], corner[k], corner[j + 3], corner[k + 3] };
        loft_deficit d;
        CHECK(loft_deficit_eval(&corner[i], ring, 4, &d) == LOFT_OK);
        sum += exact_sci(d.gauss) * exact_sci(d.area);
    }
    CHECK_NEAR(sum - 4 * acosl(-1), 0, 24 * BY_NUM(0x1p-53L, 0x1p-47L, 0x1p-47L));
}

static void where_the_ring_starts_and_which_way_it_goes_is_the_same(arb *a)
{
    loft_vec vertex, ring[RING], other[RING];
    const unsigned n = arb_ring(a, &vertex, ring), from = arb_below(a, n);
    const bool back = arb_below(a, 2) != 0;
    long double angles, area, squares;
    loft_deficit d, e;

    for (unsigned i = 0; i < n; i++)
        other[i] = ring[(from + (back ? n - i : i)) % n];
    exact_deficit(&vertex, ring, n, &angles, &area, &squares);
    CHECK(loft_deficit_eval(&vertex, ring, n, &d) == LOFT_OK &&
          loft_deficit_eval(&vertex, other, n, &e) == LOFT_OK);
    CHECK_NEAR(exact_sci(d.angles) - exact_sci(e.angles), 0,
               2 * n * BY_NUM(0x1p-54L, 0x1p-48L, 0x1p-48L));
    CHECK_NEAR(exact_sci(d.area) - exact_sci(e.area), 0,
               2 * squares * BY_NUM(0x1p-55L, 0x1p-46L, 0x1p-46L));
}

/* Four neighbours at distance h on z = (p x^2 + q y^2) / 2, whose curvature at the vertex is p q,
 * along two lines. */
static long double estimate(long double p, long double q, long double first, long double second,
                            long double h)
{
    const int64_t origin[3] = { 0, 0, 0 };
    const loft_vec vertex = at_raw(origin);
    loft_vec ring[4];
    loft_deficit d;

    for (int i = 0; i < 4; i++) {
        const long double t = (i % 2 ? second : first) + (i > 1 ? acosl(-1) : 0), x = h * cosl(t),
                          y = h * sinl(t);
        const int64_t raw[3] = { llroundl(x * 65536), llroundl(y * 65536),
                                 llroundl((p * x * x + q * y * y) * 32768) };
        ring[i] = at_raw(raw);
    }
    CHECK(loft_deficit_eval(&vertex, ring, 4, &d) == LOFT_OK);
    return exact_sci(d.gauss);
}

static void it_does_not_converge_unless_the_mesh_follows_the_curvature(arb *a)
{
    const long double pi = acosl(-1), turn = arb_below(a, 1000) / 1000.0L * pi,
                      h[2] = { 0.125L, 0.03125L };

    for (int k = 0; k < 2; k++) {
        CHECK_NEAR(estimate(1, 1, turn, turn + pi / 3, h[k]), 1.6, 0.06);
        CHECK_NEAR(estimate(1, 1, turn, turn + pi / 4, h[k]), 2.52, 0.09);
        CHECK_NEAR(estimate(1, -1, pi / 4, 3 * pi / 4, h[k]), 0, 0.02);
        CHECK_NEAR(estimate(1, 1, turn, turn + pi / 2, h[k]), 1, 0.05);
        CHECK_NEAR(estimate(2, -1, 0, pi / 2, h[k]), -2, 0.2);
    }
}

static void what_has_no_area_is_singular(arb *a)
{
    const int64_t raw[3][3] = { { 0, 0, 0 }, { 65536, 0, 0 }, { -65536, 0, 0 } };
    loft_vec vertex, ring[RING];
    loft_deficit d;

    const unsigned n = arb_ring(a, &vertex, ring);
    CHECK(loft_deficit_eval(&vertex, ring, 2, &d) == LOFT_ERR_ARG);
    ring[arb_below(a, n)] = vertex;
    CHECK(loft_deficit_eval(&vertex, ring, n, &d) == LOFT_SINGULAR);
    vertex = at_raw(raw[0]);
    for (unsigned i = 0; i < n; i++)
        ring[i] = at_raw(raw[1 + i % 2]);
    CHECK(loft_deficit_eval(&vertex, ring, n, &d) == LOFT_SINGULAR);
}

int main(void)
{
    PROPERTY(angles_area_and_curvature_hold_their_bounds, 3000);
    PROPERTY(deficits_of_a_closed_mesh_sum_to_two_turns, 500);
    PROPERTY(where_the_ring_starts_and_which_way_it_goes_is_the_same, 500);
    PROPERTY(it_does_not_converge_unless_the_mesh_follows_the_curvature, 20);
    PROPERTY(what_has_no_area_is_singular, 200);
    return check_failures();
}

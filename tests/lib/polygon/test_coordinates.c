/* tests/lib/polygon/test_coordinates.c -- properties of lib/polygon/wachspress.h and meanvalue.h
 * SPDX-License-Identifier: MIT
 */
#include "support/arb_polygon.h"            /* arb_convex, arb_simple */
#include "polygon/meanvalue.h"
#include "polygon/wachspress.h"

/* The place of an arbitrary point, and a point inside or on the boundary. */
static enum loft_place place_of(const arb_domain *p, loft_spot q)
{
    loft_sci area[LOFT_SIDES_MAX];
    unsigned index;
    return loft_domain_place(&p->d, q, area, &index);
}

static loft_spot arb_inside(arb *a, const arb_domain *p)
{
    for (int k = 0; k < 50; k++) {
        const loft_spot q = arb_near(a, p);
        if (place_of(p, q) != LOFT_OUTSIDE)
            return q;
    }
    return p->v[0];
}

/* sum phi = 1 and sum phi v = q, each to `bound` times the absolute terms. */
static void check_sums(const arb_domain *p, loft_spot q, const loft_sci phi[], long double bound)
{
    long double sum = 0, sizes = 0, at[2] = { 0, 0 }, far = 0;

    for (unsigned i = 0; i < p->n; i++) {
        const long double f = exact_sci(phi[i]);
        sum += f;
        sizes += fabsl(f);
        for (int k = 0; k < 2; k++) {
            at[k] += f * (exact_of(p->v[i].at[k]) - exact_of(q.at[k]));
            far = fmaxl(far, fabsl(exact_of(p->v[i].at[k]) - exact_of(q.at[k])));
        }
    }
    CHECK_EXACT((sum - 1) / sizes, 0, bound);
    for (int k = 0; k < 2; k++)
        CHECK_EXACT(at[k] / (far > 0 ? far * sizes : 1), 0, bound);
}

#define ROUNDED(q16, floats) BY_NUM((q16) + 0x1p-62L, (floats), (floats))

static void wachspress_is_within_its_bound(arb *a)
{
    arb_domain p = arb_convex(a);
    loft_sci phi[LOFT_SIDES_MAX];
    long double want[LOFT_SIDES_MAX];

    settle(&p);
    const loft_spot q = arb_inside(a, &p);
    CHECK(loft_wachspress_eval(&p.d, q, phi) == LOFT_OK);
    check_sums(&p, q, phi, ROUNDED(p.n * p.n * 0x1p-59L, p.n * p.n * 0x1p-46L));
    for (unsigned i = 0; i < p.n; i++)
        CHECK(loft_sci_sign(phi[i]) >= 0);
    if (place_of(&p, q) != LOFT_INSIDE)
        return;
    exact_wachspress(p.v, p.n, q, want);
    for (unsigned i = 0; i < p.n; i++)          /* relative, however small */
        CHECK_EXACT(exact_sci(phi[i]) / want[i], 1,
                    ROUNDED(p.n * p.n * 0x1p-60L, p.n * p.n * 0x1p-46L));
}

static void wachspress_is_not_for_other_polygons_nor_outside(arb *a)
{
    arb_domain p = arb_simple(a);
    loft_sci phi[LOFT_SIDES_MAX];

    settle(&p);
    const loft_spot q = arb_near(a, &p);
    CHECK(loft_wachspress_eval(&p.d, q, phi) == (!p.d.convex                       ? LOFT_ERR_ARG
                                                 : place_of(&p, q) == LOFT_OUTSIDE ? LOFT_ERR_RANGE
                                                                                   : LOFT_OK));
}

/* x' = 2 x + y, y' = -x + y of small whole numbers. */
static void wachspress_follows_affine_maps(arb *a)
{
    arb_domain p = arb_convex(a), m;
    loft_sci phi[LOFT_SIDES_MAX], mapped[LOFT_SIDES_MAX];

    settle(&p);
    const loft_spot q = arb_inside(a, &p);
    m = p;
    settle(&m);
    for (unsigned i = 0; i <= p.n; i++) {
        const loft_spot s = i < p.n ? p.v[i] : q;
        const int64_t x = exact_raw(s.at[0]) / 8, y = exact_raw(s.at[1]) / 8;
        if (x * 8 != exact_raw(s.at[0]) || y * 8 != exact_raw(s.at[1]) || llabs(x) > (1 << 20) ||
            llabs(y) > (1 << 20))
            return;
    }
    for (unsigned i = 0; i < p.n; i++)
        m.v[i] = spot_raw((2 * exact_raw(p.v[i].at[0]) + exact_raw(p.v[i].at[1])) / 8 + 77,
                          (exact_raw(p.v[i].at[1]) - exact_raw(p.v[i].at[0])) / 8 - 5);
    const loft_spot r = spot_raw((2 * exact_raw(q.at[0]) + exact_raw(q.at[1])) / 8 + 77,
                                 (exact_raw(q.at[1]) - exact_raw(q.at[0])) / 8 - 5);
    CHECK(loft_domain_init(&m.d, m.v, m.n) == LOFT_OK && m.d.convex);
    CHECK(loft_wachspress_eval(&p.d, q, phi) == LOFT_OK &&
          loft_wachspress_eval(&m.d, r, mapped) == LOFT_OK);
    for (unsigned i = 0; i < p.n; i++)
        CHECK_EXACT(exact_sci(mapped[i]), exact_sci(phi[i]), ROUNDED(0x1p-53L, 0x1p-39L));
}

/* Points that are multiples of 8 LSB, for the property above. */
static void wachspress_follows_affine_maps_of_coarse_polygons(arb *a)
{
    arb_domain p = { .n = 5 };
    const int32_t s = 8 << arb_below(a, 12);
    const int32_t raw[5][2] = { { -3, -5 }, { 4, -5 }, { 7, 1 }, { 0, 6 }, { -6, 2 } };
    loft_sci phi[5], mapped[5];
    arb_domain m = p;

    for (int i = 0; i < 5; i++) {
        p.v[i] = spot_raw(raw[i][0] * s, raw[i][1] * s);
        m.v[i] = spot_raw((2 * raw[i][0] + raw[i][1]) * s, (raw[i][1] - raw[i][0]) * s);
    }
    CHECK(loft_domain_init(&p.d, p.v, 5) == LOFT_OK && loft_domain_init(&m.d, m.v, 5) == LOFT_OK);
    const int32_t x = (int32_t)arb_below(a, (uint32_t)(5 * s)) - 2 * s,
                  y = (int32_t)arb_below(a, (uint32_t)(5 * s)) - 3 * s;
    CHECK(loft_wachspress_eval(&p.d, spot_raw(x, y), phi) == LOFT_OK);
    CHECK(loft_wachspress_eval(&m.d, spot_raw(2 * x + y, y - x), mapped) == LOFT_OK);
    for (int i = 0; i < 5; i++)
        CHECK_EXACT(exact_sci(mapped[i]), exact_sci(phi[i]), ROUNDED(0x1p-54L, 0x1p-44L));
}

static void mean_values_are_within_their_bound(arb *a)
{
    arb_domain p = arb_below(a, 2) ? arb_simple(a) : arb_convex(a);
    loft_sci phi[LOFT_SIDES_MAX];
    long double want[LOFT_SIDES_MAX], largest = 0;

    settle(&p);
    const loft_spot q = arb_near(a, &p);
    const enum loft_place place = place_of(&p, q);
    CHECK(loft_meanvalue_eval(&p.d, q, phi) == LOFT_OK);
    if (place != LOFT_INSIDE && place != LOFT_OUTSIDE)
        return;
    const long double lost = exact_meanvalue(p.v, p.n, q, want);
    for (unsigned i = 0; i < p.n; i++)
        largest = fmaxl(largest, fabsl(want[i]));
    const long double bound = ROUNDED((1 + largest) * lost * 0x1p-56L,
                                      (1 + largest) * lost * 0x1p-47L);
    for (unsigned i = 0; i < p.n; i++)          /* the reference, of 64 bits, loses as much */
        CHECK_EXACT(exact_sci(phi[i]), want[i], bound);
    check_sums(&p, q, phi, 2 * bound);
}

static void mean_values_inside_a_convex_polygon_are_positive(arb *a)
{
    arb_domain p = arb_convex(a);
    loft_sci phi[LOFT_SIDES_MAX];

    settle(&p);
    const loft_spot q = arb_inside(a, &p);
    CHECK(loft_meanvalue_eval(&p.d, q, phi) == LOFT_OK);
    for (unsigned i = 0; i < p.n; i++)
        CHECK(place_of(&p, q) == LOFT_INSIDE ? loft_sci_sign(phi[i]) > 0
                                             : loft_sci_sign(phi[i]) >= 0);
}

/* A quarter turn changes no bit of the square roots, and nothing at all in q16. */
static void mean_values_follow_a_quarter_of_a_turn(arb *a)
{
    arb_domain p = arb_simple(a), m = p;
    loft_sci phi[LOFT_SIDES_MAX], turned[LOFT_SIDES_MAX];

    settle(&p);
    const loft_spot q = arb_near(a, &p);
    for (unsigned i = 0; i < p.n; i++)
        m.v[i] = spot_raw(-exact_raw(p.v[i].at[1]), exact_raw(p.v[i].at[0]));
    CHECK(loft_domain_init(&m.d, m.v, m.n) == LOFT_OK);
    CHECK(loft_meanvalue_eval(&p.d, q, phi) == LOFT_OK);
    CHECK(loft_meanvalue_eval(&m.d, spot_raw(-exact_raw(q.at[1]), exact_raw(q.at[0])), turned) ==
          LOFT_OK);
    const long double lost = place_of(&p, q) == LOFT_INSIDE || place_of(&p, q) == LOFT_OUTSIDE
                                 ? exact_meanvalue(p.v, p.n, q, (long double[LOFT_SIDES_MAX]){ 0 })
                                 : 1;
    for (unsigned i = 0; i < p.n; i++)
        CHECK_EXACT(exact_sci(turned[i]), exact_sci(phi[i]),
                    (1 + fabsl(exact_sci(phi[i]))) * lost * ROUNDED(0x1p-55L, 0x1p-46L));
}

/* On edges and at vertices both kinds are linear: equal bit for bit, and exact at vertices. */
static void boundaries_are_decided_exactly(arb *a)
{
    arb_domain p = arb_convex(a);
    const unsigned i = arb_below(a, p.n);
    loft_sci w[LOFT_SIDES_MAX], m[LOFT_SIDES_MAX];

    settle(&p);
    const loft_spot q = arb_on_edge(a, &p, i);
    CHECK(loft_wachspress_eval(&p.d, q, w) == LOFT_OK &&
          loft_meanvalue_eval(&p.d, q, m) == LOFT_OK);
    for (unsigned k = 0; k < p.n; k++) {
        CHECK_EXACT(exact_sci(w[k]), exact_sci(m[k]), 0);
        CHECK(k == i || k == (i + 1) % p.n || loft_sci_sign(w[k]) == 0);
    }
    CHECK(loft_wachspress_eval(&p.d, p.v[i], w) == LOFT_OK);
    for (unsigned k = 0; k < p.n; k++)
        CHECK_EXACT(exact_sci(w[k]), k == i, 0);
}

static void triangles_have_one_kind_of_coordinates(arb *a)
{
    arb_domain p = arb_convex(a);
    loft_sci w[LOFT_SIDES_MAX], m[LOFT_SIDES_MAX];

    p.n = 3;
    settle(&p);
    if (loft_domain_init(&p.d, p.v, 3) != LOFT_OK)
        return;
    const loft_spot q = arb_inside(a, &p);
    CHECK(loft_wachspress_eval(&p.d, q, w) == LOFT_OK &&
          loft_meanvalue_eval(&p.d, q, m) == LOFT_OK);
    for (int k = 0; k < 3; k++)
        CHECK_EXACT(exact_sci(w[k]), exact_sci(m[k]), ROUNDED(0x1p-54L, 0x1p-43L));
}

static void what_is_no_number_is_refused(arb *a)
{
    arb_domain p = arb_convex(a);
    loft_sci phi[LOFT_SIDES_MAX];

    settle(&p);
    for (int k = 0; k < 2 && BY_NUM(false, true, true); k++) {
        loft_spot q = p.v[0];
        q.at[k] = (loft_real)BY_NUM(0, k ? NAN : INFINITY, k ? NAN : INFINITY);
        CHECK(loft_wachspress_eval(&p.d, q, phi) == LOFT_ERR_RANGE &&
              loft_meanvalue_eval(&p.d, q, phi) == LOFT_ERR_RANGE);
    }
}

int main(void)
{
    PROPERTY(wachspress_is_within_its_bound,                        2000);
    PROPERTY(wachspress_is_not_for_other_polygons_nor_outside,       500);
    PROPERTY(wachspress_follows_affine_maps,                         500);
    PROPERTY(wachspress_follows_affine_maps_of_coarse_polygons,      500);
    PROPERTY(mean_values_are_within_their_bound,                    3000);
    PROPERTY(mean_values_inside_a_convex_polygon_are_positive,      1000);
    PROPERTY(mean_values_follow_a_quarter_of_a_turn,                 500);
    PROPERTY(boundaries_are_decided_exactly,                        1000);
    PROPERTY(triangles_have_one_kind_of_coordinates,                 500);
    PROPERTY(what_is_no_number_is_refused,                            10);
    return check_failures();
}

/* tests/lib/polygon/test_domain.c -- properties of lib/polygon/domain.h
 * SPDX-License-Identifier: MIT
 */
#include "support/arb_polygon.h"            /* arb_convex, arb_simple */

static bool same(loft_spot a, loft_spot b)
{
    return exact_raw(a.at[0]) == exact_raw(b.at[0]) && exact_raw(a.at[1]) == exact_raw(b.at[1]);
}

static void reverse(arb_domain *p)
{
    for (unsigned i = 0; i < p->n / 2; i++) {
        const loft_spot swap = p->v[i];
        p->v[i] = p->v[p->n - 1 - i];
        p->v[p->n - 1 - i] = swap;
    }
}

static void rotate(arb_domain *p)
{
    const loft_spot first = p->v[0];

    for (unsigned i = 0; i + 1 < p->n; i++)
        p->v[i] = p->v[i + 1];
    p->v[p->n - 1] = first;
}

static void the_outline_does_not_depend_on_where_it_starts(arb *a)
{
    arb_domain p = arb_below(a, 2) ? arb_convex(a) : arb_simple(a);
    const enum loft_outline want = is_convex(&p) ? LOFT_OUTLINE_CONVEX : LOFT_OUTLINE_SIMPLE;

    for (unsigned i = 0; i < p.n; i++, rotate(&p))
        CHECK(loft_outline_of(p.v, p.n) == want);
    reverse(&p);
    for (unsigned i = 0; i < p.n; i++, rotate(&p))
        CHECK(loft_outline_of(p.v, p.n) == LOFT_OUTLINE_CLOCKWISE);
    CHECK(loft_domain_init(&p.d, p.v, p.n) == LOFT_ERR_ARG);
}

static void exchanged_vertices_of_a_convex_polygon_break_it(arb *a)
{
    arb_domain p = arb_convex(a);
    const unsigned i = arb_below(a, p.n), j = (i + 1) % p.n;

    if (p.n == 3)
        return;
    const loft_spot swap = p.v[i];
    p.v[i] = p.v[j];
    p.v[j] = swap;
    CHECK(loft_outline_of(p.v, p.n) == LOFT_OUTLINE_BROKEN &&
          loft_domain_init(&p.d, p.v, p.n) == LOFT_SINGULAR);
}

/* A vertex on another edge or at another vertex is broken. One LSB beside it the polygon is simple,
 * if nothing else is in the way. */
static void what_touches_itself_is_broken(arb *a)
{
    arb_domain p = { .n = 5 };
    const int32_t w = 4 + (int32_t)arb_below(a, 1000), h = 4 + (int32_t)arb_below(a, 1000),
                  x = 1 + (int32_t)arb_below(a, (uint32_t)w - 1);
    const int32_t up[3] = { 0, 1, -1 };
    const enum loft_outline want[3] = { LOFT_OUTLINE_BROKEN, LOFT_OUTLINE_SIMPLE,
                                        LOFT_OUTLINE_BROKEN };
    const unsigned turns = arb_below(a, 5);

    for (int k = 0; k < 3; k++) {
        p.v[0] = spot_raw(0, 0);
        p.v[1] = spot_raw(w, 0);
        p.v[2] = spot_raw(w, h);
        p.v[3] = spot_raw(x, up[k]);
        p.v[4] = spot_raw(0, h);
        for (unsigned t = 0; t < turns; t++)
            rotate(&p);
        CHECK(loft_outline_of(p.v, 5) == want[k]);
    }
}

/* Two vertices in one place, seen from all eight sides. */
static void pinched_polygons_are_broken(arb *a)
{
    const int32_t raw[2][6][2] = {
        { { 0, 0 }, { -2, -3 }, { 2, -4 }, { 0, 0 }, { 3, 4 }, { -3, 5 } },
        { { 0, 0 }, { 4, -1 }, { 3, -5 }, { 0, 0 }, { -1, 4 }, { -5, 3 } }
    };
    arb_domain p = { .n = 6 };
    const unsigned turns = arb_below(a, 6), view = arb_below(a, 8), way = arb_below(a, 2);

    for (int i = 0; i < 6; i++) {
        const int32_t x = raw[way][i][view & 1] * (view & 2 ? -1 : 1),
                      y = raw[way][i][!(view & 1)] * (view & 4 ? -1 : 1);
        p.v[i] = spot_raw(x, y);
    }
    for (unsigned t = 0; t < turns; t++)
        rotate(&p);
    CHECK(loft_outline_of(p.v, 6) == LOFT_OUTLINE_BROKEN);
}

static void no_length_no_area_and_spikes_are_broken(arb *a)
{
    arb_domain p = arb_convex(a);
    const unsigned i = arb_below(a, p.n), j = (i + 1) % p.n;
    const loft_spot line[4] = { p.v[0], p.v[1], p.v[0], p.v[1] };

    CHECK(loft_outline_of(line, 3) == LOFT_OUTLINE_BROKEN &&
          loft_outline_of(line, 4) == LOFT_OUTLINE_BROKEN);
    p.v[i] = p.v[j];
    CHECK(loft_outline_of(p.v, p.n) == LOFT_OUTLINE_BROKEN);
    const loft_spot spike[4] = { spot_raw(0, 0), spot_raw(4, 0), spot_raw(2, 0), spot_raw(2, 5) };
    CHECK(loft_outline_of(spike, 4) == LOFT_OUTLINE_BROKEN);
    const loft_spot back[4] = { spot_raw(2, 0), spot_raw(4, 0), spot_raw(0, 0), spot_raw(2, 5) };
    CHECK(loft_outline_of(back, 4) == LOFT_OUTLINE_BROKEN);
    const loft_spot straight[4] = { spot_raw(0, 0), spot_raw(2, 0), spot_raw(4, 0),
                                    spot_raw(2, 5) };
    CHECK(loft_outline_of(straight, 4) == LOFT_OUTLINE_SIMPLE);
}

/* The winding number by exact angles: signed crossings of the upward and downward ray, in whole
 * numbers. */
static bool winds(const arb_domain *p, loft_spot q)
{
    int winding = 0;

    for (unsigned i = 0; i < p->n; i++) {
        const loft_spot *s = &p->v[i], *t = &p->v[(i + 1) % p->n];
        const exact_wide side = exact_cross(s, t, &q);
        const bool below_s = exact_raw(s->at[1]) <= exact_raw(q.at[1]),
                   below_t = exact_raw(t->at[1]) <= exact_raw(q.at[1]);
        winding += below_s && !below_t && side > 0;
        winding -= !below_s && below_t && side < 0;
    }
    return winding != 0;
}

static void a_place_is_what_whole_numbers_say(arb *a)
{
    arb_domain p = arb_below(a, 2) ? arb_convex(a) : arb_simple(a);
    loft_sci area[LOFT_SIDES_MAX];
    unsigned index = 99;

    settle(&p);
    for (int k = 0; k < 20; k++) {
        const loft_spot q = arb_near(a, &p);
        const enum loft_place place = loft_domain_place(&p.d, q, area, &index);
        unsigned vertex = p.n, edge = p.n;
        for (unsigned i = 0; i < p.n; i++) {
            const loft_spot *s = &p.v[i], *t = &p.v[(i + 1) % p.n];
            const exact_wide twice = exact_cross(&q, s, t);
            CHECK(loft_sci_sign(area[i]) == (twice > 0) - (twice < 0));
            CHECK_EXACT(exact_sci(area[i]) * 4294967296.0L / (twice ? (long double)twice : 1),
                        twice ? 1 : 0, BY_NUM(0x1p-60L, 0x1p-47L, 0x1p-47L));
            if (same(q, *s))
                vertex = i;
            if (!twice && !same(q, *s) && !same(q, *t) && exact_dot(&q, s, t) < 0)
                edge = i;
        }
        CHECK(place == (vertex < p.n   ? LOFT_AT_VERTEX
                        : edge < p.n   ? LOFT_ON_EDGE
                        : winds(&p, q) ? LOFT_INSIDE
                                       : LOFT_OUTSIDE));
        CHECK(place == LOFT_INSIDE || place == LOFT_OUTSIDE ||
              index == (vertex < p.n ? vertex : edge));
    }
}

static void a_point_on_an_edge_has_two_coordinates(arb *a)
{
    arb_domain p = arb_simple(a);
    const unsigned i = arb_below(a, p.n), j = (i + 1) % p.n;
    loft_sci phi[LOFT_SIDES_MAX];

    settle(&p);
    const loft_spot q = arb_on_edge(a, &p, i);
    loft_domain_edge(&p.d, q, i, phi);
    for (unsigned k = 0; k < p.n; k++)
        CHECK(k == i || k == j || loft_sci_sign(phi[k]) == 0);
    const int axis = llabs(exact_raw(p.v[i].at[0]) - exact_raw(p.v[j].at[0])) >=
                             llabs(exact_raw(p.v[i].at[1]) - exact_raw(p.v[j].at[1]))
                         ? 0
                         : 1;
    const long double from = exact_of(p.v[i].at[axis]), to = exact_of(p.v[j].at[axis]),
                      t = (exact_of(q.at[axis]) - from) / (to - from);
    CHECK_EXACT(exact_sci(phi[j]), t, BY_NUM(0x1p-59L, 0x1p-51L, 0x1p-51L));
    CHECK_EXACT(exact_sci(phi[i]), 1 - t, BY_NUM(0x1p-59L, 0x1p-51L, 0x1p-51L));
}

/* No point of the boundary is nearer than that of the coordinates, which belong to one edge. */
static void the_nearest_point_of_the_boundary_is_found(arb *a)
{
    arb_domain p = arb_below(a, 2) ? arb_winding(a) : arb_simple(a);
    const loft_spot q = arb_near(a, &p);
    long double at[2] = { 0, 0 }, sum = 0, size = 0;
    unsigned counted = 0;
    loft_sci phi[LOFT_SIDES_MAX];

    settle(&p);
    loft_domain_nearest(&p.d, q, phi);
    for (unsigned i = 0; i < p.n; i++) {
        CHECK(loft_sci_sign(phi[i]) >= 0);
        if (loft_sci_sign(phi[i]) > 0)
            CHECK(counted++ == 0 || loft_sci_sign(phi[(i + p.n - 1) % p.n]) > 0 ||
                  (i + 1 == p.n && loft_sci_sign(phi[0]) > 0));
        sum += exact_sci(phi[i]);
        for (int k = 0; k < 2; k++) {
            at[k] += exact_sci(phi[i]) * exact_of(p.v[i].at[k]);
            size = fmaxl(size, fabsl(exact_of(p.v[i].at[k])));
        }
    }
    CHECK(counted <= 2 && fabsl(sum - 1) < 0x1p-50L);
    const long double found = hypotl(at[0] - exact_of(q.at[0]), at[1] - exact_of(q.at[1]));
    for (unsigned i = 0; i < p.n; i++)
        for (int k = 0; k <= 64; k++) {
            long double off[2];
            for (int j = 0; j < 2; j++)
                off[j] = exact_of(p.v[i].at[j]) * (1 - k / 64.0L) +
                         exact_of(p.v[(i + 1) % p.n].at[j]) * (k / 64.0L) - exact_of(q.at[j]);
            CHECK(found <= hypotl(off[0], off[1]) + size * 0x1p-40L);
        }
    CHECK(loft_spot_turn(&p.v[0], &p.v[1], &q) ==
          (exact_cross(&p.v[0], &p.v[1], &q) > 0) - (exact_cross(&p.v[0], &p.v[1], &q) < 0));
}

static void nonsense_is_refused(arb *a)
{
    arb_domain p = arb_convex(a);
    loft_domain d = { .sides = 77 };

    CHECK(loft_domain_init(&d, p.v, 2) == LOFT_ERR_ARG &&
          loft_domain_init(&d, p.v, LOFT_SIDES_MAX + 1) == LOFT_ERR_ARG);
    CHECK(loft_domain_init(&d, p.v, 0) == LOFT_ERR_ARG);
    for (int k = 0; k < 3 && BY_NUM(false, true, true); k++) {
        arb_domain q = p;
        q.v[arb_below(a, q.n)].at[arb_below(a, 2)] = (loft_real)BY_NUM(0,
                                                                       k == 0   ? INFINITY
                                                                       : k == 1 ? NAN
                                                                                : 1048576,
                                                                       k == 0   ? INFINITY
                                                                       : k == 1 ? NAN
                                                                                : 1048576);
        CHECK(loft_domain_init(&d, q.v, q.n) == LOFT_ERR_RANGE);
    }
    CHECK(d.sides == 77);
}

/* The whole range of coordinates, one LSB from flat. */
static void the_largest_polygons_are_judged_exactly(arb *a)
{
    const int32_t m = BY_NUM(INT32_MAX, 1 << 23, INT32_MAX), e = (int32_t)arb_below(a, 3) - 1;
    const loft_spot v[4] = { spot_raw(-m, -m + 1), spot_raw(0, e), spot_raw(m, m - 1),
                             spot_raw(-m, m) };
    const loft_spot w[4] = { spot_raw(-m, -m), spot_raw(m, -m), spot_raw(m, m), spot_raw(-m, m) };

    CHECK(loft_outline_of(v, 4) == (e < 0 ? LOFT_OUTLINE_CONVEX : LOFT_OUTLINE_SIMPLE));
    CHECK(loft_outline_of(w, 4) == LOFT_OUTLINE_CONVEX);
}

int main(void)
{
    PROPERTY(the_outline_does_not_depend_on_where_it_starts,    400);
    PROPERTY(exchanged_vertices_of_a_convex_polygon_break_it,   400);
    PROPERTY(what_touches_itself_is_broken,                     200);
    PROPERTY(pinched_polygons_are_broken,                       300);
    PROPERTY(no_length_no_area_and_spikes_are_broken,           200);
    PROPERTY(a_place_is_what_whole_numbers_say,                 600);
    PROPERTY(a_point_on_an_edge_has_two_coordinates,           2000);
    PROPERTY(the_nearest_point_of_the_boundary_is_found,        400);
    PROPERTY(nonsense_is_refused,                               100);
    PROPERTY(the_largest_polygons_are_judged_exactly,            50);
    return check_failures();
}

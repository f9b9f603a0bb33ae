/* tests/lib/polygon/test_polygon_loops.c -- the loops that headers of lib/polygon print, word for
 * word, over arbitrary polygons and patches
 * SPDX-License-Identifier: MIT
 *
 * tests/house/loops.py compares them with the headers.
 */
#include "support/arb_polygon.h"                /* arb_simple, arb_winding */
#include "support/lattices.h"                   /* arb_lattice, lattice_height */
#include "polygon/partition.h"
#include "polygon/spatch_triangle.h"
#include "polygon/toric_tensor.h"
#include "surface/triangle/triangle_rational.h" /* loft_triangle_rational_eval */

#define MOST 100

static void each_multi_index_comes_once_in_order(arb *a)
{
    const unsigned sides = 2 + arb_below(a, 7), depth = arb_below(a, sides > 5 ? 5 : 8);
    unsigned rank = 0;

    uint8_t l[LOFT_SIDES_MAX];
    loft_multiindex_first(l, sides, depth);
    do {
        unsigned sum = 0;
        for (unsigned i = 0; i < sides; i++)
            sum += l[i];
        CHECK(sum == depth && loft_multiindex_rank(l, sides) == rank);
        rank++;
    } while (loft_multiindex_next(l, sides));
    CHECK(rank == loft_multiindex_count(sides, depth));
}

static void pieces_have_the_vertices_of_their_polygon(arb *a)
{
    arb_domain p = arb_below(a, 2) ? arb_simple(a) : arb_winding(a);
    unsigned k, turns = 0;

    settle(&p);
    const loft_domain domain = p.d;
    loft_partition cut;
    loft_partition_init(&cut, &domain);
    for (k = 0; k < cut.count; k++) {
        for (unsigned i = 0; i < cut.sides[k]; i++)
            CHECK(cut.vertex[k][i] < p.n);
        turns += cut.sides[k] - 2u;
    }
    CHECK(turns == p.n - 2);
}

/* Over polygons near regular ones. The corner T1 of all triangles is one point. */
static void triangles_of_an_s_patch_share_its_middle(arb *a)
{
    static const uint8_t deepest[LOFT_SIDES_MAX + 1] = { 0, 0, 0, 9, 4, 3, 2, 1, 1 };
    const unsigned sides = 3 + arb_below(a, 6), depth = 1 + arb_below(a, deepest[sides]);
    loft_spot v[LOFT_SIDES_MAX];
    loft_vec points[MOST], middle = { { 0 } };
    loft_domain domain;
    loft_spatch s;
    loft_triangle_rational t;
    unsigned made = 0;

    for (unsigned i = 0; i < sides; i++)
        for (int k = 0; k < 2; k++)
            v[i].at[k] = LOFT_REAL(
                (double)(20 * (k ? sinl : cosl)(2 * acosl(-1) * (long double)i / sides) +
                         arb_below(a, 1001) / 500.0L));
    for (unsigned k = 0; k < loft_multiindex_count(sides, depth); k++)
        points[k] = arb_vec(a, 100);
    CHECK(loft_domain_init(&domain, v, sides) == LOFT_OK && domain.convex);
    CHECK(loft_spatch_init(&s, points, NULL, sides, depth) == LOFT_OK);
    loft_weighted p[LOFT_SPATCH_TRIANGLE_MAX];
    for (unsigned edge = 0; edge < s.sides; edge++)
        if (loft_spatch_triangle(&s, &domain, edge, p) == LOFT_OK &&
            loft_triangle_rational_init(&t, p, s.depth * (s.sides - 2u)) == LOFT_OK) {
            const loft_vec at = p[0].p;
            if (edge == 0)
                middle = at;
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_NEAR(arb_value(at.axis[i]), arb_value(middle.axis[i]),
                           BY_NUM(0x1p-15, 0x1p-15, 1e-9));
            made++;
        }
    CHECK(made == sides);
}

/* Their corner u = v = 1 is one point, the middle. */
static void patches_of_a_toric_surface_share_its_middle(arb *a)
{
    loft_lattice_polygon lattice = arb_lattice(a);
    loft_vec points[MOST], middle = { { 0 } };
    loft_toric t;
    unsigned made = 0;

    while (lattice_height(&lattice) > 6 || loft_lattice_polygon_count(&lattice) > MOST)
        lattice = arb_lattice(a);
    for (unsigned k = 0; k < loft_lattice_polygon_count(&lattice); k++)
        points[k] = arb_vec(a, 100);
    CHECK(loft_toric_init(&t, &lattice, points, NULL, NULL) == LOFT_OK);
    loft_weighted p[LOFT_TORIC_TENSOR_MAX];
    loft_tensor_rational s;
    for (unsigned vertex = 0; vertex < lattice.sides; vertex++)
        if (loft_toric_tensor(&t, vertex, p, &s) == LOFT_OK) {
            const loft_vec at = p[(s.m + 1) * (s.n + 1) - 1].p;
            if (vertex == 0)
                middle = at;
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_NEAR(arb_value(at.axis[i]), arb_value(middle.axis[i]),
                           BY_NUM(0x1p-15, 0x1p-15, 1e-9));
            made++;
        }
    CHECK(made == lattice.sides);
}

int main(void)
{
    PROPERTY(each_multi_index_comes_once_in_order,         100);
    PROPERTY(pieces_have_the_vertices_of_their_polygon,    500);
    PROPERTY(triangles_of_an_s_patch_share_its_middle,      20);
    PROPERTY(patches_of_a_toric_surface_share_its_middle,   50);
    return check_failures();
}

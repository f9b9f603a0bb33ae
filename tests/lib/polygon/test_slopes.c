/* tests/lib/polygon/test_slopes.c -- derivatives of S-patches, toric and base point patches:
 * properties of lib/polygon/jet_weighted_sum.h
 * SPDX-License-Identifier: MIT
 *
 * Their weights are products of powers, computed in 113 bits, one factor after the other.
 */
#include "support/exact_quad.h"             /* quad */
#include "support/arb_patch.h"              /* arb_net */
#include "polygon/basepoint.h"
#include "polygon/jet_weighted_sum.h"
#include "polygon/meanvalue.h"
#include "polygon/spatch.h"
#include "polygon/toric.h"
#include "polygon/wachspress.h"

static net points;
static loft_real factor[PATCH_POINTS];

/* A function and its derivatives x, y, xx, xy, yy. */
typedef struct {
    quad f, d[5];
} function;

/* Sums over all points: value and derivatives, those of the weights, and the sums of their absolute
 * values by order. */
typedef struct {
    quad x[LOFT_AXES][6], w[6], size[2];
} exact_sum;

static void multiply(function *w, const function *f)
{
    const quad *d = w->d, *e = f->d;
    const quad mixed[5] = { 0, 0, 2 * d[0] * e[0], d[0] * e[1] + d[1] * e[0], 2 * d[1] * e[1] };

    for (int k = 0; k < 5; k++)
        w->d[k] = d[k] * f->f + w->f * e[k] + mixed[k];
    w->f *= f->f;
}

static void add_term(exact_sum *s, const loft_vec *p, quad c, const function f[], const uint8_t e[],
                     unsigned n)
{
    function w = { c, { 0, 0, 0, 0, 0 } };

    for (unsigned i = 0; i < n; i++)
        for (unsigned k = 0; k < e[i]; k++)
            multiply(&w, &f[i]);
    for (int k = 0; k < 6; k++) {
        const quad part = k ? w.d[k - 1] : w.f;
        s->w[k] += part;
        if (k > 0)
            s->size[k > 2] += quad_size(part);
        for (int i = 0; i < LOFT_AXES; i++)
            s->x[i][k] += part * (quad)exact_of(p->axis[i]);
    }
}

/* The quotient's derivatives against those of the library. */
static void check_slopes(const exact_sum *s, const loft_differential *got)
{
    const quad *w = s->w;
    const long double a = (long double)(s->size[0] / quad_size(w[0])),
                      b = (long double)(s->size[1] / quad_size(w[0]));

    for (int i = 0; i < LOFT_AXES; i++) {
        const quad *x = s->x[i], p = x[0] / w[0], u = (x[1] - p * w[1]) / w[0],
                   v = (x[2] - p * w[2]) / w[0];
        const quad uu = (x[3] - 2 * u * w[1] - p * w[3]) / w[0],
                   vv = (x[5] - 2 * v * w[2] - p * w[5]) / w[0];
        const quad uv = (x[4] - u * w[2] - v * w[1] - p * w[4]) / w[0];
        const long double one = points.largest * a * BY_NUM(0x1p-44L, 0x1p-36L, 0x1p-36L),
                          two = points.largest * (b + a * a) * BY_NUM(0x1p-44L, 0x1p-36L, 0x1p-36L);
        CHECK_EXACT(exact_sci(got->u[i]), (long double)u, one);
        CHECK_EXACT(exact_sci(got->v[i]), (long double)v, one);
        CHECK_EXACT(exact_sci(got->uu[i]), (long double)uu, two);
        CHECK_EXACT(exact_sci(got->uv[i]), (long double)uv, two);
        CHECK_EXACT(exact_sci(got->vv[i]), (long double)vv, two);
    }
}

static function function_of(const loft_jet *j)
{
    const function f = { exact_sci(j->f),
                         { exact_sci(j->x), exact_sci(j->y), exact_sci(j->xx), exact_sci(j->xy),
                           exact_sci(j->yy) } };
    return f;
}

static void derivatives_of_s_patches_are_exact(arb *a)
{
    arb_domain p = arb_convex(a);
    const loft_spot q = (settle(&p), arb_near(a, &p));
    const bool rational = arb_below(a, 2);
    unsigned depth = 1 + arb_below(a, 5), rank = 0;
    loft_sci area[LOFT_SIDES_MAX];
    loft_jet phi[LOFT_SIDES_MAX];
    function f[LOFT_SIDES_MAX];
    uint8_t l[LOFT_SIDES_MAX];
    exact_sum sum = { .size = { 0, 0 } };
    loft_differential here;
    loft_spatch s;

    while (loft_multiindex_count(p.n, depth) > PATCH_POINTS)
        depth--;
    if (loft_domain_place(&p.d, q, area, &rank) != LOFT_INSIDE)
        return;
    CHECK((arb_below(a, 2) ? loft_meanvalue_jet(&p.d, q, phi)
                           : loft_wachspress_jet(&p.d, q, phi)) == LOFT_OK);
    arb_net(a, &points, loft_multiindex_count(p.n, depth));
    CHECK(loft_spatch_init(&s, points.p, rational ? points.w : NULL, p.n, depth) == LOFT_OK &&
          loft_spatch_differential(&s, phi, &here) == LOFT_OK);
    for (unsigned i = 0; i < p.n; i++)
        f[i] = function_of(&phi[i]);
    rank = 0;
    loft_multiindex_first(l, p.n, depth);
    do {
        add_term(&sum, &points.p[rank],
                 loft_multiindex_multinomial(l, p.n) *
                     (rational ? (quad)exact_of(points.w[rank]) : 1),
                 f, l, p.n);
        rank++;
    } while (loft_multiindex_next(l, p.n));
    check_slopes(&sum, &here);
}

/* An S-patch with three sides and depth 1 over any triangle is the plane through its points. */
static void a_flat_triangle_does_not_bend(arb *a)
{
    arb_domain p;
    loft_jet phi[LOFT_SIDES_MAX];
    loft_curvatures k;
    loft_differential here;
    loft_spatch s;

    do
        p = arb_convex(a);
    while (p.n != 3);
    settle(&p);
    arb_net(a, &points, 3);
    CHECK(loft_wachspress_jet(&p.d, p.v[arb_below(a, 3)], phi) == LOFT_OK);
    CHECK(loft_spatch_init(&s, points.p, NULL, 3, 1) == LOFT_OK &&
          loft_spatch_differential(&s, phi, &here) == LOFT_OK);
    const enum loft_status status = loft_differential_curvatures(&here, &k);
    CHECK(status == LOFT_SINGULAR || status == LOFT_ERR_RANGE || LOFT_AXES >= 3);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double most = 0;
        for (unsigned j = 0; j < 3; j++)
            most = fmaxl(most, fmaxl(fabsl(exact_sci(phi[j].x)), fabsl(exact_sci(phi[j].y))));
        const long double off = points.largest * most * most * BY_NUM(0x1p-48L, 0x1p-40L, 0x1p-40L);
        CHECK_EXACT(exact_sci(here.uu[i]), 0, off);
        CHECK_EXACT(exact_sci(here.uv[i]), 0, off);
        CHECK_EXACT(exact_sci(here.vv[i]), 0, off);
    }
}

static void derivatives_of_toric_patches_are_exact(arb *a)
{
    static const struct {
        loft_whole v[LOFT_SIDES_MAX];
        unsigned n;
    } shape[3] = { { { { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 1, 2 } }, { { 0, 2 } } }, 5 },
                   { { { { -3, -2 } },
                       { { 1, -3 } },
                       { { 4, 0 } },
                       { { 3, 3 } },
                       { { -1, 4 } },
                       { { -4, 1 } } },
                     6 },
                   { { { { 0, 0 } }, { { 1, 0 } }, { { 7, 1 } } }, 3 } };
    const unsigned k = arb_below(a, 3);
    loft_lattice_polygon l = { .sides = 0 };
    exact_sum sum = { .size = { 0, 0 } };
    function h[LOFT_SIDES_MAX];
    loft_differential here;
    loft_toric t;
    loft_whole q;
    unsigned m = 0;

    CHECK(loft_lattice_polygon_init(&l, shape[k].v, shape[k].n) == LOFT_OK);
    const loft_spot p = spot_raw((int64_t)arb_below(a, 9 * 65536) - 4 * 65536,
                                 (int64_t)arb_below(a, 8 * 65536) - 4 * 65536);
    for (unsigned i = 0; i < l.sides; i++) {
        const quad x = l.edge[i].normal.at[0], y = l.edge[i].normal.at[1];
        h[i] = (function){ x * (quad)exact_of(p.at[0]) + y * (quad)exact_of(p.at[1]) +
                               l.edge[i].offset,
                           { x, y, 0, 0, 0 } };
        if (!(h[i].f > 0))
            return;
    }
    arb_net(a, &points, loft_lattice_polygon_count(&l));
    for (unsigned i = 0; i < loft_lattice_polygon_count(&l); i++)
        factor[i] = loft_real_from_int(1 + (int32_t)arb_below(a, 30));
    CHECK(loft_toric_init(&t, &l, points.p, factor, points.w) == LOFT_OK &&
          loft_toric_differential(&t, p, &here) == LOFT_OK);
    loft_lattice_polygon_first(&l, &q);
    do {
        uint8_t e[LOFT_SIDES_MAX];
        for (unsigned i = 0; i < l.sides; i++)
            e[i] = (uint8_t)loft_lattice_polygon_height(&l, i, q);
        add_term(&sum, &points.p[m], (quad)exact_of(factor[m]) * (quad)exact_of(points.w[m]), h, e,
                 l.sides);
        m++;
    } while (loft_lattice_polygon_next(&l, &q));
    check_slopes(&sum, &here);
}

static void derivatives_of_base_point_patches_are_exact(arb *a)
{
    static const uint8_t cuts[4][3] = { { 0, 0, 0 }, { 1, 0, 1 }, { 2, 2, 1 }, { 0, 3, 0 } };
    const unsigned d = 5 + arb_below(a, 5), i = 1 + arb_below(a, 65534),
                   j = 1 + arb_below(a, 65535 - i);
    const uint8_t *cut = cuts[arb_below(a, 4)];
    const loft_unit one = loft_unit_of(i, 65536), two = loft_unit_of(j, 65536);
    const quad x = (quad)i / 65536, y = (quad)j / 65536;
    const function phi[3] = { { x, { 1, 0, 0, 0, 0 } },
                              { y, { 0, 1, 0, 0, 0 } },
                              { 1 - x - y, { -1, -1, 0, 0, 0 } } };
    exact_sum sum = { .size = { 0, 0 } };
    loft_basepoint b;
    loft_differential here;
    uint8_t l[3];
    unsigned k = 0;

    arb_net(a, &points, loft_multiindex_count(3, d));
    CHECK(loft_basepoint_init(&b, points.p, points.w, d, cut) == LOFT_OK &&
          loft_basepoint_differential(&b, one, two, &here) == LOFT_OK);
    loft_multiindex_first(l, 3, d);
    do {
        if (l[0] + cut[0] <= (int)d && l[1] + cut[1] <= (int)d && l[2] + cut[2] <= (int)d)
            add_term(&sum, &points.p[k],
                     loft_multiindex_multinomial(l, 3) * (quad)exact_of(points.w[k]), phi, l, 3);
        k++;
    } while (loft_multiindex_next(l, 3));
    check_slopes(&sum, &here);
}

/* Also on the side at a cut corner, v = 0, where phi has no derivatives. */
static void derivatives_at_a_corner_are_exact(arb *a)
{
    static const uint8_t cuts[4][3] = { { 0, 0, 0 }, { 1, 0, 1 }, { 2, 2, 1 }, { 0, 3, 0 } };
    const unsigned d = 5 + arb_below(a, 5), corner = arb_below(a, 3), i = 1 + arb_below(a, 65535);
    const unsigned j = arb_below(a, 4) ? 1 + arb_below(a, 65535) : 0;
    const uint8_t *cut = cuts[arb_below(a, 4)];
    const loft_unit u = loft_unit_of(i, 65536), v = loft_unit_of(j, 65536);
    const quad x = (quad)i / 65536, y = (quad)j / 65536;
    const function factor_of[4] = { { 1 - y, { 0, -1, 0, 0, 0 } },
                                    { 1 - x, { -1, 0, 0, 0, 0 } },
                                    { x, { 1, 0, 0, 0, 0 } },
                                    { y, { 0, 1, 0, 0, 0 } } };
    exact_sum sum = { .size = { 0, 0 } };
    loft_basepoint b;
    loft_differential here;
    uint8_t l[3];
    unsigned k = 0;

    if (i == 65536 || j == 65536)
        return;
    arb_net(a, &points, loft_multiindex_count(3, d));
    CHECK(loft_basepoint_init(&b, points.p, points.w, d, cut) == LOFT_OK);
    CHECK(loft_basepoint_corner_differential(&b, corner, u, v, &here) == LOFT_OK);
    CHECK(loft_basepoint_corner_differential(&b, 3, u, v, &here) == LOFT_ERR_ARG);
    loft_multiindex_first(l, 3, d);
    do {
        const uint8_t e[4] = { l[corner], l[(corner + 1) % 3], l[(corner + 2) % 3],
                               (uint8_t)(d - l[corner] - cut[corner]) };
        const quad ways = loft_multiindex_multinomial(l, 3);
        if (l[0] + cut[0] <= (int)d && l[1] + cut[1] <= (int)d && l[2] + cut[2] <= (int)d)
            add_term(&sum, &points.p[k], ways * (quad)exact_of(points.w[k]), factor_of, e, 4);
        k++;
    } while (loft_multiindex_next(l, 3));
    check_slopes(&sum, &here);
}

/* A common factor of the weights changes neither the surface nor the widths by which normals are
 * judged. */
static void widths_are_those_of_the_surface(arb *a)
{
    arb_domain p = arb_convex(a);
    loft_jet phi[LOFT_SIDES_MAX];
    loft_differential here, there;
    loft_spatch s;

    settle(&p);
    arb_net(a, &points, loft_multiindex_count(p.n, 2));
    for (unsigned k = 0; k < loft_multiindex_count(p.n, 2); k++)
        points.w[k] = loft_real_from_int(1 + (int32_t)arb_below(a, 16));
    CHECK(loft_wachspress_jet(&p.d, p.v[arb_below(a, p.n)], phi) == LOFT_OK);
    CHECK(loft_spatch_init(&s, points.p, points.w, p.n, 2) == LOFT_OK &&
          loft_spatch_differential(&s, phi, &here) == LOFT_OK);
    for (unsigned k = 0; k < loft_multiindex_count(p.n, 2); k++)
        points.w[k] *= 4;
    CHECK(loft_spatch_init(&s, points.p, points.w, p.n, 2) == LOFT_OK &&
          loft_spatch_differential(&s, phi, &there) == LOFT_OK);
    CHECK_EXACT(exact_sci(there.width_u), exact_sci(here.width_u),
                exact_sci(here.width_u) * BY_NUM(0x1p-55L, 0x1p-48L, 0x1p-48L));
    CHECK_EXACT(exact_sci(there.width_v), exact_sci(here.width_v),
                exact_sci(here.width_v) * BY_NUM(0x1p-55L, 0x1p-48L, 0x1p-48L));
}

static void where_there_is_no_point_there_are_no_derivatives(arb *a)
{
    static const uint8_t cut[3] = { 1, 0, 0 };
    loft_lattice_polygon l = { .sides = 0 };
    const loft_whole v[3] = { { { 0, 0 } }, { { 4, 0 } }, { { 0, 4 } } };
    loft_differential here;
    loft_basepoint b;
    loft_toric t;

    arb_net(a, &points, 21);
    CHECK(loft_basepoint_init(&b, points.p, points.w, 3, cut) == LOFT_OK);
    CHECK(loft_basepoint_differential(&b, LOFT_UNIT(1), 0, &here) == LOFT_SINGULAR &&
          loft_basepoint_differential(&b, LOFT_UNIT(1), LOFT_UNIT(1), &here) == LOFT_ERR_ARG);
    CHECK(loft_lattice_polygon_init(&l, v, 3) == LOFT_OK &&
          loft_toric_init(&t, &l, points.p, NULL, NULL) == LOFT_OK);
    CHECK(loft_toric_differential(&t, spot_raw(-1, 5), &here) == LOFT_ERR_RANGE &&
          loft_toric_differential(&t, spot_raw(0, 0), &here) == LOFT_OK);
}

int main(void)
{
    PROPERTY(derivatives_of_s_patches_are_exact, 300);
    PROPERTY(a_flat_triangle_does_not_bend, 300);
    PROPERTY(derivatives_of_toric_patches_are_exact, 300);
    PROPERTY(derivatives_of_base_point_patches_are_exact, 300);
    PROPERTY(derivatives_at_a_corner_are_exact, 300);
    PROPERTY(widths_are_those_of_the_surface, 200);
    PROPERTY(where_there_is_no_point_there_are_no_derivatives, 5);
    return check_failures();
}

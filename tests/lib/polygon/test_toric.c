/* tests/lib/polygon/test_toric.c -- properties of lib/polygon/toric.h and lattice.h
 * SPDX-License-Identifier: MIT
 */
#include "support/arb_patch.h"              /* arb_net, power */
#include "support/lattices.h"               /* arb_lattice */
#include "polygon/toric.h"
#include "surface/tensor/tensor.h"
#include "surface/triangle/triangle.h"

static net points;
static loft_real factor[PATCH_POINTS];

/* `tame`: points to 100 and weights as multiples of a power of two. */
static loft_toric arb_toric(arb *a, const loft_lattice_polygon *l)
{
    const unsigned count = loft_lattice_polygon_count(l);
    loft_toric t = { 0, 0, 0, 0 };

    arb_net(a, &points, count);
    for (unsigned k = 0; k < count; k++)
        factor[k] = loft_real_from_int(1 + (int32_t)arb_below(a, 30));
    CHECK(loft_toric_init(&t, l, points.p, factor, points.w) == LOFT_OK);
    return t;
}

/* A point of the polygon: inside, on an edge, or 2^-16 beside one. */
static bool arb_spot(arb *a, const loft_lattice_polygon *l, loft_spot *p)
{
    const loft_whole *s = &l->edge[arb_below(a, l->sides)].from,
                     *t = &l->edge[arb_below(a, l->sides)].from;
    const int64_t k = arb_below(a, 257);
    int64_t at[2];

    for (int i = 0; i < 2; i++) {
        at[i] = 65536 * (int64_t)s->at[i] + 256 * k * (t->at[i] - s->at[i]) +
                (arb_below(a, 2) ? 0 : (int64_t)arb_below(a, 65537) - 32768);
        if (arb_below(a, 3) == 0)
            at[i] += (int64_t)arb_below(a, 3) - 1;
    }
    *p = spot_raw(at[0], at[1]);
    for (unsigned i = 0; i < l->sides; i++)
        if (l->edge[i].normal.at[0] * at[0] + l->edge[i].normal.at[1] * at[1] +
                65536 * (int64_t)l->edge[i].offset <
            0)
            return false;
    return true;
}

static long double height(const loft_lattice_polygon *l, unsigned i, loft_spot p)
{
    return l->edge[i].normal.at[0] * exact_of(p.at[0]) +
           l->edge[i].normal.at[1] * exact_of(p.at[1]) + l->edge[i].offset;
}

static void exact_toric(const loft_toric *t, loft_spot p, long double out[LOFT_AXES])
{
    loft_whole q;
    long double w = 0;
    unsigned k = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = 0;
    loft_lattice_polygon_first(t->lattice, &q);
    do {
        long double b = exact_of(t->w[k]) * exact_of(t->c[k]);
        for (unsigned i = 0; i < t->lattice->sides; i++)
            b *= power(height(t->lattice, i, p),
                       (unsigned)loft_lattice_polygon_height(t->lattice, i, q));
        w += b;
        for (int i = 0; i < LOFT_AXES; i++)
            out[i] += b * exact_of(t->p[k].axis[i]);
        k++;
    } while (loft_lattice_polygon_next(t->lattice, &q));
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] /= w;
}

/* Pick: twice the area is 2 inside + boundary - 2. */
static void a_lattice_has_the_points_that_pick_counts(arb *a)
{
    const loft_lattice_polygon l = arb_lattice(a);
    int twice = 0, boundary = 0;

    for (unsigned i = 0; i < l.sides; i++) {
        const loft_lattice_edge *e = &l.edge[i], *f = &l.edge[(i + 1) % l.sides];
        twice += e->from.at[0] * f->from.at[1] - e->from.at[1] * f->from.at[0];
        boundary += e->length;
        CHECK(loft_lattice_polygon_height(&l, i, e->from) == 0 &&
              loft_lattice_polygon_height(&l, i, f->from) == 0);
        CHECK(loft_lattice_polygon_height(&l, (i + 1) % l.sides, e->from) > 0);
        CHECK(e->from.at[0] + e->length * e->normal.at[1] == f->from.at[0] &&
              e->from.at[1] - e->length * e->normal.at[0] == f->from.at[1]);
    }
    CHECK(2 * (int)loft_lattice_polygon_count(&l) == twice + boundary + 2);
}

static void a_point_is_within_its_bound(arb *a)
{
    const loft_lattice_polygon l = arb_lattice(a);
    const loft_toric t = arb_toric(a, &l);
    long double want[LOFT_AXES];
    loft_vec v = { { 0 } };
    loft_spot p;

    const bool holds = arb_spot(a, &l, &p);
    CHECK(loft_toric_eval(&t, p, &v) == (holds ? LOFT_OK : LOFT_ERR_RANGE));
    if (!holds)
        return;
    exact_toric(&t, p, want);
    for (int i = 0; i < LOFT_AXES; i++)
        check_axis(v.axis[i], want[i], points.largest, 0x1p-16L,
                   loft_lattice_polygon_count(&l) + 128 * 40);
}

static void a_vertex_is_its_control_point(arb *a)
{
    const loft_lattice_polygon l = arb_lattice(a);
    const loft_toric t = arb_toric(a, &l);
    const loft_whole at = l.edge[arb_below(a, l.sides)].from;
    loft_vec v = { { 0 } };
    loft_whole q;
    unsigned k = 0;

    for (loft_lattice_polygon_first(&l, &q); q.at[0] != at.at[0] || q.at[1] != at.at[1]; k++)
        CHECK(loft_lattice_polygon_next(&l, &q));
    CHECK(loft_toric_eval(&t, spot_raw(65536 * at.at[0], 65536 * at.at[1]), &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(points.p[k].axis[i]),
                    BY_NUM(0, 1, 2) * ulp(points.largest));
}

/* Its weights are those of the patch over binomials. With these as factors all are 1, and the curve
 * is exact. */
static void an_edge_is_a_rational_curve(arb *a)
{
    const loft_lattice_polygon l = arb_lattice(a);
    loft_toric t = arb_toric(a, &l);
    const unsigned e = arb_below(a, l.sides), m = l.edge[e].length;
    const loft_whole from = l.edge[e].from, n = l.edge[e].normal;
    const int64_t k = arb_below(a, 65537);
    const loft_spot p = spot_raw(65536 * (int64_t)from.at[0] + k * m * n.at[1],
                                 65536 * (int64_t)from.at[1] - k * m * n.at[0]);
    loft_weighted w[LOFT_DEGREE_MAX + 1];
    long double want[LOFT_AXES];
    loft_rational curve;
    loft_unit u = 0;
    loft_whole q;
    unsigned place = 0;

    loft_lattice_polygon_first(&l, &q);
    do {
        const int along = n.at[1] ? (q.at[0] - from.at[0]) / n.at[1]
                                  : (q.at[1] - from.at[1]) / -n.at[0];
        factor[place] = loft_lattice_polygon_height(&l, e, q)
                            ? factor[place]
                            : loft_real_from_int(loft_binomial(m, (unsigned)along));
        place++;
    } while (loft_lattice_polygon_next(&l, &q));
    t.w = NULL;
    CHECK(loft_toric_edge(&t, e, w) == LOFT_OK && loft_rational_init(&curve, w, m) == LOFT_OK);
    for (unsigned i = 0; i <= m; i++)
        CHECK_EXACT(exact_of(w[i].w), exact_of(w[0].w), 0);
    CHECK(loft_toric_parameter(&t, e, p, &u) == LOFT_OK);
    t.w = points.w;
    for (unsigned i = 0; i < place; i++)
        points.w[i] = LOFT_REAL(1);
    exact_toric(&t, p, want);
    const loft_vec v = loft_rational_eval(&curve, u);
    for (int i = 0; i < LOFT_AXES; i++)          /* a parameter off by 2^-25, 2^-24, 2^-41 */
        CHECK_EXACT(exact_of(v.axis[i]), want[i],
                    BY_NUM(0.51L * LSB, 2 * ulp(points.largest), 0) +
                        2 * m * points.largest * BY_NUM(0x1p-25L, 0x1p-24L, 0x1p-41L));
    if (k && k < 65536) {
        loft_vec on = { { 0 } };
        CHECK(loft_toric_eval(&t, p, &on) == LOFT_OK);
        for (int i = 0; i < LOFT_AXES; i++)
            check_axis(on.axis[i], want[i], points.largest, 0x1p-16L, 128 * 40);
        CHECK(loft_toric_parameter(&t, (e + 1) % l.sides, p, &u) == LOFT_ERR_ARG);
    }
}

/* Multinomials over a triangle, products of binomials over a rectangle. */
static void classical_coefficients_make_classical_patches(arb *a)
{
    const unsigned d = 1 + arb_below(a, LOFT_DEGREE_MAX), e = 1 + arb_below(a, LOFT_DEGREE_MAX);
    const loft_whole tri[3] = { { { 0, 0 } }, { { (int8_t)d, 0 } }, { { 0, (int8_t)d } } };
    const loft_whole box[4] = {
        { { 0, 0 } }, { { (int8_t)d, 0 } }, { { (int8_t)d, (int8_t)e } }, { { 0, (int8_t)e } }
    };
    const bool triangle = arb_below(a, 2);
    loft_lattice_polygon l;
    loft_toric t;
    loft_tensor s;
    loft_triangle r;
    static loft_vec ordered[PATCH_POINTS];
    loft_vec v = { { 0 } }, w;
    loft_whole q;
    unsigned k = 0;

    CHECK(loft_lattice_polygon_init(&l, triangle ? tri : box, triangle ? 3 : 4) == LOFT_OK);
    arb_net(a, &points, loft_lattice_polygon_count(&l));
    loft_lattice_polygon_first(&l, &q);
    do {
        const unsigned x = (unsigned)q.at[0], y = (unsigned)q.at[1];
        factor[k] = loft_real_from_int(triangle ? loft_binomial(d, x) * loft_binomial(d - x, y)
                                                : loft_binomial(d, x) * loft_binomial(e, y));
        ordered[triangle ? loft_triangle_place(x, y) : x * (e + 1) + y] = points.p[k];
        k++;
    } while (loft_lattice_polygon_next(&l, &q));
    CHECK(loft_toric_init(&t, &l, points.p, factor, NULL) == LOFT_OK);
    const int32_t j = (int32_t)arb_below(a, 1025),
                  i = (int32_t)arb_below(a, triangle ? (uint32_t)(1025 - j) : 1025);
    CHECK(loft_toric_eval(&t, spot_raw(j * 64 * (int64_t)d, i * 64 * (int64_t)(triangle ? d : e)),
                          &v) == LOFT_OK);
    if (triangle) {
        CHECK(loft_triangle_init(&r, ordered, d) == LOFT_OK);
        const loft_bary at = { loft_unit_of((uint32_t)j, 1024), loft_unit_of((uint32_t)i, 1024) };
        w = loft_triangle_eval(&r, at);
    } else {
        CHECK(loft_tensor_init(&s, ordered, d, e) == LOFT_OK);
        w = loft_tensor_eval(&s, loft_unit_of((uint32_t)j, 1024), loft_unit_of((uint32_t)i, 1024));
    }
    for (int axis = 0; axis < LOFT_AXES; axis++)
        CHECK_EXACT(exact_of(v.axis[axis]), exact_of(w.axis[axis]),
                    BY_NUM(1, 2, 2600) * ulp(points.largest));
}

static void nonsense_is_refused(arb *a)
{
    loft_lattice_polygon l = { .sides = 77 };
    const loft_whole clockwise[3] = { { { 0, 0 } }, { { 0, 3 } }, { { 3, 0 } } },
                     line[3] = { { { 0, 0 } }, { { 1, 1 } }, { { 2, 2 } } };
    const loft_whole flat[4] = { { { 0, 0 } }, { { 1, 0 } }, { { 2, 0 } }, { { 0, 2 } } },
                     far[3] = { { { 0, 0 } }, { { 33, 0 } }, { { 0, 3 } } };
    const loft_whole wide[4] = {
        { { -32, -32 } }, { { 31, -31 } }, { { 32, 32 } }, { { -31, 31 } }
    };
    loft_toric t = { 0, 0, 0, 0 };

    CHECK(loft_lattice_polygon_init(&l, clockwise, 3) == LOFT_SINGULAR &&
          loft_lattice_polygon_init(&l, line, 3) == LOFT_SINGULAR);
    CHECK(loft_lattice_polygon_init(&l, flat, 4) == LOFT_SINGULAR &&
          loft_lattice_polygon_init(&l, far, 3) == LOFT_ERR_ARG);
    CHECK(loft_lattice_polygon_init(&l, line, 2) == LOFT_ERR_ARG &&
          loft_lattice_polygon_init(&l, line, 9) == LOFT_ERR_ARG && l.sides == 77);
    l = arb_lattice(a);
    arb_toric(a, &l);
    const unsigned k = arb_below(a, loft_lattice_polygon_count(&l));
    factor[k] = arb_below(a, 2) ? 0 : -LOFT_REAL(1);
    CHECK(loft_toric_init(&t, &l, points.p, factor, points.w) == LOFT_ERR_RANGE);
    CHECK(loft_toric_init(&t, &l, points.p, NULL, points.w) == LOFT_OK);
    points.w[k] = loft_real_from_raw(255);
    CHECK(loft_toric_init(&t, &l, points.p, NULL, points.w) == LOFT_ERR_RANGE);
    CHECK(loft_lattice_polygon_init(&l, wide, 4) == LOFT_OK);
    static loft_vec many[4400];
    CHECK(loft_lattice_polygon_count(&l) <= 4400 &&
          loft_toric_init(&t, &l, many, NULL, NULL) == LOFT_ERR_RANGE);
    CHECK(loft_toric_edge(&t, 8, NULL) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_lattice_has_the_points_that_pick_counts,        100);
    PROPERTY(a_point_is_within_its_bound,                     1500);
    PROPERTY(a_vertex_is_its_control_point,                    300);
    PROPERTY(an_edge_is_a_rational_curve,                     1000);
    PROPERTY(classical_coefficients_make_classical_patches,    300);
    PROPERTY(nonsense_is_refused,                               30);
    return check_failures();
}

/* tests/lib/polygon/test_laws.c -- common properties of coordinates in a polygon and of all patches
 * with n sides
 * SPDX-License-Identifier: MIT
 */
#include "curve/rational.h"                     /* loft_weighted */
#include "support/sided.h"                      /* arb_kind, point_at */
#include "surface/tensor/tensor_rational.h"     /* loft_tensor_rational_eval */


// Coordinates
// -----------

/* A polygon whose corners all turn left: points of a circle of radius 100, at angles in order. */
static unsigned arb_polygon(arb *a, loft_spot v[], loft_domain *d)
{
    for (;;) {
        const unsigned sides = 3 + arb_below(a, 6);
        for (unsigned i = 0; i < sides; i++) {
            const double angle = 2 * acos(-1) * (i + arb_below(a, 800) / 1000.0) / sides;
            v[i].at[0] = LOFT_REAL(round(6553600 * cos(angle)) / 65536);
            v[i].at[1] = LOFT_REAL(round(6553600 * sin(angle)) / 65536);
        }
        if (loft_domain_init(d, v, sides) == LOFT_OK && d->convex)
            return sides;
    }
}

static loft_spot arb_spot(arb *a, const loft_spot v[], unsigned sides)
{
    double weight[LOFT_SIDES_MAX], sum = 0, at[2] = { 0, 0 };
    loft_spot p;

    for (unsigned i = 0; i < sides; i++)
        sum += weight[i] = 1 + arb_below(a, 1000);
    for (unsigned i = 0; i < sides; i++)
        for (int k = 0; k < 2; k++)
            at[k] += weight[i] / sum * (double)exact_of(v[i].at[k]);
    for (int k = 0; k < 2; k++)
        p.at[k] = LOFT_REAL(round(at[k] * 65536) / 65536);
    return p;
}

static long double value_of(loft_sci x)
{
    loft_acc wide = 0;
    CHECK(loft_sci_to_acc(x, &wide));
    return exact_acc(wide);
}

typedef enum loft_status coordinates_of(const loft_domain *d, loft_spot p, loft_sci phi[]);
static coordinates_of *const kinds[2] = { loft_wachspress_eval, loft_meanvalue_eval };

/* A wide number of q16 has 32 digits behind the point. */
#define COORDINATE BY_NUM(0x1p-31L, 0x1p-44L, 0x1p-44L)

static void coordinates_sum_to_one_and_give_the_point(arb *a)
{
    loft_spot v[LOFT_SIDES_MAX];
    loft_sci phi[LOFT_SIDES_MAX];
    loft_domain d;
    const unsigned sides = arb_polygon(a, v, &d);
    const loft_spot p = arb_spot(a, v, sides);

    for (int kind = 0; kind < 2; kind++) {
        long double sum = 0, at[2] = { 0, 0 };
        CHECK(kinds[kind](&d, p, phi) == LOFT_OK);
        for (unsigned i = 0; i < sides; i++) {
            sum += value_of(phi[i]);
            CHECK(loft_sci_sign(phi[i]) >= 0);
            for (int k = 0; k < 2; k++)
                at[k] += value_of(phi[i]) * exact_of(v[i].at[k]);
        }
        CHECK(fabsl(sum - 1) <= sides * COORDINATE);
        for (int k = 0; k < 2; k++)
            CHECK(fabsl(at[k] - exact_of(p.at[k])) <= 100 * sides * COORDINATE);
    }
}

/* Exactly 1 at the own vertex and 0 at all others; on an edge only those of its ends are not 0. */
static void coordinates_belong_to_their_vertex(arb *a)
{
    loft_spot v[LOFT_SIDES_MAX], middle;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_domain d;
    const unsigned sides = arb_polygon(a, v, &d), at = arb_below(a, sides), next = (at + 1) % sides;

    for (int k = 0; k < 2; k++)
        middle.at[k] = LOFT_REAL((double)(exact_of(v[at].at[k]) + exact_of(v[next].at[k])) / 2);
    const bool on =
        fabsl(2 * exact_of(middle.at[0]) - exact_of(v[at].at[0]) - exact_of(v[next].at[0])) <= 0 &&
        fabsl(2 * exact_of(middle.at[1]) - exact_of(v[at].at[1]) - exact_of(v[next].at[1])) <= 0;
    for (int kind = 0; kind < 2; kind++) {
        CHECK(kinds[kind](&d, v[at], phi) == LOFT_OK);
        for (unsigned i = 0; i < sides; i++)
            CHECK(fabsl(value_of(phi[i]) - (i == at)) <= 0);
        if (!on)
            continue;                   /* the number type does not hold the middle */
        CHECK(kinds[kind](&d, middle, phi) == LOFT_OK);
        for (unsigned i = 0; i < sides; i++)
            CHECK(fabsl(value_of(phi[i]) - (i == at || i == next ? 0.5L : 0)) <= 0);
    }
}

/* Over a parallelogram Wachspress's are products of the coordinates along two sides. */
static void over_a_parallelogram_wachspress_is_bilinear(arb *a)
{
    const int x[2] = { 40 + (int)arb_below(a, 40), (int)arb_below(a, 30) },
              y[2] = { (int)arb_below(a, 30) - 15, 40 + (int)arb_below(a, 40) };
    const unsigned i = arb_below(a, 257), j = arb_below(a, 257);
    const long double s = i / 256.0L, t = j / 256.0L,
                      want[4] = { (1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t };
    loft_spot v[4], p;
    loft_sci phi[4];
    loft_domain d;

    for (int k = 0; k < 2; k++) {
        v[0].at[k] = LOFT_REAL(-20);
        v[1].at[k] = LOFT_REAL(-20 + x[k]);
        v[2].at[k] = LOFT_REAL(-20 + x[k] + y[k]);
        v[3].at[k] = LOFT_REAL(-20 + y[k]);
        p.at[k] = LOFT_REAL(-20 + (double)s * x[k] + (double)t * y[k]);
    }
    CHECK(loft_domain_init(&d, v, 4) == LOFT_OK);
    CHECK(loft_wachspress_eval(&d, p, phi) == LOFT_OK);
    for (unsigned k = 0; k < 4; k++)
        CHECK(fabsl(value_of(phi[k]) - want[k]) <= 4 * COORDINATE);
}


// Patches
// -------

/* Rounded once. */
#define POINT_ERROR BY_NUM(0x1p-16L, 0x1p-16L, 0x1p-40L)

static void one_point_everywhere_is_all_of_the_patch(arb *a)
{
    scene *x = arb_kind(a, arb_below(a, KINDS), 5);
    const loft_vec p = arb_vec(a, 300);

    for (unsigned k = 0; k < POINTS; k++)
        x->p[k] = p;
    for (int n = 0; n < 8; n++) {
        const loft_vec at = point_at(x, arb_unit(a), arb_unit(a));
        CHECK(apart(&at, &p) <= POINT_ERROR);
    }
}

/* q = M p + b, in whole numbers, so that mapping the net rounds nothing in q16. */
static void affine_maps_of_the_net_map_the_patch(arb *a)
{
    scene *x = arb_kind(a, arb_below(a, KINDS), 5);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const loft_vec before = point_at(x, u, v);
    int m[LOFT_AXES][LOFT_AXES + 1];

    for (int i = 0; i < LOFT_AXES; i++)
        for (int j = 0; j <= LOFT_AXES; j++)
            m[i][j] = (int)arb_below(a, 7) - 3;
    for (unsigned k = 0; k < POINTS; k++) {
        const loft_vec p = x->p[k];
        for (int i = 0; i < LOFT_AXES; i++) {
            x->p[k].axis[i] = (loft_real)m[i][LOFT_AXES] * LOFT_REAL(1);
            for (int j = 0; j < LOFT_AXES; j++)
                x->p[k].axis[i] += (loft_real)m[i][j] * p.axis[j];
        }
    }
    const loft_vec after = point_at(x, u, v);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double want = m[i][LOFT_AXES], errors = 1;
        for (int j = 0; j < LOFT_AXES; j++) {
            want += m[i][j] * exact_of(before.axis[j]);
            errors += abs(m[i][j]);
        }
        CHECK(fabsl(exact_of(after.axis[i]) - want) <=
              errors * BY_NUM(0x1.1p-17L, 0x1p-14L, 0x1p-38L));
    }
}

/* Control points at sum l_i v_i / depth: the patch is the polygon, point by point. */
static void a_net_of_the_vertices_is_the_polygon(arb *a)
{
    scene *x = arb_kind(a, arb_below(a, 2), 0);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const long double angle = exact_unit(v) * x->sides;
    const unsigned side = angle >= x->sides ? x->sides - 1 : (unsigned)angle;
    long double from[2], to[2];
    const loft_vec p = point_at(x, u, v);

    vertex_of(x->sides, side, 50, from);
    vertex_of(x->sides, side + 1, 50, to);
    for (int k = 0; k < 2; k++) {
        const long double on = from[k] + (angle - side) * (to[k] - from[k]);
        CHECK(fabsl(exact_of(p.axis[k]) - exact_unit(u) * on) <=
              BY_NUM(3 * 0x1p-16L, 0x1p-13L, 1e-4L));
    }
}

/* There is a control point where the sides meet. */
static void corners_are_control_points(arb *a)
{
    scene *x = arb_kind(a, arb_below(a, KINDS), 5);
    const unsigned corner = arb_below(a, x->sides);
    const loft_vec p = point_at(x, LOFT_UNIT(1), loft_unit_of(corner, x->sides));
    long double nearest = 1e9L;

    for (unsigned k = 0; k < POINTS; k++)
        nearest = fminl(nearest, apart(&p, &x->p[k]));
    CHECK(nearest <= BY_NUM(8 * 0x1p-16L, 0x1p-12L, 1e-10L));
}

/* Degree 2, with one point cut off corner 3: blown up there it is a rational tensor product of
 * degrees 2 and 1. The row v = 0 is the line between two points, degree-elevated. */
static void a_triangle_without_its_tip_is_a_tensor_product(arb *a)
{
    static const uint8_t cut[3] = { 0, 0, 1 };
    static const unsigned rank[5] = { 0, 1, 3, 2, 4 };      /* 200 110 020, 101 011 */
    loft_vec p[6], q;
    loft_real w[6];
    loft_weighted net[6];
    loft_basepoint b;
    loft_tensor_rational s;

    for (unsigned k = 0; k < 6; k++) {
        p[k] = arb_vec(a, 100);
        w[k] = LOFT_REAL(2 * (1 + (double)arb_below(a, 16)));
    }
    CHECK(loft_basepoint_init(&b, p, w, 2, cut) == LOFT_OK);
    for (unsigned i = 0; i < 3; i++) {                      /* net[2 i + j]: i along u, j along v */
        net[2 * i + 1].p = p[rank[i]];
        net[2 * i + 1].w = w[rank[i]] / 2;
    }
    for (unsigned i = 0; i < 3; i += 2) {
        net[2 * i].p = p[rank[3 + i / 2]];
        net[2 * i].w = w[rank[3 + i / 2]];
    }
    net[2].w = (net[0].w + net[4].w) / 2;
    for (int k = 0; k < LOFT_AXES; k++) {
        const long double mean = (exact_of(net[0].p.axis[k]) * exact_of(net[0].w) +
                                  exact_of(net[4].p.axis[k]) * exact_of(net[4].w)) /
                                 2 / exact_of(net[2].w);
        net[2].p.axis[k] = LOFT_REAL((double)mean);
    }
    CHECK(loft_tensor_rational_init(&s, net, 2, 1) == LOFT_OK);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    CHECK(loft_basepoint_uv(&b, u, v, &q) == LOFT_OK);
    const loft_vec t = loft_tensor_rational_eval(&s, u, v);
    CHECK(apart(&q, &t) <= BY_NUM(3 * 0x1p-16L, 0x1p-14L, 1e-11L));
}

int main(void)
{
    PROPERTY(coordinates_sum_to_one_and_give_the_point, 200);
    PROPERTY(coordinates_belong_to_their_vertex, 200);
    PROPERTY(over_a_parallelogram_wachspress_is_bilinear, 200);
    PROPERTY(one_point_everywhere_is_all_of_the_patch, 150);
    PROPERTY(affine_maps_of_the_net_map_the_patch, 200);
    PROPERTY(a_net_of_the_vertices_is_the_polygon, 150);
    PROPERTY(corners_are_control_points, 150);
    PROPERTY(a_triangle_without_its_tip_is_a_tensor_product, 150);
    return check_failures();
}

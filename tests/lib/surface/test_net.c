/* tests/lib/surface/test_net.c -- properties of lib/surface/net.h, and of searches in nets that are
 * not tensor products without weights
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"          /* exact_of, exact_acc, exact_unit; CHECK, PROPERTY */
#include "support/exact_sci.h"      /* exact_sci */
#include "surface/differential.h"
#include "surface/net_nearest.h"
#include "surface/net_ray.h"
#include "surface/octant.h"

#if LOFT_AXES < 3
#  error "nets need space"
#endif

#define MOST ((LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1))
#define ROOM 40
#define GRID 24

/* A surface of one of the four kinds with a net. */
typedef struct {
    unsigned kind;
    loft_vec p[MOST];
    loft_weighted w[MOST];
    loft_tensor tensor;
    loft_tensor_rational tensor_rational;
    loft_triangle triangle;
    loft_triangle_rational triangle_rational;
    loft_net net;
    unsigned m, n;
} patch;

/* Weights from 1/4 to 4; a net over a grid that moves, so that few rays touch. */
static void arb_patch(arb *a, patch *s, unsigned most)
{
    const unsigned m = 1 + arb_below(a, most), n = 1 + arb_below(a, most);

    s->kind = arb_below(a, 4);
    s->m = m;
    s->n = s->kind < 2 ? n : m;
    for (unsigned k = 0; k < MOST; k++) {
        s->p[k] = (loft_vec) { { 0 } };
        for (int axis = 0; axis < 3; axis++)
            s->p[k].axis[axis] = arb_real(a, axis == 2 ? 10 : 3);
        s->w[k].w = loft_real_from_raw(16384 * (1 + (int32_t)arb_below(a, 16)));
    }
    for (unsigned i = 0; i <= s->m; i++)
        for (unsigned j = 0; j <= (s->kind < 2 ? s->n : s->m - i); j++) {
            const unsigned k = s->kind < 2 ? i * (s->n + 1) + j : loft_triangle_place(i, j);
            s->p[k].axis[0] += loft_real_from_int(8 * (int32_t)i);
            s->p[k].axis[1] += loft_real_from_int(8 * (int32_t)j);
        }
    for (unsigned k = 0; k < MOST; k++)
        s->w[k].p = s->p[k];
    if (s->kind == 0) {
        CHECK(loft_tensor_init(&s->tensor, s->p, m, n) == LOFT_OK);
        s->net = loft_net_from_tensor(&s->tensor);
    } else if (s->kind == 1) {
        CHECK(loft_tensor_rational_init(&s->tensor_rational, s->w, m, n) == LOFT_OK);
        s->net = loft_net_from_tensor_rational(&s->tensor_rational);
    } else if (s->kind == 2) {
        CHECK(loft_triangle_init(&s->triangle, s->p, m) == LOFT_OK);
        s->net = loft_net_from_triangle(&s->triangle);
    } else {
        CHECK(loft_triangle_rational_init(&s->triangle_rational, s->w, m) == LOFT_OK);
        s->net = loft_net_from_triangle_rational(&s->triangle_rational);
    }
}

static loft_vec point_at(const patch *s, loft_unit u, loft_unit v)
{
    const loft_bary at = { u, v };

    return s->kind == 0   ? loft_tensor_eval(&s->tensor, u, v)
           : s->kind == 1 ? loft_tensor_rational_eval(&s->tensor_rational, u, v)
           : s->kind == 2 ? loft_triangle_eval(&s->triangle, at)
                          : loft_triangle_rational_eval(&s->triangle_rational, at);
}

static long double distance_between(loft_vec a, loft_vec b)
{
    long double sum = 0;

    for (int axis = 0; axis < 3; axis++)
        sum += powl(exact_of(a.axis[axis]) - exact_of(b.axis[axis]), 2);
    return sqrtl(sum);
}

/* Twice the roundings of a point, and of the parameters: derivatives are below 16 degree times the
 * size of the net. */
#define ROUNDED BY_NUM(0x1p-15L + 2000 * 0x1p-24L, 0x1p-16L + 2000 * 0x1p-23L, 1e-9L)

static enum loft_status differential_at(const patch *s, loft_unit u, loft_unit v,
                                        loft_differential *out)
{
    const loft_bary at = { u, v };

    return s->kind == 0   ? loft_tensor_differential(&s->tensor, u, v, out)
           : s->kind == 1 ? loft_tensor_rational_differential(&s->tensor_rational, u, v, out)
           : s->kind == 2 ? loft_triangle_differential(&s->triangle, at, out)
                          : loft_triangle_rational_differential(&s->triangle_rational, at, out);
}

/* Points and derivatives are those of the surface; in a triangle P_x = (1 - y) P_v + y P_w and
 * P_y = x (P_w - P_v). */
static void forms_are_the_surface(arb *a)
{
    static patch s;
    static loft_net_form f;
    const long double x = arb_below(a, 65) / 64.0L, y = arb_below(a, 65) / 64.0L;
    const loft_sci at_x = loft_sci_from_unit(LOFT_UNIT(x)), at_y = loft_sci_from_unit(LOFT_UNIT(y));
    loft_sci jet[LOFT_NET_JET][LOFT_AXES];
    loft_differential here;
    loft_unit place[2];

    arb_patch(a, &s, 5);
    const loft_vec zero = { { 0 } };
    loft_net_load(s.net, zero, &f);
    loft_net_form_jet(&f, 2, at_x, at_y, jet);
    loft_net_form_place(&f, at_x, at_y, place);
    const loft_vec p = point_at(&s, place[0], place[1]);
    CHECK(differential_at(&s, place[0], place[1], &here) == LOFT_OK);
    for (int axis = 0; axis < 3; axis++) {
        const long double u = exact_sci(here.u[axis]), v = exact_sci(here.v[axis]),
                          uu = exact_sci(here.uu[axis]), uv = exact_sci(here.uv[axis]),
                          vv = exact_sci(here.vv[axis]);
        const bool triangle = s.kind > 1;
        /* the place has 2^-24 in q16, and derivatives of the next order are below 2^18 */
        const long double near = BY_NUM(0x1p-5L, 0x1p-5L, 1e-8L);
        CHECK_NEAR(exact_sci(jet[LOFT_NET_POINT][axis]), exact_of(p.axis[axis]), ROUNDED);
        CHECK_NEAR(exact_sci(jet[LOFT_NET_BY_X][axis]), triangle ? (1 - y) * u + y * v : u, near);
        CHECK_NEAR(exact_sci(jet[LOFT_NET_BY_Y][axis]), triangle ? x * (v - u) : v, near);
        CHECK_NEAR(exact_sci(jet[LOFT_NET_BY_XX][axis]),
                   triangle ? (1 - y) * (1 - y) * uu + 2 * y * (1 - y) * uv + y * y * vv : uu,
                   32 * near);
        CHECK_NEAR(exact_sci(jet[LOFT_NET_BY_XY][axis]),
                   triangle ? v - u + x * ((1 - y) * (uv - uu) + y * (vv - uv)) : uv, 32 * near);
        CHECK_NEAR(exact_sci(jet[LOFT_NET_BY_YY][axis]), triangle ? x * x * (uu - 2 * uv + vv) : vv,
                   32 * near);
    }
}

static void no_point_of_any_kind_is_nearer(arb *a)
{
    static patch s;
    loft_vec p = { { 0 } };
    loft_net_near near;

    arb_patch(a, &s, 3);
    for (int axis = 0; axis < 3; axis++)
        p.axis[axis] = arb_real(a, 40);
    CHECK(loft_net_nearest(s.net, p, LOFT_REAL(0.001), &near) == LOFT_OK);
    const loft_vec there = point_at(&s, near.u, near.v);
    CHECK(distance_between(there, near.point) <= ROUNDED);
    CHECK_NEAR(distance_between(near.point, p), exact_acc(near.distance), ROUNDED);
    for (unsigned i = 0; i <= GRID; i++)
        for (unsigned j = 0; j <= (s.kind < 2 ? GRID : GRID - i); j++) {
            const loft_vec other = point_at(&s, loft_unit_of(i, GRID), loft_unit_of(j, GRID));
            CHECK(exact_acc(near.distance) <= distance_between(other, p) + 0.001L + 0x1p-15L);
        }
}

static void a_ray_at_a_point_of_any_kind_hits_it(arb *a)
{
    static patch s;
    loft_ray_hit hit[ROOM];
    loft_vec from = { { 0 } };
    unsigned count;
    bool found = false;

    arb_patch(a, &s, 3);
    const uint32_t i = 1 + arb_below(a, 254), j = 1 + arb_below(a, s.kind < 2 ? 254 : 255 - i);
    const loft_vec at = point_at(&s, loft_unit_of(i, 256), loft_unit_of(j, 256));
    for (int axis = 0; axis < 3; axis++)
        from.axis[axis] = arb_real(a, 30);
    const loft_vec d = loft_vec_sub(at, from);
    const enum loft_status status = loft_net_ray(s.net, from, d, hit, ROOM, &count);
    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    for (unsigned k = 0; k < count; k++) {
        const loft_vec p = point_at(&s, hit[k].u, hit[k].v);
        for (int axis = 0; axis < 3; axis++)
            CHECK_NEAR(exact_of(p.axis[axis]),
                       exact_of(from.axis[axis]) + exact_acc(hit[k].t) * exact_of(d.axis[axis]),
                       hit[k].touch ? 0x1p-8L : 2 * ROUNDED);
        CHECK(k == 0 || hit[k - 1].t <= hit[k].t);
        found = found || fabsl(exact_acc(hit[k].t) - 1) < 0x1p-6L;
    }
    CHECK(found);
}

/* An octant of a sphere about 0: the foot of p is r p / |p|, and a ray from 0 meets it there. */
static void an_octant_is_met_at_its_radius(arb *a)
{
    const int32_t radius = 1 + (int32_t)arb_below(a, 100);
    loft_weighted net[15];
    loft_triangle_rational t;
    loft_net_near near;
    loft_ray_hit hit[ROOM];
    loft_vec p = { { 0 } }, zero = { { 0 } };
    unsigned count;

    CHECK(loft_octant_from_radius(loft_real_from_int(radius), net) == LOFT_OK);
    CHECK(loft_triangle_rational_init(&t, net, 4) == LOFT_OK);
    for (int axis = 0; axis < 3; axis++)
        p.axis[axis] = loft_real_from_int(1 + (int32_t)arb_below(a, 60));
    const long double length = distance_between(p, zero);
    /* weights have 2^-16 in q16, of some 5; their quotients move points by less than r 2^-14 */
    const long double round = radius * BY_NUM(0x1p-14L, 0x1p-21L, 1e-13L) + ROUNDED;
    CHECK(loft_net_nearest(loft_net_from_triangle_rational(&t), p, LOFT_REAL(0.0001), &near) ==
          LOFT_OK);
    CHECK_NEAR(exact_acc(near.distance), fabsl(length - radius), round + 0.0001L);
    CHECK(loft_net_ray(loft_net_from_triangle_rational(&t), zero, p, hit, ROOM, &count) == LOFT_OK);
    CHECK(count == 1);
    CHECK_NEAR(exact_acc(hit[0].t) * length, radius, round);
}

/* The corners of a triangle, one of which is an edge of the form. */
static void corners_of_triangles_are_exact(arb *a)
{
    static patch s;
    loft_net_near near;

    do
        arb_patch(a, &s, 4);
    while (s.kind < 2);
    for (unsigned corner = 0; corner < 3; corner++) {
        const loft_unit v = corner == 1 ? LOFT_UNIT(1) : 0, w = corner == 2 ? LOFT_UNIT(1) : 0;
        loft_vec far = point_at(&s, v, w);
        const loft_vec there = far;
        far.axis[0] += corner == 1 ? LOFT_REAL(400) : LOFT_REAL(-200);
        far.axis[1] += corner == 2 ? LOFT_REAL(400) : LOFT_REAL(-200);
        CHECK(loft_net_nearest(s.net, far, LOFT_REAL(0.001), &near) == LOFT_OK);
        CHECK(exact_acc(near.distance) <= distance_between(there, far) + 1e-6L);
        if (loft_vec_equal(near.point, there))
            CHECK(!(near.u < v) && !(near.u > v) && !(near.v < w) && !(near.v > w));
    }
}

int main(void)
{
    PROPERTY(forms_are_the_surface, 100);
    PROPERTY(no_point_of_any_kind_is_nearer, 40);
    PROPERTY(a_ray_at_a_point_of_any_kind_hits_it, 60);
    PROPERTY(an_octant_is_met_at_its_radius, 10);
    PROPERTY(corners_of_triangles_are_exact, 10);
    return check_failures();
}

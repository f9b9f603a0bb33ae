/* tests/lib/surface/test_area.c -- properties of lib/surface/area.h
 * SPDX-License-Identifier: MIT
 *
 * Spheres, cylinders and cones have areas and volumes in closed form; others are compared with
 * Gauss's rule.
 */
#include "check.h"              /* CHECK, PROPERTY, BY_NUM */
#include "support/exact_sci.h"      /* exact_sci */
#include "surface/area.h"
#include "surface/differential.h"
#include "surface/octant.h"             /* loft_octant_from_radius */
#include "surface/tensor/revolve.h"     /* loft_tensor_rational_from_revolve */
#include "surface/volume.h"             /* loft_net_volume */
#include "support/tensors.h"    /* tensor_fill, tensor_exact */
#include "support/weighted.h"   /* arb_weighted, gauss */

#define PI 3.14159265358979323846264338327950288L

static loft_sci memory[LOFT_NET_AREA_MEMORY(LOFT_DEGREE_MAX, 5)];

static long double density(const loft_tensor *s, long double u, long double v)
{
    long double a[3] = { 0 }, b[3] = { 0 }, sum = 0;

    for (int i = 0; i < 3 && i < LOFT_AXES; i++) {
        a[i] = tensor_exact(s, i, 1, 0, u, v);
        b[i] = tensor_exact(s, i, 0, 1, u, v);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += (a[j] * b[k] - a[k] * b[j]) * (a[j] * b[k] - a[k] * b[j]);
    }
    return sqrtl(sum);
}

static long double density_of_tensor(const void *s, long double u, long double v)
{
    return density(s, u, v);
}

static long double integral(const loft_tensor *s, unsigned parts)
{
    return gauss(density_of_tensor, s, parts);
}

/* A surface over a square of the given size, with bumps of `height` times that size. */
static tensor *arb_sheet(arb *a, int32_t size, int32_t height)
{
    static tensor x;
    const unsigned m = 1 + arb_below(a, 3), n = 1 + arb_below(a, 3);

    tensor_fill(&x, a, m, n);
    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++)
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                const int64_t raw = (axis == 0   ? (int64_t)i * size / (int64_t)m
                                     : axis == 1 ? (int64_t)j * size / (int64_t)n
                                                 : 0) +
                                    arb_raw(a, height);
                x.p[i * (n + 1) + j].axis[axis] = (loft_real)BY_NUM(raw, (double)raw / 65536,
                                                                    (double)raw / 65536);
            }
    return &x;
}

static void an_area_is_within_its_tolerance(arb *a)
{
    const int32_t size = (int32_t)1 << (12 + arb_below(a, 16));
    const tensor *x = arb_sheet(a, size, size / 8 + 1);
    const long double extent = exact_of(loft_real_from_raw(size));
    const loft_real tol =
        (loft_real)(LOFT_REAL_LSB +
                    (loft_real)BY_NUM(
                        extent * extent * 65536 / 500 < 1e9L ? extent * extent * 65536 / 500 : 1e9L,
                        extent * extent / 500, extent * extent / 500));
    loft_acc area;

    CHECK(loft_net_area(loft_net_from_tensor(&x->s), tol, memory, &area) == LOFT_OK);
    CHECK_EXACT(exact_acc(area), integral(&x->s, 4),
                exact_of(tol) + BY_NUM(0x1p-32L, 0, 0) + 1e-9L * extent * extent);
}

static void a_finer_tolerance_is_kept_too(arb *a)
{
    const tensor *x = arb_sheet(a, 65536 * 10, 65536);
    const loft_real tol = LOFT_REAL(0.0001);
    loft_acc area;

    CHECK(loft_net_area(loft_net_from_tensor(&x->s), tol, memory, &area) == LOFT_OK);
    CHECK_EXACT(exact_acc(area), integral(&x->s, 8), exact_of(tol) + 1e-7L);
}

/* A plane patch, whatever its parametrization: the corners of the rectangle give the area. */
static void a_plane_patch_is_exact(arb *a)
{
    static tensor x;
    const unsigned large = 1 + arb_below(a, LOFT_DEGREE_MAX), small = 1 + arb_below(a, 5),
                   m = arb_below(a, 2) ? large : small, n = m == large ? small : large;
    const int64_t wide = 65536 + arb_below(a, 1u << 30), high = 65536 + arb_below(a, 1u << 30);
    loft_acc area;

    tensor_fill(&x, a, m, n);
    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++)
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                const int64_t raw = axis == 1   ? wide * i * i / (m * m)
                                    : axis == 2 ? high * j / n
                                                : 0;
                x.p[i * (n + 1) + j].axis[axis] = (loft_real)BY_NUM(raw, (double)raw / 65536,
                                                                    (double)raw / 65536);
            }
    const long double want = exact_of(x.p[(m + 1) * (n + 1) - 1].axis[1]) *
                             exact_of(x.p[n].axis[2]);
    CHECK(loft_net_area(loft_net_from_tensor(&x.s), LOFT_REAL(0.001), memory, &area) == LOFT_OK);
    CHECK_EXACT(exact_acc(area), want,
                0x1p-30L * BY_NUM(1, 0, 0) + 81 * want * BY_NUM(0x1p-48L, 0x1p-40L, 0x1p-40L));
}

static void what_cannot_be_answered_is_refused(arb *a)
{
    tensor *x = arb_sheet(a, 65536 * 1000, 65536 * 100);
    loft_acc area = 77;

    CHECK(loft_net_area(loft_net_from_tensor(&x->s), 0, memory, &area) == LOFT_ERR_ARG);
    tensor_fill(x, a, 2, 2);                    /* folded along its diagonal: 3000 (u - v)^2 */
    for (unsigned i = 0; i <= 2; i++)
        for (unsigned j = 0; j <= 2; j++) {
            loft_vec *at = &x->p[3 * i + j];
            *at = (loft_vec) { { 0 } };
            at->axis[0] = loft_real_from_int(1500 * (int32_t)(2 * (i / 2 + j / 2)) -
                                             1500 * (int32_t)(i * j));
            at->axis[1] = loft_real_from_int(500 * (int32_t)(i + j));
        }
    CHECK(loft_net_area(loft_net_from_tensor(&x->s), LOFT_REAL(0.0001), memory, &area) ==
          LOFT_ERR_RANGE);
    CHECK(area > 76 && area < 78);
    tensor_fill(x, a, 1, 1);
    x->p[0] = x->p[1] = x->p[2] = x->p[3] = (loft_vec){ { 0 } };
    x->p[1].axis[1] = x->p[3].axis[1] = LOFT_REAL(32767);
    x->p[2].axis[0] = x->p[3].axis[0] = LOFT_REAL(32767);
    CHECK(loft_net_area(loft_net_from_tensor(&x->s), LOFT_REAL(1), memory, &area) == LOFT_OK);
    x->p[0].axis[0] = x->p[1].axis[0] = x->p[0].axis[1] = x->p[2].axis[1] = LOFT_REAL(-32767);
    area = 77;
    CHECK(loft_net_area(loft_net_from_tensor(&x->s), LOFT_REAL(1), memory, &area) ==
          BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
    CHECK(BY_NUM(area == 77, area > 4e9, area > 4e9));
}

static void a_patch_without_extent_has_none(arb *a)
{
    tensor *x = arb_sheet(a, 65536 * 10, 65536);
    loft_tensor line = x->s;
    loft_acc area = 1;

    line.n = 0;
    CHECK(loft_net_area(loft_net_from_tensor(&line), LOFT_REAL(0.01), memory, &area) == LOFT_OK &&
          !(area > 0) && !(area < 0));
}

/* The integral over a triangle of |P_v x P_w|, by Gauss's rule along x and y of net.h. */
static long double triangle_integral(const loft_triangle *t)
{
    static const long double node[8] = { 0.01985507175123188L, 0.10166676129318664L,
                                         0.2372337950418355L, 0.4082826787521751L,
                                         0.5917173212478249L, 0.7627662049581645L,
                                         0.8983332387068134L, 0.9801449282487681L };
    static const long double weight[8] = { 0.05061426814518813L, 0.11119051722668724L,
                                           0.15685332293894364L, 0.1813418916891810L,
                                           0.1813418916891810L,  0.15685332293894364L,
                                           0.11119051722668724L, 0.05061426814518813L };
    long double sum = 0;

    for (int i = 0; i < 8; i++)
        for (int j = 0; j < 8; j++) {
            const loft_bary at = { LOFT_UNIT(node[i] * (1 - node[j])),
                                   LOFT_UNIT(node[i] * node[j]) };
            loft_differential d;
            long double length = 0;
            CHECK(loft_triangle_differential(t, at, &d) == LOFT_OK);
            for (int k = 0; k < 3; k++) {
                const int x = (k + 1) % 3, y = (k + 2) % 3;
                length += powl(exact_sci(d.u[x]) * exact_sci(d.v[y]) -
                                   exact_sci(d.u[y]) * exact_sci(d.v[x]),
                               2);
            }
            sum += weight[i] * weight[j] * node[i] * sqrtl(length);
        }
    return sum;
}

/* A plane triangle has half the cross product of its sides; a bent one what the integral says. */
static void triangles_have_their_area(arb *a)
{
    const unsigned n = 1 + arb_below(a, 5);
    loft_vec p[LOFT_TRIANGLE_POINTS(5)];
    loft_triangle t;
    loft_acc area;

    for (int bent = 0; bent < 2; bent++) {
        for (unsigned i = 0; i <= n; i++)
            for (unsigned j = 0; i + j <= n; j++) {
                loft_vec *at = &p[loft_triangle_place(i, j)];
                *at = (loft_vec) { { 0 } };
                at->axis[0] = loft_real_from_int(4 * (int32_t)i - 7);
                at->axis[1] = loft_real_from_int(3 * (int32_t)j + 2 * (int32_t)i);
                at->axis[2] = bent ? arb_real(a, 2) : loft_real_from_int((int32_t)j);
            }
        CHECK(loft_triangle_init(&t, p, n) == LOFT_OK);
        CHECK(loft_net_area(loft_net_from_triangle(&t), LOFT_REAL(0.01), memory, &area) == LOFT_OK);
        /* sides n (4, 2, 0) and n (0, 3, 1): 12^2 + 4^2 + 2^2 = 164; a parameter has 2^-25 */
        CHECK_NEAR(exact_acc(area), bent ? triangle_integral(&t) : n * n * sqrtl(164) / 2,
                   bent ? 0.012L : 1e-6L);
    }
}


// Weights
// -------

static long double weighted_density(const void *s, long double u, long double v)
{
    long double j[3][4], sum = 0;

    weighted_jet(s, u, v, j);
    for (int k = 0; k < 3; k++) {
        const int x = (k + 1) % 3, y = (k + 2) % 3;
        long double by[2][3];
        for (int i = 0; i < 3; i++)
            for (int d = 0; d < 2; d++)
                by[d][i] = (j[d + 1][i] - j[0][i] / j[0][3] * j[d + 1][3]) / j[0][3];
        sum += powl(by[0][x] * by[1][y] - by[0][y] * by[1][x], 2);
    }
    return sqrtl(sum);
}

static long double cone_density(const void *s, long double u, long double v)
{
    long double j[3][4], det = 0;

    weighted_jet(s, u, v, j);
    for (int k = 0; k < 3; k++) {
        const int x = (k + 1) % 3, y = (k + 2) % 3;
        det += j[0][k] * (j[1][x] * j[2][y] - j[1][y] * j[2][x]);
    }
    return det / 3 / (j[0][3] * j[0][3] * j[0][3]);
}

static void weighted_patches_keep_their_tolerance(arb *a)
{
    const weighted *x = arb_weighted(a);
    const loft_net net = loft_net_from_tensor_rational(&x->s);
    static const double within[4] = { 8, 0.5, 0.0625, 0.0001 };
    const loft_real tol = LOFT_REAL(within[arb_below(a, 4)]);
    loft_acc area, volume;

    CHECK(loft_net_area(net, tol, memory, &area) == LOFT_OK);
    CHECK_EXACT(exact_acc(area), gauss(weighted_density, x, 8), exact_of(tol) + 1e-6L);
#if LOFT_AXES >= 3
    CHECK(loft_net_cone_volume(net, x->apex, tol, memory, &volume) == LOFT_OK);
    CHECK_EXACT(exact_acc(volume), gauss(cone_density, x, 8), exact_of(tol) + 1e-6L);
#else
    CHECK(loft_net_cone_volume(net, x->apex, tol, memory, &volume) == LOFT_ERR_ARG);
#endif
}

/* pi / 2 r^2, and a sixth of pi r^3 around the centre. */
static void an_octant_of_a_sphere_has_its_area(arb *a)
{
    const loft_real r  = loft_real_from_int(1 + (int32_t)arb_below(a, 20));
    const loft_vec apex = { { 0 } };
    const long double radius = exact_of(r), off = BY_NUM(2 * 0x1p-16L, 0x1p-20L * radius, 0);
    loft_triangle_rational t;
    loft_weighted p[15];
    loft_acc area, volume;

    CHECK(loft_octant_from_radius(r, p) == LOFT_OK);
    CHECK(loft_triangle_rational_init(&t, p, 4) == LOFT_OK);
    const loft_net net = loft_net_from_triangle_rational(&t);
    CHECK(loft_net_area(net, LOFT_REAL(0.03125), memory, &area) == LOFT_OK);
    if (LOFT_AXES >= 3)
        CHECK_EXACT(exact_acc(area), PI / 2 * radius * radius,
                    0.03125L + 4 * PI * radius * off + 1e-9L);
    if (loft_net_cone_volume(net, apex, LOFT_REAL(0.03125), memory, &volume) == LOFT_OK)
        CHECK_EXACT(exact_acc(volume), PI / 6 * radius * radius * radius,
                    0.03125L + 2 * PI * radius * radius * off + 1e-9L);
    else
        CHECK(LOFT_AXES < 3);
}

/* 10^-10 of the area in floats, where bounds of the third order take 5 million parts; a last bit in
 * q16. */
static void fine_tolerances_are_cheap(arb *a)
{
    const loft_real r        = LOFT_REAL(91.0741 + 0.01 * arb_below(a, 100));
    const long double radius = exact_of(r), size = PI / 2 * radius * radius;
    const loft_real tol = (loft_real)(LOFT_REAL_LSB + (loft_real)BY_NUM(0, 1e-10L, 1e-10L) * size);
    loft_triangle_rational t;
    loft_weighted p[15];
    loft_acc area;

    CHECK(loft_octant_from_radius(r, p) == LOFT_OK);
    CHECK(loft_triangle_rational_init(&t, p, 4) == LOFT_OK);
    CHECK(loft_net_area(loft_net_from_triangle_rational(&t), tol, memory, &area) == LOFT_OK);
    if (LOFT_AXES >= 3)
        CHECK_EXACT(exact_acc(area), size,
                    exact_of(tol) +
                        BY_NUM(8 * PI * 0x1p-16L * radius, 0x1p-18L * size, 0x1p-36L * size));
}

/* A line turned about the z axis: a quarter of a cylinder, a cone (r2 = 0) or a frustum. */
static void cylinders_and_cones_have_theirs(arb *a)
{
    const int32_t bottom = 1 + (int32_t)arb_below(a, 12), high = 1 + (int32_t)arb_below(a, 12),
                  top = arb_below(a, 3) == 0 ? bottom : (int32_t)arb_below(a, 12);
    const long double r = bottom, s = top, h = high, off = BY_NUM(0x1p-15L, 0x1p-19L * 12, 0);
    loft_weighted profile[2] = { { { { 0 } }, LOFT_REAL(200) }, { { { 0 } }, LOFT_REAL(200) } },
                  p[6];
    const loft_vec apex = { { 0 } };
    loft_tensor_rational patch;
    loft_rational line;
    loft_acc area, volume;

    if (LOFT_AXES < 3)
        return;
    profile[0].p.axis[0] = loft_real_from_int(bottom);
    profile[1].p.axis[0] = loft_real_from_int(top);
    profile[1].p.axis[LOFT_AXES < 3 ? 0 : 2] = loft_real_from_int(high);
    CHECK(loft_rational_init(&line, profile, 1) == LOFT_OK);
    CHECK(loft_tensor_rational_from_revolve(&line, arb_below(a, 4), p) == LOFT_OK);
    CHECK(loft_tensor_rational_init(&patch, p, 1, 2) == LOFT_OK);
    const loft_net net = loft_net_from_tensor_rational(&patch);
    CHECK(loft_net_area(net, LOFT_REAL(0.015625), memory, &area) == LOFT_OK);
    CHECK_EXACT(exact_acc(area), PI / 4 * (r + s) * sqrtl(h * h + (r - s) * (r - s)),
                0.015625L + PI * (r + s + h) * off + 1e-9L);
    /* the frustum without the cone over its upper disk, seen from the middle of the lower one;
     * the normal points inward */
    CHECK(loft_net_cone_volume(net, apex, LOFT_REAL(0.015625), memory, &volume) == LOFT_OK);
    CHECK_EXACT(exact_acc(volume), -(PI * h / 12 * (r * r + r * s + s * s) - PI / 12 * s * s * h),
                0.015625L + PI * (r + s + h) * (r + s + h) * off + 1e-9L);
}

/* Without weights the cone is exact, as volume.h says. */
static void cones_without_weights_are_exact(arb *a)
{
    tensor *x = arb_sheet(a, 65536 * 10, 65536);
    loft_vec apex = { { 0 } };
    loft_net both[2] = { { &apex, NULL, 0, 0, false }, loft_net_from_tensor(&x->s) };
    loft_acc volume, want;

    for (int axis = 0; axis < LOFT_AXES; axis++)
        apex.axis[axis] = arb_real(a, 8);
    if (loft_net_volume(both, 2, &want) == LOFT_OK) {
        CHECK(loft_net_cone_volume(both[1], apex, LOFT_REAL(1), memory, &volume) == LOFT_OK);
        CHECK_EXACT(exact_acc(volume), exact_acc(want), 1e-7L);
    } else {
        CHECK(LOFT_AXES < 3);
    }
}

// Far from the apex
// -----------------

typedef struct {
    const loft_tensor *s;
    loft_vec apex;
    int axis;               /* of a first moment; -1: the volume */
} far_cone;

static long double far_density(const void *context, long double u, long double v)
{
    const far_cone *c = context;
    long double p[3], a[3], b[3], det = 0;

    for (int i = 0; i < 3; i++) {
        p[i] = tensor_exact(c->s, i, 0, 0, u, v) - exact_of(loft_vec_axis(&c->apex, i));
        a[i] = tensor_exact(c->s, i, 1, 0, u, v);
        b[i] = tensor_exact(c->s, i, 0, 1, u, v);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        det += p[i] * (a[j] * b[k] - a[k] * b[j]);
    }
    return c->axis < 0 ? det / 3 : det / 4 * p[c->axis];
}

static long double distance_of(const loft_vec *a, const loft_vec *b)
{
    long double sum = 0;

    for (int i = 0; i < 3 && i < LOFT_AXES; i++)
        sum += powl(exact_of(a->axis[i]) - exact_of(b->axis[i]), 2);
    return sqrtl(sum);
}

/* A of the header: m n times the product of the largest steps. */
static long double size_of_steps(const loft_tensor *s)
{
    long double along = 0, across = 0;

    for (unsigned i = 0; i <= s->m; i++)
        for (unsigned j = 0; j <= s->n; j++) {
            const loft_vec *at = &s->p[i * (s->n + 1u) + j];
            if (i < s->m)
                along = fmaxl(along, distance_of(at, at + s->n + 1));
            if (j < s->n)
                across = fmaxl(across, distance_of(at, at + 1));
        }
    return s->m * s->n * along * across;
}

/* A small net far away, and a thin one, err by as little as the header says. */
static void far_cones_hold_their_bounds(arb *a)
{
    tensor *x = arb_sheet(a, (int32_t)1 << (6 + arb_below(a, 20)), 1 << arb_below(a, 18));
    const loft_net net = loft_net_from_tensor(&x->s);
    static loft_sci moment_memory[LOFT_NET_MOMENT_MEMORY(LOFT_DEGREE_MAX, 5)];
    far_cone c = { &x->s, arb_vec(a, 1 << arb_below(a, 15)), -1 };
    const long double want = gauss(far_density, &c, 1), size = size_of_steps(&x->s);
    long double far = 0;
    loft_acc volume;
    loft_sci moment[3];

    for (unsigned k = 0; k < (x->s.m + 1u) * (x->s.n + 1u); k++)
        far = fmaxl(far, distance_of(&x->s.p[k], &c.apex));
    const long double fine = BY_NUM(0x1p-48L, 0x1p-40L, 0x1p-40L) * size * far;
    if (LOFT_AXES < 3 || BY_NUM(fabsl(want) > 2e9L, false, false))
        return;
    CHECK(loft_net_cone_volume(net, c.apex, LOFT_REAL(0.01), memory, &volume) == LOFT_OK);
    CHECK_EXACT(exact_acc(volume), want, BY_NUM(0x1p-32L, 0, 0) + fine);
    CHECK(loft_net_cone_moment(net, c.apex, LOFT_REAL(0.01), moment_memory, moment) == LOFT_OK);
    for (c.axis = 0; c.axis < 3; c.axis++)
        CHECK_EXACT(exact_sci(moment[c.axis]), gauss(far_density, &c, 1), fine * far);
}

int main(void)
{
    PROPERTY(an_area_is_within_its_tolerance, 30);
    PROPERTY(a_finer_tolerance_is_kept_too, 6);
    PROPERTY(a_plane_patch_is_exact, 12);
    PROPERTY(what_cannot_be_answered_is_refused, 2);
    PROPERTY(a_patch_without_extent_has_none, 5);
    PROPERTY(triangles_have_their_area, 10);
    PROPERTY_LONG(weighted_patches_keep_their_tolerance, 24);
    PROPERTY(an_octant_of_a_sphere_has_its_area, 6);
    PROPERTY(fine_tolerances_are_cheap, 3);
    PROPERTY(cylinders_and_cones_have_theirs, 20);
    PROPERTY(cones_without_weights_are_exact, 10);
    EXTREMES(loft_net_cone_volume, far_cones_hold_their_bounds, 100);
    EXTREMES(loft_net_cone_moment, far_cones_hold_their_bounds, 1);
    return check_failures();
}

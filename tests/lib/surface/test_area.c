/* tests/lib/surface/test_area.c -- properties of lib/surface/area.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"              /* CHECK, PROPERTY, BY_NUM */
#include "support/exact_sci.h"      /* exact_sci */
#include "surface/area.h"
#include "surface/differential.h"
#include "support/tensors.h"    /* tensor_fill, tensor_exact */

/* The reference: Gauss's rule with 8 x 8 nodes on each of PARTS x PARTS pieces. */
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

static long double integral(const loft_tensor *s, unsigned parts)
{
    static const long double place[4] = { 0.1834346424956498049394761L,
                                          0.5255324099163289858177390L,
                                          0.7966664774136267395915539L,
                                          0.9602898564975362316835609L };
    static const long double weight[4] = { 0.3626837833783619829651504L,
                                           0.3137066458778872873379622L,
                                           0.2223810344533744705443560L,
                                           0.1012285362903762591525314L };
    long double sum = 0;

    for (unsigned p = 0; p < parts; p++)
        for (unsigned q = 0; q < parts; q++)
            for (int i = 0; i < 8; i++)
                for (int j = 0; j < 8; j++) {
                    const long double x = i < 4 ? place[i] : -place[i - 4],
                                      y = j < 4 ? place[j] : -place[j - 4];
                    sum += weight[i % 4] * weight[j % 4] *
                           density(s, (p + (1 + x) / 2) / parts, (q + (1 + y) / 2) / parts);
                }
    return sum / 4 / parts / parts;
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

    CHECK(loft_net_area(loft_net_from_tensor(&x->s), tol, &area) == LOFT_OK);
    CHECK_EXACT(exact_acc(area), integral(&x->s, 4),
                exact_of(tol) + BY_NUM(0x1p-32L, 0, 0) + 1e-9L * extent * extent);
}

static void a_finer_tolerance_is_kept_too(arb *a)
{
    const tensor *x = arb_sheet(a, 65536 * 10, 65536);
    const loft_real tol = LOFT_REAL(0.002);
    loft_acc area;

    CHECK(loft_net_area(loft_net_from_tensor(&x->s), tol, &area) == LOFT_OK);
    CHECK_EXACT(exact_acc(area), integral(&x->s, 4), exact_of(tol) + 1e-7L);
}

/* A plane patch, whatever its parametrization: the corners of the rectangle give the area. */
static void a_plane_patch_is_exact(arb *a)
{
    static tensor x;
    const unsigned m = 1 + arb_below(a, LOFT_DEGREE_MAX), n = 1 + arb_below(a, LOFT_DEGREE_MAX);
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
    CHECK(loft_net_area(loft_net_from_tensor(&x.s), LOFT_REAL(0.001), &area) == LOFT_OK);
    CHECK_EXACT(exact_acc(area), want,
                0x1p-30L * BY_NUM(1, 0, 0) + 81 * want * BY_NUM(0x1p-48L, 0x1p-40L, 0x1p-40L));
}

static void what_cannot_be_answered_is_refused(arb *a)
{
    tensor *x = arb_sheet(a, 65536 * 1000, 65536 * 100);
    loft_acc area = 77;

    CHECK(loft_net_area(loft_net_from_tensor(&x->s), 0, &area) == LOFT_ERR_ARG);
    x->p[0].axis[0] -= LOFT_REAL(1);            /* curved: no tolerance that fine is provable */
    x->p[x->n].axis[LOFT_AXES - 1] += LOFT_REAL(200);
#if LOFT_NUM != LOFT_Q16
    CHECK(loft_net_area(loft_net_from_tensor(&x->s), (loft_real)1e-15, &area) == LOFT_ERR_RANGE);
#endif
    tensor_fill(x, a, 1, 1);
    x->p[0] = x->p[1] = x->p[2] = x->p[3] = (loft_vec){ { 0 } };
    x->p[1].axis[1] = x->p[3].axis[1] = LOFT_REAL(32767);
    x->p[2].axis[0] = x->p[3].axis[0] = LOFT_REAL(32767);
    CHECK(loft_net_area(loft_net_from_tensor(&x->s), LOFT_REAL(1), &area) == LOFT_OK);
    x->p[0].axis[0] = x->p[1].axis[0] = x->p[0].axis[1] = x->p[2].axis[1] = LOFT_REAL(-32767);
    area = 77;
    CHECK(loft_net_area(loft_net_from_tensor(&x->s), LOFT_REAL(1), &area) ==
          BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
    CHECK(BY_NUM(area == 77, area > 4e9, area > 4e9));
}

static void a_patch_without_extent_has_none(arb *a)
{
    tensor *x = arb_sheet(a, 65536 * 10, 65536);
    loft_tensor line = x->s;
    loft_acc area = 1;

    line.n = 0;
    CHECK(loft_net_area(loft_net_from_tensor(&line), LOFT_REAL(0.01), &area) == LOFT_OK &&
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
        CHECK(loft_net_area(loft_net_from_triangle(&t), LOFT_REAL(0.01), &area) == LOFT_OK);
        /* sides n (4, 2, 0) and n (0, 3, 1): 12^2 + 4^2 + 2^2 = 164; a parameter has 2^-25 */
        CHECK_NEAR(exact_acc(area), bent ? triangle_integral(&t) : n * n * sqrtl(164) / 2,
                   bent ? 0.012L : 1e-6L);
    }
    const loft_weighted w[3] = { { p[0], LOFT_REAL(1) },
                                 { p[1], LOFT_REAL(1) },
                                 { p[2], LOFT_REAL(1) } };
    loft_triangle_rational r;
    CHECK(loft_triangle_rational_init(&r, w, 1) == LOFT_OK);
    CHECK(loft_net_area(loft_net_from_triangle_rational(&r), LOFT_REAL(0.01), &area) ==
          LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(an_area_is_within_its_tolerance, 12);
    PROPERTY_LONG(a_finer_tolerance_is_kept_too, 2);
    PROPERTY(a_plane_patch_is_exact, 12);
    PROPERTY(what_cannot_be_answered_is_refused, 2);
    PROPERTY(a_patch_without_extent_has_none, 5);
    PROPERTY(triangles_have_their_area, 10);
    return check_failures();
}

/* tests/lib/surface/test_net_moment.c -- properties of loft_net_cone_moment of lib/surface/area.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"                      /* CHECK, PROPERTY, BY_NUM */
#include "support/exact_sci.h"          /* exact_sci */
#include "support/weighted.h"           /* arb_weighted, gauss */
#include "surface/area.h"
#include "surface/tensor/revolve.h"     /* loft_tensor_rational_from_revolve */

#define PI 3.14159265358979323846264338327950288L

static loft_sci memory[LOFT_NET_MOMENT_MEMORY(3, 3)];

typedef struct {
    const weighted *x;
    int axis;
} question;

/* A quarter of the determinant times the coordinate. */
static long double moment_density(const void *context, long double u, long double v)
{
    const question *q = context;
    long double j[3][4], det = 0;

    weighted_jet(q->x, u, v, j);
    for (int k = 0; k < 3; k++) {
        const int x = (k + 1) % 3, y = (k + 2) % 3;
        det += j[0][k] * (j[1][x] * j[2][y] - j[1][y] * j[2][x]);
    }
    return det * j[0][q->axis] / 4 / powl(j[0][3], 4);
}

static void moments_are_within_their_tolerance(arb *a)
{
    const weighted *x = arb_weighted(a);
    const loft_real tol = LOFT_REAL(arb_below(a, 2) ? 8 : 1);
    loft_sci out[3];

    const enum loft_status status = loft_net_cone_moment(loft_net_from_tensor_rational(&x->s),
                                                         x->apex, tol, memory, out);
    CHECK(status == (LOFT_AXES < 3 ? LOFT_ERR_ARG : LOFT_OK));
    for (int axis = 0; axis < 3 && LOFT_AXES >= 3; axis++) {
        const question q = { x, axis };
        CHECK_EXACT(exact_sci(out[axis]), gauss(moment_density, &q, 8), exact_of(tol) + 1e-5L);
    }
}

static void moments_without_weights_are_exact(arb *a)
{
    static loft_vec p[WEIGHTED_POINTS];
    weighted *x = arb_weighted(a);
    loft_tensor s;
    loft_sci out[3];

    for (unsigned k = 0; k < (x->s.m + 1u) * (x->s.n + 1u); k++) {
        p[k]      = x->p[k].p;
        x->p[k].w = LOFT_REAL(1);
    }
    CHECK(loft_tensor_init(&s, p, x->s.m, x->s.n) == LOFT_OK);
    const enum loft_status status = loft_net_cone_moment(loft_net_from_tensor(&s), x->apex,
                                                         LOFT_REAL(0.0001), memory, out);
    CHECK(status == (LOFT_AXES < 3 ? LOFT_ERR_ARG : LOFT_OK));
    for (int axis = 0; axis < 3 && LOFT_AXES >= 3; axis++) {
        const question q = { x, axis };
        CHECK_EXACT(exact_sci(out[axis]), gauss(moment_density, &q, 4), 1e-6L);
    }
}

/* A quarter of a cylinder without the cone over its upper disk, from the middle of the lower one:
 * r^3 h / 4 along x and y, pi r^2 h^2 / 16 along z. The normal points inward. */
static void a_cylinder_has_its_moments(arb *a)
{
    const int32_t r = 1 + (int32_t)arb_below(a, 12), h = 1 + (int32_t)arb_below(a, 12);
    const long double off = BY_NUM(0x1p-15L, 0x1p-19L, 1e-12L) * 4 * (r + h) * (r + h) * (r + h);
    loft_weighted profile[2] = { { { { 0 } }, LOFT_REAL(200) }, { { { 0 } }, LOFT_REAL(200) } },
                  p[6];
    const loft_vec apex = { { 0 } };
    loft_tensor_rational patch;
    loft_rational line;
    loft_sci out[3];

    if (LOFT_AXES < 3)
        return;
    profile[0].p.axis[0] = profile[1].p.axis[0] = loft_real_from_int(r);
    profile[1].p.axis[LOFT_AXES < 3 ? 0 : 2] = loft_real_from_int(h);
    CHECK(loft_rational_init(&line, profile, 1) == LOFT_OK);
    CHECK(loft_tensor_rational_from_revolve(&line, 0, p) == LOFT_OK);
    CHECK(loft_tensor_rational_init(&patch, p, 1, 2) == LOFT_OK);
    const loft_net net = loft_net_from_tensor_rational(&patch);
    CHECK(loft_net_cone_moment(net, apex, LOFT_REAL(0.015625), memory, out) == LOFT_OK);
    const long double side = -(long double)r * r * r * h / 4, up = -PI * r * r * h * h / 16;
    CHECK_EXACT(exact_sci(out[0]), side, 0.015625L + off);
    CHECK_EXACT(exact_sci(out[1]), side, 0.015625L + off);
    CHECK_EXACT(exact_sci(out[2]), up, 0.015625L + off);
    CHECK(loft_net_cone_moment(net, apex, 0, memory, out) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(moments_are_within_their_tolerance, 12);
    PROPERTY(moments_without_weights_are_exact, 30);
    PROPERTY(a_cylinder_has_its_moments, 20);
    return check_failures();
}

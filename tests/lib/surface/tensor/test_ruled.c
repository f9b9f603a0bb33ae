/* tests/lib/surface/tensor/test_ruled.c -- properties of lib/surface/tensor/ruled.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* check_result; CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/ruled.h"
#include "surface/tensor/tensor.h"

typedef struct {
    loft_vec p[2][LOFT_DEGREE_MAX + 1];
    loft_bezier b[2];
} sample;

static sample *arb_sample(arb *a)
{
    static sample s;
    const int32_t limit = (int32_t)1 << arb_below(a, 15);

    for (int k = 0; k < 2; k++) {
        const unsigned n = arb_below(a, LOFT_DEGREE_MAX + 1);
        for (unsigned i = 0; i <= n; i++)
            s.p[k][i] = arb_vec(a, limit);
        CHECK(loft_bezier_init(&s.b[k], s.p[k], n) == LOFT_OK);
    }
    return &s;
}

static quad curve_deriv(const loft_bezier *b, unsigned k, quad t, int axis)
{
    quad c[LOFT_DEGREE_MAX + 1], factor = 1;
    unsigned n = b->degree;

    if (k > n)
        return 0;
    for (unsigned i = 0; i <= n; i++)
        c[i] = quad_of(b->p[i].axis[axis]);
    for (; k > 0; k--, n--) {
        factor *= n;
        for (unsigned i = 0; i < n; i++)
            c[i] = c[i + 1] - c[i];
    }
    for (; n > 0; n--)
        for (unsigned i = 0; i < n; i++)
            c[i] = (1 - t) * c[i] + t * c[i + 1];
    return factor * c[0];
}

static void points_and_derivatives_are_within_their_bound(arb *a)
{
    const sample *s = arb_sample(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const quad x = (quad)exact_unit(u), y = (quad)exact_unit(v);

    for (unsigned j = 0; j < 3; j++)
        for (unsigned k = 0; k < 3; k++) {
            quad want[LOFT_AXES];
            loft_vec p = { { 0 } };
            const long double grow = powl(LOFT_DEGREE_MAX, j);
            for (int i = 0; i < LOFT_AXES; i++) {
                const quad from = curve_deriv(&s->b[0], j, x, i),
                           to = curve_deriv(&s->b[1], j, x, i);
                want[i] = k == 0 ? (1 - y) * from + y * to : k == 1 ? to - from : 0;
            }
            check_result(loft_ruled_deriv(&s->b[0], &s->b[1], j, k, u, v, &p), &p, want,
                         0.5L + 0x1p-16L,
                         bound_by_num(0, 0x1p-20L * ulp(16384), 176 * grow * ulp(16384)));
        }
}

static void the_net_makes_the_same_surface(arb *a)
{
    const sample *s = arb_sample(a);
    const unsigned m = s->b[0].degree > s->b[1].degree ? s->b[0].degree : s->b[1].degree;
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    loft_vec net[2 * (LOFT_DEGREE_MAX + 1)], p = { { 0 } };
    loft_tensor t;

    CHECK(loft_tensor_from_ruled(&s->b[0], &s->b[1], net) == LOFT_OK &&
          loft_tensor_init(&t, net, m, 1) == LOFT_OK &&
          loft_ruled_deriv(&s->b[0], &s->b[1], 0, 0, u, v, &p) == LOFT_OK);
    const loft_vec q = loft_tensor_eval(&t, u, v);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    bound_by_num(1.6L * LSB, 4 * ulp(16384), 256 * ulp(16384)));
    for (unsigned end = 0; end < 2; end++) {
        CHECK(loft_vec_equal(net[end], s->p[end][0]));
        CHECK(loft_vec_equal(net[2 * m + end], s->p[end][s->b[end].degree]));
    }
}

static void mistakes_are_refused(arb *a)
{
    const sample *s = arb_sample(a);
    loft_vec v;

    CHECK(loft_ruled_deriv(&s->b[0], &s->b[1], 3, 0, 0, 0, &v) == LOFT_ERR_ARG &&
          loft_ruled_deriv(&s->b[0], &s->b[1], 0, 0, LOFT_UNIT(1.5), 0, &v) == LOFT_ERR_ARG &&
          loft_ruled_deriv(&s->b[0], &s->b[1], 0, 0, 0, LOFT_UNIT(-0.5), &v) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(points_and_derivatives_are_within_their_bound, 1000);
    PROPERTY(the_net_makes_the_same_surface,                1000);
    PROPERTY(mistakes_are_refused,                            50);
    return check_failures();
}

/* tests/lib/surface/triangle/test_triangle_join.c -- properties of
 * lib/surface/triangle/triangle_join.h and lib/surface/triangle/triangle_curvature.h
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"          /* arb_net_of, exact_polar, order_of */
#include "surface/triangle/triangle_curvature.h"
#include "surface/triangle/triangle_join.h"
#include "surface/triangle/triangle_pieces.h"

#define MOST LOFT_TRIANGLE_MAX

static loft_triangle triangle_of(const arb_net *x)
{
    loft_triangle t = { 0, 0 };
    CHECK(loft_triangle_init(&t, x->p, x->n) == LOFT_OK);
    return t;
}

static void a_continuation_is_within_its_bound_or_refused(arb *a)
{
    const arb_net *x = arb_net_of(a, 0, 6, 32767 >> arb_below(a, 15));
    const loft_triangle t = triangle_of(x);
    const loft_bary star = arb_far(a, 1 + (int32_t)arb_below(a, 6));
    const unsigned order = arb_below(a, x->n + 1);
    long double at[LOFT_DEGREE_MAX + 1][3];
    bool all = true, none = true;
    loft_vec out[MOST];

    const enum loft_status status = loft_triangle_join_continue(&t, star, order, out);
    for (unsigned i = 0, p = 0; i <= order; i++)
        for (unsigned k = 0; k <= x->n - i; k++, p++)
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                for (unsigned r = 0; r < x->n; r++) {
                    const loft_bary corner = { r < x->n - k ? LOFT_UNIT(1) : 0,
                                               r < x->n - k ? 0 : LOFT_UNIT(1) };
                    exact_bary(r < i ? star : corner, false, at[r]);
                }
                const long double want = exact_polar(x->c[axis], x->n, at);
                all  = all && exact_fits(want) == 1;
                none = none && exact_fits(want) != 0;
                if (status == LOFT_OK)
                    CHECK_EXACT(exact_of(out[p].axis[axis]), want,
                                by_kind(LSB / 2 + 0x1p-33L, BY_NUM(0, ulp(want) / 2, ulp(want))) +
                                    powl(fmaxl(1, growth3(star)), i) * x->largest * 0x1p-58L);
            }
    CHECK(status == LOFT_OK ? none : status == LOFT_ERR_RANGE && !all);
}

/* Small whole numbers and quarters of a star: every continuation is a coordinate, so it joins to
 * any order asked for. Changed by one LSB in row r, it joins exactly to order r - 1. */
static void a_continuation_joins_until_it_is_spoilt(arb *a)
{
    const unsigned n = arb_below(a, 5);
    const loft_bary star = { loft_unit_from(loft_real_from_int((int32_t)arb_below(a, 9) - 4)),
                             loft_unit_from(loft_real_from_int((int32_t)arb_below(a, 9) - 4)) };
    arb_net *x = arb_net_of(a, n, n, 1);
    loft_vec out[MOST], q[MOST] = { { { 0 } } };
    loft_triangle b, c;
    int order = -2;

    for (unsigned k = 0; k < x->count; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            x->p[k].axis[i] = loft_real_from_int((int32_t)arb_below(a, 5) - 2);
    CHECK(loft_triangle_init(&b, x->p, n) == LOFT_OK && loft_triangle_init(&c, q, n) == LOFT_OK);
    if (loft_triangle_join_continue(&b, star, n, out) != LOFT_OK)
        return;
    for (unsigned i = 0, p = 0; i <= n; i++)
        for (unsigned k = 0; k <= n - i; k++, p++)
            q[loft_triangle_place(n - i - k, k)] = out[p];
    CHECK(loft_triangle_join_order(&b, &c, star, &order) == LOFT_OK && order == (int)n);
    CHECK(order_of(x->p, q, n, star) == (int)n);

    const unsigned spoilt = arb_below(a, x->count);
    for (unsigned i = 0; i <= n; i++)
        for (unsigned k = 0; k <= n - i; k++)
            if (loft_triangle_place(n - i - k, k) == spoilt) {
                loft_real *one = &q[spoilt].axis[arb_below(a, LOFT_AXES)];
                *one += (loft_real)(fmaxl(LSB, ulp(exact_of(*one))) * BY_NUM(65536, 1, 1));
                CHECK(loft_triangle_join_order(&b, &c, star, &order) == LOFT_OK &&
                      order == (int)i - 1);
                CHECK(order_of(x->p, q, n, star) == (int)i - 1);
            }
}

static void nonsense_is_refused(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, 5, 100), *y = arb_net_of(a, 6, 9, 100);
    const loft_triangle t = triangle_of(x), s = triangle_of(y);
    const loft_bary star = { LOFT_UNIT(1), LOFT_UNIT(1) }, far = { LOFT_UNIT(127), 0 },
                    none = { 0, 0 };
    loft_vec out[MOST];
    loft_real bend = 7;
    int order = 7;

    CHECK(loft_triangle_join_continue(&t, star, x->n + 1, out) == LOFT_ERR_ARG &&
          loft_triangle_join_order(&t, &s, star, &order) == LOFT_ERR_ARG);
    CHECK(loft_triangle_join_continue(&t, far, 0, out) == LOFT_ERR_RANGE &&
          loft_triangle_join_order(&t, &t, far, &order) == LOFT_ERR_RANGE);
    CHECK(loft_triangle_corner_curvature_vec(&t, far, &bend) == LOFT_ERR_RANGE &&
          loft_triangle_corner_curvature_vec(&t, none, &bend) == LOFT_SINGULAR);
    CHECK(order == 7);
    CHECK_EXACT(exact_of(bend), exact_of(7), 0);
}

/* The curve of the surface over the line in the direction z has the curvature of the normal section
 * there: its second derivative along the normal over the square of its first. */
static void the_bend_of_a_corner_is_that_of_the_curve_over_it(arb *a)
{
    const arb_net *x = arb_net_of(a, 1, LOFT_DEGREE_MAX, 1 << arb_below(a, 15));
    const loft_triangle t = triangle_of(x);
    const loft_bary z = arb_far(a, 2);
    long double e[3], f[3], s[3], q[3], n[3], speed = 0, size = 0, top = 0, v = exact_unit(z.v),
                                              w = exact_unit(z.w), scale = 0;
    loft_real bend;

    for (int i = 0; i < 3; i++) {
        const long double *b = x->c[i];
        e[i] = b[1] - b[0];
        f[i] = b[2] - b[0];
        s[i] = v * e[i] + w * f[i];
        q[i] = x->n < 2
                   ? 0
                   : v * v * (b[3] - 2 * b[1] + b[0]) + 2 * v * w * (b[4] - b[1] - b[2] + b[0]) +
                         w * w * (b[5] - 2 * b[2] + b[0]);
        speed += s[i] * s[i];
    }
    for (int i = 0; i < 3; i++) {
        n[i] = e[(i + 1) % 3] * f[(i + 2) % 3] - e[(i + 2) % 3] * f[(i + 1) % 3];
        size += n[i] * n[i];
        top += q[i] * n[i];
        scale += fabsl(q[i] * n[i]);
    }
    const enum loft_status status = loft_triangle_corner_curvature_vec(&t, z, &bend);
    CHECK((status == LOFT_SINGULAR) == !(speed > 0 && size > 0));
    if (status == LOFT_SINGULAR)
        return;
    const long double factor = (x->n - 1) / (long double)x->n / speed / sqrtl(size),
                      want = factor * top;
    CHECK(status == LOFT_OK ? exact_fits(want) != 0 : exact_fits(want) != 1);
    if (status == LOFT_OK)
        CHECK_EXACT(exact_of(bend), want,
                    BY_NUM((0.5L + LSB) * LSB, ulp(want) / 2, ulp(want)) +
                        factor * scale * 0x1p-55L);
}

/* A bowl z = (x^2 + y^2) / (2 r), turned up: 1 / r in every direction, to the side of the
 * normal. */
static void a_bowl_bends_the_same_in_all_directions(arb *a)
{
    const int32_t r = 1 << arb_below(a, 6);
    const loft_real one = LOFT_REAL(1),
                    half = loft_div(loft_real_from_int(1), loft_real_from_int(2 * r));
    const loft_vec p[6] = {
        { { 0, 0, 0 } },      { { one / 2, 0, 0 } },       { { 0, one / 2, 0 } },
        { { one, 0, half } }, { { one / 2, one / 2, 0 } }, { { 0, one, half } }
    };
    const loft_bary z = arb_far(a, 2);
    loft_triangle t;
    loft_real bend;

    CHECK(loft_triangle_init(&t, p, 2) == LOFT_OK);
    if (loft_triangle_corner_curvature_vec(&t, z, &bend) == LOFT_OK)
        CHECK_EXACT(exact_of(bend), 1.0L / r, BY_NUM(0, ulp(1.0L / r), ulp(1.0L / r)));
    else
        CHECK(!(fabsl(exact_unit(z.v)) + fabsl(exact_unit(z.w)) > 0));
}

int main(void)
{
    PROPERTY(a_continuation_is_within_its_bound_or_refused,     300);
    PROPERTY(a_continuation_joins_until_it_is_spoilt,           500);
    PROPERTY(the_bend_of_a_corner_is_that_of_the_curve_over_it, 1000);
    PROPERTY(a_bowl_bends_the_same_in_all_directions,           200);
    PROPERTY(nonsense_is_refused,                                50);
    return check_failures();
}

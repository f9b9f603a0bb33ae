/* tests/lib/surface/tensor/test_tensor.c -- properties of lib/surface/tensor/tensor.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"              /* CHECK, PROPERTY, BY_NUM */
#include "support/tensors.h"    /* arb_tensor, tensor_exact */

static long double point_bound(const tensor *x, unsigned rows)
{
    (void)x;
    (void)rows;
    return BY_NUM(LSB / 2 + rows * LSB / 131072 + 1e-12L, ulp(x->largest),
                  3 * rows * ulp(x->largest));
}

static void a_point_is_within_its_bound(arb *a)
{
    const tensor *x = arb_tensor(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const loft_vec p = loft_tensor_eval(&x->s, u, v);

    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), tensor_exact(&x->s, i, 0, 0, exact_unit(u), exact_unit(v)),
                    point_bound(x, x->m + x->n));
}

/* The transposed net is evaluated along v first. */
static void both_orders_agree(arb *a)
{
    const tensor *x = arb_tensor(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    loft_vec net[TENSOR_POINTS];
    loft_tensor other;

    loft_tensor_transpose(&x->s, net);
    CHECK(loft_tensor_init(&other, net, x->n, x->m) == LOFT_OK);
    const loft_vec p = loft_tensor_eval(&x->s, u, v), q = loft_tensor_eval(&other, v, u);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_NEAR(exact_of(p.axis[i]), exact_of(q.axis[i]),
                   BY_NUM(LSB, ulp(x->largest), 3 * (x->m + x->n) * ulp(x->largest)));
}

static void corners_are_exact_and_beyond_is_clamped(arb *a)
{
    const tensor *x = arb_tensor(a);
    const unsigned last = (x->m + 1) * (x->n + 1) - 1;

    CHECK(loft_vec_equal(loft_tensor_eval(&x->s, 0, 0), x->p[0]));
    CHECK(loft_vec_equal(loft_tensor_eval(&x->s, 0, LOFT_UNIT(1)), x->p[x->n]));
    CHECK(loft_vec_equal(loft_tensor_eval(&x->s, LOFT_UNIT(1), 0), x->p[last - x->n]));
    CHECK(loft_vec_equal(loft_tensor_eval(&x->s, LOFT_UNIT(9), LOFT_UNIT(2)), x->p[last]));
    CHECK(loft_vec_equal(loft_tensor_eval(&x->s, LOFT_UNIT(-1), LOFT_UNIT(-7)), x->p[0]));
}

static void edges_are_evaluated_as_curves(arb *a)
{
    const tensor *x = arb_tensor(a);
    const loft_unit t = arb_unit(a), end = arb_below(a, 2) ? LOFT_UNIT(1) : 0;
    loft_vec edge[LOFT_DEGREE_MAX + 1];
    loft_bezier b;

    loft_tensor_at_u(&x->s, end, edge);
    CHECK(loft_bezier_init(&b, edge, x->n) == LOFT_OK);
    CHECK(loft_vec_equal(loft_bezier_eval(&b, t), loft_tensor_eval(&x->s, end, t)));
    loft_tensor_at_v(&x->s, end, edge);
    CHECK(loft_bezier_init(&b, edge, x->m) == LOFT_OK);
    CHECK(loft_vec_equal(loft_bezier_eval(&b, t), loft_tensor_eval(&x->s, t, end)));
}

static void curves_across_lie_on_the_patch(arb *a)
{
    const tensor *x = arb_tensor(a);
    const loft_unit t = arb_unit(a), at = arb_unit(a);
    loft_vec curve[LOFT_DEGREE_MAX + 1];
    loft_bezier b;

    loft_tensor_at_u(&x->s, at, curve);
    CHECK(loft_bezier_init(&b, curve, x->n) == LOFT_OK);
    const loft_vec p = loft_bezier_eval(&b, t);
    loft_tensor_at_v(&x->s, at, curve);
    CHECK(loft_bezier_init(&b, curve, x->m) == LOFT_OK);
    const loft_vec q = loft_bezier_eval(&b, t);
    for (int i = 0; i < LOFT_AXES; i++) {
        CHECK_EXACT(exact_of(p.axis[i]),
                    tensor_exact(&x->s, i, 0, 0, exact_unit(at), exact_unit(t)),
                    2 * point_bound(x, x->m + x->n));
        CHECK_EXACT(exact_of(q.axis[i]),
                    tensor_exact(&x->s, i, 0, 0, exact_unit(t), exact_unit(at)),
                    2 * point_bound(x, x->m + x->n));
    }
}

static long double falling(unsigned n, unsigned k)
{
    long double f = k > n ? 0 : 1;
    for (unsigned j = 0; j < k && j < n; j++)
        f *= n - j;
    return f;
}

/* 1: fits by more than one LSB, 0: exceeds by more than one LSB, -1: too close to decide */
static int fits(long double want)
{
    const long double over = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX),
                      under = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
    return want < over - LSB && want > under + LSB   ? 1
           : want > over + LSB || want < under - LSB ? 0
                                                     : -1;
}

static void a_derivative_is_within_its_bound_or_refused(arb *a)
{
    const tensor *x = arb_tensor(a);
    const unsigned i1 = arb_below(a, 4), j1 = arb_below(a, 3);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const long double f = falling(x->m, i1) * falling(x->n, j1), rows = x->m + x->n;
    bool all = true, none = true;
    loft_vec p;

    const enum loft_status status = loft_tensor_deriv(&x->s, i1, j1, u, v, &p);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = tensor_exact(&x->s, i, i1, j1, exact_unit(u), exact_unit(v));
        all  = all && fits(want) == 1;
        none = none && fits(want) != 0;
        if (status == LOFT_OK) {
            const long double by_num[3] = {
                LSB / 2 + f * rows * LSB / 131072 + 1e-9L,
                ulp(want) / 2 + ulp(x->largest) / 2 * (i1 + j1 <= 2 ? 1 : powl(2, i1 + j1)),
                ulp(want) / 2 + f * powl(2, i1 + j1) * (3 * rows + 2) * ulp(x->largest)
            };
            CHECK_EXACT(exact_of(p.axis[i]), want, by_num[BY_NUM(0, 1, 2)]);
        }
    }
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !(all && f < 1000)));
    CHECK(status != LOFT_OK || none || f > 1000);
}

/* The piece is the patch: its control points err by the bound of the curve, and so does its
 * point. */
static void check_piece(const tensor *x, const loft_vec net[], unsigned m, unsigned n,
                        long double u[2], long double v[2], arb *a)
{
    loft_tensor piece;
    const loft_unit s = arb_unit(a), t = arb_unit(a);

    CHECK(loft_tensor_init(&piece, net, m, n) == LOFT_OK);
    const long double at_u = u[0] + (u[1] - u[0]) * exact_unit(s),
                      at_v = v[0] + (v[1] - v[0]) * exact_unit(t);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(tensor_exact(&piece, i, 0, 0, exact_unit(s), exact_unit(t)),
                    tensor_exact(&x->s, i, 0, 0, at_u, at_v),
                    point_bound(x, x->m + x->n) +
                        BY_NUM(LSB / 2, ulp(x->largest), 30 * ulp(x->largest)));
}

static void splitting_changes_nothing(arb *a)
{
    const tensor *x = arb_tensor(a);
    const loft_unit t = arb_unit(a);
    const long double at = exact_unit(t);
    loft_vec left[TENSOR_POINTS], right[TENSOR_POINTS];

    CHECK(loft_tensor_split_u(&x->s, t, left, right) == LOFT_OK);
    check_piece(x, left, x->m, x->n, (long double[]){ 0, at }, (long double[]){ 0, 1 }, a);
    check_piece(x, right, x->m, x->n, (long double[]){ at, 1 }, (long double[]){ 0, 1 }, a);
    for (unsigned j = 0; j <= x->n; j++)
        CHECK(loft_vec_equal(left[x->m * (x->n + 1) + j], right[j]));
    CHECK(loft_tensor_split_v(&x->s, t, left, right) == LOFT_OK);
    check_piece(x, left, x->m, x->n, (long double[]){ 0, 1 }, (long double[]){ 0, at }, a);
    check_piece(x, right, x->m, x->n, (long double[]){ 0, 1 }, (long double[]){ at, 1 }, a);
    for (unsigned i = 0; i <= x->m; i++)
        CHECK(loft_vec_equal(left[i * (x->n + 1) + x->n], right[i * (x->n + 1)]));
}

static loft_vec raised[(LOFT_BEZIER_ELEVATE_MAX + 1) * (LOFT_DEGREE_MAX + 1)];

static void parts_and_raised_patches_are_the_patch(arb *a)
{
    const tensor *x = arb_tensor(a);
    const loft_unit from = arb_unit(a), to = arb_unit(a);
    const long double piece[2] = { exact_unit(from), exact_unit(to) }, whole[2] = { 0, 1 };
    const unsigned times = arb_below(a, 4);

    CHECK(loft_tensor_sub_u(&x->s, from, to, raised) == LOFT_OK);
    check_piece(x, raised, x->m, x->n, (long double *)piece, (long double *)whole, a);
    CHECK(loft_tensor_sub_v(&x->s, from, to, raised) == LOFT_OK);
    check_piece(x, raised, x->m, x->n, (long double *)whole, (long double *)piece, a);
    if (x->m + times <= LOFT_DEGREE_MAX) {
        CHECK(loft_tensor_elevate_u(&x->s, times, raised) == LOFT_OK);
        check_piece(x, raised, x->m + times, x->n, (long double *)whole, (long double *)whole, a);
    }
    if (x->n + times <= LOFT_DEGREE_MAX) {
        CHECK(loft_tensor_elevate_v(&x->s, times, raised) == LOFT_OK);
        check_piece(x, raised, x->m, x->n + times, (long double *)whole, (long double *)whole, a);
    }
    CHECK(loft_tensor_elevate_u(&x->s, LOFT_BEZIER_ELEVATE_MAX + 1 - x->m, raised) == LOFT_ERR_ARG);
    CHECK(loft_tensor_elevate_v(&x->s, LOFT_BEZIER_ELEVATE_MAX + 1 - x->n, raised) == LOFT_ERR_ARG);
}

/* Each row and column is a curve that was raised. */
static void a_patch_is_raised_curve_by_curve(arb *a)
{
    const tensor *x = arb_tensor(a);
    const unsigned m = x->m, n = x->n, by_u = arb_below(a, LOFT_BEZIER_ELEVATE_MAX + 1 - m),
                   by_v = arb_below(a, LOFT_BEZIER_ELEVATE_MAX + 1 - n);
    loft_vec line[LOFT_DEGREE_MAX + 1], high[LOFT_BEZIER_ELEVATE_MAX + 1];
    loft_bezier b;

    CHECK(loft_tensor_elevate_u(&x->s, by_u, raised) == LOFT_OK);
    for (unsigned j = 0; j <= n; j++) {
        for (unsigned i = 0; i <= m; i++)
            line[i] = x->p[(n + 1) * i + j];
        CHECK(loft_bezier_init(&b, line, m) == LOFT_OK &&
              loft_bezier_elevate(&b, by_u, high) == LOFT_OK);
        for (unsigned i = 0; i <= m + by_u; i++)
            CHECK(loft_vec_equal(raised[(n + 1) * i + j], high[i]));
    }
    CHECK(loft_tensor_elevate_v(&x->s, by_v, raised) == LOFT_OK);
    for (unsigned i = 0; i <= m; i++) {
        CHECK(loft_bezier_init(&b, &x->p[(n + 1) * i], n) == LOFT_OK &&
              loft_bezier_elevate(&b, by_v, high) == LOFT_OK);
        for (unsigned j = 0; j <= n + by_v; j++)
            CHECK(loft_vec_equal(raised[(n + by_v + 1) * i + j], high[j]));
    }
}

static void a_piece_may_take_the_place_of_its_net(arb *a)
{
    tensor *x = arb_tensor(a);
    const loft_unit t = arb_unit(a);
    loft_vec left[TENSOR_POINTS], right[TENSOR_POINTS], other[TENSOR_POINTS];
    const unsigned count = (x->m + 1) * (x->n + 1);

    CHECK(loft_tensor_split_u(&x->s, t, left, right) == LOFT_OK);
    CHECK(loft_tensor_split_u(&x->s, t, other, x->p) == LOFT_OK);
    for (unsigned k = 0; k < count; k++)
        CHECK(loft_vec_equal(left[k], other[k]) && loft_vec_equal(right[k], x->p[k]));
    CHECK(loft_tensor_sub_u(&x->s, LOFT_UNIT(1), 0, x->p) == LOFT_OK);
    for (unsigned k = 0; k < count; k++)
        CHECK(
            loft_vec_equal(x->p[k], right[(x->m - k / (x->n + 1)) * (x->n + 1) + k % (x->n + 1)]));
}

static void the_patch_stays_in_its_box(arb *a)
{
    const tensor *x = arb_tensor(a);
    const loft_box box = loft_tensor_box(&x->s);
    const loft_vec p = loft_tensor_eval(&x->s, arb_unit(a), arb_unit(a));
    const long double slack = BY_NUM(0, 0, 3 * (x->m + x->n) * ulp(x->largest));

    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(exact_of(p.axis[i]) >= exact_of(box.min.axis[i]) - slack &&
              exact_of(p.axis[i]) <= exact_of(box.max.axis[i]) + slack);
}

/* Moving, halving and exchanging axes of the net has the same effect on the points. */
static void an_affine_map_of_the_net_maps_the_points(arb *a)
{
    tensor *x = arb_tensor(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const loft_vec by = arb_vec(a, 16000), p = loft_tensor_eval(&x->s, u, v);
    loft_vec net[TENSOR_POINTS];
    loft_tensor moved;

    for (unsigned k = 0; k < (x->m + 1) * (x->n + 1); k++)
        for (int i = 0; i < LOFT_AXES; i++)
            net[k].axis[i] = x->p[k].axis[LOFT_AXES - 1 - i] / 2 + by.axis[i];
    CHECK(loft_tensor_init(&moved, net, x->m, x->n) == LOFT_OK);
    const loft_vec q = loft_tensor_eval(&moved, u, v);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(q.axis[i]),
                    exact_of(p.axis[LOFT_AXES - 1 - i]) / 2 + exact_of(by.axis[i]),
                    BY_NUM(1.3L * LSB, 3 * ulp(32768), 6 * (x->m + x->n + 1) * ulp(32768)));
}

static void arguments_out_of_range_are_refused(arb *a)
{
    tensor *x = arb_tensor(a);
    loft_tensor s = x->s;
    loft_vec p = x->p[0];

    CHECK(loft_tensor_init(&s, x->p, 10, 1) == LOFT_ERR_ARG &&
          loft_tensor_init(&s, x->p, 1, 10) == LOFT_ERR_ARG);
    CHECK(loft_tensor_deriv(&s, 1, 0, LOFT_UNIT(1.01), 0, &p) == LOFT_ERR_ARG);
    CHECK(loft_tensor_deriv(&s, 1, 0, 0, LOFT_UNIT(-0.01), &p) == LOFT_ERR_ARG);
    CHECK(loft_tensor_deriv(&s, 5, 5, 0, 0, &p) == LOFT_ERR_ARG &&
          loft_tensor_deriv(&s, 0, 10, 0, 0, &p) == LOFT_ERR_ARG);
    CHECK(loft_vec_equal(p, x->p[0]) && s.m == x->m && s.n == x->n);
#if LOFT_NUM != LOFT_Q16
    x->p[x->n].axis[LOFT_AXES - 1] = (loft_real)INFINITY;
    CHECK(loft_tensor_init(&s, x->p, x->m, x->n) == LOFT_ERR_RANGE);
#endif
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound, 4000);
    PROPERTY(both_orders_agree, 1000);
    PROPERTY(corners_are_exact_and_beyond_is_clamped, 300);
    PROPERTY(edges_are_evaluated_as_curves, 1000);
    PROPERTY(curves_across_lie_on_the_patch, 500);
    PROPERTY(a_derivative_is_within_its_bound_or_refused, 4000);
    PROPERTY(splitting_changes_nothing, 500);
    PROPERTY(parts_and_raised_patches_are_the_patch, 400);
    PROPERTY(a_patch_is_raised_curve_by_curve, 300);
    PROPERTY(a_piece_may_take_the_place_of_its_net, 300);
    PROPERTY(the_patch_stays_in_its_box, 1000);
    PROPERTY(an_affine_map_of_the_net_maps_the_points, 500);
    PROPERTY(arguments_out_of_range_are_refused, 20);
    return check_failures();
}

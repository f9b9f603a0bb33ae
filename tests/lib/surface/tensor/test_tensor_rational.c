/* tests/lib/surface/tensor/test_tensor_rational.c -- properties of
 * lib/surface/tensor/tensor_rational.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"              /* CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/tensor_rational.h"
#include "support/tensors.h"    /* TENSOR_POINTS, exact_deriv */

typedef struct {
    loft_weighted p[TENSOR_POINTS];
    unsigned m, n;
    loft_tensor_rational s;
    long double largest, ratio;
} rational;

/* Weights within 1/reach..reach, extremes among them. */
static rational *arb_patch(arb *a, unsigned reach, int32_t limit)
{
    static rational x;
    long double least = 1e9L, most = 0;

    x.m = arb_below(a, LOFT_DEGREE_MAX + 1);
    x.n = arb_below(a, LOFT_DEGREE_MAX + 1);
    x.largest = 0;
    for (unsigned k = 0; k < (x.m + 1) * (x.n + 1); k++) {
        const uint32_t kind = arb_below(a, 4);
        const double w = kind == 0   ? reach
                         : kind == 1 ? 1.0 / reach
                                     : 1.0 / reach + arb_below(a, 65536) / 65536.0 *
                                                         (kind == 2 ? 1 : reach - 1);
        x.p[k].p = arb_vec(a, limit);
        x.p[k].w = (loft_real)BY_NUM(w * 65536, w, w);
        least = fminl(least, exact_of(x.p[k].w));
        most = fmaxl(most, exact_of(x.p[k].w));
        for (int i = 0; i < LOFT_AXES; i++)
            x.largest = fmaxl(x.largest, fabsl(exact_of(x.p[k].p.axis[i])));
    }
    x.ratio = most / least;
    CHECK(loft_tensor_rational_init(&x.s, x.p, x.m, x.n) == LOFT_OK);
    return &x;
}

/* Numerator (axis) or denominator (axis -1), differentiated, about the first control point. */
static long double polynomial(const loft_tensor_rational *s, int axis, unsigned a, unsigned b,
                              long double u, long double v)
{
    long double row[LOFT_DEGREE_MAX + 1], column[LOFT_DEGREE_MAX + 1];

    for (unsigned i = 0; i <= s->m; i++) {
        for (unsigned j = 0; j <= s->n; j++) {
            const loft_weighted *p = &s->p[i * (s->n + 1u) + j];
            row[j] = exact_of(p->w) *
                     (axis < 0 ? 1 : exact_of(p->p.axis[axis]) - exact_of(s->p[0].p.axis[axis]));
        }
        column[i] = exact_deriv(row, s->n, b, v);
    }
    return exact_deriv(column, s->m, a, u);
}

static long double point(const loft_tensor_rational *s, int axis, long double u, long double v)
{
    return polynomial(s, axis, 0, 0, u, v) / polynomial(s, -1, 0, 0, u, v) +
           exact_of(s->p[0].p.axis[axis]);
}

static void check_point(const rational *x, arb *a)
{
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const loft_vec p = loft_tensor_rational_eval(&x->s, u, v);

    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), point(&x->s, i, exact_unit(u), exact_unit(v)),
                    BY_NUM(LSB / 2 + (x->m + x->n) * x->ratio * 0x1p-30L * LSB + 1e-12L,
                           ulp(x->largest), (6 * (x->m + x->n) + 4) * ulp(x->largest)));
}

static void a_point_is_within_its_bound(arb *a) { check_point(arb_patch(a, 16, 32767), a); }
static void so_it_is_with_weights_to_256(arb *a) { check_point(arb_patch(a, 256, 32767), a); }

static void corners_are_exact_and_points_within_the_box(arb *a)
{
    const rational *x = arb_patch(a, 256, 32767);
    const unsigned last = (x->m + 1) * (x->n + 1) - 1;
    const loft_box box = loft_tensor_rational_box(&x->s);
    const loft_vec p = loft_tensor_rational_eval(&x->s, arb_unit(a), arb_unit(a));
    const long double slack = BY_NUM(0, 0, (6 * (x->m + x->n) + 4) * ulp(x->largest));

    for (int i = 0; i < LOFT_AXES; i++) {
        CHECK(exact_of(p.axis[i]) >= exact_of(box.min.axis[i]) - slack &&
              exact_of(p.axis[i]) <= exact_of(box.max.axis[i]) + slack);
        CHECK_EXACT(exact_of(loft_tensor_rational_eval(&x->s, 0, 0).axis[i]),
                    exact_of(x->p[0].p.axis[i]), BY_NUM(0, 0, ulp(x->largest)));
        CHECK_EXACT(exact_of(loft_tensor_rational_eval(&x->s, LOFT_UNIT(1), LOFT_UNIT(1)).axis[i]),
                    exact_of(x->p[last].p.axis[i]), BY_NUM(0, 0, ulp(x->largest)));
    }
}

static void derivatives_are_within_their_bounds_or_refused(arb *a)
{
    const rational *x = arb_patch(a, arb_below(a, 2) ? 16 : 256, (int32_t)1 << arb_below(a, 15));
    const loft_unit at_u = arb_unit(a), at_v = arb_unit(a);
    const long double u = exact_unit(at_u), v = exact_unit(at_v),
                      w = polynomial(&x->s, -1, 0, 0, u, v);
    const unsigned d = x->m > x->n ? x->m : x->n, rows = x->m + x->n;
    loft_vec by_u, by_v;
    bool all = true;

    const enum loft_status status = loft_tensor_rational_deriv(&x->s, at_u, at_v, &by_u, &by_v);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double p = polynomial(&x->s, i, 0, 0, u, v) / w;
        const long double want_u =
            (polynomial(&x->s, i, 1, 0, u, v) - p * polynomial(&x->s, -1, 1, 0, u, v)) / w;
        const long double want_v =
            (polynomial(&x->s, i, 0, 1, u, v) - p * polynomial(&x->s, -1, 0, 1, u, v)) / w;
        const long double by_num = BY_NUM(LSB / 2 + d * rows * x->ratio * 0x1p-26L * LSB,
                                          32 * d * (rows + 1) * x->ratio * ulp_double(x->largest),
                                          32 * d * (rows + 1) * x->ratio * ulp_double(x->largest));
        all = all && BY_NUM(fabsl(want_u) < 32767 && fabsl(want_v) < 32767, true, true);
        if (status == LOFT_OK) {
            CHECK_EXACT(exact_of(by_u.axis[i]), want_u,
                        by_num + BY_NUM(0, ulp(want_u) / 2, ulp(want_u) / 2) +
                            1e-9L * BY_NUM(LSB, 0, 0));
            CHECK_EXACT(exact_of(by_v.axis[i]), want_v,
                        by_num + BY_NUM(0, ulp(want_v) / 2, ulp(want_v) / 2) +
                            1e-9L * BY_NUM(LSB, 0, 0));
        }
    }
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !all));
}

/* The piece is the patch, up to the rounding of its weights. */
static void check_piece(const rational *x, const loft_weighted net[], unsigned m, unsigned n,
                        const long double u[2], const long double v[2], arb *a)
{
    loft_tensor_rational piece;
    const loft_unit s = arb_unit(a), t = arb_unit(a);

    CHECK(loft_tensor_rational_init(&piece, net, m, n) == LOFT_OK);
    const long double at_u = u[0] + (u[1] - u[0]) * exact_unit(s),
                      at_v = v[0] + (v[1] - v[0]) * exact_unit(t);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(
            point(&piece, i, exact_unit(s), exact_unit(t)), point(&x->s, i, at_u, at_v),
            BY_NUM(LSB + 4 * x->largest / 65536, 24 * ulp(x->largest), 200 * ulp(x->largest)));
}

static void splitting_and_raising_change_nothing(arb *a)
{
    static loft_weighted left[TENSOR_POINTS], right[TENSOR_POINTS];
    rational *x = arb_patch(a, 1, 32767);
    const long double whole[2] = { 0, 1 };
    const unsigned times = arb_below(a, 4);

    for (unsigned k = 0; k < (x->m + 1) * (x->n + 1); k++)
        x->p[k].w = LOFT_REAL(1) + arb_real(a, 15) / 16 + LOFT_REAL(1);
    CHECK(loft_tensor_rational_init(&x->s, x->p, x->m, x->n) == LOFT_OK);
    const loft_unit t = arb_unit(a);
    const long double before[2] = { 0, exact_unit(t) }, after[2] = { exact_unit(t), 1 };

    CHECK(loft_tensor_rational_split_u(&x->s, t, left, right) == LOFT_OK);
    check_piece(x, left, x->m, x->n, before, whole, a);
    check_piece(x, right, x->m, x->n, after, whole, a);
    CHECK(loft_tensor_rational_split_v(&x->s, t, left, right) == LOFT_OK);
    check_piece(x, left, x->m, x->n, whole, before, a);
    check_piece(x, right, x->m, x->n, whole, after, a);
    if (x->m + times <= LOFT_DEGREE_MAX) {
        CHECK(loft_tensor_rational_elevate_u(&x->s, times, left) == LOFT_OK);
        check_piece(x, left, x->m + times, x->n, whole, whole, a);
    }
    if (x->n + times <= LOFT_DEGREE_MAX) {
        CHECK(loft_tensor_rational_elevate_v(&x->s, times, left) == LOFT_OK);
        check_piece(x, left, x->m, x->n + times, whole, whole, a);
    }
}

static void arguments_out_of_range_are_refused(arb *a)
{
    rational *x = arb_patch(a, 16, 1000);
    loft_tensor_rational s = x->s;
    loft_vec p = { { 0 } }, q = p;
    loft_weighted left[TENSOR_POINTS], right[TENSOR_POINTS];

    CHECK(loft_tensor_rational_init(&s, x->p, 10, 0) == LOFT_ERR_ARG &&
          loft_tensor_rational_init(&s, x->p, 0, 10) == LOFT_ERR_ARG);
    CHECK(loft_tensor_rational_deriv(&s, LOFT_UNIT(1.5), 0, &p, &q) == LOFT_ERR_ARG);
    CHECK(loft_tensor_rational_split_u(&s, LOFT_UNIT(2.5), left, right) == LOFT_ERR_ARG);
    CHECK(loft_tensor_rational_elevate_v(&s, LOFT_ELEVATE_MAX + 1 - x->n, left) == LOFT_ERR_ARG);
    x->p[x->n].w = 0;
    CHECK(loft_tensor_rational_init(&s, x->p, x->m, x->n) == LOFT_ERR_RANGE);
    x->p[x->n].w = LOFT_REAL(257);
    CHECK(loft_tensor_rational_init(&s, x->p, x->m, x->n) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound, 1500);
    PROPERTY(so_it_is_with_weights_to_256, 1500);
    PROPERTY(corners_are_exact_and_points_within_the_box, 500);
    PROPERTY(derivatives_are_within_their_bounds_or_refused, 600);
    PROPERTY(splitting_and_raising_change_nothing, 300);
    PROPERTY(arguments_out_of_range_are_refused, 30);
    return check_failures();
}

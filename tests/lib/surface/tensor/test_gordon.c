/* tests/lib/surface/tensor/test_gordon.c -- properties of lib/surface/tensor/gordon.h
 * SPDX-License-Identifier: MIT
 *
 * The reference is the formula in 113 bits. Its splines are solved one by one.
 */
#include "support/exact_spline.h"       /* quad, bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/gordon.h"
#include "surface/tensor/tensor.h"

#define MOST 6

typedef struct {
    unsigned rows, columns, m, n;
    loft_unit u[MOST], v[MOST];
    loft_vec net[36], by_u[MOST][6], by_v[MOST][6];
    loft_bezier along_u[MOST], along_v[MOST];
    loft_side side_u[MOST], side_v[MOST];
    loft_gordon_point memory[MOST * MOST];
    loft_gordon g;
} sample;

static void arb_parameters(arb *a, unsigned count, loft_unit at[])
{
    uint32_t sum = 0, part[MOST];

    for (unsigned k = 0; k + 1 < count; k++)
        sum += part[k] = 32 + arb_below(a, 64);
    uint32_t here = 0;
    for (unsigned k = 0; k < count; k++) {
        at[k] = k + 1 == count ? LOFT_UNIT(1) : loft_unit_of(here, sum);
        here += k + 1 < count ? part[k] : 0;
    }
}

/* The lines of a patch: they meet, but for rounding. */
static sample *arb_sample(arb *a)
{
    static sample s;
    loft_tensor t;

    s.rows = 2 + arb_below(a, MOST - 1);
    s.columns = 2 + arb_below(a, MOST - 1);
    s.m = 1 + arb_below(a, 5);
    s.n = 1 + arb_below(a, 5);
    arb_parameters(a, s.rows, s.u);
    arb_parameters(a, s.columns, s.v);
    for (unsigned k = 0; k < (s.m + 1) * (s.n + 1); k++)
        s.net[k] = arb_vec(a, 500);
    CHECK(loft_tensor_init(&t, s.net, s.m, s.n) == LOFT_OK);
    for (unsigned j = 0; j < s.columns; j++) {
        loft_tensor_at_v(&t, s.v[j], s.by_u[j]);
        CHECK(loft_bezier_init(&s.along_u[j], s.by_u[j], s.m) == LOFT_OK);
        s.side_u[j] = loft_side_from_bezier(&s.along_u[j]);
    }
    for (unsigned i = 0; i < s.rows; i++) {
        loft_tensor_at_u(&t, s.u[i], s.by_v[i]);
        CHECK(loft_bezier_init(&s.along_v[i], s.by_v[i], s.n) == LOFT_OK);
        s.side_v[i] = loft_side_from_bezier(&s.along_v[i]);
    }
    CHECK(loft_gordon_init(&s.g, s.side_u, s.v, s.columns, s.side_v, s.u, s.rows,
                           BY_NUM(2, LOFT_REAL(1e-3), LOFT_REAL(1e-9)), s.memory) == LOFT_OK);
    return &s;
}

/* Value of the spline that is 1 at knot `one`: second derivatives by elimination. */
static quad cardinal(const loft_unit at[], unsigned count, unsigned one, quad x)
{
    quad t[MOST], second[MOST] = { 0 }, left[MOST] = { 0 }, right[MOST] = { 0 };
    unsigned k = 0;

    for (unsigned i = 0; i < count; i++)
        t[i] = (quad)exact_unit(at[i]);
    for (unsigned i = 1; i + 1 < count; i++) {
        const quad y0 = i - 1 == one, y1 = i == one, y2 = i + 1 == one, h0 = t[i] - t[i - 1],
                   h1 = t[i + 1] - t[i];
        left[i] = 2 * (h0 + h1) - (i > 1 ? h0 * h0 / left[i - 1] : 0);
        right[i] = 6 * ((y2 - y1) / h1 - (y1 - y0) / h0) -
                   (i > 1 ? h0 / left[i - 1] * right[i - 1] : 0);
    }
    for (unsigned i = count - 1; i-- > 1; )
        second[i] = (right[i] - (t[i + 1] - t[i]) * second[i + 1]) / left[i];
    while (k + 2 < count && t[k + 1] <= x)
        k++;
    const quad h = t[k + 1] - t[k], b = (x - t[k]) / h, c = 1 - b;
    return c * (k == one) + b * (k + 1 == one) +
           h * h / 6 * ((c * c * c - c) * second[k] + (b * b * b - b) * second[k + 1]);
}

static quad bezier_at(const loft_vec p[], unsigned n, quad t, int axis)
{
    quad c[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= n; k++)
        c[k] = quad_of(p[k].axis[axis]);
    for (; n > 0; n--)
        for (unsigned k = 0; k < n; k++)
            c[k] += (c[k + 1] - c[k]) * t;
    return c[0];
}

static long double size_of(quad x) { return fabsl((long double)x); }

/* Returns L. */
static long double reference(const sample *s, loft_unit u, loft_unit v, quad out[LOFT_AXES])
{
    const quad x = (quad)exact_unit(u), y = (quad)exact_unit(v);
    long double of_f = 0, of_g = 0;

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        out[axis] = of_f = of_g = 0;
        for (unsigned j = 0; j < s->columns; j++) {
            out[axis] += cardinal(s->v, s->columns, j, y) * bezier_at(s->by_u[j], s->m, x, axis);
            of_f += size_of(cardinal(s->v, s->columns, j, y));
        }
        for (unsigned i = 0; i < s->rows; i++) {
            quad rest = bezier_at(s->by_v[i], s->n, y, axis);
            for (unsigned j = 0; j < s->columns; j++)
                rest -= cardinal(s->v, s->columns, j, y) *
                        bezier_at(s->by_u[j], s->m, (quad)exact_unit(s->u[i]), axis);
            out[axis] += cardinal(s->u, s->rows, i, x) * rest;
            of_g += size_of(cardinal(s->u, s->rows, i, x));
        }
    }
    return of_f + of_g + of_f * of_g;
}

static void points_are_within_their_bound(arb *a)
{
    const sample *s = arb_sample(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    quad want[LOFT_AXES];
    loft_vec got = { { 0 } };
    const long double most = reference(s, u, v, want);
    const enum loft_status status = loft_gordon_eval(&s->g, u, v, &got);

    check_result(status, &got, want, 0.5L + 0x1p-16L + most * 5 * 0x1p-17L,
                 bound_by_num(0, most * 0x1p-20L * ulp(512), 64 * most * ulp(512)));
}

static void it_goes_through_all_curves(arb *a)
{
    const sample *s = arb_sample(a);
    const loft_unit t = arb_unit(a);

    for (unsigned j = 0; j < s->columns; j++) {
        loft_vec p = { { 0 } };
        CHECK(loft_gordon_eval(&s->g, t, s->v[j], &p) == LOFT_OK);
        const loft_vec q = loft_bezier_eval(&s->along_u[j], t);
        for (int i = 0; i < LOFT_AXES; i++)     /* times the sum of |g_i|, below 3 */
            CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                        bound_by_num(7 * LSB, 0x1p-9L, 0x1p-30L));
    }
    for (unsigned i = 0; i < s->rows; i++) {
        loft_vec p = { { 0 } };
        CHECK(loft_gordon_eval(&s->g, s->u[i], t, &p) == LOFT_OK);
        const loft_vec q = loft_bezier_eval(&s->along_v[i], t);
        for (int k = 0; k < LOFT_AXES; k++)
            CHECK_EXACT(exact_of(p.axis[k]), exact_of(q.axis[k]),
                        bound_by_num(1.1L * LSB, 2 * ulp(512), 1024 * ulp(512)));
    }
}

static void two_curves_each_way_make_a_coons_patch(arb *a)
{
    const sample *s = arb_sample(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    loft_vec p = { { 0 } }, q = { { 0 } };
    loft_coons c;

    if (s->rows > 2 || s->columns > 2)
        return;
    CHECK(loft_coons_init(&c, s->side_u, s->side_v, BY_NUM(2, LOFT_REAL(1e-3), LOFT_REAL(1e-9))) ==
          LOFT_OK);
    CHECK(loft_coons_eval(&c, u, v, &q) == loft_gordon_eval(&s->g, u, v, &p));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    bound_by_num(1.1L * LSB, 4 * ulp(512), 512 * ulp(512)));
}

static void its_patches_are_the_same_surface(arb *a)
{
    const sample *s = arb_sample(a);
    const unsigned i = arb_below(a, s->rows - 1), j = arb_below(a, s->columns - 1),
                   m = s->m > 3 ? s->m : 3, n = s->n > 3 ? s->n : 3;
    const loft_unit from[2] = { s->u[i], s->v[j] };
    const loft_unit to[2] = { arb_below(a, 2) ? s->u[i + 1] : s->u[i] + (s->u[i + 1] - s->u[i]) / 2,
                              s->v[j + 1] };
    loft_vec p[MOST][6], q[MOST][6], net[36], on = { { 0 } };
    loft_bezier by_u[MOST], by_v[MOST];
    loft_tensor t;

    for (unsigned k = 0; k < s->columns; k++)
        CHECK(loft_bezier_sub(&s->along_u[k], from[0], to[0], p[k]) == LOFT_OK &&
              loft_bezier_init(&by_u[k], p[k], s->m) == LOFT_OK);
    for (unsigned k = 0; k < s->rows; k++)
        CHECK(loft_bezier_sub(&s->along_v[k], from[1], to[1], q[k]) == LOFT_OK &&
              loft_bezier_init(&by_v[k], q[k], s->n) == LOFT_OK);
    CHECK(loft_tensor_from_gordon(&s->g, by_u, by_v, from, to, m, n, net) == LOFT_OK &&
          loft_tensor_init(&t, net, m, n) == LOFT_OK);
    for (uint32_t k = 0; k < 9; k++) {
        const loft_unit x = LOFT_UNIT(0.5) * (loft_unit)(k % 3),
                        y = LOFT_UNIT(0.5) * (loft_unit)(k / 3);
        quad want[LOFT_AXES];
        const loft_unit u = from[0] + (to[0] - from[0]) / 2 * (loft_unit)(k % 3) * 1,
                        v = from[1] + (to[1] - from[1]) / 2 * (loft_unit)(k / 3);
        const long double most = reference(s, u, v, want);
        on = loft_tensor_eval(&t, BY_NUM(x / 1, x, x), y);
        for (int axis = 0; axis < LOFT_AXES; axis++)    /* u and v are rounded to 2^-24 */
            CHECK_EXACT((long double)(quad_of(on.axis[axis]) - want[axis]), 0,
                        bound_by_num((1.6L + most) * LSB + 0x1p-24L * 20000,
                                     (4 + most) * ulp(512) + 0x1p-24L * 20000,
                                     256 * most * ulp(512)));
    }
}

static void mistakes_are_refused(arb *a)
{
    sample *s = arb_sample(a);
    loft_gordon g;
    loft_vec p;
    const loft_unit from[2] = { 0, 0 }, to[2] = { LOFT_UNIT(1), LOFT_UNIT(1) };
    loft_vec net[100];

    CHECK(loft_gordon_eval(&s->g, LOFT_UNIT(1.5), 0, &p) == LOFT_ERR_ARG &&
          loft_gordon_eval(&s->g, 0, LOFT_UNIT(-0.5), &p) == LOFT_ERR_ARG);
    CHECK(loft_tensor_from_gordon(&s->g, s->along_u, s->along_v, to, from, 5, 5, net) ==
              LOFT_ERR_ARG &&
          loft_tensor_from_gordon(&s->g, s->along_u, s->along_v, from, to, 5, 2, net) ==
              LOFT_ERR_ARG);
    CHECK(s->rows == 2 || loft_tensor_from_gordon(&s->g, s->along_u, s->along_v, from, to, 5, 5,
                                                  net) == LOFT_ERR_ARG);
    CHECK(loft_gordon_init(&g, s->side_u, s->v, 1, s->side_v, s->u, s->rows, 0, s->memory) ==
          LOFT_ERR_ARG);
    s->by_u[0][0].axis[0] += LOFT_REAL(1);
    CHECK(loft_gordon_init(&g, s->side_u, s->v, s->columns, s->side_v, s->u, s->rows,
                           LOFT_REAL(0.5), s->memory) == LOFT_ERR_ARG);
    s->u[0] = LOFT_UNIT(0.01);
    CHECK(loft_gordon_init(&g, s->side_u, s->v, s->columns, s->side_v, s->u, s->rows, LOFT_REAL(2),
                           s->memory) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(points_are_within_their_bound,          500);
    PROPERTY(it_goes_through_all_curves,             300);
    PROPERTY(two_curves_each_way_make_a_coons_patch, 500);
    PROPERTY(its_patches_are_the_same_surface,       300);
    PROPERTY(mistakes_are_refused,                    50);
    return check_failures();
}

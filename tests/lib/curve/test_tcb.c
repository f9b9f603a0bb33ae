/* tests/lib/curve/test_tcb.c -- properties of lib/curve/tcb.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* check_result, quad_of; CHECK, PROPERTY, BY_NUM */
#include "curve/cardinal.h"
#include "curve/tcb.h"

typedef struct {
    loft_vec p[4];
    loft_tcb k[2];
    long double largest;
} sample;

static loft_unit arb_knob(arb *a)
{
    return arb_below(a, 4) ? (loft_unit)(2 * arb_unit(a) - LOFT_UNIT(1))
                           : (loft_unit)(4 * arb_unit(a) - LOFT_UNIT(2));
}

static sample arb_sample(arb *a)
{
    const int32_t limit = (int32_t)1 << arb_below(a, 15);
    sample s = { .largest = 0 };

    for (int k = 0; k < 4; k++)
        s.p[k] = arb_vec(a, limit);
    for (int k = 0; k < 2; k++)
        s.k[k] = (loft_tcb) { arb_knob(a), arb_knob(a), arb_knob(a) };
    s.largest = limit;
    return s;
}

static quad chord(const loft_vec *p, int i)
{
    return quad_of(p[1].axis[i]) - quad_of(p[0].axis[i]);
}

static quad exact_tangent(const sample *s, int end, int i)
{
    const quad t = (quad)exact_unit(s->k[end].tension), c = (quad)exact_unit(s->k[end].continuity),
               b = (quad)exact_unit(s->k[end].bias), sign = end ? -1 : 1;

    return (1 - t) * (1 + sign * c) * (1 + b) / 2 * chord(s->p + end, i) +
           (1 - t) * (1 - sign * c) * (1 - b) / 2 * chord(s->p + end + 1, i);
}

static quad exact_segment(const sample *s, unsigned k, quad t, int i)
{
    const quad m = exact_tangent(s, 0, i), n = exact_tangent(s, 1, i), d = chord(s->p + 1, i);
    const quad c2 = 3 * d - 2 * m - n, c3 = m + n - 2 * d;

    return k == 0   ? quad_of(s->p[1].axis[i]) + t * (m + t * (c2 + t * c3))
           : k == 1 ? m + t * (2 * c2 + 3 * t * c3)
           : k == 2 ? 2 * c2 + 6 * t * c3
           : k == 3 ? 6 * c3
                    : 0;
}

static void points_and_derivatives_are_within_their_bound(arb *a)
{
    const sample s = arb_sample(a);
    const loft_unit t = arb_unit(a);

    for (unsigned k = 0; k <= 4; k++) {
        quad want[LOFT_AXES];
        loft_vec v = { { 0 } };
        for (int i = 0; i < LOFT_AXES; i++)
            want[i] = exact_segment(&s, k, (quad)exact_unit(t), i);
        const enum loft_status status = k ? loft_tcb_deriv(s.p, &s.k[0], &s.k[1], k, t, &v)
                                          : loft_tcb_eval(s.p, &s.k[0], &s.k[1], t, &v);
        check_result(status, &v, want, 0.5L + (k ? 0x1p-12L : 0x1p-14L),
                     bound_by_num(0, ulp(s.largest) / 2, (k ? 4096 : 256) * ulp(s.largest)));
    }
}

static void tangents_are_those_of_the_curve(arb *a)
{
    const sample s = arb_sample(a);
    loft_vec out[2] = { { { 0 } } };
    const enum loft_status status = loft_tcb_tangents(s.p, &s.k[0], &s.k[1], out);

    if (status != LOFT_OK)
        return;
    for (int end = 0; end < 2; end++) {
        quad want[LOFT_AXES];
        for (int i = 0; i < LOFT_AXES; i++)
            want[i] = exact_tangent(&s, end, i);
        check_result(status, &out[end], want, 0.5L + 0x1p-16L,
                     bound_by_num(0, 0x1p-20L * ulp(s.largest), 128 * ulp(s.largest)));
    }
}

static void without_continuity_and_bias_it_is_a_cardinal_spline(arb *a)
{
    sample s = arb_sample(a);
    const loft_unit tension = s.k[0].tension, t = arb_unit(a);
    const loft_tcb k = { tension, 0, 0 };
    loft_vec one = { { 0 } }, two = { { 0 } };

    if (loft_tcb_eval(s.p, &k, &k, t, &one) != LOFT_OK ||
        loft_cardinal_eval(s.p, tension, t, &two) != LOFT_OK)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(one.axis[i]), exact_of(two.axis[i]),
                    bound_by_num(LSB, 8 * ulp(4 * s.largest), 512 * ulp(s.largest)));
}

static void control_points_make_the_same_segment(arb *a)
{
    const sample s = arb_sample(a);
    loft_cubic c = { { { { 0 } } } };

    if (loft_cubic_from_tcb(s.p, &s.k[0], &s.k[1], &c) != LOFT_OK)
        return;
    CHECK(loft_vec_equal(c.p[0], s.p[1]) && loft_vec_equal(c.p[3], s.p[2]));
    for (int end = 0; end < 2; end++) {
        quad want[LOFT_AXES];
        for (int i = 0; i < LOFT_AXES; i++)
            want[i] = quad_of(s.p[1 + end].axis[i]) +
                      (end ? -1 : 1) * exact_tangent(&s, end, i) / 3;
        check_result(LOFT_OK, &c.p[1 + end], want, 0.5L + 0x1p-14L,
                     bound_by_num(0, ulp(s.largest) / 2, 256 * ulp(s.largest)));
    }
}

static void mistakes_are_refused(arb *a)
{
    const sample s = arb_sample(a);
    const loft_tcb none = { 0, 0, 0 }, far = { 0, LOFT_UNIT(2.5), 0 };
    const loft_vec before = arb_vec(a, 100);
    loft_vec v = before;

    CHECK(loft_tcb_eval(s.p, &far, &none, 0, &v) == LOFT_ERR_ARG &&
          loft_tcb_eval(s.p, &none, &far, 0, &v) == LOFT_ERR_ARG &&
          loft_tcb_eval(s.p, &none, &none, LOFT_UNIT(1.5), &v) == LOFT_ERR_ARG);
    CHECK(loft_vec_equal(v, before));
}

int main(void)
{
    PROPERTY(points_and_derivatives_are_within_their_bound,       3000);
    PROPERTY(tangents_are_those_of_the_curve,                     3000);
    PROPERTY(without_continuity_and_bias_it_is_a_cardinal_spline, 2000);
    PROPERTY(control_points_make_the_same_segment,                2000);
    PROPERTY(mistakes_are_refused,                                 100);
    return check_failures();
}

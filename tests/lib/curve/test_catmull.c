/* tests/lib/curve/test_catmull.c -- properties of lib/curve/catmull.h
 * SPDX-License-Identifier: MIT
 *
 * The reference is the pyramid of Barry and Goldman, in 113 bits, for alpha 0, 1/2 and 1; other
 * values of alpha by the powers of long double.
 */
#include "support/exact_spline.h"       /* check_result, quad_of; CHECK, PROPERTY, BY_NUM */
#include "curve/cardinal.h"
#include "curve/catmull.h"

typedef struct {
    loft_vec p[4];
    loft_unit alpha;
    bool same;
    quad h[3];
} sample;

static quad step_of(const loft_vec *p, loft_unit alpha)
{
    quad sum = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const quad d = quad_of(p[1].axis[i]) - quad_of(p[0].axis[i]);
        sum += d * d;
    }
    if (!(sum > 0))
        return 0;
    return alpha == 0                ? 1
           : alpha == LOFT_UNIT(1)   ? quad_sqrt(sum)
           : alpha == LOFT_UNIT(0.5) ? quad_sqrt(quad_sqrt(sum))
                                     : powl(sqrtl((long double)sum), exact_unit(alpha));
}

static sample arb_sample(arb *a)
{
    const int32_t limit = (int32_t)1 << arb_below(a, 15);
    const loft_unit usual[3] = { 0, LOFT_UNIT(0.5), LOFT_UNIT(1) };
    sample s = { .same = false };

    for (int k = 0; k < 4; k++) {
        s.p[k] = arb_vec(a, arb_below(a, 4) ? limit : 1);
        if (k > 0 && arb_below(a, 20) == 0)
            s.p[k] = s.p[k - 1];
    }
    s.alpha = arb_below(a, 3) ? usual[arb_below(a, 3)] : arb_unit(a);
    for (int k = 0; k < 3; k++) {
        s.h[k] = step_of(s.p + k, s.alpha);
        s.same = s.same || !(s.h[k] > 0);
    }
    return s;
}

/* By three rows of lerps over the knots 0, h0, h0 + h1, h0 + h1 + h2. */
static quad pyramid(const sample *s, quad t, int axis)
{
    const quad k[4] = { 0, s->h[0], s->h[0] + s->h[1], s->h[0] + s->h[1] + s->h[2] },
               u = k[1] + t * s->h[1];
    quad x[4];

    for (int i = 0; i < 4; i++)
        x[i] = quad_of(s->p[i].axis[axis]);
    for (int i = 0; i < 3; i++)
        x[i] += (x[i + 1] - x[i]) * (u - k[i]) / (k[i + 1] - k[i]);
    for (int i = 0; i < 2; i++)
        x[i] += (x[i + 1] - x[i]) * (u - k[i]) / (k[i + 2] - k[i]);
    return x[0] + (x[1] - x[0]) * (u - k[1]) / (k[2] - k[1]);
}

static void points_are_those_of_the_pyramid(arb *a)
{
    const sample s = arb_sample(a);
    const loft_unit t = arb_unit(a);
    quad want[LOFT_AXES];
    loft_vec v = { { 0 } };
    const enum loft_status status = loft_catmull_eval(s.p, s.alpha, t, &v);

    CHECK((status == LOFT_SINGULAR) == s.same);
    if (s.same)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        want[i] = pyramid(&s, (quad)exact_unit(t), i);
    check_result(status, &v, want, 0.5L + 0x1p-14L,
                 bound_by_num(0, ulp(16384) / 2, 128 * ulp(16384)));
    if (t == 0 || t == LOFT_UNIT(1))
        CHECK(BY_NUM(loft_vec_equal(v, s.p[t > 0 ? 2 : 1]), true, true));
}

/* The derivative at the ends: the parabola through three points. */
static void slopes_at_points_are_those_of_parabolas(arb *a)
{
    const sample s = arb_sample(a);
    loft_vec v = { { 0 } };

    for (unsigned end = 0; end < 2 && !s.same; end++) {
        quad want[LOFT_AXES];
        const quad g = s.h[end], h = s.h[end + 1];
        for (int i = 0; i < LOFT_AXES; i++) {
            const quad x = quad_of(s.p[end].axis[i]), y = quad_of(s.p[end + 1].axis[i]),
                       z = quad_of(s.p[end + 2].axis[i]);
            want[i] = s.h[1] * ((y - x) / g - (z - x) / (g + h) + (z - y) / h);
        }
        const enum loft_status status = loft_catmull_deriv(s.p, s.alpha, 1, end ? LOFT_UNIT(1) : 0,
                                                           &v);
        check_result(status, &v, want, 0.5L + 0x1p-12L,
                     bound_by_num(0, ulp(16384) / 2, 2048 * ulp(16384)));
    }
}

static void uniform_knots_make_a_cardinal_spline(arb *a)
{
    const sample s = arb_sample(a);
    const loft_unit t = arb_unit(a);
    loft_vec one = { { 0 } }, two = { { 0 } };

    if (loft_catmull_eval(s.p, 0, t, &one) != LOFT_OK ||
        loft_cardinal_eval(s.p, 0, t, &two) != LOFT_OK)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(one.axis[i]), exact_of(two.axis[i]),
                    bound_by_num(LSB, 2 * ulp(32768), 128 * ulp(32768)));
}

static void control_points_are_a_third_of_the_slopes_away(arb *a)
{
    const sample s = arb_sample(a);
    loft_cubic c;
    loft_vec d = { { 0 } };

    if (loft_cubic_from_catmull(s.p, s.alpha, &c) != LOFT_OK ||
        loft_catmull_deriv(s.p, s.alpha, 1, 0, &d) != LOFT_OK)
        return;
    CHECK(loft_vec_equal(c.p[0], s.p[1]) && loft_vec_equal(c.p[3], s.p[2]));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(3 * (exact_of(c.p[1].axis[i]) - exact_of(c.p[0].axis[i])), exact_of(d.axis[i]),
                    bound_by_num(2.1L * LSB, 8 * ulp(32768), 8 * ulp(32768)));
}

static void mistakes_are_refused(arb *a)
{
    const sample s = arb_sample(a);
    const loft_vec before = arb_vec(a, 100);
    loft_vec v = before;

    CHECK(loft_catmull_eval(s.p, LOFT_UNIT(1.5), 0, &v) == LOFT_ERR_ARG &&
          loft_catmull_eval(s.p, LOFT_UNIT(-0.5), 0, &v) == LOFT_ERR_ARG &&
          loft_catmull_eval(s.p, 0, LOFT_UNIT(1.5), &v) == LOFT_ERR_ARG);
    CHECK(loft_vec_equal(v, before));
}

int main(void)
{
    PROPERTY(points_are_those_of_the_pyramid,               3000);
    PROPERTY(slopes_at_points_are_those_of_parabolas,       3000);
    PROPERTY(uniform_knots_make_a_cardinal_spline,          1000);
    PROPERTY(control_points_are_a_third_of_the_slopes_away, 2000);
    PROPERTY(mistakes_are_refused,                           100);
    return check_failures();
}

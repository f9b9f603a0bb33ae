/* tests/lib/curve/test_spline.c -- properties of lib/curve/spline.h
 * SPDX-License-Identifier: MIT
 *
 * The reference knows no system of equations: what defines a spline is checked of the result. It is
 * rebuilt in 113 bits from the wide slopes of the library, and must meet the points, join with
 * equal second derivatives, and end as said.
 */
#include "support/exact_spline.h"       /* check_result, quad_of; CHECK, PROPERTY, BY_NUM */
#include "curve/spline.h"

#define MOST 40

typedef struct {
    unsigned count, segments;
    bool chord;
    enum loft_spline_ends ends;
    loft_vec p[MOST], slope[2];
    loft_spline_knot memory[MOST];
    loft_spline s;
    enum loft_status status;
    quad h[MOST];
    long double scale;          /* the largest slope, of points or of chords */
} sample;

static void set_steps(sample *x)
{
    x->segments = x->count - (x->ends != LOFT_ENDS_CLOSED);
    for (unsigned i = 0; i < x->segments; i++) {
        quad sum = 0;
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const quad d = quad_of(x->p[(i + 1) % x->count].axis[axis]) -
                           quad_of(x->p[i].axis[axis]);
            sum += d * d;
        }
        x->h[i] = x->chord ? quad_sqrt(sum) : 1;
    }
}

static sample arb_spline(arb *a)
{
    const int32_t limit = (int32_t)1 << arb_below(a, 14);
    sample x = { .chord = arb_below(a, 2), .ends = (enum loft_spline_ends)arb_below(a, 4) };

    x.count = (x.ends == LOFT_ENDS_CLOSED ? 3 : 2) + arb_below(a, arb_below(a, 2) ? 4 : 30);
    for (unsigned i = 0; i < x.count; i++) {
        x.p[i] = arb_vec(a, limit);
        if (i > 0 && arb_below(a, 30) == 0)
            x.p[i] = x.p[i - 1];
    }
    x.slope[0] = arb_vec(a, 2);
    x.slope[1] = arb_vec(a, 2);
    set_steps(&x);
    return x;
}

static void start(sample *x)
{
    const enum loft_spacing spacing = x->chord ? LOFT_CHORD : LOFT_UNIFORM;

    x->status = x->ends == LOFT_ENDS_CLAMPED
                    ? loft_spline_clamped_init(&x->s, x->p, x->count, x->slope, spacing, x->memory)
                    : loft_spline_init(&x->s, x->p, x->count, x->ends, spacing, x->memory);
    x->scale = 1;
    for (unsigned i = 0; i < x->count && x->status == LOFT_OK; i++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            x->scale = fmaxl(x->scale, fabsl((long double)quad_sci(x->memory[i].slope[axis])));
    for (unsigned i = 0; i < x->segments && x->status == LOFT_OK; i++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            x->scale = fmaxl(x->scale, fabsl(exact_of(x->p[(i + 1) % x->count].axis[axis]) -
                                             exact_of(x->p[i].axis[axis])) /
                                           (long double)x->h[i]);
}

static bool coincides(const sample *x)
{
    for (unsigned i = 0; i < x->segments; i++)
        if (!(x->h[i] > 0))
            return true;
    return false;
}

/* The k-th derivative of segment i at x, from the points and the library's slopes. */
static quad rebuilt(const sample *x, unsigned i, unsigned k, quad t, int axis)
{
    const unsigned to = (i + 1) % x->count;
    const quad p = quad_of(x->p[i].axis[axis]), h = x->h[i], d = quad_of(x->p[to].axis[axis]) - p;
    const quad m = h * quad_sci(x->memory[i].slope[axis]),
               n = h * quad_sci(x->memory[to].slope[axis]);
    const quad c2 = 3 * d - 2 * m - n, c3 = m + n - 2 * d;

    return k == 0   ? p + t * (m + t * (c2 + t * c3))
           : k == 1 ? (m + t * (2 * c2 + 3 * t * c3)) / h
           : k == 2 ? (2 * c2 + 6 * t * c3) / (h * h)
                    : 6 * c3 / (h * h * h);
}

/* |got - want| of second derivatives, times the smaller step: a residual of the system. */
static void check_equal(const sample *x, unsigned before, unsigned after, unsigned k, int axis)
{
    const quad one = rebuilt(x, before, k, 1, axis), two = rebuilt(x, after, k, 0, axis);
    const long double a = (long double)x->h[before], b = (long double)x->h[after],
                      step = fminl(a, b);
    const long double room = bound_by_num(0x1p-52L, 0x1p-44L, 0x1p-44L) * x->scale;

    CHECK_EXACT((long double)(one - two) * powl(step, k - 1), 0, room);
}

static void second_derivatives_do_not_jump(arb *a)
{
    sample x = arb_spline(a);

    start(&x);
    if (x.chord && coincides(&x)) {
        CHECK(x.status == LOFT_SINGULAR);
        return;
    }
    CHECK(x.status == LOFT_OK);
    CHECK(loft_spline_segments(&x.s) == x.segments);
    for (int axis = 0; axis < LOFT_AXES && x.status == LOFT_OK; axis++) {
        for (unsigned i = 1; i < x.segments; i++)
            check_equal(&x, i - 1, i, 2, axis);
        if (x.ends == LOFT_ENDS_CLOSED)
            check_equal(&x, x.segments - 1, 0, 2, axis);
    }
}

static void ends_are_as_said(arb *a)
{
    sample x = arb_spline(a);

    start(&x);
    for (int axis = 0; axis < LOFT_AXES && x.status == LOFT_OK; axis++) {
        const unsigned last = x.segments - 1;
        const long double h = (long double)x.h[0], hn = (long double)x.h[last];
        const long double room = bound_by_num(0x1p-52L, 0x1p-44L, 0x1p-44L) * x.scale;
        if (x.ends == LOFT_ENDS_NATURAL || (x.ends == LOFT_ENDS_NOT_A_KNOT && x.count == 2)) {
            CHECK_EXACT((long double)rebuilt(&x, 0, 2, 0, axis) * h, 0, room);
            CHECK_EXACT((long double)rebuilt(&x, last, 2, 1, axis) * hn, 0, room);
        } else if (x.ends == LOFT_ENDS_CLAMPED) {
            CHECK(!(quad_sci(x.memory[0].slope[axis]) != quad_of(x.slope[0].axis[axis])));
            CHECK(!(quad_sci(x.memory[x.count - 1].slope[axis]) != quad_of(x.slope[1].axis[axis])));
        } else if (x.ends == LOFT_ENDS_NOT_A_KNOT && x.count == 3) {
            CHECK_EXACT((long double)rebuilt(&x, 0, 3, 0, axis) * h * h, 0, room);
        } else if (x.ends == LOFT_ENDS_NOT_A_KNOT) {
            check_equal(&x, 0, 1, 3, axis);
            check_equal(&x, last - 1, last, 3, axis);
        }
    }
}

static void points_and_derivatives_are_those_of_its_slopes(arb *a)
{
    sample x = arb_spline(a);
    const loft_unit t = arb_unit(a);

    start(&x);
    if (x.status != LOFT_OK)
        return;
    const unsigned i = arb_below(a, x.segments);
    const long double h = (long double)x.h[i];
    const long double by[3] = { h, 1, 1 / h };
    for (unsigned k = 0; k < 3; k++) {
        quad want[LOFT_AXES];
        loft_vec v = { { 0 } };
        for (int axis = 0; axis < LOFT_AXES; axis++)
            want[axis] = rebuilt(&x, i, k, (quad)exact_unit(t), axis);
        const enum loft_status status = k ? loft_spline_deriv(&x.s, i, k, t, &v)
                                          : loft_spline_eval(&x.s, i, t, &v);
        const long double rel = bound_by_num(0x1p-54L, 0x1p-46L, 0x1p-46L) * x.scale * by[k];
        check_result(status, &v, want, 0.5L + 0x1p-17L + rel / LSB,
                     rel + (k ? 0 : bound_by_num(0, ulp(16384) / 2, 16 * ulp(16384))));
    }
    loft_cubic c;
    if (loft_cubic_from_spline(&x.s, i, &c) == LOFT_OK)
        CHECK(loft_vec_equal(c.p[0], x.p[i]) && loft_vec_equal(c.p[3], x.p[(i + 1) % x.count]));
}

static void it_meets_the_points(arb *a)
{
    sample x = arb_spline(a);
    loft_vec v = { { 0 } };

    start(&x);
    for (unsigned i = 0; i < x.segments && x.status == LOFT_OK; i++) {
        CHECK(loft_spline_eval(&x.s, i, 0, &v) == LOFT_OK && loft_vec_equal(v, x.p[i]));
        CHECK(loft_spline_eval(&x.s, i, LOFT_UNIT(1), &v) == LOFT_OK);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            CHECK_EXACT(exact_of(v.axis[axis]), exact_of(x.p[(i + 1) % x.count].axis[axis]),
                        bound_by_num(0, ulp(16384), ulp(16384)));
    }
}

/* Cubics are not-a-knot splines of their own points, at any knots. */
static void not_a_knot_gives_cubics_back(arb *a)
{
    const unsigned count = 4 + arb_below(a, 8);
    loft_real u[12];
    loft_vec p[12];
    loft_spline_knot memory[12];
    loft_spline s;
    int32_t c[LOFT_AXES][4];

    for (int axis = 0; axis < LOFT_AXES; axis++)
        for (int k = 0; k < 4; k++)
            c[axis][k] = (int32_t)arb_below(a, 7) - 3;
    int32_t at = -(int32_t)arb_below(a, 5);
    for (unsigned i = 0; i < count; i++, at += 1 + (int32_t)arb_below(a, 2)) {
        u[i] = loft_real_from_int(at);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            p[i].axis[axis] = loft_real_from_int(
                ((c[axis][3] * at + c[axis][2]) * at + c[axis][1]) * at + c[axis][0]);
    }
    CHECK(loft_spline_knots_init(&s, p, count, 1, u, LOFT_ENDS_NOT_A_KNOT, memory) == LOFT_OK);
    for (unsigned i = 0; i < count; i++)
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const quad x = quad_of(u[i]);
            const quad want = (3 * c[axis][3] * x + 2 * c[axis][2]) * x + c[axis][1];
            CHECK_EXACT((long double)(quad_sci(memory[i].slope[axis]) - want), 0,
                        bound_by_num(0x1p-44L, 0x1p-34L, 0x1p-34L));
        }
}

/* Both readings of hidden points, by the functions that need none. */
static void hidden_points_shape_the_ends(arb *a)
{
    const unsigned count = 4 + arb_below(a, 6);
    loft_vec p[10], slope[2], v[2] = { { { 0 } } };
    loft_spline_knot memory[2][10];
    loft_spline s[2];
    const loft_unit t = arb_unit(a);

    for (unsigned i = 0; i < count; i++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            p[i].axis[axis] = 2 * arb_real(a, 500);         /* halves are exact */
    const unsigned i = arb_below(a, count - 3);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        slope[0].axis[axis] = (p[2].axis[axis] - p[0].axis[axis]) / 2;
        slope[1].axis[axis] = (p[count - 1].axis[axis] - p[count - 3].axis[axis]) / 2;
    }
    for (int way = 0; way < 2; way++) {
        CHECK(loft_spline_hidden_init(&s[0], p, count,
                                      way ? LOFT_HIDDEN_SLOPE : LOFT_HIDDEN_THROUGH,
                                      memory[0]) == LOFT_OK);
        CHECK(
            (way ? loft_spline_clamped_init(&s[1], p + 1, count - 2, slope, LOFT_UNIFORM, memory[1])
                 : loft_spline_init(&s[1], p, count, LOFT_ENDS_NATURAL, LOFT_UNIFORM, memory[1])) ==
            LOFT_OK);
        CHECK(loft_spline_segments(&s[0]) == count - 3);
        CHECK(loft_spline_eval(&s[0], i, t, &v[0]) == LOFT_OK &&
              loft_spline_eval(&s[1], way ? i : i + 1, t, &v[1]) == LOFT_OK);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            CHECK_EXACT(exact_of(v[0].axis[axis]), exact_of(v[1].axis[axis]),
                        bound_by_num(0, 4 * ulp(4000), 64 * ulp(4000)));
    }
}

static void mistakes_are_refused(arb *a)
{
    sample x = arb_spline(a);
    const loft_vec before = arb_vec(a, 100);
    loft_vec v = before;
    const loft_real same[3] = { LOFT_REAL(1), LOFT_REAL(1), LOFT_REAL(2) };

    CHECK(loft_spline_init(&x.s, x.p, 1, LOFT_ENDS_NATURAL, LOFT_UNIFORM, x.memory) ==
          LOFT_ERR_ARG);
    CHECK(loft_spline_init(&x.s, x.p, 2, LOFT_ENDS_CLOSED, LOFT_UNIFORM, x.memory) == LOFT_ERR_ARG);
    CHECK(loft_spline_init(&x.s, x.p, 2, LOFT_ENDS_CLAMPED, LOFT_UNIFORM, x.memory) ==
          LOFT_ERR_ARG);
    CHECK(loft_spline_knots_init(&x.s, x.p, 3, 1, same, LOFT_ENDS_NATURAL, x.memory) ==
          LOFT_ERR_ARG);
    CHECK(loft_spline_hidden_init(&x.s, x.p, 3, LOFT_HIDDEN_SLOPE, x.memory) == LOFT_ERR_ARG);
    x.p[2] = arb_vec(a, 100);
    CHECK(loft_spline_init(&x.s, x.p, 3, LOFT_ENDS_NATURAL, LOFT_UNIFORM, x.memory) == LOFT_OK);
    CHECK(loft_spline_eval(&x.s, 2, 0, &v) == LOFT_ERR_ARG &&
          loft_spline_eval(&x.s, 0, LOFT_UNIT(1.5), &v) == LOFT_ERR_ARG &&
          loft_spline_deriv(&x.s, 0, 3, 0, &v) == LOFT_ERR_ARG);
    CHECK(loft_vec_equal(v, before));
}

int main(void)
{
    PROPERTY(second_derivatives_do_not_jump,                 1000);
    PROPERTY(ends_are_as_said,                               2000);
    PROPERTY(points_and_derivatives_are_those_of_its_slopes, 2000);
    PROPERTY(it_meets_the_points,                            1000);
    PROPERTY(not_a_knot_gives_cubics_back,                   1000);
    PROPERTY(hidden_points_shape_the_ends,                   1000);
    PROPERTY(mistakes_are_refused,                            100);
    return check_failures();
}

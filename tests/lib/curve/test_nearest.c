/* tests/lib/curve/test_nearest.c -- properties of lib/curve/nearest.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/nearest.h"
#include "support/exact.h"          /* exact_eval, exact_deriv, CHECK_EXACT */

#define SAMPLES 1000

typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1], from;
    loft_bezier b;
    unsigned n;
    long double c[LOFT_AXES][LOFT_DEGREE_MAX + 1];      /* relative to `from` */
    long double size, speed;
} scene;

static long double apart(const scene *s, long double t)
{
    long double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double x = exact_eval(s->c[i], s->n, t);
        sum += x * x;
    }
    return sqrtl(sum);
}

static void prepare(scene *s)
{
    long double edge = 0;

    CHECK(loft_bezier_init(&s->b, s->p, s->n) == LOFT_OK);
    s->size = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k <= s->n; k++) {
            s->c[i][k] = exact_of(s->p[k].axis[i]) - exact_of(s->from.axis[i]);
            s->size = fmaxl(s->size, fabsl(s->c[i][k]));
            if (k)
                edge = fmaxl(edge, fabsl(s->c[i][k] - s->c[i][k-1]));
        }
    s->speed = s->n * edge * sqrtl(LOFT_AXES);
}

/* Large and small curves, points near them, on their control points and far away. */
static void arb_scene(arb *a, scene *s)
{
    const int32_t limits[3] = { 2, 200, 32767 }, limit = limits[arb_below(a, 3)];

    s->n = arb_below(a, LOFT_DEGREE_MAX + 1);
    for (unsigned k = 0; k <= s->n; k++)
        s->p[k] = arb_vec(a, limit);
    if (s->n && arb_below(a, 4) == 0)
        s->p[s->n] = s->p[arb_below(a, s->n)];
    s->from = arb_below(a, 5) ? arb_vec(a, arb_below(a, 3) ? limit : 32767)
                              : s->p[arb_below(a, s->n + 1)];
    prepare(s);
}

/* The smallest distance: of samples, and by thirds between the neighbours of each local minimum of
 * them. */
static long double least(const scene *s)
{
    static long double d[SAMPLES + 1];
    long double best = INFINITY;

    for (unsigned k = 0; k <= SAMPLES; k++)
        d[k] = apart(s, (long double)k / SAMPLES);
    for (unsigned k = 0; k <= SAMPLES; k++) {
        if ((k > 0 && d[k-1] < d[k]) || (k < SAMPLES && d[k+1] < d[k]))
            continue;
        long double low = k ? (k - 1.0L) / SAMPLES : 0,
                    high = k < SAMPLES ? (k + 1.0L) / SAMPLES : 1;
        for (int round = 0; round < 70; round++) {
            const long double third = (high - low) / 3;
            if (apart(s, low + third) < apart(s, high - third))
                high -= third;
            else
                low += third;
        }
        best = fminl(best, fminl(d[k], apart(s, low)));
    }
    return best;
}

static loft_real arb_tol(arb *a)
{
    const int32_t raw[4] = { 1, 7, 655, 65536 };
    return loft_real_from_raw(raw[arb_below(a, 4)]);
}

static void check_answer(const scene *s, const loft_nearest *found, long double tol)
{
    const long double want = least(s), slack = BY_NUM(want * 0x1p-25L + 0x1p-29L,
                                                      s->size * 0x1p-42L, s->size * 0x1p-42L);
    const long double got = exact_acc(found->distance), t = exact_unit(found->t);
    long double off = 0, measured = 0;

    CHECK(got <= want + tol + slack);
    CHECK(got >= want - slack - s->size * 0x1p-58L);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double x = exact_of(found->point.axis[i]) - exact_of(s->from.axis[i]);
        off += powl(x - exact_eval(s->c[i], s->n, t), 2);
        measured += x * x;
    }
    const long double rounding =
        sqrtl(LOFT_AXES) * (ulp(s->size + 32768) * BY_NUM(0.501L, 0.501L, 4)) + slack;
    CHECK(t >= 0 && t <= 1);
    CHECK_EXACT(sqrtl(measured), got, rounding);
    CHECK(sqrtl(off) <= rounding + s->speed * BY_NUM(0x1.01p-25L, 0x1.01p-25L, 0x1p-50L));
}

static void no_point_of_the_curve_is_nearer(arb *a)
{
    const loft_real tol = arb_tol(a);
    loft_nearest found;
    scene s;

    arb_scene(a, &s);
    CHECK(loft_bezier_nearest(&s.b, s.from, tol, &found) == LOFT_OK);
    check_answer(&s, &found, exact_of(tol));
}

/* A point of the curve is its own nearest one. */
static void a_point_of_the_curve_is_found(arb *a)
{
    const loft_real tol = loft_real_from_raw(2);
    loft_nearest found;
    scene s;

    arb_scene(a, &s);
    s.from = loft_bezier_eval(&s.b, arb_unit(a));
    prepare(&s);
    CHECK(loft_bezier_nearest(&s.b, s.from, tol, &found) == LOFT_OK);
    check_answer(&s, &found, exact_of(tol));
    CHECK(exact_acc(found.distance) <= exact_of(tol) + sqrtl(LOFT_AXES) * ulp(32767));
}

/* From the centre of an arc all points are about equally near. */
static void the_centre_of_an_arc_does_not_take_forever(arb *a)
{
    const double radius = 1 + arb_below(a, 3000), inner = 0.5522847498307936 * radius;
    const double x[4] = { radius, radius, inner, 0 };
    loft_nearest found;
    scene s = { .n = 3 };

    for (int k = 0; k < 4; k++) {
        s.p[k].axis[0] = loft_real_from_raw((int32_t)(65536 * x[k]));
        s.p[k].axis[LOFT_AXES - 1] = loft_real_from_raw((int32_t)(65536 * x[3 - k]));
    }
    prepare(&s);
    CHECK(loft_bezier_nearest(&s.b, s.from, loft_real_from_raw(16), &found) == LOFT_OK);
    check_answer(&s, &found, 16 * LSB);
}

static void refuses_what_is_no_question(arb *a)
{
    loft_nearest found = { 0 };
    scene s;

    arb_scene(a, &s);
    CHECK(loft_bezier_nearest(&s.b, s.from, 0, &found) == LOFT_ERR_ARG);
    CHECK(loft_bezier_nearest(&s.b, s.from, -loft_real_from_raw(1), &found) == LOFT_ERR_ARG);
#if LOFT_NUM != LOFT_Q16
    s.from.axis[0] = (loft_real)NAN;
    CHECK(loft_bezier_nearest(&s.b, s.from, 1, &found) == LOFT_ERR_RANGE);
#endif
    CHECK(found.distance <= 0 && found.t <= 0);
}

int main(void)
{
    PROPERTY(no_point_of_the_curve_is_nearer,             600);
    PROPERTY(a_point_of_the_curve_is_found,               300);
    PROPERTY(the_centre_of_an_arc_does_not_take_forever,   20);
    PROPERTY(refuses_what_is_no_question,                  20);
    return check_failures();
}

/* tests/lib/curve/test_bounds.c -- properties of lib/curve/bounds.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/bounds.h"
#include "support/exact.h"          /* exact_eval, exact_deriv, CHECK_EXACT */

typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1];
    loft_bezier b;
    unsigned n;
} curve;

/* Any coordinates, or only a few different ones: then extrema are at ends, double, or
 * everywhere. */
static void arb_curve(arb *a, curve *c)
{
    const int32_t limit = arb_below(a, 2) ? 32767 : 1 + (int32_t)arb_below(a, 100);
    const bool coarse = arb_below(a, 3) == 0;

    c->n = arb_below(a, LOFT_DEGREE_MAX + 1);
    for (unsigned k = 0; k <= c->n; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            c->p[k].axis[i] = coarse ? (loft_real)((int32_t)arb_below(a, 3) * BY_NUM(65536, 1, 1))
                                     : arb_real(a, limit);
    CHECK(loft_bezier_init(&c->b, c->p, c->n) == LOFT_OK);
}

/* The largest value of sign * polynomial: samples, and between their neighbours by thirds. */
static long double largest(const long double c[], unsigned n, long double sign)
{
    const unsigned samples = 200;
    long double best = sign * c[0], value[201];

    for (unsigned k = 0; k <= samples; k++)
        value[k] = sign * exact_eval(c, n, (long double)k / samples);
    for (unsigned k = 0; k <= samples; k++) {
        if ((k > 0 && value[k-1] > value[k]) || (k < samples && value[k+1] > value[k]))
            continue;
        long double low = k ? (k - 1.0L) / samples : 0,
                    high = k < samples ? (k + 1.0L) / samples : 1;
        for (int round = 0; round < 60; round++) {
            const long double third = (high - low) / 3;
            if (sign * exact_eval(c, n, low + third) > sign * exact_eval(c, n, high - third))
                high -= third;
            else
                low += third;
        }
        best = fmaxl(best, fmaxl(value[k], sign * exact_eval(c, n, low)));
    }
    return best;
}

static long double size_of(const long double c[], unsigned n)
{
    long double size = 0;
    for (unsigned k = 0; k <= n; k++)
        size = fmaxl(size, fabsl(c[k]));
    return size;
}

/* side >= want, up to the accuracy of the reference, and not far beyond */
static void check_side(long double side, long double want, long double size)
{
    const long double digits = size * 0x1p-58L;
    const long double most = BY_NUM(ceill(want * 65536 - 0x1p-20L) / 65536 + LSB,
                                    want + 3 * ulp(want) + size * 0x1p-42L, want + size * 0x1p-42L);

    CHECK(side >= want - digits);
    CHECK(side <= most + digits);
}

static void holds_the_curve_tightly(arb *a)
{
    curve c;

    arb_curve(a, &c);
    const loft_box box = loft_bezier_bounds(&c.b), hull = loft_bezier_box(&c.b);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double x[LOFT_DEGREE_MAX + 1];
        for (unsigned k = 0; k <= c.n; k++)
            x[k] = exact_of(c.p[k].axis[i]);
        check_side(exact_of(box.max.axis[i]), largest(x, c.n, 1), size_of(x, c.n));
        check_side(-exact_of(box.min.axis[i]), largest(x, c.n, -1), size_of(x, c.n));
        CHECK(box.max.axis[i] <= hull.max.axis[i] && box.min.axis[i] >= hull.min.axis[i]);
    }
}

/* Points that the library rounds are inside too. */
static void holds_every_point(arb *a)
{
    curve c;

    arb_curve(a, &c);
    const loft_box box = loft_bezier_bounds(&c.b);
    for (int k = 0; k < 100; k++) {
        const loft_vec p = loft_bezier_eval(&c.b, arb_unit(a));
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(p.axis[i] >= box.min.axis[i] - BY_NUM(0, 0, 1e-11) &&
                  p.axis[i] <= box.max.axis[i] + BY_NUM(0, 0, 1e-11));
    }
}

/* Without inner extrema, the box is exactly that of the two ends. */
static void a_monotone_curve_has_its_ends(arb *a)
{
    curve c;

    arb_curve(a, &c);
    for (unsigned k = 1; k <= c.n; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (c.p[k].axis[i] < c.p[k-1].axis[i])
                c.p[k].axis[i] = c.p[k-1].axis[i];
    const loft_box box = loft_bezier_bounds(&c.b);
    CHECK(loft_vec_equal(box.min, c.p[0]) && loft_vec_equal(box.max, c.p[c.n]));
}

int main(void)
{
    PROPERTY(holds_the_curve_tightly,       2000);
    PROPERTY(holds_every_point,              500);
    PROPERTY(a_monotone_curve_has_its_ends,  500);
    return check_failures();
}

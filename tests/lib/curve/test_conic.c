/* tests/lib/curve/test_conic.c -- properties of lib/curve/conic.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* quad_of, bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "curve/conic.h"

#if LOFT_AXES < 2
#  error "conics need a plane"
#endif

static loft_real whole(int32_t i) { return loft_real_from_int(i); }

static loft_weighted at(int32_t x, int32_t y, loft_real w)
{
    loft_weighted p = { { { 0 } }, w };
    p.p.axis[0] = whole(x);
    p.p.axis[1] = whole(y);
    return p;
}

static int32_t arb_small(arb *a, int32_t limit)
{
    return (int32_t)arb_below(a, 2 * (uint32_t)limit + 1) - limit;
}

/* Whole weights -4..4 and points -3..3: all that is special happens often. */
static void kinds_are_those_of_integers(arb *a)
{
    loft_weighted p[3];
    int32_t x[3], y[3], w[3];
    loft_conic c = { LOFT_CONIC_NULL, false, false };

    for (int k = 0; k < 3; k++) {
        x[k] = arb_small(a, 3);
        y[k] = arb_small(a, 3);
        w[k] = arb_small(a, 4);
        p[k] = at(x[k], y[k], whole(w[k]));
    }
    CHECK(loft_conic_init(&c, p) == LOFT_OK);
    const int32_t det = w[0] * w[1] * w[2] *
                        ((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]));
    const int32_t disc = w[1] * w[1] - w[0] * w[2];
    bool any = false, apart = false;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++) {
            any = any || w[j];
            apart = apart || (w[j] && w[k] && (x[j] != x[k] || y[j] != y[k]));
        }
    const enum loft_conic_kind want = det     ? disc < 0    ? LOFT_CONIC_ELLIPSE
                                                : disc == 0 ? LOFT_CONIC_PARABOLA
                                                            : LOFT_CONIC_HYPERBOLA
                                      : apart ? LOFT_CONIC_LINE
                                      : any   ? LOFT_CONIC_POINT
                                              : LOFT_CONIC_NULL;
    CHECK(c.kind == want);
    bool zero = false;                      /* of the denominator, at its ends or at its vertex */
    zero = w[0] == 0 || w[2] == 0 || (w[0] > 0) != (w[2] > 0);
    const int32_t lead = w[0] - 2 * w[1] + w[2], half = w[0] - w[1];
    if (!zero && lead && half * (lead > 0 ? 1 : -1) > 0 &&
        half * (lead > 0 ? 1 : -1) < (lead > 0 ? lead : -lead))
        zero = (w[0] > 0) == (lead > 0) ? disc >= 0 : false;
    CHECK(c.finite == !zero);
}

/* Five points of the curve are on a circle exactly if it says so; here, those it must know. */
static void quarters_with_exact_weights_are_circles(arb *a)
{
    /* the angle 60 degrees has the middle weight 1/2, and sqrt 3 in its points; a right angle at
 * the
     * ends of a 3 4 5 triangle has rational points: p0 = (5, 0), p2 = (-3, 4) turned, p1 between */
    const int32_t s = 1 + (int32_t)arb_below(a, 50), dx = arb_small(a, 500), dy = arb_small(a, 500);
    /* the circle x^2 + y^2 = 25 from (5, 0) to (-3, 4): tangents meet at (5, 10); cosine of half
 * the
     * angle: cos = -3/5, half: sqrt(1/5): weights 5, sqrt 5 .. are not rational; (3, 4): half has
     * cos^2 = 4/5: not rational; (7, 24)/25: cos = 7/25, half 4/5: rational */
    loft_weighted p[3] = { at(dx + 100 * s, dy, whole(5)), at(dx + 100 * s, dy + 75 * s, whole(4)),
                           at(dx + 28 * s, dy + 96 * s, whole(5)) };
    loft_conic c = { LOFT_CONIC_NULL, false, false };
    loft_vec centre = { { 0 } };
    loft_real axes[2] = { 0, 0 };

    CHECK(loft_conic_init(&c, p) == LOFT_OK && c.kind == LOFT_CONIC_ELLIPSE && c.circle &&
          c.finite);
    CHECK(loft_conic_axes(p, &centre, axes) == LOFT_OK);
    CHECK_EXACT(exact_of(centre.axis[0]), dx, bound_by_num(LSB, 2 * ulp(6000), 1e-10L));
    CHECK_EXACT(exact_of(axes[0]), 100 * s, bound_by_num(LSB, 2 * ulp(6000), 1e-10L));
    CHECK_EXACT(exact_of(axes[1]), 100 * s, bound_by_num(LSB, 2 * ulp(6000), 1e-10L));
    p[1].w = loft_real_from_raw(4 * 65536 + 1);
    CHECK(loft_conic_init(&c, p) == LOFT_OK && c.kind == LOFT_CONIC_ELLIPSE && !c.circle);
    p[1].w = whole(-4);                     /* the other part of the circle */
    CHECK(loft_conic_init(&c, p) == LOFT_OK && c.circle && c.finite);
}

/* A point of the curve at t, by quad: it satisfies x^2 / a^2 +- y^2 / b^2 = 1 along its axes, which
 * the two axes alone cannot tell; what they can: the sum and the product of the form's eigenvalues.
 */
static void axes_are_those_of_the_curve(arb *a)
{
    loft_weighted p[3];
    loft_conic c;
    loft_vec centre = { { 0 } };
    loft_real axes[2] = { 0, 0 };
    quad v[6][2], m[5][5], q[5];

    for (int k = 0; k < 3; k++)
        p[k] = at(arb_small(a, 40), arb_small(a, 40), whole(1 + (int32_t)arb_below(a, 4)));
    CHECK(loft_conic_init(&c, p) == LOFT_OK);
    const enum loft_status status = loft_conic_axes(p, &centre, axes);
    if (c.kind != LOFT_CONIC_ELLIPSE && c.kind != LOFT_CONIC_HYPERBOLA) {
        CHECK(status == LOFT_SINGULAR);
        return;
    }
    if (status != LOFT_OK || exact_of(axes[0]) > 1000 || exact_of(axes[1]) > 1000 ||
        exact_of(axes[1]) < 0.1L || exact_of(axes[0]) < 0.1L)
        return;
    for (int k = 0; k < 5; k++) {           /* five points: A x^2 + B x y + C y^2 + D x + E y = 1 */
        const quad t = (quad)k / 4, b[3] = { (1 - t) * (1 - t), 2 * t * (1 - t), t * t };
        quad w = 0, x[2] = { 0, 0 };
        for (int j = 0; j < 3; j++) {
            w += b[j] * quad_of(p[j].w);
            for (int i = 0; i < 2; i++)
                x[i] += b[j] * quad_of(p[j].w) * quad_of(p[j].p.axis[i]);
        }
        for (int i = 0; i < 2; i++)
            v[k][i] = x[i] / w - quad_of(centre.axis[i]);
    }
    for (int k = 0; k < 5; k++) {
        m[k][0] = v[k][0] * v[k][0];
        m[k][1] = v[k][0] * v[k][1];
        m[k][2] = v[k][1] * v[k][1];
        m[k][3] = v[k][0];
        m[k][4] = v[k][1];
        q[k] = 1;
    }
    for (int k = 0; k < 5; k++) {
        int pivot = k;
        for (int i = k; i < 5; i++)
            if (fabsl((long double)m[i][k]) > fabsl((long double)m[pivot][k]))
                pivot = i;
        for (int j = 0; j < 5; j++) {
            const quad swap = m[k][j];
            m[k][j] = m[pivot][j];
            m[pivot][j] = swap;
        }
        const quad swap = q[k];
        q[k] = q[pivot];
        q[pivot] = swap;
        for (int i = 0; i < 5; i++) {
            if (i == k)
                continue;
            const quad f = m[i][k] / m[k][k];
            for (int j = k; j < 5; j++)
                m[i][j] -= f * m[k][j];
            q[i] -= f * q[k];
        }
    }
    for (int k = 0; k < 5; k++)
        q[k] /= m[k][k];
    const long double one = 1 / powl(exact_of(axes[0]), 2), two = 1 / powl(exact_of(axes[1]), 2);
    const long double sign = c.kind == LOFT_CONIC_ELLIPSE ? 1 : -1;
    CHECK_EXACT((long double)(q[0] + q[2]), one + sign * two, 1e-3L * (one + two));
    CHECK_EXACT((long double)(q[0] * q[2] - q[1] * q[1] / 4), sign * one * two, 2e-3L * one * two);
    CHECK(sign < 0 || exact_of(axes[0]) >= exact_of(axes[1]));
}

/* A raised conic is one, and gives its points back; one LSB aside (8 in f32) it is none. */
/* Weights whose w0 w2 and w1^2 agree in up to 62 bits: the centre is as near as s allows, and the
 * area of the axes is f g (U x V)^2 of curve/conic.c. */
static void centres_near_a_parabola_are_near(arb *a)
{
    const int32_t size = 1 << arb_below(a, 24);
    const int32_t u = 1 + (int32_t)arb_below(a, 180), v = 1 + (int32_t)arb_below(a, 180),
                  f = 1 + (int32_t)arb_below(a, 60000);
    const int32_t raw[3] = { u * u * f + arb_small(a, 1), u * v * f + arb_small(a, 1), v * v * f };
    loft_weighted p[3];
    loft_vec centre = { { 0 } };
    loft_real axes[2] = { 0, 0 };
    quad x[3][2], w[3];

    for (int k = 0; k < 3; k++) {
        p[k].p = (loft_vec) { { 0 } };
        for (int i = 0; i < 2; i++) {
            p[k].p.axis[i] = loft_real_from_raw(arb_small(a, size));
            x[k][i] = quad_of(p[k].p.axis[i]);
        }
        p[k].w = loft_real_from_raw(raw[k]);
        w[k] = quad_of(p[k].w);
    }
    const quad outer = w[0] * w[2], d = outer - w[1] * w[1], s = d ? outer / (2 * d) : 0;
    const quad cross = (x[2][0] - x[0][0]) * (x[0][1] - x[1][1]) -
                       (x[2][1] - x[0][1]) * (x[0][0] - x[1][0]);
    const enum loft_status status = loft_conic_axes(p, &centre, axes);
    if (!d || !cross) {
        CHECK(status == LOFT_SINGULAR);
        return;
    }
    if (status != LOFT_OK) {
        CHECK(BY_NUM(true, false, false) && status == LOFT_ERR_RANGE);
        return;
    }
    const long double steep = 2 * fabsl((long double)s), far = steep * size / 65536,
                      e = bound_by_num(0x1p-52L, 0x1p-44L, 0x1p-44L);
    for (int i = 0; i < 2; i++) {
        const quad want = x[1][i] + s * (x[0][i] + x[2][i] - 2 * x[1][i]);
        CHECK_EXACT((long double)(quad_of(centre.axis[i]) - want), 0,
                    bound_by_num(LSB / 2 + 0x1p-33L, ulp((long double)want), 0) + e * far);
    }
    const long double area = (long double)(outer * w[1] * w[1] / (d * d) * s / 2 * cross * cross),
                      got = exact_of(axes[0]) * exact_of(axes[1]),
                      half = bound_by_num(LSB / 2 + 0x1p-33L, 0, 0) *
                             (exact_of(axes[0]) + exact_of(axes[1]) + LSB);
    CHECK_EXACT(got, sqrtl(fabsl(area)), got * bound_by_num(1e-15L, 1e-6L, 1e-13L) + half);
}

static void raised_conics_are_recognized(arb *a)
{
    loft_weighted p[3], q[4], out[3];
    int32_t w[3], h[3];

    for (int k = 0; k < 3; k++) {           /* whole after raising: multiples of 6 */
        w[k] = 1 + (int32_t)arb_below(a, 3);
        p[k] = at(12 * arb_small(a, 50), 12 * arb_small(a, 50), whole(3 * w[k]));
    }
    q[0] = p[0];
    q[3] = p[2];
    for (int k = 1; k < 3; k++) {           /* h_k = (k h_(k-1) + (3 - k) h_k) / 3 */
        const int32_t by[2] = { k, 3 - k };
        h[0] = by[0] * w[k - 1] + by[1] * w[k];
        q[k].w = whole(h[0]);
        for (int i = 0; i < LOFT_AXES; i++) {
            const int64_t sum = (int64_t)by[0] * w[k - 1] * loft_raw_from_real(p[k - 1].p.axis[i]) +
                                (int64_t)by[1] * w[k] * loft_raw_from_real(p[k].p.axis[i]);
            if (sum % h[0])
                return;
            q[k].p.axis[i] = loft_real_from_raw((int32_t)(sum / h[0]));
        }
    }
    CHECK(loft_conic_from_cubic(q, out) == LOFT_OK);
    for (int k = 0; k < 3; k++) {
        CHECK_EXACT(exact_of(out[k].w), 3 * w[k], bound_by_num(0, 1e-6L, 1e-14L));
        for (int i = 0; i < 2; i++)
            CHECK_EXACT(exact_of(out[k].p.axis[i]), exact_of(p[k].p.axis[i]),
                        bound_by_num(0, ulp(600), 1e-11L));
    }
    q[1].p.axis[0] = loft_real_from_raw(loft_raw_from_real(q[1].p.axis[0]) + BY_NUM(1, 8, 1));
    CHECK(loft_conic_from_cubic(q, out) == LOFT_SINGULAR);
}

/* Half an ellipse with the weights 3 w, w, w, 3 w: its middle is at infinity. The half has the
 * centre and the axes. */
static void half_ellipses_have_a_half(arb *a)
{
    const loft_real w = whole(1 + (int32_t)arb_below(a, 3));
    const int32_t r = 4 + 4 * (int32_t)arb_below(a, 20), high = 4 + 4 * (int32_t)arb_below(a, 20),
                  x = arb_small(a, 50), y = arb_small(a, 50);
    loft_weighted q[4] = { at(x - r, y, 3 * w), at(x - r, y + 2 * high, w),
                           at(x + r, y + 2 * high, w), at(x + r, y, 3 * w) },
                  out[3];
    loft_real axes[2];
    loft_vec centre;
    loft_conic c;

    CHECK(loft_conic_from_cubic(q, out) == LOFT_SINGULAR);
    CHECK(loft_conic_from_half_cubic(q, out) == LOFT_OK);
    CHECK(loft_conic_init(&c, out) == LOFT_OK && c.kind == LOFT_CONIC_ELLIPSE && c.finite);
    CHECK(c.circle == (r == high));
    CHECK_EXACT(exact_of(out[1].p.axis[0]), x - r, 1e-4L);
    CHECK_EXACT(exact_of(out[1].p.axis[1]), y + high, 1e-4L);
    CHECK_EXACT(exact_of(out[2].p.axis[0]), x, 1e-4L);
    CHECK_EXACT(exact_of(out[2].p.axis[1]), y + high, 1e-4L);
    CHECK(loft_conic_axes(out, &centre, axes) == LOFT_OK);
    CHECK_EXACT(exact_of(centre.axis[0]), x, 1e-3L);
    CHECK_EXACT(exact_of(centre.axis[1]), y, 1e-3L);
    CHECK_EXACT(exact_of(axes[0]), r > high ? r : high, 1e-3L);
    CHECK_EXACT(exact_of(axes[1]), r > high ? high : r, 1e-3L);
    q[1].p.axis[0] = loft_real_from_raw(loft_raw_from_real(q[1].p.axis[0]) + BY_NUM(1, 8, 1));
    CHECK(loft_conic_from_half_cubic(q, out) == LOFT_SINGULAR);
}

/* x = a c(t), y = b s(t) with (c, s) = (1 - t^2, 2 t) / (1 + t^2), turned by 3-4-5: foci at +-
 * sqrt(a^2 - b^2) along the longer axis; y = x^2 / 4 f has its focus at f. */
static void foci_are_where_they_are_known(arb *a)
{
#if LOFT_AXES > 1
    const int32_t m = 5 * (1 + (int32_t)arb_below(a, 60)), n = 5 * (1 + (int32_t)arb_below(a, 60));
    const bool parabola = arb_below(a, 3) == 0;
    /* points of the curve with the weights 1, 1, 2, or 1, 1, 1 */
    const int32_t x[3] = { parabola ? -2 * m : m, parabola ? 0 : m, parabola ? 2 * m : 0 },
                  y[3] = { parabola ? m : 0, parabola ? -m : n, parabola ? m : n };
    const long double c = parabola ? 0 : sqrtl(fabsl((long double)m * m - (long double)n * n)),
                      at[2] = { m >= n ? c : 0, parabola ? m
                                                : m >= n ? 0
                                                         : c };
    loft_weighted p[3];
    loft_vec focus[2];
    unsigned count = 0;

    for (int k = 0; k < 3; k++) {
        p[k].p = (loft_vec){ { 0 } };
        p[k].p.axis[0] = loft_real_from_int((3 * x[k] - 4 * y[k]) / 5);
        p[k].p.axis[1] = loft_real_from_int((4 * x[k] + 3 * y[k]) / 5);
        p[k].w = loft_real_from_int(parabola || k < 2 ? 1 : 2);
    }
    CHECK(loft_conic_foci(p, focus, &count) == LOFT_OK && count == (parabola ? 1u : 2u));
    const long double want[2] = { (3 * at[0] - 4 * at[1]) / 5, (4 * at[0] + 3 * at[1]) / 5 };
    const long double sign =
        want[0] * exact_of(focus[0].axis[0]) + want[1] * exact_of(focus[0].axis[1]) < 0 ? -1 : 1;
    for (unsigned k = 0; k < count; k++)
        for (int axis = 0; axis < 2; axis++)
            CHECK_EXACT(exact_of(focus[k].axis[axis]), (k ? -sign : sign) * want[axis],
                        bound_by_num(LSB / 2 + 0x1p-20L, 2 * ulp(300), 0x1p-13L));
#else
    (void)a;
#endif
}

static void lines_have_no_foci(arb *a)
{
    loft_weighted p[3] = { { { { 0 } }, LOFT_REAL(1) },
                           { { { 0 } }, LOFT_REAL(1) },
                           { { { 0 } }, LOFT_REAL(1) } };
    loft_vec focus[2];
    unsigned count = 7;

    if (LOFT_AXES < 2)
        return;
    p[1].p.axis[0] = loft_real_from_int(1 + (int32_t)arb_below(a, 100));
    p[2].p.axis[0] = loft_real_from_int(-1 - (int32_t)arb_below(a, 100));
    CHECK(loft_conic_foci(p, focus, &count) == LOFT_SINGULAR && count == 7);
}

int main(void)
{
    PROPERTY(kinds_are_those_of_integers,             3000);
    PROPERTY(quarters_with_exact_weights_are_circles,  300);
    PROPERTY(foci_are_where_they_are_known,            500);
    PROPERTY(lines_have_no_foci,                        20);
    PROPERTY(axes_are_those_of_the_curve,              500);
    PROPERTY(centres_near_a_parabola_are_near,        2000);
    PROPERTY(raised_conics_are_recognized,             500);
    PROPERTY(half_ellipses_have_a_half,                300);
    return check_failures();
}

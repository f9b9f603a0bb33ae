/* tests/lib/curve/test_shape.c -- kinds of cubics, curvature and convex polygons against exact
 * answers
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_shape.h"        /* exact_shape_of, exact_bend_at, exact_convexity */

static loft_real raw(int64_t i)
{
    return loft_real_from_raw((int32_t)(i < INT32_MIN ? INT32_MIN : i > INT32_MAX ? INT32_MAX : i));
}
static loft_vec  at(int64_t x, int64_t y)
{
    loft_vec v = { { 0 } };
    v.axis[0] = raw(x);
    v.axis[1] = raw(y);
    return v;
}

/* One LSB up or down; in floats 2^-16, if they are fine enough. */
static void nudge(arb *a, loft_real *x)
{
    *x = raw((int64_t)loft_raw_from_real(*x) + (arb_below(a, 2) ? 1 : -1));
}

/* A raw coordinate of some size: a few LSB, thousands, or the full range. */
static int64_t some(arb *a, unsigned size)
{
    const int32_t limit[4] = { 3, 4000, 40000000, INT32_MAX };
    return arb_raw(a, limit[size % 4]);
}

static loft_vec some_point(arb *a, unsigned size)   { return at(some(a, size), some(a, size)); }

/* P' = (n t - m) times a linear vector: a cusp at m / n. */
static loft_cubic with_cusp(arb *a, unsigned size)
{
    const int64_t n = 1 + arb_below(a, 8),
                  m = arb_below(a, (uint32_t)n + 2) - (int64_t)arb_below(a, 2);
    int64_t p[2][4];
    loft_cubic c;

    for (int i = 0; i < 2; i++) {
        const int64_t e = some(a, size % 2), f = some(a, size % 2), c1 = -m * e, c2 = n * e - m * f,
                      c3 = n * f;
        p[i][0] = some(a, size);
        p[i][1] = p[i][0] + 2 * c1;
        p[i][2] = p[i][0] + 4 * c1 + c2;
        p[i][3] = p[i][0] + 6 * c1 + 3 * c2 + 2 * c3;
    }
    for (int k = 0; k < 4; k++)
        c.p[k] = at(p[0][k], p[1][k]);
    return c;
}

static loft_cubic with_line(arb *a)
{
    const int64_t dx = some(a, 1), dy = some(a, 1);
    loft_cubic c;

    for (int k = 0; k < 4; k++) {
        const int64_t along = some(a, 1);
        c.p[k] = at(5 + along * dx, along * dy - 7);
    }
    return c;
}

static loft_cubic with_parabola(arb *a)
{
    loft_cubic c;
    int64_t x[3], y[3];

    for (int k = 0; k < 3; k++) {
        x[k] = 3 * some(a, 2);
        y[k] = 3 * some(a, 2);
    }
    c.p[0] = at(x[0], y[0]);
    c.p[1] = at((x[0] + 2 * x[1]) / 3, (y[0] + 2 * y[1]) / 3);
    c.p[2] = at((x[2] + 2 * x[1]) / 3, (y[2] + 2 * y[1]) / 3);
    c.p[3] = at(x[2], y[2]);
    return c;
}

/* An arbitrary cubic: of all kinds, with coincident points, on a line, and one LSB off these. */
static loft_cubic some_cubic(arb *a)
{
    const unsigned size = arb_below(a, 4), kind = arb_below(a, 8);
    loft_cubic c;

    for (int k = 0; k < 4; k++)
        c.p[k] = some_point(a, size);
    if (kind == 0)
        c = with_cusp(a, size);
    if (kind == 1)
        c = with_line(a);
    if (kind == 2)
        c = with_parabola(a);
    if (kind == 3)
        c.p[arb_below(a, 4)] = c.p[arb_below(a, 4)];
    if (kind == 4)
        c.p[2] = c.p[1 + arb_below(a, 2)] = at(some(a, size), 0);
    if (kind == 5) {                                /* as a graph y = x^3 + a x */
        const int64_t h = some(a, 2), y = some(a, 2);
        for (int k = 0; k < 4; k++)
            c.p[k] = at(k * h, k == 1 ? y : k == 2 ? -y : 0);
    }
    for (unsigned k = arb_below(a, 4); kind == 6 && k < 4; k++)
        c.p[k] = c.p[0];
    if (arb_below(a, 3) == 0)
        nudge(a, &c.p[arb_below(a, 4)].axis[arb_below(a, 2)]);
    return c;
}

static loft_shape shape_of(const loft_cubic *c)
{
    loft_shape s = { LOFT_POINT, 9, 9, 9, { 0, 0 }, 0, { 0, 0 } };
    CHECK(loft_cubic_shape(c, &s) == LOFT_OK);
    return s;
}

static void near_unit(loft_unit got, long double want)
{
    CHECK_EXACT(exact_unit(got), want,
                BY_NUM(0x1p-25L + 0x1p-33L, ulp(want) + 0x1p-65L, ulp(want) + 0x1p-58L));
}

static void kinds_and_parameters_are_exact(arb *a)
{
    const loft_cubic c = some_cubic(a);
    const exact_shape want = exact_shape_of(&c);
    const loft_shape got = shape_of(&c);

    CHECK(got.kind == want.kind && got.inflections == want.inflections && got.cusps == want.cusps &&
          got.loops == want.loops);
    for (unsigned k = 0; k < want.inflections; k++)
        near_unit(got.inflection[k], want.inflection[k]);
    if (want.cusps)
        near_unit(got.cusp, want.cusp);
    for (unsigned k = 0; k < 2 * want.loops; k++)
        near_unit(got.loop[k], want.loop[k]);
}

/* All kinds occur, otherwise the property above means little. */
static void all_kinds_are_tried(arb *a)
{
    unsigned seen[LOFT_CUSP_AT_INFINITY + 1] = { 0 }, loops = 0, pairs = 0, cusps = 0;

    for (int k = 0; k < 4000; k++) {
        const loft_cubic c = some_cubic(a);
        const exact_shape s = exact_shape_of(&c);
        seen[s.kind]++;
        loops += s.loops;
        cusps += s.cusps;
        pairs += s.inflections == 2;
    }
    for (unsigned k = 0; k <= LOFT_CUSP_AT_INFINITY; k++)
        CHECK(seen[k] > 3);
    CHECK(loops > 20 && cusps > 20 && pairs > 20);
}

static void reversal_mirrors_the_parameters(arb *a)
{
    const loft_cubic c = some_cubic(a), back = { { c.p[3], c.p[2], c.p[1], c.p[0] } };
    const loft_shape s = shape_of(&c), r = shape_of(&back);
    const long double bound = BY_NUM(0x1p-23L, 0x1p-22L, 0x1p-51L);

    CHECK(s.kind == r.kind && s.inflections == r.inflections && s.cusps == r.cusps &&
          s.loops == r.loops);
    for (unsigned k = 0; k < s.inflections; k++)
        CHECK_EXACT(exact_unit(s.inflection[k]) + exact_unit(r.inflection[s.inflections - 1 - k]),
                    1, bound);
    if (s.cusps)
        CHECK_EXACT(exact_unit(s.cusp) + exact_unit(r.cusp), 1, bound);
    for (unsigned k = 0; k < 2u * s.loops; k++)
        CHECK_EXACT(exact_unit(s.loop[k]) + exact_unit(r.loop[1 - k]), 1, bound);
}

/* (x, y) -> (y, x + 3 y): another curve, with the same areas and so the same parameters to the last
 * digit. */
static void maps_that_keep_areas_change_nothing(arb *a)
{
    loft_cubic c, d;

    for (int k = 0; k < 4; k++) {
        const int64_t x = arb_raw(a, 1000000), y = arb_raw(a, 1000000);
        c.p[k] = at(x, y);
        d.p[k] = at(y, x + 3 * y);
    }
    const loft_shape s = shape_of(&c), r = shape_of(&d);
    CHECK(s.kind == r.kind && s.inflections == r.inflections && s.cusps == r.cusps &&
          s.loops == r.loops);
    for (unsigned k = 0; k < 2; k++)
        CHECK(!(s.inflection[k] < r.inflection[k]) && !(s.inflection[k] > r.inflection[k]) &&
              !(s.loop[k] < r.loop[k]) && !(s.loop[k] > r.loop[k]));
}

static long double exact_at(const loft_cubic *c, int axis, long double t)
{
    long double p[4];
    for (int k = 0; k < 4; k++)
        p[k] = exact_of(c->p[k].axis[axis]);
    return exact_eval(p, 3, t);
}

/* The parameter is off by 2^-25 or one ulp: the points by that times the largest derivative, 3 *
 * 2^16. */
static void a_crossing_is_one_point(arb *a)
{
    const loft_cubic c = some_cubic(a);
    const loft_shape s = shape_of(&c);

    for (int axis = 0; axis < 2 && s.loops; axis++)
        CHECK_EXACT(exact_at(&c, axis, exact_unit(s.loop[0])),
                    exact_at(&c, axis, exact_unit(s.loop[1])),
                    2 * BY_NUM(0x1.1p-25L, 0x1p-24L, 0x1p-52L) * 3 * 65536);
}

static void curvature_changes_its_sign_at_an_inflection(arb *a)
{
    loft_cubic c;
    loft_bezier b;
    loft_real before = 0, after = 0;
    loft_vec tangent;

    for (int k = 0; k < 4; k++)
        c.p[k] = some_point(a, 2);
    const loft_shape s = shape_of(&c);
    const loft_unit step = LOFT_UNIT(0.001), t = s.inflection[0];
    CHECK(loft_bezier_init(&b, c.p, 3) == LOFT_OK);
    if (s.inflections == 0 || (s.inflections == 2 && s.inflection[1] - t < 3 * step))
        return;
    const enum loft_status one = loft_bezier_curvature_vec(&b, t - step, &before, &tangent),
                           two = loft_bezier_curvature_vec(&b, t + step, &after, &tangent);
    if (one == LOFT_OK && two == LOFT_OK)
        CHECK((before <= 0 && after >= 0) || (before >= 0 && after <= 0));
}


/* Curvature */

static unsigned some_curve(arb *a, loft_vec p[])
{
    const unsigned n = 1 + arb_below(a, LOFT_DEGREE_MAX), size = arb_below(a, 4);
    const int32_t limit = size == 0 ? 2 : size == 1 ? 5000 : size == 2 ? 40000000 : INT32_MAX;

    for (unsigned k = 0; k <= n; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = raw(arb_raw(a, limit));
    if (arb_below(a, 4) == 0)                       /* leaves its start like a cusp */
        p[1] = p[0];
    if (arb_below(a, 4) == 0)                       /* back and forth: stops halfway */
        for (unsigned k = 0; 2 * k < n; k++)
            p[n - k] = p[k];
    if (arb_below(a, 4) == 0)                       /* one LSB off that    */
        nudge(a, &p[arb_below(a, n + 1)].axis[0]);
    return n;
}

static int64_t some_j(arb *a)
{
    const int64_t edge[6] = { 0, 65536, 32768, 1, 65535, 32769 };
    return arb_below(a, 2) ? edge[arb_below(a, 6)] : (int64_t)arb_below(a, 65537);
}

static void near_result(loft_real got, long double want, long double unsure)
{
    CHECK_EXACT(exact_of(got), want,
                BY_NUM(LSB / 2 + LSB * 0x1p-16L, ulp(want), ulp(want)) + unsure);
}

static bool too_large(long double k)    { return fabsl(k) > BY_NUM(32767.9L, FLT_MAX, DBL_MAX); }

static void curvature_is_rounded_once(arb *a)
{
    loft_vec p[LOFT_DEGREE_MAX + 1], tangent = { { 0 } };
    const unsigned n = some_curve(a, p);
    const int64_t j = some_j(a);
    const bool plane = arb_below(a, 2);
    loft_bezier b;
    loft_real k = 0;

    CHECK(loft_bezier_init(&b, p, n) == LOFT_OK);
    const loft_unit t = loft_unit_of((uint32_t)j, 65536);
    const enum loft_status status = plane ? loft_bezier_curvature_vec(&b, t, &k, &tangent)
                                          : loft_bezier_curvature(&b, t, &k, &tangent);
    const exact_bend want = exact_bend_at(&b, j, plane ? 2 : LOFT_AXES);

    CHECK((status == LOFT_SINGULAR) == want.singular);
    if (status == LOFT_ERR_RANGE)
        CHECK(too_large(want.curvature));
    if (status != LOFT_OK)
        return;
    CHECK(!too_large(want.curvature * (1 - 0x1p-14L)));
    near_result(k, want.curvature, want.unsure);
    for (int i = 0; i < LOFT_AXES; i++)
        near_result(tangent.axis[i], want.tangent[i], 0);
}

static void a_reversed_curve_bends_the_other_way(arb *a)
{
    loft_vec p[LOFT_DEGREE_MAX + 1], q[LOFT_DEGREE_MAX + 1], one, two;
    const unsigned n = some_curve(a, p);
    const uint32_t j = (uint32_t)some_j(a);
    loft_bezier b, c;
    loft_real k = 0, l = 0;

    for (unsigned i = 0; i <= n; i++)
        q[i] = p[n - i];
    CHECK(loft_bezier_init(&b, p, n) == LOFT_OK && loft_bezier_init(&c, q, n) == LOFT_OK);
    const enum loft_status status = loft_bezier_curvature_vec(&b, loft_unit_of(j, 65536), &k, &one);
    CHECK(status == loft_bezier_curvature_vec(&c, loft_unit_of(65536 - j, 65536), &l, &two));
    if (status == LOFT_OK)
        CHECK_EXACT(exact_of(k), -exact_of(l), BY_NUM(LSB, ulp(exact_of(k)), ulp(exact_of(k))));
}

/* Edges times 1, 2, 3 on a line, and a quarter turn: known to the last digit. */
static void known_curvatures_are_given(arb *a)
{
    const int64_t h = 65536 * (1 + (int64_t)arb_below(a, 9));
    loft_vec line[4] = { at(0, 0), at(h, h), at(3 * h, 3 * h), at(0, 0) },
             bend[3] = { at(0, 0), at(h, 0), at(h, h) }, tangent;
    loft_bezier b;
    loft_real k;

    CHECK(loft_bezier_init(&b, line, 3) == LOFT_OK &&
          loft_bezier_curvature_vec(&b, LOFT_UNIT(0.25), &k, &tangent) == LOFT_OK);
    CHECK(!(k > 0) && !(k < 0));
    near_result(tangent.axis[1], sqrtl(0.5L), 0);
    CHECK(loft_bezier_init(&b, bend, 2) == LOFT_OK &&
          loft_bezier_curvature_vec(&b, 0, &k, &tangent) == LOFT_OK);
    near_result(k, 65536 / (2 * (long double)h), 0);
    near_result(tangent.axis[0], 1, 0);
}

static void what_has_no_curvature_says_so(arb *a)
{
    loft_vec p[3] = { at(1, 2), at(1, 2), at(5, 5) }, tangent = at(7, 7);
    loft_real k = LOFT_REAL(3);
    loft_bezier b;

    (void)a;
    CHECK(loft_bezier_init(&b, p, 2) == LOFT_OK);
    CHECK(loft_bezier_curvature_vec(&b, 0, &k, &tangent) == LOFT_SINGULAR &&
          loft_bezier_curvature(&b, 0, &k, &tangent) == LOFT_SINGULAR);
    CHECK(loft_bezier_curvature_vec(&b, LOFT_UNIT(2.5), &k, &tangent) == LOFT_ERR_ARG);
    CHECK(loft_bezier_curvature_vec(&b, LOFT_UNIT(-1.5), &k, &tangent) == LOFT_ERR_ARG);
    CHECK(loft_bezier_init(&b, p, 0) == LOFT_OK &&
          loft_bezier_curvature(&b, 0, &k, &tangent) == LOFT_SINGULAR);
#if LOFT_NUM == LOFT_Q16
    /* 32768 / 2^0: one more than fits */
    loft_vec sharp[3] = { at(0, 0), at(1, 0), at(1, 1) };
    CHECK(loft_bezier_init(&b, sharp, 2) == LOFT_OK &&
          loft_bezier_curvature_vec(&b, 0, &k, &tangent) == LOFT_ERR_RANGE);
#else
    p[2].axis[0] = (loft_real)2e6;
    CHECK(loft_bezier_init(&b, p, 2) == LOFT_OK &&
          loft_bezier_curvature_vec(&b, LOFT_UNIT(0.5), &k, &tangent) == LOFT_ERR_RANGE);
#endif
    CHECK(k <= LOFT_REAL(3) && k >= LOFT_REAL(3) && loft_vec_equal(tangent, at(7, 7)));
}


/* Polygons */

static unsigned some_polygon(arb *a, loft_vec p[])
{
    const unsigned count = 1 + arb_below(a, 10), size = arb_below(a, 4), kind = arb_below(a, 4);
    const long double radius = kind == 1   ? 4
                               : kind == 2 ? 5e8L
                                           : 5000,
                      from = arb_below(a, 1000) * 0.001L;
    const int64_t dx = some(a, 1), dy = some(a, 1);

    for (unsigned k = 0; k < count; k++) {
        const long double angle = 6.2831853071795864769L * (from + k) / count *
                                  (1 + (arb_below(a, 20) == 0));
        const int64_t along = some(a, 1);
        p[k] = kind == 0   ? some_point(a, size)
               : kind == 3 ? at(along * dx, along * dy)
                           : at((int64_t)roundl(radius * cosl(angle)),
                                (int64_t)roundl(radius * sinl(angle)));
        if (k > 0 && arb_below(a, 8) == 0)
            p[k] = p[k - 1];
    }
    if (arb_below(a, 3) == 0)
        nudge(a, &p[arb_below(a, count)].axis[arb_below(a, 2)]);
    return count;
}

static enum loft_convexity convexity(const loft_vec p[], unsigned count)
{
    enum loft_convexity c = LOFT_COLLINEAR;
    CHECK(loft_polygon_convex(p, count, &c) == LOFT_OK);
    return c;
}

static void convexity_is_exact_from_any_start(arb *a)
{
    loft_vec p[10], turned[10], back[10];
    const unsigned count = some_polygon(a, p), start = arb_below(a, count);
    const enum loft_convexity want = exact_convexity(p, count);

    for (unsigned k = 0; k < count; k++) {
        turned[k] = p[(start + k) % count];
        back[k] = p[count - 1 - k];
    }
    CHECK(convexity(p, count) == want && convexity(turned, count) == want &&
          convexity(back, count) == want);
}

static void few_points_and_twice_around(arb *a)
{
    const int64_t h = 1 + arb_below(a, 1000000);
    const loft_vec p[8] = { at(0, 0), at(h, 0), at(h, h), at(0, h),
                            at(0, 0), at(h, 0), at(h, h), at(0, h) };
    const loft_vec star[5] = { at(0, 3 * h), at(2 * h, -3 * h), at(-3 * h, h), at(3 * h, h),
                               at(-2 * h, -3 * h) };
    const loft_vec hook[7] = { at(0, 0),      at(2 * h, 0), at(h, 0), at(h, -h),
                               at(3 * h, -h), at(3 * h, h), at(0, h) };
    const loft_vec spike[5] = { at(0, 0), at(2 * h, 0), at(h, 0), at(h, h), at(0, h) };

    CHECK(convexity(hook, 7) == LOFT_NOT_CONVEX && convexity(spike, 5) == LOFT_NOT_CONVEX);
    CHECK(convexity(p, 0) == LOFT_COLLINEAR && convexity(p, 1) == LOFT_COLLINEAR &&
          convexity(p, 2) == LOFT_COLLINEAR);
    CHECK(convexity(p, 3) == LOFT_CONVEX && convexity(p, 4) == LOFT_CONVEX &&
          convexity(p, 5) == LOFT_CONVEX);
    CHECK(convexity(p, 8) == LOFT_NOT_CONVEX && convexity(star, 5) == LOFT_NOT_CONVEX);
}

/* What a convex polygon proves. */
static void a_convex_polygon_makes_the_curve_bend_one_way(arb *a)
{
    loft_vec p[10], tangent;
    const unsigned count = some_polygon(a, p);
    bool left = false, right = false;
    loft_bezier b;
    loft_real k;

    if (convexity(p, count) != LOFT_CONVEX)
        return;
    CHECK(loft_bezier_init(&b, p, count - 1) == LOFT_OK);
    for (uint32_t j = 0; j <= 16; j++)
        if (loft_bezier_curvature_vec(&b, loft_unit_of(j, 16), &k, &tangent) == LOFT_OK) {
            left = left || k > 0;
            right = right || k < 0;
        }
    CHECK(!(left && right));
}

static void numbers_outside_the_window_are_refused(arb *a)
{
    loft_cubic c = { { at(0, 0), at(65536, 0), at(0, 65536), at(9, 9) } };
    loft_shape s = { LOFT_LOOP, 7, 0, 0, { 0, 0 }, 0, { 0, 0 } };
    enum loft_convexity convex = LOFT_CONVEX;

    (void)a;
    c.p[arb_below(a, 4)].axis[arb_below(a, 2)] = (loft_real)BY_NUM(INT32_MIN, 1e-30, 1e-30);
    CHECK(loft_cubic_shape(&c, &s) == BY_NUM(LOFT_OK, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
    CHECK(loft_polygon_convex(c.p, 4, &convex) == BY_NUM(LOFT_OK, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
    CHECK(BY_NUM(true, s.inflections == 7 && convex == LOFT_CONVEX,
                 s.inflections == 7 && convex == LOFT_CONVEX));
}

int main(void)
{
    PROPERTY(kinds_and_parameters_are_exact,               6000);
    PROPERTY(all_kinds_are_tried,                             1);
    PROPERTY(reversal_mirrors_the_parameters,              1000);
    PROPERTY(maps_that_keep_areas_change_nothing,          1000);
    PROPERTY(a_crossing_is_one_point,                      1500);
    PROPERTY(curvature_changes_its_sign_at_an_inflection,   500);
    PROPERTY(curvature_is_rounded_once,                    3000);
    PROPERTY(a_reversed_curve_bends_the_other_way,          500);
    PROPERTY(known_curvatures_are_given,                      9);
    PROPERTY(what_has_no_curvature_says_so,                   1);
    PROPERTY(convexity_is_exact_from_any_start,            3000);
    PROPERTY(few_points_and_twice_around,                    20);
    PROPERTY(a_convex_polygon_makes_the_curve_bend_one_way, 300);
    PROPERTY(numbers_outside_the_window_are_refused,         20);
    return check_failures();
}

/* tests/lib/curve/test_invariance.c -- properties of every kind of curve: affine images, reversal,
 * hull, pieces, degree
 * SPDX-License-Identifier: MIT
 *
 * Bezier and B-spline curves, with and without weights, through the public interface. Each property
 * compares two computations by the library, so its bound is the sum of both.
 */
#include "curve/bspline.h"
#include "curve/circle.h"
#include "curve/nurbs.h"
#include "support/exact.h"          /* exact_of, ulp, CHECK_EXACT */

#define POINTS 12
#define LIMIT  2000         /* of a coordinate */
#define FINER  1024         /* parameters are j / FINER of the domain */

enum kind { A_BEZIER, A_RATIONAL, A_BSPLINE, A_NURBS, KINDS };

typedef struct {
    enum kind kind;
    unsigned degree, count;     /* of points */
    loft_weighted p[POINTS];
    loft_vec bare[POINTS];
    loft_real knots[2 * POINTS], end;
    loft_bezier bezier;
    loft_rational rational;
    loft_bspline bspline;
    loft_nurbs nurbs;
} shape;

static void init(shape *s)
{
    for (unsigned k = 0; k < s->count; k++)
        s->bare[k] = s->p[k].p;
    CHECK((s->kind == A_BEZIER     ? loft_bezier_init(&s->bezier, s->bare, s->degree)
           : s->kind == A_RATIONAL ? loft_rational_init(&s->rational, s->p, s->degree)
           : s->kind == A_BSPLINE
               ? loft_bspline_init(&s->bspline, s->bare, s->count, s->knots, s->degree)
               : loft_nurbs_init(&s->nurbs, s->p, s->count, s->knots, s->degree)) == LOFT_OK);
}

/* Coordinates are multiples of 4 LSB, knots are integers, some of them double: halves and mirrors
 * are exact. */
static void arb_shape(arb *a, shape *s, enum kind kind)
{
    const bool spline = kind == A_BSPLINE || kind == A_NURBS;
    bool doubled = false;
    unsigned at = 0;

    s->kind = kind;
    s->degree = 1 + arb_below(a, LOFT_DEGREE_MAX);
    s->count = s->degree + 1 + (spline ? arb_below(a, POINTS - s->degree) : 0);
    for (unsigned k = 0; k < s->count; k++) {
        s->p[k].w = LOFT_REAL(1) + loft_real_from_int((int32_t)arb_below(a, 200));
        for (int i = 0; i < LOFT_AXES; i++)
            s->p[k].p.axis[i] = loft_real_from_raw(arb_raw(a, LIMIT * 16384) * 4);
    }
    for (unsigned k = 0; k < s->count + s->degree + 1; k++) {
        const bool inner = k > s->degree && k < s->count;
        const bool again = inner && s->degree > 1 && k > s->degree + 1 && !doubled &&
                           arb_below(a, 3) == 0;
        at += (inner && !again) || k == s->count;
        doubled = again;
        s->knots[k] = loft_real_from_int((int32_t)at);
    }
    s->end = s->knots[s->count];
    init(s);
}

static loft_vec at(const shape *s, uint32_t j)
{
    const loft_real u = (loft_real)(s->end / FINER * (loft_real)j);

    return s->kind == A_BEZIER     ? loft_bezier_eval(&s->bezier, loft_unit_of(j, FINER))
           : s->kind == A_RATIONAL ? loft_rational_eval(&s->rational, loft_unit_of(j, FINER))
           : s->kind == A_BSPLINE  ? loft_bspline_eval(&s->bspline, u)
                                   : loft_nurbs_eval(&s->nurbs, u);
}

/* Twice the error of a point: two curves of that kind and size. */
static long double twice(const shape *s)
{
    const long double by_num[3] = { 1.02L * LSB, 2 * ulp(LIMIT),
                                    2 * (10 * s->degree + 4) * ulp(LIMIT) };
    return by_num[BY_NUM(0, 1, 2)];
}

static enum kind arb_kind(arb *a) { return (enum kind)arb_below(a, KINDS); }

/* Every coordinate becomes an average of itself and another one, reflected and translated: exactly,
 * for multiples of 4. */
static loft_vec image(loft_vec p, const int32_t m[2], loft_vec o)
{
    loft_vec q;

    for (int i = 0; i < LOFT_AXES; i++)
        q.axis[i] = p.axis[i] / 4 * (loft_real)m[0] +
                    p.axis[(i + 1) % LOFT_AXES] / 4 * (loft_real)m[1] + o.axis[i];
    return q;
}

static void an_affine_image_has_the_image_of_the_point(arb *a)
{
    const int32_t factor[4] = { -2, -1, 1, 2 },
                  m[2] = { factor[arb_below(a, 4)], factor[arb_below(a, 4)] };
    const uint32_t j = arb_below(a, FINER + 1);
    loft_vec o;
    shape s;

    arb_shape(a, &s, arb_kind(a));
    for (int i = 0; i < LOFT_AXES; i++)
        o.axis[i] = loft_real_from_int((int32_t)arb_below(a, 2000) - 1000);
    const loft_vec before = at(&s, j);
    for (unsigned k = 0; k < s.count; k++)
        s.p[k].p = image(s.p[k].p, m, o);
    init(&s);
    const loft_vec after = at(&s, j);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = exact_of(before.axis[i]) / 4 * m[0] +
                                 exact_of(before.axis[(i + 1) % LOFT_AXES]) / 4 * m[1] +
                                 exact_of(o.axis[i]);
        /* o makes the largest coordinate larger */
        CHECK_EXACT(exact_of(after.axis[i]), want, twice(&s) * BY_NUM(1, 2, 2));
    }
}

static void a_reversed_curve_is_the_same(arb *a)
{
    const uint32_t j = arb_below(a, FINER + 1);
    shape s, back;

    arb_shape(a, &s, arb_kind(a));
    back = s;
    for (unsigned k = 0; k < s.count; k++)
        back.p[k] = s.p[s.count - 1 - k];
    for (unsigned k = 0, last = s.count + s.degree; k <= last; k++)
        back.knots[k] = s.end - s.knots[last - k];
    init(&back);
    const loft_vec here = at(&s, j), there = at(&back, FINER - j);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(here.axis[i]), exact_of(there.axis[i]), twice(&s));
}

/* For a spline, the degree + 1 points that the span uses. The property must hold in every
 * direction; the axes and their sums are tested. */
static void a_point_lies_in_the_hull_of_the_points(arb *a)
{
    const uint32_t j = arb_below(a, FINER + 1);
    shape s;

    arb_shape(a, &s, arb_kind(a));
    const bool spline = s.kind == A_BSPLINE || s.kind == A_NURBS;
    const loft_real u = (loft_real)(s.end / FINER * (loft_real)j);
    const unsigned first =
        !spline ? 0
                : loft_knots_find(s.kind == A_BSPLINE ? &s.bspline.knots : &s.nurbs.knots, u) -
                      s.degree;
    const loft_vec v = at(&s, j);
    for (int way = 0; way < 8; way++) {
        long double low = 1e9L, high = -1e9L, here = 0;
        for (unsigned k = first; k <= first + s.degree; k++) {
            long double x = 0;
            for (int i = 0; i < LOFT_AXES; i++)
                x += (way >> i & 1 ? -1 : 1) * exact_of(s.p[k].p.axis[i]);
            low = fminl(low, x);
            high = fmaxl(high, x);
        }
        for (int i = 0; i < LOFT_AXES; i++)
            here += (way >> i & 1 ? -1 : 1) * exact_of(v.axis[i]);
        const long double slack = LOFT_AXES * twice(&s) / 2;
        CHECK(here >= low - slack && here <= high + slack);
    }
}

static void check_points(const shape *s, const loft_weighted p[], const loft_weighted q[])
{
    for (unsigned k = 0; k <= s->degree; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(exact_of(p[k].p.axis[i]), exact_of(q[k].p.axis[i]), twice(s));
}

static void cut(const shape *s, loft_unit t, loft_weighted out[2][POINTS],
                loft_weighted part[2][POINTS])
{
    loft_vec bare[4][POINTS];

    if (s->kind == A_RATIONAL) {
        CHECK(loft_rational_split(&s->rational, t, out[0], out[1]) == LOFT_OK);
        CHECK(loft_rational_sub(&s->rational, 0, t, part[0]) == LOFT_OK &&
              loft_rational_sub(&s->rational, t, LOFT_UNIT(1), part[1]) == LOFT_OK);
        return;
    }
    CHECK(loft_bezier_split(&s->bezier, t, bare[0], bare[1]) == LOFT_OK);
    CHECK(loft_bezier_sub(&s->bezier, 0, t, bare[2]) == LOFT_OK &&
          loft_bezier_sub(&s->bezier, t, LOFT_UNIT(1), bare[3]) == LOFT_OK);
    for (unsigned k = 0; k <= s->degree; k++)
        for (int side = 0; side < 2; side++) {
            out[side][k].p = bare[side][k];
            part[side][k].p = bare[2 + side][k];
        }
}

static void a_split_gives_the_parts(arb *a)
{
    const loft_unit t = arb_unit(a);
    loft_weighted out[2][POINTS], part[2][POINTS];
    shape s;

    arb_shape(a, &s, arb_below(a, 2) ? A_BEZIER : A_RATIONAL);
    cut(&s, t, out, part);
    check_points(&s, out[0], part[0]);
    check_points(&s, out[1], part[1]);
    /* weights: one ratio for all */
    for (unsigned k = 0; k <= s.degree && s.kind == A_RATIONAL; k++)
        for (int side = 0; side < 2; side++)
            CHECK_EXACT(exact_of(out[side][k].w) * exact_of(part[side][0].w),
                        exact_of(part[side][k].w) * exact_of(out[side][0].w),
                        512 * BY_NUM(LSB, 2 * ulp(256), 80 * ulp(256)));
}

/* Weights of at least 1 are rounded too; that moves a point by as much of the width. */
static void an_elevated_curve_is_the_same(arb *a)
{
    const uint32_t j = arb_below(a, FINER + 1);
    shape s, high;

    arb_shape(a, &s, arb_below(a, 2) ? A_BEZIER : A_RATIONAL);
    high = s;
    high.degree = s.degree + arb_below(a, LOFT_DEGREE_MAX - s.degree + 1);
    high.count = high.degree + 1;
    if (s.kind == A_RATIONAL) {
        CHECK(loft_rational_elevate(&s.rational, high.degree - s.degree, high.p) == LOFT_OK);
    } else {
        CHECK(loft_bezier_elevate(&s.bezier, high.degree - s.degree, high.bare) == LOFT_OK);
        for (unsigned k = 0; k < high.count; k++)
            high.p[k].p = high.bare[k];
    }
    init(&high);
    const loft_vec here = at(&s, j), there = at(&high, j);
    const long double weights = s.kind == A_RATIONAL
                                    ? 4 * LIMIT * BY_NUM(0x1.1p-17L, 0x1p-23L, 40 * 0x1p-52L)
                                    : 0;
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(here.axis[i]), exact_of(there.axis[i]), 1.5L * twice(&high) + weights);
}

/* The error e of the arc and the rounding of the point, for both. */
static void check_arc(const loft_circle *c, const loft_circle *other, loft_unit t, bool back,
                      loft_vec o)
{
    loft_vec here = { { 0 } }, there = { { 0 } };

    CHECK(loft_circle_eval(c, t, &here) == LOFT_OK &&
          loft_circle_eval(other, back ? LOFT_UNIT(1) - t : t, &there) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(there.axis[i]), exact_of(here.axis[i]) + exact_of(o.axis[i]),
                    BY_NUM(1.05L * LSB, 2 * ulp(3 * LIMIT), 64 * ulp(3 * LIMIT)));
}

static void an_arc_moves_with_its_points_and_runs_back(arb *a)
{
#if LOFT_AXES > 1
    const int32_t x = 1 + (int32_t)arb_below(a, 700), y = 1 + (int32_t)arb_below(a, 700),
                  turns = arb_below(a, 2) ? 1 : -1;
    const loft_unit t = loft_unit_of(arb_below(a, FINER + 1), FINER);
    loft_vec from = { { 0 } }, to = { { 0 } }, centre = { { 0 } }, zero = { { 0 } }, o = { { 0 } };
    loft_circle c, moved, back;

    from.axis[0] = loft_real_from_int(x);
    from.axis[1] = loft_real_from_int(y);
    to.axis[0]   = loft_real_from_int(-y);
    to.axis[1]   = loft_real_from_int(x);
    for (int i = 0; i < LOFT_AXES; i++)
        o.axis[i] = loft_real_from_int((int32_t)arb_below(a, 2000) - 1000);
    CHECK(loft_circle_from_centre(&c, from, to, LOFT_PLANE_XY, centre, turns) == LOFT_OK);
    CHECK(loft_circle_from_centre(&back, to, from, LOFT_PLANE_XY, centre, -turns) == LOFT_OK);
    CHECK(loft_circle_from_centre(&moved, loft_vec_add(from, o), loft_vec_add(to, o), LOFT_PLANE_XY,
                                  loft_vec_add(centre, o), turns) == LOFT_OK);
    check_arc(&c, &moved, t, false, o);
    check_arc(&c, &back, t, true, zero);
#else
    (void)a;
#endif
}

int main(void)
{
    PROPERTY(an_affine_image_has_the_image_of_the_point,    4000);
    PROPERTY(a_reversed_curve_is_the_same,                  4000);
    PROPERTY(a_point_lies_in_the_hull_of_the_points,        4000);
    PROPERTY(a_split_gives_the_parts,                       1000);
    PROPERTY(an_elevated_curve_is_the_same,                 2000);
    PROPERTY(an_arc_moves_with_its_points_and_runs_back,    1000);
    return check_failures();
}

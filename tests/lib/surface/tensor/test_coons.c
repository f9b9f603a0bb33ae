/* tests/lib/surface/tensor/test_coons.c -- properties of lib/surface/tensor/coons.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_sci.h"          /* exact_sci, exact_of */
#include "surface/tensor/coons.h"
#include "surface/differential.h"

#define COUNT (LOFT_DEGREE_MAX + 1)

/* Four Bezier curves that meet: points[0], [1] along u, [2], [3] along v. */
typedef struct {
    loft_vec p[4][COUNT];
    loft_bezier b[4];
} frame;

static void arb_frame(arb *a, frame *f, int32_t limit, unsigned m, unsigned n)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < COUNT; i++)
            f->p[k][i] = arb_vec(a, limit);
    f->p[2][0] = f->p[0][0];
    f->p[3][0] = f->p[0][m];
    f->p[2][n] = f->p[1][0];
    f->p[3][n] = f->p[1][m];
    for (int k = 0; k < 4; k++)
        CHECK(loft_bezier_init(&f->b[k], f->p[k], k < 2 ? m : n) == LOFT_OK);
}

static void patches_of(const frame *f, loft_coons *c, loft_coons_bezier *cb)
{
    const loft_side s[4] = { loft_side_from_bezier(&f->b[0]), loft_side_from_bezier(&f->b[1]),
                             loft_side_from_bezier(&f->b[2]), loft_side_from_bezier(&f->b[3]) };
    const loft_bezier u[1][2] = { { f->b[0], f->b[1] } }, v[1][2] = { { f->b[2], f->b[3] } };

    CHECK(loft_coons_init(c, s, s + 2, 0) == LOFT_OK &&
          loft_coons_bezier_init(cb, u, v, 1, 0) == LOFT_OK);
}

static long double exact_axis(const loft_bezier *b, int axis, unsigned k, long double t)
{
    long double c[COUNT];

    for (unsigned i = 0; i <= b->degree; i++)
        c[i] = exact_of(b->p[i].axis[axis]);
    return exact_deriv(c, b->degree, k, t);
}

static unsigned highest(unsigned m, unsigned n) { return m > n ? m : n; }

/* The sides are met in any degree, in q16 bit for bit as loft_bezier_eval. */
static void boundary_is_followed(arb *a)
{
    const unsigned m = 1 + arb_below(a, 9), n = 1 + arb_below(a, 9);
    const loft_unit t = arb_unit(a), one = LOFT_UNIT(1);
    frame f;
    loft_coons c;
    loft_coons_bezier cb;
    loft_vec p = { { 0 } }, q = { { 0 } };

    arb_frame(a, &f, 32767, m, n);
    patches_of(&f, &c, &cb);
    for (int k = 0; k < 4; k++) {
        const loft_unit s = k < 2 ? t : k == 3 ? one : 0, r = k > 1 ? t : k == 1 ? one : 0;
        CHECK(loft_coons_eval(&c, s, r, &p) == LOFT_OK &&
              loft_coons_bezier_eval(&cb, s, r, &q) == LOFT_OK);
        const loft_vec want = loft_bezier_eval(&f.b[k], t);
        for (int i = 0; i < LOFT_AXES; i++) {
            CHECK_EXACT(exact_of(p.axis[i]), exact_of(want.axis[i]),
                        BY_NUM(0, ulp(32767) / 2, 4 * ulp(32767)));
            CHECK_EXACT(exact_of(q.axis[i]), exact_of(want.axis[i]),
                        BY_NUM(0, ulp(32767) / 2, 4 * ulp(32767)));
        }
    }
}

/* Both kinds against long double, to the ends of the coordinates. */
static void bilinear_keeps_its_bound(arb *a)
{
    const unsigned m = 1 + arb_below(a, 9), n = 1 + arb_below(a, 9);
    const int32_t limit = arb_below(a, 3) ? 9000 : 32767;
    const loft_unit s = arb_unit(a), t = arb_unit(a);
    const long double x = exact_unit(s), y = exact_unit(t);
    frame f;
    loft_coons c;
    loft_coons_bezier cb;
    loft_vec p[2] = { { { 0 } }, { { 0 } } };
    bool fits = true;

    arb_frame(a, &f, limit, m, n);
    patches_of(&f, &c, &cb);
    const enum loft_status status[2] = { loft_coons_eval(&c, s, t, &p[0]),
                                         loft_coons_bezier_eval(&cb, s, t, &p[1]) };
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double corners =
            (1 - x) * ((1 - y) * exact_of(f.p[0][0].axis[i]) + y * exact_of(f.p[1][0].axis[i])) +
            x * ((1 - y) * exact_of(f.p[0][m].axis[i]) + y * exact_of(f.p[1][m].axis[i]));
        const long double want = (1 - y) * exact_axis(&f.b[0], i, 0, x) +
                                 y * exact_axis(&f.b[1], i, 0, x) +
                                 (1 - x) * exact_axis(&f.b[2], i, 0, y) +
                                 x * exact_axis(&f.b[3], i, 0, y) - corners;
        fits = fits && want > BY_NUM(-32768 - LSB / 2, -INFINITY, -INFINITY) &&
               want < BY_NUM(32768 - LSB / 2, INFINITY, INFINITY);
        for (int k = 0; k < 2 && status[k] == LOFT_OK; k++)
            CHECK_EXACT(exact_of(p[k].axis[i]), want,
                        BY_NUM(LSB / 2, ulp(want) / 2 + ulp(limit) / 2, 0) +
                            (BY_NUM(4, 0, 16) + BY_NUM(2, 0, 6) * highest(m, n)) *
                                BY_NUM(0x1p-33L, 0, ulp(limit)));
    }
    CHECK(status[0] == (fits ? LOFT_OK : LOFT_ERR_RANGE) && status[1] == status[0]);
}

/* The net of the boundary polygons is the same patch, with their boundary. */
static void tensor_is_the_same_patch(arb *a)
{
    const unsigned m = 1 + arb_below(a, 9), n = 1 + arb_below(a, 9);
    const loft_unit s = arb_unit(a), t = arb_unit(a);
    frame f;
    loft_coons c;
    loft_coons_bezier cb;
    loft_vec net[COUNT * COUNT], p = { { 0 } };

    arb_frame(a, &f, 5000, m, n);
    patches_of(&f, &c, &cb);
    CHECK(loft_tensor_from_coons(&cb, net) == LOFT_OK && loft_coons_eval(&c, s, t, &p) == LOFT_OK);
    for (unsigned i = 0; i <= m; i++)
        CHECK(BY_NUM(loft_vec_equal(net[i * (n + 1)], f.p[0][i]) &&
                         loft_vec_equal(net[i * (n + 1) + n], f.p[1][i]),
                     true, true));
    for (unsigned j = 0; j <= n; j++)
        CHECK(BY_NUM(loft_vec_equal(net[j], f.p[2][j]) &&
                         loft_vec_equal(net[m * (n + 1) + j], f.p[3][j]),
                     true, true));
    for (int i = 0; i < LOFT_AXES; i++) {
        long double rows[COUNT], column[COUNT];
        for (unsigned r = 0; r <= m; r++) {
            for (unsigned k = 0; k <= n; k++)
                column[k] = exact_of(net[r * (n + 1) + k].axis[i]);
            rows[r] = exact_eval(column, n, exact_unit(t));
        }
        CHECK_EXACT(exact_of(p.axis[i]), exact_eval(rows, m, exact_unit(s)),
                    BY_NUM(1.001L, 2, 40 + 6 * highest(m, n)) * ulp(15000));
    }
}

/* With slopes and curvatures too: the tensor product is the patch, whatever its curves. */
static void blended_tensors_are_the_same_patch(arb *a)
{
    const unsigned orders = 1 + arb_below(a, LOFT_COONS_ORDERS);
    static loft_vec p[4 * LOFT_COONS_ORDERS][COUNT], net[COUNT * COUNT];
    loft_bezier u[LOFT_COONS_ORDERS][2], v[LOFT_COONS_ORDERS][2];
    loft_coons_bezier c;
    loft_tensor tensor;
    loft_vec want = { { 0 } };
    long double size = 0;
    unsigned m, n;

    for (unsigned k = 0; k < 4 * orders; k++) {
        const unsigned degree = arb_below(a, 10);
        for (unsigned i = 0; i <= degree; i++)
            p[k][i] = arb_vec(a, 100);
        CHECK(loft_bezier_init(k % 2 ? &v[k / 4][k / 2 % 2] : &u[k / 4][k / 2 % 2], p[k], degree) ==
              LOFT_OK);
    }
    CHECK(loft_coons_bezier_init(&c, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v, orders,
                                 LOFT_REAL(1000)) == LOFT_OK);
    CHECK(loft_tensor_from_coons_blended(&c, &m, &n, net) == LOFT_OK);
    CHECK(loft_tensor_init(&tensor, net, m, n) == LOFT_OK);
    for (unsigned k = 0; k < (m + 1) * (n + 1); k++)
        for (int i = 0; i < LOFT_AXES; i++)
            size = fmaxl(size, fabsl(exact_of(net[k].axis[i])));
    for (int times = 0; times < 8; times++) {
        const loft_unit s = arb_unit(a), t = arb_unit(a);
        if (loft_coons_bezier_eval(&c, s, t, &want) != LOFT_OK)
            continue;
        const loft_vec got = loft_tensor_eval(&tensor, s, t);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_NEAR(exact_of(got.axis[i]), exact_of(want.axis[i]),
                       BY_NUM(2, 3, 128 * 100) * ulp(size));
    }
}

/* Moving all curves by whole millimetres moves every point by exactly that; halving halves it. */
static void moves_with_its_curves(arb *a)
{
    const unsigned m = 1 + arb_below(a, 9), n = 1 + arb_below(a, 9);
    const loft_unit s = arb_unit(a), t = arb_unit(a);
    frame f;
    loft_coons c;
    loft_coons_bezier cb;
    loft_vec p = { { 0 } }, q = { { 0 } }, d;

    arb_frame(a, &f, 3000, m, n);
    for (int i = 0; i < LOFT_AXES; i++)
        d.axis[i] = loft_real_from_int((int32_t)arb_below(a, 2000) - 1000);
    patches_of(&f, &c, &cb);
    CHECK(loft_coons_eval(&c, s, t, &p) == LOFT_OK);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < COUNT; i++)
            f.p[k][i] = loft_vec_add(f.p[k][i], d);
    patches_of(&f, &c, &cb);
    CHECK(loft_coons_eval(&c, s, t, &q) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(q.axis[i]), exact_of(p.axis[i]) + exact_of(d.axis[i]),
                    BY_NUM(0, 3 * ulp(12000), 200 * ulp(12000)));
}

/* Curves other than Bezier curves: a straight B-spline of one span and a rational curve of equal
 * weights have known points. */
static void any_curve_is_a_side(arb *a)
{
    const loft_real knots[8] = { LOFT_REAL(-2), LOFT_REAL(-2), LOFT_REAL(-2), LOFT_REAL(-2),
                                 LOFT_REAL(6),  LOFT_REAL(6),  LOFT_REAL(6),  LOFT_REAL(6) };
    const loft_unit s = loft_unit_of(arb_below(a, 1025), 1024),
                    t = loft_unit_of(arb_below(a, 1025), 1024);
    frame f;
    loft_weighted w[2][4];
    loft_rational r;
    loft_bspline b;
    loft_nurbs nurbs;
    loft_coons c, other;
    loft_coons_bezier cb;
    loft_vec p = { { 0 } }, q = { { 0 } };

    arb_frame(a, &f, 5000, 3, 3);
    patches_of(&f, &c, &cb);
    for (int k = 0; k < 4; k++)
        for (int side = 0; side < 2; side++)
            w[side][k] = (loft_weighted) { f.p[side ? 2 : 0][k], LOFT_REAL(3) };
    CHECK(loft_rational_init(&r, w[0], 3) == LOFT_OK &&
          loft_bspline_init(&b, f.p[1], 4, knots, 3) == LOFT_OK);
    CHECK(loft_nurbs_init(&nurbs, w[1], 4, knots, 3) == LOFT_OK);
    const loft_side u[2] = { loft_side_from_rational(&r), loft_side_from_bspline(&b) };
    const loft_side v[2] = { loft_side_from_nurbs(&nurbs), loft_side_from_bezier(&f.b[3]) };
    CHECK(loft_coons_init(&other, u, v, BY_NUM(0, LOFT_REAL(0.01), LOFT_REAL(1e-9))) == LOFT_OK);
    CHECK(loft_coons_eval(&c, s, t, &p) == LOFT_OK && loft_coons_eval(&other, s, t, &q) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    BY_NUM(2.1L * LSB, 8 * ulp(15000), 400 * ulp(15000)));
}

static void refuses_curves_that_do_not_meet(arb *a)
{
    const unsigned m = 1 + arb_below(a, 4), n = 1 + arb_below(a, 4);
    frame f;
    loft_coons c;
    loft_coons_bezier cb;
    loft_vec net[COUNT * COUNT], p = { { 0 } };

    arb_frame(a, &f, 1000, m, n);
    f.p[3][arb_below(a, 2) ? n : 0].axis[arb_below(a, LOFT_AXES)] += LOFT_REAL(0.5);
    const loft_side s[4] = { loft_side_from_bezier(&f.b[0]), loft_side_from_bezier(&f.b[1]),
                             loft_side_from_bezier(&f.b[2]), loft_side_from_bezier(&f.b[3]) };
    loft_bezier u[1][2] = { { f.b[0], f.b[1] } }, v[1][2] = { { f.b[2], f.b[3] } };
    CHECK(loft_coons_init(&c, s, s + 2, LOFT_REAL(0.25)) == LOFT_ERR_ARG &&
          loft_coons_init(&c, s, s + 2, LOFT_REAL(0.75)) == LOFT_OK);
    CHECK(loft_coons_bezier_init(&cb, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v, 1,
                                 LOFT_REAL(0.25)) == LOFT_ERR_ARG);
    CHECK(loft_coons_bezier_init(&cb, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v, 1,
                                 LOFT_REAL(0.75)) == LOFT_OK);
    CHECK(loft_coons_bezier_init(&cb, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v, 0,
                                 LOFT_REAL(1)) == LOFT_ERR_ARG);
    CHECK(loft_coons_bezier_init(&cb, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v, 4,
                                 LOFT_REAL(1)) == LOFT_ERR_ARG);
    CHECK(loft_coons_eval(&c, LOFT_UNIT(1.1), 0, &p) == LOFT_ERR_ARG &&
          loft_coons_bezier_eval(&cb, 0, LOFT_UNIT(-0.1), &p) == LOFT_ERR_ARG);
    cb.u[0][1].degree++;
    CHECK(loft_tensor_from_coons(&cb, net) == LOFT_ERR_ARG);
}


/* Slopes and curvatures: curves taken from a tensor product agree at the corners, and the patch
 * interpolates all of them. */

typedef struct {
    loft_vec p[4 * LOFT_COONS_ORDERS][COUNT];
    loft_bezier u[LOFT_COONS_ORDERS][2], v[LOFT_COONS_ORDERS][2];
    unsigned degree;
    long double reach;          /* the largest control value */
} web;

static int64_t difference_of(int64_t c[COUNT], unsigned n, unsigned k, int end)
{
    if (k > n)
        return 0;
    for (unsigned d = 0; d < k; d++)
        for (unsigned i = 0; i + d < n; i++)
            c[i] = (int64_t)(n - d) * (c[i + 1] - c[i]);
    return c[end ? n - k : 0];
}

/* The derivatives of a net of whole millimetres by v at v = 0, 1 along u, and by u along v. */
static void web_of(web *w, const loft_vec net[], unsigned n)
{
    w->degree = n;
    w->reach = 0;
    for (int axis = 0; axis < LOFT_AXES; axis++)
        for (unsigned k = 0; k < 2 * LOFT_COONS_ORDERS; k++)
            for (unsigned i = 0; i <= n; i++) {
                int64_t row[COUNT], column[COUNT];
                for (unsigned j = 0; j <= n; j++) {
                    row[j] = (int64_t)exact_of(net[i * (n + 1) + j].axis[axis]);
                    column[j] = (int64_t)exact_of(net[j * (n + 1) + i].axis[axis]);
                }
                const int64_t x = difference_of(row, n, k / 2, k % 2),
                              y = difference_of(column, n, k / 2, k % 2);
                w->p[k][i].axis[axis] = loft_real_from_int((int32_t)x);
                w->p[2 * LOFT_COONS_ORDERS + k][i].axis[axis] = loft_real_from_int((int32_t)y);
                w->reach = fmaxl(w->reach, fmaxl((long double)llabs(x), (long double)llabs(y)));
            }
    for (unsigned k = 0; k < 2 * LOFT_COONS_ORDERS; k++)
        CHECK(loft_bezier_init(&w->u[k / 2][k % 2], w->p[k], n) == LOFT_OK &&
              loft_bezier_init(&w->v[k / 2][k % 2], w->p[2 * LOFT_COONS_ORDERS + k], n) == LOFT_OK);
}

static loft_real arb_whole(arb *a, int32_t limit)
{
    return loft_real_from_int((int32_t)arb_below(a, 2 * (uint32_t)limit + 1) - limit);
}

static void arb_web(arb *a, web *w, unsigned n, int32_t limit)
{
    loft_vec net[COUNT * COUNT];

    for (unsigned k = 0; k < COUNT * COUNT; k++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            net[k].axis[axis] = arb_whole(a, limit);
    web_of(w, net, n);
}

static loft_coons_bezier patch_of(const web *w, unsigned orders)
{
    loft_coons_bezier c;

    CHECK(loft_coons_bezier_init(&c, (const loft_bezier(*)[2])w->u, (const loft_bezier(*)[2])w->v,
                                 orders, 0) == LOFT_OK);
    return c;
}

/* The bounds of coons.h for point or derivative; reach is the largest control value. */
static long double error_of(unsigned n, bool derivative, long double reach)
{
    const long double steps = n + 1, q16 = derivative ? 14 * n * n + 120 : 3 * n + 20;
    const long double wide[2] = { q16 * 0x1p-33L, (derivative ? 512 * steps : 64) * steps * steps *
                                                      ulp_double(reach) };

    return BY_NUM(LSB / 2, ulp(reach * 8), 0) + wide[BY_NUM(0, 1, 1)];
}

/* Values and slopes across equal those of the eight curves, anywhere along them. */
static void slopes_are_followed(arb *a)
{
    const unsigned orders = 2 + arb_below(a, 2), n = orders + arb_below(a, 5);
    const loft_unit t = arb_unit(a);
    web w;
    loft_vec p = { { 0 } };

    arb_web(a, &w, n, 20);
    const loft_coons_bezier c = patch_of(&w, orders);
    CHECK(loft_coons_bezier_meets(&c, 0));
    for (unsigned k = 0; k < 2; k++)
        for (int end = 0; end < 2; end++) {
            const loft_unit at = end ? LOFT_UNIT(1) : 0;
            CHECK(loft_coons_bezier_deriv(&c, 0, k, t, at, &p) == LOFT_OK);
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_EXACT(exact_of(p.axis[i]), exact_axis(&w.u[k][end], i, 0, exact_unit(t)),
                            error_of(n, k, w.reach));
            CHECK(loft_coons_bezier_deriv(&c, k, 0, at, t, &p) == LOFT_OK);
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_EXACT(exact_of(p.axis[i]), exact_axis(&w.v[k][end], i, 0, exact_unit(t)),
                            error_of(n, k, w.reach));
        }
}

/* The blending functions of values, slopes and curvatures at 0 and 1: coefficients of their
 * powers. */
static const int *powers_of(unsigned which, unsigned orders)
{
    static const int cubic[4][6] = {
        { 1, 0, -3, 2 }, { 0, 0, 3, -2 }, { 0, 1, -2, 1 }, { 0, 0, -1, 1 }
    };
    static const int quintic[6][6] = { { 2, 0, 0, -20, 30, -12 }, { 0, 0, 0, 20, -30, 12 },
                                       { 0, 2, 0, -12, 16, -6 },  { 0, 0, 0, -8, 14, -6 },
                                       { 0, 0, 1, -3, 3, -1 },    { 0, 0, 0, 1, -2, 1 } };
    static const int linear[2][6] = { { 1, -1 }, { 0, 1 } };

    return orders == 1 ? linear[which] : orders == 2 ? cubic[which] : quintic[which];
}

/* Differentiated k = 0, 1 or 2 times. */
static long double blend_of(unsigned which, unsigned orders, unsigned k, long double t)
{
    const int *c = powers_of(which, orders);
    long double sum = 0;

    for (int n = 5; n >= (int)k; n--)
        sum = sum * t + (k == 0 ? 1 : k == 1 ? n : n * (n - 1)) * c[n];
    return orders == 3 ? sum / 2 : sum;
}

/* Against the definition in long double: all first derivatives, all orders. */
static void patches_keep_their_bound(arb *a)
{
    const unsigned orders = 1 + arb_below(a, 3), n = 2 + arb_below(a, 8);
    const loft_unit s = arb_unit(a), t = arb_unit(a);
    const long double x = exact_unit(s), y = exact_unit(t);
    web w;

    arb_web(a, &w, n, n > 5 ? 4 : 30);
    const loft_coons_bezier c = patch_of(&w, orders);
    for (unsigned d = 0; d < 4; d++) {
        loft_vec p = { { 0 } };
        CHECK(loft_coons_bezier_deriv(&c, d / 2, d % 2, s, t, &p) == LOFT_OK);
        for (int i = 0; i < LOFT_AXES; i++) {
            long double want = 0;
            for (unsigned k = 0; k < 2 * orders; k++) {
                want += blend_of(k, orders, d % 2, y) * exact_axis(&w.u[k / 2][k % 2], i, d / 2, x);
                want += blend_of(k, orders, d / 2, x) * exact_axis(&w.v[k / 2][k % 2], i, d % 2, y);
                for (unsigned m = 0; m < 2 * orders; m++)
                    want -= blend_of(k, orders, d / 2, x) * blend_of(m, orders, d % 2, y) *
                            exact_axis(&w.u[m / 2][m % 2], i, k / 2, k % 2);
            }
            CHECK_EXACT(exact_of(p.axis[i]), want, error_of(n, d > 0, w.reach));
        }
    }
}

/* The largest Bernstein coefficient of the k-th derivative. */
static long double widest(const long double c[], unsigned n, unsigned k)
{
    long double w[COUNT], most = 0, factor = 1;

    if (k > n)
        return 0;
    for (unsigned i = 0; i <= n; i++)
        w[i] = c[i];
    for (; k > 0; k--, n--) {
        factor *= n;
        for (unsigned i = 0; i < n; i++)
            w[i] = w[i + 1] - w[i];
    }
    for (unsigned i = 0; i <= n; i++)
        most = fmaxl(most, fabsl(w[i]));
    return most * factor;
}

static long double blend_width(unsigned which, unsigned orders, unsigned k)
{
    const unsigned degree = 2 * orders - 1;
    const int *power = powers_of(which, orders);
    long double c[COUNT];

    for (unsigned i = 0; i <= degree; i++) {
        c[i] = 0;
        for (unsigned j = 0; j <= i; j++)
            c[i] += (long double)power[j] * loft_binomial(i, j) / loft_binomial(degree, j);
        c[i] /= orders == 3 ? 2 : 1;
    }
    return widest(c, degree, k);
}

/* Points are relative to the first corner. */
static long double curve_width(const web *w, const loft_bezier *b, int axis, unsigned which,
                               unsigned k)
{
    const long double origin = which < 2 ? exact_of(w->p[0][0].axis[axis]) : 0;
    long double c[COUNT];

    for (unsigned i = 0; i <= b->degree; i++)
        c[i] = exact_of(b->p[i].axis[axis]) - origin;
    return widest(c, b->degree, k);
}

/* The derivative of the Boolean sum, and the sum of the largest values of its parts. */
static long double sum_of(const web *w, unsigned orders, int axis, const uint8_t order[2],
                          long double x, long double y, long double *width)
{
    const unsigned j = order[0], k = order[1];
    long double sum = 0;

    *width = 0;
    for (unsigned a = 0; a < 2 * orders; a++) {
        const loft_bezier *u = &w->u[a / 2][a % 2], *v = &w->v[a / 2][a % 2];
        sum += blend_of(a, orders, k, y) * exact_axis(u, axis, j, x);
        sum += blend_of(a, orders, j, x) * exact_axis(v, axis, k, y);
        *width += blend_width(a, orders, k) * curve_width(w, u, axis, a, j);
        *width += blend_width(a, orders, j) * curve_width(w, v, axis, a, k);
        for (unsigned b = 0; b < 2 * orders; b++) {
            const loft_bezier *across = &w->u[b / 2][b % 2];
            const long double corner = exact_axis(across, axis, a / 2, a % 2);
            const long double from = b < 2 && a < 2 ? exact_of(w->p[0][0].axis[axis]) : 0;
            sum -= blend_of(a, orders, j, x) * blend_of(b, orders, k, y) * corner;
            *width += blend_width(a, orders, j) * blend_width(b, orders, k) * fabsl(corner - from);
        }
    }
    return sum;
}

/* All five derivatives, for curves that agree at their corners or not, near the origin or far. */
static void local_derivatives_keep_their_law(arb *a)
{
    const unsigned orders = 1 + arb_below(a, 3), n = 1 + arb_below(a, 9);
    const bool agree = arb_below(a, 2);
    const loft_unit s = arb_unit(a), t = arb_unit(a);
    const long double x = exact_unit(s), y = exact_unit(t);
    const long double law = 16 * BY_NUM(0x1p-59L, 0x1p-50L, 0x1p-50L);
    long double widths[2] = { 0, 0 };
    loft_differential here;
    web w;

    arb_web(a, &w, n, n > 5 ? 4 : 30);
    for (unsigned k = 2; k < 2 * LOFT_COONS_ORDERS && !agree; k++)
        for (unsigned i = 0; i <= n; i++)
            w.p[k][i] = arb_vec(a, 1000);
    loft_coons_bezier c = patch_of(&w, orders);
    CHECK(loft_coons_bezier_differential(&c, s, t, &here) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci got[5] = { here.u[i], here.v[i], here.uu[i], here.uv[i], here.vv[i] };
        static const uint8_t order[5][2] = { { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } };
        for (int k = 0; k < 5; k++) {
            long double width;
            const long double want = sum_of(&w, orders, i, order[k], x, y, &width);
            CHECK_EXACT(exact_sci(got[k]), want, law * width + 0x1p-57L * w.reach);
            if (k < 2)
                widths[k] = fmaxl(widths[k], width);
        }
    }
    CHECK_EXACT(exact_sci(here.width_u), widths[0], 1e-9L * widths[0]);
    CHECK_EXACT(exact_sci(here.width_v), widths[1], 1e-9L * widths[1]);
    CHECK(loft_coons_bezier_differential(&c, LOFT_UNIT(1.5), t, &here) == LOFT_ERR_ARG);
    CHECK(loft_coons_bezier_differential(&c, s, LOFT_UNIT(-1), &here) == LOFT_ERR_ARG);
}

/* A bilinear, bicubic or biquintic tensor product reproduces itself, with its curvatures. */
static void bends_as_the_tensor_product_it_is(arb *a)
{
    const unsigned orders = 1 + arb_below(a, 3), n = 2 * orders - 1;
    const loft_unit s = loft_unit_of(arb_below(a, 65), 64), t = loft_unit_of(arb_below(a, 65), 64);
    loft_vec net[36], normal[2] = { { { 0 } }, { { 0 } } };
    loft_differential here[2];
    loft_curvatures k[2];
    loft_tensor tensor;
    web w;

    for (unsigned i = 0; i < (n + 1) * (n + 1); i++) {
        const int32_t place[3] = { (int32_t)(i / (n + 1)), (int32_t)(i % (n + 1)), 0 };
        net[i] = (loft_vec) { { 0 } };
        for (int axis = 0; axis < 3; axis++)
            net[i].axis[axis] = loft_real_from_int(40 * place[axis]) + arb_whole(a, 10);
    }
    web_of(&w, net, n);
    const loft_coons_bezier c = patch_of(&w, orders);
    CHECK(loft_tensor_init(&tensor, net, n, n) == LOFT_OK);
    CHECK(loft_tensor_differential(&tensor, s, t, &here[0]) == LOFT_OK);
    CHECK(loft_coons_bezier_differential(&c, s, t, &here[1]) == LOFT_OK);
    for (int i = 0; i < 2; i++) {
        CHECK(loft_differential_normal(&here[i], &normal[i]) == LOFT_OK);
        CHECK(loft_differential_curvatures(&here[i], &k[i]) == LOFT_OK);
    }
    for (int i = 0; i < 3; i++)
        CHECK_EXACT(exact_of(normal[0].axis[i]), exact_of(normal[1].axis[i]),
                    BY_NUM(LSB, 0x1p-23L, 0x1p-36L));
    CHECK_EXACT(exact_acc(k[0].gauss), exact_acc(k[1].gauss), BY_NUM(0x1p-30L, 0x1p-30L, 0x1p-30L));
    CHECK_EXACT(exact_acc(k[0].mean), exact_acc(k[1].mean), BY_NUM(0x1p-30L, 0x1p-30L, 0x1p-30L));
}

/* A tensor product of degree 3 x 3, or 5 x 5, reproduces itself with slopes, or curvatures. */
static void reproduces_its_own_degree(arb *a)
{
    const unsigned orders = 1 + arb_below(a, 3), n = 2 * orders - 1;
    const loft_unit s = arb_unit(a), t = arb_unit(a);
    loft_vec p = { { 0 } };
    web w;

    arb_web(a, &w, n, 20);
    const loft_coons_bezier c = patch_of(&w, orders);
    CHECK(loft_coons_bezier_eval(&c, s, t, &p) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double e[6];               /* along v at s, from what is known at its ends */
        long double want = 0;
        for (unsigned k = 0; k < 2 * orders; k++)
            e[k] = exact_axis(&w.u[k / 2][k % 2], i, 0, exact_unit(s));
        for (unsigned k = 0; k < 2 * orders; k++)
            want += blend_of(k, orders, 0, exact_unit(t)) * e[k];
        CHECK_EXACT(exact_of(p.axis[i]), want, error_of(n, false, w.reach));
    }
}

/* Twists that disagree are noticed; the patch then still follows the curves along v. */
static void twists_that_disagree_favour_v(arb *a)
{
    const unsigned n = 3;
    const loft_unit t = arb_unit(a);
    loft_vec p = { { 0 } };
    web w;

    arb_web(a, &w, n, 20);
    w.p[2][1].axis[0] += LOFT_REAL(1);          /* the slope along u at v = 0 bends: its twist at u
                                                 * = 0 is 3 more */
    const loft_coons_bezier c = patch_of(&w, 2);
    CHECK(!loft_coons_bezier_meets(&c, LOFT_REAL(2.9)) &&
          loft_coons_bezier_meets(&c, LOFT_REAL(3.1)));
    for (unsigned k = 0; k < 2; k++)
        for (int end = 0; end < 2; end++) {
            CHECK(loft_coons_bezier_deriv(&c, k, 0, end ? LOFT_UNIT(1) : 0, t, &p) == LOFT_OK);
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_EXACT(exact_of(p.axis[i]), exact_axis(&w.v[k][end], i, 0, exact_unit(t)),
                            error_of(n, k, w.reach));
        }
}

/* Nothing wraps with the largest numbers: there is a result or a report. */
static void extremes_are_reported(arb *a)
{
    static web w;
    const unsigned orders = 2 + arb_below(a, 2);
    loft_vec p = { { 0 } };

    arb_web(a, &w, 9, 1);
    for (unsigned k = 0; k < 4 * LOFT_COONS_ORDERS; k++)
        for (int i = 0; i < COUNT; i++)
            for (int axis = 0; axis < LOFT_AXES; axis++)
                w.p[k][i].axis[axis] = arb_below(a, 2) ? LOFT_REAL(32767) : LOFT_REAL(-32767);
    for (int axis = 0; axis < LOFT_AXES; axis++)
        for (int k = 0; k < 4; k++)
            w.p[2 * LOFT_COONS_ORDERS + k % 2][k < 2 ? 0 : 9].axis[axis] =
                w.p[k < 2 ? 0 : 1][k % 2 ? 9 : 0].axis[axis];
    const loft_coons_bezier c = patch_of(&w, orders);
    for (unsigned d = 0; d < 4; d++) {
        const enum loft_status status = loft_coons_bezier_deriv(&c, d / 2, d % 2, arb_unit(a),
                                                                arb_unit(a), &p);
        CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    }
}

int main(void)
{
    PROPERTY(boundary_is_followed, 300);
    PROPERTY(bilinear_keeps_its_bound, 1000);
    PROPERTY(tensor_is_the_same_patch, 200);
    PROPERTY(blended_tensors_are_the_same_patch, 60);
    PROPERTY(moves_with_its_curves, 200);
    PROPERTY(any_curve_is_a_side, 200);
    PROPERTY(refuses_curves_that_do_not_meet, 50);
    PROPERTY(slopes_are_followed, 300);
    PROPERTY(patches_keep_their_bound, 400);
    PROPERTY(local_derivatives_keep_their_law, 400);
    PROPERTY(bends_as_the_tensor_product_it_is, 300);
    PROPERTY(reproduces_its_own_degree, 200);
    PROPERTY(twists_that_disagree_favour_v, 50);
    PROPERTY(extremes_are_reported, 100);
    return check_failures();
}

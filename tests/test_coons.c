/* tests/test_coons.c -- properties of lib/surface/coons.h
 * SPDX-License-Identifier: MIT
 */
#include "exact.h"
#include "surface/coons.h"

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
    const loft_side s[4] = { loft_side_from_bezier(&f->b[0]), loft_side_from_bezier(&f->b[1]), loft_side_from_bezier(&f->b[2]), loft_side_from_bezier(&f->b[3]) };
    const loft_bezier u[1][2] = { { f->b[0], f->b[1] } }, v[1][2] = { { f->b[2], f->b[3] } };

    CHECK(loft_coons_init(c, s, s + 2, 0) == LOFT_OK && loft_coons_bezier_init(cb, u, v, 1, 0) == LOFT_OK);
}

static long double exact_axis(const loft_bezier *b, int axis, unsigned k, long double t)
{
    long double c[COUNT];

    for (unsigned i = 0; i <= b->degree; i++)
        c[i] = exact_of(b->p[i].axis[axis]);
    return exact_deriv(c, b->degree, k, t);
}

static unsigned highest(unsigned m, unsigned n) { return m > n ? m : n; }

/* The sides themselves, whatever the degree: in q16 bit for bit those of loft_bezier_eval. */
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
        CHECK(loft_coons_eval(&c, s, r, &p) == LOFT_OK && loft_coons_bezier_eval(&cb, s, r, &q) == LOFT_OK);
        const loft_vec want = loft_bezier_eval(&f.b[k], t);
        for (int i = 0; i < LOFT_AXES; i++) {
            CHECK_EXACT(exact_of(p.axis[i]), exact_of(want.axis[i]), BY_NUM(0, ulp(32767) / 2, 4 * ulp(32767)));
            CHECK_EXACT(exact_of(q.axis[i]), exact_of(want.axis[i]), BY_NUM(0, ulp(32767) / 2, 4 * ulp(32767)));
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
    const enum loft_status status[2] = { loft_coons_eval(&c, s, t, &p[0]), loft_coons_bezier_eval(&cb, s, t, &p[1]) };
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double corners = (1 - x) * ((1 - y) * exact_of(f.p[0][0].axis[i]) + y * exact_of(f.p[1][0].axis[i]))
                                  + x * ((1 - y) * exact_of(f.p[0][m].axis[i]) + y * exact_of(f.p[1][m].axis[i]));
        const long double want = (1 - y) * exact_axis(&f.b[0], i, 0, x) + y * exact_axis(&f.b[1], i, 0, x)
                               + (1 - x) * exact_axis(&f.b[2], i, 0, y) + x * exact_axis(&f.b[3], i, 0, y) - corners;
        fits = fits && want > BY_NUM(-32768 - LSB / 2, -INFINITY, -INFINITY) && want < BY_NUM(32768 - LSB / 2, INFINITY, INFINITY);
        for (int k = 0; k < 2 && status[k] == LOFT_OK; k++)
            CHECK_EXACT(exact_of(p[k].axis[i]), want, BY_NUM(LSB / 2, ulp(want) / 2 + ulp(limit) / 2, 0)
                        + (BY_NUM(4, 0, 16) + BY_NUM(2, 0, 6) * highest(m, n)) * BY_NUM(0x1p-33L, 0, ulp(limit)));
    }
    CHECK(status[0] == (fits ? LOFT_OK : LOFT_ERR_RANGE) && status[1] == status[0]);
}

/* The net of the boundary polygons is the same patch, and its boundary theirs. */
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
        CHECK(BY_NUM(loft_vec_equal(net[i * (n + 1)], f.p[0][i]) && loft_vec_equal(net[i * (n + 1) + n], f.p[1][i]), true, true));
    for (unsigned j = 0; j <= n; j++)
        CHECK(BY_NUM(loft_vec_equal(net[j], f.p[2][j]) && loft_vec_equal(net[m * (n + 1) + j], f.p[3][j]), true, true));
    for (int i = 0; i < LOFT_AXES; i++) {
        long double rows[COUNT], column[COUNT];
        for (unsigned r = 0; r <= m; r++) {
            for (unsigned k = 0; k <= n; k++)
                column[k] = exact_of(net[r * (n + 1) + k].axis[i]);
            rows[r] = exact_eval(column, n, exact_unit(t));
        }
        CHECK_EXACT(exact_of(p.axis[i]), exact_eval(rows, m, exact_unit(s)), BY_NUM(1.001L, 2, 40 + 6 * highest(m, n)) * ulp(15000));
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
        CHECK_EXACT(exact_of(q.axis[i]), exact_of(p.axis[i]) + exact_of(d.axis[i]), BY_NUM(0, 3 * ulp(12000), 200 * ulp(12000)));
}

/* Curves that are not Bezier curves: a straight B-spline of one span and a rational curve of equal weights are known. */
static void any_curve_is_a_side(arb *a)
{
    const loft_real knots[8] = { LOFT_REAL(-2), LOFT_REAL(-2), LOFT_REAL(-2), LOFT_REAL(-2), LOFT_REAL(6), LOFT_REAL(6), LOFT_REAL(6), LOFT_REAL(6) };
    const loft_unit s = loft_unit_of(arb_below(a, 1025), 1024), t = loft_unit_of(arb_below(a, 1025), 1024);
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
    CHECK(loft_rational_init(&r, w[0], 3) == LOFT_OK && loft_bspline_init(&b, f.p[1], 4, knots, 3) == LOFT_OK);
    CHECK(loft_nurbs_init(&nurbs, w[1], 4, knots, 3) == LOFT_OK);
    const loft_side u[2] = { loft_side_from_rational(&r), loft_side_from_bspline(&b) };
    const loft_side v[2] = { loft_side_from_nurbs(&nurbs), loft_side_from_bezier(&f.b[3]) };
    CHECK(loft_coons_init(&other, u, v, BY_NUM(0, LOFT_REAL(0.01), LOFT_REAL(1e-9))) == LOFT_OK);
    CHECK(loft_coons_eval(&c, s, t, &p) == LOFT_OK && loft_coons_eval(&other, s, t, &q) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]), BY_NUM(2.1L * LSB, 8 * ulp(15000), 400 * ulp(15000)));
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
    const loft_side s[4] = { loft_side_from_bezier(&f.b[0]), loft_side_from_bezier(&f.b[1]), loft_side_from_bezier(&f.b[2]), loft_side_from_bezier(&f.b[3]) };
    loft_bezier u[1][2] = { { f.b[0], f.b[1] } }, v[1][2] = { { f.b[2], f.b[3] } };
    CHECK(loft_coons_init(&c, s, s + 2, LOFT_REAL(0.25)) == LOFT_ERR_ARG && loft_coons_init(&c, s, s + 2, LOFT_REAL(0.75)) == LOFT_OK);
    CHECK(loft_coons_bezier_init(&cb, (const loft_bezier (*)[2])u, (const loft_bezier (*)[2])v, 1, LOFT_REAL(0.25)) == LOFT_ERR_ARG);
    CHECK(loft_coons_bezier_init(&cb, (const loft_bezier (*)[2])u, (const loft_bezier (*)[2])v, 1, LOFT_REAL(0.75)) == LOFT_OK);
    CHECK(loft_coons_bezier_init(&cb, (const loft_bezier (*)[2])u, (const loft_bezier (*)[2])v, 0, LOFT_REAL(1)) == LOFT_ERR_ARG);
    CHECK(loft_coons_bezier_init(&cb, (const loft_bezier (*)[2])u, (const loft_bezier (*)[2])v, 4, LOFT_REAL(1)) == LOFT_ERR_ARG);
    CHECK(loft_coons_eval(&c, LOFT_UNIT(1.1), 0, &p) == LOFT_ERR_ARG && loft_coons_bezier_eval(&cb, 0, LOFT_UNIT(-0.1), &p) == LOFT_ERR_ARG);
    cb.u[0][1].degree++;
    CHECK(loft_tensor_from_coons(&cb, net) == LOFT_ERR_ARG);
}


/* Slopes and curvatures: curves taken from a tensor product agree at the corners, and the patch takes on all of them. */

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

/* An n x n net of whole millimetres, and its derivatives by v at v = 0, 1 along u, and by u along v. */
static void arb_web(arb *a, web *w, unsigned n, int32_t limit)
{
    w->degree = n;
    w->reach = 0;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        int64_t net[COUNT][COUNT];
        for (unsigned k = 0; k < COUNT * COUNT; k++)
            net[k / COUNT][k % COUNT] = (int64_t)arb_below(a, 2 * (uint32_t)limit + 1) - limit;
        for (unsigned k = 0; k < 2 * LOFT_COONS_ORDERS; k++)
            for (unsigned i = 0; i <= n; i++) {
                int64_t row[COUNT], column[COUNT];
                for (unsigned j = 0; j <= n; j++) {
                    row[j] = net[i][j];
                    column[j] = net[j][i];
                }
                const int64_t x = difference_of(row, n, k / 2, k % 2), y = difference_of(column, n, k / 2, k % 2);
                w->p[k][i].axis[axis] = loft_real_from_int((int32_t)x);
                w->p[2 * LOFT_COONS_ORDERS + k][i].axis[axis] = loft_real_from_int((int32_t)y);
                w->reach = fmaxl(w->reach, fmaxl((long double)llabs(x), (long double)llabs(y)));
            }
    }
    for (unsigned k = 0; k < 2 * LOFT_COONS_ORDERS; k++)
        CHECK(loft_bezier_init(&w->u[k / 2][k % 2], w->p[k], n) == LOFT_OK
           && loft_bezier_init(&w->v[k / 2][k % 2], w->p[2 * LOFT_COONS_ORDERS + k], n) == LOFT_OK);
}

static loft_coons_bezier patch_of(const web *w, unsigned orders)
{
    loft_coons_bezier c;

    CHECK(loft_coons_bezier_init(&c, (const loft_bezier (*)[2])w->u, (const loft_bezier (*)[2])w->v, orders, 0) == LOFT_OK);
    return c;
}

/* The bounds of coons.h for point or derivative; reach is the largest control value. */
static long double error_of(unsigned n, bool derivative, long double reach)
{
    const long double steps = n + 1, q16 = derivative ? 14 * n * n + 120 : 3 * n + 20;
    const long double wide[2] = { q16 * 0x1p-33L, (derivative ? 512 * steps : 64) * steps * steps * ulp_double(reach) };

    return BY_NUM(LSB / 2, ulp(reach * 8), 0) + wide[BY_NUM(0, 1, 1)];
}

/* Values, and slopes across, are those of the eight curves, wherever along them. */
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
                CHECK_EXACT(exact_of(p.axis[i]), exact_axis(&w.u[k][end], i, 0, exact_unit(t)), error_of(n, k, w.reach));
            CHECK(loft_coons_bezier_deriv(&c, k, 0, at, t, &p) == LOFT_OK);
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_EXACT(exact_of(p.axis[i]), exact_axis(&w.v[k][end], i, 0, exact_unit(t)), error_of(n, k, w.reach));
        }
}

/* The blends of values, slopes and curvatures at 0 and 1, k = 0 or 1 times derived. */
static long double blend_of(unsigned which, unsigned orders, unsigned k, long double t)
{
    static const int cubic[4][6] = { { 1, 0, -3, 2 }, { 0, 0, 3, -2 }, { 0, 1, -2, 1 }, { 0, 0, -1, 1 } };
    static const int quintic[6][6] = { { 2, 0, 0, -20, 30, -12 }, { 0, 0, 0, 20, -30, 12 }, { 0, 2, 0, -12, 16, -6 }, { 0, 0, 0, -8, 14, -6 },
                                       { 0, 0, 1, -3, 3, -1 }, { 0, 0, 0, 1, -2, 1 } };
    static const int linear[2][6] = { { 1, -1 }, { 0, 1 } };
    const int *c = orders == 1 ? linear[which] : orders == 2 ? cubic[which] : quintic[which];
    long double sum = 0;

    for (int n = 5; n >= (int)k; n--)
        sum = sum * t + (k ? n * c[n] : c[n]);
    return orders == 3 ? sum / 2 : sum;
}

/* Against the definition in long double, all derivatives to the first, all orders. */
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
                    want -= blend_of(k, orders, d / 2, x) * blend_of(m, orders, d % 2, y) * exact_axis(&w.u[m / 2][m % 2], i, k / 2, k % 2);
            }
            CHECK_EXACT(exact_of(p.axis[i]), want, error_of(n, d > 0, w.reach));
        }
    }
}

/* A tensor product of degree 3 x 3, or 5 x 5, is its own patch with slopes, or curvatures. */
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

/* Twists that disagree are noticed, and then the curves along v are followed all the same. */
static void twists_that_disagree_favour_v(arb *a)
{
    const unsigned n = 3;
    const loft_unit t = arb_unit(a);
    loft_vec p = { { 0 } };
    web w;

    arb_web(a, &w, n, 20);
    w.p[2][1].axis[0] += LOFT_REAL(1);          /* the slope along u at v = 0 bends: its twist at u = 0 is 3 more */
    const loft_coons_bezier c = patch_of(&w, 2);
    CHECK(!loft_coons_bezier_meets(&c, LOFT_REAL(2.9)) && loft_coons_bezier_meets(&c, LOFT_REAL(3.1)));
    for (unsigned k = 0; k < 2; k++)
        for (int end = 0; end < 2; end++) {
            CHECK(loft_coons_bezier_deriv(&c, k, 0, end ? LOFT_UNIT(1) : 0, t, &p) == LOFT_OK);
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_EXACT(exact_of(p.axis[i]), exact_axis(&w.v[k][end], i, 0, exact_unit(t)), error_of(n, k, w.reach));
        }
}

/* Nothing wraps with the largest numbers there are: a result or a report. */
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
            w.p[2 * LOFT_COONS_ORDERS + k % 2][k < 2 ? 0 : 9].axis[axis] = w.p[k < 2 ? 0 : 1][k % 2 ? 9 : 0].axis[axis];
    const loft_coons_bezier c = patch_of(&w, orders);
    for (unsigned d = 0; d < 4; d++) {
        const enum loft_status status = loft_coons_bezier_deriv(&c, d / 2, d % 2, arb_unit(a), arb_unit(a), &p);
        CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    }
}

int main(void)
{
    PROPERTY(boundary_is_followed, 300);
    PROPERTY(bilinear_keeps_its_bound, 1000);
    PROPERTY(tensor_is_the_same_patch, 200);
    PROPERTY(moves_with_its_curves, 200);
    PROPERTY(any_curve_is_a_side, 200);
    PROPERTY(refuses_curves_that_do_not_meet, 50);
    PROPERTY(slopes_are_followed, 300);
    PROPERTY(patches_keep_their_bound, 400);
    PROPERTY(reproduces_its_own_degree, 200);
    PROPERTY(twists_that_disagree_favour_v, 50);
    PROPERTY(extremes_are_reported, 100);
    return check_failures();
}

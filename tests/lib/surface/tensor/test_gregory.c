/* tests/lib/surface/tensor/test_gregory.c -- properties of lib/surface/tensor/gregory.h
 * SPDX-License-Identifier: MIT
 *
 * The reference differentiates the formula with quotients, in 113 bits, number by number.
 */
#include "support/exact_spline.h"       /* quad, check_result; CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/gregory.h"
#include "surface/tensor/tensor.h"

/* A function of u and v: value, u, v, uu, uv, vv. */
typedef struct {
    quad d[6];
} jet;

static jet jet_of(quad f) { return (jet){ { f } }; }

static jet plus(jet a, jet b, quad scale)
{
    for (int i = 0; i < 6; i++)
        a.d[i] += scale * b.d[i];
    return a;
}

static jet times(jet a, jet b)
{
    const quad *x = a.d, *y = b.d;
    return (jet){ { x[0] * y[0], x[1] * y[0] + x[0] * y[1], x[2] * y[0] + x[0] * y[2],
                    x[3] * y[0] + 2 * x[1] * y[1] + x[0] * y[3],
                    x[4] * y[0] + x[1] * y[2] + x[2] * y[1] + x[0] * y[4],
                    x[5] * y[0] + 2 * x[2] * y[2] + x[0] * y[5] } };
}

static jet inverse(jet a)
{
    const quad f = 1 / a.d[0], g = -f * f, h = 2 * f * f * f;
    return (jet){ { f, g * a.d[1], g * a.d[2], g * a.d[3] + h * a.d[1] * a.d[1],
                    g * a.d[4] + h * a.d[1] * a.d[2], g * a.d[5] + h * a.d[2] * a.d[2] } };
}

static jet bernstein(int k, jet t)
{
    const jet rest = plus(jet_of(1), t, -1);
    jet b = jet_of(k == 1 || k == 2 ? 3 : 1);
    for (int i = 0; i < 3; i++)
        b = times(b, i < k ? t : rest);
    return b;
}

static jet inner_point(const loft_vec p[], int i, int j, int axis, jet u, jet v)
{
    const jet s = i == 1 ? u : plus(jet_of(1), u, -1), t = j == 1 ? v : plus(jet_of(1), v, -1);
    const quad one = quad_of(p[4 * i + j].axis[axis]),
               two = quad_of(p[16 + 2 * (i - 1) + j - 1].axis[axis]);
    return times(plus(times(s, jet_of(one)), t, two), inverse(plus(s, t, 1)));
}

static jet reference(const loft_vec p[], int axis, loft_unit u, loft_unit v)
{
    const jet x = { { (quad)exact_unit(u), 1 } }, y = { { (quad)exact_unit(v), 0, 1 } };
    jet sum = jet_of(0);

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            const bool inner = (i == 1 || i == 2) && (j == 1 || j == 2);
            const jet b = inner ? inner_point(p, i, j, axis, x, y)
                                : jet_of(quad_of(p[4 * i + j].axis[axis]));
            sum = plus(sum, times(times(bernstein(i, x), bernstein(j, y)), b), 1);
        }
    return sum;
}

static const int order_of[6][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } };

/* Also close to the sides and the corners. */
static loft_unit arb_place(arb *a)
{
    const loft_unit t = arb_unit(a);

    switch (arb_below(a, 4)) {
    case 0:  return t / 4096;
    case 1:  return LOFT_UNIT(1) - t / 4096;
    default: return t;
    }
}

static bool at_corner(loft_unit u, loft_unit v)
{
    return (u <= 0 || u >= LOFT_UNIT(1)) && (v <= 0 || v >= LOFT_UNIT(1));
}

static void points_and_derivatives_are_within_their_bound(arb *a)
{
    static const long double grow[3] = { 1, 12, 90 };
    const int32_t size = 1 << arb_below(a, 15);
    loft_vec p[LOFT_GREGORY_POINTS];
    loft_gregory g;

    for (int k = 0; k < LOFT_GREGORY_POINTS; k++)
        p[k] = arb_vec(a, size);
    CHECK(loft_gregory_init(&g, p) == LOFT_OK);
    const loft_unit u = arb_place(a), v = arb_place(a);
    if (at_corner(u, v))
        return;
    for (int o = 0; o < 6; o++) {
        quad want[LOFT_AXES];
        loft_vec got = { { 0 } };
        const long double f = grow[order_of[o][0] + order_of[o][1]];
        for (int i = 0; i < LOFT_AXES; i++)
            want[i] = reference(p, i, u, v).d[o];
        check_result(
            loft_gregory_deriv(&g, (unsigned)order_of[o][0], (unsigned)order_of[o][1], u, v, &got),
            &got, want, 0.5L + f * 0x1p-20L,
            bound_by_num(0, f * 0x1p-16L * ulp(size), 32 * f * ulp(size)));
    }
}

static void the_differential_is_that_of_the_formula(arb *a)
{
    loft_vec p[LOFT_GREGORY_POINTS];
    loft_differential d;
    loft_gregory g;

    for (int k = 0; k < LOFT_GREGORY_POINTS; k++)
        p[k] = arb_vec(a, 100);
    CHECK(loft_gregory_init(&g, p) == LOFT_OK);
    const loft_unit u = arb_place(a), v = arb_place(a);
    if (at_corner(u, v)) {
        CHECK(loft_gregory_differential(&g, u, v, &d) == LOFT_SINGULAR);
        return;
    }
    CHECK(loft_gregory_differential(&g, u, v, &d) == LOFT_OK);
    const long double room = BY_NUM(0x1p-52L, 0x1p-44L, 0x1p-44L) *
                             (long double)quad_sci(d.width_u);
    for (int i = 0; i < LOFT_AXES; i++) {
        const jet want = reference(p, i, u, v);
        const loft_sci got[5] = { d.u[i], d.v[i], d.uu[i], d.uv[i], d.vv[i] };
        for (int o = 0; o < 5; o++)
            CHECK_EXACT((long double)(quad_sci(got[o]) - want.d[o + 1]), 0, (o < 2 ? 1 : 8) * room);
    }
}

/* With both inner points in one it is the bicubic patch, at the corners too. */
static void with_one_inner_point_it_is_bicubic(arb *a)
{
    loft_vec p[LOFT_GREGORY_POINTS];
    loft_gregory g;
    loft_tensor t;

    for (int k = 0; k < 16; k++)
        p[k] = arb_vec(a, 100);
    for (int k = 0; k < 4; k++)
        p[16 + k] = p[4 * (1 + k / 2) + 1 + k % 2];
    CHECK(loft_gregory_init(&g, p) == LOFT_OK && loft_tensor_init(&t, p, 3, 3) == LOFT_OK);
    const loft_unit u = arb_below(a, 2) ? arb_unit(a) : LOFT_UNIT(1) * (loft_unit)arb_below(a, 2),
                    v = arb_below(a, 2) ? arb_unit(a) : LOFT_UNIT(1) * (loft_unit)arb_below(a, 2);
    for (unsigned o = 0; o < 6; o++) {
        loft_vec x = { { 0 } }, y = { { 0 } };
        const unsigned j = (unsigned)order_of[o][0], k = (unsigned)order_of[o][1];
        CHECK(loft_gregory_deriv(&g, j, k, u, v, &x) == LOFT_OK &&
              loft_tensor_deriv(&t, j, k, u, v, &y) == LOFT_OK);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(exact_of(x.axis[i]), exact_of(y.axis[i]),
                        bound_by_num(1.1L * LSB, 2 * ulp(4096), 4096 * ulp(1024)));
    }
}

/* Curves and slopes of random twists: every side has its own, exactly. */
static void all_sides_keep_curves_and_slopes(arb *a)
{
    loft_vec p[LOFT_GREGORY_POINTS], c[4][4], d[4][4];
    loft_bezier u[2][2], v[2][2];
    loft_coons_bezier coons;
    loft_gregory g;

    for (int k = 0; k < 16; k++)        /* the curves: u at v = 0, v = 1; v at u = 0, u = 1 */
        c[k / 4][k % 4] = arb_vec(a, 100);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            c[2 + i][3 * j] = c[j][3 * i];
    for (int k = 0; k < 4; k++) {
        const int other = k < 2 ? 2 : 0, end = k % 2;
        d[k][1] = arb_vec(a, 100);
        d[k][2] = arb_vec(a, 100);
        for (int side = 0; side < 2; side++)
            for (int i = 0; i < LOFT_AXES; i++)
                d[k][3 * side].axis[i] = 3 * (c[other + side][end ? 3 : 1].axis[i] -
                                              c[other + side][end ? 2 : 0].axis[i]);
    }
    for (int end = 0; end < 2; end++)
        CHECK(loft_bezier_init(&u[0][end], c[end], 3) == LOFT_OK &&
              loft_bezier_init(&u[1][end], d[end], 3) == LOFT_OK &&
              loft_bezier_init(&v[0][end], c[2 + end], 3) == LOFT_OK &&
              loft_bezier_init(&v[1][end], d[2 + end], 3) == LOFT_OK);
    CHECK(loft_coons_bezier_init(&coons, (const loft_bezier(*)[2])u, (const loft_bezier(*)[2])v, 2,
                                 0) == LOFT_OK);
    CHECK(loft_gregory_from_coons(&coons, p) == LOFT_OK && loft_gregory_init(&g, p) == LOFT_OK);
    for (int k = 0; k < 4; k++) {
        const loft_unit t = arb_unit(a), end = LOFT_UNIT(1) * (loft_unit)(k % 2);
        const loft_unit s = k < 2 ? t : end, r = k < 2 ? end : t;
        const loft_bezier *curve = k < 2 ? &u[0][k] : &v[0][k - 2],
                          *slope = k < 2 ? &u[1][k] : &v[1][k - 2];
        loft_vec x = { { 0 } }, y = { { 0 } };
        CHECK(loft_gregory_eval(&g, s, r, &x) == LOFT_OK &&
              loft_gregory_deriv(&g, k >= 2, k < 2, s, r, &y) == LOFT_OK);
        const loft_vec on = loft_bezier_eval(curve, t), across = loft_bezier_eval(slope, t);
        for (int i = 0; i < LOFT_AXES; i++) {
            CHECK_EXACT(exact_of(x.axis[i]), exact_of(on.axis[i]),
                        bound_by_num(LSB, ulp(128), 8 * ulp(128)));
            CHECK_EXACT(exact_of(y.axis[i]), exact_of(across.axis[i]),     /* 3 times 1/2 LSB */
                        bound_by_num(2.6L * LSB, 8 * ulp(1024), 64 * ulp(1024)));
        }
    }
    coons.orders = 1;
    CHECK(loft_gregory_from_coons(&coons, p) == LOFT_ERR_ARG);
}

static void mistakes_are_refused(arb *a)
{
    loft_vec p[LOFT_GREGORY_POINTS], x = { { 0 } };
    loft_gregory g;

    for (int k = 0; k < LOFT_GREGORY_POINTS; k++)
        p[k] = arb_vec(a, 100);
    CHECK(loft_gregory_init(&g, p) == LOFT_OK);
    CHECK(loft_gregory_eval(&g, LOFT_UNIT(1.5), 0, &x) == LOFT_ERR_ARG &&
          loft_gregory_eval(&g, 0, LOFT_UNIT(-0.5), &x) == LOFT_ERR_ARG &&
          loft_gregory_deriv(&g, 2, 1, 0, 0, &x) == LOFT_ERR_ARG &&
          loft_gregory_deriv(&g, 1, 1, 0, LOFT_UNIT(1), &x) == LOFT_SINGULAR &&
          loft_gregory_deriv(&g, 1, 0, 0, LOFT_UNIT(1), &x) == LOFT_OK);
    p[7].axis[0] = BY_NUM(0, INFINITY, INFINITY);
    CHECK(loft_gregory_init(&g, p) == BY_NUM(LOFT_OK, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
}

int main(void)
{
    PROPERTY(points_and_derivatives_are_within_their_bound, 2000);
    PROPERTY(the_differential_is_that_of_the_formula,       1000);
    PROPERTY(with_one_inner_point_it_is_bicubic,             500);
    PROPERTY(all_sides_keep_curves_and_slopes,               500);
    PROPERTY(mistakes_are_refused,                            50);
    return check_failures();
}

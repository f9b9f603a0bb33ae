/* tests/lib/curve/test_self_crossings.c -- properties of lib/curve/self_crossings.h
 * SPDX-License-Identifier: MIT
 */
#include "curve/self_crossings.h"
#include "curve/shape.h"
#include "support/exact.h"          /* exact_eval; CHECK, PROPERTY */

#if LOFT_AXES < 2
#  error "curves in the plane"
#endif

#define MOST (LOFT_DEGREE_MAX + 1)
#define ROOM 40

typedef struct {
    loft_vec p[MOST];
    loft_bezier b;
} curve;

static void arb_plane(arb *a, curve *c, unsigned n)
{
    for (unsigned k = 0; k <= n; k++) {
        c->p[k] = (loft_vec){ { 0 } };
        for (int axis = 0; axis < 2; axis++)
            c->p[k].axis[axis] = arb_real(a, 50);
    }
    CHECK(loft_bezier_init(&c->b, c->p, n) == LOFT_OK);
}

static long double at(const curve *c, int axis, long double t)
{
    long double x[MOST];

    for (unsigned k = 0; k <= c->b.degree; k++)
        x[k] = exact_of(c->p[k].axis[axis]);
    return exact_eval(x, c->b.degree, t);
}

/* The loop of a cubic, as shape.h decides it. */
static void the_loop_of_a_cubic_is_found(arb *a)
{
    const loft_real tol = LOFT_REAL(0.0078125);
    loft_crossing out[ROOM];
    loft_cubic cubic;
    loft_shape s;
    size_t count;
    curve c;

    arb_plane(a, &c, 3);
    for (int k = 0; k < 4; k++)
        cubic.p[k] = c.p[k];
    if (loft_cubic_shape(&cubic, &s) != LOFT_OK || s.kind == LOFT_LINE || s.kind == LOFT_POINT)
        return;
    const enum loft_status status = loft_bezier_self_crossings(&c.b, tol, out, ROOM, &count);
    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    CHECK(count <= 1);
    if (s.loops == 1 && exact_unit(s.loop[1]) - exact_unit(s.loop[0]) > 0.05L) {
        bool found = false;
        for (size_t k = 0; k < count; k++)
            found = found || (fabsl(exact_unit(out[k].s) - exact_unit(s.loop[0])) < 0.02L &&
                              fabsl(exact_unit(out[k].t) - exact_unit(s.loop[1])) < 0.02L);
        CHECK(found);
    }
}

/* A number as near to x as the type holds it on a grid of 2^-12. */
static loft_real real_near(double x)
{
    return loft_real_from_int(1) / 4096 * (loft_real)(int32_t)floor(x * 4096 + 0.5);
}

/* Control points of degree 3 or 4 whose derivative is (t - u) times another polynomial. */
static void arb_cusp(arb *a, curve *c, double u)
{
    const unsigned n = 3 + arb_below(a, 2);
    double at[2] = { 0, 0 };

    c->p[0] = (loft_vec){ { 0 } };
    double v[2][3];
    for (int axis = 0; axis < 2; axis++)
        for (unsigned k = 0; k <= n - 2; k++)
            v[axis][k] = (double)arb_below(a, 400) - 200;
    for (unsigned k = 0; k < n; k++) {          /* Bernstein products: (t - u) is -u, 1 - u */
        c->p[k + 1] = (loft_vec){ { 0 } };
        for (int axis = 0; axis < 2; axis++) {
            const double low = k <= n - 2 ? -u * v[axis][k] * (n - 1 - k) / (n - 1) : 0,
                         high = k > 0 ? (1 - u) * v[axis][k - 1] * k / (n - 1) : 0;
            at[axis] += (low + high) / n;
            c->p[k + 1].axis[axis] = real_near(at[axis]);
        }
    }
    CHECK(loft_bezier_init(&c->b, c->p, n) == LOFT_OK);
}

/* Points of a curve on both sides of a cusp are near each other, and no crossing. */
static void a_cusp_is_no_crossing(arb *a)
{
    const loft_real tol = LOFT_REAL(0.0078125);
    const double u = arb_below(a, 3) == 0 ? 0.5 : 0.1 + 0.8 * arb_below(a, 1000) / 1000.0;
    loft_crossing out[ROOM];
    size_t count;
    curve c;

    arb_cusp(a, &c, u);
    CHECK(loft_bezier_self_crossings(&c.b, tol, out, ROOM, &count) >= 0);
    for (size_t k = 0; k < count; k++)
        CHECK(exact_unit(out[k].t_from) < u - 0.01 || exact_unit(out[k].s_to) > u + 0.01 ||
              exact_unit(out[k].t) - exact_unit(out[k].s) > 0.1L);
    CHECK(count <= (c.b.degree == 3 ? 0u : 2u));
}

/* The two sides of a bend narrower than tol are no crossing, however long they are. */
static void a_narrow_bend_is_no_crossing(arb *a)
{
    const loft_real tol = LOFT_REAL(0.0625);
    loft_crossing out[ROOM];
    size_t count;
    curve c;

    arb_plane(a, &c, 2);
    c.p[0].axis[0] = c.p[2].axis[0] = 0;
    c.p[1].axis[0] = loft_real_from_int(1 + (int32_t)arb_below(a, 100));
    for (int k = 0; k < 3; k++)
        c.p[k].axis[1] = tol / 128 * (loft_real)(k * (1 + (int32_t)arb_below(a, 30)));
    CHECK(loft_bezier_self_crossings(&c.b, tol, out, ROOM, &count) == LOFT_OK && count == 0);
}

/* Chords of the curve that cross are near a crossing; at a crossing both points are within tol. */
static void each_crossing_of_chords_is_near_one(arb *a)
{
    enum { N = 160 };
    const loft_real tol = LOFT_REAL(0.0625);
    long double x[N + 1], y[N + 1];
    loft_crossing out[ROOM];
    size_t count;
    curve c;

    arb_plane(a, &c, 4 + arb_below(a, LOFT_DEGREE_MAX - 3));
    const enum loft_status status = loft_bezier_self_crossings(&c.b, tol, out, ROOM, &count);
    if (status != LOFT_OK)
        return;
    for (size_t k = 0; k < count; k++) {
        const long double s = exact_unit(out[k].s), t = exact_unit(out[k].t);
        CHECK(s < t);
        CHECK(hypotl(at(&c, 0, s) - at(&c, 0, t), at(&c, 1, s) - at(&c, 1, t)) <
              exact_of(tol) + 0x1p-12L);
    }
    for (int i = 0; i <= N; i++) {
        x[i] = at(&c, 0, (long double)i / N);
        y[i] = at(&c, 1, (long double)i / N);
    }
    for (int i = 0; i < N; i++)
        for (int j = i + 2; j < N; j++) {
            const long double ux = x[i + 1] - x[i], uy = y[i + 1] - y[i], vx = x[j + 1] - x[j],
                              vy = y[j + 1] - y[j], wx = x[j] - x[i], wy = y[j] - y[i],
                              det = ux * vy - uy * vx;
            const long double s = (wx * vy - wy * vx) / det, t = (wx * uy - wy * ux) / det;
            if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1) || j - i < N / 16 ||
                fabsl(det) < 0.5L * hypotl(ux, uy) * hypotl(vx, vy))
                continue;
            bool found = false;
            for (size_t k = 0; k < count; k++)
                found = found || (fabsl(exact_unit(out[k].s) * N - i - s) < 2 &&
                                  fabsl(exact_unit(out[k].t) * N - j - t) < 2);
            CHECK(found);
        }
}

/* An arch has none; a closed curve meets itself at its ends. */
static void arches_have_none_and_ends_meet(arb *a)
{
    const int32_t wide = 5 + (int32_t)arb_below(a, 50);
    loft_crossing out[ROOM];
    size_t count;
    curve c;

    arb_plane(a, &c, 4);
    for (int k = 0; k < 5; k++) {
        c.p[k].axis[0] = loft_real_from_int(wide * k);
        c.p[k].axis[1] = loft_real_from_int(wide * (k == 0 || k == 4 ? 0 : 3));
    }
    CHECK(loft_bezier_self_crossings(&c.b, LOFT_REAL(0.01), out, ROOM, &count) == LOFT_OK &&
          count == 0);
    c.p[4].axis[0] = 0;
    CHECK(loft_bezier_self_crossings(&c.b, LOFT_REAL(0.01), out, ROOM, &count) == LOFT_OK &&
          count == 1 && out[0].s == 0 && out[0].t == LOFT_UNIT(1));
    CHECK(loft_bezier_self_crossings(&c.b, 0, out, ROOM, &count) == LOFT_ERR_ARG && count == 0);
    CHECK(loft_bezier_self_crossings(&c.b, LOFT_REAL(0.01), out, 0, &count) == LOFT_MORE);
}

/* A projective map of a polynomial curve: with the weights f(p) = 1 + x / 200 the points p / f(p).
 * It takes crossings to crossings, at the same parameters. */
static void weights_of_a_projection_keep_parameters(arb *a)
{
    const loft_real tol = LOFT_REAL(0.0625);
    loft_weighted w[MOST];
    loft_crossing plain[ROOM], out[ROOM];
    size_t count, more;
    loft_rational r;
    curve c;

    arb_plane(a, &c, 3 + arb_below(a, LOFT_DEGREE_MAX - 2));
    for (unsigned k = 0; k <= c.b.degree; k++) {
        const loft_real f = LOFT_REAL(1) + c.p[k].axis[0] / 200;
        w[k] = (loft_weighted){ { { 0 } }, f };
        for (int axis = 0; axis < 2; axis++)
            w[k].p.axis[axis] = loft_div(c.p[k].axis[axis], f);
    }
    CHECK(loft_rational_init(&r, w, c.b.degree) == LOFT_OK);
    const enum loft_status one = loft_bezier_self_crossings(&c.b, tol, plain, ROOM, &count),
                           two = loft_rational_self_crossings(&r, tol, out, ROOM, &more);
    CHECK(two >= 0);
    for (size_t k = 0; k < more; k++) {
        const loft_vec s = loft_rational_eval(&r, out[k].s), t = loft_rational_eval(&r, out[k].t);
        CHECK(out[k].s < out[k].t && (k == 0 || out[k - 1].s <= out[k].s));
        CHECK(exact_acc(loft_vec_distance(s, t)) < exact_of(tol) + 0x1p-12L);
    }
    for (size_t k = 0; one == LOFT_OK && two == LOFT_OK && k < count; k++) {
        const long double wide = exact_unit(plain[k].s_to) - exact_unit(plain[k].s_from);
        long double off = INFINITY;
        if (wide > 0.01L || exact_unit(plain[k].t) - exact_unit(plain[k].s) < 0.06L)
            continue;
        for (size_t j = 0; j < more; j++)
            off = fminl(off, fmaxl(fabsl(exact_unit(out[j].s) - exact_unit(plain[k].s)),
                                   fabsl(exact_unit(out[j].t) - exact_unit(plain[k].t))));
        CHECK(off < 0.02L);
    }
    CHECK(loft_rational_self_crossings(&r, 0, out, ROOM, &more) == LOFT_ERR_ARG && more == 0);
    const enum loft_status fine = loft_rational_self_crossings(&r, LOFT_REAL(0x1p-15), out, ROOM,
                                                               &more);
    CHECK(BY_NUM(fine == LOFT_ERR_RANGE, fine == LOFT_ERR_RANGE, fine >= 0));
}

int main(void)
{
    PROPERTY(the_loop_of_a_cubic_is_found, 200);
    PROPERTY(a_cusp_is_no_crossing, 200);
    PROPERTY(a_narrow_bend_is_no_crossing, 30);
    PROPERTY(each_crossing_of_chords_is_near_one, 60);
    PROPERTY(arches_have_none_and_ends_meet, 30);
    PROPERTY(weights_of_a_projection_keep_parameters, 60);
    return check_failures();
}

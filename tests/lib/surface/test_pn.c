/* tests/lib/surface/test_pn.c -- properties of lib/surface/pn.h
 * SPDX-License-Identifier: MIT
 */
#include "support/triangles.h"          /* arb_bary, by_kind */
#include "surface/pn.h"
#include "surface/triangle/triangle.h"

typedef struct {
    loft_vec p[3], n[3];
    long double largest;
    loft_pn t;
} shell;

static shell *arb_shell(arb *a)
{
    static shell s;
    const int32_t limit = 1 << arb_below(a, 14), long_normal = 1 << arb_below(a, 15);

    do {
        s.largest = 0;
        for (int k = 0; k < 3; k++) {
            s.p[k] = arb_vec(a, limit);
            s.n[k] = arb_vec(a, long_normal);
            for (int i = 0; i < LOFT_AXES; i++)
                s.largest = fmaxl(s.largest, fabsl(exact_of(s.p[k].axis[i])));
        }
    } while (loft_pn_init(&s.t, s.p, s.n) != LOFT_OK);
    return &s;
}

static long double dot(const long double x[], const long double y[])
{
    long double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += x[i] * y[i];
    return sum;
}

static void take(loft_vec v, long double x[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = exact_of(v.axis[i]);
}

static void control_points_are_within_their_bound(arb *a)
{
    static const unsigned place[3][3] = { { 0, 1, 2 }, { 3, 6, 7 }, { 5, 8, 9 } };
    const shell *s = arb_shell(a);
    const loft_bary u = arb_bary(a);
    long double p[3][LOFT_AXES], n[3][LOFT_AXES], b[10][LOFT_AXES], at[3][3];
    loft_vec net[10];

    for (int k = 0; k < 3; k++) {
        take(s->p[k], p[k]);
        take(s->n[k], n[k]);
        exact_bary(u, false, at[k]);
    }
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++) {
            long double e[LOFT_AXES];
            for (int i = 0; i < LOFT_AXES; i++)
                e[i] = p[j][i] - p[k][i];
            const long double foot = dot(e, n[k]) / dot(n[k], n[k]);
            for (int i = 0; i < LOFT_AXES; i++)
                b[place[k][j]][i] = (2 * p[k][i] + p[j][i] - foot * n[k][i]) / 3;
        }
    loft_pn_net(&s->t, net);
    const loft_vec v = loft_pn_eval(&s->t, u);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double c[10], ring = 0;
        for (int k = 0; k < 10; k++)
            ring += k == 4 || k == 0 || k == 6 || k == 9 ? 0 : b[k][i] / 6;
        b[4][i] = ring + (ring - (p[0][i] + p[1][i] + p[2][i]) / 3) / 2;
        for (int k = 0; k < 10; k++) {
            CHECK_EXACT(exact_of(net[k].axis[i]), b[k][i],
                        by_kind((0.5L + 0x1p-15L) * LSB, ulp(b[k][i]) / 2 + s->largest * 0x1p-49L));
            c[k] = b[k][i];
        }
        const long double want = exact_polar(c, 3, at);
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    by_kind((0.5L + 0x1p-14L) * LSB, ulp(want) / 2 + s->largest * 0x1p-48L));
    }
}

/* The reference is its own wide control points; inside it is eval. */
static void the_cubic_goes_on_beyond_the_triangle(arb *a)
{
    const shell *s = arb_shell(a);
    const loft_bary u = arb_far(a, arb_below(a, 2) ? 2 : 16), in = arb_bary(a);
    const long double l = growth3(u), cube = l * l * l;
    long double at[3][3], c[10];
    bool all = true, none = true;
    loft_vec v, w;

    CHECK(loft_pn_extrapolate(&s->t, in, &v) == LOFT_OK &&
          loft_vec_equal(v, loft_pn_eval(&s->t, in)));
    for (int k = 0; k < 3; k++)
        exact_bary(u, false, at[k]);
    const enum loft_status status = loft_pn_extrapolate(&s->t, u, &w);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (int k = 0; k < 10; k++)
            c[k] = exact_acc(s->t.b[i][k]);
        const long double want = exact_polar(c, 3, at);
        all = all && exact_fits(want) == 1;
        none = none && exact_fits(want) != 0;
        if (status == LOFT_OK)
            CHECK_EXACT(exact_of(w.axis[i]), want,
                        by_kind(LSB / 2 + (l * l + l + 1) * LSB / 131072 + 0x1p-40L,
                                ulp(want) / 2 + cube * s->largest * 0x1p-48L));
    }
    CHECK(status == LOFT_OK ? none && l < 27.001L
                            : status == LOFT_ERR_RANGE && (!all || l > 26.999L));
}

/* The surface passes through the points, at a right angle to the normals. */
static void points_and_normals_are_interpolated(arb *a)
{
    static const loft_bary corner[3] = { { 0, 0 }, { LOFT_UNIT(1), 0 }, { 0, LOFT_UNIT(1) } };
    static const unsigned own[3] = { 0, 6, 9 }, next[3][2] = { { 1, 2 }, { 3, 7 }, { 5, 8 } };
    const shell *s = arb_shell(a);
    loft_vec v;

    for (int k = 0; k < 3; k++) {
        long double n[LOFT_AXES], m[LOFT_AXES], e[LOFT_AXES];
        CHECK(loft_vec_equal(loft_pn_eval(&s->t, corner[k]), s->p[k]));
        CHECK(loft_pn_normal(&s->t, corner[k], &v) == LOFT_OK);
        take(s->n[k], n);
        take(v, m);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(m[i], n[i] / sqrtl(dot(n, n)),
                        BY_NUM(1.01L * LSB, 2 * ulp(1), 16 * ulp(1)));
        for (int side = 0; side < 2; side++) {
            for (int i = 0; i < LOFT_AXES; i++)
                e[i] = exact_acc(s->t.b[i][next[k][side]]) - exact_acc(s->t.b[i][own[k]]);
            CHECK_EXACT(dot(e, n) / sqrtl(dot(n, n)), 0, by_kind(0x1p-31L, s->largest * 0x1p-47L));
        }
    }
}

/* The normal has length 1, and equals that of the neighbour across an edge, which has the same two
 * corners. */
static void neighbours_meet_along_an_edge(arb *a)
{
    const shell *s = arb_shell(a);
    const loft_unit v = arb_unit(a);
    const loft_bary here = { v, 0 }, there = { 0, LOFT_UNIT(1) - v };
    const loft_vec p[3] = { s->p[1], arb_vec(a, 100), s->p[0] },
                   n[3] = { s->n[1], arb_vec(a, 3), s->n[0] };
    loft_vec x, y;
    loft_pn other;

    if (loft_pn_init(&other, p, n) != LOFT_OK)
        return;
    x = loft_pn_eval(&s->t, here);
    y = loft_pn_eval(&other, there);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(x.axis[i]), exact_of(y.axis[i]),
                    BY_NUM(LSB, ulp(s->largest), 32 * ulp(s->largest)));
    if (loft_pn_normal(&s->t, here, &x) == LOFT_OK) {
        long double m[LOFT_AXES];
        take(x, m);
        CHECK_EXACT(dot(m, m), 1, BY_NUM(4 * LSB, 4 * ulp(1), 32 * ulp(1)));
    }
}

/* A flat triangle stays flat if the normals are at a right angle to it. */
static void a_flat_triangle_stays_flat(arb *a)
{
    loft_vec p[3], n[3];
    loft_pn t;

    for (int k = 0; k < 3; k++) {
        p[k] = arb_vec(a, 10000);
        n[k] = (loft_vec) { { 0 } };
        p[k].axis[2] = LOFT_REAL(3);
        n[k].axis[2] = LOFT_REAL(k + 1);
    }
    const loft_bary u = arb_bary(a);
    CHECK(loft_pn_init(&t, p, n) == LOFT_OK);
    const loft_vec v = loft_pn_eval(&t, u);
    long double x[3];
    exact_bary(u, false, x);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double want = x[0] * exact_of(p[0].axis[i]) + x[1] * exact_of(p[1].axis[i]) +
                                 x[2] * exact_of(p[2].axis[i]);
        CHECK_EXACT(exact_of(v.axis[i]), want,
                    by_kind((0.5L + 0x1p-14L) * LSB, ulp(want) / 2 + 10000 * 0x1p-48L));
    }
}

static void degenerate_triangles_are_answered(arb *a)
{
    const loft_vec null = { { 0 } };
    shell *s = arb_shell(a);
    loft_vec p[3] = { s->p[0], s->p[0], s->p[0] }, n[3] = { s->n[0], s->n[1], s->n[2] }, v;
    const loft_bary u = { LOFT_UNIT(0.25), LOFT_UNIT(0.5) };
    loft_pn t;

    CHECK(loft_pn_init(&t, p, n) == LOFT_OK && loft_vec_equal(loft_pn_eval(&t, u), p[0]));
    n[arb_below(a, 3)] = null;
    CHECK(loft_pn_init(&t, p, n) == LOFT_SINGULAR);
    n[0] = n[1] = n[2] = null;
    n[0].axis[0] = n[1].axis[0] = n[2].axis[0] = LOFT_REAL(1);
    n[1].axis[0] = n[2].axis[0] = LOFT_REAL(-1);
    p[1] = p[2] = p[0];
    if (loft_pn_init(&t, p, n) == LOFT_OK)
        CHECK(loft_pn_normal(&t, (loft_bary) { LOFT_UNIT(0.5), 0 }, &v) == LOFT_SINGULAR);
}

/* Control points beyond the range of coordinates. */
static void what_does_not_fit_is_refused(arb *a)
{
    const loft_real most = BY_NUM(INT32_MAX, FLT_MAX, (loft_real)DBL_MAX);
    loft_vec p[3] = { { { 0 } }, { { 0 } }, { { 0 } } }, n[3] = { { { 0 } }, { { 0 } }, { { 0 } } };
    loft_pn t;

    (void)a;
    for (int k = 0; k < 3; k++) {
        p[k].axis[0] = k ? -most : most;
        p[k].axis[1] = most;
        n[k].axis[0] = n[k].axis[1] = LOFT_REAL(1);
    }
    p[2].axis[1] = -most;
    CHECK(loft_pn_init(&t, p, n) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(control_points_are_within_their_bound,   1200);
    PROPERTY(the_cubic_goes_on_beyond_the_triangle, 1000);
    PROPERTY(points_and_normals_are_interpolated,     1200);
    PROPERTY(neighbours_meet_along_an_edge,           1200);
    PROPERTY(a_flat_triangle_stays_flat,              800);
    PROPERTY(degenerate_triangles_are_answered,       400);
    PROPERTY(what_does_not_fit_is_refused,              1);
    return check_failures();
}

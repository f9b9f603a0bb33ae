/* tests/lib/polygon/test_spatch_triangle.c -- properties of lib/polygon/spatch_triangle.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"                              /* CHECK, PROPERTY, BY_NUM */
#include "support/exact.h"                      /* exact_of, exact_unit */
#include "polygon/spatch_triangle.h"
#include "surface/triangle/triangle_rational.h" /* loft_triangle_rational_eval */

#define POINTS 60

typedef struct {
    loft_vec p[POINTS];
    loft_real w[POINTS];
    loft_spot v[LOFT_SIDES_MAX];
    loft_domain domain;
    loft_spatch patch;
} scene;

/* Points of any place within 100, weights 1/4 to 4 or none, over a polygon near a regular one. */
static scene *arb_scene(arb *a)
{
    static const uint8_t deepest[LOFT_SIDES_MAX + 1] = { 0, 0, 0, 9, 4, 3, 2, 1, 1 };
    static scene x;
    const unsigned sides = 3 + arb_below(a, 6), depth = 1 + arb_below(a, deepest[sides]),
                   count = loft_multiindex_count(sides, depth);
    const bool weighted = arb_below(a, 2);

    for (unsigned i = 0; i < sides; i++)
        for (int k = 0; k < 2; k++)
            x.v[i].at[k] = LOFT_REAL(
                (double)(20 * (k ? sinl : cosl)(2 * acosl(-1) * (long double)i / sides) +
                         arb_below(a, 1001) / 500.0L));
    CHECK(loft_domain_init(&x.domain, x.v, sides) == LOFT_OK && x.domain.convex);
    for (unsigned k = 0; k < count; k++) {
        for (int axis = 0; axis < LOFT_AXES; axis++)
            x.p[k].axis[axis] = arb_real(a, 100);
        x.w[k] = LOFT_REAL(0.25 + arb_below(a, 376) / 100.0);
    }
    CHECK(loft_spatch_init(&x.patch, x.p, weighted ? x.w : NULL, sides, depth) == LOFT_OK);
    return &x;
}

static long double area_of(const long double a[2], const long double b[2], const long double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* The definition: Wachspress coordinates, then the sum. */
static void point_at(const scene *x, const long double at[2], long double out[LOFT_AXES])
{
    const unsigned n = x->patch.sides;
    long double v[LOFT_SIDES_MAX][2], phi[LOFT_SIDES_MAX], all = 0, under = 0;
    uint8_t l[LOFT_SIDES_MAX];
    unsigned rank = 0;

    for (unsigned i = 0; i < n; i++)
        for (int k = 0; k < 2; k++)
            v[i][k] = exact_of(x->v[i].at[k]);
    for (unsigned i = 0; i < n; i++) {
        phi[i] = area_of(v[(i + n - 1) % n], v[i], v[(i + 1) % n]);
        for (unsigned j = 0; j < n; j++)
            if (j != i && (j + 1) % n != i)
                phi[i] *= area_of(v[j], v[(j + 1) % n], at);
        all += phi[i];
    }
    for (int axis = 0; axis < LOFT_AXES; axis++)
        out[axis] = 0;
    loft_multiindex_first(l, n, x->patch.depth);
    do {
        long double term = loft_multiindex_multinomial(l, n) *
                           (x->patch.w ? exact_of(x->w[rank]) : 1);
        for (unsigned i = 0; i < n; i++)
            term *= powl(phi[i] / all, l[i]);
        under += term;
        for (int axis = 0; axis < LOFT_AXES; axis++)
            out[axis] += term * exact_of(x->p[rank].axis[axis]);
        rank++;
    } while (loft_multiindex_next(l, n));
    for (int axis = 0; axis < LOFT_AXES; axis++)
        out[axis] /= under;
}

static void a_triangle_is_the_patch(arb *a)
{
    const scene *x = arb_scene(a);
    const unsigned n = x->patch.sides, edge = arb_below(a, n), degree = x->patch.depth * (n - 2);
    const loft_bary u = { LOFT_UNIT(arb_below(a, 513) / 1024.0),
                          LOFT_UNIT(arb_below(a, 513) / 1024.0) };
    const long double share[2] = { exact_unit(u.v), exact_unit(u.w) };
    loft_weighted p[LOFT_SPATCH_TRIANGLE_MAX];
    loft_triangle_rational t;
    long double at[2] = { 0, 0 }, want[LOFT_AXES], least = 256;

    CHECK(loft_spatch_triangle(&x->patch, &x->domain, edge, p) == LOFT_OK);
    CHECK(loft_triangle_rational_init(&t, p, degree) == LOFT_OK);
    for (int k = 0; k < 2; k++) {
        for (unsigned i = 0; i < n; i++)
            at[k] += exact_of(x->v[i].at[k]) / n;
        at[k] = (1 - share[0] - share[1]) * at[k] + share[0] * exact_of(x->v[edge].at[k]) +
                share[1] * exact_of(x->v[(edge + 1) % n].at[k]);
    }
    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(degree); k++)
        least = fminl(least, exact_of(p[k].w));
    point_at(x, at, want);
    const loft_vec got = loft_triangle_rational_eval(&t, u);
    const long double reach = 200 * sqrtl(LOFT_AXES);
    for (int axis = 0; axis < LOFT_AXES; axis++)
        CHECK_EXACT(exact_of(got.axis[axis]), want[axis],
                    BY_NUM(1.01L / 65536 + reach * (0x1p-17L / least + 0x1p-48L),
                           reach * 0x1p-22L + 0x1p-15L, reach * 0x1p-40L + 0x1p-44L));
}

static void corners_are_points_of_the_net(arb *a)
{
    const scene *x = arb_scene(a);
    const unsigned n = x->patch.sides, edge = arb_below(a, n), degree = x->patch.depth * (n - 2);
    loft_weighted p[LOFT_SPATCH_TRIANGLE_MAX];

    CHECK(loft_spatch_triangle(&x->patch, &x->domain, edge, p) == LOFT_OK);
    for (unsigned k = 0; k < 2; k++) {
        uint8_t l[LOFT_SIDES_MAX] = { 0 };
        l[(edge + k) % n] = x->patch.depth;
        const loft_vec *got = &p[loft_triangle_place(k ? 0 : degree, k ? degree : 0)].p,
                       *want = &x->p[loft_multiindex_rank(l, n)];
        for (int axis = 0; axis < LOFT_AXES; axis++)
            CHECK_EXACT(exact_of(got->axis[axis]), exact_of(want->axis[axis]),
                        BY_NUM(0, 0x1p-17L, 0x1p-44L));
    }
}

static void what_is_no_such_triangle_is_refused(arb *a)
{
    scene *x = arb_scene(a);
    loft_weighted p[LOFT_SPATCH_TRIANGLE_MAX];
    loft_spatch other = x->patch;

    CHECK(loft_spatch_triangle(&x->patch, &x->domain, x->patch.sides, p) == LOFT_ERR_ARG);
    other.depth = 9;
    CHECK(x->patch.sides == 3 || loft_spatch_triangle(&other, &x->domain, 0, p) == LOFT_ERR_ARG);
    x->domain.convex = false;
    CHECK(loft_spatch_triangle(&x->patch, &x->domain, 0, p) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_triangle_is_the_patch, 500);
    PROPERTY(corners_are_points_of_the_net, 100);
    PROPERTY(what_is_no_such_triangle_is_refused, 20);
    return check_failures();
}

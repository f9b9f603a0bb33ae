/* tests/lib/polygon/test_toric_tensor.c -- properties of lib/polygon/toric_tensor.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"                              /* CHECK, PROPERTY, BY_NUM */
#include "support/exact_sci.h"                  /* exact_sci, exact_of, exact_unit */
#include "support/lattices.h"                  /* arb_lattice, lattice_height */
#include "polygon/toric_tensor.h"

#define POINTS 100

typedef struct {
    loft_vec p[POINTS];
    loft_real c[POINTS], w[POINTS];
    loft_lattice_polygon lattice;
    loft_toric patch;
    unsigned count, vertex;
    loft_weighted net[LOFT_TORIC_TENSOR_MAX];
    loft_tensor_rational s;
} scene;

static scene x;

static void hold_lattice(arb *a, loft_lattice_polygon l)
{
    x.lattice = l;
    x.count = loft_lattice_polygon_count(&x.lattice);
    x.vertex = arb_below(a, x.lattice.sides);
    CHECK(x.count <= POINTS);
}

/* Points within `limit`, weights 1/4 to 4 or none, coefficients 1 to 30 or none. */
static void arb_scene(arb *a, int32_t limit)
{
    loft_lattice_polygon l = arb_lattice(a);

    while (lattice_height(&l) > LOFT_DEGREE_MAX)
        l = arb_lattice(a);
    hold_lattice(a, l);
    for (unsigned k = 0; k < x.count; k++) {
        x.p[k] = arb_vec(a, limit);
        x.c[k] = loft_real_from_int(1 + (int32_t)arb_below(a, 30));
        x.w[k] = LOFT_REAL(0.25 + arb_below(a, 376) / 100.0);
    }
    const bool factors = arb_below(a, 2), weights = arb_below(a, 2);
    CHECK(loft_toric_init(&x.patch, &x.lattice, x.p, factors ? x.c : NULL, weights ? x.w : NULL) ==
          LOFT_OK);
    CHECK(loft_toric_tensor(&x.patch, x.vertex, x.net, &x.s) == LOFT_OK);
}

static unsigned edge_of(int side)
{
    return (x.vertex + (side ? 0 : x.lattice.sides - 1)) % x.lattice.sides;
}

static long double factor_of(unsigned k)
{
    return (x.patch.c ? exact_of(x.c[k]) : 1) * (x.patch.w ? exact_of(x.w[k]) : 1);
}

/* a or b of the header. */
static long double balance_of(int side)
{
    long double all = 0, on = 0;
    loft_whole l;
    unsigned k = 0;

    loft_lattice_polygon_first(&x.lattice, &l);
    do {
        all += factor_of(k);
        on += loft_lattice_polygon_height(&x.lattice, edge_of(side), l) ? 0 : factor_of(k);
        k++;
    } while (loft_lattice_polygon_next(&x.lattice, &l));
    return powl(all / on, 1.0L / (side ? x.s.n : x.s.m));
}

/* The largest distance of two points, or more; the smallest weight; the largest coordinate. */
static long double reach_of(long double *least, long double *most)
{
    long double sum = 0;

    *least = 256;
    *most = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        long double low = exact_of(x.p[0].axis[i]), high = low;
        for (unsigned k = 1; k < x.count; k++) {
            low = fminl(low, exact_of(x.p[k].axis[i]));
            high = fmaxl(high, exact_of(x.p[k].axis[i]));
        }
        sum += (high - low) * (high - low);
        *most = fmaxl(*most, fmaxl(high, -low));
    }
    for (unsigned k = 0; k < (x.s.m + 1u) * (x.s.n + 1u); k++)
        *least = fminl(*least, exact_of(x.net[k].w));
    return sqrtl(sum);
}

/* The bounds of this header and of loft_tensor_rational_eval. */
static long double bound_of(long double reach, long double least, long double most)
{
    const long double n = x.count, bound[3] = {
        1.01L * LSB + reach * 0x1p-17L / least + most * n * 0x1p-59L,
        2 * ulp(most) + reach * 0x1p-22L,
        (n + 6 * (x.s.m + x.s.n) + 5) * ulp(most) + reach * 0x1p-50L,
    };
    return bound[BY_NUM(0, 1, 2)];
}

/* The sum over monomials: s and t of the header. */
static void a_patch_is_the_sum_of_monomials(arb *a)
{
    arb_scene(a, arb_below(a, 3) ? 100 : 32767);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const long double one = exact_unit(u), two = exact_unit(v),
                      s = one / (one + balance_of(0) * (1 - one)),
                      t = two / (two + balance_of(1) * (1 - two));
    const loft_vec got = loft_tensor_rational_eval(&x.s, u, v);
    long double want[LOFT_AXES] = { 0 }, under = 0, least, most;
    loft_whole l;
    unsigned k = 0;

    loft_lattice_polygon_first(&x.lattice, &l);
    do {
        const long double term =
            factor_of(k) *
            powl(s, (long double)loft_lattice_polygon_height(&x.lattice, edge_of(0), l)) *
            powl(t, (long double)loft_lattice_polygon_height(&x.lattice, edge_of(1), l));
        under += term;
        for (int i = 0; i < LOFT_AXES; i++)
            want[i] += term * exact_of(x.p[k].axis[i]);
        k++;
    } while (loft_lattice_polygon_next(&x.lattice, &l));
    const long double reach = reach_of(&least, &most);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(got.axis[i]), want[i] / under, bound_of(reach, least, most));
    for (int side = 0; side < 2; side++)
        CHECK_EXACT(exact_sci(loft_toric_balance(&x.patch, edge_of(side))), balance_of(side),
                    balance_of(side) * BY_NUM(0x1p-55L, 0x1p-46L, 0x1p-46L));
}

/* log s or log t of the header, negated, in the cone of the vertex. */
static bool cone_of(const long double sum[2], long double out[2])
{
    const loft_whole *e = &x.lattice.edge[edge_of(0)].normal,
                     *f = &x.lattice.edge[edge_of(1)].normal;
    const long double det = e->at[0] * f->at[1] - e->at[1] * f->at[0];

    out[0] = -(sum[0] * f->at[1] - sum[1] * f->at[0]) / det;
    out[1] = -(e->at[0] * sum[1] - e->at[1] * sum[0]) / det;
    return out[0] >= 0 && out[1] >= 0;
}

static loft_unit parameter_of(long double log, long double balance)
{
    const long double s = expl(-log);
    return LOFT_UNIT((double)(balance * s / (1 - s + balance * s)));
}

/* By a parameter that errs by 2^-25: times the degree, and the largest weight over the smallest. */
static long double moved_of(long double reach, long double least)
{
    return reach * (x.s.m + x.s.n) * 256 / least * BY_NUM(0x1p-25L, 0x1p-25L, 0x1p-50L);
}

/* The point with these sums of logarithms is on the patch of some vertex. */
static void check_place(const long double sum[2], const loft_vec *want)
{
    long double log[2], least, most;

    for (x.vertex = 0; !cone_of(sum, log) && ++x.vertex < x.lattice.sides;)
        ;
    CHECK(x.vertex < x.lattice.sides);
    CHECK(loft_toric_tensor(&x.patch, x.vertex, x.net, &x.s) == LOFT_OK);
    const loft_vec got = loft_tensor_rational_eval(&x.s, parameter_of(log[0], balance_of(0)),
                                                   parameter_of(log[1], balance_of(1)));
    const long double reach = reach_of(&least, &most), moved = moved_of(reach, least);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(got.axis[i]), exact_of(want->axis[i]),
                    bound_of(reach, least, most) + moved + BY_NUM(LSB, ulp(most), 1e-12L));
}

/* Every point inside is on the patch of some vertex. */
static void every_point_of_the_toric_patch_is_on_one(arb *a)
{
    long double sum[2] = { 0, 0 };
    loft_spot p = { { 0, 0 } };
    loft_vec want;

    arb_scene(a, 100);
    for (int i = 0; i < 2; i++) {               /* an average with powers of 2 */
        long double share = 1, middle = 0;
        for (unsigned k = 0; k < x.lattice.sides; k++) {
            share = k + 1 < x.lattice.sides ? share / 2 : share;
            middle += share * x.lattice.edge[(k + edge_of(1)) % x.lattice.sides].from.at[i];
        }
        p.at[i] = LOFT_REAL((double)middle);
    }
    if (arb_below(a, 2)) {                      /* another one, nearer to a vertex */
        const loft_whole *v = &x.lattice.edge[arb_below(a, x.lattice.sides)].from;
        for (int i = 0; i < 2; i++)
            p.at[i] = LOFT_REAL((double)(exact_of(p.at[i]) / 8 + v->at[i] * 7 / 8.0L));
    }
    for (unsigned k = 0; k < x.lattice.sides; k++) {
        const loft_lattice_edge *e = &x.lattice.edge[k];
        const long double h = logl(e->normal.at[0] * exact_of(p.at[0]) +
                                   e->normal.at[1] * exact_of(p.at[1]) + e->offset);
        for (int i = 0; i < 2; i++)
            sum[i] += h * e->normal.at[i];
    }
    CHECK(loft_toric_eval(&x.patch, p, &want) == LOFT_OK);
    check_place(sum, &want);
}

/* A patch with base points, through its toric form, at shares of the corners. */
static void every_point_of_a_patch_with_base_points_is_on_one(arb *a)
{
    static loft_vec p[LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)];
    static loft_real w[LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)];
    const unsigned degree = 1 + arb_below(a, LOFT_DEGREE_MAX);
    uint8_t cut[3];
    loft_basepoint b;
    loft_vec want;

    do
        for (int i = 0; i < 3; i++)
            cut[i] = (uint8_t)arb_below(a, degree);
    while (cut[0] + cut[1] >= (int)degree || cut[1] + cut[2] >= (int)degree ||
           cut[0] + cut[2] >= (int)degree);
    for (unsigned k = 0; k < loft_multiindex_count(3, degree); k++) {
        p[k] = arb_vec(a, 100);
        w[k] = LOFT_REAL(0.25 + arb_below(a, 376) / 100.0);
    }
    CHECK(loft_basepoint_init(&b, p, w, degree, cut) == LOFT_OK);
    CHECK(loft_toric_from_basepoint(&b, &x.lattice, x.p, x.c, x.w, &x.patch) == LOFT_OK);
    x.count = loft_lattice_polygon_count(&x.lattice);
    const unsigned one = 1 + arb_below(a, 254), two = 1 + arb_below(a, 255 - one);
    const long double phi[3] = { one / 256.0L, two / 256.0L, 1 - (one + two) / 256.0L };
    const long double sum[2] = { logl(phi[1] / phi[0]), logl(phi[2] / phi[0]) };

    CHECK(loft_basepoint_eval(&b, LOFT_UNIT((double)phi[0]), LOFT_UNIT((double)phi[1]), &want) ==
          LOFT_OK);
    check_place(sum, &want);
}

/* Neighbours have the same points and proportional weights along the curve between them. */
static void neighbours_share_a_curve(arb *a)
{
    static loft_weighted next[LOFT_TORIC_TENSOR_MAX];
    loft_tensor_rational other;

    arb_scene(a, 100);
    CHECK(loft_toric_tensor(&x.patch, (x.vertex + 1) % x.lattice.sides, next, &other) == LOFT_OK);
    CHECK(other.m == x.s.n);
    const long double ratio = exact_of(next[other.n].w) / exact_of(x.net[x.s.m * (x.s.n + 1u)].w);
    for (unsigned k = 0; k <= other.m; k++) {
        const loft_weighted *one = &x.net[x.s.m * (x.s.n + 1u) + k],
                            *two = &next[k * (other.n + 1u) + other.n];
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(exact_of(one->p.axis[i]), exact_of(two->p.axis[i]),
                        BY_NUM(LSB, 0x1p-17L, 0x1p-44L));
        CHECK_EXACT(exact_of(two->w), ratio * exact_of(one->w),
                    BY_NUM(LSB * (1 + 2 * ratio), 0x1p-14L, 0x1p-40L));
    }
}

static void the_corner_is_the_vertex(arb *a)
{
    loft_whole l;
    unsigned k = 0;

    arb_scene(a, 32767);
    const loft_whole *v = &x.lattice.edge[x.vertex].from;
    loft_lattice_polygon_first(&x.lattice, &l);
    for (; l.at[0] != v->at[0] || l.at[1] != v->at[1]; k++)
        CHECK(loft_lattice_polygon_next(&x.lattice, &l));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(x.net[0].p.axis[i]), exact_of(x.p[k].axis[i]),
                    BY_NUM(0, 0, ulp(exact_of(x.p[k].axis[i]))));
}

/* Products of binomials over a rectangle: all weights are equal. */
static void a_tensor_product_is_one_without_weights(arb *a)
{
    const unsigned m = 1 + arb_below(a, 9), n = 1 + arb_below(a, 9);
    const loft_whole v[4] = {
        { { 0, 0 } }, { { (int8_t)m, 0 } }, { { (int8_t)m, (int8_t)n } }, { { 0, (int8_t)n } }
    };
    loft_whole l;

    CHECK(loft_lattice_polygon_init(&x.lattice, v, 4) == LOFT_OK);
    x.count = 0;
    loft_lattice_polygon_first(&x.lattice, &l);
    do {
        x.p[x.count] = arb_vec(a, 100);
        x.c[x.count++] = loft_real_from_int(loft_binomial(m, (unsigned)l.at[0]) *
                                            loft_binomial(n, (unsigned)l.at[1]));
    } while (loft_lattice_polygon_next(&x.lattice, &l));
    CHECK(loft_toric_init(&x.patch, &x.lattice, x.p, x.c, NULL) == LOFT_OK);
    CHECK(loft_toric_tensor(&x.patch, arb_below(a, 4), x.net, &x.s) == LOFT_OK);
    for (unsigned k = 1; k < x.count; k++)
        CHECK_EXACT(exact_of(x.net[k].w), exact_of(x.net[0].w), BY_NUM(LSB, 0x1p-15L, 0x1p-42L));
}

static void what_is_no_such_patch_is_refused(arb *a)
{
    arb_scene(a, 100);
    CHECK(loft_toric_tensor(&x.patch, x.lattice.sides, x.net, &x.s) == LOFT_ERR_ARG);
    hold_lattice(a, lattice_turned(a, LATTICE_WHOLE));
    for (unsigned k = 0; k < x.count; k++)      /* a vertex counts 2^-23 of all */
        x.c[k] = LOFT_REAL(k ? 32767 : 0.00390625);
    CHECK(loft_toric_init(&x.patch, &x.lattice, x.p, x.c, NULL) == LOFT_OK);
    for (x.vertex = 0; x.lattice.edge[x.vertex].from.at[0] || x.lattice.edge[x.vertex].from.at[1];)
        x.vertex++;
    CHECK(loft_toric_tensor(&x.patch, x.vertex, x.net, &x.s) == LOFT_ERR_RANGE);
    hold_lattice(a, lattice_turned(a, LATTICE_WIDE));
    CHECK(loft_toric_init(&x.patch, &x.lattice, x.p, NULL, NULL) == LOFT_OK);
    CHECK(loft_toric_tensor(&x.patch, x.vertex, x.net, &x.s) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_patch_is_the_sum_of_monomials, 1000);
    PROPERTY(every_point_of_the_toric_patch_is_on_one, 1000);
    PROPERTY(every_point_of_a_patch_with_base_points_is_on_one, 1000);
    PROPERTY(neighbours_share_a_curve, 300);
    PROPERTY(the_corner_is_the_vertex, 300);
    PROPERTY(a_tensor_product_is_one_without_weights, 100);
    PROPERTY(what_is_no_such_patch_is_refused, 20);
    return check_failures();
}

/* tests/lib/curve/test_enclosed.c -- properties of lib/curve/enclosed.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "curve/enclosed.h"

#define MOST (LOFT_DEGREE_MAX + 1)
#define CURVES 5

#if LOFT_AXES < 2
#  error "areas need a plane"
#endif

typedef struct {
    unsigned count;
    loft_vec p[CURVES * MOST];
    loft_bezier c[CURVES];
} chain;

static chain *arb_chain(arb *a, int32_t limit)
{
    static chain s;
    unsigned at = 0;

    s.count = 1 + arb_below(a, CURVES);
    s.p[0] = arb_vec(a, limit);
    for (unsigned k = 0; k < s.count; k++) {
        const unsigned n = 1 + arb_below(a, LOFT_DEGREE_MAX);
        for (unsigned i = 1; i <= n; i++)
            s.p[at + i] = arb_vec(a, limit);
        if (k + 1 == s.count)
            s.p[at + n] = s.p[0];
        CHECK(loft_bezier_init(&s.c[k], s.p + at, n) == LOFT_OK);
        at += n;
    }
    return &s;
}

/* The rule of Gauss with three points, on 64 intervals. */
static void point_of(const loft_bezier *b, long double t, long double v[2], long double d[2])
{
    for (int i = 0; i < 2; i++) {
        long double c[MOST];
        for (unsigned k = 0; k <= b->degree; k++)
            c[k] = exact_of(b->p[k].axis[i]);
        v[i] = exact_eval(c, b->degree, t);
        d[i] = exact_deriv(c, b->degree, 1, t);
    }
}

enum { AREA, MX, MY, XX, XY, YY, SUMS };

static void reference(const chain *s, const long double o[2], long double sum[SUMS])
{
    static const long double node[3] = { -0.774596669241483377035853L, 0,
                                         0.774596669241483377035853L },
                             weight[3] = { 5 / 18.0L, 8 / 18.0L, 5 / 18.0L };

    for (int i = 0; i < SUMS; i++)
        sum[i] = 0;
    for (unsigned k = 0; k < s->count; k++)
        for (int j = 0; j < 64; j++)
            for (int g = 0; g < 3; g++) {
                long double v[2], d[2];
                point_of(&s->c[k], (j + (1 + node[g]) / 2) / 64, v, d);
                const long double x = v[0] - o[0], y = v[1] - o[1], dy = d[1] * weight[g] / 64;
                sum[AREA] += x * dy;
                sum[MX] += x * x / 2 * dy;
                sum[MY] += x * y * dy;
                sum[XX] += x * x * x / 3 * dy;
                sum[XY] += x * x * y / 2 * dy;
                sum[YY] += x * y * y * dy;
            }
}

static void area_centroid_and_moments_are_integrals(arb *a)
{
    const int32_t limit = 1 + (int32_t)arb_below(a, 12);
    const chain *s = arb_chain(a, limit);
    const long double zero[2] = { 0, 0 };
    long double sum[SUMS], about[SUMS], l = 2 * limit;
    loft_enclosed e = { 0, { 0, 0 }, 0, 0, 0 };
    const enum loft_status status = loft_chain_enclosed(s->c, s->count, &e);

    reference(s, zero, sum);
    if (fabsl(sum[AREA]) < 0.25L || status != LOFT_OK)
        return;
    /* 64 intervals of a rule of degree 5: their error is far below these bounds */
    CHECK_EXACT(exact_acc(e.area), sum[AREA], 1e-6L * l * l);
    const long double c[2] = { sum[MX] / sum[AREA], sum[MY] / sum[AREA] };
    CHECK_EXACT(exact_acc(e.centroid[0]), c[0], 1e-5L * l * l * l / fabsl(sum[AREA]));
    CHECK_EXACT(exact_acc(e.centroid[1]), c[1], 1e-5L * l * l * l / fabsl(sum[AREA]));
    reference(s, c, about);
    CHECK_EXACT(exact_acc(e.xx), about[XX], 1e-5L * l * l * l * l);
    CHECK_EXACT(exact_acc(e.xy), about[XY], 1e-5L * l * l * l * l);
    CHECK_EXACT(exact_acc(e.yy), about[YY], 1e-5L * l * l * l * l);
}

/* A polygon of lines, wherever it is: the shoelace formula, and the same moments. */
static void polygons_are_measured_exactly(arb *a)
{
    loft_vec p[2][10];
    loft_bezier c[2][9];
    loft_enclosed e[2] = { { 0, { 0, 0 }, 0, 0, 0 }, { 0, { 0, 0 }, 0, 0, 0 } };
    const unsigned count = 3 + arb_below(a, 6);
    const loft_vec by = { { loft_real_from_int(29000), loft_real_from_int(-29000) } };
    int64_t twice = 0;
    enum loft_status status[2];

    for (unsigned k = 0; k < count; k++)
        for (int i = 0; i < LOFT_AXES; i++)     /* steps that floats hold at 29000, too */
            p[0][k].axis[i] = loft_real_from_raw(((int32_t)arb_below(a, 400) - 200) * 1024);
    p[0][count] = p[0][0];
    for (unsigned k = 0; k <= count; k++)
        p[1][k] = loft_vec_add(p[0][k], by);
    for (int m = 0; m < 2; m++) {
        for (unsigned k = 0; k < count; k++)
            CHECK(loft_bezier_init(&c[m][k], &p[m][k], 1) == LOFT_OK);
        status[m] = loft_chain_enclosed(c[m], count, &e[m]);
    }
    for (unsigned k = 0; k < count; k++)
        twice +=
            (int64_t)loft_raw_from_real(p[0][k].axis[0]) * loft_raw_from_real(p[0][k + 1].axis[1]) -
            (int64_t)loft_raw_from_real(p[0][k + 1].axis[0]) * loft_raw_from_real(p[0][k].axis[1]);
    CHECK((status[0] == LOFT_SINGULAR) == (twice == 0));
    CHECK(status[0] == status[1]);
    if (status[0] != LOFT_OK)
        return;
    CHECK_EXACT(exact_acc(e[0].area), (long double)twice / 8589934592.0L,
                bound_by_num(0x1p-32L, 1e-12L, 1e-12L));
    CHECK_EXACT(exact_acc(e[1].area), exact_acc(e[0].area), bound_by_num(0, 1e-12L, 1e-12L));
    const long double far = 300 / fabsl(exact_acc(e[0].area)) *
                            bound_by_num(0x1p-44L, 0x1p-34L, 0x1p-34L);
    CHECK_EXACT(exact_acc(e[1].centroid[0]) - 29000, exact_acc(e[0].centroid[0]), far + 0x1p-31L);
    CHECK_EXACT(exact_acc(e[1].xx), exact_acc(e[0].xx), 0x1p-30L + 100 * far);
}

static void reversed_chains_have_the_negative_area(arb *a)
{
    const chain *s = arb_chain(a, 50);
    loft_vec p[CURVES * MOST];
    loft_bezier c[CURVES];
    loft_enclosed e[2] = { { 0, { 0, 0 }, 0, 0, 0 }, { 0, { 0, 0 }, 0, 0, 0 } };
    unsigned all = 0, at = 0;

    for (unsigned k = 0; k < s->count; k++)
        all += s->c[k].degree;
    for (unsigned i = 0; i <= all; i++)
        p[i] = s->p[all - i];
    for (unsigned k = 0; k < s->count; k++, at += s->c[s->count - k].degree)
        CHECK(loft_bezier_init(&c[k], p + at, s->c[s->count - 1 - k].degree) == LOFT_OK);
    CHECK(loft_chain_enclosed(s->c, s->count, &e[0]) == loft_chain_enclosed(c, s->count, &e[1]));
    CHECK_EXACT(exact_acc(e[0].area), -exact_acc(e[1].area), bound_by_num(0, 1e-10L, 1e-10L));
}

static void area_under_a_curve_is_that_of_its_chain(arb *a)
{
    loft_vec p[MOST + 3];
    loft_bezier c[4];
    const unsigned n = 1 + arb_below(a, LOFT_DEGREE_MAX);
    loft_acc under = 0, part[2] = { 0, 0 };
    loft_enclosed e = { 0, { 0, 0 }, 0, 0, 0 };
    const loft_unit t = arb_unit(a);

    for (unsigned i = 0; i <= n; i++)
        p[i] = arb_vec(a, 100);
    p[n + 1] = p[n + 2] = p[n];
    p[n + 1].axis[1] = p[n + 2].axis[1] = 0;
    p[n + 2].axis[0] = p[0].axis[0];
    loft_vec last[2] = { p[n + 2], p[0] };
    CHECK(loft_bezier_init(&c[0], p, n) == LOFT_OK &&
          loft_bezier_init(&c[1], p + n, 1) == LOFT_OK &&
          loft_bezier_init(&c[2], p + n + 1, 1) == LOFT_OK &&
          loft_bezier_init(&c[3], last, 1) == LOFT_OK);
    CHECK(loft_bezier_area_under(&c[0], 0, LOFT_UNIT(1), &under) == LOFT_OK);
    CHECK(loft_bezier_area_under(&c[0], 0, t, &part[0]) == LOFT_OK &&
          loft_bezier_area_under(&c[0], t, LOFT_UNIT(1), &part[1]) == LOFT_OK);
    CHECK_EXACT(exact_acc(part[0]) + exact_acc(part[1]), exact_acc(under), 0x1p-29L);
    if (loft_chain_enclosed(c, 4, &e) != LOFT_ERR_RANGE)
        CHECK_EXACT(exact_acc(e.area), -exact_acc(under), 0x1p-29L);
}

static void mistakes_are_refused(arb *a)
{
    chain *s = arb_chain(a, 100);
    loft_enclosed e;
    loft_acc x;

    CHECK(loft_chain_enclosed(s->c, 0, &e) == LOFT_ERR_ARG);
    s->p[0].axis[0] += loft_real_from_raw(1);
    if (s->count > 1)
        CHECK(loft_chain_enclosed(s->c, s->count, &e) == LOFT_ERR_ARG);
    CHECK(loft_bezier_area_under(&s->c[0], 0, LOFT_UNIT(1.5), &x) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(area_centroid_and_moments_are_integrals,  100);
    PROPERTY(polygons_are_measured_exactly,            300);
    PROPERTY(reversed_chains_have_the_negative_area,   100);
    PROPERTY(area_under_a_curve_is_that_of_its_chain,  300);
    PROPERTY(mistakes_are_refused,                      50);
    return check_failures();
}

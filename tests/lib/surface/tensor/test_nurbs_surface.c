/* tests/lib/surface/tensor/test_nurbs_surface.c -- properties of lib/surface/tensor/nurbs_surface.h
 * SPDX-License-Identifier: MIT
 *
 * The reference is the quotient rule in 113 bits, over B-splines by their definition.
 */
#include "support/exact_basis.h"        /* quad_basis, arb_knots; CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/nurbs_surface.h"
#include "surface/tensor/tensor_rational.h"

#define ROWS 10

typedef struct {
    unsigned rows, columns, degree[2], span[2];
    loft_weighted p[ROWS * ROWS];
    loft_vec plain[ROWS * ROWS];
    loft_real knot[2][2 * ROWS], u[2];
    long double ratio, size, step[2];
    bool weighted, valid;
    loft_nurbs_surface s;
} sample;

static sample *arb_sample(arb *a)
{
    static sample s;
    const int32_t limit = (int32_t)1 << arb_below(a, 15);
    long double least = 256, most = 0;

    s.weighted = arb_below(a, 2);
    for (int k = 0; k < 2; k++)
        s.degree[k] = 1 + arb_below(a, 4);
    s.rows = s.degree[0] + 1 + arb_below(a, 4);
    s.columns = s.degree[1] + 1 + arb_below(a, 4);
    for (unsigned i = 0; i < s.rows * s.columns; i++) {
        const loft_real w = loft_real_from_raw(256 +
                                               (int32_t)arb_below(a, 1u << (1 + arb_below(a, 12))));
        s.plain[i] = arb_vec(a, limit);
        s.p[i] = (loft_weighted) { s.plain[i], s.weighted ? w : LOFT_REAL(1) };
        least = fminl(least, exact_of(s.p[i].w));
        most = fmaxl(most, exact_of(s.p[i].w));
    }
    s.ratio = most / least;
    s.size = limit;
    arb_knots(a, s.rows, s.degree[0], s.knot[0]);
    arb_knots(a, s.columns, s.degree[1], s.knot[1]);
    s.valid = (s.weighted
                   ? loft_nurbs_surface_init(&s.s, s.p, s.rows, s.columns, s.knot[0], s.degree[0],
                                             s.knot[1], s.degree[1])
                   : loft_bspline_surface_init(&s.s, s.plain, s.rows, s.columns, s.knot[0],
                                               s.degree[0], s.knot[1], s.degree[1])) == LOFT_OK;
    const unsigned points[2] = { s.rows, s.columns };
    for (int k = 0; k < 2 && s.valid; k++) {
        const loft_knots *knots = k ? &s.s.v : &s.s.u;
        s.u[k] = loft_lerp(s.knot[k][s.degree[k]], s.knot[k][points[k]], arb_unit(a));
        s.span[k] = loft_knots_find(knots, s.u[k]);
        s.step[k] = exact_of(s.knot[k][s.span[k] + 1]) - exact_of(s.knot[k][s.span[k]]);
    }
    return &s;
}

static quad net_sum(const sample *s, unsigned a, unsigned b, int axis)
{
    quad sum = 0;

    for (unsigned i = 0; i <= s->degree[0]; i++) {
        const unsigned row = s->span[0] - s->degree[0] + i;
        const quad m = quad_basis(s->knot[0], row, s->degree[0], quad_of(s->u[0]), a, s->span[0]);
        for (unsigned j = 0; j <= s->degree[1]; j++) {
            const unsigned column = s->span[1] - s->degree[1] + j;
            const loft_weighted *p = &s->p[row * s->columns + column];
            const quad n = quad_basis(s->knot[1], column, s->degree[1], quad_of(s->u[1]), b,
                                      s->span[1]);
            sum += m * n * quad_of(p->w) * (axis < 0 ? 1 : quad_of(p->p.axis[axis]));
        }
    }
    return sum;
}

static void reference(const sample *s, unsigned a, unsigned b, quad out[])
{
    const quad w = net_sum(s, 0, 0, -1), wu = net_sum(s, 1, 0, -1), wv = net_sum(s, 0, 1, -1);

    for (int i = 0; i < LOFT_AXES; i++) {
        const quad p = net_sum(s, 0, 0, i) / w, pu = (net_sum(s, 1, 0, i) - wu * p) / w,
                   pv = (net_sum(s, 0, 1, i) - wv * p) / w;
        quad x = net_sum(s, a, b, i) - net_sum(s, a, b, -1) * p;
        x -= a == 2 ? 2 * wu * pu : b == 2 ? 2 * wv * pv : a == 1 && b == 1 ? wu * pv + wv * pu : 0;
        out[i] = a + b == 0 ? p : x / w;
    }
}

static void points_and_derivatives_are_within_their_bound(arb *a)
{
    const sample *s = arb_sample(a);
    const long double slope[2] = { 2 * s->degree[0] * s->ratio / s->step[0],
                                   2 * s->degree[1] * s->ratio / s->step[1] };

    for (unsigned j = 0; j < 3; j++)
        for (unsigned k = 0; j + k < 3 && s->valid; k++) {
            quad want[LOFT_AXES];
            loft_vec p = { { 0 } };
            const long double room = bound_by_num(0x1p-54L, 0x1p-46L, 0x1p-46L) * 2 * s->size *
                                     powl(slope[0], j) * powl(slope[1], k);
            reference(s, j, k, want);
            const enum loft_status status = loft_nurbs_surface_deriv(&s->s, j, k, s->u[0], s->u[1],
                                                                     &p);
            if (room < 1)
                check_result(status, &p, want, 0.5L + 0x1p-16L + room / LSB,
                             room + bound_by_num(0, ulp(s->size), 64 * ulp(s->size)));
        }
}

/* On a line there is no tangent plane; where there is one, the normal is perpendicular. */
static void normals_are_perpendicular_where_there_is_one(arb *a)
{
    sample *s = arb_sample(a);
    loft_differential d;
    loft_vec n = { { 0 } };

    if (!s->valid || LOFT_AXES < 3)
        return;
    const enum loft_status status = loft_nurbs_surface_differential(&s->s, s->u[0], s->u[1], &d);
    CHECK(loft_nurbs_surface_regular(&s->s, s->u[0], s->u[1]) == (status != LOFT_SINGULAR));
    if (status == LOFT_OK && loft_differential_normal(&d, &n) == LOFT_OK) {
        long double square = 0;
        for (int i = 0; i < 3; i++)
            square += powl(exact_of(n.axis[i]), 2);
        CHECK_EXACT(square, 1, BY_NUM(4 * LSB, 0x1p-20L, 0x1p-46L));
    }
    for (unsigned i = 0; i < s->rows * s->columns; i++) {
        const int32_t at = (int32_t)arb_below(a, 1000);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            s->plain[i].axis[axis] = s->p[i].p.axis[axis] = loft_real_from_raw(at * (3 + 7 * axis));
    }
    CHECK(!loft_nurbs_surface_regular(&s->s, s->u[0], s->u[1]));
    CHECK(loft_nurbs_surface_differential(&s->s, s->u[0], s->u[1], &d) == LOFT_SINGULAR);
}

/* On the knots 0 and 1 it is the Bezier patch. */
static void one_span_is_a_bezier_patch(arb *a)
{
    sample *s = arb_sample(a);
    loft_nurbs_surface one;
    loft_tensor_rational t;
    loft_real knot[2][12];
    const loft_unit u = loft_unit_of(arb_below(a, 257), 256),
                    v = loft_unit_of(arb_below(a, 257), 256);
    loft_vec p = { { 0 } };

    for (int k = 0; k < 2; k++)
        for (unsigned i = 0; i < 2 * (s->degree[k] + 1); i++)
            knot[k][i] = i <= s->degree[k] ? LOFT_REAL(0) : LOFT_REAL(1);
    CHECK(loft_nurbs_surface_init(&one, s->p, s->degree[0] + 1, s->degree[1] + 1, knot[0],
                                  s->degree[0], knot[1], s->degree[1]) == LOFT_OK);
    CHECK(loft_tensor_rational_init(&t, s->p, s->degree[0], s->degree[1]) == LOFT_OK);
    CHECK(loft_nurbs_surface_eval(&one, loft_lerp(LOFT_REAL(0), LOFT_REAL(1), u),
                                  loft_lerp(LOFT_REAL(0), LOFT_REAL(1), v), &p) == LOFT_OK);
    const loft_vec q = loft_tensor_rational_eval(&t, u, v);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    bound_by_num(LSB, 4 * ulp(s->size), 256 * ulp(s->size)));
}

/* The corners of the domain are those of the parameters 0..1. */
static void as_a_surface_it_has_the_domain(arb *a)
{
    sample *s = arb_sample(a);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    loft_real at[2];
    loft_vec p = { { 0 } }, q = { { 0 } };

    if (!s->valid)
        return;
    const loft_surface f = loft_surface_from_nurbs(&s->s);
    loft_nurbs_surface_at(&s->s, 0, LOFT_UNIT(1), at);
    CHECK_EXACT(exact_of(at[0]), exact_of(s->knot[0][s->degree[0]]), 0);
    CHECK_EXACT(exact_of(at[1]), exact_of(s->knot[1][s->columns]), 0);
    loft_nurbs_surface_at(&s->s, u, v, at);
    const long double from = exact_of(s->knot[0][s->degree[0]]), to = exact_of(s->knot[0][s->rows]);
    CHECK_EXACT(exact_of(at[0]), from + (to - from) * exact_unit(u),
                bound_by_num(LSB / 2 + 0x1p-32L, ulp(fmaxl(fabsl(from), fabsl(to))),
                             3 * ulp(fmaxl(fabsl(from), fabsl(to)))));
    CHECK(f.eval(f.surface, u, v, &p) == loft_nurbs_surface_eval(&s->s, at[0], at[1], &q) &&
          loft_vec_equal(p, q));
}

static void mistakes_are_refused(arb *a)
{
    sample *s = arb_sample(a);
    loft_vec v;

    if (!s->valid)
        return;
    CHECK(loft_nurbs_surface_deriv(&s->s, 2, 1, s->u[0], s->u[1], &v) == LOFT_ERR_ARG &&
          loft_nurbs_surface_deriv(&s->s, 3, 0, s->u[0], s->u[1], &v) == LOFT_ERR_ARG);
    s->p[1].w = LOFT_REAL(300);
    CHECK(loft_nurbs_surface_init(&s->s, s->p, s->rows, s->columns, s->knot[0], s->degree[0],
                                  s->knot[1], s->degree[1]) == LOFT_ERR_RANGE);
    CHECK(loft_bspline_surface_init(&s->s, s->plain, s->degree[0], s->columns, s->knot[0],
                                    s->degree[0], s->knot[1], s->degree[1]) == LOFT_ERR_ARG);
}

/* Every span is given once, in order; in its middle its patch is the surface. */
static void spans_are_the_surface(arb *a)
{
    const sample *s = arb_sample(a);
    static loft_weighted net[25];
    static loft_vec plain[25];
    unsigned span[2] = { 0, 0 }, before[2] = { 0, 0 }, count = 0, all[2] = { 0, 0 };
    long double least = 256;

    if (!s->valid)
        return;
    for (unsigned i = 0; i < s->rows * s->columns; i++)
        least = fminl(least, exact_of(s->p[i].w));
    while (loft_nurbs_surface_next(&s->s, span, net)) {
        const loft_unit half = LOFT_UNIT(0.5);
        loft_real middle[2];
        loft_vec want, got;
        bool exact = true;
        CHECK(span[0] > before[0] || (span[0] == before[0] && span[1] > before[1]));
        for (int k = 0; k < 2; k++) {
            const loft_real *knot = s->knot[k] + span[k];
            before[k] = span[k];
            middle[k] = loft_lerp(knot[0], knot[1], half);
            exact = exact && exact_of(knot[0]) + exact_of(knot[1]) == 2 * exact_of(middle[k]);
        }
        count++;
        if (!exact || loft_nurbs_surface_eval(&s->s, middle[0], middle[1], &want) != LOFT_OK)
            continue;
        if (s->weighted) {
            loft_tensor_rational patch;
            if (loft_tensor_rational_init(&patch, net, s->degree[0], s->degree[1]) != LOFT_OK)
                continue;               /* a rounded weight below 1/256 */
            got = loft_tensor_rational_eval(&patch, half, half);
        } else {
            loft_tensor patch;
            for (unsigned i = 0; i < (s->degree[0] + 1) * (s->degree[1] + 1); i++)
                plain[i] = net[i].p;
            CHECK(loft_tensor_init(&patch, plain, s->degree[0], s->degree[1]) == LOFT_OK);
            got = loft_tensor_eval(&patch, half, half);
        }
        /* two points of 1/2 LSB (1 ulp); a weight of 2^-17 more or less turns the quotient */
        const long double weights = s->weighted ? BY_NUM(0x1p-16L / least, 0, 0) : 0;
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_NEAR(exact_of(got.axis[i]), exact_of(want.axis[i]),
                       BY_NUM(2, 4, 200) * ulp(2 * s->size) * (s->weighted ? s->ratio : 1) +
                           2 * s->size * weights);
    }
    for (int k = 0; k < 2; k++)
        for (unsigned i = s->degree[k]; i < (k ? s->columns : s->rows); i++)
            all[k] += s->knot[k][i] < s->knot[k][i + 1];
    CHECK(count == all[0] * all[1]);
}

int main(void)
{
    PROPERTY(points_and_derivatives_are_within_their_bound, 200);
    PROPERTY(normals_are_perpendicular_where_there_is_one,  200);
    PROPERTY(one_span_is_a_bezier_patch,                    500);
    PROPERTY(as_a_surface_it_has_the_domain,                300);
    PROPERTY(mistakes_are_refused,                           50);
    PROPERTY(spans_are_the_surface, 100);
    return check_failures();
}

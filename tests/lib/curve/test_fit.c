/* tests/lib/curve/test_fit.c -- properties of lib/curve/fit.h
 * SPDX-License-Identifier: MIT
 *
 * The reference solves nothing: the weighted sum of what is left at each B-spline, computed in long
 * double by the definition of B-splines, is 0 at the least sum of squares.
 */
#include "support/exact.h"          /* exact_of; CHECK, PROPERTY, BY_NUM */
#include "curve/bspline.h"
#include "curve/fit.h"

#define POINTS 40
#define DATA   200

typedef struct {
    unsigned degree, points;
    bool closed;
    loft_real knot[POINTS + 12], u[DATA], weight[DATA];
    loft_vec p[DATA], out[POINTS];
    loft_sci memory[LOFT_FIT_MEMORY(POINTS, LOFT_DEGREE_MAX)];
    loft_fit_points data;
} sample;

/* Knots are 64ths, which no number type rounds. */
static void set_knots(arb *a, sample *x)
{
    int32_t at[POINTS + 12];
    const unsigned n = x->degree;

    at[n] = 0;
    for (unsigned i = n; i < x->points; i++)
        at[i + 1] = at[i] + 1 + (int32_t)arb_below(a, arb_below(a, 2) ? 4 : 200);
    for (unsigned i = n; i-- > 0; )
        at[i] = x->closed ? at[i + x->points - n] - at[x->points] : 0;
    for (unsigned i = x->points + 1; i <= x->points + n; i++)
        at[i] = x->closed ? at[i + n - x->points] + at[x->points] : at[x->points];
    for (unsigned i = 0; i <= x->points + n; i++)
        x->knot[i] = (loft_real)at[i] * LOFT_REAL(0.015625);
}

static void insert_place(sample *x, loft_real u)
{
    unsigned k = x->data.count++;

    for (; k > 0 && x->u[k - 1] > u; k--)
        x->u[k] = x->u[k - 1];
    x->u[k] = u;
}

/* A place under each B-spline (so that a solution exists), the ends, and more. */
static void set_places(arb *a, sample *x)
{
    const loft_real from = x->knot[x->degree], to = x->knot[x->points];
    const unsigned more = arb_below(a, 2) ? arb_below(a, 4) : arb_below(a, 100);

    x->data.count = 0;
    for (unsigned i = 0; i < x->points - (x->closed ? x->degree : 0); i++) {
        long double mean = 0;
        for (unsigned k = 1; k <= x->degree; k++)
            mean += exact_of(x->knot[i + k]) / x->degree;
        if (mean < exact_of(from))
            mean += exact_of(to) - exact_of(from);
        insert_place(x, LOFT_REAL((double)mean));
    }
    for (unsigned k = 0; k < more; k++)
        insert_place(x,
                     from + (loft_real)((double)(to - from) * (double)arb_below(a, 1001) / 1000));
    if (!x->closed) {
        x->u[0] = from;
        x->u[x->data.count - 1] = to;
    }
}

static void arb_sample(arb *a, sample *x, bool closed)
{
    const int32_t limit = (int32_t)1 << arb_below(a, 14);

    x->degree = 1 + arb_below(a, arb_below(a, 2) ? 3 : LOFT_DEGREE_MAX);
    x->closed = closed;
    x->points = (closed ? 2 : 1) * x->degree + 1 + arb_below(a, 12);
    set_knots(a, x);
    set_places(a, x);
    for (unsigned k = 0; k < x->data.count; k++) {
        x->p[k] = arb_vec(a, limit);
        x->weight[k] = LOFT_REAL(1) * (loft_real)(1 + arb_below(a, 8));
    }
    x->data.p = x->p;
    x->data.u = x->u;
    x->data.weight = arb_below(a, 2) ? x->weight : NULL;
}

static enum loft_status fit(sample *x)
{
    return loft_bspline_fit(&x->data, x->knot, x->points, x->degree, x->closed, x->out, x->memory);
}

/* N_i at u, by its definition; the last piece holds the end. */
static long double basis_at(const sample *x, unsigned i, long double u)
{
    long double n[LOFT_DEGREE_MAX + 1];
    const long double end = exact_of(x->knot[x->points]);

    for (unsigned j = 0; j <= x->degree; j++) {
        const long double low = exact_of(x->knot[i + j]), high = exact_of(x->knot[i + j + 1]);
        n[j] = u < end ? low <= u && u < high : low < end && high >= end;
    }
    for (unsigned d = 1; d <= x->degree; d++)
        for (unsigned j = 0; j + d <= x->degree; j++) {
            const long double a = exact_of(x->knot[i + j]), b = exact_of(x->knot[i + j + d]),
                              c = exact_of(x->knot[i + j + 1]),
                              e = exact_of(x->knot[i + j + d + 1]);
            n[j] = (b > a ? (u - a) / (b - a) * n[j] : 0) +
                   (e > c ? (e - u) / (e - c) * n[j + 1] : 0);
        }
    return n[0];
}

typedef struct {
    long double basis[DATA][POINTS], sum[POINTS], most, largest;
} weighing;

static long double weight_of(const sample *x, unsigned k)
{
    return x->data.weight ? exact_of(x->weight[k]) : 1;
}

static void weigh(const sample *x, weighing *w)
{
    const unsigned unknowns = x->closed ? x->points - x->degree : x->points;

    *w = (weighing){ .most = 0 };
    for (unsigned k = 0; k < x->data.count; k++)
        for (unsigned i = 0; i < x->points; i++)
            w->basis[k][i % unknowns] += basis_at(x, i, exact_of(x->u[k]));
    for (unsigned i = 0; i < unknowns; i++) {
        for (unsigned k = 0; k < x->data.count; k++)
            w->sum[i] += weight_of(x, k) * w->basis[k][i];
        w->most = fmaxl(w->most, w->sum[i]);
    }
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        for (unsigned k = 0; k < x->data.count; k++)
            w->largest = fmaxl(w->largest, fabsl(exact_of(x->p[k].axis[axis])));
        for (unsigned i = 0; i < x->points; i++)
            w->largest = fmaxl(w->largest, fabsl(exact_of(x->out[i].axis[axis])));
    }
}

/* sum of w N_i(u) (C(u) - p) */
static long double left_over(const sample *x, const weighing *w, unsigned i, int axis)
{
    const unsigned unknowns = x->closed ? x->points - x->degree : x->points;
    long double sum = 0;

    for (unsigned k = 0; k < x->data.count; k++) {
        long double off = -exact_of(x->p[k].axis[axis]);
        for (unsigned j = 0; j < unknowns; j++)
            off += w->basis[k][j] * exact_of(x->out[j].axis[axis]);
        sum += weight_of(x, k) * w->basis[k][i] * off;
    }
    return sum;
}

static void nothing_is_left_over(const sample *x)
{
    static weighing w;
    const unsigned unknowns = x->closed ? x->points - x->degree : x->points;
    const long double cube = powl(x->degree + 1, 3) * (8 + x->data.count);

    weigh(x, &w);
    for (unsigned i = x->closed ? 0 : 1; i < unknowns - (x->closed ? 0 : 1); i++) {
        const long double wide = cube * w.largest * w.most;
        const long double most = BY_NUM((0.5L + 1 / 131072.0L) * LSB * w.sum[i] + wide * 0x1p-60L,
                                        ulp(w.largest) / 2 * w.sum[i] + wide * 0x1p-52L,
                                        wide * 0x1p-52L);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            CHECK_EXACT(left_over(x, &w, i, axis), 0, most);
    }
}

static void the_sum_of_squares_is_the_least(arb *a)
{
    static sample x;

    arb_sample(a, &x, false);
    const enum loft_status status = fit(&x);
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    if (status != LOFT_OK)
        return;
    CHECK(loft_vec_equal(x.out[0], x.p[0]));
    CHECK(loft_vec_equal(x.out[x.points - 1], x.p[x.data.count - 1]));
    nothing_is_left_over(&x);
}

static void closed_ones_are_closed(arb *a)
{
    static sample x;

    arb_sample(a, &x, true);
    const enum loft_status status = fit(&x);
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE || status == LOFT_SINGULAR);
    if (status != LOFT_OK)
        return;
    for (unsigned i = 0; i < x.degree; i++)
        CHECK(loft_vec_equal(x.out[i], x.out[i + x.points - x.degree]));
    nothing_is_left_over(&x);
}

/* Points of a curve give that curve back: its control points are whole numbers. */
static void a_curve_is_found_again(arb *a)
{
    static sample x;
    loft_vec control[POINTS];
    loft_bspline b;

    arb_sample(a, &x, arb_below(a, 2));
    x.degree = x.degree > 3 ? 3 : x.degree;
    x.points = (x.closed ? 2 : 1) * x.degree + 1 + arb_below(a, 12);
    set_knots(a, &x);
    set_places(a, &x);
    x.data.weight = NULL;
    for (unsigned i = 0; i < x.points; i++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            control[i].axis[axis] = x.closed && i >= x.points - x.degree
                                        ? control[i - (x.points - x.degree)].axis[axis]
                                        : LOFT_REAL(1) * (loft_real)arb_below(a, 100);
    CHECK(loft_bspline_init(&b, control, x.points, x.knot, x.degree) == LOFT_OK);
    for (unsigned k = 0; k < x.data.count; k++)
        x.p[k] = loft_bspline_eval(&b, x.u[k]);
    const enum loft_status status = fit(&x);
    CHECK(status == LOFT_OK || (x.closed && status == LOFT_SINGULAR));
    for (unsigned k = 0; status == LOFT_OK && k < x.data.count; k++) {
        CHECK(loft_bspline_init(&b, x.out, x.points, x.knot, x.degree) == LOFT_OK);
        const loft_vec at = loft_bspline_eval(&b, x.u[k]);
        for (int axis = 0; axis < LOFT_AXES; axis++)    /* the points are rounded themselves */
            CHECK_EXACT(exact_of(at.axis[axis]), exact_of(x.p[k].axis[axis]),
                        BY_NUM(16 * LSB, 16 * ulp(100), 1e-9L));
    }
}

static void too_few_points_are_told(arb *a)
{
    static sample x;

    do
        arb_sample(a, &x, false);
    while (x.points < x.degree + 4 || x.data.count > POINTS);
    for (unsigned k = 0; k < x.data.count; k++)     /* all at the ends */
        x.u[k] = x.u[2 * k < x.data.count ? 0 : x.data.count - 1];
    CHECK(fit(&x) == LOFT_SINGULAR);
}

static void mistakes_are_refused(arb *a)
{
    static sample x;

    arb_sample(a, &x, false);
    x.data.count--;
    CHECK(x.u[x.data.count - 1] >= x.knot[x.points] || fit(&x) == LOFT_ERR_ARG);
    arb_sample(a, &x, false);
    x.closed = true;
    x.points = 2 * x.degree < x.points ? 2 * x.degree : x.points;
    CHECK(fit(&x) == LOFT_ERR_ARG);
    arb_sample(a, &x, false);
    x.data.weight = x.weight;
    x.weight[arb_below(a, x.data.count)] = 0;
    CHECK(fit(&x) == LOFT_ERR_ARG);
    arb_sample(a, &x, false);
    x.knot[0] -= LOFT_REAL(1);
    CHECK(fit(&x) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(the_sum_of_squares_is_the_least, 600);
    PROPERTY(closed_ones_are_closed,          600);
    PROPERTY(a_curve_is_found_again,          300);
    PROPERTY(too_few_points_are_told,          50);
    PROPERTY(mistakes_are_refused,             50);
    return check_failures();
}

/* tests/vectors/vectors_along.c -- readers of what is asked of curves: inflections, frames, knots
 * less, loops, the nearest point, the box
 * SPDX-License-Identifier: MIT
 *
 * own/curves.py makes the rows. Where f32 cannot hold a row's numbers, nothing is compared.
 */
#include "vectors/vectors_points.h"         /* as_given; row, answer, law */
#include "curve/bounds.h"
#include "curve/inflections.h"
#include "curve/knot_removal.h"
#include "curve/nearest.h"
#include "curve/self_crossings.h"
#include "curve/tangent.h"

#define MOST   (LOFT_DEGREE_MAX + 1)
#define POINTS 64

typedef struct {
    bool weighted;
    long double ratio, size;            /* of the weights; the largest distance of two points */
    loft_vec p[MOST];
    loft_weighted w[MOST];
    loft_bezier b;
    loft_rational r;
} curve;

static void read_curve(row *r, unsigned d, curve *c)
{
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);
    loft_real w[MOST];
    long double least = INFINITY, most = 0;

    row_points(r, "P_q16", n + 1, d, c->p);
    const long double largest = r->largest;
    c->weighted = row_text(r, "w_q16")[0] != '-';
    if (c->weighted)
        row_reals(r, "w_q16", n + 1, w);
    r->largest = largest;
    c->size = 0;
    for (unsigned k = 0; k <= n; k++) {
        c->w[k] = (loft_weighted) { c->p[k], c->weighted ? w[k] : LOFT_REAL(1) };
        least = fminl(least, exact_of(c->w[k].w));
        most = fmaxl(most, exact_of(c->w[k].w));
        for (unsigned i = 0; i < k; i++) {
            long double sum = 0;
            for (unsigned axis = 0; axis < d; axis++)
                sum += powl(exact_of(c->p[k].axis[axis]) - exact_of(c->p[i].axis[axis]), 2);
            c->size = fmaxl(c->size, sqrtl(sum));
        }
    }
    c->ratio = most / least;
    if (loft_bezier_init(&c->b, c->p, n) != LOFT_OK ||
        loft_rational_init(&c->r, c->w, n) != LOFT_OK)
        row_complain(r, "the curve was refused");
}

static void expect_within(row *r, const char *column, long double got, long double error)
{
    const char *text = row_text(r, column);
    row_within(r, column, fabsl(got - row_next(&text)) * 65536, error * 65536);
}

static bool expect_count(row *r, unsigned count)
{
    char text[24];

    snprintf(text, sizeof text, "%u", count);
    row_expect_word(r, "count", text);
    return row_is(r, "count", text);
}

static void bezier_flat(row *r)
{
    static curve c;
    loft_flat f[LOFT_FLATS_MAX];
    unsigned count = 0;

    read_curve(r, 2, &c);
    const enum loft_status status = c.weighted ? loft_rational_inflections(&c.r, f, &count)
                                               : loft_bezier_inflections(&c.b, f, &count);
    if (!as_given(r))
        return;
    if (status < 0)
        row_complain(r, "the curve was refused");
    row_expect_word(r, "status", status == LOFT_SINGULAR ? "straight" : "ok");
    if (!expect_count(r, count) || count == 0)
        return;
    const char *t = row_text(r, "t"), *times = row_text(r, "mult");
    for (unsigned k = 0; k < count; k++) {
        row_within(r, "t", fabsl(exact_unit(f[k].t) - row_next(&t)) * 65536,
                   BY_NUM(0x1p-25L + 0x1p-32L, 0x1p-25L, 0x1p-51L) * 65536);
        row_within(r, "mult", fabsl(f[k].multiplicity - row_next(&times)), 0);
    }
}

/* The length of the k-th derivative. */
static long double length_of(const loft_sci x[])
{
    loft_acc length = 0;
    loft_sci sum = loft_sci_zero();

    for (int axis = 0; axis < 3; axis++)
        sum = loft_sci_add(sum, loft_sci_mul(x[axis], x[axis]));
    return loft_sci_to_acc(loft_sci_sqrt(sum), &length) ? exact_acc(length) : INFINITY;
}

/* Curvature, torsion and frame of a curve of degree n over a stretch of this length, R the ratio of
 * its weights, `size` the largest distance of two points. */
static void expect_frame(row *r, const loft_tangent *at, long double n, long double R,
                         long double size, long double length)
{
    static const char *const column[3] = { "T", "N", "B" };
    loft_acc bend = 0, turn = 0;
    loft_vec frame[3] = { { { 0 } } };
    const long double step = BY_NUM(0x1p-55L, 0x1p-47L, 0x1p-47L), slope = n * R / length,
                      a = slope * size * step, b = 8 * slope * slope * size * step,
                      e = 96 * slope * slope * slope * size * step;
    const enum loft_status bends = loft_tangent_curvature(at, false, &bend),
                           turns = loft_tangent_torsion(at, &turn),
                           frames = loft_tangent_frenet(at, frame);
    row_expect_word(r, "status", at->stops ? "stops" : turns == LOFT_SINGULAR ? "straight" : "ok");
    if (at->stops != (bends == LOFT_SINGULAR) || turns != frames)
        row_complain(r, "curvature, torsion and frame do not agree whether they exist");
    if (at->stops)
        return;
    const long double A = length_of(at->first), B = length_of(at->second), C = length_of(at->third),
                      kappa = exact_acc(bend), S = kappa * A * A * A;
    expect_within(r, "kappa", kappa,
                  4 * a / A * B / (A * A) + b / (A * A) +
                      BY_NUM(0x1p-33L, 16 * ulp_double(kappa), 16 * ulp_double(kappa)));
    if (turns != LOFT_OK)
        return;
    const long double tau = exact_acc(turn);
    expect_within(r, "tau", tau,
                  2 * (a * B * C + b * A * C + e * A * B) / (S * S) +
                      8 * fabsl(tau) * (a * B + b * A) / S +
                      BY_NUM(0x1p-33L, 16 * ulp_double(tau), 16 * ulp_double(tau)));
    for (unsigned k = 0; k < 3; k++) {
        const char *text = row_text(r, column[k]);
        const long double error = (k == 0 ? 2 * a / A : 6 * (a * B + b * A) / S) +
                                  BY_NUM(0x1p-17L + 0x1p-32L, 0x1p-25L + 0x1p-40L, 0x1p-48L);
        for (int axis = 0; axis < 3; axis++)
            row_within(r, column[k], fabsl(exact_of(frame[k].axis[axis]) - row_next(&text)) * 65536,
                       error * 65536);
    }
}

static void curve_frame(row *r)
{
    static curve c;
    loft_tangent at;

    read_curve(r, 3, &c);
    const loft_unit t = row_unit(r, "t_q16");
    if (!as_given(r))
        return;
    if (loft_rational_tangent(&c.r, t, &at) == LOFT_OK)
        expect_frame(r, &at, c.r.degree, c.ratio, c.size, 1);
    else
        row_complain(r, "the curve was refused");
}

static void nurbs_frame(row *r)
{
    static loft_vec p[POINTS];
    static loft_weighted both[POINTS];
    static loft_real knot[POINTS + MOST], w[POINTS];
    const unsigned degree = row_count(r, "p", LOFT_DEGREE_MAX), n = row_count(r, "n", POINTS);
    long double least = INFINITY, most = 0;
    loft_tangent at;
    loft_nurbs b;

    row_reals(r, "U_q16", n + degree + 1, knot);
    row_reals(r, "w_q16", n, w);
    const loft_real u = row_real(r, "u_q16");
    r->largest = 0;
    row_points(r, "P_q16", n, 3, p);
    for (unsigned k = 0; k < n; k++) {
        both[k] = (loft_weighted) { p[k], w[k] };
        least = fminl(least, exact_of(w[k]));
        most = fmaxl(most, exact_of(w[k]));
    }
    if (!as_given(r))
        return;
    if (loft_nurbs_init(&b, both, n, knot, degree) != LOFT_OK ||
        loft_nurbs_tangent(&b, u, &at) != LOFT_OK) {
        row_complain(r, "the curve was refused");
        return;
    }
    const unsigned span = loft_knots_find(&b.knots, u);
    expect_frame(r, &at, degree, most / least, 2 * sqrtl(3) * r->largest,
                 exact_of(knot[span + 1]) - exact_of(knot[span]));
}

static void bspline_thin(row *r)
{
    static loft_vec p[POINTS], q[POINTS];
    static loft_real knot[POINTS + MOST], knots[POINTS + MOST];
    const unsigned degree = row_count(r, "p", LOFT_DEGREE_MAX), n = row_count(r, "n", POINTS),
                   d = dimension(r), index = row_count(r, "knot", POINTS);
    loft_acc far = 0;
    loft_bspline b;

    row_reals(r, "U_q16", n + degree + 1, knot);
    r->largest = 0;
    row_points(r, "P_q16", n, d, p);
    if (loft_bspline_init(&b, p, n, knot, degree) != LOFT_OK)
        row_complain(r, "the curve was refused");
    if (!as_given(r) || r->complaint[0])
        return;
    const enum loft_status status = loft_bspline_remove(&b, index, q, knots, &far);
    expect_vecs(r, "Q", status, q, n - 1, d, (law){ .lsb = 0.501L, .roundings = 0x1p20L });
    /* far is that of the points as they were rounded */
    const char *text = row_text(r, "Q");
    long double moved = 0;
    for (unsigned k = 0; k + 1 < n && status == LOFT_OK; k++)
        for (unsigned axis = 0; axis < d; axis++)
            moved = fmaxl(moved, fabsl(exact_of(q[k].axis[axis]) - row_next(&text)));
    if (status == LOFT_OK)
        expect_within(r, "far", exact_acc(far),
                      sqrtl(d) * moved +
                          BY_NUM(0x1p-28L, 0x1p-44L, 0x1p-44L) * BY_NUM(1, r->largest, r->largest));
}

static void nurbs_thin(row *r)
{
    static loft_vec p[POINTS], q[POINTS];
    static loft_weighted both[POINTS], out[POINTS];
    static loft_real knot[POINTS + MOST], knots[POINTS + MOST], w[POINTS];
    const unsigned degree = row_count(r, "p", LOFT_DEGREE_MAX), n = row_count(r, "n", POINTS),
                   d = dimension(r), index = row_count(r, "knot", POINTS);
    answer *weights = answer_new();
    loft_acc far = 0;
    loft_nurbs b;

    row_reals(r, "U_q16", n + degree + 1, knot);
    row_reals(r, "w_q16", n, w);
    r->largest = 0;
    row_points(r, "P_q16", n, d, p);
    for (unsigned k = 0; k < n; k++)
        both[k] = (loft_weighted) { p[k], w[k] };
    if (loft_nurbs_init(&b, both, n, knot, degree) != LOFT_OK)
        row_complain(r, "the curve was refused");
    if (!as_given(r) || r->complaint[0])
        return;
    const enum loft_status status = loft_nurbs_remove(&b, index, out, knots, &far);
    for (unsigned k = 0; k + 1 < n && status == LOFT_OK; k++) {
        q[k] = out[k].p;
        answer_real(weights, out[k].w);
    }
    expect_vecs(r, "Q", status, q, n - 1, d, (law){ .lsb = 0.501L, .roundings = 0x1p20L });
    row_expect(r, "wQ", weights, (law){ .lsb = 0.501L, .roundings = 0x1p20L });
    const char *text = row_text(r, "dist");
    /* the curve of the rounded points is that of the row within what `far` counts too */
    row_within(r, "dist", fmaxl(row_next(&text) - exact_acc(far), 0) * 65536,
               BY_NUM(1.5L, 65536 * 4 * ulp(r->largest), 1e-9L));
}

static void curve_loops(row *r)
{
    static curve c;
    static loft_crossing found[MOST * MOST];
    const loft_real tol = LOFT_REAL(0.0009765625);
    size_t count = 0;

    read_curve(r, 2, &c);
    const enum loft_status status =
        c.weighted ? loft_rational_self_crossings(&c.r, tol, found, MOST * MOST, &count)
                   : loft_bezier_self_crossings(&c.b, tol, found, MOST * MOST, &count);
    if (!as_given(r))
        return;
    if (status != LOFT_OK)
        row_complain(r, "the curve was refused, or lies over itself: %d", (int)status);
    if (!expect_count(r, (unsigned)count))
        return;
    const char *text = row_text(r, "st");
    for (size_t k = 0; k < count; k++) {
        const long double s = row_next(&text), t = row_next(&text);
        const long double off = fmaxl(
            fmaxl(exact_unit(found[k].s_from) - s, s - exact_unit(found[k].s_to)),
            fmaxl(exact_unit(found[k].t_from) - t, t - exact_unit(found[k].t_to)));
        row_within(r, "st", fmaxl(off, 0) * 65536, 0x1p-24L * 65536);
    }
}

static void curve_closest(row *r)
{
    loft_vec p[MOST], x;
    loft_bezier b;
    loft_nearest near = { 0 };
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX), d = dimension(r);
    const loft_real tol = LOFT_REAL(1.0 / 65536);

    row_points(r, "P_q16", n + 1, d, p);
    row_points(r, "X_q16", 1, d, &x);
    if (loft_bezier_init(&b, p, n) != LOFT_OK || loft_bezier_nearest(&b, x, tol, &near) != LOFT_OK)
        row_complain(r, "the point was refused");
    if (!as_given(r))
        return;
    const char *text = row_text(r, "dist");
    const long double want = row_next(&text), got = exact_acc(near.distance),
                      slack = BY_NUM(0x1p-25L * want + 0x1p-29L, 0x1p-42L * 4 * r->largest,
                                     0x1p-42L * 4 * r->largest);
    row_within(r, "dist", fmaxl(got - want, 0) * 65536, (LSB + slack) * 65536);
    row_within(r, "dist", fmaxl(want - got, 0) * 65536, slack * 65536);
    if (got - want < slack && want > 1)
        expect_within(r, "t", exact_unit(near.t), 0x1p-8L);
}

static void curve_box(row *r)
{
    loft_vec p[MOST];
    loft_bezier b;
    const unsigned n = row_count(r, "n", LOFT_DEGREE_MAX);

    row_points(r, "P_q16", n + 1, 3, p);
    if (loft_bezier_init(&b, p, n) != LOFT_OK)
        row_complain(r, "the curve was refused");
    if (!as_given(r))
        return;
    const loft_box box = loft_bezier_bounds(&b);
    const char *text = row_text(r, "box");
    for (unsigned side = 0; side < 2; side++)
        for (int axis = 0; axis < 3; axis++) {
            const long double want = row_next(&text);
            const long double got = exact_of(side ? box.max.axis[axis] : box.min.axis[axis]);
            const long double beyond = side ? got - want : want - got;
            row_within(r, "box", fmaxl(beyond, 0) * 65536,
                       65536 * BY_NUM(2 * LSB, 3 * ulp(want) + 0x1p-42L * r->largest,
                                      ulp(want) + 0x1p-42L * r->largest));
            row_within(r, "box", fmaxl(-beyond, 0) * 65536, 1e-12L);
        }
}

const vector_system vectors_along[] = {
    { "bezier_flat", "n,P_q16,w_q16,status,count,t,mult", bezier_flat,
      "status, count, mult exact, t 2^-25 + 2^-32" },
    { "curve_frame", "n,P_q16,w_q16,t_q16,status,kappa,tau,T,N,B", curve_frame,
      "status exact, the others as curve/tangent.h with the largest D1, D2, D3" },
    { "nurbs_frame", "p,n,U_q16,P_q16,w_q16,u_q16,status,kappa,tau,T,N,B", nurbs_frame,
      "as curve_frame, over the length of the span" },
    { "bspline_thin", "p,n,d,U_q16,P_q16,knot,Q,far", bspline_thin,
      "Q 0.501 LSB, far sqrt(d) times the error of Q" },
    { "nurbs_thin", "p,n,d,U_q16,P_q16,w_q16,knot,Q,wQ,dist", nurbs_thin,
      "Q, wQ 0.501 LSB, dist at most far + 1.5 LSB" },
    { "curve_loops", "n,P_q16,w_q16,count,st", curve_loops,
      "count exact, s, t within the stretches + 2^-24, tol 2^-10" },
    { "rational_loops", "n,P_q16,w_q16,count,st", curve_loops,
      "count exact, s, t within the stretches + 2^-24, tol 2^-10" },
    { "curve_closest", "n,d,P_q16,X_q16,t,dist", curve_closest,
      "dist from -(2^-25 of it + 2^-29) to that + 1 LSB" },
    { "curve_box", "n,P_q16,box", curve_box, "q16: 2 LSB beyond, never inside" },
    { 0 }
};

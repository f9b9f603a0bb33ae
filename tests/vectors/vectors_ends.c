/* tests/vectors/vectors_ends.c -- readers of the splines with ends of any kind, with tension, and
 * with knots by distance
 * SPDX-License-Identifier: MIT
 */
#include "vectors/vectors_points.h"         /* expect_vec, as_given; row, answer, law */
#include "curve/catmull.h"
#include "curve/spline.h"
#include "curve/tcb.h"

#define POINTS 600

typedef struct {
    unsigned d, count, i;
    bool chord;
    loft_unit t;
    loft_vec p[POINTS];
    loft_spline_knot memory[POINTS];
    loft_spline s;
} spline;

static void read_spline(row *r, spline *x, const char *count, unsigned more)
{
    x->d = dimension(r);
    x->count = row_count(r, count, POINTS - more) + more;
    x->i = row_count(r, "i", POINTS);
    x->t = row_unit(r, "t_q16");
    row_points(r, "P_q16", x->count, x->d, x->p);
}

static enum loft_spacing spacing_of(row *r, spline *x)
{
    x->chord = row_is(r, "kind", "chord");
    return x->chord ? LOFT_CHORD : LOFT_UNIFORM;
}

static long double step_between(const loft_vec *p, const loft_vec *q, unsigned d)
{
    long double sum = 0;
    for (unsigned i = 0; i < d; i++)
        sum += powl(exact_of(q->axis[i]) - exact_of(p->axis[i]), 2);
    return sqrtl(sum);
}

/* S of curve/spline.h: of the slopes, and of chords over their steps, which are 1 if steps are the
 * chords. */
static long double steepest(const spline *x)
{
    const unsigned n = (unsigned)x->s.count;
    long double most = x->chord ? 1 : 0;

    for (unsigned i = 0; i < n; i++) {
        if (!x->chord)
            most = fmaxl(most, step_between(&x->s.p[i], &x->s.p[(i + 1) % n], x->d));
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            loft_acc slope = 0;
            if (loft_sci_to_acc(x->s.knot[i].slope[axis], &slope))
                most = fmaxl(most, fabsl(exact_acc(slope)));
        }
    }
    return most;
}

/* h of curve/spline.h */
static long double step_of(const spline *x)
{
    const unsigned n = (unsigned)x->s.count;
    return x->chord ? step_between(&x->s.p[x->i % n], &x->s.p[(x->i + 1) % n], x->d) : 1;
}

/* In q16 lsb[k] bounds the k-th derivative. In floats it is what curve/spline.h says, and, where
 * f32 could not hold the points, what reading rounded, times the largest weights of a point. `hard`
 * is Q there. */
static void expect_spline(row *r, const spline *x, const long double lsb[3], long double hard)
{
    loft_vec v[3] = { { { 0 } } };
    enum loft_status status[3];
    const long double h = step_of(x), steep = steepest(x) * hard * 0x1p-46L,
                      ulp_of = ulp_double(r->largest),
                      room[3] = { 16 * ulp_of + steep * h / 4, steep, steep / h };

    status[0] = loft_spline_eval(&x->s, x->i, x->t, &v[0]);
    status[1] = loft_spline_deriv(&x->s, x->i, 1, x->t, &v[1]);
    status[2] = loft_spline_deriv(&x->s, x->i, 2, x->t, &v[2]);
    for (unsigned k = 0; k < 3; k++) {
        static const char *const column[3] = { "p", "dp", "ddp" };
        const long double gain = k == 0 ? 3 : 60;
        const law l = { .lsb = lsb[k], .gain = gain, .roundings = room[k] / (gain * ulp_of) };
        expect_vec(r, column[k], status[k], v[k], x->d, l);
    }
}

static const long double rounded[3] = { 0.5L + 1 / 4096.0L, 0.5L + 1 / 4096.0L,
                                        0.5L + 1 / 4096.0L };

static bool started(row *r, const spline *x, enum loft_status start)
{
    if (as_given(r))
        row_expect_word(r, "status", start == LOFT_SINGULAR ? "zero_chord" : "ok");
    if (start != LOFT_OK && start != LOFT_SINGULAR)
        row_complain(r, "refused with status %d", start);
    return start == LOFT_OK && (as_given(r) || !x->chord);
}

static void spline_closed(row *r)
{
    static spline x;

    read_spline(r, &x, "n", 0);
    if (started(
            r, &x,
            loft_spline_init(&x.s, x.p, x.count, LOFT_ENDS_CLOSED, spacing_of(r, &x), x.memory)))
        expect_spline(r, &x, rounded, 1);
}

static void spline_clamped(row *r)
{
    static spline x;
    loft_vec slope[2];

    read_spline(r, &x, "n", 0);
    row_points(r, "T0_q16", 1, x.d, &slope[0]);
    row_points(r, "T1_q16", 1, x.d, &slope[1]);
    if (started(r, &x,
                loft_spline_clamped_init(&x.s, x.p, x.count, slope, spacing_of(r, &x), x.memory)))
        expect_spline(r, &x, rounded, 1);
}

/* Q of curve/spline.h */
static long double hardness(const spline *x)
{
    const unsigned n = x->count;
    if (!x->chord || n < 4)
        return 1;
    const loft_vec *p = x->p;
    return fmaxl(step_between(&p[0], &p[1], x->d) / step_between(&p[1], &p[2], x->d), 1) *
           fmaxl(step_between(&p[n - 2], &p[n - 1], x->d) /
                     step_between(&p[n - 3], &p[n - 2], x->d),
                 1);
}

static void spline_notaknot(row *r)
{
    static spline x;
    long double lsb[3];

    read_spline(r, &x, "n", 0);
    if (!started(r, &x,
                 loft_spline_init(&x.s, x.p, x.count, LOFT_ENDS_NOT_A_KNOT, spacing_of(r, &x),
                                  x.memory)))
        return;
    const long double h = step_of(&x), hard = hardness(&x);
    const long double by[3] = { h * 0x1p-3L, 1, 1 / h }, steep = steepest(&x);
    for (int k = 0; k < 3; k++)
        lsb[k] = fminl(rounded[k] + 0x1p-38L * steep * hard * by[k], 8 << k);
    expect_spline(r, &x, lsb, hard);
}

static void natural_hidden(row *r)
{
    static spline x;
    const enum loft_spline_hidden hidden = row_is(r, "form", "through") ? LOFT_HIDDEN_THROUGH
                                                                        : LOFT_HIDDEN_SLOPE;

    read_spline(r, &x, "N", 3);
    if (loft_spline_hidden_init(&x.s, x.p, x.count, hidden, x.memory) != LOFT_OK)
        row_complain(r, "the spline was refused");
    else
        expect_spline(r, &x, rounded, 1);
}

static loft_tcb row_tcb(row *r, const char *column)
{
    const long double largest = r->largest, inexact = r->inexact;
    loft_real x[3];

    row_reals(r, column, 3, x);
    r->largest = largest;
    r->inexact = inexact;
    return (loft_tcb) { loft_unit_from(x[0]), loft_unit_from(x[1]), loft_unit_from(x[2]) };
}

/* The factors of a chord are at most 27 / 2, so 54 of the largest coordinate. */
static void tcb(row *r)
{
    const unsigned d = dimension(r);
    const loft_tcb k1 = row_tcb(r, "k1_q16"), k2 = row_tcb(r, "k2_q16");
    const loft_unit t = row_unit(r, "t_q16");
    loft_vec p[4], tangent[2] = { { { 0 } } }, v[3] = { { { 0 } } };
    enum loft_status status[3];

    row_points(r, "P_q16", 4, d, p);
    const enum loft_status first = loft_tcb_tangents(p, &k1, &k2, tangent);
    expect_vec(r, "T1", first, tangent[0], d, (law) { .lsb = 0.501L, .gain = 54, .roundings = 4 });
    expect_vec(r, "T2", first, tangent[1], d, (law) { .lsb = 0.501L, .gain = 54, .roundings = 4 });
    status[0] = loft_tcb_eval(p, &k1, &k2, t, &v[0]);
    status[1] = loft_tcb_deriv(p, &k1, &k2, 1, t, &v[1]);
    status[2] = loft_tcb_deriv(p, &k1, &k2, 2, t, &v[2]);
    expect_vec(r, "p", status[0], v[0], d, (law) { .lsb = 0.501L, .gain = 17, .roundings = 16 });
    expect_vec(r, "dp", status[1], v[1], d, (law) { .lsb = 0.501L, .gain = 114, .roundings = 36 });
    expect_vec(r, "ddp", status[2], v[2], d, (law) { .lsb = 0.501L, .gain = 340, .roundings = 36 });
}

static void catmull_alpha(row *r)
{
    const unsigned d = dimension(r);
    const loft_unit alpha = row_unit(r, "alpha_q16"), t = row_unit(r, "s_q16");
    loft_vec p[4], v[2] = { { { 0 } } };

    row_points(r, "P_q16", 4, d, p);
    const enum loft_status point = loft_catmull_eval(p, alpha, t, &v[0]),
                           first = loft_catmull_deriv(p, alpha, 1, t, &v[1]);
    if (!as_given(r))
        return;
    row_expect_word(r, "status", point == LOFT_SINGULAR ? "zero_chord" : "ok");
    if (point == LOFT_SINGULAR)
        return;
    expect_vec(r, "p", point, v[0], d, (law) { .lsb = 0.501L, .roundings = 64 });
    expect_vec(r, "dp", first, v[1], d, (law) { .lsb = 0.501L, .roundings = 512 });
}

const vector_system vectors_ends[] = {
    { "spline_closed", "n,d,kind,P_q16,i,t_q16,status,p,dp,ddp", spline_closed,
      "status exact, p, dp, ddp 1/2 LSB + 2^-12 LSB" },
    { "spline_clamped", "n,d,kind,P_q16,T0_q16,T1_q16,i,t_q16,status,p,dp,ddp", spline_clamped,
      "status exact, p, dp, ddp 1/2 LSB + 2^-12 LSB" },
    { "spline_notaknot", "n,d,kind,P_q16,i,t_q16,status,p,dp,ddp", spline_notaknot,
      "status exact, p, dp, ddp 1/2 LSB + 2^-12 LSB + 2^-54 S Q, at most 8, 16, 32" },
    { "natural_hidden", "N,d,form,P_q16,i,t_q16,p,dp,ddp", natural_hidden,
      "p, dp, ddp 1/2 LSB + 2^-12 LSB" },
    { "tcb", "d,P_q16,k1_q16,k2_q16,t_q16,T1,T2,p,dp,ddp", tcb, "1/2 LSB + 2^-10 LSB" },
    { "catmull_alpha", "d,P_q16,alpha_q16,s_q16,status,p,dp", catmull_alpha,
      "status exact, p, dp 1/2 LSB + 2^-10 LSB" },
    { NULL, NULL, NULL, NULL }
};

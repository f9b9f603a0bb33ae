/* lib/curve/join.c
 * SPDX-License-Identifier: MIT
 *
 * With a = a[n], u = b[1], and integers throughout:
 *
 *     D = <a, a>    N = <u, a>    alpha = N / D
 *     G1: the component of u perpendicular to a is  (D u - N a) / D
 *     W = D^2 b[2] + N^2 a[n-1] = D^2 (b[2] + alpha^2 a[n-1])
 *     G2: its component perpendicular to a is  (D W - <W, a> a) / D^3,  and eta = <W, a> / D^3
 *
 * Range: an edge is below 2^e, e = 32 in q16 and 129 in floats (num/exact.h). With 6 axes D and N
 * are below 2^(2e + 2.6), W below 2^(5e + 6.2) and D W - <W, a> a below 2^(7e + 9.8): 234 bits of
 * 447, and 913 of 1087. */
#include "curve/join.h"
#include "geom/vec_exact.h" /* loft_exact: no decision depends on rounding */

typedef struct {
    loft_exact axis[LOFT_AXES];
} whole_vec;

static whole_vec edge(loft_vec from, loft_vec to)
{
    whole_vec v;

    loft_vec_exact_sub(&to, &from, LOFT_AXES, v.axis);
    return v;
}

/* v = x v - y a */
static void combine(whole_vec *v, loft_exact x, loft_exact y, const whole_vec *a)
{
    for (int i = 0; i < LOFT_AXES; i++)
        v->axis[i] = loft_exact_sub(loft_exact_mul(x, v->axis[i]), loft_exact_mul(y, a->axis[i]));
}

static void subtract(whole_vec *v, const whole_vec *a)
{
    for (int i = 0; i < LOFT_AXES; i++)
        v->axis[i] = loft_exact_sub(v->axis[i], a->axis[i]);
}

/* True if |v / d| <= tol; for tol = 0: if v is null. */
static bool is_within(const whole_vec *v, loft_exact d, loft_real tol)
{
    const loft_acc wide = loft_to_acc(tol);
    loft_acc x[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        if (!(tol > 0)) {
            if (loft_exact_sign(v->axis[i]))
                return false;
        } else if (!loft_exact_quot(v->axis[i], d, -LOFT_EXACT_REAL, &x[i]) || x[i] > wide ||
                   x[i] < -wide) {
            return false;
        }
    }
    return !(tol > 0) || loft_acc_hypot(x, LOFT_AXES) <= wide;
}

static void decide_parametric(loft_join *j, const loft_vec p[], const loft_vec q[], unsigned curved,
                              loft_real tol)
{
    const loft_exact one = loft_exact_from_int(1);
    whole_vec gap = edge(p[0], q[0]);
    const whole_vec a = edge(p[-1], p[0]);

    j->c0 = j->g0 = is_within(&gap, one, tol);
    gap = edge(q[0], q[1]);
    subtract(&gap, &a);
    j->c1 = j->c2 = j->c0 && is_within(&gap, one, tol);
    if (curved && j->c1) {                      /* (b2 - b1) - (a - a1) */
        const whole_vec b1 = edge(q[0], q[1]), a1 = edge(p[-2], p[-1]);
        gap = edge(q[1], q[2]);
        subtract(&gap, &b1);
        subtract(&gap, &a);
        combine(&gap, one, loft_exact_from_int(-1), &a1);
        j->c2 = is_within(&gap, one, tol);
    }
}

/* Decide G2 and eta, for G1 with alpha = n / d. True if eta fits a coordinate. */
static bool decide_curvature(loft_join *j, const loft_vec p[], const loft_vec q[], loft_exact n,
                             loft_exact d, loft_real tol)
{
    const loft_exact d2 = loft_exact_mul(d, d), d3 = loft_exact_mul(d2, d);
    const whole_vec a = edge(p[-1], p[0]), a1 = edge(p[-2], p[-1]);
    whole_vec w = edge(q[1], q[2]);

    combine(&w, d2, loft_exact_neg(loft_exact_mul(n, n)), &a1);
    const loft_exact along = loft_vec_exact_dot(w.axis, a.axis, LOFT_AXES);
    combine(&w, d, along, &a);
    j->g2 = is_within(&w, d3, tol);
    return !j->g2 || loft_exact_quot_real(along, d3, 0, &j->eta);
}

/* For two lines W = (D N + N^2) a: eta = (N D + N^2) / D^2. */
static bool decide_lines(loft_join *j, loft_exact n, loft_exact d)
{
    j->g2 = true;
    return loft_exact_quot_real(loft_exact_mul(n, loft_exact_add(n, d)), loft_exact_mul(d, d), 0,
                                &j->eta);
}

enum loft_status loft_join_init(loft_join *j, const loft_bezier *p, const loft_bezier *q,
                                loft_real tol)
{
    const loft_vec *last = p->p + p->degree;
    const unsigned count = p->degree < 2 ? p->degree : 2;
    const loft_join nothing = { false, false, false, false, false, false, false, 0, 0 };

    *j = nothing;
    if (p->degree != q->degree || p->degree < 1 || !(tol >= 0))
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k <= count; k++)
        if (!loft_vec_exact_valid(last - k, 1, LOFT_AXES) ||
            !loft_vec_exact_valid(&q->p[k], 1, LOFT_AXES))
            return LOFT_ERR_RANGE;

    decide_parametric(j, last, q->p, count > 1, tol);

    const whole_vec a = edge(last[-1], last[0]);
    whole_vec u = edge(q->p[0], q->p[1]);
    const loft_exact one = loft_exact_from_int(1);
    const loft_exact d = loft_vec_exact_dot(a.axis, a.axis, LOFT_AXES);
    const loft_exact n = loft_vec_exact_dot(u.axis, a.axis, LOFT_AXES);

    j->regular = !is_within(&a, one, tol) && !is_within(&u, one, tol);
    if (!j->regular || !j->c0 || loft_exact_sign(n) <= 0)
        return LOFT_OK;
    combine(&u, d, n, &a);
    j->g1 = is_within(&u, d, tol);
    if (!j->g1)
        return LOFT_OK;
    const bool fits = loft_exact_quot_real(n, d, 0, &j->alpha);
    return (count > 1 ? decide_curvature(j, last, q->p, n, d, tol) : decide_lines(j, n, d)) && fits
               ? LOFT_OK
               : LOFT_ERR_RANGE;
}

/* One axis, in units of 2^-R for c[1] * 2^R and c[2] * 2^(2R), R = LOFT_EXACT_REAL: below
 * 2^(3e). */
static bool continue_axis(const loft_vec last[], int i, loft_real alpha, loft_real eta,
                          loft_vec c[])
{
    const loft_exact one = loft_exact_from_int(1), p = loft_exact_from_real(last[0].axis[i]);
    const loft_exact p1 = loft_exact_from_real(last[-1].axis[i]),
                     p2 = loft_exact_from_real(last[-2].axis[i]);
    const loft_exact x = loft_exact_from_real(alpha), y = loft_exact_from_real(eta),
                     a = loft_exact_sub(p, p1);
    const loft_exact c1 = loft_exact_add(loft_exact_shift(p, LOFT_EXACT_REAL),
                                         loft_exact_mul(x, a));
    const loft_exact curved = loft_exact_mul(loft_exact_mul(x, x), loft_exact_sub(p1, p2));
    const loft_exact c2 = loft_exact_sub(
        loft_exact_shift(loft_exact_add(c1, loft_exact_mul(y, a)), LOFT_EXACT_REAL), curved);

    c[0].axis[i] = last[0].axis[i];
    return loft_exact_quot_real(c1, one, -2 * LOFT_EXACT_REAL, &c[1].axis[i]) &&
           loft_exact_quot_real(c2, one, -3 * LOFT_EXACT_REAL, &c[2].axis[i]);
}

enum loft_status loft_join_continue(const loft_bezier *p, loft_real alpha, loft_real eta,
                                    loft_vec c[3])
{
    const loft_vec *last = p->p + p->degree;
    loft_vec out[3];

    if (p->degree < 2)
        return LOFT_ERR_ARG;
    if (!loft_exact_valid(alpha) || !loft_exact_valid(eta))
        return LOFT_ERR_RANGE;
    for (int k = 0; k < 3; k++)
        if (!loft_vec_exact_valid(last - k, 1, LOFT_AXES))
            return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++)
        if (!continue_axis(last, i, alpha, eta, out))
            return LOFT_ERR_RANGE;
    for (int k = 0; k < 3; k++)
        c[k] = out[k];
    return LOFT_OK;
}

/* tests/lib/curve/test_join.c -- properties of lib/curve/join.h
 * SPDX-License-Identifier: MIT
 */
#include "support/joins.h"          /* joins_flags, and through it exact.h, check.h */

typedef struct {
    loft_vec p[LOFT_DEGREE_MAX + 1], q[LOFT_DEGREE_MAX + 1];
    loft_bezier first, second;
    unsigned n;
} joint;

/* An integer number of LSB. */
static loft_real lsb(int32_t raw) { return (loft_real)BY_NUM(raw, raw / 65536.0, raw / 65536.0); }

static void set(joint *g, unsigned n)
{
    g->n = n;
    CHECK(loft_bezier_init(&g->first, g->p, n) == LOFT_OK);
    CHECK(loft_bezier_init(&g->second, g->q, n) == LOFT_OK);
}

/* Coordinates of up to `size` LSB, exact in all types for sizes up to 2^23; Q continues with alpha
 * = up / down. */
static void arb_joint(arb *a, joint *g, unsigned n, int32_t size, int32_t up, int32_t down,
                      int32_t eta)
{
    const int32_t step = size < down * down ? down * down : size / (down * down) * (down * down);
    for (unsigned k = 0; k <= n; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            g->p[k].axis[i] = lsb(arb_raw(a, size));
            g->q[k].axis[i] = lsb(arb_raw(a, size));
        }
    for (int i = 0; i < LOFT_AXES; i++) {
        const int32_t e = arb_raw(a, step / (down * down)) * down * down,
                      e1 = arb_raw(a, step / (down * down)) * down * down;
        const int32_t end = (int32_t)joins_raw(g->p[n].axis[i]), next = end + e / down * up;
        g->p[n-1].axis[i] = lsb(end - e);
        g->q[0].axis[i]   = lsb(end);
        g->q[1].axis[i]   = lsb(next);
        if (n > 1) {
            g->p[n-2].axis[i] = lsb(end - e - e1);
            g->q[2].axis[i]   = lsb(next - e1 / (down * down) * up * up + eta * e);
        }
    }
    set(g, n);
}

static loft_join decide(const joint *g)
{
    loft_join j;
    const enum loft_status status = loft_join_init(&j, &g->first, &g->second, 0);
    CHECK(status == LOFT_OK || status == LOFT_ERR_RANGE);
    return j;
}

static bool agree(const loft_join *a, const loft_join *b)
{
    return a->c0 == b->c0 && a->c1 == b->c1 && a->c2 == b->c2 && a->g0 == b->g0 && a->g1 == b->g1 &&
           a->g2 == b->g2 && a->regular == b->regular;
}

/* Joints built to be smooth, and joints one LSB off: exactly the answer of integer arithmetic. */
static void flags_are_those_of_whole_numbers(arb *a)
{
    const int32_t sizes[6] = { 1, 2, 5, 300, 65536, 1 << 20 }, size = sizes[arb_below(a, 6)];
    const unsigned n = 1 + arb_below(a, LOFT_DEGREE_MAX);
    joint g;
    long double alpha, eta;

    arb_joint(a, &g, n, size, 1 + (int32_t)arb_below(a, 3), 1 + (int32_t)arb_below(a, 3),
              (int32_t)arb_below(a, 5) - 2);
    loft_real *one[3] = { &g.q[0].axis[arb_below(a, LOFT_AXES)],
                          &g.q[1].axis[arb_below(a, LOFT_AXES)],
                          &g.q[n > 1 ? 2 : 1].axis[arb_below(a, LOFT_AXES)] };
    if (arb_below(a, 2))
        *one[arb_below(a, 3)] += lsb(arb_below(a, 2) ? 1 : -1);

    const loft_join j = decide(&g), want = joins_flags(g.p, g.q, n, &alpha, &eta);
    CHECK(agree(&j, &want));
    /* factors that do not fit a coordinate: flags only */
    if (BY_NUM(alpha > 32767 || fabsl(eta) > 32767, false, false))
        return;
    if (want.g1)
        CHECK_EXACT(exact_of(j.alpha), alpha, ulp(alpha));
    else
        CHECK_EXACT(exact_of(j.alpha), 0, 0);
    if (want.g2 && n > 1)
        CHECK_EXACT(exact_of(j.eta), eta, ulp(eta) + 1e-17L * (fabsl(eta) + alpha * alpha * 1e7L));
}

static int seen[4];

/* The constructed continuation is G2, and C2 for alpha = 1, eta = 2; one LSB off it is not. */
static void a_continuation_is_g2(arb *a)
{
    const unsigned n = 2 + arb_below(a, LOFT_DEGREE_MAX - 1);
    const int32_t half[4] = { 32768, 65536, 98304, 131072 };
    const int32_t alpha = half[arb_below(a, 4)], eta = 65536 * ((int32_t)arb_below(a, 9) - 4);
    joint g;
    loft_vec c[3];

    arb_joint(a, &g, n, 1 << 18, 2, 2, 0);    /* edges are multiples of 4 LSB: nothing is rounded */
    CHECK(loft_join_continue(&g.first, lsb(alpha), lsb(eta), c) == LOFT_OK);
    for (int k = 0; k < 3; k++)
        g.q[k] = c[k];
    loft_join j = decide(&g);
    CHECK(j.c0 && j.g2 == j.regular && j.g1 == j.regular);
    if (!j.regular)
        return;
    CHECK_EXACT(exact_of(j.alpha), alpha / 65536.0L, 0);
    CHECK_EXACT(exact_of(j.eta), eta / 65536.0L, 0);
    CHECK(j.c1 == (alpha == 65536) && j.c2 == (alpha == 65536 && eta == 131072));
    seen[0] += j.c2;
#if LOFT_AXES > 1
    int axis = 0;       /* sideways unless all other components of the edge are 0 */
    for (int i = 0; i < LOFT_AXES; i++)
        if (joins_raw(g.p[n].axis[i]) == joins_raw(g.p[n-1].axis[i]))
            axis = i;
    g.q[2].axis[axis] += lsb(1);
    long double x, y;
    const loft_join want = joins_flags(g.p, g.q, n, &x, &y);
    j = decide(&g);
    CHECK(agree(&j, &want));
    seen[1] += !j.g2;
#endif
}

/* The points of a continuation, against long double. */
static void continues_by_the_formula(arb *a)
{
    const unsigned n = 2 + arb_below(a, LOFT_DEGREE_MAX - 1);
    const loft_real alpha = arb_real(a, 4), eta = arb_real(a, 4);
    loft_vec p[LOFT_DEGREE_MAX + 1], c[3];
    loft_bezier b;

    for (unsigned k = 0; k <= n; k++)
        p[k] = arb_vec(a, 300);
    CHECK(loft_bezier_init(&b, p, n) == LOFT_OK);
    CHECK(loft_join_continue(&b, alpha, eta, c) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double p0 = exact_of(p[n].axis[i]), p1 = exact_of(p[n - 1].axis[i]),
                          p2 = exact_of(p[n - 2].axis[i]);
        const long double x = exact_of(alpha), c1 = p0 + x * (p0 - p1),
                          c2 = c1 - x * x * (p1 - p2) + exact_of(eta) * (p0 - p1);
        CHECK_EXACT(exact_of(c[0].axis[i]), p0, 0);
        CHECK_EXACT(exact_of(c[1].axis[i]), c1, BY_NUM(LSB * 0.50002L, ulp(c1) * 0.5001L, ulp(c1)));
        CHECK_EXACT(exact_of(c[2].axis[i]), c2,
                    BY_NUM(LSB * 0.50002L, ulp(c2) * 0.5001L + 1e-14L, ulp(c2) + 1e-14L));
    }
}

/* Reversed, the same joint is as smooth, and alpha is its inverse. */
static void smooth_both_ways(arb *a)
{
    const unsigned n = 1 + arb_below(a, LOFT_DEGREE_MAX);
    joint g, back;

    arb_joint(a, &g, n, 1 << 12, 1 + (int32_t)arb_below(a, 3), 1 + (int32_t)arb_below(a, 2),
              (int32_t)arb_below(a, 3));
    if (arb_below(a, 3) == 0)
        g.q[n > 1 ? 2 : 1].axis[0] += lsb(1);
    for (unsigned k = 0; k <= n; k++) {
        back.p[k] = g.q[n - k];
        back.q[k] = g.p[n - k];
    }
    set(&back, n);
    const loft_join j = decide(&g), i = decide(&back);
    CHECK(agree(&i, &j));
    if (j.g1 && i.g1)
        CHECK_NEAR(exact_of(i.alpha) * exact_of(j.alpha), 1, BY_NUM(1e-4, 1e-6, 1e-15));
}

typedef struct {
    long double c0, c1, c2, g1, g2, a, b1;
} gaps;

static long double length(const long double v[])
{
    long double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += v[i] * v[i];
    return sqrtl(sum);
}

static long double inner(const long double u[], const long double v[])
{
    long double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += u[i] * v[i];
    return sum;
}

static long double across(const long double u[], const long double v[])
{
    long double r[LOFT_AXES];
    for (int i = 0; i < LOFT_AXES; i++)
        r[i] = u[i] - inner(u, v) / inner(v, v) * v[i];
    return length(r);
}

static gaps measured(const joint *g)
{
    long double c0[LOFT_AXES], c1[LOFT_AXES], c2[LOFT_AXES], a[LOFT_AXES], a1[LOFT_AXES],
        b1[LOFT_AXES], w[LOFT_AXES];
    const unsigned n = g->n;

    for (int i = 0; i < LOFT_AXES; i++) {
        a[i]  = exact_of(g->p[n].axis[i]) - exact_of(g->p[n-1].axis[i]);
        a1[i] = exact_of(g->p[n-1].axis[i]) - exact_of(g->p[n-2].axis[i]);
        b1[i] = exact_of(g->q[1].axis[i]) - exact_of(g->q[0].axis[i]);
        w[i]  = exact_of(g->q[2].axis[i]) - exact_of(g->q[1].axis[i]);
        c0[i] = exact_of(g->q[0].axis[i]) - exact_of(g->p[n].axis[i]);
        c1[i] = b1[i] - a[i];
        c2[i] = w[i] - b1[i] - a[i] + a1[i];
    }
    const long double alpha = inner(b1, a) / inner(a, a);
    for (int i = 0; i < LOFT_AXES; i++)
        w[i] += alpha * alpha * a1[i];
    return (gaps){ length(c0),   length(c1), length(c2), alpha > 0 ? across(b1, a) : INFINITY,
                   across(w, a), length(a),  length(b1) };
}

static bool is_clear(long double gap, long double tol) { return fabsl(gap - tol) > tol * 1e-6L; }

/* With a tolerance: each flag is the comparison of a length. */
static void a_tolerance_is_a_length(arb *a)
{
    const unsigned n = 2 + arb_below(a, LOFT_DEGREE_MAX - 1);
    const loft_real tol = lsb(1 + (int32_t)arb_below(a, 4000));
    const long double t = exact_of(tol);
    joint g;
    loft_join j;

    arb_joint(a, &g, n, arb_below(a, 4) ? 1 << 20 : 4000, 1 + (int32_t)arb_below(a, 3),
              1 + (int32_t)arb_below(a, 2), (int32_t)arb_below(a, 3));
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            g.q[k].axis[i] += lsb(arb_raw(a, 1 + (int32_t)arb_below(a, 2000)));
    CHECK(loft_join_init(&j, &g.first, &g.second, tol) == LOFT_OK);

    const gaps m = measured(&g);
    if (!is_clear(m.c0, t) || !is_clear(m.c1, t) || !is_clear(m.c2, t) || !is_clear(m.g1, t) ||
        !is_clear(m.g2, t) || !is_clear(m.a, t) || !is_clear(m.b1, t))
        return;
    const bool regular = m.a > t && m.b1 > t;
    CHECK(j.regular == regular);
    CHECK(j.c0 == (m.c0 <= t) && j.g0 == j.c0);
    CHECK(j.c1 == (j.c0 && m.c1 <= t));
    CHECK(j.c2 == (j.c1 && m.c2 <= t));
    CHECK(j.g1 == (j.c0 && regular && m.g1 <= t));
    CHECK(j.g2 == (j.g1 && m.g2 <= t));
    seen[2] += j.g2;
    seen[3] += j.g1 && !j.g2;
}

static void refuses_what_it_cannot_decide(arb *a)
{
    joint g;
    loft_join j;
    loft_vec c[3] = { { { 0 } } };
    loft_bezier other;

    arb_joint(a, &g, 3, 1000, 1, 1, 0);
    CHECK(loft_bezier_init(&other, g.q, 2) == LOFT_OK);
    CHECK(loft_join_init(&j, &g.first, &other, 0) == LOFT_ERR_ARG && !j.c0);
    CHECK(loft_join_init(&j, &g.first, &g.second, -lsb(1)) == LOFT_ERR_ARG);
    CHECK(loft_bezier_init(&other, g.q, 0) == LOFT_OK &&
          loft_join_init(&j, &other, &other, 0) == LOFT_ERR_ARG);
    CHECK(loft_bezier_init(&other, g.q, 1) == LOFT_OK &&
          loft_join_continue(&other, lsb(65536), 0, c) == LOFT_ERR_ARG);

    for (int k = 0; k < 4; k++)         /* edges of 50000: their continuation is beyond q16, but
                                         * within floats */
        for (int i = 0; i < LOFT_AXES; i++)
            g.p[k].axis[i] = (loft_real)((k % 2 ? 25000 : -25000) * BY_NUM(65536, 1, 1));
    set(&g, 3);
    CHECK(loft_join_continue(&g.first, lsb(65536), 0, c) ==
          BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
    CHECK(BY_NUM(c[0].axis[0] == 0, true, true));       /* and c[] is untouched */

    for (int k = 0; k < 3; k++)         /* alpha = 50000, eta = 0 */
        for (int i = 0; i < LOFT_AXES; i++) {
            g.p[3].axis[i] = g.q[0].axis[i] = g.p[1].axis[i] = 0;
            g.p[2].axis[i] = -lsb(1);
            g.p[1].axis[i] = -lsb(1);
            g.q[1].axis[i] = g.q[2].axis[i] = lsb(50000);
        }
    CHECK(loft_join_init(&j, &g.first, &g.second, 0) == BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
    CHECK(j.g2 && !j.c1 && BY_NUM(j.alpha == 0, j.alpha > 49999, j.alpha > 49999));
}

#if LOFT_NUM != LOFT_Q16
static void refuses_floats_that_are_not_exact(arb *a)
{
    joint g;
    loft_join j;

    arb_joint(a, &g, 3, 1000, 1, 1, 0);
    g.q[2].axis[0] = (loft_real)2e6;
    CHECK(loft_join_init(&j, &g.first, &g.second, 0) == LOFT_ERR_RANGE && !j.c0);
    g.q[2].axis[0] = (loft_real)NAN;
    CHECK(loft_join_init(&j, &g.first, &g.second, 0) == LOFT_ERR_RANGE);
    CHECK(loft_join_init(&j, &g.first, &g.second, (loft_real)NAN) == LOFT_ERR_ARG);
}
#endif

/* The properties above covered joints of every kind. */
static void met_every_kind(arb *a)
{
    (void)a;
    /* a line does not */
    const bool bends = LOFT_AXES == 1 || (seen[1] > 1000 && seen[3] > 50);
    CHECK(check_sampled() || (seen[0] > 20 && seen[2] > 50 && bends));
}

int main(void)
{
    PROPERTY(flags_are_those_of_whole_numbers,  3000);
    PROPERTY(a_continuation_is_g2,              2000);
    PROPERTY(continues_by_the_formula,          2000);
    PROPERTY(smooth_both_ways,                  1000);
    PROPERTY(a_tolerance_is_a_length,           3000);
    PROPERTY(refuses_what_it_cannot_decide,       20);
#if LOFT_NUM != LOFT_Q16
    PROPERTY(refuses_floats_that_are_not_exact,   20);
#endif
    PROPERTY(met_every_kind,                       1);
    return check_failures();
}

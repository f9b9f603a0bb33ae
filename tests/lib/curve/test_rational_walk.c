/* tests/lib/curve/test_rational_walk.c -- properties of lib/curve/rational_walk.h
 * SPDX-License-Identifier: MIT
 */
#include "support/rationals.h"          /* arb_rational, rational_at */
#include "curve/rational_walk.h"

#define DEGREE LOFT_RATIONAL_WALK_DEGREE_MAX

static long double bound_of(const sample *s, uint32_t n, long double want)
{
    static const long double per_step[] = { 0, 1, 3, 8, 21, 56 };
    const long double drift = 2 * s->ratio * (per_step[s->n] * n + 8 * powl(3, s->n)) /
                              9007199254740992.0L * s->largest;

    const long double by_num[2] = { LSB / 2 + 1e-13L, ulp(want) / 2 + drift };
    return by_num[BY_NUM(0, 1, 1)];
}

static void walk(const sample *s, uint32_t n)
{
    loft_rational_walk w;
    loft_vec p;
    uint32_t j = 0;

    CHECK(loft_rational_walk_init(&w, &s->r, n) == LOFT_OK);
    while (loft_rational_walk_next(&w, &p)) {
        j++;
        for (int i = 0; i < LOFT_AXES; i++) {
            const long double want = rational_at(s, i, j, n);
            CHECK_EXACT(exact_of(p.axis[i]), want, bound_of(s, n, want));
        }
    }
    CHECK(j == n);
    CHECK(loft_vec_equal(p, s->p[s->n].p));
}

static void every_point_is_within_its_bound(arb *a)
{
    const sample *s = arb_rational(a, DEGREE);
    walk(s, 1 + arb_below(a, (uint32_t)1 << arb_below(a, 9)));
}

static void long_walks_do_not_drift(arb *a)
{
    const uint32_t most[DEGREE + 1] = { 500, 10000, 10000, 20000, 20000, 6208 };
    const sample *s = arb_rational(a, DEGREE);
    walk(s, most[s->n]);
}

/* The first points of the longest walks within the law of ranges. */
static void the_law_of_ranges_is_kept_at_its_edge(arb *a)
{
    const uint32_t most[DEGREE + 1] = { UINT32_MAX, UINT32_MAX, 3037000499, 2097151, 55108, 6208 };
    const sample *s = arb_rational(a, DEGREE);
    loft_rational_walk w;
    loft_vec p;

    CHECK(loft_rational_walk_init(&w, &s->r, most[s->n]) == LOFT_OK);
    for (uint32_t j = 1; j <= 50; j++) {
        CHECK(loft_rational_walk_next(&w, &p));
        for (int i = 0; i < LOFT_AXES; i++) {
            const long double want = rational_at(s, i, j, most[s->n]);
            CHECK_EXACT(exact_of(p.axis[i]), want, bound_of(s, 50, want));
        }
    }
    if (s->n > 1)
        CHECK(loft_rational_walk_init(&w, &s->r, most[s->n] + 1) == LOFT_ERR_RANGE);
}

/* Integers small enough to produce ties: 16 bits of coordinate, equal weights, a power of two of
 * steps. */
static void ties_go_upward_in_q16(arb *a)
{
    loft_weighted p[2];
    loft_rational r;
    loft_rational_walk w;
    loft_vec v;
    const int32_t from = arb_raw(a, 1000), to = arb_raw(a, 1000);

    for (int i = 0; i < LOFT_AXES; i++) {
        p[0].p.axis[i] = (loft_real)BY_NUM(from, from / 65536.0, from / 65536.0);
        p[1].p.axis[i] = (loft_real)BY_NUM(to, to / 65536.0, to / 65536.0);
    }
    p[0].w = p[1].w = LOFT_WEIGHT_MIN;
    CHECK(loft_rational_init(&r, p, 1) == LOFT_OK && loft_rational_walk_init(&w, &r, 2) == LOFT_OK);
    CHECK(loft_rational_walk_next(&w, &v));
    const long double want =
        BY_NUM(floorl((from + to) / 2.0L + 0.5L), (from + to) / 2.0L, (from + to) / 2.0L) / 65536;
    CHECK_EXACT(exact_of(v.axis[0]), want, 0);
}

static void nonsense_is_refused_and_leaves_the_walk_alone(arb *a)
{
    sample *s = arb_rational(a, DEGREE);
    loft_rational_walk w = { .left = 77 };
    loft_vec p = { { 0 } };

    CHECK(loft_rational_walk_init(&w, &s->r, 0) == LOFT_ERR_ARG);
    s->r.degree = DEGREE + 1;
    CHECK(loft_rational_walk_init(&w, &s->r, 4) == LOFT_ERR_ARG);
    s->r.degree = 5;
    for (unsigned k = 0; k <= 5; k++)
        s->p[k] = s->p[0];
    CHECK(loft_rational_walk_init(&w, &s->r, 6209) == LOFT_ERR_RANGE);
    if (BY_NUM(false, false, true)) {
        s->p[0].p.axis[0] = (loft_real)BY_NUM(0, 0, 0x1p901);
        CHECK(loft_rational_walk_init(&w, &s->r, 4) == LOFT_ERR_RANGE);
    }
    CHECK(w.left == 77);
    w.left = 0;
    CHECK(!loft_rational_walk_next(&w, &p) && loft_vec_equal(p, (loft_vec) { { 0 } }));
}

int main(void)
{
    PROPERTY(every_point_is_within_its_bound,                600);
    PROPERTY(long_walks_do_not_drift,                          6);
    PROPERTY(the_law_of_ranges_is_kept_at_its_edge,          300);
    PROPERTY(ties_go_upward_in_q16,                         1000);
    PROPERTY(nonsense_is_refused_and_leaves_the_walk_alone,   20);
    return check_failures();
}

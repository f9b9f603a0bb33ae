/* tests/lib/basis/test_knots.c -- properties of lib/basis/knots.h
 * SPDX-License-Identifier: MIT
 */
#include "support/splines.h"    /* arb_grid, exact_weights */
#include "num/acc128.h"         /* loft_acc_rate */

static grid *started(arb *a)
{
    static grid g;
    g = arb_grid(a);
    CHECK(loft_knots_init(&g.knots, g.k, g.points, g.p) == LOFT_OK);
    return &g;
}

static void good_knots_are_taken_and_bad_ones_refused(arb *a)
{
    grid g = arb_grid(a);
    const unsigned i = arb_below(a, g.points + g.p + 1);
    loft_knots knots = { NULL, 7, 7 };

    CHECK(loft_knots_init(&g.knots, g.k, g.points, g.p) == LOFT_OK);
    CHECK(g.knots.k == g.k && g.knots.points == g.points && g.knots.degree == g.p);
    g.k[i] = arb_below(a, 3) ? g.k[arb_below(a, g.points + g.p + 1)] : arb_knot(a, g.kind);
    CHECK((loft_knots_init(&knots, g.k, g.points, g.p) == LOFT_OK) == good(&g));
    CHECK(good(&g) || (knots.k == NULL && knots.points == 7));
    CHECK(loft_knots_init(&knots, g.k, g.p, g.p) == LOFT_ERR_ARG);
    CHECK(loft_knots_init(&knots, g.k, g.points, 0) == LOFT_ERR_ARG);
    CHECK(loft_knots_init(&knots, g.k, g.points, LOFT_DEGREE_MAX + 1) == LOFT_ERR_ARG);
    CHECK(loft_knots_init(&knots, g.k, LOFT_KNOTS_POINTS_MAX + 1, g.p) == LOFT_ERR_ARG);
#if LOFT_NUM != LOFT_Q16
    const loft_real bad[3] = { (loft_real)NAN, (loft_real)INFINITY, -(loft_real)INFINITY };
    g.k[i] = bad[arb_below(a, 3)];
    CHECK(loft_knots_init(&knots, g.k, g.points, g.p) == LOFT_ERR_RANGE);
#endif
}

static void the_span_is_that_of_counting(arb *a)
{
    const grid *g = started(a);
    const loft_real u = arb_u(a, g), start = g->k[g->p], end = g->k[g->points];
    const unsigned s = loft_knots_find(&g->knots, u);

    CHECK(s == exact_span(g, u));
    CHECK(g->k[s] <= u && u <= g->k[s + 1] && g->k[s] < g->k[s + 1] &&
          (u < g->k[s + 1] || !(u < end)));
    CHECK(loft_knots_find(&g->knots, BY_NUM(INT32_MIN, -FLT_MAX, -DBL_MAX)) ==
          exact_span(g, start));
    CHECK(loft_knots_find(&g->knots, LOFT_REAL_MAX) == exact_span(g, end));
    CHECK(!(loft_knots_clamp(&g->knots, u) < u) && !(u < loft_knots_clamp(&g->knots, u)));
}

static void every_span_comes_once_and_in_order(arb *a)
{
    const grid *g = started(a);
    unsigned s = 0;

    for (unsigned i = g->p; i < g->points; i++)
        if (g->k[i] < g->k[i + 1]) {
            s = loft_knots_next(&g->knots, s);
            CHECK(s == i);
        }
    CHECK(loft_knots_next(&g->knots, s) == 0);
}

static void weights_are_those_of_the_recursion_and_sum_to_one(arb *a)
{
    const grid *g = started(a);
    const loft_real u = arb_u(a, g);
    long double n[KNOTS_MOST], sum = 0;
    loft_acc w[POINTS], exact = 0;

    const unsigned first = loft_knots_weights(&g->knots, u, w), s = exact_span(g, u);
    CHECK(first == s - g->p);
    exact_weights(g, g->p, s, exact_of(u), n);
    for (unsigned j = 0; j <= g->p; j++) {
        CHECK_EXACT(exact_acc(w[j]), n[first + j],
                    BY_NUM(g->p / 4294967296.0L, 6 * g->p * 0x1p-52L, 6 * g->p * 0x1p-52L));
        sum += n[first + j];
        exact += w[j];
    }
    CHECK_EXACT(sum, 1, 0x1p-58L);              /* nothing outside the first + 0 .. first +
                                                 * degree */
    CHECK_EXACT(exact_acc(exact), 1, BY_NUM(0, 6 * g->p * 0x1p-52L, 6 * g->p * 0x1p-52L));
}

/* c[first + j] = 1, the others 0 */
static void a_value_of_one_coefficient_is_its_weight(arb *a)
{
    const grid *g = started(a);
    const loft_real u = arb_u(a, g);
    const unsigned s = loft_knots_find(&g->knots, u), j = arb_below(a, g->p + 1);
    loft_acc c[POINTS] = { 0 };
    long double n[KNOTS_MOST];

    c[j] = loft_to_acc(LOFT_REAL(1));
    exact_weights(g, g->p, s, exact_of(u), n);
    const loft_acc y = loft_knots_eval(&g->knots, s, u, c);
    CHECK_EXACT(exact_acc(y), n[s - g->p + j],
                BY_NUM(g->p / 8589934592.0L, 5 * g->p * 0x1p-52L, 5 * g->p * 0x1p-52L));
}

/* The Greville points: coefficients (k[i+1] + .. + k[i+p]) / p give u itself. */
static void the_means_of_knots_give_the_parameter(arb *a)
{
    const grid *g = started(a);
    const loft_real u = arb_u(a, g);
    const unsigned s = loft_knots_find(&g->knots, u);
    long double n[KNOTS_MOST], y = 0, largest = 0;

    exact_weights(g, g->p, s, exact_of(u), n);
    for (unsigned i = s - g->p; i <= s; i++) {
        long double sum = 0;
        for (unsigned q = 1; q <= g->p; q++)
            sum += exact_of(g->k[i + q]);
        y += n[i] * sum / g->p;
        largest = fmaxl(largest, fabsl(sum / g->p));
    }
    CHECK_EXACT(y, exact_of(u), largest * 0x1p-57L);    /* of the reference: the recursion is
                                                         * correct */
}

static void lerp_in_is_exact_but_for_its_rounding(arb *a)
{
    loft_real k[3] = { arb_knot(a, arb_below(a, 6)), arb_knot(a, arb_below(a, 6)),
                       arb_knot(a, arb_below(a, 6)) };
    const loft_acc x = loft_prod(arb_real(a, 32767), LOFT_REAL(32767)),
                   y = loft_prod(arb_real(a, 32767), LOFT_REAL(32767));

    sort(k, 3);
    if (!(k[0] < k[2]))
        return;
    const long double t = (exact_of(k[1]) - exact_of(k[0])) / (exact_of(k[2]) - exact_of(k[0]));
    const long double want = exact_acc(x) + (exact_acc(y) - exact_acc(x)) * t,
                      largest = fmaxl(fabsl(exact_acc(x)), fabsl(exact_acc(y)));
    const long double bound[2] = { 0x1p-33L, 5 * ulp_double(largest) };
    CHECK_EXACT(exact_acc(loft_acc_lerp_in(x, y, k[1], k[0], k[2])), want,
                bound[BY_NUM(0, 1, 1)] + largest * 0x1p-61L);
    CHECK(!(loft_acc_lerp_in(x, y, k[0], k[0], k[2]) - x < 0) &&
          !(loft_acc_lerp_in(x, y, k[0], k[0], k[2]) - x > 0));
    CHECK(!(loft_acc_lerp_in(x, y, k[2], k[0], k[2]) - y < 0) &&
          !(loft_acc_lerp_in(x, y, k[2], k[0], k[2]) - y > 0));
}

static void a_rate_is_the_nearest_coordinate_or_refused(arb *a)
{
    loft_real k[2] = { arb_knot(a, arb_below(a, 6)), arb_knot(a, arb_below(a, 6)) };
    const loft_real p = arb_real(a, 32767), q = arb_real(a, (int32_t)1 << arb_below(a, 15)),
                    untouched = LOFT_REAL(1.5);
    const int32_t times = 1 + (int32_t)arb_below(a, LOFT_DEGREE_MAX);
    loft_real rate = untouched;

    sort(k, 2);
    if (!(k[0] < k[1]))
        return;
    const bool fits = loft_acc_rate((loft_to_acc(p) - loft_to_acc(q)) * times,
                                    loft_to_acc(k[1]) - loft_to_acc(k[0]), &rate);
    const long double want = (exact_of(p) - exact_of(q)) * times /
                             (exact_of(k[1]) - exact_of(k[0]));
    CHECK(fits || (!(rate < untouched) && !(rate > untouched)));
    CHECK(fits == BY_NUM(fabsl(want) < 32768 - LSB / 2, true, true));
    if (fits)
        CHECK_EXACT(exact_of(rate), want,
                    BY_NUM(LSB / 2, ulp(want), 1.5L * ulp(want)) + fabsl(want) * 0x1p-62L);
}

static void a_knot_is_inserted_in_its_place_or_refused(arb *a)
{
    grid *g = started(a);
    const loft_real u = arb_below(a, 8) ? arb_u(a, g) : arb_knot(a, g->kind);
    const unsigned count = g->points + g->p + 1;
    grid more = *g;
    unsigned times = 0;

    for (unsigned i = 0; i < count; i++)
        times += !(g->k[i] < u) && !(u < g->k[i]);
    const bool wanted = !(u < g->k[g->p]) && !(g->k[g->points] < u) && times <= g->p;
    CHECK(loft_knots_valid(&g->knots, u) == wanted);
    if (!wanted || g->points == POINTS_MOST)
        return;
    more.points++;
    more.k[count] = u;
    sort(more.k, count + 1);
    loft_knots_insert(&g->knots, u, g->k);      /* in place */
    for (unsigned i = 0; i <= count; i++)
        CHECK(!(g->k[i] < more.k[i]) && !(more.k[i] < g->k[i]));
    CHECK(good(&more));
}

int main(void)
{
    PROPERTY(good_knots_are_taken_and_bad_ones_refused, 3000);
    PROPERTY(the_span_is_that_of_counting, 5000);
    PROPERTY(every_span_comes_once_and_in_order, 2000);
    PROPERTY(weights_are_those_of_the_recursion_and_sum_to_one, 3000);
    PROPERTY(a_value_of_one_coefficient_is_its_weight, 3000);
    PROPERTY(the_means_of_knots_give_the_parameter, 2000);
    PROPERTY(lerp_in_is_exact_but_for_its_rounding, 20000);
    PROPERTY(a_rate_is_the_nearest_coordinate_or_refused, 20000);
    PROPERTY(a_knot_is_inserted_in_its_place_or_refused, 3000);
    return check_failures();
}

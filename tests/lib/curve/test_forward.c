/* tests/lib/curve/test_forward.c -- properties of lib/curve/forward.h
 * SPDX-License-Identifier: MIT
 *
 * The reference is the Bernstein sum over n^degree in 128-bit integers: exact. In f32 and f64 it is
 * the same sum in long double.
 */
#include <math.h>
#include <string.h>

#include "check.h"          /* CHECK, CHECK_NEAR, PROPERTY, BY_NUM */
#include "support/arb.h"    /* arb_real, arb_below */
#include "curve/forward.h"

#define MOST 2000                   /* points of a walk that are checked one by one   */

typedef struct {
    loft_vec p[LOFT_FORWARD_DEGREE_MAX + 1];
    loft_bezier curve;
} subject;

/* Any coordinates; one curve in four alternates between the two ends of the number type. */
static void draw(subject *s, arb *a, unsigned degree)
{
    const bool extreme = arb_below(a, 4) == 0;

    for (unsigned k = 0; k <= degree; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            s->p[k].axis[i] = arb_real(a, 32767);
            if (extreme)
                s->p[k].axis[i] = (k + (unsigned)i) & 1
                                      ? LOFT_REAL_MAX / BY_NUM(1, 65536, 65536)
                                      : -LOFT_REAL_MAX / BY_NUM(1, 65536, 65536) - BY_NUM(1, 0, 0);
        }
    s->curve.p = s->p;
    s->curve.degree = (uint8_t)degree;
}

static uint64_t choose(uint64_t n, unsigned k)
{
    uint64_t c = 1;
    for (unsigned i = 1; i <= k; i++)
        c = c * (n - i + 1) / i;
    return c;
}

#if LOFT_NUM == LOFT_Q16

__extension__ typedef __int128 exact;

static exact power(exact n, unsigned k)
{
    exact p = 1;
    while (k--)
        p *= n;
    return p;
}

/* n^degree times the curve at i/n */
static exact scaled(const subject *s, uint32_t n, uint64_t i, int axis)
{
    const unsigned d = s->curve.degree;
    exact sum = 0;
    for (unsigned k = 0; k <= d; k++)
        sum += (exact)choose(d, k) * power(i, k) * power((exact)n - (exact)i, d - k) *
               s->p[k].axis[axis];
    return sum;
}

/* Is `got` the exact value rounded to nearest, ties upward? got - 1/2 <= v < got + 1/2 */
static void check_exact(const subject *s, uint32_t n, uint64_t i, loft_vec got)
{
    const exact whole = power(n, s->curve.degree);
    for (int x = 0; x < LOFT_AXES; x++) {
        const exact off = 2 * (scaled(s, n, i, x) - got.axis[x] * whole);
        CHECK(off >= -whole && off < whole);
    }
}

/* The largest displacement of point i by rounded differences, times 2^33. */
static uint64_t drift(unsigned degree, uint64_t i)
{
    uint64_t sum = 0;
    for (unsigned k = 1; k <= degree && k <= i; k++)
        sum += choose(i, k);
    return sum;
}

/* Is it within the law of errors, 1/2 LSB plus the drift, 2^-33 + 2^-50 times the above? */
static void check_law(const subject *s, uint32_t n, uint64_t i, loft_vec got)
{
    const exact whole = power(n, s->curve.degree), one = (exact)1 << 50;
    const exact bound = (one / 2 + (exact)drift(s->curve.degree, i) * (((exact)1 << 17) + 1)) *
                        whole;
    for (int x = 0; x < LOFT_AXES; x++) {
        const exact off = one * (scaled(s, n, i, x) - got.axis[x] * whole);
        CHECK(off >= -bound && off <= bound);
    }
}

#else

static const double steps_factor[] = { 0, 1, 3, 8, 21, 56 };

static void check_law(const subject *s, uint32_t n, uint64_t i, loft_vec got)
{
    const unsigned d = s->curve.degree;
    const long double t = (long double)i / n;
    double per_start = 8;

    for (unsigned k = 0; k < d; k++)
        per_start *= 3;
    for (int x = 0; x < LOFT_AXES; x++) {
        long double sum = 0;
        double largest = 0;
        for (unsigned k = 0; k <= d; k++) {
            long double term = (long double)choose(d, k) * s->p[k].axis[x];
            for (unsigned j = 0; j < k; j++)
                term *= t;
            for (unsigned j = k; j < d; j++)
                term *= 1 - t;
            sum += term;
            if (largest < fabs((double)s->p[k].axis[x]))
                largest = fabs((double)s->p[k].axis[x]);
        }
        const double law = (steps_factor[d] * n + per_start) * 0x1p-53 + BY_NUM(0, 0x1p-24, 0);
        CHECK(fabs((double)((long double)got.axis[x] - sum)) <= law * largest);
    }
}

#define check_exact check_law

#endif

static uint32_t most_steps(unsigned degree)
{
    static const uint32_t most[] = { UINT32_MAX, UINT32_MAX - 32767, 92681, 2953, 567, 220 };
    return most[degree];
}

/* A number of steps within the law of ranges: small, any, or the largest. */
static uint32_t draw_steps(arb *a, uint32_t most)
{
    switch (arb_below(a, 4)) {
    case 0:  return 1 + arb_below(a, 9);
    case 1:  return most - arb_below(a, 2);
    default: return 1 + (uint32_t)((arb_next(a) >> 1) % (most < 4000 ? most : 4000));
    }
}

static void check_last(const subject *s, loft_vec got)
{
    CHECK(loft_vec_equal(got, s->p[s->curve.degree]));
}

/* Every point of a walk in n = 2^m steps, degree * m <= 32, is the exact point rounded to
 * nearest. */
static void powers_of_two_are_walked_exactly(arb *a)
{
    const unsigned degree = arb_below(a, 6), most = degree < 2 ? 31 : 32 / degree,
                   m = arb_below(a, most + 1);
    const uint32_t n = (uint32_t)1 << m;
    subject s;
    loft_forward w;
    loft_vec p = { { 0 } };
    uint64_t i;

    draw(&s, a, degree);
    CHECK(loft_forward_init(&w, &s.curve, n) == LOFT_OK);
    for (i = 1; i <= MOST && loft_forward_next(&w, &p); i++)
        check_exact(&s, n, i, p);
    if (n <= MOST) {
        CHECK(i == (uint64_t)n + 1);
        check_last(&s, p);
        CHECK(!loft_forward_next(&w, &p));
    }
}

/* The longest walks, up to their end. */
static void the_longest_walks_end_on_the_last_point(arb *a)
{
    static const uint32_t longest[][2] = { { 2, 65536 }, { 2, 92681 }, { 3, 1024 },
                                           { 3, 2953 },  { 4, 256 },   { 4, 567 },
                                           { 5, 64 },    { 5, 220 },   { 1, 100003 } };
    const uint32_t *which = longest[arb_below(a, 9)], n = which[1];
    const bool is_exact = (n & (n - 1)) == 0;
    subject s;
    loft_forward w;
    loft_vec p = { { 0 } };

    draw(&s, a, which[0]);
    CHECK(loft_forward_init(&w, &s.curve, n) == LOFT_OK);
    for (uint32_t i = 1; loft_forward_next(&w, &p); i++)
        if (i % (n / 500 + 1) == 0 || i + 20 > n) {
            check_law(&s, n, i, p);
            if (is_exact)
                check_exact(&s, n, i, p);
        }
    check_last(&s, p);
}

/* Any number of steps within the law of ranges keeps the law of errors and ends on the last
 * point. */
static void any_number_of_steps_keeps_the_law(arb *a)
{
    const unsigned degree = arb_below(a, 6);
    const uint32_t n = draw_steps(a, most_steps(degree));
    subject s;
    loft_forward w;
    loft_vec p = { { 0 } };

    draw(&s, a, degree);
    CHECK(loft_forward_init(&w, &s.curve, n) == LOFT_OK);
    for (uint64_t i = 1; i <= MOST && loft_forward_next(&w, &p); i++)
        check_law(&s, n, i, p);
    if (n <= MOST)
        check_last(&s, p);
}

static uint32_t most_exact_steps(unsigned degree)
{
    static const uint32_t most[] = { UINT32_MAX, UINT32_MAX, 3037000499u, 2097151, 55108, 6208 };
    return most[degree];
}

/* With quotient and remainder every point is exact, for any number of steps. */
static void remainders_make_walks_exact_for_any_number(arb *a)
{
    const unsigned degree = arb_below(a, 6);
    const uint32_t n = draw_steps(a, most_exact_steps(degree));
    subject s;
    loft_forward_exact w;
    loft_vec p = { { 0 } };
    uint64_t i;

    draw(&s, a, degree);
    CHECK(loft_forward_exact_init(&w, &s.curve, n) == LOFT_OK);
    for (i = 1; i <= MOST && loft_forward_exact_next(&w, &p); i++)
        check_exact(&s, n, i, p);
    if (n <= MOST) {
        CHECK(i == (uint64_t)n + 1);
        check_last(&s, p);
        CHECK(!loft_forward_exact_next(&w, &p));
    }
}

static void a_run_gives_the_points_of_single_steps(arb *a)
{
    const unsigned degree = arb_below(a, 6);
    const uint32_t n = 1 + arb_below(a, 200);
    loft_vec run[64], single, after = { { 0 } };
    subject s;
    loft_forward w, v;
    uint32_t done = 0;

    draw(&s, a, degree);
    CHECK(loft_forward_init(&w, &s.curve, n) == LOFT_OK &&
          loft_forward_init(&v, &s.curve, n) == LOFT_OK);
    while (done < n) {
        const uint32_t ask = arb_below(a, 64), got = loft_forward_run(&w, run, ask);
        CHECK(got == (ask < n - done ? ask : n - done));
        for (uint32_t j = 0; j < got; j++) {
            CHECK(loft_forward_next(&v, &single));
            CHECK(loft_vec_equal(single, run[j]));
        }
        done += got;
        CHECK(w.left == v.left);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(memcmp(w.axis[i].d, v.axis[i].d, sizeof w.axis[i].d) == 0);
    }
    CHECK(loft_forward_run(&w, run, 1) == 0);
    CHECK(!loft_forward_next(&w, &after));
}

/* Halving the step at any point gives the points of a walk with twice as many steps. Exactly where
 * the proof of exactness does not apply, halving is refused and the walk continues unchanged. */
static void a_halved_step_is_the_finer_walk(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 5),
                   m = arb_below(a, 32 / degree < 12 ? 32 / degree + 1 : 12);
    const uint32_t n = (uint32_t)1 << m, before = arb_below(a, n + 1);
    uint64_t i = before, count = n;
    loft_vec p;
    subject s;
    loft_forward w, was;

    draw(&s, a, degree);
    CHECK(loft_forward_init(&w, &s.curve, n) == LOFT_OK);
    for (uint64_t j = 0; j < before; j++)
        CHECK(loft_forward_next(&w, &p));
    while (count < 4096) {
        was = w;
        if (loft_forward_halve(&w) == LOFT_OK) {
            CHECK(w.left == 2 * was.left);
            CHECK(degree * (m + 1) <= 32);
            count *= 2;
            i *= 2;
        } else {
            CHECK(memcmp(&w, &was, sizeof w) == 0);
            break;
        }
    }
    CHECK(count * count <= ((uint64_t)1 << 32) || degree < 2);
    while (loft_forward_next(&w, &p)) {
        i++;
        check_exact(&s, (uint32_t)count, i, p);
    }
    CHECK(i == count);
    if (before < n)
        check_last(&s, p);
}

/* Rounded differences have no exact half. */
static void a_step_that_is_no_power_of_two_is_not_halved(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 5);
    const uint32_t n = 3 + arb_below(a, 200);
    subject s;
    loft_forward w, was;

    draw(&s, a, degree);
    CHECK(loft_forward_init(&w, &s.curve, n) == LOFT_OK);
    was = w;
    if ((n & (n - 1)) != 0) {
        CHECK(loft_forward_halve(&w) == LOFT_ERR_RANGE);
        CHECK(memcmp(&w, &was, sizeof w) == 0);
    }
}

/* Curves of ordinary size may be halved down to the last guard bit. */
static void ordinary_curves_are_halved_to_the_limit(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 5), m = 2 + arb_below(a, 4);
    loft_forward w;
    subject s;
    unsigned halved = 0;

    draw(&s, a, degree);
    for (unsigned k = 0; k <= degree; k++)
        s.p[k] = arb_vec(a, 80);
    CHECK(loft_forward_init(&w, &s.curve, (uint32_t)1 << m) == LOFT_OK);
    while (loft_forward_halve(&w) == LOFT_OK)
        halved++;
    CHECK(degree == 1 ? m + halved == 31 : m + halved == 32 / degree);
}

static void a_doubled_step_is_every_second_point(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 5);
    const uint32_t n = 2 * (1 + arb_below(a, 110)), before = arb_below(a, n + 1);
    loft_vec p, q;
    subject s;
    loft_forward w, v;

    draw(&s, a, degree);
    CHECK(loft_forward_init(&w, &s.curve, n) == LOFT_OK);
    for (uint32_t j = 0; j < before; j++)
        CHECK(loft_forward_next(&w, &p));
    v = w;
    if (before & 1) {
        CHECK(loft_forward_double(&w) == LOFT_ERR_RANGE);
        CHECK(memcmp(&w, &v, sizeof w) == 0);
        return;
    }
    CHECK(loft_forward_double(&w) == LOFT_OK);
    for (uint32_t i = before + 2; i <= n; i += 2) {
        CHECK(loft_forward_next(&v, &q) && loft_forward_next(&v, &q));
        CHECK(loft_forward_next(&w, &p));
        CHECK(BY_NUM(loft_vec_equal(p, q), true, true));
        check_law(&s, n, i, p);
    }
    CHECK(!loft_forward_next(&w, &p));
}

/* If doubling and halving again are not refused, the walk is as before. */
static void halving_undoes_doubling(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 5);
    const uint32_t n = 8 * (1 + arb_below(a, 27)), before = 4 * arb_below(a, n / 4 + 1);
    loft_vec p;
    subject s;
    loft_forward w, v;

    draw(&s, a, degree);
    CHECK(loft_forward_init(&w, &s.curve, n) == LOFT_OK);
    for (uint32_t j = 0; j < before; j++)
        CHECK(loft_forward_next(&w, &p));
    v = w;
    const unsigned times = 1 + arb_below(a, 2);
    for (unsigned k = 0; k < times; k++)
        CHECK(loft_forward_double(&w) == LOFT_OK);
    unsigned back = 0;
    while (back < times && loft_forward_halve(&w) == LOFT_OK)
        back++;
    if (back == times) {
        CHECK(BY_NUM(memcmp(&w, &v, sizeof w) == 0, w.left == v.left, w.left == v.left));
        for (uint32_t i = before + 1; loft_forward_next(&w, &p); i++)
            check_law(&s, n, i, p);
    } else {
        CHECK(back == 0 && BY_NUM(true, false, false));
    }
}

/* One step more than the law of ranges allows is refused, and the object is untouched. */
static void what_does_not_fit_is_refused(arb *a)
{
    loft_forward w, was;
    loft_forward_exact t, had;
    subject s;

    memset(&w, 0x5a, sizeof w);
    memset(&t, 0xa5, sizeof t);
    was = w;
    had = t;
    for (unsigned degree = 1; degree <= LOFT_FORWARD_DEGREE_MAX; degree++) {
        draw(&s, a, degree);
        CHECK(loft_forward_init(&w, &s.curve, most_steps(degree) + 1) == LOFT_ERR_RANGE);
        if (degree == 1)
            continue;
        CHECK(loft_forward_init(&w, &s.curve, UINT32_MAX) == LOFT_ERR_RANGE);
        CHECK(loft_forward_init(&w, &s.curve, 0) == LOFT_ERR_ARG);
        CHECK(loft_forward_exact_init(&t, &s.curve, most_exact_steps(degree) + 1) ==
              LOFT_ERR_RANGE);
        CHECK(loft_forward_exact_init(&t, &s.curve, UINT32_MAX) == LOFT_ERR_RANGE);
        CHECK(loft_forward_exact_init(&t, &s.curve, 0) == LOFT_ERR_ARG);
    }
    s.curve.degree = LOFT_FORWARD_DEGREE_MAX + 1;
    CHECK(loft_forward_init(&w, &s.curve, 1) == LOFT_ERR_ARG);
    CHECK(loft_forward_exact_init(&t, &s.curve, 1) == LOFT_ERR_ARG);
#if LOFT_NUM != LOFT_Q16
    s.curve.degree = 3;
    const loft_real bad[] = { LOFT_REAL_MAX, (loft_real)INFINITY, (loft_real)-INFINITY,
                              (loft_real)NAN };
    s.p[arb_below(a, 4)].axis[arb_below(a, LOFT_AXES)] = bad[arb_below(a, 4)];
    CHECK(loft_forward_init(&w, &s.curve, 10) == LOFT_ERR_RANGE);
    CHECK(loft_forward_exact_init(&t, &s.curve, 10) == LOFT_ERR_RANGE);
#endif
    CHECK(memcmp(&w, &was, sizeof w) == 0);
    CHECK(memcmp(&t, &had, sizeof t) == 0);
}

int main(void)
{
    PROPERTY(powers_of_two_are_walked_exactly,             300);
    PROPERTY(the_longest_walks_end_on_the_last_point,       60);
    PROPERTY(any_number_of_steps_keeps_the_law,            300);
    PROPERTY(remainders_make_walks_exact_for_any_number,   300);
    PROPERTY(a_run_gives_the_points_of_single_steps,       300);
    PROPERTY(a_halved_step_is_the_finer_walk,              600);
    PROPERTY(a_step_that_is_no_power_of_two_is_not_halved, 100);
    PROPERTY(ordinary_curves_are_halved_to_the_limit,      300);
    PROPERTY(a_doubled_step_is_every_second_point,         300);
    PROPERTY(halving_undoes_doubling,                      600);
    PROPERTY(what_does_not_fit_is_refused,                 100);
    return check_failures();
}

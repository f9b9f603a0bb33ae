/* tests/lib/num/test_angle.c -- properties of lib/num/angle.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"              /* exact_acc, CHECK_EXACT */
#include "num/angle.h"

#define HALF (0x1p-53L * 1.001L)    /* half an ulp of double, plus the rounding of the reference */

static const long double pi = 3.14159265358979323846264338327950288L;

static long double exact_fine(loft_fine x) { return BY_NUM((long double)x * 0x1p-60L, x, x); }

/* Of any size, including whole numbers of quarters and their neighbours; |x| < limit. */
static loft_fine arb_fine(arb *a, double limit)
{
    const uint32_t kind = arb_below(a, 8);
    double x = (double)(arb_next(a) >> 11) * 0x1p-53 * limit;

    if (kind == 0)
        x = x * 0x1p-40;
    if (kind == 1)
        x = (double)(arb_below(a, 11)) * (double)(pi / 4) + (double)arb_below(a, 3) * 0x1p-30;
    if (kind == 2)
        x = (double)arb_below(a, 16) / 2;
    if (x >= limit)
        x = limit / 3;
    if (arb_below(a, 2))
        x = -x;
    return (loft_fine)(x * BY_NUM(0x1p60, 1, 1));
}

static void sines_are_within_their_bound(arb *a)
{
    const loft_fine x = arb_fine(a, 8);
    CHECK_EXACT(exact_fine(loft_fine_sin(x)), sinl(exact_fine(x)),
                BY_NUM(0x1p-58L, 0x1p-52L, 0x1p-52L));
    CHECK_EXACT(exact_fine(loft_fine_cos(x)), cosl(exact_fine(x)),
                BY_NUM(0x1p-58L, 0x1p-52L, 0x1p-52L));
}

/* One turn in equal steps, so that every part of it is tested. */
static void a_turn_of_sines_is_within_its_bound(arb *a)
{
    (void)a;
    for (int j = -20000; j <= 20000; j += CHECK_STEP) {
        const loft_fine x = (loft_fine)(j * (BY_NUM(0x1p60, 1, 1) * 2e-4));
        CHECK_EXACT(exact_fine(loft_fine_sin(x)), sinl(exact_fine(x)),
                    BY_NUM(0x1p-58L, 0x1p-52L, 0x1p-52L));
        CHECK_EXACT(exact_fine(loft_fine_cos(x)), cosl(exact_fine(x)),
                    BY_NUM(0x1p-58L, 0x1p-52L, 0x1p-52L));
    }
}

static loft_acc arb_turns(arb *a)
{
    const double x = ((double)(arb_next(a) >> 11) * 0x1p-52 - 1) * (double)(1 << arb_below(a, 21));
    return (loft_acc)(x * BY_NUM(0x1p32, 1, 1));
}

static void wide_sines_are_within_their_bound(arb *a)
{
    const loft_acc x = arb_turns(a);
    const long double bound = BY_NUM(0x1p-33L + 0x1p-40L, 0x1p-52L, 0x1p-52L);

    CHECK_EXACT(exact_acc(loft_sin(x)), sinl(exact_acc(x)), bound);
    CHECK_EXACT(exact_acc(loft_cos(x)), cosl(exact_acc(x)), bound);
}

static void an_angle_loses_its_whole_turns_only(arb *a)
{
    const loft_acc x = arb_turns(a);
    const long double want = remainderl(exact_acc(x), 2 * pi), got = exact_fine(loft_fine_angle(x));
    const long double bound = BY_NUM(0x1p-60L + fabsl(exact_acc(x)) * 0x1p-61L, 0x1p-51L,
                                     0x1p-51L) +
                              0x1p-64L * fabsl(exact_acc(x));

    CHECK(fabsl(got) <= pi + bound);
    CHECK_EXACT(fabsl(got - want) > 3 ? 2 * pi - fabsl(got - want) : got - want, 0,
                bound + 0x1p-62L);
}

static loft_acc arb_component(arb *a)
{
    const uint32_t kind = arb_below(a, 6);
    const double m = (double)(arb_next(a) >> 11) * 0x1p-52 - 1;

    if (kind == 0)
        return 0;
    if (kind == 1)
        return (loft_acc)(BY_NUM(4294967296.0, 1, 1) * (arb_below(a, 2) ? 100 : -100));
    return (loft_acc)(ldexp(m, (int)arb_below(a, 46) - 30) * BY_NUM(0x1p32, 1, 1));
}

static void the_angle_of_a_vector_is_within_its_bound(arb *a)
{
    const loft_acc x = arb_component(a), y = arb_component(a);
    const long double want = atan2l(exact_acc(y), exact_acc(x)),
                      got = exact_fine(loft_fine_atan2(y, x));

    if (!(x < 0) && !(x > 0) && !(y < 0) && !(y > 0)) {
        CHECK(loft_fine_atan2(y, x) >= 0 && loft_fine_atan2(y, x) <= 0);
        return;
    }
    CHECK_EXACT(got, want, BY_NUM(0x1p-56L, 0x1p-50L, 0x1p-50L));
    CHECK_EXACT(exact_acc(loft_atan2(y, x)), want, BY_NUM(0x1p-33L + 0x1p-56L, 0x1p-50L, 0x1p-50L));
}

static void the_greatest_vectors_have_an_angle(arb *a)
{
    static const double edge[5] = { -1, -0.5, 0, 0.5, 1 };
    const double size = BY_NUM(9223372036854774784.0, 0x1p1000, 0x1p1000);
    const double x = edge[arb_below(a, 5)] * size, y = edge[arb_below(a, 5)] * size;

    if (x < 0 || x > 0 || y < 0 || y > 0)
        CHECK_EXACT(exact_fine(loft_fine_atan2((loft_acc)y, (loft_acc)x)), atan2l(y, x),
                    BY_NUM(0x1p-56L, 0x1p-50L, 0x1p-50L));
}

static void products_and_quotients_are_within_their_bound(arb *a)
{
    const loft_fine x = arb_fine(a, 2.5), y = arb_fine(a, 2.5);
    const loft_acc w = arb_component(a) / 2;
    const long double p = exact_fine(x) * exact_fine(y), s = exact_acc(w) * exact_fine(x);

    CHECK_EXACT(exact_fine(loft_fine_mul(x, y)), p,
                BY_NUM(0x1p-61L, HALF * fabsl(p), HALF * fabsl(p)) + 0x1p-63L * fabsl(p));
    CHECK_EXACT(exact_acc(loft_fine_scale(w, x)), s,
                BY_NUM(0x1p-33L, HALF * fabsl(s), HALF * fabsl(s)) + 0x1p-63L * fabsl(s));
    const long double q = exact_fine(x) / exact_fine(y);
    if (fabsl(q) < 1e9L)
        CHECK_EXACT(exact_acc(loft_fine_quot(x, y)), q,
                    BY_NUM(0x1p-33L, HALF * fabsl(q), HALF * fabsl(q)) + 0x1p-62L * fabsl(q));
    if (fabsl(q) < 7)
        CHECK_EXACT(exact_fine(loft_fine_ratio(x, y)), q,
                    BY_NUM(0x1p-61L, HALF * fabsl(q), HALF * fabsl(q)) + 0x1p-63L * fabsl(q));
    CHECK_EXACT(exact_acc(loft_fine_to_acc(x)), exact_fine(x), BY_NUM(0x1p-33L, 0, 0));
    const loft_real r = arb_real(a, 7);
    CHECK_EXACT(exact_fine(loft_fine_of(r)), exact_of(r), 0);
}

static void roots_are_within_their_bound(arb *a)
{
    loft_fine x = arb_fine(a, 1);
    x = x < 0 ? -x : x;
    const long double want = sqrtl(exact_fine(x)),
                      bound = BY_NUM(0x1p-59L, 0x1p-52L * want, 0x1p-52L * want);

    CHECK_EXACT(exact_fine(loft_fine_sqrt(x)), want, bound);
    CHECK(!(loft_fine_sqrt(0) > 0) && !(loft_fine_sqrt(LOFT_FINE_1) < LOFT_FINE_1) &&
          !(loft_fine_sqrt(LOFT_FINE_1 / 4) < LOFT_FINE_1 / 2));
    const loft_unit t = arb_unit(a);
    CHECK_EXACT(exact_fine(loft_fine_unit(t)), exact_unit(t), 0);
}

/* Along the first axis y has no sign: 0 or pi. */
static void an_angle_has_the_sign_of_y(arb *a)
{
    const loft_acc x = BY_NUM((loft_acc)(arb_next(a) >> (1 + arb_below(a, 50))),
                              (double)(1 + arb_below(a, 1000)), (double)(1 + arb_below(a, 1000))) +
                       1,
                   y = BY_NUM((loft_acc)(arb_next(a) >> (2 + arb_below(a, 50))) + 1, x / 7, x / 7);
    const loft_acc none = BY_NUM(0, -0.0, -0.0);
    const loft_fine half_turn = loft_fine_atan2(0, -x);

    CHECK_EXACT(exact_fine(half_turn), pi, BY_NUM(0x1p-56L, 0x1p-50L, 0x1p-50L));
    CHECK(exact_fine(loft_fine_atan2(none, -x)) > 0 && exact_fine(loft_fine_atan2(none, x)) >= 0 &&
          exact_fine(loft_fine_atan2(none, x)) <= 0);
    CHECK(exact_fine(loft_fine_atan2(y, x)) >= 0 && exact_fine(loft_fine_atan2(-y, x)) <= 0);
    CHECK(exact_fine(loft_fine_atan2(y, -x)) > 0 && exact_fine(loft_fine_atan2(-y, -x)) < 0);
}

int main(void)
{
    PROPERTY(sines_are_within_their_bound,                     30000);
    PROPERTY(a_turn_of_sines_is_within_its_bound,                  1);
    PROPERTY(wide_sines_are_within_their_bound,                20000);
    PROPERTY(an_angle_loses_its_whole_turns_only,              20000);
    PROPERTY(the_angle_of_a_vector_is_within_its_bound,        20000);
    PROPERTY(an_angle_has_the_sign_of_y,                         500);
    PROPERTY(the_greatest_vectors_have_an_angle,                 200);
    PROPERTY(products_and_quotients_are_within_their_bound,    20000);
    PROPERTY(roots_are_within_their_bound,                      5000);
    return check_failures();
}

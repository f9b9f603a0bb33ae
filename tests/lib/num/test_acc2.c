/* tests/lib/num/test_acc2.c -- properties of lib/num/acc2.h
 * SPDX-License-Identifier: MIT
 *
 * The value of a loft_acc2 shows only relative to another one: quotients are compared with those of
 * long double, for integers that long double represents.
 */
#include "support/exact.h"              /* exact_acc, CHECK_EXACT */
#include "num/acc2.h"

#define STEPS 16777216

static loft_acc2 acc2_of(int32_t raw) { return loft_acc2_sub(loft_real_from_raw(raw), 0); }

/* The quadratic with these Bernstein coefficients at j / 2^24. */
static loft_acc2 value_of(const int32_t raw[3], uint32_t j)
{
    const loft_unit t = loft_unit_of(j, STEPS);
    const loft_acc2 left = loft_acc2_lerp(acc2_of(raw[0]), acc2_of(raw[1]), t),
                    right = loft_acc2_lerp(acc2_of(raw[1]), acc2_of(raw[2]), t);

    return loft_acc2_lerp(left, right, t);
}

static long double size_of(loft_acc x) { return fabsl(exact_acc(x)); }

/* (p t - q (1 - t))^2 compared with 1 LSB and with a multiple of itself, a few steps from its zero:
 * 2^-48 or less of its coefficients remains. */
static void what_nearly_cancels_is_known(arb *a)
{
    const int32_t p = 1 + (int32_t)arb_below(a, 60), q = 1 + (int32_t)arb_below(a, 60),
                  factor = 1 + (int32_t)arb_below(a, 50);
    const int32_t c[3] = { q * q, -p * q, p * p },
                  more[3] = { factor * c[0], factor * c[1], factor * c[2] }, ones[3] = { 1, 1, 1 };
    const int64_t at = (int64_t)((double)q / (p + q) * STEPS) + (int64_t)arb_below(a, 64) - 32,
                  j = at < 0       ? 0
                      : at > STEPS ? STEPS
                                   : at;
    const long double root = (long double)(p * j - q * (STEPS - j)) / STEPS;
    const loft_acc2 x = value_of(c, (uint32_t)j), beside[2] = { x, value_of(ones, (uint32_t)j) },
                    alike[2] = { value_of(more, (uint32_t)j), x };
    loft_acc out[2];

    CHECK(loft_acc2_scaled(beside, 2, out) && size_of(out[1]) > 0);
    if (size_of(out[1]) > 0)
        CHECK_EXACT(exact_acc(out[0]) / exact_acc(out[1]), root * root,
                    0x1p-52L * fmaxl(1, root * root));
    const bool any = loft_acc2_scaled(alike, 2, out);
    CHECK(any == (fabsl(root) > 0));
    if (any)
        CHECK_EXACT(exact_acc(out[1]) / exact_acc(out[0]), 1.0L / factor, 0x1p-30L);
}

/* A quadratic minus its own rounded value: 24 bits cancel. The sum is an integer and wraps: in
 * 2^-48. */
static void what_is_left_of_a_sum_is_known(arb *a)
{
    const uint64_t j = arb_below(a, STEPS + 1), n = STEPS - j;
    int32_t c[3], whole;
    const int32_t ones[3] = { 1, 1, 1 };
    loft_acc out[2];

    for (int k = 0; k < 3; k++)
        c[k] = arb_raw(a, BY_NUM(1 << 29, 1 << 22, 1 << 29));
    const uint64_t sum = (uint64_t)c[0] * (n * n) + 2 * (uint64_t)c[1] * (n * j) +
                         (uint64_t)c[2] * (j * j);
    const long double t = (long double)j / STEPS, u = 1 - t;
    whole = (int32_t)lroundl(c[0] * u * u + 2 * c[1] * t * u + c[2] * t * t);
    const int64_t rest = (int64_t)(sum - (uint64_t)whole * ((uint64_t)1 << 48));
    for (int k = 0; k < 3; k++)
        c[k] -= whole;
    const loft_acc2 v[2] = { value_of(c, (uint32_t)j), value_of(ones, (uint32_t)j) };
    CHECK(loft_acc2_scaled(v, 2, out));
    CHECK_EXACT(exact_acc(out[0]) / exact_acc(out[1]), (long double)rest * 0x1p-48L, 0x1p-51L);
}

/* A difference of coordinates of very different size keeps all bits of both. */
static void differences_are_exact(arb *a)
{
    const loft_real x = arb_real(a, 16000),
                    e = BY_NUM((loft_real)1, (loft_real)0x1p-40, (loft_real)0x1p-70);
    const loft_acc2 half = loft_acc2_lerp(loft_acc2_sub(x, -e), loft_acc2_sub(0, x),
                                          LOFT_UNIT(0.5)),
                    whole = loft_acc2_sub(e, 0);
    const loft_acc2 v[3] = { loft_acc2_twice(half), whole, loft_acc2_twice(whole) };
    loft_acc out[3];

    CHECK(loft_acc2_scaled(v, 3, out));
    CHECK(!(size_of(out[0] - out[1]) > 0) && !(size_of(out[2] - 2 * out[1]) > 0));
}

/* The largest is 2^27 .. 2^28, the quotients are kept, zero vectors are reported. */
static void vectors_keep_their_direction(arb *a)
{
    const int32_t limit = (int32_t)1 << arb_below(a, 31),
                  raw[3] = { arb_raw(a, limit), arb_raw(a, limit), arb_raw(a, limit) };
    long double most = 0, largest = 0;
    loft_acc2 v[3];
    loft_acc out[3];

    for (int i = 0; i < 3; i++) {
        v[i] = acc2_of(raw[i]);
        largest = fmaxl(largest, fabsl(exact_of(loft_real_from_raw(raw[i]))));
    }
    CHECK(loft_acc2_scaled(v, 3, out) == (largest > 0));
    if (!(largest > 0))
        return;
    for (int i = 0; i < 3; i++)
        most = fmaxl(most, size_of(out[i]));
    CHECK(most >= 0x1p27L && most < 0x1p28L);
    for (int i = 0; i < 3; i++)
        CHECK_EXACT(exact_acc(out[i]) / most, exact_of(loft_real_from_raw(raw[i])) / largest,
                    0x1p-58L);
}

/* At both ends a lerp returns its arguments, and the same from either side. */
static void lerps_are_exact_at_the_ends(arb *a)
{
    const loft_acc2 x = loft_acc2_sub(arb_real(a, 32767), arb_real(a, 32767)),
                    y = loft_acc2_sub(arb_real(a, 32767), arb_real(a, 32767));
    const loft_acc2 v[4] = { x, loft_acc2_lerp(x, y, 0), y, loft_acc2_lerp(x, y, LOFT_UNIT(1)) };
    loft_acc out[4];

    if (loft_acc2_scaled(v, 4, out))
        CHECK(!(size_of(out[0] - out[1]) > 0) && !(size_of(out[2] - out[3]) > 0));
}

int main(void)
{
    PROPERTY(what_nearly_cancels_is_known, 3000);
    PROPERTY(what_is_left_of_a_sum_is_known, 3000);
    PROPERTY(differences_are_exact,        1000);
    PROPERTY(vectors_keep_their_direction, 3000);
    PROPERTY(lerps_are_exact_at_the_ends,  1000);
    return check_failures();
}

/* lib/num/acc128.c
 * SPDX-License-Identifier: MIT
 */
#include "num/acc128.h"
#include "num/sci.h"    /* loft_acc128_slope divides by small weights */

#if LOFT_NUM == LOFT_Q16

#define LIMBS 4

static bool is_negative(const loft_acc128 *x) { return x->limb[LIMBS - 1] >> 31 != 0; }

/* x += (y ^ flip) + carry; returns the carry out of the top limb. It uses 32-bit words: an 8-bit
 * core has no wider ones. */
static uint32_t add_limbs(loft_acc128 *x, const loft_acc128 *y, uint32_t flip, uint32_t carry)
{
    for (int k = 0; k < LIMBS; k++) {
        const uint32_t term = y->limb[k] ^ flip, sum = x->limb[k] + term;
        x->limb[k] = sum + carry;
        carry = (uint32_t)(sum < term) | (uint32_t)(x->limb[k] < carry);
    }
    return carry;
}

loft_acc128 loft_acc128_add(loft_acc128 x, loft_acc128 y)
{
    add_limbs(&x, &y, 0, 0);
    return x;
}
loft_acc128 loft_acc128_sub(loft_acc128 x, loft_acc128 y)
{
    add_limbs(&x, &y, 0xffffffffu, 1);
    return x;
}

static loft_acc128 negated_acc128(const loft_acc128 *x)
{
    loft_acc128 r = { { 0 } };
    add_limbs(&r, x, 0xffffffffu, 1);
    return r;
}

loft_acc128 loft_acc128_of(loft_acc x)
{
    const uint32_t sign = x < 0 ? 0xffffffffu : 0;
    const loft_acc128 r = { { loft_acc_low(x), (uint32_t)loft_acc_high(x), sign, sign } };
    return r;
}

bool loft_acc128_below(loft_acc128 x, loft_acc128 y)
{
    const loft_acc128 difference = loft_acc128_sub(x, y);
    return is_negative(&difference);
}

/* x k in `limbs` limbs of out. A product plus a carry is at most (2^32 - 1)^2 + 2^32 - 1 < 2^64. */
static void multiply_limbs(const loft_acc128 *x, uint32_t k, uint32_t out[], int limbs)
{
    uint32_t carry = 0;

    for (int i = 0; i < limbs; i++) {
        const uint64_t sum = (uint64_t)(i < LIMBS ? x->limb[i] : 0) * k + carry;
        out[i] = (uint32_t)(sum & 0xffffffffu);
        carry = (uint32_t)loft_acc_high((int64_t)sum);
    }
}

loft_acc128 loft_acc128_times(loft_acc128 x, uint32_t k)
{
    loft_acc128 r;
    multiply_limbs(&x, k, r.limb, LIMBS);
    return r;
}

/* Shift by one limb and 14 bits. */
loft_acc128 loft_acc128_guarded(loft_acc x)
{
    const loft_acc128 r = { { 0, loft_acc_low(x), (uint32_t)loft_acc_high(x),
                            x < 0 ? 0xffffffffu : 0 } };
    return loft_acc128_times(r, 16384);
}

void loft_acc128_step(loft_acc128 d[], unsigned degree)
{
    for (unsigned k = 0; k < degree; k++)
        add_limbs(&d[k], &d[k + 1], 0, 0);
}

bool loft_acc128_valid(loft_real a)
{
    (void)a;
    return true;
}

/* (|y - x| |t| + 2^23) / 2^24. The five limbs hold less than 2^126 * 2^25 + 2^23; the four limbs
 * above bit 24 are the result. */
loft_acc128 loft_acc128_lerp(loft_acc128 x, loft_acc128 y, loft_unit t)
{
    const loft_acc128 difference = loft_acc128_sub(y, x), opposite = negated_acc128(&difference);
    const bool down = is_negative(&difference);
    uint32_t product[LIMBS + 1];
    loft_acc128 part;

    multiply_limbs(down ? &opposite : &difference, (uint32_t)(t < 0 ? -t : t), product, LIMBS + 1);
    for (uint32_t i = 0, carry = 8388608; i <= LIMBS; i++) {
        product[i] += carry;
        carry = product[i] < carry;
    }
    for (int i = 0; i < LIMBS; i++)
        part.limb[i] = product[i] >> 24 | product[i + 1] << 8;
    return down != (t < 0) ? loft_acc128_sub(x, part) : loft_acc128_add(x, part);
}

/* The integer part of x / n goes to *out, the remainder is returned. x has five limbs and is below
 * 2^128 n. */
static uint32_t divide_limbs(const uint32_t x[LIMBS + 1], uint32_t n, loft_acc128 *out)
{
    uint64_t rest = x[LIMBS];

    for (int i = LIMBS - 1; i >= 0; i--) {
        rest = rest << 32 | x[i];
        out->limb[i] = (uint32_t)(rest / n);
        rest %= n;
    }
    return (uint32_t)rest;
}

/* |x| / k, with the lowest 46 bits rounded off. */
loft_acc loft_acc128_to_acc(loft_acc128 x, uint32_t k)
{
    const bool minus = is_negative(&x);
    const loft_acc128 size = minus ? negated_acc128(&x) : x;
    uint32_t five[LIMBS + 1] = { 0 };
    loft_acc128 q;

    for (int i = 0; i < LIMBS; i++)
        five[i] = size.limb[i];
    (void)divide_limbs(five, k, &q);
    const uint64_t upper = (uint64_t)q.limb[3] << 32 | q.limb[2];
    const int64_t whole = (int64_t)(upper << 18 | q.limb[1] >> 14) + (q.limb[1] >> 13 & 1);
    return minus ? -whole : whole;
}

/* |y - x| j / n with j <= n < 2^32: a five-limb product, then a division limb by limb with a
 * remainder below n. */
loft_acc128 loft_acc128_lerp_in(loft_acc128 x, loft_acc128 y, loft_real a, loft_real lo,
                                loft_real hi)
{
    const uint32_t j = (uint32_t)a - (uint32_t)lo, n = (uint32_t)hi - (uint32_t)lo;
    const loft_acc128 difference = loft_acc128_sub(y, x), opposite = negated_acc128(&difference);
    const bool down = is_negative(&difference);
    uint32_t product[LIMBS + 1];
    loft_acc128 part;

    multiply_limbs(down ? &opposite : &difference, j, product, LIMBS + 1);
    const uint32_t rest = divide_limbs(product, n, &part);
    const loft_acc128 up = { { rest >= n - rest, 0, 0, 0 } };
    part = loft_acc128_add(part, up);
    return down ? loft_acc128_sub(x, part) : loft_acc128_add(x, part);
}

/* Digit by digit. The first round gives the integer part of |x| / w, which is 0 or 1; the next 31
 * give the fraction bits. Ties go upward: away from 0 only for a positive x. */
static loft_real signed_quotient(uint32_t q, bool minus, bool above, bool tie)
{
    if (above || (tie && !minus))
        q++;
    return (loft_real)(minus ? -(int64_t)q : (int64_t)q);
}

loft_real loft_acc_project(loft_acc x, loft_acc w)
{
    const uint64_t d = (uint64_t)w;
    uint64_t rest = loft_acc_size(x);
    uint32_t q = 0;

    for (int round = 0; round < 32; round++) {
        q += q;
        if (rest >= d) {
            rest -= d;
            q++;
        }
        rest += rest;
    }
    return signed_quotient(q, x < 0, rest > d, rest == d);
}

/* The halves of w are multiplied separately: high a 2^32 / 2^31 and low a / 2^31, with |low a| <
 * 2^63 - 2^31 and 1/2 added. */
loft_acc loft_acc_weigh(loft_acc w, loft_real a)
{
    const int64_t low = (int64_t)loft_acc_low(w) * a + 1073741824;

    return (int64_t)loft_acc_high(w) * a * 2 + (int64_t)loft_acc_high(low) * 2 +
           (loft_acc_low(low) >> 31);
}

/* The quotient is 2^15 x / (2^15 h), with 2^15 h < 2^63. Let e = |x| - 2^15 h. The result rounds to
 * a valid coordinate if e / (2^15 h) is below -2^-32, or at most 2^-32 for a negative x. All are
 * integers, so e is compared with the integer part of 2^15 h / 2^32. */
bool loft_acc_rate(loft_acc x, loft_acc h, loft_real *out)
{
    const loft_acc w = h * LOFT_PROJECT, beyond = (loft_acc)(loft_acc_size(x) - (uint64_t)w);

    if (x < 0 ? beyond > loft_acc_high(w) : beyond >= -(loft_acc)loft_acc_high(w))
        return false;
    *out = loft_acc_project(x, w);
    return true;
}

/* a -= b unless the result is negative */
static bool try_subtract(loft_acc128 *a, const loft_acc128 *b)
{
    loft_acc128 less = *a;

    if (!add_limbs(&less, b, 0xffffffffu, 1))
        return false;
    *a = less;
    return true;
}

loft_real loft_acc128_project(loft_acc128 x, loft_acc128 w)
{
    const bool minus = is_negative(&x);
    loft_acc128 rest = minus ? negated_acc128(&x) : x;
    uint32_t q = 0;

    for (int round = 0; round < 32; round++) {
        q += q + try_subtract(&rest, &w);
        add_limbs(&rest, &rest, 0, 0);
    }
    const bool reached = try_subtract(&rest, &w);
    const bool tie = reached && !(rest.limb[0] | rest.limb[1] | rest.limb[2] | rest.limb[3]);
    return signed_quotient(q, minus, reached && !tie, tie);
}

/* As loft_acc_rate, with 128 bits. */
bool loft_acc128_rate(loft_acc128 x, loft_acc128 w, loft_real *out)
{
    const bool minus = is_negative(&x);
    const loft_acc128 beyond = loft_acc128_sub(minus ? negated_acc128(&x) : x, w);
    const loft_acc128 room = { { w.limb[1], w.limb[2], w.limb[3], 0 } };

    if (minus ? loft_acc128_below(room, beyond) : !loft_acc128_below(beyond, negated_acc128(&room)))
        return false;
    *out = loft_acc128_project(x, w);
    return true;
}

/* x, w and v share a common factor, which cancels in the quotient. The five products, quotients and
 * differences are each in error by 2^-61 of their result. */
bool loft_acc128_slope(const loft_acc128 x[2], const loft_acc128 w[2], loft_acc128 v, int32_t k,
                       loft_acc *out)
{
    const loft_sci by = loft_sci_from_acc128(v), w0 = loft_sci_from_acc128(w[0]),
                   w1 = loft_sci_from_acc128(w[1]);
    const loft_sci x0 = loft_sci_from_acc128(loft_acc128_times(x[0], (uint32_t)k));
    const loft_sci x1 = loft_sci_from_acc128(loft_acc128_times(x[1], (uint32_t)k));
    const loft_sci rise = loft_sci_div(loft_sci_mul(x1, w0), by),
                   fall = loft_sci_div(loft_sci_mul(x0, w1), by);

    return loft_sci_to_acc(loft_sci_div(loft_sci_sub(rise, fall), by), out);
}

#else

bool loft_acc_rate(loft_acc x, loft_acc h, loft_real *out)
{
    const loft_acc rate = x / h;

    if (!loft_acc_valid(rate))
        return false;
    *out = loft_acc_round(rate);
    return true;
}

loft_real loft_acc_project(loft_acc x, loft_acc w) { return loft_acc_round(x / w * LOFT_PROJECT); }
loft_acc loft_acc_weigh(loft_acc w, loft_real a) { return w / LOFT_PROJECT * (loft_acc)a; }
loft_real loft_acc128_project(loft_acc128 x, loft_acc128 w)
{
    return loft_acc_round(x / w * LOFT_PROJECT);
}
bool      loft_acc128_below(loft_acc128 x, loft_acc128 y)             { return x < y; }
loft_acc128 loft_acc128_of(loft_acc x)                              { return x; }
loft_acc128 loft_acc128_guarded(loft_acc x)                         { return x; }
loft_acc  loft_acc128_to_acc(loft_acc128 x, uint32_t k)               { return x / k; }
loft_acc128 loft_acc128_add(loft_acc128 x, loft_acc128 y)               { return x + y; }
loft_acc128 loft_acc128_sub(loft_acc128 x, loft_acc128 y)               { return x - y; }
loft_acc128 loft_acc128_times(loft_acc128 x, uint32_t k)              { return x * k; }
loft_acc128 loft_acc128_lerp(loft_acc128 x, loft_acc128 y, loft_unit t)
{
    return loft_acc_lerp(x, y, t);
}
bool loft_acc128_valid(loft_real a) { return (double)a > -0x1p900 && (double)a < 0x1p900; }

loft_acc128 loft_acc128_lerp_in(loft_acc128 x, loft_acc128 y, loft_real a, loft_real lo,
                                loft_real hi)
{
    return loft_acc_lerp_in(x, y, a, lo, hi);
}

bool loft_acc128_rate(loft_acc128 x, loft_acc128 w, loft_real *out)
{
    const double rate = x / w * LOFT_PROJECT;

    if (!loft_acc_valid(rate * (1 - 0x1p-40)))       /* an average of f32's largest values may round
                                                      * above it */
        return false;
    *out = loft_acc_round(rate);
    return true;
}

void loft_acc128_step(loft_acc128 d[], unsigned degree)
{
    for (unsigned k = 0; k < degree; k++)
        d[k] += d[k + 1];
}

bool loft_acc128_slope(const loft_acc128 x[2], const loft_acc128 w[2], loft_acc128 v, int32_t k,
                       loft_acc *out)
{
    *out = k * (x[1] / v * (w[0] / v) - x[0] / v * (w[1] / v));
    return *out >= -DBL_MAX && *out <= DBL_MAX;
}

#endif

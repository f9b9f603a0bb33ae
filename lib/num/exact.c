/* lib/num/exact.c -- the classical algorithms on limbs of 32 bits
 * SPDX-License-Identifier: MIT
 *
 * In two's complement, sums, differences and products are the same for all signs: they are those of
 * unsigned numbers, truncated to the width.
 */
#include "num/exact.h"

#define LIMBS LOFT_EXACT_LIMBS

static const loft_exact zero = { { 0 } };

static bool is_negative(const loft_exact *a) { return a->limb[LIMBS - 1] >> 31 != 0; }

static bool is_zero(const loft_exact *a)
{
    for (int k = 0; k < LIMBS; k++)
        if (a->limb[k])
            return false;
    return true;
}

/* a += (b ^ flip) + carry, with flip = 0 or all ones */
static void add_limbs(loft_exact *a, const loft_exact *b, uint32_t flip, uint32_t carry)
{
    for (int k = 0; k < LIMBS; k++) {
        const uint64_t sum = (uint64_t)a->limb[k] + (b->limb[k] ^ flip) + carry;
        a->limb[k] = (uint32_t)(sum & 0xffffffffu);
        carry = (uint32_t)(sum >> 32);
    }
}

static void add_exact(loft_exact *a, const loft_exact *b)          { add_limbs(a, b, 0, 0); }
static void subtract_exact(loft_exact *a, const loft_exact *b) { add_limbs(a, b, 0xffffffffu, 1); }

loft_exact loft_exact_neg(loft_exact a)
{
    loft_exact r = zero;
    subtract_exact(&r, &a);
    return r;
}
loft_exact loft_exact_add(loft_exact a, loft_exact b)
{
    add_exact(&a, &b);
    return a;
}
loft_exact loft_exact_sub(loft_exact a, loft_exact b)
{
    subtract_exact(&a, &b);
    return a;
}

/* The sum of a partial product, a digit and a carry is at most (2^32 - 1)^2 + 2 (2^32 - 1) <
 * 2^64. */
loft_exact loft_exact_mul(loft_exact a, loft_exact b)
{
    loft_exact r = zero;

    for (int i = 0; i < LIMBS; i++) {
        uint32_t carry = 0;
        if (!a.limb[i])
            continue;
        for (int k = 0; i + k < LIMBS; k++) {
            const uint64_t sum = (uint64_t)a.limb[i] * b.limb[k] + r.limb[i + k] + carry;
            r.limb[i + k] = (uint32_t)(sum & 0xffffffffu);
            carry = (uint32_t)(sum >> 32);
        }
    }
    return r;
}

loft_exact loft_exact_det(loft_exact a, loft_exact b, loft_exact c, loft_exact d)
{
    return loft_exact_sub(loft_exact_mul(a, d), loft_exact_mul(b, c));
}

int loft_exact_sign(loft_exact a) { return is_negative(&a) ? -1 : is_zero(&a) ? 0 : 1; }

int loft_exact_compare(loft_exact a, loft_exact b) { return loft_exact_sign(loft_exact_sub(a, b)); }

loft_exact loft_exact_from_int(int32_t i)
{
    loft_exact r;

    r.limb[0] = (uint32_t)i;
    for (int k = 1; k < LIMBS; k++)
        r.limb[k] = i < 0 ? 0xffffffffu : 0;
    return r;
}


/* Shifts, quotients and roots */

int loft_exact_bits(loft_exact a)
{
    if (is_negative(&a))
        a = loft_exact_neg(a);
    for (int k = LIMBS; k-- > 0; )
        if (a.limb[k]) {
            int bits = 32 * k;
            for (uint32_t top = a.limb[k]; top; top >>= 1)
                bits++;
            return bits;
        }
    return 0;
}

static uint32_t limb_at(const loft_exact *a, int k)
{
    return k < 0 ? 0 : k < LIMBS ? a->limb[k] : is_negative(a) ? 0xffffffffu : 0;
}

/* Each limb k of the result is assembled from two neighbouring limbs. */
static loft_exact shift_limbs_left(const loft_exact *a, int s)
{
    const int limbs = s / 32, bits = s % 32;
    loft_exact r;

    for (int k = 0; k < LIMBS; k++) {
        const uint64_t pair = (uint64_t)limb_at(a, k - limbs) << 32 | limb_at(a, k - limbs - 1);
        r.limb[k] = (uint32_t)(pair << bits >> 32);
    }
    return r;
}

/* Rounded down. */
static loft_exact shift_limbs_right(const loft_exact *a, int s)
{
    const int limbs = s / 32, bits = s % 32;
    loft_exact r;

    for (int k = 0; k < LIMBS; k++) {
        const uint64_t pair = (uint64_t)limb_at(a, k + limbs + 1) << 32 | limb_at(a, k + limbs);
        r.limb[k] = (uint32_t)(pair >> bits & 0xffffffffu);
    }
    return r;
}

/* floor((floor(a / 2^(s-1)) + 1) / 2) is a / 2^s rounded to nearest. */
loft_exact loft_exact_shift(loft_exact a, int s)
{
    if (s >= 0)
        return shift_limbs_left(&a, s);
    const loft_exact one = loft_exact_from_int(1);
    a = shift_limbs_right(&a, -s - 1);
    add_exact(&a, &one);
    return shift_limbs_right(&a, 1);
}

/* Digit by digit on magnitudes. The remainder r stays below b, and 2 r + 1 below
 * 2^LOFT_EXACT_BITS. */
loft_exact loft_exact_div(loft_exact a, loft_exact b)
{
    const bool flip = is_negative(&a) != is_negative(&b);
    loft_exact q = zero, r;

    if (is_negative(&a))
        a = loft_exact_neg(a);
    if (is_negative(&b))
        b = loft_exact_neg(b);
    int k = loft_exact_bits(a) - loft_exact_bits(b) + 1;
    if (k < 0)
        return zero;
    r = shift_limbs_right(&a, k);
    for (;;) {
        const loft_exact trial = loft_exact_sub(r, b);
        if (!is_negative(&trial)) {
            r = trial;
            q.limb[k / 32] |= (uint32_t)1 << (k % 32);
        }
        if (k-- == 0)
            break;
        add_exact(&r, &r);
        r.limb[0] |= a.limb[k / 32] >> (k % 32) & 1;
    }
    add_exact(&r, &r);
    if (loft_exact_compare(r, b) >= 0)
        q = loft_exact_add(q, loft_exact_from_int(1));
    return flip ? loft_exact_neg(q) : q;
}

/* Two bits of a per round, as for 64 bits in num.c. */
loft_exact loft_exact_root(loft_exact a)
{
    loft_exact r = zero;

    if (is_negative(&a))
        return zero;
    for (int k = (loft_exact_bits(a) + 1) / 2 - 1; k >= 0; k--) {
        loft_exact trial = r;
        /* r holds only bits above this one */
        trial.limb[2 * k / 32] |= (uint32_t)1 << (2 * k % 32);
        trial = loft_exact_sub(a, trial);
        r = shift_limbs_right(&r, 1);
        if (!is_negative(&trial)) {
            a = trial;
            r.limb[2 * k / 32] |= (uint32_t)1 << (2 * k % 32);
        }
    }
    return r;
}

loft_exact loft_exact_hypot(const loft_exact x[], int n)
{
    loft_exact sum = zero;

    for (int i = 0; i < n; i++)
        sum = loft_exact_add(sum, loft_exact_mul(x[i], x[i]));
    return loft_exact_root(loft_exact_shift(sum, 2 * LOFT_EXACT_HYPOT));
}

/* Keep at most 160 bits and count the bits dropped: the error is 2^-160 of the value. */
static loft_exact reduced_bits(loft_exact a, int *cut)
{
    const int excess = loft_exact_bits(a) - 160;

    *cut = excess > 0 ? excess : 0;
    return excess > 0 ? loft_exact_shift(a, -excess) : a;
}

/* a / b * 2^s to nearest, which must be below 2^63. At most 160 bits of a and b are used, so
 * neither exceeds 288 bits when shifted: |s| makes them about equally long, or one 64 bits
 * longer. */
static int64_t scaled_quotient(loft_exact a, loft_exact b, int s)
{
    int cut_a, cut_b;

    a = reduced_bits(a, &cut_a);
    b = reduced_bits(b, &cut_b);
    s += cut_a - cut_b;
    if (s >= 0)
        a = loft_exact_shift(a, s);
    else
        b = loft_exact_shift(b, -s);
    const loft_exact q = loft_exact_div(a, b);
    const uint64_t low = (uint64_t)q.limb[1] << 32 | q.limb[0];
    return is_negative(&q) ? -(int64_t)(~low + 1) : (int64_t)low;
}

/* log2 |a / b| lies within result - 1 .. result + 1 */
static int quotient_log2(loft_exact a, loft_exact b)
{
    return loft_exact_bits(a) - loft_exact_bits(b);
}

#if LOFT_NUM == LOFT_Q16

bool loft_exact_valid(loft_real a)
{
    (void)a;
    return true;
}
loft_exact loft_exact_from_real(loft_real a)    { return loft_exact_from_int(a); }
loft_exact loft_exact_from_unit(loft_unit t)    { return loft_exact_from_int(t); }

bool loft_exact_quot(loft_exact a, loft_exact b, int s, loft_acc *out)
{
    const int e = is_zero(&a) ? -100 : quotient_log2(a, b) + s;

    if (e > 30)
        return false;
    *out = e < -40 ? 0 : scaled_quotient(a, b, s + 32);
    return true;
}

#else

/* The integer part of x * 2^(32 limbs), |x| < 1; *rest is the remainder of x. All steps are
 * exact. */
static loft_exact fixed_point(double x, int limbs, double *rest)
{
    loft_exact r = zero;
    double left = x < 0 ? -x : x;

    for (int k = limbs; k-- > 0; ) {
        left *= 4294967296.0;
        r.limb[k] = (uint32_t)left;
        left -= r.limb[k];
    }
    *rest = left;
    return x < 0 ? loft_exact_neg(r) : r;
}

#define REAL_SIZE 0x1p20        /* 128 bits from 2^20 down to 2^-108 */
#define UNIT_SIZE 0x1p11        /* 64 bits from 2^11 down to 2^-53   */

bool loft_exact_valid(loft_real a)
{
    double rest = 1;

    if (a > -REAL_SIZE && a < REAL_SIZE)
        fixed_point((double)a / REAL_SIZE, 4, &rest);
    return !(rest > 0);
}

loft_exact loft_exact_from_real(loft_real a)
{
    double rest;
    return fixed_point((double)a / REAL_SIZE, 4, &rest);
}

loft_exact loft_exact_from_unit(loft_unit t)
{
    double rest;
    loft_exact r = fixed_point((double)t / UNIT_SIZE, 2, &rest);

    if (rest >= 0.5)
        r = loft_exact_add(r, loft_exact_from_int(t < 0 ? -1 : 1));
    return r;
}

static double power_of_two(int s)
{
    double p = 1;

    for (; s > 0; s--)
        p *= 2;
    for (; s < 0; s++)
        p *= 0.5;
    return p;
}

/* 61 to 63 bits of the quotient, rounded to double. */
bool loft_exact_quot(loft_exact a, loft_exact b, int s, loft_acc *out)
{
    const int k = 61 - quotient_log2(a, b), e = 61 - k + s;

    if (is_zero(&a) || e < -1000) {
        *out = 0;
        return true;
    }
    if (e >= 1000)
        return false;
    *out = (double)scaled_quotient(a, b, k) * 0x1p-61 * power_of_two(e);
    return true;
}

#endif

bool loft_exact_quot_real(loft_exact a, loft_exact b, int s, loft_real *out)
{
    loft_acc x;

    if (!loft_exact_quot(a, b, s, &x) || !loft_acc_valid(x))
        return false;
    *out = loft_acc_round(x);
    return true;
}

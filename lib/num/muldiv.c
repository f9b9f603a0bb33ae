/* lib/num/muldiv.c
 * SPDX-License-Identifier: MIT
 */
#include "num/muldiv.h"

#if LOFT_NUM == LOFT_Q16

typedef struct {
    uint64_t high, low;
} twice;

static uint64_t upper(uint64_t x)       { return (uint32_t)loft_acc_high((int64_t)x); }
static uint64_t lower(uint64_t x)       { return loft_acc_low((int64_t)x); }

static twice sum(twice a, twice b)
{
    const twice r = { a.high + b.high + (a.low + b.low < a.low), a.low + b.low };
    return r;
}

static bool below(const twice *a, const twice *b)
{
    return a->high != b->high ? a->high < b->high : a->low < b->low;
}

/* Four products of the halves. The middle sum is at most (2^32 - 1)^2 + 2 (2^32 - 1) < 2^64. */
static twice wide_product(uint64_t x, uint64_t y)
{
    const uint64_t low = lower(x) * lower(y);
    const uint64_t one = upper(x) * lower(y) + upper(low), two = lower(x) * upper(y) + lower(one);
    const twice r = { upper(x) * upper(y) + upper(one) + upper(two), two << 32 | lower(low) };
    return r;
}

/* Long division, bit by bit. The remainder stays below z < 2^63, so twice the remainder fits. The
 * quotient is below 2^63, so the upper half of the product is below z / 2 and no bit of the
 * quotient is lost. */
loft_acc loft_acc_muldiv(loft_acc x, loft_acc y, loft_acc z)
{
    const twice p = wide_product(loft_acc_size(x), loft_acc_size(y));
    const uint64_t d = (uint64_t)z;
    uint64_t rest = p.high, q = p.low;

    for (int k = 0; k < 64; k++) {
        const bool bit = q >> 63 != 0;
        q += q;
        rest += rest + bit;
        if (rest >= d) {
            rest -= d;
            q++;
        }
    }
    q += rest >= d - rest;
    return (x < 0) != (y < 0) ? -(loft_acc)q : (loft_acc)q;
}

/* For h >= 1 the result is at most 9 |x|. For h < 1, h 2^26 fits a loft_acc; x may be up to h 2^26
 * / k. */
bool loft_acc_grow(loft_acc *x, int32_t k, loft_acc h)
{
    const loft_acc most = loft_to_acc(LOFT_REAL(1)) * 67108864, size = *x < 0 ? -*x : *x;

    if (size > most || (h < loft_to_acc(LOFT_REAL(1)) && size > (h * 67108864 - 1) / k + 1))
        return false;
    *x = loft_acc_muldiv(*x, loft_to_acc(LOFT_REAL(1)) * k, h);
    return true;
}

/* The root of x < 2^122, to nearest: as in num.c, two bits of x per round. `trial` is below
 * 2^123. */
static uint64_t root_of(twice x)
{
    twice r = { 0, 0 }, bit = { (uint64_t)1 << 58, 0 };

    while (bit.high | bit.low) {
        const twice trial = sum(r, bit);
        r.low  = r.low >> 1 | r.high << 63;
        r.high >>= 1;
        if (!below(&x, &trial)) {
            const uint64_t borrow = x.low < trial.low;
            x.low  -= trial.low;
            x.high -= trial.high + borrow;
            r = sum(r, bit);
        }
        bit.low  = bit.low >> 2 | bit.high << 62;
        bit.high >>= 2;
    }
    return r.low + (x.high || x.low > r.low);
}

/* The largest component is scaled to 2^58..2^59, which loses nothing. Six squares sum to less than
 * 2^120.6. */
loft_acc loft_acc_length(const loft_acc x[], int n, uint8_t *shift)
{
    uint64_t largest = 0;
    twice squares = { 0, 0 };

    *shift = 0;
    for (int i = 0; i < n; i++)
        if (loft_acc_size(x[i]) > largest)
            largest = loft_acc_size(x[i]);
    if (largest == 0)
        return 0;
    for (; !(largest >> 58); largest += largest)
        ++*shift;
    for (int i = 0; i < n; i++) {
        const uint64_t size = loft_acc_size(x[i]) << *shift;
        squares = sum(squares, wide_product(size, size));
    }
    return (loft_acc)root_of(squares);
}

/* The bits above the dropped ones, plus the highest dropped bit. */
loft_acc loft_acc_down(loft_acc x, unsigned shift)
{
    return shift ? (x >> shift) + (x >> (shift - 1) & 1) : x;
}

#else

loft_acc loft_acc_muldiv(loft_acc x, loft_acc y, loft_acc z)  { return x / z * y; }
bool loft_acc_grow(loft_acc *x, int32_t k, loft_acc h)
{
    *x = *x / h * k;
    return true;
}
loft_acc loft_acc_down(loft_acc x, unsigned shift) { return x / (loft_acc)((uint64_t)1 << shift); }

loft_acc loft_acc_length(const loft_acc x[], int n, uint8_t *shift)
{
    *shift = 0;
    return loft_acc_hypot(x, n);
}

#endif

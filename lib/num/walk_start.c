/* lib/num/walk_start.c -- the differences of a polynomial, from its control values
 * SPDX-License-Identifier: MIT
 *
 * Let D^k p be the k-th difference of the control values at p[0]. The Bezier polynomial at t = i/n
 * is
 *
 *     P(i/n) = sum_k  g_k (i/n)^k          g_k = C(degree, k) D^k p
 *
 * Write it in the products i (i-1) .. (i-k+1) instead of the powers i^k. Its coefficients times k!
 * are the initial differences e_k. Each e_k is a sum of terms G_j = g_j / n^j, each multiplied by
 * an integer of at most 240.
 *
 * q16. e_k has 32 bits below the LSB. n^-k is computed to 96 bits by k truncating divisions, so it
 * is low by less than 2^-95. G_k = g_k n^-k is truncated to 64 bits below the LSB: its error is
 * less than 2^-63 + |g_k| 2^-95. With |p| <= 2^31 the sum of all these errors is below 2^-50. e_k
 * is then rounded to 32 bits, so its error is at most 2^-33 + 2^-50. It is exact if it is a
 * multiple of 2^-32, that is, if n^degree divides 2^32.
 *
 * The law of ranges. d[0] after i steps is sum_k C(i, k) e_k. Errors of 2^-33 + 2^-50 in e_1 and
 * above cause an error of at most S (2^-33 + 2^-50) LSB there, with S = C(n, 1) + .. + C(n,
 * degree). The walk is valid while this is below 1/2, that is for S <= 2^32 - 2^15. Then no value
 * leaves the 32 bits of its control values, and the last value, an integer, is exact. Everything
 * else may wrap: the sums are correct modulo 2^64, and d[0] needs no more.
 */
#include "num/walk.h"

/* q16: |D^k p| < 2^(k+31), so |g| < 10 * 2^34. */
void loft_walk_powers(loft_acc g[], const loft_real p[], unsigned degree)
{
    unsigned choose = 1;

    for (unsigned k = 0; k <= degree; k++)
        g[k] = p[k];
    for (unsigned k = 1; k <= degree; k++)
        for (unsigned i = degree; i >= k; i--)
            g[i] -= g[i - 1];
    for (unsigned k = 1; k <= degree; k++) {
        choose = choose * (degree - k + 1) / k;
        g[k] *= (loft_acc)choose;
    }
}

/* Turn a[k] = G_k, k = 1..degree, into a[k] = e_k. The map is linear with small integer
 * coefficients. Dividing by i, i - 1, .. in turn gives the coefficients of i (i-1) .. (i-k+1),
 * whose k-th difference is k!. */
void loft_walk_differences(loft_state a[], unsigned degree)
{
    unsigned factorial = 1;

    for (unsigned j = 1; j < degree; j++)
        for (unsigned k = degree - 1; k >= j; k--)
            for (unsigned times = 0; times < j; times++)
                a[k] += a[k + 1];
    for (unsigned k = 2; k <= degree; k++) {
        factorial *= k;
        a[k] *= (loft_state)factorial;
    }
}

#if LOFT_NUM == LOFT_Q16

#if defined(__AVR__)
static uint64_t join_words(uint32_t high, uint32_t low)
{
    loft_bytes b;
    b.half.high = (int32_t)high;
    b.half.low = low;
    return (uint64_t)b.all;
}
#else
static uint64_t join_words(uint32_t high, uint32_t low)       { return (uint64_t)high << 32 | low; }
#endif

#if defined(__AVR__)

static void divide_limbs_short(uint32_t x[], int limbs, uint16_t n)
{
    loft_avr_divide(x, (uint8_t)(4 * limbs), n);
}

static bool shift_limbs_down(uint32_t x[], int limbs, uint32_t n)
{
    (void)x;
    (void)limbs;
    (void)n;
    return false;       /* the division takes less time */
}

#else

/* 32-bit divisions, each of which handles 16 bits of x. */
static void divide_limbs_short(uint32_t x[], int limbs, uint16_t n)
{
    uint32_t rest = 0;

    for (int i = limbs - 1; i >= 0; i--) {
        const uint32_t upper = rest << 16 | x[i] >> 16;
        const uint32_t lower = upper % n << 16 | (x[i] & 0xffff);
        x[i] = upper / n << 16 | lower / n;
        rest = lower % n;
    }
}

/* x / n in place, truncated, if n is a power of two. */
static bool shift_limbs_down(uint32_t x[], int limbs, uint32_t n)
{
    uint8_t m = 0;

    while (n > (uint32_t)1 << m && m < 31)
        m++;
    if (n != (uint32_t)1 << m)
        return false;
    for (int i = 0; m && i < limbs; i++)
        x[i] = x[i] >> m | (i + 1 < limbs ? x[i + 1] << (32 - m) : 0);
    return true;
}

#endif

void loft_limbs_divide(uint32_t x[], int limbs, uint32_t n)
{
    uint32_t rest = 0;

    if (shift_limbs_down(x, limbs, n))
        return;
    if (n >> 16 == 0) {
        divide_limbs_short(x, limbs, (uint16_t)n);
        return;
    }
    for (int i = limbs - 1; i >= 0; i--) {
        const uint64_t part = join_words(rest, x[i]);
        x[i] = (uint32_t)(part / n);
        rest = (uint32_t)(part % n);
    }
}

/* 1 is represented as 2^96 - 1, which is low by 2^-96. */
static void invert_steps(uint32_t inverse[][3], unsigned degree, uint32_t n)
{
    uint32_t x[3] = { UINT32_MAX, UINT32_MAX, UINT32_MAX };

    for (unsigned k = 0; k < degree; k++) {
        loft_limbs_divide(x, 3, n);
        for (int i = 0; i < 3; i++)
            inverse[k][i] = x[i];
    }
}

void loft_powers_init(loft_powers *powers, unsigned degree, uint32_t n)
{
    invert_steps(powers->inverse, degree, n);
}
void loft_powers3_init(loft_powers3 *powers, uint16_t n) { invert_steps(powers->inverse, 3, n); }

#if !defined(__AVR__)

static uint32_t high_word(uint64_t x) { return (uint32_t)loft_acc_high((int64_t)x); }
static uint32_t low_word(uint64_t x)                         { return (uint32_t)(x & 0xffffffffu); }
static uint64_t word_product(uint32_t a, uint32_t b)         { return (uint64_t)a * b; }

typedef struct {
    uint64_t value;         /* in 2^-32, wraps          */
    uint32_t below;         /* the 32 bits below that   */
} term;

/* g times inverse, |g| < 2^38. The product has five 32-bit places: place 1 is `below`, places 2 and
 * 3 are `value`. The sum in place 1 is less than 2^32 + 2^32 + 2^38. */
static term scaled_term(int64_t g, const uint32_t inverse[3])
{
    const uint64_t size = (uint64_t)(g < 0 ? -g : g);
    const uint64_t at_1 = word_product(low_word(size), inverse[1]);
    const uint64_t sum_1 = word_product(high_word(size), inverse[0]) +
                           high_word(word_product(low_word(size), inverse[0])) + low_word(at_1);
    term t;

    t.below = low_word(sum_1);
    t.value = word_product(low_word(size), inverse[2]) + word_product(high_word(size), inverse[1]) +
              high_word(sum_1) + high_word(at_1) + join_words(high_word(size) * inverse[2], 0);
    if (g < 0) {
        t.below = 0 - t.below;
        t.value = 0 - t.value - (t.below != 0);
    }
    return t;
}

typedef uint64_t wide;

/* The caller provides space for degree + 1 numbers in `below`. */
static void start_walk(loft_state d[], const loft_real p[], unsigned degree,
                       const uint32_t inverse[][3], wide below[])
{
    loft_acc g[LOFT_WALK_DEGREE_MAX + 1];

    loft_walk_powers(g, p, degree);
    d[0] = join_words((uint32_t)p[0], (uint32_t)1 << 31);
    for (unsigned k = 1; k <= degree; k++) {
        const term t = scaled_term(g[k], inverse[k - 1]);
        d[k] = t.value;
        below[k] = t.below;
    }
    loft_walk_differences(d, degree);
    loft_walk_differences(below, degree);
    for (unsigned k = 1; k <= degree; k++)
        d[k] += high_word(below[k] + ((uint32_t)1 << 31));
}

#else

/* 96 bits, lowest byte first; wraps. avr-gcc calls a function for each 64-bit operation and loads
 * 16 registers for it. Here value and `below` are one number, and every operation is a loop over
 * its bytes. */
typedef struct {
    uint8_t byte[12];
} wide;

#define WIDE_LOOP(op)                                                                              \
    "ldi %[left], 12\n clc\n"                                                                      \
    "1: ld __tmp_reg__, %a[a]\n ld %[byte], %a[b]+\n " op                                          \
    " __tmp_reg__, %[byte]\n st %a[a]+, __tmp_reg__\n dec %[left]\n brne 1b\n"

static void wide_add(wide *a, const wide *b)
{
    uint8_t byte, left;
    __asm__ volatile(WIDE_LOOP("adc")
                     : [a] "+x"(a), [b] "+z"(b), [byte] "=&r"(byte), [left] "=&d"(left)
                     :
                     : "memory");
}

static void wide_sub(wide *a, const wide *b)
{
    uint8_t byte, left;
    __asm__ volatile(WIDE_LOOP("sbc")
                     : [a] "+x"(a), [b] "+z"(b), [byte] "=&r"(byte), [left] "=&d"(left)
                     :
                     : "memory");
}

static void wide_times(wide *a, uint8_t factor)
{
    const uint8_t zero = 0;
    uint8_t byte, left = 12, carry = 0;

    __asm__ volatile (
        "1: ld %[byte], %a[a]\n mul %[byte], %[factor]\n add r0, %[carry]\n adc r1, %[zero]\n"
        "   st %a[a]+, r0\n mov %[carry], r1\n dec %[left]\n brne 1b\n clr r1\n"
        : [a] "+x" (a), [byte] "=&r" (byte), [left] "+&r" (left), [carry] "+&r" (carry)
        : [factor] "r"(factor), [zero] "r"(zero)
        : "memory");
}

static void wide_set(wide *a, int32_t x)
{
    __builtin_memcpy(a->byte, &x, 4);
    __builtin_memset(a->byte + 4, x < 0 ? 0xFF : 0, 8);
}

/* loft_walk_powers and loft_walk_differences with 96-bit numbers; for a cubic in a third of the
 * time, in registers. */
static void start_walk(loft_state d[], const loft_real p[], unsigned degree,
                       const uint32_t inverse[][3], wide a[])
{
    uint8_t choose = 1, factorial = 1;

    if (degree == 3) {
        loft_avr_start3(d, p, inverse, a->byte);
        d[0] = join_words((uint32_t)p[0], (uint32_t)1 << 31);
        return;
    }
    for (uint8_t k = 0; k <= degree; k++)
        wide_set(&a[k], p[k]);
    for (uint8_t k = 1; k <= degree; k++)
        for (uint8_t i = (uint8_t)degree; i >= k; i--)
            wide_sub(&a[i], &a[i - 1]);
    for (uint8_t k = 1; k <= degree; k++) {
        choose = (uint8_t)(choose * (degree - k + 1) / k);
        wide_times(&a[k], choose);
    }
    for (uint8_t k = (uint8_t)degree; k >= 1; k--)
        loft_avr_scale_wide(a[k].byte, inverse[k - 1]);
    for (uint8_t j = 1; j < degree; j++)
        for (uint8_t k = (uint8_t)(degree - 1); k >= j; k--)
            for (uint8_t times = 0; times < j; times++)
                wide_add(&a[k], &a[k + 1]);
    d[0] = join_words((uint32_t)p[0], (uint32_t)1 << 31);
    for (uint8_t k = 1; k <= degree; k++) {
        factorial = (uint8_t)(factorial * k);
        wide_times(&a[k], factorial);
        __builtin_memcpy(&d[k], a[k].byte + 4, sizeof d[k]);
        if (a[k].byte[3] & 0x80u)
            d[k]++;
    }
}

#endif

static void start_polynomial(loft_state d[], const loft_real p[], unsigned degree,
                             const loft_powers *powers)
{
    wide room[LOFT_WALK_DEGREE_MAX + 1];
    start_walk(d, p, degree, powers->inverse, room);
}

static void start_cubic(loft_state d[], const loft_real p[4], const loft_powers3 *powers)
{
    wide room[4];
    start_walk(d, p, 3, powers->inverse, room);
}

#else

void loft_powers3_init(loft_powers3 *powers, uint16_t n)                    { powers->n = n; }
void loft_powers_init(loft_powers *powers, unsigned degree, uint32_t n)
{
    (void)degree;
    powers->n = n;
}

static void start_polynomial(loft_state d[], const loft_real p[], unsigned degree,
                             const loft_powers *powers)
{
    loft_acc g[LOFT_WALK_DEGREE_MAX + 1];
    double scale = powers->n;

    loft_walk_powers(g, p, degree);
    d[0] = p[0];
    for (unsigned k = 1; k <= degree; k++) {
        d[k] = g[k] / scale;
        scale *= powers->n;
    }
    loft_walk_differences(d, degree);
}

static void start_cubic(loft_state d[], const loft_real p[4], const loft_powers3 *powers)
{
    start_polynomial(d, p, 3, powers);
}

#endif

void loft_walk_init(loft_walk *w, const loft_real p[], unsigned degree, const loft_powers *powers)
{
    for (unsigned k = degree + 1; k <= LOFT_WALK_DEGREE_MAX; k++)
        w->d[k] = 0;
    start_polynomial(w->d, p, degree, powers);
    loft_walk_keep(w, p[degree]);
}

void loft_walk3_init(loft_walk3 *w, const loft_real p[4], const loft_powers3 *powers)
{
    start_cubic(w->d, p, powers);
    loft_walk3_keep(w, p[3]);
}

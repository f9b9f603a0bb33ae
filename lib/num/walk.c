/* lib/num/walk.c -- the differences of a polynomial, from its control values
 * SPDX-License-Identifier: MIT
 *
 * With D^k p the k-th difference of the control values at p[0], the Bezier polynomial at t = i/n is
 *
 *     P(i/n) = sum_k  g_k (i/n)^k          g_k = C(degree, k) D^k p
 *
 * Written in the products i (i-1) .. (i-k+1) instead of the powers i^k, its coefficients times k! are the
 * differences e_k to start with: e_k is the sum of some G_j = g_j / n^j times whole numbers of 240 at most.
 *
 * q16. e_k is kept to 32 bits below the LSB. n^-k is cut to 96 bits, by k divisions each cut: it is low by
 * less than 2^-95. G_k = g_k n^-k is cut to 64 bits below the LSB: off by less than 2^-63 + |g_k| 2^-95. With
 * |p| <= 2^31 the sums of all that are below 2^-50, so e_k, then rounded to 32 bits, is off by at most
 * 2^-33 + 2^-50, and not at all where it is a multiple of 2^-32: if n^degree divides 2^32.
 *
 * The law of ranges. d[0] after i steps is sum_k C(i, k) e_k, so errors of 2^-33 + 2^-50 in e_1.. err there
 * by at most S (2^-33 + 2^-50) LSB, S = C(n, 1) + .. + C(n, degree). The walk is admitted while that is below
 * 1/2, S <= 2^32 - 2^15: then no value leaves the 32 bits in which its control values are, and the last one,
 * being whole, is met exactly. All else may wrap: the sums are right modulo 2^64 and d[0] needs no more.
 */
#include "num/walk.h"

/* C(n, k) < 2^32 before each product, so none exceeds 2^64. */
bool loft_walk_admits(unsigned degree, uint32_t n)
{
    const uint64_t limit = UINT32_MAX - 32767;
    uint64_t choose = 1, sum = 0;

    for (unsigned k = 1; k <= degree && k <= n; k++) {
        choose = choose * (n - k + 1) / k;
        sum += choose;
        if (sum > limit)
            return false;
    }
    return true;
}

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

/* From a[k] = G_k, k = 1..degree, to a[k] = e_k, linear and in small whole numbers. Dividing by i, i - 1, ..
 * in turn gives the coefficients of i (i-1) .. (i-k+1), whose k-th difference is k!. */
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
static uint64_t join(uint32_t high, uint32_t low)
{
    loft_bytes b;
    b.half.high = (int32_t)high;
    b.half.low = low;
    return (uint64_t)b.all;
}
#else
static uint64_t join(uint32_t high, uint32_t low)       { return (uint64_t)high << 32 | low; }
#endif

static uint32_t high(uint64_t x)                        { return (uint32_t)loft_acc_high((int64_t)x); }
static uint32_t low(uint64_t x)                         { return (uint32_t)(x & 0xffffffffu); }
static uint64_t product(uint32_t a, uint32_t b)         { return (uint64_t)a * b; }

bool loft_walk_accepts(const loft_real p[], unsigned degree)
{
    (void)p;
    (void)degree;
    return true;
}

/* x / 2^m in place, cut, m < 32. */
static void shift_down(uint32_t x[], int limbs, uint8_t m)
{
    for (int i = 0; m && i < limbs; i++)
        x[i] = x[i] >> m | (i + 1 < limbs ? x[i + 1] << (32 - m) : 0);
}

/* x / n in place, cut. Divisions of 32 bits are the fastest on all cores, so a small n takes 16 bits of x
 * at a time. */
static void divide(uint32_t x[], int limbs, uint32_t n)
{
    uint32_t rest = 0;

    for (int i = limbs - 1; i >= 0; i--)
        if (n >> 16) {
            const uint64_t part = join(rest, x[i]);
            x[i] = (uint32_t)(part / n);
            rest = (uint32_t)(part % n);
        } else {
            const uint32_t upper = rest << 16 | x[i] >> 16;
            const uint32_t lower = upper % n << 16 | (x[i] & 0xffff);
            x[i] = upper / n << 16 | lower / n;
            rest = lower % n;
        }
}

void loft_limbs_divide(uint32_t x[], int limbs, uint32_t n)
{
    uint8_t m = 0;

    while (n > (uint32_t)1 << m && m < 31)
        m++;
    if (n == (uint32_t)1 << m)
        shift_down(x, limbs, m);
    else
        divide(x, limbs, n);
}

/* 1 is 2^96 - 1 here, low by 2^-96. */
void loft_powers_init(loft_powers *powers, unsigned degree, uint32_t n)
{
    uint32_t x[3] = { UINT32_MAX, UINT32_MAX, UINT32_MAX };

    for (unsigned k = 1; k <= degree; k++) {
        loft_limbs_divide(x, 3, n);
        for (int i = 0; i < 3; i++)
            powers->inverse[k][i] = x[i];
    }
}

typedef struct {
    uint64_t value;         /* in 2^-32, wraps          */
    uint32_t below;         /* the 32 bits below that   */
} term;

/* g times inverse, |g| < 2^38: the product has five places of 32 bits, of which 1 is `below` and 2, 3 are
 * `value`. Place 1 sums to less than 2^32 + 2^32 + 2^38. */
static term scaled(int64_t g, const uint32_t inverse[3])
{
    const uint64_t size = (uint64_t)(g < 0 ? -g : g);
    const uint64_t at_1 = product(low(size), inverse[1]);
    const uint64_t sum_1 = product(high(size), inverse[0]) + high(product(low(size), inverse[0])) + low(at_1);
    term t;

    t.below = low(sum_1);
    t.value = product(low(size), inverse[2]) + product(high(size), inverse[1]) + high(sum_1) + high(at_1) +
              join(high(size) * inverse[2], 0);
    if (g < 0) {
        t.below = 0 - t.below;
        t.value = 0 - t.value - (t.below != 0);
    }
    return t;
}

void loft_walk_init(loft_walk *w, const loft_real p[], unsigned degree, const loft_powers *powers)
{
    uint64_t below[LOFT_WALK_DEGREE_MAX + 1];
    loft_acc g[LOFT_WALK_DEGREE_MAX + 1];

    loft_walk_powers(g, p, degree);
    w->d[0] = join((uint32_t)p[0], (uint32_t)1 << 31);
    for (unsigned k = 1; k <= LOFT_WALK_DEGREE_MAX; k++)
        w->d[k] = 0;
    for (unsigned k = 1; k <= degree; k++) {
        const term t = scaled(g[k], powers->inverse[k]);
        w->d[k] = t.value;
        below[k] = t.below;
    }
    loft_walk_differences(w->d, degree);
    loft_walk_differences(below, degree);
    for (unsigned k = 1; k <= degree; k++)
        w->d[k] += high(below[k] + ((uint32_t)1 << 31));
}

/* loft_walk_halve divides by powers of two and so needs true differences, |D^k| < 2^31 LSB, none wrapped.
 * With n >= 4 steps all parameters that a difference sees, 0 .. 1 + (degree-1)/n, are within 0..2, where a
 * Bezier polynomial is at most 3^degree times its largest control value. So, w being the width of p,
 *
 *     |D^k| <= degree!/(degree-k)! 2^(k-1) w 3^(degree-k) / n^k
 *
 * of which, for n >= 4 and degree <= 5, k = 1 gives the largest: n >= degree 3^(degree-1) w / 2^31 suffices. */
uint32_t loft_walk_coarsest(const loft_real p[], unsigned degree)
{
    int64_t low = p[0], high = p[0];
    uint64_t bound = degree;

    for (unsigned k = 1; k <= degree; k++) {
        if (p[k] < low)  low = p[k];
        if (p[k] > high) high = p[k];
    }
    for (unsigned k = 1; k < degree; k++)
        bound *= 3;
    bound = bound * (uint64_t)(high - low) / ((uint64_t)1 << 31) + 1;
    return bound < 4 ? 4 : (uint32_t)bound;
}

/* sum is 2^k times a whole number when no true difference wraps. */
static loft_state over_power_of_two(loft_state sum, unsigned k)
{
    return (uint64_t)((int64_t)sum / (int32_t)(1 << k));
}

#else

/* The sum of all |g_k| c(k, j) is below 2^14 times the largest |p|. */
bool loft_walk_accepts(const loft_real p[], unsigned degree)
{
    for (unsigned k = 0; k <= degree; k++)
        if (!(p[k] >= -LOFT_REAL_MAX / 65536 && p[k] <= LOFT_REAL_MAX / 65536))
            return false;
    return true;
}

void loft_powers_init(loft_powers *powers, unsigned degree, uint32_t n)
{
    (void)degree;
    powers->n = n;
}

void loft_walk_init(loft_walk *w, const loft_real p[], unsigned degree, const loft_powers *powers)
{
    loft_acc g[LOFT_WALK_DEGREE_MAX + 1];
    double scale = powers->n;

    loft_walk_powers(g, p, degree);
    w->d[0] = p[0];
    w->end = p[degree];
    for (unsigned k = 1; k <= LOFT_WALK_DEGREE_MAX; k++) {
        w->d[k] = k <= degree ? g[k] / scale : 0;
        scale *= powers->n;
    }
    loft_walk_differences(w->d, degree);
}

/* Sums of floats do not wrap. */
uint32_t loft_walk_coarsest(const loft_real p[], unsigned degree)
{
    (void)p;
    (void)degree;
    return 1;
}

static loft_state over_power_of_two(loft_state sum, unsigned k)
{
    return sum / (1 << k);
}

#endif

#if defined(__AVR__)

/* No core with 8-bit registers keeps four numbers of 64 bits in them. */
void loft_walk_run(loft_walk *w, unsigned degree, loft_real out[], size_t stride, uint32_t count)
{
    for (; count; count--, out += stride)
        *out = loft_walk_step(w, degree);
}

#else

/* The differences are named, not an array: compilers keep names in registers. Those above the degree are
 * 0, so a cubic's road does for all below; two steps a round are 0.7 of the time of one. */
static void run_cubic(loft_state d[], loft_real out[], size_t stride, uint32_t count)
{
    loft_state d0 = d[0], d1 = d[1], d2 = d[2];
    const loft_state d3 = d[3];

    if (count & 1) {
        d0 += d1;
        d1 += d2;
        d2 += d3;
        *out = loft_state_real(&d0);
        out += stride;
    }
    for (count /= 2; count; count--) {
        d0 += d1;
        d1 += d2;
        d2 += d3;
        out[0] = loft_state_real(&d0);
        d0 += d1;
        d1 += d2;
        d2 += d3;
        out[stride] = loft_state_real(&d0);
        out += 2 * stride;
    }
    d[0] = d0;
    d[1] = d1;
    d[2] = d2;
}

static void run_quintic(loft_state d[], loft_real out[], size_t stride, uint32_t count)
{
    loft_state d0 = d[0], d1 = d[1], d2 = d[2], d3 = d[3], d4 = d[4];
    const loft_state d5 = d[5];

    for (; count; count--, out += stride) {
        d0 += d1;
        d1 += d2;
        d2 += d3;
        d3 += d4;
        d4 += d5;
        *out = loft_state_real(&d0);
    }
    d[0] = d0;
    d[1] = d1;
    d[2] = d2;
    d[3] = d3;
    d[4] = d4;
}

void loft_walk_run(loft_walk *w, unsigned degree, loft_real out[], size_t stride, uint32_t count)
{
    if (degree <= 3)
        run_cubic(w->d, out, stride, count);
    else
        run_quintic(w->d, out, stride, count);
}

#endif

/* Twice the step, D, from the single, d: 1 + D = (1 + d)^2, so
 *
 *     D^k = (2d + d^2)^k = sum_i  C(k, i) 2^(k-i) d^(k+i)
 *
 * The places from k upwards are still those of the single step when D^k is computed, as k rises. The
 * factor goes from i to i + 1 by (k - i) / (2 (i + 1)), without a rest. */
void loft_walk_double(loft_walk *w, unsigned degree)
{
    for (unsigned k = 1; k <= degree; k++) {
        loft_state sum = 0;
        unsigned factor = 1u << k;

        for (unsigned i = 0; i <= k && k + i <= degree; i++) {
            sum += (loft_state)factor * w->d[k + i];
            factor = factor * (k - i) / (2 * (i + 1));
        }
        w->d[k] = sum;
    }
}

/* The same solved for d^k, from the highest difference down. */
void loft_walk_halve(loft_walk *w, unsigned degree)
{
    for (unsigned k = degree; k >= 1; k--) {
        loft_state sum = w->d[k];
        unsigned factor = 1u << k;

        for (unsigned i = 1; i <= k && k + i <= degree; i++) {
            factor = factor * (k - i + 1) / (2 * i);
            sum -= (loft_state)factor * w->d[k + i];
        }
        w->d[k] = over_power_of_two(sum, k);
    }
}

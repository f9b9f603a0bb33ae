/* lib/num/walk.c -- the range checks and the steps of a walk
 * SPDX-License-Identifier: MIT
 *
 * walk_start.c sets up a walk and derives its range.
 */
#include "num/walk.h"

/* C(n, k) < 2^32 before each product, so none exceeds 2^64. */
bool loft_walk_steps_valid(unsigned degree, uint32_t n)
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

#if LOFT_NUM == LOFT_Q16

bool loft_walk_valid(const loft_real p[], unsigned degree)
{
    (void)p;
    (void)degree;
    return true;
}

/* loft_walk_halve divides by powers of two, so it needs true differences that have not wrapped,
 * |D^k| < 2^31 LSB. With n >= 4 steps, all parameters that a difference uses, 0 .. 1 +
 * (degree-1)/n, are within 0..2. There a Bezier polynomial is at most 3^degree times its largest
 * control value. Hence, with w the width of the range of p,
 *
 *     |D^k| <= degree!/(degree-k)! 2^(k-1) w 3^(degree-k) / n^k
 *
 * For n >= 4 and degree <= 5 this is largest at k = 1, so n >= degree 3^(degree-1) w / 2^31
 * suffices. */
uint32_t loft_walk_coarsest(const loft_real p[], unsigned degree)
{
    int64_t low = p[0], high = p[0];
    uint64_t bound = degree;

    for (unsigned k = 1; k <= degree; k++) {
        if (p[k] < low)
            low = p[k];
        if (p[k] > high)
            high = p[k];
    }
    for (unsigned k = 1; k < degree; k++)
        bound *= 3;
    bound = bound * (uint64_t)(high - low) / ((uint64_t)1 << 31) + 1;
    return bound < 4 ? 4 : (uint32_t)bound;
}

/* sum is 2^k times an integer if no true difference wraps. */
static loft_state over_power_of_two(loft_state sum, unsigned k)
{
    return (uint64_t)((int64_t)sum / (int32_t)(1 << k));
}

#else

/* The sum of all |g_k| c(k, j) is below 2^14 times the largest |p|. */
bool loft_walk_valid(const loft_real p[], unsigned degree)
{
    for (unsigned k = 0; k <= degree; k++)
        if (!(p[k] >= -LOFT_REAL_MAX / 65536 && p[k] <= LOFT_REAL_MAX / 65536))
            return false;
    return true;
}

/* Sums of floats do not wrap. */
uint32_t loft_walk_coarsest(const loft_real p[], unsigned degree)
{
    (void)p;
    (void)degree;
    return 1;
}

static loft_state over_power_of_two(loft_state sum, unsigned k) { return sum / (1 << k); }

#endif

#if defined(__AVR__)

/* No core with 8-bit registers holds four 64-bit numbers in registers. */
void loft_walk_run(loft_walk *w, unsigned degree, loft_real out[], size_t stride, uint32_t count)
{
    for (; count; count--, out += stride)
        *out = loft_walk_step(w, degree);
}

#else

/* The differences are separate variables, not an array, because compilers keep variables in
 * registers. Those above the degree are 0, so the cubic code serves all lower degrees. Two steps
 * per round take 0.7 of the time of one. */
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

/* Let d be the difference operator of the single step and D that of the double step. Then 1 + D =
 * (1 + d)^2, so
 *
 *     D^k = (2d + d^2)^k = sum_i  C(k, i) 2^(k-i) d^(k+i)
 *
 * k ascends, so the entries from k upwards are still those of the single step when D^k is computed.
 * The factor changes from i to i + 1 by (k - i) / (2 (i + 1)), which leaves no remainder. */
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

/* The same equation solved for d^k, from the highest difference down. */
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

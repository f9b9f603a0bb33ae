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

/* Three of the four 64-bit numbers fit in registers. `out` is in memory, so `count` has 16 bits. */
void loft_walk_run(loft_walk *w, unsigned degree, loft_real out[], size_t stride, uint32_t count)
{
#if LOFT_NUM == LOFT_Q16
    if (degree <= 3 && stride < 64 && count > 0) {
        loft_avr_run3(w->d, out, (uint16_t)count, (uint8_t)(stride * sizeof *out));
        return;
    }
#endif
    for (; count; count--, out += stride)
        *out = loft_walk_step(w, degree);
}

#else

#if defined(__thumb__) && !defined(__thumb2__) && defined(__ARMEL__) && LOFT_NUM == LOFT_Q16

/* 12 instructions a step where gcc takes 20: d[0..2] in r0..r5, d[3] in r8 and r9. */
static void run_cubic(loft_state d[], loft_real out[], size_t stride, uint32_t count)
{
    register loft_state *state __asm__("r0") = d;
    register loft_real *at __asm__("r1") = out;
    register size_t bytes __asm__("r2") = stride * sizeof *out;
    register loft_real *end __asm__("r3") = out + count * stride;

    if (count == 0)
        return;
    __asm__ volatile(".syntax unified\n"
                     "push {r0, r7}\n mov r10, r2\n mov r12, r3\n mov r7, r1\n"
                     "ldr r1, [r0, #24]\n ldr r2, [r0, #28]\n mov r8, r1\n mov r9, r2\n"
                     "ldm r0, {r0-r5}\n"
                     "1: adds r0, r0, r2\n adcs r1, r3\n str r1, [r7]\n"
                     "adds r2, r2, r4\n adcs r3, r5\n"
                     "mov r6, r8\n adds r4, r4, r6\n mov r6, r9\n adcs r5, r6\n"
                     "add r7, r10\n cmp r7, r12\n bne 1b\n"
                     "pop {r6, r7}\n stmia r6!, {r0-r5}\n"
                     : "+r"(state), "+r"(at), "+r"(bytes), "+r"(end)
                     :
                     : "r4", "r5", "r6", "r8", "r9", "r10", "r12", "cc", "memory");
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

#endif

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

#if defined(LOFT_WALK_TWO)

typedef uint64_t two_states __attribute__((vector_size(16)));
typedef int32_t four_words __attribute__((vector_size(16)));
typedef int32_t two_words __attribute__((vector_size(8)));

static inline two_states states_of(const loft_walk w[2], unsigned k)
{
    return (two_states){ w[0].d[k], w[1].d[k] };
}

/* The values of two steps. */
static inline void put_words(loft_real out[], size_t stride, four_words high)
{
    __builtin_memcpy(out, &high, 2 * sizeof *out);
    __builtin_memcpy(out + stride, (const loft_real *)&high + 2, 2 * sizeof *out);
}

static inline void put_high(loft_real out[], size_t stride, two_states first, two_states second)
{
    put_words(out, stride,
              __builtin_shufflevector((four_words)first, (four_words)second, 1, 3, 5, 7));
}

#  if defined(__AVX2__)

/* Two steps are one step of a walk of double steps, in which
 *
 *     D1 = 2 d1 + d2      D2 = 4 d2 + 4 d3        D3 = 8 d3
 *
 * The lower half of each register is at the first of two places, the upper one at the second. What
 * comes after the last places gives the differences of single steps back. All of these are sums
 * modulo 2^64, so nothing differs from single steps. In two axes it takes 0.6 of their time. */
typedef uint64_t four_states __attribute__((vector_size(32)));
typedef int32_t eight_words __attribute__((vector_size(32)));

static inline four_states both(two_states first, two_states second)
{
    return __builtin_shufflevector(first, second, 0, 1, 2, 3);
}

static void run_pairs(two_states d[4], loft_real out[], size_t stride, uint32_t pairs)
{
    const two_states first = d[0] + d[1], e1 = d[1] + d[2], e2 = d[2] + d[3], f1 = e1 + e2;
    four_states d0 = both(first, first + e1), last = d0;
    four_states d1 = both(2 * e1 + e2, 2 * f1 + e2 + d[3]);
    four_states d2 = both(4 * e2 + 4 * d[3], 4 * e2 + 8 * d[3]);
    const four_states d3 = both(8 * d[3], 8 * d[3]);

    for (; pairs; pairs--, out += 2 * stride) {
        const eight_words words = (eight_words)d0;
        put_words(out, stride, __builtin_shufflevector(words, words, 1, 3, 5, 7));
        last = d0;
        d0 += d1;
        d1 += d2;
        d2 += d3;
    }
    const two_states at = __builtin_shufflevector(last, last, 2, 3);
    const two_states next = __builtin_shufflevector(d0, d0, 0, 1);
    d[0] = at;
    d[1] = next - at;
    d[2] = __builtin_shufflevector(d0, d0, 2, 3) - 2 * next + at;
}

#  else

static void run_pairs(two_states d[4], loft_real out[], size_t stride, uint32_t pairs)
{
    two_states d0 = d[0], d1 = d[1], d2 = d[2];
    const two_states d3 = d[3];

    for (; pairs; pairs--, out += 2 * stride) {
        const two_states first = d0 + d1;
        d1 += d2;
        d2 += d3;
        d0 = first + d1;
        d1 += d2;
        d2 += d3;
        put_high(out, stride, first, d0);
    }
    d[0] = d0;
    d[1] = d1;
    d[2] = d2;
}

#  endif

/* One axis in each half of a register of 128 bits: wrapping sums of 64 bits, as one by one. In two
 * axes it takes 0.6 of the time. */
bool loft_walk_run2(loft_walk w[2], unsigned degree, loft_real out[], size_t stride, uint32_t count)
{
    two_states d[4] = { states_of(w, 0), states_of(w, 1), states_of(w, 2), states_of(w, 3) };

    if (degree > 3)
        return false;
    if (count & 1) {
        d[0] += d[1];
        d[1] += d[2];
        d[2] += d[3];
        put_high(out, 0, d[0], d[0]);
        out += stride;
    }
    if (count / 2 > 0)
        run_pairs(d, out, stride, count / 2);
    for (unsigned i = 0; i < 2; i++) {
        w[i].d[0] = d[0][i];
        w[i].d[1] = d[1][i];
        w[i].d[2] = d[2][i];
    }
    return true;
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

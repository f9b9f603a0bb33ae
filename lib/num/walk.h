/* lib/num/walk.h -- forward differencing: a polynomial at equal steps by additions, in one
 * coordinate
 * SPDX-License-Identifier: MIT
 *
 * The state is d[0] = the value and d[k] = the k-th difference. A step is d[k] += d[k+1] for k = 0,
 * 1, .. in ascending order. curve/forward.h walks all coordinates of a curve with it.
 *
 *   q16        wrapping integers, 32 bits below the LSB: only the start rounds, once; no sum does
 *   f32, f64   plain sums of doubles; the last value is the last control value
 */
#ifndef LOFT_NUM_WALK_H
#define LOFT_NUM_WALK_H

#include "num/num.h"

LOFT_BEGIN_C

#define LOFT_WALK_DEGREE_MAX 5

#if LOFT_NUM == LOFT_Q16

typedef uint64_t loft_state;    /* the LSB is 2^32; it wraps, which matters only for a value outside
                                 * 32 bits */

typedef struct {
    uint32_t inverse[LOFT_WALK_DEGREE_MAX][3];      /* [k - 1]: n^-k with 96 bits below the point,
                                                     * lowest limb first */
} loft_powers;

/* The same for a cubic, in less memory. */
typedef struct {
    uint32_t inverse[3][3];
} loft_powers3;

typedef struct {
    loft_state d[LOFT_WALK_DEGREE_MAX + 1];     /* d[0] includes the 1/2 LSB that makes truncation
                                                 * round to nearest */
} loft_walk;

/* The same for a cubic, in less memory. */
typedef struct {
    loft_state d[4];
} loft_walk3;

/* error none: the rounding is part of the state */
static inline loft_real loft_state_real(const loft_state *s)
{
#if defined(__AVR__)
    int32_t high;       /* four bytes, where loft_acc_high would load eight */
    __builtin_memcpy(&high, (const uint8_t *)s + 4, 4);
    return high;
#else
    return loft_acc_high((int64_t)*s);
#endif
}

/* The last value that the walk returns: in q16 the differences lead to it. */
static inline void loft_walk_keep(loft_walk *w, loft_real end)
{
    (void)w;
    (void)end;
}
static inline void loft_walk3_keep(loft_walk3 *w, loft_real end)
{
    (void)w;
    (void)end;
}
static inline loft_real loft_walk_end(const loft_walk *w, loft_real arrived)
{
    (void)w;
    return arrived;
}
static inline loft_real loft_walk3_end(const loft_walk3 *w, loft_real arrived)
{
    (void)w;
    return arrived;
}

/* The middle of a cubic Bezier polynomial: bit for bit the middle value of a walk of two steps.
 *
 *   error   1/2 LSB, ties upward
 *           f32, f64: one rounding of coordinates that are multiples of 2^-16
 *   cost    AVR: 150 cycles */
static inline loft_real loft_walk3_middle(loft_real a, loft_real b, loft_real c, loft_real d)
{
    /* (a + 3 b + 3 c + d + 4) / 8 in two parts: eight eighths of 29 bits, and the bits they lost,
     * at most 56 + 4 */
    const uint8_t cut = (uint8_t)((a & 7) + (d & 7) + 3 * ((b & 7) + (c & 7)) + 4);
    return loft_eighth(a) + loft_eighth(d) + 3 * (loft_eighth(b) + loft_eighth(c)) +
           (int32_t)(cut >> 3);
}

#else

typedef double loft_state;

typedef struct {
    double n;
} loft_powers, loft_powers3;

typedef struct {
    loft_state d[LOFT_WALK_DEGREE_MAX + 1];
    loft_real end;
} loft_walk;

typedef struct {
    loft_state d[4];
    loft_real end;
} loft_walk3;

static inline loft_real loft_state_real(const loft_state *s) { return (loft_real)*s; }
static inline void loft_walk_keep(loft_walk *w, loft_real end)   { w->end = end; }
static inline void loft_walk3_keep(loft_walk3 *w, loft_real end) { w->end = end; }
static inline loft_real loft_walk_end(const loft_walk *w, loft_real arrived)
{
    (void)arrived;
    return w->end;
}
static inline loft_real loft_walk3_end(const loft_walk3 *w, loft_real arrived)
{
    (void)arrived;
    return w->end;
}

static inline loft_real loft_walk3_middle(loft_real a, loft_real b, loft_real c, loft_real d)
{
    return (loft_real)(((loft_acc)a + d + 3 * ((loft_acc)b + c)) / 8);
}

#endif

/* The state of curve/forward.h. What each step reads is in front, where assembly reaches it. */
typedef struct {
    uint32_t left;                      /* points to come */
    uint8_t degree;
    int8_t halvings, doublings;         /* halvings for which guard bits remain, and doublings that
                                         * a halving can undo exactly (negative: none) */
    loft_walk axis[LOFT_AXES];
} loft_walks;

/* d[0] += d[1]. avr-gcc calls a function for it and loads 16 registers. */
static inline void loft_state_add(loft_state d[2])
{
#if defined(__AVR__)
#define LOFT_ADD_BYTE(add, i)                                                                      \
    "ldd __tmp_reg__, Z+" #i "\n ldd %0, Z+8+" #i "\n " add " __tmp_reg__, %0\n std Z+" #i         \
    ", __tmp_reg__\n "
    uint8_t byte;
    __asm__ volatile(LOFT_ADD_BYTE("add", 0) LOFT_ADD_BYTE("adc", 1) LOFT_ADD_BYTE("adc", 2)
                         LOFT_ADD_BYTE("adc", 3) LOFT_ADD_BYTE("adc", 4) LOFT_ADD_BYTE("adc", 5)
                             LOFT_ADD_BYTE("adc", 6) LOFT_ADD_BYTE("adc", 7)
                     : "=&r"(byte)
                     : "z"(d)
                     : "memory");
#  undef LOFT_ADD_BYTE
#else
    d[0] += d[1];
#endif
}

/* One step of three differences. Each is loaded once, but an AVR has too few registers for that. A
 * Cortex-M loads and stores several words at once, which gcc does not: 12 instructions, not 20. */
static inline void loft_state_step3(loft_state d[4])
{
#if defined(__AVR__)
    loft_state_add(d);
    loft_state_add(d + 1);
    loft_state_add(d + 2);
#elif defined(__thumb2__) && defined(__ARMEL__) && LOFT_NUM == LOFT_Q16
    __asm__ volatile("ldmia %0, {r0-r5}\n ldrd r6, r8, [%0, #24]\n"
                     "adds r0, r2\n adcs r1, r3\n adds r2, r4\n adcs r3, r5\n"
                     "adds r4, r6\n adc r5, r8\n stmia %0, {r0-r5}\n"
                     :
                     : "r"(d)
                     : "r0", "r1", "r2", "r3", "r4", "r5", "r6", "r8", "cc", "memory");
#elif defined(__thumb__) && defined(__ARMEL__) && LOFT_NUM == LOFT_Q16
    __asm__ volatile(".syntax unified\n"
                     "ldmia %0!, {r0-r5}\n"
                     "adds r0, r0, r2\n adcs r1, r3\n adds r2, r2, r4\n adcs r3, r5\n"
                     "subs %0, #24\n stmia %0!, {r0-r3}\n"
                     "ldr r0, [%0, #8]\n ldr r1, [%0, #12]\n"
                     "adds r4, r4, r0\n adcs r5, r1\n stmia %0!, {r4, r5}\n"
                     : "+l"(d)
                     :
                     : "r0", "r1", "r2", "r3", "r4", "r5", "cc", "memory");
#else
    const loft_state d1 = d[1], d2 = d[2];
    d[0] += d1;
#  if defined(__GNUC__)
    /* gcc would add two in one register: the next step would wait for stores of another size */
    __asm__ volatile("" : : : "memory");
#  endif
    d[1] = d1 + d2;
    d[2] = d2 + d[3];
#endif
}

/* True if loft_state_step3 steps this degree. */
static inline bool loft_walk_cubic(unsigned degree)
{
#if defined(__AVR__)
    (void)degree;
    return false;
#else
    return degree == 3;
#endif
}

/* One step of the first `degree` differences. */
static inline loft_real loft_walk_step(loft_walk *w, unsigned degree)
{
    if (loft_walk_cubic(degree))
        loft_state_step3(w->d);
    else
        for (loft_state *d = w->d, *end = d + degree; d != end; d++)
            loft_state_add(d);
    return loft_state_real(w->d);
}

#if defined(__thumb__) && defined(__ARMEL__) && LOFT_NUM == LOFT_Q16

/* text(0) .. text(LOFT_AXES - 1): gcc counts the lines, for the reach of its branches. */
#  define LOFT_EACH_1(text) text(0)
#  define LOFT_EACH_2(text) LOFT_EACH_1(text) text(1)
#  define LOFT_EACH_3(text) LOFT_EACH_2(text) text(2)
#  define LOFT_EACH_4(text) LOFT_EACH_3(text) text(3)
#  define LOFT_EACH_5(text) LOFT_EACH_4(text) text(4)
#  define LOFT_EACH_6(text) LOFT_EACH_5(text) text(5)
#  define LOFT_EACH_(axes)  LOFT_EACH_##axes
#  define LOFT_EACH(axes)   LOFT_EACH_(axes)

#  if defined(__thumb2__)
#    define LOFT_WALK_SAVED "r8", "r12", "lr"
#    define LOFT_WALK_BEGIN ""
#    define LOFT_WALK_END   ""
#    define LOFT_WALK_AXIS(i)                                                                      \
        "ldmia r0, {r2-r6, r8}\n ldrd r12, lr, [r0, #24]\n"                                        \
        "adds r2, r4\n adcs r3, r5\n adds r4, r6\n adcs r5, r8\n adds r6, r12\n adc r8, lr\n"      \
        "str r3, [r1, #4 * " #i "]\n stmia r0, {r2-r6, r8}\n adds r0, #48\n"
#  else
#    define LOFT_WALK_SAVED "r12", "lr"
#    define LOFT_WALK_BEGIN ".syntax unified\n mov r12, r7\n mov lr, r1\n"
#    define LOFT_WALK_END   "mov r7, r12\n"
#    define LOFT_WALK_AXIS(i)                                                                      \
        ".if " #i "\n adds r0, #24\n .endif\n ldmia r0!, {r1-r7}\n"                                \
        "adds r1, r1, r3\n adcs r2, r4\n adds r3, r3, r5\n adcs r4, r6\n"                          \
        "adds r5, r5, r7\n ldr r7, [r0]\n adcs r6, r7\n subs r0, #28\n stmia r0!, {r1-r6}\n"       \
        "mov r7, lr\n str r2, [r7, #4 * " #i "]\n"
#  endif

/* One step of the cubics w[0..LOFT_AXES-1], with their values to out[]. What a function may change,
 * and a few registers more, is enough: gcc saves all. r7 may be the frame pointer. */
static inline void loft_walk_step_axes(loft_walk w[], loft_real out[])
{
    register loft_state *d __asm__("r0") = w->d;
    register loft_real *at __asm__("r1") = out;

    __asm__ volatile(LOFT_WALK_BEGIN LOFT_EACH(LOFT_AXES)(LOFT_WALK_AXIS) LOFT_WALK_END
                     : "+r"(d), "+r"(at)
                     :
                     : "r2", "r3", "r4", "r5", "r6", LOFT_WALK_SAVED, "cc", "memory");
}

#else

static inline void loft_walk_step_axes(loft_walk w[], loft_real out[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = loft_walk_step(&w[i], 3);
}

#endif

/* One step of all axes, if any is left and the walk is a cubic: 1; 0 if none is left, -1 if it is
 * no cubic. The last step gives the last control values. */
static inline int8_t loft_walk_next3(loft_walks *w, loft_real out[])
{
#if defined(__AVR__)
    return w->degree == 3 ? loft_avr_next3(w, out) : -1;
#else
#  if defined(__thumb__) && !defined(__thumb2__) && defined(__ARMEL__)
    __asm__ goto(".syntax unified\n ldrb r3, [%0, #4]\n cmp r3, #3\n bne %l2\n"
                 "ldr r3, [%0]\n subs r3, #1\n bcc %l1\n str r3, [%0]\n"
                 :
                 : "l"(w)
                 : "r3", "cc", "memory"
                 : none, other);
#  else
    if (w->degree != 3)
        goto other;
    if (w->left == 0)
        goto none;
    w->left--;
#  endif
    loft_walk_step_axes(w->axis, out);
    for (int i = 0; i < LOFT_AXES && w->left == 0; i++)
        out[i] = loft_walk_end(&w->axis[i], out[i]);
    return 1;
none:
    return 0;
other:
    return -1;
#endif
}

/* One step of a cubic; the last step returns the last control value. */
static inline loft_real loft_walk3_step(loft_walk3 *w, bool last)
{
    loft_state_step3(w->d);
    return last ? loft_walk3_end(w, loft_state_real(w->d)) : loft_state_real(w->d);
}

/* True if n >= 1 steps are within the law of ranges (walk_start.c). */
bool loft_walk_steps_valid(unsigned degree, uint32_t n);

/* The powers of 1 / n that all axes share.
 *
 *   range   a valid n
 *   cost    q16: for n < 65536 degree * 6 32-bit divisions; AVR: 810 cycles per degree
 */
void loft_powers_init(loft_powers *powers, unsigned degree, uint32_t n);
void loft_powers3_init(loft_powers3 *powers, uint16_t n);

/* g[k] = C(degree, k) times the k-th difference of p[0..degree]: the polynomial is sum_k g[k] t^k.
 * In q16 they are integers in units of the LSB, |g| < 2^38. */
void loft_walk_powers(loft_acc g[], const loft_real p[], unsigned degree);

/* Start at p[0] of the Bezier polynomial p[0..degree], with n steps to go. Differences above the
 * degree are 0.
 *
 *   range   f32, f64: |p| <= LOFT_REAL_MAX / 65536
 *   error   q16: 2^-33 + 2^-50 LSB in each difference; none where n^degree divides 2^32
 *   cost    q16: degree * 6 32-bit products and degree * (degree + 5) / 2 products of small numbers
 */
void loft_walk_init(loft_walk *w, const loft_real p[], unsigned degree, const loft_powers *powers);

/* The same for a cubic, with the same values bit for bit.
 *
 *   cost    AVR: 2,400 cycles */
void loft_walk3_init(loft_walk3 *w, const loft_real p[4], const loft_powers3 *powers);

/* `count` steps; the values go to out[0], out[stride] .. */
void loft_walk_run(loft_walk *w, unsigned degree, loft_real out[], size_t stride, uint32_t count);

#if defined(__has_builtin) && LOFT_NUM == LOFT_Q16
#  if __has_builtin(__builtin_shufflevector) &&                                                    \
    (defined(__SSE2__) || (defined(__ARM_NEON) && defined(__AARCH64EL__)))
#    define LOFT_WALK_TWO
#  endif
#endif
#if defined(LOFT_WALK_TWO)

/* The same for the cubics w[0] and w[1], whose values go to out[0] and out[1], out[stride] and so
 * on, where they are faster together: if not, it returns false and does nothing. */
bool loft_walk_run2(loft_walk w[2], unsigned degree, loft_real out[], size_t stride,
                    uint32_t count);

#else

static inline bool loft_walk_run2(loft_walk w[2], unsigned degree, loft_real out[], size_t stride,
                                  uint32_t count)
{
    (void)w;
    (void)degree;
    (void)out;
    (void)stride;
    (void)count;
    return false;
}

#endif

/* Turn a[k], the coefficient of t^k for steps of 1, into the k-th difference at 0, for k =
 * 1..degree, in place. */
void loft_walk_differences(loft_state a[], unsigned degree);

#if LOFT_NUM == LOFT_Q16

/* x / n in place, truncated to an integer: 32-bit limbs, lowest first. */
void loft_limbs_divide(uint32_t x[], int limbs, uint32_t n);

#endif

/* The smallest number of steps over all of p[0..degree] for which loft_walk_halve is proven
 * exact. */
uint32_t loft_walk_coarsest(const loft_real p[], unsigned degree);

/* Halve and double the step, at the same point; exact in q16 under the conditions in forward.h. */
void loft_walk_halve(loft_walk *w, unsigned degree);
void loft_walk_double(loft_walk *w, unsigned degree);

/* True if every control value is within the range of a walk. */
bool loft_walk_valid(const loft_real p[], unsigned degree);

LOFT_END_C

#endif

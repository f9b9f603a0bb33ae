/* tests/target/states.h -- random states of walks: their faster steps against the sums that walk.h
 * says
 * SPDX-License-Identifier: MIT
 */
#ifndef TARGET_STATES_H
#define TARGET_STATES_H

#include "num/walk.h"

static uint32_t random_state;

static inline uint32_t any(void)
{
    return (random_state = random_state * 1664525u + 1013904223u) >> 8;
}

static inline uint64_t any_state(void)
{
    const uint64_t high = any(), middle = any();

    return high << 48 ^ middle << 24 ^ any();
}

/* Apart, as in loft_forward_next: its branches reach 256 bytes on a Cortex-M0. */
__attribute__((noinline)) static int8_t next3(loft_walks *w, loft_real out[])
{
    return loft_walk_next3(w, out);
}

/* One step of all axes at once, on random states: the number of wrong sums and counts. */
static inline uint32_t wrong_axes(void)
{
    static loft_walks w;
    static loft_walk sum[LOFT_AXES];
    loft_real out[LOFT_AXES];
    const uint32_t left = any() % 4 << any() % 26;
    uint32_t wrong = 0;

    w.left = left;
    w.degree = any() % 8 ? 3 : 2;
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k <= LOFT_WALK_DEGREE_MAX; k++)
            w.axis[i].d[k] = sum[i].d[k] = any_state();
    const int8_t given = next3(&w, out);
    wrong += given != (w.degree != 3 ? -1 : left > 0) || w.left != left - (given == 1);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (int k = 0; k < 3 && given == 1; k++)
            sum[i].d[k] += sum[i].d[k + 1];
        for (int k = 0; k <= LOFT_WALK_DEGREE_MAX; k++)
            wrong += w.axis[i].d[k] != sum[i].d[k];
        wrong += given == 1 && out[i] != loft_state_real(&sum[i].d[0]);
    }
    return wrong;
}

/* A run on a random state: the number of wrong sums and values. */
static inline uint32_t wrong_run(void)
{
    static loft_walk w, sum;
    static loft_real out[2 * 5];
    const uint32_t count = 1 + any() % 5, stride = 1 + any() % 2;
    uint32_t wrong = 0;

    for (int k = 0; k <= LOFT_WALK_DEGREE_MAX; k++)
        w.d[k] = sum.d[k] = k <= 3 ? any_state() : 0;
    loft_walk_run(&w, 3, out, stride, count);
    for (uint32_t n = 0; n < count; n++) {
        for (int k = 0; k < 3; k++)
            sum.d[k] += sum.d[k + 1];
        wrong += out[n * stride] != loft_state_real(&sum.d[0]);
    }
    for (int k = 0; k <= LOFT_WALK_DEGREE_MAX; k++)
        wrong += w.d[k] != sum.d[k];
    return wrong;
}

/* Random states: is a step of three differences what walk.h says? The number of wrong sums. */
static inline uint32_t wrong_steps(uint32_t states)
{
    uint32_t wrong = 0;

    for (uint32_t n = 0; n < states; n++) {
        loft_state d[4], sum[4];
        for (int k = 0; k < 4; k++)
            d[k] = sum[k] = any_state();
        loft_state_step3(d);
        for (int k = 0; k < 3; k++)
            sum[k] += sum[k + 1];
        for (int k = 0; k < 4; k++)
            wrong += d[k] != sum[k];
        wrong += wrong_axes();
        wrong += wrong_run();
    }
    return wrong;
}

#endif

/* ports/cortex-m/words.h -- slots as words of a stream
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CORTEX_WORDS_H
#define LOFT_CORTEX_WORDS_H

#include "cortex-m/stream.h"        /* stream_dir */
#include "machine/step.h"           /* loft_step_give */

#define WORDS_MOST 255              /* of loft_step_take */

#if defined(__thumb__)
/* One slot whose pulses are carries (lib/machine/step.c). The word is doubled three times, so it
 * begins as an eighth of the directions. */
#  define WORDS_SLOT                                                                               \
      "mov %[b], %[dir]\n"                                                                         \
      "adds %[p2], %[p2], %[r2]\n adcs %[b], %[b]\n"                                               \
      "adds %[p1], %[p1], %[r1]\n adcs %[b], %[b]\n"                                               \
      "adds %[p0], %[p0], %[r0]\n adcs %[b], %[b]\n"                                               \
      "stmia %[word]!, {%[b]}\n"

/* That whose step is in this bit. */
static inline loft_step_axis *axis_of(loft_step_axis axis[LOFT_AXES], int bit)
{
    return &axis[STREAM_STEP(0) == 0 ? bit : 2 - bit];
}

/* 8.5 instructions a slot, where the compiler needs 20 (M4) and 29 (M0). */
static inline void give_carries(loft_step_axis axis[LOFT_AXES], uint32_t *word, uint8_t count,
                                uint32_t rest)
{
    loft_step_axis *const a0 = axis_of(axis, 0), *const a1 = axis_of(axis, 1),
                          *const a2 = axis_of(axis, 2);
    unsigned p0 = a0->phase, p1 = a1->phase, p2 = a2->phase, b;
    const uint32_t *const odd = word + count % 4, *const end = word + count;

    __asm__ volatile(".syntax unified\n b 2f\n"
                     "1:" WORDS_SLOT "2: cmp %[word], %[odd]\n bne 1b\n b 4f\n"
                     "3:" WORDS_SLOT WORDS_SLOT WORDS_SLOT WORDS_SLOT
                     "4: cmp %[word], %[end]\n bne 3b\n"
                     : [p0] "+l"(p0), [p1] "+l"(p1), [p2] "+l"(p2), [word] "+l"(word), [b] "=&l"(b)
                     : [r0] "l"(a0->rate), [r1] "l"(a1->rate), [r2] "l"(a2->rate),
                       [dir] "h"(rest >> 3), [odd] "h"(odd), [end] "h"(end)
                     : "cc", "memory");
    a0->phase = p0;
    a1->phase = p1;
    a2->phase = p2;
}
#endif

/* The words of `count` slots of loft_step_take; `dir`: bit i is axis i. */
static inline void give_words(loft_step_tick *taken, uint32_t *word, uint8_t count, uint8_t dir)
{
    const uint32_t rest = stream_dir(dir);
    uint8_t step[WORDS_MOST];

#if defined(__thumb__)
    if (taken && loft_step_short(taken)) {
        give_carries(taken->axis, word, count, rest);
        return;
    }
#endif
    if (taken)
        loft_step_give(taken, step, count);
    for (uint8_t k = 0; k < count; k++) {
        word[k] = rest;
        for (int i = 0; taken && i < LOFT_AXES; i++)
            word[k] |= (step[k] >> i & 1u) << STREAM_STEP(i);
    }
}

#endif

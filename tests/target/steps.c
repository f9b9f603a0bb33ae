/* tests/target/steps.c -- faster steps of walks and slots against their definitions, on many random
 * states
 * SPDX-License-Identifier: MIT
 *
 * Runs on the ATmega328P by itself (simavr), or with microbit.c and netduino.ld, with -DSWEPT=.
 * Prints `wrong_steps N`, and on a Cortex-M `wrong_words N`: those of cortex-m/words.h against
 * loft_step_next, a slot each.
 */
#include "machine/step.h"

#include "say.h"            /* say_line */
#include "states.h"         /* any, wrong_steps */

int main(void);

#if defined(__AVR__)
#  include <avr/interrupt.h>
#  include <avr/io.h>
#  include <avr/sleep.h>

static void put(char c)
{
    while (!(UCSR0A & (1 << UDRE0))) {
    }
    UDR0 = (uint8_t)c;
}

int main(void)
{
    UBRR0  = 0;
    UCSR0A = 1 << U2X0;
    UCSR0B = 1 << TXEN0;
    random_state = 1;
    say_line(put, "wrong_steps", wrong_steps(SWEPT));
    put('\n');
    cli();
    sleep_enable();
    sleep_cpu();
}
#else
#  define LOFT_SLOTS 1000
#  include "cortex-m/words.h"

void debugger_put(char c);
static void put(char c) { debugger_put(c); }

/* A tick of any length, taken in portions: the wrong words. */
static uint32_t wrong_in_tick(loft_step *s, loft_step *slow, int32_t target[LOFT_AXES],
                              uint32_t *seen)
{
    static uint32_t word[WORDS_MOST];
    const uint16_t slots = (uint16_t)(1 + any() % (any() % 8 ? 1625 : 3000));
    uint32_t wrong = 0;
    uint8_t dir;

    for (int i = 0; i < LOFT_AXES; i++)
        target[i] += (int32_t)(any() % (2u * slots + 1)) - slots;
    wrong += loft_step_load(s, target, slots) != loft_step_load(slow, target, slots);
    while (!loft_step_done(s)) {
        uint8_t count = (uint8_t)(1 + any() % WORDS_MOST);
        loft_step_tick *taken = loft_step_take(s, &count, &dir);
        give_words(taken, word, count, dir);
        *seen += count;
        for (uint8_t k = 0; k < count; k++) {
            const loft_pins pins = loft_step_next(slow);
            wrong += word[k] != (stream_dir(pins.dir) | pins.step);
        }
    }
    return wrong + !loft_step_done(slow);
}

int main(void)
{
    static loft_step s, slow;
    int32_t target[LOFT_AXES] = { 0 };
    uint32_t seen = 0, wrong = 0;

    random_state = 1;
    say_line(put, "wrong_steps", wrong_steps(SWEPT));
    if (loft_step_init(&s, target) != LOFT_OK || loft_step_init(&slow, target) != LOFT_OK)
        return 1;
    while (seen < SWEPT)
        wrong += wrong_in_tick(&s, &slow, target, &seen);
    say_line(put, "wrong_words", wrong);
    return 0;
}
#endif

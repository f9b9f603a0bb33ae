/* tests/target/slots.c -- the slots that the ATmega328P makes in assembly, against Bresenham's line
 * SPDX-License-Identifier: MIT
 *
 * Each tick of up to LOFT_STEP_SHORT slots with two of its numbers of steps, and ticks longer than
 * that; made in portions of any size; each byte of PORTD. Prints `slots N`, `wrong N`, and the
 * cycles that a hundred of them take, `hundred N`. Runs on the ATmega328P (simavr).
 */
#include <avr/sleep.h>

#include "../../ports/atmega328p/slots.h"

#include "say.h"        /* say_line */

int main(void);

static uint32_t random_state, slots_seen, wrong;

static uint16_t below(uint16_t n)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (uint16_t)((random_state >> 16) * n >> 16);
}

static void put(char c)
{
    while (!(UCSR0A & (1 << UDRE0))) {
    }
    UDR0 = (uint8_t)c;
}

/* Bresenham's line as it is usually written: with a remainder. */
static struct line {
    uint16_t count, rest;
} line[LOFT_AXES];

static uint8_t byte_of_slot(uint16_t slots, uint8_t dir)
{
    uint8_t byte = (uint8_t)(dir << 5) | RX_PULL;

    for (int i = 0; i < LOFT_AXES; i++) {
        line[i].rest = (uint16_t)(line[i].rest + line[i].count);
        if (line[i].rest < slots)
            continue;
        line[i].rest = (uint16_t)(line[i].rest - slots);
        byte |= (uint8_t)(4 << i);
    }
    return byte ^ LOFT_INVERT;
}

static void run_tick(loft_step *s, uint16_t slots, int32_t target[LOFT_AXES])
{
    uint8_t *const slot = (uint8_t *)ring;
    uint8_t dir;

    for (int i = 0; i < LOFT_AXES; i++) {
        line[i].count = i ? below((uint16_t)(slots + 1)) : slots;
        line[i].rest = slots / 2u;
        target[i] += below(2) ? line[i].count : -(int32_t)line[i].count;
    }
    loft_step_load(s, target, slots);
    while (!loft_step_done(s)) {
        uint8_t count = (uint8_t)(1 + below(RING - 1));
        loft_step_tick *taken = loft_step_take(s, &count, &dir);
        give_slots(taken, slot, count, dir);
        for (uint8_t k = 0; taken && k < count; k++, slots_seen++)
            wrong += slot[k] != byte_of_slot(slots, dir);
        wrong += !taken && slot[0] != ((uint8_t)(dir << 5 | RX_PULL) ^ LOFT_INVERT);
    }
    int32_t at[LOFT_AXES];
    loft_step_position(s, at);
    for (int i = 0; i < LOFT_AXES; i++)
        wrong += at[i] != target[i];
}

/* Of a hundred slots of all axes, taken and made in two portions. */
static uint16_t cycles_of_a_slot(loft_step *s, int32_t target[LOFT_AXES])
{
    uint8_t *const slot = (uint8_t *)ring;
    uint8_t dir;

    for (int i = 0; i < LOFT_AXES; i++)
        target[i] += 99;
    loft_step_load(s, target, 100);
    TCCR1B = 1;
    const uint16_t begin = TCNT1;
    for (uint8_t made = 0; made < 100;) {
        uint8_t count = 50;
        loft_step_tick *taken = loft_step_take(s, &count, &dir);
        give_slots(taken, slot, count, dir);
        made = (uint8_t)(made + count);
    }
    return (uint16_t)(TCNT1 - begin);
}

int main(void)
{
    static loft_step s;
    int32_t target[LOFT_AXES] = { 0 };

    UBRR0  = 0;
    UCSR0A = 1 << U2X0;
    UCSR0B = 1 << TXEN0;
    wrong = loft_step_init(&s, target) != LOFT_OK;
    for (uint8_t turn = 0; turn < 4; turn++)
        for (uint16_t slots = 1; slots < LOFT_STEP_SHORT + 20; slots++)
            run_tick(&s, slots, target);
    for (uint8_t turn = 0; turn < 10; turn++)
        run_tick(&s, (uint16_t)(LOFT_STEP_SHORT + below(3000)), target);
    say_line(put, "slots", slots_seen);
    say_line(put, "wrong", wrong);
    (void)cycles_of_a_slot(&s, target);
    say_line(put, "hundred", cycles_of_a_slot(&s, target));
    put('\n');
    cli();
    sleep_enable();
    sleep_cpu();
}

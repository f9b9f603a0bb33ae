/* ports/atmega328p/outputs.h -- outputs on the pins of the CNC shield, and a servo in place of a
 * motor
 * SPDX-License-Identifier: MIT
 *
 *     output 1   D11 (PB3), 7.8 kHz, power in 1/256, the rest carried on;
 *                D13 (PB5) is high while it is above 0
 *     output 2   A3 (PC3), high while its level is above 0
 *     servo      D11: settings.wiring names it, and then output 1 has D13 alone
 *
 * Slots wait in the ring for 1.0 to 1.6 ms, and so do the levels of their ticks. Output 1 takes the
 * level of a tick 0.3 ms before its first pins to 0.3 ms behind them. A chip in reset has no
 * outputs: pins float, so a laser and a spindle need a resistor to ground.
 */
#ifndef LOFT_ATMEGA328P_OUTPUTS_H
#define LOFT_ATMEGA328P_OUTPUTS_H

#include <avr/interrupt.h>
#include <avr/io.h>

#include "machine/machine.h"    /* loft_machine */
#include "slots.h"              /* RING_TAIL */

#define LOW     80              /* slots left in the ring when work begins: enough for the longest
                                 * tick, and half as many again */
#define POWER   (1 << 3)        /* of PORTB */
#define ENABLED (1 << 5)        /* of PORTB */
#define COOLANT (1 << 3)        /* of PORTC */

#ifndef LOFT_SERVO
#  define LOFT_SERVO 1          /* settings may make the third axis a servo */
#endif
#if LOFT_MACHINE_OUTPUTS > 2
#  error "LOFT_MACHINE_OUTPUTS must be 0..2: the shield has pins for two outputs"
#endif


// Power and switches
// ------------------

#if LOFT_MACHINE_OUTPUTS > 0

#define FAST_PWM (1 << WGM21 | 1 << WGM20)

static void begin_outputs(void)
{
    TCCR2A = FAST_PWM;
    TCCR2B = 1 << CS21;
    DDRB |= POWER | ENABLED;
    DDRC |= LOFT_MACHINE_OUTPUTS > 1 ? COOLANT : 0;
}

/* On for `counts` of 256. Of a servo only the enable pin is an output of the machine. */
static void set_power(uint16_t counts)
{
    if (counts)
        PORTB |= ENABLED;
    else
        PORTB &= (uint8_t)~ENABLED;
    if (!TIMSK2) {
        OCR2A  = (uint8_t)(counts - 1);
        TCCR2A = counts ? 1 << COM2A1 | FAST_PWM : FAST_PWM;
    }
}

static void set_coolant(bool on)
{
    if (on)
        PORTC |= COOLANT;
    else
        PORTC &= (uint8_t)~COOLANT;
}

/* Levels that wait for their slots, the oldest first. A tick has 80 slots at least, and the ring
 * room for 127: two are enough, and the third is for a level that falls to 0 at once. */
#define WAITING 3
#define NEAR    24              /* slots: half of a portion */

static struct {
    uint16_t level;
    uint8_t  at;                /* the first slot of its tick */
} waiting[WAITING];
static uint8_t waits;

static void give_level(uint16_t level)
{
    static uint8_t rest;        /* what was not given yet, 1/65536 */

    rest = (uint8_t)(rest + level);
    set_power(level == UINT16_MAX ? 256 : (uint16_t)((level >> 8) + (rest < (uint8_t)level)));
}

/* After a portion of slots was put into the ring at `begun`, and the next tick was prepared. A
 * portion begins where fewer than 80 slots are left: what is farther away has been given. */
static void follow_outputs(const loft_drive *d, uint8_t begun)
{
    static uint16_t last;
    static uint8_t tick;
    const uint16_t power = loft_drive_output(d, 1);
    const uint8_t now    = d->outputs.runs;

    set_coolant(loft_drive_output(d, 2) != 0);
    if ((tick != now || power != last) && waits < WAITING) {
        waiting[waits].level = power;
        waiting[waits].at    = begun;
        waits++;
        last = power;
        tick = now;
    }
    while (waits) {
        const uint8_t away = (uint8_t)(waiting[0].at - RING_TAIL) % RING;
        if (away > NEAR && away <= LOW)
            return;
        give_level(waiting[0].level);
        waits--;
        for (uint8_t k = 0; k < waits; k++)
            waiting[k] = waiting[k + 1];
    }
}

/* After a job. */
static void end_outputs(void)
{
    if (!(PORTB & ENABLED || PORTC & COOLANT))
        return;
    cli();
    waits = 0;
    set_power(0);
    set_coolant(false);
    sei();
}

#else

static void begin_outputs(void)                     { TCCR2A = 0; }
static void follow_outputs(const loft_drive *d, uint8_t begun)
{
    (void)d;
    (void)begun;
}
static void end_outputs(void)                       {}

#endif


// A servo
// -------

#if LOFT_SERVO

#define SERVO_US    2           /* of a count */
#define SERVO_FRAME (20000u / SERVO_US)
#define SERVO_LEAST 500
#define SERVO_MOST  2500
#define SERVO_SET   (1 << COM2A1 | 1 << COM2A0)
#define SERVO_CLEAR (1 << COM2A1)

static volatile uint16_t servo_width;           /* counts */

/* The timer itself sets and clears the pin, at matches 128 to 255 counts apart. This interrupt says
 * what the next one does, so it may be 256 us late. */
ISR(TIMER2_COMPA_vect)
{
    static uint16_t left;                       /* from this match to the next edge */
    static uint16_t width;
    static bool low;                            /* it begins with the end of a pulse */

    if (left == 0) {
        low = !low;
        if (!low)
            width = servo_width;
        left = low ? SERVO_FRAME - width : width;
    }
    const uint8_t hop = (uint8_t)(left > 255 ? 128 : left);
    left  = (uint16_t)(left - hop);
    OCR2A = (uint8_t)(OCR2A + hop);
    TCCR2A = low == (left > 0) ? SERVO_CLEAR : SERVO_SET;
}

/* The pulse is that of the place of the third axis, whose steps are us. `zero`: settings.wiring; 0
 * ends the servo. Pulses begin with the first job. Called each ms. */
static void watch_servo(const loft_drive *d, uint8_t zero, bool reversed)
{
    int32_t at[LOFT_AXES];

    if (zero == 0) {
        if (TIMSK2) {
            TIMSK2 = 0;
            begin_outputs();
        }
        return;
    }
    loft_step_position(&d->step, at);
    at[2] = zero * 10 + (reversed ? -at[2] : at[2]);
    const uint16_t us = at[2] < SERVO_LEAST  ? SERVO_LEAST
                        : at[2] > SERVO_MOST ? SERVO_MOST
                                             : (uint16_t)at[2];
    cli();
    servo_width = us / SERVO_US;
    sei();
    if (!TIMSK2 && d->active) {
        TCCR2A = SERVO_CLEAR;
        TCCR2B = 1 << CS21 | 1 << CS20;
        DDRB |= POWER;
        TIMSK2 = 1 << OCIE2A;
    }
}

#else

static void watch_servo(const loft_drive *d, uint8_t zero, bool reversed)
{
    (void)d;
    (void)zero;
    (void)reversed;
}

#endif

#endif

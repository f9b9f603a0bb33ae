/* ports/atmega328p/outputs.h -- outputs on the pins of the CNC shield, and a servo in place of a
 * motor
 * SPDX-License-Identifier: MIT
 *
 *     output 1   D11 (PB3), 7.8 kHz, power in 1/256, the rest carried on;
 *                D13 (PB5) is high while it is above 0
 *     output 2   A3 (PC3), high while its level is above 0
 *     servo      D11: settings.wiring names it, and then output 1 has D13 alone
 *
 * The slots of a tick are made when fewer than LOW slots are left in the ring. Outputs take the
 * levels of that tick then, 0.2 to 0.8 ms before its first pins. A chip in reset has no
 * outputs: pins float, so a laser and a spindle need a resistor to ground.
 */
#ifndef LOFT_ATMEGA328P_OUTPUTS_H
#define LOFT_ATMEGA328P_OUTPUTS_H

#include <avr/interrupt.h>
#include <avr/io.h>

#include "machine/machine.h"    /* loft_machine */
#include "slots.h"              /* RING_TAIL */

/* Slots left in the ring when work begins, 0.8 ms: enough for the longest tick and for its first
 * slots, */
#define LOW     (LOFT_SLOTS > 80 ? LOFT_SLOTS * 4u / 5 : 64u)
#define PORTION 40              /* which are made at once */
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

static void give_level(uint16_t level)
{
    static uint8_t rest;        /* what was not given yet, 1/65536 */

    rest = (uint8_t)(rest + level);
    set_power(level == UINT16_MAX ? 256 : (uint16_t)((level >> 8) + (rest < (uint8_t)level)));
}

/* The running tick has put its first slots into the ring: fewer than LOW are before them. */
static void follow_outputs(const loft_drive *d)
{
    static uint16_t last;
    static uint8_t tick;
    const uint16_t power = loft_drive_output(d, 1);

    set_coolant(loft_drive_output(d, 2) != 0);
    if (tick != d->outputs.runs || power != last)
        give_level(power);
    last = power;
    tick = d->outputs.runs;
}

/* After a job. */
static void end_outputs(void)
{
    if (!(PORTB & ENABLED || PORTC & COOLANT))
        return;
    cli();
    set_power(0);
    set_coolant(false);
    sei();
}

#else

static void begin_outputs(void)                     { TCCR2A = 0; }
static void follow_outputs(const loft_drive *d)     { (void)d; }
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

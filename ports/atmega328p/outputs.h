/* ports/atmega328p/outputs.h -- outputs on the pins of the CNC shield, and a servo in place of a
 * motor
 * SPDX-License-Identifier: MIT
 *
 *     output 1   D11 (PB3), 7.8 kHz, power in 1/256; D13 (PB5) is high while it is above 0
 *     output 2   A3 (PC3), high while its level is above 0
 *     servo      D11: settings.wiring names it, and then output 1 has D13 alone
 *
 * Slots wait in the ring for 1.0 to 1.6 ms. An output therefore takes the level of a tick when the
 * slots of the next one are begun: 0 to 0.6 ms before the pins of its tick. What is switched off
 * while time stands still is off at once. A chip in reset has no outputs: pins float, so a laser
 * and a spindle need a resistor to ground.
 */
#ifndef LOFT_ATMEGA328P_OUTPUTS_H
#define LOFT_ATMEGA328P_OUTPUTS_H

#include <avr/interrupt.h>
#include <avr/io.h>

#include "machine/machine.h"    /* loft_machine */

#define POWER   (1 << 3)        /* of PORTB */
#define ENABLED (1 << 5)        /* of PORTB */
#define COOLANT (1 << 3)        /* of PORTC */

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

/* Of a servo only the enable pin is an output of the machine. */
static void set_power(uint8_t level)
{
    if (level)
        PORTB |= ENABLED;
    else
        PORTB &= (uint8_t)~ENABLED;
    if (!(TIMSK2 & 1 << OCIE2A)) {
        OCR2A  = level;
        TCCR2A = level ? 1 << COM2A1 | FAST_PWM : FAST_PWM;
    }
}

static void set_coolant(bool on)
{
    if (on)
        PORTC |= COOLANT;
    else
        PORTC &= (uint8_t)~COOLANT;
}

/* After a tick was prepared. */
static void follow_outputs(const loft_drive *d)
{
    static uint8_t next, tick;
    const uint8_t power = (uint8_t)(loft_drive_output(d, 1) >> 8), now = (uint8_t)d->ticks;

    if (tick == now && !loft_step_done(&d->step))
        return;
    set_power(loft_step_done(&d->step) ? power : next);
    set_coolant(loft_drive_output(d, 2) != 0);
    next = power;
    tick = now;
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

static void begin_outputs(void)                     {}
static void follow_outputs(const loft_drive *d)     { (void)d; }
static void end_outputs(void)                       {}

#endif

#endif

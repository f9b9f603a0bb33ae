/* tests/target/avr_say.h -- the serial port of an ATmega328P, to which a test prints its lines
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TEST_AVR_SAY_H
#define LOFT_TEST_AVR_SAY_H

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

static void put(char c)
{
    while (!(UCSR0A & (1 << UDRE0))) {
    }
    UDR0 = (uint8_t)c;
}

static void serial_start(void)
{
    UBRR0 = 0;
    UCSR0A = 1 << U2X0;
    UCSR0B = 1 << TXEN0;
}

/* The emulator ends when the core sleeps without interrupts. */
static void stop(void)
{
    put('\n');
    cli();
    sleep_enable();
    sleep_cpu();
}

#endif

/* ports/port.h -- what a board must give to loft. Start from template/port.c.
 * SPDX-License-Identifier: MIT
 *
 * A port is one file that defines these six functions and main; there is one board per firmware, so they are found at
 * link time. Three things happen at their own rates:
 *
 *     the timer interrupt, at the slot rate    pins = loft_machine_slot(&machine); put them out
 *     some 10 us .. 1 ms later                 loft_machine_tick(&machine): computes the next tick
 *     the main loop                            bytes in and out: loft_machine_push, loft_machine_poll
 *
 * loft_machine_tick must be called at least once per tick and may be interrupted by the slot interrupt: call it
 * behind the pins in the timer interrupt with interrupts enabled again (and not twice at a time), in an interrupt of
 * lower priority, or in the main loop if that is quick enough. On a fast part it may simply follow
 * loft_machine_slot. The three need no lock: they meet in single bytes.
 *
 * Where an interrupt per slot that computes is too long, let it take the pins from a ring and fill that with
 * loft_drive_run, many slots at once: atmega328p/port.c does. On an ATmega328P at 16 MHz with three axes (avr-gcc 5.4, simulated)
 * a slot then takes 95 cycles, making the slots of a tick and the next tick 2,900 on average, and all interrupts 0.62 of the time at
 * 40,000 slots per second with every axis pulsing in each of them; preparing a span, in loft_machine_poll, takes 20,000.
 */
#ifndef LOFT_PORT_H
#define LOFT_PORT_H

#include <stddef.h>
#include <stdint.h>

/* Clocks, pins, serial line; interrupts stay off. */
void     loft_port_init(void);

/* Enable interrupts and call loft_port_slot `slot_hz` times per second from now on. */
void     loft_port_start(uint32_t slot_hz);

/* CALLBACK, defined by the application: one slot has begun. */
void     loft_port_slot(void);

/* Put out direction and step bits (bit i = axis i), direction first. The port ends the step pulses, at the latest in
 * the next slot, and knows which pins are inverted. Called from loft_port_slot. */
void     loft_port_pins(uint8_t step_bits, uint8_t dir_bits);

/* Bytes from and to the line, as many as there are or fit now; both give the count and never wait. */
size_t   loft_port_read(uint8_t *bytes, size_t max);
size_t   loft_port_write(const uint8_t *bytes, size_t count);

#endif

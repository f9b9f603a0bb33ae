/* ports/port.h -- what a board must give to loft. Start from template/port.c; PORTING.md walks
 * through it.
 * SPDX-License-Identifier: MIT
 *
 * A port is one file that defines the functions below that are not marked as a callback; there is
 * one board per firmware, so they are found at link time. firmware.c has main and the callbacks.
 * Four things happen at their own rates:
 *
 *     the timer interrupt, at the slot rate    loft_port_slot: the pins
 *     some 10 us .. 1 ms later                 loft_port_tick: computes the next tick
 *     the line's interrupt                     loft_port_byte: keeps a byte that has come
 *     the main loop                            acts on bytes, answers, watches switches
 *
 * loft_port_tick must be called at least once per tick and may be interrupted by the slot
 * interrupt: call it in an interrupt of lower priority, or behind loft_port_slot with interrupts
 * enabled again (and not twice at a time). On a fast part it may simply follow loft_port_slot. They
 * need no lock: they meet in single bytes.
 *
 * Where an interrupt per slot that computes is too long, let it take the pins from a ring and fill
 * that with loft_drive_run, many slots at once: atmega328p/port.c does, with a main of its own. On
 * an ATmega328P at 16 MHz with three axes (avr-gcc 5.4, simulated) a slot then takes 95 cycles,
 * making the slots of a tick and the next tick 2,900 on average, and all interrupts 0.62 of the
 * time at 40,000 slots per second with every axis pulsing in each of them; preparing a span, in
 * loft_machine_poll, takes 20,000.
 */
#ifndef LOFT_PORT_H
#define LOFT_PORT_H

#include "machine/machine.h"    /* loft_machine_config */

/* Clocks, pins, serial line; interrupts stay off. Gives what the machine is and where it stands,
 * with the memory of its queue, to which `machine` keeps. Put another number into info.boot at
 * each start (a counter in flash, a random number): by it the host knows that the machine restarted
 * and lost its position. */
loft_machine_config *loft_port_init(void);

/* Enable interrupts and call loft_port_slot `slot_hz` times per second from now on. */
void     loft_port_start(uint32_t slot_hz);

/* Put out direction and step bits (bit i = axis i), direction first. The port ends the step pulses,
 * at the latest in the next slot, and knows which pins are inverted. Called from loft_port_slot. */
void     loft_port_pins(uint8_t step_bits, uint8_t dir_bits);

/* Bytes to the line, as many as fit now; gives the count and never waits. */
size_t   loft_port_write(const uint8_t *bytes, size_t count);

/* The inputs that are closed now, a sum of LOFT_INPUT_ (wire/message.h); 0 on a board without.
 * switches.h may help. */
uint16_t loft_port_inputs(void);

/* Nothing is to be done before the next interrupt: sleep until then. It may also do nothing. */
void     loft_port_wait(void);

/* CALLBACKS, defined in firmware.c: one slot has begun; time to compute; a byte has come from the
 * line. */
void     loft_port_slot(void);
void     loft_port_tick(void);
void     loft_port_byte(uint8_t byte);

#endif

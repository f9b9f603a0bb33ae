/* ports/port.h -- what loft needs of a board. Start from template/port.c; see PORTING.md.
 * SPDX-License-Identifier: MIT
 *
 * A port is one file that defines the functions below, except the callbacks. There is one board per
 * firmware, so they are found at link time. firmware.c has main and the callbacks. Four contexts
 * run at their own rates:
 *
 *     the timer interrupt, at the slot rate    loft_port_slot: the pins
 *     some 10 us .. 1 ms later                 loft_port_tick: computes the next tick
 *     the line's interrupt                     loft_port_byte: stores a received byte
 *     the main loop                            acts on bytes, answers, watches switches
 *
 * loft_port_tick must be called at least once per tick, and the slot interrupt may interrupt it.
 * Call it in an interrupt of lower priority, or after loft_port_slot with interrupts enabled again,
 * but never nested in itself. On a fast part it may simply follow loft_port_slot. No lock is
 * needed, because the contexts share single bytes.
 *
 * If an interrupt that computes in every slot is too long, let it take the pins from a ring, and
 * fill the ring with loft_drive_take, many slots at once. atmega328p/port.c does so, with a main of
 * its own; cortex-m/stream.h where DMA gives the slots without any interrupt. On an ATmega328P at
 * 16 MHz with three axes (avr-gcc 5.4, simulated) a slot then takes 61 cycles, 32 of them the
 * pulse, and making it 25. All interrupts take 0.62 of the time at 80,000 slots per second with
 * every axis pulsing in each of them. Preparing a span, in loft_machine_poll, takes 20,000.
 */
#ifndef LOFT_PORT_H
#define LOFT_PORT_H

#include "machine/machine.h"    /* loft_machine_config */

/* Set up clocks, pins and the serial line; interrupts stay off. Returns the machine's data and
 * position, with the memory of its queue, which `machine` uses. Put a different number into
 * info.boot at each start (a counter in flash, a random number). By it the host knows that the
 * machine restarted and lost its position. */
loft_machine_config *loft_port_init(void);

/* Enable interrupts and call loft_port_slot `slot_hz` times per second from now on. */
void     loft_port_start(uint32_t slot_hz);

/* Set direction and step bits (bit i = axis i), direction first. The port ends the step pulses, at
 * the latest in the next slot, and knows which pins are inverted. Called from loft_port_slot. */
void     loft_port_pins(uint8_t step_bits, uint8_t dir_bits);

/* Send as many bytes as fit now. Returns their number and never waits. If none fits, an interrupt
 * comes soon: when there is room, or with the next slot. */
size_t   loft_port_write(const uint8_t *bytes, size_t count);

/* Set output number `output`, 1 .. info.outputs, to `level`; 65535 is full. Called from
 * loft_port_tick when the level changes, at the beginning of a tick; a board whose info.outputs is
 * 0 does nothing. Outputs are off when loft_port_init returns. */
void     loft_port_output(int output, uint16_t level);

/* The inputs that are closed now, a sum of LOFT_INPUT_ (wire/message.h); 0 on a board without
 * inputs. switches.h may help. Called from the main loop and, while a guard waits, in each slot. */
uint16_t loft_port_inputs(void);

/* Nothing has to be done before the next interrupt: sleep until then, or do nothing. */
void     loft_port_wait(void);

/* CALLBACKS, defined in firmware.c: a slot begins; there is time to compute; a byte was
 * received. */
void     loft_port_slot(void);
void     loft_port_tick(void);
void     loft_port_byte(uint8_t byte);

/* CALLBACKS for a port that makes slots ahead, in the context of loft_port_tick: take the next
 * slots (loft_drive_take); does a guard wait; has an input of it changed now, which may be asked in
 * any interrupt; it had changed when so many steps were counted and not given. */
loft_step_tick *loft_port_take(uint8_t *count, uint8_t *dir);
bool     loft_port_waits(void);
bool     loft_port_changed(void);
void     loft_port_latch(const int32_t ahead[LOFT_AXES]);

#endif

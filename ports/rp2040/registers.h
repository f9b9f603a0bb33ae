/* ports/rp2040/registers.h -- where an RP2040 and an RP2350 have their registers, and what differs
 * SPDX-License-Identifier: MIT
 *
 * Parts of the same name have the same registers. RP2040 datasheet, RP2350 datasheet: 2.2 (address
 * map), 7.5 (resets), 8.3 (ring oscillator), 3.1.11 (SIO), 9.11 (pads).
 */
#ifndef LOFT_RP2040_REGISTERS_H
#define LOFT_RP2040_REGISTERS_H

#ifdef RP2350
#  define CORE       150000000u     /* Hz, from a crystal of 12 MHz: * 125 / 5 / 2 */
#  define PLL_AFTER  5u
#  define CLOCKS     0x40010000
#  define RESETS     0x40020000
#  define PINS       0x40028000     /* IO_BANK0 */
#  define PADS       0x40038000
#  define XOSC       0x40048000
#  define PLL        0x40050000
#  define UART       0x40070000
#  define RANDOM     0x400E8020     /* ROSC */
#  define SIO_DRIVES 0xD0000030     /* GPIO_OE */
#  define PARTS      (1u << 2 | 1u << 6 | 1u << 9 | 1u << 11 | 1u << 14 | 1u << 26)
#else
#  define CORE       125000000u     /* Hz, from a crystal of 12 MHz: * 125 / 6 / 2 */
#  define PLL_AFTER  6u
#  define CLOCKS     0x40008000
#  define RESETS     0x4000C000
#  define PINS       0x40014000
#  define PADS       0x4001C000
#  define XOSC       0x40024000
#  define PLL        0x40028000
#  define UART       0x40034000
#  define RANDOM     0x4006001C
#  define SIO_DRIVES 0xD0000020
#  define PARTS      (1u << 2 | 1u << 5 | 1u << 8 | 1u << 10 | 1u << 12 | 1u << 22)
#endif
#define DMA        0x50000000       /* channel 0 */
#define PIO        0x50200000
#define SM         (PIO + 0xC8)     /* state machine 0 */
#define SIO_INPUTS 0xD0000004

#endif

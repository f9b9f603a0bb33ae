/* tests/target/meter.h -- what code costs on an emulated chip: instructions of a Cortex-M, cycles of an AVR
 * SPDX-License-Identifier: MIT
 *
 * qemu-system-arm -M netduinoplus2 -icount shift=0: TIM2 counts nanoseconds, each instruction takes one. That machine runs code for a
 * Cortex-M0 as well. AVR: timer 1 counts every 64th cycle; what is measured is shorter than 2^22 cycles.
 */
#ifndef LOFT_TESTS_METER_H
#define LOFT_TESTS_METER_H

#include <stdint.h>

#if defined(__AVR__)
#include <avr/io.h>

static inline void     meter_start(void) { TCCR1B = 3; }
static inline uint32_t meter_now(void)   { return (uint32_t)TCNT1 << 6; }
static inline uint32_t meter_since(uint32_t start) { return (meter_now() - start) & 0x3fffffu; }
#else
#define METER_TIM2(offset) (*(volatile uint32_t *)(0x40000000u + (offset)))

static inline void meter_start(void)
{
    METER_TIM2(0x28) = 0;               /* PSC */
    METER_TIM2(0x2c) = 0xffffffffu;     /* ARR */
    METER_TIM2(0x14) = 1;               /* EGR */
    METER_TIM2(0x00) = 1;               /* CR1 */
}

static inline uint32_t meter_now(void) { return METER_TIM2(0x24); }
static inline uint32_t meter_since(uint32_t start) { return meter_now() - start; }
#endif

#endif

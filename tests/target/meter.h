/* tests/target/meter.h -- counts instructions on an emulated Cortex-M
 * SPDX-License-Identifier: MIT
 *
 * qemu-system-arm -M netduinoplus2 -icount shift=0: TIM2 counts nanoseconds, and each instruction
 * takes one. That machine also runs code for a Cortex-M0.
 */
#ifndef LOFT_TESTS_METER_H
#define LOFT_TESTS_METER_H

#include <stdint.h>

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

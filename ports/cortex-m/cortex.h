/* ports/cortex-m/cortex.h -- what all Cortex-M cores have: registers, SysTick, interrupts, sleep
 * SPDX-License-Identifier: MIT
 *
 * A port is compiled with the number of interrupts, CORTEX_IRQS, and that of its line,
 * CORTEX_LINE_IRQ: cortex_line is called when a byte has come. Slots come from SysTick; where
 * CORTEX_SLOT_IRQ is given, from that, by cortex_slot. loft_port_tick runs in the interrupt of
 * lowest priority, when cortex_later has asked for it.
 */
#ifndef LOFT_CORTEX_H
#define LOFT_CORTEX_H

#include <stdint.h>

#define REG(address) (*(volatile uint32_t *)(uintptr_t)(address))

#define SYST_CSR    REG(0xE000E010)
#define SYST_RVR    REG(0xE000E014)
#define SYST_CVR    REG(0xE000E018)
#define NVIC_ISER   (&REG(0xE000E100))
#define NVIC_IPR    (&REG(0xE000E400))
#define SCB_ICSR    REG(0xE000ED04)
#define SCB_SHPR3   REG(0xE000ED20)

void cortex_line(void);
void cortex_slot(void);

/* Let interrupt `irq` come, before the tick and after the slots; with `first` at the same time as
 * slots. */
static inline void cortex_enable(unsigned irq, int first)
{
    const unsigned shift = irq % 4 * 8;

    NVIC_IPR[irq / 4] = (NVIC_IPR[irq / 4] & ~(0xFFu << shift)) | (first ? 0u : 0x80u) << shift;
    NVIC_ISER[irq / 32] = 1u << irq % 32;
}

/* Slots first, the tick (PendSV) last. */
static inline void cortex_priorities(void)      { SCB_SHPR3 = 0x00C00000; }

/* Call cortex_slot each `cycles` of the core's clock, at most 2^24, from now on. */
static inline void cortex_systick(uint32_t cycles)
{
    SYST_RVR = cycles - 1;
    SYST_CVR = 0;
    SYST_CSR = 7;
}

static inline void cortex_later(void)           { SCB_ICSR = 1u << 28; }
static inline void cortex_interrupts(void)      { __asm__ volatile ("cpsie i" ::: "memory"); }
static inline void cortex_wait(void)            { __asm__ volatile ("wfi" ::: "memory"); }

/* At least so many cycles. */
static inline void cortex_delay(uint32_t cycles)
{
    for (cycles /= 3; cycles; cycles--)
        __asm__ volatile ("");
}

/* A number that a reset changes, and whatever memory holds when power comes. */
uint32_t cortex_starts(void);

#endif

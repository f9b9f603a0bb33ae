/* ports/cortex-m/cortex.h -- common parts of Cortex-M cores: registers, SysTick, interrupts, sleep
 * SPDX-License-Identifier: MIT
 *
 * A port is compiled with the number of interrupts, CORTEX_IRQS, and the number of its line's
 * interrupt, CORTEX_LINE_IRQ. cortex_line is called when a byte is received. SysTick gives the
 * slots. loft_port_tick runs in the interrupt of lowest priority, after cortex_later. With
 * CORTEX_STREAM_IRQ slots are made ahead: see stream.h.
 */
#ifndef LOFT_CORTEX_H
#define LOFT_CORTEX_H

#include <stdbool.h>
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
void cortex_block(void);
void cortex_fill(void);
void cortex_sample(void);
void cortex_sampler(void);

/* Enable interrupt `irq` at a priority above the tick and below the slots; with `first` at that of
 * the slots. */
static inline void cortex_enable(unsigned irq, int first)
{
    const unsigned shift = irq % 4 * 8;

    NVIC_IPR[irq / 4] = (NVIC_IPR[irq / 4] & ~(0xFFu << shift)) | (first ? 0u : 0x80u) << shift;
    NVIC_ISER[irq / 32] = 1u << irq % 32;
}

/* Slots have the highest priority, the tick (PendSV) the lowest. Where an interrupt of its own
 * gives the slots, SysTick is below it. */
#ifdef STREAM_BY_CORE
static inline void cortex_priorities(void)      { SCB_SHPR3 = 0x80C00000; }
#else
static inline void cortex_priorities(void)      { SCB_SHPR3 = 0x00C00000; }
#endif

/* Call cortex_slot every `cycles` of the core clock, at most 2^24, from now on. */
static inline void cortex_systick(uint32_t cycles)
{
    SYST_RVR = cycles - 1;
    SYST_CVR = 0;
    SYST_CSR = 7;
}

/* Let it stand, or run again. */
static inline void cortex_systick_run(bool run) { SYST_CSR = run ? 7 : 6; }

static inline void cortex_later(void)           { SCB_ICSR = 1u << 28; }
static inline void cortex_interrupts(void)      { __asm__ volatile ("cpsie i" ::: "memory"); }
static inline void cortex_wait(void)            { __asm__ volatile ("wfi" ::: "memory"); }

/* Wait at least so many cycles. */
static inline void cortex_delay(uint32_t cycles)
{
    for (cycles /= 3; cycles; cycles--)
        __asm__ volatile ("");
}

/* A number that changes at a reset, and depends on the contents of memory at power-up. */
uint32_t cortex_starts(void);

#endif

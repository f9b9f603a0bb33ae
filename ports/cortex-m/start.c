/* ports/cortex-m/start.c -- from reset to main: vector table, memory, floating point
 * SPDX-License-Identifier: MIT
 */
#include "cortex.h"
#include "port.h"

extern uint32_t data_from[], data_begin[], data_end[], bss_begin[], bss_end[], stack_top[];

int  main(void);
void reset(void);

static uint32_t starts __attribute__((section(".noinit")));

uint32_t cortex_starts(void) { return ++starts; }

void reset(void)
{
    const uint32_t *from = data_from;

    for (uint32_t *p = data_begin; p < data_end; p++)
        *p = *from++;
    for (uint32_t *p = bss_begin; p < bss_end; p++)
        *p = 0;
#ifdef __ARM_FP
    REG(0xE000ED88) |= 0xFu << 20;      /* CPACR: the floating-point unit is on */
    __asm__ volatile ("dsb\n isb" ::: "memory");
#endif
    cortex_priorities();
    (void)main();
    for (;;)
        cortex_wait();
}

/* Stop: no slot comes, so no step is made. */
static void fault(void)
{
    for (;;) {
    }
}

#if defined(CORTEX_STREAM_IRQ)
#  define systick cortex_sample
#  define later   cortex_fill
#  ifdef STREAM_BY_CORE
#    define stream cortex_slot
#  else
#    define stream cortex_block
#  endif
#else
#  define later   loft_port_tick
static void systick(void)
{
    loft_port_slot();
    cortex_later();
}
#endif

void loft_port_wait(void) { cortex_wait(); }

typedef union {
    void (*code)(void);
    const void *data;
} vector;

__attribute__((section(".vectors"), used)) static const vector vectors[16 + CORTEX_IRQS] = {
    { .data = stack_top },
    { .code = reset },
    { .code = fault },
    { .code = fault },
    { .code = fault },
    { .code = fault },
    { .code = fault },
    [11] = { .code = fault },
    [12] = { .code = fault },
    [14] = { .code = later },
    [15] = { .code = systick },
    [16 + CORTEX_LINE_IRQ] = { .code = cortex_line },
#ifdef CORTEX_STREAM_IRQ
    [16 + CORTEX_STREAM_IRQ] = { .code = stream },
#endif
#ifdef CORTEX_SAMPLE_IRQ
    [16 + CORTEX_SAMPLE_IRQ] = { .code = cortex_sampler },
#endif
};

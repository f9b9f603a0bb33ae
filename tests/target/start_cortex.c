/* tests/target/start_cortex.c -- runs main after a reset of a Cortex-M, for a program that ends;
 * its exit code goes to the debugger
 * SPDX-License-Identifier: MIT
 */
#include <stdint.h>

#include "alarm.h"              /* alarm_interrupt */
#include "semihost.h"           /* semihost_exit   */

extern uint32_t data_from[], data_begin[], data_end[], bss_begin[], bss_end[], stack_top[];

int  main(void);
void reset(void);

void reset(void)
{
    const uint32_t *from = data_from;

    for (uint32_t *p = data_begin; p < data_end; p++)
        *p = *from++;
    for (uint32_t *p = bss_begin; p < bss_end; p++)
        *p = 0;
#ifndef __ARM_ARCH_6M__
    *(volatile uint32_t *)0xE000ED88 |= 0xFu << 20;     /* CPACR: enables a floating-point unit; the
                                                         * library may move integers through it */
    __asm__ volatile ("dsb\n isb" ::: "memory");
#endif
    semihost_exit((uint32_t)main());
}

static void fault(void)
{
    semihost_write("fault\n");
    semihost_exit(70);
}

typedef union {
    void (*code)(void);
    const void *data;
} vector;

__attribute__((section(".vectors"), used)) static const vector vectors[16] = {
    { .data = stack_top }, { .code = reset }, { .code = fault }, { .code = fault },
    { .code = fault },     { .code = fault }, { .code = fault }, [15] = { .code = alarm_interrupt }
};

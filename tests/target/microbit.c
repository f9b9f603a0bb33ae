/* tests/target/microbit.c -- what a program needs to run on a Cortex-M0 in QEMU (-M microbit) without a library
 * SPDX-License-Identifier: MIT
 *
 * The vector table, a start that clears memory, and output through the debugger: semihosting, which QEMU answers.
 */
#include <stddef.h>
#include <stdint.h>

void debugger_put(char c);
int  main(void);
void reset(void);
void *memcpy(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);

extern uint32_t bss_begin[], bss_end[], stack_top[];

static uint32_t semihost(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;

    __asm__ volatile ("bkpt 0xab" : "+r" (r0) : "r" (r1) : "memory");
    return r0;
}

/* SYS_WRITEC */
void debugger_put(char c) { semihost(3, &c); }

static void leave(uint32_t code)
{
    const uint32_t reason[2] = { 0x20026, code };   /* SYS_EXIT_EXTENDED, ADP_Stopped_ApplicationExit */

    for (;;)
        semihost(0x20, reason);
}

static void fault(void) { leave(70); }

void reset(void)
{
    for (uint32_t *p = bss_begin; p < bss_end; p++)
        *p = 0;
    leave((uint32_t)main());
}

typedef union {
    void (*code)(void);
    const void *data;
} vector;

__attribute__((section(".vectors"), used))
static const vector vectors[4] = { { .data = stack_top }, { .code = reset }, { .code = fault }, { .code = fault } };

/* What the compiler asks for. */
void *memcpy(void *to, const void *from, size_t count)
{
    for (volatile uint8_t *t = to; count; count--, from = (const uint8_t *)from + 1)
        *t++ = *(const uint8_t *)from;
    return to;
}

void *memset(void *to, int value, size_t count)
{
    for (volatile uint8_t *t = to; count; count--)
        *t++ = (uint8_t)value;
    return to;
}

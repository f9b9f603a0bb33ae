/* tests/target/microbit.c -- runs a program without a library on a Cortex-M0 in QEMU (-M microbit)
 * SPDX-License-Identifier: MIT
 *
 * It has the vector table, a start that clears memory, and output through the debugger
 * (semihost.S).
 */
#include <stddef.h>
#include <stdint.h>

#include "semihost.h"           /* semihost, semihost_exit */

void debugger_put(char c);
int  main(void);
void reset(void);
void *memcpy(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);

extern uint32_t bss_begin[], bss_end[], stack_top[];

/* SYS_WRITEC */
void debugger_put(char c) { semihost(3, &c); }

static void fault(void) { semihost_exit(70); }

void reset(void)
{
    for (uint32_t *p = bss_begin; p < bss_end; p++)
        *p = 0;
    semihost_exit((uint32_t)main());
}

typedef union {
    void (*code)(void);
    const void *data;
} vector;

__attribute__((section(".vectors"), used)) static const vector vectors[4] = {
    { .data = stack_top }, { .code = reset }, { .code = fault }, { .code = fault }
};

/* Functions that the compiler may call. */
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

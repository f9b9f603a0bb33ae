/* tests/target/units.c -- runs tests of tests/ on a chip: each in turn, with its stack
 * SPDX-License-Identifier: MIT
 *
 * A test's main is compiled under the name that the generated `units` calls. Prints a line `== NAME
 * CODE STACK` after each test.
 */
#include "units.h"

#include <stdint.h>
#include <stdio.h>

#include "semihost.h"           /* semihost_exit */

#define PAINT   0x5a17ed00u
#define BESIDE  64              /* words between the deepest call here and the paint */

extern uint32_t bss_end[];
int  main(void);

__attribute__((noinline)) static volatile uint32_t *here(void)
{
    return (volatile uint32_t *)__builtin_frame_address(0);
}

static int with_stack(int (*run)(void), unsigned *bytes)
{
    volatile uint32_t *const top = here() - BESIDE, *p;

    for (p = bss_end; p < top; p++)
        *p = PAINT;
    const int code = run();
    for (p = bss_end; p < top && *p == PAINT; p++) {
    }
    *bytes = (unsigned)((uintptr_t)here() - (uintptr_t)p);
    return code;
}

int main(void)
{
    int bad = 0;

    for (const struct unit *u = units; u->name; u++) {
        unsigned stack;
        const int code = with_stack(u->run, &stack);
        printf("== %s %d %u\n", u->name, code, stack);
        bad |= code;
    }
    semihost_exit((uint32_t)bad);
    return bad;
}

/* tests/target/semihost.h -- talks to the debugger of a chip, which QEMU can be: text, an exit code
 * SPDX-License-Identifier: MIT
 *
 * qemu-system-.. -semihosting-config enable=on,target=native: text goes to QEMU's standard error,
 * the exit code is QEMU's.
 */
#ifndef LOFT_TARGET_SEMIHOST_H
#define LOFT_TARGET_SEMIHOST_H

#include <stddef.h>
#include <stdint.h>

/* One of the operations of ARM's semihosting. */
uint32_t semihost(uint32_t operation, const void *argument);

/* SYS_WRITE0: text up to its 0 */
static inline void semihost_write(const char *text)     { semihost(4, text); }

/* SYS_EXIT_EXTENDED with ADP_Stopped_ApplicationExit */
static inline void semihost_exit(uint32_t code)
{
    const uint32_t reason[2] = { 0x20026, code };

    for (;;)
        semihost(0x20, reason);
}

#endif

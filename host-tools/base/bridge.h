/* host-tools/base/bridge.h -- for rooms that do not take a host yet: that of the program
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_BRIDGE_H
#define LOFT_BRIDGE_H

#include "base/host.h"
#include "base/memory.h"

/* The host of the program, which it gives before all else. */
void  tool_use(host *h);
host *tool_host(void);

/* Tell it a message and return `code`. With EX_OK it is a warning: --strict, which all commands
 * take, ends the program with EX_DATAERR then. */
int tool_error(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* memory_grow, as it was called. */
static inline void *tool_grow(void *old, size_t bytes) { return memory_grow(old, bytes); }

#endif

/* ports/host/memory.h -- the memory that keeps settings without power: a file
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_MEMORY_H
#define LOFT_HOST_MEMORY_H

#include <stdint.h>

#include "config.h"     /* LOFT_NAME */

#define host_memory_open    LOFT_NAME(host_memory_open)
#define host_memory_close   LOFT_NAME(host_memory_close)
#define host_memory_get     LOFT_NAME(host_memory_get)
#define host_memory_put     LOFT_NAME(host_memory_put)

#define HOST_MEMORY_ROOM 2000       /* bytes of each of two copies */

/* Read the file, or make it. NULL: the memory lasts as long as the program. Returns 0 or an exit
 * code of <sysexits.h> after one line on standard error. */
int  host_memory_open(const char *file);
void host_memory_close(void);

/* A byte. It is in the file when put returns, so the program may be killed anywhere. */
uint8_t host_memory_get(uint16_t at);
void    host_memory_put(uint16_t at, uint8_t byte);

#endif

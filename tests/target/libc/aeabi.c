/* tests/target/libc/aeabi.c -- the names by which clang calls the functions of ports/bare/memory.c
 * on ARM
 * SPDX-License-Identifier: MIT
 */
#ifdef __arm__

#include "string.h"

#define COPY(name) \
    void name(void *to, const void *from, size_t count);    \
    void name(void *to, const void *from, size_t count)     { memcpy(to, from, count); }
#define MOVE(name) \
    void name(void *to, const void *from, size_t count);    \
    void name(void *to, const void *from, size_t count)     { memmove(to, from, count); }
#define CLEAR(name) \
    void name(void *to, size_t count);                      \
    void name(void *to, size_t count)                       { memset(to, 0, count); }
#define SET(name) \
    void name(void *to, size_t count, int value);           \
    void name(void *to, size_t count, int value)            { memset(to, value, count); }

COPY(__aeabi_memcpy)
COPY(__aeabi_memcpy4)
COPY(__aeabi_memcpy8)
MOVE(__aeabi_memmove)
MOVE(__aeabi_memmove4)
MOVE(__aeabi_memmove8)
CLEAR(__aeabi_memclr)
CLEAR(__aeabi_memclr4)
CLEAR(__aeabi_memclr8)
SET(__aeabi_memset)
SET(__aeabi_memset4)
SET(__aeabi_memset8)

#endif

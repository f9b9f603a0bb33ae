/* tests/target/libc/stdlib.h -- the part of <stdlib.h> that tests use
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TARGET_STDLIB_H
#define LOFT_TARGET_STDLIB_H

#include <stddef.h>


static inline int       abs(int x)          { return x < 0 ? -x : x; }
static inline long      labs(long x)        { return x < 0 ? -x : x; }
static inline long long llabs(long long x)  { return x < 0 ? -x : x; }

static inline char *getenv(const char *name)
{
    (void)name;
    return NULL;
}
void abort(void);
unsigned long strtoul(const char *text, char **end, int base);
unsigned long long strtoull(const char *text, char **end, int base);

#endif

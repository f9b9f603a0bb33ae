/* host-tools/base/memory.c
 * SPDX-License-Identifier: MIT
 *
 * The process has one memory: these two are the only variables of the library, and they are set
 * before it is used.
 */
#include <stdlib.h>

#include "base/memory.h"

static void (*out)(size_t bytes);
static void *(*take)(void *old, size_t bytes);

void memory_is_out(void (*handler)(size_t bytes)) { out = handler; }

void memory_take_by(void *(*grow)(void *old, size_t bytes)) { take = grow; }

void *memory_grow(void *old, size_t bytes)
{
    void *grown = (take != NULL ? take : realloc)(old, bytes ? bytes : 1);

    if (grown == NULL && out != NULL)
        out(bytes);
    if (grown == NULL)
        __builtin_trap();
    return grown;
}

/* host-tools/base/memory.h -- memory: sizes are refused before they are taken, and then there is
 * enough, or the program decides
 * SPDX-License-Identifier: MIT
 *
 * What a file can ask for is bounded by its reader, with a message that has a remedy. What is
 * bounded so may still be more than the system has. No call handles that: the program says once
 * what happens then, as the command, which prints one line and exits.
 */
#ifndef LOFT_MEMORY_H
#define LOFT_MEMORY_H

#include <stddef.h>

/* realloc, but never NULL: NULL begins an array, and 0 bytes are some. */
void *memory_grow(void *old, size_t bytes);

/* Before the first call and any thread: what happens if there are no such `bytes`. It may not
 * return; without it the program traps. */
void memory_is_out(void (*handler)(size_t bytes));

/* For tests: take memory by this function in the place of realloc; NULL: realloc. */
void memory_take_by(void *(*grow)(void *old, size_t bytes));

#endif

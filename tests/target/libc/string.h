/* tests/target/libc/string.h -- the part of <string.h> that tests use; the first four are in
 * ports/bare
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TARGET_STRING_H
#define LOFT_TARGET_STRING_H

#include <stddef.h>

void  *memcpy(void *to, const void *from, size_t count);
void  *memmove(void *to, const void *from, size_t count);
void  *memset(void *to, int value, size_t count);
int    memcmp(const void *a, const void *b, size_t count);
void  *memchr(const void *in, int value, size_t count);
size_t strlen(const char *text);
int    strcmp(const char *a, const char *b);
char  *strchr(const char *text, int c);

#endif

/* tests/target/libc/stdio.h -- the part of <stdio.h> that tests use: the debugger's console
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TARGET_STDIO_H
#define LOFT_TARGET_STDIO_H

#include <stddef.h>

typedef struct {
    int unused;
} FILE;
#define stdout ((FILE *)0)

/* %s %c %d %u %x, with l, ll and z, and %g %f %e, always with an exponent; widths and flags are
 * skipped. */
int printf(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* There are no files: a program that calls one of these does not link. Headers of tests mention
 * them in functions that a chip does not call. */
int   snprintf(char *to, size_t most, const char *format, ...);
FILE *fopen(const char *name, const char *mode);
int   fscanf(FILE *file, const char *format, ...);
int   fclose(FILE *file);

static inline int fflush(FILE *file)
{
    (void)file;
    return 0;
}

#endif

/* host-tools/base/say.h -- prints what people read: the one place where words of others pass, such
 * as names of files, layers and devices, comments of programs, and what a controller says
 * SPDX-License-Identifier: MIT
 *
 * A terminal obeys bytes that do not print. Here they become visible: \x1b for a byte, \u202e for a
 * character. Valid UTF-8 that prints stays as it is. Data, for example curves or G-code on standard
 * output, do not pass here.
 */
#ifndef LOFT_SAY_H
#define LOFT_SAY_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* The character at `text`, which does not end there. Returns how many bytes it has; *seen: the code
 * point, or -1: the byte is no character. */
int say_character(const char *text, int32_t *seen);

/* True if this code point does not print, but changes or hides what is beside it: controls of C0
 * and C1, of direction, separators, marks without width. */
bool say_hides(int32_t character);

/* Copy a text as one line that prints: newlines are escaped as well. It is cut at the end of a
 * character. Returns `out`. */
char *say_copy(char out[], size_t room, const char *text);

/* The text as JSON writes it, in quotes. Bytes that are no UTF-8 are taken for Latin 1. What does
 * not print is written in digits, beyond U+FFFF as two surrogates: a terminal may show it, too. */
void say_quoted(FILE *out, const char *text);

/* printf for people. Only a newline at the end of the format is one. */
int say(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));
int say_list(FILE *out, const char *format, va_list values);

#endif

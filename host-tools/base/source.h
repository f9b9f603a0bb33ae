/* host-tools/base/source.h -- the text of a file
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SOURCE_H
#define LOFT_SOURCE_H

#include <stdbool.h>
#include <stddef.h>

/* Read all of `file` and append a 0. "-" is standard input, which may be read again. A file that is
 * packed with gzip is unpacked. On failure prints one line, sets *code to a code of <sysexits.h>
 * and returns NULL. */
char *source_read(const char *file, size_t *size, int *code);

/* The name of the file in messages. */
const char *source_name(const char *file);

/* Does the text start with `<`, after at most a byte order mark and white space, or with the mark
 * of UTF-16? */
bool source_is_xml(const char *text);

#endif

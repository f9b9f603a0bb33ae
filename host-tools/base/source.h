/* host-tools/base/source.h -- the text of a file
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SOURCE_H
#define LOFT_SOURCE_H

#include <stdbool.h>
#include <stddef.h>

/* All of `file` ("-" is standard input, which may be read again), with a 0 behind; unpacked, if it
 * is packed with gzip. NULL after printing one line, and *code is of <sysexits.h>. */
char *source_read(const char *file, size_t *size, int *code);

/* What messages call it. */
const char *source_name(const char *file);

/* XML starts with `<`, behind a byte order mark and white space at most; UTF-16 has a mark. */
bool source_is_xml(const char *text);

#endif

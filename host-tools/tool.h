/* host-tools/tool.h -- what all subcommands share: errors in one line, exit codes, small helpers
 * SPDX-License-Identifier: MIT
 *
 * Every error is one line on standard error: `loft: what, where: remedy`, with a code of <sysexits.h>.
 */
#ifndef LOFT_TOOL_H
#define LOFT_TOOL_H

#include <stdbool.h>
#include <stddef.h>
#include <sysexits.h>       /* EX_USAGE, EX_DATAERR, EX_NOINPUT, EX_UNAVAILABLE, EX_PROTOCOL, .. */

/* Print `loft: <message>` and return `code`. */
int tool_error(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A number between least and most; on failure prints what option it was and returns false. */
bool tool_number(const char *option, const char *text, double least, double most, double *out);

/* malloc or exit(EX_OSERR) with a line; host tools only. */
void *tool_grow(void *old, size_t bytes);

#endif

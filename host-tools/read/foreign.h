/* host-tools/read/foreign.h -- files of other programs that loft cannot read
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_FOREIGN_H
#define LOFT_FOREIGN_H

#include <stddef.h>

/* Returns 0; or EX_DATAERR after printing what the file is and what to do with it: DXF, HP-GL, PDF,
 * PNG and others. `text` holds `size` bytes, followed by a 0. */
int foreign_refuse(const char *file, const char *text, size_t size);

#endif

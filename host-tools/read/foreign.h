/* host-tools/read/foreign.h -- files of other programs that no reader here can read
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_FOREIGN_H
#define LOFT_FOREIGN_H

#include <stddef.h>

/* 0; or EX_DATAERR after a line that names what the file is and what to do with it: DXF, HP-GL,
 * PDF, PNG and others. `text` holds `size` bytes and a 0 behind them. */
int foreign_refuse(const char *file, const char *text, size_t size);

#endif

/* host-tools/read/drawing_curves.h -- a drawing of curves of any kind
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_DRAWING_CURVES_H
#define LOFT_DRAWING_CURVES_H

#include "read/reader.h"

extern const reader reader_loft;

int drawing_read_curves(host *h, drawing *d, const char *file, const char *text);

#endif

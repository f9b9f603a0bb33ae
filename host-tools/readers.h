/* host-tools/readers.h -- reads any file: its content tells the kind
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_READERS_H
#define LOFT_READERS_H

#include "engine/curve.h"       /* curves */
#include "read/drawing.h"       /* drawing */

/* Read `file` ("-" is standard input): SVG, curves (LOFT.md), G-code or CSV (x0,y0,..,x3,y3 in mm
 * per line). Returns 0, or a code of <sysexits.h> after one message. `*d` must be zeroed but
 * for what is set before; free with drawing_free. */
int drawing_read(host *h, drawing *d, const char *file);

/* Read the curves of `file` ("-" is standard input); lines of two or three numbers are control
 * points. If `text` is not NULL, read the control points of one Bezier curve from it instead: "0,0
 * 1,2 3,0". Returns 0, or an exit code after one message. `*all` must be zeroed, but for what
 * is asked for. */
int curves_read(host *h, curves *all, const char *file, const char *text);

#endif

/* host-tools/plan/check.h -- judges a drawing or a program against a machine, and moves nothing
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CHECK_H
#define LOFT_CHECK_H

#include "plan/toolpath.h"       /* toolpath */
#include "read/drawing.h"        /* drawing */
#include "read/machine_file.h"   /* machine_file */

/* Print the box of all that the tool does, the feeds that are asked for, and one line each for what
 * is odd: feeds that an axis cannot do, and rapids below z = 0. `feed`, mm/s: where the drawing
 * says none. */
void check_print(FILE *out, const machine_file *m, const char *file, const drawing *d,
                 const toolpath *path, double feed);

#endif

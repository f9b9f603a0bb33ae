/* host-tools/plan/table.h -- whether a drawing stays on the machine's table
 * SPDX-License-Identifier: MIT
 *
 * The table is a box for the tool: `x.min` and `x.travel` of the machine's file. An axis without a
 * travel is not limited.
 */
#ifndef LOFT_TABLE_H
#define LOFT_TABLE_H

#include "read/drawing.h"        /* drawing */
#include "read/machine_file.h"   /* machine_file */
#include "plan/toolpath.h"       /* toolpath */

struct host;                /* base/host.h */

/* Check everything but the place where the machine stands now. The motion may leave the path by
 * `tol`, and the path the table by as much. Returns 0, or EX_DATAERR after one line with both boxes
 * and with what would fit. */
int table_check(struct host *h, const machine_file *m, const char *file, const drawing *d,
                const toolpath *path, double tol);

/* `x -5..215.3, y 10..287, z 0..1`: where the tool is, as table_check sees it. */
const char *table_words(const drawing *d, const toolpath *path, char out[160]);

/* Check a straight move of the tool. An axis that begins outside may return, or stay. Returns as
 * table_check. */
int table_place(struct host *h, const machine_file *m, const double from[ENGINE_AXES],
                const double to[ENGINE_AXES], double tol);

/* The ends of the table on an axis; infinite without a travel. */
void table_ends(const machine_file *m, int axis, double *least, double *most);

#endif

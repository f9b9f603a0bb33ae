/* host-tools/send/grbl.h -- a controller that speaks grbl's protocol (grbl 1.1, grblHAL, FluidNC):
 * G-code lines, character counting
 * SPDX-License-Identifier: MIT
 *
 * This protocol has no checksums, no line numbers and no resume: a lost byte cuts a wrong path, or
 * drops a line. loft notices what it can: an error stops the sending and the machine; a restart, an
 * alarm and an unanswered line are reported.
 */
#ifndef LOFT_GRBL_H
#define LOFT_GRBL_H

#include "engine/engine.h"  /* ENGINE_AXES */
#include "read/machine_file.h"  /* machine_file */
#include "send/gcode_write.h"     /* gcode */
#include "cmd/report.h"    /* report_job */

typedef struct grbl grbl;

/* Open the port and find out which controller answers, the size of its buffer and its position (mm,
 * in its work coordinates). Returns 0, or an exit code after printing one line. */
int  grbl_open(grbl **g, const char *port, unsigned baud, double seconds);
void grbl_close(grbl *g);

const double *grbl_place(const grbl *g);
const char   *grbl_name(const grbl *g);     /* its greeting; "": none */

/* What it answered to `$$`, over *m, with the table as grbl_table sees it. Returns 0, or an exit
 * code after printing one line. */
int  grbl_machine(const grbl *g, machine_file *m);

/* Its table in work coordinates, into m->travel and m->min. Returns false, and leaves *m, if it has
 * no soft limits ($20=1): then it does not know where it is. */
bool grbl_table(const grbl *g, machine_file *m);

/* Send all lines, made of the path of `job`, and wait for the end; handles keys and tells how it
 * goes. Returns an exit code, after printing the closing line or one error. */
int  grbl_run(grbl *g, const gcode *code, const report_job *job);

#endif

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

#include "base/host.h"
#include "engine/engine.h"  /* ENGINE_AXES */
#include "read/machine_file.h"  /* machine_file */
#include "send/gcode_write.h"     /* gcode */
#include "plan/toolpath.h"      /* toolpath */
#include "send/facts.h"         /* send_facts */
#include "send/task.h"          /* task */

typedef struct grbl grbl;

/* Open the port. Next it is to be found out which controller answers, the size of its buffer and
 * its position (mm, in its work coordinates). Returns 0, or an exit code after one message. */
int  grbl_open(grbl **g, host *h, const char *port, unsigned baud, double seconds);
void grbl_close(grbl *g);

/* What was begun, by grbl_open or by grbl_begin. Stepped, it ends with 0 or with an exit code after
 * one message. */
task grbl_task(grbl *g);

const double *grbl_place(const grbl *g);
const char   *grbl_name(const grbl *g);     /* its greeting; "": none */

/* What it answered to `$$`, over *m, with the table as grbl_table sees it. Returns 0, or an exit
 * code after one message. */
int  grbl_machine(const grbl *g, machine_file *m);

/* Its table in work coordinates, into m->travel and m->min. Returns false, and leaves *m, if it has
 * no soft limits ($20=1): then it does not know where it is. */
bool grbl_table(const grbl *g, machine_file *m);

/* Send all lines, made of the path, and wait for the end; both stay until then. At the end the
 * closing line is told. */
void grbl_begin(grbl *g, const gcode *code, const toolpath *path, const send_teller *to);

/* Obey a key: h holds, r resumes, a aborts, + - 0 change the override, s tells the state. */
void grbl_key(grbl *g, int key);

/* How it goes, and the same in words. */
void grbl_facts(grbl *g, send_facts *f, char words[160]);

/* Is the job over, so that only its end is to be told? */
bool grbl_over(const grbl *g);

#endif

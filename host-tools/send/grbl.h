/* host-tools/send/grbl.h -- a controller that speaks grbl's protocol (grbl 1.1, grblHAL, FluidNC):
 * G-code lines, character counting
 * SPDX-License-Identifier: MIT
 *
 * Such a line has no check, no numbers and no resume: a byte that is lost cuts a wrong path, or one
 * line less. What can be noticed is: an error stops the sending and the machine, a restart and an
 * alarm are told, and so is a line that nobody answers.
 */
#ifndef LOFT_GRBL_H
#define LOFT_GRBL_H

#include "engine/engine.h"         /* ENGINE_AXES */
#include "send/gcode.h"          /* gcode */

typedef struct grbl grbl;

/* Open the port and find out who answers, how much it takes at once and where it stands (mm, of its
 * work coordinates). Gives 0, or an exit code after printing one line. */
int  grbl_open(grbl **g, const char *port, unsigned baud, double seconds);
void grbl_close(grbl *g);

const double *grbl_place(const grbl *g);

/* Send all lines and see them through: keys, progress, the end. Gives an exit code, after the
 * closing line or one error. */
int  grbl_run(grbl *g, const gcode *code, const char *what);

#endif

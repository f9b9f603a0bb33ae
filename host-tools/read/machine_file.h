/* host-tools/read/machine_file.h -- a machine as text: steps, limits, tolerances, for all
 * subcommands (MACHINE.md)
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MACHINE_FILE_H
#define LOFT_MACHINE_FILE_H

#include "engine/engine.h"         /* ENGINE_AXES, engine_limits */
#include "engine/kinematics.h"     /* kinematics */

/* Lengths in mm, times in s. What is one per axis is one per motor. Read with machine_read; what
 * the file does not say keeps its value. */
typedef struct {
    double steps_per_mm[ENGINE_AXES];
    double max_speed[ENGINE_AXES], max_accel[ENGINE_AXES];
    double max_jerk[ENGINE_AXES];           /* 0: not limited; below 0: not said            */
    double max_across;                      /* 0: max_accel counts across the path too      */
    double corner, tol;                     /* junction deviation; how far from the drawing */
    double tick_hz, slots, ramp, queue, curves;     /* whole numbers                        */
    bool   limited;                         /* the file says a speed, an acceleration or a jerk */
    kinematics k;
} machine_file;

/* What `loft simulate` is without a file. */
machine_file machine_usual(void);

/* Read `file` ("-" is standard input) over *m. Gives 0, or an exit code after one line `loft:
 * file:line: ..`. */
int machine_read(machine_file *m, const char *file);

/* One line `key = value` over *m. Nothing is checked that needs more than this line. */
int machine_line(machine_file *m, const char *file, unsigned line, const char *text);

/* As machine_read, for the option --machine FILE among the arguments, before the others are looked
 * at, so that they can have the file's numbers as defaults; 0 too if there is none. */
int machine_option(machine_file *m, int argc, char **argv);

/* Lower `limits` to those of the machine. */
void machine_limit(const machine_file *m, engine_limits *limits);

#endif

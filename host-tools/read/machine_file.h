/* host-tools/read/machine_file.h -- a machine as text: steps, limits, tolerances, for all
 * subcommands (MACHINE.md)
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MACHINE_FILE_H
#define LOFT_MACHINE_FILE_H

#include <stdio.h>

#include "engine/engine.h"         /* ENGINE_AXES, engine_limits */
#include "engine/machine_kinematics.h"     /* kinematics */
#include "read/machine_tools.h"

struct host;                /* base/host.h */

/* Lengths in mm, times in s. Numbers per axis are numbers per motor. Read with machine_read; keys
 * that the file does not give keep their value. */
typedef struct {
    double steps_per_mm[ENGINE_AXES];
    double max_speed[ENGINE_AXES], max_accel[ENGINE_AXES];
    double max_jerk[ENGINE_AXES];           /* 0: not limited; below 0: not given */
    double corner, tol;                     /* tolerance near corners; of the path */
    double travel[ENGINE_AXES], min[ENGINE_AXES];   /* the table, for the tool: its size, 0: not
                                                     * limited; its low end */
    double zero[ENGINE_AXES];               /* where on the table the drawing's 0 lies */
    double home_order[ENGINE_AXES];         /* 1 to 3: when the axis is homed; 0: it is not */
    double home_end[ENGINE_AXES];           /* its switch: 0: at the low end, 1: high */
    double home_at[ENGINE_AXES];            /* where the switch is; NAN: home_back outside */
    double home_seek[ENGINE_AXES], home_touch[ENGINE_AXES], home_back[ENGINE_AXES];
    double home_search[ENGINE_AXES];        /* how far to look; 0: the table and more */
    double square[ENGINE_AXES];             /* 1: two motors with a switch each, to be squared */
    double hard_stop;                       /* 1: a limit switch stops it at once */
    double park[ENGINE_AXES], pen_up, pen_down;     /* places of `loft park` and `loft pen` */
    double reversed[ENGINE_AXES];           /* 1: the motor turns the other way */
    double limit_opens[ENGINE_AXES], probe_opens, buttons_open;    /* 1: the contact opens */
    double drive[ENGINE_AXES], servo_zero;  /* 1: a servo; us of its pulse at 0; below 0: not
                                             * given */
    double idle, pulse;                     /* s to the motors' rest, 0: none; us; below 0: not
                                             * given */
    double s_max, spin_up, laser;           /* S of full power; s until the spindle turns; 1: it is
                                             * a laser */
    double tick_hz, slots, ramp, queue, curves;     /* whole numbers                        */
    bool   limited;                         /* the file gives a speed, an acceleration or a jerk */
    kinematics k;
    machine_tools tools;                    /* what it draws with, in the order of the file */
} machine_file;

/* The machine that `loft simulate` is without a file. */
machine_file machine_usual(void);

/* Read `file` ("-" is standard input) over *m. Returns 0, or an exit code after printing one line
 * `loft: file:line: ..`. */
int machine_read(struct host *h, machine_file *m, const char *file);

/* Like machine_read, from a text; `name` is that of its place. */
int machine_text(struct host *h, machine_file *m, const char *name, const char *text);

/* Who keeps a key: a machine that obeys it, a machine as text for the host, or no machine: because
 * it is about its firmware, or about the plan. */
enum machine_keeper { MACHINE_OBEYS, MACHINE_TEXT, MACHINE_FIRMWARE, MACHINE_PLAN };

/* Print the lines of a keeper: of MACHINE_TEXT those that are not as usual. */
void machine_print(const machine_file *m, enum machine_keeper of, FILE *out);

/* The first key of a keeper in which they differ; NULL: none. */
const char *machine_differs(const machine_file *a, const machine_file *b, enum machine_keeper of);

/* Read one line `key = value` over *m. Checks only this line. */
int machine_line(struct host *h, machine_file *m, const char *file, unsigned line,
                 const char *text);

/* Where the homing switch of an axis is in the drawing, and how far to look for it; 0: the file
 * does not say. */
double machine_home_at(const machine_file *m, int axis);
double machine_home_search(const machine_file *m, int axis);

/* Lower `limits` to the limits of the machine. */
void machine_limit(const machine_file *m, engine_limits *limits);

#endif

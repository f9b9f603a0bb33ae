/* host-tools/plan/planning.h -- the options that `loft stream` and `loft plan` share: machine,
 * feeds, limits, tolerance
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PLANNING_H
#define LOFT_PLANNING_H

#include "read/drawing.h"        /* drawing */
#include "gcode/gcode.h"          /* GCODE_OPTION */
#include "plan/joints.h"         /* joints */
#include "read/machine_file.h"   /* machine_file */
#include "base/tool.h"           /* tool_option */
#include "arrange/order.h"          /* order_options */
#include "arrange/page.h"           /* page_options */
#include "plan/toolpath.h"       /* toolpath_options */

typedef struct {
    const engine *e;
    machine_file machine;
    const char *file;               /* of the machine, after it has been read */
    int dialect;                    /* of G-code, and */
    unsigned from_line;             /* its first line that is run; 0: all */
    double feed, travel;            /* mm/s                                        */
    double accel, jerk;             /* mm/s^2, mm/s^3; below 0: from the machine */
    double corner, tol, lift;       /* mm                                          */
    double exact;                   /* degrees; 0: EXACT_DEGREES, below 0: no stops */
    double smooth;                  /* mm of tol; below 0: SMOOTH_PART */
    double smoothed;                /* mm of tol that smoothing used up */
    bool passes;                    /* of a drawing that is not smoothed, only its page is needed
                                     * afterwards; set before planning_read */
    bool levels;                    /* the job sets a laser in motion; set before planning_read */
    bool park;
    page_options sheet;
    order_options order;
} planning;

/* Rows of a table of options. */
#define PLANNING_OPTIONS(p)                                                                        \
    TOOL_TEXT("machine", "FILE", &(p)->file,                                                       \
              "a machine as text, see host-tools/MACHINE.md: its limits hold too; without a port " \
              "it is planned for"),                                                                \
        TOOL_SPEED("feed", &(p)->feed, 0.016, 1000, "pen down, mm/s, or as 1200mm/min (30)"),      \
        TOOL_SPEED("travel", &(p)->travel, 0.016, 1000, "pen up (100)"),                           \
        TOOL_NUMBER("accel", "MM/S2", &(p)->accel, 1, 30000,                                       \
                    "no more than this on any axis (the machine's)"),                              \
        TOOL_NUMBER("jerk", "MM/S3", &(p)->jerk, 0, 1e7,                                           \
                    "change of acceleration on any axis (the machine's); 0: at once"),             \
        TOOL_NUMBER("tol", "MM", &(p)->tol, 0.00098, 1,                                            \
                    "how far the machine may leave the drawing (0.005)"),                          \
        TOOL_NUMBER("corner", "MM", &(p)->corner, 0, 1,                                            \
                    "the same at corners, where it turns by more than 5 degrees, and up "          \
                    "to 32 times this along it from them; at least --tol (0)"),                    \
        TOOL_MAYBE("exact", "DEG", &(p)->exact, 0.1, 180,                                          \
                   "stop at corners that turn by more than this (5), exactly on them, as G61"),    \
        TOOL_NUMBER("smooth", "MM", &(p)->smooth, 0, 1,                                            \
                    "of this tolerance, for chains of short lines to become curves (a fifth); 0: " \
                    "each line is drawn"),                                                         \
        TOOL_NUMBER("lift", "MM", &(p)->lift, 0, 100, "height of the pen while travelling (1)"),   \
        TOOL_SWITCH("park", &(p)->park,                                                            \
                    "at the end go to the machine's zero, where it was switched on or homed"),     \
        PAGE_OPTIONS(&(p)->sheet), ORDER_OPTIONS(&(p)->order),                                     \
        GCODE_OPTIONS(&(p)->dialect, &(p)->from_line),                                             \
        ENGINE_OPTION(&(p)->e, "number type of the planner (q16)")

/* Set the defaults; reads the machine's file if the options name one. Returns 0, or an exit code
 * after printing one line. */
int planning_start(planning *p, int argc, char **argv);

/* The limits of the machine of the file, or of a typical one. The second function applies those of
 * file and options to the limits of any machine. */
void planning_machine(const planning *p, engine_limits *limits);
void planning_limit(const planning *p, engine_limits *limits);

/* Read a drawing that can be planned, lay it out on its page, and prepare it for planning. Returns
 * 0, or an exit code after printing one line.
 *
 *   memory  G-code and CSV: of the smoothed curves alone, if it `passes` and no option needs all of
 *           the drawing at once (page, tools, order) */
int planning_read(planning *p, drawing *d, drawing *smooth, const char *file);

/* The options of the toolpath. The second function sets the tool's start for motors at `start`; it
 * returns false if they cannot be there. */
toolpath_options planning_path(const planning *p);
bool planning_start_at(const planning *p, const double start[ENGINE_AXES], toolpath_options *how);

/* The path of the motors from there, for the machine to plan (`chip`) or not; `limits` are those of
 * the motors. Returns 0, or an exit code after printing one line. Call joints_free in any case. */
int planning_joints(const planning *p, const char *file, const drawing *d,
                    const double start[ENGINE_AXES], bool chip, const engine_limits *limits,
                    toolpath *path, joints *out);

#endif

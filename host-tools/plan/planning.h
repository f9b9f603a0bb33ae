/* host-tools/plan/planning.h -- the options that `loft stream` and `loft plan` share: machine,
 * feeds, limits, tolerance
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PLANNING_H
#define LOFT_PLANNING_H

#include "read/drawing.h"        /* drawing */
#include "gcode/gcode.h"          /* gcode_choice */
#include "plan/joints.h"         /* joints */
#include "read/machine_file.h"   /* machine_file */
#include "base/option.h"         /* option */
#include "arrange/order.h"          /* order_options */
#include "arrange/page.h"           /* page_options */
#include "plan/toolpath.h"       /* toolpath_options */

struct host;                /* base/host.h */

typedef struct {
    const engine *e;
    machine_file machine;
    const char *file;               /* of the machine, after it has been read */
    gcode_choice program;
    double feed, travel;            /* mm/s                                        */
    double accel, jerk;             /* mm/s^2, mm/s^3; below 0: from the machine */
    double corner, tol;             /* mm; below 0: from the machine */
    double lift;                    /* mm                                          */
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

extern const option planning_rows[];

/* After the options are read: read the machine's file if they name one, and take from the machine
 * what they leave to it. The second function begins without options: all are as by default.
 * Return 0, or an exit code after printing one line. */
int planning_start(struct host *h, planning *p);
int planning_usual(struct host *h, planning *p, const char *machine);

/* The limits of the machine of the file, or of a typical one. The second function applies those of
 * file and options to the limits of any machine. */
void planning_machine(const planning *p, engine_limits *limits);
void planning_limit(const planning *p, engine_limits *limits);

/* Read a drawing that can be planned, lay it out on its page, and prepare it for planning. Returns
 * 0, or an exit code after printing one line.
 *
 *   memory  G-code and CSV: of the smoothed curves alone, if it `passes` and no option needs all of
 *           the drawing at once (page, tools, order) */
int planning_read(struct host *h, planning *p, drawing *d, drawing *smooth, const char *file);

/* The same with a drawing that was read before, and is laid out. */
int planning_smooth(struct host *h, planning *p, drawing *d, drawing *smooth, const char *file);

/* The options of the toolpath. The second function sets the tool's start for motors at `start`; it
 * returns false if they cannot be there. */
toolpath_options planning_path(const planning *p);
bool planning_start_at(const planning *p, const double start[ENGINE_AXES], toolpath_options *how);

/* The path of the motors from there, for the machine to plan (`chip`) or not; `limits` are those of
 * the motors. Returns 0, or an exit code after printing one line. Call joints_free in any case. */
int planning_joints(struct host *h, const planning *p, const char *file, const drawing *d,
                    const double start[ENGINE_AXES], bool chip, const engine_limits *limits,
                    toolpath *path, joints *out);

#endif

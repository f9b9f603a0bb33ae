/* host-tools/plan/planning.c -- chooses what is planned, and within which limits
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "base/host.h"
#include "plan/planning.h"
#include "fit/smooth.h"         /* drawing_smooth */
#include "plan/table.h"          /* table_check */
#include "arrange/tools.h"          /* tools_apply */
#include "base/source.h"         /* source_name */
#include "readers.h"

#define JERK_MAX 1e7        /* mm/s^3, of lib/path/limits.h                    */
#define SMOOTH_PART 0.2     /* of the tolerance: for replacing lines by curves */
#define MAP_PART    0.2     /* of the tolerance: for the curves of nonlinear motors */
#define TOL_MIN     (1 / 1024.0)    /* mm, of lib/path/limits.h                */
#define TOL_MAX 1.0         /* mm, of --tol */
#define RAPID 1000.0        /* mm/s: more than any axis; so its own limits are the rapid speed */
#define EXACT_DEGREES 5     /* a smaller turn is no corner */
#define JERK_PER 20         /* 1/s times the acceleration: reached in 1/20 s */

const option planning_rows[] = {
    OPTION_HEADING("motion"),
    { "machine", OPTION_FILE(planning, file), .value = "FILE",
      .help = "a machine as text, see host-tools/MACHINE.md: its limits hold too; without a port "
              "it is planned for" },
    { "feed", OPTION_NUMBER(planning, feed), .least = 0.016, .most = 1000, .unit = "mm/s",
      .standard = "30", .help = "pen down, mm/s, or as 1200mm/min" },
    { "travel", OPTION_NUMBER(planning, travel), .least = 0.016, .most = 1000, .unit = "mm/s",
      .standard = "100", .help = "pen up" },
    { "accel", OPTION_NUMBER(planning, accel), .least = 1, .most = 30000, .unit = "mm/s2",
      .unset = -1, .help = "no more than this on any axis (the machine's)" },
    { "jerk", OPTION_NUMBER(planning, jerk), .least = 0, .most = JERK_MAX, .unit = "mm/s3",
      .unset = -1, .help = "change of acceleration on any axis (the machine's); 0: at once" },
    { "tol", OPTION_NUMBER(planning, tol), .least = 0.00098, .most = TOL_MAX, .unit = "mm",
      .unset = -1, .help = "how far the machine may leave the drawing (0.005)" },
    { "corner", OPTION_NUMBER(planning, corner), .least = 0, .most = 1, .unit = "mm", .unset = -1,
      .help = "the same at corners, where it turns by more than 5 degrees, and up to 32 times this "
              "along it from them; at least --tol (0)" },
    { "exact", OPTION_MAYBE(planning, exact), .least = 0.1, .most = 180, .unit = "deg", .unset = -1,
      .help = "stop at corners that turn by more than this (5), exactly on them, as G61" },
    { "smooth", OPTION_NUMBER(planning, smooth), .least = 0, .most = 1, .unit = "mm", .unset = -1,
      .help = "of this tolerance, for chains of short lines to become curves (a fifth); 0: each "
              "line is drawn" },
    { "lift", OPTION_NUMBER(planning, lift), .least = 0, .most = 100, .unit = "mm", .standard = "1",
      .help = "height of the pen while travelling" },
    { "park", OPTION_FLAG(planning, park),
      .help = "at the end go to the machine's zero, where it was switched on or homed" },
    OPTION_GROUP(planning, sheet, page_rows),
    OPTION_GROUP(planning, order, order_rows),
    OPTION_GROUP(planning, program, gcode_rows),
    OPTION_HEADING("arithmetic"),
    ENGINE_ROW(planning, e, "q16", "number type of the planner"),
    { 0 }
};

int planning_start(host *h, planning *p)
{
    p->machine     = machine_usual();
    const int code = p->file ? machine_read(h, &p->machine, p->file) : 0;

    p->corner = p->corner < 0 ? p->machine.corner : p->corner;
    p->tol    = p->tol < 0 ? p->machine.tol : p->tol;
    return code;
}

int planning_usual(host *h, planning *p, const char *machine)
{
    option_reading r;
    option_fault fault;

    *p = (planning){ .e = NULL };
    (void)option_begin(&r, planning_rows, p, &fault);
    p->file = machine;
    return planning_start(h, p);
}

void planning_machine(const planning *p, engine_limits *limits)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        limits->max_speed[i] = p->machine.max_speed[i];
        limits->max_accel[i] = p->machine.max_accel[i];
    }
    limits->tick_hz = (unsigned)p->machine.tick_hz;
}

void planning_limit(const planning *p, engine_limits *limits)
{
    if (p->machine.limited)
        machine_limit(&p->machine, limits);
    for (int i = 0; i < ENGINE_AXES; i++) {
        const double said = p->jerk >= 0 ? p->jerk : p->machine.max_jerk[i];
        if (p->accel > 0)
            limits->max_accel[i] = fmin(limits->max_accel[i], p->accel);
        limits->max_jerk[i] = said >= 0 ? said : fmin(JERK_PER * limits->max_accel[i], JERK_MAX);
    }
    limits->corner = fmax(p->corner - p->smoothed, 0);
    limits->tol    = p->tol - p->smoothed;
    limits->exact  = p->exact < 0 ? 0
                                 : 2 * sin((p->exact > 0 ? p->exact : EXACT_DEGREES) * M_PI / 360);
}

static int within_reach(host *h, const planning *p, const drawing *d, size_t first,
                        const char *file)
{
    for (size_t i = first; i < d->count; i++)
        for (int k = 0; k < 4; k++) {
            const double *at = d->curve[i].p[k], z = d->curve[i].z[k];
            if (!(fabs(at[0]) <= p->e->reach && fabs(at[1]) <= p->e->reach))
                return host_error(h, EX_DATAERR, "plan.point-too-far",
                                  (host_place){ source_name(file), d->curve[i].line },
                                  HOST_REMEDY("bring the drawing within +-%g mm", p->e->reach),
                                  "a point at %.6g,%.6g mm", at[0], at[1]);
            if (!(fabs(z) <= p->e->reach))
                return host_error(h, EX_DATAERR, "plan.height-too-far",
                                  (host_place){ source_name(file), d->curve[i].line },
                                  HOST_REMEDY("bring the drawing within +-%g mm", p->e->reach),
                                  "a point at z %.6g mm", z);
        }
    return 0;
}

/* What a program says about its path, where the options say nothing. */
static void obey_program(planning *p, const drawing *d)
{
    const bool said = p->tol < p->machine.tol || p->tol > p->machine.tol;

    if (d->exact && p->exact < 0)
        p->exact = 0;
    if (d->within > 0 && !said)
        p->tol = fmin(fmax(d->within, TOL_MIN), TOL_MAX);
}

/* A small tolerance is left to the machine as far as that needs it. Motors that no straight line
 * maps need more (planning_joints). */
static int smooth_within(host *h, const planning *p, double *within)
{
    const bool straight = p->machine.k.kind->direct;
    const double spare = straight ? fmax(p->tol * (1 - 1e-12) - TOL_MIN, 0) : p->tol;

    *within = p->smooth < 0 ? fmin(SMOOTH_PART * p->tol, spare) : p->smooth;
    if (*within > p->tol / 2 || *within > spare)
        return host_error(
            h, EX_USAGE, "plan.smooth", (host_place){ NULL, 0 },
            HOST_REMEDY(
                "leave half of the tolerance of %g mm to the machine, and at least 0.00098 mm",
                p->tol),
            "--smooth %g", *within);
    return 0;
}

/* A drawing that is smoothed while it is read. */
typedef struct {
    host *host;
    const planning *p;
    const char *file;
    drawing *smooth;
    smoothing how;
    size_t checked;
    bool begun;
} passing;

static passing start_passing(host *h, const planning *p, drawing *smooth, const char *file)
{
    return (passing){ .host = h,
                      .p = p,
                      .file = file,
                      .smooth = smooth,
                      .how.laser = p->levels && p->machine.laser > 0 };
}

static int pass_curves(passing *s, drawing *d, bool last)
{
    const int code = within_reach(s->host, s->p, d, s->checked, s->file);

    if (code != 0)
        return code;
    smooth_more(&s->how, s->smooth, d, last);
    if (s->how.given > 1 && d->taker != NULL) {   /* the next curve may be joined to the last one */
        drawing_forget(d, s->how.given - 1);
        s->how.given = 1;
    }
    s->checked = d->count;
    return 0;
}

/* The tolerance of a program is known when the first curves are. */
static int take_curves(void *context, drawing *d)
{
    passing *s = context;
    planning p = *s->p;
    int code   = 0;

    if (!s->begun) {
        obey_program(&p, d);
        code     = smooth_within(s->host, &p, &s->how.within);
        s->begun = true;
    }
    return code == 0 ? pass_curves(s, d, false) : code;
}

static bool needs_all(const planning *p)
{
    return p->machine.tools.count > 0 || page_is_asked(&p->sheet) ||
           (p->order.how != NULL && strcmp(p->order.how, "file") != 0);
}

/* Standard input cannot be read again, so all of it is kept. */
static int read_passing(passing *s, drawing *d)
{
    const bool passes = s->p->passes && !needs_all(s->p) && strcmp(s->file, "-") != 0;

    d->taker   = passes ? take_curves : NULL;
    d->context = s;
    return drawing_read(s->host, d, s->file);
}

/* The smoothed drawing is complete. Returns `code`. */
static int end_passing(passing *s, planning *p, const drawing *d, int code)
{
    smooth_end(&s->how);
    drawing_like(s->smooth, d);
    if (s->how.replaced > 0)
        p->smoothed = s->how.within;
    return code;
}

int planning_read(host *h, planning *p, drawing *d, drawing *smooth, const char *file)
{
    double within = 0;

    d->dialect   = p->program.dialect;
    d->from_line = p->program.from_line;
    d->layers    = p->sheet.layers;
    d->areas     = p->sheet.fill.distance > 0;
    d->only      = p->sheet.only;
    d->text      = p->sheet.text;
    d->tools     = p->machine.tools.count > 0 ? &p->machine.tools : NULL;
    const drawing asked = *d;       /* without a taker */
    passing s           = start_passing(h, p, smooth, file);

    int code = smooth_within(h, p, &within);
    if (code == 0)
        code = read_passing(&s, d);
    if (code == 0) {
        obey_program(p, d);
        code = smooth_within(h, p, &within);
    }
    if (code == 0 && s.begun && (within < s.how.within || within > s.how.within)) {
        smooth_end(&s.how);                 /* it says its tolerance later: all of it is needed */
        drawing_free(smooth);
        drawing_free(d);
        *d   = asked;
        s    = start_passing(h, p, smooth, file);
        code = drawing_read(h, d, file);
    }
    s.how.within = within;
    if (code == 0)
        code = page_apply(h, &p->sheet, d, file);
    if (code == 0)
        code = tools_apply(h, &p->machine.tools, d, file);
    if (code == 0)
        code = tools_order(h, &p->order, d, planning_path(p).zero, p->park, file);
    if (code == 0)
        code = pass_curves(&s, d, true);
    return end_passing(&s, p, d, code);
}

int planning_smooth(host *h, planning *p, drawing *d, drawing *smooth, const char *file)
{
    passing s = start_passing(h, p, smooth, file);

    obey_program(p, d);
    int code = smooth_within(h, p, &s.how.within);
    if (code == 0)
        code = pass_curves(&s, d, true);
    return end_passing(&s, p, d, code);
}

toolpath_options planning_path(const planning *p)
{
    const double motors[ENGINE_AXES] = { 0, 0, 0 };
    toolpath_options how = { .feed = p->feed,
        .travel = p->travel,
        .rapid = RAPID,
        .laser = p->machine.laser > 0,
        .lift = tools_most_lift(&p->machine.tools, p->lift),
                             .park = p->park };

    (void)kinematics_tool(&p->machine.k, motors, how.zero);
    return how;
}

bool planning_start_at(const planning *p, const double start[ENGINE_AXES], toolpath_options *how)
{
    return kinematics_tool(&p->machine.k, start, how->start);
}

/* The tolerance of the tool with which that of the motors, now `tol`, is TOL_MIN. */
static double enough_tol(const planning *p, const joints *j, double tol)
{
    const double left = 1 - MAP_PART - (p->smoothed > 0 ? SMOOTH_PART : 0);

    return p->tol + 1.05 * (TOL_MIN - tol) / j->least / left + 5e-4;
}

int planning_joints(host *h, const planning *p, const char *file, const drawing *d,
                    const double start[ENGINE_AXES], bool chip, const engine_limits *limits,
                    toolpath *path, joints *out)
{
    joints_options o = {
        .file = file, .d = d, .within = MAP_PART * p->tol, .reach = p->e->reach, .chip = chip
    };

    *out = (joints){ .k = NULL };
    memcpy(o.start, start, sizeof o.start);
    int code = table_check(h, &p->machine, file, d, path, p->tol);
    if (code == 0)
        code = joints_make(h, out, path, &p->machine.k, &o);
    if (code != 0)
        return code;
    const double tol = joints_limits(out, limits).tol;
    if (tol < TOL_MIN && !p->machine.k.kind->direct)
        return host_error(h, EX_DATAERR, "plan.tolerance-motors",
                          (host_place){ source_name(file), 0 },
                          HOST_REMEDY("give --tol %.2g or more%s", enough_tol(p, out, tol),
                                      chip ? ", or --plan host" : ""),
                          "for these motors %g mm are %.5f", limits->tol, tol);
    return 0;
}

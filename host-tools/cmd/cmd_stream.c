/* host-tools/cmd/cmd_stream.c -- loft stream: sends a drawing to a machine
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/keys.h"           /* keys_start, keys_hasty */
#include "send/grbl.h"           /* grbl_run */
#include "plan/planning.h"       /* planning_limit */
#include "send/stream.h"         /* stream_run */
#include "plan/table.h"          /* table_check */
#include "base/tool.h"
#include "plan/toolpath.h"       /* toolpath_make */

typedef struct {
    planning p;
    const char *port, *record, *log;
    unsigned baud;
    double wait;
    const char *where;
    bool points, grbl, g5, dry, hold, resume, abort, chip, away;
} stream_options;

static void machine_limits(const loft_sender *s, engine_limits *l)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        l->max_speed[i] = (double)s->axis[i].max_speed / 65536;
        l->max_accel[i] = (double)s->axis[i].max_accel / 65536;
    }
    l->tick_hz = s->machine.tick_hz;
}

/* Steps in mm: a whole multiple of 2^-16, which steps_of converts back to the same steps. */
static double mm_of(const loft_axis *a, int32_t steps)
{
    return round((double)steps * 65536 * 65536 / (double)a->steps_per_mm) / 65536;
}

/* The start of a new job: the position of the machine. */
static void new_start(const loft_sender *s, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = mm_of(&s->axis[i], s->axis[i].position);
}

/* The start of the machine's current job. */
static void old_start(const loft_sender *s, bool points, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = points ? mm_of(&s->axis[i], s->axis[i].start) : (double)s->axis[i].start / 65536;
}

/* A job and the data that it is planned from. */
typedef struct {
    toolpath path;
    joints of;
    job j;
} work;

static void free_work(work *w)
{
    job_free(&w->j);
    joints_free(&w->of);
    toolpath_free(&w->path);
}

/* Plan the first portion, from the position of the motors. */
static int plan_work(const stream_options *o, const char *file, const drawing *d,
                     const double start[ENGINE_AXES], const job_options *as, work *w)
{
    toolpath_options how = planning_path(&o->p);
    int status = 0;

    if (!planning_start_at(&o->p, start, &how))
        return tool_error(EX_DATAERR,
                          "%s: its motors are at %.6g %.6g %.6g, where those of a %s machine like "
                          "this cannot be: give its --machine FILE",
                          o->port ? o->port : "-", start[0], start[1], start[2],
                          kinematics_name(&o->p.machine.k));
    toolpath_make(&w->path, d, &how);
    if (w->path.count == 0)
        return tool_error(EX_DATAERR,
                          "%s: nothing to draw in it: give a drawing with visible outlines", file);
    keys_hasty(true);
    int code = planning_joints(&o->p, file, d, start, o->chip, &as->limits, &w->path, &w->of);
    if (code == 0)
        status = job_open(&w->j, &w->of, as);
    keys_hasty(false);
    return status == 0
               ? code
               : tool_error(EX_DATAERR, "%s: cannot be planned: %s", file, engine_status(status));
}

static void print_plan(const job *j, const toolpath *path, double tol)
{
    printf("planned: %zu curve%s, %.3f m drawn, %.3f m travelled, %.1f s, %zu %s, path within %.4f "
           "mm, job %08x\n",
           path->curves, tool_s(path->curves), path->drawn / 1000, path->travelled / 1000,
           job_seconds(j), j->count, job_words(j), tol, (unsigned)j->head.id);
}

/* Choose the options of a job for a machine with these limits. */
static int options_of(const stream_options *o, job_options *as)
{
    as->e    = o->p.e;
    as->kind = o->chip ? LOFT_CURVES : o->points ? LOFT_POINTS : LOFT_SPANS;
    planning_limit(&o->p, &as->limits);
    if (o->chip && as->limits.max_across > 0)
        return tool_error(EX_CONFIG,
                          "%s: a machine that plans knows no limit of its own across the path: "
                          "give --plan host, or --across 0, "
                          "so that --accel holds in bends too",
                          o->port);
    return 0;
}

static int finish_job(const char *file, job *j)
{
    keys_hasty(true);
    const int status = job_finish(j);
    keys_hasty(false);
    return status == LOFT_OK
               ? 0
               : tool_error(EX_DATAERR, "%s: cannot be planned: %s", file, engine_status(status));
}

static void print_page(const drawing *d)
{
    char words[160];

    printf("drawing: %s\n", page_words(d, words));
}

static int dry_run(const stream_options *o, const char *file, const drawing *d,
                   const drawing *smooth)
{
    const double start[ENGINE_AXES] = { 0, 0, 0 };
    job_options as;
    work w = { .path = { 0 } };

    planning_machine(&o->p, &as.limits);
    for (int i = 0; i < ENGINE_AXES; i++)
        as.steps_per_mm[i] = (int32_t)lround(o->p.machine.steps_per_mm[i] * 65536);
    int code = options_of(o, &as);
    if (code == 0)
        code = plan_work(o, file, smooth, start, &as, &w);
    if (code == 0)
        code = finish_job(file, &w.j);
    if (code == 0) {
        print_page(d);
        print_plan(&w.j, &w.path, o->p.tol);
    }
    free_work(&w);
    return code;
}

/* Can the machine do what the options ask? */
static int check_machine(const stream_options *o, const loft_sender *s)
{
    if (!o->chip || (s->machine.kinds & 1u << LOFT_CURVES && s->machine.curves > 0))
        return 0;
    return tool_error(EX_CONFIG,
                      "%s: this machine does not plan by itself: give --plan host, or build its "
                      "firmware with memory for a planner",
                      o->port);
}

static int plan_for(const stream_options *o, const char *file, const drawing *d,
                    const double start[ENGINE_AXES], const loft_sender *s, work *w)
{
    job_options as;

    free_work(w);
    machine_limits(s, &as.limits);
    for (int i = 0; i < ENGINE_AXES; i++)
        as.steps_per_mm[i] = s->axis[i].steps_per_mm;
    const int code = options_of(o, &as);
    return code == 0 ? plan_work(o, file, d, start, &as, w) : code;
}

/* If the machine has a job, it may be this one. It is if its id equals that of this job, planned
 * from the same start. Then that job continues. */
static int stream_drawing(const stream_options *o, const char *file, const drawing *d,
                          const drawing *smooth, talk *t)
{
    const loft_sender *s = &t->sender;
    double start[ENGINE_AXES];
    work w               = { .path = { 0 } };
    int code             = check_machine(o, s);

    if (code == 0 && s->machine.job != 0) {
        old_start(s, o->points, start);
        code = plan_for(o, file, smooth, start, s, &w);
    }
    if (code == 0 && (w.j.count == 0 || w.j.head.id != s->machine.job)) {
        new_start(s, start);
        code = plan_for(o, file, smooth, start, s, &w);
    }
    if (code == 0) {
        w.j.head.away = o->away ? s->closed : 0;
        code = stream_limits(t, o->p.machine.hard_stop > 0, &w.j.head);
    }
    if (code == 0) {
        const stream_subject about = { file, w.path.curves, w.path.drawn,   o->p.tol,
                                       d,    o->record,     &o->p.machine.k };
        code = stream_run(t, &w.j, &about);
    }
    free_work(&w);
    return code;
}

static int control_machine(const stream_options *o)
{
    const enum loft_verb verb = o->abort ? LOFT_ABORT : o->hold ? LOFT_HOLD : LOFT_RESUME;
    talk t;

    int code = talk_open(&t, o->port, o->baud, o->wait, o->log);
    if (code != 0)
        return code;
    code = stream_control(&t, verb, &o->p.machine.k);
    talk_close(&t);
    return code;
}

/* Send G-code to a controller of grbl's kind, or, in a dry run, print it. The controller plans. */
static int draw_gcode(const stream_options *o, const char *file, const drawing *d,
                      toolpath_options *how)
{
    grbl *g = NULL;
    toolpath path;
    gcode lines;
    char what[64];
    int code = o->dry ? 0 : grbl_open(&g, o->port, o->baud, o->wait);

    if (code != 0)
        return code;
    if (g != NULL)
        memcpy(how->start, grbl_place(g), sizeof how->start);
    toolpath_make(&path, d, how);
    const gcode_options as = { .tol = (o->p.tol - o->p.smoothed) / 2,
                               .curves = o->g5 ? GCODE_G5 : GCODE_ARCS,
                               .rapids = d->program };
    gcode_make(&lines, &path, &as);
    snprintf(what, sizeof what, "%zu curve%s, %.3f m", path.curves, tool_s(path.curves),
             path.drawn / 1000);
    if (path.count == 0)
        code = tool_error(EX_DATAERR,
                          "%s: nothing to draw in it: give a drawing with visible outlines", file);
    else
        code = table_check(&o->p.machine, file, d, &path, o->p.tol);
    if (code == 0 && g != NULL)
        code = grbl_run(g, &lines, what);
    else if (code == 0)
        for (size_t i = 0; i < lines.count; i++)
            puts(lines.line[i]);
    gcode_free(&lines);
    toolpath_free(&path);
    grbl_close(g);
    return code;
}

static int draw_file(stream_options *o, const char *file)
{
    toolpath_options how = planning_path(&o->p);
    drawing d = { 0 }, smooth = { 0 };
    talk t;

    keys_hasty(true);
    int code = planning_read(&o->p, &d, &smooth, file);
    keys_hasty(false);
    if (code == 0 && o->grbl)
        code = draw_gcode(o, file, &smooth, &how);
    else if (code == 0 && o->dry)
        code = dry_run(o, file, &d, &smooth);
    else if (code == 0 && (code = talk_open(&t, o->port, o->baud, o->wait, o->log)) == 0) {
        code = stream_drawing(o, file, &d, &smooth, &t);
        talk_close(&t);
    }
    drawing_free(&smooth);
    drawing_free(&d);
    return code;
}

static int run_stream(const tool_command *self, int argc, char **argv)
{
    stream_options o = { .baud = 115200, .wait = 5, .where = "host" };
    int first, code  = planning_start(&o.p, argc, argv);

    if (code != 0)
        return code;
    const tool_option options[] = {
        TALK_OPTIONS(o),
        PLANNING_OPTIONS(&o.p),
        TOOL_TEXT("plan", "host|chip", &o.where,
                  "host: spans are sent; chip: curves are, and the machine plans (host)"),
        TOOL_SWITCH("points", &o.points, "send sampled points, one per tick, instead of spans"),
        TOOL_SWITCH(
            "grbl", &o.grbl,
            "send G-code to a controller of grbl's kind, which plans; with --dry-run print it"),
        TOOL_SWITCH("g5", &o.g5,
                    "with --grbl: curves as G5, for controllers that have it, instead of arcs"),
        TOOL_SWITCH("dry-run", &o.dry, "plan for a usual machine, print a summary, move nothing"),
        TOOL_TEXT("record", "FILE", &o.record,
                  "the pulses that `loft simulate --record FILE` writes: measure the path error"),
        TOOL_TEXT("log", "FILE", &o.log, "write what passes on the line, in words"),
        TOOL_SWITCH("away", &o.away,
                    "the drawing leads away from the limit switches that are closed now"),
        TOOL_SWITCH("hold", &o.hold, "no FILE: slow down on the path and stop"),
        TOOL_SWITCH("resume", &o.resume, "no FILE: go on"),
        TOOL_SWITCH("abort", &o.abort, "no FILE: slow down on the path and end the job"),
        TOOL_OPTIONS_END
    };
    code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (o.port == NULL && !o.dry)
        return tool_error(EX_USAGE, "no --port: name the machine's port, or plan with --dry-run");

    o.chip = strcmp(o.where, "chip") == 0;
    if (!o.chip && strcmp(o.where, "host") != 0)
        return tool_error(EX_USAGE, "--plan %s: give host or chip", o.where);
    if (o.chip && o.points)
        return tool_error(
            EX_USAGE, "--points: a machine that plans takes curves: leave it, or give --plan host");

    const bool controls = o.hold || o.resume || o.abort;
    if (!controls && first + 1 != argc)
        return tool_error(EX_USAGE, "%s: see `loft stream --help`",
                          first < argc ? "more than one drawing"
                                       : "no drawing: name an SVG or CSV file, or -");
    if (o.hold + o.resume + o.abort > 1 || (controls && first < argc))
        return tool_error(
            EX_USAGE,
            "--hold, --resume and --abort take no other argument: see `loft stream --help`");
    if (o.port && !controls && strcmp(o.port, "-") == 0 && strcmp(argv[first], "-") == 0)
        return tool_error(EX_USAGE,
                          "both the drawing and the port are standard input: name one of them");
    keys_start(!controls && !o.dry && strcmp(argv[first], "-") != 0 &&
               (o.port == NULL || strcmp(o.port, "-") != 0));
    return controls ? control_machine(&o) : draw_file(&o, argv[first]);
}

const tool_command command_stream = {
    "stream", "FILE --port PORT", "a drawing becomes motion: plan it and stream it to a machine",
    "Keys while it runs: h holds, r resumes, a aborts, + and - change the override by 10 %\n"
    "(10..200), 0 makes it 100 %, s prints where things are; ^C holds and leaves, twice\n"
    "leaves at once. The machine never leaves the path. A job that was cut off continues\n"
    "where the machine stopped when the same command runs again.\n",
    run_stream
};

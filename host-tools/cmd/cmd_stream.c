/* host-tools/cmd/cmd_stream.c -- loft stream: sends a drawing to a machine
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmd/commands.h"
#include "wire/action_code.h"    /* LOFT_OUTPUTS_MOST */

#include "cmd/keys.h"           /* keys_start, keys_hasty */
#include "base/say.h"
#include "cmd/stream_grbl.h"     /* stream_grbl, stream_parts_find */
#include "plan/check.h"          /* check_print */
#include "plan/missing.h"        /* missing_tell */
#include "plan/planning.h"       /* planning_limit */
#include "cmd/run.h"            /* run_open */
#include "cmd/run_settings.h"
#include "cmd/report.h"         /* report_start */
#include "cmd/run_drawing.h"
#include "plan/toolpath.h"       /* toolpath_make */
#include "host/duration.h"      /* host_duration */

/* Plan the first portion of a part, from the position of the motors. */
static int plan_work(const stream_options *o, const plan_parts *all, size_t k,
                     const double start[ENGINE_AXES], const job_options *as, job_work *w)
{
    keys_hasty(true);
    const int code = parts_plan(tool_host(), &o->p, all, k, o->line.port ? o->line.port : "-",
                                start, o->chip, as, w);
    keys_hasty(false);
    return code;
}

static void print_plan(const job *j, const toolpath *path, double tol)
{
    char text[160], time[HOST_DURATION];

    printf("planned: %zu curve%s, %.3f m drawn, %.3f m travelled, %s, %zu %s, %s, job "
           "%08x\n",
           path->curves, tool_s(path->curves), path->drawn / 1000, path->travelled / 1000,
           host_duration(time, job_seconds(j), 1), j->count, job_words(j),
           job_words_of_plan(j, tol, text), (unsigned)j->head.id);
}

/* What a machine does beside motion. `s` NULL: a dry run, for one that does all of it. */
static struct job_does does_of(const stream_options *o, const loft_sender *s)
{
    const bool all         = s == NULL;
    struct job_does does   = { .s_max = o->p.machine.s_max, .spin_up = o->p.machine.spin_up };

    does.actions = !o->chip && !o->points && (all || s->machine.kinds & LOFT_TAKES_ACTIONS);
    does.outputs = all ? LOFT_OUTPUTS_MOST : s->machine.outputs;
    return does;
}

/* From the first part that is drawn. */
static missing_job asked_by(const stream_options *o, const plan_parts *all)
{
    return (missing_job){ all->file, &all->part[all->first], all->count - all->first, o->points,
                          o->chip };
}

/* Choose the options of a job for a machine with these limits. */
static int options_of(const stream_options *o, job_options *as)
{
    as->e    = o->p.e;
    as->kind = o->chip ? LOFT_CURVES : o->points ? LOFT_POINTS : LOFT_SPANS;
    planning_limit(&o->p, &as->limits);
    return 0;
}

/* What the plan of a job holds, for the last line of a program. */
static void take_worst(const job *j, double tol)
{
    const certify c = job_judged(j);
    double of;
    const double distance = job_distance(j, tol, &of);

    if (j->head.kind != LOFT_CURVES)
        report_certified(&c, distance, of);
}

static int finish_job(const char *file, job *j)
{
    keys_hasty(true);
    const int status = job_finish(tool_host(), j);
    keys_hasty(false);
    return status == LOFT_OK ? 0 : job_refuse(tool_host(), j, file, status, "");
}

static void print_page(const drawing *d)
{
    char words[160];

    (void)say(stdout, "drawing: %s\n", page_words(d, words));
}

/* Print what a part takes, and add it to the sum. */
static void print_part(const stream_options *o, const plan_parts *all, size_t k, const job_work *w,
                       toolpath *sum, double *seconds)
{
    const tools_part *p = &all->part[k];

    if (p->tool != NULL)
        (void)say(stdout, "tool %s: ", p->tool->name);
    else if (all->count > 1)
        printf("no tool: ");
    print_plan(&w->j, &w->path, o->p.tol);
    if (p->tool != NULL && *p->tool->pause != '\0')
        (void)say(stdout, "tool %s: before it: %s\n", p->tool->name, p->tool->pause);
    report_planned(&(report_job){ .file = all->file,
                                  .tool = p->tool ? p->tool->name : NULL,
                                  .path = &w->path,
                                  .tol  = o->p.tol,
                                  .id   = w->j.head.id },
                   job_seconds(&w->j), job_items(&w->j));
    take_worst(&w->j, o->p.tol);
    sum->curves += w->path.curves;
    sum->drawn += w->path.drawn;
    sum->travelled += w->path.travelled;
    *seconds += job_seconds(&w->j) + (p->tool ? p->tool->delay : 0);
}

/* Where the motors are when a planned job is over. */
static void end_of(const job *j, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = j->head.kind == LOFT_POINTS ? 65536.0 * j->last[i] / j->steps_per_mm[i]
                                             : j->last[i] / 65536.0;
}

static int dry_run(const stream_options *o, const drawing *d, const plan_parts *all)
{
    double start[ENGINE_AXES] = { 0, 0, 0 }, seconds = 0;
    job_options as = { .patch = NULL };
    toolpath sum = { 0 };
    char time[HOST_DURATION];

    planning_machine(&o->p, &as.limits);
    for (int i = 0; i < ENGINE_AXES; i++)
        as.steps_per_mm[i] = (int32_t)lround(o->p.machine.steps_per_mm[i] * 65536);
    int code = options_of(o, &as);
    as.does                 = does_of(o, NULL);
    const missing_job asked = asked_by(o, all);
    if (code == 0)
        code = missing_tell(tool_host(), &asked, &as.does);
    for (size_t k = all->first; k < all->count && code == 0; k++) {
        job_work w = { .path = { 0 } };
        code   = plan_work(o, all, k, start, &as, &w);
        if (code == 0)
            code = finish_job(all->file, &w.j);
        if (code == 0) {
            if (k == all->first)
                print_page(d);
            print_part(o, all, k, &w, &sum, &seconds);
            if (o->check)
                check_print(stdout, &o->p.machine, all->file, &all->part[k].smooth, &w.path,
                            o->p.feed);
            end_of(&w.j, start);
        }
        job_work_free(&w);
    }
    if (code == 0 && all->count - all->first > 1)
        printf("in all: %zu curve%s, %.3f m drawn, %.3f m travelled, %s\n", sum.curves,
               tool_s(sum.curves), sum.drawn / 1000, sum.travelled / 1000,
               host_duration(time, seconds, 1));
    return code;
}

/* Refuse what the machine cannot do. */
static int check_machine(const stream_options *o, const loft_sender *s)
{
    if (!o->chip || (s->machine.kinds & 1u << LOFT_CURVES && s->machine.curves > 0))
        return 0;
    return tool_error(EX_CONFIG,
                      "%s: this machine does not plan by itself: give --plan host, or build its "
                      "firmware with memory for a planner",
                      o->line.port);
}

static int plan_for(const stream_options *o, const plan_parts *all, size_t k,
                    const double start[ENGINE_AXES], const loft_sender *s, job_work *w)
{
    job_options as = { .patch = NULL };

    job_work_free(w);
    stream_machine(s, &as.limits);
    for (int i = 0; i < ENGINE_AXES; i++)
        as.steps_per_mm[i] = s->axis[i].steps_per_mm;
    const int code = options_of(o, &as);
    as.does        = does_of(o, s);
    return code == 0 ? plan_work(o, all, k, start, &as, w) : code;
}

/* If the machine has a job, it may be one of these. It is if its id equals that of this job,
 * planned from the same start. Then *at is its part, and *w the job. */
static int find_old(const stream_options *o, const plan_parts *all, const loft_sender *s,
                    job_work *w, size_t *at)
{
    double start[ENGINE_AXES];
    int code = 0;

    *at = all->count;
    stream_old_start(s, o->points, start);
    for (size_t k = all->first; k < all->count && code == 0 && s->machine.job != 0; k++) {
        code = plan_for(o, all, k, start, s, w);
        if (code == 0 && w->j.count > 0 && w->j.head.id == s->machine.job) {
            *at = k;
            break;
        }
    }
    return code;
}

/* Send the part that is planned, or else plan it from where the machine is. */
static int stream_part(const stream_options *o, const plan_parts *all, size_t k, bool planned,
                       talk *t, job_work *w)
{
    const loft_sender *s = &t->sender;
    double start[ENGINE_AXES];
    int code = 0;

    if (!planned) {
        stream_new_start(s, start);
        code = plan_for(o, all, k, start, s, w);
    }
    if (code == 0) {
        w->j.head.away = o->away ? s->closed : 0;
        code = stream_limits(t, o->p.machine.hard_stop > 0, &w->j.head);
    }
    if (code == 0) {
        const machine_tool *tool   = all->part[k].tool;
        const stream_subject about = { .file = all->file,
                                       .curves = w->path.curves,
                                       .drawn = w->path.drawn,
                                       .tol = o->p.tol,
                                       .d = &all->part[k].d,
                                       .record = o->record,
                                       .k = &o->p.machine.k,
                                       .port = o->line.port,
                                       .tool = tool ? tool->name : NULL,
                                       .path = &w->path };
        code = run_drawing(t, &w->j, &about);
        if (code == 0)
            take_worst(&w->j, o->p.tol);
    }
    return code;
}

/* Wait until the tool is in, and look where the machine is then. */
static int change(const stream_options *o, const machine_tool *tool, talk *t)
{
    const int code = run_change(tool, o->asks);

    if (code != 0)
        return code;
    return run_again(t, o->line.wait);
}

/* One job for each tool, one after the other. */
static int stream_drawing(const stream_options *o, const plan_parts *all, talk *t)
{
    job_work w      = { .path = { 0 } };
    size_t old  = all->count;
    int code    = check_machine(o, &t->sender);
    const struct job_does does = does_of(o, &t->sender);
    const missing_job asked    = asked_by(o, all);

    if (code == 0 && o->p.machine.laser > 0)
        code = missing_laser(tool_host(), &asked, &does);
    if (code == 0)
        code = missing_tell(tool_host(), &asked, &does);
    if (code == 0)
        code = find_old(o, all, &t->sender, &w, &old);
    for (size_t k = old < all->count ? old : all->first; k < all->count && code == 0; k++) {
        const machine_tool *tool = all->part[k].tool;
        if (k == old)
            (void)say(stderr, "%s%s%s", tool ? "tool " : "", tool ? tool->name : "",
                      tool ? ": " : "");
        else if (tool != NULL && !loft_state_busy(t->sender.ack.state))
            code = change(o, tool, t);
        if (code == 0)
            code = stream_part(o, all, k, k == old, t, &w);
    }
    job_work_free(&w);
    return code;
}

static int control_machine(const stream_options *o)
{
    const enum loft_verb verb = o->abort ? LOFT_ABORT : o->hold ? LOFT_HOLD : LOFT_RESUME;
    talk t;

    int code = run_open(&t, &o->line);
    if (code != 0)
        return code;
    code = run_control(&t, verb, &o->p.machine.k);
    talk_close(&t);
    return code;
}

static int read_file(stream_options *o, const char *file, drawing *d, drawing *smooth,
                     plan_parts *all)
{
    keys_hasty(true);
    o->p.passes = o->record == NULL;
    o->p.levels = !o->grbl && !o->points && !o->chip;
    int code = planning_read(tool_host(), &o->p, d, smooth, file);
    keys_hasty(false);
    if (code == 0 && o->chip && o->p.exact >= 0)
        code = tool_error(
            EX_CONFIG, "%s: G61: a machine that plans does not stop at corners: give --plan host",
            file);
    return code == 0 ? stream_parts_find(o, file, d, smooth, all) : code;
}

/* The machine may say that its spindle is a laser. Then the rows of a raster are to be lines. */
static int adopt(stream_options *o, const char *file, talk *t, drawing *d, drawing *smooth,
                 plan_parts *all)
{
    const bool laser = o->p.machine.laser > 0;
    int code         = run_settings_adopt(&o->p.machine, t);

    if (code == 0 && o->p.machine.laser > 0 && !laser && d->events > 0 && strcmp(file, "-") != 0) {
        drawing_free(smooth);
        drawing_free(d);
        code = read_file(o, file, d, smooth, all);
    }
    return code;
}

static int draw_file(stream_options *o, const char *file)
{
    drawing d = { 0 }, smooth = { 0 };
    plan_parts all;
    talk t;

    int code = read_file(o, file, &d, &smooth, &all);
    if (code == 0 && o->grbl)
        code = stream_grbl(o, &all);
    else if (code == 0 && o->dry)
        code = dry_run(o, &smooth, &all);
    else if (code == 0 && (code = run_open(&t, &o->line)) == 0) {
        if (o->p.file == NULL)
            code = adopt(o, file, &t, &d, &smooth, &all);
        if (code == 0)
            code = talk_certain(&t);
        if (code == 0)
            code = stream_drawing(o, &all, &t);
        talk_close(&t);
    }
    drawing_free(&smooth);
    drawing_free(&d);
    return code;
}

static const option stream_rows[] = {
    OPTION_HEADING("the machine and its line"),
    OPTION_GROUP(stream_options, line, talk_rows),
    OPTION_GROUP(stream_options, p, planning_rows),
    OPTION_HEADING("who plans, and what is sent"),
    { "plan", OPTION_CHOICE(stream_options, where), .choices = "host|chip", .standard = "host",
      .help = "host: spans are sent; chip: curves are, and the machine plans" },
    { "points", OPTION_FLAG(stream_options, points),
      .help = "send sampled points, one per tick, instead of spans" },
    { "grbl", OPTION_FLAG(stream_options, grbl),
      .help = "send G-code to a controller of grbl's kind, which plans; with --dry-run print it" },
    { "g5", OPTION_FLAG(stream_options, g5),
      .help = "with --grbl: curves as G5, for controllers that have it, instead of arcs" },
    OPTION_HEADING("without moving"),
    { "dry-run", OPTION_FLAG(stream_options, dry),
      .help = "plan for a usual machine, print a summary, move nothing" },
    { "check", OPTION_FLAG(stream_options, check),
      .help = "the same, and judge it: box, feeds, what an axis cannot do, rapids below 0" },
    OPTION_HEADING("what is told"),
    { "record", OPTION_FILE(stream_options, record), .value = "FILE",
      .help = "the pulses that `loft simulate --record FILE` writes: measure the path error" },
    { "log", OPTION_FILE(stream_options, line.log), .value = "FILE",
      .help = "write what passes on the line, in words" },
    { "view", OPTION_FLAG(stream_options, view),
      .help = "show the drawing, the numbers and the keys on the whole terminal" },
    { "json", OPTION_FLAG(stream_options, json),
      .help = "tell a program how it goes: JSON, one object a line, on standard output" },
    OPTION_HEADING("jobs that begin, stop and go on"),
    { "away", OPTION_FLAG(stream_options, away),
      .help = "the drawing leads away from the limit switches that are closed now" },
    { "from-tool", OPTION_TEXT(stream_options, from_tool), .value = "NAME",
      .help = "of a machine file with tools: leave out what the tools before it draw" },
    { "hold", OPTION_FLAG(stream_options, hold),
      .help = "no FILE: slow down on the path and stop" },
    { "resume", OPTION_FLAG(stream_options, resume), .help = "no FILE: go on" },
    { "abort", OPTION_FLAG(stream_options, abort),
      .help = "no FILE: slow down on the path and end the job" },
    { "file", OPTION_WORD(stream_options, file), .value = "DRAWING",
      .remedy = "more than one drawing" },
    OPTION_EXCLUDES("check", "grbl", "--check judges a plan, and --grbl leaves it to a controller"),
    OPTION_NEEDS("", "port|dry-run|check", "name the machine's port, or plan with --dry-run"),
    OPTION_EXCLUDES("plan=chip", "exact",
                    "a machine that plans does not stop at corners: give --plan host"),
    OPTION_EXCLUDES("plan=chip", "points",
                    "a machine that plans takes curves: leave --points, or give --plan host"),
    OPTION_NEEDS("", "file|hold|resume|abort", "name an SVG or CSV file, or -"),
    OPTION_EXCLUDES("hold|resume|abort", "file", "they take no drawing"),
    OPTION_EXCLUDES("hold", "resume|abort", NULL),
    OPTION_EXCLUDES("resume", "abort", NULL),
    OPTION_NEEDS("hold|resume|abort", "port", "name the machine's port"),
    OPTION_EXCLUDES("port=-&file=-", "",
                    "both the drawing and the port are standard input: name one of them"),
    OPTION_EXCLUDES("view", "json", "one is for people, one for programs"),
    OPTION_EXCLUDES("json", "grbl&dry-run", "standard output is the G-code of --grbl --dry-run"),
    OPTION_EXCLUDES("view", "dry-run|check|hold|resume|abort|file=-|port=-",
                    "it shows a drawing from a file while a machine draws it"),
    OPTION_EXCLUDES("json", "port=-", "standard output is the port: name another port"),
    { 0 }
};

static int run_stream(void *options)
{
    stream_options *o   = options;
    const bool controls = o->hold || o->resume || o->abort;
    int code            = planning_start(tool_host(), &o->p);

    if (code != 0)
        return code;
    o->dry  = o->dry || o->check;
    o->chip = o->where == 1;
    o->asks = !controls && !o->dry && strcmp(o->file, "-") != 0 && strcmp(o->line.port, "-") != 0;
    keys_start(o->asks);
    code = report_start(o->view ? REPORT_VIEW : o->json ? REPORT_JSON : REPORT_BAR);
    if (code == 0)
        code = controls ? control_machine(o) : draw_file(o, o->file);
    return report_exit(code);
}

const command command_stream = {
    .name = "stream",
    .arguments = "FILE --port PORT",
    .summary = "a drawing becomes motion: plan it and stream it to a machine",
    .detail =
        "Keys while it runs: h holds, r resumes, a aborts, + and - change the override by 10 %\n"
        "(10..200), 0 makes it 100 %, s prints where things are; ^C holds and leaves, twice\n"
        "leaves at once. The machine never leaves the path. A job that was cut off continues\n"
        "where the machine stopped when the same command runs again. A machine that was restarted\n"
        "in a job must be homed or zeroed before: $XDG_STATE_HOME/loft, or ~/.local/state/loft,\n"
        "has a note of each job that has not ended.\n\n"
        "  loft stream drawing.svg --dry-run                    how long it takes, how large it "
        "is\n"
        "  loft stream drawing.svg --port /dev/ttyUSB0          draw it\n"
        "  loft stream drawing.svg --page A4 --fit --margin 10 --port /dev/ttyUSB0\n"
        "  loft stream part.nc --check                          judge a program of G-code\n"
        "  loft stream part.nc --grbl --port /dev/ttyACM0       on a controller of grbl's kind\n"
        "  loft stream --hold --port /dev/ttyUSB0               stop from another terminal\n",
    .options = stream_rows,
    .size = sizeof(stream_options),
    .run = run_stream,
    .talks = true,
};

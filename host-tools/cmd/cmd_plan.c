/* host-tools/cmd/cmd_plan.c -- loft plan: how fast a drawing can be drawn, and what limits it
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmd/commands.h"
#include "base/progress.h"       /* progress_clear_any */
#include "base/create.h"      /* create_refused */
#include "base/say.h"
#include "base/source.h"         /* source_name */
#include "draw/plan_plot.h"      /* plan_plot */
#include "host/duration.h"      /* host_duration */
#include "plan/certify.h"        /* certify_make */
#include "plan/planning.h"
#include "plan/trace.h"

typedef struct {
    planning p;
    double rate;                    /* rows per second; 0: none */
    const char *output, *picture;
    double size;
    bool total, spans, certify;
    const char *file;
} plan_options;


/* What is printed while the drawing is planned. */
typedef struct {
    const plan_options *o;
    const drawing *d;
    const toolpath *path;
    const trace *t;
    FILE *rows;                     /* NULL: none */
    uint64_t ticks;                 /* of the spans before */
    double row;                     /* the next one */
    engine_span last;
    double begin, end;              /* s, of the last span */
    bool table;
    trace_part drawn, travelled, all;
} report;


// Table
// -----

static void print_row(const trace *t, const char *name, const char *line, const trace_part *p)
{
    char words[160], time[HOST_DURATION];

    trace_words(t, p, words, sizeof words);
    host_duration(time, p->seconds, 1);
    (void)say(stdout, "%-8s %6s %11.3f %10.3f %9.2f  %s%s%s\n", name, line, p->length, p->seconds,
              p->top, words, strchr(time, ':') ? "; takes " : "", strchr(time, ':') ? time : "");
}

static void take_part(void *context, size_t n, const trace_part *p)
{
    report *r        = context;
    const bool draws = r->path->curve[n] != TOOLPATH_TRAVEL;
    char name[24] = "travel", line[16] = "";

    progress_clear_any();
    if (n == 0)
        printf("%-8s %6s %11s %10s %9s  %s\n", "curve", "line", "mm", "s", "top mm/s",
               "limited by, of the time");
    if (draws) {
        snprintf(name, sizeof name, "%zu", r->path->curve[n] + 1);
        snprintf(line, sizeof line, "%u", r->d->curve[r->path->curve[n]].line);
    }
    if (!r->o->total)
        print_row(r->t, name, line, p);
    trace_add(draws ? &r->drawn : &r->travelled, p);
    trace_add(&r->all, p);
}

static void print_sums(const report *r)
{
    char words[160];

    print_row(r->t, "drawn", "", &r->drawn);
    print_row(r->t, "travel", "", &r->travelled);
    print_row(r->t, "in all", "", &r->all);
    (void)say(stdout, "drawing: %s\n", page_words(r->d, words));
}


// Rows of numbers
// ---------------

static void put_axes(FILE *out, const double v[ENGINE_AXES], int digits)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        fprintf(out, ",%.*f", digits, fabs(v[i]) < 0.5 * pow(10, -digits) ? 0 : v[i]);
}

static void put_row(FILE *out, const trace_motion *m, double seconds)
{
    fprintf(out, "%.6f", seconds);
    put_axes(out, m->tool.x, 6);
    put_axes(out, m->tool.v, 5);
    put_axes(out, m->tool.a, 4);
    putc('\n', out);
}

/* Rows from time 0 at equal intervals, as far as this span says them. */
static void put_rows(report *r, const engine_span *s, double begin, double end)
{
    const double rate = r->o->rate;
    trace_motion m;

    if (r->ticks == 0)
        fprintf(r->rows, "t,x,y,z,vx,vy,vz,ax,ay,az\n");
    for (; r->row / rate < end - 1e-9; r->row++) {
        if (r->row / rate < begin)
            trace_in(r->t, &r->last, r->begin, r->end, r->row / rate, &m);
        else
            trace_in(r->t, s, begin, end, r->row / rate, &m);
        put_row(r->rows, &m, r->row / rate);
    }
}

static void put_end(const report *r)
{
    trace_motion m;

    trace_in(r->t, &r->last, r->begin, r->end, r->t->seconds, &m);
    put_row(r->rows, &m, r->t->seconds);
}

/* A span exactly: a coordinate is a whole number of 2^-16 mm. */
static void put_span(const report *r, const engine_span *s)
{
    const char *axes = kinematics_axes(r->t->joints->k);
    FILE *out        = r->rows;

    if (r->ticks == 0) {
        fprintf(out, "start_s,duration_s");
        for (int i = 0; i < ENGINE_AXES; i++)
            for (int k = 0; k < 4; k++)
                fprintf(out, ",%c%d", axes[i], k);
        putc('\n', out);
    }
    fprintf(out, "%.15g,%.15g", (double)r->ticks / r->t->limits.tick_hz,
            (double)s->ticks / r->t->limits.tick_hz);
    for (int i = 0; i < ENGINE_AXES; i++)
        for (int k = 0; k < 4; k++)
            fprintf(out, ",%.20g", s->p[k][i] / 65536.0);
    putc('\n', out);
}

static void take_span(void *context, const engine_span *s, double begin, double end)
{
    report *r = context;

    if (r->o->spans)
        put_span(r, s);
    else
        put_rows(r, s, begin, end);
    r->ticks += s->ticks;
    r->last  = *s;
    r->begin = begin;
    r->end   = end;
}

static int open_rows(report *r)
{
    const char *name = r->o->output;

    if (!(r->o->rate > 0) && !r->o->spans)
        return 0;
    r->rows = name == NULL ? stdout : create_file(name);
    return r->rows != NULL ? 0 : create_refused(tool_host(), name, errno);
}

static int close_rows(const report *r)
{
    if (r->rows == NULL || r->rows == stdout)
        return 0;
    const bool bad = ferror(r->rows) != 0;
    if (fclose(r->rows) != 0 || bad)
        return tool_error(EX_IOERR, "%s: %s: is the disk full? write elsewhere", r->o->output,
                          strerror(errno));
    return 0;
}


// All of it
// ---------

/* Judge the plan by the drawing as it is in the file. */
static int certify_drawing(const plan_options *o, const toolpath *drawn, const toolpath *path,
                           const trace *t)
{
    const certify_plan plan = { .k = t->joints->k,
                                .limits = &t->limits,
                                .span = t->span,
                                .spans = t->count,
                                .move = drawn->move,
                                .moves = drawn->count,
                                .planned = path->move,
                                .planned_moves = path->count,
                                .tol = o->p.tol,
                                .corner = o->p.corner };
    certify c;

    certify_make(&c, &plan);
    return certify_print(stdout, &c, &plan, kinematics_axes(plan.k))
               ? 0
               : tool_error(EX_SOFTWARE, "%s: the plan is not within its bounds: see MISSED",
                            o->file);
}

/* Plan, and print what is wanted meanwhile. */
static int trace_drawing(const plan_options *o, const engine_limits *limits, report *r, trace *t,
                         joints *of)
{
    const bool keep = o->picture != NULL || o->certify;
    int code        = open_rows(r);

    if (code != 0)
        return code;
    r->table = !o->certify && r->rows != stdout;
    const trace_sink sink = { .context = r,
                              .span    = r->rows != NULL ? take_span : NULL,
                              .part    = r->table ? take_part : NULL };
    const int status = trace_make(tool_host(), t, o->p.e, limits, r->path, of, &sink, keep);
    if (status == 0 && r->rows != NULL && !o->spans && t->count > 0)
        put_end(r);
    code = close_rows(r);
    if (status == TRACE_STOPPED)
        return EX_TEMPFAIL;
    return status != 0 ? tool_error(EX_DATAERR, "%s: cannot be planned: %s", o->file,
                                    engine_status(status, ENGINE_NO_MOTION))
                       : code;
}

/* Dwells and tool actions are excluded from the times. */
static void tell_times(const plan_options *o, const drawing *d)
{
    if (d->events > 0)
        (void)tool_error(EX_OK,
                         "%s:%u: G4, M0, M3 and the like (%zu times): the times are of motion "
                         "without them: `loft stream --dry-run` counts waits and stops",
                         source_name(o->file), d->event[0].line, d->events);
}

static int report_plan(const plan_options *o, const report *r, const toolpath *drawn)
{
    const plan_picture picture = { .d = r->d,
                                   .path = r->path,
                                   .t = r->t,
                                   .name = o->file,
                                   .output = o->picture,
                                   .size = o->size };
    int code = 0;

    if (o->picture != NULL)
        code = plan_plot(tool_host(), &picture);
    if (code == 0 && o->certify)
        code = certify_drawing(o, drawn, r->path, r->t);
    if (code == 0 && r->table)
        print_sums(r);
    if (code == 0 && r->table)
        tell_times(o, r->d);
    return code;
}

/* Plan `d`, which was made from `drawn`. */
static int plan_drawing(const plan_options *o, const drawing *d, const drawing *drawn)
{
    const double start[ENGINE_AXES] = { 0, 0, 0 };
    toolpath_options how = planning_path(&o->p);
    engine_limits limits;
    toolpath path, asked = { .count = 0 };
    joints of;
    trace t  = { .count = 0 };
    report r = { .o = o, .d = d, .path = &path, .t = &t };

    planning_machine(&o->p, &limits);
    planning_limit(&o->p, &limits);
    (void)planning_start_at(&o->p, start, &how);
    toolpath_make(&path, d, &how);
    if (o->certify)
        toolpath_make(&asked, drawn, &how);
    int code = planning_joints(tool_host(), &o->p, o->file, d, start, false, &limits, &path, &of);
    if (code == 0)
        code = trace_drawing(o, &limits, &r, &t, &of);
    if (code == 0)
        code = report_plan(o, &r, &asked);
    trace_free(&t);
    joints_free(&of);
    toolpath_free(&asked);
    toolpath_free(&path);
    return code;
}

static const option plan_rows[] = {
    OPTION_GROUP(plan_options, p, planning_rows),
    OPTION_HEADING("what is printed and drawn"),
    { "csv", OPTION_NUMBER(plan_options, rate), .least = 0.001, .most = 1e6, .value = "RATE",
      .unit = "Hz",
      .help = "rows t,x,y,z,vx,vy,vz,ax,ay,az at RATE Hz, in place of the table, or with -o FILE "
              "beside it" },
    { "spans", OPTION_FLAG(plan_options, spans),
      .help = "the spans, in place of the table: start_s,duration_s and the Bezier values of each "
              "motor, exactly" },
    { "certify", OPTION_FLAG(plan_options, certify),
      .help = "judge the plan, in place of the table: the worst of each limit at any instant, and "
              "of the distances between motion and drawing, as parts of --tol or --corner; exit "
              "code 70 if one is beyond its bound" },
    { "output", OPTION_FILE(plan_options, output), .value = "FILE",
      .help = "or -o: where the rows go (standard output)" },
    { "plot", OPTION_FILE(plan_options, picture), .value = "FILE",
      .help = "a picture, .png .svg or .pdf: the path by speed; speed, acceleration and jerk over "
              "time" },
    { "size", OPTION_NUMBER(plan_options, size), .least = 100, .most = 20000, .value = "WIDTH",
      .standard = "1600", .help = "px of a PNG, points of the others" },
    { "total", OPTION_FLAG(plan_options, total), .help = "only the sums, not every curve" },
    { "file", OPTION_WORD(plan_options, file), .least = 1, .value = "DRAWING",
      .remedy = "name one, an SVG, CSV or .loft file, or -" },
    OPTION_EXCLUDES("spans", "csv", "both are rows"),
    OPTION_NEEDS("output", "csv|spans", "it is for rows; --plot is for a picture"),
    OPTION_NEEDS("certify&csv|certify&spans", "output", "--certify prints a table"),
    { 0 }
};

/* Refuse what cannot be drawn or judged. Returns 0, or an exit code after printing one line. */
static int check_plan(const plan_options *o)
{
    bool png;

    if (o->picture != NULL && !plot_known(o->picture, &png))
        return tool_error(EX_USAGE, "--plot %s: give a name that ends with .png, .svg or .pdf",
                          o->picture);
    if (o->certify && !o->p.machine.k.kind->linear)
        return tool_error(EX_USAGE,
                          "--certify: the tool of a %s machine does not move on cubics: give the "
                          "limits to a cartesian one",
                          kinematics_name(&o->p.machine.k));
    const int code = create_check(tool_host(), o->picture);
    return code ? code : create_check(tool_host(), o->output);
}

static int run_plan(void *options)
{
    plan_options *o = options;
    drawing d = { .count = 0 }, smooth = { .count = 0 };
    int code = planning_start(tool_host(), &o->p);

    if (code == 0)
        code = check_plan(o);
    if (code != 0)
        return code;
    o->p.passes = !o->certify;
    o->p.levels = true;
    code = planning_read(tool_host(), &o->p, &d, &smooth, o->file);
    if (code == 0)
        code = plan_drawing(o, &smooth, &d);
    drawing_free(&smooth);
    drawing_free(&d);
    return code;
}

const command command_plan = {
    .name = "plan",
    .arguments = "FILE [--machine FILE] [--csv RATE | --spans [-o FILE]] [--certify] [--plot FILE]",
    .summary = "how fast a drawing can be drawn, and what limits it",
    .detail =
        "Plans like `loft stream` and analyses the result: for every curve and travel, and in\n"
        "total, the length, time, top speed, and the causes that limit it, with their shares of\n"
        "the time: the feed; speed, acceleration or jerk of an axis; acceleration across the path\n"
        "(curvature); corners; stops. Where no limit is used up, the cause is the previous or the\n"
        "next one, whichever is closer in time.\n",
    .options = plan_rows,
    .size = sizeof(plan_options),
    .run = run_plan,
};

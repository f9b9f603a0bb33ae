/* host-tools/cmd/cmd_plan.c -- loft plan: how fast a drawing can be drawn, and what limits it
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "draw/plan_plot.h"      /* plan_plot */
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


// Table
// -----

static int print_row(const trace *t, const char *name, const char *line, const trace_part *p)
{
    char words[160];

    trace_words(t, p, words, sizeof words);
    return printf("%-8s %6s %11.3f %10.3f %9.2f  %s\n", name, line, p->length, p->seconds, p->top,
                  words);
}

static void print_table(const plan_options *o, const drawing *d, const toolpath *path,
                        const trace *t)
{
    trace_part all = { .length = 0 }, drawn = all, travelled = all;

    printf("%-8s %6s %11s %10s %9s  %s\n", "curve", "line", "mm", "s", "top mm/s",
           "limited by, of the time");
    for (size_t k = 0; k < path->count; k++) {
        const bool draws = path->curve[k] != TOOLPATH_TRAVEL;
        char name[24] = "travel", line[16] = "";
        if (draws) {
            snprintf(name, sizeof name, "%zu", path->curve[k] + 1);
            snprintf(line, sizeof line, "%u", d->curve[path->curve[k]].line);
        }
        if (!o->total)
            print_row(t, name, line, &t->part[k]);
        trace_add(draws ? &drawn : &travelled, &t->part[k]);
        trace_add(&all, &t->part[k]);
    }
    print_row(t, "drawn", "", &drawn);
    print_row(t, "travel", "", &travelled);
    print_row(t, "in all", "", &all);
}


// Rows of numbers
// ---------------

static void put_axes(FILE *out, const double v[ENGINE_AXES], int digits)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        fprintf(out, ",%.*f", digits, fabs(v[i]) < 0.5 * pow(10, -digits) ? 0 : v[i]);
}

static void put_row(FILE *out, const trace *t, double seconds, size_t *near)
{
    trace_motion m;

    trace_at(t, seconds, near, &m);
    fprintf(out, "%.6f", seconds);
    put_axes(out, m.tool.x, 6);
    put_axes(out, m.tool.v, 5);
    put_axes(out, m.tool.a, 4);
    putc('\n', out);
}

/* Print rows from time 0 at equal intervals, and the end. */
static void put_rows(FILE *out, const trace *t, double rate)
{
    size_t near = 0;

    fprintf(out, "t,x,y,z,vx,vy,vz,ax,ay,az\n");
    for (double k = 0; k / rate < t->seconds - 1e-9; k++)
        put_row(out, t, k / rate, &near);
    put_row(out, t, t->seconds, &near);
}

/* Print the spans exactly: a coordinate is a whole number of 2^-16 mm. */
static void put_spans(FILE *out, const trace *t)
{
    const char *axes = kinematics_axes(t->joints->k);
    double begin = 0;

    fprintf(out, "start_s,duration_s");
    for (int i = 0; i < ENGINE_AXES; i++)
        for (int k = 0; k < 4; k++)
            fprintf(out, ",%c%d", axes[i], k);
    putc('\n', out);
    for (size_t n = 0; n < t->count; n++) {
        const engine_span *s = &t->span[n];
        fprintf(out, "%.15g,%.15g", begin / t->limits.tick_hz,
                (double)s->ticks / t->limits.tick_hz);
        for (int i = 0; i < ENGINE_AXES; i++)
            for (int k = 0; k < 4; k++)
                fprintf(out, ",%.20g", s->p[k][i] / 65536.0);
        putc('\n', out);
        begin += s->ticks;
    }
}

static void put_lines(FILE *out, const plan_options *o, const trace *t)
{
    if (o->spans)
        put_spans(out, t);
    else
        put_rows(out, t, o->rate);
}

static int write_lines(const plan_options *o, const trace *t)
{
    const char *name = o->output;
    FILE *out = fopen(name, "w");

    if (out == NULL)
        return tool_error(EX_CANTCREAT, "%s: cannot be written: %s", name, strerror(errno));
    put_lines(out, o, t);
    const bool bad = ferror(out) != 0;
    if (fclose(out) != 0 || bad)
        return tool_error(EX_IOERR, "%s: %s: is the disk full? write elsewhere", name,
                          strerror(errno));
    return 0;
}


// All of it
// ---------

static void print_page(const plan_options *o, const drawing *d, const toolpath *path,
                       const trace *t)
{
    char words[160];

    print_table(o, d, path, t);
    printf("drawing: %s\n", page_words(d, words));
}

/* Judge the plan by the drawing as it is in the file. */
static int certify_drawing(const plan_options *o, const toolpath *path, const trace *t)
{
    const certify_plan plan = { .k = t->joints->k,
                                .limits = &t->limits,
                                .span = t->span,
                                .spans = t->count,
                                .move = path->move,
                                .moves = path->count,
                                .tol = o->p.tol };
    certify c;

    certify_make(&c, &plan);
    return certify_print(&c, &plan, kinematics_axes(plan.k))
               ? 0
               : tool_error(EX_SOFTWARE, "%s: the plan is not within its bounds: see MISSED",
                            o->file);
}

static int report_plan(const plan_options *o, const drawing *d, const toolpath *path,
                       const toolpath *drawn, const trace *t)
{
    const bool lines = o->rate > 0 || o->spans;
    int code = 0;

    if (lines && o->output != NULL)
        code = write_lines(o, t);
    if (code == 0 && o->picture != NULL) {
        const plan_picture p = {
            .d = d, .path = path, .t = t, .name = o->file, .output = o->picture, .size = o->size
        };
        code = plan_plot(&p);
    }
    if (code == 0 && o->certify)
        code = certify_drawing(o, drawn, t);
    else if (code == 0 && lines && o->output == NULL)
        put_lines(stdout, o, t);
    else if (code == 0)
        print_page(o, d, path, t);
    return code;
}

/* Plan `d`, which was made from `drawn`. */
static int plan_drawing(const plan_options *o, const drawing *d, const drawing *drawn)
{
    const double start[ENGINE_AXES] = { 0, 0, 0 };
    toolpath_options how = planning_path(&o->p);
    engine_limits limits;
    toolpath path, asked;
    joints of;
    trace t = { .count = 0 };

    planning_machine(&o->p, &limits);
    planning_limit(&o->p, &limits);
    (void)planning_start_at(&o->p, start, &how);
    toolpath_make(&path, d, &how);
    toolpath_make(&asked, drawn, &how);
    int code = planning_joints(&o->p, o->file, d, start, false, &limits, &path, &of), status = 0;
    if (code == 0)
        status = trace_make(&t, o->p.e, &limits, &path, &of);
    if (status != 0)
        code = tool_error(EX_DATAERR, "%s: cannot be planned: %s", o->file, engine_status(status));
    else if (code == 0)
        code = report_plan(o, d, &path, &asked, &t);
    trace_free(&t);
    joints_free(&of);
    toolpath_free(&asked);
    toolpath_free(&path);
    return code;
}

/* Do the options fit together? Returns 0, or an exit code after printing one line. */
static int check_options(const plan_options *o)
{
    const enum engine_kinematics kind = o->p.machine.k.kind;
    bool png;

    if (o->spans && o->rate > 0)
        return tool_error(EX_USAGE, "--spans --csv: are both rows: give one of them");
    if (o->output != NULL && !(o->rate > 0) && !o->spans)
        return tool_error(EX_USAGE,
                          "-o %s: is for rows: give --csv RATE or --spans as well, or --plot FILE "
                          "for a picture",
                          o->output);
    if (o->picture != NULL && !plot_known(o->picture, &png))
        return tool_error(EX_USAGE, "--plot %s: give a name that ends with .png, .svg or .pdf",
                          o->picture);
    if (o->certify && (o->rate > 0 || o->spans) && o->output == NULL)
        return tool_error(EX_USAGE, "--certify: prints a table: give -o FILE for the rows");
    if (o->certify && kind != ENGINE_CARTESIAN && kind != ENGINE_COREXY)
        return tool_error(EX_USAGE,
                          "--certify: the tool of a %s machine does not move on cubics: give the "
                          "limits to a cartesian one",
                          kinematics_name(&o->p.machine.k));
    return 0;
}

static int run_plan(const tool_command *self, int argc, char **argv)
{
    plan_options o = { .size = 1600 };
    drawing d = { .count = 0 }, smooth = { .count = 0 };
    int first, code = planning_start(&o.p, argc, argv);

    if (code != 0)
        return code;
    const tool_option options[] = {
        PLANNING_OPTIONS(&o.p),
        TOOL_NUMBER("csv", "RATE", &o.rate, 0.001, 1e6,
                    "rows t,x,y,z,vx,vy,vz,ax,ay,az at RATE Hz, in place of the table, or with -o "
                    "FILE beside it"),
        TOOL_SWITCH("spans", &o.spans,
                    "the spans, in place of the table: start_s,duration_s and the Bezier values of "
                    "each motor, exactly"),
        TOOL_SWITCH("certify", &o.certify,
                    "judge the plan, in place of the table: the worst of each limit at any "
                    "instant, and of the distances between motion and drawing; exit code 70 if one "
                    "is beyond its bound"),
        TOOL_TEXT("output", "FILE", &o.output, "or -o: where the rows go (standard output)"),
        TOOL_TEXT("plot", "FILE", &o.picture,
                  "a picture, .png .svg or .pdf: the path by speed; speed, acceleration and jerk "
                  "over time"),
        TOOL_NUMBER("size", "WIDTH", &o.size, 100, 20000,
                    "px of a PNG, points of the others (1600)"),
        TOOL_SWITCH("total", &o.total, "only the sums, not every curve"),
        TOOL_OPTIONS_END
    };
    code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first + 1 != argc)
        return tool_error(EX_USAGE, "%s: see `loft plan --help`",
                          first < argc ? "more than one drawing"
                                       : "no drawing: name an SVG, CSV or .loft file, or -");
    if ((code = check_options(&o)) != 0)
        return code;
    o.file = argv[first];
    code = planning_read(&o.p, &d, &smooth, o.file);
    if (code == 0)
        code = plan_drawing(&o, &smooth, &d);
    drawing_free(&smooth);
    drawing_free(&d);
    return code;
}

const tool_command command_plan = {
    "plan", "FILE [--machine FILE] [--csv RATE | --spans [-o FILE]] [--certify] [--plot FILE]",
    "how fast a drawing can be drawn, and what limits it",
    "Plans like `loft stream` and analyses the result: for every curve and travel, and in\n"
    "total, the length, time, top speed, and the causes that limit it, with their shares of\n"
    "the time: the feed; speed, acceleration or jerk of an axis; acceleration across the path\n"
    "(curvature); corners; stops. Where no limit is used up, the cause is the previous or the\n"
    "next one, whichever is closer in time.\n",
    run_plan
};

/* host-tools/cmd/cmd_mill.c -- loft mill: the path of a cutter over surfaces, as a curve in space
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "base/create.h"      /* create_check */
#include "base/progress.h"
#include "base/say.h"
#include "base/source.h"        /* source_name */
#include "cmd/mill_chip.h"      /* mill_chip_run */
#include "geometry/surface_text.h"
#include "mill/left.h"
#include "mill/stock.h"
#include "draw/surface_plot.h"
#include "engine/mill.h"
#include "geometry/print.h"       /* print_point */
#include "engine/surface.h"
#include "num/status.h"         /* LOFT_ERR_ARG */
#include "mill/mill_trim.h"

typedef struct {
    mill_order o;
    const char *name;           /* of the tool, as given */
    stock block;
} tool_wish;

/* ball:6, flat:6, bull:6:1 */
static bool parse_tool(const char *text, void *out)
{
    static const char *const kinds[] = { "ball:", "flat:", "bull:" };
    tool_wish *w = out;
    double diameter = 0, corner = 0;
    char rest = 0;

    for (int k = 0; k < 3; k++) {
        const size_t length = strlen(kinds[k]);
        if (strncmp(text, kinds[k], length) != 0)
            continue;
        const int read = k < 2 ? sscanf(text + length, "%lf%c", &diameter, &rest)
                               : sscanf(text + length, "%lf:%lf%c", &diameter, &corner, &rest);
        if (read != (k < 2 ? 1 : 2) ||
            !(diameter >= 0.05 && diameter <= 250 && corner >= 0 && corner <= diameter / 2))
            break;
        w->o.radius = diameter / 2;
        w->o.corner = k == 0 ? diameter / 2 : corner;
        w->name = text;
        return true;
    }
    return false;
}

/* 0.5, cusp:0.01 */
static bool parse_step(const char *text, void *out)
{
    mill_order *o = &((tool_wish *)out)->o;
    const bool cusp = strncmp(text, "cusp:", 5) == 0;
    char *end;

    o->cusp = o->step = 0;
    return (cusp ? option_number_at(text + 5, 0.0005, 60, &o->cusp, &end)
                 : option_number_at(text, 0.001, 1000, &o->step, &end)) &&
           *end == '\0';
}

/* straight, ramp:5, helix:2, helix:2:5 */
static bool parse_entry(const char *text, void *out)
{
    tool_wish *w = out;
    double angle = 3, radius = 1;
    char rest = 0;

    if (strcmp(text, "straight") == 0) {
        w->o.entry = MILL_STRAIGHT;
        return true;
    }
    const bool ramp  = sscanf(text, "ramp:%lf%c", &angle, &rest) == 1,
               helix = strncmp(text, "helix:", 6) == 0 &&
                       (sscanf(text, "helix:%lf%c", &radius, &rest) == 1 ||
                        sscanf(text, "helix:%lf:%lf%c", &radius, &angle, &rest) == 2);
    if (!(ramp || helix) || !(angle >= 0.5 && angle <= 45 && radius >= 0.05 && radius <= 125))
        return false;
    w->o.entry  = ramp ? MILL_RAMP : MILL_HELIX;
    w->o.slope  = tan(angle * acos(-1) / 180);
    w->o.around = radius;
    return true;
}

static void show(void *context, double share)
{
    progress *const bar = context;

    if (bar->shown)
        progress_show(bar, share, "milling");
}

static double way_of(const mill_cut *p)
{
    double sum = 0;

    for (size_t i = 1; i < p->count; i++)
        sum += sqrt(pow(p->point[i][0] - p->point[i - 1][0], 2) +
                    pow(p->point[i][1] - p->point[i - 1][1], 2) +
                    pow(p->point[i][2] - p->point[i - 1][2], 2));
    return sum;
}

/* The path, below what is known of it. */
static int print_path(const engine *e, const tool_wish *w, const mill_cut *p, const mill_report *r)
{
    const print_options out = { e, true };

    printf("# %s, %zu lines, %zu points, %.1f mm, %.1f of it between lines\n", w->name, r->lines,
           p->count, way_of(p), r->ways);
    printf("# cuts below the surface: none, proved for each of %zu chords\n",
           p->count > 0 ? p->count - 1 : 0);
    printf(w->o.pattern == MILL_WATERLINE ? "# beside the surface: at most %g\n"
                                          : "# above the lowest way: at most %g\n",
           w->o.tol);
    if (r->cusp > 0)
        printf("# cusps: at most %.6f, asked %g\n", ceil(r->cusp * 1e6) / 1e6, w->o.cusp);
    if (p->count > 0) {
        printf("# left on the surfaces: at most %.4f\n", ceil(r->left * 1e4) / 1e4);
        printf(r->hollow > r->reached
                   ? "# left in hollows tighter than the tool: at most %.4f\n"
                   : "# left in hollows tighter than the tool: no more than %.4f\n",
               ceil(fmax(r->hollow, r->reached) * 1e4) / 1e4);
    }
    if (w->o.entry != MILL_STRAIGHT)
        printf("# entries: %zu by a helix, %zu by a ramp, %zu straight down\n",
               r->entries[MILL_HELIX], r->entries[MILL_RAMP], r->entries[MILL_STRAIGHT]);
    if (w->block.given) {
        const double *const d = w->block.size, *const low = w->block.low;
        printf("# out of --stock %.7gx%.7gx%.7g@%.7g,%.7g,%.7g, in one pass through all of it\n",
               d[0], d[1], d[2], low[0], low[1], low[2]);
    }
    if (p->count > 0)
        puts("line");
    for (size_t i = 0; i < p->count; i++)
        print_point((void *)&out, p->point[i]);
    return ferror(stdout) ? EX_IOERR : EX_OK;
}

static int refuse(const char *file, const surfaces *all, const mill_report *r, int status)
{
    if (r->failed < all->count) {
        const surface *s = &all->surface[r->failed];
        if (status == LOFT_ERR_ARG && (s->kind == SURFACE_SPATCH || s->kind == SURFACE_GB))
            return tool_error(EX_DATAERR,
                              "%s:%u: %s: cannot be milled: its bends have no bounds: give "
                              "wachspress coordinates and a convex domain",
                              file, s->line, surface_name(s->kind));
        if (status == LOFT_ERR_ARG)
            return tool_error(EX_DATAERR,
                              "%s:%u: %s: cannot be milled: give tensor, bicubic, coons, triangle, "
                              "pn, octant, spatch, toric, basepoint, ring or gb",
                              file, s->line, surface_name(s->kind));
        return tool_error(EX_DATAERR, "%s:%u: %s: %s", file, s->line, surface_name(s->kind),
                          surface_status(s, status));
    }
    if (status == LOFT_SINGULAR)
        return tool_error(EX_DATAERR,
                          "%s: nothing is left inside of the loops: --trim takes mm, "
                          "--trim-uv 0 to 1",
                          file);
    return tool_error(EX_DATAERR, "%s: --tool, --step, --area: %s", file,
                      engine_status(status, "out of bounds: give numbers above 0"));
}

static int mill_surfaces(const engine *e, tool_wish *w, const char *file)
{
    engine_mill *const run = e == &engine_q16   ? engine_mill_q16
                             : e == &engine_f32 ? engine_mill_f32
                                                : engine_mill_f64;
    surfaces all = { 0 };
    mill_cuts path = { 0 };
    progress bar;
    mill_report r;
    int code = surfaces_read_only(tool_host(), &all, file);

    const bool by_uv = w->o.parametric || (w->o.trim.count > 0 && !w->o.trim.plane);
    for (size_t k = 0; k < all.count && code == 0 && by_uv; k++)
        if (surface_is_sided(&all.surface[k]))
            code = tool_error(
                EX_DATAERR, "%s:%u: %s: has no u and v: give --trim, and --along x or y",
                source_name(file), all.surface[k].line, surface_name(all.surface[k].kind));
    if (code == 0 && w->block.given)
        code = stock_place(tool_host(), &w->block, &all, &w->o.trim, source_name(file));
    if (code == 0) {
        w->o.stocked  = w->block.given;
        w->o.stock[0] = w->block.low[2];
        w->o.stock[1] = w->block.low[2] + w->block.size[2];
        progress_start(&bar, 1);
        w->o.tell = show;
        w->o.context = &bar;
        const int status = run(&all, &w->o, &path, &r);
        progress_clear(&bar);
        code = status != 0       ? refuse(source_name(file), &all, &r, status)
               : w->block.given
                   ? stock_holds(tool_host(), &w->block, &path.cut[0], source_name(file))
                   : 0;
        if (code == 0)
            code = print_path(e, w, &path.cut[0], &r);
    }
    mill_cuts_free(&path);
    surfaces_free(&all);
    return code;
}

/* A picture of the surfaces, coloured by what a machine left on them. */
static int plot_left(tool_wish *w, const char *file, const char *record_file, const char *output)
{
    surfaces all = { 0 };
    record r = { 0 };
    left_over l;
    int code = surfaces_read_only(tool_host(), &all, file);

    if (code == 0 && w->block.given)
        code = stock_place(tool_host(), &w->block, &all, &w->o.trim, source_name(file));
    if (code == 0)
        code = record_read(tool_host(), &r, record_file, 0);
    if (code == 0) {
        left_make(&l, &r, w->o.radius, w->o.corner);
        l.block = w->block.given ? &w->block : NULL;
        const surface_options o = { .all = &all,
                                    .name = file,
                                    .output = output,
                                    .e = &engine_f64,
                                    .map = MAP_GIVEN,
                                    .value = left_at,
                                    .context = &l,
                                    .words = "left, mm",
                                    .around = w->block.given ? left_around : NULL,
                                    .around_words = "rest of the block",
                                    .azimuth = -55,
                                    .elevation = w->block.given ? 55 : 40 };
        code = surface_plot(tool_host(), &o);
        if (code == 0 &&
            say(stdout, "%s: %zu places of the tool, %.4f mm left at worst, %.4f mm cut\n", output,
                l.count, l.most[1], l.most[0]) < 0)
            code = EX_IOERR;
        left_free(&l);
    }
    record_free(&r);
    surfaces_free(&all);
    return code;
}


// The command
// -----------

typedef struct {
    const char *file, *trim, *trim_uv, *record, *output;
    tool_wish w;
    int along, where;           /* of x|y|u|v, -1: not given; of host|chip */
    option_list area, lowest;
    mill_chip_options chip;
    const engine *e;
} mill_options;

enum { ALONG_X, ALONG_Y, ALONG_U, ALONG_V };

static const option mill_rows[] = {
    { "tool", OPTION_PARSED(mill_options, w), .value = "KIND:MM[:MM]", .parse = parse_tool,
      .standard = "ball:6",
      .remedy = "give ball:DIAMETER, flat:DIAMETER or bull:DIAMETER:CORNER, with a diameter of "
                "0.05 to 250 mm",
      .help = "ball:DIAMETER, flat:DIAMETER or bull:DIAMETER:CORNER" },
    { "step", OPTION_PARSED(mill_options, w), .value = "MM|cusp:MM", .parse = parse_step,
      .remedy = "give a number from 0.001 to 1000, or cusp: and one from 0.0005 to 60",
      .help = "distance of lines or heights; cusp: as far apart as leaves cusps of a ball at most "
              "so high (cusp:0.02)" },
    { "stock", OPTION_PARSED(mill_options, w.block), .value = "WxDxH", .parse = stock_parse,
      .remedy = "give WIDTHxDEPTHxHEIGHT, or that with @X,Y,Z of its lowest corner, in mm to 4096",
      .help = "the block, mm, its middle under that of the surfaces and its top at their highest "
              "point; or WxDxH@X,Y,Z with its lowest corner (no end of material)" },
    { "pattern", OPTION_CHOICE(mill_options, w.o.pattern), .value = "KIND",
      .choices = "raster|spiral|waterline|pencil", .standard = "raster",
      .help = "raster: there and back; spiral: around and inward; waterline: at even heights; "
              "pencil: along valleys where a ball touches twice" },
    { "along", OPTION_CHOICE(mill_options, along), .choices = "x|y|u|v", .unset = -1,
      .help = "direction of a raster's lines; u, v: over lines of the surface on which the other "
              "parameter is constant, with --step of it, 0.001 to 1 (x)" },
    { "one-way", OPTION_FLAG(mill_options, w.o.one_way),
      .help = "all lines of a raster along x or y in one direction, with ways back above" },
    { "tol", OPTION_NUMBER(mill_options, w.o.tol), .least = 0.001, .most = 10, .unit = "mm",
      .standard = "0.01", .help = "how much higher than necessary the path may be" },
    { "area", OPTION_LIST(mill_options, area), .least = -4096, .most = 4096, .value = "X,Y,X,Y",
      .counts = "4", .remedy = "give X,Y,X,Y: two corners",
      .help = "where the axis of the tool may be: two corners (0.7 radius around the surfaces, as "
              "far as touches a steeper border; 1.25 with waterlines)" },
    { "trim", OPTION_FILE(mill_options, trim), .value = "DRAWING",
      .help = "closed paths in x and y, mm: what is outside of the surfaces is not there" },
    { "trim-uv", OPTION_FILE(mill_options, trim_uv), .value = "DRAWING",
      .help = "the same in the parameters u and v, 0 to 1, of each surface" },
    { "floor", OPTION_LIST(mill_options, lowest), .least = -4096, .most = 4096, .value = "Z",
      .counts = "1", .remedy = "give one height",
      .help = "lowest height of the tip (so low that it touches all borders of the surfaces; of "
              "pencils, and along u or v, that of the surfaces)" },
    { "safe", OPTION_NUMBER(mill_options, w.o.safe), .least = 0, .most = 1000, .unit = "mm",
      .standard = "5",
      .help = "height above the surfaces and the block where the path begins and ends" },
    { "entry", OPTION_PARSED(mill_options, w), .value = "KIND", .parse = parse_entry,
      .standard = "straight",
      .remedy = "give straight, ramp:DEGREES or helix:MM[:DEGREES], with 0.5 to 45 degrees and a "
                "radius of 0.05 to 125 mm",
      .help = "how the tool goes down to a line: straight, ramp:DEGREES along it, "
              "helix:MM[:DEGREES] around" },
    { "record", OPTION_FILE(mill_options, record), .value = "FILE",
      .help = "no path, but a picture of what is left, by pulses of `loft simulate --record`; with "
              "--stock as the path says it, of the block too" },
    { "output", OPTION_FILE(mill_options, output), .value = "FILE",
      .help = "or -o: that picture, .png .svg or .pdf (left.png)" },
    { "plan", OPTION_CHOICE(mill_options, where), .choices = "host|chip", .standard = "host",
      .help = "host: print the path; chip: send patches, which the machine cuts by itself" },
    OPTION_GROUP(mill_options, chip, mill_chip_rows),
    ENGINE_ROW(mill_options, e, "f64", "number type"),
    { "file", OPTION_WORD(mill_options, file), .least = 1, .value = "FILE",
      .remedy = "give one file" },
    OPTION_NEEDS("port|dry-run|log", "plan=chip",
                 "without it the path is printed, for `loft stream`"),
    OPTION_EXCLUDES("plan=chip", "record", "--record draws what a machine has left"),
    OPTION_NEEDS("output", "record",
                 "it is that picture; the path goes to the standard output: > FILE.loft"),
    OPTION_EXCLUDES("record", "trim|trim-uv", "--record draws whole surfaces"),
    OPTION_EXCLUDES("trim", "trim-uv", NULL),
    OPTION_EXCLUDES("plan=chip", "pattern=spiral|pattern=waterline|pattern=pencil|along=x|along=y",
                    "a machine cuts by lines along u or v by itself"),
    OPTION_EXCLUDES("plan=chip", "trim|trim-uv|area|floor|stock",
                    "a machine cuts the whole surface"),
    OPTION_NEEDS("plan=chip", "port|dry-run", "name the machine's port, or plan with --dry-run"),
    OPTION_EXCLUDES("plan=chip&port=-", "", "standard output has the summary: name another port"),
    OPTION_EXCLUDES("along=u|along=v", "pattern=spiral|pattern=waterline|pattern=pencil",
                    "these lines are a raster"),
    OPTION_EXCLUDES("one-way", "pattern=spiral|pattern=waterline|pattern=pencil|along=u|along=v",
                    "it is of a raster along x or y"),
    { 0 }
};

static int mill_trimmed(mill_options *o)
{
    mill_trim *trim = &o->w.o.trim;
    int code        = 0;

    trim->plane = o->trim != NULL;
    trim->tol   = o->trim ? o->w.o.tol / 10 : 1e-4;
    if (o->trim || o->trim_uv)
        code = mill_trim_read(tool_host(), trim, o->trim ? o->trim : o->trim_uv);
    if (code == 0)
        code = mill_surfaces(o->e, &o->w, o->file);
    mill_trim_free(trim);
    return code;
}

/* Patches for the machine: what the options mean for them. */
static int mill_on_chip(const mill_options *w)
{
    const mill_order *o = &w->w.o;
    const double cusp   = o->cusp > 0 ? o->cusp : fmin(0.02, o->radius / 8);
    mill_chip c         = { .a = w->chip };

    if (o->corner < o->radius || o->radius > 64)
        return tool_error(EX_USAGE, "--plan chip: a machine cuts with a ball of at most 128 mm by "
                                    "itself: give --tool ball:DIAMETER");
    if (o->entry != MILL_STRAIGHT)
        return tool_error(EX_USAGE, "--plan chip: a machine cuts the whole surface: leave out "
                                    "--entry");
    if (o->tol > 1)
        return tool_error(EX_USAGE, "--tol %g: give at most 1 with --plan chip", o->tol);
    c.o.radius  = o->radius;
    c.o.step    = o->step > 0 ? o->step : 2 * sqrt(2 * o->radius * cusp - cusp * cusp);
    c.o.tol     = o->tol;
    c.o.above   = o->safe;
    c.o.axis    = w->along != ALONG_U;
    c.o.one_way = o->one_way;
    return mill_chip_run(&c, w->file);
}

/* Only a ball leaves cusps of a known height. */
static int check_tool(const mill_options *o)
{
    const mill_order *m = &o->w.o;
    const bool ball     = m->corner == m->radius;

    if (m->cusp > 0 && !ball)
        return tool_error(EX_USAGE, "--step cusp: is for a ball: give --step MM for %s", o->w.name);
    if (m->cusp >= m->radius / 2)
        return tool_error(EX_USAGE, "--step cusp:%g: give less than a quarter of the diameter",
                          m->cusp);
    if (m->pattern == MILL_PENCIL && !ball)
        return tool_error(EX_USAGE, "--pattern pencil: is for a ball: give --tool ball:DIAMETER");
    return 0;
}

/* Where the tool may be. */
static int take_area(const option_list *area, mill_order *o)
{
    o->bounded = area->count == 4;
    for (int k = 0; k < 2 && o->bounded; k++) {
        o->area[0][k] = fmin(area->value[k], area->value[k + 2]);
        o->area[1][k] = fmax(area->value[k], area->value[k + 2]);
        if (!(o->area[0][k] < o->area[1][k]))
            return tool_error(EX_USAGE, "--area: is empty: give two corners apart");
    }
    return 0;
}

/* The path, or the picture of what it left. */
static int mill_here(mill_options *o)
{
    mill_order *m   = &o->w.o;
    const bool ball = m->corner == m->radius;
    const char *to  = o->output ? o->output : "left.png";

    m->parametric = o->along >= ALONG_U;
    m->axis       = o->along == ALONG_Y || o->along == ALONG_V;
    if (m->parametric && !(m->step > 0 && m->step <= 1))
        return tool_error(EX_USAGE,
                          "--along %c: is for --pattern raster and --step 0.001 to 1, of "
                          "%c",
                          "xyuv"[o->along], o->along == ALONG_U ? 'v' : 'u');
    if (m->cusp == 0 && m->step == 0)
        *(ball ? &m->cusp : &m->step) = ball ? fmin(0.02, m->radius / 8) : m->radius;
    m->floored = o->lowest.count == 1;
    m->lowest  = o->lowest.value[0];
    int code   = take_area(&o->area, m);
    if (code == 0 && o->record == NULL)
        return mill_trimmed(o);
    if (code == 0)
        code = create_check(tool_host(), to);
    return code == 0 ? plot_left(&o->w, o->file, o->record, to) : code;
}

static int run_mill(void *options)
{
    mill_options *o = options;
    const int code  = check_tool(o);

    if (code != 0)
        return code;
    return o->where == 1 ? mill_on_chip(o) : mill_here(o);
}

const command command_mill = {
    .name = "mill",
    .arguments =
        "[--tool ball:6] [--step MM|cusp:MM] [--stock WxDxH] [--plan chip --port PORT] FILE|-",
    .summary = "the path of a mill's tool over surfaces, as a curve in space",
    .detail =
        "FILE has surfaces in the format of host-tools/LOFT.md: tensor, bicubic, coons, triangle,\n"
        "pn, octant, toric, basepoint, ring, and spatch, gb with Wachspress coordinates. Prints\n"
        "the path of the tip as one `line` in .loft, which `loft stream` mills with z: lines "
        "there\n"
        "and back, their distance from the cusps that a ball leaves, in chords within --tol. Each\n"
        "chord is proved not to cut below any surface; beside walls the path goes up and down on\n"
        "the spot. --pattern spiral goes around the area and inward without a lift, one side to\n"
        "the left. --pattern waterline goes around what is steep, from above down, the surface to\n"
        "the right; with --step cusp: the distance of heights is that on an upright wall; each "
        "hill "
        "is\n"
        "finished before the next one. --pattern pencil goes along valleys, where a ball touches\n"
        "in two places that are half its radius apart: what a raster leaves there. --entry leads\n"
        "the tool into the material along the line or around, proved as all chords are; a helix\n"
        "without room becomes a ramp. --trim leaves of the surfaces what is inside of closed\n"
        "paths; loops in loops are holes. The first lines of the output say what is proved and\n"
        "measured: also what is left on the surfaces at most, and in hollows tighter than the\n"
        "tool. Surfaces are seen from above. With --record the surfaces are drawn instead,\n"
        "coloured by what a machine left on them or cut off them.\n"
        "\n"
        "--stock is the block that is cut: surfaces or lines that leave it, or are below its "
        "bottom,\n"
        "are refused; the path begins and ends above it, as do the ways between lines. There is "
        "no\n"
        "roughing: the one pass goes through all of the material, so choose the feed for that. "
        "The\n"
        "first lines of the path say where the block is, in the form that --record --stock takes: "
        "its\n"
        "picture then begins with the block, its top and its sides.\n"
        "\n"
        "With --plan chip nothing is printed but a summary: each tensor or bicubic patch of "
        "degrees\n"
        "up to 3 x 3 goes to the machine at --port as its control net, about 200 bytes, and the\n"
        "machine cuts it with a ball by lines along v, or --along u, from where it stands and "
        "back.\n"
        "Lines are at most --step apart along the surface, or as far as leaves such cusps where it "
        "is\n"
        "flat. What no machine can prove is refused here, with the remedy. Keys as of `loft "
        "stream`.\n",
    .options = mill_rows,
    .size = sizeof(mill_options),
    .run = run_mill,
};

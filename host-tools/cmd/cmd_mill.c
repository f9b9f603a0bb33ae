/* host-tools/cmd/cmd_mill.c -- loft mill: the path of a cutter over surfaces, as a curve in space
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/create.h"      /* create_check */
#include "base/progress.h"
#include "base/say.h"
#include "base/source.h"        /* source_name */
#include "base/tool.h"
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
    (void)tool_error(EX_USAGE,
                     "--tool %s: give ball:DIAMETER, flat:DIAMETER or bull:DIAMETER:CORNER, with a "
                     "diameter of 0.05 to 250 mm",
                     text);
    return false;
}

/* 0.5, cusp:0.01 */
static bool parse_step(const char *text, void *out)
{
    mill_order *o = &((tool_wish *)out)->o;

    o->cusp = o->step = 0;
    if (strncmp(text, "cusp:", 5) == 0)
        return tool_number("step cusp:", text + 5, 0.0005, 60, &o->cusp);
    return tool_number("step", text, 0.001, 1000, &o->step);
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
    const bool ramp = sscanf(text, "ramp:%lf%c", &angle, &rest) == 1;
    if (ramp || (strncmp(text, "helix:", 6) == 0 &&
                 (sscanf(text, "helix:%lf%c", &radius, &rest) == 1 ||
                  sscanf(text, "helix:%lf:%lf%c", &radius, &angle, &rest) == 2)))
        if (angle >= 0.5 && angle <= 45 && radius >= 0.05 && radius <= 125) {
            w->o.entry = ramp ? MILL_RAMP : MILL_HELIX;
            w->o.slope = tan(angle * acos(-1) / 180);
            w->o.around = radius;
            return true;
        }
    (void)tool_error(
        EX_USAGE,
        "--entry %s: give straight, ramp:DEGREES or helix:MM[:DEGREES], with 0.5 to 45 "
        "degrees and a radius of 0.05 to 125 mm",
        text);
    return false;
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
        printf("# cusps: at most %.6f, asked %g\n", r->cusp, w->o.cusp);
    if (p->count > 0) {
        printf("# left on the surfaces: at most %.4f\n", r->left);
        printf(r->hollow > r->reached
                   ? "# left in hollows tighter than the tool: at most %.4f\n"
                   : "# left in hollows tighter than the tool: no more than %.4f\n",
               fmax(r->hollow, r->reached));
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
        code = stock_place(&w->block, &all, &w->o.trim, source_name(file));
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
               : w->block.given ? stock_holds(&w->block, &path.cut[0], source_name(file))
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
        code = stock_place(&w->block, &all, &w->o.trim, source_name(file));
    if (code == 0)
        code = record_read(&r, record_file, 0);
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
        code = surface_plot(&o);
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

/* trim: in u and v, in x and y. */
static int mill_trimmed(const engine *e, tool_wish *w, const char *const trim[2], const char *file)
{
    int code = 0;

    if (trim[0] && trim[1])
        return tool_error(EX_USAGE, "--trim and --trim-uv: give one of them");
    w->o.trim.plane = trim[1] != NULL;
    w->o.trim.tol = trim[1] ? w->o.tol / 10 : 1e-4;
    if (trim[0] || trim[1])
        code = mill_trim_read(tool_host(), &w->o.trim, trim[1] ? trim[1] : trim[0]);
    if (code == 0)
        code = mill_surfaces(e, w, file);
    mill_trim_free(&w->o.trim);
    return code;
}

/* Patches for the machine: what the options mean for them. */
static int mill_on_chip(mill_chip *c, const tool_wish *w, const char *along, const char *pattern,
                        const char *file)
{
    const mill_order *o = &w->o;
    const double cusp   = o->cusp > 0 ? o->cusp : fmin(0.02, o->radius / 8);

    if (o->corner < o->radius || o->radius > 64)
        return tool_error(EX_USAGE, "--plan chip: a machine cuts with a ball of at most 128 mm by "
                                    "itself: give --tool ball:DIAMETER");
    if (strcmp(pattern, "raster") != 0 || (along != NULL && strchr("uv", along[0]) == NULL))
        return tool_error(EX_USAGE, "--plan chip: a machine cuts by lines along u or v by itself: "
                                    "give --along u or v, and no --pattern");
    if (o->trim.count > 0 || o->bounded || o->floored || o->entry != MILL_STRAIGHT ||
        w->block.given)
        return tool_error(EX_USAGE, "--plan chip: a machine cuts the whole surface: leave out "
                                    "--trim, --area, --floor, --entry and --stock");
    if (o->tol > 1)
        return tool_error(EX_USAGE, "--tol %g: give at most 1 with --plan chip", o->tol);
    c->o.radius  = o->radius;
    c->o.step    = o->step > 0 ? o->step : 2 * sqrt(2 * o->radius * cusp - cusp * cusp);
    c->o.tol     = o->tol;
    c->o.above   = o->safe;
    c->o.axis    = along != NULL && along[0] == 'u' ? 0 : 1;
    c->o.one_way = o->one_way;
    return mill_chip_run(c, file);
}

static int run_mill(const tool_command *self, int argc, char **argv)
{
    const engine *e = &engine_f64;
    tool_wish w = { .o = { .radius = 3, .corner = 3, .tol = 0.01, .safe = 5 }, .name = "ball:6" };
    tool_list area = { .count = 0 }, lowest = { .count = 0 };
    const char *along = NULL, *pattern = "raster", *record_file = NULL, *output = NULL,
               *trim[2] = { NULL, NULL }, *where = "host";
    mill_chip chip;
    int first, code = mill_chip_start(&chip, argc, argv);

    if (code != 0)
        return code;

    const tool_option options[] = {
        TOOL_PARSED("tool", "KIND:MM[:MM]", &w, parse_tool,
                    "ball:DIAMETER, flat:DIAMETER or bull:DIAMETER:CORNER (ball:6)"),
        TOOL_PARSED("step", "MM|cusp:MM", &w, parse_step,
                    "distance of lines or heights; cusp: as far apart as leaves cusps of a ball at "
                    "most so high (cusp:0.02)"),
        TOOL_PARSED("stock", "WxDxH", &w.block, stock_parse,
                    "the block, mm, its middle under that of the surfaces and its top at their "
                    "highest point; or WxDxH@X,Y,Z with its lowest corner (no end of material)"),
        TOOL_TEXT("pattern", "KIND", &pattern,
                  "raster: there and back; spiral: around and inward; waterline: at even heights; "
                  "pencil: along valleys where a ball touches twice (raster)"),
        TOOL_TEXT("along", "x|y|u|v", &along,
                  "direction of a raster's lines; u, v: over lines of the surface on which the "
                  "other parameter is constant, with --step of it, 0.001 to 1 (x)"),
        TOOL_SWITCH("one-way", &w.o.one_way,
                    "all lines of a raster along x or y in one direction, with ways back above"),
        TOOL_NUMBER("tol", "MM", &w.o.tol, 0.001, 10,
                    "how much higher than necessary the path may be (0.01)"),
        TOOL_LIST(
            "area", "X,Y,X,Y", &area, -4096, 4096,
            "where the axis of the tool may be: two corners (0.7 radius around the surfaces, as "
            "far as touches a steeper border; 1.25 with waterlines)"),
        TOOL_TEXT("trim", "DRAWING", &trim[1],
                  "closed paths in x and y, mm: what is outside of the surfaces is not there"),
        TOOL_TEXT("trim-uv", "DRAWING", &trim[0],
                  "the same in the parameters u and v, 0 to 1, of each surface"),
        TOOL_LIST(
            "floor", "Z", &lowest, -4096, 4096,
            "lowest height of the tip (so low that it touches all borders of the surfaces; of "
            "pencils, and along u or v, that of the surfaces)"),
        TOOL_NUMBER("safe", "MM", &w.o.safe, 0, 1000,
                    "height above the surfaces and the block where the path begins and ends (5)"),
        TOOL_PARSED("entry", "KIND", &w, parse_entry,
                    "how the tool goes down to a line: straight, ramp:DEGREES along it, "
                    "helix:MM[:DEGREES] around (straight)"),
        TOOL_TEXT("record", "FILE", &record_file,
                  "no path, but a picture of what is left, by pulses of `loft simulate --record`; "
                  "with --stock as the path says it, of the block too"),
        TOOL_TEXT("output", "FILE", &output, "or -o: that picture, .png .svg or .pdf (left.png)"),
        TOOL_TEXT("plan", "host|chip", &where,
                  "host: print the path; chip: send patches, which the machine cuts by itself "
                  "(host)"),
        MILL_CHIP_OPTIONS(chip),
        ENGINE_OPTION(&e, "number type (f64)"),
        TOOL_OPTIONS_END
    };
    code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (argc - first != 1)
        return tool_error(EX_USAGE, "mill: give one file: see `loft mill --help`");
    const bool on_chip = strcmp(where, "chip") == 0;
    if (!on_chip && strcmp(where, "host") != 0)
        return tool_error(EX_USAGE, "--plan %s: give host or chip", where);
    if (!on_chip && (chip.port != NULL || chip.dry || chip.log != NULL))
        return tool_error(EX_USAGE, "--port, --dry-run, --log: are for --plan chip: without it the "
                                    "path is printed, for `loft stream`");
    if (on_chip && record_file != NULL)
        return tool_error(EX_USAGE, "--record: draws what a machine has left: leave out --plan");
    if (record_file == NULL && output != NULL)
        return tool_error(EX_USAGE,
                          "--output %s: is the picture of --record; the path goes to the "
                          "standard output: > FILE.loft",
                          output);
    if (record_file != NULL && (trim[0] || trim[1]))
        return tool_error(EX_USAGE, "--record: draws whole surfaces: leave out --trim");
    const bool ball = w.o.corner == w.o.radius;
    if (w.o.cusp > 0 && !ball)
        return tool_error(EX_USAGE, "--step cusp: is for a ball: give --step MM for %s", w.name);
    if (w.o.cusp >= w.o.radius / 2)
        return tool_error(EX_USAGE, "--step cusp:%g: give less than a quarter of the diameter",
                          w.o.cusp);
    if (along != NULL && (strlen(along) != 1 || strchr("xyuv", along[0]) == NULL))
        return tool_error(EX_USAGE, "--along %s: give x, y, u or v", along);
    if (on_chip) {
        w.o.trim.count = trim[0] || trim[1];
        w.o.bounded    = area.count > 0;
        w.o.floored    = lowest.count > 0;
        return mill_on_chip(&chip, &w, along, pattern, argv[first]);
    }
    if (along == NULL)
        along = "x";
    if (strcmp(along, "u") == 0 || strcmp(along, "v") == 0) {
        w.o.parametric = true;
        if (!(w.o.step > 0 && w.o.step <= 1) || strcmp(pattern, "raster") != 0)
            return tool_error(EX_USAGE,
                              "--along %s: is for --pattern raster and --step 0.001 to 1, of %s",
                              along, along[0] == 'u' ? "v" : "u");
    }
    if (w.o.one_way && (w.o.parametric || strcmp(pattern, "raster") != 0))
        return tool_error(EX_USAGE, "--one-way: is for --pattern raster along x or y");
    if (w.o.cusp == 0 && w.o.step == 0)
        *(ball ? &w.o.cusp : &w.o.step) = ball ? fmin(0.02, w.o.radius / 8) : w.o.radius;
    w.o.axis = along[0] == 'y' || along[0] == 'v';
    static const char *const patterns[] = { "raster", "spiral", "waterline", "pencil" };
    int kind = 0;
    while (kind < 4 && strcmp(pattern, patterns[kind]) != 0)
        kind++;
    if (kind == 4)
        return tool_error(EX_USAGE, "--pattern %s: give raster, spiral, waterline or pencil",
                          pattern);
    if (kind == MILL_PENCIL && !ball)
        return tool_error(EX_USAGE, "--pattern pencil: is for a ball: give --tool ball:DIAMETER");
    w.o.pattern = (enum mill_pattern)kind;
    if (lowest.count > 1 || (area.count != 0 && area.count != 4))
        return tool_error(EX_USAGE, lowest.count > 1 ? "--floor: give one height"
                                                     : "--area: give X,Y,X,Y: two corners");
    w.o.floored = lowest.count == 1;
    w.o.lowest = w.o.floored ? lowest.value[0] : 0;
    w.o.bounded = area.count == 4;
    for (int k = 0; k < 2 && w.o.bounded; k++) {
        w.o.area[0][k] = fmin(area.value[k], area.value[k + 2]);
        w.o.area[1][k] = fmax(area.value[k], area.value[k + 2]);
        if (!(w.o.area[0][k] < w.o.area[1][k]))
            return tool_error(EX_USAGE, "--area: is empty: give two corners apart");
    }
    if (record_file != NULL) {
        output = output ? output : "left.png";
        const int refused = create_check(tool_host(), output);
        return refused ? refused : plot_left(&w, argv[first], record_file, output);
    }
    return mill_trimmed(e, &w, trim, argv[first]);
}

const tool_command command_mill = {
    "mill", "[--tool ball:6] [--step MM|cusp:MM] [--stock WxDxH] [--plan chip --port PORT] FILE|-",
    "the path of a mill's tool over surfaces, as a curve in space",
    "FILE has surfaces in the format of host-tools/LOFT.md: tensor, bicubic, coons, triangle,\n"
    "pn, octant, toric, basepoint, ring, and spatch, gb with Wachspress coordinates. Prints\n"
    "the path of the tip as one `line` in .loft, which `loft stream` mills with z: lines there\n"
    "and back, their distance from the cusps that a ball leaves, in chords within --tol. Each\n"
    "chord is proved not to cut below any surface; beside walls the path goes up and down on\n"
    "the spot. --pattern spiral goes around the area and inward without a lift, one side to\n"
    "the left. --pattern waterline goes around what is steep, from above down, the surface to\n"
    "the right; with --step cusp: the distance of heights is that on an upright wall; each hill "
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
    "--stock is the block that is cut: surfaces or lines that leave it, or are below its bottom,\n"
    "are refused; the path begins and ends above it, as do the ways between lines. There is no\n"
    "roughing: the one pass goes through all of the material, so choose the feed for that. The\n"
    "first lines of the path say where the block is, in the form that --record --stock takes: its\n"
    "picture then begins with the block, its top and its sides.\n"
    "\n"
    "With --plan chip nothing is printed but a summary: each tensor or bicubic patch of degrees\n"
    "up to 3 x 3 goes to the machine at --port as its control net, about 200 bytes, and the\n"
    "machine cuts it with a ball by lines along v, or --along u, from where it stands and back.\n"
    "Lines are at most --step apart along the surface, or as far as leaves such cusps where it is\n"
    "flat. What no machine can prove is refused here, with the remedy. Keys as of `loft stream`.\n",
    run_mill
};

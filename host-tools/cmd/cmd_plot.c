/* host-tools/cmd/cmd_plot.c -- loft plot: a picture of the drawing and of the path that the machine
 * took
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmd/commands.h"
#include "base/say.h"
#include "engine/curve.h"
#include "draw/plot.h"
#include "draw/surface_plot.h"
#include "arrange/page.h"
#include "base/create.h"      /* create_check */
#include "readers.h"
#include "geometry/surface_text.h"

static int print_result(const plot_options *o, const plot_result *found)
{
    size_t count = o->r == NULL && o->d->of ? o->d->of->count : o->d->count;

    for (size_t i = 0; o->d->program && i < o->d->count; i++)
        count -= o->d->curve[i].feed < 0;       /* a rapid draws nothing */

    if (o->r == NULL)
        return say(stdout, "%s: %zu curve%s\n", o->output, count, tool_s(count)) < 0 ? EX_IOERR
                                                                                     : EX_OK;
    (void)say(stdout,
              "%s: %zu curve%s, %zu pulses with the pen down, path error %.4f mm at worst, at "
              "%.3f,%.3f, %.4f mm on average",
              o->output, count, tool_s(count), found->drawing_pulses, found->worst,
              found->worst_point[0], found->worst_point[1], found->mean);
    if (found->inset)
        printf(", inset: corner at %.3f,%.3f", found->corner[0], found->corner[1]);
    return printf("\n") < 0 ? EX_IOERR : EX_OK;
}

static int plot_files(plot_options *o, const page_options *sheet, const char *record_file)
{
    drawing d = { .layers = sheet->layers,
                  .only = sheet->only,
                  .text = sheet->text,
                  .areas = sheet->fill.distance > 0 };
    record r  = { 0 };
    plot_result found = { 0 };
    int code = drawing_read(tool_host(), &d, o->name);

    if (code == 0)
        code = page_apply(tool_host(), sheet, &d, o->name);
    o->d = &d;
    if (code == 0 && record_file != NULL) {
        code = record_read(tool_host(), &r, record_file, 0);
        o->r = &r;
    }
    if (code == 0)
        code = plot_draw(tool_host(), o, &found);
    if (code == 0)
        code = print_result(o, &found);
    record_free(&r);
    drawing_free(&d);
    return code;
}

// Surfaces
// --------

typedef struct {
    option_list view;
    option_list heights;
    unsigned contours;
    int map;                    /* enum surface_map, less 1; -1: none */
    bool wire;
} surface_wishes;

static bool wishes_given(const surface_wishes *w)
{
    return w->view.count + w->heights.count + w->contours > 0 || w->map >= 0 || w->wire;
}

#define VIEW                                                                                       \
    "give AROUND,UP in degrees, UP from -90 to 90, and for perspective a distance in diameters"

/* From where a surface is seen. */
static int take_view(const option_list *view, surface_options *o)
{
    if (view->count == 0)
        return 0;
    o->azimuth   = view->value[0];
    o->elevation = view->value[1];
    o->distance  = view->count == 3 ? view->value[2] : 0;
    if (fabs(o->elevation) > 90)
        return tool_error(EX_USAGE, "--view: " VIEW);
    if (view->count == 3 && (o->distance < 0.8 || o->distance > 1000))
        return tool_error(EX_USAGE, "--view: a distance of %g diameters: give 0.8 to 1000",
                          o->distance);
    return 0;
}

static int plot_surfaces(const plot_options *p, const surface_wishes *w, const surfaces *all)
{
    surface_options o = { .all = all,
                          .name = p->name,
                          .output = p->output,
                          .e = &engine_f64,
                          .control = p->control,
                          .wire = w->wire,
                          .map = (enum surface_map)(w->map + 1),
                          .contours = w->contours,
                          .height = w->heights.value,
                          .heights = w->heights.count,
                          .azimuth = -55,
                          .elevation = 28,
                          .size = p->size };

    int code = take_view(&w->view, &o);
    if (code == 0)
        code = surface_plot(tool_host(), &o);
    return code                                                                           ? code
           : say(stdout, "%s: %zu surface%s\n", p->output, all->count, tool_s(all->count)) < 0
               ? EX_IOERR
               : EX_OK;
}

/* The content of the file decides what is drawn. */
static int plot_file(plot_options *o, const page_options *sheet, const char *record_file,
                     const surface_wishes *w, bool of_drawings)
{
    surfaces all = { .drawn = true };
    int code = surfaces_read(tool_host(), &all, o->name);

    if (code == 0 && all.count > 0 && of_drawings)
        code = tool_error(
            EX_USAGE, "%s: holds surfaces: --record, --error, --comb and --part are for drawings",
            o->name);
    else if (code == 0 && all.count == 0 && wishes_given(w))
        code = tool_error(EX_USAGE,
                          "%s: holds no surface: --view, --curvature, --contours, --heights and "
                          "--wire are for surfaces",
                          o->name);
    else if (code == 0)
        code = all.count > 0 ? plot_surfaces(o, w, &all) : plot_files(o, sheet, record_file);
    surfaces_free(&all);
    return code;
}

typedef struct {
    const char *file, *output, *record;
    bool control;
    double comb, error, tol, size;
    option_list part;
    surface_wishes of;
    page_options sheet;
} plot_command;

static const option plot_rows[] = {
    { "output", OPTION_FILE(plot_command, output), .value = "FILE", .standard = "plot.png",
      .help = "or -o: picture to write, .png .svg or .pdf" },
    { "record", OPTION_FILE(plot_command, record), .value = "FILE",
      .help = "pulses written by `loft simulate --record`: what was really drawn" },
    { "control", OPTION_FLAG(plot_command, control),
      .help = "draw the control polygons or nets, and the knots of splines" },
    { "comb", OPTION_MAYBE(plot_command, comb), .least = 1e-6, .most = 1e9, .value = "SCALE",
      .unset = PLOT_NO_COMB,
      .help = "draw curvature combs, SCALE mm for 1/mm (chosen automatically)" },
    { "error", OPTION_NUMBER(plot_command, error), .least = 0, .most = 1e9, .value = "N",
      .unset = PLOT_NO_ERROR,
      .help = "magnify errors N times, and colour by them (0: chosen automatically)" },
    { "tol", OPTION_NUMBER(plot_command, tol), .least = 1e-6, .most = 100, .unit = "mm",
      .help = "with --record: an inset shows a corner and the band of this tolerance" },
    { "part", OPTION_LIST(plot_command, part), .least = -1e5, .most = 1e5, .value = "X,Y,W,H",
      .counts = "4", .remedy = "give x,y,width,height in mm",
      .help = "show this part only, in mm from the lower left corner" },
    { "view", OPTION_LIST(plot_command, of.view), .least = -1000, .most = 1000,
      .value = "AROUND,UP", .counts = "2|3", .remedy = VIEW,
      .help = "see a surface from there, in degrees (-55,28); a third number: perspective" },
    { "curvature", OPTION_CHOICE(plot_command, of.map), .choices = "gauss|mean|largest",
      .unset = -1, .help = "colour a surface by its curvature: gauss, mean or largest" },
    { "contours", OPTION_INTEGER(plot_command, of.contours), .least = 1, .most = 100, .value = "N",
      .help = "draw lines of equal height on a surface, about N, at round heights" },
    { "heights", OPTION_LIST(plot_command, of.heights), .least = -1e5, .most = 1e5, .value = "Z,..",
      .help = "draw lines of these heights on a surface" },
    { "wire", OPTION_FLAG(plot_command, of.wire),
      .help = "draw only the lines of a surface, nothing hidden" },
    { "size", OPTION_NUMBER(plot_command, size), .least = 10, .most = 30000, .value = "WIDTH",
      .help = "px of a PNG (1600), mm of the others (true to scale)" },
    OPTION_GROUP(plot_command, sheet, page_rows),
    { "file", OPTION_WORD(plot_command, file), .least = 1, .value = "DRAWING",
      .remedy = "give one drawing" },
    OPTION_EXCLUDES("wire", "curvature", "a wire has no colour"),
    OPTION_NEEDS("error", "record", "errors are those of a machine"),
    OPTION_NEEDS("tol", "record", "it shows what was drawn"),
    { 0 }
};

static int run_plot(void *options)
{
    const plot_command *c = options;
    const double *part    = c->part.value;
    plot_options o        = { .name = c->file,
                              .output = c->output,
                              .control = c->control,
                              .comb = c->comb,
                              .error = c->error,
                              .tol = c->tol,
                              .size = c->size };

    if (c->part.count > 0 && !(part[2] > 0 && part[3] > 0))
        return tool_error(EX_USAGE, "--part: give x,y,width,height in mm");
    memcpy(o.part, part, sizeof o.part);
    const int code = create_check(tool_host(), o.output);
    return code ? code
                : plot_file(&o, &c->sheet, c->record, &c->of,
                            c->record != NULL || o.error >= 0 || o.comb >= 0 || c->part.count > 0);
}

const command command_plot = {
    .name = "plot",
    .arguments = "[-o FILE] [--record FILE [--error N]] DRAWING|-",
    .summary = "a picture of a drawing and of what the machine drew, or of surfaces",
    .detail =
        "Curves are drawn as curves, not as chords. With --record the machine's own positions are\n"
        "drawn over them; travel is dashed. With --error each position moves away from the\n"
        "drawing by N times its distance, and the colour shows the distance. A file of surfaces\n"
        "(host-tools/LOFT.md) is drawn shaded, with its parameter lines, or as a map of its\n"
        "curvature: of the two principal curvatures the product (gauss), half the sum (mean) or\n"
        "the larger absolute value, whose reciprocal is the radius of the tool that fits.\n"
        "--contours and --heights draw its sections with level planes; --view -90,90 shows it\n"
        "from above.\n",
    .options = plot_rows,
    .size = sizeof(plot_command),
    .run = run_plot,
};

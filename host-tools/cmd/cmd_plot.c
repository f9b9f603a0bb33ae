/* host-tools/cmd/cmd_plot.c -- loft plot: a picture of the drawing and of the path that the machine
 * took
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/say.h"
#include "engine/curve.h"
#include "draw/plot.h"
#include "draw/surface_plot.h"
#include "arrange/page.h"
#include "base/create.h"      /* create_check */
#include "base/tool.h"
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
        code = page_apply(sheet, &d, o->name);
    o->d = &d;
    if (code == 0 && record_file != NULL) {
        code = record_read(&r, record_file, 0);
        o->r = &r;
    }
    if (code == 0)
        code = plot_draw(o, &found);
    if (code == 0)
        code = print_result(o, &found);
    record_free(&r);
    drawing_free(&d);
    return code;
}

// Surfaces
// --------

typedef struct {
    tool_list view;
    tool_list heights;
    unsigned contours;
    const char *map;            /* NULL: none */
    bool wire;
} surface_wishes;

static bool wishes_given(const surface_wishes *w)
{
    return w->view.count + w->heights.count + w->contours > 0 || w->map != NULL || w->wire;
}

static bool map_of(const char *name, enum surface_map *out)
{
    static const char *const names[] = {
        [MAP_NONE] = "", [MAP_GAUSS] = "gauss", [MAP_MEAN] = "mean", [MAP_LARGEST] = "largest"
    };

    *out = MAP_NONE;
    if (name == NULL)
        return true;
    for (int k = MAP_GAUSS; k <= MAP_LARGEST; k++)
        if (strcmp(name, names[k]) == 0)
            *out = (enum surface_map)k;
    return *out != MAP_NONE;
}

static int plot_surfaces(const plot_options *p, const surface_wishes *w, const surfaces *all)
{
    const double *view = w->view.value;
    surface_options o = { .all = all,
                          .name = p->name,
                          .output = p->output,
                          .e = &engine_f64,
                          .control = p->control,
                          .wire = w->wire,
                          .contours = w->contours,
                          .height = w->heights.value,
                          .heights = w->heights.count,
                          .azimuth = -55,
                          .elevation = 28,
                          .size = p->size };

    if (!map_of(w->map, &o.map))
        return tool_error(EX_USAGE, "--curvature %s: give gauss, mean or largest", w->map);
    if (w->view.count == 1 || w->view.count > 3 || (w->view.count > 1 && fabs(view[1]) > 90))
        return tool_error(EX_USAGE, "--view: give AROUND,UP in degrees, UP from -90 to 90, and for "
                                    "perspective a distance in diameters");
    if (w->view.count == 3 && (view[2] < 0.8 || view[2] > 1000))
        return tool_error(EX_USAGE, "--view: a distance of %g diameters: give 0.8 to 1000",
                          view[2]);
    if (w->view.count > 1) {
        o.azimuth   = view[0];
        o.elevation = view[1];
        o.distance  = w->view.count == 3 ? view[2] : 0;
    }
    if (o.wire && o.map != MAP_NONE)
        return tool_error(EX_USAGE,
                          "--wire and --curvature: give one of them: a wire has no colour");
    const int code = surface_plot(&o);
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

static int run_plot(const tool_command *self, int argc, char **argv)
{
    const char *record_file = NULL;
    tool_list part = { .count = 0 };
    plot_options o = { .error = PLOT_NO_ERROR, .comb = PLOT_NO_COMB, .output = "plot.png" };
    surface_wishes w = { .map = NULL };
    page_options sheet = { .gap = PAGE_GAP };
    int first;

    const tool_option options[] = {
        TOOL_TEXT("output", "FILE", &o.output,
                  "or -o: picture to write, .png .svg or .pdf (plot.png)"),
        TOOL_TEXT("record", "FILE", &record_file,
                  "pulses written by `loft simulate --record`: what was really drawn"),
        TOOL_SWITCH("control", &o.control,
                    "draw the control polygons or nets, and the knots of splines"),
        TOOL_MAYBE("comb", "SCALE", &o.comb, 1e-6, 1e9,
                   "draw curvature combs, SCALE mm for 1/mm (chosen automatically)"),
        TOOL_NUMBER("error", "N", &o.error, 0, 1e9,
                    "magnify errors N times, and colour by them (0: chosen automatically)"),
        TOOL_NUMBER("tol", "MM", &o.tol, 1e-6, 100,
                    "with --record: an inset shows a corner and the band of this tolerance"),
        TOOL_LIST("part", "X,Y,W,H", &part, -1e5, 1e5,
                  "show this part only, in mm from the lower left corner"),
        TOOL_LIST("view", "AROUND,UP", &w.view, -1000, 1000,
                  "see a surface from there, in degrees (-55,28); a third number: perspective"),
        TOOL_TEXT("curvature", "gauss|mean|largest", &w.map,
                  "colour a surface by its curvature: gauss, mean or largest"),
        TOOL_COUNT("contours", "N", &w.contours, 1, 100,
                   "draw lines of equal height on a surface, about N, at round heights"),
        TOOL_LIST("heights", "Z,..", &w.heights, -1e5, 1e5,
                  "draw lines of these heights on a surface"),
        TOOL_SWITCH("wire", &w.wire, "draw only the lines of a surface, nothing hidden"),
        TOOL_NUMBER("size", "WIDTH", &o.size, 10, 30000,
                    "px of a PNG (1600), mm of the others (true to scale)"),
        PAGE_OPTIONS(&sheet),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);

    if (code == TOOL_HELP)
        code = EX_OK;
    else if (code == 0 && argc - first != 1)
        code = tool_error(EX_USAGE, "plot: give one drawing: see `loft plot --help`");
    else if (code == 0 && part.count != 0 &&
             (part.count != 4 || part.value[2] <= 0 || part.value[3] <= 0))
        code = tool_error(EX_USAGE, "--part: give x,y,width,height in mm");
    else if (code == 0 && o.error >= 0 && record_file == NULL)
        code = tool_error(EX_USAGE,
                          "--error: give --record FILE as well: errors are those of a machine");
    else if (code == 0 && o.tol > 0 && record_file == NULL)
        code = tool_error(EX_USAGE, "--tol: give --record FILE as well: it shows what was drawn");
    else if (code == 0 && (code = create_check(tool_host(), o.output)) == 0) {
        if (part.count == 4)
            memcpy(o.part, part.value, sizeof o.part);
        o.name = argv[first];
        code = plot_file(&o, &sheet, record_file, &w,
                         record_file != NULL || o.error >= 0 || o.comb >= 0 || part.count > 0);
    }
    return code;
}

const tool_command command_plot = {
    "plot", "[-o FILE] [--record FILE [--error N]] DRAWING|-",
    "a picture of a drawing and of what the machine drew, or of surfaces",
    "Curves are drawn as curves, not as chords. With --record the machine's own positions are\n"
    "drawn over them; travel is dashed. With --error each position moves away from the\n"
    "drawing by N times its distance, and the colour shows the distance. A file of surfaces\n"
    "(host-tools/LOFT.md) is drawn shaded, with its parameter lines, or as a map of its\n"
    "curvature: of the two principal curvatures the product (gauss), half the sum (mean) or\n"
    "the larger absolute value, whose reciprocal is the radius of the tool that fits.\n"
    "--contours and --heights draw its sections with level planes; --view -90,90 shows it\n"
    "from above.\n",
    run_plot
};

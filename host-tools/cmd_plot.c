/* host-tools/cmd_plot.c -- loft plot: a picture of the drawing and of what the machine made of it
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "curve.h"
#include "plot.h"
#include "tool.h"

static int print_result(const plot_options *o, const plot_result *found)
{
    if (o->r == NULL)
        return printf("%s: %zu curves\n", o->output, o->d->of ? o->d->of->count : o->d->count) < 0 ? EX_IOERR : EX_OK;
    return printf("%s: %zu curves, %zu pulses with the pen down, path error %.4f mm at worst, at %.3f,%.3f, %.4f mm on average\n",
                  o->output, o->d->count, found->drawing_pulses, found->worst, found->worst_point[0], found->worst_point[1],
                  found->mean) < 0 ? EX_IOERR : EX_OK;
}

static int plot_files(plot_options *o, const char *record_file)
{
    drawing d = { 0 };
    record r  = { 0 };
    plot_result found = { 0 };
    int code = drawing_read(&d, o->name);

    o->d = &d;
    if (code == 0 && record_file != NULL) {
        code = record_read(&r, record_file);
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

static int run(const tool_command *self, int argc, char **argv)
{
    const char *record_file = NULL;
    tool_list part = { .count = 0 };
    plot_options o = { .error = PLOT_NO_ERROR, .comb = PLOT_NO_COMB, .output = "plot.png" };
    int first;

    const tool_option options[] = {
        TOOL_TEXT("output", "FILE", &o.output, "or -o: picture to write, .png .svg or .pdf (plot.png)"),
        TOOL_TEXT("record", "FILE", &record_file, "pulses written by `loft simulate --record`: what was really drawn"),
        TOOL_SWITCH("control", &o.control, "draw the control polygons, and the knots of splines"),
        TOOL_MAYBE("comb", "SCALE", &o.comb, 1e-6, 1e9, "draw curvature combs, SCALE mm for 1/mm (as it shows best)"),
        TOOL_NUMBER("error", "N", &o.error, 0, 1e9, "magnify errors N times, and colour by them (0: as it shows best)"),
        TOOL_LIST("part", "X,Y,W,H", &part, -1e5, 1e5, "show this part only, in mm from the lower left corner"),
        TOOL_NUMBER("size", "WIDTH", &o.size, 10, 30000, "px of a PNG (1600), mm of the others (true to scale)"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);

    if (code == TOOL_HELP)
        code = EX_OK;
    else if (code == 0 && argc - first != 1)
        code = tool_error(EX_USAGE, "plot: give one drawing: see `loft plot --help`");
    else if (code == 0 && part.count != 0 && (part.count != 4 || part.value[2] <= 0 || part.value[3] <= 0))
        code = tool_error(EX_USAGE, "--part: give x,y,width,height in mm");
    else if (code == 0 && o.error >= 0 && record_file == NULL)
        code = tool_error(EX_USAGE, "--error: give --record FILE as well: errors are those of a machine");
    else if (code == 0) {
        if (part.count == 4)
            memcpy(o.part, part.value, sizeof o.part);
        o.name = argv[first];
        code = plot_files(&o, record_file);
    }
    return code;
}

const tool_command command_plot = {
    "plot", "[-o FILE] [--record FILE [--error N]] DRAWING|-", "a picture of the drawing, and of what the machine drew",
    "Curves are drawn as such, not as chords. With --record the machine's own positions lie over them, travel is dashed;\n"
    "with --error each position is moved away from the drawing by N times its distance, and the colour tells how far.\n",
    run
};

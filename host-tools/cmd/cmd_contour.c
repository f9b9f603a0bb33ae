/* host-tools/cmd/cmd_contour.c -- loft contour: waterlines of surfaces, as curves or as rows
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/contour.h"   /* contour_heights */
#include "engine/print.h"   /* print_words */
#include "base/source.h"    /* source_name */
#include "engine/surface.h"
#include "base/tool.h"

#define ROUGH 24        /* cells along each parameter, for the extent of a surface */

typedef struct {
    print_options p;
    const char *file;
    double tol;
    unsigned n;
    bool rows;
    tool_list heights;
    size_t surface;             /* the number of the current surface */
    double height;
    double (*point)[ENGINE_AXES];       /* points of the curve that is followed */
    size_t points, room, curves;
} contouring;


// Curves
// ------

static void print_curve_of(contouring *c)
{
    if (c->points < 2)          /* a corner that is only touched */
        return;
    if (!c->rows)
        printf("line                # surface %zu, z = %.9g%s\n", c->surface, c->height,
               memcmp(c->point[0], c->point[c->points - 1], sizeof c->point[0]) == 0 ? ", closed"
                                                                                     : "");
    for (size_t i = 0; i < c->points; i++) {
        if (c->rows)
            printf("%zu,%.9g,%zu", c->surface, c->height, c->curves);
        for (int k = 0; k < (c->p.solid ? ENGINE_AXES : 2); k++) {
            fputs(c->rows ? "," : k ? " " : "", stdout);
            print_number(c->p.e, c->point[i][k]);
        }
        putchar('\n');
    }
    c->curves++;
}

static void take_point(void *context, bool first, const double point[ENGINE_AXES])
{
    contouring *c = context;

    if (first) {
        print_curve_of(c);
        c->points = 0;
    }
    if (c->points > 0 && memcmp(c->point[c->points - 1], point, sizeof c->point[0]) == 0)
        return;                 /* the contour crosses both edges in one point */
    if (c->points == c->room) {
        c->room  = c->room ? 2 * c->room : 256;
        c->point = tool_grow(c->point, c->room * sizeof *c->point);
    }
    memcpy(c->point[c->points++], point, sizeof c->point[0]);
}

static int one_surface(contouring *c, const surface *s)
{
    const engine_surfaces *make = c->p.e->surface;
    engine_surface *held;
    int status = make->open(s, &held);

    if (status == 0) {
        for (size_t i = 0; i < c->heights.count && status == 0; i++) {
            c->height = c->heights.value[i];
            status = make->contour(held, c->height, c->tol, c->n, take_point, c);
            print_curve_of(c);
            c->points = 0;
        }
        make->close(held);
    }
    return status == 0 ? EX_OK
                       : tool_error(EX_DATAERR, "%s:%u: %s: %s", c->file, s->line,
                                    surface_name(s->kind), surface_status(s, status));
}


// Heights
// -------

static int find_heights(contouring *c, const surfaces *all, unsigned levels, double extent[2])
{
    mesh m   = { 0 };
    int code = mesh_make(&m, all, c->file, c->p.e, ROUGH, ROUGH);

    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    for (size_t i = 0; i < m.vertices && code == 0; i++) {
        extent[0] = fmin(extent[0], m.vertex[i].p[2]);
        extent[1] = fmax(extent[1], m.vertex[i].p[2]);
    }
    if (code == 0 && c->heights.count == 0)
        c->heights.count = contour_heights(&m, levels, c->heights.value, TOOL_LIST_MAX);
    mesh_free(&m);
    return code;
}

static int print_contours(contouring *c, const surfaces *all, unsigned levels)
{
    double extent[2];
    int code = find_heights(c, all, levels, extent);

    if (code == 0 && c->rows)
        printf("surface,height,curve,x,y%s\n", c->p.solid ? ",z" : "");
    for (size_t i = 0; i < all->count && code == 0; i++) {
        c->surface = i + 1;
        code = one_surface(c, &all->surface[i]);
    }
    if (code == 0 && c->curves == 0)
        code = tool_error(
            EX_DATAERR,
            "%s: no waterline: the surfaces reach from z = %.6g to %.6g mm, give --heights between",
            c->file, extent[0], extent[1]);
    free(c->point);
    return code;
}

static int run_contour(const tool_command *self, int argc, char **argv)
{
    contouring c    = { .p = { &engine_q16, true }, .tol = 0.001, .n = 128 };
    unsigned levels = 0;
    bool flat       = false;
    surfaces all    = { 0 };
    int first;

    const tool_option options[] = {
        TOOL_COUNT("levels", "N", &levels, 1, 200, "about N of them, at round heights (10)"),
        TOOL_LIST("heights", "Z,..", &c.heights, -1e5, 1e5, "at these heights"),
        TOOL_COUNT("n", "N", &c.n, 3, 1024,
                   "cells along each parameter in which they are looked for (128)"),
        TOOL_NUMBER("tol", "MM", &c.tol, 0, 1000, "of the height (0.001)"),
        TOOL_SWITCH("csv", &c.rows, "rows surface,height,curve,x,y,z, instead of .loft"),
        TOOL_SWITCH("flat", &flat, "without z: a map, which `loft stream` draws"),
        ENGINE_OPTION(&c.p.e, "number type (q16)"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (argc - first != 1)
        return tool_error(EX_USAGE, "contour: give one file: see `loft contour --help`");
    if (levels > 0 && c.heights.count > 0)
        return tool_error(EX_USAGE, "--levels and --heights: give one of them");
    c.file    = source_name(argv[first]);
    c.p.solid = !flat;
    code = surfaces_read_only(&all, argv[first]);
    if (code == 0)
        code = print_contours(&c, &all, levels ? levels : 10);
    surfaces_free(&all);
    return code;
}

const tool_command command_contour = {
    "contour", "[--levels N|--heights Z,..] FILE|-", "waterlines of surfaces, point by point",
    "FILE has surfaces of any kind in the format of host-tools/LOFT.md. The curves of a\n"
    "height are found on a grid of N by N cells, and their points on the surface itself, in\n"
    "the number type. Prints a `line` in .loft for each curve, which all commands read. A\n"
    "closed curve ends in its first point. Seen from above, with u to the right and v upward,\n"
    "the higher side is to the left. A peak between the corners of a cell is not found. `loft\n"
    "contour --flat FILE | loft stream -` draws a map.\n",
    run_contour
};

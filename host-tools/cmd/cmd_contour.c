/* host-tools/cmd/cmd_contour.c -- loft contour: waterlines, sections by planes, isophotes and
 * silhouettes of surfaces, as curves or as rows
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "geometry/surface_text.h"
#include "num/status.h"     /* LOFT_ERR_ARG */

#include "draw/mesh_contour.h"   /* contour_heights */
#include "geometry/print.h"   /* print_words */
#include "base/source.h"    /* source_name */
#include "engine/surface.h"

#define ROUGH 24        /* cells along each parameter, for the extent of a surface */

typedef struct {
    print_options p;
    const char *file;
    double tol;
    unsigned n;
    bool rows;
    option_list heights;
    size_t surface;             /* the number of the current surface */
    engine_level level;         /* heights, distances or angles */
    double (*point)[ENGINE_AXES];       /* points of the curve that is followed */
    size_t points, room, curves;
} contouring;


// Curves
// ------

static const char *const level_name[] = { "z", "distance", "angle" };

static void print_curve_of(contouring *c)
{
    if (c->points < 2)          /* a corner that is only touched */
        return;
    if (!c->rows)
        printf("line                # surface %zu, %s = %s%s\n", c->surface,
               level_name[c->level.of], number_text(c->p.e, c->level.value),
               memcmp(c->point[0], c->point[c->points - 1], sizeof c->point[0]) == 0 ? ", closed"
                                                                                     : "");
    for (size_t i = 0; i < c->points; i++) {
        if (c->rows)
            printf("%zu,%s,%zu", c->surface, number_text(c->p.e, c->level.value), c->curves);
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

/* Where the lines that were found may not be those of the surface. */
static int warn_of_doubt(const contouring *c, const surface *s, engine_surface *held,
                         const engine_doubt *doubt)
{
    double p[ENGINE_AXES];

    if (doubt->parts == 0 || c->p.e->surface->eval(held, doubt->at[0], doubt->at[1], p) != 0)
        return EX_OK;
    return tool_error(
        EX_OK,
        "%s:%u: %s: near %.6g %.6g %.6g, and in %u parts of 1/1024 in all, the surface "
        "runs along %s = %s: lines may be joined otherwise there: give another of "
        "--heights",
        c->file, s->line, surface_name(s->kind), p[0], p[1], p[2], doubt->parts,
        level_name[c->level.of], number_text(c->p.e, c->level.value));
}

static int one_surface(contouring *c, const surface *s)
{
    const engine_surfaces *make = c->p.e->surface;
    engine_surface *held;
    int status = make->open(s, &held), code = EX_OK;

    if (status == 0) {
        for (size_t i = 0; i < c->heights.count && status == 0 && code == EX_OK; i++) {
            engine_doubt doubt;
            c->level.value = c->heights.value[i];
            status = make->contour(held, &c->level, c->tol, c->n, &doubt, take_point, c);
            print_curve_of(c);
            c->points = 0;
            if (status == 0)
                code = warn_of_doubt(c, s, held, &doubt);
        }
        make->close(held);
    }
    return status == 0 ? code
                       : tool_error(EX_DATAERR, "%s:%u: %s: %s", c->file, s->line,
                                    surface_name(s->kind), surface_status(s, status));
}


// Heights
// -------

static double distance_along(const double d[ENGINE_AXES], const double p[ENGINE_AXES])
{
    return (d[0] * p[0] + d[1] * p[1] + d[2] * p[2]) /
           sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

static int find_heights(contouring *c, const surfaces *all, unsigned levels, double extent[2])
{
    mesh m   = { 0 };
    int code = mesh_make(tool_host(), &m, all, c->file, c->p.e, ROUGH, ROUGH);

    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    for (size_t i = 0; i < m.vertices && code == 0; i++) {
        if (c->level.of == ENGINE_LEVEL_PLANE)
            m.vertex[i].p[2] = distance_along(c->level.direction, m.vertex[i].p);
        extent[0] = fmin(extent[0], m.vertex[i].p[2]);
        extent[1] = fmax(extent[1], m.vertex[i].p[2]);
    }
    if (code == 0 && c->heights.count == 0)
        c->heights.count = contour_heights(&m, levels, c->heights.value, OPTION_LIST_MAX);
    mesh_free(&m);
    return code;
}

static int print_contours(contouring *c, const surfaces *all, unsigned levels)
{
    double extent[2] = { 0, 0 };
    int code = c->level.of == ENGINE_LEVEL_ANGLE ? 0 : find_heights(c, all, levels, extent);

    if (code == 0 && c->rows)
        printf("surface,height,curve,x,y%s\n", c->p.solid ? ",z" : "");
    for (size_t i = 0; i < all->count && code == 0; i++) {
        c->surface = i + 1;
        code = one_surface(c, &all->surface[i]);
    }
    if (code == 0 && c->curves == 0)
        code = c->level.of == ENGINE_LEVEL_ANGLE
                   ? tool_error(EX_DATAERR,
                                "%s: no line: no normal has such an angle: give other "
                                "--heights, or another --light",
                                c->file)
                   : tool_error(EX_DATAERR,
                                "%s: no waterline: the surfaces reach from %s = %.6g to %.6g mm, "
                                "give --heights between",
                                c->file, level_name[c->level.of], extent[0], extent[1]);
    free(c->point);
    return code;
}

/* Heights, or what --along and --light ask for. */
static int take_direction(contouring *c, const option_list *along, const option_list *light,
                          unsigned *levels)
{
    const option_list *given = along->count ? along : light;
    double length = 0;

    if (along->count == 0 && light->count == 0)
        return 0;
    for (size_t i = 0; i < given->count && i < ENGINE_AXES; i++) {
        c->level.direction[i] = given->value[i];
        length += fabs(given->value[i]);
    }
    if (!(length > 0))
        return tool_error(EX_USAGE, "--%s: give a direction X,Y,Z that is not 0",
                          along->count ? "along" : "light");
    c->level.of = along->count ? ENGINE_LEVEL_PLANE : ENGINE_LEVEL_ANGLE;
    if (along->count > 0 || c->heights.count > 0)
        return 0;
    const unsigned n = *levels ? *levels : 1;           /* angles within 0..180 */
    for (unsigned k = 0; k < n && k < OPTION_LIST_MAX; k++)
        c->heights.value[c->heights.count++] = 180.0 * (k + 1) / (n + 1);
    *levels = 0;
    return 0;
}

typedef struct {
    const char *file;
    unsigned levels, n;         /* levels 0: not given */
    option_list heights, along, light;
    double tol;
    bool csv, flat;
    const engine *e;
} contour_options;

static const option contour_rows[] = {
    { "levels", OPTION_INTEGER(contour_options, levels), .least = 1, .most = 200, .value = "N",
      .help = "about N of them, at round heights (10)" },
    { "heights", OPTION_LIST(contour_options, heights), .least = -1e5, .most = 1e5, .value = "Z,..",
      .help = "at these heights" },
    { "along", OPTION_LIST(contour_options, along), .least = -32768, .most = 32767,
      .value = "X,Y,Z", .counts = "3", .remedy = "give a direction X,Y,Z that is not 0",
      .help = "sections by planes at a right angle to this direction, not to z; heights are "
              "distances along it" },
    { "light", OPTION_LIST(contour_options, light), .least = -32768, .most = 32767,
      .value = "X,Y,Z", .counts = "3", .remedy = "give a direction X,Y,Z that is not 0",
      .help = "isophotes of this direction: heights are angles between it and the normal, in "
              "degrees (90: the silhouette)" },
    { "n", OPTION_INTEGER(contour_options, n), .least = 3, .most = 1024, .value = "N",
      .standard = "128", .help = "cells along each parameter in which they are looked for" },
    { "tol", OPTION_NUMBER(contour_options, tol), .least = 0, .most = 1000, .unit = "mm",
      .standard = "0.001", .help = "of the height; of the cosine of an angle" },
    { "csv", OPTION_FLAG(contour_options, csv),
      .help = "rows surface,height,curve,x,y,z, instead of .loft" },
    { "flat", OPTION_FLAG(contour_options, flat),
      .help = "without z: a map, which `loft stream` draws" },
    ENGINE_ROW(contour_options, e, "q16", "number type"),
    { "file", OPTION_WORD(contour_options, file), .least = 1, .value = "FILE",
      .remedy = "give one file" },
    OPTION_EXCLUDES("levels", "heights", NULL),
    OPTION_EXCLUDES("along", "light", NULL),
    { 0 }
};

static int run_contour(void *options)
{
    const contour_options *o = options;
    contouring c    = { .p = { o->e, !o->flat },
                        .file = source_name(o->file),
                        .tol = o->tol,
                        .n = o->n,
                        .rows = o->csv,
                        .heights = o->heights };
    unsigned levels = o->levels;
    surfaces all    = { 0 };
    int code        = take_direction(&c, &o->along, &o->light, &levels);

    if (code == 0)
        code = surfaces_read_only(tool_host(), &all, o->file);
    if (code == 0)
        code = print_contours(&c, &all, levels ? levels : 10);
    surfaces_free(&all);
    return code;
}

const command command_contour = {
    .name = "contour",
    .arguments = "[--levels N|--heights Z,..] [--along X,Y,Z|--light X,Y,Z] FILE|-",
    .summary = "waterlines, plane sections, isophotes, silhouettes of surfaces",
    .detail =
        "FILE has surfaces of any kind in the format of host-tools/LOFT.md. The curves of a\n"
        "height are found on a grid of N by N cells, and their points on the surface itself, in\n"
        "the number type. Prints a `line` in .loft for each curve, which all commands read. A\n"
        "closed curve ends in its first point. Seen from above, with u to the right and v upward,\n"
        "the higher side is to the left. For heights and planes the grid is made finer, up to "
        "1024\n"
        "cells, until no line is missing or joined otherwise; where that is not certain a warning\n"
        "says so. Of angles a ring between the corners of a cell is not found. `loft\n"
        "contour --flat FILE | loft stream -` draws a map.\n",
    .options = contour_rows,
    .size = sizeof(contour_options),
    .run = run_contour,
};

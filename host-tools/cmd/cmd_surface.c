/* host-tools/cmd/cmd_surface.c -- loft surface: a mesh of triangles
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "cmd/commands.h"
#include "base/say.h"
#include "draw/mesh.h"
#include "draw/refine.h"
#include "base/create.h"      /* create_check */
#include "base/source.h"     /* source_name */
#include "engine/surface.h"
#include "geometry/print.h"   /* number_text */
#include "geometry/surface_text.h"

static void print_body(const refined *r, const engine *e, double tol)
{
    refined_sum b;

    refined_body(r, &b);
    printf("%zu corners, %zu edges, Euler number %lld, %s", b.corners, b.edges,
           (long long)b.corners - (long long)b.edges + (long long)b.triangles,
           b.open + b.turned + b.many ? "not closed:" : "closed\n");
    if (b.open + b.turned + b.many)
        printf(" %zu edge%s open, %zu turned, %zu of more than two triangles\n", b.open,
               tool_s(b.open), b.turned, b.many);
    printf("area %s\n", number_text(e, b.area));
    if (b.open + b.turned + b.many == 0)
        printf("volume %s, within %s\ncentroid %s %s %s\n", number_text(e, b.volume),
               bound_text(tol * b.area), number_text(e, b.centroid[0]),
               number_text(e, b.centroid[1]), number_text(e, b.centroid[2]));
}

/* Triangles within a tolerance, and what they are together. */
static int refine(const surfaces *all, const char *file, const engine *e, double tol, mesh *m,
                  const char *output)
{
    refined r = { 0 };
    size_t triangles;
    int code = refine_surfaces(tool_host(), &r, all, file, e, tol);

    if (code == 0)
        code = refined_mesh(tool_host(), &r, all, file, m);
    if (code == 0)
        code = mesh_write(tool_host(), m, output, &triangles);
    if (code == 0) {
        (void)say(stdout, "%s: %zu surface%s, %zu triangles\n", output, all->count,
                  tool_s(all->count), triangles);
        print_body(&r, e, tol);
    }
    refined_free(&r);
    return code;
}

typedef struct {
    const char *file, *output;
    unsigned n;
    double tol;                 /* 0: N steps */
    const engine *e;
} mesh_options;

static const option mesh_rows[] = {
    { "output", OPTION_FILE(mesh_options, output), .value = "FILE", .standard = "mesh.stl",
      .help = "or -o: mesh to write, .stl or .ply" },
    { "n", OPTION_INTEGER(mesh_options, n), .least = 1, .most = 2000, .value = "N",
      .standard = "32", .help = "steps along each parameter of each surface" },
    { "tol", OPTION_NUMBER(mesh_options, tol), .least = 0.0001, .most = 1000, .unit = "mm",
      .help = "not N steps, but triangles within this distance of the surface" },
    ENGINE_ROW(mesh_options, e, "q16", "number type"),
    { "file", OPTION_WORD(mesh_options, file), .least = 1, .value = "FILE",
      .remedy = "give one file" },
    OPTION_EXCLUDES("n", "tol", NULL),
    { 0 }
};

/* Grids of N steps. */
static int make_grids(const mesh_options *o, const surfaces *all, mesh *m)
{
    const unsigned n = o->n;
    size_t triangles = 0;

    if (all->count * n * n > 40000000)
        return tool_error(EX_USAGE, "--n %u: %zu triangles are too many: give less", n,
                          2 * all->count * n * n);
    int code = mesh_make(tool_host(), m, all, source_name(o->file), o->e, n, n);
    if (code == 0)
        code = mesh_write(tool_host(), m, o->output, &triangles);
    if (code == 0 && say(stdout, "%s: %zu surface%s, %zu triangles\n", o->output, all->count,
                         tool_s(all->count), triangles) < 0)
        code = EX_IOERR;
    return code;
}

static int run_surface(void *options)
{
    const mesh_options *o = options;
    surfaces all          = { 0 };
    mesh m                = { 0 };
    int code              = create_check(tool_host(), o->output);

    if (code == 0)
        code = surfaces_read_only(tool_host(), &all, o->file);
    if (code == 0 && o->tol > 0)
        code = refine(&all, source_name(o->file), o->e, o->tol, &m, o->output);
    else if (code == 0)
        code = make_grids(o, &all, &m);
    mesh_free(&m);
    surfaces_free(&all);
    return code;
}

const command command_surface = {
    .name = "surface",
    .arguments = "[--n N|--tol MM] [-o FILE] FILE|-",
    .summary = "a mesh of triangles of surfaces, as STL or PLY",
    .detail =
        "FILE has surfaces of any kind in the format of host-tools/LOFT.md. Every surface becomes\n"
        "a grid of N by N cells of two triangles each (a triangle: N rows). Triangles without\n"
        "area, as at the poles of a sphere, are left out. Corners are points that the library\n"
        "computes in the number type. PLY has a normal at each corner.\n"
        "With --tol triangles are halved where the surface is farther from them, at three places\n"
        "of an edge or in the middle of a triangle. Patches that continue each other along an "
        "edge\n"
        "have the same corners there. Then prints the Euler number, whether the mesh is closed,\n"
        "the area, and of a closed mesh the volume and its centroid.\n",
    .options = mesh_rows,
    .size = sizeof(mesh_options),
    .run = run_surface,
};

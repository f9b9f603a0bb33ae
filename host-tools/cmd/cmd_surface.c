/* host-tools/cmd/cmd_surface.c -- loft surface: a mesh of triangles
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "base/say.h"
#include "draw/mesh.h"
#include "draw/refine.h"
#include "base/create.h"      /* create_check */
#include "base/source.h"     /* source_name */
#include "engine/surface.h"
#include "base/tool.h"
#include "geometry/surface_text.h"

static void print_body(const refined *r, double tol)
{
    refined_sum b;

    refined_body(r, &b);
    printf("%zu corners, %zu edges, Euler number %lld, %s", b.corners, b.edges,
           (long long)b.corners - (long long)b.edges + (long long)b.triangles,
           b.open + b.turned + b.many ? "not closed:" : "closed\n");
    if (b.open + b.turned + b.many)
        printf(" %zu edge%s open, %zu turned, %zu of more than two triangles\n", b.open,
               tool_s(b.open), b.turned, b.many);
    printf("area %.9g\n", b.area);
    if (b.open + b.turned + b.many == 0)
        printf("volume %.9g, within %.3g\ncentroid %.9g %.9g %.9g\n", b.volume, tol * b.area,
               b.centroid[0], b.centroid[1], b.centroid[2]);
}

/* Triangles within a tolerance, and what they are together. */
static int refine(const surfaces *all, const char *file, const engine *e, double tol, mesh *m,
                  const char *output)
{
    refined r = { 0 };
    size_t triangles;
    int code = refine_surfaces(&r, all, file, e, tol);

    if (code == 0)
        code = refined_mesh(&r, all, file, m);
    if (code == 0)
        code = mesh_write(m, output, &triangles);
    if (code == 0) {
        (void)say(stdout, "%s: %zu surface%s, %zu triangles\n", output, all->count,
                  tool_s(all->count), triangles);
        print_body(&r, tol);
    }
    refined_free(&r);
    return code;
}

static int run_surface(const tool_command *self, int argc, char **argv)
{
    const engine *e    = &engine_q16;
    const char *output = "mesh.stl";
    unsigned n         = 0;
    double tol         = 0;
    surfaces all       = { 0 };
    mesh m             = { 0 };
    size_t triangles   = 0;
    int first;

    const tool_option options[] = {
        TOOL_TEXT("output", "FILE", &output, "or -o: mesh to write, .stl or .ply (mesh.stl)"),
        TOOL_COUNT("n", "N", &n, 1, 2000, "steps along each parameter of each surface (32)"),
        TOOL_NUMBER("tol", "MM", &tol, 0.0001, 1000,
                    "not N steps, but triangles within this distance of the surface"),
        ENGINE_OPTION(&e, "number type (q16)"), TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (argc - first != 1)
        return tool_error(EX_USAGE, "surface: give one file: see `loft surface --help`");
    if (n > 0 && tol > 0)
        return tool_error(EX_USAGE, "--n and --tol: give one of them");
    n = n ? n : 32;
    code = create_check(tool_host(), output);
    if (code == 0)
        code = surfaces_read_only(tool_host(), &all, argv[first]);
    if (code == 0 && tol > 0) {
        code = refine(&all, source_name(argv[first]), e, tol, &m, output);
        mesh_free(&m);
        surfaces_free(&all);
        return code;
    }
    if (code == 0 && all.count * n * n > 40000000)
        code = tool_error(EX_USAGE, "--n %u: %zu triangles are too many: give less", n,
                          2 * all.count * n * n);
    if (code == 0)
        code = mesh_make(&m, &all, source_name(argv[first]), e, n, n);
    if (code == 0)
        code = mesh_write(&m, output, &triangles);
    if (code == 0 && say(stdout, "%s: %zu surface%s, %zu triangles\n", output, all.count,
                         tool_s(all.count), triangles) < 0)
        code = EX_IOERR;
    mesh_free(&m);
    surfaces_free(&all);
    return code;
}

const tool_command command_surface = {
    "surface", "[--n N|--tol MM] [-o FILE] FILE|-",
    "a mesh of triangles of surfaces, as STL or PLY",
    "FILE has surfaces of any kind in the format of host-tools/LOFT.md. Every surface becomes\n"
    "a grid of N by N cells of two triangles each (a triangle: N rows). Triangles without\n"
    "area, as at the poles of a sphere, are left out. Corners are points that the library\n"
    "computes in the number type. PLY has a normal at each corner.\n"
    "With --tol triangles are halved where the surface is farther from them, at three places\n"
    "of an edge or in the middle of a triangle. Patches that continue each other along an edge\n"
    "have the same corners there. Then prints the Euler number, whether the mesh is closed,\n"
    "the area, and of a closed mesh the volume and its centroid.\n",
    run_surface
};

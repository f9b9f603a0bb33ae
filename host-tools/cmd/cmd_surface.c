/* host-tools/cmd/cmd_surface.c -- loft surface: a mesh of triangles
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "draw/mesh.h"
#include "base/source.h"     /* source_name */
#include "engine/surface.h"
#include "base/tool.h"

static int run_surface(const tool_command *self, int argc, char **argv)
{
    const engine *e    = &engine_q16;
    const char *output = "mesh.stl";
    unsigned n         = 32;
    surfaces all       = { 0 };
    mesh m             = { 0 };
    size_t triangles   = 0;
    int first;

    const tool_option options[] = {
        TOOL_TEXT("output", "FILE", &output, "or -o: mesh to write, .stl or .ply (mesh.stl)"),
        TOOL_COUNT("n", "N", &n, 1, 2000, "steps along each parameter of each surface (32)"),
        ENGINE_OPTION(&e, "number type (q16)"), TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (argc - first != 1)
        return tool_error(EX_USAGE, "surface: give one file: see `loft surface --help`");
    code = surfaces_read_only(&all, argv[first]);
    if (code == 0 && all.count * n * n > 40000000)
        code = tool_error(EX_USAGE, "--n %u: %zu triangles are too many: give less", n,
                          2 * all.count * n * n);
    if (code == 0)
        code = mesh_make(&m, &all, source_name(argv[first]), e, n, n);
    if (code == 0)
        code = mesh_write(&m, output, &triangles);
    if (code == 0 && printf("%s: %zu surface%s, %zu triangles\n", output, all.count,
                            tool_s(all.count), triangles) < 0)
        code = EX_IOERR;
    mesh_free(&m);
    surfaces_free(&all);
    return code;
}

const tool_command command_surface = {
    "surface", "[--n N] [-o FILE] FILE|-", "a mesh of triangles of surfaces, as STL or PLY",
    "FILE has surfaces of any kind in the format of host-tools/LOFT.md. Every surface becomes\n"
    "a grid of N by N cells of two triangles each (a triangle: N rows). Triangles without\n"
    "area, as at the poles of a sphere, are left out. Corners are points that the library\n"
    "computes in the number type. PLY has a normal at each corner.\n",
    run_surface
};

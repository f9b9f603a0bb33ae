/* host-tools/cmd/measure_surface.c
 * SPDX-License-Identifier: MIT
 */
#include "base/source.h"    /* source_name */
#include "cmd/measure_surface.h"
#include "engine/surface.h"
#include "geometry/surface_text.h"
#include "make/decide.h"   /* decide_surfaces */

int measure_surfaces(const char *file, const engine *e, const option_list *at, double tol,
                     bool path, bool *done)
{
    const option_list within = { .value = { tol }, .count = 1 };
    surfaces all = { 0 };
    int code = surfaces_read(tool_host(), &all, file);

    *done = code == 0 && all.count > 0;
    if (*done && path)
        code = tool_error(
            EX_USAGE,
            "%s: holds surfaces: `loft make meet`, `loft decide join` and `loft mill` "
            "say where they meet, how they join, and the path over them",
            source_name(file));
    else if (*done && at->count == 2)
        code = tool_error(EX_USAGE, "--nearest: give x,y,z: %s holds surfaces", source_name(file));
    else if (*done)
        code = decide_surfaces(tool_host(), at->count ? "nearest" : "area", e,
                               at->count ? at : &within, &all, file);
    surfaces_free(&all);
    return code;
}

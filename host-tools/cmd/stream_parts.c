/* host-tools/cmd/stream_parts.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "base/tool.h"
#include "cmd/stream_parts.h"

int stream_parts_find(const stream_options *o, const char *file, const drawing *d,
                      const drawing *smooth, stream_parts *all)
{
    all->file  = file;
    all->count = tools_split(&o->p.machine.tools, d, smooth, all->part);
    all->first = 0;
    if (all->count == 0)
        return tool_error(EX_DATAERR, "%s: more than %u changes of the tool: split the program",
                          file, TOOLS_PARTS);
    if (o->from_tool == NULL)
        return 0;
    for (; all->first < all->count; all->first++)
        if (all->part[all->first].tool != NULL &&
            strcmp(all->part[all->first].tool->name, o->from_tool) == 0)
            return 0;
    return tool_error(EX_USAGE,
                      "--from-tool %s: %s draws nothing here: `--dry-run` lists those that do",
                      o->from_tool,
                      machine_tools_find(&o->p.machine.tools, o->from_tool)
                          ? "this tool"
                          : "it is not in the machine file, so it");
}

toolpath_options stream_parts_way(const stream_options *o, const stream_parts *all, size_t k)
{
    toolpath_options how = planning_path(&o->p);
    const bool last      = k + 1 == all->count;

    how.lift = tools_lift(all->part[k].tool, o->p.lift);
    if (all->part[k].d.program && k > 0)
        tools_counted(&all->part[k].d, how.counted);
    if (last || all->part[k].d.program)
        return how;
    how.park    = *all->part[k + 1].tool->pause != '\0';
    how.zero[0] = o->p.machine.park[0];
    how.zero[1] = o->p.machine.park[1];
    how.zero[2] = NAN;
    return how;
}

/* host-tools/cmd/stream_parts.c
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "base/tool.h"
#include "cmd/stream_parts.h"

int stream_parts_find(const stream_options *o, const char *file, const drawing *d,
                      const drawing *smooth, plan_parts *all)
{
    const int code = parts_find(tool_host(), &o->p, file, d, smooth, all);

    if (code != 0 || o->from_tool == NULL)
        return code;
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

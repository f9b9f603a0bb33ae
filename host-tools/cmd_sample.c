/* host-tools/cmd_sample.c -- loft sample: a curve at equal parameter steps, by exact forward differences
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "points.h"     /* points_read */
#include "tool.h"

static int print_walks(const engine *e, const points *all, uint32_t n, const char *file)
{
    points_printing p = { e, all->solid };

    for (size_t i = 0; i < all->count; i++) {
        const points_curve *c = &all->curve[i];
        int status = points_print_start(&p, all, i);

        if (status == 0)
            status = e->walk((const double (*)[ENGINE_AXES])c->p, c->degree, n, points_print, &p);
        if (status != 0)
            return tool_error(EX_DATAERR, "%s:%u: degree %u in %u steps: %s", file, c->line, c->degree, (unsigned)n, engine_status(status));
    }
    return EX_OK;
}

static int run(const tool_command *self, int argc, char **argv)
{
    const engine *e  = &engine_q16;
    const char *text = NULL;
    unsigned n       = 64;
    points all       = { 0 };
    int first;

    const tool_option options[] = {
        TOOL_COUNT("n", "N", &n, 1, 1e9, "equal parameter steps per curve (64)"),
        TOOL_TEXT("points", "POINTS", &text, "the control points themselves: \"0,0 1,2 3,0\""),
        TOOL_ENGINE(&e, "number type: q16, f32 or f64 (q16)"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;

    const char *file = first < argc ? argv[first] : "-";
    code = points_read(&all, file, text);
    if (code == 0)
        code = print_walks(e, &all, n, text ? "--points" : file);
    points_free(&all);
    return code;
}

const tool_command command_sample = {
    "sample", "[--n N] [FILE|-]", "a curve at equal parameter steps, by exact walking",
    "FILE has one control point per line (degree 1 to 5), or is a drawing. Prints the start and N points per curve,\n"
    "an empty line where a curve does not start at the end of the one before it.\n",
    run
};

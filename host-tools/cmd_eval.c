/* host-tools/cmd_eval.c -- loft eval: points of a curve
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "points.h"     /* points_read */
#include "tool.h"

static int print_points(const engine *e, const points *all, const tool_list *t, const char *file)
{
    points_printing p = { e, all->solid };

    for (size_t i = 0; i < all->count; i++) {
        const points_curve *c = &all->curve[i];
        if (i > 0)
            putchar('\n');
        for (size_t j = 0; j < t->count; j++) {
            double at[ENGINE_AXES];
            const int status = e->eval((const double (*)[ENGINE_AXES])c->p, c->degree, t->value[j], at);
            if (status != 0)
                return tool_error(EX_DATAERR, "%s:%u: t = %g: %s", file, c->line, t->value[j], engine_status(status));
            points_print(&p, at);
        }
    }
    return EX_OK;
}

static int run(const tool_command *self, int argc, char **argv)
{
    const engine *e  = &engine_q16;
    const char *text = NULL;
    tool_list t      = { .count = 0 };
    points all       = { 0 };
    int first;

    const tool_option options[] = {
        TOOL_LIST("t", "T,..", &t, -100, 100, "parameters, 0..1 on the curve (0.5)"),
        TOOL_TEXT("points", "POINTS", &text, "the control points themselves: \"0,0 1,2 3,0\""),
        TOOL_ENGINE(&e, "number type: q16, f32 or f64 (q16)"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (t.count == 0)
        t = (tool_list){ { 0.5 }, 1 };
    const char *file = first < argc ? argv[first] : "-";
    code = points_read(&all, file, text);
    if (code == 0)
        code = print_points(e, &all, &t, text ? "--points" : file);
    points_free(&all);
    return code;
}

const tool_command command_eval = {
    "eval", "[--t T,..] [FILE|-]", "points of a curve of degree 0 to 9",
    "FILE has one control point per line, `x y` or `x y z`; an empty line ends a curve. Prints one point per\n"
    "parameter. The error in q16 is at most 1 LSB (2^-16 mm) to degree 5, degree/4 LSB above.\n",
    run
};

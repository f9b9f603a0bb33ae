/* host-tools/cmd_eval.c -- loft eval: points of a curve
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "print.h"
#include "tool.h"

static int refuse(const char *file, const curve *c, double t, int status)
{
    if (t < curve_from(c) || t > curve_to(c))
        if (!curve_extends(c))
            return tool_error(EX_DATAERR, "%s:%u: t = %g: give %g to %g for this %s", file, c->line, t, curve_from(c), curve_to(c), curve_name(c->kind));
    return tool_error(EX_DATAERR, "%s:%u: t = %g: %s", file, c->line, t, engine_status(status));
}

static int print_points(const print_options *p, const curve *c, const tool_list *t, const char *file)
{
    const engine_curves *make = p->e->curve;
    print_options how = *p;
    engine_curve *held;
    const int status = make->open(c, &held);
    int code = 0;

    if (status != 0)
        return tool_error(EX_DATAERR, "%s:%u: %s: %s", file, c->line, curve_name(c->kind), engine_status(status));
    for (size_t j = 0; (j < t->count || j == 0) && code == 0; j++) {
        const double at = t->count ? t->value[j] : (curve_from(c) + curve_to(c)) / 2;
        double point[ENGINE_AXES];
        const int bad = make->eval(held, at, point);
        if (bad != 0)
            code = refuse(file, c, at, bad);
        else
            print_point(&how, point);
    }
    make->close(held);
    return code;
}

static int print_all(const engine *e, const curves *all, const tool_list *t, const char *file)
{
    const print_options p = { e, all->solid };
    int code = EX_OK;

    for (size_t i = 0; i < all->count && code == EX_OK; i++) {
        if (i > 0)
            putchar('\n');
        code = print_points(&p, &all->curve[i], t, file);
    }
    return code;
}

static int run(const tool_command *self, int argc, char **argv)
{
    const engine *e  = &engine_q16;
    const char *text = NULL;
    tool_list t      = { .count = 0 };
    curves all       = { 0 };
    int first;

    const tool_option options[] = {
        TOOL_LIST("t", "T,..", &t, -1e6, 1e6, "parameters, 0..1 on a Bezier curve (the middle)"),
        TOOL_TEXT("points", "POINTS", &text, "the control points themselves: \"0,0 1,2 3,0\""),
        TOOL_ENGINE(&e, "number type: q16, f32 or f64 (q16)"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    const char *file = first < argc ? argv[first] : "-";
    code = curves_read(&all, file, text);
    if (code == 0)
        code = print_all(e, &all, &t, text ? "--points" : file);
    curves_free(&all);
    return code;
}

const tool_command command_eval = {
    "eval", "[--t T,..] [FILE|-]", "points of a curve",
    "FILE has one control point per line, `x y` or `x y z` (an empty line ends a curve), or curves of any kind in the\n"
    "format of host-tools/LOFT.md. Prints one point per parameter. A parameter is the curve's own: 0..1 for Bezier\n"
    "curves, 0..n over the n pieces of a spline, the knots of a B-spline.\n",
    run
};

/* host-tools/cmd_flatten.c -- loft flatten: chords that stay within a tolerance of the curve
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "points.h"     /* points_read */
#include "tool.h"

/* Degrees 1 and 2 as cubics; the same curves. */
static bool cubic_of(const points_curve *c, double out[4][ENGINE_AXES])
{
    if (c->degree < 1 || c->degree > 3)
        return false;
    for (int i = 0; i < ENGINE_AXES; i++) {
        const double a = c->p[0][i], b = c->p[1][i], z = c->p[c->degree][i];
        out[0][i] = a;
        out[1][i] = c->degree == 3 ? b : c->degree == 2 ? (a + 2 * b) / 3 : (2 * a + z) / 3;
        out[2][i] = c->degree == 3 ? c->p[2][i] : c->degree == 2 ? (2 * b + z) / 3 : (a + 2 * z) / 3;
        out[3][i] = z;
    }
    return true;
}

static int print_chords(const engine *e, const points *all, double tol, const char *file)
{
    points_printing p = { e, all->solid };

    for (size_t i = 0; i < all->count; i++) {
        const points_curve *c = &all->curve[i];
        double cubic[4][ENGINE_AXES];

        if (!cubic_of(c, cubic))
            return tool_error(EX_DATAERR, "%s:%u: degree %u: give curves of degree 1 to 3", file, c->line, c->degree);
        int status = points_print_start(&p, all, i);
        if (status == 0)
            status = e->flatten((const double (*)[ENGINE_AXES])cubic, tol, points_print, &p);
        if (status != 0)
            return tool_error(EX_DATAERR, "%s:%u: --tol %g: %s", file, c->line, tol, engine_status(status));
    }
    return EX_OK;
}

static int run(const tool_command *self, int argc, char **argv)
{
    const engine *e  = &engine_q16;
    const char *text = NULL;
    double tol       = 0.01;
    points all       = { 0 };
    int first;

    const tool_option options[] = {
        TOOL_NUMBER("tol", "MM", &tol, 1e-6, 1000, "how far a chord may leave its curve, rounding included (0.01)"),
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
        code = print_chords(e, &all, tol, text ? "--points" : file);
    points_free(&all);
    return code;
}

const tool_command command_flatten = {
    "flatten", "[--tol MM] [DRAWING|-]", "chords that stay within a tolerance of the curve",
    "DRAWING is an SVG file, lines of eight numbers (a cubic each), or control points, one per line (degree 1 to 3).\n"
    "Prints one point per line, an empty line between paths.\n",
    run
};

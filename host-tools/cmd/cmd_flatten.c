/* host-tools/cmd/cmd_flatten.c -- loft flatten: chords that stay within a tolerance of the curve
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>

#include "num/status.h"     /* LOFT_ERR_RANGE */

#include "engine/piece.h"
#include "geometry/print.h"
#include "base/source.h"         /* source_name */
#include "base/tool.h"
#include "readers.h"

typedef struct {
    print_options p;
    double tol;         /* mm, given to the command */
    double within;      /* mm, left for the chords of a cubic */
    int status;
} flattening;

static void chords(void *context, double p[4][CURVE_AXES])
{
    flattening *f = context;

    if (f->status == 0)
        f->status = f->p.e->flatten((const double(*)[ENGINE_AXES])p, f->within, print_point, &f->p);
}

/* Cubics are flattened directly. Other curves become cubics first. For lines and quadratics,
 * rounding the control points costs half an LSB per axis. For the rest, a quarter of the tolerance
 * goes there, or as much as the library needs. */
static int flatten(void *context, const curve *c, engine_curve *held)
{
    flattening *f = context;
    const engine *e = f->p.e;

    f->status = 0;
    for (unsigned i = 0; i < e->curve->pieces(held) && f->status == 0; i++) {
        piece s;
        f->status = e->curve->piece(held, i, &s);
        if (f->status != 0)
            break;
        const bool same = s.degree == 3 && c->kind == CURVE_BEZIER,
                   polynomial = s.degree <= 3 && !curve_is_rational(c);
        const double finest = engine_finest(e, &s), share = fmax(f->tol / 4, finest);
        f->within = f->tol - (same ? 0 : polynomial ? 0.22 * finest : share);
        const int status = f->within > 0 ? e->piece->cubics(&s, share, chords, f) : LOFT_ERR_RANGE;
        f->status = f->status == 0 ? status : f->status;
    }
    return f->status;
}

static int run_flatten(const tool_command *self, int argc, char **argv)
{
    const engine *e  = &engine_q16;
    const char *text = NULL;
    double tol       = 0.01;
    curves all       = { 0 };
    const char *file;

    const tool_option options[] = {
        TOOL_NUMBER("tol", "MM", &tol, 1e-6, 1000,
                    "largest distance of a chord from its curve, rounding included (0.01)"),
        TOOL_TEXT("points", "POINTS", &text, "the control points themselves: \"0,0 1,2 3,0\""),
        ENGINE_OPTION(&e, "number type (q16)"), TOOL_OPTIONS_END
    };
    int code = tool_file_options(self, options, argc, argv, &text, &file);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;

    code = curves_read(tool_host(), &all, file, text);
    if (code == 0) {
        flattening f = { .p = { e, all.solid }, .tol = tol };
        char words[40];
        snprintf(words, sizeof words, ", --tol %g", tol);
        code = print_chain(&f.p, &all, text ? "--points" : source_name(file), words, flatten, &f);
    }
    curves_free(&all);
    return code;
}

const tool_command command_flatten = {
    "flatten", "[--tol MM] [DRAWING|-]", "chords that stay within a tolerance of the curve",
    "DRAWING is an SVG file, curves of any kind (host-tools/LOFT.md), lines of eight numbers (a "
    "cubic each), or control\n"
    "points, one per line. Prints one point per line, an empty line between paths.\n",
    run_flatten
};

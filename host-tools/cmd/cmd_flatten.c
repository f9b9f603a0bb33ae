/* host-tools/cmd/cmd_flatten.c -- loft flatten: chords that stay within a tolerance of the curve
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>

#include "cmd/commands.h"
#include "num/status.h"     /* LOFT_ERR_RANGE */

#include "engine/piece.h"
#include "geometry/print.h"
#include "base/source.h"         /* source_given */
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

typedef struct {
    source_given from;
    double tol;         /* mm */
    const engine *e;
} flatten_options;

static const option flatten_rows[] = {
    { "tol", OPTION_NUMBER(flatten_options, tol), .least = 1e-6, .most = 1000, .unit = "mm",
      .standard = "0.01", .help = "largest distance of a chord from its curve, rounding included" },
    OPTION_GROUP(flatten_options, from, source_rows),
    ENGINE_ROW(flatten_options, e, "q16", "number type"),
    { 0 }
};

static int run_flatten(void *options)
{
    const flatten_options *o = options;
    curves all               = { 0 };
    int code                 = curves_read(tool_host(), &all, o->from.file, o->from.points);

    if (code == 0) {
        flattening f = { .p = { o->e, all.solid }, .tol = o->tol };
        char words[40];
        snprintf(words, sizeof words, ", --tol %g", o->tol);
        code = print_chain(tool_host(), &f.p, &all, source_given_name(&o->from), words, flatten,
                           &f);
    }
    curves_free(&all);
    return code;
}

const command command_flatten = {
    .name = "flatten",
    .arguments = "[--tol MM] [DRAWING|-]",
    .summary = "chords that stay within a tolerance of the curve",
    .detail = "DRAWING is an SVG file, curves of any kind (host-tools/LOFT.md), lines of eight "
              "numbers (a "
        "cubic each), or control\n"
        "points, one per line. Prints one point per line, an empty line between paths.\n",
    .options = flatten_rows,
    .size = sizeof(flatten_options),
    .run = run_flatten,
};

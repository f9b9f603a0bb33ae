/* host-tools/cmd/cmd_sample.c -- loft sample: a curve or a surface at equal parameter steps
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "cmd/commands.h"
#include "engine/piece.h"
#include "geometry/print.h"
#include "base/source.h"         /* source_name */
#include "engine/surface.h"
#include "readers.h"
#include "geometry/surface_text.h"

typedef struct {
    print_options p;
    uint32_t n;
} sampling;

static int walk_curve(void *context, const curve *c, engine_curve *held)
{
    sampling *s = context;
    const engine *e = s->p.e;
    int status = 0;

    (void)c;
    for (unsigned i = 0; i < e->curve->pieces(held) && status == 0; i++) {
        piece p;
        status = e->curve->piece(held, i, &p);
        if (status == 0)
            status = e->piece->walk(&p, s->n, print_point, &s->p);
    }
    return status;
}

/* Print a grid, row by row of u, with an empty line after each row and two between surfaces and
 * kites. The rows of a triangle get shorter. */
static int sample_kite(const print_options *p, const surface *s, const engine_surface *held,
                       unsigned kite, unsigned n)
{
    print_options how = *p;
    int status = 0;

    for (unsigned i = 0; i <= n && status == 0; i++) {
        for (unsigned j = 0; j <= (surface_is_triangle(s) ? n - i : n) && status == 0; j++) {
            double point[ENGINE_AXES];
            status = p->e->surface->kite(held, kite, i / (double)n, j / (double)n, point);
            if (status == 0)
                print_point(&how, point);
        }
        putchar('\n');
    }
    return status;
}

static int sample_surfaces(const surfaces *all, const char *file, const engine *e, unsigned n)
{
    const print_options p = { e, true };
    int status = 0;

    for (size_t k = 0; k < all->count && status == 0; k++) {
        const surface *s = &all->surface[k];
        engine_surface *held;
        if (k > 0)
            putchar('\n');
        status = e->surface->open(s, &held);
        if (status == 0) {
            for (unsigned kite = 0; kite < surface_kites(s) && status == 0; kite++) {
                if (kite > 0)
                    putchar('\n');
                status = sample_kite(&p, s, held, kite, n);
            }
            e->surface->close(held);
        }
        if (status != 0)
            return tool_error(EX_DATAERR, "%s:%u: %s in %u steps: %s", source_name(file), s->line,
                              surface_name(s->kind), n, surface_status(s, status));
    }
    return EX_OK;
}

typedef struct {
    source_given from;
    unsigned n;
    const engine *e;
} sample_options;

static const option sample_rows[] = { { "n", OPTION_INTEGER(sample_options, n), .least = 1,
                                        .most = 1e9, .value = "N", .standard = "64",
                                        .help = "equal parameter steps per piece of a curve" },
    OPTION_GROUP(sample_options, from, source_rows),
    ENGINE_ROW(sample_options, e, "q16", "number type"),
                                      { 0 } };

static int sample_curves(const sample_options *o)
{
    curves all = { 0 };
    int code   = curves_read(tool_host(), &all, o->from.file, o->from.points);

    if (code == 0) {
        sampling s = { { o->e, all.solid }, o->n };
        char words[40];
        snprintf(words, sizeof words, " in %u steps", o->n);
        code = print_chain(tool_host(), &s.p, &all, source_given_name(&o->from), words, walk_curve,
                           &s);
    }
    curves_free(&all);
    return code;
}

static int run_sample(void *options)
{
    const sample_options *o = options;
    surfaces patches        = { 0 };
    int code                = 0;

    if (!o->from.points)
        code = surfaces_read(tool_host(), &patches, o->from.file);
    if (code == 0)
        code = patches.count > 0 ? sample_surfaces(&patches, o->from.file, o->e, o->n)
                                 : sample_curves(o);
    surfaces_free(&patches);
    return code;
}

const command command_sample = {
    .name = "sample",
    .arguments = "[--n N] [FILE|-]",
    .summary = "a curve or a surface at equal parameter steps",
    .detail =
        "FILE has one control point per line, or curves of any kind (host-tools/LOFT.md), or is a\n"
        "drawing. Prints the start and N points per piece, and an empty line before a curve that\n"
        "does not start at the end of the one before. Curves up to degree 5 are walked by forward\n"
        "differences, others are evaluated point by point. For surfaces prints a grid of N + 1 by\n"
        "N + 1 points, u in the outer loop, with an empty line after each row (a triangle: rows\n"
        "that shrink), and two between surfaces. For patches with n sides prints a grid for each\n"
        "side, from the corner where it begins to the middle.\n",
    .options = sample_rows,
    .size = sizeof(sample_options),
    .run = run_sample,
};

/* host-tools/cmd_sample.c -- loft sample: a curve at equal parameter steps, by exact forward differences
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "piece.h"
#include "print.h"
#include "source.h"         /* source_name */
#include "tool.h"

typedef struct {
    print_options p;
    uint32_t n;
} sampling;

static int walk(void *context, const curve *c, engine_curve *held)
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

static int run(const tool_command *self, int argc, char **argv)
{
    const engine *e  = &engine_q16;
    const char *text = NULL;
    unsigned n       = 64;
    curves all       = { 0 };
    int first;

    const tool_option options[] = {
        TOOL_COUNT("n", "N", &n, 1, 1e9, "equal parameter steps per piece of a curve (64)"),
        TOOL_TEXT("points", "POINTS", &text, "the control points themselves: \"0,0 1,2 3,0\""),
        TOOL_ENGINE(&e, "number type: q16, f32 or f64 (q16)"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;

    const char *file = first < argc ? argv[first] : "-";
    code = curves_read(&all, file, text);
    if (code == 0) {
        sampling s = { { e, all.solid }, n };
        char words[40];
        snprintf(words, sizeof words, " in %u steps", n);
        code = print_chain(&s.p, &all, text ? "--points" : source_name(file), words, walk, &s);
    }
    curves_free(&all);
    return code;
}

const tool_command command_sample = {
    "sample", "[--n N] [FILE|-]", "a curve at equal parameter steps, by exact walking",
    "FILE has one control point per line, or curves of any kind (host-tools/LOFT.md), or is a drawing. Prints the start\n"
    "and N points per piece, an empty line where a curve does not start at the end of the one before it. Curves to\n"
    "degree 5 are walked by forward differences, others are evaluated point by point.\n",
    run
};

/* host-tools/make/decide.c -- finds the question, reads the file, asks
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "base/source.h"        /* source_name */
#include "base/tool.h"
#include "engine/curve.h"
#include "engine/engine.h"
#include "engine/surface.h"
#include "geometry/surface_text.h"
#include "make/decide.h"
#include "readers.h"

static const decide_question *question_of(const decide_question all[], unsigned count,
                                          const char *name)
{
    for (unsigned k = 0; k < count; k++)
        if (strcmp(all[k].name, name) == 0)
            return &all[k];
    return NULL;
}

static int ask(const decide_question *q, const decide_input *in, const char *what)
{
    char why[DECIDE_WHY] = "";
    decide_input asked = *in;

    asked.why = why;
    const int status = q->answer(&asked);
    if (status == 0)
        return EX_OK;
    const bool told = *why != '\0';
    if (!told && q->most > 0)
        snprintf(why, sizeof why, "%s do not suit: give %s",
                 q->takes == DECIDE_NUMBERS ? "these numbers" : "the numbers, or this file,",
                 q->numbers);
    else if (!told)
        snprintf(why, sizeof why, "what this file holds does not suit: see `loft help`");
    return tool_error(EX_DATAERR, "%s: %s: %s", what, q->name,
                      told ? why : engine_status(status, why));
}

/* The curves of one file and the surfaces of another. */
static int ask_of_both(const decide_question *q, const decide_input *numbers, char *const file[2])
{
    decide_input in = *numbers;
    curves all = { 0 };
    surfaces patches = { 0 };
    int code = curves_read(tool_host(), &all, file[0], NULL);

    if (code == 0)
        code = surfaces_read_only(tool_host(), &patches, file[1]);
    in.curves = &all;
    in.surfaces = &patches;
    if (code == 0)
        code = ask(q, &in, source_name(file[0]));
    curves_free(&all);
    surfaces_free(&patches);
    return code;
}

static int ask_of_file(const decide_question *q, const decide_input *numbers, const char *file)
{
    decide_input in = *numbers;
    curves all = { .any_weights = q->takes == DECIDE_CONICS };
    surfaces patches = { .solids = q->takes == DECIDE_SOLIDS };
    const bool only_curves = q->takes == DECIDE_CURVES || q->takes == DECIDE_CONICS;
    int code = only_curves ? 0 : surfaces_read(tool_host(), &patches, file);
    const bool curved = only_curves || ((q->takes == DECIDE_EITHER || q->takes == DECIDE_SOLIDS) &&
                                        patches.count == 0);

    if (code == 0 && curved)
        code = curves_read(tool_host(), &all, file, NULL);
    if (code == 0 && q->takes == DECIDE_SURFACES && patches.count == 0)
        code = tool_error(EX_DATAERR, "%s: holds no surface: give a file of surfaces",
                          source_name(file));
    in.curves = curved ? &all : NULL;
    in.surfaces = curved ? NULL : &patches;
    if (code == 0)
        code = ask(q, &in, source_name(file));
    curves_free(&all);
    surfaces_free(&patches);
    return code;
}

static unsigned number_type(const engine *e)
{
    return e == &engine_q16 ? 0 : e == &engine_f32 ? 1 : 2;
}

int decide_surfaces(const char *question, const engine *e, const tool_list *of, const surfaces *all,
                    const char *file)
{
    static const decide_question *const table[3] = { decide_q16, decide_f32, decide_f64 };
    const decide_input in = { e, of, NULL, all, NULL };

    return ask(question_of(table[number_type(e)], DECIDE_QUESTIONS, question), &in,
               source_name(file));
}

int decide_run(const tool_command *self, const decide_question *const table[3], unsigned count,
               int argc, char **argv)
{
    const engine *e = &engine_q16;
    tool_list of = { .count = 0 };
    int first;

    const tool_option options[] = { TOOL_LIST("of", "NUMBER,..", &of, -1e15, 1e15,
                                              "the numbers of the question"),
                                    ENGINE_OPTION(&e, "number type (q16)"), TOOL_OPTIONS_END };
    const int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first >= argc)
        return tool_error(EX_USAGE, "no word after %s: see `loft help %s`", self->name, self->name);
    const decide_question *q = question_of(table[number_type(e)], count, argv[first]);
    if (q == NULL)
        return tool_error(EX_USAGE, "%s: not known to %s: see `loft help %s`", argv[first],
                          self->name, self->name);
    const decide_input in = { e, &of, NULL, NULL, NULL };
    const int words = q->takes == DECIDE_NUMBERS ? 1 : q->takes == DECIDE_BOTH ? 3 : 2;
    if (argc - first > words)
        return tool_error(EX_USAGE, "%s: one %s too many: see `loft help %s`", argv[argc - 1],
                          q->takes == DECIDE_NUMBERS ? "word" : "file", self->name);
    if (of.count < q->least || of.count > q->most)
        return tool_error(EX_USAGE, "%s: --of has %zu number%s: give %s; see `loft help %s`",
                          q->name, (size_t)of.count, tool_s(of.count), q->numbers, self->name);
    if (q->takes == DECIDE_NUMBERS)
        return ask(q, &in, "--of");
    if (q->takes == DECIDE_BOTH && argc - first < words)
        return tool_error(EX_USAGE, "%s: give a file of curves, then one of surfaces", q->name);
    if (q->takes == DECIDE_BOTH)
        return ask_of_both(q, &in, argv + first + 1);
    return ask_of_file(q, &in, first + 1 < argc ? argv[first + 1] : "-");
}

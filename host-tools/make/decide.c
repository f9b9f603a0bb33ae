/* host-tools/make/decide.c -- finds the question, reads the file, asks
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "base/source.h"        /* source_name */
#include "base/host.h"
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

static int ask(host *h, const decide_question *q, const decide_input *in, const char *what)
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
    return host_error(h, EX_DATAERR, "decide.undecided", (host_place){ what, 0 }, NULL, "%s: %s",
                      q->name, told ? why : engine_status(status, why));
}

/* The curves of one file and the surfaces of another. */
static int ask_of_both(host *h, const decide_question *q, const decide_input *numbers,
                       const char *const file[2])
{
    decide_input in = *numbers;
    curves all = { 0 };
    surfaces patches = { 0 };
    int code = curves_read(h, &all, file[0], NULL);

    if (code == 0)
        code = surfaces_read_only(h, &patches, file[1]);
    in.curves = &all;
    in.surfaces = &patches;
    if (code == 0)
        code = ask(h, q, &in, source_name(file[0]));
    curves_free(&all);
    surfaces_free(&patches);
    return code;
}

static int ask_of_file(host *h, const decide_question *q, const decide_input *numbers,
                       const char *file)
{
    decide_input in = *numbers;
    curves all = { .any_weights = q->takes == DECIDE_CONICS };
    surfaces patches = { .solids = q->takes == DECIDE_SOLIDS };
    const bool only_curves = q->takes == DECIDE_CURVES || q->takes == DECIDE_CONICS;
    int code = only_curves ? 0 : surfaces_read(h, &patches, file);
    const bool curved = only_curves || ((q->takes == DECIDE_EITHER || q->takes == DECIDE_SOLIDS) &&
                                        patches.count == 0);

    if (code == 0 && curved)
        code = curves_read(h, &all, file, NULL);
    if (code == 0 && q->takes == DECIDE_SURFACES && patches.count == 0)
        code = host_error(h, EX_DATAERR, "decide.no-surface", (host_place){ source_name(file), 0 },
                          "give a file of surfaces", "holds no surface");
    in.curves = curved ? &all : NULL;
    in.surfaces = curved ? NULL : &patches;
    if (code == 0)
        code = ask(h, q, &in, source_name(file));
    curves_free(&all);
    surfaces_free(&patches);
    return code;
}

static unsigned number_type(const engine *e)
{
    return e == &engine_q16 ? 0 : e == &engine_f32 ? 1 : 2;
}

int decide_surfaces(host *h, const char *question, const engine *e, const option_list *of,
                    const surfaces *all, const char *file)
{
    static const decide_question *const table[3] = { decide_q16, decide_f32, decide_f64 };
    const decide_input in = { e, of, NULL, all, NULL };

    return ask(h, question_of(table[number_type(e)], DECIDE_QUESTIONS, question), &in,
               source_name(file));
}

const option decide_rows[] = { { "of", OPTION_LIST(decide_options, of), .least = -1e15,
                                 .most = 1e15, .value = "NUMBER,..",
      .help = "the numbers of the question" },
    ENGINE_ROW(decide_options, e, "q16", "number type"),
                               { "question", OPTION_WORD(decide_options, question), .least = 1,
                                 .value = "word", .remedy = "say what, and of which file" },
                               { "files", OPTION_WORDS(decide_options, files), .most = 2,
                                 .value = "FILE", .remedy = "one word too many" },
                               { 0 } };

/* Refuse other numbers of files and values than the question takes. */
static int check_question(host *h, const char *name, const decide_question *q,
                          const decide_options *o)
{
    const size_t files = q->takes == DECIDE_NUMBERS ? 0 : q->takes == DECIDE_BOTH ? 2 : 1;

    if (o->files.count > files)
        return host_error(h, EX_USAGE, "decide.too-many-words", (host_place){ NULL, 0 },
                          HOST_REMEDY("see `loft help %s`", name), "%s: one %s too many",
                          o->files.word[o->files.count - 1],
                          q->takes == DECIDE_NUMBERS ? "word" : "file");
    if (o->of.count < q->least || o->of.count > q->most)
        return host_error(h, EX_USAGE, "decide.numbers", (host_place){ NULL, 0 },
                          HOST_REMEDY("give %s; see `loft help %s`", q->numbers, name),
                          "%s: --of has %zu number%s", q->name, (size_t)o->of.count,
                          tool_s(o->of.count));
    if (q->takes == DECIDE_BOTH && o->files.count < 2)
        return host_error(h, EX_USAGE, "decide.two-files", (host_place){ NULL, 0 },
                          "give a file of curves, then one of surfaces", "%s", q->name);
    return 0;
}

int decide_run(host *h, const char *name, const decide_question *const table[3], unsigned count,
               const decide_options *o)
{
    const decide_question *q = question_of(table[number_type(o->e)], count, o->question);
    const decide_input in    = { o->e, &o->of, NULL, NULL, NULL };

    if (q == NULL)
        return host_error(h, EX_USAGE, "decide.unknown", (host_place){ NULL, 0 },
                          HOST_REMEDY("see `loft help %s`", name), "%s: not known to %s",
                          o->question, name);
    const int code = check_question(h, name, q, o);
    if (code != 0)
        return code;
    if (q->takes == DECIDE_NUMBERS)
        return ask(h, q, &in, "--of");
    if (q->takes == DECIDE_BOTH)
        return ask_of_both(h, q, &in, o->files.word);
    return ask_of_file(h, q, &in, o->files.count > 0 ? o->files.word[0] : "-");
}

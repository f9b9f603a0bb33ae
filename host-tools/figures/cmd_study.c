/* host-tools/figures/cmd_study.c -- loft study: the behaviour of a patch, in numbers next to the
 * expected ones, and in pictures
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "num/status.h"     /* loft_status */

#include "figures/chapter.h"
#include "figures/cmd_figures.h"    /* command_study */
#include "figures/study_pictures.h"
#include "base/create.h"      /* create_check */
#include "base/tool.h"

#define EXPECTED "tests/vectors/ch4_numbers.csv"

typedef struct {
    char **line;                /* the lines of the file of expected numbers */
    size_t lines;
    const char *file;           /* the requested file, or NULL */
    const char *num;
    bool brief;
    unsigned compared, off, alone;
} table;

static int read_expected(table *t, const char *file, bool asked)
{
    FILE *in = fopen(file, "r");
    char line[512];

    if (in == NULL)
        return tool_error(EX_NOINPUT,
                          asked ? "%s: no such file: give one with rows "
                                  "`figure;pentagon;quantity;coordinates;numbers`"
                                : "%s: not below this folder, so there is nothing to compare "
                                  "with: give --expected FILE, or --pictures-only",
                          file);
    t->file = asked ? file : NULL;
    while (fgets(line, sizeof line, in) != NULL) {
        t->line = tool_grow(t->line, (t->lines + 1) * sizeof *t->line);
        t->line[t->lines] = tool_grow(NULL, strlen(line) + 1);
        strcpy(t->line[t->lines++], line);
    }
    const bool bad = ferror(in) != 0;
    fclose(in);
    return bad ? tool_error(EX_DATAERR,
                            "%s: cannot be read: name a file with rows "
                            "`figure;pentagon;quantity;coordinates;numbers`",
                            file)
               : 0;
}

/* The numbers after the key, or NULL. */
static const char *expected_numbers(const table *t, const char *key)
{
    const size_t length = strlen(key);

    for (size_t i = 0; i < t->lines; i++)
        if (strncmp(t->line[i], key, length) == 0 && t->line[i][length] == ';')
            return t->line[i] + length + 1;
    return NULL;
}

/* Print one line for each number: quantity, computed, expected, difference, and `off` if the
 * difference is too large. The first and the last of five are the extremes of a sample; another
 * sample has others. */
static void print_row(void *context, const chapter_row *r)
{
    table *t = context;
    const char *at = expected_numbers(t, r->key);

    for (unsigned i = 0; i < r->count; i++) {
        char *end = NULL;
        const double want = at ? strtod(at, &end) : NAN, difference = r->value[i] - want,
                     off = r->off * fmax(1, fabs(want));
        const bool extreme = r->count == 5 && (i == 0 || i == 4),
                   bad = at && end != at && !extreme && !(fabs(difference) <= off);
        t->compared += at && end != at;
        t->alone += !at || end == at;
        t->off += bad;
        if (at && end != at && (!t->brief || bad))
            printf("%s;%.9g;%.9g;%.2g%s\n", r->key, r->value[i], want, difference,
                   bad       ? ";off"
                   : extreme ? ";of the sample"
                             : "");
        else if (!at || end == at)
            printf("%s;%.9g;;\n", r->key, r->value[i]);
        at = at ? end : NULL;
    }
}

static int study_pentagons(table *t, const engine_chapters *e, unsigned fine)
{
    printf("figure;pentagon;quantity;coordinates;%s;expected;difference\n", t->num);
    for (unsigned i = 0; i < 3; i++) {
        const int status = chapter_study(e, &chapter_pentagons[i], fine, print_row, t);
        if (status != LOFT_OK)
            return tool_error(EX_DATAERR, "%s: the patch was refused: status %d",
                              chapter_pentagons[i].name, status);
    }
    printf("%u numbers beside expected ones, %u of them off; %u without\n", t->compared, t->off,
           t->alone);
    if (t->file && t->compared == 0)
        return tool_error(EX_DATAERR,
                          "%s: no row of it is a number of this study: give rows "
                          "`figure;pentagon;quantity;coordinates;numbers`",
                          t->file);
    return t->off > 0 ? EX_DATAERR : EX_OK;
}

static int run_study(const tool_command *self, int argc, char **argv)
{
    const engine *num    = &engine_f64;
    const char *folder   = NULL, *file = NULL;
    unsigned fine        = 60;
    bool pictures_only   = false;
    table t              = { .num = NULL };
    int first;

    const tool_option options[] = {
        TOOL_TEXT("output", "DIR", &folder, "draw the pictures of the chapter into this folder"),
        TOOL_TEXT("expected", "FILE", &file, "the numbers to compare with (" EXPECTED ")"),
        TOOL_COUNT("fine", "N", &fine, 4, 400, "5 N^2 points of each pentagon are looked at (60)"),
        TOOL_SWITCH("brief", &t.brief, "print only what is off, and the sum"),
        TOOL_SWITCH("pictures-only", &pictures_only, "no numbers"),
        ENGINE_OPTION(&num, "number type (f64)"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first + 1 != argc || strcmp(argv[first], "gb") != 0)
        return tool_error(EX_USAGE, "what is to be studied: give `gb`");

    const engine_chapters *e = num == &engine_q16   ? &engine_chapters_q16
                               : num == &engine_f32 ? &engine_chapters_f32
                                                    : &engine_chapters_f64;
    if ((code = create_check(tool_host(), folder)) != 0)
        return code;
    t.num = num->name;
    if (!pictures_only)
        code = read_expected(&t, file ? file : EXPECTED, file != NULL);
    if (code == 0 && !pictures_only)
        code = study_pentagons(&t, e, fine);
    if ((code == 0 || t.compared > 0) && folder != NULL) {
        const int drawn = study_pictures(num, folder);
        code = drawn ? drawn : code;
    }
    for (size_t i = 0; i < t.lines; i++)
        free(t.line[i]);
    free(t.line);
    return code;
}

const tool_command command_study = {
    "study", "gb [-o DIR] [--num TYPE]",
    "what a pentagonal GB patch does: numbers beside expected ones, pictures",
    "A generalized Bezier patch with five sides of degree 5, over three pentagons and with\n"
    "three kinds of coordinates (W Wachspress, MV mean value, H harmonic): the influence of\n"
    "the point in the middle (B0, its weight), ridges and valleys of the contours (Z_tt), and\n"
    "Gaussian curvature (K) for five heights of that point. Prints\n"
    "figure;pentagon;quantity;coordinates;number;expected;difference, a line per number, and\n"
    "how many are off. Extremes of a sample depend on the places of its points; they are\n"
    "printed, but not judged.\n",
    run_study
};

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

typedef struct {
    const char *what, *folder, *expected;
    unsigned fine;
    bool brief, pictures_only;
    const engine *e;
} study_options;

static const option study_rows[] = {
    { "output", OPTION_FOLDER(study_options, folder), .value = "DIR",
      .help = "draw the pictures of the chapter into this folder" },
    { "expected", OPTION_FILE(study_options, expected), .value = "FILE",
      .help = "the numbers to compare with (" EXPECTED ")" },
    { "fine", OPTION_INTEGER(study_options, fine), .least = 4, .most = 400, .value = "N",
      .standard = "60", .help = "5 N^2 points of each pentagon are looked at" },
    { "brief", OPTION_FLAG(study_options, brief), .help = "print only what is off, and the sum" },
    { "pictures-only", OPTION_FLAG(study_options, pictures_only), .help = "no numbers" },
    ENGINE_ROW(study_options, e, "f64", "number type"),
    { "what", OPTION_WORD(study_options, what), .least = 1, .value = "what", .choices = "gb",
      .remedy = "what is to be studied: give `gb`" },
    { 0 }
};

static int run_study(void *options)
{
    const study_options *o   = options;
    const engine_chapters *e = o->e == &engine_q16   ? &engine_chapters_q16
                               : o->e == &engine_f32 ? &engine_chapters_f32
                                                     : &engine_chapters_f64;
    table t  = { .num = o->e->name, .brief = o->brief };
    int code = create_check(tool_host(), o->folder);

    if (code != 0)
        return code;
    if (!o->pictures_only)
        code = read_expected(&t, o->expected ? o->expected : EXPECTED, o->expected != NULL);
    if (code == 0 && !o->pictures_only)
        code = study_pentagons(&t, e, o->fine);
    if ((code == 0 || t.compared > 0) && o->folder != NULL) {
        const int drawn = study_pictures(o->e, o->folder);
        code = drawn ? drawn : code;
    }
    for (size_t i = 0; i < t.lines; i++)
        free(t.line[i]);
    free(t.line);
    return code;
}

const command command_study = {
    .name = "study",
    .arguments = "gb [-o DIR] [--num TYPE]",
    .summary = "what a pentagonal GB patch does: numbers beside expected ones, pictures",
    .detail =
        "A generalized Bezier patch with five sides of degree 5, over three pentagons and with\n"
        "three kinds of coordinates (W Wachspress, MV mean value, H harmonic): the influence of\n"
        "the point in the middle (B0, its weight), ridges and valleys of the contours (Z_tt), and\n"
        "Gaussian curvature (K) for five heights of that point. Prints\n"
        "figure;pentagon;quantity;coordinates;number;expected;difference, a line per number, and\n"
        "how many are off. Extremes of a sample depend on the places of its points; they are\n"
        "printed, but not judged.\n",
    .options = study_rows,
    .size = sizeof(study_options),
    .run = run_study,
};

/* host-tools/cmd/cmd_export.c -- loft export: a drawing as a table in C for lib/curve/drawing.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/c_name.h"
#include "base/source.h"        /* source_name */
#include "base/tool.h"
#include "read/drawing.h"

typedef struct {
    int16_t *word;
    size_t count, room, run;    /* run: where the word of the run stands that is not over; or 0 */
    int bits;
    unsigned paths;
    size_t curves, lines;
} table;

static void put(table *t, int word)
{
    if (t->count == t->room) {
        t->room = t->room ? 2 * t->room : 1024;
        t->word = tool_grow(t->word, t->room * sizeof *t->word);
    }
    t->word[t->count++] = (int16_t)word;
}

static void put_point(table *t, const double p[2])
{
    for (int i = 0; i < 2; i++)
        put(t, (int)lround(ldexp(p[i], t->bits)));
}

/* As many as leave every control point in 16 bits. */
static int bits_for(const drawing *d)
{
    double largest = 0;
    int bits = 16;

    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k < 4; k++)
            largest = fmax(largest, fmax(fabs(d->curve[i].p[k][0]), fabs(d->curve[i].p[k][1])));
    while (bits > 0 && ldexp(largest, bits) >= 32767)
        bits--;
    return bits;
}

/* Are the inner points on the thirds, as far as the table tells? */
static bool is_line(const drawing_curve *c, int bits)
{
    for (int i = 0; i < 2; i++)
        if (fabs(c->p[1][i] - (2 * c->p[0][i] + c->p[3][i]) / 3) > ldexp(0.25, -bits) ||
            fabs(c->p[2][i] - (c->p[0][i] + 2 * c->p[3][i]) / 3) > ldexp(0.25, -bits))
            return false;
    return true;
}

static void put_curve(table *t, const drawing_curve *c, bool begins)
{
    const int sign = is_line(c, t->bits) ? -1 : 1;

    if (begins) {
        put(t, 0);
        put_point(t, c->p[0]);
        t->paths++;
        t->run = 0;
    }
    if (t->run == 0 || t->word[t->run] * sign < 0 || abs(t->word[t->run]) == INT16_MAX) {
        t->run = t->count;
        put(t, 0);
    }
    t->word[t->run] = (int16_t)(t->word[t->run] + sign);
    if (sign > 0)
        for (int k = 1; k < 3; k++)
            put_point(t, c->p[k]);
    put_point(t, c->p[3]);
    *(sign > 0 ? &t->curves : &t->lines) += 1;
}

static void fill(table *t, const drawing *d)
{
    t->bits = bits_for(d);
    for (size_t i = 0; i < d->count; i++)
        put_curve(t, &d->curve[i], i == 0 || d->curve[i].path != d->curve[i - 1].path);
}

static void print_words(const table *t, FILE *out)
{
    fprintf(out, "%zu path%s, %zu curve%s, %zu line%s, %zu bytes, rounded by at most %.3g mm",
            (size_t)t->paths, tool_s(t->paths), t->curves, tool_s(t->curves), t->lines,
            tool_s(t->lines), t->count * 2, ldexp(0.5, -t->bits));
}

static void write_header(const table *t, const drawing *d, const char *name, FILE *out)
{
    double box[2][2] = { { 0 } };

    (void)drawing_box(d, box);
    fprintf(out, "/* A drawing for lib/curve/drawing.h, by `loft export`:\n * ");
    print_words(t, out);
    fprintf(out, ";\n * x %.6g .. %.6g, y %.6g .. %.6g mm, y up */\n#include \"loft.h\"\n\n",
            box[0][0], box[1][0], box[0][1], box[1][1]);
    fprintf(out, "static const int16_t %s_words[%zu] LOFT_FLASH = {", name, t->count);
    for (size_t i = 0; i < t->count; i++)
        fprintf(out, "%s%d,", i % 12 ? " " : "\n    ", t->word[i]);
    fprintf(out, "\n};\nstatic const loft_drawing %s = { %s_words, %zu, %d };\n", name, name,
            t->count, t->bits);
}

static int write_file(const table *t, const drawing *d, const char *output)
{
    char name[64];

    if (output == NULL) {
        write_header(t, d, "drawing", stdout);
        return 0;
    }
    FILE *out = fopen(output, "w");
    if (out == NULL)
        return tool_error(EX_CANTCREAT,
                          "%s: cannot be written: name a file in a folder that exists", output);
    c_name_of(output, name);
    write_header(t, d, name, out);
    if (fclose(out) != 0)
        return tool_error(EX_IOERR, "%s: cannot be written: is the disk full?", output);
    printf("%s: ", output);
    print_words(t, stdout);
    printf("\n");
    return 0;
}

static int run(const tool_command *self, int argc, char **argv)
{
    const char *output = NULL, *file;
    drawing d = { 0 };
    table t = { 0 };

    const tool_option options[] = { TOOL_TEXT("output", "FILE.h", &output,
                                              "or -o: where the table goes (standard output)"),
                                    TOOL_OPTIONS_END };
    int code = tool_file_options(self, options, argc, argv, NULL, &file);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    code = drawing_read(&d, file);
    if (code == 0 && d.count == 0)
        code = tool_error(EX_DATAERR, "%s: nothing to draw: give curves", source_name(file));
    if (code == 0) {
        fill(&t, &d);
        code = write_file(&t, &d, output);
    }
    free(t.word);
    drawing_free(&d);
    return code;
}

const tool_command command_export = {
    "export", "[-o ICON.h] [DRAWING|-]", "a drawing as a table in C, for the flash of a chip",
    "DRAWING is an SVG file, curves of any kind (host-tools/LOFT.md) or lines of eight numbers. "
    "The "
    "table has the name of\n"
    "the file; lib/curve/drawing.h reads it curve by curve. A curve takes 12 bytes, a line 4; "
    "coordinates have 16 bits.\n",
    run
};

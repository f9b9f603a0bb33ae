/* host-tools/cmd/cmd_export.c -- loft export: a drawing as G-code, in other forms, or as a table in
 * C for lib/curve/drawing.h
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "cmd/commands.h"
#include "base/create.h"      /* create_refused */
#include "base/c_name.h"
#include "base/say.h"
#include "base/source.h"        /* source_name */
#include "base/spool.h"         /* spool_passed */
#include "draw/export.h"
#include "geometry/print.h"       /* bound_text */
#include "plan/planning.h"
#include "read/drawing.h"
#include "send/gcode_write.h"

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

/* True if the inner points are on the thirds, to the digits of the table. */
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

static void print_summary(const table *t, FILE *out)
{
    fprintf(out, "%zu path%s, %zu curve%s, %zu line%s, %zu bytes, rounded by at most %s mm",
            (size_t)t->paths, tool_s(t->paths), t->curves, tool_s(t->curves), t->lines,
            tool_s(t->lines), t->count * 2, bound_text(ldexp(0.5, -t->bits)));
}

static void write_header(const table *t, const drawing *d, const char *name, FILE *out)
{
    double box[2][2] = { { 0 } };

    (void)drawing_box(d, box);
    fprintf(out, "/* A drawing for lib/curve/drawing.h, by `loft export`:\n * ");
    print_summary(t, out);
    fprintf(out, ";\n * x %.6g .. %.6g, y %.6g .. %.6g mm, y up */\n#include \"loft.h\"\n\n",
            box[0][0], box[1][0], box[0][1], box[1][1]);
    fprintf(out, "static const int16_t %s_words[%zu] LOFT_FLASH = {", name, t->count);
    for (size_t i = 0; i < t->count; i++)
        fprintf(out, "%s%d,", i % 12 ? " " : "\n    ", t->word[i]);
    fprintf(out, "\n};\nstatic const loft_drawing %s = { %s_words, %zu, %d };\n", name, name,
            t->count, t->bits);
}

static void write_table(const drawing *d, const char *output, FILE *out)
{
    char name[64] = "drawing";
    table t       = { 0 };

    if (output != NULL)
        c_name_of(output, name);
    fill(&t, d);
    write_header(&t, d, name, out);
    if (output != NULL) {
        (void)say(stdout, "%s: ", output);
        print_summary(&t, stdout);
        printf("\n");
    }
    free(t.word);
}


// G-code
// ------

typedef struct {
    planning p;
    const char *output, *as, *file;
    int curves;                 /* enum gcode_curves */
    drawing_names layers;       /* of an SVG */
} export_wishes;

/* From 0, 0, 0. Travels are G0. */
static int write_gcode(const export_wishes *w, const drawing *d, FILE *out)
{
    const toolpath_options how = planning_path(&w->p);
    const gcode_options as = { .tol = (w->p.tol - w->p.smoothed) / 2,
                               .curves = (enum gcode_curves)w->curves,
                               .rapids = true };
    toolpath path;
    gcode lines;

    toolpath_make(&path, d, &how);
    gcode_make(&lines, &path, &as);
    for (size_t i = 0; i < lines.count; spool_passed(i++))
        fprintf(out, "%s\n", gcode_text(&lines, i));
    fputs("M2\n", out);
    gcode_free(&lines);
    toolpath_free(&path);
    return 0;
}


// The command
// -----------

enum form { FORM_TABLE, FORM_GCODE, FORM_SVG, FORM_CSV, FORM_LOFT, FORM_HPGL, FORMS };

/* Which form a name means by its end, or `as` as such an end without its point. */
static enum form form_of(const export_wishes *w)
{
    static const struct {
        const char *end;
        enum form form;
    } ends[] = { { "h", FORM_TABLE },   { "nc", FORM_GCODE },   { "ngc", FORM_GCODE },
                 { "gcode", FORM_GCODE }, { "tap", FORM_GCODE }, { "cnc", FORM_GCODE },
                 { "svg", FORM_SVG },   { "csv", FORM_CSV },    { "loft", FORM_LOFT },
                 { "hpgl", FORM_HPGL }, { "plt", FORM_HPGL } };
    const char *dot = w->output ? strrchr(w->output, '.') : NULL;
    const char *end = w->as ? w->as : dot ? dot + 1 : w->output ? "" : "h";

    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++)
        if (strcasecmp(ends[i].end, end) == 0)
            return ends[i].form;
    return FORMS;
}

static int write_form(const export_wishes *w, enum form form, const drawing *d,
                      const drawing *smooth, FILE *out)
{
    const export_options o = { .host = tool_host(),
                               .d = d,
                               .name = source_name(w->file),
                               .tol = w->p.tol,
                               .layers = &w->layers };

    switch (form) {
    case FORM_GCODE: return write_gcode(w, smooth, out);
    case FORM_SVG:   return export_svg(&o, out);
    case FORM_CSV:   return export_csv(&o, out);
    case FORM_LOFT:  return export_loft(&o, out);
    case FORM_HPGL:  return export_hpgl(&o, out);
    default:         write_table(d, w->output, out); return 0;
    }
}

static int write_file(const export_wishes *w, enum form form, const drawing *d,
                      const drawing *smooth)
{
    FILE *out = w->output ? create_file(w->output) : stdout;

    if (out == NULL)
        return create_refused(tool_host(), w->output, errno);
    const int code = write_form(w, form, d, smooth, out);
    const bool bad = ferror(out) != 0;
    if (out != stdout && (fclose(out) != 0 || bad) && code == 0)
        return tool_error(EX_IOERR, "%s: cannot be written: is the disk full?", w->output);
    return code;
}

typedef struct {
    const char *file, *output, *as;
    int curves;                 /* enum gcode_curves */
    double tol, smooth, feed, lift;
    page_options sheet;
    order_options order;
    gcode_choice program;
} export_command;

static const option export_rows[] = {
    { "output", OPTION_FILE(export_command, output), .value = "FILE",
      .help = "or -o: .h .nc .ngc .gcode .svg .csv .loft .hpgl or .plt (standard output)" },
    { "as", OPTION_TEXT(export_command, as), .value = "END",
      .help = "the form, as nc, whatever the name of the file (h)" },
    { "curves", OPTION_CHOICE(export_command, curves), .choices = "arcs|g5|lines",
      .standard = "arcs", .help = "of G-code" },
    { "tol", OPTION_NUMBER(export_command, tol), .least = 0.0005, .most = 1, .unit = "mm",
      .standard = "0.005", .help = "how far arcs and chords may be off" },
    { "smooth", OPTION_NUMBER(export_command, smooth), .least = 0, .most = 1, .unit = "mm",
      .unset = -1,
      .help =
          "of this tolerance, for chains of short lines to become curves, in G-code (a fifth)" },
    { "feed", OPTION_NUMBER(export_command, feed), .least = 0.016, .most = 1000, .unit = "mm/s",
      .standard = "30", .help = "of G-code, pen down" },
    { "lift", OPTION_NUMBER(export_command, lift), .least = 0, .most = 100, .unit = "mm",
      .standard = "1", .help = "of G-code: height while travelling" },
    OPTION_GROUP(export_command, sheet, page_rows),
    OPTION_GROUP(export_command, order, order_rows),
    OPTION_GROUP(export_command, program, gcode_rows),
    { "file", OPTION_WORD(export_command, file), .value = "DRAWING", .standard = "-" },
    { 0 }
};

static export_wishes wishes_of(const export_command *o)
{
    export_wishes w = { .output = o->output, .as = o->as, .file = o->file, .curves = o->curves };

    (void)planning_usual(tool_host(), &w.p, NULL);
    w.p.e       = &engine_f64;
    w.p.tol     = o->tol;
    w.p.smooth  = o->smooth;
    w.p.feed    = o->feed;
    w.p.lift    = o->lift;
    w.p.sheet   = o->sheet;
    w.p.order   = o->order;
    w.p.program = o->program;
    return w;
}

static int run_export(void *options)
{
    const export_command *o = options;
    export_wishes w         = wishes_of(o);
    drawing d = { .named = &w.layers }, smooth = { 0 };

    const enum form form = form_of(&w);
    if (form == FORMS)
        return tool_error(EX_USAGE, "%s %s: give h, nc, svg, csv, loft or hpgl as its end",
                          w.as ? "--as" : "-o", w.as ? w.as : w.output);
    int code = planning_read(tool_host(), &w.p, &d, &smooth, w.file);
    if (code == 0)
        code = write_file(&w, form, &d, &smooth);
    drawing_names_free(&w.layers);
    drawing_free(&smooth);
    drawing_free(&d);
    return code;
}

const command command_export = {
    .name = "export",
    .arguments = "[-o FILE] [DRAWING|-]",
    .summary = "a drawing as G-code, HP-GL, SVG, numbers or a table in C",
    .detail =
        "The end of FILE tells the form. .nc: arcs, G5 or lines within the tolerance, at feeds "
        "and\n"
        "heights. .svg, .csv, .loft: the curves themselves, .svg in the layers of Inkscape in "
        "which\n"
        "they were. .hpgl, .plt: chords. .h: a table for the flash of a chip with the name of the\n"
        "file, which lib/curve/drawing.h reads curve by curve:\n"
        "12 bytes a curve, 4 a line; coordinates have 16 bits.\n",
    .options = export_rows,
    .size = sizeof(export_command),
    .run = run_export,
};

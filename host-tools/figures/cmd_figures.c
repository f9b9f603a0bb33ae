/* host-tools/figures/cmd_figures.c -- loft figures: the figures of the texts, with the numbers that
 * prove them
 * SPDX-License-Identifier: MIT
 *
 * Every step of a figure is a line of this command, run in this process with its output in a file.
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cmd/dispatch.h"
#include "engine/engine.h"
#include "cmd/commands.h"        /* command_make .. */
#include "figures/cmd_figures.h"
#include "figures/figures.h"
#include "base/create.h"         /* create_file */

#define LINE   2048
#define FOLDER 400
#define WORDS  40

typedef struct {
    const engine *e;
    const char *folder;
    FILE *page;                 /* index.html */
    bool pictures, brief;
    unsigned proofs, failed;
} exhibition;

/* The files of a figure: the input, what was made, several in one. */
static void file_name(char out[LINE], const char *folder, const figure *f, const char *digits)
{
    snprintf(out, LINE, "%s%s%s%s.loft", folder, f->name, strcmp(digits, "0") ? "-" : "",
             strcmp(digits, "0") ? digits : "");
}

/* The line with the names of files in place of {..}. */
static void expand_line(char out[LINE], const char *line, const char *folder, const figure *f)
{
    size_t n = 0;

    for (const char *c = line; *c && n + 1 < LINE; c++) {
        const char *close = *c == '{' ? strchr(c, '}') : NULL;
        char digits[16], name[LINE];
        if (close == NULL || close - c >= (long)sizeof digits) {
            out[n++] = *c;
            continue;
        }
        snprintf(digits, sizeof digits, "%.*s", (int)(close - c - 1), c + 1);
        file_name(name, folder, f, digits);
        n += (size_t)snprintf(out + n, LINE - n, "%s", name);
        c = close;
    }
    out[n < LINE ? n : LINE - 1] = '\0';
}

static const command *command_of(const char *name)
{
    static const command *const used[] = { &command_make,    &command_decide,  &command_eval,
                                                &command_measure, &command_compare, &command_plot,
                                                &command_contour, &command_surface, &command_fit };

    for (size_t i = 0; i < sizeof used / sizeof used[0]; i++)
        if (strcmp(used[i]->name, name) == 0)
            return used[i];
    return NULL;
}

/* Run a line without `loft`, its output into the open file. Returns its exit code. */
static int run_line(const exhibition *x, const char *line, FILE *to)
{
    char text[2 * LINE], num[] = "--num", *argv[WORDS + 3];
    char type[8];
    int argc = 0;

    snprintf(text, sizeof text, "%s", line);
    snprintf(type, sizeof type, "%s", x->e->name);
    for (char *word = strtok(text, " "); word != NULL && argc < WORDS; word = strtok(NULL, " "))
        argv[argc++] = word;
    const command *c = argc > 0 ? command_of(argv[0]) : NULL;
    if (c == NULL)
        return tool_error(EX_SOFTWARE, "figures: %s: no such step", line);
    if (c != &command_plot) {
        argv[argc++] = num;
        argv[argc++] = type;
    }
    argv[argc] = NULL;
    fflush(stdout);
    const int held = dup(STDOUT_FILENO);
    if (held < 0 || dup2(fileno(to), STDOUT_FILENO) < 0)
        return tool_error(EX_OSERR, "standard output: %s", strerror(errno));
    const int code = dispatch(c, argc, argv);
    fflush(stdout);
    dup2(held, STDOUT_FILENO);
    close(held);
    return code;
}


// Files
// -----

static FILE *open_file(const char *name, const char *mode)
{
    FILE *f = *mode == 'r' ? fopen(name, mode) : create_file(name);

    if (f == NULL)
        (void)create_refused(tool_host(), name, errno);
    return f;
}

static int write_input(const exhibition *x, const figure *f, const char *digit, const char *input)
{
    char name[LINE];

    if (input == NULL)
        return 0;
    file_name(name, x->folder, f, digit);
    FILE *out = open_file(name, "w");
    if (out == NULL)
        return EX_CANTCREAT;
    fprintf(out, "# %s: %s\n%s", f->name, f->title, input);
    return fclose(out) == 0 ? 0 : tool_error(EX_IOERR, "%s: %s", name, strerror(errno));
}

/* Each line of `make` gives a file. */
static int make_files(const exhibition *x, const figure *f)
{
    char all[LINE], line[LINE], name[LINE], digit[2] = "1";
    char *rest = all;
    int code   = 0;

    snprintf(all, sizeof all, "%s", f->make ? f->make : "");
    for (; *rest && code == 0; digit[0]++) {
        const size_t n = strcspn(rest, ";");
        char *next = rest + n + (rest[n] == ';');
        rest[n] = '\0';
        expand_line(line, rest + strspn(rest, " "), x->folder, f);
        file_name(name, x->folder, f, digit);
        FILE *out = open_file(name, "w");
        if (out == NULL)
            return EX_CANTCREAT;
        code = run_line(x, line, out);
        fclose(out);
        rest = next;
    }
    return code;
}

/* {01}: both files in one. */
static int join_files(const exhibition *x, const figure *f, const char *line)
{
    const char *open = strchr(line, '{'), *close = open ? strchr(open, '}') : NULL;
    char digits[16], name[LINE], part[LINE];

    if (close == NULL || close - open < 3)
        return 0;
    snprintf(digits, sizeof digits, "%.*s", (int)(close - open - 1), open + 1);
    file_name(name, x->folder, f, digits);
    FILE *out = open_file(name, "w");
    if (out == NULL)
        return EX_CANTCREAT;
    for (const char *d = digits; *d; d++) {
        const char one[2] = { *d, '\0' };
        file_name(part, x->folder, f, one);
        FILE *in = open_file(part, "r");
        for (int c; in != NULL && (c = getc(in)) != EOF; )
            putc(c, out);
        if (in != NULL)
            fclose(in);
        putc('\n', out);
    }
    return fclose(out) == 0 ? 0 : EX_IOERR;
}

/* In pixels; drawings of lines have none. */
static const char *size_of(const figure *f)
{
    return strcmp(f->type, "png") == 0 ? "--size 900 " : "";
}

static int draw_picture(const exhibition *x, const figure *f)
{
    char line[LINE], all[2 * LINE];

    if (!x->pictures)
        return 0;
    FILE *nothing = tmpfile();
    if (nothing == NULL)
        return tool_error(EX_CANTCREAT, "a temporary file: %s", strerror(errno));
    int code = join_files(x, f, f->plot);
    expand_line(line, f->plot, x->folder, f);
    snprintf(all, sizeof all, "plot %s%s -o %s%s.%s", size_of(f), line, x->folder, f->name,
             f->type);
    if (code == 0)
        code = run_line(x, all, nothing);
    fclose(nothing);
    return code;
}


// Proofs
// ------

/* The whole output, to be freed. */
static char *read_back(FILE *f)
{
    const long end = ftell(f);
    const size_t n = end > 0 ? (size_t)end : 0;
    char *all = tool_grow(NULL, n + 1);

    rewind(f);
    all[fread(all, 1, n, f)] = '\0';
    return all;
}

/* True if the word is in this row, not behind it. */
static bool row_has(const char *row, const char *word, size_t length)
{
    const char *end = row + strcspn(row, "\n");

    for (; row + length <= end; row++)
        if (strncmp(row, word, length) == 0)
            return true;
    return length == 0;
}

static double word_number(const char *row, unsigned column)
{
    for (unsigned k = 1; k < column; k++) {
        row += strcspn(row, " \t\n");
        row += strspn(row, " \t");
    }
    char *end;
    const double v = strtod(row, &end);
    return end == row ? NAN : v;
}

/* Of the rows that are no comments and have the word: how many (column 0), or the largest number
 * in the column. */
static double pick_rows(const char *all, const char *word, size_t length, unsigned column)
{
    double largest = column ? NAN : 0;

    for (const char *row = all; *row; row += strcspn(row, "\n"), row += *row == '\n')
        if (*row != '#' && *row != '\n' && row_has(row, word, length))
            largest = column ? fmax(largest, word_number(row, column)) : largest + 1;
    return largest;
}

/* The number in row and column, both from 1. */
static double pick_place(const char *all, const char *pick)
{
    unsigned row = (unsigned)atoi(pick), column = (unsigned)atoi(strchr(pick, ':') + 1);

    for (; *all; all += strcspn(all, "\n"), all += *all == '\n')
        if (*all != '#' && *all != '\n' && --row == 0)
            return word_number(all, column);
    return NAN;
}

static double pick_number(const char *all, const char *pick)
{
    const char *colon = strrchr(pick, ':');

    if (*pick == '@' && colon != NULL)
        return pick_place(all, pick + 1);
    if (*pick == '#')
        return pick_rows(all, pick + 1, strlen(pick + 1), 0);
    if (colon != NULL)
        return pick_rows(all, pick, (size_t)(colon - pick), (unsigned)atoi(colon + 1));
    const char *at = strstr(all, pick);
    return at == NULL ? NAN : word_number(at + strlen(pick), 1);
}

static bool has_text(char *all, const char *text)
{
    for (char *c = all; *c; c++)
        *c = *c == '\n' ? ';' : *c;
    return strstr(all, text) != NULL;
}

static double bound_of(const engine *e, const figure_proof *p)
{
    const double size = fmax(fabs(p->want), 1),
                 lsb  = e->fixed ? e->lsb : e->lsb * exp2(floor(log2(size)));
    return p->lsb * lsb + (e->fixed || !(p->floats > 0) ? p->off : p->floats);
}

static void tell_proof(exhibition *x, const figure *f, const figure_proof *p, double got, bool good)
{
    const double bound = bound_of(x->e, p);
    char line[LINE], number[120] = "as it must be";

    x->proofs++;
    x->failed += !good;
    if (p->text == NULL)
        snprintf(number, sizeof number, "%.9g, off by %.2g, bound %.2g", got, fabs(got - p->want),
                 bound);
    if (!x->brief || !good)
        printf("%s\t%s\t%s\t%s\n", good ? "ok" : "WRONG", f->name, p->says,
               p->text && !good ? p->text : number);
    if (x->page == NULL)
        return;
    expand_line(line, p->run, "", f);
    fprintf(x->page, "<tr><td>%s<td>%s<td>%s<td><code>loft %s --num %s</code>\n",
            good ? "" : "<b>wrong</b>", p->says, p->text ? p->text : number, line, x->e->name);
}

static int prove(exhibition *x, const figure *f, const figure_proof *p)
{
    char line[LINE];
    FILE *to = tmpfile();

    if (to == NULL)
        return tool_error(EX_CANTCREAT, "a temporary file: %s", strerror(errno));
    int code = join_files(x, f, p->run);
    expand_line(line, p->run, x->folder, f);
    if (code == 0)
        code = run_line(x, line, to);
    fseek(to, 0, SEEK_END);
    char *all = read_back(to);
    fclose(to);
    const double got = code == 0 && p->text == NULL ? pick_number(all, p->pick) : NAN;
    tell_proof(x, f, p, got,
               code == 0 &&
                   (p->text ? has_text(all, p->text) : fabs(got - p->want) <= bound_of(x->e, p)));
    free(all);
    return 0;
}


// The page
// --------

static void begin_figure(const exhibition *x, const figure *f)
{
    char line[LINE], all[LINE];

    if (x->page == NULL)
        return;
    fprintf(x->page, "<h2 id=\"%s\">%s</h2>\n<p>%s, %s. <a href=\"%s.loft\">%s.loft</a></p>\n",
            f->name, f->title, f->text, f->section, f->name, f->name);
    if (x->pictures)
        fprintf(x->page, "<img src=\"%s.%s\" alt=\"%s\">\n", f->name, f->type, f->title);
    fprintf(x->page, "<pre>\n");
    snprintf(all, sizeof all, "%s", f->make ? f->make : "");
    int k = 1;
    for (char *step = strtok(all, ";"); step != NULL; step = strtok(NULL, ";")) {
        expand_line(line, step + strspn(step, " "), "", f);
        fprintf(x->page, "loft %s --num %s &gt;%s-%d.loft\n", line, x->e->name, f->name, k++);
    }
    expand_line(line, f->plot, "", f);
    fprintf(x->page, "loft plot %s%s -o %s.%s\n</pre>\n<table>\n", size_of(f), line, f->name,
            f->type);
}

static int show_figure(exhibition *x, const figure *f)
{
    int code = write_input(x, f, "0", f->input);

    if (code == 0)
        code = write_input(x, f, "9", f->also);
    if (code == 0)
        code = make_files(x, f);
    if (code == 0)
        code = draw_picture(x, f);
    if (code != 0)
        return tool_error(code, "figure %s was not made", f->name);
    begin_figure(x, f);
    for (unsigned k = 0; k < FIGURE_PROOFS && f->proof[k].says != NULL && code == 0; k++)
        code = prove(x, f, &f->proof[k]);
    if (x->page != NULL)
        fprintf(x->page, "</table>\n");
    return code;
}

static int open_page(exhibition *x, char name[LINE])
{
    if (mkdir(x->folder, 0777) != 0 && errno != EEXIST)
        return tool_error(EX_CANTCREAT, "%s: %s: name another folder", x->folder, strerror(errno));
    snprintf(name, LINE, "%sindex.html", x->folder);
    x->page = open_file(name, "w");
    if (x->page == NULL)
        return EX_CANTCREAT;
    fprintf(x->page,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
            "<title>Figures, computed in %s</title>\n"
            "<style>body { font-family: sans-serif; max-width: 60em; margin: 2em auto }\n"
            "img { max-width: 100%% } td { padding: 0 1em 0.3em 0; vertical-align: top }</style>\n"
            "<h1>Figures, computed in %s</h1>\n<p>loft %s. Run the commands in this folder.</p>\n",
            x->e->name, x->e->name, tool_version);
    return 0;
}

static int close_page(exhibition *x, const char *name)
{
    fprintf(x->page, "</html>\n");
    const bool bad = ferror(x->page) != 0;
    return fclose(x->page) != 0 || bad ? tool_error(EX_IOERR,
                                                    "%s: cannot be written: is the disk "
                                                    "full?",
                                                    name)
                                       : 0;
}


// The command
// -----------

static const figure *figure_named(const char *name)
{
    for (size_t i = 0; figure_number(i) != NULL; i++)
        if (strcmp(figure_number(i)->name, name) == 0)
            return figure_number(i);
    return NULL;
}

static int list_figures(void)
{
    for (size_t i = 0; figure_number(i) != NULL; i++) {
        const figure *f = figure_number(i);
        printf("%-18s %-10s %-22s %s\n", f->name, f->text, f->section, f->title);
    }
    return EX_OK;
}

/* All, or those that are named. */
static int show_figures(exhibition *x, const char *const *name, size_t count)
{
    char page[LINE];
    int code = open_page(x, page);

    for (size_t i = 0; code == 0 && count == 0 && figure_number(i) != NULL; i++)
        code = show_figure(x, figure_number(i));
    for (size_t i = 0; i < count && code == 0; i++)
        code = show_figure(x, figure_named(name[i]));
    if (x->page != NULL) {
        const int closed = close_page(x, page);
        code = code ? code : closed;
    }
    if (code == 0)
        printf("%s: %u numbers in %s, %u of them beyond their bounds\n", page, x->proofs,
               x->e->name, x->failed);
    return code ? code : x->failed > 0 ? EX_SOFTWARE : EX_OK;
}

typedef struct {
    const char *output;
    bool list, brief, no_pictures;
    const engine *e;
    option_words names;
} figures_options;

static const option figures_rows[] = {
    { "output", OPTION_FOLDER(figures_options, output), .value = "DIR", .standard = "figures",
      .help = "or -o: the folder, made if necessary" },
    { "list", OPTION_FLAG(figures_options, list),
      .help = "names, texts, sections and titles; nothing is made" },
    { "brief", OPTION_FLAG(figures_options, brief),
      .help = "print only what is wrong, and the sum" },
    { "no-pictures", OPTION_FLAG(figures_options, no_pictures), .help = "numbers only" },
    ENGINE_ROW(figures_options, e, "q16", "number type of all numbers"),
    { "names", OPTION_WORDS(figures_options, names), .most = 1e6, .value = "NAME" },
    { 0 }
};

static int run_figures(void *options)
{
    const figures_options *o = options;
    char folder[FOLDER];
    exhibition x = { .e = o->e, .brief = o->brief, .folder = folder, .pictures = !o->no_pictures };

    if (o->list)
        return list_figures();
    for (size_t i = 0; i < o->names.count; i++)
        if (figure_named(o->names.word[i]) == NULL)
            return tool_error(EX_USAGE, "%s: no such figure: see `loft figures --list`",
                              o->names.word[i]);
    if (strlen(o->output) >= FOLDER - 1)
        return tool_error(EX_USAGE, "-o: the name has %zu letters: give less than %d",
                          strlen(o->output), FOLDER - 1);
    snprintf(folder, sizeof folder, "%s/", o->output);
    return show_figures(&x, o->names.word, o->names.count);
}

const command command_figures = {
    .name = "figures",
    .arguments = "[-o DIR] [NAME..] | --list",
    .summary = "the figures of the texts, with the numbers that prove them",
    .detail =
        "Makes figures of five texts on curves and surfaces: of each the data in .loft, the\n"
        "picture, and the numbers that a theorem or a formula gives, computed in the number type\n"
        "and compared with their bounds. DIR/index.html has all of them, with the commands that\n"
        "repeat each step. Pictures are drawn from q16. The exit code is 70 if a number is beyond\n"
        "its bound.\n",
    .options = figures_rows,
    .size = sizeof(figures_options),
    .run = run_figures,
};
